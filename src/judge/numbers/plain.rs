//! The text's formulas in plain binary64: what a good implementation without exact numbers does.

/// f, ∇f and the Hessian of a function of N variables at a point.
#[derive(Clone, Copy, Debug)]
pub struct Jet<const N: usize> {
    pub value: f64,
    pub gradient: [f64; N],
    pub hessian: [[f64; N]; N],
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).map(|i| a[i] * b[i]).sum()
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn apply<const N: usize>(a: &[[f64; N]; N], x: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| dot(&a[i], x))
}

/// The jet of a polynomial, term by term.
pub fn polynomial<const N: usize>(terms: &[(f64, [i32; N])], at: &[f64; N]) -> Jet<N> {
    // The derivative of xⁿ of that order.
    let power = |axis: usize, n: i32, order: i32| -> f64 {
        let factor: f64 = (0..order).map(|i| f64::from(n - i)).product();
        if factor == 0.0 { 0.0 } else { (0..n - order).fold(factor, |power, _| power * at[axis]) }
    };
    let derivative = |axes: &[usize]| -> f64 {
        let order = |axis: usize| i32::try_from(axes.iter().filter(|a| **a == axis).count()).expect("at most two");
        let term = |(c, n): &(f64, [i32; N])| (0..N).fold(*c, |t, axis| t * power(axis, n[axis], order(axis)));
        terms.iter().map(term).sum()
    };
    Jet {
        value: derivative(&[]),
        gradient: std::array::from_fn(|i| derivative(&[i])),
        hessian: std::array::from_fn(|i| std::array::from_fn(|j| derivative(&[i, j]))),
    }
}

/// The jet of n/d: from n = qd, differentiated once and twice.
pub fn quotient<const N: usize>(n: &Jet<N>, d: &Jet<N>) -> Jet<N> {
    let q = n.value / d.value;
    let dq: [f64; N] = std::array::from_fn(|i| (n.gradient[i] - q * d.gradient[i]) / d.value);
    let second = |i: usize, j: usize| {
        (n.hessian[i][j] - dq[i] * d.gradient[j] - dq[j] * d.gradient[i] - q * d.hessian[i][j]) / d.value
    };
    Jet { value: q, gradient: dq, hessian: std::array::from_fn(|i| std::array::from_fn(|j| second(i, j))) }
}

/// f_xx f_y² − 2 f_xy f_x f_y + f_yy f_x² = −κ|∇f|³. CU-2.
pub fn kappa_numerator(Jet { gradient: [fx, fy], hessian: [[fxx, fxy], [_, fyy]], .. }: &Jet<2>) -> f64 {
    fxx * fy * fy - 2.0 * fxy * fx * fy + fyy * fx * fx
}

/// The same as 002 (5) prints it: f_xx f_x² − 2 f_xy f_x f_y + f_yy f_y².
pub fn printed_kappa_numerator(Jet { gradient: [fx, fy], hessian: [[fxx, fxy], [_, fyy]], .. }: &Jet<2>) -> f64 {
    fxx * fx * fx - 2.0 * fxy * fx * fy + fyy * fy * fy
}

/// |∇f|².
pub fn norm_squared<const N: usize>(v: &[f64; N]) -> f64 {
    dot(v, v)
}

/// K = ∇fᵀ adj(Hess f) ∇f/|∇f|⁴. CU-3.
pub fn gaussian(Jet { gradient: g, hessian: h, .. }: &Jet<3>) -> f64 {
    // The rows of the adjugate of a symmetric matrix are the cross products of its rows.
    let adjugate = [cross(&h[1], &h[2]), cross(&h[2], &h[0]), cross(&h[0], &h[1])];
    let w = dot(g, g);
    dot(g, &apply(&adjugate, g)) / (w * w)
}

/// |∇f|² tr(Hess f) − ∇fᵀ Hess f ∇f = −2H|∇f|³. CU-3.
pub fn mean_numerator(Jet { gradient: g, hessian: h, .. }: &Jet<3>) -> f64 {
    dot(g, g) * (h[0][0] + h[1][1] + h[2][2]) - dot(g, &apply(h, g))
}

/// (H, (k₁ − k₂)/2) from the second fundamental form in an orthonormal basis, so that nothing cancels where k₁ is near k₂.
pub fn mean_and_spread([[a, b], [_, c]]: [[f64; 2]; 2]) -> (f64, f64) {
    ((a + c) / 2.0, ((a - c) / 2.0).hypot(b))
}

