//! A small volume, its corner values, and a surface in it.

use super::projection::{CELL, Facing, Seen, lighting};
use super::{Picture, canvas, mesh, rounded};
use crate::isosurface::cases::Case;
use crate::isosurface::cell::{Decisions, Tie, assemble, decisions};
use crate::isosurface::classes::classes;
use crate::isosurface::cube::{Corner, Edge, Face};
use crate::isosurface::patch::{PatchVertex, patch};
use crate::isosurface::volume::Volume;
use crate::judge::report::{SurfaceRecord, VolumeQuestion};
use crate::number::{Rational, Sign, text};
use ::svg::node::element::{Circle, Group, Line, Path, SVG, Text};

/// The most samples with a dot, with a number and a value, and with hints at ambiguous faces.
const MOST_DOTS: usize = 64;
const MOST_LABELS: usize = 27;
const MOST_HINTS: usize = 18;

/// A volume and, where there is one, a surface in it.
///
/// Positive corners (f > c) are filled, negative ones hollow, a corner at the isovalue is half filled; each
/// has its number in `values` and its value. On an ambiguous face the diagonal that the bilinear function
/// joins is dotted, through the saddle. The side of the surface toward f > c is blue, the other one ochre
/// and hatched; its lines on the faces of the cells are bold, and an edge that ends the surface inside the
/// grid, or has more than two triangles, is red and dashed. Triangles with a vertex that is not there or not
/// within a cell's length of the grid are left out, and counted in the description.
pub fn volume_picture(question: &VolumeQuestion, surface: Option<&SurfaceRecord>, title: &str) -> Picture {
    let cells = question.shape.map(|n| n.saturating_sub(1).max(1));
    let longest = cells.into_iter().max().unwrap_or(1) as f64;
    let stage = Stage::new(cells, (380.0 / longest).clamp(24.0, 195.0), 46.0);
    let samples = Samples::new(question);
    let mut description = samples.description(question);
    let mut svg = Group::new();
    svg = stage.lines(svg, Layer::Behind);
    svg = samples.hints(svg, &stage, Layer::Behind);
    svg = samples.dots(svg, &stage, Layer::Behind);
    if let Some(surface) = surface {
        let (triangles, left_out) = mesh::triangles(surface, cells, |p| stage.place(p));
        description += &format!(" The surface has {} triangles.", surface.faces.len());
        if left_out > 0 {
            description += &format!(" {left_out} of them lie outside the picture.");
        }
        svg = mesh::draw(svg, &triangles);
    }
    svg = stage.lines(svg, Layer::Before);
    svg = samples.hints(svg, &stage, Layer::Before);
    svg = samples.dots(svg, &stage, Layer::Before);
    svg = samples.labels(svg, &stage);
    svg = stage.axes(svg);
    let svg: SVG = canvas(stage.width, stage.height, title, &description).add(svg);
    Picture(svg.to_string())
}

