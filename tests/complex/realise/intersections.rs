//! Orientations, circuits, parting hyperplanes and embeddings, against linear programs.

use super::domain::{cross_polytope, grid_torus, simplex_boundary, torus_of_revolution};
use super::program::{is_in_hull, meet};
use isoracle::complex::realise::apart::are_apart;
use isoracle::complex::realise::circuit::{Side, circuit, common_point, independent};
use isoracle::complex::realise::intersections::{Intersections, intersections};
use isoracle::complex::realise::mesh::TetrahedralMesh;
use isoracle::complex::realise::orientation::{exact, filtered, orientation};
use isoracle::complex::realise::points::Points;
use isoracle::linear::{Matrix, determinant};
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;

/// Coordinates on a coarse grid, so that points coincide and span too little; some a last place beside it.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (-2..=2_i32).prop_map(f64::from),
        1 => (-2..=2_i32, any::<bool>()).prop_map(|(x, up)| if up { f64::from(x).next_up() } else { f64::from(x).next_down() }),
        1 => (-3..=3_i32).prop_map(|x| f64::from(x) / 3.0),
    ]
}

fn cloud(points: usize, n: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::collection::vec(prop::collection::vec(coordinate(), n), points)
}

fn slices(points: &[Vec<f64>]) -> Vec<&[f64]> {
    points.iter().map(Vec::as_slice).collect()
}

mod cx_84 {
    use super::*;

    fn by_division_free_expansion<const N: usize>(points: &[&[f64]]) -> Sign {
        let value = |p: usize, i: usize| Rational::from_f64(points[p][i]).expect("finite");
        let rows = Matrix::<Rational, N, N>::from_fn(|i, j| value(i + 1, j) - value(0, j));
        Sign::of(determinant(&rows).cmp0())
    }

    proptest! {
        #[test]
        fn it_is_the_sign_of_the_determinant(points in cloud(6, 5), scale in prop_oneof![Just(1.0), Just(1e-160), Just(1e200), Just(5e-324)]) {
            let points: Vec<Vec<f64>> = points.iter().map(|p| p.iter().map(|x| x * scale).collect()).collect();
            let points = slices(&points);
            let found = orientation(&points, &[0, 1, 2, 3, 4]);
            prop_assert_eq!(found, by_division_free_expansion::<5>(&points));
            prop_assert_eq!(found, exact(&points, &[0, 1, 2, 3, 4]));
            if let Some(sign) = filtered(&points, &[0, 1, 2, 3, 4]) {
                prop_assert_eq!(sign, found);
            }
            prop_assert_eq!(orientation(&points[..4], &[1, 2, 4]), {
                let axes: Vec<Vec<f64>> = points[..4].iter().map(|p| vec![p[1], p[2], p[4]]).collect();
                by_division_free_expansion::<3>(&slices(&axes))
            });
        }
    }

    #[test]
    fn the_filter_decides_what_is_clear_and_nothing_else() {
        let unit: Vec<Vec<f64>> = (0..5).map(|i| (0..4).map(|j| f64::from(u8::from(i == j + 1))).collect()).collect();
        assert_eq!(filtered(&slices(&unit), &[0, 1, 2, 3]), Some(Sign::Positive));
        assert_eq!(filtered(&slices(&unit), &[1, 0, 2, 3]), Some(Sign::Negative));
        let mut flat = unit.clone();
        flat[4] = flat[3].clone();
        assert_eq!(filtered(&slices(&flat), &[0, 1, 2, 3]), None);
        assert_eq!(orientation(&slices(&flat), &[0, 1, 2, 3]), Sign::Zero);
        // Rounded, 1/10 and 2/10 lie on a line with 0 and 3/10 does not.
        let line = [vec![0.0, 0.0], vec![0.1, 0.2], vec![0.3, 0.6]];
        assert_eq!(orientation(&slices(&line), &[0, 1]), exact(&slices(&line), &[0, 1]));
        assert_eq!(orientation(&[&[1.0]], &[]), Sign::Positive);
    }
}

mod cx_85 {
    use super::*;

    fn sides() -> impl Strategy<Value = Vec<Side>> {
        // Two simplices of at most four corners with up to three in common.
        (0..=3_usize, 1..=4_usize, 1..=4_usize).prop_map(|(both, first, second)| {
            let (first, second) = (first.min(4 - both).max(1), second.min(4 - both).max(1));
            [vec![Side::First; first], vec![Side::Second; second], vec![Side::Both; both]].concat()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(120))]

        #[test]
        fn a_linear_program_says_the_same(points in cloud(8, 5), n in 1..=5_usize, sides in sides()) {
            let points: Vec<Vec<f64>> = points.iter().take(sides.len()).map(|p| p[..n].to_vec()).collect();
            let points = slices(&points);
            let found = circuit(&points, &sides);
            prop_assert_eq!(found.is_some(), meet(&points, &sides));
            if let Some(circuit) = found {
                prop_assert!(circuit.first.iter().all(|i| sides[*i] != Side::Second));
                prop_assert!(circuit.second.iter().all(|i| sides[*i] != Side::First && !circuit.first.contains(i)));
                // No more points than a dependence of least support has.
                prop_assert!(circuit.first.len() + circuit.second.len() <= n + 2);
                let [first, second] = [&circuit.first, &circuit.second].map(|part| part.iter().map(|i| points[*i]).collect::<Vec<_>>());
                let point = common_point(&first, &second);
                prop_assert!(is_in_hull(&point, &first) && is_in_hull(&point, &second));
            }
        }

        #[test]
        fn independence_is_to_have_no_dependence(points in cloud(5, 4), count in 1..=5_usize) {
            let points = slices(&points[..count]);
            prop_assert_eq!(independent(&points), !meet(&points, &vec![Side::Both; count]));
        }
    }
}

