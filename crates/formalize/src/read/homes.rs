//! Who lives in a home and what is in which of its rooms: "each has their own bedroom", "a bed in the bedroom and a couch in
//! the living room", "a room for my daughter".

use super::lexicon::{Class, get};
use super::number::count;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use super::zones::HOMES;
use crate::furnish::kinds;

/// The most words of a room's name.
const LONGEST: usize = 3;
/// What a second room may be, and which rooms have the others in them.
const ROOMS: [&str; 10] = [
    "bedroom",
    "bathroom",
    "kitchen",
    "living room",
    "dining room",
    "office",
    "study",
    "storage room",
    "classroom",
    "storeroom",
];
const WHOLE: [&str; 3] = ["studio apartment", "apartment", "hotel room"];
/// Who has a room of their own at home.
const CHILDREN: [&str; 18] = [
    "daughter",
    "son",
    "boy",
    "girl",
    "child",
    "kid",
    "toddler",
    "daughters",
    "sons",
    "teenager",
    "brother",
    "brothers",
    "sister",
    "sisters",
    "twins",
    "siblings",
    "boys",
    "girls",
];
/// So many share a flat where nobody says how many.
const SHARED: &str = "three";

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 11] = [
        which_bedroom,
        shared,
        bunk_beds,
        own_bedroom,
        one_bedroom,
        rooms_listed,
        in_rooms,
        another_room,
        whose,
        lives,
        own_kitchen,
    ];
    turns.iter().any(|turn| turn(tokens, i))
}

/// "The smaller bedroom" is the small bedroom, and "the parents bedroom" that of the parents.
fn which_bedroom(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAMILY: [&str; 5] = ["parents", "guests", "grandparents", "couple", "teens"];
    let is_room = matches!(word(tokens, i + 1), "bedroom" | "room" | "bathroom");
    let plain = match word(tokens, i) {
        "smaller" | "smallest" if is_room => "small",
        "larger" | "bigger" | "largest" | "biggest" if is_room => "large",
        who if is_room && (FAMILY.contains(&who) || CHILDREN.contains(&who)) => {
            tokens[i].owner = true;
            return false;
        }
        "spare" if is_room => "guest",
        // A loft is one room.
        "living" if matches!(word(tokens, i + 1), "area" | "space") && is_home(tokens, i) => {
            let one = |t: &Token| matches!(t.text.as_str(), "studio" | "loft" | "tiny");
            let open = |k: &usize| tokens[*k].text.starts_with("open") || tokens[*k].text.starts_with("combin");
            if tokens.iter().any(one) || (i.saturating_sub(6)..i).any(|k| open(&k)) || !ends_or_has(tokens, i + 2) {
                return false;
            }
            put(tokens, i, i + 2, &["living", "room"]);
            return true;
        }
        "other" if i > 0 && word(tokens, i - 1) == "the" => return other_bedroom(tokens, i, "other"),
        "smaller" | "small" | "second" if word(tokens, i + 1) == "one" => return other_bedroom(tokens, i, "other"),
        _ => return false,
    };
    put(tokens, i, i + 1, &plain.split(' ').collect::<Vec<_>>());
    true
}

