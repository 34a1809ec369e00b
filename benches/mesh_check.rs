//! `isoracle check mesh` on a large binary PLY, as a process: wall time, processor time, peak memory.
//!
//! Target: 10 million triangles under 30 s and 4 GiB on one core, in any order. `cargo bench --bench mesh_check` does that,
//! with vertices and faces row by row and then in random order; `cargo bench --bench mesh_check -- 1000000` a million.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const TRIANGLES: usize = 10_000_000;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let triangles = arguments.iter().find_map(|argument| argument.parse().ok()).unwrap_or(TRIANGLES);
    let folder = tempfile::tempdir().expect("a temporary folder");
    // 2·columns·rows triangles.
    let columns = (triangles as f64 / 2.0).sqrt().max(3.0) as usize;
    let rows = (triangles / 2 / columns).max(3);
    for (name, shuffled) in [("rows.ply", false), ("shuffled.ply", true)] {
        let path = folder.path().join(name);
        torus(&path, columns, rows, shuffled).expect("the file can be written");
        let megabytes = fs::metadata(&path).expect("it was written").len() / 1_000_000;
        println!("{} triangles, {megabytes} MB, binary32, {}", 2 * columns * rows, name.trim_end_matches(".ply"));
        check(&path);
        fs::remove_file(&path).expect("it was written");
    }
}

/// Runs `isoracle check mesh`, and prints what it took.
fn check(path: &Path) {
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_isoracle"))
        .args(["check", "mesh"])
        .arg(path)
        .stdout(Stdio::inherit())
        .spawn()
        .expect("isoracle runs");
    let mut peak = None;
    let mut processor = None;
    let status = loop {
        // The last look before the end; the peak never falls.
        peak = peak_memory(child.id()).or(peak);
        processor = processor_time(child.id()).or(processor);
        if let Some(status) = child.try_wait().expect("it can be waited for") {
            break status;
        }
        sleep(Duration::from_millis(10));
    };
    println!("wall time       {:.2} s", start.elapsed().as_secs_f64());
    println!("processor time  {}", processor.map_or("unknown".to_owned(), |s: f64| format!("{s:.2} s")));
    println!("peak memory     {}", peak.map_or("unknown".to_owned(), |kib| format!("{} MiB", kib / 1024)));
    assert!(status.success(), "the mesh is sound");
}

/// The peak resident memory of a process in KiB, where the system tells it.
fn peak_memory(id: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{id}/status")).ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok())
}

/// The processor time of a process in seconds, at the usual 100 ticks a second.
fn processor_time(id: u32) -> Option<f64> {
    let stat = fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks: u64 = fields.get(11)?.parse::<u64>().ok()? + fields.get(12)?.parse::<u64>().ok()?;
    (ticks > 0).then_some(ticks as f64 / 100.0)
}

/// A wavy torus of 2·columns·rows triangles, binary32, little endian.
fn torus(path: &Path, columns: usize, rows: usize, shuffled: bool) -> io::Result<()> {
    let (vertices, faces) = (columns * rows, 2 * columns * rows);
    let order = |n: usize| if shuffled { permutation(n) } else { (0..n as u32).collect() };
    // number[v] is where vertex v is written.
    let number = order(vertices);
    let mut vertex_at = vec![0; vertices];
    (0..).zip(&number).for_each(|(v, &place): (u32, _)| vertex_at[place as usize] = v);
    let mut out = BufWriter::new(File::create(path)?);
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
         property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )?;
    let turn = std::f64::consts::TAU;
    for v in vertex_at {
        let (i, j) = (v as usize % columns, v as usize / columns);
        let (u, v) = (i as f64 / columns as f64 * turn, j as f64 / rows as f64 * turn);
        let tube = 1.0 + 0.1 * (7.0 * u).sin() * (5.0 * v).cos();
        let around = 3.0 + tube * v.cos();
        for coordinate in [around * u.cos(), around * u.sin(), tube * v.sin()] {
            out.write_all(&(coordinate as f32).to_le_bytes())?;
        }
    }
    let at = |i: usize, j: usize| number[(j % rows) * columns + i % columns];
    for face in order(faces) {
        let (i, j) = (face as usize / 2 % columns, face as usize / 2 / columns);
        let triangle = if face % 2 == 0 {
            [at(i, j), at(i + 1, j), at(i + 1, j + 1)]
        } else {
            [at(i, j), at(i + 1, j + 1), at(i, j + 1)]
        };
        out.write_all(&[3])?;
        for vertex in triangle {
            out.write_all(&vertex.to_le_bytes())?;
        }
    }
    out.flush()
}

/// A pseudo-random order of 0 … n−1, the same in every run.
fn permutation(n: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n as u32).collect();
    let mut seed = 1_u64;
    for i in (1..n).rev() {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        order.swap(i, (seed >> 33) as usize % (i + 1));
    }
    order
}
