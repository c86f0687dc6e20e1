//! Where a value is complete and what follows does not go on from it.

use super::super::lexical::unit_meant;
use super::super::wanted::Wanted;
use super::super::words::is_constructor;
use super::{After, Finding, Site};
use crate::library;
use crate::natives::BuiltIn;
use crate::token::{Kind, UNITS};
use scenelang_base::codes::{E0110, E0112, E0116};
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, TextRange};

/// Words of other languages, and ours.
const SYNONYMS: &[(&str, &str)] = &[
    ("is", "="),
    ("equals", "="),
    ("eq", "="),
    ("isnt", "!="),
    ("then", "implies"),
    ("xor", "!="),
    ("times", "*"),
    ("plus", "+"),
    ("minus", "-"),
    ("but", "and"),
    ("with", "where"),
];

/// Whether a value stands complete before the place.
fn complete(site: &Site<'_>) -> bool {
    site.wanted.has(Wanted::OPERATOR) || site.wanted.has(Wanted::CONNECTIVE)
}

/// A comma outside any list.
pub fn comma(site: &Site<'_>) -> Option<Finding> {
    if site.found() != Some(Kind::Comma) || !complete(site) {
        return None;
    }
    let place = site.range(site.at);
    let (before, after) = (site.kind(site.at - 1), site.kind(site.at + 1));
    let touching = site.ranges.get(site.at + 1).is_some_and(|next| next.start == place.end);
    if (before, after, touching) == (Some(Kind::Number), Some(Kind::Number), true) {
        let message = "the decimal separator is `.`, not a comma";
        return Some(Diagnostic::new(E0110, place, message).fix(Applicability::Unsafe, "write `.`", place, "."));
    }
    if site.innermost_open().is_some() {
        return None;
    }
    if after.is_none() {
        let diagnostic = Diagnostic::new(E0110, place, "a statement ends with `;`, not with a comma");
        return Some(match site.after {
            After::Semicolon(_) => diagnostic.fix(Applicability::Safe, "remove it", place, ""),
            _ => diagnostic.fix(Applicability::Safe, "write `;`", place, ";"),
        });
    }
    let diagnostic = Diagnostic::new(E0110, place, "conditions are joined with `and`, not with a comma");
    Some(diagnostic.fix(Applicability::Unsafe, "write `and`", place, " and"))
}

/// `adn`, `AND`, `then`: a word in the place of an operator.
pub fn misspelt(site: &Site<'_>) -> Option<Finding> {
    if !complete(site) || site.found() != Some(Kind::Ident) {
        return None;
    }
    let word = site.slice(site.at);
    let next = site.kind(site.at + 1);
    let is_function = library::names().any(|name| name == word) || BuiltIn::named(word).is_some();
    if is_function && next != Some(Kind::LParen) {
        let operands = site.before() == Some(Kind::Ident) && next == Some(Kind::Ident);
        let (before, after) = (site.slice(site.at - 1), site.slice(site.at + 1));
        let more = library::predicate_head(word).is_some_and(|head| head.params.len() > 2);
        let rest = if more { ", …" } else { "" };
        let message = match operands {
            true => format!("`{word}` is not an operator; write `{word}({before}, {after}{rest})`"),
            false => format!("`{word}` is not an operator; write its arguments in parentheses after it"),
        };
        return Some(Diagnostic::new(E0116, site.range(site.at), message));
    }
    let synonym = SYNONYMS.iter().find(|(other, _)| other.eq_ignore_ascii_case(word)).map(|(_, ours)| *ours);
    // A lone word behind a value is more likely a second name than an operator.
    next.filter(|k| !matches!(k, Kind::RParen | Kind::RBracket | Kind::Comma | Kind::Dot))?;
    let ours = ["and", "or", "implies", "where", "weight"];
    let other_case = ours.into_iter().find(|operator| operator.eq_ignore_ascii_case(word));
    let near = synonym.or(other_case).or_else(|| nearest(word, ours))?;
    let place = site.range(site.at);
    let diagnostic = Diagnostic::new(E0116, place, format!("unknown word {}", site.quoted(site.at)));
    let diagnostic = diagnostic.label(format!("did you mean `{near}`?"));
    // `AND` can mean nothing else.
    let applicability = if Some(near) == other_case { Applicability::Safe } else { Applicability::Unsafe };
    Some(diagnostic.fix(applicability, format!("write `{near}`"), place, near))
}

