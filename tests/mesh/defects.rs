//! `mesh::defects::check` against brute force: exhaustively on small meshes, and on broken ones drawn at random.

use super::naive_check::{Listed, crosses_itself, found, naive_check, same_cycle};
use super::specimens;
use isoracle::mesh::defects::{Category, Defects, Element, ListedEdges, check};
use isoracle::mesh::examples::{cube, mesh, tetrahedron};
use isoracle::mesh::face::Face;
use isoracle::mesh::vertex_list::{Point, VertexList};
use isoracle::number::Rational;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// The categories that have elements.
fn categories(defects: &Defects) -> Vec<Category> {
    defects.iter().map(|(category, _)| category).collect()
}

#[track_caller]
fn is_as_by_brute_force(mesh: &VertexList) {
    let report = check(mesh, None);
    assert_eq!(found(&report), naive_check(mesh, None), "{mesh:?}");
}

/// All lists of length at most `longest` over 0 … n−1.
fn lists(n: u32, longest: usize) -> Vec<Vec<u32>> {
    let mut all = vec![Vec::new()];
    let mut last = all.clone();
    for _ in 0..longest {
        last = last.iter().flat_map(|list| (0..n).map(move |v| [&list[..], &[v]].concat())).collect();
        all.extend(last.iter().cloned());
    }
    all
}

/// Four positions: in space, in a plane, on a line, two of them equal.
fn positions() -> [Vec<Point>; 4] {
    let of = |points: [[i64; 3]; 4]| mesh::<[u32; 0]>(&points, &[]).vertices;
    [
        of([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]),
        of([[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]]),
        of([[0, 0, 0], [3, 3, 3], [1, 1, 1], [2, 2, 2]]),
        of([[0, 0, 0], [1, 0, 2], [0, 0, 0], [0, 1, 5]]),
    ]
}

#[test]
fn every_loop_of_at_most_four_over_five_numbers_is_judged_as_by_brute_force() {
    for vertices in positions() {
        for outer in lists(5, 4) {
            is_as_by_brute_force(&VertexList { vertices: vertices.clone(), faces: vec![Face::new(outer)] });
        }
    }
}

#[test]
fn every_pair_of_an_outer_loop_and_a_hole_of_at_most_three_is_judged_as_by_brute_force() {
    for vertices in &positions()[..2] {
        for outer in lists(4, 3) {
            for hole in lists(4, 3).into_iter().step_by(if long() { 1 } else { 3 }) {
                let face = Face { outer: outer.clone(), holes: vec![hole] };
                is_as_by_brute_force(&VertexList { vertices: vertices.clone(), faces: vec![face] });
            }
        }
    }
}

fn long() -> bool {
    std::env::var_os("ISORACLE_LONG").is_some()
}

#[test]
fn every_set_of_at_most_four_polygons_over_four_vertices_is_judged_as_by_brute_force() {
    // Up to rotation: 8 triangles and 6 quadrangles.
    let begins_least = |l: &Vec<u32>| l.iter().skip(1).all(|v| *v > l[0]);
    let distinct = |l: &Vec<u32>| l.iter().collect::<BTreeSet<_>>().len() == l.len();
    let polygons: Vec<Face> =
        lists(4, 4).into_iter().filter(|l| l.len() >= 3 && begins_least(l) && distinct(l)).map(Face::new).collect();
    assert_eq!(polygons.len(), 14);
    let at = positions();
    let (mut closed, mut manifold) = (0, 0);
    for set in (0_u32..1 << 14).filter(|set| set.count_ones() <= 4) {
        let faces: Vec<Face> = (0..14).filter(|i| set >> i & 1 == 1).map(|i| polygons[i].clone()).collect();
        // One of the position sets each, all of them in turn.
        let one = set.count_ones() as usize % 2 + 2 * usize::from(set % 7 == 0);
        for vertices in if long() { &at[..] } else { &at[one..=one] } {
            is_as_by_brute_force(&VertexList { vertices: vertices.clone(), faces: faces.clone() });
        }
        let counts =
            check(&VertexList { vertices: at[one].clone(), faces }, None).counts.expect("indices are in range");
        closed += i32::from(counts.closed);
        manifold += i32::from(counts.manifold);
    }
    // The empty one; 7 laminas; 16 tetrahedra with any flips; squares and triangles otherwise.
    assert!(manifold >= 10 && closed > manifold, "{closed} closed, {manifold} manifold");
}

