//! Furniture that is named by what it keeps or by where it stands: "shoe storage" is a shoe rack, "tyres" are a stack of
//! tires, and a bar's stools are bar stools.

use super::lexicon::{get, plural, singular};
use super::number::count;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use crate::brief::Group;

/// What is kept, and in what.
const STORAGE: [(&[&str], &[&str]); 9] = [
    (&["wood", "timber", "lumber"], &["a", "lumber", "rack"]),
    (&["tool", "tools"], &["a", "tool", "cabinet"]),
    (&["toy", "toys"], &["a", "toy", "shelf", "and", "a", "toy", "box"]),
    (&["book", "books"], &["a", "bookshelf"]),
    (&["shoe", "shoes"], &["a", "shoe", "rack"]),
    (&["clothes", "clothing"], &["a", "wardrobe"]),
    (&["bike", "bikes", "bicycle"], &["a", "bike", "rack"]),
    (&["file", "files", "document"], &["a", "filing", "cabinet"]),
    (&["wine"], &["a", "wine", "rack"]),
];
/// What precedes an amount that nobody counts.
const AMOUNTS: [&[&str]; 6] =
    [&["lots", "of"], &["plenty", "of"], &["a", "lot", "of"], &["enough"], &["ample"], &["some"]];
/// A stool belongs to a bar that was named at most so many words before.
const NEAR: usize = 5;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    renamed(tokens, i)
        || timber(tokens, i)
        || cloakroom(tokens, i)
        || storage(tokens, i)
        || tires(tokens, i)
        || stools(tokens, i)
        || partners(tokens, i)
        || at_counter(tokens, i)
        || mirrored(tokens, i)
}

/// "Ten stools along a wooden counter": at it, on the side of the guests.
fn at_counter(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "stools" | "chairs") && word(tokens, i + 1) == "along";
    let article = matches!(word(tokens, i + 2), "a" | "the" | "one");
    let counter = (i + 3..i + 7)
        .take_while(|k| !word(tokens, *k).is_empty())
        .any(|k| matches!(word(tokens, k), "counter" | "bar"));
    if said && article && counter {
        put(tokens, i + 1, i + 2, &["at"]);
    }
    said && article && counter
}

/// "A yoga studio with a mirror along one wall": mirrors all along it.
fn mirrored(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOVES: [&str; 8] = ["yoga", "dance", "ballet", "pilates", "gym", "fitness", "aerobics", "dojo"];
    let article = usize::from(matches!(word(tokens, i), "a" | "one"));
    let mirror = i + article;
    let along = matches!(word(tokens, mirror + 1), "along" | "covering" | "across");
    let wall = (mirror + 2..mirror + 5).any(|k| word(tokens, k) == "wall");
    let said = word(tokens, mirror) == "mirror" && along && wall;
    if !said || !tokens.iter().any(|t| MOVES.contains(&t.text.as_str())) {
        return false;
    }
    put(tokens, i, mirror + 2, &["mirrors", "along"]);
    true
}

/// Other words for the same: "pallet racking" is racks, a telly a television, and what hangs up hangs on the wall.
fn renamed(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) == "racking" {
        put(tokens, i, i + 1, &["racks"]);
        return true;
    }
    // "Full of junk": boxes of it.
    if word(tokens, i) == "full" && word(tokens, i + 1) == "of" && matches!(word(tokens, i + 2), "junk" | "clutter") {
        put(tokens, i, i + 3, &["with", "five", "cardboard", "boxes"]);
        return true;
    }
    if word(tokens, i) == "telly" {
        put(tokens, i, i + 1, &["tv"]);
        return true;
    }
    let hung = matches!(word(tokens, i), "hanging" | "hung") && word(tokens, i + 1) == "up";
    if hung && i > 0 && super::paraphrase::ends(tokens, i + 2) && plural(word(tokens, i - 1)) {
        put(tokens, i, i + 2, &["hanging", "on", "the", "wall"]);
        return true;
    }
    false
}

