//! Section 2(f): the coefficients of dN, K and H, as printed and as corrected; the plane and the sphere.

use super::q;
use super::surface_samples::{Jets, basis, jets, pair, rotation, second, surface};
use isoracle::curvature::angle_surfaces;
use isoracle::curvature::chart::RationalPatch;
use isoracle::curvature::gauss_map::{GaussMap, PrincipalDirections, ShapeOperator};
use isoracle::curvature::parametric_surface::{self, FundamentalForms};
use isoracle::curvature::surface_printed as text;
use isoracle::curvature::tangent::TangentPlane;
use isoracle::curvature::trigonometric::{Angle, Trigonometric};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Rational, Ring, Sign};
use proptest::prelude::*;

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

/// E, F, G and We, Wf, Wg.
fn forms(s: &Jets) -> (text::First, text::Second) {
    let forms = FundamentalForms::new(s);
    (forms.first, forms.second_w)
}

/// W times the coordinates of Nᵤ, and of Nᵥ, as rows: what equations (1) mean, from the derivatives of N.
fn by_derivatives(s: &Jets) -> Matrix<Rational, 2, 2> {
    let (plane, gauss) = (TangentPlane::new(s).expect("regular"), GaussMap::new(s).expect("regular"));
    let row = |n: &Vector<Rational, 3>| plane.coordinates(n).expect("tangent");
    Matrix([row(&gauss.derivatives_w[0]), row(&gauss.derivatives_w[1])])
}

/// z = x²/2 with σᵤ = (1, 0, 0), σᵥ = (1, 1, 0): E = F = 1, G = 2, e = f = g = 1, W = 1.
fn skewed() -> Jets {
    let (zero, up) = (vector([0, 0, 0]), vector([0, 0, 1]));
    jets(&zero, [&vector([1, 0, 0]), &vector([1, 1, 0])], [&up, &up, &up])
}

mod cu_103 {
    use super::*;

    proptest! {
        #[test]
        fn the_rows_are_the_coordinates_of_the_derivatives(s in surface()) {
            let (first, second_w) = forms(&s);
            let a = text::rows(&first, &second_w).expect("regular");
            prop_assert_eq!(&a, &by_derivatives(&s));
            let ([u, v], gauss) = (basis(&s), GaussMap::new(&s).expect("regular"));
            for (row, n) in a.0.iter().zip(&gauss.derivatives_w) {
                prop_assert_eq!(&(u.scaled(&row[0]) + &v.scaled(&row[1])), n);
            }
        }
    }
}

mod cu_104 {
    use super::*;

    proptest! {
        #[test]
        fn the_four_products_are_those_of_the_rows(s in surface()) {
            let ([u, v], [nu, nv]) = (basis(&s), GaussMap::new(&s).expect("regular").derivatives_w);
            let expected = [u.dot(&nu), v.dot(&nv), u.dot(&nv), v.dot(&nu)];
            prop_assert_eq!(text::products(&by_derivatives(&s), &forms(&s).0), expected);
        }
    }
}

mod cu_105 {
    use super::*;

    proptest! {
        #[test]
        fn the_products_with_n_are_differentiated(s in surface()) {
            let ([u, v], GaussMap { normal_w: n, derivatives_w: [nu, nv] }) =
                (basis(&s), GaussMap::new(&s).expect("regular"));
            prop_assert_eq!(u.dot(&nu), -second(&s, 0, 0).dot(&n));
            prop_assert_eq!(v.dot(&nv), -second(&s, 1, 1).dot(&n));
            let [left, right] = text::mixed_product_corrected(&u, &nv, &second(&s, 0, 1), &n);
            prop_assert_eq!(left, right);
            // The printed one holds just where f = g.
            let (_, [_, f, g]) = forms(&s);
            let [left, right] = text::mixed_product_printed(&v, &nv, &second(&s, 0, 1), &n);
            prop_assert_eq!(left == right, f == g);
        }
    }

    #[test]
    fn the_printed_product_fails_on_the_saddle() {
        let zero = vector([0, 0, 0]);
        let s = jets(&zero, [&vector([1, 0, 0]), &vector([0, 1, 0])], [&zero, &vector([0, 0, 1]), &zero]);
        let ([_, v], GaussMap { normal_w: n, derivatives_w: [_, nv] }) =
            (basis(&s), GaussMap::new(&s).expect("regular"));
        assert_eq!(text::mixed_product_printed(&v, &nv, &second(&s, 0, 1), &n), [q(0, 1), q(-1, 1)]);
    }
}

