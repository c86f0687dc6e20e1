//! For how many people a room is: "for eight people", "seating ten guests".

use super::number;
use super::token::Token;
use crate::brief::Room;

/// How many people, and where that is said.
fn people(tokens: &[Token]) -> Option<(usize, usize)> {
    const WHO: [&str; 10] = [
        "people",
        "persons",
        "guests",
        "participants",
        "attendees",
        "colleagues",
        "members",
        "employees",
        "visitors",
        "diners",
    ];
    const MOST: f64 = 40.0;
    (0..tokens.len()).filter(|&i| tokens[i].is("for") || tokens[i].is("seating")).find_map(|i| {
        let (n, words) = number::count(&tokens[i + 1..])?;
        let who = tokens.get(i + 1 + words)?;
        (n > 1.0 && n <= MOST && WHO.iter().any(|w| who.is(w))).then_some((n as usize, tokens[i].at.start))
    })
}

/// Writes it into the room that is spoken of there.
pub fn count(rooms: &mut [Room], tokens: &[Token]) {
    let Some((people, at)) = people(tokens) else { return };
    let room = rooms.iter().rposition(|room| room.source.at().start <= at).unwrap_or(0);
    if let Some(room) = rooms.get_mut(room) {
        room.people = Some(people);
    }
}
