//! Marching cubes: chapter 5.d claim by claim.

use crate::domain::*;
use isoracle::isosurface::boundary::arcs;
use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Decisions, Degenerate, Tie, Topology, assemble, decide, topology};
use isoracle::isosurface::cube::{Corner, Edge, Face};
use isoracle::isosurface::multilinear::{LinearZero, on_line, trilinear, zero_on_line};
use isoracle::isosurface::patch::patch;
use isoracle::isosurface::square::contour;
use isoracle::isosurface::subdivision::topology as subdivide;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::isosurface::{classes, mesh, slices};
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn cell(values: [i64; 8]) -> Topology {
    topology(&rationals(&values), &Rational::new(), Tie::Degenerate).expect("not degenerate")
}

mod is_54 {
    use super::*;

    #[test]
    fn each_crossed_edge_has_one_vertex_where_f_vanishes_and_no_other_edge_has_any() {
        for values in all::<8>(&[-3, -1, 2]).step_by(5).collect::<Vec<_>>() {
            let g = rationals(&values);
            let volume = Volume::integers([2, 2, 2], values.map(|v| v as i32).to_vec()).expect("a volume");
            let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Below };
            let mesh = mesh::extract(&level).expect("ties are broken");
            let mut expected = BTreeSet::new();
            for edge in Edge::ALL {
                let [a, b] = edge.corners();
                let others: Vec<usize> = (0..3).filter(|&axis| axis != edge.axis()).collect();
                let at = [others[0], others[1]].map(|axis| Rational::from(a.position()[axis]));
                match zero_on_line(&g, edge.axis(), &at) {
                    LinearZero::Everywhere => panic!("no value is 0"),
                    LinearZero::None => assert!(values[a.index()] * values[b.index()] > 0),
                    LinearZero::At(t) => {
                        let mut point = a.position().map(Rational::from);
                        point[edge.axis()] = t;
                        assert!(trilinear(&g, &point).is_zero());
                        expected.insert(point);
                    }
                }
            }
            let on_edges = mesh.vertices.iter().filter(|v| matches!(v, mesh::Vertex::Crossing(_)));
            let found: Vec<_> = on_edges.map(|v| level.position(v)).collect();
            assert_eq!(found.len(), expected.len(), "{values:?}");
            assert_eq!(found.into_iter().collect::<BTreeSet<_>>(), expected, "{values:?}");
        }
    }
}

mod is_55 {
    use super::*;

    #[test]
    fn one_corner_of_its_own_sign_makes_one_triangle() {
        let mut configurations = BTreeSet::new();
        for values in all::<8>(&SETS[0]).collect::<Vec<_>>() {
            let positive = values.iter().filter(|v| **v > 0).count();
            if positive != 1 && positive != 7 {
                continue;
            }
            let cell = cell(values);
            configurations.insert(cell.decisions.positive);
            let crossed = Edge::ALL.into_iter().filter(|e| cell.decisions.crosses(*e)).count();
            assert_eq!((cell.case, crossed, cell.components.len(), cell.chi()), (Case::C1, 3, 1, 1));
            assert_eq!(cell.decisions.faces, [0; 6]);
            assert_eq!(patch(&cell).triangles.len(), 1);
        }
        assert_eq!(configurations.len(), 16);
    }
}

mod is_56 {
    use super::*;

    /// A cell of these positive corners in which every ambiguous face joins a sign.
    fn table(positive: u8, joins: impl Fn(Face) -> i8) -> Decisions {
        let faces = Face::ALL.map(|face| {
            let [p, q, r, s] = face.cycle().map(|c| positive & c.bit() != 0);
            if p == r && q == s && p != q { joins(face) } else { 0 }
        });
        Decisions { positive, faces, tunnel: None }
    }

