//! Multilinear interpolation and its critical points.

use isoracle::isosurface::critical::{BilinearCritical, TrilinearCritical, bilinear_critical, trilinear_critical};
use isoracle::isosurface::multilinear::*;
use isoracle::number::{Enclosure, Integer, Interval, Perturbed, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn rational() -> impl Strategy<Value = Rational> {
    (-40i64..=40, 1i64..=12).prop_map(|(n, d)| q(n, d))
}

/// Every vector of N values from the set.
fn all<const N: usize>(from: &[i64]) -> impl Iterator<Item = [Rational; N]> + '_ {
    (0..from.len().pow(N as u32))
        .map(|code| std::array::from_fn(|i| Rational::from(from[code / from.len().pow(i as u32) % from.len()])))
}

/// f by repeated linear interpolation: first along x, then y, then z.
fn nested(g: &[Rational; 8], [u, v, w]: &[Rational; 3]) -> Rational {
    let lerp = |a: &Rational, b: &Rational, t: &Rational| Rational::from(b - a) * t + a;
    let x: Vec<_> = (0..4).map(|i| lerp(&g[2 * i], &g[2 * i + 1], u)).collect();
    lerp(&lerp(&x[0], &x[1], v), &lerp(&x[2], &x[3], v), w)
}

mod interpolation {
    use super::*;

    proptest! {
        #[test]
        fn trilinear_is_linear_interpolation_three_times(
            g in proptest::array::uniform8(rational()), p in proptest::array::uniform3(rational())
        ) {
            prop_assert_eq!(trilinear(&g, &p), nested(&g, &p));
        }

        #[test]
        fn bilinear_is_trilinear_on_every_face(
            g in proptest::array::uniform8(rational()), u in rational(), v in rational()
        ) {
            let face = |c: [usize; 4]| bilinear(&c.map(|c| g[c].clone()), &[u.clone(), v.clone()]);
            let (zero, one) = (Rational::new(), Rational::from(1));
            let f = |p: [&Rational; 3]| trilinear(&g, &p.map(Rational::clone));
            prop_assert_eq!(face([0, 2, 4, 6]), f([&zero, &u, &v]));
            prop_assert_eq!(face([1, 3, 5, 7]), f([&one, &u, &v]));
            prop_assert_eq!(face([0, 1, 4, 5]), f([&u, &zero, &v]));
            prop_assert_eq!(face([2, 3, 6, 7]), f([&u, &one, &v]));
            prop_assert_eq!(face([0, 1, 2, 3]), f([&u, &v, &zero]));
            prop_assert_eq!(face([4, 5, 6, 7]), f([&u, &v, &one]));
        }

        #[test]
        fn gradients_are_difference_quotients_for_f_is_linear_along_each_axis(
            g in proptest::array::uniform8(rational()), p in proptest::array::uniform3(rational()), h in 1i64..9
        ) {
            let gradient = trilinear_gradient(&g, &p);
            for axis in 0..3 {
                let mut ahead = p.clone();
                ahead[axis] += h;
                prop_assert_eq!(&gradient[axis], &((nested(&g, &ahead) - nested(&g, &p)) / h));
            }
            let g: [Rational; 4] = std::array::from_fn(|c| g[c].clone());
            let p = [p[0].clone(), p[1].clone()];
            let gradient = bilinear_gradient(&g, &p);
            for axis in 0..2 {
                let mut ahead = p.clone();
                ahead[axis] += h;
                prop_assert_eq!(&gradient[axis], &((bilinear(&g, &ahead) - bilinear(&g, &p)) / h));
            }
        }

        #[test]
        fn f_is_linear_between_the_ends_of_a_line_along_an_axis(
            g in proptest::array::uniform8(rational()), at in proptest::array::uniform2(rational()), t in rational()
        ) {
            for axis in 0..3 {
                let mut point = vec![at[0].clone(), at[1].clone()];
                point.insert(axis, t.clone());
                let point: [Rational; 3] = point.try_into().expect("three coordinates");
                prop_assert_eq!(linear(&on_line(&g, axis, &at), &t), nested(&g, &point));
                if let LinearZero::At(t) = zero_on_line(&g, axis, &at) {
                    let mut point = vec![at[0].clone(), at[1].clone()];
                    point.insert(axis, t);
                    prop_assert_eq!(nested(&g, &point.try_into().expect("three coordinates")), 0);
                }
            }
        }

        #[test]
        fn an_interval_evaluation_encloses_the_rational_one(
            g in proptest::array::uniform8(rational()), p in proptest::array::uniform3(rational())
        ) {
            let wide = |x: &Rational| Interval::from_rational(x, 24);
            let f = trilinear(&g.each_ref().map(wide), &p.each_ref().map(wide));
            prop_assert!(f.contains(&nested(&g, &p)));
        }

        #[test]
        fn a_raised_function_is_raised_everywhere(
            g in proptest::array::uniform8(rational()), p in proptest::array::uniform3(rational())
        ) {
            let raised = g.each_ref().map(|g| Perturbed::new(g.clone(), Rational::integer(1)));
            let point = p.each_ref().map(|x| Perturbed::new(x.clone(), Rational::integer(0)));
            let f = trilinear(&raised, &point) - &Perturbed::new(nested(&g, &p), Rational::integer(1));
            prop_assert_eq!(f.known_sign(), Some(Sign::Zero));
        }
    }
}

