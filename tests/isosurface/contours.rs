//! Contours of whole rasters by marching squares: chapter 5.c claim by claim.

use crate::domain::*;
use crate::squares::{VALUES, at_zero, determinant_of, is_ambiguous};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::multilinear::bilinear;
use isoracle::isosurface::polyline::{Polyline, Raster, squares};
use isoracle::isosurface::square::DegenerateSquare;
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn raster(shape: [usize; 2], values: &[i64]) -> Raster {
    Raster::new(shape, values.iter().map(|v| Rational::from(*v)).collect()).expect("a raster")
}

fn curve(shape: [usize; 2], values: &[i64]) -> Polyline {
    squares(&raster(shape, values), &Rational::new(), Tie::Degenerate).expect("not degenerate")
}

/// Closed and open curves of a polyline; panics where it is no curve.
fn curves(polyline: &Polyline, shape: [usize; 2]) -> [usize; 2] {
    let mut next = BTreeMap::new();
    let mut ends: BTreeSet<u32> = BTreeSet::new();
    for [from, to] in &polyline.segments {
        assert!(next.insert(*from, *to).is_none(), "two segments start at one vertex");
        assert!(ends.insert(*to), "two segments end at one vertex");
    }
    let mut count = [0, 0];
    for start in next.keys().copied().filter(|v| !ends.contains(v)).collect::<Vec<_>>() {
        count[1] += 1;
        let mut at = start;
        let on_border = |v: u32| {
            (0..2).any(|i| {
                let x = &polyline.vertices[v as usize][i];
                *x == 0 || *x == shape[i] as i64 - 1
            })
        };
        assert!(on_border(at));
        while let Some(to) = next.remove(&at) {
            at = to;
        }
        assert!(on_border(at));
    }
    while let Some((start, mut at)) = next.pop_first() {
        count[0] += 1;
        while at != start {
            at = next.remove(&at).expect("what does not start at the border is closed");
        }
    }
    count
}

mod is_45 {
    use super::*;

    #[test]
    fn the_same_signs_make_one_curve_or_two() {
        let with = |scale: i64, a: i64| {
            let mut values = [scale; 16];
            (values[5], values[10]) = (-a, -a);
            values
        };
        // a = 2 and a = 1/2, the latter times 2.
        assert_eq!(curves(&curve([4, 4], &with(1, 2)), [4, 4]), [1, 0]);
        assert_eq!(curves(&curve([4, 4], &with(2, 1)), [4, 4]), [2, 0]);
        assert_eq!([determinant_of(&[-2, 1, 1, -2]), determinant_of(&[-1, 2, 2, -1])], [3, -3]);
    }
}

mod is_46 {
    use super::*;

    proptest! {
        #[test]
        fn a_contour_is_an_embedded_curve_that_ends_on_the_border_alone(
            nx in 2usize..6, ny in 2usize..6, values in prop::collection::vec(prop::sample::select(&VALUES[..]), 25)
        ) {
            let shape = [nx, ny];
            // Both choices in ambiguous squares: of the values, and, where the saddle is at 0, of the tie rule.
            for factor in [1, -1] {
                let values: Vec<i64> = values[..nx * ny].iter().map(|v| v * factor).collect();
                let polyline = squares(&raster(shape, &values), &Rational::new(), Tie::Below).expect("ties are broken");
                curves(&polyline, shape);
                let crossed = polyline.vertices.iter().collect::<BTreeSet<_>>().len();
                prop_assert_eq!(crossed, polyline.vertices.len(), "no two vertices in one point");
            }
        }
    }

