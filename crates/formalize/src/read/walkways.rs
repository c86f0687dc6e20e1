//! Ways that people are to be able to go: "a clear path 0.9 m wide from the door to the desk", "a walkway of at least 1 m between
//! the bed and the door". All of them are said as "a 0.9 m wide path from … to …".

use super::measure::measure;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

const WAYS: [&str; 8] = ["path", "walkway", "route", "passage", "passageway", "pathway", "walkthrough", "gangway"];
/// What is said of a way that is nothing but one.
const FREE: [&str; 12] = [
    "clear",
    "free",
    "open",
    "unobstructed",
    "direct",
    "straight",
    "clean",
    "continuous",
    "unblocked",
    "good",
    "proper",
    "walking",
];
/// So wide is a way of which nobody says it (metres): for one person, as the guidelines of the furniture library have it.
const USUAL: (&str, f64) = ("0.75", 0.75);
/// The most words of what a way leads from.
const NAME: usize = 8;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    named(tokens, i) || from_door(tokens, i) || kept(tokens, i)
}

/// "Keep at least a metre free to walk past", "leave a path of 1 m clear": paths so wide to everything, in a sentence of their own.
fn kept(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "keep" | "leave" | "keeping" | "leaving") {
        return false;
    }
    let article = i + 1 + usize::from(word(tokens, i + 1) == "a");
    let is_way = WAYS.contains(&word(tokens, article)) && word(tokens, article + 1) == "of";
    let least = if is_way { article + 2 } else { i + 1 };
    let least = match [word(tokens, least), word(tokens, least + 1)] {
        ["at", "least"] => least + 2,
        ["about" | "around" | "roughly", _] => least + 1,
        _ => least,
    };
    let metre = matches!(word(tokens, least), "a" | "one") && matches!(word(tokens, least + 1), "metre" | "meter");
    let (wide, end) = if metre {
        (1.0, least + 2)
    } else {
        let said = tokens.get(least..).and_then(measure).filter(|(m, _)| m.values.len() == 1 && !m.area);
        let Some((m, used)) = said else { return false };
        (m.values[0], least + used)
    };
    let free = end + usize::from(FREE.contains(&word(tokens, end)));
    let walks = word(tokens, free) == "to" && matches!(word(tokens, free + 1), "walk" | "get" | "move" | "pass" | "go");
    let past = free + 2;
    let by = matches!(word(tokens, past), "past" | "by" | "around" | "round" | "through" | "between" | "about");
    let last = if walks { past + usize::from(by) } else { free };
    if !(walks || is_way && free > end) || !ends(tokens, last) {
        return false;
    }
    put(tokens, i, last, &["keep", "paths", "at", "least", "n", "m", "wide", "to", "everything"]);
    (tokens[i + 4].kind, tokens[i + 4].text) = (WordKind::Number(wide), wide.to_string());
    let and = usize::from(i > 0 && tokens[i - 1].is("and"));
    let comma = usize::from(i > and && tokens[i - 1 - and].is(","));
    if and + comma > 0 {
        let from = i - and - comma;
        (tokens[from].text, tokens[from].kind) = (".".to_owned(), WordKind::Sign('.'));
        tokens.drain(from + 1..i);
    }
    true
}

/// "A 0.9 m wide path to the desk": from the door.
fn from_door(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = WAYS.contains(&word(tokens, i)) && i > 0 && word(tokens, i - 1) == "wide" && word(tokens, i + 1) == "to";
    let all = matches!(word(tokens, i + 2), "all" | "every" | "each" | "everything");
    let until = tokens[i..].iter().position(Token::stops).map_or(tokens.len(), |n| i + n);
    let begins = (0..i).rev().find(|k| tokens[*k].stops()).map_or(0, |k| k + 1);
    if !said || all || tokens[begins..until].iter().any(|t| t.is("from")) {
        return false;
    }
    let like = tokens[i].clone();
    tokens.splice(i + 1..i + 1, ["from", "the", "door"].map(|text| like.saying(text)));
    true
}

