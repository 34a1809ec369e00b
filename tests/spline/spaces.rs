//! The spaces Sₙ: membership, bases, dimensions.

use super::{at, few, number, q, rank};
use isoracle::number::{Integer, Polynomial, Rational};
use isoracle::spline::bspline::basis;
use isoracle::spline::degree_one;
use isoracle::spline::piecewise::{Piecewise, Smoothness};
use isoracle::spline::printed;
use isoracle::spline::space::{
    NotASpline, coefficient, coefficient_at, combination, dimension, generator, local_basis, membership,
};
use proptest::prelude::*;

/// xⁿ.
fn power(n: usize) -> Polynomial {
    Polynomial::new((0..=n).map(|k| q(i64::from(k == n), 1)).collect())
}

/// (x − k)ⁿ₊.
fn cut(k: i64, n: usize) -> Piecewise {
    Piecewise::truncated_power(&q(k, 1), n)
}

mod sp_8 {
    use super::*;

    /// A second derivative that exists everywhere has no jumps where it is made of polynomials: (f′(k + s) − f′(k))/s for
    /// small s of either sign are the two pieces' second derivatives, up to a multiple of s.
    #[test]
    fn a_piecewise_polynomial_without_c2_lacks_a_second_derivative_somewhere() {
        for f in [basis(1), basis(2), cut(0, 1), cut(0, 2)] {
            assert!(f.smoothness() < Smoothness::Times(2));
            let second = f.derivative().derivative();
            let jump = |b: &Rational| {
                let left = second.piece_at(b).evaluate(b);
                second.piece_at(&(b + q(1, 4))).evaluate(b) - left
            };
            let slope_jump = |b: &Rational| {
                let first = f.derivative();
                first.piece_at(&(b + q(1, 4))).evaluate(b) - first.piece_at(b).evaluate(b)
            };
            assert!(f.breaks().iter().any(|b| jump(b) != 0 || slope_jump(b) != 0));
        }
        for f in [basis(3), basis(4), cut(1, 3)] {
            assert!(f.smoothness() >= Smoothness::Times(2));
        }
    }

    #[test]
    fn the_linear_interpolant_has_second_derivatives_on_straight_signals_alone() {
        let square = |k: &Integer| Rational::from(k.clone().square());
        assert_ne!(degree_one::slope_change(&square, &Integer::from(3)), 0);
    }
}

mod sp_9 {
    use super::*;

    #[test]
    fn of_degree_exactly_3_the_b_spline_is_not() {
        assert_eq!(membership(&basis(3), 3), Ok(()));
        assert!(!printed::has_degree_everywhere(&basis(3), 3));
        // x³ and −x³ are of degree 3, their sum is not: no vector space.
        let cubes = [power(3), -power(3)].map(Piecewise::polynomial);
        assert!(cubes.iter().all(|f| printed::has_degree_everywhere(f, 3)));
        let [cube, opposite] = cubes;
        assert!(!printed::has_degree_everywhere(&(cube + &opposite), 3));
    }

    #[test]
    fn what_is_not_in_it_says_why() {
        assert_eq!(membership(&basis(2), 2), Err(NotASpline::Knot(q(-3, 2))));
        assert_eq!(membership(&basis(3), 2), Err(NotASpline::Degree { found: 3, n: 2 }));
        let rough = NotASpline::Rough { required: 2, found: Smoothness::Times(0) };
        assert_eq!(membership(&basis(1), 3), Err(rough));
        let broken = NotASpline::Rough { required: 0, found: Smoothness::Discontinuous };
        assert_eq!(membership(&cut(0, 0), 1), Err(broken));
    }

    proptest! {
        #[test]
        fn it_is_a_vector_space_with_integer_translations(c in few(), d in few(), factor in number(), k in -9..9_i64) {
            let [f, g] = [c, d].map(|c| combination(&c, 3));
            let combined = f.shifted(&q(k, 1)) + &g.scaled(&factor);
            prop_assert_eq!(membership(&combined, 3), Ok(()));
        }
    }

