//! Brackets that do not match: one too many, one of the wrong kind, one that is never closed.

use super::super::wanted::Wanted;
use super::{Finding, Site};
use crate::token::Kind;
use scenelang_base::codes::E0113;
use scenelang_base::{Applicability, Diagnostic};

/// A closing bracket where the grammar stopped that has no matching opening bracket, or something else.
pub fn mixed(site: &Site<'_>) -> Option<Finding> {
    let closer = site.found().filter(|k| matches!(k, Kind::RParen | Kind::RBracket))?;
    let place = site.range(site.at);
    let Some(open) = site.innermost_open() else {
        let message = format!("{} has no matching opening bracket", site.quoted(site.at));
        let diagnostic = Diagnostic::new(E0113, place, message).label("no bracket is open here");
        return Some(diagnostic.fix(Applicability::Unsafe, "remove it", place, ""));
    };
    let right = closing(site.kinds[open]);
    if right.0 == closer {
        return None;
    }
    let message = format!("{} is closed by {}", site.quoted(open), site.quoted(site.at));
    let title = format!("write `{}`", right.1);
    let diagnostic = Diagnostic::new(E0113, place, message)
        .label(format!("expected `{}`", right.1))
        .related(site.range(open), "opened here");
    Some(diagnostic.fix(Applicability::Unsafe, title, place, right.1))
}

/// The statement, or the part of it that a bracket can stand in, ends, and the bracket is still open.
pub fn open(site: &Site<'_>) -> Option<Finding> {
    let past = matches!(site.found(), None | Some(Kind::Define | Kind::Arrow | Kind::ArrowSign | Kind::Weight));
    let ended = past && !site.wanted.has(Wanted::VALUE);
    let open = site.innermost_open().filter(|_| ended)?;
    let (kind, sign) = closing(site.kinds[open]);
    let closes = if kind == Kind::RParen { Wanted::CLOSE_PAREN } else { Wanted::CLOSE_BRACKET };
    if !site.wanted.has(closes) {
        return None;
    }
    let place = site.behind(site.at - 1);
    let diagnostic = Diagnostic::new(E0113, place, format!("{} is never closed", site.quoted(open)))
        .label(format!("expected `{sign}` here or earlier"))
        .related(site.range(open), "opened here");
    Some(diagnostic.fix(Applicability::Unsafe, format!("insert `{sign}`"), place, sign))
}

fn closing(open: Kind) -> (Kind, &'static str) {
    match open {
        Kind::LBracket => (Kind::RBracket, "]"),
        _ => (Kind::RParen, ")"),
    }
}
