//! A sample of the decisions, made a second time by the plain check.

use super::equal::mixed;
use super::polygons::{Polygons, exact};
use super::report::{Elements, Report};
use crate::mesh::defects::{self, Category, Element};
use crate::mesh::face::{Face, edge, sides};
use crate::mesh::triangles::EdgeKey;
use crate::mesh::vertex_list::VertexList;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use thiserror::Error;

/// What one vertex, edge or face is said to be wrong with, differently by the two checks.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{what:?}: the check says {fast:?}, the plain version {plain:?}")]
pub struct Mismatch {
    /// The vertex, edge or face.
    pub what: Element,
    /// The defects that this check gives it.
    pub fast: Vec<(Category, Element)>,
    /// The defects that the plain version gives it.
    pub plain: Vec<(Category, Element)>,
}

/// A vertex with more corners around it than this is passed over: the plain version would take too long.
const LARGEST_STAR: usize = 10_000;

/// Decides one in `one_in` vertices, edges and faces a second time, chosen by their numbers alone, and gives how many
/// they were.
///
/// The plain check is asked about the faces around the vertex, or around one end of the edge or a vertex of the face,
/// together with all vertices in the box of the edge, or at the position of the vertex: that decides all that is
/// said of it. Orientation, components, volume and area are not in the sample. `one_in` 0 samples nothing.
///
/// # Errors
/// The first item of which the two checks say different things.
pub fn audit(mesh: &Polygons, report: &Report, one_in: u64) -> Result<u64, Mismatch> {
    if one_in == 0 || report.counts.is_none() {
        return Ok(0);
    }
    let items = sample(mesh, one_in);
    let stars = stars(mesh, &items);
    let boxed = boxed_vertices(mesh, &items);
    let groups = Groups::of(report, &items);
    let mut audited = 0;
    for (item, boxed) in items.iter().zip(boxed) {
        let star = item.centre(mesh).map_or(&[][..], |v| &stars[&v]);
        if star.iter().map(|&face| mesh.face(face as usize).len()).sum::<usize>() > LARGEST_STAR {
            continue;
        }
        let mut plain = plainly(mesh, item, star, &boxed);
        let mut fast = groups.about(report, item);
        if !report.all_junctions {
            for said in [&mut plain, &mut fast] {
                said.retain(|(category, _)| *category != Category::TJunction);
            }
        }
        if plain != fast {
            let what = item.element();
            return Err(Mismatch { what, fast: fast.into_iter().collect(), plain: plain.into_iter().collect() });
        }
        audited += 1;
    }
    Ok(audited)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Item {
    Vertex(u32),
    Edge(EdgeKey),
    Face(u32),
}

impl Item {
    /// A vertex whose faces decide about the item; none for an empty face.
    fn centre(&self, mesh: &Polygons) -> Option<u32> {
        match self {
            Item::Vertex(v) | Item::Edge([v, _]) => Some(*v),
            Item::Face(face) => mesh.face(*face as usize).first().copied(),
        }
    }

    fn element(&self) -> Element {
        match self {
            Item::Vertex(v) => Element::Vertex(*v),
            Item::Edge(edge) => Element::Edge(*edge),
            Item::Face(face) => Element::Face(*face as usize),
        }
    }

    /// Whether an element of a defect names the item.
    fn is_in(&self, element: &Element) -> bool {
        match (self, element) {
            (Item::Vertex(v), Element::Vertex(w)) => v == w,
            (Item::Vertex(v), Element::Vertices(group)) => group.contains(v),
            (Item::Edge(e), Element::Edge(f) | Element::VertexInEdge(_, f)) => e == f,
            (Item::Face(f), Element::Face(g)) => *f as usize == *g,
            (Item::Face(f), Element::Faces(group)) => group.contains(&(*f as usize)),
            (Item::Vertex(_) | Item::Edge(_) | Item::Face(_), _) => false,
        }
    }
}

fn sample(mesh: &Polygons, one_in: u64) -> BTreeSet<Item> {
    let drawn = |key: u64| mixed(key).is_multiple_of(one_in);
    let vertices = (0..mesh.vertices().len() as u32).filter(|&v| drawn(v.into())).map(Item::Vertex);
    // An empty face has no vertex to find it by.
    let faces = (0..mesh.faces() as u32).filter(|&face| drawn(face.into()) && !mesh.face(face as usize).is_empty());
    let faces = faces.map(Item::Face);
    let mut items: BTreeSet<Item> = vertices.chain(faces).collect();
    for side in mesh.loops().flat_map(sides).filter(|[a, b]| a != b) {
        let [a, b] = edge(side);
        if drawn(u64::from(a) << 32 | u64::from(b)) {
            items.insert(Item::Edge([a, b]));
        }
    }
    items
}

/// The faces at the centres of the items.
fn stars(mesh: &Polygons, items: &BTreeSet<Item>) -> HashMap<u32, Vec<u32>> {
    let mut stars: HashMap<u32, Vec<u32>> =
        items.iter().filter_map(|item| item.centre(mesh)).map(|v| (v, Vec::new())).collect();
    let mut wanted = vec![false; mesh.vertices().len()];
    stars.keys().for_each(|&v| wanted[v as usize] = true);
    for (face, corners) in (0..).zip(mesh.loops()) {
        for &v in corners.iter().filter(|&&v| wanted[v as usize]) {
            let star = stars.get_mut(&v).expect("a wanted vertex");
            if star.last() != Some(&face) {
                star.push(face);
            }
        }
    }
    stars
}

/// For each item the used vertices in the closed box of an edge, and all those at the position of a vertex.
fn boxed_vertices(mesh: &Polygons, items: &BTreeSet<Item>) -> Vec<Vec<u32>> {
    const SLABS: usize = 4096;
    let points = mesh.vertices();
    let xs = || points.iter().map(|p| p[0]);
    let (low, high) = (xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max));
    // Slabs along x. Rounding does not disturb it: each step is monotone. Halves, so that no difference is infinite.
    let slab =
        |x: f64| ((x / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0) * SLABS as f64).clamp(0.0, SLABS as f64) as usize;
    let corners = |item: &Item| match item {
        Item::Vertex(v) => Some([points[*v as usize]; 2]),
        Item::Edge(ends) => Some(ends.map(|v| points[v as usize])),
        Item::Face(_) => None,
    };
    let mut used = vec![false; points.len()];
    mesh.corners().iter().for_each(|&v| used[v as usize] = true);
    let mut slabs = vec![Vec::new(); SLABS + 1];
    for (i, item) in items.iter().enumerate() {
        if let Some([a, b]) = corners(item) {
            for slab in &mut slabs[slab(a[0].min(b[0]))..=slab(a[0].max(b[0]))] {
                slab.push((i, [a, b], matches!(item, Item::Edge(_))));
            }
        }
    }
    let mut boxed = vec![Vec::new(); items.len()];
    for (v, p) in (0..).zip(points) {
        for (item, [a, b], only_used) in &slabs[slab(p[0])] {
            let within = (0..3).all(|i| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]));
            if within && (used[v as usize] || !only_used) {
                boxed[*item].push(v);
            }
        }
    }
    boxed
}

