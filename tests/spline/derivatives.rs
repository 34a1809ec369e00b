//! Derivatives of splines, and the three-dimensional case.

use super::{boundary, few, number, q, signal};
use isoracle::number::{Integer, Rational};
use isoracle::spline::basis::weights;
use isoracle::spline::bspline::{b1, b3, b3_first, b3_second, basis};
use isoracle::spline::partial;
use isoracle::spline::prefilter::interpolate;
use isoracle::spline::signal::Boundary;
use isoracle::spline::space::combination;
use isoracle::spline::tensor::Spline;
use proptest::prelude::*;

/// The spline in one variable whose coefficients are 0 but near 0; periodic, and 40 long.
fn line(c: &std::collections::BTreeMap<Integer, Rational>) -> Spline<1> {
    let mut values = vec![Rational::new(); 40];
    for (k, c) in c {
        values[(k.to_i64().expect("near") + 20) as usize] = c.clone();
    }
    Spline::new(signal([40], &values, Boundary::Periodic))
}

/// Where the line has x.
fn on_line(x: &Rational) -> [Rational; 1] {
    [Rational::from(x + 20)]
}

mod sp_40 {
    use super::*;

    proptest! {
        #[test]
        fn derivatives_go_through_the_sum(c in few(), n in -70..70_i64) {
            let (x, f) = (q(n, 8), combination(&c, 3));
            let sum = |b: fn(&Rational) -> Rational| {
                c.iter().fold(Rational::new(), |sum, (k, c)| sum + c * b(&Rational::from(&x - k)))
            };
            let derivatives = [f.clone(), f.derivative(), f.derivative().derivative()].map(|f| f.evaluate(&x));
            prop_assert_eq!(&derivatives, &[sum(b3), sum(b3_first), sum(b3_second)]);
            let spline = line(&c);
            prop_assert_eq!(derivatives, [0, 1, 2].map(|n| spline.derivative(&on_line(&x), [n])));
        }
    }
}

mod sp_41 {
    use super::*;

    #[test]
    fn eq_13_is_the_derivative_of_eq_11() {
        let first = basis(3).derivative();
        for n in -48..=48 {
            assert_eq!(b3_first(&q(n, 16)), first.evaluate(&q(n, 16)), "{n}/16");
        }
        // By values alone: for a cubic, 12s·f′ = 8(f(s) − f(−s)) − (f(2s) − f(−2s)), inside of a piece.
        for n in [-25, -13, -9, 3, 7, 21_i64] {
            let f = |step: i64| b3(&q(4 * n + step, 64));
            assert_eq!((f(1) - f(-1)) * 8 - (f(2) - f(-2)), b3_first(&q(4 * n, 64)) * 12 / 64);
        }
    }

    #[test]
    fn its_pieces_meet_at_the_knots() {
        let values = [q(0, 1), q(1, 2), q(0, 1), q(-1, 2), q(0, 1)];
        assert_eq!(values.to_vec(), (-2..=2).map(|k| b3_first(&q(k, 1))).collect::<Vec<_>>());
        // What the piece on the right of each knot says there.
        let right = [q(2, 1) - 4 + 2, q(-3, 2) + 2, q(0, 1), q(-1, 2) + 2 - 2, q(0, 1)];
        assert_eq!(values, right);
    }

    #[test]
    fn the_lines_with_weights_agree() {
        for n in 0..8 {
            let four: Vec<Rational> = (-1..=2).map(|k| b3_first(&(q(n, 8) - k))).collect();
            assert_eq!(weights(&q(n, 8), 1).to_vec(), four);
        }
    }
}

mod sp_42 {
    use super::*;

    #[test]
    fn eq_14_is_the_derivative_of_eq_13() {
        let second = basis(3).derivative().derivative();
        for n in -48..=48 {
            assert_eq!(b3_second(&q(n, 16)), second.evaluate(&q(n, 16)), "{n}/16");
        }
        // For a quadratic, f(s) − f(−s) = 2s·f′.
        for n in [-25, -13, -9, 3, 7, 21_i64] {
            let f = |step: i64| b3_first(&q(4 * n + step, 64));
            assert_eq!(f(1) - f(-1), b3_second(&q(4 * n, 64)) / 32);
        }
    }

    #[test]
    fn its_pieces_meet_at_the_knots() {
        let values = [0, 1, -2, 1, 0].map(|n| q(n, 1));
        assert_eq!(values.to_vec(), (-2..=2).map(|k| b3_second(&q(k, 1))).collect::<Vec<_>>());
        let right = [q(-2, 1) + 2, q(3, 1) - 2, q(-2, 1), q(-1, 1) + 2, q(0, 1)];
        assert_eq!(values, right);
    }

