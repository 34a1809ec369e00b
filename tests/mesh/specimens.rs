//! Meshes, sound and broken, that show what a criterion sees and what it does not.

use isoracle::linear::Vector;
use isoracle::mesh::examples::{cube, mesh, tetrahedron};
use isoracle::mesh::face::Face;
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::number::Rational;

/// p/q.
pub fn number(fraction: [i64; 2]) -> Rational {
    Rational::from((fraction[0], fraction[1]))
}

/// The point with these fractions as coordinates.
pub fn rational(coordinates: [[i64; 2]; 3]) -> Point {
    Vector(coordinates.map(number))
}

/// All of them, with their names.
pub fn all() -> Vec<(&'static str, VertexList)> {
    vec![
        ("cube", cube()),
        ("tetrahedron", tetrahedron()),
        ("torus", torus()),
        ("moebius band", moebius_band()),
        ("projective plane", projective_plane()),
        ("box with tunnel", box_with_tunnel()),
        ("box with pocket", box_with_pocket()),
        ("box with keyholes", box_with_keyholes()),
        ("tetrahedra with wall", tetrahedra_with_wall()),
        ("cubes at edge", cubes_at_edge()),
        ("tetrahedra at vertex", tetrahedra_at_vertex()),
        ("cube with vertex in edge", cube_with_vertex_in_edge()),
        ("prism on equal bow-tie", bow_tie_prism(1)),
        ("prism on unequal bow-tie", bow_tie_prism(2)),
        ("prisms at vertex of common base", prisms_on_figure_eight()),
        ("bipyramid", bipyramid([0, 0, 2])),
        ("bipyramid pinched", pinched_bipyramid()),
        ("bipyramid with vertex in edge", bipyramid_with_vertex_in_edge()),
        ("bipyramid with faces through each other", crossing_bipyramid()),
        ("tetrahedron with flat face", tetrahedron_with_flat_face()),
        ("lamina", lamina()),
    ]
}

/// A torus of 7 vertices and 14 triangles (Möbius, Császár), its vertices in general position on the moment curve:
/// combinatorially sound; its triangles cut each other.
pub fn torus() -> VertexList {
    let vertices: Vec<[i64; 3]> = (0..7).map(|t: i64| [t, t * t, t * t * t]).collect();
    let faces: Vec<[u32; 3]> =
        (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
    mesh(&vertices, &faces)
}

/// Five triangles around a band with a half twist.
pub fn moebius_band() -> VertexList {
    let vertices: Vec<[i64; 3]> = (0..5).map(|t: i64| [t, t * t, t * t * t]).collect();
    mesh(&vertices, &[[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 0, 4], [4, 0, 1]])
}

/// The projective plane of 6 vertices and 10 triangles, on the moment curve.
pub fn projective_plane() -> VertexList {
    let vertices: Vec<[i64; 3]> = (0..6).map(|t: i64| [t, t * t, t * t * t]).collect();
    let faces =
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1], [1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];
    mesh(&vertices, &faces)
}

/// The corners of a square prism: counterclockwise at height `bottom`, then at `top`.
fn square_prism(low: i64, high: i64, bottom: i64, top: i64) -> Vec<[i64; 3]> {
    let square = [[low, low], [high, low], [high, high], [low, high]];
    [bottom, top].iter().flat_map(|z| square.map(|[x, y]| [x, y, *z])).collect()
}

/// The walls of the first prism of two from outside, and those of the second from inside.
fn walls_and_inner() -> [Vec<Vec<u32>>; 2] {
    let next = |i: u32| (i + 1) % 4;
    let walls = (0..4).map(|i| vec![i, next(i), next(i) + 4, i + 4]).collect();
    [walls, (0..4).map(|i| vec![next(i) + 8, i + 8, i + 12, next(i) + 12]).collect()]
}

/// The box [0, 3]³ with the tunnel [1, 2]² through it, along z: 16 vertices, 24 edges, 10 faces, two of them with a hole.
pub fn box_with_tunnel() -> VertexList {
    let vertices = [square_prism(0, 3, 0, 3), square_prism(1, 2, 0, 3)].concat();
    let [walls, inner] = walls_and_inner();
    let loops: Vec<Vec<u32>> = [vec![0, 3, 2, 1], vec![4, 5, 6, 7]].into_iter().chain(walls).chain(inner).collect();
    let mut all = mesh(&vertices, &loops);
    all.faces[0].holes = vec![vec![8, 9, 10, 11]];
    all.faces[1].holes = vec![vec![12, 15, 14, 13]];
    all
}

/// The box [0, 3]³ with the pocket [1, 2]³ sunk from the top: no edge goes from the pocket's to the box's.
pub fn box_with_pocket() -> VertexList {
    let vertices = [square_prism(0, 3, 0, 2), square_prism(1, 2, 1, 2)].concat();
    let [walls, inner] = walls_and_inner();
    let ends = [vec![0, 3, 2, 1], vec![4, 5, 6, 7], vec![8, 9, 10, 11]];
    let loops: Vec<Vec<u32>> = ends.into_iter().chain(walls).chain(inner).collect();
    let mut all = mesh(&vertices, &loops);
    all.faces[1].holes = vec![vec![12, 15, 14, 13]];
    all
}

/// The box with the tunnel, its two faces with a hole each written as one loop that goes to the hole and back.
pub fn box_with_keyholes() -> VertexList {
    let mut all = box_with_tunnel();
    all.faces[0] = Face::new([0, 3, 2, 1, 0, 8, 9, 10, 11, 8]);
    all.faces[1] = Face::new([4, 5, 6, 7, 4, 12, 15, 14, 13, 12]);
    all
}

