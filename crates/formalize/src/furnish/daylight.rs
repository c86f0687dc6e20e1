//! The way into a room from outside, its windows, and what keeps them free.

use super::floor::Pose;
use super::kinds::PlanPlace;
use super::openings;
use super::place;
use super::plan::{Plan, metres};
use super::seek::Wall;
use super::stand;
use crate::draft::{Draft, Look, Opening, OpeningKind, Statement, ThingOrigin};
use crate::names::mentions;
use crate::sizes::SILL;
use scenelang_lang::nouns::with_article;

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
/// A window whose sill has that height ends this far below the ceiling at least (metres).
const BELOW_CEILING: f64 = 0.4;
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
    // Small ones where it is narrow.
    let first = if plan.draft.rooms.len() > 1 && w.min(d) < 2.4 { 2 } else { 0 };
    let large = plan.kind.panes.filter(|_| plan.draft.rooms.len() == 1);
    let large = large.map(|[width, height]| [width, height, WINDOWS[0][2]]);
    let sizes = large.map(|size| (true, size)).into_iter().chain(WINDOWS[first..].iter().map(|size| (false, *size)));
    for (is_large, [width, height, thick]) in sizes {
        let height = if cooks(plan) { height.min(OVER_WORKTOPS) } else { height };
        let size = [width, height.min(h - 1.1).max(0.4), thick];
        let step = width + BETWEEN;
        let most = ((w.max(d) - 0.4) / step) as usize;
        let count = wanted.min(most).min(MOST);
        // Large ones only where all of them find room.
        if is_large && in_wall(plan, count, size, step).is_none_or(|(.., fit)| fit < count) {
            continue;
        }
        if plan.draft.rooms[plan.room].outline.is_some() {
            return Some(Windows { size, count, row: None });
        }
        if let Some((wall, first, count)) = in_wall(plan, count, size, step) {
            return Some(Windows { size, count, row: Some((wall, first)) });
        }
        if plan.draft.rooms.len() == 1 {
            return Some(Windows { size, count, row: None });
        }
    }
    None
}

/// Whether such rooms have a sink and a stove.
fn cooks(plan: &Plan) -> bool {
    plan.kind.lines.iter().any(|line| line.noun == "kitchen counter")
}

/// The wall with the most room for so many windows, the middle of the first window, and how many fit.
fn in_wall(plan: &Plan, count: usize, size: [f64; 3], step: f64) -> Option<(Wall, f64, usize)> {
    let room = plan.draft.rooms[plan.room].size;
    let watched = plan.kind.lines.iter().any(|line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Before(..)));
    let mut row: Option<(Wall, f64, usize)> = None;
    let mut walls = [Wall::Left, Wall::Back, Wall::Right, Wall::Front];
    // Across from the bed hangs the television.
    if plan.draft.rooms.len() > 1 && plan.kind.has_hung_screen() {
        walls.sort_by(|a, b| a.length(room).total_cmp(&b.length(room)));
    }
    for wall in walls {
        let (count, first) = openings::windows_in(plan.draft, plan.room, wall, count, size, step);
        let behind_door = plan.draft.openings.iter().any(|o| {
            plan.place_in_room(&o.name).and_then(|pose| Wall::behind(&pose)) == Some(wall)
                && o.rooms.contains(&plan.room)
        });
        // The left one, unless another has room for clearly more.
        let more = row.map_or(count > 0, |(_, _, fit)| 2 * count > 3 * fit);
        if more && !(watched && wall == Wall::Back) && !behind_door {
            row = Some((wall, first, count));
        }
    }
    row
}

/// Gives requested windows without a stated position the places that added windows would have. A window over a sink waits
/// until the sink has its place.
pub fn place_windows(plan: &mut Plan) {
    let asked: Vec<Opening> = plan.draft.openings.iter().filter(|o| is_open(plan, o)).cloned().collect();
    let Some(first) = asked.first() else { return };
    let size = asked.iter().fold(first.size, |size, o| [size[0].max(o.size[0]), size[1].max(o.size[1]), size[2]]);
    let step = size[0] + BETWEEN;
    let Some((wall, from, count)) = in_wall(plan, asked.len(), size, step) else { return };
    let room = plan.draft.rooms[plan.room].size;
    for (i, window) in asked.iter().enumerate().take(count) {
        let pose = Pose { y: sill(plan.draft, window), ..wall.place(room, from + step * i as f64, 0.0) };
        plan.note_place(&window.name, &pose);
    }
}