    /// The segments on the common face of A (x = 1) and B (x = 0), as pairs of crossed edges' midpoints, doubled.
    fn on_common_face(cell: &Decisions, side: u8) -> Vec<[[u8; 2]; 2]> {
        let middle = |e: Edge| {
            let [a, b] = e.corners().map(Corner::position);
            [a[1] + b[1], a[2] + b[2]]
        };
        arcs(cell, Face::new(0, side)).into_iter().map(|arc| arc.map(middle)).collect()
    }

    fn set(corners: &[usize]) -> u8 {
        corners.iter().fold(0, |set, c| set | 1 << c)
    }

    /// The edges of the face that one of the two cells has and the other has not.
    fn gaps(a: &Decisions, b: &Decisions) -> BTreeMap<[u8; 2], usize> {
        let sorted = |[a, b]: [[u8; 2]; 2]| [a.min(b), a.max(b)];
        let [a, b] = [on_common_face(a, 1), on_common_face(b, 0)].map(|s| s.into_iter().map(sorted).collect());
        let differing: Vec<[[u8; 2]; 2]> = BTreeSet::symmetric_difference(&a, &b).copied().collect();
        let mut degrees = BTreeMap::new();
        differing.into_iter().flatten().for_each(|end| *degrees.entry(end).or_default() += 1);
        degrees
    }

    #[test]
    fn cases_12_and_3_by_a_table_leave_a_hole_on_their_common_face() {
        // B: + at 0, 1, 3, 6: case 12, its face x = 0 has + at 0 and 6. A: + at the same points of x = 1 alone.
        let b = |joins: i8| table(set(&[0, 1, 3, 6]), move |_| joins);
        let a = table(set(&[1, 7]), |_| -1);
        // The complement of case 3: − at the two others.
        let c = table(!set(&[3, 5]), |_| 1);
        assert_eq!([Case::of(&a), Case::of(&c)], [Case::C3_1, Case::C3_1]);
        assert!(matches!(Case::of(&b(1)), Case::C12_1_1));
        // What B isolates decides beside which of the two it fails: four edges, each in one triangle, in a cycle.
        assert_eq!(gaps(&a, &b(1)).values().copied().collect::<Vec<_>>(), [2; 4]);
        assert_eq!(gaps(&a, &b(-1)).len(), 0);
        assert_eq!(gaps(&c, &b(-1)).values().copied().collect::<Vec<_>>(), [2; 4]);
        assert_eq!(gaps(&c, &b(1)).len(), 0);
    }

    #[test]
    fn no_table_by_signs_that_respects_the_complement_is_consistent() {
        // Case 3 and its complement across one face: what the one joins, the other's rule joins with the other sign.
        for joins in [1, -1] {
            let a = table(set(&[1, 7]), |_| joins);
            let complement = table(!set(&[2, 4]), |_| -joins);
            assert_eq!(gaps(&a, &complement).values().copied().collect::<Vec<_>>(), [2; 4]);
        }
    }
}

mod is_57 {
    use super::*;

    proptest! {
        #[test]
        fn neighbours_agree_on_their_common_face(
            values in prop::collection::vec(prop::sample::select(&[-3i64, -2, -1, 0, 1, 2, 3][..]), 12)
        ) {
            // Two cells side by side along x: samples 3 × 2 × 2.
            let cell = |from: usize| -> [i64; 8] {
                std::array::from_fn(|c| values[from + (c & 1) + 3 * (c >> 1 & 1) + 6 * (c >> 2)])
            };
            let decided = [0, 1].map(|from| {
                let cell = rationals(&cell(from));
                topology(&cell, &Rational::new(), Tie::Below).expect("ties are broken").decisions
            });
            prop_assert_eq!(decided[0].faces[1], decided[1].faces[0]);
        }
    }

