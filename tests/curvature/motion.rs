//! Rigid motions, scalings, affine maps, relabelled level functions: what they do to K, H and N.

use super::level::{jet, point, polynomial, regular_jet, small, sphere, terms};
use super::q;
use isoracle::curvature::implicit_printed;
use isoracle::curvature::implicit_surface::{self, LevelSurface};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::motion::{Affine, NotOrthogonal, Orthogonal, relabelled};
use isoracle::curvature::parametric_surface::{self, FundamentalForms};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, OrderedField, Rational, Ring, Sign};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = Vector<Rational, 3>> {
    point().prop_map(Vector)
}

/// Rotations, half-turns and the identity among them, and improper ones.
fn orthogonal() -> impl Strategy<Value = Orthogonal> {
    let quaternion = prop::array::uniform4(-3..=3_i64).prop_filter("not 0", |q| *q != [0; 4]);
    (quaternion, any::<bool>()).prop_map(|(q, improper)| {
        let turn = Orthogonal::of_quaternion(&q.map(Rational::from)).expect("not zero");
        if improper { turn.opposite() } else { turn }
    })
}

fn affine() -> impl Strategy<Value = Affine> {
    let rows = prop::array::uniform3(prop::array::uniform3(small()));
    (rows, vector()).prop_filter_map("invertible", |(rows, b)| Affine::new(Matrix(rows), b).ok())
}

fn diagonal(entries: [i64; 3]) -> Matrix<Rational, 3, 3> {
    Matrix::from_fn(|i, j| q(if i == j { entries[i] } else { 0 }, 1))
}

fn invariants(level: &LevelSurface) -> (&Rational, &Rational, Sign) {
    (&level.gaussian, &level.mean_squared, level.mean_sign)
}

/// x, y, z as functions of u, v with the derivatives of a parametrisation, moved by a linear map.
fn moved_surface(surface: &[Jet<Rational, 2>; 3], a: &Affine) -> [Jet<Rational, 2>; 3] {
    std::array::from_fn(|i| {
        (0..3).fold(Jet::integer(0), |sum, j| sum + &(surface[j].clone() * &Jet::constant(a.linear().0[i][j].clone())))
    })
}

fn surface() -> impl Strategy<Value = [Jet<Rational, 2>; 3]> {
    prop::array::uniform3(prop::array::uniform5(small())).prop_map(|coordinates| {
        coordinates.map(|[u, v, uu, uv, vv]| {
            let hessian = Matrix([[uu, uv.clone()], [uv, vv]]);
            Jet { value: q(0, 1), gradient: Vector([u, v]), hessian }
        })
    })
}

mod cu_204 {
    use super::*;

    #[test]
    fn read_as_one_field_even_a_translation_changes_k() {
        // z − x² − y², moved by e₁: the image of the vertex is not on the surface, and the field K there is 4/25, not 4.
        let f = terms(&[([0, 0, 1], 1), ([2, 0, 0], -1), ([0, 2, 0], -1)]);
        let shift = Affine::new(Matrix::identity(), Vector([q(1, 1), q(0, 1), q(0, 1)])).expect("det = 1");
        let at = [q(0, 1), q(0, 1), q(0, 1)];
        let jets = implicit_printed::printed_invariance_jets(&f, &shift, &at);
        let [here, there] = jets.map(|jet| implicit_surface::curvature(&jet).expect("f_z = 1"));
        assert_eq!((&here.gaussian, &there.gaussian), (&q(4, 1), &q(4, 25)));
        assert_ne!(here.value, there.value);
        // The field of the image at the image of the point.
        let image = shift.image(&Vector(at));
        let moved = implicit_surface::curvature(&Jet::of_polynomial(&shift.moved(&f), &image.0)).expect("regular");
        assert_eq!((&moved.gaussian, moved.value), (&q(4, 1), here.value));
    }
}

mod cu_205 {
    use super::*;

    proptest! {
        #[test]
        fn a_moved_sphere_has_its_curvatures(r in orthogonal(), b in vector(), axis in 0..3_usize) {
            let motion = Affine::rigid(&r, b);
            let moved = motion.moved(&sphere());
            let at = motion.image(&Vector([0, 1, 2].map(|i| q(if i == axis { 3 } else { 0 }, 1))));
            let level = implicit_surface::curvature(&Jet::of_polynomial(&moved, &at.0)).expect("regular");
            prop_assert_eq!(&level.value, &q(9, 1));
            prop_assert_eq!(invariants(&level), (&q(1, 9), &q(1, 9), Sign::Negative));
        }
    }
}

