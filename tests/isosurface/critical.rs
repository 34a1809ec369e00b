//! Critical values of faces and cells, and ties.

use crate::cells::same;
use crate::domain::*;
use isoracle::isosurface::cell::{Degenerate, Tie, assemble, decide, decisions, topology};
use isoracle::isosurface::critical::{BilinearCritical, TrilinearCritical, bilinear_critical, trilinear_critical};
use isoracle::isosurface::cube::{Corner, Face};
use isoracle::isosurface::multilinear::{bilinear_gradient, trilinear, trilinear_gradient};
use isoracle::isosurface::square::{DegenerateSquare, contour};
use isoracle::isosurface::subdivision::{degenerate, topology as subdivide};
use isoracle::number::{Integer, OrderedField, Rational, Ring, Sign, Surd};
use proptest::prelude::*;
use rayon::prelude::*;

fn surd(x: &Rational) -> Surd {
    Surd::from(x.clone())
}

/// Every critical value of the cell: of its corners, of its faces' saddles, and of f wherever in space its gradient vanishes.
fn critical_values(values: &[Rational; 8]) -> Vec<Surd> {
    let mut found: Vec<Surd> = values.iter().map(surd).collect();
    for face in Face::ALL {
        let [a, b, d, c] = face.cycle();
        if let BilinearCritical::Saddle(saddle) = bilinear_critical(&[a, b, c, d].map(|c| values[c.index()].clone())) {
            found.push(surd(&saddle.value));
        }
    }
    match trilinear_critical(values) {
        TrilinearCritical::None | TrilinearCritical::Everywhere => {}
        TrilinearCritical::Point(point) | TrilinearCritical::Line { point, .. } => found.push(surd(&point.value)),
        TrilinearCritical::ThreeLines(centre) | TrilinearCritical::Hyperbola { centre, .. } => {
            found.push(surd(&centre.value));
        }
        TrilinearCritical::Pair(points) => found.extend(points.map(|point| point.value)),
    }
    found
}

mod is_86 {
    use super::*;

    /// 1/ε such that no critical value lies in [−ε, 0): −ε and all isovalues between it and 0 have one topology.
    const INVERSE: i64 = 1000;

    fn is_between(values: &[Rational; 8]) -> bool {
        let (low, zero) = (surd(&q(-1, INVERSE)), surd(&Rational::new()));
        critical_values(values).iter().any(|value| low <= *value && *value < zero)
    }

    #[test]
    fn the_tie_rule_is_the_isovalue_just_below() {
        let ties = all::<8>(&[-1, 0, 1])
            .filter(|values| {
                let g = rationals(values);
                assert!(!is_between(&g), "{values:?}");
                let below = topology(&g, &Rational::new(), Tie::Below).expect("ties are broken");
                let at = topology(&g, &q(-1, INVERSE), Tie::Degenerate).expect("not a critical value");
                assert_eq!(below, at, "{values:?}");
                // The same by a way that knows nothing of infinitesimals.
                let raised = values.map(|v| v * INVERSE + 1);
                let shown = subdivide(&words(&raised), 60).expect("60 cuts suffice");
                assert!(same(&below, &shown), "{values:?}: {below:?}, {shown:?}");
                // Reported, unless ties are broken; where there is none, both rules say the same.
                let strict = topology(&g, &Rational::new(), Tie::Degenerate);
                assert_eq!(strict.as_ref().err(), degenerate(&g).as_ref(), "{values:?}");
                if let Ok(strict) = &strict {
                    assert_eq!(*strict, below);
                }
                strict.is_err()
            })
            .count();
        // Each with a corner at 0, and those of ±1 with a tie on a face or inside.
        assert!(ties >= 6561 - 256);
    }