/// A case as a small icon: one cell of it, with its surface through the middles of the edges.
pub fn case_icon(case: Case) -> Picture {
    let stage = Stage::new([1, 1, 1], 24.0, 5.0);
    // Of the positions of the case, the first of those that show most of the surface.
    let shown = |class: &Decisions| {
        let triangles = icon_triangles(class, &stage);
        let area = triangles.iter().map(|(_, _, [a, b, c])| (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
        area.map(f64::abs).sum::<f64>().round() as u64
    };
    let of_case = classes().into_iter().filter(|class| Case::of(class) == case && class.positive.count_ones() <= 4);
    let decisions = of_case.rev().max_by_key(shown).expect("each of the 33 cases has a class");
    let mut svg = stage.lines(Group::new().set("stroke-width", 0.8), Layer::Behind);
    for (facing, brightness, corners) in icon_triangles(&decisions, &stage) {
        svg = svg.add(
            Path::new()
                .set("d", path(&corners.map(|p| [p.x, p.y]), true))
                .set("fill", facing.tint(brightness))
                .set("fill-opacity", 0.85)
                .set("stroke", facing.tint(0.0))
                .set("stroke-width", 0.5)
                .set("stroke-linejoin", "round"),
        );
    }
    svg = stage.lines(svg, Layer::Before);
    for corner in Corner::ALL.into_iter().filter(|c| decisions.is_positive(*c)) {
        let p = stage.place(corner.position().map(f64::from));
        svg = svg.add(disc(p, 2.4).set("class", "dot positive").set("fill", "#1d2433"));
    }
    let title = format!("Case {case}");
    let count = decisions.positive.count_ones();
    let icon = canvas(stage.width, stage.height, &title, &format!("A cell with {count} positive corners.")).add(svg);
    Picture(icon.to_string())
}

/// The triangles of a class through the middles of the edges, in the painter's order.
fn icon_triangles(decisions: &Decisions, stage: &Stage) -> Vec<(Facing, f64, [Seen; 3])> {
    let middle = |e: Edge| {
        let [p, q] = e.corners().map(|c| c.position());
        [0, 1, 2].map(|i| f64::from(p[i] + q[i]) / 2.0)
    };
    let patch = patch(&assemble(*decisions));
    let position = |vertex: PatchVertex| match vertex {
        PatchVertex::Crossing(edge) => middle(edge),
        PatchVertex::Inner(i) => {
            let rim = &patch.inner[usize::from(i)];
            let sum = rim.iter().map(|e| middle(*e)).fold([0.0; 3], |s, m| [0, 1, 2].map(|i| s[i] + m[i]));
            sum.map(|x| x / rim.len() as f64)
        }
    };
    let placed: Vec<[Seen; 3]> = patch.triangles.iter().map(|t| t.map(|v| stage.place(position(v)))).collect();
    let order = super::painter::order(&placed);
    order.into_iter().filter_map(|i| lighting(placed[i].map(upward)).map(|(f, b)| (f, b, placed[i]))).collect()
}

/// A point of the picture with y upward again, as the normal's direction needs it.
pub(super) fn upward(p: Seen) -> Seen {
    Seen { y: -p.y, ..p }
}

/// What lies behind the surface, and what before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layer {
    Behind,
    Before,
}

/// The grid's box in the picture.
struct Stage {
    cells: [usize; 3],
    scale: f64,
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Stage {
    fn new(cells: [usize; 3], scale: f64, margin: f64) -> Stage {
        let corners =
            Corner::ALL.map(|c| CELL.project([0, 1, 2].map(|i| f64::from(c.position()[i]) * cells[i] as f64)));
        let least = |f: fn(&Seen) -> f64| corners.iter().map(f).fold(f64::INFINITY, f64::min);
        let (min_x, max_x) = (least(|p| p.x), -least(|p| -p.x));
        let (min_y, max_y) = (least(|p| p.y), -least(|p| -p.y));
        Stage {
            cells,
            scale,
            left: margin - min_x * scale,
            top: margin + max_y * scale,
            width: (max_x - min_x) * scale + 2.0 * margin,
            height: (max_y - min_y) * scale + 2.0 * margin + if margin > 20.0 { 14.0 } else { 0.0 },
        }
    }

    /// Where a grid position is in the picture, y downward.
    fn place(&self, position: [f64; 3]) -> Seen {
        let seen = CELL.project(position);
        Seen { x: self.left + seen.x * self.scale, y: self.top - seen.y * self.scale, depth: seen.depth * self.scale }
    }

    /// A grid position is before the surface iff it lies on a face of the box that faces the viewer.
    fn layer(&self, position: [usize; 3], axes: &[usize]) -> Layer {
        let is_before = axes.iter().any(|&axis| {
            position[axis] == 0 && CELL.faces_viewer(axis, -1.0)
                || position[axis] == self.cells[axis] && CELL.faces_viewer(axis, 1.0)
        });
        if is_before { Layer::Before } else { Layer::Behind }
    }

    /// The lines of the grid: those of the box, and where the grid is small, all others, thin.
    fn lines(&self, mut svg: Group, layer: Layer) -> Group {
        let is_small = self.cells.iter().all(|&n| n <= 8);
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            for (a, b) in (0..=self.cells[u]).flat_map(|a| (0..=self.cells[v]).map(move |b| (a, b))) {
                let is_end = |x: usize, i: usize| x == 0 || x == self.cells[i];
                let is_box = is_end(a, u) && is_end(b, v);
                let mut from = [0; 3];
                (from[u], from[v]) = (a, b);
                if self.layer(from, &[u, v]) != layer || !(is_box || is_small) {
                    continue;
                }
                let mut to = from;
                to[axis] = self.cells[axis];
                let [p, q] = [from, to].map(|p| self.place(p.map(|x| x as f64)));
                let mut line = segment(p, q)
                    .set("class", if is_box { "edge" } else { "grid" })
                    .set("stroke", "#4a5262")
                    .set("stroke-opacity", if is_box { 1.0 } else { 0.5 });
                if layer == Layer::Behind {
                    line = line.set("stroke-dasharray", "4 4").set("stroke-opacity", if is_box { 0.7 } else { 0.35 });
                }
                svg = svg.add(line);
            }
        }
        svg
    }

    /// The directions of the axes, in the lower left corner.
    fn axes(&self, mut svg: Group) -> Group {
        let (x, y) = (16.0, self.height - 14.0);
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let mut unit = [0.0; 3];
            unit[axis] = 22.0;
            let tip = CELL.project(unit);
            let ink = "#4a5262";
            let [p, q] = [Seen { x, y, depth: 0.0 }, Seen { x: x + tip.x, y: y - tip.y, depth: 0.0 }];
            svg = svg.add(segment(p, q).set("class", "edge").set("stroke", ink));
            let (at_x, at_y) = (x + tip.x * 1.42, y - tip.y * 1.42 + 3.5);
            svg = svg.add(label(name, at_x, at_y, 11.0).set("class", "label axis").set("font-style", "italic"));
        }
        svg
    }
}

