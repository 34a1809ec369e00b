//! Contours of squares, triangles and whole grids.

use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::multilinear::{bilinear, bilinear_gradient};
use isoracle::isosurface::polyline::{Polyline, Raster, RasterError, squares};
use isoracle::isosurface::square::{DegenerateSquare, SquareContour, SquareCorner, SquareEdge, contour};
use isoracle::isosurface::triangle::{TriangleCase, case, triangles};
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;
use std::collections::BTreeMap;

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn rationals<const N: usize>(values: [i64; N]) -> [Rational; N] {
    values.map(Rational::from)
}

/// Every vector of N integers from lo to hi.
fn all<const N: usize>(lo: i64, hi: i64) -> impl Iterator<Item = [i64; N]> {
    let base = (hi - lo + 1) as usize;
    (0..base.pow(N as u32)).map(move |code| std::array::from_fn(|i| lo + (code / base.pow(i as u32) % base) as i64))
}

fn edges(segment: [SquareEdge; 2]) -> [[usize; 2]; 2] {
    segment.map(|e| e.corners().map(SquareCorner::index))
}

/// Twice the signed area of a, b, p: positive iff p is on the left of a → b.
fn left(a: &[Rational; 2], b: &[Rational; 2], p: &[Rational; 2]) -> Sign {
    let d = |p: &[Rational; 2], i: usize| Rational::from(&p[i] - &a[i]);
    Sign::of((d(b, 0) * d(p, 1) - d(b, 1) * d(p, 0)).cmp0())
}

mod one_square {
    use super::*;

    fn position(contour: &SquareContour, edge: SquareEdge) -> [Rational; 2] {
        contour.crossings.iter().find(|c| c.edge == edge).expect("a segment ends at a crossing").position()
    }

    /// Which corners lie in one component of the square cut along the contour: joined iff no segment separates
    /// them as a straight chord.
    fn joined_by_segments(contour: &SquareContour, a: usize, b: usize) -> bool {
        contour.segments.iter().all(|[from, to]| {
            let (from, to) = (position(contour, *from), position(contour, *to));
            let side = |c: usize| left(&from, &to, &SquareCorner::ALL[c].position().map(Rational::from));
            side(a) == side(b)
        })
    }

    /// Which corners a grid of (n+1)² samples connects, through samples on one side of c = 0 next to each other.
    fn joined_by_sampling(g: &[i64; 4], n: i64) -> impl Fn(usize, usize) -> bool + use<> {
        // n² times f at (i/n, j/n), in integers.
        let f = |i: i64, j: i64| (n - i) * (n - j) * g[0] + i * (n - j) * g[1] + (n - i) * j * g[2] + i * j * g[3];
        let side = (n + 1) as usize;
        let mut label = vec![usize::MAX; side * side];
        for start in 0..side * side {
            if label[start] != usize::MAX {
                continue;
            }
            let mut stack = vec![start];
            label[start] = start;
            while let Some(at) = stack.pop() {
                let (i, j) = (at % side, at / side);
                let here = f(i as i64, j as i64).signum();
                let mut visit = |i: usize, j: usize| {
                    let next = i + side * j;
                    if label[next] == usize::MAX && f(i as i64, j as i64).signum() == here {
                        label[next] = start;
                        stack.push(next);
                    }
                };
                if i > 0 {
                    visit(i - 1, j)
                }
                if j > 0 {
                    visit(i, j - 1)
                }
                if i + 1 < side {
                    visit(i + 1, j)
                }
                if j + 1 < side {
                    visit(i, j + 1)
                }
            }
        }
        let corners = [label[0], label[side - 1], label[side * (side - 1)], label[side * side - 1]];
        move |a, b| corners[a] == corners[b]
    }

