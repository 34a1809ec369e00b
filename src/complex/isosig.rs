//! Isomorphism signatures: one word for all triangulations that differ only in the names of tetrahedra and corners, letter for
//! letter the one of Regina (B. A. Burton, *Simplification paths in the Pachner graphs of closed orientable 3-manifold
//! triangulations*, 2011).

use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation};
use thiserror::Error;

/// The digits 0 … 63.
const ALPHABET: &[u8; 64] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-";

/// From this size on, a number of a tetrahedron takes several digits.
const SHORT: usize = 63;

/// What becomes of a triangle, as it is come to: 0 would be a border.
const TO_A_NEW_ONE: u8 = 1;
const TO_A_KNOWN_ONE: u8 = 2;

/// The signature of a triangulation. Two triangulations have the same one iff they are isomorphic, which is to say alike up
/// to the numbers of the tetrahedra and of the corners of each.
///
/// That of a connected one of n tetrahedra is the least, by the bytes of ASCII, of 24 n words, one for each tetrahedron to
/// begin with and each order of its corners; of others, those of the components, in order. Of none it is `a`.
/// Takes 96 n² steps: seconds for 1,000 tetrahedra. [`isosig_fast`](super::isosig_fast) gives up most words early.
#[doc(alias = "CX-93")]
pub fn signature(triangulation: &Triangulation) -> String {
    of_components(triangulation, |component| {
        let words = beginnings(component).map(|(begin, labels)| Walk::new(triangulation, begin, labels).word());
        words.min().expect("a component has a tetrahedron")
    })
}

/// The words of the components, in order.
pub(super) fn of_components(triangulation: &Triangulation, word: impl Fn(&[usize]) -> String) -> String {
    let mut seen = vec![false; triangulation.len()];
    let mut words = Vec::new();
    for first in 0..triangulation.len() {
        if seen[first] {
            continue;
        }
        let component = Walk::new(triangulation, first, Perm4::IDENTITY).order;
        component.iter().for_each(|tetrahedron| seen[*tetrahedron] = true);
        words.push(word(&component));
    }
    if words.is_empty() {
        return digit(0).to_string();
    }
    words.sort_unstable();
    words.concat()
}

/// Each tetrahedron with each order of its corners.
pub(super) fn beginnings(component: &[usize]) -> impl Iterator<Item = (usize, Perm4)> {
    component.iter().flat_map(|begin| Perm4::all().map(move |labels| (*begin, labels)))
}

/// A component walked from one tetrahedron, whose corners have new names: triangles in the order of their new names, tetrahedra
/// in the order in which they are come to. One that is new takes the names of its corners from across the triangle.
pub(super) struct Walk {
    /// The tetrahedra as they were come to.
    order: Vec<usize>,
    /// What becomes of each triangle that is not glued to an earlier one.
    actions: Vec<u8>,
    /// The gluings with a tetrahedron that is known already.
    joins: Vec<(usize, Perm4)>,
}

impl Walk {
    /// The walk from that tetrahedron, corner i of which is called `labels`(i).
    fn new(triangulation: &Triangulation, begin: usize, labels: Perm4) -> Walk {
        Walk::so_long_as(triangulation, begin, labels, |_| true).expect("it goes on to its end")
    }

    /// The same, given up as soon as something does not hold of the actions up to there.
    pub(super) fn so_long_as(
        triangulation: &Triangulation,
        begin: usize,
        labels: Perm4,
        mut holds: impl FnMut(&[u8]) -> bool,
    ) -> Option<Walk> {
        let mut walk = Walk { order: vec![begin], actions: Vec::new(), joins: Vec::new() };
        // New number and new names of the corners.
        let mut known = vec![None; triangulation.len()];
        known[begin] = Some((0, labels));
        let mut number = 0;
        while let Some(tetrahedron) = walk.order.get(number).copied() {
            let (_, labels) = known[tetrahedron].expect("it was come to");
            let old = labels.inverse();
            for triangle in 0..4 {
                let gluing = triangulation.gluings()[tetrahedron][old.image(triangle)];
                let other = gluing.tetrahedron as usize;
                match known[other] {
                    None => {
                        known[other] = Some((walk.order.len(), gluing.corners.inverse().then(labels)));
                        walk.order.push(other);
                        walk.actions.push(TO_A_NEW_ONE);
                    }
                    Some((there, names)) => {
                        let corners = old.then(gluing.corners).then(names);
                        if (there, corners.image(triangle)) < (number, triangle) {
                            continue;
                        }
                        walk.actions.push(TO_A_KNOWN_ONE);
                        walk.joins.push((there, corners));
                    }
                }
                if !holds(&walk.actions) {
                    return None;
                }
            }
            number += 1;
        }
        Some(walk)
    }

    /// Size, actions three a digit, tetrahedra joined to, permutations of the joins by their place among the 24.
    pub(super) fn word(&self) -> String {
        let size = self.order.len();
        let width = width(size);
        let mut word = String::new();
        if size >= SHORT {
            word.extend([digit(63), digit(width)]);
        }
        let number = |n: usize| (0..width).map(move |i| digit(n >> (6 * i) & 63));
        word.extend(number(size));
        word.extend(self.actions.chunks(3).map(three));
        self.joins.iter().for_each(|(tetrahedron, _)| word.extend(number(*tetrahedron)));
        word.extend(self.joins.iter().map(|(_, corners)| digit(place(*corners))));
        word
    }
}

