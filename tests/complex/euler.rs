//! Orientation, links and χ, each by a second route.

use crate::every_gluing::{
    cube_gluings, named, one_tetrahedron, random_triangulation, small_complexes, tetrahedron_gluings, triangulation,
};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::paired;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::{FaceId, GluingScheme, Polyhedron, Reason};
use isoracle::complex::triangulation::{EDGES, Triangulation};
use isoracle::complex::triangulation_link::EdgePlace;
use isoracle::mesh::classify::{ClosedSurface, SPHERE};
use isoracle::partition::Partition;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// V, E, F, P of a scheme by its corners and sides alone, whatever becomes of the edges; and how many edges are reversed.
fn counted(scheme: &GluingScheme) -> ([i64; 4], i64) {
    let first: Vec<usize> =
        scheme.polyhedra.iter().scan(0, |sum, p| Some(std::mem::replace(sum, *sum + p.edges.len()))).collect();
    let n = scheme.polyhedra.iter().map(|p| p.edges.len()).sum();
    // Ends 2e, 2e + 1 of edge e; and the edges.
    let (mut ends, mut edges) = (Partition::new(2 * n), Partition::new(n));
    let mut named: BTreeMap<(usize, u32), usize> = BTreeMap::new();
    let mut corners = Partition::new(2 * n);
    for (p, polyhedron) in scheme.polyhedra.iter().enumerate() {
        for (e, vertices) in polyhedron.edges.iter().enumerate() {
            for (end, vertex) in vertices.iter().enumerate() {
                let at = 2 * (first[p] + e) + end;
                corners.join(*named.entry((p, *vertex)).or_insert(at), at);
            }
        }
    }
    let side = |face: FaceId, i: i64| {
        let sides = scheme.face(face).expect("a face");
        let signed = sides[i.rem_euclid(sides.len() as i64) as usize];
        let edge = first[face.polyhedron] + signed.index().expect("an edge");
        if signed.is_forward() { [2 * edge, 2 * edge + 1] } else { [2 * edge + 1, 2 * edge] }
    };
    for pairing in &scheme.pairings {
        for i in 0..scheme.face(pairing.a).expect("a face").len() as i64 {
            let [a, b] = side(pairing.a, i);
            let [c, d] = match pairing.dir {
                1 => side(pairing.b, pairing.shift + i),
                // From corner shift − i to corner shift − i − 1.
                _ => {
                    let [c, d] = side(pairing.b, pairing.shift - i - 1);
                    [d, c]
                }
            };
            edges.join(a / 2, c / 2);
            for (x, y) in [(a, c), (b, d)] {
                ends.join(x, y);
                corners.join(x, y);
            }
        }
    }
    let classes = |parts: &mut Partition, n: usize| (0..n).map(|i| parts.find(i)).collect::<BTreeSet<_>>().len() as i64;
    let reversed: BTreeSet<usize> =
        (0..n).filter(|e| ends.find(2 * e) == ends.find(2 * e + 1)).map(|e| edges.find(e)).collect();
    let counts = [classes(&mut corners, 2 * n), classes(&mut edges, n)];
    let faces = scheme.pairings.len() as i64;
    ([counts[0], counts[1], faces, scheme.polyhedra.len() as i64], reversed.len() as i64)
}

/// A tetrahedron for each side of each face: tail, head, the middle of the face, the middle of the polyhedron. Edges stay whole,
/// so a reversed one stays reversed.
fn coned(scheme: &GluingScheme) -> Triangulation {
    let mut at: BTreeMap<FaceId, usize> = BTreeMap::new();
    let mut n = 0;
    for face in scheme.faces() {
        at.insert(face, n);
        n += scheme.face(face).expect("a face").len();
    }
    let mut pairs = Vec::new();
    let (same, turned) = (Perm4::IDENTITY, Perm4::new([1, 0, 2, 3]).expect("a permutation"));
    let mut uses: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for (face, first) in &at {
        let sides = scheme.face(*face).expect("a face");
        for (i, side) in sides.iter().enumerate() {
            // The head of a side is the tail of the next one.
            pairs.push(([first + i, 0], [first + (i + 1) % sides.len(), 1], turned));
            let edge = (face.polyhedron, side.index().expect("an edge"));
            if let Some(other) = uses.insert(edge, first + i) {
                pairs.push(([other, 2], [first + i, 2], turned));
            }
        }
    }
    for pairing in &scheme.pairings {
        let sides = scheme.face(pairing.a).expect("a face").len() as i64;
        for i in 0..sides {
            let (j, corners) =
                if pairing.dir == 1 { (pairing.shift + i, same) } else { (pairing.shift - i - 1, turned) };
            pairs.push(([at[&pairing.a] + i as usize, 3], [at[&pairing.b] + j.rem_euclid(sides) as usize, 3], corners));
        }
    }
    triangulation(n, &pairs)
}

