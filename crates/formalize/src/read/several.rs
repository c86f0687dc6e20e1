//! Rooms in the plural: "a flat with two bedrooms", "a two-bedroom flat", "each with its own bathroom", "the kitchen opens into
//! the living room". While a request is read, two bedrooms are one room; [`expand`] makes two of it, each with what is said
//! of both.

use super::chunk::{Chunk, ChunkPiece};
use super::lexicon::{Verb, get};
use super::noun::{Det, NounKind, Np};
use super::number::small;
use super::rooms::Rooms;
use super::token::Token;
use crate::brief::{Brief, Group, Look, MOST_THINGS, Number, Rel, Room, Thing, ThingOrigin};
use crate::text::sentence;
use std::collections::BTreeMap;
use std::ops::Range;

/// What the request says of a room beside its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Several {
    /// How many of it there are.
    pub count: usize,
    /// The room that each of them belongs to.
    pub own: Option<usize>,
    /// The rooms of which it is one: "the second bedroom".
    pub like: Option<usize>,
    /// What it is called, where that differs from its kind: "second bedroom".
    pub label: String,
}

impl Default for Several {
    fn default() -> Self {
        Self { count: 1, own: None, like: None, label: String::new() }
    }
}

/// Rooms that a sentence lists as those of another: "a flat with …".
#[derive(Debug, Default)]
pub struct Listed {
    /// The chunk of what has them.
    pub container: Option<usize>,
    /// The chunks of the rooms, and of a room that each has for its own the chunk of its owner.
    pub rooms: BTreeMap<usize, Option<usize>>,
    /// "two-bedroom": the chunk, how many, of what.
    pub hyphened: Option<(usize, usize, String)>,
}

/// What one lives in, as a whole.
const HOMES: [&str; 17] = [
    "flat",
    "apartment",
    "house",
    "home",
    "penthouse",
    "cottage",
    "condo",
    "bungalow",
    "cabin",
    "unit",
    "maisonette",
    "townhouse",
    "duplex",
    "farmhouse",
    "chalet",
    "villa",
    "mansion",
];
/// Parts of a room that are no rooms where they are listed as what a room has.
const PARTS: [&str; 8] = ["area", "nook", "corner", "space", "alcove", "zone", "place", "interior"];
/// Words for a room that only one other leads to.
const OWN: [&str; 8] = ["own", "en-suite", "ensuite", "en", "private", "attached", "adjoining", "walk-in"];

/// Words before a word for a home that make no other thing of it; a test cabin is none.
const WHOSE: [&str; 9] =
    ["family", "holiday", "vacation", "city", "town", "student", "country", "detached", "terraced"];

/// Whether a name is that of a home.
pub fn is_home(name: &str) -> bool {
    let (whose, last) = name.rsplit_once(' ').map_or((None, name), |(whose, last)| (Some(whose), last));
    HOMES.contains(&last) && whose.is_none_or(|whose| whose.split(' ').all(|word| WHOSE.contains(&word)))
}

fn room(chunk: &Chunk) -> Option<&Np> {
    chunk.np().filter(|np| np.kind == NounKind::Room)
}

/// The number and the noun of "two-bedroom".
pub fn hyphen(np: &Np) -> Option<(usize, String)> {
    let (count, noun) = np.words.first().filter(|_| np.words.len() == 1)?.split_once('-')?;
    let count = count.parse().ok().or_else(|| small(count).map(|n| n as usize))?;
    get().room(noun)?;
    (1..=super::rooms::MOST).contains(&count).then(|| (count, noun.to_owned()))
}

/// Finds the rooms that are listed as those of a home, an office or another building, and those that a room has for its own.
pub fn listed(chunks: &[Chunk], tokens: &[Token]) -> Listed {
    let mut out = Listed::default();
    let mut from = 0;
    while from < chunks.len() {
        let ends = |c: &Chunk| matches!(c.piece, ChunkPiece::Stop | ChunkPiece::Line);
        let end = chunks[from..].iter().position(ends).map_or(chunks.len(), |n| from + n);
        sentence_of(chunks, tokens, from..end, &mut out);
        from = end + 1;
    }
    out
}

