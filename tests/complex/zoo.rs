//! The zoo: what the literature says of each specimen, against its scheme.

use super::naive_scheme::{found, is_ball};
use isoracle::complex::examples::lens_space;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::scheme::{GluingScheme, Pairing, Polyhedron, SignedEdge};
use isoracle::complex::zoo::{Specimen, get, names, of_triangulation};
use std::collections::BTreeSet;

fn all() -> impl Iterator<Item = (Specimen, Manifold3)> {
    names().into_iter().map(|name| {
        let specimen = get(name).expect("a name leads to a specimen");
        let manifold = Manifold3::new(specimen.scheme.clone()).unwrap_or_else(|defects| panic!("{name}: {defects:?}"));
        (specimen, manifold)
    })
}

fn manifold(name: &str) -> Manifold3 {
    Manifold3::new(get(name).expect("a specimen").scheme).expect("the zoo holds manifolds")
}

mod cx_8 {
    use super::*;

    #[test]
    fn every_specimen_is_what_is_said_of_it() {
        for (specimen, manifold) in all() {
            let name = specimen.name;
            assert_eq!(manifold.counts(), specimen.cells, "{name}");
            assert_eq!(manifold.is_orientable(), specimen.orientable, "{name}");
            assert_eq!(manifold.first_homology(), specimen.h1, "{name}");
            assert_eq!(manifold.euler_characteristic(), 0, "{name}");
        }
    }

    #[test]
    fn the_second_derivation_says_the_same() {
        for (specimen, manifold) in all() {
            let (name, found) = (specimen.name, found(&specimen.scheme));
            assert!(specimen.scheme.polyhedra.iter().all(is_ball), "{name}");
            assert!(found.is_manifold(), "{name}");
            assert_eq!(
                (found.cells, found.orientable, found.h1),
                (specimen.cells, specimen.orientable, specimen.h1),
                "{name}"
            );
            assert_eq!(found.components, manifold.component_count(), "{name}");
        }
    }

    #[test]
    fn duality_holds() {
        for (specimen, manifold) in all() {
            let (name, components) = (specimen.name, manifold.component_count());
            let homology = manifold.chain_complex().homology();
            let mod_2 = manifold.chain_complex().betti_mod_2();
            assert_eq!((mod_2[0], mod_2[1]), (mod_2[3], mod_2[2]), "{name}");
            if specimen.orientable {
                assert_eq!((homology.betti[1], homology.betti[3]), (homology.betti[2], components), "{name}");
                assert!(homology.torsion[2].is_empty(), "{name}");
            } else if components == 1 {
                // H₂ of one that is not orientable has the torsion ℤ/2.
                assert_eq!(homology.torsion[2].len(), 1, "{name}");
                assert_eq!(homology.torsion[2][0], 2, "{name}");
                assert_eq!(homology.betti[3], 0, "{name}");
            }
        }
    }

    #[test]
    fn the_ten_flat_manifolds_differ_in_homology_and_orientation() {
        let flat = ["T3", "G2", "G3", "G4", "G5", "G6", "B1", "B2", "B3", "B4"].map(manifold);
        let kinds: BTreeSet<_> = flat.iter().map(|m| (m.is_orientable(), m.first_homology())).collect();
        assert_eq!(kinds.len(), 10);
    }

    #[test]
    fn regular_polytopes_have_their_numbers() {
        // Vertices, edges, faces, facets (Coxeter, table I).
        let known = [
            ("S3-4-simplex", [5, 10, 10, 5], 3),
            ("S3-16-cell", [8, 24, 32, 16], 4),
            ("S3-tesseract", [16, 32, 24, 8], 3),
            ("S3-24-cell", [24, 96, 96, 24], 3),
        ];
        for (name, cells, around_edges) in known {
            let manifold = manifold(name);
            assert_eq!(manifold.counts(), cells);
            assert!(manifold.edge_ring_sizes().iter().all(|size| *size == around_edges), "{name}");
        }
    }

