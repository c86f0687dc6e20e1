//! Short ways to say what has been named already or goes without saying: "three lower ones", "the biggest painting", "the
//! sink facing the window", "1.2 m clear to the door", "lots of neon".

use super::lexicon::{get, plural, singular};
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};
use crate::brief::Group;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 30] = [
        ones,
        biggest,
        racks,
        sink,
        wall_side,
        right_hand,
        cleared,
        neon,
        under_seating,
        partitions,
        from_left,
        bears,
        unblocked,
        turned_to,
        door_on_wall,
        ship_bridge,
        stations,
        on_which,
        have_between,
        one_of_the_walls,
        for_people,
        stack,
        all_over,
        to_ceiling,
        mid_room,
        for_instance,
        long_side,
        narrow_bed,
        every_wall,
        pegs,
    ];
    turns.iter().any(|turn| turn(tokens, i))
}

/// "Bookcases along the walls, plus three lower double sided ones": three lower double-sided bookcases.
fn ones(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) == "double" && word(tokens, i + 1) == "sided" {
        put(tokens, i, i + 2, &["double-sided"]);
        return true;
    }
    let look = i > 0 && get().is_look(word(tokens, i - 1));
    let said = word(tokens, i) == "ones" && (look || word(tokens, i - 1) == "double-sided");
    let counted = said && (i.saturating_sub(4)..i).any(|k| super::quantified::number(tokens, k).is_some_and(|n| n > 1));
    if !counted {
        return false;
    }
    let stops = |k: &usize| !matches!(tokens[*k].kind, WordKind::Line);
    let named = (0..i).rev().take_while(stops).find_map(|k| {
        noun(tokens, k)
            .filter(|name| name.end <= i && plural(word(tokens, name.end - 1)) && word(tokens, name.end - 1) != "walls")
    });
    let Some(name) = named else { return false };
    // The whole name: "coffee tables", not "tables".
    let start = name.start.saturating_sub(2);
    let name = (start..=name.start).find_map(|k| noun(tokens, k).filter(|whole| whole.end == name.end)).unwrap_or(name);
    let words: Vec<String> = tokens[name].iter().map(|t| t.text.clone()).collect();
    // Lower than the others: low.
    for token in &mut tokens[i.saturating_sub(3)..i] {
        let plain = match token.text.as_str() {
            "lower" => "low",
            "smaller" => "small",
            "larger" => "large",
            "taller" => "tall",
            _ => continue,
        };
        plain.clone_into(&mut token.text);
    }
    put(tokens, i, i + 1, &words.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// "In front of the biggest painting", of five: one of the paintings.
fn biggest(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOST: [&str; 8] = ["biggest", "largest", "smallest", "tallest", "longest", "widest", "oldest", "nicest"];
    let said = word(tokens, i) == "the" && MOST.contains(&word(tokens, i + 1));
    let one = singular(word(tokens, i + 2));
    let is_many = |t: &Token| t.text != one && singular(&t.text) == one;
    if !said || get().noun(&one).is_none() || !ends(tokens, i + 3) || !tokens[..i].iter().any(is_many) {
        return false;
    }
    let many = scenelang_lang::nouns::plural(&one);
    put(tokens, i, i + 3, &["one", "of", "the", &many]);
    true
}

/// "A brochure stand beside it": a stand, and no brochure that stands there.
fn racks(tokens: &mut Vec<Token>, i: usize) -> bool {
    let article = matches!(word(tokens, i), "a" | "an" | "one");
    let one = word(tokens, i + 1);
    let said = article && word(tokens, i + 2) == "stand" && singular(one) == one && tokens[i + 1].word();
    // "A desk and a chair stand at the wall"; a "reception stand" is read elsewhere.
    let others = i > 0 && tokens[i - 1].is("and") || matches!(one, "display" | "reception") || get().is_look(one);
    // "A red stand mixer".
    let others = others || !(ends(tokens, i + 3) || get().relation(&tokens[i + 3..]).is_some_and(|(_, n)| n > 0));
    if said && !others && scenelang_lang::nouns::noun(&format!("{one} stand")).is_none() {
        put(tokens, i + 1, i + 3, &["display", "stand"]);
        return true;
    }
    false
}

/// "The sink facing the window": who stands at it faces the window, so the sink is under it.
fn sink(tokens: &mut Vec<Token>, i: usize) -> bool {
    const USED: [&str; 6] = ["sink", "hob", "stove", "cooker", "worktop", "countertop"];
    let faces = matches!(word(tokens, i), "facing" | "faces") && i > 0 && USED.contains(&word(tokens, i - 1));
    if !faces || !matches!(word(tokens, i + 1), "the" | "a") || word(tokens, i + 2) != "window" {
        return false;
    }
    let under: &[&str] = if word(tokens, i) == "faces" { &["is", "under"] } else { &["under"] };
    put(tokens, i, i + 1, under);
    true
}

/// "A bench on the wall side" of a table: on one side of it.
fn wall_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "on" && matches!(word(tokens, i + 1), "the" | "its");
    if !said || word(tokens, i + 2) != "wall" || word(tokens, i + 3) != "side" || !ends(tokens, i + 4) {
        return false;
    }
    put(tokens, i + 1, i + 4, &["one", "side"]);
    true
}

