//! Where the minimisation starts: the smoothest functions on the vertices, as coordinates.

use super::mesh::TetrahedralMesh;
use super::symmetric;
use crate::partition::Partition;

/// The columns that are iterated beside those wanted: they take up what converges slowly.
const SPARE: usize = 8;

/// The degree of the polynomial that damps what is not smooth, and how often it is applied.
const DEGREE: usize = 12;
const ROUNDS: usize = 40;

/// The spectral placement of the mesh in ℝⁿ: coordinate i of the vertex v is y_i(v)/√(λ_i deg v), where y₁, y₂, … are the
/// eigenvectors of I − D^(−1/2) A D^(−1/2) to its least eigenvalues 0 < λ₁ ≤ λ₂ ≤ …, A being the adjacency of the vertices and D its
/// degrees; each component of the mesh by itself. Coordinates beyond the number of eigenvectors are 0. Not exact: a start.
///
/// Where an eigenvalue is multiple, the seed decides which of its vectors are taken.
pub fn spectral(mesh: &TetrahedralMesh, n: usize, seed: u64) -> Vec<f64> {
    let component_of = components(mesh);
    let mut x = vec![0.0; n * mesh.vertices()];
    let mut random = Random(seed);
    for first in (0..mesh.vertices()).filter(|v| component_of[*v] == *v) {
        let members: Vec<usize> = (0..mesh.vertices()).filter(|v| component_of[*v] == first).collect();
        let graph = Graph::of(mesh, &members);
        for (i, (value, vector)) in graph.smoothest(n, &mut random).into_iter().enumerate() {
            for (local, v) in members.iter().enumerate() {
                x[n * v + i] = vector[local] / (value * graph.degrees[local]).max(1e-12).sqrt();
            }
        }
    }
    x
}

/// The coordinates of [`spectral`] in ℝᵏ one after another, those of all vertices each, the smoothest first.
pub(super) fn smooth_functions(mesh: &TetrahedralMesh, k: usize, seed: u64) -> Vec<Vec<f64>> {
    let x = spectral(mesh, k, seed);
    (0..k).map(|i| x.iter().skip(i).step_by(k).copied().collect()).collect()
}

/// The component of each vertex, by its first vertex.
pub(super) fn components(mesh: &TetrahedralMesh) -> Vec<usize> {
    let mut parts = Partition::new(mesh.vertices());
    mesh.edges().iter().for_each(|[v, w]| {
        parts.join(*v as usize, *w as usize);
    });
    (0..mesh.vertices()).map(|v| parts.find(v)).collect()
}

/// A sequence of numbers that looks random and is the same for the same seed (splitmix64).
pub(super) struct Random(pub(super) u64);

impl Random {
    /// A number between −1 and 1.
    pub(super) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A connected graph.
struct Graph {
    neighbours: Vec<Vec<u32>>,
    degrees: Vec<f64>,
}

impl Graph {
    fn of(mesh: &TetrahedralMesh, members: &[usize]) -> Graph {
        let mut local = vec![u32::MAX; mesh.vertices()];
        members.iter().zip(0..).for_each(|(v, i)| local[*v] = i);
        let mut neighbours = vec![Vec::new(); members.len()];
        for [v, w] in mesh.edges().iter().map(|edge| edge.map(|v| local[v as usize])) {
            if v != w && v != u32::MAX {
                neighbours[v as usize].push(w);
                neighbours[w as usize].push(v);
            }
        }
        let degrees = neighbours.iter().map(|n: &Vec<u32>| n.len() as f64).collect();
        Graph { neighbours, degrees }
    }

    /// D^(−1/2) A D^(−1/2) y.
    fn applied(&self, y: &[f64]) -> Vec<f64> {
        let scaled: Vec<f64> = y.iter().zip(&self.degrees).map(|(y, d)| y / d.sqrt()).collect();
        let sum = |neighbours: &Vec<u32>| neighbours.iter().map(|w| scaled[*w as usize]).sum::<f64>();
        self.neighbours.iter().zip(&self.degrees).map(|(n, d)| sum(n) / d.sqrt()).collect()
    }

    /// At most n eigenvectors of I − D^(−1/2) A D^(−1/2) to its least eigenvalues beside 0, with these: subspace iteration with
    /// Chebyshev polynomials.
    fn smoothest(&self, n: usize, random: &mut Random) -> Vec<(f64, Vec<f64>)> {
        let vertices = self.degrees.len();
        let columns = (n + SPARE).min(vertices.saturating_sub(1));
        let constant: Vec<f64> = normalised(self.degrees.iter().map(|d| d.sqrt()).collect());
        let mut block: Vec<Vec<f64>> = (0..columns).map(|_| (0..vertices).map(|_| random.number()).collect()).collect();
        let mut values = vec![0.0; columns];
        // Eigenvalues μ of D^(−1/2) A D^(−1/2) are at most 1; those in [−1, cut] are damped.
        let mut cut = 0.0_f64;
        for _ in 0..ROUNDS {
            block = block.iter().map(|y| self.filtered(y, cut)).collect();
            orthonormalise(&mut block, &constant);
            let images: Vec<Vec<f64>> = block.iter().map(|y| self.applied(y)).collect();
            let reduced = block.iter().map(|a| images.iter().map(|b| dot(a, b)).collect()).collect();
            let (rotated, vectors) = symmetric::eigen(reduced);
            let combine = |weights: &Vec<f64>| {
                let mut sum = vec![0.0; vertices];
                for (weight, y) in weights.iter().zip(&block) {
                    sum.iter_mut().zip(y).for_each(|(sum, y)| *sum += weight * y);
                }
                sum
            };
            block = vectors.iter().map(combine).collect();
            values = rotated;
            cut = values.last().copied().unwrap_or(0.0).clamp(-0.5, 0.999);
        }
        block.into_iter().zip(values).map(|(y, mu)| (1.0 - mu, y)).take(n).collect()
    }

    /// T_d of the matrix, shifted so that [−1, cut] becomes [−1, 1].
    fn filtered(&self, y: &[f64], cut: f64) -> Vec<f64> {
        let (half, middle) = ((cut + 1.0) / 2.0, (cut - 1.0) / 2.0);
        let shifted =
            |y: &[f64]| -> Vec<f64> { self.applied(y).iter().zip(y).map(|(a, y)| (a - middle * y) / half).collect() };
        let (mut before, mut now) = (y.to_vec(), shifted(y));
        for _ in 1..DEGREE {
            let next = shifted(&now).iter().zip(&before).map(|(a, b)| 2.0 * a - b).collect();
            before = std::mem::replace(&mut now, next);
        }
        now
    }
}

/// Gram and Schmidt, twice, against the constant and what comes before.
fn orthonormalise(block: &mut [Vec<f64>], constant: &[f64]) {
    for i in 0..block.len() {
        let (before, rest) = block.split_at_mut(i);
        let y = &mut rest[0];
        for _ in 0..2 {
            *y = normalised(std::mem::take(y));
            for other in before.iter().map(Vec::as_slice).chain([constant]) {
                let along = dot(y, other);
                y.iter_mut().zip(other).for_each(|(y, o)| *y -= along * o);
            }
        }
        *y = normalised(std::mem::take(y));
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn normalised(y: Vec<f64>) -> Vec<f64> {
    let length = dot(&y, &y).sqrt();
    if length > 0.0 { y.into_iter().map(|y| y / length).collect() } else { y }
}
