//! Level sets of polynomials, certified cell by cell.

use isoracle::isosurface::adaptive::*;
use isoracle::isosurface::bernstein::{Bernstein, Extent, Part, Region};
use isoracle::isosurface::cell::{self, Tie};
use isoracle::isosurface::cube::{Corner, Edge};
use isoracle::isosurface::topology::{SurfaceComponent, topology};
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::number::Trivariate;
use isoracle::number::{Integer, Polynomial, Rational, Ring, Sign, SturmChain};
use proptest::prelude::*;

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn constant(numerator: i64, denominator: i64) -> Trivariate {
    Trivariate::constant(q(numerator, denominator))
}

fn xyz() -> [Trivariate; 3] {
    [0, 1, 2].map(Trivariate::variable)
}

fn square(f: &Trivariate) -> Trivariate {
    f.clone() * f
}

fn cube(low: Rational, high: Rational) -> Region {
    Region::new([low.clone(), low.clone(), low], [high.clone(), high.clone(), high]).expect("low < high")
}

/// (x − a)² + (y − b)² + (z − c)² − r².
fn sphere(centre: [Rational; 3], radius: Rational) -> Trivariate {
    let squares = (0..3).map(|i| square(&(Trivariate::variable(i) - &Trivariate::constant(centre[i].clone()))));
    squares.fold(Trivariate::integer(0), |sum, f| sum + &f) - &Trivariate::constant(Rational::from(radius.square_ref()))
}

fn unit_sphere() -> Trivariate {
    sphere([q(0, 1), q(0, 1), q(0, 1)], q(1, 1))
}

/// (x² + y² + z² + R² − r²)² − 4R²(x² + y²), r² given.
fn torus(big: Rational, small_squared: Rational) -> Trivariate {
    let [x, y, z] = xyz();
    let flat = square(&x) + &square(&y);
    let big_squared = Rational::from(big.square_ref());
    let offset = Trivariate::constant(Rational::from(&big_squared - &small_squared));
    square(&(flat.clone() + &square(&z) + &offset)) - &(flat * &Trivariate::constant(big_squared * 4))
}

/// A figure eight y² = x²(1 − x²) in the plane z = 0, thickened: (y² − x² + x⁴)² + z².
fn eight() -> Trivariate {
    let [x, y, z] = xyz();
    square(&(square(&y) - &square(&x) + &square(&square(&x)))) + &square(&z)
}

fn component(chi: i64, boundary_loops: i64, genus: i64) -> SurfaceComponent {
    SurfaceComponent { chi, boundary_loops, genus }
}

/// Adapts, and checks leaves against other derivations.
fn adapted(f: &Trivariate, isovalue: Rational, region: Region, refinement: Refinement) -> Adapted {
    let adapted = adapt(f, &isovalue, region.clone(), &refinement).expect("a function to adapt to");
    let census = adapted.census();
    let total = census.empty.volume + census.simple.volume + census.uncertified.volume;
    assert_eq!(total, region.volume());
    let level = f.clone() - &Trivariate::constant(isovalue);
    // Some hundreds of them, spread over all.
    for leaf in adapted.leaves().iter().step_by(1 + adapted.leaves().len() / 700) {
        check_leaf(&level, leaf, &adapted.cell(leaf));
    }
    adapted
}

