//! What one statement says of the names and texts of a program: a summary that depends on the statement alone, from
//! which the warnings about a whole program are made.

use super::ends::{self, Indexing};
use super::scope::{Binder, Scopes};
use super::shape;
use crate::ast::{BinaryOp, ExprId, ExprKind, Name, Quantifier, Stmt, StmtKind};
use crate::items::whole_number;
use crate::natives::{BuiltIn, Role};
use crate::program::Comparison;
use rustc_hash::FxHashSet;
use scenelang_base::TextRange;
use smol_str::SmolStr;

/// Properties that are text, of objects and of regions.
const TEXTS: [&str; 9] =
    ["category", "color", "material", "features", "role", "floorColor", "floorMaterial", "wallColor", "wallMaterial"];

/// The summary. Places are relative to the statement.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uses {
    /// Names of the program in its expressions, each once, at its first place. What it assigns is not among them.
    pub names: Vec<Name>,
    /// Whether it says something of all objects: `objects` without a filter.
    pub all: bool,
    /// Filters of `objects`: the outermost `where`.
    pub filters: Vec<ExprId>,
    /// Predicates and functions that it calls, each once.
    pub calls: Vec<SmolStr>,
    /// Whether it draws a random number itself.
    pub draws: bool,
    /// Whether a part of it did not parse.
    pub broken: bool,
    /// Names that it binds.
    pub bound: Vec<Name>,
    /// Text that it assigns to a property, or compares one with.
    pub texts: Vec<Text>,
    /// Text properties that it reads outside of filters.
    pub reads: Vec<Read>,
    /// Quantifiers over `objects` or over a filtered set.
    pub quantifiers: Vec<ExprId>,
    /// Equal for statements that say the same, where a repetition says nothing new.
    pub shape: Option<u64>,
    /// Conjuncts `not inside(a, r)` of an assertion: the name in the place of a, if there is one, and that in the place
    /// of r.
    pub kept_out: Vec<(Option<SmolStr>, SmolStr, TextRange)>,
    /// The names in each other conjunct of an assertion that calls a predicate.
    pub together: Vec<Vec<SmolStr>>,
    /// Quantifiers whose variable goes through indices of arrays.
    pub indexing: Vec<Indexing>,
    /// Elements of arrays that it names: array and index.
    pub elements: Vec<(SmolStr, u32)>,
}

/// A text beside a property.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Its value.
    pub text: SmolStr,
    /// The literal.
    pub range: TextRange,
    pub property: SmolStr,
    /// Compared with it, or else assigned to it.
    pub compared: bool,
}

/// A text property that is read.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// Whose: an object, array or region, and the element if it is a certain one; `None`: of some object.
    pub of: Option<(SmolStr, Option<u32>)>,
    pub property: SmolStr,
    /// All of the expression.
    pub range: TextRange,
}

/// Summarises a statement.
pub fn uses(stmt: &Stmt) -> Uses {
    let scopes = Scopes::of(stmt);
    let mut out = Uses { bound: scopes.bound.iter().map(|n| (*n).clone()).collect(), ..Uses::default() };
    out.shape = match stmt.kind {
        StmtKind::Assert { .. } | StmtKind::Allow { .. } => shape::statement(stmt, &shape::hashes(stmt)),
        _ => None,
    };
    let (seen, called, filtered) = (FxHashSet::default(), FxHashSet::default(), FxHashSet::default());
    let mut gather = Gather { stmt, scopes: &scopes, seen, called, filtered, out };
    for id in &scopes.order {
        gather.expr(*id);
    }
    (gather.out.indexing, gather.out.elements) = ends::of(stmt, &scopes);
    if let StmtKind::Assign { name, index: Some(index), .. } = &stmt.kind {
        let index = whole_number(stmt, *index).filter(|i| *i >= 0.0);
        gather.out.elements.extend(index.map(|i| (name.text.clone(), i as u32)));
    }
    match &stmt.kind {
        StmtKind::Assign { path, value, .. } => {
            if let ([property], ExprKind::Text(text)) = (path.as_slice(), &stmt.expr(*value).kind) {
                gather.text(text, *value, &property.text, false);
            }
        }
        StmtKind::Assert { formula } => gather.conjuncts(*formula),
        // Whoever lets everything overlap something speaks of that thing only.
        StmtKind::Allow { .. } => {
            gather.out.all = false;
            gather.out.filters.clear();
        }
        StmtKind::Error => gather.out.broken = true,
        _ => {}
    }
    gather.out
}

struct Gather<'a> {
    stmt: &'a Stmt,
    scopes: &'a Scopes<'a>,
    seen: FxHashSet<&'a str>,
    called: FxHashSet<&'a str>,
    /// Sets that a filter takes from.
    filtered: FxHashSet<u32>,
    out: Uses,
}

