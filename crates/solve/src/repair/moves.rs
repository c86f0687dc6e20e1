//! Moves that repair: places for one object after the other, best first, with a way back.
//!
//! A node of the search is a layout with a few objects moved. What is missing in it points at objects; each is tried in
//! many places, and those that leave least missing become nodes in turn. So one displaced object is put back in one
//! step, several are taken care of one by one, and what stands in the way is moved aside.

use super::judge::Judge;
use super::room::{self, Equations, Fixtures, Room, describe};
use super::{Alternative, RepairOptions, least, pool, whole};
use crate::problem::pose::Pose;
use crate::search::state::{Change, overlap_in_plan};
use crate::search::{STEPS, Snapshot};
use scenelang_engine::smallest_move;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;
use std::collections::BTreeSet;

/// The part of the budget that the search for places may take.
const PART: f64 = 0.2;
/// Where so many objects have to move, it may be better to let those follow that depend on others.
const FEW: usize = 2;
/// So many objects that something missing points at are tried in a layout.
const BLAMED: usize = 6;
/// So many of the places found for an object are made exact.
const EXACT: usize = 6;
/// So many of these are gone on from.
const BRANCH: usize = 2;
/// More objects than this, beside one for everything missing at the start, are not moved one by one.
const DEPTH: usize = 3;
/// So many layouts are gone on from.
const NODES: usize = 40;
/// After so much work the first way found is enough.
const ENOUGH: u64 = 4_000_000;
/// What a metre counts beside what is missing.
const PULL: f64 = 0.02;
/// So many others that an object has to do with are looked at for rows.
const RELATED: usize = 5;
/// How far around the place of an object others are tried (metres).
const RING: [f64; 6] = [0.02, 0.06, 0.15, 0.35, 0.7, 1.2];

/// A layout on the way.
struct Node {
    snapshot: Snapshot,
    missing: usize,
    cost: f64,
    /// Objects that were chosen to be moved so far.
    chosen: Vec<ObjectId>,
}

/// What `check` offers for the same rows; `None`: that does not repair them all, or breaks a demand.
pub(super) fn first(judge: &Judge<'_>) -> Option<Alternative> {
    let repair = smallest_move(judge.program, judge.layout, &judge.options, &judge.verdict, &judge.targets)?;
    let mut layout = judge.layout.clone();
    for step in &repair.steps {
        let name = &judge.program.objects[step.object.0 as usize].name;
        let (_, placement) = layout.objects.iter_mut().find(|(n, _)| n == name)?;
        placement.pos += Vec3::from(step.by);
        if step.turn != 0.0 {
            placement.rot.y = (placement.rot.y + step.turn).rem_euclid(360.0);
        }
    }
    let broken = judge.judge(&layout)?;
    let mut alternative = describe(judge, layout, &broken);
    for moved in &mut alternative.moves {
        moved.with = repair.steps.iter().find(|s| s.object == moved.object).and_then(|s| s.with);
    }
    Some(alternative)
}

