//! IS-16 … IS-35: multilinear interpolation and its zeros.

use isoracle::isosurface::multilinear::{
    LinearZero, bilinear, bilinear_gradient, linear, linear_zero, on_line, piecewise_linear, trilinear, zero_on_line,
};
use isoracle::linear::{Matrix, determinant};
use isoracle::number::{Integer, Rational};
use proptest::prelude::*;

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn rationals<const N: usize>(values: [i64; N]) -> [Rational; N] {
    values.map(Rational::from)
}

fn rational() -> impl Strategy<Value = Rational> {
    (-30i64..=30, 1i64..=9).prop_map(|(n, d)| q(n, d))
}

/// A number of [0, 1], often an end.
fn share() -> impl Strategy<Value = Rational> {
    (0i64..=12).prop_map(|n| q(n, 12))
}

/// A signal on the integers from a list, repeated.
fn periodic(values: &[Rational]) -> impl Fn(&Integer) -> Rational {
    move |i| {
        let n = Integer::from(values.len());
        let (_, remainder) = i.clone().div_rem_floor(n);
        values[remainder.to_usize().expect("a remainder of a positive number")].clone()
    }
}

/// g₀ + u·(g₁ − g₀): the other way to write a segment.
fn along(g0: &Rational, g1: &Rational, u: &Rational) -> Rational {
    Rational::from(g1 - g0) * u + g0
}

/// The rank of a set of rows.
fn rank(mut rows: Vec<Vec<Rational>>) -> usize {
    let mut rank = 0;
    for column in 0..rows[0].len() {
        let Some(pivot) = (rank..rows.len()).find(|&r| rows[r][column] != 0) else { continue };
        rows.swap(rank, pivot);
        for r in rank + 1..rows.len() {
            let factor = Rational::from(&rows[r][column] / &rows[rank][column]);
            for c in 0..rows[r].len() {
                let without = Rational::from(&factor * &rows[rank][c]);
                rows[r][c] -= without;
            }
        }
        rank += 1;
    }
    rank
}

/// uᵃ at 0 or 1.
fn power(u: usize, a: usize) -> usize {
    usize::from(a == 0 || u == 1)
}

mod is_16 {
    use super::*;

    proptest! {
        #[test]
        fn with_linear_pieces_f_is_continuous_at_the_grid_points(
            g in prop::collection::vec(rational(), 1..6), n in -9i64..=9, step in 1i64..=1000
        ) {
            let g = periodic(&g);
            let [before, at, after] = [n - 1, n, n + 1].map(|i| g(&Integer::from(i)));
            // |f(n ± h) − f(n)| ≤ h·|slope| with the piece's slope: the limits on both sides are f(n).
            let h = q(1, step);
            let f = |x: Rational| piecewise_linear(&g, &x);
            prop_assert_eq!(f(q(n, 1)), at.clone());
            prop_assert_eq!(f(q(n, 1) + &h), along(&at, &after, &h));
            prop_assert_eq!(f(q(n, 1) - &h), along(&at, &before, &h));
        }
    }

    #[test]
    fn the_end_conditions_alone_do_not_make_it_continuous() {
        // g ≡ 0, and f₀ is 1 at 1/2, else 0: both conditions hold.
        let piece = |u: &Rational| Rational::from(i32::from(*u == q(1, 2)));
        assert_eq!([piece(&q(0, 1)), piece(&q(1, 1))], [0, 0]);
        assert_eq!(piece(&q(1, 2)), 1);
        assert!((1..100).all(|n| piece(&(q(1, 2) + q(1, 2 * n))) == 0 && piece(&(q(1, 2) - q(1, 2 * n))) == 0));
    }
}

mod is_17 {
    use super::*;

    #[test]
    fn the_whole_part_is_the_floor_and_not_truncation() {
        let values = rationals([0, 1, 0]);
        let g = periodic(&values);
        let x = q(-1, 2);
        let truncated = x.clone().trunc();
        assert_eq!(truncated, 0);
        assert_eq!(linear(&[g(&Integer::from(0)), g(&Integer::from(1))], &x), q(-1, 2), "with truncation");
        assert_eq!(piecewise_linear(&g, &x), 0, "g[−1] = g[0] = 0");
    }

