//! What is asked for and hangs: a board before those who look at it, pictures where a wall is free, a lamp or a projector over
//! the middle of the room.

use super::build::Root;
use super::choose::{Choice, PULL};
use super::daylight::window_walls;
use super::floor::{Floor, Pose, Shape};
use super::inventory::{APART, EYES, HUNG_SCREEN};
use super::kinds::{Line, PlanPlace};
use super::plan::{AtWall, Plan};
use super::seek::Wall;
use super::spots::{around_hung, near, near_to, nominal, watched_from};
use super::{place, stand};
use crate::brief::Group;
use crate::draft::{Demand, DraftThing, ThingOrigin};
use crate::names::words;

/// A table that is as long has its lamps over it (metres).
const LONG: f64 = 1.5;
/// Furniture that has lamps above it, like tables.
const LIT: [&str; 2] = ["island", "breakfast_bar"];
/// So many lamps hang in a line over a table, or along the room.
const LAMPS: usize = 4;
/// How far from the middle of a wall what is said to hang on one wall is moved along it (metres).
const ALONG: [f64; 9] = [0.0, -0.4, 0.4, -0.8, 0.8, -1.4, 1.4, -2.0, 2.0];
/// So many boards hang side by side before those who look at them.
const ABREAST: usize = 3;
/// The most that are hung one by one.
const MOST: usize = 8;

/// Whether a thing that is asked for hangs on a wall or from the ceiling, and nobody says where.
pub fn waits(plan: &Plan, at: usize) -> bool {
    let thing = &plan.draft.things[at];
    let mounted = |text: &str| text.contains("wallMounted(") || text.contains("ceilingMounted(");
    let about = |text: &str| words(text).contains(&thing.name.as_str());
    let hangs = |text: &str| mounted(text) && about(text);
    // "Two boards on one wall": on which is not said.
    let said = plan.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)) && about(&s.text));
    let somewhere = said.clone().count() > 0
        && said.clone().all(|s| {
            s.demand == Demand::Must && (s.text.contains("wallMounted(") || at_one_wall(&s.text, &thing.name))
        });
    let from_ceiling = stand::group(&thing.category) == Group::Ceiling && thing.count <= LAMPS;
    plan.ground.is_some()
        && thing.count <= MOST
        && (from_ceiling || matches!(stand::group(&thing.category), Group::Wall | Group::Screen))
        && (somewhere
            || plan.draft.statements.iter().any(|s| !matches!(s.source, ThingOrigin::Stated(_)) && hangs(&s.text))
                && !plan.is_placed(at))
}

/// Whether it is said of several things that they are at the wall of the first of them, and not at that of something else.
fn at_one_wall(text: &str, name: &str) -> bool {
    text.ends_with(&format!("dot({name}[i].front, {name}[0].front) >= 0.9"))
}

/// Whether such rooms have a place of its own for it, as a classroom for its board, or it needs a wall for itself.
pub fn has_place(plan: &Plan, at: usize) -> bool {
    line(plan, at).is_some_and(|line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Front(_)))
        || is_row(plan, at)
}

/// Whether several things are said to hang on one wall.
fn is_row(plan: &Plan, at: usize) -> bool {
    let it = &plan.draft.things[at];
    it.count > 1 && plan.draft.statements.iter().any(|s| at_one_wall(&s.text, &it.name))
}

fn line(plan: &Plan, at: usize) -> Option<&'static Line> {
    let noun = plan.draft.things[at].category.replace('_', " ");
    let lines = || plan.kind.lines.iter();
    // A television that is asked for hangs where such rooms have their screen.
    let is_screen = |noun: &str| stand::group(noun) == Group::Screen || noun.ends_with("screen");
    let own = |line: &&Line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Front(_)) && is_screen(line.noun);
    let screen = || lines().find(own).filter(|_| is_screen(&noun) && plan.draft.things[at].count == 1);
    lines().find(|line| stand::counts_as(line.noun, &noun)).or_else(screen)
}

