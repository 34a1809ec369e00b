//! A candidate's answer beside the true one. What it leaves out is not judged, and named.

use crate::answer::value;
use crate::judge::fault::{Comparison, Fault};
use crate::number::Integer;
use serde_json::Value;

/// How two values of a field are compared.
#[derive(Clone, Copy)]
enum As {
    /// Equal, as numbers where they are numbers.
    Value,
    /// Lists that are equal but for the order.
    Sizes,
    /// Lists of the orders of cyclic groups whose sums are the same group.
    Torsion,
}

/// A field's path, the name of its fault, and how it is compared.
type Field = (&'static str, &'static str, As);

/// Fields of `complex.glue` that are numbers of the complex.
const GLUED: [Field; 20] = [
    ("chi", "wrong-counts", As::Value),
    ("cells.V", "wrong-counts", As::Value),
    ("cells.E", "wrong-counts", As::Value),
    ("cells.F", "wrong-counts", As::Value),
    ("cells.P", "wrong-counts", As::Value),
    ("facet_edge_pairs", "wrong-pairs", As::Value),
    ("edge_ring_sizes", "wrong-pairs", As::Sizes),
    ("face_degrees", "wrong-pairs", As::Sizes),
    ("components", "wrong-components", As::Value),
    ("orientable", "wrong-orientability", As::Value),
    ("homology.h1.rank", "wrong-homology", As::Value),
    ("homology.h1.torsion", "wrong-homology", As::Torsion),
    ("tetrahedra.V", "wrong-tetrahedra", As::Value),
    ("tetrahedra.E", "wrong-tetrahedra", As::Value),
    ("tetrahedra.F", "wrong-tetrahedra", As::Value),
    ("tetrahedra.T", "wrong-tetrahedra", As::Value),
    ("barycentric.V", "wrong-barycentric", As::Value),
    ("barycentric.E", "wrong-barycentric", As::Value),
    ("barycentric.F", "wrong-barycentric", As::Value),
    ("barycentric.T", "wrong-barycentric", As::Value),
];

/// The fields of `complex.refine`.
const REFINED: [Field; 10] = [
    ("V", "wrong-counts", As::Value),
    ("E", "wrong-counts", As::Value),
    ("F", "wrong-counts", As::Value),
    ("T", "wrong-counts", As::Value),
    ("simplicial", "wrong-simpliciality", As::Value),
    ("degenerate_tetrahedra", "wrong-degenerates", As::Value),
    ("duplicate_tetrahedra", "wrong-duplicates", As::Value),
    ("as_printed.T", "wrong-printed", As::Value),
    ("as_printed.F", "wrong-printed", As::Value),
    ("as_printed.E", "wrong-printed", As::Value),
];

/// The faults of an answer, the weightiest first, and the names of the fields that it leaves out.
///
/// Lists are compared sorted; torsion as a group, so that 2, 6 and 2, 2, 3 are one. Any reason that holds will do. Where a scheme is
/// no manifold because of the surfaces around its vertices, its numbers need not be there, and are judged if they are.
#[doc(alias = "CX-98")]
pub fn compare(operation: &str, truth: &Value, found: &Value) -> Comparison {
    let mut comparison = Comparing { faults: Vec::new(), left_out: Vec::new(), said: 0 };
    match operation {
        "complex.glue" => comparison.glued(truth, found),
        "complex.refine" => comparison.numbers(&REFINED, truth, found, true),
        other => unreachable!("no operation {other} of complexes"),
    }
    if comparison.said == 0 {
        comparison.faults =
            vec![Fault::new("says-nothing", formula("answer"), "answer", &truth.to_string(), &found.to_string())];
        comparison.left_out.clear();
    }
    Comparison { faults: comparison.faults, left_out: comparison.left_out, measured: Vec::new() }
}

struct Comparing {
    faults: Vec<Fault>,
    left_out: Vec<String>,
    said: usize,
}

impl Comparing {
    fn glued(&mut self, truth: &Value, found: &Value) {
        self.numbers(&[("valid", "wrong-validity", As::Value)], truth, found, true);
        let is_valid = truth["valid"] == true;
        let claims_reason = found.get("reason").filter(|reason| !reason.is_null());
        if is_valid || claims_reason.is_some() {
            self.reason(truth, claims_reason);
        } else {
            self.left_out.push("reason".to_owned());
        }
        // Before it is glued, a scheme has no numbers.
        if truth.get("cells").is_some() {
            self.numbers(&GLUED, truth, found, is_valid);
        }
    }

