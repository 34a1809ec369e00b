//! Meshes from nothing.

use super::canonical::code;
use super::meshes::{mesh, meshes};
use super::small::by_homology;
use super::words::Words;
use isoracle::mesh::euler_operators::{
    Boundary, Counts, NotClosed, NotPaired, Operator, RefusedStep, ShellId, VertexId, construction, replay,
};
use isoracle::mesh::euler_operators::{HalfEdge, Name, Refused};
use isoracle::mesh::face::{Face, sides};
use isoracle::mesh::triangles::{self, Triangle, boundary_edges};
use std::collections::{BTreeMap, BTreeSet};

pub fn boundary_of(faces: &[Face]) -> Boundary {
    Boundary::try_from(faces).expect("it is closed and oriented")
}

fn counts([v, e, f, h, c, g]: [i64; 6]) -> Counts {
    Counts { v, e, f, h, c, g }
}

/// How often mvfs, mev, mef, kemr, kfmrh and mekr stand in a sequence; none other does.
fn uses(operators: &[Operator]) -> [i64; 6] {
    let mut uses = [0; 6];
    for operator in operators {
        uses[match operator {
            Operator::Mvfs { .. } => 0,
            Operator::Mev { .. } => 1,
            Operator::Mef { .. } => 2,
            Operator::Kemr { .. } => 3,
            Operator::Kfmrh { .. } => 4,
            Operator::Mekr { .. } => 5,
            other => panic!("{other:?}"),
        }] += 1;
    }
    uses
}

/// Loops from their smallest vertex, the holes sorted.
fn turned(face: &Face) -> Face {
    let turned = |word: &Vec<u32>| {
        let mut word = word.clone();
        let first = (0..word.len()).min_by_key(|&i| word[i]).unwrap_or(0);
        word.rotate_left(first);
        word
    };
    let mut holes: Vec<Vec<u32>> = face.holes.iter().map(turned).collect();
    holes.sort();
    Face { outer: turned(&face.outer), holes }
}

mod me_113 {
    use super::*;

    #[test]
    fn every_known_mesh_is_built_from_nothing() {
        for mesh in meshes() {
            let boundary = boundary_of(&mesh.faces);
            let operators = construction(&boundary);
            let mut built = Boundary::new();
            for operator in &operators {
                built.apply(operator).unwrap_or_else(|refused| panic!("{}: {operator:?}: {refused}", mesh.name));
                assert_eq!((built.defects(), built.tracked()), (vec![], built.counted()), "{}", mesh.name);
            }
            assert_eq!(built, boundary, "{}", mesh.name);
            assert_eq!(built.tracked(), counts(mesh.counts), "{}", mesh.name);
            assert_eq!(by_homology(&built), counts(mesh.counts), "{}", mesh.name);
            assert_eq!(code(&Words::of(&built)), code(&Words::of(&boundary)), "{}", mesh.name);
            let polygons = built.polygons();
            assert!(polygons.iter().map(turned).eq(mesh.faces.iter().map(turned)), "{}", mesh.name);
            let [v, e, f, h, c, g] = mesh.counts;
            assert_eq!(uses(&operators), [c, v - c, f - c + g, h, g, g], "{}", mesh.name);
            assert_eq!(operators.len() as i64, c + g + e + 2 * h, "{}", mesh.name);
            let [mvfs, mev, mef, kemr, kfmrh, mekr] = uses(&operators).map(i128::from);
            assert_eq!(counts(mesh.counts).in_basis(), Some([mvfs, mev, mef, kemr - mekr, kfmrh]), "{}", mesh.name);
        }
    }

    #[test]
    fn the_cube_takes_one_mvfs_seven_mev_and_five_mef() {
        assert_eq!(uses(&construction(&boundary_of(&mesh("cube")))), [1, 7, 5, 0, 0, 0]);
    }

    /// A larger one, so that time is not that of all pairs.
    #[test]
    fn a_torus_of_many_squares_is_built_from_nothing() {
        let boundary = boundary_of(&super::super::meshes::torus(40));
        assert_eq!(boundary.defects(), []);
        assert_eq!(replay(&construction(&boundary)), Ok(boundary));
    }

