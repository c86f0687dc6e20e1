//! What comes next in a text, as far as a noun phrase has to know: nouns, rooms, places, the end of a name.

use super::super::chunk::look_at;
use super::super::lexicon::{Class, LookWord, get, plural, singular};
use super::super::number;
use super::super::token::Token;
use super::Nth;
use crate::brief::{Group, Place};

/// Whether a word before a place tells which one.
pub(super) fn tells_which(word: &str) -> bool {
    get().is(word, Class::Which)
}

pub(super) fn place(word: &str) -> Option<Place> {
    Some(match word {
        "wall" | "walls" => Place::Wall,
        "corner" | "corners" => Place::Corner,
        "ceiling" => Place::Ceiling,
        "floor" | "ground" => Place::Floor,
        "middle" | "centre" | "center" => Place::Middle,
        "side" | "sides" | "edge" => Place::Side,
        "end" | "ends" => Place::End,
        "head" => Place::Head,
        "foot" => Place::Foot,
        "back" | "rear" => Place::Back,
        "front" => Place::Front,
        "row" | "rows" => Place::Row,
        "circle" | "ring" => Place::Circle,
        _ => return None,
    })
}

/// The longest noun of the tables that begins here: in the singular, and its tokens.
pub(super) fn longest_noun(rest: &[Token]) -> Option<(String, usize)> {
    let lexicon = get();
    let words = rest.iter().take(4).take_while(|t| t.word()).count();
    (1..=words).rev().find_map(|n| {
        if rest[..n - 1].iter().any(|t| t.owner) {
            return None;
        }
        let mut phrase: Vec<String> = rest[..n].iter().map(|t| t.text.clone()).collect();
        let plain = phrase.join(" ");
        if let Some(last) = phrase.last_mut() {
            *last = singular(last);
        }
        let phrase = phrase.join(" ");
        // "chest of drawers" is written in the plural.
        let found = [phrase, plain].into_iter().find_map(|p| {
            // "first-aid cabinet", "note-board"
            let apart = p.replace('-', " ");
            [p, apart].into_iter().find(|p| lexicon.noun(p).is_some())
        });
        found.map(|p| (p, n))
    })
}

/// Whether a room's name begins here, and its tokens.
pub(crate) fn room_here(rest: &[Token]) -> Option<usize> {
    let lexicon = get();
    let words = rest.iter().take(3).take_while(|t| t.word()).count();
    (1..=words).rev().find(|n| {
        let mut phrase: Vec<String> = rest[..*n].iter().map(|t| t.text.clone()).collect();
        if lexicon.room(&phrase.join(" ")).is_some() {
            return true;
        }
        if let Some(last) = phrase.last_mut() {
            *last = singular(last);
        }
        lexicon.room(&phrase.join(" ")).is_some()
    })
}

/// Whether a noun of the tables comes right here, or after looks or one more word.
pub(super) fn before_noun(rest: &[Token]) -> bool {
    let Some(first) = rest.first().filter(|t| t.word()) else { return false };
    let lexicon = get();
    // "stands", "lights" after a noun are verbs more often than not.
    if lexicon.verb(rest).is_some()
        || lexicon.relation(rest).is_some_and(|(_, n)| n > 0)
        || lexicon.is(&first.text, Class::Stop)
    {
        return false;
    }
    longest_noun(rest).is_some()
        || look_at(rest)
            .is_some_and(|(_, n)| rest.get(n).is_some_and(Token::word) && longest_noun(&rest[n..]).is_some())
        || !lexicon.known(&first.text)
            && rest.get(1).is_some_and(Token::word)
            && longest_noun(&rest[1..]).is_some()
            && lexicon.verb(&rest[1..]).is_none()
}

/// Whether looks that begin here end in a noun.
pub(super) fn leads_to_noun(rest: &[Token]) -> bool {
    let mut used = 0;
    while let Some((_, n)) = look_at(&rest[used..]) {
        used += n;
        let after = &rest[used..];
        if after.first().is_some_and(|t| t.is(",") || t.is("and")) && look_at(&after[1..]).is_some() {
            used += 1;
        }
        if used > 12 {
            return false;
        }
    }
    let rest = &rest[used..];
    longest_noun(rest).is_some() || before_noun(rest) || rest.first().is_some_and(|t| t.word() && !get().known(&t.text))
}

/// Whether words that tell which place end in a place: "left front corner".
pub(super) fn leads_to_place(rest: &[Token]) -> bool {
    let words = rest.iter().take(4).take_while(|t| t.word() && tells_which(&t.text)).count();
    (1..=words).any(|n| rest.get(n).is_some_and(|t| place(&t.text).is_some() && (!tells_which(&t.text) || n == words)))
        && rest.get(words).is_some_and(|t| place(&t.text).is_some() || tells_which(&rest[words - 1].text) && words > 1)
}

/// A word that is a noun and a verb: here the verb, where no noun phrase has begun.
pub(super) fn stops_here(rest: &[Token], expected: bool) -> bool {
    !expected && (get().verb(rest).is_some() || get().relation(rest).is_some())
}

