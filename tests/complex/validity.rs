//! What the text says of cells, polyhedra, gluing models and manifolds; and the second derivation on random schemes, on specimens that
//! are broken in one place, and on polyhedra that are nearly balls.

use super::naive_scheme::{found, is_ball};
use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::census::{Census, Kind, kind};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired};
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::polyhedron::PolyhedronFlaw;
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, Reason, SchemeDefect, SignedEdge};
use isoracle::complex::zoo;
use isoracle::mesh::classify::{ClosedSurface, SPHERE};
use isoracle::number::Integer;
use proptest::prelude::*;

fn broken(name: &str) -> GluingScheme {
    zoo::invalid::get(name).expect("a broken scheme").scheme
}

fn specimen(name: &str) -> GluingScheme {
    zoo::get(name).expect("a specimen").scheme
}

/// Polyhedra of all sorts, loops and slits too.
fn balls() -> Vec<Polyhedron> {
    let zipped = specimen("S3-zipped").polyhedra[0].clone();
    let octahedron = specimen("RP3-octahedron").polyhedra[0].clone();
    let slit = specimen("RP3#RP3").polyhedra[0].clone();
    let lenses = (1..=5).map(Polyhedron::lens);
    [Polyhedron::tetrahedron(), Polyhedron::cube(), Polyhedron::prism(3), zipped, octahedron, slit]
        .into_iter()
        .chain(lenses)
        .collect()
}

/// Each polyhedron twice, so that faces can be matched; partners and maps by the choices, most of them against the walks.
fn scheme_of(kinds: &[usize], choices: &[u32]) -> GluingScheme {
    let balls = balls();
    let polyhedra: Vec<Polyhedron> = kinds.iter().chain(kinds).map(|k| balls[k % balls.len()].clone()).collect();
    let mut scheme = GluingScheme { polyhedra, pairings: Vec::new() };
    let mut open: Vec<FaceId> = scheme.faces().collect();
    let mut choices = choices.iter().cycle().map(|n| *n as usize);
    let mut next = || choices.next().expect("choices go round");
    while !open.is_empty() {
        let a = open.remove(0);
        let n = scheme.face(a).expect("a face").len();
        let partners: Vec<usize> =
            (0..open.len()).filter(|i| scheme.face(open[*i]).expect("a face").len() == n).collect();
        let b = open.remove(partners[next() % partners.len()]);
        let (shift, dir) = ((next() % n) as i64, if next().is_multiple_of(6) { 1 } else { -1 });
        scheme.pairings.push(Pairing { a, b, shift, dir });
    }
    scheme
}

/// A manifold's scheme with one pairing turned, mirrored, or two of them crossed.
fn nearly(name: &str, which: usize, how: usize) -> GluingScheme {
    let mut scheme = specimen(name);
    let count = scheme.pairings.len();
    match how % 4 {
        0 => scheme.pairings[which % count].shift += 1,
        1 => scheme.pairings[which % count].dir *= -1,
        2 => scheme.pairings[which % count].shift -= i64::MAX / 2,
        _ => {
            let (i, j) = (which % count, (which / 7 + 1) % count);
            let b = scheme.pairings[i].b;
            scheme.pairings[i].b = scheme.pairings[j].b;
            scheme.pairings[j].b = b;
        }
    }
    scheme
}

/// Everything that both derivations say, compared.
fn agree(scheme: &GluingScheme) {
    if !scheme.defects().is_empty() {
        assert!(ClosedComplex::new(scheme.clone()).is_err() && kind(scheme.clone()).is_err());
        return;
    }
    let found = found(scheme);
    match ClosedComplex::new(scheme.clone()) {
        Err(defects) => {
            assert!(found.edge_reversed && defects.iter().all(|d| d.reason() == Reason::EdgeReversed), "{scheme:?}");
            assert_eq!(kind(scheme.clone()), Ok(Kind::EdgeReversed));
        }
        Ok(complex) => {
            assert!(!found.edge_reversed, "{scheme:?}");
            let mut links = complex.vertex_links();
            links.sort_unstable();
            assert_eq!((complex.counts(), links), (found.cells, found.links.clone()), "{scheme:?}");
            assert_eq!((complex.component_count(), complex.is_orientable()), (found.components, found.orientable));
            assert_eq!(found.euler_characteristic() == 0, found.is_manifold(), "{scheme:?}");
            let valid = Manifold3::of(complex.clone());
            assert_eq!(valid.is_ok(), found.is_manifold());
            if found.is_manifold() {
                assert_eq!(complex.first_homology(), found.h1, "{scheme:?}");
            }
        }
    }
}

