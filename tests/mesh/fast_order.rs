//! The check of large meshes does not depend on the order of vertices and faces.

use crate::fast::{grid, polygons, soup};
use isoracle::mesh::defects::{Category, Element};
use isoracle::mesh::fast::equal::mixed;
use isoracle::mesh::fast::order::{Renumbered, is_scattered};
use isoracle::mesh::fast::{Polygons, Report, check, check_in_order};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// New numbers, by old number.
type Numbers = Vec<u32>;

/// The mesh whose vertices and faces have these numbers.
fn renumbered(mesh: &Polygons, vertices: &Numbers, faces: &Numbers) -> Polygons {
    let mut points = mesh.vertices().to_vec();
    vertices.iter().zip(mesh.vertices()).for_each(|(&new, &point)| points[new as usize] = point);
    let mut loops = vec![Vec::new(); mesh.faces()];
    for (face, &new) in mesh.loops().zip(faces) {
        loops[new as usize] = face.iter().map(|&v| *vertices.get(v as usize).unwrap_or(&v)).collect();
    }
    polygons(&points, &loops)
}

/// The defects in other numbers.
fn defects(report: &Report, vertices: &Numbers, faces: &Numbers) -> BTreeMap<Category, BTreeSet<Element>> {
    let vertex = |v: &u32| vertices[*v as usize];
    let face = |f: &usize| faces[*f] as usize;
    let edge = |[a, b]: &[u32; 2]| [vertex(a).min(vertex(b)), vertex(a).max(vertex(b))];
    let element = |element: &Element| match element {
        Element::Vertex(v) => Element::Vertex(vertex(v)),
        Element::Vertices(group) => {
            let group: BTreeSet<u32> = group.iter().map(vertex).collect();
            Element::Vertices(group.into_iter().collect())
        }
        Element::Edge(e) => Element::Edge(edge(e)),
        Element::VertexInEdge(v, e) => Element::VertexInEdge(vertex(v), edge(e)),
        Element::Face(f) => Element::Face(face(f)),
        Element::Faces(group) => {
            let group: BTreeSet<usize> = group.iter().map(face).collect();
            Element::Faces(group.into_iter().collect())
        }
        Element::Mesh | Element::Record(_) => element.clone(),
    };
    report.defects.iter().map(|(category, found)| (*category, found.plain().iter().map(element).collect())).collect()
}

fn same(n: usize) -> Numbers {
    (0..n as u32).collect()
}

/// A number for each of n that sorting by keys gives; the keys begin again where they end.
fn shuffled(n: usize, keys: &[u32]) -> Numbers {
    let mut order = same(n);
    order.sort_by_key(|&i| keys[i as usize % keys.len()]);
    order
}

fn assert_independent_of_order(mesh: &Polygons, vertices: &Numbers, faces: &Numbers) {
    let other = renumbered(mesh, vertices, faces);
    let (before, after) = (check(mesh, |_| {}), check(&other, |_| {}));
    let (same_vertices, same_faces) = (same(vertices.len()), same(faces.len()));
    assert_eq!(defects(&before, vertices, faces), defects(&after, &same_vertices, &same_faces), "{mesh:?} {other:?}");
    let numbers = |report: Report| (report.counts, report.components, report.area, report.all_junctions);
    assert_eq!(numbers(before), numbers(after), "{mesh:?} {other:?}");
}

/// Whether or not the check gives the vertices and faces other numbers, the report is the same, in its lists too.
fn assert_as_in_order(mesh: &Polygons) {
    let in_order = check_in_order(mesh, |_| {});
    let renumbered = Renumbered::in_space(mesh);
    assert_eq!(renumbered.in_old_numbers(check_in_order(renumbered.mesh(), |_| {})), in_order, "{mesh:?}");
    assert_eq!(check(mesh, |_| {}), in_order, "{mesh:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_shuffled_mesh_has_the_same_report_up_to_renumbering(
        mesh in prop_oneof![grid(), soup()],
        keys in prop::collection::vec(any::<u32>(), 100),
    ) {
        let (vertices, faces) = (shuffled(mesh.vertices().len(), &keys), shuffled(mesh.faces(), &keys[1..]));
        assert_independent_of_order(&mesh, &vertices, &faces);
    }

    #[test]
    fn new_numbers_change_no_report(mesh in prop_oneof![grid(), soup()]) {
        assert_as_in_order(&mesh);
    }

    #[test]
    fn new_numbers_keep_every_loop_and_position(mesh in soup()) {
        let new = Renumbered::in_space(&mesh);
        let loops = |mesh: &Polygons| {
            let at = |&v: &u32| mesh.vertices().get(v as usize).map(|p| p.map(f64::to_bits)).ok_or(v);
            let mut loops: Vec<Vec<_>> = mesh.loops().map(|face| face.iter().map(at).collect()).collect();
            loops.sort();
            loops
        };
        prop_assert_eq!(loops(new.mesh()), loops(&mesh));
        prop_assert_eq!(new.mesh().vertices().len(), mesh.vertices().len());
    }
}

/// A torus of rows of quadrilaterals, some of them in two, gone, turned or twice.
fn torus(n: u32) -> Polygons {
    let at = |i: u32, j: u32| (j % n) * n + i % n;
    let mut faces = Vec::new();
    for v in 0..n * n {
        let (i, j) = (v % n, v / n);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        match v % 1009 {
            0 => faces.extend([vec![a, b, c], vec![a, c, d]]),
            1 => {}
            2 => faces.push(vec![d, c, b, a]),
            3 => faces.extend([vec![a, b, c, d], vec![c, d, a, b]]),
            _ => faces.push(vec![a, b, c, d]),
        }
    }
    let angle = |i: u32| f64::from(i) / f64::from(n) * std::f64::consts::TAU;
    let point = |v: u32| {
        let (u, v) = (angle(v % n), angle(v / n));
        [(3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin()]
    };
    let vertices: Vec<_> = (0..n * n).map(point).collect();
    polygons(&vertices, &faces)
}

/// In no order that is of use, and the same in every run.
fn scattered(n: usize) -> Numbers {
    let keys: Vec<u32> = (0..n as u64).map(|i| mixed(i) as u32).collect();
    shuffled(n, &keys)
}

#[test]
fn meshes_in_an_order_of_space_keep_it_and_shuffled_ones_do_not() {
    let mesh = torus(300);
    let (vertices, faces) = (mesh.vertices().len(), mesh.faces());
    assert!(!is_scattered(&mesh));
    assert!(is_scattered(&renumbered(&mesh, &scattered(vertices), &same(faces))));
    assert!(is_scattered(&renumbered(&mesh, &same(vertices), &scattered(faces))));
    let both = renumbered(&mesh, &scattered(vertices), &scattered(faces));
    assert!(is_scattered(&both));
    assert!(!is_scattered(Renumbered::in_space(&both).mesh()));
}

#[test]
fn a_large_shuffled_mesh_has_the_report_of_the_one_in_rows() {
    let mesh = torus(200);
    let (vertices, faces) = (scattered(mesh.vertices().len()), scattered(mesh.faces()));
    assert!(is_scattered(&renumbered(&mesh, &vertices, &faces)));
    assert_independent_of_order(&mesh, &vertices, &faces);
    assert_as_in_order(&renumbered(&mesh, &vertices, &faces));
}
