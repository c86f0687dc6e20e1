//! Types of expressions. One mistake, one message: what failed has type `Error`, which fits everywhere.

mod unknown;

use super::Where;
use super::constant;
use crate::ast::{BinaryOp, Expr, ExprId, ExprKind, Name, Param, Quantifier, Stmt, UnitSuffix};
use crate::hir::{Hir, Local, LocalKind, Resolution};
use crate::items::{ItemKind, Names, whole_number};
use crate::natives::{self, ROOMS, SIDES, STATIC_PROPERTIES, Signature, property};
use crate::program::Comparison;
use crate::types::Ty;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, TextRange, codes};
use smol_str::SmolStr;

/// Checks the expressions of one statement.
pub(super) struct Checker<'n, 'a> {
    pub(super) names: &'n dyn Names,
    stmt: &'a Stmt,
    /// Names bound in this statement.
    locals: Vec<Local>,
    /// Those of `locals` that are in scope, innermost last.
    scope: Vec<usize>,
    /// Inside the condition of a `where`.
    filter: bool,
    /// Names reported as unknown in this statement, each once.
    unknown: Vec<SmolStr>,
    /// What is found out besides, if somebody wants to know.
    pub(super) facts: Option<Hir>,
    out: Vec<Diagnostic<Where>>,
}

impl<'n, 'a> Checker<'n, 'a> {
    pub(super) fn new(names: &'n dyn Names, stmt: &'a Stmt) -> Self {
        Self {
            names,
            stmt,
            locals: Vec::new(),
            scope: Vec::new(),
            filter: false,
            unknown: Vec::new(),
            facts: None,
            out: Vec::new(),
        }
    }

    pub(super) fn finish(self) -> Vec<Diagnostic<Where>> {
        self.out
    }

    /// What was found out besides.
    pub(super) fn into_facts(self) -> Hir {
        let mut facts = self.facts.unwrap_or_default();
        facts.locals = self.locals;
        facts
    }

    pub(super) fn bind_params(&mut self, params: &[Param]) {
        params.iter().for_each(|p| self.bind(&p.name, Ty::of(p.ty), LocalKind::Parameter));
    }

    fn bind(&mut self, name: &Name, ty: Ty, kind: LocalKind) {
        self.scope.push(self.locals.len());
        self.locals.push(Local { name: name.text.clone(), range: name.range, ty, kind });
    }

    /// The innermost local name that is written so.
    fn local(&self, name: &str) -> Option<usize> {
        self.scope.iter().rev().copied().find(|local| self.locals[*local].name == name)
    }

    /// Notes what an expression stands for.
    fn resolve(&mut self, id: ExprId, resolution: impl FnOnce() -> Resolution) {
        if let Some(facts) = &mut self.facts {
            facts.resolve(id, resolution());
        }
    }

    fn note_type(&mut self, id: ExprId, ty: Ty) {
        if let Some(facts) = &mut self.facts {
            facts.set_type(id, ty);
        }
    }

    pub(super) fn push(&mut self, d: Diagnostic<Where>) {
        self.out.push(d);
    }

    pub(super) fn error(&mut self, code: scenelang_base::Code, range: TextRange, message: impl Into<String>) {
        self.push(Diagnostic::new(code, Where::Here(range), message));
    }

    pub(super) fn range(&self, id: ExprId) -> TextRange {
        self.expr(id).range
    }

