//! What is declared: objects, arrays, regions, variables, predicates, assignments; and what is declared or assigned
//! twice.

use crate::ast::{ExprKind, Param, Stmt, StmtKind, TypeWord};
use crate::library;
use crate::natives;
use crate::sources::Units;
use crate::types::Ty;
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::{Diagnostic, FileId, Span, TextRange, codes};
use smol_str::SmolStr;

/// A statement and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// The file; `None`: the library.
    pub file: Option<FileId>,
    /// Byte offset of the statement's text in its file.
    pub offset: u32,
    /// The statement.
    pub stmt: &'a Stmt,
}

impl Place<'_> {
    /// A range of the statement as a place in the file. Library statements have no place in the user's files.
    pub fn span(&self, range: TextRange) -> Option<Span> {
        Some(range.shifted(self.offset).in_file(self.file?))
    }
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub struct Item<'a> {
    /// The declaration.
    pub place: Place<'a>,
    /// The declared name.
    pub span: Span,
    /// What it is.
    pub kind: ItemKind,
}

/// Kinds of declared names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// One object.
    Object,
    /// An array of objects and its size.
    Array(u32),
    /// A region.
    Region,
    /// A variable of a type.
    Variable(Ty),
}

impl ItemKind {
    /// The type of the bare name.
    pub fn ty(self) -> Ty {
        match self {
            Self::Object => Ty::Object,
            Self::Array(_) => Ty::Objects,
            Self::Region => Ty::Region,
            Self::Variable(ty) => ty,
        }
    }
}

/// A predicate of the program or the library.
#[derive(Clone, Copy, Debug)]
pub struct Predicate<'a> {
    /// Its definition.
    pub place: Place<'a>,
    /// Its name.
    pub name: &'a SmolStr,
    /// Its parameters.
    pub params: &'a [Param],
    /// Its body, in the statement's expressions.
    pub body: crate::ast::ExprId,
}

impl Predicate<'_> {
    /// Whether it belongs to the library.
    pub fn is_library(&self) -> bool {
        self.place.file.is_none()
    }
}

/// An assignment: the statement and its target.
#[derive(Clone, Copy, Debug)]
pub struct Assignment<'a> {
    /// The statement.
    pub place: Place<'a>,
    /// Its right side.
    pub value: crate::ast::ExprId,
    /// All of the target.
    pub target: TextRange,
}

/// What is assigned: a variable (`property` empty), or a property of an object, an element, or a region.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct AssignKey {
    /// Base name.
    pub name: SmolStr,
    /// Which element of an array.
    pub element: Option<u32>,
    /// The property.
    pub property: SmolStr,
}

/// Largest array (elements).
pub const MAX_ARRAY: f64 = 1_000_000.0;

/// What a checker asks of names. The answers say nothing about places, so that who caches them need not ask again when
/// text moves.
pub trait Names {
    /// What a name stands for.
    fn item(&self, name: &str) -> Option<ItemKind>;
    /// Whether a variable is assigned.
    fn is_assigned(&self, variable: &str) -> bool;
    /// Whether a name stands in a statement that did not parse.
    fn is_poisoned(&self, name: &str) -> bool;
    /// The predicate that a call means, seen from the library or from the program.
    fn predicate(&self, name: &str, from_library: bool) -> Option<PredicateHead>;
    /// All declared names, for "did you mean".
    fn declared(&self) -> Vec<SmolStr>;
    /// All predicates, for "did you mean".
    fn predicates(&self) -> Vec<SmolStr>;
}

/// What a call needs to know of a predicate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PredicateHead {
    /// Types and names of its parameters.
    pub params: Vec<(Ty, SmolStr)>,
    /// Whether it is of the library.
    pub library: bool,
    /// Whether its definition did not parse: then its calls are not judged.
    pub broken: bool,
}

/// The size of an array whose size is wrong: large enough that its elements are not reported, too.
const UNKNOWN_SIZE: u32 = 10_000;

/// All that is declared in a program.
#[derive(Debug, Default)]
pub struct Items<'a> {
    /// Names in order of declaration, each once.
    pub order: Vec<SmolStr>,
    /// What they stand for.
    pub names: FxHashMap<SmolStr, Item<'a>>,
    /// User predicates by name.
    pub predicates: FxHashMap<SmolStr, Predicate<'a>>,
    /// Library predicates by name.
    pub library: FxHashMap<SmolStr, Predicate<'a>>,
    /// Assignments by what they assign; for an array assigned by its bare name, one entry for each element.
    pub assignments: FxHashMap<AssignKey, Assignment<'a>>,
    /// Names that stand in statements that did not parse: not reported as unknown.
    pub poisoned: FxHashSet<SmolStr>,
}

