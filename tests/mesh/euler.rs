//! Euler and Poincaré's formula against homology, normal forms, planted solids and counts of unit cubes.

use crate::domain::{complex, disjoint, every_gluing, long, small_gluing, triangles};
use isoracle::mesh::classify::ClosedSurface;
use isoracle::mesh::euler::{Balance, EulerPoincare};
use isoracle::mesh::examples::cube;
use isoracle::mesh::examples::solids::{
    BoxSide, Cut, block, block_with_through_holes, cubes, cubes_on_an_edge, frame, grid,
};
use isoracle::mesh::examples::surfaces::{klein_bottle, moebius_band, projective_plane};
use isoracle::mesh::face::{Face, edge};
use isoracle::mesh::gluing::{FaceError, Gluing, Sheets};
use isoracle::mesh::homology::{ChainComplex, alternating_sum};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::Rational;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn count(faces: &[Face]) -> EulerPoincare {
    EulerPoincare::of(faces).expect("loops of three vertices or more")
}

/// Cells of a grid of n³ cubes.
fn cells(n: i64) -> impl Strategy<Value = BTreeSet<[i64; 3]>> {
    let all: Vec<[i64; 3]> = grid([n; 3]).collect();
    let len = all.len();
    // Full but for some, or sparse: tunnels, cavities, touching edges and corners.
    (prop::sample::subsequence(all.clone(), 1..len), any::<bool>()).prop_map(move |(some, full)| match full {
        true => all.iter().filter(|c| !some.contains(c)).copied().collect(),
        false => some.into_iter().collect(),
    })
}

/// χ of a solid of unit cubes: vertices − edges + squares − cubes.
fn chi_of_solid(cells: &BTreeSet<[i64; 3]>) -> i64 {
    // A cell of the grid by its doubled centre: odd coordinates are directions that it extends in.
    let around = |cell: &[i64; 3]| {
        let at = *cell;
        grid([3; 3]).map(move |d| [0, 1, 2].map(|i| 2 * at[i] + d[i]))
    };
    let parts: BTreeSet<[i64; 3]> = cells.iter().flat_map(around).collect();
    let dimension = |p: &[i64; 3]| p.iter().filter(|x| *x % 2 != 0).count();
    parts.iter().map(|p| if dimension(p) % 2 == 0 { 1 } else { -1 }).sum()
}

/// Cells joined through squares.
fn parts_through_squares(cells: &BTreeSet<[i64; 3]>) -> i64 {
    let mut left = cells.clone();
    let mut parts = 0;
    while let Some(first) = left.pop_first() {
        parts += 1;
        let mut pending = vec![first];
        while let Some(c) = pending.pop() {
            for (i, by) in [(0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)] {
                let mut next = c;
                next[i] += by;
                if left.remove(&next) {
                    pending.push(next);
                }
            }
        }
    }
    parts
}

mod me_88 {
    use super::*;

    #[test]
    fn the_genus_of_several_parts_is_the_sum_of_theirs() {
        for [a, b, c] in [[0, 1, 2], [3, 0, 0], [1, 1, 4]] {
            let parts = [a, b, c].map(|g| block_with_through_holes(g).faces);
            let all = disjoint(&parts.each_ref().map(|p| &p[..]));
            assert_eq!((count(&all).shells, count(&all).genus()), (3, Rational::from(a + b + c)));
            assert_eq!(Balance::of(&all).expect("a surface").twice_genus, 2 * (a + b + c));
            assert_eq!(parts.iter().map(|p| count(p).genus()).sum::<Rational>(), count(&all).genus());
        }
    }
}

mod me_90 {
    use super::*;

    #[derive(Clone, Copy, Debug)]
    enum Kind {
        Through,
        Pit,
        Below,
        Cavity,
        Nothing,
    }

    fn cut(kind: Kind, x: i64, y: i64) -> Option<Cut> {
        let cut = |z: i64, w: i64, open: &[BoxSide]| {
            Some(Cut { lo: [2 * x + 1, 2 * y + 1, z], hi: [2 * x + 2, 2 * y + 2, w], open: open.to_vec() })
        };
        match kind {
            Kind::Through => cut(0, 5, &[BoxSide::Bottom, BoxSide::Top]),
            Kind::Pit => cut(3, 5, &[BoxSide::Top]),
            Kind::Below => cut(0, 1, &[BoxSide::Bottom]),
            Kind::Cavity => cut(2, 3, &[]),
            Kind::Nothing => None,
        }
    }