    #[test]
    fn the_decision_is_that_of_marching_squares_on_the_face_whatever_the_rest() {
        for g in all::<4>(&[-3, -2, -1, 1, 2, 3]).collect::<Vec<_>>() {
            let Ok(square) = contour(&rationals(&g), &Rational::new(), Tie::Degenerate) else { continue };
            let joins = match (square.segments.len(), square.determinant_sign == Sign::Positive) {
                (2, is_main) => {
                    if is_main == (g[0] > 0) {
                        1
                    } else {
                        -1
                    }
                }
                _ => 0,
            };
            for rest in [[5, 7, 7, 9], [-5, -7, -6, -9], [9, 8, -7, 6]] {
                let values = [g[0], g[1], g[2], g[3], rest[0], rest[1], rest[2], rest[3]];
                if let Ok(decisions) = decide(&words(&values)) {
                    assert_eq!(decisions.faces[4], joins, "{values:?}");
                }
            }
        }
    }

    #[test]
    fn at_determinant_0_there_is_no_decision() {
        let told = topology(&rationals(&[1, -1, -1, 1, 2, 2, 2, 2]), &Rational::new(), Tie::Degenerate);
        let point = [q(1, 2), q(1, 2), q(0, 1)];
        assert_eq!(told, Err(Degenerate::Face { face: Face::new(2, 0), point: Box::new(point) }));
    }
}

mod is_58 {
    use super::*;

    #[test]
    fn of_656_combinations_of_signs_and_decisions_620_are_realisable() {
        let ambiguous = |positive: u8| {
            let signs = Face::ALL.map(|face| face.cycle().map(|c| positive & c.bit() != 0));
            signs.into_iter().filter(|[p, q, r, s]| p == r && q == s && p != q).count()
        };
        assert_eq!((0..=255).map(|positive| 1 << ambiguous(positive)).sum::<u32>(), 656);
        let classes = classes::face_classes();
        assert_eq!(classes.len(), 620);
        let mut of: BTreeMap<u8, u32> = BTreeMap::new();
        classes.iter().for_each(|class| *of.entry(class.positive).or_default() += 1);
        // What is missing is all in case 13, where all six faces are ambiguous.
        for (positive, count) in of {
            let all = 1 << ambiguous(positive);
            assert_eq!(count, if ambiguous(positive) == 6 { all - 18 } else { all });
        }
    }
}

mod is_59 {
    use super::*;

    #[test]
    fn the_same_signs_and_faces_with_different_insides() {
        let [discs, annulus] = [[1, 1, 1, -1, -1, 1, 1, 1], [1, 1, 1, -3, -4, 1, 1, 1]].map(cell);
        assert_eq!([discs.case.name(), annulus.case.name()], ["4.1", "4.2"]);
        assert_eq!([discs.components.len(), annulus.components.len()], [2, 1]);
        assert_eq!([discs.chi(), annulus.chi()], [2, 0]);
        assert_eq!(discs.decisions.positive, annulus.decisions.positive);
        assert_eq!([discs.decisions.faces, annulus.decisions.faces], [[0; 6]; 2]);
        for values in [[1, 1, 1, -1, -1, 1, 1, 1], [1, 1, 1, -3, -4, 1, 1, 1]] {
            assert_eq!(subdivide(&words(&values), 40).expect("40 cuts suffice").chi, cell(values).chi());
        }
    }

    #[test]
    fn a_hundred_and_forty_of_620_classes_have_several_topologies() {
        assert_eq!(classes::face_classes().iter().filter(|class| !classes::tunnels(class).is_empty()).count(), 140);
    }
}

mod is_60 {
    use super::*;

    /// For each class of signs and faces, how many topologies there are, and how many values a question about them has.
    fn fails<T: Ord>(question: impl Fn(&Topology) -> T) -> usize {
        let mut answers: BTreeMap<(u8, [i8; 6]), (usize, BTreeSet<T>)> = BTreeMap::new();
        for decisions in class_witnesses().into_keys() {
            let entry = answers.entry((decisions.positive, decisions.faces)).or_default();
            entry.0 += 1;
            entry.1.insert(question(&assemble(decisions)));
        }
        answers.values().filter(|(topologies, answers)| *topologies != answers.len()).count()
    }

