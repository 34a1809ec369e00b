//! Regular surfaces, changes of parameters, functions and maps in charts.

use super::q;
use super::surface_samples::{basis, change, determinant, function, jets, pair, rotation, surface};
use isoracle::curvature::chart::{
    ChangeError, RationalPatch, change_of_parameters, composition, distance_squared, plane_as_graph, scaled_axes,
};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::{self, FundamentalForms, SurfaceError};
use isoracle::curvature::tangent::{TangentPlane, moved};
use isoracle::curvature::trigonometric::{Angle, Trigonometric, circle_point};
use isoracle::linear::{Matrix, Vector, determinant3};
use isoracle::number::{Multivariate, Rational, Ring};
use proptest::prelude::*;

fn vector(x: [i64; 3]) -> Vector<Rational, 3> {
    Vector(x.map(Rational::from))
}

fn polynomial(terms: &[([u32; 2], i64)]) -> Multivariate<2> {
    Multivariate::new(terms.iter().map(|(e, c)| (*e, q(*c, 1))))
}

mod cu_50 {
    use super::*;

    fn trigonometric() -> impl Strategy<Value = Multivariate<5>> {
        prop::collection::vec((prop::array::uniform5(0..=4_u32), -3..=3_i32), 0..5)
            .prop_map(|terms| Multivariate::new(terms.into_iter().map(|(e, c)| (e, Rational::from(c)))))
    }

    /// (cos θ, sin θ, cos φ, sin φ, r) at tan θ/2 = m, tan φ/2 = n.
    fn place(m: &Rational, n: &Rational) -> [Rational; 5] {
        let ([c, s], [d, t]) = (circle_point(m), circle_point(n));
        [c, s, d, t, q(3, 2)]
    }

    #[test]
    fn the_angles_are_on_their_circles() {
        for angle in Angle::BOTH {
            let (c, s) = (Trigonometric::<4>::cos(angle), Trigonometric::<4>::sin(angle));
            assert_eq!(c.clone() * &c + &(s.clone() * &s), Ring::integer(1));
            assert_eq!((c.derivative(angle), s.derivative(angle)), (-s.clone(), c));
            assert_ne!(s, Ring::integer(0));
        }
    }

    proptest! {
        #[test]
        fn the_normal_form_keeps_the_function(f in trigonometric(), m in -5..=5_i64, n in 1..=4_i64) {
            let at = place(&q(m, n), &q(n, 3));
            let reduced = Trigonometric::new(f.clone());
            prop_assert_eq!(reduced.evaluate(&at), f.evaluate(&at));
            prop_assert!(reduced.polynomial().terms().all(|(e, _)| e[1] < 2 && e[3] < 2));
        }

        /// With m = tan θ/2: d/dm = (dθ/dm) d/dθ, dθ/dm = 2/(1 + m²).
        #[test]
        fn the_derivative_is_that_along_the_rational_circle(f in trigonometric(), m in -5..=5_i64, d in 1..=4_i64) {
            let m = q(m, d);
            let [t] = Jet::<Rational, 1>::variables(std::slice::from_ref(&m).try_into().expect("one"));
            let one = Jet::integer(1);
            let square = t.clone() * &t;
            let scale = (one.clone() + &square).reciprocal().expect("1 + m² > 0");
            let [c, s] = [(one - &square) * &scale, t * &Jet::integer(2) * &scale];
            let rest = place(&m, &q(1, 2));
            let at =
                [c, s, Jet::constant(rest[2].clone()), Jet::constant(rest[3].clone()), Jet::constant(rest[4].clone())];
            let along = f.evaluate_in(&at, |x| Jet::constant(x.clone())).gradient[0].clone();
            let speed = q(2, 1) / (Rational::from(m.square_ref()) + 1_u32);
            prop_assert_eq!(Trigonometric::new(f).derivative(Angle::First).evaluate(&rest) * speed, along);
        }
    }
}

mod cu_51 {
    use super::*;

    fn jets_at(patch: &RationalPatch, u: &Rational) -> Result<TangentPlane, SurfaceError> {
        patch.tangent_plane(&[u.clone(), q(1, 3)])
    }

