//! Clauses that tell why, when or for whom and ask for nothing: "because a tub won't fit", "before the movers come", "so the
//! client feels small", "for a segmentation dataset". They are left out, and that is told.

use super::lexicon::{Class, get, singular};
use super::noun::room_here;
use super::paraphrase::word;
use super::senses::{Sense, sense};
use super::token::{Token, WordKind};
use crate::brief::Note;
use std::ops::Range;

/// What makes such a clause a demand all the same: what is needed, seen or passed.
const ASKS: &[&str] = &[
    "need",
    "needs",
    "want",
    "wants",
    "must",
    "should",
    "has",
    "have",
    "see",
    "seen",
    "sees",
    "watch",
    "visible",
    "view",
    "walk",
    "pass",
    "reach",
    "enter",
    "entering",
    "get",
    "through",
    "open",
    "opens",
    "opened",
    "sit",
    "sits",
    "sitting",
    "wheelchair",
    "pram",
    "space",
    "room",
    "access",
    "share",
    "there",
    "there's",
];
/// The most words of such a clause.
const LONGEST: usize = 16;

const BESIDE: &str = "this says nothing about what is in the room";

/// Leaves out what asks for nothing, and tells so.
pub fn lift(tokens: &mut Vec<Token>) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let beside = clause(tokens, i).or_else(|| purpose(tokens, i)).or_else(|| news(tokens, i));
        let beside = beside
            .or_else(|| see_if(tokens, i))
            .or_else(|| about(tokens, i))
            .or_else(|| own_use(tokens, i))
            .or_else(|| to_use(tokens, i))
            .or_else(|| unlike(tokens, i))
            .or_else(|| stands(tokens, i))
            .or_else(|| title(tokens, i))
            .map(|clause| (clause, BESIDE));
        let found = beside
            .or_else(|| Some((bare_wall(tokens, i)?, "no statement keeps a part of a wall empty")))
            .or_else(|| Some((kept_apart(tokens, i)?, "no statement says what a partition keeps apart")));
        let Some((clause, reason)) = found else {
            i += 1;
            continue;
        };
        let at = tokens[clause.start].at.start..tokens[clause.end - 1].at.end;
        notes.push(Note { at, reason: reason.to_owned() });
        // "Keep … apart with a partition" is a partition all the same.
        if matches!(word(tokens, clause.end), "with" | "by") {
            tokens[clause.end].text = "and".to_owned();
        }
        tokens.drain(clause);
    }
    notes
}

/// "We're having a baby and our flat is 52 m²": all before the flat.
fn news(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let begins = i == 0 || tokens[i - 1].stops();
    let who =
        matches!(word(tokens, i), "i" | "we" | "he" | "she" | "they" | "i'm" | "we're" | "they're" | "she's" | "he's");
    let and = (i + 1..end(tokens, i))
        .find(|k| word(tokens, *k) == "and" && matches!(word(tokens, k + 1), "my" | "our" | "the"))?;
    let home = |k: usize| super::several::is_home(word(tokens, k)) || room_here(&tokens[k..]).is_some();
    let is_said = home(and + 2) && matches!(word(tokens, and + 3), "is" | "has" | "measures");
    let asks = (i..and).any(|k| ASKS.contains(&word(tokens, k)) || home(k) || turns(&tokens[k]));
    (begins && who && is_said && !asks).then_some(i..and + 1)
}

/// "So I want to see if this is crazy or not".
fn see_if(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const FAR: usize = 8;
    let so = usize::from(word(tokens, i) == "so");
    let begins = so == 1 || i == 0 || !tokens[i - 1].word();
    let who = begins && matches!(word(tokens, i + so), "i" | "we");
    let asks = |k: &usize| {
        matches!(word(tokens, *k), "see" | "know" | "check" | "find" | "wonder" | "wondering")
            && (k + 1..k + 3).any(|k| matches!(word(tokens, k), "if" | "whether"))
    };
    let seen = (i + so + 1..i + so + FAR).take_while(|k| tokens.get(*k).is_some_and(Token::word)).find(asks);
    let said = i..end(tokens, i);
    let things = || said.clone().any(|k| get().noun(&singular(word(tokens, k))).is_some() || turns(&tokens[k]));
    (who && seen.is_some() && !things()).then(|| said.clone())
}

