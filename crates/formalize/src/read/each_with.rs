//! Where the list of what each has ends: in "four stations, each with a mirror and a chair, two basins and a sofa" each station
//! has a mirror and a chair, and the room has the rest.

use super::lexicon::{get, plural, singular};
use super::paraphrase::word;
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;
use crate::read::quantified::number;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "Each bed needs a lamp": it has one.
    let needs = |k: usize| matches!(word(tokens, k), "needs" | "gets" | "requires");
    if word(tokens, i) == "each"
        && let Some(name) = noun(tokens, i + 1).filter(|name| needs(name.end))
    {
        super::paraphrase::put(tokens, name.end, name.end + 1, &["has"]);
        return true;
    }
    if after_each(tokens, i)
        || both_for_each(tokens, i)
        || on_each(tokens, i)
        || with_at_walls(tokens, i)
        || with_several(tokens, i)
        || shared(tokens, i)
    {
        return true;
    }
    if word(tokens, i) != "each" || !matches!(word(tokens, i + 1), "with" | "has" | "have" | "having") {
        return false;
    }
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':' | '!' | '?'));
    let end = tokens[i..].iter().position(stops).map_or(tokens.len(), |n| i + n);
    let Some(comma) = closing(tokens, i + 2, end).or_else(|| placed_after(tokens, i + 2, end)) else { return false };
    let and = usize::from(matches!(word(tokens, comma + 1), "and" | "plus"));
    goes_on(tokens, comma, and);
    true
}

/// "Four wheels, each with a stool, a table, a kiln in the corner": what has a place in the room is there once, and so is what is
/// listed before it after the first.
fn placed_after(tokens: &[Token], from: usize, end: usize) -> Option<usize> {
    let place = |k: &usize| {
        matches!(
            [word(tokens, *k), word(tokens, k + 1), word(tokens, k + 2)],
            ["in", "the", "corner" | "middle" | "centre" | "center"]
                | ["in", "a" | "one", "corner"]
                | ["against" | "along" | "by", "the", _]
        )
    };
    let at = (from..end).find(place)?;
    let mut commas = (from..at).filter(|k| tokens[*k].is(","));
    let first = commas.next()?;
    let and = usize::from(word(tokens, first + 1) == "and");
    // "Each with a bed and a lamp by the wall" says where each of them is.
    item(tokens, first + 1 + and).then_some(first)
}

/// "Two tables with six chairs each and a shelf": the shelf is there once.
fn after_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    let before = (i.saturating_sub(4)..i).any(|k| noun(tokens, k).is_some_and(|noun| noun.end == i));
    // "Four tables with two chairs each along the windows, and a desk".
    let place = |k: &usize| tokens.get(*k).is_some_and(Token::word) && !tokens[*k].is("and");
    let end =
        (i + 1..i + 7).find(|k| !place(k)).filter(|end| *end > i + 2 && tokens.get(*end).is_some_and(|t| t.is(",")));
    let related = get().relation(&tokens[(i + 1).min(tokens.len())..]).is_some();
    if let Some(end) = end.filter(|_| before && related && word(tokens, i) == "each") {
        let and = usize::from(word(tokens, end + 1) == "and");
        let with = (1..=6).any(|n| i.checked_sub(n).is_some_and(|k| tokens[k].is("with")));
        if with && item(tokens, end + 1 + and) {
            goes_on(tokens, end, and);
            return true;
        }
    }
    let comma = tokens.get(i + 1).is_some_and(|t| t.is(","));
    let and = usize::from(word(tokens, i + 1 + usize::from(comma)) == "and");
    let said = before && word(tokens, i) == "each" && (comma || and == 1);
    if !said
        || !item(tokens, i + 1 + usize::from(comma) + and)
        || !(1..=6).any(|n| i.checked_sub(n).is_some_and(|k| tokens[k].is("with")))
    {
        return false;
    }
    if comma {
        goes_on(tokens, i + 1, and);
        return true;
    }
    let own = tokens[i + 1].clone();
    let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..own.clone() };
    tokens.insert(i + 1, new(WordKind::Sign(','), ","));
    true
}

/// "Tables with a candle on each, a bar with stools, and a stand": the bar and the stand are there once. So is what follows "a
/// counter with a till on it".
fn on_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "on" | "at" | "beside" | "above" | "under" | "behind")
        && matches!(word(tokens, i + 1), "each" | "it" | "top" | "them")
        && tokens.get(i + 2).is_some_and(|t| t.is(","));
    let and = usize::from(matches!(word(tokens, i + 3), "and" | "plus"));
    let with = || tokens[..i].iter().rev().take(8).any(|t| t.is("with"));
    if !said || !item(tokens, i + 3 + and) || !with() {
        return false;
    }
    goes_on(tokens, i + 2, and);
    true
}

