//! The colours that a request names for a whole room, on its walls and on what stands out by its colour.

use super::kinds;
use super::taste::is_colored;
use crate::brief::Brief;
use crate::colors::{is_shade, known};
use crate::draft::{Draft, Look, ThingOrigin};

/// Colours that walls may have without making a room dark.
const LIGHT: [&str; 17] = [
    "white",
    "offwhite",
    "cream",
    "beige",
    "ivory",
    "sand",
    "linen",
    "lightgray",
    "mint",
    "lavender",
    "peach",
    "lightblue",
    "lightyellow",
    "lightgreen",
    "lightpink",
    "champagne",
    "vanilla",
];

/// Gives what was added another colour where the request rules its own out: "no blue".
pub fn spare(draft: &mut Draft, brief: &Brief) {
    /// What any room may have.
    const PLAIN: [&str; 4] = ["beige", "sage", "terracotta", "lightgray"];
    let ruled_out: Vec<&str> =
        brief.absent.iter().map(|(name, _)| name.as_str()).filter(|name| known(name).is_some()).collect();
    let is_out = |color: &str| ruled_out.iter().any(|out| is_shade(color, out));
    if ruled_out.is_empty() {
        return;
    }
    for room in &mut draft.rooms {
        let usual = kinds::of(&room.kind).map_or(&[][..], |kind| &kind.colors[..]);
        let others: Vec<&str> = usual.iter().chain(&PLAIN).copied().filter(|color| !is_out(color)).collect();
        let Some(first) = others.first() else { continue };
        for look in [&mut room.walls, &mut room.floor] {
            if look.color.as_deref().is_some_and(is_out) {
                look.color = Some(if LIGHT.contains(first) { (*first).to_owned() } else { "offwhite".to_owned() });
            }
        }
    }
    let kinds: Vec<String> = draft.rooms.iter().map(|room| room.kind.clone()).collect();
    for (turn, thing) in draft.things.iter_mut().enumerate() {
        let added = matches!(thing.source, ThingOrigin::Inferred(_));
        if !added || !thing.look.color.as_deref().is_some_and(is_out) {
            continue;
        }
        let usual = thing.room.and_then(|at| kinds::of(&kinds[at])).map_or(&[][..], |kind| &kind.colors[..]);
        let others: Vec<&str> = usual.iter().chain(&PLAIN).copied().filter(|color| !is_out(color)).collect();
        thing.look.color = others.get(turn % others.len().max(1)).map(|color| (*color).to_owned());
    }
}

/// Paints the rooms of a furnished draft. What has a colour that was asked for keeps it.
pub fn paint(draft: &mut Draft, brief: &Brief) {
    for (at, asked) in brief.rooms.iter().enumerate().filter(|(_, room)| !room.palette.is_empty()) {
        let Some(room) = draft.rooms.get_mut(at) else { continue };
        let usual = kinds::of(&room.kind);
        let light = asked.palette.iter().find(|color| LIGHT.contains(&color.as_str()));
        let said = asked.walls != Look::default();
        // One colour alone is that of the walls.
        let walls = light.or_else(|| asked.palette.first().filter(|_| asked.palette.len() == 1));
        if let Some(color) = walls.filter(|_| !said) {
            room.walls.color = Some(color.clone());
        }
        // What stands before the walls is of another colour, if there is one.
        let others: Vec<&String> = asked.palette.iter().filter(|color| Some(*color) != light).collect();
        let colors = if others.is_empty() { asked.palette.iter().collect() } else { others };
        let mut turn = 0;
        for thing in draft.things.iter_mut().filter(|thing| thing.room == Some(at)) {
            let usual = usual.is_some_and(|kind| kind.colors.iter().any(|c| thing.look.color.as_deref() == Some(*c)));
            let plain = thing.look.color.is_none() && thing.look.material.is_none();
            let free = match thing.source {
                ThingOrigin::Stated(_) => plain,
                ThingOrigin::Inferred(_) => plain || usual,
            };
            if free && is_colored(&thing.category.replace('_', " ")) {
                thing.look.color = Some(colors[turn % colors.len()].clone());
                turn += 1;
            }
        }
        // Where nothing shows a colour, the walls do, in a light tone of it.
        if turn == 0 && !said && light.is_some() {
            let tone = colors[0];
            room.walls.color = Some(known(&format!("light{tone}")).unwrap_or_else(|| tone.clone()));
        }
    }
}
