//! The certified prefilter against the plain one, and against coefficients that were chosen first.

use super::q;
use isoracle::number::binary::{from_f64, nearest_f64};
use isoracle::number::{Integer, Rational};
use isoracle::spline::prefilter::fast::{Enclosed, FastError, Sample, coefficients};
use isoracle::spline::prefilter::{interpolate, solve};
use isoracle::spline::signal::{Boundary, Signal, SignalError};
use proptest::prelude::*;

const BOTH: [Boundary; 2] = [Boundary::Mirror, Boundary::Periodic];

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// A pseudo-random word.
fn word(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 32) << 32 | seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32
}

/// A pseudo-random number in (−1, 1).
fn fraction(seed: &mut u64) -> f64 {
    (word(seed) as i64 >> 11) as f64 * 2_f64.powi(-52)
}

/// The plain answer, exactly.
fn exactly<T: Sample, const N: usize>(samples: &[T], shape: [usize; N], boundary: Boundary) -> Vec<Rational> {
    let exact = samples.iter().map(|g| from_f64(g.value()).expect("finite")).collect();
    let signal = Signal::new(shape, exact, boundary).expect("the shape fits");
    interpolate(&signal).coefficients().values().to_vec()
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|x| x.to_bits()).collect()
}

/// Equal to the plain answer bit for bit, signs of zeros too.
fn assert_rounded<T: Sample, const N: usize>(samples: &[T], shape: [usize; N], boundary: Boundary) {
    let fast = coefficients(samples, shape, boundary);
    let plain: Vec<f64> = exactly(samples, shape, boundary).iter().map(nearest_f64).collect();
    match plain.iter().position(|x| x.is_infinite()) {
        Some(index) => assert_eq!(fast, Err(FastError::Overflow { index })),
        None => assert_eq!(bits(&fast.expect("finite")), bits(&plain), "{shape:?} {boundary:?}"),
    }
}

/// The samples of integer coefficients that are multiples of 6ᴺ: integers.
fn samples_of<const N: usize>(c: &[i64], shape: [usize; N], boundary: Boundary) -> Vec<f64> {
    let mut values = c.to_vec();
    let mut stride = 1;
    for n in shape {
        let at = |i: usize, step: i64| {
            let k = (i / stride % n) as i64;
            let folded = boundary.index(&Integer::from(k + step), n);
            i - (k as usize) * stride + folded * stride
        };
        values = (0..values.len())
            .map(|i| values[at(i, -1)] + 4 * values[i] + values[at(i, 1)])
            .map(|sum| sum / 6)
            .collect();
        stride *= n;
    }
    assert!(values.iter().all(|g| *g as f64 as i64 == *g), "each sample is a binary64");
    values.iter().map(|g| *g as f64).collect()
}

mod sp_79 {
    use super::*;

    #[test]
    fn the_factors_of_the_elimination_are_ratios_of_chebyshev_numbers() {
        // s[k] = T_k(2)/T_{k+1}(2), and the last divisor 4 − 2s[n−2]: so the first line of the inverse is as it is there.
        let mut s = q(1, 2);
        let (mut t, mut next) = (Integer::from(1), Integer::from(2));
        for n in 2..40_usize {
            assert_eq!(s, Rational::from((t.clone(), next.clone())));
            let unit: Vec<Rational> = (0..n).map(|k| q(i64::from(k == n - 1), 1)).collect();
            let c = solve(&unit, Boundary::Mirror);
            assert_eq!(c[n - 1], Rational::from(6) / (Rational::from(4) - Rational::from(&s * 2_u32)));
            assert_eq!(c[n - 2], -Rational::from(&s * &c[n - 1]));
            s = Rational::from(1) / (Rational::from(4) - s);
            (t, next) = (next.clone(), Integer::from(&next * 4_u32) - t);
        }
    }

    #[test]
    fn lines_of_every_length_are_rounded() {
        let mut seed = 3;
        for boundary in BOTH {
            for n in (2..70).chain([129, 200]) {
                let line: Vec<f64> = (0..n).map(|_| fraction(&mut seed)).collect();
                assert_rounded(&line, [n], boundary);
                // The same lines side by side: each is solved in a lane of its own.
                let rows: Vec<f64> = (0..11 * n).map(|i| line[i / 11] * (1 + i % 11) as f64).collect();
                let fast = coefficients(&rows, [11, n], boundary).expect("finite");
                let first_row: Vec<f64> = fast.iter().step_by(11).copied().collect();
                let factor = exactly(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0], [11], boundary);
                let exact = exactly(&line, [n], boundary);
                // The products of the samples are rounded, so only nearly those of the coefficients.
                for (x, c) in first_row.iter().zip(&exact) {
                    let product = nearest_f64(&Rational::from(c * &factor[0]));
                    assert!((x - product).abs() <= 1e-13);
                }
            }
        }
    }
}

