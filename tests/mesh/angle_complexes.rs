//! Gauss–Bonnet for any triangle complex, with a border, for spheres, and by indices: ME-118, ME-119, ME-121, ME-125.

use isoracle::linear::Vector;
use isoracle::mesh::angle_deficit::{AngleError, AngleMesh, GaussBonnet, multiple_of_pi};
use isoracle::mesh::simplicial::{Simplex, SimplicialComplex};
use isoracle::number::{Enclosure, Interval, Rational, Ring};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

type Point = Vector<Rational, 3>;

const BITS: u32 = 200;

fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

fn point(p: [i64; 3]) -> Point {
    Vector(p.map(Rational::from))
}

/// Points (t, t², t³): no three of them are on one line.
fn moment_curve(n: usize) -> Vec<Point> {
    (0..n as i64).map(|t| point([t, t * t, t * t * t])).collect()
}

fn mesh(positions: Vec<Point>, triangles: &[[u32; 3]]) -> AngleMesh {
    AngleMesh::new(positions, triangles.to_vec()).expect("triangles with area")
}

/// The triples of n numbers.
fn triples(n: u32) -> Vec<[u32; 3]> {
    (0..n).flat_map(|a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| [a, b, c]))).collect()
}

fn chosen(triples: &[[u32; 3]], subset: u32) -> Vec<[u32; 3]> {
    triples.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1).map(|(_, t)| *t).collect()
}

/// |x − expected·π| is provably small, and 0 is possible.
fn is_multiple_of_pi(x: Interval, expected: &Rational) -> bool {
    let rest = x - &(Interval::pi(BITS) * &Interval::from_rational(expected, BITS));
    rest.known_sign().is_none() && rest.width().expect("finite") < Rational::from((1, 1_i64 << 62))
}

fn sum_of_enclosures(mesh: &AngleMesh) -> Interval {
    (0..mesh.vertex_count() as u32).fold(Interval::integer(0), |sum, v| sum + &mesh.curvature(v).enclosure(BITS))
}

const PROJECTIVE_PLANE: [[u32; 3]; 10] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1], [1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];

/// A grid of 3 × 3 squares, each cut in two, its left side glued to its right one and its lower one to its upper one,
/// that backwards: Klein's bottle of 9 vertices.
fn klein_bottle() -> Vec<[u32; 3]> {
    let at = |i: u32, j: u32| if j < 3 { i % 3 + 3 * j } else { (3 - i % 3) % 3 };
    let squares = (0..9).map(|n| (n % 3, n / 3));
    squares
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
            [[a, b, d], [a, d, c]]
        })
        .collect()
}

fn moebius_band() -> Vec<[u32; 3]> {
    (0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]).collect()
}

fn torus() -> Vec<[u32; 3]> {
    (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 2) % 7, (i + 3) % 7]]).collect()
}

fn complex(triangles: &[[u32; 3]]) -> SimplicialComplex {
    SimplicialComplex::from_vertices(triangles).expect("triples of different vertices")
}

/// Positions of which many are nearly on one line: integers, moved by up to 2⁻⁹⁰.
fn positions(n: usize) -> impl Strategy<Value = Vec<Point>> {
    let tiny = (-1_i64..=1, 1_u32..90).prop_map(|(sign, bits)| Rational::from(sign) >> bits);
    let coordinate = (-2_i64..=2, prop_oneof![Just(Rational::new()), tiny]).prop_map(|(n, hair)| hair + n);
    prop::collection::vec(prop::array::uniform3(coordinate).prop_map(Vector), n)
}

mod me_118 {
    use super::*;

