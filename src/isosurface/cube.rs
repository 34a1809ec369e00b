//! The combinatorics of the unit cube: its 8 corners, 12 edges, 6 faces and 48 symmetries.

/// A corner of the cell: bit 0 is x, bit 1 is y, bit 2 is z, so that corner c lies at (c&1, c>>1&1, c>>2&1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Corner(u8);

impl Corner {
    /// All eight, in order.
    pub const ALL: [Corner; 8] =
        [Corner(0), Corner(1), Corner(2), Corner(3), Corner(4), Corner(5), Corner(6), Corner(7)];

    /// The corner at (x, y, z), each 0 or 1.
    pub const fn at(x: u8, y: u8, z: u8) -> Corner {
        assert!(x < 2 && y < 2 && z < 2);
        Corner(x + 2 * y + 4 * z)
    }

    /// 0 … 7.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Its coordinates, each 0 or 1.
    pub const fn position(self) -> [u8; 3] {
        [self.0 & 1, self.0 >> 1 & 1, self.0 >> 2 & 1]
    }

    /// The corner at the other end of the edge along `axis`.
    pub const fn across(self, axis: usize) -> Corner {
        Corner(self.0 ^ 1 << axis)
    }

    /// The bit of this corner in a set of corners.
    pub const fn bit(self) -> u8 {
        1 << self.0
    }
}

/// An edge of the cell, the pair of its corners, the smaller first; ordered as those pairs are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge(u8);

/// The corners of each edge, sorted.
const EDGES: [[u8; 2]; 12] =
    [[0, 1], [0, 2], [0, 4], [1, 3], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 6], [5, 7], [6, 7]];

impl Edge {
    /// All twelve, in order.
    pub const ALL: [Edge; 12] = {
        let mut all = [Edge(0); 12];
        let mut i = 0;
        while i < 12 {
            all[i] = Edge(i as u8);
            i += 1;
        }
        all
    };

    /// 0 … 11.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Its two corners, the smaller first.
    pub const fn corners(self) -> [Corner; 2] {
        let [a, b] = EDGES[self.0 as usize];
        [Corner(a), Corner(b)]
    }

    /// The axis it runs along: 0, 1 or 2.
    pub const fn axis(self) -> usize {
        let [a, b] = EDGES[self.0 as usize];
        (a ^ b).trailing_zeros() as usize
    }

    /// The edge between two corners, if there is one.
    pub fn between(a: Corner, b: Corner) -> Option<Edge> {
        let pair = [a.0.min(b.0), a.0.max(b.0)];
        EDGES.iter().position(|e| *e == pair).map(|i| Edge(i as u8))
    }

    /// Whether the edge lies in the closed face.
    pub fn in_face(self, face: Face) -> bool {
        self.corners().iter().all(|c| c.position()[face.axis()] == face.side())
    }
}

/// A face of the cell, in the order x=0, x=1, y=0, y=1, z=0, z=1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Face(u8);

impl Face {
    /// All six, in order.
    pub const ALL: [Face; 6] = [Face(0), Face(1), Face(2), Face(3), Face(4), Face(5)];

    /// The face on which coordinate `axis` is `side`.
    pub const fn new(axis: usize, side: u8) -> Face {
        assert!(axis < 3 && side < 2);
        Face(2 * axis as u8 + side)
    }

    /// 0 … 5.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The axis of its normal.
    pub const fn axis(self) -> usize {
        self.0 as usize / 2
    }

    /// The value, 0 or 1, of that coordinate on it.
    pub const fn side(self) -> u8 {
        self.0 % 2
    }

    /// Its corners counter-clockwise, seen from outside the cell.
    pub const fn cycle(self) -> [Corner; 4] {
        let (a, s) = (self.axis(), self.side() << self.axis());
        let (u, v) = (1 << ((a + 1) % 3), 1 << ((a + 2) % 3));
        match self.side() {
            0 => [Corner(s), Corner(s + v), Corner(s + u + v), Corner(s + u)],
            _ => [Corner(s), Corner(s + u), Corner(s + u + v), Corner(s + v)],
        }
    }

    /// "x=0", "x=1", …
    pub const fn name(self) -> &'static str {
        ["x=0", "x=1", "y=0", "y=1", "z=0", "z=1"][self.0 as usize]
    }
}

/// A symmetry of the cube: corner c goes to the corner with coordinates `x′[i] = x[axes[i]] ⊕ flips[i]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Symmetry {
    axes: [usize; 3],
    flips: [u8; 3],
}

impl Symmetry {
    /// All 48, the identity first.
    pub fn all() -> Vec<Symmetry> {
        const AXES: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        AXES.into_iter()
            .flat_map(|axes| (0..8u8).map(move |f| Symmetry { axes, flips: [f & 1, f >> 1 & 1, f >> 2 & 1] }))
            .collect()
    }

    /// Whether it keeps the orientation of space; 24 of the 48 do.
    pub fn is_rotation(self) -> bool {
        let cyclic = (self.axes[0] + 1) % 3 == self.axes[1];
        cyclic == (self.flips.iter().sum::<u8>() % 2 == 0)
    }

    /// The image of a corner.
    pub fn corner(self, c: Corner) -> Corner {
        let x = c.position();
        let [a, b, d] = [0, 1, 2].map(|i| x[self.axes[i]] ^ self.flips[i]);
        Corner::at(a, b, d)
    }

    /// The image of an edge.
    pub fn edge(self, e: Edge) -> Edge {
        let [a, b] = e.corners();
        Edge::between(self.corner(a), self.corner(b)).expect("a symmetry maps edges to edges")
    }

    /// The image of a face.
    pub fn face(self, f: Face) -> Face {
        let axis = (0..3).find(|&i| self.axes[i] == f.axis()).expect("the axes are a permutation");
        Face::new(axis, f.side() ^ self.flips[axis])
    }

    /// The image of a set of corners.
    pub fn corners(self, set: u8) -> u8 {
        Corner::ALL.into_iter().filter(|c| set & c.bit() != 0).fold(0, |image, c| image | self.corner(c).bit())
    }

    /// A function on the corners carried along: the value at c goes to the image of c.
    pub fn carry<T: Clone>(self, values: &[T; 8]) -> [T; 8] {
        let mut image = values.clone();
        for c in Corner::ALL {
            image[self.corner(c).index()] = values[c.index()].clone();
        }
        image
    }
}
