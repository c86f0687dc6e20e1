//! What things hold and how that is said: "a shelf full of books" holds books, magazines "spread over the table" are on it,
//! and "each consisting of a desk and a chair" has these.

use super::lexicon::{get, singular};
use super::noun::noun_phrase;
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::token::Token;
use crate::brief::Group;
use crate::furnish::kinds;

/// So far back a noun is looked for that a word stands for.
const BACK: usize = 12;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 9] =
        [full_of, spread, on_a_stand, under_a_shelf, consisting, stack, corner, walls, end_of_room];
    turns.iter().any(|turn| turn(tokens, i))
}

/// The group of the noun that ends at a token.
fn group(tokens: &[Token], last: usize) -> Option<Group> {
    get().noun(&singular(word(tokens, last)))
}

/// "Full of", "crowded with", "buried in".
pub(super) fn is_full_of(tokens: &[Token], i: usize) -> bool {
    const WITH: [&str; 14] = [
        "loaded",
        "piled",
        "stacked",
        "packed",
        "stuffed",
        "stocked",
        "covered",
        "crowded",
        "cluttered",
        "laden",
        "littered",
        "strewn",
        "heaped",
        "crammed",
    ];
    let (filled, by) = (word(tokens, i), word(tokens, i + 1));
    match by {
        "of" => filled == "full",
        "in" | "under" | "beneath" => matches!(filled, "covered" | "buried" | "drowning"),
        "with" => WITH.contains(&filled),
        _ => false,
    }
}

/// "A shelf full of books", "a table covered in magazines": holding books.
fn full_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !is_full_of(tokens, i) || i == 0 {
        return false;
    }
    let after = tokens.get(i + 2..).unwrap_or_default();
    let soft =
        noun_phrase(after, true).is_some_and(|(np, _)| matches!(np.group, Some(Group::Soft | Group::Flat) | None));
    if soft && word(tokens, i) == "covered" {
        return false;
    }
    if kinds::of(word(tokens, i - 1)).is_some() && word(tokens, i) == "full" && group(tokens, i - 1).is_none() {
        // "A library full of books with two tables".
        let next = i + 2 + noun_phrase(after, true).map_or(0, |(_, used)| used);
        if word(tokens, next) == "with" {
            put(tokens, next, next + 1, &["and"]);
        }
        put(tokens, i, i + 2, &["with"]);
        return true;
    }
    let bench = singular(word(tokens, i - 1)) == "bench";
    let holds =
        bench || matches!(group(tokens, i - 1), Some(Group::Table | Group::Storage | Group::Top | Group::Floor));
    if holds {
        put(tokens, i, i + 2, &["holding"]);
    }
    holds
}

/// "Magazines are spread over the table": they are on it.
fn spread(tokens: &mut Vec<Token>, i: usize) -> bool {
    let out = usize::from(word(tokens, i + 1) == "out");
    let over = matches!(word(tokens, i + 1 + out), "over" | "across" | "on");
    let the = matches!(word(tokens, i + 2 + out), "the" | "a" | "an");
    let said = matches!(word(tokens, i), "spread" | "strewn" | "laid") && over && the;
    if said {
        put(tokens, i, i + 2 + out, &["on"]);
    }
    said
}

/// "A speaker on a stand": a speaker stand.
fn on_a_stand(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "on"
        || word(tokens, i + 1) != "a"
        || word(tokens, i + 2) != "stand"
        || word(tokens, i + 3) == "of"
    {
        return false;
    }
    let named = |k: &usize| scenelang_lang::nouns::noun(&format!("{} stand", singular(word(tokens, *k)))).is_some();
    let from = i.saturating_sub(BACK);
    let sentence = (from..i).rev().take_while(|k| tokens[*k].word());
    let Some(of) = sentence.into_iter().find(named).map(|k| singular(word(tokens, k))) else { return false };
    put(tokens, i + 2, i + 3, &[&of, "stand"]);
    true
}

