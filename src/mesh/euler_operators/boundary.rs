//! The boundary representation that the operators work on, and what can be wrong with one.

use super::counts::Counts;
use super::names::{FaceId, HalfEdge, LoopId, Name, ShellId, VertexId};
use crate::mesh::face::Face;
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};

/// Shells, faces, loops, half-edges, vertices. The half-edges of a loop have the face on their left, seen from outside; a
/// loop without half-edges has one vertex, which is *alone*. The half-edges that begin at a vertex make one cycle around
/// it: after h comes the one that follows h's mate in its loop.
///
/// Two are equal iff they are the same to the names. An operator is applied whole or not at all, so every boundary made of
/// operators is sound.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Boundary {
    pub(super) half_edges: BTreeMap<HalfEdge, Links>,
    pub(super) vertices: BTreeMap<VertexId, VertexRecord>,
    pub(super) loops: BTreeMap<LoopId, LoopRecord>,
    pub(super) faces: BTreeMap<FaceId, FaceRecord>,
    pub(super) shells: BTreeSet<ShellId>,
    /// The sum of the changes of the operators that made it.
    pub(super) tracked: Counts,
}

/// Where a half-edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Links {
    pub origin: VertexId,
    pub loop_: LoopId,
    pub next: HalfEdge,
    pub prev: HalfEdge,
}

/// The half-edges that begin at a vertex, or the loop of which it is all.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub(super) struct VertexRecord {
    pub half_edges: BTreeSet<HalfEdge>,
    pub alone: Option<LoopId>,
}

/// The half-edges of a loop, or its only vertex.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct LoopRecord {
    pub face: FaceId,
    pub half_edges: BTreeSet<HalfEdge>,
    pub alone: Option<VertexId>,
}

/// The loops of a face, and its shell.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct FaceRecord {
    pub shell: ShellId,
    pub outer: LoopId,
    pub rings: BTreeSet<LoopId>,
}

/// What is wrong with a boundary. There is never one where it was made by the operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Defect {
    /// It names something that does not exist.
    Missing(Name),
    /// The half-edge has no mate.
    NoMate(HalfEdge),
    /// The next one's previous one is another, or the previous one's next.
    Links(HalfEdge),
    /// The loop's half-edges are not one cycle, each followed by the next, from the end of the one before; or it has
    /// neither half-edges nor a vertex, or both.
    Loop(LoopId),
    /// The half-edges that begin at the vertex are not one cycle around it; or it has neither these nor a loop, or both.
    Vertex(VertexId),
    /// The loops that name the face are not its outer loop and its rings.
    Face(FaceId),
    /// The shell's faces are not one connected component.
    Shell(ShellId),
    /// V, E, F, H, C, G as the operators changed them differ from what is there.
    Counts {
        /// The sum of the changes.
        tracked: Counts,
        /// The numbers of its elements, of its connected components, and of their handles.
        counted: Counts,
    },
}

impl Boundary {
    /// The boundary of nothing.
    pub fn new() -> Boundary {
        Boundary::default()
    }