/// The samples of the question, exactly where its numbers can be read.
struct Samples {
    volume: Option<Volume>,
    isovalue: Option<Rational>,
    shape: [usize; 3],
    texts: Vec<String>,
}

impl Samples {
    fn new(question: &VolumeQuestion) -> Samples {
        let values: Option<Vec<Rational>> = question.values.iter().map(|v| text::parse(v).ok()).collect();
        Samples {
            volume: values.and_then(|values| Volume::rationals(question.shape, values).ok()),
            isovalue: text::parse(&question.isovalue).ok(),
            shape: question.shape,
            texts: question.values.iter().map(|v| short(v)).collect(),
        }
    }

    fn len(&self) -> usize {
        self.texts.len()
    }

    fn point(&self, index: usize) -> [usize; 3] {
        let [nx, ny, _] = self.shape.map(|n| n.max(1));
        [index % nx, index / nx % ny, index / nx / ny]
    }

    fn sign(&self, index: usize) -> Option<Sign> {
        Some(Sign::of(self.volume.as_ref()?.sample(index).cmp(self.isovalue.as_ref()?)))
    }

    /// Each ambiguous face between or beside cells: the cell, the face, and the decision.
    fn ambiguous_faces(&self) -> Vec<([usize; 3], Face, i8)> {
        let (Some(volume), Some(isovalue)) = (&self.volume, &self.isovalue) else { return Vec::new() };
        if self.len() > MOST_HINTS {
            return Vec::new();
        }
        let mut found = Vec::new();
        for cell in volume.cells() {
            let decided = decisions(&volume.corner_values(cell), isovalue, Tie::Below);
            let faces = decided.expect("c − ε is no critical value (IS-60)").faces;
            for face in Face::ALL {
                let is_last = cell[face.axis()] + 2 == self.shape[face.axis()];
                if faces[face.index()] != 0 && (face.side() == 0 || is_last) {
                    found.push((cell, face, faces[face.index()]));
                }
            }
        }
        found
    }