/// "A washer under a shelf": the shelf hangs on the wall.
fn under_a_shelf(tokens: &mut Vec<Token>, i: usize) -> bool {
    let under = matches!(word(tokens, i), "under" | "beneath" | "below" | "underneath") && word(tokens, i + 1) == "a";
    let looks =
        tokens.get(i + 2..).unwrap_or_default().iter().take_while(|t| t.word() && get().is_look(&t.text)).count();
    let stands = matches!(word(tokens, i + 3 + looks), "on" | "in");
    let said = under && word(tokens, i + 2 + looks) == "shelf" && !stands;
    if said {
        put(tokens, i + 2 + looks, i + 3 + looks, &["wall", "shelf"]);
    }
    said
}

/// "Eight workstations, each consisting of a desk and a chair": each with these. A workstation with a desk is that desk.
fn consisting(tokens: &mut Vec<Token>, i: usize) -> bool {
    let used = match [word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["consisting" | "composed", "of", _] => 2,
        ["made", "up", "of"] => 3,
        ["comprising" | "containing", ..] => 1,
        _ => return false,
    };
    if word(tokens, i) != "each" {
        return false;
    }
    put(tokens, i + 1, i + 1 + used, &["with"]);
    let place = i.checked_sub(if tokens[i - 1].is(",") { 2 } else { 1 });
    let comma = tokens.get(i + 4).is_some_and(|t| t.is(",")) || word(tokens, i + 4) == "and";
    if let Some(place) = place.filter(|k| matches!(word(tokens, *k), "workstations" | "workplaces" | "stations"))
        && matches!([word(tokens, i + 2), word(tokens, i + 3)], ["a", "desk"])
        && comma
    {
        put(tokens, i + 2, i + 5, &[]);
        put(tokens, place, place + 1, &["desks"]);
    }
    true
}

/// "A stack of three boxes": three boxes on top of each other.
fn stack(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "a")
        && matches!(word(tokens, i + 1), "stack" | "pile")
        && word(tokens, i + 2) == "of";
    let Some((n, used)) = tokens.get(i + 3..).and_then(count).filter(|_| said) else { return false };
    let noun = i + 3 + used;
    if n < 2.0 || get().noun(&singular(word(tokens, noun))).is_none() {
        return false;
    }
    let own = tokens[noun].text.clone();
    let verb = match word(tokens, noun + 1) {
        "stands" => "stand",
        "is" => "are",
        "sits" => "sit",
        other => other,
    }
    .to_owned();
    let more: &[&str] = if verb.is_empty() { &[] } else { &[&verb] };
    let to = noun + 1 + more.len();
    put(tokens, noun, to, &[&[own.as_str(), "on", "top", "of", "each", "other"], more].concat());
    tokens.drain(i..i + 3);
    true
}

/// "A table occupies the corner": it stands in the corner.
fn corner(tokens: &mut Vec<Token>, i: usize) -> bool {
    let verb = match word(tokens, i) {
        "occupies" | "fills" => "stands",
        "occupy" | "fill" => "stand",
        _ => return false,
    };
    let the = matches!(word(tokens, i + 1), "the" | "a" | "one");
    let said = the && (i + 2..i + 5).any(|k| word(tokens, k) == "corner");
    if said {
        put(tokens, i, i + 1, &[verb, "in"]);
    }
    said
}

