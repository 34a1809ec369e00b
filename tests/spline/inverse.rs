//! Finite signals: inverses written out, determinants, the recursive filter.

use super::{RULES, boundary, number, pivots, q, root3, signal};
use isoracle::number::{Integer, OrderedField, Polynomial, Rational, Ring, Sign, Surd};
use isoracle::spline::impulse::{coefficient, inverse_filter};
use isoracle::spline::inverse::{
    convergent, determinant, entry, entry_by_images, images, interior_determinant, matrix, mirrored_period, numerators,
    periodic_excess, periodic_excess_bound, solve,
};
use isoracle::spline::prefilter;
use isoracle::spline::recursive;
use isoracle::spline::signal::{Boundary, SignalError};
use proptest::prelude::*;

const SIDES: std::ops::RangeInclusive<usize> = 2..=20;

/// 6A from the definition: row k says where c[k − 1], c[k], c[k + 1] stand.
fn written_out(n: usize, boundary: Boundary) -> Vec<Vec<i64>> {
    let fold = |k: i64| -> usize {
        let n = n as i64;
        match boundary {
            Boundary::Periodic => k.rem_euclid(n) as usize,
            Boundary::Mirror if k < 0 => -k as usize,
            Boundary::Mirror if k >= n => (2 * n - 2 - k) as usize,
            Boundary::Mirror => k as usize,
        }
    };
    let row = |k: usize| {
        let mut row = vec![0; n];
        for (step, weight) in [(-1, 1), (0, 4), (1, 1)] {
            row[fold(k as i64 + step)] += weight;
        }
        row
    };
    (0..n).map(row).collect()
}

/// The determinant by elimination.
fn eliminated(rows: &[Vec<i64>]) -> Rational {
    let rows = rows.iter().map(|row| row.iter().map(|a| q(*a, 1)).collect()).collect();
    let n = Vec::len(&rows);
    let (rank, product) = pivots(rows);
    if rank < n { q(0, 1) } else { product }
}

fn size(x: Surd) -> Surd {
    if x.sign() == Sign::Negative { -x } else { x }
}

mod sp_64 {
    use super::*;

