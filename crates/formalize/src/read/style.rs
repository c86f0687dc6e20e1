//! Styles that are said of rooms: "a Victorian study", "in art deco style", "a loft, industrial". What is said so is taken
//! out of the request, so that "art" is no thing in it.

use super::lexicon::{get, singular};
use super::paraphrase::word;
use super::token::{Token, WordKind};
use crate::brief::Room;
use crate::furnish::{kinds, styles};
use std::ops::Range;

/// What follows the name of a style.
const STYLE: [&str; 20] = [
    "style",
    "styled",
    "look",
    "looking",
    "feel",
    "vibe",
    "vibes",
    "theme",
    "themed",
    "aesthetic",
    "aesthetics",
    "atmosphere",
    "decor",
    "mood",
    "ambience",
    "interior",
    "setting",
    "inspired",
    "elements",
    "touches",
];
/// What else may stand where nothing but a style is said: "sci-fi level, …".
const SCENE: [&str; 7] = ["level", "scene", "game", "map", "environment", "world", "setting"];
/// What leads to it.
const LEADS: [&str; 12] = ["in", "with", "of", "a", "an", "the", "very", "really", "super", "quite", "somewhat", "and"];
/// The most words of a room's name, with what is said of it.
const LONGEST: usize = 4;

/// A style, and where it is said.
#[derive(Clone, Debug, PartialEq)]
pub struct SaidStyle {
    name: &'static str,
    at: Range<usize>,
    /// Whether it is said of the one room that is named there.
    is_before_room: bool,
}

/// Takes what is said of the style of rooms out of a request.
pub fn lift(tokens: &mut Vec<Token>) -> Vec<SaidStyle> {
    let mut found: Vec<SaidStyle> = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let Some((style, at, is_before_room)) = style(tokens, i) else {
            i += 1;
            continue;
        };
        let bytes = tokens[at.start].at.start..tokens[at.end - 1].at.end;
        i = at.start;
        tokens.drain(at);
        found.push(SaidStyle { name: style.name, at: bytes, is_before_room });
    }
    found
}

/// Writes styles into the rooms that they are said of. What is said first of a room stands.
pub fn say(rooms: &mut [Room], styles: &[SaidStyle], request: &str) {
    for style in styles {
        let starts = |room: &Room| room.source.at().start;
        let next = rooms.iter().map(starts).filter(|start| *start >= style.at.start).min();
        for room in rooms.iter_mut().filter(|room| room.style.is_none()) {
            // Of "a rustic kitchen and a modern bath" each has its own.
            let is_other =
                styles.len() > 1 && style.is_before_room && next.is_some_and(|next| room.source.at().start != next);
            if !is_other {
                room.style = Some(style.name);
            }
        }
    }
    // "A guardroom under a castle gatehouse": where it is says it, if the request begins so.
    let ends = |c: char| matches!(c, ',' | ':' | '.' | ';' | '\n' | '!');
    let first = request.split(ends).next().unwrap_or_default();
    for room in rooms.iter_mut().filter(|room| room.style.is_none()) {
        let is_first = room.source.at().end <= first.len();
        let place = if is_first { first } else { request.get(room.source.at()).unwrap_or_default() };
        room.style = styles::of_place(place).or_else(|| styles::of_place(&room.name)).map(|style| style.name);
    }
}

/// The style that is named from a token on if it is said of a room, all tokens that say so, and whether the room is named
/// right after it.
fn style(tokens: &[Token], i: usize) -> Option<(&'static styles::Style, Range<usize>, bool)> {
    let (style, end) = named(tokens, i)?;
    let mut from = i;
    while from > 0 && tokens[from - 1].word() && LEADS.contains(&word(tokens, from - 1)) {
        from -= 1;
    }
    let said = (end..end + 3).take_while(|k| STYLE.contains(&word(tokens, *k)) || word(tokens, *k) == "modern").count();
    if said > 0 && STYLE.contains(&word(tokens, end + said - 1)) {
        let end = end + said;
        return if names_room(tokens, end) {
            Some((style, i..end, true))
        } else {
            stands_alone(tokens, from, end).then(|| (style, with_comma(tokens, from, end), false))
        };
    }
    if names_room(tokens, end) {
        return Some((style, i..end, true));
    }
    let end = end + usize::from(SCENE.contains(&word(tokens, end)));
    let begins = from == 0 || is_sign(tokens, from - 1);
    (begins && (end == tokens.len() || is_sign(tokens, end))).then(|| (style, with_comma(tokens, from, end), false))
}

