//! What the lexer could not read, as diagnostics: quotes, numbers, escapes, comments, foreign operators, stray
//! characters. Where the meaning is plain, the parser goes on with it.

use super::literals;
use crate::library;
use crate::token::{Kind, Token, UNITS};
use scenelang_base::codes::{E0101, E0102, E0103, E0104, E0105, E0106, E0115, E0116};
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, TextRange};

use super::wording::quote;

/// What the lexical errors of a statement allow the parser to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damage {
    /// There are none.
    None,
    /// All have a plain meaning: the tree is right, if the rest is.
    Repaired,
    /// Some part has no meaning.
    Lost,
}

/// The most errors that are told of one statement.
const MOST: usize = 100;

/// Operators of other languages: what they are here (if anything), how it is written, and a remark.
const FOREIGN: &[(&str, Option<Kind>, &str, &str)] = &[
    ("=>", Some(Kind::Ge), ">=", "for an implication, write `implies`"),
    ("=<", Some(Kind::Le), "<=", ""),
    ("==>", Some(Kind::Implies), "implies", ""),
    ("⇒", Some(Kind::Implies), "implies", ""),
    ("->", Some(Kind::Implies), "implies", "to assign, write `<-`"),
    ("→", Some(Kind::Implies), "implies", "to assign, write `<-`"),
    ("<->", Some(Kind::Eq), "=", "between conditions, `=` means that both hold or neither does"),
    ("<=>", Some(Kind::Eq), "=", "between conditions, `=` means that both hold or neither does"),
    ("<>", Some(Kind::Ne), "!=", ""),
    ("===", Some(Kind::Eq), "=", ""),
    ("!==", Some(Kind::Ne), "!=", ""),
    ("&", Some(Kind::And), "and", ""),
    ("|", Some(Kind::Or), "or", ""),
    ("×", Some(Kind::Star), "*", ""),
    ("·", Some(Kind::Star), "*", ""),
    ("÷", Some(Kind::Slash), "/", ""),
    ("−", Some(Kind::Minus), "-", ""),
    ("–", Some(Kind::Minus), "-", ""),
    ("%", None, "", "write a fraction: 0.1 for 10 %"),
    ("^", None, "", "for a square, write `a * a`"),
    ("**", None, "", "for a square, write `a * a`"),
];

/// The kind that an operator of another language has here.
pub fn intended_operator(text: &str) -> Option<Kind> {
    FOREIGN.iter().find(|(sign, ..)| *sign == text).and_then(|(_, kind, ..)| *kind)
}

/// Whether the operator at `at` is `=>` before what can only be a condition: it is no misspelt `>=`.
pub fn is_implication(text: &str, tokens: &[Token], at: usize) -> bool {
    let slice = |at: usize| tokens.get(at).map_or("", |t| &text[t.range.bytes()]);
    let next = slice(at + 1);
    let is_called = slice(at + 2) == "(" && library::predicates().contains_key(next);
    slice(at) == "=>" && (is_called || matches!(next, "not" | "inside" | "forall" | "exists"))
}

