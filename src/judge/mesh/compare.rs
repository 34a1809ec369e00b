//! A candidate's answer beside the true one. What it leaves out is not judged, and named.

use crate::answer::value;
use crate::judge::fault::{Comparison, Fault};
use crate::judge::isosurface::place::Tolerance;
use crate::linear::Vector;
use crate::number::Rational;
use serde_json::{Map, Value};
use std::collections::BTreeSet;

/// What an answer says of one thing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Said {
    Rightly,
    Wrongly,
    Nothing,
}

/// The faults of an answer, the weightiest first, and the names of the fields that it leaves out.
pub fn compare(operation: &str, truth: &Value, found: &Value, tolerance: Tolerance) -> Comparison {
    let mut comparison = Comparing { faults: Vec::new(), left_out: Vec::new(), said: 0, tolerance };
    match operation {
        "mesh.check" => comparison.check(truth, found),
        "mesh.plane" => comparison.plane(truth, found),
        "mesh.angle_deficits" => comparison.deficits(truth, found),
        other => unreachable!("no operation {other} of meshes"),
    }
    if comparison.said == 0 {
        comparison.faults =
            vec![Fault::new("says-nothing", whole(operation), "answer", &truth.to_string(), &found.to_string())];
        comparison.left_out.clear();
    }
    Comparison { faults: comparison.faults, left_out: comparison.left_out, measured: Vec::new() }
}

struct Comparing {
    faults: Vec<Fault>,
    left_out: Vec<String>,
    said: usize,
    tolerance: Tolerance,
}

impl Comparing {
    /// Takes note of what was said of a field.
    fn note(&mut self, said: Said, name: &'static str, formula: &'static str, field: &str, pair: [&Value; 2]) {
        match said {
            Said::Nothing => return self.left_out.push(field.to_owned()),
            Said::Wrongly => {
                self.faults.push(Fault::new(name, formula, field, &pair[0].to_string(), &pair[1].to_string()));
            }
            Said::Rightly => {}
        }
        self.said += 1;
    }

    fn check(&mut self, truth: &Value, found: &Value) {
        let none = Value::Null;
        match found.get("defects").and_then(Value::as_object) {
            None => self.left_out.push("defects".to_owned()),
            Some(defects) => {
                self.said += 1;
                let empty = Map::new();
                let expected = truth["defects"].as_object().unwrap_or(&empty);
                let categories: BTreeSet<&String> = expected.keys().chain(defects.keys()).collect();
                for category in categories {
                    let pair = [expected.get(category).unwrap_or(&none), defects.get(category).unwrap_or(&none)];
                    if !same_set(pair[0], pair[1]) {
                        self.note(Said::Wrongly, "wrong-defects", formula(category), category, pair);
                    }
                }
            }
        }
        let Some(counts) = truth["counts"].as_object() else {
            // With an index out of range there are none.
            let given = found.get("counts").filter(|counts| !counts.is_null());
            if let Some(given) = given {
                self.note(Said::Wrongly, "wrong-counts", formula("index_out_of_range"), "counts", [&none, given]);
            }
            return;
        };
        for (name, expected) in counts {
            let given = found.get("counts").and_then(|counts| counts.get(name));
            let said = match given {
                None => Said::Nothing,
                Some(given) if name == "volume" => self.real(expected, given, None),
                Some(given) => told(same(expected, given)),
            };
            let fault = match name.as_str() {
                "volume" => "wrong-volume",
                "closed" | "orientable" | "manifold" => "wrong-property",
                _ => "wrong-counts",
            };
            self.note(said, fault, formula(name), &format!("counts.{name}"), [expected, given.unwrap_or(&none)]);
        }
    }

