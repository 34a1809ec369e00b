//! The topology of a cell by subdivision: a second way to what `cell` decides, which knows nothing of cuts,
//! classes or tunnels (IS-96).
//!
//! Planes across the axes cut the cell into boxes until in each box f has one sign, or one partial derivative has.
//! Both are told by the box's corners: f lies between its least and greatest corner value, and a partial derivative,
//! which is bilinear, between the least and the greatest difference along the box's edges of that axis. A box of the second
//! kind retracts along the axis to the face where f is least (for {f ≤ 0}; greatest for {f ≥ 0}), and there f is bilinear: what remains is counted by
//! corner signs and one determinant. The rest is inclusion and exclusion over boxes, faces, edges and vertices.

use super::cell::{Degenerate, Side};
use super::critical::{BilinearCritical, TrilinearCritical, bilinear_critical, trilinear_critical};
use super::cube::{Corner, Face};
use crate::number::{Enclosure, OrderedField, Rational, Sign, Surd};
use crate::partition::Partition;
use std::collections::{BTreeSet, HashMap};
use thiserror::Error;

/// Why zero is a critical value of the cell, by the critical points themselves: the first corner at 0; else the first face
/// with its saddle inside it at 0; else a critical point inside the cell at 0. There is none else: on a curve of
/// critical points f is constant, and the curve leaves the cell through a face or an edge.
pub fn degenerate(values: &[Rational; 8]) -> Option<Degenerate> {
    let corner = Corner::ALL.into_iter().find(|c| values[c.index()].is_zero()).map(Degenerate::Corner);
    corner.or_else(|| Face::ALL.into_iter().find_map(|face| degenerate_face(values, face))).or_else(|| {
        let inside = |x: &Rational| *x > 0 && *x < 1;
        let point = match trilinear_critical(values) {
            TrilinearCritical::Point(point) => (point.value.is_zero()).then_some(point.position),
            TrilinearCritical::Pair(points) => points.into_iter().find_map(|point| {
                let (zero, one) = (Surd::from(Rational::new()), Surd::from(Rational::from(1)));
                let is_inside = point.position.iter().all(|x| *x > zero && *x < one);
                (is_inside && point.value.sign() == Sign::Zero).then(|| {
                    point
                        .position
                        .map(|x| x.rational().expect("a double root of a cut's determinant is rational").clone())
                })
            }),
            TrilinearCritical::None
            | TrilinearCritical::Line { .. }
            | TrilinearCritical::ThreeLines(_)
            | TrilinearCritical::Hyperbola { .. }
            | TrilinearCritical::Everywhere => None,
        };
        point.filter(|point| point.iter().all(inside)).map(|point| Degenerate::Interior { point: Box::new(point) })
    })
}

fn degenerate_face(values: &[Rational; 8], face: Face) -> Option<Degenerate> {
    let [u, v] = [(face.axis() + 1) % 3, (face.axis() + 2) % 3];
    let origin = Corner::ALL.into_iter().find(|c| {
        let at = c.position();
        at[face.axis()] == face.side() && at[u] == 0 && at[v] == 0
    })?;
    let corners = [origin, origin.across(u), origin.across(v), origin.across(u).across(v)];
    match bilinear_critical(&corners.map(|c| values[c.index()].clone())) {
        BilinearCritical::None | BilinearCritical::Everywhere => None,
        BilinearCritical::Saddle(saddle) => {
            let is_inside = [&saddle.u, &saddle.v].iter().all(|x| **x > 0 && **x < 1);
            (is_inside && saddle.value.is_zero()).then(|| {
                let mut point = [Rational::new(), Rational::new(), Rational::new()];
                (point[face.axis()], point[u], point[v]) = (Rational::from(face.side()), saddle.u, saddle.v);
                Degenerate::Face { face, point: Box::new(point) }
            })
        }
    }
}

/// What a subdivision shows of {f = 0} in a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subdivision {
    /// {f ≤ 0}.
    pub negative: Side,
    /// {f ≥ 0}.
    pub positive: Side,
    /// The components of {f = 0}: which part of {f ≤ 0} meets which of {f ≥ 0}, by their numbers; sorted.
    pub components: Vec<[usize; 2]>,
    /// χ of {f = 0}.
    pub chi: i64,
    /// How many boxes it took.
    pub boxes: usize,
}

