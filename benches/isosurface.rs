//! One cell, the plain version: target 20,000 cells a second on one core. Whole volumes, plain beside fast.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use isoracle::isosurface::cell::{Tie, topology};
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::isosurface::{fast, mesh};
use isoracle::number::Rational;
use std::hint::black_box;

const CELLS: u64 = 1000;

/// Pseudo-random numbers, the same in every run.
fn random(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    *seed >> 33
}

/// A non-zero integer of at most nine in absolute value.
fn digit(seed: &mut u64) -> Rational {
    let magnitude = 1 + (random(seed) % 9) as i64;
    Rational::from(if random(seed).is_multiple_of(2) { magnitude } else { -magnitude })
}

/// A binary64 in (−1, 1), exactly.
fn fraction(seed: &mut u64) -> Rational {
    Rational::from_f64(random(seed) as f64 / (1_u64 << 30) as f64 - 1.0).expect("a finite number")
}

fn cells(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("isosurface/cell/topology");
    group.throughput(Throughput::Elements(CELLS));
    let isovalue = Rational::new();
    for (name, value) in [("integers", digit as fn(&mut u64) -> Rational), ("binary64", fraction)] {
        for tie in [Tie::Degenerate, Tie::Below] {
            let mut seed = 1;
            let cells: Vec<[Rational; 8]> = (0..CELLS).map(|_| std::array::from_fn(|_| value(&mut seed))).collect();
            group.bench_function(format!("{name}/{tie:?}"), |bencher| {
                bencher.iter(|| cells.iter().filter(|cell| topology(black_box(cell), &isovalue, tie).is_ok()).count());
            });
        }
    }
}

/// A wavy volume of n³ samples, with many small handles.
fn volume(n: usize, scale: f64) -> Vec<f64> {
    let wave = |t: usize| (t as f64 * 0.7).sin();
    let at = |i: usize| (wave(i % n) + wave(i / n % n) + wave(i / n / n)) * scale;
    (0..n * n * n).map(|i| at(i).round() / if scale > 1e6 { 1024.0 } else { 1.0 }).collect()
}

/// Whole volumes, plain beside fast.
fn volumes(criterion: &mut Criterion) {
    const SIDE: usize = 32;
    let mut group = criterion.benchmark_group("isosurface/mesh");
    group.throughput(Throughput::Elements((SIDE as u64 - 1).pow(3))).sample_size(10);
    let integers = volume(SIDE, 1000.0).into_iter().map(|x| x as i32).collect();
    let integers = Volume::integers([SIDE; 3], integers).expect("the shape is sound");
    let floats = Volume::floats([SIDE; 3], volume(SIDE, 1e9)).expect("the shape is sound");
    for (name, volume) in [("integers", &integers), ("binary64", &floats)] {
        let level = Level { volume, isovalue: Rational::from((1, 3)), tie: Tie::Below };
        group.bench_function(format!("plain/{name}"), |bencher| bencher.iter(|| mesh::extract(black_box(&level))));
        group.bench_function(format!("fast/{name}"), |bencher| bencher.iter(|| fast::extract(black_box(&level))));
    }
}

criterion_group!(benches, cells, volumes);
criterion_main!(benches);
