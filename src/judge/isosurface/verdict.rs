//! Whether a mesh is the isosurface: cell by cell with labels, and as a whole.

use super::candidate_mesh::{CandidateMesh, Positions};
use super::fault::{Cell, Fault};
use super::place::{Place, Places, Sides, Tolerance, cell_edge, places};
use crate::isosurface::cell::{Decisions, Topology, assemble};
use crate::isosurface::cube::{Edge, Face};
use crate::isosurface::fast::{self, Decider};
use crate::isosurface::topology::SurfaceComponent;
use crate::isosurface::volume::{DegenerateCell, GridEdge, Level};
use crate::judge::report::{Difference, PositionError};
use crate::mesh::triangles::{Defect, Triangle, components, defects, edge_uses};
use crate::mesh::weld::weld;
use crate::partition::Partition;
use std::collections::{BTreeMap, HashMap};

/// What was found about one mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// What is wrong with it; empty iff it is the isosurface.
    pub faults: Vec<Fault>,
    /// The largest position errors.
    pub error: PositionError,
    /// Whether vertices at equal positions had to be taken for one.
    pub welded: bool,
}

/// Judges a mesh as the isosurface of a level: its labelled topology in each cell and as a whole.
///
/// Positions tell which vertex stands for which crossing; what is connected is told by the mesh's own
/// indices and, if it fails by these, by welding vertices at exactly equal positions, as triangle soups need.
///
/// Errors: the level is degenerate, so that there is no one right mesh.
pub fn judge(level: &Level, mesh: &CandidateMesh, tolerance: Tolerance) -> Result<Verdict, DegenerateCell> {
    let mut by_index = judge_indexed(level, mesh, tolerance)?;
    if by_index.faults.is_empty() {
        return Ok(by_index);
    }
    let welded = welded(mesh);
    if welded.positions.len() == mesh.positions.len() {
        return Ok(by_index);
    }
    let mut by_position = judge_indexed(level, &welded, tolerance)?;
    by_position.welded = true;
    by_index.welded = false;
    // The reading with fewer faults is the kinder one.
    Ok(if by_position.faults.len() < by_index.faults.len() { by_position } else { by_index })
}

/// The mesh with vertices at equal positions made one.
pub fn welded(mesh: &CandidateMesh) -> CandidateMesh {
    match &mesh.positions {
        Positions::Exact(positions) => {
            let (positions, triangles) = weld(positions, &mesh.triangles);
            CandidateMesh { positions: Positions::Exact(positions), triangles }
        }
        Positions::Floats(positions) => {
            // +0 and −0 are one position.
            let bits: Vec<[u64; 3]> = positions.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
            let (bits, triangles) = weld(&bits, &mesh.triangles);
            let positions = bits.into_iter().map(|p| p.map(f64::from_bits)).collect();
            CandidateMesh { positions: Positions::Floats(positions), triangles }
        }
    }
}

pub(super) fn judge_indexed(
    level: &Level,
    mesh: &CandidateMesh,
    tolerance: Tolerance,
) -> Result<Verdict, DegenerateCell> {
    let sides = Sides::new(level);
    let defects = defects(mesh.positions.len(), &mesh.triangles);
    let is_readable = !defects.iter().any(|d| matches!(d, Defect::IndexOutOfRange { .. }));
    let Places { of, mut faults, error } = places(level, &sides, &mesh.positions, tolerance);
    faults.splice(0..0, defects.into_iter().map(Fault::Defect));
    faults.extend(crossings(level, &sides, &of));
    if is_readable {
        let (by_cell, misplaced) = by_cell(level, &of, &mesh.triangles);
        faults.extend(misplaced);
        let decider = Decider::new(level);
        for cell in level.volume.cells() {
            let triangles = by_cell.get(&level.volume.index(cell)).map_or(&[][..], Vec::as_slice);
            let decisions = decider.decisions(cell)?;
            if triangles.is_empty() && matches!(decisions.positive, 0 | 255) {
                continue;
            }
            let judged = CellMesh { level, places: &of, triangles, cell };
            judged.faults(&assemble(decisions), &mut faults);
        }
        if faults.iter().all(|fault| matches!(fault, Fault::Misplaced { .. })) {
            faults.extend(totals(level, mesh)?);
        }
    }
    Ok(Verdict { faults, error, welded: false })
}

