//! The meshes that representations are tested on: named ones, all small ones, and random ones near the forbidden.

use isoracle::mesh::edge_list::EdgeList;
use isoracle::mesh::examples::{cube, mesh, point, quad_torus, tetrahedron};
use isoracle::mesh::face::Face;
use isoracle::mesh::printed::{hollow_triangle, house, segment, triangle};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::mesh::winged_edge::WingedEdges;
use isoracle::number::Rational;
use proptest::prelude::*;

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
pub fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// Positions that differ, three of them never on one line.
pub fn positions(n: u32) -> Vec<[i64; 3]> {
    (0..i64::from(n)).map(|i| [i, i * i, i * i * i]).collect()
}

/// Every loop of at most that many vertices out of 0 … labels − 1, with repetitions, the empty one first.
pub fn loops(labels: u32, longest: u32) -> Vec<Vec<u32>> {
    let of = |length: u32| {
        (0..labels.pow(length)).map(move |code| (0..length).map(|i| code / labels.pow(i) % labels).collect())
    };
    (0..=longest).flat_map(of).collect()
}

pub fn octahedron() -> VertexList {
    mesh(
        &[[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]],
        &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]],
    )
}

/// Triangles on one edge.
pub fn book(pages: u32) -> VertexList {
    let faces: Vec<[u32; 3]> = (0..pages).map(|page| [0, 1, 2 + page]).collect();
    mesh(&positions(2 + pages), &faces)
}

/// The Möbius strip of five triangles.
pub fn moebius_strip() -> VertexList {
    let faces: Vec<[u32; 3]> = (0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]).collect();
    mesh(&positions(5), &faces)
}

/// Two tetrahedra with one vertex in common.
pub fn two_tetrahedra() -> VertexList {
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    let both: Vec<[u32; 3]> =
        faces.into_iter().chain(faces.map(|t| t.map(|v| if v == 0 { 0 } else { v + 3 }))).collect();
    mesh(&positions(7), &both)
}

/// The cube whose top runs in to an inner vertex and back: closed, but the inner edge is in one polygon only, twice.
pub fn cube_with_spur() -> VertexList {
    let mut cube = cube();
    cube.vertices.push(point([1, 1, 2]));
    cube.vertices[8].0.iter_mut().take(2).for_each(|x| *x /= 2);
    cube.faces[1] = Face::from([4, 8, 4, 5, 6, 7]);
    cube
}

/// The cube with a square hole through it from bottom to top: two faces with holes.
pub fn cube_with_tunnel() -> VertexList {
    let mut mesh = cube();
    mesh.vertices = cube().vertices.iter().map(|p| p.map(|x| Rational::from(x * 3u32))).collect();
    for z in [0, 3] {
        mesh.vertices.extend([[1, 1, z], [2, 1, z], [2, 2, z], [1, 2, z]].map(point));
    }
    mesh.faces[0].holes.push(vec![8, 9, 10, 11]);
    mesh.faces[1].holes.push(vec![12, 15, 14, 13]);
    mesh.faces.extend((0..4).map(|i| Face::from([8 + i, 12 + i, 12 + (i + 1) % 4, 8 + (i + 1) % 4])));
    mesh
}

fn without_face(mut mesh: VertexList, face: usize) -> VertexList {
    mesh.faces.remove(face);
    mesh
}

/// Meshes with their names. Positions differ, and no face names a missing vertex.
pub fn named() -> Vec<(&'static str, VertexList)> {
    let width = Rational::from((1, 1000));
    vec![
        ("nothing", VertexList::default()),
        ("one triangle", mesh(&positions(3), &[[0, 1, 2]])),
        ("vertices only", mesh::<[u32; 0]>(&positions(3), &[])),
        ("an empty face", mesh(&positions(2), &[&[][..], &[0], &[0, 1]])),
        ("a two-sided loop", mesh(&positions(3), &[&[0, 1][..], &[1, 0], &[0, 1, 2]])),
        ("tetrahedron", tetrahedron()),
        ("cube", cube()),
        ("octahedron", octahedron()),
        ("torus 3×3", quad_torus(3, 3)),
        ("torus 3×5", quad_torus(3, 5)),
        ("open cube", without_face(cube(), 2)),
        ("very open cube", without_face(without_face(cube(), 4), 2)),
        ("cube with spur", cube_with_spur()),
        ("cube with tunnel", cube_with_tunnel()),
        ("open tunnel", without_face(cube_with_tunnel(), 7)),
        ("book of three", book(3)),
        ("Möbius strip", moebius_strip()),
        ("two tetrahedra", two_tetrahedra()),
        ("printed triangle", triangle()),
        ("hollow triangle", VertexList::from(&hollow_triangle())),
        ("segment", segment(&width).expect("it has a width")),
        ("house", house()),
    ]
}