    #[test]
    fn the_lines_with_weights_agree() {
        for n in 0..8 {
            let four: Vec<Rational> = (-1..=2).map(|k| b3_second(&(q(n, 8) - k))).collect();
            assert_eq!(weights(&q(n, 8), 2).to_vec(), four);
        }
    }
}

mod sp_43 {
    use super::*;

    #[test]
    fn the_third_derivative_jumps_at_each_knot() {
        let third = basis(3).derivative().derivative().derivative();
        let jumps: Vec<Rational> =
            (-2..=2).map(|k| third.evaluate(&q(2 * k + 1, 2)) - third.evaluate(&q(2 * k - 1, 2))).collect();
        assert_eq!(jumps, [1, -4, 6, -4, 1].map(|n| q(n, 1)));
        assert!(std::panic::catch_unwind(|| weights(&q(1, 2), 3)).is_err());
    }
}

mod sp_44 {
    use super::*;

    #[test]
    fn the_derivative_is_a_difference_of_quadratic_b_splines() {
        let difference = basis(2).shifted(&q(-1, 2)) - &basis(2).shifted(&q(1, 2));
        assert_eq!(basis(3).derivative(), difference);
        for n in -24..=24 {
            assert_eq!(b3_first(&q(n, 8)), difference.evaluate(&q(n, 8)));
        }
        for n in 1..=7 {
            let lower = basis(n - 1);
            assert_eq!(basis(n).derivative(), lower.shifted(&q(-1, 2)) - &lower.shifted(&q(1, 2)));
        }
    }
}

mod sp_45 {
    use super::*;

    #[test]
    fn the_second_derivative_is_a_second_difference_of_hats() {
        for n in -24..=24 {
            let x = q(n, 8);
            let hats = b1(&Rational::from(&x + 1)) - b1(&x) * 2 + b1(&Rational::from(&x - 1));
            assert_eq!(b3_second(&x), hats);
        }
    }
}

mod sp_46 {
    use super::*;

    proptest! {
        #[test]
        fn derivatives_at_the_samples(c in few(), k in -6..6_i64) {
            let spline = line(&c);
            let c = |k: i64| super::super::at(&c, &Integer::from(k));
            let at = on_line(&q(k, 1));
            prop_assert_eq!(spline.derivative(&at, [1]), (c(k + 1) - c(k - 1)) / 2);
            prop_assert_eq!(spline.derivative(&at, [2]), c(k - 1) - c(k) * 2 + c(k + 1));
        }
    }
}

mod sp_47 {
    use super::*;

    #[test]
    fn what_graphs_of_the_derivatives_show() {
        // B₃′ is odd, B₃″ even; B₃′ has its greatest value 2/3 at −2/3, a root of B₃″.
        for n in -48..=48 {
            let (x, minus) = (q(n, 16), q(-n, 16));
            assert_eq!((b3_first(&minus), b3_second(&minus)), (-b3_first(&x), b3_second(&x)));
            assert!(b3_first(&x) <= q(2, 3) && b3_second(&x) <= 1 && b3_second(&x) >= -2);
        }
        assert_eq!((b3_first(&q(-2, 3)), b3_second(&q(-2, 3))), (q(2, 3), q(0, 1)));
    }
}

/// x² + y² − z² near 0, as a spline: the coefficients i² + j² − k² − 1/3, for Σ k²B₃(x − k) = x² + 1/3.
fn cone() -> Spline<3> {
    let square = |k: usize| (k * k) as i64;
    let value = |m: usize| q(square(m % 4) + square(m / 4 % 4) - square(m / 16), 1) - q(1, 3);
    Spline::new(signal([4; 3], &(0..64).map(value).collect::<Vec<_>>(), Boundary::Mirror))
}

mod sp_48 {
    use super::*;

