//! Formulas as trees, and how they are written.

use std::fmt::{self, Display, Formatter};

/// Arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sign {
    Plus,
    Minus,
    Times,
    Over,
}

/// Comparisons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

/// What a quantifier says of its domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    Forall,
    Exists,
    Count,
}

/// What a quantifier goes through.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// `objects`.
    All,
    /// The array, by its name.
    Array(String),
    /// Those of which a condition on `.color` and `.category` holds.
    Where(Box<Domain>, Box<Term>),
    /// Whole numbers, half open.
    Range(usize, usize),
}

/// A value or a truth.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// Without a sign.
    Number(f64),
    Truth(bool),
    Text(&'static str),
    /// An object, region, variable, definition, or what a quantifier or a parameter stands for.
    Name(String),
    /// An element of the array.
    Element(String, Box<Term>),
    /// A property of what is named; of nothing in a filter.
    Property(Option<Box<Term>>, &'static str),
    Component(Box<Term>, usize),
    Call(String, Vec<Term>),
    Set(Domain),
    Rand(f64, f64),
    Neg(Box<Term>),
    Arith(Sign, Box<Term>, Box<Term>),
    Compare(Order, Box<Term>, Box<Term>),
    Not(Box<Term>),
    And(Box<Term>, Box<Term>),
    Or(Box<Term>, Box<Term>),
    Implies(Box<Term>, Box<Term>),
    Quantified(Quantity, String, Domain, Box<Term>),

    // What expansion makes; never written.
    Object(usize),
    Region(usize),
    Whole(usize),
    Draw(String),
    Objects(Vec<usize>),
    Each(Quantity, Vec<Term>),
    /// The body of a user's predicate.
    Inner(Box<Term>),
}

impl Term {
    pub fn name(name: &str) -> Self {
        Self::Name(name.to_owned())
    }
    /// A number, with its sign.
    pub fn number(x: f64) -> Self {
        if x < 0.0 { Self::Neg(Box::new(Self::Number(-x))) } else { Self::Number(x) }
    }
    pub fn of(self, property: &'static str) -> Self {
        Self::Property(Some(Box::new(self)), property)
    }
    pub fn component(self, axis: usize) -> Self {
        Self::Component(Box::new(self), axis)
    }
    pub fn call(name: &str, arguments: impl IntoIterator<Item = Self>) -> Self {
        Self::Call(name.to_owned(), arguments.into_iter().collect())
    }
    pub fn arith(sign: Sign, a: Self, b: Self) -> Self {
        Self::Arith(sign, Box::new(a), Box::new(b))
    }
    pub fn compare(order: Order, a: Self, b: Self) -> Self {
        Self::Compare(order, Box::new(a), Box::new(b))
    }
    pub fn not(a: Self) -> Self {
        Self::Not(Box::new(a))
    }
    pub fn and(a: Self, b: Self) -> Self {
        Self::And(Box::new(a), Box::new(b))
    }
    pub fn or(a: Self, b: Self) -> Self {
        Self::Or(Box::new(a), Box::new(b))
    }
    pub fn implies(a: Self, b: Self) -> Self {
        Self::Implies(Box::new(a), Box::new(b))
    }
    pub fn quantified(q: Quantity, variable: &str, domain: Domain, body: Self) -> Self {
        Self::Quantified(q, variable.to_owned(), domain, Box::new(body))
    }

    /// Whether it is made of literals and functions alone.
    pub fn is_constant(&self) -> bool {
        match self {
            Self::Number(_) | Self::Truth(_) | Self::Text(_) => true,
            Self::Neg(a) | Self::Component(a, _) | Self::Not(a) => a.is_constant(),
            Self::Arith(_, a, b) => a.is_constant() && b.is_constant(),
            Self::Call(_, arguments) => arguments.iter().all(Self::is_constant),
            _ => false,
        }
    }

    /// How tightly its outermost sign binds.
    fn binds(&self) -> u8 {
        match self {
            Self::Quantified(Quantity::Forall | Quantity::Exists, ..) => 0,
            Self::Implies(..) => 1,
            Self::Or(..) => 2,
            Self::And(..) => 3,
            Self::Not(_) => 4,
            Self::Compare(..) => 5,
            Self::Arith(Sign::Plus | Sign::Minus, ..) => 6,
            Self::Arith(..) => 7,
            Self::Neg(_) => 8,
            _ => 9,
        }
    }
    /// Written with brackets only where its surroundings bind tighter.
    fn write(&self, f: &mut Formatter<'_>, at_least: u8) -> fmt::Result {
        if self.binds() < at_least { write!(f, "({self})") } else { write!(f, "{self}") }
    }
    fn infix(f: &mut Formatter<'_>, a: (&Self, u8), sign: &str, b: (&Self, u8)) -> fmt::Result {
        a.0.write(f, a.1)?;
        write!(f, " {sign} ")?;
        b.0.write(f, b.1)
    }
}

impl Display for Domain {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::All => f.write_str("objects"),
            Self::Array(name) => f.write_str(name),
            Self::Where(of, condition) => write!(f, "{of} where {condition}"),
            Self::Range(from, to) => write!(f, "{from}..{to}"),
        }
    }
}

