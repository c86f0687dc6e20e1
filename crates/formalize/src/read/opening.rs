//! That furniture opens, and how far: "the fridge must open to at least 90 degrees", "the drawers of the desk can be pulled out
//! by 30 cm", "the wardrobe does not need to open".

use super::lexicon::singular;
use super::measure::measure;
use super::number;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};
use crate::brief::{Op, Pattern};

/// Words between what opens and how far.
const BETWEEN: [&str; 15] =
    ["to", "by", "at", "least", "up", "an", "a", "angle", "of", "full", "the", "through", "minimum", "out", "fully"];
/// So many words name the furniture that has the doors.
const NAME: usize = 3;
/// No door is opened farther (degrees), and no drawer pulled out (centimetres).
const MOST: f64 = 270.0;

/// "opens to at least 90 degrees", "pulled out by 30 cm"; how many tokens it takes.
pub fn by(rest: &[Token]) -> Option<(Pattern, usize)> {
    let turns = matches!(word(rest, 0), "open" | "opens" | "opened" | "opening");
    let slides = matches!(word(rest, 0), "pull" | "pulls" | "pulled" | "slide" | "slides" | "extend" | "extends");
    if !turns && !slides {
        return None;
    }
    let from = (1..rest.len()).find(|k| !BETWEEN.contains(&word(rest, *k)))?;
    if let Some((value, used)) = number::count(&rest[from..]).filter(|_| turns) {
        let unit = rest.get(from + used).is_some_and(|t| matches!(t.text.as_str(), "degrees" | "degree" | "deg" | "°"));
        return (unit && (1.0..=MOST).contains(&value)).then_some((Pattern::OpensBy(value as u32), from + used + 1));
    }
    let (length, used) = measure(&rest[from..]).filter(|(m, _)| slides && !m.area && m.op != Op::Most)?;
    let centimetres = length.values[0] * 100.0;
    (1.0..=MOST).contains(&centimetres).then_some((Pattern::SlidesBy(centimetres.round() as u32), from + used))
}

/// What is said of the doors of a thing is said of the thing; that it opens is no look of it, least of all where it need not.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    room_to_open(tokens, i) || whose(tokens, i) || doors_of(tokens, i) || its_door(tokens, i) || opens(tokens, i)
}

/// "…, and leave enough space to open the wardrobe doors all the way": the wardrobe opens fully.
fn room_to_open(tokens: &mut Vec<Token>, i: usize) -> bool {
    const AMOUNT: usize = 4;
    if !matches!(word(tokens, i), "leave" | "leaving" | "keep" | "with" | "have") {
        return false;
    }
    let Some(space) = (i + 1..i + AMOUNT).find(|k| matches!(word(tokens, *k), "space" | "room")) else { return false };
    let opens = matches!((word(tokens, space + 1), word(tokens, space + 2)), ("to", "open") | ("for", "opening"));
    let the = space + 3;
    if !opens || !matches!(word(tokens, the), "the" | "its" | "all") {
        return false;
    }
    let what = (the + 1..the + 1 + NAME).find(|k| crate::brief::opens(&singular(word(tokens, *k))));
    let Some(what) = what else { return false };
    let part = usize::from(matches!(word(tokens, what + 1), "door" | "doors" | "drawer" | "drawers"));
    let wide = match (word(tokens, what + 1 + part), word(tokens, what + 2 + part), word(tokens, what + 3 + part)) {
        ("all", "the", "way") => 3,
        ("fully" | "completely" | "properly" | "wide", ..) => 1,
        _ => 0,
    };
    let end = what + 1 + part + wide;
    if !ends(tokens, end) {
        return false;
    }
    let whole = tokens[i].at.start..tokens[end - 1].at.end;
    let name: Vec<String> = tokens[the + 1..=what].iter().map(|t| t.text.clone()).collect();
    let mut said = vec!["the"];
    said.extend(name.iter().map(String::as_str));
    said.extend([if singular(&name[name.len() - 1]) == name[name.len() - 1] { "opens" } else { "open" }, "fully"]);
    put(tokens, i, end, &said);
    tokens[i..i + said.len()].iter_mut().for_each(|token| token.at = whole.clone());
    // It is a sentence of its own.
    let and = usize::from(i > 0 && tokens[i - 1].is("and"));
    let comma = i > and && tokens[i - 1 - and].is(",");
    if and == 1 || comma {
        let from = i - and - usize::from(comma);
        (tokens[from].text, tokens[from].kind) = (".".to_owned(), WordKind::Sign('.'));
        tokens.drain(from + 1..i);
    }
    true
}

