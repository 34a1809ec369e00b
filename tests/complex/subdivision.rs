//! Barycentric subdivision, topological tetrahedra, and what makes a manifold.

use super::gluings::{all_complexes, all_gluings, doubled, examples, scheme_of};
use isoracle::complex::check::{TriangulationDefect, check, fast};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::flag::Flag;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::scheme::{Polyhedron, Reason, SchemeDefect};
use isoracle::complex::triangulation::Triangulation;
use std::collections::{BTreeMap, BTreeSet};

fn torus() -> ClosedComplex {
    ClosedComplex::new(three_torus()).expect("a closed complex")
}

/// Complexes of all kinds, spheres around their vertices or not.
fn complexes() -> Vec<ClosedComplex> {
    let small = all_complexes(&Polyhedron::tetrahedron());
    let cubes = all_complexes(&Polyhedron::cube()).step_by(97);
    examples().into_iter().map(|(_, complex)| complex).chain(small).chain(cubes).collect()
}

mod links_of_a_triangulation {
    use super::*;

    /// Against flags: the triangulation as a scheme of tetrahedra.
    fn agrees(triangulation: &Triangulation) -> bool {
        let facts = check(triangulation);
        assert_eq!(facts, fast::check(triangulation));
        let reversed = facts.defects.iter().filter(|d| matches!(d, TriangulationDefect::EdgeReversed { .. })).count();
        let complex = match ClosedComplex::new(scheme_of(triangulation)) {
            Ok(complex) => complex,
            Err(defects) => {
                assert!(defects.iter().all(|d| d.reason() == Reason::EdgeReversed));
                assert_eq!(reversed, defects.len());
                return false;
            }
        };
        assert_eq!(facts.counts, complex.counts());
        assert_eq!((facts.components, facts.orientable), (complex.component_count(), complex.is_orientable()));
        let mut links: Vec<_> = facts
            .defects
            .iter()
            .filter_map(|d| match d {
                TriangulationDefect::VertexLink { link, .. } => Some(*link),
                TriangulationDefect::EdgeReversed { .. } => None,
            })
            .collect();
        let mut expected: Vec<_> = Manifold3::of(complex)
            .err()
            .into_iter()
            .flatten()
            .filter_map(|d| match d {
                SchemeDefect::VertexLink { link, .. } => Some(link),
                _ => None,
            })
            .collect();
        links.sort();
        expected.sort();
        assert_eq!((links, reversed), (expected, 0));
        facts.defects.is_empty()
    }

    #[test]
    fn a_triangulation_is_a_manifold_iff_its_links_are_spheres() {
        let small = (1..=2).flat_map(all_gluings).chain(all_gluings(3).step_by(61));
        let manifolds = small.filter(agrees).count();
        assert!(manifolds > 20, "{manifolds}");
    }

    #[test]
    fn subdivisions_have_the_links_of_the_complex() {
        let mut no_manifolds = 0;
        for complex in complexes() {
            let mut links: Vec<_> = complex.vertex_links();
            links.retain(|link| *link != isoracle::mesh::classify::SPHERE);
            links.sort();
            no_manifolds += usize::from(!links.is_empty());
            let of_vertices = |triangulation: &Triangulation| {
                let facts = fast::check(triangulation);
                assert_eq!((facts.components, facts.orientable), (complex.component_count(), complex.is_orientable()));
                let mut links: Vec<_> = facts
                    .defects
                    .iter()
                    .map(|d| match d {
                        TriangulationDefect::VertexLink { link, .. } => *link,
                        TriangulationDefect::EdgeReversed { .. } => panic!("edges are edges"),
                    })
                    .collect();
                links.sort();
                links
            };
            assert_eq!(of_vertices(&complex.tetrahedra()), links);
            assert_eq!(of_vertices(&complex.barycentric()), links);
            assert_eq!(of_vertices(complex.refined(2).expect("small").triangulation()), links);
        }
        assert!(no_manifolds > 10, "{no_manifolds}");
    }
}

mod cx_44 {
    use super::*;
    use isoracle::complex::barycentric::VertexType;

