//! Owners: "the bed's foot" is "the foot of the bed", and "a teenager's large room" is a large one of a teenager, so that
//! places and rooms that belong to somebody are read in one way only.

use super::lexicon::{Class, get};
use super::token::Token;
use crate::furnish::kinds;

/// Places that a thing has.
const PLACES: [&str; 17] = [
    "foot", "head", "side", "sides", "end", "ends", "edge", "center", "centre", "middle", "front", "back", "left",
    "right", "wall", "walls", "corner",
];
/// What may stand before a place: "the table's long side".
const BEFORE: [&str; 16] = [
    "north", "south", "east", "west", "left", "right", "long", "short", "far", "near", "other", "front", "back",
    "longer", "shorter", "opposite",
];
/// The most words between "the" and the end of what has the place.
const MOST: usize = 4;

/// Turns "the bed's foot" into "the foot of the bed". All words of it are where the whole phrase is.
pub fn places(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        if let Some((from, to)) = phrase(tokens, i) {
            let at = tokens[from].at.start..tokens[to - 1].at.end;
            let word =
                |text: &str| Token { text: text.to_owned(), owner: false, capital: false, ..tokens[from].clone() };
            let mut new = vec![tokens[from].clone()];
            new.extend_from_slice(&tokens[i + 1..to]);
            new.extend([word("of"), word("the")]);
            new.extend_from_slice(&tokens[from + 1..=i]);
            for token in &mut new {
                token.at = at.clone();
                token.owner = false;
            }
            i = from + new.len();
            tokens.splice(from..to, new);
        } else {
            i += 1;
        }
    }
}

/// Turns "a teenager's large room" into "a large teenager's room", where that is a kind of room.
pub fn rooms(tokens: &mut [Token]) {
    const MOST_LOOKS: usize = 2;
    for i in 0..tokens.len() {
        let looks = tokens[i + 1..].iter().take_while(|t| t.word() && get().is_look(&t.text)).count();
        let Some(room) = tokens.get(i + 1 + looks).filter(|_| tokens[i].owner && (1..=MOST_LOOKS).contains(&looks))
        else {
            continue;
        };
        if kinds::named(&format!("{} {}", tokens[i].text, room.text)).is_some() {
            tokens[i..=i + looks].rotate_left(1);
        }
    }
}

/// Where a phrase begins and ends whose word at `i` is the owner of a place.
fn phrase(tokens: &[Token], i: usize) -> Option<(usize, usize)> {
    let lexicon = get();
    let word = |k: usize| tokens.get(k).filter(|t| t.word());
    word(i).filter(|t| t.owner)?;
    let from = (i.saturating_sub(MOST)..i).rev().find(|k| tokens[*k].is("the"))?;
    let plain = |t: &Token| t.word() && !t.owner && lexicon.relation(std::slice::from_ref(t)).is_none();
    if from + 1 > i || !tokens[from + 1..i].iter().all(plain) {
        return None;
    }
    let mut to = i + 1;
    while word(to).is_some_and(|t| BEFORE.contains(&t.text.as_str())) && word(to + 1).is_some_and(place) {
        to += 1;
    }
    word(to).filter(|t| place(t))?;
    // "the bed's side table" is no side.
    let goes_on = |t: &Token| lexicon.noun(&t.text).is_some() || lexicon.is(&t.text, Class::Abstract);
    (!word(to + 1).is_some_and(goes_on)).then_some((from, to + 1))
}

fn place(token: &Token) -> bool {
    PLACES.contains(&token.text.as_str())
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn places_of_things_are_turned_around() {
        for (text, becomes) in [
            ("a chest at the bed's foot", "a chest at the foot of the bed"),
            ("on the coffee table's left side.", "on the left side of the coffee table ."),
            ("the bed's side table", "the bed side table"),
            ("the teacher's desk", "the teacher desk"),
        ] {
            let mut tokens = tokens(text, 100).0;
            places(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
