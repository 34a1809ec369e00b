//! What the vertex numbers alone show: loops, uses of edges, links of vertices.

use super::{Category, Defects, Element};
use crate::mesh::face::{edge, sides};
use crate::mesh::triangles::EdgeKey;
use crate::mesh::vertex_list::VertexList;
use crate::partition::Partition;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// One side of one loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Use {
    /// The face.
    pub face: usize,
    /// The loop, as [`Face::loops`](crate::mesh::face::Face::loops) counts them.
    pub loop_: usize,
    /// Whether it runs from the smaller vertex to the greater.
    pub forward: bool,
}

/// The uses of each edge.
pub struct Uses(BTreeMap<EdgeKey, Vec<Use>>);

impl Uses {
    /// Those of a mesh, at each edge in order of the faces. Sides from a vertex to itself are none.
    pub fn of(mesh: &VertexList) -> Uses {
        let mut uses: BTreeMap<EdgeKey, Vec<Use>> = BTreeMap::new();
        for (face, polygon) in mesh.faces.iter().enumerate() {
            for (loop_, vertices) in polygon.loops().enumerate() {
                for [a, b] in sides(vertices).filter(|[a, b]| a != b) {
                    uses.entry(edge([a, b])).or_default().push(Use { face, loop_, forward: a < b });
                }
            }
        }
        Uses(uses)
    }

    /// The edges with their uses, in order.
    pub fn iter(&self) -> impl Iterator<Item = (EdgeKey, &[Use])> {
        self.0.iter().map(|(edge, uses)| (*edge, &uses[..]))
    }

    /// The uses of an edge, or of what is none.
    pub fn at(&self, edge: EdgeKey) -> &[Use] {
        self.0.get(&edge).map_or(&[], |uses| uses)
    }

    /// How many different edges are used.
    pub fn len(&self) -> usize {
        self.0.len()
    }
}

/// Vertices that do not exist.
pub fn out_of_range(mesh: &VertexList, defects: &mut Defects) {
    for (i, face) in mesh.faces.iter().enumerate() {
        if face.vertices().any(|v| v as usize >= mesh.vertices.len()) {
            defects.add(Category::IndexOutOfRange, Element::Face(i));
        }
    }
}

/// Each loop by itself. A loop of 3 or more vertices, none twice, has none of these, and its vertices have two
/// neighbours or more (ME-48, ME-53).
#[doc(alias = "ME-48")]
pub fn loops(mesh: &VertexList, defects: &mut Defects) {
    for (i, face) in mesh.faces.iter().enumerate() {
        for vertices in face.loops() {
            if vertices.len() < 3 {
                defects.add(Category::FaceLt3Vertices, Element::Face(i));
            }
            if vertices.iter().collect::<BTreeSet<_>>().len() < vertices.len() {
                defects.add(Category::RepeatedVertexInLoop, Element::Face(i));
            }
            if sides(vertices).any(|[a, b]| a == b) {
                defects.add(Category::DegenerateEdgeSameIndex, Element::Face(i));
            }
        }
    }
}

/// Each edge by its uses.
#[doc(alias = "ME-46")]
#[doc(alias = "ME-47")]
#[doc(alias = "ME-52")]
#[doc(alias = "ME-54")]
#[doc(alias = "ME-56")]
pub fn edges(uses: &Uses, defects: &mut Defects) {
    for (edge, uses) in uses.iter() {
        let n = uses.len();
        if n == 1 {
            defects.add(Category::BoundaryEdge, Element::Edge(edge));
        }
        if n > 2 {
            defects.add(Category::EdgeUsedGt2, Element::Edge(edge));
        }
        if n > 2 && n % 2 == 1 {
            defects.add(Category::EdgeOddUse, Element::Edge(edge));
        }
        // Uses come in order of the faces.
        if uses.windows(2).any(|pair| pair[0].face == pair[1].face) {
            defects.add(Category::EdgeTwiceInSameFace, Element::Edge(edge));
        }
        if n == 2 && uses[0].forward == uses[1].forward {
            defects.add(Category::InconsistentWindingEdge, Element::Edge(edge));
        }
    }
}

