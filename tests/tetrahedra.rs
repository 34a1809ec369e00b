//! Marching tetrahedra.

use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::cube::Corner;
use isoracle::isosurface::tetrahedra::*;
use isoracle::isosurface::topology::topology;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::number::{Rational, Sign};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet, HashMap};

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn decompositions() -> Vec<Decomposition> {
    let mut all: Vec<_> = Corner::ALL.into_iter().map(Decomposition::Kuhn).collect();
    all.push(Decomposition::Five);
    all
}

fn volume(shape: [usize; 3], values: &[i32]) -> Volume {
    Volume::integers(shape, values.to_vec()).expect("a volume")
}

type Point = [Rational; 3];

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| Rational::from(&a[i] - &b[i]))
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| Rational::from(&a[i] * &b[j]) - Rational::from(&a[j] * &b[i]))
}

fn dot(a: &Point, b: &Point) -> Rational {
    (0..3).fold(Rational::new(), |sum, i| sum + Rational::from(&a[i] * &b[i]))
}

fn six_volumes([a, b, c, d]: [&Point; 4]) -> Rational {
    dot(&minus(b, a), &cross(&minus(c, a), &minus(d, a)))
}

fn corner_point(c: Corner) -> Point {
    c.position().map(Rational::from)
}

/// χ and the number of boundary loops of each component, sorted, by the vertex numbers alone. Panics unless the
/// mesh is an oriented 2-manifold.
fn components(mesh: &TetrahedraMesh) -> Vec<(i64, i64)> {
    let n = mesh.vertices.len();
    let mut next: Vec<HashMap<u32, u32>> = vec![HashMap::new(); n];
    let mut directed = BTreeSet::new();
    for &[a, b, c] in &mesh.triangles {
        for [v, from, to] in [[a, b, c], [b, c, a], [c, a, b]] {
            assert!(directed.insert([v, from]), "edge {v} → {from} twice in one direction");
            assert!(next[v as usize].insert(from, to).is_none());
        }
    }
    // The link of each vertex is one path or one cycle.
    for (v, link) in next.iter().enumerate() {
        assert!(!link.is_empty(), "vertex {v} is in no triangle");
        let ends: BTreeSet<u32> = link.values().copied().collect();
        let starts: Vec<u32> = link.keys().copied().filter(|k| !ends.contains(k)).collect();
        assert!(starts.len() <= 1, "vertex {v} is in two fans");
        let mut at = starts.first().copied().unwrap_or_else(|| *link.keys().next().expect("not empty"));
        let mut steps = 0;
        while let Some(&to) = link.get(&at) {
            steps += 1;
            at = to;
            if steps == link.len() {
                break;
            }
        }
        assert_eq!(steps, link.len(), "vertex {v} has more than one fan");
    }
    let mut label: Vec<usize> = (0..n).collect();
    fn find(label: &[usize], mut i: usize) -> usize {
        while label[i] != i {
            i = label[i];
        }
        i
    }
    for [a, b] in &directed {
        let (a, b) = (find(&label, *a as usize), find(&label, *b as usize));
        label[a.max(b)] = a.min(b);
    }
    let mut totals: BTreeMap<usize, (i64, i64)> = BTreeMap::new();
    for v in 0..n {
        totals.entry(find(&label, v)).or_default().0 += 1;
    }
    for &[a, b] in &directed {
        if a < b || !directed.contains(&[b, a]) {
            totals.entry(find(&label, a as usize)).or_default().0 -= 1;
        }
    }
    for triangle in &mesh.triangles {
        totals.entry(find(&label, triangle[0] as usize)).or_default().0 += 1;
    }
    let mut rim: HashMap<u32, u32> =
        directed.iter().filter(|[a, b]| !directed.contains(&[*b, *a])).map(|[a, b]| (*a, *b)).collect();
    while let Some(start) = rim.keys().next().copied() {
        totals.entry(find(&label, start as usize)).or_default().1 += 1;
        let mut at = start;
        while let Some(to) = rim.remove(&at) {
            at = to;
        }
        assert_eq!(at, start, "the boundary is closed");
    }
    let mut totals: Vec<_> = totals.into_values().collect();
    totals.sort();
    totals
}

