//! The errors of plain numbers on the page: for each operation two small bar charts.

use crate::judge::accuracy::{ALL_DIGITS_WRONG, Accuracy, Histogram, short_bound, short_units};
use crate::judge::report::grouped;
use maud::{Markup, html};

/// Width and height of a chart's bars, in units of the picture, and the height below them for the axis.
const BAR: usize = 8;
const HEIGHT: f64 = 90.0;
const AXIS: f64 = 18.0;

/// The section, or nothing where no plain number was measured.
pub fn accuracy(all: &[Accuracy]) -> Markup {
    html! {
        @if !all.is_empty() {
            section aria-labelledby="accuracy" {
                h2 #accuracy { "How far plain numbers are off" }
                p.note {
                    "Errors against the exact values, not against their roundings. Left, in units of the last place (ulp) of the binary64 nearest "
                    "to the true number; right, normwise, in units of 2" sup { "−52" } " of the largest number of the same list. Each bar holds the "
                    "errors up to the bound below it, and above the one before; the first one those of correctly rounded numbers. Heights are "
                    "logarithmic."
                }
                @for Accuracy { operation, componentwise, normwise } in all {
                    div.accuracy {
                        h3 { (operation) }
                        div.pair { (chart(operation, "ulp", componentwise)) (chart(operation, "normwise", normwise)) }
                    }
                }
            }
        }
    }
}

fn chart(operation: &str, unit: &str, histogram: &Histogram) -> Markup {
    let width = BAR * (ALL_DIGITS_WRONG + 1);
    let numbers = histogram.numbers;
    let share = histogram.share_correctly_rounded();
    let title = format!("{operation}, {unit}: {} numbers, {share} % of them correctly rounded", grouped(numbers));
    let top = (numbers as f64 + 1.0).ln();
    let height = |count: usize| HEIGHT * (count as f64 + 1.0).ln() / top.max(1.0);
    let class = |bucket: usize| match bucket {
        0 => "right",
        ALL_DIGITS_WRONG => "wrong",
        _ => "off",
    };
    html! {
        figure {
            svg.histogram viewBox={ "0 0 " (width) " " (HEIGHT + AXIS) } role="img" aria-label=(title) {
                title { (title) }
                @for (i, bucket) in histogram.buckets.iter().enumerate() {
                    @if bucket.count > 0 {
                        rect class=(class(i)) x=(i * BAR) y=(format!("{:.1}", HEIGHT - height(bucket.count)))
                            width=(BAR - 1) height=(format!("{:.1}", height(bucket.count))) {
                            title { (grouped(bucket.count)) " up to " (bucket.up_to) }
                        }
                    }
                }
                line.axis x1="0" y1=(HEIGHT) x2=(width) y2=(HEIGHT) {}
                @for i in [0, 5, 11, 21, 31, 41, ALL_DIGITS_WRONG] {
                    text x=(i * BAR + BAR / 2) y=(HEIGHT + 13.0) text-anchor=(anchor(i)) { (short_bound(i)) }
                }
            }
            figcaption {
                (unit) ": " (grouped(numbers)) " numbers, " strong { (share) " %" } " correctly rounded"
                @if let Some(worst) = &histogram.worst {
                    ", worst " (short_units(worst.units)) " in " code { (worst.field) } ": expected " (worst.expected) ", found " (worst.found)
                    details { summary { "its question" } pre tabindex="0" { (worst.question.to_string()) } }
                }
            }
        }
    }
}

fn anchor(bucket: usize) -> &'static str {
    match bucket {
        0 => "start",
        ALL_DIGITS_WRONG => "end",
        _ => "middle",
    }
}
