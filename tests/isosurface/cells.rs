//! The topology of a cell: cuts, loops, components, tunnels, against subdivision and against one another.

use crate::domain::*;
use isoracle::isosurface::boundary::arcs;
use isoracle::isosurface::cell::{Tie, Topology, assemble, decide, topology};
use isoracle::isosurface::cube::{Corner, Edge, Face, Symmetry};
use isoracle::isosurface::multilinear::{trilinear, trilinear_gradient};
use isoracle::isosurface::square::contour;
use isoracle::isosurface::subdivision::{Subdivision, degenerate, topology as subdivide};
use isoracle::isosurface::{classes, critical, slices};
use isoracle::number::{Enclosure, Rational, Sign};
use proptest::prelude::*;
use rayon::prelude::*;

fn sorted<T: Ord>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut items: Vec<T> = items.into_iter().collect();
    items.sort();
    items
}

/// Whether what the decisions imply is what the subdivision shows.
pub fn same(cell: &Topology, shown: &Subdivision) -> bool {
    let part = |c: Corner| {
        let side = if cell.decisions.is_positive(c) { &shown.positive } else { &shown.negative };
        side.parts.iter().position(|corners| corners.contains(&c)).expect("every corner is in a part")
    };
    let between = |edge: &Edge| {
        let [a, b] = edge.corners();
        if cell.decisions.is_positive(a) { [part(b), part(a)] } else { [part(a), part(b)] }
    };
    let components: Vec<Vec<[usize; 2]>> = cell
        .components
        .iter()
        .map(|component| component.loops.iter().flat_map(|&l| &cell.loops[l]).map(between).collect())
        .collect();
    // All loops of a component lie between the same two parts.
    components.iter().all(|edges| edges.iter().all(|pair| *pair == edges[0]))
        && sorted(components.iter().map(|edges| edges[0])) == shown.components
        && cell.chi() == shown.chi
        && sorted(cell.negative.parts.clone()) == sorted(shown.negative.parts.clone())
        && sorted(cell.positive.parts.clone()) == sorted(shown.positive.parts.clone())
        && [cell.negative.b1, cell.positive.b1] == [shown.negative.b1, shown.positive.b1]
}

/// Of each non-degenerate cell of the sets, and of one cell of each class.
fn each_cell(check: impl Fn(&[i64; 8], &Topology) + Sync) {
    for set in SETS {
        all::<8>(&set).for_each(|values| {
            if let Ok(decisions) = decide(&words(&values)) {
                check(&values, &assemble(decisions));
            }
        });
    }
    class_witnesses().par_iter().for_each(|(decisions, values)| check(values, &assemble(*decisions)));
}

/// The value at height w on the four lines along an axis, in cyclic order.
fn cut(values: &[Rational; 8], axis: usize, w: &Rational) -> [Rational; 4] {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| {
        let mut point = [Rational::new(), Rational::new(), Rational::new()];
        (point[u], point[v], point[axis]) = (Rational::from(x), Rational::from(y), w.clone());
        trilinear(values, &point)
    })
}

/// D₀, D₁, D₂ of D = ac − bd, by its values at 0, 1/2 and 1.
fn determinant(values: &[Rational; 8], axis: usize) -> [Rational; 3] {
    let [start, middle, end] = [q(0, 1), q(1, 2), q(1, 1)].map(|w| {
        let [a, b, c, d] = cut(values, axis, &w);
        a * c - b * d
    });
    let second = (Rational::from(&start + &end) - middle * 2) * Rational::from(2);
    [start.clone(), end - start - &second, second]
}

mod is_74 {
    use super::*;

