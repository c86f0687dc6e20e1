//! Which rooms a request speaks of, before its things are read: a room is one only if it is a heading, has a size, is led
//! to, or is what a sentence is about. "The door to the garden" makes no garden.

use super::among::is_known;
use super::chunk::{Chunk, ChunkPiece};
use super::lexicon::{Verb, get};
use super::noun::{Det, NounKind, Np};
use super::several::{Listed, Several, hyphen, is_home, listed, one_of, sleeps};
use super::token::Token;
use crate::brief::{Place, Rel, Room, ThingOrigin};
use std::collections::BTreeMap;
use std::ops::Range;

/// Rooms, and which of them a chunk speaks of.
#[derive(Debug, Default)]
pub struct Rooms {
    /// In the order of the text; at least one.
    pub rooms: Vec<Room>,
    /// By the index of the chunk.
    pub spoken: BTreeMap<usize, usize>,
    /// How many of each room there are, and whose they are.
    pub several: Vec<Several>,
    /// The room that has the others: "a flat with two bedrooms".
    pub whole: Option<usize>,
}

impl Rooms {
    fn add(&mut self, room: Room, several: Several) -> usize {
        self.rooms.push(room);
        self.several.push(several);
        self.rooms.len() - 1
    }

    /// Notes one of several of a kind that were spoken of, as "the second bedroom" is. Whether there are such.
    fn is_one_of(&mut self, chunk: usize, np: &Np, (kind, label): (&str, String), source: &ThingOrigin) -> bool {
        let kind = if sleeps(&np.name()) { "bedroom" } else { kind };
        let of = self.rooms.iter().zip(&self.several).position(|(room, several)| {
            several.count > 1 && get().room(&room.name).is_some_and(|known| known.name == kind)
        });
        let Some(of) = of else { return false };
        // "A master bedroom and a kids room. The master bedroom has a bed": the same.
        let known = (0..self.rooms.len()).find(|at| self.several[*at].label == label || self.rooms[*at].name == label);
        let named = self.several.iter().filter(|several| several.like == Some(of)).count();
        let name = if is_own_name(np) { np.name() } else { self.rooms[of].name.clone() };
        let room = match known {
            Some(room) => room,
            // The first of them stands for all.
            None if named < self.several[of].count && self.rooms.len() < MOST => {
                let room = Room { name, source: source.clone(), ..self.rooms[of].clone() };
                self.add(room, Several { like: Some(of), label, ..Several::default() })
            }
            None if name != self.rooms[of].name => return false,
            None => of,
        };
        self.spoken.insert(chunk, room);
        true
    }

    /// Notes one of the rooms that a home is said to have: so many of them, of a room that alone leads to them, if any.
    fn listed(&mut self, chunk: usize, np: &Np, source: ThingOrigin, (count, own): (usize, Option<usize>)) {
        let known = self.rooms.iter().zip(&self.several).position(|(room, several)| {
            own.is_none() && room.name == np.name() && several.own.is_none() && several.count >= count
        });
        if let Some(room) = known {
            self.spoken.insert(chunk, room);
        } else if self.rooms.len() < MOST {
            let room = Room { name: name_of(np), source, ..Room::default() };
            let room = self.add(room, Several { count, own, ..Several::default() });
            self.spoken.insert(chunk, room);
        }
    }

    /// "a living room with a balcony": another room, outside. What cannot be built is told, and is not the first room.
    fn outside(&mut self, chunk: usize, np: &Np, source: ThingOrigin, chunks: &[Chunk]) {
        let before = chunk.checked_sub(1).map(|k| &chunks[k].piece);
        let has = matches!(
            before,
            Some(ChunkPiece::With | ChunkPiece::And | ChunkPiece::Comma | ChunkPiece::Verb(Verb::Have))
        );
        if has && crate::storey::is_outside(&np.name()) && self.rooms.len() < MOST {
            let room = self.add(Room { name: name_of(np), source, ..Room::default() }, Several::default());
            self.spoken.insert(chunk, room);
        }
    }