fn chi([v, e, f, p]: [i64; 4]) -> i64 {
    v - e + f - p
}

/// The closed complexes of small schemes.
fn complexes() -> Vec<ClosedComplex> {
    named().into_iter().map(|(_, complex)| complex).chain(small_complexes(5)).collect()
}

mod cx_69 {
    use super::*;

    #[test]
    fn chi_is_told_by_the_links_of_every_small_complex() {
        for complex in complexes() {
            let (counts, reversed) = counted(complex.scheme());
            assert_eq!((counts, reversed), (complex.counts().map(|n| n as i64), 0));
            assert_eq!(complex.euler_characteristic(), chi(counts));
            assert_eq!(complex.euler_characteristic_by_links(), chi(counts), "{:?}", complex.scheme().pairings);
            assert_eq!(complex.tetrahedra().euler_characteristic_by_links(), chi(counts));
        }
    }

    #[test]
    fn each_reversed_edge_takes_a_half() {
        for triangulation in one_tetrahedron() {
            assert_eq!(triangulation.euler_characteristic_by_links(), triangulation.euler_characteristic());
        }
    }

    #[test]
    fn chi_is_told_by_the_links_of_every_glued_cube() {
        let step = if crate::is_long() { 1 } else { 7 };
        let mut reversed_cubes = 0;
        for scheme in tetrahedron_gluings().into_iter().chain(cube_gluings().into_iter().step_by(step)) {
            let (counts, reversed) = counted(&scheme);
            let cones = coned(&scheme);
            assert_eq!(cones.reversed_edges().len() as i64, reversed);
            assert_eq!(cones.euler_characteristic(), chi(counts));
            assert_eq!(cones.euler_characteristic_by_links(), chi(counts), "{:?}", scheme.pairings);
            reversed_cubes += usize::from(reversed > 0);
        }
        assert!(reversed_cubes > 300);
    }

    proptest! {
        #[test]
        fn chi_is_told_by_the_links_of_random_triangulations(triangulation in random_triangulation(6)) {
            prop_assert_eq!(triangulation.euler_characteristic_by_links(), triangulation.euler_characteristic());
        }
    }
}

mod cx_70 {
    use super::*;

    #[test]
    fn chi_is_zero_iff_all_links_are_spheres() {
        let mut both = [0, 0];
        for complex in complexes() {
            let manifold = complex.vertex_links().iter().all(|link| *link == SPHERE);
            assert_eq!(complex.euler_characteristic() == 0, manifold);
            assert_eq!(Manifold3::of(complex).is_ok(), manifold);
            both[usize::from(manifold)] += 1;
        }
        assert!(both.iter().all(|n| *n > 20), "{both:?}");
    }

    /// The schemes that have an edge reversed and χ = 0 all the same.
    fn deceptive(schemes: Vec<GluingScheme>) -> Vec<GluingScheme> {
        let deceives = |scheme: &GluingScheme| {
            let (counts, reversed) = counted(scheme);
            let refused = ClosedComplex::new(scheme.clone())
                .is_err_and(|defects| defects.iter().all(|defect| defect.reason() == Reason::EdgeReversed));
            assert_eq!(refused, reversed > 0);
            reversed > 0 && chi(counts) == 0
        };
        schemes.into_iter().filter(deceives).collect()
    }

    #[test]
    fn chi_alone_is_no_test() {
        assert_eq!(deceptive(tetrahedron_gluings()).len(), 30);
        // With an even number of edges reversed, each of them.
        let cubes = deceptive(cube_gluings());
        assert_eq!(cubes.len(), 1446);
        assert!(cubes.iter().all(|scheme| counted(scheme).1 == 2));
    }

