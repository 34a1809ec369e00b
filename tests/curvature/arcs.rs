//! Arc length and reparametrisation (002, 2(b)).

use super::curves::{curve, cusp, p, parameter, polynomial_curve, rational_circle, rational_curve};
use super::q;
use super::quadrature::is_within;
use isoracle::curvature::arc_length::{
    antiderivative, arc_length, length_of_turns, parameter_at_length, polygon_length, polynomial_speed,
};
use isoracle::curvature::circle_polynomial::CirclePolynomial;
use isoracle::curvature::quadrature::{Goal, Outcome, QuadratureError};
use isoracle::curvature::rational_curve::{RationalCurve, SingularParameters};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Algebraic, Interval, Polynomial, Rational, Ring};
use proptest::prelude::*;

fn number(n: i64) -> Interval {
    Interval::from_rational(&q(n, 1), 200)
}

fn over(x: Interval, n: i64) -> Interval {
    x.checked_div(&number(n)).expect("n is not 0")
}

/// A curve of the speed 1 + t²: (t − t³/3, t²).
fn pythagorean() -> RationalCurve<2> {
    RationalCurve::polynomial([Polynomial::new(vec![q(0, 1), q(1, 1), q(0, 1), q(-1, 3)]), p(&[0, 0, 1])])
}

fn length(curve: &RationalCurve<2>, from: &Rational, to: &Rational, goal: &Goal) -> Interval {
    let length = arc_length(curve, [from, to], goal).expect("no pole");
    assert_eq!(length.outcome, Outcome::Reached);
    length.value
}

mod cu_19 {
    use super::*;

    #[test]
    fn lengths_with_closed_forms() {
        let goal = Goal::digits(12);
        // The parabola (t, t²): √5/2 + ln(2 + √5)/4 from 0 to 1.
        let root = number(5).sqrt().expect("positive");
        let truth = over(root.clone(), 2) + &over((root + &number(2)).ln().expect("positive"), 4);
        let parabola = curve(&[0, 1], &[0, 0, 1]);
        assert!(is_within(&arc_length(&parabola, [&q(0, 1), &q(1, 1)], &goal).expect("no pole"), &goal, &truth));
        // The quarter and the half circle: π/2, π.
        for (from, to, parts) in [(0, 1, 2), (-1, 1, 1)] {
            let arc = arc_length(&rational_circle(), [&q(from, 1), &q(to, 1)], &goal).expect("no pole");
            assert!(is_within(&arc, &goal, &over(Interval::pi(200), parts)));
        }
        // The cusp (t³, t²), through its singular point: ∫|t|√(9t² + 4) = ((9t² + 4)^(3/2) − 8)/27.
        let root = number(13).sqrt().expect("positive");
        let truth = over((root * &number(13) - &number(8)) * &number(2), 27);
        let arc = arc_length(&cusp(), [&q(-1, 1), &q(1, 1)], &goal).expect("no pole");
        assert!(is_within(&arc, &goal, &truth));
    }

    #[test]
    fn before_t0_the_length_is_negative() {
        let goal = Goal::digits(9);
        let arc = arc_length(&pythagorean(), [&q(1, 1), &q(0, 1)], &goal).expect("no pole");
        assert!(is_within(&arc, &goal, &over(number(-4), 3)));
    }

    #[test]
    fn a_pole_is_refused() {
        let hyperbola = RationalCurve::new([p(&[1]), p(&[0, 0, 1])], p(&[0, 1])).expect("a denominator");
        for (from, to) in [(-1, 1), (0, 1), (-1, 0), (1, -1)] {
            let error = arc_length(&hyperbola, [&q(from, 1), &q(to, 1)], &Goal::digits(3)).expect_err("a pole");
            assert_eq!(error, QuadratureError::Pole);
        }
        let no_width = Goal { width: q(-1, 1), cells: 9 };
        assert!(arc_length(&cusp(), [&q(0, 1), &q(1, 1)], &no_width).is_err());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10))]

        #[test]
        fn lengths_add_up(curve in polynomial_curve(), mut t in prop::array::uniform3(parameter())) {
            t.sort();
            let goal = Goal::digits(4);
            let [a, b, c] = [(0, 1), (1, 2), (0, 2)].map(|(i, j)| length(&curve, &t[i], &t[j], &goal));
            prop_assert!((a + &b).intersection(&c).is_some());
        }
    }
}

