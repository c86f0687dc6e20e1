//! `--core`: what a statement uses beyond the published grammar. The outermost construct is reported, once.
//!
//! The core tells conditions from values: a condition is no operand of a comparison and is not assigned, a predicate
//! takes names, and components are taken of properties and variables only.

use crate::ast::{Allow, BinaryOp, Expr, ExprId, ExprKind, Name, Quantifier, Stmt, StmtKind};
use crate::check::Where;
use scenelang_base::codes::{E0002, E0207, E0208, E0211};
use scenelang_base::{Diagnostic, TextRange};

/// Properties that the core has.
const PROPERTIES: [&str; 8] = ["pos", "rot", "scale", "color", "material", "features", "category", "dimensions"];
/// Components of vectors and rotations.
const COMPONENTS: [&str; 3] = ["x", "y", "z"];
/// Functions that the core has.
const FUNCTIONS: [&str; 4] = ["rand", "vec3", "rot", "dot"];
/// Predicates that the core has.
const PREDICATES: [&str; 2] = ["inside", "collides"];

/// What is wrong with a statement as core language: what the types tell (`found`), and what is outside the core. One
/// error for one mistake: what the whole language does not have is told as such, and what is outside the core is not looked
/// at more closely.
pub fn check(stmt: &Stmt, mut found: Vec<Diagnostic<Where>>) -> Vec<Diagnostic<Where>> {
    let here = |d: &Diagnostic<Where>| match d.primary.as_ref()?.place {
        Where::Here(range) => Some(range),
        Where::Item(_) | Where::Predicate(_) => None,
    };
    for beyond in check_core(stmt) {
        let beyond = beyond.map_places(Where::Here);
        let Some(outer) = here(&beyond) else { continue };
        // `a.foo` ends with the property, `foo(a)` begins with the function.
        let unknown = found.iter().any(|d| {
            here(d).is_some_and(|inner| match d.code {
                E0207 => inner.end == outer.end && inner.start > outer.start,
                E0208 => inner.start == outer.start,
                E0211 => inner == outer,
                _ => false,
            })
        });
        if !unknown {
            found.retain(|d| !here(d).is_some_and(|inner| outer.start <= inner.start && inner.end <= outer.end));
            found.push(beyond);
        }
    }
    found
}

/// Reports every construct of a statement that is outside the core language.
pub fn check_core(stmt: &Stmt) -> Vec<Diagnostic<TextRange>> {
    let mut check = Check { stmt, found: Vec::new() };
    if let (Some(place), false) = (stmt.attributes, stmt.requirements.is_empty()) {
        check.report(place, "`@req` is");
    }
    match &stmt.kind {
        StmtKind::Declare { name, size: Some(size), .. } => {
            let end = stmt.expr(*size).range.end.max(stmt.range.end);
            check.report(TextRange { start: name.range.start, end }, "arrays are");
        }
        StmtKind::Assign { index, path, target, value, .. } => {
            if index.is_some() {
                check.report(*target, "elements of arrays are");
            } else if let Some(property) = path.iter().find(|p| !is_core_property(p) && !is_component(p)) {
                check.report(*target, &format!("the property `{}` is", property.text));
            }
            check.value(*value);
        }
        StmtKind::Assert { formula } => check.condition(*formula),
        StmtKind::Prefer { .. } => check.report(stmt.range, "`prefer` is"),
        StmtKind::Allow { rule: Allow::Float, .. } => check.report(stmt.range, "`allowFloat` is"),
        StmtKind::Allow { args, .. } => check.names(args),
        StmtKind::Predicate { .. } => check.report(stmt.range, "`predicate` is"),
        StmtKind::Import { .. } => check.report(stmt.range, "`import` is"),
        StmtKind::Declare { size: None, .. } | StmtKind::Empty | StmtKind::Error => {}
    }
    check.found
}

struct Check<'s> {
    stmt: &'s Stmt,
    found: Vec<Diagnostic<TextRange>>,
}

