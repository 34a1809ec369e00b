//! Radial subdivision.

use super::gluings::{all_gluings, all_gluings_of_one, doubled, examples, has_edges, rings, scheme_of, zipped_bigon};
use isoracle::complex::check::{VertexSets, check, fast, vertex_sets};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::lens_space;
use isoracle::complex::radial::{Axis, SliceError, radial, slice};
use isoracle::complex::refine::fast::refine;
use isoracle::complex::scheme::{GluingScheme, Polyhedron};
use isoracle::complex::triangulation::Triangulation;
use isoracle::mesh::homology::Homology;

fn tetrahedra(scheme: GluingScheme) -> Triangulation {
    ClosedComplex::new(scheme).expect("a closed complex").tetrahedra()
}

fn bases() -> Vec<Triangulation> {
    let small = (1..=2).flat_map(all_gluings).chain(all_gluings(3).step_by(11)).filter(has_edges);
    examples().into_iter().map(|(_, complex)| complex.tetrahedra()).filter(|t| t.len() < 60).chain(small).collect()
}

/// Whether a triangle that has this edge is glued to one of the same tetrahedron.
fn is_glued_to_itself_around(base: &Triangulation, edge: [usize; 2]) -> bool {
    let around: Vec<usize> = (0..4).filter(|triangle| !edge.contains(triangle)).collect();
    base.gluings().iter().enumerate().any(|(i, row)| around.iter().any(|j| row[*j].tetrahedron as usize == i))
}

mod tetrahedra_glued_to_themselves {
    use super::*;

    #[test]
    fn a_tetrahedron_is_glued_to_itself_around_an_edge_iff_it_stands_alone_there() {
        let mut counts = [0; 2];
        for base in (1..=3).flat_map(all_gluings).step_by(3).filter(has_edges).chain(bases()) {
            for (axis, edge) in [([0, 1], 0), ([2, 3], 5)] {
                let alone = rings(&base, edge).values().any(|n| *n == 1);
                assert_eq!(is_glued_to_itself_around(&base, axis), alone);
                counts[usize::from(alone)] += 1;
            }
        }
        assert!(counts.iter().all(|n| *n > 50), "{counts:?}");
    }

    #[test]
    fn it_happens_around_the_dual_edge_alone() {
        let base = tetrahedra(doubled(Polyhedron::lens(1)));
        assert!(rings(&base, 0).values().all(|n| *n == 2), "as printed, no pair is its own next around an edge");
        let itself =
            base.gluings().iter().enumerate().filter(|(i, row)| row.iter().any(|g| g.tetrahedron as usize == *i));
        assert_eq!(itself.count(), 2);
    }
}

mod cx_50 {
    use super::*;

    fn homology(triangulation: &Triangulation) -> Homology {
        ClosedComplex::new(scheme_of(triangulation)).expect("edges are edges").chain_complex().homology()
    }

    fn same_space(a: &Triangulation, b: &Triangulation) {
        let [f, g] = [a, b].map(fast::check);
        assert_eq!((f.components, f.orientable), (g.components, g.orientable));
        let chi = |[v, e, f, t]: [usize; 4]| v as i64 - e as i64 + f as i64 - t as i64;
        assert_eq!(chi(f.counts), chi(g.counts));
        let links = |facts: &isoracle::complex::check::Facts| {
            let mut links: Vec<String> =
                facts.defects.iter().map(|d| d.to_string().split(" stands ").last().unwrap_or("").to_owned()).collect();
            links.sort();
            links
        };
        assert_eq!(links(&f), links(&g));
        assert_eq!(homology(a), homology(b));
    }

    #[test]
    fn slices_keep_the_space() {
        for base in bases().iter().step_by(2) {
            for (axis, edge) in [(Axis::Dual, 5), (Axis::Primal, 0)] {
                // Another number at each edge of the axis.
                let skeleton = base.skeleton();
                let slices: Vec<u32> = skeleton.edges.iter().map(|edges| 1 + edges[edge] % 3).collect();
                let cut = slice(base, axis, &slices).expect("equal around each edge");
                same_space(base, &cut);
                assert_eq!(cut.len() as u32, slices.iter().sum::<u32>());
                let split: u32 = rings(base, edge).keys().map(|class| class % 3).sum();
                let vertices = cut.skeleton().counts[0] - base.skeleton().counts[0];
                assert_eq!(vertices as u32, split, "a vertex for each point of a split edge");
                // The ring around the edge opposite is that of the slices.
                let mut expected: Vec<usize> = Vec::new();
                for ring in rings(base, 5 - edge).keys() {
                    let around = skeleton.edges.iter().zip(&slices).filter(|(edges, _)| edges[5 - edge] == *ring);
                    expected.push(around.map(|(_, n)| *n as usize).sum());
                }
                let mut counted: Vec<usize> = rings(&cut, 5 - edge).into_values().collect();
                expected.sort_unstable();
                counted.sort_unstable();
                assert_eq!(counted, expected);
            }
        }
    }

    #[test]
    fn the_radial_subdivision_keeps_the_space() {
        bases().iter().for_each(|base| same_space(base, &radial(base).expect("paired").triangulation));
    }

    #[test]
    fn all_tetrahedra_around_the_split_edge_are_cut() {
        let base = tetrahedra(lens_space(5, 0));
        assert_eq!(slice(&base, Axis::Dual, &[3, 1, 1, 1, 1]).err(), Some(SliceError::Different(0, 1)));
        assert_eq!(slice(&base, Axis::Dual, &[3; 5]).map(|cut| cut.len()), Ok(15));
    }

