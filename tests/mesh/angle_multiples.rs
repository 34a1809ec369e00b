//! Sums of angles, exactly: those of a triangle, and which are rational multiples of π: ME-122 … ME-124.

use isoracle::linear::Vector;
use isoracle::mesh::angle_deficit::{AngleMesh, CornerAngle, half_turns, multiple_of_pi};
use isoracle::number::{Interval, Rational, Ring, Sign};
use proptest::prelude::*;

const BITS: u32 = 320;

fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

fn angle(x: i64, n: i64) -> CornerAngle {
    CornerAngle { x: q(x, 1), n: q(n, 1) }
}

fn sum_of_enclosures(angles: &[CornerAngle]) -> Interval {
    angles.iter().fold(Interval::integer(0), |sum, a| sum + &a.enclosure(BITS))
}

fn times(x: &Interval, k: i64) -> Interval {
    x.clone() * &Interval::integer(k)
}

/// The integer in the interval x/π, if there is one; measured, not proved.
fn near_integer(x: &Interval) -> Option<Rational> {
    let (lo, hi) = x.checked_div(&Interval::pi(BITS)).expect("π > 0").bounds().expect("finite");
    let integer = lo.ceil();
    (integer <= hi).then_some(integer)
}

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

fn small_rational() -> impl Strategy<Value = Rational> {
    (-9_i64..=9, 1_i64..=9).prop_map(|(n, d)| q(n, d))
}

/// Points of which three are often nearly on one line.
fn corners() -> impl Strategy<Value = [Vector<Rational, 3>; 3]> {
    let tiny = (-1_i64..=1, 1_u32..120).prop_map(|(sign, bits)| Rational::from(sign) >> bits);
    let coordinate = (small_rational(), tiny).prop_map(|(x, hair)| x + hair);
    prop::array::uniform3(prop::array::uniform3(coordinate).prop_map(Vector))
}

mod me_122 {
    use super::*;

    proptest! {
        #[test]
        fn the_product_of_a_triangles_directions_is_real_and_negative(corners in corners(), hair in 1_u32..200) {
            let mesh = AngleMesh::new(corners.to_vec(), vec![[0, 1, 2]]);
            prop_assume!(mesh.is_ok());
            let angles = mesh.expect("just asked").angles(0);
            prop_assert_eq!(half_turns(&angles), Some(1));
            prop_assert_eq!(multiple_of_pi(&angles), Some(q(1, 1)));
            prop_assert_eq!(near_integer(&sum_of_enclosures(&angles)), Some(q(1, 1)));
            // By the sides alone: the law of cosines, and 16·area² of Heron.
            let squared = |i: usize, j: usize| (corners[i].clone() - &corners[j]).norm_squared();
            for (place, angle) in angles.iter().enumerate() {
                let [i, j, k] = [0, 1, 2].map(|n| (place + n) % 3);
                let (a, b, c) = (squared(j, k), squared(k, i), squared(i, j));
                let x: Rational = (Rational::from(&b + &c) - a) / 2;
                let product = b * c;
                prop_assert_eq!(&angle.n, &(Rational::from(&product) - Rational::from(x.square_ref())));
                prop_assert_eq!(angle.cos_squared(), Rational::from(x.square_ref()) / product);
                prop_assert_eq!(angle.cos_sign(), Sign::of(x.cmp0()));
                prop_assert_eq!(&angle.x, &x);
            }
            // A hair away, nothing sums up to a multiple of π.
            let [a, b, mut c] = angles;
            c.x += Rational::from(1) >> hair;
            prop_assert_eq!(half_turns(&[a.clone(), b.clone(), c.clone()]), None);
            prop_assert_ne!(multiple_of_pi(&[a, b, c]), Some(q(1, 1)));
        }
    }

    #[test]
    fn three_directions_of_one_radicand_sum_up_to_what_their_enclosures_say() {
        let (mut once, mut twice) = (0, 0);
        let triples = (-6..=6).flat_map(|a| (a..=6).flat_map(move |b| (b..=6).map(move |c| [a, b, c])));
        for (x, n) in triples.flat_map(|x| (1..=12).map(move |n| (x, n))) {
            let angles = x.map(|x| angle(x, n));
            let near = near_integer(&sum_of_enclosures(&angles));
            let found = half_turns(&angles);
            assert_eq!(found.map(Rational::from), near, "{x:?}, {n}");
            once += u32::from(found == Some(1));
            twice += u32::from(found == Some(2));
        }
        assert_eq!(once, twice, "the supplements of three angles that sum up to π sum up to 2π");
        assert!(once > 20, "{once}");
    }
}

