//! The triangles of a small surface: two-sided, translucent, their edges drawn by what they are.

use super::cell::{path, upward};
use super::painter;
use super::projection::{Facing, Seen, lighting};
use super::rounded;
use crate::judge::report::SurfaceRecord;
use ::svg::node::element::{Group, Path};
use std::collections::BTreeMap;

/// A triangle as it is drawn.
pub(super) struct Drawn {
    corners: [Seen; 3],
    facing: Facing,
    brightness: f64,
    /// The edges that are not just between two triangles inside a cell.
    edges: Vec<([Seen; 2], Kind)>,
}

/// What an edge of a surface is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// It lies in a face of a cell, as every edge of a cell's loops does.
    Loop,
    /// It ends the surface inside the grid, or has more than two triangles.
    Flaw,
}

/// Positions closer than this are the same, and on the same face of a cell.
const NEAR: f64 = 1e-6;

/// The triangles in the painter's order, and how many could not be drawn.
pub(super) fn triangles(
    surface: &SurfaceRecord,
    cells: [usize; 3],
    place: impl Fn([f64; 3]) -> Seen,
) -> (Vec<Drawn>, usize) {
    let is_near = |p: &[f64; 3]| (0..3).all(|i| (-1.0..=cells[i] as f64 + 1.0).contains(&p[i]));
    let corner = |v: u32| surface.vertices.get(v as usize).copied().filter(is_near);
    let there: Vec<[[f64; 3]; 3]> = surface.faces.iter().filter_map(|f| corners(f.map(corner))).collect();
    let mut uses: BTreeMap<[[i64; 3]; 2], usize> = BTreeMap::new();
    for triangle in &there {
        for edge in sides(triangle) {
            *uses.entry(key(edge)).or_default() += 1;
        }
    }
    let kind = |edge: [[f64; 3]; 2]| {
        let on = |plane: fn(f64, usize) -> bool| {
            (0..3).any(|i| (edge[0][i] - edge[1][i]).abs() < NEAR && plane(edge[0][i], cells[i]))
        };
        let is_on_face = on(|x, _| (x - x.round()).abs() < NEAR);
        let is_on_border = on(|x, n| x.abs() < NEAR || (x - n as f64).abs() < NEAR);
        match uses.get(&key(edge)) {
            Some(1) if is_on_border => Some(Kind::Loop),
            Some(2) if is_on_face => Some(Kind::Loop),
            Some(2) => None,
            Some(_) | None => Some(Kind::Flaw),
        }
    };
    let mut drawn = Vec::new();
    for triangle in &there {
        let corners = triangle.map(&place);
        let Some((facing, brightness)) = lighting(corners.map(upward)) else { continue };
        let edges = sides(triangle).into_iter().filter_map(|e| Some((e.map(&place), kind(e)?))).collect();
        drawn.push(Drawn { corners, facing, brightness, edges });
    }
    let left_out = surface.faces.len() - there.len();
    let order = painter::order(&drawn.iter().map(|t| t.corners).collect::<Vec<_>>());
    let mut waiting: Vec<Option<Drawn>> = drawn.into_iter().map(Some).collect();
    (order.into_iter().filter_map(|i| waiting[i].take()).collect(), left_out)
}

fn corners([a, b, c]: [Option<[f64; 3]>; 3]) -> Option<[[f64; 3]; 3]> {
    Some([a?, b?, c?])
}

fn sides(&[a, b, c]: &[[f64; 3]; 3]) -> [[[f64; 3]; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// An edge by where it is, so that a surface whose triangles share no vertices is seen as what it looks like.
fn key(edge: [[f64; 3]; 2]) -> [[i64; 3]; 2] {
    let [p, q] = edge.map(|p| p.map(|x| (x / NEAR).round() as i64));
    [p.min(q), p.max(q)]
}

/// The triangles over one another, each with its edges.
pub(super) fn draw(mut svg: Group, triangles: &[Drawn]) -> Group {
    for triangle in triangles {
        let (class, outline) = match triangle.facing {
            Facing::Front => ("front", "#1f4e79"),
            Facing::Back => ("back", "#8a4b0f"),
        };
        svg = svg.add(
            Path::new()
                .set("class", class)
                .set("d", path(&triangle.corners.map(|p| [p.x, p.y]), true))
                .set("fill", triangle.facing.tint(triangle.brightness))
                .set("fill-opacity", 0.8)
                .set("stroke", outline)
                .set("stroke-opacity", 0.55)
                .set("stroke-width", 0.8)
                .set("stroke-linejoin", "round"),
        );
        if triangle.facing == Facing::Back {
            let hatching = Path::new().set("class", "hatching").set("d", hatching(&triangle.corners));
            svg = svg.add(hatching.set("stroke", "#6b3706").set("stroke-opacity", 0.5).set("stroke-width", 0.9));
        }
        for ([p, q], kind) in &triangle.edges {
            let edge = Path::new().set("d", path(&[[p.x, p.y], [q.x, q.y]], false)).set("stroke-linecap", "round");
            svg = svg.add(match kind {
                Kind::Loop => edge.set("class", format!("{class}-loop")).set("stroke", outline).set("stroke-width", 3),
                Kind::Flaw => edge
                    .set("class", "flaw")
                    .set("stroke", "#c8102e")
                    .set("stroke-width", 3.2)
                    .set("stroke-dasharray", "5 5"),
            });
        }
    }
    svg
}

/// Parallel lines, falling to the left, over a triangle; the same lines for all triangles of a picture.
fn hatching(triangle: &[Seen; 3]) -> String {
    const APART: f64 = 8.0;
    let height = |p: &Seen| p.x + p.y;
    let (low, high) = triangle
        .iter()
        .map(height)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    let mut d = String::new();
    let mut level = (low / APART).ceil() * APART;
    while level < high {
        let ends: Vec<[f64; 2]> = (0..3)
            .filter_map(|i| {
                let (p, q) = (&triangle[i], &triangle[(i + 1) % 3]);
                let t = (level - height(p)) / (height(q) - height(p));
                (0.0..1.0).contains(&t).then(|| [p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)])
            })
            .collect();
        if let [[x1, y1], [x2, y2], ..] = ends[..] {
            d += &format!("M{} {}L{} {}", rounded(x1), rounded(y1), rounded(x2), rounded(y2));
        }
        level += APART;
    }
    d
}
