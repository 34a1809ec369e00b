//! Sums, handles, cross-caps on triangulations; the text's constructions of the torus, P² and the Klein bottle.

use crate::domain::complex;
use isoracle::linear::Vector;
use isoracle::mesh::classify::{ClosedSurface, SPHERE, Surface, mesh_surfaces, surfaces};
use isoracle::mesh::connected_sum::{SumError, connected_sum, cycle, with_disc_replaced, with_tube};
use isoracle::mesh::examples::surfaces::{
    annulus, ball, csaszar, csaszar_points, double_torus, icosahedron, klein_bottle, moebius_band, projective_plane,
    sphere,
};
use isoracle::mesh::examples::{cube, solids::frame};
use isoracle::mesh::homology::ChainComplex;
use isoracle::mesh::manifold::{Dimension, border};
use isoracle::mesh::simplicial::{Simplex, SimplicialComplex};
use isoracle::number::Rational;

fn orientable(genus: usize) -> ClosedSurface {
    ClosedSurface::Orientable { genus }
}

fn non_orientable(crosscaps: usize) -> ClosedSurface {
    ClosedSurface::NonOrientable { crosscaps }
}

/// What a connected closed complex is.
fn closed(complex: &SimplicialComplex) -> ClosedSurface {
    assert_eq!(complex.surface_defects(), []);
    match surfaces(complex).expect("a surface")[..] {
        [Surface { closed, boundary_loops: 0 }] => closed,
        ref other => panic!("{other:?}"),
    }
}

fn a_triangle(complex: &SimplicialComplex) -> [u32; 3] {
    let triangle = complex.of_dimension(2).last().expect("a triangle");
    triangle.vertices().try_into().expect("three corners")
}

fn simplex(vertices: &[u32]) -> Simplex {
    Simplex::new(vertices).expect("different vertices")
}

/// The complex without the triangles at a vertex.
fn without(complex: &SimplicialComplex, vertex: u32) -> SimplicialComplex {
    let kept = complex.maximal().into_iter().filter(|s| !s.vertices().contains(&vertex));
    SimplicialComplex::new(kept.cloned())
}

mod me_135 {
    use super::*;

    #[test]
    fn sums_of_triangulations_are_sums_of_surfaces() {
        let all =
            [sphere(2), icosahedron(), SimplicialComplex::torus(), klein_bottle(), projective_plane(), double_torus()];
        for a in &all {
            for b in &all {
                let sum = connected_sum(a, a_triangle(a), b, a_triangle(b)).expect("both have the triangle");
                assert_eq!(sum.euler_characteristic(), a.euler_characteristic() + b.euler_characteristic() - 2);
                assert_eq!(closed(&sum), closed(a).sum(closed(b)));
                let [v, e, f] = [0, 1, 2].map(|k| a.f_vector()[k] + b.f_vector()[k]);
                assert_eq!(sum.f_vector(), [v - 3, e - 3, f - 2]);
            }
        }
        assert_refused();
    }

    // Wherever the triangles are, at the border too: loops of the border add.
    #[test]
    fn sums_of_surfaces_with_border_have_both_borders() {
        let all = [ball(2), annulus(), moebius_band(), sphere(2), projective_plane()];
        let only = |complex: &SimplicialComplex| surfaces(complex).expect("a surface")[0];
        let mut met = 0;
        for a in &all {
            for b in &all {
                for at in a.of_dimension(2) {
                    let at = at.vertices().try_into().expect("three corners");
                    let sum = match connected_sum(a, at, b, a_triangle(b)) {
                        Ok(sum) => only(&sum),
                        Err(SumError::Border(v)) => {
                            let on_border =
                                |c: &SimplicialComplex, v| border(c, Dimension::Two).contains(&simplex(&[v]));
                            let i = at.iter().position(|w| *w == v).expect("a corner");
                            assert!(on_border(a, v) && on_border(b, a_triangle(b)[i]));
                            continue;
                        }
                        Err(other) => panic!("{other}"),
                    };
                    met += 1;
                    let boundary_loops = only(a).boundary_loops + only(b).boundary_loops;
                    assert_eq!(sum, Surface { closed: only(a).closed.sum(only(b).closed), boundary_loops });
                }
            }
        }
        assert_eq!(connected_sum(&ball(2), [0, 1, 2], &ball(2), [0, 1, 2]), Err(SumError::Border(0)));
        // All pairs with a closed surface: 2 · 12 triangles, and 5 · 14.
        assert!(met >= 24 + 70, "{met}");
    }

    fn assert_refused() {
        let torus = SimplicialComplex::torus();
        assert_eq!(connected_sum(&torus, [0, 1, 2], &torus, [0, 1, 3]), Err(SumError::NoTriangle([0, 1, 2])));
        assert_eq!(connected_sum(&torus, [0, 1, 3], &torus, [0, 0, 3]), Err(SumError::NoTriangle([0, 0, 3])));
    }
}

mod me_137 {
    use super::*;

