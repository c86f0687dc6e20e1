//! The tree of one statement. Statements are flat and independent, so each holds its own expressions in one vector;
//! places are relative to the start of the statement's text, so that an edit elsewhere changes nothing here.

use scenelang_base::TextRange;
use smol_str::SmolStr;

/// Index into [`Stmt::exprs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ExprId(pub u32);

/// A name as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    pub text: SmolStr,
    /// Where.
    pub range: TextRange,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// What it says.
    pub kind: StmtKind,
    /// From its first keyword or target to its `;`, exclusive: `@req`, comments and `///` are outside.
    pub range: TextRange,
    /// Sentences of `@req("…")`, with the range of the string.
    pub requirements: Vec<(String, TextRange)>,
    /// Text of the `///` lines before it, joined by line feeds.
    pub doc: String,
    /// The range of the first `@req(…)`, else of the first `///`; for `--core`.
    pub attributes: Option<TextRange>,
    /// The expressions of the statement, children before parents.
    pub exprs: Box<[Expr]>,
}

impl Stmt {
    pub fn expr(&self, id: ExprId) -> &Expr {
        &self.exprs[id.0 as usize]
    }
}

/// What a statement says.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// `object lamp`, `entity lamp`, `object chair[6]`, `region room`, `Number gap`, …
    Declare {
        ty: TypeWord,
        /// Where it stands.
        ty_range: TextRange,
        name: Name,
        /// The size of an array.
        size: Option<ExprId>,
    },
    /// `lamp.pos <- …`, `chair[1].color <- …`, `gap <- …`; also targets that cannot be assigned (`lamp.pos.y`).
    Assign {
        /// The base name.
        name: Name,
        /// `[…]` after it.
        index: Option<ExprId>,
        /// `.pos`, `.y`, …
        path: Vec<Name>,
        /// All of the target.
        target: TextRange,
        /// The right side.
        value: ExprId,
    },
    /// `assert φ`
    Assert { formula: ExprId },
    /// `prefer φ weight n`
    Prefer {
        formula: ExprId,
        /// n
        weight: Option<ExprId>,
    },
    /// `allowCollide(a, b)`, `allowOutside(a)`, `allowFloat(a)`
    Allow {
        rule: Allow,
        word: TextRange,
        /// Its arguments, any number.
        args: Vec<ExprId>,
    },
    /// `predicate near(Object a, …) := φ`
    Predicate { name: Name, params: Vec<Param>, body: ExprId },
    /// `import "path.scene"`
    Import {
        /// The path as written.
        path: String,
        /// The string.
        range: TextRange,
    },
    /// A stray `;`.
    Empty,
    /// It did not parse; its diagnostics are with the parser's.
    Error,
}

/// A parameter of a predicate.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    pub ty: TypeWord,
    /// Where the type stands.
    pub ty_range: TextRange,
    pub name: Name,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TypeWord {
    /// `object` (also `entity`); as a parameter's type `Object`.
    Object,
    /// `region`; as a parameter's type `Region`.
    Region,
    /// `Objects`: a set, parameters only.
    Objects,
    Number,
    Degree,
    Bool,
    Vector3,
    Rotation,
    Color,
    Material,
    /// `String`: parameters only.
    String,
}

/// Which rule an allowance lifts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Allow {
    /// `allowCollide`
    Collide,
    /// `allowOutside`
    Outside,
    /// `allowFloat`
    Float,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub kind: ExprKind,
    /// Where, parentheses around it not counted.
    pub range: TextRange,
}

/// Unit suffixes of literals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnitSuffix {
    /// metres
    M,
    /// centimetres
    Cm,
    /// millimetres
    Mm,
    /// feet (0.3048 m)
    Ft,
    /// inches (0.0254 m)
    In,
    /// degrees
    Deg,
    /// radians
    Rad,
}

impl UnitSuffix {
    /// As written behind a number.
    pub fn text(self) -> &'static str {
        match self {
            Self::M => "m",
            Self::Cm => "cm",
            Self::Mm => "mm",
            Self::Ft => "ft",
            Self::In => "in",
            Self::Deg => "deg",
            Self::Rad => "rad",
        }
    }
}

/// Operators of two operands, comparisons apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `and`
    And,
    /// `or`
    Or,
    /// `implies`, right-associative
    Implies,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantifier {
    /// `forall x in S: φ`
    Forall,
    /// `exists x in S: φ`
    Exists,
    /// `count(x in S: φ)`
    Count,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `2`, `30cm`: the value as written, and its unit.
    Number(f64, Option<UnitSuffix>),
    /// `"red"`, escapes resolved.
    Text(String),
    /// `true`, `false`
    Bool(bool),
    /// A name: object, array, region, variable, parameter, range variable.
    Name(SmolStr),
    /// `objects`: all of them (only where no such name is declared).
    Objects,
    /// `a.pos`, `a.pos.y`
    Member(ExprId, Name),
    /// `.category` in a filter
    Own(Name),
    /// `chair[1]`
    Index(ExprId, ExprId),
    /// `-x`
    Neg(ExprId),
    /// `not φ`
    Not(ExprId),
    /// `x + y`, `φ and ψ`, …; the range is that of the operator
    Binary(BinaryOp, TextRange, ExprId, ExprId),
    /// `a < b`; more than one step is an error that the parser has reported (comparisons cannot be chained)
    Compare(ExprId, Vec<(crate::program::Comparison, TextRange, ExprId)>),
    /// `vec3(…)`, `near(a, b, 1)`, `rand(…)`: functions, predicates and constructors alike
    Call(Name, Vec<ExprId>),
    /// `forall`, `exists`, `count`
    Quantified(Quantifier, Name, ExprId, ExprId),
    /// `S where φ`
    Where(ExprId, ExprId),
    /// `0..5`: half open, a quantifier's domain
    Range(ExprId, ExprId),
    /// A part that did not parse and is reported already.
    Error,
}

impl ExprKind {
    /// Calls `f` for each direct part of an expression.
    pub fn for_each_child(&self, mut f: impl FnMut(ExprId)) {
        match self {
            Self::Number(..) | Self::Text(_) | Self::Bool(_) | Self::Name(_) => {}
            Self::Objects | Self::Own(_) | Self::Error => {}
            Self::Member(a, _) | Self::Neg(a) | Self::Not(a) => f(*a),
            Self::Index(a, b) | Self::Binary(_, _, a, b) => {
                f(*a);
                f(*b);
            }
            Self::Quantified(_, _, a, b) | Self::Where(a, b) | Self::Range(a, b) => {
                f(*a);
                f(*b);
            }
            Self::Compare(first, steps) => {
                f(*first);
                steps.iter().for_each(|(_, _, right)| f(*right));
            }
            Self::Call(_, args) => args.iter().for_each(|a| f(*a)),
        }
    }
}