/// "The long right hand wall": the right wall.
fn right_hand(tokens: &mut Vec<Token>, i: usize) -> bool {
    let side = |k: usize| matches!(word(tokens, k), "left" | "right" | "left-hand" | "right-hand");
    let long = usize::from(matches!(word(tokens, i), "long" | "short"));
    let hand = usize::from(word(tokens, i + long + 1) == "hand");
    let hyphened = word(tokens, i + long).ends_with("-hand");
    let wall = matches!(word(tokens, i + long + 1 + hand), "wall" | "side" | "corner");
    if !side(i + long) || long + hand == 0 && !hyphened || !wall {
        return false;
    }
    let plain = word(tokens, i + long).trim_end_matches("-hand").to_owned();
    put(tokens, i, i + long + 1 + hand, &[&plain]);
    true
}

/// "At least 1.2 m clear all the way to the door": a path at least 1.2 m wide to the door.
fn cleared(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WAY: [&str; 6] = ["clear", "free", "space", "all", "the", "way"];
    if !matches!(word(tokens, i), "clear" | "free") || i < 2 {
        return false;
    }
    let end = (i..i + 7).find(|k| !WAY.contains(&word(tokens, *k))).unwrap_or(i);
    let to = matches!(word(tokens, end), "to" | "from") && matches!(word(tokens, end + 1), "the" | "a");
    // "At least" before the measure belongs to it.
    let Some((_, n)) = (1..=3).rev().find_map(|n| Some((n, n)).filter(|_| i >= n && is_measure(tokens, i - n, i)))
    else {
        return false;
    };
    let least = i >= n + 2 && word(tokens, i - n - 2) == "at" && word(tokens, i - n - 1) == "least";
    if !to {
        return false;
    }
    put(tokens, i, end, &["wide"]);
    let from = i - n - if least { 2 } else { 0 };
    let like = tokens[from].clone();
    let words = ["a", "path"].map(|text| like.saying(text));
    tokens.splice(from..from, words);
    true
}

/// Whether these tokens are a number and a unit of length.
fn is_measure(tokens: &[Token], from: usize, end: usize) -> bool {
    super::measure::measure(&tokens[from..end]).is_some_and(|(_, used)| used == end - from)
}

/// "Lots of neon": neon signs.
fn neon(tokens: &mut Vec<Token>, i: usize) -> bool {
    let lots = match [word(tokens, i), word(tokens, i + 1)] {
        ["lots" | "plenty", "of"] => 2,
        ["much" | "some", "neon"] => 1,
        _ => return false,
    };
    if word(tokens, i + lots) != "neon" || !ends(tokens, i + lots + 1) {
        return false;
    }
    put(tokens, i, i + lots + 1, &["three", "neon", "signs"]);
    true
}

/// "A rug under the seating": under the sofa, or the table that the seats stand around.
fn under_seating(tokens: &mut Vec<Token>, i: usize) -> bool {
    let under = matches!(word(tokens, i), "under" | "underneath" | "beneath");
    let seating = word(tokens, i + 1) == "the" && matches!(word(tokens, i + 2), "seating" | "seats");
    let group = usize::from(matches!(word(tokens, i + 3), "area" | "group"));
    if !under || !seating || !ends(tokens, i + 3 + group) {
        return false;
    }
    let table = tokens[..i].windows(2).any(|pair| pair[0].is("coffee") && pair[1].is("table"));
    let sofa = tokens[..i].iter().any(|t| t.is("sofa") || t.is("couch"));
    match () {
        () if sofa => put(tokens, i + 2, i + 3 + group, &["sofa"]),
        () if table => put(tokens, i + 2, i + 3 + group, &["coffee", "table"]),
        () => return false,
    }
    true
}

