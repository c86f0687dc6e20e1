//! Rooms that a request counts before it names them: "two rooms, a bedroom and a bathroom", "a clinic made of two rooms. The
//! waiting room has …", "room one: a bed. Room two: a sofa"; and a place that is no room of its own: "a workshop in my garage".

use super::lexicon::{get, singular};
use super::number::{count, small};
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use crate::furnish::kinds;
use std::ops::Range;

/// The most words of a room's name.
const LONGEST: usize = 3;
/// What a room is that has one of these, the first that fits.
const BY_CONTENTS: [(&str, &[&str]); 6] = [
    ("bedroom", &["bed", "beds", "bunk", "crib", "cot"]),
    ("bathroom", &["bathtub", "shower", "toilet", "bath"]),
    ("kitchen", &["stove", "fridge", "oven", "hob", "cooker"]),
    ("living room", &["sofa", "couch", "tv", "television"]),
    ("dining room", &["dining"]),
    ("office", &["desk", "desks", "computer"]),
];
const ORDINALS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];
/// Where a room may be without being one.
const PLACES: [&str; 40] = [
    "garage",
    "basement",
    "cellar",
    "attic",
    "loft",
    "shed",
    "barn",
    "outbuilding",
    "backyard",
    "house",
    "home",
    "flat",
    "apartment",
    "building",
    "village",
    "town",
    "castle",
    "gatehouse",
    "palace",
    "monastery",
    "tower",
    "lighthouse",
    "mansion",
    "villa",
    "manor",
    "cottage",
    "farmhouse",
    "skyscraper",
    "train",
    "ship",
    "boat",
    "yacht",
    "submarine",
    "spaceship",
    "plane",
    "airport",
    "station",
    "mall",
    "harbour",
    "mine",
];

/// What is said of what is left out.
const PLACE: &str = "the position of a room among the others is ignored; doors connect the rooms";
const AROUND: &str = "what the room is part of is ignored";

/// Turns what is said so; what is left out, by its bytes.
pub fn plain(tokens: &mut Vec<Token>) -> Vec<(Range<usize>, String)> {
    let around = within(tokens).map(|at| (at, AROUND.to_owned()));
    sized(tokens);
    let _found = (0..tokens.len()).any(|i| beds_and_baths(tokens, i));
    master(tokens);
    of_so_many(tokens);
    each_is(tokens);
    listed_with(tokens);
    labelled(tokens);
    named_later(tokens);
    around.into_iter().chain(placed(tokens)).collect()
}

/// "The treatment room behind it has two tables", "the waiting room at the front has six chairs": the room has them.
fn placed(tokens: &mut Vec<Token>) -> Vec<(Range<usize>, String)> {
    let has = |k: usize| matches!(word(tokens, k), "has" | "have" | "contains" | "needs" | "gets" | "with");
    let among = |k: usize| match [word(tokens, k), word(tokens, k + 1), word(tokens, k + 2)] {
        ["behind" | "beside" | "opposite" | "after" | "above" | "below", "it" | "that", _] => Some(k + 2),
        ["next" | "adjacent", "to" | "door", "it"] => Some(k + 3),
        ["at", "the", "front" | "back" | "rear" | "end" | "entrance"] => Some(k + 3),
        ["in", "front", _] | ["next", "door", _] => Some(k + 2),
        _ => None,
    };
    let found: Vec<Range<usize>> = (0..tokens.len())
        .filter(|k| starts(tokens, *k) && matches!(word(tokens, *k), "the" | "a"))
        .filter_map(|k| room(tokens, k + 1))
        .filter_map(|k| among(k).filter(|end| has(*end)).map(|end| k..end))
        .collect();
    let bytes = |range: &Range<usize>| tokens[range.start].at.start..tokens[range.end - 1].at.end;
    let notes = found.iter().map(|range| (bytes(range), PLACE.to_owned())).collect();
    found.into_iter().rev().for_each(|range| drop(tokens.drain(range)));
    notes
}

