//! From ℝⁿ to ℝ³, an axis at a time. For the eye: nothing is decided here.

use super::place::dot;
use super::points::Points;
use super::symmetric;

/// How an axis is given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Projection {
    /// Its coordinate is dropped.
    Orthogonal,
    /// The rest is seen from a point on the axis: divided by 1 − w/d, d = 8/5 of the greatest |w|. What is nearer is larger.
    Perspective,
}

/// The points in their principal axes: the mean at 0, the axis along which they spread most first. Each axis points to where the
/// first point that is off the others' hyperplane through 0 lies.
pub fn principal_axes(points: &Points) -> Points {
    let (n, count) = (points.dimension(), points.len().max(1) as f64);
    let mean: Vec<f64> = (0..n).map(|i| points.iter().map(|p| p[i]).sum::<f64>() / count).collect();
    let centred: Vec<Vec<f64>> =
        points.iter().map(|p| p.iter().zip(&mean).map(|(x, m)| x - m).collect::<Vec<_>>()).collect();
    let covariance = |i: usize, j: usize| centred.iter().map(|p| p[i] * p[j]).sum::<f64>() / count;
    let (_, axes) = symmetric::eigen((0..n).map(|i| (0..n).map(|j| covariance(i, j)).collect()).collect());
    let directed: Vec<Vec<f64>> = axes
        .into_iter()
        .map(|axis| {
            let first = centred.iter().map(|p| dot(p, &axis)).find(|x| x.abs() > 1e-9);
            if first.is_some_and(|x| x < 0.0) { axis.into_iter().map(|x| -x).collect() } else { axis }
        })
        .collect();
    let coordinates = centred.iter().flat_map(|p| directed.iter().map(|axis| dot(p, axis)).collect::<Vec<_>>());
    Points::new(n, coordinates.collect()).expect("coordinates stay finite")
}

/// The points in ℝ³: in their principal axes, the last axis given up until three are left; missing ones are 0.
pub fn to_space(points: &Points, projection: Projection) -> Vec<[f64; 3]> {
    let mut rows: Vec<Vec<f64>> = principal_axes(points).iter().map(<[f64]>::to_vec).collect();
    for _ in 3..points.dimension() {
        let last: Vec<f64> = rows.iter_mut().map(|row| row.pop().expect("more than three")).collect();
        let eye = 1.6 * last.iter().fold(0.0_f64, |max, w| max.max(w.abs()));
        if projection == Projection::Perspective && eye > 0.0 {
            for (row, w) in rows.iter_mut().zip(&last) {
                row.iter_mut().for_each(|x| *x /= 1.0 - w / eye);
            }
        }
    }
    rows.iter().map(|row| std::array::from_fn(|i| row.get(i).copied().unwrap_or(0.0))).collect()
}
