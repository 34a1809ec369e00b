//! The fundamental group, from the cells of dimension ≤ 2, from those of dimension ≥ 1, and from tetrahedra.

use super::closed_complex::ClosedComplex;
use super::flag::Flag;
use super::manifold::Manifold3;
use super::presentation::{Letter, Presentation, Word};
use super::triangulation::Triangulation;
use super::triangulation_chain::{ReversedEdge, corners_of_triangle};
use crate::partition::Partition;

impl ClosedComplex {
    /// The fundamental group of each component, in the order of their first flags (CX-74): a generator for each edge off a
    /// spanning tree of the vertices, a relator for each face, the walk around it.
    #[doc(alias = "CX-74")]
    pub fn fundamental_groups(&self) -> Vec<Presentation> {
        self.groups([0, 1, 2, 3])
    }

    /// The fundamental group of each component less its vertices (CX-75): a generator for each face off a spanning tree
    /// of the polyhedra, which goes through it, a relator for each edge, the walk around it.
    #[doc(alias = "CX-75")]
    pub fn fundamental_groups_off_vertices(&self) -> Vec<Presentation> {
        self.groups([3, 2, 1, 0])
    }

    /// Of the complex (0, 1, 2, 3), or of its dual (3, 2, 1, 0): what the dimensions are called.
    fn groups(&self, [nodes, arcs, discs, fourth]: [usize; 4]) -> Vec<Presentation> {
        let flags = self.flags();
        let (component_of, components) = flags.orbits(&[0, 1, 2, 3]);
        let (end_of_arc, _) = flags.orbits(&[discs, fourth]);
        let mut first: Vec<Option<Flag>> = vec![None; self.counts()[arcs]];
        flags.all().for_each(|flag| _ = first[self.cell(arcs, flag) as usize].get_or_insert(flag));
        let mut tree = Partition::new(self.counts()[nodes]);
        let mut generators = vec![0; components];
        // The number of each arc off the tree.
        let numbers: Vec<Option<usize>> = first
            .iter()
            .map(|flag| {
                let flag = flag.expect("each cell has a flag");
                let [a, b] = [flag, flags.sigma(nodes, flag)].map(|flag| self.cell(nodes, flag) as usize);
                let next = &mut generators[component_of[flag.0 as usize] as usize];
                (!tree.join(a, b)).then(|| std::mem::replace(next, *next + 1))
            })
            .collect();
        let letter = |flag: Flag| {
            let arc = self.cell(arcs, flag) as usize;
            let start = first[arc].expect("each cell has a flag").0 as usize;
            Some(Letter::new(numbers[arc]?, end_of_arc[start] == end_of_arc[flag.0 as usize]))
        };
        let mut relators = vec![Vec::new(); components];
        let mut walked = vec![false; self.counts()[discs]];
        for start in flags.all() {
            if std::mem::replace(&mut walked[self.cell(discs, start) as usize], true) {
                continue;
            }
            let (mut flag, mut word) = (start, Word::new());
            loop {
                word.extend(letter(flag));
                flag = flags.walk(flag, &[nodes, arcs]);
                if flag == start {
                    break;
                }
            }
            relators[component_of[start.0 as usize] as usize].push(word);
        }
        let groups = generators.into_iter().zip(relators);
        groups.map(|(generators, relators)| Presentation { generators, relators }).collect()
    }
}

impl Manifold3 {
    /// The fundamental group of each component by the dual cells (CX-75): without its vertices a manifold has the same group.
    pub fn dual_fundamental_groups(&self) -> Vec<Presentation> {
        self.complex().fundamental_groups_off_vertices()
    }
}

impl Triangulation {
    /// The fundamental group of each component, in the order of their first tetrahedra (CX-74): a generator for each edge off
    /// a spanning tree of the vertices, a relator for each triangle.
    ///
    /// # Errors
    /// Iff an edge is glued to itself, tail to head: the first one.
    #[doc(alias = "CX-74")]
    pub fn fundamental_groups(&self) -> Result<Vec<Presentation>, ReversedEdge> {
        let skeleton = self.directed_skeleton()?;
        let components = self.components();
        let count = components.orientable.len();
        let [vertices, edges, triangles, _] = skeleton.cells.counts;
        let mut tree = Partition::new(vertices);
        let (mut generators, mut numbers) = (vec![0; count], vec![None; edges]);
        let mut seen = vec![false; edges];
        for (t, edges) in skeleton.cells.edges.iter().enumerate() {
            for (edge, [i, j]) in edges.iter().zip(super::triangulation::EDGES) {
                let [a, b] = [i, j].map(|corner| skeleton.cells.vertices[t][corner] as usize);
                if !std::mem::replace(&mut seen[*edge as usize], true) && !tree.join(a, b) {
                    let next = &mut generators[components.of[t] as usize];
                    numbers[*edge as usize] = Some(std::mem::replace(next, *next + 1));
                }
            }
        }
        let mut relators = vec![Vec::new(); count];
        let mut walked = vec![false; triangles];
        for (t, triangles) in skeleton.cells.triangles.iter().enumerate() {
            for (i, triangle) in triangles.iter().enumerate() {
                if !std::mem::replace(&mut walked[*triangle as usize], true) {
                    let [a, b, c] = corners_of_triangle(i);
                    let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| skeleton.edge(t, from, to));
                    let letters = sides
                        .iter()
                        .filter_map(|(edge, forward)| Some(Letter::new(numbers[*edge as usize]?, *forward)));
                    relators[components.of[t] as usize].push(letters.collect());
                }
            }
        }
        let groups = generators.into_iter().zip(relators);
        Ok(groups.map(|(generators, relators)| Presentation { generators, relators }).collect())
    }
}
