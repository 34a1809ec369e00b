//! What is refused, and why.

use super::{RULES, q};
use isoracle::number::text::NumberError;
use isoracle::number::{Integer, Rational};
use isoracle::spline::prefilter;
use isoracle::spline::signal::{Boundary, Signal, SignalError, check_shape};

mod sp_74 {
    use super::*;

    #[test]
    fn a_signal_has_at_least_two_samples_along_each_axis() {
        for boundary in RULES {
            for n in 0..2 {
                let values = vec![q(1, 1); n];
                assert_eq!(Signal::new([n], values, boundary), Err(SignalError::Side { axis: 0, n }));
            }
            assert_eq!(Signal::new([2, 1], vec![q(1, 1); 2], boundary), Err(SignalError::Side { axis: 1, n: 1 }));
            assert_eq!(Signal::new([2, 0, 3], Vec::new(), boundary), Err(SignalError::Side { axis: 1, n: 0 }));
        }
        // The period of one mirrored sample would be 0; that of two is 2.
        assert_eq!(Boundary::Mirror.period(1), 0);
        assert_eq!(Boundary::Mirror.period(2), 2);
        let message = SignalError::Side { axis: 0, n: 1 }.to_string();
        assert_eq!(message, "shape[0]: a signal needs at least 2 samples along each axis, found 1");
    }

    #[test]
    fn a_shape_is_filled() {
        let found = |n: usize| Signal::new([2, 3], vec![q(1, 1); n], Boundary::Mirror);
        for n in [0, 5, 7] {
            assert_eq!(found(n), Err(SignalError::Values { expected: 6, found: n }));
        }
        assert!(found(6).is_ok());
        assert_eq!(check_shape(&[usize::MAX, 2], 4), Err(SignalError::TooLarge));
    }

    #[test]
    fn two_samples_are_enough() {
        // [4 2; 2 4]/6 for either rule: c = (2g₀ − g₁, 2g₁ − g₀).
        for boundary in RULES {
            assert_eq!(prefilter::solve(&[q(5, 1), q(3, 2)], boundary), [q(17, 2), q(-2, 1)]);
        }
        for n in 0..2 {
            let line = vec![Rational::new(); n];
            assert!(std::panic::catch_unwind(|| prefilter::solve(&line, Boundary::Periodic)).is_err());
        }
    }
}

mod sp_75 {
    use super::*;

    #[test]
    fn binary64_are_taken_exactly() {
        let signal = Signal::of_f64s([2, 2], &[0.1, -0.0, 5e-324, 3.0], Boundary::Periodic).expect("finite");
        let tenth = Rational::from((Integer::from(3_602_879_701_896_397_i64), Integer::from(1) << 55));
        let least = Rational::from((Integer::from(1), Integer::from(1) << 1074));
        assert_eq!(signal.values(), [tenth, q(0, 1), least, q(3, 1)]);
        assert_ne!(signal.values()[0], q(1, 10));
    }

    #[test]
    fn what_is_no_number_is_named() {
        let of = |values: &[f64]| Signal::of_f64s([3], values, Boundary::Mirror);
        let nan = SignalError::Sample { index: 1, error: NumberError::NotANumber };
        assert_eq!(of(&[0.0, f64::NAN, f64::INFINITY]), Err(nan.clone()));
        assert!(nan.to_string().starts_with("values[1]: "));
        for infinite in [f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(of(&[0.0, 1.0, infinite]), Err(SignalError::Sample { index: 2, error: NumberError::Infinite }));
        }
        // The shape is looked at first.
        assert_eq!(of(&[f64::NAN]), Err(SignalError::Values { expected: 3, found: 1 }));
    }
}