    #[test]
    fn the_segments_join_the_corners_that_a_fine_sampling_joins() {
        let mut ambiguous = 0;
        for g in all::<4>(-3, 3) {
            let Ok(contour) = contour(&rationals(g), &Rational::new(), Tie::Degenerate) else { continue };
            ambiguous += usize::from(contour.segments.len() == 2);
            // A step changes one coordinate, f is linear along it: sampling never joins what is separate. And it
            // joins what is joined: |saddle| ≥ 1/12 and |f_uv| ≤ 12, so that f has one sign on the whole line of
            // samples nearest to the saddle, at most 1/180 from it.
            let sampled = joined_by_sampling(&g, 90);
            for a in 0..4 {
                for b in 0..a {
                    if g[a].signum() == g[b].signum() {
                        assert_eq!(joined_by_segments(&contour, a, b), sampled(a, b), "{g:?}: {a}, {b}");
                    }
                }
            }
        }
        assert!(ambiguous > 100);
    }

    #[test]
    fn the_saddle_decides_an_ambiguous_square() {
        for g in all::<4>(-3, 3) {
            for twice_c in -7..=7 {
                let (values, c) = (rationals(g), q(twice_c, 2));
                let Ok(contour) = contour(&values, &c, Tie::Degenerate) else { continue };
                if contour.segments.len() < 2 {
                    continue;
                }
                let saddle = contour.saddle.as_ref().expect("an ambiguous square has a saddle");
                let at = [saddle.u.clone(), saddle.v.clone()];
                assert_eq!(bilinear(&values, &at), saddle.value);
                assert_eq!(bilinear_gradient(&values, &at), [0, 0]);
                // The saddle lies in the region that is joined.
                let positive = usize::from(values[1] > c);
                let joined = if saddle.value > c { positive } else { 1 - positive };
                assert!(joined_by_segments(&contour, joined, 3 - joined), "{g:?} at {c}");
                assert!(!joined_by_segments(&contour, 1 - joined, 2 + joined), "{g:?} at {c}");
            }
        }
    }

    #[test]
    fn f_equals_c_at_crossings_and_exceeds_it_on_the_left_of_every_segment() {
        for g in all::<4>(-3, 3) {
            let values = rationals(g);
            let Ok(contour) = contour(&values, &q(1, 17), Tie::Degenerate) else {
                panic!("a saddle is a fraction of f_uv ≤ 12")
            };
            for crossing in &contour.crossings {
                assert_eq!(bilinear(&values, &crossing.position()), q(1, 17));
                assert!(crossing.t > 0 && crossing.t < 1);
            }
            for [from, to] in &contour.segments {
                let ends = [position(&contour, *from), position(&contour, *to)];
                for (edge, end) in [(from, 0), (to, 1)] {
                    for corner in edge.corners() {
                        let side = left(&ends[0], &ends[1], &corner.position().map(Rational::from));
                        let above = Sign::of(values[corner.index()].cmp(&q(1, 17)));
                        assert_eq!(side, above, "{g:?}: end {end}");
                    }
                }
            }
            // Exercise 5.13: 0, 2 or 4 vertices; each is an end of one segment.
            let mut ends: Vec<_> = contour.segments.iter().flatten().copied().collect();
            ends.sort();
            assert_eq!(ends, contour.crossings.iter().map(|c| c.edge).collect::<Vec<_>>());
            assert!([0, 2, 4].contains(&ends.len()));
        }
    }

    #[test]
    fn two_known_squares() {
        let contour = |g: [i64; 4]| contour(&rationals(g), &Rational::new(), Tie::Degenerate);
        let lone = contour([1, -1, -3, -1]).expect("no tie");
        assert_eq!(lone.segments.iter().map(|s| edges(*s)).collect::<Vec<_>>(), [[[0, 1], [0, 2]]]);
        assert_eq!(lone.crossings.iter().map(|c| c.t.clone()).collect::<Vec<_>>(), [q(1, 2), q(1, 4)]);
        assert_eq!((lone.determinant_sign, &lone.saddle.expect("f_uv = 4").value), (Sign::Negative, &q(-1, 1)));
        let two = contour([2, -1, -1, 1]).expect("no tie");
        assert_eq!(two.determinant_sign, Sign::Positive);
        assert_eq!(two.segments.iter().map(|s| edges(*s)).collect::<Vec<_>>(), [[[0, 1], [1, 3]], [[2, 3], [0, 2]]]);
        assert_eq!(contour([1, 2, 3, 4]).expect("no tie").saddle, None);
    }

