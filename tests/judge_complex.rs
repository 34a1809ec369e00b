//! The suite of gluing schemes: it passes the oracle, and rejects each wrong answer for what is wrong with it.
#![cfg(feature = "cli")]
#![allow(missing_docs)]

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::scheme::{GluingScheme, Polyhedron, Reason};
use isoracle::judge::candidate::{Candidate, Reply};
use isoracle::judge::complex::questions::{Question, Row, questions};
use isoracle::judge::complex::{Complex, disguised};
use isoracle::judge::report::{Outcome, QuestionRecord, Report};
use isoracle::judge::run::run;
use isoracle::judge::suite::{Judgement, Suite};
use isoracle::partition::Partition;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};
use std::collections::BTreeSet;

const SUITE: Complex = Complex { seed: 7, cases: 3 };

/// The oracle, its answers altered.
struct Altered<F>(F);

impl<F: FnMut(&str, &Value, Value) -> Reply> Candidate for Altered<F> {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        let Value::Object(fields) = input else { panic!("an object") };
        match isoracle::answer::out(op, fields) {
            Ok(out) => (self.0)(op, input, out.value()),
            Err(refusal) => {
                let kind = refusal.kind().expect("the operation is there").name().to_owned();
                Reply::Error { kind, message: refusal.to_string() }
            }
        }
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

fn altered(mut alter: impl FnMut(&str, &Value, &mut Value)) -> Altered<impl FnMut(&str, &Value, Value) -> Reply> {
    Altered(move |op: &str, input: &Value, mut out: Value| {
        alter(op, input, &mut out);
        Reply::Out(out)
    })
}

fn judged(alter: impl FnMut(&str, &Value, &mut Value)) -> Report {
    run(&mut altered(alter), &SUITE, |_, _| {}).unwrap()
}

/// The faults of altered answers, by the rows that show them; nothing is shrunk.
fn asked(candidate: &mut dyn Candidate) -> BTreeSet<(&'static str, &'static str)> {
    let faults = questions(7, 3).into_iter().filter_map(|question| match SUITE.ask(candidate, &question) {
        Judgement::Right { .. } => None,
        Judgement::Wrong { fault, .. } => Some((question.row.name(), fault)),
        Judgement::Unsupported(why) => panic!("{why}"),
        Judgement::Broken(why) => panic!("{why}"),
    });
    faults.collect()
}

fn faults(found: &BTreeSet<(&'static str, &'static str)>) -> BTreeSet<&'static str> {
    found.iter().map(|(_, fault)| *fault).collect()
}

fn glue(scheme: &GluingScheme) -> Value {
    let Value::Object(input) = question(scheme).input() else { panic!("an object") };
    isoracle::answer::out("complex.glue", &input).unwrap().value()
}

fn question(scheme: &GluingScheme) -> Question {
    Question { row: Row::Several, scheme: scheme.clone(), order: None }
}

/// The scheme of a failure.
fn scheme_of(record: &QuestionRecord) -> GluingScheme {
    let QuestionRecord::Other { input, .. } = record else { panic!("not about a volume") };
    isoracle::answer::complex::scheme(input.as_object().unwrap()).unwrap()
}

/// V, E, F, P, the number of sides around each edge, that of each face, and the components, by joining corners and sides of
/// the faces along pairings. An edge that is turned on itself is an edge here.
struct Counted {
    cells: [usize; 4],
    rings: Vec<u64>,
    degrees: Vec<u64>,
    components: usize,
    /// How many different pairs of an edge and a face there are.
    different: usize,
}