/// Places a window above the kitchen sink that it is said to be over.
pub fn place_over(plan: &mut Plan) {
    let windows: Vec<Opening> = plan.draft.openings.iter().filter(|o| sink_below(plan, o).is_some()).cloned().collect();
    for window in windows {
        let sink = sink_below(plan, &window).and_then(|sink| plan.place_in_room(&sink));
        let Some((sink, wall)) = sink.and_then(|pose| Some((pose, Wall::behind(&pose)?))) else { continue };
        let room = plan.draft.rooms[plan.room].size;
        let along = if matches!(wall, Wall::Back | Wall::Front) { sink.x } else { sink.z };
        let pose = Pose { y: sill(plan.draft, &window), ..wall.place(room, along, 0.0) };
        plan.note_place(&window.name, &pose);
    }
}

/// Whether a window of the room has no place yet, and the request does not say where it is.
fn is_open(plan: &Plan, window: &Opening) -> bool {
    const RELATED: [&str; 5] = ["connects(", "near(", "above(", "behind(", "inFrontOf("];
    let says = |s: &Statement| {
        matches!(s.source, ThingOrigin::Stated(_))
            && mentions(&s.text, &window.name)
            && !RELATED.iter().any(|call| s.text.starts_with(call))
    };
    window.kind == OpeningKind::Window
        && window.category.is_none()
        && window.rooms == [plan.room]
        && plan.draft.place_of(&window.name).is_none()
        && sink_below(plan, window).is_none()
        && !plan.draft.statements.iter().any(says)
}

/// The kitchen sink that a window without a place is said to be over.
fn sink_below(plan: &Plan, window: &Opening) -> Option<String> {
    if !cooks(plan) || window.kind != OpeningKind::Window || plan.draft.place_of(&window.name).is_some() {
        return None;
    }
    let begin = format!("above({}, ", window.name);
    let mut below = plan.draft.statements.iter().filter_map(|s| s.text.strip_prefix(&begin)?.strip_suffix(')'));
    let is_sink =
        |name: &&str| plan.draft.things.iter().any(|thing| thing.name == *name && thing.category.ends_with("sink"));
    below.find(is_sink).map(str::to_owned)
}

/// Whether a statement only says that a window without a place is over a sink or near it. It does not restrict where the sink
/// stands, because the window follows the sink.
pub fn is_moving_window(plan: &Plan, statement: &Statement) -> bool {
    let over = plan.draft.openings.iter().filter(|o| mentions(&statement.text, &o.name));
    over.into_iter().any(|window| {
        sink_below(plan, window).is_some_and(|sink| {
            mentions(&statement.text, &sink)
                && ["above(", "over(", "near("].iter().any(|call| statement.text.starts_with(call))
        })
    })
}

/// The height of a window's sill, if none is stated: above whatever is said to stand below the window (metres).
pub fn sill(draft: &Draft, window: &Opening) -> f64 {
    let said = format!("{}.bottom = ", window.name);
    if let Some(said) = draft.statements.iter().find_map(|s| s.text.strip_prefix(&said)?.parse().ok()) {
        return said;
    }
    let rooms = window.rooms.iter().filter_map(|room| draft.rooms.get(*room));
    let ceiling = rooms.map(|room| room.size[1]).fold(f64::INFINITY, f64::min);
    let free = ceiling - window.size[1];
    let usual = SILL.min((free - BELOW_CEILING).max(free / 2.0));
    usual.max(top_below(draft, &window.name).min(ceiling - window.size[1] - 0.02)).max(0.0)
}

/// The top of what is said to stand below a window.
fn top_below(draft: &Draft, window: &str) -> f64 {
    let begin = format!("above({window}, ");
    let below = draft.statements.iter().filter_map(|s| s.text.strip_prefix(&begin)?.strip_suffix(')'));
    let things = below.filter_map(|name| draft.things.iter().find(|thing| thing.name == name));
    things.filter_map(|thing| thing.size).map(|[_, h, _]| h + 0.02).fold(0.0, f64::max)
}

/// Adds the windows of a room.
pub fn add_windows(plan: &mut Plan) {
    let Some(Windows { size, count, row }) = windows(plan) else { return };
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    let step = size[0] + BETWEEN;
    let sill = (2.2 - size[1]).clamp(0.9, 1.3).min(h - size[1] - 0.2).max(0.0);
    let why = format!("{} has daylight", with_article(plan.kind.name));
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