mod cu_206 {
    use super::*;

    proptest! {
        #[test]
        fn k_and_h_are_kept_by_rigid_motions(jet in regular_jet(), r in orthogonal(), b in vector()) {
            let there = Affine::rigid(&r, b).moved_jet(&jet);
            let [before, after] = [jet, there].map(|jet| implicit_surface::curvature(&jet).expect("regular"));
            prop_assert_eq!(invariants(&before), invariants(&after));
        }

        /// The moved jet is that of the moved polynomial.
        #[test]
        fn moving_a_jet_is_moving_its_function(f in polynomial(), at in point(), a in affine()) {
            let there = Jet::of_polynomial(&a.moved(&f), &a.image(&Vector(at.clone())).0);
            prop_assert_eq!(there, a.moved_jet(&Jet::of_polynomial(&f, &at)));
        }
    }
}

mod cu_207 {
    use super::*;

    proptest! {
        #[test]
        fn scaling_divides_k_by_the_square_of_the_factor(jet in regular_jet(), factor in small()) {
            let Ok(scaling) = Affine::scaling(&factor) else {
                prop_assert!(factor.is_zero());
                return Ok(());
            };
            let square = Rational::from(factor.square_ref());
            prop_assert_eq!(scaling.gaussian_factor(&jet.gradient), Some(square.clone().recip()));
            let [before, after] = [jet.clone(), scaling.moved_jet(&jet)]
                .map(|jet| implicit_surface::curvature(&jet).expect("regular"));
            prop_assert_eq!(after.gaussian * &square, before.gaussian);
            // H by |λ|, its sign kept: −I is an improper motion.
            prop_assert_eq!(after.mean_squared * square, before.mean_squared);
            prop_assert_eq!(after.mean_sign, before.mean_sign);
        }
    }

    #[test]
    fn a_sphere_of_twice_the_radius_has_a_quarter_of_k() {
        let doubling = Affine::scaling(&q(2, 1)).expect("2 ≠ 0");
        let at = [q(1, 1), q(0, 1), q(0, 1)];
        let k = |jet: &Jet<Rational, 3>| implicit_surface::curvature(jet).expect("regular").gaussian;
        let before = Jet::of_polynomial(&sphere(), &at);
        assert_eq!((k(&before), k(&doubling.moved_jet(&before))), (q(1, 1), q(1, 4)));
    }
}

mod cu_208 {
    use super::*;

    proptest! {
        #[test]
        fn tangents_of_the_moved_surface_are_the_moved_tangents(surface in surface(), a in affine()) {
            let moved = moved_surface(&surface, &a);
            for i in 0..2 {
                let tangent = |s: &[Jet<Rational, 2>; 3]| Vector(s.each_ref().map(|x| x.gradient[i].clone()));
                prop_assert_eq!(tangent(&moved), a.tangent(&tangent(&surface)));
            }
        }

        /// And of level sets: what is tangent stays tangent.
        #[test]
        fn moved_tangents_are_tangent_to_the_moved_level_set(jet in regular_jet(), a in affine(), v in vector()) {
            let v = jet.gradient.cross(&v);
            prop_assert!(a.moved_jet(&jet).gradient.dot(&a.tangent(&v)).is_zero());
        }
    }
}

mod cu_209 {
    use super::*;

    #[test]
    fn a_turn_keeps_the_normal_and_a_shear_does_not() {
        // Turned by 3, 4, 5 about z: A e₁ is the normal of the turned plane x = 0. Sheared by (x, y) ↦ (x, y + x): A e₁ is not.
        let n = Vector([1, 0, 0].map(Rational::from));
        let (e2, zero) = (Vector([0, 1, 0].map(Rational::from)), Vector::zero());
        let turn = Matrix([[q(3, 5), q(-4, 5), q(0, 1)], [q(4, 5), q(3, 5), q(0, 1)], [q(0, 1), q(0, 1), q(1, 1)]]);
        let turn = Affine::rigid(&Orthogonal::new(turn).expect("orthogonal"), zero.clone());
        let shear = Affine::new(Matrix([[1, 0, 0], [1, 1, 0], [0, 0, 1]].map(|row| row.map(Rational::from))), zero);
        let shear = shear.expect("det = 1");
        assert!(turn.carries_normal(&n) && turn.tangent(&n).dot(&turn.tangent(&e2)).is_zero());
        assert_eq!(turn.tangent(&n), turn.normal(&n));
        assert!(!shear.carries_normal(&n) && shear.tangent(&n).dot(&shear.tangent(&e2)) == 1);
        // Read as N(T(p)) = N(p), the turn changes N.
        assert_ne!(turn.normal(&n), n);
    }

