//! Curves on surfaces, tangent planes, differentials of maps.

use super::q;
use super::surface_samples::{basis, change, determinant, pair, path, surface};
use isoracle::curvature::chart::{RationalPatch, composition, scaled_axes};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::FundamentalForms;
use isoracle::curvature::tangent::{NotTangent, TangentPlane, differential};
use isoracle::curvature::trigonometric::circle_point;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::Rational;
use proptest::prelude::*;

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

mod cu_64 {
    use super::*;

    #[test]
    fn a_great_circle_leaves_the_patch() {
        // α(t) = (sin t, 0, cos t), 0 < t < π, is on the sphere. α(t) = σ(θ, φ), sin θ > 0, has cos φ = 1: φ is in no
        // (0, 2π).
        for n in 1..20 {
            let [z, x] = circle_point(&q(n, 7));
            let sine = x.clone(); // sin θ > 0 and sin²θ = 1 − z² = x²
            assert!(sine > 0 && Rational::from(z.square_ref()) + Rational::from(sine.square_ref()) == 1);
            assert_eq!(x / sine, 1);
        }
    }

    proptest! {
        #[test]
        fn a_drawn_curve_s_parameters_have_derivatives(s in surface(), first in pair(), second in pair()) {
            let path = path(&first, &second);
            let curve = s.each_ref().map(|x| composition(x, &path));
            let plane = TangentPlane::new(&s).expect("regular");
            let velocity = Vector(curve.each_ref().map(|x| x.gradient[0].clone()));
            prop_assert_eq!(plane.coordinates(&velocity), Ok(first.clone()));
            // α″ = Σ u_a″σ_a + Σ u_a′u_b′σ_ab
            let straight = s.each_ref().map(|x| composition(x, &super::path(&first, &[q(0, 1), q(0, 1)])));
            let rest = Vector(std::array::from_fn(|i| curve[i].hessian.0[0][0].clone() - &straight[i].hessian.0[0][0]));
            prop_assert_eq!(plane.coordinates(&rest), Ok(second));
        }
    }
}

mod cu_65 {
    use super::*;

    proptest! {
        #[test]
        fn coordinate_curves_have_the_basis_for_velocities(s in surface()) {
            let velocity = |path: &[Jet<Rational, 1>; 2]| {
                Vector(s.each_ref().map(|x| composition(x, path).gradient[0].clone()))
            };
            let none = [q(0, 1), q(0, 1)];
            prop_assert_eq!(
                [velocity(&path(&[q(1, 1), q(0, 1)], &none)), velocity(&path(&[q(0, 1), q(1, 1)], &none))],
                basis(&s)
            );
            // With another u(t), such as a constant or t² at t = 0, it has no tangent there.
            for second in [q(0, 1), q(2, 1)] {
                prop_assert_eq!(velocity(&path(&none, &[second, q(0, 1)])), Vector::zero());
            }
        }
    }
}

mod cu_66 {
    use super::*;

    proptest! {
        #[test]
        fn velocities_are_the_image_of_the_differential(
            s in surface(), w in pair(), second in pair(), bump in prop::array::uniform3(-2..=2_i64),
        ) {
            let plane = TangentPlane::new(&s).expect("regular");
            let curve = s.each_ref().map(|x| composition(x, &path(&w, &second)));
            let velocity = Vector(curve.each_ref().map(|x| x.gradient[0].clone()));
            prop_assert_eq!(&velocity, &plane.vector(&w));
            // Two dimensions, and no more: what is off the plane is no velocity.
            let off = velocity + &vector(bump);
            let is_tangent = vector(bump).dot(&plane.normal_w()).is_zero();
            prop_assert_eq!(plane.coordinates(&off).is_ok(), is_tangent);
            prop_assert_eq!(plane.coordinates(&plane.normal_w()), Err(NotTangent));
        }
    }
}

mod cu_67 {
    use super::*;

    proptest! {
        #[test]
        fn the_tangent_plane_is_that_of_the_surface(s in surface(), h in change(), w in pair()) {
            let t = s.each_ref().map(|x| composition(x, &h));
            let [here, there] = [&s, &t].map(|s| TangentPlane::new(s).expect("regular"));
            prop_assert_eq!(there.normal_w(), here.normal_w().scaled(&determinant(&h)));
            prop_assert!(here.coordinates(&there.vector(&w)).is_ok());
        }
    }
}