    /// Every set of at most six oriented triangles on five vertices: those that close up are built, the others are told.
    #[test]
    fn every_small_closed_triangle_mesh_is_built_from_nothing() {
        let corners = (0..5u32).flat_map(|a| (a + 1..5).flat_map(move |b| (b + 1..5).map(move |c| [a, b, c])));
        let oriented: Vec<Triangle> = corners.flat_map(|[a, b, c]| [[a, b, c], [a, c, b]]).collect();
        assert_eq!(oriented.len(), 20);
        let mut of_counts: BTreeMap<[i64; 6], usize> = BTreeMap::new();
        let mut pending: Vec<(Vec<Triangle>, usize)> = vec![(vec![], 0)];
        while let Some((set, first)) = pending.pop() {
            if set.len() < 6 {
                pending.extend((first..20).map(|i| ([&set[..], &[oriented[i]]].concat(), i + 1)));
            }
            let faces: Vec<Face> = set.iter().copied().map(Face::from).collect();
            // A triangle and its other side are a lamina, which is closed.
            let is_wrong = |defect: &triangles::Defect| !matches!(defect, triangles::Defect::DuplicateTriangle { .. });
            let is_closed = boundary_edges(&set).is_empty() && !triangles::defects(5, &set).iter().any(is_wrong);
            let boundary = Boundary::try_from(&faces[..]);
            assert_eq!(boundary.is_ok(), is_closed, "{set:?}: {boundary:?}");
            if let Ok(boundary) = boundary {
                let Counts { v, e, f, h, c, g } = boundary.counted();
                assert_eq!(boundary.counted(), by_homology(&boundary));
                *of_counts.entry([v, e, f, h, c, g]).or_default() += 1;
                assert_eq!(replay(&construction(&boundary)), Ok(boundary));
            }
        }
        // Nothing, 10 laminas, 5 tetrahedra and 10 bipyramids, either side out.
        let found: Vec<([i64; 6], usize)> = of_counts.into_iter().collect();
        assert_eq!(
            found,
            [([0, 0, 0, 0, 0, 0], 1), ([3, 3, 2, 0, 1, 0], 10), ([4, 6, 4, 0, 1, 0], 10), ([5, 9, 6, 0, 1, 0], 20),]
        );
    }

    #[test]
    fn a_refused_step_is_told_by_its_number() {
        let mut operators = construction(&boundary_of(&mesh("cube")));
        operators.insert(3, Operator::Kvfs { shell: ShellId(7) });
        let refused = Refused::NoSuch(Name::Shell(ShellId(7)));
        assert_eq!(replay(&operators), Err(RefusedStep { step: 3, refused }));
    }
}

#[test]
fn faces_that_are_no_closed_surface_are_told() {
    let cube = mesh("cube");
    let without_one = &cube[1..];
    let told = |faces: &[Face]| Boundary::try_from(faces).expect_err("it is not closed");
    assert_eq!(told(without_one), NotClosed::OpenSide { side: [0, 1] });
    assert_eq!(told(&[&cube[..], &cube[..1]].concat()), NotClosed::RepeatedSide { side: [0, 3] });
    assert_eq!(told(&[Face::from([0, 1]), Face::from([])]), NotClosed::EmptyLoop { face: 1 });
    let hole = Face { outer: vec![0, 1], holes: vec![vec![]] };
    assert_eq!(told(&[hole]), NotClosed::EmptyLoop { face: 0 });
    assert_eq!(told(&[Face::from([0, 1]), Face::from([7])]), NotClosed::ClosedSide { face: 1, vertex: 7 });
    // Two tetrahedra with one common vertex.
    let other = [[0u32, 5, 4], [0, 4, 6], [4, 5, 6], [0, 6, 5]].map(Face::from);
    let pinched = [&mesh("tetrahedron")[..], &other[..]].concat();
    assert_eq!(told(&pinched), NotClosed::SplitVertex { vertex: 0 });
    // The same two, inside out in part.
    let turned = [&mesh("tetrahedron")[1..], &[mesh("tetrahedron")[0].reversed()]].concat();
    assert!(matches!(told(&turned), NotClosed::RepeatedSide { .. }));
}

#[test]
fn half_edges_that_are_no_boundary_are_told() {
    let told = |faces: &[Vec<Vec<u32>>]| {
        let half = |faces: &[Vec<Vec<u32>>]| -> Vec<Vec<Vec<HalfEdge>>> {
            let word = |word: &Vec<u32>| word.iter().map(|h| HalfEdge(*h)).collect();
            faces.iter().map(|loops| loops.iter().map(word).collect()).collect()
        };
        Boundary::from_loops(&half(faces)).expect_err("it is none")
    };
    assert_eq!(told(&[vec![vec![]], vec![]]), NotPaired::NoLoops { face: 1 });
    assert_eq!(told(&[vec![vec![0, 1]], vec![vec![1]]]), NotPaired::Repeated(HalfEdge(1)));
    assert_eq!(told(&[vec![vec![0, 1, 4]]]), NotPaired::NoMate(HalfEdge(4)));
}

#[test]
fn vertices_keep_their_numbers() {
    let faces = [[9u32, 4, 7], [7, 4, 9]].map(Face::from);
    let boundary = boundary_of(&faces);
    assert_eq!(boundary.vertices().collect::<Vec<_>>(), [4, 7, 9].map(VertexId));
    assert_eq!(boundary.polygons().iter().map(turned).collect::<Vec<_>>(), faces.each_ref().map(turned));
    let used: BTreeSet<[u32; 2]> = faces.iter().flat_map(|face| sides(&face.outer).collect::<Vec<_>>()).collect();
    let ends = |h: HalfEdge| [h, h.mate()].map(|h| boundary.origin(h).expect("it exists").0);
    assert_eq!(boundary.half_edges().map(ends).collect::<BTreeSet<_>>(), used);
    assert!(boundary.half_edges().all(|h| (h.0 % 2 == 0) == (ends(h)[0] < ends(h)[1])));
}
