//! What `mesh::defects::check` says, derived by brute force: every pair, triple, quadruple, rotation and flip is tried.

use isoracle::linear::Vector;
use isoracle::mesh::defects::{Category, Counts, Element, Report};
use isoracle::mesh::face::Face;
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::number::Rational;
use std::collections::{BTreeMap, BTreeSet};

pub type Found = BTreeMap<Category, BTreeSet<Element>>;

/// What a report says, in the form in which brute force says it.
pub fn found(report: &Report) -> (Found, Option<Counts>) {
    (report.defects.iter().map(|(category, elements)| (category, elements.clone())).collect(), report.counts.clone())
}

/// A list of edges, perhaps with the faces of each.
#[derive(Clone, Copy)]
pub struct Listed<'a> {
    pub edges: &'a [[u32; 2]],
    pub faces: Option<&'a [Vec<u32>]>,
}

/// The same from the definitions.
pub fn naive_check(mesh: &VertexList, listed: Option<Listed>) -> (Found, Option<Counts>) {
    let naive = Naive { mesh };
    let n = mesh.vertices.len() as u32;
    let mut found = Found::new();
    let mut add = |is_there: bool, category: Category, element: Element| {
        if is_there {
            found.entry(category).or_default().insert(element);
        }
    };
    for (i, face) in mesh.faces.iter().enumerate() {
        let missing = loops(face).iter().any(|l| l.iter().any(|&v| v >= n));
        add(missing, Category::IndexOutOfRange, Element::Face(i));
    }
    if !found.is_empty() {
        return (found, None);
    }
    let mut add = |is_there: bool, category: Category, element: Element| {
        if is_there {
            found.entry(category).or_default().insert(element);
        }
    };
    for (i, face) in mesh.faces.iter().enumerate() {
        let here = Element::Face(i);
        for l in loops(face) {
            let m = l.len();
            add(m < 3, Category::FaceLt3Vertices, here.clone());
            let twice = (0..m).any(|j| (0..j).any(|k| l[j] == l[k]));
            add(twice, Category::RepeatedVertexInLoop, here.clone());
            let stays = (0..m).any(|j| l[j] == l[if j + 1 == m { 0 } else { j + 1 }]);
            add(stays, Category::DegenerateEdgeSameIndex, here.clone());
        }
        let points = naive.points(&loops(face).concat());
        let (line, plane) = (on_a_line(&points), in_a_plane(&points));
        if points.len() >= 3 {
            add(line, Category::ZeroAreaFace, here.clone());
            add(!plane, Category::NonplanarFace, here.clone());
            let total = loops(face).iter().fold(Vector::zero(), |sum, l| sum + &naive.area(l));
            add(plane && !line && total == Vector::zero(), Category::ZeroSignedAreaFace, here.clone());
            add(plane && crosses_itself(&naive.points(&face.outer)), Category::SelfCrossingLoop, here.clone());
        }
        let same = face.holes.iter().any(|hole| naive.area(hole).dot(&naive.area(&face.outer)) > 0);
        add(same, Category::HoleSameSenseAsOuter, here);
        let equal = |k: &usize| same_cycle(&face.outer, &mesh.faces[*k].outer);
        let equal: Vec<usize> = (0..mesh.faces.len()).filter(equal).collect();
        add(equal.len() > 1, Category::DuplicateFace, Element::Faces(equal));
    }
    for a in 0..n {
        let at: Vec<u32> = (0..n).filter(|&b| naive.point(a) == naive.point(b)).collect();
        add(at.len() > 1, Category::DuplicateVertexPosition, Element::Vertices(at));
        let used = naive.is_used(a);
        add(!used, Category::IsolatedVertex, Element::Vertex(a));
        let neighbours: Vec<u32> = (0..n).filter(|&b| !naive.uses(a, b).is_empty()).collect();
        add(used && neighbours.len() < 2, Category::VertexLt2Edges, Element::Vertex(a));
        add(!naive.link_is_connected(a, &neighbours), Category::NonmanifoldVertex, Element::Vertex(a));
        for b in a + 1..n {
            let uses = naive.uses(a, b);
            if uses.is_empty() {
                continue;
            }
            let here = Element::Edge([a, b]);
            add(naive.point(a) == naive.point(b), Category::ZeroLengthEdge, here.clone());
            add(uses.len() == 1, Category::BoundaryEdge, here.clone());
            add(uses.len() >= 3, Category::EdgeUsedGt2, here.clone());
            add(uses.len() >= 3 && uses.len() % 2 == 1, Category::EdgeOddUse, here.clone());
            let by = |face: usize| uses.iter().filter(|u| u.0 == face).count();
            add((0..mesh.faces.len()).any(|face| by(face) >= 2), Category::EdgeTwiceInSameFace, here.clone());
            let one_way = uses.len() == 2 && uses[0].2 == uses[1].2;
            add(one_way, Category::InconsistentWindingEdge, here);
            for v in (0..n).filter(|&v| v != a && v != b && naive.is_used(v)) {
                let t = parameter(naive.point(v), naive.point(a), naive.point(b));
                let inside = t.is_some_and(|t| t > 0 && t < 1);
                add(inside, Category::TJunction, Element::VertexInEdge(v, [a, b]));
            }
            if let Some(Listed { edges, .. }) = listed {
                let is_listed = edges.contains(&[a, b]) || edges.contains(&[b, a]);
                add(!is_listed, Category::EdgeMissingFromList, Element::Edge([a, b]));
            }
        }
    }
    if let Some(Listed { edges, faces }) = listed {
        for (i, &[a, b]) in edges.iter().enumerate() {
            let uses = if a == b { Vec::new() } else { naive.uses(a, b) };
            add(uses.is_empty(), Category::EdgeUnreferenced, Element::Record(i));
            let times = edges.iter().filter(|&&other| other == [a, b] || other == [b, a]).count();
            add(times > 1, Category::DuplicateEdgeRecord, Element::Edge([a.min(b), a.max(b)]));
            if let Some(faces) = faces {
                let using = |f: u32| uses.iter().any(|u| u.0 == f as usize);
                let all_listed = (0..mesh.faces.len() as u32).all(|f| !using(f) || faces[i].contains(&f));
                let all_use = faces[i].iter().all(|&f| using(f));
                add(!(all_listed && all_use), Category::EdgeFaceNotReciprocal, Element::Record(i));
            }
        }
    }
    let counts = naive.counts(&mut found);
    (found, Some(counts))
}

