//! From which room one gets to which: "you get to the bathroom from the living room", "the bathroom is reached through the bedroom",
//! "from the hall you enter the kitchen". Each says that the one leads to the other. A room that is between two others leads to both.

use super::numbered::room;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use std::ops::Range;

/// What says by which room one comes.
const FROM: [&str; 3] = ["from", "through", "via"];
/// What may be said of a way beside that: "can only be reached directly from".
const SOFT: [&str; 9] = ["only", "directly", "just", "also", "can", "could", "should", "must", "be"];

/// Turns what is said so.
pub fn plain(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        let said = gets(tokens, i).or_else(|| is_reached(tokens, i)).or_else(|| from_first(tokens, i));
        // A corridor of which nothing else is said is outside.
        if let Some((at, from, to)) = said.filter(|(at, from, _)| is_spoken_of(tokens, at, from)) {
            leads(tokens, at, &[(from, to)]);
        }
        i += 1;
    }
    between(tokens);
}

/// The name of a room that begins here after its article.
fn named(tokens: &[Token], i: usize) -> Option<Range<usize>> {
    let article = matches!(word(tokens, i), "the" | "a" | "an" | "my" | "our");
    room(tokens, i + 1).filter(|_| article).map(|end| i + 1..end)
}

/// Whether a room is spoken of elsewhere, too.
fn is_spoken_of(tokens: &[Token], at: &Range<usize>, room: &Range<usize>) -> bool {
    let last = word(tokens, room.end - 1);
    (0..tokens.len()).any(|k| !at.contains(&k) && word(tokens, k) == last)
}

fn soft(tokens: &[Token], i: usize) -> usize {
    i + (i..tokens.len()).take_while(|k| SOFT.contains(&word(tokens, *k))).count()
}

/// A way: where it is said, from which room, and to which.
type Way = (Range<usize>, Range<usize>, Range<usize>);

/// "You get to the bathroom from the living room", "you can only enter the bathroom through the bedroom".
fn gets(tokens: &[Token], i: usize) -> Option<Way> {
    if !matches!(word(tokens, i), "you" | "one" | "we" | "people" | "guests" | "patients" | "visitors") {
        return None;
    }
    let verb = soft(tokens, i + 1);
    let to = match word(tokens, verb) {
        "enter" | "reach" | "access" | "enters" | "reaches" => verb + 1,
        "get" | "go" | "come" | "walk" | "step" | "gets" | "goes" => {
            verb + 1 + usize::from(word(tokens, verb + 1) == "to")
        }
        _ => return None,
    };
    let to = named(tokens, to)?;
    let by = soft(tokens, to.end);
    let from = named(tokens, by + 1).filter(|_| FROM.contains(&word(tokens, by)))?;
    ends(tokens, from.end).then_some((i..from.end, from, to))
}

/// "The bathroom is reached from the bedroom", "the office is off the hall".
fn is_reached(tokens: &[Token], i: usize) -> Option<Way> {
    let to = named(tokens, i)?;
    let is = soft(tokens, to.end + usize::from(word(tokens, to.end) == "is"));
    if is == to.end {
        return None;
    }
    let by = match word(tokens, is) {
        "off" => is,
        "reached" | "accessed" | "entered" | "accessible" | "reachable" => soft(tokens, is + 1),
        _ => return None,
    };
    let from = named(tokens, by + 1).filter(|_| word(tokens, by) == "off" || FROM.contains(&word(tokens, by)))?;
    ends(tokens, from.end).then_some((i..from.end, from, to))
}

/// "From the hall you get to the kitchen".
fn from_first(tokens: &[Token], i: usize) -> Option<Way> {
    let from = named(tokens, i + 1).filter(|_| FROM.contains(&word(tokens, i)))?;
    let who = from.end + usize::from(tokens.get(from.end).is_some_and(|t| t.is(",")));
    let verb = soft(tokens, who + 1);
    let is_way = matches!(word(tokens, who), "you" | "one" | "we")
        && matches!(word(tokens, verb), "get" | "go" | "enter" | "reach" | "access" | "come" | "step" | "walk");
    let to = verb + 1 + usize::from(matches!(word(tokens, verb + 1), "to" | "into"));
    let to = named(tokens, to).filter(|_| is_way)?;
    ends(tokens, to.end).then_some((i..to.end, from, to))
}

/// Whether what is said of a way may end before a token.
fn ends(tokens: &[Token], i: usize) -> bool {
    tokens.get(i).is_none_or(|t| !t.word() || matches!(t.text.as_str(), "and" | "only" | "too" | "as"))
}

