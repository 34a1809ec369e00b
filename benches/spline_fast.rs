//! The certified prefilter: whole volumes, random, decaying from an impulse, and odd about a plane of exact zeros.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use isoracle::number::Rational;
use isoracle::spline::prefilter::fast::{Enclosed, coefficients};
use isoracle::spline::signal::Boundary;
use std::hint::black_box;

/// A pseudo-random number in (−1, 1), the same in every run.
fn fraction(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed as i64 >> 11) as f64 / (1_u64 << 52) as f64
}

fn volumes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("spline/prefilter/fast");
    for side in [64_usize, 128] {
        let count = side.pow(3);
        group.throughput(Throughput::Elements(count as u64)).sample_size(10);
        let mut seed = 1;
        let random: Vec<f64> = (0..count).map(|_| fraction(&mut seed)).collect();
        let impulse: Vec<f64> = (0..count).map(|i| if i == 5 { 1.0 } else { 0.0 }).collect();
        // x ↦ side − 1 − x turns the sign; no sample lies on the plane between, so nothing is in doubt.
        let odd: Vec<f64> = (0..count)
            .map(|i| if i % side < side / 2 { random[i] } else { -random[i / side * side + side - 1 - i % side] })
            .collect();
        for (name, volume) in [("random", &random), ("impulse", &impulse), ("odd", &odd)] {
            for boundary in [Boundary::Mirror, Boundary::Periodic] {
                group.bench_function(format!("{side}/{name}/{boundary:?}"), |bencher| {
                    bencher.iter(|| coefficients(black_box(volume), [side; 3], boundary));
                });
            }
        }
        // One sample fewer along x: a plane of exact zeros.
        let shape = [side - 1, side, side];
        let n = side - 1;
        let mut zeros = vec![0.0; n * side * side];
        for i in 0..zeros.len() {
            let x = i % n;
            if x < n / 2 {
                zeros[i] = random[i];
                zeros[i - x + n - 1 - x] = -random[i];
            }
        }
        group.bench_function(format!("{side}/plane of zeros/Mirror"), |bencher| {
            bencher.iter(|| coefficients(black_box(&zeros), shape, Boundary::Mirror));
        });
    }
    group.finish();
}

/// Jets and curvatures at points of a volume whose coefficients are enclosed already.
fn points(criterion: &mut Criterion) {
    const SIDE: usize = 32;
    let mut seed = 1;
    let volume: Vec<f64> = (0..SIDE.pow(3)).map(|_| fraction(&mut seed)).collect();
    let volume = Enclosed::new(&volume, [SIDE; 3], Boundary::Mirror).expect("sound");
    let coordinate = |seed: &mut u64| Rational::from_f64(fraction(seed) * SIDE as f64).expect("finite");
    let points: Vec<[Rational; 3]> = (0..100).map(|_| std::array::from_fn(|_| coordinate(&mut seed))).collect();
    let mut group = criterion.benchmark_group("spline/prefilter/fast/points");
    group.throughput(Throughput::Elements(points.len() as u64)).sample_size(10);
    group.bench_function("jets", |bencher| bencher.iter(|| volume.jets(black_box(&points))));
    group.bench_function("level surfaces", |bencher| bencher.iter(|| volume.level_surfaces(black_box(&points))));
    group.finish();
}

criterion_group!(benches, volumes, points);
criterion_main!(benches);
