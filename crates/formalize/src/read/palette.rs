//! The colours that a room is to have: "in warm beige and brown colours", "pastel tones", "in shades of blue".

use super::lexicon::{LookWord, get};
use super::paraphrase::{put, word};
use super::token::Token;
use crate::brief::Room;
use crate::colors::known;
use std::ops::Range;

/// Words for colours in general.
const COLORS: [&str; 7] = ["colours", "colors", "tones", "shades", "hues", "palette", "scheme"];
/// What colours are said to be like, and which colours these are.
const MOODS: [(&str, &[&str]); 9] = [
    ("warm", &["terracotta", "mustard", "sand"]),
    ("cool", &["steelblue", "lightgray", "teal"]),
    ("pastel", &["mint", "peach", "lavender"]),
    ("earth", &["olive", "clay", "sand"]),
    ("earthy", &["olive", "clay", "sand"]),
    ("natural", &["sage", "sand", "clay"]),
    ("neutral", &["beige", "gray", "white"]),
    ("bright", &["yellow", "coral", "skyblue"]),
    ("cheerful", &["yellow", "coral", "skyblue"]),
];
/// Words that say nothing more of a colour.
const SAID: [&str; 4] = ["soft", "muted", "light", "calm"];

/// Writes them into the room that is spoken of there, if the words were not read otherwise. The tokens that say so.
pub fn say(rooms: &mut [Room], tokens: &[Token], used: &[bool]) -> Range<usize> {
    let Some((colors, said)) = (0..tokens.len()).find_map(|at| palette(tokens, at)) else { return 0..0 };
    if used[said.clone()].iter().any(|used| *used) {
        return 0..0;
    }
    let at = tokens[said.start].at.start;
    let room = rooms.iter().rposition(|room| room.source.at().start <= at).unwrap_or(0);
    if let Some(room) = rooms.get_mut(room) {
        room.palette = colors;
    }
    said
}

/// The colours that the word at an index stands for, and all words that say so.
fn palette(tokens: &[Token], at: usize) -> Option<(Vec<String>, Range<usize>)> {
    if !COLORS.contains(&word(tokens, at)) {
        return None;
    }
    let is_color = |k: usize| get().look(word(tokens, k)) == Some(LookWord::Color) && known(word(tokens, k)).is_some();
    let joins = |k: usize| tokens[k].is("and") || tokens[k].is(",");
    // "Shades of blue and green".
    if word(tokens, at + 1) == "of" && is_color(at + 2) {
        let mut end = at + 3;
        while end + 1 < tokens.len() && joins(end) && is_color(end + 1) {
            end += 2;
        }
        let colors = (at + 2..end).filter(|k| is_color(*k)).filter_map(|k| known(word(tokens, k))).collect();
        return Some((colors, with_in(tokens, at)..end));
    }
    let last = at - usize::from(at > 0 && matches!(word(tokens, at - 1), "colour" | "color"));
    let mood = |k: usize| MOODS.iter().find(|(mood, _)| *mood == word(tokens, k)).map(|(_, colors)| *colors);
    let mut start = last;
    while start > 0 && (is_color(start - 1) || start < last && start > 1 && joins(start - 1) && is_color(start - 2)) {
        start -= 1;
    }
    let mut colors: Vec<String> = (start..last).filter_map(|k| known(word(tokens, k))).collect();
    while start > 0 && (mood(start - 1).is_some() || SAID.contains(&word(tokens, start - 1))) {
        start -= 1;
        if let (true, Some(mood)) = (colors.is_empty(), mood(start)) {
            colors = mood.iter().map(|color| (*color).to_owned()).collect();
        }
    }
    (!colors.is_empty()).then(|| (colors, with_in(tokens, start)..at + 1))
}

/// "In soft greens and blues": in green and blue tones.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = |k: usize| SAID.contains(&word(tokens, k)) || MOODS.iter().any(|(mood, _)| *mood == word(tokens, k));
    let color = |k: usize| {
        let one = word(tokens, k).strip_suffix('s')?;
        (get().look(one) == Some(LookWord::Color) && known(one).is_some()).then(|| one.to_owned())
    };
    let first = (i + 1..i + 4).find(|k| !said(*k)).unwrap_or(i + 1);
    let Some(one) = color(first).filter(|_| word(tokens, i) == "in") else { return false };
    let second = color(first + 2).filter(|_| tokens[first + 1].is("and"));
    match second {
        Some(second) => put(tokens, i, first + 3, &["in", &one, "and", &second, "tones"]),
        None => put(tokens, i, first + 1, &["in", &one, "tones"]),
    }
    true
}

/// Where a phrase begins with what leads to it: "in", "in a".
fn with_in(tokens: &[Token], start: usize) -> usize {
    let article = start - usize::from(start > 0 && matches!(word(tokens, start - 1), "a" | "an"));
    article - usize::from(article > 0 && matches!(word(tokens, article - 1), "in" | "of"))
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn plural_colors_are_tones() {
        for (said, becomes) in [
            ("a nursery in soft greens and natural wood", "a nursery in green tones and natural wood"),
            ("a study in blues and grays.", "a study in blue and gray tones ."),
            ("a kitchen with greens on the table", "a kitchen with greens on the table"),
            ("a hall with glasses", "a hall with glasses"),
        ] {
            assert_eq!(crate::read::paraphrase::plainly(said), becomes);
        }
    }

    #[test]
    fn palettes_are_found_with_their_words() {
        for (text, expected) in [
            ("a lobby, warm beige and brown colours.", Some(("beige brown", "warm beige and brown colours"))),
            ("a bedroom in pastel tones", Some(("mint peach lavender", "in pastel tones"))),
            ("a study in shades of blue and gray.", Some(("blue gray", "in shades of blue and gray"))),
            ("a nursery in a soft yellow colour scheme", Some(("yellow", "in a soft yellow colour scheme"))),
            ("chairs in different colours", None),
            ("three coloured boxes", None),
        ] {
            let tokens = tokens(text, 100).0;
            let found = (0..tokens.len()).find_map(|at| palette(&tokens, at)).map(|(colors, said)| {
                let words: Vec<&str> = tokens[said].iter().map(|t| t.text.as_str()).collect();
                (colors.join(" "), words.join(" "))
            });
            let expected = expected.map(|(colors, words)| (colors.to_owned(), words.to_owned()));
            assert_eq!(found, expected, "{text}");
        }
    }
}
