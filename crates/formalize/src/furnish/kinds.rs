//! What rooms of a kind have, from `data/kinds.txt`: their usual size, who is in them, floor, walls, colours, openings,
//! light and inventory. A test reads every line.

use crate::read::lexicon::{plural, singular};
use std::collections::HashMap;
use std::sync::OnceLock;

/// How many of a thing a room has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Count {
    /// So many.
    Fixed(usize),
    /// One for each so many square metres.
    Area(f64),
    /// One for each so many people.
    People(f64),
}

/// Where in the room a thing stands.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanPlace {
    /// With its back at any wall.
    Wall,
    /// In a row with its back at a wall.
    Run,
    Corner,
    Middle,
    /// Anywhere on the floor, parallel to the walls.
    Floor,
    /// In rows that look to the back of the room (+z), or away from it.
    Rows(bool),
    /// At the wall at the back of the room, at a share of its length from the middle (-1 to 1).
    Back(f64),
    /// At the wall at the front of the room.
    Front(f64),
    /// At a distance from the wall at the back, so turned: 180 looks into the room.
    Before(f64, f64),
    /// Near the door and turned to it, with so much room behind it for who works there.
    Service(f64),
    /// At a wall opposite a thing, looking at it.
    Opposite(String),
    /// On a wall, at eye level.
    Hung,
    /// Under the ceiling, spread evenly.
    Ceiling,
    /// Along the open edges of what is outdoors.
    Edge,
}

/// A line of the inventory.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// How many.
    pub count: Count,
    pub noun: &'static str,
    /// Where.
    pub place: PlanPlace,
    /// Only in rooms of at least so many square metres.
    pub least: f64,
    /// Of several in a run: so far apart.
    pub gap: f64,
    /// What it stands or hangs near; empty: nothing in particular.
    pub by: &'static str,
}

/// What hangs at windows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// A pair of curtains, from a rail to the floor.
    Curtains,
    /// A blind that is drawn up.
    Blinds,
}

impl Cover {
    /// What the table of nouns calls it.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Curtains => "curtain",
            Self::Blinds => "blinds",
        }
    }
}

/// A kind of room.
#[derive(Clone, Debug, Default)]
pub struct FurnishingKind {
    /// "living room".
    pub name: &'static str,
    /// What else it is called.
    pub also: Vec<&'static str>,
    /// Usual width, height and depth in metres.
    pub size: [f64; 3],
    /// In a home: square metres, at most so many, and the shorter side in metres. `None`: homes have no such room.
    pub home: Option<[f64; 3]>,
    /// For so many people.
    pub people: f64,
    /// Square metres for each one more.
    pub each: f64,
    /// How much of the floor furniture may take, with the places of who uses it.
    pub fill: f64,
    /// The part of the floor that may be idle: nothing is near it, and nobody needs it.
    pub idle: f64,
    /// Windows for each wall metre of a room with windows: how many in a room of the usual size.
    pub windows: usize,
    /// Width and height of its windows, where these are larger than in homes.
    pub panes: Option<[f64; 2]>,
    /// What the floor is made of, and its colour where the material does not tell.
    pub floor: (&'static str, &'static str),
    /// The colour of the walls.
    pub walls: &'static str,
    /// Colours of textiles and of what else stands out, in turn.
    pub colors: Vec<&'static str>,
    /// What wooden furniture is made of.
    pub wood: &'static str,
    /// What a plain noun means in such a room: a bed in a ward is a hospital bed.
    pub means: Vec<(&'static str, &'static str)>,
    /// The inventory, what matters most first.
    pub lines: Vec<Line>,
    /// In a home without a dining room, what one eats at; the first for which there is room.
    pub eat: Vec<Line>,
    /// Width and height of a wide door for cars and goods, beside the ordinary one.
    pub gate: Option<[f64; 2]>,
    /// How wide the place of a bed is in a ward, and how deep a ward is with beds at one wall and at two.
    pub bay: Option<[f64; 3]>,
    /// A second door, closed, to what such a room always has beside it: a bathroom.
    pub inner: Option<&'static str>,
    /// How its shelves and tables are dressed: `office`, `school`; empty: as at home.
    pub dress: &'static str,
    /// What hangs at its windows.
    pub curtains: Option<Cover>,
}

impl FurnishingKind {
    /// Whether a home eats in such a room, so that the living room needs no dining table.
    pub fn is_eaten_in(&self) -> bool {
        matches!(self.name, "dining room" | "kitchen diner")
    }

    /// Whether people sit in rows and look to the back of the room.
    pub fn is_taught(&self) -> bool {
        // Machines in rows teach nobody.
        let works = |line: &Line| line.noun.ends_with("machine");
        self.lines.iter().any(|line| line.place == PlanPlace::Rows(true) && !works(line))
    }

