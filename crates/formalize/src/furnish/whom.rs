//! Whom a room is for: no thing in it, and, for children who share a bedroom, a room with a bed for each.

use super::groups::{self, Where};
use super::kinds::{self, Count, Line};
use crate::brief::{Brief, Group, Number, Thing};
use crate::complete::defaults::push;

/// What comes before who a room is for.
const FOR: [&str; 4] = ["for", "for a", "for an", "for the"];
/// Rooms with a bed for each child.
const ROOMS: [&str; 3] = ["kids room", "teen room", "nursery"];
/// Who does not share a bed.
const CHILDREN: [&str; 12] = [
    "sisters",
    "brothers",
    "siblings",
    "twins",
    "children",
    "kids",
    "boys",
    "girls",
    "toddlers",
    "daughters",
    "sons",
    "teenagers",
];
const STUDENTS: [&str; 4] = ["students", "roommates", "flatmates", "teens"];
const NUMBERS: [&str; 4] = ["two", "three", "four", "five"];
const WHOSE: [&str; 7] = ["my", "our", "his", "her", "their", "your", "the"];
/// What is said of a room and no longer of whom it is for.
const ENDS: [&str; 10] = ["with", "who", "that", "in", "has", "having", "including", "featuring", "where", "by"];
/// So many children share a room.
const MOST: usize = 4;
/// So many words may stand between the number and who is meant: "two little boys".
const BETWEEN: usize = 2;

/// Who a room is for is no thing in it: "a nursery for a newborn".
pub fn persons(brief: &mut Brief) {
    let gone: Vec<usize> = (0..brief.things.len())
        .filter(|at| {
            let thing = &brief.things[*at];
            let start = thing.source.at().start;
            let before: Vec<&str> = brief.request.get(..start).unwrap_or("").split_whitespace().collect();
            let article = brief.request.get(thing.source.at()).unwrap_or("").to_lowercase();
            let said =
                format!("{} {article}", before.iter().rev().take(2).rev().copied().collect::<Vec<_>>().join(" "));
            let last = thing.words.last().map_or("", String::as_str);
            let for_whom = FOR.iter().any(|f| said.to_lowercase().contains(&format!("{f} {last}")));
            // "For two little boys".
            let near = before.iter().rev().take(BETWEEN).copied().chain(article.split_whitespace());
            let for_children = CHILDREN.iter().any(|child| child.strip_suffix('s') == Some(last))
                && near.into_iter().any(|word| word.eq_ignore_ascii_case("for"));
            thing.part.is_none() && (for_whom && scenelang_lang::nouns::noun(last).is_none() || for_children)
        })
        .collect();
    if !gone.is_empty() {
        // "Two girls with desks": a desk for each of them.
        for at in 0..brief.things.len() {
            if matches!(&brief.things[at].number, Number::Each { of, .. } if gone.contains(of)) {
                brief.things[at].number = Number::Exactly(brief.count(at));
            }
        }
        brief.remove(&gone);
    }
}

/// Ten microscopes are those of ten people, each with a place at a bench.
pub fn instruments(brief: &mut Brief) {
    const FEWEST: usize = 4;
    for at in 0..brief.rooms.len() {
        let room = &brief.rooms[at];
        let Some(kind) = kinds::of(&room.name).filter(|kind| room.people.is_none() && kind.home.is_none()) else {
            continue;
        };
        let places = || kind.lines.iter().filter(|line| matches!(line.count, Count::People(_)));
        let has = |line: &Line, name: &str| {
            let parts = groups::of(line.noun, kind.dress).iter();
            parts.filter(|part| matches!(part.at, Where::Top(..))).any(|part| part.noun == name)
        };
        let own = brief.things.iter().filter(|thing| thing.room == at && thing.part.is_none());
        let used = own.filter(|thing| places().any(|line| has(line, &thing.name())));
        let said = used.filter_map(|thing| thing.number.said()).max().filter(|n| *n >= FEWEST);
        if said.is_some() {
            brief.rooms[at].people = said;
        }
    }
}

