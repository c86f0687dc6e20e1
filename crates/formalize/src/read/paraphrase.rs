//! Ways of saying things that are turned into another way before anything is read: "no two plants closer than 1 m" are
//! "plants at least 1 m apart". Every word that is left is where it was, so that it is accounted for.

use super::lexicon::{get, singular};
use super::meant;
use super::token::{Token, WordKind};

/// Turns what can be said more plainly. Shared words keep their places in the request.
pub fn plain(tokens: &mut Vec<Token>) {
    let mut i = 0;
    // No text becomes so much longer: whatever rules make of it, reading ends.
    let most = 8 * tokens.len() + 500;
    while i < tokens.len() && tokens.len() < most {
        let turns: [fn(&mut Vec<Token>, usize) -> bool; 82] = [
            super::work::plain,
            super::spelling::plain,
            super::lines::plain,
            super::shorthand::plain,
            super::above::plain,
            super::walkways::plain,
            super::compounds::plain,
            super::activities::plain,
            super::amounts::plain,
            super::whereabouts::plain,
            super::palette::plain,
            super::beyond::plain,
            super::denied::plain,
            super::asides::plain,
            super::annexes::plain,
            super::each_with::plain,
            super::free_floor::plain,
            super::desks::plain,
            super::doors::plain,
            super::aisles::plain,
            super::wheeled::plain,
            opposite_wall,
            super::loose::plain,
            super::compass::plain,
            super::opening::plain,
            super::fronted::plain,
            super::seated::plain,
            super::sight::plain,
            apart,
            together,
            each_other,
            carried,
            passes,
            that_one,
            seats,
            stools,
            sleepers,
            purpose,
            opposite,
            opens,
            extends,
            walls,
            distance,
            meant::walls,
            meant::ring,
            meant::basement,
            meant::nurse_station,
            meant::with_children,
            meant::group_tables,
            meant::horseshoe_table,
            meant::barrel_tables,
            meant::vehicles,
            meant::tested,
            meant::garage_for,
            meant::under_mirror,
            meant::studio_bathroom,
            meant::guest_toilets,
            meant::audience,
            meant::window_counter,
            meant::counter_seats,
            meant::school_lab,
            meant::sells,
            meant::covers,
            meant::seating,
            meant::family,
            meant::kitchen_diner,
            meant::doubles,
            meant::walk_in,
            meant::docks,
            meant::weights,
            meant::teams,
            meant::whose,
            meant::bedrooms,
            meant::reception,
            meant::separated,
            meant::in_building,
            meant::chairs_with_tables,
            meant::practice_rooms,
            meant::bed_sizes,
            meant::kitchen_units,
            meant::bar_of_restaurant,
            meant::bank,
        ];
        let _turned = turns.iter().any(|turn| turn(tokens, i))
            || super::areas::before_rooms(tokens, i)
            || super::taken_back::plain(tokens, i)
            || super::homes::plain(tokens, i)
            || super::goods::plain(tokens, i)
            || super::contents::plain(tokens, i)
            || super::shares::plain(tokens, i)
            || super::which::plain(tokens, i)
            || super::resumed::plain(tokens, i)
            || super::quantified::plain(tokens, i);
        i += 1;
    }
}

/// What a text is turned into.
#[cfg(test)]
pub(super) fn plainly(text: &str) -> String {
    let mut tokens = super::token::tokens(text, 100).0;
    plain(&mut tokens);
    tokens.iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ")
}

pub(super) fn word(tokens: &[Token], i: usize) -> &str {
    tokens.get(i).filter(|t| t.word()).map_or("", |t| t.text.as_str())
}

/// Whether a clause ends before this token.
pub(super) fn ends(tokens: &[Token], i: usize) -> bool {
    tokens
        .get(i)
        .is_none_or(|t| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ',' | ';' | '!' | '?')) || t.is("and"))
}

/// Puts words in the place of others, where these stood.
pub(super) fn put(tokens: &mut Vec<Token>, from: usize, to: usize, words: &[&str]) {
    let (Some(first), Some(last)) = (tokens.get(from), tokens.get(to - 1)) else { return };
    let at = first.at.start..last.at.end;
    let new = |text: &&str| Token {
        kind: WordKind::Word,
        text: (*text).to_owned(),
        at: at.clone(),
        owner: false,
        capital: false,
    };
    tokens.splice(from..to, words.iter().map(new).collect::<Vec<_>>());
}