/// "A hallway with coats and muddy boots": what these hang and stand on.
fn cloakroom(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "with" || word(tokens, i + 1) != "coats" {
        return false;
    }
    let dirty = usize::from(matches!(word(tokens, i + 3), "muddy" | "wet" | "dirty" | "old"));
    let boots = word(tokens, i + 2) == "and" && matches!(word(tokens, i + 3 + dirty), "boots" | "shoes" | "wellies");
    if boots {
        put(tokens, i + 1, i + 4 + dirty, &["a", "coat", "rail", "and", "a", "shoe", "rack"]);
    } else {
        put(tokens, i + 1, i + 2, &["a", "coat", "rail"]);
    }
    true
}

/// "Timber stacked in a corner", "a stack of wood": a pile.
fn timber(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WOOD: [&str; 6] = ["timber", "lumber", "wood", "firewood", "logs", "planks"];
    if WOOD.contains(&word(tokens, i)) && matches!(word(tokens, i + 1), "stacked" | "piled") {
        let up = usize::from(word(tokens, i + 2) == "up");
        put(tokens, i, i + 2 + up, &["a", "wood", "pile"]);
        return true;
    }
    let stacked = matches!([word(tokens, i), word(tokens, i + 1)], ["stack" | "pile" | "stacks" | "piles", "of"]);
    if stacked && WOOD.contains(&word(tokens, i + 2)) {
        let piles = if word(tokens, i).ends_with('s') { "piles" } else { "pile" };
        put(tokens, i, i + 3, &["wood", piles]);
        return true;
    }
    false
}

/// "Lots of toy storage": a toy shelf and a toy box.
fn storage(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i + 1) != "storage" || get().noun(&singular(word(tokens, i + 2))).is_some() {
        return false;
    }
    let Some((_, things)) = STORAGE.iter().find(|(kept, _)| kept.contains(&word(tokens, i))) else { return false };
    let precedes = |amount: &&&[&str]| {
        let from = i.checked_sub(amount.len());
        from.is_some_and(|from| amount.iter().enumerate().all(|(k, w)| word(tokens, from + k) == *w))
    };
    let from = i - AMOUNTS.iter().find(precedes).map_or(0, |amount| amount.len());
    put(tokens, from, i + 2, things);
    true
}

/// "Tyres stacked in the corner", "a stack of winter tires": a tire stack.
fn tires(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "tires" | "tyres") {
        return false;
    }
    let kind = i - usize::from(i > 0 && matches!(word(tokens, i - 1), "winter" | "summer" | "spare" | "old"));
    let counted = kind.checked_sub(1).and_then(|k| count(&tokens[k..=k])).is_some();
    let words = |n: usize| kind.checked_sub(n).map(|from| (from..kind).map(|k| word(tokens, k)).collect::<Vec<_>>());
    let stacked = matches!(words(3).as_deref(), Some(["a", "stack" | "pile" | "set", "of"]));
    let so_many = matches!(words(4).as_deref(), Some(["a", "stack" | "pile" | "set", "of", _])) && counted;
    if counted && !so_many {
        return false;
    }
    let from = kind
        - if so_many {
            4
        } else if stacked {
            3
        } else {
            0
        };
    let to = i + 1 + usize::from(matches!(word(tokens, i + 1), "stacked" | "piled"));
    put(tokens, from, to, &["a", "tire", "stack"]);
    true
}

/// "A bar with six stools": bar stools.
fn stools(tokens: &mut Vec<Token>, i: usize) -> bool {
    let plain = matches!(word(tokens, i), "stools" | "stool") && i > 0 && word(tokens, i - 1) != "bar";
    let bar = |k: usize| word(tokens, k) == "bar" && !matches!(word(tokens, k + 1), "stool" | "stools");
    let said = plain && (i.saturating_sub(NEAR)..i).any(bar);
    if said {
        let noun = tokens[i].text.clone();
        put(tokens, i, i + 1, &["bar", &noun]);
    }
    said
}