proptest! {
    #[test]
    fn both_derivations_agree_on_random_schemes(
        kinds in prop::collection::vec(0..11_usize, 1..3), choices in prop::collection::vec(any::<u32>(), 40)
    ) {
        agree(&scheme_of(&kinds, &choices));
    }

    #[test]
    fn both_derivations_agree_on_what_is_nearly_a_manifold(
        name in prop::sample::select(vec![
            "S3", "S3-two-tetrahedra", "S3-4-simplex", "S3-tesseract", "L(5,2)", "RP3", "T3", "G6", "B4", "KxS1", "Poincare",
            "T3-hexagonal-prism", "octahedral-space", "sol", "RP3#RP3", "Weeks", "T3+RP3",
        ]),
        which in any::<usize>(), how in 0..4_usize
    ) {
        agree(&nearly(name, which, how));
    }
}

mod cx_1 {
    use super::*;

    #[test]
    fn balls_are_told_from_others_by_both() {
        for ball in balls() {
            assert!(ball.flaw().is_none() && is_ball(&ball), "{ball:?}");
        }
        for name in zoo::invalid::names() {
            for polyhedron in broken(name).polyhedra {
                assert_eq!(polyhedron.flaw().is_none(), is_ball(&polyhedron), "{name}");
            }
        }
    }

    #[test]
    fn cycles_that_walk_along_an_edge_the_same_way_have_that_flaw() {
        let turned = [vec![1, 2, 3], vec![0, 3, 2], vec![0, 1, 3], vec![0, 1, 2]];
        let flaw = Polyhedron::of_vertex_cycles(&turned).flaw();
        assert_eq!(flaw, Some(PolyhedronFlaw::SameDirection { edge: 0 }));
        let thrice = [vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4]];
        assert_eq!(Polyhedron::of_vertex_cycles(&thrice).flaw(), Some(PolyhedronFlaw::EdgeUses { edge: 0, uses: 3 }));
    }

    proptest! {
        #[test]
        fn nearly_balls_are_judged_alike(
            which in 0..11_usize, face in any::<usize>(), side in any::<usize>(), how in 0..6_usize, edge in -14..14_i32
        ) {
            let mut p = balls()[which].clone();
            let face = face % p.faces.len();
            let side = side % p.faces[face].len();
            match how {
                0 => p.faces[face][side] = SignedEdge(edge),
                1 => p.faces[face][side].0 *= -1,
                2 => drop(p.faces[face].remove(side)),
                3 => drop(p.faces.remove(face)),
                4 => {
                    let walk = p.faces[face].clone();
                    p.faces.push(walk);
                }
                _ => {
                    let count = p.edges.len();
                    p.edges[side % count][0] = edge.unsigned_abs();
                }
            }
            prop_assert_eq!(p.flaw().is_none(), is_ball(&p));
        }

        #[test]
        fn words_on_one_polygon_are_balls_or_not(sides in prop::collection::vec((1..5_i32, any::<bool>()), 1..9)) {
            // One polygon whose sides are loops at one vertex: a sphere needs several vertices, so only a slit could be one.
            let faces = vec![sides.iter().map(|(e, forward)| SignedEdge(if *forward { *e } else { -e })).collect()];
            let p = Polyhedron { edges: vec![[0, 0]; 4], faces };
            prop_assert_eq!(p.flaw().is_none(), is_ball(&p));
        }
    }
}

mod cx_2 {
    use super::*;

    #[test]
    fn a_gluing_model_may_have_an_edge_that_is_no_line() {
        // Printed: the elements of a model are homeomorphic to ℝ³, ℝ², ℝ¹, ℝ⁰. The one edge of this one is folded at its middle.
        let mut folded = lens_space(1, 0);
        folded.pairings[0].dir = 1;
        assert!(folded.defects().is_empty(), "faces are matched in twos");
        let reversed = SchemeDefect::EdgeReversed { polyhedron: 0, edge: 0 };
        assert_eq!(ClosedComplex::new(folded.clone()), Err(vec![reversed]));
        assert!(found(&folded).edge_reversed);
    }

    #[test]
    fn a_folded_edge_is_told_for_each_class_of_edges_once() {
        let mut two = lens_space(1, 0);
        two.pairings[0].dir = 1;
        let both = isoracle::complex::connected_sum::disjoint_union(&two, &two);
        let defects = ClosedComplex::new(both).expect_err("two edges are folded");
        let edges = [0, 1].map(|polyhedron| SchemeDefect::EdgeReversed { polyhedron, edge: 0 });
        assert_eq!(defects, edges);
    }

