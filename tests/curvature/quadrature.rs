//! Verified quadrature, against closed forms, exact antiderivatives, and itself.

use super::q;
use isoracle::curvature::quadrature::{Goal, Integral, Outcome, QuadratureError, integral};
use isoracle::curvature::series::{Series, multi_indices};
use isoracle::number::{Interval, Multivariate, Polynomial, Rational, Ring};
use proptest::prelude::*;

type Line = Series<1, 14>;
type Plane = Series<2, 8>;

/// The interval is as narrow as asked, and meets one that holds the same number.
pub fn is_within(integral: &Integral, goal: &Goal, truth: &Interval) -> bool {
    let is_narrow = integral.value.width().is_some_and(|width| width <= goal.width);
    is_narrow && integral.outcome == Outcome::Reached && integral.value.intersection(truth).is_some()
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    prop::collection::vec((-9..=9_i64, 1..=3_i64).prop_map(Rational::from), 0..9).prop_map(Polynomial::new)
}

fn number() -> impl Strategy<Value = Rational> {
    (-12..=12_i64, 1..=5_i64).prop_map(Rational::from)
}

mod cu_127 {
    use super::*;
    use isoracle::curvature::arc_length::antiderivative;

    #[test]
    fn a_logarithm_an_arc_tangent_and_a_sine() {
        let goal = Goal::digits(20);
        let domain = [(q(1, 1), q(7, 2))];
        let ln = integral(|[x]: &[Line; 1], _| x.inverse(), &domain, &goal).expect("well-posed");
        assert!(is_within(&ln, &goal, &Interval::from_rational(&q(7, 2), 200).ln().expect("positive")));
        let lorentz = |[x]: &[Line; 1], _: u32| (x.square() + &Line::integer(1)).inverse();
        let atan = integral(lorentz, &[(q(-3, 1), q(5, 1))], &goal).expect("well-posed");
        let number = |n: i64| Interval::from_rational(&q(n, 1), 200);
        assert!(is_within(&atan, &goal, &(number(5).atan() - &number(-3).atan())));
        let sine =
            integral(|[x]: &[Line; 1], _| Some(x.sin_cos().0), &[(q(0, 1), q(4, 1))], &goal).expect("well-posed");
        assert!(is_within(&sine, &goal, &(Interval::integer(1) - &number(4).cos())));
    }

    #[test]
    fn a_root_at_its_zero_is_integrated_by_its_range() {
        // ∫₀¹ √x = 2/3, ∫₋₁¹ √(x²) = 1: no derivatives at 0.
        let goal = Goal::digits(12);
        let root = integral(|[x]: &[Line; 1], _| x.sqrt(), &[(q(0, 1), q(1, 1))], &goal).expect("well-posed");
        assert!(is_within(&root, &goal, &Interval::from_rational(&q(2, 3), 200)));
        let corner = |[x]: &[Line; 1], _: u32| x.square().sqrt();
        let corner = integral(corner, &[(q(-1, 3), q(1, 1))], &goal).expect("well-posed");
        assert!(is_within(&corner, &goal, &Interval::from_rational(&q(5, 9), 200)));
    }

    #[test]
    fn a_limit_is_told_and_the_interval_still_holds_the_integral() {
        let goal = Goal { width: q(1, 1_000_000), cells: 5 };
        let domain = [(q(-5, 1), q(5, 1))];
        let lorentz = |[x]: &[Line; 1], _: u32| (x.square() + &Line::integer(1)).inverse();
        let atan = integral(lorentz, &domain, &goal).expect("well-posed");
        assert!(atan.outcome == Outcome::Limit && atan.cells <= 5);
        let five = Interval::from_rational(&q(5, 1), 200).atan();
        assert!(atan.value.intersection(&(five.clone() + &five)).is_some());
        // A pole: nothing is known, and that is said.
        let pole = integral(|[x]: &[Line; 1], _| x.inverse(), &domain, &Goal::digits(3)).expect("well-posed");
        assert!(pole.outcome == Outcome::Limit && pole.value.lo().is_infinite() && pole.value.hi().is_infinite());
    }

