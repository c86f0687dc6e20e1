//! Of how many things something is said, in plainer words: "none of which" are "none of the chairs", "the former" is "the
//! desk", "no table within 1 m of another" are "tables at least 1 m apart".

use super::lexicon::{get, singular};
use super::number::{count, length, unit};
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// So far back a noun is looked for that a word stands for.
const BACK: usize = 60;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 10] =
        [not_one, of_which, the_other, every_other, two_ordinals, latter, from_another, some_of, remaining, or_so];
    turns.iter().any(|turn| turn(tokens, i))
}

/// Whether a word is a noun in the plural that the tables know.
fn several(token: &Token) -> bool {
    let one = singular(&token.text);
    token.word() && !token.owner && one != token.text && get().noun(&one).is_some()
}

/// Whether a clause begins at this token.
fn begins(tokens: &[Token], i: usize) -> bool {
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!' | '?' | ':'));
    i.checked_sub(1).is_none_or(|before| ends(&tokens[before]))
}

/// The whole number that stands at this token alone.
pub(super) fn number(tokens: &[Token], i: usize) -> Option<usize> {
    let (n, used) = count(tokens.get(i..i + 1)?)?;
    (used == 1 && n.fract() == 0.0 && n > 0.0).then_some(n as usize)
}

/// "Not one of the desks": none of the desks.
fn not_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "not" && word(tokens, i + 1) == "one" && word(tokens, i + 2) == "of";
    if said {
        put(tokens, i, i + 2, &["none"]);
    }
    said
}

/// "Six chairs, none of which face the door", "half of them facing it": none of the chairs, half of the chairs.
fn of_which(tokens: &mut Vec<Token>, i: usize) -> bool {
    let which = matches!(word(tokens, i + 2), "which" | "whom");
    let them = matches!(word(tokens, i + 2), "them" | "these" | "those") && ends_phrase(tokens, i + 3);
    let some = matches!(word(tokens, i), "none" | "half");
    if word(tokens, i + 1) != "of" || !(which || them) || !(some || which && number(tokens, i).is_some()) {
        return false;
    }
    let Some(noun) = tokens[i.saturating_sub(BACK)..i].iter().rev().find(|t| several(t)).map(|t| t.text.clone()) else {
        return false;
    };
    put(tokens, i + 2, i + 3, &["the", &noun]);
    if i > 0 && tokens[i - 1].is(",") {
        tokens[i - 1].kind = WordKind::Sign(';');
        tokens[i - 1].text = ";".to_owned();
    }
    true
}

/// Whether a pronoun before this token is no determiner: "those of steel", "them facing".
fn ends_phrase(tokens: &[Token], i: usize) -> bool {
    tokens.get(i).is_none_or(|t| !several(t))
}

/// "Two armchairs, each facing the other": facing each other.
fn the_other(tokens: &mut Vec<Token>, i: usize) -> bool {
    let faces = matches!(word(tokens, i + 1), "faces" | "face" | "facing");
    let said = word(tokens, i) == "each" && faces && word(tokens, i + 2) == "the" && word(tokens, i + 3) == "other";
    if !said || !ends(tokens, i + 4) {
        return false;
    }
    put(
        tokens,
        i,
        i + 4,
        if begins(tokens, i) { &["they", "face", "each", "other"] } else { &["facing", "each", "other"] },
    );
    true
}

/// "Every other table": every second table, where no one table was spoken of that the others are told from.
fn every_other(tokens: &mut Vec<Token>, i: usize) -> bool {
    let noun = word(tokens, i + 2).to_owned();
    if word(tokens, i) != "every" || word(tokens, i + 1) != "other" || get().noun(&noun).is_none() {
        return false;
    }
    let told = |k: usize| {
        word(tokens, k + 1) == noun
            && matches!(word(tokens, k), "one" | "first" | "last" | "second" | "middle" | "this")
    };
    if (i.saturating_sub(BACK)..i).any(told) {
        return false;
    }
    put(tokens, i + 1, i + 2, &["second"]);
    true
}