fn counted(scheme: &GluingScheme) -> Counted {
    let mut place = Vec::new();
    let [mut vertices, mut edges] = [0, 0];
    for p in &scheme.polyhedra {
        place.push([vertices, edges]);
        vertices += p.edges.iter().flatten().map(|v| *v as usize + 1).max().unwrap_or(0);
        edges += p.edges.len();
    }
    let (mut at, mut along) = (Partition::new(vertices), Partition::new(edges));
    let mut parts = Partition::new(scheme.polyhedra.len());
    let side = |polyhedron: usize, face: usize, i: i64| {
        let p = &scheme.polyhedra[polyhedron];
        let sides = &p.faces[face];
        let side = sides[i.rem_euclid(sides.len() as i64) as usize];
        let [begin, _] = p.ends(side).unwrap();
        (place[polyhedron][0] + begin as usize, place[polyhedron][1] + side.index().unwrap())
    };
    for p in &scheme.pairings {
        parts.join(p.a.polyhedron, p.b.polyhedron);
        for i in 0..scheme.face(p.a).unwrap().len() as i64 {
            let j = p.shift + p.dir * i;
            at.join(side(p.a.polyhedron, p.a.face, i).0, side(p.b.polyhedron, p.b.face, j).0);
            // The side after corner i lies on the side after corner j, or before it.
            let other = if p.dir == 1 { j } else { j - 1 };
            along.join(side(p.a.polyhedron, p.a.face, i).1, side(p.b.polyhedron, p.b.face, other).1);
        }
    }
    let mut around = vec![0; edges];
    let mut pairs = BTreeSet::new();
    let mut degrees = Vec::new();
    for (number, p) in scheme.pairings.iter().enumerate() {
        degrees.push(scheme.face(p.a).unwrap().len() as u64);
        for i in 0..scheme.face(p.a).unwrap().len() as i64 {
            let edge = along.find(side(p.a.polyhedron, p.a.face, i).1);
            around[edge] += 1;
            pairs.insert((edge, number));
        }
    }
    let used: BTreeSet<usize> = scheme
        .polyhedra
        .iter()
        .zip(&place)
        .flat_map(|(p, [first, _])| p.edges.iter().flatten().map(move |v| first + *v as usize))
        .collect();
    let classes: BTreeSet<usize> = used.into_iter().map(|v| at.find(v)).collect();
    let mut rings: Vec<u64> = around.into_iter().filter(|n| *n > 0).collect();
    rings.sort_unstable();
    degrees.sort_unstable();
    Counted {
        cells: [classes.len(), rings.len(), scheme.pairings.len(), scheme.polyhedra.len()],
        rings,
        degrees,
        components: (0..scheme.polyhedra.len()).map(|i| parts.find(i)).collect::<BTreeSet<_>>().len(),
        different: pairs.len(),
    }
}

#[test]
fn the_oracle_passes_everything() {
    let report = judged(|_, _, _| {});
    assert_eq!(report.verdict, Outcome::Passed, "{:?}", report.total().faults);
    let expected = |name: &str| if name == "tetrahedra" { 108 } else { SUITE.cases };
    assert!(report.rows().all(|row| row.asked == expected(&row.name) && row.passed == row.asked));
    assert!(report.failures.is_empty() && report.left_out.is_empty());
}

#[test]
fn the_questions_depend_on_the_seed_alone_and_have_what_their_rows_say() {
    let asked = questions(3, 3);
    assert_eq!(asked, questions(3, 3));
    assert_ne!(asked, questions(4, 3));
    for question in asked.iter().filter(|question| question.order.is_none()) {
        let out = glue(&question.scheme);
        let reasons: Vec<&str> =
            out["defects"].as_array().into_iter().flatten().map(|d| d["reason"].as_str().unwrap()).collect();
        match question.row {
            Row::Manifolds | Row::LensSpaces => assert_eq!(out["valid"], true),
            Row::Disconnected => assert!(out["valid"] == true && out["components"].as_u64().unwrap() > 1),
            Row::Invalid(reason) => assert!(reasons.contains(&reason.name()), "{}: {out}", reason.name()),
            Row::Tetrahedra | Row::Cubes => assert_eq!(question.scheme.polyhedra.len(), 1),
            Row::Prisms => assert_eq!(question.scheme.polyhedra.len(), 1),
            Row::Several => assert!(question.scheme.polyhedra.len() > 1),
            Row::Refinements | Row::NoRefinements => unreachable!("they have an order"),
        }
    }
    // Each gluing of the tetrahedron is asked once, however it is written.
    let valid = asked.iter().filter(|q| q.row == Row::Tetrahedra && glue(&q.scheme)["valid"] == true).count();
    assert_eq!(valid, all_tetrahedra().iter().filter(|scheme| glue(scheme)["valid"] == true).count());
}