#[test]
fn the_specimens_are_judged_as_by_brute_force() {
    for (name, mesh) in specimens::all() {
        // Brute force tries 2^F flips.
        if mesh.faces.len() <= 14 {
            assert_eq!(found(&check(&mesh, None)), naive_check(&mesh, None), "{name}");
        }
    }
}

#[test]
fn sound_meshes_have_no_defects() {
    for mesh in [cube(), tetrahedron(), specimens::torus(), specimens::box_with_tunnel(), specimens::box_with_pocket()]
    {
        let report = check(&mesh, None);
        assert!(report.defects.is_empty(), "{:?}", report.defects);
        assert!(report.counts.expect("sound").manifold);
    }
}

#[test]
fn an_index_out_of_range_is_told_alone() {
    let broken = mesh(&[[0, 0, 0], [0, 0, 0]], &[vec![0, 0], vec![0, 1, 2], vec![], vec![u32::MAX]]);
    let report = check(&broken, None);
    assert_eq!(categories(&report.defects), [Category::IndexOutOfRange]);
    assert_eq!(
        report.defects.of(Category::IndexOutOfRange).cloned().collect::<Vec<_>>(),
        [Element::Face(1), Element::Face(3)]
    );
    assert_eq!(report.counts, None);
}

#[test]
fn a_mesh_of_nothing_is_closed_and_encloses_nothing() {
    let report = check(&VertexList::default(), None);
    assert_eq!(categories(&report.defects), [Category::ZeroVolume]);
    let counts = report.counts.expect("no index is out of range");
    assert_eq!((counts.vertices, counts.components, counts.chi, counts.genus), (0, 0, 0, Some(0)));
    assert!(counts.closed && counts.orientable && counts.manifold);
}

#[test]
fn a_face_without_vertices_leaves_no_genus() {
    let mut broken = cube();
    broken.faces.push(Face::default());
    let report = check(&broken, None);
    assert_eq!(categories(&report.defects), [Category::FaceLt3Vertices]);
    let counts = report.counts.expect("in range");
    assert_eq!((counts.chi, counts.manifold, counts.genus), (3, true, None));
    assert_eq!(counts.volume, Some(Rational::from(1)));
}

#[test]
fn a_hole_of_its_faces_sense_says_nothing_of_the_surface() {
    let mut turned = specimens::box_with_tunnel();
    let hole = &mut turned.faces[0].holes[0];
    hole.reverse();
    let report = check(&turned, None);
    assert_eq!(categories(&report.defects), [Category::InconsistentWindingEdge, Category::HoleSameSenseAsOuter]);
    let counts = report.counts.expect("in range");
    assert!(counts.closed && counts.orientable && !counts.manifold);
    assert_eq!((counts.volume, counts.genus), (None, None));
}

#[test]
fn beside_a_hole_of_its_faces_sense_no_surface_is_called_not_orientable() {
    let mut both = specimens::box_with_tunnel();
    both.faces[0].holes[0].reverse();
    let plane = specimens::projective_plane();
    both.vertices.extend(plane.vertices.into_iter().map(|v| v + &specimens::rational([[50, 1], [0, 1], [0, 1]])));
    both.faces.extend(plane.faces.iter().map(|face| Face::new(face.outer.iter().map(|v| v + 16).collect::<Vec<_>>())));
    let report = check(&both, None);
    assert_eq!(categories(&report.defects), [Category::InconsistentWindingEdge, Category::HoleSameSenseAsOuter]);
    let counts = report.counts.expect("in range");
    assert!(counts.closed && !counts.orientable);
}

