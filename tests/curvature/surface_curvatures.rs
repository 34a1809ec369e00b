//! Normal curvature, principal curvatures and directions.

use super::q;
use super::surface_samples::{Jets, change, jets, pair, path, rotation, second, surface};
use isoracle::curvature::chart::{RationalPatch, composition};
use isoracle::curvature::gauss_map::{CurveOnSurface, GaussMap, PrincipalDirections, ShapeOperator};
use isoracle::curvature::implicit_surface;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::{self, FundamentalForms};
use isoracle::curvature::tangent::TangentPlane;
use isoracle::curvature::trigonometric::circle_point;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, OrderedField, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

const ZERO: [i64; 3] = [0, 0, 0];

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

fn operator(s: &Jets) -> ShapeOperator {
    ShapeOperator::new(&FundamentalForms::new(s)).expect("regular")
}

/// The curve on the surface with these derivatives of u and v.
fn curve(s: &Jets, first: &[Rational; 2], second: &[Rational; 2]) -> Option<CurveOnSurface> {
    let curve = s.each_ref().map(|x| composition(x, &path(first, second)));
    CurveOnSurface::new(&curve, &GaussMap::new(s).expect("regular").normal_w)
}

/// z = (k₁x² + k₂y²)/2 at the origin, N = (0, 0, 1).
fn paraboloid(k1: i64, k2: i64) -> Jets {
    let second = [vector([0, 0, k1]), vector(ZERO), vector([0, 0, k2])];
    jets(&vector(ZERO), [&vector([1, 0, 0]), &vector([0, 1, 0])], second.each_ref())
}

fn is_zero(w: &[Rational; 2]) -> bool {
    w.iter().all(|x| x.is_zero())
}

mod cu_91 {
    use super::*;

    proptest! {
        #[test]
        fn kappa_is_that_of_space_curves_and_its_part_along_n_is_normal(s in surface(), w in pair(), x in pair()) {
            let Some(found) = curve(&s, &w, &x) else { prop_assert!(is_zero(&w)); return Ok(()) };
            // κ² = |α′ × α″|²/|α′|⁶
            let alpha = s.each_ref().map(|f| composition(f, &path(&w, &x)));
            let (first, second) = (&found.velocity, Vector(alpha.each_ref().map(|f| f.hessian.0[0][0].clone())));
            let v = first.norm_squared();
            let squared = first.cross(&second).norm_squared() / (Rational::from(v.square_ref()) * &v);
            prop_assert_eq!(&found.kappa_squared(), &squared);
            prop_assert!(found.curvature_vector.dot(first).is_zero());
            // cos²θ = κₙ²/κ² ≤ 1
            let w_squared = FundamentalForms::new(&s).w_squared();
            prop_assert!(found.normal_curvature_w.square() <= squared * w_squared);
        }
    }

    #[test]
    fn a_straight_curve_has_no_normal_and_the_normal_curvature_0() {
        // The line of the cylinder z = y²/2: κ = 0, so that n = κ⁻¹dt/ds is not defined.
        let line = curve(&paraboloid(0, 1), &[q(1, 1), q(0, 1)], &[q(0, 1), q(0, 1)]).expect("regular");
        assert!(line.kappa_squared().is_zero() && line.normal_curvature_w.is_zero());
    }
}

mod cu_92 {
    use super::*;

    proptest! {
        #[test]
        fn it_is_the_signed_length_of_the_projection_on_n(s in surface(), w in pair(), x in pair()) {
            let Some(found) = curve(&s, &w, &x) else { return Ok(()) };
            // κn = (its tangent part) + κₙN with Wκₙ·WN/W² for the latter.
            let plane = TangentPlane::new(&s).expect("regular");
            let n = plane.normal_w();
            let w_squared = n.norm_squared();
            let projection = n.scaled(&Rational::from(&found.normal_curvature_w / &w_squared));
            prop_assert!(plane.coordinates(&(found.curvature_vector.clone() - &projection)).is_ok());
            prop_assert_eq!(
                projection.norm_squared(),
                Rational::from(found.normal_curvature_w.square_ref()) / w_squared
            );
            prop_assert_eq!(Sign::of(projection.dot(&n).cmp0()), Sign::of(found.normal_curvature_w.cmp0()));
        }
    }
}

