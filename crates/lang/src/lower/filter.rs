//! Filters of sets: what an object must be to stay, told without a layout.

use super::{Builder, Lowered, Lowerer, Poison};
use crate::ast::{ExprId, ExprKind, Stmt};
use crate::program::{Arg, Comparison, Node, NodeId, ObjectId};
use rustc_hash::FxHashMap;
use scenelang_base::{Diagnostic, FileId, TextRange, codes};
use std::rc::Rc;

impl Lowerer<'_, '_> {
    /// Those of a set that pass a filter.
    pub(super) fn filtered(&mut self, set: Rc<[ObjectId]>, condition: ExprId) -> Lowered<Rc<[ObjectId]>> {
        // Guidelines ask the same set for a role once for each object.
        let place = self.f.place.map(|place| (place.file, place.offset, condition));
        if let Some([from, kept]) = place.and_then(|key| self.filtered.get(&key))
            && *from == set
        {
            return Ok(Rc::clone(kept));
        }
        let mut kept = Vec::new();
        for &object in set.iter() {
            if self.keeps(object, condition)? {
                kept.push(object);
            }
        }
        let kept: Rc<[ObjectId]> = kept.into();
        if let Some(key) = place.filter(|_| self.f.place.is_some_and(|p| of_the_object(p.stmt, condition))) {
            self.filtered.insert(key, [set, Rc::clone(&kept)]);
        }
        Ok(kept)
    }

    /// Whether an object passes a filter. A part that depends on the layout is reported where it stands.
    fn keeps(&mut self, object: ObjectId, condition: ExprId) -> Lowered<bool> {
        let outer = self.f.own.replace(object);
        let truth = self.truth(condition);
        self.f.own = outer;
        let truth = truth?;
        if let Some(kept) = self.f.b.known(truth) {
            return Ok(kept);
        }
        let (place, why) = self.unknown(truth);
        let whole = self.f.place.map_or(TextRange::default(), |p| p.stmt.expr(condition).range);
        // A part that stood elsewhere before is shared with it, and bears that place.
        let inside = |range: &TextRange| whole.start <= range.start && range.end <= whole.end;
        let range = if self.f.user.is_some() { place } else { Some(place).filter(inside).unwrap_or(whole) };
        if let Some(span) = self.blame(range) {
            let message = format!("a filter must not depend on the layout, but this depends on {why}");
            let d = Diagnostic::new(codes::E0306, span, message).note(
                "a filter may read color, material, features, category and role; move other conditions after the colon",
            );
            if !self.out.contains(&d) {
                self.out.push(d);
            }
        }
        Err(Poison)
    }

    /// The first part of a condition that is not known without a layout, and what it depends on.
    fn unknown(&self, condition: NodeId) -> (TextRange, String) {
        let mut open = vec![condition];
        while let Some(id) = open.pop() {
            let name = |id: &ObjectId| format!("`{}`", self.program.objects[id.0 as usize].name);
            let why = match self.f.b.node(id) {
                Node::Object(_, object) => name(object),
                Node::Region(_, region) => format!("`{}`", self.program.regions[region.0 as usize].name),
                Node::Variable(id) => {
                    format!("`{}`, which the solver chooses", self.program.variables[id.0 as usize].name)
                }
                Node::Draw(_) => "a random number".to_owned(),
                Node::Choice(..) => "a random choice".to_owned(),
                Node::BuiltIn(_, args) => {
                    let objects = args.iter().filter_map(|a| if let Arg::Object(o) = a { Some(name(o)) } else { None });
                    let objects: Vec<String> = objects.collect();
                    if objects.is_empty() { "it".to_owned() } else { objects.join(" and ") }
                }
                node => {
                    let at = open.len();
                    node.for_each_child(|child| open.push(child));
                    open[at..].reverse();
                    continue;
                }
            };
            return (self.f.b.range(id), why);
        }
        (self.f.b.range(condition), "numbers".to_owned())
    }
}

/// What passed a filter, by where it stands: the set, and what is left of it.
pub(super) type Filtered = FxHashMap<(Option<FileId>, u32, ExprId), [Rc<[ObjectId]>; 2]>;

/// Whether a filter names nothing but properties of the object that it is about.
fn of_the_object(stmt: &Stmt, condition: ExprId) -> bool {
    let kind = &stmt.expr(condition).kind;
    let read = matches!(kind, ExprKind::Own(_) | ExprKind::Text(_) | ExprKind::Bool(_));
    let mut all = read || matches!(kind, ExprKind::Not(_) | ExprKind::Binary(..) | ExprKind::Compare(..));
    kind.for_each_child(|part| all = all && of_the_object(stmt, part));
    all
}

impl Builder {
    /// The truth of a condition that no layout can change; `None` if one might.
    pub(super) fn known(&self, id: NodeId) -> Option<bool> {
        let known = |id: &NodeId| stacker::maybe_grow(64 << 10, 1 << 20, || self.known(*id));
        match self.node(id) {
            Node::Truth(truth) => Some(*truth),
            Node::Not(inner) => known(inner).map(|truth| !truth),
            Node::Iff(a, b) => Some(known(a)? == known(b)?),
            Node::And(list) => list.iter().try_fold(true, |all, id| Some(all && known(id)?)),
            Node::Or(list) => list.iter().try_fold(false, |any, id| Some(any || known(id)?)),
            Node::AtLeast(n, list) => {
                let holding = list.iter().try_fold(0, |count, id| Some(count + u32::from(known(id)?)))?;
                Some(holding >= *n)
            }
            Node::Compare(op, _, a, b) => {
                let (a, b) = (self.constant(*a)?, self.constant(*b)?);
                match op {
                    Comparison::Lt => Some(a < b),
                    Comparison::Le => Some(a <= b),
                    Comparison::Gt => Some(a > b),
                    Comparison::Ge => Some(a >= b),
                    // Equality has a tolerance, and degrees go round.
                    Comparison::Eq | Comparison::Ne => None,
                }
            }
            _ => None,
        }
    }
}
