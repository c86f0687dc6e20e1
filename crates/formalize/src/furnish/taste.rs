//! Materials and colours of what is added.

use super::kinds::FurnishingKind;
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

/// The look of something of a kind of room; `turn` goes through the colours.
pub fn look(kind: &FurnishingKind, noun: &str, turn: usize) -> Look {
    let last = noun.rsplit(' ').next().unwrap_or(noun);
    let mut look = Look::default();
    if noun == "picture" {
        // Another kind of room begins with another.
        let first: usize = kind.name.bytes().map(usize::from).sum();
        look.features.push(SHOWN[(first + turn) % SHOWN.len()].to_owned());
    }
    if UPHOLSTERED.contains(&noun) {
        look.material = Some("fabric".to_owned());
        look.color = kind.colors.first().map(|color| (*color).to_owned());
        return look;
    }
    if is_colored(noun) && !kind.colors.is_empty() {
        look.color = Some(kind.colors[turn % kind.colors.len()].to_owned());
    } else if STEEL.contains(&noun) {
        look.material = Some("steel".to_owned());
    } else if (WOODEN.contains(&last) && !NOT_WOODEN.contains(&noun)) || noun == "kitchen sink" {
        look.material = Some(kind.wood.to_owned());
    }
    look
}

/// What of which no look is said is made of the wood of the room.
pub fn dressed(kind: &FurnishingKind, category: &str, look: &mut Look) {
    if look.color.is_none() && look.material.is_none() {
        look.material = self::look(kind, &category.replace('_', " "), 0).material;
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

/// The floor and the walls of a room of a kind, as far as nothing is said of them.
pub fn surfaces(kind: &FurnishingKind, floor: &mut Surface, walls: &mut Surface) {
    if floor.material.is_none() && floor.color.is_none() {
        floor.material = Some(kind.floor.0.to_owned());
        floor.color = Some(kind.floor.1.to_owned()).filter(|c| !c.is_empty());
    }
    if walls.material.is_none() && walls.color.is_none() {
        walls.color = Some(kind.walls.to_owned());
    }
}