/// The boundary of the mesh lies on the border of the grid.
fn assert_boundary_on_border(level: &Level, mesh: &TetrahedraMesh) {
    let directed: BTreeSet<[u32; 2]> = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    for &[a, b] in directed.iter().filter(|[a, b]| !directed.contains(&[*b, *a])) {
        let samples: Vec<[usize; 3]> = [a, b]
            .iter()
            .flat_map(|v| mesh.vertices[*v as usize].ends)
            .map(|s| level.volume.point(s as usize))
            .collect();
        let on_border = (0..3).any(|axis| {
            let last = level.volume.shape()[axis] - 1;
            samples.iter().all(|p| p[axis] == 0) || samples.iter().all(|p| p[axis] == last)
        });
        assert!(on_border, "a boundary edge between {samples:?}");
    }
}

mod decomposition {
    use super::*;

    #[test]
    fn each_fills_the_cell_with_right_handed_tetrahedra_without_overlap() {
        for decomposition in decompositions() {
            for parity in 0..2 {
                let tetrahedra = decomposition.tetrahedra([parity, 0, 0]);
                let volumes: Vec<_> = tetrahedra.iter().map(|t| six_volumes(t.map(corner_point).each_ref())).collect();
                assert!(volumes.iter().all(|v| *v > 0), "{decomposition:?}");
                assert_eq!(volumes.iter().fold(Rational::new(), |sum, v| sum + v), 6);
                // Each point of a fine lattice in general position lies in exactly one.
                for n in 0..343 {
                    let p = [n % 7, n / 7 % 7, n / 49].map(|i| i64::from(i) * 7 + 1);
                    let p = [q(p[0], 50), q(p[1] + 1, 51), q(p[2] + 2, 53)];
                    let inside = tetrahedra.iter().filter(|t| {
                        let t = t.map(corner_point);
                        (0..4).all(|i| {
                            let mut with = t.clone();
                            with[i] = p.clone();
                            six_volumes(with.each_ref()) > 0
                        })
                    });
                    assert_eq!(inside.count(), 1, "{decomposition:?} at {p:?}");
                }
            }
        }
    }

    #[test]
    fn neighbouring_cells_cut_their_common_face_along_one_diagonal() {
        let diagonals = |decomposition: Decomposition, cell: [usize; 3], axis: usize, side: u8| {
            let mut found = BTreeSet::new();
            for t in decomposition.tetrahedra(cell) {
                for a in t {
                    for b in t {
                        let (a, b) = (a.position(), b.position());
                        let apart = (0..3).filter(|&i| a[i] != b[i]).count();
                        if apart == 2 && a[axis] == side && b[axis] == side && a < b {
                            // The diagonal, by its corners within the face.
                            let within = |p: [u8; 3]| [p[(axis + 1) % 3], p[(axis + 2) % 3]];
                            found.insert([within(a).min(within(b)), within(a).max(within(b))]);
                        }
                    }
                }
            }
            assert_eq!(found.len(), 1);
            found
        };
        for decomposition in decompositions() {
            for parity in 0..2 {
                for axis in 0..3 {
                    let mut next = [parity, 0, 0];
                    next[axis] += 1;
                    assert_eq!(
                        diagonals(decomposition, [parity, 0, 0], axis, 1),
                        diagonals(decomposition, next, axis, 0),
                        "{decomposition:?}"
                    );
                }
            }
        }
    }
}

mod one_tetrahedron {
    use super::*;

    /// Rotations and reflections: all renumberings of four corners.
    fn permutations() -> Vec<[usize; 4]> {
        (0..256).map(|n| [n & 3, n >> 2 & 3, n >> 4 & 3, n >> 6]).filter(|p| (0..4).all(|i| p.contains(&i))).collect()
    }

    #[test]
    fn the_16_patterns_of_signs_are_3_cases_up_to_symmetry() {
        let mut orbits = BTreeSet::new();
        let mut sizes = BTreeMap::new();
        for pattern in 0..16u8 {
            let orbit: BTreeSet<u8> = permutations()
                .iter()
                .flat_map(|p| {
                    let image = (0..4).fold(0, |image, i| image | (pattern >> i & 1) << p[i]);
                    [image, 15 - image]
                })
                .collect();
            let corners = match case([0, 1, 2, 3].map(|i| pattern >> i & 1 == 1)) {
                TetrahedronCase::Uncut => 0,
                TetrahedronCase::Triangle(_) => 3,
                TetrahedronCase::Quadrilateral(_) => 4,
            };
            sizes.insert(corners, orbit.len());
            orbits.insert((corners, orbit));
        }
        assert_eq!(orbits.len(), 3);
        assert_eq!(sizes, BTreeMap::from([(0, 2), (3, 8), (4, 6)]));
    }

