//! The colours that a room is to have: "in warm beige and brown colours", "pastel tones", "in shades of blue".

use super::lexicon::{LookWord, get};
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use crate::brief::Room;
use crate::colors::known;
use crate::furnish::kinds;
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
/// What makes another colour of one.
const SHADES: [&str; 6] = ["dark", "light", "deep", "pale", "bright", "pastel"];
/// The most words of a room's name.
const LONGEST: usize = 4;
/// Words that say nothing more of a colour.
const SAID: [&str; 4] = ["soft", "muted", "light", "calm"];

/// Colours that are said of a room, and where.
pub type Palette = (Range<usize>, Vec<String>);

/// Takes what is said of the colours of a room out of a request: after its name, or as a part of a list of its own. What stands
/// after a thing is said of the thing.
pub fn lift(tokens: &mut Vec<Token>) -> Option<Palette> {
    let (colors, said) = (0..tokens.len()).find_map(|at| {
        let (colors, said) = palette(tokens, at)?;
        is_of_room(tokens, said.start).then_some((colors, said))
    })?;
    let at = tokens[said.start].at.start..tokens[said.end - 1].at.end;
    let mut end = said.end;
    if said.start > 0 && tokens[said.start - 1].is(",") {
        end += usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    }
    tokens.drain(said.start..end);
    Some((at, colors))
}

/// Takes colours that nothing is to have out of a request: "no blue, please". Each with where that is said.
pub fn unwanted(tokens: &mut Vec<Token>) -> Vec<(String, Range<usize>)> {
    let mut found = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let no = matches!(word(tokens, i), "no" | "without" | "nothing" | "avoid" | "not");
        let begins =
            i == 0 || !tokens[i - 1].word() || matches!(word(tokens, i - 1), "and" | "but" | "please" | "with");
        let any = i + 1 + usize::from(word(tokens, i + 1) == "any");
        let Some((mut named, mut end)) = colors(tokens, any).filter(|_| no && begins) else {
            i += 1;
            continue;
        };
        // "No white or grey".
        while let Some((more, to)) = colors(tokens, end + 1).filter(|_| matches!(word(tokens, end), "or" | "nor")) {
            named.extend(more);
            end = to;
        }
        let after = (end..end + 3)
            .take_while(|k| {
                matches!(word(tokens, *k), "please" | "anywhere" | "though" | "at" | "all" | "tones" | "shades")
            })
            .count();
        let end = end + after;
        // "No blue chairs": chairs.
        if tokens.get(end).is_some_and(|t| t.word() && !t.is("and") && !t.is("but")) {
            i += 1;
            continue;
        }
        let at = tokens[i].at.start..tokens[end - 1].at.end;
        found.extend(named.into_iter().map(|color| (color, at.clone())));
        let from = i - usize::from(i > 0 && tokens[i - 1].is(","));
        tokens.drain(from..end);
        i = from;
    }
    found
}

/// Whether what begins at a token is said of a room: its name is before it, or a list goes on there.
fn is_of_room(tokens: &[Token], start: usize) -> bool {
    start == 0 || matches!(tokens[start - 1].kind, WordKind::Line | WordKind::Sign(_)) || ends_room(tokens, start)
}

/// Whether the name of a room ends before a token.
fn ends_room(tokens: &[Token], end: usize) -> bool {
    let words: Vec<String> =
        tokens[..end].iter().rev().take(LONGEST).take_while(|t| t.word()).map(|t| t.text.clone()).collect();
    let words: Vec<String> = words.into_iter().rev().collect();
    get().room_ending(&words).is_some()
        || (1..=words.len()).any(|n| kinds::named(&words[words.len() - n..].join(" ")).is_some())
}

/// Writes the colours into the room that is spoken of where they are said.
pub fn say(rooms: &mut [Room], (at, colors): Palette) {
    let room = rooms.iter().rposition(|room| room.source.at().start <= at.start).unwrap_or(0);
    if let Some(room) = rooms.get_mut(room) {
        room.palette = colors;
    }
}

/// The colours that the word at an index stands for, and all words that say so.
fn palette(tokens: &[Token], at: usize) -> Option<(Vec<String>, Range<usize>)> {
    if !COLORS.contains(&word(tokens, at)) {
        return None;
    }
    // "Shades of blue and green".
    if word(tokens, at + 1) == "of"
        && let Some((colors, end)) = colors(tokens, at + 2)
    {
        return Some((colors, with_in(tokens, at)..end));
    }
    let last = at - usize::from(at > 0 && matches!(word(tokens, at - 1), "colour" | "color"));
    let mood = |k: usize| MOODS.iter().find(|(mood, _)| *mood == word(tokens, k)).map(|(_, colors)| *colors);
    let named = (last.saturating_sub(8)..last)
        .find_map(|k| colors(tokens, k).filter(|(_, end)| *end == last).map(|(all, _)| (k, all)));
    let (mut start, mut found) = named.unwrap_or((last, Vec::new()));
    while start > 0 && (mood(start - 1).is_some() || SAID.contains(&word(tokens, start - 1))) {
        start -= 1;
        if let (true, Some(mood)) = (found.is_empty(), mood(start)) {
            found = mood.iter().map(|color| (*color).to_owned()).collect();
        }
    }
    (!found.is_empty()).then(|| (found, with_in(tokens, start)..at + 1))
}

