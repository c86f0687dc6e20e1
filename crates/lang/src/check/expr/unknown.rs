//! Names that stand for nothing, calls of what cannot be called, arguments that do not fit: what was meant instead.

use super::super::Where;
use super::Checker;
use crate::ast::{BinaryOp, ExprId, ExprKind, Name};
use crate::items::ItemKind;
use crate::library;
use crate::natives;
use crate::types::Ty;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, TextRange, codes};
use smol_str::SmolStr;

/// Words for what the language has under another name.
const OTHERS: &[(&str, &str)] = &[
    ("overlap", "collides"),
    ("overlaps", "collides"),
    ("intersect", "collides"),
    ("intersects", "collides"),
    ("collide", "collides"),
];

impl Checker<'_, '_> {
    pub(in super::super) fn unknown_name(&mut self, name: &str, range: TextRange) {
        if self.names.is_poisoned(name) || self.unknown.iter().any(|n| n == name) {
            return;
        }
        self.unknown.push(name.into());
        let d = Diagnostic::new(codes::E0201, Where::Here(range), format!("`{name}` is not declared"));
        let meant = |d: Diagnostic<Where>, meant: &str| {
            let fix = format!("write `{meant}`");
            d.label(format!("did you mean `{meant}`?")).fix(Applicability::Unsafe, fix, Where::Here(range), meant)
        };
        let declared = self.names.declared();
        let locals = self.scope.iter().map(|local| self.locals[*local].name.as_str());
        // A single letter is like any other.
        let is_short = name.chars().count() < 2;
        let near = locals.chain(declared.iter().map(SmolStr::as_str)).filter(|near| !is_short && near.len() > 1);
        let d = if natives::is_built_in(name) || self.names.predicate(name).is_some() {
            d.note(format!("`{name}` is a predicate or function: it takes arguments, `{name}(…)`"))
        } else if library::colors().any(|color| color == name) {
            let text = format!("\"{name}\"");
            d.label("a color or material is written in quotes").fix(
                Applicability::Unsafe,
                format!("write `{text}`"),
                Where::Here(range),
                text,
            )
        } else if let Some((array, index)) = self.numbered(name) {
            meant(d, &format!("{array}[{index}]")).related(Where::Item(array.clone()), format!("`{array}` is an array"))
        } else if let Some(near) = nearest(name, near) {
            let d = meant(d, near);
            match self.names.item(near) {
                Some(_) => d.related(Where::Item(near.into()), format!("`{near}` is declared here")),
                None => d,
            }
        } else if matches!(name, "all" | "everything" | "any" | "anything") {
            meant(d, "objects")
        } else {
            d.note(format!("declare it: `object {name};`"))
        };
        self.push(d);
    }

    /// `chair1`, where `chair` is an array: its name and the index.
    fn numbered(&self, name: &str) -> Option<(SmolStr, u32)> {
        let array = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let index = name[array.len()..].parse().ok()?;
        let array = array.strip_suffix('_').unwrap_or(array);
        matches!(self.names.item(array)?, ItemKind::Array(size) if index < size).then(|| (array.into(), index))
    }