fn sentence_of(chunks: &[Chunk], tokens: &[Token], at: Range<usize>, out: &mut Listed) {
    let first_np = at.clone().find(|i| chunks[*i].np().is_some_and(|np| np.kind != NounKind::Pronoun));
    let Some(mut head) = first_np.filter(|i| room(&chunks[*i]).is_some()) else { return };
    if let (Some((count, noun)), Some(next)) =
        (room(&chunks[head]).and_then(hyphen), chunks.get(head + 1).and_then(room))
        && is_home(&next.name())
    {
        out.hyphened.get_or_insert((head, count, noun));
        head += 1;
        out.container.get_or_insert(head);
    }
    let Some(np) = room(&chunks[head]) else { return };
    let lexicon = get();
    let building = lexicon.room(&np.name()).is_some_and(|kind| kind.name == "apartment" || kind.name == "office");
    if is_home(&np.name()) && matches!(np.det, Det::Indefinite | Det::Own) && out.container.is_none() && head <= 2 {
        out.container = Some(head);
    }
    let container_name = np.name();
    let has = |c: &Chunk| matches!(c.piece, ChunkPiece::With | ChunkPiece::Verb(Verb::Have) | ChunkPiece::Colon);
    let Some(with) = (head + 1..at.end).find(|i| has(&chunks[*i])) else { return };
    if (head + 1..with).any(|i| matches!(chunks[i].np(), Some(np) if np.kind == NounKind::Thing)) {
        return;
    }
    let mut last = head;
    let mut rooms: Vec<(usize, Option<usize>)> = Vec::new();
    for i in with + 1..at.end {
        let Some(np) = room(&chunks[i]) else { continue };
        let opens = |c: &Chunk| {
            matches!(
                c.piece,
                ChunkPiece::With
                    | ChunkPiece::And
                    | ChunkPiece::Comma
                    | ChunkPiece::Colon
                    | ChunkPiece::Verb(_)
                    | ChunkPiece::Word(false)
            )
        };
        if !opens(&chunks[i - 1])
            || np.det == Det::Definite
            || np.words.last().is_some_and(|w| PARTS.contains(&w.as_str()))
        {
            continue;
        }
        // What may be a thing as well is one, unless there are rooms of that kind.
        if np.group.is_some()
            && (crate::furnish::kinds::of(&np.name()).is_none() || is_furniture(&container_name, &np.name()))
        {
            continue;
        }
        let annex = np.det == Det::Indefinite && np.count.is_none() && is_annex(&container_name, &np.name());
        if annex && lexicon.room(&container_name).is_some_and(|kind| kind.loose) {
            out.container.get_or_insert(head);
        }
        let owned = annex || owned(chunks, tokens, i);
        let many = np.count.is_some_and(|n| n > 1);
        if owned || many || building {
            rooms.push((i, owned.then_some(if annex { head } else { last })));
        }
        if !owned {
            last = i;
        }
    }
    let own_only = rooms.iter().all(|(_, own)| *own == Some(head));
    if !rooms.is_empty() && !own_only && np.det != Det::Each && out.container.is_none() {
        out.container = Some(head);
    }
    out.rooms.extend(rooms);
}

