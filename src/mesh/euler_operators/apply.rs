//! The operators at work. Each checks all its preconditions before it changes anything.

use super::boundary::{Boundary, FaceRecord, Links, LoopRecord, VertexRecord};
use super::names::{FaceId, HalfEdge, LoopId, Name, ShellId, VertexId};
use super::{Corner, Operator, Refused, Span};
use std::collections::BTreeSet;
use std::mem;

/// For what a checked precondition promises.
const CHECKED: &str = "checked before anything is changed";

impl Boundary {
    /// Applies an operator, and returns the one that undoes it: applied in turn it restores this boundary, to the names,
    /// and returns the first one. It takes the time to walk along the loops and around the vertices that it names, and
    /// kvfs, mfkrh, ksfmr and msfkr that to walk over all faces.
    ///
    /// # Errors
    /// Iff a precondition is not met; the boundary is as it was.
    #[doc(alias = "ME-109")]
    pub fn apply(&mut self, operator: &Operator) -> Result<Operator, Refused> {
        let inverse = match operator {
            Operator::Mvfs { shell, face, outer, vertex } => self.mvfs(*shell, *face, *outer, *vertex),
            Operator::Kvfs { shell } => self.kvfs(*shell),
            Operator::Mev { span, half_edge, vertex } => self.mev(*span, *half_edge, *vertex),
            Operator::Kev { half_edge } => self.kev(*half_edge),
            Operator::Mef { span, half_edge, outer, face, rings } => self.mef(*span, *half_edge, *outer, *face, rings),
            Operator::Kef { half_edge } => self.kef(*half_edge),
            Operator::Kemr { half_edge, ring } => self.kemr(*half_edge, *ring),
            Operator::Mekr { from, to, half_edge } => self.mekr(*from, *to, *half_edge),
            Operator::Kfmrh { face, into } => self.kfmrh(*face, *into),
            Operator::Mfkrh { ring, face } => self.mfkrh(*ring, *face),
            Operator::Ksfmr { face, into } => self.ksfmr(*face, *into),
            Operator::Msfkr { ring, face, shell } => self.msfkr(*ring, *face, *shell),
        }?;
        self.tracked = self.tracked + operator.change();
        Ok(inverse)
    }

    fn mvfs(&mut self, shell: ShellId, face: FaceId, outer: LoopId, vertex: VertexId) -> Result<Operator, Refused> {
        for name in [Name::Shell(shell), Name::Face(face), Name::Loop(outer), Name::Vertex(vertex)] {
            self.free(name)?;
        }
        self.shells.insert(shell);
        self.faces.insert(face, FaceRecord { shell, outer, rings: BTreeSet::new() });
        self.loops.insert(outer, LoopRecord { face, half_edges: BTreeSet::new(), alone: Some(vertex) });
        self.vertices.insert(vertex, VertexRecord { half_edges: BTreeSet::new(), alone: Some(outer) });
        Ok(Operator::Kvfs { shell })
    }

    fn kvfs(&mut self, shell: ShellId) -> Result<Operator, Refused> {
        self.there(Name::Shell(shell))?;
        let mut faces = self.faces.iter().filter(|(_, record)| record.shell == shell);
        let (Some((&face, record)), None) = (faces.next(), faces.next()) else {
            return Err(Refused::NotASingleVertex(shell));
        };
        let outer = record.outer;
        let (Some(vertex), true) = (self.alone(outer), record.rings.is_empty()) else {
            return Err(Refused::NotASingleVertex(shell));
        };
        self.shells.remove(&shell);
        self.faces.remove(&face);
        self.loops.remove(&outer);
        self.vertices.remove(&vertex);
        Ok(Operator::Mvfs { shell, face, outer, vertex })
    }

