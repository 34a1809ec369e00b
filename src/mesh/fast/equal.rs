//! Equal things among millions: vertices at one position, faces of one loop.

use super::Point;
use super::polygons::Polygons;

/// For each vertex the first one at the same position; −0 is 0.
pub fn first_at_position(points: &[Point]) -> Vec<u32> {
    // x + 0 is x for every x but −0, which becomes 0.
    let bits = |i: usize| points[i].map(|x| (x + 0.0).to_bits());
    let hash = |i: usize| bits(i).into_iter().fold(0, |h, word| mixed(h ^ word));
    first_equal(points.len(), hash, |i, j| points[i] == points[j])
}

/// For each face the first one whose loop is the same cycle, in either direction. ME-150.
#[doc(alias = "ME-150")]
pub fn first_of_cycle(mesh: &Polygons) -> Vec<u32> {
    // Sums do not depend on where the cycle begins, nor on its direction.
    let hash = |f: usize| {
        let face = mesh.face(f);
        mixed(face.iter().fold(face.len() as u64, |h, &v| h.wrapping_add(mixed(u64::from(v)))))
    };
    first_equal(mesh.faces(), hash, |f, g| same_cycle(mesh.face(f), mesh.face(g)))
}

/// Whether two loops are the same cycle, in either direction.
pub fn same_cycle(a: &[u32], b: &[u32]) -> bool {
    match (a, b) {
        // Three different vertices make one cycle and its reverse.
        (&[x, y, z], &[..]) if b.len() == 3 && x != y && y != z && z != x => [x, y, z].iter().all(|v| b.contains(v)),
        _ => a.len() == b.len() && least_rotation(a) == least_rotation(b),
    }
}

/// The least of all rotations of a loop and of its reverse.
fn least_rotation(a: &[u32]) -> Vec<u32> {
    let reversed: Vec<u32> = a.iter().rev().copied().collect();
    [a, &reversed].map(rotated_to_least).into_iter().min().expect("two directions")
}

/// The least rotation of a loop, in linear time: two starts are compared, and the one that loses is passed over together
/// with the starts within its matched part, which lose to the starts within the other's.
fn rotated_to_least(a: &[u32]) -> Vec<u32> {
    let n = a.len();
    let (mut i, mut j, mut matched) = (0, 1, 0);
    while i < n && j < n && matched < n {
        match a[(i + matched) % n].cmp(&a[(j + matched) % n]) {
            std::cmp::Ordering::Equal => matched += 1,
            std::cmp::Ordering::Less => (j, matched) = (j + matched + 1, 0),
            std::cmp::Ordering::Greater => (i, matched) = (i + matched + 1, 0),
        }
        if i == j {
            j += 1;
        }
    }
    let start = i.min(j);
    a[start.min(n)..].iter().chain(&a[..start.min(n)]).copied().collect()
}

/// The groups of two and more equal things, each sorted, in the order of their first ones.
pub fn groups(first: &[u32]) -> Vec<Vec<u32>> {
    let mut later: Vec<[u32; 2]> =
        (0..first.len()).filter(|&i| first[i] as usize != i).map(|i| [first[i], i as u32]).collect();
    later.sort_unstable();
    later
        .chunk_by(|a, b| a[0] == b[0])
        .map(|group| std::iter::once(group[0][0]).chain(group.iter().map(|pair| pair[1])).collect())
        .collect()
}

/// For each of 0 … n−1 the first one equal to it. The hash decides nothing but the time it takes.
fn first_equal(n: usize, hash: impl Fn(usize) -> u64, equal: impl Fn(usize, usize) -> bool) -> Vec<u32> {
    const FREE: u32 = u32::MAX;
    let mut slots = vec![FREE; (n * 3 / 2 + 1).next_power_of_two()];
    let mask = slots.len() - 1;
    let one = |i: usize| {
        let mut slot = hash(i) as usize & mask;
        loop {
            match slots[slot] {
                FREE => {
                    slots[slot] = i as u32;
                    return i as u32;
                }
                first if equal(first as usize, i) => return first,
                _ => slot = (slot + 1) & mask,
            }
        }
    };
    (0..n).map(one).collect()
}

/// A bijection of 64-bit words that spreads neighbours (the finisher of SplitMix64).
pub fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    x ^ (x >> 31)
}
