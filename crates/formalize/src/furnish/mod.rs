//! A draft is furnished: what rooms of a kind have, what goes with a thing, openings, light, materials and colours.
//!
//! What is added to a thing is fixed to it by equations, so that the search moves it as one piece with the thing; only what
//! stands by itself is placed by the search. Nothing is added that is asked for, ruled out, or could be counted as either.

mod area;
mod asked;
mod build;
mod cell;
mod choose;
mod claim;
mod daylight;
mod drop;
mod edge;
mod even;
mod extent;
mod facing;
mod flood;
mod floor;
mod formation;
mod galley;
mod gates;
mod groups;
mod hang;
mod inventory;
pub(crate) mod kinds;
mod line;
pub(crate) mod number;
mod openings;
mod order;
mod palette;
mod place;
mod plan;
mod room;
mod rows;
mod salon;
mod seats;
mod seek;
mod slots;
mod spots;
mod spread;
mod square;
mod stacks;
pub(crate) mod stand;
pub(crate) mod styles;
mod taste;
mod tell;
mod tops;
mod twin;
mod units;
mod visitors;
mod whom;

use crate::brief::{Brief, Fact, FactKind, Group, Number, Pattern, Place, Rel, Thing};
use crate::complete::defaults::AT_BOOTH;
use crate::draft::{Draft, DraftThing, ThingOrigin};
pub use area::overfull;
pub use daylight::sill;
pub(crate) use gates::GATE;
use number::{Scale, scale};
pub(crate) use palette::paint;
use plan::RULED_OUT;
pub(crate) use taste::style;

/// Why a robot has a fence that nobody asked for.
pub(crate) const FENCED: &str = "a robot works behind a fence";
/// Rooms in which a screen is looked at are so deep at most, unless they would be longer than this (metres).
const ACROSS: f64 = 4.5;
const LONGEST: f64 = 8.4;
/// So many stand in a row at least, where nobody says how many.
const IN_A_ROW: usize = 3;
/// A row of shelves takes this part of the usual width of a room, and is of so many at most.
const ROW: f64 = 0.75;
const LONGEST_ROW: usize = 8;

/// Gives each room of a brief the usual size of its kind, for as many people as are said, and as small or large as is
/// said.
pub fn measure(brief: &mut Brief) {
    shaped(brief);
    seats::people(brief);
    for at in 0..brief.rooms.len() {
        let Some(kind) = kinds::of(&brief.rooms[at].name) else { continue };
        let [w, h, d] = kind.size;
        let area = usual_area(brief, at, kind);
        if let Some(sides) = kind.bay.map(|bay| ward(bay, beds(brief, at).unwrap_or(kind.people as usize))) {
            brief.rooms[at].usual = Some([sides[0], h, sides[1]]);
            continue;
        }
        if let Some([w, d]) = number::narrow(brief, at, area) {
            brief.rooms[at].usual = Some([w, h, d]);
            continue;
        }
        let by = (area / (w * d)).sqrt();
        // Who looks at a screen across the room is not too far from it.
        let watched = kind.lines.iter().any(|line| matches!(line.place, kinds::PlanPlace::Opposite(_)));
        let deep = ACROSS.max(area / LONGEST);
        let is_deep = brief.rooms.len() == 1 && watched && d * by > deep;
        brief.rooms[at].usual = Some(if is_deep { [area / deep, h, deep] } else { [w * by, h, d * by] });
    }
}

/// How large a room is (square metres) of which nobody says it, for as many people as are said, and as small or large as
/// is said.
fn usual_area(brief: &Brief, at: usize, kind: &kinds::FurnishingKind) -> f64 {
    let usual = kind.size[0] * kind.size[2];
    let more = |people: usize| (usual + (people as f64 - kind.people) * kind.each).max(0.5 * usual);
    let scale = match scale(brief, at) {
        Scale::Small => 0.58,
        Scale::Usual => 1.0,
        Scale::Large => 1.4,
    };
    scale * brief.rooms[at].people.map_or(usual, more)
}

/// What a kitchen is called whose worktops have the shape of a letter.
const SHAPES: [(&str, &str); 2] = [("l", "corner kitchen"), ("u", "bay kitchen")];

/// An L- or U-shaped kitchen is a kitchen whose worktops turn a corner.
fn shaped(brief: &mut Brief) {
    for room in brief.rooms.iter_mut().filter(|room| room.name == "kitchen") {
        let said = brief.request.get(room.source.at()).unwrap_or("").to_lowercase();
        let is = |letter: &str| [" ", "-"].iter().any(|mark| said.contains(&format!("{letter}{mark}shaped")));
        if let Some((_, kind)) = SHAPES.iter().find(|(letter, _)| is(letter)) {
            (*kind).clone_into(&mut room.name);
        }
    }
}