impl<'a> Items<'a> {
    /// The predicate that a call in `place` means: the program's own first, but the library calls only itself.
    pub fn predicate(&self, name: &str, from_library: bool) -> Option<Predicate<'a>> {
        let own = if from_library { None } else { self.predicates.get(name) };
        own.or_else(|| self.library.get(name)).copied()
    }

    /// Collects what the units declare and assign.
    pub fn collect(units: &'a Units, texts: impl Fn(FileId, TextRange) -> &'a str) -> (Self, Vec<Diagnostic>) {
        let mut items = Self::default();
        let mut out = Vec::new();
        for (file, statements) in library::parsed().iter().map(|f| (None::<FileId>, &f.statements)) {
            for (offset, stmt) in statements {
                if let StmtKind::Predicate { name, params, body } = &stmt.kind {
                    let place = Place { file, offset: *offset, stmt };
                    items.library.insert(name.text.clone(), Predicate { place, name: &name.text, params, body: *body });
                }
            }
        }
        let places = || {
            units.units.iter().flat_map(|u| {
                u.parsed.statements.iter().map(|(offset, stmt)| Place { file: Some(u.file), offset: *offset, stmt })
            })
        };
        for place in places() {
            items.declare(place, &texts, &mut out);
        }
        for place in places() {
            items.assign(place, &mut out);
        }
        (items, out)
    }

    fn declare(&mut self, place: Place<'a>, texts: &impl Fn(FileId, TextRange) -> &'a str, out: &mut Vec<Diagnostic>) {
        let (Some(file), stmt) = (place.file, place.stmt) else { return };
        let at = |range: TextRange| range.shifted(place.offset).in_file(file);
        match &stmt.kind {
            StmtKind::Declare { ty, name, size, .. } => {
                let kind = match (ty, size) {
                    (TypeWord::Object, Some(size)) => match array_size(stmt, *size) {
                        Ok(n) => ItemKind::Array(n),
                        Err(message) => {
                            out.push(Diagnostic::new(codes::E0304, at(stmt.expr(*size).range), message));
                            ItemKind::Array(UNKNOWN_SIZE)
                        }
                    },
                    (TypeWord::Object, None) => ItemKind::Object,
                    (word, size) => {
                        if let Some(size) = size {
                            let message = "only objects can be declared as an array";
                            out.push(Diagnostic::new(codes::E0212, at(stmt.expr(*size).range), message));
                        }
                        match Ty::of(*word) {
                            Ty::Region => ItemKind::Region,
                            ty => ItemKind::Variable(ty),
                        }
                    }
                };
                let span = at(name.range);
                if let Some(first) = self.names.get(&name.text) {
                    let message = format!("`{}` is declared twice", name.text);
                    out.push(
                        Diagnostic::new(codes::E0202, span, message)
                            .label("declared again")
                            .related(first.span, "first declared here")
                            .note("give one of them another name, or remove one"),
                    );
                } else {
                    self.order.push(name.text.clone());
                    self.names.insert(name.text.clone(), Item { place, span, kind });
                }
            }
            StmtKind::Predicate { name, params, body } => {
                let span = at(name.range);
                if natives::is_built_in(&name.text) {
                    let message = format!("`{}` is built in and cannot be redefined", name.text);
                    out.push(Diagnostic::new(codes::E0209, span, message).note("give the predicate another name"));
                } else if let Some(first) = self.predicates.get(&name.text) {
                    let first = first.place;
                    let message = format!("predicate `{}` is defined twice", name.text);
                    let mut d = Diagnostic::new(codes::E0202, span, message).label("defined again");
                    if let (StmtKind::Predicate { name, .. }, Some(f)) = (&first.stmt.kind, first.file) {
                        d = d.related(name.range.shifted(first.offset).in_file(f), "first defined here");
                    }
                    out.push(d);
                } else {
                    let predicate = Predicate { place, name: &name.text, params, body: *body };
                    self.predicates.insert(name.text.clone(), predicate);
                }
            }
            StmtKind::Error => {
                let text = texts(file, stmt.range.shifted(place.offset));
                let word = |c: char| c == '_' || c.is_alphanumeric();
                self.poisoned.extend(text.split(|c| !word(c)).filter(|w| !w.is_empty()).map(SmolStr::new));
            }
            _ => {}
        }
    }

    fn assign(&mut self, place: Place<'a>, out: &mut Vec<Diagnostic>) {
        let (Some(file), StmtKind::Assign { name, index, path, target, value }) = (place.file, &place.stmt.kind) else {
            return;
        };
        let Some(kind) = self.names.get(&name.text).map(|i| i.kind) else { return };
        if path.len() > 1 {
            return;
        }
        let property = path.first().map_or(SmolStr::default(), |p| p.text.clone());
        let elements: Vec<Option<u32>> = match (kind, index) {
            (ItemKind::Array(n), None) => (0..n).map(Some).collect(),
            (ItemKind::Array(n), Some(i)) => match whole_number(place.stmt, *i) {
                Some(i) if i >= 0.0 && i < f64::from(n) => vec![Some(i as u32)],
                _ => return,
            },
            _ => vec![None],
        };
        let assignment = Assignment { place, value: *value, target: *target };
        let mut first_place = None;
        for element in elements {
            let key = AssignKey { name: name.text.clone(), element, property: property.clone() };
            match self.assignments.get(&key) {
                Some(first) => first_place = first_place.or(Some((first.place, first.target))),
                None => {
                    self.assignments.insert(key, assignment);
                }
            }
        }
        if let Some((first, first_target)) = first_place {
            let what = if property.is_empty() { name.text.to_string() } else { format!("{}.{property}", name.text) };
            let mut d = Diagnostic::new(
                codes::E0203,
                target.shifted(place.offset).in_file(file),
                format!("`{what}` is assigned twice"),
            )
            .label("assigned again")
            .note("a program is a set of statements: a property or variable has one value");
            if let Some(span) = first.span(first_target) {
                d = d.related(span, "first assigned here");
            }
            out.push(d);
        }
    }
}

