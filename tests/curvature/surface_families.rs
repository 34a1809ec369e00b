//! Embeddings and the classification of closed surfaces.

use super::q;
use isoracle::curvature::chart::{RationalPatch, scaled_axes};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::topology::{
    Family, NoRoom, barycentric_subdivision, moment_curve, oriented, sphere_with_tubes,
};
use isoracle::linear::{Matrix, Vector, determinant};
use isoracle::mesh::classify::{ClosedSurface, Surface, glued_triangles, surfaces};
use isoracle::mesh::connected_sum::{connected_sum, cycle, with_disc_replaced};
use isoracle::mesh::examples::surfaces::{
    annulus, ball, csaszar, double_torus, icosahedron, klein_bottle, moebius_band as band_of_triangles,
    projective_plane, sphere,
};
use isoracle::mesh::gluing::Gluing;
use isoracle::mesh::manifold::{Dimension, border};
use isoracle::mesh::realisation::GeometricComplex;
use isoracle::mesh::simplicial::SimplicialComplex;
use isoracle::mesh::word::intersection_rank;
use isoracle::number::Rational;

fn closed(complex: &SimplicialComplex) -> ClosedSurface {
    let found = surfaces(complex).expect("a surface");
    assert_eq!((found.len(), found[0].boundary_loops), (1, 0));
    found[0].closed
}

fn of_word(word: &str) -> Vec<Surface> {
    Gluing::from_words(&[word]).expect("a word").surfaces()
}

/// 2 − χ by the intersection form of the word that the triangles are united to, which counts no vertices.
fn chi_by_word(complex: &SimplicialComplex) -> i64 {
    let words = glued_triangles(complex).expect("a surface").words();
    words.iter().map(|word| 2 - intersection_rank(word) as i64).sum()
}

fn six() -> [SimplicialComplex; 6] {
    [sphere(2), SimplicialComplex::torus(), projective_plane(), klein_bottle(), double_torus(), icosahedron()]
}

mod cu_231 {
    use super::*;

    #[test]
    fn squeezing_the_sphere_has_an_inverse() {
        let axes = [q(1, 2), q(3, 1), q(2, 3)];
        let back = axes.each_ref().map(|a| a.clone().recip());
        let squeezed = [0, 1, 2].map(|i| Jet::<Rational, 3>::variable(i, q(1, 1)) * &Jet::constant(axes[i].clone()));
        assert_eq!(scaled_axes(&squeezed, &back.map(Jet::constant)), [0, 1, 2].map(|i| Jet::variable(i, q(1, 1))));
    }

    #[test]
    fn equivalence_is_an_equivalence_and_the_numbers_decide_it() {
        // Reflexive, symmetric, transitive on the list; a subdivision is equivalent to its complex.
        let all: Vec<ClosedSurface> = six().iter().map(closed).collect();
        for (i, a) in all.iter().enumerate() {
            assert_eq!(*a, closed(&barycentric_subdivision(&six()[i])));
            let same: Vec<usize> = (0..6).filter(|j| all[*j] == *a).collect();
            assert_eq!(same, if i == 0 || i == 5 { vec![0, 5] } else { vec![i] });
        }
    }
}

mod cu_232 {
    use super::*;

    fn embedded<const N: usize>(complex: SimplicialComplex, at: Vec<Vector<Rational, N>>) -> bool {
        GeometricComplex::new(complex, at).is_ok()
    }