/// The longest name of a style that begins at a token, and where it ends.
fn named(tokens: &[Token], i: usize) -> Option<(&'static styles::Style, usize)> {
    (1..=styles::longest()).rev().find_map(|n| {
        let words = tokens.get(i..i + n)?;
        let text = words.iter().all(Token::word).then(|| words.iter().map(|t| t.text.as_str()).collect::<Vec<_>>())?;
        Some((styles::named(&text.join(" "))?, i + n))
    })
}

/// Whether the name of a room begins here, after a word or two that are said of it, and no name of a thing goes on behind it.
pub(super) fn names_room(tokens: &[Token], from: usize) -> bool {
    let words: Vec<String> = tokens[from.min(tokens.len())..]
        .iter()
        .take(LONGEST)
        .take_while(|t| t.word())
        .map(|t| t.text.clone())
        .collect();
    let is_room = |words: &[String]| get().room_ending(words).is_some() || kinds::named(&words.join(" ")).is_some();
    let ends = (1..=words.len()).rev().find(|n| is_room(&words[..*n]));
    ends.is_some_and(|n| {
        let function =
            words[..n].iter().any(|w| LEADS.contains(&w.as_str()) || matches!(w.as_str(), "for" | "to" | "on"));
        let next = word(tokens, from + n);
        // A toilet and a bar are things as well, unless the request begins with them.
        let is_thing = get().noun(&words[n - 1]).is_some()
            && tokens[..from].iter().any(|t| !t.word() || t.is("with") || t.is("and"));
        !function && !is_thing && (n == words.len() && n < LONGEST || get().noun(&singular(next)).is_none())
    })
}

/// Whether a phrase about style is one of its own: nothing follows that it could be said of.
fn stands_alone(tokens: &[Token], from: usize, end: usize) -> bool {
    let next = word(tokens, end);
    let ends = end >= tokens.len() || !tokens[end].word();
    let begins = from == 0 || is_sign(tokens, from - 1);
    let led = matches!(word(tokens, from), "in" | "with" | "of" | "a" | "an" | "the" | "and");
    (begins || led) && (ends || matches!(next, "with" | "for" | "and" | "please" | "where" | "that" | "which" | "to"))
}

fn is_sign(tokens: &[Token], i: usize) -> bool {
    matches!(tokens[i].kind, WordKind::Line | WordKind::Sign(_))
}

/// With the comma before it, or the one after it.
fn with_comma(tokens: &[Token], from: usize, end: usize) -> Range<usize> {
    let comma = |k: usize| tokens.get(k).is_some_and(|t| t.is(","));
    match () {
        () if from > 0 && comma(from - 1) => from - 1..end,
        () if comma(end) => from..end + 1,
        () => from..end,
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn styles_are_taken_out_with_what_says_so() {
        for (text, left, names) in [
            ("a hotel lobby in art deco style", "a hotel lobby", "art deco"),
            ("a hotel lobby with an Art-Deco look.", "a hotel lobby .", "art deco"),
            ("Victorian detective's study with a desk", "detective study with a desk", "victorian"),
            ("a mid-century modern living room with a sofa", "a living room with a sofa", "mid-century modern"),
            ("kitchen for five, modern farmhouse look. an island", "kitchen for five . an island", "farmhouse"),
            ("Sci-fi level, the bridge of a ship", "the bridge of a ship", "futuristic"),
            ("abandoned hospital ward, creepy, with beds", "hospital ward , with beds", "abandoned abandoned"),
            ("an industrial style loft", "an loft", "industrial"),
            ("a rustic kitchen and a modern bathroom", "a kitchen and a bathroom", "rustic modern"),
            // Said of things.
            ("a bedroom with a rustic table", "a bedroom with a rustic table", ""),
            ("a study with an art deco style lamp", "a study with an art deco style lamp", ""),
            ("a modern kitchen table in a hall", "a modern kitchen table in a hall", ""),
            ("a vintage bar stool", "a vintage bar stool", ""),
            ("a bath, and a modern toilet beside it", "a bath , and a modern toilet beside it", ""),
            ("a modern bar with stools", "a bar with stools", "modern"),
        ] {
            let mut tokens = tokens(text, 100).0;
            let found = lift(&mut tokens).iter().map(|style| style.name).collect::<Vec<_>>().join(" ");
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!((rest.join(" ").as_str(), found.as_str()), (left, names), "{text}");
        }
    }
}
