//! What is drawn: tetrahedra drawn apart, lines, colours, words.

use super::Paint;
use crate::complex::realise::Realised;
use crate::complex::realise::project::principal_axes;
use crate::format::gltf::Part;

/// A realised complex as it is drawn, about 0 and within distance 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The heading.
    pub title: String,
    /// What is known of it: names and values.
    pub facts: Vec<(String, String)>,
    /// The positions in ℝ³.
    pub positions: Vec<[f64; 3]>,
    /// The positions in ℝⁿ, in their principal axes.
    pub coordinates: Vec<Vec<f64>>,
    /// The corners of each tetrahedron.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The group of each tetrahedron.
    pub groups: Vec<u32>,
    /// What the groups are called.
    pub names: Vec<String>,
    /// The ends of the lines.
    pub lines: Vec<[u32; 2]>,
}

/// How far the corners of a tetrahedron stand from its middle, as a part of the whole way: the inside shows between them.
pub const SHRUNK: f64 = 0.5;

/// The colours of groups, which come round again; apart in hue and in lightness, legible on light and on dark.
pub const COLOURS: [[u8; 3]; 8] = [
    [61, 128, 188],
    [226, 146, 52],
    [70, 158, 118],
    [196, 84, 92],
    [134, 104, 190],
    [210, 186, 70],
    [84, 176, 196],
    [206, 128, 170],
];

/// The colour of the lines in glTF, which knows no light and dark.
const LINE: [u8; 3] = [24, 28, 36];

/// The group of each tetrahedron.
pub(super) fn groups(realised: &Realised, paint: &Paint) -> Vec<u32> {
    (0..realised.mesh.tetrahedra().len()).map(|i| paint.groups.get(i).copied().unwrap_or(0)).collect()
}

/// The lines between vertices that exist.
pub(super) fn lines(realised: &Realised, paint: &Paint) -> Vec<[u32; 2]> {
    let exists = |line: &&[u32; 2]| line.iter().all(|v| (*v as usize) < realised.mesh.vertices());
    paint.lines.iter().filter(exists).copied().collect()
}

/// The colour of a group.
pub fn colour(group: u32) -> [u8; 3] {
    COLOURS[group as usize % COLOURS.len()]
}

impl Scene {
    /// The scene of a realised complex.
    pub fn of(realised: &Realised, paint: &Paint) -> Scene {
        let mut positions = realised.positions.clone();
        let mut coordinates: Vec<Vec<f64>> = principal_axes(&realised.points).iter().map(<[f64]>::to_vec).collect();
        scaled(positions.iter_mut().map(<[f64; 3]>::as_mut_slice).collect());
        scaled(coordinates.iter_mut().map(Vec::as_mut_slice).collect());
        Scene {
            title: paint.title.clone(),
            facts: facts(realised),
            positions,
            coordinates,
            tetrahedra: realised.mesh.tetrahedra().to_vec(),
            groups: groups(realised, paint),
            names: paint.names.clone(),
            lines: lines(realised, paint),
        }
    }

    /// The corners of a tetrahedron, drawn toward its middle.
    pub fn corners(&self, tetrahedron: usize) -> [[f64; 3]; 4] {
        let corners = self.tetrahedra[tetrahedron].map(|v| self.positions[v as usize]);
        let middle: [f64; 3] = std::array::from_fn(|i| corners.iter().map(|p| p[i]).sum::<f64>() / 4.0);
        corners.map(|p| std::array::from_fn(|i| middle[i] + SHRUNK * (p[i] - middle[i])))
    }

    /// The named groups that occur.
    pub fn legend(&self) -> Vec<(u32, &str)> {
        let occurs = |group: &u32| self.groups.contains(group);
        (0..).zip(self.names.iter().map(String::as_str)).filter(|(group, _)| occurs(group)).collect()
    }

    /// Triangles and lines by their colours.
    pub fn parts(&self) -> Vec<Part> {
        let mut numbers = self.groups.clone();
        numbers.sort_unstable();
        numbers.dedup();
        let mut parts: Vec<Part> = numbers.into_iter().map(|group| self.part(group)).collect();
        let ends = self.lines.iter().flatten().map(|v| self.positions[*v as usize].map(|x| x as f32));
        let (positions, normals) = (ends.collect(), Vec::new());
        parts.push(Part { name: "edges".to_owned(), positions, normals, colour: LINE.map(linear) });
        parts
    }

