//! Fundamental groups: three presentations of each, their abelianisations, and homomorphisms to small groups.

use crate::every_gluing::{dodecahedron, named, small_complexes};
use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::finite_group::FiniteGroup;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::presentation::{
    Letter, NoSuchGenerator, Presentation, Word, cyclically_reduced, freely_reduced, inverse,
};
use isoracle::complex::scheme::{GluingScheme, Polyhedron};
use isoracle::mesh::classify::ClosedSurface;
use isoracle::number::Integer;
use proptest::prelude::*;

/// A word in letters, capitals for inverses.
fn word(letters: &str) -> Word {
    let letter = |c: char| Letter::new(c.to_ascii_lowercase() as usize - 'a' as usize, c.is_ascii_lowercase());
    letters.chars().filter(|c| c.is_alphabetic()).map(letter).collect()
}

fn group(generators: usize, relators: &[&str]) -> Presentation {
    Presentation::new(generators, relators.iter().map(|r| word(r)).collect()).expect("letters of the alphabet")
}

fn complex(scheme: GluingScheme) -> ClosedComplex {
    ClosedComplex::new(scheme).unwrap_or_else(|defects| panic!("{defects:?}"))
}

fn manifold(scheme: GluingScheme) -> Manifold3 {
    Manifold3::new(scheme).unwrap_or_else(|defects| panic!("{defects:?}"))
}

/// H₁ of a complex as one group, the sum over its components.
fn h1(complex: &ClosedComplex) -> AbelianGroup {
    AbelianGroup::of_homology(&complex.chain_complex().homology(), 1)
}

fn abelian(rank: usize, torsion: &[u32]) -> AbelianGroup {
    AbelianGroup { rank, torsion: torsion.iter().map(|t| Integer::from(*t)).collect() }
}

/// The free product, whose abelianisation is the sum.
fn product(groups: &[Presentation]) -> Presentation {
    let (mut generators, mut relators) = (0, Vec::new());
    for group in groups {
        let moved = |letter: &Letter| Letter::new(letter.generator() + generators, letter.is_forward());
        let words: Vec<Word> = group.relators().iter().map(|word| word.iter().map(moved).collect()).collect();
        relators.extend(words);
        generators += group.generators();
    }
    Presentation::new(generators, relators).expect("moved together")
}

/// How many homomorphisms there are to S₃, S₄ and ℤ/6.
fn counts(group: &Presentation) -> [Integer; 3] {
    let simple = group.simplified();
    [FiniteGroup::symmetric(3), FiniteGroup::symmetric(4), FiniteGroup::cyclic(6)]
        .map(|g| simple.homomorphism_count(&g))
}

/// Every choice of images, one after the other.
fn count_plainly(group: &Presentation, permutations: &[Vec<usize>]) -> usize {
    let total = permutations.len().pow(group.generators() as u32);
    let is_homomorphism = |choice: usize| {
        let image = |g: usize| &permutations[choice / permutations.len().pow(g as u32) % permutations.len()];
        group.relators().iter().all(|word| {
            (0..permutations[0].len()).all(|point| {
                let step = |at: usize, letter: &Letter| match letter.is_forward() {
                    true => image(letter.generator())[at],
                    false => image(letter.generator()).iter().position(|i| *i == at).expect("a permutation"),
                };
                word.iter().fold(point, step) == point
            })
        })
    };
    (0..total).filter(|choice| is_homomorphism(*choice)).count()
}

/// The 6 permutations of three points.
fn s3() -> Vec<Vec<usize>> {
    (0..27).map(|n| vec![n / 9, n / 3 % 3, n % 3]).filter(|p| (0..3).all(|i| p.contains(&i))).collect()
}

fn a_word(generators: usize) -> impl Strategy<Value = Word> {
    prop::collection::vec((0..generators, any::<bool>()).prop_map(|(g, forward)| Letter::new(g, forward)), 0..8)
}

fn a_group() -> impl Strategy<Value = Presentation> {
    (1..4_usize).prop_flat_map(|n| {
        prop::collection::vec(a_word(n), 0..4)
            .prop_map(move |words| Presentation::new(n, words).expect("letters below n"))
    })
}

mod cx_74 {
    use super::*;