fn starts(tokens: &[Token], i: usize) -> bool {
    i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';' | '!' | '?'))
}

/// Where the name of a room ends that begins at a token.
pub(super) fn room(tokens: &[Token], i: usize) -> Option<usize> {
    let named = |n: &usize| {
        let name: Vec<String> = (i..i + n).map(|k| word(tokens, k).to_owned()).collect();
        let whole = name.join(" ");
        !name.iter().any(|word| matches!(word.as_str(), "" | "the" | "a" | "with" | "in" | "of"))
            && (get().room(&whole).is_some() || kinds::named(&whole).is_some())
            && get().noun(&whole).is_none()
    };
    (1..=LONGEST).rev().find(named).map(|n| i + n)
}

/// A number of rooms: "two rooms".
pub(super) fn several(tokens: &[Token], i: usize) -> Option<usize> {
    let (n, used) = count(tokens.get(i..i + 1)?)?;
    let is_number = used == 1 && n.fract() == 0.0 && (2.0..=6.0).contains(&n);
    (is_number && matches!(word(tokens, i + 1), "rooms" | "spaces" | "areas")).then_some(n as usize)
}

/// "A woodworking shop in my garage": one room. Where it is, in bytes.
fn within(tokens: &mut Vec<Token>) -> Option<Range<usize>> {
    const HEAD: usize = 10;
    let said = (1..tokens.len().min(HEAD)).find_map(|i| {
        let owned = matches!(word(tokens, i + 1), "my" | "our" | "the" | "a" | "an" | "his" | "her" | "their");
        // "Under a castle gatehouse", "on a luxury train", "of an old lighthouse".
        let there =
            matches!(word(tokens, i), "in" | "inside" | "under" | "beneath" | "below" | "aboard" | "on" | "of" | "at");
        if !there || !owned {
            return None;
        }
        let spare = |k: usize| {
            let is_spare = matches!(word(tokens, k), "spare" | "old" | "guest");
            is_spare && matches!(word(tokens, k + 1), "bedroom" | "room" | "office")
        };
        let ends = |k: usize| {
            let after = word(tokens, k + 1);
            tokens.get(k + 1).is_none_or(|t| !t.word()) || matches!(after, "with" | "for" | "that")
        };
        let is_place = |k: &usize| PLACES.contains(&word(tokens, *k)) || *k > i + 2 && spare(*k - 1);
        let place = (i + 2..i + 5).filter(is_place).find(|k| ends(*k))?;
        let after = word(tokens, place + 1);
        // "A wedding reception for 80 guests in a barn".
        let before = (i.saturating_sub(4)..i).find(|k| word(tokens, *k) == "for").unwrap_or(i);
        let named = (before.saturating_sub(LONGEST)..before).any(|from| room(tokens, from) == Some(before));
        // "In a barn that is 40 feet by 70 feet": so large is the room.
        let that = usize::from(after == "that" && tokens.get(place + 2).is_some_and(|t| !t.word()));
        named.then_some(i..place + 1 + that)
    })?;
    let at = tokens[said.start].at.start..tokens[said.end - 1].at.end;
    tokens.drain(said);
    Some(at)
}

/// "My living room is 14 by 18 ft, grey sofa": so large is the room, and not the sofa.
fn sized(tokens: &mut [Token]) {
    const ENDS: [&str; 6] = ["room", "kitchen", "office", "space", "it", "shop"];
    let number = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let by = |k: usize| matches!(word(tokens, k), "by" | "x" | "×");
    let comma = (1..tokens.len()).find_map(|i| {
        let about = usize::from(matches!(word(tokens, i + 1), "about" | "around" | "roughly"));
        let first = i + 1 + about;
        let said = word(tokens, i) == "is" && ENDS.iter().any(|end| word(tokens, i - 1).ends_with(end));
        // "14 ft by 18 ft", "14 by 18 ft".
        let unit = usize::from(!by(first + 1));
        let second = first + 2 + unit;
        let sized = said && number(first) && by(first + 1 + unit) && number(second);
        (sized && tokens.get(second + 2).is_some_and(|t| t.is(","))).then_some(second + 2)
    });
    if let Some(comma) = comma {
        tokens[comma].text = ".".to_owned();
        tokens[comma].kind = WordKind::Sign('.');
    }
}

