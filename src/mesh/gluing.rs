//! Polygons glued side to side. Each edge has one or two sides, so the corners at a vertex make one fan: every gluing is a
//! compact surface with border, and every such surface is one (ME-133).

use super::face::{self, Face};
use super::simplicial::{Simplex, SimplicialComplex};
use super::triangles::EdgeKey;
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// A side of a polygon: an edge, by its label, run along forward or back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Side {
    /// The edge.
    pub edge: u32,
    /// Whether it is run along from its start to its end.
    pub forward: bool,
}

impl Side {
    /// The edge run along the other way.
    pub fn reversed(self) -> Side {
        Side { forward: !self.forward, ..self }
    }
}

/// Where a side stands: polygon, and place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The polygon.
    pub polygon: usize,
    /// The place of the side in it.
    pub side: usize,
}

/// Polygons with their sides glued in pairs, or free.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gluing {
    polygons: Vec<Vec<Side>>,
    /// Where the one or two sides of each edge stand.
    places: BTreeMap<u32, Vec<Place>>,
    /// The vertex at the start of each side.
    corners: Vec<Vec<u32>>,
    vertices: usize,
}

/// Why polygons are no gluing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum GluingError {
    /// A polygon without sides.
    #[error("polygon {polygon} has no side")]
    Empty {
        /// The polygon.
        polygon: usize,
    },
    /// An edge of three sides or more.
    #[error("edge {edge} has {sides} sides, more than two")]
    Sides {
        /// The edge.
        edge: u32,
        /// How many sides it has.
        sides: usize,
    },
    /// A character that is no letter from a to z or A to Z.
    #[error("{0:?} is no letter a … z or A … Z")]
    Letter(char),
}

/// Why faces are no surface with border, glued along their edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FaceError {
    /// A loop of fewer than three vertices.
    #[error("face {face}: a loop has {vertices} vertices, fewer than three")]
    Loop {
        /// The face.
        face: usize,
        /// How many vertices the loop has.
        vertices: usize,
    },
    /// A side from a vertex to itself.
    #[error("face {face}: a side goes from vertex {vertex} to itself")]
    Side {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// An edge of three sides or more.
    #[error("the edge from {} to {} has {sides} sides, more than two", .edge[0], .edge[1])]
    Edge {
        /// Its ends.
        edge: EdgeKey,
        /// How many sides it has.
        sides: usize,
    },
}

/// Whether the faces' loops are polygons: the first one that has fewer than three vertices, or a side from a vertex to
/// itself, is told.
///
/// # Errors
/// `Loop` or `Side`, never `Edge`.
pub fn check_loops(faces: &[Face]) -> Result<(), FaceError> {
    for (number, face) in faces.iter().enumerate() {
        if let Some(l) = face.loops().find(|l| l.len() < 3) {
            return Err(FaceError::Loop { face: number, vertices: l.len() });
        }
        if let Some([vertex, _]) = face.sides().find(|[a, b]| a == b) {
            return Err(FaceError::Side { face: number, vertex });
        }
    }
    Ok(())
}

/// A mesh whose faces are glued along their edges only: a vertex at which they make several fans falls apart into as many.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheets {
    /// The surface. Polygon k is face k, its holes reached by bridges, edges with both sides in the face.
    pub gluing: Gluing,
    /// The mesh vertex that each vertex of the gluing comes from.
    pub origin: Vec<u32>,
}

impl Sheets {
    /// The faces cut open: from the first vertex of the outer loop a bridge goes to the first vertex of each hole and,
    /// after the hole, back, so that each face is one polygon. The bridges have the last labels.
    ///
    /// # Errors
    /// Iff a loop has fewer than three vertices, a side goes from a vertex to itself, or an edge has more than two sides.
    pub fn new(faces: &[Face]) -> Result<Sheets, FaceError> {
        check_loops(faces)?;
        let edges: BTreeSet<EdgeKey> = faces.iter().flat_map(Face::sides).map(face::edge).collect();
        let labels: BTreeMap<EdgeKey, u32> = edges.iter().copied().zip(0..).collect();
        let side = |[a, b]: [u32; 2]| Side { edge: labels[&face::edge([a, b])], forward: a < b };
        let mut bridges = labels.len() as u32..;
        let mut names: Vec<Vec<u32>> = Vec::new();
        let polygons: Vec<Vec<Side>> = faces
            .iter()
            .map(|face| {
                let mut corners = face.outer.clone();
                let mut sides: Vec<Side> = face::sides(&face.outer).map(side).collect();
                for hole in &face.holes {
                    let across = Side { edge: bridges.next().expect("fewer than 2³² edges"), forward: true };
                    sides.push(across);
                    sides.extend(face::sides(hole).map(side));
                    sides.push(across.reversed());
                    corners.push(face.outer[0]);
                    corners.extend(hole);
                    corners.push(hole[0]);
                }
                names.push(corners);
                sides
            })
            .collect();
        let gluing = Gluing::new(polygons).map_err(|error| match error {
            GluingError::Sides { edge, sides } => {
                let (edge, _) = labels.iter().find(|(_, label)| **label == edge).expect("a bridge has two sides");
                FaceError::Edge { edge: *edge, sides }
            }
            GluingError::Empty { .. } | GluingError::Letter(_) => unreachable!("every loop has three sides"),
        })?;
        let mut origin = vec![0; gluing.vertices];
        for (corners, names) in gluing.corners.iter().zip(&names) {
            for (corner, name) in corners.iter().zip(names) {
                origin[*corner as usize] = *name;
            }
        }
        Ok(Sheets { gluing, origin })
    }

