//! When an answer is right.

use super::*;

mod cx_98 {
    use super::*;

    #[test]
    fn every_number_is_judged() {
        for (pointer, fault) in [
            ("/cells/V", "wrong-counts"),
            ("/cells/E", "wrong-counts"),
            ("/cells/F", "wrong-counts"),
            ("/cells/P", "wrong-counts"),
            ("/chi", "wrong-counts"),
            ("/facet_edge_pairs", "wrong-pairs"),
            ("/components", "wrong-components"),
            ("/homology/h1/rank", "wrong-homology"),
            ("/tetrahedra/V", "wrong-tetrahedra"),
            ("/tetrahedra/E", "wrong-tetrahedra"),
            ("/tetrahedra/F", "wrong-tetrahedra"),
            ("/tetrahedra/T", "wrong-tetrahedra"),
            ("/barycentric/V", "wrong-barycentric"),
            ("/barycentric/E", "wrong-barycentric"),
            ("/barycentric/F", "wrong-barycentric"),
            ("/barycentric/T", "wrong-barycentric"),
        ] {
            let found = asked(&mut altered(|op, _, out| {
                if let (true, Some(n)) = (op == "complex.glue", out.pointer_mut(pointer)) {
                    *n = json!(n.as_i64().unwrap() + 1);
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from([fault]), "{pointer}");
        }
        for name in ["valid", "orientable"] {
            let found = asked(&mut altered(|op, _, out| {
                if op == "complex.glue" && out[name].is_boolean() {
                    out[name] = json!(!out[name].as_bool().unwrap());
                }
            }));
            let fault = if name == "valid" { "wrong-validity" } else { "wrong-orientability" };
            assert_eq!(faults(&found), BTreeSet::from([fault]));
            let rows = found.iter().map(|(row, _)| *row).collect::<BTreeSet<_>>();
            assert!(name == "orientable" || rows.len() == Row::CASES.len() + Row::GLUED.len(), "{rows:?}");
        }
        for name in ["edge_ring_sizes", "face_degrees"] {
            let found = asked(&mut altered(|op, _, out| {
                if let (true, Some(list)) = (op == "complex.glue", out.get_mut(name).and_then(Value::as_array_mut)) {
                    list.pop();
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from(["wrong-pairs"]));
        }
    }

    #[test]
    fn lists_have_no_order_and_torsion_is_a_group() {
        let found = asked(&mut altered(|_, _, out| {
            for name in ["edge_ring_sizes", "face_degrees"] {
                if let Some(list) = out.get_mut(name).and_then(Value::as_array_mut) {
                    list.reverse();
                }
            }
            if let Some(list) = out.pointer_mut("/homology/h1/torsion").and_then(Value::as_array_mut) {
                list.insert(0, json!("1"));
                list.reverse();
            }
        }));
        assert!(found.is_empty(), "{found:?}");
        let beside = |p: u32, q: u32| {
            let (mut one, mut other) = (lens_space(p, 1), lens_space(q, 1));
            one.polyhedra.append(&mut other.polyhedra);
            let face = |face| isoracle::complex::scheme::FaceId { polyhedron: 1, face };
            other.pairings.iter_mut().for_each(|p| (p.a, p.b) = (face(0), face(1)));
            one.pairings.append(&mut other.pairings);
            one
        };
        for (p, q, right, wrong) in [
            (
                2,
                6,
                vec![json!([2, 2, 3]), json!(["3", 2, "2"]), json!([6, 2])],
                vec![json!([12]), json!([3, 4]), json!([2, 3])],
            ),
            (
                4,
                6,
                vec![json!([4, 6]), json!([2, 12]), json!([2, 4, 3])],
                vec![json!([24]), json!([2, 2, 6]), json!([8, 3])],
            ),
            (
                12,
                1,
                vec![json!([3, 4]), json!([4, 3, 1])],
                vec![json!([2, 6]), json!([]), json!([0, 12]), json!([-12]), json!("12")],
            ),
        ] {
            let question = question(&beside(p, q));
            let judge = |torsion: &Value| {
                SUITE.ask(&mut altered(|_, _, out| out["homology"]["h1"]["torsion"] = torsion.clone()), &question)
            };
            assert!(right.iter().all(|torsion| matches!(judge(torsion), Judgement::Right { .. })), "{p}, {q}");
            let is_wrong = |torsion| matches!(judge(torsion), Judgement::Wrong { fault: "wrong-homology", .. });
            assert!(wrong.iter().all(is_wrong), "{p}, {q}");
        }
    }

    #[test]
    fn any_reason_that_holds_will_do_and_no_other() {
        let second = asked(&mut altered(|_, _, out| {
            if let Some(last) = out["defects"].as_array().and_then(|defects| defects.last()) {
                out["reason"] = last["reason"].clone();
            }
        }));
        assert!(second.is_empty(), "{second:?}");
        for reason in ["vertex-link", "unmatched-face", "edge-reversed", "no-such-reason"] {
            let found = asked(&mut altered(|op, _, out| {
                if op == "complex.glue" && out["valid"] == false {
                    out["reason"] = json!(reason);
                }
            }));
            assert_eq!(faults(&found), BTreeSet::from(["wrong-reason"]));
            let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
            assert!(!rows.contains(reason), "{rows:?}");
            // The middle of a reversed edge has no sphere around it.
            assert_eq!(rows.contains("edge-reversed"), ["unmatched-face", "no-such-reason"].contains(&reason));
            assert!(rows.contains("face-in-two-pairings"));
        }
    }

    #[test]
    fn a_scheme_that_cannot_be_glued_may_be_refused_and_no_other() {
        let mut refuses = Altered(|_: &str, _: &Value, out: Value| match out["valid"] == false {
            true => Reply::Error { kind: "invalid-input".into(), message: "no".into() },
            false => Reply::Out(out),
        });
        let found = asked(&mut refuses);
        assert_eq!(faults(&found), BTreeSet::from(["refused"]));
        let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
        for reason in
            ["unmatched-face", "polygon-size-mismatch", "face-glued-to-itself", "bad-polyhedron", "bad-pairing"]
        {
            assert!(!rows.contains(reason), "{reason}");
        }
        assert!(rows.contains("edge-reversed") && rows.contains("vertex-link") && !rows.contains("manifolds"));
        let mut limited =
            Altered(|_: &str, _: &Value, _: Value| Reply::Error { kind: "limit".into(), message: "n".into() });
        assert!(matches!(SUITE.ask(&mut limited, &question(&three_torus())), Judgement::Unsupported(_)));
        for kind in ["invalid-input", "degenerate", "internal"] {
            let mut refuses = Altered(|_: &str, _: &Value, _| Reply::Error { kind: kind.into(), message: "n".into() });
            let judgement = SUITE.ask(&mut refuses, &question(&three_torus()));
            assert!(matches!(judgement, Judgement::Wrong { fault: "refused", .. }), "{kind}");
            // Where nothing can be glued, this is the kind of error.
            let mut unpaired = question(&three_torus());
            unpaired.scheme.pairings.clear();
            let is_right = matches!(SUITE.ask(&mut refuses, &unpaired), Judgement::Right { .. });
            assert_eq!(is_right, kind == "invalid-input");
        }
    }

    #[test]
    fn what_is_left_out_is_named_and_saying_nothing_is_wrong() {
        let report = judged(|op, _, out| {
            if op == "complex.glue" {
                *out = json!({"valid": out["valid"]});
            }
        });
        assert_eq!(report.verdict, Outcome::Passed);
        for name in ["reason", "chi", "cells.V", "homology.h1.torsion", "barycentric.T"] {
            assert!(report.left_out.contains(&name.to_owned()), "{name}: {:?}", report.left_out);
        }
        assert!(!report.left_out.contains(&"valid".to_owned()));
        let found = asked(&mut altered(|_, _, out| *out = json!({"more": 1})));
        assert_eq!(faults(&found), BTreeSet::from(["says-nothing"]));
    }

    #[test]
    fn numbers_are_those_of_cells_joined_by_hand() {
        let mut some = 0;
        for question in questions(11, 6) {
            let out = glue(&question.scheme);
            if out["cells"].is_null() {
                continue;
            }
            some += 1;
            let counted = counted(&question.scheme);
            let cells = ["V", "E", "F", "P"].map(|name| out["cells"][name].as_u64().unwrap() as usize);
            assert_eq!(cells, counted.cells);
            assert_eq!(out["edge_ring_sizes"], json!(counted.rings));
            assert_eq!(out["face_degrees"], json!(counted.degrees));
            assert_eq!(out["facet_edge_pairs"], json!(counted.degrees.iter().sum::<u64>()));
            assert_eq!(out["facet_edge_pairs"], json!(counted.rings.iter().sum::<u64>()));
            assert_eq!(out["components"], json!(counted.components));
        }
        assert!(some > 60, "{some}");
    }
}