    #[test]
    fn sphere_cylinder_and_torus_are_in_space_and_the_klein_bottle_in_dimension_four() {
        let points = |at: &[[i64; 3]]| at.iter().map(|x| Vector(x.map(Rational::from))).collect::<Vec<_>>();
        assert!(embedded(sphere(2), points(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])));
        assert!(embedded(annulus(), points(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]])));
        assert_eq!(closed(csaszar().complex()), ClosedSurface::Orientable { genus: 1 });
        assert_eq!(closed(&klein_bottle()), ClosedSurface::NonOrientable { crosscaps: 2 });
        assert!(embedded(klein_bottle(), moment_curve(8)));
        // Two triangles of points in alternating order meet: not every order does.
        let crossed = SimplicialComplex::from_vertices(&[[0, 2, 4], [1, 3, 5]]).expect("different vertices");
        assert!(!embedded(crossed, moment_curve(6)));
    }

    /// The 3-sphere as the border of the cyclic 4-polytope with 7 vertices: all surfaces in it, as borders of sets of
    /// tetrahedra, have two sides.
    #[test]
    fn closed_surfaces_in_a_triangulated_3_sphere_are_orientable() {
        // The facets of the convex hull: the other points lie on one side of their hyperplane.
        let points = moment_curve(7);
        let side = |facet: &[u32; 4], other: u32| {
            let rows = [facet[0], facet[1], facet[2], facet[3], other].map(|i| &points[i as usize].0);
            determinant(&Matrix::<Rational, 5, 5>::from_fn(|i, j| if j < 4 { rows[i][j].clone() } else { q(1, 1) })) > 0
        };
        let quadruples = ball(6).simplices().filter(|s| s.dimension() == 3).cloned().collect::<Vec<_>>();
        let quadruples = quadruples.iter().map(|s| <[u32; 4]>::try_from(s.vertices()).expect("four vertices"));
        let tetrahedra: Vec<[u32; 4]> = quadruples
            .filter(|facet| {
                let mut sides = (0..7).filter(|i| !facet.contains(i)).map(|i| side(facet, i));
                let first = sides.next();
                sides.all(|side| Some(side) == first)
            })
            .collect();
        assert_eq!(tetrahedra.len(), 14);
        let mut tori = 0;
        for chosen in 1..1_u32 << 13 {
            let mut triangles: std::collections::BTreeMap<[u32; 3], usize> = std::collections::BTreeMap::new();
            for (_, [a, b, c, d]) in (0..13).zip(&tetrahedra).filter(|(i, _)| chosen >> i & 1 == 1) {
                for t in [[*a, *b, *c], [*a, *b, *d], [*a, *c, *d], [*b, *c, *d]] {
                    *triangles.entry(t).or_default() += 1;
                }
            }
            let border: Vec<[u32; 3]> = triangles.into_iter().filter(|(_, n)| n % 2 == 1).map(|(t, _)| t).collect();
            let mut sides = [[0_u8; 7]; 7];
            for [a, b, c] in &border {
                for (x, y) in [(a, b), (a, c), (b, c)] {
                    sides[*x as usize][*y as usize] += 1;
                }
            }
            if sides.iter().flatten().any(|n| *n > 2) {
                continue;
            }
            let complex = SimplicialComplex::from_vertices(&border).expect("different vertices");
            if complex.surface_defects().is_empty() {
                for surface in surfaces(&complex).expect("a surface") {
                    let ClosedSurface::Orientable { genus } = surface.closed else { panic!("{border:?} has one side") };
                    tori += usize::from(genus == 1);
                }
            }
        }
        assert!(tori > 0);
    }
}

mod cu_233 {
    use super::*;

    #[test]
    fn the_projective_plane_is_in_dimension_four() {
        assert_eq!(closed(&projective_plane()), ClosedSurface::NonOrientable { crosscaps: 1 });
        assert!(GeometricComplex::new(projective_plane(), moment_curve(6)).is_ok());
        // (x, y, z) ↦ (x² − y², xy, xz, yz) tells the points of the sphere apart, but for antipodes.
        let sphere = RationalPatch::sphere(&q(1, 1));
        let points: Vec<[Rational; 3]> = (-6..=6)
            .flat_map(|u| (-6..=6).map(move |v| [q(u, 2), q(v, 2)]))
            .map(|at| sphere.jets(&at).expect("no pole").map(|x| x.value))
            .collect();
        let image = |[x, y, z]: &[Rational; 3]| {
            let times = |a: &Rational, b: &Rational| Rational::from(a * b);
            [times(x, x) - times(y, y), times(x, y), times(x, z), times(y, z)]
        };
        for (i, a) in points.iter().enumerate() {
            for b in &points[i + 1..] {
                let antipodal = a.iter().zip(b).all(|(x, y)| *x == Rational::from(-y));
                assert_eq!(image(a) == image(b), antipodal);
            }
        }
    }