/// "Three plinths with sculptures, one bench and a desk": the bench and the desk are there once. What stands on each may be listed
/// with it: "six desks with monitors, a lamp and a chair".
fn with_several(tokens: &mut Vec<Token>, i: usize) -> bool {
    let host = i > 0 && word(tokens, i) == "with" && plural(word(tokens, i - 1));
    let several = (i.saturating_sub(5)..i).any(|k| number(tokens, k).is_some_and(|n| n > 1));
    let Some(own) = noun(tokens, i + 1).filter(|own| host && several && plural(word(tokens, own.end - 1))) else {
        return false;
    };
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | ':' | '!' | '?' | ','));
    let Some(comma) = tokens[own.end..].iter().position(stops).map(|n| own.end + n).filter(|k| tokens[*k].is(","))
    else {
        return false;
    };
    let and = usize::from(matches!(word(tokens, comma + 1), "and" | "plus"));
    let joined = tokens[own.end..comma].iter().any(|t| t.is("and") || t.is("each") || t.is("with"));
    let next = comma + 1 + and;
    let stands =
        (1..=3).find_map(|n| noun(tokens, next + n)).is_some_and(|noun| is_furniture(word(tokens, noun.end - 1)));
    if joined || !item(tokens, next) || !stands {
        return false;
    }
    goes_on(tokens, comma, and);
    true
}

/// "Twin beds with one shared nightstand, a desk and a lamp": the nightstand is between the beds, and the room has the rest once.
fn shared(tokens: &mut Vec<Token>, i: usize) -> bool {
    let host = i > 0 && word(tokens, i) == "with" && plural(word(tokens, i - 1));
    if !host || !matches!(word(tokens, i + 1), "a" | "an" | "one") {
        return false;
    }
    let is_shared = matches!(word(tokens, i + 2), "shared" | "common" | "single");
    let Some(own) = noun(tokens, i + 2 + usize::from(is_shared)) else { return false };
    let between = word(tokens, own.end) == "between" && matches!(word(tokens, own.end + 1), "them" | "the");
    if word(tokens, i + 2) == "single" && between || !(is_shared || between) {
        return false;
    }
    let mut end = own.end;
    if between {
        end += if word(tokens, end + 1) == "the" { 3 } else { 2 };
    } else {
        let like = tokens[i + 2].clone();
        tokens.splice(end..end, ["between", "them"].map(|text| like.saying(text)));
        tokens.remove(i + 2);
        end += 1;
    }
    let comma = tokens.get(end).is_some_and(|t| t.is(","));
    let and = usize::from(comma && matches!(word(tokens, end + 1), "and" | "plus"));
    if comma && item(tokens, end + 1 + and) {
        goes_on(tokens, end, and);
        return true;
    }
    is_shared
}

/// Whether a thing stands on the floor by itself, and is no seat that belongs to what was named before.
fn is_furniture(name: &str) -> bool {
    let name = singular(name);
    let seat = ["chair", "stool", "seat"].iter().any(|seat| name.ends_with(seat));
    matches!(get().noun(&name), Some(Group::Seat | Group::Table | Group::Storage | Group::Bed)) && !seat
}

/// "Eight workbenches with vices along the two long walls, a rack": the benches stand there, and the rack is there once.
fn with_at_walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    let host = i > 0 && word(tokens, i) == "with" && plural(word(tokens, i - 1));
    let bare = host && plural(word(tokens, i + 1)) && number(tokens, i + 1).is_none();
    let along = matches!(word(tokens, i + 2), "along" | "against");
    let Some(walls) = (i + 3..i + 8).find(|k| matches!(word(tokens, *k), "wall" | "walls")).filter(|_| bare && along)
    else {
        return false;
    };
    tokens[i..=walls].rotate_left(2);
    if tokens.get(walls + 1).is_some_and(|t| t.is(",")) {
        let and = usize::from(matches!(word(tokens, walls + 2), "and" | "plus"));
        goes_on(tokens, walls + 1, and);
    }
    true
}

/// Ends a list at a comma, after which another begins.
pub(super) fn goes_on(tokens: &mut Vec<Token>, comma: usize, and: usize) {
    let first = word(tokens, comma + 1 + and);
    let bare = noun(tokens, comma + 1 + and).is_some_and(|name| !plural(word(tokens, name.end - 1)));
    let verb = if matches!(first, "a" | "an") || bare { "is" } else { "are" };
    let own = tokens[comma].clone();
    let new = |kind: WordKind, text: &str| Token { kind, text: text.to_owned(), ..own.clone() };
    let words = [new(WordKind::Sign('.'), "."), new(WordKind::Word, "there"), new(WordKind::Word, verb)];
    tokens.splice(comma..=comma + and, words);
}

/// "A cabinet and a chair for each bed": a cabinet for each as well.
fn both_for_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "for" && matches!(word(tokens, i + 1), "each" | "every");
    let Some(whom) = noun(tokens, i + 2).filter(|_| said) else { return false };
    let article = |k: usize| matches!(word(tokens, k), "a" | "an");
    // An article and a noun that ends before this token.
    let before = |end: usize| {
        (end.saturating_sub(6)..end)
            .rev()
            .find(|k| article(*k) && (1..=3).any(|n| noun(tokens, k + n).is_some_and(|name| name.end == end)))
    };
    let Some(second) = before(i) else { return false };
    if second < 3 || word(tokens, second - 1) != "and" {
        return false;
    }
    let end = second - 1 - usize::from(tokens[second - 2].is(","));
    if before(end).is_none() {
        return false;
    }
    let each: Vec<Token> = tokens[i..whom.end].to_vec();
    tokens.splice(end..end, each);
    true
}