#[test]
fn all_quadrangles_and_some_pentagons_of_a_grid_cross_themselves_as_by_brute_force() {
    // In the plane x = 2y + z, and in one along an axis.
    for place in [|u: i64, v: i64| [2 * u + v, u, v], |u: i64, v: i64| [u, 5, v]] {
        let vertices: Vec<[i64; 3]> = (0..9).map(|i| place(i % 3, i / 3)).collect();
        let pentagons = lists(9, 5).into_iter().filter(|l| l.len() == 5).step_by(if long() { 1 } else { 29 });
        let loops: Vec<Vec<u32>> = lists(9, 4).into_iter().filter(|l| l.len() == 4).chain(pentagons).collect();
        let grid = mesh(&vertices, &loops);
        let points = |l: &Vec<u32>| l.iter().map(|v| grid.vertices[*v as usize].clone()).collect::<Vec<Point>>();
        let crossing = (0..loops.len()).filter(|i| crosses_itself(&points(&loops[*i]))).map(Element::Face);
        assert!(check(&grid, None).defects.of(Category::SelfCrossingLoop).cloned().eq(crossing));
    }
}

#[test]
fn an_open_band_with_a_half_twist_is_not_orientable_but_that_is_no_defect() {
    let report = check(&specimens::moebius_band(), None);
    assert_eq!(categories(&report.defects), [Category::BoundaryEdge, Category::InconsistentWindingEdge]);
    let counts = report.counts.expect("in range");
    assert!(!counts.orientable && !counts.closed && counts.volume.is_none());
}

#[test]
fn all_loops_of_up_to_eight_over_two_numbers_are_compared_as_cycles() {
    let loops = lists(2, 8);
    let report = check(&mesh(&[[0, 0, 0], [1, 0, 0]], &loops), None);
    let equal = |l: &Vec<u32>| (0..loops.len()).filter(|i| same_cycle(l, &loops[*i])).collect::<Vec<_>>();
    let groups: BTreeSet<Vec<usize>> = loops.iter().map(equal).filter(|group| group.len() > 1).collect();
    assert!(report.defects.of(Category::DuplicateFace).cloned().eq(groups.into_iter().map(Element::Faces)));
}

#[test]
fn long_loops_of_few_vertices_are_compared_as_cycles_at_once() {
    let zeros = vec![0; 50_000];
    let (mut odd, mut turned) = (zeros.clone(), zeros.clone());
    (odd[40_000], odd[40_002], turned[7], turned[9]) = (1, 2, 2, 1);
    let loops = [zeros.clone(), odd.clone(), turned, zeros, odd[1..].to_vec()];
    let report = check(&mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &loops), None);
    let same: Vec<&Element> = report.defects.of(Category::DuplicateFace).collect();
    assert_eq!(same, [&Element::Faces(vec![0, 3]), &Element::Faces(vec![1, 2])]);
}

#[test]
fn ten_thousand_faces_take_seconds() {
    // A height field of 71·71 squares, two triangles each: edges along both axes and diagonals.
    let n = 72_u32;
    let vertices = (0..n * n)
        .map(|i| specimens::rational([[i64::from(i % n), 1], [i64::from(i / n), 1], [i64::from(i * i % 17), 5]]));
    let square = |i: u32| [Face::new([i, i + 1, i + n + 1]), Face::new([i, i + n + 1, i + n])];
    let faces = (0..n * n - n).filter(|i| i % n + 1 < n).flat_map(square).collect();
    let field = VertexList { vertices: vertices.collect(), faces };
    let report = check(&field, None);
    assert_eq!(categories(&report.defects), [Category::BoundaryEdge]);
    assert_eq!(report.defects.of(Category::BoundaryEdge).count(), 4 * 71);
    assert_eq!(report.counts.expect("in range").chi, 1);
}