    #[test]
    fn a_sphere_with_one_handle_is_a_torus() {
        let mut surface = icosahedron();
        surface = with_tube(&surface, [0, 1, 2], [11, 8, 9]).expect("opposite triangles");
        assert_eq!(closed(&surface), orientable(1));
        assert_eq!(closed(&SimplicialComplex::torus()), orientable(1));
        let [tube, torus] = [&surface, &SimplicialComplex::torus()].map(|c| ChainComplex::of_complex(c).homology());
        assert_eq!(tube, torus);
    }

    // With the tube's end turned over, the handle makes a Klein bottle: the text's cylinder has to be glued the right way.
    #[test]
    fn a_tube_glued_the_other_way_makes_a_klein_bottle() {
        for (to, made) in [([11, 8, 9], orientable(1)), ([8, 11, 9], non_orientable(2))] {
            let surface = with_tube(&icosahedron(), [0, 1, 2], to).expect("no edges between the triangles");
            assert_eq!(closed(&surface), made);
        }
    }

    #[test]
    fn tubes_that_cannot_be_are_refused() {
        assert_eq!(with_tube(&icosahedron(), [0, 1, 2], [0, 2, 3]), Err(SumError::Touching(0)));
        assert_eq!(with_tube(&icosahedron(), [0, 1, 11], [6, 7, 2]), Err(SumError::NoTriangle([0, 1, 11])));
        assert_eq!(with_tube(&icosahedron(), [0, 1, 2], [11, 6, 7]), Err(SumError::Edge(1, 6)));
    }
}

mod me_138 {
    use super::*;

    #[test]
    fn a_sphere_with_a_disc_replaced_by_a_moebius_band_is_the_projective_plane() {
        let seam = cycle(&border(&moebius_band(), Dimension::Two)).expect("one loop");
        assert_eq!(seam, [0, 2, 4, 1, 3]);
        let plane = with_disc_replaced(&icosahedron(), 0, &moebius_band(), &seam);
        // The band's inner edges are those of the disc's diagonals, which the sphere has none of.
        let plane = plane.expect("a pentagon around the vertex");
        assert_eq!(closed(&plane), non_orientable(1));
        assert_eq!(closed(&projective_plane()), non_orientable(1));
        assert_eq!(plane.f_vector(), [11, 30, 20]);
    }

    #[test]
    fn bands_that_do_not_fit_are_refused() {
        let seam = [0, 2, 4, 1, 3];
        assert_eq!(with_disc_replaced(&sphere(2), 0, &moebius_band(), &seam), Err(SumError::NoDisc(0)));
        assert_eq!(with_disc_replaced(&ball(2), 0, &moebius_band(), &seam), Err(SumError::NoDisc(0)));
        assert_eq!(with_disc_replaced(&icosahedron(), 12, &moebius_band(), &seam), Err(SumError::NoDisc(12)));
        // The plane has all edges between its six vertices.
        let twice = with_disc_replaced(&projective_plane(), 0, &moebius_band(), &seam);
        assert!(matches!(twice, Err(SumError::Edge(_, _))), "{twice:?}");
    }
}

mod me_139 {
    use super::*;

    #[test]
    fn a_sphere_without_two_discs_is_a_cylinder() {
        let cylinder = without(&without(&icosahedron(), 0), 11);
        assert_eq!(surfaces(&cylinder), surfaces(&annulus()));
        assert_eq!(cylinder.euler_characteristic(), 0);
    }

    #[test]
    fn two_moebius_bands_on_a_cylinder_make_a_klein_bottle() {
        let seam = [0, 2, 4, 1, 3];
        let plane = with_disc_replaced(&icosahedron(), 0, &moebius_band(), &seam).expect("a pentagon");
        let bottle = with_disc_replaced(&plane, 11, &moebius_band(), &seam).expect("a pentagon");
        assert_eq!(bottle.f_vector(), [10, 30, 20]);
        assert_eq!(closed(&bottle), non_orientable(2));
        let [made, known] = [&bottle, &klein_bottle()].map(|c| ChainComplex::of_complex(c).homology());
        assert_eq!(made, known);
        // Figure 17's way: a cylinder with its ends glued crosswise.
        let square = isoracle::mesh::gluing::Gluing::from_words(&["abaB"]).expect("a square");
        assert_eq!(square.surfaces()[0].closed, non_orientable(2));
    }
}

mod me_140 {
    use super::*;

    #[test]
    fn the_band_of_a_rectangle_with_opposite_corners_glued_has_one_side() {
        // Three squares in a row, each of two triangles; the last edge is glued to the first upside down.
        let strip = complex(&[[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 5], [4, 5, 1], [5, 1, 0]]);
        let moebius = Surface { closed: non_orientable(1), boundary_loops: 1 };
        assert_eq!(surfaces(&strip), Ok(vec![moebius]));
        assert_eq!(surfaces(&moebius_band()), Ok(vec![moebius]));
        let straight = complex(&[[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 5], [4, 5, 0], [5, 0, 1]]);
        assert_eq!(surfaces(&straight), surfaces(&annulus()));
        assert_eq!(closed(&sphere(2)), SPHERE);
    }
}

mod me_141 {
    use super::*;