    #[test]
    fn a_spline_of_class_c2_whose_level_has_a_point_without_a_tangent_plane() {
        let f = cone();
        for n in 0..8_i64 {
            let [x, y, z] = [q(n - 3, 8), q(2 * n - 7, 8), q(5 - n, 8)];
            let squares = [&x, &y, &z].map(|x| Rational::from(x.square_ref()));
            assert_eq!(f.value(&[x, y, z]), Rational::from(&squares[0] + &squares[1]) - &squares[2]);
        }
        let origin = [0, 0, 0].map(Rational::from);
        assert_eq!(f.value(&origin), 0);
        assert!(!f.is_regular(&origin));
        // The level holds the lines (s, 0, ±s) and (0, s, ±s), whose directions span the space: no plane is tangent.
        for s in [q(-1, 2), q(1, 3), q(3, 4)] {
            for t in [s.clone(), Rational::from(-&s)] {
                assert_eq!(f.value(&[s.clone(), q(0, 1), t.clone()]), 0);
                assert_eq!(f.value(&[q(0, 1), s.clone(), t.clone()]), 0);
                assert!(f.is_regular(&[s.clone(), q(0, 1), t]));
            }
        }
    }
}

mod sp_49 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        /// At a knot the derivatives are those of the pieces on both sides: extrapolated from five values each.
        #[test]
        fn derivatives_are_continuous_across_the_grid(
            numbers in prop::collection::vec(number(), 27), k in prop::array::uniform3(-3..4_i64), axis in 0..3_usize,
        ) {
            let spline = Spline::new(signal([3; 3], &numbers, Boundary::Mirror));
            let [x, y, z] = k.map(|k| q(8 * k + 3, 8));
            for order in 0..3_u32 {
                let on = |n: i64| {
                    let mut at = [x.clone(), y.clone(), z.clone()];
                    at[axis] = q(k[axis], 1) + q(n, 8);
                    let mut orders = [0; 3];
                    orders[axis] = order;
                    spline.derivative(&at, orders)
                };
                // A cubic from four equal steps: p(0) = 4p(1) − 6p(2) + 4p(3) − p(4).
                let from = |side: i64| on(side) * 4 - on(2 * side) * 6 + on(3 * side) * 4 - on(4 * side);
                prop_assert_eq!(from(1), on(0));
                prop_assert_eq!(from(-1), on(0));
            }
        }
    }
}

/// Sums of 64 terms, hundreds of them a case.
fn cases() -> ProptestConfig {
    ProptestConfig::with_cases(if std::env::var_os("ISORACLE_LONG").is_some() { 256 } else { 16 })
}

fn volume() -> impl Strategy<Value = (Spline<3>, [Rational; 3])> {
    let at = prop::array::uniform3((-30..30_i64, prop::sample::select(vec![1, 2, 8, 3])).prop_map(|(n, d)| q(n, d)));
    (prop::collection::vec(number(), 24), boundary(), at)
        .prop_map(|(values, boundary, at)| (Spline::new(signal([2, 3, 4], &values, boundary)), at))
}

/// ∂f along an axis, from values of f on the piece that has `at` on its left or inside: exact for a cubic.
fn differentiated(f: &dyn Fn(&[Rational; 3]) -> Rational, at: &[Rational; 3], axis: usize) -> Rational {
    // The cubic on [⌊x⌋, ⌊x⌋ + 1] through 0, 1/3, 2/3, 1, by Lagrange's formula for its derivative at t.
    let floor = at[axis].clone().floor();
    let t = Rational::from(&at[axis] - &floor);
    let nodes = [q(0, 1), q(1, 3), q(2, 3), q(1, 1)];
    let mut sum = Rational::new();
    for (i, node) in nodes.iter().enumerate() {
        let others: Vec<&Rational> = nodes.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, node)| node).collect();
        let mut place = at.clone();
        place[axis] = Rational::from(&floor + node);
        let scale = others.iter().fold(q(1, 1), |product, other| product * Rational::from(node - *other));
        let [a, b, c] = [0, 1, 2].map(|i| Rational::from(&t - others[i]));
        let slope = Rational::from(&a * &b) + Rational::from(&b * &c) + Rational::from(&a * &c);
        sum += f(&place) * slope / scale;
    }
    sum
}

/// One partial derivative: the sum, the orders, and the axes along which values are differentiated.
fn is_the_derivative(
    sum: fn(&Spline<3>, &[Rational; 3]) -> Rational,
    axes: &[usize],
    (spline, at): &(Spline<3>, [Rational; 3]),
) -> Result<(), TestCaseError> {
    let orders = std::array::from_fn(|axis| axes.iter().filter(|a| **a == axis).count() as u32);
    prop_assert_eq!(sum(spline, at), spline.derivative(at, orders));
    let value = |at: &[Rational; 3]| partial::f(spline, at);
    let first = |at: &[Rational; 3]| differentiated(&value, at, axes[0]);
    let by_values = if axes.len() == 1 { first(at) } else { differentiated(&first, at, axes[1]) };
    prop_assert_eq!(sum(spline, at), by_values);
    Ok(())
}

