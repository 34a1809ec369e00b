//! Winged edges and half-edges: what their records say, against the loops that they are made of.

use super::meshes::{accidents, book, cube_with_tunnel, moebius_strip, octahedron, two_tetrahedra, winged};
use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::mesh::edge_list::{EdgeId, EdgeList, Side};
use isoracle::mesh::examples::{cube, mesh, quad_torus, tetrahedron};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::operations::Operations;
use isoracle::mesh::printed::{HouseReading, house, house_with_edges};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::mesh::winged_edge::{WingError, WingedEdges};
use isoracle::number::Rational;
use isoracle::partition::Partition;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn wings(list: &VertexList) -> WingedEdges {
    WingedEdges::try_from(list).expect("winged edges can hold it")
}

/// The corners of a mesh: a face comes in from a vertex, to a vertex, and goes out to a vertex.
fn corners(list: &VertexList) -> Vec<(usize, [u32; 3])> {
    let mut corners = Vec::new();
    for (number, face) in list.faces.iter().enumerate() {
        for l in face.loops() {
            corners.extend((0..l.len()).map(|i| (number, [l[i], l[(i + 1) % l.len()], l[(i + 2) % l.len()]])));
        }
    }
    corners
}

mod me_28 {
    use super::*;

    /// The other edges with an end in common, and those that the record names.
    fn neighbours(mesh: &WingedEdges, id: EdgeId) -> [BTreeSet<EdgeId>; 2] {
        let edge = &mesh.edges()[id.0 as usize];
        let at = |v: u32| mesh.edges_at(&v).expect("it is there").answer;
        let mut meeting: BTreeSet<EdgeId> = edge.ends.into_iter().flat_map(at).collect();
        meeting.remove(&id);
        let wings = edge.wings.iter().flatten().flat_map(|wing| [wing.previous, wing.next]);
        [meeting, wings.filter(|other| *other != id).collect()]
    }

    #[test]
    fn the_record_names_four_edges_though_more_meet_at_the_ends() {
        for (list, all, named) in
            [(tetrahedron(), 4, 4), (cube(), 4, 4), (octahedron(), 6, 4), (quad_torus(3, 4), 6, 4)]
        {
            let mesh = wings(&list);
            for number in 0..mesh.edges().len() as u32 {
                let [meeting, wings] = neighbours(&mesh, EdgeId(number));
                assert_eq!([meeting.len(), wings.len()], [all, named]);
                assert!(wings.is_subset(&meeting));
            }
        }
    }

    #[test]
    fn wings_are_the_sides_before_and_after_in_the_loops() {
        for (name, list) in winged() {
            let mesh = wings(&list);
            let mut slots = 0;
            for (face, [a, b, c]) in corners(&list) {
                let id =
                    |ends: [u32; 2]| mesh.edges().iter().position(|e| edge(e.ends) == edge(ends)).expect("an edge");
                let wing = |ends: [u32; 2]| {
                    let record = &mesh.edges()[id(ends)];
                    record.wings[usize::from(record.ends != ends)].expect("a loop runs along it")
                };
                assert_eq!((wing([a, b]).face, wing([a, b]).next.0 as usize), (face, id([b, c])), "{name}");
                assert_eq!((wing([b, c]).face, wing([b, c]).previous.0 as usize), (face, id([a, b])), "{name}");
                slots += 1;
            }
            assert_eq!(mesh.edges().iter().flat_map(|e| e.wings).flatten().count(), slots, "{name}");
        }
    }

    #[test]
    fn the_next_side_is_found_by_the_wing() {
        for (name, list) in winged() {
            let mesh = wings(&list);
            for l in mesh.faces().iter().flat_map(|polygon| polygon.loops()) {
                for (i, side) in l.iter().enumerate() {
                    assert_eq!(mesh.next(*side), Some(l[(i + 1) % l.len()]), "{name}");
                }
            }
        }
    }
}

mod me_29 {
    use super::*;

    #[test]
    fn three_polygons_on_an_edge_are_refused_and_the_edge_named() {
        let refused = WingError::Uses { edge: EdgeId(0), ends: [0, 1], uses: [3, 0] };
        assert_eq!(WingedEdges::try_from(&EdgeList::try_from(&book(3)).expect("sound")), Err(refused));
        // The vertex list and the edge list hold them.
        assert_eq!(book(3).faces_of_edge(&[0, 1]).expect("an edge").answer, [0, 1, 2]);
    }

