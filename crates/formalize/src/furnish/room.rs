//! One room, from the way in to the light: openings, floor and walls, what is asked for with what goes with it, then the
//! inventory of its kind as far as there is room.

use super::kinds::{self, Count, Line, Place};
use super::plan::{AtWall, MOST, Plan, metres};
use super::{groups, place, stand, taste};
use crate::brief::Brief;
use crate::draft::{Demand, Draft, Look, Opening, OpeningKind, Source, Statement};

/// So much wall is left beside a window (metres).
const BESIDE: f64 = 0.3;
/// A door's size, and that of a window.
const DOOR: [f64; 3] = [0.95, 2.08, 0.12];
const WINDOW: [f64; 3] = [1.4, 1.3, 0.12];
/// How high things on walls are looked at.
const EYES: f64 = 1.5;

/// Furnishes a room of a draft.
pub fn furnish(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String]) {
    let kind = kinds::of(&draft.rooms[at].kind).or_else(|| kinds::of("room"));
    let Some(kind) = kind else { return };
    let doors_ruled_out = brief.absent.iter().any(|(name, _)| name.contains("door"));
    if !draft.outdoor && !doors_ruled_out {
        way_in(draft, at);
    }
    let own = |t: &crate::draft::Thing| t.room == Some(at) && matches!(t.source, Source::Stated(_));
    let asked: Vec<usize> = (0..draft.things.len()).filter(|i| own(&draft.things[*i])).collect();
    let windows = brief.things.iter().any(|t| t.room == at && t.group == crate::brief::Group::Window)
        || closed.iter().any(|name| name.contains("window"))
        || draft.outdoor;
    let room = &mut draft.rooms[at];
    taste::surfaces(kind, &mut room.floor, &mut room.walls);
    let mut plan = Plan::new(draft, at, kind, closed.to_vec(), brief.rooms[at].people);
    if !windows {
        add_windows(&mut plan);
    }
    for thing in &asked {
        stand_up(&mut plan, *thing);
    }
    for line in &kind.lines {
        inventory(&mut plan, line);
    }
    keep_windows_free(plan.draft, at);
}

/// A door from outside, where no door leads into a room of the program.
fn way_in(draft: &mut Draft, at: usize) {
    let leads = |o: &Opening| o.kind == OpeningKind::Door && o.rooms.contains(&at);
    let outside = |o: &Opening| o.kind == OpeningKind::Door && o.rooms.len() == 1;
    let any_outside = draft.openings.iter().any(outside);
    if draft.openings.iter().any(leads) && (at > 0 || any_outside) || at > 0 && any_outside && draft.rooms.len() > 1 {
        return;
    }
    let mut names = crate::names::Names::default();
    let taken = draft.rooms.iter().map(|r| &r.name).chain(draft.openings.iter().map(|o| &o.name));
    taken.chain(draft.things.iter().map(|t| &t.name)).for_each(|name| {
        names.take(name);
    });
    let mut size = DOOR;
    size[1] = size[1].min(draft.rooms[at].size[1] - 0.1);
    draft.openings.push(Opening {
        name: names.take("door"),
        kind: OpeningKind::Door,
        rooms: vec![at],
        size,
        look: Look::default(),
        source: Source::Inferred("one has to get in".into()),
    });
}

/// Windows side by side in a wall to the outside, as many as such rooms have.
fn add_windows(plan: &mut Plan) {
    let usual = plan.kind.size[0] * plan.kind.size[2];
    let n = (plan.kind.windows as f64 * (plan.area() / usual).sqrt()).round() as usize;
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    let most = ((w.max(d) - 0.4) / (WINDOW[0] + BESIDE + 0.2)) as usize;
    let why = format!("a {} has daylight", plan.kind.name);
    let mut made: Vec<String> = Vec::new();
    for _ in 0..n.min(most).min(6) {
        let name = plan.name("window");
        let mut size = WINDOW;
        size[1] = size[1].min(h - 1.1).max(0.4);
        plan.draft.openings.push(Opening {
            name: name.clone(),
            kind: OpeningKind::Window,
            rooms: vec![plan.room],
            size,
            look: Look::default(),
            source: Source::Inferred(why.clone()),
        });
        if let Some(last) = made.last() {
            let step = metres(WINDOW[0] + BESIDE + 0.2);
            let row =
                format!("assert {name}.pos = {last}.pos + {last}.right * {step} and {name}.rot.y = {last}.rot.y;");
            plan.say(row, "windows are in one wall");
        } else if n > 1 {
            let sill = 0.9_f64.min((h - size[1]) / 2.0).max(0.0);
            plan.say(format!("assert {name}.pos.y = {};", metres(sill)), "a window has a sill");
        }
        made.push(name);
    }
}

