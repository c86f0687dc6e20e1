//! Floor that is to stay free: "a clear area of 4 by 4 m", "keep the middle of the room empty", "leave 2 m by 3 m free in the
//! middle". A marked area of the floor is placed there, and nothing may stand on it or reach over it.

use super::lexicon::{get, singular};
use super::number;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};
use crate::brief::{Brief, Fact, FactKind, Side};

/// What the marked area is called.
pub(super) const AREA: &str = "free area";
/// Nothing may be above it up to here, in metres: as high as a door.
const HEIGHT: f64 = 2.0;
const FREE: [&str; 5] = ["free", "clear", "empty", "open", "unobstructed"];
const MIDDLE: [&str; 3] = ["middle", "centre", "center"];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    sized(tokens, i)
        || of_space(tokens, i)
        || left_free(tokens, i)
        || amount_left(tokens, i)
        || in_the_middle(tokens, i)
        || turning(tokens, i)
}

/// Where a floor area of a stated size ends that begins here: "4 by 4 m", "2 m x 3 m", "16 m²".
fn size(tokens: &[Token], i: usize) -> Option<usize> {
    let (_, n) = number::count(tokens.get(i..)?)?;
    let unit = |k: usize| usize::from(number::unit(word(tokens, k)).is_some());
    let first = i + n + unit(i + n);
    let by = matches!(word(tokens, first), "by" | "x") || tokens.get(first).is_some_and(|t| t.is("×"));
    let (_, n) = number::count(tokens.get(first + 1..)?).filter(|_| by)?;
    let end = first + 1 + n;
    (unit(end) + unit(i + 1) > 0).then_some(end + unit(end))
}

/// "A free area of about 4 by 4 m", "an empty floor space of 3 x 3 m": a free area of that size.
fn sized(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !FREE.contains(&word(tokens, i)) {
        return false;
    }
    let floor = usize::from(word(tokens, i + 1) == "floor");
    let named = i + 1 + floor;
    if !matches!(word(tokens, named), "area" | "space" | "spot" | "zone" | "patch" | "square") {
        return false;
    }
    let about = |k: usize| usize::from(matches!(word(tokens, k), "about" | "roughly" | "around" | "approximately"));
    let of = named + 1;
    let least = if word(tokens, of + 1) == "at" && word(tokens, of + 2) == "least" { 2 } else { about(of + 1) };
    let is_size = word(tokens, of) == "of" && size(tokens, of + 1 + least).is_some();
    if is_size {
        put(tokens, i, of + 1 + least, &["free", "area", "of"]);
        if i > 0 && tokens[i - 1].is("an") {
            tokens[i - 1].text = "a".to_owned();
        }
    }
    is_size
}

/// "At least 1.5 m of free space in the middle": a free area as wide as long.
fn of_space(tokens: &mut Vec<Token>, i: usize) -> bool {
    let least = if word(tokens, i) == "at" && word(tokens, i + 1) == "least" { 2 } else { 0 };
    let Some((value, n)) = tokens.get(i + least..).and_then(number::count) else { return false };
    let unit = i + least + n;
    let of = unit + 1;
    let floor = usize::from(matches!(word(tokens, of + 2), "floor" | "turning"));
    let space = of + 2 + floor;
    let said = number::unit(word(tokens, unit)).is_some()
        && word(tokens, of) == "of"
        && FREE.contains(&word(tokens, of + 1))
        && matches!(word(tokens, space), "space" | "area" | "floor");
    if !said || word(tokens, space + 1) != "in" {
        return false;
    }
    let Some(end) = middle(tokens, space + 2) else { return false };
    let end = purpose(tokens, end);
    let unit = word(tokens, unit).to_owned();
    put(tokens, i, end, &["a", "free", "area", "of", "n", &unit, "by", "n", &unit, "in", "the", "middle"]);
    for k in [i + 4, i + 7] {
        tokens[k].kind = WordKind::Number(value);
        tokens[k].text = value.to_string();
    }
    true
}

/// Where "in the middle of the room" or "the middle of the floor" ends that begins here at "the".
fn middle(tokens: &[Token], i: usize) -> Option<usize> {
    let named = word(tokens, i) == "the" && MIDDLE.contains(&word(tokens, i + 1));
    let of = |k: usize| {
        let room = matches!(word(tokens, k + 2), "room" | "floor" | "space");
        word(tokens, k) == "of" && matches!(word(tokens, k + 1), "the" | "this") && room
    };
    named.then(|| if of(i + 2) { i + 5 } else { i + 2 })
}

/// What the free floor is for, to the end of the clause: "for yoga", "so the player can turn around".
fn purpose(tokens: &[Token], i: usize) -> usize {
    let says = matches!(word(tokens, i), "so" | "for" | "to" | "where");
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ',' | '!'));
    let rest = tokens[i.min(tokens.len())..].iter().take_while(|t| !ends(t)).count();
    // What names a thing asks for more than that.
    let names = tokens[i.min(tokens.len())..].iter().take(rest).any(|t| get().noun(&singular(&t.text)).is_some());
    if says && rest <= 10 && !names { i + rest } else { i }
}

