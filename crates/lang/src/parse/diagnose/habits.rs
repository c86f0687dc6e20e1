//! What people write as other languages or plain English do: `Not`, `if … then`, `every`, `(0, 0, 0)`, a sentence after
//! `assert`, `x < 5 and > 2`.

use super::super::wanted::Wanted;
use super::super::words::{ends_value, is_constructor};
use super::{Finding, Site, quote};
use crate::token::Kind;
use scenelang_base::codes::{E0110, E0112, E0116};
use scenelang_base::{Applicability, Diagnostic, TextRange};

/// Words before a variable that other languages quantify with.
const QUANTIFIERS: &[(&str, &str)] = &[
    ("forall", "forall"),
    ("all", "forall"),
    ("every", "forall"),
    ("each", "forall"),
    ("for", "forall"),
    ("foreach", "forall"),
    ("exists", "exists"),
    ("exist", "exists"),
    ("any", "exists"),
    ("some", "exists"),
];

/// `Not near(a, b, 1)`, `FORALL c in chair: …`, `if a > 1 then …`: a word before a value that is no operator as it is
/// written.
pub fn prefix(site: &Site<'_>) -> Option<Finding> {
    let found = site.found()?;
    let at = site.at.checked_sub(1).filter(|at| *at > site.head && site.kind(*at) == Some(Kind::Ident))?;
    let opens = matches!(site.kind(at - 1)?, Kind::Assert | Kind::Prefer | Kind::And | Kind::Or | Kind::Implies)
        || matches!(site.kind(at - 1)?, Kind::LParen | Kind::Colon | Kind::Not | Kind::Define);
    let value = matches!(found, Kind::Ident | Kind::Number | Kind::Not | Kind::True | Kind::False | Kind::Count);
    if !opens || !(value || is_constructor(found)) {
        return None;
    }
    let (word, place) = (site.slice(at), site.range(at));
    let meant = |meant: &str, applicability| {
        Diagnostic::new(E0116, place, format!("unknown word {}", quote(word)))
            .label(format!("did you mean `{meant}`?"))
            .fix(applicability, format!("write `{meant}`"), place, meant)
    };
    if word.eq_ignore_ascii_case("not") {
        return Some(meant("not", Applicability::Safe));
    }
    if word.eq_ignore_ascii_case("if") {
        let diagnostic = Diagnostic::new(E0116, place, "unknown word `if`");
        return Some(
            diagnostic.note("\"if A, then B\" is written `A implies B`, as in `near(a, b, 1) implies facing(a, b)`"),
        );
    }
    let bound = found == Kind::Ident && site.slice(site.at + 1) == "in";
    let (other, quantifier) = QUANTIFIERS.iter().find(|(other, _)| bound && other.eq_ignore_ascii_case(word))?;
    let applicability = if other == quantifier { Applicability::Safe } else { Applicability::Unsafe };
    Some(meant(quantifier, applicability))
}

/// `all(c in chair: …)`: a quantifier that is written like a call.
pub fn called_quantifier(site: &Site<'_>) -> Option<Finding> {
    let open = site.at.checked_sub(2).filter(|open| site.slice(site.at) == "in" && *open > 0)?;
    if (site.kind(open), site.kind(open + 1)) != (Some(Kind::LParen), Some(Kind::Ident)) {
        return None;
    }
    let word = site.slice(open - 1);
    let (_, quantifier) = QUANTIFIERS.iter().find(|(other, _)| other.eq_ignore_ascii_case(word))?;
    let diagnostic = Diagnostic::new(E0110, site.range(open - 1), "a quantifier is not written like a function call");
    Some(diagnostic.note(format!("write `{quantifier} {} in …: …`, without parentheses", site.slice(open + 1))))
}

