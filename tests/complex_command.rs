//! `isoracle complex` as a stranger runs it.
#![cfg(feature = "cli")]

use assert_cmd::Command;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

fn isoracle(folder: &Path, arguments: &[&str], input: &str) -> (Option<i32>, String, String) {
    let binary = assert_cmd::cargo::cargo_bin!("isoracle");
    let output = Command::new(binary)
        .current_dir(folder)
        .arg("complex")
        .args(arguments)
        .write_stdin(input)
        .output()
        .expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    isoracle(folder.path(), arguments, "")
}

/// A lens with its upper and lower n-gon glued after one step around, as the protocol has it.
fn lens(n: usize) -> Value {
    let edges: Vec<[usize; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
    let upper: Vec<i64> = (1..=n as i64).collect();
    let lower: Vec<i64> = upper.iter().rev().map(|edge| -edge).collect();
    json!({
        "polyhedra": [{"edges": edges, "faces": [upper, lower]}],
        "pairings": [{"a": [0, 0], "b": [0, 1], "shift": 1, "dir": -1}],
    })
}

#[test]
fn the_page_of_the_three_torus_has_every_invariant() {
    let (code, out, err) = run(&["T3", "--refine", "2"]);
    assert_eq!(code, Some(0), "{err}");
    for line in [
        "T3: a closed 3-manifold, orientable\n",
        "V = 1, E = 3, F = 3, P = 1, χ = 0\n",
        "t = 12\n",
        "4 (3 times)\n",
        "link of a vertex       sphere\n",
        "H₀ = ℤ, H₁ = ℤ³, H₂ = ℤ³, H₃ = ℤ\n",
        "⟨a, b, c | a b A B, a c A C, b c B C⟩\n",
        "embedding in ℝ⁴        not excluded\n",
        "topological tetrahedra V = 2, E = 14, F = 24, T = 12\n",
        "barycentric tetrahedra V = 8, E = 56, F = 96, T = 48\n",
        "isomorphism signature  mvvLPQwQQhihjhfgklklklxxxxaxxxxaxxa\n",
        "refined to order 2\n  cells                  V = 16, E = 112, F = 192, T = 96\n",
        "t(k³ + k² + 1) = 156, wrong\n",
        "simplicial complex     no",
    ] {
        assert!(out.contains(line), "{line}: {out}");
    }
}

#[test]
fn json_is_what_the_protocol_answers_and_more() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("lens.json"), lens(5).to_string()).expect("it can be written");
    let (code, out, err) = isoracle(folder.path(), &["lens.json", "--json", "--refine", "3"], "");
    assert_eq!(code, Some(0), "{err}");
    let page: Value = serde_json::from_str(&out).expect("JSON");
    let asked = isoracle::answer::out("complex.glue", lens(5).as_object().expect("an object")).expect("it is one");
    let glue: Value = asked.value();
    for (field, value) in glue.as_object().expect("an object") {
        match field.as_str() {
            "homology" => assert_eq!(page["homology"]["h1"], value["h1"]),
            field => assert_eq!(page[field], *value, "{field}"),
        }
    }
    let mut question = lens(5);
    question["order"] = json!(3);
    let refine = isoracle::answer::out("complex.refine", question.as_object().expect("an object")).expect("it is one");
    let mut refinement = refine.value();
    refinement["order"] = json!(3);
    assert_eq!(page["refinement"], refinement);
    assert_eq!(page["vertex_links"], json!(["sphere"]));
    let why = "impossible, the torsion ℤ/5 of H₁ is no A ⊕ A (Hantzsche)";
    assert_eq!(page["embedding_in_r4"], json!({"obstruction": why}));
    assert_eq!(page["fundamental_groups"], json!(["⟨a | a a a a a⟩"]));
    let signature = page["isomorphism_signature"].as_str().expect("a text");
    let again = isoracle::complex::isosig::triangulation(signature).expect("it can be read");
    assert_eq!(Some(again.len() as u64), glue["tetrahedra"]["T"].as_u64());
}

#[test]
fn what_is_written_reads_back_as_the_same_space() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (code, _, err) = isoracle(folder.path(), &["L(5,2)", "--out", "lens.scheme"], "");
    assert_eq!(code, Some(0), "{err}");
    let (_, named, _) = isoracle(folder.path(), &["L(5,2)", "--json"], "");
    let (_, read, _) = isoracle(folder.path(), &["lens.scheme", "--json"], "");
    let text = fs::read_to_string(folder.path().join("lens.scheme")).expect("it was written");
    let (_, piped, _) = isoracle(folder.path(), &["-", "--json"], &text);
    let nameless = |text: &str| {
        let mut page: Value = serde_json::from_str(text).expect("JSON");
        page["name"].take();
        page
    };
    assert_eq!(nameless(&named), nameless(&read));
    assert_eq!(nameless(&named), nameless(&piped));
}

