//! The first fundamental form; the plane and the sphere.

use super::q;
use super::surface_samples::{basis, pair, path, rotation, second, surface};
use isoracle::curvature::angle_surfaces;
use isoracle::curvature::chart::{RationalPatch, composition};
use isoracle::curvature::parametric_surface::FundamentalForms;
use isoracle::curvature::surface_printed;
use isoracle::curvature::tangent::TangentPlane;
use isoracle::curvature::trigonometric::{Angle, Trigonometric, circle_point};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, Rational, Ring};
use proptest::prelude::*;

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

mod cu_72 {
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

mod cu_73 {
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

mod cu_74 {
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

mod cu_75 {
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

mod cu_76 {
    use super::*;

    proptest! {
        #[test]
        fn e_f_g_have_the_derivatives_of_the_products(
            x in prop::array::uniform3(prop::collection::vec((prop::array::uniform2(0..=3_u32), -3..=3_i64), 1..4)),
            at in pair(),
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

mod cu_77 {
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

mod cu_78 {
    use super::*;

    #[test]
    fn the_sphere_has_e_r2_f_0_g_r2_sin2() {
        let forms = FundamentalForms::new(&angle_surfaces::jets(&angle_surfaces::sphere()));
        let (r, sine) = (Trigonometric::<5>::parameter(0), Trigonometric::sin(Angle::First));
        let r2 = r.clone() * &r;
        assert_eq!(forms.first, [r2.clone(), Ring::integer(0), r2 * &sine * &sine]);
    }
}

mod cu_79 {
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
            // σ(θ, φ) is the point, with sin θ > 0, iff cos θ = z and (cos φ, sin φ) = (x, y)/√(1 − z²). φ in (0, 2π)
            // is excluded just by (cos φ, sin φ) = (1, 0); θ in (0, π) by z = ±1.
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
            let m_squared: Rational = (1 - z.clone()) / (1 + z);
            assert_eq!(m_squared, q(m * m, 9));
            // tan φ/2 = y/(√(1 − z²) + x)
            let sine: Rational = q(m, 3) * 2_u32 / (m_squared + 1_u32);
            assert_eq!(Rational::from(sine.square_ref()), sine_squared);
            assert_eq!(y / (sine + x), q(n, 5));
        }
    }
}
