//! The certified prefilter against the plain one.

use super::q;
use isoracle::number::binary::{from_f64, nearest_f64};
use isoracle::number::{Integer, Rational};
use isoracle::spline::prefilter::fast::{Enclosed, FastError, Sample, coefficients};
use isoracle::spline::prefilter::interpolate;
use isoracle::spline::signal::{Boundary, Signal, SignalError};
use proptest::prelude::*;

const BOTH: [Boundary; 2] = [Boundary::Mirror, Boundary::Periodic];

/// A pseudo-random word.
fn word(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 32) << 32 | seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32
}

/// The plain answer, rounded.
fn plain<T: Sample, const N: usize>(samples: &[T], shape: [usize; N], boundary: Boundary) -> Vec<f64> {
    let exact = samples.iter().map(|g| from_f64(g.value()).expect("finite")).collect();
    let signal = Signal::new(shape, exact, boundary).expect("the shape fits");
    interpolate(&signal).coefficients().values().iter().map(nearest_f64).collect()
}

/// Equal bit for bit, signs of zeros too.
fn assert_rounded<T: Sample, const N: usize>(samples: &[T], shape: [usize; N], boundary: Boundary) {
    let (fast, plain) = (coefficients(samples, shape, boundary), plain(samples, shape, boundary));
    match plain.iter().position(|x| x.is_infinite()) {
        Some(index) => assert_eq!(fast, Err(FastError::Overflow { index })),
        None => {
            let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
            assert_eq!(bits(&fast.expect("finite")), bits(&plain), "{shape:?} {boundary:?}");
        }
    }
}

mod sp_304 {
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
        }
    }

    #[test]
    fn every_small_shape_is_rounded() {
        let mut seed = 1;
        for boundary in BOTH {
            for i in 2..6 {
                for j in 2..6 {
                    for k in 2..5 {
                        let g: Vec<f64> =
                            (0..i * j * k).map(|_| word(&mut seed) as i32 as f64 * 2_f64.powi(-31)).collect();
                        assert_rounded(&g, [i, j, k], boundary);
                    }
                    let g: Vec<f32> = (0..i * j).map(|_| word(&mut seed) as i32 as f32).collect();
                    assert_rounded(&g, [i, j], boundary);
                }
            }
        }
    }
}
