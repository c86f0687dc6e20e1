//! Who speaks of whom: from an object to the constraints that name it, and on to the requirements that they answer; and back.

use crate::Snapshot;
use crate::names::{Occurrence, Role, Symbol, name_at, occurrences};
use crate::navigate::references;
use crate::shape::is_constraint;
use scenelang_base::TextRange;
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::Meanings;
use scenelang_lang::items::Located;

/// What can be asked about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CallNode {
    /// A name: an object, a region, a variable, a predicate.
    Name(Symbol),
    /// The statement at an offset.
    Constraint(u32),
    /// A requirement, by its sentence.
    Requirement(String),
}

/// A node with where it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    pub node: CallNode,
    /// How it is called.
    pub name: String,
    /// All of it.
    pub range: TextRange,
    pub name_range: TextRange,
}

/// What is at an offset of the main file.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn item_at(snapshot: &Snapshot, offset: u32) -> Result<Option<Item>, Cancelled> {
    let meanings = snapshot.meanings()?;
    for (place, _) in &meanings.statements {
        for (sentence, range) in &place.stmt.requirements {
            let range = range.shifted(place.offset);
            if range.start <= offset && offset <= range.end {
                return Ok(Some(requirement(sentence, range)));
            }
        }
    }
    if let Some(name) = name_at(snapshot, snapshot.main(), offset)?
        && matches!(name.symbol, Symbol::Item(..) | Symbol::Predicate(_))
    {
        return named(snapshot, &name);
    }
    let holds = |place: &Located<'_>| {
        let range = place.stmt.range.shifted(place.offset);
        is_constraint(&place.stmt.kind) && range.start <= offset && offset <= range.end
    };
    Ok(meanings.statements.iter().find(|(place, _)| holds(place)).map(|(place, _)| constraint(snapshot, place)))
}

/// Who speaks of an item: constraints of a name, requirements of a constraint. With the places where it does.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn incoming(snapshot: &Snapshot, node: &CallNode) -> Result<Vec<(Item, Vec<TextRange>)>, Cancelled> {
    let meanings = snapshot.meanings()?;
    match node {
        CallNode::Name(symbol) => {
            let places = references(snapshot, snapshot.main(), symbol, false)?;
            let places: Vec<TextRange> = places
                .into_iter()
                .filter(|(span, _)| span.file == snapshot.main())
                .map(|(span, _)| span.range)
                .collect();
            let speaking = constraints(&meanings).filter_map(|place| {
                let own = place.stmt.range.shifted(place.offset);
                let within: Vec<TextRange> =
                    places.iter().copied().filter(|r| own.start <= r.start && r.end <= own.end).collect();
                (!within.is_empty()).then(|| (constraint(snapshot, place), within))
            });
            Ok(speaking.collect())
        }
        CallNode::Constraint(at) => {
            let own = constraints(&meanings).find(|place| place.offset == *at);
            let asked = own.into_iter().flat_map(|place| {
                place.stmt.requirements.iter().map(move |(sentence, range)| {
                    let range = range.shifted(place.offset);
                    (requirement(sentence, range), vec![range])
                })
            });
            Ok(asked.collect())
        }
        CallNode::Requirement(_) => Ok(Vec::new()),
    }
}

/// Whom an item speaks of: names of a constraint, constraints of a requirement. With the places where it does.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn outgoing(snapshot: &Snapshot, node: &CallNode) -> Result<Vec<(Item, Vec<TextRange>)>, Cancelled> {
    let meanings = snapshot.meanings()?;
    match node {
        CallNode::Name(_) => Ok(Vec::new()),
        CallNode::Constraint(at) => {
            let all = occurrences(snapshot, snapshot.main())?;
            let mut out: Vec<(Item, Vec<TextRange>)> = Vec::new();
            let named_here =
                |o: &&Occurrence| o.statement == *at && matches!(o.symbol, Symbol::Item(..) | Symbol::Predicate(_));
            for name in all.iter().filter(named_here) {
                match out.iter_mut().find(|(item, _)| matches!(&item.node, CallNode::Name(s) if s.is(&name.symbol))) {
                    Some((_, places)) => places.push(name.range),
                    None => out.extend(named(snapshot, name)?.map(|item| (item, vec![name.range]))),
                }
            }
            Ok(out)
        }
        CallNode::Requirement(sentence) => {
            let answers = constraints(&meanings).filter_map(|place| {
                let (_, range) = place.stmt.requirements.iter().find(|(s, _)| s == sentence)?;
                Some((constraint(snapshot, place), vec![range.shifted(place.offset)]))
            });
            Ok(answers.collect())
        }
    }
}

fn constraints<'m>(meanings: &'m Meanings<'_>) -> impl Iterator<Item = &'m Located<'m>> {
    meanings.statements.iter().map(|(place, _)| place).filter(|place| is_constraint(&place.stmt.kind))
}

fn constraint(snapshot: &Snapshot, place: &Located<'_>) -> Item {
    let range = place.stmt.range.shifted(place.offset);
    let text: Vec<&str> = snapshot.slice(range.in_file(snapshot.main())).split_whitespace().collect();
    Item { node: CallNode::Constraint(place.offset), name: text.join(" "), range, name_range: range }
}

fn requirement(sentence: &str, range: TextRange) -> Item {
    Item { node: CallNode::Requirement(sentence.to_owned()), name: sentence.to_owned(), range, name_range: range }
}

/// A name as an item, shown where it is declared if that is in the main file.
fn named(snapshot: &Snapshot, name: &Occurrence) -> Result<Option<Item>, Cancelled> {
    let declared = references(snapshot, snapshot.main(), &name.symbol, true)?;
    let own = declared.iter().find(|(span, role)| *role == Role::Declares && span.file == snapshot.main());
    let place = own.map_or(name.range, |(span, _)| span.range);
    let text = snapshot.slice(name.range.in_file(snapshot.main())).to_owned();
    let symbol = name.symbol.clone();
    Ok(Some(Item { node: CallNode::Name(symbol), name: text, range: place, name_range: place }))
}