    fn kinds() -> impl Strategy<Value = Vec<Kind>> {
        let kind = prop::sample::select(vec![Kind::Through, Kind::Pit, Kind::Below, Kind::Cavity, Kind::Nothing]);
        prop::collection::vec(kind, 9)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if long() { 1000 } else { 64 }))]

        // C, G, H are known before the block is made.
        #[test]
        fn planted_holes_pits_and_cavities_are_found(kinds in kinds()) {
            let cuts: Vec<Cut> = kinds.iter().zip(grid([3, 3, 1])).filter_map(|(k, [x, y, _])| cut(*k, x, y)).collect();
            let mesh = block([7, 7, 5], &cuts);
            let how_many = |f: fn(&Kind) -> bool| kinds.iter().filter(|k| f(k)).count() as i64;
            let through = how_many(|k| matches!(k, Kind::Through));
            let cavities = how_many(|k| matches!(k, Kind::Cavity));
            let blind = how_many(|k| matches!(k, Kind::Pit | Kind::Below));
            let count = count(&mesh.faces);
            prop_assert_eq!([count.holes, count.shells], [2 * through + blind, 1 + cavities]);
            prop_assert_eq!(count.characteristic(), 2 * (1 + cavities - through));
            prop_assert_eq!(count.genus(), through);
            let chains = ChainComplex::of_faces(&mesh.faces).expect("loops");
            prop_assert_eq!(chains.euler_characteristic(), count.characteristic());
            let homology = chains.homology();
            prop_assert_eq!(homology.betti, [1 + cavities, 2 * through, 1 + cavities].map(|n| n as usize));
            let balance = Balance::of(&mesh.faces).expect("a surface");
            prop_assert!(balance.is_closed_surface());
            prop_assert_eq!((balance.twice_genus, balance.right_side()), (2 * through, count.characteristic()));
        }

        // Where the surface of a solid of cubes is one, χ is twice the solid's, and C counts shells: those of
        // the solid and of the empty space around and in it, less one.
        #[test]
        fn the_surface_of_a_solid_has_twice_its_characteristic(cells in cells(3)) {
            let mesh = cubes(&cells);
            let Ok(balance) = Balance::of(&mesh.faces) else { return Ok(()) };
            if balance.is_closed_surface() {
                let count = balance.counts;
                prop_assert_eq!(count.characteristic(), 2 * chi_of_solid(&cells));
                let outside: BTreeSet<[i64; 3]> = grid([5; 3]).map(|c| c.map(|x| x - 1)).filter(|c| !cells.contains(c)).collect();
                prop_assert_eq!(count.shells, parts_through_squares(&cells) + parts_through_squares(&outside) - 1);
                prop_assert!(count.genus() >= 0 && count.genus().is_integer());
                let betti = ChainComplex::of_faces(&mesh.faces).expect("loops").betti_mod_2();
                prop_assert_eq!(count.genus() * 2, betti[1]);
            }
        }
    }

    #[test]
    fn c_counts_shells_not_solids() {
        let mesh = isoracle::mesh::examples::solids::block_with_cavity();
        let count = count(&mesh.faces);
        assert_eq!((count.characteristic(), count.shells, count.genus()), (4, 2, Rational::from(0)));
        // With C = 1, the one part that the solid has: 4 = 2(1 − G), G = −1.
        assert_eq!(EulerPoincare { shells: 1, ..count }.genus(), -1);
    }

    #[test]
    fn broken_faces_are_refused() {
        let refused = |faces: &[Face]| EulerPoincare::of(faces).expect_err("a broken face");
        assert_eq!(refused(&[Face::from([0, 1, 2]), Face::from([0, 1])]), FaceError::Loop { face: 1, vertices: 2 });
        let empty_hole = Face { outer: vec![0, 1, 2], holes: vec![vec![]] };
        assert_eq!(refused(std::slice::from_ref(&empty_hole)), FaceError::Loop { face: 0, vertices: 0 });
        assert_eq!(refused(&[Face::from([0, 1, 1, 2])]), FaceError::Side { face: 0, vertex: 1 });
        assert_eq!(refused(&[Face::from([0, 1, 0])]), FaceError::Side { face: 0, vertex: 0 });
        assert_eq!(ChainComplex::of_faces(&[empty_hole]), Err(FaceError::Loop { face: 0, vertices: 0 }));
        assert_eq!(count(&[]).characteristic(), 0);
    }
}

