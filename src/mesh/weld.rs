//! Triangle soups: giving one number to vertices at one position.

use super::triangles::Triangle;
use std::collections::HashMap;
use std::hash::Hash;

/// A mesh whose vertices at exactly equal positions are one; the first of them stays. Triangles that
/// thereby lose a corner are kept as they are, for whoever judges them.
pub fn weld<P: Clone + Eq + Hash>(vertices: &[P], triangles: &[Triangle]) -> (Vec<P>, Vec<Triangle>) {
    let mut numbers: HashMap<&P, u32> = HashMap::with_capacity(vertices.len());
    let mut kept = Vec::new();
    let map: Vec<u32> = vertices
        .iter()
        .map(|position| {
            *numbers.entry(position).or_insert_with(|| {
                kept.push(position.clone());
                kept.len() as u32 - 1
            })
        })
        .collect();
    let welded = triangles.iter().map(|t| t.map(|v| map.get(v as usize).copied().unwrap_or(u32::MAX))).collect();
    (kept, welded)
}

/// Whether every vertex belongs to exactly one triangle: nothing is shared, so nothing is said of what is
/// connected.
pub fn is_soup(vertices: usize, triangles: &[Triangle]) -> bool {
    let mut used = vec![false; vertices];
    !triangles.is_empty()
        && vertices == 3 * triangles.len()
        && triangles
            .iter()
            .flatten()
            .all(|&v| used.get_mut(v as usize).is_some_and(|seen| !std::mem::replace(seen, true)))
}
