//! Level curves by the implicit function theorem (002, 3(b)).

use super::curves::{p, parameter, rational_circle};
use super::q;
use isoracle::curvature::curve_printed::{circle_kappa_printed, level_kappa_printed, level_kappa_printed_first_minus};
use isoracle::curvature::frame::Frame;
use isoracle::curvature::graph::{Axis, CurveElements, NoGraph, graph, level_elements};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::rational_curve::RationalCurve;
use isoracle::linear::Vector;
use isoracle::number::{Multivariate, OrderedField, Polynomial, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

type Function = Multivariate<2>;

fn function(terms: &[(i64, u32, u32)]) -> Function {
    Function::new(terms.iter().map(|(a, i, j)| ([*i, *j], Rational::from(*a))))
}

/// A polynomial of degree ≤ 3 in each variable.
fn any_function() -> impl Strategy<Value = Function> {
    prop::collection::vec((-4..=4_i64, 0..=3_u32, 0..=3_u32), 1..7).prop_map(|terms| function(&terms))
}

fn circle(r: i64) -> Function {
    function(&[(1, 2, 0), (1, 0, 2), (-r * r, 0, 0)])
}

fn elements(f: &Function, at: [i64; 2]) -> CurveElements {
    level_elements(&Jet::of_polynomial(f, &at.map(|x| q(x, 1)))).expect("a gradient")
}

/// With the other sign of all three.
fn turned(e: CurveElements) -> CurveElements {
    CurveElements { tangent: -e.tangent, normal: -e.normal, kappa: -e.kappa }
}

/// With x and y exchanged: a reflection, by which κ changes its sign; n is turned so that it is Jt again.
fn exchanged(e: CurveElements) -> CurveElements {
    let swap = |Vector([x, y]): Vector<Surd, 2>| Vector([y, x]);
    CurveElements { tangent: swap(e.tangent), normal: -swap(e.normal), kappa: -e.kappa }
}

fn elements_of(curve: &RationalCurve<2>, t: &Rational) -> CurveElements {
    let frame = Frame::new(&curve.jets(t).expect("no pole")).expect("regular");
    CurveElements { tangent: frame.tangent(), normal: frame.normal(), kappa: frame.kappa() }
}

mod cu_130 {
    use super::*;

    proptest! {
        /// Either graph is the curve: with the axes exchanged, it is run through the other way where f_x and f_y have one sign.
        #[test]
        fn over_both_axes_the_graph_is_one_curve(f in any_function(), at in prop::array::uniform2(parameter())) {
            let jet = Jet::of_polynomial(&f, &at);
            let over = [Axis::X, Axis::Y].map(|axis| graph(&jet, axis).map(|g| g.elements()));
            let [fx, fy] = jet.gradient.0.each_ref().map(|d| Sign::of(d.cmp0()));
            prop_assert_eq!(over[0].is_err(), fy == Sign::Zero);
            prop_assert_eq!(over[1].is_err(), fx == Sign::Zero);
            if let [Ok(x), Ok(y)] = over {
                let y = exchanged(y);
                prop_assert_eq!(x, if fx * fy == Sign::Positive { turned(y) } else { y });
            }
        }
    }

    #[test]
    fn exchanging_the_axes_changes_the_sign_of_kappa() {
        // x² + y² = 25 at (3, 4): κ < 0 of y = g(x), and of x = g(y) too, which the exchange would make > 0.
        let jet = Jet::of_polynomial(&circle(5), &[q(3, 1), q(4, 1)]);
        let [x, y] = [Axis::X, Axis::Y].map(|axis| graph(&jet, axis).expect("a graph").elements());
        assert_eq!((x.kappa.clone(), y.kappa.clone()), (Surd::from(q(-1, 5)), Surd::from(q(-1, 5))));
        assert_eq!(exchanged(y).kappa, -x.kappa);
        // At (5, 0) there is no graph over x.
        assert_eq!(graph(&Jet::of_polynomial(&circle(5), &[q(5, 1), q(0, 1)]), Axis::X), Err(NoGraph));
    }
}

mod cu_131 {
    use super::*;

    proptest! {
        /// (x, g(x)) as a parametrised curve.
        #[test]
        fn a_graph_has_the_elements_of_its_parametrisation(a in prop::collection::vec(-5..=5_i64, 0..5), x in parameter()) {
            let g = p(&a);
            let curve = RationalCurve::polynomial([p(&[0, 1]), g.clone()]);
            let slope = g.derivative().evaluate(&x);
            let second = g.derivative().derivative().evaluate(&x);
            let graph = isoracle::curvature::graph::Graph { slope, second };
            prop_assert_eq!(graph.elements(), elements_of(&curve, &x));
        }
    }
}

mod cu_132 {
    use super::*;

    proptest! {
        /// f(x + h, y + g_x h + g_xx h²/2) = f(x, y) modulo h³.
        #[test]
        fn the_graph_solves_the_equation_to_the_second_order(f in any_function(), at in prop::array::uniform2(parameter())) {
            let jet = Jet::of_polynomial(&f, &at);
            for (axis, [along, across]) in [(Axis::X, [0, 1]), (Axis::Y, [1, 0])] {
                let Ok(g) = graph(&jet, axis) else { continue };
                let mut path = [Polynomial::integer(0), Polynomial::integer(0)];
                path[along] = Polynomial::new(vec![at[along].clone(), q(1, 1)]);
                path[across] = Polynomial::new(vec![at[across].clone(), g.slope, g.second / 2_u32]);
                let along_path = f.evaluate_in(&path, |a| Polynomial::new(vec![a.clone()]));
                let coefficient = |n: usize| along_path.coefficients().get(n).cloned().unwrap_or_default();
                prop_assert_eq!((coefficient(1), coefficient(2)), (q(0, 1), q(0, 1)));
                // Only one g_xx does.
                path[across] = path[across].clone() + &p(&[0, 0, 1]);
                let other = f.evaluate_in(&path, |a| Polynomial::new(vec![a.clone()]));
                prop_assert!(other.coefficients().get(2).is_some_and(|a| !a.is_zero()));
            }
        }
    }
}

mod cu_133 {
    use super::*;

    #[test]
    fn below_the_circle_the_graph_runs_the_other_way() {
        // At (3, −4), f_y = −8: the graph has t = (4, 3)/5, (5) has t = (−4, −3)/5.
        let jet = Jet::of_polynomial(&circle(5), &[q(3, 1), q(-4, 1)]);
        let graph = graph(&jet, Axis::X).expect("a graph").elements();
        let level = level_elements(&jet).expect("a gradient");
        assert_eq!(graph.tangent.map(Surd::to_string), Vector(["4/5".to_string(), "3/5".to_string()]));
        assert_eq!(level.tangent.map(Surd::to_string), Vector(["-4/5".to_string(), "-3/5".to_string()]));
        assert_eq!(turned(graph), level);
    }

    proptest! {
        #[test]
        fn the_sign_of_f_y_is_the_direction(f in any_function(), at in prop::array::uniform2(parameter())) {
            let jet = Jet::of_polynomial(&f, &at);
            let Ok(graph) = graph(&jet, Axis::X).map(|g| g.elements()) else { return Ok(()) };
            let level = level_elements(&jet).expect("f_y is not 0");
            prop_assert_eq!(level, if jet.gradient[1] > 0 { graph } else { turned(graph) });
        }
    }
}

mod cu_134 {
    use super::*;

    #[test]
    fn the_printed_squares_have_changed_places() {
        // y = x² at its vertex: κ = 2, printed 0.
        let jet = |f: &[(i64, u32, u32)], at: [i64; 2]| Jet::of_polynomial(&function(f), &at.map(|x| q(x, 1)));
        let parabola = jet(&[(1, 0, 1), (-1, 2, 0)], [0, 0]);
        assert_eq!(level_elements(&parabola).expect("a gradient").kappa, Surd::from(q(2, 1)));
        assert_eq!(level_kappa_printed(&parabola).expect("a gradient"), Surd::from(q(0, 1)));
        assert_eq!(level_kappa_printed_first_minus(&parabola).expect("a gradient"), Surd::from(q(0, 1)));
        // x = y²: κ = −2 along t = (0, −1), printed 0. Circles do not show it, as f_xx = f_yy there.
        let sideways = jet(&[(1, 1, 0), (-1, 0, 2)], [0, 0]);
        assert_eq!(level_elements(&sideways).expect("a gradient").kappa, Surd::from(q(2, 1)));
        assert_eq!(level_kappa_printed(&sideways).expect("a gradient"), Surd::from(q(0, 1)));
        let circle = Jet::of_polynomial(&circle(5), &[q(3, 1), q(4, 1)]);
        assert_eq!(level_kappa_printed(&circle), level_elements(&circle).map(|e| e.kappa));
        // The other reading of the minus fails on the circle as well.
        assert_ne!(level_kappa_printed_first_minus(&circle), level_elements(&circle).map(|e| e.kappa));
        let flat = jet(&[(1, 2, 0)], [0, 0]);
        assert!(level_elements(&flat).is_err() && level_kappa_printed(&flat).is_err());
        assert!(level_kappa_printed_first_minus(&flat).is_err());
    }

    proptest! {
        /// The printed one is that of f(y, x), at (x, y) with the derivatives of f: right iff the difference is.
        #[test]
        fn the_printed_one_is_right_iff_the_difference_vanishes(f in any_function(), at in prop::array::uniform2(parameter())) {
            let jet = Jet::of_polynomial(&f, &at);
            let Ok(level) = level_elements(&jet) else { return Ok(()) };
            let [fx, fy] = jet.gradient.0.each_ref().map(|d| Rational::from(d.square_ref()));
            let difference = (jet.hessian.0[0][0].clone() - &jet.hessian.0[1][1]) * (fx - fy);
            prop_assert_eq!(level_kappa_printed(&jet).expect("a gradient") == level.kappa, difference.is_zero());
        }

        #[test]
        fn the_corrected_one_is_that_of_the_room(f in any_function(), at in prop::array::uniform2(parameter())) {
            use isoracle::curvature::implicit_curve::curvature;
            let jet = Jet::of_polynomial(&f, &at);
            let squared = level_elements(&jet).map(|e| (e.kappa.clone() * &e.kappa, e.kappa.sign()));
            prop_assert_eq!(squared, curvature(&jet).map(|c| (Surd::from(c.kappa_squared), c.kappa_sign)));
        }
    }
}

mod cu_135 {
    use super::*;

    #[test]
    fn the_exercise_can_be_done_for_3_4_and_the_vectors_of_5_only() {
        let jet = Jet::of_polynomial(&function(&[(1, 0, 1), (-1, 2, 0)]), &[q(0, 1), q(0, 1)]);
        let graph = graph(&jet, Axis::X).expect("f_y = 1").elements();
        let level = level_elements(&jet).expect("f_y = 1");
        assert_eq!((&graph.tangent, &graph.normal), (&level.tangent, &level.normal));
        assert_eq!(graph.kappa, level.kappa);
        assert_ne!(level_kappa_printed(&jet).expect("f_y = 1"), graph.kappa);
    }
}

mod cu_136 {
    use super::*;

    #[test]
    fn the_circle_of_the_exercise_has_the_other_sign() {
        let level = elements(&circle(5), [3, 4]);
        assert_eq!(level.tangent.map(Surd::to_string), Vector(["4/5".to_string(), "-3/5".to_string()]));
        assert_eq!(level.normal.map(Surd::to_string), Vector(["3/5".to_string(), "4/5".to_string()]));
        assert_eq!((level.kappa, circle_kappa_printed(&q(5, 1))), (Surd::from(q(-1, 5)), q(1, 5)));
    }

    proptest! {
        /// All circles, at all rational points, against the circle run through clockwise, t = (y, −x)/r.
        #[test]
        fn it_is_that_of_the_circle_run_through_clockwise(r in 1..9_i64, m in parameter()) {
            let scale = isoracle::linear::Matrix([[q(r, 1), q(0, 1)], [q(0, 1), q(r, 1)]]);
            let clockwise = rational_circle().moved(&scale, &Vector::zero()).reversed();
            let Vector([x, y]) = clockwise.point(&m).expect("no pole");
            let level = level_elements(&Jet::of_polynomial(&circle(r), &[x.clone(), y.clone()])).expect("a gradient");
            let expected = [Rational::from(&y / r), Rational::from(-&x) / r].map(Surd::from);
            prop_assert_eq!(&level.tangent, &Vector(expected));
            prop_assert_eq!(&level.kappa, &Surd::from(-circle_kappa_printed(&q(r, 1))));
            prop_assert_eq!(level, elements_of(&clockwise, &m));
        }
    }
}

mod cu_137 {
    use super::*;
    use isoracle::curvature::rational_curve::SingularParameters;

    #[test]
    fn a_regular_curve_may_be_a_level_set_with_gradient_0() {
        // (x² + y² − 1)² = 0 is the unit circle; x³ = 0 is the line (0, t).
        let square = circle(1) * &circle(1);
        let line = RationalCurve::polynomial([p(&[]), p(&[0, 1])]);
        for (f, curve) in [(square, rational_circle()), (function(&[(1, 3, 0)]), line)] {
            assert_eq!(curve.singular_parameters(), SingularParameters::At(Vec::new()));
            for m in [q(0, 1), q(1, 2), q(-7, 3)] {
                let Vector(at) = curve.point(&m).expect("no pole");
                let jet = Jet::of_polynomial(&f, &at);
                assert!(jet.value.is_zero() && level_elements(&jet).is_err());
            }
        }
    }

    proptest! {
        /// The other direction: with ∇f ≠ 0 there is a graph over one axis, and graphs are regular.
        #[test]
        fn with_a_gradient_there_is_a_graph(f in any_function(), at in prop::array::uniform2(parameter())) {
            let jet = Jet::of_polynomial(&f, &at);
            let is_graph = [Axis::X, Axis::Y].into_iter().any(|axis| graph(&jet, axis).is_ok());
            prop_assert_eq!(is_graph, level_elements(&jet).is_ok());
        }
    }
}

mod cu_138 {
    use super::*;

    proptest! {
        /// φ(f) = 2f + f³ and −f have the level curves of f.
        #[test]
        fn kappa_belongs_to_the_curve_and_its_direction(f in any_function(), at in prop::array::uniform2(parameter())) {
            let of = |f: &Function| level_elements(&Jet::of_polynomial(f, &at)).ok();
            let double = f.clone() + &f;
            let composed = double.clone() + &(f.clone() * &f * &f);
            prop_assert_eq!(of(&double), of(&f));
            prop_assert_eq!(of(&composed), of(&f));
            prop_assert_eq!(of(&-f.clone()), of(&f).map(turned));
            prop_assert_eq!(of(&(f.clone() - &Function::constant(q(7, 2)))), of(&f));
        }
    }
}