/// What is asked for stands at a wall if such things do and nothing else is said, and gets what goes with it.
fn stand_up(plan: &mut Plan, thing: usize) {
    let it = plan.draft.things[thing].clone();
    let room = plan.room_name();
    let mut wall = AtWall::No;
    if stand::on_floor(plan.draft, &it) && it.count <= 4 && stand::has_back(&it.category) {
        let verb = if stand::placed(plan.draft, &it.name) { "prefer" } else { "assert" };
        let one = if it.count > 1 { "a" } else { it.name.as_str() };
        let at_wall = format!("againstWall({one}, {room})");
        let all = |formula: &str| match it.count {
            1 => format!("{verb} {formula};"),
            _ => format!("{verb} forall a in {}: {formula};", it.name),
        };
        let said = plan.draft.statements.iter().any(|s| s.demand == Demand::Must && s.text.contains(&at_wall));
        plan.draft.statements.retain(|s| s.demand != Demand::Prefer || s.text != at_wall);
        if !said {
            plan.say(all(&at_wall), "such things stand at a wall");
        }
        if let Some(depth) = stand::access(&it.category) {
            let text = all(&format!("clear({one}, front, {})", metres(depth))).replacen("assert", "prefer", 1);
            plan.say(text, "one gets at it from the front");
        }
        if verb == "assert" || said {
            wall = AtWall::Yes;
        }
    }
    straighten(plan, thing);
    plan.surround(thing, wall, 0);
}

/// What is asked for and stands free is parallel to the walls, where nothing says how it is turned.
fn straighten(plan: &mut Plan, thing: usize) {
    const TURNING: [&str; 12] = [
        "againstWall(",
        "inCorner(",
        "facing(",
        "looksAt(",
        "beside(",
        "inFrontOf(",
        "behind(",
        "Mounted(",
        ".front",
        ".rot",
        "parallel(",
        ".right",
    ];
    let it = plan.draft.things[thing].clone();
    let free = matches!(stand::group(&it.category), crate::brief::Group::Table | crate::brief::Group::Floor);
    let name = &it.name;
    let subject = [format!("({name},"), format!("({name}["), format!("forall a in {name}:"), format!("{name}.")];
    let turned = plan
        .draft
        .statements
        .iter()
        .any(|s| TURNING.iter().any(|t| s.text.contains(t)) && subject.iter().any(|n| s.text.contains(n)));
    if !free || turned || !stand::on_floor(plan.draft, &it) || stand::has_back(&it.category) {
        return;
    }
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let along = it.size.is_none_or(|s| s[0] >= s[2]);
    let yaw = if (w >= d) == along { "0" } else { "90" };
    let [own_w, _, own_d] = it.size.unwrap_or_default();
    let (across, deep) = if yaw == "0" { (own_w, own_d) } else { (own_d, own_w) };
    // What cannot stand so is left to turn.
    if across > w || deep > d {
        return;
    }
    let island = stand::group(&it.category) == crate::brief::Group::Table && !stand::placed(plan.draft, name);
    let text = match it.count {
        1 if island && own_w.max(own_d) < w.min(d) - 2.0 => {
            format!("assert {name}.rot.y = {yaw} and gap({name}, {}) >= 0.7;", plan.room_name())
        }
        1 => format!("assert {name}.rot.y = {yaw};"),
        _ => format!("assert forall a in {name}: a.rot.y = {yaw};"),
    };
    plan.say(text, "things stand parallel to the walls");
}