/// "The first and the third shelf", "the first and third shelves": the first shelf and the third shelf.
fn two_ordinals(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WORDS: [&str; 7] = ["first", "second", "third", "fourth", "fifth", "sixth", "last"];
    let nth = |k: usize| WORDS.contains(&word(tokens, k));
    if word(tokens, i) != "the" || !nth(i + 1) || word(tokens, i + 2) != "and" {
        return false;
    }
    let article = usize::from(word(tokens, i + 3) == "the");
    let second = i + 3 + article;
    let noun = |n: usize| {
        let mut words: Vec<String> = (second + 1..=second + n).map(|k| word(tokens, k).to_owned()).collect();
        let last = words.last_mut()?;
        *last = singular(last);
        get().noun(&words.join(" ")).map(|_| words)
    };
    let Some(words) = (1..=3).rev().find_map(noun).filter(|_| nth(second)) else { return false };
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    put(tokens, second + 1, second + 1 + words.len(), &words);
    if article == 0 {
        put(tokens, i + 2, i + 3, &["and", "the"]);
    }
    let first = tokens[i + 1].text.clone();
    put(tokens, i + 1, i + 2, &[&[first.as_str()], words.as_slice()].concat());
    true
}

/// "A desk and a wardrobe, the latter against the wall": the wardrobe.
fn latter(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NEAR: usize = 5;
    let is_first = match word(tokens, i + 1) {
        "former" => true,
        "latter" => false,
        _ => return false,
    };
    let is_noun = |k: &usize| get().noun(&singular(word(tokens, *k))).is_some();
    if word(tokens, i) != "the" || is_noun(&(i + 2)) {
        return false;
    }
    let pair = |and: &usize| {
        let before = and.checked_sub(1).filter(is_noun)?;
        let after = (and + 1..(and + NEAR).min(i)).find(is_noun)?;
        Some(if is_first { before } else { after })
    };
    let ands = (i.saturating_sub(BACK)..i).rev().filter(|k| word(tokens, *k) == "and");
    let Some(noun) = ands.into_iter().find_map(|and| pair(&and)).map(|k| tokens[k].text.clone()) else { return false };
    put(tokens, i + 1, i + 2, &[&noun]);
    true
}

/// "No table is within 1 m of another", "no two desks are closer than 2 m to each other": the tables at least 1 m apart.
fn from_another(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 8;
    if word(tokens, i) != "no" {
        return false;
    }
    let two = usize::from(word(tokens, i + 1) == "two");
    let limit = |k: &usize| {
        word(tokens, *k) == "within" || matches!(word(tokens, *k), "closer" | "nearer") && word(tokens, k + 1) == "than"
    };
    let Some(first) = (i + 2 + two..i + 2 + two + FAR).find(limit) else { return false };
    let verb = |k: &usize| {
        matches!(
            word(tokens, *k),
            "may" | "should" | "must" | "can" | "shall" | "are" | "is" | "be" | "stands" | "stand"
        )
    };
    let Some(noun_end) = (i + 1 + two..=first).find(|k| *k == first || verb(k)) else { return false };
    let noun = singular(word(tokens, noun_end - 1));
    let from = first + 1 + usize::from(word(tokens, first) != "within");
    let Some(used) = tokens.get(from..).and_then(length).map(|(_, used)| used) else { return false };
    let end = from + used;
    let same = |k: usize| usize::from(singular(word(tokens, k)) == noun);
    let among = match [word(tokens, end), word(tokens, end + 1), word(tokens, end + 2)] {
        ["of" | "to" | "from", "each", "other"] | ["of" | "to" | "from", "one", "another"] => 3,
        ["of" | "to" | "from", "another", _] => 2 + same(end + 2),
        ["of" | "to" | "from", "any", "other"] if same(end + 3) == 1 => 4,
        _ => return false,
    };
    let known = get().noun(&noun).is_some() && noun_end > i + 1 + two;
    if !known || !(noun_end..first).all(|k| verb(&k)) || !ends(tokens, end + among) {
        return false;
    }
    let plural = tokens.iter().find(|t| several(t) && singular(&t.text) == noun).map(|t| t.text.clone());
    let plural = plural.unwrap_or_else(|| format!("{noun}s"));
    let last = tokens[end - 1].text.clone();
    put(tokens, end - 1, end + among, &[&last, "apart"]);
    put(tokens, noun_end - 1, from, &[&plural, "are", "at", "least"]);
    put(tokens, i, i + 1 + two, &["the"]);
    true
}