    #[test]
    fn it_holds_all_polynomials_of_its_degree_and_no_translation_by_a_half() {
        for n in 0..6 {
            assert_eq!(membership(&Piecewise::polynomial(power(n)), n), Ok(()));
            assert!(membership(&generator(n).shifted(&q(1, 2)), n).is_err());
        }
    }
}

mod sp_10 {
    use super::*;

    #[test]
    fn closed_intervals_leave_constants_alone() {
        let step = generator(0);
        assert_eq!(step.breaks(), [q(0, 1), q(1, 1)]);
        assert_eq!(membership(&step, 0), Ok(()));
        // At 0 it is 0, and 1 just after: no polynomial on [0, 1].
        assert!(!printed::is_in_s0(&step));
        assert!(printed::is_in_s0(&Piecewise::polynomial(power(0).clone() * &Polynomial::new(vec![q(7, 2)]))));
        assert!(!printed::is_in_s0(&Piecewise::polynomial(power(1))));
    }

    proptest! {
        #[test]
        fn a_step_function_with_the_same_values_at_shared_ends_is_constant(c in few()) {
            let f = combination(&c, 0);
            let is_constant = f.pieces().len() == 1;
            prop_assert_eq!(printed::is_in_s0(&f), is_constant);
            prop_assert_eq!(membership(&f, 0), Ok(()));
        }
    }
}

mod sp_11 {
    use super::*;

    /// The conditions on the n + 1 coefficients of each of m pieces: at each inner integer the derivatives 0 … n − 1 agree.
    fn conditions(n: usize, m: usize) -> Vec<Vec<Rational>> {
        let mut rows = Vec::new();
        for knot in 1..m {
            for order in 0..n {
                let mut row = vec![Rational::new(); m * (n + 1)];
                for degree in order..=n {
                    let mut p = power(degree);
                    (0..order).for_each(|_| p = p.derivative());
                    let value = p.evaluate(&q(knot as i64, 1));
                    row[(knot - 1) * (n + 1) + degree] = value.clone();
                    row[knot * (n + 1) + degree] = -value;
                }
                rows.push(row);
            }
        }
        rows
    }

    #[test]
    fn unknowns_less_conditions_and_translates_that_are_seen() {
        for n in 0..6 {
            for m in 1..6 {
                let conditions = conditions(n, m);
                assert_eq!(m * (n + 1) - rank(conditions), dimension(n, m), "{n} {m}");
                // The translates whose support meets (0, m), independent on it.
                let b = generator(n);
                let (first, last) = b.support().map(|(a, b)| (a.clone(), b.clone())).expect("a support");
                let seen: Vec<i64> = (-20..20)
                    .filter(|k| Rational::from(&first + *k) < m as i64 && Rational::from(&last + *k) > 0)
                    .collect();
                assert_eq!(seen.len(), dimension(n, m));
                let row = |k: &i64| {
                    let moved = b.shifted(&q(*k, 1));
                    let pieces = (1..=m).map(|end| moved.piece_at(&q(end as i64, 1)).clone());
                    pieces
                        .flat_map(|p| {
                            (0..=n).map(|d| p.coefficients().get(d).cloned().unwrap_or_default()).collect::<Vec<_>>()
                        })
                        .collect()
                };
                assert_eq!(rank(seen.iter().map(row).collect()), dimension(n, m));
            }
        }
    }
}

mod sp_16 {
    use super::*;

    #[test]
    fn for_even_degrees_the_centred_b_spline_is_not_in_the_space() {
        for n in 0..=7 {
            for k in -2..=2 {
                let printed = membership(&printed::translate(n, k), n);
                assert_eq!(printed.is_ok(), n % 2 == 1, "{n}");
                assert_eq!(membership(&generator(n).shifted(&q(k.into(), 1)), n), Ok(()));
            }
        }
        assert_eq!(membership(&printed::translate(2, 0), 2), Err(NotASpline::Knot(q(-3, 2))));
        assert_eq!(membership(&printed::translate(0, 0), 0), Err(NotASpline::Knot(q(-1, 2))));
    }

