//! The report for people in a hurry: a line for each finding, in the form that editors and terminals make clickable.

use super::human::{Human, holding, judged_with, summary};
use super::model::{Finding, Report, Row, RowKind, SourceSpan};
use scenelang_base::plain;
use scenelang_lang::program::Unit;
use std::fmt::Write;

/// `file:line:column: error[V0101]: what is wrong`, one line each; then one line that sums up.
pub fn compact(report: &Report, Human { color, all }: Human) -> String {
    let mut out = String::new();
    let mut add = |place: Option<&SourceSpan>, level: Level, code: &str, message: &str| {
        let place = place.map_or_else(|| report.file.clone(), |p| format!("{}:{}:{}", p.file, p.start[0], p.start[1]));
        let text = format!("{}: {}: {}", plain::line(&place), level.painted(code, color), plain::line(message));
        let _infallible = writeln!(out, "{}", plain::no_command(&text));
    };
    for Finding { code, severity, message, span, .. } in &report.diagnostics {
        let level = if severity == "error" { Level::Error } else { Level::Warning };
        add(span.as_ref(), level, code, message);
    }
    for row in report.constraints.iter().filter(|row| row.satisfied == Some(false)) {
        let level = if row.is_violation() { Level::Error } else { Level::Advice };
        add(row.span.as_ref(), level, row.code.as_deref().unwrap_or_default(), &main_fact(row));
    }
    if let Some(more) = report.unlisted.failing_in_words() {
        let _infallible = writeln!(out, "{}", plain::no_command(&format!("{}: {more}", plain::line(&report.file))));
    }
    if all {
        holding(report, &mut out);
    }
    let text = format!("{}: {}", plain::line(&report.file), summary(report));
    let _infallible = writeln!(out, "{}", plain::no_command(&text));
    judged_with(report, &mut out);
    out
}

/// Whether a margin of a unit says something beside a sentence: metres do not beside what is said in degrees.
pub fn goes_with(unit: Unit, measured: &str) -> bool {
    unit != Unit::Metre || !measured.contains('°')
}

/// A margin with three digits, or as many as it takes to see that it is none.
fn seen(margin: f64) -> String {
    let digits = (3..=6).find(|digits| margin.abs() * 10_f64.powi(*digits) >= 0.5).unwrap_or(3);
    let text = format!("{margin:.*}", digits as usize);
    // A zero has no sign.
    if margin.abs() < 5e-7 { text.trim_start_matches('-').to_owned() } else { text }
}

/// What fails and what was measured, with the margin.
pub(super) fn main_fact(row: &Row) -> String {
    // Where the objects are comes after the first semicolon.
    let measured = row.message.split("; `").next().unwrap_or_default();
    let margin = match (row.margin, row.unit.as_deref()) {
        (Some(margin), Some("deg")) => format!(" (margin {margin:.1}°)"),
        (Some(_), Some("m")) if !goes_with(Unit::Metre, measured) => String::new(),
        (Some(margin), Some(unit)) => format!(" (margin {} {unit})", seen(margin)),
        _ => String::new(),
    };
    let fails = if row.is_violation() { "fails" } else { "is not met" };
    match (row.kind, measured, row.objects.as_slice()) {
        (_, "", _) => format!("{} {fails}{margin}", row.text),
        (RowKind::Collision | RowKind::Bounds, ..) => format!("{measured}{margin}"),
        // A measure of support begins with "it".
        (RowKind::Support, _, [object]) => format!("`{object}` is not supported: {measured}{margin}"),
        // Which object it is stands nowhere else in the line.
        (RowKind::Open, _, [object, ..]) => format!("`{object}`: {measured}{margin}"),
        _ => format!("{} {fails}: {measured}{margin}", row.text),
    }
}

#[derive(Clone, Copy)]
enum Level {
    Error,
    Warning,
    Advice,
}

impl Level {
    fn painted(self, code: &str, color: bool) -> String {
        let (word, ansi) = match self {
            Self::Error => ("error", 31),
            Self::Warning => ("warning", 33),
            Self::Advice => ("advice", 36),
        };
        if color { format!("\x1b[{ansi}m{word}[{code}]\x1b[0m") } else { format!("{word}[{code}]") }
    }
}