    #[test]
    fn the_polygon_joins_the_crossed_edges_around_and_faces_the_positive_corners() {
        let corners: [Point; 4] = [[0, 0, 0], [4, 1, 0], [1, 5, 1], [0, 2, 6]].map(|p| p.map(Rational::from));
        assert!(six_volumes(corners.each_ref()) > 0);
        for pattern in 0..16u8 {
            let positive = [0, 1, 2, 3].map(|i| pattern >> i & 1 == 1);
            let polygon: Vec<[usize; 2]> = match case(positive) {
                TetrahedronCase::Uncut => vec![],
                TetrahedronCase::Triangle(edges) => edges.to_vec(),
                TetrahedronCase::Quadrilateral(edges) => edges.to_vec(),
            };
            let sorted: BTreeSet<_> = polygon.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
            let crossed: BTreeSet<_> = (0..4)
                .flat_map(|a| (a + 1..4).map(move |b| [a, b]))
                .filter(|[a, b]| positive[*a] != positive[*b])
                .collect();
            assert_eq!(sorted, crossed);
            assert_eq!(sorted.len(), polygon.len());
            let n = polygon.len();
            for i in 0..n {
                // Consecutive crossings lie on one face of the tetrahedron.
                let on: BTreeSet<usize> = polygon[i].into_iter().chain(polygon[(i + 1) % n]).collect();
                assert_eq!(on.len(), 3, "{pattern:04b}");
                // f linear with values ±1: crossings are midpoints, and the polygon is flat.
                let at = |i: usize| {
                    let [a, b] = polygon[i % n];
                    [0, 1, 2].map(|k| (Rational::from(&corners[a][k] + &corners[b][k])) / 2)
                };
                let (a, b, c) = (at(i), at(i + 1), at(i + 2));
                for (corner, positive) in corners.iter().zip(positive) {
                    let side = Sign::of(six_volumes([&a, &b, &c, corner]).cmp0());
                    assert_eq!(side == Sign::Positive, positive, "{pattern:04b}");
                }
            }
        }
    }
}

mod surfaces {
    use super::*;