    proptest! {
        #[test]
        fn f_is_the_piece_of_the_cell_that_x_is_in(g in prop::collection::vec(rational(), 1..6), i in -9i64..=9, u in share()) {
            let g = periodic(&g);
            let [g0, g1] = [i, i + 1].map(|i| g(&Integer::from(i)));
            // At u = 1 it is the next cell's at 0, which is the same.
            prop_assert_eq!(piecewise_linear(&g, &(q(i, 1) + &u)), along(&g0, &g1, &u));
        }
    }
}

mod is_18 {
    use super::*;

    proptest! {
        #[test]
        fn it_is_the_only_function_whose_graph_is_a_segment(g0 in rational(), g1 in rational(), u in share()) {
            // The point (u, f(u)) is on the line through (0, g₀) and (1, g₁), and the only one at u.
            let f = linear(&[g0.clone(), g1.clone()], &u);
            let off = |y: &Rational| determinant(&Matrix([
                [q(0, 1), g0.clone(), q(1, 1)], [q(1, 1), g1.clone(), q(1, 1)], [u.clone(), y.clone(), q(1, 1)],
            ]));
            prop_assert_eq!(off(&f), 0);
            prop_assert_ne!(off(&(f.clone() + 1)), 0);
            prop_assert_eq!(f, along(&g0, &g1, &u));
        }
    }
}

mod is_19 {
    use super::*;

    proptest! {
        #[test]
        fn it_meets_its_ends(g0 in rational(), g1 in rational()) {
            let g = [g0, g1];
            prop_assert_eq!(linear(&g, &q(0, 1)), g[0].clone());
            prop_assert_eq!(linear(&g, &q(1, 1)), g[1].clone());
        }
    }
}

mod is_20 {
    use super::*;

    proptest! {
        #[test]
        fn it_is_the_sum_of_hats(g in prop::collection::vec(rational(), 1..6), x in rational()) {
            // Another basis: f = Σ g[i]·max(0, 1 − |x − i|).
            let g = periodic(&g);
            let hat = |i: i64| (q(1, 1) - (&x - q(i, 1)).abs()).max(q(0, 1));
            let sum = (-32..=32).fold(q(0, 1), |sum, i| sum + g(&Integer::from(i)) * hat(i));
            prop_assert_eq!(piecewise_linear(&g, &x), sum);
        }
    }

    #[test]
    fn at_an_integer_the_next_sample_does_not_count() {
        for next in [-5, 0, 7] {
            let values = rationals([3, next]);
            assert_eq!(piecewise_linear(periodic(&values), &q(0, 1)), 3);
        }
    }
}

/// Every pair of integers up to 6 in size.
fn pairs() -> impl Iterator<Item = [i64; 2]> {
    (-6..=6).flat_map(|a| (-6..=6).map(move |b| [a, b]))
}

mod is_21 {
    use super::*;

    #[test]
    fn between_values_of_one_strict_sign_there_is_no_zero_and_f_keeps_that_sign() {
        for [a, b] in pairs().filter(|[a, b]| a * b > 0) {
            assert_eq!(linear_zero(&rationals([a, b])), LinearZero::None);
            for n in 0..=100 {
                assert_eq!(linear(&rationals([a, b]), &q(n, 100)).cmp0(), a.cmp(&0), "{a} {b}");
            }
        }
    }
}

mod is_22 {
    use super::*;

    #[test]
    fn there_is_one_zero_iff_signs_are_opposite_or_exactly_one_value_is_0() {
        for [a, b] in pairs() {
            // A zero is a/(a − b): a multiple of 1/27720 = 1/lcm(1 … 12). In integers, (n − k)a + kb = 0.
            let zeros = (0..=27720).filter(|k| (27720 - k) * a + k * b == 0).count();
            let one = a * b < 0 || (a == 0) != (b == 0);
            assert_eq!(zeros == 1, one);
            assert_eq!(matches!(linear_zero(&rationals([a, b])), LinearZero::At(_)), one);
        }
    }

    #[test]
    fn two_zero_ends_have_one_of_two_values_zero_and_infinitely_many_zeros() {
        assert_eq!(linear_zero(&rationals([0, 0])), LinearZero::Everywhere);
        assert!((0..=100).all(|n| linear(&rationals([0, 0]), &q(n, 100)) == 0));
    }
}

mod is_23 {
    use super::*;

    proptest! {
        #[test]
        fn the_zero_is_one_and_the_point_planted(u in share(), slope in rational(), c in rational()) {
            // f = slope·(x − u) + c, so that f = c at u.
            prop_assume!(slope != 0);
            let g = [q(0, 1), q(1, 1)].map(|x| &slope * (x - &u) + &c);
            let level = g.each_ref().map(|g| Rational::from(g - &c));
            prop_assert_eq!(linear_zero(&level), LinearZero::At(u.clone()));
            prop_assert_eq!(level[0].clone() / (level[0].clone() - &level[1]), u.clone());
            prop_assert_eq!(linear(&g, &u), c);
        }
    }
}

