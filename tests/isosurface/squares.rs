//! Marching squares: chapter 5.c claim by claim.

use crate::domain::*;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::critical::{BilinearCritical, bilinear_critical};
use isoracle::isosurface::multilinear::{LinearZero, bilinear, bilinear_gradient, linear_zero};
use isoracle::isosurface::square::{DegenerateSquare, SquareContour, SquareCorner, SquareEdge, contour};
use isoracle::number::{Rational, Sign};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

pub const VALUES: [i64; 8] = [-4, -3, -2, -1, 1, 2, 3, 4];

/// The saddle at 0.
const CROSS: [i64; 4] = [1, -1, -1, 1];

pub fn at_zero(g: &[i64; 4]) -> Result<SquareContour, DegenerateSquare> {
    contour(&rationals(g), &Rational::new(), Tie::Degenerate)
}

pub fn is_ambiguous(g: &[i64; 4]) -> bool {
    let [a, b, c, d] = g.map(i64::signum);
    a == d && b == c && a == -b
}

pub fn determinant_of([g00, g10, g01, g11]: &[i64; 4]) -> i64 {
    g00 * g11 - g10 * g01
}

fn saddle(g: &[i64; 4]) -> [Rational; 2] {
    let s = g[0] + g[3] - g[1] - g[2];
    [q(g[0] - g[2], s), q(g[0] - g[1], s)]
}

/// Of corners 0 … 3 the sets that the segments leave connected: by cutting the boundary's cycle at the crossings and
/// joining what no segment separates.
fn regions(g: &[i64; 4], contour: &SquareContour) -> BTreeSet<BTreeSet<usize>> {
    let edge = |e: &SquareEdge| e.corners().map(SquareCorner::index);
    let separated = |a: usize, b: usize| {
        contour.segments.iter().any(|[from, to]| {
            // The segment cuts off the corners between its ends, counter-clockwise.
            let cycle = [0, 1, 3, 2];
            let place = |e: &SquareEdge| {
                (0..4)
                    .find(|&i| {
                        let [p, q] = edge(e);
                        [p, q].contains(&cycle[i]) && [p, q].contains(&cycle[(i + 1) % 4])
                    })
                    .expect("a side of the square")
            };
            let (start, end) = (place(from), place(to));
            let cut_off: Vec<usize> = (1..=(end + 4 - start) % 4).map(|k| cycle[(start + k) % 4]).collect();
            cut_off.contains(&a) != cut_off.contains(&b)
        })
    };
    (0..4).map(|a| (0..4).filter(|&b| g[a].signum() == g[b].signum() && !separated(a, b)).collect()).collect()
}

/// The components of {f < 0} (`sign` −1) or {f > 0} among the corners, by samples on a lattice through the saddle.
fn sampled(g: &[i64; 4], sign: i64) -> usize {
    const N: i64 = 32;
    let f = |i: i64, j: i64| (N - i) * (N - j) * g[0] + i * (N - j) * g[1] + (N - i) * j * g[2] + i * j * g[3];
    let mut left: BTreeSet<(i64, i64)> =
        (0..=N).flat_map(|i| (0..=N).map(move |j| (i, j))).filter(|&(i, j)| f(i, j).signum() == sign).collect();
    let mut count = 0;
    while let Some(start) = left.pop_first() {
        count += 1;
        let mut stack = vec![start];
        while let Some((i, j)) = stack.pop() {
            stack.extend([(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)].into_iter().filter(|p| left.remove(p)));
        }
    }
    count
}

mod is_36 {
    use super::*;