/// How many beds are asked for in a room.
fn beds(brief: &Brief, room: usize) -> Option<usize> {
    let own = brief.things.iter().filter(|thing| thing.room == room && thing.group == Group::Bed);
    let asked: usize = own.filter_map(|thing| thing.number.said()).sum();
    Some(asked).filter(|n| *n > 0).or(brief.rooms[room].people)
}

/// Width and depth of a ward with so many beds: side by side at one wall, or at two that are opposite.
fn ward([wide, one, two]: [f64; 3], beds: usize) -> [f64; 2] {
    const IN_LINE: usize = 3;
    // In the wall of the second row is the door.
    const DOOR: f64 = 1.2;
    let (columns, deep, door) = if beds <= IN_LINE { (beds, one, 0.0) } else { (beds.div_ceil(2), two, DOOR) };
    [columns.max(1) as f64 * wide + 0.3 + door, deep].map(|v| (v * 10.0).ceil() / 10.0)
}

/// What a word means in its room: a bed in a ward is a hospital bed, twin beds are beds for one.
pub fn refine(brief: &mut Brief) {
    whom::persons(brief);
    whom::plain_room(brief);
    whom::children(brief);
    whom::pupils(brief);
    whom::student(brief);
    whom::computers(brief);
    whom::instruments(brief);
    bedside_lamps(brief);
    galley::two_rows(brief);
    salon::stations(brief);
    named(brief);
    team(brief);
    stools_at_counter(brief);
    shaped_counter(brief);
    worktop(brief);
    rows::long_shelves(brief);
    for at in 0..brief.things.len() {
        let usual = several(brief, at);
        let n = match rows(brief, at) {
            Some(rows) => Some(usual.unwrap_or(0).div_ceil(rows).max(in_a_row(brief, at)) * rows),
            None => usual,
        };
        if let Some(n) = n {
            brief.things[at].number = Number::Exactly(n);
            // "Tables for twenty-four" are for so many together.
            let booths = in_booths(brief, brief.things[at].room);
            let each = |all: usize| if all > n { all.saturating_sub(booths).div_ceil(n).max(1) } else { all };
            brief.things[at].places = brief.things[at].places.map(each);
        }
    }
    for at in 0..brief.things.len() {
        let thing = &brief.things[at];
        if thing.part.is_some() || thing.opening() || thing.size.iter().any(Option::is_some) {
            continue;
        }
        let plain = thing.words.join(" ");
        let known = |words: &str| scenelang_lang::nouns::noun(words).is_some();
        let said = thing.look.features.iter();
        let said = said.map(|feature| format!("{} {plain}", feature.replace('-', " ")));
        let kind = brief.rooms.get(thing.room).and_then(|room| kinds::of(&room.name));
        let is_on = |fact: &Fact| fact.of.contains(&at) && matches!(fact.what, FactKind::Rel(Rel::On, _));
        let rests = brief.facts.iter().any(is_on);
        let counter = kind.filter(|_| !rests).and_then(|kind| counter_of_till(brief, at, kind));
        let meant = |name: &str| {
            let said = kind?.means.iter().find(|(said, _)| *said == name);
            let noun = said.map(|(_, noun)| noun).or(counter.as_ref().filter(|_| name == plain))?;
            // "A cash register on a counter" is no till that stands on the floor.
            (known(noun) && !(rests && stand::group(noun) != Group::Top)).then(|| (*noun).to_owned())
        };
        // "A double sink" has a name of its own, or one in such a room; a small round table of a cafe is one of its tables.
        let is_small = thing.look.features.iter().any(|feature| feature == "small" || feature == "little")
            || thing.places.is_some_and(|places| places <= 2);
        let is_shape = |name: &str| is_small && name.starts_with("round ") && meant(&plain).is_some();
        let named = |(at, name): (usize, String)| match meant(&name) {
            Some(meant) => Some((at, meant)),
            None => (known(&name) && !is_shape(&name)).then_some((at, name)),
        };
        let said = said.enumerate().filter(|_| thing.words.len() == 1).find_map(named);
        // "Glass counters" in a jewellery shop.
        let made_of = thing.look.material.as_ref().and_then(|material| meant(&format!("{material} {plain}")));
        let thing = match said {
            Some((feature, name)) => {
                brief.things[at].look.features.remove(feature);
                Some(name)
            }
            None => made_of.or_else(|| meant(&plain)),
        }
        .map(|name| (at, name));
        if let Some((at, name)) = thing {
            brief.things[at].words = name.split(' ').map(str::to_owned).collect();
            brief.things[at].last = brief.things[at].words.len();
            if let Some((_, group)) = crate::read::lexicon::get().noun_ending(&brief.things[at].words) {
                brief.things[at].group = group;
            }
        }
    }
}

