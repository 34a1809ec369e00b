//! The numbers of a mesh and the surfaces it is, the latter two ways.

use isoracle::mesh::classify::{ClosedSurface, mesh_surfaces};
use isoracle::mesh::euler::EulerPoincare;
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::homology::ChainComplex;
use std::collections::BTreeMap;

pub fn count(faces: &[Face]) -> EulerPoincare {
    EulerPoincare::of(faces).expect("loops of three vertices or more")
}

/// V, E, F.
pub fn numbers(faces: &[Face]) -> [i64; 3] {
    let count = count(faces);
    [count.vertices, count.edges, count.faces]
}

/// H, C.
pub fn holes_and_shells(faces: &[Face]) -> [i64; 2] {
    let count = count(faces);
    [count.holes, count.shells]
}

/// The closed surfaces of a mesh; by homology, too, 2G = b₁ over ℤ/2 and C = b₀.
pub fn closed(faces: &[Face]) -> Vec<ClosedSurface> {
    let surfaces = mesh_surfaces(faces).expect("a surface");
    assert!(surfaces.iter().all(|s| s.boundary_loops == 0));
    let betti = ChainComplex::of_faces(faces).expect("loops").betti_mod_2();
    let count = count(faces);
    assert_eq!(betti[0] as i64, count.shells);
    assert_eq!(count.genus() * 2, betti[1]);
    surfaces.into_iter().map(|s| s.closed).collect()
}

pub fn torus() -> ClosedSurface {
    ClosedSurface::Orientable { genus: 1 }
}

/// How many faces each edge has.
pub fn faces_of_edges(faces: &[Face]) -> BTreeMap<[u32; 2], usize> {
    let mut uses = BTreeMap::new();
    faces.iter().flat_map(Face::sides).for_each(|side| *uses.entry(edge(side)).or_default() += 1);
    uses
}
