//! The numbers that the texts print, each on its mesh.

use crate::domain::{complex, disjoint, triangles};
use crate::tallies::{closed, count, faces_of_edges, numbers, torus};
use isoracle::mesh::classify::{ClosedSurface, SPHERE, Surface, mesh_surfaces, surfaces};
use isoracle::mesh::connected_sum::connected_sum;
use isoracle::mesh::euler::{EulerPoincare, faces_with_holes};
use isoracle::mesh::examples::laminae::{house_prism, lamina, laminae, triangle};
use isoracle::mesh::examples::solids::{
    block_with_cavity, block_with_pit, block_with_through_holes, block_with_two_pits, crossing_tunnels, cube_with_loop,
    cubes, divided_cube, frame, hexagonal_prism, pierced_block_with_two_in_one_face, prism, solids_at_two_points,
};
use isoracle::mesh::examples::surfaces::{double_torus, icosahedron, klein_bottle, sphere, sphere_of_one_face};
use isoracle::mesh::examples::{cube, tetrahedron};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::gluing::Sheets;
use isoracle::mesh::homology::ChainComplex;
use isoracle::mesh::realisation::GeometricComplex;
use isoracle::mesh::simplicial::SimplicialComplex;
use isoracle::number::Rational;
use std::collections::{BTreeMap, BTreeSet};

mod me_75 {
    use super::*;

    #[test]
    fn it_holds_for_spheres_of_disc_faces_only() {
        let spheres = [cube(), tetrahedron(), hexagonal_prism(), divided_cube(), house_prism(), triangle()];
        for mesh in spheres {
            assert_eq!(count(&mesh.faces).euler_number(), 2);
            assert_eq!(closed(&mesh.faces), [SPHERE]);
        }
        // No hole goes through these, either.
        assert_eq!(count(&block_with_cavity().faces).euler_number(), 4);
        assert_eq!(count(&block_with_pit().faces).euler_number(), 3);
        assert_eq!(count(&frame().faces).euler_number(), 0);
    }
}

mod me_76 {
    use super::*;

    #[test]
    fn laminae_have_two_faces() {
        for (mesh, n) in laminae().into_iter().zip([4, 6, 8]) {
            assert_eq!(numbers(&mesh.faces), [n, n, 2]);
            assert_eq!(closed(&mesh.faces), [SPHERE]);
            // With one face, no lamina obeys: 1.
            assert_eq!(count(&mesh.faces[..1]).euler_number(), 1);
        }
    }
}

mod me_77 {
    use super::*;

    #[test]
    fn a_parallelepiped_has_eight_vertices_twelve_edges_six_faces() {
        let skew = prism(&[[0, 0], [3, 1], [4, 3], [1, 2]], 2);
        for mesh in [cube(), skew] {
            assert_eq!(numbers(&mesh.faces), [8, 12, 6]);
            assert_eq!(count(&mesh.faces).euler_number(), 6 - 12 + 8);
            assert_eq!(closed(&mesh.faces), [SPHERE]);
        }
    }
}

mod me_78 {
    use super::*;

    #[test]
    fn the_hexagonal_prism_has_twelve_vertices_eighteen_edges_eight_faces() {
        assert_eq!(numbers(&hexagonal_prism().faces), [12, 18, 8]);
        assert_eq!(count(&hexagonal_prism().faces).euler_number(), 2);
        for n in 3..10i64 {
            // Points of a parabola, in convex position.
            let polygon: Vec<[i64; 2]> = (0..n).map(|i| [i, i * i]).collect();
            assert_eq!(numbers(&prism(&polygon, 1).faces), [2 * n, 3 * n, n + 2]);
        }
    }
}

mod me_79 {
    use super::*;

    #[test]
    fn each_face_in_four_makes_24_48_26() {
        assert_eq!(numbers(&divided_cube().faces), [26, 48, 24]);
        assert_eq!(count(&divided_cube().faces).euler_number(), 2);
        assert_eq!(closed(&divided_cube().faces), closed(&cube().faces));
    }

    #[test]
    fn another_object_may_have_another_number() {
        assert_ne!(count(&frame().faces).euler_number(), count(&cube().faces).euler_number());
    }
}