    #[test]
    fn each_barycentric_tetrahedron_has_one_vertex_of_each_type() {
        for complex in complexes() {
            let skeleton = complex.barycentric().skeleton();
            let mut cells = BTreeMap::new();
            for (flag, vertices) in complex.flags().all().zip(&skeleton.vertices) {
                for (k, vertex_type) in VertexType::ALL.into_iter().enumerate() {
                    let cell = (vertex_type, complex.cell(k, flag));
                    assert_eq!(*cells.entry(vertices[k]).or_insert(cell), cell, "a vertex has one type and one cell");
                }
            }
            assert_eq!(cells.len(), skeleton.counts[0]);
            assert_eq!(
                cells.values().collect::<BTreeSet<_>>().len(),
                complex.counts().iter().sum::<usize>(),
                "and each cell one vertex"
            );
        }
    }
}

mod cx_45 {
    use super::*;

    #[test]
    fn counts_are_those_of_the_skeleton() {
        for complex in complexes() {
            assert_eq!(complex.barycentric_counts(), complex.barycentric().skeleton().counts);
        }
    }

    #[test]
    fn a_vertex_in_a_boundary_is_joined_as_often_as_it_comes() {
        let complex = torus();
        let skeleton = complex.barycentric().skeleton();
        // Edges 03, 13, 23 end in the middle of the polyhedron.
        let edges: BTreeSet<u32> = skeleton.edges.iter().flat_map(|e| [e[2], e[4], e[5]]).collect();
        let ends: BTreeSet<u32> = skeleton.vertices.iter().flat_map(|v| [v[0], v[1], v[2]]).collect();
        assert_eq!((edges.len(), ends.len()), (26, 7));
        assert_eq!(skeleton.counts, [8, 56, 96, 48]);
    }
}

mod cx_46 {
    use super::*;

    #[test]
    fn barycentric_is_simplicial_iff_the_complex_is_regular() {
        let of_tetrahedra = all_gluings(2).filter_map(|t| ClosedComplex::new(scheme_of(&t)).ok());
        let prisms = (3..6).map(|n| ClosedComplex::new(doubled(Polyhedron::prism(n))).expect("a sphere"));
        let mut regular = 0;
        for complex in complexes().into_iter().chain(of_tetrahedra).chain(prisms) {
            let simplicial = check(&complex.barycentric()).vertex_sets.simplicial;
            assert_eq!(complex.is_regular(), simplicial, "{:?}", complex.scheme());
            regular += usize::from(simplicial);
        }
        assert!(regular > 5, "{regular}");
    }

    #[test]
    fn that_of_any_triangulation_keeps_the_space() {
        for base in (1..=2).flat_map(all_gluings).filter(super::super::gluings::has_edges) {
            let [before, after] = [&base, &base.barycentric()].map(fast::check);
            let [v, e, f, t] = before.counts;
            assert_eq!((after.counts[0], after.counts[3]), (v + e + f + t, 24 * t));
            assert_eq!((after.components, after.orientable), (before.components, before.orientable));
            assert_eq!(after.defects.len(), before.defects.len());
        }
    }

    #[test]
    fn the_second_one_always_is() {
        for complex in complexes().iter().filter(|complex| complex.facet_edge_pairs() <= 12).step_by(3) {
            let twice = complex.barycentric().barycentric();
            let facts = fast::check(&twice);
            assert!(facts.vertex_sets.simplicial);
            let [v, e, f, t] = facts.counts.map(|n| n as i64);
            assert_eq!((v - e + f - t, t as usize), (complex.euler_characteristic(), 96 * complex.facet_edge_pairs()));
        }
    }
}

mod cx_47 {
    use super::*;

    #[test]
    fn four_barycentric_tetrahedra_stand_around_the_edge_from_e_to_f() {
        for complex in complexes() {
            // Edge 12 of a barycentric tetrahedron, between the middles of its edge and its face.
            let mut around: BTreeMap<u32, BTreeSet<Flag>> = BTreeMap::new();
            let skeleton = complex.barycentric().skeleton();
            for (flag, edges) in complex.flags().all().zip(&skeleton.edges) {
                around.entry(edges[3]).or_default().insert(flag);
            }
            let parts: BTreeSet<BTreeSet<Flag>> =
                complex.barycentric_parts().into_iter().map(|parts| parts.into_iter().collect()).collect();
            assert_eq!(parts, around.into_values().collect());
            assert!(parts.iter().all(|four| four.len() == 4));
        }
    }