    #[test]
    fn a_value_at_c_is_outside_and_a_saddle_at_c_joins_the_outside() {
        all::<8>(&[-1, 0, 1]).for_each(|values| {
            let below = decisions(&rationals(&values), &Rational::new(), Tie::Below).expect("ties are broken");
            for c in Corner::ALL {
                assert_eq!(below.is_positive(c), values[c.index()] >= 0);
            }
            for face in Face::ALL {
                let [a, b, c, d] = face.cycle().map(|c| values[c.index()]);
                let alternates = a * c > 0 && b * d > 0 && a * b < 0;
                if alternates && a * c == b * d {
                    assert_eq!(below.faces[face.index()], 1, "{values:?}");
                }
            }
        });
    }

    #[test]
    fn a_tie_inside_counts_as_outside() {
        let case = |values: [i64; 8]| {
            let cell = topology(&rationals(&values), &Rational::new(), Tie::Below).expect("ties are broken");
            cell.case.name()
        };
        assert_eq!(case([-3, 1, 1, 1, 1, 1, 1, -3]), "4.1");
        assert_eq!(case([3, -1, -1, -1, -1, -1, -1, 3]), "4.2");
    }

    #[test]
    fn a_sign_that_vanishes_for_every_epsilon_means_no_tunnel() {
        // f = u + v + w − c: D₂ and the discriminant vanish identically in c.
        for c in 0..=3 {
            let values: [i64; 8] = std::array::from_fn(|i| i64::from((i as u32).count_ones()) - c);
            let below = decisions(&rationals(&values), &Rational::new(), Tie::Below).expect("ties are broken");
            assert_eq!(below.tunnel, None);
        }
        let constant = topology(&rationals(&[0; 8]), &Rational::new(), Tie::Below).expect("ties are broken");
        assert_eq!((constant.case.name(), constant.positive.parts.len()), ("0", 1));
    }

    proptest! {
        #[test]
        fn next_to_a_critical_value_too(values in critical(), nudge in -1..=1i64) {
            let g = rationals(&values);
            let c = q(nudge, 1_000_000_000_000);
            let below = topology(&g, &c, Tie::Below).expect("ties are broken");
            let epsilon = q(1, 1_000_000_000_000_000_000);
            let low = Rational::from(&c - &epsilon);
            if critical_values(&g).iter().all(|value| *value < surd(&low) || *value >= surd(&c)) {
                prop_assert_eq!(below, topology(&g, &low, Tie::Degenerate).expect("not a critical value"));
            }
        }
    }
}

mod is_87 {
    use super::*;

    #[test]
    fn a_face_has_its_critical_value_iff_the_two_products_are_negative() {
        let values: Vec<i64> = (-3..=3).collect();
        let seen = all::<4>(&values)
            .filter(|g| {
                let [g00, g10, g01, g11] = *g;
                let has = (g01 - g00) * (g11 - g10) < 0 && (g10 - g00) * (g11 - g01) < 0;
                let inside = match bilinear_critical(&rationals(g)) {
                    BilinearCritical::None | BilinearCritical::Everywhere => None,
                    BilinearCritical::Saddle(saddle) => {
                        let is_inside = [&saddle.u, &saddle.v].iter().all(|x| **x > 0 && **x < 1);
                        let gradient = bilinear_gradient(&rationals(g), &[saddle.u.clone(), saddle.v.clone()]);
                        assert!(gradient.iter().all(Rational::is_zero));
                        is_inside.then_some(saddle)
                    }
                };
                assert_eq!(inside.is_some(), has, "{g:?}");
                let Some(saddle) = inside else { return false };
                let c = q(g00 * g11 - g10 * g01, g00 + g11 - g10 - g01);
                assert_eq!(saddle.value, c, "{g:?}");
                // At that isovalue the signs alternate, and the square and a cell with this face are degenerate there.
                assert_eq!(
                    contour(&rationals(g), &c, Tie::Degenerate),
                    Err(DegenerateSquare::Saddle { u: saddle.u.clone(), v: saddle.v.clone() })
                );
                let cell = rationals(&[g00, g10, g01, g11, 20, 20, 20, 20]);
                let point = [saddle.u, saddle.v, Rational::new()];
                let told = topology(&cell, &c, Tie::Degenerate);
                assert_eq!(told, Err(Degenerate::Face { face: Face::new(2, 0), point: Box::new(point) }));
                // On its two sides the face joins different pairs.
                let sides = [-1, 1].map(|s| {
                    let near = q(s, 100) + &c;
                    decisions(&cell, &near, Tie::Degenerate).expect("1/100 off a critical value").faces[4]
                });
                assert_eq!(sides, [1, -1], "{g:?}");
                true
            })
            .count();
        assert!(seen > 300);
    }
}