mod sp_80 {
    use super::*;

    fn assert_enclosed<const N: usize>(samples: &[f64], shape: [usize; N], boundary: Boundary, is_narrow: bool) {
        let enclosed = Enclosed::new(samples, shape, boundary).expect("sound");
        for (i, c) in exactly(samples, shape, boundary).iter().enumerate() {
            let (lo, hi) = enclosed.bounds(i);
            assert!(lo <= *c && *c <= hi, "coefficient {i}");
            if is_narrow {
                // Within 2⁻⁹⁰ of the largest sample.
                assert!((hi - lo) << 90_u32 <= 1);
            }
        }
    }

    #[test]
    fn every_coefficient_lies_in_its_enclosure() {
        let mut seed = 5;
        for boundary in BOTH {
            for n in [2, 3, 5, 17, 64] {
                let g: Vec<f64> = (0..n).map(|_| fraction(&mut seed)).collect();
                assert_enclosed(&g, [n], boundary, true);
            }
            for shape in [[9, 2, 7], [3, 8, 4], [2, 2, 2], [5, 13, 3]] {
                let g: Vec<f64> = (0..shape.iter().product()).map(|_| fraction(&mut seed)).collect();
                assert_enclosed(&g, shape, boundary, true);
                // Of any size.
                let g: Vec<f64> = g.iter().map(|g| g * 2_f64.powi((word(&mut seed) % 2000) as i32 - 1000)).collect();
                assert_enclosed(&g, shape, boundary, false);
            }
        }
    }

    #[test]
    fn the_error_is_small_beside_the_coefficient_far_from_an_impulse() {
        let mut line = vec![0.0; 120];
        line[3] = 1.0;
        let enclosed = Enclosed::new(&line, [120], Boundary::Mirror).expect("sound");
        for i in 0..120 {
            let (lo, hi) = enclosed.bounds(i);
            let width = Rational::from(&hi - &lo);
            assert!(width << 90_u32 < lo.abs(), "coefficient {i}");
        }
    }
}

mod sp_81 {
    use super::*;

    /// Samples that are odd about a plane: coefficients that are 0 there, where rounding leaves any small number.
    fn odd_about_a_plane(n: usize, seed: &mut u64) -> Vec<f64> {
        let mut g = vec![0.0; n * n * n];
        for i in 0..n * n * n {
            let (x, y, z) = (i % n, i / n % n, i / n / n);
            if y < n / 2 {
                g[i] = fraction(seed);
                g[x + n * (n - 1 - y) + n * n * z] = -g[i];
            }
        }
        g
    }

    #[test]
    fn a_plane_of_zeros_is_exactly_zero() {
        let mut seed = 7;
        let n = if is_long() { 65 } else { 17 };
        let g = odd_about_a_plane(n, &mut seed);
        let c = coefficients(&g, [n; 3], Boundary::Mirror).expect("finite");
        for (i, x) in c.iter().enumerate() {
            if i / n % n == n / 2 {
                assert_eq!(x.to_bits(), 0, "+0 at {i}");
            } else {
                assert!(*x != 0.0);
            }
        }
        assert_rounded(&odd_about_a_plane(5, &mut seed), [5; 3], Boundary::Mirror);
        assert_rounded(&odd_about_a_plane(7, &mut seed), [7; 3], Boundary::Periodic);
    }

    #[test]
    fn ties_go_to_the_even_one() {
        // c = 6m at the even places, 3m odd with 54 bits: half-way between two binary64; 0 at the odd places.
        let mut seed = 9;
        for boundary in BOTH {
            for _ in 0..20 {
                let n = if boundary == Boundary::Mirror { 9 } else { 8 };
                let m = || {
                    let third = ((1_i64 << 53) / 3 + 2) | 1;
                    let m = third + 2 * (word(&mut seed) % (1 << 50)) as i64;
                    assert!((1 << 53..1 << 54).contains(&(3 * m)));
                    if word(&mut seed).is_multiple_of(2) { m } else { -m }
                };
                let m: Vec<i64> = std::iter::repeat_with(m).take(n).collect();
                let c: Vec<i64> = (0..n).map(|k| if k % 2 == 0 { 6 * m[k] } else { 0 }).collect();
                let fast = coefficients(&samples_of(&c, [n], boundary), [n], boundary).expect("finite");
                for (x, c) in fast.iter().zip(&c) {
                    assert_eq!(x.to_bits(), nearest_f64(&Rational::from(*c)).to_bits());
                    assert_eq!((*x as i64 - c).abs(), if *c == 0 { 0 } else { 2 }, "half a unit of 4 away");
                }
            }
        }
    }

