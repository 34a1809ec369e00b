//! Lengths on surfaces and areas (002, 2(d)).

use super::curves::{p, parameter};
use super::q;
use super::quadrature::is_within;
use isoracle::curvature::arc_length::arc_length;
use isoracle::curvature::area::RationalSurface;
use isoracle::curvature::curve_printed::path_length_printed;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::FundamentalForms;
use isoracle::curvature::quadrature::{Goal, Outcome, QuadratureError};
use isoracle::curvature::rational_curve::RationalCurve;
use isoracle::number::{Interval, Multivariate, Rational, Ring};
use proptest::prelude::*;

type Function = Multivariate<2>;

fn f(terms: &[(i64, u32, u32)]) -> Function {
    Function::new(terms.iter().map(|(a, i, j)| ([*i, *j], Rational::from(*a))))
}

fn surface(numerators: [&[(i64, u32, u32)]; 3], denominator: &[(i64, u32, u32)]) -> RationalSurface {
    RationalSurface::new(numerators.map(f), f(denominator)).expect("a denominator")
}

/// (1 − u², 2u, (1 + u²)v)/(1 + u²): the cylinder of radius 1.
fn cylinder() -> RationalSurface {
    surface([&[(1, 0, 0), (-1, 2, 0)], &[(2, 1, 0)], &[(1, 0, 1), (1, 2, 1)]], &[(1, 0, 0), (1, 2, 0)])
}

/// v(1 − u², 2u, 1 + u²)/(1 + u²): the cone x² + y² = z².
fn cone() -> RationalSurface {
    surface([&[(1, 0, 1), (-1, 2, 1)], &[(2, 1, 1)], &[(1, 0, 1), (1, 2, 1)]], &[(1, 0, 0), (1, 2, 0)])
}

/// (2u, 2v, u² + v² − 1)/(1 + u² + v²): the sphere of radius 1 from its north pole.
fn sphere() -> RationalSurface {
    surface([&[(2, 1, 0)], &[(2, 0, 1)], &[(1, 2, 0), (1, 0, 2), (-1, 0, 0)]], &[(1, 0, 0), (1, 2, 0), (1, 0, 2)])
}

fn box_of(u: [i64; 2], v: [i64; 2]) -> [(Rational, Rational); 2] {
    [u, v].map(|[from, to]| (q(from, 1), q(to, 1)))
}

fn any_function() -> impl Strategy<Value = Function> {
    prop::collection::vec((-3..=3_i64, 0..=2_u32, 0..=2_u32), 1..4).prop_map(|terms| f(&terms))
}

fn any_surface() -> impl Strategy<Value = RationalSurface> {
    let denominator = any_function().prop_filter("not zero", |q| !q.is_zero());
    (prop::array::uniform3(any_function()), denominator)
        .prop_map(|(numerators, q)| RationalSurface::new(numerators, q).expect("a denominator"))
}

fn pi_times(n: i64, d: i64) -> Interval {
    Interval::pi(200) * &Interval::from_rational(&q(n, d), 200)
}

mod cu_121 {
    use super::*;

    #[test]
    fn from_0_there_may_be_no_length() {
        // (1/t, 0, 0) on J = (0, ∞), in the plane: from 1 to 2 its length is 1/2.
        let plane = surface([&[(1, 1, 0)], &[(1, 0, 1)], &[]], &[(1, 0, 0)]);
        let path = RationalCurve::new([p(&[1]), p(&[])], p(&[0, 1])).expect("a denominator");
        let goal = Goal::digits(9);
        let error = path_length_printed(&plane, &path, &q(2, 1), &goal).expect_err("no length from 0");
        assert_eq!(error, QuadratureError::Pole);
        let length = plane.path_length(&path, [&q(1, 1), &q(2, 1)], &goal).expect("no pole");
        assert!(is_within(&length, &goal, &Interval::from_rational(&q(1, 2), 100)));
        // Where 0 is in J and t₀ is another point, the printed one measures another arc.
        let line = RationalCurve::polynomial([p(&[0, 1]), p(&[])]);
        let printed = path_length_printed(&plane, &line, &q(2, 1), &goal).expect("no pole");
        assert!(is_within(&printed, &goal, &Interval::integer(2)));
        let right = plane.path_length(&line, [&q(1, 1), &q(2, 1)], &goal).expect("no pole");
        assert!(is_within(&right, &goal, &Interval::integer(1)));
    }
}

mod cu_122 {
    use super::*;