/// "Three rooms: a reception with a desk, an exam room with a table, and an office with two desks": the reception room has a desk.
fn listed_with(tokens: &mut Vec<Token>) {
    let Some((i, n)) = (0..tokens.len()).find_map(|i| Some((i, several(tokens, i)?))) else { return };
    if !tokens.get(i + 2).is_some_and(|t| t.is(":")) {
        return;
    }
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!'));
    let end = tokens[i..].iter().position(stops).map_or(tokens.len(), |n| i + n);
    // Where the rooms of the list begin: an article after the colon or a comma, a name of one to three words, "with".
    let head = |k: usize| {
        let and = usize::from(word(tokens, k) == "and");
        let article = matches!(word(tokens, k + and), "a" | "an" | "one" | "the");
        let with = (k + and + 2..k + and + 5).find(|k| word(tokens, *k) == "with")?;
        let name = k + and + 1..with;
        let is_room = room(tokens, name.start) == Some(with)
            || matches!(word(tokens, with - 1), "reception" | "lobby" | "office" | "kitchen" | "room" | "area");
        (article && is_room).then_some((k, name, with))
    };
    let heads: Vec<(usize, Range<usize>, usize)> =
        (i + 3..end).filter(|k| tokens[k - 1].is(":") || tokens[k - 1].is(",")).filter_map(head).collect();
    if heads.len() != n {
        return;
    }
    for (from, name, with) in heads.into_iter().rev() {
        let mut words: Vec<String> = name.map(|k| word(tokens, k).to_owned()).collect();
        if words.last().is_some_and(|word| word == "reception") {
            words.push("room".to_owned());
        }
        let words: Vec<&str> =
            [".", "the"].into_iter().chain(words.iter().map(String::as_str)).chain(["has"]).collect();
        put(tokens, from - 1, with + 1, &words);
        tokens[from - 1].kind = WordKind::Sign('.');
    }
    // What they are rooms of is a building.
    let begin = (0..i).rev().find(|k| starts(tokens, *k)).unwrap_or(0);
    if tokens[begin..i].iter().all(Token::word) && i - begin <= 6 {
        put(tokens, begin, i + 2, &["a", "building"]);
    } else {
        tokens.drain(i..i + 2);
    }
}

/// "An office suite of three rooms" is a building with three rooms, and so is "a three-room office: …". Where rooms are counted, a
/// reception is one of them.
fn of_so_many(tokens: &mut Vec<Token>) {
    const OF: [&str; 6] = ["made", "consisting", "consists", "comprised", "composed", "comprising"];
    hyphened(tokens);
    let Some(i) = (1..tokens.len()).find(|i| several(tokens, *i).is_some()) else { return };
    let of = match word(tokens, i - 1) {
        "of" => i - 1 - usize::from(i > 1 && OF.contains(&word(tokens, i - 2))),
        "with" | "has" | "having" | "comprising" | "containing" => i - 1,
        _ => i,
    };
    // "Made of two rooms" that are all named later is read below.
    let from = (0..of).rev().find(|k| starts(tokens, *k) || matches!(word(tokens, *k), "a" | "an" | "my" | "our"));
    let named = from.filter(|from| of > *from && of - from <= LONGEST + 1 && (*from..of).all(|k| tokens[k].word()));
    let listed = tokens.get(i + 2).is_some_and(|t| matches!(t.kind, WordKind::Sign(',' | ':' | '—' | '.')));
    let counted = of < i && listed && word(tokens, i - 1) == "of" && (of + 1 == i || !stops(tokens, i + 2));
    if let (Some(_), true) = (named, counted) {
        put(tokens, of, i, &["with"]);
        if matches!(word(tokens, of - 1), "suite" | "unit" | "complex") {
            let two = usize::from(of > 1 && get().room(word(tokens, of - 2)).is_some());
            put(tokens, of - 1 - two, of, &["building"]);
        }
    }
    // "A kitchen area" is a room of its own where rooms are counted.
    for k in (i + 2..tokens.len().saturating_sub(1)).rev() {
        if matches!(word(tokens, k), "kitchen" | "waiting" | "reception") && word(tokens, k + 1) == "area" {
            let name = tokens[k].text.clone();
            let words = [name.as_str(), "room"];
            put(tokens, k, k + 2, &words[..if name == "kitchen" { 1 } else { 2 }]);
        }
    }
    let goes_on =
        |k: usize| matches!(word(tokens, k), "desk" | "area" | "room" | "counter" | "stand" | "hall" | "table");
    let is_room = |k: &usize| {
        let before = k.checked_sub(1).map_or("", |k| tokens[k].text.as_str());
        let begins = matches!(before, "a" | "the" | "one" | "," | ":" | "." | "and" | "—" | "\n");
        tokens[*k].is("reception") && begins && !goes_on(k + 1)
    };
    for k in (0..tokens.len()).rev().filter(is_room).collect::<Vec<_>>() {
        put(tokens, k, k + 1, &["reception", "room"]);
    }
}

