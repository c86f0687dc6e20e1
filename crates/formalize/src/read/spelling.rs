//! Other ways to write the same: "a night stand" is a nightstand, "two white chairs and one black" are three chairs, "each of
//! which" after several things is each of them, "there aren't any" are none.

use super::lexicon::{Class, get, singular};
use super::number;
use super::paraphrase::{ends, put, word};
use super::shares::{counted, noun};
use super::token::{Token, WordKind};
use crate::brief::Group;
use scenelang_lang::nouns::plural;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 13] = [
        hyphened,
        covering,
        on_both,
        joined,
        and_one,
        each_of,
        stacked,
        each_wall,
        not_any,
        has_been,
        which_hangs,
        rows_with,
        circle_of,
    ];
    turns.iter().any(|turn| turn(tokens, i))
}

/// "A walk in shower", "an L shaped sofa": walk-in, L-shaped.
fn hyphened(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WALK_IN: [&str; 7] = ["shower", "closet", "wardrobe", "fridge", "freezer", "pantry", "cupboard"];
    match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["walk", "in", thing] if WALK_IN.contains(&thing) => put(tokens, i, i + 2, &["walk-in"]),
        [letter @ ("l" | "u" | "c" | "t"), "shape" | "shaped", _] => {
            let shape = format!("{letter}-shaped");
            put(tokens, i, i + 2, &[&shape]);
        }
        _ => return false,
    }
    true
}

/// "Bookshelves covering two walls": along two walls.
fn covering(tokens: &mut Vec<Token>, i: usize) -> bool {
    let that = usize::from(matches!(word(tokens, i), "that" | "which"));
    let covers = matches!(word(tokens, i + that), "covering" | "cover" | "lining" | "filling");
    let (first, second) = (word(tokens, i + that + 1), word(tokens, i + that + 2));
    let side = matches!(second, "side" | "long" | "short") && word(tokens, i + that + 3) == "walls";
    let walls = matches!(first, "two" | "three" | "both" | "all" | "one")
        && (side || matches!(second, "walls" | "wall" | "of" | "the"));
    let said = covers && walls && i > 0 && tokens[i - 1].word();
    if said {
        let should =
            usize::from(that == 0 && matches!(word(tokens, i - 1), "should" | "must" | "will" | "shall") && i > 1);
        put(tokens, i - should, i + that + 1, &["along"]);
    }
    said
}

/// "Three paintings on each long wall": three on one of the two and three on the other.
fn on_both(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "Two rails on each wall": at the walls that face each other.
    let plain = matches!(word(tokens, i + 1), "each" | "either") && word(tokens, i + 2) == "wall";
    let said = word(tokens, i) == "on"
        && (plain
            || matches!(word(tokens, i + 1), "each" | "either" | "both")
                && matches!(word(tokens, i + 2), "long" | "short" | "side")
                && matches!(word(tokens, i + 3), "wall" | "walls"));
    let each = word(tokens, i + 1) != "both";
    let Some(all) = counted(tokens, i, 2).filter(|all| said && each && all.noun.end == i) else { return false };
    let of: Vec<Token> = tokens[all.noun.start - 1..all.noun.end].to_vec();
    let side = if plain { "side" } else { word(tokens, i + 2) }.to_owned();
    let like = tokens[i].clone();
    let new = |text: &str| Token { text: text.to_owned(), ..like.clone() };
    let mut words: Vec<Token> = ["on", "one", &side, "wall", "and"].map(new).to_vec();
    words.extend(of);
    words.extend(["on", "the", "opposite", "wall"].map(new));
    tokens.splice(i..i + if plain { 3 } else { 4 }, words);
    true
}

