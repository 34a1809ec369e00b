//! Finitely generated abelian groups, such as first homology groups are.

use super::closed_complex::ClosedComplex;
use crate::number::Integer;
use std::fmt::{self, Display, Formatter};

/// ℤ^rank ⊕ ℤ/t₁ ⊕ ℤ/t₂ ⊕ … with 1 < t₁ | t₂ | …, which every finitely generated abelian group is in one way.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AbelianGroup {
    /// How often ℤ stands in it.
    pub rank: usize,
    /// t₁, t₂, …
    pub torsion: Vec<Integer>,
}

impl AbelianGroup {
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

    /// Whether the torsion is A ⊕ A for some A: that of H₁ is, if a closed orientable 3-manifold lies in ℝ⁴ without crossing itself
    /// (CX-89).
    #[doc(alias = "CX-91")]
    pub fn torsion_is_double(&self) -> bool {
        // With t₁ | t₂ | … the two summands A have every other coefficient.
        self.torsion.chunks(2).all(|pair| pair.len() == 2 && pair[0] == pair[1])
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
    /// H₁ over ℤ, from the boundaries of its cells. Of a manifold the dual cells have the same (CX-7).
    #[doc(alias = "CX-7")]
    pub fn first_homology(&self) -> AbelianGroup {
        let mut homology = self.chain_complex().homology();
        AbelianGroup { rank: homology.betti[1], torsion: homology.torsion.swap_remove(1) }
    }
}