    #[test]
    fn the_klein_bottle_has_characteristic_zero() {
        assert_eq!(klein_bottle().f_vector(), [8, 24, 16]);
        assert_eq!(klein_bottle().euler_characteristic(), 0);
        assert_eq!(closed(&klein_bottle()), non_orientable(2));
        assert_eq!(non_orientable(2).euler_characteristic(), 0);
        let homology = ChainComplex::of_complex(&klein_bottle()).homology();
        assert_eq!(homology.betti, [1, 1, 0]);
    }
}

mod me_144 {
    use super::*;

    #[test]
    fn the_first_two_families_have_two_sides_and_the_third_has_one() {
        let torus = SimplicialComplex::torus();
        let plane = projective_plane();
        let (mut handles, mut crosscaps) = (sphere(2), plane.clone());
        for g in 0..4 {
            assert_eq!(closed(&handles), orientable(g));
            assert_eq!(ChainComplex::of_complex(&handles).homology().betti[2], 1);
            assert_eq!(closed(&crosscaps), non_orientable(g + 1));
            assert_eq!(ChainComplex::of_complex(&crosscaps).homology().betti[2], 0);
            handles = connected_sum(&handles, a_triangle(&handles), &torus, [0, 1, 3]).expect("a triangle of each");
            crosscaps =
                connected_sum(&crosscaps, a_triangle(&crosscaps), &plane, [0, 1, 2]).expect("a triangle of each");
        }
    }
}

mod me_84 {
    use super::*;

    /// Whether a segment and a triangle without a common end meet, for points in general position.
    fn pierces(points: &[Vector<Rational, 3>], [a, b]: [u32; 2], [x, y, z]: [u32; 3]) -> bool {
        let at = |v: u32| points[v as usize].clone();
        let volume = |a, b, c, d| (at(b) - &at(a)).dot(&(at(c) - &at(a)).cross(&(at(d) - &at(a)))).cmp0();
        let beside = [volume(a, b, x, y), volume(a, b, y, z), volume(a, b, z, x)];
        assert!(beside.iter().all(|s| s.is_ne()), "general position");
        volume(a, x, y, z) != volume(b, x, y, z) && beside[0] == beside[1] && beside[1] == beside[2]
    }

    #[test]
    fn the_torus_is_neither_the_sphere_nor_the_cube() {
        let one = |complex: &SimplicialComplex| ChainComplex::of_complex(complex).homology().betti[1];
        assert_eq!([one(&SimplicialComplex::torus()), one(&sphere(2)), one(&icosahedron())], [2, 0, 0]);
        let surface = |faces: &[isoracle::mesh::face::Face]| mesh_surfaces(faces).expect("a surface");
        assert_ne!(surface(&frame().faces), surface(&cube().faces));
        assert_eq!(surface(&cube().faces), surfaces(&sphere(2)).expect("a surface"));
        assert_eq!(surface(&frame().faces), surfaces(csaszar().complex()).expect("a surface"));
    }

    #[test]
    fn the_torus_of_seven_vertices_lies_in_space() {
        assert_eq!(csaszar().complex(), &SimplicialComplex::torus());
        // Another way: no edge pierces a triangle. Of all ways to lay the torus on the points only one is so.
        let torus = SimplicialComplex::torus();
        let lies = |name: &[u32]| {
            let of = |s: &Simplex| s.vertices().iter().map(|v| name[*v as usize]).collect::<Vec<u32>>();
            let edges: Vec<[u32; 2]> = torus.of_dimension(1).map(|e| of(e).try_into().expect("two ends")).collect();
            let triangles: Vec<[u32; 3]> = torus.of_dimension(2).map(|t| of(t).try_into().expect("three")).collect();
            let apart = |e: &[u32; 2], t: &[u32; 3]| e.iter().all(|v| !t.contains(v));
            let points = csaszar_points();
            edges.iter().all(|e| triangles.iter().filter(|t| apart(e, t)).all(|t| !pierces(&points, *e, *t)))
        };
        assert!(lies(&[0, 1, 2, 3, 4, 5, 6]));
        assert!(!lies(&[1, 0, 2, 3, 4, 5, 6]));
        let symmetric = |name: &[u32]| {
            torus
                .of_dimension(2)
                .all(|t| torus.contains(&simplex(&t.vertices().iter().map(|v| name[*v as usize]).collect::<Vec<_>>())))
        };
        // The torus can be turned so that any vertex is the first: names that begin with 0 are all, up to that.
        let mut names = vec![vec![0]];
        for v in 1..7u32 {
            let with = |name: Vec<u32>| {
                (1..=name.len()).map(move |i| [&name[..i], &[v], &name[i..]].concat()).collect::<Vec<Vec<u32>>>()
            };
            names = names.into_iter().flat_map(with).collect();
        }
        let fitting = names.iter().filter(|name| lies(name)).count();
        let symmetries = names.iter().filter(|name| symmetric(name)).count();
        // 6!/6 = 120 tori on seven points; one fits.
        assert_eq!([names.len(), symmetries, fitting], [720, 6, 6]);
    }
}