/// −dN in an orthonormal basis of the tangent plane of a level surface: −⟨tᵢ, Hess f tⱼ⟩/|∇f|.
pub fn shape_operator(Jet { gradient: g, hessian: h, .. }: &Jet<3>) -> [[f64; 2]; 2] {
    let length = dot(g, g).sqrt();
    let normal = g.map(|x| x / length);
    let axis = (0..3).min_by(|i, j| normal[*i].abs().total_cmp(&normal[*j].abs())).expect("there are three");
    let first = cross(&normal, &std::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 }));
    let size = dot(&first, &first).sqrt();
    let first = first.map(|x| x / size);
    let basis = [first, cross(&normal, &first)];
    std::array::from_fn(|i| std::array::from_fn(|j| -dot(&basis[i], &apply(h, &basis[j])) / length))
}

/// −dN in the orthonormal basis that Gram and Schmidt make of σᵤ, σᵥ, from E, F, G and We, Wf, Wg.
pub fn shape_of_forms([e1, f1, _]: [f64; 3], [we, wf, wg]: [f64; 3], w: f64) -> [[f64; 2]; 2] {
    let off = (wf * e1 - we * f1) / (e1 * w * w);
    let last = ((wg * e1 - wf * f1) * e1 - (wf * e1 - we * f1) * f1) / (e1 * w * w * w);
    [[we / (e1 * w), off], [off, last]]
}

/// k₁, k₂ as 002 4(b) prints them, (tr dN ± √(2|dN|² − (tr dN)²))/2, from the Frobenius norm of −P·Hess f/|∇f|, which is symmetric
/// only by chance.
pub fn printed_frobenius(Jet { gradient: g, hessian: h, .. }: &Jet<3>) -> [f64; 2] {
    let w = dot(g, g);
    let entry = |i: usize, j: usize| -(h[i][j] - g[i] * dot(g, &h.map(|row| row[j])) / w) / w.sqrt();
    let dn: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let trace = dn[0][0] + dn[1][1] + dn[2][2];
    let norm_squared: f64 = dn.iter().map(|row| dot(row, row)).sum();
    let root = (2.0 * norm_squared - trace * trace).sqrt();
    [(trace + root) / 2.0, (trace - root) / 2.0]
}

/// K and H as 002 3(d) prints them, with determinants over f_z: K = (det A₁ det A₃ − det A₂²)/(f_z²|∇f|⁴), and H of the normal +∇f/|∇f|,
/// against the sign of the expanded form that follows it. Where f_z = 0 they are no numbers.
pub fn printed_determinants(Jet { gradient: [fx, fy, fz], hessian: h, .. }: &Jet<3>) -> (f64, f64) {
    // The determinant of (a b p; c d fz; q fz 0).
    let bordered = |a: f64, b: f64, p: f64, c: f64, q: f64| {
        let d = h[2][2];
        a * (-fz * fz) - b * (-fz * q) + p * (c * fz - d * q)
    };
    let a1 = bordered(h[0][0], h[0][2], *fx, h[0][2], *fx);
    let a2 = bordered(h[0][1], h[1][2], *fy, h[0][2], *fx);
    let a3 = bordered(h[1][1], h[1][2], *fy, h[1][2], *fy);
    let w = fx * fx + fy * fy + fz * fz;
    let k = (a1 * a3 - a2 * a2) / (fz * fz * w * w);
    let sum = a1 * (1.0 + fy * fy / (fz * fz)) - 2.0 * a2 * (fx * fy / (fz * fz)) + a3 * (1.0 + fx * fx / (fz * fz));
    (k, sum / (2.0 * w * w.sqrt()))
}

/// n_λ(x). CU-7.
pub fn normalize(slope: f64, x: f64) -> f64 {
    if x < 0.0 { (slope * x).exp() / 2.0 } else { 1.0 - (-slope * x).exp() / 2.0 }
}

/// z = −2 + √3 = −1/(2 + √3), of which the second form cancels nothing.
fn pole() -> f64 {
    -1.0 / (2.0 + 3_f64.sqrt())
}