/// "The game is a murder mystery, so": what a scene is for, and no thing in it.
fn about(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const WHAT: [&str; 12] =
        ["game", "story", "film", "movie", "play", "idea", "theme", "plot", "concept", "genre", "setting", "show"];
    let begins = i == 0 || tokens[i - 1].stops();
    let named = matches!(word(tokens, i), "the" | "our" | "my") && WHAT.contains(&word(tokens, i + 1));
    let is = matches!(word(tokens, i + 2), "is" | "was" | "takes");
    let said = i..end(tokens, i);
    let known = |k: usize| {
        let thing = super::shares::noun(tokens, k).is_some();
        thing || room_here(&tokens[k..]).is_some() || turns(&tokens[k])
    };
    let comma = usize::from(tokens.get(said.end).is_some_and(|t| t.is(",")));
    (begins && named && is && !said.clone().skip(2).any(known)).then_some(said.start..said.end + comma)
}

/// "A chair for putting on his socks": what is somebody's own is used there, and nothing that is to be placed.
fn own_use(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let acts = word(tokens, i) == "for" && word(tokens, i + 1).ends_with("ing");
    let on = i + 2 + usize::from(matches!(word(tokens, i + 2), "on" | "up" | "off" | "away"));
    let own = matches!(word(tokens, on), "my" | "his" | "her" | "their" | "our");
    let end = on + 2;
    (acts && own && tokens.get(end).is_none_or(|t| !t.word() || t.is("and"))).then_some(i..end)
}

/// "A bench to try shoes on", "a table to eat at": what a thing is used for.
fn to_use(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const USES: [&str; 19] = [
        "try", "sit", "eat", "read", "work", "put", "change", "lie", "sleep", "wait", "write", "draw", "play", "fold",
        "relax", "rest", "sort", "wrap", "drink",
    ];
    const FAR: usize = 4;
    let used = word(tokens, i) == "to" && i > 0 && USES.contains(&word(tokens, i + 1));
    let after = used && (i.saturating_sub(3)..i).any(|k| super::shares::noun(tokens, k).is_some_and(|n| n.end == i));
    let particle = |k: usize| matches!(word(tokens, k), "on" | "at" | "in" | "from" | "with" | "down" | "off");
    // Nothing follows that the particle could lead to.
    let free = |k: usize| {
        !tokens.get(k).is_some_and(Token::word)
            || matches!(word(tokens, k), "and" | "in" | "at" | "by" | "near" | "next" | "against" | "under" | "beside")
    };
    let end = (i + 2..i + 2 + FAR).take_while(|k| tokens.get(*k).is_some_and(Token::word));
    let mut end = end.filter(|k| particle(*k)).map(|k| k + 1);
    end.find(|end| free(*end)).filter(|_| after).map(|end| i..end)
}

/// "But please not like a souvenir shop": what it is not like is nothing in it.
fn unlike(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let but = i + usize::from(word(tokens, i) == "but");
    let not = but + usize::from(word(tokens, but) == "please");
    let said = word(tokens, not) == "not" && word(tokens, not + 1) == "like";
    said.then(|| i..end(tokens, i)).filter(|said| said.len() <= LONGEST)
}

/// "Ten stools and a bartender behind it": people are not placed, and what is said of them is not said of the stools.
fn stands(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let joins = matches!(word(tokens, i), "and" | "with");
    let counted = super::number::count(tokens.get(i + 1..)?).map(|(_, used)| used);
    let person = i + 1 + counted.unwrap_or(usize::from(matches!(word(tokens, i + 1), "a" | "an" | "the")));
    let who = word(tokens, person);
    let is_person = person > i + 1 && sense(who) == Some(Sense::Person) && get().noun(&singular(who)).is_none();
    let (_, used) = get().relation(tokens.get(person + 1..)?).filter(|_| joins && is_person)?;
    let to = person + 1 + used;
    let end = match word(tokens, to) {
        "it" | "them" => to + 1,
        "the" => super::shares::noun(tokens, to + 1)?.end,
        _ => return None,
    };
    (used > 0 && tokens.get(end).is_none_or(|t| !t.word() || t.is("and"))).then_some(i..end)
}

/// "Heist map, …": what kind of work the room is for, at the beginning.
fn title(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const MOST: usize = 4;
    const WORKS: [&str; 7] = ["map", "level", "scene", "mission", "quest", "episode", "lesson"];
    let end = (i == 0).then(|| end(tokens, 0)).filter(|end| (2..=MOST).contains(end) && *end < tokens.len())?;
    let work = WORKS.contains(&word(tokens, end - 1)) && (tokens[end].is(",") || tokens[end].is(":"));
    let named = (0..end - 1).any(|k| room_here(&tokens[k..]).is_some() || get().noun(word(tokens, k)).is_some());
    // "A world map, a desk" is a list.
    let article = get().is(word(tokens, 0), Class::Det) || get().is(word(tokens, 0), Class::Def);
    (work && !named && !article && super::shares::noun(tokens, 0).is_none()).then_some(0..end)
}

