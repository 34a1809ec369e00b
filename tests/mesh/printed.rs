//! The meshes that 001 prints: every printed incidence, against the others.

use isoracle::linear::{Matrix, determinant2};
use isoracle::mesh::edge_list::{EdgeId, EdgeList, EdgeRecords, walks};
use isoracle::mesh::explicit::Polygon;
use isoracle::mesh::face::{edge, sides};
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::printed::{
    HOUSE_EDGES, HouseReading, hollow_triangle, hollow_triangle_rows, house, house_with_edges, segment, triangle,
    triangle_records,
};
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::mesh::winged_edge::WingedEdges;
use isoracle::number::Rational;
use isoracle::partition::Partition;
use std::collections::BTreeSet;

/// Twice the signed area of a loop in the plane z = 0: positive iff it is counterclockwise.
fn twice_area(loop_: &[u32], vertices: &[Point]) -> Rational {
    let at = |v: u32| vertices[v as usize].0.clone();
    let corner = |[a, b]: [u32; 2]| {
        let ([x1, y1, _], [x2, y2, _]) = (at(a), at(b));
        determinant2(&Matrix([[x1, y1], [x2, y2]]))
    };
    sides(loop_).map(corner).fold(Rational::new(), |sum, d| sum + d)
}

fn cycle(l: &[u32]) -> Vec<u32> {
    (0..l.len()).map(|i| [&l[i..], &l[..i]].concat()).min().unwrap_or_default()
}

/// Connected parts: faces joined where they share an edge.
fn parts(list: &EdgeList) -> usize {
    let mut parts = Partition::new(list.faces().len());
    let joined = list.edges().iter().filter(|e| e.faces.len() > 1 && parts.join(e.faces[0], e.faces[1])).count();
    list.faces().len() - joined
}

mod me_32 {
    use super::*;

    #[test]
    fn the_two_faces_of_the_triangle_are_each_clockwise_from_their_own_side() {
        let list = triangle();
        let areas = list.faces.iter().map(|face| twice_area(&face.outer, &list.vertices));
        // 10·10/2 = 50; from the front, Ft1 is clockwise.
        assert_eq!(areas.collect::<Vec<_>>(), [-100, 100]);
        let edges = EdgeList::try_from(&list).expect("sound");
        assert_eq!(edges.uses(), [[1, 1]; 3]);
        assert!(WingedEdges::try_from(&edges).is_ok());
    }
}

mod me_33 {
    use super::*;

    #[test]
    fn the_tables_of_edges_say_what_the_table_of_faces_says() {
        let list = EdgeList::try_from(&triangle_records()).expect("the tables are consistent");
        let [from_edges, from_faces] = [VertexList::from(&list), triangle()];
        assert_eq!(from_edges.vertices, from_faces.vertices);
        let cycles = |list: &VertexList| list.faces.iter().map(|face| cycle(&face.outer)).collect::<Vec<_>>();
        assert_eq!(cycles(&from_edges), cycles(&from_faces));
        // Ft2 begins elsewhere: (At1, At3, At2) begins at Vt2, (Vt1, Vt3, Vt2) at Vt1.
        assert_eq!([&from_edges.faces[1].outer, &from_faces.faces[1].outer], [&[1, 0, 2], &[0, 2, 1]]);
        let ends = |list: &EdgeList| list.edges().iter().map(|edge| edge.ends).collect::<Vec<_>>();
        assert_eq!(ends(&list), ends(&EdgeList::try_from(&triangle()).expect("sound")));
        assert_eq!([list.vertices().len(), list.edges().len(), list.faces().len()], [3, 3, 2]);
    }

    #[test]
    fn no_other_order_of_the_second_faces_edges_matches() {
        // Of the six orders, the three rotations of the printed one turn the loop over; the others repeat Ft1.
        let turned = |order: [u32; 3]| {
            let mut records = triangle_records();
            records.faces[1] = Polygon::new(order);
            EdgeList::try_from(&records).expect("any order is a closed walk").uses() == [[1, 1]; 3]
        };
        let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        assert_eq!(orders.map(turned), [false, false, false, true, true, true]);
    }
}

