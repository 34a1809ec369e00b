//! Finitely generated abelian groups, up to isomorphism.

use super::closed_complex::ClosedComplex;
use crate::mesh::homology::{Homology, divisors};
use crate::number::Integer;
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

/// ℤ^rank ⊕ ℤ/t₁ ⊕ ℤ/t₂ ⊕ … with 1 < t₁ | t₂ | … Two groups are isomorphic iff they are equal.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
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

    /// The sum of the two.
    pub fn sum(&self, other: &AbelianGroup) -> AbelianGroup {
        let mut torsion = [&self.torsion[..], &other.torsion].concat();
        // ℤ/a ⊕ ℤ/b is ℤ/gcd ⊕ ℤ/lcm.
        for i in 0..torsion.len() {
            for j in i + 1..torsion.len() {
                let gcd = Integer::from(torsion[i].gcd_ref(&torsion[j]));
                let lcm = Integer::from(torsion[i].lcm_ref(&torsion[j]));
                (torsion[i], torsion[j]) = (gcd, lcm);
            }
        }
        torsion.retain(|t| *t != 1);
        AbelianGroup { rank: self.rank + other.rank, torsion }
    }

    /// Whether it has one element only.
    pub fn is_trivial(&self) -> bool {
        self.rank == 0 && self.torsion.is_empty()
    }
}

impl Display for AbelianGroup {
    /// `0`, `ℤ`, `ℤ² ⊕ ℤ/2 ⊕ ℤ/4`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let free = match self.rank {
            0 => None,
            1 => Some("ℤ".to_owned()),
            rank => Some(format!("ℤ{}", superscript(rank))),
        };
        let parts: Vec<String> = free.into_iter().chain(self.torsion.iter().map(|t| format!("ℤ/{t}"))).collect();
        f.write_str(if parts.is_empty() { "0" } else { "" })?;
        f.write_str(&parts.join(" ⊕ "))
    }
}

fn superscript(n: usize) -> String {
    let digit = |c: char| match c {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32(u32::from('⁰') + c.to_digit(10).expect("a digit")).expect("superscripts stand in a row"),
    };
    n.to_string().chars().map(digit).collect()
}

impl ClosedComplex {
    /// H₁ over ℤ, from the boundaries of its cells. Of a manifold the dual cells have the same (CX-408).
    #[doc(alias = "CX-408")]
    pub fn first_homology(&self) -> AbelianGroup {
        let mut homology = self.chain_complex().homology();
        AbelianGroup { rank: homology.betti[1], torsion: homology.torsion.swap_remove(1) }
    }
}