    /// A call of something that is neither a function nor a predicate.
    pub(super) fn unknown_function(&mut self, id: ExprId, name: &Name, args: &[ExprId]) {
        let is_local = self.local(&name.text).is_some();
        let message = format!("there is no function or predicate `{}`", name.text);
        let place = Where::Here(name.range);
        let d = Diagnostic::new(codes::E0208, place.clone(), message);
        let item = self.names.item(&name.text).filter(|_| !is_local);
        if let (Some(ItemKind::Array(_)), [index]) = (item, args) {
            // Not looked at as a value: what stands in the brackets need not be one yet.
            let message = format!("`{}` is an array; an element is written in brackets, `{}[…]`", name.text, name.text);
            let d =
                Diagnostic::new(codes::E0208, place, message).related(Where::Item(name.text.clone()), "declared here");
            self.push(self.in_brackets(d, id, name, *index));
            return;
        }
        let types: Vec<Ty> = args.iter().map(|arg| self.ty(*arg)).collect();
        if self.names.is_poisoned(&name.text) {
            return;
        }
        if name.text == "count" {
            let set = match args.first().map(|arg| &self.expr(*arg).kind) {
                Some(ExprKind::Name(set)) => set.as_str(),
                _ => "chair",
            };
            let message = "`count` needs a variable, a set and a condition";
            let note = format!("as in `count(c in {set}: c.pos.x > 0) = 2`");
            self.push(Diagnostic::new(codes::E0208, place, message).note(note));
            return;
        }
        if let (Some(kind), false) = (item, self.names.is_poisoned(&name.text)) {
            let message = format!("`{}` is {}, and cannot be called", name.text, kind.ty());
            let d = Diagnostic::new(codes::E0208, place, message);
            self.push(d.related(Where::Item(name.text.clone()), "declared here"));
            return;
        }
        let d = match self.meant_functions(&name.text).as_slice() {
            [] => d.note(format!("define it: `predicate {}({}) := …;`", name.text, parameters(&types))),
            near => {
                let quoted: Vec<String> = near.iter().map(|near| format!("`{near}`")).collect();
                let d = d.label(format!("did you mean {}?", quoted.join(" or ")));
                near.iter().fold(d, |d, near| {
                    d.fix(Applicability::Unsafe, format!("write `{near}`"), place.clone(), near.as_str())
                })
            }
        };
        let d = match OTHERS.iter().find(|(other, _)| name.text.eq_ignore_ascii_case(other)) {
            Some(_) => d.note("solid objects do not overlap anyway, unless `allowCollide(a, b);` permits it"),
            None => d,
        };
        self.push(d);
    }

    /// The functions and predicates that a word is likely to mean: the nearest by its letters, else those whose names
    /// contain it as a word, `leftOf` for `left`.
    fn meant_functions(&self, name: &str) -> Vec<SmolStr> {
        if let Some((_, ours)) = OTHERS.iter().find(|(other, _)| name.eq_ignore_ascii_case(other)) {
            return vec![(*ours).into()];
        }
        let mut known: Vec<SmolStr> = natives::BUILT_INS.iter().map(|s| s.name.into()).collect();
        known.extend(self.names.predicates());
        known.push("not".into());
        known.sort_unstable();
        known.dedup();
        if let Some(near) = nearest(name, known.iter().map(SmolStr::as_str)) {
            return vec![near.into()];
        }
        if name.chars().count() < 3 {
            return Vec::new();
        }
        let follows = |rest: &str| rest.is_empty() || rest.starts_with(char::is_uppercase);
        let begins = |known: &&SmolStr| known.strip_prefix(name).is_some_and(follows);
        let mut letters = name.chars();
        let inner: String = letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect();
        let ends = |known: &&SmolStr| known.split_once(inner.as_str()).is_some_and(|(_, rest)| follows(rest));
        let mut near: Vec<SmolStr> = known.iter().filter(begins).cloned().collect();
        near.extend(known.iter().filter(ends).cloned());
        near.truncate(3);
        near
    }

    /// Offers `chair[1]` for `chair(1)`.
    fn in_brackets(&self, d: Diagnostic<Where>, id: ExprId, name: &Name, index: ExprId) -> Diagnostic<Where> {
        let (whole, inner) = (self.range(id), self.range(index));
        let edit =
            |start, end, text: &str| Edit { place: Where::Here(TextRange { start, end }), text: text.to_owned() };
        let edits = vec![edit(name.range.end, inner.start, "["), edit(inner.end, whole.end, "]")];
        let title = match &self.expr(index).kind {
            ExprKind::Number(index, None) => format!("write `{}[{index}]`", name.text),
            _ => "write brackets".to_owned(),
        };
        Diagnostic { fixes: vec![Fix { title, edits, applicability: Applicability::Unsafe }], ..d }
    }

