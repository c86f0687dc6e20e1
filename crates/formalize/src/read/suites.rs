//! Rooms that one sentence names one after the other, each with what is in it: "a reception with a shelf, one changing room with
//! lockers, and the main practice room, which should fit 16 mats" is three rooms, and then what each of them has. The business
//! that they belong to ("my yoga studio", "I run a bakery") is the building.

use super::lexicon::{get, singular};
use super::number::count;
use super::token::{Token, WordKind};
use std::ops::Range;

/// The most words of a room's name, with what is said of it.
const LONGEST: usize = 4;
/// What ends the name of a part of a room.
const PARTS: [&str; 11] =
    ["area", "nook", "corner", "space", "alcove", "zone", "place", "interior", "section", "entry", "garden"];
/// A room after one of these is where something is.
const WHERE: [&str; 25] = [
    "in", "of", "to", "from", "between", "behind", "beside", "near", "into", "for", "by", "at", "on", "under", "above",
    "off", "through", "facing", "towards", "inside", "within", "per", "as", "like", "than",
];
/// What precedes the things that a room has.
const HAS: [&str; 9] = ["with", "has", "have", "having", "containing", "featuring", "holds", "contains", "fits"];
/// In so many sentences a home may be said to have rooms.
const SENTENCES: usize = 4;
/// The most words between a room and what it has: "at the front, with".
const BETWEEN: usize = 5;

/// A room that a sentence names.
#[derive(Clone, Debug)]
struct Head {
    /// Its article, name, and what is said of it.
    at: Range<usize>,
    /// Where its name begins.
    name: usize,
    /// How many of it there are, if more than one.
    several: bool,
    /// Where what it has begins.
    has: Option<usize>,
}

/// Takes such sentences apart.
pub fn plain(tokens: &mut Vec<Token>) {
    home(tokens, SENTENCES);
    let mut from = 0;
    while from < tokens.len() {
        let end = tokens[from..].iter().position(Token::stops).map_or(tokens.len(), |n| from + n);
        let heads = heads(tokens, from..end);
        let listed = heads.iter().all(|head| head.has.is_none());
        from = end + 1;
        if heads.len() < 2 {
            continue;
        }
        // A list of rooms that says nothing of them reads well as it is.
        let after_colon = heads[0].at.start > 0 && word(tokens, heads[0].at.start - 1) == ":";
        let furnished = heads.iter().skip(usize::from(heads.len() == 2)).any(|head| head.has.is_some());
        let grown = if furnished && !is_simple(tokens, &heads) {
            split(tokens, &heads, end)
        } else if listed && after_colon {
            0
        } else {
            continue;
        };
        from += grown;
        if let Some((at, words)) = business(tokens, heads[0].at.start) {
            tokens.splice(at, words);
        }
    }
}

/// "A flat. It should have a living room and a bedroom": the flat has them.
fn home(tokens: &mut Vec<Token>, most: usize) {
    const HAVE: [&[&str]; 11] = [
        &["should", "have"],
        &["must", "have"],
        &["needs", "to", "have"],
        &["has", "to", "have"],
        &["will", "have"],
        &["should", "include"],
        &["has"],
        &["needs"],
        &["includes"],
        &["contains"],
        &["consists", "of"],
    ];
    let starts = |k: &usize| *k > 0 && tokens[k - 1].stops();
    let said = (0..tokens.len()).filter(starts).find_map(|it| {
        let is = |words: &&&[&str]| words.iter().enumerate().all(|(k, have)| word(tokens, it + 1 + k) == *have);
        let end = match word(tokens, it) {
            "it" | "this" => it + 1 + HAVE.iter().find(is)?.len(),
            // "Plus a kitchen and a bathroom."
            "plus" | "also" => it + 1 + usize::from(word(tokens, it + 1) == ","),
            "there" => {
                let end = tokens[it..].iter().position(Token::stops).map_or(tokens.len(), |n| it + n);
                let furnished = tokens[it..end].iter().any(|t| HAS.iter().any(|has| t.is(has)));
                let list = tokens[it..end].iter().any(|t| t.is("and"));
                let is = matches!(word(tokens, it + 1), "is" | "are" | "'s");
                (is && list && !furnished).then_some(it + 2)?
            }
            _ => return None,
        };
        let has_room = (end..end + 2).any(|k| room(tokens, k, false).is_some());
        let home = (0..it).rev().find(|k| super::several::is_home(word(tokens, *k)))?;
        has_room.then_some((it..end, home))
    });
    if let Some((at, home)) = said.filter(|_| most > 0) {
        let like = tokens[at.start].clone();
        let name = tokens[home].text.clone();
        tokens.splice(at, ["the", &name, "has"].map(|text| like.saying(text)));
        self::home(tokens, most - 1);
    }
}

