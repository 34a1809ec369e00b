//! A second derivation of what a scheme is, without flags: classes of corners, directed edges and vertices; links glued from polygons;
//! H₁ from the dual cells.

use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use isoracle::mesh::classify::{ClosedSurface, Surface};
use isoracle::mesh::gluing::{Gluing, Side};
use isoracle::mesh::homology::{Chain, ChainComplex};
use isoracle::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};

/// What was found of a scheme whose polyhedra are balls and whose pairings match the faces.
#[derive(Debug, PartialEq, Eq)]
pub struct Found {
    /// Whether some edge is glued to itself, tail to head.
    pub edge_reversed: bool,
    /// V, E, F, P.
    pub cells: [usize; 4],
    /// The links, sorted.
    pub links: Vec<ClosedSurface>,
    pub components: usize,
    pub orientable: bool,
    pub h1: AbelianGroup,
}

impl Found {
    pub fn is_manifold(&self) -> bool {
        let sphere = ClosedSurface::Orientable { genus: 0 };
        !self.edge_reversed && self.links.iter().all(|link| *link == sphere)
    }

    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f, p] = self.cells.map(|n| n as i64);
        v - e + f - p
    }
}

/// A corner of a face: polyhedron, face, and the side that begins there.
type Corner = (usize, usize, usize);

struct Scheme<'a> {
    scheme: &'a GluingScheme,
    /// Each corner's partner, and the pairing's number and direction, + from its face a to b.
    partner: BTreeMap<Corner, (Corner, i64)>,
    crossing: BTreeMap<FaceId, (usize, i64)>,
}

impl Scheme<'_> {
    fn face(&self, (p, f, _): Corner) -> &[SignedEdge] {
        &self.scheme.polyhedra[p].faces[f]
    }

    fn side(&self, corner: Corner) -> SignedEdge {
        self.face(corner)[corner.2]
    }

    fn before(&self, (p, f, i): Corner) -> Corner {
        let n = self.face((p, f, i)).len();
        (p, f, (i + n - 1) % n)
    }

    fn after(&self, (p, f, i): Corner) -> Corner {
        (p, f, (i + 1) % self.face((p, f, i)).len())
    }

    fn corners(&self) -> Vec<Corner> {
        self.partner.keys().copied().collect()
    }

    /// The other side of the polyhedron along the same edge.
    fn across_edge(&self, corner: Corner) -> Corner {
        let edge = self.side(corner).0;
        let faces = self.scheme.polyhedra[corner.0].faces.iter().enumerate();
        let mut same = faces.flat_map(|(f, face)| face.iter().enumerate().map(move |(i, side)| (f, i, side.0)));
        let (f, i, _) = same.find(|(_, _, side)| *side == -edge).expect("each edge is walked along both ways");
        (corner.0, f, i)
    }

    /// The side that this side is glued to, and whether it is walked along the same way.
    fn across_face(&self, corner: Corner) -> (Corner, i64) {
        let (image, dir) = self.partner[&corner];
        (if dir == 1 { image } else { self.before(image) }, dir)
    }

    fn name(&self, corner: Corner) -> u32 {
        self.scheme.polyhedra[corner.0].ends(self.side(corner)).expect("an edge")[0]
    }
}

/// What the scheme is.
pub fn found(scheme: &GluingScheme) -> Found {
    let (mut partner, mut crossing) = (BTreeMap::new(), BTreeMap::new());
    for (number, Pairing { a, b, shift, dir }) in scheme.pairings.iter().enumerate() {
        let n = scheme.polyhedra[a.polyhedron].faces[a.face].len() as i64;
        for i in 0..n {
            let j = (i128::from(*shift) + i128::from(dir * i)).rem_euclid(i128::from(n)) as usize;
            let (from, to) = ((a.polyhedron, a.face, i as usize), (b.polyhedron, b.face, j));
            partner.insert(from, (to, *dir));
            partner.insert(to, (from, *dir));
        }
        crossing.insert(*a, (number, 1));
        crossing.insert(*b, (number, -1));
    }
    let scheme = Scheme { scheme, partner, crossing };
    let (edge_reversed, edges) = edges(&scheme);
    let cells = [vertices(&scheme), edges, scheme.scheme.pairings.len(), scheme.scheme.polyhedra.len()];
    let (components, orientable) = sides(scheme.scheme);
    Found { edge_reversed, cells, links: links(&scheme), components, orientable, h1: h1(&scheme) }
}

