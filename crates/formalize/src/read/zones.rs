//! Parts of a room that are named by what one does there, from `data/zones.txt`: "an office with a meeting corner" has a
//! table with chairs. Where the request goes on with what such a part has, that alone counts.

use super::lexicon::get;
use super::number;
use super::paraphrase::put;
use super::token::{self, Token};
use crate::brief::Group;
use crate::furnish::kinds::{self, Count, FurnishingKind};
use scenelang_lang::nouns::plural;
use std::sync::OnceLock;

/// What follows the name of an activity.
const PLACES: [&str; 12] =
    ["area", "areas", "corner", "corners", "nook", "nooks", "space", "spaces", "spot", "spots", "zone", "zones"];
/// What precedes such a part in a list of what a room has.
const LISTS: [&str; 11] =
    ["with", "and", "plus", "has", "have", "having", "featuring", "including", "includes", "add", "want"];
/// What precedes the things that such a part has.
const HAS: [&str; 7] = ["with", "has", "having", "featuring", "including", "containing", "holding"];
/// What such a part is called beside its looks.
const PLAIN: [&str; 6] = ["separate", "dedicated", "designated", "distinct", "defined", "extra"];
/// What follows a part that is a room of its own, or of which something else is told.
const OWN: [&str; 5] = ["of", "measuring", "is", "are", "that"];
/// Homes have rooms by these names.
pub(super) const HOMES: [&str; 16] = [
    "apartment",
    "flat",
    "house",
    "condo",
    "cabin",
    "cottage",
    "bungalow",
    "penthouse",
    "villa",
    "loft",
    "townhouse",
    "duplex",
    "maisonette",
    "farmhouse",
    "chalet",
    "mansion",
];
/// The most words of a room's name.
const LONGEST: usize = 4;

/// A line of the table.
struct Zone {
    names: Vec<&'static str>,
    alone: Vec<&'static str>,
    things: Vec<&'static str>,
    present: Vec<&'static str>,
}

fn all() -> &'static [Zone] {
    static ZONES: OnceLock<Vec<Zone>> = OnceLock::new();
    ZONES.get_or_init(|| {
        let lines = include_str!("../../data/zones.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty());
        lines.filter_map(zone).collect()
    })
}

fn zone(line: &'static str) -> Option<Zone> {
    let [names, things, present] = line.split('|').map(str::trim).collect::<Vec<_>>()[..] else { return None };
    let list = |text: &'static str| text.split(',').map(str::trim).collect::<Vec<_>>();
    Some(Zone {
        names: list(names).into_iter().filter(|name| !name.ends_with('*')).collect(),
        alone: list(names).into_iter().filter_map(|name| name.strip_suffix('*')).collect(),
        things: things.split(' ').collect(),
        present: list(present),
    })
}

/// Turns "a meeting corner" into what such a corner has.
pub fn plain(tokens: &mut Vec<Token>) {
    let is_home = tokens.iter().any(|t| HOMES.iter().any(|home| t.is(home)));
    fronted(tokens);
    let mut i = 0;
    while i < tokens.len() {
        // A home has rooms by the names of areas, but a corner is in one of them.
        if is_home && !tokens.get(i + 1).is_some_and(|t| t.is("corner") || t.is("nook")) {
            i += 1;
            continue;
        }
        two_groups(tokens, i);
        // "I want a reading nook": that is the room.
        if let Some((zone, end)) = named(tokens, i)
            && let Some(from) = begin(tokens, i)
            && let Some((at, kind)) = room_of(&tokens[..from])
            // "A hotel with a lobby, a lounge and a bar": rooms, each of them.
            && (end > i + 1 || begin(tokens, at).is_none())
            && !is_told_of(tokens, i, end)
        {
            replace(tokens, zone, kind, from, end);
        } else if let Some(words) = thing(tokens, i)
            && let Some(from) = begin(tokens, i)
            && room_of(&tokens[..from]).is_some()
        {
            let name: Vec<String> = tokens[i..i + words].iter().map(|t| t.text.clone()).collect();
            let name: Vec<&str> = std::iter::once("a").chain(name.iter().map(String::as_str)).collect();
            put(tokens, from, i + words + 1, &name);
        }
        i += 1;
    }
}

