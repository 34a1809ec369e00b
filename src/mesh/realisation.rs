//! Simplicial complexes as points of space: general position, convex hulls, simplices that meet in common faces
//! (IS-4, IS-5, IS-8).
//!
//! One notion serves all three. An *affine circuit* is a minimal affinely dependent set of points; its dependency
//! Σ λᵢpᵢ = 0, Σ λᵢ = 0 is unique up to a factor, and no λᵢ is 0. It says that the hull of the points with λᵢ > 0
//! meets the hull of those with λᵢ < 0 in just one point, Radon's.

use super::simplicial::{Simplex, SimplicialComplex};
use crate::linear::Vector;
use crate::number::{OrderedField, Rational, Ring, Sign};
use thiserror::Error;

/// Coefficients λ, not all 0, with Σ λᵢpᵢ = 0 and Σ λᵢ = 0; the last one that is not 0 is −1, and no dependent
/// point stands before it. `None` iff the points are affinely independent: the vertices of a simplex (IS-4).
#[doc(alias = "IS-4")]
pub fn affine_dependency<const N: usize>(points: &[Vector<Rational, N>]) -> Option<Vec<Rational>> {
    // Rows (p, 1 | e): the last part tells which combination of points the row is. Gauss' elimination, a point a time.
    let mut reduced: Vec<(usize, Vec<Rational>, Vec<Rational>)> = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let mut row: Vec<Rational> = point.0.iter().cloned().chain([Rational::from(1)]).collect();
        let mut combination = vec![Rational::new(); points.len()];
        combination[i] = Rational::from(-1);
        for (pivot, other, other_combination) in &reduced {
            let factor = Rational::from(&row[*pivot] / &other[*pivot]);
            subtract(&mut row, &factor, other);
            subtract(&mut combination, &factor, other_combination);
        }
        match row.iter().position(|x| !x.is_zero()) {
            Some(pivot) => reduced.push((pivot, row, combination)),
            None => return Some(combination),
        }
    }
    None
}

fn subtract(row: &mut [Rational], factor: &Rational, other: &[Rational]) {
    for (x, y) in row.iter_mut().zip(other) {
        *x -= Rational::from(factor * y);
    }
}

/// Whether the points are affinely independent, d + 1 of them the vertices of a simplex of dimension d.
pub fn are_affinely_independent<const N: usize>(points: &[Vector<Rational, N>]) -> bool {
    affine_dependency(points).is_none()
}

/// The dependency of the points, if they are an affine circuit.
fn circuit<const N: usize>(points: &[Vector<Rational, N>]) -> Option<Vec<Rational>> {
    affine_dependency(points).filter(|coefficients| coefficients.iter().all(|x| !x.is_zero()))
}

/// Coefficients λᵢ ≥ 0, Σ λᵢ = 1, with Σ λᵢpᵢ = the point, at most N + 1 of them not 0; `None` iff the point is
/// not in the convex hull of the points, the smallest convex set that they lie in (IS-5).
///
/// # Panics
/// Iff there are more than 31 points: it tries all small subsets.
#[doc(alias = "IS-5")]
pub fn hull_coefficients<const N: usize>(
    points: &[Vector<Rational, N>],
    point: &Vector<Rational, N>,
) -> Option<Vec<Rational>> {
    // Carathéodory's theorem: the point is one of them, or it and at most N + 1 of them are a circuit, the point alone on
    // its side.
    let mut coefficients = vec![Rational::new(); points.len()];
    if let Some(same) = points.iter().position(|p| p == point) {
        coefficients[same] = Rational::from(1);
        return Some(coefficients);
    }
    for chosen in subsets(points.len(), N + 1) {
        let with: Vec<_> = chosen.iter().map(|&i| points[i].clone()).chain([point.clone()]).collect();
        // The last coefficient, the point's, is −1, so the others sum to 1.
        if let Some(found) = circuit(&with).filter(|found| found[..chosen.len()].iter().all(|x| *x > 0)) {
            for (i, x) in chosen.into_iter().zip(found) {
                coefficients[i] = x;
            }
            return Some(coefficients);
        }
    }
    None
}

/// The non-empty subsets of 0 … n−1 with at most `most` elements.
fn subsets(n: usize, most: usize) -> impl Iterator<Item = Vec<usize>> {
    let sets = (1u32..1 << n).filter(move |set| set.count_ones() as usize <= most);
    sets.map(move |set| (0..n).filter(|i| set >> i & 1 == 1).collect())
}

/// A simplicial complex whose simplices are those of the space, disjoint but for common faces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeometricComplex<const N: usize> {
    complex: SimplicialComplex,
    positions: Vec<Vector<Rational, N>>,
}

