//! Any bytes, and lines near sound ones.

use super::{ask, is_refused, question};
use isoracle::isosurface::cell::{self, Tie};
use isoracle::number::Rational;
use proptest::prelude::*;
use serde_json::{Value, json};

/// Lines near sound ones: a sound one with some of its bytes changed, dropped or repeated.
fn nearly_a_question() -> impl Strategy<Value = Vec<u8>> {
    let sound = prop::sample::select(vec![
        r#"{"id":1,"op":"hello","in":{"protocol":1}}"#,
        r#"{"id":[1,{"a":"b\n"}],"op":"isosurface.cell","in":{"values":[1,-2.5e-3,"1/3",NaN,5,6,"0x1p3",-8],"isovalue":0,"tie":"below"}}"#,
        r#"{"id":null,"op":"isosurface.cell","in":{"values":[1,-1,-1,1,-1,1,1,-1],"isovalue":"1/7"}}"#,
        r#"{"id":"x","op":"isosurface.topology","in":{"volume":{"shape":[2,2,3],"values":[1,-2,3,-4,5,-6,7,-8,9,-10,11,-12]},"isovalue":0.5}}"#,
        r#"{"id":2,"op":"isosurface.mesh","in":{"volume":{"shape":[2,2,2],"values":[1,-2,3,-4,5,-6,7,-8]},"isovalue":-0.5}}"#,
        r#"{"id":3,"op":"isosurface.polyline","in":{"shape":[3,2],"values":[1,-2,3,-4,5,-6],"isovalue":0,"method":"squares"}}"#,
        r#"{"id":4,"op":"trilinear.evaluate","in":{"values":[1,2,3,4,5,6,7,9],"points":[[0.5,"1/2",0]]}}"#,
        r#"{"id":5,"op":"mesh.check","in":{"vertices":[[0,0,0],[3,0,0],[0,3,0],[1,1,0],[2,1,0],[1,2,0],[0,0,"1/2"]],"faces":[[0,1,2],[0,6,1],[1,6,2],[2,6,0]],"holes":{"0":[[3,5,4]]},"edges":[[0,1],[2,1]],"edge_faces":[[0,1],[0]]}}"#,
        r#"{"id":6,"op":"mesh.plane","in":{"polygon":[[0,0,0],[1,0,"1/3"],[1,1,0.5],[0,1,0]]}}"#,
    ]);
    let byte = prop_oneof![3 => prop::sample::select(b"{}[]\":,0123456789.-+eE/xNI\\ ntfu".to_vec()), 1 => any::<u8>()];
    let change = (any::<prop::sample::Index>(), byte, 0..4_u8);
    (sound, prop::collection::vec(change, 0..6)).prop_map(|(sound, changes)| {
        let mut line = sound.as_bytes().to_vec();
        for (at, byte, how) in changes {
            let at = at.index(line.len());
            match how {
                0 => line[at] = byte,
                1 => line.insert(at, byte),
                2 if line.len() > 1 => drop(line.remove(at)),
                _ => line.extend_from_within(at..),
            }
        }
        line
    })
}

fn is_blank(line: &[u8]) -> bool {
    line.iter().all(|byte| b" \t\r".contains(byte))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes_have_an_answer_a_line(
        lines in prop::collection::vec(
            prop_oneof![nearly_a_question(), prop::collection::vec(any::<u8>(), 0..40)], 0..8,
        ),
    ) {
        let input = lines.join(&b'\n');
        let expected: Vec<&[u8]> = input.split(|byte| *byte == b'\n').filter(|line| !is_blank(line)).collect();
        let answers = ask(&input);
        prop_assert_eq!(answers.len(), expected.len());
        for (line, answer) in expected.into_iter().zip(answers) {
            // A line that is JSON as it stands is answered with its own id, or as malformed.
            let sent: Option<Value> = serde_json::from_slice(line).ok();
            let own_id = sent.as_ref().map(|question| question.get("id").cloned().unwrap_or_default());
            let error = &answer["error"];
            if error["kind"] == "malformed" {
                prop_assert_eq!(&answer["id"], &Value::Null);
            } else if let Some(id) = own_id {
                prop_assert_eq!(&answer["id"], &id);
            }
            prop_assert_ne!(&error["kind"], "internal");
            let fields = ["out", "error", "unsupported"].iter().filter(|field| answer.get(field).is_some()).count();
            prop_assert_eq!((fields, answer.as_object().map(|fields| fields.len())), (1, Some(2)));
        }
    }

    #[test]
    fn the_protocol_adds_nothing_to_a_cell(values in prop::array::uniform8(-4_i64..5), below in any::<bool>()) {
        let (tie, rest) = if below { (Tie::Below, r#","tie":"below""#) } else { (Tie::Degenerate, "") };
        let answer = question("isosurface.cell", &format!(r#"{{"values":{values:?},"isovalue":0{rest}}}"#));
        match cell::topology(&values.map(Rational::from), &Rational::new(), tie) {
            Ok(topology) => {
                let out = &answer["out"];
                prop_assert_eq!(&out["case"], topology.case.name());
                prop_assert_eq!(&out["faces"], &json!(topology.decisions.faces));
                prop_assert_eq!(&out["chi"], topology.chi());
                let counts = [
                    (&out["b0_neg"], &out["neg_parts"], topology.negative.parts.len()),
                    (&out["b0_pos"], &out["pos_parts"], topology.positive.parts.len()),
                ];
                for (count, parts, expected) in counts {
                    prop_assert_eq!(count.as_u64(), Some(expected as u64));
                    prop_assert_eq!(parts.as_array().map(Vec::len), Some(expected));
                }
                prop_assert_eq!((&out["b1_neg"], &out["b1_pos"]), (&json!(topology.negative.b1), &json!(topology.positive.b1)));
                prop_assert_eq!(out["loops"].as_array().map(Vec::len), Some(topology.loops.len()));
            }
            Err(error) => is_refused(&answer, json!(7), "degenerate", &error.to_string()),
        }
    }
}