/// Whether what stands here ends a name although alone it is no thing or a verb: "a headphone stand", "two game cases".
/// `several`: there may be more than one.
pub(super) fn tail_here(rest: &[Token], several: bool) -> bool {
    let lexicon = get();
    let Some(word) = rest.first().map(|t| t.text.as_str()) else { return false };
    let next = &rest[1..];
    let verbal = lexicon.verb(rest).is_some() || lexicon.soft(rest).is_some();
    let fits = match word {
        // "an armchair set beside the table", "a chair that can be moved"
        "set" => next
            .first()
            .is_none_or(|t| !t.word() || lexicon.verb(next).is_some() || t.is("and") || t.is("on") || t.is("of")),
        // "a bowl and a jar stand side by side"
        "stand" => next.first().is_none_or(|t| !t.word() || lexicon.verb(next).is_some() && t.text.ends_with('s')),
        "can" => next.first().is_none_or(|t| {
            !t.word()
                || lexicon.relation(next).is_some()
                || matches!(t.text.as_str(), "and" | "with")
                || lexicon.verb(next).is_some() && ["s", "ed", "ing"].iter().any(|e| t.text.ends_with(e))
        }),
        _ => !verbal && !matches!(word, "display" | "support" | "block") || !takes_object(next),
    };
    let fits = fits && longest_noun(next).is_none() && !(lexicon.is_look(word) && look_at(next).is_some());
    lexicon.is(&singular(word), Class::Tail) && fits && (!plural(word) || several)
}

/// Whether what stands here is what a verb before it may be done to.
pub(super) fn takes_object(rest: &[Token]) -> bool {
    let lexicon = get();
    rest.first().is_some_and(|t| {
        t.word()
            && (lexicon.is(&t.text, Class::Det)
                || lexicon.is(&t.text, Class::Def)
                || lexicon.is(&t.text, Class::Each)
                || number::small(&t.text).is_some())
    })
}

/// Whether it is said here where something stands: a relation, and what it is to.
pub(super) fn stands_somewhere(rest: &[Token]) -> bool {
    get().relation(rest).is_some_and(|(_, n)| rest.get(n).is_some_and(Token::word))
}

/// Whether a word that no table has is an adjective by its end.
pub(super) fn adjective(word: &str) -> bool {
    word.contains('-')
        || ["ed", "able", "ible", "less", "ful", "ous", "ish", "ern", "ian", "ese", "esque", "ic", "ive", "y", "al"]
            .iter()
            .any(|e| word.len() > e.len() + 2 && word.ends_with(e))
}

/// "half the desks", "half of the desks": the words before the noun.
pub(super) fn half(rest: &[Token]) -> usize {
    let of = usize::from(rest.first().is_some_and(|t| t.is("of")));
    let the = rest.get(of).is_some_and(|t| get().is(&t.text, Class::Def));
    if the && rest.get(of + 1).is_some_and(|t| plural(&t.text)) { of + 1 } else { 0 }
}

pub(super) fn ordinal(word: &str) -> Option<Nth> {
    const WORDS: [&str; 10] =
        ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"];
    match word {
        "last" => return Some(Nth::Last),
        "middle" => return Some(Nth::Middle),
        _ => {}
    }
    WORDS.iter().position(|w| *w == word).map(Nth::At)
}

/// Whether a noun comes that an ordinal counts: not "the first floor", "the second of May".
pub(super) fn names_something(rest: &[Token]) -> bool {
    // "the first four desks"
    let counted = number::count(rest).map_or(0, |(_, n)| n);
    let rest = &rest[counted.min(rest.len())..];
    rest.first().filter(|t| t.word()).is_some_and(|t| match place(&t.text) {
        Some(place) => place == Place::Row,
        // "The first picture", not "the first stands".
        None => before_noun(rest) || !t.text.ends_with('s') && longest_noun(rest).is_some(),
    })
}

/// "except the last", "but for the first one": which one is left out, and the words.
pub(super) fn but_one(rest: &[Token]) -> Option<(Nth, usize)> {
    let text = |i: usize| rest.get(i).map_or("", |t| t.text.as_str());
    let mut used = match (text(0), text(1)) {
        ("except" | "but" | "excepting", "for") | ("apart" | "aside", "from") | ("other", "than") => 2,
        ("except" | "but" | "excepting", _) => 1,
        _ => return None,
    };
    used += usize::from(text(used) == "the");
    let nth = match text(used) {
        "first" => Nth::ButFirst,
        "last" => Nth::ButLast,
        _ => return None,
    };
    used += 1;
    // "All but the first and the last": of more than one.
    if text(used) == "and" && ordinal(text(used + 1)).or(ordinal(text(used + 2))).is_some() {
        return None;
    }
    Some((nth, used + usize::from(text(used) == "one")))
}

/// Looks that are no word of the tables, before a noun: an adverb and a participle ("neatly rolled"), a part and what it
/// is like ("glass top", "spindle back"). How many words.
pub(super) fn worded_look(rest: &[Token]) -> Option<usize> {
    const PARTS: [&str; 4] = ["top", "frame", "back", "base"];
    let lexicon = get();
    let [first, second, after @ ..] = rest else { return None };
    if !first.word() || !second.word() || first.owner || second.owner {
        return None;
    }
    let goes_on = || longest_noun(after).is_some() || look_at(after).is_some() && leads_to_noun(after);
    if first.text.ends_with("ly") && first.text.len() > 4 {
        let participle = second.text.ends_with("ed") && lexicon.look(&second.text).is_none();
        return (participle && lexicon.verb(&rest[1..]).is_none() && goes_on()).then_some(2);
    }
    let like = matches!(lexicon.look(&first.text), Some(LookWord::Material | LookWord::Shade))
        || !lexicon.known(&first.text) && !lexicon.is(&first.text, Class::Stop);
    let (noun, _) = longest_noun(after)?;
    let of_itself = matches!(noun.as_str(), "shelf" | "drawer" | "row" | "rest" | "cushion" | "board" | "plate")
        || matches!(lexicon.noun(&noun), Some(Group::Door | Group::Window));
    let single = longest_noun(rest).is_none_or(|(_, n)| n < 2) && longest_noun(&rest[1..]).is_none_or(|(_, n)| n < 2);
    (PARTS.contains(&second.text.as_str()) && like && single && !of_itself).then_some(2)
}