    #[test]
    fn the_conditions_are_independent() {
        // (u² − 1, u(u² − 1), v): injective differential, and a line of crossings.
        let node = RationalPatch::polynomial([
            polynomial(&[([2, 0], 1), ([0, 0], -1)]),
            polynomial(&[([3, 0], 1), ([1, 0], -1)]),
            Multivariate::variable(1),
        ]);
        for n in -40..=40 {
            assert!(jets_at(&node, &q(n, 8)).is_ok());
        }
        let value = |u: &Rational| node.jets(&[u.clone(), q(0, 1)]).expect("a polynomial").map(|x| x.value);
        assert_eq!(value(&q(1, 1)), value(&q(-1, 1)));
        // On u > −1 it is injective, and no homeomorphism: u → −1 leads to the point of u = 1.
        for k in 1..40_u32 {
            let near = Rational::from((1, 1_u64 << k));
            let squared = distance_squared(&value(&(near.clone() - 1_u32)), &value(&q(1, 1)));
            assert!(squared < near.square() * 16_u32);
        }
        // (u², u³, v): a homeomorphism, u = y/x, whose differential is not injective at u = 0.
        let cusp = RationalPatch::polynomial([
            polynomial(&[([2, 0], 1)]),
            polynomial(&[([3, 0], 1)]),
            Multivariate::variable(1),
        ]);
        assert_eq!(jets_at(&cusp, &q(0, 1)), Err(SurfaceError::Singular));
        for n in (-20..=20).filter(|n| *n != 0) {
            assert!(jets_at(&cusp, &q(n, 7)).is_ok());
            let [x, y, _] = cusp.jets(&[q(n, 7), q(0, 1)]).expect("a polynomial").map(|x| x.value);
            assert_eq!(y / x, q(n, 7));
        }
    }
}

mod cu_52 {
    use super::*;

    proptest! {
        #[test]
        fn the_sphere_s_coordinates_are_differentiable_together([u, v] in pair(), r in 1..=5_i64) {
            let sphere = RationalPatch::sphere(&q(r, 2)).jets(&[u, v]).expect("u² + v² + 1 > 0");
            let squares = distance_squared(&sphere, &Jet::<Rational, 2>::integer(0).into_three());
            prop_assert_eq!(squares, Jet::constant(q(r * r, 4)));
        }
    }

    trait Three: Sized + Clone {
        fn into_three(self) -> [Self; 3] {
            [self.clone(), self.clone(), self]
        }
    }
    impl Three for Jet<Rational, 2> {}

    #[test]
    fn a_pole_is_told() {
        let patch = RationalPatch { denominator: Multivariate::variable(0), ..RationalPatch::sphere(&q(1, 1)) };
        assert_eq!(patch.jets(&[q(0, 1), q(1, 1)]), Err(SurfaceError::Pole));
        assert_eq!(patch.tangent_plane(&[q(0, 1), q(1, 1)]), Err(SurfaceError::Pole));
    }
}

mod cu_53 {
    use super::*;

    #[test]
    fn the_product_is_zero_just_for_dependent_vectors() {
        let all = || (0..27_i64).map(|n| vector([n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1]));
        let zero = vector([0, 0, 0]);
        for (u, v) in all().flat_map(|u| all().map(move |v| (u.clone(), v))) {
            // With entries in {−1, 0, 1}, dependent vectors are 0, equal, or opposite.
            let dependent = u == zero || v == zero || u == v || u == -v.clone();
            let surface = jets(&zero, [&u, &v], [&zero, &zero, &zero]);
            assert_eq!(TangentPlane::new(&surface).is_err(), dependent);
        }
    }
}

mod cu_54 {
    use super::*;

    #[test]
    fn a_can_has_an_edge_and_a_cone_a_tip() {
        // At (1, 0, 1) the wall x² + y² = 1 and the lid z = 1 of a can have different tangent planes.
        let zero = vector([0, 0, 0]);
        let at = vector([1, 0, 1]);
        let wall = jets(&at, [&vector([0, 1, 0]), &vector([0, 0, 1])], [&vector([-1, 0, 0]), &zero, &zero]);
        let lid = jets(&at, [&vector([1, 0, 0]), &vector([0, 1, 0])], [&zero, &zero, &zero]);
        assert_eq!(change_of_parameters(&[q(0, 1), q(1, 1)], &wall, &lid), Err(ChangeError::TangentPlanes));
        // The cone (uc, us, u) at its tip.
        let [u, c, s] = [0, 1, 2].map(|i| Trigonometric::<5>::new([4, 0, 1].map(Multivariate::variable)[i].clone()));
        let sigma_phi = [c.clone(), s.clone()].map(|x| (u.clone() * &x).derivative(Angle::First));
        let at_tip = [q(3, 5), q(4, 5), q(1, 1), q(0, 1), q(0, 1)];
        assert!(sigma_phi.iter().all(|x| x.evaluate(&at_tip).is_zero()));
    }
}