    /// Its vertices, sorted.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> {
        self.vertices.keys().copied()
    }

    /// Its half-edges, sorted.
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdge> {
        self.half_edges.keys().copied()
    }

    /// Its loops, sorted.
    pub fn loops(&self) -> impl Iterator<Item = LoopId> {
        self.loops.keys().copied()
    }

    /// Its faces, sorted.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> {
        self.faces.keys().copied()
    }

    /// Its shells, sorted.
    pub fn shells(&self) -> impl Iterator<Item = ShellId> {
        self.shells.iter().copied()
    }

    /// The half-edge after this one in its loop.
    pub fn next(&self, h: HalfEdge) -> Option<HalfEdge> {
        self.half_edges.get(&h).map(|links| links.next)
    }

    /// The half-edge before this one in its loop.
    pub fn prev(&self, h: HalfEdge) -> Option<HalfEdge> {
        self.half_edges.get(&h).map(|links| links.prev)
    }

    /// The vertex at which a half-edge begins.
    pub fn origin(&self, h: HalfEdge) -> Option<VertexId> {
        self.half_edges.get(&h).map(|links| links.origin)
    }

    /// The loop of a half-edge.
    pub fn loop_of(&self, h: HalfEdge) -> Option<LoopId> {
        self.half_edges.get(&h).map(|links| links.loop_)
    }

    /// The face of a loop.
    pub fn face_of(&self, l: LoopId) -> Option<FaceId> {
        self.loops.get(&l).map(|record| record.face)
    }

    /// The vertex of a loop without edges.
    pub fn alone(&self, l: LoopId) -> Option<VertexId> {
        self.loops.get(&l).and_then(|record| record.alone)
    }

    /// The outer loop of a face.
    pub fn outer(&self, f: FaceId) -> Option<LoopId> {
        self.faces.get(&f).map(|record| record.outer)
    }

    /// The rings of a face, sorted; none for a face that does not exist.
    pub fn rings(&self, f: FaceId) -> impl Iterator<Item = LoopId> {
        self.faces.get(&f).into_iter().flat_map(|record| record.rings.iter().copied())
    }

    /// The shell of a face.
    pub fn shell_of(&self, f: FaceId) -> Option<ShellId> {
        self.faces.get(&f).map(|record| record.shell)
    }

    /// The half-edges of a loop in order, from the smallest; none for one without edges, or that does not exist.
    pub fn cycle(&self, l: LoopId) -> Vec<HalfEdge> {
        let first = self.loops.get(&l).and_then(|record| record.half_edges.first().copied());
        first.map_or_else(Vec::new, |first| self.orbit(first, |h| self.next(h)))
    }

    /// The half-edges that begin where this one does, in order around the vertex; none for one that does not exist.
    pub fn around(&self, h: HalfEdge) -> Vec<HalfEdge> {
        self.orbit(h, |h| self.next(h.mate()))
    }

    /// h, step(h), … up to the first that was there before, or is none.
    pub(super) fn orbit(&self, h: HalfEdge, step: impl Fn(HalfEdge) -> Option<HalfEdge>) -> Vec<HalfEdge> {
        let mut seen = BTreeSet::new();
        let existing = Some(h).filter(|h| self.half_edges.contains_key(h));
        std::iter::successors(existing, |&h| step(h)).take_while(|h| seen.insert(*h)).collect()
    }

    /// Its faces by the numbers of their vertices, in the order of their names; a lone vertex makes a loop of one.
    pub fn polygons(&self) -> Vec<Face> {
        let polygon = |l: LoopId| -> Vec<u32> {
            let along = self.cycle(l).into_iter().filter_map(|h| self.origin(h));
            self.alone(l).into_iter().chain(along).map(|v| v.0).collect()
        };
        self.faces
            .values()
            .map(|face| Face {
                outer: polygon(face.outer),
                holes: face.rings.iter().map(|ring| polygon(*ring)).collect(),
            })
            .collect()
    }

    /// V, E, F, H, C, G as the operators have made them: the sum of their changes.
    pub fn tracked(&self) -> Counts {
        self.tracked
    }

    /// V, E, F, H, C, G of what is there, whatever made it: C the number of parts that hang together through edges and
    /// faces, G the sum of their genera 1 − χ/2, where χ of a part is V − E + Σ (2 − loops of a face).
    pub fn counted(&self) -> Counts {
        let number: BTreeMap<FaceId, usize> = self.faces().zip(0..).collect();
        let part_of = self.parts(&number);
        let mut chi: BTreeMap<usize, i64> = BTreeMap::new();
        let part = |l: LoopId| self.face_of(l).and_then(|f| number.get(&f)).map(|&i| part_of[i]);
        for (f, record) in &self.faces {
            *chi.entry(part_of[number[f]]).or_default() += 1 - record.rings.len() as i64;
        }
        for vertex in self.vertices.values() {
            let at = vertex.half_edges.first().and_then(|&h| self.loop_of(h));
            at.or(vertex.alone).and_then(part).into_iter().for_each(|part| *chi.entry(part).or_default() += 1);
        }
        for h in self.half_edges.keys().filter(|h| h.0 % 2 == 0) {
            self.loop_of(*h).and_then(part).into_iter().for_each(|part| *chi.entry(part).or_default() -= 1);
        }
        Counts {
            v: self.vertices.len() as i64,
            e: self.half_edges.len() as i64 / 2,
            f: self.faces.len() as i64,
            h: self.loops.len() as i64 - self.faces.len() as i64,
            c: chi.len() as i64,
            g: chi.values().map(|chi| 1 - chi.div_euclid(2)).sum(),
        }
    }

    /// The parts that hang together: for each face, by its number, the number of its part's first face.
    pub(super) fn parts(&self, number: &BTreeMap<FaceId, usize>) -> Vec<usize> {
        let mut parts = Partition::new(number.len());
        let face = |h: HalfEdge| self.loop_of(h).and_then(|l| self.face_of(l)).and_then(|f| number.get(&f)).copied();
        for h in self.half_edges() {
            if let (Some(a), Some(b)) = (face(h), face(h.mate())) {
                parts.join(a, b);
            }
        }
        (0..number.len()).map(|i| parts.find(i)).collect()
    }

    /// Everything that is wrong with it, sorted; empty iff it is sound.
    #[doc(alias = "ME-116")]
    pub fn defects(&self) -> Vec<Defect> {
        let mut defects = self.missing();
        if !defects.is_empty() {
            return defects;
        }
        for (&h, links) in &self.half_edges {
            if self.prev(links.next) != Some(h) || self.next(links.prev) != Some(h) {
                defects.push(Defect::Links(h));
            }
            if !self.loops[&links.loop_].half_edges.contains(&h) {
                defects.push(Defect::Loop(links.loop_));
            }
            if !self.vertices[&links.origin].half_edges.contains(&h) {
                defects.push(Defect::Vertex(links.origin));
            }
        }
        for (&l, record) in &self.loops {
            let cycle = self.cycle(l);
            let follows = |h: HalfEdge| self.next(h).and_then(|n| self.origin(n)) == self.origin(h.mate());
            let is_cycle = record.half_edges.iter().eq(&cycle.iter().copied().collect::<BTreeSet<_>>())
                && cycle.iter().all(|h| self.loop_of(*h) == Some(l) && follows(*h));
            let is_lone = record.alone.is_some_and(|v| self.vertices[&v].alone == Some(l));
            if record.alone.is_some() != cycle.is_empty() || !is_cycle || is_lone != cycle.is_empty() {
                defects.push(Defect::Loop(l));
            }
        }
        for (&v, record) in &self.vertices {
            let around: BTreeSet<HalfEdge> =
                record.half_edges.first().into_iter().flat_map(|&h| self.around(h)).collect();
            let is_lone = record.alone.is_some_and(|l| self.loops[&l].alone == Some(v));
            let begin_here = around.iter().all(|h| self.origin(*h) == Some(v));
            if record.alone.is_some() != around.is_empty()
                || is_lone != around.is_empty()
                || !begin_here
                || record.half_edges != around
            {
                defects.push(Defect::Vertex(v));
            }
        }
        let mut own: BTreeMap<FaceId, BTreeSet<LoopId>> = BTreeMap::new();
        for (&l, record) in &self.loops {
            own.entry(record.face).or_default().insert(l);
        }
        for (&f, record) in &self.faces {
            let named: BTreeSet<LoopId> = record.rings.iter().copied().chain([record.outer]).collect();
            if own.get(&f) != Some(&named) || record.rings.contains(&record.outer) {
                defects.push(Defect::Face(f));
            }
        }
        defects.extend(self.shell_defects());
        let (tracked, counted) = (self.tracked, self.counted());
        if tracked != counted {
            defects.push(Defect::Counts { tracked, counted });
        }
        defects.sort();
        defects.dedup();
        defects
    }

    /// Names that stand in records, of what does not exist, and half-edges that nothing holds.
    fn missing(&self) -> Vec<Defect> {
        let mut defects = BTreeSet::new();
        let mut need = |name: Name| {
            if !self.has(name) {
                defects.insert(Defect::Missing(name));
            }
        };
        for links in self.half_edges.values() {
            need(Name::Vertex(links.origin));
            need(Name::Loop(links.loop_));
            need(Name::HalfEdge(links.next));
            need(Name::HalfEdge(links.prev));
        }
        for record in self.vertices.values() {
            record.half_edges.iter().for_each(|h| need(Name::HalfEdge(*h)));
            record.alone.into_iter().for_each(|l| need(Name::Loop(l)));
        }
        for record in self.loops.values() {
            need(Name::Face(record.face));
            record.half_edges.iter().for_each(|h| need(Name::HalfEdge(*h)));
            record.alone.into_iter().for_each(|v| need(Name::Vertex(v)));
        }
        for record in self.faces.values() {
            need(Name::Shell(record.shell));
            record.rings.iter().chain([&record.outer]).for_each(|l| need(Name::Loop(*l)));
        }
        let without_mate = self.half_edges().filter(|h| !self.half_edges.contains_key(&h.mate()));
        defects.extend(without_mate.map(Defect::NoMate));
        defects.into_iter().collect()
    }

    /// Shells whose faces are not one part of those that hang together.
    fn shell_defects(&self) -> Vec<Defect> {
        let number: BTreeMap<FaceId, usize> = self.faces().zip(0..).collect();
        let part_of = self.parts(&number);
        let mut shells_of: BTreeMap<usize, BTreeSet<ShellId>> = BTreeMap::new();
        let mut parts_of: BTreeMap<ShellId, BTreeSet<usize>> =
            self.shells.iter().map(|s| (*s, BTreeSet::new())).collect();
        for (f, record) in &self.faces {
            shells_of.entry(part_of[number[f]]).or_default().insert(record.shell);
            parts_of.entry(record.shell).or_default().insert(part_of[number[f]]);
        }
        let is_one = |parts: &BTreeSet<usize>| parts.len() == 1 && parts.iter().all(|part| shells_of[part].len() == 1);
        parts_of.iter().filter(|(_, parts)| !is_one(parts)).map(|(s, _)| Defect::Shell(*s)).collect()
    }

    /// Whether something of that name exists.
    pub fn has(&self, name: Name) -> bool {
        match name {
            Name::Vertex(v) => self.vertices.contains_key(&v),
            Name::HalfEdge(h) => self.half_edges.contains_key(&h),
            Name::Loop(l) => self.loops.contains_key(&l),
            Name::Face(f) => self.faces.contains_key(&f),
            Name::Shell(s) => self.shells.contains(&s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::euler_operators::Operator;
    use crate::mesh::examples::cube;

    /// The cube, and a lone vertex on a sphere.
    fn sound() -> Boundary {
        let mut boundary = Boundary::try_from(&cube().faces[..]).expect("the cube is closed");
        let (face, outer) = (FaceId(6), LoopId(6));
        let made = boundary.apply(&Operator::Mvfs { shell: ShellId(1), face, outer, vertex: VertexId(8) });
        assert!(made.is_ok() && boundary.defects().is_empty());
        boundary
    }

    /// The defects after something was put wrong.
    fn defects(put_wrong: impl Fn(&mut Boundary)) -> Vec<Defect> {
        let mut boundary = sound();
        put_wrong(&mut boundary);
        boundary.defects()
    }

    fn links(b: &mut Boundary, h: u32) -> &mut Links {
        b.half_edges.get_mut(&HalfEdge(h)).expect("it exists")
    }

    #[test]
    fn what_does_not_exist_is_told() {
        let missing = |name| vec![Defect::Missing(name)];
        assert_eq!(defects(|b| links(b, 0).origin = VertexId(9)), missing(Name::Vertex(VertexId(9))));
        assert_eq!(defects(|b| links(b, 0).loop_ = LoopId(9)), missing(Name::Loop(LoopId(9))));
        assert_eq!(defects(|b| links(b, 0).next = HalfEdge(99)), missing(Name::HalfEdge(HalfEdge(99))));
        assert_eq!(defects(|b| links(b, 0).prev = HalfEdge(99)), missing(Name::HalfEdge(HalfEdge(99))));
        assert_eq!(defects(|b| _ = b.shells.remove(&ShellId(1))), missing(Name::Shell(ShellId(1))));
        assert_eq!(defects(|b| _ = b.faces.remove(&FaceId(6))), missing(Name::Face(FaceId(6))));
        assert_eq!(defects(|b| _ = b.loops.remove(&LoopId(6))), missing(Name::Loop(LoopId(6))));
        assert_eq!(defects(|b| _ = b.vertices.remove(&VertexId(8))), missing(Name::Vertex(VertexId(8))));
        assert!(defects(|b| _ = b.half_edges.remove(&HalfEdge(0))).contains(&Defect::NoMate(HalfEdge(1))));
    }

    #[test]
    fn what_does_not_fit_is_told() {
        let has = |defect: Defect, put_wrong: &dyn Fn(&mut Boundary)| {
            let defects = defects(put_wrong);
            assert!(defects.contains(&defect), "{defect:?} in {defects:?}");
        };
        let next = sound().next(HalfEdge(0)).expect("it exists");
        has(Defect::Links(HalfEdge(0)), &|b| links(b, 0).next = HalfEdge(0));
        has(Defect::Links(HalfEdge(0)), &|b| links(b, next.0).prev = HalfEdge(1));
        let [l, m] = [HalfEdge(0), HalfEdge(1)].map(|h| sound().loop_of(h).expect("it exists"));
        has(Defect::Loop(l), &|b| links(b, 0).loop_ = m);
        has(Defect::Loop(m), &|b| links(b, 0).loop_ = m);
        has(Defect::Loop(l), &|b| _ = b.loops.get_mut(&l).map(|record| record.half_edges.remove(&HalfEdge(0))));
        has(Defect::Loop(l), &|b| _ = b.loops.get_mut(&l).map(|record| record.alone = Some(VertexId(8))));
        has(Defect::Loop(LoopId(6)), &|b| _ = b.loops.get_mut(&LoopId(6)).map(|record| record.alone = None));
        let [v, w] = [HalfEdge(0), HalfEdge(1)].map(|h| sound().origin(h).expect("it exists"));
        has(Defect::Vertex(v), &|b| links(b, 0).origin = w);
        has(Defect::Vertex(w), &|b| links(b, 0).origin = w);
        has(Defect::Vertex(v), &|b| _ = b.vertices.get_mut(&v).map(|record| record.half_edges.remove(&HalfEdge(0))));
        has(Defect::Vertex(v), &|b| _ = b.vertices.get_mut(&v).map(|record| record.alone = Some(l)));
        has(Defect::Vertex(VertexId(8)), &|b| _ = b.vertices.get_mut(&VertexId(8)).map(|record| record.alone = None));
        has(Defect::Face(FaceId(0)), &|b| _ = b.faces.get_mut(&FaceId(0)).map(|record| record.outer = LoopId(1)));
        has(Defect::Face(FaceId(0)), &|b| _ = b.faces.get_mut(&FaceId(0)).map(|record| record.rings.insert(LoopId(0))));
        has(Defect::Face(FaceId(0)), &|b| _ = b.loops.get_mut(&LoopId(1)).map(|record| record.face = FaceId(0)));
        has(Defect::Shell(ShellId(1)), &|b| _ = b.faces.get_mut(&FaceId(0)).map(|record| record.shell = ShellId(1)));
        has(Defect::Shell(ShellId(2)), &|b| _ = b.shells.insert(ShellId(2)));
        let (tracked, counted) = (Counts::default(), sound().counted());
        has(Defect::Counts { tracked, counted }, &|b| b.tracked = Counts::default());
    }

    /// A vertex with two cycles of half-edges: two laminas with one vertex in common.
    #[test]
    fn a_vertex_of_two_cycles_is_told() {
        let faces = [[0u32, 1, 2], [0, 2, 1], [3, 4, 5], [3, 5, 4]].map(Face::from);
        let mut boundary = Boundary::try_from(&faces[..]).expect("two laminas");
        let moved = boundary.vertices.remove(&VertexId(3)).expect("it exists").half_edges;
        for h in &moved {
            links(&mut boundary, h.0).origin = VertexId(0);
        }
        boundary.vertices.entry(VertexId(0)).or_default().half_edges.extend(moved);
        assert!(boundary.defects().contains(&Defect::Vertex(VertexId(0))));
    }
}