/// "The kids share a bedroom with bunk beds": the kids' bedroom has bunk beds. "One of the bathrooms belongs to the master bedroom":
/// that has its own bathroom.
fn shared(tokens: &mut Vec<Token>, i: usize) -> bool {
    let who = matches!(word(tokens, i), "kids" | "children" | "boys" | "girls" | "daughters" | "sons" | "twins");
    let name = i + 2 + usize::from(matches!(word(tokens, i + 2), "a" | "the" | "one"));
    let room = matches!(word(tokens, name), "bedroom" | "room") && matches!(word(tokens, name + 1), "with");
    if who && word(tokens, i + 1) == "share" && room {
        put(tokens, i + 1, name + 2, &["bedroom", "has"]);
        tokens[i].owner = true;
        return true;
    }
    let one = ["one", "of", "the", "bathrooms"].iter().enumerate().all(|(k, said)| word(tokens, i + k) == *said);
    let of = match [word(tokens, i + 4), word(tokens, i + 5)] {
        ["belongs", "to"] | ["is", "for" | "off"] => i + 6,
        _ => return false,
    };
    let Some(end) = self::room(tokens, of + 1).filter(|_| one && word(tokens, of) == "the") else { return false };
    let mut words: Vec<String> = (of..end).map(|k| tokens[k].text.clone()).collect();
    words.extend(["has", "its", "own", "bathroom"].map(str::to_owned));
    put(tokens, i, end, &words.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// Whether the name of a room may end before a token.
fn ends_or_has(tokens: &[Token], i: usize) -> bool {
    let verb = tokens.get(i..i + 1).is_some_and(|t| get().verb(t).is_some());
    tokens.get(i).is_none_or(|t| !t.word())
        || verb
        || matches!(word(tokens, i), "with" | "and" | "there" | "put" | "has")
}

/// "A two-bedroom flat. The main bedroom has a bed, and the other one has a desk", "the smaller one a crib": the other bedroom.
fn other_bedroom(tokens: &mut Vec<Token>, i: usize, which: &str) -> bool {
    const WHICH: [&str; 6] = ["main", "master", "primary", "large", "small", "guest"];
    let one = word(tokens, i + 1) == "one";
    let end = i + 1 + usize::from(one);
    let has = matches!(word(tokens, end), "has" | "gets" | "needs" | "contains" | "is");
    let listed = one && (matches!(word(tokens, end), "a" | "an") || counts(tokens, end));
    let plural = |k: &usize| word(tokens, *k) == "bedrooms" || word(tokens, *k).ends_with("-bedroom");
    let Some(counted) = (0..i).rev().find(plural).filter(|_| has || listed) else { return false };
    let two = counted > 0 && count(&tokens[counted - 1..counted]).is_some_and(|(n, _)| n == 2.0);
    let named = (counted..i).any(|k| WHICH.contains(&word(tokens, k)) && word(tokens, k + 1) == "bedroom");
    // The room that was spoken of last is a bedroom.
    let last = (counted..i).rev().find_map(|k| room(tokens, k));
    let said =
        (two || hyphened(tokens, counted)) && named && last.is_some_and(|end| word(tokens, end - 1) == "bedroom");
    if said {
        let words = [which, "bedroom", "has"];
        put(tokens, i, end, &words[..if has { 2 } else { 3 }]);
        let the = i - 1;
        if listed && the > 0 && (tokens[the - 1].is(",") || tokens[the - 1].is("and")) {
            tokens[the - 1] = Token { kind: WordKind::Sign('.'), ..tokens[the - 1].saying(".") };
        }
    }
    said
}

fn counts(tokens: &[Token], i: usize) -> bool {
    count(tokens.get(i..i + 1).unwrap_or_default()).is_some()
}

/// "A room for two boys with bunk beds": a bunk bed, in which both sleep.
fn bunk_beds(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "bunk" && word(tokens, i + 1) == "beds";
    let counted = i > 0 && count(&tokens[i - 1..i]).is_some();
    let two = |k: usize| {
        word(tokens, k) == "for"
            && word(tokens, k + 1) == "two"
            && (k + 2..k + 5).any(|n| {
                CHILDREN.contains(&word(tokens, n)) || word(tokens, n) == "kids" || word(tokens, n) == "children"
            })
    };
    if !said || counted || !(0..i).any(two) {
        return false;
    }
    put(tokens, i, i + 2, &["a", "bunk", "bed"]);
    true
}

/// "Two bedrooms, one with a double bed and one with a bunk bed", "one bedroom has a desk, the other bedroom has none": the
/// first bedroom, and the second one.
fn one_bedroom(tokens: &mut Vec<Token>, i: usize) -> bool {
    let all = |k: &usize| {
        // Of other rooms the whole name counts: "two consulting rooms".
        let kind = *k > 0 && word(tokens, *k) == "rooms" && get().noun(word(tokens, k - 1)).is_none();
        let named = kind && room(tokens, k - 1) == Some(k + 1);
        named
            || matches!(word(tokens, *k), "bedrooms" | "bathrooms" | "offices")
            || word(tokens, *k).ends_with("-bedroom")
    };
    let Some(plural) = (0..i).rev().find(all) else { return false };
    let hyphened = tokens[plural].text.ends_with("-bedroom");
    let one = match word(tokens, plural) {
        "rooms" => format!("{} room", word(tokens, plural - 1)),
        _ if hyphened => "bedroom".to_owned(),
        many => many.trim_end_matches('s').to_owned(),
    };
    if next_bedroom(tokens, i, &one) {
        return true;
    }
    if one_and_other(tokens, i, plural, &one) {
        return true;
    }
    let named = |k: usize| matches!(word(tokens, k), "bedroom" | "bathroom" | "office");
    match [word(tokens, i), word(tokens, i + 1)] {
        ["one", name] if named(i + 1) && name == one => put(tokens, i, i + 1, &["the", "first"]),
        ["the", "other"] if named(i + 2) && word(tokens, i + 2) == one => put(tokens, i + 1, i + 2, &["second"]),
        ["one", "with"] if i > 0 && tokens[i - 1].is(",") && plural + 2 == i => {
            let stop = tokens[i..].iter().position(Token::stops).map_or(tokens.len(), |n| i + n);
            let next = (i + 2..stop).find_map(|k| {
                let joins = tokens[k].is("and") || tokens[k].is(",");
                match [word(tokens, k + 1), word(tokens, k + 2), word(tokens, k + 3)] {
                    ["one", "with", _] if joins => Some((k, k + 3)),
                    ["the", "other", "with"] if joins => Some((k, k + 4)),
                    ["the", "other", "one"] if joins && word(tokens, k + 4) == "with" => Some((k, k + 5)),
                    _ => None,
                }
            });
            let Some((and, end)) = next else { return false };
            for (from, to, which) in [(and, end, "second"), (i - 1, i + 2, "first")] {
                let words: Vec<&str> = [".", "the", which].into_iter().chain(one.split(' ')).chain(["has"]).collect();
                put(tokens, from, to, &words);
                tokens[from].kind = WordKind::Sign('.');
            }
        }
        ["one", "for"] if i > 0 && tokens[i - 1].is(",") && plural + 2 == i => return one_for_each(tokens, i),
        _ => return false,
    }
    true
}

/// "Two bedrooms, one for the parents with a double bed and one for the kids with a bunk bed": the parents' bedroom has a double
/// bed, and the kids' bedroom has a bunk bed.
fn one_for_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WORDS: usize = 7;
    let whom = |from: usize| -> Option<(String, usize)> {
        let with = (from + 2..from + WORDS).find(|k| word(tokens, *k) == "with")?;
        let who = tokens[from + 2..with].iter().find_map(|t| match t.text.as_str() {
            "parents" | "couple" | "adults" | "guests" => Some(t.text.clone()),
            child if CHILDREN.contains(&child) || matches!(child, "kids" | "children") => Some("kids".to_owned()),
            _ => None,
        });
        Some((who?, with))
    };
    let stop = tokens[i..].iter().position(Token::stops).map_or(tokens.len(), |n| i + n);
    let next = |k: &usize| {
        let joins = tokens[*k].is("and") || tokens[*k].is(",");
        joins && word(tokens, k + 1) == "one" && word(tokens, k + 2) == "for"
    };
    let (Some((first, with)), Some(and)) = (whom(i), (i + 2..stop).find(next)) else { return false };
    let Some((second, end)) = whom(and + 1).filter(|(second, _)| *second != first) else { return false };
    for (from, to, who) in [(and, end + 1, second), (i - 1, with + 1, first)] {
        put(tokens, from, to, &[".", "the", &who, "bedroom", "has"]);
        tokens[from].kind = WordKind::Sign('.');
        tokens[from + 2].owner = true;
    }
    true
}

/// "Two bedrooms. One has a bed, the other has a crib", "hers gets the window, his is smaller: a single bed": the first bedroom and
/// the second.
fn one_and_other(tokens: &mut Vec<Token>, i: usize, plural: usize, one: &str) -> bool {
    let two = plural > 0 && count(&tokens[plural - 1..plural]).is_some_and(|(n, _)| n == 2.0);
    let starts = i > plural && (!tokens[i - 1].word() || matches!(word(tokens, i - 1), "and" | "while" | "but"));
    let told = |which: &str| (plural..i).any(|k| word(tokens, k) == which && word(tokens, k + 1) == one);
    let has = |k: usize| matches!(word(tokens, k), "has" | "is" | "gets" | "needs" | "contains");
    let whose = matches!(word(tokens, i), "hers" | "his" | "mine" | "ours" | "theirs" | "yours");
    let other = |k: usize| word(tokens, k) == "the" && word(tokens, k + 1) == "other" && has(k + 2);
    let (which, verb) = match word(tokens, i) {
        "one" if has(i + 1) && (i..tokens.len()).any(other) => ("first", i + 1),
        "the" if other(i) && told("first") => ("second", i + 2),
        _ if whose && has(i + 1) => (if told("first") { "second" } else { "first" }, i + 1),
        _ => return false,
    };
    if !two && !hyphened(tokens, plural) || !starts || told("second") {
        return false;
    }
    // "His is smaller: an electric bed" has one.
    let colon = tokens.get(verb + 2).is_some_and(|t| t.is(":")) && word(tokens, verb) == "is";
    let end = if colon { verb + 3 } else { verb + 1 };
    let verb = if colon || word(tokens, verb) == "gets" { "has" } else { word(tokens, verb) }.to_owned();
    put(tokens, i, end, &["the", which, one, &verb]);
    if i > 0 && (tokens[i - 1].is(",") || tokens[i - 1].word()) {
        put(tokens, i - 1, i, &["."]);
        tokens[i - 1].kind = WordKind::Sign('.');
    }
    true
}

fn hyphened(tokens: &[Token], plural: usize) -> bool {
    tokens[plural].text.starts_with("two-")
}

/// "…, one bedroom with a double bed, and a smaller bedroom with a desk": sentences about the first and the second bedroom.
fn next_bedroom(tokens: &mut Vec<Token>, i: usize, one: &str) -> bool {
    let joins = |k: usize| k > 0 && (tokens[k - 1].is(",") || tokens[k - 1].is("and"));
    let from = i - usize::from(joins(i)) - usize::from(joins(i) && joins(i - 1));
    let told = (0..i).any(|k| word(tokens, k) == "first" && word(tokens, k + 1) == one);
    let which = match word(tokens, i) {
        "one" if !told => "first",
        "a" | "another" | "the" | "one" if told => "second",
        _ => return false,
    };
    let Some(name) = (i + 1..i + 3).find(|k| word(tokens, *k) == one) else { return false };
    if from == i || word(tokens, name + 1) != "with" || matches!(word(tokens, i + 1), "first" | "second") {
        return false;
    }
    put(tokens, name + 1, name + 2, &["has"]);
    put(tokens, from, i + 1, &[".", "the", which]);
    tokens[from].kind = WordKind::Sign('.');
    true
}

/// "Three rooms: a living room, a bedroom and a kitchen": these, and not three more.
fn rooms_listed(tokens: &mut Vec<Token>, i: usize) -> bool {
    let number = count(tokens.get(i..i + 1).unwrap_or_default()).filter(|_| word(tokens, i + 1) == "rooms");
    let all = |(n, _): (f64, usize)| super::numbered::listed(tokens, (i + 3).min(tokens.len())) as f64 >= n;
    let counted = number.is_some_and(all);
    let listed = tokens.get(i + 2).is_some_and(|t| matches!(t.kind, WordKind::Sign(':')));
    let said = counted && listed && word(tokens, i + 3) == "a" && room(tokens, i + 4).is_some();
    if said {
        tokens.drain(i..i + 3);
    }
    said
}

/// Where the name of a kind of room ends that begins here.
fn room(tokens: &[Token], i: usize) -> Option<usize> {
    let named = |n: &usize| {
        let name: Vec<&str> = (i..i + n).map(|k| word(tokens, k)).collect();
        !name.contains(&"") && kinds::named(&name.join(" ")).is_some()
    };
    (1..=LONGEST).rev().find(named).map(|n| i + n)
}

fn is_home(tokens: &[Token], i: usize) -> bool {
    tokens[..i]
        .iter()
        .any(|t| HOMES.iter().any(|home| t.is(home)) || t.text.ends_with("-bedroom") || t.text.ends_with("-room"))
}

/// "A flat for three: each has their own bedroom": a flat with three bedrooms.
fn own_bedroom(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "each" || !is_home(tokens, i) {
        return false;
    }
    const BETWEEN: usize = 7;
    let own =
        (i + 1..i + BETWEEN).find(|k| word(tokens, *k) == "own" && matches!(word(tokens, k + 1), "bedroom" | "room"));
    let has = |k: usize| matches!(word(tokens, k), "has" | "have" | "gets" | "with" | "having" | "needs");
    let Some(own) = own.filter(|own| (i + 1..*own).any(has)) else { return false };
    let number = |k: usize| count(&tokens[k..=k]).is_some_and(|(n, _)| (2.0..=8.0).contains(&n));
    let people = (1..i).find(|k| word(tokens, k - 1) == "for" && number(*k)).map(|k| tokens[k].clone());
    let where_from = i - usize::from(i > 0 && word(tokens, i - 1) == "where");
    let sign = where_from > 0 && matches!(tokens[where_from - 1].kind, WordKind::Sign(':' | ',' | ';'));
    let from = where_from - usize::from(sign);
    put(tokens, from, own + 2, &["with", SHARED, "bedrooms"]);
    if let Some(people) = people {
        tokens[from + 1] = Token { at: tokens[from + 1].at.clone(), ..people };
    }
    true
}

/// "A living room with a sofa and a bedroom with a bed", "a bedroom with a bed" as a sentence after that: the second room has it.
fn another_room(tokens: &mut Vec<Token>, i: usize) -> bool {
    let starts = i > 0 && matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let there = if matches!(word(tokens, i), "there") && matches!(word(tokens, i + 1), "is") { 2 } else { 0 };
    let article = match word(tokens, i) {
        "and" => i + 1,
        _ if starts => i + there,
        _ => return false,
    };
    let Some(end) =
        Some(article).filter(|at| matches!(word(tokens, *at), "a" | "an")).and_then(|at| room(tokens, at + 1))
    else {
        return false;
    };
    let name = |from: usize, end: usize| (from..end).map(|k| word(tokens, k)).collect::<Vec<_>>().join(" ");
    let own = name(article + 1, end);
    // A bar or a lounge in a hotel is a part of it, and so may be a kitchenette.
    let is_room =
        get().noun(&own).is_none() && (own.ends_with(" room") || ROOMS.iter().any(|room| own.ends_with(room)));
    let has = matches!(word(tokens, end), "with" | "has" | "containing");
    let kind = kinds::named(&own).map(|kind| kind.name);
    let begins = |k: usize| matches!(word(tokens, k), "a" | "an" | "the") && room(tokens, k + 1).is_some();
    let other = (0..article.saturating_sub(2)).find(|k| begins(*k)).and_then(|k| {
        let end = room(tokens, k + 1)?;
        let first = matches!(word(tokens, end), "with" | "has" | "contains" | "that" | "where" | "");
        let is_one = get().room(&name(k + 1, end)).is_none_or(|known| !known.loose);
        kinds::named(&name(k + 1, end)).filter(|_| first && is_one).map(|kind| kind.name)
    });
    if !is_room || !has || is_home(tokens, i) || other.is_none_or(|other| Some(other) == kind || WHOLE.contains(&other))
    {
        return false;
    }
    put(tokens, end, end + 1, &["has"]);
    let from = if word(tokens, i) == "and" { i } else { article - there };
    put(tokens, from, article + 1, if starts { &["the"] } else { &[".", "the"] });
    if !starts {
        tokens[from].kind = WordKind::Sign('.');
    }
    true
}

/// "A bed in the bedroom and a couch in the living room", "the bedroom has a bed, the living room needs a couch": a sentence for
/// each room.
fn in_rooms(tokens: &mut Vec<Token>, i: usize) -> bool {
    const HAS: [&str; 8] = ["has", "contains", "holds", "needs", "gets", "have", "need", "should"];
    let is_comma = tokens[i].is(",") && word(tokens, i + 1) != "and";
    if word(tokens, i) != "and" && !is_comma {
        return false;
    }
    let comma = usize::from(!is_comma && i > 0 && tokens[i - 1].is(","));
    let stop = |tokens: &mut Vec<Token>, words: &[&str]| {
        put(tokens, i - comma, i + 1, words);
        tokens[i - comma].kind = WordKind::Sign('.');
    };
    // "And in the living room there is a couch", "and the living room has a couch".
    let the = if word(tokens, i + 1) == "in" { i + 2 } else { i + 1 };
    if word(tokens, the) == "the"
        && let Some(end) = room(tokens, the + 1)
    {
        let goes_on = match word(tokens, i + 1) {
            "in" => matches!(word(tokens, end), "there" | "stands" | "stand" | "is" | "are"),
            _ => HAS.contains(&word(tokens, end)),
        };
        if goes_on {
            stop(tokens, &["."]);
        }
        return goes_on;
    }
    if is_comma {
        return false;
    }
    // "A bed in the bedroom and a couch in the living room".
    let before = (1..=LONGEST).find_map(|n| {
        let from = (i - comma).checked_sub(n)?;
        let in_the = from >= 2 && word(tokens, from - 2) == "in" && word(tokens, from - 1) == "the";
        (in_the && room(tokens, from) == Some(i - comma)).then_some(())
    });
    let first = i + 1 + usize::from(matches!(word(tokens, i + 1), "just" | "only"));
    let starts =
        matches!(word(tokens, first), "a" | "an") || count(tokens.get(first..first + 1).unwrap_or_default()).is_some();
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!'));
    let end = tokens[first..].iter().position(ends).map_or(tokens.len(), |n| first + n);
    let after = (first + 1..end)
        .find(|k| word(tokens, *k) == "in" && word(tokens, k + 1) == "the" && room(tokens, k + 2) == Some(end));
    let has_verb = |end: usize| (i + 1..end).any(|k| get().verb(&tokens[k..=k]).is_some());
    if before.is_none() || !starts || after.is_none_or(has_verb) {
        return false;
    }
    stop(tokens, &[".", "there", "is"]);
    room_first(tokens, i - comma);
    let next = i - comma + 1;
    let end = tokens[next..].iter().position(ends).map_or(tokens.len(), |n| next + n);
    room_first(tokens, end);
    true
}

/// "Three desks, a cabinet and a board in the office": in the office there are all of them. The sentence ends at a token.
fn room_first(tokens: &mut [Token], stop: usize) {
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | ';' | ':' | '!'));
    let from = tokens[..stop].iter().rposition(ends).map_or(0, |n| n + 1);
    let in_room =
        |k: &usize| word(tokens, *k) == "in" && word(tokens, k + 1) == "the" && room(tokens, k + 2) == Some(stop);
    let Some(place) = (from + 1..stop).find(in_room) else { return };
    let there = if word(tokens, from) == "there" { 2 } else { 0 };
    let first = from + there + usize::from(matches!(word(tokens, from + there), "just" | "only"));
    let counted = matches!(word(tokens, first), "a" | "an") || count(&tokens[first..=first]).is_some();
    let several = tokens[first..place].iter().any(|t| t.is(",") || t.is("and"));
    let says = (first..place).any(|k| get().verb(&tokens[k..=k]).is_some());
    if !counted || !several || says {
        return;
    }
    // What is in another order is all where the whole of it is.
    let whole = tokens[from].at.start..tokens[stop - 1].at.end;
    tokens[from..stop].iter_mut().for_each(|token| token.at = whole.clone());
    tokens[from..stop].rotate_left(place - from);
}

