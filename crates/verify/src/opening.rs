//! What stands in the way of a part that opens: other solids, and the walls of the room that it opens into.
//!
//! Nobody has to move the object itself, what is in it or rests on the part, or carpets and curtains. Before furniture, light
//! things are pushed aside; before the door of a room they are not. P-OPEN and the built-ins about opening stand on this.

mod limits;

use crate::builtins::region_beside;
use crate::eval::{Cause, Truth};
use crate::number::Number;
use crate::world::World;
use nalgebra::Matrix3;
use scenelang_lang::program::{ObjectId, ObjectSide, Program, RegionId};
use scenelang_layout::sweep::SHARE;
use scenelang_layout::{Aabb, Convex, Joint, Motion, Moving, Obb, Separation, Swept, Vec2, Vec3};

/// What a person pushes aside before furniture is opened: the last word of the category. An object with the feature "fixed"
/// is not, one with the feature "light" is, whatever its category.
pub const PUSHED_ASIDE: [&str; 22] = [
    "armchair",
    "backpack",
    "bag",
    "ball",
    "basket",
    "beanbag",
    "bin",
    "chair",
    "dustbin",
    "footrest",
    "footstool",
    "hamper",
    "hassock",
    "highchair",
    "ottoman",
    "pouf",
    "slipper",
    "shoe",
    "stool",
    "suitcase",
    "toy",
    "wastebasket",
];
/// Roles of what gives way to anything.
const SOFT: [&str; 2] = ["carpet", "curtain"];
/// What goes along with an object is no further from it (metres).
pub(crate) const CARRIED: f64 = 0.5;
/// How well it has to be known how much is missing, as a share of it, for a search that goes on.
const ROUGH: f64 = 0.5;
/// So many looks at poses are spent on one part.
pub const LOOKS: usize = 20_000;

/// What the program says of objects and regions that matters to what opens.
#[derive(Clone, Debug, Default)]
pub(crate) struct Habits {
    /// By object: whether it is the door of a room.
    door: Vec<bool>,
    /// By object: whether it is pushed aside before furniture; whether it gives way to anything.
    light: Vec<bool>,
    soft: Vec<bool>,
    /// By region: whether it has walls.
    walled: Vec<bool>,
    /// How far things have to open at most.
    limits: limits::Limits,
}

impl Habits {
    pub fn of(program: &Program) -> Self {
        let words = |text: &str| text.to_lowercase().split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect();
        let has = |text: &str, word: &str| -> bool {
            let words: Vec<String> = words(text);
            words.iter().any(|w| w == word)
        };
        let objects = program.objects.iter();
        let light = |category: &str| {
            let words: Vec<String> = words(category);
            words.last().is_some_and(|last| {
                PUSHED_ASIDE.contains(&last.as_str())
                    || last.strip_suffix('s').is_some_and(|w| PUSHED_ASIDE.contains(&w))
            })
        };
        let asserted = |id: usize| program.allow.doors.iter().any(|door| door.object.0 as usize == id);
        Self {
            door: objects.clone().enumerate().map(|(i, o)| o.role == "door" || asserted(i)).collect(),
            light: objects
                .clone()
                .map(|o| !has(&o.features, "fixed") && (has(&o.features, "light") || light(&o.category)))
                .collect(),
            soft: objects.map(|o| SOFT.contains(&o.role.as_str())).collect(),
            walled: program.regions.iter().map(|r| !has(r.text("features"), "outdoor")).collect(),
            limits: limits::Limits::of(program),
        }
    }

    /// Whether an object is the door of a room.
    pub fn is_door(&self, id: ObjectId) -> bool {
        self.door.get(id.0 as usize).is_some_and(|door| *door)
    }

    /// How far P-OPEN asks a part to open, if it is to open at all (degrees or metres): as far as is useful, or as the program
    /// says.
    pub fn demand(&self, id: ObjectId, joint: &Joint) -> Option<f64> {
        let demand = self.limits.demand(id, joint.motion, joint.useful?);
        (demand > 0.0).then_some(demand)
    }
}

/// What a part that opens meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Another object.
    Object(ObjectId),
    Wall(RegionId),
}

/// The least gap while a part opens, and to what.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// What comes nearest.
    pub met: Met,
    /// How near (metres), and where.
    pub swept: Swept,
    /// Of a wall: a point of it that comes nearest.
    at: Vec3,
}

/// How far something opens, in words.
pub fn amount(amount: f64, motion: Motion) -> String {
    match motion {
        Motion::Hinge => format!("{}°", (amount + 0.0).floor()),
        Motion::Slide => format!("{:.2} m", (amount * 100.0).floor() / 100.0 + 0.0),
    }
}

