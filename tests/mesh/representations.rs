//! Conversions: what each way round gives back, on all small meshes and on random ones.

use super::meshes::{accidents, cube_with_spur, is_long, loops, named, positions, soup, triangle_sets, winged};
use isoracle::mesh::convert::MissingVertex;
use isoracle::mesh::edge_list::{Edge, EdgeId, EdgeList, EdgeListError, EdgeRecords, Side};
use isoracle::mesh::examples::{cube, mesh, point};
use isoracle::mesh::explicit::{ExplicitList, Polygon};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::operations::Operations;
use isoracle::mesh::vertex_list::VertexList;
use isoracle::mesh::winged_edge::{WingError, WingedEdges};
use proptest::prelude::*;
use std::collections::BTreeSet;

fn edge_list(list: &VertexList) -> EdgeList {
    EdgeList::try_from(list).expect("no vertex is missing")
}

/// All pairs of loops of at most four vertices out of three, as two faces, or as a face with a hole.
fn small() -> impl Iterator<Item = VertexList> {
    let all = loops(3, 4);
    let n = if is_long() { all.len() } else { 60 };
    let pairs = (0..all.len()).flat_map(move |a| (0..n).map(move |b| (a, b, b * 2 + a % 2)));
    pairs.map(move |(a, b, c)| {
        let (first, second) = (all[a].clone(), all[if is_long() { b } else { c }].clone());
        let faces = match (a + b) % 2 {
            0 => vec![Face::new(first), Face::new(second)],
            _ => vec![Face { outer: first, holes: vec![second] }],
        };
        VertexList { faces, ..mesh::<[u32; 0]>(&positions(3), &[]) }
    })
}

/// How often a side runs from a to b.
fn runs(list: &VertexList, a: u32, b: u32) -> usize {
    list.faces.iter().flat_map(Face::sides).filter(|side| *side == [a, b]).count()
}

/// The vertex list that comes back from the explicit one: by pairwise comparison of positions.
fn welded(list: &VertexList) -> VertexList {
    let mut vertices: Vec<_> = Vec::new();
    let mut number = |v: &u32| {
        let position = &list.vertices[*v as usize];
        vertices.iter().position(|p| p == position).unwrap_or_else(|| {
            vertices.push(position.clone());
            vertices.len() - 1
        }) as u32
    };
    let mut faces = Vec::new();
    for face in &list.faces {
        let outer = face.outer.iter().map(&mut number).collect();
        let holes = face.holes.iter().map(|hole| hole.iter().map(&mut number).collect()).collect();
        faces.push(Face { outer, holes });
    }
    VertexList { vertices, faces }
}

mod me_9 {
    use super::*;

    #[test]
    fn each_position_stands_once() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            let back = VertexList::from(&explicit);
            let distinct: BTreeSet<_> = explicit.polygons.iter().flat_map(Polygon::corners).collect();
            assert_eq!(back.vertices.iter().collect::<BTreeSet<_>>(), distinct, "{name}");
            assert_eq!(back.vertices.len(), distinct.len(), "{name}");
        }
    }

    #[test]
    fn two_vertices_at_one_position_tear_the_mesh_when_one_moves() {
        // A square by two triangles, once with its corners duplicated.
        let at = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
        let mut torn = mesh(&[at[0], at[1], at[2], at[0], at[2], at[3]], &[[0, 1, 2], [3, 4, 5]]);
        let mut whole = VertexList::from(&ExplicitList::try_from(&torn).expect("sound"));
        assert_eq!([torn.vertices.len(), whole.vertices.len()], [6, 4]);
        let boundary = |list: &VertexList| list.boundary_edges().expect("sound").answer.len();
        assert_eq!([boundary(&torn), boundary(&whole)], [6, 4]);
        for list in [&mut torn, &mut whole] {
            list.move_vertex(&0, point([0, 0, 1])).expect("vertex 0 is there");
        }
        let corners = |list: &VertexList| {
            let polygons = list.polygons().expect("sound").answer;
            polygons.iter().flat_map(Polygon::corners).filter(|corner| **corner == point([0, 0, 1])).count()
        };
        assert_eq!([corners(&torn), corners(&whole)], [1, 2]);
    }
}

mod me_12 {
    use super::*;

    #[test]
    fn as_many_polygons_as_the_explicit_list_has_and_not_as_many_as_vertices() {
        for (name, list) in named() {
            let explicit = ExplicitList::try_from(&list).expect(name);
            assert_eq!(VertexList::from(&explicit).faces.len(), explicit.polygons.len());
        }
        assert_eq!([cube().vertices.len(), cube().faces.len()], [8, 6]);
    }
}