mod is_24 {
    use super::*;

    #[test]
    fn between_opposite_signs_it_is_inside_and_divides_as_the_values_do() {
        for [a, b] in pairs().filter(|[a, b]| a * b < 0) {
            let LinearZero::At(u) = linear_zero(&rationals([a, b])) else { panic!("{a} {b}") };
            assert!(u > 0 && u < 1);
            assert_eq!(Rational::from(&u * b.abs()), (q(1, 1) - &u) * a.abs());
        }
    }
}

mod is_25 {
    use super::*;

    proptest! {
        #[test]
        fn it_is_linear_interpolation_twice_in_either_order(
            g in prop::array::uniform4(rational()), u in rational(), v in rational()
        ) {
            let [g00, g10, g01, g11] = &g;
            let f = bilinear(&g, &[u.clone(), v.clone()]);
            prop_assert_eq!(&f, &along(&along(g00, g10, &u), &along(g01, g11, &u), &v));
            prop_assert_eq!(&f, &along(&along(g00, g01, &v), &along(g10, g11, &v), &u));
            // And the power basis g00 + (g10 − g00)u + (g01 − g00)v + (g00 − g10 − g01 + g11)uv.
            let uv = Rational::from(g00 - g10) - g01 + g11;
            let power = Rational::from(g10 - g00) * &u + Rational::from(g01 - g00) * &v + uv * &u * &v + g00;
            prop_assert_eq!(f, power);
        }
    }
}

mod is_26 {
    use super::*;

    proptest! {
        #[test]
        fn it_meets_its_corners(g in prop::array::uniform4(rational())) {
            for c in 0..4 {
                prop_assert_eq!(&bilinear(&g, &[q(c as i64 & 1, 1), q(c as i64 >> 1, 1)]), &g[c]);
            }
        }
    }
}

mod is_27 {
    use super::*;

    #[test]
    fn another_quadric_has_the_same_corner_values() {
        let other = |u: &Rational| u * (q(1, 1) - u);
        assert_eq!([0, 1].map(|u| other(&q(u, 1))), [0, 0]);
        let at = [q(1, 2), q(0, 1)];
        assert_eq!(bilinear(&rationals([0, 0, 0, 0]), &at), 0);
        assert_eq!(other(&at[0]), q(1, 4));
    }

    #[test]
    fn six_coefficients_have_four_conditions_and_the_four_of_multilinear_functions_as_many() {
        let quadric: Vec<[usize; 2]> = (0..3).flat_map(|a| (0..3 - a).map(move |b| [a, b])).collect();
        assert_eq!(quadric.len(), 6);
        let row = |c: usize, monomials: &[[usize; 2]]| -> Vec<Rational> {
            monomials.iter().map(|[a, b]| Rational::from(power(c & 1, *a) * power(c >> 1, *b))).collect()
        };
        assert_eq!(rank((0..4).map(|c| row(c, &quadric)).collect()), 4);
        let multilinear = [[0, 0], [1, 0], [0, 1], [1, 1]];
        assert_eq!(determinant::<Rational, 4>(&Matrix::from_fn(|i, j| row(i, &multilinear)[j].clone())), 1);
    }
}

mod is_28 {
    use super::*;

    proptest! {
        #[test]
        fn on_a_line_along_an_axis_it_is_the_linear_interpolant_of_its_ends(
            g in prop::array::uniform4(rational()), a in share(), t in share()
        ) {
            let f = |u: &Rational, v: &Rational| bilinear(&g, &[u.clone(), v.clone()]);
            let [zero, one] = [q(0, 1), q(1, 1)];
            prop_assert_eq!(f(&a, &t), along(&f(&a, &zero), &f(&a, &one), &t));
            prop_assert_eq!(f(&t, &a), along(&f(&zero, &a), &f(&one, &a), &t));
        }
    }

    #[test]
    fn on_other_lines_it_is_not() {
        let [start, middle, end] = [0, 1, 2].map(|n| bilinear(&rationals([0, 0, 0, 1]), &[q(n, 2), q(n, 2)]));
        assert_eq!([&start, &middle, &end], [&q(0, 1), &q(1, 4), &q(1, 1)]);
        assert_ne!(middle, along(&start, &end, &q(1, 2)));
    }
}

