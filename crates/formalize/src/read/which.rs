//! Which one of several is spoken of: "the left shelf", "the desk by the window", "the middle one".

use super::lexicon::{get, singular};
use super::paraphrase::{put, word};
use super::shares::{LONGEST, counted, goes_on, insert, noun};
use super::token::{Token, WordKind};
use crate::brief::Group;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    middle_one(tokens, i) || nth_one(tokens, i) || left_one(tokens, i) || one_there(tokens, i) || faced(tokens, i)
}

/// "A printer sits on the middle one": the middle cabinet holds a printer.
fn middle_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NTH: [&str; 6] = ["first", "second", "third", "fourth", "last", "middle"];
    const LIES: [&str; 8] = ["sits", "stands", "is", "lies", "sit", "stand", "are", "lie"];
    let said = word(tokens, i) == "on" && word(tokens, i + 1) == "the" && NTH.contains(&word(tokens, i + 2));
    if !said || word(tokens, i + 3) != "one" || i == 0 || !LIES.contains(&word(tokens, i - 1)) {
        return false;
    }
    let article = (i.saturating_sub(LONGEST + 2)..i - 1).rev().find(|k| matches!(word(tokens, *k), "a" | "an"));
    let Some(from) = article else { return false };
    if noun(tokens, from + 1).is_none_or(|noun| noun.end != i - 1) {
        return false;
    }
    let Some(all) = counted(tokens, from, 2) else { return false };
    let mut of: Vec<String> = tokens[all.noun].iter().map(|t| t.text.clone()).collect();
    if let Some(last) = of.last_mut() {
        *last = singular(last);
    }
    let which = tokens[i + 2].text.clone();
    let said = [vec!["the".to_owned(), which], of, vec!["holds".to_owned()]].concat();
    let said: Vec<String> = said.into_iter().chain(tokens[from..i - 1].iter().map(|t| t.text.clone())).collect();
    put(tokens, from, i + 4, &said.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// "The first is red", "the middle one has a lamp", of chairs that were counted: the first chair.
fn nth_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NTH: [&str; 7] = ["first", "second", "third", "fourth", "last", "middle", "other"];
    const SAYS: [&str; 12] =
        ["is", "has", "stands", "holds", "faces", "sits", "hangs", "lies", "leans", "should", "must", "touches"];
    let starts =
        begins(tokens, i) || i > 0 && (tokens[i - 1].is(",") || matches!(word(tokens, i - 1), "and" | "but" | "while"));
    if !starts || word(tokens, i) != "the" {
        return false;
    }
    let side = matches!(word(tokens, i + 1), "left" | "right");
    // ", the first of which is red".
    let which = usize::from(word(tokens, i + 2) == "of" && matches!(word(tokens, i + 3), "which" | "them")) * 2;
    let one = usize::from(word(tokens, i + 2) == "one") + which;
    let nth = NTH.contains(&word(tokens, i + 1)) && (one > 0 || word(tokens, i + 1) != "other");
    // "Two beds, the first under the window".
    let comma = i > 0 && tokens[i - 1].is(",") && one == 0 && word(tokens, i + 1) != "last";
    let placed = comma && tokens.get(i + 2..).and_then(|rest| get().relation(rest)).is_some_and(|(_, n)| n > 0);
    if !(nth || side && one > 0) || !(SAYS.contains(&word(tokens, i + 2 + one)) || placed) {
        return false;
    }
    let Some(all) = counted(tokens, i, 2) else { return false };
    let mut of: Vec<Token> = tokens[all.noun].to_vec();
    let at = tokens[i + 1].at.clone();
    for token in &mut of {
        token.at = at.clone();
    }
    if let Some(last) = of.last_mut() {
        last.text = singular(&last.text);
    }
    if placed {
        of.push(Token { text: "is".to_owned(), ..tokens[i].clone() });
    }
    tokens.splice(i + 2..i + 2 + one, of);
    if (which > 0 || placed) && tokens[i - 1].is(",") {
        tokens[i - 1].text = ".".to_owned();
        tokens[i - 1].kind = WordKind::Sign('.');
    }
    if side {
        left_one(tokens, i);
    }
    true
}

/// "A lamp to the left of the door, facing it": facing the door.
fn faced(tokens: &mut Vec<Token>, i: usize) -> bool {
    let verb = match [word(tokens, i), word(tokens, i + 1)] {
        ["facing", "it"] => 1,
        ["turned" | "looking" | "pointed" | "angled", "towards" | "toward" | "at"] if word(tokens, i + 2) == "it" => 2,
        _ => return false,
    };
    if i == 0 || !tokens[i - 1].is(",") {
        return false;
    }
    let named = |from: &usize| {
        let the = word(tokens, *from) == "the" && noun(tokens, from + 1).is_some_and(|noun| noun.end == i - 1);
        // What precedes it says where something is.
        the && (1..=4).any(|n| {
            from.checked_sub(n).is_some_and(|k| get().relation(&tokens[k..]).is_some_and(|(_, used)| used == n))
        })
    };
    let Some(from) = (i.saturating_sub(LONGEST + 2)..i - 1).find(named) else { return false };
    let said: Vec<String> = tokens[from..i - 1].iter().map(|t| t.text.clone()).collect();
    put(tokens, i + verb, i + verb + 1, &said.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// Whether a sentence begins at this token.
fn begins(tokens: &[Token], i: usize) -> bool {
    i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';'))
}