/// "Two freestanding partition walls": room dividers.
fn partitions(tokens: &mut Vec<Token>, i: usize) -> bool {
    let free = usize::from(matches!(word(tokens, i), "freestanding" | "free-standing" | "movable" | "mobile"));
    let walls = match [word(tokens, i + free), word(tokens, i + free + 1)] {
        ["partition" | "partitioning" | "dividing" | "divider", "walls"] => "dividers",
        ["partition" | "partitioning" | "dividing" | "divider", "wall"] => "divider",
        _ => return false,
    };
    put(tokens, i, i + free + 2, &["room", walls]);
    true
}

/// "From left to right: a bookcase, a lamp and a bench": said after them.
#[expect(clippy::ptr_arg, reason = "one of the turns")]
fn from_left(tokens: &mut Vec<Token>, i: usize) -> bool {
    let begins = i == 0 || tokens[i - 1].stops();
    let sides = matches!((word(tokens, i + 1), word(tokens, i + 3)), ("left", "right") | ("right", "left"));
    if !begins || word(tokens, i) != "from" || !sides || word(tokens, i + 2) != "to" {
        return false;
    }
    if !tokens.get(i + 4).is_some_and(|t| t.is(":") || t.is(",")) {
        return false;
    }
    let end = tokens[i + 5..].iter().position(Token::stops).map_or(tokens.len(), |n| i + 5 + n);
    // The sign between them goes along, as a word that says nothing.
    tokens[i + 4].kind = WordKind::Word;
    "there".clone_into(&mut tokens[i + 4].text);
    tokens[i..end].rotate_left(4);
    if let Some(there) = tokens.get_mut(i) {
        "are".clone_into(&mut there.text);
    }
    true
}

/// "The desk holds the lamp": the lamp stands on the desk.
fn bears(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(carrier) = definite(tokens, i) else { return false };
    let verb = carrier.end;
    let bears = matches!(word(tokens, verb), "carries" | "holds" | "supports" | "bears");
    let Some(load) = definite(tokens, verb + 1).filter(|load| bears && ends(tokens, load.end)) else { return false };
    let mut words: Vec<Token> = tokens[verb + 1..load.end].to_vec();
    let like = tokens[verb].clone();
    words.extend(["stands", "on"].map(|text| like.saying(text)));
    words.extend_from_slice(&tokens[i..verb]);
    tokens.splice(i..load.end, words);
    true
}

/// "The safe must not be blocked", "the cabinet must stay accessible": nothing blocks it.
fn unblocked(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SAID: [&[&str]; 8] = [
        &["must", "not", "be", "blocked"],
        &["should", "not", "be", "blocked"],
        &["must", "be", "kept", "clear"],
        &["must", "stay", "clear"],
        &["must", "remain", "clear"],
        &["must", "remain", "unobstructed"],
        &["is", "unobstructed"],
        &["is", "blocked", "by", "nothing"],
    ];
    let Some(name) = definite(tokens, i) else { return false };
    let is = |words: &&&[&str]| words.iter().enumerate().all(|(k, w)| word(tokens, name.end + k) == *w);
    let Some(said) = SAID.iter().find(is).filter(|said| ends(tokens, name.end + said.len())) else { return false };
    let kind = get().noun(&singular(word(tokens, name.end - 1)));
    if matches!(kind, Some(Group::Door | Group::Window)) {
        return false;
    }
    let like = tokens[i].clone();
    let mut words: Vec<Token> = ["nothing", "blocks"].map(|text| like.saying(text)).to_vec();
    words.extend_from_slice(&tokens[i..name.end]);
    tokens.splice(i..name.end + said.len(), words);
    true
}

/// "Turn the chest towards the bed": the chest faces the bed.
fn turned_to(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(name) = definite(tokens, i + 1).filter(|_| word(tokens, i) == "turn") else { return false };
    if !matches!(word(tokens, name.end), "towards" | "toward" | "to") || word(tokens, name.end + 1) != "the" {
        return false;
    }
    put(tokens, name.end, name.end + 1, &["faces"]);
    tokens.remove(i);
    true
}