    #[test]
    fn spaces_with_the_same_cells_are_told_apart_by_the_turn() {
        let rings = |name: &str| {
            let mut sizes = manifold(name).edge_ring_sizes();
            sizes.dedup();
            sizes
        };
        // Three dodecahedra around each edge are spherical, five hyperbolic, two make RP³.
        assert_eq!(["Poincare", "Seifert-Weber", "RP3-dodecahedron"].map(rings), [[3], [5], [2]]);
        assert_eq!(["T3", "RP3", "quaternion-space", "tetrahedral-space"].map(rings), [[4], [2], [3], [3]]);
    }

    #[test]
    fn names_are_told_once() {
        let names = names();
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
        assert!(names.len() >= 60 && get("t3").is_none());
    }
}

mod cx_14 {
    use super::*;

    fn gcd(a: u32, b: u32) -> u32 {
        if b == 0 { a } else { gcd(b, a % b) }
    }

    /// The scheme with each edge in n parts.
    fn with_edges_in_parts(scheme: &GluingScheme, n: u32) -> GluingScheme {
        let parts = |side: &SignedEdge| -> Vec<SignedEdge> {
            let first = (side.0.abs() - 1) * n as i32 + 1;
            let along = (first..first + n as i32).map(|edge| SignedEdge(edge * side.0.signum()));
            if side.is_forward() { along.collect() } else { along.rev().collect() }
        };
        let polyhedron = |p: &Polyhedron| {
            let vertices = p.edges.len() as u32;
            // Part k of edge e begins at the new vertex V + (n − 1)e + k − 1, the first at the tail.
            let edges = p.edges.iter().zip(0..).flat_map(|([tail, head], e)| {
                let inner = move |k: u32| vertices + (n - 1) * e + k - 1;
                (0..n).map(move |k| {
                    [if k == 0 { *tail } else { inner(k) }, if k == n - 1 { *head } else { inner(k + 1) }]
                })
            });
            Polyhedron {
                edges: edges.collect(),
                faces: p.faces.iter().map(|f| f.iter().flat_map(parts).collect()).collect(),
            }
        };
        let pairing = |p: &Pairing| Pairing { shift: p.shift * i64::from(n), ..*p };
        GluingScheme {
            polyhedra: scheme.polyhedra.iter().map(polyhedron).collect(),
            pairings: scheme.pairings.iter().map(pairing).collect(),
        }
    }

    #[test]
    fn a_turn_by_q_of_p_is_that_of_the_reduced_fraction_with_divided_edges() {
        for p in 1..=14_u32 {
            for q in 0..p {
                let d = gcd(p, q);
                let lens = Manifold3::new(lens_space(p, q)).expect("a manifold");
                let divided = Manifold3::new(with_edges_in_parts(&lens_space(p / d, q / d), d)).expect("a manifold");
                assert_eq!(lens.flags(), divided.flags(), "{p}, {q}");
                assert_eq!(lens.counts(), [d as usize, d as usize, 1, 1]);
                let h1 = lens.first_homology();
                let order: Vec<u32> = h1.torsion.iter().map(|t| t.to_u32().expect("small")).collect();
                assert_eq!((h1.rank, order), (0, [p / d].into_iter().filter(|n| *n > 1).collect()), "{p}, {q}");
            }
        }
    }

    #[test]
    fn a_turn_by_more_than_all_is_one_by_less() {
        let flags = |q| Manifold3::new(lens_space(7, q)).expect("a manifold").flags().clone();
        assert_eq!(flags(3), flags(10));
        assert_ne!(flags(3), flags(4));
    }
}

#[test]
fn triangulations_are_schemes_of_tetrahedra() {
    for name in ["T3", "RP3", "KxS1", "Poincare", "S3-zipped"] {
        let whole = manifold(name);
        for triangulation in [whole.tetrahedra(), whole.barycentric()] {
            let again = Manifold3::new(of_triangulation(&triangulation)).expect("the same space");
            assert_eq!(again.counts(), triangulation.skeleton().counts, "{name}");
            assert_eq!(again.first_homology(), whole.first_homology(), "{name}");
            assert_eq!(again.is_orientable(), whole.is_orientable(), "{name}");
        }
    }
}
