//! The example meshes are what their names say.

use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::mesh::examples::laminae::{hollow_triangle, house, house_prism, laminae, segment, triangle};
use isoracle::mesh::examples::solids::{
    block_with_cavity, block_with_pit, block_with_through_holes, block_with_two_pits, crossing_tunnels, cube_with_loop,
    cubes_on_an_edge, divided_cube, frame, hexagonal_prism, pierced_block, pierced_block_with_two_in_one_face,
    solids_at_two_points,
};
use isoracle::mesh::examples::{cube, tetrahedron};
use isoracle::mesh::face::{Face, edge, sides};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::Rational;
use std::collections::BTreeSet;

/// Six times the signed volume, by tetrahedra from the origin over a fan of each loop.
fn six_volumes(mesh: &VertexList) -> Rational {
    let at = |v: u32| mesh.vertices[v as usize].clone();
    let of_loop = |l: &[u32]| -> Rational {
        let fan = |i: usize| determinant3(&Matrix::from_columns(&[at(l[0]), at(l[i]), at(l[i + 1])]));
        (1..l.len() - 1).map(fan).sum()
    };
    mesh.faces.iter().flat_map(|f| f.loops().map(of_loop).collect::<Vec<_>>()).sum()
}

fn is_planar(mesh: &VertexList, face: &Face) -> bool {
    let at = |v: u32| &mesh.vertices[v as usize];
    let area = |l: &[u32]| sides(l).map(|[a, b]| at(a).cross(at(b))).fold(Vector::zero(), |sum, n| sum + &n);
    let normal: Vector<Rational, 3> = area(&face.outer);
    normal != Vector::zero()
        && face.vertices().all(|v| normal.dot(&(at(v).clone() - at(face.outer[0]))).is_zero())
        && face.holes.iter().all(|hole| normal.dot(&area(hole)) < 0)
}

/// Planar faces, holes turned against them, each edge run along as often one way as the other; and the volume.
fn assert_sound(mesh: &VertexList, volume: (i64, i64)) {
    assert!(mesh.faces.iter().all(|face| is_planar(mesh, face)));
    let all: Vec<[u32; 2]> = mesh.faces.iter().flat_map(|f| f.sides().collect::<Vec<_>>()).collect();
    let uses = |side: [u32; 2]| all.iter().filter(|other| **other == side).count();
    assert!(all.iter().all(|[a, b]| uses([*a, *b]) == uses([*b, *a])));
    assert_eq!(six_volumes(mesh), Rational::from(volume) * 6);
    assert!(mesh.faces.iter().flat_map(Face::vertices).all(|v| (v as usize) < mesh.vertices.len()));
    let different: BTreeSet<_> = mesh.vertices.iter().map(|v| v.0.clone()).collect();
    assert_eq!(different.len(), mesh.vertices.len());
}

#[test]
fn the_cube_and_the_tetrahedron_have_their_numbers() {
    for (mesh, v, e, f) in [(cube(), 8, 12, 6), (tetrahedron(), 4, 6, 4)] {
        let sides: Vec<[u32; 2]> = mesh.faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).collect();
        let edges: BTreeSet<[u32; 2]> = sides.iter().map(|side| edge(*side)).collect();
        assert_eq!([mesh.vertices.len(), edges.len(), mesh.faces.len()], [v, e, f]);
        assert!(sides.iter().all(|[a, b]| sides.contains(&[*b, *a])));
    }
}

#[test]
fn solids_are_bounded_by_planar_faces_turned_outwards() {
    assert_sound(&cube(), (1, 1));
    assert_sound(&tetrahedron(), (1, 6));
    assert_sound(&divided_cube(), (8, 1));
    assert_sound(&hexagonal_prism(), (36, 1));
    assert_sound(&pierced_block(), (75 - 3 - 1, 1));
    assert_sound(&pierced_block_with_two_in_one_face(), (75 - 3 - 1, 1));
    assert_sound(&block_with_pit(), (26, 1));
    assert_sound(&block_with_two_pits(), (43, 1));
    assert_sound(&block_with_cavity(), (26, 1));
    assert_sound(&cube_with_loop(), (27, 1));
    assert_sound(&frame(), (8, 1));
    assert_sound(&crossing_tunnels(), (22, 1));
    assert_sound(&cubes_on_an_edge(), (2, 1));
    assert_sound(&house_prism(), (8, 1));
    for g in 0..4 {
        assert_sound(&block_with_through_holes(g), (2 * (3 * (2 * g + 1) - g), 1));
    }
    // Over each triangle of area 2 two tetrahedra of height 2 on both sides: 2 · 2 · (2 · 2/3).
    assert_sound(&solids_at_two_points(), (16, 3));
}

#[test]
fn laminae_have_no_volume() {
    for mesh in laminae().iter().chain([&triangle(), &segment(), &hollow_triangle(), &house()]) {
        assert_sound(mesh, (0, 1));
    }
}
