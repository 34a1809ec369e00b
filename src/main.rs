//! The command line, thin.
use isoracle::isosurface::cell;
use isoracle::number::Rational;
use std::io::BufRead;
fn main() {
    for line in std::io::stdin().lock().lines() {
        let v: serde_json::Value = serde_json::from_str(&line.unwrap()).unwrap();
        let q = |x: &serde_json::Value| -> Rational { x.to_string().trim_matches('"').parse().unwrap() };
        let i = &v["in"];
        if let Some(a) = i["volume"]["values"].as_array() {
            use isoracle::isosurface::*;
            let vol = volume::Volume::rationals(
                std::array::from_fn(|k| i["volume"]["shape"][k].as_u64().unwrap() as usize),
                a.iter().map(q).collect(),
            )
            .unwrap();
            let tie = if i["tie"] == "below" { cell::Tie::Below } else { cell::Tie::Degenerate };
            let level = volume::Level { volume: &vol, isovalue: q(&i["isovalue"]), tie };
            let t = topology::topology(&level).unwrap();
            let m = mesh::extract(&level).unwrap();
            let mut edges = std::collections::HashMap::new();
            for t in &m.triangles {
                for k in 0..3 {
                    *edges.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
                }
            }
            assert!(edges.values().all(|&n| n == 1));
            let bd = edges.keys().filter(|(a, b)| !edges.contains_key(&(*b, *a))).count();
            let chi = m.vertices.len() as i64 - (edges.len() as i64 + bd as i64) / 2 + m.triangles.len() as i64;
            assert_eq!(chi, t.chi());
            println!(
                "{}",
                serde_json::json!({"id":v["id"],"out":{"chi":t.chi(),"components":t.components.len(),"boundary_loops":t.boundary_loops(),"b0_neg":t.b0_negative,"b0_pos":t.b0_positive,"edge_crossings":t.edge_crossings,"component_list":t.components.iter().map(|c| [c.chi,c.boundary_loops,c.genus]).collect::<Vec<_>>()}})
            );
            continue;
        }
        let Some(a) = i["values"].as_array() else { continue };
        let vals: [Rational; 8] = std::array::from_fn(|k| q(&a[k]));
        let tie = if i["tie"] == "below" { cell::Tie::Below } else { cell::Tie::Degenerate };
        match cell::topology(&vals, &q(&i["isovalue"]), tie) {
            Err(e) => println!("{}", serde_json::json!({"id":v["id"],"error":e.to_string()})),
            Ok(t) => {
                let l: Vec<Vec<_>> =
                    t.loops.iter().map(|l| l.iter().map(|e| e.corners().map(|c| c.index())).collect()).collect();
                let parts = |s: &cell::Side| -> Vec<Vec<usize>> {
                    s.parts.iter().map(|p| p.iter().map(|c| c.index()).collect()).collect()
                };
                println!(
                    "{}",
                    serde_json::json!({"id":v["id"],"out":{"case":t.case.name(),"faces":t.decisions.faces,"loops":l,"chi":t.chi(),
                "components":t.components.iter().map(|c| serde_json::json!({"loops":c.loops,"chi":c.chi,"genus":c.genus})).collect::<Vec<_>>(),
                "b0_neg":t.negative.parts.len(),"b0_pos":t.positive.parts.len(),"b1_neg":t.negative.b1,"b1_pos":t.positive.b1,"neg_parts":parts(&t.negative),"pos_parts":parts(&t.positive)}})
                );
            }
        }
    }
}
