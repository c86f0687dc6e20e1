//! Text → tokens. Every byte belongs to exactly one token: blanks, comments and what is no token at all included.
//!
//! Tokens carry no payload; their text is looked up in the source. Contextual words (`prefer`, `forall`, `weight`, …)
//! are identifiers here; the parser tells them apart by their place.
//!
//! The kinds, how each is written and what each is to a reader stand in one table, [`TABLE`]. The lexer is made of it,
//! and so are the grammars that editors colour programs by (`crates/grammars`).

use logos::{Lexer, Logos};
use scenelang_base::TextRange;

/// A token: what it is, and its bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    pub kind: Kind,
    /// Its bytes, relative to the text that was lexed.
    pub range: TextRange,
}

/// What a token is to a reader: what an editor has a colour for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Between tokens.
    Blank,
    Comment,
    /// A comment that documents.
    Documentation,
    /// A name of the program's own, or one that the standard library gives.
    Name,
    /// A number with its unit.
    Number,
    /// Text in quotation marks.
    Text,
    /// A word that says what is declared: `object`, `predicate`.
    Declaration,
    Type,
    /// A word that makes a sentence: `assert`, `forall`, `where`.
    Keyword,
    /// A reserved word that is called like a function.
    Function,
    /// A word that is a value: `true`, `objects`.
    Constant,
    /// What stands before a statement: `@req`.
    Attribute,
    /// `and`, `or`, `not`, `implies`, in words or signs.
    Logic,
    /// `=`, `<`, …
    Comparison,
    /// `+`, `-`, …
    Arithmetic,
    /// `..`
    Range,
    /// What gives a name its value: `<-`, `:=`.
    Assignment,
    /// The `.` before a property.
    Accessor,
    /// `,` and `:`
    Separator,
    /// The `;` after a statement.
    Terminator,
    /// Round and square brackets.
    Bracket,
    /// What no program may contain.
    Error,
}

/// A kind of token: how it is written, and what it is to a reader.
#[derive(Debug)]
pub struct TokenRow {
    pub kind: Kind,
    /// What it is to a reader.
    pub class: Class,
    /// Its spellings, if they can be listed.
    pub spellings: &'static [&'static str],
    /// Regular expressions for the others. Some only begin such a token: a function of the lexer finds its end.
    pub patterns: &'static [&'static str],
    /// Names that are this kind where a name cannot stand: contextual words.
    pub words: &'static [&'static str],
}

