//! What a word is that names no thing, from a table of English words: for words that the reader's own tables do not have.

use super::lexicon::singular;
use std::cmp::Ordering;

/// What a word is instead of a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// "mover", "welder".
    Person,
    /// An act, a quality, a state, a time: "heist", "chance".
    Abstract,
    Verb,
    /// An adjective or an adverb.
    Quality,
}

/// The words, one a line, sorted, after a comment.
fn table() -> &'static str {
    const TEXT: &str = include_str!("../../data/senses.txt");
    TEXT.find("\naah ").map_or(TEXT, |start| &TEXT[start + 1..])
}

/// What a word is, if it certainly names no thing.
pub fn sense(word: &str) -> Option<Sense> {
    look_up(word).or_else(|| by_its_end(word)).or_else(|| {
        let one = singular(word);
        // "dresses up": a plural is no verb form.
        (one != word).then(|| look_up(&one)).flatten()
    })
}

/// Words that the table leaves out because their end tells what they are.
fn by_its_end(word: &str) -> Option<Sense> {
    const ABSTRACT: [&str; 3] = ["ness", "ism", "ology"];
    // "A 10-year-old".
    if word.ends_with("-year-old") || word.ends_with("-year-olds") {
        return Some(Sense::Person);
    }
    let is_thing = word.len() < 7 || word.ends_with("harness");
    (!is_thing && ABSTRACT.iter().any(|end| word.ends_with(end))).then_some(Sense::Abstract)
}

/// Searches the lines of the table by halves.
fn look_up(word: &str) -> Option<Sense> {
    let mut rest = table();
    while !rest.is_empty() {
        let middle = rest.len() / 2;
        let start = rest.as_bytes()[..middle].iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1);
        let end = rest.as_bytes()[start..].iter().position(|b| *b == b'\n').map_or(rest.len(), |at| start + at);
        let (found, class) = rest[start..end].split_once(' ')?;
        match word.cmp(found) {
            Ordering::Less => rest = &rest[..start],
            Ordering::Greater => rest = rest.get(end + 1..)?,
            Ordering::Equal => {
                return match class {
                    "p" => Some(Sense::Person),
                    "a" => Some(Sense::Abstract),
                    "v" => Some(Sense::Verb),
                    _ => Some(Sense::Quality),
                };
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_sorted_and_every_line_is_found() {
        let lines: Vec<&str> = table().lines().collect();
        assert!(lines.len() > 30_000);
        assert!(lines.windows(2).all(|pair| pair[0] < pair[1]));
        let missed = lines.iter().filter(|line| line.split_once(' ').is_none_or(|(word, _)| look_up(word).is_none()));
        assert_eq!(missed.collect::<Vec<_>>(), Vec::<&&str>::new());
    }

    #[test]
    fn people_acts_and_verbs_are_no_things() {
        assert_eq!(sense("movers"), Some(Sense::Person));
        assert_eq!(sense("15-year-olds"), Some(Sense::Person));
        assert_eq!(sense("heist"), Some(Sense::Abstract));
        assert_eq!(sense("thrown"), Some(Sense::Quality));
        for thing in ["samovar", "cobot", "lamp", "wig", "gong", "harness"] {
            assert_eq!(sense(thing), None, "{thing}");
        }
    }
}
