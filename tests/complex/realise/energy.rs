//! The energy: exact differences, motions, scales, and what minimisation does.

use super::domain::{cross_polytope, grid_torus, simplex_boundary, twice};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::realise::energy::Energy;
use isoracle::complex::realise::mesh::{MeshError, NotSimplicial, TetrahedralMesh};
use isoracle::complex::realise::points::{Points, PointsError};
use isoracle::complex::realise::{Options, RealiseError, realise};
use isoracle::number::Rational;
use proptest::prelude::*;

fn q(p: i64, d: i64) -> Rational {
    Rational::from((p, d))
}

fn energy(mesh: &TetrahedralMesh, bending: f64) -> Energy {
    Energy::new(mesh, bending).expect("a weight")
}

/// A mesh of each kind: simplicial, with many edges between two vertices, with loops.
fn meshes() -> Vec<TetrahedralMesh> {
    let torus = ClosedComplex::new(three_torus()).expect("a closed complex");
    let lens = ClosedComplex::new(lens_space(3, 1)).expect("a closed complex");
    let coarse = TetrahedralMesh::of(&torus.tetrahedra());
    assert!(coarse.edges().iter().any(|[v, w]| v == w));
    let uneven = twice(lens_space(1, 0));
    vec![simplex_boundary(), cross_polytope(), coarse, TetrahedralMesh::of(&lens.barycentric()), uneven]
}

/// Rationals that are small binary64 too.
fn placement(numbers: usize) -> impl Strategy<Value = Vec<f64>> {
    let entry = prop_oneof![2 => (-8..=8_i32).prop_map(|n| f64::from(n) / 4.0), 1 => -2.0..2.0_f64];
    prop::collection::vec(entry, numbers)
}

fn exact(x: &[f64]) -> Vec<Rational> {
    x.iter().map(|x| Rational::from_f64(*x).expect("finite")).collect()
}

fn moved(x: &[Rational], h: &[Rational], t: i64) -> Vec<Rational> {
    x.iter().zip(h).map(|(x, h)| x + h * Rational::from(t)).collect()
}

/// A case: the number of a mesh, n, β, a placement and a direction, of which as much is used as the mesh needs.
type Case = (usize, usize, f64, Vec<f64>, Vec<f64>);

fn case() -> impl Strategy<Value = Case> {
    let weight = prop_oneof![Just(0.0), Just(0.25), 0.0..2.0_f64];
    (0..5_usize, 3..=5_usize, weight, placement(200), placement(200))
}

fn used((kind, n, bending, x, h): Case) -> (TetrahedralMesh, usize, f64, Vec<f64>, Vec<f64>) {
    let mesh = meshes().swap_remove(kind);
    let length = (mesh.vertices() * n).min(x.len());
    assert_eq!(length, mesh.vertices() * n);
    (mesh, n, bending, x[..length].to_vec(), h[..length].to_vec())
}

/// The definition once more, a vertex and its edges at a time.
fn by_vertices(mesh: &TetrahedralMesh, bending: &Rational, x: &[Rational], n: usize) -> Rational {
    let at = |v: u32| &x[n * v as usize..n * (v as usize + 1)];
    let square = |u: &[Rational]| u.iter().fold(Rational::new(), |sum, u| sum + Rational::from(u.square_ref()));
    let minus =
        |a: &[Rational], b: &[Rational]| a.iter().zip(b).map(|(a, b)| Rational::from(a - b)).collect::<Vec<_>>();
    let (mut twice_uniformity, mut bent) = (Rational::new(), Rational::new());
    for v in 0..mesh.vertices() as u32 {
        let ends = mesh.edges().iter().flat_map(|[a, b]| [[*a, *b], [*b, *a]]).filter(|[a, _]| *a == v);
        let neighbours: Vec<u32> = ends.map(|[_, b]| b).collect();
        for w in &neighbours {
            let deviation: Rational = square(&minus(at(*w), at(v))) - 1_u32;
            twice_uniformity += deviation.square();
        }
        let others: Vec<u32> = neighbours.into_iter().filter(|w| *w != v).collect();
        if let Some(count) = Some(others.len()).filter(|count| *count > 0) {
            let mean: Vec<Rational> =
                (0..n).map(|i| others.iter().fold(Rational::new(), |sum, w| sum + &at(*w)[i]) / count as u32).collect();
            bent += square(&minus(&mean, at(v)));
        }
    }
    twice_uniformity / (2 * mesh.edges().len() as u32) + bent * bending / mesh.vertices() as u32
}

