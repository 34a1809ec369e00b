//! Homology of large triangulations on one core, each in a process of its own: seconds and peak memory.
//!
//! Target: a million tetrahedra within 60 s. `cargo bench --bench complex_homology` takes
//! - `torus 55`: the 3-torus of 55³ cubes in 6 tetrahedra each;
//! - `shuffled 55`: its tetrahedra in random order, the corners of each too;
//! - `torn 55`: its cubes in one block, whose opposite sides are glued square to square at random;
//! - `lenses 6 1000`: a thousand lens spaces L(p, 1), p from 2 to 7, subdivided once;
//! - `lens 5 2 3`: the lens space L(5, 2), subdivided barycentrically three times;
//! - `product 200 2`: the surface of genus 200 times a circle, subdivided twice.
//!
//! Those words after `--` take that one alone.

#[path = "../tests/complex/subdivided.rs"]
mod subdivided;

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired};
use isoracle::complex::homology_fast::homology;
use isoracle::complex::kuhn_torus::kuhn_torus;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::{GluingScheme, Polyhedron};
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use isoracle::number::Integer;
use std::process::Command;
use std::time::Instant;

const CASES: [&str; 6] = ["torus 55", "shuffled 55", "torn 55", "lenses 6 1000", "lens 5 2 3", "product 200 2"];

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let Some((kind, numbers)) = words.split_first() else {
        for case in CASES {
            let this = std::env::current_exe().expect("this program has a file");
            assert!(Command::new(this).args(case.split(' ')).status().expect("it runs").success());
        }
        return;
    };
    let numbers: Vec<usize> = numbers.iter().filter_map(|number| number.parse().ok()).collect();
    let triangulation = match (&kind[..], &numbers[..]) {
        ("torus", [n]) => kuhn_torus([*n; 3]),
        ("shuffled", [n]) => shuffled(&kuhn_torus([*n; 3])),
        ("torn", [n]) => torn(*n),
        ("lenses", [kinds, count]) => {
            let all: Vec<Triangulation> = (0..*kinds).map(|i| subdivided::subdivided(&lens(i as u32 + 2, 1))).collect();
            beside((0..*count).map(|i| &all[i % kinds]))
        }
        ("lens", [p, q, times]) => {
            (0..*times).fold(lens(*p as u32, *q as u32), |coarse, _| subdivided::subdivided(&coarse))
        }
        ("product", [genus, times]) => {
            let space = ClosedComplex::new(surface_times_circle(*genus)).expect("a manifold");
            (0..*times).fold(space.tetrahedra(), |coarse, _| subdivided::subdivided(&coarse))
        }
        _ => panic!("no such case: {}", words.join(" ")),
    };
    take(&words.join(" "), &triangulation);
}

fn lens(p: u32, q: u32) -> Triangulation {
    ClosedComplex::new(lens_space(p, q)).expect("a lens space").tetrahedra()
}

/// The prism over a 4g-gon, g ≥ 1, top glued to bottom, sides four by four as a b A B.
fn surface_times_circle(genus: usize) -> GluingScheme {
    let n = 4 * genus;
    let sides = (0..genus).flat_map(|k| [0, 1].map(|i| (2 + 4 * k + i, 4 + 4 * k + i, 1, -1)));
    let pairs: Vec<_> = [(0, 1, n as i64 - 1, -1)].into_iter().chain(sides).collect();
    paired(Polyhedron::prism(n as u32), &pairs)
}

fn beside<'a>(all: impl Iterator<Item = &'a Triangulation>) -> Triangulation {
    let mut gluings = Vec::new();
    for triangulation in all {
        let first = gluings.len() as u32;
        let moved = |g: TriangleGluing| TriangleGluing { tetrahedron: g.tetrahedron + first, ..g };
        gluings.extend(triangulation.gluings().iter().map(|four| four.map(moved)));
    }
    Triangulation::new(gluings).expect("as they are")
}

/// Tetrahedron t becomes order[t], its corners go where its permutation says.
fn shuffled(triangulation: &Triangulation) -> Triangulation {
    let order = permutation(triangulation.len(), 1);
    let all: Vec<Perm4> = Perm4::all().collect();
    let corners: Vec<Perm4> = permutation(triangulation.len(), 2).iter().map(|n| all[n % 24]).collect();
    let mut gluings = vec![[TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4]; triangulation.len()];
    for (t, four) in triangulation.gluings().iter().enumerate() {
        for (i, gluing) in four.iter().enumerate() {
            let other = gluing.tetrahedron as usize;
            gluings[order[t]][corners[t].image(i)] = TriangleGluing {
                tetrahedron: order[other] as u32,
                corners: corners[t].inverse().then(gluing.corners).then(corners[other]),
            };
        }
    }
    Triangulation::new(gluings).expect("the same gluings")
}

/// n³ cubes in a block, n ≥ 3. Squares of opposite sides are glued by translations, at random: no edge is reversed, and the vertices
/// have surfaces of many handles around them.
fn torn(n: usize) -> Triangulation {
    let mut gluings = kuhn_torus([n; 3]).gluings().to_vec();
    let number = |cube: [usize; 3]| (cube[2] * n + cube[1]) * n + cube[0];
    for axis in 0..3 {
        let image = permutation(n * n, axis as u64 + 3);
        let mut back = vec![0; n * n];
        image.iter().enumerate().for_each(|(i, j)| back[*j] = i);
        let others: Vec<usize> = (0..3).filter(|other| *other != axis).collect();
        for square in 0..n * n {
            for (side, beyond, squares) in [(n - 1, 0, &image), (0, n - 1, &back)] {
                let at = |depth: usize, square: usize| {
                    let mut cube = [depth; 3];
                    (cube[others[0]], cube[others[1]]) = (square % n, square / n);
                    6 * number(cube)
                };
                let (here, straight, there) = (at(side, square), at(beyond, square), at(beyond, squares[square]));
                for gluing in gluings[here..here + 6].as_flattened_mut() {
                    // Of a block of one cube all gluings are such.
                    let other = gluing.tetrahedron as usize;
                    if (straight..straight + 6).contains(&other) && gluing.corners != Perm4::IDENTITY {
                        gluing.tetrahedron = (other - straight + there) as u32;
                    }
                }
            }
        }
    }
    Triangulation::new(gluings).expect("each square is glued to one other")
}

/// A pseudo-random order of 0 … n−1, the same in every run.
fn permutation(n: usize, mut seed: u64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        order.swap(i, (seed >> 33) as usize % (i + 1));
    }
    order
}

/// Prints the homology and what it took.
fn take(name: &str, triangulation: &Triangulation) {
    let before = peak_memory();
    let start = Instant::now();
    let homology = homology(triangulation).expect("no edge is reversed");
    let seconds = start.elapsed().as_secs_f64();
    println!("{name}: {} tetrahedra", triangulation.len());
    println!("homology        {:?}, torsion {}", homology.betti, brief(&homology.torsion[1]));
    println!("wall time       {seconds:.2} s");
    println!("peak memory     {} MiB, {} MiB before", peak_memory(), before);
}

/// The numbers, each with how often it stands there.
fn brief(torsion: &[Integer]) -> String {
    let runs: Vec<String> = torsion.chunk_by(|a, b| a == b).map(|run| format!("{}^{}", run[0], run.len())).collect();
    format!("[{}]", runs.join(", "))
}

/// The peak resident memory of this process in MiB, 0 where the system does not tell it.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok());
    line.map_or(0, |kib: u64| kib / 1024)
}