mod sp_52 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn the_sum_is_the_tensor_product((spline, at) in volume()) {
            prop_assert_eq!(partial::f(&spline, &at), spline.value(&at));
        }
    }

    #[test]
    fn the_terms_that_are_left_out_are_0() {
        let values: Vec<Rational> = (0..27).map(|n| q(n * n % 11 - 5, 1)).collect();
        let spline = Spline::new(signal([3; 3], &values, Boundary::Periodic));
        let at = [q(1, 2), q(-3, 1), q(7, 4)];
        let mut sum = Rational::new();
        for i in -4..=5_i64 {
            for j in -7..=2_i64 {
                for k in -3..=6_i64 {
                    let product = b3(&(at[0].clone() - i)) * b3(&(at[1].clone() - j)) * b3(&(at[2].clone() - k));
                    sum += product * spline.coefficients().sample(&[i, j, k].map(Integer::from));
                }
            }
        }
        assert_eq!(partial::f(&spline, &at), sum);
    }
}

mod sp_53 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fx_is_the_sum(case in volume()) {
            is_the_derivative(partial::fx, &[0], &case)?;
        }
    }
}

mod sp_54 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fy_is_the_sum(case in volume()) {
            is_the_derivative(partial::fy, &[1], &case)?;
        }
    }
}

mod sp_55 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fz_is_the_sum(case in volume()) {
            is_the_derivative(partial::fz, &[2], &case)?;
        }
    }
}

mod sp_56 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fxx_is_the_sum(case in volume()) {
            is_the_derivative(partial::fxx, &[0, 0], &case)?;
        }
    }
}

mod sp_57 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fxy_is_the_sum(case in volume()) {
            is_the_derivative(partial::fxy, &[0, 1], &case)?;
        }
    }
}

mod sp_58 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fxz_is_the_sum(case in volume()) {
            is_the_derivative(partial::fxz, &[0, 2], &case)?;
        }
    }
}

mod sp_59 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fyy_is_the_sum(case in volume()) {
            is_the_derivative(partial::fyy, &[1, 1], &case)?;
        }
    }
}

mod sp_60 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fyz_is_the_sum(case in volume()) {
            is_the_derivative(partial::fyz, &[1, 2], &case)?;
        }
    }
}

mod sp_61 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn fzz_is_the_sum(case in volume()) {
            is_the_derivative(partial::fzz, &[2, 2], &case)?;
        }
    }
}

mod sp_62 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn mixed_derivatives_do_not_depend_on_the_order((spline, at) in volume()) {
            let value = |at: &[Rational; 3]| partial::f(&spline, at);
            for (i, j) in [(0, 1), (0, 2), (1, 2)] {
                let along = |first: usize, second: usize| {
                    differentiated(&|at: &[Rational; 3]| differentiated(&value, at, first), &at, second)
                };
                prop_assert_eq!(along(i, j), along(j, i));
                prop_assert_eq!(&along(j, i), &spline.jet(&at).hessian.0[i][j]);
            }
            let hessian = spline.jet(&at).hessian;
            prop_assert_eq!(hessian.transposed(), hessian);
        }
    }
}

mod sp_63 {
    use super::*;

    /// The coefficients, and the samples, that are 1 at the middle of 7 by 7.
    fn middle() -> Vec<Rational> {
        (0..49).map(|m| q(i64::from(m == 24), 1)).collect()
    }

    #[test]
    fn the_figure_shows_the_b_spline_and_not_the_interpolant_of_an_impulse() {
        let shown = Spline::new(signal([7, 7], &middle(), Boundary::Mirror));
        let interpolant = interpolate(&signal([7, 7], &middle(), Boundary::Mirror));
        let at = [q(3, 1), q(3, 1)];
        assert_eq!((shown.value(&at), interpolant.value(&at)), (q(4, 9), q(1, 1)));
        for m in 0..81_i64 {
            let (x, y) = (q(m % 9 - 4, 2), q(m / 9 - 4, 2));
            let at = [Rational::from(&x + 3), Rational::from(&y + 3)];
            let panels = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]].map(|orders| shown.derivative(&at, orders));
            let b = [b3, b3_first, b3_second];
            let product = |m: usize, n: usize| b[m](&x) * b[n](&y);
            let products = [product(0, 0), product(1, 0), product(0, 1), product(2, 0), product(1, 1), product(0, 2)];
            assert_eq!(panels, products);
        }
    }
}