    /// The room that a name means among those that were spoken of: by its name, or by what it ends with.
    fn named(&self, np: &Np, base: &str, is_known: bool) -> Option<usize> {
        let same = self.rooms.iter().position(|r| r.name == np.name());
        let ends = || {
            self.rooms.iter().position(|r| {
                let base_too = base != "room" || np.words.len() == 1;
                // A lawyer's office is no law office.
                let plain = np.name() == base || r.name.ends_with(&format!(" {}", np.name()));
                base_too && (r.name == base || plain && r.name.ends_with(&format!(" {base}")))
            })
        };
        // "A reception area … The reception has a desk": the same place.
        let name = np.name();
        let known = || self.rooms.iter().position(|r| place(&r.name) == place(&name));
        same.or_else(ends).or_else(|| known().filter(|_| is_known && np.count.is_none() && place(&name) != "dining"))
    }
}

/// What a place is called but for the last word: "reception" of a reception area.
fn place(name: &str) -> &str {
    name.rsplit_once(' ').filter(|(_, last)| ["area", "room", "space", "zone"].contains(last)).map_or(name, |(a, _)| a)
}

/// What parts of rooms are called, as well as rooms.
const AREAS: [&str; 6] = ["area", "corner", "nook", "space", "zone", "lounge"];
/// The kind of what is under the open sky.
const OUTDOORS: &str = "terrace";
/// More rooms than this are not told apart.
pub(super) const MOST: usize = 12;

/// Whether a room has a name of its own, and not only one that says which of several it is.
fn is_own_name(np: &Np) -> bool {
    const WHICH: [&str; 13] = [
        "first", "second", "third", "fourth", "fifth", "sixth", "last", "other", "next", "larger", "smaller", "large",
        "small",
    ];
    np.nth.is_none() && np.name() != "bedroom" && !np.words.first().is_some_and(|word| WHICH.contains(&word.as_str()))
}

pub fn find(chunks: &mut [Chunk], tokens: &[Token]) -> Rooms {
    nameless(chunks);
    let listed = listed(chunks, tokens);
    let mut out = spoken(chunks, tokens, &listed);
    out.several.resize(out.rooms.len(), Several::default());
    super::among::settle(&mut out, chunks, tokens, listed.hyphened.map(|(at, ..)| at));
    // What could be a thing as well and is no room here is a thing.
    let placed: Vec<bool> = (0..chunks.len()).map(|i| placed(chunks, i)).collect();
    for (i, chunk) in chunks.iter_mut().enumerate() {
        if let ChunkPiece::Np(np) = &mut chunk.piece
            && np.kind == NounKind::Room
            && (np.group.is_some() || placed[i])
            && !out.spoken.contains_key(&i)
        {
            np.kind = NounKind::Thing;
        }
    }
    out
}

/// "A scriptorium with two desks": what the request begins with and nobody knows is a room, if no other is named.
fn nameless(chunks: &mut [Chunk]) {
    if chunks.iter().any(|chunk| chunk.np().is_some_and(|np| np.kind == NounKind::Room)) {
        return;
    }
    let Some(first) = chunks.iter().position(|chunk| chunk.np().is_some()) else { return };
    let ends = matches!(
        chunks.get(first + 1).map(|chunk| &chunk.piece),
        None | Some(ChunkPiece::With | ChunkPiece::Stop | ChunkPiece::Line)
    );
    let begins = chunks[..first].iter().all(|chunk| !matches!(chunk.piece, ChunkPiece::Rel(_) | ChunkPiece::There));
    let Some(Chunk { piece: ChunkPiece::Np(np), .. }) = chunks.get_mut(first) else { return };
    let one = np.det == Det::Indefinite && np.count.is_none_or(|n| n == 1);
    let unknown = !np.known && np.group.is_none() && crate::furnish::kinds::of(&np.name()).is_none();
    if ends && begins && one && np.kind == NounKind::Thing && unknown {
        np.words.push("room".to_owned());
        np.kind = NounKind::Room;
    }
}

/// "The cold store is in the corner": a room that stands somewhere in another is a thing there.
fn placed(chunks: &[Chunk], i: usize) -> bool {
    let piece = |k: usize| chunks.get(k).map(|c| &c.piece);
    let corner = |k: usize| matches!(piece(k), Some(ChunkPiece::Np(np)) if matches!(np.kind, NounKind::Place(Place::Corner | Place::Wall | Place::Middle)));
    matches!(piece(i + 1), Some(ChunkPiece::Verb(Verb::Be)))
        && matches!(piece(i + 2), Some(ChunkPiece::Rel(Rel::In | Rel::At | Rel::Against)))
        && corner(i + 3)
}

