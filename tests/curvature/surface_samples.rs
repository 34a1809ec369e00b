//! Random surfaces to second order, near-degenerate ones among them.

use isoracle::curvature::jet::Jet;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Integer, Multivariate, Rational};
use proptest::prelude::*;

/// The jets of x, y, z.
pub type Jets = [Jet<Rational, 2>; 3];

/// A vector of three small integers.
fn small() -> impl Strategy<Value = Vector<Rational, 3>> {
    prop::array::uniform3(-3..=3_i32).prop_map(|x| Vector(x.map(Rational::from)))
}

/// 0, or ±2⁻ᵇ.
fn hair() -> impl Strategy<Value = Rational> {
    (-1..=1_i32, 0..60_u32).prop_map(|(sign, bits)| Rational::from((Integer::from(sign), Integer::from(1) << bits)))
}

/// The jets with these derivatives.
pub fn jets(at: &Vector<Rational, 3>, first: [&Vector<Rational, 3>; 2], second: [&Vector<Rational, 3>; 3]) -> Jets {
    std::array::from_fn(|i| Jet {
        value: at[i].clone(),
        gradient: Vector(first.map(|x| x[i].clone())),
        hessian: Matrix::from_fn(|a, b| second[a + b][i].clone()),
    })
}

/// Regular surfaces to second order: any small ones; with σᵥ next to a multiple of σᵤ; umbilic or next to it; with σᵤ
/// ⟂ σᵥ.
pub fn surface() -> impl Strategy<Value = Jets> {
    let any = (small(), small(), small(), [small(), small(), small()])
        .prop_map(|(at, u, v, [uu, uv, vv])| jets(&at, [&u, &v], [&uu, &uv, &vv]));
    let thin = (small(), small(), small(), [small(), small(), small()], -2..=2_i32, hair()).prop_map(
        |(at, u, w, [uu, uv, vv], n, hair)| {
            let v = u.scaled(&Rational::from(n)) + &w.scaled(&hair);
            jets(&at, [&u, &v], [&uu, &uv, &vv])
        },
    );
    // σ_ij = (tangent) + (k⟨σᵢ, σⱼ⟩ + hair) n, so that W(e f; f g) = W²(k(E F; F G) + hair).
    let umbilic = (small(), small(), small(), prop::array::uniform3((-2..=2_i32, -2..=2_i32, hair())), -2..=2_i32)
        .prop_map(|(at, u, v, parts, k)| {
            let n = u.cross(&v);
            let products = [u.dot(&u), u.dot(&v), v.dot(&v)];
            let second: [Vector<Rational, 3>; 3] = std::array::from_fn(|i| {
                let (a, b, hair) = &parts[i];
                let along = Rational::from(&products[i] * k) + hair;
                u.scaled(&Rational::from(*a)) + &v.scaled(&Rational::from(*b)) + &n.scaled(&along)
            });
            jets(&at, [&u, &v], [&second[0], &second[1], &second[2]])
        });
    let orthogonal = (small(), small(), small(), [small(), small(), small()]).prop_map(|(at, u, w, [uu, uv, vv])| {
        let v = u.cross(&w);
        jets(&at, [&u, &v], [&uu, &uv, &vv])
    });
    prop_oneof![3 => any, 1 => thin, 2 => umbilic, 1 => orthogonal].prop_filter("regular", |surface| {
        let [u, v] = basis(surface);
        u.cross(&v) != Vector::zero()
    })
}

/// σᵤ and σᵥ.
pub fn basis(surface: &Jets) -> [Vector<Rational, 3>; 2] {
    [0, 1].map(|i| Vector(surface.each_ref().map(|x| x.gradient[i].clone())))
}

/// σ_ij.
pub fn second(surface: &Jets, i: usize, j: usize) -> Vector<Rational, 3> {
    Vector(surface.each_ref().map(|x| x.hessian.0[i][j].clone()))
}

/// Changes of parameters to second order: det ∂h ≠ 0.
pub fn change() -> impl Strategy<Value = [Jet<Rational, 2>; 2]> {
    let entry = || -2..=2_i32;
    let jet = move || {
        ([entry(), entry(), entry()], [entry(), entry(), entry()]).prop_map(|([value, a, b], [aa, ab, bb])| {
            let [value, a, b, aa, ab, bb] = [value, a, b, aa, ab, bb].map(Rational::from);
            Jet { value, gradient: Vector([a, b]), hessian: Matrix([[aa, ab.clone()], [ab, bb]]) }
        })
    };
    [jet(), jet()].prop_filter("invertible", |h| !determinant(h).is_zero())
}

/// det ∂h.
pub fn determinant([x, y]: &[Jet<Rational, 2>; 2]) -> Rational {
    Rational::from(&x.gradient[0] * &y.gradient[1]) - Rational::from(&x.gradient[1] * &y.gradient[0])
}

/// (a, b), small.
pub fn pair() -> impl Strategy<Value = [Rational; 2]> {
    prop::array::uniform2((-4..=4_i32, 1..=3_i32).prop_map(Rational::from))
}

/// The curve (u(t), v(t)) with these first and second derivatives.
pub fn path(first: &[Rational; 2], second: &[Rational; 2]) -> [Jet<Rational, 1>; 2] {
    std::array::from_fn(|a| Jet {
        value: Rational::new(),
        gradient: Vector([first[a].clone()]),
        hessian: Matrix([[second[a].clone()]]),
    })
}

/// A polynomial in x, y, z of low degree.
pub fn function() -> impl Strategy<Value = Multivariate<3>> {
    prop::collection::vec((prop::array::uniform3(0..=2_u32), -3..=3_i32), 0..6)
        .prop_map(|terms| Multivariate::new(terms.into_iter().map(|(e, c)| (e, Rational::from(c)))))
}

/// A rotation, by Cayley's (I − S)⁻¹(I + S) with S = [w]×: rational, orthogonal, of determinant 1.
pub fn rotation() -> impl Strategy<Value = Matrix<Rational, 3, 3>> {
    prop::array::uniform3((-3..=3_i32, 1..=2_i32)).prop_map(|w| {
        let [a, b, c] = w.map(Rational::from);
        let skew = |sign: i32| {
            let (zero, one) = (Rational::new(), Rational::from(1));
            let s = [
                [zero.clone(), -c.clone(), b.clone()],
                [c.clone(), zero.clone(), -a.clone()],
                [-b.clone(), a.clone(), zero],
            ];
            Matrix::from_fn(|i, j| {
                let unit = if i == j { one.clone() } else { Rational::new() };
                unit + Rational::from(&s[i][j] * sign)
            })
        };
        isoracle::linear::inverse(&skew(-1)).expect("I − S is regular for a skew S").times(&skew(1))
    })
}