mod cx_86 {
    use super::*;

    /// Every pair of tetrahedra, and each by itself, by linear programs.
    fn by_programs(mesh: &TetrahedralMesh, points: &Points) -> (usize, usize) {
        let tetrahedra = mesh.tetrahedra();
        let pair = |a: &[u32; 4], b: &[u32; 4]| {
            let mut vertices = a.to_vec();
            vertices.extend(b.iter().filter(|v| !a.contains(v)));
            let side = |v: &u32| match (a.contains(v), b.contains(v)) {
                (true, true) => Side::Both,
                (true, false) => Side::First,
                (false, _) => Side::Second,
            };
            let sides: Vec<Side> = vertices.iter().map(side).collect();
            meet(&vertices.iter().map(|v| points.at(*v as usize)).collect::<Vec<_>>(), &sides)
        };
        let flat = tetrahedra.iter().filter(|t| pair(t, t)).count();
        let pairs = (0..tetrahedra.len())
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .filter(|(i, j)| pair(&tetrahedra[*i], &tetrahedra[*j]))
            .count();
        (flat, pairs)
    }

    fn assert_witnessed(mesh: &TetrahedralMesh, points: &Points, found: &Intersections) {
        assert_eq!(found.is_embedded(), found.witness.is_none());
        if let Some(witness) = &found.witness {
            let point = witness.point(points);
            for (simplex, tetrahedron) in witness.simplices.iter().zip(witness.tetrahedra) {
                assert!(simplex.iter().all(|v| mesh.tetrahedra()[tetrahedron as usize].contains(v)));
                let corners: Vec<&[f64]> = simplex.iter().map(|v| points.at(*v as usize)).collect();
                assert!(is_in_hull(&point, &corners));
            }
            assert!(witness.simplices[0].iter().all(|v| !witness.simplices[1].contains(v)));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3))]

        #[test]
        fn every_pair_is_found(points in cloud(8, 4), n in 3..=4_usize) {
            for mesh in [simplex_boundary(), cross_polytope()] {
                let coordinates = points[..mesh.vertices()].iter().flat_map(|p| p[..n].to_vec()).collect();
                let points = Points::new(n, coordinates).expect("finite");
                let found = intersections(&mesh, &points);
                prop_assert_eq!((found.flat, found.pairs), by_programs(&mesh, &points));
                assert_witnessed(&mesh, &points, &found);
            }
        }
    }

    #[test]
    fn convex_hypersurfaces_are_embedded_and_their_shadows_are_not() {
        for mesh in [simplex_boundary(), cross_polytope()] {
            let corner = |v: usize| -> Vec<f64> {
                match mesh.vertices() {
                    5 => (0..4).map(|i| f64::from(u8::from(i == v))).collect(),
                    _ => (0..4).map(|i| if i == v / 2 { 1.0 - 2.0 * (v % 2) as f64 } else { 0.0 }).collect(),
                }
            };
            let solid = |n: usize| {
                let coordinates = (0..mesh.vertices()).flat_map(|v| corner(v)[..n].to_vec()).collect();
                Points::new(n, coordinates).expect("finite")
            };
            assert!(intersections(&mesh, &solid(4)).is_embedded());
            let shadow = intersections(&mesh, &solid(3));
            assert!(!shadow.is_embedded());
            assert_witnessed(&mesh, &solid(3), &shadow);
        }
    }

    #[test]
    fn the_torus_of_revolution_lies_in_four_dimensions() {
        let sizes = [4, 5, 9];
        let (mesh, points) = (grid_torus(sizes), torus_of_revolution(sizes, [1.0, 2.5, 6.0]));
        let found = intersections(&mesh, &points);
        assert!(found.is_embedded(), "{found:?}");
        assert!(found.tested >= mesh.triangles().len());
        // A vertex pulled through the hole meets the other side.
        let mut coordinates = points.coordinates().to_vec();
        coordinates[..4].copy_from_slice(&[-7.0, 0.25, 0.125, 0.0]);
        let pulled = Points::new(4, coordinates).expect("finite");
        let found = intersections(&mesh, &pulled);
        assert!(found.pairs > 0 && found.flat == 0, "{found:?}");
        assert_witnessed(&mesh, &pulled, &found);
        // With radii the wrong way round it runs through itself.
        let thick = torus_of_revolution(sizes, [2.5, 1.0, 6.0]);
        assert!(intersections(&mesh, &thick).pairs > 0);
    }

    #[test]
    fn five_dimensions_do_not_part_what_is_laid_across() {
        // Two tetrahedra of ℝ⁵ without a common vertex that meet in a segment: 3 + 3 − 5 = 1.
        let mesh = TetrahedralMesh::of_tetrahedra(8, &[[0, 1, 2, 3], [4, 5, 6, 7]]).expect("tetrahedra");
        let corner = |axes: [f64; 5]| axes.to_vec();
        let first = [
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [-1.0, 1.0, 0.0, 0.0, 0.0],
            [-1.0, -1.0, 1.0, 0.0, 0.0],
            [-1.0, -1.0, -1.0, 0.0, 0.0],
        ];
        let second = [
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0, 1.0, 0.0],
            [-1.0, 0.0, 0.0, -1.0, 1.0],
            [-1.0, 0.0, 0.0, -1.0, -1.0],
        ];
        let coordinates: Vec<f64> = first.into_iter().chain(second).flat_map(corner).collect();
        let points = Points::new(5, coordinates.clone()).expect("finite");
        assert_eq!(intersections(&mesh, &points).pairs, 1);
        let lifted: Vec<f64> =
            coordinates.iter().enumerate().map(|(i, x)| if i >= 20 && i % 5 == 2 { x + 9.0 } else { *x }).collect();
        assert!(intersections(&mesh, &Points::new(5, lifted).expect("finite")).is_embedded());
    }

    #[test]
    fn what_is_flat_is_found_by_itself() {
        let mesh = TetrahedralMesh::of_tetrahedra(4, &[[0, 1, 2, 3]]).expect("a tetrahedron");
        let square = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
        let points = Points::new(4, square.to_vec()).expect("finite");
        let found = intersections(&mesh, &points);
        assert_eq!((found.flat, found.pairs), (1, 0));
        assert_witnessed(&mesh, &points, &found);
        // The diagonals of the square meet in its middle.
        let middle = found.witness.expect("a witness").point(&points);
        assert_eq!(middle, [1, 1, 0, 0].map(|x| Rational::from((x, 2))));
    }
}