mod me_34 {
    use super::*;

    #[test]
    fn each_row_is_an_outer_loop_and_a_hole_against_it() {
        let list = hollow_triangle();
        for (row, face) in hollow_triangle_rows().into_iter().zip(list.faces()) {
            let edges: Vec<u32> = face.corners().map(|side| side.edge.0).collect();
            assert_eq!(edges, row);
            let ends = row.map(|e| list.edges()[e as usize].ends);
            // The row is no one walk; its first and last three are one each.
            assert!(walks(&ends).is_empty());
            let [outer, hole] = [&walks(&ends[..3])[..], &walks(&ends[3..])[..]];
            let ([outer], [hole]) = (outer, hole) else { panic!("one walk each") };
            let areas = [outer, hole].map(|l| twice_area(l, list.vertices()));
            assert!(areas[0].clone() * &areas[1] < 0, "opposite senses");
        }
        assert_eq!(list.uses(), [[1, 1]; 6]);
        let counts = [list.vertices().len(), list.edges().len(), list.faces().len(), parts(&list)];
        assert_eq!(counts, [6, 6, 2, 1]);
    }

    #[test]
    fn the_hole_is_strictly_inside() {
        let list = hollow_triangle();
        let left = |side: [u32; 2], v: u32| twice_area(&[side[0], side[1], v], list.vertices());
        for side in [[0, 1], [1, 2], [2, 0]] {
            assert!((3..6).all(|v| left(side, v) < 0), "to the right of the clockwise loop");
        }
    }
}

mod me_35 {
    use super::*;

    #[test]
    fn a_segment_is_a_quadrilateral_with_four_vertices_four_edges_two_faces() {
        for width in [(1, 1), (1, 1000), (1, i64::MAX)] {
            let list = segment(&Rational::from(width)).expect("it has a width");
            let edges = EdgeList::try_from(&list).expect("sound");
            assert_eq!([edges.vertices().len(), edges.edges().len(), edges.faces().len()], [4, 4, 2]);
            assert_eq!(edges.uses(), [[1, 1]; 4]);
            let areas: Vec<Rational> = list.faces.iter().map(|f| twice_area(&f.outer, &list.vertices)).collect();
            let expected = Rational::from(width) * 4u32;
            assert_eq!(areas, [expected.clone(), -expected]);
            assert_eq!(list.vertices.iter().collect::<BTreeSet<_>>().len(), 4);
        }
        assert_eq!(segment(&Rational::new()), None);
    }
}

mod me_36 {
    use super::*;

    #[test]
    fn the_printed_edges_are_the_sides_of_the_faces_and_two_are_one_pair() {
        let used: BTreeSet<[u32; 2]> =
            house().faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).map(edge).collect();
        let printed: BTreeSet<[u32; 2]> = HOUSE_EDGES.into_iter().map(edge).collect();
        assert_eq!(printed, used);
        assert_eq!([HOUSE_EDGES.len(), printed.len()], [8, 7]);
        assert_eq!(HOUSE_EDGES[2], HOUSE_EDGES[7]);
    }

    #[test]
    fn as_pairs_of_vertices_one_edge_has_four_faces() {
        let list = EdgeList::try_from(&house()).expect("sound");
        let faces: Vec<usize> = list.edges().iter().map(|edge| edge.faces.len()).collect();
        assert_eq!(faces, [2, 2, 4, 2, 2, 2, 2]);
        assert_eq!(edge(list.edges()[2].ends), [2, 3]);
    }

    #[test]
    fn as_eight_edges_each_is_common_to_two_faces_in_two_ways() {
        let parts = [HouseReading::FrontAndBack, HouseReading::WallsAndRoof].map(|reading| {
            let list = house_with_edges(reading);
            assert_eq!(VertexList::from(&list), house());
            assert_eq!(list.uses(), [[1, 1]; 8]);
            assert!(list.edges().iter().all(|edge| edge.faces.iter().collect::<BTreeSet<_>>().len() == 2));
            assert!(WingedEdges::try_from(&list).is_ok());
            parts(&list)
        });
        assert_eq!(parts, [1, 2]);
    }

    #[test]
    fn there_is_no_third_way() {
        // The faces that use A3 among those of V3 and V4: six choices of two of four, three up to names.
        let mut sound = Vec::new();
        for others in [1, 2, 3] {
            let a8 = |face: usize| face != 0 && face != others;
            let mut faces = house_with_edges(HouseReading::FrontAndBack).faces().to_vec();
            for (number, polygon) in faces.iter_mut().enumerate() {
                for side in polygon.outer.iter_mut().filter(|side| [2, 7].contains(&side.edge.0)) {
                    side.edge = EdgeId(if a8(number) { 7 } else { 2 });
                }
            }
            let list = EdgeList::new(house().vertices, HOUSE_EDGES.to_vec(), faces).expect("closed");
            if list.uses() == [[1, 1]; 8] {
                sound.push(list);
            }
        }
        let readings = [HouseReading::FrontAndBack, HouseReading::WallsAndRoof];
        assert_eq!(sound, readings.map(house_with_edges));
    }

    #[test]
    fn walls_and_roof_touch_at_two_vertices() {
        let fans = |reading| {
            let wings = WingedEdges::try_from(&house_with_edges(reading)).expect("sound");
            assert!(HalfEdges::from(&wings).boundary_loops().is_empty());
            wings.vertices().iter().map(|vertex| vertex.fans.len()).collect::<Vec<_>>()
        };
        assert_eq!(fans(HouseReading::FrontAndBack), [1; 6]);
        assert_eq!(fans(HouseReading::WallsAndRoof), [1, 1, 2, 2, 1, 1]);
    }
}

