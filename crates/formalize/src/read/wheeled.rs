//! People who come with a wheelchair or a pram: "someone with a pram still needs to get through" asks for paths that are wide
//! enough, and for no pram.

use super::lexicon::{Class, get};
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};

/// As wide as DIN 18040 asks of a passage for wheelchairs, in metres.
const WIDE: f64 = 0.9;
const WHEELED: [&str; 8] = ["wheelchair", "wheelchairs", "pram", "prams", "stroller", "strollers", "buggy", "walker"];
const THROUGH: [&str; 7] = ["through", "past", "around", "everywhere", "in", "by", "along"];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    if room_for(tokens, i) || to_get_through(tokens, i) || as_wide(tokens, i) || uses(tokens, i) {
        return true;
    }
    let starts = i == 0
        || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Sign('.' | ';' | ','))
        || tokens[i - 1].is("so");
    let Some(who) = somebody(tokens, i).filter(|_| starts) else { return false };
    let with = matches!(word(tokens, who), "with" | "in" | "using" | "on" | "pushing");
    let article = who + usize::from(with);
    let wheeled = article + usize::from(matches!(word(tokens, article), "a" | "an" | "their"));
    let goes = if with && WHEELED.contains(&word(tokens, wheeled)) {
        wheeled + 1
    } else if WHEELED.contains(&word(tokens, i)) || WHEELED.contains(&word(tokens, who.saturating_sub(1))) {
        who
    } else {
        return false;
    };
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!'));
    let end = tokens[goes..].iter().position(ends).map_or(tokens.len(), |n| goes + n);
    let must =
        |t: &Token| matches!(t.text.as_str(), "needs" | "need" | "has" | "have" | "should" | "must" | "can" | "could");
    let moves = |t: &Token| matches!(t.text.as_str(), "get" | "pass" | "move" | "come" | "go" | "turn");
    let clause = &tokens[goes..end];
    let Some(verb) = clause.iter().position(moves).filter(|n| clause[..*n].iter().any(must)) else { return false };
    // "Get all the way through".
    let way = 3 * usize::from(clause.get(verb + 3).is_some_and(|t| t.is("way")));
    if !clause[verb + 1 + way..].iter().take(2).any(|t| THROUGH.contains(&t.text.as_str()))
        || clause.len() > verb + way + 5
    {
        return false;
    }
    put(tokens, i, end, &["there", "are", "0.9", "m", "wide", "paths", "to", "everything"]);
    tokens[i + 2].kind = WordKind::Number(WIDE);
    if i > 0 && tokens[i - 1].is("so") {
        tokens[i - 1].text = ".".to_owned();
        tokens[i - 1].kind = WordKind::Sign('.');
    }
    true
}

/// "The robot base is 60 cm wide so keep the floor free": paths as wide as what moves there, which is no thing of the room.
fn as_wide(tokens: &mut Vec<Token>, i: usize) -> bool {
    let robot = usize::from(word(tokens, i + 1) == "mobile");
    let base = usize::from(matches!(word(tokens, i + robot + 2), "base" | "platform"));
    let is = i + robot + 2 + base;
    let moves = matches!(word(tokens, i + robot + 1), "robot" | "robots") || WHEELED.contains(&word(tokens, i + 1));
    let measure = tokens.get(is + 1).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let unit = word(tokens, is + 2).to_owned();
    let said = matches!(word(tokens, i), "the" | "our" | "my") && moves && word(tokens, is) == "is" && measure;
    let who = word(tokens, i + robot + 1);
    let placed = tokens[..i.min(tokens.len())]
        .windows(2)
        .any(|pair| matches!(pair[0].text.as_str(), "a" | "one" | "mobile") && pair[1].text == who);
    if !said || word(tokens, is + 3) != "wide" || placed {
        return false;
    }
    let number = tokens[is + 1].clone();
    let end = is + 4;
    put(tokens, i, end, &["there", "are", "n", &unit, "wide", "paths", "to", "everything"]);
    tokens[i + 2] = number;
    if word(tokens, i + 8) == "so" {
        tokens[i + 8].text = ".".to_owned();
        tokens[i + 8].kind = WordKind::Sign('.');
    }
    true
}

/// "She uses a walker": paths for it.
fn uses(tokens: &mut Vec<Token>, i: usize) -> bool {
    let who = matches!(word(tokens, i), "i" | "she" | "he" | "they") && (i == 0 || !tokens[i - 1].word());
    let said =
        who && matches!(word(tokens, i + 1), "use" | "uses") && matches!(word(tokens, i + 2), "a" | "her" | "his");
    if !said || !WHEELED.contains(&word(tokens, i + 3)) {
        return false;
    }
    put(tokens, i, i + 4, &["there", "are", "0.9", "m", "wide", "paths", "to", "everything"]);
    tokens[i + 2].kind = WordKind::Number(WIDE);
    true
}

