//! Schemes, flags, cells and tetrahedra of the first examples.

use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::manifold::Manifold3;
use isoracle::number::Integer;

#[test]
fn the_three_torus_has_one_vertex_and_twelve_pairs() {
    let torus = Manifold3::new(three_torus()).expect("a manifold");
    assert_eq!(torus.counts(), [1, 3, 3, 1]);
    assert_eq!(torus.facet_edge_pairs(), 12);
    assert_eq!(torus.edge_ring_sizes(), [4, 4, 4]);
    assert!(torus.is_orientable());
    let homology = torus.chain_complex().homology();
    assert_eq!(homology.betti, [1, 3, 3, 1]);
    assert!(homology.torsion.iter().all(Vec::is_empty));
    assert_eq!(torus.tetrahedra().skeleton().counts, [2, 14, 24, 12]);
    assert_eq!(torus.barycentric().skeleton().counts, [8, 56, 96, 48]);
}

#[test]
fn a_lens_space_has_cyclic_homology() {
    for (p, q) in [(1, 0), (2, 1), (3, 1), (5, 2), (7, 3), (12, 5)] {
        let lens = Manifold3::new(lens_space(p, q)).unwrap_or_else(|defects| panic!("L({p}, {q}): {defects:?}"));
        let homology = lens.chain_complex().homology();
        let torsion: Vec<Integer> = [p].into_iter().filter(|p| *p > 1).map(Integer::from).collect();
        assert_eq!((homology.betti, &homology.torsion[1]), (vec![1, 0, 0, 1], &torsion), "L({p}, {q})");
    }
}
