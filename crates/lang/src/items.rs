//! What is declared: objects, arrays, regions, variables, predicates, assignments.

use crate::ast::{ExprId, ExprKind, Param, Stmt, StmtKind};
use crate::db::{At, NameTable};
use crate::library;
use crate::types::Ty;
use rustc_hash::FxHashMap;
use scenelang_base::{FileId, Span, TextRange};
use smol_str::SmolStr;

/// A statement and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Located<'a> {
    /// The file; `None`: the library.
    pub file: Option<FileId>,
    /// Byte offset of the statement's text in its file.
    pub offset: u32,
    /// The statement.
    pub stmt: &'a Stmt,
}

impl Located<'_> {
    /// A range of the statement as a place in the file. Library statements have no place in the user's files.
    pub fn span(&self, range: TextRange) -> Option<Span> {
        Some(range.shifted(self.offset).in_file(self.file?))
    }
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub struct Item<'a> {
    /// The declaration.
    pub place: Located<'a>,
    /// The declared name.
    pub span: Span,
    pub kind: ItemKind,
}

/// Kinds of declared names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ItemKind {
    Object,
    /// An array of objects and its size.
    Array(u32),
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
    pub place: Located<'a>,
    pub name: &'a SmolStr,
    pub params: &'a [Param],
    /// Its body, in the statement's expressions.
    pub body: ExprId,
}

impl<'a> Predicate<'a> {
    /// The predicate that a statement defines.
    pub(crate) fn of(place: Located<'a>) -> Option<Self> {
        let StmtKind::Predicate { name, params, body } = &place.stmt.kind else { return None };
        Some(Self { place, name: &name.text, params, body: *body })
    }
    /// Whether it belongs to the library.
    pub fn is_library(&self) -> bool {
        self.place.file.is_none()
    }
}

/// An assignment: the statement and its target.
#[derive(Clone, Copy, Debug)]
pub struct Assignment<'a> {
    /// The statement.
    pub place: Located<'a>,
    /// Its right side.
    pub value: ExprId,
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
    /// The predicate that a call means: the program's own, else the library's.
    fn predicate(&self, name: &str) -> Option<PredicateHead>;
    /// All declared names, for "did you mean".
    fn declared(&self) -> Vec<SmolStr>;
    /// All predicates, for "did you mean".
    fn predicates(&self) -> Vec<SmolStr>;
}

/// What a call needs to know of a predicate.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct PredicateHead {
    /// Types and names of its parameters.
    pub params: Vec<(Ty, SmolStr)>,
    /// Whether it is of the library.
    pub library: bool,
    /// Whether its definition did not parse: then its calls are not judged.
    pub broken: bool,
}

/// What a call needs to know of a definition.
pub(crate) fn head_of(stmt: &Stmt, params: &[Param], body: ExprId, library: bool) -> PredicateHead {
    PredicateHead {
        params: params.iter().map(|p| (Ty::of(p.ty), p.name.text.clone())).collect(),
        library,
        broken: matches!(stmt.expr(body).kind, ExprKind::Error),
    }
}

/// All that is declared in a program, with the statements that do it.
pub struct Items<'a> {
    /// Names in order of declaration, each once.
    pub order: &'a [SmolStr],
    /// What they stand for.
    pub names: FxHashMap<SmolStr, Item<'a>>,
    /// User predicates by name.
    pub predicates: FxHashMap<SmolStr, Predicate<'a>>,
    /// Assignments by what they assign; for an array assigned by its bare name, one entry for each element.
    pub assignments: FxHashMap<AssignKey, Assignment<'a>>,
}

impl<'a> Items<'a> {
    /// The declared names with their statements, which `place` finds.
    pub(crate) fn new(
        table: &'a NameTable,
        assigned: &FxHashMap<AssignKey, At>,
        place: impl Fn(At) -> Located<'a>,
    ) -> Self {
        let item = |(name, (kind, at)): (&SmolStr, &(ItemKind, At))| {
            let place = place(*at);
            let StmtKind::Declare { name: written, .. } = &place.stmt.kind else { return None };
            Some((name.clone(), Item { place, span: place.span(written.range)?, kind: *kind }))
        };
        let predicate =
            |(name, (_, at)): (&SmolStr, &(PredicateHead, At))| Some((name.clone(), Predicate::of(place(*at))?));
        let assignment = |(key, at): (&AssignKey, &At)| {
            let place = place(*at);
            let StmtKind::Assign { target, value, .. } = &place.stmt.kind else { return None };
            Some((key.clone(), Assignment { place, value: *value, target: *target }))
        };
        Self {
            order: &table.order,
            names: table.items.iter().filter_map(item).collect(),
            predicates: table.predicates.iter().filter_map(predicate).collect(),
            assignments: assigned.iter().filter_map(assignment).collect(),
        }
    }

    /// The predicate that a call in `place` means: the program's own first, but the library calls only itself.
    pub fn predicate(&self, name: &str, from_library: bool) -> Option<Predicate<'a>> {
        let own = if from_library { None } else { self.predicates.get(name) };
        own.or_else(|| library::predicates().get(name)).copied()
    }
}

/// A whole number written as literals, with a sign or arithmetic.
pub fn whole_number(stmt: &Stmt, id: ExprId) -> Option<f64> {
    let value = crate::check::constant::number(stmt, id)?;
    (value.fract() == 0.0).then_some(value)
}

/// Why the size of an array is none.
pub(crate) struct BadSize {
    /// In a sentence.
    pub message: String,
    /// A size to go on with: large enough that the array's elements are not reported, too.
    pub assumed: u32,
}

/// The size of an array, from its declaration.
pub(crate) fn array_size(stmt: &Stmt, id: ExprId) -> Result<u32, BadSize> {
    const ASSUMED: u32 = 10_000;
    let message = match stmt.expr(id).kind {
        ExprKind::Error => return Ok(ASSUMED), // reported by the parser
        ExprKind::Number(n, None) if n.fract() != 0.0 || n < 1.0 => {
            format!("the size of an array must be a whole number of at least 1, not {n}")
        }
        ExprKind::Number(n, None) if n > MAX_ARRAY => {
            format!("an array of {n} elements is too large; at most {MAX_ARRAY}")
        }
        ExprKind::Number(n, None) => return Ok(n as u32),
        _ => "the size of an array must be a whole number literal of at least 1".into(),
    };
    Err(BadSize { message, assumed: ASSUMED })
}
