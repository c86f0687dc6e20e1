//! Rooms that are one room: "an open-plan living room and kitchen" is a living room with what a kitchen has along its wall.

use super::lexicon::get;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use super::zones::HOMES;

/// What says that the rooms that follow are one, and in how many words.
const ONE: [&[&str]; 6] =
    [&["open-plan"], &["open", "plan"], &["open-concept"], &["open", "concept"], &["combined"], &["combination"]];

/// What a part of a home is called, and what it has in a room that is another one first.
const PARTS: [(&str, &[&str]); 7] = [
    ("living", &["a", "sofa"]),
    ("lounge", &["a", "sofa"]),
    ("kitchen", &["a", "kitchen", "counter"]),
    ("dining", &["a", "dining", "table"]),
    ("office", &["a", "desk"]),
    ("study", &["a", "desk"]),
    ("bedroom", &["a", "bed"]),
];

/// What the whole is by its parts, the first that is among them.
const WHOLE: [&str; 7] = ["living", "lounge", "kitchen", "dining", "bedroom", "office", "study"];

/// Turns several rooms that are said to be one into the first of them, with what the others have.
pub fn plain(tokens: &mut Vec<Token>) {
    room_at_home(tokens);
    one_room(tokens);
    open_kitchen(tokens);
    let mut i = 0;
    while i < tokens.len() {
        let said = |words: &&&[&str]| words.iter().enumerate().all(|(k, w)| word(tokens, i + k) == *w);
        if let Some(words) = ONE.iter().find(said) {
            let first = i + words.len();
            merge(tokens, i, first);
        } else if shares_room(tokens, i) {
            merge(tokens, i, i);
        }
        i += 1;
    }
}

/// "A kitchen/living room", "a kitchen-living room", "an open kitchen and living room": one room. This is read before rooms are told
/// apart.
pub fn joined(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        hyphened(tokens, i);
        are_one(tokens, i);
        let slash = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.kind, WordKind::Sign('/')));
        let next = part(tokens, i).map(|(.., next)| next);
        if next.is_some_and(slash) && next.is_some_and(|next| part(tokens, next + 1).is_some()) {
            let open = usize::from(i > 0 && matches!(word(tokens, i - 1), "open" | "combined"));
            merge_by(tokens, i - open, i, |t| matches!(t.kind, WordKind::Sign('/')));
        } else if word(tokens, i) == "open"
            && let Some((first, _, next)) = part(tokens, i + 1)
            && let Some((second, _, end)) = part(tokens, next + 1).filter(|_| word(tokens, next) == "and")
            && [first, second].iter().all(|name| WHOLE[..4].contains(name))
            && matches!(word(tokens, end - 1), "room" | "area" | "space" | "kitchen" | "lounge")
            && first != second
        {
            merge_by(tokens, i, i + 1, |t| t.is("and"));
        }
        i += 1;
    }
}

/// "The kitchen and living area are open plan": an open-plan kitchen and living area. "A reception and waiting area": a reception.
fn are_one(tokens: &mut Vec<Token>, i: usize) {
    let waits = matches!(word(tokens, i + 2), "waiting") && matches!(word(tokens, i + 3), "area" | "room");
    let and = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.text.as_str(), "and" | "/" | "&"));
    if word(tokens, i) == "reception" && and(i + 1) && waits {
        put(tokens, i, i + 4, &["reception", "area"]);
        return;
    }
    if word(tokens, i + 2) == "diner" && tokens[i + 1].is("/") && part(tokens, i).is_some() {
        "dining".clone_into(&mut tokens[i + 2].text);
    }
    let starts = i == 0 || !tokens[i - 1].word() || matches!(word(tokens, i - 1), "the" | "and");
    let Some((_, _, next)) = part(tokens, i).filter(|_| starts) else { return };
    let second = next + 1 + usize::from(word(tokens, next + 1) == "the");
    let Some((_, _, end)) = part(tokens, second).filter(|_| word(tokens, next) == "and") else { return };
    let are = end + usize::from(matches!(word(tokens, end), "are" | "should" | "is"));
    let are = are + usize::from(word(tokens, are) == "be");
    let said = match [word(tokens, are), word(tokens, are + 1)] {
        ["open-plan" | "combined", _] => are + 1,
        ["open", "plan"] | ["one", "room" | "space"] => are + 2,
        _ => return,
    };
    let the = i - usize::from(i > 0 && word(tokens, i - 1) == "the");
    if are > end && tokens.get(said).is_none_or(|t| !t.word()) {
        let mut words: Vec<String> = vec!["there".into(), "is".into(), "an".into(), "open-plan".into()];
        words.extend((i..next).chain([next]).chain(second..end).map(|k| tokens[k].text.clone()));
        put(tokens, the, said, &words.iter().map(String::as_str).collect::<Vec<_>>());
    }
}

