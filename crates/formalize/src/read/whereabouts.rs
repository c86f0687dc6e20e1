//! Places that depend on which way one looks or on what a room is like: "at one end", "on the left as you come in", "along the
//! front window", "five chairs on each side", "two on each side wall".

use super::lexicon::{get, plural, singular};
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    at_one_end(tokens, i)
        || coming_in(tokens, i)
        || at_the_window(tokens, i)
        || one_side_only(tokens, i)
        || on_each_side(tokens, i)
        || on_side_walls(tokens, i)
        || with_in_corner(tokens, i)
        || with_placed(tokens, i)
        || down_the_side(tokens, i)
}

/// "A stage at one end": at a wall. Which one is the end of a room depends on its size, which nobody has given.
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
    put(tokens, i, end + if of { 3 } else { 0 }, &["against", "a", "wall"]);
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
    // "… and a bench on the left": what is said next of the other side is seen from there, too.
    let other = if side_word == "left" { "right" } else { "left" };
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':'));
    let until = tokens[end..].iter().position(stops).map_or(tokens.len(), |n| end + n);
    let is_other = |k: &usize| {
        matches!(word(tokens, *k), "on" | "to") && word(tokens, k + 1) == "the" && word(tokens, k + 2) == other
    };
    if let Some(k) = (end..until).find(|k| is_other(k) && ends(tokens, k + 3)) {
        put(tokens, k, k + 3, &["along", "the", other, "wall"]);
    }
    put(tokens, i, end, &["along", "the", &side_word, "wall"]);
    true
}

/// "Tables along the big front window": near it. "A desk near its sill": near the window. Light that filters in is no filter.
fn at_the_window(tokens: &mut Vec<Token>, i: usize) -> bool {
    let light = i > 0 && matches!(word(tokens, i - 1), "light" | "sunlight" | "daylight" | "moonlight" | "sun");
    if light && matches!(word(tokens, i), "filters" | "pours" | "spills") {
        put(tokens, i, i + 1, &["streams"]);
        return true;
    }
    let near = matches!(word(tokens, i), "near" | "by" | "under" | "below" | "beneath");
    let window = || tokens[..i].iter().rev().take(30).any(|t| t.is("window") || t.is("windows"));
    if near && word(tokens, i + 1) == "its" && word(tokens, i + 2) == "sill" && window() {
        put(tokens, i + 1, i + 3, &["the", "window"]);
        return true;
    }
    let said = word(tokens, i) == "along" && matches!(word(tokens, i + 1), "the" | "a");
    let window = (i + 2..i + 5).find(|k| matches!(word(tokens, *k), "window" | "windows"));
    let Some(window) = window.filter(|_| said) else { return false };
    if (i + 2..window).any(|k| !get().is_look(word(tokens, k)) && word(tokens, k) != "front") {
        return false;
    }
    let last = tokens[window].text.clone();
    put(tokens, i, window + 1, &["near", "the", &last]);
    true
}

/// "Three stools on one side only": on one side. "An island and three stools on one side": in front of the island.
fn one_side_only(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SAT_AT: [&str; 5] = ["island", "table", "counter", "bar", "desk"];
    let said = word(tokens, i) == "only" && word(tokens, i + 1) == "on" && word(tokens, i + 2) == "one";
    if said && word(tokens, i + 3) == "side" {
        tokens.remove(i);
    }
    if word(tokens, i) != "on" || word(tokens, i + 1) != "one" || word(tokens, i + 2) != "side" {
        return said;
    }
    if word(tokens, i + 3) == "only" {
        tokens.remove(i + 3);
    }
    let seats = i > 0 && matches!(word(tokens, i - 1), "stools" | "chairs" | "seats");
    let goes_on = tokens.get(i + 3).is_some_and(|t| t.word() && !t.is("and"));
    let at =
        (i.saturating_sub(10)..i).rev().find(|k| SAT_AT.contains(&word(tokens, *k)) && word(tokens, k + 1) != "stools");
    let Some(at) = at.filter(|_| seats && !goes_on) else { return said };
    let name = tokens[at].text.clone();
    put(tokens, i, i + 3, &["in", "front", "of", "the", &name]);
    true
}

