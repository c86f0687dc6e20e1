//! `--core`: what a statement uses beyond the published grammar. The outermost construct is reported, once.

use crate::ast::{Allow, BinaryOp, ExprId, ExprKind, Name, Quantifier, Stmt, StmtKind};
use scenelang_base::codes::E0002;
use scenelang_base::{Diagnostic, TextRange};

/// Properties that the core has.
const PROPERTIES: [&str; 11] =
    ["pos", "rot", "scale", "color", "material", "features", "category", "dimensions", "x", "y", "z"];
/// Functions and predicates that the core has.
const CALLS: [&str; 6] = ["inside", "collides", "rand", "vec3", "rot", "dot"];

/// Reports every construct of a statement that is outside the core language.
pub fn check_core(stmt: &Stmt) -> Vec<Diagnostic<TextRange>> {
    let mut check = Check { stmt, found: Vec::new() };
    if let (Some(place), false) = (stmt.attributes, stmt.requirements.is_empty()) {
        check.report(place, "`@req`");
    }
    match &stmt.kind {
        StmtKind::Declare { name, size: Some(size), .. } => {
            let end = stmt.expr(*size).range.end.max(stmt.range.end);
            check.report(TextRange { start: name.range.start, end }, "an array");
        }
        StmtKind::Assign { index, path, target, value, .. } => {
            if index.is_some() {
                check.report(*target, "an element of an array");
            } else if let Some(property) = path.iter().find(|p| !is_core_property(p)) {
                check.report(*target, &format!("the property `{}`", property.text));
            }
            check.expr(*value);
        }
        StmtKind::Assert { formula } => check.expr(*formula),
        StmtKind::Prefer { .. } => check.report(stmt.range, "`prefer`"),
        StmtKind::Allow { rule: Allow::Float, .. } => check.report(stmt.range, "`allowFloat`"),
        StmtKind::Allow { args, .. } => args.iter().for_each(|arg| check.expr(*arg)),
        StmtKind::Predicate { .. } => check.report(stmt.range, "`predicate`"),
        StmtKind::Import { .. } => check.report(stmt.range, "`import`"),
        StmtKind::Declare { size: None, .. } | StmtKind::Empty | StmtKind::Error => {}
    }
    check.found
}

struct Check<'s> {
    stmt: &'s Stmt,
    found: Vec<Diagnostic<TextRange>>,
}

impl Check<'_> {
    fn report(&mut self, place: TextRange, what: &str) {
        self.found.push(Diagnostic::new(E0002, place, format!("{what} is not in the core language")));
    }

    /// Looks at an expression and, if it is core itself, at its parts. The parser bounds the depth.
    fn expr(&mut self, id: ExprId) {
        let expr = self.stmt.expr(id);
        let what = match &expr.kind {
            ExprKind::Number(_, Some(_)) => "a number with a unit".to_owned(),
            ExprKind::Objects => "`objects`".to_owned(),
            ExprKind::Member(_, name) if !is_core_property(name) => format!("the property `{}`", name.text),
            ExprKind::Own(_) | ExprKind::Where(..) => "a set filter".to_owned(),
            ExprKind::Index(..) => "an element of an array".to_owned(),
            ExprKind::Binary(BinaryOp::Implies, ..) => "`implies`".to_owned(),
            ExprKind::Call(name, _) if !CALLS.contains(&name.text.as_str()) => format!("`{}`", name.text),
            ExprKind::Quantified(Quantifier::Forall, ..) => "`forall`".to_owned(),
            ExprKind::Quantified(Quantifier::Exists, ..) => "`exists`".to_owned(),
            ExprKind::Quantified(Quantifier::Count, ..) => "`count`".to_owned(),
            ExprKind::Range(..) => "a range".to_owned(),
            kind => {
                kind.for_each_child(|child| self.expr(child));
                return;
            }
        };
        self.report(expr.range, &what);
    }
}

fn is_core_property(name: &Name) -> bool {
    PROPERTIES.contains(&name.text.as_str())
}