mod cu_20 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        /// (L(t + h) − L(t))/h lies between the extremes of |α′|² on [t, t + h], here at h = 2⁻²⁰ and so close to |α′(t)|. So does it at a
        /// singular t, where L′ = |α′| = 0.
        #[test]
        fn the_derivative_of_the_length_is_the_speed(curve in polynomial_curve(), t in parameter()) {
            let h = q(1, 1 << 20);
            let goal = Goal { width: Rational::from(1) >> 60, cells: 1 << 12 };
            let step = length(&curve, &t, &Rational::from(&t + &h), &goal);
            let quotient = step * &Interval::from_rational(&h.recip(), 200);
            let velocity = curve.derivative().point(&t).expect("a polynomial");
            let speed = Interval::from_rational(&velocity.norm_squared(), 200).sqrt().expect("not negative");
            let (lo, hi) = (quotient - &speed).abs().bounds().expect("finite");
            prop_assert!(lo <= hi && hi < q(1, 50));
        }
    }

    #[test]
    fn the_length_is_differentiable_at_a_singular_parameter_too() {
        // Of the cusp, L(t) = ((9t² + 4)^(3/2) − 8)/27 for t ≥ 0, and L(h)/h → 0 = |α′(0)|.
        let goal = Goal::digits(15);
        let step = length(&cusp(), &q(0, 1), &q(1, 1000), &goal);
        assert!(step.bounds().expect("finite").1 * 1000_u32 < q(2, 1000));
        assert_eq!(cusp().singular_parameters(), SingularParameters::At(vec![Algebraic::from(q(0, 1))]));
    }

    #[test]
    fn a_differentiable_curve_may_have_no_length() {
        // (t, t² sin 1/t²), 0 at 0: at t² = 1/((k + 1/2)π) its height is ±t², so the swings up to k = n add up to more than
        // Σ 1/((k + 1/2)π), which passes every bound.
        let swings = |n: i64| {
            let sum = (0..n).fold(Rational::new(), |sum, k| sum + q(2, 2 * k + 1));
            Interval::from_rational(&sum, 100)
                .checked_div(&Interval::pi(100))
                .expect("π > 0")
                .bounds()
                .expect("finite")
                .0
        };
        assert!(swings(200) > swings(20) + q(2, 3) && swings(2000) > swings(200) + q(2, 3));
    }
}

mod cu_21 {
    use super::*;

    #[test]
    fn at_unit_speed_the_length_is_the_time() {
        let line = RationalCurve::polynomial([
            Polynomial::new(vec![q(7, 1), q(3, 5)]),
            Polynomial::new(vec![q(0, 1), q(-4, 5)]),
        ]);
        assert_eq!(polynomial_speed(&line), Some(p(&[1])));
        let t0 = q(-2, 3);
        assert_eq!(antiderivative(&p(&[1]), &t0), Polynomial::with_root(&t0));
        let goal = Goal::digits(9);
        assert!(is_within(&arc_length(&line, [&t0, &q(5, 1)], &goal).expect("no pole"), &goal, &over(number(17), 3)));
    }
}

mod cu_22 {
    use super::*;

    #[test]
    fn two_base_points_differ_by_a_constant_and_two_directions_by_the_sign() {
        let length =
            |curve: &RationalCurve<2>, t0: &Rational| antiderivative(&polynomial_speed(curve).expect("a square"), t0);
        let (one, other) = (length(&pythagorean(), &q(0, 1)), length(&pythagorean(), &q(3, 2)));
        assert!((one - &other).degree() == Some(0));
        // The other way along the line (t, 0): from s to −s.
        let line = curve(&[0, 1], &[]);
        let reversed = line.reversed();
        let t = q(5, 1);
        assert_eq!(line.point(&t), reversed.point(&-t.clone()));
        let (s, back) = (length(&line, &q(0, 1)).evaluate(&t), length(&reversed, &q(0, 1)).evaluate(&-t));
        assert_eq!((s.clone(), back), (q(5, 1), q(-5, 1)));
        assert_ne!(s.clone() - q(-5, 1), q(0, 1), "no constant for both 5 and −5");
    }
}

mod cu_23 {
    use super::*;

    #[test]
    fn the_tangent_of_a_circle_is_perpendicular_to_its_radius() {
        let [c, s, r] = CirclePolynomial::<3>::variables();
        let circle = [c * &r, s * &r];
        let velocity = circle.each_ref().map(CirclePolynomial::derivative);
        let dot =
            |a: &[CirclePolynomial<3>; 2], b: &[CirclePolynomial<3>; 2]| a[0].clone() * &b[0] + &(a[1].clone() * &b[1]);
        assert_eq!(dot(&circle, &velocity), CirclePolynomial::integer(0));
        assert_eq!(dot(&velocity, &velocity), r.clone() * &r);
        assert_eq!(velocity, [-circle[1].clone(), circle[0].clone()]);
    }

    #[test]
    fn its_length_is_two_pi_r() {
        let goal = Goal::digits(12);
        let [c, s] = CirclePolynomial::<2>::variables();
        for r in [1, 7] {
            let radius = CirclePolynomial::integer(r);
            let circle = [c.clone() * &radius, s.clone() * &radius];
            let turn = length_of_turns(&circle, [&q(0, 1), &q(1, 1)], &goal).expect("well-posed");
            assert!(is_within(&turn, &goal, &(Interval::pi(200) * &number(2 * r))));
        }
    }
}

