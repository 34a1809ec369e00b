//! Maps of a mesh to circles, one for each free generator of H¹, and the placement that is turned about them.

use super::mesh::TetrahedralMesh;
use super::place::{dot, smooth_functions};
use crate::number::Integer;
use std::collections::{BTreeMap, VecDeque};
use std::f64::consts::TAU;

/// A closed integer cochain: a number for each edge, from its first to its second end, whose sum around each triangle is 0.
pub type Cocycle = Vec<Integer>;

/// The edges of a triangle, each with its number and whether it is walked from its first to its second end, once around.
type Around = [(usize, bool); 3];

/// Cocycles whose classes are a basis of H¹ over ℤ of a connected simplicial mesh, 0 on the edges of a tree.
///
/// An edge outside the tree is a combination of generators: where two edges of a triangle are known, the third is; where no triangle has
/// two known edges and a third one, some edge becomes a generator. Triangles that close say which combinations are 0.
#[doc(alias = "CX-92")]
pub fn cocycles(mesh: &TetrahedralMesh) -> Vec<Cocycle> {
    let numbers: BTreeMap<[u32; 2], usize> = mesh.edges().iter().copied().zip(0..).collect();
    let side = |v: u32, w: u32| match numbers.get(&[v, w]) {
        Some(edge) => (*edge, true),
        None => (numbers[&[w, v]], false),
    };
    let triangles: Vec<Around> =
        mesh.triangles().iter().map(|[a, b, c]| [side(*a, *b), side(*b, *c), side(*c, *a)]).collect();
    let mut at_edge = vec![Vec::new(); mesh.edges().len()];
    for (i, triangle) in triangles.iter().enumerate() {
        triangle.iter().for_each(|(edge, _)| at_edge[*edge].push(i));
    }
    // By edge: the coefficients of the generators.
    let mut known: Vec<Option<Vec<Integer>>> = vec![None; mesh.edges().len()];
    tree(mesh).into_iter().for_each(|edge| known[edge] = Some(Vec::new()));
    let mut pending: VecDeque<usize> = (0..triangles.len()).collect();
    let (mut generators, mut next) = (0, 0);
    loop {
        while let Some(i) = pending.pop_front() {
            let mut unknown = triangles[i].iter().filter(|(edge, _)| known[*edge].is_none());
            let (Some((edge, forward)), None) = (unknown.next(), unknown.next()) else { continue };
            let others = triangles[i].iter().filter(|(other, _)| other != edge);
            let mut sum = around(others, &known);
            if *forward {
                sum.iter_mut().for_each(|n| *n = -n.clone());
            }
            known[*edge] = Some(sum);
            pending.extend(&at_edge[*edge]);
        }
        let Some(edge) = (next..known.len()).find(|edge| known[*edge].is_none()) else { break };
        let mut generator = vec![Integer::new(); generators];
        generator.push(Integer::from(1));
        known[edge] = Some(generator);
        pending.extend(&at_edge[edge]);
        (generators, next) = (generators + 1, edge);
    }
    let closing = triangles.iter().map(|triangle| around(triangle.iter(), &known));
    let basis = kernel(closing.collect(), generators);
    let value = |combination: &Vec<Integer>, weights: &[Integer]| {
        combination.iter().zip(weights).fold(Integer::new(), |sum, (n, w)| sum + Integer::from(n * w))
    };
    let known: Vec<Vec<Integer>> = known.into_iter().map(|n| n.expect("every edge is known")).collect();
    basis.iter().map(|weights| known.iter().map(|n| value(n, weights)).collect()).collect()
}

/// The edges of a tree that reaches every vertex, breadth first.
fn tree(mesh: &TetrahedralMesh) -> Vec<usize> {
    let mut neighbours = vec![Vec::new(); mesh.vertices()];
    for (edge, [v, w]) in mesh.edges().iter().enumerate() {
        neighbours[*v as usize].push((*w, edge));
        neighbours[*w as usize].push((*v, edge));
    }
    let (mut seen, mut edges) = (vec![false; mesh.vertices()], Vec::new());
    for first in 0..mesh.vertices() {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut pending = VecDeque::from([first]);
        while let Some(v) = pending.pop_front() {
            for (w, edge) in &neighbours[v] {
                if !std::mem::replace(&mut seen[*w as usize], true) {
                    edges.push(*edge);
                    pending.push_back(*w as usize);
                }
            }
        }
    }
    edges
}