mod cx_88 {
    use super::*;

    proptest! {
        #[test]
        fn what_is_parted_does_not_meet(points in cloud(8, 4), shift in 0..=5_i32, last in any::<bool>()) {
            let moved = |x: f64| if last { x + f64::from(shift) } else { (x + f64::from(shift)).next_up() };
            let second: Vec<Vec<f64>> = points[4..].iter().map(|p| [&[moved(p[0])], &p[1..]].concat()).collect();
            let (first, second) = (slices(&points[..4]), slices(&second));
            let sides = [[Side::First; 4], [Side::Second; 4]].concat();
            if are_apart(&first, &second) {
                prop_assert!(!meet(&[first.clone(), second.clone()].concat(), &sides));
            }
            // Boxes that are clearly apart are parted.
            if shift == 5 {
                prop_assert!(are_apart(&first, &second) && are_apart(&second, &first));
            }
        }
    }

    proptest! {
        /// The second one has a corner of the first, or the middle of its edge, and else lies beyond.
        #[test]
        fn what_touches_in_a_point_is_not_parted(points in cloud(8, 4), middle in any::<bool>(), shift in 0..=6_i32) {
            let corner: Vec<f64> = match middle {
                true => points[0].iter().zip(&points[1]).map(|(a, b)| f64::midpoint(*a, *b)).collect(),
                false => points[0].clone(),
            };
            let mut second: Vec<Vec<f64>> =
                points[4..].iter().map(|p| [&[p[0] + f64::from(shift)], &p[1..]].concat()).collect();
            second[0] = corner;
            let (first, second) = (slices(&points[..4]), slices(&second));
            let sides = [[Side::First; 4], [Side::Second; 4]].concat();
            if !middle {
                prop_assert!(!are_apart(&first, &second) && !are_apart(&second, &first));
            } else if are_apart(&first, &second) {
                // A rounded middle need not lie on the edge.
                prop_assert!(!meet(&[first, second].concat(), &sides));
            }
        }
    }

    #[test]
    fn what_touches_is_never_parted() {
        // A corner on the other's face, whose plane no binary64 direction is normal to exactly.
        let third = 1.0 / 3.0;
        let face = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-9.0, -9.0, -9.0]].map(|p| p.to_vec());
        let touching =
            [[third, third, 1.0 - 2.0 * third], [5.0, 5.0, 5.5], [5.0, 5.5, 5.0], [6.0, 5.0, 5.0]].map(|p| p.to_vec());
        let sides = [[Side::First; 4], [Side::Second; 4]].concat();
        let all = [slices(&face), slices(&touching)].concat();
        assert!(meet(&all, &sides));
        assert!(!are_apart(&slices(&face), &slices(&touching)));
        let huge = [[1e150; 3], [1e151; 3], [1e152; 3], [1e153; 3]].map(|p| p.to_vec());
        assert!(!are_apart(&slices(&face), &slices(&huge)));
    }
}
