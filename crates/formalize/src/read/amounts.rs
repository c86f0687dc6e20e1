//! Amounts that nobody counts or measures: "lots of shelves", "shelves round the walls", "wide enough for a forklift", "about 20
//! seats".

use super::each_with::{goes_on, item};
use super::lexicon::{get, plural, singular};
use super::number::{count, length};
use super::paraphrase::{put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;

/// So many are lots of something.
const LOTS: usize = 5;
/// Fewer seats are those of one table.
const FEW_SEATS: f64 = 6.0;
/// So many shelves stand round the walls of a room.
const ROUND: usize = 6;
/// As wide as the aisle of what drives there: forklifts by their makers' data sheets (counterbalanced, pallets of 1.2 m), pallet
/// trucks and trolleys by ASR A1.8, in metres.
const WIDE: [(&[&str], f64); 3] = [
    (&["forklift", "forklifts", "fork"], 3.5),
    (&["pallet", "cart", "carts", "trolley", "trolleys"], 1.5),
    (&["people", "person", "customers", "two"], 1.2),
];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    lots(tokens, i)
        || round(tokens, i)
        || in_a_run(tokens, i)
        || wide_enough(tokens, i)
        || between_rows(tokens, i)
        || no_other(tokens, i)
        || and_nothing(tokens, i)
        || seats_people(tokens, i)
}

/// Where a noun ends that names several things for which there is a place on the floor or at a wall; words for their looks may
/// precede.
fn several(tokens: &[Token], i: usize) -> Option<usize> {
    let looks = (i..i + 3).take_while(|k| get().is_look(word(tokens, *k))).count();
    let name = noun(tokens, i + looks)?;
    let last = word(tokens, name.end - 1);
    let kind = get().noun(&singular(last));
    // How many tables and seats there are follows from the room.
    let stands = matches!(kind, Some(Group::Storage | Group::Floor | Group::Wall));
    (plural(last) && stands).then_some(name.end)
}

/// "Lots of shelves", "plenty of plants": five.
fn lots(tokens: &mut Vec<Token>, i: usize) -> bool {
    let of = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["lots" | "loads" | "tons" | "plenty" | "heaps", "of", _] => i + 2,
        ["a", "lot", "of"] => i + 3,
        _ => return false,
    };
    if several(tokens, of).is_none() {
        return false;
    }
    counted(tokens, i, of, LOTS);
    true
}

/// Puts a number in the place of words.
fn counted(tokens: &mut Vec<Token>, from: usize, to: usize, n: usize) {
    put(tokens, from, to, &[&n.to_string()]);
    tokens[from].kind = WordKind::Number(n as f64);
}

/// "Tall shelves round the walls": as many as there is room for beside each other in a room of usual size.
fn round(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SHELVES: [&str; 7] = ["shelves", "bookshelves", "bookcases", "shelving", "cupboards", "cabinets", "racks"];
    // The noun is the word before; its own words and a number may precede.
    let along = matches!(word(tokens, i), "round" | "around" | "along" | "lining" | "on" | "against" | "covering");
    if !along || i == 0 || !SHELVES.contains(&word(tokens, i - 1)) {
        return false;
    }
    let all = i + 1 + usize::from(word(tokens, i + 1) == "all");
    let end = all + usize::from(matches!(word(tokens, all), "the" | "its" | "of" | "four"));
    let end = end + usize::from(word(tokens, end) == "the");
    let perimeter = matches!(word(tokens, end), "perimeter" | "edge" | "edges" | "sides") && along;
    if word(tokens, end) != "walls" && !(perimeter && matches!(word(tokens, i), "round" | "around" | "along")) {
        return false;
    }
    let mut first = i - 1;
    while first > 0 && (get().is_look(word(tokens, first - 1)) || matches!(word(tokens, first - 1), "wall" | "book")) {
        first -= 1;
    }
    let before = first.checked_sub(1).map_or("", |k| word(tokens, k));
    let numbered = first > 0
        && (matches!(tokens[first - 1].kind, WordKind::Number(_)) || count(&tokens[first - 1..first]).is_some());
    if numbered || matches!(before, "the" | "these" | "those" | "some" | "few" | "many" | "no") {
        return false;
    }
    put(tokens, i, end + 1, &["against", "the", "walls"]);
    let copy = tokens[first].clone();
    tokens.insert(first, Token { kind: WordKind::Number(ROUND as f64), text: ROUND.to_string(), ..copy });
    true
}