    #[test]
    fn each_has_one_of_two_triangles_in_the_face_and_one_of_two_in_the_dual_face() {
        for complex in complexes() {
            let skeleton = complex.barycentric().skeleton();
            for parts in complex.barycentric_parts() {
                // Triangle 3 is V, E, F; triangle 0 is E, F, P.
                let pairs =
                    parts.map(|flag| skeleton.triangles[flag.0 as usize]).map(|triangles| (triangles[3], triangles[0]));
                let [vef, efp]: [BTreeSet<u32>; 2] = [pairs.map(|p| p.0).into(), pairs.map(|p| p.1).into()];
                assert_eq!((vef.len(), efp.len(), BTreeSet::from(pairs).len()), (2, 2, 4));
            }
        }
    }

    #[test]
    fn the_three_torus_has_twelve_and_not_six() {
        let complex = torus();
        let mut by_cells: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        complex.flags().all().for_each(|flag| *by_cells.entry([1, 2].map(|k| complex.cell(k, flag))).or_default() += 1);
        assert_eq!(by_cells.values().copied().collect::<Vec<_>>(), [8; 6]);
        assert_eq!(complex.barycentric_parts().len(), 12);
    }
}

mod cx_48 {
    use super::*;
    use isoracle::complex::barycentric::{CORNER_TYPES, VertexType};

    #[test]
    fn corners_are_vertices_and_middles_of_polyhedra_and_e_lies_opposite_the_dual_edge() {
        for complex in complexes() {
            let [v, e, f, p] = complex.counts();
            let skeleton = complex.tetrahedra().skeleton();
            let classes = |kind: VertexType| -> BTreeSet<u32> {
                let corners = (0..4).filter(|i| CORNER_TYPES[*i] == kind);
                corners.flat_map(|i| skeleton.vertices.iter().map(move |vertices| vertices[i])).collect()
            };
            let (ends, middles) = (classes(VertexType::V), classes(VertexType::P));
            assert_eq!((ends.len(), middles.len()), (v, p));
            assert!(ends.is_disjoint(&middles));
            // Edges 01 and 23 have no corner in common: as many as edges, and as faces, with the rings of both.
            let rings = |edge: usize| {
                let mut sizes: Vec<usize> =
                    super::super::gluings::rings(&complex.tetrahedra(), edge).into_values().collect();
                sizes.sort_unstable();
                sizes
            };
            let sorted = |mut sizes: Vec<usize>| {
                sizes.sort_unstable();
                sizes
            };
            assert_eq!((rings(0).len(), rings(5).len()), (e, f));
            assert_eq!(rings(0), sorted(complex.edge_ring_sizes()));
            assert_eq!(rings(5), sorted(complex.face_degrees()));
            // Four triangles, each with a pair of corners of one type and one of the other.
            assert_eq!(skeleton.counts[2], 2 * complex.facet_edge_pairs());
        }
    }
}

mod pairs_of_a_closed_complex {
    use super::*;

    #[test]
    fn t_is_the_sum_of_the_rings_and_half_the_sides_of_the_scheme() {
        for complex in complexes() {
            let t = complex.facet_edge_pairs();
            let sides: usize = complex.scheme().polyhedra.iter().flat_map(|p| &p.faces).map(Vec::len).sum();
            assert_eq!(complex.tetrahedra().len(), t);
            assert_eq!(complex.edge_ring_sizes().iter().sum::<usize>(), t);
            assert_eq!((complex.face_degrees().iter().sum::<usize>(), sides), (t, 2 * t));
        }
    }

    #[test]
    fn faces_counted_once_give_another_number() {
        let complex = torus();
        let mut faces: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        for flag in complex.flags().all() {
            faces.entry(complex.cell(1, flag)).or_default().insert(complex.cell(2, flag));
        }
        assert_eq!(faces.values().map(BTreeSet::len).sum::<usize>(), 6, "as printed, read as different faces");
        assert_eq!(complex.facet_edge_pairs(), 12);
    }
}

