//! What is ruled out, taken back or left out to be understood, in plainer words: "pallets are banned" is "no pallets", "six
//! chairs, I mean four" is "four chairs", "the first shelf … the second" is "the second shelf".

use super::lexicon::{get, singular};
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// Turns what begins at a token, or ends there; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 9] =
        [banned, not_to_be, not_the, not_stored, instead, rather_than, altogether, mended, ordinal];
    turns.iter().any(|turn| turn(tokens, i))
}

/// Where the clause begins that this token is in.
fn begin(tokens: &[Token], i: usize) -> usize {
    tokens[..i].iter().rposition(|t| !t.word() && !matches!(t.kind, WordKind::Number(_))).map_or(0, |k| k + 1)
}

/// The words of a clause up to a verb, if they can be things that nobody has spoken of: "wooden pallets".
fn bare(tokens: &[Token], from: usize, to: usize) -> bool {
    const MOST: usize = 4;
    let said =
        |t: &Token| matches!(t.text.as_str(), "the" | "this" | "that" | "it" | "they" | "no" | "which" | "there");
    (1..=MOST).contains(&(to - from)) && !tokens[from..to].iter().any(said)
}

/// "Pallets are banned", "dogs are not allowed": no pallets, no dogs.
fn banned(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "Ping-pong, absolutely not."
    let firmly = |k: usize| matches!(word(tokens, k), "absolutely" | "definitely" | "certainly" | "please");
    let adverb = i - (1..=i.min(2)).take_while(|n| firmly(i - n)).count();
    if word(tokens, i) == "not" && ends(tokens, i + 1) && adverb < i && adverb > 0 && tokens[adverb - 1].is(",") {
        let from = begin(tokens, adverb - 1);
        let said = bare(tokens, from, adverb - 1);
        if said {
            put(tokens, adverb - 1, i + 1, &[]);
            no(tokens, from);
        }
        return said;
    }
    let is_unneeded = |k: usize| matches!(word(tokens, k), "needed" | "necessary" | "required");
    // "Carpet not needed."
    if word(tokens, i) == "not" && is_unneeded(i + 1) && ends(tokens, i + 2) {
        let from = begin(tokens, i);
        let said = bare(tokens, from, i);
        if said {
            put(tokens, i, i + 2, &[]);
            no(tokens, from);
        }
        return said;
    }
    if !matches!(word(tokens, i), "is" | "are") {
        return false;
    }
    let verb = match word(tokens, i + 1) {
        "banned" | "forbidden" | "prohibited" | "unwanted" => i + 1,
        "not"
            if matches!(word(tokens, i + 2), "allowed" | "permitted" | "wanted" | "welcome") || is_unneeded(i + 2) =>
        {
            i + 2
        }
        _ => return false,
    };
    let from = begin(tokens, i);
    let said = bare(tokens, from, i);
    if said {
        put(tokens, i, verb + 1, &[]);
        no(tokens, from);
    }
    said
}

/// "The sink is not to be next to the fryer": it must not be.
fn not_to_be(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "is" | "are") && word(tokens, i + 1) == "not" && word(tokens, i + 2) == "to";
    if said {
        put(tokens, i, i + 3, &["must", "not"]);
    }
    said
}

/// "Not the beanbags, though.": no beanbags. Within a sentence it may be the other side of something: "facing the door,
/// not the window".
fn not_the(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOST: usize = 4;
    let starts = i
        .checked_sub(1)
        .is_none_or(|k| matches!(tokens[k].kind, WordKind::Line | WordKind::Sign('.' | '!' | '?' | ';')));
    if !starts || word(tokens, i) != "not" || !matches!(word(tokens, i + 1), "the" | "those" | "these") {
        return false;
    }
    let last = |k: &usize| ends(tokens, *k) || matches!(word(tokens, *k), "tho" | "though" | "please" | "again");
    let Some(end) = (i + 2..i + 3 + MOST).find(last) else { return false };
    let thing = end > i + 2 && get().noun(&singular(word(tokens, end - 1))).is_some();
    if thing {
        put(tokens, i, i + 2, &["no"]);
    }
    thing
}

