//! Topologies, connectedness, continuity: finite spaces exhaustively, and sets of the real line.

use super::q;
use isoracle::curvature::finite_topology::{FiniteSpace, Points, TopologyError, subsets};
use isoracle::curvature::line_set::LineSet;
use isoracle::number::Rational;
use std::collections::BTreeSet;

/// Every topology on {0, …, n − 1}.
fn topologies(n: u32) -> Vec<FiniteSpace> {
    let sets = 1_u32 << n;
    let family = |bits: u32| (0..sets).filter(move |i| bits >> i & 1 == 1).map(|i| i as Points);
    let whole = sets - 1;
    let with_ends = (0..1_u64 << sets).map(|bits| bits as u32).filter(|bits| bits & 1 == 1 && bits >> whole & 1 == 1);
    with_ends.filter_map(|bits| FiniteSpace::new(n, family(bits)).ok()).collect()
}

fn has(set: Points, x: u32) -> bool {
    set >> x & 1 == 1
}

/// The least open set around a point.
fn around(space: &FiniteSpace, x: u32) -> Points {
    space.open().iter().filter(|u| has(**u, x)).fold(space.whole(), |least, u| least & u)
}

/// All maps from n points to m points.
fn maps(n: u32, m: u32) -> impl Iterator<Item = Vec<u32>> {
    (0..m.pow(n)).map(move |number| (0..n).map(|i| number / m.pow(i) % m).collect())
}

/// The set of these cells of the line with the ends 0, 1, 2: (−∞, 0), {0}, (0, 1), {1}, (1, 2), {2}, (2, ∞).
fn of_cells(cells: Points) -> LineSet {
    let end = |i: i64| (0..3).contains(&i).then(|| q(i, 1));
    let cell = |i: i64| match i % 2 {
        1 => LineSet::point(q(i / 2, 1)),
        _ => LineSet::interval(end(i / 2 - 1), end(i / 2)),
    };
    (0..7).filter(|i| has(cells, *i)).fold(LineSet::empty(), |set, i| set.union(&cell(i64::from(i))))
}

/// The line with the cells as points: a cell {pᵢ} has the gaps beside it in each open set around it.
fn digital_line() -> FiniteSpace {
    let open = subsets(0b111_1111)
        .filter(|set| (1..7).step_by(2).all(|i| !has(*set, i) || (has(*set, i - 1) && has(*set, i + 1))));
    FiniteSpace::new(7, open).expect("a topology")
}

mod cu_219 {
    use super::*;

    fn classes(n: u32) -> usize {
        let images = |space: &FiniteSpace, map: &[u32]| -> BTreeSet<Points> {
            let image = |set: Points| (0..n).filter(|x| has(set, *x)).fold(0, |image, x| image | 1 << map[x as usize]);
            space.open().iter().map(|u| image(*u)).collect()
        };
        let bijections: Vec<Vec<u32>> =
            maps(n, n).filter(|m| m.iter().collect::<BTreeSet<_>>().len() == n as usize).collect();
        let least = |space: &FiniteSpace| bijections.iter().map(|map| images(space, map)).min();
        topologies(n).iter().map(least).collect::<BTreeSet<_>>().len()
    }

    #[test]
    fn homeomorphisms_are_the_bijections_that_keep_the_open_sets() {
        for n in 0..=3 {
            let spaces = topologies(n);
            for (a, b) in spaces.iter().flat_map(|a| spaces.iter().map(move |b| (a, b))) {
                for map in maps(n, n) {
                    let is_bijective = map.iter().collect::<BTreeSet<_>>().len() == n as usize;
                    let image =
                        |set: Points| (0..n).filter(|x| has(set, *x)).fold(0, |image, x| image | 1 << map[x as usize]);
                    let images: BTreeSet<Points> = a.open().iter().map(|u| image(*u)).collect();
                    assert_eq!(a.is_homeomorphism(&map, b), is_bijective && images == *b.open());
                }
            }
        }
        // Up to homeomorphism: 1, 1, 3, 9, 33 spaces.
        assert_eq!((0..=4).map(classes).collect::<Vec<_>>(), [1, 1, 3, 9, 33]);
    }

