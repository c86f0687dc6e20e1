//! Warnings: programs that compile and most likely do not say what was meant.
//!
//! What can be told from one statement and the names in it is found by [`statement`]; what takes the whole program by
//! [`program`], from summaries of the statements ([`uses`]) that depend on their texts alone. Both take time in
//! proportion to the program. What is inside a library predicate is never looked at, and a doubt is no finding: a
//! warning that is wrong makes all others worth less.
//!
//! | file | code |
//! |---|---|
//! | `unused` | W0201 never used, W0202 a text never assigned, W0303 no object |
//! | `hiding` | W0203 a name that hides another |
//! | `spelling` | W0204 names and texts spelt almost alike, W0205 unknown categories, W0206 misspelt colors and materials |
//! | `units` | W0207 sizes that are in centimetres or millimetres |
//! | `degrees` | W0301 order of degrees |
//! | `sets` | W0302 empty sets |
//! | `dead` | W0304 what makes no difference |
//! | `outside` | W0305 kept out of a region |
//! | `ends` | W0307 ranges that leave out one element |
//! | `words` | W0306 templates of messages that cannot be used |
//! | `allow` | comments that silence a warning, and W0103 those that do not |
//! | `scope`, `shape`, `uses`, `facts` | what they are made from |

pub mod allow;
mod dead;
mod degrees;
mod ends;
mod facts;
mod hiding;
mod outside;
mod scope;
mod sets;
mod shape;
mod spelling;
mod units;
mod unused;
mod uses;
mod words;

use crate::ast::Stmt;
use crate::check::Where;
use crate::items::{Located, Names};
use facts::{DefinitionNode, Facts};
use scenelang_base::{Code, Diagnostic, codes};
use scope::Scopes;
use smol_str::SmolStr;

use unused::may_hide_uses;
pub use uses::{Uses, uses};

/// The warnings about one statement without errors. They depend on its text and on what `names` says of the names in
/// it, not on where anything stands.
pub fn statement(names: &dyn Names, stmt: &Stmt) -> Vec<Diagnostic<Where>> {
    let scopes = Scopes::of(stmt);
    let mut out = Vec::new();
    hiding::within(&scopes, &mut out);
    degrees::check(names, stmt, &scopes, &mut out);
    sets::ranges(stmt, &scopes, &mut out);
    dead::check(names, stmt, &scopes, &mut out);
    words::check(stmt, &scopes, &mut out);
    out
}

/// A statement as [`program`] takes it.
#[derive(Clone, Copy)]
pub struct Linted<'a> {
    /// The statement and its place, in a file of the user.
    pub place: Located<'a>,
    /// Its summary.
    pub uses: &'a Uses,
    /// Whether it has no errors of its own.
    pub sound: bool,
    /// Whether [`statement`] said that a part of it makes no difference.
    pub dead: bool,
}

impl<'a> Linted<'a> {
    /// A statement with what was found about it alone, types and all.
    pub fn new<'d>(place: Located<'a>, uses: &'a Uses, found: impl Iterator<Item = &'d Diagnostic<Where>>) -> Self {
        let mut linted = Self { place, uses, sound: true, dead: false };
        for d in found {
            linted.sound &= !d.is_error();
            linted.dead |= d.code == codes::W0304;
        }
        linted
    }
}

/// The warnings about a whole program. `statements`: those of the main file first, then of what it imports.
/// `errors`: codes of the errors that were found; what they may have hidden is not held against the rest.
pub fn program(names: &dyn Names, statements: &[Linted<'_>], errors: &[Code]) -> Vec<Diagnostic> {
    let facts = Facts::of(names, statements);
    let mut out = Vec::new();
    if !errors.iter().any(|code| may_hide_uses(*code)) {
        unused::names(&facts, &mut out);
    }
    unused::texts(&facts, &mut out);
    // A definition that is wrong may have been meant to speak of something.
    if errors.is_empty() {
        unused::without_objects(&facts, &mut out);
    }
    hiding::declared(&facts, &mut out);
    spelling::check(&facts, &mut out);
    units::check(&facts, &mut out);
    sets::empty(&facts, &mut out);
    outside::check(&facts, &mut out);
    ends::check(&facts, &mut out);
    let drawing = facts.closure(|s| s.uses.draws);
    dead::repeated(
        statements,
        |predicate| drawing.contains(&DefinitionNode::Predicate(&SmolStr::new(predicate))),
        &mut out,
    );
    out
}