#[test]
fn every_file_of_a_triangulation_is_written() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, begin) in [("t.isosig", "mvvLPQwQQ"), ("t.gluings", "Tet"), ("t.tri", "% Triangulation")] {
        let (code, _, err) = isoracle(folder.path(), &["T3", "--out", name], "");
        assert_eq!(code, Some(0), "{err}");
        let text = fs::read_to_string(folder.path().join(name)).expect("it was written");
        assert!(text.trim_start().contains(begin), "{name}: {text}");
    }
}

#[test]
fn every_file_of_a_realisation_is_written() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for extension in ["ply", "vtu", "gltf", "msh", "svg", "html"] {
        let name = format!("s3.{extension}");
        let arguments = ["S3-tesseract", "--refine", "1", "--realise", "--iterations", "20", "--out", &name];
        let (code, out, err) = isoracle(folder.path(), &arguments, "");
        assert_eq!(code, Some(0), "{err}");
        assert!(out.contains("placed in ℝ⁴\n"), "{out}");
        assert!(out.contains("  embedded               "), "{out}");
        assert!(fs::metadata(folder.path().join(&name)).expect("it was written").len() > 1000, "{name}");
    }
}

#[test]
fn a_scheme_that_is_no_manifold_gets_its_reasons_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut open = lens(3);
    open["pairings"] = json!([]);
    fs::write(folder.path().join("open.json"), open.to_string()).expect("it can be written");
    let (code, out, err) = isoracle(folder.path(), &["open.json", "--refine", "2", "--out", "x.isosig"], "");
    assert_eq!(code, Some(1), "{err}");
    assert_eq!(
        out,
        "open.json: no closed complex\n  unmatched-face         face 0 of polyhedron 0 is in no pairing\n  \
         unmatched-face         face 1 of polyhedron 0 is in no pairing\n"
    );
    assert!(err.contains("nothing was written"), "{err}");
    assert!(!folder.path().join("x.isosig").exists());
}

#[test]
fn a_complex_with_a_bad_vertex_has_its_numbers_too() {
    let name = isoracle::complex::zoo::invalid::all()
        .into_iter()
        .find(|broken| broken.defect.reason().name() == "vertex-link")
        .expect("there is one")
        .name;
    let (code, out, err) = run(&[name]);
    assert_eq!(code, Some(1), "{err}");
    assert!(out.starts_with(&format!("{name}: a closed complex, but no 3-manifold\n")), "{out}");
    for line in
        ["  vertex-link            around vertex ", "  cells                  V = ", "  homology               H₀ = "]
    {
        assert!(out.contains(line), "{out}");
    }
}

#[test]
fn the_list_names_what_can_be_asked_for() {
    let (code, out, _) = run(&["--list"]);
    assert_eq!(code, Some(0));
    assert!(out.lines().count() >= 60, "{out}");
    for line in out.lines().take(3).chain(out.lines().rev().take(3)) {
        let name = line.split("  ").next().expect("a name");
        let (code, page, err) = run(&[name]);
        let is_manifold = !line.contains("no manifold");
        assert_eq!(code, Some(if is_manifold { 0 } else { 1 }), "{err}");
        assert_eq!(page.starts_with(&format!("{name}: a closed 3-manifold")), is_manifold, "{page}");
    }
}

#[test]
fn what_cannot_be_used_is_said_before_any_work() {
    for (arguments, words) in [
        (&["no-such-thing"][..], "no-such-thing: "),
        (&["T3", "--refine", "0"], "0 is not in 1.."),
        (&["T3", "--out", "x.doc"], "tetrahedra are written as .tri"),
        (&["T3", "--out", "x.ply"], "shows the tetrahedra placed in space"),
        (&["T3", "--realise", "--out", "x.tri"], "has no places"),
        (&["T3", "--realise"], "--out <FILE>"),
        (&["T3", "--refine", "1000000"], "more than 2²⁷"),
        (&[], "SCHEME"),
    ] {
        let (code, out, err) = run(arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {out}{err}");
        let one_line = err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(one_line.contains(words), "{arguments:?}: {one_line}");
    }
    for (text, words) in
        [("{\"polyhedra\": 1}", "polyhedra: expected an array"), ("{", "not JSON"), ("nonsense 1", "1")]
    {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let (code, out, err) = isoracle(folder.path(), &["-"], text);
        assert_eq!(code, Some(2), "{text}: {out}{err}");
        assert!(err.contains(words), "{text}: {err}");
    }
}
