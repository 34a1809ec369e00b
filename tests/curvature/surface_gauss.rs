//! The Gauss map and the second fundamental form.

use super::q;
use super::surface_samples::{Jets, basis, change, jets, pair, path, surface};
use isoracle::curvature::chart::{RationalPatch, composition, plane_as_graph};
use isoracle::curvature::gauss_map::{CurveOnSurface, GaussMap, ShapeOperator};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::{self, FundamentalForms, SurfaceError};
use isoracle::curvature::surface_printed;
use isoracle::curvature::tangent::TangentPlane;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Rational, Ring, Sign, Surd};
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

mod cu_80 {
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

mod cu_81 {
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

mod cu_82 {
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

mod cu_83 {
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

mod cu_84 {
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

mod cu_85 {
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

mod cu_86 {
    use super::*;

    proptest! {
        #[test]
        fn the_second_form_has_one_vector_for_its_argument(s in surface(), w in pair()) {
            let (plane, gauss) = (TangentPlane::new(&s).expect("regular"), GaussMap::new(&s).expect("regular"));
            let operator = ShapeOperator::new(&FundamentalForms::new(&s)).expect("regular");
            let (dn, vector) = (gauss.differential_w(&w), plane.vector(&w));
            prop_assert_eq!(-dn.dot(&vector), operator.second_form_w(&w));
            // A quadratic form takes −w to the same value; as a function of a pair it takes (w, −w) to the opposite
            // one.
            let opposite = w.each_ref().map(|x| Rational::from(-x));
            prop_assert_eq!(operator.second_form_w(&opposite), operator.second_form_w(&w));
            prop_assert_eq!(surface_printed::second_form_printed(&dn, &-vector), -operator.second_form_w(&w));
        }
    }
}

mod cu_87 {
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

mod cu_88 {
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

mod cu_89 {
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

mod cu_90 {
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

mod cu_225 {
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
