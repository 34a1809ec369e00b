//! Homology of large triangulations: the fast twin of [`Triangulation::chain_complex`] and its Smith forms, in nearly linear time.

use super::relations::Relations;
use super::triangulation::{EDGES, Triangulation};
use super::triangulation_chain::{ReversedEdge, corners_of_triangle};
use crate::mesh::homology::Homology;
use crate::partition::Partition;
use std::collections::VecDeque;

const UNKNOWN: u32 = u32::MAX;

/// H₀ … H₃ over ℤ of a closed triangulation (CX-67, CX-68, CX-79), the links of its vertices being any surfaces.
///
/// H₀ and H₃ are the components and those that can be oriented. H₁ is ℤ^E modulo a spanning forest of the vertices and the
/// boundaries of the triangles: what the edges are there is found triangle by triangle. H₂ has the torsion ℤ/2 for each
/// component that cannot be oriented, and the rank that χ leaves for it.
///
/// # Errors
/// Iff an edge is glued to itself, tail to head: the first one.
#[doc(alias = "CX-67")]
#[doc(alias = "CX-68")]
#[doc(alias = "CX-79")]
pub fn homology(triangulation: &Triangulation) -> Result<Homology, ReversedEdge> {
    let cells = Cells::new(triangulation)?;
    let components = triangulation.components().orientable;
    let orientable = components.iter().filter(|orientable| **orientable).count();
    let h1 = cells.relations().group();
    let [v, e, f, t] = [cells.vertices, cells.ends.len(), cells.triangles.len(), triangulation.len()].map(|n| n as i64);
    // χ is the alternating sum of the ranks too.
    let b2 = v - e + f - t - components.len() as i64 + h1.rank as i64 + orientable as i64;
    let b2 = usize::try_from(b2).expect("a rank is not negative");
    let twos = vec![2.into(); components.len() - orientable];
    Ok(Homology {
        betti: vec![components.len(), h1.rank, b2, orientable],
        torsion: vec![Vec::new(), h1.torsion, twos, Vec::new()],
    })
}

/// The cells of dimension ≤ 2. A directed edge is 2e, or 2e + 1 against the direction of edge e.
#[derive(Debug)]
struct Cells {
    vertices: usize,
    /// Where each edge begins and ends.
    ends: Vec<[u32; 2]>,
    /// The directed edges around each triangle.
    triangles: Vec<[u32; 3]>,
}

impl Cells {
    fn new(triangulation: &Triangulation) -> Result<Cells, ReversedEdge> {
        let (edges, count) = edges(triangulation)?;
        let (corners, vertices) = vertices(triangulation);
        let mut ends = vec![[UNKNOWN; 2]; count as usize];
        let mut triangles = Vec::with_capacity(2 * triangulation.len());
        for (t, gluings) in triangulation.gluings().iter().enumerate() {
            for (edge, [i, j]) in edges[t].iter().zip(EDGES) {
                let [tail, head] = if edge % 2 == 0 { [i, j] } else { [j, i] };
                ends[*edge as usize / 2] = [corners[4 * t + tail], corners[4 * t + head]];
            }
            for (i, gluing) in gluings.iter().enumerate() {
                if (t, i) < (gluing.tetrahedron as usize, gluing.corners.image(i)) {
                    let [a, b, c] = corners_of_triangle(i);
                    triangles.push([edges[t][EDGE[b][c]], edges[t][EDGE[a][c]] ^ 1, edges[t][EDGE[a][b]]]);
                }
            }
        }
        Ok(Cells { vertices, ends, triangles })
    }

    /// ℤ^E modulo the edges of a spanning forest and the boundaries of the triangles.
    ///
    /// A triangle with one edge that is not known yet tells what it is; one whose edges are all known tells a relation. Where no
    /// triangle has just one unknown edge, an unknown edge becomes a generator.
    fn relations(&self) -> Relations {
        let edge = |directed: u32| directed as usize / 2;
        let mut group = Relations::new();
        let mut values = vec![UNKNOWN; self.ends.len()];
        self.forest().into_iter().for_each(|edge| values[edge as usize] = 0);
        let at = Incidence::new(self.ends.len(), self.triangles.iter().map(|sides| sides.map(|side| side / 2)));
        let mut unknown: Vec<u8> = (self.triangles.iter())
            .map(|sides| sides.iter().filter(|side| values[edge(**side)] == UNKNOWN).count() as u8)
            .collect();
        let mut used = vec![false; self.triangles.len()];
        let mut pending: VecDeque<u32> =
            (0..).zip(&unknown).filter(|(_, unknown)| **unknown <= 1).map(|(t, _)| t).collect();
        let mut next = 0;
        loop {
            let found = match pending.pop_front() {
                Some(triangle) if used[triangle as usize] => continue,
                Some(triangle) => {
                    used[triangle as usize] = true;
                    let (mut sum, mut missing) = (0, None);
                    for side in self.triangles[triangle as usize] {
                        match values[edge(side)] {
                            UNKNOWN => missing = Some(side),
                            value => {
                                sum = group.sum(sum, if side % 2 == 0 { value } else { Relations::negative(value) })
                            }
                        }
                    }
                    match missing {
                        None => {
                            group.tell(sum);
                            continue;
                        }
                        Some(side) if side % 2 == 0 => (edge(side), Relations::negative(sum)),
                        Some(side) => (edge(side), sum),
                    }
                }
                None => {
                    let Some(free) = (next..values.len()).find(|edge| values[*edge] == UNKNOWN) else { return group };
                    next = free + 1;
                    (free, group.generator())
                }
            };
            values[found.0] = found.1;
            for triangle in at.of(found.0) {
                unknown[*triangle as usize] -= 1;
                if unknown[*triangle as usize] <= 1 {
                    pending.push_back(*triangle);
                }
            }
        }
    }

