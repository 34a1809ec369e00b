//! The operation `complex.refine`.

use super::complex::scheme;
use super::message::{Out, Refusal};
use super::value::{self, InvalidField, Object, Problem};
use crate::complex::check::{Facts, VertexSets, fast as check};
use crate::complex::closed_complex::ClosedComplex;
use crate::complex::manifold::Manifold3;
use crate::complex::refine::counts::printed_counts;
use crate::complex::refine::fast;
use serde_json::{Value, json};

/// The most tetrahedra that a refinement of a question may have: 2²¹.
pub const MAX_REFINED: u64 = 1 << 21;

/// `complex.refine` in `{polyhedra, pairings, order}`: the numbers of the glued complex refined to that order, counted, and those that
/// 000 prints.
///
/// Ill-posed: a field of another type, an order that is no integer from 1 on, polyhedra or pairings with a defect by themselves.
/// Degenerate: an edge glued to itself, tail to head, or a vertex around which no sphere stands. Limit: [`MAX_REFINED`] tetrahedra.
pub fn refine(input: &Object) -> Result<Out, Refusal> {
    let scheme = scheme(input)?;
    let order = value::field(input, "order", order)?;
    let by_itself = scheme.defects();
    if let Some(defect) = by_itself.into_iter().next() {
        return Err(Refusal::InvalidScheme(Box::new(defect)));
    }
    let first = |defects: Vec<_>| Refusal::NoManifold(Box::new(defects.into_iter().next().expect("there is a defect")));
    let manifold = Manifold3::of(ClosedComplex::new(scheme).map_err(first)?).map_err(first)?;
    let pairs = manifold.facet_edge_pairs() as u64;
    let tetrahedra = order.and_then(|k| k.checked_pow(3)).and_then(|n| n.checked_mul(pairs));
    let (Some(order), Some(0..=MAX_REFINED)) = (order, tetrahedra) else {
        return Err(Refusal::TooManyTetrahedra { pairs, limit: MAX_REFINED });
    };
    let refined = fast::refine(&manifold.tetrahedra(), order as u32).expect("order and size were checked");
    let Facts { counts: [v, e, f, t], vertex_sets, .. } = check::check(refined.triangulation());
    let VertexSets { degenerate_tetrahedra, duplicate_tetrahedra, simplicial } = vertex_sets;
    let [printed_e, printed_f, printed_t] = printed_counts(pairs, order);
    Ok(Out::new(&json!({
        "V": v, "E": e, "F": f, "T": t,
        "simplicial": simplicial,
        "degenerate_tetrahedra": degenerate_tetrahedra,
        "duplicate_tetrahedra": duplicate_tetrahedra,
        "as_printed": {"T": printed_t, "F": printed_f, "E": printed_e},
    })))
}

/// An integer from 1 on; `None` where it is beyond 64 bits, and so beyond any limit.
fn order(value: &Value) -> Result<Option<u64>, InvalidField> {
    match value::number(value)? {
        n if n.is_integer() && n >= 1 => Ok(n.numer().to_u64()),
        n => Err(InvalidField::here(Problem::Order(n))),
    }
}