mod is_29 {
    use super::*;

    proptest! {
        #[test]
        fn neighbours_agree_on_their_common_edge(g in prop::array::uniform6(rational()), t in share()) {
            // Samples (i, j), i = 0, 1, j = 0, 1, 2.
            let cell = |j: usize| [0, 1, 2, 3].map(|c| g[2 * j + c].clone());
            let edge = along(&g[2], &g[3], &t);
            prop_assert_eq!(bilinear(&cell(0), &[t.clone(), q(1, 1)]), edge.clone());
            prop_assert_eq!(bilinear(&cell(1), &[t, q(0, 1)]), edge);
        }
    }

    #[test]
    fn their_gradients_need_not() {
        let (low, high) = (rationals([0, 0, 0, 0]), rationals([0, 0, 1, 1]));
        let at = q(1, 2);
        assert_eq!(bilinear_gradient(&low, &[at.clone(), q(1, 1)]), [0, 0]);
        assert_eq!(bilinear_gradient(&high, &[at, q(0, 1)]), [0, 1]);
    }
}

mod is_30 {
    use super::*;

    #[test]
    fn on_the_edges_of_a_cell_the_zeros_are_those_of_eq_22() {
        for n in 0..3i64.pow(8) {
            let g: [i64; 8] = std::array::from_fn(|c| [-2, 1, 5][(n / 3i64.pow(c as u32) % 3) as usize]);
            for (axis, at) in (0..3).flat_map(|axis| (0..4usize).map(move |at| (axis, at))) {
                let [a, b] = [[1, 2], [0, 2], [0, 1]][axis];
                let low = (at & 1) << a | (at >> 1) << b;
                let [g0, g1] = [g[low], g[low | 1 << axis]];
                let zero = zero_on_line(&rationals(g), axis, &[q(at as i64 & 1, 1), q(at as i64 >> 1, 1)]);
                let expected = if g0 * g1 < 0 { LinearZero::At(q(g0, g0 - g1)) } else { LinearZero::None };
                assert_eq!(zero, expected, "{g:?} along {axis} at {at}");
            }
        }
    }
}

mod is_31 {
    use super::*;

    proptest! {
        #[test]
        fn it_is_the_bilinear_functions_of_two_faces_interpolated_and_meets_its_corners(
            g in prop::array::uniform8(rational()), p in prop::array::uniform3(rational())
        ) {
            let face = |w: usize| bilinear(&[0, 1, 2, 3].map(|c| g[4 * w + c].clone()), &[p[0].clone(), p[1].clone()]);
            prop_assert_eq!(trilinear(&g, &p), along(&face(0), &face(1), &p[2]));
            for c in 0..8i64 {
                prop_assert_eq!(&trilinear(&g, &[c & 1, c >> 1 & 1, c >> 2].map(Rational::from)), &g[c as usize]);
            }
        }
    }
}

mod is_32 {
    use super::*;

    #[test]
    fn another_cubic_has_the_same_corner_values() {
        let other = |[u, _, _]: &[Rational; 3]| u * (q(1, 1) - u);
        for c in 0..8i64 {
            assert_eq!(other(&[c & 1, c >> 1 & 1, c >> 2].map(Rational::from)), 0);
        }
        let at = [q(1, 2), q(0, 1), q(0, 1)];
        assert_eq!(trilinear(&rationals([0; 8]), &at), 0);
        assert_eq!(other(&at), q(1, 4));
    }

    #[test]
    fn twenty_coefficients_have_eight_independent_conditions_and_the_eight_multilinear_ones_are_fixed() {
        let cubic: Vec<[usize; 3]> =
            (0..64).map(|n| [n % 4, n / 4 % 4, n / 16]).filter(|m| m.iter().sum::<usize>() <= 3).collect();
        assert_eq!(cubic.len(), 20);
        let value =
            |c: usize, m: &[usize; 3]| Rational::from((0..3).map(|i| power(c >> i & 1, m[i])).product::<usize>());
        assert_eq!(rank((0..8).map(|c| cubic.iter().map(|m| value(c, m)).collect()).collect()), 8);
        let multilinear = |i: usize, j: usize| value(i, &[j & 1, j >> 1 & 1, j >> 2]);
        assert_eq!(determinant::<Rational, 8>(&Matrix::from_fn(multilinear)), 1);
    }
}

mod is_33 {
    use super::*;

