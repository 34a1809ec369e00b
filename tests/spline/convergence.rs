//! Orders of convergence of the spline through samples of a polynomial, and what the text says of them.

use super::q;
use isoracle::curvature::implicit_surface::curvature;
use isoracle::curvature::jet::Jet;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::topology::topology;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::number::{Multivariate, Rational, Trivariate};
use isoracle::spline::coherence_counterexamples::{rippled, speckled, touching};
use isoracle::spline::convergence::{
    Errors, enclosed_order_in_hundredths, errors, floor_of_logarithm, order_in_hundredths, spline_jet,
};
use isoracle::spline::prefilter::interpolate;
use isoracle::spline::signal::{Boundary, Signal};
use isoracle::spline::specimen::Specimen;
use proptest::prelude::*;

fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// f(x − c).
fn moved(f: &Trivariate, centre: [Rational; 3]) -> Trivariate {
    let variables: [Trivariate; 3] =
        std::array::from_fn(|a| Multivariate::variable(a) - &Multivariate::constant(centre[a].clone()));
    f.evaluate_in(&variables, |c| Multivariate::constant(c.clone()))
}

/// A square of x² + y² + z²: spheres again, but of degree 4. The centre is in the middle of the unit box.
fn sphere() -> Trivariate {
    let f = moved(&Specimen::Sphere.polynomial(), [q(1, 2), q(1, 2), q(1, 2)]);
    f.clone() * &f
}

fn torus() -> Trivariate {
    // With R = 5/8, r = 1/4 the point (2/3, 2/3, 7/12) is (R + r·3/5)(4/5, 3/5), r·4/5 from the centre.
    let across = q(5, 8) + q(3, 20);
    let centre = [q(2, 3) - q(4, 5) * &across, q(2, 3) - q(3, 5) * &across, q(7, 12) - q(1, 5)];
    moved(&Specimen::Torus.polynomial(), centre)
}

const NAMES: [&str; 5] = ["f", "∇f", "Hess f", "K", "H"];

/// Orders of the five errors, in hundredths, from one spacing to its half.
fn orders(coarse: &Errors, fine: &Errors) -> [Option<i64>; 5] {
    [
        order_in_hundredths(&coarse.value, &fine.value),
        order_in_hundredths(&coarse.gradient, &fine.gradient),
        order_in_hundredths(&coarse.hessian, &fine.hessian),
        order_in_hundredths(&coarse.gaussian, &fine.gaussian),
        enclosed_order_in_hundredths(&coarse.mean, &fine.mean),
    ]
}

/// Off the grid: thirds, which stay thirds when spacings are halved. On it. On the border.
fn places() -> [(&'static str, [Rational; 3]); 3] {
    [
        ("between samples", [q(2, 3), q(2, 3), q(7, 12)]),
        ("at a sample", [q(5, 8), q(3, 4), q(3, 8)]),
        ("on the border", [q(0, 1), q(2, 3), q(7, 12)]),
    ]
}

mod sp_92 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn products_of_splines_are_the_spline_of_the_product(
            terms in prop::collection::vec((prop::array::uniform3(0..4_u32), -9..=9_i64), 1..6),
            n in 1..5_u32, periodic in any::<bool>(), at in prop::array::uniform3(0..=12_i64),
        ) {
            let boundary = if periodic { Boundary::Periodic } else { Boundary::Mirror };
            let f = Multivariate::new(terms.into_iter().map(|(exponents, c)| (exponents, q(c, 1))));
            let at = at.map(|x| q(x, 12));
            let side = n as usize + 1;
            let values = (0..side.pow(3)).map(|m| {
                f.evaluate(&[m % side, m / side % side, m / side / side].map(|i| Rational::from((i, n))))
            });
            let signal = Signal::new([side; 3], values.collect(), boundary).expect("the shape fits");
            let grid = interpolate(&signal).jet(&at.clone().map(|x| x * n));
            let jet = spline_jet(&f, n, boundary, &at);
            prop_assert_eq!(&jet.value, &grid.value);
            for i in 0..3 {
                prop_assert_eq!(&jet.gradient[i], &(grid.gradient[i].clone() * n));
                for j in 0..3 {
                    prop_assert_eq!(&jet.hessian.0[i][j], &(grid.hessian.0[i][j].clone() * n * n));
                }
            }
        }
    }
}

mod sp_93 {
    use super::*;