/// "A bedroom for my twin daughters", "a room for my teenage daughter": for twin daughters, a bedroom for a teenage daughter.
fn whose(tokens: &mut Vec<Token>, i: usize) -> bool {
    let owned =
        word(tokens, i) == "for" && matches!(word(tokens, i + 1), "my" | "our" | "his" | "her" | "their" | "the");
    let who = (i + 2..i + 5).find(|k| CHILDREN.contains(&word(tokens, *k)));
    let Some(who) = who.filter(|_| owned) else { return false };
    if i > 0 && word(tokens, i - 1) == "room" && (i < 2 || matches!(word(tokens, i - 2), "a" | "the")) {
        put(tokens, i - 1, i, &["bedroom"]);
    }
    let one = !tokens[who].text.ends_with('s');
    put(tokens, i + 1, i + 2, &["a"][..usize::from(one)]);
    true
}

/// The words that say for which child a bedroom is: its beds and its furniture follow from them.
pub fn children(tokens: &[Token]) -> Vec<usize> {
    let is_for = |i: &usize| word(tokens, *i) == "for" && (0..*i).any(|k| word(tokens, k).ends_with("bedroom"));
    let Some(from) = (0..tokens.len()).find(is_for) else { return Vec::new() };
    let who = (from + 1..from + 5).find(|k| CHILDREN.contains(&word(tokens, *k)));
    who.map_or_else(Vec::new, |who| (from + 1..=who).collect())
}

