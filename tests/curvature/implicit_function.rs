//! The implicit function theorem, with its neighbourhoods.

use super::level::{point, polynomial, sphere, terms};
use super::q;
use isoracle::curvature::implicit_function::{GraphBox, chart, graph_box};
use isoracle::curvature::implicit_graph::GraphError;
use isoracle::curvature::jet::Jet;
use isoracle::number::{Algebraic, Multivariate, Polynomial, Rational, real_roots};
use proptest::prelude::*;

/// The points of the level set over a point that lie in W, counted by Sturm's theorem on the restriction.
fn heights_in_box<const N: usize>(
    f: &Multivariate<N>,
    at: &[Rational; N],
    graph: &GraphBox<N>,
    over: &[Rational; N],
) -> Vec<Algebraic> {
    let axis = graph.axis();
    let along = std::array::from_fn(|i| match i == axis {
        true => Polynomial::new(vec![q(0, 1), q(1, 1)]),
        false => Polynomial::new(vec![over[i].clone()]),
    });
    let constant = Polynomial::new(vec![f.evaluate(at)]);
    let restricted = f.evaluate_in(&along, |c| Polynomial::new(vec![c.clone()])) - &constant;
    let [lo, hi] = [-1, 1].map(|s| Algebraic::from(at[axis].clone() + Rational::from(graph.height_radius() * s)));
    let roots = real_roots(&restricted).expect("not constant in the box");
    roots.into_iter().filter(|root| lo < *root && *root < hi).collect()
}

/// Points of V: the corners, the middle, and one between.
fn points_over<const N: usize>(at: &[Rational; N], graph: &GraphBox<N>) -> Vec<[Rational; N]> {
    let offsets = [[-1, -1], [-1, 1], [1, -1], [1, 1], [0, 0]].map(|o| o.map(|n| q(n, 1)));
    let offsets = offsets.into_iter().chain([[q(1, 3), q(-2, 7)]]);
    offsets.map(|o| std::array::from_fn(|i| at[i].clone() + Rational::from(graph.base_radius() * &o[i % 2]))).collect()
}

fn is_a_graph<const N: usize>(
    f: &Multivariate<N>,
    at: &[Rational; N],
    graph: &GraphBox<N>,
) -> Result<(), TestCaseError> {
    for over in points_over(at, graph) {
        let heights = heights_in_box(f, at, graph, &over);
        prop_assert_eq!(heights.len(), 1);
        prop_assert_eq!(graph.height(&over), heights.first().cloned());
    }
    prop_assert_eq!(graph.height(at).expect("over the middle"), Algebraic::from(at[graph.axis()].clone()));
    Ok(())
}

mod cu_143 {
    use super::*;

    #[test]
    fn over_the_projection_of_u_there_is_no_function() {
        // U = ℝ³, the unit sphere at its north pole: (2, 0) lies in the projection of U, and no point of the sphere over it.
        let north = [q(0, 1), q(0, 1), q(1, 1)];
        let graph = graph_box(&sphere(), &north, 2).expect("f_z = 2");
        let far = [q(2, 1), q(0, 1), q(0, 1)];
        assert_eq!(graph.height(&far), None);
        let over = Polynomial::new(vec![q(3, 1), q(0, 1), q(1, 1)]);
        assert!(real_roots(&over).expect("not zero").is_empty());
        // Over V the sphere has two points, and one of them in W.
        let near = [Rational::from(graph.base_radius()), q(0, 1), q(0, 1)];
        assert!(graph.height(&near).is_some());
    }

    #[test]
    fn without_a_slope_there_is_no_box() {
        let east = [q(1, 1), q(0, 1), q(0, 1)];
        assert_eq!(graph_box(&sphere(), &east, 2), Err(GraphError::Vertical));
        assert_eq!(graph_box(&sphere(), &[q(0, 1), q(0, 1), q(0, 1)], 2), Err(GraphError::Singular));
    }
}

mod cu_144 {
    use super::*;