/// "And please leave the wall beneath the window empty".
fn bare_wall(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const FAR: usize = 12;
    let from = i + usize::from(word(tokens, i) == "and");
    let from = from + usize::from(word(tokens, from) == "please");
    let said = matches!(word(tokens, from), "leave" | "keep")
        && word(tokens, from + 1) == "the"
        && word(tokens, from + 2) == "wall";
    let mut within = (from + 3..from + FAR).take_while(|k| tokens.get(*k).is_some_and(Token::word));
    let bare = |k: &usize| matches!(word(tokens, *k), "empty" | "free" | "clear" | "bare" | "unobstructed");
    within.find(bare).filter(|_| said).map(|end| i..end + 1)
}

/// "But keep the cat side and the dog side apart with a low partition": all before the partition.
fn kept_apart(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const FAR: usize = 14;
    let from = i + usize::from(word(tokens, i) == "but");
    let begins = from > i || i == 0 || !tokens[i - 1].word() || word(tokens, i - 1) == "please";
    if !matches!(word(tokens, from), "keep" | "separate") || !begins {
        return None;
    }
    let mut within = (from + 1..from + FAR).take_while(|k| tokens.get(*k).is_some_and(Token::word));
    let by = |k: &usize| matches!(word(tokens, *k), "with" | "by") && matches!(word(tokens, k + 1), "a" | "an");
    let by = within.find(by)?;
    let apart = word(tokens, by - 1) == "apart" || word(tokens, from) == "separate";
    // Where the two are things, they have a place each.
    let things = (from + 1..by).any(|k| get().noun(&singular(word(tokens, k))).is_some());
    let divider = (by + 2..by + 5).any(|k| get().noun(&singular(word(tokens, k))).is_some());
    (apart && !things && divider).then_some(i..by)
}

/// Where the clause ends that a token is in.
fn end(tokens: &[Token], i: usize) -> usize {
    let sign = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ',' | ';' | ':' | '!' | '?' | ')'));
    tokens[i..].iter().position(sign).map_or(tokens.len(), |n| i + n)
}

/// "Because a tub won't fit", "when my parents come over".
fn clause(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let said = i..end(tokens, i);
    let of_reason = matches!(word(tokens, i), "because" | "since" | "although" | "though");
    let of_time = matches!(word(tokens, i), "when" | "whenever" | "while" | "before" | "after" | "until" | "once");
    let of_aim = word(tokens, i) == "so" && !matches!(word(tokens, i + 1), "that" | "we" | "i");
    let who = i + 1;
    let acts = |at: usize| word(tokens, at).ends_with("ing") && word(tokens, at).len() > 5;
    let tells = match () {
        () if of_reason => tokens.get(who).is_some_and(Token::word),
        () if of_time => somebody(tokens, who).is_some() || acts(who),
        () if of_aim => somebody(tokens, who).is_some_and(|end| does(tokens, end)),
        () => false,
    };
    let asks = tokens[said.clone()].iter().any(|t| ASKS.contains(&t.text.as_str()) || turns(t));
    let asks = asks || (i..said.end).any(|k| word(tokens, k) == "come" && word(tokens, k + 1) == "in");
    (tells && said.len() > 2 && said.len() <= LONGEST && !asks).then_some(said)
}

/// Numbers belong to demands.
fn turns(t: &Token) -> bool {
    matches!(t.kind, WordKind::Number(_)) || !t.is("in") && super::number::unit(&t.text).is_some()
}

/// "They", "my parents", "the movers": where the words for somebody end.
fn somebody(tokens: &[Token], i: usize) -> Option<usize> {
    if matches!(word(tokens, i), "i" | "we" | "he" | "she" | "they" | "people" | "everyone" | "everybody" | "nobody") {
        return Some(i + 1);
    }
    let lexicon = get();
    let the = lexicon.is(word(tokens, i), Class::Def) || lexicon.is(word(tokens, i), Class::Det);
    let person = |k: usize| {
        let who = word(tokens, k);
        let one = singular(who);
        let known = || lexicon.noun(&one).is_some();
        lexicon.is(who, Class::Person)
            || lexicon.is(&one, Class::Person)
            || sense(who) == Some(Sense::Person) && !known()
    };
    (i + usize::from(the)..i + 3).find(|k| person(*k)).map(|k| k + 1)
}

/// Whether a verb comes that the reader does not have: "feels", "can watch".
fn does(tokens: &[Token], i: usize) -> bool {
    let verb = word(tokens, i);
    matches!(verb, "can" | "could" | "will" | "feels" | "feel" | "know" | "knows" | "do" | "does")
        || sense(&singular(verb)) == Some(Sense::Verb)
}