    #[test]
    fn it_is_a_sphere_with_a_disc_replaced_by_a_band() {
        let made = with_disc_replaced(&icosahedron(), 0, &band_of_triangles(), &[0, 2, 4, 1, 3])
            .expect("a disc of five triangles");
        assert!(made.surface_defects().is_empty());
        assert_eq!(closed(&made), closed(&projective_plane()));
        assert_eq!(closed(&Family::Bands(1).triangulation()), closed(&made));
    }
}

mod cu_234 {
    use super::*;

    #[test]
    fn each_handle_takes_2_from_chi() {
        for g in 0..=3 {
            let surface = sphere_with_tubes(g, 0).expect("room for it");
            assert_eq!(closed(&surface), ClosedSurface::Orientable { genus: g });
            assert_eq!(surface.euler_characteristic(), 2 - 2 * g as i64);
            assert_eq!(chi_by_word(&surface), 2 - 2 * g as i64);
        }
        assert_eq!(closed(&sphere_with_tubes(1, 0).expect("room for it")), closed(&SimplicialComplex::torus()));
    }

    #[test]
    fn one_handle_glued_the_other_way_makes_it_one_sided() {
        for g in 0..=2 {
            let surface = sphere_with_tubes(g, 1).expect("room for it");
            assert_eq!(closed(&surface), ClosedSurface::NonOrientable { crosscaps: 2 * g + 2 });
        }
        assert_eq!(closed(&sphere_with_tubes(0, 1).expect("room for it")), closed(&klein_bottle()));
        let Err(NoRoom { wanted: usize::MAX, room }) = sphere_with_tubes(usize::MAX, 1) else {
            panic!("there is no room")
        };
        assert!(sphere_with_tubes(room, 0).is_ok() && sphere_with_tubes(room, 1).is_err());
    }
}

mod cu_235 {
    use super::*;

    #[test]
    fn two_bands_on_a_cylinder_make_a_klein_bottle() {
        // A sphere less two discs is a cylinder.
        let less_two = icosahedron()
            .maximal()
            .into_iter()
            .filter(|t| !t.vertices().iter().any(|v| [0, 11].contains(v)))
            .cloned()
            .collect::<Vec<_>>();
        assert_eq!(surfaces(&SimplicialComplex::new(less_two)).expect("a surface")[0].to_string(), "annulus");
        let rim = cycle(&border(&band_of_triangles(), Dimension::Two)).expect("one loop");
        let made = [0, 11].into_iter().fold(icosahedron(), |surface, vertex| {
            with_disc_replaced(&surface, vertex, &band_of_triangles(), &rim).expect("a disc of five triangles")
        });
        assert!(made.surface_defects().is_empty());
        assert_eq!((closed(&made), made.euler_characteristic()), (closed(&klein_bottle()), 0));
        assert_eq!(closed(&Family::Bands(2).triangulation()), closed(&made));
    }

    #[test]
    fn a_rectangle_made_a_cylinder_with_its_ends_glued_in_opposite_directions_is_one() {
        // a, c are glued straight to a cylinder, whose ends b are glued against one another.
        assert_eq!(of_word("abAb")[0].to_string(), "Klein bottle");
        assert_eq!(of_word("abAB")[0].to_string(), "torus");
        assert_eq!(of_word("abAc")[0].to_string(), "annulus");
    }
}

mod cu_236 {
    use super::*;

    fn families() -> impl Iterator<Item = Family> {
        (0..=4).flat_map(|g| [Family::Handles(g), Family::Bands(g)]).chain([Family::Sphere])
    }

    #[test]
    fn each_family_is_what_its_triangulation_is() {
        for family in families() {
            let complex = family.triangulation();
            assert!(complex.surface_defects().is_empty());
            assert_eq!(closed(&complex), family.surface());
            // "Orientáveis", "não orientáveis": true of all but the third family with g = 0.
            let is_right = oriented(&complex).expect("a surface").is_some() == family.is_orientable_printed();
            assert_eq!(is_right, family != Family::Bands(0));
        }
    }