/// How far something opens and how far it should, in as many digits as tell the two apart.
pub fn amounts(free: f64, wanted: f64, motion: Motion) -> [String; 2] {
    let both = [free, wanted].map(|x| amount(x, motion));
    if both[0] != both[1] || (free - wanted).abs() < 1e-9 {
        return both;
    }
    let finer = |x: f64| match motion {
        Motion::Hinge => format!("{:.1}°", (x * 10.0).floor() / 10.0 + 0.0),
        Motion::Slide => format!("{:.3} m", (x * 1000.0).floor() / 1000.0 + 0.0),
    };
    [free, wanted].map(finer)
}

/// What is in the way, in words.
pub fn met_in_words(program: &Program, met: Met) -> String {
    match met {
        Met::Object(id) => format!("`{}`", program.objects[id.0 as usize].name),
        Met::Wall(id) => format!("a wall of `{}`", program.regions[id.0 as usize].name),
    }
}

/// Something that may be in the way.
struct Obstacle<'w> {
    met: Met,
    solid: std::borrow::Cow<'w, [Convex]>,
    /// The distance of its box from that of the whole motion (metres).
    distance: f64,
}

/// The names and joints of an object that count.
pub fn joints<N: Number>(world: &World<N>, id: ObjectId) -> &[Joint] {
    world.object(id).map_or(&[], |thing| thing.body.joints())
}

/// The least gap between a part and whatever is in its way, opened by so much (degrees or metres); `None`: there is nothing as
/// near as the clearance that is asked for.
///
/// # Errors
/// The layout lacks the object.
pub fn nearest<N: Number>(
    world: &World<N>,
    id: ObjectId,
    part: usize,
    amount: f64,
    looks: &mut usize,
) -> Result<Option<Nearest>, Cause> {
    let Some(moving) = world.object(id)?.body.moving(part) else { return Ok(None) };
    let mut best: Option<Nearest> = None;
    let clearance = world.options.detail.clearance;
    // Who does not ask how much room there is does not ask how much is missing, either.
    let share = if clearance.is_finite() { ROUGH } else { SHARE };
    for obstacle in obstacles(world, id, moving, amount, clearance.max(0.0)) {
        let below = best.map_or(clearance, |nearest| nearest.swept.gap);
        if obstacle.distance > below.max(0.0) {
            break;
        }
        if let Some(swept) = moving.least_about(&obstacle.solid, amount, below, share, looks) {
            let there = &moving.opened(swept.at)[swept.parts[0]];
            let at = there.contact(&obstacle.solid[swept.parts[1]], &swept.separation).1;
            best = Some(Nearest { met: obstacle.met, swept, at });
        }
    }
    Ok(best)
}

/// How far a part opens (degrees or metres), `amount` at most, with nothing nearer than the tolerance of contact; and what it
/// then meets.
///
/// # Errors
/// The layout lacks the object.
pub fn free<N: Number>(
    world: &World<N>,
    id: ObjectId,
    part: usize,
    amount: f64,
    looks: &mut usize,
) -> Result<(f64, Option<Met>), Cause> {
    let Some(moving) = world.object(id)?.body.moving(part) else { return Ok((amount, None)) };
    let least = -world.options.tolerances.contact;
    let (mut free, mut met) = (amount, None);
    for obstacle in obstacles(world, id, moving, amount, 0.0) {
        if let (shorter, Some(_)) = moving.free(&obstacle.solid, free, least, looks) {
            (free, met) = (shorter, Some(obstacle.met));
        }
    }
    Ok((free, met))
}

/// Whether a part opens by so much (degrees or metres): its least gap, with the tolerance.
///
/// # Errors
/// The layout lacks the object.
pub fn opens<N: Number>(
    world: &World<N>,
    id: ObjectId,
    part: usize,
    amount: f64,
    looks: &mut usize,
) -> Result<Truth<N>, Cause> {
    let tolerances = &world.options.tolerances;
    let Some(nearest) = nearest(world, id, part, amount, looks)? else {
        let clearance = world.options.detail.clearance;
        let free = Truth::metres(N::constant(clearance), tolerances.order);
        return Ok(if clearance.is_finite() { free } else { Truth::discrete(true) });
    };
    let gap = N::measured(nearest.swept.gap, || widening(world, id, part, &nearest).unwrap_or(N::constant(0.0)));
    Ok(Truth::metres(gap + N::constant(tolerances.contact), tolerances.order))
}

