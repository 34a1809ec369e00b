//! Geometric realisation, the text's next step: the vertices of a tetrahedral mesh placed in ℝ⁴ or ℝ⁵, an energy of the
//! placement lowered, and an exact report of whether the result is an embedding.
//!
//! Positions are binary64 and only as good as the minimum that was found; that two tetrahedra meet, or do not, is decided exactly.

pub mod apart;
pub mod circles;
pub mod circuit;
pub mod energy;
pub mod intersections;
pub mod mesh;
pub mod minimise;
pub mod orientation;
pub mod place;
pub mod points;
pub mod project;
mod symmetric;

use energy::Energy;
use intersections::{Intersections, intersections};
use mesh::TetrahedralMesh;
use minimise::Descent;
use place::Random;
use points::{Points, PointsError};
use project::{Projection, to_space};
use thiserror::Error;

/// How a mesh is realised.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// n, the dimension of the space: 3, 4, 5 or 6.
    pub dimension: usize,
    /// What chooses among equally good starts. The same seed gives the same result.
    pub seed: u64,
    /// The most steps of the minimisation.
    pub iterations: usize,
    /// β, the weight of bending.
    pub bending: f64,
    /// Whether to stop before tetrahedra meet, where the start is an embedding.
    pub keep_embedded: bool,
    /// How the positions in ℝ³ are made.
    pub projection: Projection,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            dimension: 4,
            seed: 1,
            iterations: 300,
            bending: 1.0,
            keep_embedded: true,
            projection: Projection::Perspective,
        }
    }
}

/// A placement whose energy was lowered.
#[derive(Clone, Debug, PartialEq)]
pub struct Realised {
    /// What was placed.
    pub mesh: TetrahedralMesh,
    /// The vertices in ℝⁿ.
    pub points: Points,
    /// The vertices in ℝ³.
    pub positions: Vec<[f64; 3]>,
    /// The energy of the start, and after each step.
    pub energies: Vec<f64>,
    /// The lengths of the edges.
    pub lengths: Lengths,
    /// Whether it is an embedding.
    pub intersections: Intersections,
}

/// How long edges are, in units of the ideal length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lengths {
    /// The shortest.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The longest.
    pub max: f64,
}

/// Why nothing was realised.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum RealiseError {
    /// Not 3, 4, 5 or 6.
    #[error("dimension {0}: tetrahedra are placed in dimension 3, 4, 5 or 6")]
    Dimension(usize),
    /// Negative, or no number.
    #[error("the weight of bending is {0}; it is finite and not negative")]
    Bending(f64),
    /// There is no tetrahedron.
    #[error("there is no tetrahedron")]
    Empty,
    /// The start or the minimum is not finite.
    #[error("the placement is not finite: {0}")]
    NotFinite(#[from] PointsError),
}

/// Places the mesh, lowers the energy, and says what the result is.
///
/// # Errors
/// Iff a dimension or weight is out of its range, there is no tetrahedron, or the numbers overflow.
#[doc(alias = "CX-90")]
pub fn realise(mesh: &TetrahedralMesh, options: &Options) -> Result<Realised, RealiseError> {
    let n = options.dimension;
    if !(3..=6).contains(&n) {
        return Err(RealiseError::Dimension(n));
    }
    let energy = Energy::new(mesh, options.bending).ok_or(RealiseError::Bending(options.bending))?;
    if mesh.tetrahedra().is_empty() {
        return Err(RealiseError::Empty);
    }
    let mut descent = energy.minimise(start(mesh, &energy, options)?.coordinates(), n, options.iterations);
    let intersections = match options.keep_embedded {
        true => while_embedded(mesh, n, &mut descent)?,
        false => intersections(mesh, &Points::new(n, last(&descent))?),
    };
    let points = Points::new(n, last(&descent))?;
    Ok(Realised {
        positions: to_space(&points, options.projection),
        lengths: lengths(mesh, &points),
        intersections,
        energies: descent.energies,
        mesh: mesh.clone(),
        points,
    })
}