mod cu_55 {
    use super::*;

    proptest! {
        #[test]
        fn every_plane_is_the_graph_over_two_axes(
            n in prop::array::uniform3(-3..=3_i64), d in -5..=5_i64, [u, v] in pair(),
        ) {
            let coefficients = n.map(|x| q(x, 1));
            let Some(patch) = plane_as_graph(&coefficients, &q(d, 1)) else {
                prop_assert_eq!(n, [0, 0, 0]);
                return Ok(());
            };
            let jets = patch.jets(&[u.clone(), v.clone()]).expect("a polynomial");
            let point = Vector(jets.each_ref().map(|x| x.value.clone()));
            prop_assert_eq!(point.dot(&Vector(coefficients.clone())), q(d, 1));
            let [su, sv] = basis(&jets);
            if n[2] != 0 {
                // σ = (u, v, Au + Bv + C), σ⁻¹ = (x, y).
                let [a, b] = [0, 1].map(|i| -q(n[i], n[2]));
                prop_assert_eq!([&point[0], &point[1]], [&u, &v]);
                prop_assert_eq!((su, sv), (Vector([q(1, 1), q(0, 1), a]), Vector([q(0, 1), q(1, 1), b])));
            } else {
                // No such A, B, C: the plane has points above each other.
                let up = vector([0, 0, 1]);
                prop_assert!(up.dot(&Vector(coefficients)).is_zero());
                prop_assert!(patch.tangent_plane(&[u, v]).expect("regular").coordinates(&up).is_ok());
            }
        }
    }
}

mod cu_56 {
    use super::*;

    proptest! {
        #[test]
        fn a_graph_is_regular_everywhere(
            terms in prop::collection::vec((prop::array::uniform2(0..=3_u32), -4..=4_i64), 0..6), at in pair(),
        ) {
            let f = Multivariate::new(terms.into_iter().map(|(e, c)| (e, q(c, 1))));
            let patch = RationalPatch::graph(f.clone());
            prop_assert!(patch.tangent_plane(&at).is_ok());
            let slope = |axis: usize| f.derivative(axis).evaluate(&at).square();
            let w_squared = FundamentalForms::new(&patch.jets(&at).expect("a polynomial")).w_squared();
            prop_assert_eq!(w_squared, slope(0) + slope(1) + 1_u32);
        }
    }
}

mod cu_57 {
    use super::*;

    proptest! {
        #[test]
        fn rigid_motions_change_nothing(s in surface(), a in rotation(), b in prop::array::uniform3(-3..=3_i64)) {
            prop_assert_eq!(determinant3(&a), q(1, 1));
            let there = moved(&s, &a, &vector(b));
            let [here, there] = [&s, &there].map(|s| parametric_surface::curvature(s).expect("regular"));
            prop_assert_eq!(&here.forms.first, &there.forms.first);
            prop_assert_eq!(&here.forms.second_w, &there.forms.second_w);
            prop_assert_eq!(
                (here.gaussian, here.mean_squared, here.mean_sign),
                (there.gaussian, there.mean_squared, there.mean_sign)
            );
        }

        #[test]
        fn reflections_change_the_sign_of_h(s in surface(), a in rotation()) {
            let mirrored = moved(&s, &Matrix::from_fn(|i, j| -a.0[i][j].clone()), &vector([1, 2, 3]));
            let [here, there] = [&s, &mirrored].map(|s| parametric_surface::curvature(s).expect("regular"));
            prop_assert_eq!(&here.forms.first, &there.forms.first);
            prop_assert_eq!(here.forms.second_w.map(|x| -x), there.forms.second_w);
            prop_assert_eq!(
                (here.gaussian, here.mean_squared, -here.mean_sign),
                (there.gaussian, there.mean_squared, there.mean_sign)
            );
        }
    }
}

mod cu_58 {
    use super::*;

    /// σ taken at (0, 0), reached by h.
    fn reparametrised(s: &[Jet<Rational, 2>; 3], h: &[Jet<Rational, 2>; 2]) -> [Jet<Rational, 2>; 3] {
        s.each_ref().map(|x| composition(x, h))
    }

