//! Refinement of order k.

use super::gluings::{all_complexes, all_gluings, examples};
use isoracle::complex::check::{check, fast as fast_check};
use isoracle::complex::refine::{fast, refine};
use isoracle::complex::refine::simplicial::obstructions;

#[test]
fn explore() {
    for (name, complex) in examples() {
        for k in 1..=5 {
            let base = complex.tetrahedra();
            let plain = refine(&base, k).unwrap();
            let quick = fast::refine(&base, k).unwrap();
            assert_eq!(plain.triangulation(), quick.triangulation(), "{name} {k}");
            let facts = check(plain.triangulation());
            assert_eq!(facts, fast_check::check(plain.triangulation()));
            let predicted = obstructions(&base).iter().all(|o| !o.matters(k));
            println!("{name} {k} {facts:?} {predicted}");
            assert_eq!(predicted, facts.vertex_sets.simplicial);
        }
    }
    for t in 1..=3 {
        let mut tally = std::collections::BTreeMap::new();
        for base in all_gluings(t) {
            let bf = fast_check::check(&base);
            if bf.defects.iter().any(|d| matches!(d, isoracle::complex::check::TriangulationDefect::EdgeReversed{..})) { continue; }
            let o = obstructions(&base);
            for k in 1..=5 {
                let q = fast::refine(&base, k).unwrap();
                let facts = fast_check::check(q.triangulation());
                *tally.entry((k, facts.vertex_sets.simplicial, o.iter().all(|o| !o.matters(k)))).or_insert(0) += 1;
            }
        }
        println!("{t} {tally:?}");
    }
    let mut tally = std::collections::BTreeMap::new();
    for c in all_complexes(&isoracle::complex::scheme::Polyhedron::cube()) {
        let base = c.tetrahedra();
        let o = obstructions(&base);
        for k in 1..=4 {
            let q = fast::refine(&base, k).unwrap();
            let facts = fast_check::check(q.triangulation());
            *tally.entry((k, facts.vertex_sets.simplicial, o.iter().all(|o| !o.matters(k)))).or_insert(0) += 1;
        }
    }
    println!("cube {tally:?}");
}
