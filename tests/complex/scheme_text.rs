//! The text of schemes: what is read, what is refused and where, round trips, any bytes at all; and the files of the zoo.
#![cfg(feature = "cli")]

use isoracle::answer::scheme_file::{SchemeFileError, file_name, read, specimen, write};
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use isoracle::complex::zoo::{self, invalid};
use isoracle::format::scheme::{self, MAX_BYTES, PairingRecord, PolyhedronRecord, SchemeRecord, SchemeTextError};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const TORUS: &str = "\u{feff}# T³\r\n\n  polyhedron cube # eight vertices\r\n\tfaces (3 2 1 0)\t( 4 5 6 7 ) (0 1 5 4)(1 2 6 5)\n\
    faces (2 3 7 6) (3 0 4 7)\nglue cube.0 cube.1 shift 3 dir -1\nglue 0.2 cube.4   shift 1 dir -1\nglue 0.3 0.5 shift -3 dir -1";

fn message(text: &str) -> String {
    scheme::read(text.as_bytes()).expect_err("this must be refused").to_string()
}

#[test]
fn both_ways_to_write_a_polyhedron_are_read() {
    let mut torus = three_torus();
    torus.pairings[2].shift = -3;
    // Items of a list have a space before each.
    assert_eq!(read(TORUS.replace(")(", ") (").as_bytes()).expect("a scheme"), torus);
    let lens = "glue a.0 a.1 shift -1 dir -1\npolyhedron a\nedges 0>1\nedges 1>0\nface 1 2\nface -2 -1\n";
    assert_eq!(read(lens.as_bytes()).expect("a scheme"), lens_space(2, 1));
    assert_eq!(read(b"").expect("an empty scheme"), GluingScheme::default());
    assert_eq!(read(b"# nothing\n").expect("an empty scheme"), GluingScheme::default());
    let bare = read(b"polyhedron\npolyhedron b-2\nface\nfaces_").expect_err("no statement");
    assert_eq!(bare.to_string(), "line 4, column 6: expected a space or the end of the line, found \"_\"");
    let empty = read(b"polyhedron\npolyhedron b-2\nface\nface 1\npolyhedron\nfaces () (7)\n").expect("a scheme");
    assert_eq!(empty.polyhedra[0], Polyhedron::default());
    assert_eq!(empty.polyhedra[1].faces, [vec![], vec![SignedEdge(1)]]);
    assert_eq!(empty.polyhedra[2], Polyhedron { edges: vec![[7, 7]], faces: vec![vec![], vec![SignedEdge(1)]] });
}

