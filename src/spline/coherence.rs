//! Gauss–Bonnet between two interpolants of the same samples: curvature by splines, topology by trilinear interpolation (002, 5(e)).

use super::cell_form::{EnclosedSpline, may_vanish};
use super::enclosure::hull;
use super::normal_count::quarter_turns;
use super::prefilter::interpolate;
use super::signal::{Boundary, Signal, SignalError};
use super::tensor::Spline;
use super::total_curvature::{Effort, Quadrature, Unresolved, by_quadrature};
use crate::curvature::implicit_surface::curvature;
use crate::isosurface::mesh::extract;
use crate::isosurface::topology::topology;
use crate::isosurface::volume::{DegenerateCell, Level, Volume, VolumeError};
use crate::linear::Vector;
use crate::number::{Integer, Interval, Polynomial, Rational, Ring, SturmChain};
use std::fmt::{self, Display, Formatter};
use thiserror::Error;

/// The precision, in bits, of the enclosures of areas and of multiples of π.
const PRECISION: u32 = 96;

/// What Gauss and Bonnet's theorem says of a surface in a box whose faces it meets at right angles, or in a torus.
///
/// χ counts the closed surface with its border. With a mirror boundary the reflections of the box make eight copies of the surface into a
/// closed one, of characteristic 8χ − 2E, E the crossings with the twelve edges of the box: ∫ K dA = 2πχ − (π/2)E. With a periodic
/// boundary opposite faces are glued: χ − E, where E counts the crossings with the three edges at the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Characteristic {
    /// χ of the surface within the grid's box, for a periodic boundary within the box of a period.
    pub chi: i64,
    /// E.
    pub edge_crossings: i64,
    boundary: Boundary,
}

impl Characteristic {
    /// ∫ K dA in units of π/2, if the theorem is to hold: 4χ − E, or 4(χ − E). SP-86.
    pub fn quarter_turns(&self) -> i64 {
        match self.boundary {
            Boundary::Mirror => 4 * self.chi - self.edge_crossings,
            Boundary::Periodic => 4 * (self.chi - self.edge_crossings),
        }
    }
}

/// The three quantities of one volume at one isovalue.
#[derive(Clone, Debug)]
pub struct Coherence {
    /// Of the exact trilinear isosurface.
    pub trilinear: Characteristic,
    /// Of the spline's isosurface.
    pub spline: Characteristic,
    /// Around Σ K(v) A(v), the curvature by splines over the exact trilinear mesh.
    pub mesh_sum: Interval,
    /// Around ∫ K dA over the spline's isosurface, by quadrature.
    pub quadrature: Quadrature,
}

impl Coherence {
    /// Around ∫ K dA over the spline's isosurface, by the degree of its Gauss map. SP-87.
    pub fn total_curvature(&self) -> Interval {
        quarter_turn() * &Interval::integer(self.spline.quarter_turns())
    }

    /// The mesh sum in units of π, to three decimals, rounded outward.
    pub fn mesh_sum_text(&self) -> String {
        in_turns(&self.mesh_sum)
    }

    /// The quadrature in units of π, to three decimals, rounded outward.
    pub fn quadrature_text(&self) -> String {
        in_turns(&of_binary64(&self.quadrature))
    }

    /// Around 2πχ of the trilinear isosurface, less π/2 for each crossing with an edge of the box.
    pub fn trilinear_turns(&self) -> Interval {
        quarter_turn() * &Interval::integer(self.trilinear.quarter_turns())
    }

    /// Whether ∫ K dA over the spline's isosurface is 2πχ of the trilinear one, border and all: a question about integers. SP-90.
    #[doc(alias = "SP-90")]
    pub fn is_coherent(&self) -> bool {
        self.spline.quarter_turns() == self.trilinear.quarter_turns()
    }
}

/// χ of both, their turns in units of π, the mesh sum and the quadrature in units of π, to three decimals, rounded outward.
impl Display for Coherence {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [spline, trilinear] = [self.spline, self.trilinear].map(|c| Rational::from((c.quarter_turns(), 2)));
        write!(f, "spline: χ {} E {} ∫K {spline}π", self.spline.chi, self.spline.edge_crossings)?;
        write!(f, "; trilinear: χ {} E {} {trilinear}π", self.trilinear.chi, self.trilinear.edge_crossings)?;
        write!(f, "; mesh {}; quadrature {}", self.mesh_sum_text(), self.quadrature_text())
    }
}

fn in_turns(x: &Interval) -> String {
    format!("{}π", outward(&x.checked_div(&Interval::pi(PRECISION)).expect("π is not 0")))
}

fn of_binary64(quadrature: &Quadrature) -> Interval {
    let bound = |x: f64| {
        Rational::from_f64(x).unwrap_or_else(|| Rational::from(Integer::from(1) << 1024_u32) * x.signum() as i32)
    };
    let (lo, hi) = (bound(quadrature.integral.lo()), bound(quadrature.integral.hi()));
    Interval::between(&lo, &hi, PRECISION).expect("the bounds are in order")
}

