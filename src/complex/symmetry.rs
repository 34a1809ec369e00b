//! Symmetries of a polyhedron's surface, and which of its gluings are the same up to them.

use super::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use std::collections::BTreeMap;

/// A symmetry of a polyhedron: where each face goes, corner i of it to corner shift + dir · i.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// By face: the image, and (shift, dir) of its corners.
    faces: Vec<(usize, i64, i64)>,
}

impl Symmetry {
    /// Whether it is a rotation, and no reflection.
    pub fn is_rotation(&self) -> bool {
        self.faces.iter().all(|(_, _, dir)| *dir == 1)
    }

    /// The image of a gluing of the polyhedron with itself: pairings from lesser to greater faces, sorted, 0 ≤ shift < n.
    pub fn image(&self, scheme: &GluingScheme) -> Vec<Pairing> {
        let n = |id: FaceId| scheme.face(id).map_or(1, <[_]>::len) as i64;
        let pairing = |p: &Pairing| {
            let [(a, shift_a, dir_a), (b, shift_b, dir_b)] = [p.a, p.b].map(|id| self.faces[id.face]);
            // Corner x of the image of a is corner dir_a·(x − shift_a) of a.
            let dir = dir_b * p.dir * dir_a;
            let shift = shift_b + dir_b * p.shift.rem_euclid(n(p.a)) - dir * shift_a;
            let [a, b] = [a, b].map(|face| FaceId { polyhedron: 0, face });
            let (a, b, shift) = if a < b { (a, b, shift) } else { (b, a, -dir * shift) };
            Pairing { a, b, shift: shift.rem_euclid(n(p.a)), dir }
        };
        let mut pairings: Vec<Pairing> = scheme.pairings.iter().map(pairing).collect();
        pairings.sort_unstable_by_key(|p| (p.a, p.b));
        pairings
    }
}

/// All symmetries of a ball's surface, reflections too; the identity is the first. Empty iff it is not a ball.
///
/// A symmetry is known from where it takes one side of one face, and in which direction.
#[doc(alias = "CX-13")]
pub fn symmetries(polyhedron: &Polyhedron) -> Vec<Symmetry> {
    if polyhedron.flaw().is_some() {
        return Vec::new();
    }
    let faces = &polyhedron.faces;
    // The other side of the same edge.
    let mut places: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
    for (face, sides) in faces.iter().enumerate() {
        for (i, side) in sides.iter().enumerate() {
            places.entry(side.index().expect("a ball's side")).or_default().push((face, i));
        }
    }
    let across = |place: (usize, usize)| {
        let both = &places[&faces[place.0][place.1].index().expect("a ball's side")];
        both[usize::from(both[0] == place)]
    };
    let starts = faces.iter().enumerate().flat_map(|(face, sides)| (0..sides.len()).map(move |i| (face, i)));
    let starts = [1, -1].into_iter().flat_map(|dir| starts.clone().map(move |start| (start, dir)));
    starts.filter_map(|(start, dir)| extended(faces, start, dir, &across)).collect()
}

/// The symmetry that takes side 0 of face 0 to this side, along its walk or against it, if there is one.
fn extended(
    faces: &[Vec<super::scheme::SignedEdge>],
    start: (usize, usize),
    dir: i64,
    across: &impl Fn((usize, usize)) -> (usize, usize),
) -> Option<Symmetry> {
    // Side i goes to side shift + i along the walk; against it to side shift − 1 − i, since it is named by its beginning.
    let image = |(to, shift, dir): (usize, i64, i64), i: usize| {
        let side = if dir == 1 { shift + i as i64 } else { shift - 1 - i as i64 };
        (to, side.rem_euclid(faces[to].len() as i64) as usize)
    };
    let mapped = |face: usize, i: usize, (to, j): (usize, usize)| {
        let n = faces[to].len() as i64;
        let shift = if dir == 1 { j as i64 - i as i64 } else { j as i64 + 1 + i as i64 };
        (faces[face].len() == faces[to].len()).then(|| (to, shift.rem_euclid(n), dir))
    };
    let mut images = vec![None; faces.len()];
    images[0] = Some(mapped(0, 0, start)?);
    let mut pending = vec![0];
    while let Some(face) = pending.pop() {
        let here = images[face].expect("it is mapped");
        for i in 0..faces[face].len() {
            let (next, j) = across((face, i));
            let there = mapped(next, j, across(image(here, i)))?;
            match images[next].replace(there) {
                None => pending.push(next),
                Some(before) if before == there => {}
                Some(_) => return None,
            }
        }
    }
    Some(Symmetry { faces: images.into_iter().map(|image| image.expect("a sphere is connected")).collect() })
}