    #[test]
    fn four_too_though_a_polyhedron_may_have_them() {
        let refused = WingError::Uses { edge: EdgeId(2), ends: [2, 3], uses: [2, 2] };
        assert_eq!(WingedEdges::try_from(&EdgeList::try_from(&house()).expect("sound")), Err(refused));
        for reading in [HouseReading::FrontAndBack, HouseReading::WallsAndRoof] {
            assert!(WingedEdges::try_from(&house_with_edges(reading)).is_ok());
        }
    }

    #[test]
    fn two_are_named_in_the_record_and_never_more() {
        for (name, list) in winged() {
            let mesh = wings(&list);
            for (number, record) in (0..).zip(mesh.edges()) {
                let [a, b] = record.ends;
                let users = list.faces.iter().filter(|f| f.sides().any(|s| s == [a, b] || s == [b, a])).count();
                let faces = mesh.faces_of_edge(&EdgeId(number)).expect("it is there").answer;
                assert!(faces.len() == users && users <= 2, "{name}");
            }
        }
    }
}

mod me_30 {
    use super::*;

    #[test]
    fn the_edges_at_a_vertex_of_a_convex_solid_are_clockwise_seen_from_outside() {
        for list in [cube(), tetrahedron(), octahedron()] {
            let n = Rational::from(list.vertices.len());
            let sum = list.vertices.iter().fold(Vector::zero(), |sum, p| sum + p);
            let centre = sum.scaled(&n.recip());
            let mesh = wings(&list);
            for (number, vertex) in (0u32..).zip(mesh.vertices()) {
                let [fan] = &vertex.fans[..] else { panic!("one fan at each vertex") };
                let out = |edge: &EdgeId| {
                    let [a, b] = mesh.edges()[edge.0 as usize].ends;
                    list.vertices[if a == number { b } else { a } as usize].clone() - &vertex.position
                };
                for (i, edge) in fan.iter().enumerate() {
                    let (p, q) = (out(edge), out(&fan[(i + 1) % fan.len()]));
                    let outward = vertex.position.clone() - &centre;
                    assert!(determinant3(&Matrix([p.0, q.0, outward.0])) < 0);
                }
            }
        }
    }

    #[test]
    fn neighbours_in_a_fan_have_a_corner_between_them() {
        for (name, list) in winged() {
            check(name, &list);
        }
    }

    /// Fans are all the corners, each once, and all the edges, each once.
    fn check(name: &str, list: &VertexList) {
        let mesh = wings(list);
        let mut between: Vec<(u32, [u32; 2])> = Vec::new();
        for (v, vertex) in (0u32..).zip(mesh.vertices()) {
            let other = |edge: &EdgeId| {
                let [a, b] = mesh.edges()[edge.0 as usize].ends;
                assert!(a == v || b == v, "{name}");
                a + b - v
            };
            for fan in &vertex.fans {
                // Clockwise: a loop comes in along an edge, and goes out along the next one.
                between.extend(fan.windows(2).map(|pair| (v, [other(&pair[0]), other(&pair[1])])));
                let comes_in = mesh.edges()[fan[fan.len() - 1].0 as usize];
                if comes_in.wings[usize::from(comes_in.ends[1] != v)].is_some() {
                    between.push((v, [other(&fan[fan.len() - 1]), other(&fan[0])]));
                    assert_eq!(fan.iter().min(), fan.first(), "{name}: it closes and begins with its least edge");
                }
            }
            let mut edges: Vec<EdgeId> = vertex.fans.concat();
            edges.sort();
            let truth = (0..mesh.edges().len() as u32).map(EdgeId);
            let truth: Vec<EdgeId> = truth.filter(|e| mesh.edges()[e.0 as usize].ends.contains(&v)).collect();
            assert_eq!(edges, truth, "{name}");
        }
        let mut truth: Vec<(u32, [u32; 2])> = corners(list).iter().map(|(_, [a, b, c])| (*b, [*a, *c])).collect();
        truth.sort();
        between.sort();
        assert_eq!(between, truth, "{name}");
    }

    #[test]
    fn without_orientation_there_is_no_order() {
        // Each triangle as it is or turned over: no choice gives the Möbius strip's edges opposite directions.
        for choice in 0..32 {
            let mut strip = moebius_strip();
            for (i, face) in strip.faces.iter_mut().enumerate().filter(|(i, _)| choice >> i & 1 == 1) {
                assert!(i < 5);
                *face = face.reversed();
            }
            let error = WingedEdges::try_from(&EdgeList::try_from(&strip).expect("sound")).expect_err("one-sided");
            assert!(matches!(error, WingError::Uses { uses: [2, 0] | [0, 2], .. }), "{error}");
        }
    }

