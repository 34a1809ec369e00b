//! Random sequences of operators.

use super::small::by_homology;
use super::states::{KINDS, operators_of};
use super::words::{Words, applied};
use isoracle::mesh::euler_operators::{Boundary, Operator, construction, replay};
use proptest::prelude::*;

/// The kind of the next operator, mev, mef, kemr and kfmrh more often, and which of those allowed it is.
fn choices() -> impl Strategy<Value = Vec<(usize, usize)>> {
    let kind = prop_oneof![3 => Just(2usize), 3 => Just(4), 2 => Just(6), 2 => Just(8), 1 => 0..KINDS];
    prop::collection::vec((kind, any::<prop::sample::Index>().prop_map(|i| i.index(1 << 20))), 1..14)
}

/// The allowed operators of a kind.
fn allowed(b: &Boundary, kind: usize) -> Vec<Operator> {
    operators_of(b, kind).into_iter().filter(|operator| b.clone().apply(operator).is_ok()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn sequences_keep_everything_and_are_undone_to_nothing(choices in choices()) {
        let mut boundary = Boundary::new();
        let mut undone_by = Vec::new();
        for (kind, which) in choices {
            let operators = match allowed(&boundary, kind) {
                none if none.is_empty() => allowed(&boundary, 0),
                some => some,
            };
            let operator = &operators[which % operators.len()];
            let expected = applied(&boundary, operator);
            let before = boundary.clone();
            let inverse = boundary.apply(operator).expect("it is allowed");
            prop_assert_eq!(Some(Words::of(&boundary).sorted()), expected);
            prop_assert_eq!(boundary.defects(), []);
            prop_assert_eq!(boundary.tracked(), by_homology(&boundary));
            let mut back = boundary.clone();
            prop_assert_eq!(back.apply(&inverse), Ok(operator.clone()));
            prop_assert_eq!(&back, &before);
            undone_by.push(inverse);
        }
        prop_assert_eq!(replay(&construction(&boundary)), Ok(boundary.clone()));
        for inverse in undone_by.iter().rev() {
            boundary.apply(inverse).expect("it undoes what was done last");
        }
        prop_assert_eq!(boundary, Boundary::new());
    }
}
