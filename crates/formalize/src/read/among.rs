//! Rooms that are named are among those that are counted: of "a two-bedroom flat" the main bedroom and the kids' room are the two
//! bedrooms, and of "a clinic with three rooms" the waiting room, the exam room and the office are the three rooms.

use super::chunk::{Chunk, ChunkPiece};
use super::lexicon::get;
use super::noun::Det;
use super::rooms::Rooms;
use super::several::{Several, is_home, sleeps};
use super::token::Token;

/// What a building is called that has rooms.
const BUILDING: &str = "building";
/// What says that a room is one more than those that were counted.
const MORE: [&str; 6] = ["another", "additional", "extra", "also", "further", "plus"];
/// The bedroom of those who live there, of which there is one.
const MAIN: [&str; 3] = ["main", "master", "primary"];

/// Leaves of counted rooms only those that are not named.
pub fn settle(out: &mut Rooms, chunks: &[Chunk], tokens: &[Token], hyphened: Option<usize>) {
    while let Some(counted) = (0..out.rooms.len()).find(|at| is_nameless(out, *at)) {
        if !rest(out, counted) {
            break;
        }
    }
    let several: Vec<usize> = (0..out.rooms.len()).filter(|at| out.several[*at].count > 1).collect();
    for model in several {
        of_a_kind(out, model, chunks, tokens, hyphened);
    }
}

/// Whether these are so many rooms of which nothing else is said: "three rooms".
fn is_nameless(out: &Rooms, at: usize) -> bool {
    out.rooms[at].name == "room" && out.several[at].count > 1 && out.several[at].like.is_none()
}

/// Makes counted rooms those that are left when the others have names; whether all have.
fn rest(out: &mut Rooms, counted: usize) -> bool {
    let is_other = |at: &usize| {
        let several = &out.several[*at];
        let is_outside = crate::storey::is_outside(&out.rooms[*at].name);
        *at != counted && Some(*at) != out.whole && several.own.is_none() && several.like.is_none() && !is_outside
    };
    let named: usize = (0..out.rooms.len()).filter(is_other).map(|at| out.several[at].count).sum();
    if named == 0 {
        return false;
    }
    // What they are rooms of is a building, even if a room may be called so.
    if let Some(whole) = out.whole
        && !is_home(&out.rooms[whole].name)
        && get().room(&out.rooms[whole].name).is_none_or(|kind| kind.name != "apartment")
    {
        out.rooms[whole].name = BUILDING.to_owned();
    }
    if named < out.several[counted].count {
        out.several[counted].count -= named;
        return false;
    }
    remove(out, counted);
    true
}

/// Removes a room. What was said of it is said of the whole.
fn remove(out: &mut Rooms, room: usize) {
    let whole = out.whole;
    let moved = |at: usize| at - usize::from(at > room);
    out.spoken.retain(|_, at| *at != room || whole.is_some());
    for at in out.spoken.values_mut() {
        *at = if *at == room { moved(whole.unwrap_or(0)) } else { moved(*at) };
    }
    out.rooms.remove(room);
    out.several.remove(room);
    for several in &mut out.several {
        several.own = several.own.filter(|own| *own != room).map(moved);
        several.like = several.like.map(moved);
    }
    out.whole = whole.map(moved);
}

/// Finds the rooms that are among several of their kind.
fn of_a_kind(out: &mut Rooms, model: usize, chunks: &[Chunk], tokens: &[Token], hyphened: Option<usize>) {
    let several = &out.several[model];
    let kind = |name: &str| get().room(name).map(|kind| kind.name);
    let Some(of) = kind(&out.rooms[model].name).filter(|_| several.own.is_none() && several.like.is_none()) else {
        return;
    };
    if of == "room" || out.rooms[model].name != of {
        return;
    }
    let first_spoken = |room: usize| out.spoken.iter().find(|(_, at)| **at == room).map(|(chunk, _)| *chunk);
    // "A two-bedroom flat" has no more than two.
    let by_hyphen = hyphened.filter(|at| out.rooms[model].source.at() == bytes(chunks, tokens, *at));
    let Some(counted) = by_hyphen.or_else(|| first_spoken(model)) else { return };
    // "Two bathrooms. The master bedroom has its own bathroom": one of the two.
    for at in 0..out.rooms.len() {
        let one = out.several[at].own.is_some_and(|owner| out.several[owner].count == 1) && out.several[at].count == 1;
        let told = first_spoken(at).is_some_and(|chunk| is_told(chunks, counted, chunk));
        if one && told && out.rooms[at].name == of && out.several[model].count > 1 {
            out.several[model].count -= 1;
        }
    }
    let mut named = out.several.iter().filter(|several| several.like == Some(model)).count();
    for at in 0..out.rooms.len() {
        let (room, own) = (&out.rooms[at], &out.several[at]);
        let alone = at != model && own.count == 1 && own.own.is_none() && own.like.is_none() && out.whole != Some(at);
        let words: Vec<String> = room.name.split(' ').map(str::to_owned).collect();
        let same = get().room_ending(&words).is_some_and(|(_, kind)| kind.name == of);
        // Of what is called otherwise, only bedrooms are alike: "the kids room".
        let called = room.name.ends_with(&format!(" {of}"));
        let (same, called) = if of == "bedroom" { (sleeps(&room.name), room.name != of) } else { (same, called) };
        let Some(chunk) = first_spoken(at).filter(|_| alone && same && called) else { continue };
        let is_main = words.first().is_some_and(|word| MAIN.contains(&word.as_str()));
        let among = is_main
            || !is_more(chunks, tokens, chunk) && {
                by_hyphen.is_some() || is_known(chunks, tokens, chunk) || is_told(chunks, counted, chunk)
            };
        if among && named < out.several[model].count {
            out.several[at].like = Some(model);
            named += 1;
        }
    }
    if named > 0 && named + 1 == out.several[model].count {
        last_one(out, model, chunks);
    }
}