fn last(descent: &Descent) -> Vec<f64> {
    descent.path.last().expect("it has a start").clone()
}

/// Cuts a descent from an embedding off at a step that is one too, and the next looked at is none; all of it if its end is one, or its
/// start is none. Steps between are not all looked at: what counts is where it ends.
fn while_embedded(mesh: &TetrahedralMesh, n: usize, descent: &mut Descent) -> Result<Intersections, PointsError> {
    let at = |step: usize| Ok(intersections(mesh, &Points::new(n, descent.path[step].clone())?));
    let end = descent.path.len() - 1;
    let whole = at(end)?;
    if whole.is_embedded() {
        return Ok(whole);
    }
    let mut best = at(0)?;
    if !best.is_embedded() {
        return Ok(whole);
    }
    let (mut good, mut bad) = (0, end);
    // The first steps are the long ones, so they are looked at first.
    while bad - good > 1 {
        let step = if good == 0 { bad.div_ceil(8).min(bad - 1) } else { good.midpoint(bad) };
        let found = at(step)?;
        if found.is_embedded() { (good, best) = (step, found) } else { bad = step }
    }
    descent.path.truncate(good + 1);
    descent.energies.truncate(good + 1);
    Ok(best)
}

/// Where the minimisation starts: turned about the circles of H¹ where the mesh is connected, simplicial and has some, or else the
/// spectral placement; at its best scale, components side by side, shaken by a thousandth: what lies on one place could never part
/// otherwise.
///
/// # Errors
/// Iff the numbers overflow.
pub fn start(mesh: &TetrahedralMesh, energy: &Energy, options: &Options) -> Result<Points, PointsError> {
    let n = options.dimension;
    let component_of = place::components(mesh);
    let is_whole = component_of.iter().all(|first| *first == 0) && mesh.not_simplicial().is_none();
    let turned = if is_whole { circles::turned(mesh, n, options.seed) } else { None };
    let mut x = turned.unwrap_or_else(|| place::spectral(mesh, n, options.seed));
    let mut random = Random(options.seed);
    let size = x.iter().fold(0.0_f64, |max, x| max.max(x.abs())).max(1e-3);
    x.iter_mut().for_each(|x| *x += 1e-3 * size * random.number());
    let scale = energy.best_scale(&x, n);
    x.iter_mut().for_each(|x| *x *= scale);
    side_by_side(&mut x, n, &component_of);
    Points::new(n, x)
}

/// Moves components along the first axis until their boxes are apart.
fn side_by_side(x: &mut [f64], n: usize, component_of: &[usize]) {
    let mut end = None;
    for first in (0..component_of.len()).filter(|v| component_of[*v] == *v) {
        let members: Vec<usize> = (0..component_of.len()).filter(|v| component_of[*v] == first).collect();
        let bound = |choose: fn(f64, f64) -> f64| members.iter().map(|v| x[n * v]).reduce(choose).expect("a vertex");
        let (least, greatest) = (bound(f64::min), bound(f64::max));
        // What is moved grows a little as its edges find their lengths.
        let shift = end.map_or(0.0, |end: f64| end + 3.0 + 0.5 * (greatest - least) - least);
        members.iter().for_each(|v| x[n * v] += shift);
        end = Some(greatest + shift + 0.5 * (greatest - least));
    }
}

/// The lengths of the edges of a mesh with at least one.
fn lengths(mesh: &TetrahedralMesh, points: &Points) -> Lengths {
    let length = |[v, w]: &[u32; 2]| {
        let [v, w] = [v, w].map(|v| points.at(*v as usize));
        v.iter().zip(w).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let all: Vec<f64> = mesh.edges().iter().map(length).collect();
    Lengths {
        min: all.iter().copied().fold(f64::INFINITY, f64::min),
        mean: all.iter().sum::<f64>() / all.len() as f64,
        max: all.iter().copied().fold(0.0, f64::max),
    }
}
