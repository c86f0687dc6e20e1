//! Distances that are denied, and distances of which something else is the subject: "no bench is more than 3 m from the nearest
//! shower" is "every bench is within 3 m of one of the showers", "for each desk there is a lamp on it" is "each desk has …".

use super::lexicon::singular;
use super::measure::measure;
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use scenelang_lang::nouns::plural;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    no_more_than(tokens, i)
        || no_further_than(tokens, i)
        || for_each(tokens, i)
        || within_of_each(tokens, i)
        || clear_space(tokens, i)
        || the_distance(tokens, i)
        || of_any(tokens, i)
        || one_within(tokens, i)
        || listed_after(tokens, i)
}

/// "No X is": where the verb is, after the name of X.
fn no_thing(tokens: &[Token], i: usize) -> Option<(std::ops::Range<usize>, usize)> {
    let name = noun(tokens, i + 1).filter(|_| word(tokens, i) == "no")?;
    let verb = name.end;
    let end = match [word(tokens, verb), word(tokens, verb + 1)] {
        ["may" | "should" | "must" | "can" | "shall", "be" | "stand"] => verb + 2,
        ["is" | "stands" | "sits", _] => verb + 1,
        _ => return None,
    };
    Some((i + 1..name.end, end))
}

/// "No bench is more than 3 m (away) from the nearest shower": every bench is within 3 m of it.
fn no_more_than(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((name, verb)) = no_thing(tokens, i) else { return false };
    let more = matches!(word(tokens, verb), "more" | "further" | "farther") && word(tokens, verb + 1) == "than";
    let Some(used) = length(tokens, verb + 2).filter(|_| more) else { return false };
    let mut from = verb + 2 + used;
    from += usize::from(matches!(word(tokens, from), "away" | "distant" | "apart"));
    if word(tokens, from) != "from" {
        return false;
    }
    let what = of_them(tokens, from + 1, i);
    let size: Vec<Token> = tokens[verb + 2..verb + 2 + used].to_vec();
    let like = size[0].clone();
    let middle = [&[like.saying("within")], &size[..], &[like.saying("of")]].concat();
    every(tokens, i, &name, middle, what, from)
}

/// "No desk is further away from the printer than 3 m": every desk is within 3 m of it.
fn no_further_than(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((name, verb)) = no_thing(tokens, i) else { return false };
    let far = matches!(word(tokens, verb), "further" | "farther");
    if !far && !matches!(word(tokens, verb), "closer" | "nearer") {
        return false;
    }
    let from = verb + 1 + usize::from(word(tokens, verb + 1) == "away");
    if !matches!(word(tokens, from), "from" | "to") {
        return false;
    }
    let Some(than) = (from + 2..from + 7).find(|k| word(tokens, *k) == "than") else { return false };
    let Some(used) = length(tokens, than + 1) else { return false };
    let size: Vec<Token> = tokens[than + 1..than + 1 + used].to_vec();
    tokens.drain(than..than + 1 + used);
    let what = of_them(tokens, from + 1, i);
    let like = size[0].clone();
    let leads: &[&str] = if far { &["within"] } else { &["at", "least"] };
    let mut middle: Vec<Token> = leads.iter().map(|text| like.saying(text)).collect();
    middle.extend(size);
    middle.push(like.saying(if far { "of" } else { "from" }));
    every(tokens, i, &name, middle, what, from)
}

/// Writes "every X is MIDDLE WHAT" in the place of all words up to the end of what was named, or to what follows `from`.
fn every(
    tokens: &mut Vec<Token>,
    i: usize,
    name: &std::ops::Range<usize>,
    middle: Vec<Token>,
    what: Option<(usize, Vec<String>)>,
    from: usize,
) -> bool {
    let like = tokens[i].clone();
    let mut words = vec![like.saying("every")];
    words.extend_from_slice(&tokens[name.clone()]);
    words.push(like.saying("is"));
    words.extend(middle);
    let (end, names) = what.unwrap_or((from + 1, Vec::new()));
    words.extend(names.iter().map(|name| like.saying(name)));
    tokens.splice(i..end, words);
    true
}

