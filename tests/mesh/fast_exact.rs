//! What the check of large meshes decides about positions, against rationals and by trial.

use crate::fast::polygons;
use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::mesh::fast::polygons::exact;
use isoracle::mesh::fast::{Point, check};
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;

fn random() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-64..65_i32).prop_map(|n| f64::from(n) / 16.0),
        2 => -1.0..1.0_f64,
        1 => (-1.0..1.0_f64, -40..41_i32).prop_map(|(x, e)| x * 2_f64.powi(e)),
    ]
}

/// Any finite binary64: subnormals, those whose products overflow or vanish.
fn extreme() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => random(),
        1 => (random(), -1074..970_i32).prop_map(|(x, e)| x * 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2)),
        1 => prop::num::f64::ANY.prop_filter("finite", |x| x.is_finite()),
    ]
}

fn point(x: impl Strategy<Value = f64>) -> impl Strategy<Value = Point> {
    prop::collection::vec(x, 3).prop_map(|p| [p[0], p[1], p[2]])
}

/// A coordinate and its neighbours.
fn nudged(x: f64, by: i8) -> f64 {
    let x = match by {
        1 => x.next_up(),
        2 => x.next_down(),
        _ => x,
    };
    x.clamp(f64::MIN, f64::MAX)
}

/// A point near a + s·(b − a) + t·(c − a): rounded, and now and then a neighbour of that.
fn near([a, b, c]: [Point; 3], s: f64, t: f64, nudge: [i8; 3]) -> Point {
    std::array::from_fn(|i| {
        let x = a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]);
        nudged(if x.is_finite() { x } else { 0.0 }, nudge[i])
    })
}

fn difference(a: &Point, b: &Point) -> Vector<Rational, 3> {
    let (a, b) = (exact(a), exact(b));
    Vector(std::array::from_fn(|i| Rational::from(&a.0[i] - &b.0[i])))
}

fn sign(x: &Rational) -> Sign {
    Sign::of(x.cmp0())
}

fn nudges() -> impl Strategy<Value = [i8; 3]> {
    prop::array::uniform3(0..4_i8)
}

const HALVES: [f64; 6] = [0.5, 0.25, 2.0, -1.0, 1.0 / 3.0, 0.0];

fn weight() -> impl Strategy<Value = f64> {
    prop_oneof![prop::sample::select(HALVES.to_vec()), -1.0..2.0_f64]
}

/// ME-145
mod me_145 {
    use super::*;
    use isoracle::mesh::fast::exact::{collinear, orientation};

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn orientations_are_those_of_rationals(a in point(extreme()), b in point(extreme()), s in weight(), nudge in nudges()) {
            let c = near([a, b, a], s, 0.0, nudge);
            let normal = difference(&b, &a).cross(&difference(&c, &a));
            for axis in 0..3 {
                prop_assert_eq!(orientation(axis, &a, &b, &c), sign(&normal.0[axis]), "{:?}", [a, b, c]);
            }
            prop_assert_eq!(collinear(&a, &b, &c), normal == Vector::zero());
        }
    }

    #[test]
    fn the_rounded_minor_alone_would_be_wrong() {
        // The printed bound is needed: without it the rounded value 0 would be taken for the sign.
        let (a, b, c) = ([0.1, 0.1, 0.0], [0.3, 0.3, 0.0], [0.7, 0.7_f64.next_up(), 0.0]);
        let rounded = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert_eq!(orientation(2, &a, &b, &c), Sign::Positive);
        assert!(rounded >= 0.0 && !collinear(&a, &b, &c));
        let tiny = [1e-200, 1e-200, 0.0];
        assert_eq!(orientation(2, &[0.0; 3], &tiny, &[-1e-200, 1e-200, 0.0]), Sign::Positive, "the products vanish");
    }
}

/// ME-146
mod me_146 {
    use super::*;
    use isoracle::mesh::fast::exact::side_of_plane;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn sides_are_those_of_rationals(
            a in point(extreme()), b in point(extreme()), c in point(extreme()),
            s in weight(), t in weight(), nudge in nudges(),
        ) {
            let d = near([a, b, c], s, t, nudge);
            let rows = [&b, &c, &d].map(|p| difference(p, &a).0);
            prop_assert_eq!(side_of_plane(&a, &b, &c, &d), sign(&determinant3(&Matrix(rows))), "{:?}", [a, b, c, d]);
        }
    }
}

/// ME-147
mod me_147 {
    use super::*;
    use isoracle::mesh::fast::exact::strictly_between;

