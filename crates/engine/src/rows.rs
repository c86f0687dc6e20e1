//! Rows and their parts, judged one at a time with any number: what a search for moves asks again and again.

use scenelang_lang::program::{ConstraintKind, NodeId, Program};
use scenelang_verify::check::Subject;
use scenelang_verify::explain::RowRef;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::rules::{Scope, Support, bounds, collide, mounts, open, support};
use scenelang_verify::{Number, Scratch, Truth, Value, World, judge};

/// What is to hold: a row, or a part of a statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Goal {
    Row(RowRef),
    /// A node of the statement's formula.
    Part(usize, NodeId),
}

/// The row of a statement.
pub fn row_of(program: &Program, constraint: usize) -> RowRef {
    let kind = match program.constraints[constraint].kind {
        ConstraintKind::Assert => RowKind::Assert,
        ConstraintKind::Prefer { .. } => RowKind::Prefer,
        ConstraintKind::Pin => RowKind::Pin,
    };
    RowRef { kind, subject: Subject::Statement(constraint) }
}

/// The verdict on a goal in an instance, with any number.
pub(crate) fn truth<N: Number>(
    program: &Program,
    scope: &Scope,
    world: &World<N>,
    scratch: &mut Scratch<N>,
    goal: Goal,
    cone: Option<&[NodeId]>,
) -> Option<Truth<N>> {
    let value = match goal {
        Goal::Part(index, _) => scratch.evaluate_cone(&program.constraints[index].formula, cone?, world).ok()?,
        Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
            scratch.evaluate(&program.constraints[index].formula, world).ok()?
        }
        Goal::Row(RowRef { subject: Subject::Pair(a, b), .. }) => return collide::pair(world, a, b).ok(),
        Goal::Row(RowRef { subject: Subject::Part(id, part), .. }) => return open::part(world, id, part).ok(),
        Goal::Row(RowRef { kind: RowKind::Bounds, subject: Subject::Object(id) }) => {
            let truth = bounds::object(world, id).ok()?;
            return (truth.holds || world.missing_region().is_none()).then_some(truth);
        }
        Goal::Row(RowRef { subject: Subject::Object(id), .. }) => {
            let truth = match scope.support(id) {
                Support::Lifted | Support::Held => Truth::discrete(true),
                Support::Mounted => mounts(&program.allow, id)
                    .filter_map(|mount| judge(&mount.formula, world).ok())
                    .fold(Truth::discrete(false), Truth::or),
                Support::Rests => support::object(world, id).ok()?,
            };
            let complete = world.missing_object().or(world.missing_region()).is_none();
            return (truth.holds || complete).then_some(truth);
        }
    };
    match value {
        Value::Truth(truth) => Some(truth),
        _ => None,
    }
}