/// "The master has a bed", in a home: the master bedroom.
fn master(tokens: &mut Vec<Token>) {
    let has = |k: usize| matches!(word(tokens, k), "has" | "gets" | "needs" | "contains" | "with");
    let is_home = |t: &Token| t.text.contains("bedroom") || super::several::is_home(&t.text);
    let said = (1..tokens.len()).find(|k| {
        word(tokens, k - 1) == "the" && word(tokens, *k) == "master" && has(k + 1) && tokens[..*k].iter().any(is_home)
    });
    if let Some(master) = said {
        put(tokens, master, master + 1, &["master", "bedroom"]);
    }
}

fn stops(tokens: &[Token], i: usize) -> bool {
    tokens.get(i).is_none_or(Token::stops)
}

/// "A two-bed, two-bath apartment", "a 3 bed 2 bath house": a two-bedroom apartment with two bathrooms.
fn beds_and_baths(tokens: &mut Vec<Token>, i: usize) -> bool {
    let counted = |k: usize, nouns: &[&str]| -> Option<(String, usize)> {
        let text = tokens.get(k)?.text.as_str();
        let number = |text: &str| text.parse::<usize>().ok().or_else(|| small(text).map(|n| n as usize));
        if let Some((n, noun)) = text.split_once('-') {
            return (nouns.contains(&noun) && number(n).is_some()).then(|| (n.to_owned(), k + 1));
        }
        (nouns.contains(&word(tokens, k + 1)) && number(text).is_some()).then(|| (text.to_owned(), k + 2))
    };
    let Some((beds, next)) = counted(i, &["bed", "beds", "bedroom", "bedrooms", "br"]) else { return false };
    let joins = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.text.as_str(), "," | "/" | "and" | "&"));
    let bath = next + usize::from(joins(next));
    let baths = counted(bath, &["bath", "baths", "bathroom", "bathrooms", "ba"]);
    let home = baths.as_ref().map_or(next, |(_, end)| *end);
    if !super::several::is_home(word(tokens, home)) {
        return false;
    }
    let like = tokens[i].clone();
    let name = word(tokens, home).to_owned();
    let mut said = vec![like.saying(&format!("{beds}-bedroom")), tokens[home].saying(&name)];
    let with = word(tokens, home + 1) == "with";
    if let Some((n, _)) = baths {
        let number = match n.parse::<f64>() {
            Ok(value) => Token { kind: WordKind::Number(value), ..like.saying(&n) },
            Err(_) => like.saying(&n),
        };
        let one = matches!(n.as_str(), "1" | "one");
        said.extend([like.saying("with"), number, like.saying(if one { "bathroom" } else { "bathrooms" })]);
        said.extend(with.then(|| tokens[home + 1].saying(",")).map(|t| Token { kind: WordKind::Sign(','), ..t }));
    }
    let end = home + 1 + usize::from(with && said.len() > 2);
    tokens.splice(i..end, said);
    true
}

