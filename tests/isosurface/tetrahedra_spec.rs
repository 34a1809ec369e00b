//! IS-67, IS-68: marching tetrahedra.

use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::cube::Corner;
use isoracle::isosurface::tetrahedra::{Decomposition, TetrahedraMesh, TetrahedronCase, case, extract};
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::linear::Vector;
use isoracle::mesh::triangles::components;
use isoracle::number::Rational;
use proptest::prelude::*;
use std::collections::BTreeSet;

mod is_67 {
    use super::*;

    fn patterns() -> impl Iterator<Item = [bool; 4]> {
        (0..16).map(|n| [0, 1, 2, 3].map(|i| n >> i & 1 == 1))
    }

    /// The permutations of four corners; only the even ones, the rotations, if asked.
    fn permutations(even_only: bool) -> Vec<[usize; 4]> {
        let all = (0..256usize).map(|n| [n & 3, n >> 2 & 3, n >> 4 & 3, n >> 6]);
        let inversions =
            |p: &[usize; 4]| (0..4).flat_map(|i| (0..i).map(move |j| (j, i))).filter(|(j, i)| p[*j] > p[*i]).count();
        all.filter(|p| (0..4).all(|i| p.contains(&i))).filter(|p| !even_only || inversions(p) % 2 == 0).collect()
    }

    fn orbit_count(group: &[[usize; 4]], complement: bool) -> usize {
        let image = |pattern: [bool; 4], p: &[usize; 4], flip: bool| p.map(|i| pattern[i] != flip);
        let orbits: BTreeSet<BTreeSet<[bool; 4]>> = patterns()
            .map(|pattern| {
                let flips: &[bool] = if complement { &[false, true] } else { &[false] };
                group.iter().flat_map(|p| flips.iter().map(move |f| image(pattern, p, *f))).collect()
            })
            .collect();
        orbits.len()
    }

    #[test]
    fn there_are_three_cases_with_the_complement_and_five_without() {
        let (rotations, all) = (permutations(true), permutations(false));
        assert_eq!((rotations.len(), all.len()), (12, 24));
        for group in [rotations, all] {
            assert_eq!(orbit_count(&group, true), 3);
            assert_eq!(orbit_count(&group, false), 5);
        }
        let mut sizes = [0; 3];
        for pattern in patterns() {
            sizes[match case(pattern) {
                TetrahedronCase::Uncut => 0,
                TetrahedronCase::Triangle(_) => 1,
                TetrahedronCase::Quadrilateral(_) => 2,
            }] += 1;
        }
        assert_eq!(sizes, [2, 8, 6]);
    }

    #[test]
    fn the_polygon_has_the_crossed_edges_and_its_sides_lie_in_faces() {
        for pattern in patterns() {
            let polygon: Vec<[usize; 2]> = match case(pattern) {
                TetrahedronCase::Uncut => Vec::new(),
                TetrahedronCase::Triangle(edges) => edges.to_vec(),
                TetrahedronCase::Quadrilateral(edges) => edges.to_vec(),
            };
            let crossed: BTreeSet<[usize; 2]> =
                (0..4).flat_map(|i| (0..i).map(move |j| [j, i])).filter(|[a, b]| pattern[*a] != pattern[*b]).collect();
            assert_eq!(polygon.iter().map(|[a, b]| [*a.min(b), *a.max(b)]).collect::<BTreeSet<_>>(), crossed);
            assert_eq!(polygon.len(), crossed.len());
            for i in 0..polygon.len() {
                let corners: BTreeSet<usize> =
                    [polygon[i], polygon[(i + 1) % polygon.len()]].concat().into_iter().collect();
                assert_eq!(corners.len(), 3, "two edges of one face");
            }
        }
    }

