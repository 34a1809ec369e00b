//! The floor plan: which room may name which, and that nothing else does.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Each room with the rooms below it that it may name. Rooms of one level do not name one another, but for the pairs that
/// stand here.
const ARROWS: &[(&str, &[&str])] = &[
    ("number", &[]),
    ("linear", &["number"]),
    ("partition", &[]),
    ("isosurface", &["number", "linear", "partition"]),
    ("mesh", &["number", "linear", "partition"]),
    ("complex", &["number", "linear", "partition", "mesh"]),
    ("curvature", &["number", "linear", "mesh"]),
    ("spline", &["number", "linear", "isosurface", "mesh", "curvature"]),
    ("format", &[]),
    ("picture", &["complex", "format"]),
    ("spec", &[]),
    ("answer", &["number", "linear", "isosurface", "mesh", "complex", "curvature", "spline", "format"]),
    (
        "judge",
        &["number", "linear", "partition", "isosurface", "mesh", "complex", "curvature", "spline", "format", "answer"],
    ),
];

fn source(path: &Path, files: &mut Vec<PathBuf>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).expect("the folder can be read") {
            source(&entry.expect("the entry can be read").path(), files);
        }
    } else if path.extension().is_some_and(|extension| extension == "rs") {
        files.push(path.to_owned());
    }
}

fn files(room: &str) -> Vec<PathBuf> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    for path in [src.join(room), src.join(room).with_extension("rs")].iter().filter(|path| path.exists()) {
        source(path, &mut files);
    }
    files
}

/// The names that follow `crate::` in a text.
fn named(text: &str) -> BTreeSet<String> {
    let of_word = |c: char| c.is_ascii_lowercase() || c == '_';
    text.split("crate::").skip(1).map(|rest| rest.chars().take_while(|c| of_word(*c)).collect()).collect()
}

#[test]
fn arrows_go_down() {
    let rooms: BTreeSet<&str> = ARROWS.iter().map(|(room, _)| *room).collect();
    let mut wrong = Vec::new();
    for (room, below) in ARROWS {
        let files = files(room);
        assert!(!files.is_empty(), "the room {room} has no file");
        for path in files {
            let text = fs::read_to_string(&path).expect("sources are text");
            for name in named(&text).iter().filter(|name| rooms.contains(name.as_str())) {
                if name != room && !below.contains(&name.as_str()) {
                    wrong.push(format!("{} names {name}", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "arrows that do not stand in the floor plan:\n{}", wrong.join("\n"));
}

#[test]
fn every_room_stands_in_the_floor_plan() {
    let lib = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("lib.rs is there");
    let declared: BTreeSet<&str> =
        lib.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    assert_eq!(declared, ARROWS.iter().map(|(room, _)| *room).collect());
}

#[test]
fn no_file_is_past_500_lines_or_named_for_nothing() {
    for (room, _) in ARROWS {
        for path in files(room) {
            let lines = fs::read_to_string(&path).expect("sources are text").lines().count();
            assert!(lines <= 500, "{}: {lines} lines", path.display());
            let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
            assert!(!["util", "utils", "common", "helper", "helpers", "misc"].contains(&name.as_str()), "{name}");
        }
    }
}