/// "The exam room has to be in between the other two", "the office is between the hall and the store": doors lead from it to both.
fn between(tokens: &mut Vec<Token>) {
    let said = (0..tokens.len()).find_map(|i| {
        let middle = named(tokens, i)?;
        let is = match [word(tokens, middle.end), word(tokens, middle.end + 1), word(tokens, middle.end + 2)] {
            ["has" | "needs" | "is" | "ought", "to", "be"] => middle.end + 3,
            ["is" | "lies" | "sits" | "goes", ..] => middle.end + 1,
            ["should" | "must" | "will" | "can", "be", _] => middle.end + 2,
            _ => return None,
        };
        let is = is + usize::from(word(tokens, is) == "in");
        (word(tokens, is) == "between").then_some((i, middle, is + 1))
    });
    let Some((i, middle, of)) = said else { return };
    let others = [word(tokens, of), word(tokens, of + 1), word(tokens, of + 2)];
    let (first, second, end) = match others {
        ["the", "other", "two"] | ["the", "two", "other" | "others"] => {
            let end = of + 3 + usize::from(matches!(word(tokens, of + 3), "rooms"));
            let Some([first, second]) = other_two(tokens, i, &middle) else { return };
            (first, second, end)
        }
        _ => {
            let Some(first) = named(tokens, of) else { return };
            let Some(second) = named(tokens, first.end + 1).filter(|_| word(tokens, first.end) == "and") else {
                return;
            };
            let end = second.end;
            (first, second, end)
        }
    };
    if ends(tokens, end) && starts(tokens, i) {
        leads(tokens, i..end, &[(middle.clone(), first), (middle, second)]);
    }
}

/// The two rooms that were named beside one, if there are just two.
fn other_two(tokens: &[Token], until: usize, middle: &Range<usize>) -> Option<[Range<usize>; 2]> {
    let text = |range: &Range<usize>| range.clone().map(|k| word(tokens, k)).collect::<Vec<_>>();
    let is_place = |range: &Range<usize>| {
        let name = text(range).join(" ");
        !super::lexicon::get().room(&name).is_some_and(|kind| kind.loose) && !name.ends_with("clinic")
    };
    let mut others: Vec<Range<usize>> = Vec::new();
    let mut k = 0;
    while k < until {
        let Some(found) = named(tokens, k).filter(is_place) else {
            k += 1;
            continue;
        };
        k = found.end;
        let whole = |other: &Range<usize>| text(other) == text(&found);
        // What has rooms is none of them.
        let has = word(tokens, found.end) == "with" && super::numbered::several(tokens, found.end + 1).is_some();
        if !has && text(&found) != text(middle) && !others.iter().any(whole) {
            others.push(found);
        }
    }
    others.try_into().ok()
}

fn starts(tokens: &[Token], i: usize) -> bool {
    i == 0 || !tokens[i - 1].word() || matches!(word(tokens, i - 1), "and" | "but")
}

/// Says of rooms that each first one leads to the second.
fn leads(tokens: &mut Vec<Token>, at: Range<usize>, ways: &[(Range<usize>, Range<usize>)]) {
    let mut said: Vec<String> = Vec::new();
    let name = |words: &Range<usize>| words.clone().map(|k| tokens[k].text.clone()).collect::<Vec<_>>();
    for (k, (from, to)) in ways.iter().enumerate() {
        let stop = if k > 0 { Some(".".to_owned()) } else { None };
        said.extend(stop);
        said.push("the".to_owned());
        said.extend(name(from));
        said.extend(["leads", "to", "the"].map(str::to_owned));
        said.extend(name(to));
    }
    let words: Vec<&str> = said.iter().map(String::as_str).collect();
    let from = at.start;
    put(tokens, from, at.end, &words);
    for token in tokens[from..from + words.len()].iter_mut().filter(|t| t.is(".")) {
        token.kind = WordKind::Sign('.');
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn one_room_leads_to_another() {
        for (text, becomes) in [
            (
                "a living room. you get to the bathroom from the living room.",
                "a living room . the living room leads to the bathroom .",
            ),
            ("a hall. you can only enter the office through the hall.", "a hall . the hall leads to the office ."),
            (
                "a bedroom. the bathroom is only accessible via the bedroom.",
                "a bedroom . the bedroom leads to the bathroom .",
            ),
            ("a hall. the bathroom can be reached from the hall.", "a hall . the hall leads to the bathroom ."),
            ("a hall. the bathroom is off the hall.", "a hall . the hall leads to the bathroom ."),
            (
                "a waiting room, an exam room and a storage room. the exam room has to be in between the other two.",
                "a waiting room , an exam room and a storage room . the exam room leads to the waiting room . the exam \
                 room leads to the storage room .",
            ),
            (
                "the office is between the kitchen and the hall.",
                "the office leads to the kitchen . the office leads to the hall .",
            ),
            ("you enter the kitchen from the corridor.", "you enter the kitchen from the corridor ."),
            ("the table is between the sofa and the window.", "the table is between the sofa and the window ."),
            ("you get to the bed from the kitchen.", "you get to the bed from the kitchen ."),
            ("you enter the kitchen through a wide door.", "you enter the kitchen through a wide door ."),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