mod cu_24 {
    use super::*;

    #[test]
    fn a_composition_need_be_neither_regular_nor_the_same_trace() {
        let line = curve(&[0, 1], &[]);
        let polynomial = |h: &[i64]| RationalCurve::polynomial([p(h)]);
        let cubed = line.reparametrised(&polynomial(&[0, 0, 0, 1])).expect("no constant");
        assert_eq!(cubed.singular_parameters(), SingularParameters::At(vec![Algebraic::from(q(0, 1))]));
        let constant = line.reparametrised(&polynomial(&[2])).expect("no pole");
        assert_eq!(constant.singular_parameters(), SingularParameters::Everywhere);
        // t² reaches only half of the line.
        let squared = line.reparametrised(&polynomial(&[0, 0, 1])).expect("no constant");
        assert_eq!(squared, curve(&[0, 0, 1], &[]));
        // At a pole there is nothing to compose with.
        let hyperbola = RationalCurve::new([p(&[1]), p(&[0, 1])], p(&[0, 1])).expect("a denominator");
        assert!(hyperbola.reparametrised(&polynomial(&[])).is_err());
    }

    proptest! {
        /// With h′ > 0 regular curves stay regular, and lengths stay what they are.
        #[test]
        fn a_change_of_parameter_keeps_regularity(curve in polynomial_curve(), a in 1..4_i64, b in 0..3_i64) {
            // h = at + bt³ is a bijection of ℝ, h′ ≥ a > 0.
            let h = RationalCurve::polynomial([p(&[0, a, 0, b])]);
            let changed = curve.reparametrised(&h).expect("no pole");
            let count = |curve: &RationalCurve<2>| match curve.singular_parameters() {
                SingularParameters::Everywhere => None,
                SingularParameters::At(roots) => Some(roots.len()),
            };
            prop_assert_eq!(count(&changed), count(&curve));
        }
    }
}

mod cu_25 {
    use super::*;

    proptest! {
        #[test]
        fn the_chain_rule(curve in rational_curve(), h in rational_curve(), s in parameter()) {
            let [top, _] = h.numerators();
            let h = RationalCurve::new([top.clone()], h.denominator().clone()).expect("a denominator");
            let Some(Vector([t])) = h.point(&s) else { return Ok(()) };
            let Ok(composed) = curve.reparametrised(&h) else { return Ok(()) };
            let Some(velocity) = curve.derivative().point(&t) else { return Ok(()) };
            prop_assert_eq!(composed.point(&s), curve.point(&t));
            let Vector([slope]) = h.derivative().point(&s).expect("h is defined at s");
            prop_assert_eq!(composed.derivative().point(&s), Some(velocity.scaled(&slope)));
        }
    }
}

mod cu_26 {
    use super::*;