/// "Cabinets with a sink": one sink among all of them. "Benches with sinks and gas taps": two sinks beside them.
fn in_a_run(tokens: &mut Vec<Token>, i: usize) -> bool {
    let benches = i > 0 && word(tokens, i) == "with" && matches!(word(tokens, i - 1), "benches");
    if benches && word(tokens, i + 1) == "sinks" {
        put(tokens, i, i + 1, &["and", "two"]);
        return true;
    }
    const RUN: [&str; 6] = ["cabinets", "counters", "cupboards", "units", "worktops", "countertops"];
    let one = matches!(word(tokens, i + 1), "a" | "one");
    let fitted = (i + 2..i + 4).any(|k| matches!(word(tokens, k), "sink" | "basin" | "hob" | "washbasin" | "oven"));
    let said = i > 0 && word(tokens, i) == "with" && one && fitted && RUN.contains(&word(tokens, i - 1));
    if said {
        put(tokens, i, i + 1, &["and"]);
    }
    said
}

/// "Wide enough between them for a forklift, so 3.5 metres or more", "with aisles wide enough for a forklift": at least so much
/// between the rows.
fn wide_enough(tokens: &mut Vec<Token>, i: usize) -> bool {
    let aisles = usize::from(matches!(word(tokens, i), "aisles" | "aisle" | "gaps" | "gangways" | "lanes"));
    let wide = i + aisles;
    let between = wide + 2 + 2 * usize::from(word(tokens, wide + 2) == "between" && word(tokens, wide + 3) == "them");
    let whom = between + 1 + usize::from(matches!(word(tokens, between + 1), "a" | "an" | "the"));
    let said = word(tokens, wide) == "wide" && word(tokens, wide + 1) == "enough" && word(tokens, between) == "for";
    if !said || aisles == 0 && between == wide + 2 {
        return false;
    }
    let Some((_, metres)) = WIDE.iter().find(|(goes, _)| goes.contains(&word(tokens, whom))) else { return false };
    let mut metres = *metres;
    let mut end = whom + 1 + usize::from(matches!(word(tokens, whom + 1), "truck" | "trucks" | "lift" | "people"));
    let comma = usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    let so = end + comma + usize::from(matches!(word(tokens, end + comma), "so" | "meaning" | "say"));
    if let Some((given, used)) = length(tokens.get(so..).unwrap_or(&[])).filter(|_| so > end) {
        metres = given;
        end = so + used;
        if word(tokens, end) == "or" && matches!(word(tokens, end + 1), "more" | "wider" | "so") {
            end += 2;
        }
    }
    let before = |n: usize| i.checked_sub(n).and_then(|k| tokens.get(k));
    let joins = usize::from(before(1).is_some_and(|t| t.is(",") || t.is("with") || t.is("and")));
    let from = i - joins;
    let text = format!("{metres}");
    put(tokens, from, end, &["with", "at", "least", &text, "m", "between", "the", "rows"]);
    tokens[from + 3].kind = WordKind::Number(metres);
    // What comes next is not between the rows.
    let comma = from + 8;
    let and = usize::from(matches!(word(tokens, comma + 1), "and" | "plus"));
    if tokens.get(comma).is_some_and(|t| t.is(",")) && item(tokens, comma + 1 + and) {
        goes_on(tokens, comma, and);
    }
    true
}

/// "Four rows of racks at least 3.5 m between them": between the rows.
fn between_rows(tokens: &mut Vec<Token>, i: usize) -> bool {
    let rows = (i.saturating_sub(8)..i).any(|k| word(tokens, k) == "rows" && word(tokens, k + 1) == "of");
    let least = i + 2 * usize::from(word(tokens, i) == "at" && word(tokens, i + 1) == "least");
    let Some((_, used)) = length(tokens.get(least..).unwrap_or(&[])).filter(|_| rows && i > 0) else { return false };
    let end = least + used;
    let free = i > 0 && (noun(tokens, i - 1).is_some_and(|name| name.end == i) || tokens[i - 1].is(","));
    if !free || word(tokens, end) != "between" || word(tokens, end + 1) != "them" {
        return false;
    }
    put(tokens, end + 1, end + 2, &["the", "rows"]);
    let copy = tokens[i].clone();
    tokens.insert(i, Token { kind: WordKind::Word, text: "with".into(), ..copy });
    true
}

/// "No other furniture please": nothing else.
fn no_other(tokens: &mut Vec<Token>, i: usize) -> bool {
    let end = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["no", "other" | "more" | "additional" | "further", "furniture" | "objects" | "things" | "items"] => i + 3,
        ["nothing", "else", "please"] => i + 2,
        _ => return false,
    };
    let please = usize::from(word(tokens, end) == "please");
    put(tokens, i, end + please, &["nothing", "else"]);
    true
}

