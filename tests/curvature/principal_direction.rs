//! Normal curvature, principal directions, Euler's formula.

use super::level::{jet, regular_jet, small};
use super::q;
use isoracle::curvature::implicit_graph::{Axis, forms_along, tangent_basis};
use isoracle::curvature::implicit_surface;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::principal_direction::{
    DirectionError, PrincipalDirections, euler_w, is_principal, normal_curvature, principal_directions,
};
use isoracle::curvature::shape_operator::ShapeOperator;
use isoracle::linear::Vector;
use isoracle::number::{Rational, Ring, Surd};
use proptest::prelude::*;

/// A tangent vector with these coordinates in the basis of a graph.
fn tangent(jet: &Jet<Rational, 3>, s: &Rational, t: &Rational) -> Vector<Rational, 3> {
    let basis = Axis::ALL.iter().find_map(|&axis| tangent_basis(jet, axis).ok());
    let [a, b] = basis.expect("∇f ≠ 0");
    a.scaled(s) + &b.scaled(t)
}

/// |∇f|, in ℚ(√|∇f|²).
fn length(jet: &Jet<Rational, 3>) -> Surd {
    Surd::sqrt(&jet.gradient.norm_squared()).expect("a sum of squares")
}

mod cu_194 {
    use super::*;

    proptest! {
        #[test]
        fn principal_directions_are_where_the_normal_curvature_is_principal(jet in regular_jet()) {
            let PrincipalDirections::Two(directions) = principal_directions(&jet).expect("regular") else { return Ok(()) };
            let scaled = ShapeOperator::new(&jet).expect("regular").scaled_principal();
            prop_assert!(scaled[0] > scaled[1]);
            let embedded = |x: &Rational| Surd::from(x.clone());
            let (n, hessian) = (jet.gradient.map(embedded), jet.hessian.0.each_ref().map(|row| row.each_ref().map(embedded)));
            for (v, k) in directions.iter().zip(scaled) {
                prop_assert_eq!(n.dot(v), Surd::integer(0));
                let bent = Vector(hessian.each_ref().map(|row| Vector(row.clone()).dot(v)));
                prop_assert_eq!(-v.dot(&bent), v.norm_squared() * &k);
                // det(v, ∇f, Hess f v) = 0
                prop_assert_eq!(v.cross(&n).dot(&bent), Surd::integer(0));
            }
        }

        #[test]
        fn a_tangent_vector_is_principal_iff_it_is_along_one_of_the_two(
            jet in regular_jet(), s in small(), t in small(),
        ) {
            let v = tangent(&jet, &s, &t);
            let Ok(principal) = is_principal(&jet, &v) else { return Ok(()) };
            let v = v.map(|x| Surd::from(x.clone()));
            let expected = match principal_directions(&jet).expect("regular") {
                PrincipalDirections::Umbilic(_) => true,
                PrincipalDirections::Two(directions) => directions.iter().any(|d| d.cross(&v) == Vector::zero()),
            };
            prop_assert_eq!(principal, expected);
        }
    }

    #[test]
    fn on_a_cylinder_they_are_its_axis_and_across_it() {
        // y² + z² at (0, 3, 4), outward: k₁ = 0 along x, k₂ = −1/5 across.
        let jet = jet([0, 6, 8], [0, 0, 0, 2, 0, 2]);
        let PrincipalDirections::Two([first, second]) = principal_directions(&jet).expect("regular") else {
            panic!("no umbilic")
        };
        let e1 = Vector([1, 0, 0].map(Surd::integer));
        assert_eq!(first.cross(&e1), Vector::zero());
        assert_eq!(second.cross(&Vector([0, 4, -3].map(Surd::integer))), Vector::zero());
        assert_eq!(principal_directions(&super::super::level::jet([0; 3], [1; 6])), Err(DirectionError::Singular));
    }
}

mod cu_195 {
    use super::*;

    #[test]
    fn along_a_great_circle_it_is_minus_1_over_r() {
        // x² + y² + z² at (1, 2, 2): r = 3
        let jet = jet([2, 4, 4], [2, 0, 0, 2, 0, 2]);
        for v in [[2, -1, 0], [0, 1, -1], [4, 0, -2]] {
            assert_eq!(normal_curvature(&jet, &Vector(v.map(Rational::from))), Ok(Surd::from(q(-1, 3))));
        }
    }

