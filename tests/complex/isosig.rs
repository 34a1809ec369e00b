//! Isomorphism signatures and gluing tables beside Regina's, and beside isomorphisms sought by hand.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::gluing_table::GluingTable;
use isoracle::complex::isosig::{SignatureError, signature, triangulation};
use isoracle::complex::isosig_fast;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// A line of tests/complex/regina.txt.
struct Seen {
    signature: &'static str,
    is_manifold: bool,
    is_orientable: bool,
    components: usize,
    counts: Vec<usize>,
    h1: &'static str,
    triangulation: Triangulation,
}

/// What Regina 7.4 says of 339 triangulations, the gluings of one tetrahedron first.
fn regina() -> Vec<Seen> {
    let lines = include_str!("regina.txt").lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| seen(line).unwrap_or_else(|| panic!("{line}"))).collect()
}

fn seen(line: &'static str) -> Option<Seen> {
    let mut words = line.split(' ');
    let mut next = || words.next();
    let (signature, manifold, orientable, components, counts, h1) =
        (next()?, next()?, next()?, next()?, next()?, next()?);
    let triangle = |word: &str| {
        let (other, images) = word.split_once('/')?;
        let images: Vec<u8> = images.bytes().map(|digit| digit - b'0').collect();
        Some((other.parse::<u32>().ok()?, <[u8; 4]>::try_from(images).ok()?))
    };
    let triangles: Vec<(u32, [u8; 4])> = words.map(triangle).collect::<Option<_>>()?;
    let rows = triangles.chunks(4).map(|t| ([t[0].0, t[1].0, t[2].0, t[3].0], [t[0].1, t[1].1, t[2].1, t[3].1]));
    Some(Seen {
        signature,
        is_manifold: manifold == "valid",
        is_orientable: orientable == "orientable",
        components: components.parse().ok()?,
        counts: counts.split(',').map(|n| n.parse().ok()).collect::<Option<_>>()?,
        h1,
        triangulation: Triangulation::of_rows(rows).ok()?,
    })
}

/// The gluings that these numbers say: triangles in the order of the numbers, paired in twos, each pair glued by one of six maps.
fn glued(n: usize, numbers: &[u32]) -> Triangulation {
    let mut order: Vec<usize> = (0..4 * n).collect();
    order.sort_by_key(|i| (numbers[*i % numbers.len()].rotate_left(*i as u32), *i));
    let mut gluings = vec![[TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4]; n];
    for (pair, number) in order.chunks(2).zip(numbers.iter().cycle()) {
        let [(s, a), (t, b)] = [pair[0], pair[1]].map(|i| (i / 4, i % 4));
        let mut maps = Perm4::all().filter(|p| p.image(a) == b);
        let corners = maps.nth(*number as usize % 6).expect("there are six");
        gluings[s][a] = TriangleGluing { tetrahedron: t as u32, corners };
        gluings[t][b] = TriangleGluing { tetrahedron: s as u32, corners: corners.inverse() };
    }
    Triangulation::new(gluings).expect("triangles are glued in twos")
}

/// The same with other numbers: tetrahedron i becomes `order`\[i\], its corners by `labels`\[i\].
fn renumbered(t: &Triangulation, order: &[usize], labels: &[Perm4]) -> Triangulation {
    let mut gluings = t.gluings().to_vec();
    for (i, triangles) in t.gluings().iter().enumerate() {
        for (triangle, gluing) in triangles.iter().enumerate() {
            let other = gluing.tetrahedron as usize;
            gluings[order[i]][labels[i].image(triangle)] = TriangleGluing {
                tetrahedron: order[other] as u32,
                corners: labels[i].inverse().then(gluing.corners).then(labels[other]),
            };
        }
    }
    Triangulation::new(gluings).expect("only names differ")
}