fn check_leaf(level: &Trivariate, leaf: &Leaf, cell: &Region) {
    let corners = Corner::ALL.map(|c| level.evaluate(&cell.corner(c)));
    match leaf.verdict {
        Verdict::Empty(sign) => {
            for n in 0..27 {
                let at = cell.point(&[n % 3, n / 3 % 3, n / 9].map(|i| q(i, 2)));
                assert_eq!(Sign::of(level.evaluate(&at).cmp0()), sign);
            }
        }
        Verdict::Simple { positive, axis } => {
            // The trilinear function with these corner values makes the same disk.
            let trilinear = cell::topology(&corners, &Rational::new(), Tie::Degenerate).expect("no tie");
            assert_eq!(trilinear.decisions.positive, positive);
            assert_eq!((trilinear.loops.len(), trilinear.components.len(), trilinear.chi()), (1, 1, 1));
            // By Sturm's theorem, each edge is crossed as often as its corners say.
            for edge in Edge::ALL {
                let [a, b] = edge.corners();
                let crossed = (positive & a.bit() != 0) != (positive & b.bit() != 0);
                assert_eq!(roots_between(level, &cell.corner(a), &cell.corner(b)), usize::from(crossed));
            }
            // And each line along the axis at most once.
            for n in 1..3 {
                let mut ends = [0, 1].map(|_| [q(n, 3), q(3 - n, 4), q(2 * n, 7)]);
                for (end, at) in ends.iter_mut().enumerate() {
                    at[axis] = Rational::from(end);
                }
                let [a, b] = ends.map(|at| cell.point(&at));
                assert!(roots_between(level, &a, &b) <= 1);
            }
        }
        Verdict::Uncertified(_) => {}
    }
}

/// How many zeros f has on the segment, by its restriction and Sturm's theorem.
fn roots_between(f: &Trivariate, a: &[Rational; 3], b: &[Rational; 3]) -> usize {
    // f(a + t(b − a)) by powers of t.
    let times = |f: &[Rational], g: &[Rational]| {
        let mut product = vec![Rational::new(); f.len() + g.len() - 1];
        for (i, f) in f.iter().enumerate() {
            for (j, g) in g.iter().enumerate() {
                product[i + j] += Rational::from(f * g);
            }
        }
        product
    };
    let mut restricted = vec![Rational::new(); 1];
    for (exponents, coefficient) in f.terms() {
        let mut term = vec![coefficient.clone()];
        for axis in 0..3 {
            let line = [a[axis].clone(), Rational::from(&b[axis] - &a[axis])];
            for _ in 0..exponents[axis] {
                term = times(&term, &line);
            }
        }
        restricted.resize(restricted.len().max(term.len()), Rational::new());
        for (sum, term) in restricted.iter_mut().zip(term) {
            *sum += term;
        }
    }
    let chain = SturmChain::new(&Polynomial::new(restricted)).expect("f does not vanish on the segment");
    chain.count(&Rational::new(), &Rational::from(1))
}

/// The components by sampling on a uniform grid of n cells an axis and the trilinear surface of the samples.
fn sampled(f: &Trivariate, isovalue: Rational, region: &Region, n: usize) -> Vec<SurfaceComponent> {
    let at = |i: usize| q(i as i64, n as i64);
    let side = n + 1;
    let values = (0..side * side * side)
        .map(|s| f.evaluate(&region.point(&[at(s % side), at(s / side % side), at(s / side / side)])))
        .collect();
    let volume = Volume::rationals([side; 3], values).expect("a volume");
    topology(&Level { volume: &volume, isovalue, tie: Tie::Below }).expect("ties are broken").components
}

mod forms {
    use super::*;

    fn polynomial() -> impl Strategy<Value = Trivariate> {
        proptest::collection::vec(((0u32..4, 0u32..3, 0u32..4), -9i64..=9), 1..8)
            .prop_map(|terms| Trivariate::new(terms.into_iter().map(|((i, j, k), c)| ([i, j, k], Rational::from(c)))))
    }

    fn region() -> impl Strategy<Value = Region> {
        (proptest::array::uniform3(-6i64..6), proptest::array::uniform3(1i64..9)).prop_map(|(low, width)| {
            let low = low.map(|n| q(n, 3));
            let high = [0, 1, 2].map(|i| low[i].clone() + q(width[i], 4));
            Region::new(low, high).expect("a width is positive")
        })
    }