    #[test]
    fn what_is_no_direction_is_an_error() {
        let jet = jet([0, 0, 2], [1, 0, 0, 1, 0, 0]);
        let v = |v: [i64; 3]| Vector(v.map(Rational::from));
        assert_eq!(normal_curvature(&jet, &v([0, 0, 0])), Err(DirectionError::Zero));
        assert_eq!(normal_curvature(&jet, &v([1, 0, 3])), Err(DirectionError::NotTangent { product: q(6, 1) }));
        let singular = super::super::level::jet([0; 3], [1; 6]);
        assert_eq!(normal_curvature(&singular, &v([1, 0, 0])), Err(DirectionError::Singular));
    }

    proptest! {
        /// II(v)/I(v) in the graph's coordinates.
        #[test]
        fn it_is_the_quotient_of_the_fundamental_forms(jet in regular_jet(), s in small(), t in small()) {
            for axis in Axis::ALL {
                let (Ok(forms), Ok([a, b])) = (forms_along(&jet, axis), tangent_basis(&jet, axis)) else { continue };
                let quadratic = |[e, f, g]: &[Rational; 3]| {
                    let mixed = Rational::from(&s * &t) * f * 2_u32;
                    Rational::from(s.square_ref()) * e + mixed + Rational::from(t.square_ref()) * g
                };
                let Ok(k) = normal_curvature(&jet, &(a.scaled(&s) + &b.scaled(&t))) else {
                    prop_assert!(s.is_zero() && t.is_zero());
                    continue;
                };
                let quotient = quadratic(&forms.second_w) / quadratic(&forms.first);
                prop_assert_eq!(k * &length(&jet), Surd::from(quotient));
            }
        }

        /// k(v) + k(N × v) = 2H
        #[test]
        fn two_directions_across_one_another_have_2_h(jet in regular_jet(), s in small(), t in small()) {
            let v = tangent(&jet, &s, &t);
            let Ok(k) = normal_curvature(&jet, &v) else { return Ok(()) };
            let across = normal_curvature(&jet, &jet.gradient.cross(&v)).expect("tangent");
            prop_assert_eq!(k + &across, ShapeOperator::new(&jet).expect("regular").trace());
        }
    }
}

mod cu_196 {
    use super::*;

    proptest! {
        #[test]
        fn euler_s_formula_gives_the_normal_curvature(jet in regular_jet(), s in small(), t in small()) {
            let v = tangent(&jet, &s, &t);
            match (euler_w(&jet, &v), normal_curvature(&jet, &v)) {
                (Ok(euler), Ok(k)) => {
                    prop_assert_eq!(euler.clone(), k * &length(&jet));
                    let [k1, k2] = ShapeOperator::new(&jet).expect("regular").scaled_principal();
                    prop_assert!(k2 <= euler && euler <= k1);
                }
                (euler, k) => prop_assert_eq!(euler.err(), k.err()),
            }
        }
    }
}

mod cu_198 {
    use super::*;

    proptest! {
        #[test]
        fn directions_are_free_at_umbilics_alone(jet in regular_jet()) {
            let level = implicit_surface::curvature(&jet).expect("regular");
            let umbilic = matches!(principal_directions(&jet), Ok(PrincipalDirections::Umbilic(_)));
            prop_assert_eq!(umbilic, level.discriminant().is_zero());
            if umbilic {
                for v in [tangent(&jet, &q(1, 1), &q(0, 1)), tangent(&jet, &q(2, 1), &q(-3, 1))] {
                    prop_assert_eq!(is_principal(&jet, &v), Ok(true));
                }
            }
        }
    }

    #[test]
    fn a_hair_from_an_umbilic_there_are_two() {
        let hair = Rational::from((1, isoracle::number::Integer::from(1) << 200));
        let mut jet = jet([0, 0, 1], [2, 0, 0, 2, 0, 0]);
        assert!(matches!(principal_directions(&jet), Ok(PrincipalDirections::Umbilic(_))));
        jet.hessian.0[0][1] += &hair;
        jet.hessian.0[1][0] += &hair;
        assert!(matches!(principal_directions(&jet), Ok(PrincipalDirections::Two(_))));
    }
}
