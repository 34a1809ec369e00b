//! The flat objects of the text: two faces, or more, back to back, so that they can be taken in hand.

use super::mesh;
use crate::mesh::gluing::Gluing;
use crate::mesh::printed;
use crate::mesh::vertex_list::VertexList;
use crate::number::Rational;

/// A polygon of the plane z = 1, counterclockwise, with its other side.
pub fn lamina(polygon: &[[i64; 2]]) -> VertexList {
    let front: Vec<u32> = (0..polygon.len() as u32).collect();
    let back: Vec<u32> = front.iter().rev().copied().collect();
    mesh(&at_height_1(polygon), &[front, back])
}

fn at_height_1(polygon: &[[i64; 2]]) -> Vec<[i64; 3]> {
    polygon.iter().map(|[x, y]| [*x, *y, 1]).collect()
}

/// The text's square, hexagon and octagon: V = E = 4, 6, 8, F = 2. Its figures give no coordinates.
#[doc(alias = "ME-76")]
pub fn laminae() -> [VertexList; 3] {
    [
        lamina(&[[0, 0], [2, 0], [2, 2], [0, 2]]),
        lamina(&[[0, 0], [4, 0], [4, 1], [1, 1], [1, 3], [0, 3]]),
        lamina(&[[0, 0], [3, 0], [3, 1], [2, 1], [2, 3], [1, 3], [1, 1], [0, 1]]),
    ]
}

/// The text's triangle, two faces.
#[doc(alias = "ME-97")]
pub fn triangle() -> VertexList {
    printed::triangle()
}

/// The text's segment: a quadrilateral ever so thin, 1/1000 here, with its other side.
#[doc(alias = "ME-99")]
pub fn segment() -> VertexList {
    printed::segment(&Rational::from((1, 2000))).expect("it has a width")
}

/// The text's hollow triangle: two faces with a hole each.
#[doc(alias = "ME-98")]
pub fn hollow_triangle() -> VertexList {
    VertexList::from(&printed::hollow_triangle())
}

/// The text's house by its faces: the edge from V3 to V4 is in all four.
#[doc(alias = "ME-100")]
pub fn house() -> VertexList {
    printed::house()
}

/// The house with its edges A1 … A8 as printed, named a … h: c = A3 and h = A8 both join V3 and V4. F1 and F2, its front,
/// have A3 in common, F3 and F4, its back, A8.
pub fn house_by_edges() -> Gluing {
    // a = V1V2, b = V2V3, c = V3V4, d = V4V5, e = V5V6, f = V6V3, g = V1V4, h = V3V4.
    Gluing::from_words(&["abcG", "CFED", "AgHB", "hdef"]).expect("eight edges of two sides")
}

/// The same edges where F1 and F3 have A3 in common, F2 and F4 A8: two laminae.
pub fn house_in_two() -> Gluing {
    Gluing::from_words(&["abcG", "HFED", "AgCB", "hdef"]).expect("eight edges of two sides")
}

/// The house of eight triangles: the edges from V3 to V4 are two, and the front's inner edges are not the back's.
#[doc(alias = "ME-104")]
pub fn house_of_triangles() -> Gluing {
    // At the front i = V1V3, j = V4V6, at the back k = V1V3, l = V4V6.
    Gluing::from_words(&["abI", "icG", "CFJ", "jED", "AkB", "gHK", "hlf", "deL"]).expect("twelve edges of two sides")
}

/// The house in space, from z = 0 to z = 1: the outline's hexagon as a prism, both ends with the edge from V3 to V4, now two
/// edges of different ends.
pub fn house_prism() -> VertexList {
    let outline = [[2, 1], [5, 1], [5, 3], [2, 3], [3, 4], [4, 4]];
    let at = |z: i64| outline.map(|[x, y]| [x, y, z]);
    let around = [0, 1, 2, 5, 4, 3];
    let walls = (0..6).map(|i| {
        let [a, b] = [around[i], around[(i + 1) % 6]];
        vec![a, b, b + 6, a + 6]
    });
    let ends = [vec![6, 7, 8, 9], vec![9, 8, 11, 10], vec![1, 0, 3, 2], vec![2, 3, 4, 5]];
    mesh(&[at(0), at(1)].concat(), &ends.into_iter().chain(walls).collect::<Vec<_>>())
}
