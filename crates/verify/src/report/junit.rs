//! The report for test runners: a test case per constraint, a failure where it fails, an error where the file is wrong.

use super::model::{Finding, Report, Row};
use scenelang_base::plain;
use std::fmt::Write;

/// A JUnit XML document with a suite per report.
pub fn junit(reports: &[Report]) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"scenelang\">\n");
    for report in reports {
        suite(report, &mut out);
    }
    out.push_str("</testsuites>\n");
    out
}

fn suite(report: &Report, out: &mut String) {
    let errors: Vec<&Finding> = report.diagnostics.iter().filter(|d| d.severity == "error").collect();
    let rows = &report.constraints;
    let more = report.unlisted.failing_in_words();
    let failures = rows.iter().filter(|r| r.is_violation()).count() + usize::from(more.is_some());
    let skipped = rows.iter().filter(|r| is_skipped(r)).count();
    let file = escaped(&report.file);
    let tests = rows.len() + errors.len() + usize::from(more.is_some());
    line(
        out,
        format_args!(
            "  <testsuite name=\"{file}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{}\" skipped=\"{skipped}\">",
            errors.len()
        ),
    );
    for row in rows {
        case(row, &file, out);
    }
    if let Some(more) = more.as_deref().map(escaped) {
        line(out, format_args!("    <testcase classname=\"{file}\" name=\"{more}\">"));
        line(out, format_args!("      <failure message=\"{more}\">{more}</failure>"));
        line(out, format_args!("    </testcase>"));
    }
    for finding in errors {
        let place = finding.span.as_ref().map(|s| format!("{}:{}:{}: ", s.file, s.start[0], s.start[1]));
        let code = escaped(&finding.code);
        let message = escaped(&finding.message);
        let text = escaped(&format!("{}{}", place.unwrap_or_default(), finding.message));
        line(out, format_args!("    <testcase classname=\"{file}\" name=\"{code}: {message}\">"));
        line(out, format_args!("      <error type=\"{code}\" message=\"{message}\">{text}</error>"));
        line(out, format_args!("    </testcase>"));
    }
    line(out, format_args!("  </testsuite>"));
}

/// What cannot be judged, and a preference that is not met: neither passed nor failed.
fn is_skipped(row: &Row) -> bool {
    row.satisfied != Some(true) && !row.is_violation()
}

fn case(row: &Row, file: &str, out: &mut String) {
    let (id, text) = (escaped(&row.id), escaped(&row.text));
    let head = format!("    <testcase classname=\"{file}\" name=\"{id} {text}\"");
    if row.satisfied == Some(true) {
        line(out, format_args!("{head}/>"));
        return;
    }
    let message = escaped(&row.message);
    line(out, format_args!("{head}>"));
    if row.is_violation() {
        let code = escaped(row.code.as_deref().unwrap_or_default());
        let margin = match (row.margin, &row.unit) {
            (Some(margin), Some(unit)) => format!("margin {margin} {unit}; "),
            _ => String::new(),
        };
        line(out, format_args!("      <failure type=\"{code}\" message=\"{message}\">{margin}{message}</failure>"));
    } else {
        line(out, format_args!("      <skipped message=\"{message}\"/>"));
    }
    line(out, format_args!("    </testcase>"));
}

fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    let _infallible = writeln!(out, "{text}");
}

/// Text as XML takes it; characters that XML has no way to write become the replacement character.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    // Viewers show it, and some print it.
    for c in plain::line(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\r' | '\t' => out.push(' '),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