/// [lo, hi] to three decimals, rounded outward.
fn outward(x: &Interval) -> String {
    let Some((lo, hi)) = x.bounds() else { return "[-∞, ∞]".to_string() };
    let thousandths = |n: Integer| {
        let sign = if n.cmp0().is_lt() { "-" } else { "" };
        let (whole, rest) = n.abs().div_rem(Integer::from(1000));
        format!("{sign}{whole}.{:03}", rest.to_u32().expect("below 1000"))
    };
    let thousand = Rational::from(1000);
    let [lo, hi] = [Rational::from(&lo * &thousand).floor(), Rational::from(&hi * &thousand).ceil()]
        .map(|x| thousandths(x.into_numer_denom().0));
    format!("[{lo}, {hi}]")
}

fn quarter_turn() -> Interval {
    Interval::pi(PRECISION) * &Interval::from_rational(&Rational::from((1, 2)), PRECISION)
}

/// Why there are no such quantities.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CoherenceError {
    /// The volume is no signal, or has no room for the layer that closes a period.
    #[error(transparent)]
    Signal(#[from] SignalError),
    /// A period needs a layer more than the volume has, and there is no room for it.
    #[error(transparent)]
    Volume(#[from] VolumeError),
    /// The isovalue is a critical value of the trilinear interpolant.
    #[error(transparent)]
    Degenerate(#[from] DegenerateCell),
    /// The isovalue is one of the spline, or too near to one.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// A vertex of the trilinear mesh where the spline's gradient is 0, so that it has no curvature there.
    #[error("vertex {vertex} of the trilinear mesh: the spline's gradient is 0 there")]
    FlatVertex {
        /// Its number.
        vertex: usize,
    },
}

/// The spline's total curvature, the trilinear isosurface's 2πχ, and the mesh sum, of {f = c}.
///
/// # Errors
/// iff the isovalue is, or cannot be told from, a critical value of one of the interpolants, or ∇f = 0 for the spline at a vertex of the mesh.
pub fn coherence(level: &Level, boundary: Boundary, effort: Effort) -> Result<Coherence, CoherenceError> {
    let shape = level.volume.shape();
    let values = (0..level.volume.len()).map(|i| level.volume.sample(i)).collect();
    let spline = interpolate(&Signal::new(shape, values, boundary)?);
    let period = match boundary {
        Boundary::Mirror => level.volume.clone(),
        Boundary::Periodic => closed(level.volume)?,
    };
    let period = Level { volume: &period, ..level.clone() };
    Ok(Coherence {
        trilinear: of_trilinear(&period, boundary)?,
        spline: of_spline(&spline, &level.isovalue)?,
        mesh_sum: mesh_sum(&period, &spline)?,
        quadrature: by_quadrature(&spline, &level.isovalue, effort)?,
    })
}

/// The volume with its first layers once more at the far ends.
fn closed(volume: &Volume) -> Result<Volume, VolumeError> {
    let shape = volume.shape();
    let [nx, ny, nz] = shape.map(|n| n + 1);
    let points = (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
    let values = points.map(|p| volume.sample(volume.index([0, 1, 2].map(|a| p[a] % shape[a])))).collect();
    Volume::rationals([nx, ny, nz], values)
}

/// The edges of the box that count: along an axis, at the sides of the other two, the lower axis first.
fn edges(boundary: Boundary) -> impl Iterator<Item = (usize, [usize; 2])> {
    let sides = match boundary {
        Boundary::Mirror => 2,
        Boundary::Periodic => 1,
    };
    (0..3).flat_map(move |axis| (0..sides).flat_map(move |a| (0..sides).map(move |b| (axis, [a, b]))))
}

/// The grid point at a distance along such an edge.
fn on_edge(axis: usize, sides: [usize; 2], shape: [usize; 3], along: usize) -> [usize; 3] {
    let mut point = [0; 3];
    let others = (0..3).filter(|&a| a != axis);
    for (other, side) in others.zip(sides) {
        point[other] = side * (shape[other] - 1);
    }
    point[axis] = along;
    point
}

/// χ and E of the piecewise trilinear {f = c}; a sample that a tie was broken for is outside.
///
/// # Errors
/// iff c is a critical value in a cell, unless ties are broken.
pub fn of_trilinear(level: &Level, boundary: Boundary) -> Result<Characteristic, DegenerateCell> {
    let shape = level.volume.shape();
    let mut edge_crossings = 0;
    for (axis, sides) in edges(boundary) {
        let outside = |along: usize| level.is_outside(level.volume.index(on_edge(axis, sides, shape, along)));
        edge_crossings += (1..shape[axis]).filter(|&along| outside(along) != outside(along - 1)).count() as i64;
    }
    Ok(Characteristic { chi: topology(level)?.chi(), edge_crossings, boundary })
}

/// χ and E of the spline's {f = c}: E by Sturm's theorem on each edge of a cell, χ from it and [`quarter_turns`]. SP-86.
///
/// # Errors
/// As [`quarter_turns`].
pub fn of_spline(spline: &Spline<3>, isovalue: &Rational) -> Result<Characteristic, Unresolved> {
    let boundary = spline.coefficients().boundary();
    let turns = quarter_turns(spline, isovalue)?;
    let edge_crossings = spline_crossings(spline, isovalue);
    let chi = match boundary {
        Boundary::Mirror => (turns + edge_crossings) / 4,
        Boundary::Periodic => turns / 4 + edge_crossings,
    };
    let characteristic = Characteristic { chi, edge_crossings, boundary };
    assert_eq!(characteristic.quarter_turns(), turns, "4 divides the turns of a closed surface");
    Ok(characteristic)
}

/// How often {f = c} crosses the edges of the box that count. A regular surface passes none of its corners with a mirror boundary, where
/// ∇f = 0; with a periodic one a point at the origin counts once an axis, for the three edges end there: then χ says the same.
fn spline_crossings(spline: &Spline<3>, isovalue: &Rational) -> i64 {
    let boundary = spline.coefficients().boundary();
    let cells = spline.coefficients().shape().map(|n| match boundary {
        Boundary::Mirror => n - 1,
        Boundary::Periodic => n,
    });
    let enclosed = EnclosedSpline::new(spline, isovalue);
    let mut crossings = 0;
    for (axis, sides) in edges(boundary) {
        for along in 0..cells[axis] {
            let low = on_edge(axis, sides, cells.map(|n| n + 1), along);
            let cell = [0, 1, 2].map(|a| low[a].min(cells[a] - 1));
            let may_cross =
                enclosed.cell(cell).is_some_and(|form| may_vanish(hull(form.edge(axis, sides).into_iter())));
            if may_cross {
                crossings += roots_along(spline, isovalue, axis, low) as i64;
            }
        }
    }
    crossings
}

/// The number of 0 < t ≤ 1 with f(low + t eₐ) = c; low is a grid point, so that f is a cubic there.
fn roots_along(spline: &Spline<3>, isovalue: &Rational, axis: usize, low: [usize; 3]) -> usize {
    let mut at = low.map(Rational::from);
    let order = |n: u32| {
        let mut orders = [0; 3];
        orders[axis] = n;
        orders
    };
    let [value, first, second] = [0, 1, 2].map(|n| spline.derivative(&at, order(n)));
    at[axis] += 1;
    let [value, second] = [value - isovalue, second / 2];
    let third = spline.value(&at) - isovalue - &value - &first - &second;
    let cubic = Polynomial::new(vec![value, first, second, third]);
    // f = c along the whole edge would make a regular surface contain it, which meets the two faces at right angles: it cannot.
    SturmChain::new(&cubic).map_or(0, |chain| chain.count(&Rational::new(), &Rational::from(1)))
}

/// Around Σ K(v) A(v) over the exact mesh of the trilinear {f = c}: K the Gaussian curvature of the spline's level surface through the vertex v,
/// which is one of {f = c} on the spline only by chance, and A(v) a third of the area of the triangles at v. SP-91.
///
/// # Errors
/// iff c is a critical value in a cell, unless ties are broken, or ∇f = 0 at a vertex.
#[doc(alias = "SP-91")]
pub fn mesh_sum(level: &Level, spline: &Spline<3>) -> Result<Interval, CoherenceError> {
    let mesh = extract(level)?;
    let positions: Vec<Vector<Rational, 3>> = mesh.vertices.iter().map(|v| Vector(level.position(v))).collect();
    let gaussian = |(vertex, at): (usize, &Vector<Rational, 3>)| match curvature(&spline.jet(&at.0)) {
        Ok(surface) => Ok(surface.gaussian),
        Err(_) => Err(CoherenceError::FlatVertex { vertex }),
    };
    let curvatures = positions.iter().enumerate().map(gaussian).collect::<Result<Vec<Rational>, CoherenceError>>()?;
    let mut sum = Interval::integer(0);
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| v as usize);
        let side = |v: usize| positions[v].clone() - &positions[a];
        // Twice the area, times thrice the mean curvature.
        let area = Interval::from_rational(&side(b).cross(&side(c)).norm_squared(), PRECISION).sqrt();
        let area = area.expect("a square is not negative");
        let total = Rational::from(&curvatures[a] + &curvatures[b]) + &curvatures[c];
        sum = sum + &(area * &Interval::from_rational(&(total / 6), PRECISION));
    }
    Ok(sum)
}
