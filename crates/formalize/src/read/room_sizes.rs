//! Sizes of the room that are said far from it: in "a ward for testing a robot, 9 by 7.2 m" the ward is so large, and not the
//! robot; "maybe 7 by 5 m" and "its only 400 sq ft" are sizes as well.

use super::lexicon::singular;
use super::measure::measure;
use super::noun::room_here;
use super::number;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use std::ops::Range;

/// No room is smaller across than this many metres, as far as such a size is moved to it.
const LEAST: f64 = 2.0;
/// So many times as large as usual a thing is not.
const TOO_LARGE: f64 = 2.0;

/// Says sizes where they are read.
pub fn plain(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        guessed(tokens, i);
        large_for_wide(tokens, i);
        only_area(tokens, i);
        floor_is(tokens, i);
        i += 1;
    }
    behind_things(tokens);
}

fn is_number(tokens: &[Token], i: usize) -> bool {
    tokens.get(i).is_some_and(|t| matches!(t.kind, WordKind::Number(_)))
}

/// "Maybe 7 by 5 metres": about.
fn guessed(tokens: &mut Vec<Token>, i: usize) {
    let guess = matches!(word(tokens, i), "maybe" | "perhaps" | "say" | "possibly");
    let sides = guess && is_number(tokens, i + 1) && measure(&tokens[i + 1..]).is_some_and(|(m, _)| m.values.len() > 1);
    if sides {
        put(tokens, i, i + 1, &["about"]);
    }
}

/// "13 metres long, 6 metres large": wide.
fn large_for_wide(tokens: &mut Vec<Token>, i: usize) {
    let said =
        word(tokens, i) == "large" && i > 1 && is_number(tokens, i - 2) && number::unit(word(tokens, i - 1)).is_some();
    let long = (i.saturating_sub(8)..i).any(|k| word(tokens, k) == "long");
    if said && long {
        put(tokens, i, i + 1, &["wide"]);
    }
}

/// "But its only 400 sq ft": the room is.
fn only_area(tokens: &mut Vec<Token>, i: usize) {
    let its = match (word(tokens, i), word(tokens, i + 1)) {
        ("its" | "it's", _) => i + 1,
        ("it", "is") => i + 2,
        _ => return,
    };
    let only = its + usize::from(matches!(word(tokens, its), "only" | "just" | "about"));
    if !is_number(tokens, only) || number::area(&tokens[only..]).is_none() {
        return;
    }
    let but = i > 0 && matches!(word(tokens, i - 1), "but" | "and" | "so");
    let from = i - usize::from(but);
    put(tokens, from, only, &[".", "the", "room", "is"]);
    tokens[from].kind = WordKind::Sign('.');
}

/// "The floor is about 10 metres by 6": the room is.
fn floor_is(tokens: &mut Vec<Token>, i: usize) {
    let named = matches!(word(tokens, i + 1), "floor" | "space" | "place" | "area" | "unit" | "premises" | "footprint");
    let is = matches!(word(tokens, i + 2), "is" | "measures" | "are");
    let about =
        i + 3 + usize::from(matches!(word(tokens, i + 3), "about" | "around" | "roughly" | "maybe" | "perhaps"));
    let sides =
        || measure(tokens.get(about..)?).filter(|(m, _)| m.values.len() > 1 && m.values.iter().all(|v| *v >= LEAST));
    if matches!(word(tokens, i), "the" | "our" | "my") && named && is && sides().is_some() {
        put(tokens, i + 1, i + 2, &["room"]);
    }
}