    #[test]
    fn known_groups() {
        let torus = complex(three_torus()).fundamental_groups();
        assert_eq!(torus.len(), 1);
        assert_eq!((torus[0].generators(), torus[0].relators().len()), (3, 3));
        assert_eq!(torus[0].simplified().to_string(), "⟨a, b, c | a b A B, a c A C, b c B C⟩");
        for (p, q) in [(1, 0), (2, 1), (5, 2), (6, 1)] {
            let lens = complex(lens_space(p, q)).fundamental_groups();
            let power = vec!["a"; p as usize].join(" ");
            let expected = if p == 1 { "⟨⟩".to_owned() } else { format!("⟨a | {power}⟩") };
            assert_eq!(lens[0].simplified().to_string(), expected);
        }
    }

    #[test]
    fn one_group_a_component() {
        let (_, both) = named().into_iter().find(|(name, _)| *name == "T³ and L(3,1)").expect("it is there");
        let abelianised: Vec<AbelianGroup> =
            both.fundamental_groups().iter().map(Presentation::abelianisation).collect();
        assert_eq!(abelianised, [abelian(3, &[]), abelian(0, &[3])]);
    }

    #[test]
    fn cells_tetrahedra_and_subdivision_have_one_group() {
        let complexes = named().into_iter().map(|(_, complex)| complex).chain(small_complexes(401));
        for complex in complexes {
            let groups = complex.fundamental_groups();
            let of_tetrahedra = complex.tetrahedra().fundamental_groups().expect("directed");
            let of_flags = complex.barycentric().fundamental_groups().expect("directed");
            assert_eq!([groups.len(), of_tetrahedra.len()], [of_flags.len(); 2]);
            for ((a, b), c) in groups.iter().zip(&of_tetrahedra).zip(&of_flags) {
                let expected = counts(a);
                assert_eq!(counts(b), expected, "{a}");
                assert_eq!(counts(c), expected, "{a}");
            }
        }
    }

    #[test]
    fn the_poincare_sphere_has_a_perfect_group_that_is_not_trivial() {
        let sphere = manifold(dodecahedron(POINCARE));
        assert_eq!(sphere.counts(), [5, 10, 6, 1]);
        let group = &sphere.fundamental_groups()[0];
        assert!([h1(&sphere), group.abelianisation()].iter().all(|group| *group == abelian(0, &[])));
        // The binary icosahedral group leads onto A₅ in |Aut A₅| = 120 ways, and to 1.
        assert_eq!(group.simplified().homomorphism_count(&FiniteGroup::alternating(5)), 121);
        assert_eq!(group.simplified().homomorphism_count(&FiniteGroup::symmetric(4)), 1);
    }

    #[test]
    fn the_dodecahedral_spaces_differ_by_their_turn() {
        let found: Vec<AbelianGroup> =
            (0..5).filter_map(|turn| Some(h1(Manifold3::new(dodecahedron(turn)).ok()?.complex()))).collect();
        assert_eq!(found, [&[2][..], &[5, 5, 5], &[], &[], &[5, 5, 5]].map(|torsion| abelian(0, torsion)));
    }
}

/// The turn of a tenth: two fifths after the antipodal map, which is a half turn there.
const POINCARE: i64 = 2;

mod cx_75 {
    use super::*;