    #[test]
    fn all_1024_complexes_of_five_vertices_have_it_and_the_printed_sum_has_it_iff_3_triangles_are_2_edges() {
        let triples = triples(5);
        let (mut as_printed, mut closed) = (0, 0);
        for subset in 0..1 << 10 {
            let triangles = chosen(&triples, subset);
            let mesh = mesh(moment_curve(5), &triangles);
            let vertices: Vec<[u32; 1]> = (0..5).map(|v| [v]).collect();
            let of_triangles = complex(&triangles);
            // χ of the closure, with the vertices of no triangle.
            let loose = vertices.iter().filter(|v| !triangles.iter().flatten().any(|u| *u == v[0])).count() as i64;
            let chi = of_triangles.euler_characteristic() + loose;
            assert_eq!(mesh.total_curvature(), GaussBonnet { half_turns: 2 * chi, chi }, "{triangles:?}");
            // The link's χ is what is taken from two half turns.
            for [v] in &vertices {
                let vertex = Simplex::new(&[*v]).expect("one vertex");
                let link = of_triangles.link(&vertex).euler_characteristic();
                assert_eq!(mesh.curvature(*v).half_turns, 2 - link, "{triangles:?}, {v}");
            }
            let counts = of_triangles.f_vector();
            let count = |d: usize| counts.get(d).copied().unwrap_or(0);
            let printed_holds = mesh.total_deficit_in_half_turns() == 2 * chi;
            assert_eq!(printed_holds, 3 * count(2) == 2 * count(1), "{triangles:?}");
            as_printed += u32::from(printed_holds);
            let is_closed = mesh.gauss_bonnet().is_ok();
            assert!(!is_closed || printed_holds);
            closed += u32::from(is_closed);
        }
        // Closed are the empty one, 5 tetrahedra and 10 double ones; in the other 60, edges of three triangles balance
        // those of one.
        assert_eq!((as_printed, closed), (76, 16));
    }

    proptest! {
        #[test]
        fn any_triangles_on_any_points_have_it(
            positions in positions(7), picks in prop::collection::vec(0_usize..35, 0..12)
        ) {
            // With triangles that stand twice, edges of many triangles, pinched vertices.
            let triples = triples(7);
            let triangles: Vec<[u32; 3]> = picks.iter().map(|i| triples[*i]).collect();
            let mesh = AngleMesh::new(positions, triangles.clone());
            prop_assume!(!matches!(mesh, Err(AngleError::Degenerate { .. })));
            let mesh = mesh.expect("indices in range");
            let edges: BTreeSet<[u32; 2]> =
                triangles.iter().flat_map(|&[a, b, c]| [[a, b], [a, c], [b, c]]).collect();
            let chi = 7 - edges.len() as i64 + triangles.len() as i64;
            prop_assert_eq!(mesh.total_curvature(), GaussBonnet { half_turns: 2 * chi, chi });
            prop_assert!(is_multiple_of_pi(sum_of_enclosures(&mesh), &q(2 * chi, 1)));
        }

        #[test]
        fn surfaces_that_cannot_be_oriented_have_it_wherever_they_lie(positions in positions(9), index in 0_usize..5) {
            let (triangles, chi) = match index {
                0 => (PROJECTIVE_PLANE.to_vec(), 1),
                1 => (klein_bottle(), 0),
                2 => (moebius_band(), 0),
                3 => (torus(), 0),
                _ => ([&PROJECTIVE_PLANE[..], &[[6, 7, 8]]].concat(), 2),
            };
            let n = triangles.iter().flatten().max().expect("a triangle") + 1;
            let mesh = AngleMesh::new(positions[..n as usize].to_vec(), triangles);
            prop_assume!(!matches!(mesh, Err(AngleError::Degenerate { .. })));
            let mesh = mesh.expect("indices in range");
            prop_assert_eq!(mesh.total_curvature(), GaussBonnet { half_turns: 2 * chi, chi });
            prop_assert!(is_multiple_of_pi(sum_of_enclosures(&mesh), &q(2 * chi, 1)));
        }
    }

