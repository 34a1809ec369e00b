//! What the text claims of operations, and what the preconditions are.

use super::building::boundary_of;
use super::meshes::mesh;
use super::small::by_homology;
use super::states::{Limit, boundary, reached};
use isoracle::mesh::euler_operators::{
    BASIS, Boundary, Corner, Counts, Defect, FaceId, HalfEdge, LoopId, Name, Operator, Refused, Scope, ShellId, Span,
    VertexId,
};
use std::collections::BTreeSet;

/// The boundary after these operators, all of which are allowed.
fn after(mut b: Boundary, operators: &[Operator]) -> Boundary {
    for operator in operators {
        b.apply(operator).unwrap_or_else(|refused| panic!("{operator:?}: {refused}"));
    }
    b
}

mod me_108 {
    use super::*;

    const MOST: i64 = 2;

    fn row(c: Counts) -> [i64; 6] {
        [c.v, c.e, c.f, c.h, c.c, c.g]
    }

    /// All six numbers from −2 to 2.
    fn box_() -> impl Iterator<Item = Counts> {
        let digits = |code: i64| [1, 5, 25, 125, 625, 3125].map(|unit| code / unit % 5 - MOST);
        (0..5i64.pow(6)).map(digits).map(|[v, e, f, h, c, g]| Counts { v, e, f, h, c, g })
    }

    #[test]
    fn balanced_numbers_are_integer_combinations_in_one_way_and_others_are_none() {
        for counts in box_() {
            let Some(times) = counts.in_basis() else {
                assert_ne!(counts.balance(), 0);
                continue;
            };
            let parts = BASIS.iter().zip(times).map(|(change, n)| *change * i64::try_from(n).expect("it is small"));
            assert_eq!(parts.sum::<Counts>(), counts);
        }
    }

    /// By integer row and column steps alone: the five rows, and the equation's complement, have invariant factors 1.
    #[test]
    fn the_invariant_factors_are_five_ones() {
        let mut rows: Vec<Vec<i64>> = BASIS.iter().map(|change| row(*change).to_vec()).collect();
        assert_eq!(invariant_factors(&mut rows), [1; 5]);
        // With one of them doubled the index is two: the method sees it.
        let mut rows: Vec<Vec<i64>> = BASIS.iter().map(|change| row(*change).to_vec()).collect();
        rows[4].iter_mut().for_each(|n| *n *= 2);
        assert_eq!(invariant_factors(&mut rows), [1, 1, 1, 1, 2]);
    }

    /// The diagonal of Smith's normal form.
    fn invariant_factors(rows: &mut [Vec<i64>]) -> Vec<i64> {
        let (height, width) = (rows.len(), rows[0].len());
        for k in 0..height {
            loop {
                let places = (k..height).flat_map(|i| (k..width).map(move |j| (i, j)));
                let pivot = places.filter(|(i, j)| rows[*i][*j] != 0).min_by_key(|(i, j)| rows[*i][*j].abs());
                let Some((i, j)) = pivot else { break };
                rows.swap(k, i);
                rows.iter_mut().for_each(|row| row.swap(k, j));
                for i in k + 1..height {
                    let n = rows[i][k].div_euclid(rows[k][k]);
                    (0..width).for_each(|j| rows[i][j] -= n * rows[k][j]);
                }
                for j in k + 1..width {
                    let n = rows[k][j].div_euclid(rows[k][k]);
                    rows.iter_mut().for_each(|row| row[j] -= n * row[k]);
                }
                let is_done = (k + 1..height).all(|i| rows[i][k] == 0) && (k + 1..width).all(|j| rows[k][j] == 0);
                let open = (k + 1..height).find(|&i| rows[i][k + 1..].iter().any(|n| n % rows[k][k] != 0));
                match (is_done, open) {
                    (false, _) => {}
                    (true, None) => break,
                    (true, Some(i)) => (0..width).for_each(|j| rows[k][j] += rows[i][j]),
                }
            }
        }
        (0..height).map(|k| rows[k][k].abs()).collect()
    }

    #[test]
    fn the_operator_between_shells_is_a_sum_of_three() {
        let ksfmr = Operator::Ksfmr { face: FaceId(0), into: FaceId(1) }.change();
        assert_eq!(ksfmr.in_basis(), Some([-1, 1, 0, 1, 0]));
        assert_eq!(BASIS[1] + BASIS[3] + BASIS[0] * -1, ksfmr);
    }

    #[test]
    fn the_greatest_numbers_do_not_overflow() {
        let counts = Counts { v: i64::MAX, e: i64::MIN, f: i64::MAX, h: i64::MIN, c: i64::MIN, g: i64::MAX };
        assert_eq!(counts.balance(), 4 * i128::from(i64::MAX) - 4 * i128::from(i64::MIN));
        assert_eq!(counts.in_basis(), None);
    }
}