/// "By the loading door on the short wall": the wall is that of the door, in a sentence of its own.
fn door_on_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    let near = match [word(tokens, i), word(tokens, i + 1)] {
        ["by" | "near" | "beside" | "facing", _] => 1,
        ["next", "to"] => 2,
        _ => return false,
    };
    let first = i + near + 1;
    let is_opening = |k: &usize| matches!(get().noun(word(tokens, *k)), Some(Group::Door | Group::Window));
    let last = (first..first + 3).find(is_opening).filter(|_| word(tokens, i + near) == "the");
    let Some(door) = last.map(|last| first..last + 1) else { return false };
    let at = door.end;
    let on = matches!(word(tokens, at), "on" | "in") && word(tokens, at + 1) == "the" && word(tokens, at + 3) == "wall";
    if !on || !ends(tokens, at + 4) {
        return false;
    }
    let end = tokens[at..].iter().position(Token::stops).map_or(tokens.len(), |n| at + n);
    let like = tokens[at].clone();
    let mut sentence = vec![Token { kind: WordKind::Sign('.'), ..like.saying(".") }, like.saying("the")];
    sentence.extend_from_slice(&tokens[door]);
    sentence.push(like.saying("is"));
    sentence.extend_from_slice(&tokens[at..at + 4]);
    tokens.splice(end..end, sentence);
    tokens.drain(at..at + 4);
    true
}

/// "The bridge of a cargo ship": a control room.
fn ship_bridge(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "the" | "a") && word(tokens, i + 1) == "bridge" && word(tokens, i + 2) == "of";
    let ship =
        |k: usize| word(tokens, k).ends_with("ship") || matches!(word(tokens, k), "vessel" | "spacecraft" | "ferry");
    let Some(end) = (i + 3..i + 7).find(|k| ship(*k)).filter(|_| said) else { return false };
    put(tokens, i, end + 1, &["a", "control", "room"]);
    true
}

/// "Four crew stations": workstations.
fn stations(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WHOSE: [&str; 7] = ["crew", "operator", "control", "navigation", "officer", "pilot", "work"];
    let last = match word(tokens, i + 1) {
        "station" => "workstation",
        "stations" => "workstations",
        _ => return false,
    };
    let said = WHOSE.contains(&word(tokens, i));
    if said {
        put(tokens, i, i + 2, &[last]);
    }
    said
}

/// "A desk next to which stands a lamp": with a lamp next to it.
fn on_which(tokens: &mut Vec<Token>, i: usize) -> bool {
    let n = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["on" | "above" | "under" | "below" | "behind" | "beside" | "near", "which", _] => 1,
        ["next", "to", "which"] => 2,
        ["in", "front", "of"] if word(tokens, i + 3) == "which" => 3,
        _ => return false,
    };
    let there = usize::from(word(tokens, i + n + 1) == "there");
    let verb = i + n + 1 + there;
    let is = matches!(word(tokens, verb), "is" | "stands" | "hangs" | "sits" | "lies");
    let article = is && matches!(word(tokens, verb + 1), "a" | "an" | "one");
    let Some(what) = noun(tokens, verb + 2).filter(|what| article && ends(tokens, what.end)) else { return false };
    let like = tokens[i].clone();
    let mut words = vec![like.saying("with")];
    words.extend_from_slice(&tokens[verb + 1..what.end]);
    words.extend_from_slice(&tokens[i..i + n]);
    words.push(like.saying("it"));
    let comma = usize::from(i > 0 && tokens[i - 1].is(","));
    tokens.splice(i - comma..what.end, words);
    true
}

/// "The bed and the chest have a lamp between them": a lamp is between the bed and the chest.
fn have_between(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(first) = definite(tokens, i).filter(|first| word(tokens, first.end) == "and") else { return false };
    let Some(second) = definite(tokens, first.end + 1) else { return false };
    let have = second.end;
    let article = word(tokens, have) == "have" && matches!(word(tokens, have + 1), "a" | "an" | "one");
    let Some(what) = noun(tokens, have + 2).filter(|_| article) else { return false };
    if word(tokens, what.end) != "between" || word(tokens, what.end + 1) != "them" || !ends(tokens, what.end + 2) {
        return false;
    }
    let like = tokens[have].clone();
    let mut words: Vec<Token> = tokens[have + 1..what.end].to_vec();
    words.extend(["is", "between"].map(|text| like.saying(text)));
    words.extend_from_slice(&tokens[i..second.end]);
    tokens.splice(i..what.end + 2, words);
    true
}