    /// A point of a part of the box.
    fn within(part: Part, shares: [Rational; 3]) -> [Rational; 3] {
        let mut shares = shares;
        for (share, extent) in shares.iter_mut().zip(part.0) {
            match extent {
                Extent::Low => *share = Rational::new(),
                Extent::High => *share = Rational::from(1),
                Extent::Across => {}
            }
        }
        shares
    }

    proptest! {
        #[test]
        fn a_certified_sign_is_the_sign_of_the_function_and_of_its_derivative(
            f in polynomial(), region in region(), shares in proptest::array::uniform3(0i64..=5)
        ) {
            let form = Bernstein::of(&f, &region);
            let sign = |f: &Trivariate, at: &[Rational; 3]| Sign::of(f.evaluate(at).cmp0());
            for part in Part::all() {
                let at = region.point(&within(part, shares.map(|n| q(n, 5))));
                if let Some(certified) = form.sign(part) {
                    prop_assert_eq!(sign(&f, &at), certified);
                }
                for axis in part.axes() {
                    if let Some(certified) = form.slope(part, axis) {
                        // The ends too: the differences are all the coefficients of the derivative.
                        prop_assert_eq!(sign(&f.derivative(axis), &at), certified);
                    }
                }
                if part.dimension() == 0 {
                    let certified = form.sign(part).unwrap_or(Sign::Zero);
                    prop_assert_eq!(sign(&f, &at), certified);
                }
            }
        }

        #[test]
        fn the_form_of_a_part_of_a_box_is_split_from_that_of_the_box(
            f in polynomial(), region in region(), p in 1i64..7
        ) {
            let split = Bernstein::of(&f, &region).split(&Integer::from(p), &Integer::from(7));
            for (c, form) in Corner::ALL.into_iter().zip(split) {
                let child = Bernstein::of(&f, &region.child(c, &q(p, 7)));
                for part in Part::all() {
                    prop_assert_eq!(form.sign(part), child.sign(part));
                    for axis in 0..3 {
                        prop_assert_eq!(form.slope(part, axis), child.slope(part, axis));
                    }
                }
            }
        }

        #[test]
        fn polynomials_are_a_ring_of_functions_with_a_product_rule(
            f in polynomial(), g in polynomial(), at in proptest::array::uniform3(-5i64..=5)
        ) {
            let at = at.map(|n| q(n, 2));
            let (fx, gx) = (f.evaluate(&at), g.evaluate(&at));
            prop_assert_eq!((f.clone() + &g).evaluate(&at), fx.clone() + &gx);
            prop_assert_eq!((f.clone() - &g).evaluate(&at), fx.clone() - &gx);
            prop_assert_eq!((f.clone() * &g).evaluate(&at), fx * gx);
            prop_assert!((f.clone() - &f).is_zero());
            for axis in 0..3 {
                let product = f.derivative(axis) * &g + &(g.derivative(axis) * &f);
                prop_assert_eq!((f.clone() * &g).derivative(axis), product);
            }
        }
    }

    #[test]
    fn the_parts_of_a_cell_are_8_corners_12_edges_6_faces_and_itself() {
        let parts = Part::all();
        let count = |d: usize| parts.iter().filter(|part| part.dimension() == d).count();
        assert_eq!([0, 1, 2, 3].map(count), [8, 12, 6, 1]);
        assert!(parts.iter().all(|part| part.corners().count_ones() == 1 << part.dimension()));
        assert!(parts.iter().all(|part| part.axes().count() == part.dimension()));
    }
}

mod surfaces {
    use super::*;

    #[test]
    fn a_sphere_has_chi_2() {
        let region = cube(q(-9, 7), q(4, 3));
        let adapted = adapted(&unit_sphere(), q(0, 1), region.clone(), Refinement::halving(18));
        assert_eq!(adapted.topology(), Some(vec![component(2, 0, 0)]));
        assert_eq!(adapted.chi(), Some(2));
        assert_eq!(sampled(&unit_sphere(), q(0, 1), &region, 11), [component(2, 0, 0)]);
    }

