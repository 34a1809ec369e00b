//! The questions of the suite `curvature`.
//!
//! Those of the ordinary rows are well-conditioned, or have numbers so short that the plain formulas in binary64 meet no
//! rounding before the last steps; where they are not short, a question is drawn again until the curvatures are no small
//! difference of large terms. So a good implementation in binary64 passes. Hard questions stand in rows of their own.

use super::conditioning::is_well_conditioned;
use super::question::{Question, any, eighth, integer, nonzero, power_of_two, terms, text, texts};
use super::spline::signal;
use crate::answer::value;
use crate::curvature::jet::Jet;
use crate::number::{Multivariate, Rational};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// Ordinary questions: level surfaces that are spheres, cylinders, saddles, planes, quadrics, that have an umbilic, a vertical tangent
/// plane (f_z = 0), or are given by any cubic polynomial; level curves; parametrised curves and surfaces; splines; n_λ.
pub const ROWS: [&str; 16] = [
    "spheres",
    "cylinders",
    "saddles",
    "planes",
    "quadrics",
    "umbilics",
    "fz-zero",
    "cubic-surfaces",
    "circles",
    "cubic-curves",
    "inflections",
    "parametric-curves",
    "parametric-surfaces",
    "spline-2d",
    "spline-3d",
    "normalize",
];

/// Hard ones: k₁ and k₂ nearly equal; a gradient, or a tangent vector, that is short but not zero; one that is zero, and poles (the answer is
/// `degenerate`); questions that are ill-posed.
pub const GROUPS: [&str; 4] = ["near-umbilics", "near-singular", "singular", "broken"];

