//! One room, from the way in to the light: openings, floor and walls, what is asked for with what goes with it, then the
//! inventory of its kind as far as there is room.

use super::build::Root;
use super::choose::{self, Choice};
use super::floor::{Floor, Piece, Pose, Shape};
use super::kinds::{self, Count, Line, Place};
use super::openings;
use super::plan::{AtWall, MOST, Plan, metres};
use super::seek::Wall;
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

/// So many lines of an inventory matter: a room without them is not what it is called.
const MATTER: usize = 4;
/// How often a room grows whose size nobody gave and in which something that matters finds no room, and by how much.
const GROWN: usize = 5;
const GROWTH: f64 = 1.07;

/// Furnishes a room of a draft.
pub fn furnish(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String]) {
    let may_grow = draft.rooms.len() == 1 && !draft.rooms[at].sized && draft.rooms[at].outline.is_none();
    let mut before = draft.clone();
    // The smallest of the rooms that lack the least.
    let mut best: Option<(usize, Draft)> = None;
    for grown in 0..=GROWN {
        let lacking = furnish_once(draft, brief, at, closed);
        if lacking == 0 || !may_grow {
            return;
        }
        if best.as_ref().is_none_or(|(least, _)| lacking < *least) {
            best = Some((lacking, draft.clone()));
        }
        if grown < GROWN {
            for k in [0, 2] {
                before.rooms[at].size[k] = (before.rooms[at].size[k] * GROWTH * 10.0).ceil() / 10.0;
            }
            *draft = before.clone();
        }
    }
    if let Some((_, best)) = best {
        *draft = best;
    }
}

/// Furnishes a room of its size. How much that matters found no room.
fn furnish_once(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String]) -> usize {
    let kind = kinds::of(&draft.rooms[at].kind).or_else(|| kinds::of("room"));
    let Some(kind) = kind else { return 0 };
    let doors_ruled_out = brief.absent.iter().any(|(name, _)| name.contains("door"));
    if !draft.outdoor && !doors_ruled_out {
        way_in(draft, at);
    }
    let rectangular = draft.rooms[at].outline.is_none();
    if rectangular && !draft.outdoor {
        openings::doors(draft, at);
    }
    let own = |t: &crate::draft::Thing| t.room == Some(at) && matches!(t.source, Source::Stated(_));
    let mut asked: Vec<usize> = (0..draft.things.len()).filter(|i| own(&draft.things[*i])).collect();
    // What seats go with comes before them.
    asked.sort_by_key(|i| {
        let category = &draft.things[*i].category;
        stand::group(category) == crate::brief::Group::Seat && !stand::has_back(category)
    });
    let windows = brief.things.iter().any(|t| t.room == at && t.group == crate::brief::Group::Window)
        || closed.iter().any(|name| name.contains("window"))
        || draft.outdoor;
    let room = &mut draft.rooms[at];
    taste::surfaces(kind, &mut room.floor, &mut room.walls);
    let mut plan = Plan::new(draft, at, kind, closed.to_vec(), brief.rooms[at].people);
    if !windows {
        add_windows(&mut plan);
    }
    if rectangular {
        plan.ground = Some(openings::floor(plan.draft, at));
    }
    for thing in &asked {
        stand_up(&mut plan, *thing);
    }
    for (i, line) in kind.lines.iter().enumerate() {
        let stands = !matches!(line.place, Place::Hung | Place::Ceiling | Place::Corner);
        let few = matches!(line.count, Count::Fixed(..=3)) || matches!(line.place, Place::Rows(_));
        plan.matters = i < MATTER && stands && few && line.least == 0.0 && plan.count() <= MOST;
        let (things, closed) = (plan.draft.things.len(), plan.is_closed(line.noun));
        inventory(&mut plan, line);
        plan.lacking += usize::from(plan.matters && !closed && plan.draft.things.len() == things);
    }
    let lacking = plan.lacking;
    keep_windows_free(plan.draft, at);
    lacking
}

