//! Numbers that are joined to a noun: "a 3-chair barbershop" has three chairs, "a 12-person meeting room" is for twelve people,
//! and so is "a twelve-seat table".

use super::lexicon::{get, plural};
use super::number::small;
use super::paraphrase::word;
use super::token::{Token, WordKind};
use crate::furnish::kinds;

/// Who, or whose place, is counted.
const PEOPLE: [&str; 15] = [
    "person", "people", "man", "seat", "seater", "place", "pupil", "student", "child", "guest", "cover", "player",
    "pax", "patient", "kid",
];
/// The most words between the number and the end of the name that it stands before.
const LONGEST: usize = 4;
/// What is seldom larger.
const MOST: f64 = 200.0;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((n, noun, from)) = counted(tokens, i) else { return false };
    let people = PEOPLE.contains(&noun.as_str());
    if noun == "seat" && sofa(tokens, from) {
        return false;
    }
    let table = people.then(|| table(tokens, from)).flatten();
    let Some(end) = table.or_else(|| room(tokens, from)) else { return false };
    if !people && (get().noun(&noun).is_none() || get().room(&noun).is_some()) {
        return false;
    }
    let like = tokens[i].clone();
    let number = match tokens[i].text.split_once('-').map_or(tokens[i].text.as_str(), |(number, _)| number) {
        number if small(number).is_some() => like.saying(number),
        number => Token { kind: WordKind::Number(n), ..like.saying(number) },
    };
    let said = if people {
        vec![like.saying("for"), number, like.saying("people")]
    } else if tokens.get(end).is_some_and(|t| t.is(",")) {
        // "A 3-chair barbershop, dark green": the shop is green.
        let noun = if n > 1.0 { scenelang_lang::nouns::plural(&noun) } else { noun };
        let stop = tokens[end..].iter().position(Token::stops).map_or(tokens.len(), |k| end + k);
        let dot = Token { kind: WordKind::Sign('.'), ..like.saying(".") };
        let said = [dot, like.saying("there"), like.saying("are"), number, like.saying(&noun)];
        tokens.splice(stop..stop, said);
        tokens.drain(i..from);
        return true;
    } else {
        let noun = if n > 1.0 { scenelang_lang::nouns::plural(&noun) } else { noun };
        let with = word(tokens, end) == "with";
        let mut said = vec![like.saying("with"), number, like.saying(&noun)];
        if with {
            said.push(like.saying("and"));
            tokens.remove(end);
        }
        said
    };
    tokens.splice(end..end, said);
    tokens.drain(i..from);
    true
}

/// "3-chair", "twelve-person", "twelve person": the number, the noun, and where what it is said of begins.
fn counted(tokens: &[Token], i: usize) -> Option<(f64, String, usize)> {
    let token = tokens.get(i)?;
    let number = |text: &str| text.parse().ok().or_else(|| small(text));
    let (n, noun, from) = match token.kind {
        WordKind::Word => match token.text.split_once('-') {
            Some((n, noun)) => (number(n)?, noun.to_owned(), i + 1),
            None => (small(&token.text)?, word(tokens, i + 1).to_owned(), i + 2),
        },
        // "3" and "-chair", "3 chair"
        WordKind::Number(n) => {
            let hyphen = usize::from(tokens.get(i + 1).is_some_and(|t| t.is("-")));
            (n, word(tokens, i + 1 + hyphen).to_owned(), i + 2 + hyphen)
        }
        _ => return None,
    };
    let one_word = !noun.is_empty() && !plural(&noun) && noun.chars().all(char::is_alphabetic);
    (one_word && n >= 1.0 && n.fract() == 0.0 && n <= MOST).then_some((n, noun, from))
}

/// Where the name of a room ends that begins here.
fn room(tokens: &[Token], from: usize) -> Option<usize> {
    let names = |n: &usize| {
        let words: Vec<String> = (from..from + n).map(|k| word(tokens, k).to_owned()).collect();
        let plain =
            words.iter().all(|word| !word.is_empty() && !matches!(word.as_str(), "with" | "and" | "for" | "in"));
        // "Two seating areas" are not for two.
        let part = |word: &str| matches!(word, "area" | "areas" | "space" | "spaces" | "corner" | "zone" | "zones");
        let kind = get().room_ending(&words).is_some_and(|(_, kind)| kind.name != "room");
        let named = !part(&words[n - 1]) && (kind || kinds::named(&words.join(" ")).is_some());
        plain && named && (get().noun(&words[n - 1]).is_none() || kinds::named(&words.join(" ")).is_some())
    };
    (1..=LONGEST).rev().find(names).map(|n| from + n)
}

/// Where the name of a table ends that begins here.
fn table(tokens: &[Token], from: usize) -> Option<usize> {
    let is_table = |k: &usize| matches!(word(tokens, *k), "table" | "tables");
    let between =
        |end: &usize| (from..*end).all(|k| tokens[k].word() && !matches!(word(tokens, k), "with" | "and" | "at"));
    (from..from + LONGEST).find(is_table).filter(between).map(|end| end + 1)
}

fn sofa(tokens: &[Token], from: usize) -> bool {
    (from..from + LONGEST).any(|k| matches!(word(tokens, k), "sofa" | "couch" | "settee" | "loveseat" | "bench"))
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn numbers_that_are_joined_to_a_noun_count_it() {
        for (text, becomes) in [
            ("a 3-chair barbershop, retro", "a barbershop , retro . there are 3 chairs"),
            ("a 3-chair barbershop with a sofa", "a barbershop with 3 chairs and a sofa"),
            ("a 12-person meeting room with a screen", "a meeting room for 12 people with a screen"),
            ("a four-bed ward with a sink", "a ward with four beds and a sink"),
            ("a 40-seat restaurant", "a restaurant for 40 people"),
            ("a 12-seat dining table and a lamp", "a dining table for 12 people and a lamp"),
            ("a three-seat sofa in the living room", "a three-seat sofa in the living room"),
            ("a two-bedroom flat", "a two-bedroom flat"),
            ("two chairs in the kitchen", "two chairs in the kitchen"),
            ("six table lamps", "six table lamps"),
            ("a two-storey house", "a two-storey house"),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
