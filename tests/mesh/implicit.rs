//! Surfaces given by functions have two sides.

use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::mesh::extract;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::mesh::classify::mesh_surfaces;
use isoracle::mesh::examples::point;
use isoracle::mesh::face::Face;
use isoracle::mesh::gluing::Sheets;
use isoracle::number::Rational;
use proptest::prelude::*;

mod me_142 {
    use super::*;

    proptest! {
        #[test]
        fn isosurfaces_of_any_values_have_two_sides(values in prop::collection::vec(-3i32..4, 64)) {
            let volume = Volume::integers([4; 3], values).expect("a volume");
            let level = Level { volume: &volume, isovalue: Rational::from((1, 7)), tie: Tie::Below };
            let mesh = extract(&level).expect("ties are decided");
            // Whichever way the triangles are turned.
            let turn = |(i, t): (usize, &[u32; 3])| if i % 3 == 0 { Face::from([t[0], t[2], t[1]]) } else { Face::from(*t) };
            let faces: Vec<Face> = mesh.triangles.iter().enumerate().map(turn).collect();
            let sheets = Sheets::new(&faces).expect("edges of at most two triangles");
            prop_assert!(sheets.gluing.is_orientable() && sheets.pinches().is_empty());
        }

        // Over a grid of heights: the normals' third coordinates are all positive, and the surface is a disc.
        #[test]
        fn graphs_have_two_sides(heights in prop::collection::vec(-50i64..50, 25)) {
            let at = |x: u32, y: u32| 5 * x + y;
            let squares = (0..4).flat_map(|x| (0..4).map(move |y| [x, y]));
            let triangles: Vec<[u32; 3]> = squares
                .flat_map(|[x, y]| [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]])
                .collect();
            let position = |v: u32| point([i64::from(v / 5), i64::from(v % 5), heights[v as usize]]);
            for [a, b, c] in &triangles {
                let normal = (position(*b) - &position(*a)).cross(&(position(*c) - &position(*a)));
                prop_assert!(normal.0[2] > 0);
            }
            let faces: Vec<Face> = triangles.iter().map(|t| Face::from(*t)).collect();
            let names: Vec<String> = mesh_surfaces(&faces).expect("a surface").iter().map(ToString::to_string).collect();
            prop_assert_eq!(names, ["disc"]);
        }
    }
}