/// "The nearest shower", "a shower" where showers are counted before: one of the showers. And where that ends.
fn of_them(tokens: &[Token], at: usize, before: usize) -> Option<(usize, Vec<String>)> {
    let nearest = usize::from(matches!(word(tokens, at + 1), "nearest" | "closest" | "next"));
    let any = nearest == 1 || matches!(word(tokens, at), "a" | "an" | "any" | "some");
    let name = noun(tokens, at + 1 + nearest).filter(|_| any && tokens.get(at).is_some_and(Token::word))?;
    let one: Vec<String> = tokens[name.clone()].iter().map(|t| t.text.clone()).collect();
    let last = one.last()?;
    let many = plural(&singular(last));
    let counted = tokens[..before].iter().any(|t| t.text == many);
    let mut words: Vec<String> =
        if counted { ["one", "of", "the"] } else { ["the", "", ""] }.map(str::to_owned).to_vec();
    words.retain(|word| !word.is_empty());
    words.extend(one[..one.len() - 1].iter().cloned());
    words.push(if counted { many } else { singular(last) });
    Some((name.end, words))
}

/// "For each desk there is a lamp on it", "for every bench, there must be a locker": each desk has a lamp on it.
fn for_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "for" && matches!(word(tokens, i + 1), "each" | "every") && begins(tokens, i);
    let Some(name) = noun(tokens, i + 2).filter(|_| said) else { return false };
    let there = name.end + usize::from(tokens.get(name.end).is_some_and(|t| t.is(",")));
    let end = match [word(tokens, there), word(tokens, there + 1), word(tokens, there + 2)] {
        ["there", "is" | "are", _] => there + 2,
        ["there", "must" | "should" | "shall", "be"] => there + 3,
        _ => return false,
    };
    if !matches!(word(tokens, end), "a" | "an" | "one" | "two" | "three" | "four") {
        return false;
    }
    put(tokens, name.end, end, &["has"]);
    tokens.remove(i);
    true
}

/// "Within 3 m of every bench there is a shower": there is a shower within 3 m of every bench.
fn within_of_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "within" || !begins(tokens, i) {
        return false;
    }
    let Some(used) = length(tokens, i + 1) else { return false };
    let of = i + 1 + used;
    let each = word(tokens, of) == "of" && matches!(word(tokens, of + 1), "each" | "every" | "the");
    let Some(name) = noun(tokens, of + 2).filter(|_| each) else { return false };
    let there = name.end + usize::from(tokens.get(name.end).is_some_and(|t| t.is(",")));
    let thing = match [word(tokens, there), word(tokens, there + 1), word(tokens, there + 2)] {
        ["there", "is", "a" | "an" | "one"] => there + 2,
        ["there", "must" | "should" | "shall", "be"] => there + 3,
        ["stands" | "is" | "hangs", "a" | "an" | "one", _] => there + 1,
        _ => return false,
    };
    let Some(what) = noun(tokens, thing + 1).filter(|what| ends(tokens, what.end)) else { return false };
    let like = tokens[i].clone();
    let mut words = vec![like.saying("there"), like.saying("is")];
    words.extend_from_slice(&tokens[thing..what.end]);
    words.extend_from_slice(&tokens[i..name.end]);
    tokens.splice(i..what.end, words);
    true
}

/// "In front of the safe there must be 1 m of clear space": 1 m must be kept clear in front of the safe.
fn clear_space(tokens: &mut Vec<Token>, i: usize) -> bool {
    let relation = match (word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)) {
        ("behind" | "beside" | "around" | "before", ..) => 1,
        ("in", "front", "of") => 3,
        _ => return false,
    };
    let article = matches!(word(tokens, i + relation), "the" | "every" | "each" | "both" | "all");
    let Some(name) = noun(tokens, i + relation + 1).filter(|_| article && begins(tokens, i)) else { return false };
    let there = name.end + usize::from(tokens.get(name.end).is_some_and(|t| t.is(",")));
    let mut at = match [word(tokens, there), word(tokens, there + 1), word(tokens, there + 2)] {
        ["there", "must" | "should" | "shall", "be"] => there + 3,
        ["there", "is" | "are", _] => there + 2,
        _ => return false,
    };
    let least = at;
    if word(tokens, at) == "at" && word(tokens, at + 1) == "least" {
        at += 2;
    }
    let Some(used) = length(tokens, at) else { return false };
    let mut end = at + used;
    end += usize::from(word(tokens, end) == "of");
    let free = matches!(word(tokens, end), "clear" | "free" | "empty")
        && matches!(word(tokens, end + 1), "space" | "floor" | "room");
    if !free || !ends(tokens, end + 2) {
        return false;
    }
    let like = tokens[i].clone();
    let mut words: Vec<Token> = tokens[least..at + used].to_vec();
    words.extend(["must", "be", "kept", "clear"].map(|text| like.saying(text)));
    words.extend_from_slice(&tokens[i..name.end]);
    tokens.splice(i..end + 2, words);
    true
}

