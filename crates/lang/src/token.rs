//! Text → tokens. Every byte belongs to exactly one token: blanks, comments and what is no token at all included.
//!
//! Tokens carry no payload; their text is looked up in the source. Contextual words (`prefer`, `forall`, `weight`, …)
//! are identifiers here; the parser tells them apart by their place.

use logos::{Lexer, Logos};
use scenelang_base::TextRange;

/// A token: what it is, and its bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: Kind,
    /// Its bytes, relative to the text that was lexed.
    pub range: TextRange,
}

/// Kinds of tokens. Different spellings of one operator are one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Logos)]
pub enum Kind {
    // ── Trivia ──
    /// Blanks and line breaks.
    #[regex(r"[ \t\r\n\x0c]+")]
    Blank,
    /// `// …`, also `////…`
    #[regex(r"//[^\r\n]*", allow_greedy = true, callback = line_comment)]
    LineComment,
    /// `/// …`: documents the declaration that follows.
    DocComment,
    /// `/* … */`, nesting
    #[token("/*", block_comment)]
    BlockComment,
    /// A byte order mark; trivia at the start of a file only.
    #[token("\u{feff}")]
    Bom,

    // ── Names and literals ──
    /// A name, or a contextual word.
    #[regex(r"[\p{XID_Start}_]\p{XID_Continue}*")]
    Ident,
    /// `2`, `.5`, `1e3`, `30cm`
    #[regex(r"\.?[0-9]+", number)]
    Number,
    /// `"red"`
    #[regex(r#""([^"\\\r\n]|\\[^\r\n])*""#)]
    Str,

    // ── Reserved words ──
    /// `object`
    #[token("object")]
    Object,
    /// `entity`
    #[token("entity")]
    Entity,
    /// `region`
    #[token("region")]
    Region,
    /// `Number`, the type
    #[token("Number")]
    NumberType,
    /// `Degree`
    #[token("Degree")]
    Degree,
    /// `Bool`
    #[token("Bool")]
    Bool,
    /// `Vector3`
    #[token("Vector3")]
    Vector3,
    /// `Rotation`
    #[token("Rotation")]
    Rotation,
    /// `Color`
    #[token("Color")]
    Color,
    /// `Material`
    #[token("Material")]
    Material,
    /// `assert`
    #[token("assert")]
    Assert,
    /// `allowCollide`
    #[token("allowCollide")]
    AllowCollide,
    /// `allowOutside`
    #[token("allowOutside")]
    AllowOutside,
    /// `inside`
    #[token("inside")]
    Inside,
    /// `rand`
    #[token("rand")]
    Rand,
    /// `vec3`
    #[token("vec3")]
    Vec3,
    /// `rot`
    #[token("rot")]
    Rot,
    /// `dot`
    #[token("dot")]
    DotWord,
    /// `true`
    #[token("true")]
    True,
    /// `false`
    #[token("false")]
    False,
    /// `and`, `&&`, `∧`
    #[token("and")]
    #[token("&&")]
    #[token("∧")]
    And,
    /// `or`, `||`, `∨`
    #[token("or")]
    #[token("||")]
    #[token("∨")]
    Or,
    /// `not`, `!`, `¬`
    #[token("not")]
    #[token("!")]
    #[token("¬")]
    Not,

    // ── Contextual words: never made by the lexer, but by `parse::words` from identifiers ──
    /// `prefer`
    Prefer,
    /// `weight`
    Weight,
    /// `allowFloat`
    AllowFloat,
    /// `predicate`
    Predicate,
    /// `Object`, `Region`, `Objects`, `String` before a parameter
    ParamType,
    /// `import`
    Import,
    /// `forall`
    Forall,
    /// `exists`
    Exists,
    /// `count` before `(x in …`
    Count,
    /// `in`
    In,
    /// `where`
    Where,
    /// `implies`
    Implies,
    /// `objects`
    Objects,

    // ── Operators and punctuation ──
    /// `<-`
    #[token("<-")]
    Arrow,
    /// `←`
    #[token("←")]
    ArrowSign,
    /// `:=`
    #[token(":=")]
    Define,
    /// `=`, `==`
    #[token("=")]
    #[token("==")]
    Eq,
    /// `!=`, `≠`
    #[token("!=")]
    #[token("≠")]
    Ne,
    /// `<`
    #[token("<")]
    Lt,
    /// `<=`, `≤`
    #[token("<=")]
    #[token("≤")]
    Le,
    /// `>`
    #[token(">")]
    Gt,
    /// `>=`, `≥`
    #[token(">=")]
    #[token("≥")]
    Ge,
    /// `+`
    #[token("+")]
    Plus,
    /// `-`
    #[token("-")]
    Minus,
    /// `*`
    #[token("*")]
    Star,
    /// `/`
    #[token("/")]
    Slash,
    /// `..`
    #[token("..")]
    DotDot,
    /// `.`
    #[token(".")]
    Dot,
    /// `,`
    #[token(",")]
    Comma,
    /// `:`
    #[token(":")]
    Colon,
    /// `;`
    #[token(";")]
    Semi,
    /// `(`
    #[token("(")]
    LParen,
    /// `)`
    #[token(")")]
    RParen,
    /// `[`
    #[token("[")]
    LBracket,
    /// `]`
    #[token("]")]
    RBracket,
    /// `@req`
    #[token("@req")]
    Req,