/// "A bedroom with a bed and a bathroom with a shower": read as it is.
fn is_simple(tokens: &[Token], heads: &[Head]) -> bool {
    let plain = |head: &Head| {
        let article = matches!(word(tokens, head.at.start), "a" | "an");
        article && head.has.is_none_or(|has| has == head.at.end + 1 && word(tokens, head.at.end) == "with")
    };
    heads.len() == 2 && heads.iter().all(plain) && heads[1].at.start > 1 && !tokens[heads[1].at.start - 1].is("plus")
}

fn heads(tokens: &[Token], within: Range<usize>) -> Vec<Head> {
    let mut heads: Vec<Head> = Vec::new();
    let mut k = within.start;
    while k < within.end {
        let found = head(tokens, k, within.clone(), heads.is_empty());
        k = found.as_ref().map_or(k + 1, |head| head.at.end);
        heads.extend(found);
    }
    // The last of them may be what the others have.
    let each = |head: &Head| matches!(word(tokens, head.at.end), "each" | "both");
    if heads.iter().any(each) { Vec::new() } else { heads }
}

/// A word or a sign.
fn word(tokens: &[Token], i: usize) -> &str {
    tokens.get(i).map_or("", |t| t.text.as_str())
}

/// The room that is named here as the first of a list, or as the next.
fn head(tokens: &[Token], k: usize, within: Range<usize>, is_first: bool) -> Option<Head> {
    let before = k.checked_sub(1).map_or("", |k| word(tokens, k));
    let joined = matches!(before, "," | "and" | "plus" | "then" | ":") || k == within.start;
    let article = matches!(word(tokens, k), "a" | "an" | "one" | "the" | "my" | "our");
    let number = count(tokens.get(k..k + 1)?).is_some_and(|(n, _)| n > 1.0);
    if !(joined || is_first && article && !WHERE.contains(&before) && !runs(before)) || !(article || number || joined) {
        return None;
    }
    let name = k + usize::from(article || number);
    let end = room(tokens, name, number).filter(|end| *end <= within.end)?;
    let has = has(tokens, end, within.end);
    // "An office with three rooms: …" is what has the rooms.
    if has.is_some_and(|has| super::numbered::several(tokens, has).is_some()) {
        return None;
    }
    let owned = matches!(word(tokens, k), "my" | "our");
    let ends = end == within.end || matches!(word(tokens, end), "," | "and" | "plus" | "then" | "at");
    // Alone before a comma it is what the sentence speaks of, and "a kitchen of 3 by 4 m" has a size.
    (has.is_some() || ends && !(owned && is_first)).then_some(Head { at: k..end, name, several: number, has })
}

