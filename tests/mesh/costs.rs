//! What the operations read and the structures store, as the text compares them.

use super::meshes::{book, closed_manifolds, cube_with_spur, cube_with_tunnel, named, octahedron, positions};
use super::operations::{of, sorted};
use isoracle::linear::Vector;
use isoracle::mesh::edge_list::{EdgeId, EdgeList};
use isoracle::mesh::examples::{cube, mesh, point, quad_torus};
use isoracle::mesh::explicit::{ExplicitList, Polygon};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::operations::{Counted, NoSuch, Operations};
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::mesh::winged_edge::WingedEdges;
use isoracle::number::Rational;
use std::collections::BTreeSet;

/// The table in `mesh::operations`.
mod table {
    use super::*;

    /// For each operation: the number of reads of all its questions together.
    fn reads<M: Operations>(mesh: &mut M, vertices: &[M::Vertex], faces: usize) -> [u64; 10] {
        let edges: BTreeSet<M::Edge> = vertices.iter().flat_map(|v| of(mesh.edges_at(v))).collect();
        let count = |reads: Result<u64, NoSuch>| reads.expect("the names are those of the mesh");
        [
            count(mesh.polygons().map(|c| c.reads)),
            count(mesh.segments().map(|c| c.reads)),
            vertices.iter().map(|v| count(mesh.edges_at(v).map(|c| c.reads))).sum(),
            edges.iter().map(|e| count(mesh.ends(e).map(|c| c.reads))).sum(),
            edges.iter().map(|e| count(mesh.faces_of_edge(e).map(|c| c.reads))).sum(),
            vertices.iter().map(|v| count(mesh.faces_at(v).map(|c| c.reads))).sum(),
            (0..faces).map(|face| count(mesh.adjacent_faces(face).map(|c| c.reads))).sum(),
            count(mesh.move_vertex(&vertices[0].clone(), point([50, 0, 0])).map(|c| c.reads)),
            count(mesh.boundary_edges().map(|c| c.reads)),
            count(mesh.unused_vertices().map(|c| c.reads)),
        ]
    }

    fn table(list: &VertexList) -> [[u64; 10]; 5] {
        let numbers: Vec<u32> = (0..list.vertices.len() as u32).collect();
        let faces = list.faces.len();
        let mut wings = WingedEdges::try_from(list).expect("sound");
        let mut halves = HalfEdges::from(&wings);
        [
            reads(&mut ExplicitList::try_from(list).expect("sound"), &list.vertices, faces),
            reads(&mut list.clone(), &numbers, faces),
            reads(&mut EdgeList::try_from(list).expect("sound"), &numbers, faces),
            reads(&mut wings, &numbers, faces),
            reads(&mut halves, &numbers, faces),
        ]
    }

    #[test]
    fn on_closed_manifolds_the_table_is_exact() {
        let mut seen = 0;
        for (name, list) in closed_manifolds() {
            let s: u64 = list.faces.iter().map(|face| face.vertices().count() as u64).sum();
            let (v, e, f) = (list.vertices.len() as u64, s / 2, list.faces.len() as u64);
            let l: u64 = list.faces.iter().map(|face| face.loops().count() as u64).sum();
            let wings = WingedEdges::try_from(&list).expect(name);
            let fans: u64 = wings.vertices().iter().map(|vertex| vertex.fans.len() as u64).sum();
            // Each edge is at two vertices and has two uses: Σd = 2E; Σk is 4E over the edges at all vertices, 2S over those of
            // all polygons.
            let rows = [
                [s, s, v * s, 0, e * s, v * s, s + f * s, s, s, 0],
                [2 * s, s + 2 * e, v * s, 0, e * s, v * s, s + f * s, 1, s, s],
                [3 * s, 3 * e, v * e, e, 3 * e, v * e + 4 * e, 4 * s, 1, e, e],
                [3 * s, 3 * e, v + 2 * e, e, e, v + 4 * e, 2 * s, 1, e, v + 4 * e],
                [2 * s + l, 4 * e, fans + 2 * e, 2 * e, 2 * e, fans + 4 * e, l + 2 * s, 1, 2 * e, fans + 4 * e],
            ];
            assert_eq!(table(&list), rows, "{name}");
            seen += 1;
        }
        assert!(seen > 5);
    }
}

