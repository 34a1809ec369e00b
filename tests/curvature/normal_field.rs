//! The unit normal, the Hessian and the projections of the text's derivation of dN.

use super::level::{jet, point, polynomial, regular_jet, sphere};
use super::q;
use isoracle::curvature::gradient::{gradient, hessian};
use isoracle::curvature::implicit_graph::{self as graph, Axis};
use isoracle::curvature::implicit_printed::{self as printed, printed_normal_derivative_w};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::shape_operator::{self as operator, ShapeOperator};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Rational, Ring, Surd};
use proptest::prelude::*;

fn surds(v: &Vector<Rational, 3>) -> Vector<Surd, 3> {
    v.map(|x| Surd::from(x.clone()))
}

mod cu_152 {
    use super::*;

    proptest! {
        #[test]
        fn the_normal_is_across_the_kernel_of_df(jet in regular_jet()) {
            let normal = ShapeOperator::new(&jet).expect("regular").unit_normal();
            prop_assert_eq!(normal.norm_squared(), Surd::integer(1));
            for axis in Axis::ALL {
                let Ok(tangents) = graph::tangent_basis(&jet, axis) else { continue };
                for v in tangents {
                    prop_assert!(jet.gradient.dot(&v).is_zero());
                    prop_assert_eq!(normal.dot(&surds(&v)), Surd::integer(0));
                }
            }
            // What is across every tangent vector is a multiple of ∇f.
            prop_assert_eq!(normal.cross(&surds(&jet.gradient)), Vector::zero());
        }
    }
}

mod cu_174 {
    use super::*;

    #[test]
    fn the_normal_points_to_larger_values() {
        let jet = Jet::of_polynomial(&sphere(), &[q(2, 3), q(-1, 3), q(2, 3)]);
        let normal = ShapeOperator::new(&jet).expect("regular").unit_normal();
        assert_eq!(normal, Vector([q(2, 3), q(-1, 3), q(2, 3)].map(Surd::from)));
        assert!(ShapeOperator::new(&self::jet([0; 3], [1; 6])).is_err());
    }
}

mod cu_177 {
    use super::*;

    proptest! {
        #[test]
        fn the_derivative_of_the_squared_norm_is_a_product(f in polynomial(), at in point()) {
            let jet = Jet::of_polynomial(&f, &at);
            let derivative = gradient(&f).norm_squared();
            let derivative = gradient(&derivative).map(|g| g.evaluate(&at));
            prop_assert_eq!(&printed::squared_norm_derivative(&jet), &derivative);
            // 2∇fᵀ·Hess f as a product of matrices
            let product = jet.hessian.transposed().apply(&jet.gradient).scaled(&q(2, 1));
            prop_assert_eq!(&product, &derivative);
        }

        #[test]
        fn the_third_line_is_the_second(jet in regular_jet()) {
            let [_, second, third, ..] = printed_normal_derivative_w(&jet).expect("regular");
            prop_assert_eq!(second, third);
        }
    }
}

mod cu_180 {
    use super::*;

    proptest! {
        #[test]
        fn the_hessian_is_symmetric_and_that_of_the_jet(f in polynomial(), at in point()) {
            let fields = hessian(&f);
            prop_assert_eq!(&fields, &fields.transposed());
            let jet = Jet::of_polynomial(&f, &at);
            prop_assert_eq!(Matrix::from_fn(|i, j| fields.0[i][j].evaluate(&at)), jet.hessian);
        }
    }
}

mod cu_181 {
    use super::*;

    proptest! {
        #[test]
        fn the_two_projections_are_orthogonal_and_sum_to_one(jet in regular_jet()) {
            let (n, p) = (&jet.gradient, operator::projection(&jet.gradient));
            let along = Matrix::from_fn(|i, j| Rational::from(i32::from(i == j)) - &p.0[i][j]);
            for a in [&p, &along] {
                prop_assert_eq!(&a.times(a), a);
                prop_assert_eq!(&a.transposed(), a);
            }
            prop_assert_eq!(p.apply(n), Vector::zero());
            prop_assert_eq!(&along.apply(n), n);
            // The ranks are the traces: a plane and a line.
            prop_assert_eq!((operator::trace(&p), operator::trace(&along)), (q(2, 1), q(1, 1)));
            for axis in Axis::ALL {
                for v in graph::tangent_basis(&jet, axis).into_iter().flatten() {
                    prop_assert_eq!(p.apply(&v), v);
                }
            }
        }
    }
}