    #[test]
    fn images_are_rational_inverse_matrices() {
        for boundary in RULES {
            for n in 2..=12 {
                for i in 0..n {
                    for j in 0..n {
                        let sum = entry_by_images(n, boundary, i, j);
                        assert_eq!(sum.rational(), Some(&entry(n, boundary, i, j)), "{boundary:?} {n} {i} {j}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_sum_over_many_images_closes_in_on_the_geometric_series() {
        for (d, period) in [(0_u32, 1_u32), (0, 2), (1, 2), (2, 5), (7, 5), (3, 10)] {
            let partial = (-24..=24_i64).fold(Surd::integer(0), |sum, m| {
                let place = i64::from(d) + m * i64::from(period);
                sum + &inverse_filter(place.unsigned_abs() as u32)
            });
            assert!(size(partial - &images(d, period)) < Surd::from(q(1, 100_000)), "{d} {period}");
        }
        // Of all integers Σ h = 1; of the even ones, (1 + 3)/2, by Σ h = 1 and Σ (−1)ᵏh = 3.
        assert_eq!([images(0, 1), images(0, 2), images(1, 2)], [1, 2, -1].map(Surd::integer));
    }
}

mod sp_65 {
    use super::*;

    #[test]
    fn every_side_from_2_to_20() {
        for boundary in RULES {
            for n in SIDES {
                let g: Vec<Rational> = (0..n).map(|k| q((k as i64 * 37 + 11) % 19 - 9, 1 + k as i64 % 3)).collect();
                assert_eq!(solve(&g, boundary), Ok(prefilter::solve(&g, boundary)), "{boundary:?} {n}");
            }
        }
    }

    proptest! {
        #[test]
        fn equal_to_the_recursion(g in prop::collection::vec(number(), 2..=20), boundary in boundary()) {
            prop_assert_eq!(solve(&g, boundary), Ok(prefilter::solve(&g, boundary)));
        }
    }

    #[test]
    fn lines_that_are_too_short_are_refused() {
        for n in 0..2 {
            let g = vec![q(1, 1); n];
            for boundary in RULES {
                assert_eq!(solve(&g, boundary), Err(SignalError::Side { axis: 0, n }));
                assert_eq!(recursive::solve(&g, boundary), Err(SignalError::Side { axis: 0, n }));
            }
            assert_eq!(mirrored_period(&g), Err(SignalError::Side { axis: 0, n }));
        }
    }
}

/// A⁻¹A = 1, entry by entry.
fn inverts(n: usize, boundary: Boundary) {
    let a = written_out(n, boundary);
    for i in 0..n {
        (0..n).for_each(|j| {
            let product = (0..n).fold(Rational::new(), |sum, k| sum + entry(n, boundary, i, k) * q(a[k][j], 6));
            assert_eq!(product, q(i64::from(i == j), 1), "{boundary:?} {n} {i} {j}");
        });
    }
}

mod sp_66 {
    use super::*;

    #[test]
    fn the_mirror_inverse_is_a_product_of_two_convergents() {
        SIDES.for_each(|n| inverts(n, Boundary::Mirror));
        let three = |i, j| entry(3, Boundary::Mirror, i, j);
        assert_eq!([three(0, 0), three(0, 1), three(0, 2), three(1, 1)], [q(7, 4), q(-1, 1), q(1, 4), q(2, 1)]);
    }
}

mod sp_67 {
    use super::*;

    #[test]
    fn the_periodic_inverse_is_a_convergent_by_a_denominator() {
        SIDES.for_each(|n| inverts(n, Boundary::Periodic));
        assert_eq!([0, 1, 2].map(|j| entry(3, Boundary::Periodic, 0, j)), [q(5, 3), q(-1, 3), q(-1, 3)]);
    }
}

mod sp_68 {
    use super::*;

    #[test]
    fn determinants_in_closed_form() {
        for n in 2..=14 {
            for boundary in RULES {
                let rows = written_out(n, boundary);
                assert_eq!(Rational::from(determinant(n, boundary)), eliminated(&rows), "{boundary:?} {n}");
                let integers = matrix(n, boundary);
                assert!((0..n).all(|i| (0..n).all(|j| integers[i][j] == rows[i][j])));
            }
        }
    }

    #[test]
    fn without_a_rule_it_is_a_chebyshev_polynomial() {
        let tridiagonal = |n: usize| -> Vec<Vec<i64>> {
            (0..n).map(|i| (0..n).map(|j| [4, 1, 0][i.abs_diff(j).min(2)]).collect()).collect()
        };
        // Uₙ₊₁ = 2xUₙ − Uₙ₋₁ at x = 2.
        let (mut u, mut next) = (Integer::from(1), Integer::from(4));
        for n in 1..=12 {
            assert_eq!(interior_determinant(n), next);
            assert_eq!(Rational::from(interior_determinant(n)), eliminated(&tridiagonal(n)));
            (u, next) = (next.clone(), next * 4 - u);
        }
    }

    #[test]
    fn the_denominators_of_the_inverses_are_no_multiple_too_large() {
        // B is the least common denominator of A⁻¹.
        for n in 2..=14_usize {
            for boundary in RULES {
                let lcm = (0..n * n).fold(Integer::from(1), |lcm, m| lcm.lcm(entry(n, boundary, m / n, m % n).denom()));
                assert_eq!(lcm, convergent(boundary.period(n) as u32).1, "{boundary:?} {n}");
            }
        }
    }
}

mod sp_69 {
    use super::*;

    proptest! {
        #[test]
        fn mirror_is_periodic_of_the_mirrored_period(g in prop::collection::vec(number(), 2..=12)) {
            let period = mirrored_period(&g).expect("long enough");
            prop_assert_eq!(period.len(), 2 * g.len() - 2);
            let c = prefilter::solve(&g, Boundary::Mirror);
            prop_assert_eq!(prefilter::solve(&period, Boundary::Periodic), mirrored_period(&c).expect("long enough"));
        }

        #[test]
        fn and_so_are_the_splines(g in prop::collection::vec(number(), 2..=6), x in -200..200_i64) {
            let n = g.len();
            let mirror = prefilter::interpolate(&signal([n], &g, Boundary::Mirror));
            let period = mirrored_period(&g).expect("long enough");
            let periodic = prefilter::interpolate(&signal([2 * n - 2], &period, Boundary::Periodic));
            prop_assert_eq!(mirror.jet(&[q(x, 16)]), periodic.jet(&[q(x, 16)]));
            prop_assert_eq!(mirror.value(&[q(x, 16)]), mirror.value(&[q(-x, 16)]));
        }
    }
}

mod sp_70 {
    use super::*;

    #[test]
    fn every_side_from_2_to_20() {
        for boundary in RULES {
            for n in SIDES {
                let g: Vec<Rational> = (0..n).map(|k| q((k as i64 * 29 + 5) % 17 - 8, 1 + k as i64 % 4)).collect();
                assert_eq!(recursive::solve(&g, boundary), Ok(prefilter::solve(&g, boundary)), "{boundary:?} {n}");
            }
        }
    }

    proptest! {
        #[test]
        fn the_recursive_filter_is_the_solution(g in prop::collection::vec(number(), 2..9), boundary in boundary()) {
            prop_assert_eq!(recursive::solve(&g, boundary), Ok(prefilter::solve(&g, boundary)));
        }
    }
}

mod sp_71 {
    use super::*;

    #[test]
    fn the_difference_is_exact_and_within_the_bound() {
        for n in 2..=12_u32 {
            for d in 0..n {
                let periodic = Surd::from(entry(n as usize, Boundary::Periodic, 0, d as usize));
                let difference = periodic - &inverse_filter(d);
                assert_eq!(difference, periodic_excess(n, d), "{n} {d}");
                assert!(size(difference) <= periodic_excess_bound(n, d), "{n} {d}");
            }
        }
    }

    #[test]
    fn a_long_line_with_few_samples_differs_little_from_an_infinite_one() {
        let n = 24_u32;
        let mut g = vec![Rational::new(); n as usize];
        for (k, value) in [(10, 3), (12, -5), (13, 7)] {
            g[k] = q(value, 1);
        }
        let samples = [(10, 3), (12, -5), (13, 7)].map(|(k, v)| (Integer::from(k), q(v, 1))).into();
        let c = prefilter::solve(&g, Boundary::Periodic);
        for (k, c) in c.iter().enumerate().take(18).skip(6) {
            let infinite = coefficient(&samples, &Integer::from(k)).expect("near");
            let bound = [(10_usize, 3), (12, 5), (13, 7)].iter().fold(Surd::integer(0), |sum, (j, v)| {
                sum + &(periodic_excess_bound(n, k.abs_diff(*j) as u32) * &Surd::integer(*v))
            });
            let difference = size(Surd::from(c.clone()) - &infinite);
            assert!(difference <= bound && bound < Surd::from(q(1, 100_000)), "{k}");
        }
    }
}

mod sp_73 {
    use super::*;

    #[test]
    fn the_continued_fraction_of_the_root_of_3() {
        let first: Vec<(i32, i32)> =
            vec![(1, 0), (1, 1), (2, 1), (5, 3), (7, 4), (19, 11), (26, 15), (71, 41), (97, 56)];
        for (k, (a, b)) in first.into_iter().enumerate() {
            assert_eq!(convergent(k as u32), (Integer::from(a), Integer::from(b)));
        }
        // A_(k+1) = a·A_k + A_(k−1) with the partial quotients 1, 2, 1, 2, …
        for k in 1..40_u32 {
            let ((a0, b0), (a1, b1), (a2, b2)) = (convergent(k - 1), convergent(k), convergent(k + 1));
            let quotient = if k % 2 == 1 { 1 } else { 2 };
            assert_eq!((a2, b2), (a1.clone() * quotient + a0, b1.clone() * quotient + b0));
            assert_eq!(a1.clone().square() - b1.clone().square() * 3, if k % 2 == 0 { 1 } else { -2 });
        }
    }

    #[test]
    fn powers_of_2_plus_the_root_of_3() {
        let mut power = root3(1, 0);
        for m in 0..20 {
            let (a, b) = convergent(2 * m);
            assert_eq!(
                power.parts(),
                (&Rational::from(a), &Rational::from(b), &Integer::from(if m == 0 { 1 } else { 3 }))
            );
            power = power * &root3(2, 1);
        }
        for k in 0..40 {
            let all = numerators(k);
            assert_eq!((all.len(), &all[k]), (k + 1, &convergent(k as u32).0));
        }
        // T_m(2) by the recursion of Chebyshev polynomials.
        let two = Polynomial::new(vec![q(4, 1)]);
        let (mut t, mut next) = (Polynomial::new(vec![q(1, 1)]), Polynomial::new(vec![q(2, 1)]));
        for m in 0..12_u32 {
            assert_eq!(t.coefficients(), [Rational::from(convergent(2 * m).0)]);
            (t, next) = (next.clone(), next * &two - &t);
        }
    }
}