/// How many digits the number of a tetrahedron has.
fn width(size: usize) -> usize {
    if size < SHORT { 1 } else { (size.ilog2() / 6 + 1) as usize }
}

/// How many digits stand before the actions.
pub(super) fn before_actions(size: usize) -> usize {
    if size < SHORT { 1 } else { 2 + width(size) }
}

/// Three actions in a digit, the first in its lowest place.
pub(super) fn three(actions: &[u8]) -> char {
    digit(actions.iter().rev().fold(0, |n, action| n << 2 | usize::from(*action)))
}

fn digit(n: usize) -> char {
    char::from(ALPHABET[n])
}

/// Its place among the 24 permutations in the order of their images.
fn place(permutation: Perm4) -> usize {
    let [a, b, c, d] = permutation.images();
    let less = |n: usize, later: &[usize]| later.iter().filter(|m| **m < n).count();
    6 * less(a, &[b, c, d]) + 2 * less(b, &[c, d]) + less(c, &[d])
}

/// Why a text is no signature of a closed triangulation. Positions count the text's characters from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SignatureError {
    /// Another character than those of the alphabet.
    #[error("character {position}: {found:?} is none of a…z, A…Z, 0…9, +, -")]
    NoDigit {
        /// Where.
        position: usize,
        /// What stands there.
        found: char,
    },
    /// The text ends early.
    #[error("character {position}: the text ends where {expected} should follow")]
    Truncated {
        /// Its length.
        position: usize,
        /// What is missing.
        expected: &'static str,
    },
    /// A number of tetrahedra that no machine could hold.
    #[error("character {position}: a number of tetrahedra that is too large")]
    TooLarge {
        /// Where it begins.
        position: usize,
    },
    /// A triangle of the border: the triangulation is not closed.
    #[error("character {position}: a triangle is glued to nothing, and the triangulation is not closed")]
    Border {
        /// Where.
        position: usize,
    },
    /// The digit says of a triangle something other than border, new tetrahedron, known tetrahedron; or says something of more
    /// triangles than there are.
    #[error("character {position}: the digit says of no triangle what becomes of it")]
    NoAction {
        /// Where.
        position: usize,
    },
    /// More new tetrahedra than there are tetrahedra.
    #[error("character {position}: there are only {size} tetrahedra, and one more is said to be new")]
    NoneIsNew {
        /// Where.
        position: usize,
        /// How many there are.
        size: usize,
    },
    /// Not all tetrahedra are come to.
    #[error("character {position}: of {size} tetrahedra only {reached} hang together")]
    NotReached {
        /// Where the component ends.
        position: usize,
        /// How many there should be.
        size: usize,
        /// How many are come to.
        reached: usize,
    },
    /// A gluing with a tetrahedron that is not known yet.
    #[error("character {position}: tetrahedron {tetrahedron} is not known yet, for only {known} are")]
    NotKnown {
        /// Where.
        position: usize,
        /// The tetrahedron.
        tetrahedron: usize,
        /// How many are known.
        known: usize,
    },
    /// A digit past the 24 permutations.
    #[error("character {position}: there is no permutation {place}; there are 24")]
    NoPermutation {
        /// Where.
        position: usize,
        /// The digit.
        place: usize,
    },
    /// A gluing with a triangle that is glued already, or with itself.
    #[error("character {position}: triangle {triangle} of tetrahedron {tetrahedron} is glued already, or to itself")]
    GluedTwice {
        /// Where its permutation stands.
        position: usize,
        /// The tetrahedron, in the component.
        tetrahedron: usize,
        /// Its triangle.
        triangle: usize,
    },
}

/// The triangulation that a signature names. A word that is not the least of its 24 n is read too; a component without
/// tetrahedra is nothing.
///
/// # Errors
/// Iff the text is empty, or describes no closed triangulation by its letters alone; the first reason, with its place. Spaces are none
/// of the letters. Nothing is allocated for a size that the length of the text does not allow.
#[doc(alias = "CX-94")]
pub fn triangulation(signature: &str) -> Result<Triangulation, SignatureError> {
    let mut digits = Vec::new();
    for (position, found) in signature.chars().enumerate() {
        let value = ALPHABET.iter().position(|letter| char::from(*letter) == found);
        digits.push(value.ok_or(SignatureError::NoDigit { position, found })?);
    }
    let mut reader = Reader { digits, position: 0 };
    let mut gluings = Vec::new();
    loop {
        let component = reader.component(gluings.len())?;
        gluings.extend(component);
        if reader.position == reader.digits.len() {
            break;
        }
    }
    Ok(Triangulation::new(gluings).expect("triangles were glued in twos"))
}

struct Reader {
    digits: Vec<usize>,
    position: usize,
}