/// "The till next to the entrance" is the counter of such a room that carries one, unless the request names a counter.
fn counter_of_till(brief: &Brief, at: usize, kind: &kinds::FurnishingKind) -> Option<&'static str> {
    let counters = ["counter", "desk", "checkout", "bar"];
    let is_till = |thing: &Thing| matches!(thing.words.last().map(String::as_str), Some("till" | "register"));
    // Nobody pays at a styling counter or a student desk.
    let pays = |thing: &Thing| {
        let first = thing.words.first().map_or("", String::as_str);
        thing.words.len() == 1
            || matches!(
                first,
                "sales" | "checkout" | "bar" | "service" | "reception" | "front" | "cash" | "shop" | "serving" | "deli"
            )
    };
    let is_counter =
        |thing: &Thing| thing.words.last().is_some_and(|word| counters.contains(&word.as_str())) && pays(thing);
    let room = brief.things[at].room;
    if !is_till(&brief.things[at]) || brief.things.iter().any(|other| other.room == room && is_counter(other)) {
        return None;
    }
    let carries = |noun: &&str| groups::of(noun, kind.dress).iter().any(|part| part.noun == "till");
    kind.lines.iter().map(|line| line.noun).find(carries).or(Some("checkout counter"))
}

/// "A kitchen with an L-shaped counter": the worktops of such a kitchen turn a corner, with its appliances between them.
fn shaped_counter(brief: &mut Brief) {
    let is_told = |brief: &Brief, at: usize| {
        let mut facts = brief.facts.iter();
        facts.any(|fact| fact.of.contains(&at) || fact.what.objects().unwrap_or_default().contains(&at))
    };
    let mut gone = Vec::new();
    for at in 0..brief.things.len() {
        let thing = &brief.things[at];
        let shape = SHAPES.iter().find(|(letter, _)| {
            let shaped = format!("{letter}-shaped");
            thing.look.features.contains(&shaped)
        });
        let is_worktop =
            matches!(&thing.words[..], [word] if matches!(word.as_str(), "counter" | "worktop" | "countertop"));
        let room = brief.rooms.get(thing.room).filter(|room| room.name == "kitchen");
        if let (Some((letter, kind)), true, Some(_)) = (shape, is_worktop, room) {
            let room = thing.room;
            (*kind).clone_into(&mut brief.rooms[room].name);
            if is_told(brief, at) {
                // It is the part of the run of which something is said.
                let shaped = format!("{letter}-shaped");
                brief.things[at].look.features.retain(|feature| *feature != shaped);
            } else {
                gone.push(at);
            }
        }
    }
    if !gone.is_empty() {
        brief.remove(&gone);
    }
}

/// "A bedroom with two lamps": on the nightstands.
fn bedside_lamps(brief: &mut Brief) {
    for at in 0..brief.things.len() {
        let thing = &brief.things[at];
        let kind = brief.rooms.get(thing.room).and_then(|room| kinds::of(&room.name));
        let sleeps = kind.is_some_and(|kind| matches!(kind.name, "bedroom" | "hotel room"));
        let is_told = |fact: &Fact| fact.of.contains(&at) || fact.what.objects().unwrap_or_default().contains(&at);
        if sleeps && thing.words == ["lamp"] && brief.count(at) == 2 && !brief.facts.iter().any(is_told) {
            let thing = &mut brief.things[at];
            thing.words.insert(0, "bedside".into());
            thing.last = 2;
            thing.group = Group::Top;
        }
    }
}

/// An office in which so many have desks is one for a team.
fn team(brief: &mut Brief) {
    const DESKS: usize = 4;
    for at in 0..brief.rooms.len() {
        let own = brief.things.iter().filter(|thing| thing.room == at && thing.part.is_none());
        let is_desk = |name: &str| name.ends_with("desk") || name.ends_with("workstation");
        let desks: usize = own.filter(|thing| is_desk(&thing.name())).filter_map(|thing| thing.number.said()).sum();
        if desks >= DESKS && kinds::of(&brief.rooms[at].name).is_some_and(|kind| kind.name == "office") {
            "open-plan office".clone_into(&mut brief.rooms[at].name);
        }
    }
}

/// "A kitchen with a counter", of which nothing else is said, has its worktop.
fn worktop(brief: &mut Brief) {
    for at in 0..brief.things.len() {
        let thing = &brief.things[at];
        let kind = brief.rooms.get(thing.room).and_then(|room| kinds::of(&room.name));
        let is_told = brief.facts.iter().any(|fact| fact.of.contains(&at));
        let cooks = kind.is_some_and(|kind| kind.name.ends_with("kitchen") && kind.home.is_some());
        if cooks && thing.words == ["counter"] && !is_told {
            let thing = &mut brief.things[at];
            thing.words.insert(0, "kitchen".into());
            thing.last = 2;
        }
    }
}

