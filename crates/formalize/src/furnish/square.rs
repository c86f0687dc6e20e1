//! What no plan found a place for is left to the solver. If it is large, it stands square to the walls all the same: nobody puts a
//! counter across the room.

use super::stand;
use crate::brief::Group;
use crate::draft::{Demand, Draft, DraftThing, Statement, ThingOrigin};
use crate::names::{calls, mentions};

/// From this width on a thing is large (metres).
const LARGE: f64 = 0.9;
/// What is lower lies on the floor (metres).
const LOW: f64 = 0.3;
/// The product of both parts of a direction that is within one degree of a wall's.
const SQUARE: f64 = 0.02;

/// Statements that settle which way a thing looks.
const TURNS: [&str; 9] =
    ["inCorner", "facing", "looksAt", "angle", "parallel", "aligned", "around", "connects", "wallMounted"];

/// Adds that large things stand square to the walls.
pub fn to_the_walls(draft: &mut Draft) {
    for at in 0..draft.things.len() {
        let thing = &draft.things[at];
        if !is_large(thing) || !has_square_room(draft, thing) || is_settled(draft, thing) {
            continue;
        }
        let name = &thing.name;
        let square = |x: &str| format!("abs({x}.front.x * {x}.front.z) <= {SQUARE}");
        let text = if thing.count == 1 { square(name) } else { format!("forall a in {name}: {}", square("a")) };
        let source = ThingOrigin::Inferred("it stands square to the walls".to_owned());
        draft.statements.push(Statement::new(&format!("assert {text};"), source));
    }
}

fn is_large(thing: &DraftThing) -> bool {
    let group = stand::group(&thing.category);
    let stands = matches!(group, Group::Table | Group::Storage | Group::Bed | Group::Seat);
    // What holds things is drawn square, whatever it is called.
    let turned = |feature: &str| {
        matches!(feature, "diagonal" | "angled")
            || matches!(feature, "round" | "circular") && matches!(group, Group::Table | Group::Seat)
    };
    let free = thing.look.features.iter().any(|feature| turned(feature));
    stands && !free && thing.size.is_some_and(|[w, h, d]| w.max(d) >= LARGE && h > LOW)
}

/// Whether all walls of a thing's room are parallel to the axes.
fn has_square_room(draft: &Draft, thing: &DraftThing) -> bool {
    let Some(room) = thing.room.map(|room| &draft.rooms[room]) else { return false };
    let Some(outline) = &room.outline else { return true };
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).all(|(a, b)| (a[0] - b[0]).abs() < 1e-6 || (a[1] - b[1]).abs() < 1e-6)
}

/// Whether something says which way a thing looks.
fn is_settled(draft: &Draft, thing: &DraftThing) -> bool {
    let name = &thing.name;
    let said = |s: &&Statement| s.demand != Demand::Prefer && mentions(&s.text, name);
    // What is fixed to it is turned as it is.
    let own = |text: &str| {
        text.match_indices(".rot").any(|(at, _)| {
            let rest = text[at + 4..].strip_prefix(".y").unwrap_or(&text[at + 4..]);
            let of = text[..at].ends_with(name.as_str()) || thing.count > 1;
            of && (rest.starts_with(" =") || rest.starts_with(" <-"))
        })
    };
    let turns = |s: &Statement| {
        own(&s.text)
            || s.text.contains(&format!("{name}.front.x"))
            || calls(&s.text).iter().any(|call| TURNS.contains(call))
    };
    draft.statements.iter().filter(said).any(turns)
}
