//! What is known of a model besides its triangles: the card, a JSON file beside it.
//!
//! `chair.json` is the card of `chair.glb`. Every member may be missing; members that are not known are passed over.

use crate::faults::{Fault, fault};
use scenelang_assets::words;
use scenelang_base::codes;
use scenelang_layout::Vec3;
use serde::Deserialize;

/// Sizes beyond this are no furniture (metres).
const LARGEST: f64 = 1000.0;

/// What is known of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Card {
    /// The noun. Without a card, the words of the file's name.
    pub category: String,
    /// A sentence.
    pub description: String,
    /// A WordNet synset: `chair.n.01`.
    pub synset: String,
    /// What it is made of.
    pub materials: Vec<String>,
    /// Extents w, h, d in metres once its front is turned to +z; the numbers in the file are scaled to it.
    pub size: Option<Vec3>,
    /// Whether the file has z upward instead of y.
    pub z_up: bool,
    /// Where its front is: degrees from the usual front of the file (+z; −y where z is up) towards its +x.
    pub front: Option<f64>,
    /// Under which licence it may be used.
    pub licence: Option<String>,
    /// Kilograms.
    pub mass: Option<f64>,
}

/// The file's text.
#[derive(Deserialize)]
struct Written {
    category: Option<String>,
    description: Option<String>,
    synset: Option<String>,
    materials: Option<OneOrMore>,
    size: Option<[f64; 3]>,
    up: Option<String>,
    front: Option<Front>,
    #[serde(alias = "license")]
    licence: Option<String>,
    mass: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum OneOrMore {
    One(String),
    More(Vec<String>),
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Front {
    Degrees(f64),
    Axis(String),
}

impl Card {
    /// Of a file without a card: its name says what it is.
    pub(crate) fn of_name(stem: &str) -> Self {
        Self { category: words(stem).join(" "), ..Self::default() }
    }

    /// Reads the card of the model with this name (without its ending).
    pub(crate) fn read(bytes: &[u8], stem: &str) -> Result<Self, Fault> {
        let wrong = |why: String| fault(codes::E0705, format!("its card {stem}.json cannot be used: {why}"));
        let written: Written = serde_json::from_slice(bytes).map_err(|e| wrong(e.to_string()))?;
        let z_up = match written.up.as_deref() {
            None | Some("y" | "+y") => false,
            Some("z" | "+z") => true,
            Some(other) => return Err(wrong(format!("`up` must be \"y\" or \"z\", not {other:?}"))),
        };
        let front = match written.front {
            None => None,
            Some(Front::Degrees(degrees)) => Some(degrees.rem_euclid(360.0)),
            Some(Front::Axis(axis)) => Some(degrees_of(&axis, z_up).ok_or_else(|| {
                let axes = if z_up { "\"-y\", \"+x\", \"+y\" or \"-x\"" } else { "\"+z\", \"+x\", \"-z\" or \"-x\"" };
                wrong(format!("`front` must be {axes}, or an angle in degrees, not {axis:?}"))
            })?),
        };
        if let Some(size) = written.size
            && !size.iter().all(|x| *x > 0.0 && *x <= LARGEST)
        {
            return Err(wrong(format!(
                "`size` must be three lengths in metres, each greater than 0 and at most {LARGEST}"
            )));
        }
        Ok(Self {
            category: written.category.unwrap_or_else(|| words(stem).join(" ")),
            description: written.description.unwrap_or_default(),
            synset: written.synset.unwrap_or_default(),
            materials: match written.materials {
                None => Vec::new(),
                Some(OneOrMore::One(one)) => vec![one],
                Some(OneOrMore::More(more)) => more,
            },
            size: written.size.map(Vec3::from),
            z_up,
            front,
            licence: written.licence.filter(|l| !l.trim().is_empty()),
            mass: written.mass,
        })
    }
}

/// Where an axis points, as degrees from the usual front.
fn degrees_of(axis: &str, z_up: bool) -> Option<f64> {
    Some(match (axis, z_up) {
        ("z" | "+z", false) | ("-y", true) => 0.0,
        ("x" | "+x", _) => 90.0,
        ("-z", false) | ("y" | "+y", true) => 180.0,
        ("-x", _) => 270.0,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> String {
        match Card::read(text.as_bytes(), "oak_chair2") {
            Ok(card) => {
                format!("{} front {:?} size {:?}", card.category, card.front, card.size.map(|s| [s.x, s.y, s.z]))
            }
            Err(fault) => fault.message,
        }
    }

    #[test]
    fn a_card_says_what_it_says_or_why_it_cannot_be_used() {
        for (text, wanted) in [
            ("{}", "oak chair front None size None"),
            (r#"{"category": "stool", "front": "-x", "more": 1}"#, "stool front Some(270.0) size None"),
            (r#"{"front": -90, "size": [1, 2, 3]}"#, "oak chair front Some(270.0) size Some([1.0, 2.0, 3.0])"),
            (r#"{"front": "-y", "up": "z"}"#, "oak chair front Some(0.0) size None"),
            (
                r#"{"front": "y"}"#,
                "its card oak_chair2.json cannot be used: `front` must be \"+z\", \"+x\", \"-z\" or \"-x\", or an angle in degrees, not \"y\"",
            ),
            (r#"{"up": "w"}"#, "its card oak_chair2.json cannot be used: `up` must be \"y\" or \"z\", not \"w\""),
            (
                r#"{"size": [1, 0, 3]}"#,
                "its card oak_chair2.json cannot be used: `size` must be three lengths in metres, each greater than 0 and at most 1000",
            ),
            (
                r#"{"size": [1, 1e9, 3]}"#,
                "its card oak_chair2.json cannot be used: `size` must be three lengths in metres, each greater than 0 and at most 1000",
            ),
        ] {
            assert_eq!(said(text), wanted, "{text}");
        }
        assert!(said("{").contains("cannot be used: EOF"), "{}", said("{"));
    }
}
