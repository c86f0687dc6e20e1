//! Doors and cloth that rooms of some kinds have beside a way in and windows: a garage door, the door to a bathroom, curtains.

use super::daylight;
use super::floor::Pose;
use super::kinds::{Cover, FurnishingKind};
use super::openings;
use super::plan::{Plan, metres};
use super::seek::Wall;
use crate::draft::{Draft, DraftThing, Look, Opening, OpeningKind, ThingOrigin};
use crate::names::{GivenNames, mentions};
use scenelang_lang::nouns::with_article;

/// What a wide door for cars and goods is called.
pub const GATE: &str = "garage door";
/// A door of a usual size is no wider (metres).
const NARROW: f64 = 1.0;
/// So much wider than its window is a pair of curtains, and so far it hangs from the wall (metres).
const WIDER: f64 = 0.8;
const DEEP: f64 = 0.1;
const OFF: f64 = 0.075;
/// A blind that is drawn up covers this part of its window, and is so deep and so far from the wall (metres).
const DRAWN_UP: f64 = 0.4;
const BLIND: f64 = 0.06;
const BLIND_OFF: f64 = 0.065;
/// From the floor to a curtain, and from the top of the window to its rail.
const ABOVE_FLOOR: f64 = 0.03;
const RAIL: f64 = 0.16;

/// The doors that rooms of a kind have beside the ordinary one, in a program of one room; a garage of a home has its gate.
pub fn doors(draft: &mut Draft, at: usize, kind: &FurnishingKind) {
    let of_home = draft.rooms.len() > 1;
    if of_home && (kind.home.is_none() || kind.gate.is_none()) || draft.outdoor || draft.rooms[at].outline.is_some() {
        return;
    }
    let [w, h, d] = draft.rooms[at].size;
    let is_stated = |o: &&Opening| o.kind == OpeningKind::Door && matches!(o.source, ThingOrigin::Stated(_));
    let stated = draft.openings.iter().any(|o| is_stated(&o));
    if let Some([wide, high]) = kind.gate
        && w.max(d) > wide + 1.6
    {
        // A door for goods that is asked for, and of which no size is said, is as wide as such doors are.
        let size = [gate_width(draft, at, wide), high.min(h - 0.15), 0.12];
        let gates = draft.openings.iter_mut().filter(|o| is_stated(&&**o) && o.category.as_deref() == Some(GATE));
        gates.filter(|o| o.size[0] < NARROW).for_each(|o| o.size = size);
    }
    if let Some([wide, high]) = kind.gate
        && !stated
        && w.max(d) > wide + 1.6
    {
        let size = [gate_width(draft, at, wide), high.min(h - 0.15), 0.12];
        add(draft, at, "garageDoor", GATE, size, &format!("cars or goods enter a {}", kind.name));
        // It is placed first: the ordinary door finds room beside it.
        if !of_home {
            draft.openings.rotate_right(1);
        }
    }
    if let Some(name) = kind.inner
        && !stated
        && !of_home
    {
        let size = [0.86, 2.04_f64.min(h - 0.1), 0.12];
        let words: Vec<String> = name.split(' ').map(str::to_owned).collect();
        let called = crate::names::identifier(&words.join(" "), "door");
        add(draft, at, &called, &format!("{name} door"), size, &format!("{} has one", with_article(kind.name)));
    }
}

/// How wide the gate is for the cars that are asked for, if the wall is wide enough.
fn gate_width(draft: &Draft, at: usize, one: f64) -> f64 {
    const EACH: f64 = 2.5;
    const BESIDE: f64 = 0.6;
    let cars = draft.things.iter().filter(|thing| thing.room == Some(at) && thing.category.ends_with("car"));
    let more = cars.map(|thing| thing.count).sum::<usize>().saturating_sub(1);
    let [w, _, d] = draft.rooms[at].size;
    (one + EACH * more as f64).min(w.max(d) - BESIDE).max(one)
}

fn add(draft: &mut Draft, at: usize, name: &str, category: &str, size: [f64; 3], why: &str) {
    let mut names = GivenNames::default();
    let taken = draft.rooms.iter().map(|r| &r.name).chain(draft.openings.iter().map(|o| &o.name));
    taken.chain(draft.things.iter().map(|t| &t.name)).for_each(|name| {
        names.take(name);
    });
    draft.openings.push(Opening {
        name: names.take(name),
        kind: OpeningKind::Door,
        category: Some(category.to_owned()),
        rooms: vec![at],
        size,
        look: Look::default(),
        source: ThingOrigin::Inferred(why.to_owned()),
    });
}