mod me_37 {
    use super::super::meshes::{closed_manifolds, named};
    use super::*;

    #[test]
    fn each_edge_is_in_two_faces_in_opposite_directions_iff_the_mesh_is_closed_and_oriented() {
        let closed: BTreeSet<&str> = closed_manifolds().into_iter().map(|(name, _)| name).collect();
        for (name, list) in named() {
            let sides: Vec<[u32; 2]> = list.faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).collect();
            let once = |side: [u32; 2]| sides.iter().filter(|other| **other == side).count() == 1;
            let paired = !sides.is_empty() && sides.iter().all(|&[a, b]| a != b && once([a, b]) && once([b, a]));
            assert_eq!(paired, closed.contains(name), "{name}");
        }
        for name in ["open cube", "one triangle", "house"] {
            assert!(!closed.contains(name));
        }
    }

    #[test]
    fn as_printed_it_fails_for_a_mesh_with_boundary() {
        let list =
            EdgeList::try_from(&isoracle::mesh::examples::mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[[0, 1, 2]]));
        let list = list.expect("sound");
        assert!(list.edges().iter().all(|edge| edge.faces == [0]));
        assert_eq!(list.uses(), [[1, 0]; 3]);
    }
}

mod me_39 {
    use super::*;

    #[test]
    fn the_hollow_triangles_wire_frame_is_also_that_of_two_triangles() {
        let hollow = hollow_triangle();
        let frame = hollow.wire_frame();
        // Two triangles of two faces each, one inside the other.
        let loops = |face: usize| hollow.faces()[face].loops().map(|l| Polygon::new(l.to_vec())).collect::<Vec<_>>();
        let ends: Vec<[u32; 2]> = frame.edges().iter().map(|edge| edge.ends).collect();
        let nested = EdgeList::new(frame.vertices().to_vec(), ends, [loops(0), loops(1)].concat()).expect("closed");
        assert_eq!(nested.wire_frame(), frame);
        assert_eq!([nested.uses(), hollow.uses()], [vec![[1, 1]; 6], vec![[1, 1]; 6]]);
        assert_eq!([nested.faces().len(), hollow.faces().len()], [4, 2]);
        assert_eq!([parts(&nested), parts(&hollow)], [2, 1]);
    }

    #[test]
    fn a_wire_frame_has_no_polygon_to_answer_with() {
        let frame: EdgeRecords = hollow_triangle().wire_frame().records();
        assert!(frame.faces.is_empty() && frame.edges.iter().all(|edge| edge.faces.is_empty()));
    }
}