    #[test]
    fn half_knots_do_not_make_a_kink_at_an_integer() {
        // x²₊ is in S₂; any sum of centred B₂ is one polynomial around 0, and x²₊ is two.
        assert_eq!(membership(&cut(0, 2), 2), Ok(()));
        for k in -3..=3 {
            let b = printed::translate(2, k);
            assert_eq!(b.piece_at(&q(-1, 4)), b.piece_at(&q(1, 4)));
        }
        assert_ne!(cut(0, 2).piece_at(&q(-1, 4)), cut(0, 2).piece_at(&q(1, 4)));
    }
}

mod sp_17 {
    use super::*;

    proptest! {
        #[test]
        fn coefficients_are_found_again(c in few(), n in 0..=5_usize, k in -8..8_i64) {
            let f = combination(&c, n);
            let k = Integer::from(k);
            prop_assert_eq!(coefficient(&f, n, &k), Ok(at(&c, &k)));
            // From each interval of the support.
            for interval in 0..=n {
                prop_assert_eq!(coefficient_at(&f, n, &k, interval), at(&c, &k));
            }
        }

        #[test]
        fn functions_are_found_again(n in 1..=5_usize, a in prop::collection::vec(number(), 4), b in number(), x in -32..32_i64) {
            // A polynomial and two cut powers: no finite sum of B-splines, yet their sum near each point.
            let polynomial = Piecewise::polynomial(Polynomial::new(a[..n.min(3) + 1].to_vec()));
            let f = polynomial + &cut(0, n).scaled(&b) + &cut(2, n).scaled(&a[0]);
            let b_spline = generator(n);
            let x = q(x, 8);
            let floor = x.clone().floor().into_numer_denom().0;
            let terms = (-7..=7).map(|step| {
                let k = Integer::from(&floor + step);
                coefficient(&f, n, &k).expect("in the space") * b_spline.evaluate(&(Rational::from(&x - &k)))
            });
            prop_assert_eq!(terms.fold(Rational::new(), |sum, term| sum + term), f.evaluate(&x));
        }
    }

    #[test]
    fn what_is_not_in_the_space_has_none() {
        assert_eq!(coefficient(&basis(2), 2, &Integer::new()), Err(NotASpline::Knot(q(-3, 2))));
    }
}

mod sp_50 {
    use super::*;

    #[test]
    fn c2_is_neither_s3_alone_nor_in_s2() {
        // x⁴ and B₅ are C², and not in S₃.
        for f in [Piecewise::polynomial(power(4)), basis(5)] {
            assert!(f.smoothness() >= Smoothness::Times(2));
            assert!(matches!(membership(&f, 3), Err(NotASpline::Degree { n: 3, .. })));
        }
        for n in 1..=7 {
            assert_eq!(generator(n).smoothness() >= Smoothness::Times(2), n >= 3);
        }
    }

    proptest! {
        /// In S₂ only polynomials are C².
        #[test]
        fn in_s2_only_polynomials_are_c2(c in few()) {
            let f = combination(&c, 2);
            prop_assert_eq!(f.smoothness() >= Smoothness::Times(2), f.breaks().is_empty());
        }
    }
}

mod sp_76 {
    use super::*;

    #[test]
    fn on_one_interval_they_are_independent() {
        for n in 0..=7 {
            let rows: Vec<Vec<Rational>> = local_basis(n)
                .iter()
                .map(|p| (0..=n).map(|k| p.coefficients().get(k).cloned().unwrap_or_default()).collect())
                .collect();
            assert_eq!(rank(rows), n + 1, "{n}");
        }
    }

    #[test]
    fn for_cubics_they_are_the_four_weights() {
        use isoracle::spline::basis::weights;
        let four = local_basis(3);
        for n in 0..8 {
            let values: Vec<Rational> = four.iter().map(|p| p.evaluate(&q(n, 8))).collect();
            assert_eq!(weights(&q(n, 8), 0).to_vec(), values);
        }
    }
}