fn spoken(chunks: &[Chunk], tokens: &[Token], listed: &Listed) -> Rooms {
    let mut out = Rooms::default();
    let lexicon = get();
    let bytes = |c: &Chunk| -> Range<usize> { tokens[c.at.start].at.start..tokens[c.at.end - 1].at.end };
    let mut loose: Vec<(usize, String)> = Vec::new();
    let mut weak: Vec<(usize, String)> = Vec::new();
    for (i, chunk) in chunks.iter().enumerate() {
        let Some(np) = chunk.np().filter(|n| n.kind == NounKind::Room) else { continue };
        if let Some((_, count, noun)) = listed.hyphened.as_ref().filter(|(at, ..)| *at == i) {
            hyphened(&mut out, chunks, tokens, (i, *count, noun));
            continue;
        }
        if listed.hyphened.is_some() && listed.container == Some(i) {
            continue;
        }
        let Some((n, kind)) = lexicon.room_ending(&np.words) else { continue };
        let base = np.words[np.words.len() - n..].join(" ");
        // "where guests feel at home"
        let before = chunk.at.start.checked_sub(1).map_or("", |k| tokens[k].text.as_str());
        if np.name() == "home" && np.det == Det::None && matches!(before, "at" | "from" | "feel") {
            continue;
        }
        let source = ThingOrigin::Stated(bytes(chunk));
        let count = np.count.filter(|n| (2..=MOST).contains(n)).unwrap_or(1);
        if listed.container == Some(i) && out.whole.is_none() {
            let whole = out.add(Room { name: np.name(), source, ..Room::default() }, Several::default());
            out.whole = Some(whole);
            out.spoken.insert(i, whole);
            continue;
        }
        if let Some(owner) = listed.rooms.get(&i) {
            let own = owner.and_then(|chunk| out.spoken.get(&chunk).copied());
            out.listed(i, np, source, (count, own));
            continue;
        }
        // "the second bedroom", of two.
        if let Some(label) = one_of(np, n, &tokens[chunk.at.clone()])
            && out.is_one_of(i, np, (kind.name, label), &source)
        {
            continue;
        }
        if np.words.len() == 1 && base == "room" && of_two(chunk, tokens, 0).is_some() {
            loose.push((i, np.name()));
            continue;
        }
        if let Some(room) = out.named(np, &base, np.det != Det::Indefinite || is_known(chunks, tokens, i)) {
            out.spoken.insert(i, room);
            continue;
        }
        // "the beer cellar, a vaulted room of 12 by 7 m": the same; "a corridor, an office and a lab": another.
        if i >= 2
            && np.det == Det::Indefinite
            && (kind.loose || base == "room")
            && chunks[i - 1].piece == ChunkPiece::Comma
            && let Some(room) = out.spoken.get(&(i - 2)).copied()
        {
            out.spoken.insert(i, room);
            continue;
        }
        // "evacuation study", "case study", but "a wizard's study"
        let owned = tokens[chunk.at.clone()].iter().any(|token| token.owner);
        if base == "study" && np.words.len() > 1 && !owned {
            continue;
        }
        // "eye test cabin": a thing, where nothing says that it is a room.
        if kind.loose && np.group.is_some() && np.words.len() > 1 {
            continue;
        }
        if kind.name == OUTDOORS && np.det == Det::Indefinite && !out.rooms.is_empty() {
            out.outside(i, np, source, chunks);
            continue;
        }
        // "the sewing room": of its own, where it is said like one.
        let told = !out.rooms.is_empty() || sized(chunks, i);
        let own_name = base == "room" && np.words.len() > 1 && told && strong(chunks, i, false);
        if (kind.loose || base == "office building") && !own_name {
            loose.push((i, np.name()));
            continue;
        }
        let same_kind = kind.name != "stock room" && np.det == Det::Definite;
        if same_kind
            && let Some(room) =
                out.rooms.iter().position(|r| lexicon.room(&r.name).is_some_and(|k| k.name == kind.name))
        {
            out.spoken.insert(i, room);
            continue;
        }
        let either = np.group.is_some();
        let said = strong(chunks, i, out.rooms.is_empty() && !either) && (!either || titled(chunks, i));
        if out.rooms.len() < MOST && (said || is_all(chunks, i)) {
            let room = Room { name: name_of(np), source: ThingOrigin::Stated(bytes(chunk)), ..Room::default() };
            let room = out.add(room, Several { count, ..Several::default() });
            out.spoken.insert(i, room);
        } else if !either {
            weak.push((i, np.name()));
        }
    }
    settle(&mut out, chunks, tokens, loose, &weak);
    out
}