    #[test]
    fn the_dual_cells_present_the_same_group_of_a_manifold() {
        let mut seen = 0;
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(23)) {
            let Ok(manifold) = Manifold3::of(complex) else { continue };
            let (primal, dual) = (manifold.fundamental_groups(), manifold.dual_fundamental_groups());
            assert_eq!(primal.len(), dual.len());
            for (a, b) in primal.iter().zip(&dual) {
                assert_eq!(counts(a), counts(b), "{a} {b}");
                assert_eq!(a.abelianisation(), b.abelianisation());
            }
            seen += 1;
        }
        assert!(seen > 20);
    }

    #[test]
    fn off_a_vertex_with_a_klein_bottle_around_it_it_is_another_group() {
        let gieseking = complex(paired(Polyhedron::tetrahedron(), &[(0, 1, 2, 1), (2, 3, 0, 1)]));
        assert_eq!(gieseking.vertex_links(), [ClosedSurface::NonOrientable { crosscaps: 2 }]);
        let groups = [gieseking.fundamental_groups(), gieseking.fundamental_groups_off_vertices()];
        assert_eq!(groups.map(|groups| groups[0].simplified().to_string()), ["⟨⟩", "⟨a, b | a a b b A B⟩"]);
    }

    #[test]
    fn with_the_vertices_it_is_a_quotient() {
        let odd = small_complexes(23).into_iter().filter(|complex| Manifold3::of(complex.clone()).is_err());
        let mut differing = 0;
        for complex in odd {
            let (all, off) = (complex.fundamental_groups(), complex.fundamental_groups_off_vertices());
            // The group with the vertices is a quotient of the other one.
            for (all, off) in all.iter().zip(&off) {
                assert!(counts(all).iter().zip(counts(off)).all(|(all, off)| *all <= off));
                differing += usize::from(all.abelianisation() != off.abelianisation());
            }
        }
        assert!(differing > 20, "{differing}");
    }

    #[test]
    fn the_poincare_sphere_dually() {
        let dual = &manifold(dodecahedron(POINCARE)).dual_fundamental_groups()[0];
        assert_eq!((dual.generators(), dual.relators().len()), (6, 10));
        assert_eq!(dual.simplified().homomorphism_count(&FiniteGroup::alternating(5)), 121);
    }
}

mod cx_76 {
    use super::*;

    #[test]
    fn made_abelian_it_is_h1() {
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(5)) {
            assert_eq!(product(&complex.fundamental_groups()).abelianisation(), h1(&complex));
        }
    }

    #[test]
    fn made_abelian_from_tetrahedra_it_is_h1() {
        for complex in named().into_iter().map(|(_, complex)| complex).chain(small_complexes(97)) {
            for triangulation in [complex.tetrahedra(), complex.barycentric()] {
                let groups = triangulation.fundamental_groups().expect("directed");
                assert_eq!(product(&groups).abelianisation(), h1(&complex));
            }
        }
    }

    #[test]
    fn known_abelianisations() {
        assert_eq!(group(2, &["abAB"]).abelianisation(), abelian(2, &[]));
        assert_eq!(group(2, &["aabb"]).abelianisation(), abelian(1, &[2]));
        assert_eq!(group(2, &["aaaa", "bbbbbb"]).abelianisation(), abelian(0, &[2, 12]));
        assert_eq!(group(2, &["aaaa", "bbbbbb"]).abelianisation().to_string(), "ℤ/2 ⊕ ℤ/12");
        assert_eq!(group(3, &["aab"]).abelianisation().to_string(), "ℤ²");
        assert_eq!(group(1, &["a"]).abelianisation().to_string(), "0");
    }
}

mod cx_77 {
    use super::*;

    #[test]
    fn groups_have_their_orders() {
        let orders = [1, 2, 3, 4].map(|n| FiniteGroup::symmetric(n).order());
        assert_eq!(orders, [1, 2, 6, 24]);
        assert_eq!([1, 2, 3, 4, 5].map(|n| FiniteGroup::alternating(n).order()), [1, 1, 3, 12, 60]);
        assert_eq!([1, 2, 7].map(|n| FiniteGroup::cyclic(n).order()), [1, 2, 7]);
        assert_eq!(FiniteGroup::generated(3, &[vec![0, 0, 1]]), None);
        assert_eq!(FiniteGroup::generated(2, &[vec![0, 1, 2]]), None);
    }

    #[test]
    fn known_counts() {
        let s3 = FiniteGroup::symmetric(3);
        // Commuting pairs: the order times the number of conjugacy classes.
        assert_eq!(group(2, &["abAB"]).homomorphism_count(&s3), 18);
        assert_eq!(group(3, &[]).homomorphism_count(&s3), 216);
        assert_eq!(group(3, &["a"]).homomorphism_count(&s3), 36);
        assert_eq!(group(0, &[""]).homomorphism_count(&s3), 1);
        assert_eq!(group(1, &["aa"]).homomorphism_count(&s3), 4);
        // ⟨a, b | aa, bbb, abab⟩ is S₃: 6 automorphisms, 3 onto a subgroup of order 2, and 1.
        assert_eq!(group(2, &["aa", "bbb", "abab"]).homomorphism_count(&s3), 10);
    }

