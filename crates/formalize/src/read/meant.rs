//! What people mean who name a thing by its use or as a whole: a wall of books is bookshelves, an audience is its seats.

use super::lexicon::{Class, get, plural};
use super::number;
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use super::zones::HOMES;
use crate::furnish::kinds;

/// "A bookshelf wall", "a wall of books": three bookshelves side by side; so are mirrors.
pub(super) fn walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SHELVES: [&str; 6] = ["books", "bookshelves", "bookcases", "shelves", "bookshelf", "bookcase"];
    if !matches!(word(tokens, i), "a" | "one" | "the") {
        return false;
    }
    let first = i + 1 + usize::from(matches!(word(tokens, i + 1), "whole" | "full" | "big" | "large"));
    let mirrors = match [word(tokens, first), word(tokens, first + 1), word(tokens, first + 2)] {
        ["wall", "of", "mirrors"] => Some(first + 3),
        ["mirror" | "mirrored", "wall", _] => Some(first + 2),
        _ => None,
    };
    if let Some(end) = mirrors {
        // "Three treadmills facing the mirror wall": they look straight at that wall.
        let faced = i > 0 && word(tokens, i - 1) == "facing" && ends(tokens, end);
        let all = ["the", "back", "wall", "and", "three", "gym", "mirrors", "on", "the", "back", "wall"];
        put(tokens, i, end, if faced { &all } else { &all[4..7] });
        return true;
    }
    let wine = match [word(tokens, first), word(tokens, first + 1), word(tokens, first + 2)] {
        ["wall", "of", "wine" | "wines"] => Some(first + 3),
        ["wine", "wall", _] => Some(first + 2),
        _ => None,
    };
    if let Some(end) = wine {
        put(tokens, i, end, &["three", "wine", "racks"]);
        return true;
    }
    let end = match [word(tokens, first), word(tokens, first + 1), word(tokens, first + 2)] {
        ["wall", "of", books] if SHELVES.contains(&books) => first + 3,
        ["bookshelf" | "bookcase" | "book", "wall", _] => first + 2,
        _ => return false,
    };
    put(tokens, i, end, &["three", "bookshelves"]);
    true
}

/// "A boxing gym with a ring": one to box in.
pub(super) fn ring(tokens: &mut Vec<Token>, i: usize) -> bool {
    let boxes = tokens.iter().any(|t| t.is("boxing"));
    if !boxes || word(tokens, i) != "ring" || i == 0 || word(tokens, i - 1) == "boxing" {
        return false;
    }
    put(tokens, i, i + 1, &["boxing", "ring"]);
    true
}

/// "A nurse station with a desk" is a room where a request begins with it; elsewhere it is a desk.
pub(super) fn nurse_station(tokens: &mut Vec<Token>, i: usize) -> bool {
    let begins = i == 1 && matches!(word(tokens, 0), "a" | "the");
    let nurses = matches!(word(tokens, i), "nurse" | "nurses" | "nurses'" | "nurse's");
    if !begins || !nurses || word(tokens, i + 1) != "station" {
        return false;
    }
    put(tokens, i, i + 2, &["nursing", "office"]);
    true
}

/// "A basement with a pool table": no cellar for things that nobody needs.
pub(super) fn basement(tokens: &mut Vec<Token>, i: usize) -> bool {
    const PLAYS: [&str; 8] = ["pool", "billiard", "billiards", "snooker", "ping-pong", "foosball", "bar", "darts"];
    if !matches!(word(tokens, i), "basement" | "cellar") || word(tokens, i + 1) != "with" {
        return false;
    }
    if !tokens[i..].iter().any(|t| PLAYS.iter().any(|plays| t.is(plays))) {
        return false;
    }
    put(tokens, i, i + 1, &["games", "room"]);
    true
}

/// "For a family with two children": so many people, and their parents.
pub(super) fn with_children(tokens: &mut Vec<Token>, i: usize) -> bool {
    let group = matches!(word(tokens, i), "family" | "couple") && word(tokens, i + 1) == "with";
    let Some((n, words)) = number::count(tokens.get(i + 2..).unwrap_or(&[])).filter(|_| group) else { return false };
    let end = i + 2 + words;
    if !matches!(word(tokens, end), "children" | "kids" | "child" | "kid" | "teenagers") {
        return false;
    }
    let from = i - usize::from(i > 0 && matches!(word(tokens, i - 1), "a" | "one" | "the"));
    const NUMBERS: [&str; 5] = ["three", "four", "five", "six", "seven"];
    let Some(all) = (n >= 1.0).then(|| NUMBERS.get(n as usize - 1)).flatten() else { return false };
    put(tokens, from, end + 1, &[all, "people"]);
    true
}