mod cx_81 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn it_is_the_sum_over_the_vertices(case in case()) {
            let (mesh, n, bending, x, _) = used(case);
            let energy = energy(&mesh, bending);
            let (at, weight) = (exact(&x), exact(&[bending]).remove(0));
            let value = energy.exact(&at, n);
            prop_assert_eq!(&value, &by_vertices(&mesh, &weight, &at, n));
            prop_assert!(value >= 0);
            let rounded = energy.value(&x, n);
            prop_assert!((rounded - value.to_f64()).abs() <= 1e-12 * (1.0 + value.to_f64()));
        }

        #[test]
        fn motions_do_not_change_it(case in case(), p in -5..=5_i64, d in 1..=5_i64, shift in -9..=9_i64) {
            let (mesh, n, bending, x, _) = used(case);
            let energy = energy(&mesh, bending);
            let x = exact(&x);
            // The rotation by the angle whose half has the tangent p/d, in the first and the last axis, then a translation; and a mirror.
            let t = q(p, d);
            let sum: Rational = 1 + Rational::from(t.square_ref());
            let scale = sum.recip();
            let (c, s) = ((1 - Rational::from(t.square_ref())) * &scale, t * Rational::from(2) * &scale);
            let (mut turned, mut mirrored) = (x.clone(), x.clone());
            for (point, at) in turned.chunks_exact_mut(n).zip(x.chunks_exact(n)) {
                point[0] = Rational::from(&c * &at[0]) - Rational::from(&s * &at[n - 1]) + q(shift, 7);
                point[n - 1] = Rational::from(&s * &at[0]) + Rational::from(&c * &at[n - 1]);
            }
            mirrored.chunks_exact_mut(n).for_each(|point| point[1] = -point[1].clone());
            let value = energy.exact(&x, n);
            prop_assert_eq!(&energy.exact(&turned, n), &value);
            prop_assert_eq!(&energy.exact(&mirrored, n), &value);
        }
    }

    #[test]
    fn weights_are_finite_and_not_negative() {
        for wrong in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(Energy::new(&simplex_boundary(), wrong).is_none());
            let options = Options { bending: wrong, ..Options::default() };
            assert!(matches!(realise(&simplex_boundary(), &options), Err(RealiseError::Bending(_))));
        }
    }
}

mod cx_82 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// p(t) = E(x + t·h) has degree 4, so five values give p′(0) exactly.
        #[test]
        fn the_gradient_is_what_exact_differences_say(case in case()) {
            let (mesh, n, bending, x, h) = used(case);
            let energy = energy(&mesh, bending);
            let (at, along) = (exact(&x), exact(&h));
            let p = |t: i64| energy.exact(&moved(&at, &along, t), n);
            let slope = (p(-2) - p(2) + Rational::from(8) * (p(1) - p(-1))) / 12_u32;
            let gradient = energy.exact_gradient(&at, n);
            let product = gradient.iter().zip(&along).fold(Rational::new(), |sum, (g, h)| sum + Rational::from(g * h));
            prop_assert_eq!(product, slope);
            // Taylor's fifth difference of a quartic is 0: the values themselves are those of one polynomial.
            let fifth = p(3) - 5 * p(2) + 10 * p(1) - 10 * p(0) + 5 * p(-1) - p(-2);
            prop_assert_eq!(fifth, 0);
            let size = gradient.iter().fold(1.0_f64, |max, g| max.max(g.to_f64().abs()));
            for (rounded, g) in energy.gradient(&x, n).iter().zip(&gradient) {
                prop_assert!((rounded - g.to_f64()).abs() <= 1e-12 * size, "{} {}", rounded, g.to_f64());
            }
        }
    }
}

mod cx_83 {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// E(s·x) is a polynomial A − 2Bs² + Cs⁴ with C ≥ 0: least at s² = B/C, and at 0 where B < 0.
        #[test]
        fn no_scale_is_better(case in case()) {
            let (mesh, n, bending, x, _) = used(case);
            let energy = energy(&mesh, bending);
            let at = exact(&x);
            let scaled = |s: &Rational| energy.exact(&at.iter().map(|x| Rational::from(x * s)).collect::<Vec<_>>(), n);
            let (zero, one, two) = (scaled(&q(0, 1)), scaled(&q(1, 1)), scaled(&q(2, 1)));
            // one − zero = C − 2B, two − zero = 16C − 8B.
            let c = (Rational::from(&two - &zero) - Rational::from(4) * Rational::from(&one - &zero)) / 12_u32;
            let b = (Rational::from(&c - &one) + &zero) / 2_u32;
            let s = energy.best_scale(&x, n);
            if c == 0 {
                prop_assert_eq!(s, 1.0);
            } else if b <= 0 {
                prop_assert!(s.abs() < 1e-7);
            } else {
                let best = Rational::from(&b / &c).to_f64().sqrt();
                prop_assert!((s - best).abs() <= 1e-7 * best.max(1.0), "{s} {best}");
            }
        }
    }

    #[test]
    fn one_place_has_no_scale() {
        assert_eq!(energy(&simplex_boundary(), 1.0).best_scale(&[0.5; 20], 4), 1.0);
    }
}

mod cx_87 {
    use super::*;