    #[test]
    fn the_example_surfaces_are_what_they_are_called() {
        for (triangles, is_closed, chi) in [
            (PROJECTIVE_PLANE.to_vec(), true, 1),
            (klein_bottle(), true, 0),
            (torus(), true, 0),
            (moebius_band(), false, 0),
        ] {
            let complex = complex(&triangles);
            assert_eq!(complex.surface_defects().is_empty(), is_closed);
            assert_eq!((complex.euler_characteristic(), complex.component_count()), (chi, 1));
        }
        let bottle = complex(&klein_bottle());
        assert_eq!(bottle.f_vector(), [9, 27, 18]);
        for (triangles, orientable) in [(klein_bottle(), false), (torus(), true), (PROJECTIVE_PLANE.to_vec(), false)] {
            assert_eq!(is_orientable(&triangles), orientable);
        }
    }

    /// Whether one of the 2ⁿ choices of sides is consistent: spread from the first triangle over the edges.
    fn is_orientable(triangles: &[[u32; 3]]) -> bool {
        let directed = |t: &[u32; 3], flip: bool| {
            let [a, b, c] = if flip { [t[0], t[2], t[1]] } else { *t };
            [[a, b], [b, c], [c, a]]
        };
        let mut flips: BTreeMap<usize, bool> = BTreeMap::from([(0, false)]);
        let mut pending = vec![0];
        while let Some(t) = pending.pop() {
            let sides = directed(&triangles[t], flips[&t]);
            for (u, other) in triangles.iter().enumerate().filter(|(u, _)| *u != t) {
                let has = |flip: bool| directed(other, flip).iter().any(|s| sides.contains(&[s[1], s[0]]));
                let flip = match (has(false), has(true)) {
                    (false, false) => continue,
                    (is_right, _) => !is_right,
                };
                match flips.insert(u, flip) {
                    None => pending.push(u),
                    Some(known) if known != flip => return false,
                    Some(_) => {}
                }
            }
        }
        true
    }

    #[test]
    fn curvatures_of_vertices_of_every_kind() {
        // A book of three pages, a loose vertex, a triangle that stands twice.
        let corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [5, 5, 5]].map(point).to_vec();
        let book = mesh(corners.clone(), &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        let over_pi = |mesh: &AngleMesh, v: u32| mesh.curvature(v).over_pi();
        let half_turns: Vec<i64> = (0..6).map(|v| book.curvature(v).half_turns).collect();
        assert_eq!(half_turns, [1, 1, 1, 1, 1, 2]);
        // π(2 − 4 + 3) − 3π/2 at the binding's end of right angles, π − 3π/4 at the other one.
        assert_eq!(over_pi(&book, 0), Some(q(-1, 2)));
        assert_eq!(over_pi(&book, 1), Some(q(1, 4)));
        assert_eq!(over_pi(&book, 5), Some(q(2, 1)));
        let twice = mesh(corners[..4].to_vec(), &[[0, 1, 2], [2, 1, 0]]);
        assert_eq!(over_pi(&twice, 0), Some(q(1, 1)));
        assert_eq!(twice.gauss_bonnet().expect("each edge is in two triangles").chi, 3);
        assert_eq!(mesh(Vec::new(), &[]).total_curvature(), GaussBonnet { half_turns: 0, chi: 0 });
    }

    #[test]
    fn what_has_no_angles_is_refused_and_the_first_such_triangle_is_named() {
        let corners = || [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]].map(point).to_vec();
        let refused = |triangles: &[[u32; 3]]| AngleMesh::new(corners(), triangles.to_vec()).map(drop);
        assert_eq!(refused(&[[0, 1, 3], [0, 1, 4]]), Err(AngleError::IndexOutOfRange { triangle: 1 }));
        assert_eq!(refused(&[[u32::MAX, 0, 0]]), Err(AngleError::IndexOutOfRange { triangle: 0 }));
        for (triangle, vertex) in [([0, 0, 1], 0), ([1, 3, 1], 1), ([3, 1, 1], 1), ([2, 2, 2], 2)] {
            assert_eq!(refused(&[triangle]), Err(AngleError::RepeatedVertex { triangle: 0, vertex }));
        }
        assert_eq!(refused(&[[0, 1, 3], [0, 2, 1], [0, 0, 1]]), Err(AngleError::Degenerate { triangle: 1 }));
        assert_eq!(refused(&[[0, 1, 3], [0, 2, 3]]), Ok(()));
    }
}