    // ── Errors whose meaning is plain ──
    /// A comment that never closes: the rest of the text.
    OpenComment,
    /// A string that does not close: the rest of its line.
    #[regex(r#""([^"\\\r\n]|\\[^\r\n])*\\?"#)]
    OpenStr,
    /// A string in other quotation marks: `'x'`, `“x”`, `«x»`, `` `x` ``.
    #[regex(r#"'[^'";\r\n]*'"#)]
    #[regex(r#"`[^`";\r\n]*`"#)]
    #[regex(r#"[“”„‟‘’‚][^“”„‟‘’‚"';\r\n]*[“”„‟‘’"']"#)]
    #[regex(r#"«[^»";\r\n]*»"#)]
    OddQuotes,
    /// Digits with something attached that is no unit, or two decimal points.
    BadNumber,
    /// An operator of other languages: `=>`, `&`, `×`, …
    #[token("=>")]
    #[token("=<")]
    #[token("==>")]
    #[token("->")]
    #[token("<->")]
    #[token("<=>")]
    #[token("<>")]
    #[token("===")]
    #[token("!==")]
    #[token("&")]
    #[token("|")]
    #[token("%")]
    #[token("^")]
    #[token("**")]
    #[token("→")]
    #[token("⇒")]
    #[token("×")]
    #[token("·")]
    #[token("÷")]
    #[token("−")]
    #[token("–")]
    WrongOperator,
    /// `@` before anything but `req`.
    #[regex(r"@\p{XID_Continue}*")]
    BadAttribute,
    /// Characters that mean nothing. A lone quotation mark is named, lest it takes along what could have been quoted.
    #[regex("['`“”„‟‘’‚«»]")]
    Unknown,
}

impl Kind {
    /// Whether it separates tokens and means nothing to the parser. A byte order mark is not among them.
    pub fn is_trivia(self) -> bool {
        matches!(self, Self::Blank | Self::LineComment | Self::DocComment | Self::BlockComment)
    }
    /// Whether it is a comment of any kind.
    pub fn is_comment(self) -> bool {
        matches!(self, Self::LineComment | Self::DocComment | Self::BlockComment | Self::OpenComment)
    }
}

/// Units that may follow a number directly.
pub const UNITS: [&str; 7] = ["m", "cm", "mm", "ft", "in", "deg", "rad"];

/// Cuts a text into tokens that cover it without gaps.
pub fn lex(text: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::with_capacity(text.len() / 3);
    for (kind, range) in Kind::lexer(text).spanned() {
        let kind = kind.unwrap_or(Kind::Unknown);
        match tokens.last_mut() {
            Some(last) if kind == Kind::Unknown && last.kind == kind => last.range.end = range.end as u32,
            _ => tokens.push(Token { kind, range: TextRange::new(range.start, range.end) }),
        }
    }
    tokens
}

/// Three slashes document, two or more than three do not (rulers of slashes are common).
fn line_comment(lexer: &mut Lexer<'_, Kind>) -> Kind {
    let text = lexer.slice();
    if text.starts_with("///") && !text.starts_with("////") { Kind::DocComment } else { Kind::LineComment }
}

fn block_comment(lexer: &mut Lexer<'_, Kind>) -> Kind {
    let rest = lexer.remainder().as_bytes();
    let (mut depth, mut at) = (1u32, 0);
    while let Some(&byte) = rest.get(at) {
        match (byte, rest.get(at + 1)) {
            (b'/', Some(b'*')) => {
                depth += 1;
                at += 2;
            }
            (b'*', Some(b'/')) => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    lexer.bump(at);
                    return Kind::BlockComment;
                }
            }
            _ => at += 1,
        }
    }
    lexer.bump(rest.len());
    Kind::OpenComment
}

