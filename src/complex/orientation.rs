//! Orientation by other routes than the flags: by polyhedra, and by tetrahedra.

use super::closed_complex::ClosedComplex;
use super::triangulation::Triangulation;

/// Which tetrahedra belong together, and which components can be oriented.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    /// The component of each tetrahedron, numbered by their first ones.
    pub of: Vec<u32>,
    /// Whether each component can be oriented.
    pub orientable: Vec<bool>,
}

impl ClosedComplex {
    /// A sign for each polyhedron such that each pairing joins outside to outside, + for the first polyhedron of each component
    /// (CX-71): signs agree iff dir = −1, the faces of each polyhedron being seen from one side. `None` iff there is none.
    #[doc(alias = "CX-71")]
    pub fn polyhedron_signs(&self) -> Option<Vec<bool>> {
        let scheme = self.scheme();
        let mut neighbours = vec![Vec::new(); scheme.polyhedra.len()];
        for pairing in &scheme.pairings {
            let [a, b] = [pairing.a, pairing.b].map(|face| face.polyhedron);
            neighbours[a].push((b, pairing.dir == -1));
            neighbours[b].push((a, pairing.dir == -1));
        }
        let (Components { orientable, .. }, signs) = signed(neighbours.len(), |p| neighbours[p].iter().copied());
        orientable.iter().all(|orientable| *orientable).then_some(signs)
    }
}

impl Triangulation {
    /// Its components, and which can be oriented (CX-71): tetrahedra glued by an odd permutation of the corners have one sign,
    /// by an even one different signs.
    #[doc(alias = "CX-71")]
    pub fn components(&self) -> Components {
        let neighbours = |t: usize| self.gluings()[t].iter().map(|g| (g.tetrahedron as usize, !g.corners.is_even()));
        signed(self.len(), neighbours).0
    }

    /// Whether all tetrahedra can be given signs that way.
    pub fn is_orientable(&self) -> bool {
        self.components().orientable.iter().all(|orientable| *orientable)
    }
}

/// The components of a graph whose edges say whether their ends have one sign; signs, + for the first of each component. They
/// are right in a component that has such signs.
fn signed<I: Iterator<Item = (usize, bool)>>(n: usize, neighbours: impl Fn(usize) -> I) -> (Components, Vec<bool>) {
    const UNSEEN: u32 = u32::MAX;
    let (mut of, mut signs, mut orientable) = (vec![UNSEEN; n], vec![true; n], Vec::new());
    for first in 0..n {
        if of[first] != UNSEEN {
            continue;
        }
        let component = orientable.len() as u32;
        orientable.push(true);
        of[first] = component;
        let mut pending = vec![first];
        while let Some(at) = pending.pop() {
            for (next, same) in neighbours(at) {
                let sign = signs[at] == same;
                if of[next] == UNSEEN {
                    (of[next], signs[next]) = (component, sign);
                    pending.push(next);
                } else if signs[next] != sign {
                    orientable[component as usize] = false;
                }
            }
        }
    }
    (Components { of, orientable }, signs)
}
