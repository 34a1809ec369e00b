//! IS-9 … IS-15: curves and surfaces as simplicial complexes.

use isoracle::mesh::simplicial::{CurveDefect, Simplex, SimplicialComplex, SurfaceDefect};
use isoracle::mesh::triangles::{Defect, defects};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn simplex(vertices: &[u32]) -> Simplex {
    Simplex::new(vertices).expect("a simplex")
}

fn complex<const K: usize>(simplices: &[[u32; K]]) -> SimplicialComplex {
    SimplicialComplex::from_vertices(simplices).expect("simplices")
}

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
const PROJECTIVE_PLANE: [[u32; 3]; 10] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1], [1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];

/// All sets of edges, or of triangles, on 5 vertices: 2¹⁰ of each.
fn all_on_five<const K: usize>() -> impl Iterator<Item = Vec<[u32; K]>> {
    let subsets = (0u32..32).filter(|set| set.count_ones() as usize == K);
    let all: Vec<[u32; K]> = subsets
        .map(|set| {
            let mut vertices = (0..5).filter(move |v| set >> v & 1 == 1);
            std::array::from_fn(|_| vertices.next().expect("K of them"))
        })
        .collect();
    assert_eq!(all.len(), 10);
    (0u32..1 << 10).map(move |set| (0..10).filter(|i| set >> i & 1 == 1).map(|i| all[i]).collect())
}

/// Whether these edges are one cycle, by walking along it.
fn is_one_cycle(edges: &BTreeSet<[u32; 2]>) -> bool {
    let Some(&[start, _]) = edges.first() else { return false };
    let (mut left, mut at) = (edges.clone(), start);
    while let Some(&edge) = left.iter().find(|edge| edge.contains(&at)) {
        left.remove(&edge);
        at = edge[0] + edge[1] - at;
        if at == start {
            break;
        }
    }
    let visits = |v: u32| edges.iter().filter(|e| e.contains(&v)).count();
    at == start && left.is_empty() && edges.iter().flatten().all(|v| visits(*v) == 2)
}

/// The Betti numbers modulo 2 of dimensions 0, 1, 2, by the ranks of the boundary matrices.
fn betti(complex: &SimplicialComplex) -> [i64; 3] {
    let rank = |k: usize| -> i64 {
        let faces: Vec<&Simplex> = complex.of_dimension(k - 1).collect();
        let row = |s: &Simplex| -> BTreeSet<usize> {
            s.faces(k - 1).iter().map(|f| faces.binary_search(&f).expect("a complex has its faces")).collect()
        };
        let mut reduced: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for simplex in complex.of_dimension(k) {
            let mut row = row(simplex);
            while let Some(pivot) = row.first().copied() {
                match reduced.get(&pivot) {
                    Some(other) => row = row.symmetric_difference(other).copied().collect(),
                    None => {
                        reduced.insert(pivot, row);
                        break;
                    }
                }
            }
        }
        reduced.len() as i64
    };
    let count = |k: usize| complex.of_dimension(k).count() as i64;
    [count(0) - rank(1), count(1) - rank(1) - rank(2), count(2) - rank(2)]
}

mod is_9 {
    use super::*;

    #[test]
    fn on_five_vertices_a_graph_is_a_polygonal_curve_iff_it_falls_into_cycles_by_walking() {
        let mut curves = 0;
        for edges in all_on_five::<2>() {
            let mut left: BTreeSet<[u32; 2]> = edges.iter().copied().collect();
            // Part by part: everything connected to the first edge is to be one cycle.
            let mut falls_into_cycles = true;
            while let Some(&first) = left.first() {
                let mut part = BTreeSet::from([first]);
                while let Some(&next) =
                    left.iter().find(|e| !part.contains(*e) && part.iter().flatten().any(|v| e.contains(v)))
                {
                    part.insert(next);
                }
                falls_into_cycles &= is_one_cycle(&part);
                left = &left - &part;
            }
            assert_eq!(complex(&edges).curve_defects().is_empty(), falls_into_cycles, "{edges:?}");
            curves += usize::from(falls_into_cycles);
        }
        // None; 10 triangles, 15 quadrilaterals, 12 pentagons.
        assert_eq!(curves, 1 + 10 + 15 + 12);
    }