/// Goes on after the first digits: fraction, exponent, unit. By hand, because `0..5` needs a look ahead.
fn number(lexer: &mut Lexer<'_, Kind>) -> Kind {
    let rest = lexer.remainder();
    let bytes = rest.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut at = 0;
    if !lexer.slice().starts_with('.') && bytes.first() == Some(&b'.') && bytes.get(1) != Some(&b'.') {
        at = 1 + digits(1);
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        let exponent = digits((at + 1 + sign).min(bytes.len()));
        if exponent > 0 {
            at += 1 + sign + exponent;
        }
    }
    let word = |from: usize| -> usize {
        rest[from..].chars().take_while(|c| unicode_ident::is_xid_continue(*c)).map(char::len_utf8).sum()
    };
    let suffix = word(at);
    let mut end = at + suffix;
    let mut good = suffix == 0 || UNITS.contains(&&rest[at..end]);
    while bytes.get(end) == Some(&b'.') && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        good = false;
        end += 1 + word(end + 1);
    }
    lexer.bump(end);
    if good { Kind::Number } else { Kind::BadNumber }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Tokens without blanks, as `kind text`.
    fn show(text: &str) -> String {
        let shown = lex(text)
            .into_iter()
            .filter(|t| t.kind != Kind::Blank)
            .map(|t| format!("{:?} {}", t.kind, &text[t.range.bytes()]));
        shown.collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn numbers() {
        let cases = [
            ("5", "Number 5"),
            ("5.", "Number 5."),
            (".5", "Number .5"),
            ("1e3", "Number 1e3"),
            ("007", "Number 007"),
            ("2.5E-3cm", "Number 2.5E-3cm"),
            ("5.e3", "Number 5.e3"),
            ("30cm", "Number 30cm"),
            ("5in", "Number 5in"),
            ("0..5", "Number 0 | DotDot .. | Number 5"),
            ("0.5..1.5", "Number 0.5 | DotDot .. | Number 1.5"),
            ("1 in", "Number 1 | Ident in"),
            ("1e", "BadNumber 1e"),
            ("1_000", "BadNumber 1_000"),
            ("3kg", "BadNumber 3kg"),
            ("1.2.3", "BadNumber 1.2.3"),
            ("5м", "BadNumber 5м"),
            ("-1", "Minus - | Number 1"),
            ("a.5", "Ident a | Number .5"),
            ("1...5", "Number 1 | DotDot .. | Number .5"),
        ];
        for (text, expected) in cases {
            assert_eq!(show(text), expected, "{text}");
        }
    }

    #[test]
    fn spellings_of_operators() {
        let cases = [
            ("<- ←", "Arrow <- | ArrowSign ←"),
            ("= ==", "Eq = | Eq =="),
            ("!= ≠", "Ne != | Ne ≠"),
            ("<= ≤ >= ≥", "Le <= | Le ≤ | Ge >= | Ge ≥"),
            ("and && ∧", "And and | And && | And ∧"),
            ("or || ∨", "Or or | Or || | Or ∨"),
            ("not ! ¬", "Not not | Not ! | Not ¬"),
            ("a<-1", "Ident a | Arrow <- | Number 1"),
            (
                "=> =< -> === <>",
                "WrongOperator => | WrongOperator =< | WrongOperator -> | WrongOperator === | WrongOperator <>",
            ),
            ("@req @reqs @", "Req @req | BadAttribute @reqs | BadAttribute @"),
        ];
        for (text, expected) in cases {
            assert_eq!(show(text), expected, "{text}");
        }
    }

    #[test]
    fn strings_and_comments() {
        let cases = [
            (r#""a \" b""#, r#"Str "a \" b""#),
            ("\"open;\nx", "OpenStr \"open; | Ident x"),
            ("\"open\\\nx", "OpenStr \"open\\ | Ident x"),
            ("“red”", "OddQuotes “red”"),
            ("“red\"", "OddQuotes “red\""),
            ("\"red”;", "OpenStr \"red”;"),
            ("'red'", "OddQuotes 'red'"),
            ("' ;", "Unknown ' | Semi ;"),
            ("/* a /* b */ c */ d", "BlockComment /* a /* b */ c */ | Ident d"),
            ("/* a /* b */ c", "OpenComment /* a /* b */ c"),
            ("/**/x", "BlockComment /**/ | Ident x"),
            ("// a\r/// b\r\n//// c", "LineComment // a | DocComment /// b | LineComment //// c"),
        ];
        for (text, expected) in cases {
            assert_eq!(show(text), expected, "{text}");
        }
    }

    #[test]
    fn names_are_xid_and_only_core_words_are_reserved() {
        assert_eq!(
            show("_a1 lámpara 日本語 prefer objects"),
            "Ident _a1 | Ident lámpara | Ident 日本語 | Ident prefer | Ident objects"
        );
        assert_eq!(show("objects object rot"), "Ident objects | Object object | Rot rot");
        assert_eq!(show("a\u{200b}b"), "Ident a | Unknown \u{200b} | Ident b");
        assert_eq!(lex("\0\0\0\u{1}").len(), 1);
    }

    proptest! {
        #[test]
        fn tokens_cover_any_text(text in r#"([\PC\n\r\t"'/*.0-9e<>=-]|//|/\*|\*/|0\.\.5|“x”){0,60}"#) {
            let mut at = 0;
            for token in lex(&text) {
                prop_assert_eq!(token.range.start, at);
                prop_assert!(token.range.end > at);
                prop_assert!(text.is_char_boundary(token.range.end as usize));
                at = token.range.end;
            }
            prop_assert_eq!(at as usize, text.len());
        }
    }
}