/// "A coffee shop with a counter and five stools": the counter is a bar, at which they stand.
fn stools_at_counter(brief: &mut Brief) {
    for at in 0..brief.things.len() {
        let room = brief.things[at].room;
        let serves =
            brief.rooms.get(room).and_then(|room| kinds::of(&room.name)).is_some_and(|kind| kind.dress == "food");
        let others = || brief.things.iter().filter(|other| other.room == room);
        let has_stools = others().any(|other| other.name().ends_with("stool") && other.number != Number::Exactly(1));
        let has_bar = others().any(|other| {
            other.name().contains("bar counter") || other.group == Group::Table && other.name().contains("high")
        });
        if serves && has_stools && !has_bar && brief.things[at].words == ["counter"] {
            brief.things[at].words.insert(0, "bar".into());
            brief.things[at].last = 2;
        }
    }
}

/// How many are in a row at least: so many shelves that a row is as long as most of the room.
fn in_a_row(brief: &Brief, at: usize) -> usize {
    let thing = &brief.things[at];
    let kind = brief.rooms.get(thing.room).and_then(|room| kinds::of(&room.name));
    let Some(kind) = kind.filter(|_| thing.group == Group::Storage) else { return IN_A_ROW };
    let noun = thing.name();
    let meant = kind.means.iter().find(|(said, _)| *said == noun).map_or(noun.as_str(), |(_, noun)| noun);
    let width = scenelang_lang::nouns::ending(meant).map_or(kind.size[0], |noun| noun.size[0]);
    ((ROW * kind.size[0] / width).round() as usize).clamp(IN_A_ROW, LONGEST_ROW)
}

/// "Five rows of desks", of which nobody says how many: a few in each row.
pub fn in_rows(brief: &mut Brief) {
    for at in 0..brief.things.len() {
        if let Some(rows) = rows(brief, at) {
            brief.things[at].number = Number::Exactly(rows * IN_A_ROW);
        }
    }
}

/// In how many rows things stand of which nobody says how many there are: "six rows of racks".
fn rows(brief: &Brief, at: usize) -> Option<usize> {
    let of = |fact: &Fact| match fact.what {
        FactKind::Pattern(Pattern::Rows(rows)) if fact.of == [at] => rows,
        _ => None,
    };
    let plural = |_: &usize| brief.things[at].number == Number::Plural;
    brief.facts.iter().find_map(of).or_else(|| shelves_in_rows(brief, at)).filter(plural)
}

/// In how many rows shelves stand of which it is said only that they stand in rows.
fn shelves_in_rows(brief: &Brief, at: usize) -> Option<usize> {
    const ROWS: usize = 4;
    let thing = &brief.things[at];
    let said = brief.request.get(..thing.source.at().start)?.trim_end().to_lowercase();
    (thing.group == Group::Storage && said.ends_with("rows of")).then_some(ROWS)
}

/// So many can be in rows of two, three or six.
const FULL_ROWS: usize = 6;

/// "Many" are so many at least.
const MANY: usize = 5;

/// So many people sit at tables for groups, where nobody says how many.
const MOST_AT_GROUPS: usize = 24;