    fn plane(&mut self, truth: &Value, found: &Value) {
        let none = Value::Null;
        let pair = |name: &str| [truth.get(name).unwrap_or(&none).clone(), found.get(name).unwrap_or(&none).clone()];
        let [expected, given] = pair("planar");
        let said = if given.is_null() { Said::Nothing } else { told(expected == given) };
        self.note(said, "wrong-planarity", formula("nonplanar_face"), "planar", [&expected, &given]);
        let [expected, given] = pair("normal");
        let normals = [vector(&expected), vector(&given)];
        let is_exact = !given.as_array().is_some_and(|list| list.iter().any(|x| is_rounded(x) || x.is_object()));
        let (said, scale) = match normals {
            [Some(n), Some(m)] => self.parallel(&n, &m, is_exact),
            [_, None] if given.is_null() => (Said::Nothing, None),
            [_, _] => (Said::Wrongly, None),
        };
        self.note(said, "wrong-normal", formula("normal"), "normal (up to a positive factor)", [&expected, &given]);
        // The offset is that of the answered normal.
        let [expected, given] = pair("offset");
        let said = match (scale, given.is_null()) {
            (_, true) => Said::Nothing,
            (Some(scale), false) => self.real(&expected, &given, Some((&scale, is_exact))),
            (None, false) => return,
        };
        self.note(said, "wrong-offset", formula("offset"), "offset", [&expected, &given]);
        let [expected, given] = pair("worst_distance_squared");
        let said = if given.is_null() { Said::Nothing } else { self.real(&expected, &given, None) };
        self.note(said, "wrong-distance", formula("distance"), "worst_distance_squared", [&expected, &given]);
    }

    /// Whether two vectors have one direction, and how long the second is in units of the first. Only where it is rounded may
    /// it be off by the tolerance.
    fn parallel(&self, n: &Vector<Rational, 3>, m: &Vector<Rational, 3>, is_exact: bool) -> (Said, Option<Rational>) {
        let (dot, square) = (n.dot(m), n.norm_squared());
        if dot <= 0 || square == 0 {
            return (Said::Wrongly, None);
        }
        // sin² of the angle between them.
        let sine = n.cross(m).norm_squared() / (square.clone() * m.norm_squared());
        let most = if is_exact { Rational::new() } else { self.relative().square() };
        (told(sine <= most), Some(dot / square))
    }

    fn deficits(&mut self, truth: &Value, found: &Value) {
        let none = Value::Null;
        for (name, fault) in [("chi", "wrong-counts"), ("total_over_pi", "wrong-total")] {
            let given = found.get(name);
            let said = given.map_or(Said::Nothing, |given| told(same(&truth[name], given)));
            self.note(said, fault, formula(name), name, [&truth[name], given.unwrap_or(&none)]);
        }
        let lists = [truth.get("deficits"), found.get("deficits")].map(|list| list.and_then(Value::as_array));
        match lists {
            [Some(expected), Some(given)] if expected.len() == given.len() => {
                for (v, (expected, given)) in expected.iter().zip(given).enumerate() {
                    let said = self.real(expected, given, None);
                    self.note(said, "wrong-deficit", formula("deficits"), &format!("deficits[{v}]"), [expected, given]);
                }
            }
            [_, None] => self.left_out.push("deficits".to_owned()),
            [_, Some(_)] => {
                let pair = [&truth["deficits"], found.get("deficits").unwrap_or(&none)];
                self.note(Said::Wrongly, "wrong-deficit", formula("deficits"), "deficits", pair);
            }
        }
    }

    /// The relative error that a number with a rounding may have.
    fn relative(&self) -> Rational {
        let ulps = Rational::from_f64(self.tolerance.0).unwrap_or_default();
        ulps >> 24
    }

