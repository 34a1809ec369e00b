//! All gluings of one polyhedron, by number, and what each is.

use super::abelian::AbelianGroup;
use super::closed_complex::ClosedComplex;
use super::manifold::Manifold3;
use super::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SchemeDefect};
use crate::mesh::classify::{ClosedSurface, SPHERE, Surface};
use std::fmt::{self, Display, Formatter};

/// The gluings of a polyhedron's faces in twos, each with one of as many sides, by all 2n maps: face by face, each with a later
/// one. They have numbers from 0 on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Census {
    polyhedron: Polyhedron,
}

impl Census {
    /// Of this polyhedron.
    ///
    /// # Errors
    /// Iff it is not a ball.
    pub fn new(polyhedron: Polyhedron) -> Result<Census, SchemeDefect> {
        match polyhedron.flaw() {
            None => Ok(Census { polyhedron }),
            Some(flaw) => Err(SchemeDefect::BadPolyhedron { polyhedron: 0, flaw }),
        }
    }

    /// The polyhedron.
    pub fn polyhedron(&self) -> &Polyhedron {
        &self.polyhedron
    }

    /// How many there are: Π (m − 1)!!·(2n)^{m/2} over the numbers m of n-gons, 0 if one of them is odd (CX-9). `None` from
    /// 2¹²⁸ on.
    #[doc(alias = "CX-9")]
    pub fn count(&self) -> Option<u128> {
        let mut open: Vec<usize> = self.polyhedron.faces.iter().map(Vec::len).collect();
        open.sort_unstable();
        if open.chunk_by(|a, b| a == b).any(|same| same.len() % 2 == 1) {
            return Some(0);
        }
        let mut count: u128 = 1;
        while let Some(sides) = open.pop() {
            let partners = open.iter().filter(|n| **n == sides).count();
            count = count.checked_mul((partners * 2 * sides) as u128)?;
            open.pop();
        }
        Some(count)
    }

    /// The gluing of that number, the number of the first face's partner and map varying fastest. `None` iff there is none.
    pub fn gluing(&self, number: u128) -> Option<GluingScheme> {
        let faces = &self.polyhedron.faces;
        let mut open: Vec<usize> = (0..faces.len()).collect();
        let (mut rest, mut pairings) = (number, Vec::new());
        while !open.is_empty() {
            let a = open.remove(0);
            let n = faces[a].len();
            let partners: Vec<usize> = open.iter().copied().filter(|b| faces[*b].len() == n).collect();
            let choices = (partners.len() * 2 * n) as u128;
            if choices == 0 {
                return None;
            }
            let choice = (rest % choices) as usize;
            rest /= choices;
            let b = partners[choice / (2 * n)];
            open.retain(|face| *face != b);
            let [a, b] = [a, b].map(|face| FaceId { polyhedron: 0, face });
            let dir = if (choice / n).is_multiple_of(2) { 1 } else { -1 };
            pairings.push(Pairing { a, b, shift: (choice % n) as i64, dir });
        }
        (rest == 0).then(|| GluingScheme { polyhedra: vec![self.polyhedron.clone()], pairings })
    }

    /// All of them in order, as far as their numbers go.
    pub fn gluings(&self) -> impl Iterator<Item = GluingScheme> {
        (0..self.count().unwrap_or(u128::MAX)).filter_map(|number| self.gluing(number))
    }
}

/// What a gluing without defects of its own turns out to be.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// A closed 3-manifold.
    Manifold {
        /// Whether it is orientable.
        orientable: bool,
        /// H₁ over ℤ.
        h1: AbelianGroup,
        /// V, E, F, P.
        cells: [usize; 4],
    },
    /// A closed complex that is no manifold: the surfaces around its vertices, sorted, not all of them spheres.
    NoManifold(Vec<ClosedSurface>),
    /// An edge is glued to itself, tail to head.
    EdgeReversed,
}

impl Display for Kind {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Kind::Manifold { orientable, h1, cells: [v, e, _, _] } => {
                let sides = if *orientable { "orientable" } else { "not orientable" };
                write!(f, "manifold, {sides}, H₁ = {h1}, V = {v}, E = {e}")
            }
            Kind::NoManifold(links) => {
                let named = |link: &ClosedSurface| Surface { closed: *link, boundary_loops: 0 }.to_string();
                write!(f, "vertex-link: {}", links.iter().map(named).collect::<Vec<_>>().join(", "))
            }
            Kind::EdgeReversed => f.write_str("edge-reversed"),
        }
    }
}

/// What a scheme is.
///
/// # Errors
/// Iff it has a defect by itself ([`GluingScheme::defects`]).
#[doc(alias = "CX-10")]
#[doc(alias = "CX-11")]
pub fn kind(scheme: GluingScheme) -> Result<Kind, Vec<SchemeDefect>> {
    let complex = match ClosedComplex::new(scheme) {
        Ok(complex) => complex,
        Err(defects) if defects.iter().all(|d| matches!(d, SchemeDefect::EdgeReversed { .. })) => {
            return Ok(Kind::EdgeReversed);
        }
        Err(defects) => return Err(defects),
    };
    let mut links = complex.vertex_links();
    if links.iter().any(|link| *link != SPHERE) {
        links.sort_unstable();
        return Ok(Kind::NoManifold(links));
    }
    let manifold = Manifold3::of(complex).expect("all links are spheres");
    let (orientable, h1, cells) = (manifold.is_orientable(), manifold.first_homology(), manifold.counts());
    Ok(Kind::Manifold { orientable, h1, cells })
}