/// Two tetrahedra on a common triangle, which stays as a wall inside: its edges have three uses.
pub fn tetrahedra_with_wall() -> VertexList {
    let vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]];
    mesh(&vertices, &[[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4], [0, 1, 2]])
}

/// The cubes [0, 1]³ and [1, 2]² × [0, 1], with their common edge: 14 vertices, 23 edges, 12 squares.
pub fn cubes_at_edge() -> VertexList {
    let mut all = cube();
    let map = |v: u32| match v {
        0 => 2,
        4 => 6,
        v if v < 4 => v + 7,
        v => v + 6,
    };
    let moved: Vec<Point> = cube().vertices.iter().map(|v| v.clone() + &rational([[1, 1], [1, 1], [0, 1]])).collect();
    for v in [1, 2, 3, 5, 6, 7] {
        all.vertices.push(moved[v].clone());
    }
    all.faces
        .extend(cube().faces.into_iter().map(|face| Face::new(face.outer.into_iter().map(map).collect::<Vec<_>>())));
    all
}

/// Two tetrahedra with one common vertex.
pub fn tetrahedra_at_vertex() -> VertexList {
    let vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [0, 4, 5], [0, 6, 4], [4, 6, 5], [0, 5, 6]];
    mesh(&vertices, &faces)
}

/// The cube, its edge [0, 1] divided in the bottom alone.
pub fn cube_with_vertex_in_edge() -> VertexList {
    let mut all = cube();
    all.vertices.push(rational([[1, 2], [0, 1], [0, 1]]));
    all.faces[0] = Face::new([0, 3, 2, 1, 8]);
    all
}

/// The prism on a bow-tie of two triangles with heights 1 and `height` over equal angles.
pub fn bow_tie_prism(height: i64) -> VertexList {
    let base = [[-1, -1], [height, height], [height, -height], [-1, 1]];
    let vertices: Vec<[i64; 3]> = [0, 1].iter().flat_map(|z| base.map(|[x, y]| [x, y, *z])).collect();
    let walls = (0..4).map(|i| {
        let j = (i + 1) % 4;
        vec![j, i, i + 4, j + 4]
    });
    let loops: Vec<Vec<u32>> = [vec![0, 1, 2, 3], vec![7, 6, 5, 4]].into_iter().chain(walls).collect();
    mesh(&vertices, &loops)
}

/// Two oblique prisms with one common vertex, their bases in one polygon that visits it twice.
pub fn prisms_on_figure_eight() -> VertexList {
    let vertices = [
        [0, 0, 0],
        [2, -1, 0],
        [2, 1, 0],
        [-2, 1, 0],
        [-2, -1, 0],
        [1, 0, 1],
        [3, -1, 1],
        [3, 1, 1],
        [-1, 0, 1],
        [-3, 1, 1],
        [-3, -1, 1],
    ];
    let loops: Vec<Vec<u32>> = vec![
        vec![0, 2, 1, 0, 4, 3],
        vec![5, 6, 7],
        vec![0, 1, 6, 5],
        vec![1, 2, 7, 6],
        vec![2, 0, 5, 7],
        vec![8, 9, 10],
        vec![0, 3, 9, 8],
        vec![3, 4, 10, 9],
        vec![4, 0, 8, 10],
    ];
    mesh(&vertices, &loops)
}

/// A bipyramid over a hexagon in z = 0, its lower apex (0, 0, −2): 8 vertices, 12 triangles.
pub fn bipyramid(upper: [i64; 3]) -> VertexList {
    let vertices = [[4, 0, 0], [2, 4, 0], [-2, 4, 0], [-4, 0, 0], [-2, -4, 0], [2, -4, 0], upper, [0, 0, -2]];
    let faces: Vec<[u32; 3]> = (0..6)
        .flat_map(|i| {
            let j = (i + 1) % 6;
            [[i, j, 6], [j, i, 7]]
        })
        .collect();
    mesh(&vertices, &faces)
}

/// The bipyramid, one corner of its hexagon at the position of the opposite one.
pub fn pinched_bipyramid() -> VertexList {
    let mut all = bipyramid([0, 0, 2]);
    all.vertices[0] = rational([[-1, 1], [0, 1], [0, 1]]);
    all.vertices[3] = all.vertices[0].clone();
    all
}

/// The bipyramid, one corner of its hexagon moved into the opposite side.
pub fn bipyramid_with_vertex_in_edge() -> VertexList {
    let mut all = bipyramid([0, 0, 2]);
    all.vertices[3] = rational([[3, 1], [2, 1], [0, 1]]);
    all
}

/// The bipyramid with its upper apex moved through a lower face.
pub fn crossing_bipyramid() -> VertexList {
    let mut all = bipyramid([12, 0, -1]);
    all.vertices[7] = rational([[0, 1], [0, 1], [-7, 1]]);
    all
}

/// A tetrahedron, its edge [0, 1] divided on one side by vertex 4, the triangle 0 1 4 between: all on one line.
pub fn tetrahedron_with_flat_face() -> VertexList {
    let vertices = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]];
    mesh(&vertices, &[[0, 2, 4], [4, 2, 1], [0, 4, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
}

/// A triangle and its back.
pub fn lamina() -> VertexList {
    mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[[0, 1, 2], [0, 2, 1]])
}