    #[test]
    fn a_square_has_0_2_or_4_vertices() {
        let mut patterns: BTreeMap<usize, BTreeSet<[bool; 4]>> = BTreeMap::new();
        for g in all::<4>(&[-3, -1, 1, 2]).collect::<Vec<_>>() {
            let Ok(contour) = at_zero(&g) else { continue };
            // A vertex is a zero on an edge, between opposite signs.
            let cycle = [g[0], g[1], g[3], g[2]];
            let changes = (0..4).filter(|&i| cycle[i] * cycle[(i + 1) % 4] < 0).count();
            assert_eq!(contour.crossings.len(), changes, "{g:?}");
            patterns.entry(changes).or_default().insert(g.map(|v| v > 0));
        }
        let counts: Vec<_> = patterns.into_iter().map(|(changes, patterns)| (changes, patterns.len())).collect();
        assert_eq!(counts, [(0, 2), (2, 12), (4, 2)]);
    }
}

mod is_37 {
    use super::*;

    fn orbits(complement: bool, reflections: bool) -> usize {
        let turn = |p: [bool; 4]| [p[2], p[0], p[3], p[1]];
        let mirror = |p: [bool; 4]| [p[1], p[0], p[3], p[2]];
        let least = |pattern: [bool; 4]| {
            let mut images = vec![pattern];
            for _ in 0..3 {
                images.push(turn(images[images.len() - 1]));
            }
            if reflections {
                images.extend(images.clone().into_iter().map(mirror));
            }
            if complement {
                images.extend(images.clone().into_iter().map(|p| p.map(|b| !b)));
            }
            images.into_iter().min()
        };
        (0..16).map(|bits| least([0, 1, 2, 3].map(|i| bits >> i & 1 == 1))).collect::<BTreeSet<_>>().len()
    }

    #[test]
    fn fourteen_of_sixteen_patterns_have_none_or_one_segment() {
        let mut few = BTreeSet::new();
        let mut two = BTreeSet::new();
        for g in all::<4>(&[-2, -1, 1, 2]).collect::<Vec<_>>() {
            let Ok(contour) = at_zero(&g) else { continue };
            let pattern = g.map(|v| v > 0);
            assert_eq!(contour.segments.len() * 2, contour.crossings.len());
            if contour.segments.len() < 2 {
                few.insert(pattern)
            } else {
                two.insert(pattern)
            };
        }
        assert_eq!((few.len(), two.len()), (14, 2));
        assert!(few.is_disjoint(&two));
    }

    #[test]
    fn six_cases_under_rotations_and_four_with_the_exchange_of_signs() {
        assert_eq!([orbits(false, false), orbits(true, false)], [6, 4]);
        assert_eq!([orbits(false, true), orbits(true, true)], [6, 4]);
    }
}

mod is_38 {
    use super::*;

    #[test]
    fn with_zeros_at_grid_points_edges_may_hold_infinitely_many_and_else_may_not() {
        // The whole edge v = 0.
        assert_eq!(linear_zero(&rationals(&[0, 0])), LinearZero::Everywhere);
        assert_eq!(at_zero(&[0, 0, 1, 1]), Err(DegenerateSquare::Corner(SquareCorner::ALL[0])));
        for g in all::<2>(&VALUES).collect::<Vec<_>>() {
            assert_ne!(linear_zero(&rationals(&g)), LinearZero::Everywhere);
        }
        // The excluded reading, solutions in the plane: infinitely many without any zero sample, on two points of edges.
        let g = [1, -1, 1, -1];
        for n in 0..=12 {
            assert_eq!(bilinear(&rationals(&g), &[q(1, 2), q(n, 12)]), 0);
        }
        let crossings = at_zero(&g).expect("no sample is 0").crossings;
        assert_eq!(
            crossings.iter().map(|c| c.edge.corners().map(SquareCorner::index)).collect::<Vec<_>>(),
            [[0, 1], [2, 3]]
        );
    }
}

mod is_39 {
    use super::*;

