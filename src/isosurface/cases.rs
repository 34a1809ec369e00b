//! The 33 cases of marching cubes, by Chernyaev's names.

use super::cell::Decisions;
use super::cube::{Corner, Edge, Face};

macro_rules! cases {
    ($($variant:ident $name:literal),* $(,)?) => {
        /// A case of marching cubes 33: the cell up to rotation, reflection (but 11 from 14 and 12.2 from
        /// 12.3) and exchange of inside and outside.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Case { $(#[doc = concat!("Case ", $name, ".")] $variant),* }

        impl Case {
            /// All of them, in Chernyaev's order.
            pub const ALL: &[Case] = &[$(Case::$variant),*];

            /// Chernyaev's name, such as "13.5.2".
            pub const fn name(self) -> &'static str {
                match self { $(Case::$variant => $name),* }
            }
        }
    };
}

cases! {
    C0 "0", C1 "1", C2 "2", C3_1 "3.1", C3_2 "3.2", C4_1 "4.1", C4_2 "4.2", C5 "5", C6_1_1 "6.1.1", C6_1_2 "6.1.2",
    C6_2 "6.2", C7_1 "7.1", C7_2 "7.2", C7_3 "7.3", C7_4_1 "7.4.1", C7_4_2 "7.4.2", C8 "8", C9 "9",
    C10_1_1 "10.1.1", C10_1_2 "10.1.2", C10_2 "10.2", C11 "11", C12_1_1 "12.1.1", C12_1_2 "12.1.2", C12_2 "12.2",
    C12_3 "12.3", C13_1 "13.1", C13_2 "13.2", C13_3 "13.3", C13_4 "13.4", C13_5_1 "13.5.1", C13_5_2 "13.5.2", C14 "14",
}

impl std::fmt::Display for Case {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}

impl std::str::FromStr for Case {
    type Err = UnknownCase;
    fn from_str(name: &str) -> Result<Case, UnknownCase> {
        Case::ALL.iter().copied().find(|case| case.name() == name).ok_or_else(|| UnknownCase(name.to_owned()))
    }
}

/// A name that is none of the 33.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0:?} is none of the 33 cases")]
pub struct UnknownCase(String);

impl Case {
    /// The case of a cell with these decisions (IS-82); one corner of its own sign is case 1 (IS-55).
    #[doc(alias = "IS-55")]
    #[doc(alias = "IS-82")]
    pub fn of(decisions: &Decisions) -> Case {
        // The fewer corners of one sign give the case its shape; of four and four, the positive ones.
        let minority_is_positive = decisions.positive.count_ones() <= 4;
        let minority = if minority_is_positive { decisions.positive } else { !decisions.positive };
        let within: Vec<Edge> =
            Edge::ALL.into_iter().filter(|e| e.corners().iter().all(|c| minority & c.bit() != 0)).collect();
        let own = if minority_is_positive { 1 } else { -1 };
        let joining = decisions.faces.iter().filter(|&&sign| sign == own).count();
        let ambiguous = decisions.faces.iter().filter(|&&sign| sign != 0).count();
        let tunnel = decisions.tunnel.is_some();
        match (minority.count_ones(), within.len()) {
            (0, _) => Case::C0,
            (1, _) => Case::C1,
            (2, 1) => Case::C2,
            (2, _) => match (ambiguous, joining, tunnel) {
                (0, _, false) => Case::C4_1,
                (0, _, true) => Case::C4_2,
                (_, 0, _) => Case::C3_1,
                (_, _, _) => Case::C3_2,
            },
            (3, 2) => Case::C5,
            (3, 1) => match (joining, tunnel) {
                (0, false) => Case::C6_1_1,
                (0, true) => Case::C6_1_2,
                (_, _) => Case::C6_2,
            },
            (3, _) => match (joining, tunnel) {
                (0, _) => Case::C7_1,
                (1, _) => Case::C7_2,
                (2, _) => Case::C7_3,
                (_, false) => Case::C7_4_1,
                (_, true) => Case::C7_4_2,
            },
            (_, 4) => Case::C8,
            (_, 3) => path_of_three(&within).map_or(Case::C9, |turn| if turn > 0 { Case::C11 } else { Case::C14 }),
            (_, 2) => match (shared_corner(within[0], within[1]), joining, tunnel) {
                (None, 1, _) => Case::C10_2,
                (None, _, false) => Case::C10_1_1,
                (None, _, true) => Case::C10_1_2,
                (Some(_), 1, _) => {
                    if twelve_turns_right(decisions, &within) {
                        Case::C12_2
                    } else {
                        Case::C12_3
                    }
                }
                (Some(_), _, false) => Case::C12_1_1,
                (Some(_), _, true) => Case::C12_1_2,
            },
            (_, _) => match (joining, decisions.is_odd_thirteen(), tunnel) {
                (0 | 6, _, _) => Case::C13_1,
                (1 | 5, _, _) => Case::C13_2,
                (2 | 4, _, _) => Case::C13_3,
                (_, false, _) => Case::C13_4,
                (_, true, false) => Case::C13_5_1,
                (_, true, true) => Case::C13_5_2,
            },
        }
    }
}