    #[test]
    fn a_square_is_degenerate_iff_a_corner_or_the_saddle_of_an_ambiguous_one_is_at_the_level() {
        for g in all::<4>(-2, 2) {
            let sign = |i: usize| g[i].signum();
            let ambiguous = sign(0) == sign(3) && sign(1) == sign(2) && sign(0) == -sign(1);
            let critical = ambiguous && g[0] * g[3] == g[1] * g[2];
            match contour(&rationals(g), &Rational::new(), Tie::Degenerate) {
                Ok(_) => assert!(!g.contains(&0) && !critical, "{g:?}"),
                Err(DegenerateSquare::Corner(c)) => assert_eq!(g[c.index()], 0, "{g:?}"),
                Err(DegenerateSquare::Saddle { u, v }) => {
                    assert!(critical, "{g:?}");
                    assert_eq!(bilinear(&rationals(g), &[u, v]), 0, "{g:?}");
                }
            }
        }
    }

    #[test]
    fn a_broken_tie_is_the_contour_just_below() {
        // Critical values of a square with values in −2…2 are fractions of f_uv, |f_uv| ≤ 8: nothing happens
        // between −1/100 and 0.
        for g in all::<4>(-2, 2) {
            let values = rationals(g);
            let limit = contour(&values, &Rational::new(), Tie::Below).expect("ties are broken");
            let below = contour(&values, &q(-1, 100), Tie::Degenerate).expect("−1/100 is no critical value");
            assert_eq!(limit.segments, below.segments, "{g:?}");
            assert_eq!(limit.determinant_sign, below.determinant_sign, "{g:?}");
            assert_eq!(limit.crossings.len(), below.crossings.len());
            for (limit, below) in limit.crossings.iter().zip(&below.crossings) {
                assert_eq!(limit.edge, below.edge);
                // |dt/dc| = 1/|g₁ − g₀| ≤ 1.
                assert!(Rational::from(&limit.t - &below.t).abs() <= q(1, 100), "{g:?}");
            }
            assert_eq!(limit.saddle, below.saddle);
        }
    }

    #[test]
    fn a_tie_that_is_none_changes_nothing() {
        for g in all::<4>(-2, 2) {
            let c = q(1, 7);
            let [strict, below] = [Tie::Degenerate, Tie::Below].map(|tie| contour(&rationals(g), &c, tie));
            assert_eq!(strict, below);
        }
    }
}

mod grids {
    use super::*;

    fn raster(shape: [usize; 2], values: &[i64]) -> Raster {
        Raster::new(shape, values.iter().map(|v| Rational::from(*v)).collect()).expect("a raster")
    }

    /// Each vertex starts and ends at most one segment, and does both unless it lies on the border.
    fn assert_manifold(polyline: &Polyline, shape: [usize; 2]) {
        let mut degree = vec![[0, 0]; polyline.vertices.len()];
        for segment in &polyline.segments {
            for (i, v) in segment.iter().enumerate() {
                degree[*v as usize][i] += 1;
            }
        }
        for (degree, position) in degree.iter().zip(&polyline.vertices) {
            let on_border = (0..2).any(|i| position[i] == 0 || position[i] == shape[i] as i64 - 1);
            assert!(degree.iter().all(|d| *d <= 1), "{degree:?} at {position:?}");
            assert_eq!(degree.iter().sum::<i32>(), if on_border { 1 } else { 2 }, "{degree:?} at {position:?}");
        }
    }

    /// b₀ of the polyline by union–find, and how many of its components are closed: V − E counts the open ones.
    fn components(polyline: &Polyline) -> (usize, usize) {
        let mut label: Vec<usize> = (0..polyline.vertices.len()).collect();
        fn find(label: &[usize], mut i: usize) -> usize {
            while label[i] != i {
                i = label[i];
            }
            i
        }
        for [a, b] in &polyline.segments {
            let (a, b) = (find(&label, *a as usize), find(&label, *b as usize));
            label[a] = b;
        }
        let count = (0..label.len()).filter(|&i| label[i] == i).count();
        (count, count - (polyline.vertices.len() - polyline.segments.len()))
    }

