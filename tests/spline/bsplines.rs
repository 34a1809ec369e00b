//! B-splines: recursions, closed forms, and what they satisfy.

use super::{number, q, sum};
use isoracle::number::{Polynomial, Rational};
use isoracle::spline::basis::weights;
use isoracle::spline::bspline::{b1, b3, basis, by_de_boor, by_truncated_powers, closed_form, indicator};
use isoracle::spline::piecewise::{Piecewise, PiecewiseError, Smoothness};
use isoracle::spline::space::{generator, membership};
use proptest::prelude::*;

const DEGREES: std::ops::RangeInclusive<usize> = 0..=7;

/// p(x) = Σ aₖxᵏ from integers.
fn polynomial(a: &[i64]) -> Polynomial {
    Polynomial::new(a.iter().map(|a| q(*a, 1)).collect())
}

fn reflected(f: &Piecewise) -> impl Fn(&Rational) -> Rational + '_ {
    |x| f.evaluate(&Rational::from(-x))
}

mod sp_18 {
    use super::*;

    #[test]
    fn the_four_that_are_drawn() {
        for n in 0..4 {
            assert_eq!(closed_form(n), Some(basis(n)));
        }
        assert_eq!(closed_form(4), None);
        let middles = [q(1, 1), q(1, 1), q(3, 4), q(2, 3)];
        assert_eq!(middles.to_vec(), (0..4).map(|n| basis(n).evaluate(&q(0, 1))).collect::<Vec<_>>());
        let ends = [q(1, 1), q(0, 1), q(1, 8), q(1, 6)];
        assert_eq!(basis(0).evaluate(&q(1, 2)), ends[0]);
        assert_eq!(basis(2).evaluate(&q(1, 1)), ends[2]);
        assert_eq!([basis(1), basis(3)].map(|b| b.evaluate(&q(1, 1))), [ends[1].clone(), ends[3].clone()]);
    }
}

mod sp_19 {
    use super::*;

    #[test]
    fn convolving_with_the_box_gives_the_next_one() {
        for n in 0..7 {
            let by_powers = basis(n).convolve(&basis(0)).expect("0 to the left");
            assert_eq!(by_powers, basis(n + 1));
            assert_eq!(basis(n).averaged(), by_truncated_powers(n + 1));
        }
    }

    #[test]
    fn the_hat_of_eq_9_is_the_box_with_itself_and_does_not_see_the_ends_of_the_box() {
        let hat = basis(0).averaged();
        for n in -20..=20 {
            assert_eq!(hat.evaluate(&q(n, 8)), b1(&q(n, 8)));
        }
        // [−½, ½) instead: the box turned round. Only at ±½ does it differ.
        let indicator = indicator();
        let turned = reflected(&indicator);
        let differs: Vec<i64> = (-9..=9).filter(|n| turned(&q(*n, 4)) != indicator.evaluate(&q(*n, 4))).collect();
        assert_eq!(differs, [-2, 2]);
        assert_eq!([indicator.evaluate(&q(-1, 2)), indicator.evaluate(&q(1, 2))], [q(0, 1), q(1, 1)]);
    }

    #[test]
    fn from_a_b_spline_of_even_degree_that_eq_10_wants_the_next_one_is_out_of_place() {
        let moved = generator(2);
        assert_eq!((membership(&moved, 2), membership(&basis(2), 2).is_ok()), (Ok(()), false));
        assert_eq!(moved.averaged(), basis(3).shifted(&q(1, 2)));
        assert!(membership(&moved.averaged(), 3).is_err() && membership(&basis(3), 3).is_ok());
        // Nor does (10) fix a factor: twice B₃ generates S₃ too.
        assert_ne!(basis(2).averaged(), basis(3).scaled(&q(2, 1)));
    }

    #[test]
    fn splitting_the_factors_otherwise_gives_the_same() {
        // Bₘ ⋆ Bₙ = Bₘ₊ₙ₊₁: the convolution of what has a support is associative.
        for (m, n) in [(1, 1), (2, 1), (1, 2), (3, 3), (0, 5), (2, 4)] {
            assert_eq!(basis(m).convolve(&basis(n)), Ok(basis(m + n + 1)), "{m} {n}");
        }
    }
}

mod sp_20 {
    use super::*;

    #[test]
    fn a_convolution_by_hand() {
        // x·1_(0,1] ⋆ 1_(0,1]: x²/2 on (0, 1], (1 − (x − 1)²)/2 = x − x²/2 on (1, 2].
        let of = |pieces: &[&[i64]]| {
            let knots = (0..pieces.len() as i64 - 1).map(|k| q(k, 1)).collect();
            Piecewise::new(knots, pieces.iter().map(|p| polynomial(p)).collect()).expect("increasing")
        };
        let (ramp, one) = (of(&[&[], &[0, 1], &[]]), of(&[&[], &[1], &[]]));
        let doubled = of(&[&[], &[0, 0, 1], &[0, 2, -1], &[]]);
        assert_eq!(ramp.convolve(&one), Ok(doubled.scaled(&q(1, 2))));
        assert_eq!(one.convolve(&ramp), ramp.convolve(&one));
    }