    #[test]
    fn orders_are_logarithms_rounded_down() {
        let order = |a: i64, b: i64| order_in_hundredths(&q(a, 1), &q(b, 1));
        assert_eq!([order(16, 1), order(1, 16), order(1, 1)], [Some(400), Some(-400), Some(0)]);
        // log₂ 3 = 1.5849…, log₂ (1/3) = −1.5849…, log₂ (5/3) = 0.7369…
        assert_eq!([order(3, 1), order(1, 3), order(5, 3)], [Some(158), Some(-159), Some(73)]);
        let floors = [(1, 3), (3, 4), (1, 1), (5, 3), (7, 2), (9, 2), (1, 8)].map(|(n, d)| floor_of_logarithm(q(n, d)));
        assert_eq!(floors, [-2, -1, 0, 0, 1, 2, -3]);
        assert_eq!([order(0, 1), order(1, 0), order(-1, 1)], [None; 3]);
    }

    #[test]
    fn inside_they_are_four_three_two_two_two() {
        for f in [sphere(), torus()] {
            for (place, at) in &places()[..2] {
                let [coarse, fine] = [64, 128].map(|n| errors(&f, n, Boundary::Mirror, at).expect("regular"));
                let found = orders(&coarse, &fine);
                // At a sample the value is exact, and for degree 4 the gradient nearly so: the rest falls as 0.27ⁿ.
                let expected = if *place == "at a sample" {
                    [None, Some(1500), Some(200), Some(200), Some(200)]
                } else {
                    [400, 300, 200, 200, 200].map(Some)
                };
                for i in 0..5 {
                    match (found[i], expected[i]) {
                        (None, None) => {}
                        (Some(order), Some(1500)) => assert!(order >= 1500),
                        (Some(order), Some(expected)) => {
                            assert!((order - expected).abs() <= 15, "{place} {}: {order}", NAMES[i])
                        }
                        (found, _) => panic!("{place} {}: {found:?}", NAMES[i]),
                    }
                }
            }
        }
    }

    #[test]
    fn the_leading_error_is_that_of_hermite_interpolation() {
        // f − s = h⁴ f⁗ t²(1 − t)²/24 = h⁴ t²(1 − t)² for x⁴, up to what the border sends in.
        let f = Multivariate::new([([4, 0, 0], q(1, 1))]);
        for t in [q(1, 2), q(1, 3), q(1, 7)] {
            let at = [(q(20, 1) + &t) / 40, q(1, 2), q(1, 2)];
            let gap = (f.evaluate(&at) - spline_jet(&f, 40, Boundary::Mirror, &at).value) * 40_i64.pow(4);
            let rest = gap - t.clone().square() * (q(1, 1) - t).square();
            assert!(rest.abs() < q(1, 1_000_000));
        }
    }

    #[test]
    fn cubic_polynomials_are_hit_but_for_the_border() {
        let f = Multivariate::new([
            ([3, 0, 0], q(1, 1)),
            ([1, 2, 0], q(-2, 1)),
            ([0, 1, 3], q(5, 1)),
            ([0, 0, 1], q(1, 1)),
        ]);
        let [coarse, fine] = [32, 64].map(|n| errors(&f, n, Boundary::Mirror, &places()[0].1).expect("regular"));
        assert!(orders(&coarse, &fine).iter().all(|order| order.is_some_and(|order| order > 1000)));
    }

    #[test]
    fn gradients_at_samples_are_of_order_four() {
        let f = moved(&Specimen::GenusTwo.polynomial(), [q(1, 3), q(1, 5), q(1, 2)]);
        let at = &places()[1].1;
        let [coarse, fine] = [64, 128].map(|n| errors(&f, n, Boundary::Mirror, at).expect("regular"));
        assert_eq!(orders(&coarse, &fine)[1], Some(400));
    }

    fn text(sizes: &[u32], boundaries: &[Boundary]) -> String {
        let random = Multivariate::new([
            ([5, 0, 0], q(2, 1)),
            ([0, 4, 1], q(-3, 1)),
            ([1, 2, 3], q(5, 1)),
            ([2, 2, 2], q(-7, 2)),
            ([0, 1, 5], q(1, 1)),
            ([3, 1, 0], q(4, 1)),
            ([1, 0, 0], q(-2, 3)),
            ([0, 1, 1], q(3, 1)),
        ]);
        let mut text = String::new();
        for (name, f) in [("sphere", sphere()), ("torus", torus()), ("polynomial", random)] {
            for boundary in boundaries {
                for (place, at) in places() {
                    let all: Vec<Errors> =
                        sizes.iter().map(|n| errors(&f, *n, *boundary, &at).expect("regular")).collect();
                    for (pair, n) in all.windows(2).zip(sizes) {
                        text += &format!("{name} {boundary:?} {place}, h = 1/{n} to 1/{}:", 2 * n);
                        for (name, order) in NAMES.iter().zip(orders(&pair[0], &pair[1])) {
                            let sign = if order.is_some_and(|n| n < 0) { "-" } else { "" };
                            let shown = |n: i64| format!("{sign}{}.{:02}", n.abs() / 100, n.abs() % 100);
                            text += &format!(" {name} {}", order.map_or("exact".to_string(), shown));
                        }
                        text += "\n";
                    }
                }
            }
        }
        text
    }