mod me_119 {
    use super::*;

    /// Each vertex with the edges at it that are in just one triangle.
    fn border_degrees(triangles: &[[u32; 3]]) -> Option<BTreeMap<u32, usize>> {
        let mut uses: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        for &[a, b, c] in triangles {
            for edge in [[a, b], [a, c], [b, c]] {
                *uses.entry(edge).or_default() += 1;
            }
        }
        let mut degrees = BTreeMap::new();
        for v in uses.iter().filter(|(_, n)| **n == 1).flat_map(|(edge, _)| edge) {
            *degrees.entry(*v).or_default() += 1;
        }
        uses.values().all(|n| *n <= 2).then_some(degrees)
    }

    #[test]
    fn of_all_complexes_of_five_vertices_those_with_no_pinched_border_have_it_and_no_others() {
        let triples = triples(5);
        let (mut surfaces, mut pinched) = (0, 0);
        for subset in 0..1 << 10 {
            let triangles = chosen(&triples, subset);
            let mesh = mesh(moment_curve(5), &triangles);
            let found = mesh.gauss_bonnet_with_border();
            let Some(degrees) = border_degrees(&triangles) else {
                assert!(matches!(found, Err(AngleError::NotASurface { triangles: 3, .. })));
                continue;
            };
            // As the text would have it: 2π inside, π at each vertex of the border, π a triangle.
            let chi = mesh.euler_characteristic();
            let printed = 2 * 5 - degrees.len() as i64 - triangles.len() as i64;
            match degrees.iter().find(|(_, n)| **n > 2) {
                None => {
                    assert_eq!(found, Ok(GaussBonnet { half_turns: printed, chi }));
                    assert_eq!(printed, 2 * chi, "{triangles:?}");
                    surfaces += 1;
                }
                Some((&vertex, &edges)) => {
                    assert_eq!(found, Err(AngleError::PinchedBorder { vertex, edges: edges as u32 }));
                    assert!(printed > 2 * chi, "{triangles:?}");
                    pinched += 1;
                }
            }
        }
        assert_eq!((surfaces, pinched), (283, 105));
    }

    #[test]
    fn two_triangles_at_one_vertex_have_3_pi_by_the_border_rule_and_2_pi_by_links() {
        let triangles = [[0, 1, 2], [0, 3, 4]];
        let mesh = mesh(moment_curve(5), &triangles);
        assert_eq!(mesh.gauss_bonnet_with_border(), Err(AngleError::PinchedBorder { vertex: 0, edges: 4 }));
        assert_eq!(5 - triangles.len(), 3, "π at each of five vertices less π a triangle");
        assert_eq!(mesh.total_curvature(), GaussBonnet { half_turns: 2, chi: 1 });
        assert_eq!(mesh.curvature(0).half_turns, 0);
    }

    #[test]
    fn a_flat_square_turns_by_right_angles_and_a_flat_hexagon_by_sixth_turns() {
        let square = mesh(
            [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0]].map(point).to_vec(),
            &[[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0]],
        );
        for (v, turn) in [(0, q(1, 2)), (1, q(1, 2)), (2, q(1, 2)), (3, q(1, 2)), (4, q(0, 1))] {
            assert_eq!(square.curvature(v).over_pi(), Some(turn));
        }
        let rim = [[1, -1, 0], [1, 0, -1], [0, 1, -1], [-1, 1, 0], [-1, 0, 1], [0, -1, 1]].map(point);
        let hexagon =
            mesh([&rim[..], &[point([0, 0, 0])]].concat(), &(0..6).map(|i| [6, i, (i + 1) % 6]).collect::<Vec<_>>());
        assert!((0..6).all(|v| hexagon.curvature(v).over_pi() == Some(q(1, 3))));
        assert_eq!(hexagon.curvature(6).over_pi(), Some(q(0, 1)));
        assert_eq!(hexagon.gauss_bonnet_with_border(), Ok(GaussBonnet { half_turns: 2, chi: 1 }));
        assert_eq!(hexagon.gauss_bonnet(), Err(AngleError::NotClosed { edge: [0, 1], triangles: 1 }));
    }
}