    #[test]
    fn whether_the_negative_side_is_connected_does_not_tell_the_topology() {
        let [discs, annulus] = [[-1, -1, -1, 1, 1, -1, -1, -1], [-1, -1, -1, 3, 4, -1, -1, -1]];
        // As printed: the same answer for both, by subdivision too.
        for values in [discs, annulus] {
            assert_eq!(cell(values).negative.parts.len(), 1);
            assert_eq!(subdivide(&words(&values), 40).expect("40 cuts suffice").negative.parts.len(), 1);
        }
        assert_eq!([cell(discs), cell(annulus)].map(|c| (c.components.len(), c.chi())), [(2, 2), (1, 0)]);
        assert_eq!(fails(|cell| cell.negative.parts.len()), 74);
    }

    #[test]
    fn the_components_of_both_sides_tell_it() {
        assert_eq!(fails(|cell| (cell.negative.parts.len(), cell.positive.parts.len())), 0);
    }
}

mod is_61 {
    use super::*;

    /// Of the ambiguous cuts across z: whether there are any, whether all have {f < 0} joined, whether some have.
    fn cuts(values: &[i64; 8]) -> [bool; 3] {
        let lines = [0, 1, 3, 2].map(|xy| [values[xy], values[xy + 4]]);
        let at = |line: usize, w: &Rational| {
            let [low, high] = lines[line];
            Rational::from(high - low) * w + low
        };
        let zeros = lines.iter().filter(|[a, b]| a * b < 0).map(|[a, b]| q(*a, a - b));
        let mut heights: Vec<Rational> = zeros.chain([q(0, 1), q(1, 1)]).collect();
        heights.sort();
        heights.dedup();
        let mut found = [false, true, false];
        for ends in heights.windows(2) {
            let middle = Rational::from(&ends[0] + &ends[1]) / Rational::from(2);
            let [a, b, c, d] = [0, 1, 2, 3].map(|line| Sign::of(at(line, &middle).cmp0()));
            if a != c || b != d || a == b {
                continue;
            }
            // gD > 0 where the negative pair is joined.
            let g = if a == Sign::Negative { 1 } else { -1 };
            let joins = |w: &Rational| (at(0, w) * at(2, w) - at(1, w) * at(3, w)) * Rational::from(g);
            let [low, mid, high] = [&ends[0], &middle, &ends[1]].map(joins);
            // The parabola through the three values, by its extreme point in between.
            let second: Rational = Rational::from(&low + &high) - Rational::from(&mid * 2);
            let slope: Rational = Rational::from(&high - &low);
            let mut values = vec![low, high, mid];
            if !second.is_zero() {
                let share = q(1, 2) - slope / Rational::from(&second * 4);
                if share > 0 && share < 1 {
                    values.push(joins(&(Rational::from(&ends[1] - &ends[0]) * share + &ends[0])));
                }
            }
            // At an end of the stretch the value may be 0 where the cut is no longer ambiguous; inside it is not.
            found[0] = true;
            found[1] &= values.iter().all(|v| *v >= 0);
            found[2] |= values.iter().any(|v| *v > 0);
        }
        found
    }

    fn is_connected(values: &[i64; 8]) -> bool {
        subdivide(&words(values), 60).expect("60 cuts suffice").negative.parts.len() == 1
    }