/// The named meshes that winged edges can hold.
pub fn winged() -> Vec<(&'static str, VertexList)> {
    named().into_iter().filter(|(_, mesh)| WingedEdges::try_from(mesh).is_ok()).collect()
}

/// The closed manifolds among the named meshes, with or without holes in faces.
pub fn closed_manifolds() -> Vec<(&'static str, VertexList)> {
    let is_closed = |mesh: &VertexList| {
        EdgeList::try_from(mesh).is_ok_and(|list| !list.edges().is_empty() && list.uses().iter().all(|n| *n == [1, 1]))
    };
    winged().into_iter().filter(|(_, mesh)| is_closed(mesh)).collect()
}

/// Every set of triangles on four vertices, the two sides of a triangle being two; in the long form, on five vertices.
pub fn triangle_sets() -> impl Iterator<Item = VertexList> {
    let labels = if is_long() { 5 } else { 4 };
    let increasing = loops(labels, 3).into_iter().filter(|l| l.len() == 3 && l[0] < l[1] && l[1] < l[2]);
    let both: Vec<[u32; 3]> = increasing.flat_map(|l| [[l[0], l[1], l[2]], [l[0], l[2], l[1]]]).collect();
    (0..1u32 << both.len()).map(move |set| {
        let faces: Vec<[u32; 3]> = (0..both.len()).filter(|i| set >> i & 1 == 1).map(|i| both[i]).collect();
        mesh(&positions(labels), &faces)
    })
}

fn loop_strategy(vertices: u32) -> impl Strategy<Value = Vec<u32>> {
    prop::collection::vec(0..vertices, 0..6)
}

/// Any faces on a few vertices: repeated vertices, empty loops, edges of many uses, unused vertices.
pub fn soup() -> impl Strategy<Value = VertexList> {
    let face = (loop_strategy(6), prop::collection::vec(loop_strategy(6), 0..3))
        .prop_map(|(outer, holes)| Face { outer, holes });
    prop::collection::vec(face, 0..7).prop_map(|faces| VertexList { faces, ..mesh::<[u32; 0]>(&positions(6), &[]) })
}

/// A sound mesh with accidents that leave it one: faces away, all turned over, loops begun elsewhere, vertices
/// renumbered and, where they share no edge's end, glued, unused ones added.
pub fn accidents() -> impl Strategy<Value = VertexList> {
    let changes = (any::<u32>(), any::<bool>(), any::<u32>(), 0..1000u32, any::<[u32; 4]>());
    (prop::sample::select(winged()), changes).prop_map(|((_, mut mesh), (dropped, turned, start, renumber, glue))| {
        let mut bits = (0..).map(|i| dropped.rotate_left(i) & 7 == 0);
        mesh.faces.retain(|_| !bits.next().expect("there is no end"));
        for face in &mut mesh.faces {
            if turned {
                *face = face.reversed();
            }
            for l in std::iter::once(&mut face.outer).chain(&mut face.holes).filter(|l| !l.is_empty()) {
                let n = l.len();
                l.rotate_left(start as usize % n);
            }
        }
        mesh.vertices.push(point([9, 9, 9]));
        let n = mesh.vertices.len() as u32;
        let moved = |v: u32| (v + renumber) % n;
        let mut vertices = mesh.vertices.clone();
        for (v, position) in (0..n).zip(&mesh.vertices) {
            vertices[moved(v) as usize].clone_from(position);
        }
        mesh.vertices = vertices;
        on_vertices(&mut mesh, moved);
        let [a, b, ..] = glue.map(|v| v % n);
        let mut glued = mesh.clone();
        on_vertices(&mut glued, |v| if v == b { a } else { v });
        if WingedEdges::try_from(&glued).is_ok() { glued } else { mesh }
    })
}

fn on_vertices(mesh: &mut VertexList, f: impl Fn(u32) -> u32) {
    for face in &mut mesh.faces {
        std::iter::once(&mut face.outer).chain(&mut face.holes).flatten().for_each(|v| *v = f(*v));
    }
}