/// "A kitchen-living room": a kitchen / living room.
fn hyphened(tokens: &mut Vec<Token>, i: usize) {
    let Some((first, second)) = word(tokens, i).split_once('-').map(|(a, b)| (a.to_owned(), b.to_owned())) else {
        return;
    };
    let is_part = |name: &str| PARTS.iter().any(|(part, _)| *part == name);
    if is_part(&first) && is_part(&second) && first != "open" {
        put(tokens, i, i + 1, &[&first, "/", &second]);
        tokens[i + 1].kind = WordKind::Sign('/');
    }
}

/// "A home recording den" is a den, and no home with its rooms.
fn room_at_home(tokens: &mut Vec<Token>) {
    const MOST: usize = 3;
    let lexicon = get();
    let mut i = 0;
    while i < tokens.len() {
        let after = tokens[i + 1..].iter().take(MOST);
        let plain = |t: &&Token| t.word() && lexicon.relation(std::slice::from_ref(t)).is_none() && !t.is("and");
        let words: Vec<String> = after.take_while(plain).map(|t| t.text.clone()).collect();
        let names = |n: usize| lexicon.room_ending(&words[..n]).is_some();
        let is_own = |n: usize| lexicon.room(&format!("home {}", words[..n].join(" "))).is_some();
        if tokens[i].is("home") && (1..=words.len()).any(names) && !(1..=words.len()).any(is_own) {
            tokens.remove(i);
        }
        i += 1;
    }
}

/// "A loft with a living area and a sleeping area": a loft is one room, and these are what stands there.
fn one_room(tokens: &mut Vec<Token>) {
    const AREAS: [(&str, &[&str]); 12] = [
        ("living", &["a", "sofa"]),
        ("lounge", &["a", "sofa"]),
        ("seating", &["a", "sofa"]),
        ("kitchen", &["a", "kitchen", "counter"]),
        ("cooking", &["a", "kitchen", "counter"]),
        ("dining", &["a", "dining", "table"]),
        ("sleeping", &["a", "bed"]),
        ("bed", &["a", "bed"]),
        ("bedroom", &["a", "bed"]),
        ("work", &["a", "desk"]),
        ("working", &["a", "desk"]),
        ("office", &["a", "desk"]),
    ];
    let is_tiny = |i: usize| word(tokens, i) == "tiny" && matches!(word(tokens, i + 1), "house" | "home");
    let is_one = |i: &usize| matches!(word(tokens, *i), "loft" | "studio") || is_tiny(*i);
    let Some(home) = (0..tokens.len()).find(is_one) else { return };
    let tiny = is_tiny(home);
    let mut i = home + 1;
    while i < tokens.len() {
        let adjective = usize::from(matches!(word(tokens, i + 1), "open" | "separate" | "small" | "large"));
        let name = word(tokens, i + 1 + adjective).to_owned();
        let placed = matches!(word(tokens, i + 2 + adjective), "area" | "space" | "zone" | "corner" | "nook" | "loft");
        let open = name == "kitchen" && (tiny || adjective > 0 && word(tokens, i + 1) == "open");
        if matches!(word(tokens, i), "a" | "an") && matches!(word(tokens, i + 1), "workspace" | "workplace") {
            put(tokens, i, i + 2, &["a", "desk"]);
        } else if let (true, Some((_, has))) =
            (matches!(word(tokens, i), "a" | "an") && (placed || open), AREAS.iter().find(|(area, _)| *area == name))
        {
            put(tokens, i, i + 2 + adjective + usize::from(placed), has);
        }
        i += 1;
    }
}