/// `5 cm`: a unit apart from its number.
pub fn unit(site: &Site<'_>) -> Option<Finding> {
    let written = site.slice(site.at);
    if site.before() != Some(Kind::Number) || !complete(site) {
        return None;
    }
    let unit = UNITS.into_iter().find(|unit| *unit == written).or_else(|| unit_meant(written))?;
    let number = site.range(site.at - 1);
    let place = number.cover(site.range(site.at));
    let message = match unit == written {
        true => "there must be no space between a number and its unit".to_owned(),
        false => format!("the unit {} is written `{unit}`, directly after the number", site.quoted(site.at)),
    };
    let diagnostic = Diagnostic::new(E0110, site.range(site.at), message);
    let joined = format!("{}{unit}", site.slice(site.at - 1));
    let title = format!("write {}", super::quote(&joined));
    Some(diagnostic.fix(Applicability::Safe, title, place, joined))
}

/// Signs and words that belong elsewhere.
pub fn foreign_use(site: &Site<'_>) -> Option<Finding> {
    if !complete(site) {
        return None;
    }
    let place = site.range(site.at);
    match site.found()? {
        Kind::Define => {
            let diagnostic = Diagnostic::new(E0110, place, "`:=` defines a predicate; to compare, write `=`");
            Some(diagnostic.fix(Applicability::Unsafe, "write `=`", place, "="))
        }
        Kind::Arrow | Kind::ArrowSign => {
            let message = format!("{} is allowed only after the target of an assignment", site.quoted(site.at));
            Some(Diagnostic::new(E0110, place, message).note("to compare, write `=`"))
        }
        Kind::Weight => {
            let diagnostic = Diagnostic::new(E0110, place, "only `prefer` can have a `weight`");
            let keyword = site.range(site.head);
            Some(match site.kind(site.head) {
                Some(Kind::Assert) => diagnostic
                    .related(keyword, "assertions are hard constraints and have no weight")
                    .fix(Applicability::Unsafe, "make it a preference", keyword, "prefer"),
                _ => diagnostic,
            })
        }
        Kind::LParen if site.before() == Some(Kind::Ident) && site.kind(site.at.checked_sub(2)?) == Some(Kind::Dot) => {
            let message = format!("{} cannot be called with a dot", site.quoted(site.at - 1));
            let note = "predicates and functions are called by their name alone: `near(a, b, 1)`";
            Some(Diagnostic::new(E0110, site.range(site.at - 1), message).note(note))
        }
        Kind::LParen => {
            let diagnostic = Diagnostic::new(E0110, place, "an operator is missing before `(`");
            Some(diagnostic.note("a product is written with `*`"))
        }
        Kind::Colon if site.innermost_open().is_none() && !site.wanted.has(Wanted::COLON) => Some(
            Diagnostic::new(E0110, place, "`:` is allowed only after the set of a quantifier")
                .note("as in `forall c in chair: …`"),
        ),
        _ => None,
    }
}

/// `forall a, b in S`, `forall a in S, b in S`: one variable each.
pub fn pairs(site: &Site<'_>) -> Option<Finding> {
    if site.found() != Some(Kind::Comma) {
        return None;
    }
    let begins = |at: usize| matches!(site.kind(at), Some(Kind::Forall | Kind::Exists));
    let quantifier = (0..site.at).rev().find(|at| begins(*at))?;
    let names = site.kind(quantifier + 1) == Some(Kind::Ident) && site.kind(site.at + 1) == Some(Kind::Ident);
    let listed = site.at == quantifier + 2;
    let again = site.slice(quantifier + 2) == "in" && site.slice(site.at + 2) == "in";
    let colon = (quantifier..site.at).any(|at| site.kind(at) == Some(Kind::Colon));
    if !names || colon || !(listed || again) {
        return None;
    }
    let message = format!("{} has one variable", site.quoted(quantifier));
    let (a, b) = (site.slice(quantifier + 1), site.slice(site.at + 1));
    let note = format!("for pairs, write `forall {a} in chair: forall {b} in chair: {a} != {b} implies …`");
    Some(Diagnostic::new(E0110, site.range(site.at), message).note(note))
}