mod me_80 {
    use super::*;

    #[test]
    fn a_line_that_ends_at_no_edge_changes_the_number() {
        let mesh = cube_with_loop();
        assert_eq!(numbers(&mesh.faces), [12, 16, 7]);
        assert_eq!(count(&mesh.faces).euler_number(), 3, "as printed");
        assert_eq!(count(&mesh.faces).characteristic(), 2);
        assert_eq!(closed(&mesh.faces), [SPHERE]);
    }

    #[test]
    fn lines_between_corners_of_a_face_do_not() {
        let mut faces = cube().faces;
        let top = faces.remove(1).outer;
        faces.extend([[top[0], top[1], top[2]], [top[0], top[2], top[3]]].map(Face::from));
        assert_eq!(numbers(&faces), [8, 13, 7]);
        // A line from a new vertex of an edge to another, and a vertex in a line.
        let mut sphere = sphere(2);
        for new in 4..40 {
            let all: Vec<_> = sphere.simplices().cloned().collect();
            let at = &all[(new as usize * 7919) % all.len()];
            sphere = sphere.with_inner_vertex(at, new).unwrap_or(sphere);
        }
        assert_eq!(count(&triangles(&sphere)).euler_number(), 2);
    }
}

mod me_81 {
    use super::*;

    #[test]
    fn cube_sphere_potato_and_bread_have_number_2() {
        let twelve: Vec<[i64; 2]> =
            [[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3], [-5, 0], [-4, -3], [-3, -4], [0, -5], [3, -4], [4, -3]]
                .to_vec();
        let bread = lamina(&twelve);
        // A potato with a bump, as unit cubes.
        let potato = cubes(&BTreeSet::from([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 0, 1]]));
        for faces in [cube().faces, triangles(&icosahedron()), potato.faces, bread.faces.clone()] {
            assert_eq!(count(&faces).euler_number(), 2);
            assert_eq!(closed(&faces), [SPHERE]);
        }
        // What the bread is "practically" is another thing: a circle, or one side of it.
        let circle: Vec<[u32; 2]> = (0..12).map(|i| [i, (i + 1) % 12]).collect();
        assert_eq!(complex(&circle).euler_characteristic(), 0);
        assert_eq!(count(&bread.faces[..1]).euler_number(), 1);
    }
}

mod me_82 {
    use super::*;

    #[test]
    fn the_torus_has_number_0() {
        assert_eq!(numbers(&frame().faces), [16, 32, 16]);
        assert_eq!(closed(&frame().faces), [torus()]);
        assert_eq!(SimplicialComplex::torus().euler_characteristic(), 0);
    }

    #[test]
    fn with_two_ring_faces_v_minus_e_plus_f_is_2() {
        let ring = block_with_through_holes(1);
        assert_eq!(numbers(&ring.faces), [16, 24, 10]);
        assert_eq!(count(&ring.faces).euler_number(), 2);
        assert_eq!(count(&ring.faces).characteristic(), 0);
        assert_eq!(closed(&ring.faces), [torus()]);
    }
}

mod me_83 {
    use super::*;

    #[test]
    fn connected_with_more_than_one_hole_it_is_negative() {
        for g in 2..6 {
            let mesh = block_with_through_holes(g);
            assert_eq!(count(&mesh.faces).characteristic(), 2 - 2 * g);
            assert_eq!(closed(&mesh.faces), [ClosedSurface::Orientable { genus: g as usize }]);
        }
    }

    #[test]
    fn beside_other_parts_it_need_not_be() {
        let two_holes = block_with_through_holes(2).faces;
        let parts = disjoint(&[&two_holes, &cube().faces, &cube().faces]);
        assert_eq!(count(&parts).characteristic(), 2);
        assert_eq!(count(&parts).genus(), 2);
    }
}

mod me_85 {
    use super::*;

    #[test]
    fn two_tunnels_that_cross_make_genus_three() {
        let mesh = crossing_tunnels();
        assert_eq!(closed(&mesh.faces), [ClosedSurface::Orientable { genus: 3 }]);
        // Not crossing, they make two.
        assert_eq!(closed(&block_with_through_holes(2).faces), [ClosedSurface::Orientable { genus: 2 }]);
    }
}

