//! Finer triangulations of the same space.

use isoracle::complex::permutation::Perm4;
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};

/// The barycentric subdivision of a triangulation: tetrahedron 24t + k is the flag of the corners in the k-th order.
pub fn subdivided(triangulation: &Triangulation) -> Triangulation {
    let orders: Vec<Perm4> = Perm4::all().collect();
    let number = |order: Perm4| orders.binary_search(&order).expect("one of the 24") as u32;
    let flag = |t: usize, order: Perm4| {
        let mut images = order.images();
        let neighbour = |k: usize| match k {
            0..3 => {
                images.swap(k, k + 1);
                let swapped = Perm4::new(images.map(|i| i as u8)).expect("a permutation");
                images.swap(k, k + 1);
                24 * t as u32 + number(swapped)
            }
            _ => {
                let gluing = triangulation.gluings()[t][order.image(3)];
                24 * gluing.tetrahedron + number(order.then(gluing.corners))
            }
        };
        [0, 1, 2, 3].map(neighbour).map(|tetrahedron| TriangleGluing { tetrahedron, corners: Perm4::IDENTITY })
    };
    let flags = (0..triangulation.len()).flat_map(|t| orders.iter().map(move |order| (t, *order)));
    Triangulation::new(flags.map(|(t, order)| flag(t, order)).collect()).expect("a closed triangulation")
}