/// "A ward for testing a robot, 9 by 7.2 m": a ward, 9 by 7.2 m, for testing a robot.
fn behind_things(tokens: &mut Vec<Token>) {
    let Some(room) = (0..tokens.len()).find_map(|i| room_here(&tokens[i..]).map(|n| i..i + n)) else { return };
    let first = tokens[room.end..].iter().position(Token::stops).map_or(tokens.len(), |n| room.end + n);
    let sized = |i: usize| -> Option<Range<usize>> {
        let about = usize::from(matches!(word(tokens, i), "about" | "around" | "roughly" | "approximately"));
        let (m, used) = measure(tokens.get(i + about..)?)?;
        let sides = m.values.len() >= 2 && m.values[..2].iter().all(|side| *side >= LEAST) && m.plain();
        (sides && !m.area).then_some(i..i + about + used)
    };
    // Where the room has a size of its own, another one is that of a thing.
    let own = (room.end..room.end + 4).any(|k| sized(k).is_some());
    let comma = |k: &usize| tokens[*k].is(",");
    let within = (room.end..first).filter(comma).find_map(|k| Some((k, sized(k + 1)?)));
    // "A library that a robot drives in. Maybe 15 by 12 m, five shelves".
    let next = || Some((first, sized(first + 1)?)).filter(|_| first > room.end);
    let Some((at, size)) = within.or_else(next) else { return };
    let ends = tokens.get(size.end).is_none_or(|t| !t.word());
    if own || !ends || at == room.end || at != first && is_as_large(tokens, at, &size) {
        return;
    }
    let said: Vec<Token> = if at == first {
        // The sentence before it ends where it did.
        let like = tokens[at].clone();
        let size: Vec<Token> = tokens.drain(at + 1..size.end).collect();
        std::iter::once(Token { kind: WordKind::Sign(','), ..like.saying(",") }).chain(size).collect()
    } else {
        tokens.drain(at..size.end).collect()
    };
    tokens.splice(room.end..room.end, said);
    let end = room.end + size.end - at;
    // What followed the name goes on after another comma.
    if tokens.get(end).is_some_and(Token::word) {
        let comma = Token { kind: WordKind::Sign(','), ..tokens[room.end].saying(",") };
        tokens.insert(end, comma);
    }
}

/// Whether the thing named before a token may be of that size.
fn is_as_large(tokens: &[Token], at: usize, size: &Range<usize>) -> bool {
    const SURFACES: [&str; 12] =
        ["rug", "carpet", "pool", "stage", "area", "zone", "floor", "ring", "court", "platform", "terrace", "hole"];
    let Some((m, _)) = (size.start..size.end).find_map(|k| measure(&tokens[k..])) else { return true };
    let least = m.values.iter().copied().fold(f64::MAX, f64::min);
    let one = singular(word(tokens, at - 1));
    let usual = scenelang_lang::nouns::ending(&one).map_or(0.6, |noun| noun.size[0].max(noun.size[2]));
    SURFACES.contains(&one.as_str()) || room_here(&tokens[at - 1..at]).is_some() || usual * TOO_LARGE > least
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;

    #[test]
    fn sizes_are_those_of_the_room() {
        for (text, becomes) in [
            (
                "a ward for testing a robot, 9.0 m x 7.2 m, ceiling 2.8 m.",
                "a ward , 9.0 m x 7.2 m , for testing a robot , ceiling 2.8 m .",
            ),
            ("a pub, low beams, maybe 7 by 5 metres.", "a pub , about 7 by 5 metres , low beams ."),
            (
                "a library a robot drives in. Maybe 15 by 12 metres, five shelves.",
                "a library , about 15 by 12 metres , a robot drives in . , five shelves .",
            ),
            ("a study, 3 by 4 m, a rug, 2 by 3 m", "a study , 3 by 4 m , a rug , 2 by 3 m"),
            ("a hall with a rug, 2 by 3 m", "a hall with a rug , 2 by 3 m"),
            ("a hall with a stage, 4 by 3 m", "a hall with a stage , 4 by 3 m"),
            ("a bar. The floor is maybe 10 metres by 6.", "a bar . the room is about 10 metres by 6 ."),
            ("a bar. The floor is oak.", "a bar . the floor is oak ."),
            ("inside is 13 m long, 6 m large", "inside is 13 m long , 6 m wide"),
            ("a nail salon, pink, but its only 400 sq ft.", "a nail salon , pink , . the room is 400 sq ft ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            super::plain(&mut tokens);
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(rest.join(" "), becomes, "{text}");
        }
    }
}