impl<'a> Gather<'a> {
    fn kind(&self, id: ExprId) -> &'a ExprKind {
        &self.stmt.expr(id).kind
    }

    fn expr(&mut self, id: ExprId) {
        let range = self.stmt.expr(id).range;
        match self.kind(id) {
            ExprKind::Name(name) if self.scopes.binder(id).is_none() => self.name(name, range),
            ExprKind::Objects => {
                // The set of all, unless something is declared by that name.
                self.name("objects", range);
                self.out.all |= !self.filtered.contains(&id.0);
            }
            ExprKind::Where(..) => self.filter(id),
            ExprKind::Call(name, _) => {
                self.out.draws |= crate::natives::is_draw(&name.text);
                if self.called.insert(&name.text) {
                    self.out.calls.push(name.text.clone());
                }
            }
            ExprKind::Quantified(_, _, domain, _) => {
                if matches!(self.kind(*domain), ExprKind::Objects | ExprKind::Where(..)) {
                    self.out.quantifiers.push(id);
                }
            }
            ExprKind::Compare(left, steps) => {
                if let [(Comparison::Eq | Comparison::Ne, _, right)] = steps.as_slice() {
                    self.compared(*left, *right);
                    self.compared(*right, *left);
                }
            }
            ExprKind::Member(of, property) if TEXTS.contains(&property.text.as_str()) => {
                if let Some(of) = self.owner(*of) {
                    self.out.reads.push(Read { of, property: property.text.clone(), range });
                }
            }
            ExprKind::Error => self.out.broken = true,
            _ => {}
        }
    }

    fn name(&mut self, name: &'a str, range: TextRange) {
        if self.seen.insert(name) {
            self.out.names.push(Name { text: name.into(), range });
        }
    }

    fn text(&mut self, text: &str, at: ExprId, property: &SmolStr, compared: bool) {
        let range = self.stmt.expr(at).range;
        self.out.texts.push(Text { text: text.into(), range, property: property.clone(), compared });
    }

    fn compared(&mut self, literal: ExprId, with: ExprId) {
        if let (ExprKind::Text(text), ExprKind::Member(_, property) | ExprKind::Own(property)) =
            (self.kind(literal), self.kind(with))
        {
            self.text(text, literal, &property.text, true);
        }
    }

    /// A filter of all objects; of filters of filters the outermost, which is met first.
    fn filter(&mut self, id: ExprId) {
        let mut at = id;
        let outermost = !self.filtered.contains(&id.0);
        while let ExprKind::Where(set, _) = self.kind(at) {
            at = *set;
            self.filtered.insert(at.0);
        }
        if outermost && *self.kind(at) == ExprKind::Objects {
            self.out.filters.push(id);
        }
    }

    /// Whose property it is, as far as the statement tells.
    fn owner(&self, id: ExprId) -> Option<Option<(SmolStr, Option<u32>)>> {
        match self.kind(id) {
            ExprKind::Index(base, index) => {
                let element = whole_number(self.stmt, *index).filter(|i| *i >= 0.0).map(|i| i as u32);
                Some(Some((self.base_name(*base)?, element)))
            }
            ExprKind::Name(name) => match self.scopes.binder(id) {
                None => Some(Some((name.clone(), None))),
                Some(Binder::Parameter(_)) => None,
                Some(Binder::Quantifier(quantifier)) => {
                    let ExprKind::Quantified(_, _, domain, _) = self.kind(quantifier) else { return None };
                    match self.kind(*domain) {
                        ExprKind::Objects => Some(None),
                        ExprKind::Where(set, _) if *self.kind(*set) == ExprKind::Objects => Some(None),
                        _ => Some(Some((self.base_name(*domain)?, None))),
                    }
                }
            },
            _ => None,
        }
    }

    /// The name of the program behind an object: `lamp`, `chair[1]`, the variable of a quantifier over `chair`.
    fn base_name(&self, id: ExprId) -> Option<SmolStr> {
        let mut at = id;
        loop {
            at = match self.kind(at) {
                ExprKind::Index(base, _) | ExprKind::Where(base, _) => *base,
                ExprKind::Name(name) => match self.scopes.binder(at) {
                    None => return Some(name.clone()),
                    Some(Binder::Parameter(_)) => return None,
                    Some(Binder::Quantifier(quantifier)) => match self.kind(quantifier) {
                        ExprKind::Quantified(_, _, domain, _) => *domain,
                        _ => return None,
                    },
                },
                _ => return None,
            };
        }
    }

    /// What an assertion asserts at top level: conjuncts, also under `forall`.
    fn conjuncts(&mut self, formula: ExprId) {
        let mut open = vec![formula];
        while let Some(id) = open.pop() {
            match self.kind(id) {
                ExprKind::Binary(BinaryOp::And, _, left, right) => open.extend([*right, *left]),
                ExprKind::Quantified(Quantifier::Forall, _, _, body) => open.push(*body),
                ExprKind::Not(inner) => {
                    if let ExprKind::Call(name, args) = self.kind(*inner)
                        && BuiltIn::named(&name.text).is_some_and(|b| b.role() == Role::Containment)
                        && let [object, region] = args.as_slice()
                        && let ExprKind::Name(region) = self.kind(*region)
                    {
                        let place = self.stmt.expr(id).range;
                        self.out.kept_out.push((self.base_name(*object), region.clone(), place));
                    }
                }
                ExprKind::Call(_, args) => {
                    let names: Vec<SmolStr> = args.iter().filter_map(|a| self.base_name(*a)).collect();
                    self.out.together.extend((names.len() > 1).then_some(names));
                }
                _ => {}
            }
        }
    }
}
