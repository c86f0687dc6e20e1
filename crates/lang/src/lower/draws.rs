//! Draws: `rand` and `oneOf`. Each occurrence has a key of its own, by which a layout records its value.

use super::{Lowered, Lowerer, Poison, Val};
use crate::ast::ExprId;
use crate::program::*;
use crate::types::Ty;
use scenelang_base::{TextRange, codes};
use smol_str::SmolStr;
use std::rc::Rc;

impl Lowerer<'_, '_> {
    pub(super) fn rand(&mut self, args: &[ExprId], range: TextRange) -> Lowered<Val> {
        let key = self.next_key();
        let mut bounds = Vec::new();
        let mut ty = Ty::Literal;
        for arg in args {
            let Val::Num(n, t) = self.lower(*arg)? else { return Err(Poison) };
            ty = ty.join_numeric(t).ok_or(Poison)?;
            let bound = self.f.b.extract(n);
            let depends = bound
                .nodes
                .iter()
                .any(|n| matches!(n, Node::Object(..) | Node::Region(..) | Node::Variable(_) | Node::BuiltIn(..)));
            if depends {
                let message =
                    "the bounds of `rand` must not depend on the layout, because values are drawn before solving";
                self.error(codes::E0306, range, message);
                return Err(Poison);
            }
            bounds.push(bound);
        }
        let [lo, hi] = <[Formula; 2]>::try_from(bounds).map_err(|_| Poison)?;
        let id = self.draw(key, [lo, hi], false)?;
        Ok(Val::Num(self.f.b.add(Node::Draw(id), range), ty))
    }

    /// What is drawn is the number of an argument, so that a layout records one number whatever is chosen.
    pub(super) fn one_of(&mut self, args: &[ExprId], range: TextRange) -> Lowered<Val> {
        let key = self.next_key();
        let values = args.iter().map(|arg| self.lower(*arg)).collect::<Lowered<Vec<Val>>>()?;
        let bounds = [0, values.len().saturating_sub(1)].map(|bound| {
            let node = self.f.b.number(bound as f64, range);
            self.f.b.extract(node)
        });
        let id = self.draw(key, bounds, true)?;
        let nodes = |of: fn(&Val) -> Option<NodeId>| values.iter().map(of).collect::<Option<Box<[NodeId]>>>();
        match values.first().ok_or(Poison)? {
            Val::Num(..) => {
                let ty = values.iter().try_fold(Ty::Literal, |ty, value| match value {
                    Val::Num(_, own) => ty.join_numeric(*own),
                    _ => None,
                });
                let list = nodes(|value| if let Val::Num(n, _) = value { Some(*n) } else { None });
                let node = self.choose(id, list.ok_or(Poison)?, range);
                Ok(Val::Num(node, ty.ok_or(Poison)?))
            }
            Val::Vec(_) => {
                let list = nodes(|value| if let Val::Vec(n) = value { Some(*n) } else { None }).ok_or(Poison)?;
                // By component: proofs know in which bounds each is.
                let parts = [Axis::X, Axis::Y, Axis::Z].map(|axis| {
                    let of = list.iter().map(|v| self.f.b.component(axis, *v, range)).collect();
                    self.choose(id, of, range)
                });
                Ok(Val::Vec(self.f.b.add(Node::Vector(parts), range)))
            }
            Val::Rot(_) => {
                let list = nodes(|value| if let Val::Rot(n) = value { Some(*n) } else { None }).ok_or(Poison)?;
                Ok(Val::Rot(self.choose(id, list, range)))
            }
            Val::Text(_) | Val::TextOf(..) => self.text_of(id, &values, range),
            _ => Err(Poison),
        }
    }

    fn text_of(&mut self, id: DrawId, values: &[Val], range: TextRange) -> Lowered<Val> {
        let mut texts: Vec<SmolStr> = Vec::with_capacity(values.len());
        for value in values {
            match value {
                Val::Text(text) => texts.push(text.clone()),
                Val::TextOf(..) => {
                    let message =
                        "a text that `oneOf` chooses from must not be drawn itself; list all texts in one `oneOf`";
                    self.error(codes::E0306, range, message);
                    return Err(Poison);
                }
                _ => return Err(Poison),
            }
        }
        Ok(Val::TextOf(id, texts.into()))
    }

    /// Whether two texts, of which one is drawn at least, are the same: a truth without a margin.
    pub(super) fn same_text(&mut self, a: &Val, b: &Val, range: TextRange) -> Lowered<NodeId> {
        match (a, b) {
            (Val::Text(a), Val::Text(b)) => Ok(self.f.b.add(Node::Truth(a == b), range)),
            (Val::TextOf(a, texts), Val::TextOf(b, others)) if a == b => {
                let same = texts.iter().zip(others.iter()).map(|(a, b)| a == b).collect::<Vec<bool>>();
                let list = same.into_iter().map(|same| self.f.b.add(Node::Truth(same), range)).collect();
                Ok(self.choose(*a, list, range))
            }
            (Val::TextOf(id, texts), other) | (other, Val::TextOf(id, texts)) => {
                let (id, texts) = (*id, Rc::clone(texts));
                let each = texts.iter().map(|text| self.same_text(&Val::Text(text.clone()), other, range));
                let list = each.collect::<Lowered<Box<[NodeId]>>>()?;
                Ok(self.choose(id, list, range))
            }
            _ => Err(Poison),
        }
    }

    /// What all of them are depends on no draw.
    fn choose(&mut self, id: DrawId, list: Box<[NodeId]>, range: TextRange) -> NodeId {
        match list.iter().all(|node| *node == list[0]) {
            true => list[0],
            false => self.f.b.add(Node::Choice(id, list), range),
        }
    }

    fn next_key(&mut self) -> String {
        let key = format!("{}/{}", self.f.draw_key, self.f.draw_count);
        self.f.draw_count += 1;
        key
    }

    fn draw(&mut self, key: String, [lo, hi]: [Formula; 2], is_choice: bool) -> Lowered<DrawId> {
        if let Some(id) = self.draws.get(&key) {
            return Ok(*id);
        }
        let id = DrawId(self.program.draws.len() as u32);
        let place = self.f.place.filter(|p| p.file.is_some()).or(self.f.root);
        let span = place.and_then(|p| p.span(p.stmt.range)).ok_or(Poison)?;
        self.program.draws.push(Draw { key: key.clone(), lo, hi, is_choice, span });
        self.draws.insert(key, id);
        Ok(id)
    }
}
