//! The spline's total curvature beside the trilinear isosurface's 2πχ on crops of a real scan.
#![cfg(feature = "cli")]

use super::q;
use isoracle::format::{Limits, nrrd};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::number::decimal::Digits;
use isoracle::number::{Interval, Rational};
use isoracle::spline::coherence::{Characteristic, mesh_sum, of_spline, of_trilinear};
use isoracle::spline::prefilter_fast_exact::interpolate;
use isoracle::spline::signal::{Boundary, Signal};

/// A crop of n³ samples with the corner (24, 24, 24), at the isovalue 127/2.
fn row(head: &Volume, n: usize) -> String {
    let crop = head.crop([24; 3], [23 + n; 3]).expect("within the volume");
    let level = Level { volume: &crop, isovalue: q(127, 2), tie: Tie::Below };
    let values = (0..crop.len()).map(|i| crop.sample(i)).collect();
    let spline = interpolate(&Signal::new(crop.shape(), values, Boundary::Mirror).expect("a volume is a signal"));
    let turns = |c: Characteristic| Rational::from((c.quarter_turns(), 2));
    let found = of_spline(&spline, &level.isovalue).expect("regular");
    let trilinear = of_trilinear(&level, Boundary::Mirror).expect("ties are broken");
    let sum = match mesh_sum(&level, &spline) {
        Ok(sum) => {
            let sum = sum.checked_div(&Interval::pi(96)).expect("π is not 0");
            let sum = sum.decimals(Digits::new(3).expect("few digits")).expect("narrow enough");
            format!("[{}, {}]π", sum.lo, sum.hi)
        }
        Err(error) => error.to_string(),
    };
    let [spline, of_mesh] = [found, trilinear].map(|c| format!("χ {} E {} {}π", c.chi, c.edge_crossings, turns(c)));
    format!("{n}³: ∫K of the spline {spline}; 2πχ of the trilinear {of_mesh}; mesh {sum}\n")
}

mod sp_90 {
    use super::*;

    /// ∫ K dA of the spline's isosurface is exact here, by the degree of its Gauss map; the two differ on every crop that is not small.
    #[test]
    fn crops_of_a_scan() {
        let bytes = include_bytes!("../../data/mni152_crop.nrrd");
        let head = nrrd::read(&bytes[..], &Limits::default()).expect("the crate's own file");
        let head = Volume::try_from(head).expect("a volume");
        let is_long = std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1");
        let table = |sizes: &[usize]| sizes.iter().map(|n| row(&head, *n)).collect::<String>();
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../../snapshots");
        settings.set_prepend_module_to_snapshot(false);
        settings.bind(|| {
            insta::assert_snapshot!("sp_90__scan", table(&[8, 12, 16]));
            if is_long {
                insta::assert_snapshot!("sp_90__scan_long", table(&[20, 24, 32, 40]));
            }
        });
    }
}