/// "Two long tables with lamps, five chairs on each side": with five chairs on each side of each table.
fn on_each_side(tokens: &mut [Token], i: usize) -> bool {
    const TABLES: [&str; 4] = ["tables", "desks", "benches", "workbenches"];
    let Some((_, used)) = count(tokens.get(i + 1..).unwrap_or(&[])).filter(|_| tokens[i].is(",")) else { return false };
    let seats = i + 1 + used;
    let side = matches!(word(tokens, seats + 2), "each" | "either" | "both");
    let said = matches!(word(tokens, seats), "chairs" | "stools" | "seats") && word(tokens, seats + 1) == "on" && side;
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':' | ','));
    let from = tokens[..i].iter().rposition(stops).map_or(0, |k| k + 1);
    let several = tokens[from..i].iter().any(|t| TABLES.iter().any(|name| t.is(name)));
    if !said || !several || !matches!(word(tokens, seats + 3), "side" | "sides") {
        return false;
    }
    tokens[i].kind = WordKind::Word;
    tokens[i].text = "with".to_owned();
    true
}

/// "Four cases, two on each side wall": two at the left wall and two at the right.
fn on_side_walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((n, 1)) = count(tokens.get(i + 1..).unwrap_or(&[])).filter(|_| tokens[i].is(",")) else { return false };
    let said = matches!(word(tokens, i + 2), "on" | "along" | "at" | "against")
        && matches!(word(tokens, i + 3), "each" | "either")
        && word(tokens, i + 4) == "side"
        && word(tokens, i + 5) == "wall";
    // As many as at both walls, and what they are called up to the comma.
    let all = |k: &usize| {
        let twice = count(&tokens[*k..*k + 1]).is_some_and(|(all, _)| all == 2.0 * n);
        twice && *k + 1 < i && tokens[*k + 1..i].iter().all(Token::word) && plural(word(tokens, i - 1))
    };
    let Some(all) = (i.saturating_sub(4)..i).find(all).filter(|_| said) else { return false };
    let number = tokens[i + 1].clone();
    let name: Vec<Token> = tokens[all + 1..i].to_vec();
    put(tokens, i, i + 6, &["on", "the", "left", "wall", "and", "n", "on", "the", "right", "wall"]);
    tokens[i + 5] = number.clone();
    tokens.splice(i + 6..i + 6, name);
    tokens[all] = number;
    true
}

/// "A reading chair with a floor lamp in the corner": the chair is in the corner.
fn with_in_corner(tokens: &mut [Token], i: usize) -> bool {
    let seat = |name: &str| matches!(get().noun(name), Some(Group::Seat | Group::Bed));
    let said = i > 0 && word(tokens, i) == "with" && matches!(word(tokens, i + 1), "a" | "an");
    let whose = said
        && (1..=2).any(|n| i >= n && noun(tokens, i - n).is_some_and(|name| name.end == i))
        && seat(word(tokens, i - 1));
    let Some(name) = noun(tokens, i + 2).filter(|_| whose) else { return false };
    let corner = |k: usize| word(tokens, k) == "in" && matches!(word(tokens, k + 1), "the" | "a" | "one");
    let at = name.end;
    if !corner(at) || word(tokens, at + 2) != "corner" {
        return false;
    }
    let goes_on = matches!(word(tokens, at + 3), "by" | "near")
        && word(tokens, at + 4) == "the"
        && tokens.get(at + 5).is_some_and(Token::word);
    let end = at + 3 + if goes_on { 3 } else { 0 };
    tokens[i..end].rotate_left(at - i);
    true
}

