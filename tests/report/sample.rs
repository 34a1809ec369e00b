//! A handmade run, with the meshes of true cells and of cells that were decided wrongly.

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Decisions, Tie, assemble};
use isoracle::isosurface::patch::{PatchVertex, patch};
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::judge::report::{
    CandidateInfo, Difference, Failure, Outcome, PositionError, QuestionRecord, Report, Row, Seconds, SurfaceRecord,
    VolumeQuestion,
};
use isoracle::number::Rational;

/// A question about integers with isovalue 0.
pub fn question(shape: [usize; 3], values: &[i32]) -> VolumeQuestion {
    VolumeQuestion {
        op: "isosurface.mesh".to_owned(),
        shape,
        values: values.iter().map(ToString::to_string).collect(),
        isovalue: "0".to_owned(),
    }
}

/// The mesh of a question with integers, each cell decided as `decide` alters its true decisions; cells
/// share no vertices, as in the output of a parallel implementation.
pub fn surface(question: &VolumeQuestion, decide: impl Fn([usize; 3], Decisions) -> Decisions) -> SurfaceRecord {
    let values = question.values.iter().map(|v| v.parse().expect("integers")).collect();
    let volume = Volume::integers(question.shape, values).expect("the values fit the shape");
    let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Below };
    let mut surface = SurfaceRecord { vertices: Vec::new(), faces: Vec::new() };
    for cell in volume.cells() {
        let decisions = level.decisions(cell).expect("ties are broken");
        let patch = patch(&assemble(decide(cell, decisions)));
        let crossing = |edge| level.crossing_position(level.grid_edge(cell, edge)).map(|x| x.to_f64());
        for triangle in &patch.triangles {
            let first = u32::try_from(surface.vertices.len()).expect("few vertices");
            surface.faces.push([first, first + 1, first + 2]);
            surface.vertices.extend(triangle.map(|vertex| match vertex {
                PatchVertex::Crossing(edge) => crossing(edge),
                PatchVertex::Inner(i) => {
                    let rim = &patch.inner[usize::from(i)];
                    let sum = rim.iter().fold([0.0; 3], |sum, e| {
                        let p = crossing(*e);
                        [0, 1, 2].map(|i| sum[i] + p[i])
                    });
                    sum.map(|x| x / rim.len() as f64)
                }
            }));
        }
    }
    surface
}

/// The true mesh.
pub fn truth(question: &VolumeQuestion) -> SurfaceRecord {
    surface(question, |_, decisions| decisions)
}

fn difference(invariant: &str, expected: &str, found: &str) -> Difference {
    Difference { invariant: invariant.to_owned(), expected: expected.to_owned(), found: found.to_owned() }
}

struct Way<'a> {
    row: &'a str,
    case: &'a str,
    fault: &'a str,
    formula: &'a str,
    message: &'a str,
}

fn failure(way: &Way, question: VolumeQuestion, found: Option<SurfaceRecord>, differences: Vec<Difference>) -> Failure {
    Failure {
        row: way.row.to_owned(),
        case: way.case.to_owned(),
        fault: way.fault.to_owned(),
        formula: way.formula.to_owned(),
        messages: vec![way.message.to_owned()],
        expected: Some(truth(&question)),
        found,
        differences,
        command: format!("isoracle judge --seed 7 --only {}/{} -- ./fastmc --protocol", way.row, way.fault),
        question: QuestionRecord::Volume(question),
    }
}

/// A tunnel that was not seen.
pub fn missed_tunnel() -> Failure {
    let way = Way {
        row: "13.5.2",
        case: "13.5.2",
        fault: "wrong-components",
        formula: "IS-58",
        message: "The cell's surface has 2 components, one of them an annulus; the mesh has 3 disks.",
    };
    let question = question([2, 2, 2], &[1, -3, -4, 4, -7, 4, 9, -5]);
    let found = surface(&question, |_, decisions| Decisions { tunnel: None, ..decisions });
    let differences = vec![
        difference("χ", "1", "3"),
        difference("components", "2", "3"),
        difference("loops by component of cell [0, 0, 0]", "[1, 2]", "[1, 1, 1]"),
    ];
    failure(&way, question, Some(found), differences)
}

