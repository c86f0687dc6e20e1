//! W0307: ranges of indices that leave out the first or the last element of an array, although they go through all others.

use super::facts::Facts;
use super::scope::{Binder, Scopes};
use crate::ast::{BinaryOp, ExprId, ExprKind, Stmt};
use crate::check::constant;
use crate::items::ItemKind;
use rustc_hash::FxHashSet;
use scenelang_base::{Applicability, Diagnostic, TextRange, codes};
use smol_str::SmolStr;

/// A quantifier over a range of constants whose variable is an index and nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Indexing {
    /// The arrays that it indexes, each once.
    pub arrays: Vec<Indexed>,
    /// Where the ends of the range are written.
    at: [TextRange; 2],
}

/// The elements of an array that a quantifier goes through.
#[derive(Clone, Debug, PartialEq)]
pub struct Indexed {
    name: SmolStr,
    /// From this index up to, but not including, that one.
    lo: u32,
    hi: u32,
    /// How much more than the variable the least and the greatest index are.
    off: [i64; 2],
}

/// The quantifiers of a statement that go through indices, and the elements that it names: array and index. Where a variable
/// is part of the range of another variable, the range may be shorter for good reason.
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
                if let Some(arrays) = indexed(stmt, scopes, *id, [from, to]) {
                    let at = [*lo, *hi].map(|id| stmt.expr(id).range);
                    found.push(Indexing { arrays, at });
                }
            }
            _ => {}
        }
    }
    (found, elements)
}

/// The arrays that the variable of a quantifier indexes (`seat[i]`, `seat[i + 1]`), if that is all that it is used for.
fn indexed(stmt: &Stmt, scopes: &Scopes<'_>, quantifier: ExprId, [lo, hi]: [u32; 2]) -> Option<Vec<Indexed>> {
    let is_variable = |id: ExprId| scopes.binder(id) == Some(Binder::Quantifier(quantifier));
    let whole = |id: ExprId| constant::number(stmt, id).filter(|n| n.fract() == 0.0 && n.abs() < 1e6).map(|n| n as i64);
    let offset = |index: ExprId| match &stmt.expr(index).kind {
        _ if is_variable(index) => Some(0),
        ExprKind::Binary(BinaryOp::Add, _, a, b) if is_variable(*a) => whole(*b),
        ExprKind::Binary(BinaryOp::Add, _, a, b) if is_variable(*b) => whole(*a),
        ExprKind::Binary(BinaryOp::Sub, _, a, b) if is_variable(*a) => whole(*b).map(|n| -n),
        _ => None,
    };
    let mut arrays: Vec<(SmolStr, [i64; 2])> = Vec::new();
    let (mut uses, mut plain) = (0, 0);
    for id in &scopes.order {
        uses += usize::from(is_variable(*id));
        if let ExprKind::Index(array, index) = &stmt.expr(*id).kind
            && let Some(off) = offset(*index)
            && let ExprKind::Name(name) = &stmt.expr(*array).kind
            && scopes.binder(*array).is_none()
        {
            plain += 1;
            match arrays.iter_mut().find(|(known, _)| known == name) {
                Some((_, [least, most])) => (*least, *most) = ((*least).min(off), (*most).max(off)),
                None => arrays.push((name.clone(), [off; 2])),
            }
        }
    }
    let elements = |(name, off): (SmolStr, [i64; 2])| {
        let ends = [i64::from(lo) + off[0], i64::from(hi) + off[1]].map(u32::try_from);
        let [Ok(lo), Ok(hi)] = ends else { return None };
        Some(Indexed { name, lo, hi, off })
    };
    (plain > 0 && uses == plain && lo < hi).then(|| arrays.into_iter().map(elements).collect())?
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
        for Indexing { arrays, at } in &linted.uses.indexing {
            let lengths: Vec<(&Indexed, u32)> =
                arrays.iter().filter_map(|array| Some((array, length(&array.name)?))).collect();
            if lengths.len() != arrays.len() || lengths.iter().any(|(it, n)| it.lo == 0 && it.hi == *n) {
                continue;
            }
            let left_out = lengths.iter().find_map(|(it, n)| match (it.lo, it.hi) {
                _ if *n < 3 => None,
                (0, hi) if hi + 1 == *n => Some((*it, hi, "last", *n)),
                (1, hi) if hi == *n => Some((*it, 0, "first", *n)),
                _ => None,
            });
            let Some((it, index, which, n)) = left_out else { continue };
            // Another range that is for this end of the array.
            let other = |other: &Indexed| {
                let few = 2 * other.hi.saturating_sub(other.lo) <= n;
                other.name == it.name && (other.lo..other.hi).contains(&index) && few
            };
            let mut elsewhere = facts.statements.iter().flat_map(|s| &s.uses.indexing).flat_map(|other| &other.arrays);
            if elsewhere.any(other) || named.contains(&(it.name.clone(), index)) {
                continue;
            }
            let end = at[usize::from(index > 0)];
            let Some(place) = linted.place.span(end) else { continue };
            let message = format!("this range leaves out `{}[{index}]`, the {which} of {n}", it.name);
            let mended = if index > 0 { i64::from(n) - it.off[1] } else { -it.off[0] };
            let d = Diagnostic::new(codes::W0307, place, message)
                .note("`lo..hi` contains the whole numbers from lo up to, but not including, hi; indices begin at 0");
            if mended < 0 {
                out.push(d);
                continue;
            }
            out.push(d.fix(Applicability::Unsafe, format!("write `{mended}`"), place, mended.to_string()));
        }
    }
}
