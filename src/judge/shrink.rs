//! Making a failing question small: fewer samples, then smaller integers.

use super::candidate::Candidate;
use super::place::Tolerance;
use super::run::{Judgement, ask, size};
use super::suite::{Question, Row};
use crate::isosurface::cases::Case;
use crate::isosurface::cell::Tie;
use crate::isosurface::volume::Volume;
use crate::number::Rational;

/// The most questions that shrinking one failure may ask.
const BUDGET: usize = 300;

struct Shrinker<'a> {
    candidate: &'a mut dyn Candidate,
    fault: &'a str,
    tolerance: Tolerance,
    asked: usize,
}

/// The smallest question found that fails in the same way: by the same first fault, and, for a single cell,
/// in the same case.
pub fn shrink(candidate: &mut dyn Candidate, question: &Question, fault: &str, tolerance: Tolerance) -> Question {
    // A candidate that breaks may take its whole time limit to do so.
    if fault == "broken" {
        return question.clone();
    }
    let mut shrinker = Shrinker { candidate, fault, tolerance, asked: 0 };
    let mut smallest = question.clone();
    while let Some(smaller) = shrinker.step(&smallest) {
        smallest = smaller;
    }
    smallest
}

impl Shrinker<'_> {
    fn step(&mut self, question: &Question) -> Option<Question> {
        layers_off(question).into_iter().chain(values_toward_zero(question)).find(|smaller| self.still_fails(smaller))
    }

    fn still_fails(&mut self, question: &Question) -> bool {
        if self.asked == BUDGET || !is_of_its_row(question) {
            return false;
        }
        self.asked += 1;
        match ask(self.candidate, question, self.tolerance) {
            Judgement::Wrong { faults, .. } => faults[0].name() == self.fault,
            Judgement::Right(_) | Judgement::Unsupported(_) | Judgement::Broken(_) => false,
        }
    }
}

/// Whether the question still belongs where it came from: not a tie unless it is one of the ties, and a
/// single cell of its case.
fn is_of_its_row(question: &Question) -> bool {
    let level = question.level(Tie::Degenerate);
    let cells: Result<Vec<_>, _> = question.volume.cells().map(|cell| level.decisions(cell)).collect();
    match (question.row, cells) {
        (Row::Ties, cells) => cells.is_err(),
        (Row::Cell(case), Ok(cells)) => Case::of(&cells[0]) == case,
        (Row::Pairs | Row::Grids | Row::NearDegenerate, Ok(_)) => true,
        (_, Err(_)) => false,
    }
}

/// The question without its first or its last layer of samples along each axis that has more than two.
fn layers_off(question: &Question) -> Vec<Question> {
    let shape = question.volume.shape();
    let mut smaller = Vec::new();
    for axis in (0..3).filter(|&axis| shape[axis] > 2) {
        for first in [0, 1] {
            let mut low = [0; 3];
            let mut high = shape.map(|n| n - 1);
            low[axis] += first;
            high[axis] -= 1 - first;
            let volume = question.volume.crop(low, high).expect("each axis keeps two samples");
            smaller.push(Question { volume, ..question.clone() });
        }
    }
    smaller
}

/// The question with one sample nearer to the isovalue, on the same side: 1 away, half as far, 1 nearer.
fn values_toward_zero(question: &Question) -> Vec<Question> {
    let volume = &question.volume;
    let values: Vec<Rational> = (0..volume.len()).map(|i| volume.sample(i)).collect();
    let mut smaller = Vec::new();
    for (i, value) in values.iter().enumerate() {
        let difference = Rational::from(value - &question.isovalue);
        if !difference.is_integer() {
            continue;
        }
        let size = difference.numer().clone().abs();
        let half = Rational::from(size.clone() / 2u32);
        for nearer in [Rational::from(1), half, Rational::from(&size - 1u32)] {
            if nearer >= 1 && nearer < size {
                let mut values = values.clone();
                let signed = if difference > 0 { nearer } else { -nearer };
                values[i] = signed + &question.isovalue;
                let volume = Volume::rationals(volume.shape(), values).expect("the shape is the same");
                smaller.push(Question { volume, ..question.clone() });
            }
        }
    }
    smaller.sort_by_key(size);
    smaller
}