mod me_17 {
    use super::*;

    #[test]
    fn the_vertices_are_those_of_the_vertex_list() {
        for (name, list) in named() {
            assert_eq!(edge_list(&list).vertices(), list.vertices, "{name}");
            assert_eq!(edge_list(&list).records().vertices, list.vertices, "{name}");
        }
    }
}

mod me_18 {
    use super::*;

    #[test]
    fn the_edges_are_the_pairs_that_sides_join_each_once() {
        for list in small().chain(named().into_iter().map(|(_, list)| list)) {
            let edges: Vec<[u32; 2]> = edge_list(&list).edges().iter().map(|e| edge(e.ends)).collect();
            let n = list.vertices.len() as u32;
            let pairs = (0..n).flat_map(|b| (0..=b).map(move |a| [a, b]));
            let truth: BTreeSet<[u32; 2]> =
                pairs.filter(|[a, b]| runs(&list, *a, *b) + runs(&list, *b, *a) > 0).collect();
            assert_eq!(edges.iter().copied().collect::<BTreeSet<_>>(), truth);
            assert_eq!(edges.len(), truth.len());
        }
    }
}

mod me_19 {
    use super::*;

    #[test]
    fn an_edge_lists_a_polygon_once_for_each_use() {
        for list in small().chain(named().into_iter().map(|(_, list)| list)) {
            for edge in edge_list(&list).edges() {
                let [a, b] = edge.ends;
                let uses = |face: &Face| face.sides().filter(|s| *s == [a, b] || *s == [b, a]).count();
                let truth: Vec<usize> =
                    list.faces.iter().enumerate().flat_map(|(i, face)| vec![i; uses(face)]).collect();
                assert_eq!(edge.faces, truth);
            }
        }
    }

    #[test]
    fn an_edge_of_a_closed_mesh_may_have_one_polygon_only() {
        let list = edge_list(&cube_with_spur());
        assert!(list.uses().iter().all(|uses| *uses == [1, 1]), "it is closed");
        let edge = list.edges().iter().find(|e| edge(e.ends) == [4, 8]).expect("the spur");
        assert_eq!(edge.faces, [1, 1]);
        // Without an edge twice in one polygon there are at least two.
        for edge in edge_list(&cube()).edges() {
            assert_eq!(edge.faces.iter().collect::<BTreeSet<_>>().len(), 2);
        }
    }
}

mod me_20 {
    use super::*;

    #[test]
    fn the_polygons_are_those_of_the_vertex_list_in_their_order() {
        for (name, list) in named() {
            let edges = edge_list(&list);
            assert_eq!(edges.records().faces.len(), list.faces.len(), "{name}");
            for (polygon, face) in edges.faces().iter().zip(&list.faces) {
                let walked: Vec<[u32; 2]> = polygon.corners().map(|side| edges.directed(*side)).collect();
                assert_eq!(walked, face.sides().collect::<Vec<_>>(), "{name}");
            }
        }
    }
}

mod me_40 {
    use super::*;

    #[test]
    fn the_vertex_list_comes_back_from_the_edge_list() {
        for list in small().chain(named().into_iter().map(|(_, list)| list)) {
            assert_eq!(VertexList::from(&edge_list(&list)), list);
        }
    }

    #[test]
    fn edges_are_numbered_and_directed_by_first_use() {
        for (name, list) in named() {
            let mut first_uses: Vec<[u32; 2]> = Vec::new();
            for side in list.faces.iter().flat_map(Face::sides) {
                if !first_uses.iter().any(|known| edge(*known) == edge(side)) {
                    first_uses.push(side);
                }
            }
            let ends: Vec<[u32; 2]> = edge_list(&list).edges().iter().map(|edge| edge.ends).collect();
            assert_eq!(ends, first_uses, "{name}");
        }
    }

    #[test]
    fn the_edge_list_comes_back_but_for_unused_and_equal_edges_and_numbers() {
        let side = |edge, is_backward| Side { edge: EdgeId(edge), is_backward };
        let ends = vec![[2, 1], [0, 1], [0, 2], [1, 2]];
        let triangle = Polygon::new([side(1, false), side(3, false), side(2, true)]);
        let other = Polygon::new([side(2, false), side(0, false), side(1, true)]);
        let list =
            EdgeList::new(mesh(&positions(3), &[[0, 1, 2]]).vertices, ends, vec![triangle, other]).expect("closed");
        let normal = edge_list(&VertexList::from(&list));
        assert_ne!(normal, list);
        let kept: Vec<[u32; 2]> = normal.edges().iter().map(|edge| edge.ends).collect();
        assert_eq!(kept, [[0, 1], [1, 2], [2, 0]]);
        assert_eq!(edge_list(&VertexList::from(&normal)), normal);
    }