/// "A desk with catalogues next to the entrance", "a table with a lamp by the window", "a bench crowded with bottles along the back
/// wall": what stands there is the desk, the table and the bench, with what is on it.
fn with_placed(tokens: &mut Vec<Token>, i: usize) -> bool {
    let group = |k: usize| get().noun(&singular(word(tokens, k)));
    let filled = usize::from(super::contents::is_full_of(tokens, i));
    if i == 0 || filled == 0 && word(tokens, i) != "with" {
        return false;
    }
    let whose = singular(word(tokens, i - 1));
    let carrier = matches!(group(i - 1), Some(Group::Table | Group::Storage | Group::Bed | Group::Floor));
    if !carrier && (filled == 0 || whose != "bench") {
        return false;
    }
    let first = i + 1 + filled;
    let counted = count(&tokens[first.min(tokens.len())..]).map(|(_, used)| used);
    let article = counted.unwrap_or(usize::from(matches!(word(tokens, first), "a" | "an" | "some")));
    let Some(name) = noun(tokens, first + article) else { return false };
    let at = name.end;
    let named = singular(word(tokens, at - 1));
    // "A counter with ten stools along the left wall": the counter is there.
    let bar = matches!(whose.as_str(), "counter" | "bar" | "island" | "worktop");
    if bar && get().noun(&named) == Some(Group::Seat) {
        down_the_side(tokens, at);
        return of_room(tokens, at).is_some_and(|end| {
            tokens[i..end].rotate_left(at - i);
            true
        });
    }
    let shown = matches!(whose.as_str(), "plinth" | "pedestal" | "podium" | "sideboard");
    let place = of_room(tokens, at).filter(|_| shown || is_carried(&named));
    let Some(end) = place.or_else(|| by_something(tokens, at).filter(|_| is_carried(&named))) else { return false };
    if filled == 1 {
        put(tokens, i, first, &["with"]);
    }
    tokens[i..end - filled].rotate_left(at - filled - i);
    true
}

/// Whether a thing is usually on another.
fn is_carried(name: &str) -> bool {
    matches!(get().noun(name), Some(Group::Top | Group::Soft | Group::Screen))
        || matches!(name, "lamp" | "catalogue" | "catalog")
}

/// Where "next to the entrance" ends. "Books next to the lamp", "cushions against the headboard" are about what is on it.
fn by_something(tokens: &[Token], at: usize) -> Option<usize> {
    let by = match [word(tokens, at), word(tokens, at + 1), word(tokens, at + 2)] {
        ["next", "to", _] => 2,
        ["in", "front", "of"] => 3,
        ["near" | "beside" | "by" | "under" | "opposite" | "against" | "along" | "behind", _, _] => 1,
        _ => return None,
    };
    let next = at + by + 1;
    let opening = matches!(word(tokens, next), "entrance" | "door" | "window" | "wall" | "exit");
    let what = noun(tokens, next).or(opening.then_some(next..next + 1));
    let what = what.filter(|_| matches!(word(tokens, at + by), "the" | "a" | "an"))?;
    let last = singular(word(tokens, what.end - 1));
    (!is_carried(&last) && !get().part(&last) && ends(tokens, what.end)).then_some(what.end)
}

/// Where a place in the room ends that begins here: "on the opposite wall", "in the middle", "in the centre of the room".
fn of_room(tokens: &[Token], at: usize) -> Option<usize> {
    let the = matches!(word(tokens, at + 1), "the" | "a" | "one");
    let wall = (at + 2..at + 5).find(|k| word(tokens, *k) == "wall");
    let end = match word(tokens, at) {
        "on" | "along" | "against" | "at" => {
            let wall = wall?;
            let which = |k: usize| {
                get().is_look(word(tokens, k))
                    || matches!(
                        word(tokens, k),
                        "back" | "front" | "left" | "right" | "far" | "opposite" | "other" | "side"
                    )
            };
            (at + 2..wall).all(which).then_some(wall + 1)?
        }
        "in" if matches!(word(tokens, at + 2), "middle" | "centre" | "center") => {
            let room = word(tokens, at + 3) == "of" && matches!(word(tokens, at + 5), "room" | "space" | "hall");
            at + 3 + if room { 3 } else { 0 }
        }
        "in" if matches!(word(tokens, at + 3), "zone" | "area" | "part") => at + 4,
        _ => return None,
    };
    (the && ends(tokens, end)).then_some(end)
}