    #[test]
    fn broken_questions_are_refused() {
        let one = |_: &[Line; 1], _: u32| Some(Line::integer(1));
        let zero_width = Goal { width: q(0, 1), cells: 9 };
        let error = integral(one, &[(q(0, 1), q(1, 1))], &zero_width).expect_err("no width");
        assert_eq!(error, QuadratureError::Width(q(0, 1)));
        let error = integral(one, &[(q(1, 1), q(0, 1))], &Goal::digits(3)).expect_err("reversed");
        assert_eq!(error, QuadratureError::Reversed { from: q(1, 1), to: q(0, 1) });
        let point = integral(one, &[(q(1, 1), q(1, 1))], &Goal::digits(3)).expect("a point is a domain");
        assert_eq!(point.value.bounds(), Some((q(0, 1), q(0, 1))));
    }

    #[test]
    fn more_digits_than_the_first_bits_hold_are_reached() {
        // (x − 10⁶)⁸ expanded: terms of 10⁴⁸ that cancel to 1.
        let base = Polynomial::with_root(&q(1_000_000, 1));
        let power = (0..8).fold(Polynomial::integer(1), |p, _| p * &base);
        let f = |[x]: &[Line; 1], precision: u32| Some(Line::of_polynomial(&power, x, precision));
        let goal = Goal::digits(12);
        let value = integral(f, &[(q(1_000_000, 1), q(1_000_001, 1))], &goal).expect("well-posed");
        assert!(is_within(&value, &goal, &Interval::from_rational(&q(1, 9), 200)));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn polynomials_have_the_integrals_of_their_antiderivatives(p in polynomial(), a in number(), b in number()) {
            let (a, b) = if a <= b { (a, b) } else { (b, a) };
            let f = |[x]: &[Line; 1], precision: u32| Some(Line::of_polynomial(&p, x, precision));
            let goal = Goal::digits(20);
            let value = integral(f, &[(a.clone(), b.clone())], &goal).expect("well-posed");
            let truth = antiderivative(&p, &a).evaluate(&b);
            prop_assert!(value.outcome == Outcome::Reached && value.value.contains(&truth));
        }
    }
}

mod cu_128 {
    use super::*;

    #[test]
    fn a_rectangle_of_a_quotient() {
        // ∫₀¹∫₀¹ 1/(1 + x + y) = 3 ln 3 − 4 ln 2
        let goal = Goal::digits(12);
        let f = |[x, y]: &[Plane; 2], _: u32| (Plane::integer(1) + x + y).inverse();
        let unit = (q(0, 1), q(1, 1));
        let value = integral(f, &[unit.clone(), unit], &goal).expect("well-posed");
        let ln = |n: i64| Interval::from_rational(&q(n, 1), 200).ln().expect("positive") * &Interval::integer(n);
        let truth = ln(3) - &(ln(2) * &Interval::integer(2));
        assert!(is_within(&value, &goal, &truth));
    }

    #[test]
    fn a_cone_is_integrated_at_its_apex() {
        // ∫∫ √(x² + y²) over the unit square: (√2 + ln(1 + √2))/3
        let goal = Goal::digits(4);
        let f = |[x, y]: &[Plane; 2], _: u32| (x.square() + &y.square()).sqrt();
        let unit = (q(0, 1), q(1, 1));
        let value = integral(f, &[unit.clone(), unit], &goal).expect("well-posed");
        let root = Interval::from_rational(&q(2, 1), 200).sqrt().expect("positive");
        let sum = root.clone() + &(root + &Interval::integer(1)).ln().expect("positive");
        assert!(is_within(&value, &goal, &sum.checked_div(&Interval::integer(3)).expect("3 is not 0")));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        #[test]
        fn products_of_polynomials_have_the_product_of_their_integrals(
            f in polynomial(), g in polynomial(), [a, b] in prop::array::uniform2(number()),
        ) {
            use isoracle::curvature::arc_length::antiderivative;
            let product = |[x, y]: &[Plane; 2], bits: u32| {
                Some(Plane::of_polynomial(&f, x, bits) * &Plane::of_polynomial(&g, y, bits))
            };
            let domain = [(a.clone(), a.clone() + 1_u32), (b.clone(), b.clone() + q(1, 2))];
            let value = integral(product, &domain, &Goal { width: q(1, 1000), cells: 300 }).expect("well-posed");
            let truth = antiderivative(&f, &a).evaluate(&domain[0].1) * antiderivative(&g, &b).evaluate(&domain[1].1);
            prop_assert!(value.value.contains(&truth));
        }
    }
}

