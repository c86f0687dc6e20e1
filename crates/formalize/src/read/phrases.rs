//! Phrases of the tables in `data/`, each with what it means: the longest that begins at a place of the text.

use super::lexicon::table;
use super::token::Token;
use std::collections::BTreeMap;

/// Phrases by their first word.
pub struct Phrases<T> {
    by_word: BTreeMap<&'static str, Vec<(Vec<&'static str>, T)>>,
}

impl<T: Clone> Phrases<T> {
    /// Those of a table whose key means something.
    pub fn new(text: &'static str, meaning: impl Fn(&str) -> Option<T>) -> Self {
        let mut by_word: BTreeMap<&str, Vec<(Vec<&str>, T)>> = BTreeMap::new();
        for (key, phrases) in table(text) {
            let Some(meaning) = meaning(key) else { continue };
            for phrase in phrases {
                let words: Vec<&str> = phrase.split(' ').collect();
                by_word.entry(words[0]).or_default().push((words, meaning.clone()));
            }
        }
        Self { by_word }
    }

    /// What the longest phrase that begins here means, and how many tokens it takes.
    pub fn longest(&self, rest: &[Token]) -> Option<(T, usize)> {
        let own = self.by_word.get(rest.first()?.text.as_str())?;
        let fits = |words: &[&str]| words.len() <= rest.len() && words.iter().zip(rest).all(|(w, t)| t.is(w));
        let best = own.iter().filter(|(words, _)| fits(words)).max_by_key(|(words, _)| words.len())?;
        Some((best.1.clone(), best.0.len()))
    }
}