    #[test]
    fn a_helix_on_the_cylinder_and_a_great_circle() {
        let goal = Goal::digits(12);
        // The quarter circle at v = 0; the meridian u = 0 of the sphere from v = 0 to 1.
        let across = RationalCurve::polynomial([p(&[0, 1]), p(&[2])]);
        let quarter = cylinder().path_length(&across, [&q(0, 1), &q(1, 1)], &goal).expect("no pole");
        assert!(is_within(&quarter, &goal, &pi_times(1, 2)));
        let meridian = RationalCurve::polynomial([p(&[]), p(&[0, 1])]);
        let quarter = sphere().path_length(&meridian, [&q(0, 1), &q(1, 1)], &goal).expect("no pole");
        assert!(is_within(&quarter, &goal, &pi_times(1, 2)));
        // s(1) is not s(2): the formula is that of a number.
        let plane = surface([&[(1, 1, 0)], &[(1, 0, 1)], &[]], &[(1, 0, 0)]);
        let line = RationalCurve::polynomial([p(&[0, 1]), p(&[])]);
        let lengths = [1, 2].map(|t| plane.path_length(&line, [&q(0, 1), &q(t, 1)], &goal).expect("no pole"));
        assert!(
            is_within(&lengths[0], &goal, &Interval::integer(1))
                && is_within(&lengths[1], &goal, &Interval::integer(2))
        );
        // A plane in skew coordinates, F = 1: (t, t) runs along (2t, t), and (t, −t) along (0, −t).
        let skew = surface([&[(1, 1, 0), (1, 0, 1)], &[(1, 0, 1)], &[]], &[(1, 0, 0)]);
        for (v, squared) in [(1, 5), (-1, 1)] {
            let path = RationalCurve::polynomial([p(&[0, 1]), p(&[0, v])]);
            let length = skew.path_length(&path, [&q(0, 1), &q(1, 1)], &goal).expect("no pole");
            let truth = Interval::from_rational(&q(squared, 1), 200).sqrt().expect("positive");
            assert!(is_within(&length, &goal, &truth));
        }
        // Between broken bounds, and near a pole of the surface.
        assert!(sphere().path_length(&meridian, [&q(1, 1), &q(0, 1)], &goal).is_err());
        let hole = surface([&[(1, 0, 0)], &[(1, 0, 1)], &[]], &[(1, 1, 0)]);
        let through = RationalCurve::polynomial([p(&[0, 1]), p(&[])]);
        let length = hole.path_length(&through, [&q(-1, 1), &q(1, 1)], &goal).expect("well-posed");
        assert!(length.outcome == Outcome::Limit && length.value.hi().is_infinite());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4))]

        /// By E, F, G in the plane of u and v, and by x′² + y′² + z′² in space.
        #[test]
        fn it_is_the_length_of_the_curve_in_space(
            x in any_function(), y in any_function(), u in prop::collection::vec(-2..=2_i64, 1..4), v in prop::collection::vec(-2..=2_i64, 1..4),
        ) {
            let surface = RationalSurface::new([x, y, f(&[(1, 1, 0), (1, 0, 1)])], f(&[(1, 0, 0)])).expect("a denominator");
            let path = RationalCurve::polynomial([p(&u), p(&v)]);
            let goal = Goal { width: q(1, 1000), cells: 1 << 6 };
            let (from, to) = (q(-1, 2), q(2, 3));
            let form = surface.path_length(&path, [&from, &to], &goal).expect("no pole");
            let space = arc_length(&surface.along(&path).expect("no pole"), [&from, &to], &goal).expect("no pole");
            prop_assert!(form.value.intersection(&space.value).is_some());
        }

        #[test]
        fn the_curve_in_space_is_the_surface_along_the_path(surface in any_surface(), u in prop::collection::vec(-2..=2_i64, 0..3), t in parameter()) {
            let path = RationalCurve::new([p(&u), p(&[1, 2])], p(&[2, 0, 1])).expect("a denominator");
            let Ok(curve) = surface.along(&path) else { return Ok(()) };
            let at = path.point(&t).expect("no pole").0;
            let forms = surface.first_form_numerators().map(|e| e.evaluate(&at));
            let Some(velocity) = curve.derivative().point(&t) else { return Ok(()) };
            let [du, dv] = path.derivative().point(&t).expect("no pole").0;
            let q2 = surface.denominator().evaluate(&at).square();
            // q⁴(Eu′² + 2Fu′v′ + Gv′²) = q⁴|γ′|²
            let [e, f, g] = forms;
            let form = e * &du * &du + f * &du * &dv * 2_u32 + g * &dv * &dv;
            prop_assert_eq!(form, velocity.norm_squared() * &q2 * &q2);
        }
    }
}