    fn part(&self, group: u32) -> Part {
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        for i in (0..self.tetrahedra.len()).filter(|i| self.groups[*i] == group) {
            for triangle in outward(self.corners(i)) {
                // A triangle without area has no normal, and none is seen of it.
                let Some(normal) = normal(triangle) else { continue };
                for corner in triangle {
                    positions.push(corner.map(|x| x as f32));
                    normals.push(normal.map(|x| x as f32));
                }
            }
        }
        let name = self.names.get(group as usize).filter(|name| !name.is_empty()).cloned();
        let colour = colour(group).map(linear);
        Part { name: name.unwrap_or_else(|| format!("group {group}")), positions, normals, colour }
    }
}

/// The triangles of a tetrahedron, counter-clockwise as seen from outside.
pub(super) fn outward(corners: [[f64; 3]; 4]) -> [[[f64; 3]; 3]; 4] {
    let [a, b, c, d] = corners;
    let right = [[b, c, d], [a, d, c], [a, b, d], [a, c, b]];
    // With |b − a, c − a, d − a| > 0 these are seen counter-clockwise from outside.
    let volume = dot(cross(minus(b, a), minus(c, a)), minus(d, a));
    if volume >= 0.0 { right } else { right.map(|[p, q, r]| [p, r, q]) }
}

/// The unit normal; `None` for a triangle without area.
pub(super) fn normal([a, b, c]: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    let n = cross(minus(b, a), minus(c, a));
    let length = dot(n, n).sqrt();
    (length > 1e-12).then(|| n.map(|x| x / length))
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// sRGB to linear light.
fn linear(channel: u8) -> f32 {
    let x = f32::from(channel) / 255.0;
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}

/// Points about the middle of their box, the farthest at distance 1.
fn scaled(mut points: Vec<&mut [f64]>) {
    for axis in 0..points.first().map_or(0, |p| p.len()) {
        let range =
            points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |r, p| [r[0].min(p[axis]), r[1].max(p[axis])]);
        points.iter_mut().for_each(|p| p[axis] -= f64::midpoint(range[0], range[1]));
    }
    let farthest = points.iter().map(|p| p.iter().map(|x| x * x).sum::<f64>()).fold(0.0, f64::max).sqrt();
    if farthest > 0.0 {
        points.iter_mut().for_each(|p| p.iter_mut().for_each(|x| *x /= farthest));
    }
}

fn facts(realised: &Realised) -> Vec<(String, String)> {
    let (mesh, found) = (&realised.mesh, &realised.intersections);
    let n = realised.points.dimension();
    let counts = [mesh.vertices(), mesh.edges().len(), mesh.triangles().len(), mesh.tetrahedra().len()].map(grouped);
    let embedded = match (&found.not_simplicial, found.flat, found.pairs) {
        (Some(_), _, _) => "no: it is not a simplicial complex".to_owned(),
        (None, 0, 0) => "yes".to_owned(),
        (None, 0, pairs) => format!("no: {} pairs of tetrahedra meet", grouped(pairs)),
        (None, flat, pairs) => format!("no: {} flat tetrahedra, {} pairs meet", grouped(flat), grouped(pairs)),
    };
    let energy = [realised.energies.first(), realised.energies.last()].map(|e| e.copied().unwrap_or(0.0));
    let lengths = realised.lengths;
    let facts = [
        ("vertices", counts[0].clone()),
        ("edges", counts[1].clone()),
        ("triangles", counts[2].clone()),
        ("tetrahedra", counts[3].clone()),
        ("energy", format!("{:.4} → {:.4} in {} steps", energy[0], energy[1], realised.energies.len() - 1)),
        ("edge lengths", format!("{:.3} … {:.3}, mean {:.3}", lengths.min, lengths.max, lengths.mean)),
        ("embedded in", format!("ℝ{}: {embedded}", ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶"].get(n).unwrap_or(&"ⁿ"))),
    ];
    facts.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// A count with its thousands apart.
fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|c| std::str::from_utf8(c).expect("digits")).collect();
    groups.join("\u{202f}")
}
