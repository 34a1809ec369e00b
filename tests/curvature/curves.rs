//! Curves by a parametrisation: regular, closed, periodic, simple (002, 2(a)).

use super::q;
use isoracle::curvature::circle_polynomial::{CirclePolynomial, least_period};
use isoracle::curvature::crossing::{Crossings, crossing_polynomial, crossings, share_a_point};
use isoracle::curvature::rational_curve::{
    Closing, End, Period, RationalCurve, SingularParameters, agreeing_derivatives,
};
use isoracle::linear::Vector;
use isoracle::number::{Algebraic, Polynomial, Rational, Ring};
use proptest::prelude::*;

/// a₀ + a₁t + …
pub fn p(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|a| Rational::from(*a)).collect())
}

pub fn curve(x: &[i64], y: &[i64]) -> RationalCurve<2> {
    RationalCurve::polynomial([p(x), p(y)])
}

/// ((1 − t²)/(1 + t²), 2t/(1 + t²)).
pub fn rational_circle() -> RationalCurve<2> {
    RationalCurve::new([p(&[1, 0, -1]), p(&[0, 2])], p(&[1, 0, 1])).expect("a denominator")
}

pub fn cusp() -> RationalCurve<2> {
    curve(&[0, 0, 0, 1], &[0, 0, 1])
}

fn node() -> RationalCurve<2> {
    curve(&[0, -4, 0, 1], &[-4, 0, 1])
}

fn at(x: i64, y: i64) -> Vector<Rational, 2> {
    Vector([q(x, 1), q(y, 1)])
}

fn numbers(values: &[i64]) -> Vec<Algebraic> {
    values.iter().map(|x| Algebraic::from(q(*x, 1))).collect()
}

/// Small polynomial curves.
pub fn polynomial_curve() -> impl Strategy<Value = RationalCurve<2>> {
    let polynomial = || prop::collection::vec(-4..=4_i64, 0..5).prop_map(|a| p(&a));
    (polynomial(), polynomial()).prop_map(|(x, y)| RationalCurve::polynomial([x, y]))
}

pub fn rational_curve() -> impl Strategy<Value = RationalCurve<2>> {
    let polynomial = || prop::collection::vec(-4..=4_i64, 0..4).prop_map(|a| p(&a));
    let denominator = polynomial().prop_filter("not zero", |q| !q.is_zero());
    (polynomial(), polynomial(), denominator)
        .prop_map(|(x, y, d)| RationalCurve::new([x, y], d).expect("a denominator"))
}

pub fn parameter() -> impl Strategy<Value = Rational> {
    (-9..=9_i64, 1..=4_i64).prop_map(Rational::from)
}

mod cu_8 {
    use super::*;

    #[test]
    fn a_differentiable_curve_may_have_a_cusp_and_a_singular_one_a_smooth_trace() {
        // The cusp is a polynomial curve; (t³, t³) is singular at 0, and runs along a line.
        let line = curve(&[0, 0, 0, 1], &[0, 0, 0, 1]);
        for curve in [cusp(), line.clone()] {
            assert_eq!(curve.singular_parameters(), SingularParameters::At(numbers(&[0])));
        }
        let [x, y] = line.numerators();
        assert_eq!(x, y);
    }
}

mod cu_9 {
    use super::*;

    proptest! {
        /// The trace of (t³, t²) is x² = y³: each of its points has one parameter, the cube root of x.
        #[test]
        fn the_trace_of_the_cusp_is_a_cubic(t in parameter()) {
            let Vector([x, y]) = cusp().point(&t).expect("a polynomial");
            prop_assert_eq!(x.clone().square(), y.clone().square() * &y);
            prop_assert!(y >= 0 && (t.is_zero() || x / y == t));
        }

        #[test]
        fn jets_are_those_of_the_quotient(curve in rational_curve(), t in parameter()) {
            use isoracle::curvature::jet::Jet;
            let [time] = Jet::variables(std::slice::from_ref(&t).try_into().expect("one"));
            let of = |p: &Polynomial| {
                let constant = |a: &Rational| Jet::constant(a.clone());
                p.coefficients().iter().rev().fold(Jet::integer(0), |value, a| value * &time + &constant(a))
            };
            let quotient = of(curve.denominator()).reciprocal().map(|r| curve.numerators().each_ref().map(|p| of(p) * &r));
            prop_assert_eq!(curve.jets(&t), quotient);
        }

        #[test]
        fn a_common_factor_is_no_pole(curve in rational_curve(), factor in parameter()) {
            let factor = Polynomial::with_root(&factor) * &p(&[3]);
            let raised = curve.numerators().each_ref().map(|p| p.clone() * &factor);
            prop_assert_eq!(RationalCurve::new(raised, curve.denominator().clone() * &factor), Ok(curve));
        }
    }