    #[test]
    fn four_vertices_are_the_only_ambiguous_case() {
        // A pattern is ambiguous iff values of those signs have different segments.
        let mut segments: BTreeMap<[bool; 4], BTreeSet<Vec<[SquareEdge; 2]>>> = BTreeMap::new();
        for g in all::<4>(&VALUES).collect::<Vec<_>>() {
            if let Ok(contour) = at_zero(&g) {
                segments.entry(g.map(|v| v > 0)).or_default().insert(contour.segments);
            }
        }
        let ambiguous: Vec<_> = segments.into_iter().filter(|(_, ways)| ways.len() > 1).collect();
        let patterns: Vec<_> = ambiguous.iter().map(|(pattern, ways)| (*pattern, ways.len())).collect();
        assert_eq!(patterns, [([false, true, true, false], 2), ([true, false, false, true], 2)]);
    }
}

mod is_40 {
    use super::*;

    #[test]
    fn the_saddle_of_an_ambiguous_square_lies_inside_and_its_gradient_is_null() {
        let seen = all::<4>(&VALUES)
            .filter(is_ambiguous)
            .map(|g| {
                let BilinearCritical::Saddle(found) = bilinear_critical(&rationals(&g)) else { panic!("{g:?}") };
                let [u, v] = saddle(&g);
                assert_eq!([&found.u, &found.v], [&u, &v]);
                assert!(u > 0 && u < 1 && v > 0 && v < 1, "{g:?}");
                assert!(bilinear_gradient(&rationals(&g), &[u, v]).iter().all(Rational::is_zero));
            })
            .count();
        assert_eq!(seen, 512);
    }
}

mod is_41 {
    use super::*;

    #[test]
    fn the_contour_is_a_hyperbola_about_the_saddle_unless_the_determinant_is_0() {
        for g in all::<4>(&VALUES).filter(is_ambiguous).collect::<Vec<_>>() {
            let [u0, v0] = saddle(&g);
            let s = g[0] + g[3] - g[1] - g[2];
            // f = s(u − u_s)(v − v_s) + det/s: a hyperbola with that centre iff the constant is not 0.
            for (n, m) in [(0, 0), (1, 5), (3, 2), (-2, 7), (5, 5)] {
                let point = [q(n, 5), q(m, 5)];
                let offset = Rational::from(&point[0] - &u0) * Rational::from(&point[1] - &v0);
                assert_eq!(bilinear(&rationals(&g), &point), offset * s + q(determinant_of(&g), s), "{g:?}");
            }
            let is_crossed = matches!(at_zero(&g), Err(DegenerateSquare::Saddle { .. }));
            assert_eq!(is_crossed, determinant_of(&g) == 0);
        }
    }

    #[test]
    fn printed_without_the_condition_it_fails_for_two_crossing_lines() {
        assert_eq!(at_zero(&CROSS), Err(DegenerateSquare::Saddle { u: q(1, 2), v: q(1, 2) }));
        for n in -3..=5 {
            assert_eq!(bilinear(&rationals(&CROSS), &[q(1, 2), q(n, 2)]), 0);
            assert_eq!(bilinear(&rationals(&CROSS), &[q(n, 2), q(1, 2)]), 0);
        }
    }
}

mod is_42 {
    use super::*;

    #[test]
    fn the_determinant_says_which_diagonal_is_joined() {
        for g in all::<4>(&VALUES).filter(|g| is_ambiguous(g) && determinant_of(g) != 0).collect::<Vec<_>>() {
            let contour = at_zero(&g).expect("the determinant is not 0");
            let pair = if determinant_of(&g) > 0 { [0, 3] } else { [1, 2] };
            let found = regions(&g, &contour);
            assert!(found.contains(&BTreeSet::from(pair)), "{g:?}: {found:?}");
            assert_eq!(found.len(), 3, "{g:?}");
            // From the saddle to both corners of the pair f keeps its sign.
            let [u, v] = saddle(&g);
            for c in pair {
                for n in 0..=8 {
                    let share = |from: &Rational, to: usize| Rational::from(to) * q(n, 8) + from * q(8 - n, 8);
                    let value = bilinear(&rationals(&g), &[share(&u, c & 1), share(&v, c >> 1)]);
                    assert_eq!(Sign::of(value.cmp0()).value(), g[c].signum() as i8, "{g:?}");
                }
            }
        }
    }