/// The sum of known edges along a walk.
fn around<'a>(walk: impl Iterator<Item = &'a (usize, bool)>, known: &[Option<Vec<Integer>>]) -> Vec<Integer> {
    let mut sum = Vec::new();
    for (edge, forward) in walk {
        for (i, n) in known[*edge].iter().flatten().enumerate() {
            if sum.len() <= i {
                sum.resize(i + 1, Integer::new());
            }
            if *forward { sum[i] += n } else { sum[i] -= n }
        }
    }
    sum
}

/// A basis of the integer vectors x of length n with ⟨row, x⟩ = 0 for all rows: columns are changed by steps of Euclid's algorithm until
/// each row has one entry beside those that are done.
fn kernel(rows: Vec<Vec<Integer>>, n: usize) -> Vec<Vec<Integer>> {
    let mut basis: Vec<Vec<Integer>> =
        (0..n).map(|i| (0..n).map(|j| Integer::from(u32::from(i == j))).collect()).collect();
    for row in rows.iter().filter(|row| row.iter().any(|n| *n != 0)) {
        let product =
            |x: &Vec<Integer>| row.iter().zip(x).fold(Integer::new(), |sum, (r, x)| sum + Integer::from(r * x));
        loop {
            let products: Vec<Integer> = basis.iter().map(product).collect();
            let others = || (0..basis.len()).filter(|i| products[*i] != 0);
            let Some(least) = others().min_by(|i, j| products[*i].cmp_abs(&products[*j])) else { break };
            if others().count() == 1 {
                basis.swap_remove(least);
                break;
            }
            let pivot = basis[least].clone();
            for i in others().filter(|i| *i != least).collect::<Vec<_>>() {
                let quotient = Integer::from(&products[i] / &products[least]);
                basis[i].iter_mut().zip(&pivot).for_each(|(x, p)| *x -= Integer::from(&quotient * p));
            }
        }
    }
    basis
}

/// A map to the circle of length 1: its differences along the edges, and its value at each vertex.
struct Circle {
    along: Vec<f64>,
    at: Vec<f64>,
}

impl Circle {
    /// The smoothest map in the class of a cocycle c: the f with least Σ (c_e + f_w − f_v)², by conjugate gradients.
    fn of(mesh: &TetrahedralMesh, cocycle: &Cocycle) -> Circle {
        let c: Vec<f64> = cocycle.iter().map(Integer::to_f64).collect();
        let divergence = |flow: &dyn Fn(usize, [usize; 2]) -> f64| {
            let mut sum = vec![0.0; mesh.vertices()];
            for (edge, ends) in mesh.edges().iter().enumerate() {
                let [v, w] = ends.map(|v| v as usize);
                let flow = flow(edge, [v, w]);
                sum[v] += flow;
                sum[w] -= flow;
            }
            sum
        };
        let mut f = vec![0.0; mesh.vertices()];
        let mut rest = divergence(&|edge, _| c[edge]);
        let (mut step, mut size) = (rest.clone(), dot(&rest, &rest));
        for _ in 0..4 * mesh.vertices() {
            if size < 1e-20 {
                break;
            }
            let image = divergence(&|_, [v, w]| step[v] - step[w]);
            let length = size / dot(&step, &image);
            f.iter_mut().zip(&step).for_each(|(f, s)| *f += length * s);
            rest.iter_mut().zip(&image).for_each(|(r, i)| *r -= length * i);
            let before = std::mem::replace(&mut size, dot(&rest, &rest));
            step.iter_mut().zip(&rest).for_each(|(s, r)| *s = r + size / before * *s);
        }
        let ends = mesh.edges().iter().map(|ends| ends.map(|v| v as usize));
        Circle { along: ends.zip(&c).map(|([v, w], c)| c + f[w] - f[v]).collect(), at: f }
    }

    /// How long the circle is, in edges: 1 over the length of the gradient, a third of whose square an edge sees on the mean.
    fn length(&self) -> f64 {
        (self.along.len() as f64 / (3.0 * dot(&self.along, &self.along))).sqrt()
    }

    /// This one less so many times the other.
    fn less(&mut self, other: &Circle, times: f64) {
        self.along.iter_mut().zip(&other.along).for_each(|(a, b)| *a -= times * b);
        self.at.iter_mut().zip(&other.at).for_each(|(a, b)| *a -= times * b);
    }
}

