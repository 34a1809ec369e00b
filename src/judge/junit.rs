//! The run as JUnit XML, for servers that show tests.

use super::report::{Failure, Report, Row};
use quick_junit::{NonSuccessKind, Property, TestCase, TestCaseStatus, TestSuite};
use std::time::Duration;

/// One suite for each row. Its first test is the row itself, and fails iff an answer in it is wrong, or is an
/// error iff a question in it broke the candidate; the others are its failures, each with how to see it again.
/// A row of which nothing was answered is skipped.
pub fn junit(report: &Report) -> String {
    let mut xml = quick_junit::Report::new(format!("isoracle judge {}: {}", report.suite, report.candidate.name));
    xml.set_time(seconds(report.seconds.total));
    for row in report.rows() {
        let mut suite = TestSuite::new(row.name.as_str());
        suite.add_property(Property::new(
            "candidate",
            format!("{} {}", report.candidate.name, report.candidate.version),
        ));
        suite.add_property(Property::new("seed", report.seed.to_string()));
        for (name, count) in [
            ("asked", row.asked),
            ("passed", row.passed),
            ("wrong", row.wrong),
            ("broken", row.broken),
            ("unsupported", row.unsupported),
        ] {
            suite.add_property(Property::new(name, count.to_string()));
        }
        suite.add_test_case(row_test(report, row));
        let failures = report.failures.iter().filter(|failure| failure.row == row.name);
        suite.add_test_cases(failures.map(|failure| failure_test(report, failure)));
        xml.add_test_suite(suite);
    }
    xml.to_string().expect("a report of plain strings can be written")
}

fn class_name(report: &Report, row: &str) -> String {
    format!("{}.{row}", report.suite)
}

fn row_test(report: &Report, row: &Row) -> TestCase {
    let mut status = if row.broken > 0 {
        TestCaseStatus::non_success(NonSuccessKind::Error)
    } else if row.wrong > 0 {
        TestCaseStatus::non_success(NonSuccessKind::Failure)
    } else if row.passed == 0 {
        TestCaseStatus::skipped()
    } else {
        TestCaseStatus::success()
    };
    status.set_message(format!(
        "{} of {} answers are right, {} wrong, {} broken, {} declined",
        row.passed, row.asked, row.wrong, row.broken, row.unsupported
    ));
    if !row.faults.is_empty() {
        let faults: Vec<String> = row.faults.iter().map(|(name, count)| format!("{name}: {count}")).collect();
        status.set_description(faults.join("\n"));
    }
    let mut test = TestCase::new("every answer is right", status);
    test.set_classname(class_name(report, &row.name));
    test
}

fn failure_test(report: &Report, failure: &Failure) -> TestCase {
    // Without a mesh from the candidate, and without an invariant that differs, there was no answer to be wrong.
    let kind = match (&failure.found, failure.differences.as_slice()) {
        (None, []) => NonSuccessKind::Error,
        (None, [_, ..]) | (Some(_), _) => NonSuccessKind::Failure,
    };
    let mut status = TestCaseStatus::non_success(kind);
    status.set_message(failure.messages.first().unwrap_or(&failure.fault).as_str());
    status.set_type(failure.fault.as_str());
    let mut lines = vec![format!("case {}, {}", failure.case, failure.formula)];
    lines.extend(failure.messages.iter().cloned());
    let differences = failure.differences.iter();
    lines.extend(differences.map(|d| format!("{}: expected {}, found {}", d.invariant, d.expected, d.found)));
    lines.push(failure.question.json());
    lines.push(format!("again: {}", failure.command));
    status.set_description(lines.join("\n"));
    let mut test = TestCase::new(format!("{} in case {}", failure.fault, failure.case), status);
    test.set_classname(class_name(report, &failure.row));
    test
}

/// A duration from a number that a caller may have made NaN or negative.
fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or_default()
}