    #[test]
    fn what_is_not_0_to_the_left_has_none() {
        let one = Piecewise::polynomial(polynomial(&[1]));
        assert_eq!(one.convolve(&basis(2)), Err(PiecewiseError::Unbounded));
        assert_eq!(basis(2).convolve(&one), Err(PiecewiseError::Unbounded));
    }

    #[test]
    fn broken_records_are_refused() {
        let p = || polynomial(&[1]);
        let two = PiecewiseError::Pieces { breaks: 1, pieces: 1 };
        assert_eq!(Piecewise::new(vec![q(0, 1)], vec![p()]), Err(two.clone()));
        assert_eq!(two.to_string(), "1 breakpoints separate 2 pieces, found 1");
        for second in [q(0, 1), q(-1, 1)] {
            let unordered = PiecewiseError::Unordered { index: 1, found: second.clone() };
            assert_eq!(Piecewise::new(vec![q(0, 1), second], vec![p(), p(), p()]), Err(unordered));
        }
    }

    #[test]
    fn breakpoints_without_a_change_are_left_out() {
        let p = || polynomial(&[3, 1]);
        let f = Piecewise::new(vec![q(0, 1), q(1, 2)], vec![p(), p(), polynomial(&[])]).expect("increasing");
        assert_eq!(f.breaks(), [q(1, 2)]);
        assert_eq!(f.clone() - &f, Piecewise::zero());
        assert_eq!(f.clone() + &f, f.scaled(&q(2, 1)));
        assert_eq!((f.evaluate(&q(1, 2)), f.evaluate(&q(3, 4))), (q(7, 2), q(0, 1)));
    }

    /// Pieces of degree at most 2 between a few breakpoints, 0 outside.
    fn few_pieces() -> impl Strategy<Value = Piecewise> {
        prop::collection::vec((1..9_i64, prop::collection::vec(-4..4_i64, 0..3)), 1..4).prop_map(|steps| {
            let mut end = q(-2, 1);
            let (mut knots, mut pieces) = (vec![end.clone()], vec![polynomial(&[])]);
            for (width, a) in steps {
                end += q(width, 4);
                knots.push(end.clone());
                pieces.push(polynomial(&a));
            }
            pieces.push(polynomial(&[]));
            Piecewise::new(knots, pieces).expect("increasing")
        })
    }

    /// ∫ f(t)g(x − t) dt for one x, over the intervals on which both are polynomials.
    fn integral(f: &Piecewise, g: &Piecewise, x: &Rational) -> Rational {
        let mut knots: Vec<Rational> =
            f.breaks().iter().cloned().chain(g.breaks().iter().map(|b| Rational::from(x - b))).collect();
        knots.sort();
        // Each interval by Simpson's rule with two halves, Boole's: exact up to degree 5.
        let total = knots.windows(2).map(|ends| {
            let width = Rational::from(&ends[1] - &ends[0]);
            let sample = |n: i64| {
                // In the interior, where neither end's convention matters; the ends by the interval's polynomials.
                let middle = Rational::from(&ends[0] + &ends[1]) / 2;
                let t = &ends[0] + Rational::from(&width * &q(n, 4));
                let other = Rational::from(x - &middle);
                f.piece_at(&middle).evaluate(&t) * g.piece_at(&other).evaluate(&Rational::from(x - &t))
            };
            let boole = sample(0) * 7 + sample(1) * 32 + sample(2) * 12 + sample(3) * 32 + sample(4) * 7;
            boole * &width / 90
        });
        total.fold(Rational::new(), |sum, part| sum + part)
    }

    proptest! {
        #[test]
        fn truncated_powers_and_the_integral_agree(f in few_pieces(), g in few_pieces(), n in -40..60_i64) {
            let product = f.convolve(&g).expect("0 to the left");
            prop_assert_eq!(product.evaluate(&q(n, 8)), integral(&f, &g, &q(n, 8)));
            prop_assert_eq!(&product, &g.convolve(&f).expect("0 to the left"));
            let areas = f.integral().zip(g.integral()).map(|(f, g)| f * g);
            prop_assert_eq!(product.integral(), areas);
            prop_assert_eq!(f.averaged(), f.convolve(&basis(0)).expect("0 to the left"));
        }

        #[test]
        fn derivatives_undo_antiderivatives(f in few_pieces(), n in -40..60_i64) {
            prop_assert_eq!(&f.antiderivative().derivative(), &f);
            prop_assert!(f.antiderivative().smoothness() >= Smoothness::Times(0));
            let powers = f.truncated_powers().expect("0 to the left");
            let sum = powers.iter().fold(Piecewise::zero(), |sum, (b, n, a)| {
                sum + &Piecewise::truncated_power(b, *n).scaled(a)
            });
            prop_assert_eq!(&sum, &f);
            prop_assert_eq!(f.shifted(&q(3, 8)).evaluate(&q(n, 8)), f.evaluate(&q(n - 3, 8)));
        }
    }
}