/// "A guest room and their bedroom, which has twin beds", of two: what is said of one bedroom is said of the one without a name.
fn last_one(out: &mut Rooms, model: usize, chunks: &[Chunk]) {
    let is_one = |chunk: usize| {
        chunks[chunk].np().is_some_and(|np| {
            let one = !np.many && np.count.is_none() && np.nth.is_none();
            one && matches!(np.det, Det::Definite | Det::Own) && np.name() == out.rooms[model].name
        })
    };
    let said: Vec<usize> =
        out.spoken.iter().filter(|(chunk, at)| **at == model && is_one(**chunk)).map(|(chunk, _)| *chunk).collect();
    if said.is_empty() || out.rooms.len() >= super::rooms::MOST {
        return;
    }
    let room = out.rooms[model].clone();
    out.rooms.push(room);
    out.several.push(Several { like: Some(model), ..Several::default() });
    let last = out.rooms.len() - 1;
    out.spoken.extend(said.into_iter().map(|chunk| (chunk, last)));
}

fn bytes(chunks: &[Chunk], tokens: &[Token], chunk: usize) -> std::ops::Range<usize> {
    let at = &chunks[chunk].at;
    tokens[at.start].at.start..tokens[at.end - 1].at.end
}

/// "The guest room", also where the reader has written "a" in the place of "the".
pub(super) fn is_known(chunks: &[Chunk], tokens: &[Token], chunk: usize) -> bool {
    let first = &tokens[chunks[chunk].at.start];
    let was_definite = first.is("a") && first.at.len() == "the".len();
    was_definite || chunks[chunk].np().is_some_and(|np| matches!(np.det, Det::Definite | Det::Own))
}

/// "There is also a guest room", "an extra bedroom": one more.
fn is_more(chunks: &[Chunk], tokens: &[Token], chunk: usize) -> bool {
    const BEFORE: usize = 3;
    let at = &chunks[chunk].at;
    let said = tokens[at.start.saturating_sub(BEFORE)..at.end].iter().rev().take_while(|t| !t.stops());
    said.into_iter().any(|t| MORE.iter().any(|more| t.is(more)))
}

/// "Two bedrooms: a master bedroom and a nursery", "two bedrooms. There is a nursery …": told of after they were counted.
fn is_told(chunks: &[Chunk], counted: usize, chunk: usize) -> bool {
    let ends = |c: &Chunk| matches!(c.piece, ChunkPiece::Stop | ChunkPiece::Line);
    let between = chunks.get(counted + 1..chunk).unwrap_or_default();
    chunks.get(counted + 1).is_some_and(|c| c.piece == ChunkPiece::Colon) || between.iter().any(ends)
}

#[cfg(test)]
mod tests {
    #[test]
    fn named_rooms_are_among_counted_ones() {
        for (text, rooms) in [
            (
                "A two bedroom flat: a living room, one bathroom, the main bedroom has a double bed and the kids room has bunk beds.",
                "flat, living room, bathroom, main bedroom, kid room",
            ),
            (
                "A three-bedroom house. The master bedroom has a king bed, the guest room has a single bed.",
                "house, bedroom, master bedroom, guest room",
            ),
            (
                "A flat with two bedrooms. There is a nursery with a crib. There is also a guest room with a bed.",
                "flat, bedroom, guest room, nursery",
            ),
            (
                "Reception area and a meeting room. Reception has a desk and two chairs. Meeting room is 4x5 with a table.",
                "reception area, meeting room",
            ),
            (
                "A kitchen area and a waiting area. The kitchen has a stove, the waiting room has a sofa.",
                "kitchen area, waiting area",
            ),
            (
                "A vet clinic with three rooms. There's a waiting room with chairs, an exam room with a table and a storage room.",
                "building, veterinary exam room, storage room, waiting room",
            ),
            (
                "A house with four rooms. The kitchen has a table. The bedroom has a bed.",
                "house, kitchen, bedroom, room, room",
            ),
        ] {
            let names: Vec<String> = crate::read::brief(text).rooms.into_iter().map(|room| room.name).collect();
            let mut names: Vec<&str> = names.iter().map(String::as_str).collect();
            let mut expected: Vec<&str> = rooms.split(", ").collect();
            names.sort_unstable();
            expected.sort_unstable();
            assert_eq!(names, expected, "{text}");
        }
    }
}
