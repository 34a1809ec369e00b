//! Gauss–Bonnet for plane polygons with holes: ME-120.

mod me_120 {
    use isoracle::linear::Vector;
    use isoracle::mesh::angle_deficit::{AngleMesh, GaussBonnet, PolygonAngleMesh, PolygonError};
    use isoracle::mesh::examples::{cube, mesh, point, tetrahedron};
    use isoracle::mesh::face::Face;
    use isoracle::mesh::vertex_list::{Point, VertexList};
    use isoracle::number::{Interval, Rational, Ring};
    use proptest::prelude::*;

    fn q(n: i64, d: i64) -> Rational {
        Rational::from((n, d))
    }

    fn angles(mesh: &VertexList) -> PolygonAngleMesh {
        PolygonAngleMesh::new(mesh).expect("plane polygons")
    }

    fn refused(mesh: &VertexList) -> Option<PolygonError> {
        PolygonAngleMesh::new(mesh).err()
    }

    /// A polygon in the plane z = 0.
    fn flat(corners: &[[i64; 2]]) -> VertexList {
        let corners: Vec<[i64; 3]> = corners.iter().map(|[x, y]| [*x, *y, 0]).collect();
        mesh(&corners, &[(0..corners.len() as u32).collect::<Vec<u32>>()])
    }

    /// The prism over a polygon that is given counterclockwise, perhaps with a hole, clockwise, in the same list.
    fn prism(corners: &[[i64; 2]], outer: u32) -> VertexList {
        let n = corners.len() as u32;
        let at = |z: i64| corners.iter().map(move |[x, y]| point([*x, *y, z]));
        let hole = |first: u32| if outer < n { vec![(first + outer..first + n).collect()] } else { Vec::new() };
        let top = Face { outer: (n..n + outer).collect(), holes: hole(n) };
        let bottom = Face { outer: (0..outer).collect(), holes: hole(0) }.reversed();
        let around = |from: u32, to: u32| {
            (from..to).map(move |i| {
                let j = if i + 1 == to { from } else { i + 1 };
                Face::from([i, j, j + n, i + n])
            })
        };
        let sides = around(0, outer).chain(around(outer, n));
        VertexList { vertices: at(0).chain(at(3)).collect(), faces: [top, bottom].into_iter().chain(sides).collect() }
    }

