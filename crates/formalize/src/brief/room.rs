//! A room of a brief.

use super::{Look, ThingOrigin};

/// A room, as far as the request describes it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Room {
    /// Its kind in the singular: "meeting room".
    pub name: String,
    /// Width, height and depth, where they are said.
    pub size: [Option<f64>; 3],
    /// Square metres, where they are said.
    pub area: Option<f64>,
    /// How many corners an even outline has: 8 for "octagonal". `None`: a rectangle.
    pub corners: Option<usize>,
    /// How many people it is for.
    pub people: Option<usize>,
    /// Whether nothing is in it but what is asked for: "with only a bed".
    pub only: bool,
    /// Usual width, height and depth of its kind, for so many people; set when a request is completed.
    pub usual: Option<[f64; 3]>,
    /// The colours that it is to have, if the request names some for the whole room.
    pub palette: Vec<String>,
    /// The style that it is to have, as `data/styles.txt` calls it: "art deco".
    pub style: Option<&'static str>,
    pub floor: Look,
    pub walls: Look,
    /// Where it comes from.
    pub source: ThingOrigin,
}