mod me_123 {
    use super::*;

    /// a + b s + c t + d st with s² = −M, t² = −N: a field iff MN is no square.
    #[derive(Clone, PartialEq, Debug)]
    struct Biquadratic([Rational; 4]);

    impl Biquadratic {
        fn times(&self, other: &Biquadratic, [m, n]: [i64; 2]) -> Biquadratic {
            let mut product = [(); 4].map(|()| Rational::new());
            for (i, x) in self.0.iter().enumerate() {
                for (j, y) in other.0.iter().enumerate() {
                    // The bits of an index are the exponents of s and t.
                    let s = if i & j & 1 == 1 { -m } else { 1 };
                    let t = if i & j & 2 == 2 { -n } else { 1 };
                    product[i ^ j] += Rational::from(x * y) * (s * t);
                }
            }
            Biquadratic(product)
        }

        fn to_the_24th(&self, radicands: [i64; 2]) -> Biquadratic {
            let square = |u: &Biquadratic| u.times(u, radicands);
            let eighth = square(&square(&square(self)));
            square(&eighth).times(&eighth, radicands)
        }

        fn one() -> Biquadratic {
            Biquadratic([q(1, 1), q(0, 1), q(0, 1), q(0, 1)])
        }
    }

    /// exp(2iβ) = (x + √−N)²/(x² + N), √−N being s or t.
    fn doubled(x: i64, n: i64, root: usize) -> Biquadratic {
        let mut parts = [q(x * x - n, x * x + n), q(0, 1), q(0, 1), q(0, 1)];
        parts[root] = q(2 * x, x * x + n);
        Biquadratic(parts)
    }

    fn is_square(n: i64) -> bool {
        (0..=n).any(|r| r * r == n)
    }

    /// By algebra in the field of both roots: its roots of unity are those of order 1, 2, 3, 4, 6, 8, 12 and 24, all of
    /// whose 24th powers are 1; there are no others in a field of degree 4 with a Galois group of exponent 2.
    #[test]
    fn two_angles_of_different_fields_sum_up_to_a_multiple_iff_the_24th_power_of_the_product_is_1() {
        let (mut multiples, mut others) = (0, 0);
        for (m, n) in (1..=12).flat_map(|m| (1..m).map(move |n| (m, n))).filter(|(m, n)| !is_square(m * n)) {
            for (x, y) in (-6..=6).flat_map(|x| (-6..=6).map(move |y| (x, y))) {
                let product = doubled(x, m, 1).times(&doubled(y, n, 2), [m, n]);
                let is_root_of_unity = product.to_the_24th([m, n]) == Biquadratic::one();
                let sum = multiple_of_pi(&[angle(x, m), angle(y, n)]);
                assert_eq!(sum.is_some(), is_root_of_unity, "{x} + √−{m}, {y} + √−{n}");
                if is_root_of_unity {
                    multiples += 1
                } else {
                    others += 1
                }
                // Two angles of each: the pairs by field, the product by the ring.
                let twice = product.times(&product, [m, n]);
                assert_eq!(
                    multiple_of_pi(&[angle(x, m), angle(y, n), angle(x, m), angle(y, n)]).is_some(),
                    twice.to_the_24th([m, n]) == Biquadratic::one()
                );
            }
        }
        assert!(multiples > 100 && others > 1000, "{multiples}, {others}");
    }

    /// Every multiset of three small directions. A sum said to be p/12·π is measured to be that, one said to be irrational
    /// is measured to be no p/q·π with q ≤ 40.
    #[test]
    fn three_angles_sum_up_to_a_multiple_iff_their_enclosures_meet_one() {
        let (most_x, most_n) = if is_long() { (4, 12) } else { (2, 7) };
        let angles: Vec<CornerAngle> =
            (-most_x..=most_x).flat_map(|x| (1..=most_n).map(move |n| angle(x, n))).collect();
        let enclosures: Vec<Interval> = angles.iter().map(|a| a.enclosure(BITS)).collect();
        let n = angles.len();
        let mut rational = 0;
        let multisets = (0..n).flat_map(|i| (i..n).flat_map(move |j| (j..n).map(move |k| [i, j, k])));
        for [i, j, k] in multisets {
            let sum = enclosures[i].clone() + &enclosures[j] + &enclosures[k];
            let found = multiple_of_pi(&[i, j, k].map(|i| angles[i].clone()));
            let measured = near_integer(&times(&sum, 12)).map(|n| n / 12);
            assert_eq!(found, measured, "{:?}", [i, j, k].map(|i| &angles[i]));
            match found {
                Some(_) => rational += 1,
                None if (i + j + k) % 20 == 0 || is_long() => {
                    assert!((1..=40).all(|q| near_integer(&times(&sum, q)).is_none()));
                }
                None => {}
            }
        }
        assert!(rational > 500, "{rational}");
    }

