//! The page of text that `isoracle complex` writes: every invariant of a scheme, or the reason why not.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::scheme::SchemeDefect;
use isoracle::mesh::classify::{ClosedSurface, Surface};
use isoracle::mesh::homology::Homology;
use isoracle::number::Integer;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::{self, Write};

/// ℤ^rank ⊕ ℤ/t₁ ⊕ …; 0 for the group of one element.
pub fn group(rank: usize, torsion: &[Integer]) -> String {
    let free = match rank {
        0 => None,
        1 => Some("ℤ".to_owned()),
        _ => Some(format!("ℤ{}", superscript(rank))),
    };
    let terms: Vec<String> = free.into_iter().chain(torsion.iter().map(|t| format!("ℤ/{t}"))).collect();
    if terms.is_empty() { "0".to_owned() } else { terms.join(" ⊕ ") }
}

fn superscript(n: usize) -> String {
    let digit = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10).expect("a digit") as usize).expect("ten of them");
    n.to_string().chars().map(digit).collect()
}

/// "4 × 12, 3": how often each value occurs.
pub fn tally<T: Ord + Display>(values: impl IntoIterator<Item = T>) -> String {
    let mut times: BTreeMap<T, usize> = BTreeMap::new();
    values.into_iter().for_each(|value| *times.entry(value).or_default() += 1);
    let term = |(value, n): (&T, &usize)| if *n == 1 { value.to_string() } else { format!("{value} ({n} times)") };
    times.iter().map(term).collect::<Vec<_>>().join(", ")
}

/// What is wrong, each defect a line.
pub fn write_defects(out: &mut impl Write, defects: &[SchemeDefect]) -> io::Result<()> {
    for defect in defects {
        writeln!(out, "  {:<22}{defect}", defect.reason().name())?;
    }
    Ok(())
}

/// Cells, rings, homology, links of a complex.
pub fn write_cells(out: &mut impl Write, complex: &ClosedComplex) -> io::Result<()> {
    let [v, e, f, p] = complex.counts();
    writeln!(out, "  V = {v}, E = {e}, F = {f}, P = {p}, χ = V − E + F − P = {}", complex.euler_characteristic())?;
    writeln!(out, "  face-edge pairs        t = {}", complex.facet_edge_pairs())?;
    writeln!(out, "  faces around an edge   {}", tally(complex.edge_ring_sizes()))?;
    writeln!(out, "  sides of a face        {}", tally(complex.face_degrees()))?;
    let links = complex.vertex_links().into_iter().map(name);
    writeln!(out, "  links of vertices      {}", tally(links))
}

fn name(link: ClosedSurface) -> String {
    Surface { closed: link, boundary_loops: 0 }.to_string()
}

/// H₀, H₁, H₂, H₃.
pub fn write_homology(out: &mut impl Write, homology: &Homology) -> io::Result<()> {
    let groups = homology.betti.iter().zip(&homology.torsion).zip(["H₀", "H₁", "H₂", "H₃"]);
    let groups: Vec<String> = groups.map(|((b, t), name)| format!("{name} = {}", group(*b, t))).collect();
    writeln!(out, "  homology               {}", groups.join(", "))
}
