//! Critical points and critical values, decided for quadrics and for polynomials of one variable.

use super::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Multivariate, Polynomial, Rational, Ring, SturmChain};

/// Whether a is a critical value of a polynomial f: ℝ → ℝ, by gcd(f − a, f′) having a real root. There are at most deg f − 1, and
/// one where f is constant: a set of measure zero. CU-139.
#[doc(alias = "CU-139")]
pub fn is_critical_value(f: &Polynomial, a: &Rational) -> bool {
    let common = (f.clone() - &Polynomial::new(vec![a.clone()])).gcd(&f.derivative());
    // f = a: every point is critical.
    SturmChain::new(&common).is_none_or(|chain| chain.count_all() > 0)
}

/// The critical value of a polynomial of degree at most 2, at any solution of Hess f·x = −∇f(0): one value or none. CU-140, CU-146.
///
/// Its other values, taken or not, are regular.
#[doc(alias = "CU-140")]
#[doc(alias = "CU-146")]
pub fn critical_value_of_quadric<const N: usize>(f: &Multivariate<N>) -> Option<Rational> {
    let origin = std::array::from_fn(|_| Rational::new());
    let jet = Jet::of_polynomial(f, &origin);
    let critical = any_solution(&jet.hessian, &-jet.gradient)?;
    Some(f.evaluate(&critical.0))
}

/// Whether ∇f = 0 there. CU-146, CU-148.
#[doc(alias = "CU-148")]
pub fn is_critical_point<const N: usize>(f: &Multivariate<N>, at: &[Rational; N]) -> bool {
    Jet::of_polynomial(f, at).gradient.norm_squared().is_zero()
}

/// |p − c|² as a polynomial: its level sets of the values r² > 0 are the spheres about c. CU-141.
#[doc(alias = "CU-141")]
pub fn squared_distance<const N: usize>(c: &[Rational; N]) -> Multivariate<N> {
    let part = |i: usize| Multivariate::variable(i) - &Multivariate::constant(c[i].clone());
    (0..N).map(part).fold(Multivariate::integer(0), |sum, d| sum + &(d.clone() * &d))
}

/// x²/a² + y²/b² + z²/c² − 1 for a, b, c ≠ 0; `None` iff one is 0. CU-149.
#[doc(alias = "CU-149")]
pub fn ellipsoid(semi_axes: &[Rational; 3]) -> Option<Multivariate<3>> {
    if semi_axes.iter().any(Rational::is_zero) {
        return None;
    }
    let part = |i: usize| {
        let mut exponents = [0; 3];
        exponents[i] = 2;
        (exponents, Rational::from(semi_axes[i].square_ref()).recip())
    };
    Some(Multivariate::new([part(0), part(1), part(2), ([0; 3], Rational::from(-1))]))
}

/// x² + y² − z. CU-150.
#[doc(alias = "CU-150")]
pub fn paraboloid() -> Multivariate<3> {
    let square = |i: usize| Multivariate::variable(i) * &Multivariate::variable(i);
    square(0) + &square(1) - &Multivariate::variable(2)
}

/// Some x with Ax = b; `None` iff there is none. By elimination, free unknowns 0.
fn any_solution<const N: usize>(a: &Matrix<Rational, N, N>, b: &Vector<Rational, N>) -> Option<Vector<Rational, N>> {
    let (mut a, mut b) = (a.0.clone(), b.0.clone());
    let mut pivots = Vec::new();
    for column in 0..N {
        let rank = pivots.len();
        let Some(pivot) = (rank..N).find(|&row| !a[row][column].is_zero()) else { continue };
        a.swap(rank, pivot);
        b.swap(rank, pivot);
        for row in (0..N).filter(|&row| row != rank) {
            let factor = Rational::from(&a[row][column] / &a[rank][column]);
            let (upper, upper_b) = (a[rank].clone(), b[rank].clone());
            for (x, y) in a[row].iter_mut().zip(&upper) {
                *x -= Rational::from(&factor * y);
            }
            b[row] -= factor * upper_b;
        }
        pivots.push(column);
    }
    if b[pivots.len()..].iter().any(|x| !x.is_zero()) {
        return None;
    }
    let mut x = Vector::zero();
    for (row, &column) in pivots.iter().enumerate() {
        x.0[column] = Rational::from(&b[row] / &a[row][column]);
    }
    Some(x)
}