    #[test]
    fn what_is_no_curve_is_told() {
        let path_and_point = SimplicialComplex::new([simplex(&[0, 1]), simplex(&[1, 2]), simplex(&[7])]);
        let expected = [
            CurveDefect::Isolated(7),
            CurveDefect::Degree { vertex: 0, edges: 1 },
            CurveDefect::Degree { vertex: 2, edges: 1 },
        ];
        assert_eq!(path_and_point.curve_defects(), expected);
        let triangle = complex(&[[0, 1, 2]]);
        assert_eq!(triangle.curve_defects(), [CurveDefect::TooLarge(simplex(&[0, 1, 2]))]);
    }
}

mod is_10 {
    use super::*;

    #[test]
    fn an_edge_is_manifold_iff_its_link_is_two_points() {
        for triangles in all_on_five::<3>() {
            let complex = complex(&triangles);
            let defects = complex.surface_defects();
            for edge in complex.of_dimension(1) {
                let link = complex.link(edge);
                let manifold = link.f_vector() == [2];
                let told = defects.iter().any(|d| matches!(d, SurfaceDefect::Edge { edge: e, .. } if e == edge));
                assert_eq!(manifold, !told, "{edge:?} of {triangles:?}");
                assert_eq!(link.f_vector(), [triangles.iter().filter(|t| simplex(*t).has_face(edge)).count() as i64]);
            }
        }
    }

    #[test]
    fn isolated_simplices_and_solids_are_told() {
        let mixed = SimplicialComplex::new([simplex(&[0, 1, 2, 3]), simplex(&[4, 5]), simplex(&[6])]);
        let defects = mixed.surface_defects();
        assert!(defects.contains(&SurfaceDefect::TooLarge(simplex(&[0, 1, 2, 3]))));
        assert!(defects.contains(&SurfaceDefect::Isolated(simplex(&[4, 5]))));
        assert!(defects.contains(&SurfaceDefect::Isolated(simplex(&[6]))));
        for surface in [complex(&TETRAHEDRON), complex(&PROJECTIVE_PLANE), SimplicialComplex::torus()] {
            assert_eq!(surface.surface_defects(), []);
        }
    }
}

mod is_11 {
    use super::*;

    /// Two tetrahedra's surfaces with vertex 0 in common.
    fn two_cones() -> SimplicialComplex {
        let second = TETRAHEDRON.map(|t| t.map(|v| if v == 0 { 0 } else { v + 3 }));
        complex(&[TETRAHEDRON, second].concat())
    }

    #[test]
    fn with_the_vertex_its_surroundings_are_connected_without_it_they_are_not() {
        let cones = two_cones();
        let vertex = simplex(&[0]);
        let around = cones.simplices().filter(|s| s.has_face(&vertex));
        let closed_star = SimplicialComplex::new(around.cloned());
        assert_eq!(closed_star.component_count(), 1, "as printed: connected, so manifold");
        assert_eq!(cones.link(&vertex).component_count(), 2, "two cones");
        assert_eq!(cones.surface_defects(), [SurfaceDefect::Vertex { vertex: 0, parts: 2 }]);
    }