    /// The mesh vertices of several fans, with how many they have.
    pub fn pinches(&self) -> BTreeMap<u32, usize> {
        let mut fans: BTreeMap<u32, usize> = BTreeMap::new();
        for vertex in &self.origin {
            *fans.entry(*vertex).or_default() += 1;
        }
        fans.into_iter().filter(|(_, fans)| *fans > 1).collect()
    }
}

impl Gluing {
    /// The gluing of these polygons: sides of one label are glued, start to start and end to end.
    ///
    /// # Errors
    /// Iff a polygon has no side or a label stands more than twice.
    pub fn new(polygons: Vec<Vec<Side>>) -> Result<Gluing, GluingError> {
        if let Some(polygon) = polygons.iter().position(Vec::is_empty) {
            return Err(GluingError::Empty { polygon });
        }
        let mut places: BTreeMap<u32, Vec<Place>> = BTreeMap::new();
        for (polygon, sides) in polygons.iter().enumerate() {
            for (side, Side { edge, .. }) in sides.iter().enumerate() {
                places.entry(*edge).or_default().push(Place { polygon, side });
            }
        }
        if let Some((edge, sides)) = places.iter().find(|(_, places)| places.len() > 2) {
            return Err(GluingError::Sides { edge: *edge, sides: sides.len() });
        }
        let (corners, vertices) = vertices(&polygons, &places);
        Ok(Gluing { polygons, places, corners, vertices })
    }

    /// The gluing of polygons given by words, one letter a side: `a` runs along an edge forward, `A` back. `"abAB"` is a
    /// torus, `"aabb"` a Klein bottle, `"a"` a disc.
    ///
    /// # Errors
    /// As [`Gluing::new`], and iff a character is no letter.
    pub fn from_words<S: AsRef<str>>(words: &[S]) -> Result<Gluing, GluingError> {
        let side = |letter: char| match letter {
            'a'..='z' | 'A'..='Z' => {
                Ok(Side { edge: u32::from(letter.to_ascii_lowercase()), forward: letter.is_ascii_lowercase() })
            }
            _ => Err(GluingError::Letter(letter)),
        };
        let polygons: Result<Vec<Vec<Side>>, _> =
            words.iter().map(|word| word.as_ref().chars().map(side).collect()).collect();
        Gluing::new(polygons?)
    }

    /// Its polygons.
    pub fn polygons(&self) -> &[Vec<Side>] {
        &self.polygons
    }

    /// Where the sides of each edge stand, one or two places.
    pub fn places(&self) -> &BTreeMap<u32, Vec<Place>> {
        &self.places
    }

    /// The vertices, 0 … V−1, at the start of each polygon's sides.
    pub fn corners(&self) -> &[Vec<u32>] {
        &self.corners
    }

    /// The vertices that an edge goes from and to. `None` iff there is no such edge.
    pub fn ends(&self, edge: u32) -> Option<[u32; 2]> {
        let Place { polygon, side } = self.places.get(&edge)?[0];
        let corners = &self.corners[polygon];
        let ends = [corners[side], corners[(side + 1) % corners.len()]];
        Some(if self.polygons[polygon][side].forward { ends } else { [ends[1], ends[0]] })
    }

    /// V, E, F.
    pub fn counts(&self) -> [i64; 3] {
        [self.vertices, self.places.len(), self.polygons.len()].map(|n| n as i64)
    }