/// "A night stand", "an arm chair": one word, where the two are not a name of their own.
fn joined(tokens: &mut Vec<Token>, i: usize) -> bool {
    let [first, second] = [word(tokens, i), word(tokens, i + 1)];
    if first.len() < 3 || second.len() < 3 {
        return false;
    }
    let last = singular(second);
    let known = |name: &str| scenelang_lang::nouns::noun(name).is_some();
    let one = format!("{first}{last}");
    // "A night stand" is no stand, though a name of two words may be known as well.
    let ends = ["stand", "chair"].contains(&last.as_str());
    let is_one = known(&one) && get().noun(&one).is_some() && (ends || !known(&format!("{first} {last}")));
    // "A desk top lamp": more belongs to the name.
    let goes_on = !word(tokens, i + 2).is_empty() && known(&format!("{last} {}", word(tokens, i + 2)));
    if !is_one || goes_on || get().is(first, Class::Stop) {
        return false;
    }
    let text = format!("{first}{second}");
    put(tokens, i, i + 2, &[&text]);
    true
}

/// "Two white chairs and one black": one black chair.
fn and_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "and" {
        return false;
    }
    let Some((n, used)) = number::count(tokens.get(i + 1..).unwrap_or_default()) else { return false };
    let look = i + 1 + used;
    if n < 1.0
        || !get().is_look(word(tokens, look))
        || get().noun(word(tokens, look)).is_some()
        || !ends(tokens, look + 1)
    {
        return false;
    }
    let Some(all) = counted(tokens, i, 1).filter(|all| all.noun.end == i) else { return false };
    let mut of = tokens[all.noun].to_vec();
    if n == 1.0
        && let Some(last) = of.last_mut()
    {
        last.text = singular(&last.text);
    }
    let at = tokens[look].at.clone();
    of.iter_mut().for_each(|token| token.at = at.clone());
    tokens.splice(look + 1..look + 1, of);
    true
}

/// "A sofa between two tables, each of which has a lamp": each table. "Each of them has two chairs": each of those counted last.
fn each_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    let which = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["each", "of", "which"] => true,
        ["each", "of", "them"] if i == 0 || matches!(tokens[i - 1].kind, WordKind::Sign('.') | WordKind::Line) => false,
        _ => return false,
    };
    let comma = which && i > 0 && tokens[i - 1].is(",");
    if which && !comma {
        return false;
    }
    let Some(all) = counted(tokens, if comma { i - 1 } else { i }, 2) else { return false };
    // What was named last, and not what is before that.
    if comma && all.noun.end != i - 1 {
        return false;
    }
    let mut of: Vec<String> = tokens[all.noun].iter().map(|t| t.text.clone()).collect();
    if let Some(last) = of.last_mut() {
        *last = singular(last);
    }
    let said: Vec<&str> = std::iter::once("each").chain(of.iter().map(String::as_str)).collect();
    put(tokens, i, i + 3, &said);
    if comma {
        tokens[i - 1].text = ".".to_owned();
        tokens[i - 1].kind = WordKind::Sign('.');
    }
    true
}

/// "Two barrels are stacked in the corner": on top of each other.
fn stacked(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i + 1) != "stacked" || !matches!(word(tokens, i), "are" | "stand" | "lie") {
        return false;
    }
    let Some(all) = counted(tokens, i, 2).filter(|all| all.noun.end == i) else { return false };
    let on_each_other = word(tokens, i + 2) == "on" && matches!(word(tokens, i + 3), "top" | "each");
    let end = if on_each_other {
        (i + 3..tokens.len().min(i + 8)).find(|k| word(tokens, *k) == "other")
    } else {
        Some(i + 1)
    };
    let Some(end) = end else { return false };
    let verb: &[&str] = if ends(tokens, end + 1) { &[] } else { &["are"] };
    put(tokens, i, end + 1, &[&["on", "top", "of", "each", "other"], verb].concat());
    all.noun.end == i
}

/// Whether a sentence begins at a token.
fn begins(tokens: &[Token], k: usize) -> bool {
    k == 0 || matches!(tokens[k - 1].kind, WordKind::Sign('.' | ';') | WordKind::Line)
}

