//! Handles: a face-edge pair as it is seen, one of eight versions.

use std::fmt::{self, Display, Formatter};

/// The complex that is meant, or its dual, whose vertices are the polyhedra and whose edges are the faces of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Space {
    /// The complex.
    Primal,
    /// Its dual.
    Dual,
}

impl Space {
    /// The other one.
    pub const fn other(self) -> Space {
        match self {
            Space::Primal => Space::Dual,
            Space::Dual => Space::Primal,
        }
    }
}

/// A face-edge pair in one of eight versions: in the primal or in the dual space, its edge directed one way or the other (the
/// *orientation*: the sense in which the ring of edges E_f is walked), the face turned around the edge one way or the other
/// (the *spin*: the sense in which the ring of faces F_e is walked).
///
/// Each record has a version with neither bit set, its base; the dual base is [`Handle::sdual`] of it. As a flag a primal handle
/// has the tail of its edge for vertex and the polyhedron that its spin turns into for polyhedron.
///
/// As functions of handles, written behind them: Spin² = Clock² = Sdual² = 1, Spin Clock = Clock Spin, Sdual Clock = Clock
/// Sdual, Sdual Spin Sdual = Spin Clock. They make the group of order 8 that moves a pair's versions among each other.
#[doc(alias = "CX-15")]
#[doc(alias = "CX-22")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Handle {
    pair: u32,
    space: Space,
    reversed: bool,
    counter: bool,
}

impl Handle {
    /// The base version of a pair in the primal space.
    pub const fn base(pair: u32) -> Handle {
        Handle { pair, space: Space::Primal, reversed: false, counter: false }
    }

    /// The eight versions of a pair, primal ones first.
    pub fn versions(pair: u32) -> [Handle; 8] {
        let base = Handle::base(pair);
        let primal = [base, base.spin(), base.clock(), base.clock().spin()];
        std::array::from_fn(|i| if i < 4 { primal[i] } else { primal[i - 4].sdual() })
    }

    /// The number of the pair's record.
    pub const fn pair(self) -> u32 {
        self.pair
    }

    /// The space in which the pair is seen.
    pub const fn space(self) -> Space {
        self.space
    }

    /// Whether the edge is directed against that of the record's base version in this space.
    pub const fn is_reversed(self) -> bool {
        self.reversed
    }

    /// Whether the face is turned against that of the record's base version in this space.
    pub const fn is_counter(self) -> bool {
        self.counter
    }

    /// Spin: the faces around the edge in the other sense; the edge keeps its direction.
    #[doc(alias = "CX-20")]
    pub const fn spin(self) -> Handle {
        Handle { counter: !self.counter, ..self }
    }

    /// Clock: both rings in the other sense. Seen from the other end of the edge, what turned clockwise turns anticlockwise.
    #[doc(alias = "CX-19")]
    pub const fn clock(self) -> Handle {
        Handle { reversed: !self.reversed, counter: !self.counter, ..self }
    }

    /// The same faces around the same edge in the same sense, with the edge directed the other way: Spin Clock.
    pub const fn flip(self) -> Handle {
        Handle { reversed: !self.reversed, ..self }
    }

    /// Sdual: the pair of the dual edge and the dual face. The dual edge is directed as the spin turns, and the spin of the dual
    /// pair turns as the edge is directed.
    #[doc(alias = "CX-21")]
    pub const fn sdual(self) -> Handle {
        Handle { pair: self.pair, space: self.space.other(), reversed: self.counter, counter: self.reversed }
    }

    /// The same version of the pair of that number.
    pub(crate) const fn of_pair(self, pair: u32) -> Handle {
        Handle { pair, ..self }
    }

    /// The same bits in the other space: a handle of the complex as one of the dual structure.
    pub(crate) const fn in_other_space(self) -> Handle {
        Handle { space: self.space.other(), ..self }
    }

    /// Another handle, turned as this one is against its base. Twice is nothing.
    pub(crate) const fn turning(self, other: Handle) -> Handle {
        Handle { reversed: self.reversed != other.reversed, counter: self.counter != other.counter, ..other }
    }
}

impl Display for Handle {
    /// `7`, `7 Spin`, `7 Clock Sdual`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (primal, sdual) = match self.space {
            Space::Primal => (*self, ""),
            Space::Dual => (self.sdual(), " Sdual"),
        };
        let version = match (primal.reversed, primal.counter) {
            (false, false) => "",
            (false, true) => " Spin",
            (true, true) => " Clock",
            (true, false) => " Clock Spin",
        };
        write!(f, "{}{version}{sdual}", self.pair)
    }
}
