//! What walls and floors look like, said among the things of a room: "a bedroom with blue walls and a bed" becomes "a bedroom
//! with a bed. The walls are blue".

use super::account::turns;
use super::lexicon::{LookWord, MATERIALS_AND_SHADES, get, singular};
use super::paraphrase::word;
use super::token::{Token, WordKind};
use std::ops::Range;

/// How a finish is treated, which changes neither its colour nor its material.
const TREATED: [&str; 9] = ["exposed", "bare", "polished", "painted", "plain", "raw", "rough", "smooth", "real"];

/// A finish among the things of a list: "and a dark oak floor".
struct Finish {
    /// What comes before it: "with", "has", a comma, "and".
    before: Range<usize>,
    /// The whole phrase.
    phrase: Range<usize>,
    looks: Range<usize>,
    /// The word that it ends with: "walls", "floor", "tiles".
    noun: usize,
}

/// Moves finishes into sentences of their own.
pub fn plain(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        tiled(tokens, i);
        two_colors(tokens, i);
        wall_of(tokens, i);
        match finish(tokens, i).filter(|finish| is_plain(tokens, finish)) {
            Some(finish) => move_out(tokens, &finish),
            None => i += 1,
        }
    }
}

/// "A black and white floor": the language has floors of one colour, and the other is told not to be used.
fn two_colors(tokens: &mut Vec<Token>, i: usize) {
    let color = |k: usize| get().look(word(tokens, k)) == Some(LookWord::Color);
    let floor = matches!(word(tokens, i + 3), "floor" | "tiles" | "tiled" | "tile" | "chequered" | "checkered");
    if color(i) && word(tokens, i + 1) == "and" && color(i + 2) && floor {
        super::paraphrase::put(tokens, i, i + 2, &["two-tone"]);
    }
}

/// "A menu on the brick wall behind the bar": on the wall; the walls are of brick.
fn wall_of(tokens: &mut Vec<Token>, i: usize) {
    const OF: [&str; 6] = ["brick", "stone", "concrete", "wooden", "tiled", "marble"];
    let on = matches!(word(tokens, i), "on" | "against" | "along" | "at") && matches!(word(tokens, i + 1), "the" | "a");
    let treated = usize::from(TREATED.contains(&word(tokens, i + 2)));
    let of = i + 2 + treated;
    if !on || !OF.contains(&word(tokens, of)) || word(tokens, of + 1) != "wall" {
        return;
    }
    let end = sentence(tokens, i).end;
    let like = tokens[of].clone();
    let mut said = vec![Token { kind: WordKind::Sign('.'), ..like.saying(".") }];
    said.extend(["the", "walls", "are"].map(|text| like.saying(text)));
    said.push(like);
    tokens.splice(end..end, said);
    tokens.drain(i + 2..=of);
}

/// "A bath and two sinks, all in pale tiles": with pale tiles.
fn tiled(tokens: &mut Vec<Token>, i: usize) {
    let said = word(tokens, i) == "all" && word(tokens, i + 1) == "in";
    let tiles = (i + 2..i + 5).find(|k| matches!(word(tokens, *k), "tiles" | "tile"));
    if said && tiles.is_some_and(|last| (i + 2..last).all(|k| get().is_look(word(tokens, k)))) {
        super::paraphrase::put(tokens, i, i + 2, &["with"]);
    }
}

/// Whether a sentence speaks of one room at most, says one thing of this surface, and makes no exception.
fn is_plain(tokens: &[Token], finish: &Finish) -> bool {
    let around = sentence(tokens, finish.noun);
    let surface = &tokens[finish.noun].text;
    let is_one = tokens[around.clone()].iter().filter(|t| t.text == *surface).count() == 1;
    is_one && rooms(&tokens[around.clone()]) <= 1 && !around.into_iter().any(|i| turns(tokens, i))
}

