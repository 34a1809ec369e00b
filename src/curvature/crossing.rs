//! Points that a plane curve passes more than once, and whether it is simple.

use super::rational_curve::RationalCurve;
use crate::number::{Algebraic, Integer, Polynomial, Rational, Ring, Sign, real_roots};

/// The parameters that share their point with another one. CU-31.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-31")]
pub enum Crossings {
    /// The parameters of each point passed more than once, in increasing order; none: the curve is simple.
    At(Vec<Vec<Algebraic>>),
    /// A polynomial in s and t divides both coordinates of (α(s) − α(t))/(s − t): real or not, there are infinitely many such pairs.
    CommonFactor,
}

/// (f(s)g(t) − f(t)g(s))/(s − t), as a polynomial in s whose coefficients are polynomials in t.
fn divided_difference(f: &Polynomial, g: &Polynomial) -> Vec<Polynomial> {
    let length = f.coefficients().len().max(g.coefficients().len());
    let a = |p: &Polynomial, n: usize| p.coefficients().get(n).cloned().unwrap_or_default();
    // sⁿtᵐ − sᵐtⁿ = (s − t)·Σ sⁱtʲ over i + j = n + m − 1, m ≤ i < n
    let mut table = vec![vec![Rational::new(); length]; length];
    for n in 0..length {
        for m in 0..n {
            let factor = a(f, n) * a(g, m) - a(f, m) * a(g, n);
            for i in m..n {
                table[i][n + m - 1 - i] += &factor;
            }
        }
    }
    let mut rows: Vec<Polynomial> = table.into_iter().map(Polynomial::new).collect();
    while rows.last().is_some_and(Polynomial::is_zero) {
        rows.pop();
    }
    rows
}

/// The resultant of two polynomials whose coefficients are polynomials, the constant first, the last one not 0: 0 where they
/// have a common root, or where both leading coefficients are 0. CU-31.
pub fn resultant(a: &[Polynomial], b: &[Polynomial]) -> Polynomial {
    let (Some(m), Some(n)) = (a.len().checked_sub(1), b.len().checked_sub(1)) else {
        // The roots common with 0 are all roots: none, of a constant.
        let other = if a.is_empty() { b } else { a };
        return if let [constant] = other { constant.clone() } else { Polynomial::new(Vec::new()) };
    };
    // Sylvester's matrix: the leading coefficients first.
    let row = |p: &[Polynomial], shift: usize| {
        let mut row = vec![Polynomial::new(Vec::new()); m + n];
        for (entry, coefficient) in row[shift..].iter_mut().zip(p.iter().rev()) {
            *entry = coefficient.clone();
        }
        row
    };
    determinant((0..n).map(|i| row(a, i)).chain((0..m).map(|i| row(b, i))).collect())
}

/// The determinant, by Bareiss' elimination: its divisions have no remainder.
fn determinant(mut rows: Vec<Vec<Polynomial>>) -> Polynomial {
    let (size, mut last, mut is_odd) = (rows.len(), Polynomial::integer(1), false);
    for k in 0..size {
        let Some(pivot) = (k..size).find(|&i| !rows[i][k].is_zero()) else { return Polynomial::new(Vec::new()) };
        rows.swap(k, pivot);
        is_odd ^= pivot != k;
        for i in k + 1..size {
            for j in k + 1..size {
                let minor = rows[k][k].clone() * &rows[i][j] - &(rows[i][k].clone() * &rows[k][j]);
                rows[i][j] = minor.divide(&last).expect("a pivot is not 0").0;
            }
        }
        last = rows[k][k].clone();
    }
    if is_odd { -last } else { last }
}

/// A polynomial that is 0 at each t that shares its point with another s, real or complex, and at each singular t. CU-31.
pub fn crossing_polynomial(curve: &RationalCurve<2>) -> Polynomial {
    let [x, y] = curve.numerators().each_ref().map(|p| divided_difference(p, curve.denominator()));
    resultant(&x, &y)
}

/// The points that the curve passes more than once, over all real parameters but poles: with none, it is simple, so injective.
/// CU-12, CU-31.
#[doc(alias = "CU-12")]
#[doc(alias = "CU-16")]
pub fn crossings(curve: &RationalCurve<2>) -> Crossings {
    let common = crossing_polynomial(curve);
    let Some(roots) = real_roots(&common) else { return Crossings::CommonFactor };
    let defined = |t: &Algebraic| t.sign_of(curve.denominator()) != Sign::Zero;
    let roots: Vec<Algebraic> = roots.into_iter().filter(defined).collect();
    let values: Vec<[Algebraic; 2]> = roots
        .iter()
        .map(|t| curve.numerators().each_ref().map(|p| value(p, curve.denominator(), &common, t)))
        .collect();
    let mut groups: Vec<(&[Algebraic; 2], Vec<Algebraic>)> = Vec::new();
    for (t, point) in roots.into_iter().zip(&values) {
        match groups.iter_mut().find(|(other, _)| *other == point) {
            Some((_, group)) => group.push(t),
            None => groups.push((point, vec![t])),
        }
    }
    Crossings::At(groups.into_iter().map(|(_, group)| group).filter(|group| group.len() > 1).collect())
}