mod me_121 {
    use super::*;

    #[test]
    fn the_regular_solids_share_4_pi_equally() {
        let tetrahedron = mesh(
            [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(point).to_vec(),
            &[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]],
        );
        let axes = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map(point).to_vec();
        let octahedron = mesh(axes, &(0..8).map(|n| [n & 1, 2 + (n >> 1 & 1), 4 + (n >> 2)]).collect::<Vec<_>>());
        let corners = (0..8).map(|n| point([n & 1, n >> 1 & 1, n >> 2])).collect();
        let squares = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
        let cube = mesh(corners, &squares.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect::<Vec<_>>());
        for (mesh, n) in [(tetrahedron, 4), (octahedron, 6), (cube, 8)] {
            assert_eq!(mesh.gauss_bonnet(), Ok(GaussBonnet { half_turns: 4, chi: 2 }));
            assert!((0..n).all(|v| mesh.curvature(v).over_pi() == Some(q(4, i64::from(n)))));
        }
    }

    /// An icosahedron with 8/5, 21/13 or 987/610 for the golden ratio: its 12 vertices are alike, so each has a twelfth
    /// of 4π, though the angles of most triangles are no rational parts of π. Stretched, it has 4π still.
    #[test]
    fn a_rational_icosahedron_has_a_third_of_pi_at_each_vertex() {
        for g in [q(8, 5), q(21, 13), q(987, 610)] {
            let points: Vec<Point> = (0..12)
                .map(|n| {
                    let one = Rational::from(if n & 1 == 0 { 1 } else { -1 });
                    let g = if n & 2 == 0 { g.clone() } else { -g.clone() };
                    let mut p = [Rational::new(), one, g];
                    p.rotate_right(n / 4);
                    Vector(p)
                })
                .collect();
            // Vertices are joined if they are at an edge's distance: short for a pair of ones, else near it.
            let near = |a: usize, b: usize| (points[a].clone() - &points[b]).norm_squared() < 5;
            let triangles: Vec<[u32; 3]> = triples(12)
                .into_iter()
                .filter(|t| [[0, 1], [0, 2], [1, 2]].iter().all(|[i, j]| near(t[*i] as usize, t[*j] as usize)))
                .collect();
            assert_eq!(triangles.len(), 20);
            let isosceles = |mesh: &AngleMesh| {
                let irrational =
                    |t: &usize| mesh.angles(*t).iter().any(|a| multiple_of_pi(std::slice::from_ref(a)).is_none());
                (0..20).filter(irrational).count()
            };
            let stretched = points.iter().map(|Vector([x, y, z])| Vector([x.clone() * 3, y.clone(), z.clone() / 2]));
            let stretched = mesh(stretched.collect(), &triangles);
            let mesh = mesh(points, &triangles);
            assert_eq!(mesh.gauss_bonnet(), Ok(GaussBonnet { half_turns: 4, chi: 2 }));
            assert_eq!(isosceles(&mesh), 12, "the other eight are equilateral");
            assert!((0..12).all(|v| mesh.curvature(v).over_pi() == Some(q(1, 3))));
            assert!(is_multiple_of_pi(mesh.curvature(7).enclosure(BITS), &q(1, 3)));
            assert_eq!(stretched.gauss_bonnet(), Ok(GaussBonnet { half_turns: 4, chi: 2 }));
            assert!((0..12).all(|v| stretched.curvature(v).over_pi().is_none()));
        }
    }
}

mod me_125 {
    use super::*;

    /// One direction of each of the 48 chambers of the cube's symmetries.
    fn chambers() -> Vec<Point> {
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        orders
            .into_iter()
            .flat_map(|order| {
                (0..8).map(move |signs| point(order.map(|i| if signs >> i & 1 == 0 { 1 << i } else { -(1 << i) })))
            })
            .collect()
    }