/// All that was found; the best first. With `careless`, preferences may break.
pub(super) fn all(judge: &Judge<'_>, options: &RepairOptions, careless: bool) -> Vec<Alternative> {
    let solver = room::solver(options);
    let part = (options.budget as f64 * PART) as u64;
    let free = Fixtures::new(judge, Equations::Judged);
    let mut room = Room::new(judge, &free, &solver, careless);
    let mut found: Vec<Alternative> = Vec::new();
    let solutions = search(&mut room, part);
    gather(&mut room, solutions, &mut found);
    if found.iter().all(|a| a.moves.len() > FEW) {
        let work = room.search.state.work;
        let bound = Fixtures::new(judge, Equations::Obeyed);
        let mut room = Room::new(judge, &bound, &solver, careless);
        room.search.state.work = work;
        let solutions = search(&mut room, work + part);
        gather(&mut room, solutions, &mut found);
        if found.is_empty() {
            let solutions = whole::search(&mut room, options);
            gather(&mut room, solutions, &mut found);
        }
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found.truncate(options.alternatives);
    found
}

/// Takes of each solution what is needed, and adds it to what was found if it repairs.
fn gather(room: &mut Room<'_, '_>, solutions: Vec<Snapshot>, found: &mut Vec<Alternative>) {
    for snapshot in solutions {
        room.search.restore(&snapshot);
        least::shrink(room);
        let Some(alternative) = room.alternative() else { continue };
        let objects = |a: &Alternative| a.moves.iter().map(|m| m.object).collect::<Vec<_>>();
        // Of moves of the same objects the smallest is enough.
        match found.iter_mut().find(|a| objects(a) == objects(&alternative)) {
            Some(known) if known.cost > alternative.cost => *known = alternative,
            Some(_) => {}
            None => found.push(alternative),
        }
    }
}

/// Layouts in which nothing is missing.
fn search(room: &mut Room<'_, '_>, budget: u64) -> Vec<Snapshot> {
    let start = room.start.clone();
    room.search.restore(&start);
    let missing = room.missing();
    if missing.is_empty() {
        return vec![start];
    }
    let depth = missing.len() + DEPTH;
    let mut open = vec![Node { snapshot: start, missing: missing.len(), cost: 0.0, chosen: Vec::new() }];
    let mut seen: BTreeSet<(usize, u64)> = BTreeSet::new();
    for _ in 0..NODES {
        let rank = |n: &Node| (n.missing + n.chosen.len(), n.cost);
        let Some(best) = (0..open.len()).min_by(|&i, &j| {
            let (a, b) = (rank(&open[i]), rank(&open[j]));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(i.cmp(&j))
        }) else {
            break;
        };
        let node = open.swap_remove(best);
        let children = expand(room, &node, budget);
        let (done, rest): (Vec<Node>, Vec<Node>) = children.into_iter().partition(|n| n.missing == 0);
        if !done.is_empty() {
            return done.into_iter().map(|n| n.snapshot).collect();
        }
        if room.search.state.work >= budget || room.search.is_late() {
            break;
        }
        // The same in another order is the same.
        open.extend(rest.into_iter().filter(|n| n.chosen.len() < depth && seen.insert((n.missing, n.cost.to_bits()))));
    }
    Vec::new()
}

/// The layouts one move away from a layout.
fn expand(room: &mut Room<'_, '_>, node: &Node, budget: u64) -> Vec<Node> {
    room.search.restore(&node.snapshot);
    let missing = room.missing();
    let mut blamed: Vec<(ObjectId, usize)> = Vec::new();
    for check in missing {
        // Who is in the way of free space or of a way is found by taking each away in turn, which is dear.
        let spent = room.search.state.work >= budget || room.search.is_late();
        let all = if spent { room.search.state.objects_of(check) } else { room.search.blamed(check) };
        for id in all.into_iter().filter(|id| room.search.state.frame.is_movable(*id)) {
            match blamed.iter_mut().find(|(o, _)| *o == id) {
                Some((_, times)) => *times += 1,
                None => blamed.push((id, 1)),
            }
        }
    }
    // What most of the trouble points at first; of two, what nobody has chosen yet, and what is smaller.
    let state = &room.search.state;
    let size = |id: ObjectId| state.pose(id).scale.iter().product::<f64>();
    blamed.sort_by(|(a, n), (b, m)| {
        let fresh = |id: &ObjectId| node.chosen.contains(id);
        m.cmp(n).then(fresh(a).cmp(&fresh(b))).then(size(*a).total_cmp(&size(*b))).then(a.cmp(b))
    });
    let mut children = Vec::new();
    for (id, _) in blamed.into_iter().take(BLAMED) {
        let work = room.search.state.work;
        let done = children.iter().any(|n: &Node| n.missing == 0);
        if room.search.is_late() || !children.is_empty() && work >= budget || done && work >= ENOUGH {
            break;
        }
        let mut chosen = node.chosen.clone();
        if !chosen.contains(&id) {
            chosen.push(id);
        }
        room.search.restore(&node.snapshot);
        let places = places(room, id);
        children.extend(places.into_iter().map(|(missing, cost, snapshot)| Node {
            snapshot,
            missing,
            cost,
            chosen: chosen.clone(),
        }));
    }
    children
}

/// Layouts with an object (and what stands on it) elsewhere; those that leave least missing first, then the nearest.
fn places(room: &mut Room<'_, '_>, id: ObjectId) -> Vec<(usize, f64, Snapshot)> {
    let from = room.search.snapshot();
    let now = room.search.state.pose(id);
    let mut ranked: Vec<(f64, Pose)> = vec![(f64::NEG_INFINITY, now)];
    for pose in candidates(room, id, &now) {
        let pull = PULL * room.travel(id, &pose);
        let limit = if ranked.len() <= EXACT { f64::INFINITY } else { ranked[EXACT].0 };
        let state = &mut room.search.state;
        let changes = state.with_riders(id, pose);
        let Some(cost) = state.attempt(&changes, limit - pull) else { continue };
        state.undo();
        let at = ranked.partition_point(|(c, _)| *c <= cost + pull);
        if ranked[at - 1].1 != pose {
            ranked.insert(at, (cost + pull, pose));
            ranked.truncate(EXACT + 1);
        }
    }
    let mut out: Vec<(usize, f64, Snapshot)> = Vec::new();
    for (_, pose) in ranked {
        room.search.restore(&from);
        let changes = room.search.state.with_riders(id, pose);
        if room.search.state.attempt(&changes, f64::INFINITY).is_none() {
            continue;
        }
        room.search.state.keep();
        if room.search.is_troubled(id) {
            room.search.polish(vec![id], STEPS[0]);
        }
        let snapshot = room.search.snapshot();
        if snapshot != from {
            out.push((room.cheaply_missing().len(), room.cost(), snapshot));
        }
    }
    let order = |a: &(usize, f64, Snapshot), b: &(usize, f64, Snapshot)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
    out.sort_by(order);
    out.truncate(if room.dear { 2 * BRANCH } else { BRANCH });
    if room.dear {
        // Ways over the floor are looked for only where nothing else is missing, and only until one place has them.
        for i in 0..out.len() {
            if out[i].0 == 0 {
                room.search.restore(&out[i].2);
                out[i].0 = room.missing().len();
                if out[i].0 == 0 {
                    out.truncate(i + 1);
                    break;
                }
            }
        }
        out.sort_by(order);
        out.truncate(BRANCH);
    }
    out
}

/// Places for an object: where the layout had it, around where it is, turned on the spot, lowered or raised onto what is
/// there, and all that the solver would try.
fn candidates(room: &mut Room<'_, '_>, id: ObjectId, now: &Pose) -> Vec<Pose> {
    let mut out = vec![room.poses[id.0 as usize]];
    let yaws = [0.0, 90.0, 180.0, 270.0].map(|yaw| now.facing(yaw));
    out.extend(yaws);
    let state = &room.search.state;
    // Where those would be in their places again that its rules have taken along.
    for owner in state.frame.followers[id.0 as usize].iter().map(|&r| state.frame.rules.list[r].owner) {
        let (here, there) = (state.pose(owner), room.poses[owner.0 as usize]);
        if owner != id && here != there {
            let back = now.pos + there.pos - here.pos;
            out.push(now.at(back.x, back.y, back.z).facing(now.rot.y + there.rot.y - here.rot.y));
        }
    }
    out.extend(in_line(room, id, now));
    let search = &mut room.search;
    let state = &search.state;
    let span = *state.span(id);
    let mut heights: Vec<f64> = state.world().prisms().map(|(_, prism)| prism.floor + now.depth_below()).collect();
    heights.push(now.pos.y);
    for other in state.placed().filter(|o| *o != id && overlap_in_plan(state.span(*o), &span)) {
        let top = state.span(other).max.y;
        let surface = state.world().object(other).ok().and_then(|t| t.body.surface.map(|s| t.body.pos.y + s));
        heights.extend(surface.into_iter().chain([top]).map(|h| h + now.depth_below()));
    }
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    for height in heights {
        out.push(now.at(now.pos.x, height, now.pos.z));
        for radius in RING {
            for (dx, dz) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
                let (dx, dz) = (radius * f64::from(dx), radius * f64::from(dz));
                out.push(now.at(now.pos.x + dx, height, now.pos.z + dz));
            }
        }
    }
    out.extend(pool::candidates(&mut search.state, id, &mut search.chance));
    out
}

/// Places in a row with two others that it has to do with: between them, and beyond one of them, turned as that one.
fn in_line(room: &Room<'_, '_>, id: ObjectId, now: &Pose) -> Vec<Pose> {
    let state = &room.search.state;
    let related = state.frame.related[id.0 as usize].iter().map(|(o, _)| *o).filter(|o| state.is_placed(*o));
    let poses: Vec<Pose> = related.take(RELATED).map(|o| state.pose(o)).collect();
    let mut out = Vec::new();
    for (i, a) in poses.iter().enumerate() {
        for (j, b) in poses.iter().enumerate().filter(|(j, _)| *j != i) {
            let (between, beyond) = ((a.pos + b.pos) / 2.0, a.pos * 2.0 - b.pos);
            for at in [between, beyond].into_iter().skip(usize::from(j < i)) {
                out.extend([0.0, 180.0].map(|turn| now.at(at.x, now.pos.y, at.z).facing(a.rot.y + turn)));
            }
        }
    }
    out
}

/// The changes that bring objects to poses.
pub(super) fn changes(to: &[(ObjectId, Pose)]) -> Vec<Change> {
    to.iter().map(|(id, pose)| Change::Object(*id, *pose)).collect()
}