/// "In one of the corners", "against one of the walls": in a corner, against a wall.
fn one_of_the_walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "one" && word(tokens, i + 1) == "of" && word(tokens, i + 2) == "the";
    let one = match word(tokens, i + 3) {
        "corners" => "corner",
        "walls" => "wall",
        _ => return false,
    };
    let at = i > 0 && matches!(word(tokens, i - 1), "in" | "against" | "on" | "along" | "at");
    if said && at {
        put(tokens, i, i + 4, &["a", one]);
    }
    said && at
}

/// "An office for twelve people, desks in pairs": twelve desks.
fn for_people(tokens: &mut Vec<Token>, i: usize) -> bool {
    let grouped = word(tokens, i) == "desks" && word(tokens, i + 1) == "in" && word(tokens, i + 2) == "pairs";
    let counted = i > 0
        && (tokens[i - 1].word() || matches!(tokens[i - 1].kind, WordKind::Number(_)))
        && !matches!(word(tokens, i - 1), "and" | "with");
    if !grouped || counted {
        return false;
    }
    let people = (0..i).find_map(|k| {
        let (_, used) = super::number::count(&tokens[k + 1..]).filter(|_| word(tokens, k) == "for")?;
        let who = word(tokens, k + 1 + used);
        matches!(who, "people" | "employees" | "persons" | "colleagues" | "workers")
            .then(|| tokens[k + 1..k + 1 + used].to_vec())
    });
    let Some(people) = people else { return false };
    let at = tokens[i].at.clone();
    tokens.splice(i..i, people.into_iter().map(|t| Token { at: at.clone(), ..t }));
    true
}

/// "A barrel stack", "a stack of barrels": three barrels.
fn stack(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "a" | "one") {
        return false;
    }
    let (name, end) = match [word(tokens, i + 1), word(tokens, i + 2)] {
        ["stack" | "pile", "of"] => (i + 3, i + 4),
        [_, "stack" | "pile"] => (i + 1, i + 3),
        _ => return false,
    };
    let one = singular(word(tokens, name));
    const STACKED: [&str; 8] = ["barrel", "crate", "box", "pallet", "tire", "tyre", "log", "sack"];
    if !STACKED.contains(&one.as_str()) || !ends(tokens, end) && get().relation(&tokens[end..]).is_none() {
        return false;
    }
    let many = scenelang_lang::nouns::plural(&one);
    put(tokens, i, end, &["three", &many]);
    true
}

/// "Clothes all over the floor": six of them on the floor.
fn all_over(tokens: &mut Vec<Token>, i: usize) -> bool {
    let what = word(tokens, i);
    let many = plural(what) && noun(tokens, i).is_some_and(|name| name.end == i + 1);
    if !many && what != "clothes" {
        return false;
    }
    let lie = usize::from(matches!(word(tokens, i + 1), "scattered" | "strewn" | "thrown" | "lying" | "everywhere"));
    let all = usize::from(word(tokens, i + 1 + lie) == "all");
    let over = i + 1 + lie + all;
    let floor = word(tokens, over) == "over"
        && word(tokens, over + 1) == "the"
        && matches!(word(tokens, over + 2), "floor" | "place" | "room");
    let counted = i > 0 && super::quantified::number(tokens, i - 1).is_some();
    if !floor || lie + all == 0 || counted || !ends(tokens, over + 3) {
        return false;
    }
    let name = if what == "clothes" { "shirts" } else { what }.to_owned();
    put(tokens, i, over + 3, &["six", &name, "on", "the", "floor"]);
    true
}

/// "Shelves up to the ceiling": floor-to-ceiling shelves.
fn to_ceiling(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(name) = noun(tokens, i) else { return false };
    let reach = usize::from(matches!(word(tokens, name.end), "that" | "which"));
    let reach = reach
        + usize::from(matches!(word(tokens, name.end + reach), "reach" | "reaches" | "reaching" | "going" | "go"));
    let to = name.end + reach + usize::from(matches!(word(tokens, name.end + reach), "right" | "all"));
    let up = matches!(word(tokens, to), "up") && word(tokens, to + 1) == "to" || reach > 0 && word(tokens, to) == "to";
    let ceiling = to + if word(tokens, to) == "up" { 2 } else { 1 };
    if !up || word(tokens, ceiling) != "the" || word(tokens, ceiling + 1) != "ceiling" {
        return false;
    }
    let look = tokens[ceiling].saying("floor-to-ceiling");
    tokens.drain(name.end..ceiling + 2);
    tokens.insert(name.start, look);
    true
}

