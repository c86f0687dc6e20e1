//! Names of a program from names of others.

use scenelang_lang::library;
use scenelang_lang::natives::{BuiltIn, SIDES, is_built_in};
use scenelang_lang::token::{Kind, lex};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The longest name, in characters.
const LONGEST: usize = 40;
/// Words that mean something where a name may stand.
const MEANT: &[&str] = &["objects", "count", "in", "where", "weight", "rooms", "vec3", "rot", "dot", "rand", "polygon"];

/// Names that were given: each is given once.
#[derive(Debug, Default)]
pub(crate) struct GivenNames {
    given: BTreeSet<String>,
    /// The number to be tried next, by name.
    next: BTreeMap<String, usize>,
}

impl GivenNames {
    /// A name of these words: "coffee table" is `coffeeTable`.
    pub fn take(&mut self, words: &str, fallback: &str) -> String {
        let wanted = identifier(words, fallback);
        let next = self.next.entry(wanted.clone()).or_insert(1);
        loop {
            let name = if *next == 1 { wanted.clone() } else { format!("{wanted}{next}") };
            *next += 1;
            if !is_taken(&name) && self.given.insert(name.clone()) {
                return name;
            }
        }
    }
}

fn is_taken(name: &str) -> bool {
    let is_word = !matches!(lex(name).as_slice(), [one] if one.kind == Kind::Ident);
    is_word
        || MEANT.contains(&name)
        || is_built_in(name)
        || BuiltIn::named(name).is_some()
        || SIDES.iter().any(|(side, _)| *side == name)
        || library::names().any(|known| known == name)
}

fn identifier(words: &str, fallback: &str) -> String {
    let mut name = String::new();
    for word in library::words(words) {
        let mut letters = word.chars().filter(char::is_ascii_alphanumeric);
        let Some(first) = letters.next() else { continue };
        name.push(if name.is_empty() { first } else { first.to_ascii_uppercase() });
        name.extend(letters);
    }
    name.truncate(LONGEST);
    if name.is_empty() { fallback.to_owned() } else { name }
}

/// What the files are called that are made of a file.
pub(crate) fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() || matches!(c, '-' | '_') { c } else { '-' };
    let stem: String = stem.chars().take(LONGEST).map(plain).collect();
    let stem = stem.trim_matches('-');
    if stem.is_empty() { "house".to_owned() } else { stem.to_owned() }
}

/// A category as it is written in programs: words in small letters, no more than a few.
pub(crate) fn category(text: &str) -> String {
    let words: Vec<String> = library::words(text).into_iter().take(6).collect();
    words.join(" ").chars().take(LONGEST).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_can_be_written_and_are_given_once() {
        let mut names = GivenNames::default();
        let taken = ["Coffee Table", "coffee_table-2", "object", "on", "灯", "front", "TVStand"]
            .map(|n| names.take(n, "thing"));
        assert_eq!(taken, ["coffeeTable", "coffeeTable2", "object2", "on2", "thing", "front2", "tvstand"]);
        assert_eq!(category("DiningTable_12_1"), "dining table");
        assert_eq!(stem(Path::new("a/scene 3.json")), "scene-3");
    }
}
