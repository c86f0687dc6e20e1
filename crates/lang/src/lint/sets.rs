//! W0302: quantifiers over a set that is empty, as far as the program's texts tell.

use super::facts::Facts;
use super::scope::Scopes;
use super::shape;
use crate::ast::{BinaryOp, ExprId, ExprKind, Quantifier, Stmt, StmtKind};
use crate::check::{Where, constant};
use crate::compile::MAX_ERRORS;
use crate::items::ItemKind;
use crate::natives::STATIC_PROPERTIES;
use crate::program::Comparison;
use rustc_hash::FxHashMap;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, TextRange, codes};
use smol_str::SmolStr;
use std::collections::BTreeSet;

/// So many questions whether an object passes a filter are asked; what is left is not reported. A program that people
/// write needs a few thousand.
const MOST: usize = 50_000;

/// Ranges of constants that hold no number.
pub fn ranges(stmt: &Stmt, scopes: &Scopes<'_>, out: &mut Vec<Diagnostic<Where>>) {
    for id in &scopes.order {
        let expr = stmt.expr(*id);
        if let ExprKind::Quantified(quantifier, _, domain, _) = &expr.kind
            && let ExprKind::Range(lo, hi) = &stmt.expr(*domain).kind
            && let (Some(lo), Some(hi)) = (constant::number(stmt, *lo), constant::number(stmt, *hi))
            && lo >= hi
        {
            let d =
                Diagnostic::new(codes::W0302, Where::Here(expr.range), consequence(*quantifier, "this range is empty"));
            out.push(d.note("`lo..hi` contains the whole numbers from lo up to, but not including, hi"));
        }
    }
}

/// What follows from an empty domain.
fn consequence(quantifier: Quantifier, why: &str) -> String {
    match quantifier {
        Quantifier::Forall => format!("{why}, so `forall` always holds"),
        Quantifier::Exists => format!("{why}, so `exists` always fails"),
        Quantifier::Count => format!("{why}, so `count` is always 0"),
    }
}

/// Quantifiers over filtered objects that no object passes. Not in predicates of imported files, and not without any
/// object: such files are made for programs that have them.
pub fn empty(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let things = things(facts);
    if things.is_empty() {
        return;
    }
    // A filter of all objects need not look at two that have the same texts.
    let mut kinds: Vec<Texts<'_>> = things.iter().map(|(_, texts)| *texts).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let mut given = None;
    let (mut asked, mut guessed) = (0, 0);
    // Filters of the whole set that were asked before.
    let mut known: FxHashMap<(u64, bool), bool> = FxHashMap::default();
    for linted in facts.statements.iter().filter(|s| s.sound && s.place.file == facts.main) {
        let stmt = linted.place.stmt;
        let hashes = if linted.uses.quantifiers.is_empty() { Vec::new() } else { shape::hashes(stmt) };
        for id in &linted.uses.quantifiers {
            let ExprKind::Quantified(quantifier, _, domain, _) = &stmt.expr(*id).kind else { continue };
            let mut filters = Vec::new();
            let mut base = *domain;
            while let ExprKind::Where(set, filter) = &stmt.expr(base).kind {
                filters.push(*filter);
                base = *set;
            }
            let predicate = matches!(stmt.kind, StmtKind::Predicate { .. });
            let of = match &stmt.expr(base).kind {
                ExprKind::Objects if facts.names.item("objects").is_none() => None,
                // In a predicate it may be a parameter.
                ExprKind::Name(name) if !predicate => Some(name),
                _ => continue,
            };
            let own: Vec<Texts<'_>>;
            let chosen = match of {
                None => &kinds,
                Some(name) => {
                    let start = things.partition_point(|(n, _)| *n < name);
                    own = things[start..].iter().take_while(|(n, _)| *n == name).map(|(_, texts)| *texts).collect();
                    &own
                }
            };
            if chosen.is_empty() {
                continue;
            }
            let is_empty = *known.entry((hashes[domain.0 as usize], predicate)).or_insert_with(|| {
                let mut passes = |texts: &Texts<'_>| {
                    asked += 1;
                    asked > MOST || filters.iter().all(|f| keeps(facts, stmt, *f, texts) != Some(false))
                };
                !chosen.iter().any(&mut passes)
            });
            if is_empty && let Some(at) = linted.place.span(stmt.expr(*id).range) {
                let message = consequence(*quantifier, "no object matches this filter");
                let mut d = Diagnostic::new(codes::W0302, at, message);
                let given = given.get_or_insert_with(|| given_texts(facts));
                guessed += 1;
                if guessed <= MAX_ERRORS
                    && let Some((range, near)) = filters.iter().find_map(|f| misspelt(given, stmt, *f))
                    && let Some(at) = linted.place.span(range)
                {
                    let title = format!("write \"{near}\"");
                    d = d.fix(Applicability::Unsafe, title, at, format!("\"{near}\""));
                }
                out.push(d);
            }
        }
    }
}

/// What a filter sees of an object, in the order of [`STATIC_PROPERTIES`]; `None`: cannot be told.
type Texts<'a> = [Option<&'a str>; STATIC_PROPERTIES.len()];

