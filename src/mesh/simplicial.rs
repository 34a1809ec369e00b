//! Simplicial complexes as combinatorics: which sets of vertices span a simplex (IS-6 … IS-15).

use crate::number::Integer;
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// A simplex of dimension d, as its d + 1 vertices, sorted.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Simplex(Vec<u32>);

/// Why vertices are no simplex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SimplexError {
    /// There are none.
    #[error("a simplex has at least one vertex")]
    Empty,
    /// One stands twice.
    #[error("vertex {0} stands twice")]
    Repeated(u32),
    /// There are more than [`Simplex::MOST_VERTICES`].
    #[error("{0} vertices are more than {most}", most = Simplex::MOST_VERTICES)]
    TooMany(usize),
}

impl Simplex {
    /// A complex has all 2^(d+1) − 1 faces of its simplices, so d is bounded.
    pub const MOST_VERTICES: usize = 16;

    /// The simplex with these vertices, in any order.
    ///
    /// # Errors
    /// Iff there is none, one stands twice, or there are more than [`Simplex::MOST_VERTICES`].
    pub fn new(vertices: &[u32]) -> Result<Simplex, SimplexError> {
        let mut sorted = vertices.to_vec();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(SimplexError::Repeated(pair[0]));
        }
        match sorted.len() {
            0 => Err(SimplexError::Empty),
            n if n > Simplex::MOST_VERTICES => Err(SimplexError::TooMany(n)),
            _ => Ok(Simplex(sorted)),
        }
    }

    /// Its vertices, sorted.
    pub fn vertices(&self) -> &[u32] {
        &self.0
    }

    /// d, one less than the number of its vertices.
    pub fn dimension(&self) -> usize {
        self.0.len() - 1
    }

    /// Its faces of dimension k: every choice of k + 1 of its vertices (IS-6). There are [`face_count`] of them.
    #[doc(alias = "IS-6")]
    pub fn faces(&self, k: usize) -> Vec<Simplex> {
        let chosen = |set: u32| (0..self.0.len()).filter(move |i| set >> i & 1 == 1).map(|i| self.0[i]);
        let sets = (1u32..1 << self.0.len()).filter(|set| set.count_ones() as usize == k + 1);
        sets.map(|set| Simplex(chosen(set).collect())).collect()
    }

    /// Whether the other is a face of it, of any dimension, itself included.
    pub fn has_face(&self, other: &Simplex) -> bool {
        other.0.iter().all(|v| self.0.binary_search(v).is_ok())
    }

    /// The simplex of its other vertices; `None` where none is left.
    fn without(&self, face: &Simplex) -> Option<Simplex> {
        let rest: Vec<u32> = self.0.iter().copied().filter(|v| face.0.binary_search(v).is_err()).collect();
        (!rest.is_empty()).then_some(Simplex(rest))
    }
}

/// The number of k-faces of a d-simplex, C(d+1, k+1); the text prints C(d, k), the number for one vertex
/// less on either side (IS-7).
#[doc(alias = "IS-7")]
pub fn face_count(d: u32, k: u32) -> Integer {
    Integer::from(Integer::binomial_u(d + 1, k + 1))
}

/// A finite simplicial complex: a set of simplices that has all their faces. As a set of points it is the
/// disjoint union of their relative interiors.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct SimplicialComplex {
    simplices: BTreeSet<Simplex>,
}

impl SimplicialComplex {
    /// The complex of these simplices and all their faces.
    pub fn new(simplices: impl IntoIterator<Item = Simplex>) -> SimplicialComplex {
        let faces = |simplex: Simplex| (0..=simplex.dimension()).flat_map(move |k| simplex.faces(k));
        SimplicialComplex { simplices: simplices.into_iter().flat_map(faces).collect() }
    }

    /// The complex of these vertex sets and all their faces.
    ///
    /// # Errors
    /// Iff one of them is no simplex.
    pub fn from_vertices<V: AsRef<[u32]>>(simplices: &[V]) -> Result<SimplicialComplex, SimplexError> {
        let simplices: Result<Vec<_>, _> = simplices.iter().map(|v| Simplex::new(v.as_ref())).collect();
        simplices.map(SimplicialComplex::new)
    }