/// "A three-room office: a reception, …", where the rooms are named: an office with three rooms.
fn hyphened(tokens: &mut Vec<Token>) {
    let said = (0..tokens.len()).find_map(|i| {
        let number = tokens[i].text.strip_suffix("-room")?.to_owned();
        let (name, used) = (i + 1, 1 + usize::from(room(tokens, i + 2) == Some(i + 3)));
        let listed = tokens.get(name + used).is_some_and(|t| matches!(t.kind, WordKind::Sign(':' | '—')));
        (listed && get().room(word(tokens, name + used - 1)).is_some()).then_some((i, number, name + used))
    });
    let Some((i, number, end)) = said else { return };
    let like = tokens[i].clone();
    let number = match number.parse::<f64>() {
        Ok(n) => Token { kind: WordKind::Number(n), ..like.saying(&number) },
        Err(_) => like.saying(&number),
    };
    let name = word(tokens, end - 1).to_owned();
    tokens.splice(end..end, [like.saying("with"), number, like.saying("rooms")]);
    if !super::several::is_home(&name) {
        put(tokens, i + 1, end, &["building"]);
    }
    tokens.remove(i);
    if !starts(tokens, i) || matches!(word(tokens, i), "a" | "an") {
        return;
    }
    tokens.insert(i, like.saying("a"));
}

/// "An office of three rooms. The first is a reception, the second one is an office with a desk": a reception, an office with a
/// desk.
fn each_is(tokens: &mut Vec<Token>) {
    let Some(counted) = (0..tokens.len()).find(|i| several(tokens, *i).is_some()) else { return };
    let is_which = |text: &str| text == "the" || ORDINALS.contains(&text) || matches!(text, "last" | "other");
    let said = |i: usize| {
        if is_which(word(tokens, i - 1)) {
            return None;
        }
        let the = usize::from(word(tokens, i) == "the");
        let which = word(tokens, i + the);
        let nth = ORDINALS.contains(&which) || matches!(which, "last" | "other" | "one" | "another");
        let one = i + the + 1 + usize::from(matches!(word(tokens, i + the + 1), "one" | "room"));
        let is = match [word(tokens, one), word(tokens, one + 1)] {
            ["should" | "will" | "must", "be"] => one + 2,
            ["is", _] => one + 1,
            _ => return None,
        };
        let article = matches!(word(tokens, is), "a" | "an" | "the" | "my" | "our" | "for");
        (nth && article && room(tokens, is + 1).is_some()).then_some(i..is)
    };
    let found: Vec<Range<usize>> = (counted + 2..tokens.len()).filter_map(said).collect();
    found.into_iter().rev().for_each(|range| drop(tokens.drain(range)));
}

/// A part of a request that is about one room: its label, and where it ends.
struct Part {
    label: Range<usize>,
    end: usize,
}

