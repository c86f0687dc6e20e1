//! Every name in a file and what it stands for: the ground of navigation, renaming, colouring and hovering.

use scenelang_base::{FileId, TextRange};
use scenelang_lang::ast::{ExprId, ExprKind, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::{Hir, LocalKind, Meanings, Resolution};
use scenelang_lang::items::{ItemKind, Located};
use scenelang_lang::natives;
use scenelang_lang::token::{Kind, lex};
use scenelang_lang::types::Ty;
use smol_str::SmolStr;

use crate::Snapshot;

/// What a name stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// An object, an array, a region or a variable.
    Item(SmolStr, ItemKind),
    /// A parameter of a predicate or the variable of a quantifier: the statement's offset in the file, and which.
    Local {
        /// Offset of the statement.
        statement: u32,
        /// Index into the locals of the statement.
        index: usize,
        /// How it is bound.
        kind: LocalKind,
        /// Its type.
        ty: Ty,
    },
    /// A predicate of the program.
    Predicate(SmolStr),
    /// A predicate of the standard library.
    Library(SmolStr),
    /// A built-in function or predicate.
    BuiltIn(&'static str),
    /// A property of objects or of regions.
    Property(Ty, &'static str),
    /// `x`, `y` or `z`.
    Component,
    /// A side word.
    Side,
    AllObjects,
    AllRooms,
}

/// What is done with the name where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It is declared or defined.
    Declares,
    /// It is given a value.
    Writes,
    /// It is read, or called.
    Reads,
}

/// A name in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Occurrence {
    /// Its bytes in the file.
    pub range: TextRange,
    /// What it stands for.
    pub symbol: Symbol,
    /// What is done with it.
    pub role: Role,
    /// Offset of the statement that it stands in.
    pub statement: u32,
}

/// All names of a file, in the order of the text.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn occurrences(snapshot: &Snapshot, file: FileId) -> Result<Vec<Occurrence>, Cancelled> {
    let meanings = snapshot.analysis().meanings(file)?;
    let text = snapshot.sources().get(file).text();
    let items = Items::of(snapshot, &meanings);
    let mut out = Vec::new();
    for (place, hir) in &meanings.statements {
        Statement { place: *place, hir, items: &items, text, out: &mut out }.collect();
    }
    out.sort_by_key(|o: &Occurrence| (o.range.start, o.range.end));
    out.dedup_by(|a, b| a.range == b.range);
    Ok(out)
}

/// The name at an offset of a file: the one that holds it or, if none does, that ends there.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn name_at(snapshot: &Snapshot, file: FileId, offset: u32) -> Result<Option<Occurrence>, Cancelled> {
    let all = occurrences(snapshot, file)?;
    Ok(at(&all, offset).cloned())
}

pub(crate) fn at(all: &[Occurrence], offset: u32) -> Option<&Occurrence> {
    let holds = |o: &&Occurrence| o.range.start <= offset && offset < o.range.end;
    all.iter().find(holds).or_else(|| all.iter().find(|o| o.range.end == offset))
}

/// What names of the program stand for, for statements that did not parse.
struct Items {
    declared: Vec<(SmolStr, ItemKind)>,
    defined: Vec<SmolStr>,
}

impl Items {
    fn of(snapshot: &Snapshot, meanings: &Meanings<'_>) -> Self {
        // Only broken statements ask.
        if meanings.statements.iter().all(|(place, _)| !matches!(place.stmt.kind, StmtKind::Error)) {
            return Self { declared: Vec::new(), defined: Vec::new() };
        }
        let mut declared = Vec::new();
        for (id, _) in snapshot.sources().iter() {
            let Ok(other) = snapshot.analysis().meanings(id) else { continue };
            declared.extend(other.statements.iter().filter_map(|(place, _)| declared_kind(place)));
        }
        Self { declared, defined: meanings.defined.keys().cloned().collect() }
    }

    fn symbol(&self, name: &str) -> Option<Symbol> {
        let item = self.declared.iter().find(|(n, _)| n == name);
        let item = item.map(|(n, kind)| Symbol::Item(n.clone(), *kind));
        item.or_else(|| self.defined.iter().find(|n| *n == name).map(|n| Symbol::Predicate(n.clone())))
    }
}

/// The name that a statement declares, and what it is.
pub(crate) fn declared_kind(place: &Located<'_>) -> Option<(SmolStr, ItemKind)> {
    use scenelang_lang::ast::TypeWord;
    let StmtKind::Declare { ty, name, size, .. } = &place.stmt.kind else { return None };
    let count = size.and_then(|id| scenelang_lang::items::whole_number(place.stmt, id)).unwrap_or(1.0);
    let kind = match ty {
        TypeWord::Object if size.is_some() => ItemKind::Array(count.max(1.0) as u32),
        TypeWord::Object => ItemKind::Object,
        TypeWord::Region => ItemKind::Region,
        other => ItemKind::Variable(Ty::of(*other)),
    };
    Some((name.text.clone(), kind))
}