    proptest! {
        #[test]
        fn rigid_motions_and_scalings_carry_every_normal(r in orthogonal(), n in vector(), m in vector(), factor in small()) {
            let motion = Affine::rigid(&r, Vector::zero());
            prop_assert!(motion.carries_normal(&n));
            prop_assert_eq!(motion.tangent(&n).dot(&motion.tangent(&m)), n.dot(&m));
            if let Ok(scaling) = Affine::scaling(&factor) {
                prop_assert!(scaling.carries_normal(&n));
            }
        }

        #[test]
        fn a_normal_is_carried_iff_its_image_is_along_the_new_one(a in affine(), n in vector()) {
            prop_assert_eq!(a.carries_normal(&n), a.tangent(&n).cross(&a.normal(&n)) == Vector::zero());
        }
    }
}

mod cu_210 {
    use super::*;

    #[test]
    fn a_mirror_turns_a_parametrisation_s_normal_round() {
        // σ = (u, v, 0), mirrored in its own plane: it stays as it is, and so does its normal e₃; A⁻ᵀe₃ = −e₃.
        let mirror = Affine::new(diagonal([1, 1, -1]), Vector::zero()).expect("det = −1");
        let [u, v] = Jet::variables(&[q(0, 1), q(0, 1)]);
        let surface = [u, v, Jet::integer(0)];
        let normal = |s: &[Jet<Rational, 2>; 3]| FundamentalForms::new(s).normal_w;
        let e3 = Vector([0, 0, 1].map(Rational::from));
        assert_eq!(normal(&surface), e3);
        assert_eq!(normal(&moved_surface(&surface, &mirror)), e3);
        assert_eq!(mirror.normal(&e3), -e3.clone());
        assert_eq!(mirror.parametric_normal(&e3), e3);
    }

    #[test]
    fn the_image_is_of_unit_length_for_orthogonal_maps_alone() {
        let n = Vector([0, 0, 1].map(Rational::from));
        let stretch = Affine::new(diagonal([1, 1, 2]), Vector::zero()).expect("det = 2");
        assert_eq!(stretch.normal(&n).norm_squared(), q(1, 4));
        assert!(Affine::new(diagonal([1, 0, 1]), Vector::zero()).is_err());
    }

    proptest! {
        #[test]
        fn products_with_tangents_are_kept(a in affine(), n in vector(), v in vector()) {
            prop_assert_eq!(a.normal(&n).dot(&a.tangent(&v)), n.dot(&v));
        }

        #[test]
        fn the_cross_product_moves_by_det_a_times_a_inverse_transposed(surface in surface(), a in affine()) {
            let normal = |s: &[Jet<Rational, 2>; 3]| FundamentalForms::new(s).normal_w;
            prop_assert_eq!(normal(&moved_surface(&surface, &a)), a.parametric_normal(&normal(&surface)));
        }

        #[test]
        fn a_rigid_motion_takes_the_unit_normal_to_the_unit_normal(r in orthogonal(), n in vector()) {
            let motion = Affine::rigid(&r, Vector::zero());
            prop_assert_eq!(motion.normal(&n), r.matrix().apply(&n));
            prop_assert_eq!(motion.normal(&n).norm_squared(), n.norm_squared());
        }
    }
}

mod cu_213 {
    use super::*;

