//! When two facet-edge structures are the same but for the numbers of their pairs; the parts of one structure.

use super::facet_edge::FacetEdgeStructure;
use super::handle::{Handle, Space};

impl FacetEdgeStructure {
    /// The image of each pair's base under an isomorphism to another structure: a map of primal handles that Fnext, Enext, Spin and
    /// Clock commute with. `None` iff there is none. Components are matched first come, first served: being isomorphic is an
    /// equivalence, so that no choice is wrong.
    #[doc(alias = "CX-43")]
    pub fn isomorphism(&self, other: &FacetEdgeStructure) -> Option<Vec<Handle>> {
        if self.len() != other.len() {
            return None;
        }
        let mut image: Vec<Option<Handle>> = vec![None; self.len()];
        let mut taken = vec![false; other.len()];
        for pair in 0..self.len() {
            if image[pair].is_some() {
                continue;
            }
            let free = other.handles(Space::Primal).into_iter().filter(|h| !taken[h.pair() as usize]);
            let component = free.map(|h| self.extended(other, pair as u32, h)).find_map(|found| found)?;
            for (pair, h) in component {
                image[pair as usize] = Some(h);
                taken[h.pair() as usize] = true;
            }
        }
        image.into_iter().collect()
    }

    /// The only map of a component that takes the base of this pair to that handle, if it is an isomorphism to a component.
    fn extended(&self, other: &FacetEdgeStructure, pair: u32, h: Handle) -> Option<Vec<(u32, Handle)>> {
        let mut image: Vec<Option<Handle>> = vec![None; self.len()];
        let mut used = vec![false; other.len()];
        image[pair as usize] = Some(h);
        used[h.pair() as usize] = true;
        let mut reached = vec![(pair, h)];
        let mut done = 0;
        while done < reached.len() {
            let (pair, h) = reached[done];
            done += 1;
            let base = Handle::base(pair);
            for (a, b) in [(base, h), (base.clock(), h.clock())] {
                for (next, to) in [(self.fnext(a), other.fnext(b)), (self.enext(a), other.enext(b))] {
                    let to = next.turning(to);
                    match image[next.pair() as usize] {
                        Some(known) if known == to => {}
                        Some(_) => return None,
                        None if std::mem::replace(&mut used[to.pair() as usize], true) => return None,
                        None => {
                            image[next.pair() as usize] = Some(to);
                            reached.push((next.pair(), to));
                        }
                    }
                }
            }
        }
        Some(reached)
    }

    /// The pairs of each connected component.
    pub fn components(&self) -> Vec<Vec<u32>> {
        let (number, count) = self.orbits(&[&|h| h.spin(), &|h| h.clock(), &|h| self.fnext(h), &|h| self.enext(h)]);
        let mut components = vec![Vec::new(); count];
        (0..self.len()).for_each(|pair| components[number[4 * pair] as usize].push(pair as u32));
        components
    }

    /// The structure of these pairs alone, numbered as they come. `None` iff a pair has no record or is named twice, or a ring
    /// leads out of them.
    pub fn part(&self, pairs: &[u32]) -> Option<FacetEdgeStructure> {
        let mut number = vec![None; self.len()];
        for (new, old) in pairs.iter().enumerate() {
            if number.get_mut(*old as usize)?.replace(new as u32).is_some() {
                return None;
            }
        }
        let renamed = |h: &Handle| Some(h.of_pair(number[h.pair() as usize]?));
        let mut part = FacetEdgeStructure::default();
        for old in pairs {
            let [a, b, c, d] = &self.fields()[*old as usize];
            part.fields_mut().push([renamed(a)?, renamed(b)?, renamed(c)?, renamed(d)?]);
        }
        Some(part)
    }
}
