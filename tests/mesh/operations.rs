//! The operations give equal answers on all structures: those of the definition.

use super::meshes::{accidents, is_long, loops, named, positions, soup, triangle_sets};
use isoracle::mesh::edge_list::{EdgeId, EdgeList};
use isoracle::mesh::examples::{cube, mesh, point, tetrahedron};
use isoracle::mesh::explicit::{ExplicitList, Polygon};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::operations::{Counted, NoSuch, Operations};
use isoracle::mesh::printed::{HouseReading, house_with_edges};
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::mesh::winged_edge::WingedEdges;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

type Numbers = Vec<usize>;

/// All that the operations say of a mesh, by vertex numbers.
#[derive(Debug, PartialEq, Eq)]
struct Answers {
    polygons: Vec<Polygon<Point>>,
    segments: Vec<[Point; 2]>,
    edges_at: BTreeMap<u32, Vec<[u32; 2]>>,
    faces_of: BTreeMap<[u32; 2], Numbers>,
    faces_at: BTreeMap<u32, Numbers>,
    adjacent: Vec<Numbers>,
    boundary: Vec<[u32; 2]>,
    unused: Vec<u32>,
}

pub fn of<T>(counted: Result<Counted<T>, NoSuch>) -> T {
    counted.expect("the names are those of the mesh").answer
}

pub fn sorted<T: Ord>(things: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut sorted: Vec<T> = things.into_iter().collect();
    sorted.sort();
    sorted
}

fn answers<M: Operations>(mesh: &M, vertices: &[(u32, M::Vertex)], faces: usize) -> Answers {
    let number = |v: &M::Vertex| vertices.iter().find(|(_, name)| name == v).expect("a vertex of the mesh").0;
    let ends = |e: &M::Edge| edge(of(mesh.ends(e)).each_ref().map(number));
    let edges: BTreeSet<M::Edge> = vertices.iter().flat_map(|(_, v)| of(mesh.edges_at(v))).collect();
    Answers {
        polygons: of(mesh.polygons()),
        segments: sorted(of(mesh.segments()).into_iter().map(sorted).map(|s| [s[0].clone(), s[1].clone()])),
        edges_at: vertices.iter().map(|(n, v)| (*n, sorted(of(mesh.edges_at(v)).iter().map(ends)))).collect(),
        faces_of: edges.iter().map(|e| (ends(e), of(mesh.faces_of_edge(e)))).collect(),
        faces_at: vertices.iter().map(|(n, v)| (*n, of(mesh.faces_at(v)))).collect(),
        adjacent: (0..faces).map(|face| of(mesh.adjacent_faces(face))).collect(),
        boundary: sorted(of(mesh.boundary_edges()).iter().map(ends)),
        unused: of(mesh.unused_vertices()).iter().map(number).collect(),
    }
}

/// The answers by their definitions, from the sides that every face has.
fn truth(list: &VertexList) -> Answers {
    let n = list.vertices.len() as u32;
    let runs = |face: &Face, [a, b]: [u32; 2]| face.sides().filter(|s| *s == [a, b] || *s == [b, a]).count();
    let users =
        |ends: [u32; 2]| -> Numbers { (0..list.faces.len()).filter(|f| runs(&list.faces[*f], ends) > 0).collect() };
    let pairs = || (0..n).flat_map(|a| (a + 1..n).map(move |b| [a, b]));
    let edges: Vec<[u32; 2]> = pairs().filter(|ends| !users(*ends).is_empty()).collect();
    let place = |v: &u32| list.vertices[*v as usize].clone();
    let faces_at =
        |v: u32| (0..list.faces.len()).filter(|f| list.faces[*f].vertices().any(|w| w == v)).collect::<Numbers>();
    let beside = |f: usize, g: usize| f != g && edges.iter().any(|e| users(*e).contains(&f) && users(*e).contains(&g));
    Answers {
        polygons: list
            .faces
            .iter()
            .map(|face| Polygon { outer: face.outer.clone(), holes: face.holes.clone() }.map(place))
            .collect(),
        segments: sorted(edges.iter().map(|[a, b]| sorted([place(a), place(b)])).map(|s| [s[0].clone(), s[1].clone()])),
        edges_at: (0..n).map(|v| (v, edges.iter().copied().filter(|e| e.contains(&v)).collect())).collect(),
        faces_of: edges.iter().map(|e| (*e, users(*e))).collect(),
        faces_at: (0..n).map(|v| (v, faces_at(v))).collect(),
        adjacent: (0..list.faces.len()).map(|f| (0..list.faces.len()).filter(|g| beside(f, *g)).collect()).collect(),
        boundary: edges
            .iter()
            .copied()
            .filter(|e| list.faces.iter().map(|f| runs(f, *e)).sum::<usize>() == 1)
            .collect(),
        unused: (0..n).filter(|v| faces_at(*v).is_empty()).collect(),
    }
}

