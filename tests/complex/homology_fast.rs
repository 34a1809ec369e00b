//! The fast homology of triangulations against Smith's form of all their chains.

use crate::every_gluing::{
    beside, named, one_tetrahedron, random_triangulation, small_complexes, surface_times_circle,
};
use crate::subdivided::subdivided;
use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::lens_space;
use isoracle::complex::homology_fast::homology;
use isoracle::complex::kuhn_torus::kuhn_torus;
use isoracle::complex::relations::{Combination, Relations};
use isoracle::complex::triangulation::Triangulation;
use isoracle::mesh::homology::Homology;
use isoracle::number::Integer;
use proptest::prelude::*;

fn plain(triangulation: &Triangulation) -> Homology {
    triangulation.chain_complex().expect("no edge is reversed").homology()
}

fn lens(p: u32, q: u32) -> Triangulation {
    ClosedComplex::new(lens_space(p, q)).expect("a lens space").tetrahedra()
}

mod cx_79 {
    use super::*;

    #[test]
    fn it_is_that_of_all_chains_of_one_tetrahedron() {
        for triangulation in one_tetrahedron() {
            let fast = homology(&triangulation);
            assert_eq!(fast, triangulation.chain_complex().map(|chains| chains.homology()));
        }
        assert_eq!(homology(&Triangulation::new(Vec::new()).expect("nothing")).expect("nothing").betti, [0; 4]);
    }

    #[test]
    fn it_is_that_of_all_chains_of_small_complexes() {
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(11)) {
            let expected = complex.chain_complex().homology();
            assert_eq!(homology(&complex.tetrahedra()), Ok(expected.clone()));
            assert_eq!(homology(&complex.barycentric()), Ok(expected));
        }
    }

    #[test]
    fn it_is_that_of_the_grid() {
        for sizes in [[1, 1, 1], [1, 2, 3], [2, 2, 2], [3, 1, 1]] {
            let torus = kuhn_torus(sizes);
            let n: usize = sizes.iter().product();
            assert_eq!(torus.skeleton().counts, [n, 7 * n, 12 * n, 6 * n]);
            assert_eq!(homology(&torus), Ok(plain(&torus)));
        }
        let large = homology(&kuhn_torus([9, 7, 8])).expect("directed");
        assert_eq!((large.betti, large.torsion.concat()), (vec![1, 3, 3, 1], vec![]));
    }

    #[test]
    fn it_is_kept_by_subdivision() {
        for (p, q) in [(2, 1), (5, 2), (8, 3)] {
            let coarse = lens(p, q);
            let fine = subdivided(&subdivided(&coarse));
            assert_eq!(homology(&fine), Ok(plain(&coarse)));
        }
        let (_, klein) = named().into_iter().find(|(name, _)| *name == "Klein bottle × S¹").expect("it is there");
        assert_eq!(homology(&subdivided(&klein.barycentric())), Ok(klein.chain_complex().homology()));
    }

    #[test]
    fn many_generators_are_told_apart() {
        let space = ClosedComplex::new(surface_times_circle(5)).expect("a manifold");
        let homology = homology(&subdivided(&space.tetrahedra())).expect("directed");
        assert_eq!((homology.betti, homology.torsion.concat()), (vec![1, 11, 11, 1], vec![]));
    }

    #[test]
    fn torsion_adds_over_components() {
        let both = beside(&beside(&lens(4, 1), &lens(6, 1)), &lens(9, 2));
        let homology = homology(&both).expect("directed");
        assert_eq!(homology.torsion[1], [Integer::from(6), Integer::from(36)]);
        assert_eq!(homology.betti, [3, 0, 0, 3]);
        assert_eq!(homology, plain(&both));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if crate::is_long() { 20_000 } else { 512 }))]

        #[test]
        fn it_is_that_of_all_chains_of_random_triangulations(triangulation in random_triangulation(8)) {
            let expected = triangulation.chain_complex().map(|chains| chains.homology());
            prop_assert_eq!(homology(&triangulation), expected);
        }

        #[test]
        fn it_is_kept_by_subdivision_of_random_triangulations(triangulation in random_triangulation(3)) {
            if let Ok(coarse) = homology(&triangulation) {
                prop_assert_eq!(homology(&subdivided(&triangulation)), Ok(coarse));
            }
        }
    }
}

mod cx_80 {
    use super::*;

    /// Small coefficients, and some beyond 64 bits.
    fn relation(generators: u32) -> impl Strategy<Value = Vec<(u32, i64, bool)>> {
        prop::collection::vec((0..generators, -6_i64..=6, prop::bool::weighted(0.05)), 0..6)
    }

    fn combination(terms: &[(u32, i64, bool)]) -> Combination {
        let mut sum = Combination::new();
        for (generator, n, large) in terms {
            *sum.entry(*generator).or_default() += Integer::from(*n) << if *large { 80 } else { 0 };
        }
        sum
    }

    /// The element with these coefficients, by doubling.
    fn element(group: &mut Relations, generators: &[u32], sum: &Combination) -> u32 {
        let mut total = 0;
        for (generator, n) in sum {
            let mut power = generators[*generator as usize];
            if *n < 0 {
                power = Relations::negative(power);
            }
            let digits = n.clone().abs();
            for bit in 0..digits.significant_bits() {
                if digits.get_bit(bit) {
                    total = group.sum(total, power);
                }
                power = group.sum(power, power);
            }
        }
        total
    }

    proptest! {
        #[test]
        fn relations_told_one_by_one_make_the_same_group(
            relations in prop::collection::vec(relation(5), 0..7),
            late in 0..5_usize,
        ) {
            let mut group = Relations::new();
            let generators: Vec<u32> = (0..5).map(|_| group.generator()).collect();
            let rows: Vec<Combination> = relations.iter().map(|terms| combination(terms)).collect();
            for row in &rows {
                let sum = element(&mut group, &generators, row);
                group.tell(sum);
            }
            // What is known to be 0 changes nothing, nor does what was told before.
            for row in rows.iter().skip(late) {
                let sum = element(&mut group, &generators, row);
                group.tell(Relations::negative(sum));
            }
            let plain = rows.iter().map(|row| row.iter().map(|(g, n)| (*g as usize, n.clone())).collect()).collect();
            prop_assert_eq!(group.group(), AbelianGroup::of_relations(5, plain));
        }
    }

    #[test]
    fn elements_are_reduced_by_what_was_told() {
        let mut group = Relations::new();
        let [a, b] = [group.generator(), group.generator()];
        let twice = group.sum(a, a);
        let six = {
            let four = group.sum(twice, twice);
            group.sum(four, twice)
        };
        group.tell(six);
        group.tell(b);
        let five = {
            let four = group.sum(twice, twice);
            group.sum(four, a)
        };
        assert_eq!(group.sum(five, a), 0);
        assert_ne!(group.sum(twice, a), 0);
        assert_eq!(group.group(), AbelianGroup { rank: 0, torsion: vec![Integer::from(6)] });
        assert_eq!(Relations::negative(0), 0);
    }

    #[test]
    fn an_element_has_one_form_whichever_sign_was_told() {
        for turned in [false, true] {
            let mut group = Relations::new();
            let a = group.generator();
            let [twice, four, six] = [1, 2, 3].map(|n| {
                let two = group.sum(a, a);
                (1..n).fold(two, |sum, _| group.sum(sum, two))
            });
            group.tell(if turned { Relations::negative(six) } else { six });
            let minus = Relations::negative(a);
            assert_eq!(group.sum(minus, minus), four);
            assert_eq!(group.sum(four, four), twice);
        }
    }
}
