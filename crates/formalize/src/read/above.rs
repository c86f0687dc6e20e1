//! What hangs above other things, where few words say so: "a vanity with a mirror" has it above it, and in "a workbench, a pegboard
//! with tools above it" the board is above the bench. In "a table, six chairs and a television on the wall" only the television is
//! on the wall.

use super::each_with::goes_on;
use super::lexicon::{get, plural, singular};
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;
use crate::furnish::stand;
use scenelang_lang::nouns::{self, Stands};
use std::ops::Range;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    own_mirror(tokens, i) || with_tools(tokens, i) || tools_hang(tokens, i) || last_on_wall(tokens, i)
}

/// "A table, six chairs and a television on the wall": the television is.
fn last_on_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "and" || !matches!(word(tokens, i + 1), "a" | "an" | "one") {
        return false;
    }
    let hung = |name: &str| {
        let stands = nouns::ending(name).is_some_and(|noun| noun.stands == Stands::Wall);
        stands || matches!(name, "tv" | "television" | "screen" | "whiteboard")
    };
    let own = (i + 2..i + 4).find_map(|k| noun(tokens, k).filter(|name| hung(&one(tokens, name.clone()))));
    let Some(own) = own.filter(|own| word(tokens, own.end) == "on" && word(tokens, own.end + 1) == "the") else {
        return false;
    };
    let wall = (own.end + 2..own.end + 4).any(|k| word(tokens, k) == "wall");
    let comma = usize::from(i > 0 && tokens[i - 1].is(","));
    let before = i - comma;
    let last = (before.saturating_sub(3)..before).find_map(|k| noun(tokens, k).filter(|name| name.end == before));
    // Nobody hangs up a table.
    let stands =
        last.is_some_and(|name| matches!(stand::group(&one(tokens, name)), Group::Seat | Group::Table | Group::Bed));
    if !wall || !stands {
        return false;
    }
    if comma == 0 {
        tokens[i] = Token { kind: WordKind::Sign(','), ..tokens[i].saying(",") };
    }
    goes_on(tokens, before, comma);
    true
}

/// The words of a noun, in the singular.
fn one(tokens: &[Token], range: Range<usize>) -> String {
    range.map(|k| singular(word(tokens, k))).collect::<Vec<_>>().join(" ")
}

/// "A vanity with mirror", "four styling stations with mirrors on one wall": a mirror above each of them.
fn own_mirror(tokens: &mut Vec<Token>, i: usize) -> bool {
    const HOSTS: [&str; 16] = [
        "vanity",
        "washbasin",
        "basin",
        "sink",
        "washstand",
        "console",
        "dresser",
        "station",
        "counter",
        "sideboard",
        "credenza",
        "commode",
        "fireplace",
        "mantelpiece",
        "mantel",
        "shelf",
    ];
    let article = usize::from(matches!(word(tokens, i + 1), "a" | "an"));
    let mirror = (i + 1 + article..i + 4 + article).find(|k| matches!(word(tokens, *k), "mirror" | "mirrors"));
    let Some(mirror) = mirror.filter(|_| word(tokens, i) == "with" && i > 0) else { return false };
    // "With a large round mirror".
    if !(i + 1 + article..mirror).all(|k| get().is_look(word(tokens, k))) {
        return false;
    }
    let host = word(tokens, i - 1).to_owned();
    let named = HOSTS.contains(&singular(&host).as_str());
    // Where it hangs may be said of what it belongs to.
    let place = matches!(word(tokens, mirror + 1), "on" | "along" | "against" | "at");
    let wall =
        (mirror + 2..mirror + 6).take_while(|k| !word(tokens, *k).is_empty()).find(|k| word(tokens, *k) == "wall");
    let end = match wall.filter(|_| place) {
        Some(wall) => wall + 1,
        None => mirror + 1,
    };
    if !named || !ends(tokens, end) {
        return false;
    }
    let many = plural(&host);
    let like = tokens[mirror].clone();
    if word(tokens, mirror) == "mirrors" {
        put(tokens, mirror, mirror + 1, &["mirror"]);
    }
    if article == 0 {
        tokens.insert(i + 1, like.saying("a"));
    }
    let (mirror, end) = (mirror + 1 - article, end + 1 - article);
    let place: Vec<Token> = tokens.drain(mirror + 1..end).collect();
    let above = ["above", if many { "each" } else { "it" }].map(|text| like.saying(text));
    tokens.splice(mirror + 1..mirror + 1, above);
    let after = mirror + 3 + place.len();
    tokens.splice(i..i, place);
    // "…, and a row of seats": these are no part of each.
    if many && word(tokens, after) == "and" && matches!(word(tokens, after + 1), "a" | "an" | "the" | "one") {
        goes_on(tokens, after, 0);
    }
    true
}