mod cu_93 {
    use super::*;

    proptest! {
        #[test]
        fn it_keeps_its_sign_with_the_curve_reversed_and_changes_it_with_the_surface(
            s in surface(), w in pair(), x in pair(),
        ) {
            let Some(found) = curve(&s, &w, &x) else { return Ok(()) };
            let back = w.each_ref().map(|x| Rational::from(-x));
            let reversed = curve(&s, &back, &x).expect("regular");
            prop_assert_eq!(&reversed.normal_curvature_w, &found.normal_curvature_w);
            // u and v interchanged turn N over.
            let exchanged = [Jet::variable(1, q(0, 1)), Jet::variable(0, q(0, 1))];
            let turned = s.each_ref().map(|f| composition(f, &exchanged));
            let turned = curve(&turned, &[w[1].clone(), w[0].clone()], &[x[1].clone(), x[0].clone()]).expect("regular");
            prop_assert_eq!(&turned.velocity, &found.velocity);
            prop_assert_eq!(turned.normal_curvature_w, -found.normal_curvature_w);
        }
    }
}

mod cu_94 {
    use super::*;

    proptest! {
        /// For |α′| = 1: σᵤ, σᵥ orthonormal, (u′, v′) on the unit circle.
        #[test]
        fn the_second_form_of_a_unit_tangent_is_the_normal_curvature(
            a in rotation(), parts in [pair(), pair(), pair()], heights in prop::array::uniform3(-3..=3_i64),
            m in -6..=6_i64, x in pair(),
        ) {
            let [u, v, n] = [0, 1, 2].map(|i| a.column(i));
            let bend = |i: usize| u.scaled(&parts[i][0]) + &v.scaled(&parts[i][1]) + &n.scaled(&q(heights[i], 1));
            let s = jets(&vector(ZERO), [&u, &v], [&bend(0), &bend(1), &bend(2)]);
            let unit = circle_point(&q(m, 3));
            let found = curve(&s, &unit, &x).expect("regular");
            prop_assert_eq!(found.velocity.norm_squared(), q(1, 1));
            prop_assert_eq!(operator(&s).second_form_w(&unit), found.normal_curvature_w);
        }

        /// For any other parameter the form is κₙ|α′|².
        #[test]
        fn it_is_divided_by_the_first_form(s in surface(), w in pair(), x in pair()) {
            let found = curve(&s, &w, &x).map(|c| c.normal_curvature_w * c.velocity.norm_squared());
            prop_assert_eq!(found.unwrap_or_default(), operator(&s).second_form_w(&w));
        }
    }
}

mod cu_95 {
    use super::*;

    proptest! {
        #[test]
        fn curves_with_one_tangent_have_one_normal_curvature(
            s in surface(), w in pair(), x in [pair(), pair()], factor in 1..=5_i64,
        ) {
            let [one, other] = [0, 1].map(|i| curve(&s, &w, &x[i]).map(|c| c.normal_curvature_w));
            prop_assert_eq!(&one, &other);
            prop_assert_eq!(&operator(&s).normal_curvature_w(&w), &one);
            let longer = w.each_ref().map(|x| Rational::from(x * -factor));
            prop_assert_eq!(operator(&s).normal_curvature_w(&longer), one);
        }
    }
}

/// Wk₁, Wk₂ with e₁, e₂; at an umbilic two of its directions, orthogonal ones.
fn principal(s: &Jets) -> ([Surd; 2], [[Surd; 2]; 2]) {
    match operator(s).principal_directions() {
        PrincipalDirections::Two { curvatures_w, directions } => (curvatures_w, *directions),
        PrincipalDirections::Umbilic { curvature_w } => {
            let [e, f, _] = FundamentalForms::new(s).first;
            let k = Surd::from(curvature_w);
            let directions = [[q(1, 1), q(0, 1)], [-f, e]].map(|d| d.map(Surd::from));
            ([k.clone(), k], directions)
        }
    }
}

