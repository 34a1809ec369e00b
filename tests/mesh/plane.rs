//! ME-60 … ME-72: the plane of a polygon, from three vertices and from all.

use super::naive_check::{in_a_plane, on_a_line};
use super::specimens::{number, rational};
use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::mesh::examples::point;
use isoracle::mesh::plane::{
    NoPlane, Plane, Span, corner_normal, least_squares_offset, projected_areas, span, successor,
};
use isoracle::mesh::vertex_list::Point;
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;

/// The points {0, …, n − 1}³.
fn grid(n: i64) -> Vec<Point> {
    (0..n * n * n).map(|i| point([i % n, i / n % n, i / (n * n)])).collect()
}

fn d(from: &Point, to: &Point) -> Point {
    to.clone() - from
}

/// |a b c|.
fn det(a: &Point, b: &Point, c: &Point) -> Rational {
    determinant3(&Matrix::from_columns(&[a.clone(), b.clone(), c.clone()]))
}

fn coordinate() -> impl Strategy<Value = Rational> {
    let hair = prop_oneof![4 => Just(0_i64), 1 => Just(1), 1 => Just(-1)];
    (-4..=4_i64, hair).prop_map(|(x, hair)| number([x, 2]) + number([hair, 1_000_000_000_000_000]))
}

fn any_point() -> impl Strategy<Value = Point> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vector)
}

mod me_60 {
    use super::*;

    #[test]
    fn a_zero_normal_is_no_plane() {
        assert_eq!(Plane::new(point([0, 0, 0]), Rational::from(1)), Err(NoPlane::ZeroNormal));
        assert_eq!(Plane::of_polygon(&[]), Err(NoPlane::NoVertex));
        assert_eq!(Plane::of_polygon(&grid(2)[..2]), Err(NoPlane::ZeroNormal));
    }

    proptest! {
        #[test]
        fn its_points_are_those_across_the_normal_from_one_of_them(normal in any_point(), p in any_point(), q in any_point()) {
            let offset = normal.dot(&p);
            if let Ok(plane) = Plane::new(normal.clone(), offset) {
                prop_assert_eq!(plane.side(&p), Sign::Zero);
                prop_assert_eq!(plane.side(&q), Sign::of(d(&p, &q).dot(&normal).cmp0()));
                // Along the normal it goes up, across it stays.
                prop_assert_eq!(plane.side(&(p.clone() + &normal)), Sign::Positive);
                prop_assert_eq!(plane.height(&(q.clone() + &normal.cross(&p))), plane.height(&q));
            }
        }
    }
}

mod me_61 {
    use super::*;

    #[test]
    fn the_plane_changes_unless_the_offset_takes_the_factor_too() {
        let plane = Plane::new(point([0, 0, 2]), Rational::from(2)).expect("a normal");
        assert_eq!(plane.unit_factor_squared(), number([1, 4]));
        let on_it = point([5, 7, 1]);
        let unit = |offset: i64| Plane::new(point([0, 0, 1]), Rational::from(offset)).expect("a normal");
        assert_eq!(plane.side(&on_it), Sign::Zero);
        assert_eq!((unit(2).side(&on_it), unit(1).side(&on_it)), (Sign::Negative, Sign::Zero));
    }

    proptest! {
        #[test]
        fn the_normal_times_k_has_length_one(normal in any_point()) {
            if let Ok(plane) = Plane::new(normal.clone(), Rational::from(3)) {
                let k_squared = plane.unit_factor_squared();
                let squares = normal.0.iter().map(|x| Rational::from(x * x) * &k_squared);
                prop_assert_eq!(squares.sum::<Rational>(), Rational::from(1));
                // Where the modulus is rational, so is k.
                let scaled = normal.scaled(&number([3, 5]));
                let k = Plane::new(scaled, Rational::new()).expect("not 0").unit_factor_squared();
                prop_assert_eq!(k * number([9, 25]), k_squared);
            }
        }
    }
}

mod me_62 {
    use super::*;