    fn description(&self, question: &VolumeQuestion) -> String {
        let [nx, ny, nz] = question.shape;
        let mut text = format!("{nx} × {ny} × {nz} samples, isovalue {}.", short(&question.isovalue));
        if self.len() <= MOST_LABELS {
            let values: Vec<String> = self.texts.iter().enumerate().map(|(i, v)| format!("{i}: {v}")).collect();
            text += &format!(" Values by corner: {}.", values.join(", "));
        }
        for (cell, face, sign) in self.ambiguous_faces() {
            let joined = if sign > 0 { "positive" } else { "negative" };
            text += &format!(" Face {} of cell {cell:?} is ambiguous and joins its {joined} corners.", face.name());
        }
        text
    }

    fn dots(&self, mut svg: Group, stage: &Stage, layer: Layer) -> Group {
        if self.len() > MOST_DOTS {
            return svg;
        }
        for index in 0..self.len() {
            let point = self.point(index);
            if stage.layer(point, &[0, 1, 2]) != layer {
                continue;
            }
            let p = stage.place(point.map(|x| x as f64));
            let radius = self.radius();
            let ring = disc(p, radius).set("stroke", "#1d2433").set("stroke-width", 1.4);
            let sign = self.sign(index);
            let is_filled = sign == Some(Sign::Positive);
            svg = svg.add(if is_filled {
                ring.set("class", "dot positive").set("fill", "#1d2433")
            } else {
                ring.set("class", "dot negative").set("fill", "#ffffff")
            });
            if sign == Some(Sign::Zero) {
                let (x, top, r) = (rounded(p.x), rounded(p.y - radius), rounded(radius));
                let half = format!("M{x} {top}a{r} {r} 0 0 1 0 {}z", rounded(2.0 * radius));
                svg = svg.add(Path::new().set("class", "dot tie").set("fill", "#1d2433").set("d", half));
            }
            if self.len() <= MOST_LABELS {
                let size = if self.len() <= 12 { 11.0 } else { 9.0 };
                let number = label(&index.to_string(), p.x, p.y + size * 0.36, size);
                svg = svg.add(match sign {
                    Some(Sign::Positive) => number.set("class", "number in").set("fill", "#ffffff"),
                    Some(Sign::Zero) => halo(number).set("class", "number out halo"),
                    Some(Sign::Negative) | None => number.set("class", "number out"),
                });
            }
        }
        svg
    }

    fn radius(&self) -> f64 {
        match self.len() {
            0..=12 => 9.0,
            13..=MOST_LABELS => 7.0,
            _ => 3.0,
        }
    }

    /// The values beside the dots, away from the middle of the box.
    fn labels(&self, mut svg: Group, stage: &Stage) -> Group {
        if self.len() > MOST_LABELS {
            return svg;
        }
        let middle = stage.place(stage.cells.map(|n| n as f64 / 2.0));
        let size = if self.len() <= 12 { 13.0 } else { 10.0 };
        for (index, value) in self.texts.iter().enumerate() {
            let p = stage.place(self.point(index).map(|x| x as f64));
            let is_right = p.x > middle.x;
            let x = p.x + if is_right { self.radius() + 4.0 } else { -self.radius() - 4.0 };
            let y = p.y + if p.y > middle.y { size * 0.9 } else { -size * 0.2 };
            let anchor = if is_right { "start" } else { "end" };
            svg = svg.add(halo(label(value, x, y, size)).set("class", "label value halo").set("text-anchor", anchor));
        }
        svg
    }

