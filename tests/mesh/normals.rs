//! ME-66, ME-67, ME-69: the sense of normals, and projected areas.

use isoracle::linear::Vector;
use isoracle::mesh::examples::point;
use isoracle::mesh::plane::{Plane, corner_normal, least_squares_offset, projected_areas};
use isoracle::mesh::vertex_list::Point;
use isoracle::number::Rational;
use proptest::prelude::*;

/// A lattice point of the plane.
type Flat = [i64; 2];

/// Twice the signed area of a triangle.
fn turn(a: Flat, b: Flat, c: Flat) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether p is on the closed segment.
fn is_on(p: Flat, a: Flat, b: Flat) -> bool {
    turn(a, b, p) == 0 && (0..2).all(|k| p[k] >= a[k].min(b[k]) && p[k] <= a[k].max(b[k]))
}

/// Whether sides have no point in common but consecutive ones their common vertex.
fn is_simple(polygon: &[Flat]) -> bool {
    let n = polygon.len();
    let side = |i: usize| (polygon[i % n], polygon[(i + 1) % n]);
    (0..n).all(|i| {
        (i + 1..n).all(|j| {
            let ((a, b), (c, e)) = (side(i), side(j));
            if j == i + 1 {
                !is_on(e, a, b) && !is_on(a, c, e)
            } else if i == 0 && j + 1 == n {
                !is_on(c, a, b) && !is_on(b, c, e)
            } else {
                let proper = turn(a, b, c).signum() * turn(a, b, e).signum() < 0
                    && turn(c, e, a).signum() * turn(c, e, b).signum() < 0;
                !proper && ![(c, a, b), (e, a, b), (a, c, e), (b, c, e)].iter().any(|&(p, q, r)| is_on(p, q, r))
            }
        })
    })
}

/// Whether a point off the border is inside: the number of sides that a ray to the right crosses is odd.
fn is_inside(p: Flat, polygon: &[Flat]) -> bool {
    let n = polygon.len();
    let crossed = |i: &usize| {
        let (a, b) = (polygon[*i], polygon[(*i + 1) % n]);
        (a[1] > p[1]) != (b[1] > p[1]) && (turn(a, b, p) > 0) == (b[1] > a[1])
    };
    (0..n).filter(crossed).count() % 2 == 1
}

/// All simple polygons of n vertices on {0, 1, 2} × {0, 1, 2}, from every first vertex, in both senses.
fn simple_polygons(n: usize) -> Vec<Vec<Flat>> {
    let mut all: Vec<Vec<Flat>> = vec![Vec::new()];
    for _ in 0..n {
        let longer = |part: &Vec<Flat>| {
            let part = part.clone();
            let next = (0..9).map(|i| [i % 3, i / 3]).filter({
                let part = part.clone();
                move |p| !part.contains(p)
            });
            next.map(move |p| [&part[..], &[p]].concat()).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.retain(|polygon| is_simple(polygon));
    all
}

/// The polygon in the plane z = 2x − 3y + 1, whose normal (−2, 3, 1) points up.
fn tilted(polygon: &[Flat]) -> Vec<Point> {
    polygon.iter().map(|&[x, y]| point([x, y, 2 * x - 3 * y + 1])).collect()
}

/// The sense of a simple polygon, by the corner at its leftmost vertex, of these the lowest: it is convex.
fn sense(polygon: &[Flat]) -> i64 {
    let n = polygon.len();
    let i = (0..n).min_by_key(|&i| polygon[i]).expect("a polygon has vertices");
    turn(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]).signum()
}

/// What a corner is: `None` where it is straight; whether it is convex otherwise. At a convex corner a point a little way
/// between the two sides is inside.
fn is_convex(polygon: &[Flat], i: usize) -> Option<bool> {
    let n = polygon.len();
    let [a, v, b] = [polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]];
    // In a lattice a hundred times as fine; no side is as near.
    let fine: Vec<Flat> = polygon.iter().map(|p| p.map(|x| 100 * x)).collect();
    let between = [0, 1].map(|k| 100 * v[k] + (a[k] - v[k]) + (b[k] - v[k]));
    (turn(a, v, b) != 0).then(|| is_inside(between, &fine))
}

/// n / (−2, 3, 1), which is a number.
fn along_up(n: &Point) -> Rational {
    let k = n[2].clone();
    assert_eq!(*n, point([-2, 3, 1]).scaled(&k));
    k
}

