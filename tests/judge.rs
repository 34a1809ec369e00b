//! The judge: it passes the oracle, rejects each broken candidate for its own reason, and outlives what breaks.
#![cfg(feature = "cli")]
#![allow(missing_docs)]

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::judge::candidate::{Breakdown, Candidate, Process, Reply};
use isoracle::judge::isosurface::Isosurface;
use isoracle::judge::isosurface::builtin::Builtin;
use isoracle::judge::isosurface::candidate_mesh::{CandidateMesh, Positions};
use isoracle::judge::isosurface::fault::Fault;
use isoracle::judge::isosurface::place::Tolerance;
use isoracle::judge::isosurface::questions::{Question, Row, questions};
use isoracle::judge::isosurface::tie::judge_tied;
use isoracle::judge::isosurface::verdict::{judge, welded};
use isoracle::judge::report::{Outcome, Report};
use isoracle::judge::run::run;
use isoracle::judge::suite::{Judgement, Suite};
use isoracle::number::Rational;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::time::{Duration, Instant};

const SUITE: Isosurface = Isosurface { seed: 7, cases: 40, tolerance: Tolerance(64.0) };

/// A candidate in this process.
struct InProcess {
    answer: Box<Answer>,
}

type Answer = dyn FnMut(&str, &Value) -> Reply;

