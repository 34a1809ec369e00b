//! Frames, curvature, osculating circles (002, 2(b)).

use super::curves::{curve, p, parameter, polynomial_curve, rational_circle, rational_curve};
use super::q;
use isoracle::curvature::circle_polynomial::CirclePolynomial;
use isoracle::curvature::curve_printed::{
    circle_arc_length_printed, circle_turns_printed, inverse_radius_squared_printed,
};
use isoracle::curvature::frame::{Frame, OsculationError, contact, osculating_circle, quarter_turn, tangent_contact};
use isoracle::curvature::rational_curve::RationalCurve;
use isoracle::linear::{Matrix, Vector, determinant2};
use isoracle::number::{OrderedField, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

fn frame(curve: &RationalCurve<2>, t: &Rational) -> Option<Frame> {
    Frame::new(&curve.jets(t)?).ok()
}

/// The frame at a parameter where the curve is regular.
fn regular(curve: &RationalCurve<2>, t: i64) -> Frame {
    frame(curve, &q(t, 1)).expect("regular")
}

fn surds(v: &Vector<Rational, 2>) -> Vector<Surd, 2> {
    v.map(|x| Surd::from(x.clone()))
}

fn parabola() -> RationalCurve<2> {
    curve(&[0, 1], &[0, 0, 1])
}

mod cu_32 {
    use super::*;

    proptest! {
        #[test]
        fn t_and_n_are_a_positive_orthonormal_basis(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let (t, n) = (frame.tangent(), frame.normal());
            let one = Surd::from(q(1, 1));
            prop_assert_eq!((t.norm_squared(), n.norm_squared()), (one.clone(), one.clone()));
            prop_assert_eq!(t.dot(&n).sign(), Sign::Zero);
            prop_assert_eq!(determinant2(&Matrix::from_columns(&[t, n])), one);
        }
    }

    #[test]
    fn j_turns_counterclockwise() {
        let turned = quarter_turn(&Vector([q(3, 1), q(1, 1)]));
        assert_eq!(turned, Vector([q(-1, 1), q(3, 1)]));
        assert_eq!(quarter_turn(&turned), Vector([q(-3, 1), q(-1, 1)]));
    }
}

mod cu_33 {
    use super::*;

    #[test]
    fn more_than_two_vectors_are_orthogonal_but_only_two_of_unit_length() {
        let t = Vector([q(3, 5), q(4, 5)]);
        let n = quarter_turn(&t);
        for k in [q(1, 1), q(-1, 1), q(2, 1), q(0, 1)] {
            assert!(t.dot(&n.scaled(&k)).is_zero());
        }
        // The orthogonal vectors are the kn, of the length |k|: two for k² = 1, and 2n is a third.
        assert!(n.scaled(&q(2, 1)) != n && n.scaled(&q(2, 1)) != -n);
    }
}

mod cu_34 {
    use super::*;

    proptest! {
        #[test]
        fn dt_is_across_t_and_dn_across_n(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let (dt, dn) = (frame.tangent_derivative(), quarter_turn(&frame.tangent_derivative()));
            let (t, n) = (frame.tangent(), frame.normal());
            prop_assert_eq!(surds(&dt).dot(&t).sign(), Sign::Zero);
            prop_assert_eq!(surds(&dn).dot(&n).sign(), Sign::Zero);
            prop_assert_eq!((surds(&dt).dot(&n) + &t.dot(&surds(&dn))).sign(), Sign::Zero);
        }
    }
}

mod cu_35 {
    use super::*;

    #[test]
    fn kappa_is_a_number_that_carries_n_to_dt() {
        let frame = regular(&parabola(), 0);
        assert_eq!(frame.kappa(), Surd::from(q(2, 1)));
        assert_eq!(frame.normal().scaled(&frame.kappa()), surds(&frame.tangent_derivative()));
        // The vector dt/ds in the place of κ has no such product: ⟨dt/ds, n⟩ is a number, dt/ds = (0, 2) none.
        assert_eq!(frame.tangent_derivative(), Vector([q(0, 1), q(2, 1)]));
    }
}

mod cu_36 {
    use super::*;

    proptest! {
        #[test]
        fn frenets_equations(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            // By the quotient rule, and n = Jt, on the left; κ on the right.
            prop_assert_eq!(frame.tangent_derivative(), frame.kappa_normal());
            prop_assert_eq!(quarter_turn(&frame.tangent_derivative()), frame.minus_kappa_tangent());
            prop_assert_eq!(frame.normal().scaled(&frame.kappa()), surds(&frame.kappa_normal()));
            prop_assert_eq!(frame.tangent().scaled(&-frame.kappa()), surds(&frame.minus_kappa_tangent()));
        }
    }

    #[test]
    fn dt_is_the_limit_of_its_difference_quotients() {
        // On (t, t²): t(h) − t(0) over the length between them, which is h but for h³.
        let h = q(1, 1 << 20);
        let [here, there] = [q(0, 1), h.clone()].map(|t| frame(&parabola(), &t).expect("regular").tangent());
        let step = |i: usize| (there[i].enclosure(200) - &here[i].enclosure(200)).bounds().expect("finite");
        assert!((step(0).1 / &h).abs() < q(1, 1000));
        assert!((step(1).0 / &h - q(2, 1)).abs() < q(1, 1000));
    }
}

mod cu_37 {
    use super::*;

    proptest! {
        #[test]
        fn kappa_is_the_length_of_the_second_derivative_by_arc_length(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let kappa = frame.kappa();
            prop_assert_eq!(kappa.clone() * &kappa, Surd::from(frame.tangent_derivative().norm_squared()));
        }
    }

    #[test]
    fn it_is_not_the_length_of_any_second_derivative() {
        // (t², t²) runs along a line: κ = 0, |α″| = 2√2.
        let line = curve(&[0, 0, 1], &[0, 0, 1]);
        assert_eq!(regular(&line, 1).kappa(), Surd::from(q(0, 1)));
        assert_eq!(line.derivative().derivative().point(&q(1, 1)), Some(Vector([q(2, 1), q(2, 1)])));
    }
}

mod cu_38 {
    use super::*;

    proptest! {
        #[test]
        fn at_unit_speed_kappa_is_the_determinant(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let jets = curve.jets(&t).expect("defined");
            let [v, a] = [jets.each_ref().map(|f| f.gradient[0].clone()), jets.each_ref().map(|f| f.hessian.0[0][0].clone())];
            let determinant = determinant2(&Matrix([[v[0].clone(), a[0].clone()], [v[1].clone(), a[1].clone()]]));
            prop_assert_eq!(frame.acceleration_across(), determinant.clone());
            // d/ds = (1/|α′|) d/dt: both vectors by the arc length.
            let by_length = determinant2(&Matrix::from_columns(&[frame.tangent(), surds(&frame.tangent_derivative())]));
            prop_assert_eq!(by_length, frame.kappa());
        }
    }

    #[test]
    fn at_another_speed_it_is_not() {
        // (2t, 4t²) at 0: det = 16, κ = 2.
        let fast = curve(&[0, 2], &[0, 0, 4]);
        assert_eq!(
            (regular(&fast, 0).acceleration_across(), regular(&fast, 0).kappa()),
            (q(16, 1), Surd::from(q(2, 1)))
        );
    }
}

mod cu_39 {
    use super::*;

    proptest! {
        /// κ > 0 iff the curve leaves its tangent to the left, the side of n.
        #[test]
        fn the_sign_is_the_side_of_the_tangent(curve in polynomial_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let velocity = curve.derivative().point(&t).expect("a polynomial");
            let normal = quarter_turn(&velocity);
            let here = curve.point(&t).expect("a polynomial");
            let side = |h: &Rational| {
                let step = curve.point(&Rational::from(&t + h)).expect("a polynomial") + &-here.clone();
                Sign::of(step.dot(&normal).cmp0())
            };
            let h = q(1, 1 << 40);
            if frame.kappa().sign() != Sign::Zero {
                prop_assert_eq!(side(&h), frame.kappa().sign());
                prop_assert_eq!(side(&-h), frame.kappa().sign());
            }
        }
    }

    #[test]
    fn left_is_positive() {
        assert_eq!(regular(&rational_circle(), 0).kappa(), Surd::from(q(1, 1)));
        assert_eq!(regular(&rational_circle().reversed(), 0).kappa(), Surd::from(q(-1, 1)));
    }
}

mod cu_40 {
    use super::*;

    #[test]
    fn between_two_signs_the_curvature_is_0_but_not_every_0_is_an_inflection() {
        let cubic = curve(&[0, 1], &[0, 0, 0, 1]);
        assert_eq!([-1, 0, 1].map(|t| regular(&cubic, t).kappa().sign()), [Sign::Negative, Sign::Zero, Sign::Positive]);
        assert_eq!(tangent_contact(&cubic, &q(0, 1)), Ok(Some(3)));
        let quartic = curve(&[0, 1], &[0, 0, 0, 0, 1]);
        assert_eq!(
            [-1, 0, 1].map(|t| regular(&quartic, t).kappa().sign()),
            [Sign::Positive, Sign::Zero, Sign::Positive]
        );
        assert_eq!(tangent_contact(&quartic, &q(0, 1)), Ok(Some(4)));
        assert_eq!(tangent_contact(&curve(&[0, 1], &[5, 2]), &q(0, 1)), Ok(None));
        assert!(tangent_contact(&curve(&[0, 0, 1], &[0, 0, 0, 1]), &q(0, 1)).is_err());
    }

    proptest! {
        #[test]
        fn the_tangent_is_met_twice_iff_the_curvature_is_not_0(curve in rational_curve(), t in parameter()) {
            let Some(frame) = frame(&curve, &t) else { return Ok(()) };
            let contact = tangent_contact(&curve, &t).expect("regular");
            prop_assert_eq!(frame.kappa().sign() != Sign::Zero, contact == Some(2));
            prop_assert!(contact.is_none_or(|m| m >= 2));
        }
    }
}

mod cu_41 {
    use super::*;

    #[test]
    fn without_curvature_there_is_no_circle() {
        let cubic = curve(&[0, 1], &[0, 0, 0, 1]);
        assert_eq!(osculating_circle(&cubic, &q(0, 1)), Err(OsculationError::Flat));
        let pole = RationalCurve::new([p(&[1]), p(&[1, 1])], p(&[0, 1])).expect("a denominator");
        assert!(matches!(osculating_circle(&pole, &q(0, 1)), Err(OsculationError::Curve(_))));
        assert!(matches!(
            osculating_circle(&curve(&[0, 0, 1], &[0, 0, 0, 1]), &q(0, 1)),
            Err(OsculationError::Curve(_))
        ));
        // Circles that touch y = x³ at 0 leave it at the second order, whatever their radius: the larger the closer.
        for r in [1, 10, 1000] {
            let circle =
                isoracle::curvature::frame::Circle { centre: Vector([q(0, 1), q(r, 1)]), radius_squared: q(r * r, 1) };
            assert_eq!(contact(&cubic, &circle, &q(0, 1)), Some(2));
        }
    }

    proptest! {
        /// No other circle meets the curve three times there.
        #[test]
        fn the_circle_is_the_one_of_the_second_order(curve in rational_curve(), t in parameter(), [x, y] in prop::array::uniform2(parameter())) {
            let Ok(circle) = osculating_circle(&curve, &t) else { return Ok(()) };
            prop_assert!(contact(&curve, &circle, &t).is_none_or(|m| m >= 3));
            let point = curve.point(&t).expect("defined");
            prop_assert_eq!((point.clone() + &-circle.centre.clone()).norm_squared(), circle.radius_squared.clone());
            let centre = circle.centre.clone() + &Vector([x, y]);
            let radius_squared = (point + &-centre.clone()).norm_squared();
            let other = isoracle::curvature::frame::Circle { centre, radius_squared };
            prop_assert_eq!(contact(&curve, &other, &t).is_none_or(|m| m >= 3), other == circle);
        }
    }
}

mod cu_42 {
    use super::*;

    #[test]
    fn the_inverse_radius_has_lost_the_sign() {
        for curve in [rational_circle(), rational_circle().reversed()] {
            let circle = osculating_circle(&curve, &q(0, 1)).expect("curved");
            assert_eq!(inverse_radius_squared_printed(&circle.radius_squared), q(1, 1));
        }
        assert_eq!(regular(&rational_circle().reversed(), 0).kappa(), Surd::from(q(-1, 1)));
    }

    proptest! {
        #[test]
        fn its_square_is_that_of_the_curvature(curve in rational_curve(), t in parameter()) {
            let Ok(circle) = osculating_circle(&curve, &t) else { return Ok(()) };
            let kappa = frame(&curve, &t).expect("regular").kappa();
            prop_assert_eq!(kappa.clone() * &kappa, Surd::from(inverse_radius_squared_printed(&circle.radius_squared)));
            // The centre is on the side of n iff κ > 0.
            let normal = quarter_turn(&curve.derivative().point(&t).expect("defined"));
            let side = (circle.centre + &-curve.point(&t).expect("defined")).dot(&normal);
            prop_assert_eq!(Sign::of(side.cmp0()), kappa.sign());
        }
    }
}

mod cu_43 {
    use super::*;

    #[test]
    fn of_circles_run_clockwise_the_larger_has_the_larger_curvature() {
        let clockwise = |r: i64| {
            rational_circle().reversed().moved(&Matrix([[q(r, 1), q(0, 1)], [q(0, 1), q(r, 1)]]), &Vector::zero())
        };
        let [small, large] = [1, 2].map(|r| regular(&clockwise(r), 0).kappa());
        assert!(large > small);
        let [small, large] = [1, 2].map(|r| regular(&clockwise(r).reversed(), 0).kappa());
        assert!(large < small);
        let radius = |r: i64| osculating_circle(&clockwise(r), &q(0, 1)).expect("curved").radius_squared;
        assert_eq!([radius(1), radius(2)], [q(1, 1), q(4, 1)]);
    }
}

mod cu_44 {
    use super::*;
    use isoracle::curvature::circle_polynomial::least_period;
    use isoracle::curvature::rational_curve::Period;

    #[test]
    fn the_printed_domain_is_one_turn_for_r_1_only() {
        let circle = CirclePolynomial::<2>::variables();
        for (r, turns) in [(q(1, 1), q(1, 1)), (q(2, 1), q(1, 2)), (q(1, 3), q(3, 1))] {
            // The period in t is r turns of 2π.
            assert_eq!(least_period(&circle, &r.clone().recip()), Period::Turns(r.clone()));
            assert_eq!(circle_turns_printed(&r), turns);
        }
        // r = 2: it ends at t/r = π, at c − (r, 0).
        let [c, s] = circle;
        assert_eq!([c.at_quarter_turns(2, &[]), s.at_quarter_turns(2, &[])], [q(-1, 1), q(0, 1)]);
    }
}

mod cu_45 {
    use super::*;
    use crate::quadrature::is_within;
    use isoracle::curvature::arc_length::length_of_turns;
    use isoracle::curvature::curve_printed::circle_arc_length;
    use isoracle::curvature::quadrature::Goal;
    use isoracle::number::Interval;

    #[test]
    fn the_curve_has_unit_speed_already() {
        // α′ = r·(1/r)(−sin, cos): with w = 1/r for a constant, rw = 1.
        let [c, s, w] = CirclePolynomial::<3>::variables();
        let speed = |r: &CirclePolynomial<3>| {
            let v = [c.clone() * r, s.clone() * r].map(|x| x.derivative() * &w);
            v[0].clone() * &v[0] + &(v[1].clone() * &v[1])
        };
        let r = CirclePolynomial::integer(5);
        // (rw)², which is 1 for w = 1/r.
        assert_eq!(speed(&r), CirclePolynomial::integer(25) * &w * &w);
        assert_eq!(speed(&r).at_slope(&q(1, 7), &[q(1, 5)]), q(1, 1));
        assert_eq!(circle_arc_length(&q(3, 1)), q(3, 1));
        assert_eq!(circle_arc_length_printed(&q(5, 1), &q(3, 1)), q(15, 1));
    }

    #[test]
    fn its_length_is_t_and_not_rt() {
        // r = 2: from t = 0 to π the angle runs a quarter, of the length π; printed 2π.
        let [c, s] = CirclePolynomial::<2>::variables();
        let two = CirclePolynomial::integer(2);
        let goal = Goal::digits(9);
        let arc = length_of_turns(&[c * &two, s * &two], [&q(0, 1), &q(1, 4)], &goal).expect("well-posed");
        let pi = Interval::pi(100);
        assert!(is_within(&arc, &goal, &pi) && !is_within(&arc, &goal, &(pi.clone() + &pi)));
    }
}

mod cu_46 {
    use super::*;

    #[test]
    fn by_its_length_a_circle_has_the_printed_frame_and_curvature() {
        // d/ds of functions of s/r is w·d/dθ, w = 1/r; β = c + r(cos, sin), and rw = 1 is put in by hand.
        let [c, s, w] = CirclePolynomial::<3>::variables();
        let t = [-s.clone(), c.clone()];
        let dt = t.each_ref().map(|x| x.derivative() * &w);
        assert_eq!(dt, [-(c.clone() * &w), -(s.clone() * &w)]);
        let n = [-t[1].clone(), t[0].clone()];
        assert_eq!(n, [-c, -s]);
        let kappa = dt[0].clone() * &n[0] + &(dt[1].clone() * &n[1]);
        assert_eq!(kappa, w);
    }
}

mod cu_47 {
    use super::*;

    proptest! {
        #[test]
        fn a_change_of_parameter_keeps_kappa_but_for_the_direction(curve in rational_curve(), h in rational_curve(), s in parameter()) {
            let [top, _] = h.numerators();
            let h = RationalCurve::new([top.clone()], h.denominator().clone()).expect("a denominator");
            let (Some(Vector([t])), Some(Vector([slope]))) = (h.point(&s), h.derivative().point(&s)) else { return Ok(()) };
            let (Ok(changed), Some(old)) = (curve.reparametrised(&h), frame(&curve, &t)) else { return Ok(()) };
            let new = frame(&changed, &s).map(|frame| frame.kappa());
            prop_assert_eq!(new, match Sign::of(slope.cmp0()) {
                Sign::Positive => Some(old.kappa()),
                Sign::Negative => Some(-old.kappa()),
                Sign::Zero => None,
            });
        }

        #[test]
        fn it_is_that_of_the_printed_formula(curve in rational_curve(), t in parameter()) {
            use isoracle::curvature::parametric_curve::curvature;
            let Some(jets) = curve.jets(&t) else { return Ok(()) };
            let kappa = Frame::new(&jets).map(|frame| frame.kappa());
            let squared = kappa.clone().map(|k| (k.clone() * &k, k.sign()));
            prop_assert_eq!(squared, curvature(&jets).map(|c| (Surd::from(c.kappa_squared), c.kappa_sign)));
        }
    }
}

mod cu_48 {
    use super::*;

    proptest! {
        #[test]
        fn motions_keep_kappa_reflections_turn_its_sign_and_scaling_divides_it(
            curve in rational_curve(), t in parameter(), m in parameter(), k in 1..5_i64, [x, y] in prop::array::uniform2(parameter()),
        ) {
            let Some(old) = frame(&curve, &t) else { return Ok(()) };
            let Vector([c, s]) = rational_circle().point(&m).expect("no pole");
            let v = Vector([x, y]);
            let kappa = |a: Matrix<Rational, 2, 2>| frame(&curve.moved(&a, &v), &t).expect("regular").kappa();
            let turn = |sign: i64, k: &Rational| Matrix([
                [Rational::from(&c * k), -Rational::from(&s * k) * sign],
                [Rational::from(&s * k), Rational::from(&c * k) * sign],
            ]);
            let one = q(1, 1);
            prop_assert_eq!(kappa(turn(1, &one)), old.kappa());
            prop_assert_eq!(kappa(turn(-1, &one)), -old.kappa());
            prop_assert_eq!(kappa(turn(1, &q(k, 1))) * &Surd::from(q(k, 1)), old.kappa());
        }
    }
}

mod cu_49 {
    use super::*;
    use crate::quadrature::is_within;
    use isoracle::curvature::arc_length::length_of_turns;
    use isoracle::curvature::quadrature::Goal;
    use isoracle::number::Interval;

    #[test]
    fn the_ellipse_for_all_t_a_and_b() {
        let [c, s, a, b] = CirclePolynomial::<4>::variables();
        let [x1, y1] = [c.clone() * &a, s.clone() * &b].map(|f| f.derivative());
        let [x2, y2] = [&x1, &y1].map(CirclePolynomial::derivative);
        assert_eq!(x1.clone() * &y2 - &(x2 * &y1), a.clone() * &b);
        let speed = a.clone() * &a * &s * &s + &(b.clone() * &b * &c * &c);
        assert_eq!(x1.clone() * &x1 + &(y1.clone() * &y1), speed);
        // a = 3, b = −2: clockwise, κ = −6/(…)^(3/2) < 0; at t = 0: −6/8.
        let at = |f: &CirclePolynomial<4>| f.at_quarter_turns(0, &[q(3, 1), q(-2, 1)]);
        assert_eq!((at(&(a * &b)), at(&speed)), (q(-6, 1), q(4, 1)));
    }

    #[test]
    fn at_rational_points_it_is_the_curvature_of_the_rational_ellipse() {
        for (a, b) in [(3, 2), (3, -2), (-1, 5), (2, 2)] {
            let ellipse = rational_circle().moved(&Matrix([[q(a, 1), q(0, 1)], [q(0, 1), q(b, 1)]]), &Vector::zero());
            for m in [q(0, 1), q(1, 3), q(-5, 2)] {
                let Vector([c, s]) = rational_circle().point(&m).expect("no pole");
                let w = s.square() * (a * a) + c.square() * (b * b);
                let printed = Surd::new(q(0, 1), q(a * b, 1) / &w / &w, &w).expect("positive");
                assert_eq!(frame(&ellipse, &m).expect("regular").kappa(), printed);
            }
        }
    }

    /// Gauss: the length is 2π/M(a, b)·(a² − Σ 2ⁿ⁻¹cₙ²), c₀² = a² − b², cₙ₊₁ = (aₙ − bₙ)/2.
    #[test]
    fn its_length_is_that_of_the_arithmetic_geometric_mean() {
        let number = |n: i64| Interval::from_rational(&q(n, 1), 200);
        let half = Interval::from_rational(&q(1, 2), 200);
        let (mut a, mut b) = (number(3), number(2));
        let mut sum = number(9) - &(number(5) * &half);
        for n in 0..8 {
            let c = (a.clone() - &b) * &half;
            sum = sum - &(c.square() * &number(1 << n));
            (a, b) = ((a.clone() + &b) * &half, (a * &b).sqrt().expect("positive"));
        }
        let truth = (Interval::pi(200) * &number(2) * &sum).checked_div(&a).expect("positive");
        // The terms left out are less than 10⁻⁵⁰.
        let [c, s] = CirclePolynomial::<2>::variables();
        let ellipse = [c * &CirclePolynomial::integer(3), s * &CirclePolynomial::integer(2)];
        let goal = Goal::digits(12);
        assert!(is_within(&length_of_turns(&ellipse, [&q(0, 1), &q(1, 1)], &goal).expect("well-posed"), &goal, &truth));
        assert!(truth.width().expect("finite") < q(1, 1_000_000_000_000_000));
    }
}
