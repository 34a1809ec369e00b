//! A large surface as one compact picture.

use super::projection::{Facing, MODEL, Seen, lighting};
use super::{Picture, canvas};
use crate::judge::report::grouped;
use ::svg::node::element::{Group, Path};
use std::collections::{BTreeMap, HashMap};

/// Beyond so many triangles the surface is drawn coarser.
const MOST_TRIANGLES: usize = 90_000;

/// How many steps of brightness, of distance, and how many units to a pixel.
const SHADES: usize = 14;
const SLICES: usize = 60;
const UNITS: f64 = 4.0;

/// A surface, flat-shaded, seen from x > 0, y > 0, z > 0, `size` pixels in its longer direction.
///
/// Only triangles that some pixel shows are in the picture, so that 60,000 take less than a megabyte and a
/// half. The front, the side that the normals point to, is blue, the back ochre. A mesh of more than 90,000
/// triangles is drawn with its vertices merged on a coarser grid, and the description says so. Faces with
/// a vertex that is not there or not finite are left out.
pub fn surface_picture(vertices: &[[f64; 3]], faces: &[[u32; 3]], size: u32) -> Picture {
    let corner = |v: u32| vertices.get(v as usize).copied().filter(|p| p.iter().all(|x| x.is_finite()));
    let there: Vec<[[f64; 3]; 3]> = faces
        .iter()
        .filter_map(|f| f.iter().map(|v| corner(*v)).collect::<Option<Vec<_>>>()?.try_into().ok())
        .collect();
    let (triangles, pitch) = coarsened(there);
    let mut description = format!("A surface of {} triangles, flat-shaded.", grouped(faces.len()));
    if let Some(pitch) = pitch {
        let drawn = grouped(triangles.len());
        description += &format!(" Drawn coarser, as {drawn} triangles: vertices merged on a grid of pitch {pitch:.3}.");
    }
    let projected: Vec<[Seen; 3]> = triangles.iter().map(|t| t.map(|p| MODEL.project(p))).collect();
    let all = || projected.iter().flatten();
    let bound =
        |f: fn(&Seen) -> f64| all().map(f).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let ((min_x, max_x), (min_y, max_y)) = (bound(|p| p.x), bound(|p| p.y));
    let (min_depth, max_depth) = bound(|p| p.depth);
    let longer = (max_x - min_x).max(max_y - min_y);
    if longer.is_nan() || longer <= 0.0 {
        let side = f64::from(size);
        return Picture(canvas(side, side, "A surface", "No triangle of it can be drawn.").to_string());
    }
    const MARGIN: f64 = 2.0;
    let scale = (f64::from(size) - 2.0 * MARGIN) / longer;
    let placed: Vec<[Seen; 3]> = projected
        .iter()
        .map(|t| {
            t.map(|p| Seen {
                x: MARGIN + (p.x - min_x) * scale,
                y: MARGIN + (max_y - p.y) * scale,
                depth: (p.depth - min_depth) / (max_depth - min_depth).max(f64::MIN_POSITIVE),
            })
        })
        .collect();
    let (width, height) = ((max_x - min_x) * scale + 2.0 * MARGIN, (max_y - min_y) * scale + 2.0 * MARGIN);

    // Slices of distance, the farthest first; within one, a path for each shade.
    let mut paths: BTreeMap<(usize, Facing, usize), String> = BTreeMap::new();
    for i in visible(&placed, width, height) {
        let Some((facing, brightness)) = lighting(projected[i]) else { continue };
        let depth = placed[i].iter().map(|p| p.depth).sum::<f64>() / 3.0;
        let step = |share: f64, steps: usize| ((share * steps as f64) as usize).min(steps - 1);
        let d = paths.entry((step(depth, SLICES), facing, step(brightness, SHADES))).or_default();
        outline(d, &placed[i]);
    }
    // A hair's stroke closes the gaps that smoothed borders would leave between triangles.
    let units = format!("scale({})", 1.0 / UNITS);
    let mut group =
        Group::new().set("transform", units).set("stroke-width", 0.7 * UNITS).set("stroke-linejoin", "round");
    for ((_, facing, shade), d) in paths {
        let tint = facing.tint((shade as f64 + 0.5) / SHADES as f64);
        group = group.add(Path::new().set("fill", tint.as_str()).set("stroke", tint.as_str()).set("d", d));
    }
    Picture(canvas(width, height, "A surface", &description).add(group).to_string())
}

