//! Smaller questions of a row: fewer faces, fewer vertices, simpler coordinates.

use super::plant::drop_unused;
use super::questions::{Question, Row, listed};
use super::truth;
use crate::number::Rational;
use serde_json::Value;
use std::collections::BTreeSet;

/// How large a question is: loops' vertices first, then vertices, then the size of the coordinates' numbers.
pub fn size(question: &Question) -> (usize, usize, u64) {
    let mesh = &question.mesh;
    let sides = mesh.faces.iter().map(|face| face.vertices().count()).sum();
    let records = question.listed.as_ref().map_or(0, |listed| listed.edges().len());
    let bits = |x: &Rational| u64::from(x.numer().significant_bits()) + u64::from(x.denom().significant_bits());
    (sides, mesh.vertices.len() + records, mesh.vertices.iter().flat_map(|v| &v.0).map(bits).sum())
}

/// Smaller questions of the same row, that have no other categories of defects than the question: so a defect is not shown
/// by a heap of others.
pub fn smaller(question: &Question) -> impl Iterator<Item = Question> {
    let with_fewer = match question.row {
        Row::Planes => corners_off(question),
        _ => [faces_off(question), unlisted(question), corners_off(question)].concat(),
    };
    let (known, most, row) = (categories(question).unwrap_or_default(), size(question), question.row);
    with_fewer.into_iter().chain(simpler_coordinates(question)).filter(move |smaller| {
        let keeps = |found: BTreeSet<String>| match row {
            Row::Defect(category) => found.contains(category) && found.is_subset(&known),
            Row::Sound | Row::Random | Row::Planes | Row::Angles => found.is_subset(&known),
        };
        size(smaller) < most && categories(smaller).is_some_and(keeps)
    })
}

/// The categories of its defects, none where the answer has none; `None` where it has no answer.
fn categories(question: &Question) -> Option<BTreeSet<String>> {
    let out = truth(question).ok()?;
    Some(out.get("defects").and_then(Value::as_object).map(|d| d.keys().cloned().collect()).unwrap_or_default())
}

/// Without half of the faces, then without one.
fn faces_off(question: &Question) -> Vec<Question> {
    let count = question.mesh.faces.len();
    let without = |range: std::ops::Range<usize>| {
        let mut smaller = question.clone();
        smaller.mesh.faces.drain(range);
        let keeps_unused = question.row == Row::Defect("isolated_vertex");
        if !keeps_unused && smaller.listed.is_none() {
            drop_unused(&mut smaller.mesh);
        }
        if smaller.listed.is_some() {
            // The list follows the faces; what was wrong with it is wrong no more.
            smaller.listed = Some(listed(&smaller.mesh));
        }
        smaller
    };
    let halves = if count > 3 { vec![without(0..count / 2), without(count / 2..count)] } else { Vec::new() };
    halves.into_iter().chain((0..count).map(|f| without(f..f + 1))).collect()
}

fn unlisted(question: &Question) -> Vec<Question> {
    question.listed.iter().map(|_| Question { listed: None, ..question.clone() }).collect()
}

/// With one corner less in a loop of more than three.
fn corners_off(question: &Question) -> Vec<Question> {
    let mut all = Vec::new();
    for (f, face) in question.mesh.faces.iter().enumerate() {
        for i in (0..face.outer.len()).filter(|_| face.outer.len() > 3) {
            let mut smaller = question.clone();
            let corner = smaller.mesh.faces[f].outer.remove(i);
            if question.row == Row::Planes {
                smaller.mesh.vertices.remove(corner as usize);
                smaller.mesh.faces[f].outer = (0..smaller.mesh.vertices.len() as u32).collect();
            }
            all.push(smaller);
        }
    }
    all
}

/// With one vertex moved to the nearest integers, or half as far from the origin.
fn simpler_coordinates(question: &Question) -> Vec<Question> {
    let mut all = Vec::new();
    for v in 0..question.mesh.vertices.len() {
        let simplifications: [fn(&Rational) -> Rational; 2] = [|x| x.clone().round(), |x| (x.clone() / 2u32).trunc()];
        for simplify in simplifications {
            let mut smaller = question.clone();
            smaller.mesh.vertices[v] = smaller.mesh.vertices[v].map(simplify);
            all.push(smaller);
        }
    }
    all
}
