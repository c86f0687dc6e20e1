//! What people do in a room, as far as furniture follows: "somewhere to work from home" is a desk, children who love dinosaurs
//! have a poster of one, and of a family that watches films nothing follows but a note.

use super::lexicon::{Class, get, singular};
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};

/// Verbs, and the part of a room where that is done (see `data/zones.txt`).
const DONE: [(&str, &str); 31] = [
    ("work", "work"),
    ("study", "study"),
    ("do homework", "homework"),
    ("do their homework", "homework"),
    ("do her homework", "homework"),
    ("do his homework", "homework"),
    ("do my homework", "homework"),
    ("write", "writing"),
    ("read", "reading"),
    ("sit and read", "reading"),
    ("sit", "seating"),
    ("relax", "lounge"),
    ("unwind", "lounge"),
    ("eat", "dining"),
    ("dine", "dining"),
    ("have dinner", "dining"),
    ("have breakfast", "breakfast"),
    ("have lunch", "lunch"),
    ("play", "play"),
    ("play games", "gaming"),
    ("watch tv", "tv"),
    ("watch films", "tv"),
    ("watch movies", "tv"),
    ("draw", "art"),
    ("paint", "art"),
    ("exercise", "exercise"),
    ("work out", "workout"),
    ("stretch", "stretching"),
    ("do yoga", "yoga"),
    ("meditate", "meditation"),
    ("put on makeup", "makeup"),
];
/// What may follow without a change of what is done: "work from home", "eat together".
const HOW: [&str; 15] = [
    "from",
    "home",
    "together",
    "quietly",
    "comfortably",
    "properly",
    "in",
    "peace",
    "down",
    "up",
    "too",
    "on",
    "at",
    "alone",
    "well",
];
/// What is kept somewhere, and the furniture for it.
const KEPT: [(&[&str], &[&str]); 5] = [
    (&["coats", "coat", "jackets", "jacket", "bags"], &["a", "coat", "rack"]),
    (&["shoes", "boots", "shoe"], &["a", "shoe", "rack"]),
    (&["keys", "mail", "post"], &["a", "console", "table"]),
    (&["clothes"], &["a", "wardrobe"]),
    (&["books"], &["a", "bookshelf"]),
];
const CHILDREN: [&str; 16] = [
    "kid",
    "kids",
    "kid's",
    "kids'",
    "child",
    "child's",
    "children",
    "children's",
    "boy",
    "boys",
    "girl",
    "girls",
    "son",
    "daughter",
    "toddler",
    "twins",
];
/// What children love, though it may stand in a room as a toy as well.
const THEMES: [&str; 16] = [
    "space",
    "football",
    "basketball",
    "horses",
    "trains",
    "cars",
    "trucks",
    "animals",
    "dinosaurs",
    "unicorns",
    "robots",
    "rockets",
    "planes",
    "cats",
    "dogs",
    "bears",
];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    somewhere(tokens, i)
        || watches(tokens, i)
        || loves(tokens, i)
        || background(tokens, i)
        || see_over(tokens, i)
        || school_year(tokens, i)
        || wait_on(tokens, i)
}

/// "Customers wait on a row of four seats": there is one.
fn wait_on(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WHO: [&str; 10] = [
        "customers",
        "clients",
        "guests",
        "visitors",
        "patients",
        "people",
        "parents",
        "pupils",
        "students",
        "passengers",
    ];
    let modal = i + 1 + usize::from(matches!(word(tokens, i + 1), "can" | "will" | "should"));
    let waits = matches!(word(tokens, modal), "wait" | "sit") && matches!(word(tokens, modal + 1), "on" | "in");
    let the = modal + 2;
    let named = matches!(word(tokens, the), "a" | "an") || count(&tokens[the.min(tokens.len())..]).is_some();
    let starts = i == 0 || tokens[i - 1].stops() || tokens[i - 1].is("and") || tokens[i - 1].is(",");
    if !WHO.contains(&word(tokens, i)) || !waits || !named || !starts {
        return false;
    }
    // "In a room of its own" is no seat.
    if word(tokens, modal + 1) == "in" && super::noun::room_here(&tokens[the + 1..]).is_some() {
        return false;
    }
    put(tokens, i, the, &["there", "is"]);
    true
}

