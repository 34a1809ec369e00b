//! Kinds of points; principal curvatures as roots of a rational quartic.

use super::level::{any_jet, jet, small, sphere, terms};
use super::q;
use isoracle::curvature::implicit_surface::{self, LevelSurface};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::point_kind::{PointKind, quadric_with};
use isoracle::number::{Algebraic, Polynomial, Rational, Sign, Surd};
use proptest::prelude::*;

fn at_origin(f: &isoracle::number::Multivariate<3>) -> LevelSurface {
    implicit_surface::curvature(&Jet::of_polynomial(f, &[q(0, 1), q(0, 1), q(0, 1)])).expect("f_z = 1")
}

mod cu_193 {
    use super::*;

    proptest! {
        #[test]
        fn the_isolated_roots_are_the_surds(jet in any_jet()) {
            let Ok(level) = implicit_surface::curvature(&jet) else { return Ok(()) };
            let [k1, k2] = level.principal_roots();
            prop_assert!(k1 >= k2);
            for (root, k) in [&k1, &k2].into_iter().zip(level.principal().enclosure(300)) {
                // Where k is irrational, the bounds are within 2⁻¹⁰⁰ of it.
                let (lo, hi) = k.bounds().expect("finite");
                let fine = root.refined(100);
                let (a, b) = fine.bounds();
                prop_assert!(*a <= hi && lo <= *b);
                prop_assert!(root.sign_of(&level.principal_quartic()) == Sign::Zero);
            }
            // Roots of k² ∓ 2|H|k + K are told from those of the other sign by H and K: product and order.
            let zero = Algebraic::from(q(0, 1));
            let signs = [&k1, &k2].map(|k| Sign::of(k.cmp(&zero)));
            prop_assert_eq!(signs[0] * signs[1], Sign::of(level.gaussian.cmp0()));
        }

        #[test]
        fn planted_principal_curvatures_are_found(a in small(), b in small()) {
            let [k1, k2] = at_origin(&quadric_with(&a, &b)).principal_roots();
            let (larger, smaller) = if a < b { (b, a) } else { (a, b) };
            prop_assert_eq!(k1.rational(), Some(&larger));
            prop_assert_eq!(k2.rational(), Some(&smaller));
        }
    }

    #[test]
    fn the_quartic_of_minus_2_and_3() {
        let level = at_origin(&quadric_with(&q(-2, 1), &q(3, 1)));
        let expected = Polynomial::new([36, 0, -13, 0, 1].map(Rational::from).to_vec());
        assert_eq!(level.principal_quartic(), expected);
    }

    #[test]
    fn curvatures_in_no_common_quadratic_field_are_roots_all_the_same() {
        // ∇f = (1, 1, 0): H ∈ √2·ℚ, and H² − K is no square of either.
        let level = implicit_surface::curvature(&jet([1, 1, 0], [1, 0, 1, 2, 0, 3])).expect("regular");
        assert!(level.principal().exact().is_none());
        let [k1, k2] = level.principal_roots();
        assert!(k1.rational().is_none() && k2.rational().is_none() && k1 > k2);
    }
}

mod cu_197 {
    use super::*;

    #[test]
    fn each_kind_has_its_example() {
        let kinds = [
            ([0, 0], PointKind::Planar),
            ([0, 3], PointKind::Parabolic),
            ([-3, 0], PointKind::Parabolic),
            ([-1, 2], PointKind::Hyperbolic),
            ([-1, 1], PointKind::Hyperbolic),
            ([1, 2], PointKind::Elliptic),
            ([-2, -1], PointKind::Elliptic),
            ([2, 2], PointKind::Umbilic),
            ([-2, -2], PointKind::Umbilic),
        ];
        for (k, kind) in kinds {
            let [a, b] = k.map(Rational::from);
            assert_eq!(at_origin(&quadric_with(&a, &b)).kind(), kind, "{k:?}");
        }
    }

    #[test]
    fn a_torus_has_all_but_planar_and_umbilic_points() {
        // (x² + y² + z² + 3)² − 16(x² + y²): R = 2, r = 1
        let r = sphere() + &terms(&[([0, 0, 0], 3)]);
        let f = r.clone() * &r - &terms(&[([2, 0, 0], 16), ([0, 2, 0], 16)]);
        let kinds = [
            ([q(3, 1), q(0, 1), q(0, 1)], PointKind::Elliptic),
            ([q(1, 1), q(0, 1), q(0, 1)], PointKind::Hyperbolic),
            ([q(2, 1), q(0, 1), q(1, 1)], PointKind::Parabolic),
            ([q(0, 1), q(13, 5), q(-4, 5)], PointKind::Elliptic),
            ([q(0, 1), q(7, 5), q(4, 5)], PointKind::Hyperbolic),
        ];
        for (at, kind) in kinds {
            assert_eq!(f.evaluate(&at), 0);
            assert_eq!(implicit_surface::curvature(&Jet::of_polynomial(&f, &at)).expect("regular").kind(), kind);
        }
    }

    proptest! {
        #[test]
        fn the_kind_is_that_of_the_principal_curvatures_signs(jet in any_jet()) {
            let Ok(level) = implicit_surface::curvature(&jet) else { return Ok(()) };
            let zero = Algebraic::from(q(0, 1));
            let [k1, k2] = level.principal_roots();
            let expected = match (Sign::of(k1.cmp(&zero)) * Sign::of(k2.cmp(&zero)), k1 == k2) {
                (Sign::Negative, _) => PointKind::Hyperbolic,
                (Sign::Zero, true) => PointKind::Planar,
                (Sign::Zero, false) => PointKind::Parabolic,
                (Sign::Positive, true) => PointKind::Umbilic,
                (Sign::Positive, false) => PointKind::Elliptic,
            };
            prop_assert_eq!(level.kind(), expected);
        }
    }
}

mod cu_199 {
    use super::*;

    proptest! {
        #[test]
        fn every_number_is_a_curvature(a in small(), b in small()) {
            let level = at_origin(&quadric_with(&a, &b));
            prop_assert_eq!(&level.gaussian, &Rational::from(&a * &b));
            let mean = Rational::from(&a + &b) / 2_u32;
            prop_assert_eq!(level.principal().mean(), Surd::from(mean));
        }
    }
}