/// What the plain check says of an item.
fn plainly(mesh: &Polygons, item: &Item, star: &[u32], boxed: &[u32]) -> BTreeSet<(Category, Element)> {
    let loops = || star.iter().map(|&face| mesh.face(face as usize));
    let mut vertices: BTreeSet<u32> = loops().flatten().chain(boxed).copied().collect();
    vertices.extend(item.centre(mesh));
    let vertices: Vec<u32> = vertices.into_iter().collect();
    let local: BTreeMap<u32, u32> = vertices.iter().copied().zip(0..).collect();
    let mut faces: Vec<Face> =
        loops().map(|face| Face::new(face.iter().map(|v| local[v]).collect::<Vec<_>>())).collect();
    if let Item::Edge(_) = item {
        // A vertex in the box of an edge is a used one, by whatever face.
        faces.extend(boxed.iter().map(|v| Face::new([local[v]])));
    }
    let part = VertexList { vertices: vertices.iter().map(|&v| exact(&mesh.vertices()[v as usize])).collect(), faces };
    let global = |element: &Element| match element {
        Element::Vertex(v) => Some(Element::Vertex(vertices[*v as usize])),
        Element::Vertices(group) => Some(Element::Vertices(group.iter().map(|&v| vertices[v as usize]).collect())),
        Element::Edge(edge) => Some(Element::Edge(edge.map(|v| vertices[v as usize]))),
        Element::VertexInEdge(v, edge) => {
            Some(Element::VertexInEdge(vertices[*v as usize], edge.map(|v| vertices[v as usize])))
        }
        Element::Face(face) => star.get(*face).map(|&face| Element::Face(face as usize)),
        Element::Faces(group) => {
            let faces: Vec<usize> =
                group.iter().filter_map(|&face| star.get(face)).map(|&face| face as usize).collect();
            Some(Element::Faces(faces))
        }
        Element::Mesh | Element::Record(_) => None,
    };
    let report = defects::check(&part, None);
    let elements = report.defects.iter().flat_map(|(category, elements)| elements.iter().map(move |e| (category, e)));
    let elements = elements.filter_map(|(category, element)| Some((category, global(element)?)));
    elements.filter(|(_, element)| item.is_in(element)).collect()
}