/// How many "racks" are, where such rooms have whole rows of them.
fn several(brief: &Brief, at: usize) -> Option<usize> {
    // So many sit at a table for a group.
    const GROUP: usize = 4;
    let thing = &brief.things[at];
    let kind = kinds::of(&brief.rooms.get(thing.room)?.name)?;
    let many = is_many(brief, at);
    let plural = (thing.number == Number::Plural || many) && thing.part.is_none();
    let is_group = plural && matches!(thing.name().as_str(), "group table" | "shared table");
    let usual = (kind.people as usize).min(MOST_AT_GROUPS);
    if let Some(people) = brief.rooms.get(thing.room)?.people.or(Some(usual)).filter(|_| is_group) {
        return Some(people.div_ceil(GROUP).max(2));
    }
    // Two sleep in a bunk bed, and those of two children are one.
    if let Some(people) = brief.rooms.get(thing.room)?.people.filter(|_| plural && thing.name() == "bunk bed") {
        return Some(people.div_ceil(2));
    }
    // "A long table with benches": one at each of its long sides.
    let is_table = |other: &usize| {
        let other = &brief.things[*other];
        other.room == thing.room && other.group == Group::Table && other.name().ends_with("table")
    };
    if plural
        && thing.name() == "bench"
        && let Some(table) = (0..brief.things.len()).find(is_table)
    {
        return Some(2 * brief.count(table));
    }
    if let Some(n) = along_walls(brief, at, kind).filter(|_| plural && !many) {
        return Some(n);
    }
    // "Sofas and low tables": one before each.
    let is_sofa = |other: &Thing| {
        other.room == thing.room && other.group == Group::Seat && stand::counts_as("sofa", &other.name())
    };
    let is_low = thing.name() == "coffee table"
        || thing.name() == "table" && thing.look.features.iter().any(|feature| feature == "low");
    if plural
        && is_low
        && let Some(sofas) = brief.things.iter().position(is_sofa)
    {
        return Some(brief.count(sofas));
    }
    // "Monitors" of four beds are four.
    if let Some(each) = at_anchors(brief, at, kind).filter(|_| plural) {
        return Some(each);
    }
    // "Cushions" in a tea house: as many as there are places at its tables.
    if let Some(places) = at_tables(brief, at, kind).filter(|_| plural) {
        return Some(places);
    }
    // "Double desks" are other ones than desks.
    let looks = || thing.look.features.iter().map(|look| format!("{look} {}", thing.name()));
    let named = looks().find(|name| kind.means.iter().any(|(said, _)| said == name));
    let name = meant(kind, named.unwrap_or_else(|| thing.name()));
    let like = |line: &&kinds::Line| stand::counts_as(line.noun, &name);
    // "Desks" in a classroom are those of the pupils.
    let for_people = |line: &&kinds::Line| plural && like(line) && matches!(line.count, kinds::Count::People(_));
    let named = kind.lines.iter().find(|line| for_people(line) && line.noun == name);
    let own = named.or_else(|| kind.lines.iter().find(for_people)).or_else(|| kind.lines.iter().find(like));
    let least = (many && thing.part.is_none()).then_some(MANY);
    // "High tables" in a bar: as many as its people need, whatever they are called.
    let eats = |line: &&kinds::Line| {
        matches!(line.count, kinds::Count::People(_))
            && stand::group(line.noun) == Group::Table
            && line.noun.ends_with("table")
    };
    let own = own.or_else(|| {
        let is_table = plural && thing.group == Group::Table && thing.name().ends_with("table");
        kind.lines.iter().find(eats).filter(|_| is_table && thing.name() != "coffee table")
    });
    let usual = own.and_then(|line| usual_number(brief, at, kind, line, plural));
    usual.map(|n| n.max(least.unwrap_or(0))).or(least)
}

/// How many shelves cover a wall, or stand along the walls, of a room of the usual size.
fn along_walls(brief: &Brief, at: usize, kind: &kinds::FurnishingKind) -> Option<usize> {
    const COVER: [&str; 9] =
        ["along", "lining", "lines", "lined", "covering", "covers", "covered", "filling", "all sides"];
    /// The part of a wall that shelves take, and those of all walls.
    const PART: f64 = 0.7;
    const PARTS: f64 = 1.2;
    const MOST: f64 = 8.0;
    let thing = &brief.things[at];
    let says = |fact: &&Fact| fact.of == [at] && matches!(fact.what, FactKind::Place(_, Place::Wall, _));
    let fact = brief.facts.iter().find(says).filter(|_| thing.group == Group::Storage)?;
    let FactKind::Place(_, _, which) = &fact.what else { return None };
    let said = brief.request.get(fact.source.at()).unwrap_or("").to_lowercase();
    if !COVER.iter().any(|cover| said.contains(cover)) {
        return None;
    }
    let room = &brief.rooms[thing.room];
    let side = |k: usize| room.size[k].or(room.usual.map(|usual| usual[k])).unwrap_or(kind.size[k]);
    let is = |names: [&str; 4]| which.iter().any(|which| names.contains(&which.as_str()));
    let wall = match () {
        () if is(["left", "right", "east", "west"]) => side(2),
        () if is(["back", "front", "north", "south"]) => side(0),
        () => side(0).max(side(2)),
    };
    let width =
        thing.size[0].or_else(|| scenelang_lang::nouns::ending(&meant(kind, thing.name())).map(|noun| noun.size[0]))?;
    let part = if said.contains("walls") || said.contains("all sides") { PARTS } else { PART };
    Some((part * wall / width).floor().clamp(2.0, MOST) as usize)
}

/// How many of a thing there are, if each of several other requested things has exactly one of it in such a room.
fn at_anchors(brief: &Brief, at: usize, kind: &kinds::FurnishingKind) -> Option<usize> {
    let meant = |name: String| meant(kind, name);
    let noun = meant(brief.things[at].name());
    let others = (0..brief.things.len()).filter(|i| *i != at && brief.things[*i].room == brief.things[at].room);
    let has_one = |other: usize| {
        let parts = groups::of(&meant(brief.things[other].name()), kind.dress);
        let mut like = parts.iter().filter(|part| part.noun == noun && stand::group(part.noun) != Group::Seat);
        matches!((like.next(), like.next()), (Some(_), None))
    };
    others.filter(|other| brief.count(*other) > 1 && has_one(*other)).map(|other| brief.count(other)).next()
}

