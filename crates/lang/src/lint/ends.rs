//! W0307: ranges of indices that leave out the first or the last element of an array, although they go through all others.

use super::facts::Facts;
use super::scope::{Binder, Scopes};
use crate::ast::{ExprId, ExprKind, Stmt};
use crate::check::constant;
use crate::items::ItemKind;
use rustc_hash::FxHashSet;
use scenelang_base::{Applicability, Diagnostic, TextRange, codes};
use smol_str::SmolStr;

/// A quantifier over a range of constants whose variable is an index and nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Indexing {
    /// The arrays that it indexes, each once.
    pub arrays: Vec<SmolStr>,
    /// From this index.
    lo: u32,
    /// Up to, but not including, this one.
    hi: u32,
    /// Where both are written.
    at: [TextRange; 2],
}

/// The quantifiers of a statement that go through indices, and the elements that it names: array and index. Where a variable
/// is part of an index (`seat[i + 1]`) or of the range of another variable, the range may be shorter for good reason.
pub fn of(stmt: &Stmt, scopes: &Scopes<'_>) -> (Vec<Indexing>, Vec<(SmolStr, u32)>) {
    let (mut found, mut elements) = (Vec::new(), Vec::new());
    let free = |id: ExprId| match &stmt.expr(id).kind {
        ExprKind::Name(name) if scopes.binder(id).is_none() => Some(name),
        _ => None,
    };
    for id in &scopes.order {
        match &stmt.expr(*id).kind {
            ExprKind::Index(array, index) => {
                let number = constant::number(stmt, *index).filter(|n| n.fract() == 0.0 && *n >= 0.0);
                elements.extend(free(*array).zip(number).map(|(array, n)| (array.clone(), n as u32)));
            }
            ExprKind::Quantified(_, _, domain, _) => {
                let ExprKind::Range(lo, hi) = &stmt.expr(*domain).kind else { continue };
                let whole = |id: ExprId| {
                    constant::number(stmt, id).filter(|n| n.fract() == 0.0 && (0.0..1e6).contains(n)).map(|n| n as u32)
                };
                let (Some(from), Some(to)) = (whole(*lo), whole(*hi)) else { continue };
                if let Some(arrays) = indexed(stmt, scopes, *id) {
                    let at = [*lo, *hi].map(|id| stmt.expr(id).range);
                    found.push(Indexing { arrays, lo: from, hi: to, at });
                }
            }
            _ => {}
        }
    }
    (found, elements)
}

/// The arrays that the variable of a quantifier indexes, if that is all that it is used for.
fn indexed(stmt: &Stmt, scopes: &Scopes<'_>, quantifier: ExprId) -> Option<Vec<SmolStr>> {
    let is_variable = |id: ExprId| scopes.binder(id) == Some(Binder::Quantifier(quantifier));
    let mut arrays: Vec<SmolStr> = Vec::new();
    let (mut uses, mut plain) = (0, 0);
    for id in &scopes.order {
        uses += usize::from(is_variable(*id));
        if let ExprKind::Index(array, index) = &stmt.expr(*id).kind
            && is_variable(*index)
            && let ExprKind::Name(name) = &stmt.expr(*array).kind
            && scopes.binder(*array).is_none()
        {
            plain += 1;
            if !arrays.contains(name) {
                arrays.push(name.clone());
            }
        }
    }
    (plain > 0 && uses == plain).then_some(arrays)
}

/// Looks at all statements of the main file. An element that is named anywhere is not forgotten, and a range that goes
/// through all of another array is as long as it should be.
pub fn check(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    if facts.statements.iter().all(|s| s.uses.indexing.is_empty()) {
        return;
    }
    let named: FxHashSet<&(SmolStr, u32)> = facts.statements.iter().flat_map(|s| &s.uses.elements).collect();
    let length = |array: &SmolStr| match facts.names.item(array) {
        Some(ItemKind::Array(n)) => Some(n),
        _ => None,
    };
    for linted in facts.statements.iter().filter(|s| s.sound && s.place.file == facts.main) {
        for Indexing { arrays, lo, hi, at } in &linted.uses.indexing {
            let lengths: Vec<u32> = arrays.iter().filter_map(length).collect();
            if lengths.len() != arrays.len() || lengths.iter().any(|n| *lo == 0 && hi == n) {
                continue;
            }
            let left_out = arrays.iter().zip(&lengths).find_map(|(array, n)| match (*lo, *hi) {
                _ if *n < 3 => None,
                (0, hi) if hi + 1 == *n => Some((array, hi, "last", n)),
                (1, hi) if hi == *n => Some((array, 0, "first", n)),
                _ => None,
            });
            let Some((array, index, which, n)) = left_out else { continue };
            // Another range that is for this end of the array.
            let other = |it: &Indexing| {
                it.arrays.contains(array) && (it.lo..it.hi).contains(&index) && 2 * it.hi.saturating_sub(it.lo) <= *n
            };
            let elsewhere = facts.statements.iter().flat_map(|s| &s.uses.indexing).any(other);
            if elsewhere || named.contains(&(array.clone(), index)) {
                continue;
            }
            let end = at[usize::from(index > 0)];
            let Some(place) = linted.place.span(end) else { continue };
            let message = format!("this range leaves out `{array}[{index}]`, the {which} of {n}");
            let mended = if index > 0 { n.to_string() } else { "0".to_owned() };
            let d = Diagnostic::new(codes::W0307, place, message)
                .note("`lo..hi` contains the whole numbers from lo up to, but not including, hi; indices begin at 0");
            let title = format!("write `{mended}`");
            out.push(d.fix(Applicability::Unsafe, title, place, mended));
        }
    }
}
