//! Algorithm 1 of 000, GlueTetra, on facet-edge structures; and complexes made from it and the three operators alone.

use super::closed_complex::ClosedComplex;
use super::facet_edge::FacetEdgeStructure;
use super::handle::{Handle, Space};
use super::polyhedron::PolyhedronFlaw;
use super::scheme::{GluingScheme, Pairing, Polyhedron, SchemeDefect};
use super::splice::SpliceError;
use std::collections::BTreeSet;
use thiserror::Error;

/// Why two faces are not glued.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Error)]
pub enum GlueError {
    /// A handle of a pair that has no record.
    #[error("there is no pair ({0})")]
    NoSuchPair(Handle),
    /// The faces have different numbers of sides.
    #[error("a face of {a} sides is not glued to one of {b}")]
    Sizes {
        /// The sides of the face of `a`.
        a: usize,
        /// The sides of the face of `b`.
        b: usize,
    },
    /// Both handles are of one face.
    #[error("({0}) and ({1}) are of one face")]
    SameFace(Handle, Handle),
    /// The sides have one edge already, but something lies between the two faces there.
    #[error("({1}) is in the ring of ({0}) and not next to it")]
    NotNext(Handle, Handle),
    /// The triangle that a handle turns into is glued already.
    #[error("the triangle before ({0}) is glued already")]
    AlreadyGlued(Handle),
    /// The rings of two sides cannot be spliced.
    #[error(transparent)]
    Splice(#[from] SpliceError),
}

impl FacetEdgeStructure {
    /// GlueTetra (a, b = a Fnext): lays the face of a on that of b, side a Enextⁱ on side b Enextⁱ. The polyhedron that a turns into
    /// and the one that b comes from are to be outside of what is glued.
    ///
    /// At each side: if the rings are distinct, b is put behind a, then a is taken out of the ring. The face of b is left between the
    /// polyhedra behind a and before b; that of a is left over, each side alone in its ring, as a 3-sphere of its own.
    ///
    /// # Errors
    /// Iff a pair has no record, the faces are one or differ in their numbers of sides, or two sides that are to be one edge are in
    /// one ring otherwise than as a and a Fnext: the edge would be glued to itself, or there is something in between. Nothing is
    /// changed then.
    #[doc(alias = "CX-30")]
    #[doc(alias = "CX-31")]
    #[doc(alias = "CX-32")]
    pub fn glue_tetra(&mut self, a: Handle, b: Handle) -> Result<(), GlueError> {
        if let Some(stray) = [a, b].into_iter().find(|h| !self.has(*h)) {
            return Err(GlueError::NoSuchPair(stray));
        }
        if a.space() != b.space() {
            return Err(SpliceError::Spaces(a, b).into());
        }
        let [sides_a, sides_b] = [a, b].map(|h| self.edge_ring(h));
        if sides_a.iter().any(|h| h.pair() == b.pair()) {
            return Err(GlueError::SameFace(a, b));
        }
        if sides_a.len() != sides_b.len() {
            return Err(GlueError::Sizes { a: sides_a.len(), b: sides_b.len() });
        }
        let mut done = Vec::new();
        let glued = self.glue_sides(a, b, &mut done);
        if glued.is_err() {
            // Each splice is its own inverse.
            for (a, b) in done.into_iter().rev() {
                self.splice_facets(a, b).expect("what was spliced can be spliced back");
            }
        }
        glued
    }

    /// The lines of the algorithm, by their numbers, with a list of the splices.
    fn glue_sides(&mut self, a: Handle, b: Handle, done: &mut Vec<(Handle, Handle)>) -> Result<(), GlueError> {
        let (mut a, mut b) = (a, b);
        // 1
        let first_a = a;
        // 2
        loop {
            match self.facet_ring(a).contains(&b) {
                // 2:1
                false => {
                    let before_b = self.fprev(b);
                    self.splice_facets(a, before_b)?;
                    done.push((a, before_b));
                }
                true if self.fnext(a) == b => {}
                true => return Err(GlueError::NotNext(a, b)),
            }
            // 2:2
            let before_a = self.fprev(a);
            self.splice_facets(a, before_a)?;
            done.push((a, before_a));
            // 2:3, 2:4, 3
            (a, b) = (self.enext(a), self.enext(b));
            if a == first_a {
                return Ok(());
            }
        }
    }

