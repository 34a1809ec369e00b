//! Vertices inside edges.

use super::combinatorial::{Uses, used};
use super::{Category, Defects, Element};
use crate::linear::Vector;
use crate::mesh::vertex_list::{Point, VertexList};

/// The used vertices along each axis: in order of their coordinate, and where the different coordinates begin.
struct Axis {
    /// Vertices by coordinate.
    order: Vec<u32>,
    /// The rank of each vertex's coordinate among the different ones.
    rank: Vec<usize>,
    /// Where in `order` each rank begins, and, last, its end.
    begins: Vec<usize>,
}

impl Axis {
    fn new(vertices: &[Point], used: &[bool], k: usize) -> Axis {
        let mut order: Vec<u32> = (0..).zip(used).filter(|(_, used)| **used).map(|(v, _)| v).collect();
        let coordinate = |v: u32| &vertices[v as usize][k];
        order.sort_by(|a, b| coordinate(*a).cmp(coordinate(*b)));
        let (mut rank, mut begins) = (vec![0; vertices.len()], Vec::new());
        for (i, &v) in order.iter().enumerate() {
            if i == 0 || coordinate(order[i - 1]) != coordinate(v) {
                begins.push(i);
            }
            rank[v as usize] = begins.len() - 1;
        }
        begins.push(order.len());
        Axis { order, rank, begins }
    }

    /// The least and the greatest rank of an edge's points.
    fn range(&self, edge: [u32; 2]) -> [usize; 2] {
        let [a, b] = edge.map(|v| self.rank[v as usize]);
        [a.min(b), a.max(b)]
    }

    /// The vertices whose coordinate is one of an edge's points.
    fn beside(&self, edge: [u32; 2]) -> &[u32] {
        let [low, high] = self.range(edge);
        &self.order[self.begins[low]..self.begins[high + 1]]
    }

    fn has_beside(&self, v: u32, edge: [u32; 2]) -> bool {
        let [low, high] = self.range(edge);
        (low..=high).contains(&self.rank[v as usize])
    }
}

/// Every used vertex strictly inside a used edge.
///
/// An edge is compared with the vertices beside it along the axis that has fewest of them.
pub fn t_junctions(mesh: &VertexList, uses: &Uses, defects: &mut Defects) {
    let used = used(mesh);
    let axes = [0, 1, 2].map(|k| Axis::new(&mesh.vertices, &used, k));
    for (edge, _) in uses.iter() {
        let [a, b] = edge.map(|v| &mesh.vertices[v as usize]);
        let fewest = axes.iter().map(|axis| axis.beside(edge)).min_by_key(|beside| beside.len());
        for &v in fewest.into_iter().flatten() {
            let is_near = !edge.contains(&v) && axes.iter().all(|axis| axis.has_beside(v, edge));
            if is_near && is_strictly_between(&mesh.vertices[v as usize], a, b) {
                defects.add(Category::TJunction, Element::VertexInEdge(v, edge));
            }
        }
    }
}

/// Whether p = a + t(b − a) for some 0 < t < 1, and p is neither end.
fn is_strictly_between(p: &Point, a: &Point, b: &Point) -> bool {
    let (to, along) = (p.clone() - a, b.clone() - a);
    // With p on the line, t = ⟨to, along⟩/|along|².
    let t = to.dot(&along);
    to.cross(&along) == Vector::zero() && t > 0 && t < along.norm_squared()
}