    #[test]
    fn every_pattern_of_corner_signs_gives_a_manifold_bounded_on_the_cell() {
        for decomposition in decompositions() {
            for pattern in 0..256 {
                let values: Vec<i32> = (0..8).map(|c| if pattern >> c & 1 == 1 { 1 } else { -1 }).collect();
                let volume = volume([2, 2, 2], &values);
                let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Degenerate };
                let mesh = extract(&level, decomposition).expect("no tie");
                assert_boundary_on_border(&level, &mesh);
                let boundary: i64 = components(&mesh).iter().map(|(_, loops)| *loops).sum();
                assert_eq!(boundary == 0, pattern == 0 || pattern == 255);
                // A second count: the surface separates the corners that edges of tetrahedra connect. With s
                // regions it has s − 1 components, as a ball is cut.
                let mut joined: Vec<usize> = (0..8).collect();
                for t in decomposition.tetrahedra([0, 0, 0]) {
                    for a in t.map(Corner::index) {
                        for b in t.map(Corner::index) {
                            if values[a] == values[b] {
                                let (from, to) = (joined[a], joined[b]);
                                joined.iter_mut().filter(|x| **x == from).for_each(|x| *x = to);
                            }
                        }
                    }
                }
                let regions: BTreeSet<_> = joined.into_iter().collect();
                assert_eq!(components(&mesh).len(), regions.len() - 1, "{decomposition:?} {pattern:08b}");
            }
        }
    }

    #[test]
    fn broken_ties_leave_a_manifold_whatever_ties_there_are() {
        for decomposition in [Decomposition::default(), Decomposition::Five] {
            for code in 0..6561 {
                let values: Vec<i32> = (0..8).map(|c| code / 3i32.pow(c) % 3 - 1).collect();
                let (tied, below) = (volume([2, 2, 2], &values), values.iter().map(|v| 2 * v + 1).collect::<Vec<_>>());
                let level = Level { volume: &tied, isovalue: Rational::new(), tie: Tie::Below };
                let mesh = extract(&level, decomposition).expect("ties are broken");
                // The values 2v + 1 have the signs of v just below 0.
                let shifted = volume([2, 2, 2], &below);
                let shifted = Level { volume: &shifted, isovalue: Rational::new(), tie: Tie::Degenerate };
                assert_eq!(mesh, extract(&shifted, decomposition).expect("odd numbers"));
                components(&mesh);
                for pair in &mesh.vertices {
                    let position = level.crossing_between(*pair);
                    assert!(position.iter().all(|x| *x >= 0 && *x <= 1));
                    for end in pair.ends {
                        if tied.sample(end as usize) == 0 {
                            assert_eq!(position, tied.point(end as usize).map(Rational::from));
                        }
                    }
                }
                // Else the tie is an error that names the first tied sample.
                let strict = Level { volume: &tied, isovalue: Rational::new(), tie: Tie::Degenerate };
                match (extract(&strict, decomposition), values.iter().position(|v| *v == 0)) {
                    (Ok(strict), None) => assert_eq!(strict, mesh),
                    (Err(error), Some(first)) => assert_eq!(error, DegenerateSample { point: tied.point(first) }),
                    (outcome, first) => panic!("{outcome:?}, {first:?}"),
                }
            }
        }
    }

    proptest! {
        #[test]
        fn a_surface_in_a_random_grid_is_a_manifold_closed_inside_the_grid(
            shape in proptest::array::uniform3(2usize..5), values in proptest::collection::vec(-9i32..=9, 64)
        ) {
            let volume = volume(shape, &values[..shape.iter().product()]);
            let level = Level { volume: &volume, isovalue: q(1, 2), tie: Tie::Degenerate };
            for decomposition in decompositions() {
                let mesh = extract(&level, decomposition).expect("no sample is 1/2");
                components(&mesh);
                assert_boundary_on_border(&level, &mesh);
            }
        }

        #[test]
        fn f_equals_c_at_vertices_and_normals_point_to_greater_values(
            shape in proptest::array::uniform3(2usize..4), values in proptest::collection::vec(-9i32..=9, 27)
        ) {
            let volume = volume(shape, &values[..shape.iter().product()]);
            let level = Level { volume: &volume, isovalue: q(1, 3), tie: Tie::Degenerate };
            let mesh = extract(&level, Decomposition::default()).expect("no sample is 1/3");
            for triangle in &mesh.triangles {
                let pairs = triangle.map(|v| mesh.vertices[v as usize]);
                let [a, b, c] = pairs.map(|pair| level.crossing_between(pair));
                let normal = cross(&minus(&b, &a), &minus(&c, &a));
                for pair in pairs {
                    let [low, high] = pair.ends.map(|s| s as usize);
                    let at = level.crossing_between(pair);
                    let (p, r) = (volume.point(low).map(Rational::from), volume.point(high).map(Rational::from));
                    // f along the edge is linear: at the vertex its value is c.
                    let share = dot(&minus(&at, &p), &minus(&r, &p)) / dot(&minus(&r, &p), &minus(&r, &p));
                    let (g0, g1) = (volume.sample(low), volume.sample(high));
                    prop_assert_eq!(Rational::from(&g1 - &g0) * share + &g0, q(1, 3));
                    let up = if g1 > g0 { minus(&r, &p) } else { minus(&p, &r) };
                    prop_assert!(dot(&normal, &up) > 0);
                }
            }
        }

        #[test]
        fn a_linear_function_has_its_plane_by_every_decomposition(
            gradient in proptest::array::uniform3(-5i32..=5), offset in -20i32..=20
        ) {
            let values: Vec<i32> = (0..64)
                .map(|n| gradient[0] * (n % 4) + gradient[1] * (n / 4 % 4) + gradient[2] * (n / 16))
                .collect();
            let volume = volume([4, 4, 4], &values);
            let c = Rational::from(offset) + q(1, 2);
            let level = Level { volume: &volume, isovalue: c.clone(), tie: Tie::Degenerate };
            for decomposition in decompositions() {
                let mesh = extract(&level, decomposition).expect("no sample is half an odd number");
                for pair in &mesh.vertices {
                    prop_assert_eq!(dot(&gradient.map(Rational::from), &level.crossing_between(*pair)), c.clone());
                }
                prop_assert!(mesh.vertices.is_empty() || components(&mesh) == [(1, 1)]);
            }
        }

        #[test]
        fn the_volume_below_a_closed_surface_is_that_of_the_linear_pieces(
            values in proptest::collection::vec(-3i32..=9, 8)
        ) {
            // Eight samples within a frame of positive ones: what is inside is negative. Its volume by the
            // divergence theorem, against the clipped tetrahedra one by one.
            let mut padded = vec![4; 64];
            for (n, v) in values.iter().enumerate() {
                padded[1 + n % 2 + 4 * (1 + n / 2 % 2) + 16 * (1 + n / 4)] = 2 * v + 1;
            }
            let volume = volume([4, 4, 4], &padded);
            let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Degenerate };
            for decomposition in decompositions() {
                let mesh = extract(&level, decomposition).expect("no sample is zero");
                let origin = [0, 0, 0].map(Rational::from);
                let enclosed = mesh.triangles.iter().fold(Rational::new(), |sum, t| {
                    let [a, b, c] = t.map(|v| level.crossing_between(mesh.vertices[v as usize]));
                    sum + six_volumes([&origin, &a, &b, &c])
                });
                let mut clipped = Rational::new();
                for cell in volume.cells() {
                    for t in decomposition.tetrahedra(cell) {
                        let whole = six_volumes(t.map(corner_point).each_ref());
                        let g = t.map(|c| volume.sample(volume.corner_index(cell, c)));
                        clipped += whole * share_below(g);
                    }
                }
                prop_assert_eq!(enclosed, clipped);
            }
        }
    }

    /// The share of a tetrahedron where the linear function with these corner values is negative, by cutting off
    /// the corners that are.
    fn share_below(mut g: [Rational; 4]) -> Rational {
        g.sort();
        let cut = |low: &Rational, high: &Rational| -low.clone() / Rational::from(high - low);
        let [a, b, c, d] = &g;
        match g.iter().filter(|x| **x < 0).count() {
            0 => Rational::new(),
            1 => cut(a, b) * cut(a, c) * cut(a, d),
            // A wedge with edges ab: three tetrahedra a, b, and the crossings of ac, ad, bc, bd.
            2 => {
                let (ac, ad, bc, bd) = (cut(a, c), cut(a, d), cut(b, c), cut(b, d));
                let one = Rational::from(1);
                // In coordinates with a the origin and b, c, d the unit vectors.
                let zero = Rational::new;
                let at_ac = [zero(), ac, zero()];
                let at_ad = [zero(), zero(), ad];
                let at_bc = [one.clone() - &bc, bc, zero()];
                let at_bd = [one.clone() - &bd, zero(), bd];
                let (origin, b) = ([zero(), zero(), zero()], [one, zero(), zero()]);
                [[&origin, &b, &at_bc, &at_bd], [&origin, &at_ac, &at_bc, &at_bd], [&origin, &at_ac, &at_ad, &at_bd]]
                    .into_iter()
                    .fold(Rational::new(), |sum, t| sum + six_volumes(t).abs())
            }
            3 => Rational::from(1) - cut(d, a).abs() * cut(d, b).abs() * cut(d, c).abs(),
            _ => Rational::from(1),
        }
    }
}

