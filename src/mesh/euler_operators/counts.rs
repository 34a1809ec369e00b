//! The six numbers of Euler and Poincaré, and the lattice of their changes.

use std::iter::Sum;
use std::ops::{Add, Mul};

/// The numbers of a boundary, or what is added to them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Counts {
    /// V, vertices.
    pub v: i64,
    /// E, edges.
    pub e: i64,
    /// F, faces.
    pub f: i64,
    /// H, rings: loops but the faces' outer ones.
    pub h: i64,
    /// C, shells: connected components.
    pub c: i64,
    /// G, handles: the sum of the shells' genera.
    pub g: i64,
}

/// The changes of mvfs, mev, mef, kemr and kfmrh, in this order.
#[rustfmt::skip]
pub const BASIS: [Counts; 5] = [
    Counts { v: 1, e:  0, f:  1, h: 0, c: 1, g: 0 },
    Counts { v: 1, e:  1, f:  0, h: 0, c: 0, g: 0 },
    Counts { v: 0, e:  1, f:  1, h: 0, c: 0, g: 0 },
    Counts { v: 0, e: -1, f:  0, h: 1, c: 0, g: 0 },
    Counts { v: 0, e:  0, f: -1, h: 1, c: 0, g: 1 },
];

impl Counts {
    /// NE = V − E + F − H, the Euler number: χ. The faces need to be discs for V − E + F to be it.
    #[doc(alias = "ME-115")]
    pub fn euler_number(&self) -> i128 {
        let [v, e, f, h, ..] = self.wide();
        v - e + f - h
    }

    /// V − E + F − H − 2(C − G), which is 0 for every boundary and every operator.
    #[doc(alias = "ME-107")]
    pub fn balance(&self) -> i128 {
        let [.., c, g] = self.wide();
        self.euler_number() - 2 * (c - g)
    }

    /// How often mvfs, mev, mef, kemr and kfmrh add up to these numbers, a negative number counting inverses. It is
    /// (C, V − C, F − C + G, H − G, G), the only solution; `None` iff the balance is not 0. So the five are a basis of the
    /// integer solutions of V − E + F − H = 2(C − G).
    #[doc(alias = "ME-108")]
    pub fn in_basis(&self) -> Option<[i128; 5]> {
        let [v, _, f, h, c, g] = self.wide();
        (self.balance() == 0).then_some([c, v - c, f - c + g, h - g, g])
    }

    /// The six numbers, in an integer type in which the formulas cannot overflow.
    fn wide(&self) -> [i128; 6] {
        [self.v, self.e, self.f, self.h, self.c, self.g].map(i128::from)
    }
}

impl Add for Counts {
    type Output = Counts;

    fn add(self, o: Counts) -> Counts {
        let (v, e, f) = (self.v + o.v, self.e + o.e, self.f + o.f);
        Counts { v, e, f, h: self.h + o.h, c: self.c + o.c, g: self.g + o.g }
    }
}

impl Mul<i64> for Counts {
    type Output = Counts;

    fn mul(self, n: i64) -> Counts {
        Counts { v: n * self.v, e: n * self.e, f: n * self.f, h: n * self.h, c: n * self.c, g: n * self.g }
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Counts>>(changes: I) -> Counts {
        changes.fold(Counts::default(), Counts::add)
    }
}