/// Compares all structures that can hold the mesh; says whether winged edges can.
fn compare(list: &VertexList) -> bool {
    let truth = truth(list);
    let faces = list.faces.len();
    let numbers: Vec<(u32, u32)> = (0..list.vertices.len() as u32).map(|v| (v, v)).collect();
    assert_eq!(answers(list, &numbers, faces), truth, "vertex list");
    assert_eq!(answers(&EdgeList::try_from(list).expect("sound"), &numbers, faces), truth, "edge list");
    let explicit = ExplicitList::try_from(list).expect("sound");
    let used = (0..).zip(list.vertices.iter().cloned()).filter(|(v, _)| !truth.unused.contains(v));
    let of_explicit = answers(&explicit, &used.collect::<Vec<_>>(), faces);
    let without_unused = |mut answers: Answers| {
        answers.edges_at.retain(|v, _| !truth.unused.contains(v));
        answers.faces_at.retain(|v, _| !truth.unused.contains(v));
        Answers { unused: Vec::new(), ..answers }
    };
    assert_eq!(of_explicit, without_unused(super::operations::truth(list)), "explicit list");
    let Ok(wings) = WingedEdges::try_from(list) else { return false };
    assert_eq!(answers(&wings, &numbers, faces), truth, "winged edges");
    assert_eq!(answers(&HalfEdges::from(&wings), &numbers, faces), truth, "half-edges");
    true
}

mod me_1 {
    use super::*;

    #[test]
    fn all_structures_give_the_answers_of_the_definition() {
        for (name, list) in named() {
            println!("{name}");
            compare(&list);
        }
    }

    #[test]
    fn on_all_small_meshes_too() {
        let all = loops(3, 4);
        let step = if is_long() { 1 } else { 17 };
        let pairs = (0..all.len() * all.len()).step_by(step).map(|i| [&all[i / all.len()], &all[i % all.len()]]);
        let held = pairs.filter(|loops| compare(&mesh(&positions(3), &loops[..]))).count();
        let sets = triangle_sets().step_by(if is_long() { 61 } else { 1 });
        assert!(held + sets.filter(compare).count() > 30);
    }

    #[test]
    fn edges_with_the_same_ends_are_told_apart_where_edges_are_numbered() {
        for (reading, a3) in [(HouseReading::FrontAndBack, [0, 1]), (HouseReading::WallsAndRoof, [0, 2])] {
            let list = house_with_edges(reading);
            let wings = WingedEdges::try_from(&list).expect("no edge is used twice in one direction");
            let halves = HalfEdges::from(&wings);
            assert_eq!(of(list.faces_of_edge(&EdgeId(2))), a3);
            for edge in (0..8).map(EdgeId) {
                let answers =
                    [list.faces_of_edge(&edge), wings.faces_of_edge(&edge), halves.faces_of_edge(&edge)].map(of);
                assert!(answers[0] == answers[1] && answers[1] == answers[2]);
            }
            for vertex in 0..6 {
                let answers = [list.edges_at(&vertex), wings.edges_at(&vertex), halves.edges_at(&vertex)].map(of);
                assert!(answers[0] == answers[1] && answers[1] == answers[2]);
            }
            for face in 0..4 {
                let answers =
                    [list.adjacent_faces(face), wings.adjacent_faces(face), halves.adjacent_faces(face)].map(of);
                assert!(answers[0] == answers[1] && answers[1] == answers[2]);
            }
        }
    }

    fn refuses<M: Operations>(mesh: &mut M, vertex: &M::Vertex, edge: &M::Edge) {
        assert_eq!(mesh.edges_at(vertex).map(drop), Err(NoSuch::Vertex));
        assert_eq!(mesh.faces_at(vertex).map(drop), Err(NoSuch::Vertex));
        assert_eq!(mesh.move_vertex(vertex, point([0, 0, 0])).map(drop), Err(NoSuch::Vertex));
        assert_eq!(mesh.faces_of_edge(edge).map(drop), Err(NoSuch::Edge));
        assert_eq!(mesh.adjacent_faces(6).map(drop), Err(NoSuch::Face));
    }

    #[test]
    fn names_that_the_mesh_does_not_have_are_refused() {
        let missing = point([5, 5, 5]);
        let mut explicit = ExplicitList::try_from(&cube()).expect("sound");
        refuses(&mut explicit, &missing, &[missing.clone(), point([0, 0, 0])]);
        refuses(&mut cube(), &8, &[0, 6]);
        refuses(&mut EdgeList::try_from(&cube()).expect("sound"), &8, &EdgeId(12));
        refuses(&mut WingedEdges::try_from(&cube()).expect("sound"), &8, &EdgeId(12));
        refuses(&mut HalfEdges::try_from(&cube()).expect("sound"), &8, &EdgeId(12));
        assert_eq!(explicit, ExplicitList::try_from(&cube()).expect("sound"));
    }

