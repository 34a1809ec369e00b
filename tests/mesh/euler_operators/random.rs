//! Random sequences of operators.

use super::building::boundary_of;
use super::meshes::{mesh, meshes};
use super::small::by_homology;
use super::states::{KINDS, boundary, operators_of};
use super::words::{Words, applied};
use isoracle::mesh::euler_operators::{Boundary, Operator, construction, replay};
use isoracle::mesh::face::Face;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// The kind of the next operator, mev, mef, kemr and kfmrh more often, and which of those allowed it is.
fn choices() -> impl Strategy<Value = Vec<(usize, usize)>> {
    let kind = prop_oneof![3 => Just(2usize), 3 => Just(4), 2 => Just(6), 2 => Just(8), 1 => 0..KINDS];
    prop::collection::vec((kind, any::<prop::sample::Index>().prop_map(|i| i.index(1 << 20))), 1..14)
}

/// Where sequences begin: at nothing, or near what is special: a strut, rings, closed edges, a handle, two shells.
fn starts() -> impl Strategy<Value = Boundary> {
    let meshes = ["nothing", "segment", "hollow triangle", "lamina triangle"].map(|name| boundary_of(&mesh(name)));
    let glued: [&[Vec<Vec<u32>>]; 4] = [
        &[vec![vec![0, 2, 1, 3]]],
        &[vec![vec![0], vec![]], vec![vec![1]]],
        &[vec![vec![], vec![]], vec![vec![0, 1]]],
        &[vec![vec![0], vec![2]], vec![vec![1], vec![3]]],
    ];
    prop::sample::select([&meshes[..], &glued.map(boundary)[..]].concat())
}

/// The allowed operators of a kind.
fn allowed(b: &Boundary, kind: usize) -> Vec<Operator> {
    operators_of(b, kind).into_iter().filter(|operator| b.clone().apply(operator).is_ok()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn sequences_keep_everything_and_are_undone(start in starts(), choices in choices()) {
        let mut boundary = start.clone();
        let mut undone_by = Vec::new();
        for (kind, which) in choices {
            let operators = match allowed(&boundary, kind) {
                none if none.is_empty() => allowed(&boundary, 0),
                some => some,
            };
            let operator = &operators[which % operators.len()];
            let expected = applied(&boundary, operator);
            let before = boundary.clone();
            let inverse = boundary.apply(operator).expect("it is allowed");
            prop_assert_eq!(Some(Words::of(&boundary).sorted()), expected);
            prop_assert_eq!(boundary.defects(), []);
            prop_assert_eq!(boundary.tracked(), by_homology(&boundary));
            let mut back = boundary.clone();
            prop_assert_eq!(back.apply(&inverse), Ok(operator.clone()));
            prop_assert_eq!(&back, &before);
            undone_by.push(inverse);
        }
        prop_assert_eq!(replay(&construction(&boundary)), Ok(boundary.clone()));
        for inverse in undone_by.iter().rev() {
            boundary.apply(inverse).expect("it undoes what was done last");
        }
        prop_assert_eq!(boundary, start);
    }
}

/// A mesh, perhaps with a mistake: one vertex called as another, a face left out, turned over, or there twice.
fn meshes_with_mistakes() -> impl Strategy<Value = Vec<Face>> {
    let mesh =
        prop::sample::select(meshes().into_iter().map(|mesh| mesh.faces).filter(|f| !f.is_empty()).collect::<Vec<_>>());
    (mesh, 0..5, any::<prop::sample::Index>(), 0..24u32, 0..24u32).prop_map(|(mut faces, mistake, which, v, w)| {
        let i = which.index(faces.len());
        match mistake {
            0 => {}
            1 => {
                let loops = faces.iter_mut().flat_map(|face| face.holes.iter_mut().chain([&mut face.outer]));
                loops.flatten().filter(|u| **u == v).for_each(|u| *u = w);
            }
            2 => _ = faces.remove(i),
            3 => faces[i] = faces[i].reversed(),
            _ => faces.push(faces[i].clone()),
        }
        faces
    })
}

/// Whether each side has one opposite, and the corners at each vertex, from the vertex before to the one after, make one
/// cycle of its neighbours.
fn is_closed(faces: &[Face]) -> bool {
    let sides: Vec<[u32; 2]> = faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).collect();
    let count = |side: [u32; 2]| sides.iter().filter(|other| **other == side).count();
    if sides.iter().any(|&[a, b]| a == b || count([a, b]) != 1 || count([b, a]) != 1) {
        return false;
    }
    let mut after: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for word in faces.iter().flat_map(Face::loops) {
        for i in 0..word.len() {
            let (before, v) = (word[i], word[(i + 1) % word.len()]);
            after.entry(v).or_default().insert(before, word[(i + 2) % word.len()]);
        }
    }
    after.values().all(|link| {
        let first = *link.keys().next().expect("it has a corner");
        let cycle = std::iter::successors(Some(link[&first]), |v| (*v != first).then(|| link[v]));
        cycle.count() == link.len()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn faces_are_taken_iff_they_are_closed(faces in meshes_with_mistakes()) {
        let boundary = Boundary::try_from(&faces[..]);
        prop_assert_eq!(boundary.is_ok(), is_closed(&faces), "{:?}", boundary);
        if let Ok(boundary) = boundary {
            prop_assert_eq!(boundary.defects(), []);
            prop_assert_eq!(replay(&construction(&boundary)), Ok(boundary));
        }
    }
}
