//! All jets with derivatives −1, 0, 1: kinds of points and principal curvatures counted, and each derived twice.

use super::level::jet;
use isoracle::curvature::implicit_graph::{Axis, forms_along};
use isoracle::curvature::implicit_printed::printed_principal_w;
use isoracle::curvature::implicit_surface;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::point_kind::PointKind;
use isoracle::curvature::principal_direction::{PrincipalDirections, principal_directions};
use isoracle::curvature::shape_operator::ShapeOperator;
use isoracle::linear::Matrix;
use isoracle::number::{OrderedField, Rational, Sign, Surd};
use std::collections::BTreeMap;

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// The numbers with these digits to the base 3, less 1 each.
fn digits<const N: usize>() -> impl Iterator<Item = [i64; N]> {
    let count = 3_usize.pow(u32::try_from(N).expect("few digits"));
    (0..count).map(|n| std::array::from_fn(|i| (n / 3_usize.pow(u32::try_from(i).expect("few")) % 3) as i64 - 1))
}

/// The gradients: all 26, or one of each shape.
fn gradients() -> Vec<[i64; 3]> {
    match is_long() {
        true => digits().filter(|g| *g != [0; 3]).collect(),
        false => vec![[1, 0, 0], [1, 1, 0], [1, 1, 1]],
    }
}

/// The kind by the signs of |∇f|k₁ and |∇f|k₂.
fn kind_by_signs([k1, k2]: &[Surd; 2]) -> PointKind {
    match (k1.sign() * k2.sign(), k1 == k2) {
        (Sign::Negative, _) => PointKind::Hyperbolic,
        (Sign::Zero, true) => PointKind::Planar,
        (Sign::Zero, false) => PointKind::Parabolic,
        (Sign::Positive, true) => PointKind::Umbilic,
        (Sign::Positive, false) => PointKind::Elliptic,
    }
}

fn check(jet: &Jet<Rational, 3>, shape: &ShapeOperator, scaled: &[Surd; 2]) {
    let level = implicit_surface::curvature(jet).expect("regular");
    for forms in Axis::ALL.iter().filter_map(|&axis| forms_along(jet, axis).ok()) {
        assert_eq!(forms.gaussian(), level.gaussian);
        assert_eq!(forms.mean_w().square() / &forms.gradient_squared, level.mean_squared);
    }
    let (PrincipalDirections::Umbilic(directions) | PrincipalDirections::Two(directions)) =
        principal_directions(jet).expect("regular");
    let matrix = Matrix::<Surd, 3, 3>(shape.scaled().0.clone().map(|row| row.map(Surd::from)));
    for (v, k) in directions.iter().zip(scaled) {
        assert_eq!(matrix.apply(v), v.scaled(k));
    }
}

mod cu_197 {
    use super::*;

    /// The counts come from another program, by the sign of the determinant and the trace of the form in a basis of the kernel.
    #[test]
    fn points_of_each_kind_are_as_many_as_counted_otherwise() {
        let mut kinds = BTreeMap::new();
        for gradient in gradients() {
            for second in digits() {
                let jet = jet(gradient, second);
                let shape = ShapeOperator::new(&jet).expect("regular");
                let scaled = shape.scaled_principal();
                let kind = implicit_surface::curvature(&jet).expect("regular").kind();
                assert_eq!(kind, kind_by_signs(&scaled), "{gradient:?} {second:?}");
                *kinds.entry(kind).or_insert(0) += 1;
                check(&jet, &shape, &scaled);
            }
        }
        let counts: Vec<u32> = kinds.into_values().collect();
        // Planar, parabolic, hyperbolic, elliptic, umbilic.
        let expected = if is_long() { [414, 3648, 12096, 2088, 708] } else { [51, 444, 1390, 212, 90] };
        assert_eq!(counts, expected);
    }
}

mod cu_189 {
    use super::*;

    #[test]
    fn the_printed_principal_curvatures_are_right_for_a_tenth_of_the_jets() {
        let right = |gradient: [i64; 3], second: [i64; 6]| {
            let shape = ShapeOperator::new(&jet(gradient, second)).expect("regular");
            printed_principal_w(&shape) == shape.scaled_principal()
        };
        let all = gradients().into_iter().flat_map(|g| digits().map(move |second| (g, second)));
        let count = all.filter(|(g, second)| right(*g, *second)).count();
        assert_eq!(count, if is_long() { 1818 } else { 207 });
    }
}
