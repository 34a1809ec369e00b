//! What can be wrong with a mesh that is meant to be an isosurface.

use crate::isosurface::cases::Case;
use crate::isosurface::volume::GridEdge;
use crate::judge::report::Difference;
use crate::mesh::triangles::Defect;
use thiserror::Error;

/// A cell of the grid, by its lowest grid point.
pub type Cell = [usize; 3];

/// One way in which a mesh is not the isosurface, with its witness.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// A position is NaN or infinite.
    #[error("vertex {vertex} is not at a finite position")]
    NotFinite {
        /// Which vertex.
        vertex: usize,
    },
    /// A vertex outside the grid's box.
    #[error("vertex {vertex} lies outside the grid")]
    OutsideGrid {
        /// Which vertex.
        vertex: usize,
    },
    /// The mesh is no consistently oriented 2-manifold.
    #[error("{}: {}", .0.name(), describe(.0))]
    Defect(Defect),
    /// A grid edge whose ends lie on one side carries a vertex.
    #[error(
        "vertex {vertex} lies on a grid edge that the surface does not cross, at grid point {low:?} along axis {axis}"
    )]
    StrayVertex {
        /// Which vertex.
        vertex: usize,
        /// The lower end of the edge.
        low: Cell,
        /// Its axis.
        axis: u8,
    },
    /// A vertex at a grid point that no crossing of the surface is near.
    #[error("vertex {vertex} lies at grid point {point:?}, to which no crossing belongs")]
    VertexAtGridPoint {
        /// Which vertex.
        vertex: usize,
        /// The grid point.
        point: Cell,
    },
    /// A crossed grid edge without a vertex.
    #[error("the surface crosses the grid edge at {low:?} along axis {axis}; the mesh has no vertex there")]
    MissingCrossing {
        /// The lower end of the edge.
        low: Cell,
        /// Its axis.
        axis: u8,
        /// The edge.
        edge: GridEdge,
    },
    /// A crossed grid edge with several vertices.
    #[error("the surface crosses the grid edge at {low:?} along axis {axis} once; the mesh has {count} vertices there")]
    RepeatedCrossing {
        /// The lower end of the edge.
        low: Cell,
        /// Its axis.
        axis: u8,
        /// How many vertices there are.
        count: u32,
    },
    /// A vertex is farther from the true crossing than allowed.
    #[error("vertex {vertex} is {ulp} units in the last place (binary32) from the crossing")]
    Misplaced {
        /// Which vertex.
        vertex: usize,
        /// The distance, rounded up.
        ulp: u64,
    },
    /// A triangle that no one cell contains.
    #[error("triangle {triangle} lies in no one cell")]
    AcrossCells {
        /// Which triangle.
        triangle: usize,
    },
    /// A triangle that lies in a face between two cells.
    #[error("triangle {triangle} lies in the face between two cells")]
    TriangleInFace {
        /// Which triangle.
        triangle: usize,
    },
    /// An inner edge of a cell's triangles that lies in a face of the cell, where a neighbour may have it too.
    #[error("cell {cell:?}: an inner edge lies in a face of the cell, which the surface meets in its arcs only")]
    EdgeInFace {
        /// The cell.
        cell: Cell,
        /// Its case.
        case: Case,
    },
    /// A boundary edge inside a cell.
    #[error("cell {cell:?}: the mesh ends inside the cell, at the edge between vertices {} and {}", .edge[0], .edge[1])]
    Hole {
        /// The cell.
        cell: Cell,
        /// Its case.
        case: Case,
        /// The edge.
        edge: [u32; 2],
    },
    /// The curves on the cell's boundary are not the true ones: a face was decided wrongly.
    #[error("cell {cell:?} (case {case}): wrong loops on the boundary of the cell")]
    WrongLoops {
        /// The cell.
        cell: Cell,
        /// Its case.
        case: Case,
        /// The truth and the mesh's.
        difference: Difference,
    },
    /// The curves are right but run the wrong way: normals toward f < c.
    #[error("cell {cell:?} (case {case}): the orientation is reversed, normals point toward f < c")]
    Reversed {
        /// The cell.
        cell: Cell,
        /// Its case.
        case: Case,
    },
    /// The loops are right, but not what they bound: the inside was decided wrongly.
    #[error("cell {cell:?} (case {case}): wrong components inside the cell")]
    WrongComponents {
        /// The cell.
        cell: Cell,
        /// Its case.
        case: Case,
        /// The truth and the mesh's.
        difference: Difference,
    },
    /// The components of the whole surface are not the true ones.
    #[error("wrong topology of the whole surface")]
    WrongTotals {
        /// The truth and the mesh's.
        difference: Difference,
    },
    /// A question that has an answer was answered with an error.
    #[error("it answers with an error ({kind}): {message}")]
    Refused {
        /// The error's kind.
        kind: String,
        /// Its message.
        message: String,
    },
    /// At a tie: neither the surface just below the isovalue nor the one just above.
    #[error("neither the surface of c − ε nor that of c + ε")]
    NeitherTie {
        /// The truths and the mesh's.
        difference: Difference,
    },
}