    #[test]
    fn observed() {
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../../snapshots");
        settings.set_prepend_module_to_snapshot(false);
        settings.bind(|| insta::assert_snapshot!("sp_93__orders", text(&[16, 32, 64, 128], &[Boundary::Mirror])));
        if is_long() {
            let long = text(&[16, 32, 64, 128, 256], &[Boundary::Mirror, Boundary::Periodic]);
            settings.bind(|| insta::assert_snapshot!("sp_93__orders_long", long));
        }
    }
}

mod sp_94 {
    use super::*;

    #[test]
    fn a_uniform_limit_says_nothing_of_curvatures() {
        for n in [4_usize, 6, 8] {
            let signal = rippled(n).expect("small");
            // Within 2h² of z.
            for (m, value) in signal.values().iter().enumerate() {
                let z = Rational::from((m / (n + 1) / (n + 1), n));
                assert!((value - z).abs() <= Rational::from((2, n * n)));
            }
            let spline = interpolate(&signal);
            for at in [[2, 2, 2], [1, 2, 2], [1, 3, 2]] {
                let surface = curvature(&spline.jet(&at.map(Rational::from))).expect("regular");
                // In units of the box: f_x = f_y = 0, f_xx = ∓12, f_yy = ∓12, and f_z near 1.
                let rise = surface.gradient[2].clone() * n as u32;
                let k = surface.gaussian * (n * n) as u32;
                let sign = if (at[0] + at[1]) % 2 == 0 { 1 } else { -1 };
                assert_eq!(k * rise.clone().square(), sign * 144);
                assert!(q(3, 4) < rise && rise < q(5, 4));
            }
        }
        // As printed the limit would be the plane's K.
        let plane = Jet::of_polynomial(&Multivariate::variable(2), &[q(0, 1), q(0, 1), q(1, 2)]);
        assert_eq!(curvature(&plane).expect("regular").gaussian, 0);
    }
}

mod sp_95 {
    use super::*;

    #[test]
    fn a_uniform_limit_says_nothing_of_topology() {
        for n in [4_usize, 6, 8, 10] {
            let volume = speckled(n).expect("small");
            for m in 0..volume.len() {
                // 4n times within 2h of z − 1/2.
                let plane = Rational::from(4 * volume.point(m)[2]) - 2 * n as i32;
                assert!((volume.sample(m) - plane).abs() <= 8);
            }
            let level = Level { volume: &volume, isovalue: q(0, 1), tie: Tie::Degenerate };
            let found = topology(&level).expect("no ties");
            // The plane's is a disc: χ = 1.
            assert_eq!(found.chi(), (2 * n * n + 3) as i64);
        }
    }
}

mod sp_96 {
    use super::*;

    #[test]
    fn at_a_mirror_curvatures_diverge() {
        let at = &places()[2].1;
        for f in [sphere(), torus()] {
            let all: Vec<Errors> = [16, 32, 64].map(|n| errors(&f, n, Boundary::Mirror, at).expect("regular")).into();
            for pair in all.windows(2) {
                let found = orders(&pair[0], &pair[1]);
                assert_eq!(found[1], Some(0));
                assert!(found[2..].iter().all(|order| order.is_some_and(|order| order < -80)), "{found:?}");
                assert!(pair[0].gaussian < pair[1].gaussian);
            }
            // ∂f/∂x of the spline is 0 there, whatever that of f is.
            assert_eq!(spline_jet(&f, 16, Boundary::Mirror, at).gradient[0], 0);
            assert_ne!(Jet::of_polynomial(&f, at).gradient[0], 0);
        }
    }
}

mod sp_97 {
    use super::*;

    #[test]
    fn a_critical_isovalue_is_never_seen() {
        // {f = 0} is the plane z = 1/3; on the plane ∇f = 0.
        let topology_of = |volume: &Volume| {
            topology(&Level { volume, isovalue: q(0, 1), tie: Tie::Degenerate }).expect("no sample is 0")
        };
        for n in [1, 2, 4, 8] {
            assert!(topology_of(&touching(n).expect("small")).components.is_empty());
        }
        let square = Multivariate::variable(2) - &Multivariate::constant(q(1, 3));
        let jet = Jet::of_polynomial(&(square.clone() * &square), &[q(0, 1), q(0, 1), q(1, 3)]);
        assert_eq!((jet.value.clone(), jet.gradient.norm_squared()), (q(0, 1), q(0, 1)));
    }
}