    /// Compares a real number with the true one (times a factor, exact or not). Exact answers and enclosures are taken at their word;
    /// a binary64 may be off by the tolerance, relative to the truth.
    fn real(&self, truth: &Value, found: &Value, factor: Option<(&Rational, bool)>) -> Said {
        let (Some(truth), Some(given)) = (bounds(truth), bounds(found)) else {
            return told(truth == found);
        };
        let one = Rational::from(1);
        let (factor, is_exact) = factor.unwrap_or((&one, true));
        let [low, high] = truth.map(|x| x * factor);
        // Of a rounded factor only a rounded product comes.
        let slack = if is_rounded(found) || !is_exact {
            (low.clone().abs().max(high.clone().abs())) * self.relative()
        } else {
            Rational::new()
        };
        told(given[1] >= low - &slack && given[0] <= high + slack)
    }
}

fn told(rightly: bool) -> Said {
    if rightly { Said::Rightly } else { Said::Wrongly }
}

/// Whether a value is a JSON number with a fraction or an exponent: a binary64.
fn is_rounded(value: &Value) -> bool {
    value.is_number() && !value.is_i64() && !value.is_u64()
}

/// The least and the greatest number that a value may stand for.
fn bounds(value: &Value) -> Option<[Rational; 2]> {
    match value.as_object() {
        Some(enclosure) => {
            let end = |name: &str| enclosure.get(name).and_then(|end| value::number(end).ok());
            Some([end("lo")?, end("hi")?])
        }
        None => value::number(value).ok().map(|x| [x.clone(), x]),
    }
}

fn vector(value: &Value) -> Option<Vector<Rational, 3>> {
    let list = value.as_array().filter(|list| list.len() == 3)?;
    let middle = |x: &Value| bounds(x).map(|[low, high]| (low + high) / 2);
    let numbers: Vec<Rational> = list.iter().map(middle).collect::<Option<_>>()?;
    Some(Vector(numbers.try_into().ok()?))
}

/// Equal as numbers where both are numbers, else equal.
fn same(truth: &Value, found: &Value) -> bool {
    match (value::number(truth), value::number(found)) {
        (Ok(x), Ok(y)) => x == y,
        (_, _) => truth == found,
    }
}

/// Equal as sets of elements; a category without elements is absent.
fn same_set(truth: &Value, found: &Value) -> bool {
    let set = |value: &Value| match value {
        Value::Null => Some(BTreeSet::new()),
        Value::Array(list) => Some(list.iter().map(Value::to_string).collect::<BTreeSet<String>>()),
        _ => None,
    };
    set(found).is_some_and(|found| Some(found) == set(truth))
}

/// The spec entry of a category, a count or a field.
fn formula(name: &str) -> &'static str {
    match name {
        "face_lt3_vertices" => "ME-48",
        "zero_length_edge" | "degenerate_edge_same_index" => "ME-58",
        "boundary_edge" | "closed" => "ME-54",
        "edge_used_gt2" => "ME-52",
        "edge_odd_use" => "ME-47",
        "edge_twice_in_same_face" => "ME-56",
        "inconsistent_winding_edge" => "ME-38",
        "isolated_vertex" => "ME-57",
        "duplicate_vertex_position" => "ME-9",
        "nonplanar_face" => "ME-55",
        "zero_area_face" => "ME-64",
        "zero_signed_area_face" | "normal" => "ME-67",
        "vertex_lt2_edges" => "ME-53",
        "non_orientable" | "orientable" => "ME-126",
        "edge_unreferenced" => "ME-51",
        "edge_missing_from_list" => "ME-18",
        "duplicate_edge_record" => "ME-23",
        "edge_face_not_reciprocal" => "ME-59",
        "V" | "E" | "F" | "H" | "C" | "G" | "chi" => "ME-90",
        "offset" => "ME-72",
        "distance" => "ME-70",
        "deficits" | "total_over_pi" => "ME-118",
        "volume" => "ME-148",
        // What the printed criteria leave out.
        _ => "ME-74",
    }
}

/// The spec entry of an operation as a whole.
pub fn whole(operation: &str) -> &'static str {
    match operation {
        "mesh.plane" => "ME-67",
        "mesh.angle_deficits" => "ME-118",
        _ => "ME-74",
    }
}
