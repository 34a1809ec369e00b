//! Sampled grids and their cubic splines, for the command line: in certified binary64 numbers, or exactly.

use clap::ValueEnum;
use isoracle::answer::spline::MAX_EXACT_SAMPLES;
use isoracle::answer::value::MAX_SAMPLES;
use isoracle::curvature::jet::Jet;
use isoracle::format::{self, FormatError, Limits, Samples};
use isoracle::isosurface::volume::Volume;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::Rational;
use isoracle::number::binary::{exact_f64, nearest_f64};
use isoracle::number::text::{self, NumberError};
use isoracle::spline::prefilter::fast::{Enclosed, FastError, JetError, LevelSurface64};
use isoracle::spline::prefilter_fast_exact::{self, IntegerSpline};
use isoracle::spline::signal::{Boundary, Signal, SignalError, check_shape};
use isoracle::spline::tensor::Spline;
use miette::Diagnostic;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// How samples go on beyond the grid, as an option.
#[derive(Clone, Copy, ValueEnum)]
pub enum BoundaryRule {
    /// Mirrored at the first and the last sample.
    Mirror,
    /// Repeated: after the last sample comes the first.
    Periodic,
}

impl From<BoundaryRule> for Boundary {
    fn from(rule: BoundaryRule) -> Boundary {
        match rule {
            BoundaryRule::Mirror => Boundary::Mirror,
            BoundaryRule::Periodic => Boundary::Periodic,
        }
    }
}

/// Why samples have no spline here.
#[derive(Debug, Error, Diagnostic)]
pub enum Failure {
    #[error("{0}")]
    #[diagnostic(help(
        "samples are a .npy file of one to three axes, a .nrrd or .nhdr file of three, or a .txt file of numbers"
    ))]
    Format(FormatError),
    #[error("{}: {error}", .path.display())]
    #[diagnostic(help(
        "samples are a .npy file of one to three axes, a .nrrd or .nhdr file of three, or a .txt file of numbers"
    ))]
    Text { path: PathBuf, error: io::Error },
    #[error("{}: number {number}: {error}", .path.display())]
    #[diagnostic(help("a number is exact: 3, -7/2, 0.1 (one tenth, not the binary64 nearest to it), 0x1.8p-3"))]
    Number { path: PathBuf, number: usize, error: NumberError },
    #[error("{0}")]
    #[diagnostic(help("a cubic spline needs at least 2 samples along each axis"))]
    Signal(SignalError),
    #[error("{0}")]
    #[diagnostic(help("every sample must be a number, and what comes of them within the range of binary64"))]
    Fast(FastError),
    #[error("{0}")]
    #[diagnostic(help("a result is beyond the range of binary64; --exact has no such range"))]
    Jet(JetError),
    #[error("--volume: a sample is no binary64 number")]
    #[diagnostic(help("--exact takes any integers, of at most 524,288 samples"))]
    NotBinary64,
    #[error("sample {0} is NaN or infinite")]
    #[diagnostic(help("every sample must be a number"))]
    NotFinite(usize),
    #[error("{samples} samples are more than the {MAX_EXACT_SAMPLES} that are interpolated exactly")]
    #[diagnostic(help("without --exact, and with samples that are binary64 numbers, there may be 2²⁸"))]
    TooManySamples { samples: usize },
}

/// Samples of one to three axes, the first one fastest.
pub struct Grid {
    shape: Vec<usize>,
    values: Values,
}

enum Values {
    Floats(Vec<f64>),
    Rationals(Vec<Rational>),
}

/// Reads samples from a file.
pub fn read_grid(path: &Path) -> Result<Grid, Failure> {
    let (shape, values) = if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("txt")) {
        let values = numbers(path)?;
        (vec![values.len()], Values::Rationals(values))
    } else {
        let record = format::read_grid(path, &Limits { samples: MAX_SAMPLES }).map_err(Failure::Format)?;
        (record.shape, Values::of(record.samples))
    };
    let grid = Grid { shape, values };
    check_shape(&grid.shape, grid.len()).map_err(Failure::Signal)?;
    Ok(grid)
}

/// The numbers of a text, between blanks.
fn numbers(path: &Path) -> Result<Vec<Rational>, Failure> {
    let text = fs::read_to_string(path).map_err(|error| Failure::Text { path: path.to_owned(), error })?;
    let number = |(i, word): (usize, &str)| {
        text::parse(word).map_err(|error| Failure::Number { path: path.to_owned(), number: i + 1, error })
    };
    text.split_whitespace().enumerate().map(number).collect()
}

impl Values {
    fn of(samples: Samples) -> Values {
        fn floats<T: Into<f64>>(values: Vec<T>) -> Values {
            Values::Floats(values.into_iter().map(T::into).collect())
        }
        fn integers<T: Copy>(values: &[T]) -> Values
        where
            Rational: From<T>,
        {
            Values::of_rationals(values.iter().map(|&value| Rational::from(value)).collect())
        }
        match samples {
            Samples::U8(values) => floats(values),
            Samples::I8(values) => floats(values),
            Samples::U16(values) => floats(values),
            Samples::I16(values) => floats(values),
            Samples::U32(values) => floats(values),
            Samples::I32(values) => floats(values),
            Samples::F32(values) => floats(values),
            Samples::F64(values) => Values::Floats(values),
            Samples::U64(values) => integers(&values),
            Samples::I64(values) => integers(&values),
        }
    }

