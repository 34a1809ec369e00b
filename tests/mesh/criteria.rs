//! ME-48 … ME-50, ME-53, ME-55, ME-57, ME-58, ME-73, ME-74: the other criteria, and what they all let pass.

use super::printed_criteria::*;
use super::specimens::*;
use isoracle::linear::Vector;
use isoracle::mesh::defects::{Category, Element, ListedEdges, check};
use isoracle::mesh::examples::{cube, mesh, tetrahedron};
use isoracle::mesh::face::Face;
use isoracle::mesh::plane::projected_areas;
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::number::Rational;
use std::collections::BTreeSet;

mod me_48 {
    use super::*;

    #[test]
    fn fewer_than_three_vertices_have_no_area_and_three_have_one_unless_collinear() {
        let grid: Vec<Point> = (0..27).map(|i| Vector([i % 3, i / 3 % 3, i / 9].map(Rational::from))).collect();
        assert_eq!(projected_areas([]), Vector::zero());
        for a in &grid {
            assert_eq!(projected_areas([a]), Vector::zero());
            for b in &grid {
                assert_eq!(projected_areas([a, b]), Vector::zero());
                for c in grid.iter().step_by(4) {
                    let line = super::super::naive_check::on_a_line(&[a.clone(), b.clone(), c.clone()]);
                    assert_eq!(projected_areas([a, b, c]) == Vector::zero(), line);
                }
            }
        }
    }

    #[test]
    fn a_loop_of_two_is_told() {
        let mut with = cube();
        with.faces.push(Face::new([0, 6]));
        let report = check(&with, None);
        assert!(report.defects.of(Category::FaceLt3Vertices).eq([&Element::Face(6)]));
    }
}

mod me_49 {
    use super::*;

    #[test]
    fn read_implicitly_an_explicit_closure_is_a_repeated_vertex() {
        let explicit = mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[vec![0, 1, 2, 0], vec![0, 2, 1, 0]]);
        let found = categories(&explicit);
        assert!(found.contains(&Category::RepeatedVertexInLoop) && found.contains(&Category::DegenerateEdgeSameIndex));
        assert_eq!(uses(&explicit), uses(&lamina()));
        let area = |mesh: &VertexList| projected_areas(mesh.faces[0].outer.iter().map(|v| &mesh.vertices[*v as usize]));
        assert_eq!(area(&explicit), area(&lamina()));
    }

    #[test]
    fn every_loop_comes_back() {
        for (name, mesh) in all() {
            for face in &mesh.faces {
                let position = |v: u32| mesh.vertices[v as usize].clone();
                let sum = face.sides().fold(Vector::zero(), |sum, [a, b]| sum + &(position(b) - &position(a)));
                assert_eq!(sum, Vector::zero(), "{name}");
            }
        }
    }
}

mod me_50 {
    use super::*;

    #[test]
    fn each_face_of_the_cube_may_be_two_triangles_on_either_diagonal() {
        for choice in 0..64 {
            let halves = |(i, face): (usize, &Face)| match face.outer[..] {
                [a, b, c, d] if choice >> i & 1 == 0 => [Face::new([a, b, c]), Face::new([a, c, d])],
                [a, b, c, d] => [Face::new([b, c, d]), Face::new([b, d, a])],
                _ => panic!("a square"),
            };
            let triangles = VertexList { faces: cube().faces.iter().enumerate().flat_map(halves).collect(), ..cube() };
            assert_eq!(categories(&triangles), []);
            let counts = counts(&triangles);
            assert_eq!((counts.vertices, counts.edges, counts.faces, counts.chi), (8, 18, 12, 2));
            assert_eq!(counts.volume, Some(Rational::from(1)));
        }
    }
}

mod me_53 {
    use super::*;