mod me_91 {
    use super::*;

    fn balance(mesh: &VertexList) -> Result<Balance, FaceError> {
        Balance::of(&mesh.faces)
    }

    #[test]
    fn solids_whose_surface_is_pinched_need_no_genus() {
        let at_a_corner = cubes(&BTreeSet::from([[0, 0, 0], [1, 1, 1]]));
        let found = count(&at_a_corner.faces);
        assert_eq!([found.vertices, found.edges, found.faces, found.shells], [15, 24, 12, 1]);
        assert_eq!((found.characteristic(), found.genus()), (3, Rational::from((-1, 2))));
        let pinched = balance(&at_a_corner).expect("edges of two faces");
        assert_eq!((pinched.pinches, pinched.sheets, pinched.is_closed_surface()), (1, 2, false));
        assert_eq!(count(&cubes_on_an_edge().faces).characteristic(), 3);
        assert!(balance(&cubes_on_an_edge()).is_err());
        assert!(balance(&frame()).expect("a surface").is_closed_surface());
        let open = Balance::of(&cube().faces[1..]).expect("a surface");
        assert_eq!((open.is_closed_surface(), open.right_side()), (false, 1));
    }

    // A mesh that obeys with an integer G ≥ 0 may still be no solid.
    #[test]
    fn a_klein_bottle_obeys() {
        assert_eq!(count(&triangles(&klein_bottle())).genus(), 1);
    }
}

mod me_94 {
    use super::*;

    proptest! {
        // A solid is on one side of each square at an edge and not on the other: turning around it the sides change.
        #[test]
        fn every_edge_of_a_solid_has_an_even_number_of_faces(cells in cells(3)) {
            let mut uses: BTreeMap<[u32; 2], [i64; 2]> = BTreeMap::new();
            for side in cubes(&cells).faces.iter().flat_map(|f| f.sides().collect::<Vec<_>>()) {
                uses.entry(edge(side)).or_default()[usize::from(side[0] < side[1])] += 1;
            }
            prop_assert!(uses.values().all(|n| *n == [1, 1] || *n == [2, 2]));
        }
    }
}

mod me_102 {
    use super::*;

    #[test]
    fn an_odd_number_of_crosscaps_has_half_a_genus() {
        assert_eq!(count(&triangles(&projective_plane())).genus(), Rational::from((1, 2)));
        assert_eq!(count(&triangles(&klein_bottle())).genus(), 1);
    }

    #[test]
    fn twice_the_genus_is_the_first_betti_number_mod_2() {
        let check = |gluing: Gluing| {
            let faces = triangles(&gluing.triangulated());
            let twice = |s: &isoracle::mesh::classify::Surface| match s.closed {
                ClosedSurface::Orientable { genus } => 2 * genus,
                ClosedSurface::NonOrientable { crosscaps } => crosscaps,
            };
            let sum: usize = gluing.surfaces().iter().map(twice).sum();
            assert_eq!(count(&faces).genus() * 2, sum);
            assert_eq!(ChainComplex::of_faces(&faces).expect("triangles").betti_mod_2()[1], sum);
            assert_eq!(Balance::of(&faces).expect("a surface").twice_genus, sum as i64);
        };
        for sizes in [&[2usize][..], &[4], &[1, 1], &[3, 1]] {
            every_gluing(sizes, false, check);
        }
    }
}

mod me_103 {
    use super::*;