    /// A polyhedron in a 3-sphere of its own, made by the three operators: its faces and edges, what is inside and what is
    /// outside. Returned are handles by face, then by side, directed as the face is walked and turned to the outside.
    ///
    /// # Errors
    /// The first flaw, iff the faces do not make a sphere. Nothing is added then.
    pub fn add_polyhedron(&mut self, polyhedron: &Polyhedron) -> Result<Vec<Vec<Handle>>, PolyhedronFlaw> {
        if let Some(flaw) = polyhedron.flaw() {
            return Err(flaw);
        }
        let mut other_use: Vec<Option<Handle>> = vec![None; polyhedron.edges.len()];
        let mut faces = Vec::new();
        for face in &polyhedron.faces {
            let sides: Vec<Handle> = face.iter().map(|_| self.make_facet_edge()).collect();
            for ends in sides.windows(2) {
                self.splice_edges(ends[0], ends[1]).expect("two pairs without a common ring");
            }
            for (signed, side) in face.iter().zip(&sides) {
                match other_use[signed.index().expect("an edge")].replace(*side) {
                    None => {}
                    // The other face walks along the edge the other way: from the outside one comes to it from behind.
                    Some(other) => {
                        self.splice_facets(*side, other.clock()).expect("two sides without a common ring");
                    }
                }
            }
            faces.push(sides);
        }
        Ok(faces)
    }

    /// The complex of a scheme, made by the three operators: each polyhedron by itself, then each pairing by
    /// [`FacetEdgeStructure::glue_tetra`]. What is left over of the faces is not in it.
    ///
    /// # Errors
    /// Iff the scheme has a defect by itself or an edge is glued to itself, tail to head.
    #[doc(alias = "CX-33")]
    pub fn glued(scheme: &GluingScheme) -> Result<FacetEdgeStructure, AssemblyError> {
        let defects = scheme.defects();
        if !defects.is_empty() {
            return Err(AssemblyError::Scheme(defects));
        }
        let mut structure = FacetEdgeStructure::default();
        let mut faces = Vec::new();
        for polyhedron in &scheme.polyhedra {
            faces.push(structure.add_polyhedron(polyhedron).expect("the scheme has no defect"));
        }
        let mut left_over = BTreeSet::new();
        for (pairing, Pairing { a, b, shift, dir }) in scheme.pairings.iter().enumerate() {
            let [a, b] = [a, b].map(|id| &faces[id.polyhedron][id.face]);
            let n = b.len() as i64;
            // Side 0 runs from corner 0 to corner 1, which go to corners `shift` and `shift` + `dir`.
            let onto = match dir {
                1 => b[shift.rem_euclid(n) as usize].spin(),
                _ => b[(shift - 1).rem_euclid(n) as usize].clock(),
            };
            structure.glue_tetra(a[0], onto).map_err(|reason| AssemblyError::Pairing { pairing, reason })?;
            left_over.extend(a.iter().map(|h| h.pair()));
        }
        Ok(structure.without(&left_over))
    }

    /// The topological tetrahedra of the complex, each made by itself and glued by [`FacetEdgeStructure::glue_tetra`], primal and
    /// dual: 6t pairs for t. What is left over of the triangles is not in it.
    pub fn glued_tetrahedra(&self) -> FacetEdgeStructure {
        let mut separate = SeparateTetrahedra::of(self);
        for a in self.gluings() {
            separate.glue(a, self.fnext(a)).expect("no edge and no face of a sound structure is glued to itself");
        }
        separate.without_left_over()
    }

    /// One handle a for each gluing of a with b = a Fnext: of the t in the primal space and the t in the dual space. A gluing has four,
    /// a, a Spin Clock, b Clock and b Spin, of which the first stands.
    #[doc(alias = "CX-34")]
    pub fn gluings(&self) -> Vec<Handle> {
        let handles = [Space::Primal, Space::Dual].into_iter().flat_map(|space| self.handles(space));
        let is_first = |a: &Handle| {
            let b = self.fnext(*a);
            [a.flip(), b.clock(), b.spin()].into_iter().all(|other| *a <= other)
        };
        handles.filter(is_first).collect()
    }

    /// What is left when these pairs are taken out.
    fn without(&self, pairs: &BTreeSet<u32>) -> FacetEdgeStructure {
        let kept: Vec<u32> = (0..self.len() as u32).filter(|pair| !pairs.contains(pair)).collect();
        self.part(&kept).expect("the pairs of a face that is left over have no others in their rings")
    }
}

/// Why a scheme makes no facet-edge structure.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum AssemblyError {
    /// The scheme has defects by itself.
    #[error("the scheme has {} defects", .0.len())]
    Scheme(Vec<SchemeDefect>),
    /// A pairing cannot be made: an edge would be glued to itself.
    #[error("pairing {pairing}: {reason}")]
    Pairing {
        /// The pairing.
        pairing: usize,
        /// Why not.
        reason: GlueError,
    },
}