impl Reader {
    fn digit(&mut self, expected: &'static str) -> Result<usize, SignatureError> {
        let digit = self.digits.get(self.position).copied();
        let digit = digit.ok_or(SignatureError::Truncated { position: self.position, expected })?;
        self.position += 1;
        Ok(digit)
    }

    fn number(&mut self, width: usize, expected: &'static str) -> Result<usize, SignatureError> {
        let position = self.position;
        let mut number = 0;
        for i in 0..width {
            let digit = self.digit(expected)?;
            let shifted = digit.checked_shl(6 * i as u32).filter(|n| n >> (6 * i) == digit);
            number |= if digit == 0 { 0 } else { shifted.ok_or(SignatureError::TooLarge { position })? };
        }
        Ok(number)
    }

    /// The gluings of a component, its tetrahedra numbered from `base` on.
    fn component(&mut self, base: usize) -> Result<Vec<[TriangleGluing; 4]>, SignatureError> {
        let mut width = 1;
        if self.digits.get(self.position) == Some(&63) {
            self.position += 1;
            width = self.digit("the number of digits of a number")?;
        }
        let begin = self.position;
        let size = self.number(width, "the number of tetrahedra")?;
        // A digit speaks of six triangles at most.
        let left = self.digits.len() - self.position;
        if size > left.saturating_mul(6) / 4 {
            return Err(SignatureError::Truncated {
                position: self.digits.len(),
                expected: "what becomes of triangles",
            });
        }
        u32::try_from(base + size).map_err(|_| SignatureError::TooLarge { position: begin })?;
        let actions = self.actions(size)?;
        let joins = actions.iter().filter(|action| **action == TO_A_KNOWN_ONE).count();
        let mut others = Vec::new();
        for _ in 0..joins {
            others.push((self.position, self.number(width, "a tetrahedron")?));
        }
        let mut corners = Vec::new();
        for _ in 0..joins {
            let (position, place) = (self.position, self.digit("a permutation")?);
            let permutation = Perm4::all().nth(place).ok_or(SignatureError::NoPermutation { position, place })?;
            corners.push((position, permutation));
        }
        let joins: Vec<Join> = others.into_iter().zip(corners).collect();
        self.glued(base, size, &actions, &joins)
    }

    /// What becomes of the triangles, until each is spoken of.
    fn actions(&mut self, size: usize) -> Result<Vec<u8>, SignatureError> {
        let (mut actions, mut triangles, mut reached) = (Vec::new(), 0, 1);
        while triangles < 4 * size {
            let (position, digit) = (self.position, self.digit("what becomes of triangles")?);
            for i in 0..3 {
                match (digit >> (2 * i) & 3, triangles == 4 * size) {
                    // The last digit is filled up with zeros.
                    (0, true) => {}
                    (_, true) | (3.., false) => return Err(SignatureError::NoAction { position }),
                    (0, false) => return Err(SignatureError::Border { position }),
                    (1, false) if reached == size => return Err(SignatureError::NoneIsNew { position, size }),
                    (action @ (1 | 2), false) => {
                        reached += usize::from(action == 1);
                        actions.push(action as u8);
                        triangles += 2;
                    }
                }
            }
        }
        if reached < size {
            return Err(SignatureError::NotReached { position: self.position, size, reached });
        }
        Ok(actions)
    }

    fn glued(
        &self,
        base: usize,
        size: usize,
        actions: &[u8],
        joins: &[Join],
    ) -> Result<Vec<[TriangleGluing; 4]>, SignatureError> {
        let mut glued: Vec<[Option<TriangleGluing>; 4]> = vec![[None; 4]; size];
        let (mut actions, mut joins, mut known) = (actions.iter(), joins.iter(), 1);
        for tetrahedron in 0..size {
            if tetrahedron == known {
                return Err(SignatureError::NotReached { position: self.position, size, reached: known });
            }
            for triangle in 0..4 {
                if glued[tetrahedron][triangle].is_some() {
                    continue;
                }
                let action = actions.next().expect("two triangles are glued by each");
                let (other, corners) = if *action == TO_A_NEW_ONE {
                    known += 1;
                    (known - 1, Perm4::IDENTITY)
                } else {
                    let ((position, other), (place, corners)) = *joins.next().expect("they were counted");
                    if other >= known {
                        return Err(SignatureError::NotKnown { position, tetrahedron: other, known });
                    }
                    let across = corners.image(triangle);
                    if glued[other][across].is_some() || (other, across) == (tetrahedron, triangle) {
                        let [tetrahedron, triangle] = [other, across];
                        return Err(SignatureError::GluedTwice { position: place, tetrahedron, triangle });
                    }
                    (other, corners)
                };
                let gluing = |tetrahedron: usize, corners| {
                    Some(TriangleGluing { tetrahedron: (base + tetrahedron) as u32, corners })
                };
                glued[tetrahedron][triangle] = gluing(other, corners);
                glued[other][corners.image(triangle)] = gluing(tetrahedron, corners.inverse());
            }
        }
        let whole = glued.into_iter().map(|triangles| triangles.map(|gluing| gluing.expect("each was glued")));
        Ok(whole.collect())
    }
}

/// A tetrahedron and a permutation, each with its place in the text.
type Join = ((usize, usize), (usize, Perm4));