/// What a plain "room" is, by what is asked for in it: one with a bed is a bedroom.
pub fn plain_room(brief: &mut Brief) {
    const TELLING: [(&str, &[&str]); 4] = [
        ("hospital room", &["hospital bed"]),
        ("bathroom", &["bathtub", "toilet", "shower"]),
        ("bedroom", &["bed"]),
        ("living room", &["sofa", "couch"]),
    ];
    let [room] = &brief.rooms[..] else { return };
    let is_plain = room.name.ends_with("room") && kinds::of(&room.name).is_none_or(|kind| kind.name == "room");
    let has = |noun: &&str| {
        let is_it = |name: &str| name.strip_suffix(noun).is_some_and(|rest| rest.is_empty() || rest.ends_with(' '));
        brief.things.iter().any(|thing| thing.part.is_none() && is_it(&thing.words.join(" ")))
    };
    if let Some((kind, _)) = TELLING.iter().filter(|_| is_plain).find(|(_, nouns)| nouns.iter().any(&has)) {
        (*kind).clone_into(&mut brief.rooms[0].name);
    }
}

/// A student lives where there is a desk.
pub fn student(brief: &mut Brief) {
    let [room] = &brief.rooms[..] else { return };
    let is_home = kinds::of(&room.name).is_some_and(|kind| matches!(kind.name, "studio apartment" | "bedroom"));
    let request = brief.request.to_lowercase();
    let is_for = ["for a student", "for one student", "for students"].iter().any(|whom| request.contains(whom));
    let has_desk = brief.things.iter().any(|thing| thing.name().ends_with("desk"));
    if is_home && is_for && !has_desk {
        push(brief, 0, "desk", 1, "a student needs a desk");
    }
}

/// Several computers in a room where nobody has a desk stand on desks of their own: six computers in a library.
pub fn computers(brief: &mut Brief) {
    const DESK: &str = "computer desk";
    const WHY: &str = "a computer stands on a desk";
    for room in 0..brief.rooms.len() {
        let Some(kind) = kinds::of(&brief.rooms[room].name).filter(|kind| kind.home.is_none()) else { continue };
        let is_place = |thing: &Thing| {
            thing.room == room
                && thing.part.is_none()
                && (thing.name().ends_with("desk") || thing.name().ends_with("workstation"))
        };
        let has_screen = |line: &Line| {
            matches!(line.count, Count::People(_))
                && groups::of(line.noun, kind.dress)
                    .iter()
                    .any(|part| matches!(part.noun, "monitor" | "computer" | "laptop"))
        };
        if brief.things.iter().any(is_place) || kind.lines.iter().any(has_screen) {
            continue;
        }
        let told = |at: usize| brief.facts.iter().any(|fact| fact.of.contains(&at));
        let several = |at: &usize| {
            let thing = &brief.things[*at];
            thing.room == room && thing.name() == "computer" && thing.number.said().is_some_and(|n| n > 1) && !told(*at)
        };
        let Some(n) = (0..brief.things.len()).find(several).and_then(|at| brief.things[at].number.said()) else {
            continue;
        };
        push(brief, room, DESK, n, WHY);
    }
}

/// A laboratory with a desk for a teacher is one of a school.
pub fn pupils(brief: &mut Brief) {
    let taught = |at: usize| {
        brief
            .things
            .iter()
            .any(|thing| thing.room == at && thing.name().ends_with("desk") && thing.name().starts_with("teacher"))
    };
    let is_lab = |at: &usize| kinds::of(&brief.rooms[*at].name).is_some_and(|kind| kind.name == "laboratory");
    let labs: Vec<usize> = (0..brief.rooms.len()).filter(is_lab).filter(|at| taught(*at)).collect();
    labs.into_iter().for_each(|at| "school lab".clone_into(&mut brief.rooms[at].name));
}