/// "The distance from the printer to every desk is at most 3 m": every desk is within 3 m of the printer.
fn the_distance(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said_so = word(tokens, i) == "the" && word(tokens, i + 1) == "distance" && begins(tokens, i);
    if !said_so || !matches!(word(tokens, i + 2), "from" | "between" | "of") {
        return false;
    }
    let is_det = |k: usize| matches!(word(tokens, k), "the" | "every" | "each" | "a" | "an");
    let Some(first) = noun(tokens, i + 4).filter(|_| is_det(i + 3)) else { return false };
    let to = first.end;
    let Some(second) = noun(tokens, to + 2).filter(|_| is_det(to + 1)) else { return false };
    if !matches!(word(tokens, to), "to" | "and" | "from") {
        return false;
    }
    let verb = second.end;
    let (at, most) = match [word(tokens, verb), word(tokens, verb + 1), word(tokens, verb + 2), word(tokens, verb + 3)]
    {
        ["is", "at", "most", _] | ["is", "no", "more", _] | ["is", "less", "than", _] => (verb + 3, true),
        ["must" | "should" | "shall", "not", "exceed", _] => (verb + 3, true),
        ["must" | "should" | "shall", "be", "at", "most"] => (verb + 4, true),
        ["is", "at", "least", _] => (verb + 3, false),
        ["must" | "should" | "shall", "be", "at", "least"] => (verb + 4, false),
        _ => return false,
    };
    let at = at + usize::from(word(tokens, at) == "than");
    let Some(used) = length(tokens, at).filter(|used| ends(tokens, at + used)) else { return false };
    let each = |k: usize| matches!(word(tokens, k), "every" | "each");
    let (first, second) = (i + 3..first.end, to + 1..second.end);
    let (who, what) = if each(second.start) && !each(first.start) { (second, first) } else { (first, second) };
    let like = tokens[i].clone();
    let mut words: Vec<Token> = tokens[who].to_vec();
    words.push(like.saying("is"));
    words.extend(if most { vec!["within"] } else { vec!["at", "least"] }.into_iter().map(|text| like.saying(text)));
    words.extend_from_slice(&tokens[at..at + used]);
    words.push(like.saying(if most { "of" } else { "from" }));
    words.extend_from_slice(&tokens[what]);
    tokens.splice(i..at + used, words);
    true
}