impl Display for Term {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(x) => write!(f, "{x}"),
            Self::Truth(p) => write!(f, "{p}"),
            Self::Text(text) => write!(f, "\"{text}\""),
            Self::Name(name) => f.write_str(name),
            Self::Element(array, index) => write!(f, "{array}[{index}]"),
            Self::Property(None, property) => write!(f, ".{property}"),
            Self::Property(Some(of), property) => {
                of.write(f, 9)?;
                write!(f, ".{property}")
            }
            Self::Component(of, axis) => {
                of.write(f, 9)?;
                write!(f, ".{}", ["x", "y", "z"][*axis])
            }
            Self::Call(name, arguments) => {
                write!(f, "{name}(")?;
                for (i, argument) in arguments.iter().enumerate() {
                    write!(f, "{}{argument}", if i > 0 { ", " } else { "" })?;
                }
                f.write_str(")")
            }
            Self::Set(domain) => write!(f, "{domain}"),
            Self::Rand(lo, hi) => write!(f, "rand({lo}, {hi})"),
            Self::Neg(a) => {
                f.write_str("-")?;
                a.write(f, 8)
            }
            Self::Arith(sign, a, b) => match sign {
                Sign::Plus => Self::infix(f, (a, 6), "+", (b, 7)),
                Sign::Minus => Self::infix(f, (a, 6), "-", (b, 7)),
                Sign::Times => Self::infix(f, (a, 7), "*", (b, 8)),
                Sign::Over => Self::infix(f, (a, 7), "/", (b, 8)),
            },
            Self::Compare(order, a, b) => {
                let sign = match order {
                    Order::Eq => "=",
                    Order::Ne => "!=",
                    Order::Lt => "<",
                    Order::Le => "<=",
                    Order::Gt => ">",
                    Order::Ge => ">=",
                };
                Self::infix(f, (a, 6), sign, (b, 6))
            }
            Self::Not(a) => {
                f.write_str("not ")?;
                a.write(f, 4)
            }
            Self::And(a, b) => Self::infix(f, (a, 3), "and", (b, 4)),
            Self::Or(a, b) => Self::infix(f, (a, 2), "or", (b, 3)),
            // To the right.
            Self::Implies(a, b) => Self::infix(f, (a, 2), "implies", (b, 1)),
            Self::Quantified(Quantity::Count, variable, domain, body) => {
                write!(f, "count({variable} in {domain}: {body})")
            }
            Self::Quantified(quantity, variable, domain, body) => {
                let word = if *quantity == Quantity::Forall { "forall" } else { "exists" };
                write!(f, "{word} {variable} in {domain}: {body}")
            }
            Self::Object(_)
            | Self::Region(_)
            | Self::Whole(_)
            | Self::Draw(_)
            | Self::Objects(_)
            | Self::Each(..)
            | Self::Inner(_) => f.write_str("<expanded>"),
        }
    }
}