mod cu_106 {
    use super::*;

    proptest! {
        #[test]
        fn e_f_and_g_are_the_products_with_n(s in surface()) {
            let ([u, v], GaussMap { normal_w: n, derivatives_w: [nu, nv] }) =
                (basis(&s), GaussMap::new(&s).expect("regular"));
            let e = [-nu.dot(&u), n.dot(&second(&s, 0, 0))];
            let f = [text::f_corrected(&nv, &u), n.dot(&second(&s, 0, 1)), n.dot(&second(&s, 1, 0)), -nu.dot(&v)];
            let g = [-nv.dot(&v), n.dot(&second(&s, 1, 1))];
            prop_assert!(e[0] == e[1] && g[0] == g[1]);
            prop_assert!(f.iter().all(|x| *x == f[0]));
            prop_assert_eq!(&text::f_printed(&nv, &v), &g[0]);
            prop_assert_eq!(text::f_printed(&nv, &v) == f[0], f[0] == g[0]);
        }
    }

    #[test]
    fn the_printed_f_fails_on_the_saddle() {
        let zero = vector([0, 0, 0]);
        let s = jets(&zero, [&vector([1, 0, 0]), &vector([0, 1, 0])], [&zero, &vector([0, 0, 1]), &zero]);
        let ([_, v], gauss) = (basis(&s), GaussMap::new(&s).expect("regular"));
        assert_eq!((text::f_printed(&gauss.derivatives_w[1], &v), forms(&s).1), (q(0, 1), [q(0, 1), q(1, 1), q(0, 1)]));
    }
}

mod cu_107 {
    use super::*;

    /// −f, −f, −e, −g.
    fn left([e, f, g]: &text::Second) -> [Rational; 4] {
        [f, f, e, g].map(|x| Rational::from(-x))
    }

    proptest! {
        #[test]
        fn the_lines_hold_for_the_other_order_of_indices(s in surface()) {
            let (first, second_w) = forms(&s);
            let a = by_derivatives(&s);
            prop_assert_eq!(text::lines_corrected(&a, &first), left(&second_w));
            prop_assert_eq!(text::lines_printed(&a.transposed(), &first), left(&second_w));
            // With (1) they hold just where (a_ij) is symmetric.
            prop_assert_eq!(text::lines_printed(&a, &first) == left(&second_w), a == a.transposed());
        }
    }

    #[test]
    fn they_are_those_of_the_transposed_matrix_whatever_it_is() {
        // Of a surface the first two lines are equal; of other numbers they are not.
        let (a, first) = (Matrix([[q(1, 1), q(2, 1)], [q(3, 1), q(5, 1)]]), [q(7, 1), q(11, 1), q(13, 1)]);
        let expected = [q(11 + 2 * 13, 1), q(3 * 7 + 5 * 11, 1), q(7 + 2 * 11, 1), q(3 * 11 + 5 * 13, 1)];
        assert_eq!(text::lines_corrected(&a, &first), expected);
        assert_eq!(text::lines_printed(&a.transposed(), &first), expected);
    }

    #[test]
    fn they_fail_on_a_cylinder_in_skew_coordinates() {
        let (first, second_w) = forms(&skewed());
        let a = by_derivatives(&skewed());
        assert_eq!(a, Matrix([[q(-1, 1), q(0, 1)], [q(-1, 1), q(0, 1)]]));
        assert_eq!(text::lines_printed(&a, &first), [q(-3, 1), q(0, 1), q(-2, 1), q(0, 1)]);
        assert_eq!(left(&second_w), [q(-1, 1), q(-1, 1), q(-1, 1), q(-1, 1)]);
    }
}

mod cu_108 {
    use super::*;

    proptest! {
        #[test]
        fn the_matrix_equation_is_that_of_the_rows(s in surface()) {
            let ([e, f, g], [ee, ff, gg]) = { let (first, second) = forms(&s); (second, first) };
            let negated = Matrix([[-e, -f.clone()], [-f, -g]]);
            let first = Matrix([[ee, ff.clone()], [ff, gg]]);
            let a = by_derivatives(&s);
            prop_assert_eq!(&a.times(&first), &negated);
            // The columns stand on the other side: (E F; F G)(a_ij)ᵀ.
            prop_assert_eq!(&first.times(&a.transposed()), &negated);
            prop_assert_eq!(a.transposed().times(&first) == negated, a == a.transposed());
        }
    }
}

mod cu_109 {
    use super::*;

