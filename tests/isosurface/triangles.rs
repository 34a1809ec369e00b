//! Marching triangles: chapter 5.c claim by claim.

use crate::domain::*;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::multilinear::{LinearZero, linear_zero};
use isoracle::isosurface::polyline::{Raster, squares};
use isoracle::isosurface::triangle::{TriangleCase, case, triangles};
use isoracle::number::Rational;
use rayon::prelude::*;
use std::collections::BTreeMap;

fn patterns() -> impl Iterator<Item = [bool; 3]> {
    (0..8).map(|bits| [0, 1, 2].map(|i| bits >> i & 1 == 1))
}

mod is_51 {
    use super::*;

    #[test]
    fn no_edge_is_crossed_or_two_are() {
        let mut counts = BTreeMap::new();
        for positive in patterns() {
            let crossed: Vec<[usize; 2]> =
                [[0, 1], [0, 2], [1, 2]].into_iter().filter(|[a, b]| positive[*a] != positive[*b]).collect();
            *counts.entry(crossed.len()).or_insert(0) += 1;
            let found = match case(positive) {
                TriangleCase::Uncut => Vec::new(),
                TriangleCase::Segment(ends) => {
                    let mut ends = ends.map(|[a, b]| [a.min(b), a.max(b)]).to_vec();
                    ends.sort();
                    ends
                }
            };
            assert_eq!(found, crossed, "{positive:?}");
        }
        assert_eq!(counts, BTreeMap::from([(0, 2), (2, 6)]));
    }
}

mod is_52 {
    use super::*;

    #[test]
    fn a_triangle_has_at_most_two_vertices_and_one_way_to_join_them() {
        for g in all::<3>(&[-2, -1, 1, 2]).collect::<Vec<_>>() {
            let zeros = [[0, 1], [0, 2], [1, 2]]
                .into_iter()
                .filter(|[a, b]| linear_zero(&rationals(&[g[*a], g[*b]])) != LinearZero::None)
                .count();
            // Two ends of one segment, whatever the magnitudes.
            let ends = if case(g.map(|v| v > 0)) == TriangleCase::Uncut { 0 } else { 2 };
            assert_eq!(zeros, ends, "{g:?}");
        }
    }

    #[test]
    fn with_null_values_an_edge_may_have_infinitely_many() {
        assert_eq!(linear_zero(&rationals(&[0, 0])), LinearZero::Everywhere);
        let raster = Raster::new([2, 2], rationals(&[0, 0, 1, 1]).to_vec()).expect("a raster");
        assert!(triangles(&raster, &Rational::new(), Tie::Degenerate).is_err());
    }
}

mod is_53 {
    use super::*;

    /// How many curves cut the square, and whether they cut off the corners (0,0) and (1,1), by squares and by triangles.
    fn separates_main(values: [i64; 4]) -> [bool; 2] {
        let raster = Raster::new([2, 2], rationals(&values).to_vec()).expect("a raster");
        let zero = Rational::new();
        let by_squares = squares(&raster, &zero, Tie::Degenerate).expect("not degenerate");
        let by_triangles = triangles(&raster, &zero, Tie::Degenerate).expect("not degenerate");
        // The diagonal from (0,0) to (1,1) is crossed iff the two are apart; by triangles never, if their signs agree.
        let side = |p: &[Rational; 2]| p[0].cmp(&p[1]);
        [by_squares, by_triangles].map(|polyline| {
            polyline.segments.iter().any(|s| {
                let [a, b] = s.map(|v| &polyline.vertices[v as usize]);
                let crosses_diagonal = side(a) != side(b);
                crosses_diagonal || side(a).is_eq()
            })
        })
    }

    #[test]
    fn the_diagonals_own_pair_is_joined_whatever_the_values() {
        // Diagonal 00–11 joins + in (1,−2,−2,1), where the determinant, −3, joins −.
        assert_eq!(separates_main([1, -2, -2, 1]), [true, false]);
        // The mirror image stands for the diagonal 10–01: it joins − in (2,−1,−1,2), where the determinant, 3, joins +.
        assert_eq!(separates_main([-1, 2, 2, -1]), [true, false]);
        assert_eq!(separates_main([2, -1, -1, 2]), [false, false]);
        for g in all::<4>(&[-3, -2, -1, 1, 2, 3]).collect::<Vec<_>>() {
            let is_ambiguous = g[0] * g[3] > 0 && g[1] * g[2] > 0 && g[0] * g[1] < 0;
            let determinant = g[0] * g[3] - g[1] * g[2];
            if is_ambiguous && determinant != 0 {
                assert_eq!(separates_main(g), [determinant < 0, false], "{g:?}");
            }
        }
    }
}