    /// v = a + t(b − a) with 0 < t < 1, t from a coordinate in which a and b differ.
    fn by_parameter(v: &Point, a: &Point, b: &Point) -> bool {
        let (along, to) = (difference(b, a), difference(v, a));
        let Some(i) = (0..3).find(|&i| along.0[i] != 0) else { return false };
        let t = Rational::from(&to.0[i] / &along.0[i]);
        t > 0 && t < 1 && to == along.scaled(&t)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn between_is_a_parameter_between_0_and_1(a in point(random()), b in point(random()), s in weight(), nudge in nudges()) {
            let v = near([a, b, a], s, 0.0, nudge);
            prop_assert_eq!(strictly_between(&v, &a, &b), by_parameter(&v, &a, &b), "{:?}", [v, a, b]);
        }
    }

    #[test]
    fn ends_are_not_inside() {
        let (a, b) = ([0.0; 3], [3.0, 3.0, 3.0]);
        assert!(strictly_between(&[1.0, 1.0, 1.0], &a, &b));
        for v in [a, b, [-0.0; 3], [1.0, 1.0, 1.0_f64.next_up()], [4.0; 3], [-1.0; 3]] {
            assert!(!strictly_between(&v, &a, &b), "{v:?}");
        }
        assert!(!strictly_between(&a, &a, &a));
    }
}

/// ME-148
mod me_148 {
    use super::*;
    use isoracle::mesh::fast::exact::Dyadic;
    use isoracle::mesh::fast::sum::DyadicSum;
    use isoracle::mesh::fast::volume::volume;

    #[test]
    fn a_word_that_is_full_is_carried() {
        let mut sum = DyadicSum::default();
        for _ in 0..5 {
            sum.add(i128::MAX, -7);
            sum.add(i128::MIN, 3000);
        }
        let power =
            |e: i32| if e < 0 { Rational::from(1) >> e.unsigned_abs() } else { Rational::from(1) << e.unsigned_abs() };
        let expected = Rational::from(i128::MAX) * power(-7) + Rational::from(i128::MIN) * power(3000);
        assert_eq!(sum.total(), expected * 5);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn a_binary64_is_its_mantissa_and_exponent(x in extreme()) {
            let Dyadic { mantissa, exponent } = Dyadic::of(x);
            prop_assert!(mantissa == 0 || mantissa % 2 != 0);
            let power = Rational::from(1) << exponent.unsigned_abs();
            let value = if exponent < 0 { Rational::from(mantissa) / power } else { Rational::from(mantissa) * power };
            prop_assert_eq!(value, Rational::from_f64(x).expect("finite"));
        }

        #[test]
        fn volumes_are_the_sums_of_rationals(points in prop::collection::vec(point(extreme()), 4..9)) {
            let loops: Vec<Vec<u32>> = vec![vec![0, 1, 2], (0..points.len() as u32).collect(), vec![3, 2], vec![]];
            let mesh = polygons(&points, &loops);
            let exact: Vec<_> = points.iter().map(exact).collect();
            let fans = loops.iter().flat_map(|l| (2..l.len()).map(move |i| [l[0], l[i - 1], l[i]]));
            let six = fans.map(|t| determinant3(&Matrix(t.map(|v| exact[v as usize].clone().0)))).fold(Rational::new(), |s, d| s + d);
            prop_assert_eq!(volume(&mesh), six / 6);
        }
    }
}

/// ME-149
mod me_149 {
    use super::*;
    use isoracle::mesh::fast::between::junctions;
    use isoracle::mesh::fast::exact::strictly_between;

