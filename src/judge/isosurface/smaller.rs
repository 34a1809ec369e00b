//! Smaller questions: fewer samples, then smaller integers.

use super::questions::{Question, Row};
use crate::isosurface::cases::Case;
use crate::isosurface::cell::Tie;
use crate::isosurface::volume::Volume;
use crate::number::Rational;

/// How large a question is: samples first, then the size of its values.
pub fn size(question: &Question) -> (usize, Rational) {
    let volume = &question.volume;
    let total = (0..volume.len()).fold(Rational::new(), |sum, i| sum + volume.sample(i).abs());
    (volume.len(), total)
}

/// Smaller questions of the same row, for single cells of the same case.
pub fn smaller(question: &Question) -> impl Iterator<Item = Question> {
    layers_off(question).into_iter().chain(values_toward_zero(question)).filter(is_of_its_row)
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