    proptest! {
        #[test]
        fn on_a_plane_along_two_axes_it_is_bilinear_and_on_a_line_along_one_linear(
            g in prop::array::uniform8(rational()), height in share(), p in prop::array::uniform2(share()), axis in 0usize..3
        ) {
            let [a, b] = [[1, 2], [0, 2], [0, 1]][axis];
            let at = |s: &Rational, t: &Rational, h: &Rational| {
                let mut point = [q(0, 1), q(0, 1), q(0, 1)];
                (point[a], point[b], point[axis]) = (s.clone(), t.clone(), h.clone());
                trilinear(&g, &point)
            };
            let ends = [q(0, 1), q(1, 1)];
            let plane = [0, 1, 2, 3].map(|c| at(&ends[c & 1], &ends[c >> 1], &height));
            prop_assert_eq!(bilinear(&plane, &p), at(&p[0], &p[1], &height));
            let line = on_line(&g, axis, &p);
            prop_assert_eq!(&line, &ends.each_ref().map(|h| at(&p[0], &p[1], h)));
            prop_assert_eq!(linear(&line, &height), at(&p[0], &p[1], &height));
        }
    }

    #[test]
    fn on_a_plane_along_one_axis_only_it_is_not() {
        // f = uv on u = v, which is parallel to the w axis.
        let g = rationals([0, 0, 0, 1, 0, 0, 0, 1]);
        let values = [0, 1, 2].map(|n| trilinear(&g, &[q(n, 2), q(n, 2), q(1, 3)]));
        assert_eq!(values, [q(0, 1), q(1, 4), q(1, 1)]);
        assert_ne!(values[1], along(&values[0], &values[2], &q(1, 2)));
    }
}

mod is_34 {
    use super::*;

    proptest! {
        #[test]
        fn neighbouring_cells_agree_on_their_common_face(
            g in prop::collection::vec(rational(), 12), p in prop::array::uniform2(share()), axis in 0usize..3
        ) {
            // Three layers of four samples along the axis.
            let [a, b] = [[1, 2], [0, 2], [0, 1]][axis];
            let cell = |layer: usize| -> [Rational; 8] {
                std::array::from_fn(|c| g[4 * (layer + (c >> axis & 1)) + (c >> a & 1) + 2 * (c >> b & 1)].clone())
            };
            let at = |h: i64| {
                let mut point = [q(h, 1), q(h, 1), q(h, 1)];
                (point[a], point[b]) = (p[0].clone(), p[1].clone());
                point
            };
            prop_assert_eq!(trilinear(&cell(0), &at(1)), trilinear(&cell(1), &at(0)));
        }

        #[test]
        fn in_a_cell_it_is_a_polynomial_of_degree_1_in_each_variable(
            g in prop::array::uniform8(rational()), p in prop::array::uniform3(rational()), h in 1i64..5, axis in 0usize..3
        ) {
            // Its second differences vanish, so all derivatives exist.
            let values = [0, 1, 2].map(|n| {
                let mut point = p.clone();
                point[axis] += n * h;
                trilinear(&g, &point)
            });
            prop_assert_eq!(Rational::from(&values[0] + &values[2]), values[1].clone() * 2);
        }
    }
}

mod is_35 {
    use super::*;
    use isoracle::isosurface::cell::Tie;
    use isoracle::isosurface::polyline::{Raster, squares};

    /// Nothing is claimed; that arbitrary signals are drawn is what the exercise asks for.
    #[test]
    fn curves_of_arbitrary_signals_are_drawn() {
        let points = (-6..=6).flat_map(|y| (-6..=6).map(move |x| (x, y)));
        let samples = points.map(|(x, y)| Rational::from(x * x + 2 * y * y - 20)).collect();
        let raster = Raster::new([13, 13], samples).expect("13 × 13 samples");
        let ellipse = squares(&raster, &q(1, 7), Tie::Degenerate).expect("1/7 is no critical value");
        assert!(ellipse.vertices.len() > 12);
        assert_eq!(ellipse.vertices.len(), ellipse.segments.len(), "closed");
        for [x, y] in &ellipse.vertices {
            // A chord of a convex parabola is above it by at most 1/4 of its second coefficient.
            let exact = Rational::from(x - 6).square() + Rational::from(y - 6).square() * 2 - 20;
            assert!(exact <= q(1, 7) && exact >= q(1, 7) - q(1, 2), "({x}, {y}): {exact}");
        }
    }
}