/// A door from outside, where none leads into a room of the program. Of several rooms the one that leads to the others has it.
fn way_in(draft: &mut Draft, at: usize) {
    let outside = |o: &Opening| o.kind == OpeningKind::Door && o.rooms.len() == 1;
    let kinds: Vec<&str> = draft.rooms.iter().map(|room| room.kind.as_str()).collect();
    if draft.openings.iter().any(outside) || crate::storey::hub(&kinds) != at {
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
    let step = metres(WINDOW[0] + BESIDE + 0.2);
    let most = ((w.max(d) - 0.4) / (WINDOW[0] + BESIDE + 0.2)) as usize;
    let mut n = n.min(most).min(6);
    let mut size = WINDOW;
    size[1] = size[1].min(h - 1.1).max(0.4);
    let sill = 0.9_f64.min(h - size[1] - 0.2).max(0.0);
    // In the wall with the most room for them; not behind what people look at.
    let watched = plan.kind.lines.iter().any(|line| matches!(line.place, Place::Back(_) | Place::Before(..)));
    let mut chosen: Option<(Wall, f64)> = None;
    if plan.draft.rooms[plan.room].outline.is_none() {
        let mut fit = 0;
        for wall in [Wall::Left, Wall::Back, Wall::Right, Wall::Front] {
            let row = WINDOW[0] + BESIDE + 0.2;
            let (count, first) = openings::windows_in(plan.draft, plan.room, wall, n, size, row);
            let behind_door = plan.draft.openings.iter().any(|o| {
                plan.place_in_room(&o.name).and_then(|pose| Wall::behind(&pose)) == Some(wall)
                    && o.rooms.contains(&plan.room)
            });
            // The left one, unless another has room for clearly more.
            let more = if chosen.is_some() { 2 * count > 3 * fit } else { count > 0 };
            if more && !(watched && wall == Wall::Back) && !behind_door {
                (chosen, fit) = (Some((wall, first)), count);
            }
        }
        if chosen.is_some() {
            n = fit;
        }
    }
    let why = format!("a {} has daylight", plan.kind.name);
    let mut made: Vec<String> = Vec::new();
    for i in 0..n {
        let name = plan.name("window");
        plan.draft.openings.push(Opening {
            name: name.clone(),
            kind: OpeningKind::Window,
            rooms: vec![plan.room],
            size,
            look: Look::default(),
            source: Source::Inferred(why.clone()),
        });
        if let Some((wall, first)) = chosen {
            let along = first + (WINDOW[0] + BESIDE + 0.2) * i as f64;
            let pose = Pose { y: sill, ..wall.place([w, h, d], along, 0.0) };
            let pose = openings::in_scene(plan.draft, plan.room, &pose);
            plan.draft.places.push((name.clone(), [pose.x, pose.y, pose.z, pose.yaw]));
        }
        if let Some(last) = made.last() {
            let row =
                format!("assert {name}.pos = {last}.pos + {last}.right * {step} and {name}.rot.y = {last}.rot.y;");
            plan.say(row, "windows are in one wall");
        } else {
            plan.say(format!("assert {name}.pos.y = {};", metres(sill)), "a window has a sill");
        }
        made.push(name);
    }
}

/// The walls of the room that have windows.
fn window_walls(plan: &Plan) -> Vec<Wall> {
    let windows = plan.draft.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.rooms.contains(&plan.room));
    windows.filter_map(|o| Wall::behind(&plan.place_in_room(&o.name)?)).collect()
}

/// Whether someone works behind a counter at the back of such a room.
fn staffed(plan: &Plan) -> bool {
    plan.kind.lines.iter().any(|line| matches!(line.place, Place::Before(_, yaw) if yaw == 180.0))
}

/// The place of what someone sits or lies on who looks at something.
fn watched_from(plan: &Plan) -> Option<Pose> {
    let seat = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    let mut seat = seat.filter(|t| choose::seats(&t.category.replace('_', " ")));
    plan.place_in_room(&seat.next()?.name)
}