fn renumbered_by(t: &Triangulation, numbers: &[u32]) -> Triangulation {
    let number = |i: usize| numbers[i % numbers.len()].rotate_right(i as u32);
    let mut order: Vec<usize> = (0..t.len()).collect();
    order.sort_by_key(|i| (number(*i), *i));
    let labels: Vec<Perm4> =
        (0..t.len()).map(|i| Perm4::all().nth(number(i + 1) as usize % 24).expect("one of 24")).collect();
    renumbered(t, &order, &labels)
}

/// Whether tetrahedra and corners of one can be laid on those of the other: every way is tried, one tetrahedron after the other.
fn isomorphic(a: &Triangulation, b: &Triangulation) -> bool {
    fn laid(a: &Triangulation, b: &Triangulation, on: &mut Vec<(usize, Perm4)>) -> bool {
        let i = on.len();
        if i == a.len() {
            return true;
        }
        for other in (0..b.len()).filter(|j| on.iter().all(|(k, _)| k != j)).collect::<Vec<_>>() {
            for labels in Perm4::all() {
                on.push((other, labels));
                let fits = |t: usize| {
                    let (there, names) = on[t];
                    a.gluings()[t].iter().enumerate().all(|(triangle, gluing)| {
                        let image = b.gluings()[there][names.image(triangle)];
                        let neighbour = gluing.tetrahedron as usize;
                        on.get(neighbour).is_none_or(|(j, theirs)| {
                            image.tetrahedron as usize == *j
                                && names.then(image.corners) == gluing.corners.then(*theirs)
                        })
                    })
                };
                if (0..=i).all(fits) && laid(a, b, on) {
                    return true;
                }
                on.pop();
            }
        }
        false
    }
    a.len() == b.len() && laid(a, b, &mut Vec::new())
}

mod cx_93 {
    use super::*;

    #[test]
    fn signatures_are_regina_s() {
        let all = regina();
        assert_eq!(all.len(), 339);
        for seen in all {
            assert_eq!(signature(&seen.triangulation), seen.signature);
            assert_eq!(isosig_fast::signature(&seen.triangulation), seen.signature);
        }
    }

    #[test]
    fn the_gluings_of_one_tetrahedron_fall_into_the_classes_that_their_symmetries_count() {
        let all: Vec<Triangulation> = regina().into_iter().take(108).map(|seen| seen.triangulation).collect();
        let mut classes: BTreeMap<String, Vec<&Triangulation>> = BTreeMap::new();
        for t in &all {
            classes.entry(signature(t)).or_default().push(t);
        }
        // Burnside: as many as gluings are left as they are, on the average over the 24 permutations.
        let fixed =
            Perm4::all().map(|p| all.iter().filter(|t| &&renumbered(t, &[0], &[p]) == t).count()).sum::<usize>();
        assert_eq!((fixed % 24, fixed / 24), (0, classes.len()));
        for (signature, members) in &classes {
            let own = Perm4::all().filter(|p| &renumbered(members[0], &[0], &[*p]) == members[0]).count();
            assert_eq!(members.len() * own, 24, "{signature}");
        }
        for a in &all {
            for b in &all {
                assert_eq!(signature(a) == signature(b), isomorphic(a, b));
            }
        }
    }

    #[test]
    fn small_ones_have_one_signature_iff_they_are_isomorphic() {
        // Pairings of two tetrahedra's triangles with maps of few kinds: many are isomorphic, many nearly so.
        let numbers = |k: u32| [k % 5, k % 7, k / 3, 0xabcd * (k % 4)];
        let mut all: Vec<Triangulation> = (0..36).map(|k| glued(2, &numbers(k))).collect();
        all.extend(
            (0..12).map(|k| renumbered_by(&all[3 * k], &[(k as u32).wrapping_mul(0x9e37_79b9), 5])).collect::<Vec<_>>(),
        );
        let mut alike = 0;
        for a in &all {
            for b in &all {
                let same = isomorphic(a, b);
                alike += usize::from(same);
                assert_eq!(signature(a) == signature(b), same);
            }
        }
        assert!(alike > 60 && alike < 1000, "{alike}");
    }