/// The groups of the report in which items are.
struct Groups(HashMap<Item, BTreeSet<(Category, Element)>>);

impl Groups {
    fn of(report: &Report, items: &BTreeSet<Item>) -> Groups {
        let wanted: HashSet<Item> = items.iter().copied().collect();
        let mut groups: HashMap<Item, BTreeSet<(Category, Element)>> = HashMap::new();
        let mut add = |item: Item, category: Category, element: &dyn Fn() -> Element| {
            if wanted.contains(&item) {
                groups.entry(item).or_default().insert((category, element()));
            }
        };
        for (&category, elements) in &report.defects {
            match elements {
                Elements::VertexGroups(list) => {
                    for group in list {
                        group
                            .iter()
                            .for_each(|&v| add(Item::Vertex(v), category, &|| Element::Vertices(group.clone())));
                    }
                }
                Elements::FaceGroups(list) => {
                    for group in list {
                        let element = || Element::Faces(group.iter().map(|&face| face as usize).collect());
                        group.iter().for_each(|&face| add(Item::Face(face), category, &element));
                    }
                }
                Elements::Junctions(list) => {
                    for &(v, edge) in list {
                        add(Item::Edge(edge), category, &|| Element::VertexInEdge(v, edge));
                    }
                }
                Elements::Faces(_) | Elements::Vertices(_) | Elements::Edges(_) | Elements::Whole => {}
            }
        }
        Groups(groups)
    }

    /// What the report says of an item.
    fn about(&self, report: &Report, item: &Item) -> BTreeSet<(Category, Element)> {
        let is_in = |elements: &Elements| match (item, elements) {
            (Item::Face(face), Elements::Faces(list)) => list.binary_search(face).is_ok(),
            (Item::Vertex(vertex), Elements::Vertices(list)) => list.binary_search(vertex).is_ok(),
            (Item::Edge(edge), Elements::Edges(list)) => list.binary_search(edge).is_ok(),
            (Item::Face(_) | Item::Vertex(_) | Item::Edge(_), _) => false,
        };
        let alone = report.defects.iter().filter(|(_, elements)| is_in(elements));
        let alone = alone.map(|(category, _)| (*category, item.element()));
        alone.chain(self.0.get(item).into_iter().flatten().cloned()).collect()
    }
}
