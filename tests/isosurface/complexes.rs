//! IS-1 … IS-8: cells, simplices, complexes.

use isoracle::linear::{Matrix, Vector, determinant};
use isoracle::mesh::cells::{Cell, CellComplex, CellError, CellId, Walk};
use isoracle::mesh::realisation::{
    GeometricComplex, GeometricDefect, affine_dependency, are_affinely_independent, hull_coefficients,
};
use isoracle::mesh::simplicial::{Simplex, SimplexError, SimplicialComplex, face_count};
use isoracle::number::Rational;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn point<const N: usize>(coordinates: [i64; N]) -> Vector<Rational, N> {
    Vector(coordinates.map(Rational::from))
}

/// The subsets of k elements of 0 … n−1.
fn choices(n: usize, k: usize) -> impl Iterator<Item = Vec<usize>> {
    let sets = (0u32..1 << n).filter(move |set| set.count_ones() as usize == k);
    sets.map(move |set| (0..n).filter(|i| set >> i & 1 == 1).collect())
}

/// Independence by Gram's determinant of the differences to the first point, for up to five points.
fn independent_by_gram<const N: usize>(points: &[Vector<Rational, N>]) -> bool {
    let edges: Vec<_> = points[1..].iter().map(|p| p.clone() - &points[0]).collect();
    let gram = |i: usize, j: usize| edges[i].dot(&edges[j]);
    let volume = match edges.len() {
        0 => Rational::from(1),
        1 => determinant::<_, 1>(&Matrix::from_fn(gram)),
        2 => determinant::<_, 2>(&Matrix::from_fn(gram)),
        3 => determinant::<_, 3>(&Matrix::from_fn(gram)),
        4 => determinant::<_, 4>(&Matrix::from_fn(gram)),
        n => panic!("{n} edges"),
    };
    volume != 0
}

fn complex<const K: usize>(simplices: &[[u32; K]]) -> SimplicialComplex {
    SimplicialComplex::from_vertices(simplices).expect("simplices")
}

mod is_1 {
    use super::*;

    fn sphere(belt: impl Fn([CellId; 2], [CellId; 2]) -> Vec<Cell>) -> CellComplex {
        let [v, w, e, f] = [0, 1, 2, 3].map(CellId);
        let circle = |edge| Walk::Edges(vec![(edge, true)]);
        let mut cells = vec![Cell::Vertex, Cell::Vertex, Cell::Edge([v, v]), Cell::Edge([w, w])];
        cells.extend([Cell::Disc(circle(e)), Cell::Disc(circle(f))]);
        cells.extend(belt([v, w], [e, f]));
        CellComplex::new(cells).expect("a sphere")
    }

    #[test]
    fn with_an_annulus_as_a_cell_the_count_is_not_the_characteristic_of_the_sphere() {
        let annulus = sphere(|_, [e, f]| vec![Cell::Annulus([e, f].map(|edge| Walk::Edges(vec![(edge, true)])))]);
        let [vertices, edges, faces] = annulus.counts();
        assert_eq!([vertices, edges, faces], [2, 2, 3]);
        assert_eq!(faces - edges + vertices, 3);
        assert_eq!(annulus.euler_characteristic(), 2);
    }

    #[test]
    fn an_edge_across_the_annulus_makes_it_a_ball_and_the_count_right() {
        let cut = sphere(|[v, w], [e, f]| {
            let across = CellId(6);
            let walk = [(e, true), (across, true), (f, true), (across, false)];
            vec![Cell::Edge([v, w]), Cell::Disc(Walk::Edges(walk.to_vec()))]
        });
        let [vertices, edges, faces] = cut.counts();
        assert_eq!([vertices, edges, faces], [2, 3, 3]);
        assert_eq!(faces - edges + vertices, 2);
        assert_eq!(cut.euler_characteristic(), 2);
    }