    /// As binary64 numbers, where they are some.
    fn of_rationals(values: Vec<Rational>) -> Values {
        match values.iter().map(exact_f64).collect() {
            Some(floats) => Values::Floats(floats),
            None => Values::Rationals(values),
        }
    }
}

impl Grid {
    /// The number of samples along each axis.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    fn len(&self) -> usize {
        match &self.values {
            Values::Floats(values) => values.len(),
            Values::Rationals(values) => values.len(),
        }
    }

    /// The spline in certified binary64 numbers, or, where samples are none, the exact one.
    ///
    /// # Panics
    /// Iff there are not N axes.
    pub fn interpolant<const N: usize>(&self, boundary: BoundaryRule) -> Result<Interpolant<'_, N>, Failure> {
        match &self.values {
            Values::Floats(values) => {
                let shape = self.shape.as_slice().try_into().expect("there are N axes");
                Enclosed::new(values, shape, boundary.into()).map(Interpolant::Enclosed).map_err(Failure::Fast)
            }
            Values::Rationals(_) => self.exact(boundary).map(Interpolant::Exact),
        }
    }

    /// The exact spline.
    ///
    /// # Panics
    /// Iff there are not N axes.
    pub fn exact<const N: usize>(&self, boundary: BoundaryRule) -> Result<Spline<N>, Failure> {
        if self.len() > MAX_EXACT_SAMPLES {
            return Err(Failure::TooManySamples { samples: self.len() });
        }
        let values = match &self.values {
            Values::Floats(values) => values
                .iter()
                .enumerate()
                .map(|(i, x)| Rational::from_f64(*x).ok_or(Failure::NotFinite(i)))
                .collect::<Result<_, _>>()?,
            Values::Rationals(values) => values.clone(),
        };
        let shape = self.shape.as_slice().try_into().expect("there are N axes");
        Ok(prefilter_fast_exact::interpolate(&Signal::new(shape, values, boundary.into()).map_err(Failure::Signal)?))
    }
}

/// A cubic spline that is asked for correctly rounded numbers.
pub enum Interpolant<'a, const N: usize> {
    /// In certified binary64 numbers.
    Enclosed(Enclosed<'a, f64, N>),
    /// In rationals.
    Exact(Spline<N>),
}

/// The curvatures of the level surface through a point.
pub struct Curvatures {
    pub gaussian: f64,
    pub mean: f64,
    pub principal: [f64; 2],
}

/// A point of a level surface; no curvatures where the gradient is zero.
pub struct SurfacePoint {
    pub value: f64,
    pub gradient: [f64; 3],
    pub curvatures: Option<Curvatures>,
}

impl<const N: usize> Interpolant<'_, N> {
    /// f, ∇f and the Hessian at each point.
    pub fn jets(&self, points: &[[Rational; N]]) -> Result<Vec<Jet<f64, N>>, Failure> {
        match self {
            Interpolant::Enclosed(enclosed) => {
                enclosed.jets(points).into_iter().collect::<Result<_, _>>().map_err(Failure::Jet)
            }
            Interpolant::Exact(spline) => Ok(points.iter().map(|point| rounded(&spline.jet(point))).collect()),
        }
    }

    /// The coefficients.
    pub fn into_coefficients(self) -> Result<Vec<f64>, Failure> {
        match self {
            Interpolant::Enclosed(enclosed) => enclosed.into_coefficients().map_err(Failure::Fast),
            Interpolant::Exact(spline) => Ok(spline.coefficients().values().iter().map(nearest_f64).collect()),
        }
    }
}

fn rounded<const N: usize>(jet: &Jet<Rational, N>) -> Jet<f64, N> {
    Jet {
        value: nearest_f64(&jet.value),
        gradient: Vector(jet.gradient.0.each_ref().map(nearest_f64)),
        hessian: Matrix(jet.hessian.0.each_ref().map(|row| row.each_ref().map(nearest_f64))),
    }
}

/// The level surfaces through points, every number correctly rounded.
pub fn surfaces(volume: &Enclosed<'_, f64, 3>, points: &[[Rational; 3]]) -> Result<Vec<SurfacePoint>, Failure> {
    let point = |jet: Jet<f64, 3>, curvatures| SurfacePoint { value: jet.value, gradient: jet.gradient.0, curvatures };
    let answers = volume.level_surfaces(points).into_iter().zip(points).map(|(surface, at)| match surface {
        Ok(LevelSurface64 { jet, gaussian, mean, principal }) => {
            Ok(point(jet, Some(Curvatures { gaussian, mean, principal })))
        }
        Err(JetError::Singular { .. }) => {
            let mut jets = volume.jets(std::slice::from_ref(at));
            jets.pop().expect("a jet a point").map(|jet| point(jet, None))
        }
        Err(error @ JetError::Overflow { .. }) => Err(error),
    });
    answers.collect::<Result<_, _>>().map_err(Failure::Jet)
}

/// The exact spline of a volume.
pub fn exact(volume: &Volume, boundary: BoundaryRule) -> Result<IntegerSpline<3>, Failure> {
    if volume.len() > MAX_EXACT_SAMPLES {
        return Err(Failure::TooManySamples { samples: volume.len() });
    }
    let values = (0..volume.len()).map(|i| volume.sample(i)).collect();
    let signal = Signal::new(volume.shape(), values, boundary.into()).map_err(Failure::Signal)?;
    Ok(IntegerSpline::interpolate(&signal))
}