/// Each vertex by its edges and corners.
#[doc(alias = "ME-53")]
#[doc(alias = "ME-57")]
pub fn vertices(mesh: &VertexList, uses: &Uses, defects: &mut Defects) {
    let used = used(mesh);
    let mut neighbours = vec![0; mesh.vertices.len()];
    for (edge, _) in uses.iter() {
        for v in edge {
            neighbours[v as usize] += 1;
        }
    }
    for (v, (used, neighbours)) in (0..).zip(used.into_iter().zip(neighbours)) {
        if !used {
            defects.add(Category::IsolatedVertex, Element::Vertex(v));
        } else if neighbours < 2 {
            defects.add(Category::VertexLt2Edges, Element::Vertex(v));
        }
    }
    for v in split_links(mesh, uses) {
        defects.add(Category::NonmanifoldVertex, Element::Vertex(v));
    }
}

/// Which vertices a loop uses.
pub fn used(mesh: &VertexList) -> Vec<bool> {
    let mut used = vec![false; mesh.vertices.len()];
    for v in mesh.faces.iter().flat_map(|face| face.vertices()) {
        used[v as usize] = true;
    }
    used
}

/// The vertices whose link graph, neighbours joined by corners, has more than one component.
fn split_links(mesh: &VertexList, uses: &Uses) -> BTreeSet<u32> {
    // A node [v, w]: the neighbour w in the link of v.
    let nodes: Vec<[u32; 2]> = uses.iter().flat_map(|([a, b], _)| [[a, b], [b, a]]).collect();
    let number: HashMap<[u32; 2], usize> = nodes.iter().enumerate().map(|(i, node)| (*node, i)).collect();
    let mut link = Partition::new(nodes.len());
    for loop_ in mesh.faces.iter().flat_map(|face| face.loops()) {
        let corners = without_repeats(loop_);
        let n = corners.len();
        for i in 0..if n < 2 { 0 } else { n } {
            let [before, v, after] = [corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]];
            link.join(number[&[v, before]], number[&[v, after]]);
        }
    }
    let mut component: HashMap<u32, usize> = HashMap::new();
    let mut split = BTreeSet::new();
    for (i, [v, _]) in nodes.iter().enumerate() {
        let found = link.find(i);
        if *component.entry(*v).or_insert(found) != found {
            split.insert(*v);
        }
    }
    split
}

/// The loop, each run of one vertex as one.
fn without_repeats(loop_: &[u32]) -> Vec<u32> {
    let mut corners = loop_.to_vec();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    corners
}

/// Faces whose outer loops are equal as cycles.
pub fn duplicate_faces(mesh: &VertexList, defects: &mut Defects) {
    let mut same: BTreeMap<Vec<u32>, Vec<usize>> = BTreeMap::new();
    for (i, face) in mesh.faces.iter().enumerate() {
        same.entry(least_rotation(&face.outer)).or_default().push(i);
    }
    for faces in same.into_values().filter(|faces| faces.len() > 1) {
        defects.add(Category::DuplicateFace, Element::Faces(faces));
    }
}

/// The least of all rotations of a cycle, in both directions.
fn least_rotation(cycle: &[u32]) -> Vec<u32> {
    let backwards: Vec<u32> = cycle.iter().rev().copied().collect();
    let least = |cycle: &[u32]| {
        let (before, from) = cycle.split_at(least_start(cycle));
        [from, before].concat()
    };
    least(cycle).min(least(&backwards))
}

/// Where the least rotation of a cycle begins, in linear time: of two candidates that agree in k places and differ in the
/// next, the greater loses, and so does each of the k that follow it.
fn least_start(cycle: &[u32]) -> usize {
    let n = cycle.len();
    let (mut i, mut j, mut k) = (0, 1, 0);
    while i < n && j < n && k < n {
        match cycle[(i + k) % n].cmp(&cycle[(j + k) % n]) {
            Ordering::Equal => k += 1,
            Ordering::Less => (j, k) = (j + k + 1, 0),
            Ordering::Greater => (i, k) = (i + k + 1, 0),
        }
        j += usize::from(i == j);
    }
    i.min(j)
}
