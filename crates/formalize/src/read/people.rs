//! For how many people a room is: "for eight people", "seating ten guests", "for six".

use super::number;
use super::token::{Kind, Token};
use crate::brief::Room;

/// How many people, and where that is said.
fn people(tokens: &[Token]) -> Option<(usize, usize)> {
    const WHO: [&str; 18] = [
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
        "pupils",
        "students",
        "children",
        "kids",
        "adults",
        "workers",
        "patients",
        "readers",
    ];
    const GROUPS: [&str; 6] = ["family", "group", "team", "class", "party", "crew"];
    const MOST: f64 = 40.0;
    (0..tokens.len()).filter(|&i| tokens[i].is("for") || tokens[i].is("seating")).find_map(|i| {
        // "For a family of five", "for a class of twenty".
        let group = (i + 1..tokens.len().min(i + 5)).find(|k| tokens[*k].is("of"));
        let of = group.filter(|k| GROUPS.iter().any(|group| tokens[k - 1].is(group)));
        let i = of.unwrap_or(i);
        let (n, words) = number::count(&tokens[i + 1..])?;
        // "For six" without a noun speaks of people, too.
        let who = tokens.get(i + 1 + words).filter(|_| of.is_none());
        let ends = |who: &Token| matches!(who.kind, Kind::Line | Kind::Sign('.' | ',' | ';' | '!'));
        let speaks_of_people = who.is_none_or(|who| ends(who) || WHO.iter().any(|w| who.is(w)));
        (n > 1.0 && n <= MOST && speaks_of_people).then_some((n as usize, tokens[i].at.start))
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
