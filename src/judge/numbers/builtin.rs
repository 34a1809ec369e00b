//! Built-in candidates for the suites `spline` and `curvature`: the text's formulas in plain binary64, as corrected and as printed.

use super::plain::{self, Jet, Spline};
use crate::answer::message::{Kind, Out, Question, Refusal};
use crate::answer::value::{self, Object};
use crate::answer::{self};
use crate::curvature::implicit_curve::SingularPoint;
use crate::curvature::parametric_curve::CurveError;
use crate::curvature::parametric_surface::SurfaceError;
use crate::number::binary::nearest_f64;
use serde_json::{Value, json};

/// A built-in candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Formulas {
    /// As corrected.
    Corrected,
    /// κ of a level curve with the numerator of 002 (5).
    PrintedKappa,
    /// H with the sign of the expanded form of 002 3(d), which is that of the normal −∇f/|∇f|.
    PrintedMean,
    /// k₁, k₂ from the Frobenius norm of P·Hess f (002, after (16)).
    PrintedFrobenius,
    /// K and H from the determinants over f_z of 002 3(d).
    PrintedDeterminants,
}

impl Formulas {
    /// All of them.
    pub const ALL: [Formulas; 5] = [
        Formulas::Corrected,
        Formulas::PrintedKappa,
        Formulas::PrintedMean,
        Formulas::PrintedFrobenius,
        Formulas::PrintedDeterminants,
    ];

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Formulas::Corrected => "formulas",
            Formulas::PrintedKappa => "formulas-printed-kappa",
            Formulas::PrintedMean => "formulas-printed-mean",
            Formulas::PrintedFrobenius => "formulas-printed-frobenius",
            Formulas::PrintedDeterminants => "formulas-printed-determinants",
        }
    }

    /// What it answers.
    ///
    /// # Errors
    /// As the oracle where the question is ill-posed; `degenerate` where a gradient, a cross product or a denominator comes out as 0 in
    /// binary64.
    pub fn answer(self, question: &Question) -> Result<Out, Refusal> {
        let operation = question.op.as_str();
        if operation == "hello" {
            let ops: Vec<&str> = super::Family::Spline
                .operations()
                .iter()
                .chain(super::Family::Curvature.operations())
                .copied()
                .collect();
            let version = env!("CARGO_PKG_VERSION");
            return Ok(Out::new(&json!({"protocol": 1, "name": self.name(), "version": version, "ops": ops})));
        }
        let input = question.input()?;
        // Reading questions is not what is tried out here: the oracle says which are ill-posed.
        match answer::out(operation, input) {
            Err(refusal) if refusal.kind() != Some(Kind::Degenerate) => return Err(refusal),
            Ok(_) | Err(_) => {}
        }
        let out = match operation {
            "spline.coefficients" => json!({"coefficients": spline(input).coefficients}),
            "spline.evaluate" => evaluate(input),
            "spline.impulse" => impulse(input),
            "curvature.implicit_curve" => self.level_curve(&polynomial(&input["polynomial"], &input["point"]), None)?,
            "curvature.implicit_surface" => {
                self.level_surface(&polynomial(&input["polynomial"], &input["point"]), None)?
            }
            "curvature.parametric_curve" => parametric_curve(input)?,
            "curvature.parametric_surface" => parametric_surface(input)?,
            "curvature.spline" => self.spline_curvature(input)?,
            "curvature.normalize" => json!({"value": plain::normalize(real(&input["lambda"]), real(&input["x"]))}),
            other => return Err(Refusal::NoSuchOperation(other.chars().take(100).collect())),
        };
        Ok(Out::new(&out))
    }

    fn level_curve(self, jet: &Jet<2>, index: Option<usize>) -> Result<Value, Refusal> {
        let w = regular(&jet.gradient, index)?;
        let numerator = match self {
            Formulas::PrintedKappa => plain::printed_kappa_numerator(jet),
            Formulas::Corrected
            | Formulas::PrintedMean
            | Formulas::PrintedFrobenius
            | Formulas::PrintedDeterminants => plain::kappa_numerator(jet),
        };
        let kappa = -numerator / (w * w.sqrt());
        Ok(json!({
            "value": jet.value, "gradient": jet.gradient,
            "kappa_squared": kappa * kappa, "kappa_sign": sign(kappa),
        }))
    }

    fn level_surface(self, jet: &Jet<3>, index: Option<usize>) -> Result<Value, Refusal> {
        let w = regular(&jet.gradient, index)?;
        let (k, h) = match self {
            Formulas::PrintedDeterminants => plain::printed_determinants(jet),
            Formulas::Corrected | Formulas::PrintedKappa | Formulas::PrintedMean | Formulas::PrintedFrobenius => {
                (plain::gaussian(jet), -plain::mean_numerator(jet) / (2.0 * w * w.sqrt()))
            }
        };
        let h = if self == Formulas::PrintedMean { -h } else { h };
        let (mean, spread) = plain::mean_and_spread(plain::shape_operator(jet));
        let principal = match self {
            Formulas::PrintedFrobenius => plain::printed_frobenius(jet),
            Formulas::Corrected | Formulas::PrintedKappa | Formulas::PrintedMean | Formulas::PrintedDeterminants => {
                [mean + spread, mean - spread]
            }
        };
        Ok(json!({
            "value": jet.value, "gradient": jet.gradient, "hessian": jet.hessian,
            "gaussian": k, "mean_squared": h * h, "mean_sign": sign(h),
            "discriminant": spread * spread, "principal": principal,
        }))
    }

    fn spline_curvature(self, input: &Object) -> Result<Value, Refusal> {
        let spline = spline(input);
        let one = |(i, point): (usize, &Value)| {
            let at = reals(point);
            match spline.shape.len() {
                2 => self.level_curve(&spline.jet(&at), Some(i)),
                _ => self.level_surface(&spline.jet(&at), Some(i)),
            }
        };
        let points: Result<Vec<Value>, Refusal> = items(&input["points"]).iter().enumerate().map(one).collect();
        Ok(json!({"points": points?}))
    }
}