    proptest! {
        #[test]
        fn the_determinant_of_a_cut_is_its_saddle_value_times_the_mixed_derivative(
            values in prop::array::uniform8(-9..=9i64), n in -3..=9i64, axis in 0..3usize
        ) {
            let (g, w) = (rationals(&values), q(n, 7));
            let [d0, d1, d2] = determinant(&g, axis);
            let [a, b, c, d] = cut(&g, axis, &w);
            let value = (Rational::from(&d2 * &w) + &d1) * &w + &d0;
            prop_assert_eq!(&value, &(Rational::from(&a * &c) - Rational::from(&b * &d)), "degree 2");
            let mixed = Rational::from(&a + &c) - &b - &d;
            match critical::bilinear_critical(&[a, b, d, c]) {
                critical::BilinearCritical::Saddle(saddle) => {
                    prop_assert_eq!(&value, &Rational::from(&mixed * &saddle.value));
                    // m = D/f_uv, so m′ = (D′ − m·f_uv′)/f_uv: the derivative across the cut at the saddle.
                    let [low, high] = [q(0, 1), q(1, 1)].map(|w| {
                        let [a, b, c, d] = cut(&g, axis, &w);
                        a + c - b - d
                    });
                    let slope = (d2 * &w * Rational::from(2) + d1 - (high - low) * &saddle.value) / mixed;
                    let mut point = [w.clone(), w.clone(), w];
                    (point[(axis + 1) % 3], point[(axis + 2) % 3]) = (saddle.u, saddle.v);
                    prop_assert_eq!(&trilinear_gradient(&g, &point)[axis], &slope);
                }
                critical::BilinearCritical::None | critical::BilinearCritical::Everywhere => {
                    prop_assert!(mixed.is_zero());
                }
            }
        }
    }

    #[test]
    fn the_sign_of_the_saddle_is_the_one_that_an_ambiguous_cut_joins() {
        for axis in 0..3 {
            for (_, values) in class_witnesses() {
                let [a, b, c, d] = cut(&rationals(&values), axis, &q(3, 7));
                let mixed = Rational::from(&a + &c) - &b - &d;
                let square = [a.clone(), b, d, c];
                let Ok(contour) = contour(&square, &Rational::new(), Tie::Degenerate) else { continue };
                if contour.segments.len() == 2 {
                    assert_eq!(Sign::of(mixed.cmp0()), Sign::of(a.cmp0()));
                    let saddle = contour.saddle.expect("an ambiguous square has one");
                    assert_eq!(Sign::of(saddle.value.cmp0()), contour.determinant_sign * Sign::of(a.cmp0()));
                }
            }
        }
    }
}

mod is_75 {
    use super::*;

    /// From a point, along each axis in turn to the end where f does not increase; f never increases on the way.
    fn walk(values: &[Rational; 8], mut point: [Rational; 3]) -> [Rational; 3] {
        for axis in 0..3 {
            let start = trilinear(values, &point);
            let [low, high] = [0, 1].map(|end| {
                let mut to = point.clone();
                to[axis] = Rational::from(end);
                to
            });
            point = if trilinear(values, &low) <= start { low } else { high };
            assert!(trilinear(values, &point) <= start, "an end of a line is not above any point of it");
        }
        point
    }

    #[test]
    fn from_every_point_f_descends_to_a_corner_along_the_axes() {
        all::<8>(&[-1, 0, 1]).for_each(|values| {
            let g = rationals(&values);
            for (n, m, l) in [(1, 1, 1), (1, 2, 3), (4, 1, 2), (3, 4, 4)] {
                let end = walk(&g, [q(n, 5), q(m, 5), q(l, 5)]);
                assert!(end.iter().all(Rational::is_integer));
            }
        });
    }

    #[test]
    fn every_part_has_a_corner_and_every_corner_a_part() {
        // The subdivision asserts it of each of its boxes.
        each_cell(|values, cell| {
            let corners = [&cell.negative, &cell.positive].map(|side| sorted(side.parts.iter().flatten().copied()));
            assert!([&cell.negative, &cell.positive].iter().all(|side| side.parts.iter().all(|p| !p.is_empty())));
            for (corners, sign) in corners.iter().zip([-1, 1]) {
                let expected: Vec<Corner> =
                    Corner::ALL.into_iter().filter(|c| values[c.index()].signum() == sign).collect();
                assert_eq!(*corners, expected);
            }
            subdivide(&words(values), 40).expect("40 cuts suffice");
        });
    }
}

