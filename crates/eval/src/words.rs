//! Words of names and phrases, so that `coffeeTables`, `coffee_table` and "Coffee tables" are the same.

use std::collections::BTreeSet;

/// Words that say nothing about a thing.
const EMPTY: &[&str] = &["a", "an", "the", "of", "for", "with", "and", "in", "on", "to", "s"];

/// British spellings: the left one becomes the right one.
const SPELLINGS: &[(&str, &str)] =
    &[("grey", "gray"), ("colour", "color"), ("aluminium", "aluminum"), ("fibre", "fiber"), ("centre", "center")];

/// The words of a phrase or an identifier in order: lower case, singular, one spelling; numbers are none.
pub fn list(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut before = ' ';
    for c in text.chars().chain([' ']) {
        let starts = c.is_uppercase() && before.is_lowercase();
        if !c.is_alphabetic() || starts {
            push(&mut words, &word);
            word.clear();
        }
        if c.is_alphabetic() {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words
}

fn push(words: &mut Vec<String>, word: &str) {
    if !word.is_empty() && !EMPTY.contains(&word) {
        let word = singular(word);
        words.push(SPELLINGS.iter().find(|(from, _)| *from == word).map_or(word, |(_, to)| (*to).to_owned()));
    }
}

/// A noun without the ending of its plural. Wrong ones ("lens" → "len") do no harm: both sides are treated alike.
fn singular(word: &str) -> String {
    let cut = |n: usize, ending: &str| word[..word.len() - n].to_owned() + ending;
    if word.len() < 3 || word.ends_with("ss") || word.ends_with("us") {
        word.to_owned()
    } else if word.ends_with("ies") {
        cut(3, "y")
    } else if word.ends_with("ves") {
        cut(3, "f")
    } else if ["sses", "xes", "ches", "shes"].iter().any(|e| word.ends_with(e)) {
        cut(2, "")
    } else if word.ends_with('s') {
        cut(1, "")
    } else {
        word.to_owned()
    }
}

/// What a thing is called, for finding out whether two are called alike.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Called {
    /// The words of its name and category.
    words: BTreeSet<String>,
    /// Name and category without blanks: "bookshelf" is "book shelf".
    whole: BTreeSet<String>,
    /// The last words of them: of a coffee table, that it is a table.
    heads: BTreeSet<String>,
}

impl Called {
    /// What is called by each of these phrases.
    pub fn by<'a>(phrases: impl IntoIterator<Item = &'a str>) -> Self {
        let mut called = Self::default();
        for words in phrases.into_iter().map(list).filter(|w| !w.is_empty()) {
            called.whole.insert(words.concat());
            called.heads.extend(words.last().cloned());
            called.words.extend(words);
        }
        called
    }

    /// Whether a word is in both.
    pub fn overlaps(&self, other: &Self) -> bool {
        !self.words.is_disjoint(&other.words) || !self.whole.is_disjoint(&other.whole)
    }

    /// How alike they are, 0 to 100.
    pub fn likeness(&self, other: &Self) -> i64 {
        if !self.whole.is_disjoint(&other.whole) {
            return 100;
        }
        let common = self.words.intersection(&other.words).count() as i64;
        let all = self.words.union(&other.words).count().max(1) as i64;
        let head = if self.heads.is_disjoint(&other.heads) { 0 } else { 30 };
        60 * common / all + head
    }
}

/// Whether what is said is in one of the texts: each word of it, or all of it as one word ("dark blue" in "darkblue").
pub fn carried(said: &str, texts: &[&str]) -> bool {
    let wanted = list(said);
    let there: BTreeSet<String> = texts.iter().flat_map(|t| list(t)).collect();
    wanted.iter().all(|w| there.contains(w)) || there.contains(&wanted.concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_names() {
        let cases = [
            ("coffeeTables", "coffee table"),
            ("coffee_table", "coffee table"),
            ("wall shelves", "wall shelf"),
            ("glasses of the benches", "glass bench"),
            ("chair2", "chair"),
            ("Cactus", "cactus"),
            ("gray-green", "gray green"),
            ("grey", "gray"),
            ("TVs", "tv"),
            ("12 × 8", ""),
        ];
        for (text, words) in cases {
            assert_eq!(list(text).join(" "), words, "{text}");
        }
    }

    #[test]
    fn alike() {
        let (table, coffee) = (Called::by(["table"]), Called::by(["coffeeTable", "coffee table"]));
        assert!(table.overlaps(&coffee));
        assert!(Called::by(["bookshelf"]).overlaps(&Called::by(["book_shelf"])));
        assert!(!Called::by(["rug"]).overlaps(&Called::by(["carpet"])));
        assert_eq!(Called::by(["barStool"]).likeness(&Called::by(["barstools"])), 100);
        assert!(coffee.likeness(&Called::by(["coffee machine"])) < coffee.likeness(&table));
    }

    #[test]
    fn words_that_are_carried() {
        assert!(carried("dark blue", &["darkblue"]));
        assert!(carried("grey steel", &["steel", "gray"]));
        assert!(!carried("dark blue", &["blue"]));
        assert!(!carried("oak", &[""]));
    }
}
