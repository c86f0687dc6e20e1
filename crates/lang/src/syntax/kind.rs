//! Kinds of nodes and leaves of the syntax tree, and their numbers in it.

use crate::ast::{ExprKind, StmtKind};
use crate::token::{Kind, TABLE};
use std::cmp::Ordering;
use std::fmt;

/// What an element of the tree is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SyntaxKind {
    /// A leaf: a token, with contextual words told apart.
    Token(Kind),
    /// A node: it has children.
    Node(NodeKind),
}

macro_rules! node_kinds {
    ($($(#[doc = $doc:literal])+ $name:ident)*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum NodeKind {
            $($(#[doc = $doc])+ $name,)*
        }
        const NODES: &[NodeKind] = &[$(NodeKind::$name),*];
    };
}

node_kinds! {
    /// A file: statements, and what stands between them.
    File
    /// The text of one statement: its documentation, its `@req`, what it says, its `;`. Where a `;` is missing, what
    /// several statements say.
    Statement
    /// `///` lines before a statement.
    Documentation
    /// `@req("…")`
    Requirement

    /// `object lamp`, `object chair[6]`, `region room`, `Number gap`
    Declaration
    /// `lamp.pos <- …`, `gap <- …`
    Assignment
    /// `assert φ`
    Assertion
    /// `prefer φ weight n`
    Preference
    /// `allowCollide(a, b)`, `allowOutside(a)`, `allowFloat(a)`
    Allowance
    /// `predicate near(Object a, …) := φ`
    PredicateDefinition
    /// `import "path.scene"`
    Import
    /// A stray `;`, or several in a row.
    Empty
    /// Tokens that are no statement, with what could be recognised in them; or a literal that has no value.
    Error

    /// A name that is being declared: of a thing, a predicate, a parameter, the variable of a quantifier.
    Name
    /// A name that stands for something declared elsewhere.
    NameRef
    /// The name of a property, after a dot.
    Property
    /// What an assignment assigns: `lamp.pos`, `chair[1].color`, `gap`.
    Path
    /// `(Object a, Number d)` of a predicate.
    Parameters
    /// `Object a`
    Parameter
    /// `(a, b)` of a call or an allowance.
    Arguments
    /// `[…]`
    Brackets
    /// `(…)` around an expression, or after `count`.
    Parentheses

    /// `2`, `30cm`
    Number
    /// `"red"`
    Text
    /// `true`, `false`
    Bool
    /// `objects`
    Objects
    /// `a.pos`
    Member
    /// `.category` in a filter.
    Own
    /// `chair[1]`
    Index
    /// `-x`
    Negative
    /// `not φ`
    Not
    /// `x + y`, `φ and ψ`
    Binary
    /// `a < b`
    Comparison
    /// `vec3(…)`, `near(a, b)`
    Call
    /// `forall`, `exists`, `count`
    Quantifier
    /// `S where φ`
    Filter
    /// `0..5`
    Range
}

/// The language, for the tree's types.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SceneLanguage {}

impl rowan::Language for SceneLanguage {
    type Kind = SyntaxKind;

    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        let at = usize::from(raw.0);
        match TABLE.get(at) {
            Some(row) => SyntaxKind::Token(row.kind),
            // No tree holds a number that is not from `kind_to_raw`.
            None => SyntaxKind::Node(NODES.get(at - TABLE.len()).copied().unwrap_or(NodeKind::Error)),
        }
    }

    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        rowan::SyntaxKind(match kind {
            SyntaxKind::Token(kind) => kind as u16,
            SyntaxKind::Node(kind) => TABLE.len() as u16 + kind as u16,
        })
    }
}

impl From<SyntaxKind> for rowan::SyntaxKind {
    fn from(kind: SyntaxKind) -> Self {
        <SceneLanguage as rowan::Language>::kind_to_raw(kind)
    }
}

/// By number, for the tree's types ask for an order.
impl Ord for SyntaxKind {
    fn cmp(&self, other: &Self) -> Ordering {
        let number = |kind: Self| rowan::SyntaxKind::from(kind).0;
        number(*self).cmp(&number(*other))
    }
}

impl PartialOrd for SyntaxKind {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl SyntaxKind {
    /// The token's kind, if it is a leaf.
    pub fn token(self) -> Option<Kind> {
        match self {
            Self::Token(kind) => Some(kind),
            Self::Node(_) => None,
        }
    }
    /// The node's kind, if it is none.
    pub fn node(self) -> Option<NodeKind> {
        match self {
            Self::Token(_) => None,
            Self::Node(kind) => Some(kind),
        }
    }
}

impl NodeKind {
    /// Whether it is what a statement says.
    pub fn is_statement(self) -> bool {
        use NodeKind::*;
        matches!(
            self,
            Declaration
                | Assignment
                | Assertion
                | Preference
                | Allowance
                | PredicateDefinition
                | Import
                | Empty
                | Error
        )
    }
}

impl From<&StmtKind> for NodeKind {
    fn from(kind: &StmtKind) -> Self {
        match kind {
            StmtKind::Declare { .. } => Self::Declaration,
            StmtKind::Assign { .. } => Self::Assignment,
            StmtKind::Assert { .. } => Self::Assertion,
            StmtKind::Prefer { .. } => Self::Preference,
            StmtKind::Allow { .. } => Self::Allowance,
            StmtKind::Predicate { .. } => Self::PredicateDefinition,
            StmtKind::Import { .. } => Self::Import,
            StmtKind::Empty => Self::Empty,
            StmtKind::Error => Self::Error,
        }
    }
}

impl From<&ExprKind> for NodeKind {
    fn from(kind: &ExprKind) -> Self {
        match kind {
            ExprKind::Number(..) => Self::Number,
            ExprKind::Text(_) => Self::Text,
            ExprKind::Bool(_) => Self::Bool,
            ExprKind::Name(_) => Self::NameRef,
            ExprKind::Objects => Self::Objects,
            ExprKind::Member(..) => Self::Member,
            ExprKind::Own(_) => Self::Own,
            ExprKind::Index(..) => Self::Index,
            ExprKind::Neg(_) => Self::Negative,
            ExprKind::Not(_) => Self::Not,
            ExprKind::Binary(..) => Self::Binary,
            ExprKind::Compare(..) => Self::Comparison,
            ExprKind::Call(..) => Self::Call,
            ExprKind::Quantified(..) => Self::Quantifier,
            ExprKind::Where(..) => Self::Filter,
            ExprKind::Range(..) => Self::Range,
            ExprKind::Error => Self::Error,
        }
    }
}

impl fmt::Display for NodeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl fmt::Display for SyntaxKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Token(kind) => write!(f, "{kind:?}"),
            Self::Node(kind) => write!(f, "{kind}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rowan::Language;

    #[test]
    fn numbers_lead_back_to_their_kinds() {
        let all = TABLE.iter().map(|row| SyntaxKind::Token(row.kind)).chain(NODES.iter().map(|n| SyntaxKind::Node(*n)));
        for (number, kind) in all.enumerate() {
            assert_eq!(usize::from(SceneLanguage::kind_to_raw(kind).0), number, "{kind}");
            assert_eq!(SceneLanguage::kind_from_raw(SceneLanguage::kind_to_raw(kind)), kind);
        }
    }
}