    #[test]
    fn a_torus_has_chi_0() {
        let f = torus(q(1, 1), q(1, 9));
        let region = Region::new([q(-13, 9), q(-17, 12), q(-5, 9)], [q(19, 13), q(10, 7), q(4, 7)]).expect("a box");
        let adapted = adapted(&f, q(0, 1), region.clone(), Refinement::halving(18));
        assert_eq!(adapted.topology(), Some(vec![component(0, 0, 1)]));
        assert_eq!(sampled(&f, q(0, 1), &region, 16), [component(0, 0, 1)]);
    }

    #[test]
    fn a_thick_figure_eight_has_genus_2_and_its_holes_close_at_one_sixteenth() {
        // On the axis of a hole, f ≥ (x² − x⁴)² = 1/16 at x² = 1/2: below that level a hole, above it none.
        let region = Region::new([q(-11, 8), q(-10, 11), q(-3, 7)], [q(18, 13), q(8, 9), q(5, 12)]).expect("a box");
        let at = |level: Rational| adapted(&eight(), level, region.clone(), Refinement::halving(18)).topology();
        assert_eq!(at(q(1, 40)), Some(vec![component(-2, 0, 2)]));
        assert_eq!(at(q(1, 12)), Some(vec![component(2, 0, 0)]));
        assert_eq!(sampled(&eight(), q(1, 40), &region, 20), [component(-2, 0, 2)]);
    }

    #[test]
    fn two_near_spheres_are_two_and_a_neck_makes_them_one() {
        // The product of two unit spheres' equations, their poles 1/16 apart: at the origin it is
        // ((33/32)² − 1)² = (65/1024)².
        let at = |x: Rational| sphere([x, q(0, 1), q(0, 1)], q(1, 1));
        let f = at(q(-33, 32)) * &at(q(33, 32));
        let region = Region::new([q(-22, 10), q(-13, 11), q(-8, 7)], [q(23, 10), q(9, 7), q(17, 13)]).expect("a box");
        let level = |c: Rational, depth| adapted(&f, c, region.clone(), Refinement::halving(depth));
        assert_eq!(level(q(0, 1), 18).topology(), Some(vec![component(2, 0, 0); 2]));
        let critical = q(65 * 65, 1024 * 1024);
        assert_eq!(level(critical.clone() + q(1, 200), 18).topology(), Some(vec![component(2, 0, 0)]));
        // At the level itself the two touch: whatever the depth, what holds the origin is not certified.
        for depth in [4, 6] {
            let touching = level(critical.clone(), depth);
            assert_eq!(touching.topology(), None);
            assert_holds_an_uncertified(&touching, &[q(0, 1), q(0, 1), q(0, 1)]);
        }
    }

    fn holds(cell: &Region, point: &[Rational; 3]) -> bool {
        (0..3).all(|i| cell.low()[i] <= point[i] && point[i] <= cell.high()[i])
    }

    fn assert_holds_an_uncertified(adapted: &Adapted, point: &[Rational; 3]) {
        for leaf in adapted.leaves().iter().filter(|leaf| holds(&adapted.cell(leaf), point)) {
            assert!(matches!(leaf.verdict, Verdict::Uncertified(_)), "{leaf:?}");
        }
    }

    #[test]
    fn a_cone_is_certified_but_for_few_cells_about_its_apex() {
        let [x, y, z] = xyz();
        let f = square(&x) + &square(&y) - &square(&z);
        let mut before = None;
        for depth in 4..9 {
            let region = Region::new([q(-8, 9), q(-9, 10), q(-7, 8)], [q(10, 9), q(11, 10), q(9, 8)]).expect("a box");
            let adapted = adapted(&f, q(0, 1), region, Refinement::halving(depth));
            assert_eq!(adapted.topology(), None);
            assert_holds_an_uncertified(&adapted, &[q(0, 1), q(0, 1), q(0, 1)]);
            let census = adapted.census();
            // All of them within a few cells of the apex: they shrink as 2^−depth.
            let reach = Rational::from(12) / Rational::from(1 << depth);
            for leaf in adapted.leaves().iter().filter(|leaf| matches!(leaf.verdict, Verdict::Uncertified(_))) {
                let cell = adapted.cell(leaf);
                assert!(cell.low().iter().chain(cell.high()).all(|x| x.clone().abs() <= reach), "{cell:?}");
            }
            assert!(census.uncertified.leaves <= 100, "{census:?}");
            if let Some(before) = before.replace(census.uncertified.volume.clone()) {
                assert!(census.uncertified.volume < before);
            }
        }
    }