/// Adds a line of the inventory.
fn inventory(plan: &mut Plan, line: &Line) {
    let total: usize = plan.draft.things.iter().map(|t| t.count).sum();
    if plan.area() < line.least || plan.is_closed(line.noun) || total > MOST {
        return;
    }
    let people = plan.people.map_or(plan.kind.people, |n| n as f64);
    let n = match line.count {
        Count::Fixed(n) => n,
        Count::Area(each) => (plan.area() / each).round() as usize,
        Count::People(each) => (people / each).ceil() as usize,
    };
    let why = format!("a {} has {}", plan.kind.name, if n == 1 { "one" } else { "some" });
    match &line.place {
        Place::Ceiling => ceiling(plan, line.noun, n.max(1), &why),
        Place::Rows(toward) => rows(plan, line.noun, n, *toward, &why),
        _ => single(plan, line, n, &why),
    }
}

/// The size of a thing; a table is as long as the people need who sit at it.
fn for_people(plan: &Plan, noun: &str, n: usize) -> [f64; 3] {
    let mut size = Plan::size(noun);
    let seats = groups::of(noun).iter().find(|part| matches!(part.at, groups::Where::Around(..)));
    if let (Some(people), Some(part), 1) = (plan.people, seats, n) {
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        let each_side = people.saturating_sub(2).div_ceil(2) as f64;
        let needed = each_side * (Plan::size(part.noun)[0] + 0.12) + 0.1;
        size[0] = size[0].max(needed.min(w.max(d) - 2.0));
    }
    size
}

/// Things at walls, in corners, in the middle.
fn single(plan: &mut Plan, line: &Line, n: usize, why: &str) {
    let size = for_people(plan, line.noun, n);
    let hung = line.place == Place::Hung
        || matches!(stand::group(line.noun), crate::brief::Group::Wall | crate::brief::Group::Screen);
    let at_wall = !matches!(line.place, Place::Middle | Place::Floor | Place::Before(..));
    let n = (0..=n).rev().find(|n| hung || plan.has_room(size, *n, at_wall)).unwrap_or(0);
    if n == 0 {
        return;
    }
    if !hung {
        plan.take(size, n, at_wall);
    }
    let thing = plan.add(line.noun, n, size, why);
    let room = plan.room_name();
    let [_, height, depth] = plan.draft.rooms[plan.room].size;
    let width = plan.draft.rooms[plan.room].size[0];
    let name = plan.draft.things[thing].name.clone();
    let every = |f: &dyn Fn(&str) -> String| match n {
        1 => format!("assert {};", f(&name)),
        _ => format!("assert forall a in {name}: {};", f("a")),
    };
    let access = stand::access(line.noun).map(metres);
    let used = |x: &str| access.as_ref().map_or(String::new(), |a| format!(" and clear({x}, front, {a})"));
    let fixed = |x: f64, z: f64, y: f64, yaw: f64| place::absolute(&name, &room, [x, y, z], yaw);
    // Against the wall to a millimetre, so that what is on the wall above it touches the wall, too.
    let back = |x: &str| format!("onFloor({x}, {room}) and backToWall({x}, {room}, 0.01)");
    let up = |h: f64| if hung { (EYES - size[1] / 2.0).clamp(0.3, (h - size[1] - 0.1).max(0.3)) } else { 0.0 };
    let text = match &line.place {
        Place::Hung => every(&|x| format!("wallMounted({x}, {room}) and {x}.bottom = {}", metres(up(height)))),
        Place::Wall => every(&|x| format!("{}{}", back(x), used(x))),
        Place::Run if n == 1 => every(&|x| format!("{}{}", back(x), used(x))),
        Place::Run => {
            let step = metres(size[0] + 0.01);
            let first = format!("{name}[0]");
            plan.say(format!("assert {}{};", back(&first), used(&first)), why);
            format!(
                "assert forall i in 1..{n}: {name}[i].pos = {name}[0].pos + {name}[0].right * (i * {step}) and {name}[i].rot.y = {name}[0].rot.y;"
            )
        }
        Place::Corner => every(&|x| format!("onFloor({x}, {room}) and inCorner({x}, {room})")),
        Place::Middle if n == 1 && plan.draft.rooms[plan.room].outline.is_none() => {
            let along = size[0] >= size[2];
            let yaw = if (width >= depth) == along { 0.0 } else { 90.0 };
            format!("assert {};", fixed(0.0, 0.0, 0.0, yaw))
        }
        Place::Middle | Place::Floor => {
            every(&|x| format!("onFloor({x}, {room}) and gap({x}, {room}) >= 0.6 and {x}.rot.y = 0"))
        }
        Place::Back(share) => {
            let x = share * (width - size[0]) / 2.0;
            format!("assert {};", fixed(x, (depth - size[2]) / 2.0, up(height), 180.0))
        }
        Place::Front(share) => {
            let x = share * (width - size[0]) / 2.0;
            format!("assert {};", fixed(x, (size[2] - depth) / 2.0, up(height), 0.0))
        }
        Place::Before(gap, yaw) => format!("assert {};", fixed(0.0, (depth - size[2]) / 2.0 - gap, 0.0, *yaw)),
        Place::Opposite(other) => {
            let to = plan.draft.things.iter().find(|t| {
                t.room == Some(plan.room) && t.count == 1 && t.category.replace('_', " ").ends_with(other.as_str())
            });
            let opposite = to.map(|to| {
                let to = &to.name;
                format!("prefer angle({name}.front, {to}.front) >= 175 and abs(dot({name}.center - {to}.center, {to}.right)) <= 0.3;")
            });
            if let Some(opposite) = opposite {
                plan.say(opposite, why);
            }
            every(&|x| back(x))
        }
        Place::Ceiling | Place::Rows(_) => return,
    };
    plan.say(text, why);
    if matches!(line.place, Place::Back(_) | Place::Front(_)) && hung {
        plan.say(every(&|x| format!("wallMounted({x}, {room})")), why);
    }
    let wall = if at_wall && !hung && line.place != Place::Corner { AtWall::Yes } else { AtWall::No };
    plan.surround(thing, wall, 0);
}

