//! Directions and parts of a room: "the southeast corner", "on the west side of the room", "facing east", "the sink is on the
//! left", "in front of it, about a metre away, is a chair".

use super::lexicon::{get, singular};
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};
use crate::brief::Group;
use crate::furnish::kinds;
use scenelang_lang::nouns;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 8] =
        [corner, facing, side, along_side, on_the_left, away, corner_of_table, north_of];
    turns.iter().any(|turn| turn(tokens, i))
}

/// How a direction is called on the plan, where north is at the back.
fn on_plan(word: &str) -> Option<&'static str> {
    Some(match word {
        "north" | "northern" => "back",
        "south" | "southern" => "front",
        "east" | "eastern" => "right",
        "west" | "western" => "left",
        _ => return None,
    })
}

/// "A lamp at the corner of the desk": on it; a thing on the floor stands beside it.
fn corner_of_table(tokens: &mut Vec<Token>, i: usize) -> bool {
    let at = match word(tokens, i) {
        "on" | "in" => "on",
        "at" | "by" | "near" => "beside",
        _ => return false,
    };
    let corner = matches!(word(tokens, i + 1), "the" | "a" | "one") && word(tokens, i + 2) == "corner";
    let of = corner && word(tokens, i + 3) == "of" && matches!(word(tokens, i + 4), "the" | "a" | "its");
    let table = get().noun(word(tokens, i + 5)).is_some_and(|group| group == Group::Table);
    if of && table {
        put(tokens, i, i + 4, &[at]);
    }
    of && table
}

/// "The southeast corner": the front right corner.
fn corner(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i).replace('-', "");
    let split = || {
        let name = ["north", "south"].into_iter().find(|name| said.starts_with(name))?;
        let rest = said.strip_prefix(name)?.trim_end_matches("ern");
        Some((on_plan(name)?, on_plan(rest)?, 1))
    };
    let two = || {
        let [first, second] = [word(tokens, i), word(tokens, i + 1)];
        let pair = matches!(first, "north" | "south") && matches!(second, "east" | "west");
        Some((on_plan(first)?, on_plan(second)?, 2)).filter(|_| pair)
    };
    let Some((back, side, used)) = split().or_else(two) else { return false };
    if word(tokens, i + used) != "corner" {
        return false;
    }
    put(tokens, i, i + used, &[back, side]);
    true
}

/// "Six desks facing east": facing the east wall.
fn facing(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "facing" | "face" | "faces" | "look" | "looks" | "looking");
    let direction = matches!(word(tokens, i + 1), "north" | "south" | "east" | "west");
    if !said || !direction || !(ends(tokens, i + 2) || word(tokens, i + 2) == "with") {
        return false;
    }
    let to = tokens[i + 1].text.clone();
    put(tokens, i, i + 2, &["facing", "the", &to, "wall"]);
    true
}

/// Where the name of a room ends that begins with an article: "the room", "the shop".
fn of_room(tokens: &[Token], i: usize) -> Option<usize> {
    if word(tokens, i) != "of" || !matches!(word(tokens, i + 1), "the" | "this" | "my" | "our") {
        return None;
    }
    (1..=3).rev().map(|n| i + 2 + n).find(|end| {
        let name: Vec<&str> = (i + 2..*end).map(|k| word(tokens, k)).collect();
        // "Of the kitchen table": of a table.
        let longer = format!("{} {}", name.join(" "), singular(word(tokens, *end)));
        let is_thing = get().noun(&longer).is_some() || nouns::noun(&longer).is_some();
        let goes_on = is_thing || get().noun(&singular(word(tokens, *end))).is_some();
        !name.contains(&"")
            && !goes_on
            && (name == ["room"] || name == ["space"] || kinds::named(&name.join(" ")).is_some())
    })
}

/// "A lamp north of the table": "to the north of the table", so that the direction is no part of the name.
fn north_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "north" | "south" | "east" | "west") && word(tokens, i + 1) == "of";
    if !said || i == 0 || !tokens[i - 1].word() || matches!(word(tokens, i - 1), "the" | "to") {
        return false;
    }
    let direction = tokens[i].text.clone();
    put(tokens, i, i + 1, &["to", "the", &direction]);
    true
}

/// "On the left side of the room", "in the western half of the office": in that half of it.
fn side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let leads = matches!(word(tokens, i), "on" | "at" | "in" | "to" | "along") && word(tokens, i + 1) == "the";
    let which = match word(tokens, i + 2) {
        which @ ("left" | "right") => which,
        which => match on_plan(which) {
            Some(which) => which,
            None => return false,
        },
    }
    .to_owned();
    let part = usize::from(matches!(word(tokens, i + 3), "side" | "half" | "part" | "end"));
    let Some(end) = of_room(tokens, i + 3 + part).filter(|_| leads) else { return false };
    match which.as_str() {
        "back" | "front" => put(tokens, i, i + 3 + part, &["at", "the", &which]),
        _ => put(tokens, i, end, &["to", "the", &which, "as", "you", "come", "in"]),
    }
    true
}