/// "A flat with an open kitchen": one cooks in the living room, unless that is spoken of.
fn open_kitchen(tokens: &mut Vec<Token>) {
    let is_home = tokens.iter().any(|t| HOMES.iter().any(|home| t.is(home)));
    let lives = tokens.iter().any(|t| t.is("living") || t.is("lounge"));
    let open = |i: &usize| word(tokens, *i) == "open" && word(tokens, *i + 1) == "kitchen";
    // "A living room with an open kitchen".
    let in_living = |at: &usize| {
        let before = [4, 3, 2, 1].map(|k| at.checked_sub(k).map_or("", |k| word(tokens, k)));
        matches!(before, ["living" | "lounge", "room" | "area", "with" | "has", "an"])
    };
    // "A living room with open kitchen".
    let bare = |at: &usize| {
        let before = [3, 2, 1].map(|k| at.checked_sub(k).map_or("", |k| word(tokens, k)));
        matches!(before, ["living" | "lounge", "room" | "area", "with" | "has"])
    };
    if let Some(at) = (1..tokens.len()).filter(open).find(bare) {
        return put(tokens, at, at + 2, &["a", "kitchen", "counter"]);
    }
    if let Some(at) = (1..tokens.len()).filter(open).find(in_living) {
        return put(tokens, at - 1, at + 2, &["a", "kitchen", "counter"]);
    }
    if let Some(at) = (1..tokens.len()).find(open).filter(|at| is_home && !lives && word(tokens, at - 1) == "an") {
        // "An open kitchen with a table": the table is in the same room.
        let with = at + 2 < tokens.len() && word(tokens, at + 2) == "with";
        if with {
            put(tokens, at + 2, at + 3, &["and"]);
        }
        // Where one sleeps elsewhere, the living room is smaller.
        let small = tokens.iter().any(|t| t.is("bedroom") || t.is("bedrooms"));
        let kitchen: &[&str] = if small { &["kitchenette"] } else { &["kitchen", "counter"] };
        put(tokens, at - 1, at + 2, &[&["a", "living", "room", "with", "a"], kitchen].concat());
    }
}

/// "A living room and dining area", "a living and dining room": one room, too.
fn shares_room(tokens: &[Token], i: usize) -> bool {
    let Some((name, _, next)) = part(tokens, i) else { return false };
    let is_area = |end: usize| matches!(word(tokens, end - 1), "area" | "space" | "zone");
    let joined = word(tokens, next) == "and" || matches!(tokens.get(next).map(|t| t.kind), Some(WordKind::Sign('/')));
    let Some((other, _, end)) = part(tokens, next + 1).filter(|_| joined) else { return false };
    let is_bare = next == i + 1 && matches!(name, "living" | "dining") && word(tokens, end - 1) == "room";
    name != other && !is_area(next) && (is_area(end) || is_bare)
}