mod is_76 {
    use super::*;

    /// The segments of a face by marching squares, as pairs of cell edges, each sorted.
    fn segments(values: &[i64; 8], face: Face) -> Vec<[Edge; 2]> {
        let [p, q, r, s] = face.cycle();
        // Square corners (0,0), (1,0), (0,1), (1,1).
        let corners = [p, q, s, r];
        let square = corners.map(|c| Rational::from(values[c.index()]));
        let contour = contour(&square, &Rational::new(), Tie::Degenerate).expect("the cell is not degenerate");
        sorted(contour.segments.iter().map(|segment| {
            segment.map(|side| {
                let [a, b] = side.corners().map(|c| corners[c.index()]);
                Edge::between(a, b).expect("a side of a face is an edge")
            })
        }))
    }

    #[test]
    fn loops_are_closed_curves_through_each_crossed_edge_once_made_of_the_faces_segments() {
        each_cell(|values, cell| {
            let crossed: Vec<Edge> = Edge::ALL.into_iter().filter(|e| cell.decisions.crosses(*e)).collect();
            assert_eq!(sorted(cell.loops.iter().flatten().copied()), crossed);
            let mut steps: Vec<[Edge; 2]> = Vec::new();
            for cycle in &cell.loops {
                assert!((3..=12).contains(&cycle.len()), "{values:?}");
                steps.extend((0..cycle.len()).map(|i| [cycle[i], cycle[(i + 1) % cycle.len()]]));
            }
            // Each with f > 0 on its left seen from outside, as marching squares has it.
            let squares: Vec<[Edge; 2]> = Face::ALL.into_iter().flat_map(|face| segments(values, face)).collect();
            assert_eq!(sorted(steps), sorted(squares), "{values:?}");
            for face in Face::ALL {
                assert_eq!(sorted(arcs(&cell.decisions, face)), segments(values, face), "{values:?}");
            }
            // The loops cut the sphere into regions: one more than there are loops.
            let mut regions = cell.decisions.boundary_parts();
            let count = (0..8).filter(|&c| regions.find(c) == c).count();
            assert_eq!(count, cell.loops.len() + 1, "{values:?}");
            assert!(cell.loops.len() <= 4);
        });
    }
}

mod is_77 {
    use super::*;

    #[test]
    fn components_and_betti_numbers_are_those_that_subdivision_shows() {
        each_cell(|values, cell| {
            let shown = subdivide(&words(values), 40).expect("40 cuts suffice");
            assert!(same(cell, &shown), "{values:?}: {cell:?}, {shown:?}");
        });
    }

    #[test]
    fn components_are_discs_and_at_most_one_annulus() {
        for decisions in classes::classes() {
            let cell = assemble(decisions);
            let annuli = cell.components.iter().filter(|c| c.chi == 0).count();
            assert_eq!(annuli, usize::from(decisions.tunnel.is_some()));
            assert_eq!(cell.chi(), cell.loops.len() as i64 - 2 * annuli as i64);
            assert_eq!(cell.components.len(), cell.loops.len() - annuli);
            assert!(cell.components.iter().all(|c| c.genus == 0 && c.chi == 2 - c.loops.len() as i64));
            assert_eq!(cell.components.len() + 1, cell.negative.parts.len() + cell.positive.parts.len());
            // The annulus is a tube of one sign, which the other side goes round.
            let of_tube = decisions.tunnel.map(|join| decisions.is_positive(join.corners[0]));
            assert_eq!(cell.negative.b1, i64::from(of_tube == Some(true)));
            assert_eq!(cell.positive.b1, i64::from(of_tube == Some(false)));
        }
    }
}

mod is_78 {
    use super::*;