/// "A cart mid-aisle": in the middle of the room.
fn mid_room(tokens: &mut Vec<Token>, i: usize) -> bool {
    if i == 0 || !matches!(word(tokens, i), "mid-aisle" | "mid-room" | "mid-floor" | "midroom") {
        return false;
    }
    put(tokens, i, i + 1, &["in", "the", "middle", "of", "the", "room"]);
    true
}

/// "Some clutter is welcome, for instance a suitcase": a suitcase.
fn for_instance(tokens: &mut Vec<Token>, i: usize) -> bool {
    let example = matches!(
        [word(tokens, i), word(tokens, i + 1)],
        ["for", "instance" | "example"] | ["such", "as"] | ["say", "a" | "an" | "some"]
    );
    let comma = i > 0 && tokens[i - 1].is(",");
    let general =
        (i.saturating_sub(8)..i).find(|k| matches!(word(tokens, *k), "clutter" | "mess" | "props" | "untidiness"));
    let Some(at) = general.filter(|_| example && comma) else { return false };
    let begins = (0..at).rev().find(|k| !tokens[*k].word()).map_or(0, |k| k + 1);
    let end = if word(tokens, i) == "say" { i + 1 } else { i + 2 };
    put(tokens, begins, end, &["there", "are"]);
    true
}

/// "Windows along one long side": along one long wall. Chairs are at a side of their table.
fn long_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let before = i.checked_sub(1).map_or("", |k| word(tokens, k));
    if !matches!(get().noun(&singular(before)), Some(Group::Window | Group::Door)) {
        return false;
    }
    let at = matches!(word(tokens, i), "along" | "on" | "at" | "down");
    let one = matches!(word(tokens, i + 1), "one" | "the" | "a" | "each");
    let long = matches!(word(tokens, i + 2), "long" | "longer" | "short" | "shorter");
    if !at || !one || !long || word(tokens, i + 3) != "side" || !ends(tokens, i + 4) {
        return false;
    }
    put(tokens, i + 3, i + 4, &["wall"]);
    true
}

/// "A narrow bed": for one.
fn narrow_bed(tokens: &mut Vec<Token>, i: usize) -> bool {
    let is_bed = matches!(word(tokens, i + 1), "bed" | "beds");
    if !matches!(word(tokens, i), "narrow" | "straw" | "camp") || !is_bed {
        return false;
    }
    put(tokens, i, i + 1, &["single"]);
    true
}

/// "Shelves on every wall": one against each.
fn every_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some(name) = noun(tokens, i) else { return false };
    let many = plural(word(tokens, name.end - 1)) && (i == 0 || super::quantified::number(tokens, i - 1).is_none());
    let at = name.end;
    let on = matches!(word(tokens, at), "on" | "along" | "against") && matches!(word(tokens, at + 1), "every" | "each");
    let stands =
        matches!(get().noun(&singular(word(tokens, name.end - 1))), Some(Group::Storage | Group::Seat | Group::Table));
    if !many || !on || word(tokens, at + 2) != "wall" || !stands {
        return false;
    }
    let one: Vec<String> = tokens[name.clone()].iter().map(|t| singular(&t.text)).collect();
    // Shelves and cabinets line the walls: two on each.
    let lines = get().noun(&singular(word(tokens, name.end - 1))) == Some(Group::Storage);
    let mut words: Vec<String> = vec![if lines { "eight" } else { "four" }.to_owned()];
    words.extend(tokens[name.clone()].iter().map(|t| t.text.clone()));
    const NTH: [&str; 8] = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"];
    let walls = ["left", "right", "back", "front"].into_iter().cycle();
    for (nth, wall) in NTH.into_iter().zip(walls).take(if lines { 8 } else { 4 }) {
        words.extend([".", "the", nth].map(str::to_owned));
        words.extend(one.iter().cloned());
        words.extend(["stands", "against", "the", wall, "wall"].map(str::to_owned));
    }
    let comma = tokens.get(at + 3).is_some_and(|t| t.is(","));
    words.extend(comma.then(|| ".".to_owned()));
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    put(tokens, name.start, at + 3 + usize::from(comma), &words);
    for token in tokens[name.start..].iter_mut().take(words.len()).filter(|token| token.text == ".") {
        token.kind = WordKind::Sign('.');
    }
    true
}

