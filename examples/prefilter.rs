//! Times the certified prefilter on a volume: `prefilter IN OUT nx ny nz mirror|periodic REPEATS`.
//!
//! IN and OUT hold little-endian binary64 numbers, the first axis fastest. Prints the CPU seconds of each repeat, one a line, without
//! reading and writing. `scipy_spline_filter.py` beside this file runs it beside scipy.

use isoracle::spline::prefilter::fast::coefficients;
use isoracle::spline::signal::Boundary;
use std::error::Error;
use std::time::Instant;
use std::{env, fs};

/// Seconds that this process has run for; those of the clock where the system does not say.
fn cpu_seconds(since: Instant) -> f64 {
    let nanoseconds =
        fs::read_to_string("/proc/self/schedstat").ok().and_then(|s| s.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| since.elapsed().as_secs_f64(), |n| n * 1e-9)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [input, output, nx, ny, nz, boundary, repeats] = arguments.as_slice() else {
        return Err("usage: prefilter IN OUT nx ny nz mirror|periodic REPEATS".into());
    };
    let shape = [nx.parse()?, ny.parse()?, nz.parse()?];
    let boundary = match boundary.as_str() {
        "mirror" => Boundary::Mirror,
        "periodic" => Boundary::Periodic,
        other => return Err(format!("{other} is no boundary rule").into()),
    };
    let bytes = fs::read(input)?;
    let samples: Vec<f64> = bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().expect("eight"))).collect();
    let start = Instant::now();
    let mut result = Vec::new();
    for _ in 0..repeats.parse::<usize>()?.max(1) {
        let before = cpu_seconds(start);
        result = coefficients(&samples, shape, boundary)?;
        println!("{:.6}", cpu_seconds(start) - before);
    }
    fs::write(output, result.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>())?;
    Ok(())
}
