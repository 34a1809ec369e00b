//! Where in a grid the vertices of a candidate's mesh lie.

use super::candidate_mesh::Positions;
use super::fault::{Cell, Fault};
use crate::isosurface::cube::Edge;
use crate::isosurface::fast;
use crate::isosurface::volume::{GridEdge, Level};
use crate::judge::report::PositionError;
use crate::number::{Integer, Rational, binary};

/// What a vertex stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The crossing on an edge of the grid.
    Crossing(GridEdge),
    /// Inside the face across `axis` above the grid point `low`, on an arc of the surface or wrongly there.
    Face {
        /// The least grid point of the face.
        low: Cell,
        /// The axis of its normal.
        axis: usize,
    },
    /// Inside a cell.
    Inside(Cell),
}

impl Place {
    /// The least and the greatest cell, by index, that touch the place; as ranges per axis, clipped to the grid.
    pub fn cells(&self, level: &Level) -> [[usize; 2]; 3] {
        let shape = level.volume.shape();
        let around = |i: usize, axis: usize| [i.saturating_sub(1), i.min(shape[axis] - 2)];
        match *self {
            Place::Crossing(edge) => {
                let point = level.volume.point(edge.low as usize);
                std::array::from_fn(|a| if a == usize::from(edge.axis) { [point[a]; 2] } else { around(point[a], a) })
            }
            Place::Face { low, axis } => {
                std::array::from_fn(|a| if a == axis { around(low[a], a) } else { [low[a]; 2] })
            }
            Place::Inside(cell) => cell.map(|i| [i; 2]),
        }
    }

    /// Whether the place lies on the boundary plane of the cell with this coordinate fixed.
    pub fn on_plane(&self, level: &Level, axis: usize, at: usize) -> bool {
        match *self {
            Place::Crossing(edge) => {
                usize::from(edge.axis) != axis && level.volume.point(edge.low as usize)[axis] == at
            }
            Place::Face { low, axis: normal } => normal == axis && low[axis] == at,
            Place::Inside(_) => false,
        }
    }
}

/// The places of all vertices, and the faults on the way.
pub struct Places {
    /// The place of each vertex; `None` where it has none.
    pub of: Vec<Option<Place>>,
    /// What was wrong.
    pub faults: Vec<Fault>,
    /// The largest errors on grid edges.
    pub error: PositionError,
}

/// Which side of the isovalue every sample is on.
pub struct Sides {
    outside: Vec<bool>,
}

impl Sides {
    /// The sides of all samples of a level.
    pub fn new(level: &Level) -> Sides {
        Sides { outside: fast::outside(level) }
    }

    /// Whether the surface crosses an edge of the grid.
    pub fn crosses(&self, level: &Level, edge: GridEdge) -> bool {
        self.outside[edge.low as usize] != self.outside[level.high(edge)]
    }
}

/// How far a vertex may be from the true crossing, in units in the last place of binary32.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance(pub f64);

impl Default for Tolerance {
    fn default() -> Tolerance {
        Tolerance(64.0)
    }
}

/// Finds the place of every vertex of a mesh.
pub fn places(level: &Level, sides: &Sides, positions: &Positions, tolerance: Tolerance) -> Places {
    let mut places =
        Places { of: Vec::with_capacity(positions.len()), faults: Vec::new(), error: PositionError::default() };
    let mut at_grid_points = Vec::new();
    for vertex in 0..positions.len() {
        let place = match positions.exact(vertex) {
            None => Err(Fault::NotFinite { vertex }),
            Some(position) => place(level, vertex, &position),
        };
        places.of.push(match place {
            Ok(Found::Place(Place::Crossing(edge))) if !sides.crosses(level, edge) => {
                let low = level.volume.point(edge.low as usize);
                places.faults.push(Fault::StrayVertex { vertex, low, axis: edge.axis });
                None
            }
            Ok(Found::Place(place)) => Some(place),
            Ok(Found::GridPoint(point)) => {
                at_grid_points.push((vertex, point));
                None
            }
            Err(fault) => {
                places.faults.push(fault);
                None
            }
        });
    }
    resolve_grid_points(level, sides, &mut places, &at_grid_points);
    for (vertex, place) in places.of.iter().enumerate() {
        let Some(Place::Crossing(edge)) = place else { continue };
        let axis = usize::from(edge.axis);
        let found = positions.rounded(vertex)[axis];
        let exact = &level.crossing_position(*edge)[axis];
        let ulp = |error: Result<Rational, _>| error.map_or(f64::INFINITY, |e: Rational| e.to_f64());
        let wide = ulp(binary::ulp_error(found, exact));
        let narrow = ulp(binary::ulp_error_f32(found as f32, exact));
        places.error.binary64_ulp = places.error.binary64_ulp.max(wide);
        places.error.binary32_ulp = places.error.binary32_ulp.max(narrow);
        if narrow > tolerance.0 {
            places.faults.push(Fault::Misplaced { vertex, ulp: narrow.ceil() as u64 });
        }
    }
    places
}

