//! All that is to be marked in a program and its layout: errors, warnings, and what does not hold in the layout, shown
//! at the statement that says it or, for a physical rule, at the declarations of its objects.

use crate::{Judged, Snapshot};
use scenelang_base::{Diagnostic, Label, Severity, codes};
use scenelang_lang::db::Cancelled;
use scenelang_lang::program::Unit;
use scenelang_verify::check::Judged as Row;
use scenelang_verify::report::goes_with;
use scenelang_verify::report::model::RowKind;

/// What is less than this has no digits to be shown, nor a sign.
const NOTHING: f64 = 5e-5;
/// No more violations are shown.
const MOST: usize = 250;

/// Something to be marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What, and where. Without a place it is said at the start of the file that it is about.
    pub diagnostic: Diagnostic,
    /// The row of the verdict that it shows.
    pub row: Option<usize>,
}

/// What is to be marked, in the program's files and in the layout.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn diagnostics(snapshot: &Snapshot) -> Result<Vec<Finding>, Cancelled> {
    let plain = |diagnostic: Diagnostic| Finding { diagnostic, row: None };
    let mut out: Vec<Finding> = snapshot.compiled()?.diagnostics.iter().cloned().map(plain).collect();
    if let Some(layout) = snapshot.layout() {
        out.extend(layout.read.diagnostics.iter().chain(&layout.unreadable).cloned().map(plain));
    }
    let Some(judged) = snapshot.judged()? else { return Ok(out) };
    out.extend(judged.verdict.diagnostics.iter().cloned().map(plain));
    let fails = |(_, row): &(usize, &Row)| row.satisfied == Some(false);
    for (index, row) in judged.verdict.rows.iter().enumerate().filter(fails).take(MOST) {
        if !said_already(&judged, row) {
            violation(row, index, &mut out);
        }
    }
    Ok(out)
}

/// Whether a collision is said by an assertion about the same two objects.
fn said_already(judged: &Judged, row: &Row) -> bool {
    let same = |other: &Row| {
        other.kind == RowKind::Assert
            && other.code == codes::V0102
            && other.satisfied == Some(false)
            && other.objects.iter().all(|id| row.objects.contains(id))
    };
    row.kind == RowKind::Collision && judged.verdict.rows.iter().any(same)
}

fn violation(row: &Row, index: usize, out: &mut Vec<Finding>) {
    let message = headline(row);
    let made = |place, related: Vec<Label>| {
        let mut d = Diagnostic::new(row.code, place, message.clone());
        if row.kind == RowKind::Prefer {
            d.severity = Severity::Warning;
        }
        d.related = related;
        d.notes.extend(row.requirements.iter().map(|r| format!("required by \"{r}\"")));
        Finding { diagnostic: d, row: Some(index) }
    };
    if row.kind.rule().is_none() {
        out.push(made(row.place, row.related.clone()));
        return;
    }
    // A rule has no text of its own; its objects have.
    let mut seen = Vec::new();
    for label in &row.related {
        if !seen.contains(&label.place) {
            seen.push(label.place);
            let others = row.related.iter().filter(|other| other.place != label.place).cloned();
            out.push(made(label.place, others.collect()));
        }
    }
    if seen.is_empty() {
        out.push(made(row.place, Vec::new()));
    }
}

/// What fails, and by how much, in a line.
pub fn headline(row: &Row) -> String {
    let what = if row.measured.is_empty() { &row.text } else { &row.measured };
    let fits = row.margin.is_some_and(|(_, unit)| goes_with(unit, what));
    match margin(row).filter(|_| fits) {
        Some(margin) => format!("{what} (margin {margin})"),
        None => what.clone(),
    }
}

/// A margin as people read it: `−0.07 m`, `+12°`.
pub fn margin(row: &Row) -> Option<String> {
    let (value, unit) = row.margin.filter(|(value, _)| value.is_finite())?;
    Some(in_words(value, unit))
}

pub(crate) fn in_words(value: f64, unit: Unit) -> String {
    let size = value.abs();
    // Below a millimetre the digits are what matters.
    let digits = if (NOTHING..0.01).contains(&size) { format!("{size:.4}") } else { format!("{size:.2}") };
    let sign = if value <= -NOTHING { "−" } else { "+" };
    let unit = if unit == Unit::Degree { "°" } else { " m" };
    format!("{sign}{digits}{unit}")
}