impl Names for Items<'_> {
    fn item(&self, name: &str) -> Option<ItemKind> {
        self.names.get(name).map(|i| i.kind)
    }
    fn is_assigned(&self, variable: &str) -> bool {
        let key = AssignKey { name: variable.into(), element: None, property: SmolStr::default() };
        self.assignments.contains_key(&key)
    }
    fn is_poisoned(&self, name: &str) -> bool {
        self.poisoned.contains(name)
    }
    fn predicate(&self, name: &str, from_library: bool) -> Option<PredicateHead> {
        let p = Items::predicate(self, name, from_library)?;
        let params = p.params.iter().map(|x| (Ty::of(x.ty), x.name.text.clone())).collect();
        let broken = matches!(p.place.stmt.expr(p.body).kind, ExprKind::Error);
        Some(PredicateHead { params, library: p.is_library(), broken })
    }
    fn declared(&self) -> Vec<SmolStr> {
        self.order.clone()
    }
    fn predicates(&self) -> Vec<SmolStr> {
        let mut all: Vec<SmolStr> = self.predicates.keys().chain(self.library.keys()).cloned().collect();
        all.sort_unstable();
        all
    }
}

/// A whole number written as literals, with a sign or arithmetic.
pub fn whole_number(stmt: &Stmt, id: crate::ast::ExprId) -> Option<f64> {
    let value = crate::check::constant::number(stmt, id)?;
    (value.fract() == 0.0).then_some(value)
}

fn array_size(stmt: &Stmt, id: crate::ast::ExprId) -> Result<u32, String> {
    let literal = match &stmt.expr(id).kind {
        ExprKind::Number(n, None) => Some(*n),
        ExprKind::Error => Some(f64::from(UNKNOWN_SIZE)), // reported by the parser
        _ => None,
    };
    match literal {
        Some(n) if n.fract() != 0.0 || n < 1.0 => {
            Err(format!("an array has a whole number of elements, at least 1; {n} is none"))
        }
        Some(n) if n > MAX_ARRAY => Err(format!("an array of {n} elements is too large; at most {MAX_ARRAY}")),
        Some(n) => Ok(n as u32),
        None => Err("the size of an array is a whole number written as such, at least 1".into()),
    }
}