/// "Coat pegs by the door": a coat rack on the wall.
fn pegs(tokens: &mut Vec<Token>, i: usize) -> bool {
    let coat = matches!(word(tokens, i), "coat" | "clothes") && word(tokens, i + 1) == "pegs";
    if !coat {
        return false;
    }
    put(tokens, i, i + 2, &["a", "coat", "hook", "rail"]);
    true
}

/// The noun after "the" that begins here.
fn definite(tokens: &[Token], i: usize) -> Option<std::ops::Range<usize>> {
    noun(tokens, i + 1).filter(|_| word(tokens, i) == "the")
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn what_is_said_in_short_is_said_in_full() {
        for (text, becomes) in [
            (
                "bookcases along both walls, plus three lower double sided ones in the centre",
                "bookcases along both walls , plus three low double-sided bookcases in the centre",
            ),
            (
                "five paintings. a bench before the biggest painting.",
                "five paintings . a bench before one of the paintings .",
            ),
            ("a bench before the biggest painting.", "a bench before the biggest painting ."),
            ("a desk with a brochure stand beside it", "a desk with a display stand beside it"),
            ("a plant stand beside it", "a plant stand beside it"),
            ("a red stand mixer and a fruit stand mixer", "a red stand mixer and a fruit stand mixer"),
            ("a kitchen with the sink facing the window.", "a kitchen with the sink under the window ."),
            ("a table with a bench on the wall side.", "a table with a bench on one side ."),
            ("three pictures on the long right-hand wall", "three pictures on the right wall"),
            ("a desk on the left hand side of the bed", "a desk on the left side of the bed"),
            (
                "a bed, and at least 1.2 m clear all the way to the bathroom door.",
                "a bed , and a path at least 1.2 m wide to the bathroom door .",
            ),
            ("a bar, lots of neon.", "a bar , three neon signs ."),
            ("a coffee table. a rug under the seating.", "a coffee table . a rug under the coffee table ."),
            ("from left to right: a desk, a lamp and a bench.", "are a desk , a lamp and a bench from left to right ."),
            ("the desk holds the lamp.", "the lamp stands on the desk ."),
            ("the safe must not be blocked.", "nothing blocks the safe ."),
            ("the door must be kept clear.", "the door must be kept clear ."),
            ("turn the chest towards the bed", "the chest faces the bed"),
            (
                "two forklifts parked by the loading door on the short wall, and ten boxes. a lamp",
                "two forklifts parked by the loading door , and ten boxes . the loading door is on the short wall . a lamp",
            ),
            ("the bridge of a cargo ship with four crew stations", "a control room with four workstations"),
            ("a desk, next to which stands a lamp.", "a desk with a lamp next to it ."),
            ("a desk on which there is a lamp", "a desk with a lamp on it"),
            ("the bed and the chest have a lamp between them.", "a lamp is between the bed and the chest ."),
            ("a plant in one of the corners", "a plant in a corner"),
            ("an office for twelve people, desks in pairs", "an office for twelve people , twelve desks in pairs"),
            ("a barrel stack and a stack of crates by the door", "three barrels and three crates by the door"),
            ("drying shelves up to the ceiling.", "floor-to-ceiling drying shelves ."),
            ("a bookcase that reaches to the ceiling", "a floor-to-ceiling bookcase"),
            ("one cart mid-aisle", "one cart in the middle of the room"),
            (
                "some clutter is welcome, for instance an open suitcase and a towel on the floor.",
                "there are an open suitcase and a towel on the floor .",
            ),
            ("windows along one long side.", "windows along one long wall ."),
            (
                "shelves on every wall, a cart",
                "eight shelves . the first shelf stands against the left wall . the second shelf stands against \
                 the right wall . the third shelf stands against the back wall . the fourth shelf stands against \
                 the front wall . the fifth shelf stands against the left wall . the sixth shelf stands against \
                 the right wall . the seventh shelf stands against the back wall . the eighth shelf stands \
                 against the front wall . a cart",
            ),
            ("coat pegs by the door", "a coat hook rail by the door"),
            ("a narrow bed, straw beds", "a single bed , single beds"),
            ("a messy bedroom, clothes all over the floor", "a messy bedroom , six shirts on the floor"),
            ("books scattered all over the place.", "six books on the floor ."),
            ("a lamp over the floor", "a lamp over the floor"),
            ("two partition walls. a desk", "two room dividers . a desk"),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
