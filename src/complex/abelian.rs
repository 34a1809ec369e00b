//! Finitely generated abelian groups, up to isomorphism.

use crate::mesh::homology::{Homology, divisors};
use crate::number::Integer;
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

/// ℤ^rank ⊕ ℤ/t₁ ⊕ ℤ/t₂ ⊕ … with 1 < t₁ | t₂ | … Two groups are isomorphic iff they are equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AbelianGroup {
    /// The number of summands ℤ.
    pub rank: usize,
    /// The orders of the finite cyclic summands.
    pub torsion: Vec<Integer>,
}

impl AbelianGroup {
    /// The group of so many generators with these relations: each the coefficients, by generator, of a sum that is 0.
    pub fn of_relations(generators: usize, relations: Vec<BTreeMap<usize, Integer>>) -> AbelianGroup {
        let divisors = divisors(relations);
        let rank = generators - divisors.len();
        AbelianGroup { rank, torsion: divisors.into_iter().filter(|t| *t != 1).collect() }
    }

    /// H_k; the group 0 above the dimension.
    pub fn homology(homology: &Homology, k: usize) -> AbelianGroup {
        AbelianGroup {
            rank: homology.betti.get(k).copied().unwrap_or(0),
            torsion: homology.torsion.get(k).cloned().unwrap_or_default(),
        }
    }

    /// Whether its torsion is A ⊕ A for a group A (CX-317). H₁ of an orientable closed 3-manifold in four dimensions is so.
    #[doc(alias = "CX-317")]
    pub fn has_doubled_torsion(&self) -> bool {
        self.torsion.len().is_multiple_of(2) && self.torsion.chunks(2).all(|pair| pair[0] == pair[1])
    }

    /// Whether it has one element only.
    pub fn is_trivial(&self) -> bool {
        self.rank == 0 && self.torsion.is_empty()
    }
}

impl Display for AbelianGroup {
    /// `ℤ^2 ⊕ ℤ/2 ⊕ ℤ/4`, and `0`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let free = match self.rank {
            0 => None,
            1 => Some("ℤ".to_owned()),
            rank => Some(format!("ℤ^{rank}")),
        };
        let summands: Vec<String> = free.into_iter().chain(self.torsion.iter().map(|t| format!("ℤ/{t}"))).collect();
        f.write_str(if summands.is_empty() { "0" } else { "" })?;
        f.write_str(&summands.join(" ⊕ "))
    }
}