/// `count(c in S where φ)`: a set, and nothing that is counted in it.
fn narrowed(site: &Site<'_>) -> Option<Finding> {
    let open = site.innermost_open().filter(|_| site.found() == Some(Kind::RParen))?;
    let at = (open..site.at).rev().find(|at| site.kind(*at) == Some(Kind::Where))?;
    let counts = site.kind(open.checked_sub(1)?) == Some(Kind::Count);
    let place = TextRange::new(site.behind(at - 1).start as usize, site.range(at).end as usize);
    let message = "`count` has a set, but no condition";
    let note =
        "`where` makes the set smaller; what is counted stands after `:`, as in `count(c in chair: c.pos.x > 1)`";
    let diagnostic = Diagnostic::new(E0110, site.range(at), message).note(note);
    counts.then(|| diagnostic.fix(Applicability::Unsafe, "write `:`", place, ":"))
}

/// `forall x S`, `forall x in S …`
pub fn quantifier(site: &Site<'_>) -> Option<Finding> {
    let place = site.range(site.at);
    let behind = site.behind(site.at.checked_sub(1)?);
    if site.wanted.has(Wanted::IN) && site.slice(site.at - 1) == "in" {
        let diagnostic = Diagnostic::new(E0112, site.range(site.at - 1), "the quantifier has no variable");
        let place = TextRange::empty(site.range(site.at - 1).start);
        let diagnostic = diagnostic.note("as in `forall c in chair: …`");
        return Some(diagnostic.fix(Applicability::Unsafe, "insert a variable", place, "x "));
    }
    if site.wanted.has(Wanted::IN) {
        let message =
            format!("expected `in` and a set after {}, found {}", site.quoted(site.at - 1), site.name_of(site.at));
        let diagnostic = Diagnostic::new(E0110, place, message).note("as in `forall c in chair: …`");
        return Some(match site.found() {
            Some(Kind::Ident | Kind::Objects | Kind::Number) => {
                diagnostic.fix(Applicability::Unsafe, "insert `in`", behind, " in")
            }
            _ => diagnostic,
        });
    }
    if !site.wanted.has(Wanted::COLON) || site.found().is_some_and(|k| !begins_value(k) && k != Kind::RParen) {
        return None;
    }
    if let Some(finding) = narrowed(site) {
        return Some(finding);
    }
    let message = format!("expected `:` and a condition after the set, found {}", site.name_of(site.at));
    let diagnostic = Diagnostic::new(E0110, place, message).note("as in `forall c in chair: …`");
    Some(match site.found() {
        Some(found) if begins_value(found) => diagnostic.fix(Applicability::Unsafe, "insert `:`", behind, ":"),
        _ => diagnostic,
    })
}

/// Two arguments without a comma between them.
pub fn argument(site: &Site<'_>) -> Option<Finding> {
    let found = site.found().filter(|k| begins_value(*k))?;
    if !site.wanted.has(Wanted::COMMA) || found == Kind::LParen {
        return None;
    }
    let open = site.innermost_open()?;
    let behind = site.behind(site.at - 1);
    let message = format!("a comma is missing before {}", site.name_of(site.at));
    let diagnostic =
        Diagnostic::new(E0110, site.range(site.at), message).related(site.range(open), "in the list that opens here");
    Some(diagnostic.fix(Applicability::Safe, "insert `,`", behind, ","))
}

/// Two values side by side.
pub fn juxtaposed(site: &Site<'_>) -> Option<Finding> {
    let found = site.found().filter(|k| begins_value(*k))?;
    if !complete(site) || site.innermost_open().is_some() {
        return None;
    }
    let name = site.name_of(site.at);
    let before = site.quoted(site.at - 1);
    let message = format!("an operator or `;` is missing between {before} and {name}");
    let diagnostic = Diagnostic::new(E0110, site.range(site.at), message);
    Some(match found {
        Kind::Not if site.kind(site.at + 1) == Some(Kind::Inside) => {
            diagnostic.note("as in `a > 1 and not inside(a, r)`")
        }
        _ => diagnostic,
    })
}

/// Whether a value can begin with this token.
fn begins_value(kind: Kind) -> bool {
    use Kind::*;
    matches!(kind, Ident | Number | Str | True | False | Objects | Count | Not | Forall | Exists | LParen)
        || is_constructor(kind)
}
