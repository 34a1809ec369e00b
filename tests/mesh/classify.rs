//! Surfaces: orientation, the classification by numbers against the reduction of words.

use crate::domain::{every_gluing, gluing, long};
use isoracle::mesh::classify::{ClosedSurface, SPHERE, Surface};
use isoracle::mesh::gluing::{Gluing, GluingError, Place, Side};
use isoracle::mesh::homology::ChainComplex;
use isoracle::mesh::orientation::{Crossing, Orientation};
use isoracle::mesh::word::{intersection_rank, normal_form};
use isoracle::number::Integer;
use proptest::prelude::*;

fn words(words: &[&str]) -> Gluing {
    Gluing::from_words(words).expect("a gluing")
}

fn orientable(genus: usize) -> ClosedSurface {
    ClosedSurface::Orientable { genus }
}

fn non_orientable(crosscaps: usize) -> ClosedSurface {
    ClosedSurface::NonOrientable { crosscaps }
}

/// By homology alone: H₂ = ℤ iff the closed component can be oriented, and b₁ over ℤ/2 is 2 − χ.
fn by_homology(component: &Gluing) -> ClosedSurface {
    let chains = ChainComplex::of_gluing(&component.capped());
    let homology = chains.homology();
    let mod_2 = chains.betti_mod_2();
    assert_eq!([mod_2[0], mod_2[2]], [1, 1], "every closed connected surface has a cycle over ℤ/2");
    match homology.betti[2] {
        1 => {
            assert!(homology.torsion[1].is_empty());
            assert_eq!(homology.betti[1], mod_2[1]);
            orientable(mod_2[1] / 2)
        }
        _ => {
            assert_eq!(homology.torsion[1], [Integer::from(2)]);
            assert_eq!(homology.betti[1] + 1, mod_2[1]);
            non_orientable(mod_2[1])
        }
    }
}

/// Every second derivation of what a gluing is.
fn assert_classified(gluing: &Gluing) {
    let surfaces = gluing.surfaces();
    let closed: Vec<ClosedSurface> = surfaces.iter().map(|s| s.closed).collect();
    let by_words: Vec<ClosedSurface> = gluing.words().iter().map(|word| normal_form(word).into()).collect();
    assert_eq!(closed, by_words);
    let components = gluing.components();
    assert_eq!(closed, components.iter().map(by_homology).collect::<Vec<_>>());
    for (word, surface) in gluing.words().iter().zip(&closed) {
        assert_eq!(intersection_rank(word) as i64, 2 - surface.euler_characteristic());
    }
    let chi: i64 = surfaces.iter().map(|s| s.euler_characteristic()).sum();
    assert_eq!(chi, gluing.euler_characteristic());
    assert_eq!(surfaces.iter().map(|s| s.boundary_loops).sum::<usize>(), gluing.boundary().len());
    assert_oriented(gluing, closed.iter().any(|s| matches!(s, ClosedSurface::NonOrientable { .. })));
}