fn finish(tokens: &[Token], i: usize) -> Option<Finish> {
    let is_comma = |i: usize| tokens.get(i).is_some_and(|t| t.kind == WordKind::Sign(','));
    let start = match word(tokens, i) {
        "with" | "has" | "have" | "and" => i + 1,
        _ if is_comma(i) && word(tokens, i + 1) == "and" => i + 2,
        _ if is_comma(i) => i + 1,
        // "Rubber floor." "A cellar: stone walls, a cauldron."
        _ if i == 0 || tokens[i - 1].stops() || tokens[i - 1].is(":") => i,
        _ => return None,
    };
    let from = start + usize::from(matches!(word(tokens, start), "a" | "an" | "the"));
    let from = from + usize::from(TREATED.contains(&word(tokens, from)));
    let looks = |from: usize| {
        let is_look = |t: &&Token| {
            let look = get().look(&t.text);
            t.word() && matches!(look, Some(LookWord::Color | LookWord::Shade | LookWord::Material))
        };
        from..from + tokens.iter().skip(from).take_while(is_look).count()
    };
    let is_surface = |i: usize| matches!(word(tokens, i), "walls" | "floor" | "floors" | "flooring" | "floorboards");
    let is_tiled = |i: usize| word(tokens, i) == "tiles";
    let (looks, noun, end) = if is_surface(from) {
        let linked = match (word(tokens, from + 1), word(tokens, from + 2)) {
            ("made", "of") => from + 3,
            ("painted" | "in" | "of", _) => from + 2,
            _ => return None,
        };
        let looks = looks(linked);
        (looks.clone(), from, looks.end)
    } else {
        let looks = looks(from);
        // "White wall tiles"
        let of = usize::from(matches!(word(tokens, looks.end), "wall" | "floor") && is_tiled(looks.end + 1));
        (looks.clone(), looks.end + of, looks.end + of + 1)
    };
    let ends = tokens.get(end).is_none_or(|t| !t.word() || t.is("and") || t.is("with"));
    // "Dark walls" have no colour that one could give them; a dark floor is one of dark wood.
    let is_floor = is_surface(noun) && word(tokens, noun) != "walls";
    let is_look = |t: &Token| {
        let look = get().look(&t.text);
        matches!(look, Some(LookWord::Color | LookWord::Material))
            || MATERIALS_AND_SHADES.contains(&t.text.as_str())
            || is_floor && matches!(t.text.as_str(), "dark" | "light" | "pale")
    };
    let says_how = tokens.get(looks.clone()).is_some_and(|looks| looks.iter().any(is_look));
    let is_finish = says_how && (is_surface(noun) || is_tiled(noun)) && ends;
    // "White walls are required" has a verb.
    let alone = start > i || tokens.get(end).is_none_or(|t| !t.word());
    (is_finish && alone).then_some(Finish { before: i..start, phrase: start..end, looks, noun })
}

/// Whether tiles are on the walls: "wall tiles", and those of which nobody says where they are in a bathroom, or in a room
/// with another floor.
fn are_on_walls(tokens: &[Token], noun: usize) -> bool {
    const TILED: [&str; 4] = ["bathroom", "shower", "toilet", "washroom"];
    match word(tokens, noun - 1) {
        "wall" => true,
        "floor" => false,
        _ => {
            let other = tokens.iter().any(|t| matches!(t.text.as_str(), "floor" | "floors" | "flooring"));
            other || tokens[sentence(tokens, noun)].iter().any(|t| TILED.contains(&t.text.as_str()))
        }
    }
}