    #[test]
    fn components_are_put_in_order() {
        let seen: Vec<Seen> = regina().into_iter().filter(|seen| seen.components > 1).collect();
        assert!(seen.len() > 20);
        assert_eq!(signature(&Triangulation::new(Vec::new()).expect("none are glued")), "a");
        assert_eq!(isosig_fast::signature(&Triangulation::new(Vec::new()).expect("none are glued")), "a");
    }

    #[test]
    fn topological_tetrahedra_of_known_spaces_have_regina_s_signatures() {
        // Regina 7.4, on the gluings of the two sides of each face.
        let of = |scheme| ClosedComplex::new(scheme).expect("a complex");
        for (scheme, expected) in [
            (lens_space(1, 0), "bkaagb"),
            (lens_space(3, 1), KNOWN[0]),
            (lens_space(5, 2), KNOWN[1]),
            (three_torus(), KNOWN[2]),
        ] {
            assert_eq!(signature(&of(scheme.clone()).tetrahedra()), expected);
            // Many symmetries: many words are the least.
            let barycentric = of(scheme).barycentric();
            assert_eq!(isosig_fast::signature(&barycentric), signature(&barycentric));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn names_do_not_matter(n in 1_usize..9, numbers: [u32; 5], names: [u32; 4]) {
            let t = glued(n, &numbers);
            let same = renumbered_by(&t, &names);
            prop_assert_eq!(signature(&same), signature(&t));
            prop_assert_eq!(isosig_fast::signature(&same), signature(&t));
        }

        #[test]
        fn one_gluing_turned_is_another_class_or_the_same(numbers: [u32; 3], which in 0_usize..12, turn in 1_usize..6) {
            // Nearly the same: one pair of triangles glued by another map.
            let t = glued(3, &numbers);
            let mut gluings = t.gluings().to_vec();
            let (s, a) = (which / 4, which % 4);
            let old = gluings[s][a];
            let b = old.corners.image(a);
            let maps: Vec<Perm4> = Perm4::all().filter(|p| p.image(a) == b).collect();
            let at = maps.iter().position(|p| *p == old.corners).expect("one of six");
            let corners = maps[(at + turn) % 6];
            gluings[s][a].corners = corners;
            gluings[old.tetrahedron as usize][b].corners = corners.inverse();
            let other = Triangulation::new(gluings).expect("still in twos");
            prop_assert_eq!(signature(&t) == signature(&other), isomorphic(&t, &other));
        }
    }
}

/// Signatures of L(3, 1), L(5, 2), the 3-torus.
const KNOWN: [&str; 3] = ["dLQbccchhgb", "fvPQcdecdeeffofoo", "mvvLPQwQQhihjhfgklklklxxxxaxxxxaxxa"];

mod cx_94 {
    use super::*;

    #[test]
    fn reading_a_signature_gives_the_same_triangulation_up_to_names() {
        for seen in regina() {
            let read = triangulation(seen.signature).expect("a signature");
            assert_eq!(signature(&read), seen.signature);
            if read.len() <= 3 {
                assert!(isomorphic(&read, &seen.triangulation), "{}", seen.signature);
            }
        }
        assert_eq!(triangulation("a").map(|t| t.len()), Ok(0));
        // Not the least word, and a component of nothing, are read all the same.
        assert_eq!(triangulation("abkaagh").map(|t| signature(&t)), Ok("bkaagh".to_owned()));
    }

