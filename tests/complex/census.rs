//! All gluings of one tetrahedron, of one cube, and of other small polyhedra: each classified twice.

use super::naive_scheme::found;
use insta::assert_snapshot;
use isoracle::complex::census::{Census, Kind, kind};
use isoracle::complex::scheme::{GluingScheme, Pairing, Polyhedron};
use isoracle::complex::symmetry::{Symmetry, symmetries};
use std::collections::{BTreeMap, BTreeSet};

/// Snapshots stand beside the tests' folder.
pub fn snapshots(check: impl FnOnce()) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(check);
}

/// The kind of a gluing by the second derivation.
fn naive_kind(scheme: &GluingScheme) -> Kind {
    let found = found(scheme);
    match (found.edge_reversed, found.is_manifold()) {
        (true, _) => Kind::EdgeReversed,
        (false, true) => Kind::Manifold { orientable: found.orientable, h1: found.h1, cells: found.cells },
        (false, false) => Kind::NoManifold(found.links),
    }
}

fn of(polyhedron: Polyhedron) -> Census {
    Census::new(polyhedron).expect("a ball")
}

/// The pairings of a gluing: faces, shift, dir.
type Pairings = Vec<[i64; 4]>;

/// How many gluings of a kind there are, and their classes under two groups.
#[derive(Default)]
struct Tally {
    gluings: usize,
    classes: [BTreeSet<Pairings>; 2],
}

/// The least of the images of a gluing under the symmetries.
fn least(scheme: &GluingScheme, symmetries: &[Symmetry]) -> Pairings {
    let key = |p: &Pairing| [p.a.face as i64, p.b.face as i64, p.shift, p.dir];
    let images = symmetries.iter().map(|symmetry| symmetry.image(scheme).iter().map(key).collect());
    images.min().expect("the identity is one")
}

/// The totals, gluings and classes up to symmetry, a line a kind.
fn totals(census: &Census) -> String {
    let symmetries = symmetries(census.polyhedron());
    let rotations: Vec<Symmetry> = symmetries.iter().filter(|s| s.is_rotation()).cloned().collect();
    let mut tally: BTreeMap<Kind, Tally> = BTreeMap::new();
    for scheme in census.gluings() {
        let kind = kind(scheme.clone()).expect("faces are matched");
        assert_eq!(kind, naive_kind(&scheme), "{:?}", scheme.pairings);
        let of_kind = tally.entry(kind).or_default();
        of_kind.gluings += 1;
        of_kind.classes[0].insert(least(&scheme, &symmetries));
        of_kind.classes[1].insert(least(&scheme, &rotations));
    }
    let sum = |i: usize| tally.values().map(|of_kind| of_kind.classes[i].len()).sum::<usize>();
    let count = tally.values().map(|of_kind| of_kind.gluings).sum::<usize>();
    assert_eq!(Some(count as u128), census.count());
    assert_eq!([sum(0), sum(1)], [&symmetries[..], &rotations].map(|group| by_burnside(census, group)));
    let mut lines = vec!["gluings, up to rotations and reflections, up to rotations".to_owned()];
    lines.push(format!("{count:5} {:4} {:4}  all", sum(0), sum(1)));
    for (kind, Tally { gluings, classes }) in &tally {
        lines.push(format!("{gluings:5} {:4} {:4}  {kind}", classes[0].len(), classes[1].len()));
    }
    lines.join("\n")
}

/// The number of classes as the mean number of gluings that a symmetry leaves as they are.
fn by_burnside(census: &Census, group: &[Symmetry]) -> usize {
    let identity = &group[..1];
    let fixed = |scheme: &GluingScheme| {
        let itself = least(scheme, identity);
        group.iter().filter(|symmetry| least(scheme, std::slice::from_ref(*symmetry)) == itself).count()
    };
    let fixed: usize = census.gluings().map(|scheme| fixed(&scheme)).sum();
    assert_eq!(fixed % group.len(), 0, "the symmetries are a group");
    fixed / group.len()
}

mod cx_9 {
    use super::*;

    #[test]
    fn gluings_are_counted_by_the_formula_and_differ() {
        let cases = [
            (Polyhedron::tetrahedron(), 108),
            (Polyhedron::cube(), 7_680),
            (Polyhedron::prism(3), 0),
            (Polyhedron::lens(1), 2),
            (Polyhedron::lens(7), 14),
            (Polyhedron::prism(5), 0),
        ];
        for (polyhedron, count) in cases {
            let census = of(polyhedron);
            assert_eq!(census.count(), Some(count));
            let all: Vec<GluingScheme> = census.gluings().collect();
            assert_eq!(all.len() as u128, count);
            let different: BTreeSet<String> = all.iter().map(|scheme| format!("{:?}", scheme.pairings)).collect();
            assert_eq!(different.len(), all.len());
            assert!(all.iter().all(|scheme| scheme.defects().is_empty()));
            assert_eq!(census.gluing(count), None);
        }
        // The hexagonal prism: 15·8³ ways for the sides, 12 for the ends; the octahedron: 7!!·6⁴.
        assert_eq!(of(Polyhedron::prism(6)).count(), Some(15 * 512 * 12));
        let octahedron = isoracle::complex::zoo::get("RP3-octahedron").expect("a specimen").scheme;
        assert_eq!(of(octahedron.polyhedra[0].clone()).count(), Some(105 * 1_296));
    }