    #[test]
    fn at_determinant_0_neither_pair_is_joined() {
        assert_eq!(determinant_of(&CROSS), 0);
        assert!(at_zero(&CROSS).is_err());
        assert_eq!([sampled(&CROSS, -1), sampled(&CROSS, 1)], [2, 2]);
    }
}

mod is_43 {
    use super::*;

    #[test]
    fn the_value_at_the_saddle_is_the_determinant_over_the_mixed_derivative() {
        for g in all::<4>(&[-3, -2, -1, 0, 1, 2, 3]).collect::<Vec<_>>() {
            let s = g[0] + g[3] - g[1] - g[2];
            let BilinearCritical::Saddle(found) = bilinear_critical(&rationals(&g)) else {
                assert_eq!(s, 0);
                continue;
            };
            let value = bilinear(&rationals(&g), &saddle(&g));
            assert_eq!(value, q(determinant_of(&g), s));
            assert_eq!(found.value, value);
            if is_ambiguous(&g) {
                let sign = determinant_of(&g).signum() * g[0].signum();
                assert_eq!(i64::from(Sign::of(value.cmp0()).value()), sign, "{g:?}");
            }
        }
    }
}

mod is_44 {
    use super::*;

    #[test]
    fn in_an_ambiguous_square_exactly_one_side_is_connected() {
        for g in all::<4>(&[-3, -1, 1, 2]).collect::<Vec<_>>() {
            let connected = [-1, 1].map(|sign| sampled(&g, sign) <= 1);
            if !is_ambiguous(&g) {
                assert_eq!(connected, [true, true], "{g:?}");
            } else if determinant_of(&g) != 0 {
                let joins_positive = (determinant_of(&g) > 0) == (g[0] > 0);
                assert_eq!(connected, [!joins_positive, joins_positive], "{g:?}");
                let parts = regions(&g, &at_zero(&g).expect("not degenerate"));
                let negative = parts.iter().filter(|part| part.iter().all(|c| g[*c] < 0)).count();
                assert_eq!(negative == 1, connected[0], "{g:?}");
            }
        }
    }

    #[test]
    fn at_determinant_0_a_disconnected_negative_side_does_not_mean_a_joined_positive_one() {
        assert_eq!([sampled(&CROSS, -1), sampled(&CROSS, 1)], [2, 2]);
    }
}

/// Whether 0 is a regular value of f in the closed square: where f = 0 the gradient is not null.
fn is_regular(g: &[i64; 4]) -> bool {
    match bilinear_critical(&rationals(g)) {
        BilinearCritical::None => true,
        BilinearCritical::Everywhere => g[0] != 0,
        BilinearCritical::Saddle(saddle) => {
            !saddle.value.is_zero() || ![saddle.u, saddle.v].iter().all(|x| *x >= 0 && *x <= 1)
        }
    }
}

mod is_47 {
    use super::*;

    #[test]
    fn without_null_samples_0_is_regular_iff_the_square_is_not_degenerate() {
        for g in all::<4>(&VALUES).collect::<Vec<_>>() {
            assert_eq!(is_regular(&g), !is_ambiguous(&g) || determinant_of(&g) != 0, "{g:?}");
            assert_eq!(is_regular(&g), at_zero(&g).is_ok(), "{g:?}");
        }
    }

    #[test]
    fn null_samples_are_neither_necessary_nor_sufficient_for_a_critical_value() {
        assert!(!CROSS.contains(&0) && !is_regular(&CROSS));
        let plane = [0, 1, 1, 2];
        assert!(plane.contains(&0) && is_regular(&plane));
        for [n, m] in [[0, 0], [1, 3], [2, 1]] {
            assert_eq!(bilinear(&rationals(&plane), &[q(n, 3), q(m, 3)]), q(n + m, 3));
        }
    }
}
