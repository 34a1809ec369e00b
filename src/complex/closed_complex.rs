//! Schemes whose faces are all glued: cells, rings, orientation.

use super::flag::{Flag, Flags};
use super::scheme::{GluingScheme, Pairing, SchemeDefect};

/// A closed 3-complex: balls glued along their faces in twos, no edge turned on itself. Each vertex has a surface around it,
/// which may be another one than a sphere.
///
/// Flags 2s and 2s + 1 are at the beginning and the end of side s, where the sides of all faces are numbered in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClosedComplex {
    scheme: GluingScheme,
    flags: Flags,
    /// By dimension, then by flag.
    cell_of: [Vec<u32>; 4],
    counts: [usize; 4],
}

impl ClosedComplex {
    /// The complex of a scheme.
    ///
    /// # Errors
    /// Iff the scheme has a defect by itself, or an edge is glued to itself, tail to head: all of them, never none.
    #[doc(alias = "CX-2")]
    pub fn new(scheme: GluingScheme) -> Result<ClosedComplex, Vec<SchemeDefect>> {
        let defects = scheme.defects();
        if !defects.is_empty() {
            return Err(defects);
        }
        let flags = glued(&scheme);
        let reversed = reversed_edges(&scheme, &flags);
        if !reversed.is_empty() {
            return Err(reversed);
        }
        let orbits = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].map(|maps| flags.orbits(&maps));
        let counts = [0, 1, 2, 3].map(|k| orbits[k].1);
        Ok(ClosedComplex { scheme, flags, cell_of: orbits.map(|(numbers, _)| numbers), counts })
    }

    /// What it was glued from.
    pub fn scheme(&self) -> &GluingScheme {
        &self.scheme
    }

    /// Its flags.
    pub fn flags(&self) -> &Flags {
        &self.flags
    }

    /// V, E, F, P.
    pub fn counts(&self) -> [usize; 4] {
        self.counts
    }

    /// χ = V − E + F − P.
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f, p] = self.counts.map(|n| n as i64);
        v - e + f - p
    }

    /// The cell of dimension k ≤ 3 of a flag. Polyhedra have the numbers that they have in the scheme.
    pub fn cell(&self, k: usize, flag: Flag) -> u32 {
        self.cell_of[k][flag.0 as usize]
    }

    /// The number t of face-edge pairs, with multiplicity: Σ |F_e| = Σ |E_f|.
    #[doc(alias = "CX-16")]
    pub fn facet_edge_pairs(&self) -> usize {
        self.flags.len() / 4
    }

    /// |F_e| of each edge e: how often faces stand around it.
    pub fn edge_ring_sizes(&self) -> Vec<usize> {
        self.pairs_of(1)
    }

    /// |E_f| of each face f: how many sides it has.
    pub fn face_degrees(&self) -> Vec<usize> {
        self.pairs_of(2)
    }

    fn pairs_of(&self, k: usize) -> Vec<usize> {
        let mut flags = vec![0; self.counts[k]];
        self.cell_of[k].iter().for_each(|cell| flags[*cell as usize] += 1);
        flags.into_iter().map(|n| n / 4).collect()
    }

    /// The number of its connected components.
    pub fn component_count(&self) -> usize {
        self.flags.orbits(&[0, 1, 2, 3]).1
    }

    /// Whether polyhedra can be turned so that each pairing glues an outside to an outside, reversed.
    pub fn is_orientable(&self) -> bool {
        self.flags.signs(&[0, 1, 2, 3]).is_some()
    }

    /// The polyhedron of the scheme at a flag, and what the flag's vertex is called there.
    pub fn name(&self, flag: Flag) -> (usize, u32) {
        let mut side = flag.0 as usize / 2;
        for (number, polyhedron) in self.scheme.polyhedra.iter().enumerate() {
            for face in &polyhedron.faces {
                if let Some(signed) = face.get(side) {
                    let ends = polyhedron.ends(*signed).expect("the polyhedron was checked");
                    return (number, ends[flag.0 as usize % 2]);
                }
                side -= face.len();
            }
        }
        unreachable!("flags are numbered by sides")
    }
}

/// The flags of a scheme without defects.
fn glued(scheme: &GluingScheme) -> Flags {
    let mut first = Vec::new();
    let mut sides = 0;
    for polyhedron in &scheme.polyhedra {
        let mut of_faces = Vec::new();
        for face in &polyhedron.faces {
            of_faces.push(sides);
            sides += face.len();
        }
        first.push(of_faces);
    }
    let flag = |side: usize, end: usize| (2 * side + end) as u32;
    let mut sigma = [(); 4].map(|()| vec![0; 2 * sides]);
    let mut join = |k: usize, a: u32, b: u32| {
        sigma[k][a as usize] = b;
        sigma[k][b as usize] = a;
    };
    for (polyhedron, first) in scheme.polyhedra.iter().zip(&first) {
        let mut other_use = vec![None; polyhedron.edges.len()];
        for (face, first) in polyhedron.faces.iter().zip(first) {
            for (i, signed) in face.iter().enumerate() {
                let side = first + i;
                join(0, flag(side, 0), flag(side, 1));
                join(1, flag(side, 1), flag(first + (i + 1) % face.len(), 0));
                // The two faces at an edge walk along it opposite ways.
                match other_use[signed.index().expect("an edge")].replace(side) {
                    None => {}
                    Some(other) => (0..2).for_each(|end| join(2, flag(side, end), flag(other, 1 - end))),
                }
            }
        }
    }
    for Pairing { a, b, shift, dir } in &scheme.pairings {
        let n = scheme.polyhedra[a.polyhedron].faces[a.face].len() as i64;
        let [a, b] = [a, b].map(|id| first[id.polyhedron][id.face]);
        for i in 0..n {
            // Side i runs from corner i to corner i + 1.
            let corner = |i: i64| (shift.rem_euclid(n) + dir * i).rem_euclid(n) as usize;
            match dir {
                1 => (0..2).for_each(|end| join(3, flag(a + i as usize, end), flag(b + corner(i), end))),
                _ => (0..2).for_each(|end| join(3, flag(a + i as usize, end), flag(b + corner(i + 1), 1 - end))),
            }
        }
    }
    Flags::new(sigma).expect("sides, corners, edges and faces are joined in twos")
}

/// The edges that are glued to themselves, tail to head, by the first edge of a polyhedron that is a part of each.
fn reversed_edges(scheme: &GluingScheme, flags: &Flags) -> Vec<SchemeDefect> {
    let (end_of_edge, _) = flags.orbits(&[2, 3]);
    let (edge_of, edges) = flags.orbits(&[0, 2, 3]);
    let mut told = vec![false; edges];
    let mut defects = Vec::new();
    let mut side = 0;
    for (polyhedron, p) in scheme.polyhedra.iter().enumerate() {
        for signed in p.faces.iter().flatten() {
            let turned = end_of_edge[2 * side] == end_of_edge[2 * side + 1];
            if turned && !std::mem::replace(&mut told[edge_of[2 * side] as usize], true) {
                let edge = signed.index().expect("an edge");
                defects.push(SchemeDefect::EdgeReversed { polyhedron, edge });
            }
            side += 1;
        }
    }
    defects
}
