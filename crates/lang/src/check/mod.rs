//! Types of statements: what may stand where, said before anything is expanded.

pub mod constant;
pub(crate) mod cycles;
mod expr;

use crate::ast::{Allow, ExprId, ExprKind, Stmt, StmtKind, TypeWord};
use crate::hir::{AssignTarget, Hir, Resolution};
use crate::items::{ItemKind, Names, array_size, whole_number};
use crate::natives::{self, property};
use crate::types::Ty;
use expr::Checker;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, TextRange, codes};
use smol_str::SmolStr;

/// Checks one statement. What is found depends on the statement's text and on what `names` says of the names in it, not
/// on where anything stands.
pub fn statement(names: &dyn Names, stmt: &Stmt) -> Vec<Diagnostic<Where>> {
    let mut checker = Checker::new(names, stmt);
    check(&mut checker, stmt);
    checker.finish()
}

/// What a statement means, written down by the checker on its way.
pub(crate) fn meaning(names: &dyn Names, stmt: &Stmt) -> Hir {
    let mut checker = Checker::new(names, stmt);
    checker.facts = Some(Hir::of_size(stmt.exprs.len()));
    check(&mut checker, stmt);
    // Of sizes, indices and weights the checker wants the value, not the type; of arguments nothing if their number is
    // wrong.
    let rest: Vec<ExprId> = match &stmt.kind {
        StmtKind::Declare { size, .. } => size.iter().copied().collect(),
        StmtKind::Assign { index, .. } => index.iter().copied().collect(),
        StmtKind::Prefer { weight, .. } => weight.iter().copied().collect(),
        StmtKind::Allow { args, .. } => args.clone(),
        _ => Vec::new(),
    };
    for id in rest {
        checker.ty(id);
    }
    checker.into_facts()
}

fn check(checker: &mut Checker<'_, '_>, stmt: &Stmt) {
    match &stmt.kind {
        StmtKind::Assert { formula } => checker.condition(*formula),
        StmtKind::Prefer { formula, weight } => {
            checker.condition(*formula);
            if let Some(weight) = weight {
                check_weight(checker, stmt, *weight);
            }
        }
        StmtKind::Allow { rule, word, args } => check_allow(checker, *rule, *word, args),
        StmtKind::Predicate { name, params, body } => {
            if natives::is_built_in(&name.text) {
                let message = format!("`{}` is built in and cannot be redefined", name.text);
                checker.push(
                    Diagnostic::new(codes::E0209, Where::Here(name.range), message)
                        .note("give the predicate another name"),
                );
            }
            for (i, p) in params.iter().enumerate() {
                if let Some(first) = params[..i].iter().find(|q| q.name.text == p.name.text) {
                    let message = format!("predicate `{}` has two parameters named `{}`", name.text, p.name.text);
                    checker.push(
                        Diagnostic::new(codes::E0202, Where::Here(p.name.range), message)
                            .related(Where::Here(first.name.range), "first declared here"),
                    );
                }
            }
            checker.bind_params(params);
            checker.condition(*body);
        }
        StmtKind::Assign { .. } => check_assign(checker, stmt),
        StmtKind::Declare { ty, size: Some(size), .. } => {
            let range = stmt.expr(*size).range;
            if *ty != TypeWord::Object {
                checker.error(codes::E0212, range, "only objects can be declared as an array");
            } else if let Err(bad) = array_size(stmt, *size) {
                checker.error(codes::E0304, range, bad.message);
            }
        }
        StmtKind::Declare { .. } | StmtKind::Import { .. } | StmtKind::Empty | StmtKind::Error => {}
    }
}

/// A place seen from a statement: in it, or where a name is declared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Where {
    /// Relative to the start of the statement's text.
    Here(TextRange),
    /// The declaration of an object, region or variable.
    Item(SmolStr),
    /// The definition of a predicate of the program.
    Predicate(SmolStr),
}

fn check_weight(checker: &mut Checker<'_, '_>, stmt: &Stmt, weight: ExprId) {
    let range = stmt.expr(weight).range;
    if constant::number(stmt, weight).is_none_or(|w| w <= 0.0) {
        let message = "a weight is a number greater than 0, such as `2`";
        checker.error(codes::E0305, range, message);
    }
}

fn check_allow(checker: &mut Checker<'_, '_>, rule: Allow, word: TextRange, args: &[ExprId]) {
    let (name, wanted) = match rule {
        Allow::Collide => ("allowCollide", 2),
        Allow::Outside => ("allowOutside", 1),
        Allow::Float => ("allowFloat", 1),
    };
    if args.len() != wanted {
        let message = format!(
            "`{name}` takes {}, not {}",
            if wanted == 2 { "two objects or arrays" } else { "one object or array" },
            args.len()
        );
        checker.error(codes::E0303, word, message);
        return;
    }
    for arg in args {
        let ty = checker.ty(*arg);
        if !ty.fits(Ty::Objects) {
            let message = format!("`{name}` takes objects or arrays of objects, but this is {ty}");
            checker.error(codes::E0301, checker.range(*arg), message);
        }
    }
}

