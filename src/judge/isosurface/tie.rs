//! Judging at a tie: a sample, a face saddle or an inner critical point at the isovalue.
//!
//! Two answers are permitted, the surface of c − ε and that of c + ε, one of them throughout the volume.
//! Their vertices may coincide at grid points, where positions no longer tell which crossing a vertex stands
//! for. Away from tied samples the mesh is judged with labels as ever; at them, by what is left: a
//! consistently oriented 2-manifold with the true components.

use super::candidate_mesh::{CandidateMesh, Positions};
use super::fault::{Cell, Fault};
use super::place::Tolerance;
use super::verdict::{Verdict, judge_indexed, mesh_components, totals_text, welded};
use crate::isosurface::cell::Tie;
use crate::isosurface::cube::Corner;
use crate::isosurface::fast;
use crate::isosurface::topology::SurfaceComponent;
use crate::isosurface::volume::{DegenerateCell, Level, Volume};
use crate::judge::report::Difference;
use crate::number::Rational;

/// Judges a mesh as the isosurface at a tie.
///
/// Errors: never for a level that the symbolic perturbation decides, which is every one (IS-86).
pub fn judge_tied(
    volume: &Volume,
    isovalue: &Rational,
    mesh: &CandidateMesh,
    tolerance: Tolerance,
) -> Result<Verdict, DegenerateCell> {
    let below = Level { volume, isovalue: isovalue.clone(), tie: Tie::Below };
    // {f = c + ε} is {−f = −c − ε}, with inside and outside exchanged.
    let negated = volume.negated();
    let above = Level { volume: &negated, isovalue: Rational::from(-isovalue), tie: Tie::Below };
    let turned = turned(mesh);
    let mut expected: Vec<Vec<SurfaceComponent>> = Vec::new();
    let mut closest: Option<Verdict> = None;
    for (level, mesh) in [(&below, mesh), (&above, &turned)] {
        let components = fast::topology(level)?.components;
        for mesh in [mesh, &welded(mesh)] {
            let mut verdict = judge_indexed(level, mesh, tolerance)?;
            let untied = Untied { level, mesh };
            verdict.faults.retain(|fault| untied.counts(fault));
            if verdict.faults.is_empty() && mesh_components(mesh) == components {
                return Ok(verdict);
            }
            if closest.as_ref().is_none_or(|known| verdict.faults.len() < known.faults.len()) {
                closest = Some(verdict);
            }
        }
        expected.push(components);
    }
    let mut verdict = closest.expect("two readings of two levels were judged");
    let difference = Difference {
        invariant: "components (χ, boundary loops, genus)".into(),
        expected: format!("{} just below, or {} just above", totals_text(&expected[0]), totals_text(&expected[1])),
        found: totals_text(&mesh_components(mesh)),
    };
    verdict.faults.push(Fault::NeitherTie { difference });
    Ok(verdict)
}

/// The same mesh with the other orientation.
fn turned(mesh: &CandidateMesh) -> CandidateMesh {
    let triangles = mesh.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    CandidateMesh { positions: mesh.positions.clone(), triangles }
}

/// Which faults count though the level is tied.
struct Untied<'a, 'b> {
    level: &'a Level<'b>,
    mesh: &'a CandidateMesh,
}

impl Untied<'_, '_> {
    fn is_tied(&self, point: Cell) -> bool {
        let volume = self.level.volume;
        volume.sample(volume.index(point)) == self.level.isovalue
    }

    fn touches_tied_sample(&self, cell: Cell) -> bool {
        Corner::ALL.into_iter().any(|c| self.is_tied(self.level.volume.point(self.level.volume.corner_index(cell, c))))
    }

    fn edge_is_tied(&self, low: Cell, axis: u8) -> bool {
        let mut high = low;
        high[usize::from(axis)] += 1;
        self.is_tied(low) || self.is_tied(high)
    }

    fn triangle_is_tied(&self, triangle: usize) -> bool {
        self.mesh.triangles[triangle].iter().any(|&v| self.is_at_grid_point(&self.mesh.positions, v as usize))
    }

    fn is_at_grid_point(&self, positions: &Positions, vertex: usize) -> bool {
        positions.exact(vertex).is_some_and(|position| position.iter().all(Rational::is_integer))
    }

    fn counts(&self, fault: &Fault) -> bool {
        match fault {
            Fault::VertexAtGridPoint { point, .. } => !self.is_tied(*point),
            Fault::StrayVertex { low, axis, .. }
            | Fault::MissingCrossing { low, axis, .. }
            | Fault::RepeatedCrossing { low, axis, .. } => !self.edge_is_tied(*low, *axis),
            Fault::AcrossCells { triangle } | Fault::TriangleInFace { triangle } => !self.triangle_is_tied(*triangle),
            Fault::EdgeInFace { cell, .. }
            | Fault::Hole { cell, .. }
            | Fault::WrongLoops { cell, .. }
            | Fault::Reversed { cell, .. }
            | Fault::WrongComponents { cell, .. } => !self.touches_tied_sample(*cell),
            // A mesh that merges what coincides may have no place for a vertex; its components tell.
            Fault::WrongTotals { .. } => false,
            Fault::NotFinite { .. }
            | Fault::OutsideGrid { .. }
            | Fault::Defect(_)
            | Fault::Misplaced { .. }
            | Fault::Refused { .. }
            | Fault::NeitherTie { .. } => true,
        }
    }
}