mod piecewise {
    use super::*;

    /// The text's figure 35 in spirit: a hat at 0.
    fn hat(i: &Integer) -> Rational {
        Rational::from(if *i == 0 { 1 } else { 0 })
    }

    #[test]
    fn the_floor_of_a_negative_number_is_below_it() {
        assert_eq!(piecewise_linear(hat, &q(-1, 4)), q(3, 4));
        assert_eq!(piecewise_linear(hat, &q(1, 4)), q(3, 4));
        assert_eq!(piecewise_linear(hat, &q(-5, 4)), 0);
    }

    proptest! {
        #[test]
        fn the_signal_is_met_at_integers_and_the_function_is_continuous(n in -9i64..9, steps in 1i64..1000) {
            let g = |i: &Integer| Rational::from(i * i.clone()) * i - Rational::from(7 * i.clone());
            let at = |x: &Rational| piecewise_linear(g, x);
            let whole = Rational::from(n);
            prop_assert_eq!(at(&whole), g(&Integer::from(n)));
            // One step below n, f is off by at most the slope there times the step.
            let step = q(1, steps + 1);
            let slope = g(&Integer::from(n)) - g(&Integer::from(n - 1));
            prop_assert_eq!(at(&whole) - at(&Rational::from(&whole - &step)), slope * step);
        }
    }
}

mod zeros {
    use super::*;

    #[test]
    fn a_linear_function_vanishes_once_iff_signs_differ_and_everywhere_iff_both_are_zero() {
        for [g0, g1] in all::<2>(&[-3, -2, -1, 0, 1, 2, 3]) {
            // Where it vanishes on the multiples of 1/60 = 1/lcm(1…6), which hold every possible zero.
            let zeros: Vec<_> =
                (0..=60).map(|n| q(n, 60)).filter(|t| linear(&[g0.clone(), g1.clone()], t) == 0).collect();
            match linear_zero(&[g0, g1]) {
                LinearZero::None => assert!(zeros.is_empty()),
                LinearZero::At(t) => assert_eq!(zeros, [t]),
                LinearZero::Everywhere => assert_eq!(zeros.len(), 61),
            }
        }
    }
}

mod critical_points {
    use super::*;

    /// The multiples of 1/2 in [−3, 4].
    fn lattice() -> Vec<Rational> {
        (-6..=8).map(|n| q(n, 2)).collect()
    }

    #[test]
    fn the_bilinear_critical_points_are_where_the_gradient_vanishes() {
        for g in all::<4>(&[-3, -2, -1, 0, 1, 2, 3]) {
            let critical = bilinear_critical(&g);
            if let BilinearCritical::Saddle(saddle) = &critical {
                let at = [saddle.u.clone(), saddle.v.clone()];
                assert_eq!(bilinear_gradient(&g, &at), [0, 0], "{g:?}");
                assert_eq!(bilinear(&g, &at), saddle.value, "{g:?}");
            }
            for u in lattice() {
                for v in lattice() {
                    let at = [u.clone(), v.clone()];
                    let reported = match &critical {
                        BilinearCritical::None => false,
                        BilinearCritical::Everywhere => true,
                        BilinearCritical::Saddle(saddle) => saddle.u == u && saddle.v == v,
                    };
                    assert_eq!(bilinear_gradient(&g, &at) == [0, 0], reported, "{g:?} at {at:?}");
                }
            }
        }
    }

    #[test]
    fn an_alternating_square_holds_its_saddle_and_the_determinant_shows_which_corners_exceed_it() {
        for g in all::<4>(&[-3, -2, -1, 1, 2, 3]) {
            let sign = |x: &Rational| Sign::of(x.cmp0());
            if sign(&g[0]) != sign(&g[3]) || sign(&g[1]) != sign(&g[2]) || sign(&g[0]) == sign(&g[1]) {
                continue;
            }
            let BilinearCritical::Saddle(saddle) = bilinear_critical(&g) else { panic!("no saddle: {g:?}") };
            assert!(saddle.u > 0 && saddle.u < 1 && saddle.v > 0 && saddle.v < 1);
            let determinant = Rational::from(&g[0] * &g[3]) - Rational::from(&g[1] * &g[2]);
            assert_eq!(sign(&saddle.value), sign(&determinant) * sign(&g[0]), "{g:?}");
        }
    }

