//! Rigid motions and affine maps, exactly, and what they do to level sets.

use super::jet::Jet;
use crate::linear::{LinearError, Matrix, Vector, determinant3, inverse};
use crate::number::{Multivariate, Rational, Ring, Sign, Trivariate};
use thiserror::Error;

/// RᵀR ≠ I, or a quaternion is 0.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NotOrthogonal {
    /// The columns i and j have this product, which is not that of an orthonormal basis.
    #[error("the columns {i} and {j} have the product {product}")]
    Columns {
        /// A column, from 0.
        i: usize,
        /// A column, from 0.
        j: usize,
        /// ⟨aᵢ, aⱼ⟩ ≠ δᵢⱼ.
        product: Rational,
    },
    /// 0 is the quaternion of no rotation.
    #[error("the quaternion is zero")]
    ZeroQuaternion,
}

/// A rational 3×3 matrix R with RᵀR = I: a rotation where det R = 1, else one after −I. CU-213.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-213")]
pub struct Orthogonal(Matrix<Rational, 3, 3>);

impl Orthogonal {
    /// A matrix that is orthogonal.
    ///
    /// # Errors
    /// `Columns` iff RᵀR ≠ I.
    pub fn new(matrix: Matrix<Rational, 3, 3>) -> Result<Orthogonal, NotOrthogonal> {
        let product = |i: usize, j: usize| matrix.column(i).dot(&matrix.column(j));
        let pairs = (0..3).flat_map(|i| (i..3).map(move |j| (i, j)));
        let fault = pairs.map(|(i, j)| (i, j, product(i, j))).find(|(i, j, p)| *p != i32::from(i == j));
        match fault {
            Some((i, j, product)) => Err(NotOrthogonal::Columns { i, j, product }),
            None => Ok(Orthogonal(matrix)),
        }
    }

    /// (I − S)⁻¹(I + S) with Sx = v × x: Cayley's transform, the turn about v by the angle 2 arctan |v|. Every rational rotation but
    /// those by 180° is one. CU-213.
    pub fn cayley(v: &Vector<Rational, 3>) -> Orthogonal {
        let Vector([x, y, z]) = v.clone();
        let zero = Rational::new();
        let s = [[zero.clone(), -z.clone(), y.clone()], [z, zero.clone(), -x.clone()], [-y, x, zero]];
        let entry = |i: usize, j: usize, sign: i32| Rational::from(&s[i][j] * sign) + i32::from(i == j);
        let less = inverse(&Matrix::from_fn(|i, j| entry(i, j, -1))).expect("det(I − S) = 1 + |v|²");
        Orthogonal(less.times(&Matrix::from_fn(|i, j| entry(i, j, 1))))
    }

    /// x ↦ qxq⁻¹ for the quaternion q = a + bi + cj + dk: every rational rotation is one. CU-213.
    ///
    /// # Errors
    /// `ZeroQuaternion` iff q = 0.
    pub fn of_quaternion([a, b, c, d]: &[Rational; 4]) -> Result<Orthogonal, NotOrthogonal> {
        let times = |x: &Rational, y: &Rational| Rational::from(x * y);
        let norm = times(a, a) + times(b, b) + times(c, c) + times(d, d);
        if norm.is_zero() {
            return Err(NotOrthogonal::ZeroQuaternion);
        }
        // (a² − |v|²)I + 2vvᵀ + 2aS, over a² + |v|²
        let v = [b, c, d];
        let first = times(a, a) * 2_u32 - &norm;
        let s = [
            [None, Some((-1, d)), Some((1, c))],
            [Some((1, d)), None, Some((-1, b))],
            [Some((-1, c)), Some((1, b)), None],
        ];
        let entry = |i: usize, j: usize| {
            let diagonal = if i == j { first.clone() } else { Rational::new() };
            let turned = s[i][j].map_or_else(Rational::new, |(sign, x)| times(a, x) * sign);
            (diagonal + times(v[i], v[j]) * 2_u32 + turned * 2_u32) / &norm
        };
        Ok(Orthogonal(Matrix::from_fn(entry)))
    }

    /// −R: improper iff R is proper.
    pub fn opposite(&self) -> Orthogonal {
        Orthogonal(Matrix(self.0.0.clone().map(|row| row.map(|x| -x))))
    }

    /// R.
    pub fn matrix(&self) -> &Matrix<Rational, 3, 3> {
        &self.0
    }

    /// det R: positive for a rotation, negative for an improper map. CU-216.
    #[doc(alias = "CU-216")]
    pub fn orientation(&self) -> Sign {
        Sign::of(determinant3(&self.0).cmp0())
    }

    /// Whether R takes ℤ³ to itself: iff its entries are integers, so that it permutes the axes and turns some round. CU-211.
    #[doc(alias = "CU-211")]
    pub fn keeps_lattice(&self) -> bool {
        self.0.0.iter().flatten().all(Rational::is_integer)
    }
}

/// An affine map x ↦ Ax + b with an inverse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Affine {
    linear: Matrix<Rational, 3, 3>,
    inverse: Matrix<Rational, 3, 3>,
    translation: Vector<Rational, 3>,
}

impl Affine {
    /// From A and b.
    ///
    /// # Errors
    /// `Singular` iff det A = 0.
    pub fn new(linear: Matrix<Rational, 3, 3>, translation: Vector<Rational, 3>) -> Result<Affine, LinearError> {
        let inverse = inverse(&linear)?;
        Ok(Affine { linear, inverse, translation })
    }

