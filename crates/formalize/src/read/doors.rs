//! Doors that are said as several or by what is behind them: "French doors" are one door with two leaves, and in "the toilets are
//! through a door at the rear" there is a door at the rear.

use super::number::count;
use super::paraphrase::{put, word};
use super::token::Token;

/// What has two leaves and is said in the plural.
const PAIRS: [&str; 8] = ["french", "patio", "bifold", "folding", "double", "swing", "sliding", "terrace"];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    pair(tokens, i) || leads_on(tokens, i)
}

/// "The patio doors": a door. "Two French doors" are two.
fn pair(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !PAIRS.contains(&word(tokens, i)) || word(tokens, i + 1) != "doors" {
        return false;
    }
    // A wardrobe has such doors, too.
    let several = (i.saturating_sub(2)..i).any(|k| {
        let counted = count(&tokens[k..=k]).is_some_and(|(n, _)| n > 1.0);
        counted || matches!(tokens[k].text.as_str(), "all" | "both" | "its")
    });
    let of_furniture =
        i > 1 && word(tokens, i - 1) == "with" && crate::brief::opens(&super::lexicon::singular(word(tokens, i - 2)));
    if several || of_furniture {
        return false;
    }
    let name = if word(tokens, i) == "swing" { "double" } else { word(tokens, i) }.to_owned();
    let bare = i == 0 || !matches!(word(tokens, i - 1), "the" | "a" | "some" | "glass" | "wide" | "big" | "large");
    let some = i > 0 && word(tokens, i - 1) == "some";
    let from = i - usize::from(some);
    let words: &[&str] = if bare || some { &["a", &name, "door"] } else { &[&name, "door"] };
    put(tokens, from, i + 2, words);
    true
}

/// "The loos are through a door at the rear": there is a door at the back.
fn leads_on(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BEHIND: [&str; 12] = [
        "toilets",
        "toilet",
        "loos",
        "loo",
        "restrooms",
        "restroom",
        "washrooms",
        "washroom",
        "stockroom",
        "storeroom",
        "cellar",
        "changing",
    ];
    let named = word(tokens, i) == "the" && BEHIND.contains(&word(tokens, i + 1));
    let verb = i + 2 + usize::from(word(tokens, i + 1) == "changing");
    let is = matches!(word(tokens, verb), "are" | "is" | "lie" | "lies");
    let through = verb + 1;
    let by = matches!(word(tokens, through), "through" | "behind") && matches!(word(tokens, through + 1), "a" | "the");
    let door = through + 2;
    let placed = matches!(word(tokens, door + 1), "at" | "in" | "on") && word(tokens, door + 2) == "the";
    let end = door + 3;
    let side = match word(tokens, end) {
        "rear" | "back" => "back",
        "front" => "front",
        "left" => "left",
        "right" => "right",
        _ => return false,
    };
    let wall = usize::from(matches!(word(tokens, end + 1), "wall" | "side"));
    if !named || !is || !by || word(tokens, door) != "door" || !placed {
        return false;
    }
    put(tokens, i, end + 1 + wall, &["there", "is", "a", "door", "in", "the", side, "wall"]);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn doors_are_one_each() {
        for (said, becomes) in [
            ("a table near the patio doors", "a table near the patio door"),
            ("a lounge with French doors.", "a lounge with a french door ."),
            ("two sliding doors", "two sliding doors"),
            ("a wardrobe with sliding doors", "a wardrobe with sliding doors"),
            ("The loos are through a door at the rear.", "there is a door in the back wall ."),
            ("the toilets are clean", "the toilets are clean"),
        ] {
            assert_eq!(plainly(said), becomes, "{said}");
        }
    }
}