    /// On each ambiguous face, the joined diagonal, dotted, through the saddle.
    fn hints(&self, mut svg: Group, stage: &Stage, layer: Layer) -> Group {
        for (cell, face, sign) in self.ambiguous_faces() {
            let origin = [0, 1, 2].map(|i| cell[i] + usize::from(i == face.axis() && face.side() == 1));
            if stage.layer(origin, &[face.axis()]) != layer {
                continue;
            }
            let joined = face.cycle().into_iter().filter(|c| self.corner_is(cell, *c, sign > 0));
            let mut ends = joined.map(|c| stage.place([0, 1, 2].map(|i| cell[i] as f64 + f64::from(c.position()[i]))));
            let (Some(p), Some(q), Some(s)) = (ends.next(), ends.next(), self.saddle(cell, face)) else { continue };
            let s = stage.place(s);
            svg = svg.add(
                Path::new()
                    .set("class", "joined")
                    .set("d", path(&[[p.x, p.y], [s.x, s.y], [q.x, q.y]], false))
                    .set("fill", "none")
                    .set("stroke", "#8a3fa0")
                    .set("stroke-width", 1.6)
                    .set("stroke-linecap", "round")
                    .set("stroke-dasharray", "0.1 5"),
            );
        }
        svg
    }

    fn corner_is(&self, cell: [usize; 3], corner: Corner, positive: bool) -> bool {
        let index = self.volume.as_ref().map(|volume| volume.corner_index(cell, corner));
        // A tie is outside: the decisions are those of c − ε.
        index.and_then(|i| self.sign(i)).is_some_and(|sign| (sign != Sign::Negative) == positive)
    }

    /// The saddle of the bilinear function on a face, rounded.
    fn saddle(&self, cell: [usize; 3], face: Face) -> Option<[f64; 3]> {
        let volume = self.volume.as_ref()?;
        let [p, q, r, s] = face.cycle();
        let [g00, g10, g11, g01] = [p, q, r, s].map(|c| volume.sample(volume.corner_index(cell, c)).to_f64());
        let mixed = g00 + g11 - g10 - g01;
        let (along_q, along_s) = ((g00 - g01) / mixed, (g00 - g10) / mixed);
        let at = |c: Corner| c.position().map(f64::from);
        let (p, q, s) = (at(p), at(q), at(s));
        let point = [0, 1, 2].map(|i| cell[i] as f64 + p[i] + along_q * (q[i] - p[i]) + along_s * (s[i] - p[i]));
        point.iter().all(|x| x.is_finite()).then_some(point)
    }
}

/// A number in at most eight characters: as it is, or rounded with a sign that says so.
fn short(value: &str) -> String {
    let typographic = |text: &str| text.replace('-', "−");
    match text::parse(value) {
        _ if value.chars().count() <= 7 => typographic(value),
        Ok(x) => {
            let x = x.to_f64();
            let is_plain = (1e-3..1e5).contains(&x.abs());
            typographic(&if is_plain { format!("≈{x:.3}") } else { format!("≈{x:.1e}") })
        }
        Err(_) => value.chars().take(7).chain(['…']).collect(),
    }
}

fn disc(p: Seen, radius: f64) -> Circle {
    Circle::new().set("cx", rounded(p.x)).set("cy", rounded(p.y)).set("r", radius)
}

fn segment(p: Seen, q: Seen) -> Line {
    Line::new().set("x1", rounded(p.x)).set("y1", rounded(p.y)).set("x2", rounded(q.x)).set("y2", rounded(q.y))
}

fn label(content: &str, x: f64, y: f64, size: f64) -> Text {
    Text::new(content)
        .set("x", rounded(x))
        .set("y", rounded(y))
        .set("font-size", size)
        .set("font-family", "ui-sans-serif, system-ui, sans-serif")
        .set("text-anchor", "middle")
        .set("fill", "#1d2433")
}

/// A text that stays readable over lines.
fn halo(text: Text) -> Text {
    text.set("stroke", "#ffffff").set("stroke-width", 3).set("stroke-linejoin", "round").set("paint-order", "stroke")
}

/// A path through points.
pub(super) fn path(points: &[[f64; 2]], is_closed: bool) -> String {
    let mut d = String::new();
    for (i, [x, y]) in points.iter().enumerate() {
        d += &format!("{}{} {}", if i == 0 { "M" } else { "L" }, rounded(*x), rounded(*y));
    }
    if is_closed {
        d.push('z');
    }
    d
}