mod me_86 {
    use super::*;

    #[test]
    fn torus_and_klein_bottle_have_one_number() {
        let [torus, klein] = [SimplicialComplex::torus(), klein_bottle()];
        assert_eq!(torus.euler_characteristic(), klein.euler_characteristic());
        assert_ne!(surfaces(&torus), surfaces(&klein));
        let [a, b] = [&torus, &klein].map(|c| ChainComplex::of_complex(c).homology());
        assert_ne!(a, b);
    }

    #[test]
    fn so_have_a_torus_and_a_sphere_beside_a_double_torus() {
        let both = disjoint(&[&cube().faces, &block_with_through_holes(2).faces]);
        assert_eq!(count(&both).characteristic(), count(&frame().faces).characteristic());
        assert_ne!(closed(&both), closed(&frame().faces));
    }

    #[test]
    fn connected_orientable_surfaces_are_told_apart() {
        let found: Vec<_> = (0..6).map(|g| closed(&block_with_through_holes(g).faces)).collect();
        for (g, surface) in found.iter().enumerate() {
            assert_eq!(surface, &[ClosedSurface::Orientable { genus: g }]);
            assert_eq!(surface[0].euler_characteristic(), 2 - 2 * g as i64);
        }
    }
}

mod me_87 {
    use super::*;

    #[test]
    fn the_sum_of_two_tori_has_genus_two() {
        let closed = |complex: &SimplicialComplex| surfaces(complex).expect("a surface");
        let two = Surface { closed: ClosedSurface::Orientable { genus: 2 }, boundary_loops: 0 };
        assert_eq!(closed(&double_torus()), [two]);
        assert_eq!(double_torus().euler_characteristic(), -2);
        assert_eq!(double_torus().f_vector(), [11, 39, 26]);
        // A global operation may keep the genus: with a sphere it is a local one.
        let torus = SimplicialComplex::torus();
        let same = connected_sum(&torus, [0, 1, 3], &sphere(2), [0, 1, 2]).expect("both have the triangle");
        assert_eq!(closed(&same), closed(&torus));
        assert_eq!(Ok(same), torus.with_inner_vertex(torus.of_dimension(2).next().expect("{0, 1, 3}"), 7).ok_or(()));
    }

    /// V, E, F, H, C, G.
    fn all(faces: &[Face]) -> [i64; 6] {
        let count = count(faces);
        let genus = count.genus();
        assert!(genus.is_integer());
        let g = genus.numer().to_i64().expect("small");
        [count.vertices, count.edges, count.faces, count.holes, count.shells, g]
    }

    #[test]
    fn local_operations_keep_the_genus_and_global_ones_change_genus_or_shells() {
        let block = block_with_through_holes(0).faces;
        let change = |faces: &[Face]| {
            closed(faces);
            let (before, after) = (all(&block), all(faces));
            std::array::from_fn::<i64, 6, _>(|i| after[i] - before[i])
        };
        // In place of the last face, the left side 3 0 4 7.
        let with = |new: &[&[u32]]| -> Vec<Face> {
            block[..5].iter().cloned().chain(new.iter().map(|f| Face::new(*f))).collect()
        };
        assert_eq!(change(&with(&[&[3, 0, 4], &[3, 4, 7]])), [0, 1, 1, 0, 0, 0]);
        assert_eq!(change(&with(&[&[3, 0, 8], &[0, 4, 8], &[4, 7, 8], &[7, 3, 8]])), [1, 4, 3, 0, 0, 0]);
        assert_eq!(change(&cube_with_loop().faces), [4, 4, 1, 1, 0, 0]);
        assert_eq!(change(&block_with_pit().faces), [8, 12, 5, 1, 0, 0]);
        // Global ones.
        assert_eq!(change(&block_with_through_holes(1).faces), [8, 12, 4, 2, 0, 1]);
        assert_eq!(change(&block_with_cavity().faces), [8, 12, 6, 0, 1, 0]);
    }
}

mod me_89 {
    use super::*;