/// Cayley's hyperdeterminant, as printed.
fn hyperdeterminant(a: &[Rational; 8]) -> Rational {
    // a_ijk with i, j, k the coordinates: a[i + 2j + 4k].
    let [a000, a100, a010, a110, a001, a101, a011, a111] = a;
    let product = |factors: &[&Rational]| factors.iter().fold(Rational::from(1), |product, x| product * *x);
    let square = |x: &Rational, y: &Rational| product(&[x, x, y, y]);
    let squares = square(a000, a111) + square(a100, a011) + square(a010, a101) + square(a001, a110);
    let mixed = product(&[a000, a111, a100, a011])
        + product(&[a000, a111, a010, a101])
        + product(&[a000, a111, a001, a110])
        + product(&[a100, a011, a010, a101])
        + product(&[a100, a011, a001, a110])
        + product(&[a010, a101, a001, a110]);
    let fours = product(&[a000, a011, a101, a110]) + product(&[a111, a100, a010, a001]);
    squares - mixed * Rational::from(2) + fours * Rational::from(4)
}

/// k0, ku, kv, kw, kuv, kuw, kvw, e.
fn monomials(g: &[Rational; 8]) -> [Rational; 8] {
    let sum = |corners: [i32; 8]| (0..8).fold(Rational::new(), |sum, i| sum + Rational::from(&g[i] * corners[i]));
    [
        sum([1, 0, 0, 0, 0, 0, 0, 0]),
        sum([-1, 1, 0, 0, 0, 0, 0, 0]),
        sum([-1, 0, 1, 0, 0, 0, 0, 0]),
        sum([-1, 0, 0, 0, 1, 0, 0, 0]),
        sum([1, -1, -1, 1, 0, 0, 0, 0]),
        sum([1, -1, 0, 0, -1, 1, 0, 0]),
        sum([1, 0, -1, 0, -1, 0, 1, 0]),
        sum([-1, 1, 1, -1, 1, -1, -1, 1]),
    ]
}

mod is_88 {
    use super::*;

    /// D₁² − 4D₂D₀ along an axis, by D at 0, 1 and −1.
    fn discriminant(g: &[Rational; 8], axis: usize) -> Rational {
        let at = |w: i32| {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let value = |x: i32, y: i32| {
                let mut point = [0; 3];
                (point[u], point[v], point[axis]) = (x, y, w);
                trilinear(g, &point.map(Rational::from))
            };
            value(0, 0) * value(1, 1) - value(1, 0) * value(0, 1)
        };
        let [below, zero, above] = [at(-1), at(0), at(1)];
        let second = (Rational::from(&above + &below) - Rational::from(&zero * 2)) / 2;
        let first: Rational = (above - below) / 2;
        first.clone() * first - second * zero * Rational::from(4)
    }

    fn lowered(g: &[Rational; 8], c: &Rational) -> [Rational; 8] {
        g.each_ref().map(|v| Rational::from(v - c))
    }

