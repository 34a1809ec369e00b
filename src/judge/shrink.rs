//! Making a failing question small.

use super::candidate::Candidate;
use super::suite::{Judgement, Suite};

/// The most questions that shrinking one failure may ask.
const BUDGET: usize = 300;

/// The smallest question found that fails in the same way: by the same first fault, in the same row.
pub fn shrink<S: Suite>(suite: &S, candidate: &mut dyn Candidate, question: &S::Question, fault: &str) -> S::Question {
    let mut smallest = question.clone();
    // A candidate that breaks may take its whole time limit to do so.
    if fault == "broken" {
        return smallest;
    }
    let mut asked = 0;
    let mut still_fails = |smaller: &S::Question| {
        asked += 1;
        asked <= BUDGET
            && matches!(suite.ask(candidate, smaller), Judgement::Wrong { fault: found, .. } if found == fault)
    };
    loop {
        let next = suite.smaller(&smallest).find(&mut still_fails);
        match next {
            Some(smaller) => smallest = smaller,
            None => return smallest,
        }
    }
}