    /// A rigid motion x ↦ Rx + b. It keeps E, F, G, and so areas. CU-218.
    #[doc(alias = "CU-218")]
    pub fn rigid(rotation: &Orthogonal, translation: Vector<Rational, 3>) -> Affine {
        Affine { linear: rotation.0.clone(), inverse: rotation.0.transposed(), translation }
    }

    /// x ↦ λx.
    ///
    /// # Errors
    /// `Singular` iff λ = 0.
    pub fn scaling(factor: &Rational) -> Result<Affine, LinearError> {
        let entry = |i: usize, j: usize| if i == j { factor.clone() } else { Rational::new() };
        Affine::new(Matrix::from_fn(entry), Vector::zero())
    }

    /// A.
    pub fn linear(&self) -> &Matrix<Rational, 3, 3> {
        &self.linear
    }

    /// det A ≠ 0.
    pub fn determinant(&self) -> Rational {
        determinant3(&self.linear)
    }

    /// Ap + b.
    pub fn image(&self, p: &Vector<Rational, 3>) -> Vector<Rational, 3> {
        self.linear.apply(p) + &self.translation
    }

    /// Av: the image of a tangent vector, by the chain rule. CU-208.
    #[doc(alias = "CU-208")]
    pub fn tangent(&self, v: &Vector<Rational, 3>) -> Vector<Rational, 3> {
        self.linear.apply(v)
    }

    /// A⁻ᵀn: along the image's normal, the gradient of f∘T⁻¹ for n = ∇f. Not of unit length, but where A is orthogonal. CU-210.
    #[doc(alias = "CU-210")]
    pub fn normal(&self, n: &Vector<Rational, 3>) -> Vector<Rational, 3> {
        self.inverse.transposed().apply(n)
    }

    /// Whether A takes the normal n to a normal of the image: iff AᵀAn is a multiple of n. For every n iff A is a multiple of an
    /// orthogonal map. CU-209.
    #[doc(alias = "CU-209")]
    pub fn carries_normal(&self, n: &Vector<Rational, 3>) -> bool {
        self.linear.transposed().apply(&self.linear.apply(n)).cross(n).norm_squared().is_zero()
    }

    /// det A·A⁻ᵀ(σᵤ × σᵥ) = Aσᵤ × Aσᵥ: the normal that a parametrisation gives, opposite to A⁻ᵀn iff det A < 0. CU-210.
    pub fn parametric_normal(&self, n: &Vector<Rational, 3>) -> Vector<Rational, 3> {
        self.normal(n).scaled(&self.determinant())
    }

    /// f∘T⁻¹, whose level sets are the images of f's. CU-205.
    #[doc(alias = "CU-205")]
    pub fn moved(&self, f: &Trivariate) -> Trivariate {
        let minus_b = self.inverse.apply(&self.translation);
        let coordinate = |i: usize| {
            let variables =
                (0..3).map(|j| Multivariate::variable(j) * &Multivariate::constant(self.inverse.0[i][j].clone()));
            variables.fold(Multivariate::constant(Rational::from(-&minus_b[i])), |sum, term| sum + &term)
        };
        f.evaluate_in(&std::array::from_fn(coordinate), |c| Multivariate::constant(c.clone()))
    }

    /// The jet of f∘T⁻¹ at T(p), from that of f at p: A⁻ᵀ∇f and A⁻ᵀ Hess f A⁻¹. CU-206.
    #[doc(alias = "CU-206")]
    pub fn moved_jet(&self, jet: &Jet<Rational, 3>) -> Jet<Rational, 3> {
        let hessian = self.inverse.transposed().times(&jet.hessian).times(&self.inverse);
        Jet { value: jet.value.clone(), gradient: self.normal(&jet.gradient), hessian }
    }

    /// K of the image at T(p) over K at p: |∇f|⁴/((det A)²|A⁻ᵀ∇f|⁴) > 0. So affine maps keep the sign of K; a rigid motion keeps
    /// K, and a scaling by λ makes it K/λ². `None` iff ∇f = 0. CU-207, CU-214.
    #[doc(alias = "CU-207")]
    #[doc(alias = "CU-214")]
    pub fn gaussian_factor(&self, gradient: &Vector<Rational, 3>) -> Option<Rational> {
        let image = self.normal(gradient).norm_squared() * self.determinant();
        (!image.is_zero()).then(|| (gradient.norm_squared() / image).square())
    }
}

/// The jet of f with its variables permuted: variable i takes the place of\[i]. A level set is reflected or turned with it, and K and H
/// are kept. CU-168.
#[doc(alias = "CU-168")]
pub fn permuted<K: Ring>(jet: &Jet<K, 3>, of: [usize; 3]) -> Jet<K, 3> {
    Jet {
        value: jet.value.clone(),
        gradient: Vector(of.map(|i| jet.gradient[i].clone())),
        hessian: Matrix::from_fn(|i, j| jet.hessian.0[of[i]][of[j]].clone()),
    }
}

/// φ∘f from φ′ and φ″ at f's value: for φ′ ≠ 0 the same level set; N, H, k₁ and k₂ take the sign of φ′, K stays. CU-215.
#[doc(alias = "CU-215")]
pub fn relabelled(jet: &Jet<Rational, 3>, first: &Rational, second: &Rational) -> Jet<Rational, 3> {
    jet.composed(&[jet.value.clone(), first.clone(), second.clone()])
}
