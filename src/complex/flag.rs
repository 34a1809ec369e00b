//! Flags: a vertex, an edge, a face and a polyhedron, each a part of the next. The whole of a cell complex is how flags
//! that differ in one cell are joined.

use crate::partition::Partition;

/// The number of a flag.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Flag(pub u32);

/// The flags of a closed 3-complex: σ_k takes a flag to the one that differs from it in its cell of dimension k alone.
///
/// σ_k has no fixed flag and is its own inverse, and σ₀σ₂, σ₀σ₃, σ₁σ₃ are their own inverses. A flag is also a tetrahedron
/// of the barycentric subdivision, σ_k its neighbour across the face that lies opposite the vertex of dimension k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flags {
    /// By k, then by flag.
    sigma: [Vec<u32>; 4],
}

/// What keeps four maps from being those of a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FlagDefect {
    /// σ_k names a flag that does not exist.
    OutOfRange(usize, Flag),
    /// σ_k leaves the flag where it is.
    Fixed(usize, Flag),
    /// σ_k twice does not lead back to the flag.
    NoInvolution(usize, Flag),
    /// σ_i after σ_j is not σ_j after σ_i at the flag, though |i − j| > 1.
    DoNotCommute([usize; 2], Flag),
}

impl Flags {
    /// The flags with these four maps.
    ///
    /// # Errors
    /// The first defect, iff there is one.
    pub fn new(sigma: [Vec<u32>; 4]) -> Result<Flags, FlagDefect> {
        let flags = Flags { sigma };
        match flags.defects().first() {
            None => Ok(flags),
            Some(defect) => Err(*defect),
        }
    }

    /// What keeps the maps from being those of a complex.
    pub fn defects(&self) -> Vec<FlagDefect> {
        let n = self.len();
        let mut defects = Vec::new();
        for (k, sigma) in self.sigma.iter().enumerate() {
            let stray = (0..n).filter(|i| sigma.get(*i).is_none_or(|j| *j as usize >= n));
            defects.extend(stray.map(|i| FlagDefect::OutOfRange(k, Flag(i as u32))));
        }
        if !defects.is_empty() {
            return defects;
        }
        for flag in self.all() {
            for k in 0..4 {
                match self.sigma(k, flag) {
                    same if same == flag => defects.push(FlagDefect::Fixed(k, flag)),
                    other if self.sigma(k, other) != flag => defects.push(FlagDefect::NoInvolution(k, flag)),
                    _ => {}
                }
            }
            for [i, j] in [[0, 2], [0, 3], [1, 3]] {
                if self.sigma(i, self.sigma(j, flag)) != self.sigma(j, self.sigma(i, flag)) {
                    defects.push(FlagDefect::DoNotCommute([i, j], flag));
                }
            }
        }
        defects
    }

    /// How many flags there are.
    pub fn len(&self) -> usize {
        self.sigma[0].len()
    }

    /// Whether there is no flag.
    pub fn is_empty(&self) -> bool {
        self.sigma[0].is_empty()
    }

    /// Every flag.
    pub fn all(&self) -> impl Iterator<Item = Flag> + use<> {
        (0..self.len() as u32).map(Flag)
    }

    /// σ_k: the flag that differs in its cell of dimension k ≤ 3 alone.
    pub fn sigma(&self, k: usize, flag: Flag) -> Flag {
        Flag(self.sigma[k][flag.0 as usize])
    }

    /// A flag taken by one map after the other, the first one first.
    pub fn walk(&self, flag: Flag, maps: &[usize]) -> Flag {
        maps.iter().fold(flag, |flag, k| self.sigma(*k, flag))
    }

    /// The number of each flag's orbit under the maps of these dimensions, numbered by their first flags; and how many
    /// orbits there are. The cells of dimension k are the orbits of the other three maps.
    pub fn orbits(&self, maps: &[usize]) -> (Vec<u32>, usize) {
        let mut parts = Partition::new(self.len());
        for k in maps {
            for (i, j) in self.sigma[*k].iter().enumerate() {
                parts.join(i, *j as usize);
            }
        }
        parts.numbered()
    }

    /// A sign for each flag such that each of these maps changes it, + for the first flag of each orbit.
    /// `None` iff there is none, that is iff a closed walk of these maps has an odd number of steps.
    pub fn signs(&self, maps: &[usize]) -> Option<Vec<bool>> {
        let mut signs: Vec<Option<bool>> = vec![None; self.len()];
        for first in self.all() {
            if signs[first.0 as usize].is_some() {
                continue;
            }
            signs[first.0 as usize] = Some(true);
            let mut pending = vec![first];
            while let Some(flag) = pending.pop() {
                let sign = signs[flag.0 as usize].expect("it has its sign");
                for k in maps {
                    let next = self.sigma(*k, flag);
                    match signs[next.0 as usize] {
                        Some(other) if other == sign => return None,
                        Some(_) => {}
                        None => {
                            signs[next.0 as usize] = Some(!sign);
                            pending.push(next);
                        }
                    }
                }
            }
        }
        Some(signs.into_iter().map(|sign| sign.expect("every flag was reached")).collect())
    }
}
