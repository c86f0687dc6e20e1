//! Rooms beside others: "two offices connected by a corridor", "a workshop and a separate small storage room".

use super::lexicon::{get, singular};
use super::number;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    by_corridor(tokens, i) || separate(tokens, i) || next_to_it(tokens, i) || outside(tokens, i)
}

/// "Facing the balcony", of a room: facing the door that leads there.
fn outside(tokens: &mut Vec<Token>, i: usize) -> bool {
    const OUTSIDE: [&str; 6] = ["balcony", "terrace", "patio", "garden", "veranda", "backyard"];
    const TO: [&str; 13] = [
        "to",
        "facing",
        "near",
        "by",
        "towards",
        "toward",
        "at",
        "beside",
        "overlooking",
        "opposite",
        "face",
        "faces",
        "before",
    ];
    let said = word(tokens, i) == "the"
        && OUTSIDE.contains(&word(tokens, i + 1))
        && i > 0
        && TO.contains(&word(tokens, i - 1));
    if !said || !ends(tokens, i + 2) && !matches!(word(tokens, i + 2), "without" | "with") {
        return false;
    }
    let name = tokens[i + 1].text.clone();
    let named = |k: usize| tokens[k].text == name && k != i + 1;
    if (0..tokens.len()).any(named) || word(tokens, i - 1) == "to" && leads(tokens, i - 1) {
        return false;
    }
    put(tokens, i + 1, i + 2, &[&name, "door"]);
    true
}

/// "A door to the balcony", but "from the door to the balcony".
fn leads(tokens: &[Token], to: usize) -> bool {
    to > 0 && word(tokens, to - 1) == "door" && !tokens[to.saturating_sub(4)..to].iter().any(|t| t.is("from"))
}

/// "A waiting room and a treatment room next to it, connected by a door": rooms of one house are next to each other and have a door
/// between them.
fn next_to_it(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = |words: &[&str]| words.iter().enumerate().all(|(k, w)| word(tokens, i + k) == *w);
    const BESIDE: [&[&str]; 5] = [
        &["next", "to", "it"],
        &["beside", "it"],
        &["next", "door"],
        &["right", "next", "to", "it"],
        &["adjacent", "to", "it"],
    ];
    let is_room = |n: usize| {
        let words: Vec<&str> = (i.saturating_sub(n)..i).map(|k| word(tokens, k)).collect();
        words.len() == n && get().room(&words.join(" ")).is_some() && get().noun(&words.join(" ")).is_none()
    };
    let Some(n) = BESIDE.iter().find(|words| said(words)).map(|words| words.len()) else { return false };
    let Some(named) = (1..=LONGEST).rev().find(|n| is_room(*n)) else { return false };
    let before = i - named;
    if before < 2
        || !matches!(word(tokens, before - 1), "a" | "an")
        || !(tokens[before - 2].is("and") || tokens[before - 2].is(","))
    {
        return false;
    }
    let comma = i + n + usize::from(tokens.get(i + n).is_some_and(|t| t.is(",")));
    let door = match [word(tokens, comma), word(tokens, comma + 1), word(tokens, comma + 2), word(tokens, comma + 3)] {
        ["connected" | "joined" | "linked", "by" | "with" | "through", "a", "door"] => comma + 4,
        _ => i + n,
    };
    if !ends(tokens, door) {
        return false;
    }
    let at = tokens[i - 1].at.start..tokens[door - 1].at.end;
    tokens[i - 1].at = at;
    tokens.drain(i..door);
    true
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
    let start = tokens[..i].iter().rposition(Token::stops).map_or(0, |end| end + 1);
    if !begins_with_room(tokens, start, i) {
        return false;
    }
    let end = tokens[i..].iter().position(Token::stops).map_or(tokens.len(), |at| i + at);
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
            (
                "a practice with a waiting room and a treatment room next to it, connected by a door.",
                "a practice with a waiting room and a treatment room .",
            ),
            (
                "a station with an office and an interview room next door.",
                "a station with an office and an interview room .",
            ),
            ("a bed and a lamp next to it.", "a bed and a lamp next to it ."),
            ("a sofa facing the balcony.", "a sofa facing the balcony door ."),
            ("from the door to the balcony without a turn", "from the door to the balcony door without a turn"),
            ("a door to the balcony", "a door to the balcony"),
            // No rooms, or no corridor.
            ("two tables connected by a cable.", "two tables connected by a cable ."),
            ("two shelves connected by a corridor.", "two shelves connected by a corridor ."),
            ("a separate table.", "a separate table ."),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
