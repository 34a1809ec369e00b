//! Directions and spins for all pairs at once: orientability, and what directions the edges of topological tetrahedra get.

use super::facet_edge::FacetEdgeStructure;
use super::handle::{Handle, Space};

/// A direction of the edge of a topological tetrahedron between a vertex and the middle of a polyhedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Towards {
    /// From the polyhedron's middle to the vertex.
    Vertex,
    /// From the vertex to the polyhedron's middle.
    Polyhedron,
}

/// What the two triangles at such an edge say of its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EdgeSense {
    /// Both the same.
    Defined(Towards),
    /// One one way, the other the other way.
    Ambiguous,
}

/// The sense of the edge between the tail of h and the polyhedron that h turns into, in the tetrahedron of its pair, whose edge is
/// directed and whose dual edge is crossed as `chosen` says.
///
/// The edge e gives its direction to the two triangles that have it: tail, head, middle. So does the dual edge f′, directed as the spin
/// turns, to its two triangles. h is defined iff it is `chosen` or `chosen` Clock.
///
/// # Panics
/// If the handles are not primal ones of one pair.
#[doc(alias = "CX-36")]
pub fn edge_sense(chosen: Handle, h: Handle) -> EdgeSense {
    assert!(
        chosen.pair() == h.pair() && [chosen, h].iter().all(|a| a.space() == Space::Primal),
        "versions of one pair"
    );
    // From the middle to the tail of e, from the head of e to the middle.
    let by_edge = if h.is_reversed() == chosen.is_reversed() { Towards::Vertex } else { Towards::Polyhedron };
    // From the polyhedron ahead to the vertex, from the vertex to the polyhedron behind.
    let by_dual_edge = if h.is_counter() == chosen.is_counter() { Towards::Vertex } else { Towards::Polyhedron };
    if by_edge == by_dual_edge { EdgeSense::Defined(by_edge) } else { EdgeSense::Ambiguous }
}

impl FacetEdgeStructure {
    /// The orbit of each primal handle under Enext, Fnext and Clock, and how many there are: two for each orientable component,
    /// which Spin exchanges, one for each other one.
    #[doc(alias = "CX-23")]
    pub fn sense_orbits(&self) -> (Vec<u32>, usize) {
        self.orbits(&[&|h| self.enext(h), &|h| self.fnext(h), &|h| h.clock()])
    }

    /// Whether each component is orientable: no walk of Enext, Fnext, Clock leads to the other spin.
    pub fn is_orientable(&self) -> bool {
        let (orbit_of, _) = self.sense_orbits();
        (0..self.len() as u32).map(Handle::base).all(|a| orbit_of[self.index(a)] != orbit_of[self.index(a.spin())])
    }

    /// A handle for each pair: its edge as a scheme directs it, which is as the first pair of the edge has it, or against that where
    /// `against` is true for the edge's number; and the spin anticlockwise, that is of one orbit of Enext, Fnext and Clock, that of
    /// the component's first base. Edges that `against` leaves out are not turned. `None` iff the structure is not orientable.
    pub fn anticlockwise(&self, against: &[bool]) -> Option<Vec<Handle>> {
        if !self.is_orientable() {
            return None;
        }
        let (orbit_of, orbits) = self.sense_orbits();
        let mut is_chosen: Vec<Option<bool>> = vec![None; orbits];
        let mut chosen = vec![None; self.len()];
        let mut edges = 0;
        for pair in 0..self.len() as u32 {
            let base = Handle::base(pair);
            let [one, other] = [base, base.spin()].map(|h| orbit_of[self.index(h)] as usize);
            is_chosen[one].get_or_insert(true);
            is_chosen[other].get_or_insert(false);
            if chosen[pair as usize].is_some() {
                continue;
            }
            let first = if against.get(edges).is_some_and(|turned| *turned) { base.flip() } else { base };
            edges += 1;
            // The ring keeps the direction of the edge; the spin is that of the orbit.
            for h in self.facet_ring(first) {
                let is_of_orbit = is_chosen[orbit_of[self.index(h)] as usize] == Some(true);
                chosen[h.pair() as usize] = Some(if is_of_orbit { h } else { h.spin() });
            }
        }
        chosen.into_iter().collect()
    }

    /// The first handle at which a gluing, of a with a Fnext or in the dual space, does not lay an ambiguous edge on one with a
    /// direction. `None`, whatever the directions of the edges are, if the spins are those of [`FacetEdgeStructure::anticlockwise`].
    ///
    /// # Panics
    /// If `chosen` is not a primal handle for each pair, in order.
    #[doc(alias = "CX-37")]
    pub fn unpaired_sense(&self, chosen: &[Handle]) -> Option<Handle> {
        let is_defined = |h: Handle| edge_sense(chosen[h.pair() as usize], h) != EdgeSense::Ambiguous;
        let across = |h: Handle| [self.fnext(h).spin(), self.enext(h.flip())];
        self.handles(Space::Primal).into_iter().find(|h| across(*h).iter().any(|g| is_defined(*g) == is_defined(*h)))
    }

    /// The corners of polyhedra, by the directions that their edge gets from the copies that have one: the edge from the corner's vertex
    /// to the middle of the polyhedron. Each list has one entry for each different direction, so that two mean a contradiction.
    ///
    /// # Panics
    /// If `chosen` is not a primal handle for each pair, in order.
    #[doc(alias = "CX-38")]
    pub fn corner_directions(&self, chosen: &[Handle]) -> Vec<Vec<Towards>> {
        let (corner_of, corners) = self.orbits(&[&|h| self.fnext(h).spin(), &|h| self.enext(h.flip())]);
        let mut directions = vec![Vec::new(); corners];
        for h in self.handles(Space::Primal) {
            let found = &mut directions[corner_of[self.index(h)] as usize];
            match edge_sense(chosen[h.pair() as usize], h) {
                EdgeSense::Defined(towards) if !found.contains(&towards) => found.push(towards),
                EdgeSense::Defined(_) | EdgeSense::Ambiguous => {}
            }
        }
        directions.iter_mut().for_each(|found| found.sort());
        directions
    }
}