/// "Five desks. Two desks have a lamp.", "two of the five desks": two of the desks.
fn some_of(tokens: &mut Vec<Token>, i: usize) -> bool {
    const VERBS: [&str; 8] = ["have", "face", "stand", "hold", "carry", "each", "hang", "are"];
    let Some(n) = number(tokens, i) else { return false };
    let counted = |noun: &str, fits: &dyn Fn(usize) -> bool| {
        let so_many = |k: usize| word(tokens, k) == noun && k > 0 && number(tokens, k - 1).is_some_and(fits);
        (i.saturating_sub(BACK)..i).any(so_many)
    };
    if word(tokens, i + 1) == "of" && word(tokens, i + 2) == "the" {
        let Some(all) = number(tokens, i + 3).filter(|all| *all > n) else { return false };
        if !tokens.get(i + 4).is_some_and(several) || !counted(word(tokens, i + 4), &|m| m == all) {
            return false;
        }
        put(tokens, i + 3, i + 4, &[]);
        return true;
    }
    let plural = n > 1 && tokens.get(i + 1).is_some_and(several) && begins(tokens, i);
    if !plural || !VERBS.contains(&word(tokens, i + 2)) || !counted(word(tokens, i + 1), &|m| m > n) {
        return false;
    }
    let own = tokens[i].clone();
    let new = ["of", "the"].map(|text| Token { kind: WordKind::Word, text: text.to_owned(), ..own.clone() });
    tokens.splice(i + 1..i + 1, new);
    true
}

/// "The remaining two", "the rest of the desks", "the others stand": the other two, the other desks, the other ones.
fn remaining(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NEXT: [&str; 14] = [
        "by", "at", "near", "in", "on", "against", "along", "beside", "behind", "under", "face", "stand", "are", "have",
    ];
    if word(tokens, i) != "the" {
        return false;
    }
    let goes_on = NEXT.contains(&word(tokens, i + 2));
    match [word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["remaining", ..] => put(tokens, i + 1, i + 2, &["other"]),
        ["rest", "of", "the"] if tokens.get(i + 4).is_some_and(several) => put(tokens, i + 1, i + 4, &["other"]),
        ["others" | "rest", ..] if goes_on => {
            // As many as are left of those that were told apart last.
            let first = (i.saturating_sub(BACK)..i).rev().find(|k| word(tokens, *k) == "first");
            let noun = first.map(|k| word(tokens, k + 1).to_owned());
            let plural = noun.and_then(|noun| {
                tokens[..i].iter().find(|t| several(t) && singular(&t.text) == noun).map(|t| t.text.clone())
            });
            let Some(plural) = plural else { return false };
            put(tokens, i + 1, i + 2, &["other", &plural]);
        }
        _ => return false,
    }
    true
}

/// "A dozen or so chairs": a dozen chairs.
fn or_so(tokens: &mut Vec<Token>, i: usize) -> bool {
    let counts = i > 0
        && (number(tokens, i - 1).is_some()
            || unit(word(tokens, i - 1)).is_some()
            || matches!(word(tokens, i - 1), "dozen" | "couple"));
    let said = counts && word(tokens, i) == "or" && word(tokens, i + 1) == "so";
    if said {
        put(tokens, i, i + 2, &[]);
    }
    said
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn what_is_said_of_some_is_said_plainly() {
        for (text, becomes) in [
            ("not one of the desks is here", "none of the desks is here"),
            ("six chairs, none of which face it", "six chairs ; none of the chairs face it"),
            ("six chairs, half of them facing it", "six chairs ; half of the chairs facing it"),
            ("a lamp, none of which is lit", "a lamp , none of which is lit"),
            ("two armchairs, each facing the other.", "two armchairs , facing each other ."),
            ("every other table has a lamp", "every second table has a lamp"),
            ("one table is round, every other table is square", "one table is round , every other table is square"),
            ("every other day", "every other day"),
            ("the first and the third shelf", "the first shelf and the third shelf"),
            ("the first and last desks", "the first desk and the last desk"),
            ("a desk and an oak wardrobe, the latter here", "a desk and an oak wardrobe , the wardrobe here"),
            ("a desk and a bed. the former is red", "a desk and a bed . the desk is red"),
            ("four tables. no table is within 1 m of another.", "four tables . the tables are at least 1 m apart ."),
            ("no two tables are closer than 1 m to each other", "the tables are at least 1 m apart"),
            ("no table is within 1 m of the bar", "no table is within 1 m of the bar"),
            ("five desks. two desks have a lamp", "five desks . two of the desks have a lamp"),
            ("five desks. three of the five desks face it", "five desks . three of the desks face it"),
            ("two desks. five desks have a lamp", "two desks . five desks have a lamp"),
            ("three of the five desks face it", "three of the five desks face it"),
            ("the remaining two", "the other two"),
            ("the rest of the desks", "the other desks"),
            (
                "three desks. the first desk is here, the others by it",
                "three desks . the first desk is here , the other desks by it",
            ),
            ("surprise me with the rest", "surprise me with the rest"),
            ("a dozen or so chairs", "a dozen chairs"),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
