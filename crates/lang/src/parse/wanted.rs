//! What the grammar could have gone on with where it failed: a set of expectations, in the user's words.
//!
//! This is the parser's error type. It is one word wide, so that bookkeeping costs nothing while all goes well;
//! `diagnose` makes sentences of it.

use crate::token::Kind;
use chumsky::DefaultExpected;
use chumsky::error::{Error, LabelError};
use chumsky::span::SimpleSpan;
use chumsky::util::MaybeRef;

/// A set of expectations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted(u32);

macro_rules! expectations {
    ($($name:ident $bit:literal $words:literal)*) => {
        impl Wanted {
            $(#[doc = $words] pub const $name: Self = Self(1 << $bit);)*
            /// All, in the order in which a sentence lists them.
            const WORDS: &'static [(Self, &'static str)] = &[$((Self::$name, $words)),*];
        }
    };
}

expectations! {
    STATEMENT 0 "a statement"
    NAME 1 "a name"
    TYPE 2 "a type"
    VALUE 3 "a value"
    CONDITION 4 "a condition"
    PROPERTY 5 "the name of a property"
    STRING 6 "a string in double quotes"
    OPERATOR 7 "an operator"
    CONNECTIVE 8 "`and` or `or`"
    OPEN_PAREN 9 "`(`"
    OPEN_BRACKET 10 "`[`"
    COMMA 11 "`,`"
    CLOSE_PAREN 12 "`)`"
    CLOSE_BRACKET 13 "`]`"
    IN 14 "`in`"
    COLON 15 "`:`"
    ARROW 16 "`<-`"
    DEFINE 17 "`:=`"
    DOT 18 "`.`"
    WEIGHT 19 "`weight`"
    END 20 "`;`"
}

impl Wanted {
    /// Whether all of `other` is expected.
    pub fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
    /// Both.
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    /// Without the expectations in `other`.
    pub fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }
    /// "a name", "`,` or `)`", "a, b or c"; empty if nothing is expected.
    pub fn words(self) -> String {
        let words: Vec<&str> = Self::WORDS.iter().filter(|(w, _)| self.has(*w)).map(|(_, words)| *words).collect();
        match words.as_slice() {
            [] => String::new(),
            [only] => (*only).to_owned(),
            [first @ .., last] => format!("{} or {last}", first.join(", ")),
        }
    }

    fn of_kind(kind: Kind) -> Self {
        match kind {
            Kind::Ident => Self::NAME,
            Kind::Str => Self::STRING,
            Kind::LParen => Self::OPEN_PAREN,
            Kind::LBracket => Self::OPEN_BRACKET,
            Kind::Comma => Self::COMMA,
            Kind::RParen => Self::CLOSE_PAREN,
            Kind::RBracket => Self::CLOSE_BRACKET,
            Kind::In => Self::IN,
            Kind::Colon => Self::COLON,
            Kind::Arrow => Self::ARROW,
            Kind::Define => Self::DEFINE,
            Kind::Dot => Self::DOT,
            Kind::Weight => Self::WEIGHT,
            _ => Self::default(),
        }
    }
}

/// Where the grammar could not go on, as the number of the token, and what it wanted there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Index of the token; the number of tokens if they ended too early.
    pub at: usize,
    /// What would have been right.
    pub wanted: Wanted,
}

type Input<'t> = &'t [Kind];

impl<'t> Error<'t, Input<'t>> for Failure {
    fn merge(self, other: Self) -> Self {
        Self { at: self.at, wanted: self.wanted.and(other.wanted) }
    }
}

impl<'t> LabelError<'t, Input<'t>, DefaultExpected<'t, Kind>> for Failure {
    fn expected_found<E: IntoIterator<Item = DefaultExpected<'t, Kind>>>(
        expected: E,
        _: Option<MaybeRef<'t, Kind>>,
        span: SimpleSpan,
    ) -> Self {
        let wanted = expected.into_iter().fold(Wanted::default(), |wanted, e| {
            wanted.and(match e {
                DefaultExpected::Token(kind) => Wanted::of_kind(*kind),
                DefaultExpected::EndOfInput => Wanted::END,
                _ => Wanted::default(),
            })
        });
        Self { at: span.start, wanted }
    }
}

impl<'t> LabelError<'t, Input<'t>, Wanted> for Failure {
    fn expected_found<E: IntoIterator<Item = Wanted>>(
        expected: E,
        _: Option<MaybeRef<'t, Kind>>,
        span: SimpleSpan,
    ) -> Self {
        Self { at: span.start, wanted: expected.into_iter().fold(Wanted::default(), Wanted::and) }
    }
    fn label_with(&mut self, label: Wanted) {
        self.wanted = label;
    }
}
