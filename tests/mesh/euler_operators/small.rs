//! Every small boundary.

use super::building::boundary_of;
use super::canonical::{betti, symmetries};
use super::meshes::mesh;
use super::states::{KINDS, Limit, States, boundary, cycles, enumerated, is_long, operators_of, permutations, reached};
use super::words::{Words, applied};
use isoracle::mesh::euler_operators::{Boundary, Counts, Operator, Scope, construction, replay};
use std::collections::{BTreeMap, BTreeSet, HashSet};

fn limit() -> Limit {
    Limit { edges_and_rings: if is_long() { 4 } else { 3 }, shells: 2 }
}

fn small() -> States {
    reached(Boundary::new(), limit(), |_| true)
}

fn operators(b: &Boundary) -> impl Iterator<Item = Operator> {
    (0..KINDS).flat_map(|kind| operators_of(b, kind))
}

/// V, E, F, H, C, G by homology: b0 = C, b1 = 2G, and b2 = C as every component is orientable.
pub fn by_homology(b: &Boundary) -> Counts {
    let words = Words::of(b);
    let [b0, b1, b2] = betti(&words);
    assert_eq!((b0, b1 % 2), (b2, 0));
    Counts { c: b0, g: b1 / 2, ..words.counts() }
}

mod me_106 {
    use super::*;

    #[test]
    fn each_operator_changes_the_numbers_as_the_table_says() {
        let mut met = HashSet::new();
        for b in small().values() {
            for operator in operators(b) {
                let mut after = b.clone();
                if after.apply(&operator).is_ok() {
                    let [before, now] = [b, &after].map(by_homology);
                    assert_eq!(before + operator.change(), now, "{operator:?}");
                    met.insert(std::mem::discriminant(&operator));
                }
            }
        }
        assert_eq!(met.len(), KINDS, "each operator was allowed somewhere");
    }
}

mod me_107 {
    use super::*;

    /// One part of space with two shells.
    #[test]
    fn a_cavity_is_a_component_of_its_own() {
        let counts = by_homology(&boundary_of(&mesh("cube with a cavity")));
        assert_eq!((counts.euler_number(), counts.c, counts.g), (4, 2, 0));
        let printed = Counts { c: 1, ..counts };
        assert_eq!((counts.balance(), printed.balance()), (0, 2));
    }

    #[test]
    fn every_small_boundary_is_balanced_and_its_genus_is_that_of_homology() {
        for b in small().values() {
            let counts = by_homology(b);
            assert_eq!((b.tracked(), b.counted(), counts.balance()), (counts, counts, 0));
            assert!(counts.g >= 0 && counts.c >= 0);
        }
    }
}

mod me_109 {
    use super::*;

    /// Each operator on each small boundary, against surgery on words, and back; in the long form also on each connected one
    /// with up to five edges and rings.
    #[test]
    fn operators_are_allowed_where_surgery_on_words_is_and_their_inverses_restore_the_names() {
        let mut states = small();
        if is_long() {
            states.extend(reached(Boundary::new(), Limit { edges_and_rings: 5, shells: 1 }, |_| true));
        }
        for b in states.values() {
            assert_eq!(b.defects(), []);
            for operator in operators(b) {
                let mut after = b.clone();
                let outcome = after.apply(&operator);
                let expected = applied(b, &operator);
                assert_eq!(outcome.is_ok(), expected.is_some(), "{operator:?} {outcome:?} of {:?}", Words::of(b));
                match outcome {
                    Err(_) => assert_eq!(after, *b, "{operator:?}"),
                    Ok(inverse) => {
                        assert_eq!(Some(Words::of(&after).sorted()), expected, "{operator:?} of {:?}", Words::of(b));
                        assert_eq!(after.defects(), [], "{operator:?} of {:?}", Words::of(b));
                        assert_eq!(inverse.change(), operator.change() * -1);
                        assert_eq!(after.apply(&inverse), Ok(operator.clone()));
                        assert_eq!(after, *b, "{operator:?}, then {inverse:?}");
                    }
                }
            }
        }
    }
}

mod me_110 {
    use super::*;

    #[test]
    fn local_operators_keep_each_shells_genus() {
        let genera = |b: &Boundary| -> Vec<i64> {
            let parts = Words::of(b).components();
            let words = Words::of(b);
            let part =
                |p: usize| Words((0..parts.len()).filter(|f| parts[*f] == p).map(|f| words.0[f].clone()).collect());
            let mut genera: Vec<i64> =
                BTreeSet::from_iter(parts.iter().copied()).into_iter().map(|p| betti(&part(p))[1] / 2).collect();
            genera.sort_unstable();
            genera
        };
        for b in small().values() {
            for operator in operators(b).filter(|operator| operator.scope() == Scope::Local) {
                let mut after = b.clone();
                if after.apply(&operator).is_ok() {
                    assert_eq!(genera(b), genera(&after), "{operator:?}");
                }
            }
        }
    }
}

mod me_113 {
    use super::*;

    #[test]
    fn every_small_boundary_is_built_from_nothing() {
        for b in small().values() {
            assert_eq!(replay(&construction(b)).as_ref(), Ok(b));
        }
    }