    #[test]
    fn every_pairing_of_faces_and_every_map_occurs() {
        let mut seen = BTreeSet::new();
        for scheme in of(Polyhedron::tetrahedron()).gluings() {
            seen.extend(scheme.pairings.iter().map(|p| (p.a.face, p.b.face, p.shift, p.dir)));
        }
        assert_eq!(seen.len(), 6 * 6);
    }

    #[test]
    fn numbers_beyond_all_machine_integers_are_no_number() {
        // 62 digons and a slit: 61!!·4³¹ < 2¹²⁸ < 63!!·4³².
        let stack = |digons: i32| {
            let edges = vec![[0, 1]; digons as usize];
            let next = |i: i32| if i == digons { 1 } else { i + 1 };
            let faces = (1..=digons).map(|i| vec![i, -next(i)].into_iter().map(isoracle::complex::scheme::SignedEdge));
            Polyhedron { edges, faces: faces.map(Iterator::collect).collect() }
        };
        assert!(of(stack(40)).count().is_some());
        assert_eq!(of(stack(64)).count(), None);
        assert_eq!(of(stack(65)).count(), Some(0), "one face is always left");
        assert!(of(stack(64)).gluing(12_345).is_some());
    }

    #[test]
    fn no_ball_has_no_census() {
        let mut open = Polyhedron::cube();
        open.faces.pop();
        assert!(Census::new(open).is_err());
    }
}

mod cx_10 {
    use super::*;

    #[test]
    fn the_gluings_of_a_tetrahedron() {
        snapshots(|| assert_snapshot!("cx_10__tetrahedron", totals(&of(Polyhedron::tetrahedron()))));
    }
}

mod cx_11 {
    use super::*;

    #[test]
    fn the_gluings_of_a_cube() {
        snapshots(|| assert_snapshot!("cx_11__cube", totals(&of(Polyhedron::cube()))));
    }
}

mod cx_13 {
    use super::*;

    #[test]
    fn symmetries_are_as_many_as_known() {
        let known = [
            (Polyhedron::tetrahedron(), 24),
            (Polyhedron::cube(), 48),
            (Polyhedron::prism(3), 12),
            (Polyhedron::prism(5), 20),
            (Polyhedron::lens(1), 4),
            (Polyhedron::lens(6), 24),
        ];
        for (polyhedron, order) in known {
            let all = symmetries(&polyhedron);
            assert_eq!(all.len(), order);
            assert_eq!(all.iter().filter(|symmetry| symmetry.is_rotation()).count(), order / 2);
            assert!((1..order).all(|i| !all[..i].contains(&all[i])), "they differ");
        }
        for (name, order) in [("RP3-octahedron", 48), ("Poincare", 120), ("octahedral-space", 48)] {
            let specimen = isoracle::complex::zoo::get(name).expect("a specimen");
            // The dodecahedron of pyrite has, as faces go, all symmetries of the regular one.
            assert_eq!(symmetries(&specimen.scheme.polyhedra[0]).len(), order, "{name}");
        }
    }

    #[test]
    fn the_image_of_a_gluing_is_the_same_space() {
        let census = of(Polyhedron::cube());
        let all = symmetries(census.polyhedron());
        let step = if crate::is_long() { 1 } else { 37 };
        for scheme in census.gluings().step_by(step) {
            let before = kind(scheme.clone()).expect("faces are matched");
            for symmetry in all.iter().step_by(5) {
                let image = GluingScheme { pairings: symmetry.image(&scheme), ..scheme.clone() };
                assert_eq!(kind(image).expect("faces are matched"), before);
            }
        }
    }

    #[test]
    fn an_open_surface_has_no_symmetries() {
        let mut open = Polyhedron::cube();
        open.faces.pop();
        assert!(symmetries(&open).is_empty());
    }
}

#[test]
fn the_gluings_of_a_hexagonal_prism_are_seen_alike_by_both() {
    let census = of(Polyhedron::prism(6));
    let step = if crate::is_long() { 7 } else { 911 };
    for scheme in census.gluings().step_by(step) {
        assert_eq!(kind(scheme.clone()).expect("faces are matched"), naive_kind(&scheme), "{:?}", scheme.pairings);
    }
}
