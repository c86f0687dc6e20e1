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
