//! The exact fast twin, and solving by axes.

use super::{RULES, boundary, number, q, signal};
use isoracle::number::{Integer, Rational};
use isoracle::spline::inverse::solve as solve_by_inverse;
use isoracle::spline::prefilter::{self, interpolate};
use isoracle::spline::prefilter_fast_exact::{self as fast, IntegerSpline};
use isoracle::spline::signal::{Boundary, Signal};
use isoracle::spline::tensor::Spline;
use proptest::prelude::*;

fn cases() -> ProptestConfig {
    ProptestConfig::with_cases(if std::env::var_os("ISORACLE_LONG").is_some() { 512 } else { 64 })
}

/// Any real point: at samples, between, and beyond.
fn point<const N: usize>() -> impl Strategy<Value = [Rational; N]> {
    let coordinate = prop_oneof![
        2 => (-20..20_i64).prop_map(|n| q(n, 1)),
        2 => (-90..90_i64, 1..9_i64).prop_map(|(n, d)| q(n, d)),
        1 => (any::<i64>(), 1..i64::MAX).prop_map(|(n, d)| q(n, d)),
        1 => any::<i64>().prop_map(|n| q(n, 1) + Rational::from((Integer::from(1), Integer::from(1) << 90))),
    ];
    prop::collection::vec(coordinate, N).prop_map(|at| at.try_into().expect("N of them"))
}

mod sp_51 {
    use super::*;

    /// Solves along the axes in the order given.
    fn by_axes(signal: &Signal<3>, axes: [usize; 3]) -> Vec<Rational> {
        let (shape, mut values) = (signal.shape(), signal.values().to_vec());
        for axis in axes {
            let stride: usize = shape[..axis].iter().product();
            for first in (0..values.len()).filter(|i| (i / stride).is_multiple_of(shape[axis])) {
                let line: Vec<Rational> = (0..shape[axis]).map(|k| values[first + k * stride].clone()).collect();
                for (k, c) in solve_by_inverse(&line, signal.boundary()).expect("long enough").into_iter().enumerate() {
                    values[first + k * stride] = c;
                }
            }
        }
        values
    }

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn the_axes_may_be_solved_in_any_order(
            shape in prop::array::uniform3(2..5_usize), numbers in prop::collection::vec(number(), 64), boundary in boundary(),
        ) {
            let signal = signal(shape, &numbers, boundary);
            let c = interpolate(&signal);
            for axes in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                prop_assert_eq!(by_axes(&signal, axes), c.coefficients().values());
            }
        }
    }
}

mod sp_72 {
    use super::*;

    #[test]
    fn every_side_from_2_to_20() {
        for boundary in RULES {
            for n in 2..=20 {
                let values: Vec<Rational> =
                    (0..n).map(|k| q((k as i64 * 53 + 7) % 23 - 11, 1 + k as i64 % 5)).collect();
                let signal = signal([n], &values, boundary);
                assert_eq!(fast::interpolate(&signal), interpolate(&signal), "{boundary:?} {n}");
            }
        }
    }

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn it_is_the_plain_one_in_1_to_3_dimensions(
            shape in prop::array::uniform3(2..6_usize), numbers in prop::collection::vec(number(), 125), boundary in boundary(),
        ) {
            let three = signal(shape, &numbers, boundary);
            prop_assert_eq!(fast::interpolate(&three), interpolate(&three));
            let two = signal([shape[0], shape[1]], &numbers, boundary);
            prop_assert_eq!(fast::interpolate(&two), interpolate(&two));
            let one = signal([shape[0]], &numbers, boundary);
            prop_assert_eq!(fast::interpolate(&one), interpolate(&one));
        }

        #[test]
        fn derivatives_and_jets_are_the_plain_ones(
            shape in prop::array::uniform3(2..6_usize), numbers in prop::collection::vec(number(), 125), boundary in boundary(),
            at in point::<3>(),
        ) {
            let signal = signal(shape, &numbers, boundary);
            let (plain, fast) = (interpolate(&signal), IntegerSpline::interpolate(&signal));
            prop_assert_eq!(plain.jet(&at), fast.jet(&at));
            prop_assert_eq!(plain.derivative(&at, [2, 1, 2]), fast.derivative(&at, [2, 1, 2]));
            let given = IntegerSpline::new(plain.coefficients());
            prop_assert_eq!(given.value(&at), plain.value(&at));
            prop_assert_eq!(given.spline(), plain);
        }
    }

    #[test]
    fn huge_and_tiny_binary64_are_exact() {
        let values = [f64::MAX, 5e-324, -0.0, 1.0, -f64::MAX, 0.1];
        for boundary in RULES {
            let signal = Signal::of_f64s([3, 2], &values, boundary).expect("finite");
            let spline = fast::interpolate(&signal);
            assert_eq!(spline, interpolate(&signal));
            assert_eq!(spline.value(&[q(1, 1), q(0, 1)]), Rational::from_f64(5e-324).expect("finite"));
        }
    }

    /// A volume of side n, checked at its samples and against the plain solution of some lines' sums.
    fn cube(n: usize) {
        let values: Vec<Rational> =
            (0..n * n * n).map(|m| q((m as i64 * m as i64 * 7919 + 13) % 511 - 255, 1)).collect();
        let signal = signal([n; 3], &values, Boundary::Mirror);
        let spline = IntegerSpline::interpolate(&signal);
        for m in (0..n * n * n).step_by(n * n * n / 97) {
            let at = [m % n, m / n % n, m / n / n].map(Rational::from);
            assert_eq!(spline.value(&at), values[m]);
        }
        // The solution is linear: a line of sums over planes has the sums of coefficients, up to the weights of mirrored sums.
        let coefficients = spline.spline();
        let along = |values: &[Rational]| -> Vec<Rational> {
            let weight = |k: usize| if k == 0 || k == n - 1 { 1 } else { 2 };
            let plane = |z: usize| {
                (0..n * n).fold(Rational::new(), |sum, i| {
                    sum + Rational::from(&values[z * n * n + i] * (weight(i % n) * weight(i / n)))
                })
            };
            (0..n).map(plane).collect()
        };
        assert_eq!(prefilter::solve(&along(&values), Boundary::Mirror), along(coefficients.coefficients().values()));
    }

    #[test]
    fn a_volume_of_side_9() {
        cube(9);
    }

    #[test]
    fn a_volume_of_side_64() {
        if std::env::var_os("ISORACLE_LONG").is_some() {
            cube(64);
        }
    }
}

mod sp_77 {
    use super::*;

    proptest! {
        #![proptest_config(cases())]
        #[test]
        fn many_points_one_after_the_other(
            numbers in prop::collection::vec(number(), 20), boundary in boundary(),
            points in prop::collection::vec(point::<2>(), 0..12),
        ) {
            let plain: Spline<2> = interpolate(&signal([4, 5], &numbers, boundary));
            let fast = IntegerSpline::new(plain.coefficients());
            prop_assert_eq!(fast.values(&points), points.iter().map(|at| plain.value(at)).collect::<Vec<_>>());
            prop_assert_eq!(fast.jets(&points), points.iter().map(|at| plain.jet(at)).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_point_far_away_is_folded() {
        let signal = signal([3, 4], &(0..12).map(|n| q(n * n % 7, 1)).collect::<Vec<_>>(), Boundary::Mirror);
        let spline = IntegerSpline::interpolate(&signal);
        // The periods are 4 and 6.
        let far = Rational::from(Integer::from(12) << 200);
        assert_eq!(spline.value(&[Rational::from(&far + 1), Rational::from(&far - 2)]), signal.values()[1 + 3 * 2]);
    }
}