mod cu_123 {
    use super::*;

    proptest! {
        /// Lagrange's identity as one of polynomials: q⁸(EG − F²) = q²·|q³ σᵤ × σᵥ|².
        #[test]
        fn the_cross_product_has_the_length_of_the_first_form(surface in any_surface()) {
            let square = surface.denominator().clone() * surface.denominator();
            prop_assert_eq!(surface.w_squared_numerator(), surface.normal_numerator().norm_squared() * &square);
        }

        /// Against the jets of the ground, and as base times height: |σᵤ|²·|σᵥ − (F/E)σᵤ|².
        #[test]
        fn it_is_base_times_height(surface in any_surface(), at in prop::array::uniform2(parameter())) {
            let q = surface.denominator().evaluate(&at);
            if q.is_zero() {
                return Ok(());
            }
            let [big_e, big_f, big_g] = surface.first_form_numerators().map(|e| e.evaluate(&at) / q.clone().square().square());
            let w = surface.w_squared_numerator().evaluate(&at) / q.clone().square().square().square();
            let coordinates = surface.numerators().each_ref().map(|p| Jet::of_polynomial(p, &at));
            let inverse = Jet::of_polynomial(surface.denominator(), &at).reciprocal().expect("not 0");
            let forms = FundamentalForms::new(&coordinates.map(|x| x * &inverse));
            prop_assert_eq!(&forms.first, &[big_e.clone(), big_f.clone(), big_g.clone()]);
            prop_assert_eq!((forms.w_squared(), forms.normal_w.norm_squared()), (w.clone(), w.clone()));
            if !big_e.is_zero() {
                let height = big_g - Rational::from(big_f.square_ref()) / &big_e;
                prop_assert_eq!(big_e * height, w);
            }
        }
    }

    #[test]
    fn both_integrands_give_one_area() {
        let goal = Goal::digits(3);
        let saddle = surface([&[(1, 1, 0)], &[(1, 0, 1)], &[(1, 1, 1)]], &[(1, 0, 0)]);
        let half = [(q(0, 1), q(1, 2)), (q(0, 1), q(1, 2))];
        for (surface, domain) in [(saddle, box_of([0, 1], [0, 2])), (sphere(), half)] {
            let [cross, form] = [surface.area(&domain, &goal), surface.area_by_first_form(&domain, &goal)];
            let (cross, form) = (cross.expect("well-posed"), form.expect("well-posed"));
            assert!(is_within(&cross, &goal, &form.value) && is_within(&form, &goal, &cross.value));
        }
    }
}

mod cu_124 {
    use super::*;

    #[test]
    fn a_map_that_covers_twice_counts_twice() {
        // (u², v, 0) over −1 ≤ u ≤ 1: the unit square, twice; over 0 ≤ u ≤ 1, where it is a parametrisation but at the edge, once.
        let fold = surface([&[(1, 2, 0)], &[(1, 0, 1)], &[]], &[(1, 0, 0)]);
        let goal = Goal { width: q(1, 20), cells: 1 << 12 };
        let area = |u: [i64; 2]| fold.area(&box_of(u, [0, 1]), &goal).expect("well-posed");
        assert!(is_within(&area([-1, 1]), &goal, &Interval::integer(2)));
        assert!(is_within(&area([0, 1]), &goal, &Interval::integer(1)));
        assert!(fold.area(&box_of([1, 0], [0, 1]), &goal).is_err());
    }

    #[test]
    fn a_bounded_surface_may_have_no_area() {
        // z = sin 1/x over 0 < x < 1, 0 < y < 1: at 1/x = (k + 1/2)π the height is ±1, so that n swings, each of the width
        // 1, have an area above 2n; it lies in a cube of side 2.
        let heights: Vec<Interval> =
            (0..40).map(|k| (Interval::pi(100) * &Interval::from_rational(&q(2 * k + 1, 2), 100)).sin()).collect();
        let swings = heights.windows(2).map(|pair| (pair[0].clone() - &pair[1]).abs().bounds().expect("finite").0);
        assert!(swings.fold(Rational::new(), |sum, swing| sum + swing) > 77);
    }
}

mod cu_125 {
    use super::*;