mod me_66 {
    use super::*;

    #[test]
    fn at_a_corner_the_normal_is_inverse_iff_the_corner_is_reflex() {
        let (mut convex, mut reflex) = (0, 0);
        for polygon in [4, 5].into_iter().flat_map(simple_polygons) {
            let (n, points) = (polygon.len(), tilted(&polygon));
            for i in 0..n {
                let corner = corner_normal([&points[(i + n - 1) % n], &points[i], &points[(i + 1) % n]]);
                let has_sense = along_up(&corner) * sense(&polygon);
                match is_convex(&polygon, i) {
                    None => assert_eq!(has_sense, 0),
                    Some(true) => assert!(has_sense > 0, "{polygon:?} {i}"),
                    Some(false) => assert!(has_sense < 0, "{polygon:?} {i}"),
                }
                convex += i32::from(has_sense > 0);
                reflex += i32::from(has_sense < 0);
            }
        }
        assert!(convex > 1000 && reflex > 100, "{convex} {reflex}");
    }

    #[test]
    fn in_a_pentagon_with_its_only_reflex_corner_at_2_the_vertices_4_5_1_are_right() {
        let mut found = 0;
        for polygon in simple_polygons(5) {
            let corners: Vec<Option<bool>> = (0..5).map(|i| is_convex(&polygon, i)).collect();
            if corners == [Some(true), Some(false), Some(true), Some(true), Some(true)] {
                let v = tilted(&polygon);
                assert!(along_up(&corner_normal([&v[0], &v[1], &v[2]])) * sense(&polygon) < 0);
                assert!(along_up(&corner_normal([&v[3], &v[4], &v[0]])) * sense(&polygon) > 0);
                found += 1;
            }
        }
        assert!(found > 10);
    }
}

mod me_67 {
    use super::*;

    fn half(x: Rational) -> Rational {
        x / 2
    }

    /// ½ Σ Vᵢ × Vᵢ₊₁.
    fn by_products(polygon: &[Point]) -> Point {
        let n = polygon.len();
        let sum = (0..n).fold(Vector::zero(), |sum, i| sum + &polygon[i].cross(&polygon[(i + 1) % n]));
        sum.map(|x| half(x.clone()))
    }

    /// The triangles from the first vertex.
    fn by_triangles(polygon: &[Point]) -> Point {
        let triangles =
            (1..polygon.len().max(2) - 1).map(|i| corner_normal([&polygon[0], &polygon[i], &polygon[i + 1]]));
        triangles.fold(Vector::zero(), |sum, t| sum + &t).map(|x| half(x.clone()))
    }

    #[test]
    fn trapezoids_products_and_triangles_agree_on_all_polygons_of_up_to_five_corners_of_the_cube() {
        let corners: Vec<Point> = (0..8).map(|i| point([i & 1, i >> 1 & 1, i >> 2])).collect();
        for n in 0..=5_u32 {
            for i in (0..8_usize.pow(n)).step_by(if n == 5 { 7 } else { 1 }) {
                let polygon: Vec<Point> = (0..n).map(|k| corners[i >> (3 * k) & 7].clone()).collect();
                let areas = projected_areas(&polygon);
                assert_eq!(areas, by_products(&polygon));
                assert_eq!(areas, by_triangles(&polygon));
            }
        }
    }

    #[test]
    fn each_coefficient_is_the_area_of_a_projection_counted_by_lattice_points() {
        // Pick: area = points inside + points on the border / 2 − 1; the projection on (x,y), and by symmetry on the others.
        for polygon in [3, 4, 5].into_iter().flat_map(simple_polygons) {
            let n = polygon.len();
            let lattice = (0..9).map(|i| [i % 3, i / 3]);
            let on_border = |p: &Flat| (0..n).any(|i| is_on(*p, polygon[i], polygon[(i + 1) % n]));
            let border = lattice.clone().filter(on_border).count() as i64;
            let inside = lattice.filter(|p| !on_border(p) && is_inside(*p, &polygon)).count() as i64;
            let area = Rational::from((2 * inside + border - 2, 2)) * sense(&polygon);
            let placed = |k: usize| -> Vec<Point> {
                let place = |&[u, v]: &Flat| {
                    let mut p = [7, 7, 7];
                    (p[k], p[(k + 1) % 3], p[(k + 2) % 3]) = (u * v - 5, u, v);
                    point(p)
                };
                polygon.iter().map(place).collect()
            };
            // k = 0: u, v are y, z, and A is the area; k = 1: z, x and B; k = 2: x, y and C.
            for k in 0..3 {
                assert_eq!(projected_areas(&placed(k))[k], area, "{polygon:?}");
            }
            assert_eq!(projected_areas(&tilted(&polygon)), point([-2, 3, 1]).scaled(&area));
        }
    }