/// "the big room", "the other room": which of two rooms this is; the larger one is named first.
fn of_two(chunk: &Chunk, tokens: &[Token], last: usize) -> Option<usize> {
    tokens[chunk.at.clone()].iter().find_map(|token| match token.text.as_str() {
        "big" | "bigger" | "large" | "larger" | "main" => Some(0),
        "small" | "smaller" | "little" => Some(1),
        "other" => Some(1 - last.min(1)),
        _ => None,
    })
}

/// "a two-bedroom flat": the flat, and its bedrooms.
fn hyphened(out: &mut Rooms, chunks: &[Chunk], tokens: &[Token], (i, count, noun): (usize, usize, &str)) {
    let bytes = |c: &Chunk| -> Range<usize> { tokens[c.at.start].at.start..tokens[c.at.end - 1].at.end };
    let whole = Room {
        name: chunks[i + 1].np().map_or_else(String::new, Np::name),
        source: ThingOrigin::Stated(bytes(&chunks[i + 1])),
        ..Room::default()
    };
    let whole = out.add(whole, Several::default());
    out.whole = Some(whole);
    out.spoken.extend([(i, whole), (i + 1, whole)]);
    of_so_many(out, count, noun, bytes(&chunks[i]));
}

/// What was said loosely: the only room, where there is no other; the last spoken of; what has a name elsewhere.
fn settle(out: &mut Rooms, chunks: &[Chunk], tokens: &[Token], loose: Vec<(usize, String)>, weak: &[(usize, String)]) {
    let bytes = |c: &Chunk| -> Range<usize> { tokens[c.at.start].at.start..tokens[c.at.end - 1].at.end };
    if out.rooms.is_empty() {
        // The most telling of what was said loosely.
        let pick =
            loose.iter().find(|(_, n)| n != "room" && n != "space" && n != "place").or(loose.first()).or(weak.first());
        let room = match pick {
            Some((i, name)) => {
                Room { name: name.clone(), source: ThingOrigin::Stated(bytes(&chunks[*i])), ..Room::default() }
            }
            None => Room { name: "room".into(), ..Room::default() },
        };
        out.rooms.push(room);
        for (i, name) in weak {
            if out.rooms[0].name == *name {
                out.spoken.insert(*i, 0);
            }
        }
    }
    // "leads into the kitchen", before the kitchen is described.
    for (i, name) in weak {
        if let Some(room) = out.rooms.iter().position(|r| r.name == *name) {
            out.spoken.entry(*i).or_insert(room);
        }
    }
    // "the room", "the flat": the room last spoken of. "The big room", "the other room", of two: one of them.
    for (i, _) in loose {
        // "You get there from the hall. The room …": not the hall.
        let left = |k: usize| k > 0 && chunks[k - 1].piece == ChunkPiece::Rel(Rel::From);
        let last = out.spoken.range(..i).rev().find(|(k, _)| !left(**k)).map_or(0, |(_, r)| *r);
        let whole = chunks[i].np().filter(|np| is_home(&np.name())).and(out.whole);
        let told = of_two(&chunks[i], tokens, last);
        let told = told.filter(|_| out.rooms.len() == 2);
        out.spoken.insert(i, whole.or(told).unwrap_or(last));
    }
}

/// What a room is called; "en-suite" is no name.
fn name_of(np: &Np) -> String {
    match np.words.split_first() {
        Some((first, rest)) if first.starts_with("en") && first.ends_with("suite") && !rest.is_empty() => {
            rest.join(" ")
        }
        _ => np.name(),
    }
}

