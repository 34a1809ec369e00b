//! The objects that the texts draw or list: their numbers, each on its mesh.

use crate::domain::triangles;
use crate::tallies::{closed, count, faces_of_edges, holes_and_shells, numbers, torus};
use isoracle::mesh::classify::{SPHERE, Surface, mesh_surfaces};
use isoracle::mesh::euler::{Balance, EulerPoincare, faces_with_holes};
use isoracle::mesh::examples::cube;
use isoracle::mesh::examples::laminae::{
    hollow_triangle, house, house_by_edges, house_in_two, house_of_triangles, house_prism, segment, triangle,
};
use isoracle::mesh::examples::solids::{cubes_on_an_edge, pierced_block};
use isoracle::mesh::examples::surfaces::{annulus, klein_bottle, sphere};
use isoracle::mesh::face::Face;
use isoracle::mesh::gluing::{FaceError, Sheets};
use isoracle::mesh::simplicial::SimplicialComplex;
use isoracle::number::Rational;
use std::collections::{BTreeMap, BTreeSet};

mod me_96 {
    use super::*;

    #[test]
    fn the_pierced_block_has_its_numbers() {
        let mesh = pierced_block();
        assert_eq!(numbers(&mesh.faces), [24, 36, 15]);
        assert_eq!(faces_with_holes(&mesh.faces), 3);
        assert_eq!(holes_and_shells(&mesh.faces), [3, 1]);
        assert_eq!(closed(&mesh.faces), [torus()]);
        assert_eq!((count(&mesh.faces).characteristic(), count(&mesh.faces).genus()), (0, Rational::from(1)));
    }
}

mod me_97 {
    use super::*;

    #[test]
    fn the_triangle_has_three_three_two() {
        let mesh = triangle();
        assert_eq!(numbers(&mesh.faces), [3, 3, 2]);
        assert_eq!(holes_and_shells(&mesh.faces), [0, 1]);
        assert_eq!(count(&mesh.faces).genus(), 0);
        assert_eq!(mesh.faces[1].reversed(), Face::from([0, 1, 2]));
        assert_eq!(closed(&mesh.faces), [SPHERE]);
    }
}

mod me_98 {
    use super::*;

    #[test]
    fn the_hollow_triangle_is_a_torus() {
        let mesh = hollow_triangle();
        assert_eq!(numbers(&mesh.faces), [6, 6, 2]);
        assert_eq!(holes_and_shells(&mesh.faces), [2, 1]);
        assert_eq!(count(&mesh.faces).genus(), 1);
        assert_eq!(closed(&mesh.faces), [torus()]);
        // Its lists turn holes against their outer loop, and the two faces against each other.
        let area = |l: &[u32]| -> Rational {
            let at = |v: u32| &mesh.vertices[v as usize].0;
            let term = |[a, b]: [u32; 2]| Rational::from(&at(a)[0] * &at(b)[1]) - Rational::from(&at(b)[0] * &at(a)[1]);
            isoracle::mesh::face::sides(l).map(term).sum()
        };
        let twice: Vec<[Rational; 2]> = mesh.faces.iter().map(|f| [area(&f.outer), area(&f.holes[0])]).collect();
        let exact = |n: i64| Rational::from((n, 25));
        assert_eq!(twice, [[exact(-2500), exact(2401)], [exact(2500), exact(-2401)]]);
        assert!(faces_of_edges(&mesh.faces).values().all(|n| *n == 2));
    }

    #[test]
    fn its_hole_lies_inside() {
        let mesh = hollow_triangle();
        let at = |v: usize| &mesh.vertices[v];
        for hole in 3..6 {
            for i in 0..3 {
                // Clockwise as seen from above: the inside is to the right.
                let [a, b] = [at(i), at((i + 1) % 3)];
                let turn = (b.clone() - a).cross(&(at(hole).clone() - a));
                assert!(turn.0[2] < 0);
            }
        }
    }
}

mod me_99 {
    use super::*;