/// A question of a row, the `number`th.
pub fn question(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    match row {
        "spheres" => {
            let centre = [(); 3].map(|()| eighth(random, 4));
            let scale = nonzero(random, 5);
            surface(row, &(sphere(&centre) * &constant(&scale)), &elsewhere(random, &centre))
        }
        "cylinders" => {
            // |d|²|x|² − ⟨d, x⟩²: the squared distance from the line through 0 along d, times |d|².
            let axis = [nonzero(random, 3), integer(random, 3), integer(random, 3)];
            let dot = linear(&axis);
            let square = axis.iter().fold(Rational::new(), |sum, d| sum + Rational::from(d.square_ref()));
            let f = sphere(&[(); 3].map(|()| Rational::new())) * &constant(&square) - &(dot.clone() * &dot);
            // Anywhere but on the line.
            let at = [nonzero(random, 5) / 8_u32, integer(random, 5), integer(random, 5)];
            let on_axis = (0..3).all(|i| {
                let j = (i + 1) % 3;
                Rational::from(&axis[i] * &at[j]) == Rational::from(&axis[j] * &at[i])
            });
            if on_axis { question(random, row, number) } else { surface(row, &f, &at) }
        }
        "saddles" => {
            // z = (x² − y²)·a + b·xy
            let [x, y, z] = variables::<3>();
            let quadratic = (x.clone() * &x - &(y.clone() * &y)) * &constant(&nonzero(random, 5));
            let f = z - &quadratic - &(x * &y * &constant(&integer(random, 5)));
            surface(row, &f, &[(); 3].map(|()| eighth(random, 2)))
        }
        "planes" => {
            let normal = [integer(random, 9), integer(random, 9), nonzero(random, 9)];
            surface(row, &(linear(&normal) + &constant(&integer(random, 9))), &[(); 3].map(|()| eighth(random, 9)))
        }
        "umbilics" => {
            // A sphere, and what vanishes at the point to third order.
            let centre = [(); 3].map(|()| integer(random, 3));
            let at = elsewhere(random, &centre).map(Rational::round);
            let at = if at == centre { [at[0].clone() + 1_u32, at[1].clone(), at[2].clone()] } else { at };
            let offset: [Multivariate<3>; 3] = std::array::from_fn(|i| Multivariate::variable(i) - &constant(&at[i]));
            let [u, v, w] = &offset;
            let cubes = [[u, u, v], [v, v, w], [u, v, w], [w, w, w]];
            let cubic = cubes.into_iter().fold(Multivariate::constant(Rational::new()), |sum, [a, b, c]| {
                sum + &(a.clone() * b * c * &constant(&integer(random, 3)))
            });
            surface(row, &(sphere(&centre) + &cubic), &at)
        }
        "fz-zero" => well_conditioned(random, |random| {
            let at = [(); 3].map(|()| eighth(random, 2));
            let f = polynomial::<3>(random, 3, |random| integer(random, 9));
            let slope = Jet::of_polynomial(&f, &at).gradient[2].clone();
            surface(row, &(f - &(Multivariate::variable(2) * &constant(&slope))), &at)
        }),
        "quadrics" => well_conditioned(random, |random| {
            let at = [(); 3].map(|()| eighth(random, 3));
            surface(row, &polynomial::<3>(random, 2, |random| any(random, 9)), &at)
        }),
        "cubic-surfaces" => well_conditioned(random, |random| {
            let at = [(); 3].map(|()| any(random, 2));
            surface(row, &polynomial::<3>(random, 3, |random| any(random, 9)), &at)
        }),
        "circles" => {
            let [x, y] = variables::<2>();
            let centre = [(); 2].map(|()| eighth(random, 4));
            let [x, y] = [x - &constant(&centre[0]), y - &constant(&centre[1])];
            let f = (x.clone() * &x + &(y.clone() * &y)) * &constant(&nonzero(random, 5));
            curve(row, &f, &[centre[0].clone() + nonzero(random, 9) / 8_u32, eighth(random, 5)])
        }
        "cubic-curves" => well_conditioned(random, |random| {
            let at = [(); 2].map(|()| any(random, 2));
            curve(row, &polynomial::<2>(random, 3, |random| any(random, 9)), &at)
        }),
        "inflections" => {
            // A line, or y = a + b(x − c) + d(x − c)³ at x = c.
            let [x, y] = variables::<2>();
            let [a, b, c] = [(); 3].map(|()| integer(random, 5));
            let u = x - &constant(&c);
            let cubic = u.clone() * &u * &u * &constant(&integer(random, 3));
            let f = (y - &(u * &constant(&b)) - &cubic) * &constant(&nonzero(random, 3));
            curve(row, &f, &[c, a])
        }
        "parametric-curves" => parametric_curve(random, row, number),
        "parametric-surfaces" => well_conditioned(random, |random| parametric_surface(random, row, number)),
        "spline-2d" => well_conditioned(random, |random| spline(random, row, 2, number)),
        "spline-3d" => well_conditioned(random, |random| spline(random, row, 3, number)),
        "normalize" => {
            let slope = (eighth(random, 9).abs() + Rational::from((1, 8))) * power_of_two(random.random_range(-4..5));
            let x = any(random, 9) * power_of_two(random.random_range(-9..6));
            Question { row, operation: "curvature.normalize", input: json!({"lambda": text(&slope), "x": text(&x)}) }
        }
        "near-umbilics" => {
            // An ellipsoid that is nearly a sphere.
            let [x, y, z] = variables::<3>();
            let squares = [x, y, z].map(|x| x.clone() * &x);
            let f = squares.into_iter().fold(Multivariate::constant(Rational::new()), |sum, square| {
                let nearly_1 = power_of_two(-random.random_range(8..45)) * integer(random, 3) + 1_u32;
                sum + &(square * &constant(&nearly_1))
            });
            surface(row, &f, &[nonzero(random, 5), integer(random, 5), integer(random, 5)])
        }
        "near-singular" => near_singular(random, row, number),
        "singular" => singular(random, row, number),
        "broken" => broken(row, number),
        other => unreachable!("no row {other}"),
    }
}

/// Whether a level set, its curvatures known, is what the name of its row says.
pub fn is_of_row(row: &str, out: &Value) -> bool {
    let number = |x: &Value| value::number(x).unwrap_or_default();
    let real = |name: &str| number(&out[name]);
    let short = || {
        let gradient = out["gradient"].as_array().map_or(&[][..], Vec::as_slice);
        gradient.iter().all(|x| number(x).abs() < power_of_two(-10))
    };
    match row {
        "spheres" | "umbilics" => real("discriminant") == 0 && real("gaussian") > 0,
        "cylinders" => real("gaussian") == 0 && real("mean_squared") > 0,
        "planes" => real("gaussian") == 0 && real("mean_squared") == 0,
        "saddles" => real("gaussian") < 0,
        "fz-zero" => number(&out["gradient"][2]) == 0,
        "circles" => real("kappa_squared") > 0,
        "inflections" => real("kappa_squared") == 0,
        "near-umbilics" => real("discriminant") * 1000_u32 < real("mean_squared"),
        "near-singular" => out.get("gradient").is_none() || short(),
        _ => true,
    }
}

