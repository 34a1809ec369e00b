//! The chain complex of the cells, with a direction for each of them.

use super::closed_complex::ClosedComplex;
use super::flag::Flag;
use crate::mesh::homology::{Chain, ChainComplex};

impl ClosedComplex {
    /// The chain complex C₃ → C₂ → C₁ → C₀ of its cells, each directed as its first flag says: an edge leaves the flag's
    /// vertex, a face is walked from there along the edge, a polyhedron has the first face so.
    pub fn chain_complex(&self) -> ChainComplex {
        let flags = self.flags();
        let [vertices, edges, faces, polyhedra] = self.counts();
        // A flag stands for the directed cell of dimension k: even steps of the maps below k keep its direction.
        let signs = [&[][..], &[0], &[0, 1], &[0, 1, 2]].map(|maps| self.directions(maps));
        let mut boundaries = vec![vec![Chain::new(); vertices]];
        for (k, count) in [(1, edges), (2, faces), (3, polyhedra)] {
            let mut cells = vec![Chain::new(); count];
            // One flag of each part of the boundary, which is a cell of dimension k − 1 seen from this one.
            let maps: Vec<usize> = (0..4).filter(|i| *i != k - 1 && *i < k).chain(k + 1..4).collect();
            let (part_of, parts) = flags.orbits(&maps);
            let mut seen = vec![false; parts];
            for flag in flags.all() {
                let i = flag.0 as usize;
                if std::mem::replace(&mut seen[part_of[i] as usize], true) {
                    continue;
                }
                // The vertex that an edge leaves counts −1.
                let sign = if (signs[k][i] == signs[k - 1][i]) == (k != 1) { 1 } else { -1 };
                *cells[self.cell(k, flag) as usize].entry(self.cell(k - 1, flag) as usize).or_default() += sign;
            }
            boundaries.push(cells);
        }
        ChainComplex::new(boundaries).expect("the boundary of a boundary is nothing")
    }

    /// Whether each flag has the direction of the first flag of its cell, whose dimension is the number of maps.
    fn directions(&self, maps: &[usize]) -> Vec<bool> {
        let (k, flags) = (maps.len(), self.flags());
        let mut directions: Vec<Option<bool>> = vec![None; flags.len()];
        for first in flags.all() {
            let mut pending = vec![(first, true)];
            if directions[first.0 as usize].is_some() {
                continue;
            }
            while let Some((flag, direction)) = pending.pop() {
                if directions[flag.0 as usize].replace(direction).is_some() {
                    continue;
                }
                let neighbours =
                    (0..4).filter(|i| *i != k).map(|i| (flags.sigma(i, flag), direction ^ maps.contains(&i)));
                pending.extend(neighbours.filter(|(Flag(i), _)| directions[*i as usize].is_none()));
            }
        }
        directions.into_iter().map(|d| d.expect("every flag was reached")).collect()
    }
}