/// "Shelves, and nothing heavy near the mat": the shelves may be near it.
fn and_nothing(tokens: &mut Vec<Token>, i: usize) -> bool {
    let nothing = word(tokens, i) == "and" && word(tokens, i + 1) == "nothing";
    if !nothing || matches!(word(tokens, i + 2), "else" | "more" | "other" | "") || i == 0 {
        return false;
    }
    let comma = usize::from(tokens[i - 1].is(","));
    put(tokens, i - comma, i + 1, &["."]);
    tokens[i - comma].kind = WordKind::Sign('.');
    true
}

/// "A café, about 20 seats", "the table should seat six": for so many people.
fn seats_people(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SERVES: [&str; 9] = ["cafe", "café", "restaurant", "bistro", "diner", "pub", "bar", "canteen", "pizzeria"];
    let modal = matches!(word(tokens, i), "should" | "must" | "can" | "has" | "needs" | "could");
    let to = i + 1 + usize::from(word(tokens, i + 1) == "to");
    if modal && word(tokens, to) == "seat" && count(tokens.get(to + 1..).unwrap_or(&[])).is_some() {
        put(tokens, i, to + 1, &["is", "for"]);
        return true;
    }
    // "A restaurant seating around forty".
    let vague = matches!(word(tokens, i + 1), "about" | "around" | "roughly" | "approximately");
    let guests = || count(tokens.get(i + 2..).unwrap_or(&[])).map(|(_, used)| i + 2 + used);
    if let Some(end) = (word(tokens, i) == "seating" && vague).then(guests).flatten() {
        if !matches!(word(tokens, end), "people" | "guests" | "diners") {
            let copy = tokens[end - 1].clone();
            tokens.insert(end, Token { kind: WordKind::Word, text: "people".to_owned(), ..copy });
        }
        put(tokens, i, i + 2, &["for"]);
        return true;
    }
    let about = usize::from(matches!(word(tokens, i), "about" | "around" | "roughly" | "some"));
    let Some((n, used)) = count(tokens.get(i + about..).unwrap_or(&[])) else { return false };
    let end = i + about + used;
    let ends = tokens.get(end + 1).is_none_or(|t| !t.word());
    let place = i > 0 && tokens[..i].iter().rev().take(4).any(|t| SERVES.iter().any(|serves| t.is(serves)));
    // "With 30 seats" names the seats.
    let first = i.checked_sub(1).is_some_and(|k| tokens[k].is(","));
    if word(tokens, end) != "seats" || !ends || !place || !first || n < FEW_SEATS {
        return false;
    }
    put(tokens, i - 1, i + about, &["for"]);
    let seats = i + used;
    put(tokens, seats, seats + 1, &["people"]);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn amounts_and_places_are_said_plainly() {
        for (said, becomes) in [
            ("a room with lots of tall shelves", "a room with 5 tall shelves"),
            ("an office with plenty of plants", "an office with 5 plants"),
            ("a restaurant with lots of tables", "a restaurant with lots of tables"),
            ("a room with lots of light", "a room with lots of light"),
            ("tall shelves round the walls and a table", "6 tall shelves against the walls and a table"),
            ("three shelves along the walls", "three shelves along the walls"),
            ("cabinets with a sink run along the back wall", "cabinets and a sink run along the back wall"),
            ("two rows of benches with sinks and gas taps", "two rows of benches and two sinks and gas taps"),
            ("desks with a lamp", "desks with a lamp"),
            ("a mat, shelves, and nothing heavy near the mat", "a mat , shelves . nothing heavy near the mat"),
            ("a desk, a chair and nothing else", "a desk , a chair and nothing else"),
            (
                "four rows of racks, wide enough between them for a forklift, so 3.5 metres or more. a desk",
                "four rows of racks with at least 3.5 m between the rows . a desk",
            ),
            ("four rows of racks at least 3 m between them", "four rows of racks with at least 3 m between the rows"),
            (
                "rows of racks with boxes, aisles wide enough for a forklift so three metres or so, and a desk",
                "rows of racks with boxes with at least 3 m between the rows . there is a desk",
            ),
            ("a door wide enough for a bed", "a door wide enough for a bed"),
            ("café, about 20 seats. counter on it", "cafe for 20 people . counter on it"),
            ("a restaurant seating around forty: six tables", "a restaurant for forty people : six tables"),
            ("tall shelves around the perimeter", "6 tall shelves against the walls"),
            ("a cafe with 20 seats", "a cafe with ten cafe tables"),
            ("the table should seat six and have a lamp", "the table is for six and have a lamp"),
            ("two benches. no other furniture please", "two benches . nothing else"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