/// Makes [`Kind`] with its lexer, and [`TABLE`]. A row is `Kind Class`, then `= "spelling" | …`,
/// `~ (r"pattern", options of logos) | …`, `where "contextual word" | …`, as far as it has them.
macro_rules! tokens {
    ($(
        $(#[$doc:meta])* $kind:ident $class:ident
        $(= $($spelling:tt)|+)? $(~ $(($pattern:tt $($option:tt)*))|+)? $(where $($word:tt)|+)?;
    )*) => {
        /// Kinds of tokens. Different spellings of one operator are one kind.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Logos)]
        pub enum Kind {
            $(
                $(#[$doc])*
                $(#[doc = concat!($("`", $spelling, "` "),+)] $(#[token($spelling)])+)?
                $($(#[regex($pattern $($option)*)])+)?
                $(#[doc = concat!($("`", $word, "` "),+, "where no name can stand")])?
                $kind,
            )*
        }

        /// All kinds, in the order of [`Kind`].
        pub const TABLE: &[TokenRow] = &[$(TokenRow {
            kind: Kind::$kind,
            class: Class::$class,
            spellings: &[$($($spelling),+)?],
            patterns: &[$($($pattern),+)?],
            words: &[$($($word),+)?],
        }),*];
    };
}

tokens! {
    // ── Trivia ──
    /// Blanks and line breaks.
    Blank Blank ~ (r"[ \t\r\n\x0c]+");
    /// `// …`, also `////…`
    LineComment Comment ~ (r"//[^\r\n]*", allow_greedy = true, callback = line_comment);
    /// `/// …`: documents the declaration that follows.
    DocComment Documentation;
    /// `/* … */`, nesting
    BlockComment Comment ~ (r"/\*", block_comment);
    /// A byte order mark; trivia at the start of a file only.
    Bom Blank = "\u{feff}";

    // ── Names and literals ──
    /// A name, or a contextual word.
    Ident Name ~ (r"[\p{XID_Start}_]\p{XID_Continue}*");
    /// `2`, `.5`, `1e3`, `30cm`
    Number Number ~ (r"\.?[0-9]+", number);
    /// `"red"`
    Str Text ~ (r#""([^"\\\r\n]|\\[^\r\n])*""#);

    // ── Reserved words ──
    Object Declaration = "object";
    Entity Declaration = "entity";
    Region Declaration = "region";
    NumberType Type = "Number";
    Degree Type = "Degree";
    Bool Type = "Bool";
    Vector3 Type = "Vector3";
    Rotation Type = "Rotation";
    Color Type = "Color";
    Material Type = "Material";
    Assert Keyword = "assert";
    AllowCollide Keyword = "allowCollide";
    AllowOutside Keyword = "allowOutside";
    Inside Function = "inside";
    Rand Function = "rand";
    Vec3 Function = "vec3";
    Rot Function = "rot";
    DotWord Function = "dot";
    True Constant = "true";
    False Constant = "false";
    And Logic = "and" | "&&" | "∧";
    Or Logic = "or" | "||" | "∨";
    Not Logic = "not" | "!" | "¬";

    // ── Contextual words: never made by the lexer, but by `parse::words` from identifiers ──
    Prefer Keyword where "prefer";
    Weight Keyword where "weight";
    AllowFloat Keyword where "allowFloat";
    Predicate Declaration where "predicate";
    /// The type of a parameter:
    ParamType Type where "Object" | "Region" | "Objects" | "String";
    Import Keyword where "import";
    Forall Keyword where "forall";
    Exists Keyword where "exists";
    /// Before `(x in …`:
    Count Keyword where "count";
    In Keyword where "in";
    Where Keyword where "where";
    Implies Logic where "implies";
    Objects Constant where "objects";

    // ── Operators and punctuation ──
    Arrow Assignment = "<-";
    ArrowSign Assignment = "←";
    Define Assignment = ":=";
    Eq Comparison = "=" | "==";
    Ne Comparison = "!=" | "≠";
    Lt Comparison = "<";
    Le Comparison = "<=" | "≤";
    Gt Comparison = ">";
    Ge Comparison = ">=" | "≥";
    Plus Arithmetic = "+";
    Minus Arithmetic = "-";
    Star Arithmetic = "*";
    Slash Arithmetic = "/";
    DotDot Range = "..";
    Dot Accessor = ".";
    Comma Separator = ",";
    Colon Separator = ":";
    Semi Terminator = ";";
    LParen Bracket = "(";
    RParen Bracket = ")";
    LBracket Bracket = "[";
    RBracket Bracket = "]";
    Req Attribute = "@req";

    // ── Errors whose meaning is plain ──
    /// A comment that never closes: the rest of the text.
    OpenComment Error;
    /// A string that does not close: the rest of its line.
    OpenStr Error ~ (r#""([^"\\\r\n]|\\[^\r\n])*\\?"#);
    /// A string in other quotation marks: `'x'`, `“x”`, `«x»`, `` `x` ``.
    OddQuotes Error ~ (r#"'[^'";\r\n]*'"#) | (r#"`[^`";\r\n]*`"#)
        | (r#"[“”„‟‘’‚][^“”„‟‘’‚"';\r\n]*[“”„‟‘’"']"#) | (r#"«[^»";\r\n]*»"#);
    /// Digits with something attached that is no unit, or two decimal points.
    BadNumber Error;
    /// An operator of other languages:
    WrongOperator Error = "=>" | "=<" | "==>" | "->" | "<->" | "<=>" | "<>" | "===" | "!==" | "&" | "|" | "%" | "^" | "**"
        | "→" | "⇒" | "×" | "·" | "÷" | "−" | "–";
    /// `@` before anything but `req`.
    BadAttribute Error ~ (r"@\p{XID_Continue}*");
    /// Characters that mean nothing. A lone quotation mark is named, lest it takes along what could have been quoted.
    Unknown Error ~ ("['`“”„‟‘’‚«»]");
}

impl Kind {
    /// Its row in the table.
    pub fn row(self) -> &'static TokenRow {
        &TABLE[self as usize]
    }
    /// What it is to a reader.
    pub fn class(self) -> Class {
        self.row().class
    }
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
    fn the_table_is_what_the_lexer_does() {
        for (i, row) in TABLE.iter().enumerate() {
            assert_eq!(row.kind as usize, i, "rows stand in the order of the kinds");
            for spelling in row.spellings {
                let kinds: Vec<Kind> = lex(spelling).iter().map(|t| t.kind).collect();
                assert_eq!(kinds, [row.kind], "{spelling}");
            }
            for word in row.words {
                assert_eq!(lex(word)[0].kind, Kind::Ident, "{word} is contextual, not reserved");
            }
        }
        let all: Vec<&str> = TABLE.iter().flat_map(|r| r.spellings.iter().chain(r.words).copied()).collect();
        let distinct: std::collections::BTreeSet<_> = all.iter().collect();
        assert_eq!(distinct.len(), all.len(), "no spelling stands twice");
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