    #[test]
    fn loops_of_three_or_more_vertices_without_repetition_always_have_it() {
        let mut told = 0;
        for i in 0..3_u32.pow(4) * 4 {
            let outer: Vec<u32> = [i % 3, i / 3 % 3, i / 9 % 3, i / 27 % 3][..(i / 81 + 1) as usize].to_vec();
            let sound = outer.len() >= 3 && outer.iter().collect::<BTreeSet<_>>().len() == outer.len();
            let one = mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], std::slice::from_ref(&outer));
            let is_told = categories(&one).contains(&Category::VertexLt2Edges);
            assert!(!(is_told && sound), "{outer:?}");
            told += i32::from(is_told);
        }
        assert!(told > 0);
    }

    #[test]
    fn a_dead_end_is_told() {
        let spike = mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [3, 3, 0]], &[vec![0, 1, 3, 1, 2]]);
        assert!(check(&spike, None).defects.of(Category::VertexLt2Edges).eq([&Element::Vertex(3)]));
    }
}

mod me_55 {
    use super::*;

    #[test]
    fn a_corner_out_of_the_plane_by_a_hair_is_told() {
        let hair = 1_000_000_000_000_000_000;
        let mut bent = cube();
        bent.vertices[6] = rational([[1, 1], [1, 1], [1 + hair, hair]]);
        let report = check(&bent, None);
        // The top; the walls at that corner stay plane.
        assert!(report.defects.of(Category::NonplanarFace).eq([&Element::Face(1)]));
        assert_eq!(printed_failures(&bent), ["plane"]);
    }

    #[test]
    fn a_hole_may_leave_the_plane_of_a_triangle() {
        let mut holed = tetrahedron();
        holed.faces[0].holes.push(vec![3, 1, 0]);
        assert!(check(&holed, None).defects.of(Category::NonplanarFace).eq([&Element::Face(0)]));
    }
}

mod me_57 {
    use super::*;

    #[test]
    fn an_isolated_vertex_is_told_and_not_counted() {
        let mut with = cube();
        with.vertices.push(rational([[7, 1], [7, 1], [7, 1]]));
        assert!(check(&with, None).defects.of(Category::IsolatedVertex).eq([&Element::Vertex(8)]));
        assert_eq!(counts(&with), counts(&cube()));
        assert_eq!(with.vertices.len() + counts(&with).faces - counts(&with).edges, 3);
        assert_eq!(printed_failures(&with), ["in a polygon"]);
    }
}

mod me_58 {
    use super::*;

    #[test]
    fn an_edge_is_of_length_zero_only_if_its_ends_are_at_one_position() {
        let moved = |x: [i64; 2]| {
            let mut moved = tetrahedron();
            moved.vertices[1] = rational([x, [0, 1], [0, 1]]);
            moved
        };
        assert!(check(&moved([0, 1]), None).defects.of(Category::ZeroLengthEdge).eq([&Element::Edge([0, 1])]));
        assert_eq!(printed_failures(&moved([0, 1])), ["length"]);
        assert_eq!(categories(&moved([1, 1_000_000_000_000_000])), []);
    }
}

mod me_73 {
    use super::*;

    #[test]
    fn no_path_goes_along_every_edge_of_the_cube_once() {
        // Depth first over all trails of the cube from vertex 0; by symmetry from any.
        let edges: Vec<[u32; 2]> = polygons_at(&cube()).into_keys().collect();
        fn longest(edges: &[[u32; 2]], at: u32, used: u32) -> u32 {
            let next = (0..edges.len()).filter(|i| used >> i & 1 == 0 && edges[*i].contains(&at));
            next.map(|i| 1 + longest(edges, edges[i][0] + edges[i][1] - at, used | 1 << i)).max().unwrap_or(0)
        }
        assert_eq!((longest(&edges, 0, 0), edges.len()), (9, 12));
        let odd = |v: &u32| edges.iter().filter(|edge| edge.contains(v)).count() % 2 == 1;
        assert_eq!((0..8).filter(odd).count(), 8);
    }

    #[test]
    fn without_holes_faces_connect_what_edges_connect_and_with_holes_more() {
        for (name, mesh) in all() {
            let holes = mesh.faces.iter().any(|face| !face.holes.is_empty());
            assert_eq!(counts(&mesh).components, 1, "{name}");
            assert_eq!(edges_connect(&mesh), !holes, "{name}");
        }
        assert!(check(&box_with_pocket(), None).defects.is_empty());
    }
}

mod me_74 {
    use super::*;