enum Found {
    Place(Place),
    GridPoint(Cell),
}

fn place(level: &Level, vertex: usize, position: &[Rational; 3]) -> Result<Found, Fault> {
    let shape = level.volume.shape();
    let mut low = [0; 3];
    let mut between = [false; 3];
    for axis in 0..3 {
        let floor = Integer::from(position[axis].floor_ref());
        let is_between = !position[axis].is_integer();
        let last = shape[axis] - 1;
        low[axis] = match floor.to_usize() {
            Some(i) if i < last || (i == last && !is_between) => i,
            _ => return Err(Fault::OutsideGrid { vertex }),
        };
        between[axis] = is_between;
    }
    Ok(match between {
        [false, false, false] => Found::GridPoint(low),
        [true, true, true] => Found::Place(Place::Inside(low)),
        _ => {
            let along: Vec<usize> = (0..3).filter(|&axis| between[axis]).collect();
            match along[..] {
                [axis] => {
                    Found::Place(Place::Crossing(GridEdge { low: level.volume.index(low) as u32, axis: axis as u8 }))
                }
                _ => {
                    let axis = (0..3).find(|&axis| !between[axis]).expect("one coordinate is integral");
                    Found::Place(Place::Face { low, axis })
                }
            }
        }
    })
}

/// A crossing very near a grid point may be rounded onto it. Each vertex at a grid point gets the nearest
/// crossing on an edge at that point which no other vertex stands for.
fn resolve_grid_points(level: &Level, sides: &Sides, places: &mut Places, vertices: &[(usize, Cell)]) {
    use std::collections::HashSet;
    if vertices.is_empty() {
        return;
    }
    let mut taken: HashSet<GridEdge> = places
        .of
        .iter()
        .filter_map(|place| match place {
            Some(Place::Crossing(edge)) => Some(*edge),
            _ => None,
        })
        .collect();
    for &(vertex, point) in vertices {
        let nearest = edges_at(level, point)
            .filter(|(edge, _)| sides.crosses(level, *edge) && !taken.contains(edge))
            .map(|(edge, is_low)| {
                let share = level.crossing(edge);
                (if is_low { share } else { Rational::from(1) - share }, edge)
            })
            .min();
        match nearest {
            Some((_, edge)) => {
                taken.insert(edge);
                places.of[vertex] = Some(Place::Crossing(edge));
            }
            None => places.faults.push(Fault::VertexAtGridPoint { vertex, point }),
        }
    }
}

/// The grid edges at a grid point, and whether the point is their lower end.
fn edges_at(level: &Level, point: Cell) -> impl Iterator<Item = (GridEdge, bool)> {
    let shape = level.volume.shape();
    let edge = |low: Cell, axis: usize| GridEdge { low: level.volume.index(low) as u32, axis: axis as u8 };
    (0..3).flat_map(move |axis| {
        let up = (point[axis] + 1 < shape[axis]).then(|| (edge(point, axis), true));
        let down = (point[axis] > 0).then(|| {
            let mut low = point;
            low[axis] -= 1;
            (edge(low, axis), false)
        });
        [up, down].into_iter().flatten()
    })
}

/// The edge of a cell that is a given edge of the grid.
pub fn cell_edge(level: &Level, cell: Cell, edge: GridEdge) -> Option<Edge> {
    Edge::ALL.into_iter().find(|e| level.grid_edge(cell, *e) == edge)
}