    proptest! {
        #[test]
        fn the_change_is_found_and_has_an_inverse(s in surface(), h in change()) {
            let at = h.each_ref().map(|x| x.value.clone());
            let t = reparametrised(&s, &h);
            let found = change_of_parameters(&at, &s, &t).expect("one surface");
            prop_assert_eq!(&found, &h);
            let origin = [q(0, 1), q(0, 1)];
            let back = change_of_parameters(&origin, &t, &s).expect("one surface");
            prop_assert_eq!(back.each_ref().map(|x| composition(x, &h)), Jet::variables(&origin));
            prop_assert!(!determinant(&back).is_zero());
        }

        #[test]
        fn what_differs_is_told(s in surface(), h in change(), i in 0..3_usize, order in 0..3_usize) {
            let at = h.each_ref().map(|x| x.value.clone());
            let mut t = reparametrised(&s, &h);
            let normal = TangentPlane::new(&s).expect("regular").normal_w();
            for (x, n) in t.iter_mut().zip(&normal.0) {
                match order {
                    0 => x.value += n,
                    1 => x.gradient.0[i % 2] += n,
                    _ => x.hessian.0[i / 2][i / 2] += n,
                }
            }
            let expected = [ChangeError::Points, ChangeError::TangentPlanes, ChangeError::SecondOrder][order];
            prop_assert_eq!(change_of_parameters(&at, &s, &t), Err(expected));
        }
    }

    #[test]
    fn a_singular_parametrisation_has_no_change() {
        let zero = vector([0, 0, 0]);
        let s = jets(&zero, [&vector([1, 0, 0]), &vector([0, 1, 0])], [&zero, &zero, &zero]);
        let bad = jets(&zero, [&vector([1, 0, 0]), &vector([2, 0, 0])], [&zero, &zero, &zero]);
        let origin = [q(0, 1), q(0, 1)];
        for (a, b) in [(&s, &bad), (&bad, &s)] {
            assert_eq!(change_of_parameters(&origin, a, b), Err(ChangeError::Surface(SurfaceError::Singular)));
        }
    }

    #[test]
    fn the_two_stereographic_charts_differ_by_an_inversion() {
        // From the south pole: (2u, 2v, 1 − u² − v²)/(1 + u² + v²); h = (u, v)/(u² + v²).
        for (u, v) in [(q(1, 2), q(-2, 3)), (q(3, 1), q(0, 1)), (q(1, 1), q(1, 1))] {
            let [x, y] = Jet::variables(&[u.clone(), v.clone()]);
            let scale = (x.clone() * &x + &(y.clone() * &y)).reciprocal().expect("not the pole");
            let h = [x * &scale, y * &scale];
            let mut south = RationalPatch::sphere(&q(2, 1));
            south.numerators[2] = -south.numerators[2].clone();
            let at = h.each_ref().map(|x| x.value.clone());
            let sigma = RationalPatch::sphere(&q(2, 1)).jets(&at).expect("no pole");
            assert_eq!(change_of_parameters(&at, &sigma, &south.jets(&[u, v]).expect("no pole")), Ok(h));
        }
    }
}

mod cu_59 {
    use super::*;
    use isoracle::curvature::gauss_map::ShapeOperator;
    use isoracle::number::Sign;

    proptest! {
        #[test]
        fn curvatures_and_dn_are_those_of_the_surface(s in surface(), h in change()) {
            let t = s.each_ref().map(|x| composition(x, &h));
            let det = determinant(&h);
            let sign = Sign::of(det.cmp0());
            let [here, there] = [&s, &t].map(|s| parametric_surface::curvature(s).expect("regular"));
            prop_assert_eq!(&here.gaussian, &there.gaussian);
            prop_assert_eq!(&here.mean_squared, &there.mean_squared);
            prop_assert_eq!(here.mean_sign * sign, there.mean_sign);
            // I′ = JᵀIJ, W′ = |det J|W, and J(−dN)′ = ±(−dN)J.
            let j = Matrix::from_fn(|a, i| h[a].gradient[i].clone());
            let gram = |s| TangentPlane::new(s).expect("regular").gram();
            prop_assert_eq!(gram(&t), j.transposed().times(&gram(&s)).times(&j));
            prop_assert_eq!(&there.w_squared, &(Rational::from(det.square_ref()) * &here.w_squared));
            let operator = |forms| ShapeOperator::new(forms).expect("regular").matrix_w();
            // W and W′ are in the same field, W′ = |det|W; with its sign det W.
            let scaled = operator(&here.forms).times(&j);
            let scaled = Matrix::from_fn(|a, i| Rational::from(&scaled.0[a][i] * &det));
            prop_assert_eq!(j.times(&operator(&there.forms)), scaled);
        }
    }
}

