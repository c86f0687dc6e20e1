//! A thing of a brief: its noun, how many, how it looks, and where it is.

use super::Dim;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A thing, or several like ones; a door or a window too.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing {
    /// The words of its name in the singular: "coffee", "table".
    pub words: Vec<String>,
    /// How many of the last words are one noun.
    pub last: usize,
    /// How such things usually are in a room.
    pub group: Group,
    /// How many.
    pub number: Number,
    /// What it holds or consists of, as part of its name: "honey" of a jar of honey.
    pub of: Option<String>,
    /// The room it is in, an index.
    pub room: usize,
    /// For a door or a window: the room on the other side. `None`: the outside.
    pub beyond: Option<usize>,
    /// For how many people: "a table for six".
    pub places: Option<usize>,
    pub look: Look,
    /// Width, height and depth, where they are said.
    pub size: [Option<f64>; 3],
    /// Where it comes from.
    pub source: ThingOrigin,
    /// Set where this is no thing of its own, but some of another: "the first exit", "two of them".
    pub part: Option<Subset>,
}

/// How many there are of a thing, as the request says it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Number {
    /// Nothing is said: one.
    #[default]
    Unsaid,
    /// A plural without a number: "chairs".
    Plural,
    /// "several", "a few": three or more.
    Several,
    Exactly(usize),
    AtLeast(usize),
    /// So many for each of another thing, an index.
    Each {
        /// The other thing.
        of: usize,
        /// How many for each.
        number: usize,
    },
}

impl Number {
    /// The number that is said, for each of another thing where it is of that kind.
    pub fn said(self) -> Option<usize> {
        match self {
            Self::Exactly(n) | Self::AtLeast(n) | Self::Each { number: n, .. } => Some(n),
            Self::Unsaid | Self::Plural | Self::Several => None,
        }
    }

    /// Whether it is so many for each of another thing.
    pub fn follows(self) -> bool {
        matches!(self, Self::Each { .. })
    }

    /// Whether the thing is spoken of in the plural.
    pub fn many(self) -> bool {
        match self {
            Self::Unsaid => false,
            Self::Exactly(n) | Self::AtLeast(n) => n > 1,
            Self::Plural | Self::Several | Self::Each { .. } => true,
        }
    }
}

/// How a thing usually is in a room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// To sit on.
    Seat,
    /// With a top that things stand on.
    Table,
    Storage,
    /// To sleep on.
    Bed,
    /// Other things on the floor; also what no table knows.
    Floor,
    Wall,
    /// Under the ceiling.
    Ceiling,
    /// On top of something.
    Top,
    /// A television, a screen: hangs or stands.
    Screen,
    /// Flat on the floor.
    Flat,
    /// Lies on seats and beds.
    Soft,
    /// Hangs along windows.
    Drape,
    /// A way through a wall.
    Door,
    /// A view through a wall.
    Window,
}

/// What a thing looks like, in the words of the request.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// As the request says it.
    pub color: Option<String>,
    /// In one or a few words: "oak".
    pub material: Option<String>,
    /// What else is said of it: "with armrests".
    pub features: Vec<String>,
}

/// Where something comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ThingOrigin {
    /// The request says so, in these bytes.
    Stated(Range<usize>),
    /// Rooms of the kind need it, or the world does: the sentence says why.
    Inferred(String),
}

impl Default for ThingOrigin {
    fn default() -> Self {
        Self::Stated(0..0)
    }
}

impl ThingOrigin {
    /// The bytes of the request; empty where it does not say so.
    pub fn at(&self) -> Range<usize> {
        match self {
            Self::Stated(at) => at.clone(),
            Self::Inferred(_) => 0..0,
        }
    }

    /// Why it was added, if the request does not say so.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Stated(_) => None,
            Self::Inferred(why) => Some(why),
        }
    }
}

/// Some of several like things.
#[derive(Clone, Debug, PartialEq)]
pub struct Subset {
    /// The thing, an index.
    pub of: usize,
    pub pick: Pick,
}

/// Which of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pick {
    /// So many, from this one on: "one of them", "the second exit".
    Run(usize, usize),
    /// All from this one on: "the others".
    Rest(usize),
    Last,
    /// "half of the desks".
    Half,
    /// "every second counter".
    Every(usize),
    /// The one in the middle of a row.
    Row(usize),
}

