//! The matrix of dN: the text's five lines, its eigenvalues, its norm, and the principal curvatures from these.

use super::level::{jet, point, polynomial, regular_jet, sphere, terms};
use super::q;
use isoracle::curvature::gradient::gradient;
use isoracle::curvature::implicit_graph::{self as graph, Axis};
use isoracle::curvature::implicit_printed::{self as printed, printed_normal_derivative_w};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::principal_direction::{PrincipalDirections, principal_directions};
use isoracle::curvature::shape_operator::{self as operator, ShapeOperator};
use isoracle::curvature::{implicit_surface, parametric_surface};
use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::number::{OrderedField, Polynomial, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

type Square = Matrix<Rational, 3, 3>;

fn minus(a: &Square) -> Square {
    Matrix(a.0.clone().map(|row| row.map(|x| -x)))
}

fn surds(v: &Vector<Rational, 3>) -> Vector<Surd, 3> {
    v.map(|x| Surd::from(x.clone()))
}

/// The plane x = 0 as the zero set of x(1 + y), at the origin: ∇f = (1, 0, 0), Hess f·N = (0, 1, 0).
fn plane_by_a_product() -> Jet<Rational, 3> {
    jet([1, 0, 0], [0, 1, 0, 0, 0, 0])
}

/// |∇f|dN from the rational field NNᵀ = ∇f∇fᵀ/|∇f|²: its derivative applied to ∇f, for NᵀdN = 0.
fn derivative_of_the_projection(f: &isoracle::number::Multivariate<3>, at: &[Rational; 3]) -> Option<Square> {
    let n = gradient(f).map(|g| Jet::of_polynomial(g, at));
    let scale = n.norm_squared().reciprocal()?;
    let entry = |i: usize, k: usize| {
        (0..3).fold(q(0, 1), |sum, j| {
            let field = n[i].clone() * &n[j] * &scale;
            sum + Rational::from(&field.gradient[k] * &n[j].value)
        })
    };
    Some(Matrix::from_fn(entry))
}

mod cu_175 {
    use super::*;

    #[test]
    fn on_the_unit_sphere_the_first_line_is_minus_the_derivative() {
        // N = p/|p|: at (1, 0, 0) dN = diag(0, 1, 1).
        let at = [q(1, 1), q(0, 1), q(0, 1)];
        let jet = Jet::of_polynomial(&sphere(), &at);
        let [first, ..] = printed_normal_derivative_w(&jet).expect("regular");
        let truth = derivative_of_the_projection(&sphere(), &at).expect("regular");
        let diagonal = |x: i64| Matrix::from_fn(|i, j| q(if i == j && i > 0 { x } else { 0 }, 1));
        assert_eq!((truth, first), (diagonal(2), diagonal(-2)));
    }

    proptest! {
        #[test]
        fn the_first_line_is_minus_the_derivative_of_the_normal(f in polynomial(), at in point()) {
            let Some(truth) = derivative_of_the_projection(&f, &at) else {
                prop_assert!(printed_normal_derivative_w(&Jet::of_polynomial(&f, &at)).is_err());
                return Ok(());
            };
            let [first, ..] = printed_normal_derivative_w(&Jet::of_polynomial(&f, &at)).expect("regular");
            prop_assert_eq!(first, minus(&truth));
        }
    }
}

mod cu_176 {
    use super::*;

    #[test]
    fn on_the_unit_sphere_the_second_line_is_minus_the_derivative() {
        let at = [q(1, 1), q(0, 1), q(0, 1)];
        let [_, second, ..] = printed_normal_derivative_w(&Jet::of_polynomial(&sphere(), &at)).expect("regular");
        let truth = derivative_of_the_projection(&sphere(), &at).expect("regular");
        assert_eq!(second, minus(&truth));
        assert_ne!(second, truth);
    }

    proptest! {
        #[test]
        fn the_second_line_is_the_first(jet in regular_jet()) {
            let [first, second, ..] = printed_normal_derivative_w(&jet).expect("regular");
            prop_assert_eq!(first, second);
        }
    }
}

mod cu_178 {
    use super::*;

    #[test]
    fn with_the_hessian_inside_its_bracket_a_plane_bends() {
        // f = x: Hess f = 0 and dN = 0, but the fourth line is −I.
        let jet = jet([1, 0, 0], [0; 6]);
        let [_, _, third, fourth, fifth] = printed_normal_derivative_w(&jet).expect("regular");
        let zero = Matrix::from_fn(|_, _| q(0, 1));
        assert_eq!((third, fifth), (zero.clone(), zero));
        assert_eq!(fourth, minus(&Matrix::identity()));
    }

    proptest! {
        /// The difference is I − Hess f: the line is right for Hess f = I alone.
        #[test]
        fn the_fourth_line_is_off_by_the_hessian_less_one(jet in regular_jet()) {
            let [_, _, third, fourth, _] = printed_normal_derivative_w(&jet).expect("regular");
            let difference: Square = Matrix::from_fn(|i, j| Rational::from(&third.0[i][j] - &fourth.0[i][j]));
            let expected: Square = Matrix::from_fn(|i, j| Rational::from(i32::from(i == j)) - &jet.hessian.0[i][j]);
            prop_assert_eq!(difference, expected);
        }
    }
}

mod cu_179 {
    use super::*;

    #[test]
    fn on_the_unit_sphere_equation_16_is_minus_the_derivative() {
        let at = [q(0, 1), q(1, 1), q(0, 1)];
        let jet = Jet::of_polynomial(&sphere(), &at);
        let shape = ShapeOperator::new(&jet).expect("regular");
        let [.., fifth] = printed_normal_derivative_w(&jet).expect("regular");
        let truth = derivative_of_the_projection(&sphere(), &at).expect("regular");
        // dN(e₁) = e₁ there, and (16) says −e₁.
        assert_eq!((truth.0[0][0].clone(), fifth.0[0][0].clone()), (q(2, 1), q(-2, 1)));
        assert_eq!(shape.normal_derivative().0[0][0], Surd::integer(1));
        assert_eq!(shape.matrix().0[0][0], Surd::integer(-1));
    }

    proptest! {
        #[test]
        fn the_shape_operator_is_minus_the_derivative_of_the_normal(f in polynomial(), at in point()) {
            let Some(truth) = derivative_of_the_projection(&f, &at) else { return Ok(()) };
            let shape = ShapeOperator::new(&Jet::of_polynomial(&f, &at)).expect("regular");
            prop_assert_eq!(shape.scaled(), &minus(&truth));
        }

        #[test]
        fn the_fifth_line_is_the_third_and_the_shape_operator(jet in regular_jet()) {
            let [_, _, third, _, fifth] = printed_normal_derivative_w(&jet).expect("regular");
            let shape = ShapeOperator::new(&jet).expect("regular");
            prop_assert_eq!(&third, &fifth);
            prop_assert_eq!(shape.scaled(), &fifth);
            let (s, dn) = (shape.matrix(), shape.normal_derivative());
            for (s, dn) in s.0.iter().flatten().zip(dn.0.iter().flatten()) {
                prop_assert_eq!(s.clone() + dn, Surd::integer(0));
            }
        }

        /// Over the plane of x and y: −N_u = Sσᵤ, by the Weingarten equations of the graph.
        #[test]
        fn it_takes_tangent_vectors_where_weingarten_s_equations_do(jet in regular_jet()) {
            let Ok(derivatives) = graph::graph(&jet) else { return Ok(()) };
            let [x, y] = Jet::variables(&[q(0, 1), q(0, 1)]);
            let surface = parametric_surface::curvature(&[x, y, derivatives.jet(q(0, 1))]).expect("a graph");
            let a = surface.weingarten_w();
            let basis = graph::tangent_basis(&jet, Axis::Z).expect("a graph");
            let scaled = ShapeOperator::new(&jet).expect("regular").scaled().clone();
            for i in 0..2 {
                // The graph's normal is sign(f_z)N, and W = |∇f|/|f_z|.
                let derivative = basis[0].scaled(&a.0[0][i]) + &basis[1].scaled(&a.0[1][i]);
                prop_assert_eq!(scaled.apply(&basis[i]), -derivative.scaled(&jet.gradient[2]));
            }
        }
    }
}

mod cu_182 {
    use super::*;

    #[test]
    fn the_normal_of_a_plane_by_a_product_is_no_eigenvector() {
        let shape = ShapeOperator::new(&plane_by_a_product()).expect("regular");
        // (16) applied to N = e₁ is −e₂, not 0.
        assert_eq!(shape.along_normal(), Vector([q(0, 1), q(-1, 1), q(0, 1)]));
    }

    proptest! {
        #[test]
        fn the_normal_is_an_eigenvector_from_the_left(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            prop_assert_eq!(shape.scaled().transposed().apply(&jet.gradient), Vector::zero());
            prop_assert!(determinant3(shape.scaled()).is_zero());
            let parallel = jet.hessian.apply(&jet.gradient).cross(&jet.gradient) == Vector::zero();
            prop_assert_eq!(shape.along_normal() == Vector::zero(), parallel);
        }
    }
}

mod cu_183 {
    use super::*;

    proptest! {
        #[test]
        fn principal_directions_and_the_normal_are_an_orthogonal_basis(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let n = surds(&jet.gradient);
            let [v1, v2] = match principal_directions(&jet).expect("regular") {
                PrincipalDirections::Umbilic(v) | PrincipalDirections::Two(v) => v,
            };
            for (a, b) in [(&v1, &v2), (&v1, &n), (&v2, &n)] {
                prop_assert_eq!(a.dot(b), Surd::integer(0));
                prop_assert_eq!(a.cross(b).norm_squared().sign(), Sign::Positive);
            }
            let scaled = Matrix(shape.scaled().0.clone().map(|row| row.map(Surd::from)));
            for (v, k) in [v1, v2].iter().zip(shape.scaled_principal()) {
                prop_assert_eq!(scaled.apply(v), v.scaled(&k));
            }
        }
    }
}

mod cu_184 {
    use super::*;

    #[test]
    fn in_its_basis_the_matrix_has_a_third_column() {
        // v₁, v₂, N = e₂, e₃, e₁: the printed diagonal is 0, the matrix is not.
        let shape = ShapeOperator::new(&plane_by_a_product()).expect("regular");
        let basis = Matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]].map(|row| row.map(Rational::from)));
        let matrix = basis.transposed().times(shape.scaled()).times(&basis);
        assert_eq!(matrix, Matrix([[0, 0, -1], [0, 0, 0], [0, 0, 0]].map(|row| row.map(Rational::from))));
        let diagonal = printed::printed_diagonal_w(&shape);
        assert_eq!(diagonal, Matrix::from_fn(|_, _| Surd::integer(0)));
    }

    proptest! {
        /// BᵀSPB and BᵀSB, B = (v₁, v₂, N) not of unit length: the first is diagonal, the second up to its last column.
        #[test]
        fn after_the_projection_it_is_diagonal(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let PrincipalDirections::Two([v1, v2]) = principal_directions(&jet).expect("regular") else { return Ok(()) };
            let basis = [v1, v2, surds(&jet.gradient)];
            let diagonal = printed::printed_diagonal_w(&shape);
            let [full, tangential] = [shape.scaled(), &shape.tangential()]
                .map(|a| Matrix::<Surd, 3, 3>(a.0.clone().map(|row| row.map(Surd::from))));
            for (j, v) in basis.iter().enumerate() {
                for (i, u) in basis.iter().enumerate() {
                    let expected = diagonal.0[i][j].clone() * &u.norm_squared();
                    prop_assert_eq!(&u.dot(&tangential.apply(v)), &expected);
                    if j < 2 {
                        prop_assert_eq!(&u.dot(&full.apply(v)), &expected);
                    }
                }
            }
        }
    }
}

