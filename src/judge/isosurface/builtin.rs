//! Built-in candidates: the popular mistake, and our own mesher broken on purpose.
//!
//! A judge is worth something only if it rejects what is wrong. Each of these is wrong in one way, and the
//! judge has to say so for that reason.

use crate::answer::message::{Out, Question, Refusal};
use crate::answer::{value, volume};
use crate::isosurface::cell::{Decisions, Tie, assemble};
use crate::isosurface::cube::{Corner, Edge, Face};
use crate::isosurface::patch::{Patch, PatchVertex, patch, share_a_face};
use crate::isosurface::volume::{DegenerateCell, GridEdge, Level};
use crate::number::binary::nearest_f64;
use serde_json::json;
use std::collections::HashMap;

/// A built-in candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// The table of 1987, in f64: no face test, no interior test.
    Classic,
    /// Ours, with every ambiguous face joining its negative pair.
    WrongFaceRule,
    /// Ours, with no tunnel anywhere.
    WrongInteriorRule,
    /// Ours, with one triangle of each mesh turned over.
    FlippedTriangle,
    /// Ours, with one triangle of each mesh twice.
    DuplicatedTriangle,
    /// Ours, with one triangle of each mesh left out.
    Hole,
    /// Ours, with polygons cut by diagonals in the faces of cells.
    EdgeInFace,
    /// Ours, unbroken.
    Right,
}

impl Builtin {
    /// All of them.
    pub const ALL: [Builtin; 8] = [
        Builtin::Classic,
        Builtin::WrongFaceRule,
        Builtin::WrongInteriorRule,
        Builtin::FlippedTriangle,
        Builtin::DuplicatedTriangle,
        Builtin::Hole,
        Builtin::EdgeInFace,
        Builtin::Right,
    ];

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Builtin::Classic => "classic",
            Builtin::WrongFaceRule => "wrong-face-rule",
            Builtin::WrongInteriorRule => "wrong-interior-rule",
            Builtin::FlippedTriangle => "flipped-triangle",
            Builtin::DuplicatedTriangle => "duplicated-triangle",
            Builtin::Hole => "hole",
            Builtin::EdgeInFace => "edge-in-face",
            Builtin::Right => "right",
        }
    }

    /// Its mesh of a level, in f64: positions and triangles.
    pub fn mesh(self, level: &Level) -> Result<Indexed, DegenerateCell> {
        let (positions, mut triangles) = match self {
            Builtin::Classic => return Ok(classic(level)),
            Builtin::WrongFaceRule => build(level, |decisions| patch(&assemble(negative_faces(decisions)))),
            Builtin::WrongInteriorRule => {
                build(level, |decisions| patch(&assemble(Decisions { tunnel: None, ..decisions })))
            }
            Builtin::EdgeInFace => build(level, |decisions| fans(&decisions)),
            Builtin::FlippedTriangle | Builtin::DuplicatedTriangle | Builtin::Hole | Builtin::Right => {
                build(level, |decisions| patch(&assemble(decisions)))
            }
        }?;
        match self {
            Builtin::FlippedTriangle => triangles.iter_mut().take(1).for_each(|t| t.swap(1, 2)),
            Builtin::DuplicatedTriangle => triangles.extend(triangles.first().copied()),
            Builtin::Hole => drop(triangles.pop()),
            Builtin::Classic
            | Builtin::WrongFaceRule
            | Builtin::WrongInteriorRule
            | Builtin::EdgeInFace
            | Builtin::Right => {}
        }
        Ok((positions, triangles))
    }
}

fn negative_faces(decisions: Decisions) -> Decisions {
    Decisions { faces: decisions.faces.map(|sign| if sign == 0 { 0 } else { -1 }), tunnel: None, ..decisions }
}

/// Our mesh with the first polygon diagonals that come, wherever they lie.
fn fans(decisions: &Decisions) -> Patch {
    let topology = assemble(*decisions);
    if topology.components.iter().any(|component| component.loops.len() > 1) {
        return patch(&topology);
    }
    let mut patch = Patch::default();
    for rim in &topology.loops {
        // The fan with the most diagonals in faces.
        let in_faces = |start: usize| {
            let ends = rim.iter().enumerate().filter(|(i, e)| {
                let steps = (i + rim.len() - start) % rim.len();
                (2..rim.len() - 1).contains(&steps) && share_a_face(rim[start], **e)
            });
            ends.count()
        };
        let apex = (0..rim.len()).max_by_key(|&start| (in_faces(start), rim.len() - start)).unwrap_or(0);
        let at = |i: usize| PatchVertex::Crossing(rim[(apex + i) % rim.len()]);
        patch.triangles.extend((1..rim.len() - 1).map(|i| [at(0), at(i), at(i + 1)]));
    }
    patch
}

