//! The smallest cells of the 33 cases.

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Tie, assemble, decide, topology};
use isoracle::isosurface::witness::smallest;
use isoracle::number::{Rational, Word};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Greatest |value| and Σ |value|: what is least.
fn size(cell: &[i32; 8]) -> (i32, i32) {
    let magnitudes = cell.map(i32::abs);
    (magnitudes.into_iter().max().expect("eight values"), magnitudes.into_iter().sum())
}

mod is_83 {
    use super::*;

    #[test]
    fn the_witness_of_a_case_is_of_that_case() {
        for &case in Case::ALL {
            let topology = topology(&smallest(case).map(Rational::from), &Rational::new(), Tie::Degenerate);
            assert_eq!(topology.expect("no witness is degenerate").case, case);
        }
    }

    #[test]
    fn no_cell_of_the_case_is_smaller() {
        // All 8⁸ cells with values in ±1 … ±4, the degenerate ones left out.
        let smallest_of = |low: i32| {
            let mut least: BTreeMap<Case, (i32, i32)> = BTreeMap::new();
            for code in 0..8u32.pow(6) {
                let value = |digit: u32| [-4, -3, -2, -1, 1, 2, 3, 4][digit as usize];
                let cell: [i32; 8] = std::array::from_fn(|i| match i {
                    0 => value(low as u32 % 8),
                    1 => value(low as u32 / 8),
                    _ => value(code / 8u32.pow(i as u32 - 2) % 8),
                });
                if let Ok(decisions) = decide(&cell.map(|v| Word(v.into()))) {
                    let size = size(&cell);
                    least.entry(Case::of(&decisions)).and_modify(|known| *known = size.min(*known)).or_insert(size);
                }
            }
            least
        };
        let least = (0..64).into_par_iter().map(smallest_of).reduce(BTreeMap::new, |mut a, b| {
            for (case, size) in b {
                a.entry(case).and_modify(|known| *known = size.min(*known)).or_insert(size);
            }
            a
        });
        let frozen: BTreeMap<Case, (i32, i32)> = Case::ALL.iter().map(|&case| (case, size(&smallest(case)))).collect();
        assert_eq!(least, frozen);
    }

    #[test]
    fn the_table_of_the_entry_is_what_the_witnesses_show() {
        let number = |word: &str| word.replace('−', "-").parse::<i32>().expect("a number");
        let numbers = |text: &str| text.split(", ").filter(|w| *w != "–").map(number).collect::<Vec<_>>();
        let mut rows = 0;
        for line in include_str!("../../spec/isosurface.md").lines().filter(|line| line.starts_with("| ")) {
            let columns: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            let Ok(case) = columns[0].parse::<Case>() else { continue };
            let [_, _, loops, components, chi, b0, annulus, cell] = columns[..] else { continue };
            rows += 1;
            let cell: Vec<i32> = cell.split(' ').map(number).collect();
            assert_eq!(cell, smallest(case), "{case}");
            let values = smallest(case).map(|v| Word(v.into()));
            let topology = assemble(decide(&values).expect("no witness is degenerate"));
            let mut lengths: Vec<i32> = topology.loops.iter().map(|l| l.len() as i32).collect();
            lengths.sort_by_key(|n| -n);
            assert_eq!(lengths, numbers(loops), "{case}: loops");
            assert_eq!(topology.components.len() as i32, number(components), "{case}: components");
            assert_eq!(topology.chi(), i64::from(number(chi)), "{case}: χ");
            let mut parts = vec![topology.negative.parts.len() as i32, topology.positive.parts.len() as i32];
            parts.sort();
            assert_eq!(parts, numbers(b0), "{case}: b0");
            let mut rims: Vec<i32> = topology
                .components
                .iter()
                .filter(|c| c.chi == 0)
                .flat_map(|c| c.loops.iter().map(|&l| topology.loops[l].len() as i32))
                .collect();
            rims.sort();
            let listed: Vec<i32> = annulus.split(" + ").filter(|w| !w.is_empty()).map(number).collect();
            assert_eq!(rims, listed, "{case}: annulus");
        }
        assert_eq!(rows, Case::ALL.len());
    }
}