#[test]
fn json_is_read_as_the_protocol_has_it() {
    let json = r#" {"polyhedra":[{"edges":[[0,1],[1,0]],"faces":[[1,2],[-2,-1]]}],"pairings":[{"a":[0,0],"b":[0,1],"shift":-1,"dir":-1}]}"#;
    assert_eq!(read(json.as_bytes()).expect("a scheme"), lens_space(2, 1));
    assert!(matches!(read(b"{\"polyhedra\":"), Err(SchemeFileError::Json(_))));
    let missing = read(b"{\"polyhedra\":[]}").expect_err("a field is missing");
    assert!(matches!(missing, SchemeFileError::Field(_)) && missing.to_string().contains("pairings"), "{missing}");
    let wrong = read(br#"{"polyhedra":[{"edges":[[0,-1]],"faces":[]}],"pairings":[]}"#).expect_err("no vertex");
    assert!(wrong.to_string().contains("edges"), "{wrong}");
}

#[test]
fn what_is_refused_is_named_with_its_place() {
    let at = |line: usize, column: usize, expected: &str, found: &str| {
        format!("line {line}, column {column}: expected {expected}, found {found}")
    };
    let statement = "`polyhedron`, `edges`, `face`, `faces` or `glue`";
    let end = "the end of the line";
    assert_eq!(message("\n cube"), at(2, 2, statement, "\"cube\""));
    assert_eq!(message("polyhedron 7"), at(1, 12, "a name: a letter, then letters, digits, `_` and `-`", "\"7\""));
    assert_eq!(message("polyhedron a b"), at(1, 14, "a space or the end of the line", "\"b\""));
    assert_eq!(message("polyhedron a\nedges 0>1 1-2"), at(2, 12, "`>` and the edge's head", "\"-2\""));
    assert_eq!(message("polyhedron\nedges 0>x"), at(2, 9, "a vertex, a number from 0 on", "\"x\""));
    assert_eq!(message("polyhedron\nedges 0>"), at(2, 9, "a vertex, a number from 0 on", end));
    assert_eq!(message("polyhedron\nedges -1>0"), at(2, 7, "a vertex, a number from 0 on", "\"-1>0\""));
    assert_eq!(message("polyhedron\nedges 4294967296>0"), at(2, 7, "a vertex, a number from 0 on", "\"4294967296>0\""));
    let side = "a side, the number of an edge with the sign of its direction";
    assert_eq!(message("polyhedron\nface 1 2 é # ü"), at(2, 10, side, "\"é\""));
    assert_eq!(message("polyhedron\nface 1 2147483648"), at(2, 8, side, "\"2147483648\""));
    assert_eq!(message("polyhedron\nface 1-2"), at(2, 7, "a space or the end of the line", "\"-2\""));
    assert_eq!(message("polyhedron\nfaces 0 1 2"), at(2, 7, "a face, as `(0 1 2)`", "\"0\""));
    assert_eq!(message("polyhedron\nfaces (0 1"), at(2, 11, "a vertex or `)`", end));
    assert_eq!(message("polyhedron\nfaces (0 1,2)"), at(2, 11, "a vertex or `)`", "\",2)\""));
    assert_eq!(message("glue 0.0"), at(1, 9, "a face, as `0.5` or `cube.5`", end));
    assert_eq!(message("glue 0.0 1 shift 0 dir 1"), at(1, 11, "a face, as `0.5` or `cube.5`", "\"shift\""));
    assert_eq!(message("glue 0.0 1.1"), at(1, 13, "`shift` and an integer", end));
    assert_eq!(message("glue 0.0 1.1 shift x"), at(1, 20, "an integer", "\"x\""));
    assert_eq!(message("glue 0.0 1.1 shift 1"), at(1, 21, "`dir` and 1 or -1", end));
    assert_eq!(message("glue 0.0 1.1 shift 1 dir +"), at(1, 26, "1 or -1", "\"+\""));
    assert_eq!(message("glue 0.0 1.1 shift 1 dir 1 2"), at(1, 28, "a space or the end of the line", "\"2\""));
    let began = "`polyhedron`, before its edges and faces";
    assert_eq!(message("\tface 1"), at(1, 2, began, "\"face\""));
    assert_eq!(message("faces (0 1 2)"), at(1, 1, began, "\"faces\""));
    assert_eq!(
        message("polyhedron\nfaces (0 1 2)\n edges 0>1"),
        at(3, 2, "`faces`, as this polyhedron began", "\"edges\"")
    );
    assert_eq!(
        message("polyhedron\nface 1\nfaces (0 1)"),
        at(3, 1, "`edges` or `face`, as this polyhedron began", "\"faces\"")
    );
    assert_eq!(message("polyhedron p\npolyhedron p"), at(2, 12, "a name that no polyhedron before has", "\"p\""));
    let unknown = "the name of a polyhedron";
    assert_eq!(message("polyhedron e\nglue e.0\tglue.1 shift 1 dir 1"), at(2, 10, unknown, "\"glue.1\""));
    assert_eq!(scheme::read(b"polyhedron\n# \xff"), Err(SchemeTextError::NotUtf8(2)));
    assert_eq!(scheme::read(&vec![b' '; MAX_BYTES + 1]), Err(SchemeTextError::TooLong(MAX_BYTES + 1)));
}

#[test]
fn schemes_are_written_as_people_would() {
    let text = "polyhedron\nedges 0>1 1>0\nface 1 2\nface -2 -1\nglue 0.0 0.1 shift -1 dir -1\n";
    assert_eq!(write(&lens_space(2, 1)), text);
    let torus = write(&three_torus());
    assert!(
        torus.starts_with("polyhedron\nfaces (3 2 1 0) (4 5 6 7) (0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)\nglue 0.0")
    );
}

fn record() -> impl Strategy<Value = SchemeRecord> {
    let small = || prop_oneof![4 => 0..6_u32, 1 => any::<u32>()];
    let side = prop_oneof![4 => -6..6_i32, 1 => any::<i32>()];
    let cycles = prop::collection::vec(prop::collection::vec(small(), 0..5), 1..5).prop_map(PolyhedronRecord::Cycles);
    let edges = prop::collection::vec((small(), small()).prop_map(|(a, b)| [a, b]), 0..5);
    let faces = prop::collection::vec(prop::collection::vec(side, 0..5), 0..5);
    let sides = (edges, faces).prop_map(|(edges, faces)| PolyhedronRecord::Sides { edges, faces });
    let number = || prop_oneof![4 => 0..6_usize, 1 => any::<usize>()];
    let integer = || prop_oneof![4 => -2..3_i64, 1 => any::<i64>()];
    let pairing = (number(), number(), number(), number(), integer(), integer());
    let pairing = pairing.prop_map(|(p, f, q, g, shift, dir)| PairingRecord { a: [p, f], b: [q, g], shift, dir });
    let polyhedra = prop::collection::vec(prop_oneof![cycles, sides], 0..4);
    (polyhedra, prop::collection::vec(pairing, 0..5))
        .prop_map(|(polyhedra, pairings)| SchemeRecord { polyhedra, pairings })
}

proptest! {
    #[test]
    fn what_is_written_is_read_again(record in record()) {
        prop_assert_eq!(scheme::read(scheme::write(&record).as_bytes()), Ok(record));
    }

    #[test]
    fn schemes_survive_the_text(record in record()) {
        let scheme = GluingScheme::from(record);
        prop_assert_eq!(read(write(&scheme).as_bytes()).expect("it was written"), scheme.clone());
        // Whatever stands there, it is judged without a panic.
        let small = scheme.polyhedra.iter().all(|p| p.edges.iter().flatten().all(|v| *v < 100));
        prop_assert!(!small || scheme.defects().len() < 1_000);
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        drop(read(&bytes));
    }

    #[test]
    fn broken_texts_are_read_or_refused(
        record in record(), at in any::<prop::sample::Index>(), cut in 0..4_usize, more in "[ -~\n\t#é]{0,6}"
    ) {
        let text = scheme::write(&record);
        let chars: Vec<char> = text.chars().collect();
        let at = at.index(chars.len() + 1);
        let end = (at + cut).min(chars.len());
        let broken: String = chars[..at].iter().copied().chain(more.chars()).chain(chars[end..].iter().copied()).collect();
        match read(broken.as_bytes()) {
            Ok(scheme) => drop(scheme.defects()),
            Err(SchemeFileError::Text(SchemeTextError::Syntax { line, column, found, .. })) => {
                let lines: Vec<&str> = broken.lines().collect();
                let rest: String = lines[line - 1].chars().skip(column - 1).collect();
                let word = rest.split('#').next().and_then(|rest| rest.split_whitespace().next()).map(|word| format!("{:?}", word.chars().take(40).collect::<String>()));
                prop_assert_eq!(word.unwrap_or("the end of the line".to_owned()), found);
            }
            Err(SchemeFileError::Text(_)) => prop_assert!(false, "it is short, and UTF-8"),
            Err(SchemeFileError::Json(_) | SchemeFileError::Field(_)) => {}
        }
    }
}

/// Where the files of the zoo stand, what they are called and what is in them.
fn files() -> Vec<(PathBuf, String, GluingScheme)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("zoo");
    let manifolds = zoo::names().into_iter().map(|name| {
        let found = zoo::get(name).expect("a specimen");
        (folder.join(file_name(name)), specimen(&found), found.scheme)
    });
    let broken = invalid::all().into_iter().map(|broken| {
        let text = format!("# {}: {}\n# {}\n{}", broken.name, broken.about, broken.defect, write(&broken.scheme));
        (folder.join("invalid").join(file_name(broken.name)), text, broken.scheme)
    });
    manifolds.chain(broken).collect()
}