/// Whether a room that is listed among the things of another one is a room beside it: the bathroom of a bedroom, the kitchen
/// of a restaurant.
fn is_annex(of: &str, room: &str) -> bool {
    const STORES: [&str; 5] = ["storeroom", "store room", "stockroom", "stock room", "storage room"];
    /// What shops, libraries, gyms and the like have next door for their guests.
    const GUESTS: [&str; 9] =
        ["bakery", "cafe", "coffee shop", "gift shop", "massage room", "nail salon", "sauna", "steam room", "workshop"];
    let kind = |name: &str| get().room(name).map_or("", |kind| kind.name);
    let of_kind = crate::furnish::kinds::of(of);
    let furnished = of_kind.map_or("", |kind| kind.name);
    // What has no dress is furnished as at home, but for these.
    let is_public = of_kind
        .is_some_and(|kind| !kind.dress.is_empty() || matches!(kind.name, "furniture store" | "gallery" | "museum"));
    if is_public && GUESTS.contains(&room) && crate::furnish::kinds::of(room).is_some_and(|kind| kind.name != furnished)
    {
        return true;
    }
    match furnished {
        "treatment room" | "veterinary clinic" | "dental surgery" | "spa" | "tattoo studio" | "hair salon" => {
            return matches!(room, "waiting room" | "reception room") || STORES.contains(&room);
        }
        "recording studio" => return room == "control room",
        "patient room" | "care room" | "hotel suite" => return kind(room) == "bathroom",
        "pharmacy" | "bank" | "museum" | "gallery" => return STORES.contains(&room),
        "warehouse" | "factory hall" | "workshop" | "woodworking shop" | "repair garage" => {
            return matches!(room, "office" | "break room" | "locker room") || STORES.contains(&room);
        }
        _ => {}
    }
    match kind(of) {
        "bedroom" | "office" | "library" | "classroom" | "lobby" => kind(room) == "bathroom",
        "restaurant" | "cafe" | "bar room" => matches!(kind(room), "bathroom" | "kitchen") || STORES.contains(&room),
        "shop" => kind(room) == "bathroom" || STORES.contains(&room),
        "gym" => kind(room) == "bathroom" || matches!(room, "changing room" | "locker room"),
        _ => false,
    }
}

/// Whether such a room has things of this name in it: a clothes shop its fitting rooms.
fn is_furniture(room: &str, noun: &str) -> bool {
    let kind = crate::furnish::kinds::of(room);
    kind.is_some_and(|kind| kind.lines.iter().any(|line| line.noun == noun))
}

/// "each with its own bathroom", "with an en-suite bathroom".
fn owned(chunks: &[Chunk], tokens: &[Token], i: usize) -> bool {
    let is_own = |at: Range<usize>| tokens[at].iter().any(|token| OWN.iter().any(|own| token.is(own)));
    let mut k = i;
    while k > 0 && !matches!(chunks[k].piece, ChunkPiece::Comma | ChunkPiece::And | ChunkPiece::Stop | ChunkPiece::Line)
    {
        if is_own(chunks[k].at.clone()) {
            return true;
        }
        k -= 1;
        if room(&chunks[k]).is_some() {
            break;
        }
    }
    false
}

/// Whether one sleeps in a room of this name at home: "kids room", "parents bedroom".
pub fn sleeps(name: &str) -> bool {
    const SLEEP: [&str; 4] = ["bedroom", "kids room", "teen room", "nursery"];
    crate::furnish::kinds::of(name).is_some_and(|kind| SLEEP.contains(&kind.name))
}

/// "Second" of the second bedroom, "kids" of the kids' room: one of several rooms, not all of them. What it is called.
pub fn one_of(np: &Np, kind_words: usize, said: &[Token]) -> Option<String> {
    const WHICH: [&str; 15] = [
        "first", "second", "third", "fourth", "fifth", "last", "other", "master", "main", "primary", "larger",
        "smaller", "large", "small", "guest",
    ];
    if !matches!(np.det, Det::Definite | Det::Own | Det::None) || np.count.is_some() || np.many {
        return None;
    }
    let name = np.name();
    let before = &np.words[..np.words.len() - kind_words];
    let which = np.nth.is_some() || np.words.first().is_some_and(|w| WHICH.contains(&w.as_str()));
    if which && before.len() <= 1 || sleeps(&name) && name != "bedroom" {
        return Some(name);
    }
    // "The smaller bedroom": the size is a look of other rooms.
    let size = said.iter().find_map(|token| match token.text.as_str() {
        "small" | "smaller" | "little" | "smallest" => Some("small"),
        "large" | "larger" | "big" | "bigger" | "largest" | "biggest" => Some("large"),
        "other" => Some("other"),
        _ => None,
    })?;
    before.is_empty().then(|| format!("{size} {name}"))
}

