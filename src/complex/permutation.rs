//! Permutations of the four corners of a tetrahedron.

use std::fmt::{self, Display, Formatter};

/// A permutation of 0, 1, 2, 3.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Perm4([u8; 4]);

impl Perm4 {
    /// Every corner where it is.
    pub const IDENTITY: Perm4 = Perm4([0, 1, 2, 3]);

    /// The permutation i ↦ `images[i]`. `None` iff a number is missing.
    pub fn new(images: [u8; 4]) -> Option<Perm4> {
        (0..4).all(|i| images.contains(&i)).then_some(Perm4(images))
    }

    /// The 24 permutations, in the order of their images.
    pub fn all() -> impl Iterator<Item = Perm4> {
        (0..256_u32).filter_map(|n| Perm4::new([n >> 6, n >> 4 & 3, n >> 2 & 3, n & 3].map(|i| i as u8)))
    }

    /// Where corner i goes.
    pub fn image(self, i: usize) -> usize {
        usize::from(self.0[i])
    }

    /// The images of 0, 1, 2, 3.
    pub fn images(self) -> [usize; 4] {
        self.0.map(usize::from)
    }

    /// What undoes it.
    pub fn inverse(self) -> Perm4 {
        let mut inverse = [0; 4];
        (0..4).for_each(|i| inverse[self.image(i)] = i as u8);
        Perm4(inverse)
    }

    /// First `self`, then `next`.
    pub fn then(self, next: Perm4) -> Perm4 {
        Perm4(self.0.map(|i| next.0[usize::from(i)]))
    }

    /// Whether it is a product of an even number of transpositions.
    pub fn is_even(self) -> bool {
        let [a, b, c, d] = self.0;
        // An even number of pairs in the wrong order.
        !((a > b) ^ (a > c) ^ (a > d) ^ (b > c) ^ (b > d) ^ (c > d))
    }
}

impl Display for Perm4 {
    /// Its images, as `0321`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|i| write!(f, "{i}"))
    }
}