/// "Gas cylinders shall not be stored in the laboratory": no gas cylinders.
fn not_stored(tokens: &mut Vec<Token>, i: usize) -> bool {
    let modal = matches!(word(tokens, i), "shall" | "must" | "may" | "should");
    let kept = matches!(word(tokens, i + 3), "stored" | "kept" | "installed" | "provided" | "present" | "used");
    if !modal || word(tokens, i + 1) != "not" || word(tokens, i + 2) != "be" || !kept {
        return false;
    }
    let end = (i + 4..i + 10).find(|k| ends(tokens, *k)).unwrap_or(i + 10);
    let here = end == i + 4 || matches!(word(tokens, end - 1), "here" | "anywhere");
    let inside = matches!(word(tokens, i + 4), "in" | "inside" | "within");
    let room = inside && (get().room(word(tokens, end - 1)).is_some() || word(tokens, end - 1) == "room");
    let from = begin(tokens, i);
    let said = (here || room) && bare(tokens, from, i);
    if said {
        put(tokens, i, i + 4, &[]);
        no(tokens, from);
    }
    said
}

/// "Instead of a blackboard there is a whiteboard": no blackboard; there is a whiteboard.
fn instead(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOST: usize = 6;
    let begins = word(tokens, i) == "instead" && word(tokens, i + 1) == "of" && begin(tokens, i) == i;
    let article = usize::from(matches!(word(tokens, i + 2), "a" | "an" | "the" | "any"));
    let first = i + 2 + article;
    let goes_on = |k: &usize| {
        let pronoun = matches!(word(tokens, *k), "there" | "we" | "i" | "put" | "place" | "use" | "have");
        pronoun || tokens.get(*k).is_some_and(|t| t.is(","))
    };
    let Some(end) = (first + 1..first + MOST).find(goes_on).filter(|_| begins) else { return false };
    let stop = Token { kind: WordKind::Sign(';'), text: ";".to_owned(), ..tokens[end - 1].clone() };
    if tokens[end].is(",") {
        tokens[end] = stop;
    } else {
        tokens.insert(end, stop);
    }
    put(tokens, i, first, &["no"]);
    true
}

/// "A proper bed rather than a sofa bed and a desk": no sofa bed, and a desk.
fn rather_than(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "rather" && word(tokens, i + 1) == "than";
    let article = usize::from(matches!(word(tokens, i + 2), "a" | "an" | "the" | "any"));
    let first = i + 2 + article;
    let Some(name) = super::shares::noun(tokens, first).filter(|_| said && begin(tokens, i) < i) else { return false };
    if !ends(tokens, name.end) {
        return false;
    }
    let comma = Token { kind: WordKind::Sign(','), text: ",".to_owned(), ..tokens[i].clone() };
    if tokens.get(name.end).is_some_and(|t| t.is("and")) {
        tokens.insert(name.end, comma.clone());
    }
    put(tokens, i, first, &["no"]);
    tokens.insert(i, comma);
    true
}

/// "Fire extinguishers, six altogether", "shelves, three pieces": six, three in number.
fn altogether(tokens: &mut Vec<Token>, i: usize) -> bool {
    let words = match (word(tokens, i), word(tokens, i + 1)) {
        ("altogether", _) => 1,
        ("pieces" | "units" | "pcs", _) if ends(tokens, i + 1) => 1,
        ("in", "all" | "total") if ends(tokens, i + 2) => 2,
        _ => return false,
    };
    let counted = i > 1 && count(&tokens[i - 1..i]).is_some() && tokens[i - 2].is(",");
    if counted {
        put(tokens, i, i + words, &["in", "number"]);
    }
    counted
}

