//! Every way in which a scheme can be none, by name, with its witness.

use super::naive_scheme::{found, is_ball};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::polyhedron::PolyhedronFlaw;
use isoracle::complex::scheme::{PairingFlaw, Reason, SchemeDefect};
use isoracle::complex::zoo::invalid::{Broken, all, get, names};
use std::collections::BTreeSet;

mod cx_6 {
    use super::*;

    #[test]
    fn every_broken_scheme_has_its_defect_first() {
        for Broken { name, defect, scheme, .. } in all() {
            let defects = Manifold3::new(scheme).expect_err(name);
            assert_eq!(defects[0], defect, "{name}");
        }
    }

    #[test]
    fn every_reason_and_every_flaw_has_an_example() {
        let number = |reason: Reason| match reason {
            Reason::UnmatchedFace => 0,
            Reason::PolygonSizeMismatch => 1,
            Reason::FaceGluedToItself => 2,
            Reason::FaceInTwoPairings => 3,
            Reason::BadPairing => 4,
            Reason::EdgeReversed => 5,
            Reason::VertexLink => 6,
            Reason::BadPolyhedron => 7,
        };
        let (mut reasons, mut flaws, mut pairings) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for Broken { defect, .. } in all() {
            reasons.insert(number(defect.reason()));
            match defect {
                SchemeDefect::BadPolyhedron { flaw, .. } => drop(flaws.insert(match flaw {
                    PolyhedronFlaw::NoFace => 0,
                    PolyhedronFlaw::EmptyFace { .. } => 1,
                    PolyhedronFlaw::NoSuchEdge { .. } => 2,
                    PolyhedronFlaw::BrokenWalk { .. } => 3,
                    PolyhedronFlaw::EdgeUses { .. } => 4,
                    PolyhedronFlaw::SameDirection { .. } => 5,
                    PolyhedronFlaw::Pinch { .. } => 6,
                    PolyhedronFlaw::Disconnected { .. } => 7,
                    PolyhedronFlaw::NotASphere(_) => 8,
                })),
                SchemeDefect::BadPairing { flaw, .. } => drop(pairings.insert(match flaw {
                    PairingFlaw::NoSuchFace(_) => 0,
                    PairingFlaw::Direction(_) => 1,
                })),
                _ => {}
            }
        }
        assert_eq!((reasons.len(), flaws.len(), pairings.len()), (8, 9, 2));
    }

    #[test]
    fn the_words_of_the_reasons_are_those_of_the_protocol() {
        let words: BTreeSet<&str> = all().iter().map(|broken| broken.defect.reason().name()).collect();
        let known = [
            "bad-pairing",
            "bad-polyhedron",
            "edge-reversed",
            "face-glued-to-itself",
            "face-in-two-pairings",
            "polygon-size-mismatch",
            "unmatched-face",
            "vertex-link",
        ];
        assert_eq!(words, BTreeSet::from(known));
    }

    #[test]
    fn the_second_derivation_sees_the_same_kind_of_fault() {
        for Broken { name, defect, scheme, .. } in all() {
            let balls = scheme.polyhedra.iter().all(is_ball);
            match defect {
                SchemeDefect::BadPolyhedron { polyhedron, .. } => {
                    assert!(!is_ball(&scheme.polyhedra[polyhedron]), "{name}")
                }
                SchemeDefect::Empty => assert!(scheme.polyhedra.is_empty()),
                SchemeDefect::EdgeReversed { .. } => assert!(balls && found(&scheme).edge_reversed, "{name}"),
                SchemeDefect::VertexLink { link, .. } => {
                    let found = found(&scheme);
                    assert!(balls && !found.edge_reversed && found.links.contains(&link), "{name}");
                    assert!(found.euler_characteristic() > 0, "{name}");
                    let mut links = ClosedComplex::new(scheme).expect("a complex").vertex_links();
                    links.sort_unstable();
                    assert_eq!(links, found.links, "{name}");
                }
                _ => assert!(balls, "{name}"),
            }
        }
    }

    #[test]
    fn all_that_is_wrong_is_told_in_order() {
        // A polyhedron that is no ball, a pairing of no face, one of different sizes, one of a face with itself, a face in two
        // pairings, a face in none.
        let mut scheme = get("size-mismatch").expect("a broken scheme").scheme;
        scheme.polyhedra.extend(get("torus-surface").expect("a broken scheme").scheme.polyhedra);
        let pairing = scheme.pairings[0];
        scheme.pairings.push(isoracle::complex::scheme::Pairing { b: pairing.a, dir: 5, ..pairing });
        scheme.pairings[1].b.face = 9;
        let words: Vec<&str> = scheme.defects().iter().map(|defect| defect.reason().name()).collect();
        let expected = [
            "bad-polyhedron",
            "polygon-size-mismatch",
            "bad-pairing",
            "bad-pairing",
            "face-glued-to-itself",
            "face-in-two-pairings",
            "unmatched-face",
            "unmatched-face",
            "unmatched-face",
            "unmatched-face",
        ];
        assert_eq!(words, expected);
    }

    #[test]
    fn messages_name_the_witness() {
        let message = |name: &str| get(name).expect("a broken scheme").defect.to_string();
        assert_eq!(message("unmatched-face"), "face 3 of polyhedron 0 is in no pairing");
        assert_eq!(message("size-mismatch"), "pairing 0 glues a face of 3 sides to one of 4");
        assert_eq!(message("no-direction"), "pairing 1: dir is 0; it is 1 or -1");
        assert_eq!(message("pinched-sphere"), "polyhedron 0 is not a ball: at vertex 0 2 fans of faces touch");
        assert_eq!(message("torus-surface"), "polyhedron 0 is not a ball: its faces make a torus, not a sphere");
        let around = "around vertex 0, which is vertex 1 of polyhedron 0, stands a Klein bottle, not a sphere";
        assert_eq!(message("gieseking"), around);
    }
}

#[test]
fn names_are_told_once() {
    let names = names();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
    assert!(names.len() >= 30 && get("T3").is_none());
    assert!(names.iter().all(|name| get(name).is_some_and(|broken| broken.name == *name)));
}