/// Each crossed edge of the grid has one vertex.
fn crossings(level: &Level, sides: &Sides, places: &[Option<Place>]) -> Vec<Fault> {
    let mut counts: HashMap<GridEdge, u32> = HashMap::new();
    for place in places.iter().flatten() {
        if let Place::Crossing(edge) = place {
            *counts.entry(*edge).or_default() += 1;
        }
    }
    let shape = level.volume.shape();
    let mut faults = Vec::new();
    for index in 0..level.volume.len() {
        let low = level.volume.point(index);
        for axis in (0..3u8).filter(|&axis| low[usize::from(axis)] + 1 < shape[usize::from(axis)]) {
            let edge = GridEdge { low: index as u32, axis };
            if sides.crosses(level, edge) {
                match counts.get(&edge).copied().unwrap_or(0) {
                    0 => faults.push(Fault::MissingCrossing { low, axis, edge }),
                    1 => {}
                    count => faults.push(Fault::RepeatedCrossing { low, axis, count }),
                }
            }
        }
    }
    faults
}

/// The triangles of each cell, and the faults of those that no one cell has.
fn by_cell(
    level: &Level,
    places: &[Option<Place>],
    triangles: &[Triangle],
) -> (HashMap<usize, Vec<Triangle>>, Vec<Fault>) {
    let mut by_cell: HashMap<usize, Vec<Triangle>> = HashMap::new();
    let mut faults = Vec::new();
    for (number, triangle) in triangles.iter().enumerate() {
        // A vertex without a place has been told already; its triangles belong nowhere.
        let [Some(a), Some(b), Some(c)] = triangle.map(|v| places[v as usize]) else { continue };
        let cells = [a, b, c].map(|place| place.cells(level));
        let common: [[usize; 2]; 3] = std::array::from_fn(|axis| {
            let low = cells.iter().map(|range| range[axis][0]).max().expect("three vertices");
            let high = cells.iter().map(|range| range[axis][1]).min().expect("three vertices");
            [low, high]
        });
        if common.iter().any(|[low, high]| low > high) {
            faults.push(Fault::AcrossCells { triangle: number });
        } else if common.iter().any(|[low, high]| low < high) {
            faults.push(Fault::TriangleInFace { triangle: number });
        } else {
            by_cell.entry(level.volume.index(common.map(|[low, _]| low))).or_default().push(*triangle);
        }
    }
    (by_cell, faults)
}

/// The part of a mesh in one cell.
struct CellMesh<'a, 'b> {
    level: &'a Level<'b>,
    places: &'a [Option<Place>],
    triangles: &'a [Triangle],
    cell: Cell,
}

/// A closed curve of crossed edges; starts at its least edge.
type Loop = Vec<Edge>;

impl CellMesh<'_, '_> {
    /// "loops", and of which cell where there are several.
    fn name(&self, what: &str) -> String {
        let is_alone = self.level.volume.shape() == [2; 3];
        if is_alone { what.to_owned() } else { format!("{what} in cell {:?}", self.cell) }
    }

