//! Free space whose place is said first: "behind every chair a depth of at least 0.9 m shall remain free" is "a depth of at least
//! 0.9 m shall remain free behind every chair".

use super::number;
use super::paraphrase::{ends, word};
use super::token::{Token, WordKind};

/// Words before an amount of free space.
const AMOUNT: [&str; 12] =
    ["a", "depth", "width", "space", "distance", "clearance", "area", "of", "at", "least", "about", "strip"];
/// Words between the amount and what it is to be.
const VERB: [&str; 20] = [
    "shall",
    "should",
    "must",
    "will",
    "is",
    "are",
    "has",
    "have",
    "to",
    "be",
    "kept",
    "left",
    "remain",
    "remains",
    "stay",
    "stays",
    "of",
    "space",
    "floor",
    "clearance",
];
/// So many words name a thing, with its article.
const NAME: usize = 6;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    if have_behind(tokens, i) {
        return true;
    }
    let starts =
        i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | ';' | ':'));
    let relation = match (word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)) {
        ("behind" | "beside" | "around" | "before", ..) => 1,
        ("in", "front", "of") | ("to", "the", "left" | "right") => 3,
        _ => 0,
    };
    if !starts || relation == 0 {
        return false;
    }
    let article = i + relation + usize::from(word(tokens, i + relation) == "of");
    if !matches!(word(tokens, article), "the" | "every" | "each" | "all" | "both") {
        return false;
    }
    // The amount, behind the name of the thing and perhaps a comma.
    let is_amount =
        |k: usize| number::count(&tokens[k..]).is_some_and(|(_, used)| number::unit(word(tokens, k + used)).is_some());
    let Some(number) = (article + 2..(article + NAME + AMOUNT.len()).min(tokens.len())).find(|k| is_amount(*k)) else {
        return false;
    };
    let from = (article + 2..number).rev().take_while(|k| AMOUNT.contains(&word(tokens, *k))).last().unwrap_or(number);
    let comma = usize::from(tokens[from - 1].is(","));
    let name = &tokens[article..from - comma];
    if name.len() > NAME
        || !name.iter().all(Token::word)
        || name[1..].iter().any(|t| matches!(t.text.as_str(), "is" | "are" | "and" | "a" | "an" | "the"))
    {
        return false;
    }
    // "shall remain free", "must be kept clear", "stays empty"
    let free = |k: &usize| matches!(word(tokens, *k), "free" | "clear" | "empty");
    let Some(free) = (number..(number + 9).min(tokens.len())).find(free).filter(|k| ends(tokens, k + 1)) else {
        return false;
    };
    // Nothing stands between the amount and the verb: "a lamp 1.5 m tall stands free" is a lamp.
    let verb = number + number::count(&tokens[number..]).map_or(0, |(_, used)| used + 1);
    if !(verb..free).all(|k| VERB.contains(&word(tokens, k))) {
        return false;
    }
    // What is in another order is all where the whole of it is.
    let whole = tokens[i].at.start..tokens[free].at.end;
    tokens[i..=free].iter_mut().for_each(|token| token.at = whole.clone());
    let place: Vec<Token> = tokens[i..from - comma].to_vec();
    tokens.splice(free + 1..free + 1, place);
    tokens.drain(i..from);
    true
}

/// "All chairs should have about 80 cm behind them": 80 cm must be kept clear behind all chairs.
fn have_behind(tokens: &mut Vec<Token>, i: usize) -> bool {
    let must = matches!(word(tokens, i), "should" | "must" | "shall" | "need" | "needs");
    let have = i + usize::from(must);
    if !matches!(word(tokens, have), "have" | "has" | "to") || i == 0 {
        return false;
    }
    let have = if word(tokens, have) == "to" && word(tokens, have + 1) == "have" { have + 1 } else { have };
    let least = if word(tokens, have + 1) == "at" && word(tokens, have + 2) == "least" { 2 } else { 0 };
    let about = usize::from(matches!(word(tokens, have + 1), "about" | "around" | "roughly"));
    let from = have + 1 + least + about;
    let Some((_, used)) = number::count(tokens.get(from..).unwrap_or_default()) else { return false };
    let mut end = from + used + 1;
    if number::unit(word(tokens, end - 1)).is_none() {
        return false;
    }
    let amount = have + 1..end;
    // "Of free space", "free".
    end += tokens[end..]
        .iter()
        .take_while(|t| ["of", "free", "clear", "empty", "space", "room"].iter().any(|w| t.is(w)))
        .count();
    let relation = match (word(tokens, end), word(tokens, end + 1), word(tokens, end + 2)) {
        ("behind" | "beside" | "around" | "before", ..) => 1,
        ("in", "front", "of") => 3,
        _ => return false,
    };
    if !matches!(word(tokens, end + relation), "them" | "it") {
        return false;
    }
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | ';' | ':' | ','));
    let begin = tokens[..i].iter().rposition(stops).map_or(0, |n| n + 1);
    let name = &tokens[begin..i];
    if name.is_empty() || name.len() > NAME || !name.iter().all(Token::word) {
        return false;
    }
    let like = tokens[i].clone();
    let new = |text: &str| Token { kind: WordKind::Word, text: text.to_owned(), ..like.clone() };
    let mut said = tokens[amount].to_vec();
    said.extend(["must", "be", "kept", "clear"].map(new));
    said.extend_from_slice(&tokens[end..end + relation]);
    said.extend_from_slice(name);
    // What is in another order is all where the whole of it is.
    let whole = tokens[begin].at.start..tokens[end + relation].at.end;
    said.iter_mut().for_each(|token| token.at = whole.clone());
    tokens.splice(begin..=end + relation, said);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn the_place_of_free_space_comes_last() {
        for (said, becomes) in [
            (
                "behind every chair a depth of at least 0.9 m shall remain free.",
                "a depth of at least 0.9 m shall remain free behind every chair .",
            ),
            ("in front of the wardrobe, 1 m must be kept clear.", "1 m must be kept clear in front of the wardrobe ."),
            ("behind the bed a lamp 1.5 m tall stands free.", "behind the bed a lamp 1.5 m tall stands free ."),
            (
                "all chairs should have about 80 cm behind them so people can get up.",
                "about 80 cm must be kept clear behind all chairs so people can get up .",
            ),
            ("the sofa has 1 m of free space in front of it.", "1 m must be kept clear in front of the sofa ."),
            ("the desk has 2 drawers in it.", "the desk has 2 drawers in it ."),
            ("behind the sofa two plants stand clear.", "behind the sofa two plants stand clear ."),
            (
                "behind the sofa is a table 1 m wide, free of things.",
                "behind the sofa is a table 1 m wide , free of things .",
            ),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