    #[test]
    fn no_gluing_against_the_walks_folds_an_edge() {
        // Around the middle of a folded edge stands a projective plane, so the complex is not orientable.
        let census = Census::new(Polyhedron::cube()).expect("a ball");
        let against = census.gluings().filter(|scheme| scheme.pairings.iter().all(|p| p.dir == -1));
        let folded: Vec<bool> = against.map(|scheme| found(&scheme).edge_reversed).collect();
        assert_eq!((folded.len(), folded.contains(&true)), (15 * 64, false));
    }

    #[test]
    fn boundaries_are_made_of_lower_cells() {
        for name in ["T3", "Poincare", "B4", "S3-zipped", "L(7,2)"] {
            let complex = ClosedComplex::new(specimen(name)).expect("a complex");
            // Each cell's boundary is a cycle of cells below, which the constructor of a chain complex checks; all cells
            // stand in it.
            assert_eq!(complex.chain_complex().counts(), complex.counts().to_vec(), "{name}");
            let sides: usize = complex.face_degrees().iter().sum();
            assert_eq!(sides, complex.facet_edge_pairs(), "{name}");
        }
    }
}

mod cx_3 {
    use super::*;

    #[test]
    fn which_faces_are_identified_does_not_say_the_space() {
        // Printed: faces are identified two by two. Opposite faces of a cube, in three ways: three spaces.
        let names = ["T3", "RP3", "quaternion-space"];
        let pairs = |name: &str| {
            let scheme = specimen(name);
            let faces = |p: &Pairing| {
                let corners = |id: FaceId| {
                    let polyhedron = &scheme.polyhedra[0];
                    let sides = scheme.face(id).expect("a face");
                    sides.iter().map(|s| polyhedron.ends(*s).expect("an edge")[0]).collect::<Vec<_>>()
                };
                let [a, b] = [p.a, p.b].map(corners);
                assert!(a.iter().all(|v| !b.contains(v)), "opposite faces have no vertex in common");
            };
            scheme.pairings.iter().for_each(faces);
            assert_eq!((scheme.polyhedra.len(), scheme.pairings.len()), (1, 3), "{name}");
            Manifold3::new(scheme).expect("a manifold").first_homology().to_string()
        };
        assert_eq!(names.map(pairs), ["ℤ³", "ℤ/2", "ℤ/2 ⊕ ℤ/2"]);
    }

    #[test]
    fn no_face_is_left_and_none_is_used_twice() {
        let torus = specimen("T3");
        for i in 0..3 {
            let mut open = torus.clone();
            let Pairing { a, b, .. } = open.pairings.remove(i);
            let mut left = [a, b].map(|face| SchemeDefect::UnmatchedFace { face });
            left.sort_by_key(|defect| format!("{defect:?}"));
            assert_eq!(open.defects(), left);
        }
    }

    #[test]
    fn every_closed_complex_has_a_model() {
        // Its barycentric subdivision is one of tetrahedra, whatever its vertices are.
        for name in ["suspension-torus", "gieseking", "suspension-RP2"] {
            let complex = ClosedComplex::new(broken(name)).expect("a complex");
            let model = zoo::of_triangulation(&complex.barycentric());
            let again = ClosedComplex::new(model).expect("a complex");
            assert_eq!(again.euler_characteristic(), complex.euler_characteristic(), "{name}");
            let singular = |c: &ClosedComplex| {
                let mut links: Vec<ClosedSurface> =
                    c.vertex_links().into_iter().filter(|link| *link != SPHERE).collect();
                links.sort_unstable();
                links
            };
            assert_eq!(singular(&again), singular(&complex), "{name}");
        }
    }
}

mod cx_4 {
    use super::*;

    #[test]
    fn a_gluing_model_need_not_be_a_manifold() {
        let tetrahedron = broken("gieseking");
        assert!(tetrahedron.defects().is_empty(), "faces are identified two by two until none is left");
        let link = ClosedSurface::NonOrientable { crosscaps: 2 };
        let defect = SchemeDefect::VertexLink { vertex: 0, polyhedron: 0, name: 1, link };
        assert_eq!(Manifold3::new(tetrahedron.clone()), Err(vec![defect]));
        assert_eq!(found(&tetrahedron).links, [link]);
    }

    #[test]
    fn most_gluings_of_a_tetrahedron_are_none() {
        let census = Census::new(Polyhedron::tetrahedron()).expect("a ball");
        let of = |which: fn(&Kind) -> bool| {
            census.gluings().filter(|scheme| which(&kind(scheme.clone()).expect("faces are matched"))).count()
        };
        let manifolds = of(|kind| matches!(kind, Kind::Manifold { .. }));
        let links = of(|kind| matches!(kind, Kind::NoManifold(_)));
        let folded = of(|kind| matches!(kind, Kind::EdgeReversed));
        assert_eq!((manifolds, links, folded), (27, 12, 69));
    }
}

mod cx_5 {
    use super::*;