    fn assert_balanced(faces: &[Face]) -> Balance {
        let balance = Balance::of(faces).expect("edges of at most two sides");
        assert_eq!(balance.counts.characteristic(), balance.right_side());
        let chains = ChainComplex::of_faces(faces).expect("loops");
        assert_eq!(balance.right_side(), chains.euler_characteristic());
        assert_eq!(balance.right_side(), alternating_sum(&chains.betti_mod_2()));
        assert_eq!(balance.counts.shells as usize, chains.betti_mod_2()[0]);
        balance
    }

    #[test]
    fn every_term_is_met() {
        let two = [Face::from([0, 1, 2]), Face::from([0, 3, 4])];
        let balance = assert_balanced(&two);
        let Balance { sheets, twice_genus, boundary_loops, pinches, counts } = balance;
        assert_eq!([sheets, twice_genus, boundary_loops, pinches, counts.shells], [2, 0, 2, 1, 1]);
        let band = assert_balanced(&triangles(&moebius_band()));
        assert_eq!([band.sheets, band.twice_genus, band.boundary_loops, band.pinches], [1, 1, 1, 0]);
        // A square with a hole that touches its outer loop, and one whose hole shares an edge with it.
        assert_balanced(&[Face { outer: vec![0, 1, 2, 3], holes: vec![vec![0, 4, 5]] }]);
        assert_balanced(&[Face { outer: vec![0, 1, 2, 3], holes: vec![vec![1, 0, 4]] }]);
        let three = [Face::from([0, 1, 2]), Face::from([1, 0, 3]), Face::from([0, 1, 4])];
        assert_eq!(Balance::of(&three), Err(FaceError::Edge { edge: [0, 1], sides: 3 }));
        assert_balanced(&[]);
    }

    fn face() -> impl Strategy<Value = Face> {
        let vertices = || prop::sample::subsequence((0u32..7).collect::<Vec<_>>(), 3..6).prop_shuffle();
        let holes = prop_oneof![3 => Just(vec![]), 1 => prop::collection::vec(vertices(), 1..3)];
        (vertices(), holes).prop_map(|(outer, holes)| Face { outer, holes })
    }

    proptest! {
        // Any polygons with holes on seven vertices, taken while their edges have at most two sides.
        #[test]
        fn random_faces_are_balanced(faces in prop::collection::vec(face(), 1..12)) {
            let mut taken: Vec<Face> = Vec::new();
            for face in faces {
                taken.push(face);
                if Balance::of(&taken).is_err() {
                    taken.pop();
                }
            }
            assert_balanced(&taken);
        }

        #[test]
        fn solids_of_cubes_are_balanced(cells in cells(3)) {
            let faces = cubes(&cells).faces;
            match Balance::of(&faces) {
                Ok(_) => prop_assert_eq!(assert_balanced(&faces).boundary_loops, 0),
                Err(FaceError::Edge { sides, .. }) => prop_assert_eq!(sides, 4),
                Err(other) => prop_assert!(false, "{}", other),
            }
        }

        #[test]
        fn surfaces_and_surfaces_pinched_are_balanced(gluing in small_gluing(), keep in 3u32..40) {
            let faces = triangles(&gluing.triangulated());
            prop_assert_eq!(assert_balanced(&faces).pinches, 0);
            // Vertices of one number modulo `keep` become one, where no triangle or edge is lost by it.
            let renamed: Vec<Face> = faces.iter().map(|f| Face::new(f.outer.iter().map(|v| v % keep).collect::<Vec<_>>())).collect();
            if Balance::of(&renamed).is_ok() {
                assert_balanced(&renamed);
            }
            // The polygons themselves, where their vertices are different ones.
            let polygons: Vec<Face> = gluing.corners().iter().map(|c| Face::new(c.clone())).collect();
            if let Ok(sheets) = Sheets::new(&polygons) {
                assert_balanced(&polygons);
                prop_assert_eq!(sheets.gluing.polygons().len(), gluing.polygons().len());
            }
        }
    }

    #[test]
    fn the_text_of_an_error_names_its_place() {
        let error = |faces: &[Face]| Balance::of(faces).expect_err("broken").to_string();
        assert_eq!(error(&[Face::from([4, 4, 5])]), "face 0: a side goes from vertex 4 to itself");
        assert_eq!(complex(&[[0, 1, 2]]).euler_characteristic(), 1);
    }
}
