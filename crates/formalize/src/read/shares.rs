//! A number of things that is told in parts: "five tables, three by the window and two along the wall" are three of them and
//! two of them; "three chairs, two red and one blue" are two red chairs and a blue one.

use super::lexicon::{get, singular};
use super::paraphrase::{put, word};
use super::quantified::number;
use super::token::{Token, WordKind};

/// So many words may stand between a number of things and a part of it.
pub(super) const BACK: usize = 40;
/// The most words of a noun.
pub(super) const LONGEST: usize = 4;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 8] =
        [for_how_many, on_each_side, on_one_side, on_the_other_side, looks, of_them, the_others, gapped];
    turns.iter().any(|turn| turn(tokens, i))
}

/// Things that were counted: how many, and where their noun is.
pub(super) struct Counted {
    pub n: usize,
    pub noun: std::ops::Range<usize>,
}

/// The noun in the singular or plural that the tables know and that begins here, after looks.
pub(super) fn noun(tokens: &[Token], from: usize) -> Option<std::ops::Range<usize>> {
    let looks = tokens.get(from..)?.iter().take(3).take_while(|t| t.word() && get().is_look(&t.text)).count();
    let first = from + looks;
    let known = |n: &usize| {
        let Some(words) = tokens.get(first..first + n) else { return false };
        let mut name: Vec<String> = words.iter().map(|t| t.text.clone()).collect();
        if let Some(last) = name.last_mut() {
            *last = singular(last);
        }
        let name = name.join(" ");
        words.iter().all(Token::word) && (get().noun(&name).is_some() || scenelang_lang::nouns::noun(&name).is_some())
    };
    (1..=LONGEST).rev().find(known).map(|n| first..first + n)
}

/// The last things before a token that were counted, at least so many.
pub(super) fn counted(tokens: &[Token], i: usize, least: usize) -> Option<Counted> {
    (i.saturating_sub(BACK)..i).rev().find_map(|at| {
        let n = number(tokens, at).filter(|n| *n >= least)?;
        let noun = noun(tokens, at + 1)
            .filter(|noun| noun.end <= i && singular(&tokens[noun.end - 1].text) != tokens[noun.end - 1].text)?;
        Some(Counted { n, noun })
    })
}

/// How many of them have been told of already: "two of them", "two of which".
fn told(tokens: &[Token], of: &Counted, i: usize) -> usize {
    let part = |k: usize| {
        let of = word(tokens, k + 1) == "of" && matches!(word(tokens, k + 2), "them" | "which" | "the");
        if of { number(tokens, k) } else { None }
    };
    (of.noun.end..i).filter_map(part).sum()
}

/// Whether the sentence goes on here with where things are or what they do.
pub(super) fn goes_on(tokens: &[Token], i: usize) -> bool {
    let Some(rest) = tokens.get(i..).filter(|rest| rest.first().is_some_and(Token::word)) else { return false };
    // "Three round tables".
    if noun(tokens, i).is_some() {
        return false;
    }
    if let Some((_, n)) = get().relation(rest) {
        // "One above the other", "4 by 5 m", "one on each side", "two of the".
        let next = rest.get(n..).unwrap_or_default();
        let second = next.get(1).map_or("", |t| t.text.as_str());
        let of_parts = |t: &Token| matches!(t.text.as_str(), "each" | "either" | "both" | "every" | "another" | "of");
        let size = next.first().is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
        let parted = rest[..n].iter().chain(next.first()).any(of_parts) || second == "other";
        return n > 0 && !size && !parted;
    }
    get().verb(rest).is_some()
}

/// What separates the parts of a list.
fn separates(token: &Token) -> bool {
    matches!(token.kind, WordKind::Sign(',' | ';' | ':' | '.')) || token.is("with")
}