    /// Whether a television hangs across from the bed.
    pub fn has_hung_screen(&self) -> bool {
        let hangs = self.lines.iter().any(|line| line.noun == "tv" && line.place == PlanPlace::Hung);
        hangs && self.lines.iter().any(|line| line.noun.ends_with("bed"))
    }
}

/// The part of the floor that may be idle in a room, unless its kind says otherwise.
const IDLE: f64 = 0.13;

/// All kinds, in the order of the table.
pub fn all() -> &'static [FurnishingKind] {
    static KINDS: OnceLock<Vec<FurnishingKind>> = OnceLock::new();
    KINDS.get_or_init(|| parse(include_str!("../../data/kinds.txt")))
}

/// The kind whose name ends a room's name: "a small meeting room" is a meeting room.
pub fn of(room: &str) -> Option<&'static FurnishingKind> {
    let words: Vec<String> = room.split_whitespace().map(one).collect();
    (0..words.len()).find_map(|from| by_name().get(&words[from..].join(" ")).copied())
}

/// The kind that is called so.
pub fn named(room: &str) -> Option<&'static FurnishingKind> {
    let words: Vec<String> = room.split_whitespace().map(one).collect();
    by_name().get(&words.join(" ")).copied()
}

/// All kinds by their names in the singular; of two kinds with the same name the first.
fn by_name() -> &'static HashMap<String, &'static FurnishingKind> {
    static NAMES: OnceLock<HashMap<String, &'static FurnishingKind>> = OnceLock::new();
    NAMES.get_or_init(|| {
        let mut names = HashMap::new();
        for kind in all() {
            for name in kind.also.iter().chain([&kind.name]) {
                names.entry(name.split(' ').map(one).collect::<Vec<_>>().join(" ")).or_insert(kind);
            }
        }
        names
    })
}

/// Whether all who are in such a room sit at a table of this name: not where each has a place of their own elsewhere.
pub fn seats_all(kind: &FurnishingKind, table: &str) -> bool {
    let mut places = kind.lines.iter().filter(|line| matches!(line.count, Count::People(_)));
    places.all(|line| super::stand::counts_as(line.noun, table))
}

/// Whether people sit at several tables in such a room.
pub fn has_tables(kind: &FurnishingKind) -> bool {
    let sits = |line: &Line| {
        matches!(line.count, Count::People(_)) && super::stand::group(line.noun) == crate::brief::Group::Table
    };
    kind.lines.iter().any(sits)
}

/// A word in the singular.
fn one(word: &str) -> String {
    let word = word.trim_end_matches("'s").trim_end_matches('\'');
    if plural(word) { singular(word) } else { word.to_owned() }
}

fn parse(text: &'static str) -> Vec<FurnishingKind> {
    let mut out: Vec<FurnishingKind> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            out.push(FurnishingKind { name, fill: 0.5, idle: IDLE, wood: "oak", ..FurnishingKind::default() });
            continue;
        }
        let Some(kind) = out.last_mut() else { continue };
        match line.split_once(": ") {
            Some((key, value)) => set(kind, key, value),
            None => kind.lines.extend(entry(line)),
        }
    }
    out
}

fn set(kind: &mut FurnishingKind, key: &str, value: &'static str) {
    let list = || value.split(',').map(str::trim).filter(|word| !word.is_empty()).collect::<Vec<_>>();
    let numbers = || value.split_whitespace().filter_map(|n| n.parse().ok()).collect::<Vec<f64>>();
    match key {
        "also" => kind.also = list(),
        "size" => {
            if let [w, d, h] = numbers()[..] {
                kind.size = [w, h, d];
            }
        }
        "people" => {
            if let [people, each] = numbers()[..] {
                (kind.people, kind.each) = (people, each);
            }
        }
        "eat" => kind.eat = value.split(',').filter_map(|line| entry(line.trim())).collect(),
        "bay" => kind.bay = numbers().try_into().ok(),
        "panes" => kind.panes = numbers().try_into().ok(),
        "gate" => kind.gate = numbers().try_into().ok(),
        "inner" => kind.inner = Some(value),
        "dress" => kind.dress = value,
        "curtains" => {
            kind.curtains = match value {
                "yes" => Some(Cover::Curtains),
                "blinds" => Some(Cover::Blinds),
                _ => None,
            }
        }
        "home" => kind.home = numbers().try_into().ok(),
        "idle" => kind.idle = value.parse().unwrap_or(kind.idle),
        "fill" => kind.fill = value.parse().unwrap_or(kind.fill),
        "windows" => kind.windows = value.parse().unwrap_or(0),
        "floor" => kind.floor = value.split_once(',').map_or((value, ""), |(a, b)| (a.trim(), b.trim())),
        "walls" => kind.walls = value,
        "colors" => kind.colors = list(),
        "means" => kind.means = list().into_iter().filter_map(|pair| pair.split_once('=')).collect(),
        "wood" => kind.wood = value,
        _ => {}
    }
}

