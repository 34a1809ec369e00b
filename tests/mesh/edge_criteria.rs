//! ME-46, ME-47, ME-51, ME-52, ME-54, ME-56, ME-59: the criteria on edges and their polygons.

use super::printed_criteria::*;
use super::specimens::*;
use isoracle::mesh::defects::{Category, Element, ListedEdges, check};
use isoracle::mesh::examples::{cube, mesh, tetrahedron};
use isoracle::mesh::face::Face;
use isoracle::mesh::plane::projected_areas;
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::Rational;
use std::collections::{BTreeMap, BTreeSet};

mod me_46 {
    use super::*;

    #[test]
    fn a_bridge_lies_in_one_polygon_of_a_closed_surface() {
        let keyholes = box_with_keyholes();
        assert_eq!(different_polygons(&keyholes), BTreeSet::from([1, 2]));
        assert_eq!(polygons_at(&keyholes)[&[0, 8]], [0, 0]);
        assert_eq!(uses(&keyholes), BTreeSet::from([2]));
        let counts = counts(&keyholes);
        assert!(counts.closed && counts.manifold);
        assert_eq!(counts.volume, Some(Rational::from(24)));
        assert_eq!(counts.genus, Some(1));
    }

    #[test]
    fn sides_of_a_closed_oriented_surface_cancel_and_of_no_part_of_it() {
        // The boundary of the chain of all faces: each edge forwards less backwards.
        let border = |mesh: &VertexList| {
            let mut chain: BTreeMap<[u32; 2], i32> = BTreeMap::new();
            for [a, b] in mesh.faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()) {
                *chain.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
            chain.into_values().filter(|n| *n != 0).count()
        };
        for whole in [cube(), torus(), box_with_keyholes(), box_with_tunnel()] {
            assert_eq!(border(&whole), 0);
            for i in 0..whole.faces.len() {
                let open = without(&whole, |j| j == i);
                assert!(border(&open) > 0 && uses(&open).contains(&1) && !counts(&open).closed);
            }
        }
    }
}

mod me_47 {
    use super::*;

    #[test]
    fn a_wall_makes_three_polygons_meet_where_no_edge_has_one() {
        let wall = tetrahedra_with_wall();
        assert_eq!(different_polygons(&wall), BTreeSet::from([2, 3]));
        assert_eq!(printed_failures(&wall), ["even", "at most two"]);
        let odd: Vec<Element> = check(&wall, None).defects.of(Category::EdgeOddUse).cloned().collect();
        assert_eq!(odd, [[0, 1], [0, 2], [1, 2]].map(Element::Edge));
    }

    #[test]
    fn a_bridge_has_one_polygon_and_two_uses() {
        assert!(different_polygons(&box_with_keyholes()).contains(&1));
        assert!(!categories(&box_with_keyholes()).contains(&Category::EdgeOddUse));
    }

    #[test]
    fn every_set_of_unit_cubes_has_an_even_number_of_squares_at_each_edge() {
        // All 256 subsets of 2 × 2 × 2 cubes: squares between a cube of the set and one that is not.
        let number = |[x, y, z]: [i64; 3]| (x + 3 * y + 9 * z) as u32;
        let vertices: Vec<[i64; 3]> = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9]).collect();
        for set in 0_u32..256 {
            let has =
                |at: [i64; 3]| at.iter().all(|x| (0..2).contains(x)) && set >> (at[0] + 2 * at[1] + 4 * at[2]) & 1 == 1;
            let mut squares: Vec<Vec<u32>> = Vec::new();
            for i in 0..8_i64 {
                let at = [i & 1, i >> 1 & 1, i >> 2];
                for axis in 0..3 {
                    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                    for side in 0..2 {
                        let mut beyond = at;
                        beyond[axis] += 2 * side - 1;
                        if has(at) && !has(beyond) {
                            let corner = |du: i64, dv: i64| {
                                let mut c = at;
                                (c[axis], c[u], c[v]) = (c[axis] + side, c[u] + du, c[v] + dv);
                                number(c)
                            };
                            let around = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                            squares.push(if side == 1 {
                                around.to_vec()
                            } else {
                                around.iter().rev().copied().collect()
                            });
                        }
                    }
                }
            }
            let solid = mesh(&vertices, &squares);
            let report = check(&solid, None);
            assert!(!report.defects.has(Category::BoundaryEdge) && !report.defects.has(Category::EdgeOddUse), "{set}");
            // Where two cubes meet in an edge or a vertex alone it shows as that, and else as nothing.
            let counts = report.counts.expect("in range");
            assert!(!counts.closed || counts.volume == Some(Rational::from(set.count_ones())), "{set}");
        }
    }

    #[test]
    fn an_even_number_is_not_enough() {
        assert_eq!(uses(&lamina()), BTreeSet::from([2]));
        assert_eq!(counts(&lamina()).volume, Some(Rational::new()));
    }
}

mod me_51 {
    use super::*;

    #[test]
    fn an_edge_of_the_list_that_no_polygon_uses_is_told_and_one_used_once_is_open() {
        let edges: Vec<[u32; 2]> = polygons_at(&cube()).into_keys().chain([[0, 6]]).collect();
        let listed = ListedEdges::new(edges, None).expect("no faces");
        let report = check(&cube(), Some(&listed));
        assert!(
            report
                .defects
                .iter()
                .map(|(c, e)| (c, e.clone()))
                .eq([(Category::EdgeUnreferenced, BTreeSet::from([Element::Record(12)]))])
        );
        let open = without(&cube(), |i| i == 2);
        let once: Vec<Element> = check(&open, None).defects.of(Category::BoundaryEdge).cloned().collect();
        assert_eq!(once, [[0, 1], [0, 4], [1, 5], [4, 5]].map(Element::Edge));
    }
}