/// Planes of the least distance do not suffice: the cell is degenerate, or nearly so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("boxes of side 2^-{bits} do not show the topology")]
pub struct TooCoarse {
    /// The least distance of planes is 2^−bits.
    pub bits: u32,
}

/// The cell cut by planes across its axes.
struct Grid<'a, K> {
    values: &'a [K; 8],
    /// 2^bits, the side of the cell in units of the least distance.
    side: i64,
    /// The planes across each axis, sorted, 0 and `side` among them.
    planes: [Vec<i64>; 3],
    /// side³ f at the points asked for so far.
    known: HashMap<[i64; 3], K>,
}

fn sign<K: Enclosure>(value: &K) -> Sign {
    value.known_sign().expect("exact numbers have a sign")
}

/// What the corners of a box show.
enum Shape {
    /// f has one sign.
    Uniform,
    /// The partial derivative along an axis has one sign.
    Monotone(usize),
    /// Neither.
    Unknown,
}

impl<K: Enclosure> Grid<'_, K> {
    fn at(&mut self, point: [i64; 3]) -> K {
        let (values, side) = (self.values, self.side);
        let value = self.known.entry(point).or_insert_with(|| {
            let [x, y, z] = point.map(|x| [K::integer(side - x), K::integer(x)]);
            let mix = |a: &K, b: &K, t: &[K; 2]| a.clone() * &t[0] + &(b.clone() * &t[1]);
            let [a, b, c, d] = [0, 2, 4, 6].map(|i| mix(&values[i], &values[i + 1], &x));
            mix(&mix(&a, &b, &y), &mix(&c, &d, &y), &z)
        });
        value.clone()
    }

    /// The values at the corners of the box between these planes and the next ones.
    fn corner_values(&mut self, low: [usize; 3]) -> [K; 8] {
        Corner::ALL.map(|c| {
            let offset = c.position();
            self.at([0, 1, 2].map(|a| self.planes[a][low[a] + usize::from(offset[a])]))
        })
    }

    fn boxes(&self) -> Vec<[usize; 3]> {
        let [nx, ny, nz] = self.planes.each_ref().map(|planes| planes.len() - 1);
        (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k]))).collect()
    }

    /// Puts a plane across the axis between two others, near their middle, where f has no zero at a vertex and the plane
    /// no saddle at zero.
    fn split(&mut self, axis: usize, [low, high]: [i64; 2]) -> bool {
        let length = high - low;
        let offsets = [(1, 2), (3, 8), (5, 8), (7, 16), (9, 16), (1, 4), (3, 4), (15, 32), (17, 32)];
        let mut places = offsets.iter().map(|(n, d)| low + length * n / d).filter(|x| *x > low && *x < high);
        let Some(plane) = places.find(|x| self.is_general(axis, *x)) else { return false };
        let planes = &mut self.planes[axis];
        planes.insert(planes.partition_point(|x| *x < plane), plane);
        true
    }

    fn is_general(&mut self, axis: usize, plane: i64) -> bool {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let mut point = [0; 3];
        point[axis] = plane;
        for x in self.planes[u].clone() {
            for y in self.planes[v].clone() {
                (point[u], point[v]) = (x, y);
                if sign(&self.at(point)) == Sign::Zero {
                    return false;
                }
            }
        }
        let corners = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| {
            (point[u], point[v]) = (x * self.side, y * self.side);
            self.at(point)
        });
        !(alternates(&corners) && determinant(&corners) == Sign::Zero)
    }
}

/// Whether the signs alternate around a rectangle with values g00, g10, g01, g11 at its corners, none of them 0.
fn alternates<K: Enclosure>(g: &[K; 4]) -> bool {
    let [a, b, c, d] = g.each_ref().map(sign);
    a == d && b == c && a != b
}

/// The sign of g00·g11 − g10·g01.
fn determinant<K: Enclosure>([a, b, c, d]: &[K; 4]) -> Sign {
    sign(&(a.clone() * d - &(b.clone() * c)))
}

/// Of four corners of a rectangle, numbered as in g, the pairs that {f < 0} or {f > 0} connects.
fn joined<K: Enclosure>(g: &[K; 4]) -> Vec<[usize; 2]> {
    let edges = [[0, 1], [0, 2], [1, 3], [2, 3]].into_iter().filter(|[a, b]| sign(&g[*a]) == sign(&g[*b]));
    let diagonal = alternates(g).then(|| if determinant(g) == Sign::Positive { [0, 3] } else { [1, 2] });
    edges.chain(diagonal).collect()
}