    proptest! {
        #[test]
        fn a_contour_of_a_random_grid_is_a_curve(
            nx in 2usize..7, ny in 2usize..7, values in proptest::collection::vec(-9i64..=9, 49)
        ) {
            let raster = raster([nx, ny], &values[..nx * ny]);
            let c = q(1, 2);
            // A saddle at 1/2 happens: then the contour is no curve, and the square is named.
            match squares(&raster, &c, Tie::Degenerate) {
                Ok(polyline) => assert_manifold(&polyline, [nx, ny]),
                Err(error) => {
                    let at_saddle = matches!(error.degenerate, DegenerateSquare::Saddle { .. });
                    prop_assert!(at_saddle);
                }
            }
            assert_manifold(&triangles(&raster, &c, Tie::Degenerate).expect("no sample is 1/2"), [nx, ny]);
        }

        #[test]
        fn the_same_crossings_on_grid_edges_by_squares_and_by_triangles(
            nx in 2usize..6, ny in 2usize..6, values in proptest::collection::vec(-9i64..=9, 36)
        ) {
            let raster = raster([nx, ny], &values[..nx * ny]);
            let on_grid = |polyline: Polyline| {
                let mut on: Vec<_> = polyline.vertices.into_iter()
                    .filter(|p| p.iter().any(|x| x.is_integer())).collect();
                on.sort();
                on
            };
            let c = q(1, 3);
            let squares = squares(&raster, &c, Tie::Below).expect("ties are broken");
            let triangles = triangles(&raster, &c, Tie::Below).expect("ties are broken");
            prop_assert_eq!(on_grid(squares), on_grid(triangles));
        }
    }

    #[test]
    fn broken_ties_leave_a_curve_by_vertex_numbers_whatever_ties_there_are() {
        for g in all::<9>(-1, 1) {
            let raster = raster([3, 3], &g);
            for polyline in [
                squares(&raster, &Rational::new(), Tie::Below).expect("ties are broken"),
                triangles(&raster, &Rational::new(), Tie::Below).expect("ties are broken"),
            ] {
                let mut degree = vec![[0, 0]; polyline.vertices.len()];
                for segment in &polyline.segments {
                    for (i, v) in segment.iter().enumerate() {
                        degree[*v as usize][i] += 1;
                    }
                }
                assert!(degree.iter().flatten().all(|d| *d <= 1), "{g:?}");
                // As many crossed edges as there are vertices; each end on the border is on a border edge, and
                // the border is crossed an even number of times.
                let open = degree.iter().filter(|d| d.contains(&0)).count();
                let border = [0, 1, 2, 5, 8, 7, 6, 3];
                let changes = (0..8).filter(|&i| (g[border[i]] < 0) != (g[border[(i + 1) % 8]] < 0)).count();
                assert_eq!(open, changes, "{g:?}");
            }
        }
    }

    #[test]
    fn a_tie_is_named() {
        let raster = raster([3, 2], &[1, 2, 3, 4, 0, 6]);
        let error = squares(&raster, &Rational::new(), Tie::Degenerate).expect_err("a tie");
        assert_eq!(error.to_string(), "square [0, 0]: the value at corner 3 equals the isovalue");
        let error = triangles(&raster, &Rational::new(), Tie::Degenerate).expect_err("a tie");
        assert_eq!(error.to_string(), "the sample at [1, 1] equals the isovalue");
    }

    #[test]
    fn an_ambiguous_square_is_decided_by_its_data_in_squares_and_by_its_diagonal_in_triangles() {
        // Two negative samples, diagonal neighbours across one ambiguous square.
        let joined = raster([4, 4], &[1, 1, 1, 1, 1, -3, 1, 1, 1, 1, -3, 1, 1, 1, 1, 1]);
        let apart = raster([4, 4], &[3, 3, 3, 3, 3, -1, 3, 3, 3, 3, -1, 3, 3, 3, 3, 3]);
        let zero = Rational::new();
        let count = |raster: &Raster| {
            [
                components(&squares(raster, &zero, Tie::Degenerate).expect("no tie")),
                components(&triangles(raster, &zero, Tie::Degenerate).expect("no tie")),
            ]
        };
        assert_eq!(count(&joined), [(1, 1), (1, 1)]);
        assert_eq!(count(&apart), [(2, 2), (1, 1)]);
        // The other diagonal: triangles never join it.
        let turned = raster([4, 4], &[1, 1, 1, 1, 1, 1, -3, 1, 1, -3, 1, 1, 1, 1, 1, 1]);
        assert_eq!(count(&turned), [(1, 1), (2, 2)]);
    }

