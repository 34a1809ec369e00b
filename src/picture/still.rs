//! The still picture, as SVG.

use super::scene::{Scene, colour, dot, minus, normal, outward};
use std::fmt::Write as _;
use svg::Document;
use svg::node::element::{Circle, Group, Line, Polygon, Rectangle, Style, Text};

/// The size of the picture, and of the part of it that the complex may fill.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 780.0;
const RADIUS: f64 = 360.0;
const CENTRE: [f64; 2] = [500.0, 390.0];

/// The view: to the right, upward, toward the viewer; 32° to the side and 21° from above.
const VIEW: [[f64; 3]; 3] =
    [[0.848_048, 0.0, -0.529_919], [-0.189_907, 0.933_580, -0.303_914], [0.494_722, 0.358_368, 0.791_726]];

/// From the upper left, behind the viewer's shoulder.
const LIGHT: [f64; 3] = [-0.408_25, 0.510_31, 0.756_88];

/// The viewer's distance, in radii of the complex.
const EYE: f64 = 4.0;

const STYLE: &str = ".paper{fill:#fbfaf6}.ink{fill:#1d2433}.soft{fill:#596072}.line{stroke:#1d2433}.knot{fill:#1d2433}\
text{font-family:ui-sans-serif,system-ui,\"Segoe UI\",\"Helvetica Neue\",Arial,sans-serif}\
@media(prefers-color-scheme:dark){.paper{fill:#14171d}.ink{fill:#e6e4dd}.soft{fill:#a0a6b4}.line{stroke:#f4f1e8}.knot{fill:#f4f1e8}}";

/// The scene from a fixed view, what is farther drawn first and fainter.
pub fn still(scene: &Scene) -> String {
    let mut drawn = Vec::new();
    for i in 0..scene.tetrahedra.len() {
        let corners = scene.corners(i).map(seen);
        let depth = corners.iter().map(|p| p[2]).sum::<f64>() / 4.0;
        let mut group = Group::new();
        for triangle in outward(corners) {
            group = facet(triangle, scene.groups[i]).into_iter().fold(group, Group::add);
        }
        drawn.push((depth, group.set("opacity", short(fog(depth)))));
    }
    for [v, w] in &scene.lines {
        let [a, b] = [*v, *w].map(|v| seen(scene.positions[v as usize]));
        let depth = f64::midpoint(a[2], b[2]);
        let ([x1, y1], [x2, y2]) = (place(a), place(b));
        let line = Line::new().set("x1", short(x1)).set("y1", short(y1)).set("x2", short(x2)).set("y2", short(y2));
        let line = line.set("class", "line").set("stroke-width", short(2.2 * scale(a))).set("stroke-linecap", "round");
        drawn.push((depth, Group::new().set("opacity", short(fog(depth))).add(line)));
    }
    drawn.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let body = drawn.into_iter().fold(Group::new().set("stroke-linejoin", "round"), |body, (_, item)| body.add(item));
    let document = Document::new()
        .set("viewBox", (0, 0, WIDTH, HEIGHT))
        .set("role", "img")
        .set("aria-label", format!("{}, drawn in space", scene.title))
        .add(Style::new(STYLE))
        .add(Rectangle::new().set("class", "paper").set("width", WIDTH).set("height", HEIGHT))
        .add(body);
    words(document, scene).to_string()
}

fn words(mut document: Document, scene: &Scene) -> Document {
    let text = |x: f64, y: f64, size: u32, class: &str, words: &str| {
        Text::new(words).set("x", x).set("y", y).set("font-size", size).set("class", class)
    };
    document = document.add(text(28.0, 44.0, 24, "ink", &scene.title).set("font-weight", 600));
    for (i, (group, name)) in scene.legend().into_iter().enumerate() {
        let y = 74.0 + 22.0 * i as f64;
        let dot = Circle::new().set("cx", 35).set("cy", y - 4.5).set("r", 6).set("fill", hex(colour(group), 1.0));
        document = document.add(dot).add(text(50.0, y, 14, "soft", name));
    }
    let (last, others) = scene.facts.split_last().expect("there are facts");
    // Counts on one line, what was measured on the next.
    let mut lines = [String::new(), String::new()];
    for (name, value) in others {
        let is_count = value.chars().all(|c| c.is_ascii_digit() || c == '\u{202f}');
        let line = &mut lines[usize::from(!is_count)];
        let separator = if line.is_empty() { "" } else { " · " };
        let fact = if is_count { format!("{value} {name}") } else { format!("{name} {value}") };
        write!(line, "{separator}{fact}").expect("a text can be written to");
    }
    for (i, line) in lines.iter().enumerate() {
        document = document.add(text(28.0, HEIGHT - 66.0 + 22.0 * i as f64, 14, "soft", line));
    }
    document.add(text(28.0, HEIGHT - 22.0, 14, "ink", &format!("{} {}", last.0, last.1)))
}

/// A triangle that faces the viewer.
fn facet(triangle: [[f64; 3]; 3], group: u32) -> Option<Polygon> {
    let normal = normal(triangle)?;
    if dot(normal, minus([0.0, 0.0, EYE], triangle[0])) <= 0.0 {
        return None;
    }
    let brightness = 0.62 + 0.48 * dot(normal, LIGHT);
    let points = triangle.map(|p| place(p).map(short).join(",")).join(" ");
    let fill = hex(colour(group), brightness);
    let edge = hex(colour(group), 0.62 * brightness);
    Some(Polygon::new().set("points", points).set("fill", fill).set("stroke", edge).set("stroke-width", 0.6))
}

/// A point in the frame of the view.
fn seen(p: [f64; 3]) -> [f64; 3] {
    VIEW.map(|axis| dot(axis, p))
}

/// How large things are at a point of the frame.
fn scale(p: [f64; 3]) -> f64 {
    EYE / (EYE - p[2])
}

fn place(p: [f64; 3]) -> [f64; 2] {
    [CENTRE[0] + RADIUS * p[0] * scale(p), CENTRE[1] - RADIUS * p[1] * scale(p)]
}

/// How much of a thing is seen through the air.
fn fog(depth: f64) -> f64 {
    (0.72 + 0.3 * depth).clamp(0.3, 1.0)
}

fn short(x: f64) -> String {
    format!("{x:.1}")
}

/// A colour in light of that brightness; beyond 1 it turns white.
fn hex(colour: [u8; 3], brightness: f64) -> String {
    let channel = |c: u8| {
        let c = f64::from(c);
        let lit =
            if brightness <= 1.0 { c * brightness.max(0.0) } else { c + (255.0 - c) * (brightness - 1.0).min(1.0) };
        lit.round() as u8
    };
    let [r, g, b] = colour.map(channel);
    format!("#{r:02x}{g:02x}{b:02x}")
}
