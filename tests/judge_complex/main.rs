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

mod answers;
mod shrunk;

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

mod cx_97 {
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

#[test]
fn a_question_is_read_as_it_is_quoted() {
    for question in questions(5, 2) {
        let Value::Object(text) = SUITE.text(&question) else { panic!("an object") };
        let read = SUITE.parse(&text).unwrap();
        assert_eq!(SUITE.text(&read), SUITE.text(&question));
        assert!(matches!(SUITE.ask(&mut altered(|_, _, _| {}), &read), Judgement::Right { .. }));
    }
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