/// Whether a part is spoken of again with its name: "The waiting area has six chairs" tells what is in it.
fn is_told_of(tokens: &[Token], from: usize, end: usize) -> bool {
    let is_again = |at: usize| (0..end - from).all(|k| tokens[at + k].text == tokens[from + k].text);
    let told = |at: &usize| is_again(*at) && ["a", "an", "the"].iter().any(|article| tokens[at - 1].is(article));
    // "The lounge has a sofa", of a lounge area.
    let name = &tokens[from..end - 1];
    let short = |at: usize| {
        let is_same =
            tokens.get(at..at + name.len()).is_some_and(|said| said.iter().zip(name).all(|(a, b)| a.is(&b.text)));
        let after = tokens.get(at + name.len()).map_or("", |t| t.text.as_str());
        let starts = tokens[at - 1].is("the") || matches!(tokens[at - 1].kind, token::WordKind::Sign('.' | ','));
        is_same && starts && !name.is_empty() && (after == "room" || HAS.contains(&after) || after == "is")
    };
    (end + 1..(tokens.len() + from + 1).saturating_sub(end)).any(|at| told(&at)) || (end + 1..tokens.len()).any(short)
}

/// Turns "a reading corner in a bedroom", with which a request begins, into "a bedroom with a reading corner".
fn fronted(tokens: &mut Vec<Token>) {
    let is_article = |t: &Token| ["a", "an", "the", "my", "our"].iter().any(|word| t.is(word));
    let ends = |t: &Token| !t.word() || HAS.iter().chain(&LISTS).chain(&OWN).any(|word| t.is(word));
    let Some(from) = tokens.iter().take(LONGEST).position(|t| t.is("a") || t.is("an")) else { return };
    let placed = tokens[from..].iter().take(LONGEST + 2).position(|t| PLACES.iter().any(|place| t.is(place)));
    let Some(zone) = placed.map(|n| from + n + 1) else { return };
    let is_zone = (from + 1..zone).any(|i| named(tokens, i).is_some_and(|(_, to)| to == zone));
    let is = |at: usize, words: &[&str]| {
        words.iter().enumerate().all(|(k, word)| tokens.get(at + k).is_some_and(|t| t.is(word)))
    };
    // "In the corner of a bedroom".
    let end =
        zone + if is(zone, &["in", "the", "corner", "of"]) || is(zone, &["in", "a", "corner", "of"]) { 3 } else { 0 };
    let leads = is(end, &["in"]) || is(end, &["of"]);
    if !is_zone || !leads || !tokens.get(end + 1).is_some_and(is_article) {
        return;
    }
    let to = tokens[end + 1..].iter().position(ends).map_or(tokens.len(), |n| end + 1 + n);
    if to > end + 2 && to <= end + 2 + LONGEST && kind(&tokens[end + 1..to]).is_some() {
        let mut with = tokens[end].clone();
        "with".clone_into(&mut with.text);
        let room = tokens[end + 1..to].to_vec();
        let zone = tokens[from..end].to_vec();
        tokens.splice(from..to, room.into_iter().chain([with]).chain(zone));
    }
}

/// "Two seating areas": a sofa with what goes with it, and a smaller one.
fn two_groups(tokens: &mut Vec<Token>, i: usize) {
    const SEATS: [&str; 6] = ["seating", "sitting", "lounge", "lounging", "conversation", "sofa"];
    const PLACES: [&str; 5] = ["areas", "groups", "corners", "zones", "spaces"];
    let is = |at: usize, any: &[&str]| tokens.get(at).is_some_and(|t| any.iter().any(|word| t.is(word)));
    let end = i + 2 + usize::from(is(i + 1, &PLAIN));
    let listed = i > 0 && (is(i - 1, &LISTS) || matches!(tokens[i - 1].kind, token::WordKind::Sign(',')));
    if listed && is(i, &["two"]) && is(end - 1, &SEATS) && is(end, &PLACES) {
        put(tokens, i, end + 1, &["a", "sofa", "and", "a", "loveseat"]);
    }
}

/// The part of a room whose name begins at a word, and where the name ends.
fn named(tokens: &[Token], i: usize) -> Option<(&'static Zone, usize)> {
    let first = tokens.get(i).filter(|t| t.word())?;
    let placed = tokens.get(i + 1).is_some_and(|t| t.word() && PLACES.iter().any(|place| t.is(place)));
    all().iter().find_map(|zone| {
        if placed && zone.names.iter().any(|name| first.is(name)) {
            return Some((zone, i + 2));
        }
        let said =
            |name: &&&str| name.split(' ').enumerate().all(|(k, word)| tokens.get(i + k).is_some_and(|t| t.is(word)));
        zone.alone.iter().find(said).map(|name| (zone, i + name.split(' ').count()))
    })
}

