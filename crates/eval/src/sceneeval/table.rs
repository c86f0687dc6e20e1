//! The words of the benchmark, and what they mean here: `table.txt`, where the original asks a model.

use super::lookups::Lookups;

/// The rows of `table.txt`, and what a model says instead for one request.
#[derive(Clone, Debug)]
pub struct Table(Vec<(String, Vec<String>)>, Lookups);

/// Key and words of each row.
const TEXT: &str = include_str!("table.txt");

impl Default for Table {
    fn default() -> Self {
        Self::new()
    }
}

impl Table {
    pub fn new() -> Self {
        let rows = TEXT.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once(" : "));
        let rows = rows.map(|(key, words)| (key.to_owned(), words.split(' ').map(str::to_owned).collect())).collect();
        Self(rows, Lookups::default())
    }

    /// The table with answers of a model.
    pub fn with(lookups: Lookups) -> Self {
        Self(Self::new().0, lookups)
    }

    /// What a model answered; nothing where none was asked.
    pub fn lookups(&self) -> &Lookups {
        &self.1
    }

    /// The words of each row with this key.
    pub fn rows<'a>(&'a self, key: &'a str) -> impl Iterator<Item = &'a [String]> {
        self.0.iter().filter(move |(k, _)| k == key).map(|(_, words)| words.as_slice())
    }

    /// Whether a row with this key has a word.
    pub fn has(&self, key: &str, word: &str) -> bool {
        self.rows(key).any(|words| words.iter().any(|w| w == word))
    }

    /// What follows `part` in the key of the first row that has a word: `near` of `between near`.
    pub fn find<'a>(&'a self, part: &str, word: &str) -> Option<&'a str> {
        let key = |key: &'a str| key.strip_prefix(part).and_then(|rest| rest.strip_prefix(' '));
        let mut rows = self.0.iter().filter_map(|(k, words)| Some((key(k)?, words)));
        rows.find(|(_, words)| words.iter().any(|w| w == word)).map(|(rest, _)| rest)
    }

    /// By which predicates a program says a geometry.
    pub fn said(&self, geometry: &str) -> &[String] {
        let row = self.0.iter().find(|(key, _)| key.strip_prefix("said ") == Some(geometry));
        row.map_or(&[], |(_, words)| words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sceneeval::places::RoomRelation;
    use crate::sceneeval::relations::Relation;

    #[test]
    fn every_row_is_of_use() {
        let lines = TEXT.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
        let table = Table::new();
        assert_eq!(table.0.len(), lines.count(), "each line is a row");
        for (key, _) in &table.0 {
            let known = match key.split_once(' ') {
                None => ["synonyms", "kinds", "sizes"].contains(&key.as_str()),
                Some(("between", name)) => Relation::of(name).is_some(),
                Some(("said", name)) => {
                    Relation::of(name).is_some() || RoomRelation::ALL.iter().any(|p| p.name() == name)
                }
                Some(("opening", name)) => ["next", "across", "far", "below"].contains(&name),
                Some(("wall", name)) => ["on", "near"].contains(&name),
                Some(("room", name)) => ["corner", "middle"].contains(&name),
                Some(("sides", name)) => ["none", "all", "three"].contains(&name),
                Some(("held", name)) => ["wall", "ceiling"].contains(&name),
                Some(_) => false,
            };
            assert!(known, "{key}");
        }
        for name in Relation::ALL.map(Relation::name).into_iter().chain(RoomRelation::ALL.map(RoomRelation::name)) {
            assert!(!table.said(name).is_empty(), "{name}");
        }
    }

    #[test]
    fn words_are_found() {
        let table = Table::new();
        assert_eq!(table.find("between", "beside"), Some("next"));
        assert_eq!(table.find("between", "sideways"), None);
        assert!(table.has("sizes", "king_size") && !table.has("sizes", "oak"));
    }
}
