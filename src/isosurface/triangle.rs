//! Marching triangles: contours of a barycentric interpolant, which has no ambiguous case.

use super::cell::Tie;
use super::polyline::{Drawing, Polyline, Raster};
use crate::number::Rational;
use thiserror::Error;

/// What a level set cuts out of a triangle, no corner being at the level: never ambiguous (IS-51, IS-52).
#[doc(alias = "IS-52")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleCase {
    /// No edge is crossed.
    Uncut,
    /// Two edges are crossed, the two at one corner. The segment goes from the one to the other, each given by
    /// its corners, with f > c on the left where the corners run counter-clockwise.
    Segment([[usize; 2]; 2]),
}

/// The case of a triangle by which of its corners have f > c (IS-51).
#[doc(alias = "IS-51")]
pub fn case(positive: [bool; 3]) -> TriangleCase {
    // The corner whose sign is its own, if there is one.
    let Some(lone) = (0..3).find(|&i| positive[i] != positive[(i + 1) % 3] && positive[i] != positive[(i + 2) % 3])
    else {
        return TriangleCase::Uncut;
    };
    let (after, before) = ([lone, (lone + 1) % 3], [lone, (lone + 2) % 3]);
    // Around the triangle, f falls below c on the edge after a lone positive corner, before a lone negative one.
    TriangleCase::Segment(if positive[lone] { [after, before] } else { [before, after] })
}

/// A sample of a raster that equals the isovalue.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("the sample at [{}, {}] equals the isovalue", .point[0], .point[1])]
pub struct DegeneratePoint {
    /// Where it is.
    pub point: [usize; 2],
}

/// The contour {f = c} by marching triangles: each square is cut along its diagonal from (0,0) to (1,1), and f is
/// linear on both halves (IS-53). The diagonal, not the data, decides the ambiguous squares.
///
/// Errors: iff a sample equals c and ties are not broken.
#[doc(alias = "IS-53")]
pub fn triangles(raster: &Raster, isovalue: &Rational, tie: Tie) -> Result<Polyline, DegeneratePoint> {
    if let (Tie::Degenerate, Some(point)) = (tie, raster.sample_at(isovalue)) {
        return Err(DegeneratePoint { point });
    }
    let mut drawing = Drawing::new(raster, isovalue);
    for [i, j] in raster.squares() {
        let [p00, p10, p01, p11] = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
        for triangle in [[p00, p10, p11], [p00, p11, p01]] {
            match case(triangle.map(|p| drawing.is_outside(p))) {
                TriangleCase::Uncut => {}
                TriangleCase::Segment(edges) => drawing.segment(edges.map(|edge| edge.map(|i| triangle[i]))),
            }
        }
    }
    Ok(drawing.polyline)
}