mod dependence {
    use super::*;

    fn trilinear(level: &Level) -> Vec<(i64, i64)> {
        topology(level).expect("no tie").components.iter().map(|c| (c.chi, c.boundary_loops)).collect()
    }

    /// The surfaces by trilinear interpolation, by Kuhn's tetrahedra and by five: (χ, boundary loops) each.
    fn surfaces(volume: &Volume) -> [Vec<(i64, i64)>; 3] {
        let level = Level { volume, isovalue: Rational::new(), tie: Tie::Degenerate };
        let of = |d| components(&extract(&level, d).expect("no tie"));
        [trilinear(&level), of(Decomposition::default()), of(Decomposition::Five)]
    }

    const CELL: [i32; 8] = [1, -2, -2, 1, -2, 1, -2, -2];

    #[test]
    fn eight_samples_have_three_topologies_by_three_interpolations() {
        // Corners 0, 3, 5 are diagonal to one another across three faces, on which the determinants separate them
        // and so do not join them inside. Kuhn's face diagonals from corner 0 join it to 3 and to 5. The five
        // tetrahedra join all three and cut corner 1 off from the other negative ones.
        let disks = |n: usize| vec![(1, 1); n];
        assert_eq!(surfaces(&volume([2, 2, 2], &CELL)), [disks(3), disks(1), disks(2)]);
    }

    #[test]
    fn in_a_frame_they_are_closed_and_five_tetrahedra_depend_on_where_the_cell_lies() {
        let spheres = |n: usize| vec![(2, 0); n];
        for (x, by_five) in [(1, spheres(3)), (2, spheres(1))] {
            let mut framed = vec![-2; 80];
            for (c, v) in CELL.into_iter().enumerate() {
                framed[x + c % 2 + 5 * (1 + c / 2 % 2) + 20 * (1 + c / 4)] = v;
            }
            assert_eq!(surfaces(&volume([5, 4, 4], &framed)), [spheres(3), spheres(1), by_five]);
        }
    }
}