    /// arctan(1/k), and its supplement for −k.
    fn arctan_of_inverse(k: i64) -> CornerAngle {
        angle(k, 1)
    }

    /// The sum of p·arctan(1/k) in multiples of π, negative p taken as p times the supplement less π.
    fn machin(terms: &[(i64, i64)]) -> Option<Rational> {
        let angles: Vec<CornerAngle> =
            terms.iter().flat_map(|&(p, k)| (0..p.abs()).map(move |_| arctan_of_inverse(p.signum() * k))).collect();
        let supplements: i64 = terms.iter().filter(|(p, _)| *p < 0).map(|(p, _)| -p).sum();
        multiple_of_pi(&angles).map(|sum| sum - supplements)
    }

    #[test]
    fn the_classical_relations_are_found_and_no_others_beside_them() {
        assert_eq!(multiple_of_pi(&[angle(1, 1), angle(1, 4), angle(1, 9)]), Some(q(1, 1)), "arctan 1 + 2 + 3");
        assert_eq!(multiple_of_pi(&[angle(1, 1), angle(1, 4), angle(1, 16)]), None);
        let quarter = Some(q(1, 4));
        assert_eq!(machin(&[(1, 2), (1, 3)]), quarter, "Euler");
        assert_eq!(machin(&[(2, 2), (-1, 7)]), quarter, "Hermann");
        assert_eq!(machin(&[(2, 3), (1, 7)]), quarter, "Hutton");
        assert_eq!(machin(&[(4, 5), (-1, 239)]), quarter, "Machin");
        assert_eq!(machin(&[(1, 2), (1, 5), (1, 8)]), quarter, "Dase");
        assert_eq!(machin(&[(12, 18), (8, 57), (-5, 239)]), quarter, "Gauss");
        assert_eq!(machin(&[(6, 8), (2, 57), (1, 239)]), quarter, "Størmer");
        assert_eq!(machin(&[(44, 57), (7, 239), (-12, 682), (24, 12943)]), quarter, "Størmer");
        for wrong in [238, 240] {
            assert_eq!(machin(&[(4, 5), (-1, wrong)]), None);
            assert_eq!(machin(&[(44, 57), (7, wrong), (-12, 682), (24, 12943)]), None);
        }
        // Exhaustively: p·arctan(1/2) + r·arctan(1/7) with small p, r is a multiple of π iff p = −2r, for
        // 7 + i = (2 + i)²(1 − i), and no power of 2 + i has a multiple.
        for (p, r) in (-6..=6).flat_map(|p| (-3..=3).map(move |r| (p, r))) {
            assert_eq!(machin(&[(p, 2), (r, 7)]).is_some(), p + 2 * r == 0, "{p}, {r}");
        }
    }

    /// A flat disc of many thin triangles that stand in any order: sums on the way are numbers of many digits.
    #[test]
    fn a_full_turn_of_many_angles_in_any_order_is_found() {
        let count = if is_long() { 20_000 } else { 1_000 };
        let ray = |k: i64| [q(count - 2 * k, 1), q(k * k % 97 + 1, 1)];
        // Rays above the axis, from right to left, and those opposite: count angles, and count more, of a full turn.
        let between = |[a, b]: [Rational; 2], [c, d]: [Rational; 2]| {
            let x = Rational::from(&a * &c) + Rational::from(&b * &d);
            CornerAngle { x, n: (a * d - b * c).square() }
        };
        let mut rays: Vec<[Rational; 2]> = (0..=count).map(ray).collect();
        // Slopes are of no order: sort by cot.
        rays.sort_by_key(|[x, y]| -x.clone() / y);
        rays.dedup_by_key(|[x, y]| Rational::from(&*x / &*y));
        let opposite: Vec<[Rational; 2]> = rays.iter().map(|[x, y]| [-x.clone(), -y.clone()]).collect();
        let around = [&rays[..], &opposite, &rays[..1]].concat();
        let mut angles: Vec<CornerAngle> = around.windows(2).map(|w| between(w[0].clone(), w[1].clone())).collect();
        let n = angles.len();
        assert!(n > count as usize);
        for i in 0..n {
            angles.swap(i, i * 7919 % n);
        }
        assert_eq!(multiple_of_pi(&angles), Some(q(2, 1)));
        assert_ne!(multiple_of_pi(&angles[1..]), Some(q(2, 1)));
    }