/// Doors that are said to be between two rooms, with the chunks that say so.
pub fn connect(brief: &mut Brief, chunks: &[Chunk], tokens: &[Token], found: &Rooms) -> Vec<Range<usize>> {
    let spoken = |i: usize| found.spoken.get(&i).copied().filter(|_| chunks.get(i).and_then(room).is_some());
    let piece = |i: usize| chunks.get(i).map(|c| &c.piece);
    let mut said = Vec::new();
    for i in 0..chunks.len() {
        // "a door between the kitchen and the hall"
        if matches!(piece(i), Some(ChunkPiece::Rel(Rel::Between)))
            && matches!(piece(i + 2), Some(ChunkPiece::And))
            && let (Some(a), Some(b)) = (spoken(i + 1), spoken(i + 3))
            && let Some(door) =
                i.checked_sub(1).filter(|k| chunks[*k].np().is_some_and(|np| np.group == Some(Group::Door)))
        {
            said.push((a, b, door..i + 4));
        }
        // "the kitchen opens into the living room"
        let Some(a) = spoken(i).filter(|_| matches!(piece(i + 1), Some(ChunkPiece::Verb(Verb::Lead)))) else {
            continue;
        };
        let to = (i + 2..i + 5).find(|k| chunks.get(*k).is_some_and(|c| room(c).is_some()));
        let Some((to, b)) = to.and_then(|k| Some((k, spoken(k)?))) else { continue };
        if (i + 2..to).all(|k| matches!(piece(k), Some(ChunkPiece::Rel(_) | ChunkPiece::Word(_)))) {
            said.push((a, b, i..to + 1));
        }
    }
    let mut used = Vec::new();
    for (a, b, range) in said.into_iter().filter(|(a, b, _)| a != b) {
        let words = chunks[range.start].at.start..chunks[range.end - 1].at.end;
        let bytes = tokens[words.start].at.start..tokens[words.end - 1].at.end;
        let joins =
            |t: &Thing| t.group == Group::Door && t.beyond.is_some_and(|to| [(a, b), (b, a)].contains(&(t.room, to)));
        used.push(words);
        if brief.things.iter().any(joins) {
            continue;
        }
        let own = brief.things.iter_mut().find(|t| {
            let at = t.source.at();
            t.group == Group::Door
                && t.beyond.is_none()
                && at.start >= bytes.start
                && at.end <= bytes.end
                && !at.is_empty()
        });
        match own {
            Some(door) => (door.room, door.beyond) = (a, Some(b)),
            None => brief.things.push(door(a, b, ThingOrigin::Stated(bytes))),
        }
    }
    used
}

fn door(room: usize, beyond: usize, source: ThingOrigin) -> Thing {
    Thing {
        words: vec!["door".into()],
        last: 1,
        group: Group::Door,
        number: Number::Unsaid,
        of: None,
        room,
        beyond: Some(beyond),
        places: None,
        look: Look::default(),
        size: [None; 3],
        source,
        part: None,
    }
}

/// Makes as many rooms as are asked for. What is said of a room that there are several of is said of each of them; a number
/// of things that is not said of each is divided among them.
pub fn expand(brief: &mut Brief, several: &[Several]) {
    let mut copies: Vec<Vec<usize>> = (0..brief.rooms.len()).map(|room| vec![room]).collect();
    let mut models: Vec<usize> = Vec::new();
    for (room, of) in several.iter().enumerate() {
        if let Some(all) = of.like {
            copies[all].push(room);
        }
    }
    for room in 0..several.len() {
        let count = several[room].own.map_or(several[room].count, |own| several[own].count.max(several[room].count));
        let named = copies[room].len();
        if several[room].like.is_some() || count < 2 {
            continue;
        }
        let room_for = super::rooms::MOST.saturating_sub(brief.rooms.len());
        for _ in 0..count.saturating_sub(named).min(room_for) {
            copies[room].push(brief.rooms.len());
            let new = Room { source: brief.rooms[room].source.clone(), ..brief.rooms[room].clone() };
            brief.rooms.push(new);
        }
        let is_model = named > count;
        let to = copies[room][usize::from(is_model)..].to_vec();
        divide(brief, room, &to);
        for copy in to.iter().filter(|copy| **copy != room) {
            copy_things(brief, room, *copy);
        }
        if is_model {
            copies[room].remove(0);
            models.push(room);
        }
    }
    for (room, of) in several.iter().enumerate() {
        let Some(owner) = of.own else { continue };
        let source = brief.rooms[room].source.clone();
        for (own, of) in copies[room].clone().into_iter().zip(copies[owner].clone()) {
            brief.things.push(door(of, own, source.clone()));
        }
    }
    models.into_iter().rev().for_each(|room| remove(brief, room));
}