fn loops(face: &Face) -> Vec<Vec<u32>> {
    std::iter::once(face.outer.clone()).chain(face.holes.clone()).collect()
}

struct Naive<'a> {
    mesh: &'a VertexList,
}

impl Naive<'_> {
    fn point(&self, v: u32) -> &Point {
        &self.mesh.vertices[v as usize]
    }

    fn points(&self, l: &[u32]) -> Vec<Point> {
        l.iter().map(|&v| self.point(v).clone()).collect()
    }

    fn is_used(&self, v: u32) -> bool {
        self.mesh.faces.iter().any(|face| loops(face).iter().any(|l| l.contains(&v)))
    }

    /// The sides between two vertices: face, loop, whether from the smaller one.
    fn uses(&self, a: u32, b: u32) -> Vec<(usize, usize, bool)> {
        let mut uses = Vec::new();
        for (i, face) in self.mesh.faces.iter().enumerate() {
            for (j, l) in loops(face).iter().enumerate() {
                for k in 0..l.len() {
                    let side = [l[k], if k + 1 == l.len() { l[0] } else { l[k + 1] }];
                    if a != b && (side == [a, b] || side == [b, a]) {
                        uses.push((i, j, side[0] < side[1]));
                    }
                }
            }
        }
        uses
    }

    /// Whether there is a way along corners at v from each of its neighbours to each other one.
    fn link_is_connected(&self, v: u32, neighbours: &[u32]) -> bool {
        let Some(&first) = neighbours.first() else { return true };
        let mut corners = Vec::new();
        for l in self.mesh.faces.iter().flat_map(loops) {
            let m = l.len();
            for i in (0..m).filter(|&i| l[i] == v) {
                // The nearest different vertex on either side.
                let after = (1..m).map(|d| l[(i + d) % m]).find(|&w| w != v);
                let before = (1..m).map(|d| l[(i + m - d) % m]).find(|&w| w != v);
                corners.extend(before.zip(after));
            }
        }
        let mut reached = vec![first];
        let mut next = 0;
        while next < reached.len() {
            for &(a, b) in &corners {
                for (from, to) in [(a, b), (b, a)] {
                    if from == reached[next] && !reached.contains(&to) {
                        reached.push(to);
                    }
                }
            }
            next += 1;
        }
        neighbours.iter().all(|w| reached.contains(w))
    }

    /// ½ Σ (vᵢ − v₁) × (vᵢ₊₁ − v₁).
    fn area(&self, l: &[u32]) -> Point {
        let points = self.points(l);
        let triangles = (1..points.len().max(2) - 1).map(|i| {
            (points[i].clone() - &points[0])
                .cross(&(points[i + 1].clone() - &points[0]))
                .scaled(&Rational::from((1, 2)))
        });
        triangles.fold(Vector::zero(), |sum, t| sum + &t)
    }

    fn counts(&self, found: &mut Found) -> Counts {
        let (faces, n) = (&self.mesh.faces, self.mesh.vertices.len() as u32);
        let edges: Vec<_> = (0..n)
            .flat_map(|a| (a + 1..n).map(move |b| (a, b)))
            .map(|(a, b)| self.uses(a, b))
            .filter(|uses| !uses.is_empty())
            .collect();
        let used: Vec<u32> = (0..n).filter(|&v| self.is_used(v)).collect();
        let mut left: BTreeSet<u32> = used.iter().copied().collect();
        let mut components = 0;
        while let Some(start) = left.pop_first() {
            components += 1;
            let mut pending = vec![start];
            while let Some(v) = pending.pop() {
                for face in faces.iter().map(|face| loops(face).concat()).filter(|all| all.contains(&v)) {
                    pending.extend(face.into_iter().filter(|w| left.remove(w)));
                }
            }
        }
        let holes: usize = faces.iter().map(|face| face.holes.len()).sum();
        let chi = used.len() as i64 - edges.len() as i64 + faces.len() as i64 - holes as i64;
        let has = |category| found.contains_key(&category);
        let closed = edges.iter().all(|uses| uses.len() == 2) && !has(Category::DegenerateEdgeSameIndex);
        let consistent = !has(Category::InconsistentWindingEdge);
        let same_sense = |u: &(usize, usize, bool)| {
            let face = &faces[u.0];
            u.1 > 0 && self.area(&face.holes[u.1 - 1]).dot(&self.area(&face.outer)) > 0
        };
        let works = |flips: u32, turn: bool| {
            let along = |u: &(usize, usize, bool)| u.2 ^ (flips >> u.0 & 1 == 1) ^ (turn && same_sense(u));
            edges.iter().filter(|uses| uses.len() == 2).all(|uses| along(&uses[0]) != along(&uses[1]))
        };
        let orientable = [false, true].iter().any(|&turn| (0..1 << faces.len()).any(|flips| works(flips, turn)));
        let manifold = closed && consistent && orientable && !has(Category::NonmanifoldVertex);
        // ∫ z dx dy over the fans: the volume under the surface.
        let volume = (closed && consistent && orientable).then(|| {
            let third = Rational::from((1, 3));
            faces.iter().flat_map(loops).fold(Rational::new(), |sum, l| {
                (1..l.len().max(2) - 1).fold(sum, |sum, i| {
                    let height = [0, i, i + 1].iter().fold(Rational::new(), |h, &j| h + &self.point(l[j])[2]);
                    sum + height * &third * &self.area(&[l[0], l[i], l[i + 1]])[2]
                })
            })
        });
        let mut mesh_defect = |is_there: bool, category: Category| {
            if is_there {
                found.insert(category, BTreeSet::from([Element::Mesh]));
            }
        };
        let flippable = (0..1 << faces.len()).any(|flips| works(flips, false));
        let no_same_sense =
            !faces.iter().enumerate().any(|(i, face)| (1..=face.holes.len()).any(|j| same_sense(&(i, j, true))));
        mesh_defect(closed && no_same_sense && !flippable, Category::NonOrientable);
        mesh_defect(volume.as_ref().is_some_and(|volume| *volume < 0), Category::InsideOut);
        mesh_defect(volume.as_ref().is_some_and(|volume| *volume == 0), Category::ZeroVolume);
        let genus = (manifold && chi % 2 == 0).then(|| (2 * components - chi) / 2);
        Counts {
            vertices: used.len(),
            edges: edges.len(),
            faces: faces.len(),
            holes,
            components: components as usize,
            chi,
            genus,
            closed,
            orientable,
            manifold,
            volume,
        }
    }
}