/// Of how many words the name of a thing is that stands on the floor, if its area is spoken of: "a piano corner" has a piano.
fn thing(tokens: &[Token], i: usize) -> Option<usize> {
    const AREAS: [&str; 4] = ["area", "corner", "nook", "zone"];
    let stands = |group| matches!(group, Group::Seat | Group::Table | Group::Bed | Group::Storage | Group::Floor);
    let words = (1..LONGEST).find(|n| tokens.get(i + n).is_some_and(|t| AREAS.iter().any(|area| t.is(area))))?;
    let told = tokens.get(i + words + 1).is_some_and(|t| HAS.iter().chain(&OWN).any(|word| t.is(word)));
    let name: Vec<&str> = tokens[i..i + words].iter().map(|t| t.text.as_str()).collect();
    (!told && get().noun(&name.join(" ")).is_some_and(stands)).then_some(words)
}

/// Where the noun phrase begins whose noun is such a part: at an article that follows a word of a list.
fn begin(tokens: &[Token], i: usize) -> Option<usize> {
    let mut from = i;
    while from > 0 && (get().is_look(&tokens[from - 1].text) || PLAIN.iter().any(|word| tokens[from - 1].is(word))) {
        from -= 1;
    }
    let article = from.checked_sub(1).filter(|k| tokens[*k].is("a") || tokens[*k].is("an"))?;
    let before = tokens.get(article.checked_sub(1)?)?;
    let listed = matches!(before.kind, token::WordKind::Sign(',')) || LISTS.iter().any(|word| before.is(word));
    listed.then_some(article)
}

fn replace(tokens: &mut Vec<Token>, zone: &Zone, kind: &FurnishingKind, from: usize, end: usize) {
    let next = tokens.get(end).map_or("", |t| t.text.as_str());
    if HAS.contains(&next) && tokens.get(end + 1).is_some_and(Token::word) {
        // "A reading corner with an armchair": the armchair.
        let first = tokens[end + 1].text.clone();
        if tokens[end - 1].is("corner") {
            on_rug(tokens, end + 2);
        }
        return put(tokens, from, end + 2, &[&first]);
    }
    let told = OWN.contains(&next) || number::count(&tokens[end.min(tokens.len())..]).is_some();
    let mut there = kind.lines.iter().filter(|line| line.least == 0.0 && zone.present.contains(&line.noun));
    match there.next() {
        _ if told => {}
        // "A play corner": its mat is in a corner.
        None if tokens[end - 1].is("corner") && zone.things.starts_with(&["a", "play", "mat"]) => {
            put(tokens, from, end, &[&["a", "play", "mat", "in", "a", "corner"], &zone.things[3..]].concat());
        }
        None => put(tokens, from, end, &zone.things),
        // What such rooms have anyway is asked for then.
        Some(line) if line.count == Count::Fixed(1) => {
            let words: Vec<&str> = std::iter::once("a").chain(line.noun.split(' ')).collect();
            put(tokens, from, end, &words);
        }
        Some(line) => {
            let words: Vec<&str> = line.noun.split(' ').collect();
            let several = plural(words[words.len() - 1]);
            put(tokens, from, end, &[&words[..words.len() - 1], &[several.as_str()]].concat());
        }
    }
}

/// "A reading corner with a rug and cushions": the rug is in a corner, and the cushions are on it.
fn on_rug(tokens: &mut Vec<Token>, i: usize) {
    let noun = |tokens: &[Token], i: usize, any: &[&str]| {
        let found = (i..tokens.len().min(i + LONGEST)).find(|k| any.iter().any(|word| tokens[*k].is(word)))?;
        (i..found).all(|k| get().is_look(&tokens[k].text)).then_some(found + 1)
    };
    let ends =
        |tokens: &[Token], at: usize| tokens.get(at).is_none_or(|t| !t.word() || LISTS.iter().any(|word| t.is(word)));
    let Some(rug) = noun(tokens, i, &["rug", "carpet", "mat"]).filter(|at| ends(tokens, *at)) else { return };
    let soft = tokens.get(rug).filter(|t| t.is("and")).and_then(|_| {
        let first = rug + 1 + usize::from(tokens.get(rug + 1).is_some_and(|t| t.is("some")));
        let first = first + usize::from(number::count(&tokens[first.min(tokens.len())..]).is_some());
        noun(tokens, first, &["cushions", "pillows"]).filter(|at| ends(tokens, *at))
    });
    let mut insert = |at: usize, words: &[&str]| {
        let copy = tokens[at - 1].clone();
        let new = words.iter().map(|word| Token { text: (*word).to_owned(), ..copy.clone() });
        tokens.splice(at..at, new.collect::<Vec<_>>());
    };
    if let Some(soft) = soft {
        insert(soft, &["on", "it"]);
    }
    insert(rug, &["in", "a", "corner"]);
}