/// A bedroom for several children has a bed for each: "a bedroom for two teenage sisters".
pub fn children(brief: &mut Brief) {
    const CRIBS: [&str; 4] = ["crib", "cot", "cradle", "bassinet"];
    let is_crib = |thing: &Thing| thing.words.last().is_some_and(|word| CRIBS.contains(&word.as_str()));
    let is_bed = |thing: &Thing| thing.group == Group::Bed && !is_crib(thing);
    let has_bed = brief.things.iter().any(is_bed);
    let [room] = &mut brief.rooms[..] else { return };
    let kind = kinds::of(&room.name).map_or("", |kind| kind.name);
    if kind != "bedroom" && (has_bed || !ROOMS.contains(&kind)) {
        return;
    }
    let request = brief.request.to_lowercase();
    let words: Vec<&str> =
        request.split(|c: char| !c.is_alphanumeric() && c != '\'').filter(|w| !w.is_empty()).collect();
    for (at, _) in words.iter().enumerate().filter(|(_, word)| **word == "for") {
        // "For my two sons".
        let at = at + usize::from(words.get(at + 1).is_some_and(|word| WHOSE.contains(word)));
        let said = words.get(at + 1).copied().unwrap_or("");
        let number = NUMBERS.iter().position(|number| *number == said).map(|i| i + 2);
        let twins = said == "twins" || said == "twin";
        let Some(n) = number.or_else(|| said.parse().ok()).or(twins.then_some(2)).filter(|n| (2..=5).contains(n))
        else {
            continue;
        };
        let whom = &words[at + 1..words.len().min(at + 3 + BETWEEN)];
        // "For 4 year old boys": an age.
        if whom.get(1).is_some_and(|word| word.starts_with("year") || word.starts_with("month")) {
            continue;
        }
        let (child, student) = [&CHILDREN[..], &STUDENTS[..]].map(|list| whom.iter().any(|w| list.contains(w))).into();
        let teen = whom.iter().any(|word| word.starts_with("teen"));
        let name = match () {
            () if teen => "teen room",
            () if child => "kids room",
            () if student && !has_bed => "dorm room",
            () => continue,
        };
        if kind == "bedroom" {
            name.clone_into(&mut room.name);
        }
        room.people = Some(n);
        return;
    }
    let named = words.iter().enumerate().filter(|(_, word)| **word == "for").find_map(|(at, _)| {
        let whom = &words[at + 1..];
        child(&whom[..whom.iter().position(|word| ENDS.contains(word)).unwrap_or(whom.len())])
    });
    // "My teenage son needs a room".
    let needs = words.iter().position(|word| matches!(*word, "needs" | "need" | "wants" | "want"));
    let named = named.or_else(|| child(&words[..needs?]));
    if let Some((n, name)) = named.filter(|_| kind == "bedroom") {
        name.clone_into(&mut room.name);
        room.people = Some(n);
    }
}

/// "My daughter", "a baby and an older sister", "a 15 year old boy": how many of them need a bed, a crib aside, and what their
/// room is. None where parents sleep there, too.
fn child(whom: &[&str]) -> Option<(usize, &'static str)> {
    const GROWN: [&str; 9] = ["me", "us", "couple", "parents", "wife", "husband", "partner", "adult", "adults"];
    const BABY: [&str; 3] = ["baby", "newborn", "infant"];
    const TEEN: f64 = 13.0;
    let is_child = |word: &str| CHILDREN.iter().any(|child| child.strip_suffix('s') == Some(word) || word == "child");
    let is_teen = |word: &str| matches!(word, "teen" | "teenager");
    if whom.iter().any(|word| GROWN.contains(word)) {
        return None;
    }
    let aged = |pair: &[&str]| pair[1].starts_with("year") && pair[0].parse::<f64>().is_ok_and(|age| age >= TEEN);
    let grown = whom.iter().any(|word| is_teen(word) || *word == "teenage") || whom.windows(2).any(aged);
    match whom.iter().filter(|word| is_child(word) || is_teen(word)).count() {
        0 if whom.iter().any(|word| BABY.contains(word)) => Some((1, "nursery")),
        n @ 1..=MOST if grown => Some((n, "teen room")),
        n @ 1..=MOST => Some((n, "kids room")),
        _ => None,
    }
}
