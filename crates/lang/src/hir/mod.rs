//! What the names and expressions of a statement mean, before anything is expanded: the type of each expression, and
//! what each name stands for. For hover, go to definition, and whoever wants to look.
//!
//! The checker writes this down while it checks ([`statement`] runs it), so there is one meaning and not two. Like the
//! checker's findings it depends on the statement's text and on what [`Names`] says of the names in it, not on where
//! anything stands.

use crate::ast::{ExprId, Stmt};
use crate::check;
use crate::items::{ItemKind, Located, Names};
use crate::natives::{Property, Signature};
use crate::program::ObjectSide;
use crate::types::Ty;
use rustc_hash::FxHashMap;
use scenelang_base::{Span, TextRange};
use smol_str::SmolStr;

/// What a statement means.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Hir {
    types: Vec<Option<Ty>>,
    resolutions: Vec<Option<Resolution>>,
    /// Parameters and variables of quantifiers, in the order in which they are bound.
    pub locals: Vec<Local>,
    pub target: Option<AssignTarget>,
}

/// What a name or an expression stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// An object, an array, a region or a variable of the program.
    Item(SmolStr, ItemKind),
    /// An element of an array.
    Element {
        array: SmolStr,
        /// Which, if literals say it.
        index: Option<u32>,
    },
    AllObjects,
    /// `rooms`: all regions that are rooms.
    AllRooms,
    /// A parameter or the variable of a quantifier: an index into [`Hir::locals`].
    Local(usize),
    /// A predicate of the program or of the library.
    Predicate {
        name: SmolStr,
        /// Whether it is of the library.
        library: bool,
    },
    /// A built-in function or predicate: the overload that the arguments choose.
    BuiltIn(&'static Signature),
    /// A property of an object or a region.
    Property {
        /// Of an object or of a region.
        of: Ty,
        property: &'static Property,
    },
    /// `x`, `y` or `z` of a vector or a rotation.
    Component,
    /// A side word.
    Side(ObjectSide),
}

/// A name that a statement binds for a part of itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Local {
    pub name: SmolStr,
    /// Where it is bound, relative to the start of the statement's text.
    pub range: TextRange,
    /// Its type.
    pub ty: Ty,
    /// How it is bound.
    pub kind: LocalKind,
}

/// How a local name is bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LocalKind {
    /// As a parameter of a predicate.
    Parameter,
    /// By a quantifier.
    Variable,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AssignTarget {
    /// The object, element, region or variable.
    pub owner: Resolution,
    /// The property; `None`: the whole variable, or something that cannot be assigned.
    pub property: Option<&'static Property>,
    /// The type of what is assigned.
    pub ty: Ty,
}

impl Hir {
    pub(crate) fn of_size(exprs: usize) -> Self {
        Self { types: vec![None; exprs], resolutions: vec![None; exprs], ..Self::default() }
    }
    pub(crate) fn set_type(&mut self, id: ExprId, ty: Ty) {
        self.types[id.0 as usize] = Some(ty);
    }
    pub(crate) fn resolve(&mut self, id: ExprId, resolution: Resolution) {
        self.resolutions[id.0 as usize] = Some(resolution);
    }

    /// The type of an expression of the statement; [`Ty::Error`] if there is something wrong with it, `None` if nobody
    /// asked (the statement is broken, or the name of the element's array).
    pub fn type_of(&self, id: ExprId) -> Option<Ty> {
        self.types.get(id.0 as usize).copied().flatten()
    }
    /// What an expression of the statement stands for: of a name, what is declared; of `a.b` the property `b`; of a call
    /// what is called; `None` for operators and literals, and for names that nothing has.
    pub fn resolution(&self, id: ExprId) -> Option<&Resolution> {
        self.resolutions.get(id.0 as usize)?.as_ref()
    }
}

/// What the statements of a file mean, and where the names that they speak of are declared.
#[derive(Debug)]
pub struct Meanings<'a> {
    /// The statements, in order.
    pub statements: Vec<(Located<'a>, &'a Hir)>,
    /// Where objects, arrays, regions and variables are declared, in any file of the program.
    pub declared: FxHashMap<SmolStr, Span>,
    /// Where the predicates of the program are defined.
    pub defined: FxHashMap<SmolStr, Span>,
}

pub fn statement(names: &dyn Names, stmt: &Stmt) -> Hir {
    check::meaning(names, stmt)
}

#[cfg(test)]
mod tests;