    #[test]
    fn by_its_arc_length_a_curve_has_unit_speed() {
        // β(s) = α(t(s)): the chord from s to s + h has the length h, but for h³.
        let curve = pythagorean();
        let h = q(1, 1 << 12);
        for s in [q(0, 1), q(4, 3), q(-7, 2), q(100, 1)] {
            let [a, b] = [s.clone(), Rational::from(&s + &h)].map(|s| {
                let t = parameter_at_length(&curve, &q(0, 1), &s).expect("a polynomial speed").refined(100);
                curve.point(t.bounds().0).expect("a polynomial")
            });
            let ratio = (b + &-a).norm_squared() / h.clone().square();
            assert!(ratio <= q(1_000_001, 1_000_000) && ratio > q(999_999, 1_000_000), "{ratio}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        /// The length is that of the trace, whatever the parameter: h = (t + t³)/2 maps [0, 1] onto itself.
        #[test]
        fn length_does_not_depend_on_the_parameter(curve in polynomial_curve()) {
            let h = RationalCurve::polynomial([Polynomial::new(vec![q(0, 1), q(1, 2), q(0, 1), q(1, 2)])]);
            let changed = curve.reparametrised(&h).expect("no pole");
            let goal = Goal::digits(5);
            let (zero, one) = (q(0, 1), q(1, 1));
            let [a, b, c] = [(&curve, &zero, &one), (&changed, &zero, &one), (&curve.reversed(), &q(-1, 1), &zero)]
                .map(|(curve, from, to)| length(curve, from, to, &goal));
            prop_assert!(a.intersection(&b).is_some() && a.intersection(&c).is_some());
        }
    }
}

mod cu_27 {
    use super::*;

    #[test]
    fn the_length_from_the_end_of_the_interval_need_not_exist() {
        // (1/t, 0) on (0, 1) is regular; from a = 0 there is no length, from t₀ = 1/2 there is.
        let ray = RationalCurve::new([p(&[1]), p(&[])], p(&[0, 1])).expect("a denominator");
        assert_eq!(ray.singular_parameters(), SingularParameters::At(Vec::new()));
        let goal = Goal::digits(9);
        let printed = arc_length(&ray, [&q(0, 1), &q(1, 1)], &goal);
        assert_eq!(printed.expect_err("a pole"), QuadratureError::Pole);
        assert!(is_within(&arc_length(&ray, [&q(1, 2), &q(1, 1)], &goal).expect("no pole"), &goal, &number(1)));
        // From ε it is 1/ε − 1, beyond every bound.
        let long = arc_length(&ray, [&q(1, 1000), &q(1, 1)], &goal).expect("no pole");
        assert!(is_within(&long, &goal, &number(999)));
    }
}

mod cu_28 {
    use super::*;

    #[test]
    fn the_length_is_increasing_and_its_inverse_has_the_inverse_slope() {
        let curve = pythagorean();
        let speed = polynomial_speed(&curve).expect("a square");
        assert_eq!(speed, p(&[1, 0, 1]));
        let s = antiderivative(&speed, &q(0, 1));
        for t in [q(-3, 1), q(0, 1), q(1, 2), q(5, 1)] {
            assert_eq!(parameter_at_length(&curve, &q(0, 1), &s.evaluate(&t)), Some(Algebraic::from(t.clone())));
            // dt/ds = 1/(ds/dt): the difference quotients are within 2⁻¹⁵ of each other.
            let h = q(1, 1 << 20);
            let next = s.evaluate(&Rational::from(&t + &h)) - s.evaluate(&t);
            let slope: Rational = h / next - Rational::from(speed.evaluate(&t).recip_ref());
            assert!(slope.abs() < q(1, 1 << 15));
        }
        // A speed with a zero is no such one, nor is one that is no polynomial.
        assert_eq!(polynomial_speed(&curve_of_speed_t()), Some(p(&[0, 2])));
        assert_eq!(parameter_at_length(&curve_of_speed_t(), &q(0, 1), &q(1, 1)), None);
        assert_eq!(polynomial_speed(&super::cusp()), None);
    }

    fn curve_of_speed_t() -> RationalCurve<2> {
        curve(&[0, 0, 1], &[])
    }

    proptest! {
        #[test]
        fn roots_of_squares_are_found(a in prop::collection::vec(parameter(), 0..5)) {
            use isoracle::curvature::crossing::square_root;
            let f = Polynomial::new(a);
            let root = square_root(&(f.clone() * &f)).expect("a square");
            prop_assert!(root == f || root == -f.clone());
            prop_assert!(root.coefficients().last().is_none_or(|a| *a > 0));
            if f.degree().is_some_and(|n| n > 0) {
                prop_assert_eq!(square_root(&(f.clone() * &f + &p(&[1]))), None);
                prop_assert_eq!(square_root(&(f.clone() * &f * &p(&[-1]))), None);
            }
        }
    }
}

mod cu_29 {
    use super::*;

    #[test]
    fn inscribed_polygons_come_close_from_below() {
        let goal = Goal::digits(12);
        let arc = length(&rational_circle(), &q(0, 1), &q(1, 1), &goal);
        let sides = |n: i64| {
            let parameters: Vec<Rational> = (0..=n).map(|i| q(i, n)).collect();
            polygon_length(&rational_circle(), &parameters, 100).expect("no pole").bounds().expect("finite")
        };
        let (lo, hi) = arc.bounds().expect("finite");
        // Each side of angle θ falls short by θ³/24.
        for (n, gap) in [(8, q(1, 100)), (64, q(1, 10_000))] {
            assert!(sides(n).1 < lo && sides(n).0 > Rational::from(&hi - &gap));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10))]

        #[test]
        fn lengths_scale_and_keep_under_motions(curve in polynomial_curve(), k in 1..5_i64) {
            let goal = Goal::digits(5);
            let (zero, one) = (q(0, 1), q(1, 1));
            let old = length(&curve, &zero, &one, &goal);
            let polygon = polygon_length(&curve, &[zero.clone(), q(1, 3), one.clone()], 100).expect("no pole");
            prop_assert!(polygon.bounds().expect("finite").0 <= old.bounds().expect("finite").1);
            // Turned by 3/5, 4/5, reflected, moved, and k times as large.
            let scale = q(k, 5);
            let turn = Matrix([[q(3, 1), q(4, 1)], [q(4, 1), q(-3, 1)]].map(|row| row.map(|x| x * &scale)));
            let new = length(&curve.moved(&turn, &Vector([q(2, 1), q(-7, 3)])), &zero, &one, &goal);
            prop_assert!((old * &Interval::from_rational(&q(k, 1), 100)).intersection(&new).is_some());
        }
    }
}