/// "With enough space between them for a pram": as much between them as a pram needs.
fn room_for(tokens: &mut Vec<Token>, i: usize) -> bool {
    let enough = usize::from(word(tokens, i) == "enough");
    let space = i + enough;
    let said = matches!(word(tokens, space), "space" | "room") && word(tokens, space + 1) == "between";
    let whom = space + 2 + usize::from(word(tokens, space + 2) == "the");
    let article = whom + 2 + usize::from(matches!(word(tokens, whom + 2), "a" | "two"));
    if !said || word(tokens, whom + 1) != "for" || !WHEELED.contains(&word(tokens, article)) {
        return false;
    }
    let them: Vec<String> = (space + 2..=whom).map(|k| word(tokens, k).to_owned()).collect();
    let words: Vec<&str> = ["0.9", "m", "between"].into_iter().chain(them.iter().map(String::as_str)).collect();
    put(tokens, i, article + 1, &words);
    tokens[i].kind = WordKind::Number(WIDE);
    true
}

/// "Leave enough space to get a pram through to the door": paths for it.
fn to_get_through(tokens: &mut Vec<Token>, i: usize) -> bool {
    let leaves = usize::from(matches!(word(tokens, i), "leave" | "leaving" | "with"));
    let enough = i + leaves + usize::from(word(tokens, i + leaves) == "enough");
    // "Enough room in the middle for a pram to get through".
    let middle = enough + 1 + 3 * usize::from(word(tokens, enough + 1) == "in" && word(tokens, enough + 3) == "middle");
    let whom = middle + 1 + usize::from(matches!(word(tokens, middle + 1), "a" | "the" | "my"));
    let to = whom + 1;
    let for_it = matches!(word(tokens, enough), "space" | "room") && word(tokens, middle) == "for";
    let gets = word(tokens, to) == "to" && matches!(word(tokens, to + 1), "get" | "pass" | "come" | "go" | "move");
    if for_it && WHEELED.contains(&word(tokens, whom)) && gets && THROUGH.contains(&word(tokens, to + 2)) {
        put(tokens, i, to + 3, &["there", "are", "0.9", "m", "wide", "paths", "to", "everything"]);
        tokens[i + 2].kind = WordKind::Number(WIDE);
        return true;
    }
    let space = matches!(word(tokens, enough), "space" | "room") && word(tokens, enough + 1) == "to";
    let moves = matches!(word(tokens, enough + 2), "get" | "push" | "wheel" | "move");
    let article = enough + 3 + usize::from(matches!(word(tokens, enough + 3), "a" | "the" | "my"));
    if !space || !moves || !WHEELED.contains(&word(tokens, article)) || !THROUGH.contains(&word(tokens, article + 1)) {
        return false;
    }
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ',' | '!'));
    let end = tokens[article..].iter().position(ends).map_or(tokens.len(), |n| article + n);
    put(tokens, i, end, &["there", "are", "0.9", "m", "wide", "paths", "to", "everything"]);
    tokens[i + 2].kind = WordKind::Number(WIDE);
    true
}

/// Where the words for a person end that begin here: "someone", "a visitor", "people", "a wheelchair user", "wheelchairs".
fn somebody(tokens: &[Token], i: usize) -> Option<usize> {
    let article = usize::from(matches!(word(tokens, i), "a" | "an" | "the" | "our" | "my"));
    let at = i + article;
    let user = WHEELED.contains(&word(tokens, at));
    if user {
        return Some(at + 1 + usize::from(matches!(word(tokens, at + 1), "user" | "users")));
    }
    let is_person =
        |word: &str| get().is(word, Class::Person) || get().is(&scenelang_lang::nouns::plural(word), Class::Person);
    let named = matches!(word(tokens, at), "someone" | "somebody" | "anyone" | "people" | "person")
        || is_person(word(tokens, at));
    named.then_some(at + 1)
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn who_comes_on_wheels_needs_wide_paths() {
        let paths = "there are 0.9 m wide paths to everything";
        for (said, becomes) in [
            ("a hall. someone with a pram still needs to get through.", format!("a hall . {paths} .")),
            ("a hall. prams have to be able to get all the way through.", format!("a hall . {paths} .")),
            ("she uses a walker, so no rugs", format!("{paths} , so no rugs")),
            ("a shop. people in wheelchairs must be able to get around.", format!("a shop . {paths} .")),
            ("a ward, so a wheelchair can pass through", format!("a ward , . {paths}")),
            (
                "two rows of shelves with enough space between them for a pram.",
                "two rows of shelves with 0.9 m between them .".to_owned(),
            ),
            ("leave enough space to get a pram through to the toilets door", paths.to_owned()),
            ("enough room in the middle for a pram to get through.", format!("{paths} .")),
            (
                "a kitchen. the robot base is 60 cm wide so keep the floor free.",
                "a kitchen . there are 60 cm wide paths to everything . keep the floor free .".to_owned(),
            ),
            (
                "a lab with a robot. the robot is 60 cm wide.",
                "a lab with a robot . the robot is 60 cm wide .".to_owned(),
            ),
            ("the robot", "the robot".to_owned()),
            ("a hall with a pram. the pram stands there.", "a hall with a pram . the pram stands there .".to_owned()),
            ("a visitor with a pram sits there.", "a visitor with a pram sits there .".to_owned()),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