/// "two-bedroom": two of them. Of rooms in general ("a four-room flat") one is the living room, and the others are bedrooms.
fn of_so_many(out: &mut Rooms, count: usize, noun: &str, at: Range<usize>) {
    let source = ThingOrigin::Stated(at);
    let mut add = |name: &str, count: usize| {
        let room = Room { name: name.to_owned(), source: source.clone(), ..Room::default() };
        out.add(room, Several { count, ..Several::default() });
    };
    if noun == "room" {
        add("living room", 1);
        if count > 1 {
            add("bedroom", count - 1);
        }
    } else {
        add(noun, count);
    }
}

/// Rooms of which several are asked for and fewer are laid out: where that is said, and a reason for the list.
pub fn fewer(chunks: &[Chunk], tokens: &[Token], rooms: &[Room]) -> Vec<(Range<usize>, String)> {
    let lexicon = get();
    let kind = |name: &str| lexicon.room(name).map(|kind| &kind.name);
    let mut out = Vec::new();
    for chunk in chunks {
        let Some(np) = chunk.np().filter(|np| np.kind == NounKind::Room) else { continue };
        let hyphened = hyphen(np).filter(|(_, noun)| noun != "room");
        let Some((wanted, noun)) = hyphened.or_else(|| Some((np.count?, np.words.last()?.clone()))) else { continue };
        let Some(kind_wanted) = kind(&noun).filter(|_| noun != "room") else { continue };
        let is_one = |room: &&Room| {
            let last = room.name.rsplit(' ').next().and_then(kind);
            last == Some(kind_wanted) || noun == "bedroom" && sleeps(&room.name)
        };
        let laid_out = rooms.iter().filter(is_one).count();
        if wanted > laid_out.max(1) {
            let at = tokens[chunk.at.start].at.start..tokens[chunk.at.end - 1].at.end;
            let done = match laid_out {
                0 => "none was".to_owned(),
                1 => "only one was".to_owned(),
                n => format!("only {n} were"),
            };
            out.push((at, format!("{wanted} such rooms are requested, but {done} placed; name each of them")));
        }
    }
    out
}

/// Whether a mention makes a room.
fn strong(chunks: &[Chunk], i: usize, first: bool) -> bool {
    let piece = |k: usize| chunks.get(k).map(|c| &c.piece);
    let before = i.checked_sub(1).and_then(piece);
    let before2 = i.checked_sub(2).and_then(piece);
    let after = piece(i + 1);
    let start =
        matches!(before, None | Some(ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::Bullet | ChunkPiece::Colon));
    let beside = matches!(before, Some(ChunkPiece::Rel(r)) if !matches!(r, Rel::In | Rel::Of | Rel::To | Rel::Between));
    let to = matches!(before, Some(ChunkPiece::Rel(Rel::To | Rel::In | Rel::From)));
    let led = to && matches!(before2, Some(ChunkPiece::Verb(Verb::Lead)))
        || matches!(before, Some(ChunkPiece::Verb(Verb::Lead)));
    let sized = sized(chunks, i);
    let heading = start
        && matches!(
            after,
            Some(
                ChunkPiece::Colon
                    | ChunkPiece::Stop
                    | ChunkPiece::Line
                    | ChunkPiece::Open
                    | ChunkPiece::Measure(_)
                    | ChunkPiece::Comma
                    | ChunkPiece::Attr(_)
            ) | None
        );
    // "Evacuation plan, gymnasium: …": a title before the room.
    let title = matches!(after, Some(ChunkPiece::Comma))
        && matches!(piece(i + 2), Some(ChunkPiece::Np(np)) if np.kind == NounKind::Room)
        && matches!(piece(i + 3), Some(ChunkPiece::Colon | ChunkPiece::Measure(_)));
    if title {
        return false;
    }
    if placed(chunks, i) {
        return false;
    }
    let subject = start && matches!(after, Some(ChunkPiece::Verb(_) | ChunkPiece::Which));
    let opens = start_of_clause(chunks, i) && matches!(before, Some(ChunkPiece::Rel(Rel::In)));
    let joined = matches!(before, Some(ChunkPiece::And | ChunkPiece::Comma))
        && before2.is_some_and(|p| matches!(p, ChunkPiece::Np(np) if np.kind == NounKind::Room))
        || matches!(before, Some(ChunkPiece::And))
            && chunks[..i].iter().rev().take(8).any(|c| c.np().is_some_and(|n| n.kind == NounKind::Room))
            && matches!(
                after,
                Some(ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::Comma | ChunkPiece::Colon) | None
            )
            && chunks[..i]
                .iter()
                .rev()
                .take_while(|c| !matches!(c.piece, ChunkPiece::Stop | ChunkPiece::Line))
                .all(|c| !matches!(c.np(), Some(n) if n.kind == NounKind::Thing));
    let one = chunks[i].np().is_some_and(|np| np.det == Det::Indefinite);
    let joins = |piece: Option<&ChunkPiece>| matches!(piece, Some(ChunkPiece::And | ChunkPiece::Comma));
    // "A playroom with a rug and shelves, and a nap room with ten beds".
    let next = one && matches!(before, Some(ChunkPiece::And)) && matches!(before2, Some(ChunkPiece::Comma));
    let next = next && matches!(after, Some(ChunkPiece::With));
    // "A reception with a counter, and behind it an office".
    let it = matches!(before, Some(ChunkPiece::Np(np)) if np.kind == NounKind::Pronoun);
    let beyond = one && it && matches!(before2, Some(ChunkPiece::Rel(_))) && joins(i.checked_sub(3).and_then(piece));
    // "There is a waiting room with chairs", "A waiting room with chairs": a sentence of its own. An area may be a part of a room.
    let is_area = chunks[i].np().is_some_and(|np| np.words.last().is_some_and(|last| AREAS.contains(&last.as_str())));
    // "There is also a guest room with a bed".
    let also = matches!(before, Some(ChunkPiece::Soft | ChunkPiece::Word(_)));
    let there = before == Some(&ChunkPiece::There) || also && before2 == Some(&ChunkPiece::There);
    let told = one && !is_area && (start || there) && matches!(after, Some(ChunkPiece::With));
    let added =
        (next || beyond || told) && chunks[..i].iter().any(|c| c.np().is_some_and(|n| n.kind == NounKind::Room));
    sized || led || heading || subject || opens || joined || added || first && !beside && !to
}

