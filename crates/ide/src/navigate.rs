//! From a name to where it comes from, and to wherever else it stands.

use crate::Snapshot;
use crate::names::{self, Occurrence, Role, Symbol};
use scenelang_base::{FileId, Span, TextRange};
use scenelang_lang::ast::{ExprKind, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::items::ItemKind;
use scenelang_lang::library;
use scenelang_lang::sources::normal;
use scenelang_lang::types::Ty;
use std::path::Path;

/// A place to go to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NavigationTarget {
    /// In a file of the program: the name, and all of its statement.
    File(Span, TextRange),
    /// In a file of the standard library (an index into [`library::FILES`]): the name, and all of its statement.
    Library(usize, TextRange, TextRange),
}

/// Where what is named at an offset of the main file is defined: a variable where it is given its value, a predicate of the
/// library in the library, an import in the file that it reads. With the name or path itself.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn definition(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled> {
    if let Some(found) = import_at(snapshot, offset)? {
        return Ok(Some(found));
    }
    let Some(name) = names::name_at(snapshot, snapshot.main(), offset)? else { return Ok(None) };
    if let Symbol::Item(item, ItemKind::Variable(_)) = &name.symbol
        && let Some(target) = assignment_of(snapshot, item, None)?
    {
        return Ok(Some((name.range, target)));
    }
    Ok(declared(snapshot, &name)?.map(|target| (name.range, target)))
}

/// Where what is named at an offset of the main file is declared.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn declaration(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled> {
    if let Some(found) = import_at(snapshot, offset)? {
        return Ok(Some(found));
    }
    let Some(name) = names::name_at(snapshot, snapshot.main(), offset)? else { return Ok(None) };
    Ok(declared(snapshot, &name)?.map(|target| (name.range, target)))
}

/// Where it is said what kind of thing is named at an offset: of an object the assignment of its category, of the variable
/// of a quantifier the set that it goes through.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn type_definition(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled> {
    let Some(name) = names::name_at(snapshot, snapshot.main(), offset)? else { return Ok(None) };
    let target = match &name.symbol {
        Symbol::Item(item, ItemKind::Object | ItemKind::Array(_)) => assignment_of(snapshot, item, Some("category"))?,
        Symbol::Local { statement, index, .. } => domain_of(snapshot, *statement, *index)?,
        _ => None,
    };
    Ok(target.map(|target| (name.range, target)))
}

/// Where something is named, in all files of the program, in their order; with its declaration or without.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn references(
    snapshot: &Snapshot,
    file: FileId,
    symbol: &Symbol,
    declaration: bool,
) -> Result<Vec<(Span, Role)>, Cancelled> {
    let mut out = Vec::new();
    for (id, _) in snapshot.sources().iter() {
        // Names that are bound in a statement are known in its file only.
        if matches!(symbol, Symbol::Local { .. }) && id != file || snapshot.layout().is_some_and(|l| l.file == id) {
            continue;
        }
        let all = names::occurrences(snapshot, id)?;
        let same = |o: &&Occurrence| o.symbol.is(symbol) && (declaration || o.role != Role::Declares);
        out.extend(all.iter().filter(same).map(|o| (o.range.in_file(id), o.role)));
    }
    Ok(out)
}

/// Where what is named at an offset stands in the main file.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn highlights(snapshot: &Snapshot, offset: u32) -> Result<Vec<(TextRange, Role)>, Cancelled> {
    let all = names::occurrences(snapshot, snapshot.main())?;
    let Some(name) = names::at(&all, offset) else { return Ok(Vec::new()) };
    Ok(all.iter().filter(|o| o.symbol.is(&name.symbol)).map(|o| (o.range, o.role)).collect())
}

/// The place where a name is declared, defined or bound.
pub(crate) fn declared(snapshot: &Snapshot, name: &Occurrence) -> Result<Option<NavigationTarget>, Cancelled> {
    let meanings = snapshot.meanings()?;
    let span = match &name.symbol {
        Symbol::Item(item, _) => meanings.declared.get(item).copied(),
        Symbol::Predicate(predicate) => meanings.defined.get(predicate).copied(),
        Symbol::Local { statement, index, .. } => {
            let found = meanings.statements.iter().find(|(place, _)| place.offset == *statement);
            found.and_then(|(place, hir)| place.span(hir.locals.get(*index)?.range))
        }
        Symbol::Library(predicate) => return Ok(in_library(predicate)),
        _ => None,
    };
    Ok(match span {
        Some(span) => Some(NavigationTarget::File(span, statement_around(snapshot, span)?)),
        None => None,
    })
}