    proptest! {
        /// Cramer's rule, on ⟨Nᵢ, σⱼ⟩ = aᵢ₁⟨σᵤ, σⱼ⟩ + aᵢ₂⟨σᵥ, σⱼ⟩.
        #[test]
        fn the_solved_equation_is_that_of_the_rows(s in surface()) {
            let (first, second_w) = forms(&s);
            let [ee, ff, gg] = &first;
            let w_squared = Rational::from(ee * gg) - Rational::from(ff * ff);
            let [e, f, g] = second_w.each_ref().map(|x| Rational::from(-x));
            let row = |x: &Rational, y: &Rational| [
                (Rational::from(x * gg) - Rational::from(y * ff)) / &w_squared,
                (Rational::from(y * ee) - Rational::from(x * ff)) / &w_squared,
            ];
            prop_assert_eq!(text::rows(&first, &second_w), Some(Matrix([row(&e, &f), row(&f, &g)])));
        }
    }
}

mod cu_110 {
    use super::*;

    proptest! {
        #[test]
        fn the_inverse_times_the_matrix_is_1(e in -5..=5_i64, f in -5..=5_i64, g in -5..=5_i64) {
            let entries = [e, f, g].map(|x| q(x, 2));
            let matrix = Matrix([[q(e, 2), q(f, 2)], [q(f, 2), q(g, 2)]]);
            match text::first_form_inverse(&entries) {
                None => prop_assert_eq!(e * g, f * f),
                Some(inverse) => {
                    prop_assert_eq!(matrix.times(&inverse), Matrix::identity());
                    prop_assert_eq!(inverse.times(&matrix), Matrix::identity());
                }
            }
        }
    }
}

mod cu_111 {
    use super::*;

    proptest! {
        #[test]
        fn the_printed_entries_are_those_of_the_columns(s in surface()) {
            let (first, second_w) = forms(&s);
            let a = by_derivatives(&s);
            prop_assert_eq!(text::entries_corrected(&first, &second_w), Some(a.clone()));
            prop_assert_eq!(text::entries_printed(&first, &second_w), Some(a.transposed()));
            let columns = parametric_surface::curvature(&s).expect("regular").weingarten_w();
            prop_assert_eq!(text::entries_printed(&first, &second_w), Some(columns));
        }
    }

    #[test]
    fn they_do_not_follow_from_the_matrix_equation() {
        let (first, second_w) = forms(&skewed());
        let printed = text::entries_printed(&first, &second_w).expect("regular");
        let corrected = text::entries_corrected(&first, &second_w).expect("regular");
        assert_eq!(Some(&corrected), text::rows(&first, &second_w).as_ref());
        assert_eq!((printed.0[0][1].clone(), corrected.0[0][1].clone()), (q(-1, 1), q(0, 1)));
        assert_eq!((printed.0[1][0].clone(), corrected.0[1][0].clone()), (q(0, 1), q(-1, 1)));
        let singular = [q(1, 1), q(2, 1), q(4, 1)];
        assert_eq!(
            (text::entries_printed(&singular, &second_w), text::entries_corrected(&singular, &second_w)),
            (None, None)
        );
        assert_eq!(text::rows(&singular, &second_w), None);
    }
}

mod cu_112 {
    use super::*;

    proptest! {
        #[test]
        fn k_is_a_quotient_of_determinants(s in surface()) {
            let (first, second_w) = forms(&s);
            let surface = parametric_surface::curvature(&s).expect("regular");
            let determinant = |Matrix([[a, b], [c, d]]): Matrix<Rational, 2, 2>| a * d - b * c;
            // det(W a_ij) = W²K, for both orders of the indices.
            let w2k = Rational::from(&surface.gaussian * &surface.w_squared);
            prop_assert_eq!(&text::gaussian(&first, &second_w).expect("regular"), &w2k);
            prop_assert_eq!(&determinant(by_derivatives(&s)), &w2k);
            prop_assert_eq!(&determinant(text::entries_printed(&first, &second_w).expect("regular")), &w2k);
        }
    }
}

mod cu_113 {
    use super::*;

    #[test]
    fn the_cylinder_of_curvature_1_tells_the_maps_apart() {
        // z = x²/2: k₁ = 1. dN + I is singular, dN − I is not, and dN is no multiple of I.
        let a = by_derivatives(&skewed());
        assert_eq!(text::characteristic(&a, &q(1, 1)), 0);
        assert_eq!(text::singular_map_printed(&a, &q(1, 1)), 2);
        assert_ne!(a, Matrix([[q(1, 1), q(0, 1)], [q(0, 1), q(1, 1)]]));
    }