    proptest! {
        #[test]
        fn the_discriminant_is_the_hyperdeterminant_along_each_axis(g in prop::array::uniform8(-30..=30i64)) {
            let g = rationals(&g);
            for axis in 0..3 {
                prop_assert_eq!(discriminant(&g, axis), hyperdeterminant(&g));
            }
        }

        #[test]
        fn it_is_quadratic_in_the_isovalue(values in prop::array::uniform8(-9..=9i64)) {
            let g = rationals(&values);
            let at = |c: i32| hyperdeterminant(&lowered(&g, &Rational::from(c)));
            let second = (at(1) + at(-1)) / 2 - at(0);
            let first = (at(1) - at(-1)) / Rational::from(2);
            let [_, ku, kv, kw, kuv, kuw, kvw, e] = monomials(&g);
            prop_assert_eq!(&second, &Rational::from(e.square_ref()));
            for c in [2, 3, -7] {
                let c = Rational::from(c);
                let value = (Rational::from(&second * &c) + &first) * &c + at(0);
                prop_assert_eq!(value, hyperdeterminant(&lowered(&g, &c)));
            }
            let product = |a: &Rational, b: &Rational| Rational::from(a * b);
            let alpha = product(&e, &ku) - product(&kuv, &kuw);
            let beta = product(&e, &kv) - product(&kuv, &kvw);
            let gamma = product(&e, &kw) - product(&kuw, &kvw);
            let minus_abc = -(product(&alpha, &beta) * &gamma);
            let discriminant = Rational::from(first.square_ref()) - product(&second, &at(0)) * Rational::from(4);
            prop_assert_eq!(discriminant, Rational::from(&minus_abc * 16));
            // The critical points, and their values.
            if e.is_zero() {
                return Ok(());
            }
            let points = trilinear_critical(&g);
            match minus_abc.cmp0() {
                std::cmp::Ordering::Less => prop_assert_eq!(points, TrilinearCritical::None),
                std::cmp::Ordering::Equal => {
                    let is_pair = matches!(points, TrilinearCritical::Pair(_));
                    prop_assert!(!is_pair);
                }
                std::cmp::Ordering::Greater => {
                    let TrilinearCritical::Pair(found) = points else { panic!("two points") };
                    let root = Surd::sqrt(&minus_abc).expect("not negative");
                    for sign in [1, -1] {
                        let sigma = root.clone() * &Surd::integer(sign);
                        let coordinate = |mixed: &Rational, of: &Rational| {
                            let over = Surd::from(Rational::from(-1) / of) * &sigma;
                            (over - &surd(mixed)) * &surd(&(Rational::from(1) / &e))
                        };
                        let point = [coordinate(&kvw, &alpha), coordinate(&kuw, &beta), coordinate(&kuv, &gamma)];
                        let gradient = trilinear_gradient(&g.each_ref().map(surd), &point);
                        prop_assert!(gradient.iter().all(|x| x.sign() == Sign::Zero));
                        let centre = [&kvw, &kuw, &kuv].map(|mixed| -Rational::from(mixed / &e));
                        let value = surd(&trilinear(&g, &centre))
                            - &(sigma * &surd(&(Rational::from(2) / Rational::from(e.square_ref()))));
                        prop_assert_eq!(&trilinear(&g.each_ref().map(surd), &point), &value);
                        let is_found = found.iter().any(|p| p.position == point && p.value == value);
                        prop_assert!(is_found);
                    }
                }
            }
        }

        #[test]
        fn planted_critical_points_have_hyperdeterminant_0_and_are_reported(values in critical()) {
            let told = decide(&integers(&values)).map(assemble);
            if let Err(Degenerate::Interior { point }) = topology(&rationals(&values), &Rational::new(), Tie::Degenerate) {
                prop_assert!(told.is_err());
                prop_assert!(hyperdeterminant(&rationals(&values)).is_zero());
                prop_assert!(trilinear(&rationals(&values), &point).is_zero());
                prop_assert!(trilinear_gradient(&rationals(&values), &point).iter().all(Rational::is_zero));
                prop_assert!(point.iter().all(|x| *x > 0 && *x < 1));
            }
        }
    }

