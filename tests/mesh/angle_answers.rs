//! `mesh.angle_deficits`, asked through the protocol.
#![cfg(feature = "cli")]

use isoracle::answer::answer;
use isoracle::linear::Vector;
use isoracle::mesh::angle_deficit::AngleMesh;
use isoracle::number::{Rational, text};
use proptest::prelude::*;
use serde_json::{Value, json};

fn ask(input: &Value) -> Value {
    let line = json!({"id": 1, "op": "mesh.angle_deficits", "in": input}).to_string();
    serde_json::from_str(&answer(line.as_bytes())).expect("an answer is JSON")
}

fn out(input: &Value) -> Value {
    let answer = ask(input);
    assert!(answer["out"].is_object(), "{answer}");
    answer["out"].clone()
}

fn error(input: &Value) -> (String, String) {
    let answer = ask(input);
    let field = |name: &str| answer["error"][name].as_str().unwrap_or_else(|| panic!("{answer}")).to_owned();
    (field("kind"), field("message"))
}

fn exact(value: &Value) -> Rational {
    text::parse(value.as_str().expect("numbers leave as strings")).expect("an exact number")
}

fn bounds(enclosure: &Value) -> [Rational; 2] {
    ["lo", "hi"].map(|bound| exact(&enclosure[bound]))
}

/// Answers derived elsewhere; a decimal there lies within 10⁻²⁵ of the true value.
#[test]
fn the_answered_questions_conform() {
    let cases: Vec<Value> = include_str!("angle_deficits.jsonl")
        .lines()
        .map(|line| serde_json::from_str(line).expect("a case is JSON"))
        .collect();
    assert_eq!(cases.len(), 2);
    for case in cases {
        let (known, found) = (&case["out"], out(&case["in"]));
        assert_eq!((&known["chi"], &known["total_over_pi"]), (&found["chi"], &found["total_over_pi"]));
        let deficits = |out: &Value| out["deficits"].as_array().expect("a list").clone();
        assert_eq!(deficits(known).len(), deficits(&found).len());
        for (known, found) in deficits(known).iter().zip(deficits(&found)) {
            let (known, [lo, hi]) = (exact(known), bounds(&found));
            let slack = Rational::from((1, 10_i64.pow(18))) / 10_000_000;
            assert!(lo <= known.clone() + &slack && known <= hi + slack, "{}", case["case"]);
        }
    }
}

#[test]
fn a_corner_of_the_cube_with_its_border_and_a_vertex_of_no_triangle() {
    let out = out(&json!({
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], ["1/3", "0.5", 2]],
        "faces": [[0, 1, 2], [0, 3, 2], [3, 1, 0]],
    }));
    assert_eq!((&out["chi"], &out["total_over_pi"]), (&json!(2), &json!("4")));
    assert_eq!(out["over_pi"], json!(["1/2", "1/2", "1/2", "1/2", "2"]));
    let corner =
        |triangle, sign, cos_squared| json!({"triangle": triangle, "cos_sign": sign, "cos_squared": cos_squared});
    let angles = json!([
        [corner(0, 0, "0"), corner(1, 0, "0"), corner(2, 0, "0")],
        [corner(0, 1, "1/2"), corner(2, 1, "1/2")],
        [corner(0, 1, "1/2"), corner(1, 1, "1/2")],
        [corner(1, 1, "1/2"), corner(2, 1, "1/2")],
        [],
    ]);
    assert_eq!(out["angles"], angles);
}

#[test]
fn an_obtuse_angle_has_a_negative_cosine() {
    let out = out(&json!({"vertices": [[0, 0, 0], [1, 0, 0], [-1, "1/2", 0]], "faces": [[1, 0, 2]]}));
    assert_eq!(out["angles"][0], json!([{"triangle": 0, "cos_sign": -1, "cos_squared": "4/5"}]));
    assert_eq!(out["angles"][1], json!([{"triangle": 0, "cos_sign": 1, "cos_squared": "16/17"}]));
}

#[test]
fn enclosures_are_as_narrow_as_asked_for_and_0_is_0() {
    let fan = |digits: Value| {
        out(&json!({
            "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, -1, 0], [7, 1, 3]],
            "faces": [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 2, 4]],
            "digits": digits,
        }))
    };
    for digits in [0, 1, 10, 30, 31, 200] {
        let out = fan(json!(digits));
        assert_eq!(out["over_pi"][0], "0");
        assert_eq!(bounds(&out["deficits"][0]), [Rational::new(), Rational::new()]);
        for deficit in &out["deficits"].as_array().expect("a list")[1..] {
            let [lo, hi] = bounds(deficit);
            let width = Rational::from(&hi - &lo);
            let magnitude = lo.abs().min(hi.abs()).max(Rational::from(1));
            let unit = Rational::from(10).recip();
            let allowed = (0..digits).fold(magnitude, |x, _| x * &unit);
            assert!(width > 0 && width <= allowed, "{digits}: {width}");
        }
    }
    assert_eq!(fan(json!(30))["deficits"], fan(json!("30"))["deficits"]);
}