/// "Three chairs, each in front of a mirror", "three sculptures on pedestals": as many mirrors and pedestals.
fn partners(tokens: &mut Vec<Token>, i: usize) -> bool {
    const CARRY: [&str; 5] = ["pedestals", "plinths", "easels", "stands", "bases"];
    const MIRRORS: [&str; 2] = ["mirrors", "screens"];
    let Some((n, 1)) = tokens.get(i..).and_then(count) else { return false };
    let Some(noun) = (i + 1..i + 4).find(|k| {
        let w = word(tokens, *k);
        plural(w) && get().noun(&singular(w)).is_some()
    }) else {
        return false;
    };
    if n < 2.0 || n.fract() != 0.0 {
        return false;
    }
    let digits = (n as usize).to_string();
    let comma = usize::from(tokens.get(noun + 1).is_some_and(|t| t.is(",")));
    let each = noun + 1 + comma;
    // "Two chairs, mirrors facing them": each chair is in front of a mirror.
    let seats = get().noun(&singular(word(tokens, noun))) == Some(Group::Seat);
    if seats && comma == 1 && word(tokens, each) == "mirrors" && word(tokens, each + 1) == "facing" {
        let them = each + 2 + usize::from(word(tokens, each + 2) == "the");
        if word(tokens, them) == "them" || word(tokens, them) == word(tokens, noun) {
            put(tokens, noun + 1, them + 1, &["in", "front", "of", &digits, "mirrors"]);
            tokens[noun + 4].kind = WordKind::Number(n);
            return true;
        }
    }
    let relation = |from: usize| match [word(tokens, from), word(tokens, from + 1), word(tokens, from + 2)] {
        ["in", "front", "of"] => Some(from + 3),
        ["facing" | "on" | "under" | "behind", ..] => Some(from + 1),
        _ => None,
    };
    if word(tokens, each) == "each"
        && let Some(partner) = relation(each + 1)
        && matches!(word(tokens, partner), "a" | "an")
    {
        let name = (partner + 1..partner + 4).rev().find(|k| get().noun(word(tokens, *k)).is_some());
        let many = name.map(|k| (k, scenelang_lang::nouns::plural(word(tokens, k))));
        let shared = |k: &usize| matches!(word(tokens, *k), "window" | "door" | "pillar" | "column" | "wall" | "table");
        let Some((name, many)) = many.filter(|(k, _)| !shared(k)) else { return false };
        put(tokens, name, name + 1, &[&many]);
        put(tokens, partner, partner + 1, &[&digits]);
        tokens[partner].kind = WordKind::Number(n);
        tokens.drain(noun + 1..=each);
        return true;
    }
    let Some(partner) = relation(noun + 1) else { return false };
    let of = word(tokens, partner).to_owned();
    let on = word(tokens, noun + 1) == "on";
    if !(if on { &CARRY[..] } else { &MIRRORS[..] }).contains(&of.as_str()) {
        return false;
    }
    put(tokens, partner, partner + 1, &[&digits, &of]);
    tokens[partner].kind = WordKind::Number(n);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn goods_are_said_plainly() {
        for (text, becomes) in [
            ("a playroom with lots of toy storage", "a playroom with a toy shelf and a toy box"),
            ("a workshop with wood storage", "a workshop with a lumber rack"),
            ("a book storage box", "a book storage box"),
            ("tyres stacked in the corner", "a tire stack in the corner"),
            ("a stack of winter tires", "a tire stack"),
            ("a bar with six stools", "a bar with six bar stools"),
            ("ten chairs along a wooden counter", "ten chairs at a wooden counter"),
            ("ten chairs along a wall", "ten chairs along a wall"),
            ("a yoga studio, a mirror along one wall", "a yoga studio , mirrors along one wall"),
            ("a bedroom, a mirror along one wall", "a bedroom , a mirror along one wall"),
            ("a gym, a mirror along", "a gym , a mirror along"),
            ("three chairs, each in front of a mirror", "three chairs in front of 3 mirrors"),
            ("three sculptures on pedestals", "three sculptures on 3 pedestals"),
            ("ten books on shelves", "ten books on shelves"),
            ("four rows of tall pallet racking", "four rows of tall pallet racks"),
            (
                "clamps hanging up and timber stacked in a corner",
                "clamps hanging on the wall and a wood pile in a corner",
            ),
            ("a pile of firewood", "a wood pile"),
            ("a garage full of junk and bikes", "a garage with five cardboard boxes and bikes"),
            ("a narrow hallway with coats and muddy boots", "a narrow hallway with a coat rail and a shoe rack"),
            ("a hallway with a rail for coats", "a hallway with a rail for coats"),
            ("a picture hung up high", "a picture hung up high"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