    #[test]
    fn what_is_nearly_a_tie_goes_to_its_side() {
        // As above, one m alone, and a tiny sample two places from it: c is moved by √3z²·tiny or so.
        for boundary in BOTH {
            let powers = [-30, -52, -60, -70, -110, -300, -1000].map(|e| 2_f64.powi(e));
            for tiny in powers.into_iter().chain([f64::from_bits(1)]) {
                for sign in [1.0, -1.0] {
                    let m = 3_002_399_751_580_331_i64 + 2;
                    let c = [0, 0, 0, 6 * m, 0, 0, 0, 0];
                    let mut g = samples_of(&c, [8], boundary);
                    assert_eq!(g[5], 0.0);
                    g[5] = sign * tiny;
                    assert_rounded(&g, [8], boundary);
                    let x = coefficients(&g, [8], boundary).expect("finite")[3];
                    // z² > 0: it moves to the tiny sample's side.
                    assert_eq!((x as i64 - c[3]).signum() as f64, sign);
                }
            }
        }
    }

    /// Planes so large that their integers are not held at once: zeros in each of them.
    #[test]
    fn planes_that_are_held_one_by_one_give_the_same() {
        let shape = if is_long() { [731, 719, 2] } else { [31, 29, 2] };
        let mut seed = 17;
        let mut g = vec![0.0; shape.iter().product()];
        for row in g.chunks_mut(shape[0]) {
            for x in 0..row.len() / 2 {
                row[x] = fraction(&mut seed);
                row[shape[0] - 1 - x] = -row[x];
            }
        }
        let c = coefficients(&g, shape, Boundary::Mirror).expect("finite");
        assert!(c.chunks(shape[0]).all(|row| row[shape[0] / 2].to_bits() == 0));
        assert!(c.chunks(shape[0]).all(|row| row.iter().filter(|x| **x == 0.0).count() == 1));
    }

    #[test]
    fn signs_far_below_the_least_binary64_are_right() {
        // From the end of a long line the coefficients fall below what doubled numbers hold.
        let mut g = vec![0.0; 2 * 3 * 1200];
        g[1] = 1.0;
        let c = coefficients(&g, [2, 3, 1200], Boundary::Mirror).expect("finite");
        let lines = [[0, 1, 0].as_slice(), &[1, 0, 0]].map(|g: &[i32]| {
            let n = if g[0] == 0 { 2 } else { 3 };
            solve(&g[..n].iter().map(|g| Rational::from(*g)).collect::<Vec<_>>(), Boundary::Mirror)
        });
        let mut long = vec![Rational::new(); 1200];
        long[0] = q(1, 1);
        let long = solve(&long, Boundary::Mirror);
        for (i, x) in c.iter().enumerate() {
            let exact = Rational::from(&lines[0][i % 2] * &lines[1][i / 2 % 3]) * &long[i / 6];
            assert_eq!(x.to_bits(), nearest_f64(&exact).to_bits(), "coefficient {i}");
        }
        assert!(c.iter().rev().take(6).any(|x| x.to_bits() == (-0.0_f64).to_bits()), "a sign below all binary64");
    }
}

mod sp_82 {
    use super::*;

    #[test]
    fn small_lines_of_small_integers_are_rounded_exhaustively() {
        for boundary in BOTH {
            for n in 2..=5_usize {
                for code in 0..5_usize.pow(n as u32) {
                    let line: Vec<i8> = (0..n).map(|k| (code / 5_usize.pow(k as u32) % 5) as i8 - 2).collect();
                    assert_rounded(&line, [n], boundary);
                }
            }
            for code in 0..3_usize.pow(8) {
                let cube: Vec<i32> = (0..8).map(|k| (code / 3_usize.pow(k) % 3) as i32 - 1).collect();
                if code % 7 == 0 || is_long() {
                    assert_rounded(&cube, [2; 3], boundary);
                }
            }
        }
    }