    #[test]
    fn beside_the_apex_the_hyperboloids_are_an_annulus_and_two_disks() {
        let [x, y, z] = xyz();
        let f = square(&x) + &square(&y) - &square(&z);
        let region = Region::new([q(-17, 9), q(-19, 10), q(-7, 8)], [q(19, 10), q(21, 11), q(9, 8)]).expect("a box");
        let at = |c: Rational| adapted(&f, c, region.clone(), Refinement::halving(18)).topology();
        assert_eq!(at(q(1, 9)), Some(vec![component(0, 2, 0)]));
        assert_eq!(at(q(-1, 9)), Some(vec![component(1, 1, 0); 2]));
    }

    #[test]
    fn a_small_handle_is_uncertified_until_the_cells_are_small_enough() {
        // A torus with a hole of radius 1/20.
        let f = torus(q(1, 2), q(81, 400));
        let region = Region::new([q(-13, 12), q(-17, 16), q(-7, 13)], [q(14, 13), q(15, 14), q(8, 15)]).expect("a box");
        let at = |depth| adapted(&f, q(0, 1), region.clone(), Refinement::halving(depth));
        assert_eq!(at(3).topology(), None);
        assert_eq!(at(12).topology(), Some(vec![component(0, 0, 1)]));
        // Samples on the coarse grid do not see the handle.
        assert_eq!(sampled(&f, q(0, 1), &region, 9), [component(2, 0, 0)]);
    }

    #[test]
    fn a_surface_through_the_border_of_the_box_has_boundary_loops() {
        // An octant, a belt and a sphere pierced by six planes.
        let box_of = |low: [Rational; 3], high: [Rational; 3]| Region::new(low, high).expect("a box");
        let at = |region| adapted(&unit_sphere(), q(0, 1), region, Refinement::halving(18)).topology();
        let octant = box_of([q(1, 9), q(1, 8), q(1, 7)], [q(7, 6), q(6, 5), q(5, 4)]);
        assert_eq!(at(octant), Some(vec![component(1, 1, 0)]));
        let belt = box_of([q(-5, 4), q(-6, 5), q(-1, 3)], [q(7, 6), q(9, 7), q(2, 5)]);
        assert_eq!(at(belt), Some(vec![component(0, 2, 0)]));
        let pierced = box_of([q(-8, 9), q(-7, 8), q(-6, 7)], [q(9, 10), q(10, 11), q(11, 12)]);
        assert_eq!(at(pierced), Some(vec![component(-4, 6, 0)]));
        // Eight corner triangles: the planes at ± 3/5 cut the sphere's six caps so that they overlap.
        let corners = box_of([q(-5, 8), q(-3, 5), q(-7, 11)], [q(8, 13), q(11, 18), q(13, 21)]);
        assert_eq!(at(corners), Some(vec![component(1, 1, 0); 8]));
        // And nothing: the box inside the sphere.
        assert_eq!(at(cube(q(-1, 2), q(1, 2))), Some(vec![]));
    }