struct Statement<'a> {
    place: Located<'a>,
    hir: &'a Hir,
    items: &'a Items,
    text: &'a str,
    out: &'a mut Vec<Occurrence>,
}

impl Statement<'_> {
    /// A name at a range that is relative to the statement.
    fn push(&mut self, range: TextRange, symbol: Symbol, role: Role) {
        let statement = self.place.offset;
        self.out.push(Occurrence { range: range.shifted(statement), symbol, role, statement });
    }

    fn collect(&mut self) {
        let stmt = self.place.stmt;
        match &stmt.kind {
            StmtKind::Declare { name, .. } => {
                if let Some((text, kind)) = declared_kind(&self.place) {
                    self.push(name.range, Symbol::Item(text, kind), Role::Declares);
                }
            }
            StmtKind::Predicate { name, .. } if !natives::is_built_in(&name.text) => {
                self.push(name.range, Symbol::Predicate(name.text.clone()), Role::Declares);
            }
            StmtKind::Assign { name, path, .. } => {
                if let Some(target) = &self.hir.target {
                    let role = if path.is_empty() { Role::Writes } else { Role::Reads };
                    if let Some(symbol) = self.symbol(&target.owner) {
                        self.push(name.range, symbol, role);
                    }
                    if let (Some(property), Some(written)) = (target.property, path.first()) {
                        let of = match &target.owner {
                            Resolution::Item(_, ItemKind::Region) => Ty::Region,
                            _ => Ty::Object,
                        };
                        self.push(written.range, Symbol::Property(of, property.name), Role::Writes);
                    }
                }
            }
            StmtKind::Error => self.broken(),
            _ => {}
        }
        for (index, local) in self.hir.locals.iter().enumerate() {
            let symbol = Symbol::Local { statement: self.place.offset, index, kind: local.kind, ty: local.ty };
            self.push(local.range, symbol, Role::Declares);
        }
        for (i, expr) in stmt.exprs.iter().enumerate() {
            let Some(resolution) = self.hir.resolution(ExprId(i as u32)) else { continue };
            let range = match &expr.kind {
                ExprKind::Name(_) | ExprKind::Objects => expr.range,
                ExprKind::Member(_, name) | ExprKind::Own(name) | ExprKind::Call(name, _) => name.range,
                // The array's own name is an expression of its own, which nobody resolves.
                ExprKind::Index(base, _) => stmt.expr(*base).range,
                _ => continue,
            };
            if let Some(symbol) = self.symbol(resolution) {
                self.push(range, symbol, Role::Reads);
            }
        }
    }

    fn symbol(&self, resolution: &Resolution) -> Option<Symbol> {
        Some(match resolution {
            Resolution::Item(name, kind) => Symbol::Item(name.clone(), *kind),
            // How many there are is said where it is declared.
            Resolution::Element { array, .. } => Symbol::Item(array.clone(), ItemKind::Array(0)),
            Resolution::AllObjects => Symbol::AllObjects,
            Resolution::AllRooms => Symbol::AllRooms,
            Resolution::Local(index) => {
                let local = self.hir.locals.get(*index)?;
                Symbol::Local { statement: self.place.offset, index: *index, kind: local.kind, ty: local.ty }
            }
            Resolution::Predicate { name, library: true } => Symbol::Library(name.clone()),
            Resolution::Predicate { name, library: false } => Symbol::Predicate(name.clone()),
            Resolution::BuiltIn(signature) => Symbol::BuiltIn(signature.name),
            Resolution::Property { of, property } => Symbol::Property(*of, property.name),
            Resolution::Component => Symbol::Component,
            Resolution::Side(_) => Symbol::Side,
        })
    }

    /// Names in a statement that did not parse: those that are declared somewhere, properties left out.
    fn broken(&mut self) {
        let range = self.place.stmt.range.shifted(self.place.offset);
        let Some(text) = self.text.get(range.bytes()) else { return };
        let mut after_dot = false;
        for token in lex(text) {
            if token.kind == Kind::Ident
                && !after_dot
                && let Some(symbol) = self.items.symbol(&text[token.range.bytes()])
            {
                self.push(token.range.shifted(self.place.stmt.range.start), symbol, Role::Reads);
            }
            after_dot = token.kind == Kind::Dot || (after_dot && token.kind.is_trivia());
        }
    }
}

impl Symbol {
    /// Whether two occurrences mean the same thing. An element means its array.
    pub fn is(&self, other: &Symbol) -> bool {
        match (self, other) {
            (Self::Item(a, _), Self::Item(b, _)) => a == b,
            (Self::Local { statement: a, index: i, .. }, Self::Local { statement: b, index: j, .. }) => {
                a == b && i == j
            }
            _ => self == other,
        }
    }

    /// Whether it can be given another name.
    pub fn is_own(&self) -> bool {
        matches!(self, Self::Item(..) | Self::Local { .. } | Self::Predicate(_))
    }
}