/// Reports what is wrong with single tokens of a statement. Of characters without meaning only the first is told, and
/// an open string or comment ends the list: what follows is a consequence.
pub fn check(text: &str, tokens: &[Token]) -> (Vec<Diagnostic<TextRange>>, Damage) {
    let mut found = Vec::new();
    let mut damage = Damage::None;
    for (at, token) in tokens.iter().enumerate() {
        if found.len() == MOST {
            return (found, Damage::Lost);
        }
        let slice = &text[token.range.bytes()];
        let before = at.checked_sub(1).map(|b| tokens[b]);
        let (diagnostic, worse) = match token.kind {
            Kind::Str => (bad_escape(slice, token.range), Damage::Repaired),
            Kind::OpenStr => (Some(open_string(slice, token.range)), Damage::Repaired),
            Kind::OddQuotes => (Some(odd_quotes(slice, token.range)), Damage::Repaired),
            Kind::Number => (too_large(slice, token.range), Damage::Repaired),
            Kind::BadNumber => (Some(bad_number(slice, token.range, before)), Damage::Repaired),
            Kind::WrongOperator => {
                let assigns = tokens.first().is_some_and(|t| t.kind == Kind::Ident);
                let repaired = intended_operator(slice).map_or(Damage::Lost, |_| Damage::Repaired);
                let implies = is_implication(text, tokens, at);
                (Some(foreign_operator(text, token.range, assigns, implies)), repaired)
            }
            Kind::OpenComment => (Some(open_comment(token.range)), Damage::Repaired),
            Kind::BadAttribute if damage != Damage::Lost => (Some(bad_attribute(slice, token.range)), Damage::Lost),
            Kind::Unknown | Kind::Bom if damage != Damage::Lost => {
                let number = before.filter(|b| b.kind == Kind::Number && b.range.end == token.range.start);
                let quantified = slice.starts_with('{') && awaits_colon(text, &tokens[..at]);
                let grouped = number
                    .filter(|_| slice.starts_with(['\'', '’']))
                    .and(tokens.get(at + 1))
                    .is_some_and(|next| next.kind == Kind::Number && next.range.start == token.range.end);
                let diagnostic = match (quantified, grouped) {
                    (true, _) => block_of_quantifier(token.range),
                    (_, true) => Diagnostic::new(E0106, token.range, "digits cannot be grouped").fix(
                        Applicability::Safe,
                        format!("remove {}", quote(slice)),
                        token.range,
                        "",
                    ),
                    _ => unknown(slice, token.range, number),
                };
                (Some(diagnostic), Damage::Lost)
            }
            _ => (None, Damage::None),
        };
        if let Some(diagnostic) = diagnostic {
            found.push(diagnostic);
            if damage != Damage::Lost {
                damage = worse;
            }
        }
    }
    (found, damage)
}

fn bad_escape(slice: &str, range: TextRange) -> Option<Diagnostic<TextRange>> {
    let bad = literals::bad_escape(slice)?;
    let place = TextRange::new(bad.start, bad.end).shifted(range.start);
    let escape = &slice[bad];
    let message = match escape.starts_with("\\u") {
        true => format!("{} is not a valid character", quote(escape)),
        false => format!("{} is not an escape", quote(escape)),
    };
    let diagnostic = Diagnostic::new(E0103, place, message)
        .note("the escapes are `\\\"` `\\\\` `\\/` `\\n` `\\r` `\\t` and `\\u` with four hexadecimal digits")
        .fix(Applicability::Unsafe, "write a backslash as `\\\\`", TextRange::empty(place.start), "\\");
    Some(diagnostic)
}

fn open_string(slice: &str, range: TextRange) -> Diagnostic<TextRange> {
    let end = slice.trim_end_matches([';', ')', ',', ' ', '\t']);
    let curly = end.ends_with(['“', '”']);
    let place = TextRange::empty(range.start + end.len() as u32);
    let diagnostic =
        Diagnostic::new(E0102, range, "this string is not closed on its line").label("the string begins here");
    if curly {
        let quote = end.char_indices().next_back().map_or(0, |(i, _)| i) as u32 + range.start;
        let last = TextRange { start: quote, end: place.end };
        diagnostic.note("a typographic quotation mark does not close a string").fix(
            Applicability::Unsafe,
            "write `\"`",
            last,
            "\"",
        )
    } else {
        diagnostic.fix(Applicability::Unsafe, "close the string", place, "\"")
    }
}

fn odd_quotes(slice: &str, range: TextRange) -> Diagnostic<TextRange> {
    let inner = literals::string_value(slice);
    let straight = format!("\"{}\"", inner.replace('\\', "\\\\").replace('"', "\\\""));
    let title = format!("write {}", quote(&straight));
    Diagnostic::new(E0104, range, format!("strings are written in straight double quotes, not as {}", quote(slice)))
        .fix(Applicability::Safe, title, range, straight)
}

fn too_large(slice: &str, range: TextRange) -> Option<Diagnostic<TextRange>> {
    // Only a long number or one with an exponent can be out of range; most are neither.
    let suspect = slice.len() > 300 || slice.contains(['e', 'E']);
    if !suspect || literals::number_value(slice).is_some() {
        return None;
    }
    let message = format!("{} is too large", quote(slice));
    Some(Diagnostic::new(E0106, range, message).note("the largest number is about 1.8e308"))
}

