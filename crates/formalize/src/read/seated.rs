//! Who sits where: "the supervisor sits at the front" asks for a desk there, and of "a chair for the doctor and two for
//! patients" the two are chairs.

use super::lexicon::{get, singular};
use super::number::count;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};
use crate::brief::{Brief, Fact, FactKind, Group, Number, Rel};
use scenelang_lang::nouns::plural;

/// Who works at a desk of their own.
const AT_A_DESK: [&str; 18] = [
    "supervisor",
    "teacher",
    "manager",
    "boss",
    "instructor",
    "lecturer",
    "professor",
    "secretary",
    "guard",
    "invigilator",
    "trainer",
    "director",
    "principal",
    "headteacher",
    "librarian",
    "assistant",
    "tutor",
    "clerk",
];
/// The most words between "for" and the noun before it, and between two that are counted in this way.
const NEAR: usize = 8;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    sits(tokens, i) || counted_for(tokens, i) || for_each(tokens, i)
}

/// "A cabinet and a chair for each patient": for each bed.
fn for_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    let place = match word(tokens, i + 2) {
        "patient" => "bed",
        "student" | "pupil" => "desk",
        _ => return false,
    };
    let are_there = tokens[..i].iter().any(|t| t.word() && singular(&t.text).ends_with(place));
    let said = word(tokens, i) == "for" && matches!(word(tokens, i + 1), "each" | "every") && are_there;
    if !said {
        return false;
    }
    put(tokens, i + 2, i + 3, &[place]);
    // "A cabinet and chair for each": each has both.
    let singles = i > 3
        && word(tokens, i - 2) == "and"
        && get().noun(word(tokens, i - 1)).is_some()
        && get().noun(word(tokens, i - 3)).is_some();
    if singles {
        let owner = tokens[i..i + 3].to_vec();
        let mut article = tokens[i].clone();
        article.text = "a".to_owned();
        tokens.insert(i - 1, article);
        tokens.splice(i - 2..i - 2, owner);
    }
    true
}

/// "The supervisor sits at the front facing everybody": a supervisor desk at the front facing the desks.
fn sits(tokens: &mut Vec<Token>, i: usize) -> bool {
    let who = word(tokens, i + 1).to_owned();
    let article = matches!(word(tokens, i), "the" | "a" | "an" | "our" | "one");
    if !article || !AT_A_DESK.contains(&who.as_str()) || !matches!(word(tokens, i + 2), "sits" | "works") {
        return false;
    }
    // "The teacher sits at a desk" names it.
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let end = tokens[i..].iter().position(stops).map_or(tokens.len(), |n| i + n);
    let has_seat = |t: &Token| matches!(singular(&t.text).as_str(), "desk" | "table" | "chair" | "counter" | "podium");
    if tokens[i + 3..end].iter().any(has_seat) || get().relation(&tokens[i + 3..]).is_none_or(|(_, n)| n == 0) {
        return false;
    }
    let everybody = (i + 4..end).find(|k| {
        matches!(word(tokens, *k), "everybody" | "everyone" | "them" | "students" | "class" | "pupils")
            && matches!(word(tokens, k - 1), "facing" | "the")
    });
    let desks = tokens[..i].iter().any(|t| t.is("desks"));
    if let Some(at) = everybody.filter(|_| desks) {
        let from = at - usize::from(word(tokens, at - 1) == "the");
        put(tokens, from, at + 1, &["the", "desks"]);
    }
    put(tokens, i, i + 3, &["a", &who, "desk"]);
    true
}

/// "A chair for the doctor and two for patients": and two chairs for patients.
fn counted_for(tokens: &mut Vec<Token>, i: usize) -> bool {
    let joined = i > 0 && (word(tokens, i - 1) == "and" || tokens[i - 1].is(","));
    let Some((n, 1)) = tokens.get(i..).and_then(count).filter(|_| joined && word(tokens, i + 1) == "for") else {
        return false;
    };
    let before = (i.saturating_sub(NEAR)..i - 1).rev().find(|k| word(tokens, *k) == "for");
    let Some(noun) = before.and_then(|k| k.checked_sub(1)).filter(|k| tokens[*k].word()) else { return false };
    let name = singular(word(tokens, noun));
    if get().noun(&name).is_none() || (noun + 1..i - 1).any(|k| !tokens[k].word() && !tokens[k].is(",")) {
        return false;
    }
    let said = tokens[i].text.clone();
    let name = if n == 1.0 { name } else { plural(&name) };
    put(tokens, i, i + 1, &[&said, &name]);
    true
}

/// "A table for ten. Leave a metre behind the chairs": these are the chairs at the table.
pub fn at_tables(brief: &mut Brief) {
    let placed = |seat: usize| {
        brief.facts.iter().any(|fact| {
            let other =
                matches!(fact.what, FactKind::Rel(..) | FactKind::Place(..) | FactKind::Pattern(_) | FactKind::Gap(..));
            other && (fact.of.contains(&seat) || fact.what.objects().unwrap_or_default().contains(&seat))
        })
    };
    let is_chair = |at: &usize| {
        let thing = &brief.things[*at];
        thing.head() == "chair" && thing.number == Number::Plural && thing.part.is_none() && !placed(*at)
    };
    let chairs: Vec<usize> = (0..brief.things.len()).filter(is_chair).collect();
    for chair in chairs {
        let room = brief.things[chair].room;
        let mut tables = (0..brief.things.len()).filter(|at| {
            let table = &brief.things[*at];
            table.room == room && table.group == Group::Table && table.places.is_some() && !table.number.many()
        });
        let (Some(table), None) = (tables.next(), tables.next()) else { continue };
        let source = brief.things[chair].source.clone();
        if let Some(places) = brief.things[table].places {
            brief.things[chair].number = Number::Exactly(places);
        }
        brief.facts.push(Fact::new(vec![chair], FactKind::Rel(Rel::Around, vec![table]), source));
    }
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase::plainly;

    #[test]
    fn who_sits_somewhere_has_a_seat() {
        for (text, becomes) in [
            (
                "twenty desks. the supervisor sits at the front facing everybody.",
                "twenty desks . a supervisor desk at the front facing the desks .",
            ),
            ("the teacher sits near the window.", "a teacher desk near the window ."),
            ("the teacher sits at a desk near the window.", "the teacher sits at a desk near the window ."),
            ("the supervisor sits.", "the supervisor sits ."),
            (
                "a desk, a chair for the doctor and two for patients.",
                "a desk , a chair for the doctor and two chairs for patients .",
            ),
            ("two shelves for books and one for files.", "two shelves for books and one shelf for files ."),
            ("a table and two for the garden.", "a table and two for the garden ."),
            ("two beds, a cabinet for each patient.", "two beds , a cabinet for each bed ."),
            ("a cabinet for each patient.", "a cabinet for each patient ."),
            (
                "two beds, a cabinet and chair for each patient.",
                "two beds , a cabinet for each bed and a chair for each bed .",
            ),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
