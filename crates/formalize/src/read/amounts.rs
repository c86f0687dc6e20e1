//! Amounts and places that nobody counts or measures: "lots of shelves", "shelves round the walls", "wide enough for a forklift",
//! "at one end", "on the left as you come in".

use super::lexicon::{get, plural, singular};
use super::number::length;
use super::paraphrase::{put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;

/// So many are lots of something.
const LOTS: usize = 5;
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
        || at_one_end(tokens, i)
        || coming_in(tokens, i)
        || no_other(tokens, i)
}

/// Where a noun ends that names several things for which there is a place on the floor or at a wall; words for their looks may precede.
fn several(tokens: &[Token], i: usize) -> Option<usize> {
    let looks = (i..i + 3).take_while(|k| get().is_look(word(tokens, *k))).count();
    let name = noun(tokens, i + looks)?;
    let last = word(tokens, name.end - 1);
    let kind = get().noun(&singular(last));
    let stands = matches!(kind, Some(Group::Seat | Group::Table | Group::Storage | Group::Floor | Group::Wall));
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
    if word(tokens, end) != "walls" {
        return false;
    }
    let mut first = i - 1;
    while first > 0 && (get().is_look(word(tokens, first - 1)) || matches!(word(tokens, first - 1), "wall" | "book")) {
        first -= 1;
    }
    let before = first.checked_sub(1).map_or("", |k| word(tokens, k));
    let numbered = first > 0
        && (matches!(tokens[first - 1].kind, WordKind::Number(_))
            || super::number::count(&tokens[first - 1..first]).is_some());
    if numbered || matches!(before, "the" | "these" | "those" | "some" | "few" | "many" | "no") {
        return false;
    }
    put(tokens, i, end + 1, &["against", "the", "walls"]);
    let copy = tokens[first].clone();
    tokens.insert(first, Token { kind: WordKind::Number(ROUND as f64), text: ROUND.to_string(), ..copy });
    true
}

/// "Cabinets with a sink": one sink among all of them.
fn in_a_run(tokens: &mut Vec<Token>, i: usize) -> bool {
    const RUN: [&str; 6] = ["cabinets", "counters", "cupboards", "units", "worktops", "countertops"];
    let one = matches!(word(tokens, i + 1), "a" | "one");
    let fitted = (i + 2..i + 4).any(|k| matches!(word(tokens, k), "sink" | "basin" | "hob" | "washbasin" | "oven"));
    let said = i > 0 && word(tokens, i) == "with" && one && fitted && RUN.contains(&word(tokens, i - 1));
    if said {
        put(tokens, i, i + 1, &["and"]);
    }
    said
}

/// "Wide enough between them for a forklift, so 3.5 metres or more": at least so much between the rows.
fn wide_enough(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said =
        matches!(word(tokens, i), "wide" | "enough") && matches!(word(tokens, i + 1), "enough" | "space" | "room");
    let between = i + 2 + 2 * usize::from(word(tokens, i + 2) == "between" && word(tokens, i + 3) == "them");
    let whom = between + 1 + usize::from(matches!(word(tokens, between + 1), "a" | "an" | "the"));
    if !said || between == i + 2 || word(tokens, between) != "for" {
        return false;
    }
    let Some((_, wide)) = WIDE.iter().find(|(whom_, _)| whom_.contains(&word(tokens, whom))) else { return false };
    let truck = usize::from(matches!(word(tokens, whom + 1), "truck" | "trucks" | "lift" | "people"));
    let mut end = whom + 1 + truck;
    let mut wide = *wide;
    let so = end + usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    let so = so + usize::from(matches!(word(tokens, so), "so" | "meaning" | "say"));
    if let Some((metres, used)) = length(tokens.get(so..).unwrap_or(&[])).filter(|_| so > end) {
        wide = metres;
        end = so + used;
        if word(tokens, end) == "or" && matches!(word(tokens, end + 1), "more" | "wider") {
            end += 2;
        }
    }
    let metres = format!("{wide}");
    let comma = usize::from(i > 0 && tokens[i - 1].is(","));
    put(tokens, i - comma, end, &["with", "at", "least", &metres, "m", "between", "the", "rows"]);
    tokens[i - comma + 3].kind = WordKind::Number(wide);
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

/// "A stage at one end": at a short wall.
fn at_one_end(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "at" && word(tokens, i + 1) == "one" && word(tokens, i + 2) == "end";
    let end = i + 3;
    let of = word(tokens, end) == "of";
    let room = word(tokens, end + 1) == "the"
        && (get().room(word(tokens, end + 2)).is_some() || matches!(word(tokens, end + 2), "room" | "space"));
    // "Shelves at one end and a table at the other": sides of one thing or of a room, and read elsewhere.
    let other = tokens.get(end..).unwrap_or(&[]).iter().take(12).any(|t| t.is("other"));
    if !said || of && !room || other || i == 0 {
        return false;
    }
    put(tokens, i, end + if of { 3 } else { 0 }, &["against", "a", "short", "wall"]);
    true
}

/// "A counter on the left as you come in": along the left wall.
fn coming_in(tokens: &mut Vec<Token>, i: usize) -> bool {
    let side = i + 2;
    let said = matches!(word(tokens, i), "on" | "to") && word(tokens, i + 1) == "the";
    let side_word = word(tokens, side).to_owned();
    let hand = usize::from(word(tokens, side + 1) == "side");
    let at = side + 1 + hand;
    let enters = matches!(word(tokens, at), "as" | "when")
        && matches!(word(tokens, at + 1), "you" | "one" | "people" | "customers" | "guests" | "i" | "we");
    if !said || !matches!(side_word.as_str(), "left" | "right") || !enters {
        return false;
    }
    let end = match [word(tokens, at + 2), word(tokens, at + 3)] {
        ["come" | "walk" | "go" | "step", "in" | "inside"] => at + 4,
        ["enter", "the"] => at + 5,
        ["enter", _] => at + 3,
        _ => return false,
    };
    put(tokens, i, end, &["along", "the", &side_word, "wall"]);
    true
}

/// "No other furniture": nothing else.
fn no_other(tokens: &mut Vec<Token>, i: usize) -> bool {
    let end = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["no", "other" | "more" | "additional" | "further", "furniture" | "objects" | "things" | "items"] => i + 3,
        _ => return false,
    };
    put(tokens, i, end, &["nothing", "else"]);
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
            ("a room with lots of light", "a room with lots of light"),
            ("tall shelves round the walls and a table", "6 tall shelves against the walls and a table"),
            ("three shelves along the walls", "three shelves along the walls"),
            ("cabinets with a sink run along the back wall", "cabinets and a sink run along the back wall"),
            ("desks with a lamp", "desks with a lamp"),
            (
                "four rows of racks, wide enough between them for a forklift, so 3.5 metres or more. a desk",
                "four rows of racks with at least 3.5 m between the rows . a desk",
            ),
            ("four rows of racks at least 3 m between them", "four rows of racks with at least 3 m between the rows"),
            ("a door wide enough for a bed", "a door wide enough for a bed"),
            ("a hall with a stage at one end and chairs", "a hall with a stage against a short wall and chairs"),
            ("one big table at the far end with eight chairs", "one big table at the back with eight chairs"),
            ("a sofa at one end and a desk at the other", "a sofa at one end and a desk at the other"),
            ("a lamp at one end of the table", "a lamp at one end of the table"),
            (
                "the counter is on the left as you come in, then tables",
                "the counter is along the left wall , then tables",
            ),
            ("a lamp on the left of the bed", "a lamp on the left of the bed"),
            ("two benches. no other furniture please", "two benches . nothing else please"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