/// One lamp hangs above the middle of the room; several hang in a line over its table, or along it.
fn lamps(plan: &mut Plan, it: &DraftThing, y: f64) {
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let tables = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count == 1);
    let long = |size: [f64; 3]| size[0].max(size[2]);
    let is_lit = |t: &&DraftThing| {
        let noun = t.category.replace('_', " ");
        !noun.ends_with("kitchen counter")
            && (stand::group(&noun) == Group::Table || LIT.iter().any(|end| noun.ends_with(end)))
    };
    let mut tables: Vec<&DraftThing> =
        tables.filter(is_lit).filter(|t| t.size.is_some_and(|s| long(s) > LONG)).collect();
    // First what one stands or sits at in mid-room.
    tables.sort_by_key(|t| !LIT.iter().any(|end| t.category.ends_with(end)));
    let table = tables.into_iter().find_map(|t| Some((plan.place_in_room(&t.name)?, t.size?))).filter(|_| it.count > 1);
    let (middle, length) = match table {
        Some((at, size)) if size[2] > size[0] => (Pose { yaw: at.yaw + 90.0, ..at }, size[2]),
        Some((at, size)) => (at, size[0]),
        None => (Pose { yaw: if w >= d { 0.0 } else { 90.0 }, ..Pose::default() }, w.max(d)),
    };
    let step = length / it.count as f64;
    let each = (0..it.count).map(|i| {
        let along = (i as f64 + 0.5) * step - length / 2.0;
        let at = middle.then(&Pose { x: along, ..Pose::default() });
        let name = if it.count > 1 { format!("{}[{i}]", it.name) } else { it.name.clone() };
        (name, Pose { y, yaw: 0.0, ..at })
    });
    let each: Vec<(String, Pose)> = each.collect();
    each.iter().for_each(|(name, at)| plan.note_place(name, at));
    let room = plan.room_name();
    let each = each.iter().map(|(name, at)| place::absolute(name, &room, [at.x, at.y, at.z], 0.0));
    let text = format!("prefer {};", each.collect::<Vec<_>>().join(" and "));
    plan.say(text, if it.count > 1 { "lamps hang in a line" } else { "it hangs above the middle of the room" });
}

/// From a projector to its screen, as far as there is room (metres).
const THROW: f64 = 2.8;

/// Projectors that are asked for hang before the screen of the room, or above its middle.
pub fn projectors(plan: &mut Plan) {
    for at in 0..plan.draft.things.len() {
        let it = plan.draft.things[at].clone();
        let is_asked = it.room == Some(plan.room) && matches!(it.source, ThingOrigin::Stated(_)) && it.count == 1;
        if !is_asked || !is_projector(&it.category) || !waits(plan, at) {
            continue;
        }
        let (Some(size), [_, height, depth]) = (it.size, plan.draft.rooms[plan.room].size) else { continue };
        let Some(screen) = near_to(plan, "projection screen") else {
            lamps(plan, &it, height - size[1]);
            continue;
        };
        let before = screen.then(&Pose { z: THROW.min(0.6 * depth), ..Pose::default() });
        let pose = Pose { y: height - size[1], yaw: (screen.yaw + 180.0) % 360.0, ..before };
        plan.note_place(&it.name, &pose);
        let there = place::absolute(&it.name, &plan.room_name(), [pose.x, pose.y, pose.z], pose.yaw);
        plan.say(format!("prefer {there};"), "it shines on its screen");
    }
}

fn is_projector(category: &str) -> bool {
    category.ends_with("projector")
}