/// What is asked for stands at a wall if such things do and nothing else is said, and gets what goes with it.
fn stand_up(plan: &mut Plan, thing: usize) {
    if plan.claimed.contains(&thing) {
        return;
    }
    let it = plan.draft.things[thing].clone();
    let noun = it.category.replace('_', " ");
    // Where such rooms have their own of it, it stands as those do.
    let own = plan.kind.lines.iter().find(|line| stand::counts_as(line.noun, &noun)).map(|line| &line.place);
    if let (Some(Place::Rows(toward)), true) = (own, it.count > 2 && !stand::placed(plan.draft, &it.name)) {
        let clear = format!("againstWall(a, {})", plan.room_name());
        if stand::on_floor(plan.draft, &it)
            && rows(plan, &noun, it.count, *toward, ("such things stand in rows", Some(thing)))
        {
            plan.draft
                .statements
                .retain(|s| s.demand != Demand::Prefer || !s.text.contains(&clear) || !s.text.contains(&it.name));
            return;
        }
    }
    let at_wall_like = matches!(own, Some(Place::Wall | Place::Run));
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
        if let Some(depth) = stand::access(&it.category).filter(|_| !choose::front_taken(&noun)) {
            let text = all(&format!("clear({one}, front, {})", metres(depth))).replacen("assert", "prefer", 1);
            plan.say(text, "one gets at it from the front");
        }
        if verb == "assert" || said {
            wall = AtWall::Yes;
        }
    }
    if !at_wall_like {
        straighten(plan, thing);
    }
    let placed = match it.size.filter(|_| plan.ground.is_some() && stand::on_floor(plan.draft, &it)) {
        Some(size) => {
            let windows = window_walls(plan);
            let choice = Choice {
                noun: &noun,
                size,
                windows: &windows,
                looks_at: None,
                strictly: false,
                staffed: staffed(plan),
            };
            let turned = plan.draft.statements.iter().any(|s| s.text.contains(&format!("{}.rot.y = 90", it.name)));
            let yaws: &[f64] = if turned { &[90.0] } else { &[0.0] };
            let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| {
                if (stand::has_back(&it.category) || at_wall_like) && it.count <= 8 {
                    choice.wall(floor, shape, before)
                } else {
                    choice.floor(floor, shape, before, yaws)
                }
            };
            let root = Root { n: it.count, frames: vec![Pose::default()], wall, seek: &seek };
            let placed = plan.place_asked(thing, &root);
            plan.lacking += usize::from(!placed);
            placed
        }
        None => false,
    };
    if !placed {
        plan.building = None;
        plan.surround(thing, wall, 0);
    }
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
        Place::Rows(toward) => {
            rows(plan, line.noun, n, *toward, (&why, None));
        }
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
    // Where places are known, they say better what there is room for.
    let room_for = |n: &usize| hung || plan.matters && plan.ground.is_some() || plan.has_room(size, *n, at_wall);
    let n = (0..=n).rev().find(room_for).unwrap_or(0);
    if n == 0 {
        return;
    }
    let [width, height, depth] = plan.draft.rooms[plan.room].size;
    let y = if hung { (EYES - size[1] / 2.0).clamp(0.3, (height - size[1] - 0.1).max(0.3)) } else { 0.0 };
    let along = size[0] >= size[2];
    let middle_yaw = if (width >= depth) == along { 0.0 } else { 90.0 };
    let rectangular = plan.draft.rooms[plan.room].outline.is_none();
    let opposite = match &line.place {
        Place::Opposite(other) => plan
            .draft
            .things
            .iter()
            .find(|t| {
                t.room == Some(plan.room) && t.count == 1 && t.category.replace('_', " ").ends_with(other.as_str())
            })
            .map(|t| t.name.clone()),
        _ => None,
    };
    let opposite_pose = opposite.as_ref().and_then(|name| plan.place_in_room(name));
    let watched = if line.noun.ends_with("tv") { watched_from(plan) } else { opposite_pose };
    let windows = window_walls(plan);
    let choice = Choice {
        noun: line.noun,
        size,
        windows: &windows,
        looks_at: watched,
        strictly: opposite_pose.is_some(),
        staffed: staffed(plan),
    };
    // Of places along a line, the nearest to the one that is meant.
    let near = |floor: &Floor, shape: &Shape, nominal: Pose| {
        let off =
            |i: i32, k: i32| Pose { x: nominal.x + 0.15 * f64::from(i), z: nominal.z - 0.15 * f64::from(k), ..nominal };
        let further = if matches!(line.place, Place::Before(..)) { 6 } else { 0 };
        let steps = (0..=further).flat_map(|k| (-30..=30).map(move |i| off(i, k)));
        super::seek::best(floor, shape, steps, &|pose| {
            Some((pose.x - nominal.x).abs() + 2.0 * (pose.z - nominal.z).abs())
        })
    };
    let nominal = match &line.place {
        Place::Back(share) => Pose { x: share * (width - size[0]) / 2.0, y, z: (depth - size[2]) / 2.0, yaw: 180.0 },
        Place::Front(share) => Pose { x: share * (width - size[0]) / 2.0, y, z: (size[2] - depth) / 2.0, yaw: 0.0 },
        Place::Before(gap, yaw) => Pose { x: 0.0, y: 0.0, z: (depth - size[2]) / 2.0 - gap, yaw: *yaw },
        _ => Pose { yaw: middle_yaw, ..Pose::default() },
    };
    let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| match &line.place {
        _ if hung && matches!(line.place, Place::Hung | Place::Wall) => choice.hung(floor, shape, before, y),
        Place::Wall | Place::Run | Place::Hung => choice.wall(floor, shape, before),
        Place::Opposite(_) => choice.wall(floor, shape, before).or_else(|| {
            let anywhere = Choice { strictly: false, ..choice };
            anywhere.wall(floor, shape, before)
        }),
        Place::Corner => choice.corner(floor, shape, before),
        Place::Floor => choice.floor(floor, shape, before, &[0.0]),
        Place::Middle if n > 1 => choice.floor(floor, shape, before, &[0.0]),
        _ => near(floor, shape, nominal),
    };
    let run = line.place == Place::Run && n > 1;
    let together = |n: usize| (0..n).map(|i| Pose { x: i as f64 * (size[0] + 0.01), ..Pose::default() }).collect();
    let frames: Vec<Pose> = if run { together(n) } else { vec![Pose::default()] };
    let wall = if at_wall && !hung && line.place != Place::Corner { AtWall::Yes } else { AtWall::No };
    let mut add = |plan: &mut Plan, n: usize| {
        if !hung {
            plan.take(size, n, at_wall);
        }
        plan.add(line.noun, n, size, why)
    };
    // A run that is too long is made shorter.
    let mut found = None;
    let shortest = if run { 1 } else { n };
    for less in (shortest..=n).rev() {
        let frames = if run { frames[..less].to_vec() } else { frames.clone() };
        let root = Root { n: if run { 1 } else { n }, frames, wall, seek: &seek };
        found = plan.place_group(&root, &mut add);
        if found.is_some() {
            break;
        }
    }
    let Some((thing, poses)) = found else { return };
    let (name, n) = (plan.draft.things[thing].name.clone(), plan.draft.things[thing].count);
    let room = plan.room_name();
    let every = |f: &dyn Fn(&str) -> String| match n {
        1 => format!("assert {};", f(&name)),
        _ => format!("assert forall a in {name}: {};", f("a")),
    };
    let access = stand::access(line.noun).filter(|_| !choose::front_taken(line.noun)).map(metres);
    let used = |x: &str| access.as_ref().map_or(String::new(), |a| format!(" and clear({x}, front, {a})"));
    let at = poses.first().copied().unwrap_or(nominal);
    let fixed = |at: &Pose| place::absolute(&name, &room, [at.x, at.y, at.z], at.yaw);
    // Against the wall to a millimetre, so that what is on the wall above it touches the wall, too.
    let back = |x: &str| format!("onFloor({x}, {room}) and backToWall({x}, {room}, 0.01)");
    let text = match &line.place {
        _ if hung && matches!(line.place, Place::Hung | Place::Wall) => {
            every(&|x| format!("wallMounted({x}, {room}) and {x}.bottom = {}", metres(y)))
        }
        Place::Wall | Place::Hung => every(&|x| format!("{}{}", back(x), used(x))),
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
        Place::Middle if n == 1 && rectangular => format!("assert {};", fixed(&at)),
        Place::Middle | Place::Floor => {
            every(&|x| format!("onFloor({x}, {room}) and gap({x}, {room}) >= 0.6 and {x}.rot.y = 0"))
        }
        Place::Back(_) | Place::Front(_) | Place::Before(..) if n == 1 => format!("assert {};", fixed(&at)),
        Place::Back(_) | Place::Front(_) | Place::Before(..) => every(&|x| back(x)),
        Place::Opposite(_) => {
            let straight = match (opposite_pose, poses.first()) {
                (Some(seen), Some(at)) => (seen.yaw - at.yaw).rem_euclid(360.0) == 180.0,
                _ => true,
            };
            if let Some(to) = opposite.filter(|_| straight) {
                plan.say(
                    format!(
                        "prefer angle({name}.front, {to}.front) >= 175 and abs(dot({name}.center - {to}.center, {to}.right)) <= 0.3;"
                    ),
                    why,
                );
            }
            every(&|x| back(x))
        }
        Place::Ceiling | Place::Rows(_) => return,
    };
    plan.say(text, why);
    if matches!(line.place, Place::Back(_) | Place::Front(_)) && hung {
        plan.say(every(&|x| format!("wallMounted({x}, {room})")), why);
    }
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
/// Of things that are asked for, all or none. Whether they stand there.
fn rows(plan: &mut Plan, noun: &str, n: usize, toward: bool, (why, asked): (&str, Option<usize>)) -> bool {
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    if plan.draft.rooms[plan.room].outline.is_some() || n == 0 {
        return false;
    }
    let wanted = n;
    let size = asked.and_then(|thing| plan.draft.things[thing].size).unwrap_or_else(|| Plan::size(noun));
    let flat = size[1] < 0.05;
    let [left, right, back, front] = plan.reach(noun, size);
    let (cell_w, cell_d) = (left + right, back + front);
    // Ways of this width between the rows and around them.
    let (aisle, side) = (if cell_w > 1.9 { 0.75 } else { 0.45 }, 0.9);
    let between = if flat { 0.35 } else { 0.6 };
    let ahead = match toward {
        true if flat => 1.3,
        true => 2.2_f64.min(0.28 * d),
        false => side,
    };
    let (free_w, free_d) = (w - 2.0 * side, d - ahead - side);
    let columns = (((free_w + aisle) / (cell_w + aisle)) as usize).max(1);
    let lines = (((free_d + between) / (cell_d + between)) as usize).max(1);
    if cell_w > free_w || cell_d > free_d {
        plan.lacking += usize::from(plan.matters);
        return false;
    }
    let mut n = n.min(columns * lines);
    // As square as the room.
    let lines_used = n.div_ceil(columns).max(((n as f64 * free_d / free_w).sqrt().round() as usize).clamp(1, lines));
    let columns_used = n.div_ceil(lines_used);
    let step = |free: f64, cell: f64, count: usize, least: f64| {
        let most = if count > 1 { (free - cell) / (count - 1) as f64 } else { 0.0 };
        most.min(cell + least.max(0.35 * cell)).max(most.min(cell + least))
    };
    let step_x = step(free_w, cell_w, columns_used, aisle);
    let step_z = step(free_d, cell_d, lines_used, between);
    // The middle of the rows, the group's own middle apart.
    let mid_z = (side - ahead) / 2.0 - if toward { 0.0 } else { (front - back) / 2.0 };
    let yaw = if toward { 180.0 } else { 0.0 };
    let off = if toward { (front - back) / 2.0 } else { 0.0 };
    let mut places: Vec<Pose> = (0..n)
        .map(|i| {
            let (column, line) = (i % columns_used, i / columns_used);
            let in_line = columns_used.min(n - line * columns_used);
            let x = (column as f64 - (in_line as f64 - 1.0) / 2.0) * step_x;
            let z = mid_z + off - (line as f64 - (lines_used as f64 - 1.0) / 2.0) * step_z;
            Pose { x, y: 0.0, z, yaw }
        })
        .collect();
    if let Some(ground) = &plan.ground {
        // What stands there already, and doors, leave less.
        let around = Pose { x: (right - left) / 2.0, z: (front - back) / 2.0, ..Pose::default() };
        let cell = [cell_w, size[1].max(0.9), cell_d];
        let piece = Piece { thing: 0, at: around, size: cell, flat, tall: false };
        let shape = Shape { pieces: vec![piece], free: Vec::new() };
        places.retain(|at| ground.fits(&shape, at));
    }
    n = places.len();
    plan.lacking += usize::from(plan.matters && n < wanted);
    if n == 0 || asked.is_some() && n < wanted {
        return false;
    }
    let thing = asked.unwrap_or_else(|| plan.add(noun, n, size, why));
    let room = plan.room_name();
    let name = plan.draft.things[thing].name.clone();
    let each: Vec<String> = places
        .iter()
        .enumerate()
        .map(|(i, at)| {
            let element = if n > 1 { format!("{name}[{i}]") } else { name.clone() };
            place::absolute(&element, &room, [at.x, at.y, at.z], at.yaw)
        })
        .collect();
    plan.say(format!("assert {};", each.join(" and ")), why);
    plan.take([cell_w, size[1], cell_d], n, false);
    let seek = |_: &Floor, _: &Shape, before: &[Pose]| places.get(before.len()).copied();
    let root = Root { n, frames: vec![Pose::default()], wall: AtWall::No, seek: &seek };
    if plan.ground.is_none() || !plan.place_asked(thing, &root) {
        plan.building = None;
        plan.surround(thing, AtWall::No, 0);
    }
    true
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
