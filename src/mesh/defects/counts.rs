//! The numbers of a mesh: V, E, F, H, C, χ, G, and whether it is a closed oriented surface.

use super::combinatorial::{Use, Uses, used};
use super::geometric::{points, same_sense_holes};
use super::{Category, Defects, Element};
use crate::mesh::vertex_list::VertexList;
use crate::number::{Rational, Sign};
use crate::partition::Partition;
use std::collections::BTreeSet;

/// The numbers of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    /// V: used vertices.
    pub vertices: usize,
    /// E: different edges used.
    pub edges: usize,
    /// F: faces, as many as there are in the list.
    pub faces: usize,
    /// H: loops of holes.
    pub holes: usize,
    /// C: connected components, used vertices being joined by faces; each face joins all its loops.
    pub components: usize,
    /// χ = V − E + F − H.
    pub chi: i64,
    /// G = C − χ/2. `None` unless the mesh is a manifold and χ is even; it is, but for loops without an edge.
    pub genus: Option<i64>,
    /// No edge has one use or more than two, and no side goes from a vertex to itself.
    pub closed: bool,
    /// Some choice of faces to flip, each with its holes, makes every edge with two uses run both ways; the mesh may be open.
    /// A hole that has its face's sense may be turned first: it says nothing of the surface.
    pub orientable: bool,
    /// Closed, orientable, wound consistently, and the link of each vertex is connected.
    pub manifold: bool,
    /// The volume inside, positive where loops run counterclockwise seen from outside. `None` unless the mesh is closed, wound
    /// consistently and orientable. A loop that is not plane is filled by the triangles from its first vertex.
    pub volume: Option<Rational>,
}

/// The numbers of a mesh, and the defects that show in them.
pub fn counts(mesh: &VertexList, uses: &Uses, defects: &mut Defects) -> Counts {
    let vertices = used(mesh).into_iter().filter(|used| *used).count();
    let (edges, faces, holes) = (uses.len(), mesh.faces.len(), mesh.faces.iter().map(|face| face.holes.len()).sum());
    let components = components(mesh);
    let chi = vertices as i64 - edges as i64 + faces as i64 - holes as i64;

    let has = |categories: &[Category]| categories.iter().any(|category| defects.has(*category));
    let closed = !has(&[Category::BoundaryEdge, Category::EdgeUsedGt2, Category::DegenerateEdgeSameIndex]);
    let consistent = !has(&[Category::InconsistentWindingEdge]);
    let all_holes_opposite = !has(&[Category::HoleSameSenseAsOuter]);
    let orientable = is_orientable(faces, uses, |_| false)
        || (!all_holes_opposite && {
            let same: BTreeSet<(usize, usize)> = (0..)
                .zip(&mesh.faces)
                .flat_map(|(i, face)| same_sense_holes(mesh, face).into_iter().map(move |loop_| (i, loop_)))
                .collect();
            is_orientable(faces, uses, |u| same.contains(&(u.face, u.loop_)))
        });
    let manifold = closed && consistent && orientable && !has(&[Category::NonmanifoldVertex]);
    let volume = (closed && consistent && orientable).then(|| volume(mesh));

    if closed && all_holes_opposite && !orientable {
        defects.add(Category::NonOrientable, Element::Mesh);
    }
    match volume.as_ref().map(|volume| Sign::of(volume.cmp0())) {
        Some(Sign::Negative) => defects.add(Category::InsideOut, Element::Mesh),
        Some(Sign::Zero) => defects.add(Category::ZeroVolume, Element::Mesh),
        Some(Sign::Positive) | None => {}
    }
    let genus = (manifold && chi % 2 == 0).then(|| components as i64 - chi / 2);
    Counts { vertices, edges, faces, holes, components, chi, genus, closed, orientable, manifold, volume }
}

/// C. By edges alone, faces with holes would fall apart (ME-73).
#[doc(alias = "ME-73")]
fn components(mesh: &VertexList) -> usize {
    let mut joined = Partition::new(mesh.vertices.len());
    for face in &mesh.faces {
        let mut vertices = face.vertices();
        if let Some(first) = vertices.next() {
            for v in vertices {
                joined.join(first as usize, v as usize);
            }
        }
    }
    let used = used(mesh);
    (0..used.len()).filter(|&v| used[v] && joined.find(v) == v).count()
}

/// Whether some choice of faces to flip makes every edge with two uses run both ways, once those uses are turned.
fn is_orientable(faces: usize, uses: &Uses, is_turned: impl Fn(&Use) -> bool) -> bool {
    // Each face twice, kept and flipped; what must be chosen together is joined.
    let mut together = Partition::new(2 * faces);
    for (_, uses) in uses.iter() {
        if let [a, b] = uses {
            let [along_a, along_b] = [a, b].map(|u| u.forward != is_turned(u));
            let [a, b, flip] = [2 * a.face, 2 * b.face, usize::from(along_a == along_b)];
            together.join(a, b + flip);
            together.join(a + 1, b + 1 - flip);
        }
    }
    (0..faces).all(|face| together.find(2 * face) != together.find(2 * face + 1))
}

/// ⅙ Σ |v₁ vᵢ vᵢ₊₁| over the triangles from the first vertex of each loop: the cones from the origin.
fn volume(mesh: &VertexList) -> Rational {
    let loops = mesh.faces.iter().flat_map(|face| face.loops());
    let cones = loops.map(|loop_| match &points(mesh, loop_)[..] {
        [] => Rational::new(),
        [first, rest @ ..] => rest.windows(2).map(|pair| first.dot(&pair[0].cross(pair[1]))).sum(),
    });
    cones.sum::<Rational>() / Rational::from(6)
}
