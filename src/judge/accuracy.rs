//! How far the plain numbers of answers are from the true ones, gathered into histograms.
//!
//! A plain JSON number x that stands for the real y is measured twice, exactly: the error is that against y, not against a rounding of y.
//! Component-wise, it is |x − y| in units of the last place of the binary64 that is nearest to y ([`crate::number::binary::ulp_error`]).
//! Normwise, it is |x − y| in units of 2⁻⁵²·M, where M is the largest absolute value of the list that y belongs to (what that is
//! for each field stands at [`super::numbers::compare`]), but never in a unit below 2⁻¹⁰⁷⁴, the least binary64. So a correctly
//! rounded number is at most 1/2 off either way.

use super::report::grouped;
use serde::Serialize;
use serde_json::Value;

/// The bucket of errors above 2⁵² units: no digit is right. Bucket i below it holds the errors up to 2^(i−1), and above those of the
/// bucket before it.
pub const ALL_DIGITS_WRONG: usize = 54;

/// An error in some unit, and its bucket, which is decided exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnitude {
    /// 0, for at most 1/2, to [`ALL_DIGITS_WRONG`].
    pub bucket: usize,
    /// The error, rounded; the largest binary64 stands for all that is beyond.
    pub units: f64,
}

/// One plain number of an answer.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Where it stands in the answer: "gradient\[1]".
    pub field: String,
    /// The truth.
    pub expected: String,
    /// The number.
    pub found: String,
    /// Its error in units of the last place.
    pub componentwise: Magnitude,
    /// Its error in units of 2⁻⁵² of the largest of its list.
    pub normwise: Magnitude,
}

/// The errors of an operation's plain numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Accuracy {
    /// The operation: "spline.coefficients".
    pub operation: String,
    /// In units of the last place of the true number.
    pub componentwise: Histogram,
    /// In units of 2⁻⁵² of the largest of the number's list.
    pub normwise: Histogram,
}

/// How many numbers are how far off.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Histogram {
    /// How many numbers were measured.
    pub numbers: usize,
    /// How many of them are at most 1/2 off.
    pub correctly_rounded: usize,
    /// The buckets, up to the last one that is not empty.
    pub buckets: Vec<Bucket>,
    /// The number that is farthest off.
    pub worst: Option<Worst>,
}

/// The numbers whose errors lie between the bound of the bucket before and this one's.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Bucket {
    /// The largest error: "1/2", "1", "2", "4", … "4503599627370496", and "all digits wrong" beyond.
    pub up_to: String,
    /// How many numbers.
    pub count: usize,
}

/// The number that is farthest off.
#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    /// Its error.
    pub units: f64,
    /// Where it stands in the answer.
    pub field: String,
    /// The truth.
    pub expected: String,
    /// The number.
    pub found: String,
    /// The question, as `--question` takes it.
    pub question: Value,
}

impl Accuracy {
    /// Of an operation, before any number.
    pub fn new(operation: &str) -> Accuracy {
        let operation = operation.to_owned();
        Accuracy { operation, componentwise: Histogram::default(), normwise: Histogram::default() }
    }

    /// Takes up a number of the answer to a question.
    pub fn note(&mut self, measured: &Measured, question: impl Fn() -> Value) {
        self.componentwise.note(measured.componentwise, measured, &question);
        self.normwise.note(measured.normwise, measured, &question);
    }
}

impl Histogram {
    fn note(&mut self, error: Magnitude, measured: &Measured, question: impl Fn() -> Value) {
        self.numbers += 1;
        self.correctly_rounded += usize::from(error.bucket == 0);
        while self.buckets.len() <= error.bucket {
            self.buckets.push(Bucket { up_to: bound(self.buckets.len()), count: 0 });
        }
        self.buckets[error.bucket].count += 1;
        if self.worst.as_ref().is_none_or(|worst| error.units > worst.units) {
            let Measured { field, expected, found, .. } = measured.clone();
            self.worst = Some(Worst { units: error.units, field, expected, found, question: question() });
        }
    }

    /// How many numbers are in the buckets from one to another, the latter not included.
    pub fn between(&self, from: usize, to: usize) -> usize {
        self.buckets.iter().take(to).skip(from).map(|bucket| bucket.count).sum()
    }

    /// The share of correctly rounded numbers in percent, rounded down to a tenth: "100" only where all are; "–" of none.
    pub fn share_correctly_rounded(&self) -> String {
        super::report::percent(self.correctly_rounded, self.numbers)
    }
}

/// The largest error of a bucket.
fn bound(bucket: usize) -> String {
    match bucket {
        0 => "1/2".to_owned(),
        ALL_DIGITS_WRONG => "all digits wrong".to_owned(),
        i => (1_u64 << (i - 1)).to_string(),
    }
}

/// The same, short: "½", "8", "2^20".
pub fn short_bound(bucket: usize) -> String {
    match bucket {
        0 => "½".to_owned(),
        i @ 1..=10 => (1_u64 << (i - 1)).to_string(),
        ALL_DIGITS_WRONG => "more".to_owned(),
        i => format!("2^{}", i - 1),
    }
}

/// An error for reading: three digits, or the whole number, or a power of ten.
pub fn short_units(units: f64) -> String {
    match units {
        u if u >= 1e6 => format!("{u:.1e}"),
        u if u >= 100.0 => grouped(u.round() as usize),
        u => format!("{u:.3}"),
    }
}