    #[test]
    fn every_small_shape_is_rounded() {
        let mut seed = 1;
        for boundary in BOTH {
            for i in 2..6 {
                for j in 2..6 {
                    for k in 2..5 {
                        let g: Vec<f64> = (0..i * j * k).map(|_| fraction(&mut seed)).collect();
                        assert_rounded(&g, [i, j, k], boundary);
                    }
                    let g: Vec<f32> = (0..i * j).map(|_| fraction(&mut seed) as f32).collect();
                    assert_rounded(&g, [i, j], boundary);
                }
            }
            // Wider than a block, and by no multiple of one.
            let g: Vec<f64> = (0..37 * 3 * 2).map(|_| fraction(&mut seed)).collect();
            for shape in [[37, 3, 2], [3, 37, 2], [2, 3, 37], [2, 37, 3]] {
                assert_rounded(&g, shape, boundary);
            }
        }
    }

    #[test]
    fn coefficients_that_were_chosen_first_are_found() {
        let n = if is_long() { 96 } else { 20 };
        let mut seed = 11;
        for boundary in BOTH {
            let shape = [n, n + 1, n - 1];
            let c: Vec<i64> = (0..shape.iter().product()).map(|_| 216 * (word(&mut seed) as i64 >> 20)).collect();
            let found = coefficients(&samples_of(&c, shape, boundary), shape, boundary).expect("finite");
            assert!(found.iter().zip(&c).all(|(x, c)| *x == *c as f64));
        }
    }

    #[test]
    fn impulses_decay_without_losing_a_bit() {
        // The product of the lines' coefficients, exact.
        let n: usize = if is_long() { 64 } else { 24 };
        for (boundary, at) in [(Boundary::Mirror, [0, n / 2, n - 1]), (Boundary::Periodic, [1, 0, n / 3])] {
            let mut g = vec![0_u8; n * n * n];
            g[at[0] + n * at[1] + n * n * at[2]] = 255;
            let lines = at.map(|at| {
                let unit: Vec<Rational> = (0..n).map(|k| Rational::from(u8::from(k == at))).collect();
                solve(&unit, boundary)
            });
            let found = coefficients(&g, [n; 3], boundary).expect("finite");
            for (i, x) in found.iter().enumerate().filter(|(i, _)| is_long() || i % 5 == 0) {
                let exact = Rational::from(&lines[0][i % n] * &lines[1][i / n % n]) * &lines[2][i / n / n] * 255_u32;
                assert_eq!(x.to_bits(), nearest_f64(&exact).to_bits(), "coefficient {i}");
            }
        }
    }

    #[test]
    fn constants_halves_of_zeros_and_subnormals_are_rounded() {
        let mut seed = 13;
        for boundary in BOTH {
            for value in [0.0, -0.0, 1.0, -0.1, f64::MAX / 2.0, f64::MIN_POSITIVE, 5e-324, -1e-320] {
                let c = coefficients(&[value; 60], [3, 4, 5], boundary).expect("finite");
                assert!(c.iter().all(|x| x.to_bits() == (value + 0.0).to_bits()), "{value}");
            }
            let g: Vec<f64> = (0..200).map(|i| if i < 100 { 0.0 } else { fraction(&mut seed) }).collect();
            assert_rounded(&g, [10, 20], boundary);
            assert_rounded(&g, [200], boundary);
            let g: Vec<f64> =
                (0..60).map(|_| f64::from_bits(word(&mut seed) >> 40) * fraction(&mut seed).signum()).collect();
            assert_rounded(&g, [5, 4, 3], boundary);
            let g: Vec<f64> = g.iter().map(|g| g * 2_f64.powi(30)).collect();
            assert_rounded(&g, [3, 20], boundary);
            let g: Vec<f64> = (0..60).map(|i| [1e300, 1e-300, -1e300, 0.0, 3e-310][(i * i) % 5]).collect();
            assert_rounded(&g, [4, 5, 3], boundary);
        }
    }

