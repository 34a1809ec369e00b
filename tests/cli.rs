//! The command line: what it prints, where, and with which exit code.
#![cfg(feature = "cli")]

use assert_cmd::Command;
use isoracle::format::{MeshRecord, Samples, VolumeRecord, read_mesh, write_volume};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn isoracle(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(assert_cmd::cargo::cargo_bin!("isoracle")).args(arguments).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// A volume of a ball: the squared distance from the middle of a grid of 9³ points.
fn ball(directory: &TempDir) -> PathBuf {
    let square = |i: i32| (i - 4) * (i - 4);
    let samples = (0..729).map(|n| square(n % 9) + square(n / 9 % 9) + square(n / 81)).collect();
    let path = directory.path().join("ball.npy");
    let record = VolumeRecord { shape: [9, 9, 9], samples: Samples::I32(samples) };
    write_volume(&path, &record).expect("the volume can be written");
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a temporary path is UTF-8")
}

fn mesh(volume: &Path, isovalue: &str, out: &Path, more: &[&str]) -> (Option<i32>, String, String) {
    let arguments = ["isosurface", "--volume", text(volume), "--isovalue", isovalue, "--out", text(out)];
    isoracle(&[&arguments[..], more].concat())
}

fn directory() -> TempDir {
    tempfile::tempdir().expect("a temporary directory")
}

#[test]
fn version_and_help_go_to_stdout() {
    let (code, out, err) = isoracle(&["--version"]);
    assert_eq!(
        (code, out.as_str(), err.as_str()),
        (Some(0), concat!("isoracle ", env!("CARGO_PKG_VERSION"), "\n"), "")
    );
    for command in ["answer", "isosurface", "spec"] {
        assert!(isoracle(&["--help"]).1.contains(command));
        let (code, out, err) = isoracle(&[command, "--help"]);
        assert_eq!((code, err.as_str()), (Some(0), ""));
        assert!(out.contains("Examples:"), "{out}");
    }
}

#[test]
fn a_wrong_command_line_ends_with_2() {
    for arguments in [
        &[][..],
        &["nothing"],
        &["answer", "--nothing"],
        &["isosurface"],
        &["isosurface", "--volume", "v.npy", "--isovalue", "x", "--out", "m.ply"],
        &["isosurface", "--volume", "v.npy", "--isovalue", "0", "--out", "m.xyz"],
        &["isosurface", "--volume", "v.npy", "--isovalue", "0", "--out", "m.ply", "--tie", "above"],
        &["spec", "7"],
        &["spec", "XX-1"],
        &["spec", "--json", "--html", "pages"],
    ] {
        let (code, out, err) = isoracle(arguments);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(!err.is_empty());
    }
}

#[test]
fn an_isosurface_is_written_in_every_format() {
    let directory = directory();
    let volume = ball(&directory);
    for name in ["m.ply", "m.obj", "m.stl", "M.PLY"] {
        let out = directory.path().join(name);
        // No sample has this value.
        let (code, stdout, stderr) = mesh(&volume, "21/2", &out, &[]);
        assert_eq!((code, stdout.as_str()), (Some(0), ""), "{stderr}");
        let record = read_mesh(&out).expect("the mesh can be read");
        assert!(stderr.contains(&format!("{} triangles", record.faces.len())), "{stderr}");
        if !record.soup {
            // A sphere: V − E + F = 2, and E = 3F/2.
            assert_eq!(2 * record.vertices.len(), record.faces.len() + 4);
        }
        assert!(volume_of(&record) > 0.0, "the normals point out of the ball, toward greater values");
    }
}

/// Six times the volume that a closed mesh encloses.
fn volume_of(mesh: &MeshRecord) -> f64 {
    let corner = |face: &[u32], i: usize| mesh.vertices[face[i] as usize];
    mesh.faces
        .iter()
        .map(|face| {
            let [a, b, c] = [0, 1, 2].map(|i| corner(face, i));
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        })
        .sum()
}

#[test]
fn a_tie_is_explained_and_can_be_broken() {
    let directory = directory();
    let (volume, out) = (ball(&directory), directory.path().join("m.ply"));
    let (code, _, stderr) = mesh(&volume, "9", &out, &[]);
    assert_eq!(code, Some(2));
    assert!(stderr.contains("equals the isovalue") && stderr.contains("--tie below"), "{stderr}");
    assert!(!out.exists());
    assert_eq!(mesh(&volume, "9", &out, &["--tie", "below"]).0, Some(0));
    assert!(out.exists());
}

#[test]
fn negative_isovalues_are_read() {
    let directory = directory();
    let (volume, out) = (ball(&directory), directory.path().join("m.ply"));
    assert_eq!(mesh(&volume, "-1/2", &out, &[]).0, Some(0));
    assert_eq!(read_mesh(&out).expect("an empty mesh can be read").faces.len(), 0);
}

#[test]
fn files_that_cannot_be_used_are_named() {
    let directory = directory();
    let (missing, out) = (directory.path().join("missing.npy"), directory.path().join("m.ply"));
    let (code, stdout, stderr) = mesh(&missing, "0", &out, &[]);
    assert_eq!((code, stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains("--volume: ") && stderr.contains("missing.npy") && stderr.contains("help"), "{stderr}");
    let nowhere = directory.path().join("no").join("m.ply");
    let (code, _, stderr) = mesh(&ball(&directory), "21/2", &nowhere, &[]);
    assert_eq!(code, Some(2));
    assert!(stderr.contains("--out: "), "{stderr}");
}

#[test]
fn more_is_said_on_demand() {
    let directory = directory();
    let (volume, out) = (ball(&directory), directory.path().join("m.ply"));
    assert!(!mesh(&volume, "21/2", &out, &[]).2.contains("INFO"));
    assert!(mesh(&volume, "21/2", &out, &["-v"]).2.contains("INFO"));
}

#[test]
fn the_specification_is_shown_as_list_entry_and_json() {
    let (code, list, _) = isoracle(&["spec"]);
    assert_eq!(code, Some(0));
    let (code, json, _) = isoracle(&["spec", "--json"]);
    assert_eq!(code, Some(0));
    let entries: Vec<Value> = serde_json::from_str(&json).expect("a JSON list");
    assert_eq!(list.lines().count(), entries.len());
    let fields =
        ["id", "title", "sources", "verdict", "printed", "correct", "counterexample", "code", "tests", "snapshots"];
    for (entry, line) in entries.iter().zip(list.lines()) {
        let id = entry["id"].as_str().expect("an id is a text");
        assert!(line.starts_with(id));
        let keys: Vec<&String> = entry.as_object().expect("an entry is an object").keys().collect();
        assert_eq!(keys, fields);
    }
    let id = entries[0]["id"].as_str().expect("an id is a text");
    let (code, one, _) = isoracle(&["spec", &id.to_lowercase().replace('-', "_")]);
    assert_eq!(code, Some(0));
    assert!(one.starts_with(id) && one.contains("verdict:"));
    let (_, one, _) = isoracle(&["spec", id, "--json"]);
    assert_eq!(serde_json::from_str::<Vec<Value>>(&one).expect("a JSON list"), entries[..1]);
}

#[test]
fn the_specification_is_written_as_pages() {
    let directory = directory();
    let pages = directory.path().join("new").join("pages");
    assert_eq!(isoracle(&["spec", "--html", text(&pages)]).0, Some(0));
    let index = std::fs::read_to_string(pages.join("index.html")).expect("an index");
    let (_, list, _) = isoracle(&["spec"]);
    for line in list.lines() {
        let id = line.split(' ').next().expect("a line begins with an id");
        assert!(index.contains(&format!("href=\"{id}.html\"")));
        let page = std::fs::read_to_string(pages.join(format!("{id}.html"))).expect("a page an entry");
        assert!(page.contains(&format!("<h1>{id} ")));
    }
    let (code, _, stderr) = isoracle(&["spec", "--html", text(&pages.join("index.html"))]);
    assert_eq!(code, Some(2));
    assert!(stderr.contains("--html: "), "{stderr}");
}
