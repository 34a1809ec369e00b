//! Solids by their boundary: prisms, blocks with holes, and solids of unit cubes.

use super::mesh;
use crate::mesh::face::Face;
use crate::mesh::vertex_list::VertexList;
use std::collections::{BTreeMap, BTreeSet};

/// A prism over a polygon that runs counterclockwise, from z = 0 up to a height > 0.
pub fn prism(polygon: &[[i64; 2]], height: i64) -> VertexList {
    let n = polygon.len() as u32;
    let at = |z: i64| polygon.iter().map(move |[x, y]| [*x, *y, z]);
    let ends = [(0..n).rev().collect::<Vec<u32>>(), (n..2 * n).collect()];
    let walls = (0..n).map(|a| (a, (a + 1) % n)).map(|(a, b)| vec![a, b, b + n, a + n]);
    mesh(&at(0).chain(at(height)).collect::<Vec<_>>(), &ends.into_iter().chain(walls).collect::<Vec<_>>())
}

/// A hexagonal prism: V = 12, E = 18, F = 8.
#[doc(alias = "ME-78")]
pub fn hexagonal_prism() -> VertexList {
    prism(&[[2, 0], [4, 1], [4, 3], [2, 4], [0, 3], [0, 1]], 3)
}

/// The cube [0, 2]³, each face divided in four by the lines through its centre: V = 26, E = 48, F = 24.
#[doc(alias = "ME-79")]
pub fn divided_cube() -> VertexList {
    cubes(&grid([2; 3]).collect())
}

/// The cells 0 … n−1 of a grid.
pub fn grid([nx, ny, nz]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..nx).flat_map(move |x| (0..ny).flat_map(move |y| (0..nz).map(move |z| [x, y, z])))
}

/// A side of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BoxSide {
    /// Least z.
    Bottom,
    /// Greatest z.
    Top,
    /// Least y.
    Front,
    /// Greatest x.
    Right,
    /// Greatest y.
    Back,
    /// Least x.
    Left,
}

const SIDES: [BoxSide; 6] =
    [BoxSide::Bottom, BoxSide::Top, BoxSide::Front, BoxSide::Right, BoxSide::Back, BoxSide::Left];

impl BoxSide {
    /// The corners of [`corners`] at it, counterclockwise from outside.
    fn corners(self) -> [u32; 4] {
        match self {
            BoxSide::Bottom => [0, 3, 2, 1],
            BoxSide::Top => [4, 5, 6, 7],
            BoxSide::Front => [0, 1, 5, 4],
            BoxSide::Right => [1, 2, 6, 5],
            BoxSide::Back => [2, 3, 7, 6],
            BoxSide::Left => [3, 0, 4, 7],
        }
    }
}

fn corners([x, y, z]: [i64; 3], [u, v, w]: [i64; 3]) -> [[i64; 3]; 8] {
    [[x, y, z], [u, y, z], [u, v, z], [x, v, z], [x, y, w], [u, y, w], [u, v, w], [x, v, w]]
}

/// A box that is cut out of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// Its corner of least coordinates.
    pub lo: [i64; 3],
    /// Its corner of greatest coordinates.
    pub hi: [i64; 3],
    /// The sides at which it opens: none for a cavity, one for a blind hole, two opposite ones for a through hole.
    pub open: Vec<BoxSide>,
}

/// The block from (0, 0, 0) to `hi` less boxes. It is the solid's boundary where the cuts touch neither one another nor the
/// block's edges, and each reaches the sides at which it opens, and only these.
pub fn block(hi: [i64; 3], cuts: &[Cut]) -> VertexList {
    let mut vertices = corners([0; 3], hi).to_vec();
    let mut outer: Vec<Face> = SIDES.iter().map(|side| Face::from(side.corners())).collect();
    let mut inner = Vec::new();
    for cut in cuts {
        let first = vertices.len() as u32;
        vertices.extend(corners(cut.lo, cut.hi));
        for (side, face) in SIDES.iter().zip(&mut outer) {
            let wall = Face::from(side.corners().map(|v| v + first)).reversed();
            if cut.open.contains(side) { face.holes.push(wall.outer) } else { inner.push(wall) }
        }
    }
    let faces = outer.into_iter().chain(inner).collect();
    VertexList { vertices: vertices.into_iter().map(super::point).collect(), faces }
}

fn through(x: i64, y: i64, height: i64) -> Cut {
    Cut { lo: [x, y, 0], hi: [x + 1, y + 1, height], open: vec![BoxSide::Bottom, BoxSide::Top] }
}

fn pit(x: i64, y: i64, height: i64) -> Cut {
    Cut { lo: [x, y, height - 1], hi: [x + 1, y + 1, height], open: vec![BoxSide::Top] }
}

/// The solid of the text's figure 3.5: a block with a through hole and a blind hole in another face. V = 24, E = 36,
/// F = 15, three faces have a hole.
#[doc(alias = "ME-96")]
pub fn pierced_block() -> VertexList {
    let blind = Cut { lo: [1, 0, 1], hi: [2, 1, 2], open: vec![BoxSide::Front] };
    block([5, 5, 3], &[through(3, 3, 3), blind])
}