/// "A U-shaped conference table", "tables in a U": a table like a U.
pub(super) fn horseshoe_table(tokens: &mut Vec<Token>, i: usize) -> bool {
    let is_table = |at: usize| matches!(word(tokens, at), "table" | "tables");
    let numbered = i > 0 && number::count(&tokens[i - 1..i]).is_some_and(|(n, _)| n > 1.0);
    let end = match word(tokens, i) {
        "u-shaped" | "horseshoe" | "horseshoe-shaped" => (i + 1..i + 3).find(|at| is_table(*at)).map(|at| at + 1),
        "table" | "tables" => {
            let at = i + 1 + usize::from(matches!(word(tokens, i + 1), "arranged" | "set" | "placed"));
            match [word(tokens, at), word(tokens, at + 1), word(tokens, at + 2), word(tokens, at + 3)] {
                ["in", "a", "u", "shape" | "form"] => Some(at + 4),
                ["in", "a", "u" | "u-shape" | "horseshoe", _] => Some(at + 3),
                ["in", "u", "shape" | "form", _] => Some(at + 3),
                ["in", "u-shape", _, _] => Some(at + 2),
                _ => None,
            }
        }
        _ => None,
    };
    let Some(end) = end.filter(|_| !numbered) else { return false };
    let has_article = i > 0 && matches!(word(tokens, i - 1), "a" | "an" | "one" | "the");
    put(tokens, i, end, if has_article { &["horseshoe", "table"] } else { &["a", "horseshoe", "table"] });
    true
}

/// "Barrels as tables": barrels that one stands or sits at.
pub(super) fn barrel_tables(tokens: &mut Vec<Token>, i: usize) -> bool {
    let end = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["barrels", "as", "tables", _] => i + 3,
        ["barrels", "used" | "serving", "as", "tables"] => i + 4,
        _ => return false,
    };
    put(tokens, i, end, &["barrel", "tables"]);
    true
}

/// "Tables for groups of four" are group tables.
pub(super) fn group_tables(tokens: &mut Vec<Token>, i: usize) -> bool {
    let groups =
        matches!([word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)], ["tables", "for", "groups" | "group"]);
    if !groups {
        return false;
    }
    let of = number::count(tokens.get(i + 4..).unwrap_or(&[])).filter(|_| word(tokens, i + 3) == "of");
    let end = of.map_or(i + 3, |(_, words)| i + 4 + words);
    let end = end + usize::from(matches!(word(tokens, end), "work" | "people" | "pupils" | "students"));
    put(tokens, i, end, &["group", "tables"]);
    true
}

/// "A garage for two cars with a workbench", "for a car with bikes": the garage has the workbench.
pub(super) fn vehicles(tokens: &mut Vec<Token>, i: usize) -> bool {
    const VEHICLES: [&str; 8] = ["car", "van", "truck", "bike", "bicycle", "motorcycle", "motorbike", "vehicle"];
    let vehicle = word(tokens, i + 2);
    let are_some = VEHICLES.contains(&vehicle.strip_suffix('s').unwrap_or(vehicle)) && word(tokens, i + 3) == "with";
    let is_counted = || matches!(word(tokens, i + 1), "a" | "one") || number::count(&tokens[i + 1..]).is_some();
    if word(tokens, i) != "for" || !are_some || !is_counted() {
        return false;
    }
    put(tokens, i, i + 1, &["with"]);
    put(tokens, i + 3, i + 4, &["and"]);
    true
}

/// "A warehouse for testing a mobile robot, with four rows of shelves", "a hall to test a robot": it has the robot and the shelves.
pub(super) fn tested(tokens: &mut Vec<Token>, i: usize) -> bool {
    let purpose = match (word(tokens, i), word(tokens, i + 1)) {
        ("for", does) => matches!(does, "testing" | "training" | "demonstrating" | "repairing" | "assembling"),
        ("to", does) => matches!(does, "test" | "train" | "demonstrate" | "repair" | "assemble"),
        _ => false,
    };
    if !purpose || !matches!(word(tokens, i + 2), "a" | "an" | "our" | "the" | "my") {
        return false;
    }
    let Some(name) = noun(tokens, i + 3) else { return false };
    put(tokens, i, i + 2, &["with"]);
    let end = name.end - 1;
    let comma = usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    if word(tokens, end + comma) == "with" {
        put(tokens, end, end + comma + 1, &["and"]);
    }
    true
}

/// "A studio with a separate bathroom": such a room has a door to one.
pub(super) fn studio_bathroom(tokens: &mut Vec<Token>, i: usize) -> bool {
    let is_studio = |t: &Token| ["studio", "bedsit", "loft"].iter().any(|name| t.is(name));
    let separate = usize::from(matches!(word(tokens, i + 1), "separate" | "small" | "private"));
    let end = i + 2 + separate;
    let room = usize::from(word(tokens, end - 1) == "shower" && word(tokens, end) == "room");
    let named = word(tokens, end - 1) == "bathroom" || room == 1;
    let closes = tokens.get(end + room).is_none_or(|t| !t.word() || t.is("and"));
    if word(tokens, i) != "a" || !named || !closes || !tokens[..i].iter().any(is_studio) {
        return false;
    }
    put(tokens, i, end + room, &["a", "bathroom", "door"]);
    true
}