mod cu_68 {
    use super::*;

    proptest! {
        #[test]
        fn coordinates_are_found_by_other_vectors_too(s in surface(), w in pair()) {
            let plane = TangentPlane::new(&s).expect("regular");
            let vector = plane.vector(&w);
            prop_assert_eq!(plane.coordinates(&vector), Ok(w.clone()));
            // Cramer's rule with n = σᵤ × σᵥ: a = ⟨w × σᵥ, n⟩/W², b = ⟨σᵤ × w, n⟩/W².
            let n = plane.normal_w();
            let a = vector.cross(&plane.v).dot(&n) / n.norm_squared();
            let b = plane.u.cross(&vector).dot(&n) / n.norm_squared();
            prop_assert_eq!([a, b], w);
        }
    }
}

mod cu_69 {
    use super::*;

    proptest! {
        #[test]
        fn the_image_velocity_depends_on_the_velocity_alone_and_linearly(
            at in pair(), [w, x] in [pair(), pair()], second in [pair(), pair()],
            axes in prop::array::uniform3(1..=4_i64),
        ) {
            let axes = axes.map(|x| Jet::constant(q(x, 2)));
            let sphere = RationalPatch::sphere(&q(1, 1)).jets(&at).expect("no pole");
            let image = scaled_axes(&sphere, &axes);
            let velocity = |first: &[Rational; 2], second: &[Rational; 2]| {
                Vector(image.each_ref().map(|x| composition(x, &path(first, second)).gradient[0].clone()))
            };
            prop_assert_eq!(velocity(&w, &second[0]), velocity(&w, &second[1]));
            let sum = std::array::from_fn(|i| Rational::from(&w[i] * 2_u32) - &x[i]);
            let combined = velocity(&w, &second[0]).scaled(&q(2, 1)) - &velocity(&x, &second[0]);
            prop_assert_eq!(velocity(&sum, &second[1]), combined);
        }

        /// In charts dφ is the derivative of σ₂⁻¹∘φ∘σ₁.
        #[test]
        fn its_matrix_is_that_of_the_map_in_charts(s in surface(), h in change()) {
            let image = s.each_ref().map(|x| composition(x, &h));
            let plane = TangentPlane::new(&s).expect("regular");
            let expected = Matrix::from_fn(|a, i| h[a].gradient[i].clone());
            prop_assert_eq!(differential(&image, &plane), Ok(expected));
            let mut lifted = image;
            lifted[0].gradient.0[0] += &plane.normal_w()[0];
            lifted[1].gradient.0[0] += &plane.normal_w()[1];
            lifted[2].gradient.0[0] += &plane.normal_w()[2];
            prop_assert_eq!(differential(&lifted, &plane), Err(NotTangent));
        }
    }
}

mod cu_70 {
    use super::*;

    proptest! {
        #[test]
        fn tangent_vectors_go_to_tangent_vectors_and_a_constant_map_forgets_them(
            s in surface(), t in surface(), w in pair(),
        ) {
            let target = TangentPlane::new(&t).expect("regular");
            let constant = t.each_ref().map(|x| Jet::constant(x.value.clone()));
            let matrix = differential(&constant, &target).expect("0 is tangent");
            prop_assert_eq!(matrix.apply(&Vector(w)), Vector::zero());
            // A map that forgets v: its image of T_pS is a line.
            let along_u = [Jet::variable(0, q(0, 1)), Jet::constant(q(0, 1))];
            let folded = t.each_ref().map(|x| composition(x, &along_u));
            let matrix = differential(&folded, &target).expect("tangent");
            prop_assert_eq!(matrix, Matrix([[q(1, 1), q(0, 1)], [q(0, 1), q(0, 1)]]));
            prop_assert!(TangentPlane::new(&s).is_ok());
        }
    }
}

mod cu_71 {
    use super::*;

    proptest! {
        #[test]
        fn w_squared_is_lagrange_s_identity(s in surface()) {
            let forms = FundamentalForms::new(&s);
            prop_assert_eq!(forms.w_squared(), forms.normal_w.norm_squared());
            prop_assert!(forms.w_squared() > 0);
        }
    }
}