    #[test]
    fn the_map_need_not_be_injective_on_the_border() {
        // A sphere of one point and one disc, a torus of one point, two loops and one disc.
        let sphere = CellComplex::new(vec![Cell::Vertex, Cell::Disc(Walk::Constant(CellId(0)))]).expect("a sphere");
        assert_eq!(sphere.euler_characteristic(), 2);
        let [v, a, b] = [0, 1, 2].map(CellId);
        let walk = Walk::Edges(vec![(a, true), (b, true), (a, false), (b, false)]);
        let torus = CellComplex::new(vec![Cell::Vertex, Cell::Edge([v, v]), Cell::Edge([v, v]), Cell::Disc(walk)]);
        assert_eq!(torus.expect("a torus").euler_characteristic(), 0);
    }
}

mod is_2 {
    use super::*;

    #[test]
    fn two_edges_of_a_circle_have_two_points_in_common() {
        let [v, w] = [0, 1].map(CellId);
        let circle = CellComplex::new(vec![Cell::Vertex, Cell::Vertex, Cell::Edge([v, w]), Cell::Edge([w, v])]);
        let circle = circle.expect("a circle");
        let common = circle.common_border(CellId(2), CellId(3));
        assert_eq!(common, BTreeSet::from([v, w]));
        assert!(!circle.is_one_closed_cell(&common));
        assert_eq!(circle.euler_characteristic(), 0);
    }

    #[test]
    fn two_triangles_of_a_square_have_their_diagonal_in_common() {
        let [v, w, x, y] = [0, 1, 2, 3].map(CellId);
        let sides = [[v, w], [w, x], [x, v], [x, y], [y, w]];
        let walk = |ids: [(usize, bool); 3]| Cell::Disc(Walk::Edges(ids.map(|(id, way)| (CellId(id), way)).to_vec()));
        let mut cells = vec![Cell::Vertex; 4];
        cells.extend(sides.map(Cell::Edge));
        cells.extend([walk([(4, true), (5, true), (6, true)]), walk([(5, true), (7, true), (8, true)])]);
        let square = CellComplex::new(cells).expect("a square");
        let common = square.common_border(CellId(9), CellId(10));
        assert_eq!(common, BTreeSet::from([w, x, CellId(5)]));
        assert!(square.is_one_closed_cell(&common));
        // A triangle and its side have the closed side in common.
        assert_eq!(square.common_border(CellId(9), CellId(5)), common);
        assert_eq!(square.euler_characteristic(), 1);
    }

    #[test]
    fn in_a_simplicial_complex_two_simplices_have_one_simplex_or_nothing_in_common() {
        let with_faces = |s: &Simplex| (0..=s.dimension()).flat_map(|k| s.faces(k)).collect::<BTreeSet<_>>();
        let all: Vec<Simplex> = (1..=4)
            .flat_map(|k| choices(6, k))
            .map(|c| Simplex::new(&c.iter().map(|i| *i as u32).collect::<Vec<_>>()))
            .collect::<Result<_, _>>()
            .expect("simplices");
        for a in &all {
            for b in &all {
                let common: BTreeSet<_> = with_faces(a).intersection(&with_faces(b)).cloned().collect();
                let is_one = common.iter().any(|s| with_faces(s) == common);
                assert!(common.is_empty() || is_one, "{a:?} {b:?}");
            }
        }
    }
}

mod is_3 {
    use super::*;

    #[test]
    fn a_segment_and_its_ends_are_disjoint_as_open_cells_only() {
        let [v, w, e] = [0, 1, 2].map(CellId);
        let segment = CellComplex::new(vec![Cell::Vertex, Cell::Vertex, Cell::Edge([v, w])]).expect("a segment");
        assert_eq!(segment.border(e), BTreeSet::from([v, w]));
        assert_eq!(segment.euler_characteristic(), 1);
        // Read with closed cells, the segment meets each of its ends.
        for end in [v, w] {
            assert_eq!(segment.common_border(e, end), BTreeSet::from([end]));
        }
    }

