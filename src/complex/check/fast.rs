//! The same facts in one pass around each vertex and each edge, and by sorting.

use super::{Facts, TriangulationDefect, VertexSets, surface};
use crate::complex::triangulation::{EDGES, TriangleGluing, Triangulation};
use crate::mesh::classify::SPHERE;

/// As [`check`](super::check).
#[doc(alias = "CX-63")]
pub fn check(triangulation: &Triangulation) -> Facts {
    let gluings = triangulation.gluings();
    let parities: Vec<u8> = gluings.iter().map(parities).collect();
    let (components, orientable) = components(gluings, &parities);
    let mut links = links(gluings, &parities);
    let (edges, mut defects) = edges(gluings, &links.vertices);
    for (ends, reversed) in &edges {
        // A reversed edge has one end twice.
        ends[..if *reversed { 1 } else { 2 }].iter().for_each(|v| links.doubled[*v as usize] += 2);
    }
    for (vertex, (doubled, orientable)) in links.doubled.iter().zip(&links.orientable).enumerate() {
        let link = surface(doubled / 2, *orientable);
        if link != SPHERE {
            defects.push(TriangulationDefect::VertexLink { vertex, link });
        }
    }
    let n = gluings.len();
    let vertex_sets = vertex_sets(gluings, &links.vertices, links.doubled.len(), &edges);
    Facts { counts: [links.doubled.len(), edges.len(), 2 * n, n], components, orientable, defects, vertex_sets }
}

/// Bit i: whether triangle i is glued by an even permutation.
fn parities(row: &[TriangleGluing; 4]) -> u8 {
    (0..4).map(|i| u8::from(row[i].corners.is_even()) << i).sum()
}

fn components(gluings: &[[TriangleGluing; 4]], parities: &[u8]) -> (usize, bool) {
    // 0: not reached; else 2 + sign.
    let mut signs = vec![0_u8; gluings.len()];
    let (mut components, mut orientable) = (0, true);
    let mut pending = Vec::new();
    for first in 0..gluings.len() {
        if signs[first] != 0 {
            continue;
        }
        components += 1;
        signs[first] = 2;
        pending.push(first);
        while let Some(tetrahedron) = pending.pop() {
            for (i, gluing) in gluings[tetrahedron].iter().enumerate() {
                let sign = signs[tetrahedron] ^ (parities[tetrahedron] >> i & 1);
                match &mut signs[gluing.tetrahedron as usize] {
                    new if *new == 0 => {
                        *new = sign;
                        pending.push(gluing.tetrahedron as usize);
                    }
                    known => orientable &= *known == sign,
                }
            }
        }
    }
    (components, orientable)
}

/// The vertices, with what their links add up to.
struct Links {
    vertices: Vec<[u32; 4]>,
    /// 2χ less what the ends of edges add: −1 for each triangle of the link.
    doubled: Vec<i64>,
    orientable: Vec<bool>,
}

fn links(gluings: &[[TriangleGluing; 4]], parities: &[u8]) -> Links {
    let mut vertices = vec![[u32::MAX; 4]; gluings.len()];
    let mut signs = vec![0_u8; gluings.len()];
    let (mut doubled, mut orientable) = (Vec::new(), Vec::new());
    let mut pending = Vec::new();
    for first in 0..gluings.len() {
        for corner in 0..4 {
            if vertices[first][corner] != u32::MAX {
                continue;
            }
            let number = doubled.len() as u32;
            let (mut triangles, mut is_orientable) = (0, true);
            vertices[first][corner] = number;
            pending.push((first as u32, corner as u8));
            while let Some((tetrahedron, corner)) = pending.pop() {
                triangles += 1;
                let tetrahedron = tetrahedron as usize;
                let sign = signs[tetrahedron] >> corner & 1;
                for (i, gluing) in gluings[tetrahedron].iter().enumerate() {
                    if i == usize::from(corner) {
                        continue;
                    }
                    let (other, image) = (gluing.tetrahedron as usize, gluing.corners.image(corner.into()));
                    let sign = sign ^ (parities[tetrahedron] >> i & 1);
                    if vertices[other][image] == u32::MAX {
                        vertices[other][image] = number;
                        signs[other] |= sign << image;
                        pending.push((gluing.tetrahedron, image as u8));
                    } else {
                        is_orientable &= signs[other] >> image & 1 == sign;
                    }
                }
            }
            doubled.push(-triangles);
            orientable.push(is_orientable);
        }
    }
    Links { vertices, doubled, orientable }
}

/// The ends of each edge, and whether it is reversed; with the defects.
type Edges = Vec<([u32; 2], bool)>;

