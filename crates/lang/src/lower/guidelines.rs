//! Guidelines: preferences by predicates of `std/guidelines.scene`.
//!
//! One such statement speaks of many things, and is a constraint for each of them: so a report says which things are as
//! they should be, and a solver gains by each that it puts right. What the program itself says of a guideline counts instead
//! of what the library says: `prefer` with another weight, or a predicate of the same name.

use super::Lowerer;
use crate::ast::{ExprKind, Stmt, StmtKind};
use crate::db::Unit;
use crate::items::Located;
use crate::program::{ConstraintKind, Guideline, Node, NodeId};
use crate::wording::MARK;
use rustc_hash::FxHashSet;
use smol_str::SmolStr;

/// The guidelines of a program.
#[derive(Default)]
pub(super) struct Guidelines {
    /// The predicates that imported files of the library prefer.
    names: FxHashSet<SmolStr>,
    /// Those that the program prefers itself.
    stated: FxHashSet<SmolStr>,
}

/// The predicate that a preference calls, and nothing else.
fn called(stmt: &Stmt) -> Option<&SmolStr> {
    let StmtKind::Prefer { formula, .. } = &stmt.kind else { return None };
    if let ExprKind::Call(name, _) = &stmt.expr(*formula).kind { Some(&name.text) } else { None }
}

impl Guidelines {
    pub(super) fn of(units: &[Unit<'_>]) -> Self {
        let mut found = Self::default();
        for unit in units.iter().filter(|unit| unit.bundled) {
            found.names.extend(unit.places().filter_map(|place| called(place.stmt).cloned()));
        }
        if !found.names.is_empty() {
            for unit in units.iter().filter(|unit| !unit.bundled) {
                found.stated.extend(unit.places().filter_map(|place| called(place.stmt).cloned()));
            }
        }
        found
    }

    /// The guideline that a statement states.
    pub(super) fn name(&self, stmt: &Stmt) -> Option<SmolStr> {
        called(stmt).filter(|name| self.names.contains(*name)).cloned()
    }

    /// Whether the program says itself what a statement of the library says.
    pub(super) fn stated_anew(&self, stmt: &Stmt) -> bool {
        called(stmt).is_some_and(|name| self.stated.contains(name))
    }
}

impl<'a> Lowerer<'a, '_> {
    /// One constraint for each thing that a guideline speaks of; none where it asks for nothing.
    pub(super) fn instances(&mut self, place: Located<'a>, kind: ConstraintKind, name: &SmolStr, root: NodeId) {
        let members = match self.f.b.node(root) {
            Node::Truth(true) => return,
            Node::And(members) => members.to_vec(),
            _ => vec![root],
        };
        let wordings = self.f.wordings.clone();
        let says = self.predicate(name).map_or("", |p| p.place.stmt.doc.as_str());
        let says = says.lines().filter(|line| !line.starts_with(MARK)).collect::<Vec<_>>().join(" ");
        let subjects = std::mem::take(&mut self.f.subjects);
        for member in members {
            self.f.wordings.clone_from(&wordings);
            let before = self.program.constraints.len();
            self.constraint(place, kind, "prefer", member);
            for constraint in &mut self.program.constraints[before..] {
                // The outermost quantifier is the last to be done.
                let of = subjects.iter().rev().find(|(node, _)| *node == member).map(|(_, object)| *object);
                constraint.guideline = Some(Guideline { name: name.clone(), says: says.clone(), of });
            }
        }
    }
}