mod cu_185 {
    use super::*;

    #[test]
    fn the_trace_of_dn_itself_is_minus_the_sum() {
        let jet = Jet::of_polynomial(&sphere(), &[q(0, 1), q(1, 1), q(0, 1)]);
        let shape = ShapeOperator::new(&jet).expect("regular");
        assert_eq!(shape.trace(), Surd::integer(-2));
        assert_eq!(operator::trace(&shape.normal_derivative()), Surd::integer(2));
        let level = implicit_surface::curvature(&jet).expect("regular");
        assert_eq!(level.principal().exact(), Some([Surd::integer(-1), Surd::integer(-1)]));
    }

    proptest! {
        #[test]
        fn the_trace_is_2_h_and_the_second_invariant_k(jet in regular_jet()) {
            let (shape, level) =
                (ShapeOperator::new(&jet).expect("regular"), implicit_surface::curvature(&jet).expect("regular"));
            let mean = level.principal().mean();
            prop_assert_eq!(shape.trace(), mean.clone() + &mean);
            prop_assert_eq!(shape.second_invariant(), level.gaussian);
        }
    }
}

mod cu_186 {
    use super::*;

    #[test]
    fn the_norm_of_a_plane_by_a_product_is_1() {
        let shape = ShapeOperator::new(&plane_by_a_product()).expect("regular");
        assert_eq!(printed::printed_sum_of_squares(&shape), 1);
        assert_eq!(shape.tangential_frobenius_squared(), 0);
    }

