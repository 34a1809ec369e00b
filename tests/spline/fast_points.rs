//! Values, derivatives and curvatures of certified volumes, against the plain spline.

use super::q;
use isoracle::curvature::implicit_surface::{LevelSurface, curvature};
use isoracle::curvature::jet::Jet;
use isoracle::number::binary::{from_f64, nearest_f64};
use isoracle::number::{Rational, Sign};
use isoracle::spline::prefilter::fast::{Enclosed, JetError, LevelSurface64};
use isoracle::spline::prefilter::interpolate;
use isoracle::spline::signal::{Boundary, Signal};
use isoracle::spline::tensor::Spline;
use proptest::prelude::*;

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

const BOTH: [Boundary; 2] = [Boundary::Mirror, Boundary::Periodic];

fn spline<const N: usize>(samples: &[f64], shape: [usize; N], boundary: Boundary) -> Spline<N> {
    let exact = samples.iter().map(|g| from_f64(*g).expect("finite")).collect();
    interpolate(&Signal::new(shape, exact, boundary).expect("the shape fits"))
}

fn assert_nearest(x: f64, exact: &Rational, what: &str) {
    assert_eq!(x.to_bits(), nearest_f64(exact).to_bits(), "{what}: {x}");
}

fn assert_jet<const N: usize>(jet: &Jet<f64, N>, exact: &Jet<Rational, N>) {
    assert_nearest(jet.value, &exact.value, "f");
    for i in 0..N {
        assert_nearest(jet.gradient[i], &exact.gradient[i], "∇f");
        for j in 0..N {
            assert_nearest(jet.hessian.0[i][j], &exact.hessian.0[i][j], "Hess f");
        }
    }
}

/// Whether x is nearest to sign·√square, by squares of the numbers half-way to its neighbours.
fn is_nearest_root(x: f64, sign: Sign, square: &Rational) -> bool {
    if sign == Sign::Zero {
        return x.to_bits() == 0;
    }
    let magnitude = x * f64::from(sign.value());
    let middle = |y: f64| (from_f64(magnitude).expect("finite") + from_f64(y).expect("finite")) / 2_u32;
    let (below, above) = (middle(magnitude.next_down()).square(), middle(magnitude.next_up()).square());
    let is_even = x.to_bits() & 1 == 0;
    magnitude > 0.0 && (below < *square && *square < above || is_even && (below == *square || *square == above))
}

/// K by the rational, H by squares, k₁ and k₂ by enclosures of 2000 bits.
fn assert_surface(found: &LevelSurface64, exact: &LevelSurface) {
    assert_nearest(found.gaussian, &exact.gaussian, "K");
    assert!(is_nearest_root(found.mean, exact.mean_sign, &exact.mean_squared), "H: {}", found.mean);
    let enclosures = exact.principal().enclosure(2000);
    for (x, k) in found.principal.iter().zip(&enclosures) {
        let (lo, hi) = k.bounds().expect("bounded");
        if exact.gaussian == 0 && lo <= 0 && hi >= 0 {
            assert_eq!(x.to_bits(), 0);
        } else {
            assert!(nearest_f64(&lo) == *x || nearest_f64(&hi) == *x, "k: {x}");
            assert!(
                nearest_f64(&lo).to_bits() == nearest_f64(&hi).to_bits() || Rational::from(&hi - &lo) << 900_u32 < 1
            );
        }
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![3 => -1.0..1.0_f64, 2 => (-4..4_i32).prop_map(f64::from), 1 => (-300..300_i32).prop_map(|e| 2_f64.powi(e)), 1 => Just(0.0)]
}

fn coordinate() -> impl Strategy<Value = Rational> {
    prop_oneof![
        (-30..30_i64, 1..9_i64).prop_map(|(n, d)| q(n, d)),
        (-3.0..9.0_f64).prop_map(|x| from_f64(x).expect("finite")),
    ]
}

mod sp_83 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if is_long() { 500 } else { 24 }))]
        #[test]
        fn jets_are_rounded(
            numbers in prop::collection::vec(number(), 48), mirror in any::<bool>(),
            points in prop::collection::vec(prop::array::uniform3(coordinate()), 3),
        ) {
            let boundary = if mirror { Boundary::Mirror } else { Boundary::Periodic };
            let (volume, plain) = (Enclosed::new(&numbers, [4, 3, 4], boundary).expect("sound"), spline(&numbers, [4, 3, 4], boundary));
            for (jet, x) in volume.jets(&points).iter().zip(&points) {
                assert_jet(jet.as_ref().expect("finite"), &plain.jet(x));
            }
            let (plane, plain) = (Enclosed::new(&numbers, [6, 8], boundary).expect("sound"), spline(&numbers, [6, 8], boundary));
            let points: Vec<[Rational; 2]> = points.into_iter().map(|[x, y, _]| [x, y]).collect();
            for (jet, x) in plane.jets(&points).iter().zip(&points) {
                assert_jet(jet.as_ref().expect("finite"), &plain.jet(x));
            }
            let (line, plain) = (Enclosed::new(&numbers, [48], boundary).expect("sound"), spline(&numbers, [48], boundary));
            let points: Vec<[Rational; 1]> = points.into_iter().map(|[x, _]| [x]).collect();
            for (jet, x) in line.jets(&points).iter().zip(&points) {
                assert_jet(jet.as_ref().expect("finite"), &plain.jet(x));
            }
        }
    }

    #[test]
    fn samples_and_symmetries_come_back_exactly() {
        let g: Vec<f64> = (0..125).map(|i| f64::from((i * 7919 % 101) - 50) * 0.1).collect();
        for boundary in BOTH {
            let volume = Enclosed::new(&g, [5; 3], boundary).expect("sound");
            let points: Vec<[Rational; 3]> = (0..125).map(|i| [i % 5, i / 5 % 5, i / 25].map(Rational::from)).collect();
            for ((jet, g), x) in volume.jets(&points).into_iter().zip(&g).zip(&points) {
                let jet = jet.expect("finite");
                assert_eq!(jet.value.to_bits(), g.to_bits());
                // A mirror is flat where it stands.
                let is_end = |i: usize| boundary == Boundary::Mirror && (x[i] == 0 || x[i] == 4);
                assert!((0..3).all(|i| !is_end(i) || jet.gradient[i].to_bits() == 0));
            }
        }
    }

    #[test]
    fn what_is_too_large_is_said_of_its_point_alone() {
        // f = MAX at the samples; between, 2f″ and more.
        let g = [f64::MAX, -f64::MAX, f64::MAX, 0.0, 0.0, 0.0, 0.0, 0.0];
        let line = Enclosed::new(&g, [8], Boundary::Periodic).expect("sound");
        let found = line.jets(&[[q(5, 1)], [q(1, 1)], [q(11, 2)]]);
        let plain = spline(&g, [8], Boundary::Periodic);
        assert_jet(found[0].as_ref().expect("finite"), &plain.jet(&[q(5, 1)]));
        assert_eq!(found[1], Err(JetError::Overflow { point: 1 }));
        assert_jet(found[2].as_ref().expect("finite"), &plain.jet(&[q(11, 2)]));
    }
}