/// "A wardrobe whose doors can open fully".
fn whose(tokens: &mut Vec<Token>, i: usize) -> bool {
    let part = matches!(word(tokens, i + 1), "door" | "doors" | "drawer" | "drawers" | "lid");
    let owner = i > 0 && crate::brief::opens(&singular(word(tokens, i - 1)));
    let said = word(tokens, i) == "whose" && part && owner && verb_follows(tokens, i + 2);
    if said {
        put(tokens, i, i + 2, &["which"]);
    }
    said
}

/// Whether a verb of opening follows within a few words of the same sentence.
fn verb_follows(tokens: &[Token], from: usize) -> bool {
    const NEAR: usize = 6;
    let modal =
        matches!(word(tokens, from), "must" | "should" | "shall" | "can" | "could" | "has" | "have" | "needs" | "need")
            || matches!(word(tokens, from), "open" | "opens" | "slide" | "slides" | "does" | "do");
    let verb = |k: usize| matches!(word(tokens, k), "open" | "opens" | "opened" | "pulled" | "slide" | "slides");
    modal && (from..from + NEAR).any(verb)
}

/// "The doors of the wardrobe can be opened": the wardrobe can.
fn doors_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    let part = matches!(word(tokens, i + 1), "door" | "doors" | "drawer" | "drawers" | "lid");
    if word(tokens, i) != "the" || !part || word(tokens, i + 2) != "of" || word(tokens, i + 3) != "the" {
        return false;
    }
    // "The doors of the classroom" are those of a room.
    let end = (i + 4..i + 4 + NAME).find(|k| crate::brief::opens(&singular(word(tokens, *k))));
    let said = end.is_some_and(|end| verb_follows(tokens, end + 1));
    if said {
        tokens.drain(i..i + 3);
    }
    said
}

/// "The fridge door must open": the fridge must.
fn its_door(tokens: &mut Vec<Token>, i: usize) -> bool {
    let part = matches!(word(tokens, i), "door" | "doors" | "drawer" | "drawers" | "lid");
    // "The glass door" is no door of a glass.
    let owner = i > 0 && crate::brief::opens(word(tokens, i - 1));
    let said = part && owner && verb_follows(tokens, i + 1);
    if said {
        tokens.remove(i);
    }
    said
}

/// "The wardrobe must be able to open": it opens fully. "It does not need to open" is nothing that a program can say.
fn opens(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BACK: usize = 5;
    let modal = i > 0 && matches!(word(tokens, i - 1), "must" | "should" | "shall" | "can" | "could" | "to" | "not");
    if word(tokens, i) != "open" || !modal {
        return false;
    }
    let start = (0..i).rev().take(BACK).take_while(|k| !tokens[*k].is(".")).last().unwrap_or(i);
    if (start..i).any(|k| matches!(word(tokens, k), "not" | "never" | "n't" | "cannot")) {
        put(tokens, i, i + 1, &["operate"]);
        return true;
    }
    let said = ends(tokens, i + 1);
    if said {
        put(tokens, i, i + 1, &["opens", "fully"]);
    }
    said
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_is_said_of_doors_is_said_of_what_has_them() {
        for (said, becomes) in [
            ("the doors of the wardrobe can be opened by 90 degrees.", "the wardrobe can be opened by 90 degrees ."),
            (
                "a bed, and leave enough space to open the wardrobe doors all the way.",
                "a bed . the wardrobe opens fully .",
            ),
            ("a bed. leave room to open the fridge door.", "a bed . the fridge opens fully ."),
            ("leave room to open the classroom door.", "leave room to open the classroom door ."),
            ("a wardrobe whose doors can open by 90 degrees.", "a wardrobe which can open by 90 degrees ."),
            ("the fridge door must open.", "the fridge must opens fully ."),
            ("the wardrobe does not need to open.", "the wardrobe does not need to operate ."),
            ("the kitchen door must open outwards.", "the kitchen door must open outwards ."),
            ("the glass door must open.", "the glass door must opens fully ."),
            ("the doors of the classroom can be opened.", "the doors of the classroom can be opened ."),
            ("the shelf needs to be open.", "the shelf needs to be open ."),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
