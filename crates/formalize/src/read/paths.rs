//! Paths of a stated width that lead to more than one thing: "1.2 m wide paths to everything", "escape paths of 1.5 m are kept
//! clear", "for a wheelchair user"; and "reachable by a path 0.9 m wide". Paths lead from a door.

use super::chunk::{Chunk, ChunkPiece};
use super::measure::measure;
use super::token::{Token, WordKind};
use crate::brief::{Brief, Dim, Fact, FactKind, Group, Op, Rel, Thing, ThingOrigin};
use crate::complete::defaults::push;
use std::ops::Range;

const PATHS: [&str; 14] = [
    "path",
    "paths",
    "walkway",
    "walkways",
    "route",
    "routes",
    "passage",
    "passages",
    "passageway",
    "passageways",
    "way",
    "ways",
    "circulation",
    "corridors",
];
/// What makes a sentence speak of all there is.
const ALL: [&str; 2] = ["everything", "everywhere"];
const EACH: [&str; 3] = ["all", "every", "each"];
const THINGS: [&str; 9] = ["furniture", "object", "objects", "item", "items", "thing", "things", "piece", "pieces"];
/// Other words of such a sentence, which say no more than that.
const BESIDE: [&str; 44] = [
    "narrower",
    "less",
    "than",
    "keep",
    "keeps",
    "kept",
    "leave",
    "left",
    "provide",
    "ensure",
    "maintain",
    "need",
    "needs",
    "clear",
    "free",
    "open",
    "wide",
    "width",
    "clearance",
    "minimum",
    "least",
    "min",
    "escape",
    "emergency",
    "evacuation",
    "fire",
    "circulation",
    "access",
    "accessible",
    "reach",
    "reached",
    "reachable",
    "around",
    "through",
    "room",
    "space",
    "must",
    "should",
    "remain",
    "stay",
    "have",
    "has",
    "are",
    "is",
];
/// Who sits in a wheelchair needs doors and paths so wide (metres; DIN 18040).
const WHEELCHAIR: f64 = 0.9;
const IN_IT: [&str; 5] = ["in", "uses", "using", "with", "needs"];

/// Adds to a brief what is said of such paths. The words that say so.
pub fn say(brief: &mut Brief, tokens: &[Token], chunks: &[Chunk]) -> Vec<usize> {
    let mut used = Vec::new();
    for sentence in sentences(tokens) {
        // "Ideally", "if possible".
        let within_sentence = |c: &&Chunk| sentence.start <= c.at.start && c.at.end <= sentence.end;
        let softened = chunks.iter().filter(within_sentence).any(|c| c.piece == ChunkPiece::Soft);
        let soft = softened || sentence.clone().any(|i| tokens[i].is("if") || tokens[i].is("unless"));
        if let Some(said) = wheelchair(tokens, &sentence).filter(|_| !denies(tokens, &sentence)) {
            let at = bytes(tokens, &said);
            // Who sits in it comes with it.
            let in_it = |thing: &Thing| matches!(&thing.source, ThingOrigin::Stated(s) if at.contains(&s.start));
            let gone: Vec<usize> = (0..brief.things.len()).filter(|i| in_it(&brief.things[*i])).collect();
            brief.remove(&gone);
            to_all(brief, WHEELCHAIR, &at, soft);
            used.extend(said);
        }
        let Some((width, measured)) = width(tokens, &sentence) else { continue };
        let at = bytes(tokens, &sentence);
        let within = |fact: &Fact| matches!(&fact.source, ThingOrigin::Stated(s) if at.contains(&s.start));
        let words = |all: &[&str]| sentence.clone().any(|i| all.iter().any(|word| tokens[i].is(word)));
        let each = sentence.clone().any(|i| {
            let next = &tokens[i + 1..sentence.end.min(i + 4)];
            EACH.iter().any(|word| tokens[i].is(word)) && next.iter().any(|t| THINGS.iter().any(|thing| t.is(thing)))
        });
        let mut reached = false;
        for fact in brief.facts.iter_mut().filter(|fact| within(fact)) {
            // "Every desk is reachable by a path 0.9 m wide."
            if let FactKind::Rel(Rel::Reachable, to) = &fact.what {
                fact.what = FactKind::Path(width, to.clone());
                reached = true;
            }
        }
        let is_of_all = words(&ALL) || each || !brief.facts.iter().any(within) && speaks_of_nothing_else(brief, &at);
        if !reached && is_of_all {
            // It is no distance among what the sentence names besides.
            let is_apart = |fact: &Fact| matches!(fact.what, FactKind::Among(_, w) if w == width);
            brief.facts.retain(|fact| !(within(fact) && is_apart(fact)));
            to_all(brief, width, &at, soft);
        }
        let is_path = |fact: &Fact| within(fact) && matches!(fact.what, FactKind::Path(w, _) if w == width);
        if brief.facts.iter().any(is_path) {
            let all = [PATHS.as_slice(), &ALL, &EACH, &THINGS, &BESIDE].concat();
            let said: Vec<usize> = sentence
                .clone()
                .filter(|i| measured.contains(i) || all.iter().any(|word| tokens[*i].is(word)))
                .collect();
            // "Narrower than" is translated after all.
            let is_said = |i: usize| said.contains(&i);
            let inside = |at: &Range<usize>| {
                let mut words =
                    sentence.clone().filter(|i| at.start <= tokens[*i].at.start && tokens[*i].at.end <= at.end);
                words.all(is_said)
            };
            brief.notes.retain(|note| !(at.start <= note.at.start && note.at.end <= at.end && inside(&note.at)));
            used.extend(said);
        }
    }
    used
}

