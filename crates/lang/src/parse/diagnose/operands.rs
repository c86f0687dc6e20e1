//! Where a value is wanted and none stands.

use super::super::wanted::Wanted;
use super::super::words::{ends_value, is_constructor, is_word};
use super::{Finding, Site};
use crate::token::Kind;
use scenelang_base::codes::{E0110, E0112, E0116};
use scenelang_base::{Applicability, Diagnostic};

/// Nothing, or no name, after a dot.
pub fn property(site: &Site<'_>) -> Option<Finding> {
    if !site.wanted.has(Wanted::PROPERTY) {
        return None;
    }
    let dot = site.at - 1;
    let message = match site.found() {
        None => "the name of a property is missing after `.`".to_owned(),
        Some(_) => format!("expected the name of a property after `.`, found {}", site.name_of(site.at)),
    };
    let place = if site.found().is_none() { site.range(dot) } else { site.range(site.at) };
    Some(Diagnostic::new(E0112, place, message).note("properties are `pos`, `rot`, `scale`, `color`, `top`, …"))
}

/// `+1`: there is a unary minus, but no plus.
pub fn number_like(site: &Site<'_>) -> Option<Finding> {
    if !site.wanted.has(Wanted::VALUE) || site.found() != Some(Kind::Plus) {
        return None;
    }
    if !site.kind(site.at + 1).is_some_and(|k| matches!(k, Kind::Number | Kind::Ident | Kind::LParen)) {
        return None;
    }
    let place = site.range(site.at);
    let diagnostic = Diagnostic::new(E0112, place, "missing value before `+`; there is no unary `+`");
    Some(diagnostic.fix(Applicability::Safe, "remove it", place, ""))
}

/// `a > not b`, `1 + forall …`: conditions inside arithmetic.
pub fn needs_parentheses(site: &Site<'_>) -> Option<Finding> {
    let condition = matches!(site.found(), Some(Kind::Not | Kind::Forall | Kind::Exists));
    if !condition || !site.wanted.has(Wanted::VALUE) || site.wanted.has(Wanted::CONDITION) {
        return None;
    }
    let message = format!("{} after {} needs parentheses", site.quoted(site.at), site.quoted(site.at - 1));
    let diagnostic = Diagnostic::new(E0110, site.range(site.at), message);
    Some(diagnostic.note("comparisons and calculations bind more tightly than `not`, `and`, `or` and quantifiers"))
}

/// `> =` for `>=`.
pub fn split_operator(site: &Site<'_>) -> Option<Finding> {
    let found = site.found()?;
    if found == Kind::Not && site.slice(site.at) == "!" && site.kind(site.at + 1) == Some(Kind::Eq) {
        return Some(blank_inside(site, site.at, "!="));
    }
    if !site.wanted.has(Wanted::VALUE) {
        return None;
    }
    let whole = match (site.before()?, found) {
        (Kind::Gt, Kind::Eq) => ">=",
        (Kind::Lt, Kind::Eq) => "<=",
        (Kind::Eq, Kind::Eq) => "=",
        (Kind::Eq, Kind::Gt) => ">=",
        (Kind::Eq, Kind::Lt) => "<=",
        (Kind::Lt, Kind::Gt) => "!=",
        _ => return None,
    };
    Some(blank_inside(site, site.at - 1, whole))
}

/// Two signs that should be one operator; `first` is the first of them.
fn blank_inside(site: &Site<'_>, first: usize, whole: &str) -> Finding {
    let place = site.range(first).cover(site.range(first + 1));
    let message = format!("there is no operator {}", super::quote(&site.text[place.bytes()]));
    let diagnostic = Diagnostic::new(E0116, place, message).label(format!("write `{whole}`"));
    // `> =` can mean nothing else; `= <` is a guess.
    let written: String = site.text[place.bytes()].split_whitespace().collect();
    let applicability = if written == whole { Applicability::Safe } else { Applicability::Unsafe };
    diagnostic.fix(applicability, format!("write `{whole}`"), place, whole)
}

/// A comma too many in a list of arguments.
pub fn list(site: &Site<'_>) -> Option<Finding> {
    let comma = match (site.before()?, site.found()?) {
        (Kind::Comma, Kind::RParen | Kind::Comma) => site.at - 1,
        (Kind::LParen, Kind::Comma) => site.at,
        _ => return None,
    };
    if !site.wanted.has(Wanted::VALUE) {
        return None;
    }
    let side = if comma == site.at { "before" } else { "after" };
    let diagnostic = Diagnostic::new(E0112, site.range(comma), format!("a value is missing {side} this comma"));
    Some(diagnostic.fix(Applicability::Unsafe, "remove the comma", site.range(comma), ""))
}

/// An operator, keyword or bracket without the value it needs.
pub fn missing(site: &Site<'_>) -> Option<Finding> {
    if !site.wanted.has(Wanted::VALUE) {
        // `rot`, `inside` and the like are no values without their arguments.
        let bare = site.before().is_some_and(is_constructor) && site.wanted.has(Wanted::OPEN_PAREN);
        return bare.then(|| {
            let word = site.slice(site.at - 1);
            let message = format!("`{word}` needs its arguments in parentheses");
            let usage = match word {
                "inside" => "inside(lamp, room)",
                "rand" => "rand(low, high)",
                "vec3" => "vec3(x, y, z)",
                "rot" => "rot(x, y, z)",
                _ => "dot(a, b)",
            };
            Diagnostic::new(E0112, site.range(site.at - 1), message).note(format!("write `{usage}`"))
        });
    }
    let what = if site.wanted.has(Wanted::CONDITION) { "a condition" } else { "a value" };
    let what = match site.before() {
        Some(Kind::Arrow | Kind::ArrowSign | Kind::Weight | Kind::LBracket | Kind::LParen | Kind::Comma | Kind::In) => {
            "a value"
        }
        _ => what,
    };
    let found = site.found();
    let word = site.slice(site.at);
    let infix = matches!(found, Some(Kind::And | Kind::Or | Kind::Implies | Kind::Where));
    if found.is_some() && is_word(word) && !infix {
        let message = format!("expected {what}, found {}", site.name_of(site.at));
        let diagnostic = Diagnostic::new(E0112, site.range(site.at), message);
        let reserved = found.is_some_and(super::super::words::starts_statement);
        return Some(if reserved { diagnostic.note(format!("`{word}` is a reserved word")) } else { diagnostic });
    }
    let before = site.at.checked_sub(1).filter(|at| *at >= site.head && !ends_value(site.kinds[*at]))?;
    let after = site.quoted(before);
    match found {
        // The operator that lacks its operand is nearer to the mistake than the `;` that shows it.
        None | Some(Kind::RParen | Kind::RBracket | Kind::Comma | Kind::Colon | Kind::Weight) => {
            let diagnostic = Diagnostic::new(E0112, site.range(before), format!("{what} is missing after {after}"));
            Some(diagnostic.label(format!("expected {what} before {}", site.name_of(site.at))))
        }
        // A list, as other languages write a vector.
        Some(Kind::LBracket) if site.kind(site.at + 1) == Some(Kind::Number) => {
            let diagnostic = Diagnostic::new(E0112, site.range(site.at), "a list in brackets is not a value");
            Some(diagnostic.note("a vector is written `vec3(x, y, z)`"))
        }
        Some(_) => {
            let message = format!("{what} is missing between {after} and {}", site.quoted(site.at));
            Some(Diagnostic::new(E0112, site.range(site.at), message))
        }
    }
}
