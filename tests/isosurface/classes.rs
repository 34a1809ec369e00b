//! The labelled classes of cells, and their names.

use crate::domain::*;
use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Decisions, Join, assemble, decide};
use isoracle::isosurface::classes::{classes, face_classes, tunnels};
use isoracle::isosurface::cube::{Corner, Face, Symmetry};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A class carried by a symmetry, with signs exchanged or not.
fn carry(class: &Decisions, symmetry: Symmetry, exchange: bool) -> Decisions {
    let positive = symmetry.corners(class.positive);
    let mut faces = [0; 6];
    for face in Face::ALL {
        faces[symmetry.face(face).index()] = class.faces[face.index()];
    }
    let mut image = Decisions { positive, faces, tunnel: None };
    if exchange {
        image = Decisions { positive: !positive, faces: faces.map(|s| -s), tunnel: None };
    }
    let mut parts = image.boundary_parts();
    image.tunnel = class.tunnel.map(|join| {
        let [a, b] = join.corners.map(|c| parts.find(symmetry.corner(c).index()));
        Join { corners: [Corner::ALL[a.min(b)], Corner::ALL[a.max(b)]] }
    });
    image
}

/// The symmetries of a group: rotations or all, with the exchange of signs or without.
fn group(reflections: bool, exchange: bool) -> Vec<(Symmetry, bool)> {
    let symmetries = Symmetry::all().into_iter().filter(|s| reflections || s.is_rotation());
    symmetries.flat_map(|s| [(s, false), (s, true)]).filter(|(_, e)| exchange || !e).collect()
}

/// The orbits, by the least element of each, and by Burnside's lemma.
fn orbits(classes: &BTreeSet<Decisions>, group: &[(Symmetry, bool)]) -> usize {
    let least = |class: &Decisions| group.iter().map(|(s, e)| carry(class, *s, *e)).min();
    let by_enumeration = classes.iter().map(least).collect::<BTreeSet<_>>().len();
    let fixed = |(s, e): &(Symmetry, bool)| classes.iter().filter(|class| carry(class, *s, *e) == **class).count();
    let fixed: usize = group.iter().map(fixed).sum();
    assert_eq!(fixed, by_enumeration * group.len(), "Burnside");
    by_enumeration
}

mod is_79 {
    use super::*;

    #[test]
    fn the_face_classes_are_those_that_cells_of_magnitudes_1_2_and_4_have() {
        let met = all::<8>(&[-4, -2, -1, 1, 2, 4])
            .filter_map(|values| decide(&words(&values)).ok())
            .fold(BTreeSet::new, |mut met, decisions| {
                met.insert(Decisions { tunnel: None, ..decisions });
                met
            })
            .reduce(BTreeSet::new, |mut a, b| {
                a.extend(b);
                a
            });
        assert_eq!(met, face_classes().into_iter().collect());
        assert_eq!(met.len(), 620);
    }

    #[test]
    fn in_case_13_products_over_opposite_faces_are_one_number() {
        // exp(L) of a face: the product at its positive corners over that at its negative ones. For each axis the two faces
        // have all corners, so that both cannot exceed 1 for one axis and fall short of it for another.
        let ratio = |values: &[i64; 8], corners: &[Corner]| {
            corners.iter().fold(q(1, 1), |ratio, c| match values[c.index()] {
                v if v > 0 => ratio * q(v, 1),
                v => ratio / q(-v, 1),
            })
        };
        all::<4>(&[1, 2, 3, 5]).for_each(|m| {
            let values = [m[0], -m[1], -m[2], m[3], -m[1] - 1, m[2], m[0] + 2, -m[3]];
            for axis in 0..3 {
                let sides = [0, 1].map(|side| ratio(&values, &Face::new(axis, side).cycle()));
                assert_eq!(sides[0].clone() * &sides[1], ratio(&values, &Corner::ALL));
                if let Ok(decisions) = decide(&words(&values)) {
                    for (side, ratio) in sides.iter().enumerate() {
                        assert_eq!(decisions.faces[2 * axis + side], if *ratio > 1 { 1 } else { -1 });
                    }
                }
            }
        });
    }

    #[test]
    fn case_13_has_46_of_64_decisions() {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for class in face_classes().iter().filter(|class| class.faces.iter().all(|s| *s != 0)) {
            *counts.entry(Case::of(class).name()).or_default() += 1;
        }
        // Of two configurations of signs.
        let expected = [("13.1", 2), ("13.2", 12), ("13.3", 24), ("13.4", 4), ("13.5.1", 4)];
        assert_eq!(counts, expected.map(|(name, count)| (name, 2 * count)).into());
    }
}

mod is_80 {
    use super::*;