    /// The test of the entry along an axis: no root is computed.
    fn has_tunnel(values: &[Rational; 8], axis: usize) -> bool {
        let [d0, d1, d2] = determinant(values, axis);
        let [low, high] = [0, 1].map(|w| cut(values, axis, &Rational::from(w)));
        // Heights at which a line vanishes bound the stretches of one pattern.
        let mut heights = vec![q(0, 1), q(1, 1)];
        for (a, b) in low.iter().zip(&high) {
            if Sign::of(a.cmp0()) != Sign::of(b.cmp0()) {
                heights.push(a / Rational::from(a - b));
            }
        }
        heights.sort();
        heights.dedup();
        heights.windows(2).any(|ends| {
            let [alpha, beta] = [&ends[0], &ends[1]];
            let [a, b, c, d] = cut(values, axis, &((Rational::from(alpha + beta)) / 2)).map(|v| Sign::of(v.cmp0()));
            if a != c || b != d || a == b || d2.is_zero() {
                return false;
            }
            // g makes gD positive where the pair P, R is joined; the tunnel joins either pair.
            [1, -1].into_iter().any(|g| {
                let at = |w: &Rational| ((Rational::from(&d2 * w) + &d1) * w + &d0) * g;
                let top = Rational::from(-&d1) / Rational::from(&d2 * 2);
                Rational::from(&d2 * g) < 0
                    && Rational::from(d1.square_ref()) > Rational::from(&d2 * &d0) * 4
                    && *alpha < top
                    && top < *beta
                    && at(alpha) < 0
                    && at(beta) < 0
            })
        })
    }

    #[test]
    fn the_tunnel_is_seen_along_each_axis() {
        each_cell(|values, cell| {
            for axis in 0..3 {
                assert_eq!(has_tunnel(&rationals(values), axis), cell.decisions.tunnel.is_some(), "{values:?}: {axis}");
            }
        });
    }

    #[test]
    fn cuts_along_the_other_axes_give_the_same_topology() {
        // `decide` cuts across z alone. A cell and its image under a symmetry of the cube have the same answer, carried.
        let symmetries = Symmetry::all();
        for set in SETS {
            all::<8>(&set).for_each(|values| {
                let told = decide(&words(&values)).map(assemble);
                let turns = [8, 16, 1 + values.iter().map(|v| v.unsigned_abs() as usize).sum::<usize>() * 7 % 47];
                for symmetry in turns.map(|i| symmetries[i]) {
                    let image = decide(&words(&symmetry.carry(&values))).map(assemble);
                    match (&told, image) {
                        (Ok(told), Ok(image)) => {
                            let carried = |parts: &[Vec<Corner>]| {
                                sorted(parts.iter().map(|p| sorted(p.iter().map(|c| symmetry.corner(*c)))))
                            };
                            assert_eq!(carried(&told.negative.parts), sorted(image.negative.parts), "{values:?}");
                            assert_eq!(carried(&told.positive.parts), sorted(image.positive.parts), "{values:?}");
                            assert_eq!(told.decisions.tunnel.is_some(), image.decisions.tunnel.is_some());
                        }
                        (Err(_), Err(_)) => {}
                        (told, image) => panic!("{values:?}: {told:?}, {image:?}"),
                    }
                }
            });
        }
    }

    #[test]
    fn the_annulus_joins_the_loops_round_the_two_corners_of_the_tunnel() {
        for (decisions, _) in class_witnesses() {
            let Some(join) = decisions.tunnel else { continue };
            let cell = assemble(decisions);
            let annulus = cell.components.iter().find(|c| c.chi == 0).expect("a tunnel's surface is an annulus");
            let mut regions = decisions.boundary_parts();
            // Each rim of the annulus runs round the region of one of the two corners.
            let sign = decisions.is_positive(join.corners[0]);
            let round = annulus.loops.iter().map(|&l| {
                let own = cell.loops[l][0].corners().into_iter().find(|c| decisions.is_positive(*c) == sign);
                regions.find(own.expect("a crossed edge has an end of each sign").index())
            });
            let mut round = sorted(round);
            round.dedup();
            assert_eq!(round, join.corners.map(Corner::index));
        }
    }
}

