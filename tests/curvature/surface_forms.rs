//! The two fundamental forms and the Gauss map.

use super::q;
use super::surface_samples::{Jets, basis, change, jets, pair, path, rotation, second, surface};
use isoracle::curvature::angle_surfaces;
use isoracle::curvature::chart::{RationalPatch, composition, plane_as_graph};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::{self, FundamentalForms, SurfaceError};
use isoracle::curvature::shape_operator::{CurveOnSurface, GaussMap, ShapeOperator};
use isoracle::curvature::surface_printed;
use isoracle::curvature::tangent::TangentPlane;
use isoracle::curvature::trigonometric::{Angle, Trigonometric, circle_point};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

/// The unit sphere at the parameters (u, v); its normal points inward or outward as the chart has it.
fn sphere(radius: i64, at: [i64; 2]) -> Jets {
    RationalPatch::sphere(&q(radius, 1)).jets(&at.map(|x| q(x, 2))).expect("no pole")
}

/// The matrix of W dN, its columns the coordinates of WNᵤ and WNᵥ, found from the derivative of the normal.
fn dn_w(s: &Jets) -> Matrix<Rational, 2, 2> {
    let (plane, gauss) = (TangentPlane::new(s).expect("regular"), GaussMap::new(s).expect("regular"));
    let column = |n: &Vector<Rational, 3>| Vector(plane.coordinates(n).expect("dN is tangent"));
    let [u, v] = &gauss.derivatives_w;
    Matrix::from_columns(&[column(u), column(v)])
}

mod cu_224 {
    use super::*;

    proptest! {
        #[test]
        fn the_first_form_is_the_length_squared(s in surface(), w in pair(), x in pair()) {
            let plane = TangentPlane::new(&s).expect("regular");
            let (a, b) = (plane.vector(&w), plane.vector(&x));
            prop_assert_eq!(plane.first_form(&w), a.norm_squared());
            prop_assert_eq!(plane.first_form(&w) > 0, w != [q(0, 1), q(0, 1)]);
            // The bilinear form that belongs to it: ⟨a, b⟩ = (I(a + b) − I(a) − I(b))/2, symmetric.
            let sum = std::array::from_fn(|i| Rational::from(&w[i] + &x[i]));
            let polar = (plane.first_form(&sum) - plane.first_form(&w) - plane.first_form(&x)) / 2_u32;
            prop_assert_eq!(polar, b.dot(&a));
        }
    }
}

mod cu_225 {
    use super::*;

    proptest! {
        /// A quadratic form has one vector for its argument; as a function of pairs ⟨ , ⟩ is not ≥ 0.
        #[test]
        fn the_printed_domain_is_that_of_the_bilinear_form(s in surface(), w in pair()) {
            let plane = TangentPlane::new(&s).expect("regular");
            let vector = plane.vector(&w);
            let printed = surface_printed::first_form_printed(&vector, &-vector.clone());
            prop_assert_eq!(&printed, &-plane.first_form(&w));
            prop_assert_eq!(printed < 0, w != [q(0, 1), q(0, 1)]);
            let doubled = w.each_ref().map(|x| Rational::from(x * 2_u32));
            prop_assert_eq!(plane.first_form(&doubled), plane.first_form(&w) * 4_u32);
        }
    }
}

mod cu_226 {
    use super::*;

    proptest! {
        #[test]
        fn a_velocity_s_length_is_given_by_e_f_and_g(s in surface(), w in pair(), x in pair()) {
            let curve = s.each_ref().map(|f| composition(f, &path(&w, &x)));
            let velocity = Vector(curve.each_ref().map(|f| f.gradient[0].clone()));
            let [e, f, g] = FundamentalForms::new(&s).first;
            let [a, b] = &w;
            let form = e * a * a + f * a * b * 2_u32 + g * b * b;
            prop_assert_eq!(&form, &velocity.norm_squared());
            prop_assert_eq!(form, TangentPlane::new(&s).expect("regular").first_form(&w));
        }
    }
}

mod cu_227 {
    use super::*;