/// The most words between "no two" and "closer".
const FAR: usize = 8;

/// "No two plants may be closer to each other than 1 m": "plants at least 1 m apart".
fn apart(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "no" || word(tokens, i + 1) != "two" {
        return false;
    }
    let Some(closer) = (i + 3..i + 3 + FAR).find(|k| matches!(word(tokens, *k), "closer" | "nearer")) else {
        return false;
    };
    // Nothing but a verb stands between the things and "closer".
    let verb = |k: &usize| {
        matches!(word(tokens, *k), "may" | "should" | "must" | "can" | "shall" | "are" | "is" | "be" | "stand" | "sit")
    };
    let Some(first) = (i + 3..=closer).find(|k| *k == closer || verb(k)) else { return false };
    let Some(than) = (closer + 1..closer + 5).find(|k| word(tokens, *k) == "than") else { return false };
    let among = tokens[closer + 1..than]
        .iter()
        .all(|t| matches!(t.text.as_str(), "to" | "together" | "each" | "other" | "one" | "another"));
    let Some(number) = tokens.get(than + 1).filter(|t| matches!(t.kind, WordKind::Number(_)) || t.word()) else {
        return false;
    };
    let unit = than + 2;
    let joined = super::number::unit(&number.text).is_some();
    if !(first..closer).all(|k| verb(&k)) || !among || super::number::unit(word(tokens, unit)).is_none() && !joined {
        return false;
    }
    let end = if joined { unit } else { unit + 1 };
    let after = if word(tokens, end) == "apart" { end + 1 } else { end };
    if !ends(tokens, after) {
        return false;
    }
    if after == end {
        put(tokens, end - 1, end, &[tokens[end - 1].text.clone().as_str(), "apart"]);
    }
    put(tokens, first, than + 1, &["at", "least"]);
    tokens.drain(i..i + 2);
    true
}

/// The tokens of a length that begins here: "2 m", "two metres", "a metre".
fn length(tokens: &[Token], i: usize) -> Option<usize> {
    super::number::length(tokens.get(i..)?).map(|(_, used)| used)
}

/// How many words say that it is among themselves: "each other", "one another".
fn one_another(tokens: &[Token], i: usize) -> Option<usize> {
    matches!((word(tokens, i), word(tokens, i + 1)), ("each", "other") | ("one", "another")).then_some(2)
}

/// "No closer than 2 m together", "not nearer to each other than 2 m": "at least 2 m apart".
fn together(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "no" | "not" | "never") || !matches!(word(tokens, i + 1), "closer" | "nearer") {
        return false;
    }
    let among = |k: usize| match word(tokens, k) {
        "together" => Some(1),
        "to" | "from" => one_another(tokens, k + 1).map(|n| n + 1),
        _ => None,
    };
    let before = among(i + 2).unwrap_or(0);
    let than = i + 2 + before;
    if word(tokens, than) != "than" {
        return false;
    }
    let Some(used) = length(tokens, than + 1) else { return false };
    let end = than + 1 + used;
    let after = among(end).unwrap_or(0);
    if before + after == 0 {
        return false;
    }
    let unit = tokens[end - 1].text.clone();
    put(tokens, end - 1, end + after, &[unit.as_str(), "apart"]);
    put(tokens, i, than + 1, &["at", "least"]);
    true
}

/// "Two metres from one another": "two metres apart".
fn each_other(tokens: &mut Vec<Token>, i: usize) -> bool {
    let away = usize::from(word(tokens, i) == "away");
    if i == 0 || word(tokens, i + away) != "from" || super::number::unit(word(tokens, i - 1)).is_none() {
        return false;
    }
    let Some(n) = one_another(tokens, i + away + 1) else { return false };
    put(tokens, i, i + away + 1 + n, &["apart"]);
    true
}

