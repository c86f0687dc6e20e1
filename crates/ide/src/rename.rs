//! Another name for something, wherever it is named: in the program, what it imports, and its layout.

use crate::Snapshot;
use crate::names::{self, Symbol};
use crate::navigate::references;
use scenelang_base::{Edit, FileId, TextRange};
use scenelang_lang::db::Cancelled;
use scenelang_lang::natives;
use scenelang_lang::token::{Kind, lex};
use smol_str::SmolStr;

/// The name at an offset that can be changed, and where it stands.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn renamable(snapshot: &Snapshot, offset: u32) -> Result<Option<TextRange>, Cancelled> {
    let name = names::name_at(snapshot, snapshot.main(), offset)?;
    Ok(name.filter(|o| o.symbol.is_own()).map(|o| o.range))
}

/// Edits that give what is named at an offset another name; or why not, in a sentence.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn rename(snapshot: &Snapshot, offset: u32, new: &str) -> Result<Result<Vec<Edit>, String>, Cancelled> {
    let Some(name) = names::name_at(snapshot, snapshot.main(), offset)?.filter(|o| o.symbol.is_own()) else {
        return Ok(Err("nothing here can be renamed".to_owned()));
    };
    let old = snapshot.slice(name.range.in_file(snapshot.main())).to_owned();
    edits(snapshot, snapshot.main(), &name.symbol, &old, new)
}

/// The same for a symbol that a file of the program knows.
pub(crate) fn edits(
    snapshot: &Snapshot,
    file: FileId,
    symbol: &Symbol,
    old: &str,
    new: &str,
) -> Result<Result<Vec<Edit>, String>, Cancelled> {
    if let Some(why) = refusal(snapshot, symbol, old, new)? {
        return Ok(Err(why));
    }
    let mut edits: Vec<Edit> = references(snapshot, file, symbol, true)?
        .into_iter()
        .map(|(place, _)| Edit { place, text: new.to_owned() })
        .collect();
    if let Symbol::Item(..) = symbol {
        edits.extend(in_layout(snapshot, old, new));
    }
    Ok(Ok(edits))
}

/// Why something cannot be called so.
fn refusal(snapshot: &Snapshot, symbol: &Symbol, old: &str, new: &str) -> Result<Option<String>, Cancelled> {
    if !matches!(lex(new).as_slice(), [token] if token.kind == Kind::Ident) {
        return Ok(Some(format!(
            "`{new}` is not a name: a name starts with a letter, continues with letters and digits, and is not a keyword"
        )));
    }
    if new == old {
        return Ok(None);
    }
    let meanings = snapshot.meanings()?;
    let taken = |what: &str| Some(format!("there is already {what} `{new}`"));
    Ok(match symbol {
        Symbol::Predicate(_) if natives::is_built_in(new) => taken("a built-in"),
        Symbol::Predicate(_) if meanings.defined.contains_key(new) => taken("a predicate"),
        Symbol::Predicate(_) => None,
        Symbol::Local { statement, .. } => {
            let found = meanings.statements.iter().find(|(place, _)| place.offset == *statement);
            let beside = found.is_some_and(|(_, hir)| hir.locals.iter().any(|l| l.name == new));
            if beside {
                taken("a variable or parameter")
            } else if meanings.declared.contains_key(new) {
                taken("a declaration of")
            } else {
                None
            }
        }
        _ if meanings.declared.contains_key(new) => taken("a declaration of"),
        _ => {
            // A name that a statement binds for itself would hide it there.
            let named = |hir: &&scenelang_lang::hir::Hir| {
                hir.locals.iter().any(|l: &scenelang_lang::hir::Local| l.name == SmolStr::new(new))
            };
            let hidden = meanings.statements.iter().map(|(_, hir)| *hir).any(|hir| named(&hir));
            if hidden { taken("a variable or parameter") } else { None }
        }
    })
}

/// Keys of the layout: the object or region, elements of an array, a decision variable, draws.
fn in_layout(snapshot: &Snapshot, old: &str, new: &str) -> Vec<Edit> {
    let Some(layout) = snapshot.layout().filter(|l| l.read.usable) else { return Vec::new() };
    let places = &layout.read.places;
    let renamed = |key: &str, ends: &[char]| {
        let rest = key.strip_prefix(old)?;
        (rest.is_empty() || rest.starts_with(ends)).then(|| format!("{new}{rest}"))
    };
    let things = [&places.objects, &places.regions, &places.variables].into_iter().flat_map(|block| block.iter());
    let things = things.filter_map(|entry| Some((entry, renamed(&entry.name, &['['])?)));
    let draws = places.draws.iter().filter_map(|entry| Some((entry, renamed(&entry.name, &['[', '.', '/'])?)));
    let edit = |(entry, key): (&scenelang_layout::file::Entry, String)| Edit {
        place: entry.place.key,
        text: serde_json::Value::from(key).to_string(),
    };
    things.chain(draws).map(edit).collect()
}