    const L: [[i64; 2]; 6] = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
    const FRAME: [[i64; 2]; 8] = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [1, 3], [3, 3], [3, 1]];

    fn over_pi(mesh: &PolygonAngleMesh, n: u32) -> Vec<Option<Rational>> {
        (0..n).map(|v| mesh.curvature(v).over_pi()).collect()
    }

    #[test]
    fn prisms_have_it_with_reflex_corners_and_with_holes() {
        let half = Some(q(1, 2));
        let (box_, l, frame) = (angles(&cube()), angles(&prism(&L, 6)), angles(&prism(&FRAME, 4)));
        assert_eq!(box_.total_curvature(), GaussBonnet { half_turns: 4, chi: 2 });
        assert_eq!(over_pi(&box_, 8), vec![half.clone(); 8]);
        assert_eq!(angles(&tetrahedron()).total_curvature(), GaussBonnet { half_turns: 4, chi: 2 });
        assert_eq!(l.total_curvature(), GaussBonnet { half_turns: 4, chi: 2 });
        let inner = |v: usize| if v % 6 == 3 { Some(q(-1, 2)) } else { half.clone() };
        assert_eq!(over_pi(&l, 12), (0..12).map(inner).collect::<Vec<_>>());
        // V − E + F − H = 16 − 24 + 10 − 2: a torus.
        assert_eq!(frame.total_curvature(), GaussBonnet { half_turns: 0, chi: 0 });
        let sign = |v: usize| if v % 8 < 4 { half.clone() } else { Some(q(-1, 2)) };
        assert_eq!(over_pi(&frame, 16), (0..16).map(sign).collect::<Vec<_>>());
    }

    #[test]
    fn a_hole_is_outside_whichever_way_it_is_wound_and_so_is_a_face_turned_over() {
        for turned in 0..8 {
            let mut frame = prism(&FRAME, 4);
            for (face, bit) in [(0, 1), (1, 2)] {
                if turned & bit != 0 {
                    frame.faces[face].holes[0].reverse();
                }
            }
            if turned & 4 != 0 {
                frame.faces[0] = frame.faces[0].reversed();
            }
            assert_eq!(angles(&frame).total_curvature(), GaussBonnet { half_turns: 0, chi: 0 });
            assert_eq!(over_pi(&angles(&frame), 16), over_pi(&angles(&prism(&FRAME, 4)), 16));
        }
    }

    #[test]
    fn a_flat_face_turns_on_its_border_and_a_straight_corner_does_not() {
        let plate = angles(&flat(&[[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]]));
        assert_eq!(plate.total_curvature(), GaussBonnet { half_turns: 2, chi: 1 });
        assert_eq!(over_pi(&plate, 5), [q(1, 2), q(0, 1), q(1, 2), q(1, 2), q(1, 2)].map(Some));
        // A comb, a spiral.
        for corners in [
            &[[0, 0], [6, 0], [6, 3], [5, 1], [4, 3], [3, 1], [2, 3], [1, 1], [0, 3]][..],
            &[
                [0, 0],
                [9, 0],
                [9, 9],
                [2, 9],
                [2, 4],
                [5, 4],
                [5, 6],
                [4, 6],
                [4, 5],
                [3, 5],
                [3, 8],
                [8, 8],
                [8, 1],
                [0, 1],
            ],
        ] {
            let back: Vec<[i64; 2]> = corners.iter().rev().copied().collect();
            for wound in [corners, &back] {
                assert_eq!(angles(&flat(wound)).total_curvature(), GaussBonnet { half_turns: 2, chi: 1 });
            }
        }
    }

    #[test]
    fn faces_without_angles_are_refused() {
        let square = [[0, 0], [2, 0], [2, 2], [0, 2]];
        let error = |corners: &[[i64; 2]]| refused(&flat(corners));
        assert_eq!(error(&square), None);
        assert_eq!(error(&[]), Some(PolygonError::NoArea { face: 0 }));
        assert_eq!(error(&square[..2]), Some(PolygonError::NoArea { face: 0 }));
        assert_eq!(error(&[[0, 0], [1, 1], [2, 2], [5, 5]]), Some(PolygonError::NoArea { face: 0 }));
        let figure_eight = [[0, 0], [2, 2], [2, 0], [0, 3]];
        assert_eq!(error(&figure_eight), Some(PolygonError::Turns { face: 0, turns: 0 }));
        let pentagram = [[0, 3], [-2, -3], [3, 1], [-3, 1], [2, -3]];
        assert_eq!(error(&pentagram), Some(PolygonError::Turns { face: 0, turns: 2 }));
        assert_eq!(error(&[[0, 0], [2, 0], [2, 0], [0, 2]]), Some(PolygonError::NoAngle { face: 0, vertex: 1 }));
        assert_eq!(error(&[[0, 0], [3, 0], [2, 0], [0, 2]]), Some(PolygonError::NoAngle { face: 0, vertex: 1 }));
        let bent = mesh(&[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]], &[[0, 1, 2, 3]]);
        assert!(matches!(refused(&bent), Some(PolygonError::NotPlanar { face: 0, .. })));
        let beyond = mesh(&[[0, 0, 0], [1, 0, 0], [1, 1, 1]], &[[0, 1, 2], [0, 1, 3]]);
        assert_eq!(refused(&beyond), Some(PolygonError::IndexOutOfRange { face: 1 }));
        let mut frame = prism(&FRAME, 4);
        frame.faces[1].holes[0].truncate(2);
        assert_eq!(refused(&frame), Some(PolygonError::NoArea { face: 1 }));
        let mut high = prism(&FRAME, 4);
        high.faces[0].holes[0][0] = 4;
        assert_eq!(refused(&high), Some(PolygonError::NotPlanar { face: 0, vertex: 4 }));
    }

    /// The turning number by another count: how often the direction of the sides passes that of (1000, 1), to the left
    /// less to the right, each turn being less than half a one.
    fn passes(corners: &[[i64; 2]]) -> i64 {
        let n = corners.len();
        let side = |i: usize| [0, 1].map(|k| corners[(i + 1) % n][k] - corners[i % n][k]);
        let cross = |a: [i64; 2], b: [i64; 2]| a[0] * b[1] - a[1] * b[0];
        let dot = |a: [i64; 2], b: [i64; 2]| a[0] * b[0] + a[1] * b[1];
        let ray = [1000, 1];
        // A turn from a to b, less than half a one, passes the ray iff a and b are on both sides of it and it is between
        // them: seen from a, the ray on the side that b is.
        (0..n)
            .map(|i| {
                let (a, b) = (side(i), side(i + 1));
                match (cross(ray, a).signum(), cross(ray, b).signum()) {
                    (-1, 1) if cross(a, b) > 0 => 1,
                    (1, -1) if cross(a, b) < 0 => -1,
                    (s, t) => {
                        assert!(s != 0 && t != 0 && (cross(a, b) != 0 || dot(a, b) > 0));
                        0
                    }
                }
            })
            .sum()
    }

    fn area(corners: &[[i64; 2]]) -> i64 {
        let n = corners.len();
        (0..n).map(|i| corners[i][0] * corners[(i + 1) % n][1] - corners[i][1] * corners[(i + 1) % n][0]).sum()
    }

    /// A tilted copy: (x, y) in the plane of two rational vectors.
    fn tilted(mesh: &VertexList) -> VertexList {
        let [u, v] = [[3, 1, 2], [-1, 5, 1]].map(point);
        let at = |Vector([x, y, _]): &Point| u.scaled(x) + &v.scaled(y);
        VertexList { vertices: mesh.vertices.iter().map(at).collect(), faces: mesh.faces.clone() }
    }

    proptest! {
        #[test]
        fn any_closed_loop_turns_as_often_as_its_direction_passes_a_ray(
            corners in prop::collection::vec(prop::array::uniform2(-4_i64..=4), 3..12)
        ) {
            let outcome = PolygonAngleMesh::new(&tilted(&flat(&corners)));
            match outcome.as_ref().err() {
                Some(PolygonError::NoArea { .. }) => prop_assert_eq!(area(&corners), 0),
                Some(PolygonError::NoAngle { vertex, .. }) => {
                    let n = corners.len();
                    let [a, v, b] = [n - 1, 0, 1].map(|step| corners[(*vertex as usize + step) % n]);
                    let [p, r] = [a, b].map(|u| [u[0] - v[0], u[1] - v[1]]);
                    prop_assert!(p[0] * r[1] == p[1] * r[0] && p[0] * r[0] + p[1] * r[1] >= 0);
                }
                // The normal is on the side from which the area is positive.
                Some(PolygonError::Turns { turns, .. }) => {
                    prop_assert_eq!(passes(&corners) * area(&corners).signum(), *turns);
                    prop_assert_ne!(*turns, 1);
                }
                Some(PolygonError::IndexOutOfRange { .. } | PolygonError::NotPlanar { .. }) => prop_assert!(false),
                None => {
                    prop_assert_eq!(passes(&corners) * area(&corners).signum(), 1);
                    let mesh = outcome.expect("just asked");
                    prop_assert_eq!(mesh.total_curvature(), GaussBonnet { half_turns: 2, chi: 1 });
                    // Measured, not proved.
                    let enclosures = (0..corners.len() as u32).map(|v| mesh.curvature(v).enclosure(200));
                    let sum = enclosures.fold(Interval::integer(0), |sum, k| sum + &k);
                    let rest = sum - &(Interval::pi(200) * &Interval::integer(2));
                    prop_assert!(rest.contains(&Rational::new()));
                    prop_assert!(rest.width().expect("finite") < Rational::from((1, 1_i64 << 62)));
                }
            }
        }

        /// Cut into triangles around a corner that sees all others, each face keeps what it gives to each vertex.
        #[test]
        fn cut_into_triangles_a_convex_prism_keeps_every_curvature(
            heights in prop::collection::vec(1_i64..=20, 3..9), offset in prop::array::uniform2(-5_i64..=5)
        ) {
            // Sides of growing slope make a convex polygon.
            let mut corners = vec![[0, 0]];
            for (k, step) in heights.iter().enumerate() {
                let [x, y] = corners[k];
                corners.push([x + step, y + step * (k as i64 - 4) * 3]);
            }
            let mut prism = prism(&corners, corners.len() as u32);
            // Shorn, so that the angles are no right ones; the faces stay plane.
            for vertex in &mut prism.vertices {
                let z = vertex.0[2].clone();
                vertex.0[0] += z.clone() * offset[0];
                vertex.0[1] += z * offset[1];
            }
            let fan = |face: &Face| {
                let v = face.outer.clone();
                (1..v.len() - 1).map(move |i| [v[0], v[i], v[i + 1]])
            };
            let triangles = prism.faces.iter().flat_map(fan).collect();
            let cut = AngleMesh::new(prism.vertices.clone(), triangles).expect("convex faces");
            let whole = angles(&prism);
            prop_assert_eq!(whole.total_curvature(), GaussBonnet { half_turns: 4, chi: 2 });
            for v in 0..prism.vertices.len() as u32 {
                let (a, b) = (whole.curvature(v), cut.curvature(v));
                prop_assert_eq!(a.over_pi(), b.over_pi());
                let difference = a.enclosure(200) - &b.enclosure(200);
                prop_assert!(difference.contains(&Rational::new()));
                prop_assert!(difference.width().expect("finite") < Rational::from((1, 1_i64 << 62)));
            }
        }
    }
}
