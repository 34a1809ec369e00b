//! The meshes that text 001 prints with their tables, as printed. Numbers begin with 0 here, with 1 there.

use super::edge_list::{EdgeId, EdgeList, EdgeRecords, Side};
use super::explicit::Polygon;
use super::face::Face;
use super::vertex_list::{Point, VertexList};
use crate::linear::Vector;
use crate::number::Rational;

/// A point by tenths; its third coordinate is 1, as in the tables.
fn tenths([x, y]: [i64; 2]) -> Point {
    Vector([Rational::from((x, 10)), Rational::from((y, 10)), Rational::from(1)])
}

/// A side by the number of its edge, from 1 as printed; negative where the loop runs from the edge's second vertex to
/// its first.
fn side(number: i32) -> Side {
    Side { edge: EdgeId(number.unsigned_abs() - 1), is_backward: number < 0 }
}

fn loop_of(numbers: &[i32]) -> Vec<Side> {
    numbers.iter().copied().map(side).collect()
}

const TRIANGLE: [[i64; 2]; 3] = [[50, 100], [100, 0], [0, 0]];

/// The triangle by faces and vertices: Ft1 = (Vt1, Vt2, Vt3), Ft2 = (Vt1, Vt3, Vt2) (ME-32). A closed mesh of two
/// faces, each clockwise from its own side.
#[doc(alias = "ME-32")]
pub fn triangle() -> VertexList {
    VertexList { vertices: TRIANGLE.map(tenths).to_vec(), faces: vec![Face::from([0, 1, 2]), Face::from([0, 2, 1])] }
}

/// The triangle by faces, edges and vertices: At1 = (Vt1, Vt2), At2 = (Vt2, Vt3), At3 = (Vt3, Vt1);
/// Ft1 = (At1, At2, At3), Ft2 = (At1, At3, At2) (ME-33). That an edge lists its faces is added.
#[doc(alias = "ME-33")]
pub fn triangle_records() -> EdgeRecords {
    let edge = |ends| super::edge_list::Edge { ends, faces: vec![0, 1] };
    EdgeRecords {
        vertices: TRIANGLE.map(tenths).to_vec(),
        edges: [[0, 1], [1, 2], [2, 0]].map(edge).to_vec(),
        faces: vec![Polygon::new([0, 1, 2]), Polygon::new([0, 2, 1])],
    }
}

/// The hollow triangle, "triângulo vazado": two faces, each with a hole (ME-34). The text lists the six edges of a
/// face in one row; that the last three are a loop of their own is in [`hollow_triangle_rows`] for the reader to find.
#[doc(alias = "ME-34")]
pub fn hollow_triangle() -> EdgeList {
    let vertices = [[50, 100], [100, 0], [0, 0], [1, 1], [99, 1], [50, 99]].map(tenths).to_vec();
    let ends = vec![[0, 1], [1, 2], [2, 0], [4, 3], [3, 5], [5, 4]];
    let face = |outer: &[i32], hole: &[i32]| Polygon { outer: loop_of(outer), holes: vec![loop_of(hole)] };
    let faces = vec![face(&[1, 2, 3], &[-4, -6, -5]), face(&[-1, -3, -2], &[4, 5, 6])];
    EdgeList::new(vertices, ends, faces).expect("the printed tables are consistent")
}

/// The rows of the hollow triangle's face table: the numbers of the edges, from 0, of Ft1 and Ft2.
pub fn hollow_triangle_rows() -> [[u32; 6]; 2] {
    [[0, 1, 2, 3, 5, 4], [0, 2, 1, 3, 4, 5]]
}

/// A segment as an object: a quadrilateral of half the given width to either side of the segment from (0, 0) to (1, 0),
/// with two faces and four edges (ME-35). `None` iff it has no width.
#[doc(alias = "ME-35")]
pub fn segment(half_width: &Rational) -> Option<VertexList> {
    let at = |x: i64, y: Rational| Vector([Rational::from(x), y, Rational::from(1)]);
    let (below, above) = (Rational::from(-half_width), half_width.clone());
    let vertices = vec![at(0, below.clone()), at(1, below), at(1, above.clone()), at(0, above)];
    let faces = vec![Face::from([0, 1, 2, 3]), Face::from([1, 0, 3, 2])];
    (!half_width.is_zero()).then_some(VertexList { vertices, faces })
}

/// The house, "casinha", by its printed vertices and faces: F1 = (V1, V2, V3, V4), F2 = (V4, V3, V6, V5),
/// F3 = (V2, V1, V4, V3), F4 = (V3, V4, V5, V6). All four use the edge of V3 and V4 (ME-36).
pub fn house() -> VertexList {
    VertexList {
        vertices: [[20, 10], [50, 10], [50, 30], [20, 30], [30, 40], [40, 40]].map(tenths).to_vec(),
        faces: [[0, 1, 2, 3], [3, 2, 5, 4], [1, 0, 3, 2], [2, 3, 4, 5]].map(Face::from).to_vec(),
    }
}

/// The printed edges A1 … A8 of the house by their vertices. A3 and A8 have the same.
pub const HOUSE_EDGES: [[u32; 2]; 8] = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 2], [0, 3], [2, 3]];

/// Which edge of V3 and V4 each face of the house uses: the text does not say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum HouseReading {
    /// A3 in F1 and F2, A8 in F3 and F4: front and back are two discs, glued along the outline to one sphere.
    FrontAndBack,
    /// A3 in F1 and F3, A8 in F2 and F4: walls and roof are two spheres that touch at V3 and V4.
    WallsAndRoof,
}

/// The house with its eight printed edges, each common to two faces, which run along it in opposite directions
/// (ME-36).
#[doc(alias = "ME-36")]
pub fn house_with_edges(reading: HouseReading) -> EdgeList {
    let [f2, f3] = match reading {
        HouseReading::FrontAndBack => [3, 8],
        HouseReading::WallsAndRoof => [8, 3],
    };
    let faces = [[1, 2, 3, -7], [-f2, -6, -5, -4], [-1, 7, -f3, -2], [8, 4, 5, 6]];
    let faces = faces.map(|numbers| Polygon::new(loop_of(&numbers))).to_vec();
    EdgeList::new(house().vertices, HOUSE_EDGES.to_vec(), faces).expect("the printed loops are closed")
}