/// What moves as the least gap does.
fn widening<N: Number>(world: &World<N>, id: ObjectId, part: usize, nearest: &Nearest) -> Option<N> {
    let owner = world.object(id).ok()?;
    let moving = owner.body.moving(part)?;
    let Swept { at, separation, parts: [own, other], .. } = nearest.swept;
    let Separation { normal, .. } = separation;
    let opened = moving.opened(at);
    let body = opened.get(own)?;
    Some(match nearest.met {
        Met::Object(met) => {
            let thing = world.object(met).ok()?;
            let (p, q) = body.contact(thing.body.solid().get(other)?, &separation);
            thing.attached(&q).along(&normal) - owner.attached(&p).along(&normal)
        }
        Met::Wall(region) => {
            let [x, z] = world.region(region).ok()?.attached(nearest.at.x, nearest.at.z);
            let p = nearest.at - normal * separation.gap;
            x.scale(normal.x) + z.scale(normal.z) - owner.attached(&p).along(&Vec3::new(normal.x, 0.0, normal.z))
        }
    })
}

/// All that may be in the way and whose box is no further than `reach` from that of the motion (metres), the nearest first.
fn obstacles<'w, N: Number>(
    world: &'w World<N>,
    id: ObjectId,
    moving: &Moving,
    amount: f64,
    reach: f64,
) -> Vec<Obstacle<'w>> {
    let around = moving.around(amount);
    let near = world.bodies().map(|(other, body)| (other, body, around.distance(&body.aabb())));
    let mut things: Vec<_> = near.filter(|(_, _, distance)| *distance <= reach).collect();
    things.retain(|(other, ..)| !gives_way(world, id, *other));
    if !things.is_empty() {
        let carried = carried(world, id, moving);
        things.retain(|(other, ..)| !carried.contains(other));
    }
    let mut found: Vec<Obstacle<'w>> = things
        .into_iter()
        .map(|(other, body, distance)| Obstacle { met: Met::Object(other), solid: body.solid().into(), distance })
        .collect();
    found.extend(walls(world, id, moving, amount, &around, reach));
    found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    found
}

/// Whether one object is never in the way of the parts of another.
pub fn gives_way<N: Number>(world: &World<N>, owner: ObjectId, other: ObjectId) -> bool {
    let habits = &world.habits;
    let is = |list: &[bool]| list.get(other.0 as usize).is_some_and(|is| *is);
    if other == owner || is(&habits.soft) || (!habits.is_door(owner) && is(&habits.light)) {
        return true;
    }
    world.allow.collide.contains(owner, other) || contains(world, owner, other)
}

/// Whether an object is asserted to be in another, or in something that is.
fn contains<N: Number>(world: &World<N>, outer: ObjectId, inner: ObjectId) -> bool {
    let mut open = vec![inner];
    let mut known = open.clone();
    while let Some(at) = open.pop() {
        for &(_, container) in world.allow.contents.iter().filter(|(content, _)| *content == at) {
            if container == outer {
                return true;
            }
            if !known.contains(&container) {
                known.push(container);
                open.push(container);
            }
        }
    }
    false
}

/// What rests on a part or is in its object, and what rests on that: it goes along.
fn carried<N: Number>(world: &World<N>, owner: ObjectId, moving: &Moving) -> Vec<ObjectId> {
    let Ok(thing) = world.object(owner) else { return Vec::new() };
    let reach = world.options.tolerances.support;
    let near: Vec<(ObjectId, Aabb, Vec3)> = world
        .bodies()
        .filter(|(id, _)| *id != owner)
        .map(|(id, body)| (id, body.aabb(), body.obb.center))
        .filter(|(_, around, _)| around.distance(&thing.body.aabb()) < CARRIED)
        .collect();
    let rests = |on: &Aabb, above: &Aabb| {
        (above.min.y - on.max.y).abs() <= reach
            && above.min.x < on.max.x
            && on.min.x < above.max.x
            && above.min.z < on.max.z
            && on.min.z < above.max.z
    };
    let own = &thing.body.obb;
    let inside = |p: &Vec3| (own.axes.tr_mul(&(p - own.center)).abs() - own.half).max() < 0.0;
    let mut bases: Vec<Aabb> = moving.bodies().iter().map(|body| *body.aabb()).collect();
    let mut found = Vec::new();
    loop {
        let before = found.len();
        for (id, around, center) in &near {
            if !found.contains(id) && (inside(center) || bases.iter().any(|base| rests(base, around))) {
                found.push(*id);
                bases.push(*around);
            }
        }
        if found.len() == before {
            return found;
        }
    }
}

