//! The program of a plan: the ground truth of a scene. Each relation that the request states is an assertion of its own, with
//! the sentence that states it; the rest (which room a thing is in, doors, heights of what hangs) is stated without one.

use super::plan::{Extra, ExtraKind, Link, Plan, PlannedThing};
use super::pools::ThingPlace;
use std::fmt::Write;

/// Between two walls of rooms that stand side by side: each is 3 cm thick.
const WALLS: f64 = 0.06;
/// Under what hangs on a wall, where the room is high enough for it.
const HUNG: f64 = 0.9;

/// One relation, with the assertions that it becomes.
#[derive(Debug)]
pub(crate) struct Stated {
    /// The rule of the grammar that words it.
    pub rule: &'static str,
    /// The thing that it is said of.
    pub thing: usize,
    /// The other thing; `None`: it is said of the room, or of the thing alone.
    pub other: Option<usize>,
    /// How far, where it says so.
    pub distance: f64,
    /// The formulas, one for each instance.
    pub formulas: Vec<String>,
}

/// What things and rooms are called in the program.
#[derive(Debug)]
pub(crate) struct ProgramNames {
    pub rooms: Vec<String>,
    pub things: Vec<String>,
    pub links: Vec<String>,
}

impl ProgramNames {
    pub fn new(plan: &Plan) -> Self {
        let rooms: Vec<String> = plan.rooms.iter().map(|room| identifier(room.kind)).collect();
        let twice = |noun: &str| plan.things.iter().filter(|thing| thing.noun == noun).count() > 1;
        let thing = |thing: &PlannedThing| {
            let own = identifier(thing.noun);
            let is_taken = twice(thing.noun) || rooms.contains(&own);
            if is_taken { format!("{own}Of{}", capital(&rooms[thing.room])) } else { own }
        };
        let things = plan.things.iter().map(thing).collect();
        let mut links = Vec::new();
        for link in &plan.links {
            let taken = links.iter().filter(|name: &&String| name.starts_with(link.noun)).count();
            links.push(if taken == 0 { link.noun.to_owned() } else { format!("{}{}", link.noun, taken + 1) });
        }
        Self { rooms, things, links }
    }

    /// One of a kind of things.
    fn one(&self, plan: &Plan, thing: usize, nth: u32) -> String {
        let name = &self.things[thing];
        if plan.things[thing].count == 1 { name.clone() } else { format!("{name}[{nth}]") }
    }
}

/// "children's room" → `childrensRoom`.
fn identifier(words: &str) -> String {
    let clean: String = words.chars().filter(|c| *c != '\'').collect();
    let mut out = String::new();
    for word in clean.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty()) {
        if out.is_empty() { out.push_str(word) } else { out.push_str(&capital(word)) }
    }
    out
}

