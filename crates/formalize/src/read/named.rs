//! Rooms that are called by the last word of their name, where that word is a thing as well: "A ramen bar with its own
//! kitchen. The bar is nine metres long": the ramen bar.

use super::lexicon::{get, singular};
use super::number::count;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use crate::furnish::kinds;

/// Gives a room its whole name wherever it is called by the last word of it. Only where a measure says that the room is
/// meant: who speaks of "the bar" may mean the counter.
pub fn whole(tokens: &mut Vec<Token>) {
    let Some((first, last)) = named(tokens) else { return };
    let measured = |i: usize| {
        let number =
            tokens.get(i + 3..i + 4).is_some_and(|t| matches!(t[0].kind, WordKind::Number(_)) || count(t).is_some());
        let long = (i + 4..i + 7).any(|k| matches!(word(tokens, k), "long" | "wide" | "by" | "x"));
        short(tokens, i, &last) && word(tokens, i + 2) == "is" && number && long
    };
    if !(0..tokens.len()).any(measured) {
        return;
    }
    let mut i = 0;
    while i < tokens.len() {
        let at_thing = i > 0
            && matches!(word(tokens, i - 1), "at" | "on" | "behind" | "above" | "along" | "under" | "around" | "of");
        if short(tokens, i, &last) && !at_thing {
            let at = tokens[i + 1].at.clone();
            tokens.insert(i + 1, Token { kind: WordKind::Word, text: first.clone(), at, owner: false, capital: false });
        }
        i += 1;
    }
}

/// "A dentist with two chairs", "a library for children": a request that begins with a word for people, or with a name of
/// several words that is not read as one, is about the room that is called so.
pub fn titled(tokens: &mut Vec<Token>) {
    const LONGEST: usize = 4;
    let lexicon = get();
    let is_before = |t: &&Token| matches!(t.text.as_str(), "a" | "an" | "the") || lexicon.look(&t.text).is_some();
    let from = tokens.iter().take_while(is_before).count();
    let most = tokens[from..].iter().take(LONGEST).take_while(|t| t.word()).count();
    let ends = |i: usize| tokens.get(i).is_none_or(|t| !t.word() || t.is("with") || t.is("for"));
    for n in (1..=most).rev().filter(|n| ends(from + n)) {
        let words: Vec<&str> = (from..from + n).map(|i| word(tokens, i)).collect();
        let (name, last) = (words.join(" "), words[n - 1]);
        if let Some(room) = room_of(&name, &tokens[from + n..]) {
            put(tokens, from, from + n, &room.split(' ').collect::<Vec<_>>());
            return;
        }
        // Their words have other meanings, too.
        let is_misread = words.contains(&"for") || last == "class" || matches!(words[0], "front" | "it" | "nursing");
        let has_owner = n > 1 && tokens[from..from + n].iter().any(|t| t.owner);
        let is_read = has_owner || lexicon.room(&name).is_some() && !is_misread;
        let is_thing = n == 1 && lexicon.noun(last).is_some();
        if let Some(kind) = kinds::named(&name).filter(|kind| !is_read && !is_thing && kind.name != name) {
            let words: Vec<&str> = kind.name.split(' ').collect();
            put(tokens, from, from + n, &words);
            return;
        }
    }
}

/// What is in such a building if the request names none of its rooms.
const BUILDINGS: [(&str, &str); 11] = [
    ("school", "classroom"),
    ("high school", "classroom"),
    ("elementary school", "classroom"),
    ("primary school", "classroom"),
    ("secondary school", "classroom"),
    ("college", "lecture hall"),
    ("university", "lecture hall"),
    ("hotel", "hotel lobby"),
    ("company", "open-plan office"),
    ("office building", "open-plan office"),
    ("mall", "shopping mall"),
];

/// The room of a building that a request is about, if it names none.
fn room_of(building: &str, rest: &[Token]) -> Option<&'static str> {
    let is_room = |t: &Token| t.text.contains("room") || get().room(&singular(&t.text)).is_some();
    let found = BUILDINGS.iter().find(|(name, _)| *name == building)?;
    (!rest.iter().any(is_room)).then_some(found.1)
}

/// "the bar"
fn short(tokens: &[Token], i: usize, last: &str) -> bool {
    word(tokens, i) == "the" && word(tokens, i + 1) == last
}

/// The first room that has a name of two words, of which the last alone is a thing.
fn named(tokens: &[Token]) -> Option<(String, String)> {
    let lexicon = get();
    (0..tokens.len().saturating_sub(1)).find_map(|i| {
        let (first, last) = (word(tokens, i), word(tokens, i + 1));
        let room = lexicon.room(&format!("{first} {last}")).is_some_and(|kind| !kind.loose);
        let thing = lexicon.room(last).is_none() && lexicon.noun(last).is_some();
        (room && thing).then(|| (first.to_owned(), last.to_owned()))
    })
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn a_request_may_begin_with_who_works_there() {
        for (text, becomes) in [
            ("a small dentist with two chairs.", "a small dental surgery with two chairs ."),
            ("a hairdresser.", "a hair salon ."),
            ("a library for children.", "a children's library ."),
            ("a bar with six stools.", "a bar with six stools ."),
            ("a school.", "a classroom ."),
            ("a school with two classrooms.", "a school with two classrooms ."),
            ("a front room.", "a living room ."),
            ("a dental clinic with a waiting room.", "a dental clinic with a waiting room ."),
            ("a hotel for ten.", "a hotel lobby for ten ."),
            ("a room for a dentist.", "a room for a dentist ."),
            ("a painting with a frame.", "a painting with a frame ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            titled(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }

    #[test]
    fn the_last_word_stands_for_the_name() {
        for (text, becomes) in [
            ("a ramen bar. the bar is 9 m long.", "a ramen bar . the ramen bar is 9 m long ."),
            (
                "a ramen bar. the bar is 9 m long. a stool at the bar.",
                "a ramen bar . the ramen bar is 9 m long . a stool at the bar .",
            ),
            ("a ramen bar. the bar is nine metres long.", "a ramen bar . the ramen bar is nine metres long ."),
            ("a ramen bar. the bar is made of oak.", "a ramen bar . the bar is made of oak ."),
            ("a bar. the bar is 9 m long.", "a bar . the bar is 9 m long ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            whole(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
