//! The painter's order of triangles: what is farther is drawn first.

use super::projection::Seen;

/// Beyond so many triangles the order is that of their middles: comparing all pairs would take too long.
const MOST_COMPARED: usize = 600;

/// An order in which to draw the triangles, farther ones first. Of two that overlap in the picture, the one
/// that is farther in the middle of their overlap is first; where that goes around in a circle, or
/// triangles cut one another, no order is right, and the farthest middle goes first.
pub(super) fn order(triangles: &[[Seen; 3]]) -> Vec<usize> {
    let middle = |i: usize| triangles[i].iter().map(|p| p.depth).sum::<f64>() / 3.0;
    let mut by_middle: Vec<usize> = (0..triangles.len()).collect();
    by_middle.sort_by(|&i, &j| middle(i).total_cmp(&middle(j)));
    if triangles.len() > MOST_COMPARED {
        return by_middle;
    }
    // behind[i]: how many triangles must come before i; before[i]: which must come after it.
    let mut behind = vec![0usize; triangles.len()];
    let mut before = vec![Vec::new(); triangles.len()];
    for i in 0..triangles.len() {
        for j in 0..i {
            match is_farther(&triangles[i], &triangles[j]) {
                None => {}
                Some(true) => {
                    before[i].push(j);
                    behind[j] += 1;
                }
                Some(false) => {
                    before[j].push(i);
                    behind[i] += 1;
                }
            }
        }
    }
    let mut order = Vec::with_capacity(triangles.len());
    while !by_middle.is_empty() {
        let free = by_middle.iter().position(|&i| behind[i] == 0).unwrap_or(0);
        let next = by_middle.remove(free);
        for &later in &before[next] {
            behind[later] = behind[later].saturating_sub(1);
        }
        order.push(next);
    }
    order
}

/// Whether a is farther than b in the middle of their overlap; `None` where they do not overlap, or meet there.
fn is_farther(a: &[Seen; 3], b: &[Seen; 3]) -> Option<bool> {
    let overlap = clip(a, b);
    if area(&overlap).abs() < 1e-6 {
        return None;
    }
    let n = overlap.len() as f64;
    let middle = overlap.iter().fold([0.0, 0.0], |[x, y], p| [x + p[0] / n, y + p[1] / n]);
    let difference = depth_at(a, middle)? - depth_at(b, middle)?;
    (difference.abs() > 1e-9).then_some(difference < 0.0)
}

/// The depth of a triangle's plane over a point of the picture.
fn depth_at([a, b, c]: &[Seen; 3], [x, y]: [f64; 2]) -> Option<f64> {
    let twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    let v = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / twice;
    let w = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / twice;
    Some(a.depth + v * (b.depth - a.depth) + w * (c.depth - a.depth)).filter(|depth| depth.is_finite())
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// The part of triangle a inside triangle b, in the picture.
fn clip(a: &[Seen; 3], b: &[Seen; 3]) -> Vec<[f64; 2]> {
    let mut part: Vec<[f64; 2]> = a.iter().map(|p| [p.x, p.y]).collect();
    let window = b.map(|p| [p.x, p.y]);
    let turn = area(&window).signum();
    for i in 0..3 {
        let ([px, py], [qx, qy]) = (window[i], window[(i + 1) % 3]);
        let inside = |[x, y]: [f64; 2]| turn * ((qx - px) * (y - py) - (qy - py) * (x - px));
        part = cut(&part, inside);
    }
    part
}

/// The part of a convex polygon where a linear function is not negative.
pub(super) fn cut(polygon: &[[f64; 2]], f: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (&p, &q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (fp, fq) = (f(p), f(q));
        if fp >= 0.0 {
            part.push(p);
        }
        if fp * fq < 0.0 {
            let t = fp / (fp - fq);
            part.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    part
}