/// Lights spread evenly under the ceiling.
fn ceiling(plan: &mut Plan, noun: &str, n: usize, why: &str) {
    if plan.draft.outdoor {
        return;
    }
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    let size = Plan::size(noun);
    let outline = plan.draft.rooms[plan.room].outline.is_some();
    let n = if outline { 1 } else { n.min(16) };
    // Rows across the shorter side.
    let pendant = plan.draft.things.iter().any(|t| t.room == Some(plan.room) && t.category.contains("pendant"));
    let n = if pendant { n.max(2) } else { n };
    let rows = ((n as f64 * d / w).sqrt().round() as usize).clamp(1, n);
    let columns = n.div_ceil(rows);
    // What hangs over a table in the middle has its place there.
    let columns = if pendant && rows % 2 == 1 && columns % 2 == 1 { columns + 1 } else { columns };
    let n = rows * columns;
    let thing = plan.add(noun, n, size, why);
    let room = plan.room_name();
    let name = plan.draft.things[thing].name.clone();
    let y = h - size[1];
    let text = if outline {
        format!("assert {name}.pos = vec3({room}.center.x, {room}.floor + {}, {room}.center.z);", metres(y))
    } else if n == 1 {
        format!("assert {};", place::absolute(&name, &room, [0.0, y, 0.0], 0.0))
    } else {
        let each: Vec<String> = (0..n)
            .map(|i| {
                let x = ((i % columns) as f64 + 0.5) / columns as f64 - 0.5;
                let z = ((i / columns) as f64 + 0.5) / rows as f64 - 0.5;
                place::absolute(&format!("{name}[{i}]"), &room, [x * w, y, z * d], 0.0)
            })
            .collect();
        format!("assert {};", each.join(" and "))
    };
    plan.say(text, why);
    let mounted = match n {
        1 => format!("assert ceilingMounted({name}, {room});"),
        _ => format!("assert forall a in {name}: ceilingMounted(a, {room});"),
    };
    plan.say(mounted, why);
}