    fn mev(&mut self, span: Span, x: HalfEdge, w: VertexId) -> Result<Operator, Refused> {
        let y = x.mate();
        let (v, at_x, at_y) = match span {
            Span::NothingAt(corner) => self.corner(corner).map(|(v, l)| (v, l, l))?,
            Span::AllFrom(a) => self.corner(Corner::Before(a)).map(|(v, l)| (v, l, l))?,
            Span::Between(a, b) if a == b => return Err(Refused::EmptySpan(a)),
            Span::Between(a, b) => {
                let ((v, at_a), (w, at_b)) = (self.corner(Corner::Before(a))?, self.corner(Corner::Before(b))?);
                if v != w {
                    return Err(Refused::TwoVertices(a, b));
                }
                (v, at_a, at_b)
            }
        };
        self.free(Name::HalfEdge(x))?;
        self.free(Name::Vertex(w))?;
        let moved: Vec<HalfEdge> = match span {
            Span::NothingAt(_) => Vec::new(),
            Span::AllFrom(a) => self.around(a),
            Span::Between(a, b) => self.around(a).into_iter().take_while(|h| *h != b).collect(),
        };
        self.vertices.insert(w, VertexRecord::default());
        moved.into_iter().for_each(|h| self.begin_at(h, w));
        self.insert(x, v, at_x);
        self.insert(y, w, at_y);
        match span {
            Span::NothingAt(Corner::Alone(_)) => self.link(&[x, y, x]),
            Span::NothingAt(Corner::Before(a)) => self.link(&[self.before(a), x, y, a]),
            Span::AllFrom(a) => self.link(&[self.before(a), y, x, a]),
            Span::Between(a, b) => {
                self.link(&[self.before(a), x, a]);
                self.link(&[self.before(b), y, b]);
            }
        }
        Ok(Operator::Kev { half_edge: x })
    }

    fn kev(&mut self, x: HalfEdge) -> Result<Operator, Refused> {
        let y = x.mate();
        let ((v, l), (w, _)) = (self.corner(Corner::Before(x))?, self.corner(Corner::Before(y))?);
        if v == w {
            return Err(Refused::ClosedEdge(x));
        }
        let (after_x, after_y) = (self.after(x), self.after(y));
        let span = match (after_x == y, after_y == x) {
            (true, true) => Span::NothingAt(Corner::Alone(v)),
            (true, false) => Span::NothingAt(Corner::Before(after_y)),
            (false, true) => Span::AllFrom(after_x),
            (false, false) => Span::Between(after_x, after_y),
        };
        for h in [x, y] {
            self.link(&[self.before(h), self.after(h)]);
            self.remove(h);
        }
        if (after_x, after_y) == (y, x) {
            self.leave_alone(v, l);
        }
        let killed = self.vertices.remove(&w).expect(CHECKED);
        killed.half_edges.into_iter().for_each(|h| self.begin_at(h, v));
        Ok(Operator::Mev { span, half_edge: x, vertex: w })
    }

    fn mef(
        &mut self,
        span: Span,
        x: HalfEdge,
        outer: LoopId,
        face: FaceId,
        rings: &BTreeSet<LoopId>,
    ) -> Result<Operator, Refused> {
        let y = x.mate();
        let (v, w, l) = match span {
            Span::NothingAt(corner) => self.corner(corner).map(|(v, l)| (v, v, l))?,
            Span::AllFrom(a) => self.corner(Corner::Before(a)).map(|(v, l)| (v, v, l))?,
            Span::Between(a, b) if a == b => return Err(Refused::EmptySpan(a)),
            Span::Between(a, b) => {
                let ((v, l), (w, m)) = (self.corner(Corner::Before(a))?, self.corner(Corner::Before(b))?);
                if l != m {
                    return Err(Refused::TwoLoops(a, b));
                }
                (v, w, l)
            }
        };
        for name in [Name::HalfEdge(x), Name::Loop(outer), Name::Face(face)] {
            self.free(name)?;
        }
        let old = self.loops[&l].face;
        if let Some(&ring) = rings.iter().find(|&ring| *ring == l || !self.faces[&old].rings.contains(ring)) {
            return Err(Refused::NotToMove(ring));
        }
        let moved: Vec<HalfEdge> = match span {
            Span::NothingAt(_) => Vec::new(),
            Span::AllFrom(a) => self.orbit(a, |h| self.next(h)),
            Span::Between(a, b) => self.orbit(a, |h| self.next(h)).into_iter().take_while(|h| *h != b).collect(),
        };
        let shell = self.faces[&old].shell;
        self.faces.insert(face, FaceRecord { shell, outer, rings: BTreeSet::new() });
        self.loops.insert(outer, LoopRecord { face, half_edges: BTreeSet::new(), alone: None });
        rings.iter().for_each(|ring| self.move_ring(*ring, face));
        moved.into_iter().for_each(|h| self.run_in(h, outer));
        self.insert(x, v, l);
        self.insert(y, w, outer);
        match span {
            Span::NothingAt(Corner::Alone(_)) => {
                self.link(&[x, x]);
                self.link(&[y, y]);
            }
            Span::NothingAt(Corner::Before(a)) => {
                self.link(&[self.before(a), x, a]);
                self.link(&[y, y]);
            }
            Span::AllFrom(a) => {
                self.link(&[self.before(a), y, a]);
                self.link(&[x, x]);
            }
            Span::Between(a, b) => {
                let (before_a, before_b) = (self.before(a), self.before(b));
                self.link(&[before_a, x, b]);
                self.link(&[before_b, y, a]);
            }
        }
        Ok(Operator::Kef { half_edge: y })
    }

