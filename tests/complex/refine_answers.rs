//! `complex.refine` through the protocol: what is answered, what is refused, and how.

use isoracle::answer::answer;
use serde_json::{Value, json};

fn ask(input: &Value) -> Value {
    let line = json!({"id": 1, "op": "complex.refine", "in": input}).to_string();
    serde_json::from_str(&answer(line.as_bytes())).expect("an answer is JSON")
}

/// L(p, q), refined, with these fields instead.
fn lens(p: u32, q: i64, order: Value) -> Value {
    let upper: Vec<u32> = (1..=p).collect();
    let lower: Vec<i64> = upper.iter().rev().map(|n| -i64::from(*n)).collect();
    json!({
        "polyhedra": [{"edges": (0..p).map(|i| [i, (i + 1) % p]).collect::<Vec<_>>(), "faces": [upper, lower]}],
        "pairings": [{"a": [0, 0], "b": [0, 1], "shift": -q, "dir": -1}],
        "order": order,
    })
}

#[track_caller]
fn is_refused(input: &Value, kind: &str, message: &str) {
    let answer = ask(input);
    assert_eq!((&answer["error"]["kind"], &answer["error"]["message"]), (&json!(kind), &json!(message)));
}

#[test]
fn a_refinement_is_counted_and_compared_with_print() {
    let expected = json!({
        "V": 68, "E": 452, "F": 768, "T": 384,
        "simplicial": true, "degenerate_tetrahedra": 0, "duplicate_tetrahedra": 0,
        "as_printed": {"T": 384, "F": 768, "E": 486},
    });
    assert_eq!(ask(&lens(6, 1, json!(4)))["out"], expected);
    assert_eq!(ask(&lens(6, 1, json!("4")))["out"], expected);
    let rough = ask(&lens(5, 2, json!(2)));
    assert_eq!(rough["out"]["duplicate_tetrahedra"], json!(20));
    assert_eq!(rough["out"]["simplicial"], json!(false));
}

#[test]
fn an_order_is_an_integer_from_one_on() {
    for (order, found) in [(json!(0), "0"), (json!(-2), "-2"), (json!("3/2"), "3/2"), (json!(1.5), "3/2")] {
        is_refused(
            &lens(3, 1, order),
            "invalid-input",
            &format!("order: expected an order, an integer from 1 on, found {found}"),
        );
    }
    is_refused(&lens(3, 1, Value::Null), "invalid-input", "order: expected a number, found null");
}

#[test]
fn too_many_tetrahedra_are_a_limit() {
    let message = "order: a refinement may have at most 2097152 tetrahedra; of order k it has 3·k³";
    for order in [json!(89), json!(4_294_967_297_u64), json!("100000000000000000000000000")] {
        is_refused(&lens(3, 1, order), "limit", message);
    }
    is_refused(&lens(1, 0, json!(129)), "limit", &message.replace('3', "1").replace("k¹", "k³"));
}

#[test]
fn a_scheme_that_is_no_manifold_is_refused() {
    let mut unmatched = lens(3, 1, json!(2));
    unmatched["pairings"] = json!([]);
    is_refused(&unmatched, "invalid-input", "face 0 of polyhedron 0 is in no pairing");
    let mut reversed = lens(1, 0, json!(2));
    reversed["pairings"][0]["dir"] = json!(1);
    is_refused(&reversed, "degenerate", "edge 1 of polyhedron 0 is glued to itself, tail to head");
    // A tetrahedron glued so that a torus or a Klein bottle stands around its one vertex.
    let faces = json!([[1, 2, 3], [4, -2, 5], [-5, -1, 6], [-6, -3, -4]]);
    let polyhedron = json!({"edges": [[1, 3], [3, 2], [2, 1], [0, 2], [3, 0], [1, 0]], "faces": faces});
    let mut links = 0;
    for (b, ways) in [(1, 36), (2, 36), (3, 36)] {
        for way in 0..ways {
            let others: Vec<i64> = (1..4).filter(|f| *f != b).collect();
            let pairing = |a: i64, b: i64, code: i64| json!({"a": [0, a], "b": [0, b], "shift": code / 2, "dir": code % 2 * 2 - 1});
            let pairings = [pairing(0, b, way / 6), pairing(others[0], others[1], way % 6)];
            let answer = ask(&json!({"polyhedra": [polyhedron], "pairings": pairings, "order": 2}));
            let message = answer["error"]["message"].as_str().unwrap_or("").to_owned();
            if message.starts_with("around vertex") {
                assert_eq!(answer["error"]["kind"], json!("degenerate"));
                links += 1;
            }
        }
    }
    assert!(links > 0);
}
