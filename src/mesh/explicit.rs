//! The explicit list: every polygon by the positions of its vertices, and nothing that polygons share.

use super::operations::{Counted, NoSuch, Noted, Operations, counted};
use super::vertex_list::Point;
use std::collections::BTreeSet;

/// A polygon with holes by something that stands once for each of its corners: a position, a vertex, a side. Loops are
/// closed implicitly.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Polygon<T> {
    /// The outer loop.
    pub outer: Vec<T>,
    /// The loops of the holes.
    pub holes: Vec<Vec<T>>,
}

impl<T> Polygon<T> {
    /// A polygon without holes.
    pub fn new(outer: impl Into<Vec<T>>) -> Polygon<T> {
        Polygon { outer: outer.into(), holes: Vec::new() }
    }

    /// Its loops, the outer one first.
    pub fn loops(&self) -> impl Iterator<Item = &[T]> {
        std::iter::once(&self.outer[..]).chain(self.holes.iter().map(|hole| &hole[..]))
    }

    /// What stands for its corners, loop by loop.
    pub fn corners(&self) -> impl Iterator<Item = &T> {
        self.loops().flatten()
    }

    /// The polygon with each loop replaced.
    ///
    /// # Errors
    /// The first error of the replacement. It is given the number of the loop, the outer one being 0, and the loop.
    pub fn try_map<U, E>(&self, mut f: impl FnMut(usize, &[T]) -> Result<Vec<U>, E>) -> Result<Polygon<U>, E> {
        let outer = f(0, &self.outer)?;
        let holes = self.holes.iter().enumerate().map(|(i, hole)| f(i + 1, hole)).collect::<Result<_, E>>()?;
        Ok(Polygon { outer, holes })
    }

    /// The polygon with each corner replaced.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> Polygon<U> {
        let mut all = |corners: &[T]| corners.iter().map(&mut f).collect();
        Polygon { outer: all(&self.outer), holes: self.holes.iter().map(|hole| all(hole)).collect() }
    }
}

/// A mesh by its polygons, Pᵢ = (x₁,y₁,z₁), …, (xₙ,yₙ,zₙ), in the order of each loop: as a set of triples, which the
/// text prints, they make no one polygon (ME-3). A vertex is a position: it is stored once for each corner (ME-4),
/// and two vertices at one position are one. Vertices that no polygon uses cannot be stored.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[doc(alias = "ME-3")]
pub struct ExplicitList {
    /// Polygons.
    pub polygons: Vec<Polygon<Point>>,
}

impl ExplicitList {
    /// S, the number of corners.
    pub fn corner_count(&self) -> u64 {
        self.polygons.iter().map(|polygon| polygon.corners().count() as u64).sum()
    }

    /// How often a position is stored: once for each corner there, which is once for each polygon that refers to it
    /// where no polygon comes to it twice (ME-4).
    #[doc(alias = "ME-4")]
    pub fn copies(&self, of: &Point) -> usize {
        self.polygons.iter().flat_map(Polygon::corners).filter(|corner| *corner == of).count()
    }

    /// The segments drawn where each polygon draws its sides: a common edge as often as polygons use it (ME-5).
    #[doc(alias = "ME-5")]
    pub fn strokes(&self) -> Vec<[&Point; 2]> {
        self.polygons.iter().flat_map(Polygon::loops).flat_map(pairs).filter(|[a, b]| a != b).collect()
    }

    /// Each segment once, by the text's procedure without further memory: before a side is drawn, all sides before it
    /// are read to see whether one is the same segment. It reads up to S + S(S−1)/2 sides, and all of these iff no
    /// segment comes twice (ME-6); [`Operations::segments`] remembers what it has drawn and reads S.
    #[doc(alias = "ME-6")]
    pub fn segments_by_rescanning(&self) -> Counted<Vec<[Point; 2]>> {
        let all: Vec<[&Point; 2]> = self.polygons.iter().flat_map(Polygon::loops).flat_map(pairs).collect();
        let (mut segments, mut reads) = (Vec::new(), 0);
        for (i, &[a, b]) in all.iter().enumerate() {
            let drawn = all[..i].iter().position(|&side| side == [a, b] || side == [b, a]);
            reads += 1 + drawn.map_or(i, |at| at + 1) as u64;
            if drawn.is_none() && a != b {
                segments.push(unordered([a, b]));
            }
        }
        Counted { answer: segments, reads }
    }

    /// The words it takes, a coordinate being one: 3S (ME-13).
    pub fn words(&self) -> u64 {
        3 * self.corner_count()
    }

