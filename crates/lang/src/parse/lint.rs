//! What is wrong with a statement that parses: comparisons that chain, arrows read as `<` `-`.

use super::wording::quote;
use crate::ast::{Expr, ExprId, ExprKind};
use crate::program::Comparison;
use scenelang_base::codes::{E0114, W0102};
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, TextRange};

/// A comparison's operator, its place, its right side.
type Step = (Comparison, TextRange, ExprId);

/// Checks a statement's expressions; `arrows` are the places where `<-` was read as `<` and `-`.
pub fn check(text: &str, exprs: &[Expr], arrows: &[TextRange]) -> Vec<Diagnostic<TextRange>> {
    let mut found: Vec<Diagnostic<TextRange>> = arrows.iter().map(|arrow| arrow_inside(*arrow)).collect();
    // Looked for only when needed: chains are rare.
    let mut under_not = None;
    for (i, expr) in exprs.iter().enumerate() {
        if let ExprKind::Compare(_, steps) = &expr.kind
            && steps.len() > 1
        {
            let negated = under_not.get_or_insert_with(|| negated(exprs))[i];
            found.push(chain(text, expr.range, steps, exprs, negated));
        }
    }
    found
}

fn arrow_inside(arrow: TextRange) -> Diagnostic<TextRange> {
    Diagnostic::new(W0102, arrow, "`<-` inside an expression means `<` and `-`").fix(
        Applicability::Safe,
        "write a space between them",
        TextRange::empty(arrow.start + 1),
        " ",
    )
}

/// Which expressions stand directly after `not`.
fn negated(exprs: &[Expr]) -> Vec<bool> {
    let mut negated = vec![false; exprs.len()];
    for expr in exprs.iter().filter(|e| matches!(e.kind, ExprKind::Not(_))) {
        expr.kind.for_each_child(|child| negated[child.0 as usize] = true);
    }
    negated
}

fn chain(text: &str, place: TextRange, steps: &[Step], exprs: &[Expr], negated: bool) -> Diagnostic<TextRange> {
    let right_side = |i: usize| -> &str {
        // Up to the next operator, so that parentheses around the operand are kept.
        let (_, operator, right) = &steps[i];
        let end = steps.get(i + 1).map_or(exprs[right.0 as usize].range.end, |(_, next, _)| next.start);
        text[operator.end as usize..end as usize].trim()
    };
    let mut diagnostic = Diagnostic::new(E0114, place, "comparisons cannot be chained");
    for ((_, operator, _), which) in steps.iter().zip(["the first comparison", "the second"]) {
        diagnostic = diagnostic.related(*operator, which);
    }
    let shared = 0..steps.len() - 1;
    if shared.clone().any(|i| right_side(i).contains("//")) {
        // A comment would go along with its operand.
        return diagnostic.note("join two comparisons with `and`");
    }
    let again =
        |i: usize| Edit { place: TextRange::empty(steps[i + 1].1.start), text: format!("and {} ", right_side(i)) };
    let mut edits: Vec<Edit<TextRange>> = shared.map(again).collect();
    if negated {
        edits.insert(0, Edit { place: TextRange::empty(place.start), text: "(".to_owned() });
        edits.push(Edit { place: TextRange::empty(place.end), text: ")".to_owned() });
    }
    let title = format!("write {}", quote(&applied(text, place, &edits)));
    diagnostic.fixes.push(Fix { title, edits, applicability: Applicability::Unsafe });
    diagnostic.note(format!("compare {} twice, and join the comparisons with `and`", quote(right_side(0))))
}

/// The text of a place with edits inside it made.
fn applied(text: &str, place: TextRange, edits: &[Edit<TextRange>]) -> String {
    let mut made = String::new();
    let mut at = place.start as usize;
    for edit in edits {
        made.push_str(&text[at..edit.place.start as usize]);
        made.push_str(&edit.text);
        at = edit.place.end as usize;
    }
    made.push_str(&text[at..place.end as usize]);
    made
}
