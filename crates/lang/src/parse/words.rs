//! What a word or an arrow means where it stands.
//!
//! Only core words are reserved. `forall`, `weight`, `objects`, … are keywords only where an identifier cannot stand;
//! anywhere else they are names like any other. Likewise `<-` is an arrow only after an assignment's target, and `<`
//! followed by `-` inside an expression. Both are decided here, once, by looking a token or two ahead, so that the
//! grammar never has to try one reading and take it back.

use super::lexical::{intended_operator, is_implication};
use crate::chunk::has_line_break;
use crate::token::{Kind, Token};
use scenelang_base::TextRange;

/// The tokens of one statement as the grammar reads them.
#[derive(Debug, Default)]
pub struct Words {
    /// What each token is.
    pub kinds: Vec<Kind>,
    /// Where each stands; as many as `kinds`.
    pub ranges: Vec<TextRange>,
    /// The first token after the attributes.
    pub head: usize,
    /// Arrows that were read as `<` and `-`.
    pub split_arrows: Vec<TextRange>,
}

/// One past the attributes at the start of some tokens: only whole ones (`@req("…")`) count.
pub fn attributes_end(tokens: &[Token]) -> usize {
    let mut at = 0;
    while let [req, open, string, close, ..] = &tokens[at..]
        && (req.kind, open.kind, close.kind) == (Kind::Req, Kind::LParen, Kind::RParen)
        && matches!(string.kind, Kind::Str | Kind::OddQuotes)
    {
        at += 4;
    }
    at
}

/// Whether a value can end with this token, so that no name can follow it.
pub fn ends_value(kind: Kind) -> bool {
    use Kind::*;
    matches!(kind, Ident | Number | Str | True | False | RParen | RBracket | Objects | OpenStr | OddQuotes | BadNumber)
}

/// Whether the text is a word: a name or a reserved word, not a sign.
pub fn is_word(text: &str) -> bool {
    text.starts_with(|c| c == '_' || unicode_ident::is_xid_start(c))
}

/// Whether a statement of the core can begin with this token, whatever stands before it.
pub fn starts_statement(kind: Kind) -> bool {
    declares(kind) || matches!(kind, Kind::Assert | Kind::AllowCollide | Kind::AllowOutside)
}

/// Whether a name is declared after this word.
pub fn declares(kind: Kind) -> bool {
    is_type_word(kind) || matches!(kind, Kind::Object | Kind::Entity | Kind::Region)
}

/// The reserved names of types.
pub fn is_type_word(kind: Kind) -> bool {
    use Kind::*;
    matches!(kind, NumberType | Degree | Bool | Vector3 | Rotation | Color | Material)
}

/// Whether the word before these tokens can only be a variable that is assigned: `.`, `[`, `<-` follow.
pub fn is_assigned(after: Option<Kind>) -> bool {
    use Kind::*;
    matches!(after, Some(Dot | LBracket | Arrow | ArrowSign | Define | Eq))
}

/// Reads the tokens of one statement (without trivia and without its `;`). `first`: what its first word is to be taken
/// for, where that is misspelt.
pub fn read(text: &str, tokens: &[Token], first: Option<Kind>) -> Words {
    let head = attributes_end(tokens);
    let mut reader = Reader { text, tokens, depth: 0, variable: usize::MAX, arrow: Arrow::First, in_parameters: false };
    let mut words = Words { head, ..Words::default() };
    words.kinds.reserve(tokens.len());
    words.ranges.reserve(tokens.len());
    for (at, token) in tokens.iter().enumerate() {
        let kind = reader.read(at, head, words.kinds.last().copied(), first);
        if kind == Kind::Arrow && reader.splits_arrow() {
            let TextRange { start, end } = token.range;
            words.split_arrows.push(token.range);
            words.kinds.extend([Kind::Lt, Kind::Minus]);
            words.ranges.extend([TextRange { start, end: start + 1 }, TextRange { start: start + 1, end }]);
        } else {
            words.kinds.push(kind);
            words.ranges.push(token.range);
        }
    }
    words
}

/// Which `<-` is an arrow.
#[derive(PartialEq)]
enum Arrow {
    /// The next one outside brackets.
    First,
    /// None any more.
    None,
}

