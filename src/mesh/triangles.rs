//! What is wrong with a triangle mesh as a surface, whatever it is meant to be.

use crate::partition::Partition;
use std::collections::{BTreeMap, HashMap};

/// A triangle, as three vertex numbers.
pub type Triangle = [u32; 3];

/// An undirected edge, the smaller vertex number first.
pub type EdgeKey = [u32; 2];

/// One defect of a triangle mesh, with its witness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Defect {
    /// A triangle names a vertex that does not exist.
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
    },
    /// A triangle names a vertex twice.
    RepeatedVertex {
        /// The triangle.
        triangle: usize,
    },
    /// Two triangles have the same three vertices.
    DuplicateTriangle {
        /// The earlier and the later one.
        triangles: [usize; 2],
    },
    /// An edge with more than two triangles.
    EdgeUsedMoreThanTwice {
        /// Its ends.
        edge: EdgeKey,
        /// How many triangles use it.
        uses: usize,
    },
    /// Two triangles run along their common edge in the same direction.
    InconsistentWinding {
        /// Its ends.
        edge: EdgeKey,
    },
    /// The triangles at a vertex make more than one fan.
    NonmanifoldVertex {
        /// The vertex.
        vertex: u32,
    },
}

impl Defect {
    /// The category's name, as in the protocol's `mesh.check` where that has it.
    pub const fn name(&self) -> &'static str {
        match self {
            Defect::IndexOutOfRange { .. } => "index_out_of_range",
            Defect::RepeatedVertex { .. } => "repeated_vertex_in_loop",
            Defect::DuplicateTriangle { .. } => "duplicate_face",
            Defect::EdgeUsedMoreThanTwice { .. } => "edge_used_gt2",
            Defect::InconsistentWinding { .. } => "inconsistent_winding_edge",
            Defect::NonmanifoldVertex { .. } => "nonmanifold_vertex",
        }
    }
}

/// The uses of each edge: how many triangles run along it from its smaller to its greater vertex, and how
/// many the other way.
pub fn edge_uses(triangles: &[Triangle]) -> HashMap<EdgeKey, [u32; 2]> {
    let mut uses: HashMap<EdgeKey, [u32; 2]> = HashMap::with_capacity(triangles.len() * 3 / 2);
    for triangle in triangles {
        for [a, b] in sides(*triangle) {
            uses.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
        }
    }
    uses
}

/// The three directed sides of a triangle.
pub fn sides([a, b, c]: Triangle) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The edges that exactly one triangle uses, directed as it runs along them, sorted.
pub fn boundary_edges(triangles: &[Triangle]) -> Vec<[u32; 2]> {
    let mut boundary: Vec<_> = edge_uses(triangles)
        .into_iter()
        .filter_map(|([a, b], uses)| match uses {
            [1, 0] => Some([a, b]),
            [0, 1] => Some([b, a]),
            _ => None,
        })
        .collect();
    boundary.sort_unstable();
    boundary
}

/// Every defect of a triangle mesh, sorted; empty iff it is a consistently oriented 2-manifold with
/// boundary. Where an index is out of range, or a triangle repeats a vertex, only such defects are told.
pub fn defects(vertices: usize, triangles: &[Triangle]) -> Vec<Defect> {
    let mut defects = Vec::new();
    for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
        if [a, b, c].iter().any(|&v| v as usize >= vertices) {
            defects.push(Defect::IndexOutOfRange { triangle });
        } else if a == b || b == c || c == a {
            defects.push(Defect::RepeatedVertex { triangle });
        }
    }
    if !defects.is_empty() {
        return defects;
    }
    let mut seen: HashMap<Triangle, usize> = HashMap::with_capacity(triangles.len());
    for (i, triangle) in triangles.iter().enumerate() {
        let mut corners = *triangle;
        corners.sort_unstable();
        if let Some(earlier) = seen.insert(corners, i) {
            defects.push(Defect::DuplicateTriangle { triangles: [earlier, i] });
        }
    }
    for (edge, [up, down]) in edge_uses(triangles) {
        match (up, down) {
            (0, 1) | (1, 0) | (1, 1) => {}
            (2, 0) | (0, 2) => defects.push(Defect::InconsistentWinding { edge }),
            (up, down) => defects.push(Defect::EdgeUsedMoreThanTwice { edge, uses: (up + down) as usize }),
        }
    }
    defects.extend(nonmanifold_vertices(triangles).into_iter().map(|vertex| Defect::NonmanifoldVertex { vertex }));
    defects.sort();
    defects
}

/// The vertices whose triangles are not all connected through edges at that vertex (IS-11).
fn nonmanifold_vertices(triangles: &[Triangle]) -> Vec<u32> {
    // The corners of the mesh, joined where two triangles at a vertex share an edge at it.
    let mut corners = Partition::new(3 * triangles.len());
    let mut at: HashMap<[u32; 2], usize> = HashMap::with_capacity(3 * triangles.len());
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        for (k, (vertex, others)) in [(a, [b, c]), (b, [c, a]), (c, [a, b])].into_iter().enumerate() {
            for other in others {
                let first = *at.entry([vertex, other]).or_insert(3 * t + k);
                corners.join(first, 3 * t + k);
            }
        }
    }
    let mut fan_of: HashMap<u32, usize> = HashMap::new();
    let mut nonmanifold = Vec::new();
    for (i, &vertex) in triangles.iter().flatten().enumerate() {
        let fan = corners.find(i);
        if *fan_of.entry(vertex).or_insert(fan) != fan {
            nonmanifold.push(vertex);
        }
    }
    nonmanifold.sort_unstable();
    nonmanifold.dedup();
    nonmanifold
}

/// One connected component of a triangle mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MeshComponent {
    /// V − E + F.
    pub chi: i64,
    /// How many closed curves its boundary edges make; for a 2-manifold, its boundary loops.
    pub boundary_loops: i64,
    /// The genus, where the mesh is an oriented 2-manifold: χ = 2 − 2·genus − loops.
    pub genus: i64,
}

/// The components of a mesh without defects: triangles connected through vertices, sorted; vertices that no
/// triangle uses do not count.
pub fn components(vertices: usize, triangles: &[Triangle]) -> Vec<MeshComponent> {
    let mut connected = Partition::new(vertices);
    for &[a, b, c] in triangles {
        connected.join(a as usize, b as usize);
        connected.join(a as usize, c as usize);
    }
    let mut totals: BTreeMap<usize, MeshComponent> = BTreeMap::new();
    let mut add = |connected: &mut Partition, vertex: u32, chi: i64, boundary_loops: i64| {
        let zero = MeshComponent { chi: 0, boundary_loops: 0, genus: 0 };
        let total = totals.entry(connected.find(vertex as usize)).or_insert(zero);
        total.chi += chi;
        total.boundary_loops += boundary_loops;
    };
    let mut used = vec![false; vertices];
    for triangle in triangles {
        add(&mut connected, triangle[0], 1, 0);
        for &vertex in triangle {
            if !std::mem::replace(&mut used[vertex as usize], true) {
                add(&mut connected, vertex, 1, 0);
            }
        }
    }
    let mut curves = Partition::new(vertices);
    for (&[a, b], &[up, down]) in &edge_uses(triangles) {
        add(&mut connected, a, -1, 0);
        if up + down == 1 && !curves.join(a as usize, b as usize) {
            add(&mut connected, a, 0, 1);
        }
    }
    let mut components: Vec<_> = totals.into_values().collect();
    for component in &mut components {
        component.genus = (2 - component.chi - component.boundary_loops) / 2;
    }
    components.sort();
    components
}
