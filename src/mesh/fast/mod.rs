//! The check of large meshes: what [`Report`] says of ten million triangles within half a minute, in exact arithmetic.
//!
//! Flat arrays, counting sorts and filtered predicates in place of maps and rationals. Every decision is exact: rounded
//! arithmetic decides only where a bound proves it right.

pub mod area;
mod audit;
pub mod between;
mod bounds;
mod components;
mod edges;
pub mod equal;
pub mod exact;
mod fans;
pub mod order;
pub mod polygons;
pub mod report;
pub mod shape;
pub mod sum;
pub mod volume;

pub use audit::{Mismatch, audit};
pub use polygons::{Polygons, Unsound};
pub use report::{Component, Elements, Report};

use crate::mesh::defects::{Category, Counts};
use crate::mesh::triangles::EdgeKey;
use crate::number::{OrderedField, Sign};
use edges::{FaceOf, Side, Uses};
use fans::Fans;
use order::Renumbered;
use shape::Shape;
use std::collections::BTreeMap;

/// A position of three finite binary64, each taken exactly.
pub type Point = [f64; 3];

/// The search for t-junctions stops at so many: edges that overlap on one line can have as many as the
/// square of their number. Which of them are found then, the order of the mesh decides.
pub const MAX_JUNCTIONS: usize = 10_000_000;

/// Up to so many faces the area is enclosed within 2⁻¹²⁷ of itself, of more within 2⁻⁶¹.
pub const SMALL: usize = 100_000;

