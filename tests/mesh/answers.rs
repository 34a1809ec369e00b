//! `mesh.check` and `mesh.plane` through the protocol: what is answered, what is refused, and how.

use isoracle::answer::answer;
use serde_json::{Value, json};

fn ask(op: &str, input: &Value) -> Value {
    let line = json!({"id": 1, "op": op, "in": input}).to_string();
    serde_json::from_str(&answer(line.as_bytes())).expect("an answer is JSON")
}

/// The answer to a question about a mesh.
fn checked(input: &Value) -> Value {
    let answer = ask("mesh.check", input);
    assert!(answer["out"].is_object(), "{answer}");
    answer["out"].clone()
}

#[track_caller]
fn is_refused(op: &str, input: &Value, kind: &str, message: &str) {
    let answer = ask(op, input);
    assert_eq!((&answer["error"]["kind"], &answer["error"]["message"]), (&json!(kind), &json!(message)));
}

/// A tetrahedron with these fields beside, or instead.
fn tetrahedron(fields: Value) -> Value {
    let mut all = json!({
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, "1/3"]],
        "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    });
    for (name, value) in fields.as_object().expect("fields") {
        all[name] = value.clone();
    }
    all
}

#[test]
fn a_sound_mesh_has_numbers_and_no_defects() {
    let counts = json!({"V": 4, "E": 6, "F": 4, "H": 0, "C": 1, "chi": 2, "G": 0, "closed": true, "orientable": true,
        "manifold": true, "volume": "1/18"});
    assert_eq!(checked(&tetrahedron(json!({}))), json!({"defects": {}, "counts": counts}));
}

#[test]
fn elements_are_written_as_their_category_has_them() {
    let out = checked(&tetrahedron(json!({
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], ["1/2", 0, 0], [0, 0, 0], [9, 9, 9]],
        "faces": [[0, 2, 1], [1, 0, 2], [3, 3, 4], [0, 1, 5]],
        "holes": {"0": [[1, 2]]},
        "edges": [[1, 0], [0, 1], [0, 6]],
        "edge_faces": [[0, 1, 3], [3, 1, 0, 0], [7]],
    })));
    let defects = json!({
        "face_lt3_vertices": [0],
        "repeated_vertex_in_loop": [2],
        "degenerate_edge_same_index": [2],
        "zero_length_edge": [[0, 5]],
        "boundary_edge": [[0, 5], [1, 5]],
        "edge_used_gt2": [[0, 1], [1, 2]],
        "edge_odd_use": [[0, 1]],
        "edge_twice_in_same_face": [[1, 2], [3, 4]],
        "inconsistent_winding_edge": [[0, 2]],
        "isolated_vertex": [6],
        "duplicate_vertex_position": [[0, 5]],
        "duplicate_face": [[0, 1]],
        "zero_area_face": [2, 3],
        "t_junction": [[4, [0, 1]], [4, [1, 5]]],
        "vertex_lt2_edges": [3, 4],
        "edge_unreferenced": [2],
        "edge_missing_from_list": [[0, 2], [0, 5], [1, 2], [1, 5], [3, 4]],
        "duplicate_edge_record": [[0, 1]],
        "edge_face_not_reciprocal": [2],
    });
    assert_eq!(out["defects"], defects);
    assert_eq!((&out["counts"]["G"], &out["counts"]["volume"]), (&Value::Null, &Value::Null));
    assert_eq!((&out["counts"]["H"], &out["counts"]["C"]), (&json!(1), &json!(2)));
}

#[test]
fn whatever_number_a_loop_names_it_is_in_range_or_not() {
    for beyond in [json!(4), json!(-1), json!(4294967295_u64), json!(4294967296_u64), json!("1e30")] {
        let out = checked(&tetrahedron(json!({"faces": [[0, 2, 1], [0, 1, beyond.clone()], []]})));
        assert_eq!(out, json!({"defects": {"index_out_of_range": [1]}, "counts": null}));
        let out = checked(&tetrahedron(json!({"holes": {"3": [[0, 1, 2], [beyond]]}})));
        assert_eq!(out, json!({"defects": {"index_out_of_range": [3]}, "counts": null}));
    }
}

#[test]
fn nothing_at_all_is_a_mesh() {
    let out = checked(&json!({"vertices": [], "faces": []}));
    assert_eq!(out["defects"], json!({"zero_volume": [true]}));
    let out = checked(&json!({"vertices": [], "faces": [[], []], "holes": {"1": [[]]}, "edges": [], "edge_faces": []}));
    let expected = json!({"face_lt3_vertices": [0, 1], "duplicate_face": [[0, 1]], "zero_volume": [true]});
    assert_eq!(out["defects"], expected);
}

