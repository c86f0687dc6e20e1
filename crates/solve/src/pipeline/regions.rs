//! Regions that the program leaves open: sized by what is to stand in them, placed beside each other.
//!
//! Rooms that share a door share a wall; all others keep their own walls apart, too: twice η between neighbours.

use crate::problem::pose::Pose;
use crate::problem::pose::round_to;
use crate::search::Search;
use crate::search::least_squares::{Targets, least_squares};
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::Hold;
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::{Aabb, Vec3};

/// Floor that furniture leaves free, as a multiple of what it covers.
const SPARE: f64 = 2.2;
/// Free floor in an empty room (square metres).
const BARE: f64 = 5.0;
/// Around the largest thing in a room (metres).
const ROOM: f64 = 1.2;
/// Usual height of a room (metres).
const HEIGHT: f64 = 2.7;

/// Sizes and places the regions that are open; `growth` makes them larger than usual. Those of `kept` stay.
pub(crate) fn arrange(search: &mut Search<'_>, growth: f64, kept: &dyn Fn(RegionId) -> bool) {
    let frame = search.state.frame;
    let all: Vec<RegionId> = (0..frame.program.regions.len() as u32).map(RegionId).collect();
    let mut changes = Vec::new();
    for &id in &all {
        let pins = frame.region_pins[id.0 as usize];
        if !pins.scale && !kept(id) {
            let size = size(&search.state, id, growth);
            let pose = search.state.region_pose(id);
            let outlined = search.state.world().region(id).is_ok_and(|r| r.outlined);
            let scale = if outlined { Vec3::new(pose.scale.x, size.y, pose.scale.z) } else { size };
            changes.push(Change::Region(id, Pose { scale, ..pose }));
        }
    }
    apply(&mut search.state, &changes);
    let mut placed: Vec<RegionId> = all.iter().copied().filter(|&id| is_fixed(&search.state, id) || kept(id)).collect();
    for &id in &all {
        if !placed.contains(&id) {
            let pose = best_place(search, id, &placed);
            apply(&mut search.state, &[Change::Region(id, pose)]);
            placed.push(id);
        }
    }
    search.state.measure_all();
    if search.state.total() > 0.0 {
        let targets = Targets {
            regions: all,
            variables: scenelang_engine::frame::variables(frame.program).collect(),
            ..Targets::default()
        };
        least_squares(&mut search.state, &targets);
    }
}

fn apply(state: &mut Candidate<'_>, changes: &[Change]) {
    if !changes.is_empty() && state.attempt(changes, f64::INFINITY).is_some() {
        state.keep();
    }
}

fn is_fixed(state: &Candidate<'_>, id: RegionId) -> bool {
    state.frame.region_pins[id.0 as usize].pos || state.world().region(id).is_ok_and(|r| r.outlined)
}

/// Objects that are to be in a region, as far as the program says; of a single region all.
fn content(state: &Candidate<'_>, id: RegionId) -> Vec<ObjectId> {
    let frame = state.frame;
    let only = frame.program.regions.len() == 1;
    frame.objects().filter(|o| only || frame.regions[o.0 as usize].contains(&id)).collect()
}

fn size(state: &Candidate<'_>, id: RegionId, growth: f64) -> Vec3 {
    let (mut covered, mut longest, mut tallest) = (0.0, 0.0f64, 0.0f64);
    for object in content(state, id) {
        let scale = state.pose(object).scale;
        tallest = tallest.max(scale.y);
        if state.frame.hold(object) == Hold::Rests {
            covered += scale.x * scale.z;
            longest = longest.max(scale.x.max(scale.z));
        }
    }
    let area = (BARE + covered * (1.0 + SPARE)) * growth;
    let width = (area * 1.25).sqrt().max(longest + ROOM);
    let depth = (area / width).max(longest + ROOM).min(width);
    Vec3::new(round_to(width, 0.1), round_to(HEIGHT.max(tallest + 0.3), 0.1), round_to(depth, 0.1))
}

fn outline(state: &Candidate<'_>, id: RegionId) -> Aabb {
    let prism = state.world().region(id).map(|r| &r.prism);
    Aabb::of(prism.into_iter().flat_map(|p| p.polygon.corners()).map(|c| Vec3::new(c.x, 0.0, c.y)))
}

/// Beside those that stand already: first those that it shares a door with.
fn best_place(search: &mut Search<'_>, id: RegionId, placed: &[RegionId]) -> Pose {
    let state = &mut search.state;
    let pose = state.region_pose(id);
    let apart = 2.0 * state.world().options.eta;
    let doors = &state.frame.program.allow.doors;
    let linked = |other: RegionId| {
        doors.iter().any(|d| (d.first == id && d.second == Some(other)) || (d.first == other && d.second == Some(id)))
    };
    let spans: Vec<(RegionId, Aabb)> = placed.iter().map(|&r| (r, outline(state, r))).collect();
    let half = pose.scale / 2.0;
    let mut best = (f64::INFINITY, Pose { pos: Vec3::zeros(), ..pose });
    let mut places: Vec<(f64, Vec3)> = Vec::new();
    for &(other, span) in &spans {
        let cost = if linked(other) { 0.0 } else { 1.0 };
        let middle = (span.min + span.max) / 2.0;
        let floor = state.region_pose(other).pos.y;
        for (i, sign) in [(0, 1.0), (2, 1.0), (0, -1.0), (2, -1.0)] {
            let (along, across) = (i, 2 - i);
            let edge = if sign > 0.0 { span.max[along] } else { span.min[along] };
            let flush = [middle[across], span.min[across] + half[across], span.max[across] - half[across]];
            for offset in flush {
                let mut pos = Vec3::new(0.0, floor, 0.0);
                pos[along] = edge + sign * (apart + half[along]);
                pos[across] = offset;
                places.push((cost, pos));
            }
        }
    }
    if places.is_empty() {
        places.push((0.0, Vec3::zeros()));
    }
    for (cost, pos) in places {
        let own = Aabb { min: pos - half, max: pos + half };
        let overlaps =
            |b: &Aabb| (0..3).step_by(2).all(|i| own.min[i] < b.max[i] - 1e-9 && b.min[i] < own.max[i] - 1e-9);
        let meets = spans.iter().filter(|(_, span)| overlaps(span)).count() as f64;
        let next = Pose { pos, ..pose };
        let Some(stated) = state.attempt(&[Change::Region(id, next)], f64::INFINITY) else { continue };
        state.undo();
        let total = cost + 10.0 * meets + 20.0 * stated + 1e-3 * pos.norm();
        if total < best.0 - 1e-12 {
            best = (total, next);
        }
    }
    best.1
}