/// The walls of the room that a part opens into and whose box is no further than `reach` from that of the motion (metres), as
/// thin upright bodies; in them a door has its own opening.
fn walls<'w, N: Number>(
    world: &'w World<N>,
    id: ObjectId,
    moving: &Moving,
    amount: f64,
    around: &Aabb,
    reach: f64,
) -> Vec<Obstacle<'w>> {
    let Ok(thing) = world.object(id) else { return Vec::new() };
    let own = &thing.body.obb;
    let middle = |bodies: &[Convex]| {
        let whole = scenelang_layout::convex::aabb(bodies);
        (whole.min + whole.max) / 2.0
    };
    let is_door = world.habits.is_door(id);
    let way = || (middle(&moving.opened(amount)) - middle(moving.bodies())).dot(&own.axes.column(2));
    let side = match is_door {
        true if way() < 0.0 => ObjectSide::Behind,
        true => ObjectSide::Front,
        false => ObjectSide::Above,
    };
    let Some((region, prism)) = region_beside(world, id, side) else { return Vec::new() };
    if !world.habits.walled.get(region.0 as usize).is_some_and(|walled| *walled) {
        return Vec::new();
    }
    // A door stands in a gap of the wall that is as wide as it is.
    let wall = 2.0 * world.options.eta + world.options.tolerances.door;
    let gap = is_door.then(|| [own.half.x, own.half.z + wall]);
    let corners = prism.polygon.corners();
    let mut found = Vec::new();
    for (i, from) in corners.iter().enumerate() {
        for piece in left_of([*from, corners[(i + 1) % corners.len()]], own, gap) {
            if !is_near(piece, around, reach) {
                continue;
            }
            let Some(wall) = upright(piece, around) else { continue };
            let distance = around.distance(wall.aabb());
            if distance <= reach {
                found.push(Obstacle { met: Met::Wall(region), distance, solid: vec![wall].into() });
            }
        }
    }
    found
}

/// Whether a piece of outline may be as near to a box as `reach`, seen from above. Most walls of a room are not, and it costs more to
/// make a body of one.
fn is_near([a, b]: [Vec2; 2], around: &Aabb, reach: f64) -> bool {
    let apart = |axis: usize, at: usize| {
        let (lo, hi) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
        (lo - around.max[at]).max(around.min[at] - hi)
    };
    apart(0, 0).max(apart(1, 2)) <= reach + 1e-6
}

/// What is left of a piece of wall beside an opening of these half extents, along the width and depth of a door.
fn left_of([a, b]: [Vec2; 2], door: &Obb, gap: Option<[f64; 2]>) -> Vec<[Vec2; 2]> {
    let Some(half) = gap else { return vec![[a, b]] };
    let local = |p: Vec2| {
        let arm = Vec3::new(p.x - door.center.x, 0.0, p.y - door.center.z);
        [arm.dot(&door.axes.column(0)), arm.dot(&door.axes.column(2))]
    };
    let (from, to) = (local(a), local(b));
    // The share of the piece that is in the opening, side by side.
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let step = to[k] - from[k];
        if step.abs() < 1e-12 {
            if from[k].abs() >= half[k] {
                return vec![[a, b]];
            }
            continue;
        }
        let (s, t) = ((-half[k] - from[k]) / step, (half[k] - from[k]) / step);
        (enter, leave) = (enter.max(s.min(t)), leave.min(s.max(t)));
    }
    if enter >= leave {
        return vec![[a, b]];
    }
    let at = |share: f64| a + (b - a) * share;
    [[a, at(enter)], [at(leave), b]].into_iter().filter(|[p, q]| (q - p).norm() > 1e-6).collect()
}

/// A wall without thickness over a piece of outline, as high as what moves before it.
fn upright([a, b]: [Vec2; 2], around: &Aabb) -> Option<Convex> {
    let length = (b - a).norm();
    if length < 1e-9 {
        return None;
    }
    let along = Vec3::new(b.x - a.x, 0.0, b.y - a.y) / length;
    let middle = (a + b) / 2.0;
    let center = Vec3::new(middle.x, (around.min.y + around.max.y) / 2.0, middle.y);
    let half = Vec3::new(length / 2.0, (around.max.y - around.min.y) / 2.0 + 1.0, 0.0);
    Some(Convex::from_box(&Obb {
        center,
        axes: Matrix3::from_columns(&[along, Vec3::y(), along.cross(&Vec3::y())]),
        half,
    }))
}
