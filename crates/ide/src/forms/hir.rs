//! `scenelang hir`: what the names and expressions of a program mean, before it is expanded.

use scenelang_base::{SourceFile, SourceMap, Span, TextRange};
use scenelang_lang::ast::{ExprId, ExprKind, Stmt, StmtKind};
use scenelang_lang::hir::{Hir, LocalKind, Meanings, Resolution};
use scenelang_lang::items::{ItemKind, Located, whole_number};
use scenelang_lang::natives::{SIDES, Signature};
use scenelang_lang::program::ObjectSide;
use scenelang_lang::syntax::NodeKind;
use scenelang_lang::types::Ty;
use scenelang_verify::report;
use serde_json::{Value, json};
use std::fmt::Write;

/// The value of the member `format`.
const FORMAT: &str = "scenelang.hir/1";
/// Longer texts of expressions are cut, in the form for people (characters).
const LONGEST: usize = 60;

/// Declarations and statements of a file, for people.
pub fn text(file: &SourceFile, sources: &SourceMap, meanings: &Meanings<'_>) -> String {
    View { file, sources, meanings }.text()
}

/// The same for programs.
pub fn json(file: &SourceFile, sources: &SourceMap, meanings: &Meanings<'_>) -> Value {
    View { file, sources, meanings }.json()
}

struct View<'a> {
    file: &'a SourceFile,
    sources: &'a SourceMap,
    meanings: &'a Meanings<'a>,
}

/// A statement and what it means.
#[derive(Clone, Copy)]
struct Meant<'a> {
    place: Located<'a>,
    hir: &'a Hir,
}

