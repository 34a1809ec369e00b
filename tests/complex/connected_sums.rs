//! Connected sums and unions.

use super::naive_scheme::found;
use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::connected_sum::{connected_sum, disjoint_union};
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::scheme::Pairing;
use isoracle::complex::zoo;
use isoracle::number::Integer;

const NAMES: [&str; 12] =
    ["S3", "S3-zipped", "L(1,0)", "L(3,1)", "L(5,2)", "RP3", "quaternion-space", "T3", "S2~xS1", "Weeks", "G6", "KxS1"];

fn manifold(name: &str) -> Manifold3 {
    Manifold3::new(zoo::get(name).expect("a specimen").scheme).expect("the zoo holds manifolds")
}

fn group(rank: usize, torsion: &[u32]) -> AbelianGroup {
    AbelianGroup { rank, torsion: torsion.iter().copied().map(Integer::from).collect() }
}

mod cx_12 {
    use super::*;

    #[test]
    fn homology_adds_and_cells_are_as_many_as_stated() {
        for a in NAMES {
            for b in NAMES {
                let (m, n) = (manifold(a), manifold(b));
                let sum =
                    Manifold3::new(connected_sum(&m, &n)).unwrap_or_else(|defects| panic!("{a} # {b}: {defects:?}"));
                let [v, e, f, p]: [usize; 4] = std::array::from_fn(|k| m.counts()[k] + n.counts()[k]);
                assert_eq!(sum.counts(), [v - 1, e + 1, f + 2, p], "{a} # {b}");
                assert_eq!(sum.component_count(), 1, "{a} # {b}");
                assert_eq!(sum.first_homology(), m.first_homology().sum(&n.first_homology()), "{a} # {b}");
                assert_eq!(sum.is_orientable(), m.is_orientable() && n.is_orientable(), "{a} # {b}");
                let again = found(sum.scheme());
                assert!(again.is_manifold() && again.h1 == sum.first_homology(), "{a} # {b}");
            }
        }
    }

    #[test]
    fn homology_over_two_elements_adds_too() {
        for (a, b) in [("RP3", "KxS1"), ("G6", "L(3,1)"), ("T3", "quaternion-space")] {
            let (m, n) = (manifold(a), manifold(b));
            let sum = Manifold3::new(connected_sum(&m, &n)).expect("a manifold");
            let of = |m: &Manifold3| m.chain_complex().betti_mod_2();
            assert_eq!(of(&sum)[1], of(&m)[1] + of(&n)[1]);
        }
    }

    #[test]
    fn first_polyhedra_keep_their_orientations() {
        for a in NAMES {
            for b in NAMES {
                let (m, n) = (manifold(a), manifold(b));
                if !m.is_orientable() || !n.is_orientable() {
                    continue;
                }
                let sum = connected_sum(&m, &n);
                // Polyhedra that pairings with dir −1 join are seen alike, those that dir 1 joins are not.
                let mut seen = vec![None; sum.polyhedra.len()];
                seen[m.scheme().pairings[0].a.polyhedron] = Some(true);
                while seen.contains(&None) {
                    for Pairing { a, b, dir, .. } in &sum.pairings {
                        let alike = |side: bool| side == (*dir == -1);
                        match (seen[a.polyhedron], seen[b.polyhedron]) {
                            (Some(side), None) => seen[b.polyhedron] = Some(alike(side)),
                            (None, Some(side)) => seen[a.polyhedron] = Some(alike(side)),
                            (Some(x), Some(y)) => assert_eq!(alike(x), y, "{a} # {b}"),
                            (None, None) => {}
                        }
                    }
                }
                let other = m.scheme().polyhedra.len() + n.scheme().pairings[0].a.polyhedron;
                assert_eq!(seen[other], Some(true), "{a} # {b}");
            }
        }
    }

    #[test]
    fn a_pairing_along_the_walks_is_slit_too() {
        // One polyhedron of T³ seen from inside: its pairings with the other one run along the walks.
        let mut turned = zoo::get("S3").expect("a specimen").scheme;
        for face in &mut turned.polyhedra[1].faces {
            face.reverse();
            face.iter_mut().for_each(|side| side.0 = -side.0);
        }
        turned.pairings.iter_mut().for_each(|pairing| pairing.dir = -1);
        let turned = Manifold3::new(turned).expect("a sphere");
        let sum = Manifold3::new(connected_sum(&turned, &manifold("L(5,2)"))).expect("a manifold");
        assert_eq!((sum.first_homology(), sum.is_orientable()), (group(0, &[5]), true));
    }

    #[test]
    fn in_a_union_the_first_component_takes_part() {
        let both = zoo::get("T3+RP3").expect("a specimen").scheme;
        let sum = connected_sum(&Manifold3::new(both).expect("a manifold"), &manifold("L(3,1)"));
        let sum = Manifold3::new(sum).expect("a manifold");
        assert_eq!((sum.component_count(), sum.first_homology()), (2, group(3, &[6])));
    }
}

#[test]
fn in_a_union_everything_adds() {
    for (a, b) in [("T3", "RP3"), ("S3-24-cell", "KxS1"), ("L(3,1)", "L(3,2)")] {
        let (m, n) = (manifold(a), manifold(b));
        let union = Manifold3::new(disjoint_union(m.scheme(), n.scheme())).expect("a manifold");
        assert_eq!(union.counts(), std::array::from_fn(|k| m.counts()[k] + n.counts()[k]));
        assert_eq!(union.component_count(), 2);
        assert_eq!(union.first_homology(), m.first_homology().sum(&n.first_homology()));
    }
}

#[test]
fn groups_are_added_and_written() {
    assert_eq!(group(1, &[2, 4]).sum(&group(2, &[3, 6])), group(3, &[2, 6, 12]));
    assert_eq!(group(0, &[2]).sum(&group(0, &[3])), group(0, &[6]));
    assert_eq!(group(0, &[2]).sum(&group(0, &[])), group(0, &[2]));
    let words = [(0, &[][..]), (1, &[]), (0, &[5, 10]), (2, &[2]), (13, &[]), (456, &[]), (7890, &[])];
    let words = words.map(|(rank, torsion)| group(rank, torsion).to_string());
    assert_eq!(words, ["0", "ℤ", "ℤ/5 ⊕ ℤ/10", "ℤ² ⊕ ℤ/2", "ℤ¹³", "ℤ⁴⁵⁶", "ℤ⁷⁸⁹⁰"]);
}