/// "A cabinet on which a radio is kept": "a cabinet with a radio on top".
fn carried(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 10;
    if word(tokens, i) != "on" || word(tokens, i + 1) != "which" {
        return false;
    }
    let held = |k: &usize| {
        matches!(
            word(tokens, *k),
            "kept"
                | "placed"
                | "displayed"
                | "stored"
                | "stand"
                | "stands"
                | "sit"
                | "sits"
                | "lie"
                | "lies"
                | "rest"
                | "rests"
        )
    };
    let within = (i + 3..i + FAR).take_while(|k| tokens.get(*k).is_some_and(|t| t.word() || t.is(",")));
    let Some(last) = within.into_iter().find(held) else { return false };
    let first = last - usize::from(matches!(word(tokens, last - 1), "is" | "are"));
    put(tokens, first, last + 1, &["on", "top"]);
    put(tokens, i, i + 2, &["with"]);
    true
}

/// "You get from the hall to the kitchen through a wide door", "one enters the kitchen from the hall through a door":
/// "a door leads from the hall to the kitchen".
fn passes(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 14;
    let who = matches!(word(tokens, i), "you" | "one" | "we" | "people" | "guests" | "they" | "everyone" | "i");
    let enters = matches!(word(tokens, i + 1), "enter" | "enters" | "reach" | "reaches" | "access" | "accesses");
    let goes = matches!(
        word(tokens, i + 1),
        "get" | "gets" | "go" | "goes" | "come" | "comes" | "walk" | "walks" | "pass" | "passes" | "step" | "steps"
    );
    if !who || !(enters || goes) {
        return false;
    }
    let inside = |k: &usize| tokens.get(*k).is_some_and(Token::word);
    let clause: Vec<usize> = (i + 2..i + 2 + FAR).take_while(inside).collect();
    let find = |words: &[&str]| clause.iter().copied().find(|k| words.contains(&word(tokens, *k)));
    let (Some(from), Some(by)) = (find(&["from"]), find(&["through", "via", "by"])) else { return false };
    let to = find(&["to", "into"]);
    let named = |from: usize, to: usize| (from < to && to - from <= 4).then_some(from..to);
    let (source, target) = match to {
        Some(to) if from < to => (named(from + 1, to), named(to + 1, by)),
        Some(to) => (named(from + 1, by), named(to + 1, from)),
        None if enters => (named(from + 1, by), named(i + 2, from)),
        None => return false,
    };
    let (Some(source), Some(target)) = (source, target) else { return false };
    let door: Vec<usize> = clause.iter().copied().filter(|k| *k > by).collect();
    let is_door = |k: &usize| matches!(get().noun(&singular(word(tokens, *k))), Some(crate::brief::Group::Door));
    let Some(last) = door.iter().copied().find(is_door) else { return false };
    let text = |range: std::ops::Range<usize>| tokens[range].iter().map(|t| t.text.clone()).collect::<Vec<_>>();
    let mut said = text(by + 1..last + 1);
    said.extend(["leads".to_owned(), "from".to_owned()]);
    said.extend(text(source));
    said.push("to".to_owned());
    said.extend(text(target));
    let said: Vec<&str> = said.iter().map(String::as_str).collect();
    put(tokens, i, last + 1, &said);
    true
}

/// "Three shelves. The middle one …": the middle shelf.
fn that_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BACK: usize = 60;
    const MIDDLE: [&str; 4] = ["one", "in", "the", "middle"];
    if (0..MIDDLE.len()).all(|k| word(tokens, i + k) == MIDDLE[k]) && i > 0 && word(tokens, i - 1) == "the" {
        put(tokens, i, i + MIDDLE.len(), &["middle", "one"]);
    }
    let which = matches!(word(tokens, i), "first" | "second" | "third" | "fourth" | "fifth" | "last" | "middle");
    if !which || i == 0 || word(tokens, i - 1) != "the" || word(tokens, i + 1) != "one" {
        return false;
    }
    let several = |t: &&Token| {
        let one = singular(&t.text);
        t.word() && !t.owner && one != t.text && get().noun(&one).is_some()
    };
    let Some(noun) = tokens[i.saturating_sub(BACK)..i].iter().rev().find(several).map(|t| singular(&t.text)) else {
        return false;
    };
    put(tokens, i + 1, i + 2, &[noun.as_str()]);
    true
}

