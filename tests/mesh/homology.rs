//! Homology: integers against ℤ/2, cells against triangulations, known complexes.

use crate::domain::{cyclic_complexes, every_gluing, small_gluing, triangles};
use isoracle::mesh::examples::surfaces::{
    annulus, ball, cone, double_torus, dunce_hat, klein_bottle, moebius_band, projective_plane, sphere, suspension,
    three_torus,
};
use isoracle::mesh::homology::{Chain, ChainComplex, Homology, NoCycle, alternating_sum, elementary_divisors};
use isoracle::mesh::simplicial::SimplicialComplex;
use isoracle::number::Integer;
use proptest::prelude::*;

/// Betti numbers over ℤ/2 by those over ℤ and the torsion (universal coefficients).
fn over_z2(homology: &Homology) -> Vec<usize> {
    let even = |k: usize| homology.torsion[k].iter().filter(|t| t.is_even()).count();
    (0..homology.betti.len()).map(|k| homology.betti[k] + even(k) + if k > 0 { even(k - 1) } else { 0 }).collect()
}

fn assert_consistent(chains: &ChainComplex) -> Homology {
    let homology = chains.homology();
    assert_eq!(chains.betti_mod_2(), over_z2(&homology));
    assert_eq!(chains.euler_characteristic(), alternating_sum(&homology.betti));
    assert_eq!(homology.betti.first().copied().unwrap_or(0), chains.component_count());
    homology
}

fn determinant(m: &[Vec<i64>]) -> i64 {
    match m.len() {
        0 => 1,
        n => (0..n)
            .map(|j| {
                let minor: Vec<Vec<i64>> = m[1..].iter().map(|row| [&row[..j], &row[j + 1..]].concat()).collect();
                (if j % 2 == 0 { 1 } else { -1 }) * m[0][j] * determinant(&minor)
            })
            .sum(),
    }
}

/// The greatest common divisor of all minors of that size.
fn minors(m: &[Vec<i64>], size: usize) -> Integer {
    let columns = m.first().map_or(0, Vec::len);
    let chosen = |n: usize| (0u32..1 << n).filter(move |s| s.count_ones() as usize == size);
    let mut gcd = Integer::new();
    for rows in chosen(m.len()) {
        for cols in chosen(columns) {
            let row = |i: usize| (0..columns).filter(|j| cols >> j & 1 == 1).map(|j| m[i][j]).collect();
            let minor: Vec<Vec<i64>> = (0..m.len()).filter(|i| rows >> i & 1 == 1).map(row).collect();
            gcd.gcd_mut(&Integer::from(determinant(&minor)));
        }
    }
    gcd
}

mod me_101 {
    use super::*;

    #[test]
    fn known_spaces_have_their_homology() {
        let none = Vec::new;
        let two = || vec![Integer::from(2)];
        let known: [(SimplicialComplex, &[usize], Vec<Integer>); 12] = [
            (sphere(1), &[1, 1], none()),
            (sphere(2), &[1, 0, 1], none()),
            (sphere(3), &[1, 0, 0, 1], none()),
            (ball(3), &[1, 0, 0, 0], none()),
            (SimplicialComplex::torus(), &[1, 2, 1], none()),
            (klein_bottle(), &[1, 1, 0], two()),
            (projective_plane(), &[1, 0, 0], two()),
            (moebius_band(), &[1, 1, 0], none()),
            (annulus(), &[1, 1, 0], none()),
            (double_torus(), &[1, 4, 1], none()),
            (dunce_hat(), &[1, 0, 0], none()),
            (three_torus(3), &[1, 3, 3, 1], none()),
        ];
        for (complex, betti, torsion) in known {
            let homology = assert_consistent(&ChainComplex::of_complex(&complex));
            assert_eq!(homology.betti, betti);
            // None but in H₁.
            assert_eq!(homology.torsion.concat(), torsion);
            assert_eq!(homology.torsion[1], torsion);
        }
    }

