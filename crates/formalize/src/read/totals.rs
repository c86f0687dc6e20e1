//! The area of all rooms together: "a flat with …, 55 m² in total" is that of the flat, and "total floor area 120 m²" that of the
//! building.

use super::lexicon::get;
use super::measure::measure;
use super::number::area;
use super::paraphrase::word;
use super::several::is_home;
use super::token::{Token, WordKind};
use std::collections::BTreeSet;
use std::ops::Range;

/// What is said of an area that nothing is made of.
const TOTAL: &str = "the total area of a building is ignored; each room has the size that it needs";

/// Says what has such an area; what is left out, by its bytes.
pub fn plain(tokens: &mut Vec<Token>) -> Option<(Range<usize>, String)> {
    let (said, measured) = (0..tokens.len()).find_map(|i| behind(tokens, i).or_else(|| ahead(tokens, i)))?;
    let home = tokens.iter().find(|t| is_home(&t.text)).cloned();
    let building = tokens.iter().any(|t| t.is("building"));
    let measure = tokens[measured].to_vec();
    let like = tokens[said.start].clone();
    let name = match home {
        Some(home) => home.text,
        None if building || rooms(tokens) > 1 => {
            let at = tokens[said.start].at.start..tokens[said.end - 1].at.end;
            tokens.drain(said);
            return Some((at, TOTAL.to_owned()));
        }
        None => "room".to_owned(),
    };
    let mut words = vec![like.saying("the"), like.saying(&name), like.saying("is")];
    words.extend(measure);
    if said.start > 0 && !tokens[said.start - 1].stops() {
        words.insert(0, Token { kind: WordKind::Sign('.'), ..like.saying(".") });
    }
    tokens.splice(said, words);
    None
}

/// How many rooms a text names.
fn rooms(tokens: &[Token]) -> usize {
    let begins =
        |k: &usize| *k == 0 || !tokens[k - 1].word() || ["a", "an", "the", "and"].contains(&word(tokens, k - 1));
    let name = |k: usize| {
        let end = super::numbered::room(tokens, k)?;
        let name: Vec<&str> = (k..end).map(|k| word(tokens, k)).collect();
        // A place in general is no other room.
        (!get().room(&name.join(" ")).is_some_and(|kind| kind.loose)).then(|| name.join(" "))
    };
    let names: BTreeSet<String> = (0..tokens.len()).filter(begins).filter_map(name).collect();
    names.len()
}

/// "Around 55 square metres in total": all of that, and the area.
fn behind(tokens: &[Token], i: usize) -> Option<(Range<usize>, Range<usize>)> {
    let (_, used) = area(tokens.get(i..)?)?;
    let end = i + used;
    let to = match [word(tokens, end), word(tokens, end + 1)] {
        ["in", "total" | "all"] => end + 2,
        ["altogether" | "overall" | "total", _] => end + 1,
        _ => return None,
    };
    let about = i > 0 && matches!(word(tokens, i - 1), "around" | "about" | "roughly" | "approx" | "of");
    let from = i - usize::from(about);
    let from = from - usize::from(from > 0 && tokens[from - 1].is(","));
    // "A bedroom of 20 m² in total" has one room.
    (tokens.get(to).is_none_or(|t| !t.word())).then_some((from..to, i..end))
}

/// "Total space is about 120 m²".
fn ahead(tokens: &[Token], i: usize) -> Option<(Range<usize>, Range<usize>)> {
    if !matches!(word(tokens, i), "total" | "overall") {
        return None;
    }
    let article = usize::from(i > 0 && matches!(word(tokens, i - 1), "the" | "a"));
    let noun = (i + 1..i + 3).take_while(|k| matches!(word(tokens, *k), "space" | "area" | "floor" | "size")).count();
    let is = |k: &usize| matches!(word(tokens, *k), "is" | "of" | "about" | "around" | "roughly" | "should" | "be");
    let from = i + 1 + noun;
    let measured = from + (from..from + 4).take_while(|k| is(k) || tokens.get(*k).is_some_and(|t| t.is(":"))).count();
    // "Overall 3.6 m x 7 m".
    let sides = || measure(tokens.get(measured..)?).filter(|(m, _)| m.values.len() > 1).map(|(_, used)| used);
    // "Total about 50 m²."
    let alone = i == 0 || !tokens[i - 1].word();
    let of_area = area(tokens.get(measured..)?).map(|(_, used)| used).filter(|_| noun > 0 || alone);
    let used = of_area.or_else(sides)?;
    let from = i - article;
    let from = from - usize::from(from > 0 && tokens[from - 1].is(","));
    Some((from..measured + used, measured..measured + used))
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn areas_of_all_rooms_are_those_of_the_whole() {
        for (text, becomes) in [
            (
                "a flat with a hall and a bedroom, around 55 square metres in total.",
                "a flat with a hall and a bedroom . the flat is 55 square metres .",
            ),
            ("my building, total space is about 120 m². a hall.", "my building . a hall ."),
            ("a study, overall area 12 m². a desk", "a study . the room is 12 m ² . a desk"),
            (
                "a hotel room for a robot. overall 3.6 m x 7 m, a desk",
                "a hotel room for a robot . the room is 3.6 m x 7 m , a desk",
            ),
            (
                "a flat with a hall and a bedroom. total about 50 square metres.",
                "a flat with a hall and a bedroom . the flat is 50 square metres .",
            ),
            ("an exam room and a waiting room, 60 square metres in total.", "an exam room and a waiting room ."),
            ("a total of six chairs", "a total of six chairs"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