/// Positions and triangles.
pub type Indexed = (Vec<[f64; 3]>, Vec<[u32; 3]>);

fn build(level: &Level, triangles_of: impl Fn(Decisions) -> Patch) -> Result<Indexed, DegenerateCell> {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut numbers: HashMap<GridEdge, u32> = HashMap::new();
    for cell in level.volume.cells() {
        let patch = triangles_of(level.decisions(cell)?);
        let position = |edge: Edge| level.crossing_position(level.grid_edge(cell, edge)).map(|x| nearest_f64(&x));
        let first_inner = positions.len() as u32;
        for rim in &patch.inner {
            let sum = rim.iter().fold([0.0; 3], |sum, edge| {
                let p = position(*edge);
                [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]]
            });
            positions.push(sum.map(|x| x / rim.len() as f64));
        }
        for triangle in patch.triangles {
            triangles.push(triangle.map(|vertex| match vertex {
                PatchVertex::Inner(i) => first_inner + u32::from(i),
                PatchVertex::Crossing(edge) => *numbers.entry(level.grid_edge(cell, edge)).or_insert_with(|| {
                    positions.push(position(edge));
                    positions.len() as u32 - 1
                }),
            }));
        }
    }
    Ok((positions, triangles))
}

/// The table of 1987: each of the 256 configurations is one of 15 patterns up to rotation and complement,
/// and a pattern cuts off the fewer corners one by one. So a face with alternating signs is cut one way by a
/// configuration and the other way by the complement of its neighbour's pattern: the surfaces do not meet.
fn pattern_of_1987(positive: u8) -> Decisions {
    let joined = if positive.count_ones() > 4 { 1 } else { -1 };
    let faces = Face::ALL.map(|face| {
        let [p, q, r, s] = face.cycle().map(|c| positive & c.bit() != 0);
        if p == r && q == s && p != q { joined } else { 0 }
    });
    Decisions { positive, faces, tunnel: None }
}

/// Marching cubes as of 1987, in f64 throughout; knows of no ties.
fn classic(level: &Level) -> Indexed {
    let volume = level.volume;
    let values: Vec<f64> = (0..volume.len()).map(|i| nearest_f64(&volume.sample(i))).collect();
    let isovalue = nearest_f64(&level.isovalue);
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut numbers: HashMap<GridEdge, u32> = HashMap::new();
    for cell in volume.cells() {
        let is_positive = |c: &Corner| values[volume.corner_index(cell, *c)] >= isovalue;
        let positive = Corner::ALL.into_iter().filter(is_positive).fold(0, |set, c| set | c.bit());
        for triangle in patch(&assemble(pattern_of_1987(positive))).triangles {
            triangles.push(triangle.map(|vertex| {
                let PatchVertex::Crossing(edge) = vertex else { unreachable!("the patterns have no inner vertices") };
                let edge = level.grid_edge(cell, edge);
                *numbers.entry(edge).or_insert_with(|| {
                    let (a, b) = (values[edge.low as usize], values[level.high(edge)]);
                    let mut position = volume.point(edge.low as usize).map(|x| x as f64);
                    position[usize::from(edge.axis)] += (isovalue - a) / (b - a);
                    positions.push(position);
                    positions.len() as u32 - 1
                })
            }));
        }
    }
    (positions, triangles)
}

impl Builtin {
    /// What it answers.
    ///
    /// # Errors
    /// As the oracle.
    pub fn answer(self, question: &Question) -> Result<Out, Refusal> {
        match question.op.as_str() {
            "hello" => {
                let hello = json!({"protocol": 1, "name": self.name(), "version": env!("CARGO_PKG_VERSION"), "ops": ["isosurface.mesh"]});
                Ok(Out::new(&hello))
            }
            "isosurface.mesh" => {
                let input = question.input()?;
                let volume = value::field(input, "volume", volume::read)?;
                let isovalue = value::field(input, "isovalue", value::number)?;
                let (vertices, faces) = self.mesh(&Level { volume: &volume, isovalue, tie: Tie::Below })?;
                Ok(Out::new(&json!({"vertices": vertices, "faces": faces})))
            }
            other => Err(Refusal::NoSuchOperation(other.chars().take(100).collect())),
        }
    }
}