    fn expr(&self, id: ExprId) -> &'a Expr {
        self.stmt.expr(id)
    }

    /// Requires a condition.
    pub(super) fn condition(&mut self, id: ExprId) {
        let ty = self.ty(id);
        self.is_condition(id, ty);
    }

    /// Requires that an expression of some type is a condition.
    fn is_condition(&mut self, id: ExprId, ty: Ty) {
        if !ty.fits(Ty::Bool) {
            let mut d = Diagnostic::new(
                codes::E0302,
                Where::Here(self.range(id)),
                format!("expected a condition, but this is {ty}"),
            );
            d = match ty {
                Ty::Number | Ty::Degree | Ty::Literal => d.note("compare it with something: `… > 1`"),
                Ty::Objects => d.note("state a condition for each: `forall x in …: …`"),
                _ => d.note("a condition is a comparison, a predicate, or several joined by `and`, `or`, `not`"),
            };
            self.push(d);
        }
    }

    /// Requires a type; `what` takes the value.
    pub(super) fn expect(&mut self, id: ExprId, wanted: Ty, what: &str) {
        let ty = self.ty(id);
        if !ty.fits(wanted) {
            let message = format!("{what} expects {wanted}, but this is {ty}");
            let d = Diagnostic::new(codes::E0301, Where::Here(self.range(id)), message);
            self.push(self.repaired(d, id, wanted, ty));
        }
    }

    /// The type of an expression; problems in it are reported.
    pub(super) fn ty(&mut self, id: ExprId) -> Ty {
        let ty = stacker::maybe_grow(64 << 10, 1 << 20, || self.ty_of(id));
        self.note_type(id, ty);
        ty
    }

    fn ty_of(&mut self, id: ExprId) -> Ty {
        let before = self.out.len();
        let ty = match &self.expr(id).kind {
            ExprKind::Number(_, unit) => match unit {
                None => Ty::Literal,
                Some(UnitSuffix::Deg | UnitSuffix::Rad) => Ty::Degree,
                Some(_) => Ty::Number,
            },
            ExprKind::Text(_) => Ty::String,
            ExprKind::Bool(_) => Ty::Bool,
            ExprKind::Name(name) => self.name(id, name),
            ExprKind::Objects => self.objects(id),
            ExprKind::Member(base, name) => self.member(id, *base, name),
            ExprKind::Own(name) => self.own(id, name),
            ExprKind::Index(base, index) => self.index(id, *base, *index),
            ExprKind::Neg(e) => match self.ty(*e) {
                t @ (Ty::Literal | Ty::Number | Ty::Degree | Ty::Vector3 | Ty::Error) => t,
                other => {
                    self.error(codes::E0301, self.range(*e), format!("{other} cannot be negated"));
                    Ty::Error
                }
            },
            ExprKind::Not(e) => {
                self.condition(*e);
                Ty::Bool
            }
            ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or | BinaryOp::Implies), _, l, r) => {
                self.condition(*l);
                self.condition_after(*op, *l, *r);
                Ty::Bool
            }
            ExprKind::Binary(op, _, l, r) => self.arith(*op, *l, *r, self.range(id)),
            ExprKind::Compare(first, rest) => {
                // A chain is reported by the parser; its parts are still checked, pair by pair.
                let mut left = (*first, self.ty(*first));
                for (op, _, right) in rest {
                    let ty = self.ty(*right);
                    self.comparison(*op, left, (*right, ty));
                    left = (*right, ty);
                }
                Ty::Bool
            }
            ExprKind::Call(name, args) => self.call(id, name, args),
            ExprKind::Quantified(q, var, domain, body) => self.quantified(*q, var, *domain, *body),
            ExprKind::Where(set, condition) => {
                self.set(*set);
                let outer = std::mem::replace(&mut self.filter, true);
                self.condition(*condition);
                self.filter = outer;
                Ty::Objects
            }
            ExprKind::Range(lo, hi) => {
                for end in [*lo, *hi] {
                    let ty = self.ty(end);
                    if !ty.fits(Ty::Literal) {
                        self.error(codes::E0304, self.range(end), "the bounds of a range must be whole numbers");
                    }
                }
                Ty::Range
            }
            ExprKind::Error => Ty::Error,
        };
        if self.out.len() == before
            && let Err(e) = self.constant(id)
        {
            self.error(e.code, self.range(id), e.message);
            return Ty::Error;
        }
        ty
    }

    /// Reports an operation on constants that has no value. Only the operation itself: an operand without a value has
    /// been reported, and makes the whole not constant.
    fn constant(&self, id: ExprId) -> Result<(), constant::NoValue> {
        let worth = matches!(
            self.expr(id).kind,
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div, ..) | ExprKind::Call(..)
        );
        if worth && !self.filter { constant::evaluate(self.stmt, id, &|_| None).map(|_| ()) } else { Ok(()) }
    }

    fn name(&mut self, id: ExprId, name: &SmolStr) -> Ty {
        let range = self.range(id);
        if let Some(local) = self.local(name) {
            self.resolve(id, || Resolution::Local(local));
            return self.locals[local].ty;
        }
        let item = self.names.item(name);
        if let Some(kind) = item {
            self.resolve(id, || Resolution::Item(name.clone(), kind));
        }
        match item {
            Some(ItemKind::Variable(ty)) if ty.is_text() && !self.names.is_assigned(name) => {
                let message = format!("`{name}` is read but never assigned, and the solver cannot choose text");
                self.push(
                    Diagnostic::new(codes::E0307, Where::Here(range), message)
                        .related(Where::Item(name.clone()), "declared here")
                        .note(format!("assign it: `{name} <- \"…\";`")),
                );
                Ty::Error
            }
            Some(kind) => kind.ty(),
            None if name == "objects" => self.objects(id),
            None if name == ROOMS && !self.names.is_poisoned(name) => {
                self.resolve(id, || Resolution::AllRooms);
                Ty::Regions
            }
            None => {
                self.unknown_name(name, range);
                Ty::Error
            }
        }
    }

    /// `objects`, unless something is called so.
    fn objects(&mut self, id: ExprId) -> Ty {
        match self.names.item("objects") {
            Some(kind) => {
                self.resolve(id, || Resolution::Item("objects".into(), kind));
                kind.ty()
            }
            None => {
                self.resolve(id, || Resolution::AllObjects);
                Ty::Objects
            }
        }
    }

    fn member(&mut self, id: ExprId, base: ExprId, name: &Name) -> Ty {
        let ty = self.ty(base);
        let known: Vec<&str> = match ty {
            Ty::Error => return Ty::Error,
            Ty::Vector3 | Ty::Rotation => {
                if ["x", "y", "z"].contains(&name.text.as_str()) {
                    self.resolve(id, || Resolution::Component);
                    return if ty == Ty::Rotation { Ty::Degree } else { Ty::Number };
                }
                vec!["x", "y", "z"]
            }
            Ty::Object | Ty::Region => {
                if let Some(p) = property(ty, &name.text) {
                    self.resolve(id, || Resolution::Property { of: ty, property: p });
                    return p.ty;
                }
                let table = if ty == Ty::Object { natives::OBJECT_PROPERTIES } else { natives::REGION_PROPERTIES };
                table.iter().map(|p| p.name).collect()
            }
            Ty::Objects => {
                self.bare_set(base, &format!("it has no `{}`", name.text));
                return Ty::Error;
            }
            other => {
                self.error(codes::E0207, name.range, format!("{other} has no property `{}`", name.text));
                return Ty::Error;
            }
        };
        let mut d =
            Diagnostic::new(codes::E0207, Where::Here(name.range), format!("{ty} has no property `{}`", name.text));
        let called = matches!(ty, Ty::Object | Ty::Region).then(|| natives::property_called(ty, &name.text)).flatten();
        d = match called.or_else(|| nearest(&name.text, known.iter().copied())) {
            Some(near) => d.label(format!("did you mean `{near}`?")).fix(
                Applicability::Unsafe,
                format!("write `{near}`"),
                Where::Here(name.range),
                near,
            ),
            None => d.note(format!("it has: {}", known.join(", "))),
        };
        self.push(d);
        Ty::Error
    }

    /// A set where one object is meant.
    fn bare_set(&mut self, at: ExprId, why: &str) {
        let range = self.range(at);
        let mut d = Diagnostic::new(codes::E0212, Where::Here(range), format!("this is a set of objects: {why}"));
        d = match &self.expr(at).kind {
            ExprKind::Name(n) => {
                d.note(format!("name one element, `{n}[0]`, or quantify over all: `forall x in {n}: …`"))
            }
            _ => d.note("quantify over them: `forall x in …: …`"),
        };
        self.push(d);
    }

    fn own(&mut self, id: ExprId, name: &Name) -> Ty {
        if let Some(property) = property(Ty::Object, &name.text) {
            self.resolve(id, || Resolution::Property { of: Ty::Object, property });
        }
        if !self.filter {
            let message = format!("`.{}` without an object before it is allowed only after `where`", name.text);
            self.error(codes::E0207, name.range, message);
            return Ty::Error;
        }
        if STATIC_PROPERTIES.contains(&name.text.as_str()) {
            return Ty::String;
        }
        let mut d = Diagnostic::new(
            codes::E0306,
            Where::Here(name.range),
            format!("a filter may read color, material, features, category and role, not `{}`", name.text),
        )
        .note("the elements of a set must not depend on the layout; move other conditions after the colon");
        if let Some(near) = nearest(&name.text, STATIC_PROPERTIES) {
            d = d.fix(Applicability::Unsafe, format!("write `{near}`"), Where::Here(name.range), near);
        }
        self.push(d);
        Ty::Error
    }

    fn index(&mut self, id: ExprId, base: ExprId, index: ExprId) -> Ty {
        let index_ty = self.ty(index);
        let array = match &self.expr(base).kind {
            ExprKind::Name(n) if self.local(n).is_none() => self.names.item(n).map(|kind| (n, kind)),
            _ => None,
        };
        let Some((name, kind)) = array else {
            let ty = self.ty(base);
            if ty != Ty::Error {
                self.error(codes::E0212, self.range(base), format!("{ty} cannot be indexed"));
            }
            return Ty::Error;
        };
        self.note_type(base, kind.ty());
        self.resolve(base, || Resolution::Item(name.clone(), kind));
        let ItemKind::Array(n) = kind else {
            let message = format!("`{name}` is not an array");
            let d = Diagnostic::new(codes::E0212, Where::Here(self.range(base)), message)
                .related(Where::Item(name.clone()), "declared here")
                .note(format!("leave the brackets out, or declare `object {name}[…];`"));
            self.push(d);
            return Ty::Error;
        };
        let range = self.range(index);
        if !index_ty.fits(Ty::Literal) || (index_ty == Ty::Literal && self.is_static(index).is_err()) {
            let message = "an index must be a whole number, or an expression of numbers and range variables, such as `i` in `forall i in 0..5`";
            self.error(codes::E0304, range, message);
            return Ty::Error;
        }
        let at = constant::number(self.stmt, index);
        if let Some(i) = at
            && (whole_number(self.stmt, index).is_none() || i < 0.0 || i >= f64::from(n))
        {
            self.index_error(name, n, range);
            return Ty::Error;
        }
        self.resolve(id, || Resolution::Element { array: name.clone(), index: at.map(|i| i as u32) });
        Ty::Object
    }

    pub(super) fn index_error(&mut self, name: &SmolStr, n: u32, range: TextRange) {
        let elements = if n == 1 { "one element".to_owned() } else { format!("{n} elements") };
        self.push(
            Diagnostic::new(codes::E0205, Where::Here(range), format!("this element of `{name}` does not exist"))
                .label(format!("expected a whole number from 0 to {}", n - 1))
                .related(Where::Item(name.clone()), format!("declared with {elements} here")),
        );
    }

    /// Whether an expression of literal type is made of literals and range variables alone.
    fn is_static(&self, id: ExprId) -> Result<(), ()> {
        match &self.expr(id).kind {
            ExprKind::Number(_, None) | ExprKind::Name(_) => Ok(()),
            ExprKind::Neg(e) => self.is_static(*e),
            ExprKind::Binary(_, _, l, r) => self.is_static(*l).and(self.is_static(*r)),
            _ => Err(()),
        }
    }

    fn arith(&mut self, op: BinaryOp, l: ExprId, r: ExprId, range: TextRange) -> Ty {
        let (a, b) = (self.ty(l), self.ty(r));
        if a == Ty::Error || b == Ty::Error {
            return Ty::Error;
        }
        let result = match op {
            BinaryOp::Add | BinaryOp::Sub => match (a, b) {
                (Ty::Vector3, Ty::Vector3) => Some(Ty::Vector3),
                _ => a.join_numeric(b),
            },
            BinaryOp::Mul => match (a, b) {
                (Ty::Vector3, Ty::Number | Ty::Literal) | (Ty::Number | Ty::Literal, Ty::Vector3) => Some(Ty::Vector3),
                (Ty::Degree, Ty::Number | Ty::Literal) | (Ty::Number | Ty::Literal, Ty::Degree) => Some(Ty::Degree),
                (Ty::Degree, Ty::Degree) => None,
                _ => a.join_numeric(b),
            },
            _ => match (a, b) {
                (Ty::Vector3, Ty::Number | Ty::Literal) => Some(Ty::Vector3),
                (Ty::Degree, Ty::Number | Ty::Literal) => Some(Ty::Degree),
                (Ty::Degree | Ty::Literal, Ty::Degree) => Some(Ty::Number),
                _ => a.join_numeric(b),
            },
        };
        result.unwrap_or_else(|| {
            let verb = match op {
                BinaryOp::Add => "added",
                BinaryOp::Sub => "subtracted",
                BinaryOp::Mul => "multiplied",
                _ => "divided",
            };
            let d = Diagnostic::new(codes::E0301, Where::Here(range), format!("{a} and {b} cannot be {verb}"))
                .related(Where::Here(self.range(l)), format!("this is {a}"))
                .related(Where::Here(self.range(r)), format!("this is {b}"));
            self.push(self.reconciled(d, (l, a), (r, b)));
            Ty::Error
        })
    }

    fn comparison(&mut self, op: Comparison, (l, a): (ExprId, Ty), (r, b): (ExprId, Ty)) {
        if a == Ty::Error || b == Ty::Error {
            return;
        }
        let ordered = !matches!(op, Comparison::Eq | Comparison::Ne);
        let fine = a.join_numeric(b).is_some()
            || (!ordered
                && (a == b && matches!(a, Ty::Bool | Ty::Vector3 | Ty::Rotation | Ty::Object | Ty::Region)
                    || a.is_text() && b.is_text()));
        if fine {
            return;
        }
        if let Some((set, _)) = [(l, a), (r, b)].into_iter().find(|(_, t)| *t == Ty::Objects) {
            self.bare_set(set, "it cannot be compared");
            return;
        }
        let range = self.range(l).cover(self.range(r));
        let message = if ordered && a == b {
            format!("{a} cannot be ordered")
        } else {
            format!("{a} and {b} cannot be compared")
        };
        let d = Diagnostic::new(codes::E0301, Where::Here(range), message)
            .related(Where::Here(self.range(l)), format!("this is {a}"))
            .related(Where::Here(self.range(r)), format!("this is {b}"));
        self.push(self.reconciled(d, (l, a), (r, b)));
    }

    fn set(&mut self, id: ExprId) {
        let ty = self.ty(id);
        if !ty.fits(Ty::Objects) {
            self.error(codes::E0301, self.range(id), format!("expected a set of objects, but this is {ty}"));
        }
    }

    fn quantified(&mut self, q: Quantifier, var: &Name, domain: ExprId, body: ExprId) -> Ty {
        let ty = self.ty(domain);
        let var_ty = match ty {
            Ty::Range => Ty::Literal,
            Ty::Objects | Ty::Object => Ty::Object,
            Ty::Regions => Ty::Region,
            Ty::Error => Ty::Error,
            other => {
                let message =
                    format!("a quantifier ranges over a set of objects or a range like `0..5`, not over {other}");
                self.error(codes::E0301, self.range(domain), message);
                Ty::Error
            }
        };
        self.bind(var, var_ty, LocalKind::Variable);
        self.condition(body);
        self.scope.pop();
        if q == Quantifier::Count { Ty::Number } else { Ty::Bool }
    }

    fn call(&mut self, id: ExprId, name: &Name, args: &[ExprId]) -> Ty {
        if natives::is_built_in(&name.text) {
            let (signature, types) = self.built_in(name, args, self.range(id));
            self.resolve(id, || Resolution::BuiltIn(signature));
            return result_of(signature, &types);
        }
        let Some(predicate) = self.names.predicate(&name.text) else {
            self.unknown_function(id, name, args);
            return Ty::Error;
        };
        self.resolve(id, || Resolution::Predicate { name: name.text.clone(), library: predicate.library });
        if predicate.broken {
            for a in args {
                self.ty(*a);
            }
            return Ty::Bool;
        }
        if args.len() != predicate.params.len() {
            let wanted: Vec<&str> = predicate.params.iter().map(|(_, name)| name.as_str()).collect();
            let mut d = Diagnostic::new(
                codes::E0303,
                Where::Here(name.range),
                format!("`{}` takes {}, not {}", name.text, count(wanted.len()), args.len()),
            )
            .note(format!("`{}({})`", name.text, wanted.join(", ")));
            if !predicate.library {
                d = d.related(Where::Predicate(name.text.clone()), "defined here");
            }
            self.push(d);
            for a in args {
                self.ty(*a);
            }
            return Ty::Bool;
        }
        self.arguments(id, name, args, &predicate.params);
        Ty::Bool
    }

    /// A complaint that `id` is of type `found` where `wanted` is expected, with what to do about it.
    fn repaired(&self, d: Diagnostic<Where>, id: ExprId, wanted: Ty, found: Ty) -> Diagnostic<Where> {
        match self.other_unit(id, wanted) {
            Some(unit) => self.without_unit(d, id, unit),
            None => hint(wanted, found).map(|h| d.clone().note(h)).unwrap_or(d),
        }
    }

    /// A complaint that two values do not go together. A literal with a unit is the one to blame.
    fn reconciled(&self, d: Diagnostic<Where>, (l, a): (ExprId, Ty), (r, b): (ExprId, Ty)) -> Diagnostic<Where> {
        match (self.other_unit(r, a), self.other_unit(l, b)) {
            (Some(unit), _) => self.without_unit(d, r, unit),
            (_, Some(unit)) => self.without_unit(d, l, unit),
            _ => hint(a, b).or_else(|| hint(b, a)).map(|h| d.clone().note(h)).unwrap_or(d),
        }
    }

    /// The unit of a literal that is a length where degrees are wanted, or degrees where a number is.
    fn other_unit(&self, id: ExprId, wanted: Ty) -> Option<UnitSuffix> {
        let id = match self.expr(id).kind {
            ExprKind::Neg(inner) => inner,
            _ => id,
        };
        let ExprKind::Number(_, unit) = self.expr(id).kind else { return None };
        let angle = matches!(unit?, UnitSuffix::Deg | UnitSuffix::Rad);
        matches!((wanted, angle), (Ty::Degree, false) | (Ty::Number, true)).then_some(unit?)
    }

    /// Offers a literal without its unit or, where degrees are wanted, with the right one.
    fn without_unit(&self, d: Diagnostic<Where>, id: ExprId, unit: UnitSuffix) -> Diagnostic<Where> {
        let length = unit.text().len() as u32;
        let end = self.range(id).end;
        let place = Where::Here(TextRange { start: end - length, end });
        if matches!(unit, UnitSuffix::Deg | UnitSuffix::Rad) {
            return d.note("a length is expected here, not an angle").fix(
                Applicability::Unsafe,
                "remove the unit",
                place,
                "",
            );
        }
        d.note("expected degrees; a plain number such as `90` is read as degrees")
            .fix(Applicability::Unsafe, "replace the unit with `deg`", place.clone(), "deg")
            .fix(Applicability::Unsafe, "remove the unit", place, "")
    }

    /// The overload that the arguments choose (or the likeliest, if they fit none), and their types.
    fn built_in(&mut self, name: &Name, args: &[ExprId], range: TextRange) -> (&'static Signature, Vec<Ty>) {
        let all: Vec<&'static Signature> = natives::overloads(&name.text).collect();
        let fitting: Vec<&'static Signature> = all.iter().copied().filter(|s| s.takes(args.len())).collect();
        let side_at = |i: usize| all.iter().any(|s| s.param(i) == Ty::Side);
        let types: Vec<Ty> =
            args.iter().enumerate().map(|(i, a)| if side_at(i) { self.side(*a) } else { self.ty(*a) }).collect();
        if fitting.is_empty() {
            let forms: Vec<String> = all.iter().map(|s| format!("`{}({})`", s.name, s.names)).collect();
            let mut sizes: Vec<usize> = all.iter().map(|s| s.params.len()).collect();
            sizes.sort_unstable();
            sizes.dedup();
            let wanted = match (all[0].variadic, sizes.as_slice()) {
                (true, [n, ..]) => format!("{n} arguments or more"),
                (_, [n]) => count(*n),
                (_, many) => {
                    format!("{} arguments", many.iter().map(usize::to_string).collect::<Vec<_>>().join(" or "))
                }
            };
            let d = Diagnostic::new(
                codes::E0303,
                Where::Here(range),
                format!("`{}` takes {wanted}, not {}", name.text, args.len()),
            )
            .note(forms.join(" or "));
            self.push(d);
            return (all[0], types);
        }
        if types.contains(&Ty::Error) {
            return (fitting[0], types);
        }
        if let Some(s) = fitting.iter().find(|s| accepts(s, &types)) {
            return (s, types);
        }
        // Blame the first argument that no signature, chosen by the arguments before it, can take.
        let bad =
            (0..types.len()).find(|&i| !fitting.iter().any(|s| (0..=i).all(|j| fits_param(s, j, &types)))).unwrap_or(0);
        let mut wanted: Vec<Ty> = Vec::new();
        for s in fitting.iter().filter(|s| (0..bad).all(|j| fits_param(s, j, &types))) {
            if !wanted.contains(&s.param(bad)) {
                wanted.push(s.param(bad));
            }
        }
        if types[bad] == Ty::Objects && wanted.contains(&Ty::Object) {
            self.bare_set(args[bad], &format!("`{}` takes one object here", name.text));
            return (fitting[0], types);
        }
        let words: Vec<String> = wanted
            .iter()
            .map(|t| match (t, bad) {
                (Ty::Literal, 0) => "a Number or a Degree".into(),
                (Ty::Literal, _) => format!("{} as before it", types[0]),
                _ => t.to_string(),
            })
            .collect();
        let mut d = Diagnostic::new(
            codes::E0301,
            Where::Here(self.range(args[bad])),
            format!("`{}` takes {} here, but this is {}", name.text, words.join(" or "), types[bad]),
        );
        let mut swapped = types.clone();
        swapped.reverse();
        if let Some(s) = fitting.iter().find(|s| accepts(s, &swapped)) {
            d = d.note(format!("the arguments fit in the other order: `{}({})`", s.name, s.names));
        } else if let [only] = wanted.as_slice() {
            d = self.repaired(d, args[bad], *only, types[bad]);
        }
        self.push(d);
        (fitting[0], types)
    }

    /// The side word of `clear`.
    fn side(&mut self, id: ExprId) -> Ty {
        if let ExprKind::Name(n) = &self.expr(id).kind
            && let Some((_, side)) = SIDES.iter().find(|(word, _)| word == n)
        {
            self.note_type(id, Ty::Side);
            self.resolve(id, || Resolution::Side(*side));
            return Ty::Side;
        }
        let words: Vec<&str> = SIDES.iter().map(|(w, _)| *w).collect();
        let message = format!("expected one of the sides {}", words.join(", "));
        self.error(codes::E0301, self.range(id), message);
        Ty::Error
    }
}