    fn kef(&mut self, y: HalfEdge) -> Result<Operator, Refused> {
        let x = y.mate();
        let ((v, l), (_, killed)) = (self.corner(Corner::Before(x))?, self.corner(Corner::Before(y))?);
        let (stays, face) = (self.loops[&l].face, self.loops[&killed].face);
        if stays == face {
            return Err(Refused::OneFace(face));
        }
        if self.faces[&face].outer != killed {
            return Err(Refused::IsRing(killed));
        }
        let (after_x, after_y) = (self.after(x), self.after(y));
        let (before_x, before_y) = (self.before(x), self.before(y));
        let span = match (after_x == x, after_y == y) {
            (true, true) => Span::NothingAt(Corner::Alone(v)),
            (false, true) => Span::NothingAt(Corner::Before(after_x)),
            (true, false) => Span::AllFrom(after_y),
            (false, false) => Span::Between(after_y, after_x),
        };
        self.remove(x);
        self.remove(y);
        match span {
            Span::NothingAt(Corner::Alone(_)) => self.leave_alone(v, l),
            Span::NothingAt(Corner::Before(_)) => self.link(&[before_x, after_x]),
            Span::AllFrom(_) => self.link(&[before_y, after_y]),
            Span::Between(..) => {
                self.link(&[before_x, after_y]);
                self.link(&[before_y, after_x]);
            }
        }
        let half_edges = mem::take(&mut self.loop_mut(killed).half_edges);
        half_edges.into_iter().for_each(|h| self.run_in(h, l));
        let rings = self.faces[&face].rings.clone();
        rings.iter().for_each(|ring| self.move_ring(*ring, stays));
        self.loops.remove(&killed);
        self.faces.remove(&face);
        Ok(Operator::Mef { span, half_edge: x, outer: killed, face, rings })
    }

    fn kemr(&mut self, x: HalfEdge, ring: LoopId) -> Result<Operator, Refused> {
        let y = x.mate();
        let ((v, l), (w, m)) = (self.corner(Corner::Before(x))?, self.corner(Corner::Before(y))?);
        if l != m {
            return Err(Refused::TwoLoops(x, y));
        }
        self.free(Name::Loop(ring))?;
        let (after_x, after_y, before_x, before_y) = (self.after(x), self.after(y), self.before(x), self.before(y));
        let moved: Vec<HalfEdge> = self.orbit(after_x, |h| self.next(h)).into_iter().take_while(|h| *h != y).collect();
        let face = self.loops[&l].face;
        self.loops.insert(ring, LoopRecord { face, half_edges: BTreeSet::new(), alone: None });
        self.faces.get_mut(&face).expect(CHECKED).rings.insert(ring);
        moved.into_iter().for_each(|h| self.run_in(h, ring));
        self.remove(x);
        self.remove(y);
        let to = if after_x == y { Corner::Alone(w) } else { Corner::Before(after_x) };
        let from = if after_y == x { Corner::Alone(v) } else { Corner::Before(after_y) };
        match to {
            Corner::Alone(_) => self.leave_alone(w, ring),
            Corner::Before(_) => self.link(&[before_y, after_x]),
        }
        match from {
            Corner::Alone(_) => self.leave_alone(v, l),
            Corner::Before(_) => self.link(&[before_x, after_y]),
        }
        Ok(Operator::Mekr { from, to, half_edge: x })
    }

    fn mekr(&mut self, from: Corner, to: Corner, x: HalfEdge) -> Result<Operator, Refused> {
        let y = x.mate();
        let ((v, l), (w, ring)) = (self.corner(from)?, self.corner(to)?);
        if l == ring {
            return Err(Refused::OneLoop(l));
        }
        let face = self.loops[&l].face;
        if face != self.loops[&ring].face {
            return Err(Refused::TwoFaces(l, ring));
        }
        if self.faces[&face].outer == ring {
            return Err(Refused::IsOuter(ring));
        }
        self.free(Name::HalfEdge(x))?;
        // Around a lone vertex, the new edge follows itself.
        let ends = |corner: Corner, lone: [HalfEdge; 2]| match corner {
            Corner::Before(h) => [self.before(h), h],
            Corner::Alone(_) => lone,
        };
        let ([before_from, after_y], [before_to, after_x]) = (ends(from, [y, x]), ends(to, [x, y]));
        let half_edges = mem::take(&mut self.loop_mut(ring).half_edges);
        half_edges.into_iter().for_each(|h| self.run_in(h, l));
        self.loops.remove(&ring);
        self.faces.get_mut(&face).expect(CHECKED).rings.remove(&ring);
        self.insert(x, v, l);
        self.insert(y, w, l);
        self.link(&[before_from, x, after_x]);
        self.link(&[before_to, y, after_y]);
        Ok(Operator::Kemr { half_edge: x, ring })
    }

