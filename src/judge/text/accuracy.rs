//! The errors of plain numbers for a terminal: a line for each operation and unit.

use super::Ink;
use crate::judge::accuracy::{ALL_DIGITS_WRONG, Accuracy, Histogram, short_bound, short_units};

/// The last buckets of the columns after the first.
const COLUMNS: [usize; 6] = [1, 3, 7, 13, 23, ALL_DIGITS_WRONG];

/// A table of all operations, or nothing where no plain number was measured.
pub fn accuracy(all: &[Accuracy], ink: &Ink) -> String {
    if all.is_empty() {
        return String::new();
    }
    let bound = |bucket: &usize| match *bucket {
        ALL_DIGITS_WRONG => "more".to_owned(),
        bucket => format!("≤{}", short_bound(bucket)),
    };
    let columns: Vec<String> = COLUMNS.iter().map(|bucket| format!("{:>6}", bound(bucket))).collect();
    let head = format!("{:12} {:>7} {:>6} {} {:>8}", "how far off", "numbers", "≤½, %", columns.join(" "), "worst");
    let mut out = format!("\n{}\n", ink.faint(&head));
    for Accuracy { operation, componentwise, normwise } in all {
        out += &format!("{operation}\n{}{}", line("  ulp", componentwise), line("  normwise", normwise));
    }
    out += &(ink.faint("Of plain numbers; normwise, in units of 2^-52 of the largest of the same list.") + "\n");
    out
}

fn line(name: &str, histogram: &Histogram) -> String {
    let mut from = 1;
    let columns = COLUMNS.map(|to| {
        let count = histogram.between(from, to + 1);
        from = to + 1;
        format!("{:>6}", if count == 0 { "·".to_owned() } else { count.to_string() })
    });
    let worst = histogram.worst.as_ref().map_or_else(String::new, |worst| short_units(worst.units));
    let share = histogram.share_correctly_rounded();
    format!("{name:12} {:>7} {share:>6} {} {worst:>8}\n", histogram.numbers, columns.join(" "))
}
