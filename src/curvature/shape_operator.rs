//! The shape operator of a level surface as a 3×3 matrix, the text's (16), with what is true of it.

use super::implicit_curve::SingularPoint;
use super::implicit_graph::{over_root, unit};
use super::implicit_surface::adjugate;
use super::jet::Jet;
use crate::linear::{Matrix, Vector, determinant2, determinant3};
use crate::number::{Polynomial, QuadraticRoots, Rational, Ring, Surd, quadratic_roots};

/// S = −P·Hess f/|∇f|, P = I − NNᵀ: the matrix of −dN on ℝ³, N = +∇f/|∇f| on the level sets around. CU-179.
///
/// |∇f|S is rational. On the tangent plane S is the shape operator, of eigenvalues k₁ ≥ k₂; its third eigenvalue is 0, with
/// N as an eigenvector from the left, NᵀS = 0, and from the right only where Hess f·N is a multiple of N.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-179")]
pub struct ShapeOperator {
    gradient: Vector<Rational, 3>,
    hessian: Matrix<Rational, 3, 3>,
    /// |∇f|² > 0.
    w: Rational,
    /// |∇f|S = −P·Hess f.
    scaled: Matrix<Rational, 3, 3>,
}

/// P = I − vvᵀ/|v|²: the projection along v ≠ 0 to the plane across it. CU-181.
#[doc(alias = "CU-181")]
pub fn projection(v: &Vector<Rational, 3>) -> Matrix<Rational, 3, 3> {
    let w = v.norm_squared();
    Matrix::from_fn(|i, j| Rational::from(i32::from(i == j)) - Rational::from(&v[i] * &v[j]) / &w)
}

/// The sum of the diagonal.
pub fn trace<K: Ring>(Matrix(a): &Matrix<K, 3, 3>) -> K {
    a[0][0].clone() + &a[1][1] + &a[2][2]
}

/// The sum of the principal 2×2 minors.
pub fn second_invariant<K: Ring>(Matrix(a): &Matrix<K, 3, 3>) -> K {
    let minor = |i: usize, j: usize| {
        let entry = |r: usize, c: usize| a[r][c].clone();
        determinant2(&Matrix([[entry(i, i), entry(i, j)], [entry(j, i), entry(j, j)]]))
    };
    minor(0, 1) + &minor(0, 2) + &minor(1, 2)
}

/// tr(AAᵀ) = Σ aᵢⱼ², the square of Frobenius' norm.
pub fn frobenius_squared<K: Ring>(a: &Matrix<K, 3, 3>) -> K {
    a.0.iter().flatten().fold(K::integer(0), |sum, x| sum + &(x.clone() * x))
}

impl ShapeOperator {
    /// At the point of a jet.
    ///
    /// # Errors
    /// iff ∇f = 0.
    pub fn new(jet: &Jet<Rational, 3>) -> Result<ShapeOperator, SingularPoint> {
        let (gradient, hessian) = (jet.gradient.clone(), jet.hessian.clone());
        let w = gradient.norm_squared();
        if w.is_zero() {
            return Err(SingularPoint);
        }
        let scaled = projection(&gradient).times(&hessian);
        let scaled = Matrix(scaled.0.map(|row| row.map(|x| -x)));
        Ok(ShapeOperator { gradient, hessian, w, scaled })
    }

    /// |∇f|S = −P·Hess f.
    pub fn scaled(&self) -> &Matrix<Rational, 3, 3> {
        &self.scaled
    }

    /// S, in ℚ(√|∇f|²).
    pub fn matrix(&self) -> Matrix<Surd, 3, 3> {
        Matrix::from_fn(|i, j| over_root(&self.scaled.0[i][j], &self.w))
    }

    /// The matrix of dN = −S: P·Hess f/|∇f|.
    pub fn normal_derivative(&self) -> Matrix<Surd, 3, 3> {
        Matrix::from_fn(|i, j| -over_root(&self.scaled.0[i][j], &self.w))
    }

    /// tr S = k₁ + k₂ = 2H. CU-185.
    #[doc(alias = "CU-185")]
    pub fn trace(&self) -> Surd {
        over_root(&trace(&self.scaled), &self.w)
    }

    /// The sum of the principal 2×2 minors of S: k₁k₂ = K.
    pub fn second_invariant(&self) -> Rational {
        second_invariant(&self.scaled) / &self.w
    }

    /// det(λI − |∇f|S) = λ(λ² − 2|∇f|Hλ + |∇f|²K), of the roots |∇f|k₁, |∇f|k₂, 0. CU-190.
    #[doc(alias = "CU-190")]
    pub fn characteristic(&self) -> Polynomial {
        let a = &self.scaled;
        Polynomial::new(vec![-determinant3(a), second_invariant(a), -trace(a), Rational::from(1)])
    }

    /// |∇f|k₁ ≥ |∇f|k₂, in one field ℚ(√d). CU-190.
    pub fn scaled_principal(&self) -> [Surd; 2] {
        let (one, sum, product) = (Rational::from(1), -trace(&self.scaled), second_invariant(&self.scaled));
        match quadratic_roots(&one, &sum, &product) {
            QuadraticRoots::Double(k) => [k.clone(), k].map(Surd::from),
            QuadraticRoots::Two(second, first) => [first, second],
            QuadraticRoots::Every | QuadraticRoots::None | QuadraticRoots::Linear(_) => {
                unreachable!("a symmetric form on the tangent plane has two real eigenvalues")
            }
        }
    }

    /// |∇f|SP = −P·Hess f·P: symmetric, of the eigenvectors v₁, v₂, N, and diag(k₁, k₂, 0) in that basis. CU-192.
    #[doc(alias = "CU-192")]
    pub fn tangential(&self) -> Matrix<Rational, 3, 3> {
        self.scaled.times(&projection(&self.gradient))
    }

    /// |S|²_F = k₁² + k₂² + |SN|². CU-189.
    #[doc(alias = "CU-189")]
    pub fn frobenius_squared(&self) -> Rational {
        frobenius_squared(&self.scaled) / &self.w
    }

    /// k₁² + k₂² = |SP|²_F = tr(S²) = 4H² − 2K. CU-186.
    #[doc(alias = "CU-186")]
    pub fn tangential_frobenius_squared(&self) -> Rational {
        frobenius_squared(&self.tangential()) / &self.w
    }

    /// SN = −P·Hess f·∇f/|∇f|²: minus the change of N along N, and −P∇(log |∇f|). It is 0 iff N is an eigenvector of S, iff S is
    /// symmetric. CU-182, CU-189.
    #[doc(alias = "CU-182")]
    pub fn along_normal(&self) -> Vector<Rational, 3> {
        self.scaled.apply(&self.gradient).map(|x| Rational::from(x / &self.w))
    }

    /// adj(Hess f)·∇f, which S takes to 0; where K ≠ 0 it spans the kernel of S. CU-191.
    #[doc(alias = "CU-191")]
    pub fn kernel(&self) -> Vector<Rational, 3> {
        adjugate(&self.hessian).apply(&self.gradient)
    }

    /// N = +∇f/|∇f|, in ℚ(√|∇f|²), across ker(df). CU-152, CU-174.
    #[doc(alias = "CU-152")]
    #[doc(alias = "CU-174")]
    pub fn unit_normal(&self) -> Vector<Surd, 3> {
        unit(&self.gradient)
    }
}