/// "A studio where a couple sleeps and works": for a couple.
fn lives(tokens: &mut Vec<Token>, i: usize) -> bool {
    const DOES: [&str; 14] = [
        "sleep", "sleeps", "work", "works", "live", "lives", "eat", "eats", "cook", "cooks", "relax", "relaxes",
        "study", "studies",
    ];
    if word(tokens, i) != "where" {
        return false;
    }
    let whom = |k: usize| {
        word(tokens, k) == "couple" || get().is(word(tokens, k), Class::Person) || word(tokens, k) == "family"
    };
    let Some(who) = (i + 1..i + 4).find(|k| whom(*k)) else { return false };
    let mut end = who + 1;
    while DOES.contains(&word(tokens, end))
        || matches!(word(tokens, end), "and" | "can") && DOES.contains(&word(tokens, end + 1))
    {
        end += 1;
    }
    if end == who + 1 {
        return false;
    }
    let works = (who..end).any(|k| word(tokens, k).starts_with("work") || word(tokens, k).starts_with("stud"));
    let desk = works && !tokens.iter().any(|t| t.is("desk") || t.is("desks"));
    let said: Vec<String> = (i + 1..=who).map(|k| tokens[k].text.clone()).collect();
    let more: &[&str] = if desk { &["with", "a", "desk"] } else { &[] };
    let said: Vec<&str> =
        ["for"].into_iter().chain(said.iter().map(String::as_str)).chain(more.iter().copied()).collect();
    put(tokens, i, end, &said);
    true
}

