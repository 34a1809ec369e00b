//! Meshes of two cells and of whole grids, and the topology of grids.

use crate::domain::*;
use crate::patches::{glued, patches};
use isoracle::isosurface::boundary::arcs;
use isoracle::isosurface::cell::{Tie, assemble};
use isoracle::isosurface::cube::{Corner, Edge, Face};
use isoracle::isosurface::patch::PatchVertex;
use isoracle::isosurface::subdivision::topology as subdivide;
use isoracle::isosurface::topology::{GridTopology, topology};
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::isosurface::{fast, mesh, table};
use isoracle::mesh::triangles::{boundary_edges, components, defects};
use isoracle::number::{Rational, Sign};
use isoracle::partition::Partition;
use proptest::prelude::*;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A level of an integer volume at 0.
fn at_zero(volume: &Volume, tie: Tie) -> Level<'_> {
    Level { volume, isovalue: Rational::new(), tie }
}

fn volume(shape: [usize; 3], values: impl IntoIterator<Item = i64>) -> Volume {
    Volume::integers(shape, values.into_iter().map(|v| i32::try_from(v).expect("small")).collect()).expect("a volume")
}

/// What is asked of every mesh: a manifold whose boundary lies on the grid's border, of the topology of the surface.
fn check(level: &Level) -> GridTopology {
    let mesh = mesh::extract(level).expect("not degenerate");
    let known = topology(level).expect("not degenerate");
    assert_eq!(defects(mesh.vertices.len(), &mesh.triangles), []);
    let shape = level.volume.shape();
    let on_border = |v: u32| match &mesh.vertices[v as usize] {
        mesh::Vertex::Inner(_) => [false; 6],
        mesh::Vertex::Crossing(edge) => {
            let low = level.volume.point(edge.low as usize);
            Face::ALL.map(|f| {
                let across = usize::from(edge.axis) != f.axis();
                across && low[f.axis()] == if f.side() == 0 { 0 } else { shape[f.axis()] - 1 }
            })
        }
    };
    for edge in boundary_edges(&mesh.triangles) {
        let [a, b] = edge.map(on_border);
        assert!((0..6).any(|f| a[f] && b[f]), "a boundary edge inside the grid");
    }
    let found: Vec<[i64; 3]> = components(mesh.vertices.len(), &mesh.triangles)
        .into_iter()
        .map(|c| [c.chi, c.boundary_loops, c.genus])
        .collect();
    let expected: Vec<[i64; 3]> = known.components.iter().map(|c| [c.chi, c.boundary_loops, c.genus]).collect();
    assert_eq!(found, expected);
    assert_eq!(fast::extract(level).as_ref(), Ok(&mesh));
    assert_eq!(fast::topology(level).as_ref(), Ok(&known));
    known
}

/// b₀ and χ of {f ≤ c} and {f ≥ c} in the whole grid, from the subdivision of each cell: components by the parts that
/// cells share corners of, χ by inclusion and exclusion over cells, inner faces, edges and points.
fn by_subdivision(volume: &Volume, values: &[i64]) -> [(usize, i64); 2] {
    let shape = volume.shape();
    let mut parts = Partition::new(volume.len());
    let mut chi = [0; 2];
    let is_inner = |point: [usize; 3], fixed: &[usize]| fixed.iter().all(|&a| point[a] > 0 && point[a] < shape[a] - 1);
    for cell in volume.cells() {
        let corners = Corner::ALL.map(|c| volume.corner_index(cell, c));
        let shown = subdivide(&words(&corners.map(|i| values[i])), 60).expect("60 cuts suffice");
        for (s, side) in [&shown.negative, &shown.positive].into_iter().enumerate() {
            chi[s] += side.parts.len() as i64 - side.b1;
            for part in &side.parts {
                part.iter().for_each(|c| {
                    parts.join(corners[part[0].index()], corners[c.index()]);
                });
            }
        }
    }
    for (s, sign) in [-1, 1].into_iter().enumerate() {
        for index in 0..volume.len() {
            let point = volume.point(index);
            let at = |steps: &[usize]| {
                let mut to = point;
                steps.iter().for_each(|&a| to[a] += 1);
                (0..3).all(|a| to[a] < shape[a]).then(|| values[volume.index(to)])
            };
            for axis in 0..3 {
                let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                // The face across the axis with its lowest corner here.
                if let (true, Some(g10), Some(g01), Some(g11)) =
                    (is_inner(point, &[axis]), at(&[u]), at(&[v]), at(&[u, v]))
                {
                    let g = [values[index], g10, g01, g11];
                    let own: Vec<usize> = (0..4).filter(|&i| g[i].signum() == sign).collect();
                    let determinant = g[0] * g[3] - g[1] * g[2];
                    chi[s] -= match own[..] {
                        [] => 0,
                        [0, 3] if determinant < 0 => 2,
                        [1, 2] if determinant > 0 => 2,
                        _ => 1,
                    };
                }
                if let (true, Some(end)) = (is_inner(point, &[u, v]), at(&[axis])) {
                    chi[s] += i64::from([values[index], end].iter().any(|v| v.signum() == sign));
                }
            }
            chi[s] -= i64::from(is_inner(point, &[0, 1, 2]) && values[index].signum() == sign);
        }
    }
    let b0 =
        [-1, 1].map(|sign| (0..volume.len()).filter(|&i| values[i].signum() == sign && parts.find(i) == i).count());
    [(b0[0], chi[0]), (b0[1], chi[1])]
}