/// The coefficients of a line of samples, by a causal and an anticausal recursion with the pole z, each begun where the boundary rule
/// says. SP-2.
pub fn prefilter(g: &[f64], is_mirror: bool) -> Vec<f64> {
    let (n, z) = (g.len(), pole());
    let mut c: Vec<f64> = g.iter().map(|g| 6.0 * g).collect();
    // zᵏ, k = 0, …, 2n
    let powers: Vec<f64> = std::iter::successors(Some(1.0), |p| Some(p * z)).take(2 * n + 1).collect();
    if is_mirror {
        let period = 2 * n - 2;
        let sum: f64 = (0..period).map(|k| powers[k] * c[if k < n { k } else { period - k }]).sum();
        c[0] = sum / (1.0 - powers[period]);
    } else {
        let sum: f64 = (0..n).map(|k| powers[k] * c[(n - k) % n]).sum();
        c[0] = sum / (1.0 - powers[n]);
    }
    for k in 1..n {
        c[k] += z * c[k - 1];
    }
    if is_mirror {
        c[n - 1] = z / (z * z - 1.0) * (c[n - 1] + z * c[n - 2]);
    } else {
        let sum: f64 = (0..n).map(|k| powers[k + 1] * c[(n - 1 + k) % n]).sum();
        c[n - 1] = -sum / (1.0 - powers[n]);
    }
    for k in (0..n - 1).rev() {
        c[k] = z * (c[k + 1] - c[k]);
    }
    c
}

/// B₃⁽ⁿ⁾ of the four B-splines that are not 0 at i + t. SP-1.
fn weights(t: f64, n: usize) -> [f64; 4] {
    let s = 1.0 - t;
    match n {
        0 => {
            [s * s * s / 6.0, 2.0 / 3.0 - t * t * (1.0 - t / 2.0), 2.0 / 3.0 - s * s * (1.0 - s / 2.0), t * t * t / 6.0]
        }
        1 => [-s * s / 2.0, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), t * t / 2.0],
        _ => [s, 3.0 * t - 2.0, 3.0 * s - 2.0, t],
    }
}

/// A spline of up to three axes.
pub struct Spline {
    pub shape: Vec<usize>,
    pub is_mirror: bool,
    pub coefficients: Vec<f64>,
}

impl Spline {
    /// The one that takes these values. SP-2.
    pub fn interpolate(shape: Vec<usize>, values: Vec<f64>, is_mirror: bool) -> Spline {
        let (mut coefficients, mut stride) = (values, 1);
        for &n in &shape {
            for first in (0..coefficients.len()).filter(|i| i / stride % n == 0) {
                let line: Vec<f64> = (0..n).map(|k| coefficients[first + k * stride]).collect();
                for (k, c) in prefilter(&line, is_mirror).into_iter().enumerate() {
                    coefficients[first + k * stride] = c;
                }
            }
            stride *= n;
        }
        Spline { shape, is_mirror, coefficients }
    }

    /// The derivative with these orders at a point. SP-3.
    pub fn derivative(&self, at: &[f64], orders: &[usize]) -> f64 {
        let axes = self.shape.len();
        let weights: Vec<[f64; 4]> = (0..axes).map(|a| weights(at[a] - at[a].floor(), orders[a])).collect();
        let terms = (0..1_usize << (2 * axes)).map(|m| {
            let (mut index, mut weight, mut stride) = (0, 1.0, 1);
            for axis in 0..axes {
                let i = m >> (2 * axis) & 3;
                index += stride * self.fold(at[axis].floor() as i64 + i as i64 - 1, axis);
                weight *= weights[axis][i];
                stride *= self.shape[axis];
            }
            weight * self.coefficients[index]
        });
        terms.sum()
    }

    fn fold(&self, k: i64, axis: usize) -> usize {
        let n = self.shape[axis];
        let period = if self.is_mirror { 2 * n - 2 } else { n };
        let k = k.rem_euclid(period as i64) as usize;
        if k < n { k } else { period - k }
    }

    /// f, ∇f and the Hessian at a point.
    pub fn jet<const N: usize>(&self, at: &[f64]) -> Jet<N> {
        let along = |axes: &[usize]| {
            let orders: Vec<usize> = (0..N).map(|a| axes.iter().filter(|axis| **axis == a).count()).collect();
            self.derivative(at, &orders)
        };
        Jet {
            value: along(&[]),
            gradient: std::array::from_fn(|i| along(&[i])),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| along(&[i, j]))),
        }
    }
}

/// c\[k] = Σ √3 z^|k−j| g\[j]. SP-4.
pub fn bounded_coefficient(samples: &[(i64, f64)], k: i64) -> f64 {
    let power = |n: u64| (0..n).fold(1.0, |power, _| power * pole());
    samples.iter().map(|(j, g)| 3_f64.sqrt() * power(k.abs_diff(*j)) * g).sum()
}

/// The derivative of that order at x of the spline with these coefficients. SP-4.
pub fn bounded_derivative(samples: &[(i64, f64)], x: f64, order: usize) -> f64 {
    let first = x.floor() as i64 - 1;
    let weights = weights(x - x.floor(), order);
    (0..4).map(|m| weights[m] * bounded_coefficient(samples, first + m as i64)).sum()
}
