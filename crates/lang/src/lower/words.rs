//! Templates of messages put in place: which comparison of a formula each is for, and what its names stand for there.

use super::{Lowerer, Val};
use crate::ast::{ExprId, StmtKind};
use crate::program::{NodeId, Unit};
use crate::types::Ty;
use crate::wording::{MARK, Named, Template, Wording, templates};
use std::rc::Rc;
use std::sync::Arc;

/// The templates of a predicate, each with the left side of its comparison.
pub(super) type Templates = Rc<[(ExprId, Arc<Template>)]>;

impl Lowerer<'_, '_> {
    /// Notes the template for a comparison with this left side, if the predicate that is being expanded has one. One whose
    /// names stand for nothing that can be said is as good as none.
    pub(super) fn say(&mut self, left: ExprId, node: NodeId) {
        let Some(place) = self.f.place.filter(|p| p.stmt.doc.contains(MARK)) else { return };
        let StmtKind::Predicate { name, .. } = &place.stmt.kind else { return };
        let key = (name.text.clone(), place.file.is_none());
        let known = Rc::clone(self.templates.entry(key).or_insert_with(|| templates(place.stmt).into()));
        let Some((_, template)) = known.iter().find(|(of, _)| *of == left) else { return };
        let named: Option<Box<[Named]>> = template.names.iter().map(|name| self.named(name)).collect();
        if let Some(named) = named.filter(|named| template.fits(named)) {
            self.f.wordings.push(Wording { node, template: Arc::clone(template), named });
        }
    }

    /// What a parameter, or a variable of a quantifier, stands for.
    fn named(&self, name: &str) -> Option<Named> {
        let (_, value) = self.f.scope.iter().rev().find(|(n, _)| n == name)?;
        let unit = |ty: &Ty| if *ty == Ty::Degree { Unit::Degree } else { Unit::Metre };
        Some(match value {
            Val::Object(id) => Named::Object(*id),
            Val::Region(id) => Named::Region(*id),
            Val::Num(node, ty) => match self.f.b.constant(*node) {
                Some(value) => Named::Constant(value, unit(ty)),
                None => Named::Node(*node, unit(ty)),
            },
            _ => return None,
        })
    }
}

/// Wordings of a formula that was taken out of the one under construction, sorted by node. Of several for one node the
/// first stays.
pub(super) fn placed(wordings: Vec<Wording>, places: &[Option<NodeId>]) -> Vec<Wording> {
    let place = |node: NodeId| places.get(node.0 as usize).copied().flatten();
    let moved = |wording: Wording| {
        let named = wording.named.iter().map(|named| match named {
            Named::Node(node, unit) => Some(Named::Node(place(*node)?, *unit)),
            other => Some(*other),
        });
        Some(Wording { node: place(wording.node)?, named: named.collect::<Option<_>>()?, ..wording })
    };
    let mut found: Vec<Wording> = wordings.into_iter().filter_map(moved).collect();
    found.sort_by_key(|wording| wording.node.0);
    found.dedup_by_key(|wording| wording.node);
    found
}
