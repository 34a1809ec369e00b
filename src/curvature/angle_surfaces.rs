//! Surfaces whose coordinates are polynomials in sines and cosines.

use super::jet::Jet;
use super::trigonometric::{Angle, Trigonometric};
use crate::number::Ring;

/// The text's sphere σ(θ, φ) = (r sin θ cos φ, r sin θ sin φ, r cos θ), the further variable being r (002, exercise
/// 2.28). CU-78.
///
/// With 0 < θ < π, 0 < φ < 2π it is injective and regular, and leaves out the half circle y = 0, x ≥ 0. CU-79.
#[doc(alias = "CU-78")]
#[doc(alias = "CU-79")]
#[doc(alias = "CU-118")]
#[doc(alias = "CU-119")]
pub fn sphere() -> [Trigonometric<5>; 3] {
    let [theta, phi] = Angle::BOTH;
    let (r, sine) = (Trigonometric::parameter(0), Trigonometric::sin(theta));
    let radius = r.clone() * &sine;
    [radius.clone() * &Trigonometric::cos(phi), radius * &Trigonometric::sin(phi), r * &Trigonometric::cos(theta)]
}

/// The normal (sin θ cos φ, sin θ sin φ, cos θ) of the text's example 2.39, printed with ψ for φ: outward, and that of
/// σ_θ × σ_φ where sin θ > 0. CU-117.
#[doc(alias = "CU-117")]
pub fn sphere_normal() -> [Trigonometric<5>; 3] {
    let [theta, phi] = Angle::BOTH;
    let sine = Trigonometric::sin(theta);
    [sine.clone() * &Trigonometric::cos(phi), sine * &Trigonometric::sin(phi), Trigonometric::cos(theta)]
}

/// The jets of the coordinates in both angles, as functions.
pub fn jets<const N: usize>(surface: &[Trigonometric<N>; 3]) -> [Jet<Trigonometric<N>, 2>; 3] {
    surface.each_ref().map(Trigonometric::jet)
}

/// A Möbius band around the circle of radius R: with η half the angle around the axis, the first angle here, and
/// further variables R and t, ((R + t cos η) cos 2η, (R + t cos η) sin 2η, t sin η). The point of (η + π, −t) is that
/// of (η, t). CU-229.
#[doc(alias = "CU-229")]
pub fn moebius_band() -> [Trigonometric<6>; 3] {
    let (c, s) = (Trigonometric::<6>::cos(Angle::First), Trigonometric::sin(Angle::First));
    let (big_r, t) = (Trigonometric::parameter(0), Trigonometric::parameter(1));
    let radius = big_r + &(t.clone() * &c);
    let cosine = c.clone() * &c - &(s.clone() * &s);
    let sine = c * &s * &Trigonometric::integer(2);
    [radius.clone() * &cosine, radius * &sine, t * &s]
}

/// y(x² + y² + z²) − R²y − 2Rxz − 2z(x² + y²), which is 0 on the Möbius band. Its gradient is 0 somewhere on every
/// closed path that reverses the sides, for else ∇f/|∇f| would orient the band. CU-227.
#[doc(alias = "CU-227")]
pub fn moebius_equation<K: Ring>([x, y, z]: &[K; 3], big_r: &K) -> K {
    let times = |a: &K, b: &K| a.clone() * b;
    let (squares, across) = (times(x, x) + &times(y, y), times(x, z));
    let two = K::integer(2);
    times(y, &(squares.clone() + &times(z, z)))
        - &times(&times(big_r, big_r), y)
        - &times(&two, &(times(big_r, &across) + &times(z, &squares)))
}