    #[test]
    fn each_region_of_negative_samples_in_a_positive_frame_has_one_closed_curve() {
        // Four samples in a frame of positive ones: the negative samples make one region, or two if they are a
        // diagonal pair that the determinant separates; each region has one closed curve around it.
        for g in all::<4>(-2, 2) {
            if g.contains(&0) {
                continue;
            }
            let mut values = [1i64; 16];
            for (k, v) in [5, 6, 9, 10].into_iter().zip(g) {
                values[k] = v;
            }
            let Ok(polyline) = squares(&raster([4, 4], &values), &Rational::new(), Tie::Degenerate) else {
                continue;
            };
            let (count, closed) = components(&polyline);
            assert_eq!(count, closed);
            let negative: Vec<usize> = (0..4).filter(|&i| g[i] < 0).collect();
            let expected = match negative.as_slice() {
                [] => 0,
                [0, 3] | [1, 2] => {
                    let determinant = g[0] * g[3] - g[1] * g[2];
                    let negative_joined = (determinant > 0) == (negative == [0, 3]);
                    if negative_joined { 1 } else { 2 }
                }
                _ => 1,
            };
            assert_eq!(count, expected, "{g:?}");
        }
    }

    #[test]
    fn numbers_are_a_raster_iff_there_are_two_along_each_axis_and_as_many_as_the_shape_asks_for() {
        let new = |shape, n| Raster::new(shape, vec![Rational::new(); n]);
        assert_eq!(new([1, 4], 4), Err(RasterError::TooThin { axis: 0, samples: 1 }));
        assert_eq!(new([2, 0], 0), Err(RasterError::TooThin { axis: 1, samples: 0 }));
        assert_eq!(new([2, 2], 5), Err(RasterError::WrongCount { expected: 4, found: 5 }));
        assert_eq!(new([usize::MAX, 2], 5), Err(RasterError::TooLarge([usize::MAX, 2])));
        assert!(new([2, 2], 4).is_ok());
    }
}

mod one_triangle {
    use super::*;

    #[test]
    fn of_the_8_patterns_of_signs_2_cut_no_edge_and_6_cut_two() {
        let mut count = BTreeMap::new();
        for bits in 0..8 {
            let positive = [0, 1, 2].map(|i| bits >> i & 1 == 1);
            let crossed: Vec<_> =
                [[0, 1], [1, 2], [0, 2]].into_iter().filter(|[a, b]| positive[*a] != positive[*b]).collect();
            *count.entry(crossed.len()).or_insert(0) += 1;
            match case(positive) {
                TriangleCase::Uncut => assert!(crossed.is_empty()),
                TriangleCase::Segment(ends) => {
                    let sorted = |mut e: [usize; 2]| {
                        e.sort();
                        e
                    };
                    let mut ends_sorted = ends.map(sorted).to_vec();
                    ends_sorted.sort();
                    let mut crossed = crossed.clone();
                    crossed.sort();
                    assert_eq!(ends_sorted, crossed);
                    // f > c on the left, in the triangle (0,0), (2,0), (0,2).
                    let corners = [[0, 0], [2, 0], [0, 2]].map(|p: [i64; 2]| p.map(Rational::from));
                    let middle =
                        |[a, b]: [usize; 2]| [0, 1].map(|i| (Rational::from(&corners[a][i] + &corners[b][i])) / 2);
                    for i in 0..3 {
                        let side = left(&middle(ends[0]), &middle(ends[1]), &corners[i]);
                        assert_eq!(side == Sign::Positive, positive[i], "{positive:?}");
                    }
                }
            }
        }
        assert_eq!(count, BTreeMap::from([(0, 2), (2, 6)]));
    }
}