#[test]
fn the_folder_zoo_holds_the_zoo() {
    let files = files();
    let rewrite = std::env::var("ISORACLE_WRITE_ZOO").is_ok_and(|value| value == "1");
    for (path, text, scheme) in &files {
        if rewrite {
            fs::write(path, text).expect("the folder is there");
        }
        let there = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(String::from_utf8_lossy(&there), *text, "{}", path.display());
        assert_eq!(read(&there).expect("a scheme"), *scheme, "{}", path.display());
    }
    let known: BTreeSet<&PathBuf> = files.iter().map(|(path, _, _)| path).collect();
    assert_eq!(known.len(), files.len(), "no two specimens have one file");
    for folder in ["zoo", "zoo/invalid"] {
        for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).expect("a folder") {
            let path = entry.expect("an entry").path();
            assert!(path.is_dir() || known.contains(&path), "{} is none of the zoo", path.display());
        }
    }
}

#[test]
fn pairings_keep_their_faces() {
    let pairing =
        Pairing { a: FaceId { polyhedron: 3, face: 1 }, b: FaceId { polyhedron: 0, face: 2 }, shift: 5, dir: -1 };
    let scheme = GluingScheme { polyhedra: Vec::new(), pairings: vec![pairing] };
    assert_eq!(write(&scheme), "glue 3.1 0.2 shift 5 dir -1\n");
}