    /// The meshes that pass, with all that is wrong with them.
    fn passing() -> Vec<(VertexList, Vec<Category>)> {
        let mut flipped = cube();
        flipped.faces[0] = flipped.faces[0].reversed();
        let turned = VertexList { faces: tetrahedron().faces.iter().map(Face::reversed).collect(), ..tetrahedron() };
        vec![
            (flipped, vec![Category::InconsistentWindingEdge]),
            (projective_plane(), vec![Category::InconsistentWindingEdge, Category::NonOrientable]),
            (turned, vec![Category::InsideOut]),
            (lamina(), vec![Category::DuplicateFace, Category::ZeroVolume]),
            (pinched_bipyramid(), vec![Category::DuplicateVertexPosition]),
            (tetrahedron_with_flat_face(), vec![Category::ZeroAreaFace, Category::TJunction]),
            (bow_tie_prism(2), vec![Category::SelfCrossingLoop]),
            (bow_tie_prism(1), vec![Category::ZeroSignedAreaFace, Category::SelfCrossingLoop, Category::ZeroVolume]),
            (prisms_on_figure_eight(), vec![Category::RepeatedVertexInLoop]),
            (bipyramid_with_vertex_in_edge(), vec![Category::TJunction]),
            (tetrahedra_at_vertex(), vec![Category::NonmanifoldVertex]),
        ]
    }

    #[test]
    fn each_passes_every_printed_criterion_and_is_broken() {
        for (mesh, broken) in passing() {
            assert_eq!(printed_failures(&mesh), [""; 0], "{broken:?}");
            assert_eq!(categories(&mesh), broken);
        }
    }

    #[test]
    fn what_the_printed_criteria_see_is_told_under_another_name() {
        // Over all small specimens, with a face dropped or not: printed failures are defects or a lack of connection.
        for (name, whole) in all() {
            for missing in 0..=whole.faces.len() {
                let mesh = without(&whole, |i| i == missing);
                let printed: Vec<_> = printed_failures(&mesh).into_iter().filter(|c| *c != "connected").collect();
                assert!(printed.is_empty() || !categories(&mesh).is_empty(), "{name}: {printed:?}");
            }
        }
    }

    #[test]
    fn an_edge_twice_in_its_list_passes() {
        let at = polygons_at(&tetrahedron());
        let records = at.iter().chain(at.iter().take(1));
        let (edges, faces): (Vec<[u32; 2]>, Vec<Vec<u32>>) =
            records.map(|(edge, faces)| (*edge, faces.iter().map(|f| *f as u32).collect())).unzip();
        let listed = ListedEdges::new(edges, Some(faces)).expect("as many");
        let report = check(&tetrahedron(), Some(&listed));
        let found: Vec<_> = report.defects.iter().map(|(category, elements)| (category, elements.clone())).collect();
        assert_eq!(found, [(Category::DuplicateEdgeRecord, BTreeSet::from([Element::Edge([0, 1])]))]);
    }

    /// Whether a segment goes through the inside of a triangle: its ends are on different sides of the triangle's plane, and
    /// the line turns about the three sides in one sense.
    fn pierces([p, q]: [&Point; 2], [a, b, c]: [&Point; 3]) -> bool {
        let volume = |a: &Point, b: &Point, c: &Point, d: &Point| {
            (b.clone() - a).cross(&(c.clone() - a)).dot(&(d.clone() - a)).cmp0() as i32
        };
        let turns = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
        volume(a, b, c, p) * volume(a, b, c, q) < 0 && (turns == [1; 3] || turns == [-1; 3])
    }

    #[test]
    fn faces_that_cut_each_other_pass_this_check_too() {
        let crossing = crossing_bipyramid();
        assert_eq!((printed_failures(&crossing), categories(&crossing)), (vec![], vec![]));
        let point = |v: u32| &crossing.vertices[v as usize];
        let pierced = |mesh: &VertexList| {
            let edges = polygons_at(mesh).into_keys().collect::<Vec<_>>();
            let faces = mesh.faces.iter().map(|face| [face.outer[0], face.outer[1], face.outer[2]]);
            faces
                .flat_map(|f| edges.iter().map(move |e| (*e, f)))
                .filter(|(e, f)| pierces(e.map(point), f.map(point)))
                .count()
        };
        assert!(pierced(&crossing) > 0);
    }
}