fn check_assign(checker: &mut Checker<'_, '_>, stmt: &Stmt) {
    let StmtKind::Assign { name, index, path, target, value } = &stmt.kind else { return };
    let Some(kind) = checker.names.item(&name.text) else {
        checker.unknown_name(name.text.as_str(), name.range);
        checker.ty(*value);
        return;
    };
    if let Some(index) = index {
        match kind {
            ItemKind::Array(n) => {
                if whole_number(stmt, *index).is_none_or(|i| i < 0.0 || i >= f64::from(n)) {
                    checker.index_error(&name.text, n, stmt.expr(*index).range);
                }
            }
            _ => checker.error(codes::E0212, stmt.expr(*index).range, format!("`{}` is not an array", name.text)),
        }
    }
    let owner = match (kind, index) {
        (ItemKind::Array(_), _) | (ItemKind::Object, _) => Ty::Object,
        (kind, _) => kind.ty(),
    };
    let assigned = path.first().and_then(|p| property(owner, &p.text)).filter(|_| path.len() == 1);
    if let Some(facts) = &mut checker.facts {
        let element = |index| Resolution::Element {
            array: name.text.clone(),
            index: whole_number(stmt, index).filter(|i| *i >= 0.0).map(|i| i as u32),
        };
        let whole = || Resolution::Item(name.text.clone(), kind);
        let ty = match (assigned, path.is_empty()) {
            (Some(property), _) => property.ty,
            (None, true) => owner,
            (None, false) => Ty::Error,
        };
        facts.target = Some(AssignTarget { owner: index.map_or_else(whole, element), property: assigned, ty });
    }
    match (owner, path.as_slice()) {
        (Ty::Object | Ty::Region, []) => {
            let message = format!("{owner} cannot be assigned; only its properties can");
            checker.error(codes::E0211, *target, message);
            checker.ty(*value);
        }
        (Ty::Object | Ty::Region, [prop]) => match property(owner, &prop.text) {
            Some(p) if p.assignable => {
                checker.expect(*value, p.ty, &format!("`{}`", p.name));
                if matches!(p.name, "dimensions" | "scale") {
                    check_size(checker, stmt, owner, *value);
                }
            }
            Some(p) => {
                let message = format!("`{}` is derived from other properties and cannot be assigned", p.name);
                let d = Diagnostic::new(codes::E0211, Where::Here(*target), message);
                checker.push(asserted(d, *target, stmt.expr(*value).range));
                checker.ty(*value);
            }
            None if owner == Ty::Region && prop.text == "category" => {
                let d = Diagnostic::new(codes::E0211, Where::Here(*target), "a region has no category");
                checker.push(d.note("use its name to say what it is, and `features` to describe it further"));
                checker.ty(*value);
            }
            None => {
                let table = if owner == Ty::Object { natives::OBJECT_PROPERTIES } else { natives::REGION_PROPERTIES };
                let names = table.iter().filter(|p| p.assignable).map(|p| p.name);
                let message = format!("{owner} has no property `{}` that can be assigned", prop.text);
                let mut d = Diagnostic::new(codes::E0211, Where::Here(*target), message);
                match nearest(&prop.text, names.clone()).or_else(|| synonym(owner, &prop.text)) {
                    Some(near) => {
                        d = d.label(format!("did you mean `{near}`?")).fix(
                            Applicability::Unsafe,
                            format!("write `{near}`"),
                            Where::Here(prop.range),
                            near,
                        );
                    }
                    None => d = d.note(format!("it has: {}", names.collect::<Vec<_>>().join(", "))),
                }
                checker.push(d);
                checker.ty(*value);
            }
        },
        (Ty::Object | Ty::Region, [first, ..]) => {
            let message = format!("only whole properties can be assigned, not a component of `{}`", first.text);
            let d = Diagnostic::new(codes::E0211, Where::Here(*target), message);
            checker.push(asserted(d, *target, stmt.expr(*value).range));
            checker.ty(*value);
        }
        (ty, []) => checker.expect(*value, ty, &format!("`{}`", name.text)),
        (ty, [..]) => {
            let message = format!("`{}` is {ty}; it can only be assigned as a whole", name.text);
            checker.error(codes::E0211, *target, message);
            checker.ty(*value);
        }
    }
    if let (ExprKind::Call(call, _), [prop]) = (&stmt.expr(*value).kind, path.as_slice())
        && call.text == "polygon"
        && prop.text != "vertices"
    {
        checker.error(codes::E0301, call.range, "a polygon can only be assigned to the `vertices` of a region");
    }
}

/// A size that is written in numbers has three sides, each greater than 0. Those of a region along the floor do not count
/// if it has an outline.
fn check_size(checker: &mut Checker<'_, '_>, stmt: &Stmt, owner: Ty, value: ExprId) {
    let ExprKind::Call(call, sides) = &stmt.expr(value).kind else { return };
    if call.text != "vec3" || sides.len() != 3 {
        return;
    }
    for (side, name) in sides.iter().zip(["width", "height", "depth"]) {
        if owner == Ty::Region && name != "height" {
            continue;
        }
        if let Some(length) = constant::number(stmt, *side).filter(|length| *length <= 0.0) {
            let message = format!("a size must be greater than 0, but the {name} is {length}");
            checker.error(codes::E0308, stmt.expr(*side).range, message);
        }
    }
}

/// The assignable property that other languages call by this name.
fn synonym(owner: Ty, name: &str) -> Option<&'static str> {
    Some(match (owner, name) {
        (Ty::Region, "dimensions" | "size" | "extent" | "extents") => "scale",
        (Ty::Object, "size" | "extent" | "extents") => "dimensions",
        (_, "position" | "location" | "translation") => "pos",
        (_, "rotation" | "orientation" | "yaw") => "rot",
        _ => return None,
    })
}

/// What to write instead of an assignment of `target` that cannot be.
fn asserted(d: Diagnostic<Where>, target: TextRange, value: TextRange) -> Diagnostic<Where> {
    let edit = |start, end, text: &str| Edit { place: Where::Here(TextRange { start, end }), text: text.to_owned() };
    let edits = vec![edit(target.start, target.start, "assert "), edit(target.end, value.start, " = ")];
    let title = "assert an equation instead, and the solver will make it true".to_owned();
    Diagnostic { fixes: vec![Fix { title, edits, applicability: Applicability::Unsafe }], ..d }
}
