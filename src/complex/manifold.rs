//! Closed complexes that are manifolds: a sphere around each vertex.

use super::closed_complex::ClosedComplex;
use super::scheme::{GluingScheme, SchemeDefect};
use crate::mesh::classify::{ClosedSurface, SPHERE};
use std::ops::Deref;

/// A closed 3-manifold with its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Manifold3(ClosedComplex);

impl Manifold3 {
    /// The manifold of a scheme.
    ///
    /// # Errors
    /// Iff the scheme makes no closed complex, or a surface around a vertex is no sphere: all that is wrong, never nothing.
    #[doc(alias = "CX-4")]
    pub fn new(scheme: GluingScheme) -> Result<Manifold3, Vec<SchemeDefect>> {
        Manifold3::of(ClosedComplex::new(scheme)?)
    }

    /// The complex as a manifold.
    ///
    /// # Errors
    /// Iff a surface around a vertex is no sphere: the vertices at which it is none, never nothing.
    #[doc(alias = "CX-5")]
    pub fn of(complex: ClosedComplex) -> Result<Manifold3, Vec<SchemeDefect>> {
        let links = complex.vertex_links();
        let defects: Vec<SchemeDefect> = (0..)
            .zip(links)
            .filter(|(_, link)| *link != SPHERE)
            .map(|(vertex, link)| {
                let flag = complex.flags().all().find(|flag| complex.cell(0, *flag) == vertex).expect("it has a flag");
                let (polyhedron, name) = complex.name(flag);
                SchemeDefect::VertexLink { vertex, polyhedron, name, link }
            })
            .collect();
        if defects.is_empty() { Ok(Manifold3(complex)) } else { Err(defects) }
    }

    /// The complex, whose other facts it is asked for.
    pub fn complex(&self) -> &ClosedComplex {
        &self.0
    }
}

impl Deref for Manifold3 {
    type Target = ClosedComplex;

    fn deref(&self) -> &ClosedComplex {
        &self.0
    }
}

impl ClosedComplex {
    /// The surface around each vertex, its link: a vertex for each end of an edge there, an edge for each corner of a face, a
    /// polygon for each corner of a polyhedron. Connected, for a vertex is an orbit of σ₁, σ₂, σ₃.
    pub fn vertex_links(&self) -> Vec<ClosedSurface> {
        let flags = self.flags();
        let mut chi = vec![0_i64; self.counts()[0]];
        for (maps, sign) in [([2, 3], 1), ([1, 3], -1), ([1, 2], 1)] {
            let (orbit_of, orbits) = flags.orbits(&maps);
            let mut counted = vec![false; orbits];
            for flag in flags.all() {
                if !std::mem::replace(&mut counted[orbit_of[flag.0 as usize] as usize], true) {
                    chi[self.cell(0, flag) as usize] += sign;
                }
            }
        }
        let mut orientable = vec![true; self.counts()[0]];
        if flags.signs(&[1, 2, 3]).is_none() {
            orientable = self.vertices_with_signs();
        }
        let surface = |(chi, orientable): (i64, bool)| {
            let missing = usize::try_from(2 - chi).expect("a closed connected surface has χ ≤ 2");
            match orientable {
                true => ClosedSurface::Orientable { genus: missing / 2 },
                false => ClosedSurface::NonOrientable { crosscaps: missing },
            }
        };
        chi.into_iter().zip(orientable).map(surface).collect()
    }

    /// Whether the flags at each vertex fall into two classes that σ₁, σ₂, σ₃ exchange.
    fn vertices_with_signs(&self) -> Vec<bool> {
        let flags = self.flags();
        let even: Vec<[usize; 2]> = vec![[1, 2], [1, 3], [2, 3]];
        let mut parts = crate::partition::Partition::new(flags.len());
        for flag in flags.all() {
            for maps in &even {
                parts.join(flag.0 as usize, flags.walk(flag, maps).0 as usize);
            }
        }
        let mut orientable = vec![true; self.counts()[0]];
        for flag in flags.all() {
            let next = flags.sigma(1, flag);
            if parts.find(flag.0 as usize) == parts.find(next.0 as usize) {
                orientable[self.cell(0, flag) as usize] = false;
            }
        }
        orientable
    }
}