/// How many components {f < 0} (or {f > 0}) has in a rectangle; each is contractible.
fn pieces<K: Enclosure>(g: &[K; 4], of: Sign) -> i64 {
    let corners = g.iter().filter(|v| sign(*v) == of).count();
    let joined_diagonal = if determinant(g) == Sign::Positive { 0 } else { 1 };
    match corners {
        0 => 0,
        2 if alternates(g) && sign(&g[joined_diagonal]) != of => 2,
        _ => 1,
    }
}

/// The four corners of a box's face, as g00, g10, g01, g11.
fn face_values<K: Clone>(values: &[K; 8], axis: usize, side: u8) -> [K; 4] {
    face_corners(axis, side).map(|c| values[c.index()].clone())
}

fn face_corners(axis: usize, side: u8) -> [Corner; 4] {
    let low = if side == 0 { Corner::ALL[0] } else { Corner::ALL[0].across(axis) };
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    [low, low.across(u), low.across(v), low.across(u).across(v)]
}

fn shape<K: Enclosure>(values: &[K; 8]) -> Shape {
    if values.iter().all(|v| sign(v) == sign(&values[0])) {
        return Shape::Uniform;
    }
    let is_monotone = |axis: &usize| {
        let low = face_corners(*axis, 0);
        let slopes = low.map(|c| sign(&(values[c.across(*axis).index()].clone() - &values[c.index()])));
        slopes[0] != Sign::Zero && slopes.iter().all(|s| *s == slopes[0])
    };
    (0..3).find(is_monotone).map_or(Shape::Unknown, Shape::Monotone)
}

/// The topology of {f = 0} for a cell that is not [`degenerate`], by boxes no thinner than 2^−bits.
///
/// Errors: iff they do not suffice.
#[doc(alias = "IS-96")]
pub fn topology<K: Enclosure>(values: &[K; 8], bits: u32) -> Result<Subdivision, TooCoarse> {
    let side = 1i64 << bits;
    let mut grid = Grid { values, side, planes: [0, 1, 2].map(|_| vec![0, side]), known: HashMap::new() };
    loop {
        let mut wide: BTreeSet<(usize, [i64; 2])> = BTreeSet::new();
        for low in grid.boxes() {
            if matches!(shape(&grid.corner_values(low)), Shape::Unknown) {
                let sides = [0, 1, 2].map(|a| [grid.planes[a][low[a]], grid.planes[a][low[a] + 1]]);
                let widest = (0..3).rev().max_by_key(|a| sides[*a][1] - sides[*a][0]).expect("three axes");
                wide.insert((widest, sides[widest]));
            }
        }
        if wide.is_empty() {
            return Ok(Count::of(grid).conclude());
        }
        for (axis, sides) in wide {
            if !grid.split(axis, sides) {
                return Err(TooCoarse { bits });
            }
        }
    }
}

/// The sums over boxes, faces, edges and vertices.
struct Count<'a, K> {
    grid: Grid<'a, K>,
    /// Which vertices of the grid are connected in their sign.
    parts: Partition,
    /// χ of {f ≤ 0} and of {f ≥ 0}.
    chi: [i64; 2],
}

const SIDES: [Sign; 2] = [Sign::Negative, Sign::Positive];