fn bad_number(slice: &str, range: TextRange, before: Option<Token>) -> Diagnostic<TextRange> {
    let names = |b: Token| super::words::starts_statement(b.kind);
    if before.is_some_and(names) {
        let message = format!("{} is not a name: a name begins with a letter or `_`", quote(slice));
        return Diagnostic::new(E0106, range, message);
    }
    let (digits, suffix) = literals::split_unit(slice);
    let diagnostic = Diagnostic::new(E0106, range, format!("{} is not a number", quote(slice)));
    let plain = slice.replace('_', "");
    if plain != slice && literals::number_value(&plain).is_some() {
        let title = format!("write {}", quote(&plain));
        return diagnostic.note("digits cannot be grouped").fix(Applicability::Safe, title, range, plain);
    }
    if suffix.starts_with('.') || suffix.contains('.') {
        return diagnostic.note("it has more than one decimal point");
    }
    if matches!(suffix, "e" | "E") {
        return diagnostic.note("the exponent has no digits");
    }
    let place = TextRange { start: range.start + digits.len() as u32, end: range.end };
    let diagnostic = diagnostic.label(format!("{} is not a unit", quote(suffix)));
    let diagnostic = diagnostic.note("units are `m` `cm` `mm` `ft` `in` `deg` `rad`, directly after the digits");
    match unit_meant(suffix) {
        Some(unit) => {
            diagnostic.fix(Applicability::Safe, format!("write `{}{unit}`", quote_inner(digits)), place, unit)
        }
        None => diagnostic,
    }
}

fn quote_inner(text: &str) -> String {
    quote(text).trim_matches('`').to_owned()
}

/// The unit that a longer word for it, or another case, means.
pub fn unit_meant(suffix: &str) -> Option<&'static str> {
    let lower = suffix.to_lowercase();
    let long = match lower.as_str() {
        "meter" | "meters" | "metre" | "metres" => "m",
        "centimeter" | "centimeters" | "centimetre" | "centimetres" => "cm",
        "millimeter" | "millimeters" | "millimetre" | "millimetres" => "mm",
        "foot" | "feet" => "ft",
        "inch" | "inches" => "in",
        "degree" | "degrees" | "degs" => "deg",
        "radian" | "radians" | "rads" => "rad",
        other => return UNITS.into_iter().find(|unit| *unit == other),
    };
    Some(long)
}

/// `assigns`: it stands behind the target of an assignment; `implies`: `=>` between conditions.
fn foreign_operator(text: &str, range: TextRange, assigns: bool, implies: bool) -> Diagnostic<TextRange> {
    let slice = &text[range.bytes()];
    let entry = FOREIGN.iter().find(|(sign, ..)| *sign == slice);
    let (meant, remark) = entry.map_or(("", ""), |(_, _, meant, remark)| (*meant, *remark));
    let arrow = matches!(slice, "->" | "→");
    let (meant, remark) = match (arrow && assigns, implies) {
        (true, _) => ("<-", ""),
        (_, true) => ("implies", ""),
        _ => (meant, remark),
    };
    let mut diagnostic = Diagnostic::new(E0116, range, format!("there is no operator {}", quote(slice)));
    if !meant.is_empty() {
        let applicability = if remark.is_empty() { Applicability::Safe } else { Applicability::Unsafe };
        // A word needs blanks around it where the sign had none.
        let touches =
            |beside: Option<char>| meant.starts_with(char::is_alphabetic) && !beside.is_some_and(char::is_whitespace);
        let before = if touches(text[..range.start as usize].chars().next_back()) { " " } else { "" };
        let after = if touches(text[range.end as usize..].chars().next()) { " " } else { "" };
        let text = format!("{before}{meant}{after}");
        diagnostic = diagnostic.label(format!("write `{meant}`"));
        diagnostic = diagnostic.fix(applicability, format!("write `{meant}`"), range, text);
    }
    if remark.is_empty() { diagnostic } else { diagnostic.note(remark) }
}

fn open_comment(range: TextRange) -> Diagnostic<TextRange> {
    let place = TextRange { start: range.start, end: range.start + 2 };
    Diagnostic::new(E0105, place, "this comment is never closed")
        .label("begins here")
        .note("comments nest, so every `/*` needs its own `*/`; the rest of the file is ignored")
}