    #[test]
    fn a_missing_vertex_is_named() {
        let broken = mesh(&positions(3), &[[0, 1, 2], [2, 1, 3]]);
        let missing = MissingVertex { face: 1, vertex: 3 };
        assert_eq!(EdgeList::try_from(&broken), Err(missing));
        assert_eq!(ExplicitList::try_from(&broken), Err(missing));
        assert_eq!(WingedEdges::try_from(&broken).expect_err("missing").to_string(), missing.to_string());
        assert_eq!(missing.to_string(), "face 1 names vertex 3, which does not exist");
    }

    #[test]
    fn what_is_wrong_with_records_is_named() {
        let sound = edge_list(&cube()).records();
        let error = |change: fn(&mut EdgeRecords)| {
            let mut records = sound.clone();
            change(&mut records);
            EdgeList::try_from(&records).expect_err("the records are broken")
        };
        let edge = EdgeId(3);
        assert_eq!(error(|r| r.edges[3].ends[1] = 8), EdgeListError::VertexOutOfRange { edge, vertex: 8 });
        assert_eq!(error(|r| r.edges[3].faces.truncate(1)), EdgeListError::NotReciprocal { edge });
        assert_eq!(error(|r| r.edges[3].faces.push(5)), EdgeListError::NotReciprocal { edge });
        assert_eq!(error(|r| r.faces[5].outer[2] = 12), EdgeListError::EdgeOutOfRange { face: 5, edge: EdgeId(12) });
        assert_eq!(error(|r| r.faces[5].outer.swap(0, 1)), EdgeListError::Open { face: 5, loop_number: 0 });
        assert_eq!(error(|r| r.faces[5].holes.push(vec![0])), EdgeListError::Open { face: 5, loop_number: 1 });
        let mut unsorted = sound.clone();
        unsorted.edges.push(Edge { ends: [0, 6], faces: Vec::new() });
        unsorted.edges[3].faces =
            vec![unsorted.edges[3].faces[1], unsorted.edges[3].faces[0], unsorted.edges[3].faces[0]];
        let list = EdgeList::try_from(&unsorted).expect("order and repetition do not matter, nor an unused edge");
        assert_eq!(list.records().edges[..12], sound.edges);
    }

    #[test]
    fn what_is_wrong_with_directed_sides_is_named() {
        let positions = cube().vertices;
        let of = |numbers: &[u32]| vec![Polygon::new(numbers.iter().map(|n| EdgeId(*n).forward()).collect::<Vec<_>>())];
        let new = |ends: &[[u32; 2]], faces| EdgeList::new(positions.clone(), ends.to_vec(), faces);
        let triangle = [[0, 1], [1, 2], [2, 0]];
        assert!(new(&triangle, of(&[0, 1, 2])).is_ok());
        assert_eq!(new(&triangle, of(&[0, 2, 1])), Err(EdgeListError::Open { face: 0, loop_number: 0 }));
        assert_eq!(new(&triangle, of(&[0, 3])), Err(EdgeListError::EdgeOutOfRange { face: 0, edge: EdgeId(3) }));
        let missing = EdgeListError::VertexOutOfRange { edge: EdgeId(1), vertex: 9 };
        assert_eq!(new(&[[0, 1], [9, 0]], of(&[0])), Err(missing));
        let backward = vec![Polygon::new([EdgeId(0).forward().reversed()])];
        assert_eq!(new(&[[4, 4]], backward), new(&[[4, 4]], of(&[0])));
    }

    proptest! {
        #[test]
        fn any_vertex_list_comes_back(list in soup()) {
            prop_assert_eq!(VertexList::from(&edge_list(&list)), list);
        }
    }
}

mod me_41 {
    use super::*;

    #[test]
    fn the_explicit_list_comes_back_from_the_vertex_list() {
        for list in small().chain(named().into_iter().map(|(_, list)| list)) {
            let explicit = ExplicitList::try_from(&list).expect("sound");
            assert_eq!(ExplicitList::try_from(&VertexList::from(&explicit)), Ok(explicit));
        }
    }

    #[test]
    fn the_vertex_list_comes_back_welded_and_in_order_of_first_use() {
        for mut list in small().chain(named().into_iter().map(|(_, list)| list)) {
            for coincident in [false, true] {
                if coincident && list.vertices.len() > 1 {
                    let first = list.vertices[0].clone();
                    list.vertices[1] = first;
                }
                let back = VertexList::from(&ExplicitList::try_from(&list).expect("sound"));
                assert_eq!(back, welded(&list));
            }
        }
    }