mod cu_96 {
    use super::*;

    proptest! {
        #[test]
        fn an_orthogonal_basis_has_dn_e_equal_minus_k_e(s in surface()) {
            let (curvatures, directions) = principal(&s);
            let operator = operator(&s);
            prop_assert_eq!(operator.inner_product(&directions[0], &directions[1]), Surd::integer(0));
            let matrix = operator.matrix_w();
            for (k, e) in curvatures.iter().zip(&directions) {
                prop_assert!(operator.inner_product(e, e) > Surd::integer(0));
                for i in 0..2 {
                    let row = &matrix.0[i];
                    let image = Surd::from(row[0].clone()) * &e[0] + &(Surd::from(row[1].clone()) * &e[1]);
                    prop_assert_eq!(image, e[i].clone() * k);
                }
            }
        }
    }
}

mod cu_97 {
    use super::*;

    proptest! {
        #[test]
        fn principal_curvatures_are_the_extremes_of_normal_curvature(s in surface(), w in pair()) {
            let ([k1, k2], directions) = principal(&s);
            let operator = operator(&s);
            if let Some(k) = operator.normal_curvature_w(&w).map(Surd::from) {
                prop_assert!(k2 <= k && k <= k1);
            }
            for (k, e) in [k1, k2].iter().zip(&directions) {
                prop_assert_eq!(operator.second_form_of_surds_w(e), operator.inner_product(e, e) * k);
            }
        }
    }

    #[test]
    fn curvature_itself_has_no_maximum() {
        // In the plane, (t, nt²/2) has the curvature n at 0, and every normal curvature is 0.
        for n in 0..50 {
            let parabola = curve(&paraboloid(0, 0), &[q(1, 1), q(0, 1)], &[q(0, 1), q(n, 1)]).expect("regular");
            assert_eq!((parabola.kappa_squared(), parabola.normal_curvature_w), (q(n * n, 1), q(0, 1)));
        }
    }
}

mod cu_98 {
    use super::*;

    proptest! {
        /// The lines of curvature: (eF − fE)a² + (eG − gE)ab + (fG − gF)b² = 0, an equation for vectors.
        #[test]
        fn principal_directions_are_eigenvectors(s in surface()) {
            let FundamentalForms { first: [ee, ff, gg], second_w: [e, f, g], .. } = FundamentalForms::new(&s);
            let times = |a: &Rational, b: &Rational| Rational::from(a * b);
            let coefficients =
                [times(&e, &ff) - times(&f, &ee), times(&e, &gg) - times(&g, &ee), times(&f, &gg) - times(&g, &ff)].map(Surd::from);
            let (_, directions) = principal(&s);
            for [a, b] in directions {
                let terms = [a.clone() * &a, a * &b, b.clone() * &b];
                let sum = terms.iter().zip(&coefficients).fold(Surd::integer(0), |sum, (x, c)| sum + &(x.clone() * c));
                prop_assert_eq!(sum, Surd::integer(0));
            }
        }
    }

    #[test]
    fn eigenvalues_are_numbers() {
        // z = x² − y²: the eigenvalues of −dN are 2 and −2, the directions (1, 0) and (0, 1).
        let PrincipalDirections::Two { curvatures_w, directions } = operator(&paraboloid(2, -2)).principal_directions()
        else {
            panic!("a saddle is no umbilic");
        };
        assert_eq!(curvatures_w, [2, -2].map(Surd::integer));
        assert_eq!(directions[0][1], Surd::integer(0));
        assert_eq!(directions[1][0], Surd::integer(0));
        assert_ne!([&directions[0][0], &directions[1][1]], [&Surd::integer(0); 2]);
    }
}

mod cu_99 {
    use super::*;

