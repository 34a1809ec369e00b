//! Barycentric subdivision: types of vertices, numbers of cells, and when it is a simplicial complex.

use super::closed_complex::ClosedComplex;
use super::flag::Flag;
use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation};
use std::collections::BTreeMap;

/// What a vertex of the barycentric subdivision is the middle of (000, section 3). Corner i of each barycentric tetrahedron has
/// the i-th type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[doc(alias = "CX-44")]
pub enum VertexType {
    /// A vertex of the complex itself.
    V,
    /// An edge.
    E,
    /// A face.
    F,
    /// A polyhedron.
    P,
}

impl VertexType {
    /// The types, by the dimension of the cell.
    pub const ALL: [VertexType; 4] = [VertexType::V, VertexType::E, VertexType::F, VertexType::P];
}

/// What the corners of a topological tetrahedron are: ends of an edge, and middles of polyhedra (000, section 5.1).
#[doc(alias = "CX-48")]
pub const CORNER_TYPES: [VertexType; 4] = [VertexType::V, VertexType::V, VertexType::P, VertexType::P];

impl ClosedComplex {
    /// How many vertices, edges, triangles and tetrahedra the barycentric subdivision has, by the numbers of the complex:
    /// V + E + F + P, that + 4t − χ, 8t, 4t.
    #[doc(alias = "CX-45")]
    pub fn barycentric_counts(&self) -> [usize; 4] {
        let vertices: usize = self.counts().iter().sum();
        let tetrahedra = 4 * self.facet_edge_pairs();
        let edges = (vertices + tetrahedra) as i64 - self.euler_characteristic();
        [vertices, edges as usize, 2 * tetrahedra, tetrahedra]
    }

    /// The four barycentric tetrahedra of each topological one (000, section 5.1), as flags: (v, e, f, p), (w, e, f, p), (v, e, f, q),
    /// (w, e, f, q) with v, w the ends of e, corners 0 and 1, and p, q the polyhedra at f, corners 2 and 3.
    #[doc(alias = "CX-47")]
    pub fn barycentric_parts(&self) -> Vec<[Flag; 4]> {
        let flags = self.flags();
        let parts = |base: Flag| [&[][..], &[0], &[3], &[0, 3]].map(|maps| flags.walk(base, maps));
        self.tetrahedron_flags().into_iter().map(parts).collect()
    }

    /// The two polyhedra that each topological tetrahedron lies half in, at corners 2 and 3: the face cuts it in two.
    #[doc(alias = "CX-49")]
    pub fn polyhedra_of_tetrahedra(&self) -> Vec<[u32; 2]> {
        let polyhedra = |flag: Flag| [flag, self.flags().sigma(3, flag)].map(|flag| self.cell(3, flag));
        self.tetrahedron_flags().into_iter().map(polyhedra).collect()
    }

    /// Whether each closed cell is a ball: no cell comes to another one twice. A vertex, an edge, a face comes to a cell once if the
    /// flags of the two cells are joined by maps of the other dimensions.
    ///
    /// The barycentric subdivision is a simplicial complex iff it is so (CX-46).
    #[doc(alias = "CX-46")]
    #[doc(alias = "CX-2")]
    pub fn is_regular(&self) -> bool {
        let pairs = (0..4).flat_map(|low| (low + 1..4).map(move |high| (low, high)));
        pairs.into_iter().all(|(low, high)| {
            let others: Vec<usize> = (0..4).filter(|k| *k != low && *k != high).collect();
            let (incidence_of, _) = self.flags().orbits(&others);
            let mut incidences = BTreeMap::new();
            self.flags().all().all(|flag| {
                let incidence = incidence_of[flag.0 as usize];
                *incidences.entry((self.cell(low, flag), self.cell(high, flag))).or_insert(incidence) == incidence
            })
        })
    }
}

impl Triangulation {
    /// Its barycentric subdivision: a tetrahedron for each order of the corners of each tetrahedron, whose corners 0, 1, 2, 3 are the
    /// first corner, the middle of the first two, the middle of the first three, and the middle of all.
    #[doc(alias = "CX-46")]
    pub fn barycentric(&self) -> Triangulation {
        let orders: Vec<Perm4> = Perm4::all().collect();
        let number = |order: Perm4| orders.binary_search(&order).expect("orders are sorted") as u32;
        let mut gluings = Vec::with_capacity(24 * self.len());
        for (tetrahedron, outer) in (0..).zip(self.gluings()) {
            for order in &orders {
                let mut row = [TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4];
                for (k, triangle) in row.iter_mut().enumerate() {
                    triangle.tetrahedron = if k < 3 {
                        let mut images = [0, 1, 2, 3];
                        images.swap(k, k + 1);
                        24 * tetrahedron + number(Perm4::new(images).expect("a permutation").then(*order))
                    } else {
                        let TriangleGluing { tetrahedron, corners } = outer[order.image(3)];
                        24 * tetrahedron + number(order.then(corners))
                    };
                }
                gluings.push(row);
            }
        }
        Triangulation::new(gluings).expect("each neighbour knows it")
    }
}