    #[test]
    fn printed_it_fails_in_both_directions() {
        // ⇒: connected through face z = 0, and by a tunnel; not every cut is marked connected.
        for values in [[-2, 1, 1, -1, 1, 1, 1, 1], [-3, 1, 1, 1, 1, 1, 1, -4]] {
            assert!(is_connected(&values));
            assert_eq!(cuts(&values), [true, false, true], "{values:?}");
        }
        let line = |low: i64, high: i64, w: &Rational| Rational::from(high - low) * w + low;
        let w = q(9, 20);
        let [a, b, c, d] = [[-2, 1], [1, 1], [-1, 1], [1, 1]].map(|[low, high]| line(low, high, &w));
        assert_eq!([&a, &b, &c, &d], [&q(-13, 20), &q(1, 1), &q(-1, 10), &q(1, 1)]);
        assert_eq!(a * c - b * d, q(-187, 200));
        // −4 + 19w − 20w².
        for (w, value) in [(q(1, 4), q(-1, 2)), (q(19, 40), q(41, 80))] {
            let determinant = line(-3, 1, &w) * line(1, -4, &w) - 1;
            assert_eq!(determinant, value);
            assert_eq!(Rational::from(&w * 19) - Rational::from(w.square_ref()) * Rational::from(20) - 4, value);
        }
        // ⇐: no cut is ambiguous, so none is marked disconnected.
        let apart = [-1, 1, 1, 1, 1, 1, 1, -1];
        assert!(!is_connected(&apart));
        assert_eq!(cuts(&apart), [false, true, false]);
    }

    #[test]
    fn corrected_it_is_the_components_of_the_graph_of_lines() {
        for set in SETS {
            all::<8>(&set).filter(|values| decide(&words(values)).is_ok()).for_each(|values| {
                let parts = slices::parts(&rationals(&values), 2, -1);
                if values.iter().any(|v| *v < 0) {
                    assert_eq!(parts.len() == 1, is_connected(&values), "{values:?}");
                }
                let [any, always, some] = cuts(&values);
                let negative: Vec<usize> = (0..4).filter(|&xy| values[xy].min(values[xy + 4]) < 0).collect();
                if negative == [0, 3] || negative == [1, 2] {
                    assert_eq!(some, is_connected(&values), "{values:?}");
                }
                // ⇐ holds where there is an ambiguous cut.
                assert!(!(any && always) || is_connected(&values), "{values:?}");
                // Of S+ with two opposite corners it holds when turned round.
                let positive: Vec<usize> = (0..8).filter(|&c| values[c] > 0).collect();
                if positive.len() == 2 && positive[0] + positive[1] == 7 {
                    let shown = subdivide(&words(&values), 60).expect("60 cuts suffice");
                    assert_eq!(shown.positive.parts.len() == 2, always, "{values:?}");
                }
            });
        }
    }
}

mod is_62 {
    use super::*;

    proptest! {
        #[test]
        fn along_an_axis_f_changes_sign_once_at_most(
            values in prop::array::uniform8(-5..=5i64), axis in 0..3usize, at in prop::array::uniform2(0..=6i64)
        ) {
            let g = rationals(&values);
            let at = at.map(|n| q(n, 6));
            let samples: Vec<Rational> = (0..=12)
                .map(|n| {
                    let mut point = [at[0].clone(), at[0].clone(), at[1].clone()];
                    match axis {
                        0 => (point[1], point[2]) = (at[0].clone(), at[1].clone()),
                        1 => (point[0], point[2]) = (at[0].clone(), at[1].clone()),
                        _ => (point[0], point[1]) = (at[0].clone(), at[1].clone()),
                    }
                    point[axis] = q(n, 12);
                    trilinear(&g, &point)
                })
                .collect();
            let [low, high] = on_line(&g, axis, &at);
            prop_assert_eq!([&low, &high], [&samples[0], &samples[12]]);
            for (n, value) in samples.iter().enumerate() {
                prop_assert_eq!(value, &(Rational::from(&high - &low) * q(n as i64, 12) + &low));
            }
            let signs: Vec<Sign> = samples.iter().map(|v| Sign::of(v.cmp0())).filter(|s| *s != Sign::Zero).collect();
            prop_assert!(signs.windows(2).filter(|pair| pair[0] != pair[1]).count() <= 1);
        }
    }

    #[test]
    fn it_may_vanish_on_a_whole_line() {
        assert_eq!(
            zero_on_line(&rationals(&[1, -1, 1, -1, 1, -1, 1, -1]), 2, &[q(1, 2), q(1, 3)]),
            LinearZero::Everywhere
        );
    }
}