/// Reads of the first vertex, of the first edge, and of the first polygon, by structure.
fn of_first<M: Operations>(mesh: &M, vertex: &M::Vertex) -> [u64; 5] {
    let edge = of(mesh.edges_at(vertex))[0].clone();
    let reads = [
        mesh.edges_at(vertex).map(|c| c.reads),
        mesh.ends(&edge).map(|c| c.reads),
        mesh.faces_of_edge(&edge).map(|c| c.reads),
        mesh.faces_at(vertex).map(|c| c.reads),
        mesh.adjacent_faces(0).map(|c| c.reads),
    ];
    reads.map(|reads| reads.expect("the names are those of the mesh"))
}

mod me_4 {
    use super::*;

    #[test]
    fn a_vertex_is_stored_once_for_each_polygon_that_comes_to_it_once() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            for (v, position) in (0u32..).zip(&list.vertices) {
                let users = list.faces.iter().filter(|face| face.vertices().any(|w| w == v));
                let times: Vec<usize> = users.map(|face| face.vertices().filter(|w| *w == v).count()).collect();
                assert_eq!(explicit.copies(position), times.iter().sum::<usize>(), "{name}");
                if times.iter().all(|n| *n == 1) {
                    assert_eq!(explicit.copies(position), times.len(), "{name}");
                }
            }
            assert_eq!(explicit.words(), 3 * list.corner_count());
        }
    }

    #[test]
    fn and_more_often_where_one_comes_twice() {
        let list = cube_with_spur();
        let explicit = ExplicitList::try_from(&list).expect("sound");
        let printed = of(list.faces_at(&4)).len();
        assert_eq!([printed, explicit.copies(&list.vertices[4])], [3, 4]);
    }
}

mod me_5 {
    use super::*;

    fn strokes(list: &VertexList, ends: [u32; 2]) -> usize {
        let [a, b] = ends.map(|v| &list.vertices[v as usize]);
        let explicit = ExplicitList::try_from(list).expect("sound");
        explicit.strokes().into_iter().filter(|side| *side == [a, b] || *side == [b, a]).count()
    }

    #[test]
    fn an_edge_is_drawn_once_for_each_polygon_that_uses_it_once() {
        for list in [cube(), octahedron(), cube_with_tunnel(), book(3)] {
            for ends in list.strokes() {
                assert_eq!(strokes(&list, ends), of(list.faces_of_edge(&ends)).len());
            }
        }
        assert_eq!(strokes(&book(3), [0, 1]), 3);
    }

    #[test]
    fn and_more_often_where_one_uses_it_twice() {
        // A third polygon on the spur's edge.
        let mut list = cube_with_spur();
        list.faces.push(Face::from([4, 8, 0]));
        let printed = of(list.faces_of_edge(&[4, 8])).len();
        assert_eq!([printed, strokes(&list, [4, 8])], [2, 3]);
    }
}

mod me_6 {
    use super::*;

    #[test]
    fn rescanning_draws_each_edge_once() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            assert_eq!(sorted(explicit.segments_by_rescanning().answer), sorted(of(explicit.segments())), "{name}");
        }
    }

    #[test]
    fn and_reads_up_to_the_edge_that_it_finds() {
        // Sides 01 12 20 21 13 32: the fourth is found as the second, after 2 reads; the others are not found.
        let two = mesh(&positions(4), &[[0, 1, 2], [2, 1, 3]]);
        let explicit = ExplicitList::try_from(&two).expect("sound");
        assert_eq!(explicit.segments_by_rescanning().reads, 6 + (1 + 2 + 2 + 4 + 5));
    }

    #[test]
    fn and_reads_up_to_half_the_square() {
        // Apart, nothing is found: S + S(S − 1)/2. On the torus each edge is found half the time.
        for n in [3, 6, 9] {
            let apart: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let explicit = ExplicitList::try_from(&mesh(&positions(3 * n), &apart)).expect("sound");
            let s = u64::from(3 * n);
            assert_eq!(explicit.segments_by_rescanning().reads, s + s * (s - 1) / 2);
            assert_eq!(explicit.segments().expect("sound").reads, s);
        }
        let reads = [4, 8, 16].map(|n| {
            let torus = ExplicitList::try_from(&quad_torus(n, n)).expect("sound");
            torus.segments_by_rescanning().reads
        });
        assert!(reads[1] > 10 * reads[0] && reads[2] > 10 * reads[1], "{reads:?}: four times the sides");
    }
}