/// The topological tetrahedra of a structure's pairs, in one structure, some of them glued: corners 0 and 1 are the ends of the pair's
/// edge, 2 and 3 the polyhedra that its base turns into and comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeparateTetrahedra {
    structure: FacetEdgeStructure,
    /// The triangles that are glued, by pair and corner.
    glued: BTreeSet<(u32, usize)>,
    left_over: BTreeSet<u32>,
    /// By pair, by triangle, by side.
    sides: Vec<Vec<Vec<Handle>>>,
}

impl SeparateTetrahedra {
    /// A tetrahedron for each pair, none glued.
    pub fn of(pairs: &FacetEdgeStructure) -> SeparateTetrahedra {
        let mut structure = FacetEdgeStructure::default();
        let tetrahedron = Polyhedron::tetrahedron();
        let mut add = |_| structure.add_polyhedron(&tetrahedron).expect("a tetrahedron is a ball");
        let sides = (0..pairs.len()).map(&mut add).collect();
        SeparateTetrahedra { structure, glued: BTreeSet::new(), left_over: BTreeSet::new(), sides }
    }

    /// Triangles and edges of all of them, glued or not, and the triangles that are left over.
    pub fn structure(&self) -> &FacetEdgeStructure {
        &self.structure
    }

    /// The pairs of the triangles that gluings have left over.
    pub fn left_over(&self) -> &BTreeSet<u32> {
        &self.left_over
    }

    /// Glues the tetrahedra of a and b = a Fnext: the triangle of a's edge and the polyhedron that a turns into on the triangle of b's
    /// edge and the polyhedron that b comes from. For dual handles edges are dual ones, and vertices stand for polyhedra. Where
    /// a = b the tetrahedron is glued to itself.
    ///
    /// # Errors
    /// Iff one of the triangles is glued already, or as [`FacetEdgeStructure::glue_tetra`].
    ///
    /// # Panics
    /// If a or b is no pair of the structure that the tetrahedra are of.
    #[doc(alias = "CX-35")]
    pub fn glue(&mut self, a: Handle, b: Handle) -> Result<(), GlueError> {
        // Triangle i lies opposite corner i.
        let triangles = [a, b.spin()].map(|h| (h, (h.pair(), corners(h)[3])));
        if let Some((h, _)) = triangles.iter().find(|(_, triangle)| self.glued.contains(triangle)) {
            return Err(GlueError::AlreadyGlued(*h));
        }
        let [side_a, side_b] = [self.ahead(a), self.ahead(b.spin()).spin()];
        let triangle = self.structure.edge_ring(side_a);
        self.structure.glue_tetra(side_a, side_b)?;
        self.left_over.extend(triangle.iter().map(|h| h.pair()));
        self.glued.extend(triangles.map(|(_, triangle)| triangle));
        Ok(())
    }

    /// The tetrahedra without the triangles that are left over.
    pub fn without_left_over(&self) -> FacetEdgeStructure {
        self.structure.without(&self.left_over)
    }

    /// In the tetrahedron of a: its edge in the triangle with the polyhedron that it turns into, turned to the outside.
    pub fn ahead(&self, a: Handle) -> Handle {
        let [tail, head, ahead, behind] = corners(a);
        let polyhedron = Polyhedron::tetrahedron();
        let sides = polyhedron.faces[behind].iter().zip(&self.sides[a.pair() as usize][behind]);
        for (signed, side) in sides {
            let [from, to] = polyhedron.ends(*signed).expect("a side of the tetrahedron").map(|end| end as usize);
            if [from, to] == [tail, head] {
                return *side;
            }
            if [from, to] == [head, tail] {
                return side.flip();
            }
        }
        unreachable!("triangle {behind} has the corners {tail}, {head} and {ahead}")
    }
}

/// The corners of the pair's tetrahedron at a handle's tail and head, at what it turns into and what it comes from.
pub fn corners(a: Handle) -> [usize; 4] {
    let primal = match a.space() {
        Space::Primal => a,
        Space::Dual => a.sdual(),
    };
    let (reversed, counter) = (usize::from(primal.is_reversed()), usize::from(primal.is_counter()));
    let [tail, head, ahead, behind] = [reversed, 1 - reversed, 2 + counter, 3 - counter];
    match a.space() {
        Space::Primal => [tail, head, ahead, behind],
        // The dual edge runs as the spin turns, and the dual spin turns to the head of the edge.
        Space::Dual => [behind, ahead, head, tail],
    }
}

impl ClosedComplex {
    /// The topological tetrahedra glued as 000, section 5.2, has it: [`FacetEdgeStructure::glued_tetrahedra`].
    #[doc(alias = "CX-41")]
    pub fn glued_tetrahedra(&self) -> FacetEdgeStructure {
        FacetEdgeStructure::of(self).glued_tetrahedra()
    }
}