    /// E − E_min = 1/10 Σ (q − 1 + 5β/16)² over the squared lengths q of the ten edges.
    #[test]
    fn the_boundary_of_the_simplex_ends_regular() {
        for (bending, n, seed) in [(0.0, 4, 1), (0.1, 4, 2), (0.5, 4, 3), (0.1, 5, 4), (0.1, 6, 5)] {
            let options = Options { bending, dimension: n, seed, ..Options::default() };
            let ended = realise(&simplex_boundary(), &options).expect("a placement");
            let x = ended.points.exact();
            let shrunk = Rational::from(1) - exact(&[bending]).remove(0) * q(5, 16);
            let squares = ended.mesh.edges().iter().map(|[v, w]| {
                (0..n).fold(Rational::new(), |sum, i| {
                    sum + Rational::from(&x[n * *v as usize + i] - &x[n * *w as usize + i]).square()
                })
            });
            let mut above = Rational::new();
            for square in squares {
                assert!((Rational::from(&square - &shrunk)).to_f64().abs() < 1e-6, "β {bending}, n {n}: {square}");
                above += Rational::from(&square - &shrunk).square() / 10_u32;
            }
            let least = Rational::from(1) - Rational::from(shrunk.square_ref());
            assert_eq!(energy(&ended.mesh, bending).exact(&x, n), least + above);
            assert!(ended.intersections.is_embedded());
        }
    }
}

mod cx_90 {
    use super::*;

    #[test]
    fn the_energy_never_rises_and_the_seed_decides() {
        for (mesh, n) in [(cross_polytope(), 4), (grid_torus([3, 3, 3]), 4), (grid_torus([3, 3, 3]), 5)] {
            let options = Options { dimension: n, iterations: 60, keep_embedded: false, ..Options::default() };
            let ended = realise(&mesh, &options).expect("a placement");
            assert!(ended.energies.windows(2).all(|pair| pair[1] < pair[0]), "{:?}", ended.energies);
            assert!(ended.energies.len() > 2 && ended.energies.len() <= 61);
            let value = energy(&mesh, options.bending).exact(&ended.points.exact(), n).to_f64();
            assert!((value - ended.energies.last().expect("a start")).abs() < 1e-12);
            assert_eq!(realise(&mesh, &options).expect("a placement"), ended);
            let other = realise(&mesh, &Options { seed: 2, ..options }).expect("a placement");
            assert_ne!(other.points, ended.points);
        }
    }

    #[test]
    fn the_sphere_unfolds_from_its_smoothest_functions() {
        let sphere =
            realise(&twice(lens_space(1, 0)), &Options { iterations: 40, ..Options::default() }).expect("a placement");
        assert!(sphere.lengths.min > 0.3 && sphere.lengths.max < 3.0, "{:?}", sphere.lengths);
    }

    #[test]
    fn what_cannot_be_placed_is_refused() {
        let options = |dimension| Options { dimension, ..Options::default() };
        for n in [0, 1, 2, 7] {
            assert_eq!(realise(&simplex_boundary(), &options(n)), Err(RealiseError::Dimension(n)));
        }
        let nothing = TetrahedralMesh::of_tetrahedra(0, &[]).expect("no tetrahedra");
        assert_eq!(realise(&nothing, &options(4)), Err(RealiseError::Empty));
        let stray = TetrahedralMesh::of_tetrahedra(4, &[[0, 1, 2, 4]]);
        assert_eq!(stray, Err(MeshError::NoSuchVertex { tetrahedron: 0, vertex: 4 }));
        let twice = TetrahedralMesh::of_tetrahedra(4, &[[0, 1, 2, 3], [0, 1, 2, 1]]);
        assert_eq!(twice, Err(MeshError::VertexTwice { tetrahedron: 1, vertex: 1 }));
        assert_eq!(Points::new(0, vec![]), Err(PointsError::Shape { dimension: 0, coordinates: 0 }));
        assert_eq!(Points::new(3, vec![0.0; 4]), Err(PointsError::Shape { dimension: 3, coordinates: 4 }));
        assert_eq!(Points::new(2, vec![0.0, 0.0, 0.0, f64::NAN]), Err(PointsError::NotFinite { point: 1, axis: 1 }));
    }

    #[test]
    fn a_complex_of_one_vertex_is_placed_and_called_no_simplicial_complex() {
        let torus = ClosedComplex::new(three_torus()).expect("a closed complex");
        for mesh in [TetrahedralMesh::of(&torus.tetrahedra()), TetrahedralMesh::of(&torus.barycentric())] {
            let placed = realise(&mesh, &Options::default()).expect("a placement");
            assert!(!placed.intersections.is_embedded());
            assert!(placed.intersections.not_simplicial.is_some());
        }
        let coarse = TetrahedralMesh::of(&torus.tetrahedra());
        assert_eq!(coarse.not_simplicial(), Some(NotSimplicial::VertexTwice { tetrahedron: 0 }));
        let barycentric = TetrahedralMesh::of(&torus.barycentric());
        assert!(
            matches!(barycentric.not_simplicial(), Some(NotSimplicial::SameVertices { vertices }) if vertices.len() == 2)
        );
    }
}