/// Hangs it up. Where there is no place, its place is left to the search.
pub fn up(plan: &mut Plan, at: usize) {
    if plan.claimed.contains(&at) {
        return;
    }
    let it = plan.draft.things[at].clone();
    let Some(mut size) = it.size else { return };
    let (noun, windows) = (it.category.replace('_', " "), window_walls(plan));
    // A screen of the usual size has no foot when it hangs.
    if stand::group(&noun) == Group::Screen && size[2] > HUNG_SCREEN && size[1..] == Plan::size(&noun)[1..] {
        size[2] = HUNG_SCREEN;
        plan.draft.things[at].size = Some(size);
    }
    let height = plan.draft.rooms[plan.room].size[1];
    if is_projector(&noun) && it.count == 1 {
        return;
    }
    if stand::group(&noun) == Group::Ceiling {
        return lamps(plan, &it, height - size[1]);
    }
    let y = (EYES - size[1] / 2.0).clamp(0.3, (height - size[1] - 0.1).max(0.3));
    let line = line(plan, at);
    // One for a projector is watched, too.
    let is_screen = stand::group(&noun) == Group::Screen || noun.ends_with("screen");
    let choice = Choice {
        noun: &noun,
        size,
        windows: &windows,
        looks_at: if is_screen { watched_from(plan) } else { None },
        strictly: false,
        staffed: None,
        near: line.and_then(|line| near_to(plan, line.by)),
        pull: PULL[0],
        beds: &[],
        watched: false,
        dines: false,
        taught: false,
        parted: false,
        exit: None,
        side: [0.0; 2],
    };
    let is_own = |line: &&Line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Front(_));
    let own = line.filter(|line| it.count <= ABREAST && is_own(line));
    let own = own.map(|line| (line, nominal(plan, line, size, y)));
    let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| {
        // Two of them hang side by side where one would.
        let aside = (before.len() as f64 - (it.count as f64 - 1.0) / 2.0) * (size[0] + APART[1]);
        let own = own
            .and_then(|(line, nominal)| near(line, floor, shape, nominal.then(&Pose { x: aside, ..Pose::default() })));
        own.or_else(|| choice.hung(floor, shape, before, y))
    };
    if own.is_none() && is_row(plan, at) {
        let placed = APART.iter().any(|beside| side_by_side(plan, at, (size, y), *beside));
        plan.lacking += usize::from(!placed);
        return;
    }
    for beside in APART {
        let free = around_hung(&noun, size, beside);
        let root =
            Root { n: it.count, frames: vec![Pose::default()], wall: AtWall::No, free, whole: false, seek: &seek };
        if plan.place_asked(at, &root) {
            break;
        }
    }
    // Nobody turns the head in bed to watch.
    let is_across = |pose: Pose, seen: Pose| (pose.yaw - seen.yaw).rem_euclid(360.0) == 180.0;
    if let (Some(pose), Some(seen), true) = (plan.place_in_room(&it.name), choice.looks_at, plan.sleeps()) {
        plan.lacking += usize::from(!is_across(pose, seen));
    }
    if let (Some(_), Some(pose)) = (own, plan.place_in_room(&it.name)) {
        let text = place::absolute(&it.name, &plan.room_name(), [pose.x, pose.y, pose.z], pose.yaw);
        plan.say(format!("prefer {text};"), "it usually stands there in such a room");
    }
}

/// Hangs several things in a row on the first wall that has room for all of them. Whether there is one.
fn side_by_side(plan: &mut Plan, at: usize, (size, y): ([f64; 3], f64), beside: f64) -> bool {
    let (noun, n) = (plan.draft.things[at].category.replace('_', " "), plan.draft.things[at].count);
    let step = size[0] + if noun.ends_with("gym mirror") { 0.0 } else { beside };
    let tries = Wall::ALL.iter().flat_map(|wall| ALONG.iter().map(move |along| (*wall, *along)));
    tries.into_iter().any(|(wall, middle)| {
        let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| {
            let along = middle + (before.len() as f64 - (n as f64 - 1.0) / 2.0) * step;
            let pose = Pose { y, ..wall.place(floor.size, along, size[2] / 2.0) };
            floor.fits(shape, &pose).then_some(pose)
        };
        let free = around_hung(&noun, size, beside / 2.0);
        plan.place_asked(
            at,
            &Root { n, frames: vec![Pose::default()], wall: AtWall::No, free, whole: false, seek: &seek },
        )
    })
}