/// −1, 0 or 1.
fn sign(x: f64) -> i8 {
    i8::from(x > 0.0) - i8::from(x < 0.0)
}

/// |∇f|², not 0.
fn regular<const N: usize>(gradient: &[f64; N], index: Option<usize>) -> Result<f64, Refusal> {
    let w = plain::norm_squared(gradient);
    let field = if index.is_some() { "points" } else { "point" };
    if w == 0.0 { Err(Refusal::SingularPoint { field, index, error: SingularPoint }) } else { Ok(w) }
}

/// The items of a list of a question that the oracle can read.
fn items(list: &Value) -> &[Value] {
    list.as_array().map_or(&[], Vec::as_slice)
}

/// A number of such a question, rounded.
fn real(x: &Value) -> f64 {
    value::number(x).map_or(f64::NAN, |x| nearest_f64(&x))
}

fn reals(list: &Value) -> Vec<f64> {
    items(list).iter().map(real).collect()
}

fn coordinates<const N: usize>(point: &Value) -> [f64; N] {
    std::array::from_fn(|i| point.get(i).map_or(f64::NAN, real))
}

fn polynomial<const N: usize>(terms: &Value, at: &Value) -> Jet<N> {
    let term = |term: &Value| (real(&term[0]), std::array::from_fn(|i| real(&term[i + 1]) as i32));
    let terms: Vec<(f64, [i32; N])> = items(terms).iter().map(term).collect();
    plain::polynomial(&terms, &coordinates(at))
}

fn spline(input: &Object) -> Spline {
    let shape = reals(&input["shape"]).into_iter().map(|n| n as usize).collect();
    Spline::interpolate(shape, reals(&input["values"]), input["boundary"] == "mirror")
}