    #[test]
    fn the_families_are_disjoint_but_for_g_0() {
        let all: Vec<Family> = families().collect();
        let is_sphere = |f: &Family| matches!(f, Family::Sphere | Family::Handles(0) | Family::Bands(0));
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            assert_eq!(a.surface() == b.surface(), a == b || is_sphere(a) && is_sphere(b));
        }
    }

    #[test]
    fn several_components_are_classified_one_by_one() {
        let union = SimplicialComplex::torus().disjoint_union(&projective_plane());
        let mut found: Vec<ClosedSurface> =
            surfaces(&union).expect("a surface").into_iter().map(|s| s.closed).collect();
        found.sort();
        assert_eq!(found, [Family::Handles(1).surface(), Family::Bands(1).surface()]);
    }

    #[test]
    fn bounded_is_not_compact() {
        // The open disc x² + y² < 1, z = 0: bounded, and with each point it has a disc around it, so it has no border
        // and is connected (convex).
        let inside = |x: &Rational, y: &Rational| Rational::from(x.square_ref()) + Rational::from(y.square_ref()) < 1;
        for (a, b) in (-9..=9).flat_map(|a| (-9..=9).map(move |b| (q(a, 10), q(b, 10)))).filter(|(a, b)| inside(a, b)) {
            let room = (q(1, 1) - Rational::from(a.square_ref()) - Rational::from(b.square_ref())) / 4_u32;
            for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
                assert!(inside(&(a.clone() + Rational::from(&room * dx)), &(b.clone() + Rational::from(&room * dy))));
            }
        }
        // It has not the limit (1, 0) of its points (1 − 2⁻ᵏ, 0), as a compact set would.
        assert!((1..60).all(|k| inside(&(q(1, 1) - Rational::from((1, 1_u64 << k))), &q(0, 1))));
        assert!(!inside(&q(1, 1), &q(0, 1)));
    }
}

mod cu_237 {
    use super::*;

    #[test]
    fn the_three_cases_are_v_minus_e_plus_f() {
        for g in 0..=4 {
            for family in [Family::Sphere, Family::Handles(g), Family::Bands(g)] {
                let complex = family.triangulation();
                assert_eq!(complex.euler_characteristic(), family.euler_characteristic());
                assert_eq!(chi_by_word(&complex), family.euler_characteristic());
                assert_eq!(family.surface().euler_characteristic(), family.euler_characteristic());
            }
        }
        let of_zero = [Family::Sphere, Family::Handles(0), Family::Bands(0)].map(Family::euler_characteristic);
        assert_eq!(of_zero, [2, 2, 2]);
    }

    #[test]
    fn the_klein_bottle_has_0_as_the_torus_has() {
        assert_eq!(Family::Bands(2).euler_characteristic(), 0);
        assert_eq!((klein_bottle().f_vector(), klein_bottle().euler_characteristic()), (vec![8, 24, 16], 0));
        assert_eq!(Family::Handles(1).euler_characteristic(), 0);
        assert_ne!(closed(&klein_bottle()), closed(&SimplicialComplex::torus()));
    }

    #[test]
    fn a_barycentric_subdivision_and_a_sum_change_it_as_they_should() {
        for complex in six() {
            let finer = barycentric_subdivision(&complex);
            let counts = complex.f_vector();
            // V′ = V + E + F, E′ = 2E + 6F, F′ = 6F.
            assert_eq!(
                finer.f_vector(),
                [counts[0] + counts[1] + counts[2], 2 * counts[1] + 6 * counts[2], 6 * counts[2]]
            );
            assert_eq!(finer.euler_characteristic(), complex.euler_characteristic());
            for other in six() {
                let at = |c: &SimplicialComplex| {
                    <[u32; 3]>::try_from(c.of_dimension(2).next().expect("a triangle").vertices()).expect("three")
                };
                let sum = connected_sum(&complex, at(&complex), &other, at(&other)).expect("closed surfaces");
                assert_eq!(
                    sum.euler_characteristic(),
                    complex.euler_characteristic() + other.euler_characteristic() - 2
                );
                assert_eq!(closed(&sum), closed(&complex).sum(closed(&other)));
            }
        }
    }
}