    proptest! {
        #[test]
        fn fans_are_sound_whatever_happens_to_a_mesh(list in accidents()) {
            check("accidents", &list);
        }
    }
}

mod me_43 {
    use super::*;

    fn check(name: &str, list: &VertexList) {
        let mesh = HalfEdges::try_from(list).expect(name);
        let all = || (0..mesh.half_edges().len() as u32).map(|e| EdgeId(e).forward()).flat_map(|s| [s, s.reversed()]);
        for side in all() {
            let half = mesh.half_edge(side);
            assert_eq!(mesh.half_edge(half.next).previous, side, "{name}");
            assert_eq!(mesh.half_edge(half.previous).next, side, "{name}");
            assert_eq!(mesh.half_edge(half.next).face, half.face, "{name}");
            assert_eq!(mesh.half_edge(half.next).origin, mesh.half_edge(side.reversed()).origin, "{name}");
        }
        let mut open: Vec<Side> = all().filter(|side| mesh.half_edge(*side).face.is_none()).collect();
        open.sort();
        let mut walked = mesh.boundary_loops().concat();
        walked.sort();
        assert_eq!(walked, open, "{name}");
        let wings = wings(list);
        for (vertex, winged) in mesh.vertices().iter().zip(wings.vertices()) {
            let fans = vertex.fans.iter().map(|first| mesh.fan_of(*first).iter().map(|s| s.edge).collect());
            assert_eq!(fans.collect::<Vec<Vec<EdgeId>>>(), winged.fans, "{name}");
        }
    }

    #[test]
    fn half_edges_are_closed_under_their_own_references() {
        for (name, list) in winged() {
            check(name, &list);
        }
    }

    #[test]
    fn boundary_loops_are_those_of_the_surface_with_its_fans_apart() {
        let lengths = |list: &VertexList| {
            let mesh = HalfEdges::try_from(list).expect("it can be held");
            mesh.boundary_loops().iter().map(Vec::len).collect::<Vec<usize>>()
        };
        let without = |mut list: VertexList, faces: &[usize]| {
            faces.iter().for_each(|face| drop(list.faces.remove(*face)));
            list
        };
        let pair = mesh(&super::super::meshes::positions(5), &[[0, 1, 2], [0, 3, 4]]);
        assert_eq!(lengths(&cube()), [0usize; 0]);
        assert_eq!(lengths(&without(cube(), &[0])), [4]);
        assert_eq!(lengths(&without(cube(), &[1, 0])), [4, 4]);
        assert_eq!(lengths(&without(cube(), &[2, 0])), [6]);
        assert_eq!(lengths(&pair), [3, 3]);
        // Two faces that meet at one vertex away: two loops, since the other fans are apart.
        assert_eq!(lengths(&without(octahedron(), &[6, 0])), [3, 3]);
        // A face with a hole away: its two loops.
        assert_eq!(lengths(&without(cube_with_tunnel(), &[0])), [4, 4]);
        assert_eq!(lengths(&without(mesh(&super::super::meshes::positions(3), &[[0, 1, 2]]), &[])), [3]);
    }

    #[test]
    fn an_edge_without_polygon_is_walked_along_both_ways() {
        let ends = vec![[0, 1], [1, 2], [2, 0], [2, 3]];
        let list = mesh(&super::super::meshes::positions(4), &[[0, 1, 2]]);
        let triangle = EdgeList::try_from(&list).expect("sound").faces().to_vec();
        let list = EdgeList::new(list.vertices, ends, triangle).expect("sound");
        let wings = WingedEdges::try_from(&list).expect("it can be held");
        let mesh = HalfEdges::from(&wings);
        assert_eq!(mesh.boundary_loops().iter().map(Vec::len).collect::<Vec<_>>(), [3, 2]);
        // It is used by no polygon, so it is none of the edges used once.
        let once = [list.boundary_edges(), wings.boundary_edges(), mesh.boundary_edges()];
        assert!(once.into_iter().all(|edges| edges.expect("sound").answer == [0, 1, 2].map(EdgeId)));
        assert_eq!(WingedEdges::from(&mesh), wings);
        assert_eq!(EdgeList::from(&mesh), list);
    }

    proptest! {
        #[test]
        fn half_edges_are_sound_whatever_happens_to_a_mesh(list in accidents()) {
            check("accidents", &list);
        }
    }
}