impl Candidate for InProcess {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        (self.answer)(op, input)
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

fn oracle() -> InProcess {
    let answer = |op: &str, input: &Value| {
        let line = json!({"id": 1, "op": op, "in": input}).to_string();
        let mut message: Value = serde_json::from_str(&isoracle::answer::answer(line.as_bytes())).unwrap();
        Reply::Out(message["out"].take())
    };
    InProcess { answer: Box::new(answer) }
}

fn builtin(builtin: Builtin) -> InProcess {
    let answer = move |op: &str, input: &Value| {
        let line = json!({"id": 1, "op": op, "in": input}).to_string() + "\n";
        let mut out = Vec::new();
        isoracle::judge::builtin::serve(isoracle::judge::builtin::Builtin::Mesher(builtin), line.as_bytes(), &mut out)
            .unwrap();
        let mut message: Value = serde_json::from_slice(&out).unwrap();
        Reply::Out(message["out"].take())
    };
    InProcess { answer: Box::new(answer) }
}

fn judged(which: Builtin) -> Report {
    run(&mut builtin(which), &SUITE, |_, _| {}).unwrap()
}

fn failing_cases(report: &Report) -> Vec<&str> {
    report.cases.iter().filter(|row| row.passed < row.asked).map(|row| row.name.as_str()).collect()
}

fn faults(report: &Report) -> BTreeSet<&str> {
    report.rows().flat_map(|row| &row.faults).map(|(name, _)| name.as_str()).collect()
}

#[test]
fn the_oracle_passes_everything() {
    let report = run(&mut oracle(), &SUITE, |_, _| {}).unwrap();
    assert_eq!(report.verdict, Outcome::Passed, "{:?}", faults(&report));
    assert!(report.rows().all(|row| row.asked > 0 && row.passed == row.asked));
    assert!(report.failures.is_empty());
}

#[test]
fn our_mesher_in_binary64_passes_everything() {
    let report = judged(Builtin::Right);
    assert_eq!(report.verdict, Outcome::Passed, "{:?}", faults(&report));
    assert!(report.position_error.binary64_ulp <= 0.5);
}

#[test]
fn the_table_of_1987_is_wrong_where_a_face_or_the_inside_is_ambiguous() {
    let report = judged(Builtin::Classic);
    assert_eq!(report.verdict, Outcome::Wrong);
    let failing = failing_cases(&report);
    for case in ["0", "1", "2", "5", "8", "9", "11", "14", "3.1", "4.1", "6.1.1", "7.1"] {
        assert!(!failing.contains(&case), "case {case} has nothing to get wrong");
    }
    for case in ["3.2", "4.2", "6.1.2", "6.2", "7.2", "7.3", "7.4.2", "10.2", "12.2", "12.3", "13.2", "13.5.2"] {
        assert!(failing.contains(&case), "case {case} needs a decision that the table does not make");
    }
}

#[test]
fn a_wrong_face_rule_shows_as_wrong_loops() {
    let report = judged(Builtin::WrongFaceRule);
    assert!(faults(&report).contains("wrong-loops"));
    assert!(failing_cases(&report).contains(&"3.2") && failing_cases(&report).contains(&"13.3"));
}

#[test]
fn a_wrong_interior_rule_shows_as_wrong_components_in_the_tunnel_cases_alone() {
    let report = judged(Builtin::WrongInteriorRule);
    assert_eq!(failing_cases(&report), ["4.2", "6.1.2", "7.4.2", "10.1.2", "12.1.2", "13.5.2"]);
    for row in &report.cases {
        assert!(row.faults.iter().all(|(name, _)| name == "wrong-components"), "{row:?}");
    }
}

#[test]
fn a_flipped_triangle_shows_as_inconsistent_winding_or_a_reversed_piece() {
    let report = judged(Builtin::FlippedTriangle);
    assert_eq!(failing_cases(&report).len(), 32, "all but the empty case 0");
    assert!(faults(&report).contains("inconsistent-winding"));
    // A piece of one triangle has no neighbour to disagree with.
    let one = report.cases.iter().find(|row| row.name == "1").unwrap();
    assert_eq!(one.faults, [("reversed-orientation".to_owned(), one.asked)]);
}

#[test]
fn a_duplicated_triangle_shows_as_one() {
    let report = judged(Builtin::DuplicatedTriangle);
    assert_eq!(failing_cases(&report).len(), 32);
    assert!(report.cases.iter().all(|row| row.faults.iter().all(|(name, _)| name == "duplicate-triangle")));
}

#[test]
fn a_hole_shows_as_one() {
    let report = judged(Builtin::Hole);
    assert_eq!(failing_cases(&report).len(), 32);
    let eight = report.cases.iter().find(|row| row.name == "8").unwrap();
    assert_eq!(eight.faults, [("hole".to_owned(), eight.asked)]);
}

#[test]
fn an_edge_in_a_face_shows_in_single_cells_and_breaks_pairs() {
    let report = judged(Builtin::EdgeInFace);
    assert_eq!(report.verdict, Outcome::Wrong);
    assert!(report.cases.iter().all(|row| row.faults.iter().all(|(name, _)| name == "edge-in-face")));
    let seen = faults(&report);
    assert!(seen.contains("edge-with-more-than-two-triangles") || seen.contains("duplicate-triangle"), "{seen:?}");
}

#[test]
fn the_smallest_failing_cells_have_small_integers_and_fail_again() {
    let report = judged(Builtin::WrongInteriorRule);
    for failure in report.failures.iter().filter(|failure| failure.row.contains('.')) {
        let question = failure.question.volume().unwrap();
        assert_eq!(question.shape, [2, 2, 2]);
        let values: Vec<i64> = question.values.iter().map(|v| v.parse().unwrap()).collect();
        assert!(values.iter().all(|v| v.abs() <= 4), "{values:?}");
        assert!(!failure.differences.is_empty() && failure.expected.is_some() && failure.found.is_some());
        let case = Case::ALL.iter().copied().find(|case| case.name() == failure.row).unwrap();
        let volume = Volume::rationals([2; 3], values.into_iter().map(Rational::from).collect()).unwrap();
        let question = Question { row: Row::Cell(case), volume, isovalue: Rational::new() };
        match SUITE.ask(&mut builtin(Builtin::WrongInteriorRule), &question) {
            Judgement::Wrong { fault, .. } => assert_eq!(fault, failure.fault),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn the_suite_holds_every_case_in_every_orientation_and_depends_on_its_seed_alone() {
    let suite = questions(3, 10);
    assert_eq!(suite, questions(3, 10));
    assert_ne!(suite, questions(4, 10));
    for case in Case::ALL {
        let cells = suite.iter().filter(|q| q.row == Row::Cell(*case)).count();
        assert!(cells >= 48, "{case}: {cells}");
    }
    for row in Row::GROUPS {
        assert!(suite.iter().filter(|q| q.row == row).count() >= 10);
    }
}

#[test]
fn questions_outside_the_ties_are_not_degenerate_and_ties_are() {
    for question in questions(11, 60) {
        let level = question.level(Tie::Degenerate);
        let is_tied = question.volume.cells().any(|cell| level.decisions(cell).is_err());
        assert_eq!(is_tied, question.row == Row::Ties, "{question:?}");
    }
}

/// The volume whose middle face has determinant 0.
fn tied_volume() -> Volume {
    let values = [13, -1, 15, -1, 7, -3, -1, 1, -9, -7, -7, -1];
    Volume::integers([3, 2, 2], values.to_vec()).unwrap()
}

fn candidate_mesh(level: &Level) -> CandidateMesh {
    let (positions, triangles) = Builtin::Right.mesh(level).unwrap();
    CandidateMesh { positions: Positions::Floats(positions), triangles }
}

#[test]
fn at_a_tie_both_sides_are_right_and_a_mixture_is_not() {
    let volume = tied_volume();
    let zero = Rational::new();
    assert!(volume.cells().any(|cell| {
        Level { volume: &volume, isovalue: zero.clone(), tie: Tie::Degenerate }.decisions(cell).is_err()
    }));
    let mut right = Vec::new();
    for epsilon in [-1, 1] {
        let isovalue = Rational::from((epsilon, 1_000_000));
        let mesh = candidate_mesh(&Level { volume: &volume, isovalue, tie: Tie::Degenerate });
        let verdict = judge_tied(&volume, &zero, &mesh, Tolerance(1e9)).unwrap();
        assert_eq!(verdict.faults, [], "ε = {epsilon}e-6");
        right.push(mesh);
    }
    assert_ne!(right[0].triangles, right[1].triangles, "the two sides of this tie differ");
    // The first cell decided one way and the second the other: the surfaces do not meet.
    let mixed = judge_tied(&volume, &zero, &mixture(&volume), Tolerance(1e9)).unwrap();
    assert!(!mixed.faults.is_empty());
}

/// One cell's triangles from just below, the other's from just above.
fn mixture(volume: &Volume) -> CandidateMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (cell, epsilon) in [(0, -1), (1, 1)] {
        let half = volume.crop([cell, 0, 0], [cell + 1, 1, 1]).unwrap();
        let level = Level { volume: &half, isovalue: Rational::from((epsilon, 1_000_000)), tie: Tie::Degenerate };
        let (part, faces) = Builtin::Right.mesh(&level).unwrap();
        let base = positions.len() as u32;
        // The same positions on the face between them, so that welding can join what meets.
        let at_zero = |x: f64| (x * 1000.0).round() / 1000.0;
        positions.extend(part.into_iter().map(|[x, y, z]| [at_zero(x) + cell as f64, at_zero(y), at_zero(z)]));
        triangles.extend(faces.into_iter().map(|t| t.map(|v| v + base)));
    }
    CandidateMesh { positions: Positions::Floats(positions), triangles }
}

#[test]
fn a_soup_is_welded_before_it_is_judged() {
    let volume = Volume::integers([3, 3, 3], (0..27).map(|i| if i == 13 { 1 } else { -1 }).collect()).unwrap();
    let level = Level { volume: &volume, isovalue: Rational::from((1, 3)), tie: Tie::Degenerate };
    let mesh = candidate_mesh(&level);
    let Positions::Floats(positions) = &mesh.positions else { unreachable!() };
    let corners = mesh.triangles.iter().flatten().map(|&v| positions[v as usize]).collect::<Vec<_>>();
    let triangles = (0..corners.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let soup = CandidateMesh { positions: Positions::Floats(corners), triangles };
    assert_eq!(welded(&soup).positions.len(), mesh.positions.len());
    let verdict = judge(&level, &soup, Tolerance::default()).unwrap();
    assert!(verdict.faults.is_empty() && verdict.welded);
}

#[test]
fn vertices_off_their_crossings_are_told() {
    let volume = Volume::integers([2; 3], vec![3, -1, -1, -1, -1, -1, -1, -1]).unwrap();
    let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Degenerate };
    let mesh = |x: f64| CandidateMesh {
        positions: Positions::Floats(vec![[x, 0.0, 0.0], [0.0, 0.75, 0.0], [0.0, 0.0, 0.75]]),
        triangles: vec![[0, 2, 1]],
    };
    let name = |x: f64| judge(&level, &mesh(x), Tolerance::default()).unwrap().faults.first().map(Fault::name);
    assert_eq!(name(0.75), None);
    assert_eq!(name(0.750_000_1), None, "two units of binary32 are within the tolerance");
    assert_eq!(name(0.7501), Some("misplaced-vertex"));
    assert_eq!(name(-0.5), Some("outside-grid"));
    assert_eq!(name(f64::NAN), Some("not-finite"));
    let turned = CandidateMesh { triangles: vec![[0, 1, 2]], ..mesh(0.75) };
    assert_eq!(judge(&level, &turned, Tolerance::default()).unwrap().faults[0].name(), "reversed-orientation");
}

fn script(python: &str) -> Process {
    let command = ["python3".to_owned(), "-c".to_owned(), python.to_owned()];
    Process::new(command.into(), Duration::from_millis(2500))
}

const HELLO: &str = "import sys, json\nfor line in sys.stdin:\n q = json.loads(line)\n if q['op'] == 'hello':\n  print(json.dumps({'id': q['id'], 'out': {'protocol': 1, 'name': 'x', 'version': '0', 'ops': ['isosurface.mesh']}}), flush=True)\n else:\n";

#[test]
fn what_hangs_dies_or_prints_garbage_costs_the_question_alone() {
    type Way = (&'static str, fn(&Breakdown) -> bool);
    let ways: [Way; 4] = [
        ("  import time; time.sleep(60)", |b| matches!(b, Breakdown::Hung(_))),
        ("  sys.exit(3)", |b| matches!(b, Breakdown::Ended(_))),
        ("  print('garbage', flush=True)", |b| matches!(b, Breakdown::Nonsense(_))),
        ("  print(json.dumps({'id': -1, 'out': {}}), flush=True)", |b| matches!(b, Breakdown::Nonsense(_))),
    ];
    let volume = Volume::integers([2; 3], vec![3, -1, -1, -1, -1, -1, -1, -1]).unwrap();
    let question = Question { row: Row::Cell(Case::C1), volume, isovalue: Rational::new() };
    for (way, is_expected) in ways {
        let mut candidate = script(&format!("{HELLO}{way}\n"));
        for _ in 0..2 {
            let start = Instant::now();
            match SUITE.ask(&mut candidate, &question) {
                Judgement::Broken(breakdown) => assert!(is_expected(&breakdown), "{way}: {breakdown}"),
                other => panic!("{way}: {other:?}"),
            }
            assert!(start.elapsed() < Duration::from_secs(20));
        }
        // It is started anew, and says hello again.
        assert!(matches!(candidate.ask("hello", &json!({"protocol": 1})), Reply::Out(_)), "{way}");
    }
}

#[test]
fn a_candidate_that_cannot_be_started_or_says_no_hello_ends_the_run() {
    let mut missing = Process::new(vec!["/no/such/program".into()], Duration::from_secs(1));
    assert!(matches!(run(&mut missing, &SUITE, |_, _| {}), Err(Breakdown::NotStarted(_))));
    let mut silent = script("import time; time.sleep(60)");
    assert!(matches!(run(&mut silent, &SUITE, |_, _| {}), Err(Breakdown::Hung(_))));
}

#[test]
fn an_error_for_a_question_with_an_answer_is_wrong_and_a_refusal_is_not() {
    let volume = Volume::integers([2; 3], vec![3, -1, -1, -1, -1, -1, -1, -1]).unwrap();
    let question = Question { row: Row::Cell(Case::C1), volume, isovalue: Rational::new() };
    let says = |reply: Reply| InProcess { answer: Box::new(move |_, _| reply.clone()) };
    let error = |kind: &str| Reply::Error { kind: kind.into(), message: "no".into() };
    let asked = |reply| SUITE.ask(&mut says(reply), &question);
    assert!(matches!(asked(error("invalid-input")), Judgement::Wrong { .. }));
    assert!(matches!(asked(error("degenerate")), Judgement::Wrong { .. }));
    assert!(matches!(asked(error("limit")), Judgement::Unsupported(_)));
    assert!(matches!(asked(Reply::Unsupported("no".into())), Judgement::Unsupported(_)));
    assert!(matches!(asked(Reply::Out(json!({"vertices": 3}))), Judgement::Broken(_)));
    assert!(matches!(asked(Reply::Out(json!({"vertices": [], "faces": [[0, 1, 2]]}))), Judgement::Wrong { .. }));
}