fn edges(scheme: &Scheme) -> (bool, usize) {
    let mut first = vec![0];
    for p in &scheme.scheme.polyhedra {
        first.push(first[first.len() - 1] + p.edges.len());
    }
    let edges = first[first.len() - 1];
    // Directed edges: an edge along its direction, then all of them against it.
    let number = |p: usize, side: i32| first[p] + side.unsigned_abs() as usize - 1 + if side > 0 { 0 } else { edges };
    let (mut directed, mut undirected) = (Partition::new(2 * edges), Partition::new(edges));
    for corner in scheme.corners() {
        let (image, dir) = scheme.across_face(corner);
        let (here, there) = (scheme.side(corner).0, scheme.side(image).0 * dir as i32);
        for sign in [1, -1] {
            directed.join(number(corner.0, sign * here), number(image.0, sign * there));
        }
        undirected.join(number(corner.0, here.abs()), number(image.0, there.abs()));
    }
    let reversed = (0..edges).any(|e| directed.find(e) == directed.find(e + edges));
    (reversed, (0..edges).filter(|e| undirected.find(*e) == *e).count())
}

fn vertices(scheme: &Scheme) -> usize {
    let names: BTreeSet<(usize, u32)> = scheme.corners().into_iter().map(|c| (c.0, scheme.name(c))).collect();
    let numbers: BTreeMap<(usize, u32), usize> = names.into_iter().zip(0..).collect();
    let mut classes = Partition::new(numbers.len());
    for corner in scheme.corners() {
        let (image, _) = scheme.partner[&corner];
        classes.join(numbers[&(corner.0, scheme.name(corner))], numbers[&(image.0, scheme.name(image))]);
    }
    (0..numbers.len()).filter(|v| classes.find(*v) == *v).count()
}

/// A polygon for each corner of a polyhedron; its sides are corners of faces, which are glued as the faces are.
fn links(scheme: &Scheme) -> Vec<ClosedSurface> {
    let mut labels: BTreeMap<Corner, Side> = BTreeMap::new();
    for (label, (from, (to, dir))) in (0..).zip(&scheme.partner) {
        labels.entry(*from).or_insert_with(|| Side { edge: label, forward: true });
        let label = labels[from];
        labels.entry(*to).or_insert(Side { forward: label.forward == (*dir == 1), ..label });
    }
    let mut left: BTreeSet<Corner> = scheme.partner.keys().copied().collect();
    let mut polygons = Vec::new();
    while let Some(first) = left.first().copied() {
        let (mut polygon, mut corner) = (Vec::new(), first);
        while left.remove(&corner) {
            polygon.push(labels[&corner]);
            // The next face at the outgoing edge comes in along it.
            corner = scheme.after(scheme.across_edge(corner));
        }
        polygons.push(polygon);
    }
    let surfaces = Gluing::new(polygons).expect("corners are glued in twos").surfaces();
    let mut links: Vec<ClosedSurface> = surfaces
        .into_iter()
        .map(|Surface { closed, boundary_loops }| {
            assert_eq!(boundary_loops, 0, "links are closed");
            closed
        })
        .collect();
    links.sort_unstable();
    links
}