    fn kfmrh(&mut self, face: FaceId, into: FaceId) -> Result<Operator, Refused> {
        let [killed, other] = self.two_faces(face, into)?;
        if killed != other {
            return Err(Refused::TwoShells(killed, other));
        }
        Ok(Operator::Mfkrh { ring: self.face_to_ring(face, into), face })
    }

    fn mfkrh(&mut self, ring: LoopId, face: FaceId) -> Result<Operator, Refused> {
        let into = self.face_with_ring(ring)?;
        self.free(Name::Face(face))?;
        if self.divided_by(ring).is_some() {
            return Err(Refused::Divides(ring));
        }
        self.ring_to_face(ring, face, self.faces[&into].shell);
        Ok(Operator::Kfmrh { face, into })
    }

    fn ksfmr(&mut self, face: FaceId, into: FaceId) -> Result<Operator, Refused> {
        let [shell, other] = self.two_faces(face, into)?;
        if shell == other {
            return Err(Refused::OneShell(shell));
        }
        self.faces.values_mut().filter(|record| record.shell == shell).for_each(|record| record.shell = other);
        self.shells.remove(&shell);
        Ok(Operator::Msfkr { ring: self.face_to_ring(face, into), face, shell })
    }

    fn msfkr(&mut self, ring: LoopId, face: FaceId, shell: ShellId) -> Result<Operator, Refused> {
        let into = self.face_with_ring(ring)?;
        self.free(Name::Face(face))?;
        self.free(Name::Shell(shell))?;
        let part = self.divided_by(ring).ok_or(Refused::DoesNotDivide(ring))?;
        for f in part {
            self.faces.get_mut(&f).expect(CHECKED).shell = shell;
        }
        self.shells.insert(shell);
        self.ring_to_face(ring, face, shell);
        Ok(Operator::Ksfmr { face, into })
    }
}

/// Preconditions.
impl Boundary {
    fn there(&self, name: Name) -> Result<(), Refused> {
        if self.has(name) { Ok(()) } else { Err(Refused::NoSuch(name)) }
    }

    /// A new half-edge brings its mate, and half-edges exist in pairs.
    fn free(&self, name: Name) -> Result<(), Refused> {
        if self.has(name) { Err(Refused::Taken(name)) } else { Ok(()) }
    }

    /// The vertex and the loop of a corner.
    fn corner(&self, corner: Corner) -> Result<(VertexId, LoopId), Refused> {
        match corner {
            Corner::Before(h) => {
                let links = self.half_edges.get(&h).ok_or(Refused::NoSuch(Name::HalfEdge(h)))?;
                Ok((links.origin, links.loop_))
            }
            Corner::Alone(v) => {
                let vertex = self.vertices.get(&v).ok_or(Refused::NoSuch(Name::Vertex(v)))?;
                vertex.alone.map(|l| (v, l)).ok_or(Refused::NotAlone(v))
            }
        }
    }

    /// The shells of a face without rings, and of another.
    fn two_faces(&self, face: FaceId, into: FaceId) -> Result<[ShellId; 2], Refused> {
        self.there(Name::Face(face))?;
        self.there(Name::Face(into))?;
        if face == into {
            return Err(Refused::OneFace(face));
        }
        if !self.faces[&face].rings.is_empty() {
            return Err(Refused::HasRings(face));
        }
        Ok([self.faces[&face].shell, self.faces[&into].shell])
    }

    fn face_with_ring(&self, ring: LoopId) -> Result<FaceId, Refused> {
        let face = self.face_of(ring).ok_or(Refused::NoSuch(Name::Loop(ring)))?;
        if self.faces[&face].outer == ring { Err(Refused::IsOuter(ring)) } else { Ok(face) }
    }

