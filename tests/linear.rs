//! Vectors, determinants and linear systems, each against a second derivation.

use isoracle::linear::{LinearError, Matrix, Vector, determinant, determinant2, determinant3, inverse, solve};
use isoracle::number::{F64Interval, Integer, Polynomial, Rational, Ring, Surd};
use proptest::prelude::*;

fn q(p: i64, q: i64) -> Rational {
    Rational::from((p, q))
}

/// Small integers and fractions: singular matrices are common.
fn entry() -> impl Strategy<Value = Rational> {
    prop_oneof![3 => (-2..=2_i64).prop_map(|p| q(p, 1)), 1 => (-9..=9_i64, 1..=9_i64).prop_map(|(p, d)| q(p, d))]
}

fn vector<const N: usize>() -> impl Strategy<Value = Vector<Rational, N>> {
    prop::collection::vec(entry(), N).prop_map(|v| Vector(std::array::from_fn(|i| v[i].clone())))
}

fn matrix<const N: usize>() -> impl Strategy<Value = Matrix<Rational, N, N>> {
    prop::collection::vec(entry(), N * N).prop_map(|v| Matrix::from_fn(|i, j| v[N * i + j].clone()))
}

/// The definition: Σ over the permutations, by cofactors of the first row.
fn by_cofactors<K: Ring>(rows: &[Vec<K>]) -> K {
    let Some((first, below)) = rows.split_first() else { return K::integer(1) };
    let mut sum = K::integer(0);
    for (j, a) in first.iter().enumerate() {
        let minor: Vec<Vec<K>> = below
            .iter()
            .map(|row| row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, x)| x.clone()).collect())
            .collect();
        let term = a.clone() * &by_cofactors(&minor);
        sum = if j % 2 == 0 { sum + &term } else { sum - &term };
    }
    sum
}

fn rows<K: Ring, const N: usize>(a: &Matrix<K, N, N>) -> Vec<Vec<K>> {
    a.0.iter().map(|row| row.to_vec()).collect()
}

mod nu_19 {
    use super::*;

    #[test]
    fn the_cross_product_is_right_handed() {
        let e = |i: usize| Vector::<Integer, 3>(std::array::from_fn(|j| Integer::from(i == j)));
        for i in 0..3 {
            assert_eq!(e(i).cross(&e((i + 1) % 3)), e((i + 2) % 3));
            assert_eq!(e((i + 1) % 3).cross(&e(i)), -e((i + 2) % 3));
        }
    }

    proptest! {
        #[test]
        fn it_is_normal_to_both_and_as_long_as_lagrange_says(a in vector::<3>(), b in vector::<3>(), c in vector::<3>()) {
            let n = a.cross(&b);
            prop_assert_eq!(n.dot(&a), 0);
            prop_assert_eq!(n.dot(&b), 0);
            let dot = a.dot(&b);
            prop_assert_eq!(n.norm_squared(), a.norm_squared() * b.norm_squared() - dot.clone() * &dot);
            prop_assert_eq!(n.dot(&c), determinant3(&Matrix([a.0.clone(), b.0.clone(), c.0.clone()])));
            // a × (b × c) = b⟨a, c⟩ − c⟨a, b⟩
            prop_assert_eq!(a.cross(&b.cross(&c)), b.scaled(&a.dot(&c)) - &c.scaled(&dot));
        }

        #[test]
        fn vectors_are_a_module(a in vector::<4>(), b in vector::<4>(), k in entry()) {
            prop_assert_eq!((a.clone() + &b).scaled(&k), a.scaled(&k) + &b.scaled(&k));
            prop_assert_eq!(a.clone() - &b + &b, a.clone());
            prop_assert_eq!(a.clone() + &-a.clone(), Vector::zero());
            prop_assert_eq!((a.clone() + &b).norm_squared() - (a.clone() - &b).norm_squared(), a.dot(&b) * 4_u32);
        }
    }
}

mod nu_20 {
    use super::*;

    #[test]
    fn known_determinants() {
        // Vandermonde: Π (xⱼ − xᵢ), and the Hilbert matrix of order 4.
        let nodes = [2, 3, 5, 7, 11_i64];
        let vandermonde = Matrix::<Integer, 5, 5>::from_fn(|i, j| Integer::from(nodes[i].pow(j as u32)));
        let product: i64 = (0..5).flat_map(|i| (0..i).map(move |j| nodes[i] - nodes[j])).product();
        assert_eq!(determinant(&vandermonde), product);
        let hilbert = Matrix::<Rational, 4, 4>::from_fn(|i, j| q(1, 1 + i as i64 + j as i64));
        assert_eq!(determinant(&hilbert), q(1, 6_048_000));
        assert_eq!(determinant(&Matrix::<Integer, 0, 0>([])), 1);
        assert_eq!(determinant(&Matrix([[Integer::from(-7)]])), -7);
        assert_eq!(determinant(&Matrix::<Integer, 6, 6>::identity()), 1);
    }