mod me_38 {
    use super::*;

    /// Whether the normals by the right-hand rule point away from the centre of the cube, face by face.
    fn outward(list: &VertexList) -> Vec<bool> {
        let at = |v: u32| list.vertices[v as usize].clone();
        let twice = |p: Vector<Rational, 3>| p.scaled(&Rational::from(2));
        let normal = |face: &Face| {
            let [a, b, c] = [0, 1, 2].map(|i| at(face.outer[i]));
            (b.clone() - &a).cross(&(c - &a)).dot(&(twice(a) - &Vector([1, 1, 1].map(Rational::from))))
        };
        list.faces.iter().map(|face| normal(face) > 0).collect()
    }

    #[test]
    fn clockwise_faces_point_inward_by_the_right_hand_rule() {
        let counterclockwise = cube();
        let mut clockwise = cube();
        clockwise.faces.iter_mut().for_each(|face| *face = face.reversed());
        assert_eq!(outward(&counterclockwise), [true; 6]);
        assert_eq!(outward(&clockwise), [false; 6]);
    }

    #[test]
    fn turning_all_faces_over_turns_every_wing_over() {
        for (name, list) in winged() {
            let mut turned = list.clone();
            turned.faces.iter_mut().for_each(|face| *face = face.reversed());
            let [a, b] = [&list, &turned].map(wings);
            let named = |mesh: &WingedEdges, id: EdgeId| edge(mesh.edges()[id.0 as usize].ends);
            let slots = |mesh: &WingedEdges, turn: bool| {
                let mut slots = BTreeSet::new();
                for record in mesh.edges() {
                    let [x, y] = record.ends;
                    for (ends, wing) in [[x, y], [y, x]].into_iter().zip(record.wings) {
                        let ends = if turn { [ends[1], ends[0]] } else { ends };
                        let beside = wing.map(|w| [named(mesh, w.previous), named(mesh, w.next)]);
                        let beside = beside.map(|[p, n]| if turn { [n, p] } else { [p, n] });
                        slots.insert((ends, wing.map(|w| w.face), beside));
                    }
                }
                slots
            };
            assert_eq!(slots(&a, false), slots(&b, true), "{name}");
        }
    }
}

mod me_44 {
    use super::*;

    /// How many parts the corners at a vertex make, joined where they have a side in common.
    fn parts(list: &VertexList, v: u32) -> usize {
        let at: Vec<[u32; 3]> = corners(list).into_iter().map(|(_, c)| c).filter(|[_, b, _]| *b == v).collect();
        let mut parts = Partition::new(at.len());
        let mut count = at.len();
        for i in 0..at.len() {
            for j in 0..i {
                let share = [at[i][0], at[i][2]].iter().any(|x| [at[j][0], at[j][2]].contains(x));
                count -= usize::from(share && parts.join(i, j));
            }
        }
        count
    }

    #[test]
    fn a_vertex_has_a_fan_for_each_part_of_its_surroundings() {
        for (name, list) in winged() {
            for (v, vertex) in (0u32..).zip(wings(&list).vertices()) {
                assert_eq!(vertex.fans.len(), parts(&list, v), "{name}");
            }
        }
    }

    #[test]
    fn two_tetrahedra_with_a_common_vertex_are_held() {
        let mesh = wings(&two_tetrahedra());
        let sizes: Vec<Vec<usize>> = mesh.vertices().iter().map(|v| v.fans.iter().map(Vec::len).collect()).collect();
        assert_eq!(sizes, [vec![3, 3], vec![3], vec![3], vec![3], vec![3], vec![3], vec![3]]);
        assert_eq!(mesh.faces_at(&0).expect("vertex 0").answer, [0, 1, 3, 4, 5, 7]);
    }

    proptest! {
        #[test]
        fn fans_are_counted_whatever_happens_to_a_mesh(list in accidents()) {
            for (v, vertex) in (0u32..).zip(wings(&list).vertices()) {
                prop_assert_eq!(vertex.fans.len(), parts(&list, v));
            }
        }
    }
}

#[test]
fn the_examples_have_holes_and_boundaries_and_common_vertices() {
    let names: Vec<&str> = winged().into_iter().map(|(name, _)| name).collect();
    for name in ["open tunnel", "very open cube", "two tetrahedra", "cube with spur", "hollow triangle"] {
        assert!(names.contains(&name), "{name}");
    }
    assert!(winged().iter().any(|(_, list)| list.faces.iter().any(|face: &Face| !face.holes.is_empty())));
}
