//! What is shown between the words: margins behind assertions, values of variables, sizes of objects; and above them, what
//! can be done.

use crate::diagnostics::in_words;
use crate::hover::constraint_at;
use crate::names::declared_kind;
use crate::shape::is_constraint;
use crate::{Snapshot, facts};
use rustc_hash::FxHashSet;
use scenelang_base::TextRange;
use scenelang_lang::ast::StmtKind;
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::Meanings;
use scenelang_lang::items::ItemKind;
use scenelang_lang::program::Unit;
use scenelang_verify::Tolerances;
use scenelang_verify::check::{Judged as Row, Subject};
use smol_str::SmolStr;

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
        if row.satisfied == Some(true) && says_nothing(snapshot, row) {
            continue;
        }
        let margin = row.margin.filter(|(value, _)| value.is_finite()).map(|(value, unit)| in_words(value, unit));
        let (label, tooltip) = match (row.satisfied, margin) {
            (Some(true), Some(margin)) => (margin, "holds by so much"),
            (Some(true), None) => continue,
            (Some(false), Some(margin)) => (format!("✗ {margin}"), "fails by so much"),
            (Some(false), None) => ("✗".to_owned(), "fails"),
            (None, _) => ("?".to_owned(), "cannot be checked in this layout"),
        };
        out.push(Hint { at: row.place.range.end, label, kind: HintKind::Margin, tooltip: tooltip.to_owned() });
    }
    let meanings = snapshot.meanings()?;
    let written = sized(&meanings);
    for (place, _) in &meanings.statements {
        let Some((name, kind)) = declared_kind(place) else { continue };
        let at = place.stmt.range.shifted(place.offset).end;
        match kind {
            ItemKind::Object | ItemKind::Array(_) if written.contains(&name) => {}
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

/// Whether the margin of what holds is no news: what holds to the last digit, an equality or a contact, still has its
/// tolerance as its margin.
fn says_nothing(snapshot: &Snapshot, row: &Row) -> bool {
    /// To so much layouts are rounded.
    const EXACT: f64 = 1e-4;
    let Tolerances { equal, contact, support, angle, .. } = snapshot.judging().options.tolerances;
    row.margin.is_some_and(|(value, unit)| match unit {
        Unit::Degree => value <= angle + EXACT,
        Unit::Metre => value <= equal + EXACT || [contact, support].iter().any(|most| (value - most).abs() <= EXACT),
    })
}

/// Objects whose size is written in the file already.
fn sized(meanings: &Meanings<'_>) -> FxHashSet<SmolStr> {
    let sizes = meanings.statements.iter().filter_map(|(place, _)| match &place.stmt.kind {
        StmtKind::Assign { name, path, .. } => {
            let size = path.first().is_some_and(|p| matches!(p.text.as_str(), "dimensions" | "scale"));
            size.then(|| name.text.clone())
        }
        _ => None,
    });
    sizes.collect()
}

/// What is said of the hint behind an offset, for who points at it: all that is known of its constraint.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn tooltip(snapshot: &Snapshot, at: u32) -> Result<Option<String>, Cancelled> {
    Ok(constraint_at(snapshot, at)?.map(|(_, text)| text))
}

/// What can be done above a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lens {
    /// With the whole program.
    Program,
    /// With a constraint that fails.
    Failing,
    /// With an object, or an array, that the layout has no place for yet.
    Unplaced(SmolStr),
}

/// Objects and arrays of the main file that the layout has no place for, at least not for all elements: their declarations,
/// and their names. Where there is no layout, none of them is said to lack a place.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn unplaced(snapshot: &Snapshot) -> Result<Vec<(TextRange, SmolStr)>, Cancelled> {
    let Some(layout) = snapshot.layout().filter(|l| l.read.usable).map(|l| &l.read.layout) else {
        return Ok(Vec::new());
    };
    let meanings = snapshot.meanings()?;
    let declared = meanings.statements.iter().filter_map(|(place, _)| {
        let (name, kind) = declared_kind(place)?;
        let lacks = match kind {
            ItemKind::Object => layout.object(&name).is_none(),
            ItemKind::Array(n) => (0..n).any(|i| layout.object(&format!("{name}[{i}]")).is_none()),
            _ => false,
        };
        (lacks && !name.is_empty()).then(|| (place.stmt.range.shifted(place.offset), name))
    });
    Ok(declared.collect())
}

/// Where something can be done: the first statement, constraints that fail, objects without a place.
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
        let fails = |row: &&Row| Some(row.place) == span && row.satisfied == Some(false);
        if let Some(span) = span.filter(|_| judged.verdict.rows.iter().any(|row| fails(&row))) {
            out.push((span.range, Lens::Failing));
        }
    }
    out.extend(unplaced(snapshot)?.into_iter().map(|(range, name)| (range, Lens::Unplaced(name))));
    Ok(out)
}
