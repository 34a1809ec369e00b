//! What keeps closed 3-manifolds out of ℝ⁴.

use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::embedding::{R4Obstruction, r4_obstruction};
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::scheme::{GluingScheme, Polyhedron};
use isoracle::number::Integer;
use std::collections::BTreeMap;

fn is_double(torsion: &[Integer]) -> bool {
    AbelianGroup { rank: 0, torsion: torsion.to_vec() }.torsion_is_double()
}

fn manifold(scheme: GluingScheme) -> Manifold3 {
    Manifold3::new(scheme).unwrap_or_else(|defects| panic!("{defects:?}"))
}

/// The manifolds among the gluings of the cube whose faces are paired as numbered: opposite faces, or all 15 ways.
fn cubes(pairings: &[[usize; 6]]) -> Vec<Manifold3> {
    let glued = |order: &[usize; 6], code: i64| {
        let pair = |i: usize| {
            let code = code >> (3 * i) & 7;
            (order[2 * i], order[2 * i + 1], code & 3, if code & 4 == 0 { 1 } else { -1 })
        };
        Manifold3::new(paired(Polyhedron::cube(), &[pair(0), pair(1), pair(2)])).ok()
    };
    pairings.iter().flat_map(|order| (0..512).filter_map(move |code| glued(order, code))).collect()
}

/// The number of elements of order dividing n in ⊕ ℤ/tᵢ is Π gcd(n, tᵢ); in A ⊕ A it is a square, for every n.
fn counts_are_squares(torsion: &[Integer]) -> bool {
    let greatest = torsion.iter().max().map_or(1, |t| t.to_u32().expect("small"));
    (1..=greatest).all(|n| {
        let count = torsion.iter().fold(Integer::from(1), |count, t| count * Integer::from(t.gcd_u_ref(n)));
        count.is_perfect_square()
    })
}

/// Two schemes side by side.
fn beside(a: GluingScheme, b: GluingScheme) -> GluingScheme {
    let shift = a.polyhedra.len();
    let mut both = a;
    both.polyhedra.extend(b.polyhedra);
    both.pairings.extend(b.pairings.into_iter().map(|mut pairing| {
        pairing.a.polyhedron += shift;
        pairing.b.polyhedron += shift;
        pairing
    }));
    both
}

mod cx_89 {
    use super::*;

    /// "Quatro dimensões são suficientes para os complexos ditos orientáveis, mas outros podem exigir cinco."
    fn printed_four_suffice(manifold: &Manifold3) -> bool {
        manifold.is_orientable()
    }

    #[test]
    fn the_projective_space_is_orientable_and_does_not_lie_in_four_dimensions() {
        let projective = manifold(lens_space(2, 1));
        assert!(printed_four_suffice(&projective));
        let torsion = vec![Integer::from(2)];
        assert_eq!(r4_obstruction(&projective), Some(R4Obstruction::Torsion { polyhedron: 0, torsion }));
    }

    #[test]
    fn no_lens_space_but_the_sphere_lies_there() {
        for p in 2..=12_u32 {
            for q in (1..p).filter(|q| Integer::from(*q).gcd(&Integer::from(p)) == 1) {
                let lens = manifold(lens_space(p, q));
                let found = r4_obstruction(&lens);
                assert!(
                    matches!(&found, Some(R4Obstruction::Torsion { torsion, .. }) if torsion[..] == [p]),
                    "L({p}, {q})"
                );
            }
        }
        assert_eq!(r4_obstruction(&manifold(lens_space(1, 0))), None);
        assert_eq!(r4_obstruction(&manifold(three_torus())), None);
    }

    #[test]
    fn the_gluings_of_opposite_faces_of_the_cube() {
        let mut tally: BTreeMap<(bool, Vec<Integer>), usize> = BTreeMap::new();
        for cube in cubes(&[[0, 1, 2, 4, 3, 5]]) {
            let torsion = cube.chain_complex().homology().torsion.swap_remove(1);
            let expected = match (cube.is_orientable(), counts_are_squares(&torsion)) {
                (false, _) => Some(R4Obstruction::NonOrientable { polyhedron: 0 }),
                (true, true) => None,
                (true, false) => Some(R4Obstruction::Torsion { polyhedron: 0, torsion: torsion.clone() }),
            };
            assert_eq!(r4_obstruction(&cube), expected);
            *tally.entry((cube.is_orientable(), torsion)).or_default() += 1;
        }
        // Among them are the torus, and the quaternion space with ℤ/2 ⊕ ℤ/2, which lies in ℝ⁴.
        assert!(tally.contains_key(&(true, vec![])) && tally.contains_key(&(true, vec![Integer::from(2); 2])));
        assert!(tally.keys().any(|(orientable, _)| !orientable));
    }

    #[test]
    fn each_component_is_asked_by_itself() {
        // The torsion of both together is ℤ/2 ⊕ ℤ/2.
        let two = manifold(beside(lens_space(2, 1), lens_space(2, 1)));
        assert!(two.first_homology().torsion_is_double());
        assert!(matches!(r4_obstruction(&two), Some(R4Obstruction::Torsion { polyhedron: 0, .. })));
        let mixed = manifold(beside(three_torus(), lens_space(3, 1)));
        assert!(matches!(r4_obstruction(&mixed), Some(R4Obstruction::Torsion { polyhedron: 1, .. })));
        assert_eq!(r4_obstruction(&manifold(beside(three_torus(), three_torus()))), None);
    }
}

mod cx_91 {
    use super::*;

    /// The invariant factors of ⊕ ℤ/nᵢ: gcd and lcm in turn.
    fn invariant_factors(mut orders: Vec<Integer>) -> Vec<Integer> {
        for i in 0..orders.len() {
            for j in i + 1..orders.len() {
                let gcd = Integer::from(orders[i].gcd_ref(&orders[j]));
                let lcm = Integer::from(orders[i].lcm_ref(&orders[j]));
                (orders[i], orders[j]) = (gcd, lcm);
            }
        }
        orders.retain(|n| *n > 1);
        orders
    }

    #[test]
    fn a_group_is_a_double_iff_its_elements_of_each_order_say_so() {
        let mut doubles = 0;
        for code in 0..12_i64.pow(4) {
            let orders = (0..4).map(|i| Integer::from(code / 12_i64.pow(i) % 12 + 1)).collect();
            let torsion = invariant_factors(orders);
            assert_eq!(is_double(&torsion), counts_are_squares(&torsion), "{torsion:?}");
            doubles += usize::from(is_double(&torsion));
        }
        assert!(doubles > 100);
    }

    #[test]
    fn twice_a_group_is_a_double() {
        for (a, b) in (1..20).flat_map(|a| (1..20).map(move |b| (a, b))) {
            assert!(is_double(&invariant_factors([a, b, a, b].map(Integer::from).to_vec())));
        }
    }
}
