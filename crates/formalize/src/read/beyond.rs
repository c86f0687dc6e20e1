//! Rooms that one gets to from another, with what is in them: "through a doorway there is a waiting area with six chairs" is a
//! door that leads to it, and what it has is in it, not near the door.

use super::lexicon::get;
use super::paraphrase::word;
use super::token::{Token, WordKind};

/// What one goes through.
const DOORS: [&str; 6] = ["door", "doorway", "doors", "archway", "arch", "opening"];
/// What precedes the things that a room has.
const HAS: [&str; 5] = ["with", "has", "having", "containing", "featuring"];
/// The most words of a room's name, and of what is said of it.
const LONGEST: usize = 4;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    through(tokens, i) || beside_it(tokens, i) || leads_to(tokens, i)
}

/// "Through a doorway there is a waiting area": a doorway leads to a waiting area.
fn through(tokens: &mut Vec<Token>, i: usize) -> bool {
    let leads = matches!(word(tokens, i), "through" | "beyond" | "behind") && begins(tokens, i);
    let article = matches!(word(tokens, i + 1), "a" | "an" | "the" | "one");
    let Some(door) = (i + 2..i + 5).find(|k| DOORS.contains(&word(tokens, *k))).filter(|_| leads && article) else {
        return false;
    };
    let Some(room) = there_is(tokens, door + 1).filter(|room| name(tokens, room + 1).is_some()) else { return false };
    let like = tokens[door].clone();
    tokens.splice(door + 1..room, ["leads", "to"].map(|text| like.saying(text)));
    tokens.remove(i);
    true
}

/// "Next to it is a kitchen with an island": a door leads to a kitchen.
fn beside_it(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BESIDE: [&[&str]; 6] =
        [&["next", "to"], &["beside"], &["behind"], &["adjoining"], &["off"], &["adjacent", "to"]];
    let is = |at: usize, words: &[&str]| words.iter().enumerate().all(|(k, w)| word(tokens, at + k) == *w);
    let Some(beside) = BESIDE.iter().find(|words| is(i, words)).filter(|_| begins(tokens, i)) else { return false };
    let what = i + beside.len();
    let end = match word(tokens, what) {
        "it" | "this" | "that" => what + 1,
        "the" => match name(tokens, what + 1) {
            Some(end) => end,
            None => return false,
        },
        _ => return false,
    };
    let Some(room) = there_is(tokens, end) else { return false };
    let Some(to) = name(tokens, room + 1).filter(|to| HAS.contains(&word(tokens, *to))) else { return false };
    // "Behind it is a bar with stools": what is a thing as well stands there.
    if get().noun(word(tokens, to - 1)).is_some() {
        return false;
    }
    let like = tokens[i].clone();
    tokens.splice(i..room, ["a", "door", "leads", "to"].map(|text| like.saying(text)));
    true
}

/// "A door leads to a kitchen with an island": in the kitchen there is an island.
fn leads_to(tokens: &mut Vec<Token>, i: usize) -> bool {
    let leads = matches!(word(tokens, i), "leads" | "opens" | "leading" | "opening") && i > 0;
    let to = matches!(word(tokens, i + 1), "to" | "into" | "onto") && matches!(word(tokens, i + 2), "a" | "an");
    let door = DOORS.contains(&word(tokens, i.saturating_sub(1)));
    let Some(end) = name(tokens, i + 3).filter(|_| leads && to && door) else { return false };
    if !HAS.contains(&word(tokens, end)) || tokens.get(end + 1).is_none_or(|t| t.kind == WordKind::Line) {
        return false;
    }
    let like = tokens[end].clone();
    let mut words = vec![Token { kind: WordKind::Sign('.'), ..like.saying(".") }];
    words.extend(["in", "the"].map(|text| like.saying(text)));
    words.extend(tokens[i + 3..end].iter().map(|t| like.saying(&t.text)));
    words.extend(["there", "are"].map(|text| like.saying(text)));
    tokens.splice(end..=end, words);
    true
}

/// Where "a" stands after "there is", "you find", a comma before them left out.
fn there_is(tokens: &[Token], at: usize) -> Option<usize> {
    let at = at + usize::from(tokens.get(at).is_some_and(|t| t.is(",")));
    let end = match [word(tokens, at), word(tokens, at + 1), word(tokens, at + 2)] {
        ["there", "is" | "are", "also"] => at + 3,
        ["there", "is" | "are", _] | ["you", "find" | "enter" | "reach", _] => at + 2,
        ["you", "will", "find"] | ["you", "get", "to"] => at + 3,
        ["there's", "also", _] => at + 2,
        ["is" | "lies" | "comes" | "there's", ..] => at + 1,
        _ => return None,
    };
    matches!(word(tokens, end), "a" | "an").then_some(end)
}

/// Where the name of a room ends that begins here, after words that are said of it.
fn name(tokens: &[Token], from: usize) -> Option<usize> {
    let looks = (from..from + LONGEST).take_while(|k| get().is_look(word(tokens, *k))).count();
    let is_room = |n: &usize| {
        let words: Vec<&str> = (from..from + n).map(|k| word(tokens, k)).collect();
        (looks..*n).any(|skip| get().room(&words[skip..].join(" ")).is_some())
    };
    (looks + 1..=looks + LONGEST).rev().find(is_room).map(|n| from + n)
}

fn begins(tokens: &[Token], i: usize) -> bool {
    i == 0 || !tokens[i - 1].word() || tokens[i - 1].is("and")
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn rooms_behind_doors_have_their_own_things() {
        for (text, becomes) in [
            (
                "through a doorway there's a waiting area with six chairs.",
                "a doorway leads to a waiting area . in the waiting area there are six chairs .",
            ),
            (
                "a door leads to a kitchen with an island and a stool",
                "a door leads to a kitchen . in the kitchen there are an island and a stool",
            ),
            (
                "an office . next to it is a small kitchen with an island",
                "an office . a door leads to a small kitchen . in the small kitchen there are an island",
            ),
            ("a door leads to a kitchen. a stool", "a door leads to a kitchen . a stool"),
            ("a sofa. next to it is a lamp with a shade", "a sofa . next to it is a lamp with a shade"),
            ("a wall. behind it is a counter with lamps", "a wall . behind it is a counter with lamps"),
            ("a path leads to a table with chairs", "a path leads to a table with chairs"),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