mod is_89 {
    use super::*;

    /// The sum of the entry.
    fn sum(level: &Level) -> i64 {
        let shape = level.volume.shape();
        let mut chi = 0;
        for cell in level.volume.cells() {
            let decisions = level.decisions(cell).expect("not degenerate");
            chi += assemble(decisions).chi();
            for face in Face::ALL.into_iter().filter(|f| f.side() == 1 && cell[f.axis()] + 2 < shape[f.axis()]) {
                chi -= arcs(&decisions, face).len() as i64;
            }
        }
        for index in 0..level.volume.len() {
            let low = level.volume.point(index);
            for axis in (0..3).filter(|&a| low[a] + 1 < shape[a]) {
                let is_inner = (0..3).all(|a| a == axis || (low[a] > 0 && low[a] + 1 < shape[a]));
                let mut high = low;
                high[axis] += 1;
                let crossed = level.is_outside(index) != level.is_outside(level.volume.index(high));
                chi += i64::from(is_inner && crossed);
            }
        }
        chi
    }

    fn agree(shape: [usize; 3], values: &[i64]) {
        let volume = volume(shape, values.iter().copied());
        let level = at_zero(&volume, Tie::Degenerate);
        let Ok(known) = topology(&level) else { return };
        assert_eq!(known.chi(), sum(&level), "{values:?}");
        let [negative, positive] = by_subdivision(&volume, values);
        assert_eq!((known.b0_negative, known.b0_positive), (negative.0, positive.0), "{values:?}");
        // The two sides cover the box and meet in the surface.
        assert_eq!(known.chi(), negative.1 + positive.1 - 1, "{values:?}");
        let expected = if negative.0 == 0 || positive.0 == 0 { 0 } else { negative.0 + positive.0 - 1 };
        assert_eq!(known.components.len(), expected, "{values:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if is_long() { 20_000 } else { 400 }))]

        #[test]
        fn the_sum_over_cells_faces_and_edges_is_that_by_subdivision(
            shape in prop::array::uniform3(2..=4usize), set in 0..4usize, digits in prop::collection::vec(0..4usize, 64)
        ) {
            let values: Vec<i64> = digits.iter().map(|d| SETS[set][*d]).take(shape.iter().product()).collect();
            agree(shape, &values);
        }

        #[test]
        fn with_larger_values_too(
            shape in prop::array::uniform3(2..=4usize), values in prop::collection::vec(-99..=99i64, 64)
        ) {
            agree(shape, &values[..shape.iter().product()]);
        }
    }
}

mod is_94 {
    use super::*;

    #[test]
    fn the_patch_of_each_class_is_its_discs_and_annulus_on_its_loops() {
        for (class, cell, patch) in patches() {
            let (vertices, triangles) = glued(&[([0; 3], &patch)]);
            assert_eq!(defects(vertices, &triangles), [], "{class:?}");
            let found: Vec<[i64; 2]> =
                components(vertices, &triangles).iter().map(|c| [c.chi, c.boundary_loops]).collect();
            let mut expected: Vec<[i64; 2]> = cell.components.iter().map(|c| [c.chi, c.loops.len() as i64]).collect();
            expected.sort();
            assert_eq!(found, expected, "{class:?}");
            // Directed boundary edges, by their crossings: each arc of the loops, with f > c on its left seen from outside:
            // the triangles' normals point toward f > c.
            let mut steps: BTreeMap<[Edge; 2], i32> = BTreeMap::new();
            for [a, b, c] in &patch.triangles {
                for pair in [[a, b], [b, c], [c, a]] {
                    if let [PatchVertex::Crossing(a), PatchVertex::Crossing(b)] = pair.map(|v| *v) {
                        *steps.entry([a, b]).or_default() += 1;
                        *steps.entry([b, a]).or_default() -= 1;
                    }
                }
            }
            let boundary: BTreeSet<[Edge; 2]> = steps.into_iter().filter(|(_, n)| *n == 1).map(|(e, _)| e).collect();
            let rims = cell.loops.iter().flat_map(|l| (0..l.len()).map(|i| [l[i], l[(i + 1) % l.len()]]));
            assert_eq!(boundary, rims.collect(), "{class:?}");
        }
    }