/// The colours that are listed from a token on, and where the list ends: "pink, dark green and white".
fn colors(tokens: &[Token], from: usize) -> Option<(Vec<String>, usize)> {
    let one = |k: usize| -> Option<(String, usize)> {
        let is_color = |k: usize| get().look(word(tokens, k)) == Some(LookWord::Color);
        let pair = format!("{}{}", word(tokens, k), word(tokens, k + 1));
        if SHADES.contains(&word(tokens, k)) && is_color(k + 1) {
            return Some((known(&pair).or_else(|| known(word(tokens, k + 1)))?, k + 2));
        }
        is_color(k).then(|| known(word(tokens, k)))?.map(|color| (color, k + 1))
    };
    let (first, mut end) = one(from)?;
    let mut all = vec![first];
    loop {
        let comma = usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
        let and = usize::from(word(tokens, end + comma) == "and");
        let Some((next, to)) = one(end + comma + and).filter(|_| comma + and > 0) else { return Some((all, end)) };
        all.push(next);
        end = to;
    }
}

/// "A salon, pink and white, with a desk", "a hotel room, dark green": in pink and white tones.
fn listed(tokens: &mut Vec<Token>, i: usize) -> bool {
    let comma = tokens[i].is(",");
    if i == 0 || !(comma || word(tokens, i) == "in") {
        return false;
    }
    let Some((all, end)) = colors(tokens, i + 1) else { return false };
    let of_room = ends_room(tokens, i);
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':' | '!'));
    let sentence = tokens[..i].iter().rposition(stops).map_or(0, |k| k + 1);
    let in_list = comma && all.len() > 1 && tokens[sentence..i].iter().any(|t| t.is(","));
    let ends = tokens.get(end).is_none_or(|t| matches!(t.kind, WordKind::Line | WordKind::Sign(_)));
    let stands = ends || of_room && word(tokens, end) == "with";
    if !stands || !(of_room || in_list) {
        return false;
    }
    let tones: Token = Token { text: "tones".to_owned(), ..tokens[end - 1].clone() };
    tokens.insert(end, tones);
    if comma {
        let in_them = Token { kind: WordKind::Word, text: "in".to_owned(), ..tokens[i].clone() };
        tokens.insert(i + 1, in_them);
    }
    true
}

/// "In soft greens and blues": in green and blue tones.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    if listed(tokens, i) {
        return true;
    }
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
            ("a hotel room, dark green.", "a hotel room , in dark green tones ."),
            ("a salon in pink and white, a desk", "a salon in pink and white tones , a desk"),
            (
                "a salon, four tables, pink and white, a desk",
                "a salon , four tables , in pink and white tones , a desk",
            ),
            ("a sofa, dark green", "a sofa , dark green"),
            ("two chairs, red and blue", "two chairs , red and blue"),
            ("a salon, in", "a salon , in"),
        ] {
            assert_eq!(crate::read::paraphrase::plainly(said), becomes);
        }
    }

    #[test]
    fn colors_that_nothing_is_to_have_are_taken_out() {
        for (text, colors, becomes) in [
            ("a bedroom, bunk bed, no blue please", "blue", "a bedroom , bunk bed"),
            ("an office with a desk, no white or grey", "white gray", "an office with a desk"),
            ("a study. nothing red. a desk", "red", "a study . . a desk"),
            ("a study with no blue chairs", "", "a study with no blue chairs"),
        ] {
            let mut tokens = tokens(text, 100).0;
            let found: Vec<String> = unwanted(&mut tokens).into_iter().map(|(color, _)| color).collect();
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!((found.join(" ").as_str(), words.join(" ").as_str()), (colors, becomes));
        }
    }

    #[test]
    fn palettes_are_found_with_their_words() {
        for (text, expected) in [
            ("a lobby, warm beige and brown colours.", Some(("beige brown", "warm beige and brown colours"))),
            ("a bedroom in pastel tones", Some(("mint peach lavender", "in pastel tones"))),
            ("a study in shades of blue and gray.", Some(("blue gray", "in shades of blue and gray"))),
            ("a nursery in a soft yellow colour scheme", Some(("yellow", "in a soft yellow colour scheme"))),
            ("a den in dark green and gold tones", Some(("darkgreen gold", "in dark green and gold tones"))),
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