    #[test]
    fn the_two_segments_of_a_square_do_not_meet() {
        for g in all::<4>(&VALUES).filter(is_ambiguous).collect::<Vec<_>>() {
            let Ok(contour) = at_zero(&g) else { continue };
            // Each lies on its own side of a diagonal's parallel: u + v < 1 and > 1, or u − v < 0 and > 0.
            let joins_main = contour.determinant_sign == Sign::Positive;
            let heights = contour.segments.iter().map(|segment| {
                let heights = segment.map(|edge| {
                    let crossing = contour.crossings.iter().find(|c| c.edge == edge).expect("it ends at a crossing");
                    let [u, v] = crossing.position();
                    if joins_main { u - v } else { u + v - Rational::from(1) }
                });
                heights.map(|h| Sign::of(h.cmp0()))
            });
            let mut signs: Vec<_> = heights.collect();
            signs.sort();
            assert_eq!(signs, [[Sign::Negative; 2], [Sign::Positive; 2]], "{g:?}");
        }
    }
}

mod is_48 {
    use super::*;

    #[test]
    fn a_plane_through_samples_has_a_curve() {
        let values: Vec<i64> = (0..9).map(|i| i % 3 + i / 3 - 2).collect();
        let raster = raster([3, 3], &values);
        let error = squares(&raster, &Rational::new(), Tie::Degenerate).expect_err("g = 0 at three points");
        assert!(matches!(error.degenerate, DegenerateSquare::Corner(_)));
        let polyline = squares(&raster, &Rational::new(), Tie::Below).expect("ties are broken");
        assert_eq!(curves(&polyline, [3, 3]), [0, 1]);
        let points: BTreeSet<_> = polyline.vertices.iter().cloned().collect();
        assert_eq!(points, BTreeSet::from([[2, 0], [1, 1], [0, 2]].map(|p| p.map(Rational::from))));
    }
}

mod is_49 {
    use super::*;

    #[test]
    fn four_branches_meet_in_a_null_sample_and_the_tie_rule_parts_them() {
        let values: Vec<i64> = (0..9).map(|i| (i % 3 - 1) * (i / 3 - 1)).collect();
        // f = (x − 1)(y − 1): zero on both lines through (1, 1).
        for n in 0..=4 {
            let g = [1, 0, 0, 0];
            assert_eq!(bilinear(&rationals(&g), &[q(1, 1), q(n, 4)]), 0);
            assert_eq!(bilinear(&rationals(&g), &[q(n, 4), q(1, 1)]), 0);
        }
        let raster = raster([3, 3], &values);
        assert!(squares(&raster, &Rational::new(), Tie::Degenerate).is_err());
        let polyline = squares(&raster, &Rational::new(), Tie::Below).expect("ties are broken");
        assert_eq!(curves(&polyline, [3, 3]), [0, 2]);
    }
}

mod is_50 {
    use super::*;

    #[test]
    fn the_polygon_bends_one_way_and_the_spline_through_its_vertices_the_other() {
        let y = [q(19, 24), q(2, 3), q(1, 8), q(2, 3)];
        let moments = [q(1, 4), q(-5, 4), q(9, 4), q(-5, 4)];
        // The periodic cubic spline: M_{i−1} + 4M_i + M_{i+1} = 6Δ²y_i.
        let second = |i: usize| Rational::from(&y[(i + 3) % 4] + &y[(i + 1) % 4]) - Rational::from(&y[i] * 2);
        for i in 0..4 {
            let sum = Rational::from(&moments[(i + 3) % 4] + &moments[(i + 1) % 4]) + Rational::from(&moments[i] * 4);
            assert_eq!(sum, second(i) * Rational::from(6));
        }
        assert_eq!((second(0), &moments[0]), (q(-1, 4), &q(1, 4)));
        // The contour of g[i, j] = j − y_i is that polygon, and no square is ambiguous.
        let shape = [9, 2];
        let values = (0..18).map(|k| Rational::from(k / 9) - &y[k % 9 % 4]).collect();
        let raster = Raster::new(shape, values).expect("a raster");
        let polyline = squares(&raster, &Rational::new(), Tie::Degenerate).expect("not degenerate");
        assert_eq!(curves(&polyline, shape), [0, 1]);
        for i in 0..9usize {
            assert!(polyline.vertices.contains(&[Rational::from(i), y[i % 4].clone()]));
        }
    }
}