    proptest! {
        #[test]
        fn cayley_s_transform_is_the_quaternion_1_plus_v(v in vector()) {
            let [x, y, z] = v.0.clone();
            let turn = Orthogonal::cayley(&v);
            prop_assert_eq!(&turn, &Orthogonal::of_quaternion(&[q(1, 1), x, y, z]).expect("not zero"));
            prop_assert_eq!(Orthogonal::new(turn.matrix().clone()), Ok(turn.clone()));
            prop_assert_eq!(turn.orientation(), Sign::Positive);
            prop_assert_eq!(turn.matrix().apply(&v), v.clone());
            // The angle is 2 arctan |v|: tr R = 1 + 2cos θ, cos θ = (1 − |v|²)/(1 + |v|²).
            let m = turn.matrix();
            let trace = Rational::from(&m.0[0][0] + &m.0[1][1]) + &m.0[2][2];
            let square = v.norm_squared();
            prop_assert_eq!((trace - 1_u32) * (square.clone() + 1_u32), (q(1, 1) - square) * 2_u32);
            // By the right-hand rule: ⟨w × Rw, v⟩ has the sign of sin θ > 0.
            for axis in 0..3 {
                let w = v.cross(&Vector([0, 1, 2].map(|i| q(i64::from(i == axis), 1))));
                let turned = w.cross(&m.apply(&w)).dot(&v);
                prop_assert_eq!(turned.sign(), w.norm_squared().sign());
            }
        }

        #[test]
        fn quaternions_make_orthogonal_matrices(r in orthogonal()) {
            prop_assert_eq!(Orthogonal::new(r.matrix().clone()), Ok(r.clone()));
            prop_assert_eq!(r.opposite().orientation(), -r.orientation());
        }
    }

    #[test]
    fn what_is_not_orthogonal_is_told() {
        let stretched = Orthogonal::new(diagonal([1, 2, 1]));
        assert_eq!(stretched, Err(NotOrthogonal::Columns { i: 1, j: 1, product: q(4, 1) }));
        assert_eq!(Orthogonal::of_quaternion(&[0; 4].map(Rational::from)), Err(NotOrthogonal::ZeroQuaternion));
        // A half-turn about x is a quaternion without a real part.
        let half = Orthogonal::of_quaternion(&[0, 1, 0, 0].map(Rational::from)).expect("not zero");
        assert_eq!(half.matrix(), &diagonal([1, -1, -1]));
    }
}

mod cu_214 {
    use super::*;

    proptest! {
        #[test]
        fn affine_maps_multiply_k_by_a_positive_factor(jet in regular_jet(), a in affine()) {
            let factor = a.gaussian_factor(&jet.gradient).expect("regular");
            let [before, after] = [jet.clone(), a.moved_jet(&jet)]
                .map(|jet| implicit_surface::curvature(&jet).expect("regular").gaussian);
            prop_assert_eq!(after, before * &factor);
            prop_assert_eq!(factor.sign(), Sign::Positive);
        }

        /// The same of a parametrised surface: (EG − F²)² over that of the image, times (det A)².
        #[test]
        fn it_is_the_factor_of_parametrised_surfaces(surface in surface(), a in affine()) {
            let Ok(before) = parametric_surface::curvature(&surface) else { return Ok(()) };
            let after = parametric_surface::curvature(&moved_surface(&surface, &a)).expect("A is invertible");
            let factor = a.gaussian_factor(&before.forms.normal_w).expect("regular");
            prop_assert_eq!(&after.gaussian, &(before.gaussian.clone() * factor));
        }
    }

    #[test]
    fn a_stretched_sphere_is_an_ellipsoid() {
        // x²/4 + y² + z² = 1: K = 1/4 at (0, 1, 0) and 4 at (2, 0, 0).
        let stretch = Affine::new(diagonal([2, 1, 1]), Vector::zero()).expect("det = 2");
        for (at, k) in [([0, 1, 0], q(1, 4)), ([1, 0, 0], q(4, 1))] {
            let jet = Jet::of_polynomial(&sphere(), &at.map(Rational::from));
            assert_eq!(stretch.gaussian_factor(&jet.gradient), Some(k.clone()));
            assert_eq!(implicit_surface::curvature(&stretch.moved_jet(&jet)).expect("regular").gaussian, k);
        }
        assert_eq!(stretch.gaussian_factor(&Vector::zero()), None);
    }
}

mod cu_215 {
    use super::*;

