//! The energy of a placement: how far its edges are from equal length, and how far its vertices stand off the means of
//! their neighbours. A polynomial of degree 4, here over ℚ; [`minimise`](super::minimise) has its twin in binary64.

use super::mesh::TetrahedralMesh;
use crate::number::Rational;

/// E(x) = 1/|E| Σ_{vw} (|x_v − x_w|² − 1)² + β/|V| Σ_v |u_v|², with u_v = 1/deg v Σ_{vw} (x_w − x_v).
///
/// The first sum runs over the edges, whose ideal length is 1. deg v counts the ends of edges at v, those of loops left out,
/// which pull nowhere; u_v = 0 where deg v = 0. The second sum is the bending energy: u_v, the umbrella vector, is 0 iff the
/// vertex is the mean of its neighbours. β ≥ 0 is its weight.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "CX-81")]
#[doc(alias = "CX-87")]
pub struct Energy {
    pub(super) vertices: usize,
    pub(super) edges: Vec<[u32; 2]>,
    /// deg v.
    pub(super) degrees: Vec<u32>,
    pub(super) bending: f64,
}

impl Energy {
    /// The energy of placements of that mesh, with the weight β of bending. `None` iff β is negative or not finite.
    pub fn new(mesh: &TetrahedralMesh, bending: f64) -> Option<Energy> {
        if !bending.is_finite() || bending < 0.0 {
            return None;
        }
        let mut degrees = vec![0; mesh.vertices()];
        for [v, w] in mesh.edges().iter().filter(|[v, w]| v != w) {
            degrees[*v as usize] += 1;
            degrees[*w as usize] += 1;
        }
        Some(Energy { vertices: mesh.vertices(), edges: mesh.edges().to_vec(), degrees, bending })
    }

    /// β, exactly.
    pub fn bending(&self) -> Rational {
        Rational::from_f64(self.bending).expect("it is finite")
    }

    /// E(x), exactly; x has the coordinates of a point of ℝⁿ after another.
    pub fn exact(&self, x: &[Rational], n: usize) -> Rational {
        let uniformity = self.edges.iter().fold(Rational::new(), |sum, edge| {
            let deviation: Rational = squared_length(x, n, *edge) - 1;
            sum + deviation.square()
        });
        let u = self.umbrellas(x, n);
        let bending = u.iter().fold(Rational::new(), |sum, u| sum + Rational::from(u.square_ref()));
        mean(uniformity, self.edges.len()) + self.bending() * mean(bending, self.vertices)
    }

    /// ∂E/∂x, exactly: for the vertex v
    /// 4/|E| Σ_{vw} (|x_v − x_w|² − 1)(x_v − x_w) + 2β/|V| (Σ_{vw} u_w/deg w − \[deg v > 0\] u_v).
    #[doc(alias = "CX-82")]
    pub fn exact_gradient(&self, x: &[Rational], n: usize) -> Vec<Rational> {
        let u = self.umbrellas(x, n);
        let mut gradient = vec![Rational::new(); x.len()];
        for [v, w] in self.edges.iter().map(|edge| edge.map(|v| v as usize)).filter(|[v, w]| v != w) {
            let pull = mean((squared_length(x, n, [v as u32, w as u32]) - 1) * Rational::from(4), self.edges.len());
            let bend = mean(self.bending() * Rational::from(2), self.vertices);
            for i in 0..n {
                let [a, b] = [v, w].map(|v| n * v + i);
                let along = Rational::from(&x[a] - &x[b]) * &pull;
                // The edge has u_w/deg w for v and −1/deg v of u_v, which all edges at v add to −u_v.
                let [of_v, of_w] = [(a, v), (b, w)].map(|(i, v)| Rational::from(&u[i] / self.degrees[v]) * &bend);
                let across = of_w - of_v;
                gradient[a] += Rational::from(&along + &across);
                gradient[b] -= along + across;
            }
        }
        gradient
    }

    /// u_v, vertex after vertex.
    fn umbrellas(&self, x: &[Rational], n: usize) -> Vec<Rational> {
        let mut u = vec![Rational::new(); x.len()];
        for [v, w] in self.edges.iter().map(|edge| edge.map(|v| v as usize)).filter(|[v, w]| v != w) {
            for i in 0..n {
                let [a, b] = [v, w].map(|v| n * v + i);
                u[a] += Rational::from(&x[b] - &x[a]) / self.degrees[v];
                u[b] += Rational::from(&x[a] - &x[b]) / self.degrees[w];
            }
        }
        u
    }
}

fn squared_length(x: &[Rational], n: usize, edge: [u32; 2]) -> Rational {
    let [v, w] = edge.map(|v| n * v as usize);
    (0..n).fold(Rational::new(), |sum, i| sum + Rational::from(&x[v + i] - &x[w + i]).square())
}

/// sum/count; 0 for an empty sum.
fn mean(sum: Rational, count: usize) -> Rational {
    sum / count.max(1) as u64
}
