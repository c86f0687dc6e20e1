//! For how many people a room is: "for eight people", "seating ten guests", "for six".

use super::lexicon::{Class, get, singular};
use super::number;
use super::senses::{Sense, sense};
use super::token::{Token, WordKind, tokens};
use crate::brief::{Brief, Number, Room, Thing};
use std::ops::Range;

/// How many people are spoken of right after "for", and how many tokens that takes: "six", "six people".
fn after_for(rest: &[Token]) -> Option<(f64, usize)> {
    // "A table for eight and a sideboard".
    const GO_ON: [&str; 15] = [
        "and", "with", "plus", "in", "at", "near", "by", "under", "next", "beside", "where", "along", "against",
        "down", "on",
    ];
    let (n, words) = number::count(rest)?;
    // "For six" without a noun speaks of people, too.
    let ends = |who: &Token| {
        matches!(who.kind, WordKind::Line | WordKind::Sign('.' | ',' | ';' | '!' | ')' | ':'))
            || GO_ON.iter().any(|word| who.is(word))
    };
    match rest.get(words) {
        None => Some((n, words)),
        Some(who) if ends(who) => Some((n, words)),
        Some(who) => get().is(&who.text, Class::Person).then_some((n, words + 1)),
    }
}

/// For how many people a thing is of which this is said: "for six".
pub fn places(tokens: &[Token]) -> Option<(usize, usize)> {
    const MOST: f64 = 60.0;
    let (n, words) = tokens.first().filter(|t| t.is("for")).and_then(|_| after_for(&tokens[1..]))?;
    (n.fract() == 0.0 && (1.0..=MOST).contains(&n)).then_some((n as usize, words + 1))
}

/// How many people, and the tokens that say so.
fn people(tokens: &[Token]) -> Option<(usize, Range<usize>)> {
    const GROUPS: [&str; 8] = ["family", "group", "team", "class", "party", "crew", "staff", "household"];
    const MOST: f64 = 120.0;
    const AT_ONE: f64 = 4.0;
    (0..tokens.len())
        .filter(|&i| tokens[i].is("for") || tokens[i].is("seating"))
        .find_map(|i| {
            // "For a family of five", "for a class of twenty".
            let group = (i + 1..tokens.len().min(i + 5)).find(|k| tokens[*k].is("of"));
            let of = group.filter(|k| GROUPS.iter().any(|group| tokens[k - 1].is(group)));
            let first = of.map_or(i, |of| of - 1);
            let i = of.unwrap_or(i);
            // "For a family of five" ends there.
            let (n, words) = match of {
                Some(_) => number::count(&tokens[i + 1..])?,
                None => after_for(&tokens[i + 1..])?,
            };
            // "Six tables for two" are for twelve.
            // "Reading tables for twelve", of which nobody says how many: twelve at all of them.
            let all_of_them = || (n > AT_ONE).then_some(1.0);
            let tables = if of.is_none() { tables(&tokens[..i]).or_else(all_of_them) } else { Some(1.0) };
            let all = n * tables?;
            (n > 1.0 && all <= MOST).then(|| (all as usize, first..i + 1 + words))
        })
        .or_else(|| told(tokens).filter(|(n, _)| *n <= MOST as usize))
}

/// "Sixteen pupils.", "we are ten people", "fourteen of us this year": so many, where nothing else says for how many.
fn told(tokens: &[Token]) -> Option<(usize, Range<usize>)> {
    let begins = |i: usize| {
        i == 0
            || !tokens[i - 1].word()
            || ["are", "is", "we're", "they're", "be"].iter().any(|word| tokens[i - 1].is(word))
    };
    (0..tokens.len()).filter(|i| begins(*i)).find_map(|i| {
        let (n, words) = number::count(&tokens[i..]).filter(|(n, _)| *n > 1.0 && n.fract() == 0.0)?;
        let end = i + words;
        let us = tokens.get(end).is_some_and(|t| t.is("of")) && tokens.get(end + 1).is_some_and(|t| t.is("us"));
        if us {
            return Some((n as usize, i..end + 2));
        }
        let who = &tokens.get(end).filter(|t| t.word())?.text;
        let is_thing = get().noun(&singular(who)).is_some();
        let person = get().is(who, Class::Person) || sense(who) == Some(Sense::Person) && !is_thing;
        // "Two children each" and "two guests' beds" count something else.
        let alone = tokens.get(end + 1).is_none_or(|t| !t.word() || get().relation(&tokens[end + 1..]).is_none());
        (person && alone && singular(who) != *who).then_some((n as usize, i..end + 1))
    })
}