    #[test]
    fn a_denominator_of_zero_is_refused() {
        assert!(RationalCurve::new([p(&[1]), p(&[1])], p(&[])).is_err());
    }
}

mod cu_10 {
    use super::*;

    #[test]
    fn closed_curves_have_one_limit_at_both_ends() {
        let (minus, plus) = (End::MinusInfinity, End::PlusInfinity);
        let on = |t: i64| End::At(q(t, 1));
        // The loop of example 2.4 is closed, with two directions at its point; a longer piece of the curve is not.
        assert_eq!(node().closing(&on(-2), &on(2)), Closing::Closed(at(0, 0)));
        assert_ne!(node().derivative().point(&q(2, 1)), node().derivative().point(&q(-2, 1)));
        assert_eq!(node().closing(&on(-2), &on(3)), Closing::Open(at(0, 0), at(15, 5)));
        assert_eq!(node().closing(&minus, &plus), Closing::NoLimit);
        // The circle without (−1, 0): closed on ℝ by its limits.
        assert_eq!(rational_circle().closing(&minus, &plus), Closing::Closed(at(-1, 0)));
        let hyperbola = RationalCurve::new([p(&[1]), p(&[0, 1])], p(&[0, 1])).expect("a denominator");
        assert_eq!(hyperbola.limit(&on(0)), None);
        assert_eq!(hyperbola.limit(&plus), Some(at(0, 1)));
    }

    proptest! {
        /// At infinity the limit is approached: |α(t) − l| is less for t = 2⁶⁰ than for t = 2³⁰, or both are 0.
        #[test]
        fn limits_at_infinity_are_approached(curve in rational_curve()) {
            let far = [30, 60].map(|bits| Rational::from(1) << bits);
            let Some(limit) = curve.limit(&End::PlusInfinity) else {
                let size = |t: &Rational| curve.point(t).expect("no root is so large").norm_squared();
                prop_assert!(size(&far[1]) > size(&far[0]));
                return Ok(());
            };
            let distance = far.map(|t| (curve.point(&t).expect("no root is so large") + &-limit.clone()).norm_squared());
            prop_assert!(distance[1] < distance[0] || distance.iter().all(Rational::is_zero));
            prop_assert!(distance[1] < q(1, 1_000_000_000));
        }
    }
}

mod cu_11 {
    use super::*;

    #[test]
    fn a_constant_curve_is_periodic_and_has_no_least_period() {
        assert_eq!(curve(&[3], &[-1]).period(), Period::EveryNumber);
        let one = CirclePolynomial::<2>::integer(1);
        assert_eq!(least_period(&[one.clone(), one], &q(1, 1)), Period::EveryNumber);
        assert_eq!(cusp().period(), Period::None);
        assert_eq!(rational_circle().period(), Period::None);
    }

    #[test]
    fn the_least_period_comes_from_the_harmonics() {
        let [c, s] = CirclePolynomial::<2>::variables();
        let double = [c.clone() * &c, s.clone() * &c];
        assert_eq!(least_period(&double, &q(1, 1)), Period::Turns(q(1, 2)));
        // cos 2t and cos 3t: 1 turn. 4c³ − 3c = cos 3t alone: a third.
        let cube = c.clone() * &c * &c;
        let triple = cube.clone() * &CirclePolynomial::integer(4) - &(c.clone() * &CirclePolynomial::integer(3));
        assert_eq!(triple.harmonics(), [3]);
        assert_eq!(least_period(&[double[0].clone(), triple.clone()], &q(1, 1)), Period::Turns(q(1, 1)));
        assert_eq!(least_period(&[triple.clone(), triple], &q(-2, 5)), Period::Turns(q(5, 6)));
        assert_eq!(cube.harmonics(), [1, 3]);
        assert_eq!((s.clone() * &s).harmonics(), [0, 2]);
    }

    proptest! {
        /// c → −c, s → −s is half a turn: a function has only even harmonics iff it stays.
        #[test]
        fn half_a_turn_tells_even_harmonics(terms in prop::collection::vec(([0..=3_u32, 0..=3_u32], -3..=3_i64), 0..5)) {
            use isoracle::number::Multivariate;
            let signed = |sign: i64| {
                let terms = terms.iter().map(|(e, a)| (*e, Rational::from(if (e[0] + e[1]) % 2 == 1 { a * sign } else { *a })));
                CirclePolynomial::<2>::new(&Multivariate::new(terms))
            };
            let harmonics = signed(1).harmonics();
            prop_assert_eq!(signed(1) == signed(-1), harmonics.iter().all(|k| k % 2 == 0));
            prop_assert_eq!(signed(1).derivative() == CirclePolynomial::integer(0), harmonics.iter().all(|k| *k == 0));
        }
    }
}