/// The kind of the room in which a part is, and where its name begins: the room that was named last. "A hotel lobby with a bar and a
/// lounge" has a bar to stand at.
fn room_of(tokens: &[Token]) -> Option<(usize, &'static FurnishingKind)> {
    let last = kind(tokens)?;
    let is_thing = |at: usize| {
        tokens[at..].iter().take(2).any(|t| t.word() && get().noun_ending(std::slice::from_ref(&t.text)).is_some())
    };
    let (mut end, mut main) = (tokens.len(), Some(last));
    while let Some((at, _)) = main {
        match begin(tokens, at) {
            None => return main,
            Some(article) if article < end && is_thing(at) => end = article,
            Some(_) => break,
        }
        main = kind(&tokens[..end]);
    }
    Some(last)
}

/// The kind of the room that was named last, and where its name begins.
fn kind(tokens: &[Token]) -> Option<(usize, &'static FurnishingKind)> {
    (0..tokens.len()).rev().find_map(|last| {
        let from = |first: usize| tokens[first..=last].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
        let found = kinds::of(&from(last.saturating_sub(LONGEST - 1)))?;
        let begins = |first: &usize| {
            kinds::of(&from(*first)).is_some_and(|kind| kind.name == found.name) && tokens[*first].word()
        };
        let article = (0..last).rev().find(|k| tokens[*k].is("a") || tokens[*k].is("an")).map_or(0, |k| k + 1);
        Some((article.min(last), found)).filter(|(at, _)| begins(at)).or(Some((last, found)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read() {
        let lines = include_str!("../../data/zones.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty());
        assert_eq!(lines.count(), all().len());
        for zone in all() {
            for noun in &zone.present {
                let last = noun.split(' ').next_back().unwrap_or("");
                assert_eq!(crate::read::lexicon::singular(&plural(last)), last);
            }
            let noun = zone.present.iter().find(|noun| scenelang_lang::nouns::noun(noun).is_none());
            assert_eq!(noun, None, "{:?}", zone.names);
        }
    }

    #[test]
    fn a_part_of_a_room_is_what_it_has() {
        for (text, becomes) in [
            ("an office with a meeting corner", "an office with a round table"),
            ("a bedroom with a cozy reading nook by the window", "a bedroom with a reading chair by the window"),
            ("a classroom with a reading corner with a rug", "a classroom with a rug in a corner"),
            (
                "a hall with a play corner with a blue rug and two cushions.",
                "a hall with a blue rug in a corner and two cushions on it .",
            ),
            ("a bedroom with a desk and a play area", "a bedroom with a desk and a play mat and a toy box"),
            ("a reading corner in my bedroom, with a lamp", "my bedroom with a reading chair , with a lamp"),
            ("a work area in the corner of a bedroom", "a bedroom with a desk in the corner"),
            ("a cosy reading corner in a bedroom with an armchair", "a bedroom with an armchair"),
            ("a pizzeria with an open kitchen", "a pizzeria with a kitchen counter"),
            ("a living room with a workspace", "a living room with a desk"),
            ("a hotel lobby with two seating areas", "a hotel lobby with a sofa and a loveseat"),
            ("a lounge with two separate seating groups and a bar", "a lounge with a sofa and a loveseat and a bar"),
            ("a hotel lobby with a bar and a lounge", "a hotel lobby with a bar and a sofa"),
            // What such rooms have anyway.
            ("a bookshop with a reading corner", "a bookshop with a reading chair"),
            ("a bakery with a seating area", "a bakery with cafe tables"),
            ("a bank with a waiting area", "a bank with waiting chairs"),
            // The area of a thing.
            ("a gym with treadmills and a locker area", "a gym with treadmills and three lockers and a locker bench"),
            ("a lounge with a piano corner", "a lounge with a piano"),
            ("a lounge with a pool table area and a bar", "a lounge with a pool table and a bar"),
            // What is a room.
            ("i want a reading nook with a bookshelf", "i want a reading nook with a bookshelf"),
            (
                "we need a plan and an office space with four desks",
                "we need a plan and an office space with four desks",
            ),
            ("an apartment with a dining area", "an apartment with a dining area"),
            ("a one-bedroom flat with a study corner", "a one-bedroom flat with a desk"),
            ("a cafe. The dining area is 4 m wide", "a cafe . the dining area is 4 m wide"),
        ] {
            let mut tokens = token::tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