    #[test]
    fn around_each_vertex_of_a_manifold_stands_a_sphere() {
        for name in zoo::names() {
            let manifold = Manifold3::new(specimen(name)).expect("a manifold");
            assert_eq!(manifold.vertex_links(), vec![SPHERE; manifold.counts()[0]], "{name}");
        }
    }

    #[test]
    fn all_singular_vertices_are_told() {
        let complex = ClosedComplex::new(broken("suspension-genus-2")).expect("a complex");
        let defects = Manifold3::of(complex).expect_err("two vertices are singular");
        let link = ClosedSurface::Orientable { genus: 2 };
        let at = |vertex, name| SchemeDefect::VertexLink { vertex, polyhedron: 0, name, link };
        assert_eq!(defects, [at(1, 8), at(2, 9)]);
    }
}

mod euler_characteristics {
    use super::*;

    #[test]
    fn chi_is_half_of_what_the_links_lack() {
        for name in
            ["suspension-RP2", "suspension-torus", "suspension-crosscaps", "gieseking", "genus-2-cusp", "figure-eight"]
        {
            let complex = ClosedComplex::new(broken(name)).expect("a complex");
            let lacks: i64 = complex.vertex_links().iter().map(|link| 2 - link.euler_characteristic()).sum();
            assert_eq!(2 * complex.euler_characteristic(), lacks, "{name}");
            assert!(lacks > 0, "{name}");
        }
    }

    #[test]
    fn without_the_condition_on_edges_chi_says_nothing() {
        // Folded edges can hide what vertices lack: χ = 0 and no manifold.
        let census = Census::new(Polyhedron::cube()).expect("a ball");
        let folded = census
            .gluings()
            .step_by(11)
            .map(|scheme| found(&scheme))
            .find(|found| found.edge_reversed && found.euler_characteristic() == 0);
        assert!(folded.is_some());
    }
}

mod cx_7 {
    use super::*;

    #[test]
    fn of_a_complex_that_is_no_manifold_the_dual_cells_know_the_rest_only() {
        // The dual cells miss the vertices: of the figure-eight they see the knot's complement, ℤ, the cells its quotient.
        let knot = broken("figure-eight");
        let dual = found(&knot).h1;
        let cells = ClosedComplex::new(knot).expect("a complex").first_homology();
        assert_eq!((dual.to_string(), cells.to_string()), ("ℤ".to_owned(), "0".to_owned()));
    }

    #[test]
    fn of_a_manifold_both_are_the_same() {
        for name in ["Seifert-Weber", "Weeks", "G6", "T3-27-cubes", "genus2-turned", "N3xS1"] {
            let scheme = specimen(name);
            let dual = found(&scheme).h1;
            assert_eq!(ClosedComplex::new(scheme).expect("a complex").first_homology(), dual, "{name}");
        }
    }
}

mod torsion_of_products {
    use super::*;

    #[test]
    fn a_projective_space_is_orientable_and_its_torsion_is_no_double() {
        // Printed: four dimensions suffice for the orientable ones.
        let space = Manifold3::new(specimen("RP3")).expect("a manifold");
        assert!(space.is_orientable());
        assert!(!space.first_homology().torsion_is_double());
    }

    #[test]
    fn doubles_are_told_from_others() {
        let group =
            |torsion: &[u32]| AbelianGroup { rank: 1, torsion: torsion.iter().copied().map(Integer::from).collect() };
        for double in [&[][..], &[2, 2], &[2, 2, 6, 6], &[5, 5, 5, 5]] {
            assert!(group(double).torsion_is_double(), "{double:?}");
        }
        for other in [&[2][..], &[2, 4], &[2, 2, 4], &[2, 4, 4, 8], &[5, 5, 5]] {
            assert!(!group(other).torsion_is_double(), "{other:?}");
        }
    }

    #[test]
    fn torsion_of_doubles_is_double() {
        // M less a ball, times an interval, has the boundary M # (−M), and lies in ℝ⁴ for M = L(3, 1): Zeeman's spun lens.
        let sum = Manifold3::new(specimen("L(3,1)#L(3,2)")).expect("a manifold");
        assert!(sum.first_homology().torsion_is_double());
        let quaternions = Manifold3::new(specimen("quaternion-space")).expect("a manifold");
        assert!(quaternions.first_homology().torsion_is_double());
    }
}

#[test]
fn shifts_count_modulo_the_sides() {
    let lens = |shift| Manifold3::new(paired(Polyhedron::lens(5), &[(0, 1, shift, -1)])).expect("a manifold");
    for shift in [i64::MIN, i64::MAX, -3, 7, 1 << 40] {
        assert_eq!(lens(shift).flags(), lens(shift.rem_euclid(5)).flags());
    }
}