/// "Keep the middle of the room clear", "the middle of the floor should stay empty": a free area in the middle.
fn left_free(tokens: &mut Vec<Token>, i: usize) -> bool {
    let keeps = matches!(word(tokens, i), "keep" | "leave");
    let the = i + usize::from(keeps);
    let Some(end) = middle(tokens, the) else { return false };
    let starts = i == 0
        || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | ';' | ':'))
        || keeps;
    const VERB: [&str; 14] = [
        "should", "must", "has", "to", "stay", "stays", "be", "is", "kept", "left", "remain", "remains", "shall",
        "needs",
    ];
    let verb = tokens[end..].iter().take_while(|t| !keeps && VERB.contains(&t.text.as_str())).count();
    let free = end + verb;
    let says = FREE.contains(&word(tokens, free)) && (keeps || verb > 0);
    let goes_on = purpose(tokens, free + 1);
    let closes = ends(tokens, free + 1) || matches!(word(tokens, free + 1), "so" | "for" | "to" | "where");
    if !starts || !says || !closes {
        return false;
    }
    let words = ["there", "is", "a", "free", "area", "in", "the", "middle", "of", "the", "room"];
    put(tokens, i, goes_on, &words);
    true
}

/// "Leave 2 m by 3 m free in the middle", "keep 3 x 3 m clear in the middle": a free area of that size there.
fn amount_left(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "leave" | "keep") {
        return false;
    }
    let least = if word(tokens, i + 1) == "at" && word(tokens, i + 2) == "least" { 2 } else { 0 };
    let Some(end) = size(tokens, i + 1 + least) else { return false };
    if !FREE.contains(&word(tokens, end)) || word(tokens, end + 1) != "in" || middle(tokens, end + 2).is_none() {
        return false;
    }
    tokens.remove(end);
    put(tokens, i, i + 1 + least, &["there", "is", "a", "free", "area", "of"]);
    true
}

/// "Plenty of turning space", of somebody in a wheelchair: a free area as large as DIN 18040-2 asks, 1.5 m by 1.5 m.
fn turning(tokens: &mut Vec<Token>, i: usize) -> bool {
    let amount = match [word(tokens, i), word(tokens, i + 1)] {
        ["plenty" | "lots", "of"] => 2,
        ["enough" | "some" | "a", _] => 1,
        _ => return false,
    };
    let space = i + amount + 1;
    let named = matches!(word(tokens, space), "space" | "room" | "circle" | "area");
    if word(tokens, i + amount) != "turning" || !named {
        return false;
    }
    put(tokens, i, space + 1, &["a", "free", "area", "of", "n", "m", "by", "n", "m"]);
    for k in [i + 4, i + 7] {
        tokens[k].kind = WordKind::Number(1.5);
        tokens[k].text = "1.5".to_owned();
    }
    true
}

/// "With an open space in the middle": a free area there.
fn in_the_middle(tokens: &mut Vec<Token>, i: usize) -> bool {
    let article = matches!(word(tokens, i), "a" | "an" | "some" | "enough" | "plenty" | "lots");
    let of = usize::from(word(tokens, i + 1) == "of") + 1;
    let big = usize::from(matches!(word(tokens, i + of), "big" | "large" | "good" | "wide" | "generous"));
    let free = i + of + big;
    let floor = usize::from(word(tokens, free + 1) == "floor");
    let space = free + 1 + floor;
    let named = matches!(word(tokens, space), "area" | "space");
    let says = article && FREE.contains(&word(tokens, free)) && named && word(tokens, space + 1) == "in";
    if !says || middle(tokens, space + 2).is_none() {
        return false;
    }
    put(tokens, i, space + 1, &["a", "free", "area"]);
    true
}

/// Nothing stands on a free area or reaches over it.
pub fn keep_free(brief: &mut Brief) {
    let areas: Vec<usize> = (0..brief.things.len()).filter(|at| brief.things[*at].name() == AREA).collect();
    for at in areas {
        let source = brief.things[at].source.clone();
        brief.facts.push(Fact::new(vec![at], FactKind::Clear(Side::Above, HEIGHT), source));
    }
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn free_floor_is_a_marked_area() {
        for (said, becomes) in [
            ("a free area of about 4 by 4 m with mats", "a free area of 4 by 4 m with mats"),
            ("an empty floor space of 3 m x 3 m.", "a free area of 3 m x 3 m ."),
            ("keep the middle of the room clear.", "there is a free area in the middle of the room ."),
            (
                "the middle of the floor should stay empty so the player can turn around.",
                "there is a free area in the middle of the room .",
            ),
            (
                "keep the middle of the room clear, so put the sofa at the wall.",
                "there is a free area in the middle of the room , so put the sofa at the wall .",
            ),
            ("leave 2 m by 3 m free in the middle", "there is a free area of 2 m by 3 m in the middle"),
            ("a gym with an open space in the middle", "a gym with a free area in the middle"),
            (
                "a sink and at least 1.5 m of free space in the middle to turn around.",
                "a sink and a free area of 1.5 m by 1.5 m in the middle .",
            ),
            ("a table in the middle, clear of things", "a table in the middle , clear of things"),
            ("the middle drawer is empty", "the middle drawer is empty"),
            ("grab bars and plenty of turning space", "grab bars and a free area of 1.5 m by 1.5 m"),
            ("a turning lathe", "a turning lathe"),
            ("an open space of 4 by 5 m", "a free area of 4 by 5 m"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
