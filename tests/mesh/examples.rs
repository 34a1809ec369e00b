//! The example meshes are what their names say.

use isoracle::mesh::examples::{cube, tetrahedron};
use isoracle::mesh::face::edge;
use std::collections::BTreeSet;

#[test]
fn the_cube_and_the_tetrahedron_have_their_numbers() {
    for (mesh, v, e, f) in [(cube(), 8, 12, 6), (tetrahedron(), 4, 6, 4)] {
        let sides: Vec<[u32; 2]> = mesh.faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).collect();
        let edges: BTreeSet<[u32; 2]> = sides.iter().map(|side| edge(*side)).collect();
        assert_eq!([mesh.vertices.len(), edges.len(), mesh.faces.len()], [v, e, f]);
        assert!(sides.iter().all(|[a, b]| sides.contains(&[*b, *a])));
    }
}