/// "A café with a toilet", "a restaurant with restrooms": a room next door.
pub(super) fn guest_toilets(tokens: &mut Vec<Token>, i: usize) -> bool {
    const PUBLIC: [&str; 18] = [
        "restaurant",
        "cafe",
        "café",
        "bar",
        "pub",
        "bistro",
        "diner",
        "pizzeria",
        "office",
        "shop",
        "store",
        "library",
        "gym",
        "gallery",
        "bakery",
        "salon",
        "lobby",
        "showroom",
    ];
    const TOILETS: [&str; 6] = ["toilet", "toilets", "restroom", "restrooms", "washroom", "washrooms"];
    let before = |k: usize| i.checked_sub(k).map_or("", |k| word(tokens, k));
    let whose = usize::from(matches!(before(1), "guest" | "customer"));
    let number = usize::from(matches!(before(1 + whose), "a" | "one" | "two"));
    let listed = whose + number > 0 || matches!(before(1), "with" | "and" | "has");
    let ends = tokens.get(i + 1).is_none_or(|t| !t.word() || t.is("and"));
    let mut main = tokens.iter().take(i).take_while(|t| !t.is("with"));
    if !TOILETS.contains(&word(tokens, i)) || !listed || !ends || !main.any(|t| PUBLIC.iter().any(|word| t.is(word))) {
        return false;
    }
    let from = i - whose - number;
    put(tokens, from, i + 1, &["a", "public", "toilet"]);
    true
}

/// "Two sinks under a large mirror": the mirror hangs above them.
pub(super) fn under_mirror(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SINKS: [&str; 4] = ["sink", "washbasin", "basin", "vanity"];
    if i == 0
        || !matches!(word(tokens, i), "under" | "below" | "beneath")
        || !matches!(word(tokens, i + 1), "a" | "one")
    {
        return false;
    }
    let noun = word(tokens, i - 1).to_owned();
    let one = SINKS.contains(&noun.as_str());
    let several = noun.strip_suffix('s').is_some_and(|noun| SINKS.contains(&noun)) || noun == "vanities";
    let Some(mirror) = (i + 2..i + 5).find(|k| word(tokens, *k) == "mirror").filter(|_| one || several) else {
        return false;
    };
    let mirror_words: Vec<String> = tokens[i + 1..=mirror].iter().map(|t| t.text.clone()).collect();
    let words = ["and"].into_iter().chain(mirror_words.iter().map(String::as_str));
    let words: Vec<&str> = words.chain(["above", if one { "it" } else { "them" }]).collect();
    put(tokens, i, mirror + 1, &words);
    true
}

/// "A two-car garage with a workbench": it has two cars and a workbench.
pub(super) fn garage_for(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((first, "car")) = word(tokens, i).split_once('-') else { return false };
    let cars = match first {
        "single" | "one" => ["one", "car"],
        "double" | "two" => ["two", "cars"],
        "three" => ["three", "cars"],
        _ => return false,
    };
    if word(tokens, i + 1) != "garage" {
        return false;
    }
    let has_more = word(tokens, i + 2) == "with";
    let link = if has_more { "and" } else { "" };
    let words: Vec<&str> = ["garage", "with"].into_iter().chain(cars).chain([link]).filter(|w| !w.is_empty()).collect();
    put(tokens, i, i + 2 + usize::from(has_more), &words);
    true
}

/// "An audience of forty", "an audience for forty": forty seats.
pub(super) fn audience(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "audience" || !matches!(word(tokens, i + 1), "of" | "for") {
        return false;
    }
    let Some((_, used)) = number::count(tokens.get(i + 2..).unwrap_or_default()) else { return false };
    let last = i + 2 + used;
    let people = usize::from(matches!(word(tokens, last), "people" | "persons" | "guests" | "spectators"));
    let article = usize::from(i > 0 && matches!(word(tokens, i - 1), "a" | "an" | "the"));
    let number: Vec<String> = tokens[i + 2..last].iter().map(|t| t.text.clone()).collect();
    // "Chairs for an audience of twenty" are these seats.
    let before = i - article;
    let seats = ["chairs", "seats", "stools"].into_iter();
    let own = seats.filter(|_| before > 1 && word(tokens, before - 1) == "for");
    let own = own.into_iter().find(|seats| word(tokens, before - 2) == *seats);
    let first = if own.is_some() { before - 2 } else { before };
    let words: Vec<&str> = number.iter().map(String::as_str).chain([own.unwrap_or("seats")]).collect();
    put(tokens, first, last + people, &words);
    true
}

/// "A lobby with a desk and seating": a part of the room with seats.
pub(super) fn seating(tokens: &mut Vec<Token>, i: usize) -> bool {
    let bare = i > 0 && matches!(word(tokens, i - 1), "and" | "with" | "some" | "comfortable" | "has");
    let ends = tokens.get(i + 1).is_none_or(|t| !t.word() || t.is("and"));
    if word(tokens, i) != "seating" || !bare || !ends {
        return false;
    }
    let first = i - usize::from(word(tokens, i - 1) == "some");
    put(tokens, first, i + 1, &["a", "seating", "area"]);
    true
}