    #[test]
    fn what_is_lost() {
        let list = mesh(&[[7, 7, 7], [0, 0, 0], [1, 0, 0], [0, 0, 0]], &[&[1, 2][..], &[3]]);
        let back = VertexList::from(&ExplicitList::try_from(&list).expect("sound"));
        assert_eq!(back, mesh(&[[0, 0, 0], [1, 0, 0]], &[&[0, 1][..], &[0]]));
    }

    proptest! {
        #[test]
        fn any_list_comes_back_welded(mut list in soup(), equal in prop::array::uniform2(0..6usize)) {
            let position = list.vertices[equal[0]].clone();
            list.vertices[equal[1]] = position;
            let explicit = ExplicitList::try_from(&list).expect("sound");
            let back = VertexList::from(&explicit);
            prop_assert_eq!(&back, &welded(&list));
            prop_assert_eq!(ExplicitList::try_from(&back), Ok(explicit));
        }
    }
}

mod me_42 {
    use super::*;

    /// Whether winged edges can hold it, by the definition.
    fn is_winged(list: &VertexList) -> bool {
        let n = list.vertices.len() as u32;
        let at_most_once = |a, b| runs(list, a, b) <= usize::from(a != b);
        let empty = list.faces.iter().flat_map(Face::loops).any(<[u32]>::is_empty);
        !empty && (0..n).all(|a| (0..n).all(|b| at_most_once(a, b)))
    }

    #[test]
    fn the_edge_list_comes_back_from_every_mesh_that_winged_edges_can_hold() {
        let (mut held, mut refused) = (0, 0);
        for list in small().chain(triangle_sets()).chain(named().into_iter().map(|(_, list)| list)) {
            let edges = edge_list(&list);
            match WingedEdges::try_from(&edges) {
                Ok(wings) => {
                    assert!(is_winged(&list), "{list:?}");
                    assert_eq!(EdgeList::from(&wings), edges);
                    assert_eq!(VertexList::from(&wings), list);
                    held += 1;
                }
                Err(_) => {
                    assert!(!is_winged(&list), "{list:?}");
                    refused += 1;
                }
            }
        }
        assert!(held > 100 && refused > 100, "{held} held, {refused} refused");
    }

    #[test]
    fn what_winged_edges_cannot_hold_is_named() {
        let error = |faces: &[&[u32]]| {
            WingedEdges::try_from(&edge_list(&mesh(&positions(3), faces))).expect_err("it cannot be held")
        };
        assert_eq!(error(&[&[0, 1, 2], &[0]]), WingError::OneEnd { edge: EdgeId(3), vertex: 0 });
        assert_eq!(error(&[&[0, 1, 2], &[]]), WingError::EmptyLoop { face: 1, loop_number: 0 });
        let uses = WingError::Uses { edge: EdgeId(0), ends: [0, 1], uses: [2, 0] };
        assert_eq!(error(&[&[0, 1, 2], &[0, 1, 2]]), uses);
        let message = "loops run along edge 0 from 0 to 1 2 times, and back 0 times, where one is the most";
        assert_eq!(uses.to_string(), message);
    }

    proptest! {
        #[test]
        fn any_edge_list_comes_back(list in accidents()) {
            let edges = edge_list(&list);
            let wings = WingedEdges::try_from(&edges).expect("accidents leave it sound");
            prop_assert_eq!(EdgeList::from(&wings), edges);
        }

        #[test]
        fn any_soup_is_held_iff_no_side_runs_twice(list in soup()) {
            prop_assert_eq!(WingedEdges::try_from(&list).is_ok(), is_winged(&list));
        }
    }
}

mod me_43 {
    use super::*;

    #[test]
    fn winged_edges_come_back_from_half_edges() {
        for list in small().chain(triangle_sets()).chain(winged().into_iter().map(|(_, list)| list)) {
            if let Ok(wings) = WingedEdges::try_from(&list) {
                let halves = HalfEdges::from(&wings);
                assert_eq!(WingedEdges::from(&halves), wings);
                assert_eq!(HalfEdges::from(&WingedEdges::from(&halves)), halves);
                assert_eq!(VertexList::from(&halves), list);
            }
        }
    }

    proptest! {
        #[test]
        fn any_winged_edges_come_back(list in accidents()) {
            let wings = WingedEdges::try_from(&list).expect("accidents leave it sound");
            let halves = HalfEdges::from(&wings);
            prop_assert_eq!(&HalfEdges::try_from(&list), &Ok(halves.clone()));
            prop_assert_eq!(WingedEdges::from(&halves), wings);
        }
    }
}