    #[test]
    fn the_least_complex_that_deceives() {
        let scheme = paired(Polyhedron::tetrahedron(), &[(0, 1, 0, -1), (2, 3, 0, 1)]);
        assert_eq!(counted(&scheme), ([1, 2, 2, 1], 1));
        let defects = ClosedComplex::new(scheme).expect_err("an edge is reversed");
        assert_eq!(defects.iter().map(|defect| defect.reason()).collect::<Vec<_>>(), [Reason::EdgeReversed]);
    }

    #[test]
    fn a_reversed_edge_among_spheres_makes_chi_negative() {
        let spheres = |t: &Triangulation| t.vertex_links().iter().all(|link| *link == SPHERE);
        for triangulation in one_tetrahedron().into_iter().filter(spheres) {
            let reversed = triangulation.reversed_edges().len() as i64;
            assert_eq!(2 * triangulation.euler_characteristic(), -reversed);
        }
    }

    #[test]
    fn so_many_gluings_are_manifolds() {
        let manifolds = |schemes: Vec<GluingScheme>| {
            let zero = |scheme: &GluingScheme| {
                let (counts, reversed) = counted(scheme);
                reversed == 0 && chi(counts) == 0
            };
            schemes.iter().filter(|scheme| zero(scheme)).count()
        };
        assert_eq!([manifolds(tetrahedron_gluings()), manifolds(cube_gluings())], [27, 625]);
    }
}

mod cx_71 {
    use super::*;

    #[test]
    fn five_routes_tell_orientability() {
        let mut both = [0, 0];
        for complex in complexes() {
            let orientable = complex.is_orientable();
            assert_eq!(complex.polyhedron_signs().is_some(), orientable);
            let h3 = complex.chain_complex().homology().betti[3];
            assert_eq!(h3 == complex.component_count(), orientable);
            for triangulation in [complex.tetrahedra(), complex.barycentric()] {
                let components = triangulation.components();
                assert_eq!(triangulation.is_orientable(), orientable);
                assert_eq!(components.orientable.len(), complex.component_count());
                assert_eq!(components.orientable.iter().filter(|o| **o).count(), h3);
            }
            both[usize::from(orientable)] += 1;
        }
        assert!(both.iter().all(|n| *n > 20), "{both:?}");
    }

    #[test]
    fn signs_agree_with_the_pairings() {
        for complex in complexes() {
            let Some(signs) = complex.polyhedron_signs() else { continue };
            for pairing in &complex.scheme().pairings {
                let [a, b] = [pairing.a, pairing.b].map(|face| signs[face.polyhedron]);
                assert_eq!(a == b, pairing.dir == -1);
            }
        }
    }

    proptest! {
        #[test]
        fn oriented_gluings_are_those_with_a_cycle_of_tetrahedra(triangulation in random_triangulation(4)) {
            if let Ok(chains) = triangulation.chain_complex() {
                let components = triangulation.components();
                let orientable = components.orientable.iter().filter(|o| **o).count();
                prop_assert_eq!(chains.homology().betti[3], orientable);
                prop_assert_eq!(chains.component_count(), components.orientable.len());
            }
        }
    }
}

mod cx_72 {
    use super::*;

    /// The links at the vertices of a complex, seen from a triangulation of it whose corner of this number is the vertex there.
    fn links_seen(complex: &ClosedComplex, triangulation: &Triangulation) -> Vec<Option<ClosedSurface>> {
        let skeleton = triangulation.skeleton();
        let links = triangulation.vertex_links();
        let first: Vec<_> = match triangulation.len() == complex.flags().len() {
            true => complex.flags().all().collect(),
            false => complex.tetrahedron_flags(),
        };
        let mut seen = vec![None; complex.counts()[0]];
        for (t, flag) in first.into_iter().enumerate() {
            let link = links[skeleton.vertices[t][0] as usize];
            let place = &mut seen[complex.cell(0, flag) as usize];
            assert!(place.is_none_or(|other| other == link));
            *place = Some(link);
        }
        seen
    }

    #[test]
    fn links_of_tetrahedra_are_those_of_flags() {
        for complex in complexes() {
            let links: Vec<Option<ClosedSurface>> = complex.vertex_links().into_iter().map(Some).collect();
            assert_eq!(links_seen(&complex, &complex.tetrahedra()), links);
            assert_eq!(links_seen(&complex, &complex.barycentric()), links);
        }
    }

