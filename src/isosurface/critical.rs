//! Where the gradient of a multilinear function vanishes.

use super::multilinear::{trilinear, trilinear_gradient};
use crate::number::{Rational, Sign, Surd};

/// The critical points of a bilinear function in the whole plane. There is never a line of them: where
/// f_uv = 0 the gradient is constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BilinearCritical {
    /// f_uv = 0 and f is not constant.
    None,
    /// f_uv ≠ 0: one saddle.
    Saddle(Saddle),
    /// f is constant.
    Everywhere,
}

/// The saddle of a bilinear function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saddle {
    /// u_s = (g₀₀ − g₀₁) / f_uv.
    pub u: Rational,
    /// v_s = (g₀₀ − g₁₀) / f_uv.
    pub v: Rational,
    /// f(u_s, v_s) = (g₀₀ g₁₁ − g₁₀ g₀₁) / f_uv.
    pub value: Rational,
}

/// Where the gradient of the bilinear function vanishes, with f_uv = g₀₀ + g₁₁ − g₁₀ − g₀₁ (IS-?ex5.15).
///
/// Its sign at the saddle is that of the determinant g₀₀ g₁₁ − g₁₀ g₀₁ only where f_uv > 0. If the signs of the
/// corners alternate around the square, f_uv has the sign of g₀₀, and the saddle lies inside the square.
#[doc(alias = "IS-?ex5.15")]
pub fn bilinear_critical([g00, g10, g01, g11]: &[Rational; 4]) -> BilinearCritical {
    let f_uv = Rational::from(g00 + g11) - g10 - g01;
    if f_uv.is_zero() {
        return if g00 == g10 && g00 == g01 { BilinearCritical::Everywhere } else { BilinearCritical::None };
    }
    let determinant = Rational::from(g00 * g11) - Rational::from(g10 * g01);
    BilinearCritical::Saddle(Saddle {
        u: Rational::from(g00 - g01) / &f_uv,
        v: Rational::from(g00 - g10) / &f_uv,
        value: determinant / &f_uv,
    })
}

/// A critical point and the value there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CriticalPoint<K> {
    /// Where it lies, in coordinates of the cell.
    pub position: [K; 3],
    /// f there.
    pub value: K,
}

/// The critical points of a trilinear function in the whole space. On a curve of them f is constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TrilinearCritical {
    /// The gradient vanishes nowhere.
    None,
    /// In one point; then f_xyz = 0.
    Point(CriticalPoint<Rational>),
    /// In two points, in ℚ(√d); then f_xyz ≠ 0, and their mean is the centre, where all mixed second
    /// derivatives vanish.
    Pair(Box<[CriticalPoint<Surd>; 2]>),
    /// On a straight line; then f_xyz = 0.
    Line {
        /// A point of the line.
        point: CriticalPoint<Rational>,
        /// Its direction.
        direction: [Rational; 3],
    },
    /// On the three lines through one point along the axes; then f = f_xyz·(x−x₀)(y−y₀)(z−z₀) + const.
    ThreeLines(CriticalPoint<Rational>),
    /// On the hyperbola (xⱼ − centreⱼ)(xₗ − centreₗ) = product in the plane xᵢ = centreᵢ, where i is `axis` and j, l
    /// are the other axes.
    Hyperbola {
        /// Its centre, and f on the hyperbola (and in the centre, which is not critical).
        centre: CriticalPoint<Rational>,
        /// The axis normal to its plane.
        axis: usize,
        /// Not zero.
        product: Rational,
    },
    /// f is constant.
    Everywhere,
}

/// All critical points of the trilinear function with these corner values (IS-?trilinear critical points).
///
/// With k = f_xyz ≠ 0 and the centre x₀ = −f_yz(0)/k, y₀ = −f_xz(0)/k, z₀ = −f_xy(0)/k, in X = x − x₀ and so on,
/// f = k·XYZ + βX + γY + δZ + α. The gradient vanishes iff YZ = p, XZ = q, XY = r for p = −β/k, q = −γ/k,
/// r = −δ/k; then (XYZ)² = pqr. So for pqr > 0 there are two, (X,Y,Z) = ±√(pqr)·(1/p, 1/q, 1/r), of value
/// α ∓ 2k√(pqr); for pqr < 0 none.
#[doc(alias = "IS-?trilinear critical points")]
pub fn trilinear_critical(g: &[Rational; 8]) -> TrilinearCritical {
    let [_, b, c, d, e, m, h, k] = monomials(g);
    if k.is_zero() {
        return quadric_critical(g, [b, c, d], [h, m, e]);
    }
    let position = [h, m, e].map(|mixed| -mixed / &k);
    let centre = CriticalPoint { value: trilinear(g, &position), position };
    let [p, q, r] = trilinear_gradient(g, &centre.position).map(|slope| -slope / &k);
    let square = Rational::from(&p * &q) * &r;
    let vanishing: Vec<usize> = [&p, &q, &r].iter().enumerate().filter(|(_, x)| x.is_zero()).map(|(i, _)| i).collect();
    match (vanishing.as_slice(), Sign::of(square.cmp0())) {
        ([0, 1, 2], _) => TrilinearCritical::ThreeLines(centre),
        (&[i, j], _) => {
            let axis = 3 - i - j;
            let product = [p, q, r][axis].clone();
            TrilinearCritical::Hyperbola { centre, axis, product }
        }
        (_, Sign::Negative | Sign::Zero) => TrilinearCritical::None,
        (_, Sign::Positive) => TrilinearCritical::Pair(Box::new([1, -1].map(|side| {
            let surd = |a: &Rational, b: Rational| Surd::new(a.clone(), b, &square).expect("pqr > 0");
            let [x0, y0, z0] = &centre.position;
            let share = |x: &Rational| Rational::from(side) / x;
            CriticalPoint {
                position: [surd(x0, share(&p)), surd(y0, share(&q)), surd(z0, share(&r))],
                value: surd(&centre.value, k.clone() * (-2 * side)),
            }
        }))),
    }
}

