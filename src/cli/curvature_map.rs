//! Isosurface meshes painted by the curvature of the spline.

use super::interpolant::{Curvatures, surfaces};
use clap::ValueEnum;
use isoracle::answer::mesh::record;
use isoracle::format::ply_painted::{self, Painted};
use isoracle::format::{FormatError, MeshRecord};
use isoracle::isosurface::mesh::Mesh;
use isoracle::isosurface::volume::Level;
use isoracle::number::Rational;
use isoracle::number::binary::nearest_f64;
use isoracle::spline::prefilter::fast::Enclosed;
use miette::Diagnostic;
use std::path::Path;
use thiserror::Error;

/// Which curvature colours stand for.
#[derive(Clone, Copy, ValueEnum)]
pub enum Map {
    /// K.
    Gaussian,
    /// H.
    Mean,
    /// The larger principal curvature.
    K1,
    /// The smaller principal curvature.
    K2,
}

impl Map {
    const fn name(self) -> &'static str {
        match self {
            Map::Gaussian => "gaussian",
            Map::Mean => "mean",
            Map::K1 => "k1",
            Map::K2 => "k2",
        }
    }

    fn of(self, curvatures: &Curvatures) -> f64 {
        match self {
            Map::Gaussian => curvatures.gaussian,
            Map::Mean => curvatures.mean,
            Map::K1 => curvatures.principal[0],
            Map::K2 => curvatures.principal[1],
        }
    }
}

#[derive(Debug, Error, Diagnostic)]
pub enum Failure {
    #[error("--out: {0}")]
    #[diagnostic(help("the mesh could not be written"))]
    Out(FormatError),
}

/// A painted mesh.
pub struct PaintedMesh {
    mesh: MeshRecord,
    paint: Vec<Painted>,
    map: Map,
    slope: f64,
    singular: usize,
}

/// Paints each vertex by the curvature of the spline's level surface through it: blue through green to red as n_λ goes from 0 through 1/2
/// to 1, and grey where the gradient is zero.
pub fn paint(
    level: &Level,
    mesh: &Mesh,
    spline: &Enclosed<'_, f64, 3>,
    map: Map,
    slope: Option<&Rational>,
) -> miette::Result<PaintedMesh> {
    let places: Vec<[Rational; 3]> = mesh.vertices.iter().map(|vertex| level.position(vertex)).collect();
    let surfaces = surfaces(spline, &places)?;
    let numbers: Vec<Option<f64>> =
        surfaces.iter().map(|surface| surface.curvatures.as_ref().map(|curvatures| map.of(curvatures))).collect();
    let slope = slope.map_or_else(|| slope_by_median(&numbers), nearest_f64);
    let paint = numbers.iter().map(|number| match number {
        Some(number) => Painted { colour: colour(normalized(slope, *number)), number: *number },
        None => Painted { colour: [128; 3], number: f64::NAN },
    });
    let singular = numbers.iter().filter(|number| number.is_none()).count();
    Ok(PaintedMesh { paint: paint.collect(), mesh: record(mesh, level), map, slope, singular })
}

impl PaintedMesh {
    pub fn write(&self, path: &Path) -> Result<(), Failure> {
        ply_painted::write(path, &self.mesh, self.map.name(), &self.paint).map_err(Failure::Out)
    }

    /// How much there is, and what the colours mean.
    pub fn summary(&self) -> String {
        let (vertices, triangles) = (self.mesh.vertices.len(), self.mesh.faces.len());
        let numbers = self.paint.iter().map(|paint| paint.number).filter(|number| !number.is_nan());
        let (least, most) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let name = self.map.name();
        let range = if least <= most { format!(", {name} from {least:.4} to {most:.4}") } else { String::new() };
        let singular = match self.singular {
            0 => String::new(),
            n => format!(", grey at {n} singular points"),
        };
        format!("{vertices} vertices, {triangles} triangles{range}, λ = {:.4}{singular}", self.slope)
    }
}

/// The λ that takes the median of the absolute values to 3/4: 1 − e^(−λm)/2 = 3/4.
fn slope_by_median(numbers: &[Option<f64>]) -> f64 {
    let mut sizes: Vec<f64> = numbers.iter().flatten().map(|number| number.abs()).filter(|size| *size > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).map_or(1.0, |median| std::f64::consts::LN_2 / median)
}

/// n_λ, rounded: it only chooses a colour.
fn normalized(slope: f64, x: f64) -> f64 {
    let half_power = (-slope * x.abs()).exp() / 2.0;
    if x < 0.0 { half_power } else { 1.0 - half_power }
}

/// Blue at 0, green at 1/2, red at 1.
fn colour(t: f64) -> [u8; 3] {
    let channel = |share: f64| (share.clamp(0.0, 1.0) * 255.0).round() as u8;
    [channel(2.0 * t - 1.0), channel(1.0 - (2.0 * t - 1.0).abs()), channel(1.0 - 2.0 * t)]
}
