//! What can be done at a place: fixes of what is marked there, and changes of form that keep the meaning.
//!
//! | file | what it offers |
//! |---|---|
//! | `fixes` | fixes that diagnostics carry, a missing declaration, a comment that silences, the smallest move |
//! | `predicates` | a formula becomes a predicate, a call becomes what it stands for |
//! | `rewrite` | a conjunction becomes several assertions, similar objects an array, a place in the layout an assignment |

mod fixes;
mod predicates;
mod rewrite;

use crate::Snapshot;
use crate::diagnostics::{Finding, diagnostics};
use scenelang_base::{Applicability, Edit, Span, TextRange};
use scenelang_lang::db::Cancelled;

pub use fixes::{all_safe, changing, placing, sentence};
use scenelang_layout::Vec3;

/// What kind of change it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActionKind {
    /// Repairs what is marked.
    Fix,
    /// Makes something of a part.
    Extract,
    /// Puts something in its place.
    Inline,
    /// Says the same in another way.
    Rewrite,
}

/// Something that can be done.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// In the imperative.
    pub title: String,
    /// What kind of change it is.
    pub kind: ActionKind,
    /// What is replaced, in the program's files and the layout; of [`Detail::Titles`] nothing where it is much.
    pub edits: Vec<Edit>,
    pub repairs: Option<Finding>,
    /// Whether it is what one would do.
    pub preferred: bool,
    /// Where objects are afterwards, if it moves any.
    pub moves: Vec<Ghost>,
}

/// Where an object would be.
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// Its name.
    pub object: String,
    /// Its position.
    pub pos: Vec3,
    /// Its rotation.
    pub rot: Vec3,
}

impl Action {
    fn new(title: impl Into<String>, kind: ActionKind, edits: Vec<Edit>) -> Self {
        Self { title: title.into(), kind, edits, repairs: None, preferred: false, moves: Vec::new() }
    }
}

/// How much is said of actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// What there is; edits only where they are few.
    Titles,
    /// All edits.
    Edits,
}

/// What can be done in a range of the main file.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn actions(snapshot: &Snapshot, range: TextRange, detail: Detail) -> Result<Vec<Action>, Cancelled> {
    let mut out = Vec::new();
    for finding in diagnostics(snapshot)? {
        let place = finding.diagnostic.primary.as_ref().map(|label| label.place);
        if place.is_some_and(|place| touches(place, snapshot, range)) {
            fixes::of_finding(snapshot, &finding, &mut out)?;
        }
    }
    predicates::extract(snapshot, range, &mut out)?;
    predicates::inline(snapshot, range, &mut out)?;
    rewrite::split(snapshot, range, &mut out)?;
    rewrite::array(snapshot, range, detail, &mut out)?;
    rewrite::pin(snapshot, range, &mut out)?;
    Ok(out)
}

/// Constraints that fail in a range of the main file: what can be repaired there.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn failing(snapshot: &Snapshot, range: TextRange) -> Result<Vec<Finding>, Cancelled> {
    let mut found = diagnostics(snapshot)?;
    found.retain(|f| {
        let place = f.diagnostic.primary.as_ref().map(|label| label.place);
        f.row.is_some() && place.is_some_and(|place| touches(place, snapshot, range))
    });
    Ok(found)
}

fn touches(place: Span, snapshot: &Snapshot, range: TextRange) -> bool {
    place.file == snapshot.main() && place.range.start <= range.end && range.start <= place.range.end
}

fn is_safe(applicability: Applicability) -> bool {
    applicability == Applicability::Safe
}

/// The blanks that a line begins with.
fn indent(text: &str, at: u32) -> &str {
    let start = text[..at as usize].rfind(['\n', '\r']).map_or(0, |i| i + 1);
    let line = &text[start..];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

/// Where the line of an offset begins.
fn line_start(text: &str, at: u32) -> u32 {
    text[..at as usize].rfind(['\n', '\r']).map_or(0, |i| i as u32 + 1)
}

/// Where the line of an offset ends, without what ends it.
fn line_end(text: &str, at: u32) -> u32 {
    text[at as usize..].find(['\n', '\r']).map_or(text.len() as u32, |i| at + i as u32)
}
