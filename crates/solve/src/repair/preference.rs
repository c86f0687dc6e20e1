//! What else repairs where moves do not: a preference that stands in the way is given up, or a demand becomes a preference.

use super::judge::Judge;
use super::room::describe;
use super::{Alternative, How, RepairOptions, Text, edit, moves};
use scenelang_base::{Edit, TextRange};
use scenelang_lang::program::ConstraintKind;
use scenelang_layout::Layout;
use scenelang_verify::check::Subject;
use scenelang_verify::explain::RowRef;
use scenelang_verify::prove::Contradiction;

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

/// Demands as preferences: an edit of the text. Of those that fail all or, where some cannot hold with others, only these,
/// if the rest can be repaired by moves. `None`: something else fails, too.
pub(super) fn demand(judge: &Judge<'_>, text: &Text<'_>, apart: &[(Vec<RowRef>, Layout)]) -> Option<Alternative> {
    let found = apart.iter().find_map(|(rows, layout)| demoted(judge, text, rows, layout));
    if found.is_some() {
        return found;
    }
    demoted(judge, text, &judge.targets, judge.layout)
}

/// Where only some of what fails belongs to a contradiction: that, with layouts in which moves have repaired the rest.
pub(super) fn apart(judge: &Judge<'_>, contradiction: Option<&Contradiction>) -> Vec<(Vec<RowRef>, Layout)> {
    let within = |row: &RowRef| {
        let Subject::Statement(index) = row.subject else { return false };
        contradiction.is_some_and(|c| c.statements.contains(&index))
    };
    let (own, others): (Vec<RowRef>, Vec<RowRef>) = judge.targets.iter().partition(|row| within(row));
    if own.is_empty() || others.is_empty() {
        return Vec::new();
    }
    moves::reachable(judge, &others).into_iter().map(|layout| (own.clone(), layout)).collect()
}

/// Rows as preferences in a layout, in which all others hold.
fn demoted(judge: &Judge<'_>, text: &Text<'_>, rows: &[RowRef], layout: &Layout) -> Option<Alternative> {
    let mut edits = Vec::new();
    for row in rows {
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
    let other = |row| (!rows.iter().any(|t| same_statement(t, &row))).then_some(row);
    judge.judge_with(&program, layout, other)?;
    let cost = edits.len() as f64;
    Some(Alternative { how: How::Prefer, edits, cost, ..describe(judge, layout.clone(), &[]) })
}

fn same_statement(a: &RowRef, b: &RowRef) -> bool {
    a.subject == b.subject && matches!(a.subject, Subject::Statement(_))
}