    #[test]
    fn a_side_from_a_vertex_to_itself_is_no_edge() {
        let list = mesh(&positions(3), &[[0, 0, 1]]);
        let explicit = ExplicitList::try_from(&list).expect("sound");
        let edges = EdgeList::try_from(&list).expect("sound");
        assert_eq!(list.faces_of_edge(&[0, 0]).map(drop), Err(NoSuch::Edge));
        let place = list.vertices[0].clone();
        assert_eq!(explicit.faces_of_edge(&[place.clone(), place]).map(drop), Err(NoSuch::Edge));
        assert_eq!(edges.edges()[0].ends, [0, 0]);
        assert_eq!(edges.faces_of_edge(&EdgeId(0)).map(drop), Err(NoSuch::Edge));
        assert_eq!(edges.ends(&EdgeId(0)).map(drop), Err(NoSuch::Edge));
        assert_eq!(of(edges.faces_of_edge(&EdgeId(1))), [0]);
    }

    #[test]
    fn a_vertex_list_that_names_a_missing_vertex_is_refused_by_what_comes_upon_it() {
        let mut broken = cube();
        broken.faces[5].outer[1] = 8;
        assert_eq!(broken.polygons().map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.segments().map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.edges_at(&0).map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.faces_at(&0).map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.faces_of_edge(&[0, 1]).map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.boundary_edges().map(drop), Err(NoSuch::Vertex));
        assert_eq!(broken.unused_vertices().map(drop), Err(NoSuch::Vertex));
    }

    proptest! {
        #[test]
        fn on_any_faces_too(list in soup()) {
            compare(&list);
        }

        #[test]
        fn on_any_mesh_that_winged_edges_hold(list in accidents()) {
            prop_assume!(list.vertices.iter().collect::<BTreeSet<_>>().len() == list.vertices.len());
            prop_assert!(compare(&list));
        }

        #[test]
        fn moving_is_the_same_on_all(list in accidents(), choice in any::<u32>(), to in prop::array::uniform3(20..30i64)) {
            let unused = of(list.unused_vertices());
            let vertex = choice % list.vertices.len() as u32;
            prop_assume!(!unused.contains(&vertex));
            prop_assume!(list.vertices.iter().collect::<BTreeSet<_>>().len() == list.vertices.len());
            let mut moved = list.clone();
            of(moved.move_vertex(&vertex, point(to)));
            let mut edges = EdgeList::try_from(&list).expect("sound");
            of(edges.move_vertex(&vertex, point(to)));
            prop_assert_eq!(VertexList::from(&edges), moved.clone());
            let mut wings = WingedEdges::try_from(&list).expect("sound");
            let mut halves = HalfEdges::from(&wings);
            of(wings.move_vertex(&vertex, point(to)));
            prop_assert_eq!(VertexList::from(&wings), moved.clone());
            of(halves.move_vertex(&vertex, point(to)));
            prop_assert_eq!(VertexList::from(&halves), moved.clone());
            let mut explicit = ExplicitList::try_from(&list).expect("sound");
            of(explicit.move_vertex(&list.vertices[vertex as usize], point(to)));
            prop_assert_eq!(explicit, ExplicitList::try_from(&moved).expect("sound"));
        }
    }
}

mod me_2 {
    use super::*;

    #[test]
    fn edges_are_drawn_from_the_wire_frame() {
        for (name, list) in named() {
            let list = EdgeList::try_from(&list).expect(name);
            assert_eq!(list.wire_frame().segments(), list.segments(), "{name}");
            assert!(
                list.wire_frame().faces().is_empty() && list.wire_frame().edges().iter().all(|e| e.faces.is_empty())
            );
        }
    }
}

mod me_45 {
    use super::*;

    #[test]
    fn a_vertex_moved_onto_another_is_one_with_it_from_then_on() {
        let mut explicit = ExplicitList::try_from(&tetrahedron()).expect("sound");
        let [from, onto, away] = [point([0, 0, 0]), point([1, 0, 0]), point([0, 0, 0])];
        of(explicit.move_vertex(&from, onto.clone()));
        of(explicit.move_vertex(&onto, away.clone()));
        assert_eq!(explicit.copies(&away), 6);
        assert_eq!(of(explicit.segments()).len(), 3);
        let mut list = tetrahedron();
        of(list.move_vertex(&0, onto));
        of(list.move_vertex(&0, away));
        assert_eq!(list, tetrahedron());
    }
}