/// How many tables it is said of, if these words end with some: one, if with none or one; `None`, if nobody says how many.
fn tables(before: &[Token]) -> Option<f64> {
    const AHEAD: usize = 4;
    if !before.last().is_some_and(|t| t.is("tables")) {
        return Some(1.0);
    }
    let from = before.len().saturating_sub(AHEAD);
    (from..before.len()).find_map(|i| number::count(&before[i..]).map(|(n, _)| n))
}

/// Writes it into the room that is spoken of there. The tokens that say so.
pub fn count(rooms: &mut [Room], tokens: &[Token]) -> Range<usize> {
    let Some((people, said)) = people(tokens) else { return 0..0 };
    let at = tokens[said.start].at.start;
    let room = rooms.iter().rposition(|room| room.source.at().start <= at).unwrap_or(0);
    if let Some(room) = rooms.get_mut(room) {
        room.people = Some(people);
    }
    said
}

/// Where a request says it; its beginning, if it does not.
pub fn phrase(request: &str) -> Range<usize> {
    let (mut tokens, _) = tokens(request, super::MOST_WORDS);
    super::paraphrase::plain(&mut tokens);
    super::zones::plain(&mut tokens);
    people(&tokens).map_or(0..0, |(_, said)| tokens[said.start].at.start..tokens[said.end - 1].at.end)
}

/// "An office for four people, each with a desk and a chair", "for three people with a desk each", "… and a bed for each":
/// so many of what each of them has. The tokens that say so.
pub fn each(brief: &mut Brief, tokens: &[Token]) -> Vec<usize> {
    let Some((_, said)) = people(tokens) else { return Vec::new() };
    let Some(room) = brief.rooms.iter().position(|room| room.people.is_some()) else { return Vec::new() };
    let people = brief.rooms[room].people.unwrap_or(1);
    let begin = said.start;
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!'));
    let end = tokens[begin..].iter().position(ends).map_or(tokens.len(), |n| begin + n);
    let has = |t: &Token| ["with", "has", "have", "having", "gets", "get"].iter().any(|word| t.is(word));
    let Some(at) = (begin..end).find(|i| tokens[*i].is("each")) else { return Vec::new() };
    let list = if at + 1 < end && has(&tokens[at + 1]) {
        at + 1..end
    } else {
        // It ends the list, and nothing in that list is so many for each of another.
        let closes = at + 1 == end || matches!(tokens[at + 1].kind, WordKind::Sign(','));
        let Some(with) = (begin..at).rev().find(|i| has(&tokens[*i])).filter(|_| closes) else { return Vec::new() };
        with..at
    };
    let bytes = tokens[list.start].at.start..tokens[list.end - 1].at.end;
    let single =
        |thing: &Thing| thing.part.is_none() && thing.number.said().is_none_or(|n| n == 1) && !thing.number.follows();
    let listed = |thing: &Thing| thing.room == room && bytes.contains(&thing.source.at().start);
    if !brief.things.iter().any(listed) || !brief.things.iter().filter(|thing| listed(thing)).all(single) {
        return Vec::new();
    }
    for thing in brief.things.iter_mut().filter(|thing| listed(thing)) {
        thing.number = Number::Exactly(people);
    }
    let before = usize::from(at > 0 && tokens[at - 1].is("for"));
    (at - before..=at).chain((list.start == at + 1).then_some(at + 1)).collect()
}