/// A triangle in whole units, its first corner absolute, the others from it, as short as a path can be.
fn outline(d: &mut String, corners: &[Seen; 3]) {
    let [a, b, c] = corners.map(|p| [(p.x * UNITS).round() as i64, (p.y * UNITS).round() as i64]);
    let spaced = |n: i64| if n < 0 { n.to_string() } else { format!(" {n}") };
    *d += &format!("M{}{}l{}{}", a[0], spaced(a[1]), b[0] - a[0], spaced(b[1] - a[1]));
    *d += &format!("{}{}z", spaced(c[0] - b[0]), spaced(c[1] - b[1]));
}

/// The triangles that are nearest at the middle of some pixel, or of a quarter of one.
fn visible(placed: &[[Seen; 3]], width: f64, height: f64) -> Vec<usize> {
    const FINE: f64 = 2.0;
    let (columns, rows) = ((width * FINE).ceil() as usize + 1, (height * FINE).ceil() as usize + 1);
    let mut nearest = vec![(f64::NEG_INFINITY, usize::MAX); columns * rows];
    for (i, triangle) in placed.iter().enumerate() {
        let [a, b, c] = triangle.map(|p| Seen { x: p.x * FINE, y: p.y * FINE, ..p });
        let twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if twice == 0.0 {
            continue;
        }
        let range = |p: f64, q: f64, r: f64, end: usize| {
            let from = p.min(q).min(r).ceil().max(0.0) as usize;
            from..(p.max(q).max(r).floor() as usize + 1).min(end)
        };
        for y in range(a.y, b.y, c.y, rows) {
            for x in range(a.x, b.x, c.x, columns) {
                let (px, py) = (x as f64 - a.x, y as f64 - a.y);
                let v = (px * (c.y - a.y) - (c.x - a.x) * py) / twice;
                let w = ((b.x - a.x) * py - px * (b.y - a.y)) / twice;
                if v < 0.0 || w < 0.0 || v + w > 1.0 {
                    continue;
                }
                let depth = a.depth + v * (b.depth - a.depth) + w * (c.depth - a.depth);
                let pixel = &mut nearest[y * columns + x];
                if depth > pixel.0 {
                    *pixel = (depth, i);
                }
            }
        }
    }
    let mut seen: Vec<usize> = nearest.into_iter().map(|(_, i)| i).filter(|&i| i != usize::MAX).collect();
    seen.sort_unstable();
    seen.dedup();
    seen
}

/// The triangles with their vertices merged on a grid just coarse enough, and that grid's pitch; as they
/// are where they are few enough.
fn coarsened(triangles: Vec<[[f64; 3]; 3]>) -> (Vec<[[f64; 3]; 3]>, Option<f64>) {
    if triangles.len() <= MOST_TRIANGLES {
        return (triangles, None);
    }
    let (least, most) = triangles
        .iter()
        .flatten()
        .flatten()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
    let mut pitch = (most - least) / 400.0;
    loop {
        let merged = merged(&triangles, pitch);
        if merged.len() <= MOST_TRIANGLES {
            return (merged, Some(pitch));
        }
        pitch *= 1.25;
    }
}

fn merged(triangles: &[[[f64; 3]; 3]], pitch: f64) -> Vec<[[f64; 3]; 3]> {
    let place = |p: &[f64; 3]| p.map(|x| (x / pitch).floor() as i64);
    // Each place of the grid is drawn at the mean of the vertices in it.
    let mut means: HashMap<[i64; 3], ([f64; 3], f64)> = HashMap::new();
    for p in triangles.iter().flatten() {
        let (sum, count) = means.entry(place(p)).or_insert(([0.0; 3], 0.0));
        (0..3).for_each(|i| sum[i] += p[i]);
        *count += 1.0;
    }
    let mean = |at: &[i64; 3]| {
        let (sum, count) = means[at];
        sum.map(|x| x / count)
    };
    let placed = triangles.iter().map(|t| [place(&t[0]), place(&t[1]), place(&t[2])]);
    placed.filter(|[a, b, c]| a != b && b != c && c != a).map(|t| [mean(&t[0]), mean(&t[1]), mean(&t[2])]).collect()
}