    #[test]
    fn a_border_is_a_union_of_cells_of_smaller_dimension() {
        let [v, e, f] = [0, 1, 2].map(CellId);
        let disc = |walk| vec![Cell::Vertex, Cell::Edge([v, v]), Cell::Disc(Walk::Edges(walk))];
        assert!(CellComplex::new(disc(vec![(e, true)])).is_ok());
        let wrong = |cell, through| Err(CellError::Border { cell, through });
        assert_eq!(CellComplex::new(disc(vec![(f, true)])), wrong(f, f));
        assert_eq!(CellComplex::new(disc(vec![(v, true)])), wrong(f, v));
        assert_eq!(CellComplex::new(vec![Cell::Vertex, Cell::Edge([v, e])]), wrong(e, e));
        assert_eq!(CellComplex::new(disc(Vec::new())), Err(CellError::Open(f)));
        let w = CellId(1);
        let path = vec![Cell::Vertex, Cell::Vertex, Cell::Edge([v, w]), Cell::Disc(Walk::Edges(vec![(f, true)]))];
        assert_eq!(CellComplex::new(path), Err(CellError::Open(CellId(3))));
    }
}

mod is_4 {
    use super::*;

    #[test]
    fn no_three_aligned_and_no_four_coplanar_is_too_weak_for_the_pentachoron() {
        let points = [[0, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 1, 1, 0]].map(point);
        for k in [2, 3, 4] {
            for chosen in choices(5, k) {
                let chosen: Vec<_> = chosen.into_iter().map(|i| points[i].clone()).collect();
                assert!(are_affinely_independent(&chosen), "as printed, {k} points");
            }
        }
        assert!(!are_affinely_independent(&points), "no simplex of dimension 4");
        assert!(!independent_by_gram(&points));
        let last = points.map(|Vector([x, y, z, _])| Vector([x, y, z]));
        assert!(are_affinely_independent(&last[..4]), "of dimension 3");
    }

    #[test]
    fn up_to_dimension_3_the_parenthesis_says_that_the_points_are_affinely_independent() {
        // All sets of 4 points of {0,1,2}³; aligned and coplanar by integers.
        let all: Vec<[i64; 3]> = (0..27).map(|n| [n % 3, n / 3 % 3, n / 9]).collect();
        let minus = |a: [i64; 3], b: [i64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
        let cross = |a: [i64; 3], b: [i64; 3]| [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i]);
        for chosen in choices(27, 4) {
            let p: [[i64; 3]; 4] = std::array::from_fn(|i| all[chosen[i]]);
            let aligned = choices(4, 3).any(|t| cross(minus(p[t[1]], p[t[0]]), minus(p[t[2]], p[t[0]])) == [0; 3]);
            let normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
            let coplanar = (0..3).map(|i| normal[i] * (p[3][i] - p[0][i])).sum::<i64>() == 0;
            assert_eq!(are_affinely_independent(&p.map(point)), !aligned && !coplanar, "{p:?}");
        }
    }

    proptest! {
        #[test]
        fn a_dependency_is_one_and_there_is_none_iff_grams_determinant_is_not_zero(
            points in prop::collection::vec(prop::array::uniform4(-2i64..=2), 1..=5)
        ) {
            let points: Vec<_> = points.into_iter().map(point).collect();
            match affine_dependency(&points) {
                None => prop_assert!(independent_by_gram(&points)),
                Some(coefficients) => {
                    prop_assert!(!independent_by_gram(&points));
                    let terms = points.iter().zip(&coefficients);
                    let sum = terms.fold(Vector::zero(), |sum, (p, x)| sum + &p.scaled(x));
                    prop_assert_eq!(sum, Vector::zero());
                    prop_assert_eq!(coefficients.iter().fold(Rational::new(), |sum, x| sum + x), 0);
                    prop_assert!(coefficients.iter().any(|x| *x != 0));
                }
            }
        }
    }
}