/// "A shared kitchen", in a home: a kitchen.
fn own_kitchen(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "shared" | "communal") && room(tokens, i + 1).is_some() && is_home(tokens, i);
    if said {
        let name = tokens[i + 1].text.clone();
        put(tokens, i, i + 2, &[&name]);
    }
    said
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn homes_are_said_plainly() {
        for (text, becomes) in [
            ("a flat for three people: each has own bedroom", "a flat for three people with three bedrooms"),
            ("a student flat where each person has their own room", "a student flat with three bedrooms"),
            (
                "a flat with a bed in the bedroom and a couch in the living room.",
                "a flat with a bed in the bedroom . there is a couch in the living room .",
            ),
            (
                "in the bedroom there is a bed, and in the living room there is a couch",
                "in the bedroom there is a bed . in the living room there is a couch",
            ),
            ("the bedroom has a bed, and the kitchen has a table", "the bedroom has a bed . the kitchen has a table"),
            (
                "two bedrooms, one with a desk and one with a crib",
                "two bedrooms . the first bedroom has a desk . the second bedroom has a crib",
            ),
            (
                "the bedroom has a bed, the living room needs a sofa.",
                "the bedroom has a bed . the living room needs a sofa .",
            ),
            (
                "two desks, shelves and a board in the office, and just a table, a chair on one side in the kitchen.",
                "in the office two desks , shelves and a board . in the kitchen there is just a table , a chair on one \
                 side .",
            ),
            ("a flat with two rooms: a bedroom and a kitchen", "a flat with a bedroom and a kitchen"),
            ("a room for two boys with bunk beds", "a room for two boys with a bunk bed"),
            ("a room for four kids with bunk beds", "a room for four kids with bunk beds"),
            (
                "a two-bedroom flat with a living room with a sofa, one bedroom with a double bed, and a smaller bedroom with a desk.",
                "a two-bedroom flat with a living room with a sofa . the first bedroom has a double bed . the second small bedroom \
                 has a desk .",
            ),
            ("a room for my teenage daughter", "a bedroom for a teenage daughter"),
            ("a flat. the larger bedroom has a bed", "a flat . the large bedroom has a bed"),
            (
                "a two-bedroom flat. the main bedroom has a bed, and the other one has a desk",
                "a two-bedroom flat . the main bedroom has a bed , and the other bedroom has a desk",
            ),
            (
                "two bedrooms, one for the parents with a bed and one for our son with a crib",
                "two bedrooms . the parents bedroom has a bed . the kids bedroom has a crib",
            ),
            (
                "two bedrooms. the larger bedroom has a bed, the smaller one two cribs",
                "two bedrooms . the large bedroom has a bed . the other bedroom has two cribs",
            ),
            (
                "the master has a bed, the other one a smaller lamp",
                "the master has a bed , the other one a smaller lamp",
            ),
            ("a bedroom for my twin daughters", "a bedroom for twin daughters"),
            ("a studio where a couple sleeps and works", "a studio for a couple with a desk"),
            ("a lamp on the desk and a cup on the shelf", "a lamp on the desk and a cup on the shelf"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