/// The things in the plural that were counted before a token and have the name that begins there in the singular: the number,
/// and where the name ends.
fn one_of_several(tokens: &[Token], i: usize) -> Option<(usize, usize)> {
    let name = noun(tokens, i)?;
    let all = counted(tokens, i, 2)?;
    let words = |range: std::ops::Range<usize>| tokens[range].iter().map(|t| singular(&t.text)).collect::<Vec<_>>();
    let plain = singular(&tokens[name.end - 1].text) == tokens[name.end - 1].text;
    (plain && words(name.clone()) == words(all.noun)).then_some((all.n, name.end))
}

/// Puts a sentence before the one that begins at a token.
fn before(tokens: &mut Vec<Token>, i: usize, words: &[&str]) {
    let own = tokens[i].clone();
    let new = |text: &&str| {
        let kind = if *text == "." { WordKind::Sign('.') } else { WordKind::Word };
        Token { kind, text: (*text).to_owned(), owner: false, capital: false, ..own.clone() }
    };
    tokens.splice(i..i, words.iter().map(new).collect::<Vec<_>>());
}

/// "The left shelf holds three vases", "the bed on the left has a pillow", of two: the first, which is left of the second.
fn left_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "And the right sofa is blue".
    let goes = i > 0 && (tokens[i - 1].is(",") || matches!(word(tokens, i - 1), "and" | "but" | "while"));
    if word(tokens, i) != "the" || !(begins(tokens, i) || goes) {
        return false;
    }
    let side = |k: usize| matches!(word(tokens, k), "left" | "right");
    let (at, name) = if side(i + 1) { (i + 1, i + 2) } else { (usize::MAX, i + 1) };
    let Some((_, end)) = one_of_several(tokens, name).filter(|(n, _)| *n == 2) else { return false };
    let behind = word(tokens, end) == "on" && word(tokens, end + 1) == "the" && side(end + 2);
    let (is_left, to) = match () {
        () if at != usize::MAX => (word(tokens, at) == "left", end),
        () if behind => (word(tokens, end + 2) == "left", end + 3),
        () => return false,
    };
    if !goes_on(tokens, to) {
        return false;
    }
    let noun: Vec<String> = tokens[name..end].iter().map(|t| t.text.clone()).collect();
    let noun: Vec<&str> = noun.iter().map(String::as_str).collect();
    put(tokens, i + 1, to, &[&[if is_left { "first" } else { "second" }], &noun[..]].concat());
    let said =
        [&["the", "first"], &noun[..], &["is", "to", "the", "left", "of", "the", "second"], &noun[..], &["."]].concat();
    if !tokens[..i].windows(said.len()).any(|w| w.iter().zip(&said).all(|(t, word)| t.is(word))) {
        before(tokens, i, &said);
    }
    true
}

/// "The desk by the window has a lamp", of two: the first desk is by the window, and has a lamp.
fn one_there(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "the" || !begins(tokens, i) {
        return false;
    }
    let Some((_, end)) = one_of_several(tokens, i + 1) else { return false };
    let Some((_, n)) = tokens.get(end..).and_then(|rest| get().relation(rest)).filter(|(_, n)| *n > 0) else {
        return false;
    };
    let closest = matches!(word(tokens, end), "closest" | "nearest");
    let the = matches!(word(tokens, end + n), "the" | "a");
    let Some(place) = noun(tokens, end + n + 1).filter(|_| the) else { return false };
    let fixed = matches!(get().noun(&singular(&tokens[place.end - 1].text)), Some(Group::Window | Group::Door));
    if !(fixed || closest) || !goes_on(tokens, place.end) {
        return false;
    }
    let noun: Vec<String> = tokens[i + 1..end].iter().map(|t| t.text.clone()).collect();
    let noun: Vec<&str> = noun.iter().map(String::as_str).collect();
    let first = [&["the", "first"], &noun[..]].concat();
    let mut again = tokens[place.end - 1].clone();
    again.text = ".".to_owned();
    again.kind = WordKind::Sign('.');
    tokens.insert(place.end, again);
    insert(tokens, place.end + 1, &first);
    put(tokens, i, end, &[&first[..], &["is"]].concat());
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn one_of_several_is_told_apart() {
        for (text, becomes) in [
            (
                "three cabinets, and a printer sits on the middle one",
                "three cabinets , and the middle cabinet holds a printer",
            ),
            (
                "a lamp stands to the left of the door, facing it",
                "a lamp stands to the left of the door , facing the door",
            ),
            ("a chair and a desk, facing it", "a chair and a desk , facing it"),
            ("four chairs. the first is red", "four chairs . the first chair is red"),
            ("three lamps. the middle one is white", "three lamps . the middle lamp is white"),
            (
                "two sofas. the left one is red and the right one is blue",
                "two sofas . the first sofa is to the left of the second sofa . the first sofa is red and the second sofa is blue",
            ),
            ("three chairs, the first of which is red", "three chairs . the first chair is red"),
            (
                "three tables. the table closest to the fireplace has a vase",
                "three tables . the first table is closest to the fireplace . the first table has a vase",
            ),
            ("a desk. the first is red", "a desk . the first is red"),
            (
                "two shelves. the left shelf holds a vase. the right shelf holds a book",
                "two shelves . the first shelf is to the left of the second shelf . the first shelf holds a vase . the second \
                 shelf holds a book",
            ),
            (
                "two desks. the desk by the window has a lamp",
                "two desks . the first desk is by the window . the first desk has a lamp",
            ),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