/// "A picture hangs on each wall", "on each wall hangs a picture": four, one on each of the walls.
fn each_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WALLS: [&str; 4] = ["left", "right", "back", "front"];
    const NTH: [&str; 4] = ["first", "second", "third", "fourth"];
    let each = |k: usize| matches!(word(tokens, k), "each" | "every") && word(tokens, k + 1) == "wall";
    // "Each wall has a picture".
    if begins(tokens, i) && each(i) && word(tokens, i + 2) == "has" && matches!(word(tokens, i + 3), "a" | "an" | "one")
    {
        put(tokens, i, i + 3, &["on", "each", "wall", "hangs"]);
    }
    let said =
        word(tokens, i) == "on" && matches!(word(tokens, i + 1), "each" | "every") && word(tokens, i + 2) == "wall";
    if !said || i > 0 && tokens[i - 1].is(",") {
        return false;
    }
    let starts = |k: usize| begins(tokens, k);
    let hangs = |k: usize| matches!(word(tokens, k), "hangs" | "is" | "hung" | "mounted");
    let article = |k: usize| matches!(word(tokens, k), "a" | "an" | "one");
    let named = |from: usize| noun(tokens, from + 1).map(|name| (from + 1, name));
    // Where the sentence begins and ends, and what it is about.
    let (from, to, (look, name)) = if starts(i) {
        let at = i + 3 + usize::from(word(tokens, i + 3) == "there");
        let Some(thing) = Some(at).filter(|at| hangs(*at) && article(at + 1)).and_then(|at| named(at + 1)) else {
            return false;
        };
        (i, thing.1.end, thing)
    } else {
        let begin = (0..i).rev().find(|k| starts(*k)).unwrap_or(0);
        let begin = begin + if word(tokens, begin) == "there" { 2 } else { 0 };
        let Some(thing) = Some(begin).filter(|at| article(*at)).and_then(named) else { return false };
        let mut verbs = thing.1.end..i;
        if verbs.len() > 2 || !verbs.all(hangs) {
            return false;
        }
        (begin, i + 3, thing)
    };
    if !ends(tokens, to) || word(tokens, to) == "and" {
        return false;
    }
    let thing: Vec<String> = tokens[name.clone()].iter().map(|t| t.text.clone()).collect();
    let looks: Vec<String> = tokens[look..name.start].iter().map(|t| t.text.clone()).collect();
    let mut many = thing.clone();
    if let Some(last) = many.last_mut() {
        *last = plural(last);
    }
    let mut words: Vec<String> = [vec!["four".to_owned()], looks, many].concat();
    // Windows are in the walls anyway.
    let opening = matches!(get().noun(&thing.join(" ")), Some(Group::Window | Group::Door));
    if !opening {
        words.extend(["hang", "on", "the", "walls"].map(str::to_owned));
    }
    for (nth, wall) in NTH.iter().zip(WALLS) {
        words.extend([".", "the", nth].map(str::to_owned));
        words.extend(thing.iter().cloned());
        words.extend([if opening { "is" } else { "hangs" }, "on", "the", wall, "wall"].map(str::to_owned));
    }
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    put(tokens, from, to, &words);
    for token in tokens[from..].iter_mut().take(words.len()).filter(|token| token.text == ".") {
        token.kind = WordKind::Sign('.');
    }
    true
}

/// "There aren't any windows": there are no windows.
fn not_any(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "not" {
        return false;
    }
    let verb = i > 0 && matches!(word(tokens, i - 1), "is" | "are" | "was" | "were" | "has" | "have");
    let (to, words): (usize, &[&str]) = match [word(tokens, i + 1), word(tokens, i + 2)] {
        ["any", _] if verb => (i + 2, &["no"]),
        ["any", _] => (i + 2, &["is", "no"]),
        ["have" | "need" | "contain", "any"] => (i + 3, &["has", "no"]),
        _ => return false,
    };
    put(tokens, i, to, words);
    true
}

/// "A chair has been placed next to the desk": is placed.
fn has_been(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "has" | "have" | "had") && word(tokens, i + 1) == "been";
    if said {
        let be = if word(tokens, i) == "have" { "are" } else { "is" };
        put(tokens, i, i + 2, &[be]);
    }
    said
}