    #[test]
    fn the_inverse_of_a_continuous_bijection_need_not_be_continuous() {
        let discrete = FiniteSpace::new(2, [0, 1, 2, 3]).expect("a topology");
        let trivial = FiniteSpace::new(2, [0, 3]).expect("a topology");
        assert!(discrete.is_continuous(&[0, 1], &trivial) && !trivial.is_continuous(&[0, 1], &discrete));
        assert!(!discrete.is_homeomorphism(&[0, 1], &trivial));
        let point = FiniteSpace::new(1, [0, 1]).expect("a topology");
        assert!(!point.is_homeomorphism(&[1], &discrete) && !discrete.is_homeomorphism(&[0, 0], &point));
    }
}

mod cu_220 {
    use super::*;

    #[test]
    fn finite_families_are_all_families_of_a_finite_set() {
        // Every family of subsets: the axioms for pairs against those for all subfamilies.
        for n in 0..=3_u32 {
            let sets = 1_u32 << n;
            for bits in 0..1_u32 << sets {
                let family: Vec<Points> = (0..sets).filter(|i| bits >> i & 1 == 1).map(|i| i as Points).collect();
                let whole = (sets - 1) as Points;
                let is_topology = (0..1_u32 << family.len()).all(|chosen| {
                    let members = || (0..family.len()).filter(move |i| chosen >> i & 1 == 1).map(|i| family[i]);
                    let union = members().fold(0, |a, b| a | b);
                    // That of no sets is X.
                    let intersection = members().fold(whole, |a, b| a & b);
                    family.contains(&union) && family.contains(&intersection)
                });
                assert_eq!(FiniteSpace::new(n, family).is_ok(), is_topology);
            }
        }
        assert_eq!((0..=4).map(|n| topologies(n).len()).collect::<Vec<_>>(), [1, 1, 4, 29, 355]);
    }

    #[test]
    fn what_is_missing_is_told() {
        assert_eq!(FiniteSpace::new(2, [0]), Err(TopologyError::Missing(3)));
        assert_eq!(FiniteSpace::new(2, [3]), Err(TopologyError::Missing(0)));
        assert_eq!(FiniteSpace::new(2, [0, 3, 4]), Err(TopologyError::Outside(4)));
        assert_eq!(FiniteSpace::new(3, [0, 1, 2, 7]), Err(TopologyError::Union(1, 2)));
        assert_eq!(FiniteSpace::new(3, [0, 3, 6, 7]), Err(TopologyError::Intersection(3, 6)));
        assert_eq!(FiniteSpace::new(17, []), Err(TopologyError::TooMany(17)));
        assert!(FiniteSpace::new(16, [0, u16::MAX]).is_ok());
    }

    #[test]
    fn countable_unions_are_not_all_unions() {
        // At most countable sets and ℝ: closed under unions and intersections of the sets that can be written down
        // here.
        let sets: Vec<LineSet> = (0..128).map(of_cells).filter(LineSet::is_open_printed).collect();
        assert_eq!(sets.len(), 9);
        assert!(LineSet::empty().is_open_printed() && LineSet::line().is_open_printed());
        for (a, b) in sets.iter().flat_map(|a| sets.iter().map(move |b| (a, b))) {
            assert!(a.union(b).is_open_printed() && a.intersection(b).is_open_printed());
        }
        // Each {x} is one of them; the union of those with 0 ≤ x ≤ 1 is none, though each of its points comes from one.
        let unit = LineSet::interval(Some(q(0, 1)), Some(q(1, 1)))
            .union(&LineSet::point(q(0, 1)))
            .union(&LineSet::point(q(1, 1)));
        for n in 0..=20 {
            assert!(LineSet::point(q(n, 20)).is_open_printed() && unit.contains(&q(n, 20)));
        }
        assert!(!unit.is_open_printed() && !unit.is_countable() && unit != LineSet::line());
    }
}

mod cu_221 {
    use super::*;

