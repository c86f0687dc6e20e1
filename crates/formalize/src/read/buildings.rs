//! Buildings that are called like a room of theirs: "a nursery with a playroom and a nap room" is a building with these rooms, and
//! so is "an arts centre with a foyer with a counter and a cinema with forty seats".

use super::lexicon::{get, singular};
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// What may be a room, or a building.
const NAMES: [&str; 11] = [
    "nursery",
    "kindergarten",
    "daycare",
    "creche",
    "preschool",
    "library",
    "centre",
    "center",
    "practice",
    "surgery",
    "museum",
];
/// The most words of a room's name, and of what is said of it before the name.
const LONGEST: usize = 3;
const LOOKS: usize = 2;
/// The most words before a building has something.
const HEAD: usize = 7;

/// Calls the first thing of a request a building if the next two are rooms. A toilet among rooms is one as well.
pub fn plain(tokens: &mut Vec<Token>) {
    nth_room(tokens);
    let has = |t: &Token| t.is("with") || t.is("has") || t.is("have");
    let Some(with) = tokens.iter().take(HEAD).take_while(|t| t.word()).position(has).filter(|with| *with > 0) else {
        return;
    };
    let is_article = |t: &Token| matches!(t.text.as_str(), "a" | "an" | "the" | "our" | "my" | "this");
    let at = tokens[..with].iter().rposition(is_article).map_or(0, |article| article + 1);
    let asked = at < with && tokens[at..with - 1].iter().any(|t| get().verb(std::slice::from_ref(t)).is_some());
    // "A dentist's practice" says what its treatment rooms are.
    let name = tokens[at.min(with)..with].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
    let known =
        matches!(word(tokens, with - 1), "practice" | "surgery") && crate::furnish::kinds::named(&name).is_some();
    if known || !NAMES.contains(&word(tokens, with - 1)) || asked || at >= with {
        return;
    }
    if split(tokens, with) {
        put(tokens, at, with + 1, &["building", "with"]);
        return;
    }
    let Some(first) = room(tokens, with + 1) else { return };
    let Some(mut from) = next(tokens, first).filter(|from| room(tokens, *from).is_some()) else { return };
    while let Some(end) = room(tokens, from).or_else(|| toilet(tokens, from)) {
        let is_toilet = room(tokens, from).is_none();
        if is_toilet {
            put(tokens, end - 1, end, &["public", "toilet"]);
        }
        if tokens[from].is("the") {
            tokens[from].text = "a".to_owned();
        }
        let Some(next) = next(tokens, end + usize::from(is_toilet)) else { break };
        from = next;
    }
    put(tokens, at, with + 1, &["building", "with"]);
}

/// Where the next of a list begins, if one ends before this token.
fn next(tokens: &[Token], end: usize) -> Option<usize> {
    let joins = tokens.get(end).is_some_and(|t| t.is(",") || t.is("and"));
    joins.then(|| end + 1 + usize::from(tokens[end].is(",") && word(tokens, end + 1) == "and"))
}

/// "A foyer with a counter, a cinema with forty seats and …": a foyer and a cinema. The foyer has a counter. The cinema has forty seats.
fn split(tokens: &mut Vec<Token>, with: usize) -> bool {
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!'));
    let end = tokens[with..].iter().position(stops).map_or(tokens.len(), |n| with + n);
    let furnished = |from: usize| room(tokens, from).filter(|to| word(tokens, *to) == "with").map(|to| (from, to));
    let mut rooms: Vec<(usize, usize)> = furnished(with + 1).into_iter().collect();
    if rooms.is_empty() {
        return false;
    }
    rooms.extend((with + 2..end).filter_map(|k| next(tokens, k)).filter_map(furnished));
    rooms.dedup();
    if rooms.len() < 2 {
        return false;
    }
    let like = tokens[with].clone();
    let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..like.clone() };
    let mut said = Vec::new();
    for (k, (from, to)) in rooms.iter().enumerate() {
        if k > 0 {
            said.push(new(WordKind::Word, "and"));
        }
        said.extend_from_slice(&tokens[*from..*to]);
    }
    for (k, (from, to)) in rooms.iter().enumerate() {
        let mut until = rooms.get(k + 1).map_or(end, |(next, _)| *next);
        while until > *to && (tokens[until - 1].is("and") || tokens[until - 1].is(",")) {
            until -= 1;
        }
        let named = named(tokens, *from).unwrap_or(from + 1);
        said.extend([new(WordKind::Sign('.'), "."), new(WordKind::Word, "the")]);
        said.extend_from_slice(&tokens[named..*to]);
        said.push(new(WordKind::Word, "has"));
        said.extend_from_slice(&tokens[to + 1..until]);
    }
    // What is in another order is all where the whole of it is.
    let whole = tokens[with].at.start..tokens[end - 1].at.end;
    said.iter_mut().for_each(|token| token.at = whole.clone());
    tokens.splice(with + 1..end, said);
    true
}