/// Takes a finish out of its list, and adds a sentence that says it after the one that it was in.
fn move_out(tokens: &mut Vec<Token>, finish: &Finish) {
    let Finish { before, phrase, looks, noun } = finish;
    let end = sentence(tokens, phrase.start).end;
    let like = tokens[*noun].clone();
    let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..like.clone() };
    let is_tiled = like.is("tiles");
    let on_walls = like.is("walls") || is_tiled && are_on_walls(tokens, *noun);
    let (surface, verb) = if on_walls { ("walls", "are") } else { ("floor", "is") };
    let mut said = vec![new(WordKind::Sign('.'), ".")];
    said.extend(["the", surface, verb].map(|text| new(WordKind::Word, text)));
    // "Exposed brick" is brick.
    let from = looks.start - usize::from(TREATED.contains(&word(tokens, looks.start - 1)));
    said.extend(tokens[looks.clone()].iter().cloned());
    let first = said.len() - looks.len();
    said[first].at.start = tokens[from].at.start;
    if is_tiled {
        said.push(new(WordKind::Word, "tile"));
    }
    tokens.splice(end..end, said);
    let goes_on = |i: usize| tokens.get(i).is_some_and(|t| t.kind == WordKind::Sign(',') || t.is("and"));
    let first = before.is_empty() || matches!(word(tokens, before.start), "with" | "has" | "have");
    let after = (phrase.end..end).take_while(|i| goes_on(*i)).count();
    match first && after > 0 {
        true => drop(tokens.drain(phrase.start..phrase.end + after)),
        false => drop(tokens.drain(before.start..phrase.end)),
    }
}

/// The sentence around a token, without what ends it.
pub(super) fn sentence(tokens: &[Token], i: usize) -> Range<usize> {
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | '!' | '?' | ';'));
    let start = tokens[..i].iter().rposition(ends).map_or(0, |end| end + 1);
    let end = tokens[i..].iter().position(ends).map_or(tokens.len(), |end| i + end);
    start..end
}

/// How many rooms a sentence names.
fn rooms(sentence: &[Token]) -> usize {
    let is_room = |t: &&Token| t.word() && get().room(&singular(&t.text)).is_some();
    sentence.iter().filter(is_room).count()
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn finishes_are_said_of_the_room() {
        for (text, becomes) in [
            ("a bedroom with blue walls.", "a bedroom . the walls are blue ."),
            (
                "a bar with a menu on the brick wall behind it. a stool",
                "a bar with a menu on the wall behind it . the walls are brick . a stool",
            ),
            ("a bedroom with blue walls and a bed", "a bedroom with a bed . the walls are blue"),
            (
                "a bedroom with a bed, light blue walls and a dark oak floor. a desk.",
                "a bedroom with a bed . the floor is dark oak . the walls are light blue . a desk .",
            ),
            ("the office has a desk and concrete floors.", "the office has a desk . the floor is concrete ."),
            ("a kitchen with walls painted green, and a table", "a kitchen with a table . the walls are green"),
            ("a loft with exposed brick walls.", "a loft . the walls are brick ."),
            (
                "a kitchen with white tiles, a dark floor and a table.",
                "a kitchen with a table . the floor is dark . the walls are white tile .",
            ),
            ("a kitchen with grey tiles and a table.", "a kitchen with a table . the floor is grey tile ."),
            ("a bathroom with blue wall tiles and a bath.", "a bathroom with a bath . the walls are blue tile ."),
            ("a bathroom with a toilet and white tiles.", "a bathroom with a toilet . the walls are white tile ."),
            ("a shop with a pile of white tiles.", "a shop with a pile of white tiles ."),
            // Not of a room, not of all its walls, or of which room?
            ("a picture on the white walls.", "a picture on the white walls ."),
            ("a bedroom with dark walls and a bed.", "a bedroom with dark walls and a bed ."),
            ("a bedroom with white walls and blue walls.", "a bedroom with white walls and blue walls ."),
            ("a bedroom with white walls, except one.", "a bedroom with white walls , except one ."),
            ("a bedroom with a blue wall and a bed.", "a bedroom with a blue wall and a bed ."),
            ("a kitchen with white walls and a bathroom.", "a kitchen with white walls and a bathroom ."),
            ("the walls are white and the floor is oak.", "the walls are white and the floor is oak ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
