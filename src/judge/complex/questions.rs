//! The questions of the suite `complex`: the same seed, the same questions.

use super::bases;
use super::disguise::disguised;
use super::plant::plant;
use super::reasons;
use crate::answer::complex;
use crate::answer::value::{self, InvalidField, Object};
use crate::complex::scheme::{FaceId, GluingScheme, Reason};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// A row of the report's tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Row {
    /// Closed 3-manifolds.
    Manifolds,
    /// Schemes that are none, at least for this reason.
    Invalid(Reason),
    /// All gluings of one tetrahedron.
    Tetrahedra,
    /// Gluings of one cube.
    Cubes,
    /// Lens spaces.
    LensSpaces,
    /// Gluings of one prism.
    Prisms,
    /// Several polyhedra glued at random.
    Several,
    /// Several components.
    Disconnected,
    /// Refinements of manifolds.
    Refinements,
    /// Refinements of schemes that are no manifold.
    NoRefinements,
}

impl Row {
    /// Manifolds, and each reason.
    pub const CASES: [Row; 9] = [
        Row::Manifolds,
        Row::Invalid(Reason::UnmatchedFace),
        Row::Invalid(Reason::PolygonSizeMismatch),
        Row::Invalid(Reason::FaceGluedToItself),
        Row::Invalid(Reason::FaceInTwoPairings),
        Row::Invalid(Reason::BadPairing),
        Row::Invalid(Reason::BadPolyhedron),
        Row::Invalid(Reason::EdgeReversed),
        Row::Invalid(Reason::VertexLink),
    ];

    /// The groups beside the cases that ask `complex.glue`.
    pub const GLUED: [Row; 6] =
        [Row::Tetrahedra, Row::Cubes, Row::LensSpaces, Row::Prisms, Row::Several, Row::Disconnected];

    /// Those that ask `complex.refine`.
    pub const REFINED: [Row; 2] = [Row::Refinements, Row::NoRefinements];

    /// The groups beside the cases.
    pub fn groups() -> Vec<Row> {
        [&Row::GLUED[..], &Row::REFINED].concat()
    }

    /// "manifolds", "unmatched-face", …, "refinements".
    pub const fn name(self) -> &'static str {
        match self {
            Row::Manifolds => "manifolds",
            Row::Invalid(reason) => reason.name(),
            Row::Tetrahedra => "tetrahedra",
            Row::Cubes => "cubes",
            Row::LensSpaces => "lens-spaces",
            Row::Prisms => "prisms",
            Row::Several => "several",
            Row::Disconnected => "disconnected",
            Row::Refinements => "refinements",
            Row::NoRefinements => "no-refinements",
        }
    }
}

/// A question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The row that it belongs to.
    pub row: Row,
    /// The scheme.
    pub scheme: GluingScheme,
    /// The order of its refinement, where that is what is asked for.
    pub order: Option<u32>,
}

/// The greatest order that is asked for.
const MOST: u32 = 8;

impl Question {
    /// The operation that is asked.
    pub const fn operation(&self) -> &'static str {
        match self.order {
            None => "complex.glue",
            Some(_) => "complex.refine",
        }
    }

    /// The question's `in`.
    pub fn input(&self) -> Value {
        let polyhedra: Vec<Value> = self
            .scheme
            .polyhedra
            .iter()
            .map(|p| {
                let faces: Vec<Vec<i32>> =
                    p.faces.iter().map(|sides| sides.iter().map(|side| side.0).collect()).collect();
                json!({"edges": p.edges, "faces": faces})
            })
            .collect();
        let face = |id: FaceId| [id.polyhedron, id.face];
        let pairings: Vec<Value> = self
            .scheme
            .pairings
            .iter()
            .map(|p| json!({"a": face(p.a), "b": face(p.b), "shift": p.shift, "dir": p.dir}))
            .collect();
        let mut input = json!({"polyhedra": polyhedra, "pairings": pairings});
        if let Some(order) = self.order {
            input["order"] = json!(order);
        }
        input
    }

    /// A question from `{"op":…,"in":…}`.
    ///
    /// # Errors
    /// The field that cannot be read.
    pub fn parse(text: &Object) -> Result<Question, InvalidField> {
        let rows = [("complex.glue", Row::Several), ("complex.refine", Row::Refinements)];
        let row = value::field(text, "op", |op| value::word(op, "an operation of complexes", &rows))?;
        value::field(text, "in", |input| {
            let input = value::object(input)?;
            let order = match row {
                Row::Refinements => Some(value::field(input, "order", value::vertex_number)?),
                _ => None,
            };
            Ok(Question { row, scheme: complex::scheme(input)?, order })
        })
    }
}

/// The suite: `cases` questions of each row, but all gluings of the tetrahedron.
pub fn questions(seed: u64, cases: usize) -> Vec<Question> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let rows = Row::CASES.into_iter().chain(Row::groups());
    let count = |row: Row| if row == Row::Tetrahedra { bases::TETRAHEDRA } else { cases };
    rows.flat_map(|row| (0..count(row)).map(move |i| (row, i))).map(|(row, i)| question(&mut random, row, i)).collect()
}

fn question(random: &mut ChaCha8Rng, row: Row, number: usize) -> Question {
    let (scheme, order) = match row {
        Row::Manifolds => (bases::manifold(random, number), None),
        Row::Invalid(reason) => (without_a_manifold(random, reason), None),
        Row::Tetrahedra => (bases::tetrahedron(number), None),
        Row::Cubes => (bases::cube(random.random_range(0..bases::CUBES)), None),
        Row::LensSpaces => (bases::lens(random), None),
        Row::Prisms => (bases::prism(random), None),
        Row::Several => {
            let count = random.random_range(2..6);
            (bases::several(random, count), None)
        }
        Row::Disconnected => {
            let parts = (random.random_range(6..9), random.random_range(0..9));
            (bases::beside(bases::manifold(random, parts.0), bases::manifold(random, parts.1)), None)
        }
        Row::Refinements => (bases::manifold(random, number), Some(random.random_range(1..=MOST))),
        Row::NoRefinements => {
            let Row::Invalid(reason) = Row::CASES[1 + number % 8] else { unreachable!("the others are reasons") };
            (without_a_manifold(random, reason), Some(random.random_range(1..=2)))
        }
    };
    // The first manifolds stand as they are printed.
    let is_printed = row == Row::Manifolds && number < 6;
    let scheme = if is_printed || !scheme.defects().is_empty() { scheme } else { disguised(random, &scheme) };
    Question { row, scheme, order }
}

/// A scheme that is no manifold, at least for that reason.
fn without_a_manifold(random: &mut ChaCha8Rng, reason: Reason) -> GluingScheme {
    loop {
        let kind = random.random_range(0..20);
        let base = bases::manifold(random, kind);
        let mut scheme = disguised(random, &base);
        plant(random, &mut scheme, reason);
        if reasons(&scheme).contains(&reason) {
            return scheme;
        }
    }
}