mod is_5 {
    use super::*;

    /// Twice the area of a, b, c.
    fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    #[test]
    fn in_the_plane_the_hull_is_the_intersection_of_the_half_planes_with_the_points_in_them() {
        let lattice: Vec<[i64; 2]> = (0..9).map(|n| [2 * (n % 3), 2 * (n / 3)]).collect();
        for chosen in choices(9, 3).chain(choices(9, 4)) {
            let points: Vec<[i64; 2]> = chosen.iter().map(|&i| lattice[i]).collect();
            if points[2..].iter().all(|p| turn(points[0], points[1], *p) == 0) {
                continue;
            }
            let exact: Vec<_> = points.iter().map(|p| point(*p)).collect();
            for p in (0..49).map(|n| [n % 7 - 1, n / 7 - 1]) {
                let outside = points.iter().any(|a| {
                    points.iter().any(|b| a != b && points.iter().all(|c| turn(*a, *b, *c) >= 0) && turn(*a, *b, p) < 0)
                });
                let coefficients = hull_coefficients(&exact, &point(p));
                assert_eq!(coefficients.is_none(), outside, "{p:?} in {points:?}");
            }
        }
    }

    proptest! {
        #[test]
        fn a_point_of_the_hull_is_reached_by_segments_between_points_that_every_convex_set_has(
            points in prop::collection::vec(prop::array::uniform3(-3i64..=3), 1..=6),
            weights in prop::collection::vec(0i64..=3, 6),
        ) {
            // A planted point, as a convex combination.
            let points: Vec<_> = points.into_iter().map(point).collect();
            let weights = &weights[..points.len()];
            let total: i64 = weights.iter().sum();
            prop_assume!(total > 0);
            let terms = points.iter().zip(weights);
            let sum = terms.fold(Vector::zero(), |sum, (p, w)| sum + &p.scaled(&Rational::from(*w)));
            let planted = sum.scaled(&Rational::from((1, total)));
            let coefficients = hull_coefficients(&points, &planted).expect("a convex combination is in the hull");
            prop_assert!(coefficients.iter().all(|x| *x >= 0));
            prop_assert!(coefficients.iter().filter(|x| **x > 0).count() <= 4, "Carathéodory");
            // From point to point along segments: the share of each is its coefficient by the sum so far.
            let mut reached: Option<(Vector<Rational, 3>, Rational)> = None;
            for (p, x) in points.iter().zip(&coefficients).filter(|(_, x)| **x > 0) {
                reached = Some(match reached {
                    None => (p.clone(), x.clone()),
                    Some((at, sum)) => {
                        let sum = sum + x;
                        let share = Rational::from(x / &sum);
                        prop_assert!(share > 0 && share < 1);
                        (at.clone() + &(p.clone() - &at).scaled(&share), sum)
                    }
                });
            }
            prop_assert_eq!(reached, Some((planted, Rational::from(1))));
        }
    }
}

mod is_6 {
    use super::*;

    proptest! {
        #[test]
        fn the_facets_of_a_simplex_are_simplices_of_one_dimension_less(
            points in prop::collection::vec(prop::array::uniform4(-2i64..=2), 2..=5)
        ) {
            let points: Vec<_> = points.into_iter().map(point).collect();
            prop_assume!(independent_by_gram(&points));
            let d = points.len() - 1;
            let simplex = Simplex::new(&(0..=d as u32).collect::<Vec<_>>()).expect("a simplex");
            let facets = simplex.faces(d - 1);
            prop_assert_eq!(facets.len(), d + 1);
            for facet in facets {
                prop_assert_eq!(facet.dimension(), d - 1);
                prop_assert!(simplex.has_face(&facet) && facet != simplex);
                let corners: Vec<_> = facet.vertices().iter().map(|&v| points[v as usize].clone()).collect();
                prop_assert!(are_affinely_independent(&corners) && independent_by_gram(&corners));
            }
        }
    }

