//! Two beds that are asked for stand side by side, their heads at one wall, and what belongs to both between them:
//! what is said to stand there, else a nightstand.

use super::build::Root;
use super::floor::{Floor, Footprint, Pose, Shape};
use super::plan::{AtWall, Plan};
use super::slots::{Level, Slot};
use super::stand::{self, counts_as};
use super::{place, seek};
use crate::brief::Group;
use crate::draft::{Demand, ThingOrigin};
use crate::names::mentions;

/// Between two beds at least, and beside what stands there.
const BETWEEN: f64 = 0.6;
const BESIDE: f64 = 0.06;
/// What stands between two beds is no deeper and no wider.
const LARGEST: [f64; 2] = [1.4, 0.7];
/// Beds of this name are not like others.
const OTHER: [&str; 6] = ["hospital bed", "patient bed", "bunk bed", "loft bed", "dog bed", "flower bed"];
const USUAL: &str = "nightstand";
const WHY: &str = "two beds side by side share the nightstand between them";

/// So thin and so high at least is what divides two beds; beside it there is room for what belongs to the bed on its right,
/// and for that and a chair to its left (metres).
const DIVIDER: [f64; 2] = [0.2, 1.4];
const BESIDE_DIVIDER: [f64; 2] = [0.64, 1.06];
/// Beside a bed at least, where the two are said to be nearer to each other: a cabinet (metres).
const CABINET: f64 = 0.52;

/// Finds a place for a group, given those of the groups before it.
type Seek<'s> = dyn Fn(&Floor, &Shape, &[Pose]) -> Option<Pose> + 's;

/// Whether a thing is such a pair.
pub fn is_pair(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let noun = it.category.replace('_', " ");
    let said = plan.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
    let mut about = said.filter(|s| mentions(&s.text, &it.name));
    let goes_along = |text: &str| {
        let others =
            (0..plan.draft.things.len()).filter(|at| *at != thing && mentions(text, &plan.draft.things[*at].name));
        let mut others = others.peekable();
        others.peek().is_some() && others.all(|at| plan.goes_with(at, thing))
    };
    let only = about.all(|s| {
        among(plan, &s.text, &it.name).is_some()
            || said_gap(plan, &s.text, &it.name).is_some()
            || s.text.contains("inside(")
            || s.text.contains("onFloor(")
            || goes_along(&s.text)
    });
    let asked = |t: &crate::draft::DraftThing| {
        t.room == Some(plan.room) && t.count > 1 && counts_as(USUAL, &t.category.replace('_', " "))
    };
    it.count == 2
        && only
        && stand::group(&it.category) == Group::Bed
        && (!OTHER.iter().any(|other| noun.ends_with(other)) || divider(plan, &it.name).is_some())
        && (!plan.draft.things.iter().any(asked) || divider(plan, &it.name).is_some())
}

/// The thing that a statement says is between the two.
fn among(plan: &Plan, text: &str, pair: &str) -> Option<usize> {
    let code: String = text.split_whitespace().collect();
    plan.draft.things.iter().position(|thing| {
        let fits = thing.size.is_some_and(|[w, _, d]| w <= LARGEST[0] && d <= LARGEST[1]) || divides(thing);
        thing.count == 1
            && fits
            && [[0, 1], [1, 0]]
                .iter()
                .any(|[a, b]| code.contains(&format!("between({},{pair}[{a}],{pair}[{b}])", thing.name)))
    })
}

/// How far apart a statement says the two are, in metres, and whether they may be farther.
fn said_gap(plan: &Plan, text: &str, pair: &str) -> Option<(f64, bool)> {
    let alone = plan.draft.things.iter().all(|thing| thing.name == pair || !mentions(text, &thing.name));
    let code: String = text.split_whitespace().collect();
    let number = |from: &str| -> Option<f64> {
        let end = from.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(from.len());
        from[..end].parse().ok()
    };
    let least = code.split_once("far(").and_then(|(_, rest)| number(rest.splitn(3, ',').nth(2)?));
    let exact = code.strip_prefix("foralliin0..1:abs(gap(").and_then(|rest| number(rest.split_once(")-")?.1));
    let said = least.map(|v| (v, true)).or(exact.map(|v| (v, false)));
    said.filter(|_| alone)
}

/// Whether a thing is a curtain or a screen that can stand between two beds.
fn divides(thing: &crate::draft::DraftThing) -> bool {
    thing.size.is_some_and(|[_, h, d]| d <= DIVIDER[0] && h >= DIVIDER[1])
}

/// The curtain or screen that is said to be between the two.
fn divider(plan: &Plan, pair: &str) -> Option<usize> {
    let said = plan.draft.statements.iter().find_map(|s| among(plan, &s.text, pair));
    said.filter(|at| divides(&plan.draft.things[*at]))
}