    /// What a scan of all corners finds: `find` is given the polygon and the side that begins at the corner.
    fn scan(&self, mut find: impl FnMut(usize, [&Point; 2])) -> u64 {
        for (face, polygon) in self.polygons.iter().enumerate() {
            polygon.loops().flat_map(pairs).for_each(|side| find(face, side));
        }
        self.corner_count()
    }

    fn uses(&self) -> (Noted<[Point; 2]>, u64) {
        let mut uses = Noted::default();
        let reads = self.scan(|_, [a, b]| {
            if a != b {
                uses.note(unordered([a, b]));
            }
        });
        (uses, reads)
    }
}

/// The sides of a loop, from each corner to the next.
fn pairs<T>(corners: &[T]) -> impl Iterator<Item = [&T; 2]> {
    (0..corners.len()).map(|i| [&corners[i], &corners[(i + 1) % corners.len()]])
}

fn unordered([a, b]: [&Point; 2]) -> [Point; 2] {
    [a.min(b).clone(), a.max(b).clone()]
}

/// A vertex is its position; an edge is its two ends, the smaller position first. A side between equal positions is no
/// edge.
impl Operations for ExplicitList {
    type Vertex = Point;
    type Edge = [Point; 2];

    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch> {
        counted(self.polygons.clone(), self.corner_count())
    }

    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let (uses, reads) = self.uses();
        counted(uses.once_each(), reads)
    }

    fn edges_at(&self, vertex: &Point) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let (mut edges, mut is_there) = (BTreeSet::new(), false);
        let reads = self.scan(|_, [a, b]| {
            is_there |= a == vertex;
            if a != b && (a == vertex || b == vertex) {
                edges.insert(unordered([a, b]));
            }
        });
        if is_there { counted(edges.into_iter().collect(), reads) } else { Err(NoSuch::Vertex) }
    }

    fn ends(&self, [a, b]: &[Point; 2]) -> Result<Counted<[Point; 2]>, NoSuch> {
        counted(unordered([a, b]), 0)
    }

    /// That they are common is not stored: it follows from equal positions (ME-8).
    #[doc(alias = "ME-8")]
    fn faces_of_edge(&self, [a, b]: &[Point; 2]) -> Result<Counted<Vec<usize>>, NoSuch> {
        let mut faces = BTreeSet::new();
        let reads = self.scan(|face, side| {
            if a != b && (side == [a, b] || side == [b, a]) {
                faces.insert(face);
            }
        });
        if faces.is_empty() { Err(NoSuch::Edge) } else { counted(faces.into_iter().collect(), reads) }
    }

    fn faces_at(&self, vertex: &Point) -> Result<Counted<Vec<usize>>, NoSuch> {
        let mut faces = BTreeSet::new();
        let reads = self.scan(|face, [a, _]| {
            if a == vertex {
                faces.insert(face);
            }
        });
        if faces.is_empty() { Err(NoSuch::Vertex) } else { counted(faces.into_iter().collect(), reads) }
    }

    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch> {
        let polygon = self.polygons.get(face).ok_or(NoSuch::Face)?;
        let own: BTreeSet<[Point; 2]> =
            polygon.loops().flat_map(pairs).filter(|[a, b]| a != b).map(unordered).collect();
        let mut faces = BTreeSet::new();
        let reads = self.scan(|other, side| {
            if other != face && own.contains(&unordered(side)) {
                faces.insert(other);
            }
        });
        counted(faces.into_iter().collect(), polygon.corners().count() as u64 + reads)
    }

    /// Every corner at the position moves; all are read (ME-7). Where the new position is another vertex's, the two
    /// are one from then on (ME-45).
    #[doc(alias = "ME-7")]
    #[doc(alias = "ME-45")]
    fn move_vertex(&mut self, vertex: &Point, to: Point) -> Result<Counted<()>, NoSuch> {
        let (mut reads, mut is_there) = (0, false);
        let loops = self.polygons.iter_mut().flat_map(|p| std::iter::once(&mut p.outer).chain(&mut p.holes));
        for corner in loops.flatten() {
            reads += 1;
            if corner == vertex {
                corner.clone_from(&to);
                is_there = true;
            }
        }
        if is_there { counted((), reads) } else { Err(NoSuch::Vertex) }
    }

    fn boundary_edges(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let (uses, reads) = self.uses();
        counted(uses.noted_once(), reads)
    }

    /// None: a vertex is there only as a corner.
    fn unused_vertices(&self) -> Result<Counted<Vec<Point>>, NoSuch> {
        counted(Vec::new(), 0)
    }
}