/// "First gallery has a bench, the second one a statue": the first gallery, and the second gallery has a statue.
fn nth_room(tokens: &mut Vec<Token>) {
    let mut i = 0;
    let mut last: Option<Token> = None;
    while i < tokens.len() {
        let nth = matches!(word(tokens, i), "first" | "second" | "third" | "other");
        let starts = i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';'));
        let is_room = get().room(word(tokens, i + 1)).is_some();
        if nth && is_room {
            last = Some(tokens[i + 1].clone());
            if starts {
                let the = Token { text: "the".to_owned(), ..tokens[i].clone() };
                tokens.insert(i, the);
                i += 1;
            }
        } else if nth
            && word(tokens, i + 1) == "one"
            && i > 1
            && tokens[i - 1].is("the")
            && let Some(room) = &last
        {
            tokens[i + 1].text.clone_from(&room.text);
            let listed = matches!(word(tokens, i + 2), "a" | "an")
                || count(tokens.get(i + 2..i + 3).unwrap_or_default()).is_some();
            if listed {
                let has = Token { text: "has".to_owned(), ..tokens[i + 1].clone() };
                tokens.insert(i + 2, has);
            }
            if tokens[i - 2].is(",") {
                tokens[i - 2].text = ".".to_owned();
                tokens[i - 2].kind = WordKind::Sign('.');
            }
        }
        i += 1;
    }
}

/// Where an article, looks and the name of a room end that begin here.
fn room(tokens: &[Token], i: usize) -> Option<usize> {
    let from = named(tokens, i)?;
    let several = count(tokens.get(i..i + 1)?).is_some_and(|(n, _)| n > 1.0);
    let is_room = |n: &usize| {
        let mut name: Vec<String> = (from..from + n).map(|k| word(tokens, k).to_owned()).collect();
        if let Some(last) = name.last_mut().filter(|_| several) {
            *last = singular(last);
        }
        get().room_ending(&name).is_some()
            && get().noun(&name.join(" ")).is_none()
            && !name.iter().any(|word| word == "with")
    };
    (1..=LONGEST).rev().find(is_room).map(|n| from + n)
}

fn toilet(tokens: &[Token], i: usize) -> Option<usize> {
    let from = named(tokens, i)?;
    let ends = ends(tokens, from + 1) || matches!(word(tokens, from + 1), "for" | "with");
    (word(tokens, from) == "toilet" && ends).then_some(from + 1)
}

fn named(tokens: &[Token], i: usize) -> Option<usize> {
    let counted = count(tokens.get(i..i + 1)?).is_some();
    let article = counted || matches!(word(tokens, i), "a" | "an" | "one" | "the");
    let looks = tokens.get(i + 1..)?.iter().take(LOOKS);
    let looks = looks.take_while(|t| t.kind == WordKind::Word && get().is_look(&t.text)).count();
    article.then_some(i + 1 + looks)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn what_has_rooms_is_a_building() {
        for (text, becomes) in [
            (
                "nursery with a playroom, a nap room and a small toilet for the children.",
                "building with a playroom , a nap room and a small public toilet for the children .",
            ),
            ("a kindergarten with a playroom and a kitchen", "a building with a playroom and a kitchen"),
            (
                "a gp practice with a waiting room and the office next to it.",
                "a building with a waiting room and a office next to it .",
            ),
            (
                "our arts centre has a foyer with a booth and a counter, a small cinema with 5 seats, and a meeting room with a table.",
                "our building with a foyer and a small cinema and a meeting room . the foyer has a booth and a counter . the \
                 cinema has 5 seats . the meeting room has a table .",
            ),
            (
                "a little museum with two galleries and a gift shop. first gallery has a bench, the second one a statue.",
                "a building with two galleries and a gift shop . the first gallery has a bench . the second gallery has a statue .",
            ),
            ("a nursery with a crib and a toilet", "a nursery with a crib and a toilet"),
            ("a library with a reading room", "a library with a reading room"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