    #[test]
    fn a_characteristic_polynomial_needs_no_division() {
        // det(xI − A) for a companion matrix is its polynomial: x³ − 2x² + 3x − 5.
        let a = [[0, 0, 5], [1, 0, -3], [0, 1, 2_i64]];
        let x = |k: i64| Polynomial::new(vec![q(0, 1), q(k, 1)]);
        let m = Matrix::<Polynomial, 3, 3>::from_fn(|i, j| x((i == j).into()) - &Polynomial::integer(a[i][j]));
        assert_eq!(determinant(&m).to_string(), "-5 + 3·x - 2·x^2 + x^3");
        assert_eq!(determinant3(&m), determinant(&m));
    }

    proptest! {
        #[test]
        fn the_formulas_agree_with_cofactors(a in matrix::<2>(), b in matrix::<3>()) {
            prop_assert_eq!(determinant2(&a), by_cofactors(&rows(&a)));
            prop_assert_eq!(determinant(&a), determinant2(&a));
            prop_assert_eq!(determinant3(&b), by_cofactors(&rows(&b)));
            prop_assert_eq!(determinant(&b), determinant3(&b));
        }

        #[test]
        fn bird_agrees_with_cofactors(a in matrix::<4>(), b in matrix::<5>(), c in matrix::<6>()) {
            prop_assert_eq!(determinant(&a), by_cofactors(&rows(&a)));
            prop_assert_eq!(determinant(&b), by_cofactors(&rows(&b)));
            prop_assert_eq!(determinant(&c), by_cofactors(&rows(&c)));
        }

        #[test]
        fn it_is_multiplicative_and_of_the_transpose(a in matrix::<4>(), b in matrix::<4>()) {
            prop_assert_eq!(determinant(&a.times(&b)), determinant(&a) * determinant(&b));
            prop_assert_eq!(determinant(&a.transposed()), determinant(&a));
        }

        #[test]
        fn over_intervals_it_encloses(a in matrix::<4>()) {
            let enclosed = Matrix::<F64Interval, 4, 4>::from_fn(|i, j| F64Interval::from_rational(&a.0[i][j]));
            prop_assert!(determinant(&enclosed).contains(&determinant(&a)));
        }
    }
}

mod nu_21 {
    use super::*;

    #[test]
    fn a_singular_matrix_is_refused_at_its_first_dependent_column() {
        let a = Matrix([[1, 2, 0], [2, 4, 1], [3, 6, 5]].map(|row| row.map(|x| q(x, 1))));
        let b = Vector([q(1, 1), q(2, 1), q(3, 1)]);
        assert_eq!(solve(&a, &b), Err(LinearError::Singular { column: 1 }));
        let zero = Matrix::<Rational, 2, 2>::from_fn(|_, _| q(0, 1));
        assert_eq!(inverse(&zero), Err(LinearError::Singular { column: 0 }));
    }

    #[test]
    fn it_solves_over_a_quadratic_field() {
        let root = |b| Surd::new(q(0, 1), q(b, 1), &q(2, 1)).expect("positive");
        // √2x + y = 3, x − √2y = 0
        let a = Matrix([[root(1), Surd::integer(1)], [Surd::integer(1), root(-1)]]);
        let x = solve(&a, &Vector([Surd::integer(3), Surd::integer(0)])).expect("regular");
        assert_eq!(x, Vector([root(1), Surd::integer(1)]));
    }

    proptest! {
        #[test]
        fn a_solution_solves_and_is_cramers(a in matrix::<4>(), b in vector::<4>()) {
            let det = determinant(&a);
            match solve(&a, &b) {
                Err(LinearError::Singular { .. }) => prop_assert_eq!(det, 0),
                Ok(x) => {
                    prop_assert_eq!(a.apply(&x), b.clone());
                    for i in 0..4 {
                        let replaced = Matrix::<Rational, 4, 4>::from_fn(|r, c| if c == i { b[r].clone() } else { a.0[r][c].clone() });
                        prop_assert_eq!(x[i].clone() * &det, determinant(&replaced));
                    }
                }
            }
        }

        #[test]
        fn the_inverse_is_on_both_sides(a in matrix::<3>()) {
            if let Ok(b) = inverse(&a) {
                prop_assert_eq!(a.times(&b), Matrix::identity());
                prop_assert_eq!(b.times(&a), Matrix::identity());
            } else {
                prop_assert_eq!(determinant3(&a), 0);
            }
        }
    }
}
