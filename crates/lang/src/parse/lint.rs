//! What is wrong with a statement that parses: comparisons that chain, arrows read as `<` `-`.

use super::depth::for_each_child;
use super::wording::quote;
use crate::ast::{Expr, ExprKind};
use scenelang_base::codes::{E0114, W0102};
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, TextRange};

/// Checks a statement's expressions; `arrows` are the places where `<-` was read as `<` and `-`.
pub fn check(text: &str, exprs: &[Expr], arrows: &[TextRange]) -> Vec<Diagnostic<TextRange>> {
    let mut found: Vec<Diagnostic<TextRange>> = arrows.iter().map(|arrow| arrow_inside(*arrow)).collect();
    let chains = |expr: &Expr| matches!(&expr.kind, ExprKind::Compare(_, steps) if steps.len() > 1);
    if exprs.iter().any(chains) {
        let negated = negated(exprs);
        for (expr, negated) in exprs.iter().zip(negated).filter(|(expr, _)| chains(expr)) {
            found.push(chain(text, expr, exprs, negated));
        }
    }
    found
}

fn arrow_inside(arrow: TextRange) -> Diagnostic<TextRange> {
    Diagnostic::new(W0102, arrow, "`<-` inside an expression means `<` and `-`")
        .fix(Applicability::Safe, "write a space between them", TextRange::empty(arrow.start + 1), " ")
}

/// Which expressions stand directly after `not`.
fn negated(exprs: &[Expr]) -> Vec<bool> {
    let mut negated = vec![false; exprs.len()];
    for expr in exprs.iter().filter(|e| matches!(e.kind, ExprKind::Not(_))) {
        for_each_child(&expr.kind, |child| negated[child.0 as usize] = true);
    }
    negated
}

fn chain(text: &str, expr: &Expr, exprs: &[Expr], negated: bool) -> Diagnostic<TextRange> {
    let ExprKind::Compare(_, steps) = &expr.kind else { unreachable!("only chains are passed") };
    let between = |i: usize| -> &str {
        // Up to the next operator, so that parentheses around the operand are kept.
        let (_, operator, right) = &steps[i];
        let end = steps.get(i + 1).map_or(exprs[right.0 as usize].range.end, |(_, next, _)| next.start);
        text[operator.end as usize..end as usize].trim()
    };
    let mut edits: Vec<Edit<TextRange>> = Vec::new();
    for (i, (_, operator, _)) in steps.iter().enumerate().skip(1) {
        let text = format!("and {} ", between(i - 1));
        edits.push(Edit { place: TextRange::empty(operator.start), text });
    }
    if negated {
        edits.insert(0, Edit { place: TextRange::empty(expr.range.start), text: "(".to_owned() });
        edits.push(Edit { place: TextRange::empty(expr.range.end), text: ")".to_owned() });
    }
    let mut diagnostic = Diagnostic::new(E0114, expr.range, "comparisons do not chain");
    for ((_, operator, _), which) in steps.iter().zip(["the first comparison", "the second"]) {
        diagnostic = diagnostic.related(*operator, which);
    }
    let middle = between(0);
    let note = match middle.contains(['\n', '\r']) {
        true => "join two comparisons with `and`".to_owned(),
        false => format!("compare {} twice, and join the comparisons with `and`", quote(middle)),
    };
    let mut diagnostic = diagnostic.note(note);
    let title = format!("write {}", quote(&applied(text, expr.range, &edits)));
    diagnostic.fixes.push(Fix { title, edits, applicability: Applicability::Unsafe });
    diagnostic
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
