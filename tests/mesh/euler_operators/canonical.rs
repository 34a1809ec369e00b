//! Boundaries up to the names: a code that two have in common iff they are isomorphic, and homology without χ.

use super::words::Words;
use std::collections::BTreeMap;

/// The codes of the components, sorted.
pub fn code(words: &Words) -> Vec<Vec<u32>> {
    let mut codes: Vec<Vec<u32>> = components(words).iter().map(|part| of_component(part).0).collect();
    codes.sort();
    codes
}

/// How many half-edges a component can be begun at with the same code: the order of its symmetry group, where it has
/// half-edges, as a symmetry that leaves one of them in place leaves all of a face without rings in place.
pub fn symmetries(component: &Words) -> usize {
    of_component(component).1
}

fn components(words: &Words) -> Vec<Words> {
    let of = words.components();
    let mut parts: BTreeMap<usize, Vec<Vec<Vec<u32>>>> = BTreeMap::new();
    for (loops, part) in words.0.iter().zip(of) {
        parts.entry(part).or_default().push(loops.clone());
    }
    parts.into_values().map(Words).collect()
}

/// What is numbered: a half-edge, or an empty loop by its face and its place there.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Item {
    HalfEdge(u32),
    Lone(usize, usize),
}

struct Walker<'a> {
    words: &'a Words,
    next: BTreeMap<u32, u32>,
    place: BTreeMap<u32, (usize, usize)>,
    best: Vec<u32>,
    times: usize,
}

/// The least code over all places to begin, and for each face over all ways to go on with its other loops.
fn of_component(words: &Words) -> (Vec<u32>, usize) {
    let mut place = BTreeMap::new();
    for (f, loops) in words.0.iter().enumerate() {
        for (l, word) in loops.iter().enumerate() {
            place.extend(word.iter().map(|h| (*h, (f, l))));
        }
    }
    let mut walker = Walker { words, next: words.next(), place, best: Vec::new(), times: 0 };
    for f in 0..words.0.len() {
        for l in 0..words.0[f].len() {
            walker.begin(f, l, Vec::new());
        }
    }
    (walker.best, walker.times)
}

impl Walker<'_> {
    /// Goes on at each half-edge of a loop.
    fn begin(&mut self, f: usize, l: usize, order: Vec<Item>) {
        let word = &self.words.0[f][l];
        let lone = word.is_empty().then_some(Item::Lone(f, l));
        for item in word.iter().map(|h| Item::HalfEdge(*h)).chain(lone) {
            self.walk(order.iter().copied().chain([item]).collect());
        }
    }

    fn walk(&mut self, mut order: Vec<Item>) {
        let place = |item: Item| match item {
            Item::HalfEdge(h) => self.place[&h],
            Item::Lone(f, l) => (f, l),
        };
        let mut number: BTreeMap<Item, u32> = order.iter().copied().zip(0..).collect();
        let mut i = 0;
        while i < order.len() {
            if let Item::HalfEdge(h) = order[i] {
                for other in [self.next[&h], h ^ 1].map(Item::HalfEdge) {
                    let free = number.len() as u32;
                    number.entry(other).or_insert_with(|| {
                        order.push(other);
                        free
                    });
                }
            }
            i += 1;
        }
        let mut faces: Vec<usize> = Vec::new();
        for &item in &order {
            if !faces.contains(&place(item).0) {
                faces.push(place(item).0);
            }
        }
        let is_seen = |f: usize, l: usize| order.iter().any(|item| place(*item) == (f, l));
        let open =
            faces.iter().map(|&f| (f, (0..self.words.0[f].len()).filter(|&l| !is_seen(f, l)).collect::<Vec<_>>()));
        let open = open.into_iter().find(|(_, loops)| !loops.is_empty());
        if let Some((f, loops)) = open {
            for l in loops {
                self.begin(f, l, order.clone());
            }
            return;
        }
        let mut code = Vec::new();
        for &item in &order {
            let (f, l) = place(item);
            let face = faces.iter().position(|g| *g == f).expect("all are there") as u32;
            let [next, mate] = match item {
                Item::HalfEdge(h) => [self.next[&h], h ^ 1].map(|h| number[&Item::HalfEdge(h)]),
                Item::Lone(..) => [u32::MAX; 2],
            };
            code.extend([next, mate, 2 * face + u32::from(l == 0)]);
        }
        if self.times > 0 && code == self.best {
            self.times += 1;
        } else if self.times == 0 || code < self.best {
            (self.best, self.times) = (code, 1);
        }
    }
}

/// b0, b1, b2: the ranks of homology, by elimination modulo a prime. Each ring is joined to its face's outer loop by a cut,
/// so that faces are discs; a cut is run along twice, in opposite directions. b2 = b0 iff every component is orientable.
pub fn betti(words: &Words) -> [i64; 3] {
    let vertex = words.vertices();
    let mut number: BTreeMap<(u32, usize, usize), usize> = BTreeMap::new();
    let mut at = |f: usize, l: usize, word: &[u32]| {
        let key = word.first().map_or((u32::MAX, f, l), |h| (vertex[h], 0, 0));
        let free = number.len();
        *number.entry(key).or_insert(free)
    };
    let mut cuts = Vec::new();
    for (f, loops) in words.0.iter().enumerate() {
        let ends: Vec<usize> = loops.iter().enumerate().map(|(l, word)| at(f, l, word)).collect();
        cuts.extend(ends[1..].iter().map(|end| [ends[0], *end]));
    }
    let edges: Vec<u32> = words.letters().filter(|h| h % 2 == 0).collect();
    let ends = edges.iter().map(|h| [*h, h ^ 1].map(|h| at(0, 0, &[h])));
    let ends: Vec<[usize; 2]> = ends.chain(cuts).collect();
    let v = number.len();
    let border_of_edge = |[a, b]: &[usize; 2]| {
        let mut row = vec![0i64; v];
        row[*a] -= 1;
        row[*b] += 1;
        row
    };
    let border_of_face = |loops: &Vec<Vec<u32>>| {
        let uses = |h: u32| loops.iter().flatten().filter(|g| **g == h).count() as i64;
        edges.iter().map(|h| uses(*h) - uses(h ^ 1)).collect::<Vec<i64>>()
    };
    let one = rank(ends.iter().map(border_of_edge).collect());
    let two = rank(words.0.iter().map(border_of_face).collect());
    [v as i64 - one, ends.len() as i64 - one - two, words.0.len() as i64 - two]
}

const PRIME: i64 = 1_000_003;

/// The rank modulo a prime. Of a matrix with entries 0, ±1 and at most one of each sign in a column it is the rational one.
fn rank(mut rows: Vec<Vec<i64>>) -> i64 {
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] % PRIME != 0) else { continue };
        rows.swap(rank, pivot);
        let pivot = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = row[column];
            if factor != 0 {
                for (entry, p) in row.iter_mut().zip(&pivot) {
                    *entry = (*entry * pivot[column] - factor * p) % PRIME;
                }
            }
        }
        rank += 1;
    }
    rank as i64
}
