//! Numbers in and out: text, binary64, decimal strings.

use isoracle::number::binary::{from_f64, nearest_f32, nearest_f64, ulp_error, ulp_error_f32};
use isoracle::number::decimal::{DecimalEnclosure, Digits, MAX_DIGITS};
use isoracle::number::text::{MAX_CHARACTERS, NumberError, exact_text, json_number, parse};
use isoracle::number::{Integer, Rational};
use proptest::prelude::*;

fn q(p: i64, q: i64) -> Rational {
    Rational::from((p, q))
}

fn two_to(exponent: i32) -> Rational {
    let power = Rational::from(Integer::from(1) << exponent.unsigned_abs());
    if exponent < 0 { power.recip() } else { power }
}

/// A finite binary64 from its bits, by the definition of the format.
fn decoded(x: f64) -> Rational {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 52) & 0x7FF, bits & ((1 << 52) - 1));
    let m = if field == 0 { fraction } else { fraction + (1 << 52) };
    let exponent = i32::try_from(field.max(1)).expect("11 bits") - 1075;
    let magnitude = Rational::from(m) * two_to(exponent);
    if bits >> 63 == 1 { -magnitude } else { magnitude }
}

mod nu_1 {
    use super::*;

    #[test]
    fn a_nan_and_an_infinity_are_refused() {
        assert_eq!(from_f64(f64::NAN), Err(NumberError::NotANumber));
        assert_eq!(from_f64(f64::INFINITY), Err(NumberError::Infinite));
        assert_eq!(from_f64(f64::NEG_INFINITY), Err(NumberError::Infinite));
        assert_eq!(NumberError::NotANumber.to_string(), "NaN is not a number here");
    }

    #[test]
    fn the_ends_of_the_format_are_exact() {
        assert_eq!(from_f64(-0.0), Ok(q(0, 1)));
        assert_eq!(from_f64(0.1), Ok(q(3_602_879_701_896_397, 36_028_797_018_963_968)));
        assert_eq!(from_f64(5e-324), Ok(two_to(-1074)));
        assert_eq!(from_f64(f64::MIN_POSITIVE), Ok(two_to(-1022)));
        assert_eq!(from_f64(f64::MAX), Ok(two_to(1024) - two_to(971)));
    }

    proptest! {
        #[test]
        fn every_finite_binary64_is_its_decoded_dyadic_rational(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            prop_assert_eq!(from_f64(x), Ok(decoded(x)));
        }
    }
}

mod nu_2 {
    use super::*;

