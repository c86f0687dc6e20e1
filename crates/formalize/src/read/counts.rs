//! Counts and measures that cannot be: none of something, less than none, a part of a thing, more than can be placed. What
//! is made of them is said.

use super::lexicon::get;
use super::number::{self, unit};
use super::token::{Token, WordKind};
use crate::brief::too_many;
use std::ops::Range;

/// Less than this (metres) is no size of a thing.
const THIN: f64 = 0.01;

/// "0 beds" are no beds.
pub fn none(tokens: &mut [Token]) {
    for i in 0..tokens.len() {
        if tokens[i].kind != WordKind::Number(0.0) || tokens[i].text != "0" {
            continue;
        }
        let before = i.checked_sub(1).map(|k| &tokens[k]);
        // "2 - 0", "x 0": part of something else.
        let begins = before.is_none_or(|t| !matches!(t.kind, WordKind::Number(_)) && !t.is("x") && !t.is("by"));
        let counts = tokens.get(i + 1).is_some_and(|t| {
            t.word()
                && unit(&t.text).is_none()
                && !matches!(t.text.as_str(), "x" | "by" | "square" | "sq" | "degrees" | "to" | "or")
        });
        if begins && counts {
            tokens[i].kind = WordKind::Word;
            tokens[i].text = "no".into();
        }
    }
}

/// Numbers below zero, which are read without their sign, and halves of things.
pub fn odd(tokens: &[Token]) -> Vec<(Range<usize>, String)> {
    let mut out = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        if let (WordKind::Number(n), true) = (token.kind, i > 0) {
            let sign = &tokens[i - 1];
            // "-3 chairs", but not "2-3 chairs" and not "a desk - 2 m long".
            let alone = i == 1 || tokens[i - 2].at.end < sign.at.start || tokens[i - 2].is("(");
            let minus = matches!(sign.kind, WordKind::Sign('-' | '−' | '—')) && sign.at.end == token.at.start && alone;
            if minus || sign.is("minus") {
                let at = sign.at.start..token.at.end;
                out.push((at, format!("counts and sizes cannot be negative: this is read as {n}")));
            }
        }
        let word = |k: usize| tokens.get(k).map_or("", |t| t.text.as_str());
        let along = ["long", "wide", "high", "tall", "deep", "thick", "across"].contains(&word(i + 2));
        if let (WordKind::Number(n), Some(metres), true) = (token.kind, unit(word(i + 1)), along)
            && n * metres < THIN
        {
            let at = token.at.start..tokens[i + 2].at.end;
            out.push((at, format!("too thin: the size is increased to at least {THIN} m, or to the usual size")));
        }
        let thing = |k: usize| tokens.get(k).is_some_and(|t| t.word() && get().noun(&t.text).is_some());
        let whole = tokens.get(i + 1).is_some_and(|t| t.is("a") || t.is("an"));
        if token.is("half") && whole && thing(i + 2) && number::count(&tokens[i..]).is_none() {
            let at = token.at.start..tokens[i + 2].at.end;
            out.push((at, "objects come in whole numbers: this is read as 1".to_owned()));
        }
    }
    out
}

/// The whole number of things that a number stands for.
pub fn whole(n: f64) -> usize {
    n.floor().max(1.0) as usize
}

/// What is said of a count that is not taken as it is.
pub fn said(n: f64) -> Option<String> {
    if n.fract() != 0.0 {
        return Some(format!("objects come in whole numbers: {n} is read as {}", whole(n)));
    }
    too_many(n as usize)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn zero_is_none_where_it_counts() {
        for (text, becomes) in [
            ("0 beds", true),
            ("a desk and 0 beds", true),
            ("0 m wide", false),
            ("4 x 0 m", false),
            ("0.5 m", false),
            ("0 x 4 m", false),
        ] {
            let mut tokens = tokens(text, 100).0;
            none(&mut tokens);
            assert_eq!(tokens.iter().any(|t| t.is("no")), becomes, "{text}");
        }
    }

    #[test]
    fn what_is_below_zero_is_said() {
        for (text, times) in [
            ("-3 chairs", 1),
            ("a table (-2 m long)", 1),
            ("minus 2 chairs", 1),
            ("2-3 chairs", 0),
            ("a desk - 2 m long", 0),
            ("half a bed", 1),
            ("half a dozen beds", 0),
            ("half a metre", 0),
            ("a table 0 m long", 1),
            ("a rug 5 mm thick", 1),
            ("a rug 2 cm thick", 0),
            ("0 m from the wall", 0),
        ] {
            assert_eq!(odd(&tokens(text, 100).0).len(), times, "{text}");
        }
    }
}