fn evaluate(input: &Object) -> Value {
    let (spline, only_value) = (spline(input), json!([""]));
    let words = items(input.get("derivatives").unwrap_or(&only_value));
    let orders = |word: &Value| -> Vec<usize> {
        let word = word.as_str().unwrap_or_default();
        "xyz".chars().take(spline.shape.len()).map(|axis| word.matches(axis).count()).collect()
    };
    let at = |point: &Value| -> Vec<f64> {
        let point = reals(point);
        words.iter().map(|word| spline.derivative(&point, &orders(word))).collect()
    };
    json!({"values": items(&input["points"]).iter().map(at).collect::<Vec<_>>()})
}

fn impulse(input: &Object) -> Value {
    let place = |text: &str| real(&json!(text)) as i64;
    let samples = input["samples"].as_object().into_iter().flatten();
    let samples: Vec<(i64, f64)> = samples.map(|(k, g)| (place(k), real(g))).collect();
    let [from, to] = ["k_from", "k_to"].map(|name| real(&input[name]) as i64);
    let coefficients: Vec<f64> = (from..=to).map(|k| plain::bounded_coefficient(&samples, k)).collect();
    let points = reals(&input["points"]);
    let [values, d1, d2] = [0, 1, 2]
        .map(|order| -> Vec<f64> { points.iter().map(|x| plain::bounded_derivative(&samples, *x, order)).collect() });
    json!({"coefficients": coefficients, "values": values, "d1": d1, "d2": d2})
}

/// The jets of numerators over a denominator; `None` at a pole.
fn quotients<const N: usize, const C: usize>(input: &Object, at: &Value) -> Option<[Jet<N>; C]> {
    let denominator = polynomial::<N>(&input["denominator"], at);
    let numerators: [Jet<N>; C] = std::array::from_fn(|i| polynomial(&input["numerators"][i], at));
    (denominator.value != 0.0).then(|| numerators.map(|numerator| plain::quotient(&numerator, &denominator)))
}

fn parametric_curve(input: &Object) -> Result<Value, Refusal> {
    let [x, y]: [Jet<1>; 2] = quotients(input, &json!([input["t"]])).ok_or(CurveError::Pole)?;
    let [[dx], [dy]] = [x.gradient, y.gradient];
    let w = dx * dx + dy * dy;
    if w == 0.0 {
        return Err(CurveError::Singular.into());
    }
    let kappa = (dx * y.hessian[0][0] - x.hessian[0][0] * dy) / (w * w.sqrt());
    let point = [x.value, y.value];
    Ok(json!({"point": point, "speed_squared": w, "kappa_squared": kappa * kappa, "kappa_sign": sign(kappa)}))
}

fn parametric_surface(input: &Object) -> Result<Value, Refusal> {
    let surface: [Jet<2>; 3] = quotients(input, &input["point"]).ok_or(SurfaceError::Pole)?;
    let first = |i: usize| surface.map(|x| x.gradient[i]);
    let second = |i: usize, j: usize| surface.map(|x| x.hessian[i][j]);
    let (u, v) = (first(0), first(1));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let w2 = dot(normal, normal);
    if w2 == 0.0 {
        return Err(SurfaceError::Singular.into());
    }
    let forms @ [e, f, g] = [dot(u, u), dot(u, v), dot(v, v)];
    let seconds @ [we, wf, wg] = [(0, 0), (0, 1), (1, 1)].map(|(i, j)| dot(normal, second(i, j)));
    let mean = (we * g - 2.0 * wf * f + wg * e) / (2.0 * w2 * w2.sqrt());
    let (half_sum, spread) = plain::mean_and_spread(plain::shape_of_forms(forms, seconds, w2.sqrt()));
    Ok(json!({
        "E": e, "F": f, "G": g, "w_squared": w2, "w_e": we, "w_f": wf, "w_g": wg,
        "gaussian": (we * wg - wf * wf) / (w2 * w2), "mean_squared": mean * mean, "mean_sign": sign(mean),
        "weingarten_w": [
            [(wf * f - we * g) / w2, (wg * f - wf * g) / w2],
            [(we * f - wf * e) / w2, (wf * f - wg * e) / w2],
        ],
        "principal": [half_sum + spread, half_sum - spread],
    }))
}