    #[test]
    fn every_written_form_is_exact() {
        let forms = [
            ("0", q(0, 1)),
            ("-0", q(0, 1)),
            ("-12", q(-12, 1)),
            ("+12", q(12, 1)),
            ("007", q(7, 1)),
            ("6/4", q(3, 2)),
            ("-6/4", q(-3, 2)),
            ("0.125", q(1, 8)),
            ("0.1", q(1, 10)),
            ("-1.50", q(-3, 2)),
            (".5", q(1, 2)),
            ("5.", q(5, 1)),
            ("1.5e-3", q(3, 2000)),
            ("1.5E+3", q(1500, 1)),
            ("-25e0", q(-25, 1)),
            ("0x1.8p-3", q(3, 16)),
            ("-0X1.8P-3", q(-3, 16)),
            ("0xfF", q(255, 1)),
            ("0x.8", q(1, 2)),
            ("0x1p+4", q(16, 1)),
            ("0x1e2", q(0x1e2, 1)),
            ("0x0.0000000000001p-1022", two_to(-1074)),
        ];
        for (text, value) in forms {
            assert_eq!(parse(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_refused_with_its_reason() {
        for text in ["nan", "-NaN", "+nan"] {
            assert_eq!(parse(text), Err(NumberError::NotANumber), "{text}");
        }
        for text in ["inf", "-Infinity", "INF"] {
            assert_eq!(parse(text), Err(NumberError::Infinite), "{text}");
        }
        assert_eq!(parse(""), Err(NumberError::Empty));
        assert_eq!(parse("1/0"), Err(NumberError::ZeroDenominator));
        assert_eq!(parse("-0/00"), Err(NumberError::ZeroDenominator));
        let malformed = [
            "-", "+-1", "--1", " 1", "1 ", "1_000", "1,5", ".", "e5", "1e", "1e+", "1e1.5", "1.2.3", "1/", "/2",
            "1/-2", "1/2/3", "1.5/2", "0x", "0x.", "0xg", "0x1p", "0x1p-", "0x1pf", "-0x-1", "1p3", "½", "٣", "x",
            "nano",
        ];
        for text in malformed {
            assert_eq!(parse(text), Err(NumberError::Malformed { beginning: text.to_string() }), "{text}");
        }
    }

    #[test]
    fn a_text_is_bounded_before_it_is_read() {
        let long = "1".repeat(MAX_CHARACTERS);
        assert!(parse(&long).is_ok());
        assert_eq!(parse(&format!("{long}1")), Err(NumberError::TooLong { characters: MAX_CHARACTERS + 1 }));
        assert_eq!(json_number(&format!("{long}1")), Err(NumberError::TooLong { characters: MAX_CHARACTERS + 1 }));
        for text in ["1e10001", "1e-10001", "0x1p10001", "1e99999999999999999999999999", "0e-9223372036854775808"] {
            assert_eq!(parse(text), Err(NumberError::ExponentTooLarge), "{text}");
        }
        assert_eq!(parse("0e-10000"), Ok(q(0, 1)));
        assert_eq!(parse("1e010000").map(|x| x.to_string().len()), Ok(10_001));
        let beginning = "x".repeat(40);
        assert_eq!(parse(&"x".repeat(1000)), Err(NumberError::Malformed { beginning }));
    }

    proptest! {
        #[test]
        fn a_quotient_of_integers_is_read_and_written(p: i64, d in 1..i64::MAX) {
            let value = q(p, d);
            prop_assert_eq!(parse(&format!("{p}/{d}")), Ok(value.clone()));
            prop_assert_eq!(parse(&exact_text(&value)), Ok(value.clone()));
            prop_assert_eq!(exact_text(&value).ends_with("/1"), false);
        }

        #[test]
        fn a_decimal_is_its_digits_over_a_power_of_ten(digits: u32, places in 0..9_usize, e in -30..30_i32) {
            let text = format!("{digits:0>10}");
            let (whole, fraction) = text.split_at(10 - places);
            let mut expected = Rational::from(digits);
            for _ in 0..(e - places as i32).abs() {
                if e < places as i32 { expected /= 10 } else { expected *= 10 }
            }
            prop_assert_eq!(parse(&format!("{whole}.{fraction}e{e}")), Ok(expected));
        }

        #[test]
        fn a_hexadecimal_float_is_the_binary64_that_it_spells(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let (field, fraction) = ((bits >> 52) & 0x7FF, bits & ((1 << 52) - 1));
            let (lead, exponent) = if field == 0 { (0, -1022) } else { (1, field as i64 - 1023) };
            let sign = if x.is_sign_negative() { "-" } else { "" };
            prop_assert_eq!(parse(&format!("{sign}0x{lead}.{fraction:013x}p{exponent}")), Ok(decoded(x)));
        }

        #[test]
        fn no_text_panics(text in "[-+0-9a-fxpieEn./ ]{0,12}") {
            let _ = (parse(&text), json_number(&text));
        }
    }
}

mod nu_3 {
    use super::*;

    #[test]
    fn an_integer_is_exact_and_any_other_number_is_its_nearest_binary64() {
        assert_eq!(json_number("9007199254740993"), Ok(q(9_007_199_254_740_993, 1)));
        assert_eq!(json_number("9007199254740993.0"), Ok(q(9_007_199_254_740_992, 1)));
        assert_eq!(json_number("-0"), Ok(q(0, 1)));
        assert_eq!(json_number("-0.0"), Ok(q(0, 1)));
        assert_eq!(json_number("0.1"), Ok(decoded(0.1)));
        assert_eq!(json_number("-1E2"), Ok(q(-100, 1)));
        assert_eq!(json_number("1e-20000"), Ok(q(0, 1)));
        assert_eq!(json_number("3e-324"), Ok(two_to(-1074)));
    }

    #[test]
    fn beyond_the_largest_binary64_is_an_error() {
        assert_eq!(json_number("1e309"), Err(NumberError::Overflow));
        assert_eq!(json_number("-1e99999"), Err(NumberError::Overflow));
        assert_eq!(json_number("1.7976931348623157e308"), Ok(decoded(f64::MAX)));
        let huge = format!("1{}", "0".repeat(400));
        assert_eq!(json_number(&huge), parse("1e400"), "an integer has no largest");
    }

    #[test]
    fn the_grammar_is_that_of_json() {
        for text in
            ["+1", "01", "-01.5", ".5", "5.", "1.e3", "1e", "0x10", "1/2", "NaN", "Infinity", " 1", "1e5f", "--1"]
        {
            assert_eq!(json_number(text), Err(NumberError::Malformed { beginning: text.to_string() }), "{text}");
        }
    }

    proptest! {
        #[test]
        fn it_is_the_exact_value_rounded_by_the_other_derivation(text in "-?(0|[1-9][0-9]{0,20})\\.[0-9]{1,20}e-?[0-9]{1,2}") {
            let exact = parse(&text).expect("the strategy writes decimals");
            prop_assert_eq!(json_number(&text), Ok(decoded(nearest_f64(&exact))));
        }
    }
}

mod nu_4 {
    use super::*;

    fn rounds_to(x: &Rational, expected: f64) {
        assert_eq!(nearest_f64(x).to_bits(), expected.to_bits(), "{x} ↦ {expected:e}");
    }

    #[test]
    fn known_values_round_to_nearest_even() {
        let (one, ulp) = (q(1, 1), two_to(-52));
        rounds_to(&q(0, 1), 0.0);
        rounds_to(&q(1, 10), 0.1);
        rounds_to(&q(1, 3), 1.0 / 3.0);
        rounds_to(&q(2, 3), 2.0 / 3.0);
        rounds_to(&q(-2, 3), -2.0 / 3.0);
        // Ties: 1 + ulp/2 goes down to the even 1, 1 + 3ulp/2 up to the even 1 + 2ulp.
        rounds_to(&(one.clone() + two_to(-53)), 1.0);
        rounds_to(&(one.clone() + two_to(-53) + two_to(-200)), 1.0 + f64::EPSILON);
        rounds_to(&(one.clone() + ulp * q(3, 2)), 1.0 + 2.0 * f64::EPSILON);
        rounds_to(&(one.clone() - two_to(-54)), 1.0);
        rounds_to(&(one - two_to(-54) - two_to(-200)), 1.0_f64.next_down());
        rounds_to(&q(9_007_199_254_740_993, 1), 9_007_199_254_740_992.0);
        rounds_to(&q(9_007_199_254_740_995, 1), 9_007_199_254_740_996.0);
    }

    #[test]
    fn subnormals_and_the_way_to_infinity() {
        let tiny = two_to(-1074);
        rounds_to(&tiny, 5e-324);
        rounds_to(&two_to(-1075), 0.0);
        rounds_to(&-two_to(-1075), -0.0);
        rounds_to(&(two_to(-1075) + two_to(-1200)), 5e-324);
        rounds_to(&(tiny.clone() * q(3, 2)), 1e-323);
        rounds_to(&two_to(-5000), 0.0);
        rounds_to(&two_to(-1022), f64::MIN_POSITIVE);
        rounds_to(&(two_to(-1022) - two_to(-1075)), f64::MIN_POSITIVE);
        rounds_to(&(two_to(-1022) - tiny), f64::MIN_POSITIVE.next_down());
        let largest = two_to(1024) - two_to(971);
        rounds_to(&largest, f64::MAX);
        rounds_to(&(largest.clone() + two_to(970) - two_to(0)), f64::MAX);
        rounds_to(&(largest.clone() + two_to(970)), f64::INFINITY);
        rounds_to(&-(largest + two_to(970)), f64::NEG_INFINITY);
        rounds_to(&two_to(1024), f64::INFINITY);
        rounds_to(&two_to(9999), f64::INFINITY);
    }

    #[test]
    fn binary32_is_rounded_once() {
        // Just above the midpoint of 1 and 1 + 2⁻²³: by way of binary64 it would become the midpoint, then 1.
        let x = q(1, 1) + two_to(-24) + two_to(-60);
        assert_eq!(nearest_f64(&x) as f32, 1.0);
        assert_eq!(nearest_f32(&x), 1.0 + f32::EPSILON);
        assert_eq!(nearest_f32(&two_to(-150)), 0.0);
        assert_eq!(nearest_f32(&(two_to(-150) + two_to(-300))), f32::from_bits(1));
        assert_eq!(nearest_f32(&(two_to(128) - two_to(103))), f32::INFINITY);
        assert_eq!(nearest_f32(&(two_to(128) - two_to(103) - q(1, 1))), f32::MAX);
        assert_eq!(nearest_f32(&-two_to(900)), f32::NEG_INFINITY);
    }

    /// Decimal texts that are exactly a binary64, the midpoint of two, or a hair off it.
    fn near_midpoint() -> impl Strategy<Value = Rational> {
        let low_bits = prop_oneof![any::<u64>(), 0..20_u64, (0..20_u64).prop_map(|n| (1 << 52) - 10 + n)];
        (low_bits, -1..=1_i32, 1060..1200_i32).prop_filter_map("finite", |(bits, hair, depth)| {
            let x = f64::from_bits(bits & !(1 << 63));
            (x < f64::MAX).then(|| (decoded(x) + decoded(x.next_up())) / 2_u32 + two_to(-depth - 20) * hair)
        })
    }

    proptest! {
        #[test]
        fn it_agrees_with_the_standard_library_on_midpoints(x in near_midpoint()) {
            // A dyadic rational n/2^k is the decimal n·5^k/10^k.
            let k = x.denom().significant_bits() - 1;
            let n = x.numer().clone() * rug::ops::Pow::pow(Integer::from(5), k);
            let theirs: f64 = format!("{n}e-{k}").parse().expect("a decimal");
            prop_assert_eq!(nearest_f64(&x).to_bits(), theirs.to_bits());
            let theirs: f32 = format!("{n}e-{k}").parse().expect("a decimal");
            prop_assert_eq!(nearest_f32(&x).to_bits(), theirs.to_bits());
        }

        #[test]
        fn it_agrees_with_the_standard_library_on_decimals(text in "-?[0-9]{1,25}\\.[0-9]{1,25}e-?(3[0-4]|[0-9])[0-9]") {
            let x = parse(&text).expect("the strategy writes decimals");
            let (theirs, narrow): (f64, f32) = (text.parse().expect("a decimal"), text.parse().expect("a decimal"));
            prop_assert_eq!(nearest_f64(&x), theirs);
            prop_assert_eq!(nearest_f32(&x), narrow);
        }

        #[test]
        fn it_is_a_left_inverse_of_the_exact_value(bits: u64, narrow: u32) {
            let (x, y) = (f64::from_bits(bits), f32::from_bits(narrow));
            prop_assume!(x.is_finite() && y.is_finite());
            prop_assert_eq!(nearest_f64(&decoded(x)), x);
            prop_assert_eq!(nearest_f32(&decoded(f64::from(y))), y);
        }
    }
}

mod nu_5 {
    use super::*;

    fn strings(x: &Rational, digits: u32) -> (String, String) {
        let enclosure = DecimalEnclosure::of(x, Digits::new(digits).expect("few digits"));
        (enclosure.lo, enclosure.hi)
    }

    #[test]
    fn the_lower_end_is_rounded_down_and_the_upper_one_up() {
        assert_eq!(strings(&q(2, 3), 3), ("0.6666".into(), "0.6667".into()));
        assert_eq!(strings(&q(-2, 3), 3), ("-0.6667".into(), "-0.6666".into()));
        assert_eq!(strings(&q(1, 2), 3), ("0.5000".into(), "0.5000".into()));
        assert_eq!(strings(&q(-1, 30_000), 3), ("-0.0001".into(), "0.0000".into()));
        assert_eq!(strings(&q(2000, 3), 3), ("666.66".into(), "666.67".into()));
        assert_eq!(strings(&q(1_000_000_001, 3), 3), ("333333333".into(), "333333334".into()));
        assert_eq!(strings(&q(0, 1), 0), ("0.0".into(), "0.0".into()));
    }

    #[test]
    fn bounds_too_far_apart_are_refused() {
        let digits = Digits::new(3).expect("few digits");
        let around = |lo: Rational, hi: Rational| DecimalEnclosure::around(&lo, &hi, digits);
        assert!(around(q(0, 1), q(1, 1000)).is_some());
        assert!(around(q(0, 1), q(11, 10_000)).is_none());
        assert!(around(q(1000, 1), q(1001, 1)).is_some());
        assert!(around(q(-1000, 1), q(-999, 1)).is_none());
        assert!(around(q(1, 1), q(0, 1)).is_none(), "no number lies between");
        assert_eq!(Digits::default().count(), 30);
        assert_eq!(Digits::new(MAX_DIGITS + 1), Err(NumberError::TooManyDigits { digits: MAX_DIGITS + 1 }));
    }

    proptest! {
        #[test]
        fn the_strings_enclose_within_the_promised_width(p: i64, d in 1..1_000_000_i64, digits in 0..40_u32, e in -20..40_i32) {
            let x = q(p, d) * parse(&format!("1e{e}")).expect("a power of ten");
            let (lo, hi) = strings(&x, digits);
            let (lo, hi) = (parse(&lo).expect("a decimal"), parse(&hi).expect("a decimal"));
            prop_assert!(lo <= x && x <= hi);
            let scale = x.abs().max(q(1, 1));
            let unit = parse(&format!("1e-{digits}")).expect("a power of ten");
            prop_assert!(hi - lo <= scale * unit);
        }

        #[test]
        fn eight_tenths_of_the_width_is_near_enough(p: i64, d in 1..1_000_000_i64, digits in 0..40_u32) {
            let lo = q(p, d);
            let room = q(8, 10) * parse(&format!("1e-{digits}")).expect("a power of ten");
            prop_assert!(DecimalEnclosure::around(&lo, &Rational::from(&lo + &room), Digits::new(digits).expect("few")).is_some());
        }
    }
}

mod nu_6 {
    use super::*;

    #[test]
    fn known_distances() {
        assert_eq!(ulp_error(1.0, &q(1, 1)), Ok(q(0, 1)));
        assert_eq!(ulp_error(1.0_f64.next_up(), &q(1, 1)), Ok(q(1, 1)));
        assert_eq!(ulp_error(1.0_f64.next_down(), &q(1, 1)), Ok(q(1, 2)), "the unit is that of 1, not of x");
        assert_eq!(ulp_error(5e-324, &q(0, 1)), Ok(q(1, 1)));
        assert_eq!(ulp_error(0.0, &two_to(-1076)), Ok(q(1, 4)));
        assert_eq!(ulp_error(f64::MAX, &two_to(1024)), Ok(q(1, 1)), "2¹⁰²⁴ has the largest unit, 2⁹⁷¹");
        assert_eq!(ulp_error(f64::MAX, &two_to(1025)), Ok(Rational::from(Integer::from(1) << 53) + 1));
        assert_eq!(ulp_error(f64::NAN, &q(0, 1)), Err(NumberError::NotANumber));
        assert_eq!(ulp_error(f64::INFINITY, &q(0, 1)), Err(NumberError::Infinite));
        assert_eq!(ulp_error_f32(1.0_f32.next_up(), &q(1, 1)), Ok(q(1, 1)));
        assert_eq!(ulp_error_f32(f32::MIN_POSITIVE, &q(0, 1)), Ok(Rational::from(1 << 23)));
        assert_eq!(ulp_error_f32(f32::NAN, &q(0, 1)), Err(NumberError::NotANumber));
    }

    #[test]
    fn half_a_unit_is_not_enough_next_below_a_power_of_two() {
        let y = q(1, 1) - two_to(-55);
        let neighbour = 1.0_f64.next_down();
        assert_eq!(nearest_f64(&y), 1.0);
        assert_eq!(ulp_error(neighbour, &y), Ok(q(3, 8)));
    }

    proptest! {
        #[test]
        fn a_correctly_rounded_value_is_within_half_a_unit_and_a_step_is_one(p: i64, d in 1..i64::MAX, e in -1100..900_i32) {
            let x = q(p, d) * two_to(e);
            let nearest = nearest_f64(&x);
            prop_assert!(ulp_error(nearest, &x).expect("finite") <= q(1, 2));
            let unit = decoded(nearest.abs().next_up()) - decoded(nearest.abs());
            prop_assert_eq!(ulp_error(1.5, &x), Ok((q(3, 2) - x).abs() / unit));
        }

        #[test]
        fn binary32_likewise(p: i32, d in 1..i32::MAX, e in -150..90_i32) {
            let x = q(p.into(), d.into()) * two_to(e);
            let nearest = nearest_f32(&x);
            prop_assert!(ulp_error_f32(nearest, &x).expect("finite") <= q(1, 2));
            let unit = decoded(f64::from(nearest.abs().next_up())) - decoded(f64::from(nearest.abs()));
            prop_assert_eq!(ulp_error_f32(1.5, &x), Ok((q(3, 2) - x).abs() / unit));
        }
    }
}