fn variables<const N: usize>() -> [Multivariate<N>; N] {
    std::array::from_fn(Multivariate::variable)
}

fn constant<const N: usize>(x: &Rational) -> Multivariate<N> {
    Multivariate::constant(x.clone())
}

fn linear(coefficients: &[Rational; 3]) -> Multivariate<3> {
    let term = |i: usize| Multivariate::variable(i) * &constant(&coefficients[i]);
    term(0) + &term(1) + &term(2)
}

/// |x − centre|².
fn sphere(centre: &[Rational; 3]) -> Multivariate<3> {
    let square = |i: usize| {
        let u = Multivariate::variable(i) - &constant(&centre[i]);
        u.clone() * &u
    };
    square(0) + &square(1) + &square(2)
}

/// A point with short coordinates that is not this one.
fn elsewhere(random: &mut ChaCha8Rng, point: &[Rational; 3]) -> [Rational; 3] {
    [&point[0] + nonzero(random, 9) / 8_u32, eighth(random, 4), eighth(random, 4)]
}

/// Every term up to that degree, half of them 0.
fn polynomial<const N: usize>(
    random: &mut ChaCha8Rng,
    degree: u32,
    coefficient: impl Fn(&mut ChaCha8Rng) -> Rational,
) -> Multivariate<N> {
    let mut all = Vec::new();
    for code in 0..(degree + 1).pow(u32::try_from(N).expect("few variables")) {
        let exponents: [u32; N] =
            std::array::from_fn(|i| code / (degree + 1).pow(u32::try_from(i).expect("few variables")) % (degree + 1));
        if exponents.iter().sum::<u32>() <= degree && random.random() {
            all.push((exponents, coefficient(random)));
        }
    }
    Multivariate::new(all)
}

fn surface(row: &'static str, f: &Multivariate<3>, at: &[Rational; 3]) -> Question {
    let input = json!({"polynomial": terms(f), "point": texts(at)});
    Question { row, operation: "curvature.implicit_surface", input }
}

fn curve(row: &'static str, f: &Multivariate<2>, at: &[Rational; 2]) -> Question {
    let input = json!({"polynomial": terms(f), "point": texts(at)});
    Question { row, operation: "curvature.implicit_curve", input }
}

fn curve_by<const C: usize>(
    row: &'static str,
    numerators: &[Multivariate<1>; C],
    denominator: &Multivariate<1>,
    t: &Rational,
) -> Question {
    let numerators: Value = numerators.iter().map(terms).collect();
    let input = json!({"numerators": numerators, "denominator": terms(denominator), "t": text(t)});
    Question { row, operation: "curvature.parametric_curve", input }
}

fn surface_by(
    row: &'static str,
    numerators: &[Multivariate<2>; 3],
    denominator: &Multivariate<2>,
    at: &[Rational; 2],
) -> Question {
    let numerators: Value = numerators.iter().map(terms).collect();
    let input = json!({"numerators": numerators, "denominator": terms(denominator), "point": texts(at)});
    Question { row, operation: "curvature.parametric_surface", input }
}

/// A circle by (1 − t²)/(1 + t²), 2t/(1 + t²), or polynomials.
fn parametric_curve(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let [t] = variables::<1>();
    let square = t.clone() * &t;
    let one = constant(&Rational::from(1));
    if number.is_multiple_of(2) {
        let radius = constant(&nonzero(random, 5));
        let numerators = [(one.clone() - &square) * &radius, t * &radius * &constant(&Rational::from(2))];
        return curve_by(row, &numerators, &(one + &square), &eighth(random, 3));
    }
    well_conditioned(random, |random| {
        let numerators = [(); 2].map(|()| polynomial::<1>(random, 3, |random| any(random, 9)));
        let denominator = constant(&nonzero(random, 5)) + &(square.clone() * &constant(&integer(random, 3)));
        curve_by(row, &numerators, &denominator, &any(random, 2))
    })
}