/// The statement that holds a place.
fn statement_around(snapshot: &Snapshot, span: Span) -> Result<TextRange, Cancelled> {
    let meanings = snapshot.analysis().meanings(span.file)?;
    let whole = meanings.statements.iter().map(|(place, _)| place.stmt.range.shifted(place.offset));
    let holds = |r: &TextRange| r.start <= span.range.start && span.range.end <= r.end;
    Ok(whole.into_iter().find(holds).unwrap_or(span.range))
}

/// The definition of a predicate of the library.
fn in_library(name: &str) -> Option<NavigationTarget> {
    library::parsed().iter().enumerate().find_map(|(file, parsed)| {
        parsed.statements.iter().find_map(|(offset, stmt)| match &stmt.kind {
            StmtKind::Predicate { name: own, .. } if own.text == name => {
                Some(NavigationTarget::Library(file, own.range.shifted(*offset), stmt.range.shifted(*offset)))
            }
            _ => None,
        })
    })
}

/// The statement that assigns a variable, or a property of a thing.
fn assignment_of(
    snapshot: &Snapshot,
    item: &str,
    property: Option<&str>,
) -> Result<Option<NavigationTarget>, Cancelled> {
    for (id, _) in snapshot.sources().iter() {
        for (place, _) in &snapshot.analysis().meanings(id)?.statements {
            let StmtKind::Assign { name, path, target, .. } = &place.stmt.kind else { continue };
            let assigned = path.first().map(|p| p.text.as_str());
            if name.text == item
                && assigned == property
                && let Some(span) = place.span(*target)
            {
                return Ok(Some(NavigationTarget::File(span, place.stmt.range.shifted(place.offset))));
            }
        }
    }
    Ok(None)
}

/// What the variable of a quantifier goes through.
fn domain_of(snapshot: &Snapshot, statement: u32, index: usize) -> Result<Option<NavigationTarget>, Cancelled> {
    let meanings = snapshot.meanings()?;
    let Some((place, hir)) = meanings.statements.iter().find(|(place, _)| place.offset == statement) else {
        return Ok(None);
    };
    let Some(local) = hir.locals.get(index) else { return Ok(None) };
    let domain = place.stmt.exprs.iter().find_map(|expr| match &expr.kind {
        ExprKind::Quantified(_, name, domain, _) if name.range == local.range => Some(*domain),
        _ => None,
    });
    let Some(domain) = domain else { return Ok(None) };
    if let ExprKind::Name(name) = &place.stmt.expr(domain).kind
        && let Some(span) = meanings.declared.get(name)
    {
        return Ok(Some(NavigationTarget::File(*span, statement_around(snapshot, *span)?)));
    }
    let whole = place.span(place.stmt.expr(domain).range);
    Ok(whole.map(|span| NavigationTarget::File(span, place.stmt.range.shifted(place.offset))))
}

/// The import at an offset: its path with the quotation marks, and the file.
fn import_at(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled> {
    let found = imports(snapshot)?.into_iter().find(|(range, _)| range.start <= offset && offset <= range.end);
    Ok(found
        .map(|(range, file)| (range, NavigationTarget::File(TextRange::empty(0).in_file(file), TextRange::empty(0)))))
}

/// The imports of the main file that could be read: paths with their quotation marks, and files.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn imports(snapshot: &Snapshot) -> Result<Vec<(TextRange, FileId)>, Cancelled> {
    let main = snapshot.sources().get(snapshot.main()).path();
    let folder = normal(main).parent().map(Path::to_path_buf).unwrap_or_default();
    let meanings = snapshot.meanings()?;
    let read = meanings.statements.iter().filter_map(|(place, _)| {
        let StmtKind::Import { path, range } = &place.stmt.kind else { return None };
        let wanted = normal(&folder.join(path));
        let (file, _) = snapshot.sources().iter().find(|(_, file)| normal(file.path()) == wanted)?;
        Some((range.shifted(place.offset), file))
    });
    Ok(read.collect())
}

/// What is written in a hover for a type.
pub(crate) fn word_of(ty: Ty) -> &'static str {
    match ty {
        Ty::Object => "object",
        Ty::Region => "region",
        other => other.name(),
    }
}