    #[test]
    fn numbers_of_classes() {
        let faces: BTreeSet<Decisions> = face_classes().into_iter().collect();
        let signs = (0..=255).map(|positive| Decisions { positive, faces: [0; 6], tunnel: None }).collect();
        let tunnels: BTreeSet<Decisions> = classes().into_iter().collect();
        let counts = [signs, faces, tunnels].map(|classes: BTreeSet<Decisions>| {
            let of = |reflections, exchange| orbits(&classes, &group(reflections, exchange));
            [classes.len(), of(false, false), of(false, true), of(true, false), of(true, true)]
        });
        assert_eq!(counts, [[256, 23, 15, 22, 14], [620, 45, 27, 43, 25], [768, 57, 33, 55, 31]]);
    }
}

mod is_81 {
    use super::*;

    #[test]
    fn every_class_has_a_cell_and_every_cell_a_class() {
        let classes: BTreeSet<Decisions> = classes().into_iter().collect();
        assert_eq!(class_witnesses().into_keys().collect::<BTreeSet<_>>(), classes);
        // Three magnitudes with room for tunnels, and more in the long form.
        let magnitudes: &[i64] = if is_long() { &[-7, -3, -2, -1, 1, 2, 3, 7] } else { &[-4, -2, -1, 1, 2, 4] };
        let tunnels = all::<8>(magnitudes)
            .filter_map(|values| decide(&words(&values)).ok())
            .filter(|decisions| {
                assert!(classes.contains(decisions), "{decisions:?}");
                decisions.tunnel.is_some()
            })
            .count();
        assert!(tunnels > 300, "{tunnels}");
    }

    #[test]
    fn a_hundred_and_forty_eight_classes_of_six_cases_have_a_tunnel() {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        let mut rims: BTreeMap<&str, BTreeSet<Vec<usize>>> = BTreeMap::new();
        for class in classes().into_iter().filter(|class| class.tunnel.is_some()) {
            let cell = assemble(class);
            *counts.entry(cell.case.name()).or_default() += 1;
            let annulus = cell.components.iter().find(|c| c.chi == 0).expect("an annulus");
            let mut lengths: Vec<usize> = annulus.loops.iter().map(|&l| cell.loops[l].len()).collect();
            lengths.sort();
            rims.entry(cell.case.name()).or_default().insert(lengths);
        }
        let expected = [("4.2", 8), ("6.1.2", 48), ("7.4.2", 16), ("10.1.2", 12), ("12.1.2", 48), ("13.5.2", 16)];
        assert_eq!(counts, expected.into());
        let expected = [
            ("4.2", [3, 3]),
            ("6.1.2", [3, 4]),
            ("7.4.2", [3, 6]),
            ("10.1.2", [4, 4]),
            ("12.1.2", [3, 5]),
            ("13.5.2", [3, 6]),
        ];
        assert_eq!(rims, expected.map(|(name, lengths)| (name, BTreeSet::from([lengths.to_vec()]))).into());
    }

    #[test]
    fn thirteen_five_has_two_tunnels_of_opposite_sign() {
        let mut two = 0;
        for class in face_classes() {
            let tunnels = tunnels(&class);
            assert!(tunnels.len() <= 2);
            if let [a, b] = tunnels[..] {
                two += 1;
                assert_eq!(Case::of(&class), Case::C13_5_1);
                assert_ne!(class.is_positive(a.corners[0]), class.is_positive(b.corners[0]));
            }
        }
        assert_eq!(two, 8);
    }

    #[test]
    fn ten_one_and_twelve_one_have_a_tunnel_with_either_decision() {
        for case in [Case::C10_1_2, Case::C12_1_2] {
            let own = classes().into_iter().filter(|class| Case::of(class) == case);
            let decisions: BTreeSet<Vec<i8>> =
                own.map(|class| class.faces.iter().copied().filter(|s| *s != 0).collect()).collect();
            assert_eq!(decisions, BTreeSet::from([vec![-1, -1], vec![1, 1]]));
        }
    }
}

mod is_82 {
    use super::*;

    type Vector = [i32; 3];

    fn position(c: usize) -> Vector {
        [c & 1, c >> 1 & 1, c >> 2 & 1].map(|x| x as i32)
    }

    fn minus(a: Vector, b: Vector) -> Vector {
        [0, 1, 2].map(|i| a[i] - b[i])
    }