/// "Six chairs, I mean four, …": four chairs.
fn mended(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 7;
    let words = match (word(tokens, i), word(tokens, i + 1)) {
        ("i", "mean") | ("make", "that") | ("or", "rather") | ("no", "sorry") => 2,
        ("sorry", _) => 1,
        _ => return false,
    };
    let comma = usize::from(tokens.get(i + words).is_some_and(|t| t.is(",")));
    let new = i + words + comma;
    let counts = |k: usize| count(&tokens[k..tokens.len().min(k + 1)]).is_some();
    if i < 2 || !tokens[i - 1].is(",") || new >= tokens.len() || !counts(new) || !ends(tokens, new + 1) {
        return false;
    }
    let from = begin(tokens, i - 1).max(i.saturating_sub(FAR));
    let Some(old) = (from..i - 1).find(|k| counts(*k)) else { return false };
    tokens[old] = tokens[new].clone();
    let after = usize::from(tokens.get(new + 1).is_some_and(|t| t.is(",")));
    tokens.drain(i - 1..new + 1 + after);
    true
}

/// "A vase on the first shelf and a clock on the second": on the second shelf.
fn ordinal(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 40;
    const NEXT: [&str; 4] = ["second", "third", "fourth", "last"];
    if word(tokens, i) != "the" || !NEXT.contains(&word(tokens, i + 1)) {
        return false;
    }
    let rest = &tokens[i + 2..];
    const AFTER: [&str; 14] = [
        "is", "stands", "has", "hangs", "faces", "by", "near", "at", "against", "beside", "behind", "under", "next",
        "along",
    ];
    if !ends(tokens, i + 2) && !rest.first().is_some_and(|t| AFTER.contains(&t.text.as_str())) {
        return false;
    }
    let first =
        (i.saturating_sub(FAR)..i).rev().find(|k| word(tokens, *k) == "first" && !word(tokens, *k + 1).is_empty());
    let Some(first) = first else { return false };
    let noun = |n: usize| {
        let phrase: Vec<String> = (first + 1..=first + n).map(|k| singular(word(tokens, k))).collect();
        get().noun(&phrase.join(" ")).is_some()
    };
    let Some(n) = (1..=3).rev().find(|n| noun(*n)) else { return false };
    let words = tokens[first + 1..=first + n].to_vec();
    let at = tokens[i + 1].at.clone();
    tokens.splice(i + 2..i + 2, words.into_iter().map(|t| Token { at: at.clone(), ..t }));
    true
}

/// Puts "no" before a token.
fn no(tokens: &mut Vec<Token>, at: usize) {
    if let Some(first) = tokens.get(at).cloned() {
        tokens.insert(at, Token { kind: WordKind::Word, text: "no".to_owned(), owner: false, capital: false, ..first });
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn what_is_meant_is_said_plainly() {
        for (text, becomes) in [
            ("wooden pallets are banned from here.", "no wooden pallets from here ."),
            ("plants, yes; ping-pong, absolutely not.", "plants , yes ; no ping-pong ."),
            ("carpet not needed. a sofa", "no carpet . a sofa"),
            ("pets are not allowed", "no pets"),
            ("the sink is not to be near the hob", "the sink must not be near the hob"),
            ("a couch. not the beanbags tho", "a couch . no beanbags tho"),
            ("facing the door. not the left wall", "facing the door . not the left wall"),
            ("the lamp is forbidden", "the lamp is forbidden"),
            ("gas bottles shall not be stored inside the kitchen.", "no gas bottles inside the kitchen ."),
            ("cups shall not be stored in the cupboard.", "cups shall not be stored in the cupboard ."),
            ("instead of a sofa there is a bench", "no sofa ; there is a bench"),
            ("a bench instead of a sofa", "a bench instead of a sofa"),
            ("a proper bed rather than a sofa bed and a desk", "a proper bed , no sofa bed , and a desk"),
            ("near the door rather than the window side", "near the door rather than the window side"),
            ("lamps, six altogether, hang", "lamps , six in number , hang"),
            ("shelves along the wall, three pieces.", "shelves along the wall , three in number ."),
            ("a chess board, three pieces on it", "a chess board , three pieces on it"),
            ("six chairs, i mean four, stand", "four chairs stand"),
            (
                "a vase on the first shelf and a clock on the second.",
                "a vase on the first shelf and a clock on the second shelf .",
            ),
            ("on the second floor", "on the second floor"),
        ] {
            let mut tokens = tokens(text, 100).0;
            let mut i = 0;
            while i < tokens.len() {
                plain(&mut tokens, i);
                i += 1;
            }
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