/// "A table that seats eight": "a table for eight".
fn seats(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "A bar and seating for twenty": for twenty.
    let goes_on = word(tokens, i) == "seating" && word(tokens, i + 1) == "for";
    let lists = |t: &Token| t.is("and") || t.is("with") || t.is(",");
    // "Comfortable seating", "outdoor-style seating": a word or two may say how it is.
    let from = (1..=3).filter_map(|back| i.checked_sub(back)).find(|at| lists(&tokens[*at]));
    let from = from.filter(|at| *at > 0 && tokens[*at + 1..i].iter().all(|t| get().noun(&t.text).is_none()));
    let counted = super::number::count(&tokens[(i + 2).min(tokens.len())..]).is_some();
    if let Some(from) = from.filter(|_| goes_on && counted) {
        put(tokens, from, i + 2, &["for"]);
        return true;
    }
    let that = usize::from(matches!(word(tokens, i), "that" | "which"));
    let verb = word(tokens, i + that);
    let counts = i > 0 && super::number::count(&tokens[(i + that + 1).min(tokens.len())..]).is_some();
    let said = counts && (that == 1 && matches!(verb, "seats" | "seat") || that == 0 && verb == "seating");
    if said {
        put(tokens, i, i + that + 1, &["for"]);
    }
    said
}

/// "A counter for eight": a bar counter and eight bar stools.
fn stools(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "counter" | "bar") || word(tokens, i + 1) != "for" || i == 0 {
        return false;
    }
    let Some((_, used)) = super::number::count(&tokens[i + 2..]) else { return false };
    let last = i + 2 + used;
    let people = usize::from(matches!(word(tokens, last), "people" | "persons" | "guests" | "customers"));
    if used != 1 || !ends(tokens, last + people) {
        return false;
    }
    let stools =
        ["bar", "stools"].map(|text| Token { text: text.to_owned(), kind: WordKind::Word, ..tokens[last - 1].clone() });
    tokens.splice(last..last + people, stools);
    put(tokens, i + 1, i + 2, &["and"]);
    put(tokens, i, i + 1, &["bar", "counter"]);
    true
}

/// "A bedroom for a teenage gamer" is a teen bedroom, "a room for two kids" a kids bedroom for two.
fn sleepers(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WHO: [(&str, &[&str]); 3] = [
        ("kids", &["child", "children", "kid", "kids", "toddler", "toddlers", "boy", "girl"]),
        ("teen", &["teenage", "teenager", "teen", "teenagers", "gamer"]),
        ("baby", &["baby", "newborn", "infant"]),
    ];
    if !matches!(word(tokens, i), "bedroom" | "room") || word(tokens, i + 1) != "for" {
        return false;
    }
    let kind_of = |k: usize| WHO.iter().find(|(_, who)| who.contains(&word(tokens, k))).map(|(kind, _)| *kind);
    let one = matches!(word(tokens, i + 2), "a" | "an" | "my" | "our" | "the");
    let few = matches!(word(tokens, i + 2), "two" | "three");
    let first = i + 2 + usize::from(one || few);
    let Some(kind) = kind_of(first) else { return false };
    // "A newborn baby", "a teenage gamer".
    let last = if kind_of(first + 1).is_some() { first + 1 } else { first };
    let is_said = i > 0 && word(tokens, i - 1) == kind;
    if is_said || (!ends(tokens, last + 1) && word(tokens, last + 1) != "with") {
        return false;
    }
    put(tokens, i, if few { i + 1 } else { last + 1 }, &[kind, "bedroom"]);
    true
}

/// "A workshop for bicycle repair" is a bicycle repair workshop, "a room for meetings" a meeting room.
fn purpose(tokens: &mut Vec<Token>, i: usize) -> bool {
    const MOST: usize = 3;
    let noun = word(tokens, i).to_owned();
    if !matches!(noun.as_str(), "room" | "studio" | "workshop" | "shop" | "store") || word(tokens, i + 1) != "for" {
        return false;
    }
    let said = (1..=MOST).rev().find_map(|n| {
        let after = i + 2 + n;
        let whole = ends(tokens, after) || word(tokens, after) == "with";
        let mut what: Vec<String> = (i + 2..after).map(|k| word(tokens, k).to_owned()).collect();
        let last = what.last_mut().filter(|_| whole)?;
        *last = singular(last);
        what.push(noun.clone());
        get().room(&what.join(" ")).map(|_| (after, what))
    });
    let Some((after, name)) = said else { return false };
    put(tokens, i, after, &name.iter().map(String::as_str).collect::<Vec<_>>());
    true
}