    #[test]
    fn a_cap_that_pokes_through_one_face_between_its_edges_is_found() {
        // f = z + 1/10 − 16 x(1−x) y(1−y) increases with z in the whole box, and all corners and edges are
        // positive: only the face z = 0, in which a closed curve lies, stops the box from being called empty.
        let [x, y, z] = xyz();
        let bump = |x: &Trivariate| x.clone() - &square(x);
        let f = z + &constant(1, 10) - &(bump(&x) * &bump(&y) * &constant(16, 1));
        let region = Region::new([q(0, 1), q(0, 1), q(0, 1)], [q(1, 1), q(1, 1), q(2, 1)]).expect("a box");
        let at = |depth| adapted(&f, q(0, 1), region.clone(), Refinement::halving(depth));
        let whole = at(0).leaves()[0].verdict;
        assert_eq!(whole, Verdict::Uncertified(Part([Extent::Across, Extent::Across, Extent::Low])));
        assert_eq!(at(12).topology(), Some(vec![component(1, 1, 0)]));
    }

    #[test]
    fn a_level_through_a_corner_of_the_grid_is_reported_and_certified_where_the_grid_is_another() {
        // Halving [−2, 2] puts grid points on the poles of the unit sphere.
        let halved = adapted(&unit_sphere(), q(0, 1), cube(q(-2, 1), q(2, 1)), Refinement::halving(5));
        assert_eq!(halved.topology(), None);
        assert_holds_an_uncertified(&halved, &[q(0, 1), q(0, 1), q(1, 1)]);
        let at_corner = |leaf: &&Leaf| matches!(leaf.verdict, Verdict::Uncertified(part) if part.dimension() == 0);
        assert!(halved.leaves().iter().filter(at_corner).count() > 0);
        let split = Refinement { max_depth: 12, split: q(5, 11) };
        let other = adapted(&unit_sphere(), q(0, 1), cube(q(-2, 1), q(2, 1)), split);
        assert_eq!(other.topology(), Some(vec![component(2, 0, 0)]));
    }

    #[test]
    fn refining_further_changes_no_certified_leaf() {
        let f = torus(q(1, 1), q(1, 9));
        let region = cube(q(-13, 9), q(19, 13));
        let [coarse, fine] = [3, 5].map(|depth| adapted(&f, q(0, 1), region.clone(), Refinement::halving(depth)));
        let certified = |adapted: &Adapted| -> Vec<Leaf> {
            let leaves = adapted.leaves().iter().copied();
            leaves.filter(|leaf| !matches!(leaf.verdict, Verdict::Uncertified(_))).collect()
        };
        let fine = certified(&fine);
        assert!(certified(&coarse).iter().all(|leaf| fine.contains(leaf)));
    }

    #[test]
    fn the_topology_does_not_depend_on_where_cells_are_split() {
        let f = torus(q(1, 1), q(1, 6));
        for split in [q(1, 2), q(3, 7), q(4, 7)] {
            let refinement = Refinement { max_depth: 12, split };
            let adapted = adapted(&f, q(0, 1), cube(q(-14, 9), q(20, 13)), refinement);
            assert_eq!(adapted.topology(), Some(vec![component(0, 0, 1)]));
        }
    }

    #[test]
    fn ill_posed_questions_are_errors() {
        let ask = |f: &Trivariate, depth, split| {
            adapt(f, &q(3, 1), cube(q(0, 1), q(1, 1)), &Refinement { max_depth: depth, split }).map(|_| ())
        };
        assert_eq!(ask(&unit_sphere(), 3, q(0, 1)), Err(AdaptiveError::Split(q(0, 1))));
        assert_eq!(ask(&unit_sphere(), 3, q(1, 1)), Err(AdaptiveError::Split(q(1, 1))));
        assert_eq!(ask(&unit_sphere(), 31, q(1, 2)), Err(AdaptiveError::TooDeep(31)));
        assert_eq!(ask(&constant(3, 1), 3, q(1, 2)), Err(AdaptiveError::Everywhere));
        assert_eq!(ask(&constant(4, 1), 3, q(1, 2)), Ok(()));
        assert_eq!(Region::new([q(0, 1), q(0, 1), q(1, 1)], [q(1, 1), q(1, 1), q(1, 1)]), None);
    }
}