fn shared_corner(a: Edge, b: Edge) -> Option<Corner> {
    a.corners().into_iter().find(|c| b.corners().contains(c))
}

fn direction(from: Corner, to: Corner) -> [i32; 3] {
    let (from, to) = (from.position(), to.position());
    [0, 1, 2].map(|i| i32::from(to[i]) - i32::from(from[i]))
}

fn outward(face: Face) -> [i32; 3] {
    let mut normal = [0; 3];
    normal[face.axis()] = if face.side() == 0 { -1 } else { 1 };
    normal
}

fn triple([a, b, c]: [[i32; 3]; 3]) -> i32 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The handedness of three edges that make a path, ±1; `None` where they meet in one corner.
fn path_of_three(edges: &[Edge]) -> Option<i32> {
    let middle = *edges.iter().find(|m| {
        let others = edges.iter().filter(|e| e != m);
        let touched: Vec<_> = others.filter_map(|e| shared_corner(*e, **m)).collect();
        touched.len() == 2 && touched[0] != touched[1]
    })?;
    let [b, c] = middle.corners();
    let beyond = |end: Corner| {
        let edge = edges.iter().find(|e| **e != middle && e.corners().contains(&end)).expect("a path goes on");
        let [p, q] = edge.corners();
        if p == end { q } else { p }
    };
    Some(triple([direction(beyond(b), b), direction(b, c), direction(c, beyond(c))]))
}

/// Cases 12.2 and 12.3 are mirror images: the faces that join the positive and the negative pair, and
/// the face that holds three positive corners, turn right in the one and left in the other.
fn twelve_turns_right(decisions: &Decisions, within: &[Edge]) -> bool {
    let with = |sign: i8| {
        Face::ALL.into_iter().find(|f| decisions.faces[f.index()] == sign).expect("one face joins each sign")
    };
    let base = Face::ALL.into_iter().find(|f| within.iter().all(|e| e.in_face(*f))).expect("two edges span a face");
    triple([outward(with(1)), outward(with(-1)), outward(base)]) > 0
}

impl Decisions {
    /// In case 13 with three faces of either sign: whether the surface has three loops (13.5), not one
    /// (13.4).
    fn is_odd_thirteen(&self) -> bool {
        let positive: Vec<Face> = Face::ALL.into_iter().filter(|f| self.faces[f.index()] > 0).collect();
        let [a, b, c] = positive[..] else { return false };
        let meeting = |s: u8| {
            Corner::ALL.into_iter().find(|corner| {
                self.is_positive(*corner) == (s == 1)
                    && [a, b, c].iter().all(|f| corner.position()[f.axis()] == f.side())
            })
        };
        // Three positive faces around a positive corner leave it in a region of its own class.
        meeting(0).is_some()
    }
}