mod me_111 {
    use super::*;

    #[test]
    fn the_sum_of_two_tori_has_the_genus_of_both() {
        let tori = boundary_of(&mesh("two tori"));
        let sum = after(tori.clone(), &[Operator::Ksfmr { face: FaceId(0), into: FaceId(9) }]);
        let [before, now] = [&tori, &sum].map(by_homology);
        assert_eq!([before.c, before.g], [2, 2]);
        assert_eq!([now.c, now.g], [1, 2]);
        assert_eq!(sum.defects(), []);
    }

    #[test]
    fn the_sum_of_two_cubes_changes_no_genus() {
        let cubes = boundary_of(&mesh("two cubes"));
        let sum = after(cubes.clone(), &[Operator::Ksfmr { face: FaceId(0), into: FaceId(6) }]);
        let [before, now] = [&cubes, &sum].map(by_homology);
        assert_eq!([before.c, before.g], [2, 0]);
        assert_eq!([now.c, now.g], [1, 0]);
    }

    #[test]
    fn a_hole_through_the_cube_changes_the_genus() {
        let cube = boundary_of(&mesh("block with hole and pocket"));
        assert_eq!(by_homology(&cube).g, 1);
        // The pocket's bottom and the block's: the pocket becomes a second hole.
        let through = after(cube, &[Operator::Kfmrh { face: FaceId(2), into: FaceId(0) }]);
        assert_eq!(by_homology(&through), Counts { v: 24, e: 36, f: 14, h: 4, c: 1, g: 2 });
    }

    #[test]
    fn every_global_operator_changes_either_the_genus_or_the_number_of_shells() {
        let (shell, face, outer, vertex) = (ShellId(0), FaceId(0), LoopId(0), VertexId(0));
        let (ring, into, half_edge) = (outer, face, HalfEdge(0));
        let (span, rings) = (Span::AllFrom(half_edge), BTreeSet::new());
        let global = [
            (Operator::Mvfs { shell, face, outer, vertex }, [1, 0]),
            (Operator::Kvfs { shell }, [-1, 0]),
            (Operator::Kfmrh { face, into }, [0, 1]),
            (Operator::Mfkrh { ring, face }, [0, -1]),
            (Operator::Ksfmr { face, into }, [-1, 0]),
            (Operator::Msfkr { ring, face, shell }, [1, 0]),
        ];
        for (operator, change) in global {
            assert_eq!((operator.scope(), [operator.change().c, operator.change().g]), (Scope::Global, change));
        }
        let (from, to) = (Corner::Before(half_edge), Corner::Alone(vertex));
        let local = [
            Operator::Mev { span, half_edge, vertex },
            Operator::Kev { half_edge },
            Operator::Mef { span, half_edge, outer, face, rings },
            Operator::Kef { half_edge },
            Operator::Kemr { half_edge, ring },
            Operator::Mekr { from, to, half_edge },
        ];
        assert!(local.iter().all(|operator| operator.scope() == Scope::Local));
    }
}

mod me_115 {
    use super::*;

    /// A triangle in a face of the cube: an edge from a corner of the face, two more, one that closes them to a new face,
    /// and the first one wiped out.
    fn with_triangle() -> Vec<Boundary> {
        let cube = boundary_of(&mesh("cube"));
        let corner = cube.cycle(LoopId(0))[0];
        let [e, f, g, h] = [24, 26, 28, 30].map(HalfEdge);
        let strut = |at, half_edge, v| Operator::Mev {
            span: Span::NothingAt(Corner::Before(at)),
            half_edge,
            vertex: VertexId(v),
        };
        let drawn = [
            strut(corner, e, 8),
            strut(e.mate(), f, 9),
            strut(f.mate(), g, 10),
            Operator::Mef {
                span: Span::Between(f, g.mate()),
                half_edge: h,
                outer: LoopId(6),
                face: FaceId(6),
                rings: BTreeSet::new(),
            },
            Operator::Kemr { half_edge: e, ring: LoopId(7) },
        ];
        (0..=drawn.len()).map(|n| after(cube.clone(), &drawn[..n])).collect()
    }

    #[test]
    fn connected_lines_keep_v_minus_e_plus_f_and_a_line_of_its_own_does_not() {
        let states = with_triangle();
        let printed = |b: &Boundary| by_homology(b).v - by_homology(b).e + by_homology(b).f;
        assert_eq!(states.iter().map(printed).collect::<Vec<_>>(), [2, 2, 2, 2, 2, 3]);
        assert!(states.iter().all(|b| by_homology(b).euler_number() == 2));
        assert_eq!(states.last().map(by_homology), Some(Counts { v: 11, e: 15, f: 7, h: 1, c: 1, g: 0 }));
    }
}