    proptest! {
        #[test]
        fn the_quadrilateral_is_planar_and_convex(values in prop::array::uniform4(1i64..=50), set in 0usize..16) {
            let pattern = [0, 1, 2, 3].map(|i| set >> i & 1 == 1);
            let TetrahedronCase::Quadrilateral(edges) = case(pattern) else { return Ok(()) };
            let f = |i: usize| Rational::from(if pattern[i] { values[i] } else { -values[i] });
            let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p: [i64; 3]| Vector(p.map(Rational::from)));
            let [a, b, c, d] = edges.map(|[i, j]| {
                let t = f(i) / (f(i) - f(j));
                corners[i].clone() + &(corners[j].clone() - &corners[i]).scaled(&t)
            });
            let normal = (b.clone() - &a).cross(&(c.clone() - &a));
            prop_assert_eq!(normal.dot(&(d.clone() - &a)), 0);
            let cycle = [a, b, c, d];
            for i in 0..4 {
                let [p, q, r] = [0, 1, 2].map(|k| &cycle[(i + k) % 4]);
                prop_assert!((q.clone() - p).cross(&(r.clone() - q)).dot(&normal) > 0, "turns one way");
            }
        }
    }
}

mod is_68 {
    use super::*;

    fn cell(values: [i32; 8]) -> Volume {
        Volume::integers([2, 2, 2], values.to_vec()).expect("a cell")
    }

    fn mesh(volume: &Volume, decomposition: Decomposition) -> TetrahedraMesh {
        let level = Level { volume, isovalue: Rational::new(), tie: Tie::Degenerate };
        extract(&level, decomposition).expect("no sample is 0")
    }

    /// How many components {f > 0} has: those of the graph of the positive corners and the tetrahedra's edges.
    fn positive_components(positive: &[usize], decomposition: Decomposition) -> usize {
        let mut parts: Vec<BTreeSet<usize>> = positive.iter().map(|c| BTreeSet::from([*c])).collect();
        for tetrahedron in decomposition.tetrahedra([0, 0, 0]) {
            let joined: BTreeSet<usize> =
                tetrahedron.map(Corner::index).into_iter().filter(|c| positive.contains(c)).collect();
            let (touched, mut apart): (Vec<_>, Vec<_>) = parts.into_iter().partition(|part| !part.is_disjoint(&joined));
            if !touched.is_empty() {
                apart.push(touched.into_iter().flatten().collect());
            }
            parts = apart;
        }
        parts.len()
    }

    fn kuhn(from: usize) -> Decomposition {
        Decomposition::Kuhn(Corner::ALL[from])
    }

    proptest! {
        #[test]
        fn two_opposite_corners_are_joined_by_the_decomposition_on_their_diagonal_only(
            magnitudes in prop::array::uniform8(1i32..=100)
        ) {
            let volume = cell(std::array::from_fn(|c| if c == 0 || c == 7 { magnitudes[c] } else { -magnitudes[c] }));
            for from in 0..8 {
                let joined = from == 0 || from == 7;
                prop_assert_eq!(positive_components(&[0, 7], kuhn(from)), if joined { 1 } else { 2 });
                let mesh = mesh(&volume, kuhn(from));
                let surface = components(mesh.vertices.len(), &mesh.triangles);
                let pieces: Vec<(i64, i64)> = surface.iter().map(|c| (c.chi, c.boundary_loops)).collect();
                // A tube along the diagonal, or a disc about each corner.
                prop_assert_eq!(pieces, if joined { vec![(0, 2)] } else { vec![(1, 1), (1, 1)] });
            }
        }

        #[test]
        fn two_corners_across_a_face_are_joined_by_the_diagonals_whose_faces_join_them(
            magnitudes in prop::array::uniform8(1i32..=100)
        ) {
            let volume = cell(std::array::from_fn(|c| if c == 0 || c == 3 { magnitudes[c] } else { -magnitudes[c] }));
            let counts = [0, 1, 2, 3].map(|from| {
                let mesh = mesh(&volume, kuhn(from));
                let surface = components(mesh.vertices.len(), &mesh.triangles);
                assert!(surface.iter().all(|c| (c.chi, c.boundary_loops) == (1, 1)));
                surface.len()
            });
            prop_assert_eq!(counts, [1, 2, 2, 1]);
            prop_assert_eq!([0, 1, 2, 3].map(|from| positive_components(&[0, 3], kuhn(from))), [1, 2, 2, 1]);
        }
    }
}