/// "The sofa against the wall and the television opposite": opposite it.
fn opposite(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "opposite" && i > 1 && ends(tokens, i + 1) && tokens[i - 1].word();
    // "the opposite", "directly opposite" and "the one opposite" are of something else.
    let said = said && !matches!(word(tokens, i - 1), "the" | "an" | "one" | "directly" | "right");
    if said {
        let what = before(tokens, i).or_else(|| at_wall(tokens, i)).unwrap_or_default();
        put(tokens, i, i + 1, &["opposite", if what.is_empty() { "it" } else { "the" }]);
        tokens.splice(i + 2..i + 2, what);
    }
    said
}

/// "Eight washers, six dryers on the opposite wall": the washers are along one wall. "A window and a bed on the opposite wall": on
/// the wall opposite the window.
fn opposite_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "Washers on one wall and dryers on the other".
    let on = matches!(word(tokens, i), "on" | "along" | "at" | "against");
    let other = on && word(tokens, i + 1) == "the" && word(tokens, i + 2) == "other";
    let one = |k: usize| word(tokens, k) == "one" && word(tokens, k + 1) == "wall";
    let goes_on = ends(tokens, i + 3) || matches!(word(tokens, i + 3), "with" | "and");
    // "A screen on the short wall and a board on the wall opposite".
    let opposite =
        on && word(tokens, i + 1) == "the" && word(tokens, i + 2) == "wall" && word(tokens, i + 3) == "opposite";
    let wall = tokens[..i].iter().rev().take(14).take_while(|t| !t.is(".")).any(|t| t.is("wall"));
    if opposite && ends(tokens, i + 4) && wall {
        put(tokens, i + 2, i + 4, &["opposite", "wall"]);
        return true;
    }
    if other && goes_on && (i.saturating_sub(12)..i).any(one) {
        put(tokens, i + 2, i + 3, &["opposite", "wall"]);
        return true;
    }
    let at = matches!(word(tokens, i), "on" | "along" | "at" | "against");
    let said = at && matches!(word(tokens, i + 1), "the" | "an") && word(tokens, i + 2) == "opposite";
    if !said || word(tokens, i + 3) != "wall" || word(tokens, i + 4) == "of" {
        return false;
    }
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | ';' | ':'));
    let from = tokens[..i].iter().rposition(stops).map_or(0, |n| n + 1);
    if tokens[from..i].iter().any(|t| t.is("wall") || t.is("walls") || t.is("side")) {
        return false;
    }
    // The list has a thing before this one, and nothing says yet where that is.
    let Some(mut join) = (from..i).rev().find(|k| tokens[*k].is(",") || tokens[*k].is("and")) else { return false };
    if join > from && tokens[join].is("and") && tokens[join - 1].is(",") {
        join -= 1;
    }
    let name = |k: &usize| super::shares::noun(tokens, *k).is_some_and(|noun| noun.end == join);
    let Some(first) = (from.max(join.saturating_sub(6))..join).find(name) else { return false };
    let noun: Vec<String> = tokens[first..join].iter().map(|t| singular(&t.text)).collect();
    if noun.last().is_some_and(|last| matches!(last.as_str(), "window" | "door" | "entrance")) {
        let the: Vec<&str> =
            ["on", "the", "wall", "opposite", "the"].into_iter().chain(noun.iter().map(String::as_str)).collect();
        put(tokens, i, i + 4, &the);
        return true;
    }
    let many = first > from && super::quantified::number(tokens, first - 1).is_some_and(|n| n > 1);
    if many {
        let own = tokens[join - 1].clone();
        let words = ["along", "one", "wall"].map(|text| Token { text: text.to_owned(), ..own.clone() });
        tokens.splice(join..join, words);
    }
    many
}