/// A sentence directly after `assert` or `prefer`, or at its end.
pub fn sentence(site: &Site<'_>) -> Option<Finding> {
    if !matches!(site.kind(site.head)?, Kind::Assert | Kind::Prefer) {
        return None;
    }
    let (keyword, first) = (site.range(site.head), site.head + 1);
    let (string, end) = match site.kind(first)? {
        Kind::Str => (first, first),
        Kind::LParen if site.kind(first + 1) == Some(Kind::Str) && site.kind(first + 2) == Some(Kind::RParen) => {
            (first + 1, first + 2)
        }
        _ => return trailing_sentence(site),
    };
    let begins =
        matches!(site.found()?, Kind::Ident | Kind::Not | Kind::Forall | Kind::Exists | Kind::LParen | Kind::Count);
    let joined = matches!(site.found()?, Kind::Comma | Kind::Colon);
    if site.at != end + 1 || !(begins || joined || is_constructor(site.found()?)) {
        return None;
    }
    let word = site.slice(site.head);
    let written = format!("@req({}) {word}", site.slice(string));
    let replaced = if joined { keyword.cover(site.range(site.at)) } else { keyword.cover(site.range(end)) };
    let title = format!("write {}", quote(&written));
    let message = format!("`{word}` does not take a string; put the requirement before it, in `@req(\"…\")`");
    Some(Diagnostic::new(E0110, site.range(string), message).fix(Applicability::Safe, title, replaced, written))
}

/// `assert near(a, b, 1), "they are close"`
fn trailing_sentence(site: &Site<'_>) -> Option<Finding> {
    let string = match site.found()? {
        Kind::Comma => site.at + 1,
        _ => site.at,
    };
    let whole = string + 1 == site.kinds.len() && site.kind(string) == Some(Kind::Str);
    let complete = site.wanted.has(Wanted::OPERATOR) || site.wanted.has(Wanted::CONNECTIVE);
    (whole && complete && site.innermost_open().is_none())
        .then(|| requirement(site.range(string), site.slice(site.head)))
}

fn requirement(place: TextRange, word: &str) -> Finding {
    let message = format!("`{word}` takes no text; write the requirement before it, with `@req`");
    Diagnostic::new(E0110, place, message).note(format!("write `@req(\"…\") {word} …;`"))
}

/// `prefer near(a, b, 1), 3`: a weight behind a comma.
pub fn weight(site: &Site<'_>) -> Option<Finding> {
    let last = site.at + 2 == site.kinds.len() && site.kind(site.at + 1) == Some(Kind::Number);
    if site.kind(site.head) != Some(Kind::Prefer) || site.found() != Some(Kind::Comma) || !last {
        return None;
    }
    if site.innermost_open().is_some() {
        return None;
    }
    let place = site.range(site.at);
    let number = site.slice(site.at + 1);
    let diagnostic = Diagnostic::new(E0110, place, format!("a weight is written `weight {number}`, without a comma"));
    let space = if site.range(site.at + 1).start == place.end { " weight " } else { " weight" };
    Some(diagnostic.fix(Applicability::Safe, format!("write `weight {number}`"), place, space))
}

/// `(1, 0, 2)`, or the same without parentheses: a vector without its name.
pub fn vector(site: &Site<'_>) -> Option<Finding> {
    if site.found() != Some(Kind::Comma) {
        return None;
    }
    let open = site.innermost_open();
    let assigned = site.kinds[..site.at].iter().rposition(|k| matches!(k, Kind::Arrow | Kind::ArrowSign));
    let first = open.or(assigned)? + 1;
    let is_call =
        open.and_then(|open| site.kind(open.checked_sub(1)?)).is_some_and(|k| k == Kind::Ident || is_constructor(k));
    if is_call || open.is_some_and(|open| site.kind(open) != Some(Kind::LParen)) {
        return None;
    }
    let (components, end) = components(site, first);
    // `1,5` is a number of other countries.
    let decimal = components == 2 && site.range(site.at).end == site.range(site.at + 1).start;
    let numbers = site.before() == Some(Kind::Number) && site.kind(site.at + 1) == Some(Kind::Number);
    if decimal && numbers || open.is_none() && components != 3 {
        return None;
    }
    let Some(open) = open else {
        let place = site.range(first).cover(site.range(end - 1));
        let written = format!("vec3({})", &site.text[place.bytes()]);
        let title = format!("write {}", quote(&written));
        let diagnostic = Diagnostic::new(E0110, place, "a vector is written `vec3(x, y, z)`");
        return Some(diagnostic.fix(Applicability::Safe, title, place, written));
    };
    let diagnostic = Diagnostic::new(E0110, site.range(open), "a vector is written `vec3(x, y, z)`");
    Some(match components {
        3 => {
            let whole = site.range(open).cover(site.range(end.min(site.kinds.len() - 1)));
            let title = format!("write {}", quote(&format!("vec3{}", &site.text[whole.bytes()])));
            diagnostic.fix(Applicability::Unsafe, title, site.range(open), "vec3(")
        }
        _ => diagnostic.note(format!("a vector has three components, but here there are {components}")),
    })
}