/// "Shelves down the left side": along the left wall.
fn down_the_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "down" | "along" | "all")
        && word(tokens, i + 1) == "the"
        && matches!(word(tokens, i + 2), "left" | "right")
        && matches!(word(tokens, i + 3), "side" | "hand");
    let end = i + 4 + usize::from(word(tokens, i + 3) == "hand" && word(tokens, i + 4) == "side");
    if !said || word(tokens, end) == "of" || i == 0 {
        return false;
    }
    let side = word(tokens, i + 2).to_owned();
    put(tokens, i, end, &["along", "the", &side, "wall"]);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn places_are_said_plainly() {
        for (said, becomes) in [
            (
                "soft light filters through the window onto a desk near its sill",
                "soft light streams through the window onto a desk near the window",
            ),
            ("a box of filters near its lid", "a box of filters near its lid"),
            (
                "a reading chair with a floor lamp in the corner by the window",
                "a reading chair in the corner by the window with a floor lamp",
            ),
            (
                "a reading chair with a floor lamp in the corner by the",
                "a reading chair in the corner with a floor lamp by the",
            ),
            ("a table with a plant in the corner", "a table with a plant in the corner"),
            ("a desk with catalogues next to the entrance.", "a desk next to the entrance with catalogues ."),
            ("a low table with a lamp by the sofa, a rug", "a low table by the sofa with a lamp , a rug"),
            ("a bed with cushions against the headboard", "a bed with cushions against the headboard"),
            ("a shelf with books next to the lamp", "a shelf with books next to the lamp"),
            ("a desk with a lamp next to", "a desk with a lamp next to"),
            ("shelves down the left side, a till", "shelves along the left wall , a till"),
            ("lamps along the left side of the bed", "lamps along the left side of the bed"),
            ("a hall with a stage at one end and chairs", "a hall with a stage against a wall and chairs"),
            ("one big table at the far end with eight chairs", "one big table at the back with eight chairs"),
            ("a sofa at one end and a desk at the other", "a sofa at one end and a desk at the other"),
            ("a lamp at one end of the table", "a lamp at one end of the table"),
            (
                "the counter is on the left as you come in, then tables",
                "the counter is along the left wall , then tables",
            ),
            (
                "the till on the right as you come in, a bench on the left, and a lamp",
                "the till along the right wall , a bench along the left wall , and a lamp",
            ),
            ("a lamp on the left of the bed", "a lamp on the left of the bed"),
            (
                "a sideboard with a vase on the opposite wall. a rug",
                "a sideboard on the opposite wall with a vase . a rug",
            ),
            ("a desk with a lamp against the back wall, a chair", "a desk against the back wall with a lamp , a chair"),
            ("a desk with a lamp on the left", "a desk with a lamp on the left"),
            ("four tables along the big front window", "four tables near the window"),
            ("tables along the wall with a window", "tables along the wall with a window"),
            (
                "an island and three bar stools on one side only.",
                "an island and three bar stools in front of the island .",
            ),
            (
                "two tables with lamps, five chairs on each side, and shelves",
                "two tables with lamps with 10 chairs on its long sides , and shelves",
            ),
            (
                "four cases, two on each side wall, and a bench",
                "two cases on the left wall and two cases on the right wall , and a bench",
            ),
            ("a bed, two lamps on each side", "a bed , two lamps on each side"),
            ("windows on one side only", "windows on one side"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