    #[test]
    fn the_unit_square_has_its_normal_up_and_the_other_order_of_differences_has_it_down() {
        let square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map(point);
        assert_eq!(projected_areas(&square), point([0, 0, 1]));
        assert_eq!(corner_normal([&square[0], &square[1], &square[2]]), point([0, 0, 1]));
        let other = |k: usize, l: usize| {
            let sum = (0..4).map(|i| (&square[i], &square[(i + 1) % 4]));
            half(sum.map(|(a, b)| Rational::from(&b[k] - &a[k]) * Rational::from(&a[l] + &b[l])).sum())
        };
        assert_eq!(Vector([other(1, 2), other(2, 0), other(0, 1)]), point([0, 0, -1]));
    }

    #[test]
    fn a_bow_tie_of_equal_triangles_has_none() {
        let bow_tie = [[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]].map(point);
        assert_eq!(projected_areas(&bow_tie), Vector::zero());
    }

    proptest! {
        #[test]
        fn they_do_not_change_with_the_origin_and_the_first_vertex_and_turn_with_the_sense(
            polygon in prop::collection::vec([-9..=9_i64, -9..=9, -9..=9], 1..8), by in [-9..=9_i64, -9..=9, -9..=9],
        ) {
            let mut polygon: Vec<Point> = polygon.into_iter().map(point).collect();
            let areas = projected_areas(&polygon);
            prop_assert_eq!(&areas, &by_products(&polygon));
            let moved: Vec<Point> = polygon.iter().map(|v| v.clone() + &point(by)).collect();
            prop_assert_eq!(&areas, &projected_areas(&moved));
            polygon.rotate_left(1);
            prop_assert_eq!(&areas, &projected_areas(&polygon));
            polygon.reverse();
            prop_assert_eq!(areas, -projected_areas(&polygon));
        }
    }
}

mod me_69 {
    use super::*;

    #[test]
    fn the_sense_is_right_whatever_the_corners() {
        for polygon in [3, 4, 5].into_iter().flat_map(simple_polygons) {
            assert!(along_up(&projected_areas(&tilted(&polygon))) * sense(&polygon) > 0, "{polygon:?}");
        }
    }

    /// Σ d² and the greatest d² over the vertices.
    fn misfit(plane: &Plane, polygon: &[Point]) -> (Rational, Rational) {
        let squares = || polygon.iter().map(|v| plane.distance_squared(v));
        (squares().sum(), squares().max().expect("a polygon has vertices"))
    }

    #[test]
    fn the_vertices_of_a_dart_are_nearer_to_the_plane_of_its_first_three() {
        let dart = [[0, 0, 0], [0, 8, 0], [8, 0, 0], [1, 6, 1]].map(point);
        assert!(is_simple(&[[0, 0], [0, 8], [8, 0], [1, 6]]));
        let all = Plane::of_polygon(&dart).expect("an area");
        let three = Plane::through([&dart[0], &dart[1], &dart[2]]).expect("a triangle");
        assert_eq!(misfit(&all, &dart), (Rational::from((64, 5)), Rational::from((16, 5))));
        assert_eq!(misfit(&three, &dart), (Rational::from(1), Rational::from(1)));
    }

    #[test]
    fn it_may_be_better_too_and_on_a_plane_polygon_both_are_the_same() {
        let square = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]].map(point);
        let all = Plane::of_polygon(&square).expect("an area");
        let three = Plane::through([&square[3], &square[0], &square[1]]).expect("a triangle");
        assert!(misfit(&all, &square) < misfit(&three, &square));
        for polygon in simple_polygons(4) {
            let points = tilted(&polygon);
            let all = Plane::of_polygon(&points).expect("an area");
            if let Ok(three) = Plane::through([&points[0], &points[1], &points[2]]) {
                assert_eq!(all.normal().cross(three.normal()), Vector::zero());
                assert_eq!(least_squares_offset(three.normal(), &points).as_ref(), Some(three.offset()));
            }
        }
    }
}