    proptest! {
        #[test]
        fn the_tangential_norm_is_the_sum_of_squares(jet in regular_jet()) {
            let (shape, level) =
                (ShapeOperator::new(&jet).expect("regular"), implicit_surface::curvature(&jet).expect("regular"));
            // k₁² + k₂² = 4H² − 2K = tr(S²)
            let squares = level.mean_squared * 4_u32 - level.gaussian * 2_u32;
            prop_assert_eq!(shape.tangential_frobenius_squared(), squares.clone());
            let trace = operator::trace(&shape.scaled().times(shape.scaled()));
            prop_assert_eq!(trace / jet.gradient.norm_squared(), squares);
        }
    }
}

mod cu_187 {
    use super::*;

    #[test]
    fn with_the_printed_norm_a_plane_has_a_difference_of_root_2() {
        let shape = ShapeOperator::new(&plane_by_a_product()).expect("regular");
        let trace = shape.trace();
        let printed = Surd::from(printed::printed_sum_of_squares(&shape) * 2_u32) - &(trace.clone() * &trace);
        assert_eq!(printed, Surd::integer(2));
        let [k1, k2] = shape.scaled_principal();
        assert_eq!(k1, k2);
    }

    proptest! {
        #[test]
        fn twice_the_squares_less_the_square_of_the_sum_is_the_difference_s_square(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let [k1, k2] = printed::corrected_principal_w(&shape);
            let difference = k1 - &k2;
            let level = implicit_surface::curvature(&jet).expect("regular");
            let expected = level.discriminant() * 4_u32 * jet.gradient.norm_squared();
            prop_assert_eq!(difference.clone() * &difference, Surd::from(expected));
        }
    }
}