/// "Five tables, three by the window": three of them. "Four pictures on the left wall and three on the right": three pictures.
fn of_them(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(n) = number(tokens, i).filter(|_| i > 0) else { return false };
    let and = tokens[i - 1].is("and") || tokens[i - 1].is("while") || tokens[i - 1].is("but");
    if !(and || separates(&tokens[i - 1])) {
        return false;
    }
    // "One side table holds a lamp, the other a mug", of two side tables.
    if n == 1
        && let Some(one) = noun(tokens, i + 1)
        && let Some(all) = counted(tokens, i, 2)
        && goes_on(tokens, one.end)
        && tokens[one.clone()].last().map(|t| singular(&t.text)) == tokens[all.noun].last().map(|t| singular(&t.text))
        && (one.end..tokens.len().min(one.end + BACK)).any(|k| word(tokens, k) == "other")
    {
        put(tokens, i + 1, one.end, &["of", "them"]);
        return true;
    }
    if !goes_on(tokens, i + 1) {
        return false;
    }
    let Some(all) = counted(tokens, i, 1) else { return false };
    let before = told(tokens, &all, i);
    // "Four on the left wall and three on the right": the first are somewhere else.
    let is_placed = (all.noun.end..i - 1).any(|k| get().relation(&tokens[k..]).is_some_and(|(_, n)| n > 0));
    let part = n + before <= all.n && n < all.n && (!and || before > 0);
    if part {
        insert(tokens, i + 1, &["of", "them"]);
    } else if and
        && before == 0
        && word(tokens, i + 1) != "of"
        && is_placed
        && get().relation(&tokens[i + 1..]).is_some()
    {
        let mut words: Vec<String> = tokens[all.noun].iter().map(|t| t.text.clone()).collect();
        if let Some(last) = words.last_mut().filter(|_| n == 1) {
            *last = singular(last);
        }
        insert(tokens, i + 1, &words.iter().map(String::as_str).collect::<Vec<_>>());
    } else {
        return false;
    }
    true
}

/// "Ten tables: six for four along the windows and four for two": six tables for four and four tables for two.
fn for_how_many(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(all) = number(tokens, i).filter(|n| *n > 1) else { return false };
    let Some(noun) = noun(tokens, i + 1).filter(|noun| noun.start == i + 1) else { return false };
    if !tokens.get(noun.end).is_some_and(|t| t.is(":") || t.is(",")) {
        return false;
    }
    let end = tokens[noun.end..].iter().position(Token::stops).map_or(tokens.len(), |n| noun.end + n);
    let begins = |k: usize| tokens[k - 1].is(":") || tokens[k - 1].is(",") || tokens[k - 1].is("and");
    // A part: its number, and where "for" follows.
    let part = |k: usize| {
        let n = number(tokens, k).filter(|_| begins(k))?;
        let looks =
            (k + 1..k + 4).find(|at| word(tokens, *at) == "for" || !tokens.get(*at).is_some_and(Token::word))?;
        let is_for = word(tokens, looks) == "for" && number(tokens, looks + 1).is_some();
        is_for.then_some((n, looks))
    };
    let parts: Vec<(usize, usize)> = (noun.end + 1..end).filter_map(part).collect();
    if parts.len() < 2 || parts.iter().map(|part| part.0).sum::<usize>() != all {
        return false;
    }
    let name: Vec<String> = tokens[noun.clone()].iter().map(|t| t.text.clone()).collect();
    for (n, at) in parts.into_iter().rev() {
        let mut name = name.clone();
        if let Some(last) = name.last_mut().filter(|_| n == 1) {
            *last = singular(last);
        }
        insert(tokens, at, &name.iter().map(String::as_str).collect::<Vec<_>>());
    }
    tokens.drain(i..=noun.end);
    true
}

/// How many of so many a part speaks of that begins here, and where its looks begin: "two of them are", "the other is".
fn share(tokens: &[Token], k: usize, left: usize) -> Option<(usize, usize)> {
    let (n, mut at) = match [word(tokens, k), word(tokens, k + 1)] {
        ["the", "others" | "rest"] => (left, k + 2),
        ["the", "other"] => match number(tokens, k + 2) {
            Some(n) => (n, k + 3),
            None => (left, k + 2 + usize::from(matches!(word(tokens, k + 2), "one" | "ones"))),
        },
        _ => (number(tokens, k)?, k + 1),
    };
    if word(tokens, at) == "of" && matches!(word(tokens, at + 1), "them" | "which") {
        at += 2;
    }
    Some((n, at + usize::from(matches!(word(tokens, at), "is" | "are"))))
}