    proptest! {
        #[test]
        fn the_coefficients_are_the_form_s_values_on_the_basis(s in surface()) {
            let plane = TangentPlane::new(&s).expect("regular");
            let form = |a: i64, b: i64| plane.first_form(&[q(a, 1), q(b, 1)]);
            let f = (form(1, 1) - form(1, -1)) / 4_u32;
            prop_assert_eq!(plane.gram(), Matrix([[form(1, 0), f.clone()], [f, form(0, 1)]]));
        }
    }
}

mod cu_228 {
    use super::*;

    proptest! {
        #[test]
        fn e_f_g_have_the_derivatives_of_the_products(
            x in prop::array::uniform3(prop::collection::vec((prop::array::uniform2(0..=3_u32), -3..=3_i64), 1..4)), at in pair(),
        ) {
            let x = x.map(|terms| Multivariate::<2>::new(terms.into_iter().map(|(e, c)| (e, q(c, 1)))));
            let surface = RationalPatch::polynomial(x.clone()).jets(&at).expect("a polynomial");
            let forms = FundamentalForms::new(&surface);
            let basis = basis(&surface);
            for (n, (i, j)) in [(0, 0), (0, 1), (1, 1)].into_iter().enumerate() {
                let products = x.each_ref().map(|x| x.derivative(i) * &x.derivative(j));
                let function = products.iter().fold(Multivariate::integer(0), |sum, p| sum + p);
                prop_assert_eq!(&function.evaluate(&at), &forms.first[n]);
                for k in 0..2 {
                    let derivative = second(&surface, i, k).dot(&basis[j]) + basis[i].dot(&second(&surface, j, k));
                    prop_assert_eq!(function.derivative(k).evaluate(&at), derivative);
                }
            }
        }
    }
}

mod cu_230 {
    use super::*;

    proptest! {
        #[test]
        fn an_orthonormal_basis_has_e_1_f_0_g_1(a in rotation(), p in prop::array::uniform3(-3..=3_i64), at in pair()) {
            let (w1, w2) = (a.column(0), a.column(1));
            let patch = RationalPatch::plane(&vector(p), [&w1, &w2]);
            let forms = FundamentalForms::new(&patch.jets(&at).expect("a polynomial"));
            prop_assert_eq!(forms.first, [q(1, 1), q(0, 1), q(1, 1)]);
            let skewed = RationalPatch::plane(&vector(p), [&w1, &(w1.clone() + &w2)]);
            let forms = FundamentalForms::new(&skewed.jets(&at).expect("a polynomial"));
            prop_assert_eq!(forms.first, [q(1, 1), q(1, 1), q(2, 1)]);
        }
    }
}

mod cu_231 {
    use super::*;

    #[test]
    fn the_sphere_has_e_r2_f_0_g_r2_sin2() {
        let forms = FundamentalForms::new(&angle_surfaces::jets(&angle_surfaces::sphere()));
        let (r, sine) = (Trigonometric::<5>::parameter(0), Trigonometric::sin(Angle::First));
        let r2 = r.clone() * &r;
        assert_eq!(forms.first, [r2.clone(), Ring::integer(0), r2 * &sine * &sine]);
    }
}

mod cu_232 {
    use super::*;

    /// Every rational point of the unit sphere but the pole (0, 0, 1), with numbers up to 3.
    fn points() -> impl Iterator<Item = [Rational; 3]> {
        let sphere = RationalPatch::sphere(&q(1, 1));
        (-12..=12)
            .flat_map(|u| (-12..=12).map(move |v| [q(u, 4), q(v, 4)]))
            .map(move |at| sphere.jets(&at).expect("no pole").map(|x| x.value))
    }

    #[test]
    fn the_patch_reaches_all_but_a_half_circle() {
        for [x, y, z] in points() {
            // σ(θ, φ) is the point, with sin θ > 0, iff cos θ = z and (cos φ, sin φ) = (x, y)/√(1 − z²). φ in (0, 2π) is excluded
            // just by (cos φ, sin φ) = (1, 0); θ in (0, π) by z = ±1.
            let sine_squared = Rational::from(1) - Rational::from(z.square_ref());
            let reached = sine_squared > 0 && !(y.is_zero() && x > 0);
            let half_circle = y.is_zero() && x >= 0;
            assert_eq!(reached, !half_circle, "{x} {y} {z}");
        }
    }

