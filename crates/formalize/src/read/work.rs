//! Where people and machines work: a cell with a robot is no prison cell, what a robot picks from and puts on is beside it, a fence
//! goes all round, and workplaces stand along a line.

use super::lexicon::{get, singular};
use super::number::count;
use super::paraphrase::{ends, put, word};
use super::quantified::number;
use super::shares::noun;
use super::token::{Token, WordKind};
use scenelang_lang::nouns::{self, Stands};
use std::ops::Range;

/// What handles parts by itself.
const MACHINES: [&str; 8] = ["arm", "cobot", "gripper", "manipulator", "palletiser", "palletizer", "robot", "robots"];
/// What such a line is called.
const LINES: [&str; 7] = ["assembly", "bottling", "packaging", "packing", "picking", "production", "sorting"];
/// Who stands or sits at it.
const WORKERS: [&str; 6] = ["assemblers", "operators", "packers", "people", "staff", "workers"];
/// So far back a noun is looked for.
const BACK: usize = 30;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 9] =
        [robot_cell, handles, all_round, gate_in_fence, outside, along_line, behind_workers, finished, end_of_line];
    turns.iter().any(|turn| turn(tokens, i)) || board_of_tools(tokens, i)
}

/// "A cell with a robot arm": a robot cell.
fn robot_cell(tokens: &mut Vec<Token>, i: usize) -> bool {
    let before = i.checked_sub(1).map_or("", |k| word(tokens, k));
    let bare = get().is_look(before) || matches!(before, "a" | "an" | "the" | "our" | "my" | "this");
    let robots = |t: &Token| matches!(t.text.as_str(), "robot" | "robots" | "robotic" | "cobot" | "cobots");
    let said = word(tokens, i) == "cell" && bare && tokens.iter().any(robots);
    if said {
        put(tokens, i, i + 1, &["robot", "cell"]);
    }
    said
}

/// The same of the whole request, before its first words are held for the name of its room.
pub fn cells(tokens: &mut Vec<Token>) {
    let mut i = 0;
    while i < tokens.len() {
        robot_cell(tokens, i);
        i += 1;
    }
}

/// The name of the last machine before a token that handles parts.
fn machine(tokens: &[Token], i: usize) -> Option<Vec<String>> {
    let last = (i.saturating_sub(BACK)..i).rev().find(|k| MACHINES.contains(&word(tokens, *k)))?;
    let from = (last.saturating_sub(3)..=last).find(|k| noun(tokens, *k).is_some_and(|name| name.end == last + 1));
    Some((from.unwrap_or(last)..=last).map(|k| word(tokens, k).to_owned()).collect())
}

/// Where "from a conveyor", "off the belt", "on a pallet" ends, with the noun.
fn where_to(tokens: &[Token], i: usize, by: &[&str]) -> Option<(usize, Vec<String>)> {
    let by = by.contains(&word(tokens, i)).then_some(i + 1)?;
    let by = by + usize::from(matches!(word(tokens, by), "of" | "to"));
    let article = matches!(word(tokens, by), "a" | "an" | "one").then_some(by + 1)?;
    let name = noun(tokens, article)?;
    Some((name.end, (article..name.end).map(|k| word(tokens, k).to_owned()).collect()))
}