mod cu_188 {
    use super::*;

    #[test]
    fn printed_a_plane_has_the_principal_curvatures_of_a_saddle() {
        let shape = ShapeOperator::new(&plane_by_a_product()).expect("regular");
        let half_root = Surd::new(q(0, 1), q(1, 2), &q(2, 1)).expect("2 > 0");
        assert_eq!(printed::printed_principal_w(&shape), [half_root.clone(), -half_root]);
        assert_eq!(printed::corrected_principal_w(&shape), [Surd::integer(0), Surd::integer(0)]);
    }

    proptest! {
        #[test]
        fn with_the_tangential_norm_the_formula_is_right(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            prop_assert_eq!(printed::corrected_principal_w(&shape), shape.scaled_principal());
        }
    }
}

mod cu_189 {
    use super::*;

    proptest! {
        #[test]
        fn the_printed_formula_is_right_iff_s_is_symmetric_iff_it_kills_the_normal(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let off = shape.along_normal().norm_squared();
            prop_assert_eq!(shape.frobenius_squared(), shape.tangential_frobenius_squared() + off.clone());
            let right = printed::printed_principal_w(&shape) == shape.scaled_principal();
            prop_assert_eq!(right, off.is_zero());
            prop_assert_eq!(right, *shape.scaled() == shape.scaled().transposed());
            prop_assert_eq!(right, *shape.scaled() == shape.tangential());
        }
    }

