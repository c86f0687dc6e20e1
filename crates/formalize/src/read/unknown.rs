//! Tells which objects and kinds of rooms of a request are in none of the tables: they become plain boxes and plain rooms.

use crate::brief::{Brief, Group, Note, ThingOrigin};
use crate::furnish::kinds;
use scenelang_base::suggest;
use scenelang_lang::library;

/// The things and rooms of a request that are not known, each once.
pub fn notes(brief: &Brief) -> Vec<Note> {
    let mut out: Vec<Note> = Vec::new();
    let things = brief.things.iter().filter(|thing| {
        let opening = matches!(thing.group, Group::Door | Group::Window);
        thing.part.is_none() && !opening && matches!(thing.source, ThingOrigin::Stated(_))
    });
    for thing in things.filter(|thing| !library::is_known(&thing.name())) {
        let meant = library::nearest_category(&thing.name());
        let reason = format!("unknown object, drawn as a plain box{}", question(meant.as_deref()));
        out.push(Note { at: thing.source.at(), reason });
    }
    let names = || kinds::all().iter().flat_map(|kind| std::iter::once(kind.name).chain(kind.also.iter().copied()));
    for room in brief.rooms.iter().filter(|room| !room.source.at().is_empty()) {
        // A noun that is in no table was taken for a room: "a kitchn".
        let noun = room.name.strip_suffix(" room").unwrap_or(&room.name);
        let is_known = kinds::of(&room.name).is_some_and(|kind| kind.name != "room");
        if let Some(meant) = suggest::nearest(noun, names()).filter(|meant| !is_known && is_slip(noun, meant)) {
            out.push(Note { at: room.source.at(), reason: format!("unknown kind of room{}", question(Some(meant))) });
        }
    }
    out.dedup();
    out
}

/// Whether a word is probably a misspelling of another: "kitchn" of "kitchen", and "scriptorium" not of "auditorium".
fn is_slip(noun: &str, meant: &str) -> bool {
    noun != meant && noun.chars().next() == meant.chars().next()
}

fn question(meant: Option<&str>) -> String {
    meant.map_or(String::new(), |meant| format!("; did you mean \"{meant}\"?"))
}