/// The 108 gluings of the tetrahedron.
fn all_tetrahedra() -> Vec<GluingScheme> {
    let turn = |n: usize| ((n % 3) as i64, if n < 3 { 1 } else { -1 });
    let mut all = Vec::new();
    for [b, c, d] in [[1, 2, 3], [2, 1, 3], [3, 1, 2]] {
        for n in 0..36 {
            let ((s, d1), (t, d2)) = (turn(n / 6), turn(n % 6));
            all.push(paired(Polyhedron::tetrahedron(), &[(0, b, s, d1), (c, d, t, d2)]));
        }
    }
    all
}

/// What an answer says of the scheme itself, not of the names in it.
fn without_names(mut out: Value) -> Value {
    out.as_object_mut().unwrap().remove("message");
    let mut reasons: Vec<String> =
        out["defects"].as_array().into_iter().flatten().map(|d| d["reason"].to_string()).collect();
    reasons.sort_unstable();
    reasons.dedup();
    // Which of several defects comes first is a matter of names.
    out["defects"] = json!(reasons);
    out["reason"] = json!(out["valid"] == true);
    out
}

mod cx_605 {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn no_answer_depends_on_how_a_gluing_is_written() {
        let mut random = ChaCha8Rng::seed_from_u64(605);
        let mut changed = 0;
        let known = [three_torus(), lens_space(1, 0), lens_space(2, 1), lens_space(7, 3)];
        for scheme in all_tetrahedra().into_iter().chain(known) {
            let other = disguised(&mut random, &scheme);
            changed += usize::from(other != scheme);
            assert_eq!(without_names(glue(&other)), without_names(glue(&scheme)), "{scheme:?} {other:?}");
        }
        assert!(changed > 100);
    }

    #[test]
    fn orders_of_a_face_and_its_partner_are_kept_together() {
        // Were shifts or directions lost, L(7, 2) would become another lens space, or none.
        let mut random = ChaCha8Rng::seed_from_u64(7);
        for _ in 0..50 {
            let out = glue(&disguised(&mut random, &lens_space(7, 2)));
            assert_eq!(out["homology"]["h1"], json!({"rank": 0, "torsion": [7]}));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn nor_that_of_random_ones(seed in any::<u64>(), number in 0_usize..200) {
            let all = questions(seed % 8, 3);
            let of_some_row: Vec<&Question> =
                all.iter().filter(|q| q.row != Row::Tetrahedra && q.scheme.defects().is_empty()).collect();
            let scheme = &of_some_row[number % of_some_row.len()].scheme;
            let other = disguised(&mut ChaCha8Rng::seed_from_u64(seed), scheme);
            prop_assert_eq!(without_names(glue(&other)), without_names(glue(scheme)));
        }
    }
}

mod cx_606 {
    use super::*;