/// "Room one: a bed. Room two: a sofa": the bedroom has a bed, and the living room a sofa.
fn labelled(tokens: &mut Vec<Token>) {
    let labels: Vec<Range<usize>> = (0..tokens.len()).filter_map(|i| label(tokens, i)).collect();
    if labels.len() < 2 || labels.len() > ORDINALS.len() {
        return;
    }
    let all = |k: usize| starts(tokens, k) && matches!(word(tokens, k), "both" | "each" | "all" | "the" | "they");
    let part = |(at, label): (usize, &Range<usize>)| {
        let next = labels.get(at + 1).map_or(tokens.len(), |next| next.start);
        Part { label: label.clone(), end: (label.end..next).find(|k| all(*k)).unwrap_or(next) }
    };
    let parts: Vec<Part> = labels.iter().enumerate().map(part).collect();
    let kind_of = |part: &Part| {
        let has = |words: &[&str]| tokens[part.label.end..part.end].iter().any(|t| words.iter().any(|word| t.is(word)));
        BY_CONTENTS.iter().find(|(_, words)| has(words)).map(|(kind, _)| *kind)
    };
    let Some(found) = parts.iter().map(kind_of).collect::<Option<Vec<&str>>>() else { return };
    let alike = |kind: &str| found.iter().filter(|other| **other == kind).count();
    let names: Vec<String> = (0..found.len())
        .map(|at| {
            let nth = found[..at].iter().filter(|other| **other == found[at]).count();
            let which = if alike(found[at]) > 1 { format!("{} ", ORDINALS[nth]) } else { String::new() };
            format!("{which}{}", found[at])
        })
        .collect();
    of_all(tokens, parts.last().map_or(0, |part| part.end), &names);
    for (at, part) in parts.iter().enumerate().rev() {
        let words: Vec<&str> = ["the"].into_iter().chain(names[at].split(' ')).chain(["has"]).collect();
        put(tokens, part.label.start, part.label.end, &words);
    }
    // "Two bedrooms." Rooms of different kinds are named where their parts begin.
    let first = labels[0].start;
    let same = alike(found[0]) == found.len();
    let Some(counted) = (0..first).find(|i| several(tokens, *i).is_some()) else {
        if same {
            let like = Token { at: tokens[first].at.clone(), ..tokens[first].clone() };
            let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..like.clone() };
            let number = new(WordKind::Number(found.len() as f64), &found.len().to_string());
            let words = found[0].split(' ').map(|text| new(WordKind::Word, text));
            let mut said: Vec<Token> = std::iter::once(number).chain(words).collect();
            if let Some(last) = said.last_mut() {
                last.text = scenelang_lang::nouns::plural(&last.text);
            }
            said.push(new(WordKind::Sign('.'), "."));
            tokens.splice(first..first, said);
        }
        return;
    };
    if same {
        let last = found[0].split(' ').next_back().unwrap_or_default();
        let many = scenelang_lang::nouns::plural(last);
        let mut words: Vec<&str> = found[0].split(' ').collect();
        words.pop();
        words.push(&many);
        put(tokens, counted + 1, counted + 2, &words);
    } else {
        tokens.drain(counted..counted + 2);
    }
}

/// "Both rooms are 3 by 4 m", "each one needs a wardrobe", after the parts: a sentence for each room.
fn of_all(tokens: &mut Vec<Token>, from: usize, names: &[String]) {
    let subject = |tokens: &[Token], k: usize| match [word(tokens, k), word(tokens, k + 1)] {
        ["both" | "all", "rooms"] | ["each", "one" | "room" | "of"] => {
            Some(k + 2 + 2 * usize::from(word(tokens, k + 1) == "of"))
        }
        ["both" | "each", "are" | "have" | "need" | "has" | "needs"] => Some(k + 1),
        _ => None,
    };
    let mut k = from;
    while k < tokens.len() {
        let Some(verb) = subject(tokens, k).filter(|verb| starts(tokens, k) && *verb < tokens.len()) else {
            k += 1;
            continue;
        };
        let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | '!' | ';'));
        let end = tokens[verb..].iter().position(stops).map_or(tokens.len(), |n| verb + n);
        let Some(like) = tokens.get(k).cloned() else { return };
        let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..like.clone() };
        let mut said = Vec::new();
        for (at, name) in names.iter().enumerate() {
            if at > 0 {
                said.push(new(WordKind::Sign('.'), "."));
            }
            said.extend(["the"].into_iter().chain(name.split(' ')).map(|text| new(WordKind::Word, text)));
            let mut clause = tokens[verb..end].to_vec();
            if let Some(first) = clause.first_mut() {
                let one = match first.text.as_str() {
                    "are" => "is",
                    "have" => "has",
                    "need" => "needs",
                    other => other,
                };
                first.text = one.to_owned();
            }
            said.extend(clause);
        }
        let length = said.len();
        tokens.splice(k..end, said);
        k += length;
    }
}