    #[test]
    fn on_five_vertices_and_the_edges_around_sound_connected_means_that_the_link_is_one_cycle() {
        for triangles in all_on_five::<3>() {
            let complex = complex(&triangles);
            let defects = complex.surface_defects();
            for vertex in complex.of_dimension(0) {
                let v = vertex.vertices()[0];
                let edges_are_sound =
                    !defects.iter().any(|d| matches!(d, SurfaceDefect::Edge { edge, .. } if edge.has_face(vertex)));
                let is_told = defects.iter().any(|d| matches!(d, SurfaceDefect::Vertex { vertex, .. } if *vertex == v));
                let opposite = |t: &[u32; 3]| {
                    let rest: Vec<u32> = t.iter().copied().filter(|w| *w != v).collect();
                    (rest.len() == 2).then(|| [rest[0], rest[1]])
                };
                if edges_are_sound {
                    assert_eq!(
                        !is_told,
                        is_one_cycle(&triangles.iter().filter_map(opposite).collect()),
                        "{triangles:?}"
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn the_other_test_of_triangle_meshes_tells_the_same_vertices_and_edges(set in prop::collection::btree_set(0usize..84, 1..30)) {
            let all: Vec<[u32; 3]> =
                (0..9).flat_map(|a| (0..a).flat_map(move |b| (0..b).map(move |c| [c, b, a]))).collect();
            let triangles: Vec<[u32; 3]> = set.into_iter().map(|i| all[i]).collect();
            let mut here = (BTreeSet::new(), BTreeSet::new());
            for defect in complex(&triangles).surface_defects() {
                match defect {
                    SurfaceDefect::Edge { edge, triangles } if triangles > 2 => { here.0.insert(edge.vertices().to_vec()); }
                    SurfaceDefect::Edge { .. } => {}
                    SurfaceDefect::Vertex { vertex, .. } => { here.1.insert(vertex); }
                    SurfaceDefect::TooLarge(_) | SurfaceDefect::Isolated(_) => prop_assert!(false),
                }
            }
            let mut there = (BTreeSet::new(), BTreeSet::new());
            for defect in defects(9, &triangles) {
                match defect {
                    Defect::EdgeUsedMoreThanTwice { edge, .. } => { there.0.insert(edge.to_vec()); }
                    Defect::NonmanifoldVertex { vertex } => { there.1.insert(vertex); }
                    Defect::InconsistentWinding { .. } => {}
                    other => prop_assert!(false, "{:?}", other),
                }
            }
            prop_assert_eq!(here, there);
        }
    }
}

mod is_12 {
    use super::*;

    #[test]
    fn three_triangles_on_an_edge_are_connected_around_its_end_which_is_no_manifold_point() {
        let book = complex(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        assert_eq!(book.link(&simplex(&[0])).component_count(), 1);
        assert_eq!(book.link(&simplex(&[0])).f_vector(), [4, 3], "a star of three edges, no cycle");
        assert!(book.surface_defects().contains(&SurfaceDefect::Edge { edge: simplex(&[0, 1]), triangles: 3 }));
    }

    #[test]
    fn on_five_vertices_a_manifold_vertex_has_sound_edges_around_and_a_connected_link_is_not_enough() {
        let mut connected_and_no_manifold = 0;
        for triangles in all_on_five::<3>() {
            let complex = complex(&triangles);
            for vertex in complex.of_dimension(0) {
                let link = complex.link(vertex);
                let edges = link.of_dimension(1).map(|e| [e.vertices()[0], e.vertices()[1]]).collect();
                let around = complex.of_dimension(1).filter(|e| e.has_face(vertex));
                let sound = around.into_iter().all(|e| complex.link(e).f_vector() == [2]);
                let manifold = is_one_cycle(&edges);
                assert!(!manifold || sound, "{triangles:?}");
                assert_eq!(manifold, sound && link.component_count() == 1, "{triangles:?}");
                connected_and_no_manifold += usize::from(!manifold && link.component_count() == 1);
            }
        }
        assert!(connected_and_no_manifold > 0);
    }
}

mod is_13 {
    use super::*;

    #[test]
    fn the_count_is_the_characteristic_of_surfaces_that_are_known() {
        let strip = |twisted: bool| -> Vec<[u32; 3]> {
            // Six vertices in two rows of three, closed to a ring, or to a Möbius strip of five.
            if twisted {
                (0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]).collect()
            } else {
                (0..3)
                    .flat_map(|i| {
                        let j = (i + 1) % 3;
                        [[i, j, i + 3], [j, i + 3, j + 3]]
                    })
                    .collect()
            }
        };
        let known = [
            (complex(&TETRAHEDRON), 2),
            (complex(&PROJECTIVE_PLANE), 1),
            (SimplicialComplex::torus(), 0),
            (complex(&[[0, 1, 2]]), 1),
            (complex(&strip(false)), 0),
            (complex(&strip(true)), 0),
            (complex(&[[0, 1], [1, 2], [2, 0]]), 0),
            (complex(&[[0], [1]]), 2),
            (SimplicialComplex::default(), 0),
        ];
        for (complex, chi) in known {
            let f = complex.f_vector();
            let of = |k: usize| f.get(k).copied().unwrap_or(0);
            assert_eq!(of(2) - of(1) + of(0), chi);
            assert_eq!(complex.euler_characteristic(), chi);
        }
    }

    #[test]
    fn on_five_vertices_the_count_is_the_alternating_sum_of_the_betti_numbers() {
        for triangles in all_on_five::<3>() {
            let complex = complex(&triangles);
            let [b0, b1, b2] = betti(&complex);
            assert_eq!(b0 as usize, complex.component_count());
            assert_eq!(complex.euler_characteristic(), b0 - b1 + b2, "{triangles:?}");
        }
    }
}

mod is_14 {
    use super::*;

    proptest! {
        #[test]
        fn a_vertex_in_a_simplex_changes_the_counts_as_said_and_no_betti_number(
            surface in 0usize..3, picks in prop::collection::vec((0usize..1000, 1usize..3), 1..8)
        ) {
            let mut complex = [complex(&TETRAHEDRON), complex(&PROJECTIVE_PLANE), SimplicialComplex::torus()][surface].clone();
            let (chi, numbers) = (complex.euler_characteristic(), betti(&complex));
            for (step, (pick, dimension)) in picks.into_iter().enumerate() {
                let all: Vec<Simplex> = complex.of_dimension(dimension).cloned().collect();
                let before = complex.f_vector();
                let vertex = 100 + step as u32;
                complex = complex.with_inner_vertex(&all[pick % all.len()], vertex).expect("its own simplex, a new vertex");
                // A triangle in three; an edge in two, and each of its two triangles.
                let change: Vec<i64> = complex.f_vector().iter().zip(before).map(|(new, old)| new - old).collect();
                prop_assert_eq!(change, [1, 3, 2]);
                prop_assert_eq!(complex.link(&simplex(&[vertex])).f_vector()[0], if dimension == 2 { 3 } else { 4 });
                prop_assert_eq!(complex.euler_characteristic(), chi);
                prop_assert_eq!(complex.surface_defects(), []);
            }
            prop_assert_eq!(betti(&complex), numbers);
        }
    }

    #[test]
    fn there_is_none_in_a_simplex_that_is_not_there_or_with_a_vertex_that_is() {
        let tetrahedron = complex(&TETRAHEDRON);
        assert_eq!(tetrahedron.with_inner_vertex(&simplex(&[0, 1, 2, 3]), 9), None);
        assert_eq!(tetrahedron.with_inner_vertex(&simplex(&[0, 1, 2]), 3), None);
    }
}

mod is_15 {
    use super::*;

    #[test]
    fn the_torus_is_an_orientable_surface_of_genus_1() {
        let torus = SimplicialComplex::torus();
        assert_eq!(torus.f_vector(), [7, 21, 14]);
        assert_eq!(torus.surface_defects(), []);
        assert_eq!(betti(&torus), [1, 2, 1]);
        // Oriented as listed: i, i+1, i+3 and i+2, i, i+3 run along each common edge in opposite directions.
        let oriented: Vec<[u32; 3]> =
            (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [(i + 2) % 7, i, (i + 3) % 7]]).collect();
        assert_eq!(complex(&oriented), torus);
        assert_eq!(defects(7, &oriented), []);
    }

    #[test]
    fn a_torus_beside_changes_the_topology_and_not_the_characteristic() {
        for surface in [complex(&TETRAHEDRON), complex(&PROJECTIVE_PLANE), SimplicialComplex::torus()] {
            let with = surface.disjoint_union(&SimplicialComplex::torus());
            assert_eq!(with.euler_characteristic(), surface.euler_characteristic());
            assert_eq!(with.component_count(), surface.component_count() + 1);
            let [b0, b1, b2] = betti(&surface);
            assert_eq!(betti(&with), [b0 + 1, b1 + 2, b2 + 1]);
            assert_eq!(with.surface_defects(), []);
        }
    }

    #[test]
    fn a_torus_with_b_holes_takes_b_away() {
        // Triangles divided, so that the holes do not touch.
        let mut torus = SimplicialComplex::torus();
        for (step, triangle) in SimplicialComplex::torus().of_dimension(2).enumerate() {
            torus = torus.with_inner_vertex(triangle, 100 + step as u32).expect("a triangle");
            torus = torus
                .with_inner_vertex(
                    &simplex(&[&triangle.vertices()[..2], &[100 + step as u32]].concat()),
                    200 + step as u32,
                )
                .expect("a triangle");
            let hole = simplex(&[triangle.vertices()[0], 100 + step as u32, 200 + step as u32]);
            assert!(torus.contains(&hole));
        }
        for holes in 0..=3u32 {
            let cut: BTreeSet<Simplex> = (0..holes)
                .map(|step| {
                    let inner = [100 + step, 200 + step];
                    torus
                        .of_dimension(2)
                        .find(|t| inner.iter().all(|v| t.vertices().contains(v)))
                        .expect("a hole")
                        .clone()
                })
                .collect();
            let rest = SimplicialComplex::new(torus.of_dimension(2).filter(|t| !cut.contains(t)).cloned());
            let with = complex(&TETRAHEDRON).disjoint_union(&rest);
            assert_eq!(with.euler_characteristic(), 2 - i64::from(holes));
        }
    }
}