    /// Checks the arguments of a predicate whose number is right.
    pub(super) fn arguments(&mut self, id: ExprId, name: &Name, args: &[ExprId], params: &[(Ty, SmolStr)]) {
        let before = self.out.len();
        let types: Vec<Ty> = args.iter().map(|arg| self.ty(*arg)).collect();
        if let ([a, b], [(x, _), (y, _)]) = (types.as_slice(), params)
            && self.out.len() == before
            && !a.fits(*x)
            && !b.fits(*y)
            && a.fits(*y)
            && b.fits(*x)
        {
            let names: Vec<&str> = params.iter().map(|(_, name)| name.as_str()).collect();
            let message = format!("the arguments of `{}({})` are in the wrong order", name.text, names.join(", "));
            let d = Diagnostic::new(codes::E0301, Where::Here(self.range(id)), message)
                .related(Where::Here(self.range(args[0])), format!("this is {a}"))
                .related(Where::Here(self.range(args[1])), format!("this is {b}"));
            let swapped = match (&self.expr(args[0]).kind, &self.expr(args[1]).kind) {
                (ExprKind::Name(first), ExprKind::Name(second)) => {
                    let edit = |at: ExprId, text: &SmolStr| Edit {
                        place: Where::Here(self.range(at)),
                        text: text.to_string(),
                    };
                    let title = format!("write `{}({second}, {first})`", name.text);
                    let edits = vec![edit(args[0], second), edit(args[1], first)];
                    vec![Fix { title, edits, applicability: Applicability::Unsafe }]
                }
                _ => Vec::new(),
            };
            self.push(Diagnostic { fixes: swapped, ..d });
            return;
        }
        for ((arg, ty), (wanted, param)) in args.iter().zip(types).zip(params) {
            self.argument(*arg, ty, *wanted, param, &name.text);
        }
    }

    fn argument(&mut self, arg: ExprId, ty: Ty, wanted: Ty, param: &str, of: &str) {
        if ty.fits(wanted) {
            return;
        }
        if ty == Ty::Objects && wanted == Ty::Object {
            self.bare_set(arg, &format!("`{of}` takes one object here"));
            return;
        }
        let message = format!("the argument `{param}` of `{of}` must be {wanted}, but this is {ty}");
        let d = Diagnostic::new(codes::E0301, Where::Here(self.range(arg)), message);
        if let ExprKind::Text(text) = &self.expr(arg).kind
            && self.names.item(text).is_some_and(|kind| kind.ty().fits(wanted))
        {
            let d = d.note("names are written without quotation marks");
            self.push(d.fix(
                Applicability::Unsafe,
                format!("write `{text}`"),
                Where::Here(self.range(arg)),
                text.as_str(),
            ));
            return;
        }
        self.push(self.repaired(d, arg, wanted, ty));
    }

    /// Requires a condition after `and`, `or` or `implies`. `a = 90 or 180` says how to write what is meant.
    pub(super) fn condition_after(&mut self, op: BinaryOp, left: ExprId, id: ExprId) {
        let ty = self.ty(id);
        let compared = match &self.expr(left).kind {
            ExprKind::Compare(first, steps) if ty != Ty::Bool && ty != Ty::Error => {
                steps.first().map(|step| (*first, step.0))
            }
            _ => None,
        };
        let (Some((first, sign)), BinaryOp::And | BinaryOp::Or) = (compared, op) else {
            return self.is_condition(id, ty);
        };
        let word = if op == BinaryOp::And { "and" } else { "or" };
        let message = format!("`{word}` joins conditions, but this is {ty}");
        let d = Diagnostic::new(codes::E0302, Where::Here(self.range(id)), message);
        let d = match self.path(first) {
            Some(path) => {
                let written = format!("{path} {} ", sign.sign());
                let start = self.range(id).start;
                let title = format!("repeat the comparison: `{word} {written}…`");
                d.fix(Applicability::Unsafe, title, Where::Here(TextRange { start, end: start }), written)
            }
            None => d.note(format!("repeat the comparison, as in `a = 90 {word} a = 180`")),
        };
        self.push(d);
    }

    /// A name with its properties, as it is written.
    fn path(&self, id: ExprId) -> Option<String> {
        match &self.expr(id).kind {
            ExprKind::Name(name) => Some(name.to_string()),
            ExprKind::Member(base, name) => Some(format!("{}.{}", self.path(*base)?, name.text)),
            _ => None,
        }
    }
}

/// The head of a predicate that takes arguments of some types.
fn parameters(types: &[Ty]) -> String {
    let mut letters = 'a'..='z';
    let each = types.iter().map(|ty| {
        let word = match ty {
            Ty::Literal | Ty::Range => "Number",
            Ty::Error | Ty::Side | Ty::Polygon | Ty::Regions => "Object",
            ty => ty.name(),
        };
        format!("{word} {}", letters.next().unwrap_or('z'))
    });
    each.collect::<Vec<_>>().join(", ")
}