fn count(n: usize) -> String {
    match n {
        0 => "no argument".into(),
        1 => "one argument".into(),
        n => format!("{n} arguments"),
    }
}

fn accepts(s: &Signature, types: &[Ty]) -> bool {
    (0..types.len()).all(|i| fits_param(s, i, types))
}

fn fits_param(s: &Signature, i: usize, types: &[Ty]) -> bool {
    match s.param(i) {
        // All alike: join with the ones before.
        Ty::Literal => types[..=i].iter().try_fold(Ty::Literal, |a, b| a.join_numeric(*b)).is_some(),
        wanted => types[i].fits(wanted),
    }
}

fn result_of(s: &Signature, types: &[Ty]) -> Ty {
    match s.result {
        Ty::Literal => types.iter().try_fold(Ty::Literal, |a, b| a.join_numeric(*b)).unwrap_or(Ty::Error),
        ty => ty,
    }
}

/// What to do about a type in the wrong place.
fn hint(wanted: Ty, found: Ty) -> Option<&'static str> {
    Some(match (wanted, found) {
        (Ty::Degree, Ty::Number) => "a Number is not a Degree; declare the variable as `Degree`, or multiply by `1deg`",
        (Ty::Number, Ty::Degree) => "degrees are not lengths; use `sin` or `cos`, or divide by `1deg`",
        (Ty::Number | Ty::Literal, Ty::Vector3) => "use one component (`.x`, `.y`, `.z`) or the `length`",
        (Ty::Vector3, Ty::Object) => "use one of its points: `.pos` or `.center`",
        (Ty::Number | Ty::Literal, Ty::Object) => "use one of its properties, such as `.pos.x` or `.top`",
        (Ty::Rotation, Ty::Degree | Ty::Number | Ty::Literal) => {
            "write `rot(0, …, 0)` for a rotation about the vertical axis"
        }
        (Ty::Rotation, Ty::Vector3) => "write `rot(x, y, z)`: the rotation about each axis, in degrees",
        (Ty::Color | Ty::Material | Ty::String, Ty::Object) => "text is written in double quotes",
        _ => return None,
    })
}
