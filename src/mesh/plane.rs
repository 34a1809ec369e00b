//! The plane of a polygon: from three of its vertices, and from all of them by projected areas (003, 5.6).

use super::vertex_list::Point;
use crate::linear::Vector;
use crate::number::{Rational, Sign};
use thiserror::Error;

/// What points span: the smallest point, line, plane or space with all of them in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Span {
    /// There is no point.
    Empty,
    /// All points are one.
    Point,
    /// All are on one line, and not all one.
    Line,
    /// All are in one plane, and not on one line; a normal to it, of either sense.
    Plane(Point),
    /// They are in no common plane.
    Space,
}

/// What some points span.
///
/// Three points always span less than space: a triangle is plane, but the plane is only one where it is no line (ME-62).
#[doc(alias = "ME-62")]
pub fn span<'a>(points: impl IntoIterator<Item = &'a Point>) -> Span {
    let mut points = points.into_iter();
    let Some(first) = points.next() else { return Span::Empty };
    let mut along: Option<Point> = None;
    let mut normal: Option<Point> = None;
    for point in points {
        let to = point.clone() - first;
        match (&along, &normal) {
            (None, _) => along = (to != Vector::zero()).then_some(to),
            (Some(u), None) => normal = Some(u.cross(&to)).filter(|n| *n != Vector::zero()),
            (Some(_), Some(n)) if n.dot(&to).is_zero() => {}
            (Some(_), Some(_)) => return Span::Space,
        }
    }
    match (along, normal) {
        (None, _) => Span::Point,
        (Some(_), None) => Span::Line,
        (Some(_), Some(n)) => Span::Plane(n),
    }
}

/// V₁V₂ × V₁V₃ = V₂V₃ × V₂V₁ = V₃V₁ × V₃V₂ (5.12), a normal to the plane of three points: twice the triangle's area, and
/// counterclockwise seen from its tip. ME-63.
///
/// It is 0 iff the three are collinear (ME-64). Of three consecutive vertices of a simple plane polygon it has the polygon's
/// own sense where the corner is convex, the other one where it is reflex (ME-66).
#[doc(alias = "ME-63")]
#[doc(alias = "ME-64")]
#[doc(alias = "ME-66")]
pub fn corner_normal([v1, v2, v3]: [&Point; 3]) -> Point {
    (v2.clone() - v1).cross(&(v3.clone() - v1))
}

/// i ⊕ 1 for i in 1 … n: i + 1, but 1 where i = n (5.14). ME-68.
///
/// # Panics
/// Unless 1 ≤ i ≤ n.
#[doc(alias = "ME-68")]
pub fn successor(i: usize, n: usize) -> usize {
    assert!((1..=n).contains(&i), "{i} is not in 1 … {n}");
    if i == n { 1 } else { i + 1 }
}

/// (A, B, C), the signed areas of the polygon's projections on the planes (y,z), (z,x), (x,y), positive where the projection
/// runs counterclockwise: (0, 0, 1) for the unit square of z = 0, counterclockwise. ME-67.
///
/// A = ½ Σ (yᵢ − yᵢ⊕₁)(zᵢ + zᵢ⊕₁), B = ½ Σ (zᵢ − zᵢ⊕₁)(xᵢ + xᵢ⊕₁), C = ½ Σ (xᵢ − xᵢ⊕₁)(yᵢ + yᵢ⊕₁): the trapezoids under the sides.
/// The vector is a normal where the polygon is plane and its sides enclose an area; it is 0 for a bow-tie of two equal parts.
#[doc(alias = "ME-67")]
#[doc(alias = "ME-69")]
pub fn projected_areas<'a>(polygon: impl IntoIterator<Item = &'a Point>) -> Point {
    let vertices: Vec<&Point> = polygon.into_iter().collect();
    let n = vertices.len();
    let mut doubled = Vector::<Rational, 3>::zero();
    for i in 1..=n {
        let (Vector([x, y, z]), Vector([x1, y1, z1])) = (vertices[i - 1], vertices[successor(i, n) - 1]);
        let trapezoid =
            |u: &Rational, u1: &Rational, v: &Rational, v1: &Rational| Rational::from(u - u1) * Rational::from(v + v1);
        doubled = doubled + &Vector([trapezoid(y, y1, z, z1), trapezoid(z, z1, x, x1), trapezoid(x, x1, y, y1)]);
    }
    doubled.scaled(&Rational::from((1, 2)))
}