    #[test]
    fn the_coordinates_are_on_the_sphere_and_regular_where_sin_is_not_0() {
        let sphere = angle_surfaces::sphere();
        let norm = sphere.iter().fold(Trigonometric::<5>::integer(0), |sum, x| sum + &(x.clone() * x));
        let r = Trigonometric::<5>::parameter(0);
        assert_eq!(norm, r.clone() * &r);
        let w_squared = FundamentalForms::new(&angle_surfaces::jets(&sphere)).w_squared();
        let at = |m: i64| {
            let [c, s] = circle_point(&q(m, 3));
            [c, s, q(3, 5), q(4, 5), q(2, 1)]
        };
        assert!(w_squared.evaluate(&at(0)).is_zero());
        assert!((1..30).all(|m| w_squared.evaluate(&at(m)) > 0));
        // Injective: tan θ/2 and tan φ/2 are found again from the point, off the half circle.
        for (m, n) in (1..8).flat_map(|m| (-8..8).filter(|n| *n != 0).map(move |n| (m, n))) {
            let ([c, s], [d, t]) = (circle_point(&q(m, 3)), circle_point(&q(n, 5)));
            let at = [c, s, d, t, q(1, 1)];
            let [x, y, z] = sphere.each_ref().map(|x| x.evaluate(&at));
            let sine_squared = Rational::from(1) - Rational::from(z.square_ref());
            let m_squared = Rational::from(1 - z.clone()) / Rational::from(1 + z);
            assert_eq!(m_squared, q(m * m, 9));
            // tan φ/2 = y/(√(1 − z²) + x)
            let sine = q(m, 3) * 2_u32 / (m_squared + 1_u32);
            assert_eq!(Rational::from(sine.square_ref()), sine_squared);
            assert_eq!(y / (sine + x), q(n, 5));
        }
    }
}

mod cu_233 {
    use super::*;

    proptest! {
        #[test]
        fn n_is_a_unit_vector_across_the_surface(s in surface()) {
            let gauss = GaussMap::new(&s).expect("regular");
            let n = gauss.normal();
            prop_assert_eq!(n.norm_squared(), Surd::integer(1));
            for w in basis(&s) {
                prop_assert_eq!(n.dot(&w.map(|x| Surd::from(x.clone()))), Surd::integer(0));
            }
            prop_assert_eq!(&gauss.normal_w, &TangentPlane::new(&s).expect("regular").normal_w());
            // W = ⟨N, σᵤ × σᵥ⟩ > 0
            let along = n.dot(&gauss.normal_w.map(|x| Surd::from(x.clone())));
            prop_assert!(along > Surd::integer(0));
        }
    }

    #[test]
    fn a_singular_point_has_no_normal() {
        let zero = vector([0, 0, 0]);
        let s = jets(&zero, [&zero, &vector([0, 1, 0])], [&zero, &zero, &zero]);
        assert_eq!(GaussMap::new(&s), Err(SurfaceError::Singular));
        assert_eq!(ShapeOperator::new(&FundamentalForms::new(&s)), Err(SurfaceError::Singular));
    }
}

mod cu_234 {
    use super::*;

    #[test]
    fn n_of_p_need_not_lie_on_the_surface() {
        // The plane z = 0: N = (0, 0, 1) is no point of it, so that there is no T_N(p)S; it is one of the unit sphere.
        let s = jets(
            &vector([2, 3, 0]),
            [&vector([1, 0, 0]), &vector([0, 1, 0])],
            [&vector([0, 0, 0]), &vector([0, 0, 0]), &vector([0, 0, 0])],
        );
        let n = GaussMap::new(&s).expect("regular").normal();
        assert_ne!(n[2], Surd::integer(0));
        assert_eq!(n.norm_squared(), Surd::integer(1));
    }