/// The placement of a connected simplicial mesh in ℝⁿ that is turned about a circle for each basis element of H¹, at most n − 1 of them,
/// the shortest ones; `None` where H¹ = 0. So T³ is laid in ℝ⁴ without meeting itself, if it is fine enough. Not exact: a start.
///
/// Points begin with the smoothest functions that the circles do not explain; then, a circle θ after another, the first coordinate
/// x becomes (R + x)·(cos 2πθ, sin 2πθ), R greater than every |x|.
pub fn turned(mesh: &TetrahedralMesh, n: usize, seed: u64) -> Option<Vec<f64>> {
    let mut circles: Vec<Circle> = cocycles(mesh).iter().map(|cocycle| Circle::of(mesh, cocycle)).collect();
    if circles.is_empty() {
        return None;
    }
    shorten(&mut circles);
    circles.sort_by(|a, b| a.length().total_cmp(&b.length()));
    circles.truncate(n - 1);
    let rest = n - circles.len();
    let mut points = unexplained(mesh, &circles, rest, seed);
    for circle in &circles {
        let reach = points.iter().map(|p| p[0].abs()).fold(0.0, f64::max);
        let radius = (circle.length() / TAU).max(1.4 * reach);
        for (point, turn) in points.iter_mut().zip(&circle.at) {
            let out = radius + point[0];
            let (sin, cos) = (TAU * turn).sin_cos();
            point[0] = out * cos;
            point.insert(1, out * sin);
        }
    }
    Some(points.concat())
}

/// Subtracts circles from one another as long as that makes one smoother.
fn shorten(circles: &mut [Circle]) {
    for _ in 0..32 {
        let mut changed = false;
        for i in 0..circles.len() {
            for j in (0..circles.len()).filter(|j| *j != i) {
                let times =
                    (dot(&circles[i].along, &circles[j].along) / dot(&circles[j].along, &circles[j].along)).round();
                if times != 0.0 {
                    let other = Circle { along: circles[j].along.clone(), at: circles[j].at.clone() };
                    circles[i].less(&other, times);
                    changed = true;
                }
            }
        }
        if !changed {
            return;
        }
    }
}

/// `count` functions: smooth ones less what sines and cosines of the circles explain, as far as something is left of them.
fn unexplained(mesh: &TetrahedralMesh, circles: &[Circle], count: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut explained: Vec<Vec<f64>> = vec![vec![1.0; mesh.vertices()]];
    for circle in circles {
        for k in [1.0, 2.0] {
            explained.push(circle.at.iter().map(|t| (k * TAU * t).cos()).collect());
            explained.push(circle.at.iter().map(|t| (k * TAU * t).sin()).collect());
        }
    }
    let orthogonal = |y: &mut Vec<f64>, others: &[Vec<f64>]| {
        for other in [others, others].concat() {
            let along = dot(y, &other);
            y.iter_mut().zip(&other).for_each(|(y, o)| *y -= along * o);
        }
    };
    let unit = |y: &mut Vec<f64>| {
        let length = dot(y, y).sqrt();
        y.iter_mut().for_each(|y| *y /= length);
    };
    let mut known: Vec<Vec<f64>> = Vec::new();
    for mut y in explained {
        unit(&mut y);
        orthogonal(&mut y, &known);
        if dot(&y, &y) > 1e-6 {
            unit(&mut y);
            known.push(y);
        }
    }
    let mut points = vec![vec![0.0; count]; mesh.vertices()];
    let mut found = 0;
    // The functions are given with their lengths, so that what is left of one is measured against the whole.
    for mut y in smooth_functions(mesh, count + 4 * circles.len() + 2, seed) {
        let whole = dot(&y, &y);
        orthogonal(&mut y, &known);
        if found == count || dot(&y, &y) < 0.25 * whole {
            continue;
        }
        points.iter_mut().zip(&y).for_each(|(point, y)| point[found] = *y);
        unit(&mut y);
        known.push(y);
        found += 1;
    }
    // As wide as the functions' gradients say: an edge changes a coordinate by a third of its squared length, on the mean.
    for axis in 0..found {
        let changes = mesh.edges().iter().map(|[v, w]| (points[*v as usize][axis] - points[*w as usize][axis]).powi(2));
        let mean = changes.sum::<f64>() / mesh.edges().len() as f64;
        points.iter_mut().for_each(|p| p[axis] *= (1.0 / (3.0 * mean.max(1e-12))).sqrt());
    }
    points
}