    proptest! {
        #[test]
        fn counting_by_trying_everything_is_the_same(group in a_group()) {
            prop_assert_eq!(group.homomorphism_count(&FiniteGroup::symmetric(3)), count_plainly(&group, &s3()));
        }

        #[test]
        fn cyclic_counts_are_those_of_the_abelianisation(group in a_group(), n in 1..8_usize) {
            // Hom(ℤ, ℤ/n) has n elements, Hom(ℤ/t, ℤ/n) has gcd(t, n).
            let abelian = group.abelianisation();
            let mut expected = Integer::from(n.pow(abelian.rank as u32));
            abelian.torsion.iter().for_each(|t| expected *= t.clone().gcd(&Integer::from(n)));
            prop_assert_eq!(group.homomorphism_count(&FiniteGroup::cyclic(n)), expected);
        }
    }
}

mod cx_78 {
    use super::*;

    #[test]
    fn words_are_reduced() {
        assert_eq!(freely_reduced(&word("abBAc")), word("c"));
        assert_eq!(freely_reduced(&word("abAaB")), word("a"));
        assert_eq!(cyclically_reduced(&word("abcBA")), word("c"));
        assert_eq!(cyclically_reduced(&word("abA")), word("b"));
        assert_eq!(cyclically_reduced(&word("aa")), word("aa"));
        assert_eq!(cyclically_reduced(&word("aA")), word(""));
        assert_eq!(inverse(&word("abC")), word("cBA"));
    }

    #[test]
    fn known_simplifications() {
        let simple = |n, relators: &[&str]| group(n, relators).simplified().to_string();
        assert_eq!(simple(2, &["ab"]), "⟨a⟩");
        assert_eq!(simple(2, &["aB", "bbb"]), "⟨a | a a a⟩");
        assert_eq!(simple(1, &["aA", ""]), "⟨a⟩");
        assert_eq!(simple(2, &["abAB", "bABa", "BAba", "baBA"]), "⟨a, b | a b A B⟩");
        assert_eq!(simple(3, &["abc", "cba"]), "⟨a, b | a b A B⟩");
        assert_eq!(simple(1, &["a", "aaaaa"]), "⟨⟩");
        assert_eq!(group(0, &[""]).to_string(), "⟨| 1⟩");
        assert_eq!(Presentation::new(27, vec![vec![Letter::new(26, false)]]).expect("27").relators().len(), 1);
        let many = Presentation::new(27, vec![vec![Letter::new(26, false), Letter::new(0, true)]]).expect("27");
        assert!(many.to_string().ends_with(", x27 | X27 x1⟩"));
    }

    #[test]
    fn a_letter_that_is_no_generator_is_told() {
        let error = Presentation::new(1, vec![word("a"), word("aB")]);
        assert_eq!(error, Err(NoSuchGenerator { relator: 1, generator: 1, generators: 1 }));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if crate::is_long() { 4096 } else { 256 }))]

        #[test]
        fn simplifying_keeps_the_group(group in a_group()) {
            let simple = group.simplified();
            prop_assert!(simple.letters() <= group.letters() && simple.generators() <= group.generators());
            prop_assert_eq!(simple.abelianisation(), group.abelianisation());
            let s3 = FiniteGroup::symmetric(3);
            prop_assert_eq!(simple.homomorphism_count(&s3), group.homomorphism_count(&s3));
            let s4 = FiniteGroup::symmetric(4);
            prop_assert_eq!(simple.homomorphism_count(&s4), group.homomorphism_count(&s4));
            prop_assert_eq!(simple.simplified(), simple);
        }

        #[test]
        fn reduction_keeps_the_element(word in a_word(3)) {
            let group = |word: Word| Presentation::new(3, vec![word]).expect("letters below 3");
            let s3 = FiniteGroup::symmetric(3);
            let expected = group(word.clone()).homomorphism_count(&s3);
            prop_assert_eq!(group(freely_reduced(&word)).homomorphism_count(&s3), expected.clone());
            let cyclic = cyclically_reduced(&word);
            prop_assert_eq!(group(cyclic.clone()).homomorphism_count(&s3), expected);
            let twice = [&cyclic[..], &cyclic].concat();
            prop_assert_eq!(freely_reduced(&twice), twice);
        }
    }
}