    #[test]
    fn unions_of_open_intervals_are_a_topology() {
        let open: Vec<LineSet> = (0..128).map(of_cells).filter(LineSet::is_open).collect();
        assert_eq!(open.len(), digital_line().open().len());
        for (a, b) in open.iter().flat_map(|a| open.iter().map(move |b| (a, b))) {
            assert!(a.union(b).is_open() && a.intersection(b).is_open());
        }
        assert!(LineSet::empty().is_open() && LineSet::line().is_open());
    }

    #[test]
    fn a_set_is_open_iff_it_has_an_interval_around_each_point() {
        for cells in 0..128 {
            let set = of_cells(cells);
            let around = |x: &Rational| LineSet::interval(Some(x.clone() - q(1, 4)), Some(x.clone() + q(1, 4)));
            let samples = (-4..=12).map(|n| q(n, 4)).filter(|x| set.contains(x) && x.is_integer());
            let has_all = samples.into_iter().all(|x| around(&x).difference(&set) == LineSet::empty());
            assert_eq!(set.is_open(), has_all);
        }
    }

    #[test]
    fn the_normal_form_is_that_of_the_set() {
        let samples: Vec<Rational> = (-2..=6).map(|n| q(n, 2)).collect();
        let members = |set: &LineSet| samples.iter().map(|x| set.contains(x)).collect::<Vec<_>>();
        for (a, b) in (0..128).flat_map(|a| (0..128).map(move |b| (a, b))) {
            let (x, y) = (of_cells(a), of_cells(b));
            assert_eq!(x == y, a == b);
            assert_eq!(
                (x.union(&y), x.intersection(&y), x.difference(&y)),
                (of_cells(a | b), of_cells(a & b), of_cells(a & !b))
            );
            if b == 0 {
                assert_eq!(members(&x), (0..9).map(|i| has(a, [0, 0, 1, 2, 3, 4, 5, 6, 6][i])).collect::<Vec<_>>());
            }
        }
        assert_eq!(LineSet::interval(Some(q(1, 1)), Some(q(1, 1))), LineSet::empty());
        assert_eq!(LineSet::interval(Some(q(2, 1)), Some(q(1, 1))), LineSet::empty());
        assert_eq!(LineSet::interval(None, None), LineSet::line());
    }
}

mod cu_222 {
    use super::*;

    #[test]
    fn splittings_are_the_pairs_of_open_parts() {
        for space in (0..=4).flat_map(topologies) {
            for subset in subsets(space.whole()) {
                // Open in X: around each point, what the least open set has of X.
                let is_open = |a: Points| {
                    (0..space.points()).filter(|x| has(a, *x)).all(|x| around(&space, x) & subset & !a == 0)
                };
                let expected: BTreeSet<[Points; 2]> =
                    subsets(subset).map(|a| [a, subset & !a]).filter(|[a, b]| is_open(*a) && is_open(*b)).collect();
                assert_eq!(space.splittings(subset).into_iter().collect::<BTreeSet<_>>(), expected);
                assert!(expected.contains(&[0, subset]));
            }
        }
    }

    #[test]
    fn the_line_less_a_point_falls_into_two() {
        let (below, above) = (LineSet::interval(None, Some(q(0, 1))), LineSet::interval(Some(q(0, 1)), None));
        let punctured = LineSet::line().difference(&LineSet::point(q(0, 1)));
        assert_eq!(below.union(&above), punctured);
        assert_eq!(below.intersection(&above), LineSet::empty());
        assert!(below.is_open() && above.is_open() && below != LineSet::empty() && above != LineSet::empty());
        // {0} itself is open in no part that has a point beside it, though it is open in {0}.
        assert!(digital_line().splittings(0b10).contains(&[0b10, 0]));
    }
}

mod cu_223 {
    use super::*;

    #[test]
    fn finite_sets_are_connected_iff_their_points_are_by_comparable_ones() {
        for space in (0..=4).flat_map(topologies) {
            for subset in subsets(space.whole()) {
                // x and y are comparable iff one is in every open set around the other.
                let joined = |x: u32, y: u32| has(around(&space, x), y) || has(around(&space, y), x);
                let mut reached = subset & subset.wrapping_neg();
                loop {
                    let next = (0..4).filter(|y| has(subset, *y) && (0..4).any(|x| has(reached, x) && joined(x, *y)));
                    let larger = next.fold(reached, |set, y| set | 1 << y);
                    if larger == reached {
                        break;
                    }
                    reached = larger;
                }
                assert_eq!(space.is_connected(subset), reached == subset);
            }
            assert!(space.is_connected(0));
        }
    }