/// "Three chairs, two red and one blue": two red chairs and one blue chair.
fn looks(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(all) = number(tokens, i).filter(|n| *n > 1) else { return false };
    let Some(noun) = noun(tokens, i + 1) else { return false };
    if singular(&tokens[noun.end - 1].text) == tokens[noun.end - 1].text {
        return false;
    }
    if !tokens.get(noun.end).is_some_and(|t| matches!(t.kind, WordKind::Sign(',' | ':' | ';' | '.'))) {
        return false;
    }
    let own: Vec<String> = tokens[i + 1..noun.start].iter().map(|t| t.text.clone()).collect();
    let (mut k, mut sum, mut parts) = (noun.end + 1, 0, Vec::new());
    while let Some((n, from)) = share(tokens, k, all - sum) {
        let to =
            from + tokens[from.min(tokens.len())..].iter().take_while(|t| t.word() && get().is_look(&t.text)).count();
        if to == from || to > from + 2 || n + sum > all {
            return false;
        }
        parts.push((n, from..to));
        sum += n;
        let comma = usize::from(tokens.get(to).is_some_and(|t| t.is(",")));
        let next = to + comma + usize::from(word(tokens, to + comma) == "and");
        k = to;
        if next > to && sum < all && share(tokens, next, all - sum).is_some() {
            k = next;
        } else {
            break;
        }
    }
    let ends = tokens
        .get(k)
        .is_none_or(|t| !t.word() || get().verb(&tokens[k..]).is_some() || get().relation(&tokens[k..]).is_some());
    if parts.is_empty() || parts.len() == 1 && sum == all || !ends {
        return false;
    }
    if sum < all {
        parts.push((all - sum, 0..0));
    }
    let mut said: Vec<String> = Vec::new();
    for (at, (n, look)) in parts.iter().enumerate() {
        if at > 0 {
            said.push(if at + 1 == parts.len() { "and" } else { "," }.to_owned());
        }
        said.push(digits(*n));
        said.extend(tokens[look.clone()].iter().map(|t| t.text.clone()));
        said.extend(own.iter().cloned());
        let mut name: Vec<String> = tokens[noun.clone()].iter().map(|t| t.text.clone()).collect();
        if let Some(last) = name.last_mut().filter(|_| *n == 1) {
            *last = singular(last);
        }
        said.extend(name);
    }
    // "Two lamps, one tall and one short, stand by the sofa".
    let closed = tokens.get(k).is_some_and(|t| t.is(","))
        && tokens.get(k + 1).is_some_and(|_| get().verb(&tokens[k + 1..]).is_some());
    let said: Vec<&str> = said.iter().map(String::as_str).collect();
    put(tokens, i, k + usize::from(closed), &said);
    for token in &mut tokens[i..i + said.len()] {
        if let Ok(n) = token.text.parse::<f64>() {
            token.kind = WordKind::Number(n);
        } else if token.text == "," {
            token.kind = WordKind::Sign(',');
        }
    }
    true
}

/// "While the others stand by the door", "the rest by the door": the other two, of four of which two were told of.
fn the_others(tokens: &mut Vec<Token>, i: usize) -> bool {
    let ones = usize::from(word(tokens, i + 1) == "other" && word(tokens, i + 2) == "ones");
    if word(tokens, i) != "the" || !(matches!(word(tokens, i + 1), "others" | "rest") || ones == 1) {
        return false;
    }
    let end = i + 2 + ones;
    let Some(all) = counted(tokens, i, 2).filter(|_| goes_on(tokens, end)) else { return false };
    let before = told(tokens, &all, i);
    if before == 0 || before >= all.n {
        return false;
    }
    let left = digits(all.n - before);
    put(tokens, i + 1, end, &["other", if all.n - before == 1 { "one" } else { &left }]);
    if let Ok(n) = tokens[i + 2].text.parse::<f64>() {
        tokens[i + 2].kind = WordKind::Number(n);
    }
    true
}