    proptest! {
        #[test]
        fn umbilics_are_where_the_second_form_is_a_multiple_of_the_first(s in surface(), w in pair()) {
            let FundamentalForms { first, second_w, .. } = FundamentalForms::new(&s);
            let minor =
                |i: usize, j: usize| Rational::from(&first[i] * &second_w[j]) - Rational::from(&first[j] * &second_w[i]);
            let proportional = [minor(0, 1), minor(0, 2), minor(1, 2)].iter().all(|x| x.is_zero());
            let surface = parametric_surface::curvature(&s).expect("regular");
            prop_assert_eq!(proportional, surface.mean_squared == surface.gaussian);
            match operator(&s).principal_directions() {
                PrincipalDirections::Umbilic { curvature_w } => {
                    prop_assert!(proportional);
                    prop_assert!(is_zero(&w) || operator(&s).normal_curvature_w(&w) == Some(curvature_w));
                }
                PrincipalDirections::Two { curvatures_w: [k1, k2], .. } => prop_assert!(!proportional && k1 > k2),
            }
        }
    }

    #[test]
    fn both_kinds_occur_and_a_hair_apart() {
        let umbilic = |k2: Rational| {
            let s = jets(
                &vector(ZERO),
                [&vector([1, 0, 0]), &vector([0, 1, 0])],
                [&vector([0, 0, 1]), &vector(ZERO), &Vector([q(0, 1), q(0, 1), k2])],
            );
            matches!(operator(&s).principal_directions(), PrincipalDirections::Umbilic { .. })
        };
        assert!(umbilic(q(1, 1)));
        assert!(!umbilic(q(1, 1) + Rational::from((1, 1_u64 << 60))));
    }
}

mod cu_100 {
    use super::*;

    proptest! {
        #[test]
        fn k_is_the_product_and_h_half_the_sum(s in surface()) {
            let ([k1, k2], _) = principal(&s);
            let surface = parametric_surface::curvature(&s).expect("regular");
            prop_assert_eq!(k1.clone() * &k2, Surd::from(Rational::from(&surface.gaussian * &surface.w_squared)));
            let sum = k1 + &k2;
            let mean_w = sum.rational().expect("the roots are conjugate").clone() / 2_u32;
            prop_assert_eq!(&operator(&s).mean_w(), &mean_w);
            prop_assert_eq!(Sign::of(mean_w.cmp0()), surface.mean_sign);
            prop_assert_eq!(mean_w.square() / surface.w_squared, surface.mean_squared);
        }
    }
}

mod cu_101 {
    use super::*;

    proptest! {
        /// With w = xe₁ + ye₂, cos²θ = x²|e₁|²/|w|² and sin²θ = y²|e₂|²/|w|².
        #[test]
        fn euler_s_theorem_holds_in_every_direction(s in surface(), [x, y] in pair()) {
            let ([k1, k2], directions) = principal(&s);
            let operator = operator(&s);
            let along = |x: &Rational, i: usize| directions[i].each_ref().map(|a| a.clone() * &Surd::from(x.clone()));
            let (first, second) = (along(&x, 0), along(&y, 1));
            let w = [first[0].clone() + &second[0], first[1].clone() + &second[1]];
            let [cosine, sine] = [&first, &second].map(|e| operator.inner_product(e, e));
            prop_assert_eq!(operator.inner_product(&w, &w), cosine.clone() + &sine);
            prop_assert_eq!(operator.second_form_of_surds_w(&w), cosine * &k1 + &(sine * &k2));
        }
    }
}

mod cu_102 {
    use super::*;

