//! What people say beside what they ask for: "She visits in June", "if you don't mind", "In addition, …", "This is a garage with
//! …". Courtesy and words that only lead to what is asked are left out; a sentence about something else is told to be unused.

use super::paraphrase::word;
use super::style::names_room;
use super::token::{Token, WordKind};
use crate::brief::Note;
use std::ops::Range;

/// Courtesy, which asks for nothing and makes nothing a preference.
const POLITE: [&[&str]; 12] = [
    &["if", "you", "not", "mind"],
    &["if", "you", "please"],
    &["i", "wonder", "if", "you", "could"],
    &["i", "was", "wondering", "if", "you", "could"],
    &["it", "would", "be", "great", "if", "you", "could"],
    &["would", "it", "be", "possible", "to"],
    &["as", "you", "might", "expect"],
    &["as", "you", "may", "expect"],
    &["as", "you", "can", "imagine"],
    &["which", "might", "surprise", "you"],
    &["even", "if", "nobody", "is", "home"],
    &["if", "that", "is", "ok"],
];
/// What leads to the rest of a sentence.
const LEADS: [&[&str]; 8] = [
    &["in", "addition"],
    &["at", "the", "moment"],
    &["as", "you", "know"],
    &["by", "the", "way"],
    &["task"],
    &["remember"],
    &["first", "of", "all"],
    &["last", "but", "not", "least"],
];
/// What leads to the room at the beginning of a request.
const SHOWS: [&[&str]; 17] = [
    &["here", "is", "what", "i", "want"],
    &["here", "is", "what", "we", "need"],
    &["the", "scene", "shows"],
    &["the", "image", "shows"],
    &["the", "picture", "shows"],
    &["this", "is"],
    &["it", "is"],
    &["picture", "this"],
    &["we", "are", "planning"],
    &["we", "plan"],
    &["you", "see"],
    &["think", "of"],
    &["imagine"],
    &["picture"],
    &["describe"],
    &["arrange"],
    &["furnish"],
];
/// What people do who are not speaking of the room.
const DOES: [&str; 19] = [
    "visit", "visits", "arrive", "arrives", "saw", "weigh", "weighs", "live", "lives", "hate", "hates", "love",
    "loves", "travel", "travels", "hope", "hopes", "works", "grew",
];
/// What makes a sentence about somebody one about the room all the same.
const ASKS: [&str; 16] = [
    "need",
    "needs",
    "want",
    "wants",
    "would",
    "should",
    "must",
    "so",
    "for",
    "wheelchair",
    "with",
    "room",
    "have",
    "has",
    "like",
    "to",
];
/// What somebody's own is that is no thing in a room.
const OWN: [&str; 10] =
    ["budget", "phone", "number", "email", "name", "deadline", "address", "landlord", "birthday", "boss"];

/// Leaves out courtesy and what leads to the rest.
pub fn courtesy(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        if let Some(words) = POLITE.iter().find(|words| is(tokens, i, words)) {
            remove(tokens, i..i + words.len());
            continue;
        }
        if begins(tokens, i)
            && let Some(words) = LEADS.iter().find(|words| is(tokens, i, words))
            && tokens.get(i + words.len()).is_some_and(|t| t.is(",") || t.is(":"))
        {
            tokens.drain(i..=i + words.len());
            continue;
        }
        // "Is equipped with" a table: has one.
        let fitted = matches!(word(tokens, i + 1), "equipped" | "furnished" | "fitted" | "outfitted" | "appointed");
        if matches!(word(tokens, i), "is" | "are") && fitted && word(tokens, i + 2) == "with" {
            let has = if word(tokens, i) == "is" { "has" } else { "have" };
            super::paraphrase::put(tokens, i, i + 3, &[has]);
        }
        i += 1;
    }
    if let Some(words) = SHOWS.iter().find(|words| is(tokens, 0, words)) {
        let end = words.len() + usize::from(tokens.get(words.len()).is_some_and(|t| t.is(":") || t.is(",")));
        if matches!(word(tokens, end), "a" | "an") && names_room(tokens, end + 1) {
            tokens.drain(..end);
        }
    }
}