mod cu_12 {
    use super::*;

    #[test]
    fn simple_curves_have_no_crossings() {
        for simple in
            [cusp(), rational_circle(), curve(&[0, 1], &[0, 0, 0, 1]), curve(&[0, 1], &[]), curve(&[], &[2, 5])]
        {
            assert_eq!(crossings(&simple), Crossings::At(Vec::new()), "{simple:?}");
        }
        assert_eq!(crossings(&curve(&[0, 0, 1], &[1])), Crossings::CommonFactor);
    }

    proptest! {
        /// Injective on a grid of parameters, where no crossing is found.
        #[test]
        fn parameters_that_share_a_point_are_found(curve in polynomial_curve()) {
            let grid: Vec<Rational> = (-8..=8).map(|n| q(n, 2)).collect();
            let found = crossings(&curve);
            for (i, s) in grid.iter().enumerate() {
                for t in &grid[..i] {
                    let share = share_a_point(&curve, s, t) == Some(true);
                    let together = match &found {
                        Crossings::CommonFactor => continue,
                        Crossings::At(groups) => groups.iter().any(|group| {
                            [s, t].iter().all(|x| group.contains(&Algebraic::from((*x).clone())))
                        }),
                    };
                    prop_assert_eq!(share, together);
                }
            }
        }
    }
}

mod cu_13 {
    use super::*;
    use isoracle::curvature::frame::Frame;

    #[test]
    fn a_point_of_a_trace_may_have_two_tangents_and_a_corner_none() {
        let frames = [-2, 2].map(|t| Frame::new(&node().jets(&q(t, 1)).expect("a polynomial")).expect("regular"));
        assert_eq!(node().point(&q(2, 1)), node().point(&q(-2, 1)));
        let [a, b] = frames.map(|frame| frame.tangent());
        assert!(a != b && a != -b);
        // At the cusp the vector is 0 and gives no direction.
        assert!(Frame::new(&cusp().jets(&q(0, 1)).expect("a polynomial")).is_err());
    }

    proptest! {
        /// Of the lines through α(t), the distance to the tangent alone falls off faster than |h|.
        #[test]
        fn the_tangent_is_the_line_of_second_order(curve in polynomial_curve(), t in parameter(), [a, b] in prop::array::uniform2(-5..=5_i64)) {
            use isoracle::curvature::crossing::multiplicity;
            let velocity = curve.derivative().point(&t).expect("a polynomial");
            if velocity == at(0, 0) || (a, b) == (0, 0) {
                return Ok(());
            }
            let point = curve.point(&t).expect("a polynomial");
            let [x, y] = curve.numerators();
            let line = |a: &Rational, b: &Rational| {
                let offset = Rational::from(a * &point[0]) + Rational::from(b * &point[1]);
                let f = x.clone() * &Polynomial::new(vec![a.clone()]) + &(y.clone() * &Polynomial::new(vec![b.clone()]));
                multiplicity(&(f - &Polynomial::new(vec![offset])), &t)
            };
            let is_tangent = (Rational::from(&velocity[0] * a) + Rational::from(&velocity[1] * b)).is_zero();
            prop_assert_eq!(line(&q(a, 1), &q(b, 1)).is_none_or(|m| m >= 2), is_tangent);
        }
    }
}

mod cu_14 {
    use super::*;

    #[test]
    fn the_cusp_is_smooth_as_a_map_and_singular_at_0() {
        assert_eq!(cusp().derivative().point(&q(0, 1)), Some(at(0, 0)));
        assert_eq!(cusp().singular_parameters(), SingularParameters::At(numbers(&[0])));
        // The directions before and after: (·, −1) and (·, +1) in the limit, for α′(t)/t = (3t, 2).
        assert_eq!(cusp().derivative().numerators(), &[p(&[0, 0, 3]), p(&[0, 2])]);
    }
}

mod cu_15 {
    use super::*;