/// "A cafe with eight seats and a bookshelf": two of them at each of its tables.
pub(super) fn covers(tokens: &mut Vec<Token>, i: usize) -> bool {
    const CAFES: [&str; 5] = ["cafe", "café", "coffeehouse", "tearoom", "bistro"];
    const TABLES: [&str; 12] =
        ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
    let before = tokens[..i].iter().rev().take(4).any(|t| CAFES.iter().any(|place| t.is(place)));
    if word(tokens, i) != "with" || !before {
        return false;
    }
    let Some((n, used)) = number::count(tokens.get(i + 1..).unwrap_or_default()) else { return false };
    let seats = i + 1 + used;
    let Some(tables) = (1..=TABLES.len()).find(|tables| (2 * tables) as f64 == n) else { return false };
    if !matches!(word(tokens, seats), "seats" | "covers") {
        return false;
    }
    let noun = if tables == 1 { "table" } else { "tables" };
    put(tokens, i + 1, seats + 1, &[TABLES[tables - 1], "cafe", noun]);
    true
}

/// "Counter seating": stools at a bar.
pub(super) fn counter_seats(tokens: &mut Vec<Token>, i: usize) -> bool {
    let seats = matches!(word(tokens, i + 1), "seating" | "seats");
    if !matches!(word(tokens, i), "counter" | "bar") || !seats {
        return false;
    }
    put(tokens, i, i + 2, &["a", "bar", "counter", "and", "six", "bar", "stools"]);
    true
}

/// "A two bedroom flat": a two-bedroom flat.
pub(super) fn bedrooms(tokens: &mut Vec<Token>, i: usize) -> bool {
    let is_home = HOMES.iter().any(|home| tokens.get(i + 2).is_some_and(|t| t.is(home)));
    let counted = number::count(&tokens[i..]).filter(|(_, used)| *used == 1);
    if !is_home || counted.is_none() || word(tokens, i + 1) != "bedroom" || matches!(word(tokens, i), "a" | "one") {
        return false;
    }
    let joined = format!("{}-bedroom", tokens[i].text);
    put(tokens, i, i + 2, &[joined.as_str()]);
    true
}

/// "A hairdresser's with three mirrors": the salon.
pub(super) fn whose(tokens: &mut Vec<Token>, i: usize) -> bool {
    let ends = tokens.get(i + 1).is_none_or(|t| !t.word() || t.is("with") || t.is("for"));
    let Some(kind) = kinds::of(&tokens[i].text).filter(|_| ends && tokens[i].owner) else { return false };
    let words: Vec<&str> = kind.name.split(' ').collect();
    put(tokens, i, i + 1, &words);
    true
}

/// "An office with four teams of four and a kitchenette": for sixteen people, with a kitchenette. "A laboratory with eight
/// workplaces", "a classroom with twenty pupils": for so many people.
pub(super) fn teams(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOST: f64 = 60.0;
    const PLACES: [&str; 2] = ["workplaces", "workspaces"];
    if !matches!(word(tokens, i), "with" | "for" | "has") {
        return false;
    }
    let lexicon = get();
    // "A classroom with twenty pupils", not a picture of two people.
    let room = if i > 0 { word(tokens, i - 1) } else { "" };
    let is_room = word(tokens, i) == "with" && (room.ends_with("room") || lexicon.room(room).is_some());
    let counted = |from: usize| number::count(tokens.get(from..).unwrap_or_default());
    let Some((n, used)) = counted(i + 1) else { return false };
    let of = i + 1 + used;
    let (people, end) = match (word(tokens, of), word(tokens, of + 1), counted(of + 2)) {
        ("teams", "of", Some((each, more))) => (n * each, of + 2 + more),
        (places, ..) if PLACES.contains(&places) => (n, of + 1),
        // Not "two children's beds" or "six staff lockers".
        (who, ..) if is_room && lexicon.is(who, Class::Person) && is_alone(tokens, of) => (n, of + 1),
        ("work", "places" | "spaces", _) => (n, of + 2),
        _ => return false,
    };
    if people.fract() != 0.0 || people > MOST {
        return false;
    }
    let end = end + usize::from(matches!(word(tokens, end), "people" | "persons"));
    if word(tokens, end) == "and" {
        put(tokens, end, end + 1, &["with"]);
    }
    put(tokens, i, end, &["for", "people"]);
    let at = tokens[i].at.clone();
    let number = Token { kind: WordKind::Number(people), text: people.to_string(), at, owner: false, capital: false };
    tokens.insert(i + 1, number);
    true
}

/// Whether a word is the last of its noun phrase.
fn is_alone(tokens: &[Token], i: usize) -> bool {
    !tokens[i].owner && (ends(tokens, i + 1) || word(tokens, i + 1) == "with")
}

