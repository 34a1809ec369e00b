//! The questions of the suite `isosurface`: the same seed, the same questions.

use crate::isosurface::cases::Case;
use crate::isosurface::cell::{self, Tie};
use crate::isosurface::cube::Symmetry;
use crate::isosurface::volume::{Level, Volume};
use crate::isosurface::witness::smallest;
use crate::number::Rational;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A question: a small volume and a level of it, and the row of the table it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The row.
    pub row: Row,
    /// The samples.
    pub volume: Volume,
    /// The isovalue.
    pub isovalue: Rational,
}

/// A row of the report's tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Row {
    /// Single cells of a case.
    Cell(Case),
    /// Two cells that share a face.
    Pairs,
    /// Random small grids.
    Grids,
    /// Grids and cells that are nearly degenerate.
    NearDegenerate,
    /// Samples or saddles at the isovalue.
    Ties,
}

impl Row {
    /// The groups beside the single cells.
    pub const GROUPS: [Row; 4] = [Row::Pairs, Row::Grids, Row::NearDegenerate, Row::Ties];

    /// "6.1.2", "pairs", …
    pub const fn name(self) -> &'static str {
        match self {
            Row::Cell(case) => case.name(),
            Row::Pairs => "pairs",
            Row::Grids => "grids",
            Row::NearDegenerate => "near-degenerate",
            Row::Ties => "ties",
        }
    }
}

impl Question {
    /// A question of integers at level 0.
    fn of(row: Row, shape: [usize; 3], values: Vec<i32>) -> Question {
        let volume = Volume::integers(shape, values).expect("the suite's shapes are sound");
        Question { row, volume, isovalue: Rational::new() }
    }

    /// The level that is asked about.
    pub fn level(&self, tie: Tie) -> Level<'_> {
        Level { volume: &self.volume, isovalue: self.isovalue.clone(), tie }
    }

    /// Whether its isovalue is a critical value of a cell.
    pub fn is_tied(&self) -> bool {
        let level = self.level(Tie::Degenerate);
        self.volume.cells().any(|cell| level.decisions(cell).is_err())
    }
}

/// The suite.
///
/// Single cells: for each of the 33 cases the smallest cell and a random one, in all 48 orientations; then
/// `cases` each of pairs, grids, near-degenerate ones and ties.
pub fn questions(seed: u64, cases: usize) -> Vec<Question> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut questions = Vec::new();
    for &case in Case::ALL {
        for base in [smallest(case), varied(&mut random, case)] {
            for symmetry in Symmetry::all() {
                let values = symmetry.carry(&base);
                // A reflection takes case 11 to 14 and 12.2 to 12.3; the row is the cell's own.
                questions.push(Question::of(Row::Cell(case_of(&values)), [2, 2, 2], values.to_vec()));
            }
        }
    }
    questions.extend((0..cases).map(|_| pair(&mut random)));
    questions.extend((0..cases).map(|_| grid(&mut random)));
    questions.extend((0..cases).map(|_| nearly_degenerate(&mut random)));
    questions.extend(known_ties());
    questions.extend((0..cases).map(|_| tied(&mut random)));
    questions
}

fn decide(values: &[i32; 8]) -> Option<Case> {
    let values = values.map(Rational::from);
    cell::decisions(&values, &Rational::new(), Tie::Degenerate).ok().map(|decisions| Case::of(&decisions))
}

fn case_of(values: &[i32; 8]) -> Case {
    decide(values).expect("the cell is not degenerate")
}

/// A random cell of a case: the smallest one, scaled up, noise added, complemented or not.
fn varied(random: &mut ChaCha8Rng, case: Case) -> [i32; 8] {
    loop {
        let scale = random.random_range(2..30);
        let sign = if random.random() { scale } else { -scale };
        let noise = scale / 2 + 1;
        let values = smallest(case).map(|v| sign * v + random.random_range(-noise..=noise));
        if decide(&values) == Some(case) {
            return values;
        }
    }
}

/// A random case's smallest or varied cell in a random orientation.
fn any_cell(random: &mut ChaCha8Rng) -> [i32; 8] {
    // The cases with a choice come oftener: it is there that two cells disagree.
    let case = Case::ALL[random.random_range(0..Case::ALL.len())];
    let base = if random.random() { smallest(case) } else { varied(random, case) };
    Symmetry::all()[random.random_range(0..48)].carry(&base)
}