fn named(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !WAYS.contains(&word(tokens, i)) || i == 0 {
        return false;
    }
    let free = (1..=3).take_while(|n| *n <= i && FREE.contains(&word(tokens, i - n))).count();
    let article = i - free;
    // A way whose width is said before it is read as it is.
    if article == 0 || !matches!(word(tokens, article - 1), "a" | "an" | "one" | "the") {
        return false;
    }
    let (width, end) = width(tokens, i + 1);
    let between = word(tokens, end) == "between";
    let leads = usize::from(matches!(word(tokens, end), "leading" | "going" | "running"));
    if !between && !matches!(word(tokens, end + leads), "from" | "to") {
        return false;
    }
    let told = free > 0 || end > i + 1 || leads > 0;
    let to = end + leads;
    let goes = |k: &usize| tokens.get(*k).is_some_and(|t| !t.stops() && !t.is(","));
    let and = (end + 2..end + NAME).take_while(goes).find(|k| word(tokens, *k) == "and");
    if between && and.is_none() || !between && !told {
        return false;
    }
    if let Some(and) = and.filter(|_| between) {
        "from".clone_into(&mut tokens[end].text);
        "to".clone_into(&mut tokens[and].text);
    }
    let like = tokens[i].clone();
    let mut said = vec![like.saying("a")];
    said.extend(
        width.unwrap_or_else(|| {
            vec![Token { kind: WordKind::Number(USUAL.1), ..like.saying(USUAL.0) }, like.saying("m")]
        }),
    );
    said.extend([like.saying("wide"), like]);
    tokens.splice(article - 1..to, said);
    true
}

/// How wide a way is said to be after its name, and where that ends: "of at least 1 m", "0.9 m wide".
fn width(tokens: &[Token], from: usize) -> (Option<Vec<Token>>, usize) {
    let of = match [word(tokens, from), word(tokens, from + 1)] {
        ["of", "about" | "around"] => 2,
        ["of", _] => 1,
        ["that" | "which", "is"] => 2,
        _ => 0,
    };
    let least = match [word(tokens, from + of), word(tokens, from + of + 1)] {
        ["at", "least"] => 2,
        ["minimum" | "min", _] => 1,
        _ => 0,
    };
    let number = from + of + least;
    let Some((_, used)) = tokens.get(number..).and_then(measure).filter(|(m, _)| m.values.len() == 1) else {
        return (None, from);
    };
    // A measure may have "wide" in it.
    let is_wide = |k: usize| matches!(word(tokens, k), "wide" | "clear" | "across");
    let bare = number + used - usize::from(is_wide(number + used - 1));
    let mut end = bare + usize::from(is_wide(bare));
    if word(tokens, end) == "in" && word(tokens, end + 1) == "width" {
        end += 2;
    }
    (Some(tokens[from + of..bare].to_vec()), end)
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn ways_say_how_wide_they_are_first() {
        for (text, becomes) in [
            (
                "leave a clear path 0.9 m wide from the door to the desk.",
                "leave a 0.9 m wide path from the door to the desk .",
            ),
            (
                "a walkway of at least 1 m between the bed and the door.",
                "a at least 1 m wide walkway from the bed to the door .",
            ),
            (
                "there is a clear path from the door to the desk",
                "there is a 0.75 m wide path from the door to the desk",
            ),
            ("a path 90 cm wide to the sink", "a 90 cm wide path from the door to the sink"),
            ("a path from the door to the desk", "a path from the door to the desk"),
            ("a stone path with lamps", "a stone path with lamps"),
            ("a 1 m wide path to the bed", "a 1 m wide path from the door to the bed"),
            ("1 m wide paths to all desks", "1 m wide paths to all desks"),
            (
                "a sofa, and keep at least a metre free to walk past",
                "a sofa . keep paths at least 1 m wide to everything",
            ),
            ("leave a path of 90 cm clear.", "keep paths at least 0.9 m wide to everything ."),
            ("leave 1 m of space behind the sofa", "leave 1 m of space behind the sofa"),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