/// "Fridges along the right side": along the right wall.
fn along_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "along" && word(tokens, i + 1) == "the" && word(tokens, i + 3) == "side";
    let which =
        matches!(word(tokens, i + 2), "left" | "right" | "back" | "front") || on_plan(word(tokens, i + 2)).is_some();
    if said && which && ends(tokens, i + 4) {
        put(tokens, i + 3, i + 4, &["wall"]);
        return true;
    }
    false
}

/// "The sink is on the left.": in that half of the room, where nothing is said to be on the other side.
fn on_the_left(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "on" | "at") && word(tokens, i + 1) == "the";
    let which = word(tokens, i + 2).to_owned();
    let verb =
        i > 0 && matches!(word(tokens, i - 1), "is" | "are" | "stands" | "stand" | "sits" | "sit" | "goes" | "go");
    let stop = tokens.get(i + 3).is_none_or(|t| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!')));
    if !said || !verb || !stop || !matches!(which.as_str(), "left" | "right") {
        return false;
    }
    let starts = |k: &usize| matches!(tokens[*k].kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let from = (0..i).rev().find(starts).map_or(0, |k| k + 1);
    let other = if which == "left" { "right" } else { "left" };
    // "The bed is on the wall, and the desk on the left": of something. The other of two is told apart elsewhere.
    let related = (from..i).any(|k| {
        word(tokens, k) == other || word(tokens, k) == "one" || get().relation(&tokens[k..]).is_some_and(|(_, n)| n > 0)
    });
    let before: Vec<&str> = tokens[..from].iter().map(|t| t.text.as_str()).collect();
    let pair = before.ends_with(&["side", "by", "side", "."]) || before.ends_with(&["each", "other", "."]);
    if related || pair {
        return false;
    }
    put(tokens, i, i + 3, &["to", "the", &which, "as", "you", "come", "in"]);
    true
}

/// "In front of it, about a metre away, is a chair": about a metre in front of it.
fn away(tokens: &mut Vec<Token>, i: usize) -> bool {
    let starts = i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let relation = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["in", "front", "of"] => 3,
        ["behind" | "beside" | "below" | "above", ..] => 1,
        ["next", "to", _] => 2,
        _ => return false,
    };
    const NOUN: usize = 5;
    let Some(comma) = (i + relation..i + relation + NOUN).find(|k| tokens.get(*k).is_some_and(|t| t.is(","))) else {
        return false;
    };
    let about = usize::from(matches!(word(tokens, comma + 1), "about" | "roughly" | "around" | "some" | "just"));
    let Some((_, used)) = tokens.get(comma + 1 + about..).and_then(super::measure::measure) else { return false };
    let end = comma + 1 + about + used;
    let close = usize::from(word(tokens, end) == "away");
    let verb = end + close + usize::from(tokens.get(end + close).is_some_and(|t| t.is(",")));
    if !starts || !matches!(word(tokens, verb), "is" | "are" | "stands" | "stand" | "sits" | "sit") {
        return false;
    }
    let stops = |k: &usize| !tokens[*k].word() || tokens[*k].is("and");
    let until = (verb + 1..tokens.len()).find(stops).unwrap_or(tokens.len());
    let plain = (verb + 1..until).all(|k| get().relation(&tokens[k..]).is_none_or(|(_, n)| n == 0));
    if !plain || until == verb + 1 {
        return false;
    }
    let order = [verb + 1..until, verb..verb + 1, comma + 1 + about..end, i..comma];
    let sentence: Vec<Token> = order.into_iter().flat_map(|part| tokens[part].to_vec()).collect();
    tokens.splice(i..until, sentence);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn directions_are_those_of_the_plan() {
        for (text, becomes) in [
            ("a chair in the southeast corner.", "a chair in the front right corner ."),
            ("a chair in the north-west corner.", "a chair in the back left corner ."),
            ("a chair in the south west corner.", "a chair in the front left corner ."),
            ("six desks facing east.", "six desks facing the east wall ."),
            ("a chair on the left side of the room.", "a chair to the left as you come in ."),
            ("a desk on the north side of the office.", "a desk at the back of the office ."),
            ("a lamp north of the table.", "a lamp to the north of the table ."),
            ("a lamp on the left side of the desk.", "a lamp on the left side of the desk ."),
            ("fridges along the right side and a till.", "fridges along the right wall and a till ."),
            ("a bed with lamps on both sides.", "a bed with lamps on both sides ."),
            ("a vase on the corner of the table.", "a vase on the table ."),
            ("a lamp at the corner of the desk.", "a lamp beside the desk ."),
            ("a chair in the corner of the office.", "a chair in the corner of the office ."),
            ("the sink is on the left.", "the sink is to the left as you come in ."),
            (
                "the sofa is on the left and the desk is on the right.",
                "the sofa is on the left and the desk is on the right .",
            ),
            ("in front of the sofa, about 1 m away, is a table.", "a table is 1 m in front of the sofa ."),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