    #[test]
    fn it_depends_on_the_function_and_not_on_the_surface() {
        // x and x(1 + y) have one plane, x² + y² + z² and its product with 1 + x one sphere.
        let at = [q(2, 3), q(1, 3), q(2, 3)];
        let one = terms(&[([0, 0, 0], -1)]);
        let ball = sphere() + &one;
        let twisted = ball.clone() * &terms(&[([0, 0, 0], 1), ([1, 0, 0], 1)]);
        let [good, bad] = [&ball, &twisted].map(|f| ShapeOperator::new(&Jet::of_polynomial(f, &at)).expect("regular"));
        assert!(good.along_normal() == Vector::zero() && bad.along_normal() != Vector::zero());
        assert_eq!(good.second_invariant(), bad.second_invariant());
        assert_eq!(good.trace(), bad.trace());
        assert_eq!(printed::printed_principal_w(&good), good.scaled_principal());
        assert_ne!(printed::printed_principal_w(&bad), bad.scaled_principal());
    }
}

mod cu_190 {
    use super::*;

    proptest! {
        #[test]
        fn its_roots_are_the_principal_curvatures_and_0(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let [k1, k2] = shape.scaled_principal();
            prop_assert!(k1 >= k2);
            let (sum, product) = (k1.clone() + &k2, k1 * &k2);
            let [sum, product] = [sum, product].map(|x| x.rational().expect("symmetric in conjugates").clone());
            let x = Polynomial::new(vec![q(0, 1), q(1, 1)]);
            let quadratic = Polynomial::new(vec![product, -sum, q(1, 1)]);
            prop_assert_eq!(shape.characteristic(), x * &quadratic);
            // Cayley and Hamilton
            let (s, a) = (shape.scaled(), shape.characteristic());
            let c = |i: usize| a.coefficients().get(i).cloned().unwrap_or_default();
            let square = s.times(s);
            let cube = square.times(s);
            let value: Square = Matrix::from_fn(|i, j| {
                cube.0[i][j].clone() + Rational::from(&square.0[i][j] * &c(2)) + Rational::from(&s.0[i][j] * &c(1))
            });
            prop_assert_eq!(value, Matrix::from_fn(|_, _| q(0, 1)));
        }
    }
}

mod cu_191 {
    use super::*;

    proptest! {
        #[test]
        fn the_adjugate_of_the_hessian_takes_the_gradient_to_the_kernel(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let kernel = shape.kernel();
            prop_assert_eq!(shape.scaled().apply(&kernel), Vector::zero());
            // ⟨∇f, kernel⟩ = K|∇f|⁴: not tangent where K ≠ 0.
            let w = jet.gradient.norm_squared();
            prop_assert_eq!(jet.gradient.dot(&kernel), shape.second_invariant() * w.square());
        }
    }
}

mod cu_192 {
    use super::*;

    proptest! {
        #[test]
        fn the_tangential_operator_is_symmetric_and_has_the_same_invariants(jet in regular_jet()) {
            let shape = ShapeOperator::new(&jet).expect("regular");
            let (s, t) = (shape.scaled(), shape.tangential());
            prop_assert_eq!(&t, &t.transposed());
            prop_assert_eq!(t.apply(&jet.gradient), Vector::zero());
            prop_assert_eq!(operator::trace(s), operator::trace(&t));
            prop_assert_eq!(operator::second_invariant(s), operator::second_invariant(&t));
        }
    }
}
