//! Maps to circles, and what is turned about them.

use super::domain::{cross_polytope, grid_torus, simplex_boundary, subdivided, twice};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::realise::circles::{Cocycle, cocycles, turned};
use isoracle::complex::realise::intersections::intersections;
use isoracle::complex::realise::mesh::TetrahedralMesh;
use isoracle::complex::realise::points::Points;
use isoracle::complex::realise::{Options, realise};
use isoracle::mesh::homology::{Chain, elementary_divisors};
use isoracle::number::Integer;
use std::collections::BTreeMap;

mod cx_92 {
    use super::*;

    fn sum_around(mesh: &TetrahedralMesh, cocycle: &Cocycle, walk: &[u32]) -> Integer {
        let numbers: BTreeMap<[u32; 2], usize> = mesh.edges().iter().copied().zip(0..).collect();
        let along = |v: u32, w: u32| match numbers.get(&[v, w]) {
            Some(edge) => cocycle[*edge].clone(),
            None => -cocycle[numbers[&[w, v]]].clone(),
        };
        walk.iter().zip(walk.iter().cycle().skip(1)).fold(Integer::new(), |sum, (v, w)| sum + along(*v, *w))
    }

    /// They are a basis of H¹ iff they are closed and, with the coboundaries of vertices, span a direct summand of that rank.
    fn assert_basis(mesh: &TetrahedralMesh, betti: usize) {
        let found = cocycles(mesh);
        assert_eq!(found.len(), betti);
        for (cocycle, triangle) in found.iter().flat_map(|c| mesh.triangles().iter().map(move |t| (c, t))) {
            assert_eq!(sum_around(mesh, cocycle, triangle), 0);
        }
        let mut rows: Vec<Chain> = vec![Chain::new(); mesh.vertices()];
        for (edge, [v, w]) in mesh.edges().iter().enumerate() {
            rows[*v as usize].insert(edge, -1);
            rows[*w as usize].insert(edge, 1);
        }
        let row = |cocycle: &Cocycle| {
            cocycle.iter().map(|n| n.to_i64().expect("small")).enumerate().filter(|(_, n)| *n != 0).collect()
        };
        rows.extend(found.iter().map(row));
        let divisors = elementary_divisors(&rows);
        assert_eq!(divisors.len(), mesh.vertices() - 1 + betti);
        assert!(divisors.iter().all(|d| *d == 1), "a multiple of a class, not the class");
    }

    #[test]
    fn they_are_a_basis_of_the_first_cohomology() {
        for (mesh, betti) in [
            (simplex_boundary(), 0),
            (cross_polytope(), 0),
            (grid_torus([3, 3, 3]), 3),
            (grid_torus([3, 4, 3]), 3),
            (twice(lens_space(2, 1)), 0),
            (twice(lens_space(5, 2)), 0),
        ] {
            assert_basis(&mesh, betti);
        }
        // H₁ = ℤ ⊕ ℤ/2 and the like: the gluing without a twist in one direction.
        let lens = ClosedComplex::new(lens_space(3, 0)).expect("a closed complex");
        let betti = lens.chain_complex().homology().betti[1];
        assert_basis(&subdivided(&lens.barycentric()), betti);
    }

    #[test]
    fn the_torus_starts_and_ends_without_meeting_itself() {
        let mesh = grid_torus([5, 5, 5]);
        let start = turned(&mesh, 4, 1).expect("three circles");
        assert!(intersections(&mesh, &Points::new(4, start).expect("finite")).is_embedded());
        let options = Options { iterations: 30, ..Options::default() };
        let ended = realise(&mesh, &options).expect("a placement");
        assert!(ended.intersections.is_embedded());
        assert!(ended.energies.windows(2).all(|pair| pair[1] < pair[0]));
        let free = realise(&mesh, &Options { keep_embedded: false, ..options }).expect("a placement");
        assert!(free.energies.len() >= ended.energies.len() && free.energies.starts_with(&ended.energies));
    }

    #[test]
    fn without_free_homology_nothing_is_turned() {
        assert_eq!(turned(&simplex_boundary(), 4, 1), None);
        assert_eq!(turned(&twice(lens_space(3, 1)), 4, 1), None);
        let torus = twice(three_torus());
        assert!(turned(&torus, 4, 1).is_some_and(|x| x.len() == 4 * torus.vertices()));
        assert!(turned(&torus, 3, 1).is_some_and(|x| x.len() == 3 * torus.vertices()));
        assert!(turned(&torus, 5, 1).is_some_and(|x| x.len() == 5 * torus.vertices()));
    }
}
