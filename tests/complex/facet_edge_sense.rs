//! Directions that edges of topological tetrahedra get, against triangles and signs of flags.

use super::facet_edge_samples::*;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::three_torus;
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::facet_edge_sense::{EdgeSense, Towards, edge_sense};
use isoracle::complex::glue_tetra::corners;
use isoracle::complex::handle::{Handle, Space};
use std::collections::BTreeSet;

/// The directions of the edges of a triangle walked along one of its sides.
fn walked([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

mod cx_36 {
    use super::*;

    #[test]
    fn two_of_the_six_edges_are_ambiguous() {
        // The triangles of e, walked along it, and those of f′, walked along it, by corners.
        for chosen in &Handle::versions(0)[..4] {
            let [tail, head, ahead, behind] = corners(*chosen);
            let triangles = [[tail, head, ahead], [tail, head, behind], [behind, ahead, tail], [behind, ahead, head]];
            let said: BTreeSet<[usize; 2]> = triangles.into_iter().flat_map(walked).collect();
            let ambiguous: BTreeSet<[usize; 2]> =
                said.iter().filter(|[a, b]| said.contains(&[*b, *a])).map(|[a, b]| [*a.min(b), *a.max(b)]).collect();
            let expected = [[tail, behind], [head, ahead]].map(|[v, p]| [v.min(p), v.max(p)]);
            assert_eq!(ambiguous, BTreeSet::from(expected));
            assert!(said.contains(&[tail, head]) && said.contains(&[behind, ahead]));
            for h in &Handle::versions(0)[..4] {
                let [vertex, _, polyhedron, _] = corners(*h);
                let is_said = [[polyhedron, vertex], [vertex, polyhedron]].map(|edge| said.contains(&edge));
                let sense = match is_said {
                    [true, true] => EdgeSense::Ambiguous,
                    [true, false] => EdgeSense::Defined(Towards::Vertex),
                    [false, true] => EdgeSense::Defined(Towards::Polyhedron),
                    [false, false] => unreachable!("each edge is in two triangles"),
                };
                assert_eq!(edge_sense(*chosen, *h), sense);
                assert_eq!(sense != EdgeSense::Ambiguous, [*chosen, chosen.clock()].contains(h));
            }
        }
    }

    #[test]
    fn by_the_edge_alone_nothing_is_ambiguous() {
        let triangles = [[0, 1, 2], [0, 1, 3]];
        let said: BTreeSet<[usize; 2]> = triangles.into_iter().flat_map(walked).collect();
        assert!(said.iter().all(|[a, b]| !said.contains(&[*b, *a])));
        assert!(!said.contains(&[2, 3]) && !said.contains(&[3, 2]), "f′ gets no direction");
    }
}

mod cx_37 {
    use super::*;

    #[test]
    fn ambiguous_edges_lie_on_those_with_a_direction_iff_the_complex_is_orientable() {
        let all = closed(tetrahedron_gluings()).into_iter().chain(closed(cube_gluings()));
        let mut seen = BTreeSet::new();
        for complex in all.chain(examples().into_iter().map(|(_, complex)| complex)) {
            let structure = FacetEdgeStructure::of(&complex);
            seen.insert(complex.is_orientable());
            match structure.anticlockwise(&[]) {
                None => assert!(!complex.is_orientable()),
                Some(chosen) => {
                    assert!(complex.is_orientable());
                    assert_eq!(structure.unpaired_sense(&chosen), None);
                    // The spins are those of one sign of the flags in each component.
                    let signs = complex.flags().signs(&[0, 1, 2, 3]).expect("orientable");
                    let handles = handles_of_flags(&complex);
                    let sign = |h: Handle| signs[handles.iter().position(|g| *g == h).expect("a flag")];
                    assert!(chosen.iter().all(|h| sign(*h)));
                }
            }
        }
        assert_eq!(seen.len(), 2);
    }

    #[test]
    fn no_choice_of_spins_pairs_the_edges_of_a_complex_that_is_not_orientable() {
        let structures = closed(tetrahedron_gluings()).into_iter().filter(|complex| !complex.is_orientable());
        let structures: Vec<FacetEdgeStructure> = structures.map(|complex| FacetEdgeStructure::of(&complex)).collect();
        assert_eq!(structures.len(), 12);
        for structure in structures {
            for spins in 0..1_u32 << structure.len() {
                let spun = |pair: u32| {
                    let a = Handle::base(pair);
                    if spins >> pair & 1 == 1 { a.spin() } else { a }
                };
                let chosen: Vec<Handle> = (0..structure.len() as u32).map(spun).collect();
                assert!(structure.unpaired_sense(&chosen).is_some());
            }
        }
    }

    #[test]
    fn a_clockwise_spin_at_one_pair_is_seen() {
        let structure = FacetEdgeStructure::of(&ClosedComplex::new(three_torus()).expect("closed"));
        let mut chosen = structure.anticlockwise(&[]).expect("orientable");
        chosen[5] = chosen[5].spin();
        assert!(structure.unpaired_sense(&chosen).is_some());
    }
}

mod cx_38 {
    use super::*;

    #[test]
    fn in_the_torus_two_of_eight_edges_get_one_direction_whatever_those_of_the_edges_are() {
        let structure = FacetEdgeStructure::of(&ClosedComplex::new(three_torus()).expect("closed"));
        for choice in 0..8_u32 {
            let against = [0, 1, 2].map(|edge| choice >> edge & 1 == 1);
            let chosen = structure.anticlockwise(&against).expect("orientable");
            assert_eq!(structure.unpaired_sense(&chosen), None);
            let directions = structure.corner_directions(&chosen);
            assert_eq!(directions.len(), 8, "the corners of the cube");
            // Printed: coherent, so that each has one.
            assert_eq!(directions.iter().filter(|found| found.len() == 1).count(), 2);
            assert_eq!(directions.iter().filter(|found| found.len() == 2).count(), 6);
        }
    }

    #[test]
    fn a_corner_is_coherent_iff_all_edges_leave_its_vertex_there_or_all_come_to_it() {
        for (name, complex) in examples().into_iter().filter(|(_, complex)| complex.is_orientable()) {
            let structure = FacetEdgeStructure::of(&complex);
            for choice in 0..1_u32 << complex.counts()[1].min(6) {
                let against: Vec<bool> =
                    (0..complex.counts()[1]).map(|edge| edge < 6 && choice >> edge & 1 == 1).collect();
                let chosen = structure.anticlockwise(&against).expect("orientable");
                // By flags: a corner of a polyhedron is an orbit of σ₁ and σ₂.
                let flags = structure.to_flags();
                let (corner_of, corners) = flags.orbits(&[1, 2]);
                let mut ends = vec![BTreeSet::new(); corners];
                for h in structure.handles(Space::Primal) {
                    let leaves = h.is_reversed() == chosen[h.pair() as usize].is_reversed();
                    ends[corner_of[flag_of(h).0 as usize] as usize].insert(leaves);
                }
                let mut by_flags: Vec<usize> = ends.iter().map(BTreeSet::len).collect();
                let mut found: Vec<usize> = structure.corner_directions(&chosen).iter().map(Vec::len).collect();
                by_flags.sort();
                found.sort();
                assert_eq!(found, by_flags, "{name}");
            }
        }
    }

    #[test]
    fn directions_are_those_asked_for() {
        let structure = FacetEdgeStructure::of(&ClosedComplex::new(three_torus()).expect("closed"));
        let one = structure.anticlockwise(&[]).expect("orientable");
        let other = structure.anticlockwise(&[true; 3]).expect("orientable");
        assert!(one.iter().zip(&other).all(|(a, b)| *b == a.clock()));
        // One direction for each edge: a ring has the chosen handles or those with the other spin.
        for a in &one {
            let pairs_alike = structure.facet_ring(*a).into_iter().all(|h| one[h.pair() as usize] == h);
            assert!(pairs_alike);
        }
    }
}
