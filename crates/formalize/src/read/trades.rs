//! What people do for a living or with a room: "I fix bikes for a living and want to see my workshop" asks for a workshop for
//! bicycles and for no bike, and "we're redoing the library" for a library.

use super::lexicon::get;
use super::paraphrase::{put, word};
use super::senses::{Sense, sense};
use super::token::{Token, WordKind};
use crate::brief::Note;

const BESIDE: &str = "this says what somebody does, and nothing about what is in the room";
/// What is worked on, and how a workshop for it is called.
const WORKED_ON: [(&[&str], &str); 6] = [
    (&["bike", "bikes", "bicycle", "bicycles"], "bicycle"),
    (&["motorbike", "motorbikes", "motorcycle", "motorcycles"], "motorcycle"),
    (&["car", "cars"], "car"),
    (&["cabinet", "cabinets", "furniture", "wood"], "furniture"),
    (&["pots", "pottery", "ceramics"], "pottery"),
    (&["clothes", "dresses", "suits"], "sewing"),
];
/// The most words between who and "for a living".
const FAR: usize = 7;

/// Leaves out what people do, and tells so.
pub fn lift(tokens: &mut Vec<Token>) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let begins = i == 0 || tokens[i - 1].stops();
        if begins && let Some(end) = trade(tokens, i) {
            let at = tokens[i].at.start..tokens[end - 1].at.end;
            notes.push(Note { at, reason: BESIDE.to_owned() });
            let of = tokens[i..end].iter().find_map(|t| {
                WORKED_ON.iter().find(|(what, _)| what.contains(&t.text.as_str())).map(|(_, kind)| *kind)
            });
            tokens.drain(i..end);
            name_workshop(tokens, i, of);
        }
        if begins {
            redone(tokens, i);
        }
        if begins || tokens[i - 1].is(",") || tokens[i - 1].is("and") {
            is_for(tokens, i);
        }
        i += 1;
    }
    notes
}

/// Where "I fix bikes for a living and" ends, or the sentence with it.
fn trade(tokens: &[Token], i: usize) -> Option<usize> {
    let who = matches!(word(tokens, i), "i" | "we" | "he" | "she" | "they")
        || matches!(word(tokens, i), "my" | "our") && sense(word(tokens, i + 1)) == Some(Sense::Person);
    let inside = |k: &usize| tokens.get(*k).is_some_and(Token::word);
    let living = |k: &usize| {
        matches!(
            [word(tokens, *k), word(tokens, k + 1), word(tokens, k + 2)],
            ["for", "a" | "my" | "our" | "his" | "her", "living" | "job"]
                | ["as", "a" | "my", "job" | "hobby" | "profession" | "business"]
        )
    };
    let end = (i + 2..i + 2 + FAR).take_while(inside).find(living)? + 3;
    let verb = i + 1 + usize::from(matches!(word(tokens, i), "my" | "our"));
    if !who || matches!(word(tokens, verb), "need" | "want" | "would" | "have" | "like") {
        return None;
    }
    match tokens.get(end) {
        Some(next) if next.is("and") || next.is(",") || next.is("so") || next.stops() => Some(end + 1),
        None => Some(end),
        _ => None,
    }
}

/// "My workshop" of who fixes bikes is a bicycle workshop.
fn name_workshop(tokens: &mut Vec<Token>, from: usize, of: Option<&str>) {
    let Some(of) = of else { return };
    let Some(at) = (from..tokens.len()).find(|k| word(tokens, *k) == "workshop") else { return };
    let bare = at == 0
        || matches!(word(tokens, at - 1), "a" | "my" | "our" | "the" | "his" | "her")
        || get().is_look(word(tokens, at - 1));
    if bare {
        put(tokens, at, at + 1, &[of, "workshop"]);
    }
}

/// "We're redoing the library": the library.
fn redone(tokens: &mut Vec<Token>, i: usize) {
    let verb = match [word(tokens, i), word(tokens, i + 1)] {
        ["we're" | "i'm" | "they're", _] => i + 1,
        ["we" | "they", "are"] | ["i", "am"] => i + 2,
        _ => return,
    };
    let does = matches!(
        word(tokens, verb),
        "redoing"
            | "renovating"
            | "refurbishing"
            | "redecorating"
            | "remodelling"
            | "remodeling"
            | "refitting"
            | "redesigning"
    );
    let whose = matches!(word(tokens, verb + 1), "the" | "our" | "my" | "a" | "an" | "their");
    if does && whose {
        let article = word(tokens, verb + 1).to_owned();
        put(tokens, i, verb + 2, &[&article]);
    }
}

/// "Kids get a low table": there is one for them.
fn is_for(tokens: &mut Vec<Token>, i: usize) {
    let the = usize::from(word(tokens, i) == "the");
    let who = word(tokens, i + the);
    let gets = matches!(word(tokens, i + the + 1), "get" | "gets");
    let article = matches!(word(tokens, i + the + 2), "a" | "an" | "one" | "some" | "their");
    let counted = || super::quantified::number(tokens, i + the + 2).is_some();
    let person = sense(who) == Some(Sense::Person) || matches!(who, "kids" | "children" | "staff" | "adults");
    if !gets || !person || !(article || counted()) {
        return;
    }
    let own = word(tokens, i + the + 2) == "their";
    put(tokens, i, i + the + 2 + usize::from(own), &["there", "is"]);
    if i > 0 && (tokens[i - 1].is("and") || tokens[i - 1].is(",")) {
        tokens[i - 1] = Token { kind: WordKind::Sign('.'), ..tokens[i - 1].saying(".") };
        if i > 1 && tokens[i - 2].is(",") {
            tokens.remove(i - 2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::token::tokens;

    #[test]
    fn what_people_do_is_no_thing() {
        for (text, left, notes) in [
            ("I fix bikes for a living and want to see my workshop", "want to see my bicycle workshop", 1),
            ("we restore cars for a living. a workshop with a lift", "a car workshop with a lift", 1),
            ("I build furniture as a hobby, so a workshop", "so a furniture workshop", 1),
            ("I need a desk for a living room", "i need a desk for a living room", 0),
            ("I want a bike for my job", "i want a bike for my job", 0),
            ("we're redoing the library and want six shelves", "the library and want six shelves", 0),
            ("kids get a low table, and staff get two desks.", "there is a low table . there is two desks .", 0),
            ("the sofa gets a rug", "the sofa gets a rug", 0),
        ] {
            let mut tokens = tokens(text, 100).0;
            let found = lift(&mut tokens).len();
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!((rest.join(" ").as_str(), found), (left, notes), "{text}");
        }
    }
}
