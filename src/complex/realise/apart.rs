//! A quick proof that two hulls are apart: a hyperplane between them.

/// So many directions are tried; most hulls that are apart are parted by one of the first.
const ROUNDS: usize = 12;

/// Coordinates beyond this could overflow.
const LARGEST: f64 = 1e100;

/// Whether a hyperplane was found that has one set of points strictly on one side, the other strictly on the other: a proof
/// that the hulls are disjoint. `false` says nothing.
///
/// For a direction h, the least ⟨h, p⟩ over `first` must be greater than the greatest over `second` by more than what rounding can
/// do: (n + 2)·2⁻⁵¹·Σ|hᵢ|·max|coordinate i|, and 2⁻⁹⁰⁰ for underflow. Any h that passes proves it; Gilbert's algorithm finds one:
/// h is the point of the segment from h to the difference p − q with the least ⟨h, p − q⟩ that is next to 0.
#[doc(alias = "CX-88")]
pub fn are_apart(first: &[&[f64]], second: &[&[f64]]) -> bool {
    let n = first[0].len();
    let largest: Vec<f64> =
        (0..n).map(|i| first.iter().chain(second).map(|p| p[i].abs()).fold(0.0, f64::max)).collect();
    if largest.iter().any(|x| *x > LARGEST) {
        return false;
    }
    let along = |h: &[f64], p: &[f64]| h.iter().zip(p).map(|(h, x)| h * x).sum::<f64>();
    let mut h: Vec<f64> = first[0].iter().zip(second[0]).map(|(a, b)| a - b).collect();
    for _ in 0..ROUNDS {
        let least = |points: &[&[f64]], sign: f64| {
            let value = |p: &&[f64]| sign * along(&h, p);
            (0..points.len())
                .map(|i| (value(&points[i]), i))
                .fold((f64::INFINITY, 0), |m, x| if x.0 < m.0 { x } else { m })
        };
        let ((a, i), (b, j)) = (least(first, 1.0), least(second, -1.0));
        let size: f64 = h.iter().zip(&largest).map(|(h, x)| h.abs() * x).sum();
        if a + b > (n as f64 + 2.0) * 2.0_f64.powi(-51) * size + 2.0_f64.powi(-900) {
            return true;
        }
        let difference: Vec<f64> = first[i].iter().zip(second[j]).map(|(a, b)| a - b).collect();
        let step: Vec<f64> = difference.iter().zip(&h).map(|(d, h)| d - h).collect();
        let length = along(&step, &step);
        if length == 0.0 {
            return false;
        }
        let t = (-along(&h, &step) / length).clamp(0.0, 1.0);
        h.iter_mut().zip(&step).for_each(|(h, s)| *h += t * s);
    }
    false
}