/// The same with the blind hole beside the through hole: V = 24, E = 36, F = 15, two faces have holes, three in all.
pub fn pierced_block_with_two_in_one_face() -> VertexList {
    block([5, 5, 3], &[through(3, 3, 3), pit(1, 1, 3)])
}

/// A block with g through holes side by side: G = g, H = 2g.
#[doc(alias = "ME-83")]
pub fn block_with_through_holes(g: i64) -> VertexList {
    block([2 * g + 1, 3, 2], &(0..g).map(|i| through(2 * i + 1, 1, 2)).collect::<Vec<_>>())
}

/// A block with one pit: V = 16, E = 24, F = 11, H = 1, G = 0.
pub fn block_with_pit() -> VertexList {
    block([3, 3, 3], &[pit(1, 1, 3)])
}

/// A block with two pits in one face: V = 24, E = 36, F = 16, H = 2, G = 0.
pub fn block_with_two_pits() -> VertexList {
    block([5, 3, 3], &[pit(1, 1, 3), pit(3, 1, 3)])
}

/// A block with a cavity: one solid of two shells.
pub fn block_with_cavity() -> VertexList {
    block([3, 3, 3], &[Cut { lo: [1; 3], hi: [2; 3], open: vec![] }])
}

/// The cube with a square drawn on its top that no edge leads to: V = 12, E = 16, F = 7, H = 1.
#[doc(alias = "ME-80")]
pub fn cube_with_loop() -> VertexList {
    let mut mesh = block([3, 3, 3], &[]);
    mesh.vertices.extend([[1, 1, 3], [2, 1, 3], [2, 2, 3], [1, 2, 3]].map(super::point));
    mesh.faces[1].holes.push(vec![11, 10, 9, 8]);
    mesh.faces.push(Face::from([8, 9, 10, 11]));
    mesh
}

/// A frame with corners mitred: a torus of sixteen quadrilaterals, V = 16, E = 32.
#[doc(alias = "ME-82")]
pub fn frame() -> VertexList {
    let mut mesh = block([3, 3, 1], &[through(1, 1, 1)]);
    let [bottom, top]: [Face; 2] = [mesh.faces.remove(0), mesh.faces.remove(0)];
    for face in [bottom, top] {
        let (outer, hole) = (&face.outer, &face.holes[0]);
        // Both loops begin at the same corner of their boxes and run opposite ways.
        let inner = |i: usize| hole[(4 - i) % 4];
        mesh.faces.extend((0..4).map(|i| Face::from([outer[i], outer[(i + 1) % 4], inner((i + 1) % 4), inner(i)])));
    }
    mesh
}

/// A solid of the unit cubes [x, x+1] × [y, y+1] × [z, z+1], by the squares between them and the rest, counterclockwise
/// from the rest. Vertices and edges at one place are one, so that more than two squares may have an edge.
#[doc(alias = "ME-94")]
pub fn cubes(cells: &BTreeSet<[i64; 3]>) -> VertexList {
    let steps = [[0, 0, -1], [0, 0, 1], [0, -1, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0]];
    let mut numbers: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for cell in cells {
        let at = corners(*cell, cell.map(|x| x + 1));
        for (side, step) in SIDES.iter().zip(steps) {
            if !cells.contains(&std::array::from_fn(|i| cell[i] + step[i])) {
                faces.push(side.corners().map(|corner| {
                    *numbers.entry(at[corner as usize]).or_insert_with(|| {
                        vertices.push(at[corner as usize]);
                        vertices.len() as u32 - 1
                    })
                }));
            }
        }
    }
    mesh(&vertices, &faces)
}

/// A cube of 27 cells with two square tunnels through it that meet at the centre: two straight holes, and G = 3.
#[doc(alias = "ME-85")]
pub fn crossing_tunnels() -> VertexList {
    cubes(&grid([3; 3]).filter(|[x, y, z]| *z != 1 || (*x != 1 && *y != 1)).collect())
}

/// Two cubes with one edge in common, which is in four squares.
#[doc(alias = "ME-95")]
pub fn cubes_on_an_edge() -> VertexList {
    cubes(&BTreeSet::from([[0, 0, 0], [1, 1, 0]]))
}

/// Two solids of six triangles each that touch at two points: V = 8, E = 18, F = 12, each edge is in two triangles, each vertex has
/// three edges or more, all is connected, V − E + F = 2; and it is no surface.
#[doc(alias = "ME-93")]
pub fn solids_at_two_points() -> VertexList {
    let vertices = [[0, 0, 0], [4, 0, 0], [2, 3, 0], [2, 5, 1], [2, 5, -1], [2, -3, 0], [2, -5, 1], [2, -5, -1]];
    let [p, q] = [0, 1];
    let cones =
        |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]].into_iter().flat_map(move |[v, w]| [[w, v, q], [v, w, p]]);
    mesh(&vertices, &cones([2, 3, 4]).chain(cones([5, 7, 6])).collect::<Vec<_>>())
}