struct Reader<'t> {
    text: &'t str,
    tokens: &'t [Token],
    depth: u32,
    /// The token that is a quantifier's variable.
    variable: usize,
    arrow: Arrow,
    /// Within the parentheses after `predicate name`.
    in_parameters: bool,
}

impl Reader<'_> {
    fn read(&mut self, at: usize, head: usize, before: Option<Kind>, first: Option<Kind>) -> Kind {
        let kind = match self.tokens[at].kind {
            own if at == head && first.is_some() => first.unwrap_or(own),
            Kind::Ident if before == Some(Kind::Dot) => Kind::Ident,
            Kind::Ident if at == head => self.first_word(at),
            Kind::Ident => self.word(at, before),
            Kind::OddQuotes | Kind::OpenStr => Kind::Str,
            Kind::BadNumber => Kind::Number,
            Kind::WrongOperator if is_implication(self.text, self.tokens, at) => Kind::Implies,
            Kind::WrongOperator => intended_operator(self.slice(at)).unwrap_or(Kind::WrongOperator),
            _ if before == Some(Kind::Dot) && self.is_property(at) => Kind::Ident,
            kind => kind,
        };
        match kind {
            Kind::LParen | Kind::LBracket => self.depth += 1,
            Kind::RParen | Kind::RBracket => {
                self.depth = self.depth.saturating_sub(1);
                self.in_parameters &= self.depth > 0;
            }
            Kind::Define => self.arrow = Arrow::None,
            Kind::ArrowSign if self.depth == 0 => self.arrow = Arrow::None,
            _ => {}
        }
        if at == head {
            self.in_parameters = kind == Kind::Predicate;
            let expression = matches!(kind, Kind::Assert | Kind::Prefer | Kind::AllowCollide | Kind::AllowOutside);
            if expression || matches!(kind, Kind::AllowFloat | Kind::Import) {
                self.arrow = Arrow::None;
            }
        }
        kind
    }

    /// Whether the `<-` just read is no arrow.
    fn splits_arrow(&mut self) -> bool {
        let kept = self.arrow == Arrow::First && self.depth == 0;
        if kept {
            self.arrow = Arrow::None;
        }
        !kept
    }

    /// The first word of a statement.
    fn first_word(&self, at: usize) -> Kind {
        let after = self.tokens.get(at + 1).map(|t| t.kind);
        match self.slice(at) {
            "prefer" if !is_assigned(after) => Kind::Prefer,
            "allowFloat" if !is_assigned(after) => Kind::AllowFloat,
            "import" if !is_assigned(after) => Kind::Import,
            "predicate" if !is_assigned(after) => Kind::Predicate,
            _ => Kind::Ident,
        }
    }

    /// Any other word that is not reserved.
    fn word(&mut self, at: usize, before: Option<Kind>) -> Kind {
        if at == self.variable || before.is_some_and(wants_new_name) {
            return Kind::Ident;
        }
        let value_before = before.is_some_and(ends_value);
        let after = self.tokens.get(at + 1).map(|t| t.kind);
        match self.slice(at) {
            "forall" if !value_before && self.binds(at + 1, false) => self.quantifier(Kind::Forall, at + 1),
            "exists" if !value_before && self.binds(at + 1, false) => self.quantifier(Kind::Exists, at + 1),
            "count" if !value_before && after == Some(Kind::LParen) && self.binds(at + 2, true) => {
                self.quantifier(Kind::Count, at + 2)
            }
            "in" if self.variable.checked_add(1) == Some(at) => Kind::In,
            "where" if value_before => Kind::Where,
            "implies" if value_before => Kind::Implies,
            "weight" if value_before => Kind::Weight,
            "Object" | "Region" | "Objects" | "String"
                if self.in_parameters && matches!(before, Some(Kind::LParen | Kind::Comma)) =>
            {
                Kind::ParamType
            }
            "objects" if after != Some(Kind::LParen) => Kind::Objects,
            _ => Kind::Ident,
        }
    }

    fn quantifier(&mut self, kind: Kind, variable: usize) -> Kind {
        self.variable = variable;
        kind
    }

    /// Whether the word at `at` reads as the variable of a quantifier. In parentheses after `count`, where a call
    /// reads just as well, another word must follow.
    fn binds(&self, at: usize, call: bool) -> bool {
        let word = |at: usize| self.tokens.get(at).is_some_and(|t| t.kind == Kind::Ident);
        let infix = |at: usize| matches!(self.slice(at), "implies" | "where" | "weight");
        match self.tokens.get(at + 1) {
            Some(_) if self.slice(at + 1) == "in" => true,
            Some(next) if call => word(at) && next.kind == Kind::Ident && !infix(at + 1),
            _ => word(at) && !infix(at),
        }
    }

    /// Whether a reserved word or keyword after `.` is a property's name. It is not if it begins the next line as a
    /// statement would: then the property has not been written yet.
    fn is_property(&self, at: usize) -> bool {
        let gap = &self.text[self.tokens[at - 1].range.end as usize..self.tokens[at].range.start as usize];
        is_word(self.slice(at)) && !(starts_statement(self.tokens[at].kind) && has_line_break(gap))
    }

    fn slice(&self, at: usize) -> &str {
        self.tokens.get(at).map_or("", |t| &self.text[t.range.bytes()])
    }
}

