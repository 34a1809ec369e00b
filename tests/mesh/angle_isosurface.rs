//! Gauss–Bonnet on a real surface: the isosurface of a scan, its positions exact.
#![cfg(feature = "cli")]

use isoracle::format::{Limits, nrrd};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::fast;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::linear::Vector;
use isoracle::mesh::angle_deficit::{AngleError, AngleMesh, GaussBonnet};
use isoracle::mesh::triangles::{boundary_edges, components};
use isoracle::number::{Enclosure, Interval, Rational, Ring};

fn head() -> Volume {
    let bytes = include_bytes!("../../data/mni152_crop.nrrd");
    Volume::try_from(nrrd::read(&bytes[..], &Limits::default()).expect("the crate's own file")).expect("a volume")
}

/// The isosurface as a mesh with angles, with its χ by the cells.
fn surface(isovalue: Rational) -> (AngleMesh, Vec<[u32; 3]>, i64) {
    let volume = head();
    let level = Level { volume: &volume, isovalue, tie: Tie::Below };
    let surface = fast::extract(&level).expect("ties are broken");
    let positions = surface.vertices.iter().map(|v| Vector(level.position(v))).collect();
    let mesh = AngleMesh::new(positions, surface.triangles.clone()).expect("no triangle is degenerate");
    (mesh, surface.triangles, fast::topology(&level).expect("ties are broken").chi())
}

/// No sample is 127/2, so no two vertices coincide; one saddle of a face is, and counts as if it were less.
#[test]
fn the_surface_of_the_head_has_it_triangle_by_triangle() {
    let (mesh, triangles, chi) = surface(Rational::from((127, 2)));
    // By the triangles' exact products; χ by the cells, by counting, and by components.
    let expected = GaussBonnet { half_turns: 2 * chi, chi };
    assert_eq!(mesh.total_curvature(), expected);
    assert_eq!(mesh.gauss_bonnet_with_border(), Ok(expected));
    assert!(matches!(mesh.gauss_bonnet(), Err(AngleError::NotClosed { triangles: 1, .. })));
    assert_eq!(components(mesh.vertex_count(), &triangles).iter().map(|c| c.chi).sum::<i64>(), chi);
    // The printed sum is too large by π a vertex of the border.
    let on_border = boundary_edges(&triangles).len() as i64;
    assert!(on_border > 0);
    assert_eq!(mesh.total_deficit_in_half_turns(), 2 * chi + on_border);
    // Measured, not proved: the sum of the enclosures of all curvatures.
    let vertices = 0..mesh.vertex_count() as u32;
    let sum = vertices.fold(Interval::integer(0), |sum, v| sum + &mesh.curvature(v).enclosure(96));
    let rest = sum - &(Interval::pi(96) * &Interval::integer(2 * chi));
    assert!(rest.known_sign().is_none() && rest.width().expect("finite") < Rational::from((1, 1_i64 << 40)));
}