impl Pick {
    /// The indices of so many elements that stand in so many rows.
    pub fn indices(self, count: usize, rows: usize) -> Vec<usize> {
        let last = count.max(1) - 1;
        let all = 0..=last;
        let some: Vec<usize> = match self {
            Self::Run(from, n) => all.skip(from).take(n).collect(),
            Self::Rest(from) => all.skip(from).collect(),
            Self::Last => vec![],
            Self::Half => all.take((count / 2).max(1)).collect(),
            Self::Every(n) => all.skip(n.max(1) - 1).step_by(n.max(1)).collect(),
            Self::Row(row) => {
                let columns = count.div_ceil(rows.max(1)).max(1);
                let row = row.min(rows.max(1) - 1);
                vec![(row * columns + (columns - 1) / 2).min(last)]
            }
        };
        if some.is_empty() { vec![last] } else { some }
    }
}

/// What furniture has doors, drawers or lids, by its last word: of other things nothing opens, whatever a request says.
const OPENING: [&str; 24] = [
    "armoire",
    "cabinet",
    "chest",
    "closet",
    "credenza",
    "cupboard",
    "desk",
    "dishwasher",
    "drawers",
    "dresser",
    "dryer",
    "freezer",
    "fridge",
    "locker",
    "microwave",
    "nightstand",
    "oven",
    "refrigerator",
    "sideboard",
    "stove",
    "toilet",
    "vitrine",
    "wardrobe",
    "washer",
];

/// Whether furniture of this name has doors, drawers or a lid.
pub fn opens(word: &str) -> bool {
    OPENING.contains(&word)
}

impl Thing {
    /// Whether it is furniture with doors, drawers or a lid.
    pub fn has_doors(&self) -> bool {
        self.words.last().is_some_and(|word| opens(word))
    }

    /// Whether so many people sit at each of several tables: "six tables for eight". More are all of them together.
    pub fn seats_each(&self) -> bool {
        const AT_ONE: usize = 12;
        let several = self.number.said().is_some_and(|n| n > 1);
        self.group == Group::Table && several && self.places.is_some_and(|n| n <= AT_ONE)
    }

    /// The noun: "table" of a coffee table.
    pub fn head(&self) -> String {
        self.words[self.words.len().saturating_sub(self.last)..].join(" ")
    }

    /// Its whole name.
    pub fn name(&self) -> String {
        self.words.join(" ")
    }

    /// Whether it is a plant that is said to be small.
    pub fn is_small_plant(&self) -> bool {
        const SMALL: [&str; 6] = ["small", "tiny", "little", "mini", "miniature", "potted"];
        const PLANTS: [&str; 9] = ["plant", "succulent", "orchid", "fern", "cactus", "bonsai", "ivy", "herb", "aloe"];
        let mut said = self.look.features.iter().chain(&self.words).flat_map(|words| words.split(' '));
        said.any(|word| SMALL.contains(&word)) && self.words.last().is_some_and(|word| PLANTS.contains(&word.as_str()))
    }

    /// Whether it is a door or a window.
    pub fn opening(&self) -> bool {
        matches!(self.group, Group::Door | Group::Window)
    }

    /// Takes over sizes; "long" and "wide" together are width and depth, "long" alone is the width.
    pub fn take_dims(&mut self, dims: &[(Dim, f64)]) {
        // "6 m long, 1.2 m wide": what was taken for the width is the depth.
        if let ([(Dim::Width, _)], Some(long), None) = (dims, self.size[0], self.size[2]) {
            self.size[2] = Some(long);
        }
        let wide = dims.iter().any(|(d, _)| *d == Dim::Width) || self.size[0].is_some();
        let rod = self.group == Group::Bed;
        for (dim, value) in dims {
            let axis = match dim {
                Dim::Width => 0,
                Dim::Elevation => continue,
                Dim::Height | Dim::Ceiling => 1,
                Dim::Depth => 2,
                // A bed's length is how far it reaches into the room.
                Dim::Length if rod || wide => 2,
                Dim::Length => 0,
                Dim::Across => {
                    self.size[2] = self.size[2].or(Some(*value));
                    0
                }
            };
            // "90 x 60 cm" of what hangs on a wall is as it is seen.
            let axis = if axis == 2 && matches!(self.group, Group::Wall | Group::Screen) && dims.len() == 2 {
                1
            } else {
                axis
            };
            self.size[axis] = Some(*value);
        }
    }
}