    proptest! {
        #[test]
        fn dn_is_invertible_where_k_is_not_0_even_if_it_is_a_multiple_of_i(k in -5..=5_i64) {
            // At an umbilic dN = −kI: as printed, with dN = kI read as an equation, it is invertible unless k = 0.
            let a = Matrix([[q(-k, 1), q(0, 1)], [q(0, 1), q(-k, 1)]]);
            prop_assert_eq!(text::characteristic(&a, &q(k, 1)), 0);
            prop_assert_eq!(text::singular_map_printed(&a, &q(k, 1)).is_zero(), k == 0);
            prop_assert_eq!(text::characteristic(&a, &q(0, 1)).is_zero(), k == 0);
        }
    }
}

mod cu_114 {
    use super::*;
    use isoracle::number::Surd;

    proptest! {
        #[test]
        fn principal_curvatures_are_the_roots(s in surface(), k in -9..=9_i64) {
            let a = by_derivatives(&s);
            let Matrix([[a11, a12], [a21, a22]]) = &a;
            let trace = Rational::from(a11 + a22);
            let determinant = Rational::from(a11 * a22) - Rational::from(a12 * a21);
            let k = q(k, 2);
            let polynomial = Rational::from(k.square_ref()) + Rational::from(&k * &trace) + &determinant;
            prop_assert_eq!(text::characteristic(&a, &k), polynomial);
            let operator = ShapeOperator::new(&FundamentalForms::new(&s)).expect("regular");
            let roots = match operator.principal_directions() {
                PrincipalDirections::Umbilic { curvature_w } => [Surd::from(curvature_w.clone()), Surd::from(curvature_w)],
                PrincipalDirections::Two { curvatures_w, .. } => curvatures_w,
            };
            for k in roots {
                let value = k.clone() * &k + &(k * &Surd::from(trace.clone())) + &Surd::from(determinant.clone());
                prop_assert_eq!(value, Surd::integer(0));
            }
        }
    }
}

mod cu_115 {
    use super::*;

    proptest! {
        #[test]
        fn h_is_minus_half_the_trace_and_has_no_minus_in_the_end(s in surface()) {
            let (first, second_w) = forms(&s);
            let Matrix([[a11, _], [_, a22]]) = by_derivatives(&s);
            let corrected = text::mean_corrected(&first, &second_w).expect("regular");
            prop_assert_eq!(&corrected, &(-(a11 + a22) / 2_u32));
            prop_assert_eq!(&text::mean_printed(&first, &second_w).expect("regular"), &-corrected.clone());
            let surface = parametric_surface::curvature(&s).expect("regular");
            prop_assert_eq!(Sign::of(corrected.cmp0()), surface.mean_sign);
        }
    }

    #[test]
    fn the_paraboloid_has_the_curvature_of_its_sections() {
        // z = (x² + y²)/2 at the origin, N = (0, 0, 1): k₁ = k₂ = 1.
        let (first, second_w) = ([q(1, 1), q(0, 1), q(1, 1)], [q(1, 1), q(0, 1), q(1, 1)]);
        assert_eq!(text::mean_corrected(&first, &second_w), Some(q(1, 1)));
        assert_eq!(text::mean_printed(&first, &second_w), Some(q(-1, 1)));
    }
}

mod cu_116 {
    use super::*;

    proptest! {
        #[test]
        fn a_plane_is_flat(a in rotation(), p in prop::array::uniform3(-3..=3_i64), at in pair()) {
            let (w1, w2) = (a.column(0), a.column(0) + &a.column(2));
            let patch = RationalPatch::plane(&vector(p), [&w1, &w2]);
            let surface = parametric_surface::curvature(&patch.jets(&at).expect("a polynomial")).expect("regular");
            prop_assert!(surface.gaussian.is_zero() && surface.mean_squared.is_zero());
            prop_assert_eq!(surface.mean_sign, Sign::Zero);
        }
    }
}

fn r() -> Trigonometric<5> {
    Trigonometric::parameter(0)
}

fn sine() -> Trigonometric<5> {
    Trigonometric::sin(Angle::First)
}

mod cu_117 {
    use super::*;

    #[test]
    fn the_normal_points_outward() {
        // W = r² sin θ for 0 < θ < π, so that σ_θ × σ_φ = W N; and σ = r N.
        let sphere = angle_surfaces::sphere();
        let w = r() * &r() * &sine();
        let normal = angle_surfaces::sphere_normal();
        let forms = FundamentalForms::new(&angle_surfaces::jets(&sphere));
        assert_eq!(forms.normal_w.0, normal.each_ref().map(|x| x.clone() * &w));
        assert_eq!(sphere, normal.each_ref().map(|x| x.clone() * &r()));
        assert_eq!(Vector(normal).norm_squared(), Ring::integer(1));
    }