/// Things with their groups in rows, as many as there is room for.
fn rows(plan: &mut Plan, noun: &str, n: usize, toward: bool, why: &str) {
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    if plan.draft.rooms[plan.room].outline.is_some() || n == 0 {
        return;
    }
    let size = Plan::size(noun);
    let [left, right, back, front] = plan.reach(noun, size);
    let (cell_w, cell_d) = (left + right, back + front);
    // Ways of this width between the rows and around them.
    let (aisle, side) = (if cell_w > 1.9 { 0.75 } else { 0.45 }, 0.9);
    let ahead = if toward { 2.2_f64.min(0.28 * d) } else { side };
    let (free_w, free_d) = (w - 2.0 * side, d - ahead - side);
    let columns = (((free_w + aisle) / (cell_w + aisle)) as usize).max(1);
    let lines = (((free_d + 0.6) / (cell_d + 0.6)) as usize).max(1);
    if cell_w > free_w || cell_d > free_d {
        return;
    }
    let n = n.min(columns * lines);
    // As square as the room.
    let lines_used = n.div_ceil(columns).max(((n as f64 * free_d / free_w).sqrt().round() as usize).clamp(1, lines));
    let columns_used = n.div_ceil(lines_used);
    let thing = plan.add(noun, n, size, why);
    let room = plan.room_name();
    let name = plan.draft.things[thing].name.clone();
    let step = |free: f64, cell: f64, count: usize, least: f64| {
        let most = if count > 1 { (free - cell) / (count - 1) as f64 } else { 0.0 };
        most.min(cell + least.max(0.35 * cell)).max(most.min(cell + least))
    };
    let step_x = step(free_w, cell_w, columns_used, aisle);
    let step_z = step(free_d, cell_d, lines_used, 0.6);
    // The middle of the rows, the group's own middle apart.
    let mid_z = (side - ahead) / 2.0 - if toward { 0.0 } else { (front - back) / 2.0 };
    let yaw = if toward { 180.0 } else { 0.0 };
    let off = if toward { (front - back) / 2.0 } else { 0.0 };
    let each: Vec<String> = (0..n)
        .map(|i| {
            let (column, line) = (i % columns_used, i / columns_used);
            let in_line = columns_used.min(n - line * columns_used);
            let x = (column as f64 - (in_line as f64 - 1.0) / 2.0) * step_x;
            let z = mid_z + off - (line as f64 - (lines_used as f64 - 1.0) / 2.0) * step_z;
            let element = if n > 1 { format!("{name}[{i}]") } else { name.clone() };
            place::absolute(&element, &room, [x, 0.0, z], yaw)
        })
        .collect();
    plan.say(format!("assert {};", each.join(" and ")), why);
    plan.take([cell_w, size[1], cell_d], n, false);
    plan.surround(thing, AtWall::No, 0);
}

impl Plan<'_> {
    /// How far a thing and what stands around it reach to the left, the right, the back and the front of its middle.
    fn reach(&self, noun: &str, of: [f64; 3]) -> [f64; 4] {
        let mut out = [of[0] / 2.0, of[0] / 2.0, of[2] / 2.0, of[2] / 2.0];
        for part in groups::of(noun).iter().filter(|p| !self.is_closed(p.noun) && self.area() >= p.least) {
            let own = part.size.unwrap_or_else(|| Plan::size(part.noun));
            let sizes = super::slots::Sizes { of, own };
            for slot in super::slots::slots(&part.at, &sizes, &[]) {
                if slot.level != super::slots::Level::Floor || own[1] < 0.05 {
                    continue;
                }
                let turned = (slot.yaw / 90.0).round() as i64 % 2 != 0;
                let (half_w, half_d) = if turned { (own[2] / 2.0, own[0] / 2.0) } else { (own[0] / 2.0, own[2] / 2.0) };
                out[0] = out[0].max(half_w - slot.x);
                out[1] = out[1].max(half_w + slot.x);
                out[2] = out[2].max(half_d - slot.z);
                out[3] = out[3].max(half_d + slot.z);
            }
        }
        out
    }
}

/// Nothing tall stands before a window.
fn keep_windows_free(draft: &mut Draft, at: usize) {
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
            let source = Source::Inferred("nothing tall stands before a window".into());
            draft.statements.push(Statement::new(&text, source));
        }
    }
}
