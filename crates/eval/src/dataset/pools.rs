//! The tables of the dataset: buildings with their rooms and what is in them, attributes of rooms, how requests are worded.

use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Where a thing is, with what that is said of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ThingPlace {
    /// Its back at a wall.
    Wall,
    Corner,
    /// In the middle of the room.
    Middle,
    /// Anywhere on the floor.
    Floor,
    /// All of them in one row.
    Row,
    /// On a wall.
    Hung,
    Ceiling,
    /// On the top of another thing.
    On(&'static str),
    /// One at each of other things, turned to it.
    At(&'static str),
    /// Around another thing, turned to it.
    Around(&'static str),
    /// At a side of another thing.
    Beside(&'static str),
    /// Within a metre of another thing.
    Near(&'static str),
    /// In front of another thing.
    Before(&'static str),
    /// Hung from the ceiling above another thing.
    Over(&'static str),
}

impl ThingPlace {
    /// The noun of the other thing.
    pub fn other(self) -> Option<&'static str> {
        match self {
            Self::On(n) | Self::At(n) | Self::Around(n) | Self::Beside(n) | Self::Near(n) | Self::Before(n) => Some(n),
            Self::Over(n) => Some(n),
            _ => None,
        }
    }

    /// The rule of the grammar that speaks of it.
    pub fn rule(self) -> &'static str {
        match self {
            Self::Wall => "wall",
            Self::Corner => "corner",
            Self::Middle => "middle",
            Self::Floor => "floor",
            Self::Row => "row",
            Self::Hung => "hung",
            Self::Ceiling => "ceiling",
            Self::On(_) => "on",
            Self::At(_) => "at",
            Self::Around(_) => "around",
            Self::Beside(_) => "beside",
            Self::Near(_) => "near",
            Self::Before(_) => "before",
            Self::Over(_) => "over",
        }
    }

    fn read(text: &'static str) -> Option<Self> {
        let (word, other) = text.split_once(' ').unwrap_or((text, ""));
        let place = match word {
            "wall" => Self::Wall,
            "corner" => Self::Corner,
            "middle" => Self::Middle,
            "floor" => Self::Floor,
            "row" => Self::Row,
            "hung" => Self::Hung,
            "ceiling" => Self::Ceiling,
            "on" => Self::On(other),
            "at" => Self::At(other),
            "around" => Self::Around(other),
            "beside" => Self::Beside(other),
            "near" => Self::Near(other),
            "before" => Self::Before(other),
            "over" => Self::Over(other),
            _ => return None,
        };
        (place.other().is_some() != other.is_empty()).then_some(place)
    }
}

/// What a room of a kind has: at most so many of something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    /// At most so many.
    pub most: u32,
    pub noun: &'static str,
    /// Where.
    pub place: ThingPlace,
}

/// A kind of room.
#[derive(Debug)]
pub(crate) struct RoomPool {
    /// What it is called.
    pub name: &'static str,
    /// Each noun once; what a thing refers to stands before it.
    pub items: Vec<Item>,
}

/// A kind of building and its pool of rooms.
#[derive(Debug)]
pub(crate) struct Building {
    /// What it is called.
    pub name: &'static str,
    pub kinds: Vec<RoomPool>,
}

/// Something that is said of a room.
#[derive(Debug)]
pub(crate) struct Attribute {
    /// What it is about.
    pub what: &'static str,
    /// What can be said.
    pub values: Vec<&'static str>,
    /// How; `_` stands for the value.
    pub phrases: Vec<&'static str>,
}

/// All tables.
pub(crate) struct Tables {
    /// The five kinds of buildings.
    pub buildings: Vec<Building>,
    /// What any room may have beside its own.
    pub common: Vec<Vec<Item>>,
    /// The attributes of rooms.
    pub attributes: Vec<Attribute>,
    /// The rules of the grammar with their alternatives.
    pub grammar: BTreeMap<&'static str, Vec<&'static str>>,
}

impl Tables {
    /// The alternatives of a rule; a test holds that each rule that is asked for is there.
    pub fn rule(&self, name: &str) -> &[&'static str] {
        self.grammar.get(name).map_or(&[""], Vec::as_slice)
    }
}

const POOLS: &str = include_str!("../../data/pools.txt");
/// Sections of the pools that are no building.
const NO_BUILDING: [&str; 2] = ["sets", "common"];

/// The tables, read once.
pub(crate) fn tables() -> &'static Tables {
    static TABLES: OnceLock<Tables> = OnceLock::new();
    TABLES.get_or_init(|| Tables {
        buildings: buildings(POOLS),
        common: sections(POOLS)
            .iter()
            .filter(|(name, _)| *name == "common")
            .flat_map(|(_, of)| lines(of))
            .map(|(_, text)| items(text))
            .collect(),
        attributes: attributes(include_str!("../../data/attributes.txt")),
        grammar: sections(include_str!("../../data/grammar.txt")).into_iter().collect(),
    })
}

/// The lines of each `[section]`, without comments.
fn sections(text: &'static str) -> Vec<(&'static str, Vec<&'static str>)> {
    let mut out: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            out.push((name, Vec::new()));
        } else if let Some((_, lines)) = out.last_mut() {
            lines.push(line);
        }
    }
    out
}

/// What stands before and after the sign.
fn lines(of: &[&'static str]) -> Vec<(&'static str, &'static str)> {
    of.iter().filter_map(|line| line.split_once(" = ")).collect()
}

fn items(text: &'static str) -> Vec<Item> {
    let one = |text: &'static str| {
        let (count, rest) = text.trim().split_once(' ')?;
        let (noun, place) = rest.split_once(": ")?;
        Some(Item { most: count.parse().ok()?, noun, place: ThingPlace::read(place)? })
    };
    text.split(';').filter_map(one).collect()
}

fn buildings(text: &'static str) -> Vec<Building> {
    let sections = sections(text);
    let sets: BTreeMap<&str, Vec<Item>> = sections
        .iter()
        .filter(|(name, _)| *name == "sets")
        .flat_map(|(_, of)| lines(of))
        .map(|(name, text)| (name, items(text)))
        .collect();
    let kind = |(name, text): (&'static str, &'static str)| {
        let (named, own) = text.split_once('|').unwrap_or((text, ""));
        let mut all: Vec<Item> = Vec::new();
        let of_sets = named.split_whitespace().filter_map(|set| sets.get(set)).flatten().copied();
        for item in of_sets.chain(items(own)) {
            // Two sets may have the same thing; what a set refers to may be in a later one only by mistake.
            if all.iter().all(|other| other.noun != item.noun) {
                all.push(item);
            }
        }
        RoomPool { name, items: all }
    };
    let rooms = sections.iter().filter(|(name, _)| !NO_BUILDING.contains(name));
    rooms.map(|(name, of)| Building { name, kinds: lines(of).into_iter().map(kind).collect() }).collect()
}

fn attributes(text: &'static str) -> Vec<Attribute> {
    let line = |line: &'static str| {
        let mut parts = line.split(" | ").map(str::trim);
        let (what, values) = (parts.next()?, parts.next()?);
        Some(Attribute { what, values: values.split(", ").collect(), phrases: parts.collect() })
    };
    text.lines().filter(|l| !l.starts_with('#')).filter_map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::nouns::{Stands, noun};

    /// What is written is read: no line is passed over, no set or noun is unknown.
    #[test]
    fn every_line_of_the_pools_is_read() {
        let text = POOLS;
        let written = text.lines().flat_map(|l| l.split([';', '=', '|'])).filter(|part| part.contains(": "));
        let things = |text: &'static str| text.lines().filter_map(|l| l.split_once(" = ")).map(|(_, t)| t);
        let read: usize = things(text).map(|t| items(t.rsplit('|').next().unwrap_or(t)).len()).sum();
        assert_eq!(read, written.filter(|part| !part.trim_start().starts_with('#')).count());
        let sets: Vec<&str> = sections(text)[0].1.iter().filter_map(|l| l.split_once(" = ")).map(|(n, _)| n).collect();
        for (name, lines) in sections(text).into_iter().filter(|(name, _)| !NO_BUILDING.contains(name)) {
            for (room, of) in lines.iter().map(|l| l.split_once(" = ").unwrap_or_else(|| panic!("{name}: {l}"))) {
                let named = of.split('|').next().unwrap_or("").split_whitespace();
                named.for_each(|set| assert!(sets.contains(&set), "{name}, {room}: there is no set {set}"));
            }
        }
    }

    #[test]
    fn pools_are_as_large_as_the_published_ones_and_things_are_where_they_can_be() {
        let buildings = &tables().buildings;
        let names: Vec<&str> = buildings.iter().map(|b| b.name).collect();
        assert_eq!(names, ["apartment", "mall", "office", "restaurant", "school"]);
        for building in buildings {
            assert!(building.kinds.len() >= 36, "{}: {}", building.name, building.kinds.len());
            for kind in &building.kinds {
                let wrong = |item: &Item, why: &str| panic!("{}, {}: {} {why}", building.name, kind.name, item.noun);
                for (i, item) in kind.items.iter().enumerate() {
                    let known = noun(item.noun).unwrap_or_else(|| wrong(item, "is no noun"));
                    let fits = match item.place {
                        ThingPlace::Hung => known.stands == Stands::Wall,
                        ThingPlace::Ceiling | ThingPlace::Over(_) => known.stands == Stands::Ceiling,
                        ThingPlace::On(_) => matches!(known.stands, Stands::Top | Stands::Soft),
                        _ => matches!(known.stands, Stands::Floor | Stands::Back),
                    };
                    assert!(fits && (1..=5).contains(&item.most), "{}, {}: {item:?}", building.name, kind.name);
                    if let Some(other) = item.place.other() {
                        let before = &kind.items[..i];
                        assert!(before.iter().any(|o| o.noun == other), "{}: nothing before {item:?}", kind.name);
                    }
                }
                assert!(kind.items.len() >= 5, "{}, {}", building.name, kind.name);
            }
        }
    }

    #[test]
    fn attributes_can_be_said() {
        let all = &tables().attributes;
        assert!(all.len() >= 15, "a room has up to 15 of them");
        for attribute in all {
            assert!(attribute.values.len() >= 5 && attribute.phrases.len() >= 3, "{}", attribute.what);
            assert!(attribute.phrases.iter().all(|p| p.matches('_').count() == 1), "{}", attribute.what);
        }
    }
}