/// "A three-bedroom family house": the house of parents and two children.
pub(super) fn family(tokens: &mut Vec<Token>, i: usize) -> bool {
    let home = match word(tokens, i + 1) {
        home @ ("house" | "home" | "apartment" | "flat") if word(tokens, i) == "family" => home.to_owned(),
        _ => return false,
    };
    // Whom it is for may be said.
    match word(tokens, i + 2) {
        "for" => put(tokens, i, i + 2, &[home.as_str()]),
        _ => put(tokens, i, i + 2, &[home.as_str(), "for", "four", "people"]),
    }
    true
}

/// "A guest room that doubles as a home office": it has a desk, too.
pub(super) fn doubles(tokens: &mut Vec<Token>, i: usize) -> bool {
    const LONGEST: usize = 3;
    const USES: [(&[&str], &[&str]); 7] = [
        (&["office", "study", "workspace"], &["a", "desk"]),
        (&["guest room", "guest bedroom", "spare room"], &["a", "sofa", "bed"]),
        (&["playroom", "play room", "nursery"], &["a", "play", "mat", "and", "a", "toy", "box"]),
        (&["gym", "fitness room"], &["an", "exercise", "mat", "and", "a", "dumbbell", "rack"]),
        (&["library", "reading room"], &["two", "bookshelves"]),
        (&["workshop", "craft room"], &["a", "workbench"]),
        (&["dining room"], &["a", "dining", "table"]),
    ];
    let first = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["that" | "which", "doubles", "as"] => i + 3,
        ["that" | "which", "is", "also"] => i + 3,
        ["doubling", "as", _] => i + 2,
        _ => return false,
    };
    let first = first + usize::from(matches!(word(tokens, first), "a" | "an" | "the"));
    let found = (1..=LONGEST).rev().find_map(|n| {
        let said: Vec<&str> = (first..first + n).map(|k| word(tokens, k)).collect();
        let said = said.join(" ");
        let is = |name: &&str| said == **name || said.ends_with(&format!(" {name}"));
        USES.iter().find(|(names, _)| names.iter().any(is)).map(|(_, has)| (first + n, *has))
    });
    let Some((end, has)) = found else { return false };
    let goes_on = word(tokens, end) == "with";
    if goes_on {
        put(tokens, end, end + 1, &["and"]);
    }
    let words: Vec<&str> = std::iter::once("with").chain(has.iter().copied()).collect();
    put(tokens, i, end, &words);
    true
}

/// "A walk-in wardrobe corner" of a bedroom: two wardrobes side by side.
pub(super) fn walk_in(tokens: &mut Vec<Token>, i: usize) -> bool {
    let wardrobe = matches!(word(tokens, i + 1), "wardrobe" | "closet");
    let part = matches!(word(tokens, i + 2), "corner" | "area" | "nook" | "zone");
    if word(tokens, i) != "walk-in" || !wardrobe || !part {
        return false;
    }
    let article = usize::from(i > 0 && matches!(word(tokens, i - 1), "a" | "the"));
    put(tokens, i - article, i + 3, &["two", "wardrobes"]);
    true
}

/// "A warehouse with two loading docks": a gate for each, with pallets.
pub(super) fn docks(tokens: &mut Vec<Token>, i: usize) -> bool {
    let docks = matches!(word(tokens, i), "loading") && matches!(word(tokens, i + 1), "docks" | "bays" | "gates");
    if docks {
        put(tokens, i, i + 2, &["garage", "doors"]);
    }
    docks
}

/// "A gym with treadmills and weights": a rack of them.
pub(super) fn weights(tokens: &mut Vec<Token>, i: usize) -> bool {
    let listed =
        i > 0 && (matches!(word(tokens, i - 1), "and" | "with" | "some") || tokens[i - 1].kind == WordKind::Sign(','));
    let gym = tokens[..i].iter().any(|t| t.is("gym") || t.is("fitness"));
    let ends = tokens.get(i + 1).is_none_or(|t| !t.word() || t.is("and"));
    if !matches!(word(tokens, i), "weights" | "dumbbells") || !listed || !gym || !ends {
        return false;
    }
    let first = i - usize::from(word(tokens, i - 1) == "some");
    put(tokens, first, i + 1, &["a", "dumbbell", "rack"]);
    true
}

/// "A kitchen-diner": a kitchen that one eats in.
pub(super) fn kitchen_diner(tokens: &mut Vec<Token>, i: usize) -> bool {
    let diner = word(tokens, i) == "kitchen-diner";
    if diner {
        put(tokens, i, i + 1, &["dining", "kitchen"]);
    }
    diner
}

/// "A science lab for a school", "a chemistry lab in a high school": the classroom.
pub(super) fn school_lab(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SUBJECTS: [&str; 4] = ["science", "chemistry", "physics", "biology"];
    if !matches!(word(tokens, i), "lab" | "laboratory") || !matches!(word(tokens, i + 1), "for" | "in" | "at" | "of") {
        return false;
    }
    let mut last = i + 2 + usize::from(matches!(word(tokens, i + 2), "a" | "the"));
    last += usize::from(matches!(word(tokens, last), "high" | "secondary" | "middle" | "grammar"));
    if word(tokens, last) != "school" {
        return false;
    }
    let first = i - usize::from(i > 0 && SUBJECTS.contains(&word(tokens, i - 1)));
    put(tokens, first, last + 1, &["science", "classroom"]);
    true
}

