//! What lists and sets of vertices or edges determine.

use super::meshes::{is_long, loops};
use isoracle::mesh::edge_list::{EdgeList, EdgeListError, EdgeRecords, walks};
use isoracle::mesh::examples::mesh;
use isoracle::mesh::face::{edge, sides};
use isoracle::mesh::vertex_list::VertexList;
use std::collections::{BTreeMap, BTreeSet};

/// A loop's cycle with its direction: the least of its rotations.
fn cycle(l: &[u32]) -> Vec<u32> {
    let turned = |i: usize| [&l[i..], &l[..i]].concat();
    (0..l.len()).map(turned).min().unwrap_or_default()
}

/// The cycles, with directions, of all loops through different vertices with a given property.
fn simple_cycles(labels: u32, longest: u32, is_so: impl Fn(&[u32]) -> bool) -> BTreeSet<Vec<u32>> {
    let is_simple = |l: &Vec<u32>| l.iter().collect::<BTreeSet<_>>().len() == l.len() && l.len() > 2;
    loops(labels, longest).iter().filter(|l| is_simple(l) && is_so(l)).map(|l| cycle(l)).collect()
}

mod me_3 {
    use super::*;
    use isoracle::mesh::explicit::{ExplicitList, Polygon};

    #[test]
    fn a_set_of_four_positions_is_six_polygons_and_a_list_is_one() {
        let square = mesh(&[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], &[[0, 1, 2, 3]]);
        let all = simple_cycles(4, 4, |l| l.len() == 4);
        assert_eq!(all.len(), 6);
        let lists: BTreeSet<Vec<_>> =
            all.iter().map(|l| l.iter().map(|v| square.vertices[*v as usize].clone()).collect()).collect();
        assert_eq!(lists.len(), 6);
        let sets: BTreeSet<BTreeSet<_>> = lists.iter().map(|l| l.iter().cloned().collect()).collect();
        assert_eq!(sets.len(), 1);
        // The list keeps them apart, through the vertex list too.
        for list in lists {
            let explicit = ExplicitList { polygons: vec![Polygon::new(list)] };
            assert_eq!(ExplicitList::try_from(&VertexList::from(&explicit)), Ok(explicit));
        }
    }
}

mod me_10 {
    use super::*;

    #[test]
    fn a_set_of_vertex_numbers_is_as_many_polygons_as_cycles() {
        // n vertices: (n − 1)! cycles with direction.
        for (n, cycles) in [(3, 2), (4, 6), (5, 24)] {
            assert_eq!(simple_cycles(n, n, |l| l.len() == n as usize).len(), cycles);
        }
    }

    #[test]
    fn a_list_of_vertex_numbers_has_one_closed_walk() {
        // Sides from each vertex to the next one, and from the last to the first.
        for l in loops(3, 5) {
            let walk: Vec<[u32; 2]> = sides(&l).collect();
            assert_eq!(walk.iter().map(|side| side[0]).collect::<Vec<_>>(), l);
            assert!(walk.iter().zip(walk.iter().cycle().skip(1)).all(|(a, b)| a[1] == b[0]));
        }
    }
}

mod me_11 {
    use super::*;

    #[test]
    fn the_last_and_the_first_vertex_are_consecutive_too() {
        assert_eq!(sides(&[0, 1, 2]).collect::<Vec<_>>(), [[0, 1], [1, 2], [2, 0]]);
        for l in loops(4, 4).iter().filter(|l| l.len() >= 3) {
            let printed = l.windows(2).count();
            assert_eq!([printed + 1, l.len()], [sides(l).count(), sides(l).count()], "{l:?}");
        }
        // Each vertex is left once and come to once.
        for l in loops(3, 4) {
            let mut ends = [sides(&l).map(|s| s[0]).collect::<Vec<_>>(), sides(&l).map(|s| s[1]).collect()];
            ends.iter_mut().for_each(|ends| ends.sort());
            assert_eq!(ends[0], ends[1]);
        }
    }
}

mod me_21 {
    use super::*;

    #[test]
    fn loops_without_repeated_vertex_have_as_many_edges_as_vertices_from_three_on() {
        for l in loops(5, if is_long() { 6 } else { 5 }) {
            let edges: BTreeSet<[u32; 2]> = sides(&l).map(edge).collect();
            if l.iter().collect::<BTreeSet<_>>().len() == l.len() && l.len() >= 3 {
                assert_eq!(edges.len(), l.len(), "{l:?}");
            }
        }
    }

    #[test]
    fn a_loop_that_returns_by_its_own_edges_has_fewer() {
        let there_and_back = mesh(&super::super::meshes::positions(3), &[[0, 1, 2, 1]]);
        let list = EdgeList::try_from(&there_and_back).expect("no vertex is missing");
        assert_eq!((list.edges().len(), list.records().faces[0].outer.len()), (2, 4));
        assert_eq!(list.records().faces[0].outer, [0, 1, 1, 0]);
    }
}