/// "A dorm room for a segmentation dataset", "an office of a think tank": what a room is for, in words that no table has.
fn purpose(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    const MOST: usize = 4;
    let floor = i > 0 && word(tokens, i) == "of" && word(tokens, i - 1) == "floor";
    let after_room = floor || (1..=3).any(|n| i >= n && room_here(&tokens[i - n..i]) == Some(n));
    let article = matches!(word(tokens, i + 1), "a" | "an" | "the" | "my" | "our");
    if !matches!(word(tokens, i), "for" | "of") || !after_room || !article {
        return None;
    }
    let stops = |k: &usize| {
        let w = word(tokens, *k);
        w.is_empty()
            || matches!(w, "with" | "and" | "where" | "in" | "that" | "which")
            || get().relation(&tokens[*k..]).is_some()
    };
    let end = (i + 2..=i + 2 + MOST).find(stops)?;
    let known = |k: usize| {
        let one = singular(word(tokens, k));
        get().known(word(tokens, k)) || scenelang_lang::nouns::noun(&one).is_some() || get().room(&one).is_some()
    };
    // What a room is a room of is around it: "the mess room of a research station".
    let around = word(tokens, i) == "of" && matches!(word(tokens, i + 1), "a" | "an");
    let strange = || !known(end - 1) && (i + 2..end).all(|k| !known(k) || get().is_look(word(tokens, k)));
    (end > i + 2 && (around || strange())).then_some(i..end)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn reasons_times_and_aims_are_left_out() {
        for (text, left, notes) in [
            ("a bathroom with a shower because a tub won't fit, and a bin", "a bathroom with a shower , and a bin", 1),
            ("no cabinets, since all files are held centrally.", "no cabinets , .", 1),
            ("a bedroom planned before the movers come. a bed", "a bedroom planned . a bed", 1),
            ("try a layout before moving anything heavy: a till", "try a layout : a till", 1),
            ("one stool lower so the client feels small; a stove", "one stool lower ; a stove", 1),
            ("a table when my parents stay over, a lamp", "a table , a lamp", 1),
            ("a dorm room for a segmentation dataset: a bed", "a dorm room : a bed", 1),
            (
                "chairs, but keep the cat side and the dog side apart with a low partition",
                "chairs , and a low partition",
                1,
            ),
            ("keep the bed and the desk apart", "keep the bed and the desk apart", 0),
            (
                "the table is round, and please leave the wall beneath the living room window empty, a radiator",
                "the table is round , , a radiator",
                1,
            ),
            (
                "we're having a baby in April and our flat is only 52 m², so I want to see if this is crazy.",
                "our flat is only 52 m ² , .",
                2,
            ),
            ("a chair for putting on his socks, a bed", "a chair , a bed", 1),
            ("a bench to try shoes on in the middle, a mirror", "a bench in the middle , a mirror", 1),
            ("a table to eat at, two chairs", "a table , two chairs", 1),
            ("a shelf to put on the wall", "a shelf to put on the wall", 0),
            ("a room for testing a robot", "a room for testing a robot", 0),
            ("chairs of wood, but please not like souvenir shop, no flags", "chairs of wood , , no flags", 1),
            ("the bar has ten stools and a bartender behind it.", "the bar has ten stools .", 1),
            ("a ward with two welders beside the press, a sink", "a ward , a sink", 1),
            ("a waiting room with a nurse at a desk", "a waiting room with a nurse at a desk", 0),
            ("heist level, a safe", ", a safe", 1),
            ("a world map, a desk", "a world map , a desk", 0),
            ("the ground floor of a provincial bank, a hall", "the ground floor , a hall", 1),
            ("I want to see if a piano fits", "i want to see if a piano fits", 0),
            ("the mess room of an Antarctic research station, a table", "the mess room , a table", 1),
            ("the game is a murder mystery, so put a knife block here", "so put a knife block here", 1),
            ("the game is a chess set", "the game is a chess set", 0),
            ("a desk so you can see the door", "a desk so you can see the door", 0),
            ("hooks when you come in", "hooks when you come in", 0),
            ("a desk, because there is a radiator", "a desk , because there is a radiator", 0),
            ("a garage for one car", "a garage for one car", 0),
            ("a room for a piano", "a room for a piano", 0),
            ("paths of 1 m because she uses a wheelchair", "paths of 1 m because she uses a wheelchair", 0),
            ("so eight benches", "so eight benches", 0),
        ] {
            let mut tokens = tokens(text, 100).0;
            let found = lift(&mut tokens).len();
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!((rest.join(" ").as_str(), found), (left, notes), "{text}");
        }
    }
}
