//! The way into a room from outside, its windows, and what keeps them free.

use super::floor::Pose;
use super::kinds::PlanPlace;
use super::openings;
use super::place;
use super::plan::{Plan, metres};
use super::seek::Wall;
use super::stand;
use crate::draft::{Draft, Look, Opening, OpeningKind, Statement, ThingOrigin};

/// So much wall is left beside a window (metres).
const BESIDE: f64 = 0.3;
/// From one window to the next.
pub const BETWEEN: f64 = BESIDE + 0.2;
/// A door's size.
const DOOR: [f64; 3] = [0.95, 2.08, 0.12];
/// Sizes of windows: the usual one, and those of narrow rooms.
const WINDOWS: [[f64; 3]; 3] = [[1.4, 1.3, 0.12], [0.9, 1.2, 0.12], [0.6, 0.9, 0.12]];
/// The height of a window whose sill is above worktops and taps.
const OVER_WORKTOPS: f64 = 1.05;
/// No room has more windows.
const MOST: usize = 6;

/// A door from outside, where none leads into a room of the program. Of several rooms the one that leads to the others has it.
pub fn way_in(draft: &mut Draft, at: usize) {
    let outside = |o: &Opening| o.kind == OpeningKind::Door && o.rooms.len() == 1 && o.category.is_none();
    let kinds: Vec<&str> = draft.rooms.iter().map(|room| room.kind.as_str()).collect();
    if draft.openings.iter().any(outside) || crate::storey::hub(&kinds) != at {
        return;
    }
    let mut names = crate::names::GivenNames::default();
    let taken = draft.rooms.iter().map(|r| &r.name).chain(draft.openings.iter().map(|o| &o.name));
    taken.chain(draft.things.iter().map(|t| &t.name)).for_each(|name| {
        names.take(name);
    });
    let mut size = DOOR;
    size[1] = size[1].min(draft.rooms[at].size[1] - 0.1);
    draft.openings.push(Opening {
        name: names.take("door"),
        kind: OpeningKind::Door,
        category: None,
        rooms: vec![at],
        size,
        look: Look::default(),
        source: ThingOrigin::Inferred("a room needs a way in".into()),
    });
}

/// Where windows go: how large they are, how many, in which wall, and where the first of them is along it.
struct Windows {
    size: [f64; 3],
    count: usize,
    row: Option<(Wall, f64)>,
}

/// The windows of a room: as many as such rooms have, side by side in the wall to the outside that has the most room for
/// them; not behind what people look at.
fn windows(plan: &Plan) -> Option<Windows> {
    let usual = plan.kind.size[0] * plan.kind.size[2];
    let wanted = (plan.kind.windows as f64 * (plan.area() / usual).sqrt()).round() as usize;
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    // A room of a home that usually has a window has one, however small it is.
    let wanted = if plan.draft.rooms.len() > 1 { wanted.max(plan.kind.windows.min(1)) } else { wanted };
    let watched = plan.kind.lines.iter().any(|line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Before(..)));
    let cooks = plan.kind.lines.iter().any(|line| line.noun == "kitchen counter");
    // Small ones where it is narrow.
    let first = if plan.draft.rooms.len() > 1 && w.min(d) < 2.4 { 2 } else { 0 };
    for [width, height, thick] in WINDOWS[first..].iter().copied() {
        let height = if cooks { height.min(OVER_WORKTOPS) } else { height };
        let size = [width, height.min(h - 1.1).max(0.4), thick];
        let step = width + BESIDE + 0.2;
        let most = ((w.max(d) - 0.4) / step) as usize;
        let count = wanted.min(most).min(MOST);
        if plan.draft.rooms[plan.room].outline.is_some() {
            return Some(Windows { size, count, row: None });
        }
        let mut row = None;
        let mut fit = 0;
        let mut walls = [Wall::Left, Wall::Back, Wall::Right, Wall::Front];
        // Across from the bed hangs the television.
        if plan.draft.rooms.len() > 1 && plan.kind.has_hung_screen() {
            walls.sort_by(|a, b| a.length([w, h, d]).total_cmp(&b.length([w, h, d])));
        }
        for wall in walls {
            let (count, first) = openings::windows_in(plan.draft, plan.room, wall, count, size, step);
            let behind_door = plan.draft.openings.iter().any(|o| {
                plan.place_in_room(&o.name).and_then(|pose| Wall::behind(&pose)) == Some(wall)
                    && o.rooms.contains(&plan.room)
            });
            // The left one, unless another has room for clearly more.
            let more = if row.is_some() { 2 * count > 3 * fit } else { count > 0 };
            if more && !(watched && wall == Wall::Back) && !behind_door {
                (row, fit) = (Some((wall, first)), count);
            }
        }
        if row.is_some() {
            return Some(Windows { size, count: fit, row });
        }
        if plan.draft.rooms.len() == 1 {
            return Some(Windows { size, count, row });
        }
    }
    None
}