    #[test]
    fn what_is_wrong_with_a_text_is_told_with_its_place() {
        use SignatureError as E;
        for (text, error) in [
            ("", E::Truncated { position: 0, expected: "the number of tetrahedra" }),
            ("b kaagh", E::NoDigit { position: 1, found: ' ' }),
            ("bkaaghé", E::NoDigit { position: 6, found: 'é' }),
            ("b", E::Truncated { position: 1, expected: "what becomes of triangles" }),
            ("bk", E::Truncated { position: 2, expected: "a tetrahedron" }),
            ("bkaag", E::Truncated { position: 5, expected: "a permutation" }),
            ("bkaaghbk", E::Truncated { position: 8, expected: "a tetrahedron" }),
            ("z", E::Truncated { position: 1, expected: "what becomes of triangles" }),
            ("-", E::Truncated { position: 1, expected: "the number of digits of a number" }),
            ("-c+", E::Truncated { position: 3, expected: "the number of tetrahedra" }),
            ("-cbaa", E::Border { position: 4 }),
            ("ba", E::Border { position: 1 }),
            ("bcaa", E::Border { position: 1 }),
            ("bj", E::NoneIsNew { position: 1, size: 1 }),
            ("bl", E::NoAction { position: 1 }),
            ("bRaagh", E::NoAction { position: 1 }),
            ("bAaagh", E::NoAction { position: 1 }),
            ("bQaagh", E::NoAction { position: 1 }),
            ("cQc", E::NotReached { position: 3, size: 2, reached: 1 }),
            ("bkbagh", E::NotKnown { position: 2, tetrahedron: 1, known: 1 }),
            ("bkaagy", E::NoPermutation { position: 5, place: 24 }),
            ("bkaaah", E::GluedTwice { position: 4, tetrahedron: 0, triangle: 0 }),
        ] {
            match triangulation(text) {
                Err(found) => assert_eq!(found, error, "{text}"),
                Ok(t) => panic!("{text}: {:?}", t.gluings()),
            }
        }
        let huge = format!("-{}{}", '-', "-".repeat(63));
        assert!(matches!(triangulation(&huge), Err(E::TooLarge { position: 2 })));
    }

    #[test]
    fn a_component_that_closes_early_leaves_some_out() {
        // Both pairs of the first are glued to itself before the second is come to.
        let closed = (0..24).flat_map(|p| (0..24).map(move |q| (p, q))).filter_map(|(p, q)| {
            let word = format!("cAcaaa{}{}a", char::from(b'a' + p), char::from(b'a' + q));
            triangulation(&word).err()
        });
        assert!(closed.into_iter().any(|error| matches!(error, SignatureError::NotReached { reached: 1, .. })));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn any_text_is_read_or_refused(text in "[a-kA-P+-]{0,14}") {
            if let Ok(t) = triangulation(&text) {
                let least = signature(&t);
                prop_assert_eq!(triangulation(&least).map(|t| signature(&t)), Ok(least));
            }
        }

        #[test]
        fn a_signature_with_one_letter_changed_is_read_or_refused(
            n in 1_usize..7, numbers: [u32; 4], place: usize, letter in "[a-zA-Z0-9+-]",
        ) {
            let mut text = signature(&glued(n, &numbers));
            let place = place % text.len();
            text.replace_range(place..place + 1, &letter);
            if let Ok(t) = triangulation(&text) {
                prop_assert_eq!(triangulation(&signature(&t)).map(|t| t.len()), Ok(t.len()));
            }
        }
    }
}

mod cx_95 {
    use super::*;

    /// Example3.threeTorus(), as Regina 7.4 prints it; its signature there is gvLQQedfedffrwawrhh.
    const TORUS: &str = "  Tet  |  gluing:       (012)       (013)       (023)       (123)
  -----+---------------------------------------------------------
    0  |              4 (013)     3 (012)     2 (032)     1 (132)
    1  |              4 (320)     3 (230)     5 (032)     0 (132)
    2  |              4 (231)     3 (321)     0 (032)     5 (132)
    3  |              0 (013)     5 (103)     1 (301)     2 (310)
    4  |              5 (102)     0 (012)     1 (210)     2 (201)
    5  |              4 (102)     3 (103)     1 (032)     2 (132)
";

    /// The same for bkaaid.
    const ONE: &str = "  Tet  |  gluing:       (012)       (013)       (023)       (123)
  -----+---------------------------------------------------------
    0  |              0 (031)     0 (021)     0 (213)     0 (203)
";