/// "Room one:", "room 2:", "first room:", "the second room has".
fn label(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    if !starts(tokens, i) {
        return None;
    }
    let the = usize::from(word(tokens, i) == "the");
    let numbered = |k: usize| {
        tokens.get(k).is_some_and(|t| {
            matches!(t.kind, WordKind::Number(_))
                || matches!(t.text.as_str(), "one" | "two" | "three" | "four" | "a" | "b" | "c")
        })
    };
    let end = match [word(tokens, i + the), word(tokens, i + the + 1)] {
        ["room", _] if numbered(i + the + 1) => i + the + 2,
        [nth, "room"] if ORDINALS.contains(&nth) || nth == "other" => i + the + 2,
        _ => return None,
    };
    let has = tokens.get(end).is_some_and(|t| matches!(t.kind, WordKind::Sign(':' | '-' | '–')))
        || matches!(word(tokens, end), "has" | "with" | "contains" | "needs" | "gets");
    has.then_some(i..end + 1)
}

/// How many rooms a sentence names from here on.
pub(super) fn listed(tokens: &[Token], from: usize) -> usize {
    let end = tokens[from..].iter().position(Token::stops).map_or(tokens.len(), |n| from + n);
    let joins = |k: usize| k == from || matches!(tokens[k - 1].text.as_str(), "," | "and" | "plus");
    let number = |k: usize| match word(tokens, k) {
        "a" | "an" | "one" | "the" | "my" | "our" => Some((1, k + 1)),
        _ => count(&tokens[k..=k]).map(|(n, _)| (n as usize, k + 1)).or(Some((1, k))),
    };
    let named = |k: usize| {
        let (n, name) = number(k)?;
        (0..LONGEST).any(|looks| room(tokens, name + looks).is_some_and(|to| to <= end)).then_some(n)
    };
    (from..end).filter(|k| joins(*k)).filter_map(named).sum()
}