    #[test]
    fn what_cannot_be_cut_is_refused() {
        let base = tetrahedra(lens_space(2, 1));
        assert_eq!(slice(&base, Axis::Dual, &[2]).err(), Some(SliceError::Length { slices: 1, tetrahedra: 2 }));
        assert_eq!(slice(&base, Axis::Primal, &[0, 0]).err(), Some(SliceError::NoSlice(0)));
        assert_eq!(slice(&base, Axis::Dual, &[(1 << 26) + 1; 2]).err(), Some(SliceError::TooLarge));
        assert_eq!(slice(&base, Axis::Dual, &[u32::MAX; 2]).err(), Some(SliceError::TooLarge));
        let refused: Vec<_> = all_gluings_of_one().iter().map(|one| radial(one).err()).collect();
        assert!(refused.iter().any(|e| matches!(e, Some(SliceError::NotPaired { tetrahedron: 0, .. }))));
        assert_eq!(refused.iter().filter(|e| e.is_none()).count(), 4, "those of one topological tetrahedron");
    }
}

mod cx_51 {
    use super::*;

    #[test]
    fn a_tetrahedron_alone_around_its_edge_takes_three_slices() {
        for p in 1..=6 {
            let base = tetrahedra(lens_space(p, 0));
            assert!(rings(&base, 0).values().all(|n| *n == 1));
            let around = |n: u32| {
                let cut = slice(&base, Axis::Dual, &vec![n; p as usize]).expect("equal");
                // Split along e too, so that what is left is about rings around e.
                let cut = slice(&cut, Axis::Primal, &vec![3; cut.len()]).expect("equal");
                vertex_sets(refine(&cut, 4).expect("small").triangulation())
            };
            assert!(around(1).degenerate_tetrahedra > 0);
            let two = around(2);
            assert_eq!(two.degenerate_tetrahedra, 0);
            // Two tetrahedra with the same vertices at each of the 3·4 parts of each edge e.
            assert_eq!(two.duplicate_tetrahedra, 12 * p as usize);
            assert_eq!(around(3), VertexSets { degenerate_tetrahedra: 0, duplicate_tetrahedra: 0, simplicial: true });
            let radial = radial(&base).expect("paired");
            assert_eq!(radial.around_primal, vec![3; p as usize]);
        }
    }

    #[test]
    fn two_tetrahedra_around_an_edge_have_the_same_vertices_to_any_order() {
        // Two balls glued along their surfaces: a pair at each of the k parts of each edge.
        for polyhedron in [Polyhedron::tetrahedron(), Polyhedron::cube(), Polyhedron::prism(5)] {
            let edges = polyhedron.edges.len();
            let base = tetrahedra(doubled(polyhedron));
            for k in 1..=4 {
                let sets = vertex_sets(refine(&base, k).expect("small").triangulation());
                assert_eq!((sets.degenerate_tetrahedra, sets.duplicate_tetrahedra), (0, k as usize * edges));
            }
            let radial = radial(&base).expect("paired").triangulation;
            assert_eq!(vertex_sets(refine(&radial, 3).expect("small").triangulation()).duplicate_tetrahedra, 0);
        }
    }
}

mod cx_52 {
    use super::*;

    #[test]
    fn no_tetrahedron_is_glued_to_itself_afterwards_and_rings_have_three() {
        let mut cut = 0;
        for base in bases().into_iter().chain(all_gluings(3).step_by(5).filter(has_edges)) {
            let after = radial(&base).expect("paired");
            assert!([[0, 1], [2, 3]].iter().all(|edge| !is_glued_to_itself_around(&after.triangulation, *edge)));
            let small = |t: &Triangulation, edge| rings(t, edge).values().any(|n| *n < 3);
            assert!(!small(&after.triangulation, 0) && !small(&after.triangulation, 5));
            assert_eq!(
                after.triangulation == base,
                !small(&base, 0) && !small(&base, 5),
                "others are left as they are"
            );
            cut += usize::from(after.triangulation != base);
        }
        assert!(cut > 100, "{cut}");
    }

    #[test]
    fn lens_spaces_become_simplicial() {
        for p in 1..=8 {
            for q in 0..p {
                let after = radial(&tetrahedra(lens_space(p, q))).expect("paired").triangulation;
                for k in 4..=5 {
                    assert!(
                        check(refine(&after, k).expect("small").triangulation()).vertex_sets.simplicial,
                        "L({p}, {q}), k = {k}"
                    );
                }
            }
        }
        let one = radial(&tetrahedra(lens_space(1, 0))).expect("paired").triangulation;
        let facts = check(&one);
        // The join of two triangles.
        assert_eq!((facts.counts, facts.vertex_sets.simplicial), ([6, 15, 18, 9], true));
    }

    #[test]
    fn a_corner_with_one_edge_keeps_its_pair() {
        let after = radial(&tetrahedra(doubled(zipped_bigon()))).expect("paired").triangulation;
        assert!(rings(&after, 0).values().chain(rings(&after, 5).values()).all(|n| *n >= 3));
        for k in 1..=5 {
            let sets = vertex_sets(refine(&after, k).expect("small").triangulation());
            assert_eq!(sets.duplicate_tetrahedra, 12 * k as usize - 8);
        }
    }
}