/// The comma after the list that begins here, where another list goes on: after its "and", or before an "and" where the list has
/// one item.
fn closing(tokens: &[Token], from: usize, end: usize) -> Option<usize> {
    let mut items = 1;
    let mut closed = false;
    for k in from..end {
        if tokens[k].is("and") && item(tokens, k + 1) && !tokens[k - 1].is(",") {
            closed = true;
        } else if tokens[k].is(",") {
            let plus = word(tokens, k + 1) == "plus";
            let and = usize::from(plus || word(tokens, k + 1) == "and");
            // "Each with a monitor and a chair, printer by the door": notes leave articles out.
            if closed && and == 0 && noun(tokens, k + 1).is_some() {
                return Some(k);
            }
            if !item(tokens, k + 1 + and) {
                return None;
            }
            if closed || plus || and == 1 && items == 1 {
                return Some(k);
            }
            items += 1;
        }
    }
    None
}

/// Whether a new thing is named here.
pub(super) fn item(tokens: &[Token], i: usize) -> bool {
    let counted = matches!(word(tokens, i), "a" | "an" | "some" | "one") || number(tokens, i).is_some_and(|n| n > 1);
    // "Two bedrooms, each with its own bathroom, and a kitchen" are rooms, and are read as such.
    let is_room = (1..=2).any(|n| get().room(word(tokens, i + n)).is_some());
    // Words that say what it is like stand before it.
    counted && !is_room && (1..=3).any(|n| noun(tokens, i + n).is_some())
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_each_has_ends_where_its_list_ends() {
        for (said, becomes) in [
            (
                "four wheels, each with a stool, a table, a kiln in the corner and a rack.",
                "four wheels , each with a stool . there is a table , a kiln in the corner and a rack .",
            ),
            (
                "twin beds with one shared nightstand, a desk with a lamp, and a chair.",
                "twin beds with one nightstand between them . there is a desk with a lamp , and a chair .",
            ),
            (
                "two beds with a nightstand between them, a desk and a chair.",
                "two beds with a nightstand between them . there is a desk and a chair .",
            ),
            (
                "four stations, each with a mirror and a chair, two wash basins at the back and a small desk.",
                "four stations , each with a mirror and a chair . there are two wash basins at the back and a small desk .",
            ),
            (
                "two beds, each with a locker, a lamp and a chair, and a screen between them",
                "two beds , each with a locker , a lamp and a chair . there is a screen between them",
            ),
            ("two beds. each bed needs a locker and a stand.", "two beds . each bed has a locker and a stand ."),
            (
                "two beds, and a bedside cabinet and a chair for each bed.",
                "two beds , and a bedside cabinet for each bed and a chair for each bed .",
            ),
            ("two tables with six chairs each and a shelf", "two tables with six chairs each , and a shelf"),
            (
                "four tables with two chairs each along the windows, and an information desk by the door.",
                "four tables with two chairs each near the windows . there is an information desk by the door .",
            ),
            ("two desks, each with a lamp, and a sofa", "two desks , each with a lamp . there is a sofa"),
            (
                "two desks, each with a lamp, a chair, and a monitor",
                "two desks , each with a lamp , a chair , and a monitor",
            ),
            (
                "tables with a cloth and a candle on each, a bar with six stools, and a stand",
                "tables with a cloth and a candle on each . there is a bar with six bar stools , and a stand",
            ),
            (
                "eight workbenches with vices along the two long walls, a rack and a stool",
                "eight workbenches along the two long walls with vices . there is a rack and a stool",
            ),
            ("two desks, each with a lamp and a chair", "two desks , each with a lamp and a chair"),
            (
                "a counter with a till and a cake stand on it, six tables with two chairs each, and a bench.",
                "a counter with a till and a cake stand on it . there are six tables with two chairs each . there is a bench .",
            ),
            (
                "two desks, each with a lamp and a chair, printer near the door, some plants",
                "two desks , each with a lamp and a chair . there is printer near the door , some plants",
            ),
            (
                "five tables with two chairs each, a bench by the window and a plant.",
                "five tables with two chairs each . there is a bench by the window and a plant .",
            ),
            (
                "three plinths with sculptures in a row, one long bench and a desk",
                "three plinths with sculptures on them in a row . there are one long bench and a desk",
            ),
            ("six desks with monitors, a lamp and a chair", "six desks with monitors , a lamp and a chair"),
            ("six desks with monitors and chairs, a sofa", "six desks with monitors and chairs , a sofa"),
            (
                "two desks, each with a lamp and a chair, facing the wall",
                "two desks , each with a lamp and a chair , facing the wall",
            ),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