    proptest! {
        /// Both tangent planes are orthogonal to N(p).
        #[test]
        fn the_derivative_of_n_is_tangent(s in surface()) {
            let gauss = GaussMap::new(&s).expect("regular");
            for derivative in &gauss.derivatives_w {
                prop_assert!(derivative.dot(&gauss.normal_w).is_zero());
            }
        }

        /// The quotient by W in ℚ(√W²), by the chain rule for 1/√.
        #[test]
        fn the_derivatives_are_those_of_the_quotient(s in surface()) {
            let gauss = GaussMap::new(&s).expect("regular");
            // The functions σᵤ, σᵥ to first order.
            let function = |i: usize| -> [Jet<Surd, 2>; 3] {
                std::array::from_fn(|x| Jet {
                    value: Surd::from(s[x].gradient[i].clone()),
                    gradient: Vector(std::array::from_fn(|j| Surd::from(s[x].hessian.0[i][j].clone()))),
                    hessian: Matrix::from_fn(|_, _| Surd::integer(0)),
                })
            };
            let n = Vector(function(0)).cross(&Vector(function(1)));
            let w_squared = n.norm_squared();
            let value = w_squared.value.rational().expect("rational").clone();
            let w = Surd::sqrt(&value).expect("positive");
            let inverse = Surd::new(q(0, 1), value.clone().recip(), &value).expect("positive");
            // d(1/√y) = −1/(2y√y)
            let slope = inverse.clone() * &Surd::from(-(value * 2_u32).recip());
            let unit = w_squared.composed(&[inverse, slope, Surd::integer(0)]);
            for x in 0..3 {
                let derivative = (n[x].clone() * &unit).gradient;
                for i in 0..2 {
                    prop_assert_eq!(derivative[i].clone() * &w, Surd::from(gauss.derivatives_w[i][x].clone()));
                }
            }
        }
    }
}

mod cu_235 {
    use super::*;

    proptest! {
        #[test]
        fn a_plane_s_normal_is_constant(n in prop::array::uniform3(-3..=3_i64), d in -3..=3_i64, at in pair()) {
            let coefficients = n.map(|x| q(x, 1));
            // ax + by + cz + d = 0
            let Some(patch) = plane_as_graph(&coefficients, &q(-d, 1)) else { return Ok(()) };
            let surface = patch.jets(&at).expect("a polynomial");
            let gauss = GaussMap::new(&surface).expect("regular");
            prop_assert_eq!(&gauss.derivatives_w, &[Vector::zero(), Vector::zero()]);
            // Parallel to (a, b, c); the same way as σᵤ × σᵥ of a graph over x and y iff c > 0.
            prop_assert_eq!(gauss.normal_w.cross(&vector(n)), Vector::zero());
            if n[2] != 0 {
                prop_assert_eq!(gauss.normal_w.dot(&vector(n)) > 0, n[2] > 0);
            }
        }
    }
}

mod cu_236 {
    use super::*;

    proptest! {
        #[test]
        fn dn_is_self_adjoint(s in surface(), w in pair(), x in pair()) {
            let (plane, gauss) = (TangentPlane::new(&s).expect("regular"), GaussMap::new(&s).expect("regular"));
            let product = |a: &[Rational; 2], b: &[Rational; 2]| gauss.differential_w(a).dot(&plane.vector(b));
            prop_assert_eq!(product(&w, &x), product(&x, &w));
            // The two derivations of the matrix agree.
            let negated = Matrix::from_fn(|i, j| -dn_w(&s).0[i][j].clone());
            prop_assert_eq!(ShapeOperator::new(&FundamentalForms::new(&s)).expect("regular").matrix_w(), negated);
        }
    }

    #[test]
    fn its_matrix_need_not_be_symmetric() {
        // z = x²/2 in the basis σᵤ = (1, 0, 0), σᵥ = (1, 1, 0).
        let zero = vector([0, 0, 0]);
        let up = vector([0, 0, 1]);
        let s = jets(&zero, [&vector([1, 0, 0]), &vector([1, 1, 0])], [&up, &up, &up]);
        let Matrix([[_, b], [c, _]]) = ShapeOperator::new(&FundamentalForms::new(&s)).expect("regular").matrix_w();
        assert_ne!(b, c);
    }
}

