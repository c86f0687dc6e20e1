//! Roles: what things of a category are for, in one word, as the table `std/roles.txt` says.

use crate::library::words;
use rustc_hash::FxHashMap;
use std::sync::OnceLock;

/// A role with its categories, in the order of the table.
type Row = (&'static str, Vec<&'static str>);

/// The table.
fn rows() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let mut rows: Vec<Row> = Vec::new();
        for line in include_str!("../std/roles.txt").lines().filter(|line| !line.starts_with('#')) {
            let nouns = match line.split_once(':') {
                Some((role, nouns)) => {
                    rows.push((role, Vec::new()));
                    nouns
                }
                None => line,
            };
            if let Some((_, list)) = rows.last_mut() {
                list.extend(nouns.split(',').map(str::trim).filter(|noun| !noun.is_empty()));
            }
        }
        rows
    })
}

/// All roles that categories have, sorted.
pub fn all() -> impl Iterator<Item = &'static str> {
    rows().iter().map(|(role, _)| *role)
}

/// The role of a category: that of its longest end that the table has ("oak dining table" is a table), else of its last
/// word that the table has; `""` if there is none.
pub fn role_of(category: &str) -> &'static str {
    let words = words(category);
    let found = (0..words.len()).find_map(|skip| lookup(&words[skip..].join(" ")));
    found.or_else(|| words.iter().rev().find_map(|word| lookup(word))).unwrap_or_default()
}

fn lookup(noun: &str) -> Option<&'static str> {
    static TABLE: OnceLock<FxHashMap<&str, &str>> = OnceLock::new();
    let table = TABLE
        .get_or_init(|| rows().iter().flat_map(|(role, nouns)| nouns.iter().map(move |noun| (*noun, *role))).collect());
    let find = |noun: &str| table.get(noun).copied();
    find(noun).or_else(|| find(noun.strip_suffix('s')?)).or_else(|| find(noun.strip_suffix("es")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_sorted_and_has_each_category_once() {
        let roles: Vec<&str> = all().collect();
        assert!(roles.is_sorted() && roles.len() >= 20, "{roles:?}");
        let mut seen = FxHashMap::default();
        for (role, nouns) in rows() {
            assert!(nouns.is_sorted(), "{role}");
            for noun in nouns {
                assert_eq!(words(noun).join(" "), *noun, "{role}: written as it is looked up");
                assert_eq!(seen.insert(*noun, *role), None, "{noun}");
            }
        }
    }

    #[test]
    fn roles_are_found_by_head_noun() {
        for (category, role) in [
            ("chair", "seat"),
            ("oak dining table", "table"),
            ("office_chairs", "seat"),
            ("bookShelf", "storage"),
            ("TV", "screen"),
            ("tv stand", "storage"),
            ("bedside lamp", "light"),
            ("bedside table", "storage"),
            ("shelves", ""),
            ("quux", ""),
            ("", ""),
        ] {
            assert_eq!(role_of(category), role, "{category}");
        }
    }

    #[test]
    fn every_category_with_a_usual_size_has_a_role() {
        let sizes = include_str!("../std/sizes.txt").lines().filter_map(|line| line.split('#').next());
        for category in sizes.filter_map(|row| row.split_whitespace().next()) {
            assert_ne!(role_of(category), "", "{category}");
        }
    }
}
