//! Stated constraints: assertions, preferences, assignments.

use super::describe::{declarations, measured};
use super::{CheckVerdict, Judged, Subject};
use crate::builtins::declared;
use crate::eval::{Cause, EvalError, Scratch, Value, objects_of};
use crate::explain::{self, Explanation};
use crate::report::model::RowKind;
use crate::world::World;
use rustc_hash::FxHashSet;
use scenelang_base::{Diagnostic, Span};
use scenelang_lang::program::{Constraint, ConstraintKind, Guideline, Node, NodeId, ObjectId, Program};

/// So many findings are listed; the rows say the rest.
const MOST: usize = 100;

pub(super) fn judge(program: &Program, world: &World<f64>, verdict: &mut CheckVerdict) {
    let mut scratch = Scratch::new();
    let mut errors = Vec::new();
    for index in 0..program.constraints.len() {
        let (row, error) = judge_one(program, world, &mut scratch, index);
        errors.extend(error.map(|e| (index, e)));
        verdict.summary.stated(row.kind).add(row.satisfied);
        verdict.rows.push(row);
    }
    verdict.diagnostics.extend(diagnostics(program, errors));
}

/// The row of a constraint and, if it cannot be judged, why.
pub fn judge_one(
    program: &Program,
    world: &World<f64>,
    scratch: &mut Scratch<f64>,
    index: usize,
) -> (Judged, Option<EvalError>) {
    let constraint = &program.constraints[index];
    let (kind, weight) = match constraint.kind {
        ConstraintKind::Assert => (RowKind::Assert, None),
        ConstraintKind::Prefer { weight } => (RowKind::Prefer, Some(weight)),
        ConstraintKind::Pin => (RowKind::Pin, None),
    };
    let mut row = Judged {
        kind,
        subject: Subject::Statement(index),
        satisfied: None,
        margin: None,
        objects: Vec::new(),
        text: constraint.text.clone(),
        measured: String::new(),
        place: constraint.span,
        related: Vec::new(),
        weight,
        guideline: constraint.guideline.as_ref().map(|guideline| guideline.name.clone()),
        requirements: constraint.requirements.clone(),
        code: kind.code(),
        explanation: None,
    };
    match scratch.evaluate(&constraint.formula, world) {
        Ok(Value::Truth(truth)) => {
            let deciding = scratch.deciding(&constraint.formula);
            row.satisfied = Some(truth.holds);
            row.margin = truth.margin.is_finite().then_some((truth.margin, truth.unit));
            row.objects = objects(constraint, deciding);
            if !truth.holds || world.options.detail.sentences {
                row.measured = match &constraint.guideline {
                    Some(guideline) if !truth.holds => against(program, guideline),
                    _ => measured(program, world, constraint, scratch, deciding, truth.holds),
                };
            }
            if !truth.holds {
                row.related = declarations(program, world, &row.objects);
                let measured = explain::of_statement(world, &constraint.formula, scratch, deciding);
                row.explanation = Some(Box::new(Explanation { measured, ..Explanation::default() }));
                // What is wrong is called the same whether a rule or a statement forbids it.
                let violation = match constraint.formula.node(deciding) {
                    Node::BuiltIn(built_in, _) => declared(*built_in).violation,
                    _ => None,
                };
                if kind == RowKind::Assert && truth_of(scratch, deciding) {
                    row.code = violation.unwrap_or(row.code);
                }
            }
            (row, None)
        }
        Ok(other) => unreachable!("a constraint that is not a truth value: {other:?}"),
        Err(error) => {
            row.objects = objects(constraint, error.node);
            row.measured = format!("cannot be checked: {}", reason(program, error.cause));
            (row, Some(error))
        }
    }
}

/// That a thing does not keep to a guideline. What was measured would be the inside of the library.
fn against(program: &Program, guideline: &Guideline) -> String {
    let of = guideline.of.map_or(String::new(), |id| format!(" for `{}`", program.objects[id.0 as usize].name));
    format!("`{}` does not hold{of}: {}", guideline.name, guideline.says.trim_end_matches('.'))
}

/// What to say of the constraints that cannot be judged, in their order.
pub fn diagnostics(program: &Program, errors: impl IntoIterator<Item = (usize, EvalError)>) -> Vec<Diagnostic> {
    let mut told = FxHashSet::default();
    let say = |(index, error): (usize, EvalError)| {
        diagnostic(&program.constraints[index], error, reason(program, error.cause), &mut told)
    };
    errors.into_iter().filter_map(say).take(MOST).collect()
}

/// Whether a part of the formula held when it was last evaluated.
fn truth_of(scratch: &Scratch<f64>, node: NodeId) -> bool {
    matches!(scratch.get(node), Ok(Value::Truth(truth)) if truth.holds)
}

/// Objects that a part of the formula speaks of; if it speaks of none, those of the whole.
fn objects(constraint: &Constraint, node: NodeId) -> Vec<ObjectId> {
    let own = objects_of(&constraint.formula, node);
    if own.is_empty() { objects_of(&constraint.formula, constraint.formula.root) } else { own }
}

fn reason(program: &Program, cause: Cause) -> String {
    match cause {
        Cause::MissingObject(id) => format!("the layout lacks `{}`", program.objects[id.0 as usize].name),
        Cause::MissingRegion(id) => format!("the layout lacks `{}`", program.regions[id.0 as usize].name),
        Cause::MissingVariable(id) => {
            format!("the layout has no value for `{}`", program.variables[id.0 as usize].name)
        }
        Cause::MissingDraw(id) => format!(
            "the layout does not contain the value drawn here, whose key is `{}`",
            program.draws[id.0 as usize].key
        ),
        Cause::Refused => "a value that it depends on is invalid".to_owned(),
        Cause::DivisionByZero => "this divides by zero".to_owned(),
        Cause::NegativeRoot => "this is the square root of a negative number".to_owned(),
        Cause::ZeroVector => "this takes the direction of a zero vector".to_owned(),
        Cause::NotFinite => "this number is too large".to_owned(),
    }
}

/// The diagnostic of an error, unless the layout's own tell of it; a value that several statements lack is told of once.
fn diagnostic(
    constraint: &Constraint,
    error: EvalError,
    reason: String,
    told: &mut FxHashSet<Cause>,
) -> Option<Diagnostic> {
    let code = error.cause.code()?;
    let shared = matches!(error.cause, Cause::MissingVariable(_) | Cause::MissingDraw(_));
    if shared && !told.insert(error.cause) {
        return None;
    }
    let formula = &constraint.formula;
    let whole = constraint.span;
    let place = formula
        .ranges
        .get(error.node.0 as usize)
        .map(|range| Span { file: whole.file, range: range.shifted(whole.range.start) });
    let place = place.filter(|p| p.range.end <= whole.range.end).unwrap_or(whole);
    Some(Diagnostic::new(code, place, reason))
}
