//! What the cursor speaks of, for a picture of the room that shows it: an object, an array, or a constraint.

use crate::Snapshot;
use crate::names::{Role, Symbol, name_at};
use scenelang_lang::db::Cancelled;
use scenelang_lang::items::ItemKind;
use scenelang_verify::report::statement_id;

/// The name of an object, an array or an element, or the id of the constraint that the place is in; `about` is what the
/// report is about, which these ids depend on.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn spoken(snapshot: &Snapshot, offset: u32, about: &str) -> Result<Option<String>, Cancelled> {
    let main = snapshot.main();
    if let Some(name) = name_at(snapshot, main, offset)?
        && let Symbol::Item(named, kind @ (ItemKind::Object | ItemKind::Array(_))) = name.symbol
    {
        // `desk[6]` declares six, of which none is called so; elsewhere it is the seventh.
        let element = match kind {
            ItemKind::Array(_) if name.role != Role::Declares => index(&snapshot.text()[name.range.end as usize..]),
            _ => None,
        };
        return Ok(Some(element.map_or_else(|| named.to_string(), |i| format!("{named}[{i}]"))));
    }
    let Some(judged) = snapshot.judged()? else { return Ok(None) };
    let holds = |range: scenelang_base::TextRange| range.start <= offset && offset <= range.end;
    let row = judged.verdict.rows.iter().find(|row| {
        row.kind.rule().is_none() && row.guideline.is_none() && row.place.file == main && holds(row.place.range)
    });
    Ok(row.map(|row| statement_id(about, snapshot.sources(), row.place)))
}

/// The number in the brackets that a text begins with.
fn index(text: &str) -> Option<u32> {
    text.strip_prefix('[')?.split_once(']')?.0.trim().parse().ok()
}