/// What a name means in such a room.
fn meant(kind: &kinds::FurnishingKind, name: String) -> String {
    kind.means.iter().find(|(said, _)| *said == name).map_or(name, |(_, noun)| (*noun).to_owned())
}

/// "Chairs" at one desk are so many at least.
const SEVERAL: usize = 2;

/// How many seats stand around the tables of such a room that are asked for, or else that such a room has: "ten tables and
/// chairs".
fn at_tables(brief: &Brief, at: usize, kind: &kinds::FurnishingKind) -> Option<usize> {
    let thing = &brief.things[at];
    let meant = |name: String| meant(kind, name);
    let elsewhere = |fact: &Fact| {
        let at_table = matches!(fact.what, FactKind::Rel(Rel::Around | Rel::At, _));
        fact.of.contains(&at) && !at_table
    };
    if brief.facts.iter().any(elsewhere) {
        return None;
    }
    let seat = meant(thing.name());
    let each = |table: &str| {
        groups::of(table, kind.dress).iter().find_map(|part| match part.at {
            groups::Where::Around(n, _)
            | groups::Where::LongSides(n, _)
            | groups::Where::Outside(n, _)
            | groups::Where::Row(n, _)
                if n > 0 && stand::counts_as(part.noun, &seat) =>
            {
                Some(n)
            }
            groups::Where::Front(..) | groups::Where::Back(..) if stand::counts_as(part.noun, &seat) => Some(1),
            _ => None,
        })
    };
    // All sit at the one table of such a room.
    let all = |table: &str| {
        let at_one = |line: &&kinds::Line| {
            line.count == kinds::Count::Fixed(1)
                && matches!(line.place, kinds::PlanPlace::Middle | kinds::PlanPlace::Floor)
        };
        let mut lines = kind.lines.iter().filter(at_one);
        lines
            .any(|line| each(line.noun).is_some() && stand::counts_as(line.noun, table))
            .then_some(kind.people as usize)
    };
    let mut others = (0..brief.things.len()).filter(|i| *i != at && brief.things[*i].room == thing.room);
    let asked = others.find_map(|table| {
        let (other, n) = (&brief.things[table], brief.count(table));
        // "High tables" are a kind of their own.
        let looks = other.look.features.iter().map(|feature| format!("{feature} {}", other.name()));
        let noun = looks.chain([meant(other.name())]).find(|noun| each(noun).is_some() || all(noun).is_some())?;
        if n > 1 { Some(each(&noun)? * n) } else { all(&noun).or_else(|| Some(each(&noun)?.max(SEVERAL))) }
    });
    let people = brief.rooms.get(thing.room)?.people.map_or(kind.people, |people| people as f64);
    let usual = || {
        let mut lines = kind.lines.iter().filter_map(|line| match line.count {
            kinds::Count::People(per) => Some((people / per).ceil() as usize * each(line.noun)?),
            _ => None,
        });
        lines.next().filter(|_| seat != thing.name())
    };
    asked.or_else(usual)
}

/// Whether "many" of a thing are asked for.
fn is_many(brief: &Brief, at: usize) -> bool {
    let said = brief.request.get(brief.things[at].source.at()).unwrap_or("").to_lowercase();
    let first = said.split_whitespace().next().unwrap_or("");
    brief.things[at].number == Number::Several && matches!(first, "many" | "numerous" | "countless")
}

/// How many people sit in the booths of a room that are asked for.
fn in_booths(brief: &Brief, room: usize) -> usize {
    let here = |at: &usize| brief.things[*at].room == room && brief.things[*at].name() == asked::BOOTH;
    (0..brief.things.len()).filter(here).map(|at| brief.count(at) * AT_BOOTH).sum()
}

