//! Quickcheck's `Arbitrary` for cells and volumes.

use super::cases::Case;
use super::cell::Tie;
use super::cube::{Corner, Edge, Face, Symmetry};
use super::volume::Volume;
use quickcheck::{Arbitrary, Gen};

fn any_of<T: Copy>(g: &mut Gen, all: &[T]) -> T {
    *g.choose(all).expect("the list is not empty")
}

impl Arbitrary for Corner {
    fn arbitrary(g: &mut Gen) -> Corner {
        any_of(g, &Corner::ALL)
    }
}

impl Arbitrary for Edge {
    fn arbitrary(g: &mut Gen) -> Edge {
        any_of(g, &Edge::ALL)
    }
}

impl Arbitrary for Face {
    fn arbitrary(g: &mut Gen) -> Face {
        any_of(g, &Face::ALL)
    }
}

impl Arbitrary for Symmetry {
    fn arbitrary(g: &mut Gen) -> Symmetry {
        any_of(g, &Symmetry::all())
    }
}

impl Arbitrary for Case {
    fn arbitrary(g: &mut Gen) -> Case {
        any_of(g, Case::ALL)
    }
}

impl Arbitrary for Tie {
    fn arbitrary(g: &mut Gen) -> Tie {
        any_of(g, &[Tie::Degenerate, Tie::Below])
    }
}

/// Integer volumes of 2 to 5 samples along each axis, values −9 … 9, ties among them.
impl Arbitrary for Volume {
    fn arbitrary(g: &mut Gen) -> Volume {
        let shape = [(); 3].map(|()| 2 + usize::arbitrary(g) % 4);
        let values = (0..shape.iter().product()).map(|_| i32::from(i8::arbitrary(g)) % 10).collect();
        Volume::integers(shape, values).expect("the shape has as many samples")
    }

    /// Without the last layer of samples along each axis that has more than two.
    fn shrink(&self) -> Box<dyn Iterator<Item = Volume>> {
        let volume = self.clone();
        Box::new((0..3).filter_map(move |axis| {
            let mut high = volume.shape().map(|n| n - 1);
            high[axis] -= 1;
            volume.crop([0; 3], high).ok()
        }))
    }
}