/// "Every bench is within 3 m of a shower", of three showers: of one of the showers.
fn of_any(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "of" || !matches!(word(tokens, i + 1), "a" | "an" | "some" | "any") {
        return false;
    }
    let from = tokens[..i].iter().rposition(Token::stops).map_or(0, |n| n + 1);
    let each = (from..i).any(|k| matches!(word(tokens, k), "every" | "each"));
    let within = (i.saturating_sub(5)..i).find(|k| word(tokens, *k) == "within");
    let measured = within.is_some_and(|k| length(tokens, k + 1).is_some_and(|used| k + 1 + used == i));
    let Some((end, words)) = of_them(tokens, i + 1, from).filter(|(end, _)| each && measured && ends(tokens, *end))
    else {
        return false;
    };
    // Of one shower, or of a thing that is not there yet, nothing changes.
    if words.first().is_none_or(|first| first != "one") {
        return false;
    }
    put(tokens, i + 1, end, &words.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// "There is a shower within 3 m of every bench", of three showers: every bench is within 3 m of one of the showers.
fn one_within(tokens: &mut Vec<Token>, i: usize) -> bool {
    let there = word(tokens, i) == "there" && begins(tokens, i);
    let article = match [word(tokens, i + 1), word(tokens, i + 2)] {
        ["is", _] => i + 2,
        ["must" | "should", "be"] => i + 3,
        _ => return false,
    };
    let Some((within, words)) = of_them(tokens, article, i).filter(|(end, _)| there && word(tokens, *end) == "within")
    else {
        return false;
    };
    let Some(used) = length(tokens, within + 1) else { return false };
    let of = within + 1 + used;
    let each = word(tokens, of) == "of" && matches!(word(tokens, of + 1), "each" | "every");
    let Some(name) = noun(tokens, of + 2).filter(|name| each && ends(tokens, name.end)) else { return false };
    if words.first().is_none_or(|first| first != "one") {
        return false;
    }
    let like = tokens[i].clone();
    let mut all: Vec<Token> = tokens[of + 1..name.end].to_vec();
    all.push(like.saying("is"));
    all.extend_from_slice(&tokens[within..=of]);
    all.extend(words.iter().map(|text| like.saying(text)));
    tokens.splice(i..name.end, all);
    true
}

/// "A hall with a desk with a lamp on it and a fridge": the list goes on, and the fridge has nothing to do with the desk.
fn listed_after(tokens: &mut [Token], i: usize) -> bool {
    if word(tokens, i) != "with" || !matches!(word(tokens, i + 1), "a" | "an") {
        return false;
    }
    let Some(name) = noun(tokens, i + 2) else { return false };
    let on_it = word(tokens, name.end) == "on" && matches!(word(tokens, name.end + 1), "it" | "top");
    let next = name.end + 2;
    let comma = usize::from(tokens.get(next).is_some_and(|t| t.is(",")));
    let and = usize::from(word(tokens, next + comma) == "and");
    let more = comma + and > 0 && matches!(word(tokens, next + comma + and), "a" | "an" | "two" | "three" | "four");
    let from = tokens[..i].iter().rposition(Token::stops).map_or(0, |n| n + 1);
    let in_list = (from..i).any(|k| matches!(word(tokens, k), "with" | "has" | "contains"));
    if !on_it || !more || !in_list {
        return false;
    }
    tokens[i].kind = WordKind::Sign(',');
    ",".clone_into(&mut tokens[i].text);
    true
}

/// How many tokens a plain length takes that begins here.
fn length(tokens: &[Token], at: usize) -> Option<usize> {
    let (found, used) = measure(tokens.get(at..)?)?;
    (found.values.len() == 1 && !found.area).then_some(used)
}

fn begins(tokens: &[Token], i: usize) -> bool {
    i == 0 || !tokens[i - 1].word() && !tokens[i - 1].is(",")
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_is_denied_is_said_of_each() {
        for (text, becomes) in [
            (
                "six benches, three showers. no bench is more than 3 m from the nearest shower.",
                "six benches , three showers . every bench is within 3 m of one of the showers .",
            ),
            ("no desk is farther than 10 m from the exit.", "every desk is within 10 m of the exit ."),
            ("no desk is further away from the printer than 3 m.", "every desk is within 3 m of the printer ."),
            ("no desk may be closer to the printer than 3 m.", "every desk is at least 3 m from the printer ."),
            ("for each desk there is a lamp on it.", "each desk has a lamp on it ."),
            ("for every bench, there must be a locker.", "every bench has a locker ."),
            ("within 3 m of every bench there is a shower.", "there is a shower within 3 m of every bench ."),
            ("in front of the safe there must be 1 m of clear space.", "1 m must be kept clear in front of the safe ."),
            (
                "the distance from the printer to every desk is at most 3 m.",
                "every desk is within 3 m of the printer .",
            ),
            ("the distance between a lamp and a desk must not exceed 3 m", "a lamp is within 3 m of a desk"),
            (
                "three showers. every bench is within 3 m of a shower.",
                "three showers . every bench is within 3 m of one of the showers .",
            ),
            (
                "three showers. there is a shower within 3 m of every bench.",
                "three showers . every bench is within 3 m of one of the showers .",
            ),
            ("there is a shower within 3 m of every bench.", "there is a shower within 3 m of every bench ."),
            ("every bench is within 3 m of a shower.", "every bench is within 3 m of a shower ."),
            ("a hall with a desk with a lamp on it and a fridge", "a hall with a desk , a lamp on it and a fridge"),
            ("a desk with a lamp on it and a fridge", "a desk with a lamp on it and a fridge"),
            ("in front of the safe there is a chair.", "in front of the safe there is a chair ."),
            ("no chair is red", "no chair is red"),
            ("a tank, which no table may be closer to than 1 m", "a tank , which no table may be closer to than 1 m"),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