    #[test]
    #[should_panic(expected = "N > 0")]
    fn a_flat_direction_is_no_angle() {
        multiple_of_pi(&[angle(1, 2), angle(1, 3), angle(1, 0)]);
    }

    #[test]
    fn corners_of_solids_and_tilings() {
        let many = |n: usize, a: CornerAngle| vec![a; n];
        assert_eq!(multiple_of_pi(&[]), Some(q(0, 1)));
        assert_eq!(multiple_of_pi(&many(3, angle(0, 5))), Some(q(3, 2)), "a cube's corner");
        for n in 1..=6 {
            assert_eq!(multiple_of_pi(&many(n, angle(1, 3))), Some(q(n as i64, 3)));
            assert_eq!(multiple_of_pi(&many(n, angle(-2, 12))), Some(q(2 * n as i64, 3)));
            assert_eq!(multiple_of_pi(&many(n, angle(-1, 1))), Some(q(3 * n as i64, 4)));
            assert_eq!(multiple_of_pi(&many(n, angle(3, 3))), Some(q(n as i64, 6)));
            assert_eq!(multiple_of_pi(&many(n, angle(-3, 3))), Some(q(5 * n as i64, 6)));
        }
        // Dihedral angles: of the tetrahedron arccos 1/3, of the octahedron arccos −1/3; no multiples, their sum is.
        let (tetrahedron, octahedron) = (angle(1, 8), angle(-1, 8));
        for n in 1..=30 {
            assert_eq!(multiple_of_pi(&many(n, tetrahedron.clone())), None);
        }
        let tiling = [tetrahedron.clone(), octahedron.clone(), tetrahedron.clone(), octahedron.clone()];
        assert_eq!(multiple_of_pi(&tiling), Some(q(2, 1)), "two and two fill the space around an edge");
        assert_eq!(multiple_of_pi(&[tetrahedron, angle(1, 2), angle(1, 2)]), Some(q(1, 1)), "arctan √8 + 2 arctan √2");
        // Twelve different fields at once, each with a right angle of two parts.
        let parts: Vec<CornerAngle> = (2..14).flat_map(|n| [angle(1, n), angle(n, n)]).collect();
        assert_eq!(multiple_of_pi(&parts), Some(q(6, 1)));
        assert_eq!(multiple_of_pi(&parts[..23]), None);
    }

    /// (a + b√−N)(c + d√−N).
    fn product([a, b]: &[Rational; 2], [c, d]: &[Rational; 2], n: &Rational) -> [Rational; 2] {
        let times = |x: &Rational, y: &Rational| Rational::from(x * y);
        [times(a, c) - times(b, d) * n, times(a, d) + times(b, c)]
    }

    /// Angles of one field, the last of them chosen so that all sum up to a planted multiple of π; their radicands differ
    /// by squares.
    fn planted() -> impl Strategy<Value = Vec<CornerAngle>> {
        // Directions (a, b), a + bi, of all half-lines at a multiple of the field's smallest angle, in [0, π), with
        // i = √−N/r, or b over √−3 = √−N/r.
        const PLAIN: &[[i64; 2]] = &[[1, 0], [0, 1]];
        const GAUSS: &[[i64; 2]] = &[[1, 0], [1, 1], [0, 1], [-1, 1]];
        const EISENSTEIN: &[[i64; 2]] = &[[1, 0], [3, 1], [1, 1], [0, 1], [-1, 1], [-3, 1]];
        let fields = prop::sample::select(vec![
            (1, 1, GAUSS),
            (4, 2, GAUSS),
            (9, 3, GAUSS),
            (3, 1, EISENSTEIN),
            (12, 2, EISENSTEIN),
            (2, 1, PLAIN),
            (5, 1, PLAIN),
            (6, 1, PLAIN),
            (8, 1, PLAIN),
        ]);
        let parts = prop::collection::vec((small_rational(), 1_i64..=9, 1_i64..=9), 1..8);
        (parts, fields, 0_usize..12).prop_map(|(parts, (n, r, units), unit)| {
            let radicand = q(n, 1);
            let [a, b] = units[unit % units.len()];
            let unit = [q(a, 1), q(b, r)];
            let mut angles = Vec::new();
            let mut closing = unit;
            for (x, r, s) in parts {
                // The conjugates' product turns back by what the angles turn.
                closing = product(&closing, &[x.clone(), q(-1, 1)], &radicand);
                let scale = q(r, s);
                let n = Rational::from(&radicand * &scale) * &scale;
                angles.push(CornerAngle { x: x * scale, n });
            }
            let [re, im] = closing;
            if !im.is_zero() {
                angles.push(CornerAngle { x: re / im, n: radicand });
            }
            angles
        })
    }

