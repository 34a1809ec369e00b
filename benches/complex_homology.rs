//! Homology of large triangulations on one core, each in a process of its own: seconds and peak memory.
//!
//! Target: a million tetrahedra within 60 s. `cargo bench --bench complex_homology` takes a 3-torus of 55³ cubes in 6 tetrahedra
//! each, and lens spaces subdivided barycentrically; `cargo bench --bench complex_homology -- 20` the torus of 20³ cubes alone.

#[path = "../tests/complex/subdivided.rs"]
mod subdivided;

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::lens_space;
use isoracle::complex::homology_fast::homology;
use isoracle::complex::kuhn_torus::kuhn_torus;
use isoracle::complex::triangulation::Triangulation;
use std::process::Command;
use std::time::Instant;

const CUBES: usize = 55;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let numbers: Vec<u32> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    match numbers[..] {
        [] => {
            let cases = [
                vec![CUBES.to_string()],
                vec!["5".into(), "2".into(), "3".into()],
                vec!["50".into(), "19".into(), "2".into()],
            ];
            for case in cases {
                let this = std::env::current_exe().expect("this program has a file");
                assert!(Command::new(this).args(case).status().expect("it runs").success());
            }
        }
        [p, q, times] => {
            let lens = ClosedComplex::new(lens_space(p, q)).expect("a lens space");
            let fine = (0..times).fold(lens.tetrahedra(), |coarse, _| subdivided::subdivided(&coarse));
            take(&format!("L({p}, {q}) subdivided {times} times"), &fine);
        }
        _ => {
            let n = numbers[0] as usize;
            take(&format!("T³ of {n}³ cubes"), &kuhn_torus([n, n, n]));
        }
    }
}

/// Prints the homology and what it took.
fn take(name: &str, triangulation: &Triangulation) {
    let before = peak_memory();
    let start = Instant::now();
    let homology = homology(triangulation).expect("no edge is reversed");
    let seconds = start.elapsed().as_secs_f64();
    println!("{name}: {} tetrahedra", triangulation.len());
    println!("homology        {:?}, torsion {:?}", homology.betti, homology.torsion);
    println!("wall time       {seconds:.2} s");
    println!("peak memory     {} MiB, {} MiB before", peak_memory(), before);
}

/// The peak resident memory of this process in MiB, 0 where the system does not tell it.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok());
    line.map_or(0, |kib: u64| kib / 1024)
}
