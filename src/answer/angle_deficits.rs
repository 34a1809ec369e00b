//! `mesh.angle_deficits`.

use super::message::{Out, Refusal};
use super::value::{self, EnclosureOut, Exact, InvalidField, Object, Problem, Step};
use crate::linear::Vector;
use crate::mesh::angle_deficit::{AngleError, AngleMesh, Corner, Curvature};
use crate::number::Rational;
use serde::Serialize;

#[derive(Serialize)]
struct AngleDeficitsOut {
    chi: i64,
    total_over_pi: Exact,
    deficits: Vec<EnclosureOut>,
    over_pi: Vec<Option<Exact>>,
    angles: Vec<Vec<AngleOut>>,
}

#[derive(Serialize)]
struct AngleOut {
    triangle: usize,
    cos_sign: i8,
    cos_squared: Exact,
}

/// `mesh.angle_deficits` in `{vertices, faces, digits?}`, the faces being triangles: any of them, whatever complex they make.
///
/// Each list has an item a vertex. `deficits` are the curvatures K(v) = π(2 − e + t) − Σβ of
/// [`AngleMesh::curvature`], so that ΣK = 2πχ for every mesh: 2π − Σβ inside a surface, π − Σβ on its border, 2π for a
/// vertex of no triangle, which counts in `chi` like any other. `over_pi` is K/π where that is rational, else null.
/// `angles` are the corners at the vertex, in the order of the triangles.
pub fn angle_deficits(input: &Object) -> Result<Out, Refusal> {
    let position = |point: &_| value::numbers(point).map(Vector);
    let vertices: Vec<Vector<Rational, 3>> = value::field(input, "vertices", |v| value::items(v, position))?;
    let triangle = |face: &_| value::exactly(face, value::vertex_number);
    let faces = value::field(input, "faces", |faces| value::items(faces, triangle))?;
    let digits = value::optional(input, "digits", value::digits)?.unwrap_or_default();
    let mesh = AngleMesh::new(vertices, faces).map_err(refusal)?;
    let total = mesh.total_curvature();
    assert_eq!(total.half_turns, 2 * total.chi, "Gauss and Bonnet's theorem");
    let vertices = 0..u32::try_from(mesh.vertex_count()).expect("a line has fewer than 2³² bytes");
    let curvatures: Vec<Curvature> = vertices.clone().map(|v| mesh.curvature(v)).collect();
    let angles = |v: u32| mesh.corners(v).iter().zip(&curvatures[v as usize].angles);
    Ok(Out::new(&AngleDeficitsOut {
        chi: total.chi,
        total_over_pi: Exact(Rational::from(total.half_turns)),
        deficits: curvatures.iter().map(|curvature| curvature.decimals(digits).into()).collect(),
        over_pi: curvatures.iter().map(|curvature| curvature.over_pi().map(Exact)).collect(),
        angles: vertices
            .map(|v| {
                let at = angles(v).map(|(&Corner { triangle, .. }, angle)| AngleOut {
                    triangle,
                    cos_sign: angle.cos_sign().value(),
                    cos_squared: Exact(angle.cos_squared()),
                });
                at.collect()
            })
            .collect(),
    }))
}

/// Only a triangle without area is well-posed.
fn refusal(error: AngleError) -> Refusal {
    match error {
        AngleError::IndexOutOfRange { triangle } | AngleError::RepeatedVertex { triangle, .. } => {
            let at = InvalidField::here(Problem::Triangle(error)).within(Step::Item(triangle));
            at.within(Step::Field("faces")).into()
        }
        AngleError::Degenerate { .. } => Refusal::DegenerateTriangle(error),
        AngleError::NotClosed { .. } | AngleError::NotASurface { .. } | AngleError::PinchedBorder { .. } => {
            unreachable!("a mesh may have any edges and any vertices")
        }
    }
}