/// "Two rooms please, a bedroom and a bathroom" are these two; so are those of "a clinic made of two rooms. The waiting room has …".
fn named_later(tokens: &mut Vec<Token>) {
    let Some((i, n)) = (0..tokens.len()).find_map(|i| Some((i, several(tokens, i)?))) else { return };
    let please = i + 2 + usize::from(word(tokens, i + 2) == "please");
    let sign = tokens.get(please).is_some_and(|t| matches!(t.kind, WordKind::Sign(',' | ':' | '-' | '–')));
    if sign
        && listed(tokens, please + 1) >= n
        && matches!(word(tokens, please + 1), "a" | "an" | "one" | "the")
        && room(tokens, please + 2).is_some()
    {
        tokens.drain(i..=please);
        return;
    }
    // Rooms that sentences begin with.
    let mut named: Vec<String> = Vec::new();
    for k in (please..tokens.len()).filter(|k| starts(tokens, *k) && matches!(word(tokens, *k), "the" | "a" | "one")) {
        if let Some(end) = room(tokens, k + 1) {
            let name = (k + 1..end).map(|k| singular(word(tokens, k))).collect::<Vec<_>>().join(" ");
            if !named.contains(&name) {
                named.push(name);
            }
        }
    }
    let made = (1..=3).find(|back| {
        i.checked_sub(*back).is_some_and(|k| {
            matches!(
                (word(tokens, k), word(tokens, k + 1), back),
                ("made" | "made-up" | "consisting" | "comprised" | "composed", "of", 2)
                    | ("with" | "has" | "having", _, 1)
            )
        })
    });
    let closed = tokens.get(i + 2).is_none_or(|t| matches!(t.kind, WordKind::Line | WordKind::Sign(_)));
    if let Some(back) = made.filter(|_| named.len() == n && closed) {
        // What they are rooms of is a building.
        let from = (0..i - back).rev().find(|k| starts(tokens, *k)).unwrap_or(0);
        let article = usize::from(matches!(word(tokens, from), "a" | "an" | "the" | "my" | "our"));
        let whole = (from + article..i - back).all(|k| tokens[k].word()) && i - back - from <= 5;
        if whole {
            put(tokens, from, i + 2, &["a", "building"]);
        } else {
            tokens.drain(i - back..i + 2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn counted_rooms_are_those_that_are_named() {
        for (text, becomes) in [
            ("two rooms please, a bedroom and a bathroom.", "a bedroom and a bathroom ."),
            ("two rooms: a bedroom and a bathroom.", "a bedroom and a bathroom ."),
            (
                "physiotherapy clinic made of two rooms. the waiting room at the front has a desk. the treatment room behind it has a table.",
                "a building . the waiting room has a desk . the treatment room has a table .",
            ),
            (
                "a flat with two rooms. the bedroom has a bed. the lamp is red.",
                "a flat with two rooms . the bedroom has a bed . the lamp is red .",
            ),
            (
                "two rooms. room one: a bed, black and blue. room two: a loft bed. both rooms are small.",
                "two bedrooms . the first bedroom has a bed , black and blue . the second bedroom has a loft bed . the first bedroom \
                 is small . the second bedroom is small .",
            ),
            ("room 1: a bed. room 2: a sofa.", "the bedroom has a bed . the living room has a sofa ."),
            (
                "room 1: a bed. room 2: a bed.",
                "2 bedrooms . the first bedroom has a bed . the second bedroom has a bed .",
            ),
            ("room 1: a bed. room 2: a lamp.", "room 1 : a bed . room 2 : a lamp ."),
            ("room 1: a bed. room 2: a sofa. each of", "the bedroom has a bed . the living room has a sofa . each of"),
            ("room 12: a bed.", "room 12 : a bed ."),
            ("woodworking shop in my garage, 6 m long", "woodworking shop , 6 m long"),
            ("home music studio in a spare bedroom, 3 m long", "home music studio , 3 m long"),
            ("my living room is 14 by 18 ft, grey sofa", "my living room is 14 by 18 ft . grey sofa"),
            ("the room is 4 m by 5 m, a sofa", "the room is 4 m by 5 m . a sofa"),
            ("the room is 4 by", "the room is 4 by"),
            (
                "a small clinic with three rooms: a reception with a desk and a chair, an exam room with a stool, and a nurses' office \
                 with two desks. all doors are wide.",
                "a building . the reception room has a desk and a chair . the exam room has a stool . the nurses office has two \
                 desks . all doors are wide .",
            ),
            (
                "an office suite of three rooms, a reception, an open office with a sofa and a meeting room.",
                "an building with a reception room , an open office with a sofa and a meeting room .",
            ),
            (
                "three-room office: reception with a desk and a kitchen",
                "a building with three rooms : reception room with a desk and a kitchen",
            ),
            ("a two-bed, two-bath flat.", "a two-bedroom flat with two bathrooms ."),
            ("a 3 bed 1 bath house with a hall", "a 3-bedroom house with 1 bathroom , a hall"),
            ("a two bed room", "a two bed room"),
            (
                "a law office consisting of two rooms: reception and office.",
                "a law office with two rooms : reception room and office .",
            ),
            (
                "an office with three rooms: an open office with desks, a kitchen area with a table and a waiting area.",
                "an office with an open office with desks , a kitchen with a table and a waiting room .",
            ),
            ("a flat. the master has a bed", "a flat . the master bedroom has a bed"),
            ("the master has a desk", "the master has a desk"),
            ("a three-room flat", "a three-room flat"),
            (
                "an office of two rooms. the first is a meeting room, and the other one should be a kitchen",
                "an office with two rooms . a meeting room , and a kitchen",
            ),
            ("a flat with two rooms: a", "a flat with two rooms : a"),
            ("a home gym in the basement with a bench", "a home gym with a bench"),
            ("a desk in my garage", "a desk in my garage"),
            ("a bedroom in the", "a bedroom in the"),
            ("a clinic made of two rooms", "a clinic made of two rooms"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
