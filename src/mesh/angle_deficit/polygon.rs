//! Angles of plane polygons with holes, and Gauss and Bonnet's theorem for meshes of them (ME-120).

use super::direction::CornerAngle;
use super::multiple_of_pi::multiple_of_pi;
use super::{Curvature, GaussBonnet};
use crate::linear::Vector;
use crate::mesh::face::{Face, edge, sides};
use crate::mesh::triangles::EdgeKey;
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::{Rational, Sign};
use std::collections::BTreeSet;
use thiserror::Error;

/// The angle of a polygon's corner, in (0, 2π).
#[derive(Clone, Debug)]
pub enum PolygonAngle {
    /// Less than π.
    Convex(CornerAngle),
    /// π.
    Straight,
    /// π and the angle.
    Reflex(CornerAngle),
}

impl PolygonAngle {
    /// It is half_turns·π and the rest, if there is one.
    fn parts(&self) -> (i64, Option<&CornerAngle>) {
        match self {
            PolygonAngle::Convex(rest) => (0, Some(rest)),
            PolygonAngle::Straight => (1, None),
            PolygonAngle::Reflex(rest) => (1, Some(rest)),
        }
    }

    /// 2π less the angle: that on the other side.
    fn outside(self) -> PolygonAngle {
        let supplement = |CornerAngle { x, n }: CornerAngle| CornerAngle { x: -x, n };
        match self {
            PolygonAngle::Convex(rest) => PolygonAngle::Reflex(supplement(rest)),
            PolygonAngle::Straight => PolygonAngle::Straight,
            PolygonAngle::Reflex(rest) => PolygonAngle::Convex(supplement(rest)),
        }
    }
}

/// Why a mesh of polygons has no angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PolygonError {
    /// A loop names a vertex that does not exist.
    #[error("face {face} names a vertex that does not exist")]
    IndexOutOfRange {
        /// The face.
        face: usize,
    },
    /// A loop of fewer than three vertices, or one whose vertices enclose no area.
    #[error("face {face} encloses no area")]
    NoArea {
        /// The face.
        face: usize,
    },
    /// A face that does not lie in one plane.
    #[error("vertex {vertex} of face {face} is not in the plane of its outer loop")]
    NotPlanar {
        /// The face.
        face: usize,
        /// A vertex.
        vertex: u32,
    },
    /// A side of no length, or one that goes back on the one before it.
    #[error("face {face} has no angle at vertex {vertex}")]
    NoAngle {
        /// The face.
        face: usize,
        /// A vertex.
        vertex: u32,
    },
    /// A loop that does not turn once about what it encloses, so that it crosses itself.
    #[error("a loop of face {face} turns about {turns} times, and crosses itself")]
    Turns {
        /// The face.
        face: usize,
        /// Its turning number.
        turns: i64,
    },
}

/// A mesh of plane polygons, perhaps with holes, and rational positions. It may intersect itself, and need be no surface.
#[derive(Clone, Debug)]
pub struct PolygonAngleMesh {
    /// By vertex: the angles at it, one a visit of a loop.
    angles: Vec<Vec<PolygonAngle>>,
    edges: BTreeSet<EdgeKey>,
    /// How many edges each vertex has.
    degrees: Vec<u32>,
    faces: i64,
    holes: i64,
    angle_sum_in_half_turns: i64,
}

impl PolygonAngleMesh {
    /// The mesh. Angles are taken on the side of the face: inside its outer loop, outside its holes, whichever way these
    /// are wound.
    ///
    /// # Errors
    /// The first thing wrong with the first face that something is wrong with. Not every face that crosses itself is
    /// found, only one of which a loop's turning number is not ±1; of the others the theorem is true.
    pub fn new(mesh: &VertexList) -> Result<PolygonAngleMesh, PolygonError> {
        let n = mesh.vertices.len();
        let (mut angles, mut degrees, mut edges) = (vec![Vec::new(); n], vec![0; n], BTreeSet::new());
        let (mut holes, mut angle_sum_in_half_turns) = (0, 0);
        for (i, face) in mesh.faces.iter().enumerate() {
            for (vertex, angle) in face_angles(&mesh.vertices, face, i)? {
                angles[vertex as usize].push(angle);
            }
            let vertices = face.vertices().count() as i64;
            holes += face.holes.len() as i64;
            angle_sum_in_half_turns += vertices - 2 + 2 * face.holes.len() as i64;
            edges.extend(face.sides().map(edge));
        }
        edges.iter().flatten().for_each(|v| degrees[*v as usize] += 1);
        let faces = mesh.faces.len() as i64;
        Ok(PolygonAngleMesh { angles, edges, degrees, faces, holes, angle_sum_in_half_turns })
    }

    /// The curvature π(2 − e + f) − Σβ of a vertex of e edges, which loops of faces visit f times.
    ///
    /// # Panics
    /// Iff there is no such vertex.
    pub fn curvature(&self, vertex: u32) -> Curvature {
        let parts = || self.angles[vertex as usize].iter().map(PolygonAngle::parts);
        let visits = parts().count() as i64;
        let half_turns = 2 - i64::from(self.degrees[vertex as usize]) + visits - parts().map(|(h, _)| h).sum::<i64>();
        Curvature { half_turns, angles: parts().filter_map(|(_, rest)| rest.cloned()).collect() }
    }