    #[test]
    fn the_corner_is_not_differentiable_but_its_trace_has_a_parametrisation_that_is() {
        let (before, after) = (curve(&[0, 1], &[0, -1]), curve(&[0, 1], &[0, 1]));
        assert_eq!(agreeing_derivatives(&before, &after, &q(0, 1)), Some(1));
        // (t³, |t³|) has the same trace y = |x|, and two continuous derivatives; at 0 it is singular.
        let (before, after) = (curve(&[0, 0, 0, 1], &[0, 0, 0, -1]), curve(&[0, 0, 0, 1], &[0, 0, 0, 1]));
        assert_eq!(agreeing_derivatives(&before, &after, &q(0, 1)), Some(3));
        assert_eq!(agreeing_derivatives(&after, &after, &q(0, 1)), None);
        assert_eq!(agreeing_derivatives(&before, &after, &q(1, 1)), Some(0));
    }

    proptest! {
        #[test]
        fn planted_agreement_is_found(curve in polynomial_curve(), t in parameter(), n in 0..5_u32, a in 1..5_i64) {
            let bump = (0..n).fold(p(&[a]), |product, _| product * &Polynomial::with_root(&t));
            let [x, y] = curve.numerators().clone();
            let other = RationalCurve::polynomial([x, y + &bump]);
            prop_assert_eq!(agreeing_derivatives(&curve, &other, &t), Some(n as usize));
        }
    }
}

mod cu_16 {
    use super::*;

    #[test]
    fn the_node_passes_the_origin_twice_and_no_other_point() {
        assert_eq!([2, -2].map(|t| node().point(&q(t, 1))), [Some(at(0, 0)), Some(at(0, 0))]);
        assert_eq!(crossings(&node()), Crossings::At(vec![numbers(&[-2, 2])]));
        assert_eq!(node().singular_parameters(), SingularParameters::At(Vec::new()));
    }
}

mod cu_17 {
    use super::*;

    #[test]
    fn the_circle_over_two_turns_is_closed_but_its_domain_has_no_period() {
        let [c, s] = CirclePolynomial::<2>::variables();
        let point = |quarters: i64| [&c, &s].map(|f| f.at_quarter_turns(quarters, &[]));
        assert_eq!(point(2), [q(-1, 1), q(0, 1)]);
        assert_eq!(point(2), point(6));
        assert_eq!(point(0), point(8));
        assert_eq!(least_period(&[c, s], &q(1, 1)), Period::Turns(q(1, 1)));
        // In turns: 3/2 lies in (0, 2), 3/2 and a period of 1 does not.
        let is_inside = |turns: Rational| turns > 0 && turns < 2;
        assert!(is_inside(q(3, 2)) && !is_inside(q(3, 2) + q(1, 1)));
    }

    proptest! {
        #[test]
        fn equal_trigonometric_functions_are_equal_polynomials(m in parameter(), terms in prop::collection::vec(([0..=3_u32, 0..=3_u32], -3..=3_i64), 0..5)) {
            use isoracle::number::Multivariate;
            let f = Multivariate::<2>::new(terms.iter().map(|(e, a)| (*e, Rational::from(*a))));
            let [c, s] = CirclePolynomial::<2>::variables();
            let one = CirclePolynomial::<2>::integer(1);
            prop_assert_eq!(c.clone() * &c + &(s.clone() * &s), one);
            let at = [c, s].map(|x| x.at_slope(&m, &[]));
            prop_assert_eq!(CirclePolynomial::new(&f).at_slope(&m, &[]), f.evaluate(&at));
        }
    }
}

mod cu_18 {
    use super::*;

    #[test]
    fn a_point_may_be_passed_singularly_and_regularly() {
        // (t²(t − 1), t³(t − 1)): α(0) = α(1), α′(0) = 0, α′(1) = (1, 1).
        let curve = curve(&[0, 0, -1, 1], &[0, 0, 0, -1, 1]);
        assert_eq!(curve.singular_parameters(), SingularParameters::At(numbers(&[0])));
        assert_eq!(crossings(&curve), Crossings::At(vec![numbers(&[0, 1])]));
        assert_eq!(curve.derivative().point(&q(1, 1)), Some(at(1, 1)));
    }
}

mod cu_30 {
    use super::*;

    #[test]
    fn constants_are_singular_everywhere_and_poles_are_not_singular() {
        assert_eq!(curve(&[1], &[2]).singular_parameters(), SingularParameters::Everywhere);
        let poles = RationalCurve::new([p(&[1]), p(&[1])], p(&[0, 0, 0, 1])).expect("a denominator");
        assert_eq!(poles.singular_parameters(), SingularParameters::At(Vec::new()));
        assert_eq!(poles.poles(), numbers(&[0]));
        assert!(!poles.is_defined_on(&q(0, 1), &q(1, 1)) && !poles.is_defined_on(&q(-1, 1), &q(0, 1)));
        assert!(poles.is_defined_on(&q(1, 9), &q(1, 1)));
    }