mod sp_84 {
    use super::*;

    fn assert_surfaces(g: &[f64], shape: [usize; 3], boundary: Boundary, points: &[[Rational; 3]]) {
        let volume = Enclosed::new(g, shape, boundary).expect("sound");
        let plain = spline(g, shape, boundary);
        for (i, (found, x)) in volume.level_surfaces(points).iter().zip(points).enumerate() {
            let jet = plain.jet(x);
            match (found, curvature(&jet)) {
                (Ok(found), Ok(exact)) => {
                    assert_jet(&found.jet, &jet);
                    assert_surface(found, &exact);
                }
                (found, Ok(exact)) => {
                    assert_eq!(*found, Err(JetError::Overflow { point: i }));
                    assert!(exact.gaussian.abs() > 1e300 || exact.mean_squared > 1e300);
                }
                (found, Err(_)) => assert_eq!(*found, Err(JetError::Singular { point: i })),
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if is_long() { 200 } else { 6 }))]
        #[test]
        fn curvatures_are_rounded(
            numbers in prop::collection::vec(number(), 36), mirror in any::<bool>(),
            points in prop::collection::vec(prop::array::uniform3(coordinate()), 2),
        ) {
            let boundary = if mirror { Boundary::Mirror } else { Boundary::Periodic };
            assert_surfaces(&numbers, [3, 4, 3], boundary, &points);
            // Of one variable: K and both principal curvatures are 0. Of two: one of them is.
            let sheet: Vec<f64> = (0..36).map(|i| numbers[i % 3]).collect();
            assert_surfaces(&sheet, [3, 4, 3], boundary, &points);
            let cylinder: Vec<f64> = (0..36).map(|i| numbers[i / 3]).collect();
            assert_surfaces(&cylinder, [3, 4, 3], boundary, &points);
        }
    }

    #[test]
    fn singular_points_are_named_and_others_answered() {
        let g: Vec<f64> = (0..64).map(|i| f64::from(i % 4 * (i / 4 % 4))).collect();
        let volume = Enclosed::new(&g, [4; 3], Boundary::Mirror).expect("sound");
        let found = volume.level_surfaces(&[
            [q(1, 2), q(3, 2), q(1, 3)],
            [q(0, 1), q(0, 1), q(1, 3)],
            [q(3, 2), q(1, 5), q(9, 4)],
        ]);
        assert!(found[0].is_ok() && found[2].is_ok());
        let singular = found[1].as_ref().expect_err("∇f = 0");
        assert_eq!(singular.to_string(), "points[1]: a singular point: the gradient is zero");
        let flat = Enclosed::new(&[2_u8; 27], [3; 3], Boundary::Periodic).expect("sound");
        assert_eq!(flat.level_surfaces(&[[q(1, 2), q(1, 3), q(0, 1)]]), [Err(JetError::Singular { point: 0 })]);
    }

    #[test]
    fn the_sign_is_that_of_a_sphere() {
        // Larger toward the middle: N points inward, so that a round bump bends toward N.
        let g: Vec<f64> = (0..343)
            .map(|i| -f64::from([i % 7, i / 7 % 7, i / 49].map(|k| (k - 3) * (k - 3)).iter().sum::<i32>()))
            .collect();
        let points = [[q(4, 1), q(3, 1), q(3, 1)]];
        let inward = Enclosed::new(&g, [7; 3], Boundary::Mirror).expect("sound").level_surfaces(&points);
        let inward = inward[0].as_ref().expect("regular");
        assert!(inward.mean > 0.0 && inward.principal[0] >= inward.principal[1] && inward.principal[1] > 0.0);
        let g: Vec<f64> = g.iter().map(|g| -g).collect();
        let outward = Enclosed::new(&g, [7; 3], Boundary::Mirror).expect("sound").level_surfaces(&points);
        let outward = outward[0].as_ref().expect("regular");
        assert_eq!((outward.mean, outward.gaussian), (-inward.mean, inward.gaussian));
        assert_eq!(outward.principal, [-inward.principal[1], -inward.principal[0]]);
        assert_surfaces(&g, [7; 3], Boundary::Mirror, &points);
    }

    #[test]
    fn ties_of_principal_curvatures_go_to_the_even_one() {
        // f = A(x) + B(y) at 0: A' = 2s, A″ = 0, B′ = 0, B″ = −12m; so k₁ = 6m/s, of 54 bits, k₂ = 0, H = 3m/s.
        let s = 2_f64.powi(50);
        for m in
            [3_002_399_751_580_331_i64 + 2, 3_002_399_751_580_331 + 4, 4_000_000_000_000_001, 5_000_000_000_000_007]
        {
            let m = if m % 2 == 0 { m + 1 } else { m };
            assert!((1 << 53..1 << 54).contains(&(3 * m)), "54 bits, the last one 1");
            let (a, b) = ([0.0, s, -s], [4 * m, m, 0, m].map(|x| x as f64));
            let g: Vec<f64> = (0..24).map(|i| a[i % 3] + b[i / 3 % 4]).collect();
            let volume = Enclosed::new(&g, [3, 4, 2], Boundary::Periodic).expect("sound");
            let found = volume.level_surfaces(&[[q(0, 1), q(0, 1), q(0, 1)]]);
            let found = found[0].as_ref().expect("regular");
            let k = Rational::from(6 * m) / Rational::from(1_i64 << 50);
            assert_eq!(found.principal, [nearest_f64(&k), 0.0]);
            assert_ne!(from_f64(found.principal[0]).expect("finite"), k, "a tie, not a binary64");
            assert_eq!(found.mean, nearest_f64(&(k / 2_u32)));
            assert_eq!((found.gaussian.to_bits(), found.principal[1].to_bits()), (0, 0));
        }
    }

    /// As above with D(z), D″ a multiple of 1/11: H and the root are no binary64, their sum is a tie; or nearly one.
    #[test]
    fn sums_that_are_ties_or_nearly_ties_are_decided_exactly() {
        let s = 2_f64.powi(50);
        for m in [3_002_399_751_580_333_i64, 3_002_399_751_580_335, 4_000_000_000_000_001, 4_000_000_000_000_003] {
            for tiny in [0.0, 2_f64.powi(-120), -2_f64.powi(-120)] {
                let (a, b, d) = ([0.0, s, -s], [4 * m, m, 0, m].map(|x| x as f64), [0.0, s, 0.0, 0.0, s]);
                let mut g: Vec<f64> = (0..60).map(|i| a[i % 3] + b[i / 3 % 4] + d[i / 12]).collect();
                // A sample that is 0, in the line along y through the point: it moves B″.
                let place = 3 * 2;
                assert_eq!(g[place], 0.0);
                g[place] = tiny;
                let origin = [q(0, 1), q(0, 1), q(0, 1)];
                let k = Rational::from(6 * m) / Rational::from(1_i64 << 50);
                let volume = Enclosed::new(&g, [3, 4, 5], Boundary::Periodic).expect("sound");
                let found = volume.level_surfaces(std::slice::from_ref(&origin));
                let found = found[0].as_ref().expect("regular");
                if tiny == 0.0 {
                    assert_eq!(found.principal[0], nearest_f64(&k), "to the even one");
                    assert_ne!(from_f64(found.principal[0]).expect("finite"), k, "a tie, no binary64");
                }
                assert_surfaces(&g, [3, 4, 5], Boundary::Periodic, &[origin]);
            }
        }
    }
}