/// Whether two loops are equal as cycles, in either direction: every rotation is tried.
pub fn same_cycle(a: &[u32], b: &[u32]) -> bool {
    let m = a.len();
    let equal = |at: &dyn Fn(usize, usize) -> usize| (0..m).any(|shift| (0..m).all(|i| a[i] == b[at(i, shift)]));
    m == b.len() && (m == 0 || equal(&|i, shift| (i + shift) % m) || equal(&|i, shift| (shift + m - i) % m))
}

/// Whether every triple is.
pub fn on_a_line(points: &[Point]) -> bool {
    let d = |i: usize, j: usize| points[j].clone() - &points[i];
    let n = points.len();
    (0..n).all(|i| (0..i).all(|j| (0..j).all(|k| d(i, j).cross(&d(i, k)) == Vector::zero())))
}

/// Whether every quadruple is.
pub fn in_a_plane(points: &[Point]) -> bool {
    let d = |i: usize, j: usize| points[j].clone() - &points[i];
    let n = points.len();
    (0..n).all(|i| (0..i).all(|j| (0..j).all(|k| (0..k).all(|l| d(i, j).cross(&d(i, k)).dot(&d(i, l)).is_zero()))))
}

/// t with p = a + t(b − a).
fn parameter(p: &Point, a: &Point, b: &Point) -> Option<Rational> {
    let axis = (0..3).find(|&k| a[k] != b[k])?;
    let t = Rational::from(&p[axis] - &a[axis]) / Rational::from(&b[axis] - &a[axis]);
    (a.clone() + &(b.clone() - a).scaled(&t) == *p).then_some(t)
}

