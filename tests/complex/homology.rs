//! Homology by three cell structures, and what it must be.

use crate::every_gluing::{beside, named, one_tetrahedron, random_triangulation, small_complexes};
use crate::subdivided::subdivided;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::paired;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::Polyhedron;
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use isoracle::complex::triangulation_chain::ReversedEdge;
use isoracle::complex::triangulation_link::EdgePlace;
use isoracle::mesh::classify::ClosedSurface;
use isoracle::mesh::homology::{Homology, alternating_sum};
use isoracle::number::Integer;
use proptest::prelude::*;

fn over_z2(homology: &Homology) -> Vec<usize> {
    let even = |k: usize| homology.torsion[k].iter().filter(|t| t.is_even()).count();
    (0..4).map(|k| homology.betti[k] + even(k) + if k > 0 { even(k - 1) } else { 0 }).collect()
}

/// What H₀ … H₃ must be.
fn is_right(complex: &ClosedComplex, homology: &Homology) {
    let [b0, b1, b2, b3] = homology.betti[..] else { panic!("four groups") };
    let components = complex.barycentric().components();
    assert_eq!(b0, complex.component_count());
    assert_eq!(b3, components.orientable.iter().filter(|orientable| **orientable).count());
    let twos = vec![Integer::from(2); b0 - b3];
    assert_eq!([&homology.torsion[0], &homology.torsion[2], &homology.torsion[3]], [&vec![], &twos, &vec![]]);
    assert_eq!(alternating_sum(&homology.betti), complex.euler_characteristic());
    if Manifold3::of(complex.clone()).is_ok() {
        // Poincaré duality over ℤ in each orientable component, over ℤ/2 in all of them.
        assert_eq!(b1 + b3, b2 + b0);
        let mod_2 = over_z2(homology);
        assert_eq!([mod_2[0], mod_2[1]], [mod_2[3], mod_2[2]]);
    }
}

mod cx_65 {
    use super::*;

    #[test]
    fn the_chains_have_the_cells_of_the_skeleton() {
        for triangulation in one_tetrahedron() {
            match triangulation.chain_complex() {
                Ok(chains) => assert_eq!(chains.counts(), triangulation.skeleton().counts),
                Err(ReversedEdge { edge }) => assert_eq!(Some(&edge), triangulation.reversed_edges().first()),
            }
        }
    }

    #[test]
    fn an_edge_is_reversed_iff_its_ring_comes_back_turned() {
        let mut reversed = 0;
        for triangulation in one_tetrahedron() {
            let skeleton = triangulation.skeleton();
            let turned = |ring: Vec<EdgePlace>| {
                ring.iter().any(|p| ring.contains(&EdgePlace { tail: p.head, head: p.tail, ..*p }))
            };
            let by_rings: Vec<u32> = (0..skeleton.counts[1] as u32)
                .filter(|edge| {
                    let place = skeleton.edges[0].iter().position(|e| e == edge).expect("it is there");
                    let [tail, head] = isoracle::complex::triangulation::EDGES[place].map(|corner| corner as u8);
                    turned(triangulation.edge_ring(EdgePlace { tetrahedron: 0, tail, head }))
                })
                .collect();
            assert_eq!(triangulation.reversed_edges(), by_rings);
            reversed += usize::from(!by_rings.is_empty());
        }
        assert_eq!(reversed, 69);
    }

    #[test]
    fn the_boundary_of_the_four_simplex_is_a_sphere() {
        // Tetrahedron i has the vertices but i, in order; it meets tetrahedron j in the triangle without vertex j.
        let vertices = |i: usize| -> Vec<usize> { (0..5).filter(|v| *v != i).collect() };
        let gluing = |i: usize, corner: usize| {
            let j = vertices(i)[corner];
            let image =
                |v: usize| vertices(j).iter().position(|w| *w == if v == j { i } else { v }).expect("there") as u8;
            let corners = Perm4::new(std::array::from_fn(|k| image(vertices(i)[k]))).expect("a permutation");
            TriangleGluing { tetrahedron: j as u32, corners }
        };
        let sphere = Triangulation::new((0..5).map(|i| [0, 1, 2, 3].map(|k| gluing(i, k))).collect()).expect("closed");
        assert_eq!(sphere.skeleton().counts, [5, 10, 10, 5]);
        let homology = sphere.chain_complex().expect("no edge is reversed").homology();
        assert_eq!((homology.betti, homology.torsion.concat()), (vec![1, 0, 0, 1], vec![]));
        assert!(sphere.is_orientable());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn the_subdivision_has_the_same_homology(triangulation in random_triangulation(2)) {
            if let Ok(chains) = triangulation.chain_complex() {
                let fine = subdivided(&triangulation).chain_complex().expect("corners have ranks");
                prop_assert_eq!(chains.homology(), fine.homology());
                prop_assert_eq!(chains.betti_mod_2(), over_z2(&chains.homology()));
            } else {
                prop_assert!(subdivided(&triangulation).reversed_edges().is_empty());
            }
        }
    }
}