/// "One of them holds a lamp and the other a mug": the other holds a mug.
fn gapped(tokens: &mut Vec<Token>, i: usize) -> bool {
    let one = usize::from(word(tokens, i + 2) == "one");
    let next = i + 2 + one;
    let starts = matches!(word(tokens, next), "a" | "an" | "some" | "the") || number(tokens, next).is_some();
    if word(tokens, i) != "the" || word(tokens, i + 1) != "other" || !starts {
        return false;
    }
    let them = (i.saturating_sub(BACK)..i).rev().find(|k| word(tokens, *k) == "of" && word(tokens, k + 1) == "them");
    let Some(verb) = them.map(|k| k + 2).filter(|k| get().verb(&tokens[*k..]).is_some_and(|(_, n)| n == 1)) else {
        return false;
    };
    let verb = tokens[verb].text.clone();
    insert(tokens, next, &[&verb]);
    true
}

/// "Six chairs, three on each side", "a table with three chairs on each side": six chairs on its long sides. Of a bed and
/// of a sofa, which have one thing at each side, nothing changes.
fn on_each_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(n) = number(tokens, i) else { return false };
    let named = noun(tokens, i + 1);
    let on = named.as_ref().map_or(i + 1, |noun| noun.end);
    if !matches!(word(tokens, on), "on" | "at" | "along") || !matches!(word(tokens, on + 1), "each" | "either" | "both")
    {
        return false;
    }
    let long = usize::from(word(tokens, on + 2) == "long");
    let side = on + 2 + long;
    let place: &[&str] = match word(tokens, side) {
        "side" | "sides" => &["on", "its", "long", "sides"],
        "end" => &["on", "the", "left", "and", "right"],
        _ => return false,
    };
    if word(tokens, side + 1) == "of" {
        return false;
    }
    let both = word(tokens, on + 1) == "both";
    let is_table = |k: usize| word(tokens, k).trim_end_matches('s').ends_with("table");
    if both || !(i.saturating_sub(BACK)..i).any(is_table) {
        return false;
    }
    if named.is_some() {
        put(tokens, on, side + 1, place);
        put(tokens, i, i + 1, &[&digits(2 * n)]);
        tokens[i].kind = WordKind::Number(2.0 * n as f64);
        return true;
    }
    let all = counted(tokens, i, 2).map(|all| all.n);
    let (from, them): (usize, &[&str]) = match all {
        Some(all) if all == 2 * n => (i, &["all", "of", "them"]),
        Some(all) if all > 2 * n => (i + 1, &["of", "them"]),
        _ => return false,
    };
    put(tokens, from, side + 1, &[them, place].concat());
    if from > i {
        put(tokens, i, i + 1, &[&digits(2 * n)]);
        tokens[i].kind = WordKind::Number(2.0 * n as f64);
    }
    true
}

/// "Three chairs on one side and one on the other": four chairs on its long sides.
fn on_one_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(first) = number(tokens, i) else { return false };
    let Some(noun) = noun(tokens, i + 1) else { return false };
    let on = noun.end;
    let side = |k: usize, which: &str| {
        let is = word(tokens, k) == "on"
            && (word(tokens, k + 1) == which || word(tokens, k + 1) == "the" && word(tokens, k + 2) == which);
        let end = k + 2 + usize::from(word(tokens, k + 1) == "the");
        is.then(|| end + usize::from(word(tokens, end) == "side"))
    };
    let Some(and) = side(on, "one") else { return false };
    let Some(second) = number(tokens, and + 1).filter(|_| word(tokens, and) == "and") else { return false };
    let Some(end) = side(and + 2, "other") else { return false };
    put(tokens, on, end, &["on", "its", "long", "sides"]);
    put(tokens, i, i + 1, &[&digits(first + second)]);
    tokens[i].kind = WordKind::Number((first + second) as f64);
    true
}