    /// Möbius' torus of 7 vertices, 21 edges and 14 triangles; every two vertices are joined (IS-15).
    pub fn torus() -> SimplicialComplex {
        let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 2) % 7, (i + 3) % 7]]);
        SimplicialComplex::new(triangles.map(|t| Simplex::new(&t).expect("0, 1, 2, 3 differ modulo 7")))
    }

    /// Its simplices, sorted by their vertices.
    pub fn simplices(&self) -> impl Iterator<Item = &Simplex> {
        self.simplices.iter()
    }

    /// Its simplices of dimension k.
    pub fn of_dimension(&self, k: usize) -> impl Iterator<Item = &Simplex> {
        self.simplices.iter().filter(move |s| s.dimension() == k)
    }

    /// Whether it has that simplex.
    pub fn contains(&self, simplex: &Simplex) -> bool {
        self.simplices.contains(simplex)
    }

    /// Its simplices that are a face of no other one.
    pub fn maximal(&self) -> Vec<&Simplex> {
        let is_proper_face = |s: &Simplex| self.of_dimension(s.dimension() + 1).any(|t| t.has_face(s));
        self.simplices().filter(|s| !is_proper_face(s)).collect()
    }

    /// #0, #1, #2, …: how many simplices there are of each dimension; empty for the empty complex.
    pub fn f_vector(&self) -> Vec<i64> {
        let mut counts = Vec::new();
        for simplex in self.simplices() {
            counts.resize(counts.len().max(simplex.dimension() + 1), 0);
            counts[simplex.dimension()] += 1;
        }
        counts
    }

    /// χ = #0 − #1 + #2 − #3 + … (IS-13; the text: #2 − #1 + #0).
    #[doc(alias = "IS-13")]
    pub fn euler_characteristic(&self) -> i64 {
        self.f_vector().iter().rev().fold(0, |chi, n| n - chi)
    }

    /// The link of a simplex: the simplices that have no vertex with it in common and span one with it. That of
    /// a vertex is its surroundings without itself, which is what a surface needs to be connected (IS-11).
    #[doc(alias = "IS-11")]
    pub fn link(&self, of: &Simplex) -> SimplicialComplex {
        let around = self.simplices().filter(|s| s.has_face(of));
        SimplicialComplex { simplices: around.filter_map(|s| s.without(of)).collect() }
    }

    /// How many connected components it has.
    pub fn component_count(&self) -> usize {
        let vertices: Vec<u32> = self.of_dimension(0).map(|v| v.0[0]).collect();
        let number = |v: &u32| vertices.binary_search(v).expect("a complex has its edges' ends");
        let mut parts = Partition::new(vertices.len());
        let unions = self.of_dimension(1).filter(|e| parts.join(number(&e.0[0]), number(&e.0[1]))).count();
        vertices.len() - unions
    }

    /// The complex with a simplex, and all that have it as a face, divided from a new vertex inside it: a triangle of
    /// a surface falls into three. χ, and the complex as a set of points, stay (IS-14). `None` iff it has no such
    /// simplex, or has the vertex already.
    #[doc(alias = "IS-14")]
    pub fn with_inner_vertex(&self, simplex: &Simplex, vertex: u32) -> Option<SimplicialComplex> {
        let inner = Simplex(vec![vertex]);
        if !self.contains(simplex) || self.contains(&inner) {
            return None;
        }
        let (divided, kept): (Vec<&Simplex>, Vec<&Simplex>) = self.simplices().partition(|s| s.has_face(simplex));
        let mut simplices: BTreeSet<Simplex> = kept.into_iter().cloned().collect();
        // The cone from the new vertex over the faces, of what is divided, that do not have the simplex.
        for face in divided.iter().flat_map(|s| (0..=s.dimension()).flat_map(|k| s.faces(k))) {
            if !face.has_face(simplex) {
                let spanned = [&face.0[..], &[vertex]].concat();
                simplices.insert(Simplex::new(&spanned).expect("the vertex is new"));
            }
        }
        simplices.insert(inner);
        Some(SimplicialComplex { simplices })
    }

    /// Both complexes side by side, the other one's vertices renumbered. χ is the sum of theirs, so that it does not
    /// see a torus (IS-15).
    ///
    /// # Panics
    /// Iff the numbers of the vertices do not fit into 32 bits.
    #[doc(alias = "IS-15")]
    pub fn disjoint_union(&self, other: &SimplicialComplex) -> SimplicialComplex {
        let first_free = self.of_dimension(0).map(|v| v.0[0] + 1).max().unwrap_or(0);
        let moved = other.simplices().map(|s| Simplex(s.0.iter().map(|v| v + first_free).collect()));
        SimplicialComplex { simplices: self.simplices().cloned().chain(moved).collect() }
    }

    /// What keeps it from being a polygonal curve, sorted; empty iff it is one, perhaps of several closed parts
    /// (IS-9).
    #[doc(alias = "IS-9")]
    pub fn curve_defects(&self) -> Vec<CurveDefect> {
        let mut defects: Vec<CurveDefect> =
            self.simplices().filter(|s| s.dimension() >= 2).cloned().map(CurveDefect::TooLarge).collect();
        for vertex in self.of_dimension(0) {
            match self.of_dimension(1).filter(|e| e.has_face(vertex)).count() {
                0 => defects.push(CurveDefect::Isolated(vertex.0[0])),
                2 => {}
                edges => defects.push(CurveDefect::Degree { vertex: vertex.0[0], edges }),
            }
        }
        defects.sort();
        defects
    }

    /// What keeps it from being a closed triangulated surface, sorted; empty iff it is one (IS-10, IS-11). The
    /// condition at a vertex is the one of the edges around it and that its link is connected; by itself, the link's
    /// being connected does not make the vertex manifold (IS-12).
    #[doc(alias = "IS-10")]
    #[doc(alias = "IS-12")]
    pub fn surface_defects(&self) -> Vec<SurfaceDefect> {
        let mut defects: Vec<SurfaceDefect> =
            self.simplices().filter(|s| s.dimension() >= 3).cloned().map(SurfaceDefect::TooLarge).collect();
        let mut triangles_of: BTreeMap<Simplex, usize> = self.of_dimension(1).cloned().map(|e| (e, 0)).collect();
        for edge in self.of_dimension(2).flat_map(|t| t.faces(1)) {
            *triangles_of.entry(edge).or_default() += 1;
        }
        for (edge, triangles) in triangles_of {
            match triangles {
                0 => defects.push(SurfaceDefect::Isolated(edge)),
                2 => {}
                _ => defects.push(SurfaceDefect::Edge { edge, triangles }),
            }
        }
        for vertex in self.of_dimension(0) {
            match self.link(vertex).component_count() {
                0 => defects.push(SurfaceDefect::Isolated(vertex.clone())),
                1 => {}
                parts => defects.push(SurfaceDefect::Vertex { vertex: vertex.0[0], parts }),
            }
        }
        defects.sort();
        defects
    }
}

/// What keeps a complex from being a polygonal curve.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CurveDefect {
    /// A simplex of dimension 2 or more.
    TooLarge(Simplex),
    /// A vertex of no edge.
    Isolated(u32),
    /// A vertex of another number of edges than two.
    Degree {
        /// The vertex.
        vertex: u32,
        /// How many edges it has.
        edges: usize,
    },
}

/// What keeps a complex from being a closed triangulated surface.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SurfaceDefect {
    /// A simplex of dimension 3 or more.
    TooLarge(Simplex),
    /// A vertex of no edge, or an edge of no triangle.
    Isolated(Simplex),
    /// An edge of another number of triangles than two.
    Edge {
        /// The edge.
        edge: Simplex,
        /// How many triangles it has.
        triangles: usize,
    },
    /// A vertex whose edges and triangles, without itself, are not connected.
    Vertex {
        /// The vertex.
        vertex: u32,
        /// How many parts they make.
        parts: usize,
    },
}