mod cx_66 {
    use super::*;

    fn agree(complex: &ClosedComplex, name: &str) -> Homology {
        let cells = complex.chain_complex().homology();
        for triangulation in [complex.tetrahedra(), complex.barycentric()] {
            assert_eq!(triangulation.chain_complex().expect("directed").homology(), cells, "{name}");
        }
        cells
    }

    #[test]
    fn three_cell_structures_agree_on_named_spaces() {
        for (name, complex) in named() {
            agree(&complex, name);
        }
    }

    #[test]
    fn three_cell_structures_agree_on_small_complexes() {
        let complexes = small_complexes(41);
        assert!(complexes.len() > 100);
        for complex in &complexes {
            agree(complex, &format!("{:?}", complex.scheme().pairings));
        }
        if crate::is_long() {
            // Of 108 + 7,680.
            assert_eq!(complexes.len(), 39 + 4473);
        }
    }
}

mod cx_67 {
    use super::*;

    #[test]
    fn ends_of_homology_are_components() {
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(23)) {
            is_right(&complex, &complex.chain_complex().homology());
        }
    }

    #[test]
    fn components_add() {
        let [torus, klein] = ["T³", "Klein bottle × S¹"].map(|name| {
            let (_, complex) = named().into_iter().find(|(n, _)| *n == name).expect("it is there");
            complex.tetrahedra()
        });
        let homology = beside(&torus, &klein).chain_complex().expect("directed").homology();
        assert_eq!(homology.betti, [2, 5, 4, 1]);
        let two = vec![Integer::from(2)];
        assert_eq!(homology.torsion, [vec![], two.clone(), two, vec![]]);
    }
}

mod cx_68 {
    use super::*;

    #[test]
    fn manifolds_are_dual_to_themselves() {
        let mut manifolds = [0, 0];
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(23)) {
            let Ok(manifold) = Manifold3::of(complex) else { continue };
            let homology = manifold.chain_complex().homology();
            assert_eq!(manifold.euler_characteristic(), 0);
            if manifold.is_orientable() {
                assert_eq!(homology.betti[1], homology.betti[2]);
                assert!(homology.torsion[2].is_empty());
            } else if manifold.component_count() == 1 {
                assert_eq!(homology.betti[1], homology.betti[2] + 1);
                assert_eq!(homology.torsion[2], [Integer::from(2)]);
            }
            let mod_2 = manifold.chain_complex().betti_mod_2();
            assert_eq!([mod_2[0], mod_2[1]], [mod_2[3], mod_2[2]]);
            manifolds[usize::from(manifold.is_orientable())] += 1;
        }
        assert!(manifolds.iter().all(|n| *n > 3), "{manifolds:?}");
    }

    #[test]
    fn it_fails_with_a_klein_bottle_around_a_vertex() {
        let scheme = paired(Polyhedron::tetrahedron(), &[(0, 1, 2, 1), (2, 3, 0, 1)]);
        let gieseking = ClosedComplex::new(scheme).expect("no edge is reversed");
        assert_eq!(gieseking.vertex_links(), [ClosedSurface::NonOrientable { crosscaps: 2 }]);
        let chains = gieseking.chain_complex();
        assert_eq!((chains.homology().betti, chains.betti_mod_2()), (vec![1, 0, 0, 0], vec![1, 0, 1, 1]));
        assert_eq!(gieseking.euler_characteristic(), 1);
    }

    #[test]
    fn it_fails_where_a_link_is_no_sphere() {
        let odd = small_complexes(23).into_iter().filter(|complex| Manifold3::of(complex.clone()).is_err());
        let unequal = |complex: &ClosedComplex| {
            let homology = complex.chain_complex().homology();
            complex.is_orientable() && homology.betti[1] != homology.betti[2]
        };
        assert!(odd.filter(unequal).count() > 0);
    }
}