/// Objects by name, each with its texts. The elements of an array that have nothing of their own are one.
fn things<'a>(facts: &Facts<'a>) -> Vec<(&'a SmolStr, Texts<'a>)> {
    let mut out = Vec::new();
    for (name, _) in &facts.order {
        let name = &name.text;
        let texts = |element: Option<u32>| STATIC_PROPERTIES.map(|property| facts.text(name, element, property));
        match facts.names.item(name) {
            Some(ItemKind::Array(n)) => {
                let own = facts.own_elements(name);
                let others = (own.len() < n as usize).then_some(u32::MAX);
                out.extend(own.into_iter().chain(others).map(|i| (name, texts(Some(i)))));
            }
            Some(ItemKind::Object) => out.push((name, texts(None))),
            Some(ItemKind::Region | ItemKind::Variable(_)) | None => {}
        }
    }
    out.sort();
    out
}

/// Whether some filter of all objects keeps, or may keep, one that has no text at all.
pub fn keep_blank(facts: &Facts<'_>) -> bool {
    facts.statements.iter().any(|s| {
        s.uses.filters.iter().any(|outermost| {
            let mut at = *outermost;
            while let ExprKind::Where(set, filter) = &s.place.stmt.expr(at).kind {
                if keeps(facts, s.place.stmt, *filter, &[Some(""); STATIC_PROPERTIES.len()]) == Some(false) {
                    return false;
                }
                at = *set;
            }
            true
        })
    })
}

/// Whether a filter keeps an object; `None`: cannot be told from the texts of the program.
fn keeps(facts: &Facts<'_>, stmt: &Stmt, filter: ExprId, texts: &Texts<'_>) -> Option<bool> {
    let keeps = |id: ExprId| stacker::maybe_grow(64 << 10, 1 << 20, || keeps(facts, stmt, id, texts));
    match &stmt.expr(filter).kind {
        ExprKind::Bool(value) => Some(*value),
        ExprKind::Not(inner) => keeps(*inner).map(|kept| !kept),
        ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or | BinaryOp::Implies), _, left, right) => {
            let left = keeps(*left).map(|kept| kept != (*op == BinaryOp::Implies));
            let decides = *op != BinaryOp::And;
            if left == Some(decides) {
                return Some(decides);
            }
            match keeps(*right) {
                Some(right) if right == decides => Some(decides),
                Some(right) => left.map(|_| right),
                None => None,
            }
        }
        ExprKind::Compare(left, steps) => {
            let [(op @ (Comparison::Eq | Comparison::Ne), _, right)] = steps.as_slice() else { return None };
            let (left, right) = (text(facts, stmt, *left, texts)?, text(facts, stmt, *right, texts)?);
            Some((left == right) == (*op == Comparison::Eq))
        }
        _ => None,
    }
}

/// The text that an expression in a filter stands for.
fn text<'a>(facts: &Facts<'a>, stmt: &'a Stmt, id: ExprId, texts: &Texts<'a>) -> Option<&'a str> {
    match &stmt.expr(id).kind {
        ExprKind::Text(text) => Some(text),
        ExprKind::Own(property) => texts[STATIC_PROPERTIES.iter().position(|p| *p == property.text)?],
        // A parameter is no variable of the program; in a predicate it may hide one.
        ExprKind::Name(name) if !matches!(stmt.kind, StmtKind::Predicate { .. }) => facts.variable(name),
        _ => None,
    }
}

/// The texts that objects are given, by property.
type Given<'a> = FxHashMap<&'a str, BTreeSet<&'a str>>;

fn given_texts<'a>(facts: &Facts<'a>) -> Given<'a> {
    let mut given = Given::default();
    for text in facts.statements.iter().flat_map(|s| &s.uses.texts).filter(|t| !t.compared) {
        given.entry(&text.property).or_default().insert(&text.text);
    }
    given
}

/// A text in a filter that no object has, where one has nearly the same: the literal, and what was meant.
fn misspelt<'a>(given: &Given<'a>, stmt: &Stmt, filter: ExprId) -> Option<(TextRange, &'a str)> {
    let mut open = vec![filter];
    while let Some(id) = open.pop() {
        let kind = &stmt.expr(id).kind;
        if let ExprKind::Compare(left, steps) = kind
            && let [(Comparison::Eq, _, right)] = steps.as_slice()
        {
            let (left, right) = (stmt.expr(*left), stmt.expr(*right));
            let (property, literal, text) = match (&left.kind, &right.kind) {
                (ExprKind::Own(property), ExprKind::Text(text)) => (property, right, text.as_str()),
                (ExprKind::Text(text), ExprKind::Own(property)) => (property, left, text.as_str()),
                _ => continue,
            };
            let given = given.get(property.text.as_str());
            let near = given.filter(|g| !g.contains(text)).and_then(|g| nearest(text, g.iter().copied()));
            if let Some(near) = near {
                return Some((literal.range, near));
            }
        }
        kind.for_each_child(|child| open.push(child));
    }
    None
}