    #[test]
    fn a_suspension_moves_homology_up_and_a_cone_kills_it() {
        for complex in [SimplicialComplex::torus(), projective_plane(), klein_bottle(), sphere(1), dunce_hat()] {
            let below = ChainComplex::of_complex(&complex).homology();
            let above = ChainComplex::of_complex(&suspension(&complex)).homology();
            assert_eq!(above.betti[0], 1);
            // Reduced, H_{k+1} of the suspension is H_k.
            assert_eq!(above.betti[1] + 1, below.betti[0]);
            assert_eq!(above.betti[2..], below.betti[1..]);
            assert_eq!(above.torsion[1..], below.torsion[..]);
            let over = ChainComplex::of_complex(&cone(&complex)).homology();
            assert_eq!(over.betti.iter().sum::<usize>(), 1);
            assert!(over.torsion.iter().all(Vec::is_empty));
        }
    }

    #[test]
    fn cells_and_a_triangulation_of_them_have_one_homology() {
        let check = |gluing: isoracle::mesh::gluing::Gluing| {
            let cells = assert_consistent(&ChainComplex::of_gluing(&gluing));
            let triangulated = gluing.triangulated();
            assert_eq!(gluing.euler_characteristic(), triangulated.euler_characteristic());
            assert_eq!(cells, ChainComplex::of_complex(&triangulated).homology());
            let faces = ChainComplex::of_faces(&triangles(&triangulated)).expect("triangles");
            assert_eq!(cells, faces.homology());
        };
        for sizes in [&[1usize][..], &[2], &[3], &[1, 1], &[2, 1], &[4]] {
            every_gluing(sizes, true, check);
        }
    }

    #[test]
    fn every_cyclic_complex_is_consistent() {
        for complex in cyclic_complexes(7, 2).iter().chain(&cyclic_complexes(7, 3)) {
            assert_consistent(&ChainComplex::of_complex(complex));
        }
    }

    #[test]
    fn boundaries_that_are_no_cycles_are_refused() {
        let vertices = vec![Chain::new(); 3];
        let edge = |a, b| Chain::from([(a, -1), (b, 1)]);
        let edges = vec![edge(0, 1), edge(1, 2), edge(2, 0)];
        let face = |signs: [i64; 3]| vec![(0..3).zip(signs).collect::<Chain>()];
        let complex = |signs| ChainComplex::new(vec![vertices.clone(), edges.clone(), face(signs)]);
        assert!(complex([1, 1, 1]).is_ok());
        assert_eq!(complex([0, 0, 0]).expect("a sphere and a circle").homology().betti, [1, 1, 1]);
        assert_eq!(complex([1, 1, -1]), Err(NoCycle { dimension: 2, cell: 0 }));
        assert_eq!(
            ChainComplex::new(vec![vertices.clone(), vec![edge(0, 1), edge(1, 3)]]),
            Err(NoCycle { dimension: 1, cell: 1 })
        );
        assert_eq!(ChainComplex::new(vec![vec![edge(0, 1)]]), Err(NoCycle { dimension: 0, cell: 0 }));
        assert_eq!(ChainComplex::new(vec![]).expect("nothing").homology().betti, [0usize; 0]);
    }

    fn matrix() -> impl Strategy<Value = Vec<Vec<i64>>> {
        (1usize..5, 1usize..5).prop_flat_map(|(rows, columns)| {
            prop::collection::vec(prop::collection::vec(prop_oneof![Just(0), -6i64..7], columns), rows)
        })
    }

    proptest! {
        // The product of the first k divisors is the greatest common divisor of the minors of size k.
        #[test]
        fn divisors_are_those_of_the_minors(m in matrix()) {
            let rows: Vec<Chain> = m.iter().map(|row| (0..).zip(row.iter().copied()).collect()).collect();
            let divisors = elementary_divisors(&rows);
            let mut product = Integer::from(1);
            for (k, divisor) in divisors.iter().enumerate() {
                product *= divisor;
                prop_assert_eq!(&product, &minors(&m, k + 1));
                prop_assert!(*divisor > 0);
                prop_assert!(k == 0 || divisor.is_divisible(&divisors[k - 1]));
            }
            prop_assert_eq!(minors(&m, divisors.len() + 1), 0);
        }

        #[test]
        fn random_gluings_are_consistent(gluing in small_gluing()) {
            let cells = assert_consistent(&ChainComplex::of_gluing(&gluing));
            prop_assert_eq!(cells, ChainComplex::of_complex(&gluing.triangulated()).homology());
        }
    }
}