/// Where what a room has begins, if this is said after its name.
fn has(tokens: &[Token], end: usize, until: usize) -> Option<usize> {
    let which = end + usize::from(word(tokens, end) == ",");
    if matches!(word(tokens, which), "which" | "that") {
        let modal = matches!(word(tokens, which + 1), "should" | "must" | "can" | "will" | "needs" | "has");
        let to = which + 1 + usize::from(modal) + usize::from(word(tokens, which + 2) == "to");
        let verb =
            matches!(word(tokens, to), "has" | "have" | "fit" | "fits" | "hold" | "holds" | "contain" | "contains");
        let owns = word(tokens, which + 1) == "has" && !verb;
        return (verb || owns).then_some(if owns { which + 2 } else { to + 1 });
    }
    let begins = |k: usize| HAS.contains(&word(tokens, k)) && k < until;
    if begins(end) {
        return Some(end + 1);
    }
    // "at the front, with", "behind it with"
    let place = matches!(word(tokens, end), "at" | "behind" | "beside" | "next" | "on" | "in" | "for" | "upstairs");
    let plain = |k: &usize| tokens[*k].word() && !matches!(word(tokens, *k), "and" | "plus" | "then");
    let words = (end..until).take(BETWEEN).take_while(plain).take_while(|k| !begins(*k)).count();
    let after = end + words + usize::from(word(tokens, end + words) == ",");
    (place && begins(after)).then_some(after + 1)
}

/// Where the name of a room ends that begins here, after what is said of it.
fn room(tokens: &[Token], from: usize, several: bool) -> Option<usize> {
    let is_room = |n: &usize| {
        let mut name: Vec<String> = (from..from + n).map(|k| word(tokens, k).to_owned()).collect();
        let joins = |word: &String| {
            matches!(word.as_str(), "with" | "and" | "of" | "the" | "a" | "an" | "one" | "then" | "plus")
        };
        if name.iter().any(joins) || !tokens.get(from..from + n).is_some_and(|name| name.iter().all(Token::word)) {
            return false;
        }
        if let Some(last) = name.last_mut().filter(|_| several) {
            *last = singular(last);
        }
        let Some((words, kind)) = get().room_ending(&name) else { return false };
        let last = name.last().map_or("", String::as_str);
        let known = !kind.loose || last == "room" && *n > 1;
        let own = &name[name.len() - words..];
        known && !PARTS.contains(&last) && (get().noun(&own.join(" ")).is_none() || is_both(own))
    };
    (1..=LONGEST).rev().find(is_room).map(|n| from + n)
}

/// What is a thing in some rooms, and a room where it stands among rooms.
fn is_both(name: &[String]) -> bool {
    matches!(name.join(" ").as_str(), "changing room" | "reception" | "kitchen" | "locker room")
}

/// "A shop and a kitchen. The shop has a counter. The kitchen has two ovens." Returns by how much the text grew.
fn split(tokens: &mut Vec<Token>, heads: &[Head], end: usize) -> usize {
    let like = tokens[heads[0].at.start].clone();
    let mut said: Vec<Token> = Vec::new();
    for (k, head) in heads.iter().enumerate() {
        if k > 0 {
            said.push(tokens[head.at.start].saying("and"));
        }
        match word(tokens, head.at.start) {
            _ if head.several => said.push(tokens[head.at.start].clone()),
            _ => said.push(tokens[head.at.start].saying("a")),
        }
        said.extend(called(tokens, head));
    }
    for (k, head) in heads.iter().enumerate() {
        let next = heads.get(k + 1).map_or(end, |next| next.at.start);
        let mut until = next;
        while until > head.at.end && matches!(word(tokens, until - 1), "," | "and" | "plus" | "then") {
            until -= 1;
        }
        if head.at.end >= until {
            continue;
        }
        said.push(Token { kind: WordKind::Sign('.'), ..like.saying(".") });
        said.push(tokens[head.name].saying("the"));
        said.extend(called(tokens, head).into_iter().map(|t| Token { owner: t.owner, ..t.saying(&t.text) }));
        match head.has {
            Some(has) => {
                said.push(tokens[has - 1].saying(if head.several { "have" } else { "has" }));
                said.extend_from_slice(&tokens[has..until]);
            }
            None => said.extend_from_slice(&tokens[head.at.end..until]),
        }
    }
    let from = heads[0].at.start;
    let grown = said.len().saturating_sub(end - from);
    tokens.splice(from..end, said);
    grown
}