#[test]
fn an_ill_posed_question_names_its_field() {
    let refused =
        |fields: Value, message: &str| is_refused("mesh.check", &tetrahedron(fields), "invalid-input", message);
    refused(json!({"vertices": null}), "vertices: expected an array, found null");
    refused(json!({"vertices": [[0, 0]]}), "vertices[0]: expected 3 items, found 2");
    refused(json!({"vertices": [[0, 0, "x"]]}), "vertices[0][2]: `x` is not a number");
    refused(json!({"faces": [[0, 1, 2], 3]}), "faces[1]: expected an array, found a number");
    refused(json!({"faces": [[0, 1, "1/2"]]}), "faces[0][2]: expected an integer, found 1/2");
    refused(json!({"holes": {"4": []}}), "holes.4: there is no such face; there are 4");
    refused(json!({"holes": {"0": [7]}}), "holes.0[0]: expected an array, found a number");
    refused(json!({"holes": {"0": [[0, {}]]}}), "holes.0[0][1]: expected a number, found an object");
    for key in ["-1", "00", "1.0", "", "x", "99999999999999999999"] {
        refused(json!({"holes": {key: []}}), &format!("holes: expected face numbers as keys, found {key:?}"));
    }
    refused(json!({"holes": []}), "holes: expected an object, found an array");
    refused(json!({"edges": [[0, 1], [0]]}), "edges[1]: expected 2 items, found 1");
    refused(
        json!({"edges": [[0, -1]]}),
        "edges[0][1]: expected the number of a vertex, an integer from 0 on, found -1",
    );
    refused(json!({"edge_faces": [[0]]}), "edges: missing");
    refused(json!({"edges": [[0, 1]], "edge_faces": []}), "edge_faces: expected 1 items, found 0");
    refused(json!({"edges": [[0, 1]], "edge_faces": [0]}), "edge_faces[0]: expected an array, found a number");
    refused(json!({"file": "m.ply"}), "vertices: stands beside `file`; one of the two gives the data");
    is_refused("mesh.check", &json!({"vertices": []}), "invalid-input", "faces: missing");
}

#[test]
fn a_mesh_may_stand_in_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("m.obj");
    std::fs::write(&file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
        .expect("written");
    let out = checked(&json!({"file": file}));
    assert_eq!((&out["defects"], &out["counts"]["volume"]), (&json!({}), &json!("1/12")));
    let answer = ask("mesh.check", &json!({"file": folder.path().join("none.obj")}));
    assert_eq!(answer["error"]["kind"], "invalid-input");
}

#[test]
fn the_plane_of_a_polygon() {
    let plane = |polygon: Value| ask("mesh.plane", &json!({"polygon": polygon}))["out"].clone();
    let square = plane(json!([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]));
    let expected = json!({"normal": ["0", "0", "1"], "offset": "0", "planar": true, "worst_distance_squared": "0"});
    assert_eq!(square, expected);
    // One corner up by h = 1: every vertex is at the same distance, with Σ over the normal's own sense.
    let bent = plane(json!([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]));
    let expected =
        json!({"normal": ["-1/2", "-1/2", "1"], "offset": "-1/4", "planar": false, "worst_distance_squared": "1/24"});
    assert_eq!(bent, expected);
}

#[test]
fn a_polygon_without_area_is_degenerate_and_two_points_are_no_polygon() {
    let message = "polygon: the normal vanishes: no projection of the polygon has an area";
    for polygon in [
        json!([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]),
        json!([[0, 0, 0], [1, 2, 3], [2, 4, 6]]),
        json!([[5, 5, 5], [5, 5, 5], [5, 5, 5]]),
    ] {
        is_refused("mesh.plane", &json!({"polygon": polygon}), "degenerate", message);
    }
    let few = |polygon: Value, message: &str| {
        is_refused("mesh.plane", &json!({"polygon": polygon}), "invalid-input", message)
    };
    few(json!([]), "polygon: a polygon has at least 3 vertices, found 0");
    few(json!([[0, 0, 0], [1, 0, 0]]), "polygon: a polygon has at least 3 vertices, found 2");
    few(json!([[0, 0, 0], [1, 0], [0, 0, 0]]), "polygon[1]: expected 3 items, found 2");
}