/// "A robot arm picking parts off a conveyor and putting them on a pallet": the conveyor and the pallet are beside it.
fn handles(tokens: &mut Vec<Token>, i: usize) -> bool {
    const TAKES: [&str; 16] = [
        "picking",
        "picks",
        "taking",
        "takes",
        "lifting",
        "lifts",
        "grabbing",
        "grabs",
        "unloading",
        "unloads",
        "moving",
        "moves",
        "feeding",
        "feeds",
        "removing",
        "removes",
    ];
    const PUTS: [&str; 14] = [
        "putting", "puts", "placing", "places", "stacking", "stacks", "loading", "loads", "dropping", "drops",
        "laying", "lays", "setting", "sets",
    ];
    const FAR: usize = 4;
    let that = usize::from(matches!(word(tokens, i), "that" | "which"));
    let takes = TAKES.contains(&word(tokens, i + that));
    if !takes && !PUTS.contains(&word(tokens, i + that)) || i == 0 {
        return false;
    }
    let Some(name) = machine(tokens, i) else { return false };
    let (off, on) = (["from", "off", "out"], ["on", "onto", "in", "into", "to"]);
    let source = (i + that + 1..i + that + 1 + FAR).find_map(|k| where_to(tokens, k, if takes { &off } else { &on }));
    let Some((mut end, first)) = source else { return false };
    let mut second = None;
    let joined = end + usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    let joined = joined + usize::from(word(tokens, joined) == "and");
    if takes {
        let put_down = PUTS.contains(&word(tokens, joined)) && joined > end;
        let them = usize::from(matches!(word(tokens, joined + 1), "them" | "it" | "these" | "everything"));
        let target = where_to(tokens, if put_down { joined + 1 + them } else { end }, &on);
        if let Some((to, what)) = target {
            (end, second) = (to, Some(what));
        }
    }
    let place = |what: &[String]| [&["a".to_owned()], what, &["beside".into(), "the".into()], &name].concat();
    let mut said: Vec<String> = vec![".".into(), "there".into(), "is".into()];
    said.extend(place(&first));
    if let Some(second) = &second {
        said.push("and".into());
        said.extend(place(second));
    }
    let goes_on = tokens.get(end).is_some_and(Token::word) && word(tokens, end) != "and";
    said.extend(goes_on.then(|| ",".to_owned()));
    replace(tokens, i, end, &said);
    true
}

/// Puts words and signs in the place of others.
fn replace(tokens: &mut Vec<Token>, from: usize, to: usize, said: &[String]) {
    put(tokens, from, to, &said.iter().map(String::as_str).collect::<Vec<_>>());
    for token in &mut tokens[from..from + said.len()] {
        if let "." | "," = token.text.as_str() {
            token.kind = WordKind::Sign(if token.text == "." { '.' } else { ',' });
        }
    }
}

/// "Fence it all round, about 4 by 4 m": there is a fence about 4 by 4 m around the robot.
fn all_round(tokens: &mut Vec<Token>, i: usize) -> bool {
    let begins = i == 0 || tokens[i - 1].stops() || tokens[i - 1].is(",") || tokens[i - 1].is("and");
    let verb = matches!(word(tokens, i), "fence" | "enclose" | "surround");
    let what = matches!(word(tokens, i + 1), "it" | "this" | "that" | "everything")
        || word(tokens, i + 1) == "the" && matches!(word(tokens, i + 2), "cell" | "robot" | "area" | "whole");
    let Some(name) = machine(tokens, i).filter(|_| begins && verb && what) else { return false };
    let within = |k: &usize| {
        matches!(
            word(tokens, *k),
            "it" | "this"
                | "that"
                | "everything"
                | "the"
                | "cell"
                | "robot"
                | "area"
                | "whole"
                | "all"
                | "round"
                | "around"
                | "in"
                | "off"
                | "completely"
                | "fully"
                | "thing"
        )
    };
    let end = (i + 1..).find(|k| !within(k)).unwrap_or(i + 1);
    // "With a fence" says it, too.
    let fence = word(tokens, end) == "with"
        && word(tokens, end + 1) == "a"
        && (end + 2..end + 4).any(|k| word(tokens, k) == "fence");
    let end = if fence { (end + 2..).find(|k| word(tokens, *k) == "fence").map_or(end, |k| k + 1) } else { end };
    if word(tokens, i) == "surround" && !fence {
        return false;
    }
    let comma = usize::from(tokens.get(end).is_some_and(|t| t.is(",")));
    let size = size(tokens, end + comma);
    let around: Vec<String> = ["around".to_owned(), "the".to_owned()].into_iter().chain(name).collect();
    let to = size.unwrap_or(end);
    let like = tokens[end - 1].clone();
    tokens.splice(to..to, around.iter().map(|text| like.saying(text)));
    if size.is_some() && comma == 1 {
        tokens.remove(end);
    }
    let dot = i > 0 && !tokens[i - 1].stops();
    put(tokens, i, end, &["there", "is", "a", "fence"]);
    if dot {
        tokens[i - 1] = Token { kind: WordKind::Sign('.'), ..tokens[i - 1].saying(".") };
    }
    true
}