    /// The triangles of corners of the unit cube that have no diagonal of the cube for a side.
    fn triangles_of_the_cube() -> Vec<[u32; 3]> {
        let has_diagonal = |&[a, b, c]: &[u32; 3]| [a ^ b, a ^ c, b ^ c].contains(&7);
        triples(8).into_iter().filter(|t| !has_diagonal(t)).collect()
    }

    /// Every side runs along an axis or along the sum or difference of two: a chamber, which is as wide as the others,
    /// has one index. So the mean over the 48 of them is that over all directions.
    fn the_mean_index_is_the_curvature(triangles: &[[u32; 3]]) {
        let corners = (0..8).map(|n| point([n & 1, n >> 1 & 1, n >> 2])).collect();
        let mesh = mesh(corners, triangles);
        let chambers = chambers();
        for v in 0..8 {
            let indices = chambers.iter().map(|direction| mesh.index(v, direction).expect("no side is level"));
            let mean = q(indices.sum(), 48);
            assert_eq!(mesh.curvature(v).over_pi(), Some(mean * 2), "{triangles:?}, {v}");
        }
    }

    #[test]
    fn on_the_cube_the_mean_index_is_the_curvature_for_up_to_two_triangles_and_for_all() {
        let triangles = triangles_of_the_cube();
        assert_eq!(triangles.len(), 32);
        for i in 0..32 {
            for j in i..32 {
                the_mean_index_is_the_curvature(
                    &triangles[i..=j].iter().step_by((j - i).max(1)).copied().collect::<Vec<_>>(),
                );
            }
        }
        the_mean_index_is_the_curvature(&triangles);
    }

    proptest! {
        #[test]
        fn on_the_cube_the_mean_index_is_the_curvature(subset: u32) {
            the_mean_index_is_the_curvature(&chosen(&triangles_of_the_cube(), subset));
        }

        #[test]
        fn the_indices_sum_up_to_chi_in_every_direction(
            picks in prop::collection::vec(0_usize..35, 0..14), direction in prop::array::uniform3(-30_i64..=30)
        ) {
            let triples = triples(7);
            let triangles: Vec<[u32; 3]> = picks.iter().map(|i| triples[*i]).collect();
            let mesh = mesh(moment_curve(7), &triangles);
            let indices: Option<Vec<i64>> = (0..7).map(|v| mesh.index(v, &point(direction))).collect();
            prop_assume!(indices.is_some());
            prop_assert_eq!(indices.expect("just asked").iter().sum::<i64>(), mesh.euler_characteristic());
        }
    }

    #[test]
    fn pits_peaks_slopes_and_saddles() {
        let fan = |heights: [i64; 6]| {
            let rim = [[2, 0], [1, 2], [-1, 2], [-2, 0], [-1, -2], [1, -2]];
            let corners = rim.iter().zip(heights).map(|([x, y], z)| point([*x, *y, z])).chain([point([0, 0, 0])]);
            mesh(corners.collect(), &(0..6).map(|i| [6, i, (i + 1) % 6]).collect::<Vec<_>>())
                .index(6, &point([0, 0, 1]))
        };
        assert_eq!(fan([1; 6]), Some(1));
        assert_eq!(fan([-1; 6]), Some(1));
        assert_eq!(fan([1, 1, 1, -1, -1, -1]), Some(0));
        assert_eq!(fan([1, -1, -1, 1, -1, -1]), Some(-1));
        assert_eq!(fan([1, -1, 1, -1, 1, -1]), Some(-2));
        assert_eq!(fan([1, -1, 0, -1, 1, -1]), None);
        let flat = mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [7, 7, 7]].map(point).to_vec(), &[[0, 1, 2]]);
        assert_eq!(flat.index(0, &point([1, 2, 0])), Some(1));
        assert_eq!(flat.index(0, &point([1, 0, 5])), None);
        assert_eq!(flat.index(3, &point([0, 0, 0])), Some(1), "a vertex of no triangle has no neighbour as high");
    }
}