    proptest! {
        #[test]
        fn the_theorem_holds_for_curves_and_in_four_variables(
            a in prop::array::uniform5(-3..=3_i64), x in -2..=2_i64, y in -2..=2_i64,
        ) {
            let [a, b, c, d, e] = a;
            let plane = terms(&[([2, 0], a), ([1, 1], b), ([0, 3], c), ([0, 1], d), ([1, 0], e)]);
            let at = [x, y].map(Rational::from);
            if let Ok(graph) = graph_box(&plane, &at, 1) {
                is_a_graph(&plane, &at, &graph)?;
            }
            let four = terms(&[([2, 0, 1, 0], a), ([0, 1, 0, 1], b), ([0, 0, 2, 2], c), ([0, 0, 0, 1], d), ([1, 0, 0, 0], e)]);
            let at = [x, y, y, x].map(Rational::from);
            if let Ok(graph) = graph_box(&four, &at, 3) {
                is_a_graph(&four, &at, &graph)?;
            }
        }
    }

    #[test]
    fn a_parabola_is_a_graph_over_one_axis() {
        let f = terms(&[([0, 1], 1), ([2, 0], -1)]);
        let at = [q(0, 1), q(0, 1)];
        assert!(graph_box(&f, &at, 1).is_ok());
        assert_eq!(graph_box(&f, &at, 0), Err(GraphError::Vertical));
    }
}

mod cu_145 {
    use super::*;

    proptest! {
        #[test]
        fn over_each_point_of_v_there_is_one_in_w(f in polynomial(), at in point(), axis in 0..3_usize) {
            match graph_box(&f, &at, axis) {
                Ok(graph) => is_a_graph(&f, &at, &graph)?,
                Err(_) => prop_assert!(Jet::of_polynomial(&f, &at).gradient[axis].is_zero()),
            }
        }
    }

    #[test]
    fn near_a_singular_point_the_box_is_small() {
        // z(z − 2⁻²⁰): the two sheets z = 0 and z = 2⁻²⁰ are not in one box.
        let hair = Rational::from((1, 1_u32 << 20));
        let f = Multivariate::new([([0, 0, 2], q(1, 1)), ([0, 0, 1], -hair.clone())]);
        let graph = graph_box(&f, &[q(0, 1), q(0, 1), q(0, 1)], 2).expect("f_z ≠ 0");
        assert!(*graph.height_radius() < hair);
    }
}

mod cu_147 {
    use super::*;

    #[test]
    fn around_every_point_of_a_sphere_there_is_a_chart() {
        let mut axes = Vec::new();
        for (m, n) in [(0, 0), (1, 0), (0, 2), (3, 1), (-2, 5)] {
            let scale = q(1, m * m + n * n + 1);
            let at = [2 * m, 2 * n, m * m + n * n - 1].map(|x| Rational::from(&scale * x));
            let graph = chart(&sphere(), &at).expect("1 is a regular value");
            is_a_graph(&sphere(), &at, &graph).expect("a graph");
            axes.push(graph.axis());
        }
        axes.sort_unstable();
        axes.dedup();
        assert_eq!(axes, [0, 1, 2]);
    }

    #[test]
    fn at_the_apex_of_a_cone_there_is_none() {
        let cone = terms(&[([2, 0, 0], 1), ([0, 2, 0], 1), ([0, 0, 2], -1)]);
        assert!(chart(&cone, &[q(0, 1), q(0, 1), q(0, 1)]).is_err());
    }
}

mod cu_153 {
    use super::*;

    proptest! {
        #[test]
        fn where_the_gradient_is_not_zero_some_axis_will_do(f in polynomial(), at in point()) {
            let gradient = Jet::of_polynomial(&f, &at).gradient;
            match chart(&f, &at) {
                Ok(graph) => {
                    prop_assert!(!gradient[graph.axis()].is_zero());
                    let largest = &gradient[graph.axis()];
                    prop_assert!(gradient.0.iter().all(|g| g.cmp_abs(largest).is_le()));
                }
                Err(_) => prop_assert!(gradient.norm_squared().is_zero()),
            }
        }
    }
}
