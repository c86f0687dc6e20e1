//! How large a room is said to be in words: "a small bedroom", "a spacious office".

use crate::brief::Brief;

/// How large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Smaller than usual.
    Small,
    /// Nothing is said.
    Usual,
    /// Larger than usual.
    Large,
}

const SMALL: [&str; 7] = ["small", "tiny", "little", "compact", "narrow", "mini", "cramped"];
/// A cosy room is a small one, but for a child, whose toys need their floor.
const COSY: [&str; 3] = ["cosy", "cozy", "snug"];
const LARGE: [&str; 9] = ["large", "big", "spacious", "huge", "grand", "roomy", "generous", "vast", "airy"];
/// How far before its name a room's adjectives are, in bytes.
const BEFORE: usize = 40;

/// How many times as long as wide a room is that is said to be narrow.
const NARROW: f64 = 2.2;
/// The same of a hall.
const LONG: f64 = 3.2;

/// The sides of a room of so many square metres, if it is said to be narrow.
pub fn narrow(brief: &Brief, room: usize, area: f64) -> Option<[f64; 2]> {
    let room = &brief.rooms[room];
    // In a hall one only walks.
    let is_hall = ["hallway", "hall", "corridor"].iter().any(|hall| room.name.ends_with(hall));
    let (least, narrow) = if is_hall { (1.5, LONG) } else { (2.2, NARROW) };
    let at = room.source.at();
    let named = brief.request.get(..at.end)?.rsplit(['.', ',', ';', ':', '!', '\n']).next()?.to_lowercase();
    let is_said = named.split(|c: char| !c.is_alphabetic()).any(|word| word == "narrow");
    let across = (area / narrow).sqrt().max(least);
    (is_said && room.size == [None; 3]).then_some([area / across, across])
}

/// How large a room is said to be: by a word of its phrase, or before it in the same clause.
pub fn scale(brief: &Brief, room: usize) -> Scale {
    let at = brief.rooms[room].source.at();
    let text = brief.request.get(..at.end).unwrap_or("");
    let mut from = at.start.saturating_sub(BEFORE).min(text.len());
    while !text.is_char_boundary(from) {
        from += 1;
    }
    let phrase = text[from..].rsplit(['.', ',', ';', ':', '!', '\n']).next().unwrap_or("").to_lowercase();
    let is_kids = super::kinds::of(&brief.rooms[room].name).is_some_and(|kind| kind.dress == "kids");
    // What stands before an article belongs to something else.
    let mut words = phrase.split(|c: char| !c.is_alphabetic()).rev().take_while(|w| !matches!(*w, "a" | "an" | "with"));
    words
        .find_map(|w| match w {
            w if SMALL.contains(&w) || COSY.contains(&w) && !is_kids => Some(Scale::Small),
            w if LARGE.contains(&w) => Some(Scale::Large),
            _ => None,
        })
        .unwrap_or(Scale::Usual)
}
