//! `isoracle check`, `judge` and `demo` as a stranger runs them.
#![cfg(feature = "cli")]

use assert_cmd::Command;
use isoracle::format::{MeshRecord, Samples, VolumeRecord, read_mesh, write_mesh, write_volume};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn isoracle(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let binary = assert_cmd::cargo::cargo_bin!("isoracle");
    let output = Command::new(binary).current_dir(folder).args(arguments).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn own() -> String {
    assert_cmd::cargo::cargo_bin!("isoracle").display().to_string()
}

/// A folder with a volume of integers from −9 to 9 and its right mesh.
fn folder() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let samples = (0..216_i32).map(|i| (i * i * 7 + i * 13) % 19 - 9).map(|v| if v == 0 { 5 } else { v }).collect();
    let record = VolumeRecord { shape: [6, 6, 6], samples: Samples::I32(samples) };
    write_volume(&folder.path().join("v.nrrd"), &record).expect("the volume can be written");
    let made = isoracle(folder.path(), &["isosurface", "--volume", "v.nrrd", "--isovalue", "13/97", "--out", "m.ply"]);
    assert_eq!(made.0, Some(0), "{}", made.2);
    let path = folder.path().join("m.ply");
    (folder, path)
}

fn check(folder: &TempDir, mesh: &str) -> (Option<i32>, String, String) {
    isoracle(folder.path(), &["check", "isosurface", "--volume", "v.nrrd", "--isovalue", "13/97", "--mesh", mesh])
}

#[test]
fn our_own_mesh_is_right_in_every_format() {
    let (folder, path) = folder();
    let mesh = read_mesh(&path).expect("we wrote it");
    for name in ["m.ply", "m.obj", "m.stl"] {
        write_mesh(&folder.path().join(name), &mesh).expect("it can be written");
        let (code, out, err) = check(&folder, name);
        assert_eq!(code, Some(0), "{name}: {out}{err}");
        assert!(out.contains("right: the mesh is the isosurface"), "{out}");
    }
}

#[test]
fn a_broken_mesh_is_wrong_and_the_cell_is_named() {
    let (folder, path) = folder();
    let mesh = read_mesh(&path).expect("we wrote it");
    type Break = fn(&mut MeshRecord);
    let ways: [(&str, Break, &str); 5] = [
        ("a triangle less", |m| drop(m.faces.pop()), "cell ["),
        ("a triangle turned", |m| m.faces[9].swap(0, 1), "inconsistent_winding_edge"),
        ("a triangle twice", |m| m.faces.push(m.faces[3].clone()), "duplicate_face"),
        ("a vertex moved", |m| m.vertices[5] = m.vertices[5].map(|x| x + 0.25), "vertex"),
        ("all turned", |m| m.faces.iter_mut().for_each(|f| f.swap(0, 1)), "reversed"),
    ];
    for (what, spoil, named) in ways {
        let mut broken = mesh.clone();
        spoil(&mut broken);
        write_mesh(&folder.path().join("b.ply"), &broken).expect("it can be written");
        let (code, out, _) = check(&folder, "b.ply");
        assert_eq!(code, Some(1), "{what}: {out}");
        assert!(out.contains("wrong:") && out.contains(named), "{what}: {out}");
    }
}

#[test]
fn files_that_cannot_be_used_end_with_2_and_name_the_flag() {
    let (folder, _) = folder();
    let (code, _, err) = check(&folder, "missing.ply");
    assert!(code == Some(2) && err.contains("--mesh"), "{err}");
    let arguments = ["check", "isosurface", "--volume", "missing.nrrd", "--isovalue", "0", "--mesh", "m.ply"];
    let (code, _, err) = isoracle(folder.path(), &arguments);
    assert!(code == Some(2) && err.contains("--volume"), "{err}");
}

#[test]
fn the_judge_ends_with_0_1_2_or_3() {
    let (folder, _) = folder();
    let own = own();
    let judge = |more: &[&str]| isoracle(folder.path(), &[&["judge", "--cases", "5", "--report", "r"], more].concat());
    let (code, out, err) = judge(&["--", &own, "answer"]);
    assert_eq!(code, Some(0), "{out}{err}");
    assert!(out.contains("13.5.2"));
    let (code, out, _) = judge(&["--", &own, "candidate", "wrong-interior-rule"]);
    assert_eq!(code, Some(1), "{out}");
    assert!(out.contains("wrong-components"));
    for name in ["report.json", "report.html", "report.xml"] {
        assert!(folder.path().join("r").join(name).is_file(), "{name}");
    }
    assert_eq!(judge(&[]).0, Some(2), "no candidate");
    assert_eq!(judge(&["--", "/no/such/program"]).0, Some(3));
    assert_eq!(judge(&["--limit", "1", "--", "cat"]).0, Some(3), "an echo speaks nonsense");
}

#[test]
fn a_question_of_a_report_can_be_asked_again() {
    let (folder, _) = folder();
    let own = own();
    let question = r#"{"volume":{"shape":[2,2,2],"values":[-3,1,1,1,1,1,1,-4]},"isovalue":0}"#;
    let ask = |name: &str| isoracle(folder.path(), &["judge", "--question", question, "--", &own, "candidate", name]);
    let (code, out, _) = ask("right");
    assert_eq!((code, out.as_str()), (Some(0), "right\n"));
    let (code, out, _) = ask("wrong-interior-rule");
    assert!(code == Some(1) && out.contains("a tube on loop #1 and #2"), "{out}");
    let (code, _, err) = isoracle(folder.path(), &["judge", "--question", "{", "--", &own, "answer"]);
    assert!(code == Some(2) && err.contains("--question"), "{err}");
}

#[test]
fn the_demo_says_three_lines_and_writes_a_page_that_needs_nothing_else() {
    let (folder, _) = folder();
    let (code, out, err) = isoracle(folder.path(), &["demo", "--out", "demo"]);
    assert_eq!(code, Some(0), "{err}");
    assert_eq!(out.lines().count(), 3, "{out}");
    assert!(out.contains("checked right"), "{out}");
    let page = std::fs::read_to_string(folder.path().join("demo/report.html")).expect("the page is there");
    assert!(page.contains("13.5.2") && page.contains("A real surface"));
    for outside in ["<script", "src=\"http", "href=\"http", "url(http"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(!page.contains(&own()), "no path of this machine in the report");
}