/// Where a size ends that begins here: "about 4 by 4 m".
fn size(tokens: &[Token], i: usize) -> Option<usize> {
    let about = usize::from(matches!(word(tokens, i), "about" | "around" | "roughly" | "approximately"));
    let (_, first) = count(tokens.get(i + about..)?)?;
    let by = i + about + first;
    let unit = |k: usize| usize::from(super::number::unit(word(tokens, k)).is_some());
    let by = by + unit(by);
    matches!(word(tokens, by), "by" | "x" | "×").then_some(())?;
    let (_, second) = count(tokens.get(by + 1..)?)?;
    Some(by + 1 + second + unit(by + 1 + second))
}

/// Whether a fence around a machine is told of before a token.
fn is_fenced(tokens: &[Token], i: usize) -> bool {
    let fences = |t: &Token| matches!(t.text.as_str(), "fence" | "fences" | "fencing" | "cage" | "enclosure");
    tokens[i.saturating_sub(BACK)..i].iter().any(fences) && machine(tokens, i).is_some()
}

/// "A fence around the robot with a gate on one side": the gate is part of the fence.
fn gate_in_fence(tokens: &mut Vec<Token>, i: usize) -> bool {
    let gate = i > 0 && matches!(word(tokens, i), "gate" | "door") && matches!(word(tokens, i - 1), "a" | "an" | "one");
    let with = i > 1 && matches!(word(tokens, i - 2), "with" | "and" | "has");
    if !gate || !with || !is_fenced(tokens, i) {
        return false;
    }
    // A door that is said to be in a wall is one of the room.
    let side = [word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)];
    let end = match side {
        ["on" | "at" | "in", "one" | "the" | "a", "side" | "front" | "fence"] => i + 4,
        _ if ends(tokens, i + 1) && word(tokens, i) == "gate" => i + 1,
        _ => return false,
    };
    put(tokens, i, end, &["safety", "gate"]);
    if i > 2 && tokens[i - 3].is(",") && word(tokens, i - 2) == "with" {
        tokens.remove(i - 3);
    }
    true
}

/// "A fence and the control cabinet outside": next to the fence.
fn outside(tokens: &mut Vec<Token>, i: usize) -> bool {
    let of = match [word(tokens, i + 1), word(tokens, i + 2), word(tokens, i + 3)] {
        ["the" | "it", "fence" | "cell" | "cage", _] => 2,
        ["of", "the" | "it", "fence" | "cell" | "cage"] => 3,
        ["it", ..] => 1,
        ["of", "it", _] => 2,
        _ => 0,
    };
    let said = word(tokens, i) == "outside" && ends(tokens, i + 1 + of) && i > 0 && is_fenced(tokens, i);
    let thing = said && (i.saturating_sub(4)..i).any(|k| noun(tokens, k).is_some_and(|name| name.end == i));
    if thing {
        put(tokens, i, i + 1 + of, &["next", "to", "the", "fence"]);
    }
    thing
}

/// Whether the request is about a line at which things are made or packed.
fn is_line(tokens: &[Token]) -> bool {
    tokens
        .windows(2)
        .any(|pair| LINES.iter().any(|line| pair[0].is(line)) && (pair[1].is("line") || pair[1].is("lines")))
}

/// What the conveyor of the request is called last.
fn conveyor(tokens: &[Token]) -> Option<String> {
    tokens.iter().rev().find(|t| matches!(t.text.as_str(), "conveyor" | "belt")).map(|t| t.text.clone())
}