/// How many of a thing a room has by the line of its kind that has such things.
fn usual_number(
    brief: &Brief,
    at: usize,
    kind: &kinds::FurnishingKind,
    line: &kinds::Line,
    plural: bool,
) -> Option<usize> {
    let thing = &brief.things[at];
    let rows = matches!(line.place, kinds::PlanPlace::Rows(_)) && plural;
    match line.count {
        // "A pharmacy with shelves": as many as such shops have.
        kinds::Count::Fixed(n) if n > 2 && plural => Some(n),
        // "Reading tables for twelve". Nobody says how many people: as many as sleep there, or as usual.
        kinds::Count::People(each) if plural && matches!(thing.group, Group::Table | Group::Storage) => {
            let people = brief.rooms.get(thing.room)?.people;
            let people = people.or_else(|| sleepers(brief, thing.room, kind)).or_else(|| sitters(brief, thing.room));
            // Those who sit in booths do not sit at tables.
            let booths = in_booths(brief, thing.room);
            let people = people.map_or(kind.people, |people| people.saturating_sub(booths) as f64);
            // Each has as many of the chairs that are asked for, too.
            let is_seat = |other: &Thing| other.room == thing.room && other.group == Group::Seat && other.number.many();
            let even = || claim::spread(line, people as usize);
            if thing.group == Group::Table
                && brief.things.iter().any(is_seat)
                && let Some(n) = even().filter(|n| *n > 1)
            {
                return Some(n);
            }
            Some((people / each).ceil().max(2.0) as usize)
        }
        kinds::Count::Area(each)
            if rows
                || plural
                    && matches!(
                        line.place,
                        kinds::PlanPlace::Run | kinds::PlanPlace::Wall | kinds::PlanPlace::Hung
                    ) =>
        {
            brief.rooms.get(thing.room)?;
            let n = (usual_area(brief, thing.room, kind) / each).round().max(2.0) as usize;
            // Shelves in rows that are full, however many a row has.
            let in_rows = rows && thing.group == Group::Storage;
            Some(if in_rows { n.next_multiple_of(FULL_ROWS) } else { n })
        }
        // "A church with pews": as many as its people need.
        kinds::Count::People(each) if rows => {
            let people = brief.rooms.get(thing.room)?.people.map_or(kind.people, |people| people as f64);
            Some((people / each).ceil().max(2.0) as usize)
        }
        _ => None,
    }
}

/// How many sit on the seats of a room, where one kind of seats is asked for.
fn sitters(brief: &Brief, room: usize) -> Option<usize> {
    const CLASS: usize = 6;
    let mut seats = brief.things.iter().filter(|thing| thing.room == room && thing.group == Group::Seat);
    let (Some(seat), None) = (seats.next(), seats.next()) else { return None };
    seat.number.said().filter(|n| *n >= CLASS)
}

/// How many sleep in the beds of a room that are asked for.
fn sleepers(brief: &Brief, room: usize, kind: &kinds::FurnishingKind) -> Option<usize> {
    let at = (0..brief.things.len()).find(|at| {
        let thing = &brief.things[*at];
        thing.room == room && thing.group == Group::Bed && thing.number.said().is_some()
    })?;
    let each = kind.lines.iter().find_map(|line| match line.count {
        kinds::Count::People(each) if stand::group(line.noun) == Group::Bed => Some(each),
        _ => None,
    })?;
    Some((brief.count(at) as f64 * each) as usize)
}

/// A request that names no room but what a kind of room is called by: "a cosy bar", "a bar with booths".
fn named(brief: &mut Brief) {
    let [room] = &mut brief.rooms[..] else { return };
    if room.name != "room" {
        return;
    }
    let Some(first) = brief.things.first().filter(|thing| thing.part.is_none() && !thing.number.many()) else {
        return;
    };
    // "A bar with booths" begins with the room.
    let after = brief.request.get(first.source.at().end..).unwrap_or("");
    let has = brief.things.len() == 1 || after.trim_start().starts_with("with ");
    if has && kinds::of(&first.name()).is_some_and(|kind| kind.name != "room") {
        room.name = first.name();
        // It is the room, and not a thing in it, where nothing is said of it but what it has.
        let begin = first.source.at().start;
        let listed = |fact: &Fact| {
            let own = fact.of.iter().any(|of| brief.things[*of].source.at() == fact.source.at());
            own || fact.source.at().start == begin
        };
        brief.facts.retain(|fact| !listed(fact) || fact.of.contains(&0));
        let objects = |fact: &Fact| fact.what.objects().unwrap_or_default().contains(&0);
        if !brief.facts.iter().any(|fact| fact.of.contains(&0) || objects(fact)) {
            room.source = first.source.clone();
            brief.remove(&[0]);
        }
    }
}

/// Adds to each room of a draft what such rooms have, in the colours that are asked for.
pub fn furnish(draft: &mut Draft, brief: &Brief) {
    fill(draft, brief);
    square::to_the_walls(draft);
    paint(draft, brief);
    palette::spare(draft, brief);
}