mod cx_49 {
    use super::*;

    #[test]
    fn a_topological_tetrahedron_lies_half_in_each_of_two_polyhedra() {
        let complex = ClosedComplex::new(doubled(Polyhedron::tetrahedron())).expect("a sphere");
        let polyhedra = complex.polyhedra_of_tetrahedra();
        // As printed, polyhedron 0 is cut into some of the 12.
        let inside_0 = polyhedra.iter().filter(|[p, q]| (*p, *q) == (0, 0)).count();
        assert_eq!((polyhedra.len(), inside_0), (12, 0));
        assert!(polyhedra.iter().all(|[p, q]| p + q == 1));
    }

    #[test]
    fn a_polyhedron_is_cut_into_as_many_halves_as_its_faces_have_sides() {
        for complex in complexes() {
            let mut halves = vec![0; complex.counts()[3]];
            complex.polyhedra_of_tetrahedra().iter().flatten().for_each(|p| halves[*p as usize] += 1);
            let sides = |p: &Polyhedron| p.faces.iter().map(Vec::len).sum::<usize>();
            assert_eq!(halves, complex.scheme().polyhedra.iter().map(sides).collect::<Vec<_>>());
        }
    }
}

mod cells_and_boundaries_by_subdivision {
    use super::*;

    #[test]
    fn the_boundary_of_a_cell_is_a_union_of_cells() {
        for complex in examples().into_iter().map(|(_, complex)| complex).filter(|c| c.facet_edge_pairs() < 50) {
            let flags = complex.flags();
            for (low, high) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                // The simplex of a flag's lowest cells lies inside cell `low`; the flags that have it are joined by the maps above.
                let above: Vec<usize> = (low + 1..4).collect();
                let (simplex_of, _) = flags.orbits(&above);
                let mut touched: BTreeMap<(u32, u32), BTreeSet<u32>> = BTreeMap::new();
                let mut all: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
                for flag in flags.all() {
                    let (cell, simplex) = (complex.cell(low, flag), simplex_of[flag.0 as usize]);
                    touched.entry((cell, complex.cell(high, flag))).or_default().insert(simplex);
                    all.entry(cell).or_default().insert(simplex);
                }
                assert!(touched.iter().all(|((cell, _), simplices)| *simplices == all[cell]));
            }
        }
    }

    #[test]
    fn a_reversed_edge_is_half_an_edge() {
        // A monogon glued to the other one so that its edge turns around.
        let defects =
            ClosedComplex::new(paired(Polyhedron::lens(1), &[(0, 1, 0, 1)])).expect_err("its edge is no cell");
        assert_eq!(defects.iter().map(SchemeDefect::reason).collect::<Vec<_>>(), [Reason::EdgeReversed]);
        for triangulation in (1..=2).flat_map(all_gluings) {
            let reversed = check(&triangulation)
                .defects
                .iter()
                .filter(|d| matches!(d, TriangulationDefect::EdgeReversed { .. }))
                .count();
            let skeleton = triangulation.barycentric().skeleton();
            let mut halves: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
            for (vertices, edges) in skeleton.vertices.iter().zip(&skeleton.edges) {
                halves.entry(vertices[1]).or_default().insert(edges[0]);
            }
            assert!(halves.values().all(|halves| halves.len() <= 2));
            assert_eq!(halves.values().filter(|halves| halves.len() == 1).count(), reversed);
        }
    }

    #[test]
    fn a_regular_cell_comes_once() {
        let regular = |scheme| ClosedComplex::new(scheme).expect("a closed complex").is_regular();
        assert!(regular(doubled(Polyhedron::cube())) && regular(super::super::gluings::torus_of_cubes(3)));
        assert!(!regular(super::super::gluings::torus_of_cubes(1)) && !regular(lens_space(5, 2)));
        // Edges with the same two ends are two cells, each with its ends once.
        assert!(regular(super::super::gluings::torus_of_cubes(2)));
    }
}