/// A pair of curtains, or a blind, at each window that was added.
pub fn curtains(plan: &mut Plan) {
    let Some(cover) = plan.kind.curtains.filter(|_| !plan.is_closed("curtain")) else { return };
    // Where something is said to stand at a window, or is a seat there, nothing hangs.
    let seat = |thing: &DraftThing| thing.room == Some(plan.room) && thing.category.ends_with("window_seat");
    let has_seat = plan.draft.things.iter().any(seat);
    let is_used = |window: &str| {
        let at = format!(", {window}");
        let says = |text: &str| text.starts_with("near(") && text.contains(&at) && mentions(text, window);
        has_seat || plan.draft.statements.iter().any(|s| says(&s.text))
    };
    let is_here = |o: &&Opening| o.kind == OpeningKind::Window && o.rooms.contains(&plan.room) && !is_used(&o.name);
    let windows: Vec<Opening> = plan.draft.openings.iter().filter(is_here).cloned().collect();
    let room = plan.draft.rooms[plan.room].size;
    let color = plan.turn;
    for window in windows {
        let Some(pose) = plan.place_in_room(&window.name) else { continue };
        let (Some((size, at)), why) = (match cover {
            Cover::Curtains => (hung(&window, &pose, room), "curtains hang at the window"),
            Cover::Blinds => (blind(&window, &pose, room), "a blind hangs at the window"),
        }) else {
            continue;
        };
        // All of a room are of one cloth.
        plan.turn = color;
        let thing = plan.add(cover.noun(), 1, size, why);
        let name = plan.draft.things[thing].name.clone();
        let (off, up) = (metres(at.z), metres(at.y));
        let opening = &window.name;
        plan.say(
            format!("assert {name}.pos = {opening}.pos + {opening}.front * {off} + vec3(0, {up}, 0) and {name}.rot.y = {opening}.rot.y;"),
            why,
        );
        plan.say(format!("allowFloat({name});"), "the rail is on the wall above the window");
        let at = Pose { y: pose.y + at.y, ..pose.then(&at) };
        let placed = openings::in_scene(plan.draft, plan.room, &at);
        let placed = [placed.x, placed.y, placed.z, placed.yaw].map(|v| (v * 1e4).round() / 1e4);
        plan.draft.places.push((name, placed));
        if let Some(ground) = &mut plan.ground {
            ground.body(&at, size);
        }
    }
}

/// The size of a pair of curtains, and where they are as seen from their window; `None` where there is no room for them.
fn hung(window: &Opening, pose: &Pose, room: [f64; 3]) -> Option<([f64; 3], Pose)> {
    let wall = Wall::behind(pose)?;
    let along = if matches!(wall, Wall::Back | Wall::Front) { pose.x } else { pose.z };
    let corner = wall.length(room) / 2.0 - along.abs() - 0.04;
    let wide = (window.size[0] + WIDER).min(window.size[0] + daylight::BETWEEN - 0.24).min(2.0 * corner);
    let top = (pose.y + window.size[1] + RAIL).min(room[1] - 0.05);
    let size = [wide, top - ABOVE_FLOOR, DEEP].map(to_millimetres);
    let at = Pose { y: ABOVE_FLOOR - pose.y, z: OFF + DEEP / 2.0, ..Pose::default() };
    (wide >= window.size[0] + 0.15 && size[1] >= 0.8).then_some((size, at))
}

/// The same of a blind that is drawn up.
fn blind(window: &Opening, pose: &Pose, room: [f64; 3]) -> Option<([f64; 3], Pose)> {
    let high = DRAWN_UP * window.size[1];
    let top = (window.size[1] + 0.05).min(room[1] - 0.05 - pose.y);
    let size = [window.size[0] + 0.06, high, BLIND].map(to_millimetres);
    Some((size, Pose { y: to_millimetres(top - high), z: BLIND_OFF + BLIND / 2.0, ..Pose::default() }))
}

fn to_millimetres(v: f64) -> f64 {
    (v * 1000.0).round() / 1000.0
}
