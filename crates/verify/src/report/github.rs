//! The report as workflow commands of GitHub Actions: each becomes an annotation at its line of a pull request.

use super::compact::main_fact;
use super::model::{Report, SourceSpan};
use scenelang_base::plain;
use std::fmt::Write;

/// A line for each finding; nothing where there is none.
pub fn github(reports: &[Report]) -> String {
    let mut out = String::new();
    for report in reports {
        for finding in &report.diagnostics {
            annotate(&mut out, &finding.severity, &finding.code, finding.span.as_ref(), &finding.message, report);
        }
        for row in report.constraints.iter().filter(|row| row.satisfied == Some(false)) {
            // A preference that is not met does not fail a build.
            let level = if row.is_violation() { "error" } else { "notice" };
            let code = row.code.as_deref().unwrap_or_default();
            annotate(&mut out, level, code, row.span.as_ref(), &main_fact(row), report);
        }
        if let Some(more) = report.unlisted.failing_in_words() {
            annotate(&mut out, "error", "more", None, &more, report);
        }
    }
    out
}

fn annotate(out: &mut String, level: &str, code: &str, place: Option<&SourceSpan>, message: &str, report: &Report) {
    let file = property(&place.map_or(report.file.as_str(), |p| p.file.as_str()).replace('\\', "/"));
    let place = place.map_or_else(String::new, region);
    let _infallible = writeln!(out, "::{level} file={file}{place},title={}::{}", property(code), data(message));
}

/// Columns may be given only within one line; theirs are inclusive, ours end before.
fn region(SourceSpan { start, end, .. }: &SourceSpan) -> String {
    let lines = format!(",line={},endLine={}", start[0], end[0]);
    if start[0] == end[0] {
        return format!("{lines},col={},endColumn={}", start[1], start[1].max(end[1].saturating_sub(1)));
    }
    lines
}

/// Text after `::`, escaped as the runner undoes it: a line.
fn data(text: &str) -> String {
    // The runner would make line breaks of these again; what else acts is not for a log.
    plain::line(text).replace('%', "%25")
}

/// The value of a property, which a comma or colon would end.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