    #[test]
    fn the_segment_has_four_four_two() {
        assert_eq!(numbers(&segment().faces), [4, 4, 2]);
        assert_eq!(closed(&segment().faces), [SPHERE]);
        // As it stands, with its two ends, it is no mesh.
        assert_eq!(
            EulerPoincare::of(&[Face::from([0, 1]), Face::from([1, 0])]),
            Err(FaceError::Loop { face: 0, vertices: 2 })
        );
    }
}

mod me_100 {
    use super::*;

    #[test]
    fn with_two_edges_between_v3_and_v4_the_house_is_a_sphere() {
        let house = house_by_edges();
        assert_eq!(house.counts(), [6, 8, 4]);
        assert_eq!(house.euler_characteristic(), 2);
        assert_eq!(house.surfaces(), [Surface { closed: SPHERE, boundary_loops: 0 }]);
        // Its corners are those of the printed faces.
        let name: BTreeMap<u32, u32> = house
            .corners()
            .iter()
            .flatten()
            .copied()
            .zip(super::house().faces.iter().flat_map(Face::vertices))
            .collect();
        let named: Vec<Vec<u32>> = house.corners().iter().map(|c| c.iter().map(|v| name[v]).collect()).collect();
        assert_eq!(named, super::house().faces.into_iter().map(|f| f.outer).collect::<Vec<_>>());
        assert_eq!(name.values().collect::<BTreeSet<_>>().len(), 6);
    }

    #[test]
    fn by_pairs_of_vertices_it_has_seven_edges_and_number_three() {
        assert_eq!(numbers(&house().faces), [6, 7, 4]);
        assert_eq!(count(&house().faces).euler_number(), 3);
        assert_eq!(faces_of_edges(&house().faces)[&[2, 3]], 4);
        assert_eq!(mesh_surfaces(&house().faces), Err(FaceError::Edge { edge: [2, 3], sides: 4 }.into()));
    }

    #[test]
    fn with_the_edges_shared_the_other_way_it_is_two_laminae() {
        assert_eq!(house_in_two().counts(), [8, 8, 4]);
        assert_eq!(house_in_two().surfaces().len(), 2);
        // With V3 and V4 each one vertex the numbers are those of the sphere.
        let touching = EulerPoincare { vertices: 8 - 2, edges: 8, faces: 4, holes: 0, shells: 1 };
        assert_eq!(touching.euler_number(), house_by_edges().euler_characteristic());
    }
}

mod me_104 {
    use super::*;

    #[test]
    fn of_triangles_the_house_has_six_twelve_eight() {
        let house = house_of_triangles();
        assert_eq!(house.counts(), [6, 12, 8]);
        assert_eq!(house.surfaces(), [Surface { closed: SPHERE, boundary_loops: 0 }]);
    }

    #[test]
    fn in_space_the_house_has_twelve_twenty_ten() {
        assert_eq!(numbers(&house_prism().faces), [12, 20, 10]);
        assert_eq!(closed(&house_prism().faces), [SPHERE]);
    }
}

mod me_105 {
    use super::*;

    #[test]
    fn closed_and_two_sided_are_two_conditions() {
        let both = |complex: &SimplicialComplex| {
            let gluing = Sheets::new(&triangles(complex)).expect("a surface").gluing;
            [gluing.boundary().is_empty(), gluing.is_orientable()]
        };
        assert_eq!(both(&sphere(2)), [true, true]);
        assert_eq!(both(&klein_bottle()), [true, false]);
        assert_eq!(both(&annulus()), [false, true]);
        assert_eq!(both(&isoracle::mesh::examples::surfaces::moebius_band()), [false, false]);
    }
}

mod me_95 {
    use super::*;

    #[test]
    fn an_edge_of_two_touching_cubes_has_four_faces() {
        let mesh = cubes_on_an_edge();
        let mut uses: Vec<usize> = faces_of_edges(&mesh.faces).into_values().collect();
        uses.sort_unstable();
        assert_eq!((uses.len(), uses[21], uses[22]), (23, 2, 4));
        assert!(matches!(Balance::of(&mesh.faces), Err(FaceError::Edge { sides: 4, .. })));
        assert!(faces_of_edges(&cube().faces).values().all(|n| *n == 2));
    }
}