#[test]
fn ill_posed_questions_are_refused_with_the_field_that_is_wrong() {
    let vertices = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0]]);
    let of_faces = |faces: Value| error(&json!({"vertices": vertices, "faces": faces}));
    let invalid = |message: &str| ("invalid-input".to_owned(), message.to_owned());
    let number = "expected the number of a vertex, an integer from 0 on, found";
    for (faces, message) in [
        (json!([[0, 1, 2], [0, 1, 4]]), "faces[1]: triangle 1 names a vertex that does not exist".to_owned()),
        (json!([[0, 1, 1_u64 << 40]]), "faces[0]: triangle 0 names a vertex that does not exist".to_owned()),
        (json!([[0, 1, 2], [2, 1, 2]]), "faces[1]: triangle 1 names vertex 2 twice".to_owned()),
        (json!([[0, 1, 2, 3]]), "faces[0]: expected 3 items, found 4".to_owned()),
        (json!([[0, 1]]), "faces[0]: expected 3 items, found 2".to_owned()),
        (json!([7]), "faces[0]: expected an array, found a number".to_owned()),
        (json!([[0, 1, -1]]), format!("faces[0][2]: {number} -1")),
        (json!([[0, "1/2", 1]]), format!("faces[0][1]: {number} 1/2")),
        (json!({}), "faces: expected an array, found an object".to_owned()),
    ] {
        assert_eq!(of_faces(faces), invalid(&message));
    }
    let of_vertices = |vertices: Value| error(&json!({"vertices": vertices, "faces": [[0, 1, 2]]}));
    assert_eq!(of_vertices(json!([[0, 0], [1, 0]])), invalid("vertices[0]: expected 3 items, found 2"));
    assert!(of_vertices(json!([[0, 0, "NaN"]])).1.starts_with("vertices[0][2]: "));
    assert_eq!(error(&json!({"faces": []})), invalid("vertices: missing"));
    assert_eq!(error(&json!({"vertices": []})), invalid("faces: missing"));
    let of_digits = |digits: Value| error(&json!({"vertices": [], "faces": [], "digits": digits}));
    assert_eq!(of_digits(json!(-1)), invalid("digits: expected a number of digits, an integer from 0 on, found -1"));
    assert_eq!(of_digits(json!(1_u64 << 40)).0, "limit");
    assert_eq!(of_digits(json!(10_001)).0, "limit");
    let message = "triangle 1 is degenerate: its corners are on one line";
    assert_eq!(of_faces(json!([[0, 1, 2], [0, 1, 3]])), ("degenerate".to_owned(), message.to_owned()));
    // Equal positions of different numbers are a degenerate triangle too.
    assert_eq!(of_vertices(json!([[1, 2, 3], [1, 2, 3], [0, 0, 0]])).0, "degenerate");
}

#[test]
fn the_empty_mesh_has_nothing() {
    let empty = json!({"chi": 0, "total_over_pi": "0", "deficits": [], "over_pi": [], "angles": []});
    assert_eq!(out(&json!({"vertices": [], "faces": []})), empty);
}

proptest! {
    #[test]
    fn answers_are_those_of_the_room_and_agree_with_one_another(
        points in prop::collection::vec(prop::array::uniform3(-3_i64..=3), 6),
        faces in prop::collection::vec(prop::array::uniform3(0_u32..6), 0..8),
    ) {
        let positions = points.iter().map(|p| Vector(p.map(Rational::from))).collect();
        let answer = ask(&json!({"vertices": points, "faces": faces}));
        match AngleMesh::new(positions, faces) {
            Err(_) => prop_assert!(answer["error"].is_object()),
            Ok(mesh) => {
                let out = &answer["out"];
                let total = mesh.total_curvature();
                prop_assert_eq!(&out["chi"], &json!(total.chi));
                prop_assert_eq!(&out["total_over_pi"], &json!((2 * total.chi).to_string()));
                for v in 0..6 {
                    let [lo, hi] = bounds(&out["deficits"][v]);
                    let (low, high) = mesh.curvature(v as u32).enclosure(300).bounds().expect("finite");
                    prop_assert!(lo <= high && low <= hi && hi - lo <= Rational::from((1, 1_i64 << 62)));
                    let curvature = mesh.curvature(v as u32);
                    let angles = mesh.corners(v as u32).iter().zip(&curvature.angles).map(|(corner, angle)| {
                        let squared = angle.cos_squared().to_string();
                        json!({"triangle": corner.triangle, "cos_sign": angle.cos_sign().value(), "cos_squared": squared})
                    });
                    prop_assert_eq!(&out["angles"][v], &Value::from(angles.collect::<Vec<_>>()));
                    match mesh.curvature(v as u32).over_pi() {
                        Some(multiple) => prop_assert_eq!(exact(&out["over_pi"][v]), multiple),
                        None => prop_assert!(out["over_pi"][v].is_null()),
                    }
                }
            }
        }
    }
}