fn describe(defect: &Defect) -> String {
    match defect {
        Defect::IndexOutOfRange { triangle } => format!("triangle {triangle} names a vertex that does not exist"),
        Defect::RepeatedVertex { triangle } => format!("triangle {triangle} names a vertex twice"),
        Defect::DuplicateTriangle { triangles: [a, b] } => format!("triangles {a} and {b} have the same vertices"),
        Defect::EdgeUsedMoreThanTwice { edge: [a, b], uses } => {
            format!("the edge between vertices {a} and {b} has {uses} triangles")
        }
        Defect::InconsistentWinding { edge: [a, b] } => {
            format!("both triangles run the same way along the edge between vertices {a} and {b}")
        }
        Defect::NonmanifoldVertex { vertex } => format!("the triangles at vertex {vertex} make more than one fan"),
    }
}

impl Fault {
    /// The fault's short name, by which failures are told apart.
    pub const fn name(&self) -> &'static str {
        match self {
            Fault::NotFinite { .. } => "not-finite",
            Fault::OutsideGrid { .. } => "outside-grid",
            Fault::Defect(Defect::IndexOutOfRange { .. }) => "index-out-of-range",
            Fault::Defect(Defect::RepeatedVertex { .. }) => "repeated-vertex",
            Fault::Defect(Defect::DuplicateTriangle { .. }) => "duplicate-triangle",
            Fault::Defect(Defect::EdgeUsedMoreThanTwice { .. }) => "edge-with-more-than-two-triangles",
            Fault::Defect(Defect::InconsistentWinding { .. }) => "inconsistent-winding",
            Fault::Defect(Defect::NonmanifoldVertex { .. }) => "non-manifold-vertex",
            Fault::StrayVertex { .. } => "stray-vertex",
            Fault::VertexAtGridPoint { .. } => "vertex-at-grid-point",
            Fault::MissingCrossing { .. } => "missing-crossing",
            Fault::RepeatedCrossing { .. } => "repeated-crossing",
            Fault::Misplaced { .. } => "misplaced-vertex",
            Fault::AcrossCells { .. } => "triangle-across-cells",
            Fault::TriangleInFace { .. } => "triangle-in-face",
            Fault::EdgeInFace { .. } => "edge-in-face",
            Fault::Hole { .. } => "hole",
            Fault::WrongLoops { .. } => "wrong-loops",
            Fault::Reversed { .. } => "reversed-orientation",
            Fault::WrongComponents { .. } => "wrong-components",
            Fault::WrongTotals { .. } => "wrong-totals",
            Fault::Refused { .. } => "refused",
            Fault::NeitherTie { .. } => "neither-tie",
        }
    }

    /// The spec entry of the truth that it breaks.
    pub const fn formula(&self) -> &'static str {
        match self {
            Fault::NotFinite { .. } | Fault::OutsideGrid { .. } | Fault::Misplaced { .. } => "IS-30",
            Fault::Defect(Defect::NonmanifoldVertex { .. }) => "IS-11",
            Fault::Defect(_) | Fault::Hole { .. } => "IS-10",
            Fault::StrayVertex { .. }
            | Fault::VertexAtGridPoint { .. }
            | Fault::MissingCrossing { .. }
            | Fault::RepeatedCrossing { .. } => "IS-54",
            Fault::AcrossCells { .. } | Fault::TriangleInFace { .. } | Fault::EdgeInFace { .. } => "IS-91",
            Fault::WrongLoops { .. } => "IS-76",
            Fault::Reversed { .. } => "IS-94",
            Fault::WrongComponents { .. } => "IS-77",
            Fault::WrongTotals { .. } | Fault::Refused { .. } => "IS-89",
            Fault::NeitherTie { .. } => "IS-86",
        }
    }

    /// The cell that shows it, and its case, where one cell does.
    pub const fn cell(&self) -> Option<(Cell, Case)> {
        match self {
            Fault::EdgeInFace { cell, case }
            | Fault::Hole { cell, case, .. }
            | Fault::WrongLoops { cell, case, .. }
            | Fault::Reversed { cell, case }
            | Fault::WrongComponents { cell, case, .. } => Some((*cell, *case)),
            _ => None,
        }
    }

    /// The invariant that differs, where there is one.
    pub const fn difference(&self) -> Option<&Difference> {
        match self {
            Fault::WrongLoops { difference, .. }
            | Fault::WrongComponents { difference, .. }
            | Fault::WrongTotals { difference }
            | Fault::NeitherTie { difference } => Some(difference),
            _ => None,
        }
    }
}