    /// The triangulation that a table names.
    fn read(table: &str) -> Triangulation {
        let rows = table.lines().skip(2).map(|line| {
            let (_, cells) = line.split_once('|').expect("a number, then cells");
            let words: Vec<&str> = cells.split_whitespace().collect();
            let mut others = [0; 4];
            let mut images = [[0; 4]; 4];
            for (cell, triangle) in words.chunks(2).zip([3, 2, 1, 0]) {
                others[triangle] = cell[0].parse().expect("a tetrahedron");
                let three: Vec<u8> = cell[1].bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0').collect();
                let corners = (0..4).filter(|corner| *corner != triangle);
                corners.zip(&three).for_each(|(corner, image)| images[triangle][corner] = *image);
                images[triangle][triangle] = 6 - three.iter().sum::<u8>();
            }
            (others, images)
        });
        Triangulation::of_rows(rows).expect("a table of a triangulation")
    }

    #[test]
    fn the_table_is_regina_s() {
        for (table, expected) in [(TORUS, "gvLQQedfedffrwawrhh"), (ONE, "bkaaid")] {
            let t = read(table);
            assert_eq!(signature(&t), expected);
            assert_eq!(GluingTable(&t).to_string(), table);
        }
        assert_eq!(GluingTable(&triangulation("bkaaid").expect("a signature")).to_string(), ONE);
    }

    #[test]
    fn the_table_can_be_read_back() {
        for seen in regina() {
            let table = GluingTable(&seen.triangulation).to_string();
            assert_eq!(read(&table), seen.triangulation);
            // Numbers of up to five digits keep the columns.
            assert!(table.lines().skip(2).all(|line| line.len() == 65), "{table}");
        }
    }
}

/// The scheme of tetrahedra with these gluings.
fn scheme(t: &Triangulation) -> GluingScheme {
    let cycles = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
    let mut pairings = Vec::new();
    for (i, triangles) in t.gluings().iter().enumerate() {
        for (triangle, gluing) in triangles.iter().enumerate() {
            let (j, other) = (gluing.tetrahedron as usize, gluing.corners.image(triangle));
            if (i, triangle) < (j, other) {
                let place = |c: usize| {
                    let image = gluing.corners.image(cycles[triangle][c]);
                    cycles[other].iter().position(|v| *v == image).expect("a corner of the other triangle") as i64
                };
                let dir = if (place(1) - place(0)).rem_euclid(3) == 1 { 1 } else { -1 };
                let face = |polyhedron, face| FaceId { polyhedron, face };
                pairings.push(Pairing { a: face(i, triangle), b: face(j, other), shift: place(0), dir });
            }
        }
    }
    GluingScheme { polyhedra: vec![Polyhedron::tetrahedron(); t.len()], pairings }
}

#[test]
fn regina_and_the_cells_of_a_scheme_agree_on_every_invariant() {
    let mut manifolds = 0;
    for seen in regina() {
        let name = seen.signature;
        assert_eq!(seen.triangulation.skeleton().counts[..3], seen.counts[..], "{name}");
        let manifold = Manifold3::new(scheme(&seen.triangulation));
        assert_eq!(manifold.is_ok(), seen.is_manifold, "{name}");
        let Ok(manifold) = manifold else { continue };
        manifolds += 1;
        assert_eq!(manifold.counts()[..3], seen.counts[..], "{name}");
        assert_eq!(manifold.is_orientable(), seen.is_orientable, "{name}");
        assert_eq!(manifold.component_count(), seen.components, "{name}");
        let homology = manifold.chain_complex().homology();
        let torsion: Vec<String> = homology.torsion[1].iter().map(ToString::to_string).collect();
        let h1 = [vec![homology.betti[1].to_string()], torsion].concat().join(",");
        assert_eq!(h1, seen.h1, "{name}");
    }
    assert_eq!(manifolds, 152);
}
