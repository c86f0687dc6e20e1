//! Which family a noun belongs to: an alias table and the rule of the head noun ("wooden book shelf" is a shelf for
//! books, "shelf with lamp" still a shelf).

use crate::families::{FAMILIES, maker};
use crate::words::words;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// What draws a noun.
#[derive(Clone, Copy)]
struct Drawn {
    family: &'static str,
    /// Whether it draws something else that is like it.
    stands_in: bool,
}

/// Alias, blanks taken out → family.
static ALIASES: LazyLock<BTreeMap<String, Drawn>> = LazyLock::new(|| {
    let drawn =
        |(family, alias, stands_in)| Some((words(alias).concat(), Drawn { family: maker(family)?.0, stands_in }));
    aliases().filter_map(drawn).collect()
});

/// The lines of the table as (family, alias, whether it only stands in for it).
fn aliases() -> impl Iterator<Item = (&'static str, &'static str, bool)> {
    let mut family = "";
    include_str!("lexicon.txt").lines().filter(|l| !l.starts_with('#')).flat_map(move |line| {
        let list = line.split_once(':').map_or(line, |(name, list)| {
            family = name;
            list
        });
        let of = family;
        let named = |alias: &'static str| match alias.strip_prefix('~') {
            Some(alias) => (alias, true),
            None => (alias, false),
        };
        list.split(',').map(str::trim).filter(|a| !a.is_empty()).map(named).map(move |(a, other)| (of, a, other))
    })
}

/// All nouns that a family draws, in the order of the table.
pub fn categories() -> impl Iterator<Item = &'static str> {
    aliases().map(|(_, alias, _)| alias)
}

/// The families, in the order of the alphabet.
pub fn families() -> impl Iterator<Item = &'static str> {
    let mut names: Vec<&str> = FAMILIES.iter().map(|(name, _)| *name).collect();
    names.sort_unstable();
    names.into_iter()
}

/// Words that end the head of a phrase: what follows describes.
const ENDS: &str = "of with for in on at from near by under above without to beside";
/// Words that count things: after them and "of" the head begins.
const COUNTERS: &str = "set pair stack pile group row piece bunch bundle";
/// Words that may follow the noun in a name without changing what it is.
const TAILS: &str = "left right front back rear main north south east west center centre middle top bottom upper lower \
                     inner outer near far new old big small large unit set furniture object item one two three first \
                     second third station system equipment area model";

fn among(word: &str, list: &str) -> bool {
    list.split_whitespace().any(|w| w == word)
}

/// The family that draws a thing of this category, or else of this name; `None`: nobody knows it.
///
/// The category decides if it is known; a name that says more about the same thing is heard (category "lamp", name
/// `ceilingLamp`).
pub fn family_of(category: &str, name: &str) -> Option<&'static str> {
    drawn(category, name).map(|drawn| drawn.family)
}

/// The family that draws a thing of this category, or else of this name, if it draws something else that is like it: a
/// treadmill for a rowing machine.
pub fn stand_in(category: &str, name: &str) -> Option<&'static str> {
    drawn(category, name).filter(|drawn| drawn.stands_in).map(|drawn| drawn.family)
}

fn drawn(category: &str, name: &str) -> Option<Drawn> {
    match (drawn_by_phrase(category), drawn_by_phrase(name)) {
        (Some(Drawn { family: "lamp", .. }), Some(named))
            if ["lamp", "light"].iter().any(|l| named.family.contains(l)) || named.family == "pendant" =>
        {
            Some(named)
        }
        (Some(by_category), _) => Some(by_category),
        (None, by_name) => by_name,
    }
}

fn drawn_by_phrase(phrase: &str) -> Option<Drawn> {
    let all = words(phrase);
    let end = all.iter().position(|w| among(w, ENDS)).unwrap_or(all.len());
    // An alias may reach over the end of the head: a "chest of drawers".
    if let Some(found) = ends_with_alias(&all, end) {
        return Some(found);
    }
    // "stack of books" is books; "rack of books" is a rack.
    let (mut head, tail) = all.split_at(end);
    if head.last().is_some_and(|w| among(w, COUNTERS)) && tail.len() > 1 {
        head = &tail[1..];
    }
    loop {
        if let Some(found) = ends_with_alias(head, head.len()) {
            return Some(found);
        }
        match head.split_last() {
            Some((last, rest)) if last.chars().count() == 1 || among(last, TAILS) => head = rest,
            _ => return None,
        }
    }
}

/// The family of the longest alias (of six words at most) that ends these words and starts before `limit`.
fn ends_with_alias(words: &[String], limit: usize) -> Option<Drawn> {
    (words.len().saturating_sub(6)..limit).find_map(|start| ALIASES.get(&words[start..].concat()).copied())
}