/// Gives the pair a place, its first bed where `seek` finds one. Whether there is one.
pub fn stand_up(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([w, _, d]) = it.size else { return false };
    let said = plan.draft.statements.iter().find_map(|s| among(plan, &s.text, &it.name));
    let asked = said.or_else(|| {
        (0..plan.draft.things.len()).find(|at| {
            let other = &plan.draft.things[*at];
            other.room == Some(plan.room)
                && other.count == 1
                && counts_as(USUAL, &other.category.replace('_', " "))
                && !plan.claimed.contains(at)
                && !stand::placed(plan.draft, &other.name)
        })
    });
    let own = asked.and_then(|at| plan.draft.things[at].size).unwrap_or_else(|| Plan::size(USUAL));
    let has = asked.is_some() || !plan.is_closed(USUAL);
    let divided = asked.is_some_and(|at| divides(&plan.draft.things[at]));
    let gap = plan.draft.statements.iter().find_map(|s| said_gap(plan, &s.text, &it.name));
    let wide = |usual: f64| match gap {
        Some((v, true)) => usual.max(v + 0.01),
        Some((v, false)) => v,
        None => usual,
    };
    let (apart, middle) = if divided {
        let [left, right] = BESIDE_DIVIDER;
        let apart = wide(left + own[2] + right);
        let right = right.min(apart - CABINET - own[2]).max(BESIDE);
        (apart, Slot { x: w / 2.0 + right + own[2] / 2.0, z: 0.0, level: Level::Floor, yaw: 90.0 })
    } else {
        let apart = wide(BETWEEN.max(own[0] + 2.0 * BESIDE));
        (apart, Slot { x: (w + apart) / 2.0, z: (own[2] - d) / 2.0, level: Level::Floor, yaw: 0.0 })
    };
    let across = Slot { x: w + apart, z: 0.0, level: Level::Floor, yaw: 0.0 };
    let frame = |slot: &Slot| Pose { x: slot.x, z: slot.z, yaw: slot.yaw, ..Pose::default() };
    let shared = Footprint { thing: usize::MAX, at: frame(&middle), size: own, flat: false, tall: false };
    let with_both = |floor: &Floor, shape: &Shape, before: &[Pose]| {
        let mut whole = shape.clone();
        whole.pieces.extend(has.then_some(shared));
        seek(floor, &whole, before)
    };
    let frames = vec![Pose::default(), frame(&across)];
    let root = Root { n: 1, frames, wall: AtWall::Yes, free: Vec::new(), whole: false, seek: &with_both };
    if !plan.place_asked(thing, &root) {
        return false;
    }
    let [first, second] = [0, 1].map(|i| format!("{}[{i}]", it.name));
    plan.say(format!("assert {};", place::fixed(&second, &first, &across, 0.0, 0.0)), WHY);
    if has {
        share(plan, asked, &it.name, &middle);
    }
    true
}

/// Puts between the two what they share.
fn share(plan: &mut Plan, asked: Option<usize>, pair: &str, middle: &Slot) {
    let at = asked.unwrap_or_else(|| plan.add(USUAL, 1, Plan::size(USUAL), WHY));
    let (name, first) = (plan.draft.things[at].name.clone(), format!("{pair}[0]"));
    plan.say(format!("assert {};", place::fixed(&name, &first, middle, 0.0, 0.0)), WHY);
    plan.claimed.push(at);
    // Between beds is beside both: their middles are not at the head.
    let among = |text: &str| text.contains("between(") && mentions(text, &name);
    let wall = format!("againstWall({name}, ");
    let divided = divides(&plan.draft.things[at]);
    for statement in &mut plan.draft.statements {
        if matches!(statement.source, ThingOrigin::Stated(_)) && among(&statement.text) && !divided {
            statement.text = format!("beside({name}, {pair}[0]) and beside({name}, {pair}[1])");
        }
    }
    plan.draft.statements.retain(|s| !(s.demand == Demand::Prefer && s.text.contains(&wall)));
    if let Some(from) = plan.place_in_room(&first) {
        let pose = from.then(&Pose { x: middle.x, z: middle.z, yaw: middle.yaw, ..Pose::default() });
        plan.note_place(&name, &pose);
        let size = plan.draft.things[at].size.unwrap_or_default();
        let piece = Footprint { thing: at, at: Pose::default(), size, flat: false, tall: false };
        let shape = Shape { pieces: vec![piece], ..Shape::default() };
        plan.ground.iter_mut().for_each(|ground| ground.take(&shape, &pose));
    }
    plan.surround(at, AtWall::Yes, 1);
}

/// The best place of the pair at a wall: as near to its middle as it can be, heads not under a window.
pub fn at_wall(floor: &Floor, shape: &Shape, depth: f64, windows: &[seek::Wall]) -> Option<Pose> {
    let [left, right, ..] = seek::reach(shape);
    let places = seek::at_walls(floor.size, shape, depth).into_iter();
    seek::best(floor, shape, places, &|pose| {
        let wall = seek::Wall::behind(pose)?;
        let middle = pose.then(&Pose { x: (right - left) / 2.0, ..Pose::default() });
        let off = match wall {
            seek::Wall::Back => middle.x.abs(),
            seek::Wall::Front => middle.x.abs() + 1.0,
            seek::Wall::Left | seek::Wall::Right => middle.z.abs() + 0.2,
        };
        let dark = if windows.contains(&wall) { 1.2 } else { 0.0 };
        Some(off * 0.5 + dark + (1.6 - floor.away_from_door(pose)).max(0.0) * 0.3)
    })
}