fn capital(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

/// What the request states of places, in the order in which it does.
pub(crate) fn stated(plan: &Plan, names: &ProgramNames) -> Vec<Stated> {
    let mut out = Vec::new();
    for room in 0..plan.rooms.len() {
        let things = plan.things.iter().enumerate().filter(|(_, thing)| thing.room == room);
        for (i, thing) in things {
            let formulas = of_place(plan, names, i, thing);
            out.push(Stated { rule: thing.place.rule(), thing: i, other: thing.other, distance: 0.0, formulas });
        }
        for extra in plan.extras.iter().filter(|extra| plan.things[extra.thing].room == room) {
            let formulas = of_extra(plan, names, extra);
            let (rule, thing, other) = (extra.kind.rule(), extra.thing, extra.other);
            out.push(Stated { rule, thing, other, distance: extra.distance, formulas });
        }
    }
    out
}

fn of_place(plan: &Plan, names: &ProgramNames, i: usize, thing: &PlannedThing) -> Vec<String> {
    let room = &names.rooms[thing.room];
    let one = |nth| names.one(plan, i, nth);
    // Those of another kind are taken in turn.
    let at = |nth: u32| thing.other.map_or_else(String::new, |o| names.one(plan, o, nth % plan.things[o].count));
    let each = |formula: &dyn Fn(u32) -> String| (0..thing.count).map(formula).collect::<Vec<_>>();
    match thing.place {
        ThingPlace::Floor => Vec::new(),
        ThingPlace::Wall => each(&|n| format!("againstWall({}, {room})", one(n))),
        ThingPlace::Corner => each(&|n| format!("inCorner({}, {room})", one(n))),
        ThingPlace::Middle => each(&|n| format!("centeredIn({}, {room})", one(n))),
        ThingPlace::Hung => each(&|n| format!("wallMounted({}, {room})", one(n))),
        ThingPlace::Ceiling => each(&|n| format!("ceilingMounted({}, {room})", one(n))),
        ThingPlace::Row => vec![format!("inRow({}, 0.05, 0.4)", names.things[i])],
        ThingPlace::On(_) => each(&|n| format!("on({}, {})", one(n), at(n))),
        ThingPlace::At(_) => each(&|n| format!("facing({0}, {1}) and near({0}, {1}, 0.4)", one(n), at(n))),
        ThingPlace::Beside(_) => each(&|n| format!("beside({}, {})", one(n), at(n))),
        ThingPlace::Near(_) => each(&|n| format!("near({}, {}, 1)", one(n), at(n))),
        ThingPlace::Before(_) => each(&|n| format!("inFrontOf({0}, {1}) and near({0}, {1}, 1)", one(n), at(n))),
        ThingPlace::Over(_) => each(&|n| format!("ceilingMounted({0}, {room}) and above({0}, {1})", one(n), at(n))),
        ThingPlace::Around(_) => {
            let mut all = each(&|n| format!("facing({0}, {1}) and near({0}, {1}, 0.6)", one(n), at(n)));
            if thing.count > 1 {
                all.push(format!("around({}, {}, 0.6)", names.things[i], at(0)));
            }
            all
        }
    }
}

fn of_extra(plan: &Plan, names: &ProgramNames, extra: &Extra) -> Vec<String> {
    let (count, d) = (plan.things[extra.thing].count, extra.distance);
    let one = |nth| names.one(plan, extra.thing, nth);
    let other = extra.other.map_or_else(String::new, |other| names.one(plan, other, 0));
    match extra.kind {
        ExtraKind::Far => vec![format!("far({}, {other}, {d})", one(0))],
        ExtraKind::Close => vec![format!("near({}, {other}, {d})", one(0))],
        ExtraKind::Clear => (0..count).map(|n| format!("clear({}, front, {d})", one(n))).collect(),
        ExtraKind::Facing => vec![format!("facing({}, {other})", one(0))],
        ExtraKind::Left => vec![format!("leftOf({}, {other})", one(0))],
        ExtraKind::Right => vec![format!("rightOf({}, {other})", one(0))],
        ExtraKind::Apart => {
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            pairs.map(|(a, b)| format!("far({}, {}, {d})", one(a), one(b))).collect()
        }
    }
}

/// The text of the program. `sentences` say what states each of `stated`.
pub(crate) fn program(plan: &Plan, names: &ProgramNames, stated: &[Stated], sentences: &[String]) -> String {
    let mut out = String::new();
    rooms(plan, names, &mut out);
    for (link, name) in plan.links.iter().zip(&names.links) {
        opening(link, name, names, &mut out);
    }
    for (thing, name) in plan.things.iter().zip(&names.things) {
        declaration(plan, thing, name, names, &mut out);
    }
    for (stated, sentence) in stated.iter().zip(sentences) {
        for formula in &stated.formulas {
            let _ = writeln!(out, "\n@req(\"{}\")\nassert {formula};", sentence.replace('"', "'"));
        }
    }
    out
}

/// Where the middles of the rooms are: they stand along x, one beside the other.
pub(super) fn middles(plan: &Plan) -> Vec<f64> {
    let mut end: Option<f64> = None;
    let one = |room: &super::plan::PlannedRoom| {
        let half = room.size[0] / 2.0;
        let x = end.map_or(0.0, |end| end + WALLS + half);
        end = Some(x + half);
        (x * 1000.0).round() / 1000.0
    };
    plan.rooms.iter().map(one).collect()
}

fn rooms(plan: &Plan, names: &ProgramNames, out: &mut String) {
    for ((room, name), x) in plan.rooms.iter().zip(&names.rooms).zip(middles(plan)) {
        let [width, height, depth] = room.size;
        let _ = write!(out, "region {name};\n{name}.pos <- vec3({x}, 0, 0);\n");
        let _ = write!(out, "{name}.scale <- vec3({width}, {height}, {depth});\n\n");
    }
}

fn opening(link: &Link, name: &str, names: &ProgramNames, out: &mut String) {
    let [w, h, d] = link.size;
    let _ = write!(out, "object {name};\n{name}.category <- \"{}\";\n", link.noun);
    let _ = writeln!(out, "{name}.dimensions <- vec3({w}, {h}, {d});");
    looks(name, [link.look.colour, link.look.material, link.look.feature], out);
    let (from, to) = (&names.rooms[link.between.0], link.between.1.map(|to| &names.rooms[to]));
    let _ = match to {
        Some(to) => writeln!(out, "assert connects({name}, {from}, {to});"),
        None => writeln!(out, "assert connects({name}, {from});"),
    };
    let _ = match link.noun {
        "door" => {
            writeln!(out, "assert {name}.pos.y = 0 and clear({name}, front, 0.8) and clear({name}, behind, 0.8);\n")
        }
        _ => writeln!(out, "assert {name}.pos.y = 0.9;\n"),
    };
}

fn looks(name: &str, look: [&str; 3], out: &mut String) {
    for (property, value) in ["color", "material", "features"].into_iter().zip(look) {
        if !value.is_empty() {
            let _ = writeln!(out, "{name}.{property} <- \"{value}\";");
        }
    }
}

fn declaration(plan: &Plan, thing: &PlannedThing, name: &str, names: &ProgramNames, out: &mut String) {
    let room = &names.rooms[thing.room];
    let count = if thing.count == 1 { String::new() } else { format!("[{}]", thing.count) };
    let _ = write!(out, "object {name}{count};\n{name}.category <- \"{}\";\n", thing.noun);
    looks(name, [thing.look.colour, thing.look.material, thing.look.feature], out);
    let each = |formula: &dyn Fn(&str) -> String| match thing.count {
        1 => format!("assert {};", formula(name)),
        _ => format!("assert forall each in {name}: {};", formula("each")),
    };
    let _ = writeln!(out, "{}", each(&|one| format!("inside({one}, {room})")));
    if thing.place == ThingPlace::Hung {
        let room = &plan.rooms[thing.room];
        let least = ((room.size[1] - thing.size[1] - 0.1).min(HUNG) * 100.0).floor() / 100.0;
        let _ = writeln!(out, "{}", each(&|one| format!("{one}.pos.y >= {least}")));
    }
    out.push('\n');
}