    fn share_a_face(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a, b].map(|v| self.places[v as usize]);
        let (Some(a), Some(b)) = (a, b) else { return false };
        Face::ALL.into_iter().any(|face| {
            let (axis, at) = (face.axis(), self.cell[face.axis()] + usize::from(face.side()));
            a.on_plane(self.level, axis, at) && b.on_plane(self.level, axis, at)
        })
    }

    fn faults(&self, truth: &Topology, faults: &mut Vec<Fault>) {
        let (cell, case) = (self.cell, truth.case);
        let before = faults.len();
        let mut next: HashMap<u32, Option<u32>> = HashMap::new();
        let mut is_closed = true;
        for (&[a, b], &[up, down]) in &edge_uses(self.triangles) {
            let in_face = self.share_a_face(a, b);
            if up + down == 1 {
                let [from, to] = if up == 1 { [a, b] } else { [b, a] };
                is_closed &= next.insert(from, Some(to)).is_none();
                if !in_face {
                    faults.push(Fault::Hole { cell, case, edge: [from, to] });
                }
            } else if in_face {
                faults.push(Fault::EdgeInFace { cell, case });
            }
        }
        faults[before..].sort_by_key(|fault| fault.to_string());
        faults.dedup();
        if faults.len() > before {
            return;
        }
        let Some(found) = self.loops(next, is_closed) else {
            let difference = difference(&self.name("loops"), &truth.loops, "arcs that do not close up".into());
            faults.push(Fault::WrongLoops { cell, case, difference });
            return;
        };
        let cycles = |loops: &[(Loop, u32)]| -> Vec<Loop> { loops.iter().map(|(cycle, _)| cycle.clone()).collect() };
        let mut reversed: Vec<Loop> =
            cycles(&found).into_iter().map(|cycle| least_first(cycle.into_iter().rev().collect())).collect();
        reversed.sort();
        if cycles(&found) == truth.loops {
            if let Some(difference) = self.component_difference(truth, &found) {
                faults.push(Fault::WrongComponents { cell, case, difference });
            }
        } else if reversed == truth.loops {
            faults.push(Fault::Reversed { cell, case });
        } else {
            let difference = difference(&self.name("loops"), &truth.loops, loops_text(&cycles(&found)));
            faults.push(Fault::WrongLoops { cell, case, difference });
        }
    }

    /// The boundary curves, each with one of its vertices, sorted; `None` where they are not closed curves
    /// through crossings.
    fn loops(&self, mut next: HashMap<u32, Option<u32>>, is_closed: bool) -> Option<Vec<(Loop, u32)>> {
        let mut starts: Vec<u32> = next.keys().copied().collect();
        starts.sort_unstable();
        let mut loops = Vec::new();
        for start in starts {
            let mut cycle = Vec::new();
            let mut here = start;
            while let Some(to) = next.get_mut(&here)?.take() {
                if let Some(Place::Crossing(edge)) = self.places[here as usize] {
                    cycle.push(cell_edge(self.level, self.cell, edge)?);
                }
                here = to;
            }
            if here != start {
                return None;
            }
            if !cycle.is_empty() {
                loops.push((least_first(cycle), start));
            }
        }
        loops.sort();
        is_closed.then_some(loops)
    }

    /// What the loops bound, if it is not what they should.
    fn component_difference(&self, truth: &Topology, found: &[(Loop, u32)]) -> Option<Difference> {
        let mut numbers: BTreeMap<u32, usize> = BTreeMap::new();
        for vertex in self.triangles.iter().flatten() {
            let next = numbers.len();
            numbers.entry(*vertex).or_insert(next);
        }
        let mut connected = Partition::new(numbers.len());
        for [a, b, c] in self.triangles {
            connected.join(numbers[a], numbers[b]);
            connected.join(numbers[a], numbers[c]);
        }
        let mut pieces: BTreeMap<usize, (Vec<usize>, i64)> = BTreeMap::new();
        for vertex in numbers.values() {
            pieces.entry(connected.find(*vertex)).or_default().1 += 1;
        }
        for [a, _] in edge_uses(self.triangles).keys() {
            pieces.entry(connected.find(numbers[a])).or_default().1 -= 1;
        }
        for [a, _, _] in self.triangles {
            pieces.entry(connected.find(numbers[a])).or_default().1 += 1;
        }
        for (index, (_, vertex)) in found.iter().enumerate() {
            pieces.entry(connected.find(numbers[vertex])).or_default().0.push(index);
        }
        let mut found: Vec<_> = pieces.into_values().collect();
        found.sort();
        let mut expected: Vec<_> = truth.components.iter().map(|c| (c.loops.clone(), c.chi)).collect();
        expected.sort();
        (found != expected).then(|| Difference {
            invariant: format!("{} of {}", self.name("components"), loops_text(&truth.loops)),
            expected: components_text(&expected),
            found: components_text(&found),
        })
    }
}