mod cu_129 {
    use super::*;

    /// The Taylor coefficient ∂ᵏf/k! of a polynomial at a point, exactly.
    fn exact(f: &Multivariate<2>, [i, j]: [usize; 2], at: &[Rational; 2]) -> Rational {
        let times = |f: Multivariate<2>, axis: usize, n: usize| (0..n).fold(f, |f, _| f.derivative(axis));
        let factorial = |n: usize| (1..=n as u64).fold(Rational::from(1), |product, k| product * k);
        times(times(f.clone(), 0, i), 1, j).evaluate(at) / factorial(i) / factorial(j)
    }

    fn bivariate() -> impl Strategy<Value = Multivariate<2>> {
        prop::collection::vec(([0..=3_u32, 0..=3_u32], -5..=5_i64), 1..6)
            .prop_map(|terms| Multivariate::new(terms.into_iter().map(|(e, c)| (e, Rational::from(c)))))
    }

    type Small = Series<2, 4>;

    fn variables(at: &[Rational; 2]) -> [Small; 2] {
        let number = |x: &Rational| Interval::from_rational(x, 100);
        Small::variables(&at.each_ref().map(number), &[Interval::integer(1), Interval::integer(1)])
    }

    fn agree(a: &Small, b: &Small) -> bool {
        multi_indices::<2, 4>().iter().all(|k| {
            let both = (a.coefficient(k), b.coefficient(k));
            both.0.intersection(both.1).is_some() && both.0.width().is_some_and(|w| w < q(1, 1_000_000_000))
        })
    }

    #[test]
    fn multi_indices_are_those_of_the_degree_once_each() {
        let all = multi_indices::<2, 5>();
        assert_eq!(all.len(), 21);
        assert!(all.windows(2).all(|pair| pair[0].iter().sum::<usize>() <= pair[1].iter().sum::<usize>()));
        let distinct: std::collections::BTreeSet<_> = all.iter().collect();
        assert!(distinct.len() == 21 && all.iter().all(|k| k.iter().sum::<usize>() <= 5));
        assert_eq!(multi_indices::<1, 3>(), [[0], [1], [2], [3]]);
    }

    proptest! {
        #[test]
        fn coefficients_hold_the_derivatives(f in bivariate(), x in number(), y in number()) {
            let at = [x, y];
            let series = f.evaluate_in(&variables(&at), |c| Small::rational(c, 100));
            for k in multi_indices::<2, 4>() {
                prop_assert!(series.coefficient(&k).contains(&exact(&f, k, &at)));
            }
        }

        #[test]
        fn quotients_roots_and_sines_keep_their_equations(f in bivariate(), x in number(), y in number()) {
            let f = f.evaluate_in(&variables(&[x, y]), |c| Small::rational(c, 300));
            let positive = f.square() + &Small::integer(1);
            let root = positive.sqrt().expect("positive");
            prop_assert!(agree(&root.square(), &positive) && agree(&(root.clone() * &root), &positive));
            prop_assert!(agree(&(positive.inverse().expect("positive") * &positive), &Small::integer(1)));
            let (s, c) = variables(&[q(1, 3), q(-2, 7)])[0].clone().sin_cos();
            prop_assert!(agree(&(s.square() + &c.square()), &Small::integer(1)));
        }

        /// Over a box the coefficients hold those of each of its points.
        #[test]
        fn boxes_hold_their_points(f in bivariate(), x in number(), y in number(), u in 0..=8_i64, v in 0..=8_i64) {
            let positive = |x: [Small; 2]| (f.evaluate_in(&x, |c| Small::rational(c, 100)).square() + &Small::integer(2)).sqrt();
            let range = |x: &Rational| Interval::between(x, &(x + q(1, 8)), 100).expect("in order");
            let one = [Interval::integer(1), Interval::integer(1)];
            let around = positive(Small::variables(&[range(&x), range(&y)], &one)).expect("positive");
            let inside = positive(variables(&[x + q(u, 64), y + q(v, 64)])).expect("positive");
            for k in multi_indices::<2, 4>() {
                prop_assert!(around.coefficient(&k).intersection(inside.coefficient(&k)).is_some());
            }
        }
    }
}