/// Whether two sides that are not adjacent cross: every pair is tried.
pub fn crosses_itself(points: &[Point]) -> bool {
    let m = points.len();
    let side = |i: usize| [&points[i], &points[(i + 1) % m]];
    let adjacent = |i: usize, j: usize| j == i + 1 || (i == 0 && j + 1 == m);
    (0..m).any(|i| (i + 1..m).any(|j| !adjacent(i, j) && segments_cross(side(i), side(j))))
}

/// Whether p + t(q − p) = r + s(u − r) has one solution, with t and s in (0, 1).
fn segments_cross([p, q]: [&Point; 2], [r, u]: [&Point; 2]) -> bool {
    let (d, e, w) = (q.clone() - p, u.clone() - r, r.clone() - p);
    let pairs = [(0, 1), (1, 2), (2, 0)];
    let det =
        |a: &Point, b: &Point, (i, j): (usize, usize)| Rational::from(&a[i] * &b[j]) - Rational::from(&a[j] * &b[i]);
    let Some(pair) = pairs.into_iter().find(|pair| !det(&d, &e, *pair).is_zero()) else { return false };
    let t = det(&w, &e, pair) / det(&d, &e, pair);
    let s = det(&w, &d, pair) / det(&d, &e, pair);
    let meet = p.clone() + &d.scaled(&t) == r.clone() + &e.scaled(&s);
    meet && t > 0 && t < 1 && s > 0 && s < 1
}