/// "An assembly line with five workstations on one side": in a row in front of its conveyor.
fn along_line(tokens: &mut Vec<Token>, i: usize) -> bool {
    const AT: [&str; 6] = ["benches", "desks", "stations", "tables", "workbenches", "workstations"];
    if !number(tokens, i).is_some_and(|n| (2..=20).contains(&n)) {
        return false;
    }
    let own = noun(tokens, i + 1).filter(|name| AT.contains(&word(tokens, name.end - 1)));
    let Some(Range { start, end }) = own else { return false };
    let side = matches!(
        [word(tokens, end), word(tokens, end + 1), word(tokens, end + 2)],
        ["on" | "along" | "at", "one" | "its" | "the", "side"]
    );
    let row = |k: usize| {
        word(tokens, k) == "in" && matches!(word(tokens, k + 1), "a" | "one") && word(tokens, k + 2) == "row"
    };
    let conveyor = conveyor(tokens);
    if !(side || row(end) && ends(tokens, end + 3)) || !(is_line(tokens) || conveyor.is_some() && side) {
        return false;
    }
    let after = if side { end + 3 } else { end };
    let line = conveyor.clone().unwrap_or_else(|| "conveyor".to_owned());
    let mut said = vec!["in", "a", "row", "in", "front", "of", "the", &line];
    let station = singular(word(tokens, end - 1));
    let name = match station.as_str() {
        "station" => "workstations".to_owned(),
        _ => word(tokens, end - 1).to_owned(),
    };
    let seat = seat_at_each(tokens, after);
    let one = singular(&name);
    if let Some((_, seat)) = &seat {
        said.extend([".", "there", "is", "a", seat.as_str(), "in", "front", "of", "each", &one]);
    }
    let to = seat.as_ref().map_or(after, |(to, _)| *to);
    let said: Vec<String> = said.iter().map(|text| (*text).to_owned()).collect();
    if to > end {
        replace(tokens, end, to, &said);
    } else {
        let like = tokens[end - 1].clone();
        tokens.splice(end..end, said.iter().map(|text| like.saying(text)));
    }
    if station == "station" {
        put(tokens, start, end, &[&name]);
    }
    if conveyor.is_none() {
        let like = tokens[i].clone();
        let words = ["a", "conveyor", "and"].map(|text| like.saying(text));
        tokens.splice(i..i, words);
    }
    true
}

/// "And a stool at each": where that ends, and the seat.
fn seat_at_each(tokens: &[Token], i: usize) -> Option<(usize, String)> {
    let from = i + usize::from(tokens.get(i).is_some_and(|t| t.is(",")));
    let from = from + usize::from(matches!(word(tokens, from), "and" | "with"));
    let seat =
        matches!(word(tokens, from + 1), "stool" | "chair" | "seat").then(|| word(tokens, from + 1).to_owned())?;
    let end = match [word(tokens, from + 2), word(tokens, from + 3), word(tokens, from + 4)] {
        ["at", "each", "station" | "one" | "workstation"] => from + 5,
        ["at", "each", _] => from + 4,
        ["for" | "before", "each", _] => from + 4,
        ["each", ..] => from + 3,
        _ => return None,
    };
    let article = matches!(word(tokens, from), "a" | "an" | "one");
    (article && from > i && ends(tokens, end)).then_some((end, seat))
}

