//! The check of large meshes against the plain one.

use isoracle::mesh::defects;
use isoracle::mesh::examples;
use isoracle::mesh::fast::{Polygons, check};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::binary::nearest_f64;
use proptest::prelude::*;

/// The mesh of binary64 positions in flat arrays.
pub fn flat(mesh: &VertexList) -> Polygons {
    let vertices = mesh.vertices.iter().map(|p| p.0.each_ref().map(nearest_f64)).collect();
    let mut corners = Vec::new();
    let ends = mesh.faces.iter().map(|face| {
        corners.extend(&face.outer);
        corners.len() as u32
    });
    let ends = ends.collect();
    Polygons::new(vertices, corners, ends).expect("a sound mesh")
}

/// A mesh of these positions and loops.
pub fn polygons(vertices: &[[f64; 3]], faces: &[Vec<u32>]) -> Polygons {
    let mut end = 0;
    let ends = faces.iter().map(|face| {
        end += face.len() as u32;
        end
    });
    Polygons::new(vertices.to_vec(), faces.concat(), ends.collect()).expect("a sound mesh")
}

/// The fast check says what the plain one says.
pub fn assert_as_plain(mesh: &Polygons) {
    let fast = check(mesh, |_| {});
    let plain = defects::check(&mesh.plain(), None);
    let found: Vec<_> = fast.defects.iter().map(|(category, elements)| (*category, elements.plain())).collect();
    let expected: Vec<_> = plain.defects.iter().map(|(category, elements)| (category, elements.clone())).collect();
    assert_eq!(found, expected, "{mesh:?}");
    assert_eq!(fast.counts, plain.counts, "{mesh:?}");
    assert!(fast.all_junctions);
}

#[test]
fn the_examples_are_sound() {
    for mesh in [examples::cube(), examples::tetrahedron()] {
        let mesh = flat(&mesh);
        assert_as_plain(&mesh);
        assert!(check(&mesh, |_| {}).defects.is_empty());
    }
}

/// Coordinates with many coincidences, small differences and large scales.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        12 => (-2..3_i32).prop_map(f64::from),
        2 => (-2..3_i32).prop_map(|n| f64::from(n).next_up()),
        1 => (-3..4_i32).prop_map(|n| f64::from(n) / 3.0),
        1 => prop::sample::select(vec![-0.0, 1e-300, 5e-324, 1e300, 0.1, 1.0 + 1e-9]),
        1 => prop::num::f64::NORMAL,
    ]
}

pub fn soup() -> impl Strategy<Value = Polygons> {
    let vertices = prop::collection::vec(prop::array::uniform3(coordinate()), 1..9);
    let faces = prop::collection::vec(prop::collection::vec(0..9_u32, 0..7), 0..9);
    (vertices, faces).prop_map(|(vertices, mut faces)| {
        // Mostly vertices that exist.
        let n = vertices.len() as u32;
        faces.iter_mut().flatten().for_each(|v| *v = if *v == 8 && n < 4 { n } else { *v % n });
        polygons(&vertices, &faces)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn polygon_soups_are_checked_as_by_the_plain_version(mesh in soup()) {
        assert_as_plain(&mesh);
    }
}