/// "A bed against the left wall … a wardrobe opposite": what a sentence before said to be at a wall.
fn at_wall(tokens: &[Token], i: usize) -> Option<Vec<Token>> {
    let sentence = (0..i).rev().find(|k| tokens[*k].is("."))?;
    let at = |k: &usize| {
        matches!(word(tokens, *k), "against" | "along" | "on" | "at")
            && (k + 2..k + 4).any(|wall| word(tokens, wall) == "wall")
    };
    let wall = (0..sentence).rev().find(at)?;
    let name =
        (wall.saturating_sub(4)..wall).find_map(|k| super::shares::noun(tokens, k).filter(|name| name.end == wall))?;
    (singular(&tokens[wall - 1].text) == tokens[wall - 1].text).then(|| tokens[name].to_vec())
}

/// "Chairs in front of mirrors and a bench opposite": opposite the mirrors, at which the chairs look.
fn before(tokens: &[Token], i: usize) -> Option<Vec<Token>> {
    const BETWEEN: usize = 4;
    let front = (0..i).rev().take_while(|k| !tokens[*k].is(".")).find(|k| word(tokens, *k) == "front")?;
    let from = front + 2 + usize::from(matches!(word(tokens, front + 2), "the" | "a" | "an" | "their" | "its"));
    let until = (from..i).find(|k| word(tokens, *k) == "and" || tokens[*k].is(","))?;
    let near = i - until <= BETWEEN + 1 && (until + 1..i).all(|k| tokens[k].word());
    (near && word(tokens, front + 1) == "of" && from < until).then(|| tokens[from..until].to_vec())
}

/// "The fridge should open towards the table": it faces it.
fn opens(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said =
        matches!(word(tokens, i), "open" | "opens" | "opening") && matches!(word(tokens, i + 1), "towards" | "toward");
    if said {
        put(tokens, i, i + 2, &["facing"]);
    }
    said
}

/// "A rug under the table that extends under the sofa": a rug under the table and under the sofa.
fn extends(tokens: &mut Vec<Token>, i: usize) -> bool {
    let that = matches!(word(tokens, i), "that" | "which");
    let said = that
        && matches!(word(tokens, i + 1), "extends" | "reaches" | "continues" | "stretches")
        && matches!(word(tokens, i + 2), "under" | "beneath" | "underneath");
    if said {
        put(tokens, i, i + 2, &["and"]);
    }
    said
}

/// "Windows on the south and east walls": a window on the one and a window on the other.
fn walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SIDES: [&str; 10] =
        ["north", "south", "east", "west", "northern", "southern", "eastern", "western", "left", "right"];
    let side = |k: usize| SIDES.contains(&word(tokens, k));
    let said = matches!(word(tokens, i), "on" | "in" | "along" | "against") && word(tokens, i + 1) == "the";
    if !said || !side(i + 2) || word(tokens, i + 3) != "and" || !side(i + 4) || word(tokens, i + 5) != "walls" {
        return false;
    }
    // "Large windows", and nothing that counts them.
    let begins =
        |t: &Token| !t.word() || matches!(t.text.as_str(), "and" | "with" | "has" | "have" | "are" | "put" | "place");
    let from = (0..i).rev().find(|k| begins(&tokens[*k])).map_or(0, |k| k + 1);
    let things: Vec<String> = tokens[from..i].iter().map(|t| t.text.clone()).collect();
    let Some((noun, looks)) = things.split_last().filter(|(_, looks)| looks.len() <= 2) else { return false };
    let one = singular(noun);
    let counted = looks.iter().any(|w| matches!(w.as_str(), "the" | "all" | "both" | "some" | "there"));
    if one == *noun || counted || super::number::count(&tokens[from..i]).is_some() {
        return false;
    }
    let mut again: Vec<&str> = vec!["wall", "and", "a"];
    again.extend(looks.iter().map(String::as_str));
    let (on, other) = (tokens[i].text.clone(), tokens[i + 4].text.clone());
    again.extend([one.as_str(), on.as_str(), "the", other.as_str(), "wall"]);
    put(tokens, i + 3, i + 6, &again);
    let mut first: Vec<&str> = vec!["a"];
    first.extend(looks.iter().map(String::as_str));
    first.push(&one);
    put(tokens, from, i, &first);
    true
}

