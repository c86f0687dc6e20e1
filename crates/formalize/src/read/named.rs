//! Rooms that are called by the last word of their name, where that word is a thing as well: "A ramen bar with its own
//! kitchen. The bar is nine metres long": the ramen bar.

use super::lexicon::get;
use super::number::count;
use super::paraphrase::word;
use super::token::{Token, WordKind};

/// Gives a room its whole name wherever it is called by the last word of it. Only where a measure says that the room is
/// meant: who speaks of "the bar" may mean the counter.
pub fn whole(tokens: &mut Vec<Token>) {
    let Some((first, last)) = named(tokens) else { return };
    let measured = |i: usize| {
        let number =
            tokens.get(i + 3..i + 4).is_some_and(|t| matches!(t[0].kind, WordKind::Number(_)) || count(t).is_some());
        let long = (i + 4..i + 7).any(|k| matches!(word(tokens, k), "long" | "wide" | "by" | "x"));
        short(tokens, i, &last) && word(tokens, i + 2) == "is" && number && long
    };
    if !(0..tokens.len()).any(measured) {
        return;
    }
    let mut i = 0;
    while i < tokens.len() {
        let at_thing = i > 0
            && matches!(word(tokens, i - 1), "at" | "on" | "behind" | "above" | "along" | "under" | "around" | "of");
        if short(tokens, i, &last) && !at_thing {
            let at = tokens[i + 1].at.clone();
            tokens.insert(i + 1, Token { kind: WordKind::Word, text: first.clone(), at, owner: false, capital: false });
        }
        i += 1;
    }
}

/// "the bar"
fn short(tokens: &[Token], i: usize, last: &str) -> bool {
    word(tokens, i) == "the" && word(tokens, i + 1) == last
}

/// The first room that has a name of two words, of which the last alone is a thing.
fn named(tokens: &[Token]) -> Option<(String, String)> {
    let lexicon = get();
    (0..tokens.len().saturating_sub(1)).find_map(|i| {
        let (first, last) = (word(tokens, i), word(tokens, i + 1));
        let room = lexicon.room(&format!("{first} {last}")).is_some_and(|kind| !kind.loose);
        let thing = lexicon.room(last).is_none() && lexicon.noun(last).is_some();
        (room && thing).then(|| (first.to_owned(), last.to_owned()))
    })
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn the_last_word_stands_for_the_name() {
        for (text, becomes) in [
            ("a ramen bar. the bar is 9 m long.", "a ramen bar . the ramen bar is 9 m long ."),
            (
                "a ramen bar. the bar is 9 m long. a stool at the bar.",
                "a ramen bar . the ramen bar is 9 m long . a stool at the bar .",
            ),
            ("a ramen bar. the bar is nine metres long.", "a ramen bar . the ramen bar is nine metres long ."),
            ("a ramen bar. the bar is made of oak.", "a ramen bar . the bar is made of oak ."),
            ("a bar. the bar is 9 m long.", "a bar . the bar is 9 m long ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            whole(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