/// How many values stand between commas from a token on, and where their list ends.
fn components(site: &Site<'_>, first: usize) -> (usize, usize) {
    let (mut depth, mut components) = (0, 1);
    for at in first..site.kinds.len() {
        match site.kinds[at] {
            Kind::LParen | Kind::LBracket => depth += 1,
            Kind::RParen | Kind::RBracket if depth == 0 => return (components, at),
            Kind::RParen | Kind::RBracket => depth -= 1,
            Kind::Comma if depth == 0 => components += 1,
            _ => {}
        }
    }
    (components, site.kinds.len())
}

/// `a.x < 5 and > 2`: a comparison that has its left side in another.
pub fn shared_side(site: &Site<'_>) -> Option<Finding> {
    let is_comparison = |kind| matches!(kind, Some(Kind::Eq | Kind::Ne | Kind::Lt | Kind::Le | Kind::Gt | Kind::Ge));
    let joined = matches!(site.before(), Some(Kind::And | Kind::Or));
    if !site.wanted.has(Wanted::VALUE) || !joined || !is_comparison(site.found()) {
        return None;
    }
    let (mut depth, mut operator, mut start) = (0, None, site.at - 1);
    while start > site.head {
        match site.kinds[start - 1] {
            Kind::RParen | Kind::RBracket => depth += 1,
            Kind::LParen | Kind::LBracket if depth == 0 => break,
            Kind::LParen | Kind::LBracket => depth -= 1,
            kind if depth == 0 && is_comparison(Some(kind)) => operator = Some(start - 1),
            Kind::Assert | Kind::Prefer | Kind::Colon | Kind::Define | Kind::Implies | Kind::Not if depth == 0 => break,
            Kind::And | Kind::Or if depth == 0 => break,
            _ => {}
        }
        start -= 1;
    }
    let left = site.range(start).cover(site.range(operator?.checked_sub(1).filter(|end| *end >= start)?));
    let (sign, place) = (site.quoted(site.at), site.range(site.at));
    let left = &site.text[left.bytes()];
    let diagnostic = Diagnostic::new(E0112, place, format!("the left side of {sign} is missing"));
    let title = format!("write {}", quote(&format!("{left} {}", site.slice(site.at))));
    Some(diagnostic.fix(Applicability::Unsafe, title, TextRange::empty(place.start), format!("{left} ")))
}

/// `forall c in chair facing(c, table)`: a set that no `:` follows, but the condition, or a word of English before it.
pub fn no_colon(site: &Site<'_>) -> Option<Finding> {
    if !site.wanted.has(Wanted::COLON) || site.found() != Some(Kind::Ident) || !site.before().is_some_and(ends_value) {
        return None;
    }
    let (word, next) = (site.slice(site.at), site.kind(site.at + 1)?);
    let place = site.range(site.at);
    let message = format!("expected `:` before the condition, found {}", site.name_of(site.at));
    let diagnostic = Diagnostic::new(E0110, place, message).note("as in `forall c in chair: …`");
    let filler = ["with", "then", "do", "such", "holds", "has", "have", "it", "that", "st"];
    let followed = matches!(next, Kind::Ident | Kind::Not | Kind::Number | Kind::Forall | Kind::Exists | Kind::Count);
    if filler.contains(&word) && (followed || is_constructor(next)) {
        // `with` in the place of `where` has its `:` further on.
        let later = site.kinds[site.at..].contains(&Kind::Colon);
        let glued = TextRange { start: site.range(site.at - 1).end, end: place.end };
        return (!later).then(|| diagnostic.fix(Applicability::Unsafe, "write `:`", glued, ":"));
    }
    matches!(next, Kind::LParen | Kind::Dot)
        .then(|| diagnostic.fix(Applicability::Unsafe, "insert `:`", site.behind(site.at - 1), ":"))
}