mod me_7 {
    use super::*;

    #[test]
    fn moving_in_the_explicit_list_reads_every_corner_and_writes_every_copy() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            for position in explicit.polygons.iter().flat_map(Polygon::corners) {
                let mut moved = explicit.clone();
                let reads = moved.move_vertex(position, point([70, 0, 0])).expect(name).reads;
                assert_eq!(reads, list.corner_count(), "{name}");
                assert_eq!([moved.copies(position), moved.copies(&point([70, 0, 0]))], [0, explicit.copies(position)]);
            }
        }
    }
}

mod me_8 {
    use super::*;

    #[test]
    fn equal_positions_say_what_is_common() {
        let explicit = ExplicitList::try_from(&cube()).expect("sound");
        let vertices: BTreeSet<&Point> = explicit.polygons.iter().flat_map(Polygon::corners).collect();
        let edges: BTreeSet<[Point; 2]> = vertices.iter().flat_map(|v| of(explicit.edges_at(v))).collect();
        assert_eq!([vertices.len(), edges.len()], [8, 12]);
        assert!(edges.iter().all(|edge| of(explicit.faces_of_edge(edge)).len() == 2));
    }

    #[test]
    fn rounded_positions_lose_it() {
        let third = Rational::from((1, 3));
        let rounded = Rational::from((333, 1000));
        let mut explicit = ExplicitList::try_from(&cube()).expect("sound");
        let corner = explicit.polygons[0].outer[0].clone();
        of(explicit.move_vertex(&corner, Vector([third, Rational::new(), Rational::new()])));
        explicit.polygons[0].outer[0].0[0] = rounded;
        assert_eq!(VertexList::from(&explicit).vertices.len(), 9);
        assert_eq!(of(explicit.boundary_edges()).len(), 4);
    }
}

mod me_13 {
    use super::*;

    #[test]
    fn the_vertex_list_is_shorter_iff_a_vertex_has_more_than_three_halves_of_corners() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            let (s, v) = (list.corner_count(), list.vertices.len() as u64);
            assert_eq!(list.words().cmp(&explicit.words()), (3 * v).cmp(&(2 * s)), "{name}");
        }
    }

    #[test]
    fn as_printed_it_fails_for_one_triangle_and_for_two_on_one_edge() {
        let words = |list: &VertexList| [list.words(), ExplicitList::try_from(list).expect("sound").words()];
        let printed = |list: &VertexList| words(list)[0] < words(list)[1];
        let triangle = mesh(&positions(3), &[[0, 1, 2]]);
        let two = mesh(&positions(4), &[[0, 1, 2], [2, 1, 3]]);
        assert_eq!([words(&triangle), words(&two), words(&cube())], [[12, 9], [18, 18], [48, 72]]);
        assert_eq!([printed(&triangle), printed(&two), printed(&cube())], [false, false, true]);
    }

    #[test]
    fn closed_meshes_without_an_edge_twice_in_a_polygon_have_two_corners_at_each_vertex() {
        for (name, list) in closed_manifolds().into_iter().filter(|(name, _)| *name != "cube with spur") {
            for v in 0..list.vertices.len() as u32 {
                assert!(list.faces.iter().flat_map(Face::vertices).filter(|w| *w == v).count() >= 2, "{name}");
            }
            assert!(list.words() < ExplicitList::try_from(&list).expect(name).words(), "{name}");
        }
        let there_and_back = mesh(&positions(3), &[[0, 1, 0, 2]]);
        assert_eq!(EdgeList::try_from(&there_and_back).expect("sound").uses(), [[1, 1]; 2], "closed");
        let explicit = ExplicitList::try_from(&there_and_back).expect("sound");
        assert_eq!([there_and_back.words(), explicit.words()], [13, 12]);
    }
}

mod me_14 {
    use super::*;