    /// χ = V − E + F − H, the vertices of no face counted too.
    pub fn euler_characteristic(&self) -> i64 {
        self.angles.len() as i64 - self.edges.len() as i64 + self.faces - self.holes
    }

    /// Gauss and Bonnet's theorem, ΣK(v) = 2πχ: a face of n vertices, all loops together, and h holes has the angle sum
    /// (n − 2 + 2h)π. ME-120.
    #[doc(alias = "ME-120")]
    pub fn total_curvature(&self) -> GaussBonnet {
        let at_vertex = |v: usize| 2 - i64::from(self.degrees[v]) + self.angles[v].len() as i64;
        let half_turns = (0..self.angles.len()).map(at_vertex).sum::<i64>() - self.angle_sum_in_half_turns;
        GaussBonnet { half_turns, chi: self.euler_characteristic() }
    }
}

/// The vertices of a face with their angles, loop by loop.
fn face_angles(points: &[Point], face: &Face, i: usize) -> Result<Vec<(u32, PolygonAngle)>, PolygonError> {
    if face.vertices().any(|v| v as usize >= points.len()) {
        return Err(PolygonError::IndexOutOfRange { face: i });
    }
    let at = |v: u32| &points[v as usize];
    // Twice the area, as a vector; counterclockwise seen from where it points to.
    let origin = face.outer.first().map_or_else(Vector::zero, |v| at(*v).clone());
    let normal = sides(&face.outer)
        .fold(Vector::zero(), |sum, [a, b]| sum + &(at(a).clone() - &origin).cross(&(at(b).clone() - &origin)));
    if normal == Vector::zero() || face.loops().any(|vertices| vertices.len() < 3) {
        return Err(PolygonError::NoArea { face: i });
    }
    if let Some(vertex) = face.vertices().find(|v| !(at(*v).clone() - &origin).dot(&normal).is_zero()) {
        return Err(PolygonError::NotPlanar { face: i, vertex });
    }
    let mut angles = Vec::new();
    for (number, vertices) in face.loops().enumerate() {
        let of_loop: Vec<PolygonAngle> = (0..vertices.len())
            .map(|k| {
                let [before, v, after] = [vertices.len() - 1, 0, 1].map(|step| vertices[(k + step) % vertices.len()]);
                let [next, last] = [after, before].map(|u| at(u).clone() - at(v));
                left_angle(&next, &last, &normal).ok_or(PolygonError::NoAngle { face: i, vertex: v })
            })
            .collect::<Result<_, _>>()?;
        // The face is on the left of its outer loop and of a hole wound the other way.
        let is_hole = number > 0;
        let of_face: Vec<PolygonAngle> = match (is_hole, turning_number(&of_loop)) {
            (false, 1) | (true, -1) => of_loop,
            (true, 1) => of_loop.into_iter().map(PolygonAngle::outside).collect(),
            (_, turns) => return Err(PolygonError::Turns { face: i, turns }),
        };
        angles.extend(vertices.iter().copied().zip(of_face));
    }
    Ok(angles)
}

/// The angle in (0, 2π) by which one vector turns into another, counterclockwise seen from where the normal points to;
/// `None` where one is 0, or both have one direction.
fn left_angle(from: &Point, to: &Point, normal: &Point) -> Option<PolygonAngle> {
    let (x, cross) = (from.dot(to), from.cross(to));
    let n = cross.norm_squared();
    match (Sign::of(cross.dot(normal).cmp0()), Sign::of(x.cmp0())) {
        (Sign::Zero, Sign::Zero | Sign::Positive) => None,
        (Sign::Zero, Sign::Negative) => Some(PolygonAngle::Straight),
        (Sign::Positive, _) => Some(PolygonAngle::Convex(CornerAngle { x, n })),
        // −x + √N i is the direction half a turn back.
        (Sign::Negative, _) => Some(PolygonAngle::Reflex(CornerAngle { x: -x, n })),
    }
}

/// How many times a closed loop of a plane turns to the left, by its left angles: they sum up to (n − 2·turns)π, each being
/// π less what the loop turns there.
fn turning_number(left_angles: &[PolygonAngle]) -> i64 {
    let (half_turns, rests): (Vec<i64>, Vec<Option<&CornerAngle>>) =
        left_angles.iter().map(PolygonAngle::parts).unzip();
    let rests: Vec<CornerAngle> = rests.into_iter().flatten().cloned().collect();
    // In one plane all radicands are of one class, that of the normal's square, and a loop comes back to its direction.
    let sum = multiple_of_pi(&rests).expect("a closed loop turns by a multiple of 2π") + half_turns.iter().sum::<i64>();
    let turns: Rational = (Rational::from(left_angles.len()) - sum) / 2;
    assert!(turns.is_integer(), "a closed loop turns by a multiple of 2π");
    turns.numer().to_i64().expect("at most half a turn a vertex")
}