    proptest! {
        /// |τ_a × τ_b| = |det Dh|·|σᵤ × σᵥ|∘h, squared, as an identity of polynomials.
        #[test]
        fn the_integrand_takes_the_jacobian(numerators in prop::array::uniform3(any_function()), h in prop::array::uniform2(any_function())) {
            let surface = RationalSurface::new(numerators, Function::integer(1)).expect("a denominator");
            let changed = surface.reparametrised(&h).expect("no pole");
            let jacobian = h[0].derivative(0) * &h[1].derivative(1) - &(h[0].derivative(1) * &h[1].derivative(0));
            let composed = surface.w_squared_numerator().evaluate_in(&h, |a| Function::constant(a.clone()));
            prop_assert_eq!(changed.w_squared_numerator(), composed * &jacobian * &jacobian);
        }
    }

    #[test]
    fn another_parametrisation_has_the_same_area() {
        // u = a + a², v = b − ab over the unit square, whose image is 0 ≤ u ≤ 2, 0 ≤ v ≤ 1 − a; and the rectangle with its axes exchanged.
        let saddle = surface([&[(1, 1, 0)], &[(1, 0, 1)], &[(1, 1, 1)]], &[(1, 0, 0)]);
        let goal = Goal::digits(5);
        let stretched = saddle.reparametrised(&[f(&[(1, 1, 0), (1, 2, 0)]), f(&[(1, 0, 1)])]).expect("no pole");
        let exchanged = saddle.reparametrised(&[f(&[(1, 0, 1)]), f(&[(1, 1, 0)])]).expect("no pole");
        let area = saddle.area(&box_of([0, 2], [0, 1]), &goal).expect("well-posed");
        for other in [stretched.area(&box_of([0, 1], [0, 1]), &goal), exchanged.area(&box_of([0, 1], [0, 2]), &goal)] {
            assert!(is_within(&other.expect("well-posed"), &goal, &area.value));
        }
    }
}

mod cu_126 {
    use super::*;

    #[test]
    fn areas_with_closed_forms() {
        let within = |surface: &RationalSurface, domain: &[(Rational, Rational); 2], digits: u32, truth: &Interval| {
            let goal = Goal::digits(digits);
            is_within(&surface.area(domain, &goal).expect("well-posed"), &goal, truth)
        };
        // A quarter of the cylinder, 3 high; a quarter of the cone from z = 1 to 2: √2·π·z²/4.
        assert!(within(&cylinder(), &box_of([0, 1], [0, 3]), 6, &pi_times(3, 2)));
        let root = Interval::from_rational(&q(2, 1), 200).sqrt().expect("positive");
        assert!(within(&cone(), &box_of([0, 1], [1, 2]), 6, &(pi_times(3, 4) * &root)));
        // The image of −1 ≤ u, v ≤ 1: ∫∫ 4/(1 + u² + v²)² = 8√2·arctan(1/√2).
        let truth =
            root.clone() * &Interval::integer(8) * &Interval::integer(1).checked_div(&root).expect("√2 > 0").atan();
        assert!(within(&sphere(), &box_of([-1, 1], [-1, 1]), 3, &truth));
        // A parallelogram of the sides (1, 2, 2) and (0, 3, 4): |(2, −4, 3)| = √29.
        let flat = surface([&[(1, 1, 0)], &[(2, 1, 0), (3, 0, 1)], &[(2, 1, 0), (4, 0, 1)]], &[(1, 0, 0)]);
        assert!(within(
            &flat,
            &box_of([0, 1], [0, 1]),
            12,
            &Interval::from_rational(&q(29, 1), 200).sqrt().expect("positive")
        ));
    }

    #[test]
    fn a_denominator_below_0_and_a_pole() {
        // The sphere over −(1 + u² + v²): its mirror image, of the same area.
        let mirrored = RationalSurface::new(sphere().numerators().clone(), -sphere().denominator().clone())
            .expect("a denominator");
        let goal = Goal::digits(3);
        let [a, b] = [sphere(), mirrored].map(|s| s.area(&box_of([0, 1], [0, 1]), &goal).expect("well-posed"));
        assert!(is_within(&a, &goal, &b.value));
        let pole = surface([&[(1, 0, 0)], &[(1, 0, 1)], &[]], &[(1, 1, 0)]);
        let area = pole.area(&box_of([-1, 1], [0, 1]), &Goal { width: q(1, 100), cells: 64 }).expect("well-posed");
        assert!(area.outcome == Outcome::Limit && area.value.hi().is_infinite());
        assert!(RationalSurface::new([f(&[]), f(&[]), f(&[])], f(&[])).is_err());
    }
}
