//! A second derivation of the operators: faces are lists of words, loops are words of half-edges up to rotation, and
//! vertices are what the words make them. An operator is a surgery on words; it is allowed iff it changes the six
//! numbers, counted anew, as the table says.

use isoracle::mesh::euler_operators::{Boundary, Corner, Counts, FaceId, HalfEdge, LoopId, Operator, Span};
use std::collections::{BTreeMap, BTreeSet};

/// Faces, each with its loops, the outer one first; an empty loop is a lone vertex. Half-edges 2k and 2k + 1 are mates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Words(pub Vec<Vec<Vec<u32>>>);

fn word(b: &Boundary, l: LoopId) -> Vec<u32> {
    b.cycle(l).into_iter().map(|h| h.0).collect()
}

impl Words {
    pub fn of(b: &Boundary) -> Words {
        let loops = |f: FaceId| b.outer(f).into_iter().chain(b.rings(f)).map(|l| word(b, l)).collect();
        Words(b.faces().map(loops).collect())
    }

    /// The same, with each loop from its smallest half-edge, rings and faces sorted.
    pub fn sorted(mut self) -> Words {
        for loops in &mut self.0 {
            for word in loops.iter_mut() {
                let first = (0..word.len()).min_by_key(|&i| word[i]).unwrap_or(0);
                word.rotate_left(first);
            }
            loops[1..].sort();
        }
        self.0.sort();
        self
    }

    pub fn letters(&self) -> impl Iterator<Item = u32> {
        self.0.iter().flatten().flatten().copied()
    }

    /// Each letter's next one.
    pub fn next(&self) -> BTreeMap<u32, u32> {
        let pairs = |word: &Vec<u32>| -> Vec<(u32, u32)> {
            (0..word.len()).map(|i| (word[i], word[(i + 1) % word.len()])).collect()
        };
        self.0.iter().flatten().flat_map(pairs).collect()
    }

    /// For each letter the smallest one that begins at its vertex.
    pub fn vertices(&self) -> BTreeMap<u32, u32> {
        let next = self.next();
        let mut vertex = BTreeMap::new();
        for &start in next.keys() {
            let mut h = start;
            while !vertex.contains_key(&h) {
                vertex.insert(h, start);
                h = next[&(h ^ 1)];
            }
        }
        vertex
    }

    /// For each face the first one of its component: colours spread until nothing changes.
    pub fn components(&self) -> Vec<usize> {
        let mut colour: Vec<usize> = (0..self.0.len()).collect();
        let face: BTreeMap<u32, usize> =
            self.0.iter().enumerate().flat_map(|(f, loops)| loops.iter().flatten().map(move |h| (*h, f))).collect();
        loop {
            let before = colour.clone();
            for (h, f) in &face {
                let least = colour[*f].min(colour[face[&(h ^ 1)]]);
                colour[*f] = least;
            }
            if before == colour {
                return colour;
            }
        }
    }

    /// V, E, F, H, C, G: the genus of a component is 1 − χ/2.
    pub fn counts(&self) -> Counts {
        let (vertex, component) = (self.vertices(), self.components());
        let components: BTreeSet<usize> = component.iter().copied().collect();
        let lone = |loops: &[Vec<u32>]| loops.iter().filter(|word| word.is_empty()).count() as i64;
        let mut counts = Counts { c: components.len() as i64, ..Counts::default() };
        for part in components {
            let faces: Vec<_> = (0..self.0.len()).filter(|f| component[*f] == part).map(|f| &self.0[f]).collect();
            let letters: Vec<u32> = faces.iter().flat_map(|loops| loops.iter().flatten().copied()).collect();
            let at: BTreeSet<u32> = letters.iter().map(|h| vertex[h]).collect();
            let v = at.len() as i64 + faces.iter().map(|loops| lone(loops)).sum::<i64>();
            let e = letters.len() as i64 / 2;
            let (f, loops) = (faces.len() as i64, faces.iter().map(|loops| loops.len() as i64).sum::<i64>());
            let chi = v - e + 2 * f - loops;
            assert!(chi % 2 == 0 && chi <= 2, "a closed oriented surface");
            counts = counts + Counts { v, e, f, h: loops - f, c: 0, g: (2 - chi) / 2 };
        }
        counts
    }

    /// The face and the place in it of the loop with that letter, and the place in the loop.
    fn find(&self, letter: HalfEdge) -> Option<(usize, usize, usize)> {
        let all =
            self.0.iter().enumerate().flat_map(|(f, loops)| loops.iter().enumerate().map(move |(l, w)| (f, l, w)));
        all.into_iter().find_map(|(f, l, word)| Some((f, l, word.iter().position(|h| *h == letter.0)?)))
    }

    /// The letters from that one on, around its loop.
    fn from(&self, letter: HalfEdge) -> Option<Vec<u32>> {
        let (f, l, i) = self.find(letter)?;
        let mut word = self.0[f][l].clone();
        word.rotate_left(i);
        Some(word)
    }
}

fn place(b: &Boundary, l: LoopId) -> Option<(usize, usize)> {
    let face = b.face_of(l)?;
    let f = b.faces().position(|g| g == face)?;
    let loops = b.outer(face).into_iter().chain(b.rings(face));
    Some((f, loops.into_iter().position(|m| m == l)?))
}

/// The loop of a corner, and its letters from there on.
fn corner(b: &Boundary, words: &Words, corner: Corner) -> Option<(usize, usize, Vec<u32>)> {
    match corner {
        Corner::Before(h) => {
            let (f, l, _) = words.find(h)?;
            Some((f, l, words.from(h)?))
        }
        Corner::Alone(v) => {
            let l = b.loops().find(|l| b.alone(*l) == Some(v))?;
            let (f, l) = place(b, l)?;
            Some((f, l, Vec::new()))
        }
    }
}

