//! The brief as JSON, for people and programs to look at and edit. Things and rooms have names there in place of
//! indices; a name is theirs alone. Its schema is `brief` among those of `scenelang schema`.

mod said;

use super::{
    Brief, Clause, Group, Look, MOST_COUNT, MOST_THINGS, Note, Number, Pick, Room, Subset, Thing, ThingOrigin, Word,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::Range;

/// What the format calls itself.
pub const FORMAT: &str = "scenelang.brief/1";

/// Lengths and areas are above zero and at most this (metres, square metres).
const LARGEST: f64 = 1e6;

/// A brief as text.
pub fn write(brief: &Brief) -> String {
    let text = serde_json::to_string_pretty(&Wire::of(brief))
        .expect("a brief may contain only objects, lists, strings and numbers");
    text + "\n"
}

/// A brief of a text.
///
/// # Errors
/// What is wrong with it, with line and column or with the path of the member.
pub fn read(text: &str) -> Result<Brief, String> {
    let wire: Wire = serde_json::from_str(text).map_err(|e| e.to_string())?;
    wire.brief()
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wire {
    format: String,
    request: String,
    rooms: Vec<WireRoom>,
    things: Vec<WireThing>,
    facts: Vec<said::WireFact>,
    #[serde(default)]
    absent: Vec<WireAbsent>,
    #[serde(default)]
    notes: Vec<WireNote>,
    #[serde(default)]
    clauses: Vec<WireClause>,
    #[serde(default)]
    words: Vec<WireWord>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireRoom {
    id: String,
    kind: String,
    #[serde(default)]
    size: [Option<f64>; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    area: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    corners: Option<usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    people: Option<usize>,
    #[serde(default, skip_serializing_if = "is_false")]
    only: bool,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    palette: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    style: Option<String>,
    #[serde(default, skip_serializing_if = "plain")]
    floor: WireLook,
    #[serde(default, skip_serializing_if = "plain")]
    walls: WireLook,
    source: WireSource,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireThing {
    id: String,
    noun: Vec<String>,
    #[serde(default = "one")]
    head: usize,
    group: Group,
    number: WireNumber,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    of: Option<String>,
    room: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    beyond: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    places: Option<usize>,
    #[serde(default, skip_serializing_if = "plain")]
    look: WireLook,
    #[serde(default, skip_serializing_if = "unsized_")]
    size: [Option<f64>; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    part: Option<WirePart>,
    source: WireSource,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum WireNumber {
    Unsaid,
    Plural,
    Several,
    Exactly(usize),
    AtLeast(usize),
    Each { of: String, number: usize },
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WirePart {
    of: String,
    pick: Pick,
}

#[derive(Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct WireLook {
    #[serde(skip_serializing_if = "Option::is_none")]
    color: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    material: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    features: Vec<String>,
}

/// Bytes of the request with the words there, which nobody needs to write; or a reason.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum WireSource {
    Stated {
        bytes: [usize; 2],
        #[serde(default)]
        words: String,
    },
    Inferred(String),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireAbsent {
    name: String,
    bytes: [usize; 2],
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireNote {
    bytes: [usize; 2],
    reason: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireClause {
    bytes: [usize; 2],
    understood: bool,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireWord {
    bytes: [usize; 2],
    used: bool,
}

fn one() -> usize {
    1
}

fn is_false(value: &bool) -> bool {
    !value
}

fn plain(look: &WireLook) -> bool {
    *look == WireLook::default()
}

fn unsized_(size: &[Option<f64>; 3]) -> bool {
    *size == [None; 3]
}

/// Names of rooms or things: their own words, with a number where there are several of that name.
fn ids(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut taken: BTreeMap<String, usize> = BTreeMap::new();
    let mut out: Vec<String> = Vec::new();
    for name in names {
        let mut id = name.clone();
        while out.contains(&id) {
            let n = taken.entry(name.clone()).or_insert(1);
            *n += 1;
            id = format!("{name} {n}");
        }
        out.push(id);
    }
    out
}

fn bytes(at: &Range<usize>) -> [usize; 2] {
    [at.start, at.end]
}

impl WireSource {
    fn of(source: &ThingOrigin, request: &str) -> Self {
        match source {
            ThingOrigin::Stated(at) => {
                Self::Stated { bytes: bytes(at), words: request.get(at.clone()).unwrap_or("").to_owned() }
            }
            ThingOrigin::Inferred(why) => Self::Inferred(why.clone()),
        }
    }
}

impl WireLook {
    fn of(look: &Look) -> Self {
        Self { color: look.color.clone(), material: look.material.clone(), features: look.features.clone() }
    }

    fn look(self) -> Look {
        Look { color: self.color, material: self.material, features: self.features }
    }
}

impl Wire {
    fn of(brief: &Brief) -> Self {
        let request = brief.request.as_str();
        let rooms = ids(brief.rooms.iter().map(|room| room.name.clone()));
        let things = ids(brief.things.iter().map(Thing::name));
        let wire_room = |(room, id): (&Room, &String)| WireRoom {
            id: id.clone(),
            kind: room.name.clone(),
            size: room.size,
            area: room.area,
            corners: room.corners,
            people: room.people,
            only: room.only,
            palette: room.palette.clone(),
            style: room.style.map(str::to_owned),
            floor: WireLook::of(&room.floor),
            walls: WireLook::of(&room.walls),
            source: WireSource::of(&room.source, request),
        };
        let wire_thing = |(thing, id): (&Thing, &String)| WireThing {
            id: id.clone(),
            noun: thing.words.clone(),
            head: thing.last,
            group: thing.group,
            number: match thing.number {
                Number::Unsaid => WireNumber::Unsaid,
                Number::Plural => WireNumber::Plural,
                Number::Several => WireNumber::Several,
                Number::Exactly(n) => WireNumber::Exactly(n),
                Number::AtLeast(n) => WireNumber::AtLeast(n),
                Number::Each { of, number } => WireNumber::Each { of: things[of].clone(), number },
            },
            of: thing.of.clone(),
            room: rooms[thing.room].clone(),
            beyond: thing.beyond.map(|beyond| rooms[beyond].clone()),
            places: thing.places,
            look: WireLook::of(&thing.look),
            size: thing.size,
            part: thing.part.as_ref().map(|part| WirePart { of: things[part.of].clone(), pick: part.pick }),
            source: WireSource::of(&thing.source, request),
        };
        Self {
            format: FORMAT.to_owned(),
            request: request.to_owned(),
            rooms: brief.rooms.iter().zip(&rooms).map(wire_room).collect(),
            things: brief.things.iter().zip(&things).map(wire_thing).collect(),
            facts: brief.facts.iter().map(|fact| said::WireFact::of(fact, &things, request)).collect(),
            absent: brief.absent.iter().map(|(name, at)| WireAbsent { name: name.clone(), bytes: bytes(at) }).collect(),
            notes: brief
                .notes
                .iter()
                .map(|note| WireNote { bytes: bytes(&note.at), reason: note.reason.clone() })
                .collect(),
            clauses: brief
                .clauses
                .iter()
                .map(|clause| WireClause { bytes: bytes(&clause.at), understood: clause.understood })
                .collect(),
            words: brief.words.iter().map(|word| WireWord { bytes: bytes(&word.at), used: word.used }).collect(),
        }
    }

    fn brief(self) -> Result<Brief, String> {
        if self.format != FORMAT {
            return Err(format!("format: expected \"{FORMAT}\", found \"{}\"", self.format));
        }
        let scope = Scope {
            request: &self.request,
            rooms: index("rooms", self.rooms.iter().map(|room| &room.id))?,
            things: index("things", self.things.iter().map(|thing| &thing.id))?,
        };
        if self.rooms.is_empty() {
            return Err("rooms: a brief needs at least one room".into());
        }
        if self.things.len() > MOST_THINGS {
            return Err(format!("things: there are more than {MOST_THINGS}"));
        }
        let rooms = self.rooms.into_iter().enumerate().map(|(i, room)| scope.room(&format!("rooms[{i}]"), room));
        let rooms = rooms.collect::<Result<Vec<_>, _>>()?;
        let things = self.things.into_iter().enumerate().map(|(i, thing)| scope.thing(&format!("things[{i}]"), thing));
        let things = things.collect::<Result<Vec<_>, _>>()?;
        let facts = self.facts.into_iter().enumerate().map(|(i, fact)| fact.fact(&format!("facts[{i}]"), &scope));
        let facts = facts.collect::<Result<Vec<_>, _>>()?;
        if facts.len() > 4 * MOST_THINGS {
            return Err(format!("facts: there are more than {}", 4 * MOST_THINGS));
        }
        let at = |name: &str, i: usize, bytes| scope.bytes(&format!("{name}[{i}].bytes"), bytes);
        let absent = self.absent.into_iter().enumerate().map(|(i, a)| Ok((a.name, at("absent", i, a.bytes)?)));
        let note = |(i, n): (usize, WireNote)| Ok(Note { at: at("notes", i, n.bytes)?, reason: n.reason });
        let clause =
            |(i, c): (usize, WireClause)| Ok(Clause { at: at("clauses", i, c.bytes)?, understood: c.understood });
        let word = |(i, w): (usize, WireWord)| Ok(Word { at: at("words", i, w.bytes)?, used: w.used });
        let absent = absent.collect::<Result<_, String>>()?;
        let notes = self.notes.into_iter().enumerate().map(note).collect::<Result<_, String>>()?;
        let clauses = self.clauses.into_iter().enumerate().map(clause).collect::<Result<_, String>>()?;
        let words = self.words.into_iter().enumerate().map(word).collect::<Result<_, String>>()?;
        let brief = Brief { request: self.request.clone(), rooms, things, facts, absent, notes, clauses, words };
        for (i, thing) in brief.things.iter().enumerate() {
            let whole = thing.part.as_ref().map(|part| &brief.things[part.of]);
            if whole.is_some_and(|whole| whole.part.is_some() || whole.group != thing.group) {
                return Err(format!(
                    "things[{i}].part.of: expected a thing of the same group that is not itself a part"
                ));
            }
        }
        for start in 0..brief.things.len() {
            let follow = std::iter::successors(Some(start), |thing| brief.depends(*thing));
            if follow.take(brief.things.len() + 1).count() > brief.things.len() {
                return Err(format!("things[{start}].number: it depends on itself"));
            }
        }
        Ok(brief)
    }
}

/// The index of each name.
fn index<'a>(what: &str, ids: impl Iterator<Item = &'a String>) -> Result<BTreeMap<String, usize>, String> {
    let mut out = BTreeMap::new();
    for (i, id) in ids.enumerate() {
        if let Some(first) = out.insert(id.clone(), i) {
            return Err(format!("{what}[{i}].id: \"{id}\" is already the name of {what}[{first}]"));
        }
    }
    Ok(out)
}

/// What the names of a document stand for.
struct Scope<'a> {
    request: &'a str,
    rooms: BTreeMap<String, usize>,
    things: BTreeMap<String, usize>,
}

impl Scope<'_> {
    fn a_room(&self, path: &str, id: &str) -> Result<usize, String> {
        self.rooms.get(id).copied().ok_or_else(|| format!("{path}: there is no room \"{id}\""))
    }

    fn a_thing(&self, path: &str, id: &str) -> Result<usize, String> {
        self.things.get(id).copied().ok_or_else(|| format!("{path}: there is no thing \"{id}\""))
    }

    fn bytes(&self, path: &str, [start, end]: [usize; 2]) -> Result<Range<usize>, String> {
        match self.request.get(start..end) {
            Some(_) => Ok(start..end),
            None => Err(format!("{path}: [{start}, {end}] is not a range of bytes in the request")),
        }
    }

    fn source(&self, path: &str, source: WireSource) -> Result<ThingOrigin, String> {
        Ok(match source {
            WireSource::Stated { bytes, .. } => {
                ThingOrigin::Stated(self.bytes(&format!("{path}.stated.bytes"), bytes)?)
            }
            WireSource::Inferred(why) => ThingOrigin::Inferred(why),
        })
    }

    fn length(path: &str, v: f64) -> Result<f64, String> {
        if v > 0.0 && v <= LARGEST { Ok(v) } else { Err(format!("{path}: expected a number above 0, found {v}")) }
    }

    fn size(path: &str, size: [Option<f64>; 3]) -> Result<[Option<f64>; 3], String> {
        size.iter().flatten().try_for_each(|v| Self::length(&format!("{path}.size"), *v).map(drop))?;
        Ok(size)
    }

    fn room(&self, path: &str, room: WireRoom) -> Result<Room, String> {
        if room.corners.is_some_and(|n| !(3..=64).contains(&n)) {
            return Err(format!("{path}.corners: expected 3 to 64"));
        }
        Ok(Room {
            name: room.kind,
            size: Self::size(path, room.size)?,
            area: room.area.map(|area| Self::length(&format!("{path}.area"), area)).transpose()?,
            corners: room.corners,
            people: room.people.map(|n| n.min(MOST_COUNT)),
            only: room.only,
            // Completion decides it.
            usual: None,
            style: room.style.and_then(|style| crate::furnish::styles::named(&style)).map(|style| style.name),
            palette: room.palette.iter().filter_map(|color| crate::colors::known(color)).collect(),
            floor: room.floor.look(),
            walls: room.walls.look(),
            source: self.source(&format!("{path}.source"), room.source)?,
        })
    }

    fn thing(&self, path: &str, thing: WireThing) -> Result<Thing, String> {
        if thing.head == 0 || thing.head > thing.noun.len() {
            return Err(format!(
                "{path}.head: expected 1 to {}, the number of words in the noun",
                thing.noun.len().max(1)
            ));
        }
        let own = self.a_thing(path, &thing.id)?;
        let number = match thing.number {
            WireNumber::Unsaid => Number::Unsaid,
            WireNumber::Plural => Number::Plural,
            WireNumber::Several => Number::Several,
            WireNumber::Exactly(n) => Number::Exactly(n),
            WireNumber::AtLeast(n) => Number::AtLeast(n),
            WireNumber::Each { of, number } => {
                Number::Each { of: self.a_thing(&format!("{path}.number.each.of"), &of)?, number }
            }
        };
        let part = match thing.part {
            Some(part) => {
                let of = self.a_thing(&format!("{path}.part.of"), &part.of)?;
                // Parts are of what was named before, so that no part is of a part of itself.
                if of >= own {
                    return Err(format!("{path}.part.of: \"{}\" must come before its part", part.of));
                }
                Some(Subset { of, pick: part.pick })
            }
            None => None,
        };
        Ok(Thing {
            words: thing.noun,
            last: thing.head,
            group: thing.group,
            number,
            of: thing.of,
            room: self.a_room(&format!("{path}.room"), &thing.room)?,
            beyond: thing.beyond.map(|id| self.a_room(&format!("{path}.beyond"), &id)).transpose()?,
            places: thing.places.map(|n| n.min(MOST_COUNT)),
            look: thing.look.look(),
            size: Self::size(path, thing.size)?,
            source: self.source(&format!("{path}.source"), thing.source)?,
            part,
        })
    }
}