mod me_116 {
    use super::*;

    /// What a boundary is, is the same wherever its vertices are: with all of them at one point it is sound.
    #[test]
    fn positions_are_not_looked_at() {
        let cube = isoracle::mesh::examples::cube();
        let sound = boundary_of(&cube.faces);
        let mut collapsed = cube.clone();
        collapsed.vertices.fill(isoracle::mesh::examples::point([0, 0, 0]));
        let boundary = boundary_of(&collapsed.faces);
        assert_eq!((boundary.defects(), &boundary), (vec![], &sound));
        assert_ne!(collapsed, cube);
    }

    #[test]
    fn every_boundary_that_operators_make_is_sound() {
        let limit = Limit { edges_and_rings: 2, shells: 3 };
        let all = reached(Boundary::new(), limit, |_| true);
        assert!(all.values().all(|b| b.defects() == Vec::<Defect>::new()));
        assert!(all.values().any(|b| b.counted().c == 3));
    }
}

mod me_117 {
    use super::*;

    #[test]
    fn of_each_two_operators_one_is_allowed() {
        let limit = Limit { edges_and_rings: 3, shells: 2 };
        let mut met = [0; 4];
        for b in reached(Boundary::new(), limit, |_| true).values() {
            let allowed = |operator: &Operator| b.clone().apply(operator).is_ok();
            let (new, shell) = (b.unused_face(), b.unused_shell());
            for face in b.faces().filter(|f| b.rings(*f).next().is_none()) {
                for into in b.faces().filter(|f| *f != face) {
                    let [handle, merged] =
                        [Operator::Kfmrh { face, into }, Operator::Ksfmr { face, into }].map(|o| allowed(&o));
                    assert_eq!([handle, merged], [b.shell_of(face) == b.shell_of(into), !handle]);
                    met[usize::from(merged)] += 1;
                }
            }
            for ring in b.faces().flat_map(|f| b.rings(f)) {
                let [same, two] = [Operator::Mfkrh { ring, face: new }, Operator::Msfkr { ring, face: new, shell }]
                    .map(|o| allowed(&o));
                assert!(same != two);
                met[2 + usize::from(two)] += 1;
            }
        }
        assert!(met.iter().all(|n| *n > 0), "{met:?}");
    }
}

