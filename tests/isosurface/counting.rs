//! IS-63 … IS-66: how many cases there are.

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::classes::{classes, face_classes};
use isoracle::isosurface::cube::{Corner, Edge, Symmetry};
use isoracle::isosurface::symmetry::{Group, burnside, orbits, sign_configurations};
use std::collections::BTreeSet;

const GROUPS: [Group; 5] =
    [Group::Trivial, Group::Rotations, Group::RotationsAndComplement, Group::RotationsAndReflections, Group::All];

/// The numbers of orbits under each of the groups, by enumeration and by Burnside's lemma.
fn counts(classes: &[isoracle::isosurface::cell::Decisions]) -> [usize; 5] {
    GROUPS.map(|group| {
        let orbits = orbits(classes, group);
        assert_eq!(burnside(classes, group), Some(orbits.len()), "{group:?}");
        assert_eq!(
            orbits.iter().map(Vec::len).sum::<usize>(),
            classes.len(),
            "the group maps the classes to themselves"
        );
        orbits.len()
    })
}

mod is_63 {
    use super::*;

    #[test]
    fn eight_corners_have_256_configurations_of_signs() {
        let configurations = sign_configurations();
        let signs: BTreeSet<[bool; 8]> = configurations.iter().map(|d| Corner::ALL.map(|c| d.is_positive(c))).collect();
        assert_eq!(signs.len(), 256);
        assert_eq!(configurations.len(), 1 << 8);
        assert!(signs.contains(&[true, false, false, true, false, false, false, true]));
    }
}

mod is_64 {
    use super::*;

    #[test]
    fn they_are_15_under_rotations_and_complement_and_not_under_reflections() {
        assert_eq!(counts(&sign_configurations()), [256, 23, 15, 22, 14]);
    }

    /// By cycles of the corners: an element leaves 2^cycles configurations; with the complement none, unless all
    /// cycles are even.
    #[test]
    fn burnside_by_cycles_says_the_same() {
        let mean = |reflections: bool, complement: bool| {
            let group: Vec<Symmetry> = Symmetry::all().into_iter().filter(|s| reflections || s.is_rotation()).collect();
            let fixed: usize = group
                .iter()
                .map(|symmetry| {
                    let mut cycles = Vec::new();
                    let mut left: BTreeSet<Corner> = Corner::ALL.into_iter().collect();
                    while let Some(start) = left.pop_first() {
                        let mut length = 1;
                        let mut at = symmetry.corner(start);
                        while at != start {
                            left.remove(&at);
                            at = symmetry.corner(at);
                            length += 1;
                        }
                        cycles.push(length);
                    }
                    let alternating = if cycles.iter().all(|n| n % 2 == 0) { 1 << cycles.len() } else { 0 };
                    (1 << cycles.len()) + if complement { alternating } else { 0 }
                })
                .sum();
            let order = group.len() * if complement { 2 } else { 1 };
            assert_eq!(fixed % order, 0);
            fixed / order
        };
        assert_eq!([mean(false, false), mean(false, true), mean(true, false), mean(true, true)], [23, 15, 22, 14]);
    }

    #[test]
    fn symmetries_are_the_rigid_motions_of_the_cube() {
        let all = Symmetry::all();
        let maps: BTreeSet<[Corner; 8]> = all.iter().map(|s| Corner::ALL.map(|c| s.corner(c))).collect();
        assert_eq!(maps.len(), 48);
        for symmetry in &all {
            for edge in Edge::ALL {
                let [a, b] = edge.corners().map(|c| symmetry.corner(c));
                assert!(Edge::between(a, b).is_some());
            }
            // The determinant of the linear part.
            let origin = symmetry.corner(Corner::at(0, 0, 0)).position().map(i32::from);
            let m = [Corner::at(1, 0, 0), Corner::at(0, 1, 0), Corner::at(0, 0, 1)].map(|c| {
                let image = symmetry.corner(c).position().map(i32::from);
                [0, 1, 2].map(|i| image[i] - origin[i])
            });
            let minor = |i: usize, j: usize| m[1][i] * m[2][j] - m[1][j] * m[2][i];
            let determinant = m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1);
            assert_eq!(symmetry.is_rotation(), determinant == 1);
        }
        assert_eq!(all.iter().filter(|s| s.is_rotation()).count(), 24);
    }
}

mod is_65 {
    use super::*;

    #[test]
    fn labelled_classes_are_33_under_rotations_and_complement_and_not_under_reflections() {
        assert_eq!(counts(&classes()), [768, 57, 33, 55, 31]);
        assert_eq!(counts(&face_classes()), [620, 45, 27, 43, 25]);
    }

    #[test]
    fn each_of_the_33_orbits_carries_one_name_and_each_name_one_orbit() {
        let names: Vec<BTreeSet<Case>> = orbits(&classes(), Group::RotationsAndComplement)
            .iter()
            .map(|orbit| orbit.iter().map(Case::of).collect())
            .collect();
        assert!(names.iter().all(|names| names.len() == 1));
        assert_eq!(names.into_iter().flatten().collect::<BTreeSet<_>>(), Case::ALL.iter().copied().collect());
        // Case 0 and 12.3 counted.
        assert_eq!(Case::ALL.len(), 33);
    }

    #[test]
    fn with_reflections_11_is_14_and_12_2_is_12_3() {
        let mut merged: Vec<Vec<&str>> = orbits(&classes(), Group::All)
            .iter()
            .map(|orbit| orbit.iter().map(Case::of).collect::<BTreeSet<_>>().into_iter().map(Case::name).collect())
            .filter(|names: &Vec<_>| names.len() > 1)
            .collect();
        merged.sort();
        assert_eq!(merged, [["11", "14"], ["12.2", "12.3"]]);
    }
}

mod is_66 {
    use super::*;

    #[test]
    fn more_than_730_is_768_and_730_in_tables_that_keep_one_entry_for_two_tunnels() {
        let classes = classes();
        assert_eq!(classes.len(), 768);
        assert_eq!(classes.iter().filter(|class| class.tunnel.is_some()).count(), 148);
        assert_eq!(classes.iter().filter(|class| class.tunnel.is_none()).count(), face_classes().len());
        // One entry a sign configuration for 10.1.2 and 12.1.2, one a face class for 13.5.2.
        let mut entries = BTreeSet::new();
        for class in &classes {
            let case = Case::of(class);
            let entry = match case {
                Case::C10_1_2 | Case::C12_1_2 => (case, class.positive, [0; 6], None),
                Case::C13_5_2 => (case, class.positive, class.faces, None),
                _ => (case, class.positive, class.faces, class.tunnel.map(|join| join.corners)),
            };
            entries.insert(entry);
        }
        assert_eq!(entries.len(), 730);
        assert_eq!(entries.iter().filter(|(case, ..)| *case != Case::C0).count(), 728);
        let fewer = |case: Case| {
            let all = classes.iter().filter(|class| Case::of(class) == case).count();
            all - entries.iter().filter(|(of, ..)| *of == case).count()
        };
        assert_eq!([Case::C10_1_2, Case::C12_1_2, Case::C13_5_2].map(fewer), [6, 24, 8]);
    }
}