/// "Parts bins stand behind the workers": one behind each stool.
fn behind_workers(tokens: &mut Vec<Token>, i: usize) -> bool {
    let by = matches!(word(tokens, i), "behind" | "beside" | "before");
    let whom = i + 1 + usize::from(word(tokens, i + 1) == "the");
    if !by || !WORKERS.contains(&word(tokens, whom)) || i == 0 {
        return false;
    }
    let seats = |k: &usize| matches!(word(tokens, *k), "stool" | "stools" | "chair" | "chairs");
    let works =
        |k: &usize| matches!(singular(word(tokens, *k)).as_str(), "workstation" | "workbench" | "bench" | "station");
    let back = i.saturating_sub(2 * BACK)..i;
    let Some(at) = back.clone().rev().find(seats).or_else(|| back.rev().find(works)) else { return false };
    let one = singular(word(tokens, at));
    let side = word(tokens, i).to_owned();
    let verb = matches!(word(tokens, i - 1), "stand" | "are" | "sit" | "go");
    let last = if verb { i - 1 } else { i };
    let name = (last.saturating_sub(4)..last).find_map(|k| noun(tokens, k).filter(|name| name.end == last));
    let Some(name) = name.filter(|name| get().noun(&singular(word(tokens, name.end - 1))).is_some()) else {
        put(tokens, i + 1, whom + 1, &["each", &one]);
        return true;
    };
    // A list of what stands there begins the sentence.
    let sentence = tokens[..last].iter().rposition(|t| t.stops() || t.is(",")).map_or(0, |k| k + 1);
    if last - sentence > 4 || !super::lexicon::plural(word(tokens, name.end - 1)) || tokens[sentence].is("and") {
        put(tokens, i + 1, whom + 1, &["each", &one]);
        return true;
    }
    let what: Vec<String> = (sentence..last - 1).map(|k| singular(word(tokens, k))).collect();
    let mut said: Vec<String> = vec!["there".into(), "is".into(), "a".into()];
    said.extend(what);
    said.extend([singular(word(tokens, last - 1)), side, "each".into(), one]);
    replace(tokens, sentence, whom + 1, &said);
    true
}

/// "Finished stuff ends up on a packing table": there is a packing table.
fn finished(tokens: &mut Vec<Token>, i: usize) -> bool {
    const DONE: [&str; 6] = ["finished", "packed", "ready", "completed", "assembled", "sorted"];
    const GOODS: [&str; 10] =
        ["stuff", "goods", "products", "parts", "items", "work", "pieces", "boxes", "units", "product"];
    let the = usize::from(word(tokens, i) == "the");
    let done = DONE.contains(&word(tokens, i + the));
    let goods = i + the + usize::from(done);
    if !done || !GOODS.contains(&word(tokens, goods)) {
        return false;
    }
    let verb = match [word(tokens, goods + 1), word(tokens, goods + 2)] {
        ["ends" | "end" | "comes" | "come" | "piles" | "pile", "up" | "out" | "off"] => goods + 3,
        ["goes" | "go" | "lands" | "land" | "leaves" | "arrives" | "arrive", _] => goods + 2,
        ["is" | "are" | "gets" | "get", "put" | "placed" | "packed" | "stacked" | "collected"] => goods + 3,
        _ => return false,
    };
    let article = verb + 1;
    let on = matches!(word(tokens, verb), "on" | "onto" | "at" | "in" | "into" | "to");
    if !on || !matches!(word(tokens, article), "a" | "an" | "one") || noun(tokens, article + 1).is_none() {
        return false;
    }
    put(tokens, i, article, &["there", "is"]);
    let and = i > 0 && tokens[i - 1].is("and");
    if and {
        let comma = usize::from(i > 1 && tokens[i - 2].is(","));
        tokens.drain(i - 1 - comma..i - 1);
        let k = i - 1 - comma;
        tokens[k] = Token { kind: WordKind::Sign('.'), ..tokens[k].saying(".") };
    }
    true
}

