//! Who sees what from where: "a whiteboard that every child can see" and "where you can see the fire from the sofa" become
//! sentences of their own, "the whiteboard is visible from every desk".

use super::finishes::sentence;
use super::lexicon::{Class, get, plural, singular};
use super::paraphrase::word;
use super::token::{Token, WordKind};
use crate::brief::Group;
use std::ops::Range;

/// The most words between what is seen, or from where, and the words that say so.
const NEAR: usize = 9;
const DOORS: [&str; 5] = ["doorway", "entrance", "entry", "hallway", "threshold"];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    if in_list(tokens, i) {
        return true;
    }
    let found = seen_by(tokens, i).or_else(|| seen_at_once(tokens, i)).or_else(|| hidden(tokens, i));
    let Some((said, phrase)) = found else { return false };
    // What is seen if possible is a preference, and nothing else of its sentence.
    let soft = match (word(tokens, phrase.end), word(tokens, phrase.end + 1)) {
        ("if", "possible") => 2,
        ("ideally" | "preferably", _) => 1,
        _ => 0,
    };
    let phrase = phrase.start..phrase.end + soft;
    let end = sentence(tokens, phrase.start).end;
    let at = tokens[phrase.start].at.start..tokens[phrase.end - 1].at.end;
    let new = |kind: WordKind, text: &str| Token {
        kind,
        text: text.to_owned(),
        at: at.clone(),
        owner: false,
        capital: false,
    };
    let mut sentences = Vec::new();
    for one in said {
        sentences.push(new(WordKind::Sign('.'), "."));
        let softly = if soft > 0 { &["ideally"][..] } else { &[] };
        sentences.extend(softly.iter().copied().chain(one.split(' ')).map(|text| new(WordKind::Word, text)));
    }
    tokens.splice(end..end, sentences);
    tokens.drain(phrase);
    true
}

/// Sentences, and the words that they take the place of.
type Found = (Vec<String>, Range<usize>);

/// What everybody is to see is a preference: over the heads of others nobody sees the middle of a board.
const IDEALLY: &str = "ideally ";

/// "A chair, and both beds visible from the door": the beds, in a sentence of their own.
fn in_list(tokens: &mut Vec<Token>, i: usize) -> bool {
    let comma = tokens[i].is(",");
    let lead = match (comma, word(tokens, i + 1)) {
        (true, "and") => 2,
        (true, _) => 1,
        (false, _) if tokens[i].is("and") => 1,
        _ => return false,
    };
    let from = i + lead;
    let article = matches!(word(tokens, from), "both" | "all" | "the" | "every" | "each");
    let visible = (from + 2..from + 5).find(|k| word(tokens, *k) == "visible" && word(tokens, k + 1) == "from");
    let Some(at) = visible.filter(|at| article && noun_group(word(tokens, at - 1)).is_some()) else { return false };
    let many = plural(word(tokens, at - 1)) && !matches!(word(tokens, from), "every" | "each");
    let mut verb = tokens[at].clone();
    verb.text = if many { "are" } else { "is" }.to_owned();
    tokens.insert(at, verb);
    (tokens[i].text, tokens[i].kind) = (".".to_owned(), WordKind::Sign('.'));
    tokens.drain(i + 1..from);
    true
}

/// Whoever sees: how many tokens name them, and whether they are several.
fn viewer(tokens: &[Token], i: usize) -> Option<(usize, bool)> {
    let is_person = |k: usize| get().is(word(tokens, k), Class::Person) || get().is(word(tokens, k), Class::Abstract);
    match word(tokens, i) {
        "everyone" | "everybody" | "anyone" | "anybody" => Some((1, true)),
        "every" | "each" | "all" if is_person(i + 1) => Some((2, true)),
        "all" if word(tokens, i + 1) == "the" && is_person(i + 2) => Some((3, true)),
        "you" | "i" | "we" | "one" | "she" | "he" | "they" => Some((1, false)),
        "the" | "a" | "my" if is_person(i + 1) => Some((2, false)),
        _ => None,
    }
}

/// "Can see", "is able to watch": where it ends.
fn sees(tokens: &[Token], i: usize) -> Option<usize> {
    let sight = |k: usize| match (word(tokens, k), word(tokens, k + 1)) {
        ("see" | "watch" | "view" | "overlook", _) => Some(k + 1),
        ("look", "at") => Some(k + 2),
        _ => None,
    };
    match (word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)) {
        ("can" | "could" | "should" | "must" | "may", ..) => sight(i + 1),
        ("is" | "are", "able", "to") => sight(i + 3),
        _ => None,
    }
}