    proptest! {
        #[test]
        fn k_is_kept_and_h_takes_the_sign_of_the_derivative(jet in regular_jet(), first in small(), second in small()) {
            let Ok(after) = implicit_surface::curvature(&relabelled(&jet, &first, &second)) else {
                prop_assert!(first.is_zero());
                return Ok(());
            };
            let before = implicit_surface::curvature(&jet).expect("regular");
            prop_assert_eq!(&after.gaussian, &before.gaussian);
            prop_assert_eq!(&after.mean_squared, &before.mean_squared);
            prop_assert_eq!(after.mean_sign, before.mean_sign * first.sign());
        }

        /// h·f with h ≠ 0 has the zero set of f.
        #[test]
        fn a_product_with_another_function_keeps_the_zero_set_s_curvature(f in polynomial(), h in polynomial(), at in point()) {
            let f = f.clone() - &Multivariate::constant(f.evaluate(&at));
            let factor = h.evaluate(&at).sign();
            let Ok(before) = implicit_surface::curvature(&Jet::of_polynomial(&f, &at)) else { return Ok(()) };
            let after = implicit_surface::curvature(&Jet::of_polynomial(&(f * &h), &at));
            prop_assert_eq!(after.is_err(), factor == Sign::Zero);
            if let Ok(after) = after {
                prop_assert_eq!(&after.gaussian, &before.gaussian);
                prop_assert_eq!(&after.mean_squared, &before.mean_squared);
                prop_assert_eq!(after.mean_sign, before.mean_sign * factor);
            }
        }
    }

    #[test]
    fn minus_f_turns_a_sphere_s_normal_inward() {
        let level = |f: &Multivariate<3>| {
            implicit_surface::curvature(&Jet::of_polynomial(f, &[q(1, 1), q(0, 1), q(0, 1)]))
                .expect("regular")
                .mean_sign
        };
        assert_eq!((level(&sphere()), level(&-sphere())), (Sign::Negative, Sign::Positive));
    }
}

mod cu_216 {
    use super::*;

    proptest! {
        #[test]
        fn an_improper_motion_changes_the_sign_of_h_for_parametrisations_alone(
            surface in surface(), jet in regular_jet(), r in orthogonal(),
        ) {
            let motion = Affine::rigid(&r, Vector::zero());
            if let Ok(before) = parametric_surface::curvature(&surface) {
                let after = parametric_surface::curvature(&moved_surface(&surface, &motion)).expect("regular");
                prop_assert_eq!(&after.gaussian, &before.gaussian);
                prop_assert_eq!(&after.mean_squared, &before.mean_squared);
                prop_assert_eq!(after.mean_sign, before.mean_sign * r.orientation());
            }
            let [before, after] = [jet.clone(), motion.moved_jet(&jet)]
                .map(|jet| implicit_surface::curvature(&jet).expect("regular").mean_sign);
            prop_assert_eq!(before, after);
        }
    }
    #[test]
    fn a_mirrored_jet_has_the_same_h() {
        let mirror = Orthogonal::new(diagonal([1, 1, -1])).expect("orthogonal");
        assert_eq!(mirror.orientation(), Sign::Negative);
        let bowl = jet([0, 0, 1], [-2, 0, 0, -2, 0, 0]);
        let there = Affine::rigid(&mirror, Vector::zero()).moved_jet(&bowl);
        assert_eq!(there.gradient, -bowl.gradient.clone());
        let sign = |jet: &Jet<Rational, 3>| implicit_surface::curvature(jet).expect("regular").mean_sign;
        assert_eq!((sign(&bowl), sign(&there)), (Sign::Positive, Sign::Positive));
    }
}

mod cu_218 {
    use super::*;

    proptest! {
        #[test]
        fn rigid_motions_keep_the_first_form_and_scalings_multiply_it(surface in surface(), r in orthogonal(), factor in small()) {
            let before = FundamentalForms::new(&surface);
            let after = FundamentalForms::new(&moved_surface(&surface, &Affine::rigid(&r, Vector::zero())));
            prop_assert_eq!(&after.first, &before.first);
            prop_assert_eq!(after.w_squared(), before.w_squared());
            let Ok(scaling) = Affine::scaling(&factor) else { return Ok(()) };
            let scaled = FundamentalForms::new(&moved_surface(&surface, &scaling));
            let square = Rational::from(factor.square_ref());
            prop_assert_eq!(scaled.w_squared(), before.w_squared() * square.square());
        }
    }
}