/// The plane A x + B y + C z = D, (A, B, C) ≠ 0 (5.10). Its upper side is the one that (A, B, C) points to.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "ME-60")]
pub struct Plane {
    normal: Point,
    offset: Rational,
}

/// Why a polygon or a normal gives no plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NoPlane {
    /// (A, B, C) = 0.
    #[error("the normal vanishes: no projection of the polygon has an area")]
    ZeroNormal,
    /// There is no vertex that the plane could be near to.
    #[error("there is no vertex")]
    NoVertex,
}

impl Plane {
    /// The plane of a normal and the offset D.
    ///
    /// # Errors
    /// Iff the normal is 0.
    pub fn new(normal: Point, offset: Rational) -> Result<Plane, NoPlane> {
        if normal == Vector::zero() { Err(NoPlane::ZeroNormal) } else { Ok(Plane { normal, offset }) }
    }

    /// The plane through three points, counterclockwise seen from above; D is the same from each of them (ME-65).
    ///
    /// # Errors
    /// Iff they are collinear.
    #[doc(alias = "ME-65")]
    pub fn through(points: [&Point; 3]) -> Result<Plane, NoPlane> {
        let normal = corner_normal(points);
        let offset = normal.dot(points[0]);
        Plane::new(normal, offset)
    }

    /// The plane of a polygon: its projected areas, and the offset of least squares. ME-72.
    ///
    /// # Errors
    /// Iff the projected areas are all 0, as they are for fewer than 3 vertices.
    pub fn of_polygon<'a>(polygon: impl IntoIterator<Item = &'a Point> + Clone) -> Result<Plane, NoPlane> {
        let normal = projected_areas(polygon.clone());
        let offset = least_squares_offset(&normal, polygon).ok_or(NoPlane::NoVertex)?;
        Plane::new(normal, offset)
    }

    /// (A, B, C).
    pub fn normal(&self) -> &Point {
        &self.normal
    }

    /// D.
    pub fn offset(&self) -> &Rational {
        &self.offset
    }

    /// k² = 1/(A² + B² + C²), the square of the factor that makes the normal a unit vector (5.11). D takes the same factor.
    /// ME-61.
    #[doc(alias = "ME-61")]
    pub fn unit_factor_squared(&self) -> Rational {
        self.normal.norm_squared().recip()
    }

    /// A x + B y + C z − D: |(A, B, C)| times the signed distance of a point, positive above. ME-71.
    #[doc(alias = "ME-71")]
    pub fn height(&self, point: &Point) -> Rational {
        self.normal.dot(point) - &self.offset
    }

    /// Where a point is: above, in the plane, below.
    pub fn side(&self, point: &Point) -> Sign {
        Sign::of(self.height(point).cmp0())
    }

    /// d² = (A x + B y + C z − D)² / (A² + B² + C²), the squared distance of a point. ME-70.
    #[doc(alias = "ME-70")]
    pub fn distance_squared(&self, point: &Point) -> Rational {
        self.height(point).square() * self.unit_factor_squared()
    }
}

/// The D with the least Σ (A x + B y + C z − D)² over some points: (A, B, C) · their mean. `None` iff there is none.
/// ME-72.
#[doc(alias = "ME-72")]
pub fn least_squares_offset<'a>(normal: &Point, points: impl IntoIterator<Item = &'a Point>) -> Option<Rational> {
    let heights: Vec<Rational> = points.into_iter().map(|point| normal.dot(point)).collect();
    (!heights.is_empty()).then(|| heights.iter().sum::<Rational>() / Rational::from(heights.len()))
}