/// p(t)/q(t) at a root t of r: one of the roots of Res_t(r, p − zq) in z, told from the others by an enclosure.
fn value(p: &Polynomial, q: &Polynomial, r: &Polynomial, t: &Algebraic) -> Algebraic {
    if let Some(t) = t.rational() {
        return Algebraic::from(p.evaluate(t) / q.evaluate(t));
    }
    let constants: Vec<Polynomial> = r.coefficients().iter().map(|a| Polynomial::new(vec![a.clone()])).collect();
    let length = p.coefficients().len().max(q.coefficients().len());
    let a = |p: &Polynomial, n: usize| p.coefficients().get(n).cloned().unwrap_or_default();
    let mut linear: Vec<Polynomial> = (0..length).map(|n| Polynomial::new(vec![a(p, n), -a(q, n)])).collect();
    while linear.last().is_some_and(Polynomial::is_zero) {
        linear.pop();
    }
    if linear.is_empty() {
        return Algebraic::from(Rational::new());
    }
    // r may have roots where p − zq loses its leading terms; they change no root of ours, for r's leading coefficient is a constant.
    let candidates = real_roots(&resultant(&constants, &linear)).expect("r and q have no common root with p");
    let mut bits = 16;
    loop {
        let near = t.refined(bits);
        let z = quotient_range(p, q, near.bounds());
        let inside = candidates.iter().map(|root| root.refined(bits)).enumerate().filter(|(_, root)| {
            let (lo, hi) = root.bounds();
            z.as_ref().is_none_or(|(a, b)| a <= hi && lo <= b)
        });
        let inside: Vec<usize> = inside.map(|(i, _)| i).collect();
        if let [one] = inside.as_slice() {
            return candidates[*one].clone();
        }
        bits *= 2;
    }
}

/// Around p/q for all t between the bounds; `None` where q may be 0.
fn quotient_range(p: &Polynomial, q: &Polynomial, (lo, hi): (&Rational, &Rational)) -> Option<(Rational, Rational)> {
    let middle = Rational::from(lo + hi) / 2_u32;
    let radius = Rational::from(hi - lo) / 2_u32;
    // |f(t) − f(m)| ≤ Σ n|aₙ|Mⁿ⁻¹·|t − m|, |t| ≤ M
    let largest = Rational::from(lo.abs_ref()).max(Rational::from(hi.abs_ref()));
    let slope = |f: &Polynomial| {
        let terms = f.coefficients().iter().enumerate().rev();
        terms.fold((Rational::new(), Rational::new()), |(value, slope), (_, a)| {
            (value.clone() * &largest + Rational::from(a.abs_ref()), slope * &largest + value)
        })
    };
    let range = |f: &Polynomial| {
        let (at, error) = (f.evaluate(&middle), slope(f).1 * &radius);
        (Rational::from(&at - &error), at + error)
    };
    let ((a, b), (c, d)) = (range(p), range(q));
    if c <= 0 && d >= 0 {
        return None;
    }
    let corners = [(&a, &c), (&a, &d), (&b, &c), (&b, &d)].map(|(x, y)| Rational::from(x / y));
    Some((corners.iter().min().expect("four").clone(), corners.iter().max().expect("four").clone()))
}

/// Whether the two parameters have one point; `None` where one is a pole.
pub fn share_a_point(curve: &RationalCurve<2>, s: &Rational, t: &Rational) -> Option<bool> {
    Some(curve.point(s)? == curve.point(t)?)
}

/// The multiplicity of a root t; `None` for the zero polynomial, whose multiplicity is infinite.
pub fn multiplicity(p: &Polynomial, t: &Rational) -> Option<usize> {
    let factor = Polynomial::with_root(t);
    let (mut rest, mut count) = (p.clone(), 0);
    while !rest.is_zero() {
        let (quotient, remainder) = rest.divide(&factor).expect("x − t is not 0");
        if !remainder.is_zero() {
            return Some(count);
        }
        (rest, count) = (quotient, count + 1);
    }
    None
}

/// The exact root of a polynomial that is a square: √p with a positive leading coefficient; `None` iff it is no square over ℚ.
pub fn square_root(p: &Polynomial) -> Option<Polynomial> {
    let Some(degree) = p.degree() else { return Some(p.clone()) };
    let leading = &p.coefficients()[degree];
    let is_square = |n: &Integer| *n >= 0 && n.is_perfect_square();
    if degree % 2 == 1 || !is_square(leading.numer()) || !is_square(leading.denom()) {
        return None;
    }
    let half = degree / 2;
    let mut root = vec![Rational::new(); half + 1];
    root[half] = Rational::from((leading.numer().clone().sqrt(), leading.denom().clone().sqrt()));
    // The coefficient of x^(half + k) is 2·root[half]·root[k] and products of later ones.
    for k in (0..half).rev() {
        let known = (k + 1..half).fold(Rational::new(), |sum, i| sum + Rational::from(&root[i] * &root[half + k - i]));
        let twice = root[half].clone() * 2_u32;
        root[k] = (p.coefficients()[half + k].clone() - known) / twice;
    }
    let root = Polynomial::new(root);
    (root.clone() * &root == *p).then_some(root)
}