/// Every precondition, by an operator that does not meet it.
#[test]
fn preconditions_are_named_and_nothing_is_changed() {
    let cube = boundary_of(&mesh("cube"));
    let block = boundary_of(&mesh("block with hole and pocket"));
    let two = boundary_of(&mesh("two cubes"));
    let hollow = boundary_of(&mesh("hollow triangle"));
    let point = boundary(&[vec![vec![]]]);
    let torus = boundary(&[vec![vec![0, 2, 1, 3]]]);
    let [h, v, l, f, s] = [90; 5];
    let (h, v, l, f, s) = (HalfEdge(h), VertexId(v), LoopId(l), FaceId(f), ShellId(s));
    let first = cube.cycle(LoopId(0));
    let (a, a_mate) = (first[0], first[0].mate());
    let at = |h| Span::NothingAt(Corner::Before(h));
    let mev = |span| Operator::Mev { span, half_edge: h, vertex: v };
    let mef = |span, rings: &[u32]| Operator::Mef {
        span,
        half_edge: h,
        outer: l,
        face: f,
        rings: rings.iter().copied().map(LoopId).collect(),
    };
    let mekr = |from, to| Operator::Mekr { from, to, half_edge: h };
    let before = |b: &Boundary, l: u32| Corner::Before(b.cycle(LoopId(l))[0]);
    let mvfs = |shell, face, outer, vertex| Operator::Mvfs {
        shell: ShellId(shell),
        face: FaceId(face),
        outer: LoopId(outer),
        vertex: VertexId(vertex),
    };
    let half_edge_taken = Refused::Taken(Name::HalfEdge(HalfEdge(5)));
    let ring = block.rings(FaceId(1)).next().expect("the top has rings");
    let cases = [
        (&cube, mvfs(0, 90, 90, 90), Refused::Taken(Name::Shell(ShellId(0)))),
        (&cube, mvfs(90, 0, 90, 90), Refused::Taken(Name::Face(FaceId(0)))),
        (&cube, mvfs(90, 90, 0, 90), Refused::Taken(Name::Loop(LoopId(0)))),
        (&cube, mvfs(90, 90, 90, 0), Refused::Taken(Name::Vertex(VertexId(0)))),
        (&cube, Operator::Kvfs { shell: s }, Refused::NoSuch(Name::Shell(s))),
        (&cube, Operator::Kvfs { shell: ShellId(0) }, Refused::NotASingleVertex(ShellId(0))),
        (&torus, Operator::Kvfs { shell: ShellId(0) }, Refused::NotASingleVertex(ShellId(0))),
        (&cube, mev(at(h)), Refused::NoSuch(Name::HalfEdge(h))),
        (&cube, mev(Span::NothingAt(Corner::Alone(v))), Refused::NoSuch(Name::Vertex(v))),
        (&cube, mev(Span::NothingAt(Corner::Alone(VertexId(0)))), Refused::NotAlone(VertexId(0))),
        (&cube, mev(Span::Between(a, a)), Refused::EmptySpan(a)),
        (&cube, mev(Span::Between(a, a_mate)), Refused::TwoVertices(a, a_mate)),
        (&cube, Operator::Mev { span: at(a), half_edge: HalfEdge(5), vertex: v }, half_edge_taken),
        (
            &cube,
            Operator::Mev { span: at(a), half_edge: h, vertex: VertexId(3) },
            Refused::Taken(Name::Vertex(VertexId(3))),
        ),
        (&cube, Operator::Kev { half_edge: h }, Refused::NoSuch(Name::HalfEdge(h))),
        (&torus, Operator::Kev { half_edge: HalfEdge(2) }, Refused::ClosedEdge(HalfEdge(2))),
        (&cube, mef(Span::Between(a, a), &[]), Refused::EmptySpan(a)),
        (&cube, mef(Span::Between(a, a_mate), &[]), Refused::TwoLoops(a, a_mate)),
        (&block, mef(at(block.cycle(ring)[0]), &[ring.0]), Refused::NotToMove(ring)),
        (&block, mef(at(block.cycle(LoopId(0))[0]), &[ring.0]), Refused::NotToMove(ring)),
        (&cube, mef(at(a), &[0]), Refused::NotToMove(LoopId(0))),
        (&torus, Operator::Kef { half_edge: HalfEdge(0) }, Refused::OneFace(FaceId(0))),
        (&block, Operator::Kef { half_edge: block.cycle(ring)[0] }, Refused::IsRing(ring)),
        (&cube, Operator::Kemr { half_edge: a, ring: l }, Refused::TwoLoops(a, a_mate)),
        (&torus, Operator::Kemr { half_edge: HalfEdge(0), ring: LoopId(0) }, Refused::Taken(Name::Loop(LoopId(0)))),
        (&hollow, mekr(before(&hollow, 1), before(&hollow, 0)), Refused::IsOuter(LoopId(0))),
        (&hollow, mekr(before(&hollow, 1), before(&hollow, 1)), Refused::OneLoop(LoopId(1))),
        (&hollow, mekr(before(&hollow, 0), before(&hollow, 3)), Refused::TwoFaces(LoopId(0), LoopId(3))),
        (&cube, Operator::Kfmrh { face: FaceId(1), into: FaceId(1) }, Refused::OneFace(FaceId(1))),
        (&cube, Operator::Kfmrh { face: FaceId(1), into: f }, Refused::NoSuch(Name::Face(f))),
        (&hollow, Operator::Kfmrh { face: FaceId(0), into: FaceId(1) }, Refused::HasRings(FaceId(0))),
        (&two, Operator::Kfmrh { face: FaceId(0), into: FaceId(6) }, Refused::TwoShells(ShellId(0), ShellId(1))),
        (&two, Operator::Ksfmr { face: FaceId(0), into: FaceId(1) }, Refused::OneShell(ShellId(0))),
        (&cube, Operator::Mfkrh { ring: LoopId(0), face: f }, Refused::IsOuter(LoopId(0))),
        (&cube, Operator::Mfkrh { ring: l, face: f }, Refused::NoSuch(Name::Loop(l))),
        (&block, Operator::Msfkr { ring, face: f, shell: s }, Refused::DoesNotDivide(ring)),
        (&point, Operator::Msfkr { ring: LoopId(0), face: f, shell: s }, Refused::IsOuter(LoopId(0))),
    ];
    for (b, operator, refused) in cases {
        let mut now = b.clone();
        assert_eq!(now.apply(&operator), Err(refused), "{operator:?}");
        assert_eq!(now, *b, "{operator:?}");
        assert!(!refused.to_string().is_empty());
    }
    // An island in a face: without its ring the shell falls in two.
    let merged = after(two, &[Operator::Ksfmr { face: FaceId(0), into: FaceId(6) }]);
    let divides = Operator::Mfkrh { ring: LoopId(0), face: f };
    assert_eq!(merged.clone().apply(&divides), Err(Refused::Divides(LoopId(0))));
}
