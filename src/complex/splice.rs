//! The three operators that make facet-edge structures: a new pair, and an exchange in rings of faces or of edges.

use super::facet_edge::FacetEdgeStructure;
use super::handle::Handle;
use thiserror::Error;

/// What a splice has done to the two rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Splice {
    /// The rings were distinct and are one now.
    Joined,
    /// They were one ring and are two now.
    Split,
    /// Both arguments are the same handle: everything is as it was.
    Unchanged,
}

/// Why two handles are not spliced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Error)]
pub enum SpliceError {
    /// A handle of a pair that has no record.
    #[error("there is no pair ({0})")]
    NoSuchPair(Handle),
    /// One handle is primal, the other one dual: they are in no rings of one kind.
    #[error("({0}) and ({1}) are in different spaces")]
    Spaces(Handle, Handle),
    /// The ring of `a` has `b` Clock in it: the exchange would turn a part of the ring over, or turn the edge on itself.
    #[error("({0}) and ({1}) are in one ring, walked the other way")]
    Clockwise(Handle, Handle),
    /// The ring of `a` has `b` Spin in it: the exchange would mirror a part of the ring, or fold a face on itself.
    #[error("({0}) and ({1}) are in one ring, with opposite spins")]
    Spins(Handle, Handle),
    /// The ring of `a` has `b` Spin Clock in it: the exchange would glue the edge to itself, tail to head.
    #[error("({0}) and ({1}) are in one ring, with opposite directions of the edge")]
    Directions(Handle, Handle),
}

impl FacetEdgeStructure {
    /// make_facet_edge: a new pair, alone in its rings, a Fnext = a Enext = a. Returned is its base version.
    ///
    /// The space is a 3-sphere of its own with one vertex, one edge, one face and one polyhedron: the lens with one side, its
    /// upper half laid on its lower one.
    #[doc(alias = "CX-24")]
    pub fn make_facet_edge(&mut self) -> Handle {
        let pair = u32::try_from(self.len()).expect("fewer than 2³² pairs");
        let a = Handle::base(pair);
        self.fields_mut().push([a, a.clock(), a.sdual(), a.clock().sdual()]);
        a
    }

    /// splice_facets: exchanges a Fnext and b Fnext. Joins the rings F_a and F_b if they are distinct, cuts their common ring behind
    /// a and behind b if they are one, does nothing if a = b. Its own inverse. No other ring of faces and no ring of edges changes.
    /// Of dual handles the rings are those of the dual: rings of edges of the complex.
    ///
    /// Two pairs with different edges may be spliced in any version. If the edge is the same, a and b have to be directed and
    /// turned alike.
    ///
    /// # Errors
    /// Iff a pair has no record, or the handles are of different spaces, or they have one edge and not the same direction and
    /// spin. Nothing is changed then.
    #[doc(alias = "CX-25")]
    #[doc(alias = "CX-26")]
    #[doc(alias = "CX-28")]
    pub fn splice_facets(&mut self, a: Handle, b: Handle) -> Result<Splice, SpliceError> {
        let effect = self.splice_effect(a, b)?;
        let (after_a, after_b) = (self.fnext(a), self.fnext(b));
        self.link(a, after_b);
        self.link(b, after_a);
        Ok(effect)
    }

    /// splice_edges: splice_facets in the dual space, on a Sdual and b Sdual. Exchanges a Enext and b Enext; joins or splits rings
    /// of edges and touches no ring of faces.
    ///
    /// # Errors
    /// As [`FacetEdgeStructure::splice_facets`]; the handles told of are the dual ones.
    #[doc(alias = "CX-27")]
    pub fn splice_edges(&mut self, a: Handle, b: Handle) -> Result<Splice, SpliceError> {
        self.splice_facets(a.sdual(), b.sdual())
    }

    /// What splice_facets would do.
    fn splice_effect(&self, a: Handle, b: Handle) -> Result<Splice, SpliceError> {
        if let Some(stray) = [a, b].into_iter().find(|h| !self.has(*h)) {
            return Err(SpliceError::NoSuchPair(stray));
        }
        if a.space() != b.space() {
            return Err(SpliceError::Spaces(a, b));
        }
        if a == b {
            return Ok(Splice::Unchanged);
        }
        // No ring has two versions of a pair, so that the first one met is the only one.
        match self.facet_ring(a).into_iter().find(|h| h.pair() == b.pair()) {
            None => Ok(Splice::Joined),
            Some(met) if met == b => Ok(Splice::Split),
            Some(met) if met == b.clock() => Err(SpliceError::Clockwise(a, b)),
            Some(met) if met == b.spin() => Err(SpliceError::Spins(a, b)),
            Some(_) => Err(SpliceError::Directions(a, b)),
        }
    }
}