mod me_22 {
    use super::*;

    /// The loops whose sides have these ends, by trying all loops.
    fn by_trial(labels: u32, longest: u32) -> BTreeMap<Vec<[u32; 2]>, BTreeSet<Vec<u32>>> {
        let mut found: BTreeMap<Vec<[u32; 2]>, BTreeSet<Vec<u32>>> = BTreeMap::new();
        for l in loops(labels, longest) {
            found.entry(sides(&l).map(edge).collect()).or_default().insert(l);
        }
        found
    }

    #[test]
    fn the_ordered_edges_determine_the_loop_unless_all_have_the_same_two_ends() {
        let mut ambiguous = 0;
        for (ends, truth) in by_trial(4, if is_long() { 8 } else { 6 }) {
            let found = walks(&ends);
            assert_eq!(found.iter().cloned().collect::<BTreeSet<_>>(), truth, "{ends:?}");
            assert_eq!(found.len(), truth.len());
            let same = !ends.is_empty() && ends.iter().all(|e| *e == ends[0] && e[0] != e[1]);
            assert_eq!(found.len(), if same { 2 } else { 1 }, "{ends:?}");
            ambiguous += usize::from(same);
        }
        assert!(ambiguous > 0);
    }

    #[test]
    fn edges_that_no_loop_has_are_no_walk() {
        let keys: Vec<[u32; 2]> = (0..3).flat_map(|b| (0..=b).map(move |a| [a, b])).collect();
        let truth = by_trial(3, 4);
        for code in loops(keys.len() as u32, 4) {
            // Ends in either order.
            let ends: Vec<[u32; 2]> = code.iter().map(|k| keys[*k as usize]).collect();
            let turned: Vec<[u32; 2]> = ends.iter().map(|[a, b]| [*b, *a]).collect();
            let expected = truth.get(&ends).cloned().unwrap_or_default();
            for given in [ends, turned] {
                assert_eq!(walks(&given).into_iter().collect::<BTreeSet<_>>(), expected, "{given:?}");
            }
        }
    }

    #[test]
    fn the_set_of_edges_leaves_the_direction_open() {
        // Printed in braces, as a set: the triangle's three edges are two loops.
        let triangle = BTreeSet::from([[0, 1], [1, 2], [0, 2]]);
        let loops = simple_cycles(3, 3, |l| sides(l).map(edge).collect::<BTreeSet<_>>() == triangle);
        assert_eq!(loops, BTreeSet::from([vec![0, 1, 2], vec![0, 2, 1]]));
        // As lists they differ.
        let lists = [vec![[0, 1], [1, 2], [0, 2]], vec![[0, 2], [1, 2], [0, 1]]];
        assert_eq!(lists.map(|list| walks(&list)), [vec![vec![0, 1, 2]], vec![vec![0, 2, 1]]]);
    }

    #[test]
    fn one_row_of_edges_leaves_the_loops_open_where_they_touch() {
        let ends = [[0, 1], [1, 2], [0, 2], [0, 3], [3, 4], [0, 4]];
        assert_eq!(walks(&ends), [[0, 1, 2, 0, 3, 4]]);
        assert_eq!([walks(&ends[..3]), walks(&ends[3..])], [vec![vec![0, 1, 2]], vec![vec![0, 3, 4]]]);
    }

    #[test]
    fn records_with_a_two_sided_loop_are_refused_by_its_number() {
        let mut digon = mesh(&super::super::meshes::positions(3), &[[0, 1, 2]]);
        digon.faces[0].holes.push(vec![0, 1]);
        let list = EdgeList::try_from(&digon).expect("no vertex is missing");
        let refused = EdgeListError::TwoDirections { face: 0, loop_number: 1 };
        assert_eq!(EdgeList::try_from(&list.records()), Err(refused));
        assert_eq!(VertexList::from(&list), digon);
    }

    #[test]
    fn records_are_read_back_in_all_other_cases() {
        let all = loops(3, 4);
        for (i, outer) in all.iter().enumerate() {
            let other = &all[(7 * i + 5) % all.len()];
            let list = EdgeList::try_from(&mesh(&super::super::meshes::positions(3), &[outer, other])).expect("sound");
            let records: EdgeRecords = list.records();
            let two = |l: &[u32]| !l.is_empty() && sides(l).all(|s| s[0] != s[1] && edge(s) == edge([l[0], l[1]]));
            match (0..).zip([outer, other]).find(|(_, l)| two(l)) {
                Some((face, _)) => {
                    let refused = EdgeListError::TwoDirections { face, loop_number: 0 };
                    assert_eq!(EdgeList::try_from(&records), Err(refused));
                }
                None => assert_eq!(EdgeList::try_from(&records), Ok(list)),
            }
        }
    }
}
