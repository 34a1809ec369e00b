//! Determinants over any ring, without division.

use super::Matrix;
use crate::number::Ring;

/// |a b; c d| = ad − bc. NU-20.
#[doc(alias = "NU-20")]
pub fn determinant2<K: Ring>(Matrix([[a, b], [c, d]]): &Matrix<K, 2, 2>) -> K {
    a.clone() * d - &(b.clone() * c)
}

/// |a b c; d e f; g h i| = a(ei − fh) − b(di − fg) + c(dh − eg). NU-20.
pub fn determinant3<K: Ring>(Matrix([[a, b, c], [d, e, f], [g, h, i]]): &Matrix<K, 3, 3>) -> K {
    let minor = |p: &K, q: &K, r: &K, s: &K| p.clone() * s - &(q.clone() * r);
    a.clone() * &minor(e, f, h, i) - &(b.clone() * &minor(d, f, g, i)) + &(c.clone() * &minor(d, e, g, h))
}

/// The determinant of an N×N matrix, in N⁴ operations; 1 for N = 0. NU-20.
///
/// Bareiss' elimination needs an exact division, which intervals and numbers with an infinitesimal part do not have, and the
/// expansion by cofactors takes N! steps. Bird's algorithm needs + − · only: with
/// μ(X) the strictly upper triangle of X, whose diagonal entry i is −Σ Xⱼⱼ over j > i,
/// det A = (−1)^(N−1) times the first entry of X_N, where X₁ = A and Xₖ₊₁ = μ(Xₖ)·A.
pub fn determinant<K: Ring, const N: usize>(a: &Matrix<K, N, N>) -> K {
    if N == 0 {
        return K::integer(1);
    }
    let x = (1..N).fold(a.clone(), |x, _| bird(&x).times(a));
    let first = x.0[0][0].clone();
    if N % 2 == 1 { first } else { -first }
}

/// μ(X).
fn bird<K: Ring, const N: usize>(x: &Matrix<K, N, N>) -> Matrix<K, N, N> {
    let tail = |i: usize| (i + 1..N).fold(K::integer(0), |sum, j| sum + &x.0[j][j]);
    Matrix::from_fn(|i, j| match i.cmp(&j) {
        std::cmp::Ordering::Less => x.0[i][j].clone(),
        std::cmp::Ordering::Equal => -tail(i),
        std::cmp::Ordering::Greater => K::integer(0),
    })
}
