//! What things look like: a colour, a material and a feature, each drawn or left out, of what such a thing can have.

use super::dice::Dice;
use scenelang_lang::nouns::{Stands, noun};

/// How a thing looks; what is empty is not said.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct ThingLook {
    pub colour: &'static str,
    pub material: &'static str,
    pub feature: &'static str,
}

impl ThingLook {
    /// The adjectives in their order, each with a blank after it.
    pub fn before(&self) -> String {
        [self.colour, self.material].iter().filter(|w| !w.is_empty()).map(|w| format!("{w} ")).collect()
    }

    /// What comes after the noun, with a blank before it.
    pub fn after(&self) -> String {
        if self.feature.is_empty() { String::new() } else { format!(" {}", self.feature) }
    }
}

const COLOURS: [&str; 19] = [
    "white",
    "black",
    "gray",
    "beige",
    "brown",
    "navy",
    "teal",
    "olive",
    "maroon",
    "red",
    "blue",
    "green",
    "yellow",
    "orange",
    "turquoise",
    "coral",
    "ivory",
    "tan",
    "purple",
];
const HARD: [&str; 8] = ["oak", "walnut", "birch", "pine", "ash", "steel", "bamboo", "beech"];
const SEATS: [&str; 7] = ["oak", "beech", "leather", "velvet", "linen", "rattan", "steel"];
const SOFT: [&str; 4] = ["linen", "cotton", "wool", "velvet"];
const SMALL: [&str; 4] = ["plastic", "steel", "brass", "aluminium"];
const STANDING: [&str; 6] = [
    "with slim legs",
    "with rounded edges",
    "with brass details",
    "with a matt finish",
    "with clean lines",
    "in a retro look",
];
const OTHER: [&str; 4] = ["with a thin frame", "with a matt finish", "in a simple shape", "with soft edges"];
/// Last words of what is sat on.
const SAT_ON: [&str; 12] =
    ["chair", "sofa", "stool", "armchair", "bench", "recliner", "chaise", "pouf", "ottoman", "daybed", "booth", "seat"];
/// Last words of what grows, and has the colour that it has.
const GROWS: [&str; 2] = ["plant", "box"];

/// Draws how a thing looks.
pub(crate) fn look(dice: &mut Dice, name: &str) -> ThingLook {
    let last = name.rsplit(' ').next().unwrap_or(name);
    let stands = noun(name).map_or(Stands::Floor, |n| n.stands);
    let (materials, features): (&[&str], &[&str]) = match stands {
        _ if SAT_ON.contains(&last) => (&SEATS, &STANDING),
        Stands::Soft => (&SOFT, &OTHER),
        Stands::Floor | Stands::Back => (&HARD, &STANDING),
        _ => (&SMALL, &OTHER),
    };
    let [colour, material, feature] = [dice.chance(0.6), dice.chance(0.5), dice.chance(0.3)];
    // Each draw is made whether it counts or not, so that the stream of numbers does not depend on the noun.
    let one = [&COLOURS[..], materials, features].map(|words| *dice.one(words));
    let drawn = ThingLook { colour: one[0], material: one[1], feature: one[2] };
    let some = |is: bool, word: &'static str| if is && !GROWS.contains(&last) { word } else { "" };
    ThingLook {
        colour: some(colour, drawn.colour),
        material: some(material, drawn.material),
        feature: some(feature, drawn.feature),
    }
}
