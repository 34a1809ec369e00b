//! Cells through the protocol, from line to line: target 5,000 cells a second on one core
//! (`RAYON_NUM_THREADS=1 taskset -c 0 cargo bench --bench protocol`).

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use isoracle::answer::{answer, serve};
use std::hint::black_box;
use std::io;

const CELLS: u64 = 1000;

/// Questions about cells of pseudo-random digits, the same in every run.
fn questions() -> Vec<String> {
    let mut seed = 1_u64;
    let mut digit = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let n = (seed >> 33) as i64 % 18;
        if n < 9 { n - 9 } else { n - 8 }
    };
    let values: Vec<[i64; 8]> = (0..CELLS).map(|_| std::array::from_fn(|_| digit())).collect();
    let line =
        |(id, values)| format!(r#"{{"id":{id},"op":"isosurface.cell","in":{{"values":{values:?},"isovalue":0}}}}"#);
    values.iter().enumerate().map(line).collect()
}

fn cells(criterion: &mut Criterion) {
    let questions = questions();
    let input = questions.join("\n");
    let mut group = criterion.benchmark_group("protocol/isosurface.cell");
    group.throughput(Throughput::Elements(CELLS));
    group.bench_function("serve", |bencher| bencher.iter(|| serve(black_box(input.as_bytes()), io::sink())));
    group.bench_function("answer", |bencher| {
        bencher.iter(|| questions.iter().map(|line| answer(black_box(line.as_bytes())).len()).sum::<usize>());
    });
}

criterion_group!(benches, cells);
criterion_main!(benches);