    /// Polygons with their sides glued in pairs, each to one in the opposite direction: one face.
    #[test]
    fn every_gluing_of_a_polygon_is_built_from_nothing() {
        let most = if is_long() { 5 } else { 4 };
        for n in 0..=most {
            let gluings = gluings(&(0..2 * n).collect::<Vec<_>>());
            assert_eq!(gluings.len(), (1..=n).map(|k| 2 * k - 1).product::<usize>(), "(2n − 1)!!");
            let mut of_genus: BTreeMap<i64, usize> = BTreeMap::new();
            for pairs in gluings {
                let mut word = vec![0; 2 * n];
                for (edge, [a, b]) in (0..).zip(&pairs) {
                    (word[*a], word[*b]) = (2 * edge, 2 * edge + 1);
                }
                let b = boundary(&[vec![word]]);
                assert_eq!((b.defects(), b.counted()), (vec![], by_homology(&b)));
                assert_eq!(replay(&construction(&b)), Ok(b.clone()));
                *of_genus.entry(b.counted().g).or_default() += 1;
            }
            // Harer and Zagier's numbers; those of genus 0 are Catalan's.
            let expected = [&[1][..], &[1], &[2, 1], &[5, 10], &[14, 70, 21], &[42, 420, 483]][n];
            assert_eq!(of_genus.into_values().collect::<Vec<_>>(), expected);
        }
    }

    /// Every way to divide numbers into pairs.
    fn gluings(sides: &[usize]) -> Vec<Vec<[usize; 2]>> {
        let Some((first, rest)) = sides.split_first() else { return vec![vec![]] };
        let with = |i: usize| {
            let others = [&rest[..i], &rest[i + 1..]].concat();
            gluings(&others).into_iter().map(move |pairs| [pairs, vec![[*first, rest[i]]]].concat())
        };
        (0..rest.len()).flat_map(with).collect()
    }
}

mod me_114 {
    use super::*;

    #[test]
    fn operators_reach_every_small_boundary_and_nothing_else() {
        let reached: BTreeSet<_> = small().into_keys().collect();
        let enumerated = enumerated(limit());
        assert!(reached == enumerated, "{} reached, {} enumerated", reached.len(), enumerated.len());
        assert_eq!(reached.len(), if is_long() { 1058 } else { 178 });
    }

    /// Connected ones without rings, each counted once for every half-edge that is unlike the others.
    #[test]
    fn rooted_maps_are_as_many_as_are_known() {
        let most = if is_long() { 4 } else { 3 };
        let known = [&[1][..], &[2], &[9, 1], &[54, 20], &[378, 307, 21]];
        let mut rooted = vec![BTreeMap::<i64, usize>::new(); most + 1];
        let limit = Limit { edges_and_rings: most as i64, shells: 1 };
        for b in reached(Boundary::new(), limit, |_| true).values() {
            let counts = b.counted();
            if counts.h == 0 && counts.c == 1 {
                let roots = (2 * counts.e as usize).max(1) / symmetries(&Words::of(b));
                *rooted[counts.e as usize].entry(counts.g).or_default() += roots;
            }
        }
        for (e, of_genus) in rooted.iter().enumerate() {
            assert_eq!(of_genus.values().copied().collect::<Vec<_>>(), known[e], "{e} edges");
        }
    }

    /// The same numbers from permutations alone: a rooted map is a transitive pair, of 2E half-edges, (2E − 1)! of which
    /// differ in the numbering of the other half-edges; there are (2E − 1)!! ways to pair them.
    #[test]
    fn transitive_permutations_are_as_many_as_rooted_maps() {
        for (e, known) in [(1usize, &[2][..]), (2, &[9, 1]), (3, &[54, 20])] {
            let mut of_genus: BTreeMap<i64, usize> = BTreeMap::new();
            for permutation in permutations(2 * e) {
                let words = Words(cycles(&permutation).into_iter().map(|word| vec![word]).collect());
                let counts = words.counts();
                if counts.c == 1 {
                    *of_genus.entry(counts.g).or_default() += 1;
                }
            }
            let pairings: usize = (1..=e).map(|k| 2 * k - 1).product();
            let numberings: usize = (1..2 * e).product();
            let rooted: Vec<usize> = of_genus.values().map(|n| n * pairings / numberings).collect();
            assert_eq!(rooted, known);
        }
    }
}

mod me_112 {
    use super::*;

    /// From the sphere and from the torus, by local operators alone: what is reached is each surface's own.
    #[test]
    fn local_operators_never_make_a_torus_of_a_sphere() {
        let limit = Limit { edges_and_rings: if is_long() { 4 } else { 3 }, shells: 1 };
        let is_local = |operator: &Operator| operator.scope() == Scope::Local;
        let all = reached(Boundary::new(), limit, |_| true);
        for (start, g) in [(boundary(&[vec![vec![]]]), 0), (boundary(&[vec![vec![0, 2, 1, 3]]]), 1)] {
            let of_genus: BTreeSet<_> = all
                .iter()
                .filter(|(_, b)| (b.counted().c, b.counted().g) == (1, g))
                .map(|(code, _)| code.clone())
                .collect();
            let locally: BTreeSet<_> = reached(start, limit, is_local).into_keys().collect();
            assert!(locally == of_genus, "genus {g}: {} of {}", locally.len(), of_genus.len());
            assert!(locally.len() > 10);
        }
    }

    #[test]
    fn a_face_made_a_ring_makes_a_torus_of_a_sphere() {
        // Two closed edges at one vertex of a sphere: a belt between two caps, which become the ends of a tube.
        let mut sphere = boundary(&[vec![vec![0]], vec![vec![1, 2]], vec![vec![3]]]);
        assert_eq!(by_homology(&sphere).g, 0);
        let [first, _, last] = sphere.faces().collect::<Vec<_>>()[..] else { panic!("three faces") };
        sphere.apply(&Operator::Kfmrh { face: first, into: last }).expect("they are of one shell");
        assert_eq!(by_homology(&sphere).g, 1);
    }
}