/// What keeps positions from making a complex one of the space.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GeometricDefect<const N: usize> {
    /// A vertex without a position.
    #[error("vertex {0} has no position")]
    NoPosition(u32),
    /// A simplex with affinely dependent vertices.
    #[error("the vertices {:?} are not in general position", .0.vertices())]
    Degenerate(Simplex),
    /// Two simplices that meet outside their common faces.
    #[error("the simplices {:?} and {:?} meet outside a common face", .simplices[0].vertices(), .simplices[1].vertices())]
    Improper {
        /// The two, neither a face of the other.
        simplices: [Simplex; 2],
        /// A point of both that is in no common face of them.
        point: Vector<Rational, N>,
    },
}

impl<const N: usize> GeometricComplex<N> {
    /// The complex with vertex v at `positions[v]` (IS-8): each cell is the relative interior of a simplex, and
    /// they are disjoint.
    ///
    /// # Errors
    /// All defects, vertices first; improper pairs only where there are no other defects.
    #[doc(alias = "IS-8")]
    pub fn new(
        complex: SimplicialComplex,
        positions: Vec<Vector<Rational, N>>,
    ) -> Result<GeometricComplex<N>, Vec<GeometricDefect<N>>> {
        let unplaced = complex.of_dimension(0).map(|v| v.vertices()[0]).filter(|&v| v as usize >= positions.len());
        let defects: Vec<_> = unplaced.map(GeometricDefect::NoPosition).collect();
        if !defects.is_empty() {
            return Err(defects);
        }
        let realised = GeometricComplex { complex, positions };
        let maximal = realised.complex.maximal();
        let degenerate = maximal.iter().filter(|s| !are_affinely_independent(&realised.corners(s)));
        let mut defects: Vec<_> = degenerate.map(|s| GeometricDefect::Degenerate((*s).clone())).collect();
        if defects.is_empty() {
            // Faces of simplices that meet properly do so as well.
            for (i, a) in maximal.iter().enumerate() {
                for b in &maximal[..i] {
                    if let Some(point) = realised.improper_point(a, b) {
                        let simplices = [(*b).clone(), (*a).clone()];
                        defects.push(GeometricDefect::Improper { simplices, point });
                    }
                }
            }
        }
        if defects.is_empty() { Ok(realised) } else { Err(defects) }
    }

    /// The complex without its positions.
    pub fn complex(&self) -> &SimplicialComplex {
        &self.complex
    }

    /// The positions of a simplex's vertices.
    fn corners(&self, simplex: &Simplex) -> Vec<Vector<Rational, N>> {
        simplex.vertices().iter().map(|&v| self.positions[v as usize].clone()).collect()
    }

    /// A point of both simplices in no common face; `None` iff they meet in a common face or not at all.
    ///
    /// They meet properly iff no circuit has its positive points in the one and its negative points in the other: a
    /// point with barycentric coordinates λ in the one and μ in the other gives the dependency λ − μ, which is not 0 iff
    /// the point is in no common face, and is a positive combination of circuits whose signs agree with its own.
    fn improper_point(&self, a: &Simplex, b: &Simplex) -> Option<Vector<Rational, N>> {
        let mut vertices: Vec<u32> = a.vertices().iter().chain(b.vertices()).copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        subsets(vertices.len(), N + 2).find_map(|chosen| {
            let chosen: Vec<u32> = chosen.into_iter().map(|i| vertices[i]).collect();
            let points: Vec<_> = chosen.iter().map(|&v| self.positions[v as usize].clone()).collect();
            let coefficients = circuit(&points)?;
            let within = |simplex: &Simplex, sign: Sign| {
                let on_side = chosen.iter().zip(&coefficients).filter(|(_, x)| x.sign() == sign);
                on_side.into_iter().all(|(v, _)| simplex.vertices().contains(v))
            };
            let separated = (within(a, Sign::Positive) && within(b, Sign::Negative))
                || (within(a, Sign::Negative) && within(b, Sign::Positive));
            separated.then(|| radon_point(&points, &coefficients))
        })
    }

    /// The simplex in whose relative interior the point lies; `None` iff it is not on the complex.
    pub fn carrier(&self, point: &Vector<Rational, N>) -> Option<Simplex> {
        self.complex.maximal().into_iter().find_map(|simplex| {
            let coefficients = hull_coefficients(&self.corners(simplex), point)?;
            let positive = simplex.vertices().iter().zip(coefficients).filter(|(_, x)| *x > 0).map(|(v, _)| *v);
            Some(Simplex::new(&positive.collect::<Vec<u32>>()).expect("coefficients that sum to 1 are not all 0"))
        })
    }
}

/// Where the hulls of the two sides of a circuit meet.
fn radon_point<const N: usize>(points: &[Vector<Rational, N>], coefficients: &[Rational]) -> Vector<Rational, N> {
    let positive = points.iter().zip(coefficients).filter(|(_, x)| x.sign() == Sign::Positive);
    let (sum, total) =
        positive.fold((Vector::zero(), Rational::integer(0)), |(sum, total), (p, x)| (sum + &p.scaled(x), total + x));
    sum.scaled(&total.recip())
}
