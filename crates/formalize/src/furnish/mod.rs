//! A draft is furnished: what rooms of a kind have, what goes with a thing, openings, light, materials and colours.
//!
//! What is added to a thing is fixed to it by equations, so that the search moves it as one piece with the thing; only what
//! stands by itself is placed by the search. Nothing is added that is asked for, ruled out, or could be counted as either.

mod build;
mod choose;
mod drop;
mod floor;
mod groups;
mod kinds;
mod number;
mod openings;
mod place;
mod plan;
mod room;
mod seek;
mod slots;
mod stand;
mod taste;

use crate::brief::Brief;
use crate::draft::Draft;
use number::{Scale, scale};

/// Gives each room of a brief the usual size of its kind, for as many people as are said, and as small or large as is
/// said.
pub fn measure(brief: &mut Brief) {
    for at in 0..brief.rooms.len() {
        let Some(kind) = kinds::of(&brief.rooms[at].name) else { continue };
        let [w, h, d] = kind.size;
        let mut area = w * d;
        if let Some(people) = brief.rooms[at].people {
            area = (area + (people as f64 - kind.people) * kind.each).max(0.5 * area);
        }
        area *= match scale(brief, at) {
            Scale::Small => 0.75,
            Scale::Usual => 1.0,
            Scale::Large => 1.4,
        };
        let by = (area / (w * d)).sqrt();
        brief.rooms[at].usual = Some([w * by, h, d * by]);
    }
}

/// Adds to each room of a draft what such rooms have.
pub fn furnish(draft: &mut Draft, brief: &Brief) {
    let mut closed: Vec<String> = draft.things.iter().map(|thing| thing.category.replace('_', " ")).collect();
    closed.extend(brief.absent.iter().map(|(name, _)| name.clone()));
    for at in 0..draft.rooms.len() {
        room::furnish(draft, brief, at, &closed);
    }
}