    #[test]
    fn three_points_are_always_in_a_plane_and_in_one_only_unless_collinear() {
        let mut points = grid(2);
        points.extend([point([2, 2, 2]), point([1, 2, 0])]);
        // All directions of a normal that the points can need, up to sense.
        let normals: Vec<Point> = (0..729).map(|i| point([i % 9 - 4, i / 9 % 9 - 4, i / 81 - 4])).collect();
        for a in &points {
            for b in &points {
                for c in &points {
                    let across =
                        |n: &&Point| **n != Vector::zero() && n.dot(&d(a, b)).is_zero() && n.dot(&d(a, c)).is_zero();
                    let across: Vec<&Point> = normals.iter().filter(across).collect();
                    let one = across.iter().all(|n| n.cross(across[0]) == Vector::zero());
                    assert!(!across.is_empty());
                    match span([a, b, c]) {
                        Span::Plane(n) => assert!(one && n.cross(across[0]) == Vector::zero()),
                        Span::Line => assert!(!one && on_a_line(&[a, b, c].map(Clone::clone))),
                        Span::Point => assert!(a == b && b == c),
                        Span::Empty | Span::Space => panic!("three points span {:?}", span([a, b, c])),
                    }
                }
            }
        }
    }

    #[test]
    fn what_lists_of_up_to_four_points_span_is_what_their_determinants_say() {
        assert_eq!(span(&[]), Span::Empty);
        let points = grid(2);
        for i in 0..8_usize.pow(4) {
            let some = [i % 8, i / 8 % 8, i / 64 % 8, i / 512].map(|k| points[k].clone());
            let expected = (some.iter().all(|p| *p == some[0]), on_a_line(&some), in_a_plane(&some));
            let found = match span(&some) {
                Span::Empty => panic!("four points"),
                Span::Point => (true, true, true),
                Span::Line => (false, true, true),
                Span::Plane(n) => {
                    assert!(n != Vector::zero() && some.iter().all(|p| n.dot(&d(&some[0], p)).is_zero()));
                    (false, false, true)
                }
                Span::Space => (false, false, false),
            };
            assert_eq!(found, expected, "{some:?}");
        }
    }

    proptest! {
        #[test]
        fn a_hair_out_of_the_plane_is_out_of_it(points in prop::collection::vec(any_point(), 0..7), flat: bool) {
            let mut points = points;
            if flat {
                points.iter_mut().for_each(|p| p.0[1] = Rational::from(&p[0] * &number([1, 3])) - &p[2]);
            }
            let is_plane = !matches!(span(&points), Span::Space);
            prop_assert_eq!(is_plane, in_a_plane(&points));
            let is_line = matches!(span(&points), Span::Empty | Span::Point | Span::Line);
            prop_assert_eq!(is_line, on_a_line(&points));
        }
    }
}

mod me_63 {
    use super::*;

    fn holds_for([v1, v2, v3]: [&Point; 3]) {
        let x = |[a, b]: [&Point; 2], [c, e]: [&Point; 2]| d(a, b).cross(&d(c, e));
        let n = corner_normal([v1, v2, v3]);
        // As printed.
        assert_eq!(n, x([v1, v2], [v1, v3]));
        assert_eq!(n, x([v2, v3], [v2, v1]));
        assert_eq!(n, x([v3, v1], [v3, v2]));
        // The same indices backwards by twos, and forwards.
        assert_eq!(
            [x([v2, v1], [v3, v1]), x([v3, v2], [v1, v2]), x([v1, v3], [v2, v3])],
            [n.clone(), n.clone(), n.clone()]
        );
        let back = -n.clone();
        assert_eq!(
            [x([v2, v3], [v1, v3]), x([v1, v2], [v3, v2]), x([v3, v1], [v2, v1])],
            [back.clone(), back.clone(), back]
        );
        // ⟨n, w⟩ = |V₁V₂ V₁V₃ w| for every w: that is what makes it the product.
        for axis in [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(point) {
            assert_eq!(n.dot(&axis), det(&d(v1, v2), &d(v1, v3), &axis));
        }
        // Counterclockwise from its tip.
        assert!(det(&d(v1, v2), &d(v1, v3), &n) >= 0);
    }

    #[test]
    fn the_three_products_are_equal_on_a_grid() {
        let points = grid(2);
        for i in 0..512 {
            holds_for([i % 8, i / 8 % 8, i / 64].map(|k| &points[k]));
        }
    }

    proptest! {
        #[test]
        fn the_three_products_are_equal(v1 in any_point(), v2 in any_point(), v3 in any_point()) {
            holds_for([&v1, &v2, &v3]);
        }
    }
}

mod me_64 {
    use super::*;