/// What is named by words from here, with their articles: "both the door and the tables". Where that ends.
fn named(tokens: &[Token], i: usize) -> Option<(Vec<String>, usize)> {
    const WORDS: usize = 3;
    let mut out = Vec::new();
    let mut k = i + usize::from(word(tokens, i) == "both");
    loop {
        if !matches!(word(tokens, k), "the" | "every" | "each" | "all" | "both" | "my") {
            break;
        }
        let is_noun = |end: &usize| noun_group(word(tokens, *end)).is_some();
        // The last word of the name that is a noun: "the dining table".
        let Some(first) = (k + 1..k + 1 + WORDS).find(is_noun) else { break };
        let end = (first..k + 1 + WORDS).take_while(is_noun).last().unwrap_or(first);
        let article = if word(tokens, k) == "my" { "the" } else { word(tokens, k) };
        let name: Vec<&str> = (k + 1..=end).map(|k| word(tokens, k)).collect();
        let last = if DOORS.contains(&word(tokens, end)) { "door" } else { word(tokens, end) };
        out.push(format!(
            "{article} {}{last}",
            name[..name.len() - 1].iter().map(|w| format!("{w} ")).collect::<String>()
        ));
        k = end + 1;
        if word(tokens, k) != "and" || !matches!(word(tokens, k + 1), "the" | "every" | "each" | "all") {
            break;
        }
        k += 1;
    }
    (!out.is_empty()).then(|| {
        let joined = k - usize::from(k > 0 && word(tokens, k - 1) == "and");
        (out, joined)
    })
}

fn noun_group(text: &str) -> Option<Group> {
    if DOORS.contains(&text) {
        return Some(Group::Door);
    }
    get().noun(text).or_else(|| get().noun(&singular(text)))
}

/// The last noun of some groups before a token, in its sentence.
fn noun_before(tokens: &[Token], i: usize, groups: Option<&[Group]>) -> Option<usize> {
    let from = sentence(tokens, i).start.max(i.saturating_sub(NEAR));
    let is_it =
        |k: &usize| noun_group(word(tokens, *k)).is_some_and(|g| groups.is_none_or(|groups| groups.contains(&g)));
    (from..i).rev().find(is_it)
}

/// From where everybody sees: the seats or desks that are named.
fn seats(tokens: &[Token]) -> Option<String> {
    const SEATS: [&str; 5] = ["desks", "seats", "chairs", "tables", "benches"];
    let named = SEATS.iter().find(|seat| tokens.iter().any(|t| t.is(seat)))?;
    Some(format!("every {}", if *named == "seats" { "chair".to_owned() } else { singular(named) }))
}

fn visible(what: &str, from: &str) -> String {
    let last = what.rsplit(' ').next().unwrap_or(what);
    let many = plural(last) && !what.starts_with("every") && !what.starts_with("each");
    format!("{what} {} visible from {from}", if many { "are" } else { "is" })
}

/// "That every child can see", "where you can see the fire and the television from the sofa", "so she can watch the door".
fn seen_by(tokens: &[Token], i: usize) -> Option<Found> {
    let lead = match (word(tokens, i), word(tokens, i + 1)) {
        ("so", "that") | ("such", "that") => 2,
        ("that" | "which" | "where" | "so", _) => 1,
        _ => 0,
    };
    let placed = usize::from(lead > 0 && i > 0 && matches!(word(tokens, i - 1), "placed" | "positioned" | "located"));
    let (used, everybody) = viewer(tokens, i + lead).filter(|_| lead > 0)?;
    let after = sees(tokens, i + lead + used)?;
    let (what, end) = match named(tokens, after) {
        Some((what, end)) if !matches!(word(tokens, i), "that" | "which") => (what, end),
        Some(_) => return None,
        None => {
            // What stands before "that" is seen.
            let noun = noun_before(tokens, i, None).filter(|_| matches!(word(tokens, i), "that" | "which"))?;
            (vec![format!("the {}", word(tokens, noun))], after)
        }
    };
    let (from, end) = match word(tokens, end) {
        "from" => {
            let own = matches!(word(tokens, end + 1), "their" | "his" | "her" | "your");
            match named(tokens, end + 1) {
                Some((from, end)) => (from.into_iter().next()?, end),
                None if own && noun_group(word(tokens, end + 2)).is_some() => {
                    let place = singular(word(tokens, end + 2));
                    (format!("{} {}", if everybody { "every" } else { "the" }, place.replace("seat", "chair")), end + 3)
                }
                None => return None,
            }
        }
        _ if everybody => (seats(tokens)?, end),
        _ => {
            let places = [Group::Table, Group::Seat, Group::Bed];
            let noun = noun_before(tokens, i, Some(&places))?;
            (format!("the {}", word(tokens, noun)), end)
        }
    };
    if tokens.get(end).is_some_and(|t| t.word() && !matches!(word(tokens, end), "and" | "with" | "but")) {
        return None;
    }
    let softly = if everybody { IDEALLY } else { "" };
    let said = what.iter().filter(|what| **what != from).map(|what| format!("{softly}{}", visible(what, &from)));
    Some((said.collect(), i - placed..end))
}

