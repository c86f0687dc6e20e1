//! What else repairs where moves do not: a preference that stands in the way is given up, or a demand becomes a preference.

use super::judge::Judge;
use super::room::describe;
use super::{Alternative, How, RepairOptions, Text, edit, moves};
use scenelang_base::{Edit, TextRange};
use scenelang_lang::program::ConstraintKind;
use scenelang_verify::check::Subject;

/// The keyword of a demand, and that of a preference.
const KEYWORDS: [&str; 2] = ["assert", "prefer"];

/// Moves that repair, and leave preferences unmet that hold in the layout.
pub(super) fn drops(judge: &Judge<'_>, options: &RepairOptions) -> Vec<Alternative> {
    let preferences = judge.program.constraints.iter().any(|c| matches!(c.kind, ConstraintKind::Prefer { .. }));
    if !preferences {
        return Vec::new();
    }
    moves::all(judge, options, true)
}

/// The demands that fail, as preferences: an edit of the text. `None`: something else fails, too.
pub(super) fn demand(judge: &Judge<'_>, text: &Text<'_>) -> Option<Alternative> {
    let mut edits = Vec::new();
    for row in &judge.targets {
        let Subject::Statement(index) = row.subject else { return None };
        let constraint = &judge.program.constraints[index];
        let span = constraint.span;
        let keyword = text.sources.text(span).starts_with(KEYWORDS[0]);
        if constraint.kind != ConstraintKind::Assert || !keyword {
            return None;
        }
        let start = span.range.start as usize;
        let place = TextRange::new(start, start + KEYWORDS[0].len()).in_file(span.file);
        edits.push(Edit { place, text: KEYWORDS[1].to_owned() });
    }
    let program = edit::compiled(text, &edits)?;
    let other = |row| (!judge.targets.iter().any(|t| same_statement(t, &row))).then_some(row);
    judge.judge_with(&program, judge.layout, other)?;
    let cost = edits.len() as f64;
    Some(Alternative { how: How::Prefer, edits, cost, ..describe(judge, judge.layout.clone(), &[]) })
}

fn same_statement(a: &scenelang_verify::explain::RowRef, b: &scenelang_verify::explain::RowRef) -> bool {
    a.subject == b.subject && matches!(a.subject, Subject::Statement(_))
}