    /// Whether one of the three is between the other two, or two are equal: by ratios of coordinates.
    fn collinear([a, b, c]: [&Point; 3]) -> bool {
        match (0..3).find(|&k| a[k] != b[k]) {
            None => true,
            Some(axis) => {
                let t = Rational::from(&c[axis] - &a[axis]) / Rational::from(&b[axis] - &a[axis]);
                a.clone() + &d(a, b).scaled(&t) == *c
            }
        }
    }

    #[test]
    fn the_product_vanishes_iff_three_points_are_collinear() {
        let points = grid(3);
        let mut on_lines = 0;
        for a in &points {
            for b in &points {
                for c in points.iter().step_by(2) {
                    let zero = corner_normal([a, b, c]) == Vector::zero();
                    assert_eq!(zero, collinear([a, b, c]));
                    assert_eq!(zero, Plane::through([a, b, c]) == Err(NoPlane::ZeroNormal));
                    on_lines += i32::from(zero);
                }
            }
        }
        assert!(on_lines > 1000);
    }
}

mod me_65 {
    use super::*;

    #[test]
    fn the_offset_is_the_same_from_each_of_the_three_and_the_fourth_is_judged_by_a_determinant() {
        let points = grid(2);
        for i in 0..8_usize.pow(4) {
            let [a, b, c, e] = [i % 8, i / 8 % 8, i / 64 % 8, i / 512].map(|k| &points[k]);
            if let Ok(plane) = Plane::through([a, b, c]) {
                assert!([a, b, c].iter().all(|v| plane.normal().dot(v) == *plane.offset()));
                assert_eq!(plane.side(e), Sign::of(det(&d(a, b), &d(a, c), &d(a, e)).cmp0()));
            }
        }
    }

    #[test]
    fn from_three_collinear_vertices_the_equation_says_nothing() {
        let polygon = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 1]].map(point);
        let printed = corner_normal([&polygon[0], &polygon[1], &polygon[2]]);
        assert_eq!(printed, Vector::zero());
        // 0 = 0 at every vertex.
        assert!(polygon.iter().all(|v| printed.dot(v).is_zero()));
        assert_eq!(span(&polygon), Span::Space);
        assert!(!in_a_plane(&polygon));
        assert_eq!(Plane::through([&polygon[0], &polygon[1], &polygon[2]]), Err(NoPlane::ZeroNormal));
    }
}

mod me_68 {
    use super::*;

    #[test]
    fn the_last_is_followed_by_the_first() {
        for n in 1..20 {
            let next: Vec<usize> = (1..=n).map(|i| successor(i, n)).collect();
            let mut rotated: Vec<usize> = (1..=n).collect();
            rotated.rotate_left(1);
            assert_eq!(next, rotated);
            assert!((1..=n).all(|i| successor(i, n) == i % n + 1));
        }
    }

    #[test]
    #[should_panic(expected = "is not in 1 … 3")]
    fn numbers_begin_with_one() {
        successor(0, 3);
    }
}

mod me_70 {
    use super::*;

    #[test]
    fn the_printed_sum_is_two_where_the_distance_is_zero() {
        let plane = Plane::new(point([0, 0, 1]), Rational::from(1)).expect("a normal");
        let at = point([0, 0, 1]);
        let printed = plane.normal().dot(&at) + plane.offset();
        assert_eq!((printed, plane.distance_squared(&at)), (Rational::from(2), Rational::new()));
    }

