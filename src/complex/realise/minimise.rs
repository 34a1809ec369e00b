//! The energy and its gradient in binary64, and its minimisation by L-BFGS.

use super::energy::Energy;
use argmin::core::observers::{Observe, ObserverMode};
use argmin::core::{CostFunction, Error, Executor, Gradient, IterState, KV, State};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use std::sync::{Arc, Mutex};

/// The way that a minimisation went, from its start on; never empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Descent {
    /// The coordinates at the start and after each step.
    pub path: Vec<Vec<f64>>,
    /// The energies there; each is less than the one before.
    pub energies: Vec<f64>,
}

/// A run of L-BFGS ends where the gradient is shorter than this, in units of the ideal edge length.
const LEAST_GRADIENT: f64 = 1e-9;

/// So many last steps tell L-BFGS how the gradient changes.
const MEMORY: usize = 10;

impl Energy {
    /// E(x) in binary64: [`Energy::exact`], rounded in each step.
    pub fn value(&self, x: &[f64], n: usize) -> f64 {
        let uniformity: f64 = self.edges.iter().map(|edge| (squared_length(x, n, *edge) - 1.0).powi(2)).sum();
        let bending: f64 = self.umbrellas_f64(x, n).iter().map(|u| u * u).sum();
        uniformity / self.edges.len().max(1) as f64 + self.bending * bending / self.vertices.max(1) as f64
    }

    /// ∂E/∂x in binary64: [`Energy::exact_gradient`], rounded in each step.
    pub fn gradient(&self, x: &[f64], n: usize) -> Vec<f64> {
        let u = self.umbrellas_f64(x, n);
        let bend = 2.0 * self.bending / self.vertices.max(1) as f64;
        let mut gradient = vec![0.0; x.len()];
        for &[v, w] in self.edges.iter().filter(|[v, w]| v != w) {
            let pull = 4.0 * (squared_length(x, n, [v, w]) - 1.0) / self.edges.len() as f64;
            let [a, b] = [v, w].map(|v| n * v as usize);
            let [of_v, of_w] = [v, w].map(|v| bend / f64::from(self.degrees[v as usize]));
            for i in 0..n {
                let change = pull * (x[a + i] - x[b + i]) + of_w * u[b + i] - of_v * u[a + i];
                gradient[a + i] += change;
                gradient[b + i] -= change;
            }
        }
        gradient
    }

    fn umbrellas_f64(&self, x: &[f64], n: usize) -> Vec<f64> {
        let mut u = vec![0.0; x.len()];
        for &[v, w] in self.edges.iter().filter(|[v, w]| v != w) {
            let [a, b] = [v, w].map(|v| n * v as usize);
            for i in 0..n {
                u[a + i] += x[b + i] - x[a + i];
                u[b + i] += x[a + i] - x[b + i];
            }
        }
        for (u, degree) in u.chunks_exact_mut(n).zip(&self.degrees) {
            u.iter_mut().for_each(|u| *u /= f64::from((*degree).max(1)));
        }
        u
    }

    /// The factor s ≥ 0 at which E(s·x) is least: s² = (Σq/|E| − β/(2|V|)·Σ|u|²)/(Σq²/|E|) over the squared lengths q of the
    /// edges, or 0 where that is negative; 1 where all edges have length 0.
    #[doc(alias = "CX-83")]
    pub fn best_scale(&self, x: &[f64], n: usize) -> f64 {
        let count = self.edges.len().max(1) as f64;
        let squares = || self.edges.iter().map(|edge| squared_length(x, n, *edge));
        let bending: f64 = self.umbrellas_f64(x, n).iter().map(|u| u * u).sum();
        let linear = squares().sum::<f64>() / count - self.bending * bending / (2.0 * self.vertices.max(1) as f64);
        let square = squares().map(|q| q * q).sum::<f64>() / count;
        if square > 0.0 { (linear.max(0.0) / square).sqrt() } else { 1.0 }
    }

    /// Lowers E from x on, by at most so many steps of L-BFGS with Moré and Thuente's line search. The same x gives the same
    /// result. Where E(x) is not finite, nothing is done.
    pub fn minimise(&self, x: &[f64], n: usize, iterations: usize) -> Descent {
        let mut descent = Descent { path: vec![x.to_vec()], energies: vec![self.value(x, n)] };
        loop {
            let done = descent.path.len() - 1;
            if done < iterations {
                self.run(&mut descent, n, iterations - done);
            }
            // A run may end because its line search found no step; one that made none would not do better again.
            if descent.path.len() - 1 == done {
                return descent;
            }
        }
    }

    /// One run, whose steps are kept as long as they lower the energy.
    fn run(&self, descent: &mut Descent, n: usize, iterations: usize) {
        let start = descent.path.last().expect("it has a start").clone();
        let trace =
            Arc::new(Mutex::new(std::mem::replace(descent, Descent { path: Vec::new(), energies: Vec::new() })));
        let search = MoreThuenteLineSearch::new();
        let solver = LBFGS::new(search, MEMORY).with_tolerance_grad(LEAST_GRADIENT).expect("it is not negative");
        // An error is a line search without a step, and the trace has all steps before it.
        let _ = Executor::new(Placement { energy: self, n }, solver)
            .configure(|state| state.param(start).max_iters(iterations as u64))
            .add_observer(Trace(trace.clone()), ObserverMode::Always)
            .timer(false)
            .run();
        descent.clone_from(&trace.lock().expect("nobody panicked with it"));
    }
}

fn squared_length(x: &[f64], n: usize, edge: [u32; 2]) -> f64 {
    let [v, w] = edge.map(|v| n * v as usize);
    (0..n).map(|i| (x[v + i] - x[w + i]).powi(2)).sum()
}

struct Placement<'a> {
    energy: &'a Energy,
    n: usize,
}

impl CostFunction for Placement<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        Ok(self.energy.value(x, self.n))
    }
}

impl Gradient for Placement<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Error> {
        Ok(self.energy.gradient(x, self.n))
    }
}

/// Keeps each step that lowers the energy.
struct Trace(Arc<Mutex<Descent>>);

impl Observe<IterState<Vec<f64>, Vec<f64>, (), (), (), f64>> for Trace {
    fn observe_iter(&mut self, state: &IterState<Vec<f64>, Vec<f64>, (), (), (), f64>, _: &KV) -> Result<(), Error> {
        let mut descent = self.0.lock().expect("nobody panicked with it");
        let (energy, last) = (state.get_cost(), descent.energies.last().copied());
        if let Some(x) = state.get_param().filter(|_| last.is_some_and(|last| energy < last)) {
            descent.path.push(x.clone());
            descent.energies.push(energy);
        }
        Ok(())
    }
}