/// A sphere by stereographic projection, a graph, or any polynomials.
fn parametric_surface(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let [u, v] = variables::<2>();
    let [one, two] = [1, 2].map(|n| constant(&Rational::from(n)));
    let square = u.clone() * &u + &(v.clone() * &v);
    let at = [(); 2].map(|()| eighth(random, 2));
    match number % 3 {
        0 => {
            let radius = constant(&nonzero(random, 5));
            let numerators = [u * &two * &radius, v * &two * &radius, (square.clone() - &one) * &radius];
            surface_by(row, &numerators, &(square + &one), &at)
        }
        1 => {
            let graph = polynomial::<2>(random, 3, |random| any(random, 9));
            surface_by(row, &[u, v, graph], &one, &at)
        }
        _ => {
            let numerators = [(); 3].map(|()| polynomial::<2>(random, 2, |random| any(random, 9)));
            surface_by(row, &numerators, &(one + &(square * &constant(&integer(random, 2).abs()))), &at)
        }
    }
}

fn spline(random: &mut ChaCha8Rng, row: &'static str, axes: usize, number: usize) -> Question {
    let shape: Vec<usize> = (0..axes).map(|_| random.random_range(3..6)).collect();
    let values: Vec<Rational> = (0..shape.iter().product()).map(|_| integer(random, 20)).collect();
    let mut input = signal(&shape, &values, ["mirror", "periodic"][number % 2]);
    let point = |random: &mut ChaCha8Rng| texts(&(0..axes).map(|_| eighth(random, 4)).collect::<Vec<Rational>>());
    input["points"] = (0..random.random_range(1..3)).map(|_| point(random)).collect();
    Question { row, operation: "curvature.spline", input }
}

/// The first question drawn that is well-conditioned.
fn well_conditioned(random: &mut ChaCha8Rng, mut draw: impl FnMut(&mut ChaCha8Rng) -> Question) -> Question {
    loop {
        let question = draw(random);
        if is_well_conditioned(&question) {
            return question;
        }
    }
}

/// A quadratic form near 0, where its gradient is short, and parametrisations that start slowly; all numbers are short.
fn near_singular(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let short = power_of_two(-random.random_range(20..60));
    match number % 4 {
        0 | 1 => {
            let [x, y, z] = variables::<3>();
            let form = [x.clone() * &x, y.clone() * &y, z.clone() * &z, x.clone() * &y, y * &z, z * &x];
            let f = form
                .into_iter()
                .fold(constant(&integer(random, 9)), |sum, square| sum + &(square * &constant(&nonzero(random, 9))));
            surface(row, &f, &[(); 3].map(|()| nonzero(random, 9) * &short))
        }
        2 => {
            let [x, y] = variables::<2>();
            let f =
                x.clone() * &x * &constant(&nonzero(random, 9)) + &(y.clone() * &y * &constant(&nonzero(random, 9)));
            curve(row, &f, &[(); 2].map(|()| nonzero(random, 9) * &short))
        }
        _ => {
            // A cusp, close to its tip.
            let [t] = variables::<1>();
            let square = t.clone() * &t * &constant(&nonzero(random, 5));
            let cube = t.clone() * &t * &t * &constant(&nonzero(random, 5));
            curve_by(row, &[square, cube], &constant(&Rational::from(1)), &(nonzero(random, 9) * short))
        }
    }
}