fn sentences(tokens: &[Token]) -> Vec<Range<usize>> {
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ';' | '!' | '?'));
    let mut from = 0;
    let mut out = Vec::new();
    for end in (0..tokens.len()).filter(|i| ends(&tokens[*i])).chain([tokens.len()]) {
        out.extend((from < end).then_some(from..end));
        from = end + 1;
    }
    out
}

fn bytes(tokens: &[Token], of: &Range<usize>) -> Range<usize> {
    tokens[of.start].at.start..tokens[of.end - 1].at.end
}

/// The width of the paths that a sentence speaks of, and the words of the measure.
fn width(tokens: &[Token], sentence: &Range<usize>) -> Option<(f64, Range<usize>)> {
    let is_path = |i: usize| PATHS.iter().any(|path| tokens[i].is(path));
    sentence.clone().find(|i| is_path(*i))?;
    let mut i = sentence.start;
    while i < sentence.end {
        let Some((m, n)) = measure(&tokens[i..sentence.end]) else {
            i += 1;
            continue;
        };
        let is_width = m.dims.iter().all(|dim| *dim == Dim::Width) && m.values.len() == 1 && !m.area;
        let near = i.saturating_sub(6).max(sentence.start)..(i + n + 4).min(sentence.end);
        let meant = m.dims.len() == 1 || near.into_iter().any(is_path);
        // What must not be wider, or is denied, asks for no path.
        let asked = if denies(tokens, sentence) { narrower(tokens, sentence) } else { m.op != Op::Most };
        if is_width && meant && asked && m.values[0] > 0.0 {
            return Some((m.values[0], i..i + n));
        }
        i += n.max(1);
    }
    None
}

/// Whether a sentence denies something.
fn denies(tokens: &[Token], sentence: &Range<usize>) -> bool {
    const NOT: [&str; 6] = ["no", "not", "never", "without", "nothing", "neither"];
    sentence.clone().any(|i| NOT.iter().any(|word| tokens[i].is(word)))
}

/// "No path may be narrower than 1.2 m", "nowhere less than 0.9 m wide".
fn narrower(tokens: &[Token], sentence: &Range<usize>) -> bool {
    const LESS: [&str; 4] = ["narrower", "less", "under", "below"];
    sentence.clone().any(|i| LESS.iter().any(|word| tokens[i].is(word)))
}

/// Whether a sentence names no thing.
fn speaks_of_nothing_else(brief: &Brief, at: &Range<usize>) -> bool {
    !brief.things.iter().any(|thing| matches!(&thing.source, ThingOrigin::Stated(s) if at.contains(&s.start)))
}

/// The words that say that somebody who sits in a wheelchair uses the room.
fn wheelchair(tokens: &[Token], sentence: &Range<usize>) -> Option<Range<usize>> {
    let i = sentence.clone().find(|i| tokens[*i].text.starts_with("wheelchair"))?;
    let after = tokens.get(i + 1).filter(|_| i + 1 < sentence.end);
    if tokens[i].is("wheelchair-accessible") || tokens[i].is("wheelchair-friendly") {
        return Some(i..i + 1);
    }
    let is_used = |t: &Token| ["user", "users", "access", "accessible"].iter().any(|word| t.is(word));
    if after.is_some_and(is_used) {
        return Some(i..i + 2);
    }
    // "for someone in a wheelchair"
    let from = i.checked_sub(3).filter(|from| *from >= sentence.start)?;
    let in_it = IN_IT.iter().any(|word| tokens[i - 2].is(word)) && tokens[i - 1].is("a");
    let person = ["someone", "somebody", "person", "who", "people", "man", "woman", "guest", "resident", "tenant"];
    (in_it && person.iter().any(|word| tokens[from].is(word))).then_some(from..i + 1)
}

/// A path so wide leads from the door to each thing that stands on the floor.
fn to_all(brief: &mut Brief, width: f64, at: &Range<usize>, soft: bool) {
    let stands = |thing: &Thing| {
        matches!(thing.group, Group::Seat | Group::Table | Group::Storage | Group::Bed | Group::Floor)
            && thing.part.is_none()
    };
    let carried = |i: &usize| {
        let on =
            |fact: &Fact| matches!(fact.what, FactKind::Rel(Rel::On | Rel::In | Rel::Under, _)) && fact.of.contains(i);
        brief.facts.iter().any(on)
    };
    let reached: Vec<usize> = (0..brief.things.len()).filter(|i| stands(&brief.things[*i]) && !carried(i)).collect();
    for thing in reached {
        let room = brief.things[thing].room;
        let door = door_of(brief, room);
        let source = ThingOrigin::Stated(at.clone());
        let path = FactKind::Path(width, vec![door]);
        brief.facts.push(Fact { soft, ..Fact::new(vec![thing], path, source) });
    }
}

/// A door of a room, which has one then.
fn door_of(brief: &mut Brief, room: usize) -> usize {
    let own = |thing: &Thing| {
        thing.group == Group::Door && thing.part.is_none() && (thing.room == room || thing.beyond == Some(room))
    };
    let known = brief.things.iter().position(own);
    known.unwrap_or_else(|| push(brief, room, "door", 1, "paths lead from a door"))
}