impl<'s> Check<'s> {
    fn report(&mut self, place: TextRange, what: &str) {
        self.found.push(Diagnostic::new(E0002, place, format!("{what} not part of the core language")));
    }

    fn expr(&self, id: ExprId) -> &'s Expr {
        self.stmt.expr(id)
    }

    /// Looks at a condition. Whether a value stands in its place is for the types to tell. The parser bounds the depth.
    fn condition(&mut self, id: ExprId) {
        match &self.expr(id).kind {
            ExprKind::Binary(BinaryOp::And | BinaryOp::Or, _, left, right) => {
                self.condition(*left);
                self.condition(*right);
            }
            ExprKind::Not(inner) => self.condition(*inner),
            ExprKind::Compare(first, steps) => {
                self.value(*first);
                steps.iter().for_each(|(_, _, right)| self.value(*right));
            }
            ExprKind::Call(name, args) if PREDICATES.contains(&name.text.as_str()) => self.names(args),
            _ => self.value(id),
        }
    }

    /// Looks at a value and, if it is core itself, at its parts.
    fn value(&mut self, id: ExprId) {
        let expr = self.expr(id);
        let what = match &expr.kind {
            ExprKind::Number(_, Some(_)) => "numbers with units are".to_owned(),
            ExprKind::Objects => "`objects` is".to_owned(),
            ExprKind::Member(_, name) if !is_core_property(name) && !is_component(name) => {
                format!("the property `{}` is", name.text)
            }
            ExprKind::Member(of, name) if !self.is_named(*of, is_component(name)) => {
                // What it is taken of may be outside the core itself; then that is the news.
                let before = self.found.len();
                self.value(*of);
                if self.found.len() > before {
                    return;
                }
                format!("`.{}` after something that is neither a name nor a property is", name.text)
            }
            ExprKind::Own(_) | ExprKind::Where(..) => "set filters are".to_owned(),
            ExprKind::Index(..) => "elements of arrays are".to_owned(),
            ExprKind::Binary(BinaryOp::Implies, ..) => "`implies` is".to_owned(),
            ExprKind::Quantified(Quantifier::Forall, ..) => "`forall` is".to_owned(),
            ExprKind::Quantified(Quantifier::Exists, ..) => "`exists` is".to_owned(),
            ExprKind::Quantified(Quantifier::Count, ..) => "`count` is".to_owned(),
            ExprKind::Range(..) => "ranges are".to_owned(),
            ExprKind::Binary(BinaryOp::And | BinaryOp::Or, ..) | ExprKind::Not(_) | ExprKind::Compare(..) => {
                "conditions as values are".to_owned()
            }
            ExprKind::Call(name, _) if PREDICATES.contains(&name.text.as_str()) => {
                "conditions as values are".to_owned()
            }
            ExprKind::Call(name, _) if !FUNCTIONS.contains(&name.text.as_str()) => format!("`{}` is", name.text),
            kind => {
                kind.for_each_child(|child| self.value(child));
                return;
            }
        };
        self.report(expr.range, &what);
    }

    /// Looks at arguments that must be names.
    fn names(&mut self, args: &[ExprId]) {
        for arg in args {
            let before = self.found.len();
            self.value(*arg);
            let named = matches!(self.expr(*arg).kind, ExprKind::Name(_) | ExprKind::Error);
            if !named && self.found.len() == before {
                self.report(self.expr(*arg).range, "arguments that are not names are");
            }
        }
    }

    /// Whether it is a name, or (if `deeper`) a property of one.
    fn is_named(&self, id: ExprId, deeper: bool) -> bool {
        match &self.expr(id).kind {
            ExprKind::Name(_) | ExprKind::Error => true,
            ExprKind::Member(of, name) => deeper && is_core_property(name) && self.is_named(*of, false),
            _ => false,
        }
    }
}

fn is_core_property(name: &Name) -> bool {
    PROPERTIES.contains(&name.text.as_str())
}

fn is_component(name: &Name) -> bool {
    COMPONENTS.contains(&name.text.as_str())
}