    fn det(a: Vector, b: Vector, c: Vector) -> i32 {
        (0..3).map(|i| a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3])).sum()
    }

    fn adjacent(a: usize, b: usize) -> bool {
        (a ^ b).is_power_of_two()
    }

    /// The name as the entry has it, from M, J and T.
    fn name(class: &Decisions) -> &'static str {
        let corners =
            |sign: bool| -> Vec<usize> { (0..8).filter(|&c| (class.positive >> c & 1 == 1) == sign).collect() };
        let t = corners(true).len() <= 4;
        let m = corners(t);
        let sign = if t { 1 } else { -1 };
        let j: Vec<i8> = class.faces.iter().copied().filter(|s| *s != 0).collect();
        let tunnel = class.tunnel.is_some();
        let choose = |with, without| if tunnel { with } else { without };
        let degree = |c: usize| m.iter().filter(|&&d| adjacent(c, d)).count();
        let degrees: Vec<usize> = m.iter().map(|&c| degree(c)).collect();
        let edges = degrees.iter().sum::<usize>() / 2;
        match (m.len(), edges) {
            (0, _) => "0",
            (1, _) => "1",
            (2, 1) => "2",
            (2, _) if (m[0] ^ m[1]).count_ones() == 2 => {
                if j == [sign] {
                    "3.2"
                } else {
                    "3.1"
                }
            }
            (2, _) => choose("4.2", "4.1"),
            (3, 2) => "5",
            (3, 1) => {
                if j == [sign] {
                    "6.2"
                } else {
                    choose("6.1.2", "6.1.1")
                }
            }
            (3, _) => match j.iter().filter(|s| **s == sign).count() {
                0 => "7.1",
                1 => "7.2",
                2 => "7.3",
                _ => choose("7.4.2", "7.4.1"),
            },
            (_, 4) => "8",
            (_, 3) if degrees.contains(&3) => "9",
            (_, 3) => {
                let mut path = vec![m[degrees.iter().position(|d| *d == 1).expect("a path has an end")]];
                while let Some(&next) = m.iter().find(|c| !path.contains(c) && adjacent(**c, path[path.len() - 1])) {
                    path.push(next);
                }
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| position(path[i]));
                if det(minus(b, a), minus(c, b), minus(d, c)) > 0 { "11" } else { "14" }
            }
            (_, 2) if !degrees.contains(&2) => {
                if j[0] != j[1] {
                    "10.2"
                } else {
                    choose("10.1.2", "10.1.1")
                }
            }
            (_, 2) if j[0] == j[1] => choose("12.1.2", "12.1.1"),
            (_, 2) => {
                // The normals of the faces joined ±, and among the corners of sign ± the isolated one.
                let normal = |s: i8| {
                    let face = class.faces.iter().position(|x| *x == s).expect("one face joins each");
                    let mut normal = [0; 3];
                    normal[face / 2] = if face % 2 == 1 { 1 } else { -1 };
                    normal
                };
                let isolated = |s: bool| {
                    let own = corners(s);
                    let alone = own.iter().find(|c| own.iter().all(|d| !adjacent(**c, *d)));
                    position(*alone.expect("a path of 3 and a point"))
                };
                let turn = det(normal(-1), normal(1), minus(isolated(true), isolated(false)));
                if turn > 0 { "12.2" } else { "12.3" }
            }
            (_, _) => match j.iter().map(|s| i32::from(*s)).sum::<i32>().abs() {
                6 => "13.1",
                4 => "13.2",
                2 => "13.3",
                _ => {
                    let common = (0..8).find(|&c| {
                        (0..6).filter(|&f| class.faces[f] == 1).all(|f| position(c)[f / 2] == (f % 2) as i32)
                    });
                    let corner = common.expect("in 13.4 and 13.5 the three faces that join + meet in a corner");
                    if class.positive >> corner & 1 == 1 { "13.4" } else { choose("13.5.2", "13.5.1") }
                }
            },
        }
    }

    #[test]
    fn the_names_are_those_of_the_entry() {
        for class in classes() {
            assert_eq!(Case::of(&class).name(), name(&class), "{class:?}");
        }
    }

    #[test]
    fn each_of_the_33_orbits_has_a_name_of_its_own() {
        let group = group(false, true);
        let mut names: BTreeMap<Decisions, BTreeSet<&str>> = BTreeMap::new();
        for class in classes() {
            let orbit = group.iter().map(|(s, e)| carry(&class, *s, *e)).min().expect("a group has an element");
            names.entry(orbit).or_default().insert(Case::of(&class).name());
        }
        assert!(names.values().all(|of_one| of_one.len() == 1));
        assert_eq!(names.values().flatten().collect::<BTreeSet<_>>().len(), 33);
        assert_eq!(names.len(), 33);
    }

    #[test]
    fn reflections_exchange_11_with_14_and_12_2_with_12_3_and_keep_the_rest() {
        let mirror = Symmetry::all().into_iter().find(|s| !s.is_rotation()).expect("24 of 48 are none");
        for class in classes() {
            let expected = match Case::of(&class) {
                Case::C11 => Case::C14,
                Case::C14 => Case::C11,
                Case::C12_2 => Case::C12_3,
                Case::C12_3 => Case::C12_2,
                case => case,
            };
            assert_eq!(Case::of(&carry(&class, mirror, false)), expected);
        }
    }
}