#[test]
fn a_polygon_of_two_thousand_vertices_crosses_itself_only_where_it_does() {
    // A comb: teeth of width 1, then the way back below them.
    let teeth = 500_i64;
    let mut points: Vec<[i64; 3]> =
        (0..teeth).flat_map(|i| [[4 * i, 0, 7], [4 * i + 1, 9, 7], [4 * i + 2, 9, 7], [4 * i + 3, 0, 7]]).collect();
    points.extend([[4 * teeth, -1, 7], [-1, -1, 7]]);
    let outer: Vec<u32> = (0..points.len() as u32).collect();
    let sound = check(&mesh(&points, std::slice::from_ref(&outer)), None);
    assert!(!sound.defects.has(Category::SelfCrossingLoop));
    points[2 * teeth as usize][1] = -2;
    assert!(check(&mesh(&points, &[outer]), None).defects.has(Category::SelfCrossingLoop));
}

/// Coordinates in which coincidences are common: 0, 1, 2, halves, and a hair beside them.
fn coordinate() -> impl Strategy<Value = Rational> {
    let hair = prop_oneof![6 => Just(0_i64), 1 => Just(1), 1 => Just(-1)];
    (0..=4_i64, hair)
        .prop_map(|(half, hair)| specimens::number([half, 2]) + specimens::number([hair, 1_000_000_000_000_000]))
}

fn any_mesh() -> impl Strategy<Value = VertexList> {
    let vertices =
        prop::collection::vec([coordinate(), coordinate(), coordinate()].prop_map(isoracle::linear::Vector), 1..8);
    let flat = prop_oneof![Just(false), Just(true)];
    (vertices, flat).prop_flat_map(|(mut vertices, flat)| {
        if flat {
            // All in one plane that is no coordinate plane: z = x + y.
            for v in &mut vertices {
                v.0[2] = Rational::from(&v.0[0] + &v.0[1]);
            }
        }
        let n = vertices.len() as u32;
        let cycle = move |longest| prop::collection::vec(0..n, 0..longest);
        let face = (cycle(7), prop::collection::vec(cycle(5), 0..2)).prop_map(|(outer, holes)| Face { outer, holes });
        prop::collection::vec(face, 0..6).prop_map(move |faces| VertexList { vertices: vertices.clone(), faces })
    })
}

/// A change to a mesh, by numbers that are reduced to its size.
#[derive(Clone, Debug)]
enum Change {
    Flip(usize),
    Drop(usize),
    Repeat(usize),
    Rename(usize, usize),
    Move(usize, usize, Rational),
    Cover(usize, usize),
    Shift(usize),
}

fn change() -> impl Strategy<Value = Change> {
    let i = 0..1000_usize;
    prop_oneof![
        i.clone().prop_map(Change::Flip),
        i.clone().prop_map(Change::Drop),
        i.clone().prop_map(Change::Repeat),
        (i.clone(), i.clone()).prop_map(|(a, b)| Change::Rename(a, b)),
        (i.clone(), 0..3_usize, coordinate()).prop_map(|(v, k, x)| Change::Move(v, k, x)),
        (i.clone(), i.clone()).prop_map(|(a, b)| Change::Cover(a, b)),
        i.prop_map(Change::Shift),
    ]
}

fn changed(mut mesh: VertexList, changes: &[Change]) -> VertexList {
    for change in changes {
        let (f, v) = (mesh.faces.len().max(1), mesh.vertices.len());
        match change {
            Change::Flip(i) => mesh.faces.iter_mut().skip(i % f).take(1).for_each(|face| *face = face.reversed()),
            Change::Drop(i) => drop((!mesh.faces.is_empty()).then(|| mesh.faces.remove(i % f))),
            Change::Repeat(i) => mesh.faces.extend(mesh.faces.get(i % f).cloned()),
            Change::Rename(a, b) => {
                let (a, b) = ((a % v) as u32, (b % v) as u32);
                let vertices =
                    mesh.faces.iter_mut().flat_map(|face| face.holes.iter_mut().chain([&mut face.outer])).flatten();
                vertices.filter(|w| **w == a).for_each(|w| *w = b);
            }
            Change::Move(i, k, x) => mesh.vertices[i % v].0[*k] = x.clone(),
            Change::Cover(a, b) => mesh.vertices[a % v] = mesh.vertices[b % v].clone(),
            Change::Shift(i) => mesh.faces.iter_mut().skip(i % f).take(1).for_each(|face| {
                if !face.outer.is_empty() {
                    face.outer.rotate_left(1);
                }
            }),
        }
    }
    mesh
}