/// What an operator with unused names makes of a boundary; `None` where it is not allowed.
pub fn applied(b: &Boundary, operator: &Operator) -> Option<Words> {
    let words = Words::of(b);
    let result = surgery(b, &words, operator)?;
    // Where letters meet that were of no common vertex, the numbers differ from the table's.
    let [before, after] = [&words, &result].map(Words::counts);
    (before + operator.change() == after).then(|| result.sorted())
}

fn surgery(b: &Boundary, words: &Words, operator: &Operator) -> Option<Words> {
    let mut made = words.clone();
    match operator {
        Operator::Mvfs { .. } => made.0.push(vec![vec![]]),
        Operator::Kvfs { shell } => {
            let of_shell = |i: &usize| b.faces().nth(*i).and_then(|f| b.shell_of(f)) == Some(*shell);
            let faces: Vec<usize> = (0..words.0.len()).filter(of_shell).collect();
            let [f] = faces[..] else { return None };
            let is_sphere = made.0.remove(f) == [Vec::<u32>::new()];
            return is_sphere.then_some(made);
        }
        Operator::Mev { span, half_edge, .. } => {
            let [x, y] = [half_edge.0, half_edge.mate().0];
            match *span {
                Span::NothingAt(at) => {
                    let (f, l, rest) = corner(b, words, at)?;
                    made.0[f][l] = [vec![x, y], rest].concat();
                }
                Span::AllFrom(a) => {
                    let (f, l, rest) = corner(b, words, Corner::Before(a))?;
                    made.0[f][l] = [vec![y, x], rest].concat();
                }
                Span::Between(a, b) => {
                    for (at, new) in [(a, x), (b, y)] {
                        let (f, l, i) = made.find(at)?;
                        made.0[f][l].insert(i, new);
                    }
                    if a == b {
                        return None;
                    }
                }
            }
        }
        Operator::Kev { half_edge } => {
            words.find(*half_edge)?;
            made.0.iter_mut().flatten().for_each(|word| word.retain(|h| h / 2 != half_edge.0 / 2));
        }
        Operator::Mef { span, half_edge, rings, .. } => {
            let (at, new_part, old_part) = match *span {
                Span::NothingAt(at) => (at, vec![], corner(b, words, at)?.2),
                Span::AllFrom(a) => (Corner::Before(a), words.from(a)?, vec![]),
                Span::Between(a, b) => {
                    let word = words.from(a)?;
                    let (new, old) = word.split_at(word.iter().position(|h| *h == b.0).filter(|i| *i > 0)?);
                    (Corner::Before(a), new.to_vec(), old.to_vec())
                }
            };
            let (f, l, _) = corner(b, words, at)?;
            let places: Option<Vec<(usize, usize)>> = rings.iter().map(|ring| place(b, *ring)).collect();
            if places.as_ref()?.iter().any(|&(g, m)| g != f || m == 0 || m == l) {
                return None;
            }
            made.0[f][l] = [old_part, vec![half_edge.0]].concat();
            let moved = places?.into_iter().map(|(_, m)| words.0[f][m].clone());
            let face: Vec<Vec<u32>> =
                [[new_part, vec![half_edge.mate().0]].concat()].into_iter().chain(moved).collect();
            let is_moved = |m: usize| rings.iter().any(|ring| place(b, *ring) == Some((f, m)));
            made.0[f] = (0..made.0[f].len()).filter(|m| !is_moved(*m)).map(|m| made.0[f][m].clone()).collect();
            made.0.push(face);
        }
        Operator::Kef { half_edge: y } => {
            let ((f, l, _), (g, m, _)) = (words.find(y.mate())?, words.find(*y)?);
            if f == g || m != 0 {
                return None;
            }
            made.0[f][l] = [&words.from(y.mate())?[1..], &words.from(*y)?[1..]].concat();
            made.0[f].extend(words.0[g][1..].to_vec());
            made.0.remove(g);
        }
        Operator::Kemr { half_edge: x, .. } => {
            let ((f, l, _), word) = (words.find(*x)?, words.from(*x)?);
            let (ring, stays) = word.split_at(word.iter().position(|h| *h == x.mate().0)?);
            made.0[f][l] = stays[1..].to_vec();
            made.0[f].push(ring[1..].to_vec());
        }
        Operator::Mekr { from, to, half_edge: x } => {
            let ((f, l, stays), (g, m, ring)) = (corner(b, words, *from)?, corner(b, words, *to)?);
            if f != g || l == m || m == 0 {
                return None;
            }
            made.0[f][l] = [vec![x.0], ring, vec![x.mate().0], stays].concat();
            made.0[f].remove(m);
        }
        Operator::Kfmrh { face, into } | Operator::Ksfmr { face, into } => {
            let [g, f] = [face, into].map(|face| b.faces().position(|f| f == *face));
            let (g, f) = (g?, f?);
            let [ring] = &words.0[g][..] else { return None };
            if g == f {
                return None;
            }
            made.0[f].push(ring.clone());
            made.0.remove(g);
        }
        Operator::Mfkrh { ring, .. } | Operator::Msfkr { ring, .. } => {
            let (f, l) = place(b, *ring).filter(|(_, l)| *l > 0)?;
            let ring = made.0[f].remove(l);
            made.0.push(vec![ring]);
        }
    }
    Some(made)
}