    fn by_trial(points: &[Point], edges: &[[u32; 2]]) -> Vec<(u32, [u32; 2])> {
        let all = (0..points.len() as u32).flat_map(|v| edges.iter().map(move |&edge| (v, edge)));
        let inside = |(v, [a, b]): &(u32, [u32; 2])| {
            let [v, a, b] = [v, a, b].map(|&i| &points[i as usize]);
            strictly_between(v, a, b)
        };
        let mut found: Vec<_> = all.filter(|(v, edge)| !edge.contains(v)).filter(inside).collect();
        found.sort_unstable();
        found
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(150))]

        #[test]
        fn the_tree_finds_what_trial_finds(
            random in prop::collection::vec(point(random()), 2..40),
            planted in prop::collection::vec((any::<[prop::sample::Index; 2]>(), weight(), nudges()), 0..60),
            edges in prop::collection::vec(any::<[prop::sample::Index; 2]>(), 0..80),
            scale in prop::sample::select(vec![1.0, 1e-3, 2_f64.powi(80), 2_f64.powi(-300), 2_f64.powi(400)]),
        ) {
            // Half-way points, and their neighbours, of edges, and of the halves again.
            let mut points = random;
            let mut edges: Vec<[u32; 2]> = edges.iter().map(|pair| pair.each_ref().map(|i| i.index(points.len()) as u32)).collect();
            for (ends, weight, nudge) in planted {
                let [a, b] = ends.map(|i| i.index(points.len()));
                edges.push([a as u32, b as u32]);
                points.push(near([points[a], points[b], points[a]], weight, 0.0, nudge));
            }
            points.iter_mut().flatten().for_each(|x| *x *= scale);
            edges.retain(|[a, b]| a != b);
            edges.iter_mut().for_each(|edge| edge.sort_unstable());
            edges.sort_unstable();
            edges.dedup();
            let all = 0..points.len() as u32;
            prop_assert_eq!(junctions(&points, all, &edges, usize::MAX), (by_trial(&points, &edges), true));
        }
    }

    #[test]
    fn a_long_diagonal_meets_every_vertex_on_it() {
        // 0 … 1000 on the diagonal, and as many beside it by one unit in the last place.
        let mut points: Vec<Point> = (0..=1000).map(|i| [f64::from(i); 3]).collect();
        points.extend((1..1000).map(|i| [f64::from(i), f64::from(i).next_up(), f64::from(i)]));
        let edges: Vec<[u32; 2]> = (0..9).map(|i| [i, 1000 - i]).collect();
        let all = || 0..points.len() as u32;
        let (found, complete) = junctions(&points, all(), &edges, usize::MAX);
        assert!(complete);
        assert_eq!(found.len(), (0..9).map(|i| 999 - 2 * i).sum::<usize>());
        let (some, complete) = junctions(&points, all(), &edges, 100);
        assert!(!complete && some.len() == 100 && some.iter().all(|one| found.binary_search(one).is_ok()));
    }
}

/// ME-152
mod me_152 {
    use super::*;
    use isoracle::mesh::fast::area::{Area, WORD_BITS, area};
    use isoracle::mesh::fast::shape::doubled_vector_area;
    use isoracle::number::{Interval, Ring, Surd};

    /// Points of one kind: a fine grid and binary32, whose areas fit machine words, and others, whose do not.
    fn faces() -> impl Strategy<Value = Vec<Point>> {
        let grid = (-4096..4097_i32).prop_map(|n| f64::from(n) / 64.0);
        let binary32 = (-1.0..1.0_f32).prop_map(f64::from);
        prop_oneof![
            2 => prop::collection::vec(point(grid), 3..7),
            2 => prop::collection::vec(point(binary32), 3..7),
            1 => prop::collection::vec(point(random()), 3..7),
            1 => prop::collection::vec(point(extreme()), 3..7),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn areas_are_enclosed_as_narrowly_as_stated(
            points in faces(), bits in prop::sample::select(vec![WORD_BITS, 80, 200]),
        ) {
            let loops: Vec<Vec<u32>> = vec![vec![0, 1, 2], (0..points.len() as u32).collect()];
            let Area { lo, hi } = area(&polygons(&points, &loops), bits);
            let faces = loops.iter().map(|l| l.iter().map(|&v| points[v as usize]).collect::<Vec<_>>());
            let squares: Vec<Rational> = faces.map(|f| doubled_vector_area(&f).norm_squared()).collect();
            let roots = squares.iter().map(|s| Interval::from_rational(s, 400).sqrt().expect("a sum of squares"));
            let (least, most) = roots.fold(Interval::integer(0), |sum, root| sum + &root).bounds().expect("finite");
            let (least, most) = (least / 2, most / 2);
            prop_assert!(lo <= most && least <= hi, "{lo} {hi} {least}");
            let width = Rational::from(&hi - &lo);
            prop_assert!(width <= Rational::from(&most >> (bits - 1)), "{width}");
            let rational = squares.iter().all(|s| Surd::sqrt(s).expect("a sum of squares").rational().is_some());
            prop_assert_eq!(lo == hi, rational);
        }
    }

    #[test]
    fn rational_areas_are_exact() {
        let cube = crate::fast::flat(&isoracle::mesh::examples::cube());
        let six = Area { lo: Rational::from(6), hi: Rational::from(6) };
        assert_eq!([area(&cube, WORD_BITS), area(&cube, 300)], [six.clone(), six]);
        // 3-4-5: (0, 0, 0), (1, 0, 0), (0, 4, 3) has the area 5/2.
        let slanted = polygons(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 4.0, 3.0]], &[vec![0, 1, 2]]);
        assert_eq!(check(&slanted, |_| {}).area, Some(Area { lo: Rational::from((5, 2)), hi: Rational::from((5, 2)) }));
    }
}