/// Where the words end that say "somewhere to", "a quiet place to", "space to".
fn place_to(tokens: &[Token], i: usize) -> Option<usize> {
    let noun = match word(tokens, i) {
        "somewhere" => i,
        "a" | "an" | "some" | "enough" | "proper" => {
            let named = |k: &usize| matches!(word(tokens, *k), "place" | "spot" | "space" | "corner" | "nook" | "area");
            (i + 1..i + 4).find(named)?
        }
        _ => return None,
    };
    let adjectives = noun.saturating_sub(i + 1);
    if (i + 1..i + 1 + adjectives).any(|k| !get().is_look(word(tokens, k)) && word(tokens, k) != "proper") {
        return None;
    }
    match [word(tokens, noun + 1), word(tokens, noun + 2), word(tokens, noun + 3)] {
        ["to", ..] => Some(noun + 2),
        ["for", _, "to"] => Some(noun + 4),
        ["where", _, "can"] => Some(noun + 4),
        _ => None,
    }
}

/// "Somewhere to work from home" is a work nook, "a place to hang coats" a coat rack.
fn somewhere(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(verb) = place_to(tokens, i) else { return false };
    let said = |phrase: &str| phrase.split(' ').enumerate().all(|(k, said)| word(tokens, verb + k) == said);
    let done = DONE.iter().filter(|(phrase, _)| said(phrase)).max_by_key(|(phrase, _)| phrase.len());
    if let Some((phrase, zone)) = done {
        let after = verb + phrase.split(' ').count();
        let how = (after..).take_while(|k| HOW.contains(&word(tokens, *k)) && !place(tokens, *k)).count();
        put(tokens, i, after + how, &["a", zone, "nook"]);
        return true;
    }
    if matches!(word(tokens, verb), "fold" | "iron" | "sort") {
        let end = (verb + 1..verb + 5).find(|k| ends(tokens, *k)).unwrap_or(verb + 1);
        put(tokens, i, end, &["a", "table"]);
        return true;
    }
    if !matches!(word(tokens, verb), "hang" | "put" | "leave" | "store" | "keep" | "drop" | "sit") {
        return false;
    }
    let Some(end) = (verb + 1..verb + 6).find(|k| ends(tokens, *k)) else { return false };
    let kept = |k: usize| KEPT.iter().find(|(kept, _)| kept.contains(&word(tokens, k)));
    let Some((_, things)) = (verb + 1..end).rev().find_map(kept) else { return false };
    put(tokens, i, end, things);
    true
}

/// Whether a place is named here: "at the window", which says where, unlike "at home".
fn place(tokens: &[Token], i: usize) -> bool {
    matches!(word(tokens, i), "in" | "on" | "at" | "from")
        && matches!(word(tokens, i + 1), "the" | "a" | "an" | "front")
}

/// "A family that watches a lot of films": what they watch is nothing in the room.
fn watches(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SHOWN: [&str; 10] =
        ["films", "film", "movies", "movie", "tv", "television", "sport", "sports", "football", "series"];
    let who = matches!(word(tokens, i), "that" | "who" | "we" | "they" | "i");
    let verb = i + 1 + usize::from(matches!(word(tokens, i + 1), "like" | "love" | "likes" | "loves" | "often"));
    let to = verb + usize::from(word(tokens, verb) == "to");
    if !who || !matches!(word(tokens, to), "watch" | "watches" | "watching") {
        return false;
    }
    let Some(end) = (to + 1..to + 6).find(|k| SHOWN.contains(&word(tokens, *k))) else { return false };
    let amount = |k: usize| matches!(word(tokens, k), "a" | "lot" | "lots" | "of" | "many" | "much" | "the");
    if !(to + 1..end).all(amount) {
        return false;
    }
    put(tokens, i, end + 1, &["who", "love", "films"]);
    true
}

/// Children "who love dinosaurs": with a dinosaur poster.
fn loves(tokens: &mut Vec<Token>, i: usize) -> bool {
    let children = tokens.iter().any(|t| CHILDREN.iter().any(|child| t.is(child)));
    let who = matches!(word(tokens, i), "who" | "that" | "and" | "she" | "he" | "they");
    let by = |k: usize| matches!(word(tokens, k), "about" | "with" | "by");
    let what = match [word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["love" | "loves" | "adore" | "adores" | "like" | "likes", ..] => i + 2,
        ["is" | "are", "into", _] => i + 3,
        ["is" | "are", "mad" | "crazy" | "obsessed" | "nuts" | "wild", _] if by(i + 3) => i + 4,
        _ => return false,
    };
    let loved = word(tokens, what).to_owned();
    let is_thing = noun(tokens, what).is_some() || get().is(&loved, Class::Abstract) || loved.ends_with("ing");
    let known = is_thing || get().is(&loved, Class::Stop) || get().is(&loved, Class::Person) || loved == "to";
    let theme = THEMES.contains(&loved.as_str());
    if !children || !who || loved.is_empty() || known && !theme || !ends(tokens, what + 1) {
        return false;
    }
    let theme = singular(&loved);
    put(tokens, i, what + 1, &["with", "a", &theme, "poster"]);
    true
}

