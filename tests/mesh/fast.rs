//! The check of large meshes against the plain one.

use isoracle::mesh::defects::{self, Category};
use isoracle::mesh::examples;
use isoracle::mesh::fast::{Elements, Polygons, audit, check};
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::binary::nearest_f64;
use proptest::prelude::*;

/// The mesh of binary64 positions in flat arrays.
pub fn flat(mesh: &VertexList) -> Polygons {
    let vertices = mesh.vertices.iter().map(|p| p.0.each_ref().map(nearest_f64)).collect();
    let mut corners = Vec::new();
    let ends = mesh.faces.iter().map(|face| {
        corners.extend(&face.outer);
        corners.len() as u32
    });
    let ends = ends.collect();
    Polygons::new(vertices, corners, ends).expect("a sound mesh")
}

/// A mesh of these positions and loops.
pub fn polygons(vertices: &[[f64; 3]], faces: &[Vec<u32>]) -> Polygons {
    let mut end = 0;
    let ends = faces.iter().map(|face| {
        end += face.len() as u32;
        end
    });
    Polygons::new(vertices.to_vec(), faces.concat(), ends.collect()).expect("a sound mesh")
}

/// The fast check says what the plain one says.
pub fn assert_as_plain(mesh: &Polygons) {
    let fast = check(mesh, |_| {});
    let plain = defects::check(&mesh.plain(), None);
    let found: Vec<_> = fast.defects.iter().map(|(category, elements)| (*category, elements.plain())).collect();
    let expected: Vec<_> = plain.defects.iter().map(|(category, elements)| (category, elements.clone())).collect();
    assert_eq!(found, expected, "{mesh:?}");
    assert_eq!(fast.counts, plain.counts, "{mesh:?}");
    assert!(fast.all_junctions);
}

#[test]
fn the_examples_are_sound() {
    for mesh in [examples::cube(), examples::tetrahedron()] {
        let mesh = flat(&mesh);
        assert_as_plain(&mesh);
        assert!(check(&mesh, |_| {}).defects.is_empty());
    }
}

/// Coordinates with many coincidences, small differences and large scales.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        12 => (-2..3_i32).prop_map(f64::from),
        2 => (-2..3_i32).prop_map(|n| f64::from(n).next_up()),
        1 => (-3..4_i32).prop_map(|n| f64::from(n) / 3.0),
        1 => prop::sample::select(vec![-0.0, 1e-300, 5e-324, 1e300, 0.1, 1.0 + 1e-9]),
        1 => prop::num::f64::NORMAL,
    ]
}

pub fn soup() -> impl Strategy<Value = Polygons> {
    let vertices = prop::collection::vec(prop::array::uniform3(coordinate()), 1..9);
    let faces = prop::collection::vec(prop::collection::vec(0..9_u32, 0..7), 0..9);
    (vertices, faces).prop_map(|(vertices, mut faces)| {
        // Mostly vertices that exist.
        let n = vertices.len() as u32;
        faces.iter_mut().flatten().for_each(|v| *v = if *v == 8 && n < 4 { n } else { *v % n });
        polygons(&vertices, &faces)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn polygon_soups_are_checked_as_by_the_plain_version(mesh in soup()) {
        assert_as_plain(&mesh);
    }
}

/// All sets of at most `most` of these faces, on their vertices.
fn sets(vertices: &[[f64; 3]], faces: &[Vec<u32>], most: usize, visit: &mut impl FnMut(&Polygons)) {
    fn extend(
        vertices: &[[f64; 3]],
        chosen: &mut Vec<Vec<u32>>,
        rest: &[Vec<u32>],
        most: usize,
        visit: &mut impl FnMut(&Polygons),
    ) {
        visit(&polygons(vertices, chosen));
        if chosen.len() < most {
            for (i, face) in rest.iter().enumerate() {
                chosen.push(face.clone());
                extend(vertices, chosen, &rest[i + 1..], most, visit);
                chosen.pop();
            }
        }
    }
    extend(vertices, &mut Vec::new(), faces, most, visit);
}

/// All loops of that length on the first n vertices that begin with their least one.
fn all_loops(n: u32, length: u32) -> Vec<Vec<u32>> {
    let loops = (0..n.pow(length)).map(|code| (0..length).map(|i| code / n.pow(i) % n).collect::<Vec<u32>>());
    loops.filter(|l| l.iter().all(|v| *v >= l[0])).collect()
}

const CORNERS: [[f64; 3]; 5] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0], [1.0, 1.0, 0.0]];