/// Adds the windows of a room.
pub fn add_windows(plan: &mut Plan) {
    let Some(Windows { size, count, row }) = windows(plan) else { return };
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    let step = size[0] + BESIDE + 0.2;
    let sill = (2.2 - size[1]).clamp(0.9, 1.3).min(h - size[1] - 0.2).max(0.0);
    let why = format!("a {} has daylight", plan.kind.name);
    let mut made: Vec<String> = Vec::new();
    for i in 0..count {
        let name = plan.name("window");
        plan.draft.openings.push(Opening {
            name: name.clone(),
            kind: OpeningKind::Window,
            category: None,
            rooms: vec![plan.room],
            size,
            look: Look::default(),
            source: ThingOrigin::Inferred(why.clone()),
        });
        if let Some((wall, first)) = row {
            let along = first + step * i as f64;
            let pose = Pose { y: sill, ..wall.place([w, h, d], along, 0.0) };
            let pose = openings::in_scene(plan.draft, plan.room, &pose);
            plan.draft.places.push((name.clone(), [pose.x, pose.y, pose.z, pose.yaw]));
        }
        if let Some(last) = made.last() {
            let step = metres(step);
            let row =
                format!("assert {name}.pos = {last}.pos + {last}.right * {step} and {name}.rot.y = {last}.rot.y;");
            plan.say(row, "all windows are in one wall");
        } else if let (Some((wall, first)), true) = (row, plan.draft.rooms.len() > 1) {
            let at = Pose { y: sill, ..wall.place([w, h, d], first, 0.0) };
            let text = place::absolute(&name, &plan.room_name(), [at.x, at.y, at.z], at.yaw);
            plan.say(format!("assert {text};"), "a window faces outside, not the next room");
        } else {
            plan.say(format!("assert {name}.pos.y = {};", metres(sill)), "a window has a sill");
        }
        made.push(name);
    }
}

/// The walls of the room that have windows.
pub fn window_walls(plan: &Plan) -> Vec<Wall> {
    let windows = plan.draft.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.rooms.contains(&plan.room));
    windows.filter_map(|o| Wall::behind(&plan.place_in_room(&o.name)?)).collect()
}

/// Nothing tall stands before a window.
pub fn keep_windows_free(draft: &mut Draft, at: usize) {
    let windows: Vec<String> = draft
        .openings
        .iter()
        .filter(|o| o.kind == OpeningKind::Window && o.rooms.contains(&at))
        .map(|o| o.name.clone())
        .collect();
    let tall: Vec<(String, usize, bool)> = draft
        .things
        .iter()
        .filter(|t| t.room == Some(at) && t.size.is_some_and(|s| s[1] > 1.1 && s[0] * s[2] > 0.12))
        .filter(|t| stand::on_floor(draft, t) && stand::has_back(&t.category))
        .map(|t| (t.name.clone(), t.count, stand::placed(draft, &t.name)))
        .collect();
    for window in &windows {
        for (name, count, said) in &tall {
            let verb = if *said { "prefer" } else { "assert" };
            let text = match count {
                1 => format!("{verb} far({name}, {window}, 0.1);"),
                _ => format!("{verb} forall a in {name}: far(a, {window}, 0.1);"),
            };
            let source = ThingOrigin::Inferred("nothing tall stands in front of a window".into());
            draft.statements.push(Statement::new(&text, source));
        }
    }
}
