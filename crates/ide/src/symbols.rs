//! The outline of a file, and names to search for.

use crate::Snapshot;
use crate::names::declared_kind;
use scenelang_base::{FileId, TextRange};
use scenelang_lang::ast::StmtKind;
use scenelang_lang::db::Cancelled;
use scenelang_lang::items::{ItemKind, Located};
use scenelang_lang::parse::parse_file;

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    Object,
    /// An array of objects.
    Array,
    Region,
    Variable,
    Predicate,
    /// An assertion or a preference.
    Constraint,
}

/// A declaration or a constraint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// How it is called; a constraint by its text.
    pub name: String,
    pub sort: Sort,
    /// Its whole statement.
    pub range: TextRange,
    /// Its name, or the statement.
    pub name_range: TextRange,
    /// More about it: a type, the number of elements, parameters.
    pub detail: String,
}

/// Longer texts of constraints are cut (characters).
const LONGEST: usize = 60;

/// Declarations and constraints of a file, in order.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn outline(snapshot: &Snapshot, file: FileId) -> Result<Vec<Entry>, Cancelled> {
    let text = snapshot.sources().get(file).text();
    let meanings = snapshot.analysis().meanings(file)?;
    Ok(meanings.statements.iter().filter_map(|(place, _)| entry(place, text, true)).collect())
}

/// Declarations of a text by itself.
pub fn declarations(text: &str) -> Vec<Entry> {
    let parsed = parse_file(text);
    let places = parsed.statements.iter().map(|(offset, stmt)| Located { file: None, offset: *offset, stmt });
    places.filter_map(|place| entry(&place, text, false)).collect()
}

fn entry(place: &Located<'_>, text: &str, constraints: bool) -> Option<Entry> {
    let stmt = place.stmt;
    let range = stmt.range.shifted(place.offset);
    let slice = |r: TextRange| text.get(r.shifted(place.offset).bytes()).unwrap_or_default();
    match &stmt.kind {
        StmtKind::Declare { name, .. } if !name.text.is_empty() => {
            let (_, kind) = declared_kind(place)?;
            let (sort, detail) = match kind {
                ItemKind::Object => (Sort::Object, String::new()),
                ItemKind::Array(n) => (Sort::Array, format!("[{n}]")),
                ItemKind::Region => (Sort::Region, String::new()),
                ItemKind::Variable(ty) => (Sort::Variable, ty.name().to_owned()),
            };
            let name_range = name.range.shifted(place.offset);
            Some(Entry { name: name.text.to_string(), sort, range, name_range, detail })
        }
        StmtKind::Predicate { name, params, .. } if !name.text.is_empty() => {
            let params: Vec<&str> = params.iter().map(|p| p.name.text.as_str()).collect();
            let detail = format!("({})", params.join(", "));
            let name_range = name.range.shifted(place.offset);
            Some(Entry { name: name.text.to_string(), sort: Sort::Predicate, range, name_range, detail })
        }
        StmtKind::Assert { .. } | StmtKind::Prefer { .. } if constraints => {
            let words: Vec<&str> = slice(stmt.range).split_whitespace().collect();
            let whole = words.join(" ");
            let name = if whole.chars().count() > LONGEST {
                whole.chars().take(LONGEST - 1).chain(['…']).collect()
            } else {
                whole
            };
            let detail = stmt.requirements.iter().map(|(r, _)| r.as_str()).collect::<Vec<_>>().join("; ");
            Some(Entry { name, sort: Sort::Constraint, range, name_range: range, detail })
        }
        _ => None,
    }
}

/// Whether the letters of a query stand in a name in their order, case apart.
pub fn matches(query: &str, name: &str) -> bool {
    let mut rest = name.chars().flat_map(char::to_lowercase);
    query.chars().flat_map(char::to_lowercase).all(|wanted| rest.any(|c| c == wanted))
}