    proptest! {
        /// Both derivatives are multiples of a planted polynomial, whose real roots are planted too.
        #[test]
        fn planted_singular_points_are_found(roots in prop::collection::btree_set(parameter(), 0..3), a in 1..4_i64) {
            use isoracle::curvature::arc_length::antiderivative;
            let planted = roots.iter().fold(p(&[a]), |product, t| product * &Polynomial::with_root(t));
            let rootless = planted.clone() * &p(&[2, 1, 1]);
            let curve = RationalCurve::polynomial([&planted, &rootless].map(|f| antiderivative(f, &q(1, 1))));
            let expected = roots.iter().cloned().map(Algebraic::from).collect();
            prop_assert_eq!(curve.singular_parameters(), SingularParameters::At(expected));
        }

        #[test]
        fn velocity_is_zero_at_singular_parameters_only(curve in rational_curve(), t in parameter()) {
            let is_zero = curve.derivative().point(&t).is_some_and(|v| v == at(0, 0));
            let expected = match curve.singular_parameters() {
                SingularParameters::Everywhere => curve.point(&t).is_some(),
                SingularParameters::At(roots) => roots.contains(&Algebraic::from(t)),
            };
            prop_assert_eq!(is_zero, expected);
        }
    }
}

mod cu_31 {
    use super::*;
    use isoracle::curvature::crossing::resultant;

    #[test]
    fn crossings_at_irrational_parameters_are_told_from_near_misses() {
        // (t³ − 2t, t²): ±√2 share (0, 2). (t³ − 2t, t² + t/10⁶) has an irrational pair elsewhere.
        let Crossings::At(groups) = crossings(&curve(&[0, -2, 0, 1], &[0, 0, 1])) else { panic!("no common factor") };
        assert_eq!(groups.len(), 1);
        assert_eq!(groups[0], isoracle::number::real_roots(&p(&[-2, 0, 1])).expect("not 0"));
        let near =
            RationalCurve::polynomial([p(&[0, -2, 0, 1]), Polynomial::new(vec![q(0, 1), q(1, 1_000_000), q(1, 1)])]);
        let Crossings::At(groups) = crossings(&near) else { panic!("no common factor") };
        assert_eq!(groups.iter().map(Vec::len).collect::<Vec<_>>(), [2]);
        assert!(groups[0].iter().all(|t| t.rational().is_none()));
        // A triple point: (t(t² − 1), t²(t² − 1)) passes the origin at −1, 0 and 1.
        assert_eq!(crossings(&curve(&[0, -1, 0, 1], &[0, 0, -1, 0, 1])), Crossings::At(vec![numbers(&[-1, 0, 1])]));
        // Two complex parameters share a real point of (t³ + t, t²): no crossing.
        assert_eq!(crossings(&curve(&[0, 1, 0, 1], &[0, 0, 1])), Crossings::At(Vec::new()));
        assert_eq!(crossing_polynomial(&curve(&[0, 1, 0, 1], &[0, 0, 1])).degree(), Some(2));
    }

    #[test]
    fn a_rational_curve_crosses_itself() {
        // The strophoid ((t² − 1)/(t² + 1), t(t² − 1)/(t² + 1)): both 1 and −1 at the origin.
        let strophoid = RationalCurve::new([p(&[-1, 0, 1]), p(&[0, -1, 0, 1])], p(&[1, 0, 1])).expect("a denominator");
        assert_eq!(crossings(&strophoid), Crossings::At(vec![numbers(&[-1, 1])]));
    }

    proptest! {
        /// Res(Π(x − aᵢ), Π(x − bⱼ)) = Π(aᵢ − bⱼ).
        #[test]
        fn the_resultant_is_the_product_of_differences(a in prop::collection::vec(-3..=3_i64, 0..4), b in prop::collection::vec(-3..=3_i64, 0..4)) {
            let with_roots = |roots: &[i64]| {
                let f = roots.iter().fold(p(&[1]), |f, r| f * &p(&[-r, 1]));
                f.coefficients().iter().map(|a| Polynomial::new(vec![a.clone()])).collect::<Vec<_>>()
            };
            let product: i64 = a.iter().flat_map(|x| b.iter().map(move |y| x - y)).product();
            prop_assert_eq!(resultant(&with_roots(&a), &with_roots(&b)), p(&[product]));
        }
    }
}