/// Points where the answer is `degenerate`: apices and nodes of level sets, cusps, poles, parallel tangent vectors.
fn singular(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let one = constant(&Rational::from(1));
    match number % 6 {
        0 => {
            // A cone, at its apex.
            let [x, y, z] = variables::<3>();
            let at = [(); 3].map(|()| integer(random, 5));
            let [x, y, z] = [(x, 0), (y, 1), (z, 2)].map(|(x, i)| {
                let u = x - &constant(&at[i]);
                u.clone() * &u
            });
            surface(row, &(x + &y - &(z * &constant(&nonzero(random, 5)))), &at)
        }
        1 => {
            let [x, y] = variables::<2>();
            let cube = x.clone() * &x * &x * &constant(&nonzero(random, 5));
            curve(row, &(y.clone() * &y - &cube), &[(); 2].map(|()| Rational::new()))
        }
        2 => {
            let [t] = variables::<1>();
            let square = t.clone() * &t * &constant(&nonzero(random, 5));
            curve_by(row, &[square.clone(), square * &t], &one_variable(1), &Rational::new())
        }
        3 => {
            let [t] = variables::<1>();
            let pole = integer(random, 5);
            curve_by(row, &[one_variable(1), t.clone()], &(t - &constant(&pole)), &pole)
        }
        4 => {
            let [u, v] = variables::<2>();
            let sum = u + &(v * &constant(&nonzero(random, 5)));
            let square = sum.clone() * &sum;
            surface_by(row, &[sum, square, one.clone()], &one, &[(); 2].map(|()| integer(random, 5)))
        }
        _ => {
            // No gradient anywhere, and none that rounding could bring about.
            let shape = [random.random_range(2..4), random.random_range(2..4)];
            let mut input = signal(&shape, &vec![Rational::new(); shape[0] * shape[1]], "mirror");
            input["points"] = json!([texts(&[eighth(random, 4), eighth(random, 4)])]);
            Question { row, operation: "curvature.spline", input }
        }
    }
}

fn one_variable(n: i32) -> Multivariate<1> {
    constant(&Rational::from(n))
}

/// Ill-posed questions: each a good one, but for one field.
fn broken(row: &'static str, number: usize) -> Question {
    let curve = json!({"polynomial": [["1", 2, 0], ["1", 0, 2]], "point": ["1", "1"]});
    let surface = json!({"polynomial": [["1", 2, 0, 0], ["1", 0, 2, 0], ["1", 0, 0, 2]], "point": ["1", "1", "1"]});
    let motion = json!({"numerators": [[["1", 1]], [["1", 2]]], "denominator": [["1", 0]], "t": "1"});
    let patch = json!({
        "numerators": [[["1", 1, 0]], [["1", 0, 1]], [["1", 1, 1]]], "denominator": [["1", 0, 0]], "point": ["1", "1"],
    });
    let signal =
        json!({"shape": [2, 2], "values": ["1", "2", "3", "5"], "boundary": "mirror", "points": [["1/2", "1/2"]]});
    let map = json!({"lambda": "1", "x": "1"});
    let faults = [
        ("curvature.implicit_curve", &curve, "polynomial", json!([["1", 2]])),
        ("curvature.implicit_curve", &curve, "polynomial", json!([["1", -1, 0]])),
        ("curvature.implicit_curve", &curve, "polynomial", json!([["1", "1/2", 0]])),
        ("curvature.implicit_curve", &curve, "point", json!(["1"])),
        ("curvature.implicit_surface", &surface, "polynomial", json!([["NaN", 1, 0, 0]])),
        ("curvature.implicit_surface", &surface, "polynomial", json!([["1", 1, 0]])),
        ("curvature.implicit_surface", &surface, "point", json!(["1", "1", "1/0"])),
        ("curvature.implicit_surface", &surface, "point", Value::Null),
        ("curvature.parametric_curve", &motion, "numerators", json!([[["1", 1]]])),
        ("curvature.parametric_curve", &motion, "denominator", Value::Null),
        ("curvature.parametric_curve", &motion, "t", json!(["1"])),
        ("curvature.parametric_surface", &patch, "numerators", json!([[["1", 1, 0]], [["1", 0, 1]]])),
        ("curvature.parametric_surface", &patch, "point", json!(["1", "1", "1"])),
        ("curvature.spline", &signal, "points", json!([["1/2"]])),
        ("curvature.spline", &signal, "shape", json!([4])),
        ("curvature.spline", &signal, "values", json!(["1", "2", "3"])),
        ("curvature.normalize", &map, "lambda", json!("0")),
        ("curvature.normalize", &map, "lambda", json!("-1/2")),
        ("curvature.normalize", &map, "x", json!("Infinity")),
    ];
    let (operation, input, field, value) = &faults[number % faults.len()];
    let mut input = (*input).clone();
    input[*field] = value.clone();
    if value.is_null() {
        input.as_object_mut().expect("it is one").remove(*field);
    }
    Question { row, operation, input }
}