/// "Our family of five eats together every night, so make a dining room": a dining room for five people.
fn background(tokens: &mut Vec<Token>, i: usize) -> bool {
    let makes = matches!(word(tokens, i + 1), "make" | "build" | "create" | "design" | "please" | "give");
    if i < 3 || word(tokens, i) != "so" || !makes || !tokens[i - 1].is(",") {
        return false;
    }
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!' | '?'));
    let from = tokens[..i].iter().rposition(stops).map_or(0, |k| k + 1);
    let of = (from..i).find(|k| matches!([word(tokens, *k), word(tokens, k + 1)], ["family" | "group" | "team", "of"]));
    let Some(number) = of.map(|of| of + 2).filter(|k| count(&tokens[*k..]).is_some()) else { return false };
    let people = word(tokens, number).to_owned();
    let kind = tokens[number].kind;
    put(tokens, from, i + 1, &["for", &people, "people", "please"]);
    tokens[from + 1].kind = kind;
    true
}

/// "So the librarian can see over them": why they are low.
fn see_over(tokens: &mut Vec<Token>, i: usize) -> bool {
    let that = i + 1 + usize::from(word(tokens, i + 1) == "that");
    let can = (that + 1..that + 4).find(|k| word(tokens, *k) == "can");
    let Some(can) = can.filter(|_| word(tokens, i) == "so") else { return false };
    let over = word(tokens, can + 1) == "see" && matches!(word(tokens, can + 2), "over" | "past" | "across");
    if !over || !matches!(word(tokens, can + 3), "them" | "it") {
        return false;
    }
    // It stays a clause of its own, of which no statement comes.
    put(tokens, i, can + 4, &["view"]);
    let comma = Token { kind: WordKind::Sign(','), text: ",".to_owned(), ..tokens[i].clone() };
    tokens.insert(i, comma);
    true
}

/// "A year 2 classroom" is one classroom.
fn school_year(tokens: &mut Vec<Token>, i: usize) -> bool {
    let named = matches!(word(tokens, i), "year" | "grade" | "class" | "form");
    let numbered = tokens.get(i + 1).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    if !named || !numbered || !matches!(word(tokens, i + 2), "classroom" | "class" | "pupils" | "room") {
        return false;
    }
    put(tokens, i, i + 2, &["school"]);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_people_do_asks_for_furniture() {
        for (said, becomes) in [
            (
                "a salon. customers wait on a row of four seats, a till.",
                "a salon . there is a row of four seats , a till .",
            ),
            ("a salon. customers wait in the hall.", "a salon . customers wait in the hall ."),
            ("a flat with a bed and somewhere to work from home.", "a flat with a bed and a work nook ."),
            ("a bedroom with a quiet place to read by the window", "a bedroom with a reading nook by the window"),
            ("a room with a place to sit and read", "a room with a reading nook"),
            ("a bedroom with somewhere to work at the window", "a bedroom with a work nook at the window"),
            ("a hall with somewhere to hang our coats and a mirror", "a hall with a coat rack and a mirror"),
            ("a hall with a place for us to leave muddy boots", "a hall with a shoe rack"),
            ("two machines and somewhere to fold stuff", "two machines and a table"),
            (
                "our family of five eats together every night, so make a dining room with a table",
                "for five people please make a dining room with a table",
            ),
            ("it rains, so make a roof", "it rains , so make a roof"),
            (
                "shelves no taller than 1.4 m so the librarian can see over them, and a desk",
                "shelves no taller than 1.4 m , view , and a desk",
            ),
            ("year 2 classroom for 24 children", "school classroom for 24 children"),
            ("a place to call home", "a place to call home"),
            ("a living room for a family that watches a lot of films.", "a living room for a family who love films ."),
            ("a shop that sells watches and films", "a shop that sells watches and films"),
            ("a kids room for twin girls who love dinosaurs", "a kids room for twin girls with a dinosaur poster"),
            ("a room for my son who is mad about space.", "a bedroom for a son with a space poster ."),
            ("a room for our daughter who loves reading.", "a bedroom for a daughter who loves reading ."),
            ("a hall for children who love her bed", "a hall for children who love her bed"),
            ("a house for friends who love dinosaurs", "a house for friends who love dinosaurs"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