    fn reason(&mut self, truth: &Value, claimed: Option<&Value>) {
        let holds: Vec<&str> = reasons(truth);
        let Some(claimed) = claimed else { return };
        self.said += 1;
        if !claimed.as_str().is_some_and(|claimed| holds.contains(&claimed)) {
            let expected = if holds.is_empty() { "null".to_owned() } else { holds.join(" or ") };
            self.faults.push(Fault::new("wrong-reason", formula("reason"), "reason", &expected, &claimed.to_string()));
        }
    }

    /// Compares fields; those that are not there are named if they should be.
    fn numbers(&mut self, fields: &[Field], truth: &Value, found: &Value, is_asked: bool) {
        for (path, fault, kind) in fields {
            let pointer = format!("/{}", path.replace('.', "/"));
            let expected = truth.pointer(&pointer).expect("the truth leaves nothing out");
            let Some(given) = found.pointer(&pointer).filter(|given| !given.is_null()) else {
                if is_asked {
                    self.left_out.push((*path).to_owned());
                }
                continue;
            };
            self.said += 1;
            let is_right = match kind {
                As::Value => same(expected, given),
                As::Sizes => sizes(expected).is_some_and(|list| sizes(given) == Some(list)),
                As::Torsion => torsion(expected).is_some_and(|group| torsion(given) == Some(group)),
            };
            if !is_right {
                self.faults.push(Fault::new(fault, formula(path), path, &expected.to_string(), &given.to_string()));
            }
        }
    }
}

/// The reasons for which a scheme is no manifold: those of its defects. The middle of a reversed edge is a vertex of the barycentric
/// subdivision with a projective plane around it, so that it is a `vertex-link` too.
pub fn reasons(truth: &Value) -> Vec<&str> {
    let defects = truth["defects"].as_array().map_or(&[][..], Vec::as_slice);
    let mut reasons: Vec<&str> = defects.iter().filter_map(|defect| defect["reason"].as_str()).collect();
    if reasons.contains(&"edge-reversed") {
        reasons.push("vertex-link");
    }
    reasons.sort_unstable();
    reasons.dedup();
    reasons
}

/// Equal as numbers where both are numbers, else equal.
fn same(truth: &Value, found: &Value) -> bool {
    match (value::number(truth), value::number(found)) {
        (Ok(x), Ok(y)) => x == y,
        (_, _) => truth == found,
    }
}

/// The whole numbers of a list. `None` iff it is none.
fn integers(list: &Value) -> Option<Vec<Integer>> {
    let integer = |n: &Value| value::number(n).ok().filter(|n| n.is_integer()).map(|n| n.numer().clone());
    list.as_array()?.iter().map(integer).collect()
}

fn sizes(list: &Value) -> Option<Vec<Integer>> {
    let mut sizes = integers(list)?;
    sizes.sort_unstable();
    Some(sizes)
}

/// The divisors d₁ | d₂ | …, none of them 1, of ⊕ ℤ/n over the numbers n > 0 of a list: ℤ/a ⊕ ℤ/b = ℤ/gcd ⊕ ℤ/lcm.
/// No number has to be factored, and two groups are the same iff their divisors are.
fn torsion(list: &Value) -> Option<Vec<Integer>> {
    let mut orders = integers(list)?;
    if orders.iter().any(|n| *n <= 0) {
        return None;
    }
    for i in 0..orders.len() {
        for j in i + 1..orders.len() {
            let gcd = Integer::from(orders[i].gcd_ref(&orders[j]));
            let lcm = Integer::from(orders[i].lcm_ref(&orders[j]));
            (orders[i], orders[j]) = (gcd, lcm);
        }
    }
    orders.retain(|n| *n != 1);
    Some(orders)
}

/// The spec entry of a field's truth.
pub fn formula(field: &str) -> &'static str {
    match field.split('.').next().expect("split has a first part") {
        "valid" => "CX-5",
        "reason" => "CX-6",
        "chi" | "cells" => "CX-70",
        "facet_edge_pairs" | "edge_ring_sizes" | "face_degrees" => "CX-16",
        "components" | "homology" => "CX-66",
        "orientable" => "CX-71",
        "tetrahedra" => "CX-47",
        "barycentric" => "CX-45",
        "V" | "E" | "F" | "T" => "CX-57",
        "simplicial" => "CX-61",
        "degenerate_tetrahedra" | "duplicate_tetrahedra" => "CX-64",
        "as_printed" => "CX-58",
        _ => "CX-98",
    }
}
