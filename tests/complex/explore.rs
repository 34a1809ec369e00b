use super::gluings::*;
use isoracle::complex::check::{TriangulationDefect, check, fast as fast_check};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::lens_space;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::radial::radial;
use isoracle::complex::refine::simplicial::{Obstruction, obstructions};
use isoracle::complex::refine::{fast, refine};
use isoracle::complex::scheme::Polyhedron;
use std::collections::BTreeMap;

#[test]
fn explore() {
    for (name, complex) in examples() {
        let base = complex.tetrahedra();
        let r = radial(&base).unwrap();
        let f = fast_check::check(&r.triangulation);
        print!("{name}: t {} -> {} {:?} {:?}; ", base.len(), r.triangulation.len(), f.counts, f.defects);
        for k in 1..=5 {
            let q = fast::refine(&r.triangulation, k).unwrap();
            let v = fast_check::check(q.triangulation()).vertex_sets;
            print!("{k}:{},{},{} ", v.degenerate_tetrahedra, v.duplicate_tetrahedra, v.simplicial);
        }
        println!(
            " regular {} bary {} base obst {:?} after {:?}",
            complex.is_regular(),
            check(&complex.barycentric()).vertex_sets.simplicial,
            obstructions(&base),
            obstructions(&r.triangulation)
        );
    }
    // pairs
    let mut tally: BTreeMap<(u32, bool, bool, bool), u32> = BTreeMap::new();
    let mut sets: BTreeMap<Vec<Obstruction>, u32> = BTreeMap::new();
    let mut most = BTreeMap::new();
    let mut go = |base: &isoracle::complex::triangulation::Triangulation, kmax: u32| {
        let bf = fast_check::check(base);
        if bf.defects.iter().any(|d| matches!(d, TriangulationDefect::EdgeReversed { .. })) {
            return;
        }
        if bf.defects.is_empty() && bf.components == 1 {
            *most.entry((base.len(), bf.counts[0])).or_insert(0) += 1;
        }
        let o = obstructions(base);
        *sets.entry(o.iter().copied().collect()).or_default() += 1;
        for k in 1..=kmax {
            let v = fast_check::check(fast::refine(base, k).unwrap().triangulation()).vertex_sets;
            *tally
                .entry((
                    k,
                    v.duplicate_tetrahedra > 0,
                    v.degenerate_tetrahedra > 0,
                    o.contains(&Obstruction::CornersBetweenEnds),
                ))
                .or_insert(0) += 1;
        }
    };
    for t in 1..=3 {
        for base in all_gluings(t) {
            go(&base, 6);
        }
    }
    for (p, q) in [
        (4, 1),
        (5, 1),
        (5, 2),
        (6, 1),
        (7, 1),
        (7, 2),
        (7, 3),
        (8, 1),
        (8, 3),
        (9, 1),
        (9, 2),
        (10, 3),
        (11, 3),
        (12, 5),
        (13, 5),
    ] {
        go(&ClosedComplex::new(lens_space(p, q)).unwrap().tetrahedra(), 6);
    }
    for c in all_complexes(&Polyhedron::cube()).step_by(5) {
        go(&c.tetrahedra(), 4);
    }
    println!("{tally:#?}");
    println!("{sets:?}");
    println!("most {most:?}");
    let mut x4 = BTreeMap::new();
    for s in all_schemes(&Polyhedron::cube()) {
        if let Ok(m) = Manifold3::new(s) {
            *x4.entry(m.counts()[0]).or_insert(0) += 1;
        }
    }
    println!("cube V {x4:?}");
    let mut x1 = BTreeMap::new();
    for s in all_schemes(&Polyhedron::tetrahedron()) {
        if let Ok(m) = Manifold3::new(s) {
            *x1.entry(m.counts()[0]).or_insert(0) += 1;
        }
    }
    println!("tet V {x1:?}");
}