/// "Panels cover the walls": they hang on the walls. "A study lined with bookcases": with bookcases along the walls.
fn walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    if matches!(word(tokens, i), "cover" | "covers")
        && word(tokens, i + 1) == "the"
        && matches!(word(tokens, i + 2), "walls" | "wall")
        && i > 0
        && group(tokens, i - 1) == Some(Group::Wall)
    {
        put(tokens, i, i + 1, &["hang", "on"]);
        return true;
    }
    let lined = word(tokens, i) == "lined" && word(tokens, i + 1) == "with";
    let Some((np, used)) = tokens.get(i + 2..).and_then(|rest| noun_phrase(rest, true)).filter(|_| lined) else {
        return false;
    };
    let end = i + 2 + used;
    let walls =
        i >= 2 && matches!(word(tokens, i - 1), "are" | "is") && matches!(word(tokens, i - 2), "walls" | "wall");
    let room = i > 0 && kinds::of(word(tokens, i - 1)).is_some();
    if np.group != Some(Group::Storage) || !(walls || room) || !ends(tokens, end) {
        return false;
    }
    let things: Vec<String> = tokens[i + 2..end].iter().map(|t| t.text.clone()).collect();
    let things: Vec<&str> = things.iter().map(String::as_str).collect();
    if room {
        put(tokens, i, end, &[&["with"], &things[..], &["along", "the", "walls"]].concat());
        return true;
    }
    let from = i - 2 - usize::from(i >= 3 && word(tokens, i - 3) == "the");
    put(tokens, from, end, &[&things[..], &["stand", "along", "the", "walls"]].concat());
    true
}

/// "At the front of the classroom": at the front. "At the far end": at the back.
fn end_of_room(tokens: &mut Vec<Token>, i: usize) -> bool {
    let far = matches!(word(tokens, i), "at" | "in") && word(tokens, i + 1) == "the" && word(tokens, i + 2) == "far";
    let goes_on = matches!(word(tokens, i + 4), "of" | "with" | "for" | "next" | "behind" | "near" | "facing");
    if far && word(tokens, i + 3) == "end" && (ends(tokens, i + 4) || goes_on) {
        put(tokens, i + 2, i + 4, &["back"]);
    }
    let end = matches!(word(tokens, i), "at" | "in") && word(tokens, i + 1) == "the";
    let side = matches!(word(tokens, i + 2), "front" | "back" | "rear");
    let of_room = word(tokens, i + 3) == "of" && word(tokens, i + 4) == "the";
    let room = (1..=3).find(|n| {
        let name = (i + 5..i + 5 + n).map(|k| word(tokens, k)).collect::<Vec<_>>().join(" ");
        matches!(name.as_str(), "room" | "class" | "space") || kinds::named(&name).is_some()
    });
    let Some(n) = room.filter(|_| end && side && of_room) else { return false };
    if !ends(tokens, i + 5 + n) {
        return false;
    }
    let side = tokens[i + 2].text.clone();
    // Where only this names the room, it goes on doing so.
    let is_named = (0..i).any(|k| word(tokens, k) == word(tokens, i + 4 + n));
    let to = if is_named { i + 5 + n } else { i + 4 };
    put(tokens, i + 2, to, &[side.as_str(), "in"][..if is_named { 1 } else { 2 }]);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn contents_are_said_plainly() {
        for (text, becomes) in [
            ("a shelf full of books", "a shelf holding books"),
            ("a table covered in magazines", "a table holding magazines"),
            ("a bed covered with a quilt", "a bed covered with a quilt"),
            ("a room full of plants", "a room with plants"),
            ("a library full of books with a desk", "a library with books and a desk"),
            ("a box under a shelf on the desk", "a box under a shelf on the desk"),
            ("magazines are spread over the table", "magazines are on the table"),
            ("a speaker stands on a stand.", "a speaker stands on a speaker stand ."),
            ("a washer sits under a wooden shelf", "a washer sits under a wooden wall shelf"),
            (
                "eight workstations, each consisting of a desk, a chair and a monitor",
                "eight desks , each with a chair and a monitor",
            ),
            ("a stack of three boxes stands here", "three boxes on top of each other stand here"),
            ("a table occupies the corner", "a table stands in the corner"),
            ("a study lined with bookcases", "a study with 6 bookcases against the walls"),
            ("the walls are lined with shelves.", "shelves stand along the walls ."),
            ("a classroom with a desk at the front of the classroom", "a classroom with a desk at the front"),
            ("a shop with a checkout at the far end", "a shop with a checkout at the back"),
            ("in front of the desk", "in front of the desk"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