    #[test]
    fn errors_name_what_is_wrong() {
        let of = |g: &[f64], shape| coefficients(g, shape, Boundary::Mirror);
        assert_eq!(of(&[1.0], [1]), Err(FastError::Signal(SignalError::Side { axis: 0, n: 1 })));
        assert_eq!(of(&[1.0; 3], [2]), Err(FastError::Signal(SignalError::Values { expected: 2, found: 3 })));
        let two = coefficients(&[1.0; 3], [3, 1], Boundary::Periodic);
        assert_eq!(two, Err(FastError::Signal(SignalError::Side { axis: 1, n: 1 })));
        let large = coefficients(&[1.0], [usize::MAX, 2], Boundary::Mirror);
        assert_eq!(large, Err(FastError::Signal(SignalError::TooLarge)));
        let infinite = of(&[1.0, f64::NEG_INFINITY, f64::NAN], [3]).expect_err("infinite");
        assert_eq!(infinite.to_string(), "values[1]: -inf is not a number here");
        let nan = of(&[1.0, 0.0, f64::NAN], [3]).expect_err("no number");
        assert_eq!(nan.to_string(), "values[2]: NaN is not a number here");
        // 2g₀ − g₁ = 3·MAX.
        let overflow = of(&[f64::MAX, -f64::MAX], [2]);
        assert_eq!(overflow, Err(FastError::Overflow { index: 0 }));
        assert_eq!(overflow.expect_err("too large").to_string(), "coefficients[0]: too large for a binary64");
    }

    #[test]
    fn the_largest_finite_number_is_the_last_one() {
        // c = 2g₀ − g₁ is 2¹⁰²⁴ − 2⁹⁷⁰, the first that rounds to an infinity, and just below.
        let g = [f64::MAX / 2.0, -(2_f64.powi(970))];
        assert_rounded(&g, [2], Boundary::Mirror);
        assert!(coefficients(&g, [2], Boundary::Mirror).is_err());
        for tiny in [5e-324, 1.0, 2_f64.powi(900)] {
            let g = [f64::MAX / 2.0, -(2_f64.powi(970)).next_down(), tiny];
            assert_rounded(&g, [3], Boundary::Mirror);
            assert_rounded(&g[..2], [2], Boundary::Periodic);
        }
        assert_eq!(coefficients(&[f64::MAX; 4], [4], Boundary::Mirror), Ok(vec![f64::MAX; 4]));
    }

    #[test]
    fn integers_of_every_width_are_taken() {
        let g = [-7_i8, 3, 90, 11, -128, 127];
        let expected = coefficients(&g.map(f64::from), [3, 2], Boundary::Mirror).expect("finite");
        assert_eq!(coefficients(&g, [3, 2], Boundary::Mirror).as_ref(), Ok(&expected));
        assert_eq!(coefficients(&g.map(i16::from), [3, 2], Boundary::Mirror).as_ref(), Ok(&expected));
        assert_eq!(coefficients(&g.map(i32::from), [3, 2], Boundary::Mirror).as_ref(), Ok(&expected));
        assert_eq!(coefficients(&g.map(f32::from), [3, 2], Boundary::Mirror).as_ref(), Ok(&expected));
        let g = [u32::MAX, 0, 5];
        assert_eq!(coefficients(&g, [3], Boundary::Periodic), coefficients(&g.map(f64::from), [3], Boundary::Periodic));
        let g = [255_u8, 0, 5];
        assert_eq!(coefficients(&g, [3], Boundary::Periodic), coefficients(&g.map(u16::from), [3], Boundary::Periodic));
    }

    /// A finite binary64 of any size, near others in size, or the negative of another.
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            2 => (-1.0..1.0).prop_map(|x| x),
            2 => any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
            2 => (-8..8_i32).prop_map(f64::from),
            1 => (-1074..1020_i32).prop_map(|e| 2_f64.powi(e)),
            1 => Just(0.0),
        ]
    }

    proptest! {
        #[test]
        fn volumes_of_anything_are_rounded(
            shape in prop::array::uniform3(2..5_usize), numbers in prop::collection::vec(number(), 64), mirror in any::<bool>(),
        ) {
            let count = shape.iter().product();
            let boundary = if mirror { Boundary::Mirror } else { Boundary::Periodic };
            assert_rounded(&numbers[..count], shape, boundary);
            assert_rounded(&numbers[..count], [count], boundary);
        }

        /// A number and its negative, mirrored: cancellation to nothing, or to something tiny beside it.
        #[test]
        fn cancelling_lines_are_rounded(half in prop::collection::vec(number(), 1..6), tiny in number(), mirror in any::<bool>()) {
            let mut line: Vec<f64> = half.iter().copied().chain([tiny]).chain(half.iter().rev().map(|x| -x)).collect();
            let boundary = if mirror { Boundary::Mirror } else { Boundary::Periodic };
            assert_rounded(&line, [line.len()], boundary);
            let middle = half.len();
            line[middle] = 0.0;
            assert_rounded(&line, [line.len()], boundary);
        }
    }
}