    #[test]
    fn a_spherical_face_alone_has_number_one_and_with_a_vertex_two() {
        let bare = EulerPoincare { vertices: 0, edges: 0, faces: 1, holes: 0, shells: 1 };
        assert_eq!((bare.euler_number(), bare.genus()), (1, Rational::from((1, 2))));
        let cells = sphere_of_one_face();
        assert_eq!(cells.counts(), [1, 0, 1]);
        assert_eq!(cells.euler_characteristic(), 2);
    }
}

mod me_92 {
    use super::*;

    #[test]
    fn faces_with_holes_are_not_enough_where_one_face_has_two() {
        let mesh = pierced_block_with_two_in_one_face();
        assert_eq!(numbers(&mesh.faces), [24, 36, 15]);
        assert_eq!((faces_with_holes(&mesh.faces), count(&mesh.faces).holes), (2, 3));
        assert_eq!(closed(&mesh.faces), [torus()]);
        // As printed: 24 − 36 + 15 − 2 = 1 = 2(1 − P), P = 1/2; one hole goes through.
        assert_eq!(count(&mesh.faces).euler_number() - faces_with_holes(&mesh.faces), 1);
        assert_eq!(count(&mesh.faces).characteristic(), 0);
        let pits = block_with_two_pits();
        assert_eq!(numbers(&pits.faces), [24, 36, 16]);
        assert_eq!(count(&pits.faces).euler_number() - faces_with_holes(&pits.faces), 3, "as printed, P = −1/2");
        assert_eq!((count(&pits.faces).characteristic(), closed(&pits.faces)), (2, vec![SPHERE]));
    }
}

mod me_93 {
    use super::*;

    /// The three conditions of the footnote.
    fn conditions(faces: &[Face]) -> [bool; 3] {
        let edges = faces_of_edges(faces);
        let mut at: BTreeMap<u32, usize> = BTreeMap::new();
        edges.keys().flatten().for_each(|v| *at.entry(*v).or_default() += 1);
        [count(faces).euler_number() == 2, edges.values().all(|n| *n == 2), at.values().all(|n| *n >= 3)]
    }

    #[test]
    fn simple_polyhedra_have_all_three() {
        for mesh in [cube(), tetrahedron(), hexagonal_prism(), house_prism(), block_with_through_holes(0)] {
            assert_eq!(conditions(&mesh.faces), [true; 3]);
        }
        // But for a vertex inside an edge.
        let mut faces = cube().faces;
        for face in &mut faces {
            let n = face.outer.len();
            if let Some(i) = (0..n).find(|i| edge([face.outer[*i], face.outer[(i + 1) % n]]) == [0, 1]) {
                face.outer.insert(i + 1, 8);
            }
        }
        assert_eq!(conditions(&faces), [true, true, false]);
        assert_eq!(closed(&faces), [SPHERE]);
        // Or where a bent line divides a face.
        let mut faces = cube().faces;
        faces[1] = Face::from([4, 5, 6, 8]);
        faces.push(Face::from([4, 8, 6, 7]));
        assert_eq!(numbers(&faces), [9, 14, 7]);
        assert_eq!((conditions(&faces), closed(&faces)), ([true, true, false], vec![SPHERE]));
    }

    #[test]
    fn what_has_all_three_need_not_be_simple_nor_connected() {
        let both = disjoint(&[&cube().faces, &frame().faces]);
        assert_eq!(conditions(&both), [true; 3]);
        assert_eq!(closed(&both), [SPHERE, torus()]);
    }

    #[test]
    fn what_has_all_three_and_is_connected_need_not_be_a_surface() {
        let mesh = solids_at_two_points();
        assert_eq!(conditions(&mesh.faces), [true; 3]);
        assert_eq!((numbers(&mesh.faces), count(&mesh.faces).shells), ([8, 18, 12], 1));
        assert!(mesh_surfaces(&mesh.faces).is_err());
        assert_eq!(Sheets::new(&mesh.faces).expect("edges of two faces").pinches(), BTreeMap::from([(0, 2), (1, 2)]));
        // It lies in space: triangles meet in common faces only.
        let triangles: Vec<Vec<u32>> = mesh.faces.iter().map(|f| f.outer.clone()).collect();
        assert!(GeometricComplex::new(complex(&triangles), mesh.vertices).is_ok());
    }
}