    proptest! {
        /// The plane through p along w and ∇f, in orthonormal coordinates: f has the gradient (0, |∇f|) and ∂²f = ⟨w,
        /// Hw⟩/|w|² along w, so that its level curve has κ = −⟨w, Hw⟩/(|w|²|∇f|) toward N = ∇f/|∇f|.
        #[test]
        fn a_normal_section_bends_as_the_surface_does(
            terms in prop::collection::vec((prop::array::uniform2(0..=3_u32), -3..=3_i64), 0..6), at in pair(),
            w in pair(),
        ) {
            let g = Multivariate::<2>::new(terms.into_iter().map(|(e, c)| (e, q(c, 1))));
            let f =
                Multivariate::<3>::variable(2) - &Multivariate::new(g.terms().map(|([i, j], c)| ([i, j, 0], c.clone())));
            let graph = RationalPatch::graph(g.clone()).jets(&at).expect("a polynomial");
            let [x, y] = at;
            let z = g.evaluate(&[x.clone(), y.clone()]);
            let level = implicit_surface::curvature(&Jet::of_polynomial(&f, &[x, y, z])).expect("f_z = 1");
            let plane = TangentPlane::new(&graph).expect("regular");
            // N of the graph is that of the level set.
            prop_assert_eq!(&plane.normal_w(), &level.gradient);
            let Some(found) = operator(&graph).normal_curvature_w(&w) else { return Ok(()) };
            let vector = plane.vector(&w);
            let section = -vector.dot(&level.hessian.apply(&vector)) / vector.norm_squared();
            prop_assert_eq!(found, section);
        }

        /// The section's acceleration lies in the plane of w and N.
        #[test]
        fn the_section_s_curvature_is_all_normal(s in surface(), w in pair()) {
            prop_assume!(!is_zero(&w));
            let plane = TangentPlane::new(&s).expect("regular");
            let straight = curve(&s, &w, &[q(0, 1), q(0, 1)]).expect("regular");
            // u″, v″ that take the tangent part of α″ away.
            let bent = s.each_ref().map(|x| composition(x, &path(&w, &[q(0, 1), q(0, 1)])));
            let bent = Vector(bent.each_ref().map(|x| x.hessian.0[0][0].clone()));
            let n = plane.normal_w();
            let tangent = bent.clone() - &n.scaled(&(bent.dot(&n) / n.norm_squared()));
            let away = plane.coordinates(&-tangent).expect("tangent");
            let section = curve(&s, &w, &away).expect("regular");
            prop_assert_eq!(&section.normal_curvature_w, &straight.normal_curvature_w);
            prop_assert_eq!(section.kappa_squared() * n.norm_squared(), section.normal_curvature_w.square());
        }
    }

    #[test]
    fn the_sign_is_that_of_n() {
        // z = (x² − y²)/2: without sign, the largest curvature of a normal section is 1 and the least one 0, not −1.
        let saddle = operator(&paraboloid(1, -1));
        let PrincipalDirections::Two { curvatures_w, .. } = saddle.principal_directions() else { panic!("a saddle") };
        assert_eq!(curvatures_w, [1, -1].map(Surd::integer));
        let signed = |a: i64, b: i64| saddle.normal_curvature_w(&[q(a, 1), q(b, 1)]).expect("a direction");
        let unsigned = (-9..=9).flat_map(|a| (1..=9).map(move |b| (a, b))).map(|(a, b)| signed(a, b).abs());
        assert_eq!(unsigned.min(), Some(q(0, 1)));
        assert!(signed(1, 0) == 1 && signed(0, 1) == -1 && signed(1, 1).is_zero());
    }
}

#[test]
fn the_operator_is_that_of_the_surface_in_every_chart() {
    // A second use of the change of parameters: eigenvalues times W change with |det ∂h| alone.
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    runner
        .run(&(surface(), change()), |(s, h)| {
            let t = s.each_ref().map(|x| composition(x, &h));
            let det = super::surface_samples::determinant(&h);
            let ([a1, a2], _) = principal(&s);
            let ([b1, b2], _) = principal(&t);
            let scale = Surd::from(det.clone());
            let expected = if det > 0 { [a1, a2] } else { [a2, a1] }.map(|k| k * &scale);
            prop_assert_eq!([b1, b2], expected);
            prop_assert!(second(&s, 0, 1) == second(&s, 1, 0));
            prop_assert!(Matrix::<Rational, 2, 2>::identity().0[0][0].sign() == Sign::Positive);
            Ok(())
        })
        .expect("holds for every sample");
}