/// "The TV, which hangs on the wall": which is on the wall.
fn which_hangs(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "which" | "that")
        && matches!(word(tokens, i + 1), "hangs" | "stands" | "sits" | "lies" | "rests")
        && matches!(word(tokens, i + 2), "on" | "against" | "in" | "at" | "by" | "near" | "next" | "beside");
    if said {
        put(tokens, i + 1, i + 2, &["is"]);
    }
    said
}

/// "A circle of eight chairs": eight chairs in a circle.
fn circle_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said =
        word(tokens, i) == "a" && matches!(word(tokens, i + 1), "circle" | "ring") && word(tokens, i + 2) == "of";
    let Some((n, used)) = tokens.get(i + 3..).and_then(number::count).filter(|_| said) else { return false };
    let Some(name) = noun(tokens, i + 3 + used).filter(|_| n > 2.0) else { return false };
    let copy = tokens[i + 1].clone();
    let words = ["in", "a", "circle"].map(|text| Token { text: text.to_owned(), ..copy.clone() });
    tokens.splice(name.end..name.end, words);
    tokens.drain(i..i + 3);
    true
}

/// "Three rows with four chairs each": three rows of four chairs.
fn rows_with(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "rows" && word(tokens, i + 1) == "with" && i > 0;
    let Some((_, used)) = tokens.get(i + 2..).and_then(number::count).filter(|_| said) else { return false };
    let Some(name) = noun(tokens, i + 2 + used).filter(|name| word(tokens, name.end) == "each") else { return false };
    tokens.remove(name.end);
    put(tokens, i + 1, i + 2, &["of"]);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn other_spellings_become_usual_ones() {
        for (text, becomes) in [
            ("a night stand and two arm chairs", "a nightstand and two armchairs"),
            ("walk in shower, grey L shaped sofa", "walk-in shower , grey l-shaped sofa"),
            ("walk in", "walk in"),
            ("bookshelves covering two walls and a table", "bookshelves along two walls and a table"),
            (
                "three paintings on each long wall.",
                "three paintings on one long wall and three paintings on the opposite wall .",
            ),
            ("a coffee table and a side table", "a coffee table and a side table"),
            ("two white chairs and one black.", "two white chairs and one black chair ."),
            ("two white chairs and one black stool.", "two white chairs and one black stool ."),
            (
                "a sofa between two tables, each of which has a lamp.",
                "a sofa between two tables . each table has a lamp .",
            ),
            ("two tables. each of them has a lamp.", "two tables . each table has a lamp ."),
            ("two barrels are stacked in the corner.", "two barrels on top of each other are in the corner ."),
            ("there aren't any windows.", "there is no windows ."),
            ("there are not any chairs.", "there are no chairs ."),
            ("the room doesn't have any windows.", "the room has no windows ."),
            ("a chair has been placed next to the desk.", "a chair is placed next to the desk ."),
            ("a sofa facing the tv, which hangs on the wall.", "a sofa facing the tv , which is on the wall ."),
            ("a circle of eight white chairs.", "eight white chairs in a circle ."),
            ("a ring of light.", "a ring of light ."),
            ("three rows with four chairs each.", "three rows of four chairs ."),
            ("three boxes are stacked on top of each other.", "three boxes on top of each other ."),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }

    #[test]
    fn each_wall_has_its_own() {
        let becomes = paraphrase::plainly("on each wall hangs a red picture.");
        assert!(
            becomes.starts_with("four red pictures hang on the walls . the first picture hangs on the left wall .")
        );
        let becomes = paraphrase::plainly("a lamp is mounted on every wall.");
        assert!(becomes.starts_with("four lamps hang on the walls . the first lamp hangs"), "{becomes}");
        let becomes = paraphrase::plainly("each wall has a window.");
        assert!(becomes.starts_with("four windows . the first window is on the left wall ."), "{becomes}");
        assert_eq!(paraphrase::plainly("a lamp hangs on the wall."), "a lamp hangs on the wall .");
    }
}