    #[test]
    fn normals_point_toward_the_outside() {
        // Case 1, straight: the corner's triangle, its normal toward the seven.
        for corner in Corner::ALL {
            for sign in [1, -1] {
                let values = Corner::ALL.map(|c| if c == corner { sign } else { -sign });
                let volume = volume([2, 2, 2], values);
                let level = at_zero(&volume, Tie::Degenerate);
                let mesh = mesh::extract(&level).expect("not degenerate");
                let [triangle] = mesh.triangles[..] else { panic!("one triangle") };
                let [a, b, c] = triangle.map(|v| level.position(&mesh.vertices[v as usize]));
                let minus = |a: &[Rational; 3], b: &[Rational; 3]| [0, 1, 2].map(|i| Rational::from(&a[i] - &b[i]));
                let (p, q) = (minus(&b, &a), minus(&c, &a));
                let to_corner = minus(&corner.position().map(Rational::from), &a);
                let volume = (0..3).fold(Rational::new(), |sum, i| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    sum + (Rational::from(&p[j] * &q[k]) - Rational::from(&p[k] * &q[j])) * &to_corner[i]
                });
                assert_eq!(Sign::of(volume.cmp0()).value() as i64, sign);
            }
        }
    }

    #[test]
    fn cells_and_their_neighbours_make_one_surface() {
        let witnesses: Vec<[i64; 8]> = class_witnesses().into_values().collect();
        witnesses.par_iter().enumerate().for_each(|(number, values)| {
            for face in Face::ALL {
                let (axis, side) = (face.axis(), usize::from(face.side()));
                // The mirror image, and others that agree on the face.
                for round in 0..if is_long() { 40 } else { 5u64 } {
                    let mut seed = (number as u64 * 6 + face.index() as u64) * 64 + round;
                    let mut random = move || {
                        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                        let v = (seed >> 33) as i64 % 18 - 9;
                        if v >= 0 { v + 1 } else { v }
                    };
                    let mut shape = [2; 3];
                    shape[axis] = 3;
                    let samples: Vec<i64> = (0..12)
                        .map(|index| {
                            let mut at = [index % shape[0], index / shape[0] % shape[1], index / shape[0] / shape[1]];
                            let is_own = at[axis] == 1 || (at[axis] == 0) == (side == 1);
                            if !is_own && round > 0 {
                                return random();
                            }
                            // The cell on its own side of the middle plane, and its mirror image.
                            at[axis] = if at[axis] == 1 { side } else { 1 - side };
                            values[at[0] + 2 * at[1] + 4 * at[2]]
                        })
                        .collect();
                    let volume = volume(shape, samples);
                    let level = at_zero(&volume, Tie::Degenerate);
                    if topology(&level).is_ok() {
                        check(&level);
                    } else {
                        check(&at_zero(&volume, Tie::Below));
                    }
                }
            }
        });
    }

    fn grid(values: &[i64]) {
        let volume = volume([4, 4, 4], values.iter().copied());
        let known = check(&at_zero(&volume, Tie::Below));
        let strict = at_zero(&volume, Tie::Degenerate);
        match topology(&strict) {
            Ok(same) => assert_eq!(same, known),
            Err(tie) => {
                assert_eq!(mesh::extract(&strict).expect_err("a tie"), tie);
                assert_eq!(fast::extract(&strict).expect_err("a tie"), tie);
                assert_eq!(fast::topology(&strict).expect_err("a tie"), tie);
            }
        }
        // The same as floats and as rationals, about another isovalue.
        let isovalue = Rational::from((5, 8));
        let floats = values.iter().map(|v| (*v as f64 + 5.0) / 8.0).collect();
        let rationals = values.iter().map(|v| Rational::from((*v + 5, 8))).collect();
        for moved in [Volume::floats([4, 4, 4], floats), Volume::rationals([4, 4, 4], rationals)] {
            let moved = moved.expect("a volume");
            assert_eq!(check(&Level { volume: &moved, isovalue: isovalue.clone(), tie: Tie::Below }), known);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if is_long() { 10_000 } else { 300 }))]

        #[test]
        fn random_grids_of_few_values(values in prop::collection::vec(prop::sample::select(&[-3i64, -2, -1, 1, 2, 3][..]), 64)) {
            grid(&values);
        }

        #[test]
        fn random_grids(values in prop::collection::vec(-9..=9i64, 64)) {
            grid(&values);
        }

        #[test]
        fn random_grids_of_ties(values in prop::collection::vec(-1..=1i64, 64)) {
            grid(&values);
        }
    }

    #[test]
    fn the_frozen_table_is_what_the_rule_derives() {
        assert_eq!(table::derive(), include_str!("../../src/isosurface/table.txt"));
        let table = table::Table::frozen();
        for (class, _, patch) in patches() {
            assert_eq!(*table.patch(&class), patch, "{class:?}");
        }
    }
}