fn bad_attribute(slice: &str, range: TextRange) -> Diagnostic<TextRange> {
    let diagnostic = Diagnostic::new(E0115, range, format!("unknown annotation {}", quote(slice)))
        .note("`@req(\"…\")` records the requirement that a statement expresses");
    match nearest(slice, ["@req"]) {
        Some(near) => diagnostic.fix(Applicability::Unsafe, format!("write `{near}`"), range, near),
        None => diagnostic,
    }
}

/// Whether some tokens end in a quantifier and its set, without the `:`.
fn awaits_colon(text: &str, tokens: &[Token]) -> bool {
    let is_quantifier = |token: &Token| matches!(&text[token.range.bytes()], "forall" | "exists");
    tokens.iter().rposition(is_quantifier).is_some_and(|at| tokens[at..].iter().all(|t| t.kind != Kind::Colon))
}

fn block_of_quantifier(range: TextRange) -> Diagnostic<TextRange> {
    let place = TextRange { start: range.start, end: range.start + 1 };
    Diagnostic::new(E0101, place, "write the condition of a quantifier after `:`, without braces")
        .note("as in `forall c in chair: near(c, table, 1)`; several conditions are joined with `and`")
}

/// `number`: the number that ends where the characters begin.
fn unknown(slice: &str, range: TextRange, number: Option<Token>) -> Diagnostic<TextRange> {
    let Some(first) = slice.chars().next() else {
        return Diagnostic::new(E0101, range, "these characters are not part of the language");
    };
    let one = TextRange { start: range.start, end: range.start + first.len_utf8() as u32 };
    if matches!(first, '"' | '\'' | '`' | '“' | '”' | '„' | '‟' | '‘' | '’' | '‚' | '«' | '»') {
        return Diagnostic::new(E0104, one, format!("unexpected quotation mark `{first}`"))
            .note("strings are written in straight double quotes: `\"red\"`");
    }
    let message = match first {
        '\0'..='\x1f' | '\x7f'..='\u{9f}' => format!("unexpected control character U+{:04X}", first as u32),
        c if invisible(c) => format!("unexpected invisible character U+{:04X}", c as u32),
        c => format!("unexpected character `{c}`"),
    };
    let place = if invisible(first) { one } else { range };
    let diagnostic = Diagnostic::new(E0101, place, message);
    if let (Some(_), '°') = (number, first) {
        return diagnostic.fix(Applicability::Safe, "write `deg`", one, "deg");
    }
    if let Some(plain) = wide(first) {
        return diagnostic.fix(Applicability::Safe, format!("write `{plain}`"), one, plain);
    }
    match first {
        '\u{a0}' | '\u{2000}'..='\u{200a}' | '\u{202f}' | '\u{3000}' => {
            diagnostic.fix(Applicability::Safe, "write an ordinary space", one, " ")
        }
        c if invisible(c) => diagnostic.fix(Applicability::Safe, "remove it", one, ""),
        '{' if place.start == 0 => {
            diagnostic.note("the language has no blocks; if this file is a layout, its name must end in `.json`")
        }
        '{' | '}' => diagnostic.note(
            "the language has no blocks: a statement ends with `;`, and \"if A, then B\" is written `A implies B`",
        ),
        '#' => diagnostic.note("a comment begins with `//`"),
        c if c.is_ascii() => diagnostic,
        _ => diagnostic.note("a name consists of letters, digits and `_`"),
    }
}

/// Characters that cannot be seen, and so are best named by their number.
fn invisible(c: char) -> bool {
    matches!(c, '\u{a0}' | '\u{ad}' | '\u{2000}'..='\u{200f}' | '\u{2028}'..='\u{202f}' | '\u{2060}'..='\u{2064}' | '\u{3000}' | '\u{feff}')
}

/// The plain form of a full-width sign.
fn wide(c: char) -> Option<String> {
    let code = u32::from(c);
    let plain = (0xff01..=0xff5e).contains(&code).then(|| char::from_u32(code - 0xfee0)).flatten();
    plain.filter(|p| p.is_ascii_punctuation()).map(String::from)
}