/// Removes a room that stood for several of which each has a room of its own by now.
fn remove(brief: &mut Brief, room: usize) {
    let is_there = |thing: &Thing| thing.room == room || thing.beyond == Some(room);
    let gone: Vec<usize> = (0..brief.things.len()).filter(|i| is_there(&brief.things[*i])).collect();
    brief.remove(&gone);
    for thing in &mut brief.things {
        thing.room -= usize::from(thing.room > room);
        thing.beyond = thing.beyond.map(|beyond| beyond - usize::from(beyond > room));
    }
    brief.rooms.remove(room);
}

/// A number of things in several rooms is that of all of them together, unless "each" is said: the first room gets its share,
/// and so do the things that are copied to the others.
fn divide(brief: &mut Brief, room: usize, to: &[usize]) {
    let n = to.len();
    let own: Vec<usize> = (0..brief.things.len()).filter(|i| brief.things[*i].room == room).collect();
    for thing in own {
        let words = sentence(&brief.request, &brief.things[thing].source.at()).to_lowercase();
        let each = words.split(|c: char| !c.is_alphabetic()).any(|w| matches!(w, "each" | "every" | "both"));
        let Number::Exactly(total) = brief.things[thing].number else { continue };
        if each || total < 2 || brief.things[thing].part.is_some() {
            continue;
        }
        for (k, copy) in to.iter().enumerate().skip(1) {
            let share = total / n + usize::from(k < total % n);
            if share > 0 && brief.things.len() < MOST_THINGS {
                let number = Number::Exactly(share);
                brief.things.push(Thing { room: *copy, number, ..brief.things[thing].clone() });
            }
        }
        brief.things[thing].number = Number::Exactly(total / n + usize::from(!total.is_multiple_of(n)));
    }
}

/// Copies what is in a room to another like it.
fn copy_things(brief: &mut Brief, room: usize, copy: usize) {
    let mut new: BTreeMap<usize, usize> = BTreeMap::new();
    let same = |a: &Thing, b: &Thing| a.source == b.source && a.words == b.words && a.part == b.part;
    for i in 0..brief.things.len() {
        let thing = &brief.things[i];
        let here = thing.room == room || thing.opening() && thing.beyond == Some(room);
        let there = brief.things.iter().any(|other| other.room == copy && same(other, thing));
        if !here || there || brief.things.len() >= MOST_THINGS {
            continue;
        }
        let mut thing = thing.clone();
        if thing.room == room {
            thing.room = copy;
        } else {
            thing.beyond = Some(copy);
        }
        match &mut thing.part {
            Some(part) => match new.get(&part.of) {
                Some(of) => part.of = *of,
                None => continue,
            },
            None => {
                if let Number::Each { of, .. } = &mut thing.number {
                    *of = new.get(of).copied().unwrap_or(*of);
                }
            }
        }
        new.insert(i, brief.things.len());
        brief.things.push(thing);
    }
    let facts: Vec<_> = brief
        .facts
        .iter()
        .filter_map(|fact| {
            let mut fact = fact.clone();
            let moved = |list: &[usize]| list.iter().map(|i| new.get(i).copied()).collect::<Option<Vec<usize>>>();
            fact.of = moved(&fact.of)?;
            if let Some(to) = fact.what.objects_mut() {
                *to = moved(to)?;
            }
            Some(fact)
        })
        .collect();
    brief.facts.extend(facts);
}
