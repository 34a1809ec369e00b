//! Cell complexes of points, segments, discs and annuli, glued along their borders: what the definition of a cell
//! lets in, and what it must not (IS-1 … IS-3).

use std::collections::BTreeSet;
use thiserror::Error;

/// A cell of a [`CellComplex`], by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(pub usize);

/// The bounded open set that a cell is the image of, with the cells that its border runs through.
///
/// The text allows every bounded open set; with an annulus the count #2 − #1 + #0 is not χ. It holds where every
/// cell is an open ball (IS-1).
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "IS-1")]
pub enum Cell {
    /// A point; its border is empty.
    Vertex,
    /// An open segment, by its two ends, which may be one vertex.
    Edge([CellId; 2]),
    /// An open disc, by the closed walk along its border.
    Disc(Walk),
    /// An open annulus, by the closed walks along its two borders.
    Annulus([Walk; 2]),
}

/// A closed walk that stays at one vertex, or goes along edges, each from its first end to its second or back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Walk {
    /// At a vertex.
    Constant(CellId),
    /// Along edges; `true`: from the first end to the second. Not empty.
    Edges(Vec<(CellId, bool)>),
}

/// Why cells make no complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum CellError {
    /// A border runs through what is no cell, or no cell of the dimension it must have there.
    #[error("cell {}: its border runs through {}, which is no cell of that dimension", .cell.0, .through.0)]
    Border {
        /// The cell.
        cell: CellId,
        /// What its border names.
        through: CellId,
    },
    /// A walk does not go on where it has come to, or does not come back.
    #[error("cell {}: its border is no closed walk", .0.0)]
    Open(CellId),
}

/// A finite set of disjoint open cells, the border of each a union of cells of smaller dimension (IS-3).
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "IS-3")]
pub struct CellComplex {
    cells: Vec<Cell>,
}

impl CellComplex {
    /// The complex of these cells, numbered in order.
    ///
    /// # Errors
    /// Iff an end of an edge is no vertex, or a border of a disc or annulus is no closed walk along edges.
    pub fn new(cells: Vec<Cell>) -> Result<CellComplex, CellError> {
        let complex = CellComplex { cells };
        for (id, cell) in complex.ids() {
            match cell {
                Cell::Vertex => {}
                Cell::Edge(ends) => ends.iter().try_for_each(|v| complex.vertex(id, *v))?,
                Cell::Disc(walk) => complex.check(id, walk)?,
                Cell::Annulus(walks) => walks.iter().try_for_each(|walk| complex.check(id, walk))?,
            }
        }
        Ok(complex)
    }

    fn ids(&self) -> impl Iterator<Item = (CellId, &Cell)> {
        self.cells.iter().enumerate().map(|(i, cell)| (CellId(i), cell))
    }

    fn vertex(&self, cell: CellId, through: CellId) -> Result<(), CellError> {
        match self.cells.get(through.0) {
            Some(Cell::Vertex) => Ok(()),
            Some(Cell::Edge(_) | Cell::Disc(_) | Cell::Annulus(_)) | None => Err(CellError::Border { cell, through }),
        }
    }

    fn check(&self, cell: CellId, walk: &Walk) -> Result<(), CellError> {
        let edges = match walk {
            Walk::Constant(vertex) => return self.vertex(cell, *vertex),
            Walk::Edges(edges) => edges,
        };
        let steps: Vec<[CellId; 2]> = edges
            .iter()
            .map(|&(edge, forward)| match self.cells.get(edge.0) {
                Some(Cell::Edge([from, to])) => Ok(if forward { [*from, *to] } else { [*to, *from] }),
                Some(Cell::Vertex | Cell::Disc(_) | Cell::Annulus(_)) | None => {
                    Err(CellError::Border { cell, through: edge })
                }
            })
            .collect::<Result<_, _>>()?;
        let goes_on = (0..steps.len()).all(|i| steps[i][1] == steps[(i + 1) % steps.len()][0]);
        if goes_on && !steps.is_empty() { Ok(()) } else { Err(CellError::Open(cell)) }
    }

    /// The cells that the border of a cell is the union of.
    ///
    /// # Panics
    /// Iff there is no such cell.
    pub fn border(&self, cell: CellId) -> BTreeSet<CellId> {
        let walked = |walk: &Walk| match walk {
            Walk::Constant(vertex) => BTreeSet::from([*vertex]),
            Walk::Edges(edges) => edges.iter().flat_map(|&(edge, _)| self.closure(edge)).collect(),
        };
        match &self.cells[cell.0] {
            Cell::Vertex => BTreeSet::new(),
            Cell::Edge(ends) => ends.iter().copied().collect(),
            Cell::Disc(walk) => walked(walk),
            Cell::Annulus(walks) => walks.iter().flat_map(walked).collect(),
        }
    }

    /// A cell and the cells of its border.
    ///
    /// # Panics
    /// Iff there is no such cell.
    pub fn closure(&self, cell: CellId) -> BTreeSet<CellId> {
        let mut closure = self.border(cell);
        closure.insert(cell);
        closure
    }

    /// The cells that lie in both closures: a union of cells, not always one (IS-2).
    ///
    /// # Panics
    /// Iff there is no such cell.
    #[doc(alias = "IS-2")]
    pub fn common_border(&self, a: CellId, b: CellId) -> BTreeSet<CellId> {
        self.closure(a).intersection(&self.closure(b)).copied().collect()
    }

    /// Whether these cells are those of one closed cell.
    pub fn is_one_closed_cell(&self, cells: &BTreeSet<CellId>) -> bool {
        cells.iter().any(|cell| self.closure(*cell) == *cells)
    }

    /// #0, #1, #2.
    pub fn counts(&self) -> [i64; 3] {
        let count = |d: usize| self.cells.iter().filter(|cell| cell.dimension() == d).count() as i64;
        [0, 1, 2].map(count)
    }

    /// χ: cells are disjoint, and add the Euler characteristics of open sets, 1, −1, 1 and, for an annulus, 0.
    pub fn euler_characteristic(&self) -> i64 {
        let of = |cell: &Cell| match cell {
            Cell::Vertex | Cell::Disc(_) => 1,
            Cell::Edge(_) => -1,
            Cell::Annulus(_) => 0,
        };
        self.cells.iter().map(of).sum()
    }
}

impl Cell {
    /// Its dimension.
    pub fn dimension(&self) -> usize {
        match self {
            Cell::Vertex => 0,
            Cell::Edge(_) => 1,
            Cell::Disc(_) | Cell::Annulus(_) => 2,
        }
    }
}