fn changed_specimen() -> impl Strategy<Value = VertexList> {
    let small: Vec<VertexList> =
        specimens::all().into_iter().map(|(_, mesh)| mesh).filter(|mesh| mesh.faces.len() <= 10).collect();
    (prop::sample::select(small), prop::collection::vec(change(), 0..4))
        .prop_map(|(mesh, changes)| changed(mesh, &changes))
}

/// A list of edges with faces that is right but for a few of its items.
fn listed(mesh: &VertexList, wrong: &[(usize, u32, u32)]) -> (Vec<[u32; 2]>, Vec<Vec<u32>>) {
    let mut edges: Vec<[u32; 2]> =
        mesh.faces.iter().flat_map(|face| face.sides().collect::<Vec<_>>()).filter(|[a, b]| a < b).collect();
    edges.sort_unstable();
    edges.dedup();
    for &(i, a, b) in wrong {
        match i % 4 {
            0 => edges.push([a, b]),
            1 => drop((!edges.is_empty()).then(|| edges.remove(i % edges.len().max(1)))),
            2 => edges.extend(edges.get(i % edges.len().max(1)).map(|[a, b]| [*b, *a])),
            _ => {}
        }
    }
    let users = |[a, b]: [u32; 2]| {
        let uses = |face: &Face| face.sides().any(|side| side == [a, b] || side == [b, a]);
        (0..).zip(&mesh.faces).filter(|(_, face)| uses(face)).map(|(f, _)| f).collect::<Vec<u32>>()
    };
    let mut faces: Vec<Vec<u32>> = edges.iter().map(|edge| users(*edge)).collect();
    for &(i, a, _) in wrong.iter().filter(|_| !edges.is_empty()) {
        let at = i % edges.len();
        match i % 5 {
            0 => faces[at].push(a),
            1 => drop(faces[at].pop()),
            2 => faces[at].reverse(),
            _ => {}
        }
    }
    (edges, faces)
}

proptest! {
    #[test]
    fn any_mesh_is_judged_as_by_brute_force(mesh in any_mesh()) {
        prop_assert_eq!(found(&check(&mesh, None)), naive_check(&mesh, None));
    }

    #[test]
    fn a_changed_specimen_is_judged_as_by_brute_force(mesh in changed_specimen()) {
        prop_assert_eq!(found(&check(&mesh, None)), naive_check(&mesh, None));
    }

    #[test]
    fn a_list_of_edges_is_judged_as_by_brute_force(
        mesh in changed_specimen(), wrong in prop::collection::vec((0..1000_usize, 0..12_u32, 0..12_u32), 0..4), with_faces: bool,
    ) {
        let (edges, faces) = listed(&mesh, &wrong);
        let faces = with_faces.then_some(faces);
        let list = ListedEdges::new(edges.clone(), faces.clone()).expect("as many as edges");
        let naive = naive_check(&mesh, Some(Listed { edges: &edges, faces: faces.as_deref() }));
        prop_assert_eq!(found(&check(&mesh, Some(&list))), naive);
    }

    #[test]
    fn the_volume_is_that_of_the_moved_mesh_and_turns_with_the_faces(mesh in changed_specimen(), by in [coordinate(), coordinate(), coordinate()]) {
        let mut moved = mesh.clone();
        moved.vertices.iter_mut().for_each(|v| *v = v.clone() + &isoracle::linear::Vector(by.clone()));
        let turned = VertexList { faces: mesh.faces.iter().map(Face::reversed).collect(), ..mesh.clone() };
        let volume = |mesh: &VertexList| check(mesh, None).counts.and_then(|counts| counts.volume);
        prop_assert_eq!(volume(&moved), volume(&mesh));
        let plane = !check(&mesh, None).defects.has(Category::NonplanarFace);
        prop_assert!(!plane || volume(&turned) == volume(&mesh).map(|v| -v));
    }
}