/// The name of a room as a room alone has it.
fn called(tokens: &[Token], head: &Head) -> Vec<Token> {
    let mut name = tokens[head.name..head.at.end].to_vec();
    if let Some(last) = name.last().cloned() {
        match last.text.as_str() {
            "reception" => name.push(last.saying("room")),
            "room" | "rooms" if name.len() > 1 && name[name.len() - 2].is("changing") => {
                let at = name.len() - 2;
                name[at].text = "locker".to_owned();
            }
            _ => {}
        }
    }
    name
}

/// The business that rooms which begin at a token belong to, and the building that it is.
fn business(tokens: &[Token], first: usize) -> Option<(Range<usize>, Vec<Token>)> {
    let own = |k: usize| {
        let before = k.checked_sub(1).map_or("", |k| word(tokens, k));
        matches!(before, "my" | "our") || matches!(before, "a" | "an") && k > 1 && runs(word(tokens, k - 2))
    };
    let titled = |end: usize| end + 1 == first && word(tokens, end) == ":";
    (0..first).find_map(|k| {
        let end = (1..=LONGEST).rev().find_map(|n| {
            let words: Vec<String> = (k..k + n).map(|k| word(tokens, k).to_owned()).collect();
            let kind = get().room(&words.join(" ")).filter(|kind| !kind.loose || kind.name == "restaurant")?;
            (kind.name != "apartment" && k + n <= first).then_some(k + n)
        })?;
        let same = (first..tokens.len()).any(|k| word(tokens, k) == word(tokens, end - 1) && end - k.min(end) < 2);
        let said = own(k) || own(k.saturating_sub(1)) || titled(end);
        let building = vec![tokens[end - 1].saying("building")];
        let at = if end - k > 1 { end - 1..end } else { k..end };
        (said && !same && !HAS.contains(&word(tokens, end))).then_some((at, building))
    })
}

fn runs(verb: &str) -> bool {
    matches!(verb, "run" | "own" | "opening" | "open" | "manage" | "have" | "starting")
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn rooms_are_named_before_what_they_have() {
        for (text, becomes) in [
            (
                "reception with a small retail shelf and a bench, one changing room with 20 lockers, and the main practice \
                 room, which should fit 16 mats.",
                "a reception room and a locker room and a main practice room . the reception room has a small retail shelf \
                 and a bench . the locker room has 20 lockers . the main practice room has 16 mats .",
            ),
            (
                "i run a bakery and want the shop at the front, with a counter, plus the kitchen behind it with two ovens.",
                "i run a building and want a shop and a kitchen . the shop has a counter . the kitchen has two ovens .",
            ),
            (
                "a living room with an open kitchen, a bedroom, a bathroom and a short hallway.",
                "a living room and a bedroom and a bathroom and a short hallway . the living room has an open kitchen .",
            ),
            (
                "vet clinic: reception, corridor and two exam rooms",
                "vet building : reception , corridor and two exam rooms",
            ),
            ("a bedroom with a bed and a bathroom with a shower", "a bedroom with a bed and a bathroom with a shower"),
            ("a bedroom with a bed, a reading corner and a rug", "a bedroom with a bed , a reading corner and a rug"),
            (
                "two bedrooms each with a bathroom, and a kitchen with a stove",
                "two bedrooms each with a bathroom , and a kitchen with a stove",
            ),
            (
                "behind that is an open office with six desks, then an interview room with a mirror, and three prison cells.",
                "behind that is a open office and a interview room and three prison cells . the open office has six desks . \
                 the interview room has a mirror .",
            ),
            (
                "a law office with three rooms: a hall with a desk, a kitchen and a meeting room with a table.",
                "a law office with three rooms : a hall and a kitchen and a meeting room . the hall has a desk . the meeting \
                 room has a table .",
            ),
            ("a house. plus a kitchen and a bathroom.", "a house . the house has a kitchen and a bathroom ."),
            ("the door of the kitchen and a bench with a bag", "the door of the kitchen and a bench with a bag"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