    #[test]
    fn every_number_is_judged() {
        for (pointer, fault) in [
            ("/cells/V", "wrong-counts"),
            ("/cells/E", "wrong-counts"),
            ("/cells/F", "wrong-counts"),
            ("/cells/P", "wrong-counts"),
            ("/chi", "wrong-counts"),
            ("/facet_edge_pairs", "wrong-pairs"),
            ("/components", "wrong-components"),
            ("/homology/h1/rank", "wrong-homology"),
            ("/tetrahedra/V", "wrong-tetrahedra"),
            ("/tetrahedra/E", "wrong-tetrahedra"),
            ("/tetrahedra/F", "wrong-tetrahedra"),
            ("/tetrahedra/T", "wrong-tetrahedra"),
            ("/barycentric/V", "wrong-barycentric"),
            ("/barycentric/E", "wrong-barycentric"),
            ("/barycentric/F", "wrong-barycentric"),
            ("/barycentric/T", "wrong-barycentric"),
        ] {
            let found = asked(&mut altered(|op, _, out| {
                if let (true, Some(n)) = (op == "complex.glue", out.pointer_mut(pointer)) {
                    *n = json!(n.as_i64().unwrap() + 1);
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from([fault]), "{pointer}");
        }
        for name in ["valid", "orientable"] {
            let found = asked(&mut altered(|op, _, out| {
                if op == "complex.glue" && out[name].is_boolean() {
                    out[name] = json!(!out[name].as_bool().unwrap());
                }
            }));
            let fault = if name == "valid" { "wrong-validity" } else { "wrong-orientability" };
            assert_eq!(faults(&found), BTreeSet::from([fault]));
            let rows = found.iter().map(|(row, _)| *row).collect::<BTreeSet<_>>();
            assert!(name == "orientable" || rows.len() == Row::CASES.len() + Row::GLUED.len(), "{rows:?}");
        }
        for name in ["edge_ring_sizes", "face_degrees"] {
            let found = asked(&mut altered(|op, _, out| {
                if let (true, Some(list)) = (op == "complex.glue", out.get_mut(name).and_then(Value::as_array_mut)) {
                    list.pop();
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from(["wrong-pairs"]));
        }
    }

    #[test]
    fn lists_have_no_order_and_torsion_is_a_group() {
        let found = asked(&mut altered(|_, _, out| {
            for name in ["edge_ring_sizes", "face_degrees"] {
                if let Some(list) = out.get_mut(name).and_then(Value::as_array_mut) {
                    list.reverse();
                }
            }
            if let Some(list) = out.pointer_mut("/homology/h1/torsion").and_then(Value::as_array_mut) {
                list.insert(0, json!("1"));
                list.reverse();
            }
        }));
        assert!(found.is_empty(), "{found:?}");
        let beside = |p: u32, q: u32| {
            let (mut one, mut other) = (lens_space(p, 1), lens_space(q, 1));
            one.polyhedra.append(&mut other.polyhedra);
            let face = |face| isoracle::complex::scheme::FaceId { polyhedron: 1, face };
            other.pairings.iter_mut().for_each(|p| (p.a, p.b) = (face(0), face(1)));
            one.pairings.append(&mut other.pairings);
            one
        };
        for (p, q, right, wrong) in [
            (
                2,
                6,
                vec![json!([2, 2, 3]), json!(["3", 2, "2"]), json!([6, 2])],
                vec![json!([12]), json!([3, 4]), json!([2, 3])],
            ),
            (
                4,
                6,
                vec![json!([4, 6]), json!([2, 12]), json!([2, 4, 3])],
                vec![json!([24]), json!([2, 2, 6]), json!([8, 3])],
            ),
            (
                12,
                1,
                vec![json!([3, 4]), json!([4, 3, 1])],
                vec![json!([2, 6]), json!([]), json!([0, 12]), json!([-12]), json!("12")],
            ),
        ] {
            let question = question(&beside(p, q));
            let judge = |torsion: &Value| {
                SUITE.ask(&mut altered(|_, _, out| out["homology"]["h1"]["torsion"] = torsion.clone()), &question)
            };
            assert!(right.iter().all(|torsion| matches!(judge(torsion), Judgement::Right { .. })), "{p}, {q}");
            let is_wrong = |torsion| matches!(judge(torsion), Judgement::Wrong { fault: "wrong-homology", .. });
            assert!(wrong.iter().all(is_wrong), "{p}, {q}");
        }
    }

    #[test]
    fn any_reason_that_holds_will_do_and_no_other() {
        let second = asked(&mut altered(|_, _, out| {
            if let Some(last) = out["defects"].as_array().and_then(|defects| defects.last()) {
                out["reason"] = last["reason"].clone();
            }
        }));
        assert!(second.is_empty(), "{second:?}");
        for reason in ["vertex-link", "unmatched-face", "edge-reversed", "no-such-reason"] {
            let found = asked(&mut altered(|op, _, out| {
                if op == "complex.glue" && out["valid"] == false {
                    out["reason"] = json!(reason);
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from(["wrong-reason"]));
            let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
            assert!(!rows.contains(reason), "{rows:?}");
            // The middle of a reversed edge has no sphere around it.
            assert_eq!(rows.contains("edge-reversed"), ["unmatched-face", "no-such-reason"].contains(&reason));
            assert!(rows.contains("face-in-two-pairings"));
        }
    }

    #[test]
    fn a_scheme_that_cannot_be_glued_may_be_refused_and_no_other() {
        let mut refuses = Altered(|_: &str, _: &Value, out: Value| match out["valid"] == false {
            true => Reply::Error { kind: "invalid-input".into(), message: "no".into() },
            false => Reply::Out(out),
        });
        let found = asked(&mut refuses);
        assert_eq!(faults(&found), BTreeSet::from(["refused"]));
        let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
        for reason in
            ["unmatched-face", "polygon-size-mismatch", "face-glued-to-itself", "bad-polyhedron", "bad-pairing"]
        {
            assert!(!rows.contains(reason), "{reason}");
        }
        assert!(rows.contains("edge-reversed") && rows.contains("vertex-link") && !rows.contains("manifolds"));
        let mut limited =
            Altered(|_: &str, _: &Value, _: Value| Reply::Error { kind: "limit".into(), message: "n".into() });
        assert!(matches!(SUITE.ask(&mut limited, &question(&three_torus())), Judgement::Unsupported(_)));
        for kind in ["invalid-input", "degenerate", "internal"] {
            let mut refuses = Altered(|_: &str, _: &Value, _| Reply::Error { kind: kind.into(), message: "n".into() });
            let judgement = SUITE.ask(&mut refuses, &question(&three_torus()));
            assert!(matches!(judgement, Judgement::Wrong { fault: "refused", .. }), "{kind}");
        }
    }

    #[test]
    fn what_is_left_out_is_named_and_saying_nothing_is_wrong() {
        let report = judged(|op, _, out| {
            if op == "complex.glue" {
                *out = json!({"valid": out["valid"]});
            }
        });
        assert_eq!(report.verdict, Outcome::Passed);
        for name in ["reason", "chi", "cells.V", "homology.h1.torsion", "barycentric.T"] {
            assert!(report.left_out.contains(&name.to_owned()), "{name}: {:?}", report.left_out);
        }
        assert!(!report.left_out.contains(&"valid".to_owned()));
        let found = asked(&mut altered(|_, _, out| *out = json!({"more": 1})));
        assert_eq!(faults(&found), BTreeSet::from(["says-nothing"]));
    }

    #[test]
    fn numbers_are_those_of_cells_joined_by_hand() {
        let mut some = 0;
        for question in questions(11, 6) {
            let out = glue(&question.scheme);
            if out["cells"].is_null() {
                continue;
            }
            some += 1;
            let counted = counted(&question.scheme);
            let cells = ["V", "E", "F", "P"].map(|name| out["cells"][name].as_u64().unwrap() as usize);
            assert_eq!(cells, counted.cells);
            assert_eq!(out["edge_ring_sizes"], json!(counted.rings));
            assert_eq!(out["face_degrees"], json!(counted.degrees));
            assert_eq!(out["facet_edge_pairs"], json!(counted.degrees.iter().sum::<u64>()));
            assert_eq!(out["facet_edge_pairs"], json!(counted.rings.iter().sum::<u64>()));
            assert_eq!(out["components"], json!(counted.components));
        }
        assert!(some > 60, "{some}");
    }
}

#[test]
fn pairs_without_multiplicity_are_caught_in_the_projective_space() {
    let report = judged(|op, input, out| {
        if op == "complex.glue" && out["cells"].is_object() {
            let scheme = isoracle::answer::complex::scheme(input.as_object().unwrap()).unwrap();
            out["facet_edge_pairs"] = json!(counted(&scheme).different);
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    let failure = report.failures.iter().find(|failure| failure.row == "manifolds").unwrap();
    assert_eq!(
        (failure.fault.as_str(), failure.differences[0].invariant.as_str()),
        ("wrong-pairs", "facet_edge_pairs")
    );
    // L(2, 1): one edge, twice a side of the one face.
    assert_eq!(scheme_of(&failure.question), lens_space_as_shrunk());
    assert_eq!((failure.differences[0].expected.as_str(), failure.differences[0].found.as_str()), ("2", "1"));
    assert!(failure.command.starts_with("isoracle judge --suite complex --question "), "{}", failure.command);
}

/// L(2, 1) with its shift 0 … n − 1.
fn lens_space_as_shrunk() -> GluingScheme {
    let mut scheme = lens_space(2, 1);
    scheme.pairings[0].shift = 1;
    scheme
}

#[test]
fn the_euler_characteristic_alone_is_caught_where_edges_are_reversed() {
    let report = judged(|op, input, out| {
        if op != "complex.glue" {
            return;
        }
        let scheme = isoracle::answer::complex::scheme(input.as_object().unwrap()).unwrap();
        if scheme.defects().is_empty() {
            let [v, e, f, p] = counted(&scheme).cells.map(|n| n as i64);
            *out = json!({"valid": v - e + f - p == 0});
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    assert!(report.failures.iter().all(|failure| failure.fault == "wrong-validity"));
    let rows: BTreeSet<&str> = report.failures.iter().map(|failure| failure.row.as_str()).collect();
    assert!(rows.contains("edge-reversed") && !rows.contains("vertex-link") && !rows.contains("manifolds"));
    let smallest = report.failures.iter().find(|failure| failure.row == "edge-reversed").unwrap();
    let scheme = scheme_of(&smallest.question);
    assert!(scheme.polyhedra.len() == 1 && scheme.polyhedra[0].faces.len() == 2, "{scheme:?}");
    assert_eq!(glue(&scheme)["reason"], "edge-reversed");
}

#[test]
fn a_missed_reason_is_shown_by_a_small_scheme() {
    for reason in [Reason::UnmatchedFace, Reason::FaceInTwoPairings, Reason::BadPolyhedron, Reason::VertexLink] {
        let report = judged(|op, _, out| {
            let is_there = out["defects"].as_array().into_iter().flatten().any(|d| d["reason"] == reason.name());
            if op == "complex.glue" && is_there {
                *out = json!({"valid": true});
            }
        });
        let failure = report.failures.iter().find(|failure| failure.row == reason.name()).unwrap();
        let scheme = scheme_of(&failure.question);
        let sides: usize = scheme.polyhedra.iter().flat_map(|p| &p.faces).map(Vec::len).sum();
        assert!(scheme.polyhedra.len() <= 1 && sides <= 12, "{}: {scheme:?}", reason.name());
        let out = glue(&scheme);
        assert!(out["defects"].as_array().unwrap().iter().any(|d| d["reason"] == reason.name()), "{out}");
    }
}

#[test]
fn a_fault_that_needs_two_components_keeps_them() {
    let report = judged(|op, _, out| {
        if op == "complex.glue" && out["components"].is_number() {
            out["components"] = json!(1);
        }
    });
    let failure = report.failures.iter().find(|failure| failure.row == "disconnected").unwrap();
    let scheme = scheme_of(&failure.question);
    assert_eq!(ClosedComplex::new(scheme.clone()).unwrap().component_count(), 2);
    let sides: usize = scheme.polyhedra.iter().flat_map(|p| &p.faces).map(Vec::len).sum();
    assert_eq!((scheme.polyhedra.len(), sides), (2, 4), "{scheme:?}");
}

#[test]
fn a_question_is_read_as_it_is_quoted() {
    for question in questions(5, 2) {
        let Value::Object(text) = SUITE.text(&question) else { panic!("an object") };
        let read = SUITE.parse(&text).unwrap();
        assert_eq!(SUITE.text(&read), SUITE.text(&question));
        assert!(matches!(SUITE.ask(&mut altered(|_, _, _| {}), &read), Judgement::Right { .. }));
    }
}

/// The printed number of edges of a refinement, t(k³ + k² + 1), is caught; so are other wrong numbers of it.
#[test]
fn wrong_refinements_are_caught_and_shown_at_a_small_order() {
    let is_there = isoracle::answer::OPERATIONS.iter().any(|(name, _)| *name == "complex.refine");
    assert_eq!(questions(1, 1).iter().any(|question| question.order.is_some()), is_there);
    if !is_there {
        return;
    }
    let report = judged(|op, _, out| {
        if op == "complex.refine" {
            out["E"] = out["as_printed"]["E"].clone();
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    assert!(report.failures.iter().all(|f| f.row == "refinements" && f.fault == "wrong-counts"));
    let failure = &report.failures[0];
    let QuestionRecord::Other { op, input } = &failure.question else { panic!("not about a volume") };
    // The 3-sphere of one monogon has t = 1 and V + P = 2, for which the printed number holds up to order 3 alone.
    assert_eq!((op.as_str(), &input["order"]), ("complex.refine", &json!(4)));
    assert_eq!(counted(&scheme_of(&failure.question)).cells, [1; 4]);
    assert_eq!(counted(&scheme_of(&failure.question)).degrees, [1]);
    for (name, fault) in [
        ("V", "wrong-counts"),
        ("F", "wrong-counts"),
        ("T", "wrong-counts"),
        ("simplicial", "wrong-simpliciality"),
        ("degenerate_tetrahedra", "wrong-degenerates"),
        ("duplicate_tetrahedra", "wrong-duplicates"),
        ("as_printed", "wrong-printed"),
    ] {
        let found = asked(&mut altered(|op, _, out| {
            if op == "complex.refine" {
                out[name] = match &out[name] {
                    Value::Bool(is_so) => json!(!is_so),
                    Value::Number(n) => json!(n.as_u64().unwrap() + 1),
                    _ => json!({"E": -1}),
                };
            }
        }));
        assert_eq!(found, BTreeSet::from([("refinements", fault)]), "{name}");
    }
    let mut refines_all = Altered(|_: &str, _: &Value, out: Value| Reply::Out(out));
    let none = questions(7, 8).into_iter().filter(|question| question.row == Row::NoRefinements);
    assert!(
        none.clone().count() == 8
            && none.into_iter().all(|q| matches!(SUITE.ask(&mut refines_all, &q), Judgement::Right { .. }))
    );
}

#[test]
fn the_command_judges_the_oracle_and_asks_a_quoted_question_again() {
    let folder = tempfile::tempdir().unwrap();
    let isoracle = assert_cmd::cargo::cargo_bin!("isoracle");
    let run = |arguments: &[&str]| {
        let mut command = assert_cmd::Command::new(isoracle);
        let output =
            command.current_dir(folder.path()).args(["judge", "--suite", "complex"]).args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let own = isoracle.to_str().unwrap();
    let (code, out) = run(&["--cases", "20", "--report", "report", "--", own, "answer"]);
    assert_eq!(code, Some(0), "{out}");
    assert!(out.contains("face-in-two-pairings") && out.contains("tetrahedra"), "{out}");
    let page = std::fs::read_to_string(folder.path().join("report/report.html")).unwrap();
    assert!(page.contains("kinds of schemes") && !page.contains("kinds of meshes"));
    let text = json!({"op": "complex.glue", "in": question(&three_torus()).input()}).to_string();
    assert_eq!(run(&["--question", &text, "--", own, "answer"]), (Some(0), "right\n".to_owned()));
}
