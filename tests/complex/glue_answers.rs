//! `complex.glue` through the protocol: what cannot be read is refused with its field, what can be read gets its reason.

use isoracle::answer::answer;
use isoracle::complex::zoo::invalid;
use serde_json::{Value, json};

fn ask(input: &Value) -> Value {
    let line = json!({"id": 1, "op": "complex.glue", "in": input}).to_string();
    serde_json::from_str(&answer(line.as_bytes())).expect("an answer is JSON")
}

/// A ball of two monogons.
fn lens() -> Value {
    json!({
        "polyhedra": [{"edges": [[0, 0]], "faces": [[1], [-1]]}],
        "pairings": [{"a": [0, 0], "b": [0, 1], "shift": 0, "dir": -1}],
    })
}

#[test]
fn each_field_is_read_or_named() {
    assert_eq!(ask(&lens())["out"]["valid"], true);
    for (pointer, value, message) in [
        ("/polyhedra", json!(1), "polyhedra: expected an array, found a number"),
        ("/polyhedra/0", json!([]), "polyhedra[0]: expected an object, found an array"),
        ("/polyhedra/0/edges", json!(null), "polyhedra[0].edges: expected an array, found null"),
        ("/polyhedra/0/edges/0", json!([0]), "polyhedra[0].edges[0]: expected 2 items, found 1"),
        ("/polyhedra/0/edges/0/1", json!(-1), "polyhedra[0].edges[0][1]: expected the number of a vertex"),
        (
            "/polyhedra/0/faces/1/0",
            json!("1/2"),
            "polyhedra[0].faces[1][0]: expected an integer of at most 32 bits, found 1/2",
        ),
        (
            "/polyhedra/0/faces/1/0",
            json!(4294967296_u64),
            "polyhedra[0].faces[1][0]: expected an integer of at most 32 bits",
        ),
        ("/pairings/0/a", json!([0]), "pairings[0].a: expected 2 items, found 1"),
        ("/pairings/0/b/1", json!(-1), "pairings[0].b[1]: expected an index, an integer from 0 on, found -1"),
        ("/pairings/0/shift", json!(true), "pairings[0].shift: expected a number, found a boolean"),
        ("/pairings/0/dir", json!(0.5), "pairings[0].dir: expected an integer of at most 32 bits, found 1/2"),
    ] {
        let mut input = lens();
        *input.pointer_mut(pointer).expect("it is there") = value;
        let error = &ask(&input)["error"];
        assert_eq!(error["kind"], "invalid-input", "{pointer}: {error}");
        assert!(error["message"].as_str().expect("a text").starts_with(message), "{pointer}: {error}");
    }
    for field in ["polyhedra", "pairings"] {
        let mut input = lens();
        input.as_object_mut().expect("an object").remove(field);
        assert_eq!(ask(&input)["error"]["message"], format!("{field}: missing"));
    }
}

#[test]
fn numbers_may_be_strings_and_any_shift_counts_mod_n() {
    for shift in [json!(0), json!("7"), json!(-12)] {
        let mut input = lens();
        input["pairings"][0]["shift"] = shift;
        assert_eq!(ask(&input)["out"], ask(&lens())["out"]);
    }
    let torus = |shift: i64| {
        json!({
            "polyhedra": [{"edges": [[0, 1], [1, 2], [2, 3], [3, 0]], "faces": [[1, 2, 3, 4], [-4, -3, -2, -1]]}],
            "pairings": [{"a": [0, 0], "b": [0, 1], "shift": shift, "dir": -1}],
        })
    };
    for shift in -8..8 {
        assert_eq!(ask(&torus(shift))["out"], ask(&torus(shift.rem_euclid(4)))["out"], "{shift}");
    }
    assert_ne!(ask(&torus(0))["out"], ask(&torus(1))["out"]);
}

#[test]
fn every_broken_scheme_has_its_reason_and_says_it_in_words() {
    for broken in invalid::all() {
        let polyhedron = |p: &isoracle::complex::scheme::Polyhedron| {
            let faces: Vec<Vec<i32>> = p.faces.iter().map(|face| face.iter().map(|side| side.0).collect()).collect();
            json!({"edges": p.edges, "faces": faces})
        };
        let face = |id: isoracle::complex::scheme::FaceId| json!([id.polyhedron, id.face]);
        let pairing = |p: &isoracle::complex::scheme::Pairing| json!({"a": face(p.a), "b": face(p.b), "shift": p.shift, "dir": p.dir});
        let input = json!({
            "polyhedra": broken.scheme.polyhedra.iter().map(polyhedron).collect::<Vec<_>>(),
            "pairings": broken.scheme.pairings.iter().map(pairing).collect::<Vec<_>>(),
        });
        let out = &ask(&input)["out"];
        assert_eq!(out["valid"], false, "{}", broken.name);
        assert_eq!(out["reason"], broken.defect.reason().name(), "{}", broken.name);
        assert_eq!(out["message"], broken.defect.to_string(), "{}", broken.name);
        assert_eq!(out["defects"][0]["message"], out["message"], "{}", broken.name);
        // Cells are counted iff they are cells.
        assert_eq!(out.get("cells").is_some(), out["reason"] == "vertex-link", "{}", broken.name);
    }
}