    #[test]
    fn a_critical_point_inside_is_reported_and_a_vanishing_hyperdeterminant_alone_is_none() {
        let centre = [q(1, 2), q(1, 2), q(1, 2)];
        let told = topology(&rationals(&[-3, 1, 1, 1, 1, 1, 1, -3]), &Rational::new(), Tie::Degenerate);
        assert_eq!(told, Err(Degenerate::Interior { point: Box::new(centre) }));
        let plane = rationals(&[0, 1, 1, 2, 1, 2, 2, 3]);
        for c in [q(1, 2), q(3, 2), q(5, 2)] {
            assert!(hyperdeterminant(&lowered(&plane, &c)).is_zero());
            assert!(topology(&plane, &c, Tie::Degenerate).is_ok());
        }
    }

    #[test]
    fn a_tunnel_has_a_positive_hyperdeterminant() {
        let mut without = 0;
        for (decisions, values) in class_witnesses() {
            let is_positive = hyperdeterminant(&rationals(&values)) > 0;
            assert!(is_positive || decisions.tunnel.is_none(), "{values:?}");
            without += usize::from(is_positive && decisions.tunnel.is_none());
        }
        assert!(without > 0, "necessary, not sufficient");
    }
}

mod is_95 {
    use super::*;

    #[test]
    fn the_gradient_vanishes_where_it_is_said_to_and_at_no_other_point_of_a_lattice() {
        let lattice: Vec<[Rational; 3]> =
            (0..125).map(|code: i64| [code % 5, code / 5 % 5, code / 25].map(|n| q(n - 1, 2))).collect();
        all::<8>(&[-1, 0, 2]).step_by(7).for_each(|values| {
            let g = rationals(&values);
            let found = trilinear_critical(&g);
            for point in &lattice {
                let vanishes = trilinear_gradient(&g, point).iter().all(Rational::is_zero);
                assert_eq!(found.contains(point), vanishes, "{values:?} at {point:?}: {found:?}");
            }
        });
    }

    proptest! {
        #[test]
        fn a_planted_critical_point_is_found(
            coefficients in prop::array::uniform4(-3..=3i64), at in prop::array::uniform3(-9..=9i64), height in -5..=5i64
        ) {
            // f = k·XYZ + a·YZ + b·XZ + c·XY + height, in X = x − at/4 and so on.
            let [k, a, b, c] = coefficients;
            let point = at.map(|n| q(n, 4));
            let g: [Rational; 8] = std::array::from_fn(|i| {
                let [x, y, z] = [0, 1, 2].map(|axis| Rational::from(i >> axis & 1) - &point[axis]);
                let term = |k: i64, factors: &[&Rational]| factors.iter().fold(Rational::from(k), |p, f| p * *f);
                term(k, &[&x, &y, &z]) + term(a, &[&y, &z]) + term(b, &[&x, &z]) + term(c, &[&x, &y]) + term(height, &[])
            });
            let found = trilinear_critical(&g);
            prop_assert!(found.contains(&point), "{:?}", found);
            let value = match found {
                TrilinearCritical::None => panic!("there is one"),
                TrilinearCritical::Everywhere => Rational::from(height),
                TrilinearCritical::Point(p) | TrilinearCritical::Line { point: p, .. } => p.value,
                TrilinearCritical::ThreeLines(p) | TrilinearCritical::Hyperbola { centre: p, .. } => p.value,
                TrilinearCritical::Pair(points) => {
                    let here = points.into_iter().find(|p| p.position.iter().zip(&point).all(|(x, y)| *x == surd(y)));
                    here.expect("it is one of the two").value.rational().expect("rational").clone()
                }
            };
            prop_assert_eq!(value, Rational::from(height));
            prop_assert_eq!(Integer::from(height), trilinear(&g, &point));
        }
    }
}