impl<'a> View<'a> {
    fn statements(&self) -> impl Iterator<Item = Meant<'a>> {
        self.meanings.statements.iter().map(|(place, hir)| Meant { place: *place, hir })
    }

    fn slice(&self, meant: Meant<'_>, range: TextRange) -> &'a str {
        self.file.slice(range.shifted(meant.place.offset))
    }

    // ── For people ──

    fn text(&self) -> String {
        let mut out = String::new();
        for meant in self.statements() {
            let name = declared_name(meant.place.stmt);
            if let Some((name, span)) = name.and_then(|n| Some((n, meant.place.span(n)?))) {
                let declared = declaration_in_words(meant.place.stmt, self.slice(meant, name));
                let _ = writeln!(out, "{}: {declared}", report::statement_id(self.file.name(), self.sources, span));
            }
        }
        for meant in self.statements() {
            let stmt = meant.place.stmt;
            let Some(span) = meant.place.span(stmt.range) else { continue };
            let id = report::statement_id(self.file.name(), self.sources, span);
            let said = shortened(self.slice(meant, stmt.range));
            let _ = writeln!(out, "\n{id}: {} {said}", NodeKind::from(&stmt.kind));
            if let (Some(target), StmtKind::Assign { target: range, .. }) = (&meant.hir.target, &stmt.kind) {
                let of = resolution_in_words(&target.owner, meant.hir);
                let property = target.property.map_or(String::new(), |p| format!(", property {}", p.name));
                let _ = writeln!(out, "  {} : {} = {of}{property}", self.slice(meant, *range), target.ty.name());
            }
            self.expressions(meant, &mut out);
        }
        out
    }

    /// The expressions of a statement, each below the one it is part of. No recursion: they may nest deeply.
    fn expressions(&self, meant: Meant<'_>, out: &mut String) {
        let exprs = &meant.place.stmt.exprs;
        let mut is_part = vec![false; exprs.len()];
        exprs.iter().for_each(|e| e.kind.for_each_child(|child| is_part[child.0 as usize] = true));
        let roots = (0..exprs.len()).rev().filter(|i| !is_part[*i]);
        let mut stack: Vec<(usize, ExprId)> = roots.map(|i| (1, ExprId(i as u32))).collect();
        while let Some((depth, id)) = stack.pop() {
            let expr = meant.place.stmt.expr(id);
            let ty = meant.hir.type_of(id).map_or("unknown", Ty::name);
            let _ = write!(out, "{:1$}{2} : {ty}", "", 2 * depth, shortened(self.slice(meant, expr.range)));
            if let Some(resolution) = meant.hir.resolution(id) {
                let _ = write!(out, " = {}", resolution_in_words(resolution, meant.hir));
            }
            out.push('\n');
            let first = stack.len();
            expr.kind.for_each_child(|child| stack.push((depth + 1, child)));
            stack[first..].reverse();
        }
    }

    // ── For programs ──

    fn json(&self) -> Value {
        let declarations: Vec<Value> = self.statements().filter_map(|m| self.declaration(m)).collect();
        let statements: Vec<Value> = self.statements().filter_map(|m| self.statement(m)).collect();
        json!({
            "format": FORMAT,
            "file": self.file.name(),
            "declarations": declarations,
            "statements": statements,
        })
    }

    fn declaration(&self, meant: Meant<'_>) -> Option<Value> {
        let stmt = meant.place.stmt;
        let name = declared_name(stmt)?;
        let span = report::place(self.sources, meant.place.span(name)?);
        let mut out = json!({ "name": self.slice(meant, name) });
        match &stmt.kind {
            StmtKind::Declare { ty, size, .. } => {
                out["kind"] = json!(item_kind(Ty::of(*ty), size.is_some()));
                out["type"] = json!(if size.is_some() { Ty::Objects } else { Ty::of(*ty) }.name());
                if let Some(n) = size.and_then(|size| whole_number(stmt, size)) {
                    out["size"] = json!(n as u64);
                }
            }
            StmtKind::Predicate { params, .. } => {
                let param = |p: &scenelang_lang::ast::Param| json!({ "name": p.name.text.as_str(), "type": Ty::of(p.ty).name() });
                out["kind"] = json!("predicate");
                out["type"] = json!(Ty::Bool.name());
                out["parameters"] = params.iter().map(param).collect();
            }
            _ => return None,
        }
        out["doc"] = json!(stmt.doc);
        out["span"] = json!(span);
        Some(out)
    }

    fn statement(&self, meant: Meant<'_>) -> Option<Value> {
        let stmt = meant.place.stmt;
        let span = meant.place.span(stmt.range)?;
        let mut out = json!({
            "id": report::statement_id(self.file.name(), self.sources, span),
            "kind": NodeKind::from(&stmt.kind).to_string(),
            "span": report::place(self.sources, span),
        });
        if let Some(target) = &meant.hir.target {
            out["target"] = json!({
                "owner": self.resolution(&target.owner, meant),
                "property": target.property.map(|p| p.name),
                "type": target.ty.name(),
            });
        }
        out["expressions"] = (0..stmt.exprs.len()).map(|i| self.expression(meant, ExprId(i as u32))).collect();
        Some(out)
    }

    fn expression(&self, meant: Meant<'_>, id: ExprId) -> Value {
        let expr = meant.place.stmt.expr(id);
        let mut children = Vec::new();
        expr.kind.for_each_child(|child| children.push(child.0));
        let mut out = json!({
            "kind": NodeKind::from(&expr.kind).to_string(),
            "range": bytes(expr.range.shifted(meant.place.offset)),
        });
        if matches!(expr.kind, ExprKind::Number(..) | ExprKind::Text(_) | ExprKind::Bool(_) | ExprKind::Name(_)) {
            out["text"] = json!(self.slice(meant, expr.range));
        }
        out["type"] = json!(meant.hir.type_of(id).map(Ty::name));
        out["resolution"] = json!(meant.hir.resolution(id).map(|r| self.resolution(r, meant)));
        out["children"] = json!(children);
        out
    }

    fn resolution(&self, resolution: &Resolution, meant: Meant<'_>) -> Value {
        let place = |span: Option<&Span>| {
            span.map(|span| json!({ "file": self.sources.get(span.file).name(), "range": bytes(span.range) }))
        };
        let item = |name: &str| place(self.meanings.declared.get(name));
        match resolution {
            Resolution::Item(name, kind) => {
                let kind = item_kind(kind.ty(), matches!(kind, ItemKind::Array(_)));
                json!({ "kind": kind, "name": name.as_str(), "declared": item(name) })
            }
            Resolution::Element { array, index } => {
                json!({ "kind": "element", "name": array.as_str(), "index": index, "declared": item(array) })
            }
            Resolution::AllRooms => json!({ "kind": "rooms" }),
            Resolution::AllObjects => json!({ "kind": "objects" }),
            Resolution::Local(local) => {
                let local = &meant.hir.locals[*local];
                json!({
                    "kind": local_kind(local.kind),
                    "name": local.name.as_str(),
                    "declared": place(meant.place.span(local.range).as_ref()),
                })
            }
            Resolution::Predicate { name, library } => {
                let declared = if *library { None } else { place(self.meanings.defined.get(name)) };
                json!({ "kind": "predicate", "name": name.as_str(), "library": library, "declared": declared })
            }
            Resolution::BuiltIn(signature) => {
                json!({ "kind": "built-in", "name": signature.name, "signature": in_words(signature) })
            }
            Resolution::Property { of, property } => {
                json!({ "kind": "property", "of": of.name(), "name": property.name })
            }
            Resolution::Component => json!({ "kind": "component" }),
            Resolution::Side(side) => json!({ "kind": "side", "name": side_word(*side) }),
        }
    }
}

