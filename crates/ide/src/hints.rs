//! What is shown between the words: margins behind assertions, values of variables, sizes of objects; and above them, what
//! can be done.

use crate::diagnostics::in_words;
use crate::names::declared_kind;
use crate::shape::is_constraint;
use crate::{Snapshot, facts};
use scenelang_base::TextRange;
use scenelang_lang::db::Cancelled;
use scenelang_lang::items::ItemKind;
use scenelang_verify::check::Subject;

/// What a hint says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HintKind {
    /// By how much a constraint holds.
    Margin,
    /// What a variable is.
    Value,
    /// How large an object is.
    Size,
}

/// A hint behind an offset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// Where it is shown.
    pub at: u32,
    /// What is shown.
    pub label: String,
    /// What it says.
    pub kind: HintKind,
    /// More, for who points at it.
    pub tooltip: String,
}

/// Hints in a range of the main file, in order.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn hints(snapshot: &Snapshot, range: TextRange) -> Result<Vec<Hint>, Cancelled> {
    let Some(judged) = snapshot.judged()? else { return Ok(Vec::new()) };
    let Some(layout) = snapshot.layout().map(|l| &l.read.layout) else { return Ok(Vec::new()) };
    let mut out = Vec::new();
    for row in &judged.verdict.rows {
        if row.place.file != snapshot.main() || !matches!(row.subject, Subject::Statement(_)) {
            continue;
        }
        let margin = row.margin.filter(|(value, _)| value.is_finite()).map(|(value, unit)| in_words(value, unit));
        let (label, tooltip) = match (row.satisfied, margin) {
            (Some(true), Some(margin)) => (margin, "holds by so much"),
            (Some(true), None) => ("✓".to_owned(), "holds"),
            (Some(false), Some(margin)) => (format!("✗ {margin}"), "fails by so much"),
            (Some(false), None) => ("✗".to_owned(), "fails"),
            (None, _) => ("?".to_owned(), "cannot be judged in this layout"),
        };
        out.push(Hint { at: row.place.range.end, label, kind: HintKind::Margin, tooltip: tooltip.to_owned() });
    }
    for (place, _) in &snapshot.meanings()?.statements {
        let Some((name, kind)) = declared_kind(place) else { continue };
        let at = place.stmt.range.shifted(place.offset).end;
        match kind {
            ItemKind::Object | ItemKind::Array(_) => {
                let first = layout.object(&name).or_else(|| layout.object(&format!("{name}[0]")));
                out.extend(first.map(|p| Hint {
                    at,
                    label: facts::size(&p.scale),
                    kind: HintKind::Size,
                    tooltip: "width × height × depth in the layout".to_owned(),
                }));
            }
            ItemKind::Variable(_) => out.extend(facts::of_variable(layout, &name).map(|value| Hint {
                at,
                label: format!("= {value}"),
                kind: HintKind::Value,
                tooltip: "chosen by the layout".to_owned(),
            })),
            ItemKind::Region => {}
        }
    }
    out.retain(|hint| range.start <= hint.at && hint.at <= range.end);
    out.sort_by_key(|hint| hint.at);
    Ok(out)
}

/// What can be done above a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lens {
    /// With the whole program.
    Program,
    /// With a constraint that fails.
    Failing,
}

/// Where something can be done: the first statement, and constraints that fail.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn lenses(snapshot: &Snapshot) -> Result<Vec<(TextRange, Lens)>, Cancelled> {
    let meanings = snapshot.meanings()?;
    let whole = |at: usize| meanings.statements.get(at).map(|(place, _)| place.stmt.range.shifted(place.offset));
    let mut out: Vec<(TextRange, Lens)> = whole(0).map(|range| (range, Lens::Program)).into_iter().collect();
    let Some(judged) = snapshot.judged()? else { return Ok(out) };
    for (place, _) in meanings.statements.iter().filter(|(place, _)| is_constraint(&place.stmt.kind)) {
        let span = place.span(place.stmt.range);
        let fails = |row: &&scenelang_verify::check::Judged| Some(row.place) == span && row.satisfied == Some(false);
        if let Some(span) = span.filter(|_| judged.verdict.rows.iter().any(|row| fails(&row))) {
            out.push((span.range, Lens::Failing));
        }
    }
    Ok(out)
}