/// Two cells that disagree about the face between them.
pub fn crack() -> Failure {
    let way = Way {
        row: "pairs",
        case: "3.2",
        fault: "open-edge",
        formula: "IS-46",
        message: "4 edges inside the grid have one triangle: the cells disagree about the face between them.",
    };
    let question = question([3, 2, 2], &[-2, 5, -3, -4, -1, -6, -3, -1, -2, -5, 4, -4]);
    let found = surface(&question, |cell, decisions| match cell {
        [1, 0, 0] => Decisions { faces: decisions.faces.map(|sign| -sign), ..decisions },
        _ => decisions,
    });
    let differences = vec![difference("edges with one triangle inside the grid", "0", "4"), difference("χ", "1", "2")];
    failure(&way, question, Some(found), differences)
}

/// A surface turned inside out.
pub fn inside_out() -> Failure {
    let way = Way {
        row: "5",
        case: "5",
        fault: "wrong-orientation",
        formula: "IS-36",
        message: "The normals of 3 triangles point toward f < c.",
    };
    let question = question([2, 2, 2], &[9, 1, 6, 1, -7, -9, 1, -1]);
    let mut found = truth(&question);
    found.faces.iter_mut().for_each(|[a, b, _]| std::mem::swap(a, b));
    failure(&way, question, Some(found), vec![difference("triangles with normals toward f > c", "3", "0")])
}

/// No answer.
pub fn crash() -> Failure {
    let way = Way {
        row: "grids",
        case: "7.4.2",
        fault: "crash",
        formula: "IS-61",
        message: "It ended with signal 11 before it answered.",
    };
    failure(&way, question([2, 2, 2], &[-7, 8, -8, -4, 9, -8, -9, 9]), None, Vec::new())
}

fn row(name: &str, asked: usize, wrong: usize, broken: usize, faults: &[(&str, usize)]) -> Row {
    Row {
        name: name.to_owned(),
        asked,
        passed: asked - wrong - broken,
        wrong,
        broken,
        unsupported: 0,
        faults: faults.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect(),
    }
}

/// A run with four ways of failing.
pub fn report() -> Report {
    let case_row = |case: &Case| match case.name() {
        "13.5.2" => row("13.5.2", 1200, 1187, 0, &[("wrong-components", 1187)]),
        "5" => row("5", 1200, 1, 0, &[("wrong-orientation", 1)]),
        name => row(name, 1200, 0, 0, &[]),
    };
    let mut ties = row("ties", 240, 0, 0, &[]);
    (ties.passed, ties.unsupported) = (200, 40);
    Report {
        report: 1,
        candidate: CandidateInfo {
            name: "fastmc".to_owned(),
            version: "2.1".to_owned(),
            command: vec!["./fastmc".to_owned(), "--protocol".to_owned()],
        },
        suite: "isosurface".to_owned(),
        seed: 7,
        verdict: Outcome::Broken,
        cases: Case::ALL.iter().map(case_row).collect(),
        groups: vec![
            row("pairs", 2000, 310, 0, &[("open-edge", 310), ("wrong-components", 12)]),
            row("grids", 150, 0, 2, &[("crash", 2)]),
            row("near-degenerate", 500, 0, 0, &[]),
            ties,
        ],
        failures: vec![missed_tunnel(), inside_out(), crack(), crash()],
        left_out: Vec::new(),
        position_error: PositionError { binary64_ulp: 1.5, binary32_ulp: 0.0 },
        accuracy: Vec::new(),
        seconds: Seconds { candidate: 1.25, oracle: 6.5, total: 8.125 },
    }
}

/// The same candidate where it is right.
pub fn faultless() -> Report {
    let mut report = report();
    report.verdict = Outcome::Passed;
    report.failures.clear();
    for row in report.cases.iter_mut().chain(&mut report.groups) {
        (row.passed, row.wrong, row.broken) = (row.passed + row.wrong + row.broken, 0, 0);
        row.faults.clear();
    }
    report
}