    /// The edges of a spanning forest of the vertices, breadth first.
    fn forest(&self) -> Vec<u32> {
        let at = Incidence::new(self.vertices, self.ends.iter().copied());
        let mut seen = vec![false; self.vertices];
        let mut forest = Vec::with_capacity(self.vertices);
        let mut pending = VecDeque::new();
        for root in 0..self.vertices as u32 {
            if std::mem::replace(&mut seen[root as usize], true) {
                continue;
            }
            pending.push_back(root);
            while let Some(vertex) = pending.pop_front() {
                for edge in at.of(vertex as usize) {
                    for end in self.ends[*edge as usize] {
                        if !std::mem::replace(&mut seen[end as usize], true) {
                            forest.push(*edge);
                            pending.push_back(end);
                        }
                    }
                }
            }
        }
        forest
    }
}

/// Which things have a part, with multiplicity, in order.
#[derive(Debug)]
struct Incidence {
    /// Those that have part i stand at first[i] … first[i + 1] − 1.
    first: Vec<u32>,
    things: Vec<u32>,
}

impl Incidence {
    fn new<const N: usize>(parts: usize, things: impl Iterator<Item = [u32; N]> + Clone) -> Incidence {
        let mut first = vec![0; parts + 1];
        things.clone().flatten().for_each(|part| first[part as usize + 1] += 1);
        for i in 0..parts {
            first[i + 1] += first[i];
        }
        let mut next = first.clone();
        let mut list = vec![0; first[parts] as usize];
        for (thing, parts) in (0..).zip(things) {
            for part in parts {
                let place = &mut next[part as usize];
                list[*place as usize] = thing;
                *place += 1;
            }
        }
        Incidence { first, things: list }
    }

    fn of(&self, part: usize) -> &[u32] {
        &self.things[self.first[part] as usize..self.first[part + 1] as usize]
    }
}

/// The edge between two corners: EDGES, read the other way. The diagonal is not used.
const EDGE: [[usize; 4]; 4] = [[6, 0, 1, 2], [0, 6, 3, 4], [1, 3, 6, 5], [2, 4, 5, 6]];

/// The edges of each tetrahedron, directed from the lower corner to the higher, and how many there are: numbered as in the
/// skeleton, found by walking around each one.
fn edges(triangulation: &Triangulation) -> Result<(Vec<[u32; 6]>, u32), ReversedEdge> {
    let gluings = triangulation.gluings();
    let mut edges = vec![[UNKNOWN; 6]; triangulation.len()];
    let mut count = 0;
    for t in 0..triangulation.len() {
        for [i, j] in EDGES {
            if edges[t][EDGE[i][j]] != UNKNOWN {
                continue;
            }
            let out = (0..4).find(|k| ![i, j].contains(k)).expect("two corners are left");
            let start = (t, [i, j, out]);
            let mut at = start;
            loop {
                let (tetrahedron, [i, j, out]) = at;
                let directed = 2 * count + u32::from(i > j);
                let place = &mut edges[tetrahedron][EDGE[i][j]];
                // Back at a place before the ring is closed, the walk meets the edge turned.
                if *place != UNKNOWN {
                    return Err(ReversedEdge { edge: count });
                }
                *place = directed;
                let gluing = &gluings[tetrahedron][out];
                let [i, j, came] = [i, j, out].map(|corner| gluing.corners.image(corner));
                at = (gluing.tetrahedron as usize, [i, j, 6 - i - j - came]);
                if at == start {
                    break;
                }
            }
            count += 1;
        }
    }
    Ok((edges, count))
}

/// The vertex at corner i of tetrahedron t, at 4t + i; and how many there are.
fn vertices(triangulation: &Triangulation) -> (Vec<u32>, usize) {
    let mut same = Partition::new(4 * triangulation.len());
    for (t, gluings) in triangulation.gluings().iter().enumerate() {
        for (i, gluing) in gluings.iter().enumerate() {
            let other = gluing.tetrahedron as usize;
            if (t, i) < (other, gluing.corners.image(i)) {
                for corner in corners_of_triangle(i) {
                    same.join(4 * t + corner, 4 * other + gluing.corners.image(corner));
                }
            }
        }
    }
    let (mut numbers, mut count) = (vec![UNKNOWN; 4 * triangulation.len()], 0);
    for corner in 0..numbers.len() {
        let first = same.find(corner);
        if first == corner {
            numbers[corner] = count;
            count += 1;
        } else {
            // The least corner of a vertex stands for it.
            numbers[corner] = numbers[first];
        }
    }
    (numbers, count as usize)
}
