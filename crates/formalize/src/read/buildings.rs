//! Buildings that are called like a room of theirs: "a nursery with a playroom and a nap room" is a building with these rooms, and
//! so is "a kindergarten with a group room, a kitchen and a toilet".

use super::lexicon::get;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// What may be a room, or a building.
const NAMES: [&str; 8] = ["nursery", "kindergarten", "daycare", "creche", "preschool", "library", "centre", "center"];
/// The most words of a room's name, and of what is said of it before the name.
const LONGEST: usize = 3;
const LOOKS: usize = 2;

/// Calls the first thing of a request a building if the next two are rooms. A toilet among rooms is one as well.
pub fn plain(tokens: &mut Vec<Token>) {
    let is_before = |t: &&Token| matches!(t.text.as_str(), "a" | "an" | "the") || get().look(&t.text).is_some();
    let at = tokens.iter().take_while(is_before).count();
    let said = NAMES.contains(&word(tokens, at)) && matches!(word(tokens, at + 1), "with" | "has");
    let Some(first) = room(tokens, at + 2).filter(|_| said) else { return };
    let next = |end: usize| {
        let joins = tokens.get(end).is_some_and(|t| t.is(",") || t.is("and"));
        joins.then(|| end + 1 + usize::from(tokens[end].is(",") && word(tokens, end + 1) == "and"))
    };
    let Some(mut from) = next(first).filter(|from| room(tokens, *from).is_some()) else { return };
    put(tokens, at, at + 1, &["building"]);
    while let Some(end) = room(tokens, from).or_else(|| toilet(tokens, from)) {
        let is_toilet = room(tokens, from).is_none();
        if is_toilet {
            put(tokens, end - 1, end, &["public", "toilet"]);
        }
        let end = end + usize::from(is_toilet);
        let joins = tokens.get(end).is_some_and(|t| t.is(",") || t.is("and"));
        if !joins {
            break;
        }
        from = end + 1 + usize::from(tokens[end].is(",") && word(tokens, end + 1) == "and");
    }
}

/// Where an article, looks and the name of a room end that begin here.
fn room(tokens: &[Token], i: usize) -> Option<usize> {
    let from = named(tokens, i)?;
    let is_room = |n: &usize| {
        let name: Vec<&str> = (from..from + n).map(|k| word(tokens, k)).collect();
        let name = name.join(" ");
        get().room(&name).is_some() && get().noun(&name).is_none()
    };
    (1..=LONGEST).rev().find(is_room).map(|n| from + n)
}

fn toilet(tokens: &[Token], i: usize) -> Option<usize> {
    let from = named(tokens, i)?;
    let ends = ends(tokens, from + 1) || matches!(word(tokens, from + 1), "for" | "with");
    (word(tokens, from) == "toilet" && ends).then_some(from + 1)
}

fn named(tokens: &[Token], i: usize) -> Option<usize> {
    let article = matches!(word(tokens, i), "a" | "an" | "one");
    let looks = tokens.get(i + 1..)?.iter().take(LOOKS);
    let looks = looks.take_while(|t| t.kind == WordKind::Word && get().is_look(&t.text)).count();
    article.then_some(i + 1 + looks)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn what_has_rooms_is_a_building() {
        for (text, becomes) in [
            (
                "nursery with a playroom, a nap room and a small toilet for the children.",
                "building with a playroom , a nap room and a small public toilet for the children .",
            ),
            ("a kindergarten with a playroom and a kitchen", "a building with a playroom and a kitchen"),
            ("a nursery with a crib and a toilet", "a nursery with a crib and a toilet"),
            ("a library with a reading room", "a library with a reading room"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