/// The coefficients of 1, x, y, z, xy, xz, yz, xyz.
fn monomials(g: &[Rational; 8]) -> [Rational; 8] {
    let sum = |plus: &[usize], minus: &[usize]| {
        let add = |of: &[usize]| of.iter().fold(Rational::new(), |sum, &c| sum + &g[c]);
        add(plus) - add(minus)
    };
    [
        sum(&[0], &[]),
        sum(&[1], &[0]),
        sum(&[2], &[0]),
        sum(&[4], &[0]),
        sum(&[3, 0], &[1, 2]),
        sum(&[5, 0], &[1, 4]),
        sum(&[6, 0], &[2, 4]),
        sum(&[7, 1, 2, 4], &[6, 5, 3, 0]),
    ]
}

/// The critical points where f_xyz = 0: the gradient is linear. `linear[i]` is the coefficient of xᵢ, `mixed[i]`
/// that of the product of the two other coordinates, so that
/// ∂ᵢf = linear[i] + mixed[l]·xⱼ + mixed[j]·xₗ for the axes i, j, l.
fn quadric_critical(g: &[Rational; 8], linear: [Rational; 3], mixed: [Rational; 3]) -> TrilinearCritical {
    let at = |position: [Rational; 3]| CriticalPoint { value: trilinear(g, &position), position };
    let vanishing: Vec<usize> = (0..3).filter(|&i| mixed[i].is_zero()).collect();
    match vanishing.as_slice() {
        [] => {
            // Cramer's rule; the determinant is 2·mixed[0]·mixed[1]·mixed[2].
            let own: [Rational; 3] = [0, 1, 2].map(|i| Rational::from(&linear[i] * &mixed[i]));
            let sum = Rational::from(&own[0] + &own[1]) + &own[2];
            TrilinearCritical::Point(at([0, 1, 2].map(|i| {
                let (j, l) = ((i + 1) % 3, (i + 2) % 3);
                (Rational::from(&own[i] * 2) - &sum) / (Rational::from(&mixed[j] * &mixed[l]) * 2)
            })))
        }
        &[i] => {
            // ∂ⱼf = linear[j] + mixed[l]·xᵢ and ∂ₗf = linear[l] + mixed[j]·xᵢ must vanish for one xᵢ; then ∂ᵢf = 0
            // is a line in the plane of that xᵢ.
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            if Rational::from(&linear[j] * &mixed[j]) != Rational::from(&linear[l] * &mixed[l]) {
                return TrilinearCritical::None;
            }
            let (mut position, mut direction) = (<[Rational; 3]>::default(), <[Rational; 3]>::default());
            position[i] = -Rational::from(&linear[j] / &mixed[l]);
            position[j] = -Rational::from(&linear[i] / &mixed[l]);
            direction[j] = mixed[j].clone();
            direction[l] = -mixed[l].clone();
            TrilinearCritical::Line { point: at(position), direction }
        }
        &[i, j] => {
            let l = 3 - i - j;
            if !linear[l].is_zero() {
                return TrilinearCritical::None;
            }
            let (mut position, mut direction) = (<[Rational; 3]>::default(), <[Rational; 3]>::default());
            position[i] = -Rational::from(&linear[j] / &mixed[l]);
            position[j] = -Rational::from(&linear[i] / &mixed[l]);
            direction[l] = Rational::from(1);
            TrilinearCritical::Line { point: at(position), direction }
        }
        _ if linear.iter().all(Rational::is_zero) => TrilinearCritical::Everywhere,
        _ => TrilinearCritical::None,
    }
}

impl TrilinearCritical {
    /// Whether a point is one of them.
    pub fn contains(&self, at: &[Rational; 3]) -> bool {
        let offset = |from: &[Rational; 3]| [0, 1, 2].map(|i| Rational::from(&at[i] - &from[i]));
        match self {
            TrilinearCritical::None => false,
            TrilinearCritical::Everywhere => true,
            TrilinearCritical::Point(point) => point.position == *at,
            TrilinearCritical::Pair(points) => {
                points.iter().any(|point| point.position.iter().zip(at).all(|(x, y)| x.rational() == Some(y)))
            }
            TrilinearCritical::Line { point, direction } => {
                let offset = offset(&point.position);
                (0..3).all(|i| {
                    let (j, l) = ((i + 1) % 3, (i + 2) % 3);
                    Rational::from(&offset[j] * &direction[l]) == Rational::from(&offset[l] * &direction[j])
                })
            }
            TrilinearCritical::ThreeLines(centre) => {
                offset(&centre.position).iter().filter(|x| x.is_zero()).count() >= 2
            }
            TrilinearCritical::Hyperbola { centre, axis, product } => {
                let offset = offset(&centre.position);
                let (j, l) = ((axis + 1) % 3, (axis + 2) % 3);
                offset[*axis].is_zero() && Rational::from(&offset[j] * &offset[l]) == *product
            }
        }
    }
}