mod cu_60 {
    use super::*;

    proptest! {
        #[test]
        fn a_function_in_one_chart_is_that_in_the_other(f in function(), s in surface(), h in change()) {
            let t = s.each_ref().map(|x| composition(x, &h));
            let embed = |x: &Rational| Jet::constant(x.clone());
            prop_assert_eq!(f.evaluate_in(&t, embed), composition(&f.evaluate_in(&s, embed), &h));
        }
    }

    #[test]
    fn a_function_on_an_open_part_need_not_extend() {
        // 1/z on the part z ≠ 0 of the sphere.
        let height = |u: i64| RationalPatch::sphere(&q(1, 1)).jets(&[q(u, 1), q(0, 1)]).expect("no pole")[2].clone();
        assert!(height(2).reciprocal().is_some());
        assert_eq!(height(1).reciprocal(), None);
    }
}

mod cu_61 {
    use super::*;

    proptest! {
        #[test]
        fn the_distance_squared_is_differentiable_on_every_surface(
            s in surface(), p in prop::array::uniform3(-4..=4_i64),
        ) {
            let jet = distance_squared(&s, &p.map(|x| Jet::constant(q(x, 1))));
            let away = Vector(s.each_ref().map(|x| x.value.clone())) - &vector(p);
            prop_assert_eq!(&jet.value, &away.norm_squared());
            let basis = basis(&s);
            for i in 0..2 {
                prop_assert_eq!(&jet.gradient[i], &(away.dot(&basis[i]) * 2_u32));
                for j in 0..2 {
                    let second = Vector(s.each_ref().map(|x| x.hessian.0[i][j].clone()));
                    prop_assert_eq!(&jet.hessian.0[i][j], &((away.dot(&second) + basis[i].dot(&basis[j])) * 2_u32));
                }
            }
        }
    }
}

mod cu_62 {
    use super::*;

    /// σ₂⁻¹ = (x, y)/(1 − z) of the stereographic chart, after φ∘σ₁.
    fn in_chart([x, y, z]: [Jet<Rational, 2>; 3]) -> Option<[Jet<Rational, 2>; 2]> {
        let scale = (Jet::integer(1) - &z).reciprocal()?;
        Some([x * &scale, y * &scale])
    }

    #[test]
    fn the_image_of_the_chart_has_to_lie_in_the_other() {
        let mut south = RationalPatch::sphere(&q(1, 1));
        south.numerators[2] = -south.numerators[2].clone();
        // The identity of the sphere: (0, 0) of the southern chart is the north pole, which σ₂ does not reach.
        assert_eq!(in_chart(south.jets(&[q(0, 1), q(0, 1)]).expect("no pole")), None);
        let at = [q(1, 2), q(1, 3)];
        let [x, y] = Jet::variables(&at);
        let scale = (x.clone() * &x + &(y.clone() * &y)).reciprocal().expect("not 0");
        assert_eq!(in_chart(south.jets(&at).expect("no pole")), Some([x * &scale, y * &scale]));
    }
}

mod cu_63 {
    use super::*;

    proptest! {
        #[test]
        fn the_sphere_goes_onto_the_ellipsoid(
            at in pair(), axes in prop::array::uniform3((-4..=4_i64).prop_filter("not 0", |x| *x != 0)),
        ) {
            let axes = axes.map(|x| Jet::constant(q(x, 3)));
            let sphere = RationalPatch::sphere(&q(1, 1)).jets(&at).expect("no pole");
            let image = scaled_axes(&sphere, &axes);
            let quotient = |i: usize| image[i].clone() * &axes[i].reciprocal().expect("not 0");
            let sum = (0..3).fold(Jet::integer(0), |sum, i| sum + &(quotient(i) * &quotient(i)));
            prop_assert_eq!(sum, Jet::integer(1));
            // Onto: each point comes from the one divided by the axes. The image is regular.
            prop_assert_eq!(std::array::from_fn::<_, 3, _>(quotient), sphere);
            prop_assert!(TangentPlane::new(&image).is_ok());
        }
    }

    #[test]
    fn an_axis_0_makes_a_disc() {
        let sphere = RationalPatch::sphere(&q(1, 1)).jets(&[q(1, 1), q(0, 1)]).expect("no pole");
        let flat = scaled_axes(&sphere, &[q(1, 1), q(1, 1), q(0, 1)].map(Jet::constant));
        assert_eq!(TangentPlane::new(&flat), Err(SurfaceError::Singular));
    }
}
