//! How many classes of cells there are up to symmetry, in two ways: orbits one by one, and by Burnside's lemma
//! (IS-63 … IS-66).

use super::cell::Decisions;
use super::cube::{Face, Symmetry};
use std::collections::BTreeSet;

/// Under what classes are the same. "Complement" is the exchange of f > c and f < c.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// Nothing but themselves.
    Trivial,
    /// The 24 rotations of the cube.
    Rotations,
    /// These and the complement: what the text's 15 and 33 are counted under (IS-64, IS-65).
    RotationsAndComplement,
    /// The 48 symmetries of the cube.
    RotationsAndReflections,
    /// All 96.
    All,
}

/// An element of a [`Group`]: a symmetry of the cube, then perhaps the complement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Action {
    /// The symmetry.
    pub symmetry: Symmetry,
    /// Whether f > c and f < c are exchanged.
    pub complement: bool,
}

impl Group {
    /// Its elements.
    pub fn elements(self) -> Vec<Action> {
        let (reflections, complements): (bool, &[bool]) = match self {
            Group::Trivial => return vec![Action { symmetry: Symmetry::all()[0], complement: false }],
            Group::Rotations => (false, &[false]),
            Group::RotationsAndComplement => (false, &[false, true]),
            Group::RotationsAndReflections => (true, &[false]),
            Group::All => (true, &[false, true]),
        };
        let symmetries = Symmetry::all().into_iter().filter(|s| reflections || s.is_rotation());
        symmetries
            .flat_map(|symmetry| complements.iter().map(move |&complement| Action { symmetry, complement }))
            .collect()
    }
}

impl Action {
    /// The image of a class.
    pub fn of(self, class: &Decisions) -> Decisions {
        let Action { symmetry, complement } = self;
        let positive = symmetry.corners(class.positive);
        let mut image =
            Decisions { positive: if complement { !positive } else { positive }, faces: [0; 6], tunnel: None };
        for face in Face::ALL {
            let sign = class.faces[face.index()];
            image.faces[symmetry.face(face).index()] = if complement { -sign } else { sign };
        }
        // A tunnel is named by the least corners of the two parts that it joins.
        image.tunnel = class.tunnel.map(|tunnel| {
            let carried = tunnel.corners.map(|c| symmetry.corner(c));
            image.as_tunnel(super::cell::Join { corners: carried }).expect("parts that were two stay two")
        });
        image
    }
}

/// The 2⁸ = 256 configurations of corner signs, without faces and tunnels (IS-63).
#[doc(alias = "IS-63")]
pub fn sign_configurations() -> Vec<Decisions> {
    (0..=255).map(|positive| Decisions { positive, faces: [0; 6], tunnel: None }).collect()
}

/// The orbits of a set of classes that the group maps to itself, each sorted: 15 of the sign configurations under
/// rotations and complement (IS-64), 33 of all 768 labelled classes (IS-65).
#[doc(alias = "IS-64")]
#[doc(alias = "IS-65")]
pub fn orbits(classes: &[Decisions], group: Group) -> Vec<Vec<Decisions>> {
    let elements = group.elements();
    let mut left: BTreeSet<Decisions> = classes.iter().copied().collect();
    let mut orbits = Vec::new();
    while let Some(first) = left.first().copied() {
        let orbit: BTreeSet<Decisions> = elements.iter().map(|action| action.of(&first)).collect();
        left.retain(|class| !orbit.contains(class));
        orbits.push(orbit.into_iter().collect());
    }
    orbits
}

/// The number of orbits by Burnside's lemma: the mean number, over the group, of classes that stay as they are. `None`
/// iff it is no whole number, as it can only be where the group does not map the set of classes to itself.
pub fn burnside(classes: &[Decisions], group: Group) -> Option<usize> {
    let elements = group.elements();
    let fixed: usize =
        elements.iter().map(|action| classes.iter().filter(|class| action.of(class) == **class).count()).sum();
    fixed.is_multiple_of(elements.len()).then(|| fixed / elements.len())
}