/// Values of two cells side by side along an axis: the layers of the samples across it.
fn layered(axis: usize, layers: [[i32; 4]; 3]) -> ([usize; 3], Vec<i32>) {
    let mut shape = [2; 3];
    shape[axis] = 3;
    let mut values = vec![0; 12];
    for (layer, four) in layers.into_iter().enumerate() {
        for (i, value) in four.into_iter().enumerate() {
            let mut point = [0; 3];
            point[axis] = layer;
            point[(axis + 1) % 3] = i & 1;
            point[(axis + 2) % 3] = i >> 1;
            values[point[0] + shape[0] * (point[1] + shape[1] * point[2])] = value;
        }
    }
    (shape, values)
}

/// The four corners of a cell on a face across an axis, in the order of [`layered`].
fn layer(values: &[i32; 8], axis: usize, side: usize) -> [i32; 4] {
    std::array::from_fn(|i| values[side << axis | (i & 1) << ((axis + 1) % 3) | (i >> 1) << ((axis + 2) % 3)])
}

/// A cell, and beyond one of its faces its mirror image, or other values.
fn pair(random: &mut ChaCha8Rng) -> Question {
    loop {
        let cell = any_cell(random);
        let axis = random.random_range(0..3);
        let (low, high) = (layer(&cell, axis, 0), layer(&cell, axis, 1));
        let beyond = match random.random_range(0..3) {
            0 => low,
            1 => layer(&any_cell(random), axis, 0),
            _ => std::array::from_fn(|_| nonzero(random, 9)),
        };
        let (shape, values) = layered(axis, [low, high, beyond]);
        let question = Question::of(Row::Pairs, shape, values);
        if !question.is_tied() {
            return question;
        }
    }
}

fn nonzero(random: &mut ChaCha8Rng, most: i32) -> i32 {
    let magnitude = random.random_range(1..=most);
    if random.random() { magnitude } else { -magnitude }
}

fn any_shape(random: &mut ChaCha8Rng, most: usize) -> [usize; 3] {
    [(); 3].map(|()| random.random_range(2..=most))
}

fn grid(random: &mut ChaCha8Rng) -> Question {
    loop {
        let shape = any_shape(random, 5);
        let most = [4, 9, 100, 10_000][random.random_range(0..4)];
        let values = (0..shape.iter().product()).map(|_| nonzero(random, most)).collect();
        let question = Question::of(Row::Grids, shape, values);
        if !question.is_tied() {
            return question;
        }
    }
}

/// Small values scaled up and nudged by one, so that what was a tie of a face, or of a critical point
/// inside, is one no more, by little. All values stay below 2²⁴, the integers that binary32 knows.
fn nearly_degenerate(random: &mut ChaCha8Rng) -> Question {
    loop {
        let shape = if random.random() { [2; 3] } else { any_shape(random, 4) };
        let scale = 1 << random.random_range(4..12);
        let values: Vec<i32> =
            (0..shape.iter().product()).map(|_| nonzero(random, 3) * scale + random.random_range(-1..=1)).collect();
        let unscaled = values.iter().map(|v| (f64::from(*v) / f64::from(scale)).round() as i32).collect();
        let question = Question::of(Row::NearDegenerate, shape, values);
        if Question::of(Row::NearDegenerate, shape, unscaled).is_tied() && !question.is_tied() {
            return question;
        }
    }
}

/// Ties that users of today's libraries report.
fn known_ties() -> Vec<Question> {
    // The middle face of this volume has determinant 0.
    let volume = [[[13, -1], [-1, -7]], [[-1, 1], [7, -7]], [[15, -9], [-3, -1]]];
    let values = (0..2).flat_map(|k| (0..2).flat_map(move |j| (0..3).map(move |i| volume[i][j][k]))).collect();
    vec![Question::of(Row::Ties, [3, 2, 2], values)]
}

fn tied(random: &mut ChaCha8Rng) -> Question {
    loop {
        let shape = any_shape(random, 4);
        let values = match random.random_range(0..3) {
            // Samples at the isovalue.
            0 => (0..shape.iter().product()).map(|_| random.random_range(-1..=1)).collect(),
            // Face saddles at the isovalue, and no sample.
            1 => (0..shape.iter().product()).map(|_| nonzero(random, 1)).collect(),
            _ => (0..shape.iter().product()).map(|_| random.random_range(-3..=3)).collect(),
        };
        let question = Question::of(Row::Ties, shape, values);
        if question.is_tied() {
            return question;
        }
    }
}
