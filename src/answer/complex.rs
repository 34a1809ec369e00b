//! The operation `complex.glue`, and gluing schemes as questions have them.

use super::message::{Out, Refusal};
use super::value::{self, InvalidField, Object};
use crate::complex::closed_complex::ClosedComplex;
use crate::complex::manifold::Manifold3;
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SchemeDefect, SignedEdge};
use serde_json::{Value, json};

/// The scheme of `{polyhedra:[{edges:[[tail,head],…], faces:[[±edge,…],…]}], pairings:[{a:[p,f],b:[p,f],shift,dir}]}`.
///
/// # Errors
/// The field that cannot be read. What can be read is not checked further here.
pub fn scheme(input: &Object) -> Result<GluingScheme, InvalidField> {
    let ends = |edge: &Value| value::exactly(edge, value::vertex_number);
    let side = |side: &Value| value::int32(side).map(SignedEdge);
    let polyhedron = |p: &Value| {
        let p = value::object(p)?;
        Ok(Polyhedron {
            edges: value::field(p, "edges", |list| value::items(list, ends))?,
            faces: value::field(p, "faces", |list| value::items(list, |face| value::items(face, side)))?,
        })
    };
    let face = |id: &Value| value::exactly(id, value::index).map(|[polyhedron, face]| FaceId { polyhedron, face });
    let pairing = |p: &Value| {
        let p = value::object(p)?;
        let integer = |name| value::field(p, name, value::int32).map(i64::from);
        Ok(Pairing {
            a: value::field(p, "a", face)?,
            b: value::field(p, "b", face)?,
            shift: integer("shift")?,
            dir: integer("dir")?,
        })
    };
    Ok(GluingScheme {
        polyhedra: value::field(input, "polyhedra", |list| value::items(list, polyhedron))?,
        pairings: value::field(input, "pairings", |list| value::items(list, pairing))?,
    })
}

/// `complex.glue` in `{polyhedra, pairings}`: whether the scheme is a closed 3-manifold, and which numbers it has, or why not.
///
/// `message` and `defects`, one for each thing that is wrong, are additions. Where a vertex link is no sphere the numbers of the
/// complex are there too, for its cells are cells.
///
/// Ill-posed: a field of another type.
pub fn glue(input: &Object) -> Result<Out, Refusal> {
    Ok(Out::new(&report(scheme(input)?)))
}

/// What `complex.glue` answers about a scheme.
pub fn report(scheme: GluingScheme) -> Object {
    let complex = match ClosedComplex::new(scheme) {
        Ok(complex) => complex,
        Err(defects) => return invalid(&defects),
    };
    let mut out = numbers(&complex);
    match Manifold3::of(complex) {
        Ok(_) => {}
        Err(defects) => out.extend(invalid(&defects)),
    }
    out
}

fn invalid(defects: &[SchemeDefect]) -> Object {
    let first = defects.first().expect("there is a defect");
    let defect = |d: &SchemeDefect| json!({"reason": d.reason().name(), "message": d.to_string()});
    let fields = json!({
        "valid": false,
        "reason": first.reason().name(),
        "message": first.to_string(),
        "defects": defects.iter().map(defect).collect::<Vec<_>>(),
    });
    value::object(&fields).expect("it is one").clone()
}

fn numbers(complex: &ClosedComplex) -> Object {
    let cells = |names: [&str; 4], counts: [usize; 4]| -> Object {
        names.into_iter().map(str::to_owned).zip(counts.map(Value::from)).collect()
    };
    let homology = complex.chain_complex().homology();
    // A torsion coefficient can be beyond any machine integer, and is then a number all the same.
    let torsion = |n: &crate::number::Integer| serde_json::from_str::<Value>(&n.to_string()).expect("digits");
    let sorted = |mut sizes: Vec<usize>| {
        sizes.sort_unstable();
        sizes
    };
    let fields = json!({
        "valid": true,
        "reason": null,
        "cells": cells(["V", "E", "F", "P"], complex.counts()),
        "chi": complex.euler_characteristic(),
        "facet_edge_pairs": complex.facet_edge_pairs(),
        "edge_ring_sizes": sorted(complex.edge_ring_sizes()),
        "face_degrees": sorted(complex.face_degrees()),
        "components": complex.component_count(),
        "orientable": complex.is_orientable(),
        "homology": {"h1": {
            "rank": homology.betti[1],
            "torsion": homology.torsion[1].iter().map(torsion).collect::<Vec<_>>(),
        }},
        "tetrahedra": cells(["V", "E", "F", "T"], complex.tetrahedra().skeleton().counts),
        "barycentric": cells(["V", "E", "F", "T"], complex.barycentric().skeleton().counts),
    });
    value::object(&fields).expect("it is one").clone()
}