    #[test]
    fn vertices_that_repeat_are_no_simplex() {
        assert_eq!(Simplex::new(&[]), Err(SimplexError::Empty));
        assert_eq!(Simplex::new(&[3, 1, 3]), Err(SimplexError::Repeated(3)));
        assert_eq!(Simplex::new(&(0..17).collect::<Vec<_>>()), Err(SimplexError::TooMany(17)));
        assert_eq!(Simplex::new(&[3, 1, 2]).expect("a triangle").vertices(), [1, 2, 3]);
    }
}

mod is_7 {
    use super::*;

    /// C(n, k) by Pascal's triangle.
    fn choose(n: u32, k: u32) -> u64 {
        match (n, k) {
            (_, 0) => 1,
            (0, _) => 0,
            (n, k) => choose(n - 1, k - 1) + choose(n - 1, k),
        }
    }

    #[test]
    fn the_faces_counted_one_by_one_are_as_corrected_and_never_as_printed_at_k_0() {
        for d in 0..=8u32 {
            let simplex = Simplex::new(&(0..=d).collect::<Vec<_>>()).expect("a simplex");
            let f = SimplicialComplex::new([simplex.clone()]).f_vector();
            for k in 0..=d {
                let (printed, correct) = (choose(d, k), choose(d + 1, k + 1));
                let counted = simplex.faces(k as usize).into_iter().collect::<BTreeSet<_>>().len() as u64;
                assert_eq!(counted, correct);
                assert_eq!(f[k as usize] as u64, correct);
                assert_eq!(face_count(d, k), correct);
                // C(d+1, k+1) = C(d, k) + C(d, k+1): the printed number is right for k = d only.
                assert_eq!(printed == correct, k == d);
            }
        }
    }

    #[test]
    fn a_segment_has_two_ends_and_a_triangle_three_sides() {
        assert_eq!([choose(1, 0), choose(2, 1)], [1, 2], "printed");
        assert_eq!([face_count(1, 0), face_count(2, 1)], [2, 3]);
    }
}

mod is_8 {
    use super::*;

