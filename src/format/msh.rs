//! MSH 4.1, the mesh file of Gmsh, ascii: tetrahedra by groups, and lines.

use super::{Problem, TetrahedraRecord};
use std::collections::BTreeMap;
use std::io::Write;

/// Gmsh's numbers of element types.
const LINE: u8 = 1;
const TETRAHEDRON: u8 = 4;

/// Writes a volume for each group g of tetrahedra, with the physical tag g + 1, and a curve for the lines. Nodes and elements are
/// numbered from 1; numbers are the shortest decimals that read back as the same binary64.
pub fn write(mut out: impl Write, record: &TetrahedraRecord) -> Result<(), Problem> {
    let mut groups: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    record.groups.iter().enumerate().for_each(|(i, group)| groups.entry(*group).or_default().push(i));
    let curves = usize::from(!record.lines.is_empty());
    writeln!(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat")?;
    writeln!(out, "$PhysicalNames\n{}", groups.len() + curves)?;
    if curves == 1 {
        writeln!(out, "1 1 \"edges\"")?;
    }
    for group in groups.keys() {
        writeln!(out, "3 {} \"group {group}\"", u64::from(*group) + 1)?;
    }
    writeln!(out, "$EndPhysicalNames\n$Entities\n0 {curves} 0 {}", groups.len())?;
    let [lo, hi] = bounds(&record.vertices);
    let bounds = [lo, hi].concat().iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(" ");
    if curves == 1 {
        writeln!(out, "1 {bounds} 1 1 0")?;
    }
    for group in groups.keys() {
        let tag = u64::from(*group) + 1;
        writeln!(out, "{tag} {bounds} 1 {tag} 0")?;
    }
    let nodes = record.vertices.len();
    writeln!(out, "$EndEntities\n$Nodes")?;
    // All nodes belong to the first volume: they are shared, and Gmsh asks for an owner only.
    let owner = groups.keys().next().map_or(1, |group| u64::from(*group) + 1);
    writeln!(out, "1 {nodes} {} {nodes}\n3 {owner} 0 {nodes}", nodes.min(1))?;
    (1..=nodes).try_for_each(|i| writeln!(out, "{i}"))?;
    record.vertices.iter().try_for_each(|[x, y, z]| writeln!(out, "{x:?} {y:?} {z:?}"))?;
    let elements = record.tetrahedra.len() + record.lines.len();
    writeln!(out, "$EndNodes\n$Elements\n{} {elements} {} {elements}", groups.len() + curves, elements.min(1))?;
    let mut number = 0;
    if curves == 1 {
        writeln!(out, "1 1 {LINE} {}", record.lines.len())?;
        for [v, w] in &record.lines {
            number += 1;
            writeln!(out, "{number} {} {}", u64::from(*v) + 1, u64::from(*w) + 1)?;
        }
    }
    for (group, members) in &groups {
        writeln!(out, "3 {} {TETRAHEDRON} {}", u64::from(*group) + 1, members.len())?;
        for i in members {
            number += 1;
            let [a, b, c, d] = record.tetrahedra[*i].map(|v| u64::from(v) + 1);
            writeln!(out, "{number} {a} {b} {c} {d}")?;
        }
    }
    writeln!(out, "$EndElements")?;
    Ok(())
}

fn bounds(points: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold([first, first], |[lo, hi], p| {
        [std::array::from_fn(|i| lo[i].min(p[i])), std::array::from_fn(|i| hi[i].max(p[i]))]
    })
}