    proptest! {
        #[test]
        fn planted_multiples_of_several_fields_are_found_and_a_hair_beside_them_none(
            of_fields in prop::collection::vec(planted(), 1..4), rotation in 0_usize..24, hair in 1_u32..300
        ) {
            let mut angles: Vec<CornerAngle> = of_fields.into_iter().flatten().collect();
            let n = angles.len();
            angles.rotate_left(rotation % n);
            let measured = near_integer(&times(&sum_of_enclosures(&angles), 12)).map(|n| n / 12);
            prop_assert!(measured.is_some());
            prop_assert_eq!(multiple_of_pi(&angles), measured.clone());
            angles[0].x += Rational::from(1) >> hair;
            let beside = multiple_of_pi(&angles);
            prop_assert_ne!(&beside, &measured);
            if hair > 40 {
                prop_assert_eq!(beside, None);
            }
        }
    }
}

mod me_124 {
    use super::*;

    #[test]
    fn an_angle_of_rational_squared_cosine_is_a_multiple_iff_four_times_that_is_an_integer() {
        // If β is a rational multiple of π, 4cos²β = 2 + 2cos 2β is an algebraic integer, so an integer if rational.
        let most = if is_long() { 300 } else { 80 };
        for d in 1..=most {
            for p in 0..d {
                let cos_squared = q(p, d);
                for sign in [1, -1] {
                    // x²/(x² + N) = p/d with x = p, N = p(d − p); or x = 0.
                    let n = if p == 0 { d } else { p * (d - p) };
                    let found = angle(sign * p, n);
                    assert_eq!(found.cos_squared(), cos_squared);
                    let is_integer = Rational::from(&cos_squared * 4).is_integer();
                    let over_pi = multiple_of_pi(std::slice::from_ref(&found));
                    assert_eq!(over_pi.is_some(), is_integer, "{p}/{d}");
                    let measured = near_integer(&times(&found.enclosure(BITS), 12)).map(|n| n / 12);
                    assert_eq!(over_pi, measured);
                }
            }
        }
    }

    #[test]
    fn of_the_rational_cosines_between_minus_1_and_1_only_0_and_a_half_are_of_rational_parts_of_pi() {
        let most = if is_long() { 300 } else { 80 };
        for d in 1_i64..=most {
            for p in 1 - d..d {
                let expected = match (2 * p, d) {
                    (0, _) => Some(q(1, 2)),
                    (twice, d) if twice == d => Some(q(1, 3)),
                    (twice, d) if twice == -d => Some(q(2, 3)),
                    _ => None,
                };
                assert_eq!(multiple_of_pi(&[angle(p, d * d - p * p)]), expected, "arccos {p}/{d}");
            }
        }
    }

    #[test]
    fn a_hair_beside_each_of_the_seven_angles_there_is_none() {
        for (x, n, over_pi) in [
            (3, 3, q(1, 6)),
            (1, 1, q(1, 4)),
            (1, 3, q(1, 3)),
            (0, 1, q(1, 2)),
            (-1, 3, q(2, 3)),
            (-1, 1, q(3, 4)),
            (-3, 3, q(5, 6)),
        ] {
            assert_eq!(multiple_of_pi(&[angle(x, n)]), Some(over_pi));
            for bits in [10, 53, 54, 1000] {
                let hair: Rational = Rational::from(1) >> bits;
                for x in [q(x, 1) + hair.clone(), q(x, 1) - hair] {
                    assert_eq!(multiple_of_pi(&[CornerAngle { x, n: q(n, 1) }]), None);
                }
            }
        }
    }
}
