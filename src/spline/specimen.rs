//! Surfaces given by polynomials, and their samples.

use crate::isosurface::volume::{Volume, VolumeError};
use crate::number::{Integer, Multivariate, Rational, Trivariate};

/// A closed surface {f = c} in a box around the origin, f a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Specimen {
    /// x² + y² + z² = 1/2 in [−1, 1]³.
    Sphere,
    /// (x² + y² + z² + R² − r²)² = 4R²(x² + y²) with R = 5/8, r = 1/4, in [−1, 1]³.
    Torus,
    /// (x² − x⁴ − y²)² + z²/16 = 1/40 in [−3/2, 3/2] × [−1, 1] × [−1, 1]: a tube around a figure of eight.
    GenusTwo,
}

impl Specimen {
    /// All of them.
    pub const ALL: [Specimen; 3] = [Specimen::Sphere, Specimen::Torus, Specimen::GenusTwo];

    /// f.
    pub fn polynomial(self) -> Trivariate {
        let rational = |n: i64, d: i64| Multivariate::constant(Rational::from((n, d)));
        let square = |a: &Trivariate| a.clone() * a;
        let [x, y, z] = [0, 1, 2].map(|axis| square(&Multivariate::variable(axis)));
        match self {
            Specimen::Sphere => x + &y + &z,
            Specimen::Torus => {
                // R² − r² = 21/64, 4R² = 25/16
                let flat = x + &y;
                square(&(flat.clone() + &z + &rational(21, 64))) - &(flat * &rational(25, 16))
            }
            Specimen::GenusTwo => square(&(x.clone() - &square(&x) - &y)) + &(z * &rational(1, 16)),
        }
    }

    /// c.
    pub fn isovalue(self) -> Rational {
        match self {
            Specimen::Sphere => Rational::from((1, 2)),
            Specimen::Torus => Rational::new(),
            Specimen::GenusTwo => Rational::from((1, 40)),
        }
    }

    /// χ of {f = c}: 2, 0 and −2.
    pub fn chi(self) -> i64 {
        match self {
            Specimen::Sphere => 2,
            Specimen::Torus => 0,
            Specimen::GenusTwo => -2,
        }
    }

    /// f on a grid of n + 1 samples along y and z, 2/n apart, and as many as the box asks for along x.
    ///
    /// # Errors
    /// As [`Volume::rationals`]: n = 0, or too many samples. Where n is odd the box of genus 2 is cut to whole cells.
    pub fn volume(self, n: usize) -> Result<Volume, VolumeError> {
        let across = match self {
            Specimen::Sphere | Specimen::Torus => n,
            Specimen::GenusTwo => n / 2 * 3,
        };
        let shape = [across + 1, n + 1, n + 1];
        let f = self.polynomial();
        let points = (0..=n).flat_map(|k| (0..=n).flat_map(move |j| (0..=across).map(move |i| [i, j, k])));
        let values = points.map(|p| {
            // 2i/n − (n − 1 of the axis)/n
            let at =
                [0, 1, 2].map(|a| Rational::from((Integer::from(2 * p[a]) - (shape[a] - 1), Integer::from(n.max(1)))));
            f.evaluate(&at)
        });
        Volume::rationals(shape, values.collect())
    }
}