/// "A desk you see as soon as you walk in": visible from the door.
fn seen_at_once(tokens: &[Token], i: usize) -> Option<Found> {
    let lead = usize::from(matches!(word(tokens, i), "that" | "which"));
    let (used, _) = viewer(tokens, i + lead)?;
    let at = i + lead + used;
    let at = if word(tokens, at) == "see" { at + 1 } else { sees(tokens, at)? };
    let at_once = match (word(tokens, at), word(tokens, at + 1), word(tokens, at + 2)) {
        ("as", "soon", "as") => at + 3,
        ("right", "when", _) | ("first", "when", _) => at + 2,
        ("when", ..) => at + 1,
        _ => return None,
    };
    let (who, _) = viewer(tokens, at_once)?;
    let end = match (word(tokens, at_once + who), word(tokens, at_once + who + 1)) {
        ("walk" | "come" | "step", "in" | "inside") => at_once + who + 2,
        ("enter" | "arrive", _) => at_once + who + 1,
        _ => return None,
    };
    let noun = noun_before(tokens, i, None)?;
    Some((vec![visible(&format!("the {}", word(tokens, noun)), "the door")], i..end))
}

/// "A toilet hidden from the door": not visible from it.
fn hidden(tokens: &[Token], i: usize) -> Option<Found> {
    let said = match (word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)) {
        ("hidden" | "concealed", "from", _) => i + 2,
        ("out", "of", "sight") if word(tokens, i + 3) == "of" || word(tokens, i + 3) == "from" => i + 4,
        _ => return None,
    };
    let (from, end) = named(tokens, said)?;
    let verb = usize::from(i > 0 && matches!(word(tokens, i - 1), "is" | "are" | "be"));
    let noun = noun_before(tokens, i - verb, None).filter(|_| verb == 0)?;
    let what = format!("the {}", word(tokens, noun));
    let said = from.iter().map(|from| visible(&what, from).replace(" visible", " not visible")).collect();
    Some((said, i..end))
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase::plainly;

    #[test]
    fn what_is_seen_is_a_sentence_of_its_own() {
        for (text, becomes) in [
            (
                "24 desks, a whiteboard at the front that every child can see, a rug.",
                "24 desks , a whiteboard at the front , a rug . ideally the whiteboard is visible from every desk .",
            ),
            (
                "a living room where you can see the fireplace and the tv from the sofa, warm leather.",
                "a living room , warm leather . the fireplace is visible from the sofa . the tv is visible from the sofa .",
            ),
            (
                "a desk placed so she can watch both the door and the tables.",
                "a desk . the door is visible from the desk . the tables are visible from the desk .",
            ),
            (
                "a reception desk you see as soon as you walk in, a plant.",
                "a reception desk , a plant . the desk is visible from the door .",
            ),
            (
                "a screen which everyone can see from their seat.",
                "a screen . ideally the screen is visible from every chair .",
            ),
            ("a toilet hidden from the door.", "a toilet . the toilet is not visible from the door ."),
            (
                "a toilet hidden from the door if possible, a sink.",
                "a toilet , a sink . ideally the toilet is not visible from the door .",
            ),
            (
                "a curtain, a chair, and both beds visible from the door.",
                "a curtain , a chair . both beds are visible from the door .",
            ),
            ("a bed where i can see the window.", "a bed . the window is visible from the bed ."),
            // Who sees it from where?
            ("a painting that everyone can see.", "a painting that everyone can see ."),
            ("a tv you can see while cooking.", "a tv you can see while cooking ."),
            ("a window where you can see the garden.", "a window where you can see the garden ."),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