/// "A packing table at the far end" of a line.
fn end_of_line(tokens: &mut Vec<Token>, i: usize) -> bool {
    let at = matches!(word(tokens, i), "at" | "on") && matches!(word(tokens, i + 1), "the" | "one" | "its");
    let which = usize::from(matches!(word(tokens, i + 2), "far" | "other" | "near" | "left" | "right"));
    let end = i + 2 + which;
    let first = matches!(word(tokens, end), "start" | "beginning") || matches!(word(tokens, i + 2), "near" | "left");
    if !at || !matches!(word(tokens, end), "end" | "start" | "beginning") {
        return false;
    }
    let of = match [word(tokens, end + 1), word(tokens, end + 2), word(tokens, end + 3)] {
        ["of", "the", "line" | "belt" | "conveyor"] => 3,
        ["of", "it", _] => 2,
        _ => 0,
    };
    let thing = (i.saturating_sub(4)..i).any(|k| noun(tokens, k).is_some_and(|name| name.end == i));
    let Some(name) = conveyor(&tokens[..i]).filter(|_| thing && ends(tokens, end + 1 + of)) else {
        return false;
    };
    if !is_line(tokens) && of == 0 {
        return false;
    }
    put(tokens, i, end + 1 + of, &["to", "the", if first { "left" } else { "right" }, "of", "the", &name]);
    true
}

/// "A pegboard full of tools behind them": a pegboard behind them with tools.
fn board_of_tools(tokens: &mut Vec<Token>, i: usize) -> bool {
    let full = super::contents::is_full_of(tokens, i);
    let after = i + 1 + usize::from(full);
    if i == 0 || !full && word(tokens, i) != "with" || word(tokens, after) != "tools" {
        return false;
    }
    let board = (i.saturating_sub(3)..i).find_map(|k| noun(tokens, k).filter(|name| name.end == i));
    let hangs = board.is_some_and(|name| {
        let name: Vec<String> = name.map(|k| singular(word(tokens, k))).collect();
        nouns::ending(&name.join(" ")).is_some_and(|noun| noun.stands == Stands::Wall)
    });
    if !hangs {
        return false;
    }
    if full {
        put(tokens, i, after, &["with"]);
    }
    let place = i + 2;
    let by = matches!(word(tokens, place), "behind" | "above" | "over" | "beside" | "on" | "near");
    let end = (place + 1..place + 6).find(|k| ends(tokens, *k));
    if let Some(end) = end.filter(|_| by) {
        tokens[i..end].rotate_left(2);
        return true;
    }
    full
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn work_is_told_plainly() {
        for (said, becomes) in [
            ("a cell with one robot arm, a bin", "a robot cell with one robot arm , a bin"),
            ("a cell with a bed", "a cell with a bed"),
            (
                "a robot arm in the middle picking parts off a conveyor and putting them on a pallet.",
                "a robot arm in the middle . there is a conveyor beside the robot arm and a pallet beside the robot arm .",
            ),
            ("a cobot that stacks boxes onto a pallet, a bin", "a cobot . there is a pallet beside the cobot , a bin"),
            ("a man picking books from a shelf", "a man picking books from a shelf"),
            (
                "a robot arm. fence it all round, about 4 by 4 m, with a gate on one side and the control cabinet outside.",
                "a robot arm . there is a fence about 4 by 4 m around the robot arm with a safety gate and the control \
                 cabinet next to the fence .",
            ),
            ("a robot with a fence, a desk outside", "a robot with a fence , a desk next to the fence"),
            ("a garden with a fence and a gate", "a garden with a fence and a gate"),
            (
                "an assembly line with five work stations on one side and a stool at each. parts bins stand behind the \
                 workers, and finished stuff ends up on a packing table at the far end.",
                "an assembly line with a conveyor and five workstations in a row in front of the conveyor . there is a stool \
                 in front of each workstation . there is a part bin behind each stool . there is a packing table to the right of the \
                 conveyor .",
            ),
            (
                "a packing line with a belt and four tables on one side, a desk at the start of the line",
                "a packing line with a belt and four tables in a row in front of the belt , a desk to the left of the belt",
            ),
            ("five desks on one side and a stool", "five desks on one side and a stool"),
            (
                "two stands and a pegboard full of tools behind them.",
                "two stands and a pegboard behind them with tools .",
            ),
            ("a pegboard with tools on the left wall", "a pegboard on the left wall with tools"),
            ("a shelf full of tools", "a shelf holding tools"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
