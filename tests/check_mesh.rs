//! `isoracle check mesh` as a stranger runs it.
#![cfg(feature = "cli")]

use assert_cmd::Command;
use isoracle::format::{MeshRecord, Precision, write_mesh};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

fn isoracle(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let binary = assert_cmd::cargo::cargo_bin!("isoracle");
    let output = Command::new(binary).current_dir(folder).args(arguments).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn check(folder: &TempDir, arguments: &[&str]) -> (Option<i32>, String, String) {
    isoracle(folder.path(), &[&["check", "mesh"], arguments].concat())
}

fn json_of(folder: &TempDir, arguments: &[&str]) -> Value {
    let (_, out, err) = check(folder, &[&["--json"], arguments].concat());
    serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}{err}"))
}

/// The unit cube of triangles.
fn cube() -> MeshRecord {
    let quadrilaterals = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let faces = quadrilaterals.iter().flat_map(|&[a, b, c, d]| [vec![a, b, c], vec![a, c, d]]);
    let corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    MeshRecord {
        vertices: corners.iter().map(|corner| corner.map(f64::from)).collect(),
        faces: faces.collect(),
        precision: Precision::Binary64,
        soup: false,
    }
}

/// A folder with the mesh in a file of that name.
fn folder(name: &str, mesh: &MeshRecord) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_mesh(&folder.path().join(name), mesh).expect("it can be written");
    folder
}

#[test]
fn a_cube_is_sound_in_every_format() {
    for name in ["cube.ply", "cube.obj", "cube.off", "cube.stl"] {
        let folder = folder(name, &cube());
        let (code, out, err) = check(&folder, &["--audit", "1", name]);
        assert_eq!(code, Some(0), "{out}{err}");
        assert!(out.starts_with(&format!("{name}: sound, a closed oriented surface\n")), "{out}");
        for line in ["V = 8, E = 18, F = 12, H = 0, C = 1", "= 2, genus 0", "volume   1\n", "area     6 exactly"] {
            assert!(out.contains(line), "{line}: {out}");
        }
        let note = "note: an STL shares no vertices; its 36 corners were welded to 8 at equal positions";
        assert_eq!(out.contains(note), name == "cube.stl", "{out}");
        let json = json_of(&folder, &[name]);
        let counts = json!({"V": 8, "E": 18, "F": 12, "H": 0, "C": 1, "chi": 2, "G": 0, "closed": true, "orientable": true,
            "manifold": true, "volume": "1"});
        assert_eq!((&json["counts"], &json["area"], &json["defects"]), (&counts, &json!("6"), &json!({})));
        assert_eq!(json["welded_from"], if name == "cube.stl" { json!(36) } else { Value::Null });
        assert_eq!(json["components"], json!([{"V": 8, "E": 18, "F": 12, "boundary_loops": 0, "genus": 0}]));
    }
}

#[test]
fn json_says_what_the_protocol_says() {
    let mut mesh = cube();
    mesh.faces.swap_remove(3);
    mesh.faces[4].swap(0, 1);
    mesh.faces.push(mesh.faces[0].clone());
    mesh.faces.push(vec![0, 6, 0, 7]);
    mesh.vertices.extend([[0.5, 0.5, 0.0], [0.0, 0.0, -0.0], [9.0, 0.1, 0.3]]);
    mesh.faces.push(vec![8, 1, 9, 10]);
    let folder = folder("m.obj", &mesh);
    let question = json!({"id": 1, "op": "mesh.check", "in": {"file": "m.obj"}});
    let binary = assert_cmd::cargo::cargo_bin!("isoracle");
    let mut answer = Command::new(binary);
    answer.current_dir(folder.path()).arg("answer").write_stdin(format!("{question}\n"));
    let answer: Value = serde_json::from_slice(&answer.output().expect("it runs").stdout).expect("an answer");
    let ours = json_of(&folder, &["--audit", "1", "m.obj"]);
    assert!(answer["out"]["defects"].as_object().is_some_and(|defects| defects.len() > 8), "{answer}");
    assert_eq!((&ours["defects"], &ours["counts"]), (&answer["out"]["defects"], &answer["out"]["counts"]));
    for (category, elements) in ours["defects"].as_object().expect("an object") {
        assert_eq!(ours["totals"][category], json!(elements.as_array().map_or(1, Vec::len)), "{category}");
    }
    let area = &ours["area"];
    let bound = |name: &str| area[name].as_str().and_then(|text| text.parse::<f64>().ok()).expect("a decimal");
    assert!(bound("lo") <= bound("hi") && bound("hi") - bound("lo") < 1e-12 && area["lo"] != area["hi"], "{area}");
}