    proptest! {
        #[test]
        fn it_is_the_distance_of_the_foot_which_no_other_point_of_the_plane_is_nearer_than(
            normal in any_point(), offset in coordinate(), p in any_point(), q in any_point(),
        ) {
            if let Ok(plane) = Plane::new(normal.clone(), offset) {
                let k_squared = plane.unit_factor_squared();
                let onto = |p: &Point| p.clone() - &normal.scaled(&(plane.height(p) * &k_squared));
                let (foot, other) = (onto(&p), onto(&q));
                prop_assert_eq!(plane.side(&foot), Sign::Zero);
                prop_assert_eq!(plane.distance_squared(&p), d(&foot, &p).norm_squared());
                prop_assert!(plane.distance_squared(&p) <= d(&other, &p).norm_squared());
                // The printed form is right iff D = 0.
                let printed = (normal.dot(&p) + plane.offset()).square() * &k_squared;
                let agrees_everywhere = plane.offset().is_zero();
                prop_assert!(!agrees_everywhere || printed == plane.distance_squared(&p));
                let printed_at_foot = normal.dot(&foot) + plane.offset();
                prop_assert_eq!(printed_at_foot.is_zero(), agrees_everywhere);
            }
        }
    }
}

mod me_71 {
    use super::*;

    #[test]
    fn the_printed_sum_is_two_at_a_point_of_the_plane() {
        let normal = rational([[3, 5], [0, 1], [4, 5]]);
        let plane = Plane::new(normal, Rational::from(1)).expect("a normal");
        assert_eq!(plane.unit_factor_squared(), Rational::from(1));
        let at = rational([[5, 3], [0, 1], [0, 1]]);
        assert_eq!(plane.normal().dot(&at) + plane.offset(), Rational::from(2));
        assert_eq!(plane.height(&at), Rational::new());
        // One unit up along the unit normal, and down.
        for t in [1, -1] {
            let moved = at.clone() + &plane.normal().scaled(&Rational::from(t));
            assert_eq!((plane.height(&moved), plane.distance_squared(&moved)), (Rational::from(t), Rational::from(1)));
        }
    }
}

mod me_72 {
    use super::*;

    /// Σ (A x + B y + C z − D)².
    fn squares(normal: &Point, offset: &Rational, points: &[Point]) -> Rational {
        points.iter().map(|p| (normal.dot(p) - offset).square()).sum()
    }

    #[test]
    fn with_the_printed_distance_the_plane_lies_on_the_other_side_of_the_origin() {
        let square = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]].map(point);
        let up = point([0, 0, 1]);
        assert_eq!(least_squares_offset(&up, &square), Some(Rational::from(1)));
        // Σ (z + D)² is least, 0, at D = −1, which (5.10) reads as z = −1.
        let printed = |offset: &Rational| squares(&up, &Rational::from(-offset), &square);
        let least = Rational::from(-1);
        assert_eq!(printed(&least), Rational::new());
        assert_eq!(squares(&up, &least, &square), Rational::from(16));
        assert_eq!(least_squares_offset(&up, &[]), None);
    }

    proptest! {
        #[test]
        fn no_other_offset_has_a_smaller_sum(normal in any_point(), points in prop::collection::vec(any_point(), 1..8), by in coordinate()) {
            let least = least_squares_offset(&normal, &points).expect("there is a point");
            let sum = squares(&normal, &least, &points);
            let other = squares(&normal, &Rational::from(&least + &by), &points);
            prop_assert_eq!(other - sum, Rational::from(points.len()) * by.square());
            // It is the mean: what is left over sums to 0.
            let left: Rational = points.iter().map(|p| normal.dot(p) - &least).sum();
            prop_assert_eq!(left, Rational::new());
        }

        #[test]
        fn the_plane_of_a_plane_polygon_has_all_of_its_vertices(points in prop::collection::vec(any_point(), 3..7)) {
            let flat: Vec<Point> = points.into_iter().map(|mut p| { p.0[2] = Rational::from(&p[0] - &p[1]) + 1; p }).collect();
            match Plane::of_polygon(&flat) {
                Ok(plane) => prop_assert!(flat.iter().all(|p| plane.side(p) == Sign::Zero)),
                Err(error) => prop_assert_eq!((error, projected_areas(&flat)), (NoPlane::ZeroNormal, Vector::zero())),
            }
        }
    }
}