    #[test]
    fn one_record_is_written_however_many_polygons_refer_to_it() {
        for n in 3..9 {
            // A fan of n triangles around vertex 0.
            let faces: Vec<[u32; 3]> = (1..=n).map(|i| [0, i, i % n + 1]).collect();
            let mut list = mesh(&positions(n + 1), &faces);
            let before = list.clone();
            assert_eq!(list.move_vertex(&0, point([-1, 0, 0])).expect("vertex 0").reads, 1);
            assert_eq!(list.faces, before.faces);
            assert_eq!(list.vertices[1..], before.vertices[1..]);
            let moved = of(list.polygons()).iter().filter(|p| p.outer[0] == point([-1, 0, 0])).count();
            assert_eq!(moved, n as usize);
        }
    }
}

mod me_15 {
    use super::*;

    #[test]
    fn the_vertex_list_draws_as_often_as_the_explicit_list() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            let place = |v: u32| &list.vertices[v as usize];
            let by_number = list.strokes().into_iter().map(|ends| sorted(ends.map(place)));
            let by_position = explicit.strokes().into_iter().map(sorted);
            assert_eq!(sorted(by_number), sorted(by_position), "{name}");
        }
        let strokes = cube().strokes();
        assert_eq!([strokes.len(), strokes.into_iter().collect::<BTreeSet<_>>().len()], [24, 12]);
    }
}

mod me_16 {
    use super::*;

    #[test]
    fn every_corner_is_read_for_the_polygons_of_a_vertex_or_edge() {
        for n in [3, 5, 8] {
            let torus = quad_torus(n, n);
            let s = 4 * u64::from(n * n);
            let explicit = ExplicitList::try_from(&torus).expect("sound");
            assert_eq!(of_first(&torus, &7), [s, 0, s, s, 4 + s]);
            assert_eq!(of_first(&explicit, &torus.vertices[7]), [s, 0, s, s, 4 + s]);
        }
    }

    #[test]
    fn since_any_polygon_might_be_one() {
        // What the last polygon refers to changes the answer, and no other record tells.
        let strip = |last: [u32; 3]| mesh(&positions(6), &[[0, 1, 2], [2, 1, 3], last]);
        assert_eq!(of(strip([3, 4, 5]).faces_at(&0)), [0]);
        assert_eq!(of(strip([3, 4, 0]).faces_at(&0)), [0, 2]);
    }
}

mod me_23 {
    use super::*;

    #[test]
    fn no_position_stands_twice_but_every_use_of_an_edge_does() {
        for (name, list) in named() {
            let edges = EdgeList::try_from(&list).expect(name);
            assert_eq!(edges.vertices().iter().collect::<BTreeSet<_>>().len(), edges.vertices().len());
            let s = list.corner_count();
            let (v, e) = (list.vertices.len() as u64, edges.edges().len() as u64);
            assert_eq!(edges.words(), 3 * v + 2 * e + 2 * s, "{name}");
            // The faces of the edges follow from the polygons.
            let mut users = vec![Vec::new(); edges.edges().len()];
            for (face, polygon) in edges.records().faces.iter().enumerate() {
                polygon.corners().for_each(|edge| users[*edge as usize].push(face));
            }
            assert_eq!(edges.edges().iter().map(|edge| edge.faces.clone()).collect::<Vec<_>>(), users, "{name}");
        }
        let words = EdgeList::try_from(&cube()).expect("sound").words();
        assert_eq!([words, ExplicitList::try_from(&cube()).expect("sound").words(), cube().words()], [96, 72, 48]);
    }
}

mod me_24 {
    use super::*;

    #[test]
    fn the_polygons_beside_a_polygon_are_read_off_whatever_the_size_of_the_mesh() {
        for n in [3, 5, 8, 13] {
            let list = EdgeList::try_from(&quad_torus(n, n)).expect("sound");
            let [_, ends, faces_of_edge, _, adjacent] = of_first(&list, &0);
            assert_eq!([ends, faces_of_edge, adjacent], [1, 3, 16]);
        }
        // Any number of polygons on the edge.
        let book = EdgeList::try_from(&book(5)).expect("sound");
        assert_eq!(book.faces_of_edge(&EdgeId(0)), Ok(Counted { answer: vec![0, 1, 2, 3, 4], reads: 6 }));
    }
}