impl<'a, K: Enclosure> Count<'a, K> {
    fn of(grid: Grid<'a, K>) -> Count<'a, K> {
        let vertices = grid.planes.iter().map(Vec::len).product();
        let mut count = Count { grid, parts: Partition::new(vertices), chi: [0, 0] };
        for low in count.grid.boxes() {
            let values = count.grid.corner_values(low);
            count.add_box(low, &values);
            // The faces, edges and the vertex at the low end of the box, as far as they are inside the cell.
            let inner: Vec<usize> = (0..3).filter(|&a| low[a] > 0).collect();
            for &axis in &inner {
                let face = face_values(&values, axis, 0);
                count.add(-1, |of| pieces(&face, of));
            }
            for axis in 0..3 {
                if (0..3).all(|a| a == axis || low[a] > 0) {
                    let ends = [sign(&values[0]), sign(&values[1 << axis])];
                    count.add(1, |of| i64::from(ends.contains(&of)));
                }
            }
            if inner.len() == 3 {
                count.add(-1, |of| i64::from(sign(&values[0]) == of));
            }
        }
        count
    }

    fn add(&mut self, times: i64, pieces: impl Fn(Sign) -> i64) {
        for (chi, of) in self.chi.iter_mut().zip(SIDES) {
            *chi += times * pieces(of);
        }
    }

    fn vertex(&self, low: [usize; 3], corner: Corner) -> usize {
        let offset = corner.position();
        let [nx, ny, _] = self.grid.planes.each_ref().map(Vec::len);
        let [i, j, k] = [0, 1, 2].map(|a| low[a] + usize::from(offset[a]));
        i + nx * (j + ny * k)
    }

    fn join(&mut self, low: [usize; 3], a: Corner, b: Corner) {
        let (a, b) = (self.vertex(low, a), self.vertex(low, b));
        self.parts.join(a, b);
    }

    fn add_box(&mut self, low: [usize; 3], values: &[K; 8]) {
        match shape(values) {
            Shape::Uniform => {
                Corner::ALL.into_iter().for_each(|c| self.join(low, Corner::ALL[0], c));
                self.add(1, |of| i64::from(sign(&values[0]) == of));
            }
            Shape::Monotone(axis) => {
                let rises = sign(&(values[1 << axis].clone() - &values[0])) == Sign::Positive;
                for of in SIDES {
                    // The face to which this side retracts, along the edges of the axis.
                    let end = u8::from((of == Sign::Positive) == rises);
                    let (corners, face) = (face_corners(axis, end), face_values(values, axis, end));
                    for [a, b] in joined(&face).into_iter().filter(|[a, _]| sign(&face[*a]) == of) {
                        self.join(low, corners[a], corners[b]);
                    }
                    for c in corners {
                        if sign(&values[c.across(axis).index()]) == of {
                            self.join(low, c, c.across(axis));
                        }
                    }
                    let index = usize::from(of == Sign::Positive);
                    self.chi[index] += pieces(&face, of);
                }
            }
            Shape::Unknown => unreachable!("the subdivision ends when every box is of one of the other two kinds"),
        }
    }

    fn conclude(mut self) -> Subdivision {
        let [nx, ny, nz] = self.grid.planes.each_ref().map(Vec::len);
        let corner = |c: Corner| {
            let [x, y, z] = c.position().map(usize::from);
            x * (nx - 1) + nx * (y * (ny - 1) + ny * (z * (nz - 1)))
        };
        let mut roots: [Vec<usize>; 2] = [Vec::new(), Vec::new()];
        let mut sides = [0, 1].map(|_| Side { parts: Vec::new(), b1: 0 });
        for c in Corner::ALL {
            let s = usize::from(sign(&self.grid.values[c.index()]) == Sign::Positive);
            let root = self.parts.find(corner(c));
            match roots[s].iter().position(|r| *r == root) {
                Some(part) => sides[s].parts[part].push(c),
                None => {
                    roots[s].push(root);
                    sides[s].parts.push(vec![c]);
                }
            }
        }
        for (side, chi) in sides.iter_mut().zip(self.chi) {
            // No voids: a component of the other side would be without a corner.
            side.b1 = side.parts.len() as i64 - chi;
        }
        // Two parts that meet do so in one component: a second one would make a loop through both that cannot be shrunk.
        let mut components = BTreeSet::new();
        for low in self.grid.boxes() {
            let values = self.grid.corner_values(low);
            for axis in 0..3 {
                for c in face_corners(axis, 0)
                    .into_iter()
                    .filter(|c| sign(&values[c.index()]) != sign(&values[c.across(axis).index()]))
                {
                    let ends = if sign(&values[c.index()]) == Sign::Negative {
                        [c, c.across(axis)]
                    } else {
                        [c.across(axis), c]
                    };
                    let mut part = |s: usize| {
                        let vertex = self.vertex(low, ends[s]);
                        let root = self.parts.find(vertex);
                        roots[s].iter().position(|r| *r == root).expect("every part has a corner of the cell (IS-75)")
                    };
                    components.insert([part(0), part(1)]);
                }
            }
        }
        let [negative, positive] = sides;
        Subdivision {
            negative,
            positive,
            components: components.into_iter().collect(),
            // The two sides cover the cell, χ = 1, and meet in {f = 0}.
            chi: self.chi[0] + self.chi[1] - 1,
            boxes: self.grid.boxes().len(),
        }
    }
}