/// Reserved words that are called like functions.
pub fn is_constructor(kind: Kind) -> bool {
    matches!(kind, Kind::Inside | Kind::Rand | Kind::Vec3 | Kind::Rot | Kind::DotWord)
}

/// Whether what follows is a name that is being declared.
fn wants_new_name(kind: Kind) -> bool {
    declares(kind) || matches!(kind, Kind::Predicate | Kind::ParamType)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::lex;

    /// The words of a statement that are read as keywords, and `<-` where it is an arrow.
    fn keywords(text: &str) -> String {
        let tokens: Vec<_> = lex(text).into_iter().filter(|t| !t.kind.is_trivia()).collect();
        let words = read(text, &tokens, None);
        let shown = words.kinds.iter().zip(&words.ranges).filter(|(kind, range)| {
            **kind == Kind::Arrow || !matches!(kind, Kind::Ident) && is_word(&text[range.bytes()])
        });
        shown.map(|(_, range)| &text[range.bytes()]).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn contextual_words_are_keywords_only_where_no_name_can_stand() {
        let cases = [
            ("assert forall c in chair: near(c, d, 1)", "assert forall in"),
            ("assert forall.pos.x > 1", "assert"),
            ("assert forall implies b", "assert implies"),
            ("assert count(c in chair: c) >= 2", "assert count in"),
            ("assert count(a, b)", "assert"),
            ("assert count(weight implies b)", "assert implies"),
            ("assert implies implies implies", "assert implies"),
            ("prefer weight > 1 weight weight", "prefer weight"),
            ("prefer <- 3", "<-"),
            ("prefer.pos <- vec3(1, 2, 3)", "<- vec3"),
            ("object objects", "object"),
            ("assert exists objects in objects where .where = 1: in.pos", "assert exists in objects where"),
            ("assert objects(a)", "assert"),
            ("objects[1].pos <- a", "<-"),
            ("predicate near(Object String, String Object) := Object", "predicate Object String"),
            ("predicate count(Object a) := a", "predicate Object"),
            ("predicate <- 1", "<-"),
            ("import \"a\"", "import"),
            ("allowFloat(weight)", "allowFloat"),
            ("assert a.rot.object.and > 1", "assert"),
            ("assert a.\nobject b", "assert object"),
            ("@req(\"prefer\") prefer a > b", "@req prefer"),
        ];
        for (text, expected) in cases {
            assert_eq!(keywords(text).replace("@req ", ""), expected.replace("@req ", ""), "{text}");
        }
    }

    #[test]
    fn an_arrow_stands_only_after_a_target() {
        let cases = [
            ("a <-1", 0),
            ("a[b <-1] <- 2", 1),
            ("a <- b <-1", 1),
            ("a ← b <-1", 1),
            ("assert a <-1", 1),
            ("prefer <-1", 0),
            ("predicate p(Object a) := a.x <-1", 1),
        ];
        for (text, expected) in cases {
            let tokens: Vec<_> = lex(text).into_iter().filter(|t| !t.kind.is_trivia()).collect();
            assert_eq!(read(text, &tokens, None).split_arrows.len(), expected, "{text}");
        }
    }
}
