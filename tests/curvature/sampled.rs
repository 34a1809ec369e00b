//! Samples on a grid, and what a rotation leaves of them.

use super::level::{point, terms};
use super::q;
use isoracle::curvature::implicit_surface;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::motion::{Affine, Orthogonal};
use isoracle::curvature::sampled::{central_jet, moved_central_jet};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, Rational, Sign};
use proptest::prelude::*;

/// About the axis z, by the angle of 3, 4, 5.
fn turn() -> Affine {
    let rows = [[q(3, 5), q(-4, 5), q(0, 1)], [q(4, 5), q(3, 5), q(0, 1)], [q(0, 1), q(0, 1), q(1, 1)]];
    Affine::rigid(&Orthogonal::new(Matrix(rows)).expect("orthogonal"), Vector::zero())
}

/// The symmetries of the grid that fix the origin: signed permutations.
fn grid_symmetries() -> Vec<Orthogonal> {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let signed = orders.iter().flat_map(|order| (0..8_u32).map(move |signs| (order, signs)));
    let matrix = |(order, signs): (&[usize; 3], u32)| {
        Matrix::from_fn(|i, j| {
            q(
                if order[i] != j {
                    0
                } else if signs >> i & 1 == 1 {
                    -1
                } else {
                    1
                },
                1,
            )
        })
    };
    signed.map(|s| Orthogonal::new(matrix(s)).expect("orthogonal")).collect()
}

mod cu_211 {
    use super::*;

    #[test]
    fn of_the_small_rotations_24_keep_the_grid() {
        let range = -2..=2_i64;
        let mut kept = Vec::new();
        for a in range.clone() {
            for b in range.clone() {
                for c in range.clone() {
                    for d in range.clone() {
                        let Ok(r) = Orthogonal::of_quaternion(&[a, b, c, d].map(Rational::from)) else { continue };
                        // It keeps the grid iff it takes the three unit vectors to grid points.
                        let images = (0..3).all(|j| r.matrix().column(j).0.iter().all(Rational::is_integer));
                        assert_eq!(r.keeps_lattice(), images);
                        if images && !kept.contains(&r) {
                            kept.push(r);
                        }
                    }
                }
            }
        }
        assert_eq!(kept.len(), 24);
        let symmetries = grid_symmetries();
        assert!(kept.iter().all(|r| symmetries.contains(r)));
        assert_eq!(symmetries.iter().filter(|r| r.orientation() == Sign::Positive).count(), 24);
        assert!(symmetries.iter().all(Orthogonal::keeps_lattice));
    }

    #[test]
    fn turned_by_3_4_5_a_sample_falls_between_samples() {
        let image = turn().image(&Vector([1, 0, 0].map(Rational::from)));
        assert_eq!(image, Vector([q(3, 5), q(4, 5), q(0, 1)]));
        // The samples of x⁴ and of the turned x⁴ at e₁: 1 and (3/5)⁴, which is none of 0, 1, 16, 81, …
        let f = terms(&[([4, 0, 0], 1)]);
        assert_eq!(turn().moved(&f).evaluate(&[1, 0, 0].map(Rational::from)), q(81, 625));
    }
}

mod cu_212 {
    use super::*;

    fn curvature(jet: &Jet<Rational, 3>) -> (Rational, Rational) {
        let level = implicit_surface::curvature(jet).expect("regular");
        (level.gaussian, level.mean_squared)
    }

    proptest! {
        #[test]
        fn central_differences_are_exact_for_degree_2(
            coefficients in prop::array::uniform10(-4..=4_i64), at in prop::array::uniform3(-3..=3_i64),
        ) {
            let exponents = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0], [1, 1, 0], [1, 0, 1], [0, 2, 0], [0, 1, 1], [0, 0, 2]];
            let f = Multivariate::new(exponents.into_iter().zip(coefficients.map(Rational::from)));
            let exact = Jet::of_polynomial(&f, &at.map(Rational::from));
            prop_assert_eq!(central_jet(|p| f.evaluate(&p.map(Rational::from)), at), exact);
        }

        /// Where the grid is kept, so is what is measured on it.
        #[test]
        fn grid_symmetries_keep_what_is_measured(
            f in super::super::level::polynomial(), at in prop::array::uniform3(-2..=2_i64), which in 0..48_usize,
            shift in prop::array::uniform3(-3..=3_i64),
        ) {
            let symmetry = Affine::rigid(&grid_symmetries()[which], Vector(shift.map(Rational::from)));
            let measured = central_jet(|p| f.evaluate(&p.map(Rational::from)), at);
            let there = symmetry.image(&Vector(at.map(Rational::from)));
            let there = there.0.map(|x| x.numer().to_i64().expect("small"));
            prop_assert_eq!(moved_central_jet(&f, &symmetry, there), symmetry.moved_jet(&measured));
        }

        #[test]
        fn all_motions_keep_the_measured_curvature_of_quadrics(b in point()) {
            // x² + 2y² + 3z at the origin, turned and shifted: any step of the samples gives the exact jet.
            let f = terms(&[([2, 0, 0], 1), ([0, 2, 0], 2), ([0, 0, 1], 3)]);
            let motion = Affine::rigid(&Orthogonal::cayley(&Vector(b)), Vector::zero());
            let exact = motion.moved_jet(&Jet::of_polynomial(&f, &[0, 0, 0].map(Rational::from)));
            prop_assert_eq!(moved_central_jet(&f, &motion, [0; 3]), exact);
        }
    }

    #[test]
    fn turned_by_3_4_5_the_measured_curvature_of_a_quartic_is_another() {
        // z − x⁴ at the origin: flat there, K = H = 0; measured g_xx = 2, and after the turn 2·337/625 along both axes.
        let f = terms(&[([0, 0, 1], 1), ([4, 0, 0], -1)]);
        let exact = curvature(&Jet::of_polynomial(&f, &[0, 0, 0].map(Rational::from)));
        let measured = curvature(&central_jet(|p| f.evaluate(&p.map(Rational::from)), [0; 3]));
        let turned = curvature(&moved_central_jet(&f, &turn(), [0; 3]));
        assert_eq!(exact, (q(0, 1), q(0, 1)));
        assert_eq!(measured, (q(0, 1), q(1, 1)));
        // f_xx = −2·(3/5)⁴, f_yy = −2·(4/5)⁴, f_xy = −(7⁴ − 1)/(2·5⁴): K = f_xx f_yy − f_xy², H = −(f_xx + f_yy)/2
        let k = q(4 * 81 * 256, 390_625) - q(1200, 625).square();
        assert_eq!(turned, (k, q(337, 625).square()));
    }
}