/// The part of a home that is named here, and where its name ends: "kitchen", "living room", "dining area".
fn part(tokens: &[Token], i: usize) -> Option<(&'static str, &'static [&'static str], usize)> {
    let (name, has) = PARTS.iter().find(|(name, _)| word(tokens, i) == *name)?;
    let placed = matches!(word(tokens, i + 1), "room" | "area" | "space" | "zone");
    Some((name, has, i + 1 + usize::from(placed)))
}

/// Of rooms from a word on, which are said to be one by what begins at `from`: the first with what the others have.
fn merge(tokens: &mut Vec<Token>, from: usize, first: usize) {
    let joins = |t: &Token| {
        matches!(t.kind, WordKind::Sign(',' | '/' | '&')) || matches!(t.text.as_str(), "and" | "cum" | "plus" | "a")
    };
    merge_by(tokens, from, first, joins);
}

/// The same, of rooms that are joined so.
fn merge_by(tokens: &mut Vec<Token>, from: usize, first: usize, joins: impl Fn(&Token) -> bool) {
    let (mut parts, mut second) = (Vec::new(), first);
    let (mut at, mut end) = (first, first);
    while let Some((name, has, next)) = part(tokens, at) {
        // "… kitchen and living room and a study": the study is a room of its own.
        let has_article = |at: usize| at > first && word(tokens, at - 1) == "a";
        if parts.len() > 1 && has_article(at) && !has_article(second) {
            break;
        }
        if parts.len() == 1 {
            second = at;
        }
        if !parts.iter().any(|(other, _)| *other == name) {
            parts.push((name, has));
        }
        (at, end) = (next, next);
        while tokens.get(at).is_some_and(&joins) {
            at += 1;
        }
        if at == next {
            break;
        }
    }
    // "Space", "area" after the last of them belongs to all.
    if matches!(word(tokens, end), "space" | "area") {
        end += 1;
    }
    // "An open-plan living area": one cooks there, unless a kitchen is spoken of.
    let area = end == first + 2 && matches!(word(tokens, end - 1), "area" | "space");
    if let [("living", _)] = parts[..]
        && area
        && !tokens.iter().any(|t| t.is("kitchen") || t.is("kitchenette"))
    {
        let with = if word(tokens, end) == "with" { "and" } else { "" };
        let words = ["living", "room", "with", "a", "kitchen", "counter", with];
        let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        return put(tokens, from, end + usize::from(!with.is_empty()), &words);
    }
    let whole = WHOLE.iter().find(|whole| parts.iter().any(|(name, _)| name == *whole));
    let (Some(whole), true) = (whole, parts.len() > 1) else { return };
    let mut words: Vec<&str> = match *whole {
        "living" | "lounge" => vec!["living", "room", "with"],
        "dining" => vec!["dining", "room", "with"],
        kitchen => vec![kitchen, "with"],
    };
    // A table that is spoken of afterwards is the one at which one eats.
    let is_said = |has: &[&str]| has.last().is_some_and(|noun| tokens[end..].iter().any(|t| t.is(noun)));
    let others: Vec<_> = parts.iter().filter(|(name, has)| name != whole && !is_said(has)).collect();
    if others.is_empty() {
        words.pop();
    }
    for (k, (_, has)) in others.iter().enumerate() {
        if k > 0 {
            words.push("and");
        }
        words.extend(*has);
    }
    let merged: Vec<&str> = parts.iter().map(|(name, _)| *name).filter(|name| name != whole).collect();
    called(tokens, end, &merged, words[0]);
    // What follows is said of the whole: "… with a sofa".
    if word(tokens, end) == "with" && !others.is_empty() {
        words.push("and");
        end += 1;
    }
    put(tokens, from, end, &words);
}

/// "The kitchen has an island", where one cooks in the living room: it is the living room that has it.
fn called(tokens: &mut Vec<Token>, from: usize, parts: &[&str], whole: &str) {
    for i in (from + 1..tokens.len()).rev() {
        let Some((_, _, end)) = part(tokens, i).filter(|(name, ..)| parts.contains(name)) else { continue };
        let place = usize::from(matches!(word(tokens, end), "part" | "side" | "corner"));
        let end = end + place;
        let verb = tokens.get(end..end + 1).is_some_and(|t| get().verb(t).is_some());
        let stops = tokens.get(end).is_none_or(|t| !t.word()) || verb;
        let goes_on = matches!(word(tokens, end), "there" | "put" | "and" | "with" | "has" | "i" | "we" | "should");
        if tokens[i - 1].is("the") && (stops || goes_on) {
            let name = if matches!(whole, "living" | "lounge" | "dining") { vec![whole, "room"] } else { vec![whole] };
            put(tokens, i, end, &name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::token;

    #[test]
    fn a_stroke_joins_rooms() {
        for (text, becomes) in [
            (
                "a bedroom, a bathroom and an open kitchen/living room. the kitchen has a table.",
                "a bedroom , a bathroom and an living room with a kitchen counter . the living room has a table .",
            ),
            ("a kitchen / living room with a sofa", "a living room with a kitchen counter and a sofa"),
            ("a kitchen-living room and a bedroom", "a living room with a kitchen counter and a bedroom"),
            ("living/dining room, bathroom", "living room with a dining table , bathroom"),
            ("a bedroom/office with a bed", "a bedroom with a desk and a bed"),
            ("an open kitchen and living room and a hall", "an living room with a kitchen counter and a hall"),
            ("an open kitchen and a living room", "an open kitchen and a living room"),
            ("a lounge/diner", "a living room with a dining table"),
            ("a reception and waiting area", "a reception area"),
            ("the kitchen and living area are open plan.", "there is an open-plan kitchen and living area ."),
            ("a black/white kitchen", "a black / white kitchen"),
        ] {
            let mut tokens = token::tokens(text, 100).0;
            super::joined(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }

    #[test]
    fn rooms_that_are_one_are_one_room() {
        for (text, becomes) in [
            ("an open-plan living room and kitchen", "an living room with a kitchen counter"),
            (
                "an open plan kitchen, dining and living area with a piano",
                "an living room with a kitchen counter and a dining table and a piano",
            ),
            ("a combined kitchen and dining room", "a kitchen with a dining table"),
            ("a combined kitchen, dining room and study", "a kitchen with a dining table and a desk"),
            ("an open-plan kitchen and living room and a study", "an living room with a kitchen counter and a study"),
            ("a living room and dining area for four", "a living room with a dining table for four"),
            ("a living and dining room", "a living room with a dining table"),
            ("a kitchen and dining area with a table for six", "a kitchen with a table for six"),
            ("a living room and a dining room", "a living room and a dining room"),
            ("an open-plan living area, three bedrooms", "an living room with a kitchen counter , three bedrooms"),
            (
                "a flat with a living room with an open kitchen and a bedroom",
                "a flat with a living room with a kitchen counter and a bedroom",
            ),
            ("an open-plan office", "an open-plan office"),
            ("an open plan kitchen", "an open plan kitchen"),
            ("a living room and a kitchen", "a living room and a kitchen"),
            (
                "a loft with an open kitchen, a dining area and a living area",
                "a loft with a kitchen counter , a dining table and a sofa",
            ),
            ("a flat with an open kitchen", "a flat with a living room with a kitchen counter"),
            (
                "a flat with one bedroom and an open kitchen with a dining table",
                "a flat with one bedroom and a living room with a kitchenette and a dining table",
            ),
        ] {
            let mut tokens = token::tokens(text, 100).0;
            super::plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