/// "The group room is 9 by 7 m": a size follows.
fn sized(chunks: &[Chunk], i: usize) -> bool {
    let piece = |k: usize| chunks.get(k).map(|c| &c.piece);
    match piece(i + 1) {
        Some(ChunkPiece::Measure(m)) => m.values.len() > 1 || m.area,
        Some(ChunkPiece::Open | ChunkPiece::Comma | ChunkPiece::Verb(Verb::Be) | ChunkPiece::Rel(Rel::Of)) => {
            matches!(piece(i + 2), Some(ChunkPiece::Measure(m)) if m.values.len() > 1 || m.area || !m.dims.is_empty())
        }
        _ => false,
    }
}

/// "A cosy bar.": nothing else is asked for.
fn is_all(chunks: &[Chunk], i: usize) -> bool {
    let rest = |k: usize, c: &Chunk| k == i || matches!(c.piece, ChunkPiece::Stop | ChunkPiece::Line);
    chunks.iter().enumerate().all(|(k, c)| rest(k, c))
}

/// Whether a word that may be a thing is said as a room: "Pantry: …", "a pantry of 3 by 2 m", "leads to the pantry".
fn titled(chunks: &[Chunk], i: usize) -> bool {
    let piece = |k: usize| chunks.get(k).map(|c| &c.piece);
    let sized = |k: usize| matches!(piece(k), Some(ChunkPiece::Measure(m)) if m.values.len() > 1 || m.area);
    let bullet = i.checked_sub(1).and_then(piece) == Some(&ChunkPiece::Bullet);
    sized(i + 1)
        || sized(i + 2)
        || !bullet && matches!(piece(i + 1), Some(ChunkPiece::Colon | ChunkPiece::Line))
        || !bullet
            && matches!(piece(i + 1), Some(ChunkPiece::Stop))
            && !matches!(piece(i + 2), None | Some(ChunkPiece::Line))
        || (i.saturating_sub(3)..i).any(|k| matches!(piece(k), Some(ChunkPiece::Verb(Verb::Lead))))
}

/// "In the kitchen, …": the relation before it begins a clause.
fn start_of_clause(chunks: &[Chunk], i: usize) -> bool {
    i < 2
        || matches!(
            chunks[i - 2].piece,
            ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::Bullet | ChunkPiece::Comma | ChunkPiece::Colon
        )
}