mod sp_21 {
    use super::*;

    #[test]
    fn the_recursion_of_de_boor_gives_the_same() {
        for n in DEGREES {
            assert_eq!(by_de_boor(n), basis(n), "{n}");
        }
    }
}

mod sp_22 {
    use super::*;

    #[test]
    fn truncated_powers_give_the_same() {
        for n in DEGREES {
            assert_eq!(by_truncated_powers(n), basis(n), "{n}");
        }
    }
}

mod sp_23 {
    use super::*;

    #[test]
    fn eq_11_is_the_triple_convolution_of_the_box() {
        // A piece of degree 3 is fixed by 4 points: 8 of them between two knots.
        for n in -24..=24 {
            assert_eq!(b3(&q(n, 8)), basis(3).evaluate(&q(n, 8)), "{n}/8");
        }
    }

    #[test]
    fn its_pieces_meet() {
        let thirds = [q(0, 1), q(1, 6), q(2, 3), q(1, 6), q(0, 1)];
        assert_eq!(thirds.to_vec(), (-2..=2).map(|k| b3(&q(k, 1))).collect::<Vec<_>>());
        // Both formulas at |x| = 1, and the outer one at |x| = 2.
        assert_eq!(q(2, 3) - q(1, 2) * q(1, 1), q(1, 6));
        for hair in [q(1, 1 << 40), q(-1, 1 << 40)] {
            for k in -2..=2 {
                let step = b3(&(q(k, 1) + &hair)) - b3(&q(k, 1));
                assert!(step.abs() <= Rational::from(hair.abs_ref()));
            }
        }
    }
}

mod sp_24 {
    use super::*;

    #[test]
    fn it_is_once_less_smooth_than_its_degree() {
        assert_eq!(basis(0).smoothness(), Smoothness::Discontinuous);
        for n in 1..=7 {
            assert_eq!(basis(n).smoothness(), Smoothness::Times(n - 1));
        }
        let third = basis(3).derivative().derivative().derivative();
        assert_eq!(third.smoothness(), Smoothness::Discontinuous);
        assert_eq!(third.pieces()[1..5], [[1], [-3], [3], [-1]].map(|a| polynomial(&a)));
    }
}

mod sp_25 {
    use super::*;

    proptest! {
        #[test]
        fn translates_add_up_to_1(n in DEGREES, x in number()) {
            let floor = x.clone().floor();
            let b = basis(n);
            let terms: Vec<Rational> = (-6..=6).map(|k| b.evaluate(&(Rational::from(&x - &floor) - k))).collect();
            prop_assert_eq!(sum(&terms), 1);
            prop_assert!(terms.iter().all(|term| *term >= 0));
        }
    }

    #[test]
    fn it_is_even_and_positive_inside_and_of_integral_1() {
        for n in DEGREES {
            let b = basis(n);
            assert_eq!(b.integral(), Some(q(1, 1)));
            // Off the box's ends.
            for i in -80..=80 {
                let x = q(2 * i + 1, 16);
                assert_eq!(reflected(&b)(&x), b.evaluate(&x));
                assert_eq!(b.evaluate(&x) > 0, x.clone().abs() < q(n as i64 + 1, 2));
            }
        }
    }

    #[test]
    fn the_weights_between_two_samples_add_up_to_1() {
        assert!((0..16).all(|n| sum(&weights(&q(n, 16), 0)) == 1));
    }
}

mod sp_26 {
    use super::*;

    #[test]
    fn the_support_has_width_4() {
        assert_eq!(basis(3).support(), Some((&q(-2, 1), &q(2, 1))));
        for n in DEGREES {
            let half = q(n as i64 + 1, 2);
            assert_eq!(basis(n).support(), Some((&Rational::from(-&half), &half)));
        }
        assert_eq!((Piecewise::zero().support(), Piecewise::polynomial(polynomial(&[1])).support()), (None, None));
        assert_eq!(Piecewise::truncated_power(&q(0, 1), 1).integral(), None);
        assert_eq!(Piecewise::zero().integral(), Some(q(0, 1)));
    }
}

mod sp_27 {
    use super::*;

    #[test]
    fn four_are_seen_and_three_from_an_integer() {
        for n in -32..32_i64 {
            let x = q(n, 8);
            let seen: Vec<i64> = (-9..=9).filter(|k| b3(&Rational::from(&x - *k)) != 0).collect();
            let i = n.div_euclid(8);
            let expected: Vec<i64> = if n % 8 == 0 { (i - 1..=i + 1).collect() } else { (i - 1..=i + 2).collect() };
            assert_eq!(seen, expected);
            let by_weights = weights(&(x - i), 0).iter().filter(|w| **w != 0).count();
            assert_eq!(by_weights, seen.len());
        }
    }
}