/// "A workbench, a pegboard with tools above it": a pegboard above it with tools.
fn with_tools(tokens: &mut [Token], i: usize) -> bool {
    let above = (i + 2..i + 5).find(|k| matches!(word(tokens, *k), "above" | "over"));
    let Some(above) = above.filter(|_| word(tokens, i) == "with" && i > 0) else { return false };
    let it = matches!(word(tokens, above + 1), "it" | "them") && ends(tokens, above + 2);
    let hangs = (i.saturating_sub(3)..i).find_map(|k| noun(tokens, k).filter(|name| name.end == i));
    let Some(hangs) = hangs.filter(|_| it) else { return false };
    let name = |range: Range<usize>| one(tokens, range);
    let stands = |name: &str| nouns::ending(name).map(|noun| noun.stands);
    let on_wall =
        stands(&name(hangs.clone())) == Some(Stands::Wall) || singular(word(tokens, hangs.end - 1)) == "shelf";
    let small = noun(tokens, above - 1).is_some_and(|held| stands(&name(held)) == Some(Stands::Top));
    // Something was named before it.
    let sentence = tokens[..hangs.start].iter().rposition(Token::stops).map_or(0, |k| k + 1);
    let before = (sentence..hangs.start).any(|k| noun(tokens, k).is_some());
    let said = on_wall && small && before;
    if said {
        tokens[i..above + 2].rotate_left(above - i);
    }
    said
}

/// "A workbench and clamps hanging above it": on a board.
fn tools_hang(tokens: &mut Vec<Token>, i: usize) -> bool {
    const TOOLS: [&str; 11] =
        ["tools", "clamps", "saws", "hammers", "wrenches", "spanners", "chisels", "pliers", "pots", "pans", "utensils"];
    let named = TOOLS.contains(&word(tokens, i)) && i > 0;
    let hang = i + 1 + usize::from(matches!(word(tokens, i + 1), "hanging" | "hung" | "mounted"));
    let above = matches!(word(tokens, hang), "above" | "over");
    let it = matches!(word(tokens, hang + 1), "it" | "them") && ends(tokens, hang + 2);
    // "A pegboard with tools above it".
    if !named || !above || !it || word(tokens, i - 1) == "with" {
        return false;
    }
    let board: &[&str] = if matches!(word(tokens, i), "pots" | "pans" | "utensils") {
        &["a", "wall", "shelf"]
    } else {
        &["a", "pegboard"]
    };
    let tools = tokens[i].clone();
    put(tokens, i, hang + 2, &[board, &["above", "it", "with", &tools.text]].concat());
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_hangs_above_says_so() {
        for (said, becomes) in [
            ("a vanity with mirror, a bin", "a vanity with a mirror above it . there is a bin"),
            ("a vanity with a mirror above it", "a vanity with a mirror above it"),
            ("a console table with a large round mirror.", "a console table with a large round mirror ."),
            (
                "four styling stations with mirrors on one wall, a bench",
                "four styling stations on one wall with a mirror above each . there is a bench",
            ),
            (
                "three stations with mirrors and a row of seats.",
                "three stations with a mirror above each . there is a row of seats .",
            ),
            ("a wardrobe with a mirror", "a wardrobe with a mirror"),
            ("a bench and clamps hanging above it.", "a bench and a pegboard above it with clamps ."),
            ("a bench with tools above the saw", "a bench with tools above the saw"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