    /// The faces that would hang together with a ring that were a face of its own, where the ring's face would not.
    fn divided_by(&self, ring: LoopId) -> Option<BTreeSet<FaceId>> {
        let from = self.loops[&ring].face;
        let mut part = BTreeSet::new();
        let mut pending = vec![ring];
        while let Some(l) = pending.pop() {
            for h in &self.loops[&l].half_edges {
                let beyond = self.half_edges[&h.mate()].loop_;
                let face = self.loops[&beyond].face;
                if beyond == ring {
                    continue;
                }
                if face == from {
                    return None;
                }
                if part.insert(face) {
                    pending.push(self.faces[&face].outer);
                    pending.extend(&self.faces[&face].rings);
                }
            }
        }
        Some(part)
    }
}

/// Steps whose preconditions are checked.
impl Boundary {
    fn after(&self, h: HalfEdge) -> HalfEdge {
        self.half_edges[&h].next
    }

    fn before(&self, h: HalfEdge) -> HalfEdge {
        self.half_edges[&h].prev
    }

    fn loop_mut(&mut self, l: LoopId) -> &mut LoopRecord {
        self.loops.get_mut(&l).expect(CHECKED)
    }

    fn vertex_mut(&mut self, v: VertexId) -> &mut VertexRecord {
        self.vertices.get_mut(&v).expect(CHECKED)
    }

    fn links_mut(&mut self, h: HalfEdge) -> &mut Links {
        self.half_edges.get_mut(&h).expect(CHECKED)
    }

    /// Makes each of the half-edges the next of the one before it.
    fn link(&mut self, chain: &[HalfEdge]) {
        for pair in chain.windows(2) {
            self.links_mut(pair[0]).next = pair[1];
            self.links_mut(pair[1]).prev = pair[0];
        }
    }

    /// Adds a half-edge that is not linked yet; its vertex and its loop have an edge from now on.
    fn insert(&mut self, h: HalfEdge, origin: VertexId, loop_: LoopId) {
        self.half_edges.insert(h, Links { origin, loop_, next: h, prev: h });
        let vertex = self.vertex_mut(origin);
        vertex.half_edges.insert(h);
        vertex.alone = None;
        let record = self.loop_mut(loop_);
        record.half_edges.insert(h);
        record.alone = None;
    }

    fn remove(&mut self, h: HalfEdge) {
        let Links { origin, loop_, .. } = self.half_edges.remove(&h).expect(CHECKED);
        self.vertex_mut(origin).half_edges.remove(&h);
        self.loop_mut(loop_).half_edges.remove(&h);
    }

    /// Makes a vertex all that a loop has.
    fn leave_alone(&mut self, v: VertexId, l: LoopId) {
        self.vertex_mut(v).alone = Some(l);
        self.loop_mut(l).alone = Some(v);
    }

    fn begin_at(&mut self, h: HalfEdge, v: VertexId) {
        let old = mem::replace(&mut self.links_mut(h).origin, v);
        if let Some(record) = self.vertices.get_mut(&old) {
            record.half_edges.remove(&h);
        }
        self.vertex_mut(v).half_edges.insert(h);
    }

    fn run_in(&mut self, h: HalfEdge, l: LoopId) {
        let old = mem::replace(&mut self.links_mut(h).loop_, l);
        self.loop_mut(old).half_edges.remove(&h);
        self.loop_mut(l).half_edges.insert(h);
    }

    /// Makes a loop a ring of that face; it was a ring of another.
    fn move_ring(&mut self, ring: LoopId, face: FaceId) {
        let old = mem::replace(&mut self.loop_mut(ring).face, face);
        self.faces.get_mut(&old).expect(CHECKED).rings.remove(&ring);
        self.faces.get_mut(&face).expect(CHECKED).rings.insert(ring);
    }

    /// Kills a face whose only loop becomes a ring of another, and returns that loop.
    fn face_to_ring(&mut self, face: FaceId, into: FaceId) -> LoopId {
        let ring = self.faces.remove(&face).expect(CHECKED).outer;
        self.loop_mut(ring).face = into;
        self.faces.get_mut(&into).expect(CHECKED).rings.insert(ring);
        ring
    }

    fn ring_to_face(&mut self, ring: LoopId, face: FaceId, shell: ShellId) {
        let old = mem::replace(&mut self.loop_mut(ring).face, face);
        self.faces.get_mut(&old).expect(CHECKED).rings.remove(&ring);
        self.faces.insert(face, FaceRecord { shell, outer: ring, rings: BTreeSet::new() });
    }
}