/// "A shop selling clothes", "a store that sells old books": the shop has a name.
pub(super) fn sells(tokens: &mut Vec<Token>, i: usize) -> bool {
    let shop = word(tokens, i).to_owned();
    if !matches!(shop.as_str(), "shop" | "store" | "boutique") {
        return false;
    }
    let first = match [word(tokens, i + 1), word(tokens, i + 2)] {
        ["selling", _] => i + 2,
        ["that" | "which", "sells"] => i + 3,
        _ => return false,
    };
    // Of "old books" the last word says what is sold.
    for last in first..first + 3 {
        let goods = word(tokens, last).to_owned();
        let named = |goods: &str| {
            let name = format!("{goods} {shop}");
            kinds::all().iter().any(|kind| kind.name == name || kind.also.iter().any(|also| *also == name))
        };
        let one = goods.strip_suffix('s').unwrap_or(&goods).to_owned();
        if let Some(goods) = [goods, one].iter().find(|goods| !goods.is_empty() && named(goods)) {
            put(tokens, i, last + 1, &[goods, &shop]);
            return true;
        }
    }
    false
}

/// "A window bar", "a counter along the window": one sits there and looks out.
pub(super) fn window_counter(tokens: &mut Vec<Token>, i: usize) -> bool {
    let end = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["window", "bar", ..] => i + 2,
        ["counter" | "bar", "along" | "at" | "by" | "under", "the", "window" | "windows"] => i + 4,
        ["counter", "seating" | "seats", "by" | "at" | "along", "the"] if word(tokens, i + 4).starts_with("window") => {
            i + 5
        }
        _ => return false,
    };
    let article = i > 0 && matches!(word(tokens, i - 1), "a" | "the" | "one");
    put(tokens, i, end, if article { &["window", "counter"] } else { &["a", "window", "counter"] });
    true
}

/// "A lobby with a reception", "a law office with a reception": the desk. "A reception stand": where a host receives guests.
pub(super) fn reception(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) == "reception" && word(tokens, i + 1) == "stand" {
        put(tokens, i, i + 2, &["host", "stand"]);
        return true;
    }
    let article = i > 0 && matches!(word(tokens, i - 1), "a" | "the");
    let goes_on = matches!(word(tokens, i + 1), "desk" | "area" | "room" | "counter" | "stand" | "hall" | "table");
    const RECEIVE: [&str; 10] =
        ["lobby", "office", "practice", "clinic", "salon", "spa", "gym", "surgery", "studio", "agency"];
    let receives = tokens[..i].iter().any(|t| RECEIVE.iter().any(|place| t.is(place)));
    if word(tokens, i) != "reception" || !article || goes_on || !receives {
        return false;
    }
    put(tokens, i, i + 1, &["reception", "desk"]);
    true
}

/// "A dentist's practice with two treatment rooms": rooms of a dentist.
pub(super) fn practice_rooms(tokens: &mut Vec<Token>, i: usize) -> bool {
    const OF: [(&str, &[&str]); 2] =
        [("dental", &["dentist", "dentist's", "dental", "dentists"]), ("veterinary", &["vet", "vet's", "veterinary"])];
    let is_room = matches!(word(tokens, i + 1), "room" | "rooms");
    if !matches!(word(tokens, i), "treatment" | "examination" | "exam") || !is_room || i == 0 {
        return false;
    }
    let of = |names: &[&str]| tokens[..i].iter().any(|t| names.iter().any(|name| t.is(name)));
    let Some((practice, _)) = OF.iter().find(|(practice, names)| of(names) && word(tokens, i - 1) != *practice) else {
        return false;
    };
    let (kind, room) = (word(tokens, i).to_owned(), word(tokens, i + 1).to_owned());
    put(tokens, i, i + 2, &[practice, &kind, &room]);
    true
}

/// "Twenty chairs with tables": the tables are beside the chairs, not on them.
pub(super) fn chairs_with_tables(tokens: &mut Vec<Token>, i: usize) -> bool {
    let seats = matches!(word(tokens, i), "chairs" | "seats" | "stools");
    let tables = matches!(word(tokens, i + 2), "tables" | "desks");
    if !seats || word(tokens, i + 1) != "with" || !tables {
        return false;
    }
    put(tokens, i + 1, i + 2, &["and"]);
    true
}