fn long() -> bool {
    std::env::var_os("ISORACLE_LONG").is_some()
}

#[test]
fn every_set_of_few_triangles_on_few_vertices_is_checked_as_by_the_plain_version() {
    let triangles = |n: u32| -> Vec<Vec<u32>> {
        let all = all_loops(n, 3).into_iter();
        all.filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]).collect()
    };
    let mut visited = 0;
    let mut visit = |mesh: &Polygons| {
        assert_as_plain(mesh);
        visited += 1;
    };
    sets(&CORNERS[..4], &triangles(4), 8, &mut visit);
    sets(&CORNERS, &triangles(5), if long() { 4 } else { 2 }, &mut visit);
    assert!(visited >= 256 + 211, "{visited}");
}

#[test]
fn every_pair_of_short_loops_broken_ones_too_is_checked_as_by_the_plain_version() {
    let loops: Vec<Vec<u32>> = (0..if long() { 5 } else { 4 }).flat_map(|length| all_loops(3, length)).collect();
    sets(&CORNERS[..3], &loops, 2, &mut |mesh| assert_as_plain(mesh));
    let quadrilaterals = all_loops(5, 4);
    sets(&CORNERS, &quadrilaterals, 1, &mut |mesh| assert_as_plain(mesh));
}

/// A grid of quadrilaterals or triangles, closed around in neither, one or both directions, some faces gone, some turned;
/// with a wave, or flat so that vertices lie inside edges where faces are gone.
pub fn grid() -> impl Strategy<Value = Polygons> {
    let size = (2..7_u32, 2..7_u32, any::<[bool; 2]>(), any::<bool>(), 0..3_i32);
    let spoilt = prop::collection::vec((any::<prop::sample::Index>(), 0..5_u8), 0..4);
    (size, spoilt).prop_map(|((m, n, around, split, wave), spoilt)| {
        let at = |i: u32, j: u32| (j % n) * m + i % m;
        let mut faces = Vec::new();
        for j in 0..if around[1] { n } else { n - 1 } {
            for i in 0..if around[0] { m } else { m - 1 } {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                faces.extend(if split { vec![vec![a, b, c], vec![a, c, d]] } else { vec![vec![a, b, c, d]] });
            }
        }
        for (which, how) in spoilt {
            let face = which.index(faces.len());
            match how {
                0 => drop(faces.remove(face)),
                1 => faces[face].reverse(),
                2 => faces.push(faces[face].clone()),
                3 => faces[face].rotate_left(1),
                _ => faces[face][0] = 0,
            }
            if faces.is_empty() {
                faces.push(vec![0, 1, 2]);
            }
        }
        let height = |i: u32, j: u32| f64::from(((i * i + 3 * j) as i32 * wave) % 5) / 8.0;
        let vertices: Vec<[f64; 3]> =
            (0..m * n).map(|v| [f64::from(v % m), f64::from(v / m), height(v % m, v / m)]).collect();
        polygons(&vertices, &faces)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn grids_are_checked_as_by_the_plain_version(mesh in grid()) {
        assert_as_plain(&mesh);
    }

    #[test]
    fn the_audit_of_everything_finds_no_difference(grid in grid(), soup in soup()) {
        for mesh in [&grid, &soup] {
            let report = check(mesh, |_| {});
            let audited = audit(mesh, &report, 1);
            prop_assert!(audited.is_ok(), "{audited:?}");
            let items = mesh.vertices().len() + mesh.faces() + report.counts.as_ref().map_or(0, |counts| counts.edges);
            let empty = mesh.loops().filter(|face| face.is_empty()).count();
            prop_assert_eq!(audited, Ok(if report.counts.is_some() { (items - empty) as u64 } else { 0 }));
            prop_assert_eq!(audit(mesh, &report, 0), Ok(0));
        }
    }
}

/// One loop in a slanted plane, its vertices on a small grid: it crosses itself, turns back, has no signed area.
fn plane_loop() -> impl Strategy<Value = Polygons> {
    prop::collection::vec((0..5_i32, 0..5_i32, 0..40_u8), 3..9).prop_map(|corners| {
        let at =
            |(x, y, off): &(i32, i32, u8)| [f64::from(*x), f64::from(*y), f64::from(x + 2 * y + i32::from(*off == 0))];
        let vertices: Vec<[f64; 3]> = corners.iter().map(at).collect();
        polygons(&vertices, &[(0..vertices.len() as u32).collect()])
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn loops_in_a_plane_are_checked_as_by_the_plain_version(mesh in plane_loop()) {
        assert_as_plain(&mesh);
    }
}

/// Three triangles round an edge, one of them twice, a lone vertex, two at one position, one inside an edge, a bow tie.
fn spoilt() -> Polygons {
    let vertices = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
        [0.0, 0.0, 2.0],
        [1.0, 0.0, 0.0],
        [9.0, 9.0, 9.0],
        [0.0, 2.0, 0.0],
        [5.0, 0.0, 0.0],
        [6.0, 1.0, 0.0],
        [6.0, 0.0, 0.0],
        [5.0, 1.0, 0.0],
    ];
    let faces: [&[u32]; 8] =
        [&[0, 1, 2], &[0, 1, 3], &[1, 0, 6], &[2, 1, 0], &[4, 2, 3], &[7, 8, 9, 10], &[2, 6, 3], &[0, 1, 0]];
    polygons(&vertices, &faces.map(<[u32]>::to_vec))
}

#[test]
fn the_audit_hears_of_every_element_that_is_left_out() {
    let mesh = spoilt();
    assert_as_plain(&mesh);
    let report = check(&mesh, |_| {});
    assert!(audit(&mesh, &report, 1).is_ok());
    let categories: Vec<Category> = report.defects.keys().copied().collect();
    for expected in [
        Category::TJunction,
        Category::DuplicateFace,
        Category::DuplicateVertexPosition,
        Category::SelfCrossingLoop,
        Category::EdgeUsedGt2,
        Category::IsolatedVertex,
        Category::NonmanifoldVertex,
        Category::ZeroLengthEdge,
    ] {
        assert!(categories.contains(&expected), "{expected:?}");
    }
    for category in categories {
        let mut wrong = report.clone();
        wrong.defects.remove(&category);
        let mismatch = audit(&mesh, &wrong, 1).expect_err(category.name());
        assert!(mismatch.plain.iter().any(|(named, _)| *named == category), "{mismatch}");
    }
    let mut wrong = report.clone();
    wrong.defects.insert(Category::NonplanarFace, Elements::Faces(vec![5]));
    assert!(audit(&mesh, &wrong, 1).is_err());
}

/// ME-150
mod me_150 {
    use super::*;
    use isoracle::mesh::fast::equal::{first_at_position, first_of_cycle, groups, same_cycle};

    /// All rotations of both directions, one by one.
    fn same_cycle_by_trial(a: &[u32], b: &[u32]) -> bool {
        let mut forth = b.to_vec();
        let mut found = a == b;
        for _ in 0..2 {
            for _ in 0..b.len() {
                forth.rotate_left(1);
                found |= a == forth;
            }
            forth.reverse();
        }
        found
    }

    #[test]
    fn short_loops_are_compared_as_by_trial() {
        let loops: Vec<Vec<u32>> = (0..6)
            .flat_map(|n| (0..3_u32.pow(n)).map(move |c| (0..n).map(|i| c / 3_u32.pow(i) % 3).collect()))
            .collect();
        let mut same = 0;
        for a in &loops {
            for b in &loops {
                assert_eq!(same_cycle(a, b), same_cycle_by_trial(a, b), "{a:?} {b:?}");
                same += usize::from(same_cycle(a, b));
            }
        }
        assert!(same > loops.len());
    }

    #[test]
    fn the_first_of_equal_faces_and_positions_stands_for_all() {
        let zero = [[0.0; 3], [1.0, 0.0, 0.0], [-0.0, 0.0, -0.0], [1.0, 0.0, 0.0], [5e-324, 0.0, 0.0]];
        assert_eq!(first_at_position(&zero), [0, 1, 0, 1, 4]);
        assert_eq!(groups(&first_at_position(&zero)), [[0, 2], [1, 3]]);
        let faces = [vec![0, 1, 2, 3], vec![3, 2, 1, 0], vec![0, 2, 1, 3], vec![2, 3, 0, 1], vec![0, 1, 2]];
        assert_eq!(first_of_cycle(&polygons(&zero, &faces)), [0, 0, 2, 0, 4]);
    }
}

/// ME-151
mod me_151 {
    use super::*;

    #[test]
    fn fans_that_meet_in_a_vertex_alone_are_counted_apart() {
        // Two triangles at vertex 0, apart, then bridged by a third.
        let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
        let apart = polygons(&vertices, &[vec![0, 1, 2], vec![0, 3, 4]]);
        let nonmanifold = |mesh: &Polygons| check(mesh, |_| {}).defects.get(&Category::NonmanifoldVertex).cloned();
        assert_eq!(nonmanifold(&apart), Some(Elements::Vertices(vec![0])));
        let bridged = polygons(&vertices, &[vec![0, 1, 2], vec![0, 3, 4], vec![0, 2, 3]]);
        assert_eq!(nonmanifold(&bridged), None);
        // A vertex that follows itself makes one corner.
        assert_eq!(nonmanifold(&polygons(&vertices, &[vec![0, 0, 1, 2]])), None);
        [apart, bridged].iter().for_each(assert_as_plain);
    }
}

/// ME-153
mod me_153 {
    use super::*;
    use isoracle::mesh::triangles::{self, MeshComponent};

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn sound_triangle_meshes_have_the_components_of_the_plain_count(mesh in grid()) {
            let triangles: Option<Vec<[u32; 3]>> = mesh.loops().map(|face| face.try_into().ok()).collect();
            let report = check(&mesh, |_| {});
            if let Some(triangles) = triangles && triangles::defects(mesh.vertices().len(), &triangles).is_empty() {
                let mut found: Vec<MeshComponent> = report.components.iter().map(|c| MeshComponent {
                    chi: c.vertices as i64 - c.edges as i64 + c.faces as i64,
                    boundary_loops: c.boundary_loops as i64,
                    genus: c.genus.expect("a sound mesh is a surface"),
                }).collect();
                found.sort();
                prop_assert_eq!(found, triangles::components(mesh.vertices().len(), &triangles));
            }
        }
    }

    #[test]
    fn a_torus_a_disc_and_a_pinched_pair_have_their_genus() {
        let torus: Vec<Vec<u32>> = (0..9)
            .map(|v| {
                let at = |i: u32, j: u32| (v / 3 + j) % 3 * 3 + (v + i) % 3;
                vec![at(0, 0), at(1, 0), at(1, 1), at(0, 1)]
            })
            .collect();
        let vertices: Vec<[f64; 3]> = (0..16).map(|v| [f64::from(v), f64::from(v * v % 7), f64::from(v % 5)]).collect();
        let faces = [&torus[..], &[vec![9, 10, 11]], &[vec![12, 13, 14], vec![12, 14, 13]]].concat();
        let report = check(&polygons(&vertices, &faces), |_| {});
        let found: Vec<_> = report.components.iter().map(|c| (c.faces, c.genus, c.boundary_loops)).collect();
        assert_eq!(found, [(9, Some(1), 0), (2, Some(0), 0), (1, Some(0), 1)]);
        let pinched = check(&polygons(&vertices, &[vec![0, 1, 2], vec![0, 3, 4]]), |_| {});
        assert_eq!(pinched.components.iter().map(|c| c.genus).collect::<Vec<_>>(), [None]);
    }
}
