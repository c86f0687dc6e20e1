//! A subject that is taken up again: in "a bed with a pillow and a quilt stands against the wall" the bed stands there, and in
//! "a lamp, a chair and a desk along the wall" all three do.

use super::lexicon::{Verb, get, plural};
use super::noun::{NounKind, noun_phrase};
use super::paraphrase::put;
use super::paraphrase::word;
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    if on_which(tokens, i) || list_stands(tokens, i) || another(tokens, i) || pair(tokens, i) {
        return true;
    }
    let begins = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':'));
    if i > 0 && !begins(&tokens[i - 1]) {
        return false;
    }
    carrier(tokens, i) || fragment(tokens, i)
}

/// "A sofa faces the TV stand, on which a television sits": a television sits on the TV stand.
fn on_which(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 5;
    let which = tokens[i].is(",") && word(tokens, i + 1) == "on" && word(tokens, i + 2) == "which";
    let named = |from: &usize| matches!(word(tokens, *from), "a" | "an" | "the") && thing(tokens, *from) == Some(i);
    let Some(from) = (i.saturating_sub(FAR)..i).find(named).filter(|_| which) else { return false };
    let lies = |end: &usize| matches!(word(tokens, *end), "sits" | "stands" | "lies" | "rests" | "is");
    let Some(end) = thing(tokens, i + 3).filter(lies) else { return false };
    // What the sentence begins with is the subject of the rest, too.
    let starts = from == 0 || !tokens[from - 1].word();
    if starts && tokens.get(end + 1).is_some_and(|t| t.is(",")) {
        return false;
    }
    let carrier: Vec<String> = tokens[from + 1..i].iter().map(|t| t.text.clone()).collect();
    let carrier: Vec<&str> = ["on", "the"].into_iter().chain(carrier.iter().map(String::as_str)).collect();
    let verb = tokens[end].text.clone();
    put(tokens, end, end + 1, &[&[verb.as_str()], &carrier[..]].concat());
    put(tokens, i, i + 3, &["."]);
    tokens[i].kind = WordKind::Sign('.');
    true
}

/// "A table and a plant stand in the corner": no plant stand.
fn list_stands(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 4;
    let related = |i: usize| tokens.get(i..).is_some_and(|rest| !rest.is_empty() && get().relation(rest).is_some());
    if word(tokens, i) != "stand" || i < 3 || !related(i + 1) {
        return false;
    }
    let name = format!("{} stand", word(tokens, i - 1));
    if get().noun(&name).is_none() && scenelang_lang::nouns::noun(&name).is_none() {
        return false;
    }
    let clause = (0..i).rev().take_while(|k| tokens[*k].word() || tokens[*k].is(",")).last().unwrap_or(i);
    let and = (i.saturating_sub(FAR)..i).rev().find(|k| word(tokens, *k) == "and");
    let counted =
        |k: usize| matches!(word(tokens, k), "a" | "an" | "the") || super::number::small(word(tokens, k)).is_some();
    let has_verb = (clause..i).any(|k| tokens[k].is("with") || get().verb(&tokens[k..=k]).is_some());
    if !and.is_some_and(|and| counted(and + 1)) || !counted(clause) || has_verb {
        return false;
    }
    put(tokens, i, i + 1, &["are"]);
    true
}

/// "A third chair": another one.
fn another(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "a" && matches!(word(tokens, i + 1), "second" | "third" | "fourth" | "fifth");
    if !said || thing(tokens, i + 2).is_none() {
        return false;
    }
    put(tokens, i, i + 2, &["another"]);
    true
}

/// Where the noun phrase of a thing ends that begins here.
fn thing(tokens: &[Token], i: usize) -> Option<usize> {
    let rest = tokens.get(i..).filter(|rest| !rest.is_empty())?;
    let is_place = |kind: NounKind| matches!(kind, NounKind::Room | NounKind::Place(_) | NounKind::Pronoun);
    noun_phrase(rest, true).filter(|(np, _)| !is_place(np.kind)).map(|(_, used)| i + used)
}

/// Where a list of things ends that begins here, and whether it has more than one.
fn list(tokens: &[Token], i: usize) -> Option<(usize, usize)> {
    let (mut end, mut n) = (thing(tokens, i)?, 1);
    loop {
        let comma = tokens.get(end).is_some_and(|t| t.is(","));
        let and = usize::from(comma) + usize::from(word(tokens, end + usize::from(comma)) == "and");
        // ", and a lamp" after a single thing begins a clause.
        if and == 2 && n == 1 {
            return Some((end, n));
        }
        match thing(tokens, end + and).filter(|_| and > 0) {
            Some(next) => (end, n) = (next, n + 1),
            None => return Some((end, n)),
        }
    }
}

/// Whether a verb says here where something is.
fn stands(tokens: &[Token], i: usize) -> bool {
    let rest = tokens.get(i..).filter(|rest| rest.first().is_some_and(Token::word));
    rest.and_then(|rest| get().verb(rest)).is_some_and(|(verb, _)| matches!(verb, Verb::Be | Verb::Hang | Verb::Face))
}