/// Leaves out sentences about people and other things, and tells so.
pub fn beside_the_point(tokens: &mut Vec<Token>) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut from = 0;
    while from < tokens.len() {
        let end = tokens[from..].iter().position(Token::stops).map_or(tokens.len(), |n| from + n);
        if from < end && is_beside(&tokens[from..end]) {
            let at = tokens[from].at.start..tokens[end - 1].at.end;
            notes.push(Note { at, reason: "this says nothing about what is in the room".to_owned() });
            tokens.drain(from..(end + 1).min(tokens.len()));
        } else {
            from = end + 1;
        }
    }
    notes
}

fn is_beside(sentence: &[Token]) -> bool {
    let [first, second] = [word(sentence, 0), word(sentence, 1)];
    let asks = sentence.iter().any(|t| ASKS.contains(&t.text.as_str()));
    let number = |k: usize| sentence.get(k).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let person = matches!(first, "i" | "he" | "she" | "we");
    let am = first == "i" && second == "am";
    let is_about = match (first, second) {
        _ if person && DOES.contains(&second) => !asks,
        _ if am && (number(2) || matches!(word(sentence, 2), "not" | "in" | "from" | "happy" | "sure")) => !asks,
        ("my" | "our", own) if OWN.contains(&own) => true,
        ("call" | "email" | "phone" | "contact" | "text" | "write", "me" | "us") => true,
        ("good", "luck") | ("cheers" | "greetings", _) => true,
        ("have", "a") => matches!(word(sentence, sentence.len() - 1), "day" | "evening" | "weekend" | "one"),
        // "Thanks, and add a lamp" asks for one.
        ("thanks" | "thank", _) => !asks && !sentence.iter().any(|t| t.is("and") || t.is("add") || t.is("please")),
        ("many" | "best" | "kind", "thanks" | "regards" | "wishes") => true,
        ("it", "gets" | "got" | "rains" | "snows") => !asks,
        _ => false,
    };
    is_about || is_in_town(sentence)
}

/// "It is in Berlin."
fn is_in_town(sentence: &[Token]) -> bool {
    let [it, is, at, town] = sentence else { return false };
    it.is("it") && is.is("is") && at.is("in") && town.capital && super::lexicon::get().room(&town.text).is_none()
}

fn is(tokens: &[Token], at: usize, words: &[&str]) -> bool {
    words.iter().enumerate().all(|(k, w)| word(tokens, at + k) == *w)
}

fn begins(tokens: &[Token], i: usize) -> bool {
    i == 0 || tokens[i - 1].stops()
}

/// Takes words out, with the comma before or after them.
fn remove(tokens: &mut Vec<Token>, words: Range<usize>) {
    let comma = |k: usize| tokens.get(k).is_some_and(|t| t.is(","));
    let before = words.start > 0 && comma(words.start - 1);
    let start = words.start - usize::from(before);
    let end = words.end + usize::from(comma(words.end) && (!before || words.start == 0));
    tokens.drain(start..end);
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn only_what_is_about_the_room_is_left() {
        for (text, left, notes) in [
            ("a study with a desk. She visits in June.", "a study with a desk .", 1),
            ("a study with a desk. I am 1.90 m tall. My budget is 500 euros.", "a study with a desk .", 2),
            ("a desk. I saw it in a magazine. Thanks a million!", "a desk .", 2),
            ("a desk. It is in Berlin. a lamp", "a desk . a lamp", 1),
            ("a desk. Have a nice day!", "a desk .", 1),
            (
                "a room. Have a big desk. Thanks, and add a lamp.",
                "a room . have a big desk . thanks , and add a lamp .",
                0,
            ),
            ("a desk. It is in the corner.", "a desk . it is in the corner .", 0),
            ("a desk. I am a teacher. I need a chair.", "a desk . i am a teacher . i need a chair .", 0),
            ("a desk. She loves to read, so add a lamp.", "a desk . she loves to read , so add a lamp .", 0),
            ("a desk, if you don't mind, and a chair", "a desk , and a chair", 0),
            ("a desk. In addition, a chair.", "a desk . a chair .", 0),
            ("This is a garage with a car.", "a garage with a car .", 0),
            ("Imagine a kitchen with a table", "a kitchen with a table", 0),
            ("Picture this: a small office with a desk", "a small office with a desk", 0),
            ("it is a desk", "it is a desk", 0),
            ("the kitchen is equipped with a table", "the kitchen has a table", 0),
        ] {
            let mut tokens = tokens(text, 100).0;
            courtesy(&mut tokens);
            let found = beside_the_point(&mut tokens).len();
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!((rest.join(" ").as_str(), found), (left, notes), "{text}");
        }
    }
}