mod me_25 {
    use super::*;

    #[test]
    fn each_edge_is_drawn_once_by_reading_the_edges() {
        for (name, list) in named() {
            let edges = EdgeList::try_from(&list).expect(name);
            let segments = edges.segments().expect("sound");
            let sides: BTreeSet<Vec<Point>> = segments.answer.iter().cloned().map(sorted).collect();
            assert_eq!(sides.len(), segments.answer.len(), "{name}");
            let drawn = list.strokes().into_iter().collect::<BTreeSet<_>>().len() as u64;
            assert_eq!(segments.reads, edges.edges().len() as u64 + 2 * drawn, "{name}");
        }
    }
}

mod me_26 {
    use super::*;

    #[test]
    fn edges_at_a_vertex_are_searched_for_and_so_are_its_polygons() {
        let mut rows = Vec::new();
        for n in [3, 5, 8] {
            let list = EdgeList::try_from(&quad_torus(n, n)).expect("sound");
            let e = 2 * u64::from(n * n);
            let [edges_at, .., faces_at, _] = of_first(&list, &0);
            assert_eq!([edges_at, faces_at], [e, e + 8]);
            rows.push([edges_at, faces_at]);
        }
        // Printed: one operation grows with the mesh. True: two.
        assert!(
            (0..2).all(|operation| rows[0][operation] < rows[1][operation] && rows[1][operation] < rows[2][operation])
        );
        let cube = EdgeList::try_from(&cube()).expect("sound");
        assert_eq!([cube.edges_at(&0).map(|c| c.reads), cube.faces_at(&0).map(|c| c.reads)], [Ok(12), Ok(18)]);
    }

    #[test]
    fn nor_are_a_polygons_vertices_in_its_record() {
        // Two meshes with the same polygon records: only the edges' records tell their vertices.
        let [a, b] = [[0, 1, 2], [3, 4, 5]].map(|t| EdgeList::try_from(&mesh(&positions(6), &[t])).expect("sound"));
        assert_eq!(a.records().faces, b.records().faces);
        assert_ne!(a.polygons().map(|c| c.answer), b.polygons().map(|c| c.answer));
        assert_eq!(a.polygons().map(|c| c.reads), Ok(9));
    }
}

mod me_27 {
    use super::*;

    #[test]
    fn the_other_polygon_of_an_edge_is_immediate_where_the_vertex_list_reads_all() {
        for n in [3, 5, 8, 13] {
            let torus = quad_torus(n, n);
            let wings = WingedEdges::try_from(&torus).expect("sound");
            let s = 4 * u64::from(n * n);
            for (id, record) in (0..).map(EdgeId).zip(wings.edges()) {
                let [a, b] =
                    [wings.faces_of_edge(&id), torus.faces_of_edge(&edge(record.ends))].map(|c| c.expect("an edge"));
                assert_eq!(a.answer, b.answer);
                assert_eq!([a.reads, b.reads], [1, s]);
            }
        }
    }
}

mod me_31 {
    use super::*;

    #[test]
    fn what_is_explicit_takes_its_place() {
        let words = |list: &VertexList| {
            let wings = WingedEdges::try_from(list).expect("sound");
            [EdgeList::from(&wings).words(), wings.words(), HalfEdges::from(&wings).words()]
        };
        assert_eq!(words(&cube()), [96, 168, 134]);
        // The cube's 12 edges, 8 of the holes, 4 along the tunnel; 10 faces with 12 loops; a fan at each vertex.
        let [v, e, s] = [16, 24, 48];
        let by_formula = [3 * v + 2 * e + 2 * s, 3 * v + 10 * e + s, 3 * v + 16 + 8 * e + 12];
        assert_eq!(words(&cube_with_tunnel()), by_formula);
    }

    #[test]
    fn no_question_of_neighbourhood_reads_more_on_a_larger_mesh() {
        for n in [3, 5, 8, 13] {
            let wings = WingedEdges::try_from(&quad_torus(n, n + 1)).expect("sound");
            assert_eq!(of_first(&wings, &1), [5, 1, 1, 9, 8]);
            assert_eq!(of_first(&HalfEdges::from(&wings), &1), [5, 2, 2, 9, 9]);
        }
    }
}