/// "A bed with a pillow and a quilt stands by the wall", "a bed, which has a pillow and a quilt, stands by the wall": the bed
/// has them, and the bed stands by the wall.
fn carrier(tokens: &mut Vec<Token>, i: usize) -> bool {
    let article = matches!(word(tokens, i), "a" | "an" | "the");
    let Some(name) = thing(tokens, i).filter(|_| article) else { return false };
    let comma = usize::from(tokens.get(name).is_some_and(|t| t.is(",")));
    let with = name + comma;
    let has =
        matches!(word(tokens, with), "which" | "that") && matches!(word(tokens, with + 1), "has" | "holds" | "carries");
    let on = word(tokens, with) == "on" && word(tokens, with + 1) == "which";
    let first = match () {
        () if word(tokens, with) == "with" => with + 1,
        () if has || on => with + 2,
        () => return false,
    };
    let Some((mut end, n)) = list(tokens, first) else { return false };
    // "On which a lamp and a clock stand": no clock stand.
    let lie = |k: usize| matches!(word(tokens, k), "stand" | "sit" | "lie" | "rest" | "are");
    end -= usize::from(on && lie(end - 1));
    let top = match () {
        () if on && lie(end) => 1,
        () if on => return false,
        () if word(tokens, end) == "on" && word(tokens, end + 1) == "top" => 2,
        () => 0,
    };
    let verb = end + top + usize::from(tokens.get(end + top).is_some_and(|t| t.is(",")));
    if n < 2 || !stands(tokens, verb) {
        return false;
    }
    // Its last words, without the looks: "the bed".
    let Some((np, _)) = noun_phrase(&tokens[i..], true) else { return false };
    let said: Vec<&str> = [".", "the"].into_iter().chain(np.words.iter().map(String::as_str)).collect();
    let verbs = [&said[..], &[word(tokens, verb)]].concat().iter().map(|w| (*w).to_owned()).collect::<Vec<_>>();
    put(tokens, end + top, verb + 1, &verbs.iter().map(String::as_str).collect::<Vec<_>>());
    tokens[end + top].kind = WordKind::Sign('.');
    if on {
        put(tokens, end, end + top, &["on", "top"]);
    }
    if has || on {
        put(tokens, name, first, &["with"]);
    }
    true
}

/// "Boots and orange parkas by the door": both are there.
fn pair(tokens: &mut Vec<Token>, i: usize) -> bool {
    let begins = i == 0 || !tokens[i - 1].word();
    let bare = |k: usize| {
        let looks = tokens.iter().skip(k).take(3).take_while(|t| get().is_look(&t.text)).count();
        super::shares::noun(tokens, k + looks).filter(|name| plural(word(tokens, name.end - 1))).map(|name| name.end)
    };
    let Some(and) = bare(i).filter(|and| begins && word(tokens, *and) == "and") else { return false };
    let Some(end) = bare(and + 1) else { return false };
    let by = matches!(word(tokens, end), "by" | "beside" | "near" | "next");
    if by && matches!(word(tokens, end + 1), "the" | "to") {
        let like = tokens[end - 1].saying("stand");
        tokens.insert(end, like);
        return true;
    }
    false
}

/// "A desk and a chair along the wall": both stand there.
fn fragment(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((end, n)) = list(tokens, i).filter(|(_, n)| *n > 1) else { return false };
    let rest = tokens.get(end..).unwrap_or_default();
    let in_line = ["in", "a", "line"].iter().enumerate().all(|(k, w)| word(tokens, end + k) == *w);
    let along = matches!(word(tokens, end + if in_line { 3 } else { 0 }), "along" | "against");
    let stop = rest.iter().position(|t| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ',')));
    let has_verb =
        rest[..stop.unwrap_or(rest.len())].iter().any(|t| t.word() && get().verb(std::slice::from_ref(t)).is_some());
    if n < 2 || !along || has_verb {
        return false;
    }
    let own = tokens[end - 1].clone();
    tokens.insert(end, Token { kind: WordKind::Word, text: "stand".to_owned(), owner: false, capital: false, ..own });
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn subjects_are_taken_up_again() {
        for (text, becomes) in [
            (
                "a bed with a pillow and a quilt stands against the wall",
                "a bed with a pillow and a quilt . the bed stands against the wall",
            ),
            (
                "a bed, which has a headboard and a quilt, is against the wall",
                "a bed with a headboard and a quilt . the bed is against the wall",
            ),
            (
                "the counter, on which a lamp, a vase and a clock stand, is here",
                "the counter with a lamp , a vase and a clock on top . the counter is here",
            ),
            (
                "a sofa faces the tv stand, on which a television sits.",
                "a sofa faces the tv stand . a television sits on the tv stand .",
            ),
            ("a table and a plant stand in the corner", "a table and a plant are in the corner"),
            ("there is a table and a plant stand in the corner", "there is a table and a plant stand in the corner"),
            ("a third chair stands here", "another chair stands here"),
            ("a desk and a chair along the wall.", "a desk and a chair stand along the wall ."),
            ("a table with four chairs stands here", "a table with four chairs stands here"),
            ("a sofa with a cushion, and a lamp stands here", "a sofa with a cushion , and a lamp stands here"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
