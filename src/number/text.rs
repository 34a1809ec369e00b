//! Numbers as text: every number form of the protocol, read exactly.

use super::binary;
use super::{Integer, Rational};
use rug::ops::Pow;
use thiserror::Error;

/// The most characters that the text of a number may have.
pub const MAX_CHARACTERS: usize = 100_000;

/// The largest absolute value of a written exponent, of ten as of two.
pub const MAX_EXPONENT: u32 = 10_000;

/// Why a text, or a binary64, is not a number here.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NumberError {
    /// The text is empty.
    #[error("an empty text is not a number")]
    Empty,
    /// A NaN.
    #[error("NaN is not a number here")]
    NotANumber,
    /// An infinity.
    #[error("an infinity is not a number here")]
    Infinite,
    /// p/0.
    #[error("the denominator is zero")]
    ZeroDenominator,
    /// The text is longer than [`MAX_CHARACTERS`].
    #[error("{characters} characters: a number may have at most {MAX_CHARACTERS}")]
    TooLong {
        /// Its length in bytes.
        characters: usize,
    },
    /// The written exponent is beyond ±[`MAX_EXPONENT`].
    #[error("the exponent is beyond ±{MAX_EXPONENT}")]
    ExponentTooLarge,
    /// The JSON number is nearer to 2¹⁰²⁴ than to any binary64.
    #[error("the number is beyond the largest binary64")]
    Overflow,
    /// More decimal digits are wanted than [`MAX_DIGITS`](super::decimal::MAX_DIGITS).
    #[error("{digits} digits: at most {} can be asked for", super::decimal::MAX_DIGITS)]
    TooManyDigits {
        /// How many are wanted.
        digits: u32,
    },
    /// None of the written forms.
    #[error("`{beginning}` is not a number")]
    Malformed {
        /// The text, or its first 40 characters.
        beginning: String,
    },
}

/// The exact value of a written number.
///
/// | form | value |
/// |---|---|
/// | `-12` | the integer |
/// | `p/q` | the quotient of two integers; the sign stands before p |
/// | `0.125`, `-1.5e-7` | the decimal itself, not its nearest binary64 |
/// | `0x1.8p-3` | C99 hexadecimal: hexadecimal digits, times a power of two |
///
/// A leading `+`, upper case, `5.` and `.5` are accepted; spaces and `_` are not. NU-2.
///
/// # Errors
/// Every variant of [`NumberError`] but `Overflow` and `TooManyDigits`. Length and exponent are checked
/// before anything is allocated.
#[doc(alias = "NU-2")]
pub fn parse(text: &str) -> Result<Rational, NumberError> {
    check_length(text)?;
    let magnitude = text.strip_prefix(['-', '+']).unwrap_or(text);
    let value = if magnitude.eq_ignore_ascii_case("nan") {
        Err(NumberError::NotANumber)
    } else if magnitude.eq_ignore_ascii_case("inf") || magnitude.eq_ignore_ascii_case("infinity") {
        Err(NumberError::Infinite)
    } else if let Some(hexadecimal) = magnitude.strip_prefix("0x").or_else(|| magnitude.strip_prefix("0X")) {
        positional(hexadecimal, &HEXADECIMAL, text)
    } else if let Some((p, q)) = magnitude.split_once('/') {
        quotient(p, q, text)
    } else {
        positional(magnitude, &DECIMAL, text)
    }?;
    Ok(if text.starts_with('-') { -value } else { value })
}

/// The value of a JSON number, given by its text: an integer (no point, no exponent) is exact; any other
/// number means the binary64 nearest to it, ties to even, taken exactly. NU-3.
///
/// # Errors
/// `Empty`, `TooLong`, `Malformed` where the text is not a JSON number, and `Overflow` where the nearest
/// binary64 would be infinite.
#[doc(alias = "NU-3")]
pub fn json_number(text: &str) -> Result<Rational, NumberError> {
    check_length(text)?;
    let magnitude = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = split_at_mark(magnitude, 'e');
    let (whole, fraction) = split_at_point(mantissa);
    let whole_is_json = whole == "0" || (is_digits(whole, 10) && !whole.starts_with('0'));
    let exponent_is_json = exponent.is_none_or(|e| is_digits(e.strip_prefix(['-', '+']).unwrap_or(e), 10));
    if !(whole_is_json && fraction.is_none_or(|f| is_digits(f, 10)) && exponent_is_json) {
        return Err(malformed(text));
    }
    match (fraction, exponent) {
        (None, None) => {
            let n = Rational::from(integer(whole, 10));
            Ok(if text.starts_with('-') { -n } else { n })
        }
        _ => {
            // The standard library's parser rounds to nearest even; it reads every JSON number.
            let nearest: f64 = text.parse().map_err(|_| malformed(text))?;
            binary::from_f64(nearest).map_err(|_| NumberError::Overflow)
        }
    }
}