/// "A lamp on one side and a plant on the other": on its left and on its right.
fn on_the_other_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let one = matches!(word(tokens, i), "on" | "at") && word(tokens, i + 1) == "one" && word(tokens, i + 2) == "side";
    if !one {
        return false;
    }
    let sentence = tokens[i..].iter().position(|t| t.is(".")).map_or(tokens.len(), |n| i + n);
    let is_other = |k: &usize| {
        matches!(word(tokens, *k), "on" | "at") && word(tokens, k + 1) == "the" && word(tokens, k + 2) == "other"
    };
    let Some(other) = (i + 3..sentence.min(i + BACK)).find(is_other) else { return false };
    let side = other + 3 + usize::from(word(tokens, other + 3) == "side");
    // "On the other wall", "on the other side of the room".
    if word(tokens, side) == "of" || side == other + 3 && noun(tokens, side).is_some() {
        return false;
    }
    put(tokens, other, side, &["on", "its", "right"]);
    let of = word(tokens, i + 3) == "of";
    put(tokens, i, i + 3, if of { &["to", "the", "left"] } else { &["on", "its", "left"] });
    true
}

fn digits(n: usize) -> String {
    n.to_string()
}

/// Puts words before a token, said where the token before it was.
pub(super) fn insert(tokens: &mut Vec<Token>, at: usize, words: &[&str]) {
    let own = tokens[at - 1].clone();
    let new = words.iter().map(|text| Token {
        kind: WordKind::Word,
        text: (*text).to_owned(),
        owner: false,
        capital: false,
        ..own.clone()
    });
    tokens.splice(at..at, new.collect::<Vec<_>>());
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn parts_of_a_number_are_said_plainly() {
        for (text, becomes) in [
            (
                "five tables, three by the window and two along the wall.",
                "five tables , three of them by the window and two of them along the wall .",
            ),
            ("there are five tables. three are by the door", "there are five tables . three of them are by the door"),
            (
                "four paintings on the left wall and three on the right wall",
                "four paintings on the left wall and three paintings on the right wall",
            ),
            ("four plants and two on the sill", "four plants and two on the sill"),
            ("three chairs, two red and one blue.", "2 red chairs and 1 blue chair ."),
            ("three chairs, one of which is red", "1 red chair and 2 chairs"),
            ("two chairs. one is red and the other is blue.", "1 red chair and 1 blue chair ."),
            ("ten chairs. three round tables stand here", "ten chairs . three round tables stand here"),
            ("two lamps, one tall and one short, stand here", "1 tall lamp and 1 short lamp stand here"),
            (
                "four shelves, two of them by the door, the others by the window",
                "four shelves , two of them by the door , the other 2 by the window",
            ),
            (
                "two side tables. one holds a lamp and the other a mug",
                "two side tables . one of them holds a lamp and the other holds a mug",
            ),
            ("a table with six chairs, three on each side", "a table with six chairs , all of them on its long sides"),
            (
                "a table with six chairs, two on each long side and one at each end",
                "a table with six chairs , 4 of them on its long sides and 2 of them on the left and right",
            ),
            ("a table with two chairs on each long side", "a table with 4 chairs on its long sides"),
            ("a table with three chairs on one side and one on the other", "a table with 4 chairs on its long sides"),
            (
                "on one side of the bed stands a lamp, on the other a plant",
                "to the left of the bed stands a lamp , on its right a plant",
            ),
            (
                "a bed with a lamp on one side and a plant on the other side",
                "a bed with a lamp on its left and a plant on its right",
            ),
            ("two shelves, one above the other", "two shelves , one above the other"),
            ("two nightstands, one on each side of the bed", "two nightstands , one on each side of the bed"),
            ("a bed with two lamps and a room, 4 by 5 m", "a bed with two lamps and a room , 4 by 5 m"),
            (
                "ten tables: six for four by the windows, three for two at the wall, and one very long for twelve.",
                "six tables for four by the windows , three tables for two at the wall , and one very long table for \
                 twelve .",
            ),
            ("ten tables: six for four and three for two", "ten tables : six for four and three for two"),
            ("a table for two by the window", "a table for two by the window"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