/// "A waiting room in a clinic with chairs": what is spoken of is a clinic waiting room.
pub(super) fn in_building(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BUILDINGS: [&str; 15] = [
        "clinic",
        "hospital",
        "school",
        "kindergarten",
        "university",
        "college",
        "hotel",
        "museum",
        "factory",
        "restaurant",
        "theatre",
        "theater",
        "airport",
        "library",
        "office",
    ];
    let within = matches!(word(tokens, i), "in" | "of" | "at" | "inside") && matches!(word(tokens, i + 1), "a" | "an");
    // "In a small clinic".
    let looks = tokens.iter().skip(i + 2).take_while(|t| t.word() && get().is_look(&t.text)).count();
    let end = i + 3 + looks;
    let building = word(tokens, end - 1).to_owned();
    let is_said = |t: &Token| t.is("with") || t.is(":") || t.is("has") || t.is("contains");
    let goes_on = tokens.get(end).is_some_and(is_said) || ends(tokens, end);
    if !within || !goes_on || !BUILDINGS.contains(&building.as_str()) || !matches!(word(tokens, 0), "a" | "an" | "the")
    {
        return false;
    }
    // The longest name of a room that the words before it end with.
    let name = |from: usize| (from..i).map(|at| word(tokens, at)).collect::<Vec<_>>().join(" ");
    let is_room = |from: &usize| {
        let name = name(*from);
        kinds::all().iter().any(|kind| kind.name == name || kind.also.iter().any(|also| *also == name))
    };
    let Some(from) = (1..i).find(is_room) else { return false };
    let words: Vec<String> = std::iter::once(building).chain((from..i).map(|at| word(tokens, at).to_owned())).collect();
    put(tokens, from, end, &words.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// "Two beds separated by a curtain": it is between them.
pub(super) fn separated(tokens: &mut Vec<Token>, i: usize) -> bool {
    const PASSED: [&str; 7] = ["door", "wall", "corridor", "hall", "hallway", "opening", "distance"];
    let by = matches!([word(tokens, i), word(tokens, i + 1)], ["separated" | "divided", "by"]);
    let several = i > 0 && plural(word(tokens, i - 1));
    if !by || !several || !matches!(word(tokens, i + 2), "a" | "an" | "one") {
        return false;
    }
    let end = (i + 3..tokens.len()).find(|at| ends(tokens, *at)).unwrap_or(tokens.len());
    let divider = word(tokens, end - 1).to_owned();
    if end > i + 5 || PASSED.contains(&divider.as_str()) {
        return false;
    }
    put(tokens, end - 1, end, &[&divider, "between", "them"]);
    put(tokens, i, i + 2, &["with"]);
    true
}

/// The most words between a number and what it counts.
const LOOKS: usize = 3;
/// "A kitchen with white cabinets": its units are white, worktop and wall cabinets alike.
pub(super) fn kitchen_units(tokens: &mut Vec<Token>, i: usize) -> bool {
    let noun = i + usize::from(word(tokens, i) == "kitchen");
    if !matches!(word(tokens, noun), "cabinets" | "cupboards" | "units" | "cabinetry" | "counters" | "worktops")
        || i == 0
        || !get().is_look(word(tokens, i - 1))
    {
        return false;
    }
    // So many cabinets are single ones.
    let is_counted = (i.saturating_sub(LOOKS)..i).any(|k| number::count(&tokens[k..]).is_some());
    if is_counted || !tokens[..i].iter().any(|t| t.is("kitchen")) {
        return false;
    }
    put(tokens, i, noun + 1, &["kitchen", "counter"]);
    true
}

/// "A restaurant with a wine bar": the bar is a counter in it, not another room.
pub(super) fn bar_of_restaurant(tokens: &mut Vec<Token>, i: usize) -> bool {
    let counter = match word(tokens, i) {
        "wine" | "cocktail" | "tapas" | "oyster" | "beer" | "whisky" => "bar",
        "sushi" => "sushi",
        _ => return false,
    };
    let is_part = i > 1 && matches!(word(tokens, i - 2), "with" | "and" | "has");
    let serves = |t: &Token| {
        let found = kinds::of(&t.text);
        t.word() && found.is_some_and(|kind| matches!(kind.dress, "food" | "pizza" | "wine"))
    };
    if word(tokens, i + 1) != "bar" || !is_part || !tokens[..i - 2].iter().any(serves) {
        return false;
    }
    put(tokens, i, i + 2, &[counter, "counter"]);
    true
}

/// "A bank with three counters": a branch of a bank; a bank of lockers is a row of them.
pub(super) fn bank(tokens: &mut Vec<Token>, i: usize) -> bool {
    let goes_on = matches!(word(tokens, i + 1), "with" | "for") || ends(tokens, i + 1);
    if i > 2 || word(tokens, i) != "bank" || !goes_on {
        return false;
    }
    put(tokens, i, i + 1, &["bank", "branch"]);
    true
}

/// "A king size bed": a king-size bed.
pub(super) fn bed_sizes(tokens: &mut Vec<Token>, i: usize) -> bool {
    let end = i + 2;
    let size = match (word(tokens, i), word(tokens, i + 1)) {
        ("king", "size") => "king-size",
        ("king", "sized") => "king-sized",
        ("queen", "size") => "queen-size",
        ("queen", "sized") => "queen-sized",
        _ => return false,
    };
    if !matches!(word(tokens, end), "bed" | "beds") {
        return false;
    }
    put(tokens, i, end, &[size]);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn what_is_meant_is_said() {
        for (text, becomes) in [
            ("a study with a wall of books", "a study with three bookshelves"),
            ("a lounge with a full bookshelf wall and a lamp", "a lounge with three bookshelves and a lamp"),
            ("a wall of stone", "a wall of stone"),
            ("a three-bedroom family house", "a three-bedroom house for four people"),
            ("a family home for five with a garden", "a home for five with a garden"),
            ("a guest room that doubles as a home office", "a guest room with a desk"),
            ("a study doubling as a guest room with a lamp", "a study with a sofa bed and a lamp"),
            ("a bedroom with a walk-in wardrobe corner and a lamp", "a bedroom with two wardrobes and a lamp"),
            ("a depot with two loading docks", "a depot with two garage doors"),
            ("a boxing gym with a ring and benches", "a boxing gym with a boxing ring and benches"),
            ("a wine bar with a wine wall", "a wine bar with three wine racks"),
            ("a gym with a bench, weights and a mirror", "a gym with a bench , a dumbbell rack and a mirror"),
            ("a shop with weights", "a shop with weights"),
            ("a hall to test a robot", "a hall with a robot"),
            ("a house with a kitchen-diner", "a house with a dining kitchen"),
            ("an office with four teams of four and a sofa", "an office for 16 people with a sofa"),
            ("an office for two teams of six people", "an office for 12 people"),
            ("a room with two teams", "a room with two teams"),
            ("a classroom with 20 pupils and a sink", "a classroom for 20 people with a sink"),
            ("a bedroom with two children's beds", "a bedroom with two children beds"),
            ("an office with six staff lockers", "an office with six staff lockers"),
            ("a lab with eight workplaces and a fume hood", "a lab for 8 people with a fume hood"),
            ("an office with 4 work places, a sofa and a plant", "an office for 4 people , a sofa and a plant"),
            ("a two bedroom flat with a kitchen", "a two-bedroom flat with a kitchen"),
            ("a hairdresser's with three mirrors", "a hair salon with three mirrors"),
            ("a law office with a reception and two desks", "a law office with a reception desk and two desks"),
            ("a studio with a mirrored wall", "a studio with three gym mirrors"),
            ("a garage for two cars with a workbench", "a garage with two cars and a workbench"),
            ("a two-car garage with a workbench", "a garage with two cars and a workbench"),
            ("a double-car garage", "a garage with two cars"),
            ("two sinks under a large mirror and a toilet", "two sinks and a large mirror above them and a toilet"),
            ("a vanity below a mirror", "a vanity and a mirror above it"),
            ("a cafe with a counter and a toilet", "a cafe with a counter and a public toilet"),
            ("a restaurant with toilets and a kitchen", "a restaurant with a public toilet and a kitchen"),
            ("a bathroom with a toilet", "a bathroom with a toilet"),
            ("a studio with a separate bathroom", "a studio with a bathroom door"),
            ("a bedsit with a shower room and a desk", "a bedsit with a bathroom door and a desk"),
            ("a rug under a table with a mirror", "a rug under a table with a mirror"),
            ("a room for two people with a desk", "a room for two people with a desk"),
            ("a stage with an audience of forty people", "a stage with forty seats"),
            ("the audience of a play", "the audience of a play"),
            ("a piano and chairs for an audience of twenty", "a piano and twenty chairs"),
            ("a science lab for a school", "a science classroom"),
            ("a lab in a high school with a desk", "a science classroom with a desk"),
            ("a cafe with a counter along the windows", "a cafe with a window counter"),
            ("a cafe with a bar and stools", "a cafe with a bar and bar stools"),
            ("a small shop selling clothes", "a small clothes shop"),
            ("a store that sells old books and maps", "a book store and maps"),
            ("a shop selling everything", "a shop selling everything"),
            ("a cosy cafe with eight seats and a bookshelf", "a cosy cafe with four cafe tables and a bookshelf"),
            ("a cafe with 2 seats", "a cafe with one cafe table"),
            ("a hall with eight seats", "a hall with eight seats"),
            ("a lobby with a desk and seating", "a lobby with a desk and a seating area"),
            ("a lobby with some seating, a desk and plants", "a lobby with a seating area , a desk and plants"),
            ("a hall seating twenty people", "a hall for twenty people"),
            ("two beds separated by a curtain and a lamp", "two beds with a curtain between them and a lamp"),
            ("a dental practice with two treatment rooms", "a dental practice with two dental treatment rooms"),
            ("a room with ten chairs with tables", "a room with ten chairs and tables"),
            ("a small waiting room in a clinic with a desk", "a small clinic waiting room with a desk"),
            ("a waiting room in a building with a clinic", "a waiting room in a building with a clinic"),
            ("two rooms separated by a door", "two rooms separated by a door"),
            ("a lobby with a reception and a lounge", "a lobby with a reception desk and a lounge"),
            ("a hotel with a reception", "a hotel with a reception"),
            ("a restaurant with a reception stand", "a restaurant with a host stand"),
            ("a ramen place with counter seating", "a ramen place with a bar counter and six bar stools"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