fn assert_oriented(gluing: &Gluing, is_one_sided: bool) {
    match gluing.orientation() {
        Orientation::Oriented(turned) => {
            assert!(!is_one_sided);
            for places in gluing.places().values().filter(|places| places.len() == 2) {
                let way = |p: &Place| gluing.polygons()[p.polygon][p.side].forward != turned[p.polygon];
                assert_ne!(way(&places[0]), way(&places[1]));
            }
        }
        Orientation::Reversing(path) => {
            assert!(is_one_sided);
            assert!(gluing.is_reversing(&path));
            // Polygons stand once, so that the path's neighbourhood is a band.
            let mut polygons: Vec<usize> = path.iter().map(|c| c.from.polygon).collect();
            polygons.sort_unstable();
            assert!(polygons.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
}

mod me_126 {
    use super::*;

    #[test]
    fn a_band_glued_crosswise_comes_back_mirrored() {
        // A Möbius band of three squares.
        let band = words(&["axby", "bzcw", "cuav"]);
        let Orientation::Reversing(path) = band.orientation() else { panic!("it has one side") };
        assert_eq!(path.len(), 3);
        assert!(band.is_reversing(&path));
        // The annulus of the same squares.
        let band = words(&["axBy", "bzCw", "cuAv"]);
        assert_eq!(band.orientation(), Orientation::Oriented(vec![false; 3]));
        let turned = words(&["axBy", "cZBW", "cuAv"]);
        assert_oriented(&turned, false);
    }

    #[test]
    fn only_closed_mirrored_paths_are_reversing() {
        let band = words(&["axby", "bzcw", "cuav"]);
        let Orientation::Reversing(path) = band.orientation() else { panic!("it has one side") };
        assert!(!band.is_reversing(&path[..2]), "not closed");
        assert!(!band.is_reversing(&[path.clone(), path.clone()].concat()), "mirrored twice");
        assert!(!band.is_reversing(&[]));
        let nowhere = Place { polygon: 7, side: 0 };
        assert!(!band.is_reversing(&[Crossing { from: nowhere, to: nowhere }]));
        let free = Place { polygon: 0, side: 1 };
        assert!(!band.is_reversing(&[Crossing { from: free, to: free }]), "not through a free side");
    }
}

mod me_130 {
    use super::*;

    #[test]
    fn every_closed_gluing_is_a_sphere_with_handles_or_crosscaps() {
        let mut count = 0;
        let mut check = |gluing: Gluing| {
            assert_classified(&gluing);
            count += 1;
        };
        for sizes in [&[2usize][..], &[4], &[6], &[1, 1], &[1, 3], &[2, 2], &[2, 4], &[3, 3], &[2, 1, 1]] {
            every_gluing(sizes, false, &mut check);
        }
        // (2m − 1)!! pairings of 2m sides, each pair two ways.
        assert_eq!(count, 2 * 2 + 4 * 12 + 3 * 120);
    }

    #[test]
    fn each_of_the_families_is_met() {
        let closed = |word: &str| words(&[word]).surfaces()[0].closed;
        assert_eq!(closed("aA"), SPHERE);
        assert_eq!(closed("abAB"), orientable(1));
        assert_eq!(closed("abABcdCD"), orientable(2));
        assert_eq!(closed("abABcdCDefEF"), orientable(3));
        assert_eq!(closed("aa"), non_orientable(1));
        assert_eq!(closed("aabb"), non_orientable(2));
        assert_eq!(closed("abaB"), non_orientable(2));
        assert_eq!(closed("aabbcc"), non_orientable(3));
        assert_eq!(closed("abcdABCD"), orientable(2));
        assert_eq!(closed("abcABC"), orientable(1));
    }
}

mod me_131 {
    use super::*;

    #[test]
    fn every_octagon_has_the_normal_form_of_its_numbers() {
        let mut seen = std::collections::BTreeMap::new();
        every_gluing(&[8], false, |gluing| {
            let surface = gluing.surfaces()[0].closed;
            assert_eq!(gluing.words().iter().map(|w| normal_form(w).into()).collect::<Vec<ClosedSurface>>(), [surface]);
            *seen.entry(surface).or_insert(0) += 1;
        });
        // 105 pairings: 14 planar, 70 tori, 21 double tori (Harer and Zagier); all 1680 with reversals.
        assert_eq!([seen[&orientable(0)], seen[&orientable(1)], seen[&orientable(2)]], [14, 70, 21]);
        assert_eq!(seen.values().sum::<i32>(), 1680);
        assert_eq!(seen.len(), 3 + 4);
    }

    #[test]
    fn more_gluings_where_time_allows() {
        if long() {
            every_gluing(&[10], false, |gluing| {
                let closed: Vec<ClosedSurface> = gluing.words().iter().map(|w| normal_form(w).into()).collect();
                assert_eq!(closed, [gluing.surfaces()[0].closed]);
            });
            every_gluing(&[3, 3, 3], true, |gluing| assert_classified(&gluing));
            every_gluing(&[3, 3, 3, 3], false, |gluing| {
                let closed: Vec<ClosedSurface> = gluing.surfaces().iter().map(|s| s.closed).collect();
                assert_eq!(
                    closed,
                    gluing.words().iter().map(|w| normal_form(w).into()).collect::<Vec<ClosedSurface>>()
                );
            });
        }
    }
}

mod me_132 {
    use super::*;

    #[test]
    fn the_form_has_no_diagonal_iff_the_word_can_be_oriented() {
        every_gluing(&[6], false, |gluing| {
            let words = gluing.words();
            let one_way = words[0].iter().any(|side| words[0].iter().filter(|other| *other == side).count() == 2);
            assert_eq!(gluing.is_orientable(), !one_way);
            assert_eq!(intersection_rank(&words[0]) as i64, 2 - gluing.euler_characteristic());
        });
    }
}

mod me_133 {
    use super::*;

    #[test]
    fn every_gluing_with_free_sides_is_classified() {
        for sizes in [&[1usize][..], &[2], &[3], &[4], &[5], &[1, 1], &[2, 1], &[2, 2], &[3, 2], &[3, 1, 1]] {
            every_gluing(sizes, true, |gluing| assert_classified(&gluing));
        }
    }

    #[test]
    fn surfaces_have_their_names() {
        let name = |word: &str| words(&[word]).surfaces()[0].to_string();
        assert_eq!(
            ["a", "abAc", "abac", "aAb", "aab"].map(name),
            ["disc", "annulus", "Möbius band", "disc", "Möbius band"]
        );
        assert_eq!(["aA", "abAB", "aa", "abaB"].map(name), ["sphere", "torus", "projective plane", "Klein bottle"]);
        assert_eq!(name("abABx"), "torus less a disc");
        assert_eq!(name("xbcBdeD"), "sphere less 3 discs");
        assert_eq!(name("aabbccxyXz"), "sphere with 3 cross-caps less 2 discs");
        assert_eq!(name("abABcdCD"), "sphere with 2 handles");
    }

    #[test]
    fn broken_polygons_are_refused() {
        assert_eq!(Gluing::from_words(&["aba"]).map(|g| g.boundary().len()), Ok(1));
        assert_eq!(Gluing::from_words(&["aab", "A"]), Err(GluingError::Sides { edge: u32::from('a'), sides: 3 }));
        assert_eq!(Gluing::from_words(&["aA", ""]), Err(GluingError::Empty { polygon: 1 }));
        assert_eq!(Gluing::from_words(&["a1"]), Err(GluingError::Letter('1')));
        let nothing = Gluing::new(vec![]).expect("nothing");
        assert_eq!((nothing.surfaces(), nothing.counts()), (vec![], [0; 3]));
        assert_eq!(nothing.ends(3), None);
    }

    proptest! {
        #[test]
        fn random_gluings_are_classified(gluing in gluing()) {
            assert_classified(&gluing);
        }

        // Turning polygons, reversing them and renaming edges changes nothing.
        #[test]
        fn the_surface_does_not_depend_on_how_it_is_written(gluing in gluing(), by in 0usize..6, turn in any::<[bool; 6]>()) {
            let polygons = gluing.polygons().iter().zip(turn).map(|(polygon, turn)| {
                let mut polygon: Vec<Side> =
                    polygon.iter().map(|s| Side { edge: 1000 - s.edge, forward: s.forward != (s.edge % 3 == 0) }).collect();
                let n = polygon.len();
                polygon.rotate_left(by % n);
                if turn { isoracle::mesh::word::inverse(&polygon) } else { polygon }
            });
            let other = Gluing::new(polygons.collect()).expect("the same gluing");
            prop_assert_eq!(gluing.surfaces(), other.surfaces());
            prop_assert_eq!(gluing.counts(), other.counts());
        }
    }
}

mod me_134 {
    use super::*;

    #[test]
    fn the_three_cases_give_the_number_that_counting_gives() {
        let letters = |k: usize| (0..k).map(|i| char::from(b'a' + i as u8)).collect::<Vec<char>>();
        for g in 0..7 {
            let handle = |p: &[char]| format!("{}{}{}{}", p[0], p[1], p[0].to_uppercase(), p[1].to_uppercase());
            let word: String = letters(2 * g).chunks(2).map(handle).collect();
            let gluing = words(&[&format!("{word}zZ")]);
            assert_eq!(gluing.euler_characteristic(), 2 - 2 * g as i64);
            assert_eq!(orientable(g).euler_characteristic(), 2 - 2 * g as i64);
            assert_eq!(gluing.surfaces(), [Surface { closed: orientable(g), boundary_loops: 0 }]);
            let word: String = letters(g + 1).iter().map(|c| format!("{c}{c}")).collect();
            let gluing = words(&[&word]);
            assert_eq!(gluing.euler_characteristic(), 2 - (g as i64 + 1));
            assert_eq!(gluing.surfaces()[0].closed, non_orientable(g + 1));
            assert_eq!(non_orientable(g + 1).euler_characteristic(), 1 - g as i64);
        }
    }
}

mod me_136 {
    use super::*;

    #[test]
    fn beside_a_crosscap_a_handle_is_two_crosscaps() {
        let [torus, plane] = [orientable(1), non_orientable(1)];
        assert_eq!(torus.sum(plane), plane.sum(plane).sum(plane));
        assert_eq!(plane.sum(torus), non_orientable(3));
        assert_eq!(words(&["abABcc"]).surfaces(), words(&["aabbcc"]).surfaces());
    }

    // Words with no label in common: the word of the sum.
    #[test]
    fn sums_of_words_are_sums_of_surfaces() {
        let all = ["aA", "abAB", "aa", "abaB", "abABcdCD", "aabbcc"];
        for a in all {
            for b in all {
                let moved: String = b.chars().map(|c| char::from(c as u8 + 10)).collect();
                let [x, y, z] = [a, b, &format!("{a}{moved}")].map(|w| words(&[w]).surfaces()[0].closed);
                assert_eq!(x.sum(y), z);
                assert_eq!(z.euler_characteristic(), x.euler_characteristic() + y.euler_characteristic() - 2);
            }
        }
    }
}

mod me_143 {
    use super::*;

    #[test]
    fn components_are_classified_each() {
        let gluing = words(&["abAB", "cdcD", "e", "ff"]);
        let names: Vec<String> = gluing.surfaces().iter().map(ToString::to_string).collect();
        assert_eq!(names, ["torus", "Klein bottle", "disc", "projective plane"]);
        assert_eq!(gluing.components().len(), 4);
        assert_eq!(ChainComplex::of_gluing(&gluing).homology().betti[0], 4);
    }
}
