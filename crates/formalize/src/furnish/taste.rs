//! Materials and colours of what is added.

use super::kinds::{self, FurnishingKind};
use super::styles::{self, Style};
use crate::brief::Brief;
use crate::draft::{Draft, DraftThing, Look, Surface, ThingOrigin};

/// What is made of cloth, or stands out by its colour.
const COLORED: [&str; 22] = [
    "rug",
    "carpet",
    "sofa",
    "armchair",
    "cushion",
    "throw",
    "curtain",
    "pouf",
    "ottoman",
    "bench cushion",
    "blanket",
    "vase",
    "booth",
    "loveseat",
    "mat",
    "yoga mat",
    "bean bag",
    "lounge chair",
    "play mat",
    "towel",
    "box",
    "locker",
];
/// Chairs on which one sits for hours.
const UPHOLSTERED: [&str; 3] = ["conference chair", "meeting chair", "visitor chair"];

/// What is made of wood, if anything.
const WOODEN: [&str; 29] = [
    "table",
    "desk",
    "chair",
    "stool",
    "bench",
    "nightstand",
    "wardrobe",
    "bookshelf",
    "bookcase",
    "shelf",
    "sideboard",
    "dresser",
    "cabinet",
    "bed",
    "stand",
    "counter",
    "bar",
    "lectern",
    "chest",
    "rack",
    "drawers",
    "island",
    "workbench",
    "platform",
    "stage",
    "case",
    "cupboard",
    "pew",
    "crib",
];

/// What is not made of wood though others of its kind are.
const NOT_WOODEN: [&str; 25] = [
    "office chair",
    "desk chair",
    "lab bench",
    "bar stool",
    "exam table",
    "examination table",
    "treatment table",
    "therapy table",
    "massage table",
    "operating table",
    "barber chair",
    "weight bench",
    "dumbbell rack",
    "tool chest",
    "hospital bed",
    "music stand",
    "repair stand",
    "server rack",
    "squat rack",
    "power rack",
    "tire rack",
    "iv stand",
    "pallet rack",
    "storage rack",
    "warehouse rack",
];

/// What is made of steel wherever it stands.
const STEEL: [&str; 4] = ["tool cabinet", "control cabinet", "electrical cabinet", "safety cabinet"];

/// What pictures show, in turn.
const SHOWN: [&str; 5] = ["abstract", "botanical", "landscape", "geometric", "seascape"];

/// Whether something is of cloth, or stands out by its colour.
pub fn is_colored(noun: &str) -> bool {
    let last = noun.rsplit(' ').next().unwrap_or(noun);
    COLORED.iter().any(|c| *c == noun || *c == last)
}

/// What decides how a room looks: its kind, and the style that the request names for it, if any.
#[derive(Clone, Copy, Debug)]
pub struct Taste {
    kind: &'static FurnishingKind,
    style: Option<&'static Style>,
}

impl Taste {
    pub fn new(kind: &'static FurnishingKind, style: Option<&str>) -> Self {
        Self { kind, style: style.and_then(styles::named) }
    }

    fn colors(&self) -> &'static [&'static str] {
        self.style.map_or(&self.kind.colors, |style| &style.colors)
    }

    fn wood(&self) -> &'static str {
        self.style.map_or(self.kind.wood, |style| style.wood)
    }

    /// The look of something that is added; `turn` goes through the colours.
    pub fn look(&self, noun: &str, turn: usize) -> Look {
        let (last, colors) = (noun.rsplit(' ').next().unwrap_or(noun), self.colors());
        let mut look = Look::default();
        if noun == "picture" {
            // Another kind of room begins with another.
            let first: usize = self.kind.name.bytes().map(usize::from).sum();
            look.features.push(SHOWN[(first + turn) % SHOWN.len()].to_owned());
        }
        if UPHOLSTERED.contains(&noun) {
            look.material = Some("fabric".to_owned());
            look.color = colors.first().map(|color| (*color).to_owned());
            return look;
        }
        if is_colored(noun) && !colors.is_empty() {
            look.color = Some(colors[turn % colors.len()].to_owned());
        } else if STEEL.contains(&noun) {
            look.material = Some("steel".to_owned());
        } else if (WOODEN.contains(&last) && !NOT_WOODEN.contains(&noun)) || noun == "kitchen sink" {
            look.material = Some(self.wood().to_owned());
        }
        look
    }

    /// What is asked for and of which no look is said is made of the wood of the room; where the room has a style, textiles
    /// have its colours, in turn.
    pub fn dress(&self, category: &str, look: &mut Look, turn: &mut usize) {
        if look.color.is_some() || look.material.is_some() {
            return;
        }
        let usual = self.look(&category.replace('_', " "), *turn);
        look.material = usual.material;
        if self.style.is_some() && usual.color.is_some() {
            look.color = usual.color;
            *turn += 1;
        }
    }

    /// The floor and the walls, as far as nothing is said of them.
    pub fn surfaces(&self, floor: &mut Surface, walls: &mut Surface) {
        let said = |name: &str| Some(name.to_owned()).filter(|name| !name.is_empty());
        if floor.material.is_none() && floor.color.is_none() {
            let (material, color) = self.style.map_or(self.kind.floor, |style| style.floor);
            (floor.material, floor.color) = (said(material), said(color));
        }
        if walls.material.is_none() && walls.color.is_none() {
            let (material, color) = self.style.map_or(("", self.kind.walls), |style| style.walls);
            (walls.material, walls.color) = (said(material), said(color));
        }
    }
}

/// The units of a kitchen look like the worktop that is asked for.
pub fn fitted(draft: &mut Draft, at: usize) {
    const UNITS: [&str; 5] =
        ["kitchen_counter", "kitchen_base_cabinet", "base_cabinet", "wall_cabinet", "kitchen_sink"];
    let is_unit = |it: &DraftThing| it.room == Some(at) && UNITS.contains(&it.category.as_str());
    let is_asked = |it: &&DraftThing| is_unit(it) && matches!(it.source, ThingOrigin::Stated(_));
    let Some(asked) = draft.things.iter().find(is_asked).map(|it| it.look.clone()) else { return };
    for it in draft.things.iter_mut().filter(|it| is_unit(it) && !matches!(it.source, ThingOrigin::Stated(_))) {
        (it.look.color, it.look.material) = (asked.color.clone(), asked.material.clone());
    }
}

/// Floors and walls of rooms that are to have a style, in a draft to which nothing is added.
pub fn style(draft: &mut Draft, brief: &Brief) {
    for (room, asked) in draft.rooms.iter_mut().zip(&brief.rooms).filter(|(_, asked)| asked.style.is_some()) {
        if let Some(kind) = kinds::of(&room.kind).or_else(|| kinds::of("room")) {
            Taste::new(kind, asked.style).surfaces(&mut room.floor, &mut room.walls);
        }
    }
}