fn fill(draft: &mut Draft, brief: &Brief) {
    units::any_of_run(draft);
    visitors::opposite(draft);
    let is_named = |thing: &&DraftThing| !is_among_more(draft, brief, thing);
    let mut closed: Vec<String> =
        draft.things.iter().filter(is_named).map(|thing| thing.category.replace('_', " ")).collect();
    closed.extend(brief.absent.iter().map(|(name, _)| format!("{RULED_OUT}{name}")));
    if draft.rooms.len() == 1 {
        closed.extend(places_elsewhere(draft, brief, 0));
        return extent::furnish(draft, brief, 0, &closed);
    }
    for at in 0..draft.rooms.len() {
        // What is asked for in one room is not there for the others.
        let own = draft.things.iter().filter(|thing| thing.room == Some(at));
        let own = own.filter(|thing| !is_among_more(draft, brief, thing));
        let mut closed: Vec<String> = own.map(|thing| thing.category.replace('_', " ")).collect();
        closed.extend(brief.absent.iter().map(|(name, _)| format!("{RULED_OUT}{name}")));
        closed.extend(places_elsewhere(draft, brief, at));
        // Clothes hang in the room for clothes.
        if has_closet(draft, at) {
            closed.push("wardrobe".to_owned());
        }
        extent::furnish(draft, brief, at, &closed);
    }
}

/// How many seats, and of what kind, stand around a table of this name in a room of this name.
pub fn seats_at(room: &str, table: &str) -> Option<(usize, &'static str)> {
    let dress = kinds::of(room).map_or("", |kind| kind.dress);
    groups::of(table, dress).iter().find_map(|part| match part.at {
        groups::Where::Around(n, _) | groups::Where::LongSides(n, _) | groups::Where::Outside(n, _) => {
            Some((n, part.noun))
        }
        _ => None,
    })
}

/// The tables and desks for each that such a room has, where most of its people sit at a table that is asked for: "a
/// classroom with a table for fifteen".
fn places_elsewhere(draft: &Draft, brief: &Brief, at: usize) -> Vec<String> {
    let Some(kind) = kinds::of(&draft.rooms[at].kind) else { return Vec::new() };
    let people = brief.rooms.get(at).and_then(|room| room.people).map_or(kind.people, |people| people as f64);
    let here = brief.things.iter().filter(|thing| thing.room == at && thing.head().ends_with("table"));
    let most = here.filter_map(|thing| thing.places).max().unwrap_or(0) as f64;
    let for_each = kind
        .lines
        .iter()
        .filter(|line| matches!(line.count, kinds::Count::People(_)) && stand::group(line.noun) == Group::Table);
    for_each.filter(|_| 2.0 * most >= people).map(|line| line.noun.to_owned()).collect()
}

/// Whether what matters most in a room of this kind has a planned place, where it is there and such rooms have it at a wall: of a
/// bedroom its bed. A bathroom has a shower or a bathtub.
pub fn has_place_for_first(draft: &Draft, at: usize) -> bool {
    let Some(kind) = kinds::of(&draft.rooms[at].kind) else { return true };
    let Some(first) = kind.lines.first() else { return true };
    if kind.name == "bathroom" {
        let washes = |noun: &str| ["shower", "tub"].iter().any(|end| noun.ends_with(end));
        return draft.things.iter().any(|thing| thing.room == Some(at) && washes(&thing.category));
    }
    let is_first =
        |thing: &&DraftThing| thing.room == Some(at) && stand::counts_as(first.noun, &thing.category.replace('_', " "));
    first.place != kinds::PlanPlace::Wall
        || draft.things.iter().filter(is_first).all(|thing| {
            let name = if thing.count > 1 { format!("{}[0]", thing.name) } else { thing.name.clone() };
            draft.place_of(&name).is_some() || stand::placed(draft, &thing.name)
        })
}

/// Whether "shelves" are asked for, with nothing else said of them, in a room that has several rows of those: others are added to
/// them.
fn is_among_more(draft: &Draft, brief: &Brief, thing: &DraftThing) -> bool {
    let (ThingOrigin::Stated(_), Some(room)) = (&thing.source, thing.room) else { return false };
    let said = brief.request.get(thing.source.at()).unwrap_or("");
    let Some(kind) = kinds::of(&draft.rooms[room].kind) else { return false };
    let noun = thing.category.replace('_', " ");
    let like = kind.lines.iter().filter(|line| stand::counts_as(line.noun, &noun));
    stand::group(&noun) == Group::Storage && thing.count > 1 && !said.contains(' ') && like.count() > 1
}

/// Whether a room is the only bedroom of a home that has a room for clothes.
fn has_closet(draft: &Draft, at: usize) -> bool {
    let is = |room: &crate::draft::DraftRoom, name: &str| kinds::of(&room.kind).is_some_and(|kind| kind.name == name);
    let bedrooms = draft.rooms.iter().filter(|room| is(room, "bedroom")).count();
    bedrooms == 1 && is(&draft.rooms[at], "bedroom") && draft.rooms.iter().any(|room| is(room, "walk-in closet"))
}
