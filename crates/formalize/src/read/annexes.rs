//! Rooms beside others: "two offices connected by a corridor", "a workshop and a separate small storage room".

use super::lexicon::{get, singular};
use super::number;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    by_corridor(tokens, i) || separate(tokens, i)
}

/// What a room between others is called, and what is said of it that gives no size.
const CORRIDORS: [&str; 5] = ["corridor", "hallway", "hall", "passage", "passageway"];
const KINDS: [&str; 8] = ["straight", "long", "short", "narrow", "common", "shared", "central", "connecting"];
/// Names of rooms have so many words at most.
const LONGEST: usize = 3;

/// "Two offices with a desk each, joined by a corridor at least 2 m wide" becomes "a corridor and two offices with a desk each. The
/// corridor is at least 2 m wide".
fn by_corridor(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "joined" | "connected" | "linked") || !matches!(word(tokens, i + 1), "by" | "with") {
        return false;
    }
    let article = i + 2;
    let name = (article + 1..tokens.len()).find(|k| !KINDS.contains(&word(tokens, *k))).unwrap_or(tokens.len());
    if !matches!(word(tokens, article), "a" | "an" | "one") || !CORRIDORS.contains(&word(tokens, name)) {
        return false;
    }
    let start = tokens[..i].iter().rposition(stops).map_or(0, |end| end + 1);
    if !begins_with_room(tokens, start, i) {
        return false;
    }
    let end = tokens[i..].iter().position(stops).map_or(tokens.len(), |at| i + at);
    let measured = name + 1 < end && !ends(tokens, name + 1) && !matches!(word(tokens, name + 1), "with" | "where");
    let like = tokens[name].clone();
    let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..like.clone() };
    if measured {
        let said = [".", "the", &like.text, "is"].map(|text| match text {
            "." => new(WordKind::Sign('.'), text),
            _ => new(WordKind::Word, text),
        });
        tokens.splice(name + 1..name + 1, said);
    }
    let mut front = tokens[article..=name].to_vec();
    front.push(new(WordKind::Word, "and"));
    let comma = usize::from(i > start && tokens[i - 1].is(","));
    tokens.drain(i - comma..=name);
    tokens.splice(start..start, front);
    true
}

fn stops(token: &Token) -> bool {
    matches!(token.kind, WordKind::Line | WordKind::Sign('.' | '!' | '?' | ';'))
}

/// Whether a sentence begins with several rooms, "two offices", or with one of two, "an office and a lab".
fn begins_with_room(tokens: &[Token], start: usize, end: usize) -> bool {
    let article = matches!(word(tokens, start), "a" | "an");
    let used = number::count(&tokens[start..]).map_or(usize::from(article), |(_, used)| used);
    let from = start + used.max(usize::from(article));
    let is_room = |n: &usize| {
        let words: Vec<&str> = (from..(from + n).min(end)).map(|k| word(tokens, k)).collect();
        words.len() == *n && get().room(&singular(&words.join(" "))).is_some()
    };
    from > start && (1..=LONGEST).any(|n| is_room(&n))
}

/// "A separate small storage room" is a small storage room: each room is separate.
fn separate(tokens: &mut Vec<Token>, i: usize) -> bool {
    let article = matches!(word(tokens, i), "a" | "an" | "one");
    if !article || word(tokens, i + 1) != "separate" {
        return false;
    }
    let from = i + 2 + usize::from(matches!(word(tokens, i + 2), "small" | "large" | "big" | "little" | "tiny"));
    let is_room = |n: &usize| {
        let words: Vec<&str> = (from..from + n).map(|k| word(tokens, k)).collect();
        words[n - 1] == "room" && *n > 1 && get().room(&words.join(" ")).is_some()
    };
    let Some(n) = (2..=LONGEST).find(is_room) else { return false };
    // "For the wood": what is kept there makes nothing of wood.
    let kept = from + n;
    if word(tokens, kept) == "for" && matches!(word(tokens, kept + 1), "the" | "our" | "my") && ends(tokens, kept + 3) {
        let name = word(tokens, kept - 1).to_owned();
        put(tokens, kept - 1, kept + 3, &[&name]);
    }
    let article = word(tokens, i).to_owned();
    put(tokens, i, i + 2, &[&article]);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase::plainly;

    #[test]
    fn rooms_beside_others_are_said_plainly() {
        for (text, becomes) in [
            ("two offices connected by a corridor.", "a corridor and two offices ."),
            (
                "two wards with two beds each, joined by a straight corridor at least 2 m wide.",
                "a straight corridor and two wards with two beds each . the corridor is at least 2 m wide .",
            ),
            (
                "an office and a lab linked by a hallway, with a desk in each",
                "a hallway and an office and a lab , with a desk in each",
            ),
            ("a workshop and a separate small storage room for the wood.", "a workshop and a small storage room ."),
            // No rooms, or no corridor.
            ("two tables connected by a cable.", "two tables connected by a cable ."),
            ("two shelves connected by a corridor.", "two shelves connected by a corridor ."),
            ("a separate table.", "a separate table ."),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
