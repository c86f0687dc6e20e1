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

/// What a word means in its room: a bed in a ward is a hospital bed, twin beds are beds for one.
pub fn refine(brief: &mut Brief) {
    for at in 0..brief.things.len() {
        let thing = &brief.things[at];
        if thing.part.is_some() || thing.opening() || thing.size.iter().any(Option::is_some) || thing.words.len() != 1 {
            continue;
        }
        let known = |words: &str| scenelang_lang::nouns::noun(words).is_some();
        let said = thing.look.features.iter().map(|feature| format!("{feature} {}", thing.words[0]));
        let said = said.enumerate().find(|(_, name)| known(name));
        let meant = || {
            let kind = kinds::of(&brief.rooms.get(thing.room)?.name)?;
            let (_, noun) = kind.means.iter().find(|(plain, _)| *plain == thing.words[0])?;
            known(noun).then(|| (*noun).to_owned())
        };
        let thing = match said {
            Some((feature, name)) => {
                brief.things[at].look.features.remove(feature);
                Some(name)
            }
            None => meant(),
        }
        .map(|name| (at, name));
        if let Some((at, name)) = thing {
            brief.things[at].words = name.split(' ').map(str::to_owned).collect();
            brief.things[at].last = brief.things[at].words.len();
        }
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
