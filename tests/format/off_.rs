//! OFF: fixtures by hand, refusals with their lines.

use super::*;

const PRISM: &str = "COFF # Geomview\n# a prism\n\n5 3\n0 0 0 255 0 0 255\n1. 0 -0 0 255 0 255\n1 1e0 0\n0 .1 nan\n\
    0.1 1 -inf 1 0 0 1\n4 0 1 2 3 0.5 0.5 0.5\n3 0 1 4 # a triangle\n0\n";

fn read(text: &str) -> Result<MeshRecord, Problem> {
    off::read(text.as_bytes())
}

#[test]
fn polygons_are_kept_and_colours_passed_over() {
    let mesh = read(PRISM).expect("a prism");
    assert_eq!(mesh.faces, [vec![0, 1, 2, 3], vec![0, 1, 4], vec![]]);
    assert_eq!((mesh.vertices[1], mesh.vertices[4][2]), ([1.0, 0.0, 0.0], f64::NEG_INFINITY));
    assert!(mesh.vertices[1][2].is_sign_negative() && mesh.vertices[3][2].is_nan());
    assert_eq!((mesh.precision, mesh.soup), (Precision::Binary64, false));
    for header in ["OFF 5 3 7 #", "5 3 0 #", "STCNOFF\n5 3 0 #", "NOFF\r\n5 3\r\n#"] {
        let same = read(&PRISM.replace("COFF", header).replace("\n5 3\n", "\n"));
        assert_eq!(same.expect(header).faces, mesh.faces, "{header}");
    }
}

#[test]
fn what_is_not_read_is_refused_with_its_line() {
    let with = |old: &str, new: &str| message(read(&PRISM.replace(old, new)));
    assert!(with("COFF", "4OFF").starts_with("header: expected three coordinates a vertex"));
    assert!(with("COFF", "nOFF").starts_with("header: expected three coordinates a vertex"));
    assert!(with("COFF", "OFF BINARY").starts_with("header: expected the ascii kind"));
    assert!(with("COFF", "solid").starts_with("not a file of the format OFF"));
    assert!(message(read("")).starts_with("not a file of the format OFF"));
    assert_eq!(message(read("OFF\n")), "counts of vertices and faces: missing");
    assert!(with("5 3", "-5 3").starts_with("line 4: expected the counts"));
    assert!(with("5 3", "5").starts_with("line 4: expected the counts"));
    assert!(with("5 3", "5 3 1 9").starts_with("line 4: expected the counts"));
    assert!(with("1 1e0 0", "1 1e0").starts_with("line 7: expected three coordinates"));
    assert!(with("1 1e0 0", "1 1e0 x").starts_with("line 7: expected three coordinates"));
    assert!(with("1 1e0 0", "1 1 0 red").starts_with("line 7: expected numbers"));
    assert!(with("3 0 1 4", "3 0 1 -4").starts_with("line 11: expected as many vertex indices"));
    assert!(with("3 0 1 4", "4 0 1 4").starts_with("line 11: expected as many vertex indices"));
    assert!(with("3 0 1 4", "3 0 1 4294967296").starts_with("line 11: expected as many vertex indices"));
    assert!(
        with("3 0 1 4", "3 0 1 4 1 2 3 4 5").starts_with("line 11: expected the vertex indices, then at most four")
    );
    assert!(with("3 0 1 4", "-3 0 1 4").starts_with("line 11: expected the number"));
    assert_eq!(with("5 3\n", "5 4\n"), "faces: truncated, expected 4 lines, found 3");
    assert_eq!(with("5 3\n", "5 2\n"), "data: data goes on after the expected 7 vertices and faces");
    let cut = message(read(&PRISM[..PRISM.find("4 0 1 2 3").expect("a face")]));
    assert_eq!(cut, "faces: truncated, expected 3 lines, found 0");
}

#[test]
fn a_huge_count_allocates_nothing() {
    let huge = u64::MAX;
    let refused = message(read(&format!("OFF\n{huge} {huge} 0\n0 0 0\n")));
    assert_eq!(refused, format!("vertices: truncated, expected {huge} lines, found 1"));
    assert!(message(read(&format!("OFF\n1 1 0\n0 0 0\n{huge} 0\n"))).starts_with("line 4: expected as many"));
}