fn least_first(mut cycle: Loop) -> Loop {
    let least = (0..cycle.len()).min_by_key(|&i| cycle[i]).unwrap_or(0);
    cycle.rotate_left(least);
    cycle
}

fn difference(invariant: &str, expected: &[Loop], found: String) -> Difference {
    Difference { invariant: invariant.into(), expected: loops_text(expected), found }
}

/// Loops in words: each edge as its two corners.
fn loops_text(loops: &[Loop]) -> String {
    if loops.is_empty() {
        return "no loops".into();
    }
    let cycle = |cycle: &Loop| {
        let edges: Vec<String> = cycle
            .iter()
            .map(|edge| {
                let [a, b] = edge.corners();
                format!("{}{}", a.index(), b.index())
            })
            .collect();
        format!("({})", edges.join(" "))
    };
    loops.iter().map(cycle).collect::<Vec<_>>().join(" ")
}

fn components_text(components: &[(Vec<usize>, i64)]) -> String {
    let piece = |(loops, chi): &(Vec<usize>, i64)| {
        let bounding: Vec<String> = loops.iter().map(|l| format!("#{}", l + 1)).collect();
        let kind = match (loops.len(), chi) {
            (1, 1) => "a disk".into(),
            (2, 0) => "a tube".into(),
            (0, _) => format!("a closed surface with χ = {chi}"),
            _ => format!("a surface with χ = {chi}"),
        };
        if loops.is_empty() { kind } else { format!("{kind} on loop {}", bounding.join(" and ")) }
    };
    components.iter().map(piece).collect::<Vec<_>>().join(", ")
}

/// The components of the whole, if they are not what they should be.
fn totals(level: &Level, mesh: &CandidateMesh) -> Result<Option<Fault>, DegenerateCell> {
    let expected = fast::topology(level)?.components;
    let found = mesh_components(mesh);
    Ok((expected != found).then(|| Fault::WrongTotals { difference: totals_difference(&expected, &found) }))
}

/// The components of a mesh, as those of an isosurface are told.
pub fn mesh_components(mesh: &CandidateMesh) -> Vec<SurfaceComponent> {
    components(mesh.positions.len(), &mesh.triangles)
        .into_iter()
        .map(|c| SurfaceComponent { chi: c.chi, boundary_loops: c.boundary_loops, genus: c.genus })
        .collect()
}

fn totals_difference(expected: &[SurfaceComponent], found: &[SurfaceComponent]) -> Difference {
    Difference {
        invariant: "components (χ, boundary loops, genus)".into(),
        expected: totals_text(expected),
        found: totals_text(found),
    }
}

/// Components in words: each as (χ, loops, genus).
pub fn totals_text(components: &[SurfaceComponent]) -> String {
    if components.is_empty() {
        return "none".into();
    }
    let one = |c: &SurfaceComponent| format!("({}, {}, {})", c.chi, c.boundary_loops, c.genus);
    components.iter().map(one).collect::<Vec<_>>().join(" ")
}

/// The decisions of every cell that the surface meets, for whoever wants to name cases.
pub fn decisions(level: &Level) -> Result<Vec<(Cell, Decisions)>, DegenerateCell> {
    let decider = Decider::new(level);
    let cells = level.volume.cells().map(|cell| Ok((cell, decider.decisions(cell)?)));
    Ok(cells.collect::<Result<Vec<_>, _>>()?.into_iter().filter(|(_, d)| !matches!(d.positive, 0 | 255)).collect())
}