fn edges(gluings: &[[TriangleGluing; 4]], vertices: &[[u32; 4]]) -> (Edges, Vec<TriangulationDefect>) {
    let mut seen = vec![0_u8; gluings.len()];
    let (mut edges, mut defects) = (Vec::with_capacity(gluings.len() + gluings.len() / 5), Vec::new());
    for first in 0..gluings.len() {
        for (edge, [i, j]) in EDGES.into_iter().enumerate() {
            if seen[first] >> edge & 1 == 1 {
                continue;
            }
            let [k, l] = EDGES[5 - edge];
            let start = (first, [i, j, k, l]);
            let (mut at, mut reversed) = (start, false);
            // Across the triangle opposite l, into a tetrahedron whose triangle opposite the image of l it is.
            loop {
                let (tetrahedron, [a, b, c, d]) = at;
                seen[tetrahedron] |= 1 << edge_number(a, b);
                let gluing = &gluings[tetrahedron][d];
                let image = |i| gluing.corners.image(i);
                at = (gluing.tetrahedron as usize, [image(a), image(b), image(d), image(c)]);
                if at == start {
                    break;
                }
                reversed |= at.0 == first && at.1[..2] == [j, i];
            }
            if reversed {
                defects.push(TriangulationDefect::EdgeReversed { tetrahedron: first, edge });
            }
            edges.push(([vertices[first][i], vertices[first][j]], reversed));
        }
    }
    (edges, defects)
}

/// The edge between two corners of a tetrahedron: 01, 02, 03, 12, 13, 23 are 0, …, 5.
fn edge_number(i: usize, j: usize) -> usize {
    i + j - usize::from(i == 0 || j == 0)
}

fn vertex_sets(gluings: &[[TriangleGluing; 4]], vertices: &[[u32; 4]], count: usize, edges: &Edges) -> VertexSets {
    let tetrahedra = gluings.len();
    let mut degenerate_tetrahedra = 0;
    let sets: Vec<[u32; 4]> = vertices
        .iter()
        .map(|corners| set(*corners))
        .inspect(|set| degenerate_tetrahedra += usize::from(set[3] == NONE))
        .collect();
    let all = different(&sets, count);
    let mut told_apart = all == tetrahedra && degenerate_tetrahedra == 0;
    // What follows is known where a tetrahedron is not told apart, and costs more than that.
    if told_apart {
        let ends: Vec<[u32; 2]> = edges.iter().map(|(ends, _)| set(*ends)).collect();
        told_apart = different(&ends, count) == edges.len();
    }
    if told_apart {
        let mut triangles = Vec::with_capacity(2 * tetrahedra);
        for (tetrahedron, row) in gluings.iter().enumerate() {
            for (i, gluing) in row.iter().enumerate() {
                if (tetrahedron, i) < (gluing.tetrahedron as usize, gluing.corners.image(i)) {
                    let [a, b, c] = [1, 2, 3].map(|j| vertices[tetrahedron][(i + j) % 4]);
                    triangles.push(set([a, b, c]));
                }
            }
        }
        told_apart = different(&triangles, count) == triangles.len();
    }
    VertexSets { degenerate_tetrahedra, duplicate_tetrahedra: tetrahedra - all, simplicial: told_apart }
}

/// No vertex.
const NONE: u32 = u32::MAX;

/// The set of the numbers, sorted, filled up with [`NONE`].
fn set<const N: usize>(mut numbers: [u32; N]) -> [u32; N] {
    numbers.sort_unstable();
    let mut length = 1;
    for i in 1..N {
        if numbers[i] != numbers[length - 1] {
            numbers[length] = numbers[i];
            length += 1;
        }
    }
    numbers[length..].fill(NONE);
    numbers
}

/// How many different sets there are: put beside those with the same least number, then sorted there.
fn different<const N: usize>(sets: &[[u32; N]], count: usize) -> usize {
    let mut starts = vec![0_u32; count + 1];
    sets.iter().for_each(|set| starts[set[0] as usize + 1] += 1);
    for i in 0..count {
        starts[i + 1] += starts[i];
    }
    let mut placed = vec![[0; N]; sets.len()];
    let mut next = starts.clone();
    for set in sets {
        let place = &mut next[set[0] as usize];
        placed[*place as usize] = *set;
        *place += 1;
    }
    let mut different = 0;
    for bounds in starts.windows(2) {
        let bucket = &mut placed[bounds[0] as usize..bounds[1] as usize];
        bucket.sort_unstable();
        different += usize::from(!bucket.is_empty()) + bucket.windows(2).filter(|pair| pair[0] != pair[1]).count();
    }
    different
}