    /// The common part of two triangles of the plane by clipping the one at the lines of the other: corners,
    /// without repetition.
    fn clipped(a: [[i64; 2]; 3], b: [[i64; 2]; 3]) -> Vec<[Rational; 2]> {
        let exact = |p: [i64; 2]| p.map(Rational::from);
        let turn = |a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]| {
            let d = |p: &[Rational; 2], i: usize| Rational::from(&p[i] - &a[i]);
            d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0)
        };
        let mut b = b.map(exact);
        if turn(&b[0], &b[1], &b[2]) < 0 {
            b.swap(0, 1);
        }
        let mut polygon: Vec<[Rational; 2]> = a.map(exact).to_vec();
        for i in 0..3 {
            let (from, to) = (&b[i], &b[(i + 1) % 3]);
            let mut kept = Vec::new();
            for (j, p) in polygon.iter().enumerate() {
                let q = &polygon[(j + 1) % polygon.len()];
                let (hp, hq) = (turn(from, to, p), turn(from, to, q));
                if hp >= 0 {
                    kept.push(p.clone());
                }
                if (hp > 0 && hq < 0) || (hp < 0 && hq > 0) {
                    let t = &hp / Rational::from(&hp - &hq);
                    kept.push([0, 1].map(|k| Rational::from(&q[k] - &p[k]) * &t + &p[k]));
                }
            }
            polygon = kept;
        }
        polygon.sort();
        polygon.dedup();
        polygon
    }

    #[test]
    fn two_triangles_of_a_lattice_are_a_complex_iff_their_common_part_is_that_of_their_vertices() {
        let lattice: Vec<[i64; 2]> = (0..9).map(|n| [n % 3, n / 3]).collect();
        let positions: Vec<_> = lattice.iter().map(|p| point(*p)).collect();
        let mut valid = 0;
        for (a, b) in choices(9, 3).flat_map(|a| choices(9, 3).map(move |b| (a.clone(), b))) {
            let corners = |t: &[usize]| [0, 1, 2].map(|i| lattice[t[i]]);
            if a >= b || [&a, &b].iter().any(|t| !are_affinely_independent(&corners(t).map(point))) {
                continue;
            }
            let number = |t: &[usize]| [0, 1, 2].map(|i| t[i] as u32);
            let built = GeometricComplex::new(complex(&[number(&a), number(&b)]), positions.clone());
            let common: Vec<_> = a.iter().filter(|i| b.contains(i)).collect();
            let mut expected: Vec<_> = common.iter().map(|&&i| lattice[i].map(Rational::from)).collect();
            expected.sort();
            assert_eq!(built.is_ok(), clipped(corners(&a), corners(&b)) == expected, "{a:?} {b:?}");
            valid += usize::from(built.is_ok());
            let on = |t: &[usize], p: &Vector<Rational, 2>| hull_coefficients(&corners(t).map(point), p);
            for defect in built.err().into_iter().flatten() {
                let GeometricDefect::Improper { point: p, .. } = defect else { panic!("{defect}") };
                let [in_a, in_b] = [&a, &b].map(|t| on(t, &p).expect("a point of both"));
                let in_common =
                    a.iter().zip(in_a).chain(b.iter().zip(in_b)).all(|(i, x)| x == 0 || common.contains(&i));
                assert!(!in_common, "a point of the common face");
            }
        }
        assert!(valid > 100);
    }

    #[test]
    fn a_point_is_in_one_open_simplex_and_in_several_closed_ones() {
        // Two triangles on a common side: read with closed simplices, they are not disjoint.
        let square = [[0, 0], [2, 0], [0, 2], [2, 2]].map(point).to_vec();
        let square = GeometricComplex::new(complex(&[[0, 1, 2], [1, 2, 3]]), square).expect("a complex");
        let middle = point([1, 1]);
        let holds = |s: &Simplex| {
            let corners: Vec<_> =
                s.vertices().iter().map(|&v| point([2 * (v as i64 % 2), 2 * (v as i64 / 2)])).collect();
            hull_coefficients(&corners, &middle)
        };
        let closed = square.complex().simplices().filter(|s| holds(s).is_some()).count();
        let open = square.complex().simplices().filter(|s| holds(s).is_some_and(|x| x.iter().all(|x| *x > 0))).count();
        assert_eq!((closed, open), (3, 1));
        assert_eq!(square.carrier(&middle), Some(Simplex::new(&[1, 2]).expect("the common side")));
        assert_eq!(square.carrier(&point([3, 0])), None);
    }

    #[test]
    fn figure_33_a_vertex_on_a_side_and_a_degenerate_triangle_are_invalid() {
        let positions = [[0, 0], [2, 0], [1, 2], [1, 0], [0, -1], [2, -1], [4, 0]].map(point).to_vec();
        let on_side = GeometricComplex::new(complex(&[[0, 1, 2], [3, 4, 5]]), positions.clone());
        let [GeometricDefect::Improper { point: p, .. }] = &on_side.expect_err("invalid")[..] else { panic!() };
        assert_eq!(*p, point([1, 0]));
        let flat = GeometricComplex::new(complex(&[[0, 1, 6]]), positions.clone()).expect_err("invalid");
        assert_eq!(flat, [GeometricDefect::Degenerate(Simplex::new(&[0, 1, 6]).expect("three vertices"))]);
        let missing = GeometricComplex::new(complex(&[[0, 7]]), positions).expect_err("invalid");
        assert_eq!(missing, [GeometricDefect::NoPosition(7)]);
    }
}