mod me_52 {
    use super::*;

    /// b₁ over ℤ/2 of a connected complex of discs: b₂ is the dimension of the space of sets of faces with an even number at
    /// each edge, and χ = 1 − b₁ + b₂.
    fn b1(mesh: &VertexList) -> i64 {
        let at = polygons_at(mesh);
        let closed = |set: &u32| at.values().all(|faces| faces.iter().filter(|i| set >> **i & 1 == 1).count() % 2 == 0);
        let cycles = (0..1_u32 << mesh.faces.len()).filter(closed).count();
        1 + i64::from(cycles.ilog2()) - counts(mesh).chi
    }

    #[test]
    fn a_simply_connected_mesh_has_an_edge_with_four_uses_and_a_torus_has_none() {
        let cubes = cubes_at_edge();
        assert_eq!((uses(&cubes), b1(&cubes)), (BTreeSet::from([2, 4]), 0));
        assert_eq!(printed_failures(&cubes), ["at most two"]);
        assert_eq!((uses(&torus()), b1(&torus())), (BTreeSet::from([2]), 2));
    }
}

mod me_54 {
    use super::*;

    #[test]
    fn every_proper_part_of_a_connected_surface_has_an_edge_used_once() {
        for whole in [cube(), tetrahedron(), bipyramid([0, 0, 2]), projective_plane()] {
            let n = whole.faces.len();
            for set in 1_u32..(1 << n) - 1 {
                assert!(uses(&without(&whole, |i| set >> i & 1 == 1)).contains(&1));
            }
        }
        let open = without(&cube(), |i| i == 0);
        assert_eq!(categories(&open), [Category::BoundaryEdge]);
    }

    #[test]
    fn a_missing_wall_and_a_missing_component_do_not_show() {
        let without_wall = without(&tetrahedra_with_wall(), |i| i == 6);
        assert_eq!(uses(&without_wall), BTreeSet::from([2]));
        let mut two = tetrahedron();
        two.vertices.extend(tetrahedron().vertices.into_iter().map(|v| v + &rational([[5, 1], [0, 1], [0, 1]])));
        two.faces
            .extend(tetrahedron().faces.iter().map(|f| Face::new(f.outer.iter().map(|v| v + 4).collect::<Vec<_>>())));
        assert_eq!(counts(&two).components, 2);
        assert_eq!(uses(&without(&two, |i| i >= 4)), BTreeSet::from([2]));
    }

    #[test]
    fn an_edge_used_once_need_not_be_a_gap() {
        let cracked = cube_with_vertex_in_edge();
        assert_eq!(categories(&cracked), [Category::BoundaryEdge, Category::TJunction]);
        // Every face of the cube is there, point for point.
        let area = |mesh: &VertexList, i: usize| {
            projected_areas(mesh.faces[i].outer.iter().map(|v| &mesh.vertices[*v as usize]))
        };
        assert!((0..6).all(|i| area(&cracked, i) == area(&cube(), i)));
    }
}

mod me_56 {
    use super::*;

    #[test]
    fn a_sound_torus_uses_two_edges_twice_in_one_polygon() {
        let keyholes = box_with_keyholes();
        let twice: Vec<Element> = check(&keyholes, None).defects.of(Category::EdgeTwiceInSameFace).cloned().collect();
        assert_eq!(twice, [[0, 8], [4, 12]].map(Element::Edge));
        assert!(counts(&keyholes).manifold);
        // The same solid without bridges: the same χ, volume and genus.
        let tunnel = counts(&box_with_tunnel());
        let keyholes = counts(&keyholes);
        assert_eq!((tunnel.chi, tunnel.genus, tunnel.volume), (keyholes.chi, keyholes.genus, keyholes.volume));
    }
}

mod me_59 {
    use super::*;

    #[test]
    fn an_edge_that_names_one_polygon_more_is_told() {
        let at = polygons_at(&tetrahedron());
        let (edges, mut faces): (Vec<[u32; 2]>, Vec<Vec<u32>>) =
            at.iter().map(|(edge, faces)| (*edge, faces.iter().map(|f| *f as u32).collect())).unzip();
        let told = |faces: &Vec<Vec<u32>>| {
            let listed = ListedEdges::new(edges.clone(), Some(faces.clone())).expect("as many");
            check(&tetrahedron(), Some(&listed))
                .defects
                .of(Category::EdgeFaceNotReciprocal)
                .cloned()
                .collect::<Vec<_>>()
        };
        assert_eq!(told(&faces), []);
        let at = faces.iter().position(|faces| !faces.contains(&0)).expect("face 0 has three edges of six");
        faces[at].push(0);
        // No polygon references an edge that does not reference it.
        let printed = polygons_at(&tetrahedron())
            .iter()
            .zip(&faces)
            .all(|((_, using), said)| using.iter().all(|f| said.contains(&(*f as u32))));
        assert!(printed);
        assert_eq!(told(&faces), [Element::Record(at)]);
        faces[at] = vec![faces[at][0]];
        assert_eq!(told(&faces), [Element::Record(at)]);
    }

    #[test]
    fn lists_of_different_length_are_refused() {
        let error = ListedEdges::new(vec![[0, 1]], Some(vec![])).expect_err("none for one");
        assert_eq!((error.expected, error.found), (1, 0));
    }
}