    /// The gradient at points of ℚ(√d) and the value there, by the formula over ℚ(√d).
    fn check_pair(g: &[Rational; 8], critical: &TrilinearCritical) {
        let lifted = g.each_ref().map(|x| Surd::from(x.clone()));
        if let TrilinearCritical::Pair(points) = critical {
            assert_ne!(points[0].position, points[1].position);
            for point in points.iter() {
                assert_eq!(trilinear_gradient(&lifted, &point.position), [0, 0, 0].map(Surd::integer), "{g:?}");
                assert_eq!(trilinear(&lifted, &point.position), point.value, "{g:?}");
            }
        }
    }

    fn check_value(g: &[Rational; 8], critical: &TrilinearCritical) {
        match critical {
            TrilinearCritical::Point(point)
            | TrilinearCritical::ThreeLines(point)
            | TrilinearCritical::Line { point, .. } => {
                assert_eq!(nested(g, &point.position), point.value);
                assert!(critical.contains(&point.position));
            }
            TrilinearCritical::Hyperbola { centre, product, axis } => {
                let mut on = centre.position.clone();
                on[(axis + 1) % 3] += 1;
                on[(axis + 2) % 3] += product;
                assert_eq!(trilinear_gradient(g, &on), [0, 0, 0], "{g:?}");
                assert_eq!(nested(g, &on), centre.value);
            }
            TrilinearCritical::Pair(_) | TrilinearCritical::None | TrilinearCritical::Everywhere => {}
        }
    }

    #[test]
    fn the_trilinear_critical_points_are_exactly_where_the_gradient_vanishes_on_a_lattice() {
        let mut seen = std::collections::BTreeMap::new();
        let lattice: Vec<Rational> = (-3..=5).map(|n| q(n, 2)).collect();
        for g in all::<8>(&[-1, 0, 1]) {
            let critical = trilinear_critical(&g);
            let kind = match &critical {
                TrilinearCritical::None => "none",
                TrilinearCritical::Point(_) => "point",
                TrilinearCritical::Pair(_) => "pair",
                TrilinearCritical::Line { .. } => "line",
                TrilinearCritical::ThreeLines(_) => "three lines",
                TrilinearCritical::Hyperbola { .. } => "hyperbola",
                TrilinearCritical::Everywhere => "everywhere",
            };
            *seen.entry(kind).or_insert(0) += 1;
            check_pair(&g, &critical);
            check_value(&g, &critical);
            // An eleventh of them, to be quick.
            if g.iter()
                .enumerate()
                .fold(Rational::new(), |sum, (i, x)| sum + Rational::from(x * (i as i64 + 1)))
                .numer()
                .mod_u(11)
                != 0
            {
                continue;
            }
            for x in &lattice {
                for y in &lattice {
                    for z in &lattice {
                        let at = [x.clone(), y.clone(), z.clone()];
                        let critical_here = trilinear_gradient(&g, &at) == [0, 0, 0];
                        assert_eq!(critical_here, critical.contains(&at), "{g:?} at {at:?}");
                    }
                }
            }
        }
        assert_eq!(seen.values().sum::<i32>(), 6561);
        assert_eq!(seen.len(), 7, "a kind never occurs: {seen:?}");
    }

    #[test]
    fn a_pair_of_critical_points_need_not_be_rational() {
        // xyz − 2x − y − z about its own centre 0: pqr = 2, and the points are ±√2·(1/2, 1, 1).
        let f = |x: i64, y: i64, z: i64| Rational::from(x * y * z - 2 * x - y - z);
        let g = std::array::from_fn(|c| f(c as i64 & 1, c as i64 >> 1 & 1, c as i64 >> 2 & 1));
        let TrilinearCritical::Pair(points) = trilinear_critical(&g) else { panic!("not a pair") };
        let [first, second] = *points;
        assert_eq!(first.position.map(|x| x.to_string()), ["1/2·√2", "√2", "√2"]);
        assert_eq!(second.position.map(|x| x.to_string()), ["-1/2·√2", "-√2", "-√2"]);
        assert_eq!([first.value.to_string(), second.value.to_string()], ["-2·√2", "2·√2"]);
    }
}
