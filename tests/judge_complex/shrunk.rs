//! Wrong candidates, and the small schemes that show what is wrong with them.

use super::*;

#[test]
fn pairs_without_multiplicity_are_caught_in_the_projective_space() {
    let report = judged(|op, input, out| {
        if op == "complex.glue" && out["cells"].is_object() {
            let scheme = isoracle::answer::complex::scheme(input.as_object().unwrap()).unwrap();
            out["facet_edge_pairs"] = json!(counted(&scheme).different);
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    let failure = report.failures.iter().find(|failure| failure.row == "manifolds").unwrap();
    assert_eq!(
        (failure.fault.as_str(), failure.differences[0].invariant.as_str()),
        ("wrong-pairs", "facet_edge_pairs")
    );
    // L(2, 1): one edge, twice a side of the one face.
    assert_eq!(scheme_of(&failure.question), lens_space_as_shrunk());
    assert_eq!((failure.differences[0].expected.as_str(), failure.differences[0].found.as_str()), ("2", "1"));
    assert!(failure.command.starts_with("isoracle judge --suite complex --question "), "{}", failure.command);
}

/// L(2, 1) with its shift 0 … n − 1.
fn lens_space_as_shrunk() -> GluingScheme {
    let mut scheme = lens_space(2, 1);
    scheme.pairings[0].shift = 1;
    scheme
}

#[test]
fn the_euler_characteristic_alone_is_caught_where_edges_are_reversed() {
    let report = judged(|op, input, out| {
        if op != "complex.glue" {
            return;
        }
        let scheme = isoracle::answer::complex::scheme(input.as_object().unwrap()).unwrap();
        if scheme.defects().is_empty() {
            let [v, e, f, p] = counted(&scheme).cells.map(|n| n as i64);
            *out = json!({"valid": v - e + f - p == 0});
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    assert!(report.failures.iter().all(|failure| failure.fault == "wrong-validity"));
    let rows: BTreeSet<&str> = report.failures.iter().map(|failure| failure.row.as_str()).collect();
    assert!(rows.contains("edge-reversed") && !rows.contains("vertex-link") && !rows.contains("manifolds"));
    let smallest = report.failures.iter().find(|failure| failure.row == "edge-reversed").unwrap();
    let scheme = scheme_of(&smallest.question);
    assert!(scheme.polyhedra.len() == 1 && scheme.polyhedra[0].faces.len() == 2, "{scheme:?}");
    assert_eq!(glue(&scheme)["reason"], "edge-reversed");
}

#[test]
fn a_missed_reason_is_shown_by_a_small_scheme() {
    for reason in [Reason::UnmatchedFace, Reason::FaceInTwoPairings, Reason::BadPolyhedron, Reason::VertexLink] {
        let report = judged(|op, _, out| {
            let is_there = out["defects"].as_array().into_iter().flatten().any(|d| d["reason"] == reason.name());
            if op == "complex.glue" && is_there {
                *out = json!({"valid": true});
            }
        });
        let failure = report.failures.iter().find(|failure| failure.row == reason.name()).unwrap();
        let scheme = scheme_of(&failure.question);
        let sides: usize = scheme.polyhedra.iter().flat_map(|p| &p.faces).map(Vec::len).sum();
        assert!(scheme.polyhedra.len() <= 1 && sides <= 12, "{}: {scheme:?}", reason.name());
        let out = glue(&scheme);
        assert!(out["defects"].as_array().unwrap().iter().any(|d| d["reason"] == reason.name()), "{out}");
    }
}

#[test]
fn a_shrunk_scheme_keeps_the_reason_of_its_row() {
    let report = judged(|op, _, out| {
        if op == "complex.glue" && out["valid"] == false {
            *out = json!({"valid": true});
        }
    });
    for row in &Row::CASES[1..] {
        let failure = report.failures.iter().find(|failure| failure.row == row.name()).unwrap();
        let out = glue(&scheme_of(&failure.question));
        assert!(out["defects"].as_array().unwrap().iter().any(|d| d["reason"] == row.name()), "{}: {out}", row.name());
    }
}

#[test]
fn a_fault_that_needs_two_components_keeps_them() {
    let report = judged(|op, _, out| {
        if op == "complex.glue" && out["components"].is_number() {
            out["components"] = json!(1);
        }
    });
    let failure = report.failures.iter().find(|failure| failure.row == "disconnected").unwrap();
    let scheme = scheme_of(&failure.question);
    assert_eq!(ClosedComplex::new(scheme.clone()).unwrap().component_count(), 2);
    let sides: usize = scheme.polyhedra.iter().flat_map(|p| &p.faces).map(Vec::len).sum();
    assert_eq!((scheme.polyhedra.len(), sides), (2, 4), "{scheme:?}");
}

/// The printed number of edges of a refinement, t(k³ + k² + 1), is caught; so are other wrong numbers of it.
#[test]
fn wrong_refinements_are_caught_and_shown_at_a_small_order() {
    let report = judged(|op, _, out| {
        if op == "complex.refine" {
            out["E"] = out["as_printed"]["E"].clone();
        }
    });
    assert_eq!(report.verdict, Outcome::Wrong);
    assert!(report.failures.iter().all(|f| f.row == "refinements" && f.fault == "wrong-counts"));
    let failure = &report.failures[0];
    let QuestionRecord::Other { op, input } = &failure.question else { panic!("not about a volume") };
    // The 3-sphere of one monogon has t = 1 and V + P = 2, for which the printed number holds up to order 3 alone.
    assert_eq!((op.as_str(), &input["order"]), ("complex.refine", &json!(4)));
    assert_eq!(counted(&scheme_of(&failure.question)).cells, [1; 4]);
    assert_eq!(counted(&scheme_of(&failure.question)).degrees, [1]);
    for (name, fault) in [
        ("V", "wrong-counts"),
        ("F", "wrong-counts"),
        ("T", "wrong-counts"),
        ("simplicial", "wrong-simpliciality"),
        ("degenerate_tetrahedra", "wrong-degenerates"),
        ("duplicate_tetrahedra", "wrong-duplicates"),
        ("as_printed", "wrong-printed"),
    ] {
        let found = asked(&mut altered(|op, _, out| {
            if op == "complex.refine" {
                out[name] = match &out[name] {
                    Value::Bool(is_so) => json!(!is_so),
                    Value::Number(n) => json!(n.as_u64().unwrap() + 1),
                    _ => json!({"E": -1}),
                };
            }
        }));
        assert_eq!(found, BTreeSet::from([("refinements", fault)]), "{name}");
    }
    let mut refines_all = Altered(|_: &str, _: &Value, out: Value| Reply::Out(out));
    let none = questions(7, 8).into_iter().filter(|question| question.row == Row::NoRefinements);
    assert!(
        none.clone().count() == 8
            && none.into_iter().all(|q| matches!(SUITE.ask(&mut refines_all, &q), Judgement::Right { .. }))
    );
}