/// Components, and whether polyhedra can be turned so that all pairings go against the walks.
fn sides(scheme: &GluingScheme) -> (usize, bool) {
    let n = scheme.polyhedra.len();
    let (mut parts, mut turned) = (Partition::new(n), Partition::new(2 * n));
    for Pairing { a, b, dir, .. } in &scheme.pairings {
        parts.join(a.polyhedron, b.polyhedron);
        for side in 0..2 {
            let other = if *dir == -1 { side } else { 1 - side };
            turned.join(2 * a.polyhedron + side, 2 * b.polyhedron + other);
        }
    }
    let components = (0..n).filter(|p| parts.find(*p) == *p).count();
    (components, (0..n).all(|p| turned.find(2 * p) != turned.find(2 * p + 1)))
}

/// H₁ of the dual complex: a vertex for each polyhedron, an edge for each pairing, a polygon for each edge.
fn h1(scheme: &Scheme) -> AbelianGroup {
    let polyhedra = vec![Chain::new(); scheme.scheme.polyhedra.len()];
    let pairings = scheme.scheme.pairings.iter().map(|Pairing { a, b, .. }| {
        let mut ends = Chain::new();
        *ends.entry(b.polyhedron).or_default() += 1;
        *ends.entry(a.polyhedron).or_default() -= 1;
        ends
    });
    let mut left: BTreeSet<Corner> = scheme.corners().into_iter().collect();
    let mut edges = Vec::new();
    while let Some(first) = left.first().copied() {
        let (mut walk, mut corner) = (Chain::new(), first);
        loop {
            left.remove(&corner);
            let (pairing, sign) = scheme.crossing[&FaceId { polyhedron: corner.0, face: corner.1 }];
            *walk.entry(pairing).or_default() += sign;
            let (image, _) = scheme.across_face(corner);
            left.remove(&image);
            corner = scheme.across_edge(image);
            if corner == first {
                break;
            }
        }
        edges.push(walk);
    }
    let complex = ChainComplex::new(vec![polyhedra, pairings.collect(), edges]).expect("walks around edges are closed");
    let mut homology = complex.homology();
    AbelianGroup { rank: homology.betti[1], torsion: homology.torsion.swap_remove(1) }
}

/// Whether the faces make a sphere: closed walks, each edge once each way, one cycle of corners around each vertex, connected, χ = 2.
pub fn is_ball(p: &Polyhedron) -> bool {
    let mut uses: BTreeMap<i32, (usize, usize)> = BTreeMap::new();
    for (f, face) in p.faces.iter().enumerate() {
        for (i, side) in face.iter().enumerate() {
            let before = face[(i + face.len() - 1) % face.len()];
            let (Some([_, end]), Some([begin, _])) = (p.ends(before), p.ends(*side)) else { return false };
            if end != begin || uses.insert(side.0, (f, i)).is_some() {
                return false;
            }
        }
    }
    let edges = p.edges.len() as i32;
    if p.faces.is_empty() || p.faces.iter().any(Vec::is_empty) || uses.len() != 2 * p.edges.len() {
        return false;
    }
    // Every signed edge is a side, once.
    let (mut cycles, mut parts) = (BTreeMap::<u32, usize>::new(), Partition::new(p.faces.len()));
    for e in 1..=edges {
        parts.join(uses[&e].0, uses[&-e].0);
    }
    let mut left: BTreeSet<(usize, usize)> = uses.values().copied().collect();
    while let Some(first) = left.first().copied() {
        let begin = p.ends(p.faces[first.0][first.1]).expect("an edge")[0];
        *cycles.entry(begin).or_default() += 1;
        let mut corner = first;
        while left.remove(&corner) {
            let (f, i) = uses[&-p.faces[corner.0][corner.1].0];
            corner = (f, (i + 1) % p.faces[f].len());
        }
    }
    let connected = (0..p.faces.len()).filter(|f| parts.find(*f) == *f).count() == 1;
    let chi = cycles.len() as i64 - i64::from(edges) + p.faces.len() as i64;
    connected && cycles.values().all(|n| *n == 1) && chi == 2
}
