//! Rooms that are to become another: "we turn our garage into a pottery studio" and "the attic is going to be the guest bedroom"
//! ask for the studio and for the bedroom.

use super::lexicon::get;
use super::paraphrase::word;
use super::token::{Token, WordKind};
use std::ops::Range;

/// The most words of a room's name, and between the verb and "into".
const LONGEST: usize = 4;
const NEAR: usize = 14;

/// Puts what rooms become in their places.
pub fn plain(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        let _ = into(tokens, i) || becomes(tokens, i);
        i += 1;
    }
}

/// "Turning our garage (5.5 x 6 m) into a pottery studio": a pottery studio (5.5 x 6 m).
fn into(tokens: &mut Vec<Token>, i: usize) -> bool {
    const TURN: [&str; 14] = [
        "turn",
        "turning",
        "turned",
        "convert",
        "converting",
        "converted",
        "transform",
        "transforming",
        "transformed",
        "make",
        "making",
        "change",
        "changing",
        "remodel",
    ];
    if !TURN.contains(&word(tokens, i)) {
        return false;
    }
    let Some(old) = room(tokens, i + 1) else { return false };
    let stops = |k: &usize| tokens.get(*k).is_none_or(Token::stops);
    let Some(into) = (old.end..old.end + NEAR).take_while(|k| !stops(k)).find(|k| word(tokens, *k) == "into") else {
        return false;
    };
    let Some(new) = room(tokens, into + 1) else { return false };
    let name = tokens[new.clone()].to_vec();
    tokens.drain(into..new.end);
    tokens.splice(old, name);
    true
}

/// "Our attic is going to be the guest bedroom": the guest bedroom.
fn becomes(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BE: [&[&str]; 10] = [
        &["is", "going", "to", "be"],
        &["is", "going", "to", "become"],
        &["is", "to", "become"],
        &["is", "to", "be"],
        &["will", "become"],
        &["will", "be"],
        &["becomes"],
        &["should", "become"],
        &["is", "becoming"],
        &["is", "being", "turned", "into"],
    ];
    let begins = i == 0
        || tokens[i - 1].stops()
        || matches!(tokens[i - 1].kind, WordKind::Sign(','))
        || word(tokens, i - 1) == "and";
    let Some(old) = begins.then(|| room(tokens, i)).flatten() else { return false };
    let is = |words: &&&[&str]| words.iter().enumerate().all(|(k, w)| word(tokens, old.end + k) == *w);
    let Some(be) = BE.iter().find(is) else { return false };
    let Some(new) = room(tokens, old.end + be.len()) else { return false };
    let name = tokens[new.clone()].to_vec();
    tokens.splice(old.start..new.end, name);
    true
}

/// The article and the name of a room that begin here.
fn room(tokens: &[Token], from: usize) -> Option<Range<usize>> {
    let article = matches!(word(tokens, from), "a" | "an" | "the" | "my" | "our" | "this" | "their" | "his" | "her");
    let name = from + usize::from(article);
    let names = |n: &usize| {
        let words: Vec<String> = (name..name + n).map(|k| word(tokens, k).to_owned()).collect();
        let joins = |word: &str| {
            matches!(word, "" | "into" | "is" | "will" | "of" | "the" | "a" | "with" | "for" | "and" | "in")
        };
        let plain = words.iter().all(|word| !joins(word));
        let furnished = crate::furnish::kinds::named(&words.join(" ")).is_some();
        plain && (furnished || get().room_ending(&words).is_some_and(|(_, kind)| kind.name != "room"))
    };
    let n = article.then(|| (1..=LONGEST).rev().find(names)).flatten()?;
    Some(from..name + n)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn what_a_room_becomes_counts() {
        for (text, becomes) in [
            (
                "we are turning our garage (5.5 m x 6 m) into a pottery studio. a stool.",
                "we are turning a pottery studio ( 5.5 m x 6 m ) . a stool .",
            ),
            ("our attic is going to be the guest bedroom. it is large.", "the guest bedroom . it is large ."),
            ("convert the spare bedroom into a home office with a desk", "convert a home office with a desk"),
            ("the sofa is going to be the bed", "the sofa is going to be the bed"),
            ("my kitchen is to be the heart of the home", "my kitchen is to be the heart of the home"),
            ("make the kitchen large", "make the kitchen large"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
