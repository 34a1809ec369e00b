//! Refinement of the 3-torus and what it is as a space, plain and fast.
//!
//! Target: building and checking a refinement of a million tetrahedra within 2 s and 1 GiB on one core. `cargo bench --bench complex`
//! does that first, then small orders both ways.

use criterion::Criterion;
use isoracle::complex::check;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::three_torus;
use isoracle::complex::homology_fast;
use isoracle::complex::refine::{fast, refine};
use isoracle::complex::triangulation::Triangulation;
use std::hint::black_box;
use std::time::Instant;

/// 12·44³ = 1,022,208 tetrahedra.
const LARGE: u32 = 44;

/// 12·16³ = 49,152 tetrahedra, which the plain way can do as well in seconds.
const MIDDLE: u32 = 16;

fn main() {
    let base = ClosedComplex::new(three_torus()).expect("a closed complex").tetrahedra();
    timed("fast", &base, LARGE, true);
    timed("fast", &base, MIDDLE, true);
    timed("plain", &base, MIDDLE, false);
    let mut criterion = Criterion::default().configure_from_args();
    for order in [2, 4, 8] {
        let mut group = criterion.benchmark_group(format!("complex/refine/{order}"));
        group.bench_function("plain", |b| b.iter(|| refine(black_box(&base), order)));
        group.bench_function("fast", |b| b.iter(|| fast::refine(black_box(&base), order)));
        let refined = fast::refine(&base, order).expect("small");
        group.bench_function("check plain", |b| b.iter(|| check::check(black_box(refined.triangulation()))));
        group.bench_function("check fast", |b| b.iter(|| check::fast::check(black_box(refined.triangulation()))));
    }
    criterion.final_summary();
}

/// Builds and checks once, and prints what it took; the peak is that of the process so far.
fn timed(name: &str, base: &Triangulation, order: u32, is_fast: bool) {
    let (start, processor) = (Instant::now(), processor_time());
    let refined = if is_fast { fast::refine(base, order) } else { refine(base, order) }.expect("within the limit");
    let built = start.elapsed().as_secs_f64();
    let triangulation = refined.triangulation();
    let facts = if is_fast { check::fast::check(triangulation) } else { check::check(triangulation) };
    let all = start.elapsed().as_secs_f64();
    assert!(facts.defects.is_empty() && facts.orientable && facts.vertex_sets.simplicial, "a simplicial 3-torus");
    let peak = peak_memory().map_or("unknown".to_owned(), |kib| format!("{} MiB", kib / 1024));
    let processor =
        processor_time().zip(processor).map_or("unknown".to_owned(), |(end, start)| format!("{:.2} s", end - start));
    println!(
        "{name}: {} tetrahedra built in {built:.2} s, checked in {:.2} s; processor {processor}, peak {peak}",
        triangulation.len(),
        all - built
    );
    if is_fast {
        let start = Instant::now();
        let homology = homology_fast::homology(triangulation).expect("no edge is reversed");
        assert_eq!(homology.betti, [1, 3, 3, 1], "the 3-torus");
        let peak = peak_memory().map_or("unknown".to_owned(), |kib| format!("{} MiB", kib / 1024));
        println!("{name}: its homology from the tetrahedra in {:.2} s, peak {peak}", start.elapsed().as_secs_f64());
    }
}

/// The processor time of this process in seconds, at the usual 100 ticks a second.
fn processor_time() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks: u64 = fields.get(11)?.parse::<u64>().ok()? + fields.get(12)?.parse::<u64>().ok()?;
    Some(ticks as f64 / 100.0)
}

/// The peak resident memory in KiB, where the system tells it.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok())
}