/// "Distance desks to wall: 2 m": the distance between desks and wall.
fn distance(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 5;
    let begins = i == 0 || matches!(tokens[i - 1].kind, WordKind::Line | WordKind::Bullet);
    let said = begins && matches!(word(tokens, i), "distance" | "gap" | "clearance");
    if !said || matches!(word(tokens, i + 1), "between" | "of" | "from" | "to" | "is" | "in" | "") {
        return false;
    }
    let Some(to) = (i + 2..i + FAR).find(|k| word(tokens, *k) == "to") else { return false };
    put(tokens, to, to + 1, &["and"]);
    put(tokens, i, i + 1, &["distance", "between"]);
    true
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn what_is_meant_is_said_plainly() {
        for (text, becomes) in [
            ("no two plants may be closer than 1 m.", "plants at least 1 m apart ."),
            ("No two desks are closer to each other than 0.9 m apart", "desks at least 0.9 m apart"),
            ("no two plants are closer than 1 m to the sofa", "no two plants are closer than 1 m to the sofa"),
            ("desks no closer than 2.2 m together", "desks at least 2.2 m apart"),
            ("tables no nearer to each other than two metres", "tables at least two metres apart"),
            ("no closer than 2 m to the sofa", "no closer than 2 m to the sofa"),
            ("they stand 3 m away from one another", "they stand 3 m apart"),
            ("the lamps are 2 m from each end", "the lamps are 2 m from each end"),
            ("a cabinet on which a radio and a clock are kept", "a cabinet with a radio and a clock on top"),
            (
                "you get from the hall into the kitchen through a wide door.",
                "a wide door leads from the hall to the kitchen .",
            ),
            ("we enter the cold room from the shop via a door", "a door leads from the shop to the cold room"),
            ("you get a sofa from the hall", "you get a sofa from the hall"),
            ("three shelves. the middle one holds a vase", "three shelves . the middle shelf holds a vase"),
            ("three shelves. the one in the middle", "three shelves . the middle shelf"),
            ("the first one of all", "the first one of all"),
            ("a table that seats eight", "a table for eight"),
            ("a seating area", "a seating area"),
            ("distance desks to wall: 2 m", "distance between desks and wall : 2 m"),
            ("a cafe with a bar and seating for twenty", "a cafe with a bar for twenty"),
            ("a cafe with a bar and comfortable seating for twenty", "a cafe with a bar for twenty"),
            ("a workshop for bicycle repair", "a bicycle repair workshop"),
            ("a room for meetings with a screen", "a meeting room with a screen"),
            ("a shop for two", "a shop for two"),
            ("a counter for eight and four tables", "a bar counter and eight bar stools and four tables"),
            ("a bar for six people", "a bar counter and six bar stools"),
            ("a bedroom for a teenage gamer", "a teen bedroom"),
            ("a room for two kids with desks", "a kids bedroom for two kids with desks"),
            ("a room for a newborn", "a baby bedroom"),
            ("a room for twelve children", "a room for twelve children"),
            ("a room for children's books", "a room for children books"),
            ("the sofa here and the tv opposite.", "the sofa here and the tv opposite it ."),
            (
                "eight washers, six dryers on the opposite wall",
                "eight washers along one wall , six dryers on the opposite wall",
            ),
            (
                "six washers on one wall and six dryers on the other with a table in between",
                "six washers on one wall and six dryers on the opposite wall with a table in between",
            ),
            (
                "a screen on the short wall and a board on the wall opposite.",
                "a screen on the short wall and a board on the opposite wall .",
            ),
            ("a window and a bed on the opposite wall", "a window and a bed on the wall opposite the window"),
            (
                "a shelf on one wall and a bed on the opposite wall",
                "a shelf on one wall and a bed on the opposite wall",
            ),
            ("on the opposite side, opposite the bed", "on the opposite side , opposite the bed"),
            ("the fridge opens towards the table", "the fridge facing the table"),
            (
                "with large windows on the south and east walls",
                "with a large window on the south wall and a large window on the east wall",
            ),
            ("two windows on the south and east walls", "two windows on the south and east walls"),
            ("under the table that extends under the sofa", "under the table and under the sofa"),
        ] {
            let mut tokens = tokens(text, 100).0;
            plain(&mut tokens);
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
