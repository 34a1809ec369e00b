//! What a check finds.

use super::area::Area;
use super::between::Junction;
use crate::mesh::triangles::EdgeKey;
use crate::number::Rational;
use std::collections::BTreeMap;

macro_rules! categories {
    ($($variant:ident $name:literal $meaning:literal;)*) => {
        /// A kind of defect, by the protocol's name for it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Category {
            $(#[doc = $meaning] $variant,)*
        }

        impl Category {
            /// All of them, in the order of the protocol.
            pub const ALL: &[Category] = &[$(Category::$variant),*];

            /// Its name in the protocol.
            pub const fn name(self) -> &'static str {
                match self { $(Category::$variant => $name,)* }
            }

            /// What it means, in a few words.
            pub const fn meaning(self) -> &'static str {
                match self { $(Category::$variant => $meaning,)* }
            }
        }
    };
}

categories! {
    IndexOutOfRange "index_out_of_range" "a face names a vertex that does not exist";
    FewerThanThreeVertices "face_lt3_vertices" "a face of fewer than 3 vertices";
    RepeatedVertex "repeated_vertex_in_loop" "a face visits a vertex twice";
    DegenerateEdge "degenerate_edge_same_index" "a side from a vertex to itself";
    ZeroLengthEdge "zero_length_edge" "an edge between two vertices at one position";
    BoundaryEdge "boundary_edge" "an edge of one face only";
    UsedMoreThanTwice "edge_used_gt2" "an edge of more than two faces";
    OddUse "edge_odd_use" "an edge used an odd number of times, three or more";
    TwiceInOneFace "edge_twice_in_same_face" "an edge used twice by one face";
    InconsistentWinding "inconsistent_winding_edge" "two faces run along their edge in the same direction";
    IsolatedVertex "isolated_vertex" "a vertex that no face uses";
    DuplicatePosition "duplicate_vertex_position" "vertices at one position";
    DuplicateFace "duplicate_face" "faces with the same loop";
    ZeroArea "zero_area_face" "a face all of whose vertices lie on one line";
    Nonplanar "nonplanar_face" "a face whose vertices are not in one plane";
    ZeroSignedArea "zero_signed_area_face" "a planar face whose signed area is zero";
    SelfCrossing "self_crossing_loop" "a planar face two of whose sides cross";
    TJunction "t_junction" "a vertex inside an edge that does not end there";
    NonmanifoldVertex "nonmanifold_vertex" "a vertex whose faces are not one fan";
    FewerThanTwoEdges "vertex_lt2_edges" "a vertex with fewer than two neighbours";
    NonOrientable "non_orientable" "no choice of sides makes the faces agree";
    InsideOut "inside_out" "the faces look inward: the volume is negative";
    ZeroVolume "zero_volume" "the surface encloses no volume";
}

/// The elements of one category, sorted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Elements {
    /// Faces.
    Faces(Vec<u32>),
    /// Vertices.
    Vertices(Vec<u32>),
    /// Edges.
    Edges(Vec<EdgeKey>),
    /// Groups of vertices or of faces.
    Groups(Vec<Vec<u32>>),
    /// Vertices with the edges that they lie inside.
    Junctions(Vec<Junction>),
    /// The mesh as a whole.
    Whole,
}

impl Elements {
    /// How many there are; 1 for the whole.
    pub fn len(&self) -> usize {
        match self {
            Elements::Faces(list) | Elements::Vertices(list) => list.len(),
            Elements::Edges(list) => list.len(),
            Elements::Groups(list) => list.len(),
            Elements::Junctions(list) => list.len(),
            Elements::Whole => 1,
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The numbers of a mesh: its Euler–Poincaré formula is chi = V − E + F − H = 2(C − G).
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(non_snake_case, reason = "the symbols of the formula")]
pub struct Counts {
    /// Used vertices.
    pub V: u64,
    /// Different edges.
    pub E: u64,
    /// Faces.
    pub F: u64,
    /// Loops of holes: none.
    pub H: u64,
    /// Components: vertices joined by faces.
    pub C: u64,
    /// V − E + F − H.
    pub chi: i64,
    /// The genus, where the mesh is a manifold.
    pub G: Option<i64>,
    /// No edge of one use or of more than two, no side from a vertex to itself.
    pub closed: bool,
    /// Some choice of flips makes every two-use edge opposite.
    pub orientable: bool,
    /// Closed, every vertex one fan, wound consistently, orientable.
    pub manifold: bool,
    /// The volume, where the mesh is closed and wound consistently.
    pub volume: Option<Rational>,
}

/// One connected component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Component {
    /// Its faces.
    pub faces: u64,
    /// Its vertices.
    pub vertices: u64,
    /// Its edges.
    pub edges: u64,
    /// The closed curves of its boundary edges.
    pub boundary_loops: u64,
    /// Where it is an orientable surface, perhaps with boundary: V − E + F = 2 − 2·genus − loops.
    pub genus: Option<i64>,
}

/// All that is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The defects, by category; one without elements is absent.
    pub defects: BTreeMap<Category, Elements>,
    /// The numbers; none where a face names a vertex that does not exist.
    pub counts: Option<Counts>,
    /// The components, those of most faces first; empty where there are no counts.
    pub components: Vec<Component>,
    /// The area; none where there are no counts.
    pub area: Option<Area>,
    /// Whether the t-junctions are all: their search stops at [`super::MAX_JUNCTIONS`].
    pub all_junctions: bool,
}
