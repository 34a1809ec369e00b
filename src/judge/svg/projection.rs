//! The fixed axonometric views, and what is in front of what.

/// A view: an orthonormal frame, right-handed, z of the object upright in the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    right: [f64; 3],
    up: [f64; 3],
    toward: [f64; 3],
}

/// From x > 0, y < 0, z > 0: 26° to the side and 10° from above. The eight corners of a cube stay apart, and no triangle
/// that cuts off a corner or an edge evenly is seen from its side.
pub(super) const CELL: View = View {
    right: [0.898_794_046, 0.438_371_147, 0.0],
    up: [-0.076_122_351, 0.156_073_948, 0.984_807_753],
    toward: [0.431_711_304, -0.885_139_345, 0.173_648_178],
};

/// From x > 0, y > 0, z > 0: 150° to the side and 22° from above. A head whose y axis points forward shows its face.
pub(super) const MODEL: View = View {
    right: [-0.866_025_4, 0.5, 0.0],
    up: [-0.187_303_3, -0.324_418_8, 0.927_183_9],
    toward: [0.463_591_9, 0.802_964_8, 0.374_606_6],
};

/// A point of the picture, y upward, and its distance toward the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) depth: f64,
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl View {
    pub(super) fn project(&self, p: [f64; 3]) -> Seen {
        Seen { x: dot(self.right, p), y: dot(self.up, p), depth: dot(self.toward, p) }
    }

    /// Whether the side of a box with outward normal ±e(axis) faces the viewer.
    pub(super) fn faces_viewer(&self, axis: usize, outward: f64) -> bool {
        self.toward[axis] * outward > 0.0
    }
}

/// A triangle as seen: which side, how bright from 0 to 1; `None` for one without area.
pub(super) fn lighting([a, b, c]: [Seen; 3]) -> Option<(Facing, f64)> {
    // The normal in the view's frame; its third coordinate is toward the viewer.
    let (u, v) = ([b.x - a.x, b.y - a.y, b.depth - a.depth], [c.x - a.x, c.y - a.y, c.depth - a.depth]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = dot(n, n).sqrt();
    if length.is_nan() || length <= 1e-12 {
        return None;
    }
    let (facing, towards) = if n[2] >= 0.0 { (Facing::Front, 1.0) } else { (Facing::Back, -1.0) };
    // A light from the upper left, behind the viewer's shoulder.
    const LIGHT: [f64; 3] = [-0.408_25, 0.510_31, 0.756_88];
    let cosine = towards * dot(n, LIGHT) / length;
    Some((facing, 0.5 + 0.5 * cosine))
}

/// Which side of an oriented triangle the viewer sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Facing {
    /// The side that its normal points to, f > c.
    Front,
    /// The other one.
    Back,
}

impl Facing {
    /// The tint of this side: blue for the front and ochre for the back, darker in the shade.
    pub(super) fn tint(self, brightness: f64) -> String {
        let (dark, light) = match self {
            Facing::Front => ([38.0, 82.0, 128.0], [142.0, 192.0, 226.0]),
            Facing::Back => ([146.0, 84.0, 22.0], [240.0, 192.0, 118.0]),
        };
        let [r, g, b] = [0, 1, 2].map(|i: usize| {
            let mixed: f64 = dark[i] + (light[i] - dark[i]) * brightness.clamp(0.0, 1.0);
            mixed.round() as u8
        });
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}