    #[test]
    fn another_angle_than_phi_makes_no_normal() {
        // φ = 0, ψ a right angle, θ too: (0, 1, 0) at (r, 0, 0).
        let at = |c: i64, s: i64| [q(0, 1), q(1, 1), q(c, 1), q(s, 1), q(1, 1)];
        let normal = angle_surfaces::sphere_normal().map(|x| x.evaluate(&at(0, 1)));
        let tangent = angle_surfaces::jets(&angle_surfaces::sphere()).map(|x| x.gradient[1].evaluate(&at(1, 0)));
        assert_ne!(Vector(normal).dot(&Vector(tangent)), 0);
    }
}

mod cu_118 {
    use super::*;

    #[test]
    fn e_is_minus_r_f_0_and_g_minus_r_sin2() {
        let forms = FundamentalForms::new(&angle_surfaces::jets(&angle_surfaces::sphere()));
        let w = r() * &r() * &sine();
        let expected = [-r(), Ring::integer(0), -(r() * &sine() * &sine())].map(|x| x * &w);
        assert_eq!(forms.second_w, expected);
        // By ⟨N, σ_ij⟩ with the text's N.
        let normal = Vector(angle_surfaces::sphere_normal());
        let jets = angle_surfaces::jets(&angle_surfaces::sphere());
        let product = |i: usize, j: usize| normal.dot(&Vector(jets.each_ref().map(|x| x.hessian.0[i][j].clone())));
        assert_eq!([product(0, 0), product(0, 1), product(1, 1)].map(|x| x * &w), forms.second_w);
    }
}

mod cu_119 {
    use super::*;

    #[test]
    fn k_is_1_over_r2() {
        let forms = FundamentalForms::new(&angle_surfaces::jets(&angle_surfaces::sphere()));
        let [e, f, g] = forms.second_w.clone();
        // W⁴K r² = W⁴
        let w2 = forms.w_squared();
        assert_eq!((e * &g - &(f.clone() * &f)) * &r() * &r(), w2.clone() * &w2);
        for n in 1..20 {
            let s = RationalPatch::sphere(&q(n, 3)).jets(&[q(n, 7), q(1, n)]).expect("no pole");
            assert_eq!(parametric_surface::curvature(&s).expect("regular").gaussian, q(9, n * n));
        }
    }
}

mod cu_120 {
    use super::*;

    #[test]
    fn h_is_minus_1_over_r_with_the_outward_normal() {
        let forms = FundamentalForms::new(&angle_surfaces::jets(&angle_surfaces::sphere()));
        let ([ee, _, gg], [e, _, g]) = (forms.first.clone(), forms.second_w.clone());
        // F = f = 0: 2W³H = W(eG + gE), and W³ = r⁶ sin³θ; so 2rH is −2.
        let w = r() * &r() * &sine();
        let cube = w.clone() * &w * &w;
        assert_eq!((e * &gg + &(g * &ee)) * &r(), cube * &Ring::integer(-2));
    }

    #[test]
    fn the_printed_value_is_that_of_the_inward_normal() {
        for n in 1..20 {
            // At θ = φ = a right angle: E = G = r², F = 0; e = g = −r, f = 0.
            let radius = q(n, 4);
            let square = Rational::from(radius.square_ref());
            let first = [square.clone(), q(0, 1), square];
            let second = [Rational::from(-&radius), q(0, 1), Rational::from(-&radius)];
            let mean = text::mean_corrected(&first, &second);
            assert_eq!(mean, text::sphere_mean_corrected(&radius));
            assert_ne!(mean, text::sphere_mean_printed(&radius));
            // The printed formula for H and the printed definition agree with the printed value.
            assert_eq!(text::mean_printed(&first, &second), text::sphere_mean_printed(&radius));
            let dn = text::rows(&first, &second).expect("regular");
            assert_eq!(Some(text::mean_curvature_printed(&dn)), text::sphere_mean_printed(&radius));
            let inward = second.each_ref().map(|x| Rational::from(-x));
            assert_eq!(text::mean_corrected(&first, &inward), text::sphere_mean_printed(&radius));
        }
        assert_eq!((text::sphere_mean_printed(&q(0, 1)), text::sphere_mean_corrected(&q(0, 1))), (None, None));
    }
}