/// `2 nightstand wall >=12`, `1/8 ceiling light ceiling`, `1p4 table rows`.
fn entry(line: &'static str) -> Option<Line> {
    const PLACES: [&str; 15] = [
        "wall", "run", "corner", "middle", "floor", "rows", "rowsaway", "back", "front", "before", "service",
        "opposite", "hung", "ceiling", "edge",
    ];
    let words: Vec<&'static str> = line.split_whitespace().collect();
    let at = (1..words.len()).rev().find(|i| PLACES.contains(&words[*i]))?;
    let first = *words.first()?;
    let count = match (first.split_once('/'), first.split_once('p')) {
        (Some((_, area)), _) => Count::Area(area.parse().ok()?),
        (_, Some((_, people))) => Count::People(people.parse().ok()?),
        _ => Count::Fixed(first.parse().ok()?),
    };
    // The noun as it stands in the line.
    let begin = line.find(words[1])?;
    let end = words[at].as_ptr() as usize - line.as_ptr() as usize;
    let noun = line.get(begin..end)?.trim();
    let rest = &words[at + 1..];
    let number = || rest.first().and_then(|n| n.parse().ok()).unwrap_or(0.0);
    let place = match words[at] {
        "wall" => PlanPlace::Wall,
        "run" => PlanPlace::Run,
        "corner" => PlanPlace::Corner,
        "middle" => PlanPlace::Middle,
        "floor" => PlanPlace::Floor,
        "rows" => PlanPlace::Rows(true),
        "rowsaway" => PlanPlace::Rows(false),
        "back" => PlanPlace::Back(number()),
        "front" => PlanPlace::Front(number()),
        "before" => PlanPlace::Before(number(), rest.get(1).and_then(|n| n.parse().ok()).unwrap_or(180.0)),
        "service" => PlanPlace::Service(number()),
        "opposite" => {
            PlanPlace::Opposite(rest.iter().take_while(|w| !w.starts_with('>')).copied().collect::<Vec<_>>().join(" "))
        }
        "hung" => PlanPlace::Hung,
        "edge" => PlanPlace::Edge,
        _ => PlanPlace::Ceiling,
    };
    let least = rest.iter().find_map(|w| w.strip_prefix(">=")?.parse().ok()).unwrap_or(0.0);
    let gap = match place {
        PlanPlace::Run => number().max(0.01),
        PlanPlace::Before(..) => rest.get(2).and_then(|n| n.parse().ok()).unwrap_or(0.0),
        _ => 0.0,
    };
    let by = match place {
        PlanPlace::Hung | PlanPlace::Wall | PlanPlace::Floor | PlanPlace::Corner => rest_of(line, rest),
        _ => "",
    };
    Some(Line { count, noun, place, least, gap, by })
}

/// The words of a line from the first of these to the column that begins with `>=`.
fn rest_of(line: &'static str, rest: &[&'static str]) -> &'static str {
    let Some(first) = rest.first() else { return "" };
    let begin = first.as_ptr() as usize - line.as_ptr() as usize;
    line.get(begin..).and_then(|tail| tail.split(">=").next()).unwrap_or("").trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read_and_every_kind_is_whole() {
        let text = include_str!("../../data/kinds.txt");
        let entries = text.lines().map(str::trim);
        let entries = entries.filter(|l| l.starts_with(|c: char| c.is_ascii_digit()));
        for line in entries {
            assert!(entry(line).is_some(), "{line}");
        }
        assert!(all().len() >= 60, "{}", all().len());
        for kind in all() {
            assert!(kind.size.iter().all(|v| *v > 1.5) && kind.people > 0.0 && !kind.walls.is_empty(), "{kind:?}");
            assert!(!kind.floor.0.is_empty() && !kind.colors.is_empty() && !kind.lines.is_empty(), "{kind:?}");
            let lit = kind.lines.iter().any(|l| l.place == PlanPlace::Ceiling);
            let open = kind.name == "garden" || kind.lines.iter().any(|l| l.place == PlanPlace::Edge);
            assert!(lit || open, "{}", kind.name);
            let colors = kind.colors.iter().chain([&kind.walls, &kind.floor.1]).filter(|c| !c.is_empty());
            assert!(colors.clone().all(|c| crate::colors::known(c).is_some()), "{}: {:?}", kind.name, kind.colors);
        }
    }

    #[test]
    fn no_name_has_two_kinds() {
        let mut seen = std::collections::BTreeMap::new();
        for kind in all() {
            for name in kind.also.iter().chain([&kind.name]) {
                assert_eq!(seen.insert(*name, kind.name), None, "{name}");
            }
        }
    }
}
