//! Coefficients and values of exact cubic splines, plain beside fast.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use isoracle::number::Rational;
use isoracle::spline::prefilter;
use isoracle::spline::prefilter_fast_exact::{self as fast, IntegerSpline};
use isoracle::spline::signal::{Boundary, Signal};
use std::hint::black_box;

/// A volume of n³ integers of ten bits.
fn volume(n: usize, boundary: Boundary) -> Signal<3> {
    let value = |m: usize| Rational::from((m * m * 7919 + 13) % 1021);
    Signal::new([n; 3], (0..n * n * n).map(value).collect(), boundary).expect("the shape is sound")
}

/// Coefficients: of 17³ samples plain and fast, of 64³ fast.
fn coefficients(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("spline/coefficients");
    group.sample_size(10);
    for (name, boundary) in [("mirror", Boundary::Mirror), ("periodic", Boundary::Periodic)] {
        let signal = volume(17, boundary);
        group.throughput(Throughput::Elements(17 * 17 * 17));
        group.bench_function(format!("plain/17/{name}"), |bencher| {
            bencher.iter(|| prefilter::interpolate(black_box(&signal)));
        });
        group.bench_function(format!("fast/17/{name}"), |bencher| {
            bencher.iter(|| fast::interpolate(black_box(&signal)));
        });
        group.bench_function(format!("integers/17/{name}"), |bencher| {
            bencher.iter(|| IntegerSpline::interpolate(black_box(&signal)));
        });
    }
    let signal = volume(64, Boundary::Mirror);
    group.throughput(Throughput::Elements(64 * 64 * 64));
    group.bench_function("fast/64/mirror", |bencher| bencher.iter(|| fast::interpolate(black_box(&signal))));
    group.bench_function("integers/64/mirror", |bencher| {
        bencher.iter(|| IntegerSpline::interpolate(black_box(&signal)));
    });
}

/// Values and jets at points between the samples of 17³.
fn points(criterion: &mut Criterion) {
    const POINTS: usize = 200;
    let mut group = criterion.benchmark_group("spline/points");
    group.throughput(Throughput::Elements(POINTS as u64)).sample_size(10);
    let signal = volume(17, Boundary::Mirror);
    let fast = IntegerSpline::interpolate(&signal);
    let plain = fast.spline();
    let place = |m: usize| [m * 37, m * 53, m * 71].map(|n| Rational::from((n % 1024, 64)));
    let points: Vec<[Rational; 3]> = (0..POINTS).map(place).collect();
    group.bench_function("plain/values", |bencher| {
        bencher.iter(|| points.iter().map(|at| plain.value(black_box(at))).collect::<Vec<_>>());
    });
    group.bench_function("fast/values", |bencher| bencher.iter(|| fast.values(black_box(&points))));
    group.bench_function("plain/jets", |bencher| {
        bencher.iter(|| points.iter().map(|at| plain.jet(black_box(at))).collect::<Vec<_>>());
    });
    group.bench_function("fast/jets", |bencher| bencher.iter(|| fast.jets(black_box(&points))));
}

criterion_group!(benches, coefficients, points);
criterion_main!(benches);