#[test]
fn an_open_an_inside_out_and_a_broken_mesh_are_told_apart() {
    type Spoil = fn(&mut MeshRecord);
    let ways: [(&str, Option<i32>, Spoil, &str, &str); 6] = [
        ("open", Some(1), |m| drop(m.faces.pop()), "open, a surface with a boundary", "3 boundary_edge"),
        ("inside", Some(1), |m| m.faces.iter_mut().for_each(|f| f.reverse()), "inside out", "volume   -1\n"),
        ("turned", Some(1), |m| m.faces[3].reverse(), "defective", "edge 4–6, 4–7, 6–7"),
        ("missing", Some(1), |m| m.faces[3][0] = 8, "unusable", "face 3"),
        ("lone", Some(0), |m| m.vertices.push([0.5; 3]), "sound, a closed oriented surface, with warnings", "vertex 8"),
        ("two", Some(1), |m| m.faces.push(m.faces[3].clone()), "defective", "faces 3 = 12"),
    ];
    for (name, code, spoil, verdict, named) in ways {
        let mut mesh = cube();
        spoil(&mut mesh);
        let folder = folder("m.ply", &mesh);
        let (found, out, err) = check(&folder, &["m.ply", "--audit", "1"]);
        assert_eq!(found, code, "{name}: {out}{err}");
        assert!(out.contains(verdict) && out.contains(named), "{name}: {out}");
    }
}

#[test]
fn show_limits_what_is_named_and_never_what_is_counted() {
    let mut mesh = cube();
    mesh.faces.truncate(2);
    let folder = folder("m.ply", &mesh);
    let (_, out, _) = check(&folder, &["--show", "1", "m.ply"]);
    assert!(out.contains("4 boundary_edge") && out.contains("edge 0–1, …") && !out.contains("0–3"), "{out}");
    let (_, out, _) = check(&folder, &["--show", "0", "m.ply"]);
    assert!(out.contains("4 boundary_edge") && !out.contains("edge 0"), "{out}");
    let json = json_of(&folder, &["--show", "2", "m.ply"]);
    assert_eq!(
        (&json["defects"]["boundary_edge"], &json["totals"]["boundary_edge"]),
        (&json!([[0, 1], [0, 3]]), &json!(4))
    );
}

#[test]
fn what_is_no_mesh_ends_with_2_and_says_why() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let ply = |vertex: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n{vertex}\n3 0 0 0\n"
        )
    };
    let files: [(&str, String, &str); 9] = [
        ("nan.ply", ply("0 nan 0"), "vertex 0: y is NaN"),
        ("infinite.ply", ply("0 0 -inf"), "vertex 0: z is -inf"),
        ("large.obj", "v 0 0 0\nv 1e999 0 0\nf 1 2 1\n".to_owned(), "vertex 1: x is inf"),
        ("empty.obj", String::new(), "there is no face in it"),
        ("cloud.obj", "v 0 0 0\n".to_owned(), "there is no face in it"),
        ("empty.ply", String::new(), "not a file of the format PLY"),
        ("empty.stl", String::new(), "not a file of the format STL"),
        ("empty.off", String::new(), "not a file of the format OFF"),
        ("m.vtk", String::new(), "unknown extension"),
    ];
    for (name, text, problem) in files {
        fs::write(folder.path().join(name), text).expect("it can be written");
        let (code, out, err) = check(&folder, &[name]);
        assert!(code == Some(2) && out.is_empty(), "{name}: {out}{err}");
        let err = err.replace("\n  │ ", " ");
        assert!(err.contains(name) && err.contains(problem), "{name}: {err}");
    }
    assert_eq!(check(&folder, &["none.ply"]).0, Some(2));
    let (code, out, _) = check(&folder, &["--help"]);
    assert!(code == Some(0) && out.contains("Example:") && out.contains("Exit codes: 0 the mesh is sound"), "{out}");
}
