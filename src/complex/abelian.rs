//! Finitely generated abelian groups, such as first homology groups are.

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