mod is_84 {
    use super::*;

    #[test]
    fn edges_joined_diagonals_and_the_tunnel_connect_what_subdivision_connects() {
        each_cell(|values, cell| {
            let shown = subdivide(&words(values), 40).expect("40 cuts suffice");
            let mut parts = cell.decisions.parts();
            for side in [&shown.negative, &shown.positive] {
                for part in &side.parts {
                    assert!(part.iter().all(|c| parts.find(c.index()) == part[0].index()), "{values:?}");
                }
            }
            let count = (0..8).filter(|&c| parts.find(c) == c).count();
            assert_eq!(count, shown.negative.parts.len() + shown.positive.parts.len(), "{values:?}");
        });
    }
}

mod is_85 {
    use super::*;

    #[test]
    fn cuts_along_any_axis_find_the_parts() {
        each_cell(|values, cell| {
            for axis in 0..3 {
                for (side, sign) in [(&cell.negative, -1), (&cell.positive, 1)] {
                    let found = slices::parts(&rationals(values), axis, sign);
                    assert_eq!(found, sorted(side.parts.clone()), "{values:?}: axis {axis}, sign {sign}");
                }
            }
        });
    }
}

mod is_96 {
    use super::*;

    /// Planted values are integers below M = 2³¹. A critical value c is a root of the hyperdeterminant of the values less
    /// c, quadratic in c with integer coefficients of at most 64M², 96M³, 24M⁴: 0 < |c| < 1 gives |c| ≥ 1/(160 M³) > 2⁻¹⁰¹.
    /// Around a critical point f changes by less than 2³⁵h² within h, so boxes 2⁻⁶⁸ wide do, or 204 cuts. This is half as
    /// many again.
    const CUTS: u32 = 330;

    /// Found by chance: its critical value is 2⁻⁹³ of its greatest sample.
    #[test]
    fn a_critical_value_may_be_very_near_0() {
        let values = [-3145729, 9437183, -3145727, -3145727, -3145727, -3145728, 9437184, -3145729];
        assert!(subdivide(&integers(&values), 130).is_err());
        assert!(agree(&values, &integers(&values), CUTS));
    }

    /// The topology, or the critical point, as the decisions and as the subdivision have it.
    fn agree<K: Enclosure>(values: &[i64; 8], numbers: &[K; 8], cuts: u32) -> bool {
        let told = topology(&rationals(values), &Rational::new(), Tie::Degenerate);
        match (told, degenerate(&rationals(values))) {
            (Ok(told), None) => {
                let shown = subdivide(numbers, cuts).expect("the boxes are small enough");
                assert!(same(&told, &shown), "{values:?}: {told:?}, {shown:?}");
                true
            }
            (told, critical) => {
                assert_eq!(told.err(), critical, "{values:?}");
                false
            }
        }
    }

    #[test]
    fn subdivision_shows_the_topology_and_closed_forms_the_critical_point_of_all_cells_of_few_values() {
        for set in SETS {
            let sound = all::<8>(&set).filter(|values| agree(values, &words(values), 40)).count();
            // Degenerate cells occur, and most are not.
            assert!((32_768..65_536).contains(&sound), "{sound} of 65,536 in {set:?}");
        }
        if is_long() {
            all::<8>(&[-3, -2, -1, 1, 2, 3]).for_each(|values| {
                agree(&values, &words(&values), 40);
            });
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if is_long() { 20_000 } else { 1_000 }))]

        #[test]
        fn planted_critical_points_are_found(values in critical()) {
            agree(&values, &integers(&values), CUTS);
        }

        #[test]
        fn next_to_a_critical_point_the_decisions_are_what_subdivision_shows(values in near_critical()) {
            agree(&values, &integers(&values), CUTS);
        }
    }
}