    /// χ = V − E + F.
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.counts();
        v - e + f
    }

    /// The loops of its border, each as the closed walk along its free edges; none iff the surface is closed (ME-105).
    #[doc(alias = "ME-105")]
    pub fn boundary(&self) -> Vec<Vec<Side>> {
        let free = |edge: u32| [true, false].map(|forward| Side { edge, forward });
        let mut out: BTreeMap<u32, Vec<Side>> = BTreeMap::new();
        let start = |side: Side| self.ends(side.edge).expect("an edge")[usize::from(!side.forward)];
        let edges = self.places.iter().filter(|(_, places)| places.len() == 1).map(|(edge, _)| *edge);
        let mut left: BTreeSet<u32> = edges.collect();
        left.iter().flat_map(|edge| free(*edge)).for_each(|side| out.entry(start(side)).or_default().push(side));
        let mut loops = Vec::new();
        while let Some(first) = left.pop_first() {
            let mut walk = vec![Side { edge: first, forward: true }];
            loop {
                let back = walk.last().expect("not empty").reversed();
                // A fan that is not closed has two free sides.
                let next = *out[&start(back)].iter().find(|side| **side != back).expect("two free sides at a vertex");
                if !left.remove(&next.edge) {
                    break;
                }
                walk.push(next);
            }
            loops.push(walk);
        }
        loops
    }

    /// The closed surface with a polygon glued into each loop of the border.
    pub fn capped(&self) -> Gluing {
        let polygons = self.polygons.iter().cloned().chain(self.boundary()).collect();
        Gluing::new(polygons).expect("each free side is glued to the side of one cap")
    }

    /// Its connected components, in the order of their first polygons (ME-143).
    #[doc(alias = "ME-143")]
    pub fn components(&self) -> Vec<Gluing> {
        let mut parts = Partition::new(self.polygons.len());
        for places in self.places.values() {
            parts.join(places[0].polygon, places[places.len() - 1].polygon);
        }
        let mut components: BTreeMap<usize, Vec<Vec<Side>>> = BTreeMap::new();
        for (number, polygon) in self.polygons.iter().enumerate() {
            components.entry(parts.find(number)).or_default().push(polygon.clone());
        }
        components.into_values().map(|polygons| Gluing::new(polygons).expect("as in the whole")).collect()
    }

    /// A simplicial complex of the same surface: each edge falls into three, each polygon gets a ring of inner vertices,
    /// one for each of the parts of its sides, and a centre.
    pub fn triangulated(&self) -> SimplicialComplex {
        let edges: BTreeMap<u32, u32> = self.places.keys().copied().zip(0..).collect();
        let mut free = self.vertices as u32 + 2 * edges.len() as u32;
        let mut triangles = Vec::new();
        for (sides, corners) in self.polygons.iter().zip(&self.corners) {
            let parts = |(side, corner): (&Side, &u32)| {
                let [first, second] = [0, 1].map(|k| self.vertices as u32 + 2 * edges[&side.edge] + k);
                if side.forward { [*corner, first, second] } else { [*corner, second, first] }
            };
            let border: Vec<u32> = sides.iter().zip(corners).flat_map(parts).collect();
            let n = border.len();
            let (ring, centre) = (|i: usize| free + (i % n) as u32, free + n as u32);
            for i in 0..n {
                let [a, b] = [border[i], border[(i + 1) % n]];
                triangles.extend([[a, b, ring(i)], [ring(i), b, ring(i + 1)], [ring(i), ring(i + 1), centre]]);
            }
            free = centre + 1;
        }
        SimplicialComplex::new(triangles.iter().map(|t| Simplex::new(t).expect("each has an inner vertex")))
    }
}

/// The vertex at the start of each side, and how many there are: glued sides have their ends in common.
fn vertices(polygons: &[Vec<Side>], places: &BTreeMap<u32, Vec<Place>>) -> (Vec<Vec<u32>>, usize) {
    let mut first = vec![0];
    for polygon in polygons {
        first.push(first[first.len() - 1] + polygon.len());
    }
    let ends = |place: &Place| {
        let n = polygons[place.polygon].len();
        let ends = [place.side, (place.side + 1) % n].map(|corner| first[place.polygon] + corner);
        if polygons[place.polygon][place.side].forward { ends } else { [ends[1], ends[0]] }
    };
    let mut same = Partition::new(first[polygons.len()]);
    for pair in places.values().filter(|places| places.len() == 2) {
        let [[a, b], [c, d]] = [ends(&pair[0]), ends(&pair[1])];
        same.join(a, c);
        same.join(b, d);
    }
    let mut numbers: BTreeMap<usize, u32> = BTreeMap::new();
    let corners = polygons.iter().zip(&first).map(|(polygon, first)| {
        let corner = |side: usize| {
            let next = numbers.len() as u32;
            *numbers.entry(same.find(first + side)).or_insert(next)
        };
        (0..polygon.len()).map(corner).collect()
    });
    let corners = corners.collect();
    (corners, numbers.len())
}
