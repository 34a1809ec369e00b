//! The uses of every edge, sorted by counting: no hashing, one array of machine words.

use super::polygons::Polygons;
use crate::mesh::triangles::EdgeKey;

/// Which face a corner belongs to.
pub enum FaceOf {
    /// All faces have this many corners.
    Every(u32),
    /// By corner.
    Table(Vec<u32>),
}

impl FaceOf {
    /// Of a mesh.
    pub fn of(mesh: &Polygons) -> FaceOf {
        match mesh.uniform() {
            Some(corners) => FaceOf::Every(corners),
            None => FaceOf::Table(
                mesh.loops().zip(0..).flat_map(|(face, number)| std::iter::repeat_n(number, face.len())).collect(),
            ),
        }
    }

    /// The face of a corner.
    pub fn face(&self, corner: u32) -> u32 {
        match self {
            FaceOf::Every(corners) => corner / corners,
            FaceOf::Table(faces) => faces[corner as usize],
        }
    }
}

/// All sides of all loops but those from a vertex to itself, by edge.
pub struct Uses {
    /// The sides whose smaller vertex is v are `sides[starts[v]..starts[v + 1]]`.
    starts: Vec<u32>,
    /// The greater vertex, then the corner at which the side begins; sorted for each smaller vertex.
    sides: Vec<u64>,
}

/// One use of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// The corner at which it begins.
    pub corner: u32,
    /// The corner at which it ends.
    pub next: u32,
    /// Whether it runs from the smaller vertex to the greater one.
    pub up: bool,
    /// Its face.
    pub face: u32,
}

impl Uses {
    /// Of a mesh all of whose vertices exist.
    pub fn of(mesh: &Polygons) -> Uses {
        let mut starts = vec![0_u32; mesh.vertices().len() + 1];
        for_each_side(mesh, |[a, b], _| starts[a.min(b) as usize + 1] += 1);
        for v in 1..starts.len() {
            starts[v] += starts[v - 1];
        }
        let mut free = starts.clone();
        let mut sides = vec![0; *starts.last().expect("one more than vertices") as usize];
        for_each_side(mesh, |[a, b], corner| {
            let slot = &mut free[a.min(b) as usize];
            sides[*slot as usize] = u64::from(a.max(b)) << 32 | u64::from(corner);
            *slot += 1;
        });
        for bounds in starts.windows(2) {
            sides[bounds[0] as usize..bounds[1] as usize].sort_unstable();
        }
        Uses { starts, sides }
    }

    /// Every edge with its uses, in the order of edges; the uses in the order of corners.
    pub fn for_each(&self, mesh: &Polygons, faces: &FaceOf, mut visit: impl FnMut(EdgeKey, &[Side])) {
        let corners = mesh.corners();
        let mut uses = Vec::new();
        for (v, bounds) in (0..).zip(self.starts.windows(2)) {
            let sides = &self.sides[bounds[0] as usize..bounds[1] as usize];
            for group in sides.chunk_by(|a, b| a >> 32 == b >> 32) {
                uses.clear();
                uses.extend(group.iter().map(|&side| {
                    let corner = side as u32;
                    let face = faces.face(corner);
                    Side { corner, next: next(mesh, face, corner), up: corners[corner as usize] == v, face }
                }));
                visit([v, (group[0] >> 32) as u32], &uses);
            }
        }
    }
}

/// The corner after a corner of a face.
pub fn next(mesh: &Polygons, face: u32, corner: u32) -> u32 {
    let range = mesh.range(face as usize);
    if corner as usize + 1 == range.end { range.start as u32 } else { corner + 1 }
}

/// Every side between different vertices, with the corner where it begins.
fn for_each_side(mesh: &Polygons, mut visit: impl FnMut([u32; 2], u32)) {
    let mut corner = 0;
    for face in mesh.loops() {
        let Some(&first) = face.first() else { continue };
        for (i, &a) in face.iter().enumerate() {
            let b = *face.get(i + 1).unwrap_or(&first);
            if a != b {
                visit([a, b], corner);
            }
            corner += 1;
        }
    }
}