/// Every defect of a mesh of polygons without holes, its counts, components, and area.
///
/// Where an index is out of range, that category alone is reported. `tell` hears what is being done.
pub fn check(mesh: &Polygons, tell: impl Fn(&'static str)) -> Report {
    if order::is_scattered(mesh) {
        tell("renumbering vertices and faces");
        let renumbered = Renumbered::in_space(mesh);
        return renumbered.in_old_numbers(check_in_order(renumbered.mesh(), tell));
    }
    check_in_order(mesh, tell)
}

/// The same without new numbers: slow where the mesh is in no order of space.
pub fn check_in_order(mesh: &Polygons, tell: impl Fn(&'static str)) -> Report {
    let mut found = Found::default();
    loops(mesh, &mut found);
    if !found.out_of_range.is_empty() {
        return Report {
            defects: BTreeMap::from([(Category::IndexOutOfRange, Elements::Faces(found.out_of_range))]),
            counts: None,
            components: Vec::new(),
            area: None,
            all_junctions: true,
        };
    }
    tell("sorting the edges");
    let faces = FaceOf::of(mesh);
    let uses = Uses::of(mesh);
    tell("walking round the vertices");
    let used = used_vertices(mesh);
    let edges = edge_defects(mesh, &faces, &uses, &mut found);
    let orientable = found.inconsistent.is_empty() || fans::orientable(mesh, &faces, &uses);
    drop((faces, uses));
    tell("looking for equal vertices and faces");
    let duplicate_positions = equal::groups(&equal::first_at_position(mesh.vertices()));
    let duplicate_faces = equal::groups(&equal::first_of_cycle(mesh));
    tell("looking at the shapes of the faces");
    shapes(mesh, &mut found);
    tell("looking for vertices inside edges");
    let candidates = (0..).zip(&used).filter(|(_, used)| **used).map(|(vertex, _)| vertex);
    let (junctions, all_junctions) = between::junctions(mesh.vertices(), candidates, &edges, MAX_JUNCTIONS);
    tell("counting components");
    let components = components::components(mesh, &used, &edges, &found, orientable);
    tell("adding up volume and area");
    let closed = found.boundary.is_empty() && found.gt2.is_empty() && found.degenerate.is_empty();
    let consistent = found.inconsistent.is_empty();
    let volume = (closed && consistent && orientable).then(|| volume::volume(mesh));
    let volume_sign = volume.as_ref().map(OrderedField::sign);
    let area = area::area(mesh, if mesh.faces() <= SMALL { 128 } else { area::WORD_BITS });
    let manifold = closed && consistent && orientable && found.nonmanifold.is_empty();
    let vertices = used.iter().filter(|used| **used).count();
    let chi = vertices as i64 - edges.len() as i64 + mesh.faces() as i64;
    let counts = Counts {
        vertices,
        edges: edges.len(),
        faces: mesh.faces(),
        holes: 0,
        components: components.len(),
        chi,
        genus: (manifold && chi % 2 == 0).then(|| components.len() as i64 - chi / 2),
        closed,
        orientable,
        manifold,
        volume,
    };
    let isolated = (0..).zip(&used).filter(|(_, used)| !**used).map(|(vertex, _)| vertex).collect();
    let defects = [
        (Category::FaceLt3Vertices, Elements::Faces(found.lt3)),
        (Category::RepeatedVertexInLoop, Elements::Faces(found.repeated)),
        (Category::DegenerateEdgeSameIndex, Elements::Faces(found.degenerate)),
        (Category::ZeroLengthEdge, Elements::Edges(found.zero_length)),
        (Category::BoundaryEdge, Elements::Edges(found.boundary)),
        (Category::EdgeUsedGt2, Elements::Edges(found.gt2)),
        (Category::EdgeOddUse, Elements::Edges(found.odd)),
        (Category::EdgeTwiceInSameFace, Elements::Edges(found.twice)),
        (Category::InconsistentWindingEdge, Elements::Edges(found.inconsistent)),
        (Category::IsolatedVertex, Elements::Vertices(isolated)),
        (Category::DuplicateVertexPosition, Elements::VertexGroups(duplicate_positions)),
        (Category::DuplicateFace, Elements::FaceGroups(duplicate_faces)),
        (Category::ZeroAreaFace, Elements::Faces(found.zero_area)),
        (Category::NonplanarFace, Elements::Faces(found.nonplanar)),
        (Category::ZeroSignedAreaFace, Elements::Faces(found.zero_signed_area)),
        (Category::SelfCrossingLoop, Elements::Faces(found.self_crossing)),
        (Category::TJunction, Elements::Junctions(junctions)),
        (Category::NonmanifoldVertex, Elements::Vertices(found.nonmanifold)),
        (Category::VertexLt2Edges, Elements::Vertices(found.lt2)),
    ];
    let whole = [
        (Category::NonOrientable, closed && !orientable),
        (Category::InsideOut, volume_sign == Some(Sign::Negative)),
        (Category::ZeroVolume, volume_sign == Some(Sign::Zero)),
    ];
    let whole = whole.into_iter().filter(|(_, is)| *is).map(|(category, _)| (category, Elements::Whole));
    let defects = defects.into_iter().filter(|(_, elements)| !elements.is_empty()).chain(whole).collect();
    Report { defects, counts: Some(counts), components, area: Some(area), all_junctions }
}

/// The elements of the categories, as they are found.
#[derive(Default)]
struct Found {
    out_of_range: Vec<u32>,
    lt3: Vec<u32>,
    repeated: Vec<u32>,
    degenerate: Vec<u32>,
    zero_length: Vec<EdgeKey>,
    boundary: Vec<EdgeKey>,
    gt2: Vec<EdgeKey>,
    odd: Vec<EdgeKey>,
    twice: Vec<EdgeKey>,
    inconsistent: Vec<EdgeKey>,
    zero_area: Vec<u32>,
    nonplanar: Vec<u32>,
    zero_signed_area: Vec<u32>,
    self_crossing: Vec<u32>,
    nonmanifold: Vec<u32>,
    lt2: Vec<u32>,
}

/// What a loop says by its numbers alone.
fn loops(mesh: &Polygons, found: &mut Found) {
    let vertices = mesh.vertices().len();
    for (number, face) in (0..).zip(mesh.loops()) {
        let defect = |is: bool, list: &mut Vec<u32>| {
            if is {
                list.push(number);
            }
        };
        defect(face.iter().any(|&v| v as usize >= vertices), &mut found.out_of_range);
        defect(face.len() < 3, &mut found.lt3);
        defect(repeats(face), &mut found.repeated);
        defect((0..face.len()).any(|i| face[i] == face[(i + 1) % face.len()]), &mut found.degenerate);
    }
}

/// Whether a number stands twice in a list.
fn repeats(face: &[u32]) -> bool {
    if face.len() <= 8 {
        return (1..face.len()).any(|i| face[..i].contains(&face[i]));
    }
    let mut sorted = face.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).any(|pair| pair[0] == pair[1])
}

fn used_vertices(mesh: &Polygons) -> Vec<bool> {
    let mut used = vec![false; mesh.vertices().len()];
    mesh.corners().iter().for_each(|&v| used[v as usize] = true);
    used
}

/// The defects of the edges, and of the vertices by their edges; and the edges, sorted.
fn edge_defects(mesh: &Polygons, faces: &FaceOf, uses: &Uses, found: &mut Found) -> Vec<EdgeKey> {
    let mut edges = Vec::with_capacity(mesh.corners().len() / 2 + 1);
    let mut neighbours = vec![0_u8; mesh.vertices().len()];
    let mut fans = Fans::new(mesh);
    uses.for_each(mesh, faces, |edge, sides| {
        edges.push(edge);
        for v in edge {
            neighbours[v as usize] = neighbours[v as usize].saturating_add(1);
        }
        fans.join(edge, sides);
        let [p, q] = edge.map(|v| mesh.vertices()[v as usize]);
        let defect = |is: bool, list: &mut Vec<EdgeKey>| {
            if is {
                list.push(edge);
            }
        };
        defect(p == q, &mut found.zero_length);
        defect(sides.len() == 1, &mut found.boundary);
        defect(sides.len() > 2, &mut found.gt2);
        defect(sides.len() > 2 && sides.len() % 2 == 1, &mut found.odd);
        // Sides are in the order of their corners, so those of one face stand together.
        defect(sides.windows(2).any(|pair| pair[0].face == pair[1].face), &mut found.twice);
        defect(matches!(sides, [Side { up: s, .. }, Side { up: t, .. }] if s == t), &mut found.inconsistent);
    });
    found.nonmanifold = fans.nonmanifold().collect();
    let used = used_vertices(mesh);
    let lonely = |&v: &u32| used[v as usize] && neighbours[v as usize] < 2;
    found.lt2 = (0..neighbours.len() as u32).filter(lonely).collect();
    edges
}

/// The defects of the faces as shapes in space.
fn shapes(mesh: &Polygons, found: &mut Found) {
    let mut points = Vec::new();
    for (number, face) in (0..).zip(mesh.loops()) {
        points.clear();
        points.extend(face.iter().map(|&v| mesh.vertices()[v as usize]));
        match shape::shape(&points) {
            None => {}
            Some(Shape::Collinear) => found.zero_area.push(number),
            Some(Shape::Nonplanar) => found.nonplanar.push(number),
            Some(Shape::Planar { zero_signed_area, self_crossing }) => {
                if zero_signed_area {
                    found.zero_signed_area.push(number);
                }
                if self_crossing {
                    found.self_crossing.push(number);
                }
            }
        }
    }
}