/// A rational in lowest terms: `p/q`, or `p` where q = 1.
pub fn exact_text(x: &Rational) -> String {
    x.to_string()
}

/// A positional notation.
struct Notation {
    radix: i32,
    exponent_mark: char,
    /// What the exponent is an exponent of, and which power of it a digit is worth.
    base: u32,
    exponents_a_digit: i64,
}

const DECIMAL: Notation = Notation { radix: 10, exponent_mark: 'e', base: 10, exponents_a_digit: 1 };
const HEXADECIMAL: Notation = Notation { radix: 16, exponent_mark: 'p', base: 2, exponents_a_digit: 4 };

fn positional(magnitude: &str, notation: &Notation, text: &str) -> Result<Rational, NumberError> {
    let (mantissa, exponent) = split_at_mark(magnitude, notation.exponent_mark);
    let (whole, fraction) = split_at_point(mantissa);
    let fraction = fraction.unwrap_or("");
    let digits = format!("{whole}{fraction}");
    if !is_digits(&digits, notation.radix) {
        return Err(malformed(text));
    }
    let exponent = match exponent {
        None => 0,
        Some(e) => parse_exponent(e, text)?,
    };
    let fraction_digits = i64::try_from(fraction.len()).expect("a text's length is limited");
    let scale = exponent - notation.exponents_a_digit * fraction_digits;
    let power =
        Integer::from(notation.base).pow(u32::try_from(scale.unsigned_abs()).expect("length and exponent are limited"));
    let mantissa = Rational::from(integer(&digits, notation.radix));
    Ok(if scale < 0 { mantissa / power } else { mantissa * power })
}

fn parse_exponent(exponent: &str, text: &str) -> Result<i64, NumberError> {
    let digits = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    if !is_digits(digits, 10) {
        return Err(malformed(text));
    }
    // Digits that overflow an i64 are digits of a number beyond the limit.
    match digits.parse::<i64>() {
        Ok(e) if e <= i64::from(MAX_EXPONENT) => Ok(if exponent.starts_with('-') { -e } else { e }),
        Ok(_) | Err(_) => Err(NumberError::ExponentTooLarge),
    }
}

fn quotient(p: &str, q: &str, text: &str) -> Result<Rational, NumberError> {
    if !is_digits(p, 10) || !is_digits(q, 10) {
        return Err(malformed(text));
    }
    let (p, q) = (integer(p, 10), integer(q, 10));
    if q.is_zero() { Err(NumberError::ZeroDenominator) } else { Ok(Rational::from((p, q))) }
}

fn check_length(text: &str) -> Result<(), NumberError> {
    match text.len() {
        0 => Err(NumberError::Empty),
        characters if characters > MAX_CHARACTERS => Err(NumberError::TooLong { characters }),
        _ => Ok(()),
    }
}

fn split_at_mark(magnitude: &str, mark: char) -> (&str, Option<&str>) {
    match magnitude.split_once([mark, mark.to_ascii_uppercase()]) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (magnitude, None),
    }
}

fn split_at_point(mantissa: &str) -> (&str, Option<&str>) {
    match mantissa.split_once('.') {
        Some((whole, fraction)) => (whole, Some(fraction)),
        None => (mantissa, None),
    }
}

/// At least one character, and all of them digits.
fn is_digits(text: &str, radix: i32) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_digit(radix.unsigned_abs()))
}

fn integer(digits: &str, radix: i32) -> Integer {
    Integer::from_str_radix(digits, radix).expect("only digits are passed")
}

fn malformed(text: &str) -> NumberError {
    NumberError::Malformed { beginning: text.chars().take(40).collect() }
}