fn bytes(range: TextRange) -> [u32; 2] {
    [range.start, range.end]
}

/// The name that a statement declares or defines.
fn declared_name(stmt: &Stmt) -> Option<TextRange> {
    match &stmt.kind {
        StmtKind::Declare { name, .. } | StmtKind::Predicate { name, .. } => Some(name.range),
        _ => None,
    }
}

fn declaration_in_words(stmt: &Stmt, name: &str) -> String {
    match &stmt.kind {
        StmtKind::Declare { ty, size: Some(size), .. } => {
            let size = whole_number(stmt, *size).map_or("?".to_owned(), |n| n.to_string());
            format!("{} {name}[{size}]", item_kind(Ty::of(*ty), true))
        }
        StmtKind::Declare { ty, size: None, .. } => match Ty::of(*ty) {
            ty @ (Ty::Object | Ty::Region) => format!("{} {name}", item_kind(ty, false)),
            ty => format!("variable {name} : {}", ty.name()),
        },
        StmtKind::Predicate { params, .. } => {
            let params: Vec<String> =
                params.iter().map(|p| format!("{} {}", Ty::of(p.ty).name(), p.name.text)).collect();
            format!("predicate {name}({})", params.join(", "))
        }
        _ => name.to_owned(),
    }
}

fn resolution_in_words(resolution: &Resolution, hir: &Hir) -> String {
    match resolution {
        Resolution::Item(name, ItemKind::Array(n)) => format!("array {name}[{n}]"),
        Resolution::Item(name, kind) => format!("{} {name}", item_kind(kind.ty(), false)),
        Resolution::Element { array, index: Some(i) } => format!("element {array}[{i}]"),
        Resolution::Element { array, index: None } => format!("element of {array}"),
        Resolution::AllRooms => "all rooms".to_owned(),
        Resolution::AllObjects => "all objects".to_owned(),
        Resolution::Local(local) => format!("{} {}", local_kind(hir.locals[*local].kind), hir.locals[*local].name),
        Resolution::Predicate { name, library: true } => format!("library predicate {name}"),
        Resolution::Predicate { name, library: false } => format!("predicate {name}"),
        Resolution::BuiltIn(signature) => format!("built-in {}", in_words(signature)),
        Resolution::Property { of, property } => format!("property {} of {}", property.name, of.name()),
        Resolution::Component => "component".to_owned(),
        Resolution::Side(side) => format!("side {}", side_word(*side)),
    }
}

fn item_kind(ty: Ty, array: bool) -> &'static str {
    match ty {
        _ if array => "array",
        Ty::Object => "object",
        Ty::Region => "region",
        _ => "variable",
    }
}

fn local_kind(kind: LocalKind) -> &'static str {
    match kind {
        LocalKind::Parameter => "parameter",
        LocalKind::Variable => "bound",
    }
}

fn side_word(side: ObjectSide) -> &'static str {
    SIDES.iter().find(|(_, s)| *s == side).map_or("", |(word, _)| word)
}

/// `gap(Object, Region)`
fn in_words(signature: &Signature) -> String {
    let name = |ty: &Ty| if *ty == Ty::Literal { "Number or Degree" } else { ty.name() };
    let mut params: Vec<&str> = signature.params.iter().map(name).collect();
    params.extend(signature.variadic.then_some("…"));
    format!("{}({})", signature.name, params.join(", "))
}

/// A text with its blanks folded, cut where it gets long; what the parser has lost has no text.
fn shortened(text: &str) -> String {
    if text.is_empty() {
        return "…".to_owned();
    }
    let mut out = String::new();
    let mut length = 0;
    for word in text.split_whitespace() {
        if length > 0 {
            out.push(' ');
        }
        for c in word.chars() {
            if length >= LONGEST {
                out.push('…');
                return out;
            }
            out.push(c);
            length += 1;
        }
        length += 1;
    }
    out
}