    #[test]
    fn all_other_links_are_spheres() {
        for complex in complexes() {
            for (triangulation, primal) in [(complex.tetrahedra(), [0, 1]), (complex.barycentric(), [0, 0])] {
                let (skeleton, links) = (triangulation.skeleton(), triangulation.vertex_links());
                for vertices in &skeleton.vertices {
                    for corner in (0..4).filter(|corner| !primal.contains(corner)) {
                        assert_eq!(links[vertices[corner] as usize], SPHERE);
                    }
                }
            }
        }
    }

    #[test]
    fn no_scheme_shows_every_link_by_a_sphere() {
        let surfaces: BTreeSet<ClosedSurface> = complexes().iter().flat_map(ClosedComplex::vertex_links).collect();
        let expected = [
            SPHERE,
            ClosedSurface::Orientable { genus: 1 },
            ClosedSurface::NonOrientable { crosscaps: 1 },
            ClosedSurface::NonOrientable { crosscaps: 2 },
        ];
        assert!(expected.iter().all(|surface| surfaces.contains(surface)), "{surfaces:?}");
    }
}

mod cx_73 {
    use super::*;

    fn rings_are_circles(triangulation: &Triangulation) {
        let skeleton = triangulation.skeleton();
        let reversed = triangulation.reversed_edges();
        for (t, edges) in skeleton.edges.iter().enumerate() {
            for (edge, [tail, head]) in edges.iter().zip(EDGES) {
                let place = EdgePlace { tetrahedron: t as u32, tail: tail as u8, head: head as u8 };
                let ring = triangulation.edge_ring(place);
                let unordered = |p: &EdgePlace| (p.tetrahedron, p.tail.min(p.head), p.tail.max(p.head));
                let seen: BTreeSet<_> = ring.iter().map(unordered).collect();
                let places = skeleton.edges.iter().flatten().filter(|e| *e == edge).count();
                assert_eq!(seen.len(), places);
                assert_eq!(ring.iter().collect::<BTreeSet<_>>().len(), ring.len());
                assert_eq!(ring.len(), if reversed.contains(edge) { 2 * places } else { places });
            }
        }
    }

    #[test]
    fn the_tetrahedra_around_an_edge_make_one_circle() {
        one_tetrahedron().iter().for_each(rings_are_circles);
        small_complexes(97).iter().for_each(|complex| rings_are_circles(&complex.tetrahedra()));
    }

    #[test]
    fn the_ring_of_a_reversed_edge_goes_round_twice() {
        let cones = coned(&paired(Polyhedron::tetrahedron(), &[(0, 1, 0, -1), (2, 3, 0, 1)]));
        let reversed = cones.reversed_edges();
        assert_eq!(reversed.len(), 1);
        let edges = cones.skeleton().edges;
        let (t, place) = (0..edges.len())
            .find_map(|t| Some((t, edges[t].iter().position(|e| *e == reversed[0])?)))
            .expect("it has a place");
        let [tail, head] = EDGES[place].map(|corner| corner as u8);
        let ring = cones.edge_ring(EdgePlace { tetrahedron: t as u32, tail, head });
        assert_eq!(ring.len(), 2 * edges.iter().flatten().filter(|e| **e == reversed[0]).count());
    }

    #[test]
    fn the_ring_of_a_primal_edge_is_that_of_its_faces() {
        for complex in complexes().into_iter().step_by(7) {
            let (triangulation, sizes) = (complex.tetrahedra(), complex.edge_ring_sizes());
            for (t, flag) in complex.tetrahedron_flags().into_iter().enumerate() {
                let ring = triangulation.edge_ring(EdgePlace { tetrahedron: t as u32, tail: 0, head: 1 });
                assert_eq!(ring.len(), sizes[complex.cell(1, flag) as usize]);
                let ring = triangulation.edge_ring(EdgePlace { tetrahedron: t as u32, tail: 2, head: 3 });
                assert_eq!(ring.len(), complex.face_degrees()[complex.cell(2, flag) as usize]);
            }
        }
    }

    proptest! {
        #[test]
        fn rings_of_random_triangulations_are_circles(triangulation in random_triangulation(5)) {
            rings_are_circles(&triangulation);
        }
    }
}