mod cu_237 {
    use super::*;

    proptest! {
        #[test]
        fn k_is_the_determinant_of_dn(s in surface()) {
            let Matrix([[a, b], [c, d]]) = dn_w(&s);
            let curvature = parametric_surface::curvature(&s).expect("regular");
            let determinant = (a * d - b * c) / &curvature.w_squared;
            prop_assert_eq!(&determinant, &curvature.gaussian);
            prop_assert_eq!(ShapeOperator::new(&curvature.forms).expect("regular").gaussian(), determinant);
        }
    }
}

mod cu_238 {
    use super::*;

    proptest! {
        #[test]
        fn half_the_trace_is_minus_the_mean_curvature(s in surface()) {
            let curvature = parametric_surface::curvature(&s).expect("regular");
            let mean_w = ShapeOperator::new(&curvature.forms).expect("regular").mean_w();
            let printed = surface_printed::mean_curvature_printed(&dn_w(&s));
            prop_assert_eq!(&printed, &-mean_w.clone());
            prop_assert_eq!(Sign::of(mean_w.cmp0()), curvature.mean_sign);
            prop_assert_eq!(mean_w.square() / curvature.w_squared, curvature.mean_squared);
        }
    }

    #[test]
    fn on_the_sphere_the_printed_sign_is_that_of_the_other_normal() {
        let s = sphere(1, [1, 2]);
        let curvature = parametric_surface::curvature(&s).expect("regular");
        let w =
            Rational::from((curvature.w_squared.numer().clone().sqrt(), curvature.w_squared.denom().clone().sqrt()));
        assert_eq!(Rational::from(w.square_ref()), curvature.w_squared);
        // N = −p: this chart's normal points inward, k₁ = k₂ = 1.
        let outward = curvature.forms.normal_w.dot(&Vector(s.each_ref().map(|x| x.value.clone())));
        let expected = if outward > 0 { q(-1, 1) } else { q(1, 1) };
        let mean = ShapeOperator::new(&curvature.forms).expect("regular").mean_w() / &w;
        assert_eq!(mean, expected);
        assert_eq!(surface_printed::mean_curvature_printed(&dn_w(&s)) / w, -expected);
    }
}

mod cu_239 {
    use super::*;

    proptest! {
        #[test]
        fn the_second_form_has_one_vector_for_its_argument(s in surface(), w in pair()) {
            let (plane, gauss) = (TangentPlane::new(&s).expect("regular"), GaussMap::new(&s).expect("regular"));
            let operator = ShapeOperator::new(&FundamentalForms::new(&s)).expect("regular");
            let (dn, vector) = (gauss.differential_w(&w), plane.vector(&w));
            prop_assert_eq!(-dn.dot(&vector), operator.second_form_w(&w));
            // A quadratic form takes −w to the same value; as a function of a pair it takes (w, −w) to the opposite one.
            let opposite = w.each_ref().map(|x| Rational::from(-x));
            prop_assert_eq!(operator.second_form_w(&opposite), operator.second_form_w(&w));
            prop_assert_eq!(surface_printed::second_form_printed(&dn, &-vector), -operator.second_form_w(&w));
        }
    }
}

mod cu_240 {
    use super::*;

    #[test]
    fn the_curve_is_at_p_for_t_0_and_the_patch_is_not() {
        // α(t) = σ(1 + t, 0) on the plane: α(0) = p = (1, 0, 0), while σ at (0, 0) is another point.
        let patch = RationalPatch::plane(&vector([0, 0, 0]), [&vector([1, 0, 0]), &vector([0, 1, 0])]);
        let at = |u: i64| patch.jets(&[q(u, 1), q(0, 1)]).expect("a polynomial").map(|x| x.value);
        let curve = patch
            .jets(&[q(1, 1), q(0, 1)])
            .expect("a polynomial")
            .map(|x| composition(&x, &path(&[q(1, 1), q(0, 1)], &[q(0, 1), q(0, 1)])));
        assert_eq!(curve.each_ref().map(|x| x.value.clone()), at(1));
        assert_ne!(at(0), at(1));
        assert!(CurveOnSurface::new(&curve, &vector([0, 0, 1])).is_some());
    }
}

