//! Expansion of expressions. What the checker accepted cannot fail here, but for what only expansion shows: an index
//! out of range, bounds of `rand` that depend on the layout, too much of everything.

use super::{Frame, Lowered, Lowerer, MAX_NODES, MAX_STEPS, Poison, Val};
use crate::ast::{BinaryOp, ExprId, ExprKind, Name, Quantifier, UnitSuffix};
use crate::check::constant::with_unit;
use crate::items::Predicate;
use crate::natives::{self, ROOMS, Role, SIDES};
use crate::program::*;
use crate::types::Ty;
use scenelang_base::{Diagnostic, TextRange, codes};
use smol_str::SmolStr;
use std::rc::Rc;

impl<'a> Lowerer<'a, '_> {
    /// Expands an expression.
    pub(super) fn lower(&mut self, id: ExprId) -> Lowered<Val> {
        self.steps += 1;
        if self.steps > MAX_STEPS || self.nodes + self.f.b.size() > MAX_NODES {
            if let Some(span) = self.f.root.and_then(|p| p.span(p.stmt.range)) {
                self.exhausted(span);
            }
            return Err(Poison);
        }
        if self.exhausted {
            return Err(Poison);
        }
        stacker::maybe_grow(64 << 10, 1 << 20, || self.lower_inner(id))
    }

    fn lower_inner(&mut self, id: ExprId) -> Lowered<Val> {
        let Some(place) = self.f.place else { return Err(Poison) };
        let expr = place.stmt.expr(id);
        let range = self.f.user.unwrap_or(expr.range);
        let top = std::mem::replace(&mut self.f.top, false);
        match &expr.kind {
            ExprKind::Number(x, unit) => {
                let ty = match unit {
                    None => Ty::Literal,
                    Some(UnitSuffix::Deg | UnitSuffix::Rad) => Ty::Degree,
                    Some(_) => Ty::Number,
                };
                Ok(Val::Num(self.f.b.number(with_unit(*x, *unit), range), ty))
            }
            ExprKind::Text(text) => Ok(Val::Text(SmolStr::new(text))),
            ExprKind::Bool(t) => Ok(Val::Truth(self.f.b.add(Node::Truth(*t), range))),
            ExprKind::Name(name) => self.name(name, range),
            ExprKind::Objects => self.name(&SmolStr::new_static("objects"), range),
            ExprKind::Member(base, name) => {
                let base = self.lower(*base)?;
                self.member(base, &name.text, range)
            }
            ExprKind::Own(name) => {
                let own = self.f.own.ok_or(Poison)?;
                self.object_text(own, &name.text)
            }
            ExprKind::Index(base, index) => self.index(*base, *index, range),
            ExprKind::Neg(e) => match self.lower(*e)? {
                Val::Num(n, ty) => Ok(Val::Num(self.f.b.neg(n, range), ty)),
                Val::Vec(v) => Ok(Val::Vec(self.f.b.add(Node::Neg(v), range))),
                _ => Err(Poison),
            },
            ExprKind::Not(e) => {
                let e = self.truth(*e)?;
                Ok(Val::Truth(self.f.b.not(e, range)))
            }
            ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or | BinaryOp::Implies), _, l, r) => {
                self.f.top = top && *op == BinaryOp::And;
                let mut l = self.truth(*l)?;
                self.f.top = top && *op == BinaryOp::And;
                let r = self.truth(*r)?;
                if *op == BinaryOp::Implies {
                    l = self.f.b.not(l, range);
                }
                Ok(Val::Truth(self.f.b.junction(*op == BinaryOp::And, &[l, r], range)))
            }
            ExprKind::Binary(op, _, l, r) => {
                let (l, r) = (self.lower(*l)?, self.lower(*r)?);
                self.arith(*op, l, r, range)
            }
            ExprKind::Compare(first, rest) => match rest.as_slice() {
                [(op, _, right)] => self.compare(*op, *first, *right, range),
                _ => Err(Poison),
            },
            ExprKind::Call(name, args) => self.call(name, args, range, top),
            ExprKind::Quantified(q, var, domain, body) => self.quantified(*q, var, *domain, *body, range, top),
            ExprKind::Where(set, condition) => {
                let set = self.set(*set)?;
                Ok(Val::Set(self.filtered(set, *condition)?))
            }
            ExprKind::Range(lo, hi) => {
                let mut ends = [0; 2];
                for (end, e) in ends.iter_mut().zip([*lo, *hi]) {
                    *end = self.whole(e, "the bounds of a range must be whole numbers")?;
                }
                Ok(Val::Range(ends[0], ends[1]))
            }
            ExprKind::Error => Err(Poison),
        }
    }

    /// A static whole number.
    fn whole(&mut self, id: ExprId, message: &str) -> Lowered<i64> {
        let value = self.lower(id)?;
        if let Val::Num(n, _) = value
            && let Some(x) = self.f.b.constant(n)
            && x.fract() == 0.0
            && x.abs() < 1e9
        {
            return Ok(x as i64);
        }
        let range = self.f.place.map_or(TextRange::default(), |p| p.stmt.expr(id).range);
        self.error(codes::E0304, range, message);
        Err(Poison)
    }

    fn name(&mut self, name: &SmolStr, range: TextRange) -> Lowered<Val> {
        if let Some((_, v)) = self.f.scope.iter().rev().find(|(n, _)| n == name) {
            return Ok(v.clone());
        }
        if let Some(ids) = self.objects.get(name) {
            let single = self.items.names.get(name).is_some_and(|i| i.kind == crate::items::ItemKind::Object);
            return Ok(if single { Val::Object(ids[0]) } else { Val::Set(ids.as_slice().into()) });
        }
        if let Some(&id) = self.regions.get(name) {
            return Ok(Val::Region(id));
        }
        if let Some(&id) = self.variables.get(name) {
            let node = self.f.b.add(Node::Variable(id), range);
            return Ok(match self.program.variables[id.0 as usize].kind {
                VariableKind::Number => Val::Num(node, Ty::Number),
                VariableKind::Degree => Val::Num(node, Ty::Degree),
                VariableKind::Bool => Val::Truth(node),
                VariableKind::Vector => Val::Vec(node),
                VariableKind::Rotation => Val::Rot(node),
            });
        }
        if let Some(item) = self.items.names.get(name)
            && let crate::items::ItemKind::Variable(ty) = item.kind
        {
            return self.definition(name, ty, range);
        }
        if name == "objects" {
            return Ok(Val::Set((0..self.program.objects.len()).map(|i| ObjectId(i as u32)).collect()));
        }
        if name == ROOMS { Ok(Val::Rooms) } else { Err(Poison) }
    }

    /// The regions that have walls: all but those that are outdoors.
    fn rooms(&self) -> Vec<RegionId> {
        let outdoors = |r: &Region| r.texts.iter().any(|(name, text)| name == "features" && text.contains("outdoor"));
        let ids = (0..self.program.regions.len()).filter(|i| !outdoors(&self.program.regions[*i]));
        ids.map(|i| RegionId(i as u32)).collect()
    }

    /// The value of an assigned variable, put in place once per formula.
    fn definition(&mut self, name: &SmolStr, ty: Ty, range: TextRange) -> Lowered<Val> {
        if let Some(v) = self.f.defined.get(name) {
            return Ok(v.clone());
        }
        let a = self.items.assignments.get(&self.key(name, None, "")).copied().ok_or(Poison)?;
        let value = self.assigned_value(a, name.to_string(), range);
        let value = match value? {
            Val::Num(n, _) => Val::Num(n, ty),
            other => other,
        };
        self.f.defined.insert(name.clone(), value.clone());
        Ok(value)
    }

    fn member(&mut self, base: Val, name: &str, range: TextRange) -> Lowered<Val> {
        let axis = match name {
            "x" => Some(Axis::X),
            "y" => Some(Axis::Y),
            "z" => Some(Axis::Z),
            _ => None,
        };
        match (base, axis) {
            (Val::Vec(v), Some(axis)) => Ok(Val::Num(self.f.b.component(axis, v, range), Ty::Number)),
            (Val::Rot(r), Some(axis)) => Ok(Val::Num(self.f.b.add(Node::Component(axis, r), range), Ty::Degree)),
            (Val::Object(id), _) => self.object_property(id, name, range),
            (Val::Region(id), _) => self.region_property(id, name, range),
            _ => Err(Poison),
        }
    }

    fn object_property(&mut self, id: ObjectId, name: &str, range: TextRange) -> Lowered<Val> {
        use ObjectProperty as P;
        let p = match name {
            "pos" => P::Pos,
            "rot" => P::Rot,
            "scale" | "size" => P::Scale,
            "center" => P::Center,
            "top" => P::Top,
            "bottom" => P::Bottom,
            "surface" => P::Surface,
            "front" => P::Front,
            "right" => P::Right,
            "up" => P::Up,
            "min" => P::Min,
            "max" => P::Max,
            "dimensions" => {
                let (name, element) = self.object_key(id);
                match self.items.assignments.get(&self.key(&name, element, "dimensions")).copied() {
                    Some(a) => {
                        return self.assigned_value(
                            a,
                            format!("{}.dimensions", self.program.objects[id.0 as usize].name),
                            range,
                        );
                    }
                    None => P::Scale,
                }
            }
            _ => return self.object_text(id, name),
        };
        let node = self.f.b.add(Node::Object(p, id), range);
        Ok(match p {
            P::Rot => Val::Rot(node),
            P::Top | P::Bottom | P::Surface => Val::Num(node, Ty::Number),
            _ => Val::Vec(node),
        })
    }

    /// The right side of an assignment that is no pin, put in place. `key` names what is assigned.
    fn assigned_value(&mut self, a: crate::items::Assignment<'a>, key: String, range: TextRange) -> Lowered<Val> {
        let file = a.place.file.ok_or(Poison)?;
        if self.bad.contains(&(file, a.place.offset)) {
            return Err(Poison);
        }
        if let Some(at) = self.values_open.iter().position(|k| *k == key) {
            let circle: Vec<String> = self.values_open[at..].iter().chain([&key]).map(|k| format!("`{k}`")).collect();
            let message = format!("definitions refer to each other in a cycle: {}", circle.join(" → "));
            self.circle(a, message);
            return Err(Poison);
        }
        self.values_open.push(key.clone());
        let outer = (
            self.f.place.replace(a.place),
            std::mem::take(&mut self.f.scope),
            self.f.user.replace(range),
            std::mem::replace(&mut self.f.draw_key, key),
            std::mem::replace(&mut self.f.draw_count, 0),
        );
        let value = self.lower(a.value);
        (self.f.place, self.f.scope, self.f.user, self.f.draw_key, self.f.draw_count) = outer;
        self.values_open.pop();
        value
    }

    fn region_property(&mut self, id: RegionId, name: &str, range: TextRange) -> Lowered<Val> {
        use RegionProperty as P;
        let p = match name {
            "pos" => P::Pos,
            "rot" => P::Rot,
            "scale" => P::Scale,
            "floor" => P::Floor,
            "ceiling" => P::Ceiling,
            "area" => P::Area,
            "center" => P::Center,
            "vertices" => {
                let region = self.program.regions[id.0 as usize].name.clone();
                let a = self.items.assignments.get(&self.key(&region, None, "vertices")).copied();
                return match a {
                    Some(a) => self.assigned_value(a, format!("{region}.vertices"), range),
                    None => {
                        self.error(codes::E0306, range, format!("the vertices of `{region}` are not assigned"));
                        Err(Poison)
                    }
                };
            }
            _ => {
                let region = self.program.regions[id.0 as usize].name.clone();
                return match self.items.assignments.get(&self.key(&region, None, name)).copied() {
                    Some(a) => self.static_text(a, format!("{region}.{name}")),
                    None => Ok(Val::Text(SmolStr::default())),
                };
            }
        };
        let node = self.f.b.add(Node::Region(p, id), range);
        Ok(match p {
            P::Rot => Val::Rot(node),
            P::Floor | P::Ceiling | P::Area => Val::Num(node, Ty::Number),
            _ => Val::Vec(node),
        })
    }

    fn index(&mut self, base: ExprId, index: ExprId, range: TextRange) -> Lowered<Val> {
        let i = self.whole(index, "an index must be a whole number")?;
        let Val::Set(set) = self.lower(base)? else { return Err(Poison) };
        if let Some(id) = usize::try_from(i).ok().and_then(|i| set.get(i)) {
            return Ok(Val::Object(*id));
        }
        let place = self.f.place.ok_or(Poison)?;
        let name = match &place.stmt.expr(base).kind {
            ExprKind::Name(n) => n.clone(),
            _ => return Err(Poison),
        };
        let at = if self.f.user.is_some() { range } else { place.stmt.expr(index).range };
        if let Some(span) = self.blame(at) {
            let mut d = Diagnostic::new(codes::E0205, span, format!("`{name}[{i}]` does not exist"))
                .label(format!("expected a whole number from 0 to {}", set.len().saturating_sub(1)))
                .note("the index is out of range for some values of the range variables");
            if let Some(item) = self.items.names.get(&name) {
                d = d.related(item.span, format!("declared with {} elements here", set.len()));
            }
            // One message per place, whatever the number of expansions that go wrong there.
            if !self.out.iter().any(|o| o.code == d.code && o.primary.as_ref().map(|l| l.place) == Some(span)) {
                self.out.push(d);
            }
        }
        Err(Poison)
    }

    fn arith(&mut self, op: BinaryOp, l: Val, r: Val, range: TextRange) -> Lowered<Val> {
        let arith = match op {
            BinaryOp::Add => Arith::Add,
            BinaryOp::Sub => Arith::Sub,
            BinaryOp::Mul => Arith::Mul,
            _ => Arith::Div,
        };
        Ok(match (l, r) {
            (Val::Num(a, ta), Val::Num(b, tb)) => {
                let ty = match (op, ta, tb) {
                    (BinaryOp::Div, Ty::Degree | Ty::Literal, Ty::Degree) => Ty::Number,
                    _ if ta == Ty::Degree || tb == Ty::Degree => Ty::Degree,
                    _ if ta == Ty::Literal && tb == Ty::Literal => Ty::Literal,
                    _ => Ty::Number,
                };
                let (a, b) = (self.f.b.tallied(a, range), self.f.b.tallied(b, range));
                Val::Num(self.f.b.arith(arith, a, b, range), ty)
            }
            (Val::Vec(a), Val::Vec(b) | Val::Num(b, _)) | (Val::Num(a, _), Val::Vec(b)) => {
                Val::Vec(self.f.b.add(Node::Arith(arith, a, b), range))
            }
            _ => return Err(Poison),
        })
    }

    fn compare(&mut self, op: Comparison, left: ExprId, right: ExprId, range: TextRange) -> Lowered<Val> {
        let (l, r) = (self.lower(left)?, self.lower(right)?);
        let is_count = |l: &Self, e: ExprId| {
            l.f.place.is_some_and(|p| matches!(p.stmt.expr(e).kind, ExprKind::Quantified(Quantifier::Count, ..)))
        };
        let b = &mut self.f.b;
        let equal = op == Comparison::Eq;
        let known = |b: &mut super::Builder, same: bool| b.add(Node::Truth(same == equal), range);
        let node = match (l, r) {
            (Val::Num(a, ta), Val::Num(c, tc)) => {
                if is_count(self, left)
                    && let Some(n) = self.f.b.constant(c)
                    && let Some(t) = self.counted(op, a, n, range)
                {
                    return Ok(Val::Truth(self.settled(t, range)));
                }
                if is_count(self, right)
                    && let Some(n) = self.f.b.constant(a)
                    && let Some(t) = self.counted(flipped(op), c, n, range)
                {
                    return Ok(Val::Truth(self.settled(t, range)));
                }
                let unit = if ta == Ty::Degree || tc == Ty::Degree { Unit::Degree } else { Unit::Metre };
                let node = self.f.b.add(Node::Compare(op, unit, a, c), range);
                self.say(left, node);
                node
            }
            (Val::Vec(a), Val::Vec(c)) | (Val::Rot(a), Val::Rot(c)) => {
                let same = b.add(Node::Same(a, c), range);
                if equal { same } else { b.not(same, range) }
            }
            (Val::Truth(a), Val::Truth(c)) => {
                let iff = b.add(Node::Iff(a, c), range);
                if equal { iff } else { b.not(iff, range) }
            }
            (Val::Text(a), Val::Text(c)) => known(b, a == c),
            (a @ (Val::Text(_) | Val::TextOf(..)), c @ (Val::Text(_) | Val::TextOf(..))) => {
                let same = self.same_text(&a, &c, range)?;
                if equal { same } else { self.f.b.not(same, range) }
            }
            (Val::Object(a), Val::Object(c)) => known(b, a == c),
            (Val::Region(a), Val::Region(c)) => known(b, a == c),
            _ => return Err(Poison),
        };
        Ok(Val::Truth(node))
    }

    /// A count of what is plainly true, as in "four of a category or more", is true or false itself. What compares numbers
    /// has a margin, and keeps it.
    fn settled(&mut self, count: NodeId, range: TextRange) -> NodeId {
        let (mut plain, mut open) = (true, vec![count]);
        while let Some(id) = open.pop() {
            plain = plain
                && matches!(
                    self.f.b.node(id),
                    Node::Truth(_) | Node::Not(_) | Node::And(_) | Node::Or(_) | Node::AtLeast(..)
                );
            self.f.b.node(id).for_each_child(|child| open.push(child));
        }
        match self.f.b.known(count).filter(|_| plain) {
            Some(truth) => self.f.b.add(Node::Truth(truth), range),
            None => count,
        }
    }

    /// `count(…) op n`, with the n-th greatest margin instead of a plain number.
    fn counted(&mut self, op: Comparison, count: NodeId, n: f64, range: TextRange) -> Option<NodeId> {
        let Node::Count(list) = self.f.b.node(count) else { return None };
        let list = list.clone();
        // Also of none, which always holds: what is counted may have no value, and then neither has this.
        let at_least = |l: &mut Self, n: f64| {
            l.f.b.add(Node::AtLeast(n.clamp(0.0, f64::from(u32::MAX)) as u32, list.clone()), range)
        };
        let whole = n.fract() == 0.0;
        Some(match op {
            Comparison::Ge => at_least(self, n.ceil()),
            Comparison::Gt => at_least(self, n.floor() + 1.0),
            Comparison::Le | Comparison::Lt => {
                let limit = if op == Comparison::Le { n.floor() + 1.0 } else { n.ceil() };
                let too_many = at_least(self, limit);
                self.f.b.not(too_many, range)
            }
            Comparison::Eq | Comparison::Ne if whole => {
                let enough = at_least(self, n);
                let more = at_least(self, n + 1.0);
                let no_more = self.f.b.not(more, range);
                let exactly = self.f.b.junction(true, &[enough, no_more], range);
                if op == Comparison::Eq { exactly } else { self.f.b.not(exactly, range) }
            }
            Comparison::Eq | Comparison::Ne => return None,
        })
    }

    fn quantified(
        &mut self,
        q: Quantifier,
        var: &Name,
        domain: ExprId,
        body: ExprId,
        range: TextRange,
        top: bool,
    ) -> Lowered<Val> {
        let values: Vec<Val> = match self.lower(domain)? {
            Val::Rooms => self.rooms().into_iter().map(Val::Region).collect(),
            Val::Range(lo, hi) if hi.saturating_sub(lo) > MAX_NODES as i64 => {
                if let Some(span) = self.blame(range) {
                    self.exhausted(span);
                }
                return Err(Poison);
            }
            Val::Range(lo, hi) => (lo..hi).map(|i| Val::Num(self.f.b.number(i as f64, range), Ty::Literal)).collect(),
            Val::Set(set) => set.iter().map(|o| Val::Object(*o)).collect(),
            Val::Object(o) => vec![Val::Object(o)],
            _ => return Err(Poison),
        };
        let mut members = Vec::with_capacity(values.len());
        for value in values {
            let subject = if let Val::Object(object) = value { Some(object) } else { None };
            self.f.scope.push((var.text.clone(), value));
            self.f.top = top && q == Quantifier::Forall;
            let member = self.truth(body);
            self.f.scope.pop();
            let member = member?;
            if q == Quantifier::Forall
                && let Some(object) = subject
            {
                self.f.subjects.push((member, object));
            }
            members.push(member);
        }
        Ok(match q {
            Quantifier::Forall => Val::Truth(self.f.b.junction(true, &members, range)),
            Quantifier::Exists => Val::Truth(self.f.b.junction(false, &members, range)),
            Quantifier::Count => Val::Num(self.f.b.add(Node::Count(members.into()), range), Ty::Number),
        })
    }

    fn call(&mut self, name: &Name, args: &[ExprId], range: TextRange, top: bool) -> Lowered<Val> {
        match name.text.as_str() {
            "rand" => return self.rand(args, range),
            "oneOf" => return self.one_of(args, range),
            _ => {}
        }
        if !natives::is_built_in(&name.text) {
            let predicate = self.predicate(&name.text).ok_or(Poison)?;
            let values = args.iter().map(|a| self.lower(*a)).collect::<Lowered<Vec<Val>>>()?;
            if top && predicate.is_library() {
                self.mounted(&name.text, &values);
            }
            return self.expand(predicate, values, range).map(Val::Truth);
        }
        let mut values = Vec::with_capacity(args.len());
        for (i, arg) in args.iter().enumerate() {
            values.push(match self.side_word(&name.text, i, *arg) {
                Some(side) => Val::Side(side),
                None => self.lower(*arg)?,
            });
        }
        self.built_in(&name.text, &values, range, top)
    }

    fn side_word(&self, name: &str, index: usize, arg: ExprId) -> Option<ObjectSide> {
        if !natives::overloads(name).any(|s| s.param(index) == Ty::Side) {
            return None;
        }
        match &self.f.place?.stmt.expr(arg).kind {
            ExprKind::Name(n) => SIDES.iter().find(|(w, _)| w == n).map(|(_, s)| *s),
            _ => None,
        }
    }

    /// A predicate with its parameters bound; equal expansions are shared where no random number is drawn.
    pub(super) fn expand(&mut self, p: Predicate<'a>, values: Vec<Val>, range: TextRange) -> Lowered<NodeId> {
        if let Some(file) = p.place.file
            && self.bad.contains(&(file, p.place.offset))
        {
            return Err(Poison);
        }
        let pure = self.is_pure(p);
        // An object passed for a set is a set of one.
        let values: Vec<Val> = values
            .into_iter()
            .zip(p.params)
            .map(|(v, param)| match (Ty::of(param.ty), v) {
                (Ty::Objects, Val::Object(o)) => Val::Set(Rc::from([o])),
                (ty @ (Ty::Number | Ty::Degree), Val::Num(n, _)) => Val::Num(n, ty),
                (_, v) => v,
            })
            .collect();
        let key = (p.name.clone(), p.is_library(), values.clone());
        if pure && let Some(id) = self.f.expanded.get(&key) {
            return Ok(*id);
        }
        let bound = p.params.iter().map(|x| x.name.text.clone()).zip(values).collect();
        let outer = (
            self.f.place.replace(p.place),
            std::mem::replace(&mut self.f.scope, bound),
            self.f.user.replace(range),
            self.f.own.take(),
        );
        let result = self.truth(p.body);
        (self.f.place, self.f.scope, self.f.user, self.f.own) = outer;
        if pure && let Ok(id) = &result {
            self.f.expanded.insert(key, *id);
        }
        result
    }

    fn is_pure(&mut self, p: Predicate<'a>) -> bool {
        let key = (p.name.clone(), p.is_library());
        if let Some(known) = self.pure.get(&key) {
            return *known;
        }
        // Taken as impure while it is being looked at; circles were refused before.
        self.pure.insert(key.clone(), false);
        let pure = p.place.stmt.exprs.iter().all(|e| match &e.kind {
            ExprKind::Call(name, _) if natives::is_draw(&name.text) => false,
            ExprKind::Call(name, _) if natives::is_built_in(&name.text) => true,
            ExprKind::Call(name, _) => {
                self.items.predicate(&name.text, p.is_library()).is_some_and(|q| self.is_pure(q))
            }
            // A definition may draw, but always the same number.
            _ => true,
        });
        self.pure.insert(key, pure);
        pure
    }

    fn built_in(&mut self, name: &str, values: &[Val], range: TextRange, top: bool) -> Lowered<Val> {
        use Function as F;
        let b = &mut self.f.b;
        let num = |v: &Val| if let Val::Num(n, _) = v { Ok(*n) } else { Err(Poison) };
        let three = |v: &[Val]| -> Lowered<[NodeId; 3]> {
            let nodes = v.iter().map(num).collect::<Lowered<Vec<_>>>()?;
            nodes.try_into().map_err(|_| Poison)
        };
        let function = match name {
            "vec3" => return Ok(Val::Vec(b.add(Node::Vector(three(values)?), range))),
            "rot" => return Ok(Val::Rot(b.add(Node::Rotation(three(values)?), range))),
            "polygon" => {
                let points = values.iter().map(|v| if let Val::Vec(n) = v { Ok(*n) } else { Err(Poison) });
                return Ok(Val::Polygon(points.collect::<Lowered<Vec<_>>>()?.into()));
            }
            "abs" => F::Abs,
            "min" => F::Min,
            "max" => F::Max,
            "sqrt" => F::Sqrt,
            "sin" => F::Sin,
            "cos" => F::Cos,
            "length" => F::Length,
            "normalize" => F::Normalize,
            "cross" => F::Cross,
            "dot" => F::Dot,
            "angle" => F::Angle,
            "distance" => F::Distance,
            _ => return self.geometric(name, values, range, top),
        };
        let mut ty = Ty::Literal;
        let mut nodes = Vec::with_capacity(values.len());
        for v in values {
            nodes.push(match v {
                Val::Num(n, t) => {
                    ty = ty.join_numeric(*t).ok_or(Poison)?;
                    *n
                }
                Val::Vec(n) | Val::Rot(n) => *n,
                Val::Object(o) => b.add(Node::Object(ObjectProperty::Center, *o), range),
                Val::Region(r) => b.add(Node::Region(RegionProperty::Center, *r), range),
                _ => return Err(Poison),
            });
        }
        let node = b.add(Node::Call(function, nodes.into()), range);
        Ok(match function {
            F::Normalize | F::Cross => Val::Vec(node),
            F::Abs | F::Min | F::Max => Val::Num(node, ty),
            F::Angle => Val::Num(node, Ty::Degree),
            _ => Val::Num(node, Ty::Number),
        })
    }

    fn geometric(&mut self, name: &str, values: &[Val], range: TextRange, top: bool) -> Lowered<Val> {
        let args = values
            .iter()
            .map(|v| {
                Ok(match v {
                    Val::Object(o) => Arg::Object(*o),
                    Val::Region(r) => Arg::Region(*r),
                    Val::Num(n, _) | Val::Vec(n) => Arg::Value(*n),
                    Val::Side(s) => Arg::Side(*s),
                    _ => return Err(Poison),
                })
            })
            .collect::<Lowered<Box<[Arg]>>>()?;
        let built_in = BuiltIn::named(name).ok_or(Poison)?;
        if top {
            let allow = &mut self.program.allow;
            match (built_in.role(), &*args) {
                (Role::Containment, [Arg::Object(a), Arg::Object(b)]) => allow.contents.push((*a, *b)),
                (Role::Door, [Arg::Object(door), Arg::Region(first), rest @ ..]) => {
                    let second = rest.first().and_then(|a| if let Arg::Region(r) = a { Some(*r) } else { None });
                    allow.doors.push(Door { object: *door, first: *first, second });
                }
                _ => {}
            }
        }
        let node = self.f.b.add(Node::BuiltIn(built_in, args), range);
        Ok(if built_in.is_predicate() { Val::Truth(node) } else { Val::Num(node, built_in.result()) })
    }

    /// `wallMounted` and `ceilingMounted` of the library, asserted at top level, replace the rule of support.
    fn mounted(&mut self, name: &str, values: &[Val]) {
        let (on, [Val::Object(object), Val::Region(region)]) = (
            match name {
                "wallMounted" => MountedOn::Wall,
                "ceilingMounted" => MountedOn::Ceiling,
                _ => return,
            },
            values,
        ) else {
            return;
        };
        let (object, region) = (*object, *region);
        let Some(root) = self.f.root else { return };
        let fresh = Frame { place: Some(root), root: Some(root), ..Frame::default() };
        let outer = std::mem::replace(&mut self.f, fresh);
        let range = root.stmt.range;
        let limit = self.f.b.number(0.01, range);
        let touching = match on {
            MountedOn::Wall => crate::library::predicates().get("backToWall").copied().and_then(|p| {
                self.expand(p, vec![Val::Object(object), Val::Region(region), Val::Num(limit, Ty::Number)], range).ok()
            }),
            MountedOn::Ceiling => {
                let b = &mut self.f.b;
                let ceiling = b.add(Node::Region(RegionProperty::Ceiling, region), range);
                let top = b.add(Node::Object(ObjectProperty::Top, object), range);
                let apart = b.add(Node::Arith(Arith::Sub, ceiling, top), range);
                let apart = b.add(Node::Call(Function::Abs, [apart].into()), range);
                Some(b.add(Node::Compare(Comparison::Le, Unit::Metre, apart, limit), range))
            }
        };
        if let Some(root) = touching {
            let formula = self.f.b.extract(root);
            self.program.allow.mounts.push(Mount { object, region, on, formula });
        }
        self.f = outer;
    }
}

/// The comparison with its sides exchanged.
fn flipped(op: Comparison) -> Comparison {
    match op {
        Comparison::Lt => Comparison::Gt,
        Comparison::Le => Comparison::Ge,
        Comparison::Gt => Comparison::Lt,
        Comparison::Ge => Comparison::Le,
        same => same,
    }
}