    #[test]
    fn intervals_are_the_connected_sets_of_the_line() {
        let line = digital_line();
        for cells in 0..128 {
            assert_eq!(of_cells(cells).is_connected(), line.is_connected(cells));
        }
        assert!(LineSet::line().is_connected() && LineSet::empty().is_connected());
        assert!(!LineSet::line().difference(&LineSet::point(q(0, 1))).is_connected());
    }
}

mod cu_224 {
    use super::*;

    #[test]
    fn components_are_connected_and_divide_the_set() {
        for space in (0..=4).flat_map(topologies) {
            for subset in subsets(space.whole()) {
                for x in 0..space.points() {
                    let component = space.component(x, subset);
                    assert_eq!(has(component, x), has(subset, x));
                    assert!(component & !subset == 0 && space.is_connected(component));
                    for y in (0..space.points()).filter(|y| has(component, *y)) {
                        assert_eq!(space.component(y, subset), component);
                    }
                }
            }
        }
    }

    #[test]
    fn components_on_the_line_are_those_of_its_cells() {
        let line = digital_line();
        for cells in 0..128 {
            let parts: BTreeSet<Points> = (0..7).map(|x| line.component(x, cells)).filter(|part| *part != 0).collect();
            let found = of_cells(cells).components();
            assert_eq!(found.len(), parts.len());
            assert!(parts.into_iter().all(|part| found.contains(&of_cells(part))));
        }
    }

    #[test]
    fn a_point_that_is_not_there_has_the_empty_component() {
        assert_eq!([7, 16, u32::MAX].map(|x| digital_line().component(x, 0b111_1111)), [0, 0, 0]);
    }

    #[test]
    fn that_of_1_off_0_is_the_positive_half() {
        let punctured = LineSet::line().difference(&LineSet::point(q(0, 1)));
        let component: Vec<LineSet> =
            punctured.components().into_iter().filter(|part| part.contains(&q(1, 1))).collect();
        assert_eq!(component, [LineSet::interval(Some(q(0, 1)), None)]);
    }
}

mod cu_230 {
    use super::*;

    #[test]
    fn continuous_maps_are_those_that_keep_the_order() {
        for (n, m) in (0..=3).flat_map(|n| (1..=3).map(move |m| (n, m))) {
            for (from, to) in topologies(n).iter().flat_map(|a| topologies(m).into_iter().map(move |b| (a.clone(), b)))
            {
                for map in maps(n, m) {
                    // y in every open set around x has its image in every one around x's.
                    let keeps = |x: u32, y: u32| {
                        !has(around(&from, x), y) || has(around(&to, map[x as usize]), map[y as usize])
                    };
                    let expected = (0..n).all(|x| (0..n).all(|y| keeps(x, y)));
                    assert_eq!(from.is_continuous(&map, &to), expected);
                    if from == to {
                        // As for f: ℝᵐ → ℝᵐ.
                        assert_eq!(from.is_continuous_printed(&map), expected);
                    }
                }
            }
        }
    }

    #[test]
    fn the_open_sets_of_the_domain_do_not_decide() {
        let space = |n: u32, open: &[Points]| FiniteSpace::new(n, open.iter().copied()).expect("a topology");
        let (trivial, discrete) = (space(2, &[0, 3]), space(2, &[0, 1, 2, 3]));
        assert!(trivial.is_continuous_printed(&[0, 1]) && !trivial.is_continuous(&[0, 1], &discrete));
        // Values that are no points of the domain, as those of f: ℝ² → ℝ: all preimages are empty, and every map
        // passes.
        let four = FiniteSpace::new(4, 0..16).expect("the discrete topology");
        assert!(trivial.is_continuous_printed(&[2, 3]) && !trivial.is_continuous(&[2, 3], &four));
    }
}