mod cu_241 {
    use super::*;

    proptest! {
        #[test]
        fn dn_of_a_velocity_is_the_derivative_of_n_along_the_curve(s in surface(), w in pair(), x in pair()) {
            // N along another parametrisation, whose first line runs along the curve, has ∂₁N for its derivative there.
            let gauss = GaussMap::new(&s).expect("regular");
            let across = [-w[1].clone(), w[0].clone()];
            prop_assume!(w != [q(0, 1), q(0, 1)]);
            let h: [Jet<Rational, 2>; 2] = std::array::from_fn(|a| Jet {
                value: q(0, 1),
                gradient: Vector([w[a].clone(), across[a].clone()]),
                hessian: Matrix([[x[a].clone(), q(0, 1)], [q(0, 1), q(0, 1)]]),
            });
            let along = GaussMap::new(&s.each_ref().map(|x| composition(x, &h))).expect("regular");
            // W′ = |∂h|W, det ∂h = a² + b² > 0.
            let det = Rational::from(w[0].square_ref()) + Rational::from(w[1].square_ref());
            prop_assert_eq!(&along.derivatives_w[0], &gauss.differential_w(&w).scaled(&det));
        }
    }
}

mod cu_242 {
    use super::*;

    proptest! {
        #[test]
        fn the_second_form_is_given_by_e_f_and_g(s in surface(), w in pair()) {
            let forms = FundamentalForms::new(&s);
            let gauss = GaussMap::new(&s).expect("regular");
            let [u, v] = basis(&s);
            let [nu, nv] = &gauss.derivatives_w;
            let [a, b] = &w;
            // e, f, g by their definition from the derivatives of N.
            let (e, f, g) = (-nu.dot(&u), -nv.dot(&u), -nv.dot(&v));
            prop_assert_eq!(&forms.second_w, &[e.clone(), f.clone(), g.clone()]);
            let form = e * a * a + f * a * b * 2_u32 + g * b * b;
            prop_assert_eq!(form, ShapeOperator::new(&forms).expect("regular").second_form_w(&w));
        }
    }
}

mod cu_243 {
    use super::*;

    proptest! {
        #[test]
        fn f_as_printed_is_g(s in surface()) {
            let forms = FundamentalForms::new(&s);
            let gauss = GaussMap::new(&s).expect("regular");
            let [u, v] = basis(&s);
            prop_assert_eq!(&surface_printed::f_printed(&gauss.derivatives_w[1], &v), &forms.second_w[2]);
            prop_assert_eq!(&surface_printed::f_corrected(&gauss.derivatives_w[1], &u), &forms.second_w[1]);
        }
    }

    #[test]
    fn on_the_saddle_they_differ() {
        // z = xy at the origin: f = 1, g = 0.
        let zero = vector([0, 0, 0]);
        let s = jets(&zero, [&vector([1, 0, 0]), &vector([0, 1, 0])], [&zero, &vector([0, 0, 1]), &zero]);
        let gauss = GaussMap::new(&s).expect("regular");
        let [u, v] = basis(&s);
        assert_eq!(surface_printed::f_printed(&gauss.derivatives_w[1], &v), 0);
        assert_eq!(surface_printed::f_corrected(&gauss.derivatives_w[1], &u), 1);
    }
}

mod cu_279 {
    use super::*;
    use isoracle::linear::determinant3;

    proptest! {
        #[test]
        fn the_basis_with_n_is_positive(s in surface(), h in change()) {
            for s in [s.clone(), s.each_ref().map(|x| composition(x, &h))] {
                let [u, v] = basis(&s);
                let gauss = GaussMap::new(&s).expect("regular");
                let determinant = determinant3(&Matrix::from_columns(&[u, v, gauss.normal_w.clone()]));
                prop_assert_eq!(determinant, gauss.normal_w.norm_squared());
            }
        }
    }
}
