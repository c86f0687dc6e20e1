//! What a path of some width needs of the rooms and the doors that it leads through, in proofs.
//!
//! A disc moves in the union of the regions and of the openings of doors. So any line across the disc lies in that union:
//! in a room that is too narrow for it there is a door in a wall at its side, and between two rooms it is in an opening.

use crate::number::Algebra;
use crate::prove::tape::{Claim, Term, all, any, implies};
use crate::prove::unknowns::Unknowns;
use scenelang_lang::program::{ObjectId, RegionId};

/// By how much a path may be narrower than it is asked to be, and then some (metres).
const SLACK: f64 = 3e-3;
/// How far from an object a path may end (metres), and then some.
const NEAR: f64 = 0.06;
/// What rounding of places may cost (metres).
const ROUNDING: f64 = 1e-5;
/// What stands in the way reaches into this space above the floor (metres).
const STEP: f64 = 0.05;
const HEAD: f64 = 2.0;
/// A component of an axis that is off 0 or 1 by less is along an axis of the world.
const TURNED: f64 = 1e-9;
/// With more regions or doors nothing is said: there would be a case for each of them.
const MOST_REGIONS: usize = 4;
const MOST_DOORS: usize = 6;

/// An opening: its middle, how far it reaches along x and z, and the longest line in it.
struct Opening {
    at: [Term; 2],
    reach: [Term; 2],
    longest: Term,
}

/// A rectangle along x and z.
struct Floor {
    at: [Term; 2],
    half: [Term; 2],
}

/// Claims that hold wherever a disc of this width can move from one object to the other.
pub(super) fn needed(facts: &mut Unknowns<'_>, ends: [ObjectId; 2], width: Term) -> Vec<Claim> {
    let regions = facts.regions();
    if regions.is_empty() || !regions.iter().all(|r| facts.is_rectangle(*r)) {
        return Vec::new();
    }
    let doors: Vec<ObjectId> = facts.world.allow.doors.iter().map(|door| door.object).collect();
    if let ([region], true) = (regions.as_slice(), doors.is_empty()) {
        // The disc is in one region, which is at least as wide and as long.
        let size = facts.room(*region).scale;
        return [0, 2].iter().map(|i| (size.0[*i] - width).at_least(-SLACK)).collect();
    }
    let straight = regions.iter().all(|r| facts.is_straight(*r));
    if !straight || regions.len() > MOST_REGIONS || doors.len() > MOST_DOORS {
        return Vec::new();
    }
    // Of a door that is not spoken of nothing is known, not even where it is.
    let Some(openings) = doors.iter().map(|d| opening(facts, *d)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let floors: Vec<Floor> = regions.iter().map(|r| floor(facts, *r)).collect();
    match floors.as_slice() {
        [floor] => within(floor, &openings, width),
        _ => across(facts, ends, &floors, &openings, width),
    }
}

fn opening(facts: &Unknowns<'_>, door: ObjectId) -> Option<Opening> {
    let mut long = facts.thing_spoken_of(door)?;
    let deeper = 2.0 * (2.0 * facts.options.eta + facts.options.tolerances.door);
    long.scale.0[2] = long.scale.0[2] + Term::constant(deeper);
    let (center, reach, scale) = (long.center(), long.reach(), long.scale.0);
    // Of one that is tilted the footprint is no longer than its three sides together.
    let is_upright = long.axes.0[1].0[1].known() == Some(1.0);
    let flat = (scale[0] * scale[0] + scale[2] * scale[2]).sqrt();
    let longest = if is_upright { flat } else { scale[0] + scale[1] + scale[2] };
    Some(Opening { at: [center.0[0], center.0[2]], reach: [reach.0[0], reach.0[2]], longest })
}

fn floor(facts: &Unknowns<'_>, region: RegionId) -> Floor {
    let room = facts.room(region);
    Floor { at: [0, 2].map(|i| room.pos.0[i]), half: [0, 2].map(|i| room.scale.0[i].scale(0.5)) }
}

/// Claims that hold wherever a disc of this width can move from one object to the other and a third one is not one of them: in
/// the only room, if they are on different sides of that, the disc passes it on the one side or on the other.
pub(crate) fn past(facts: &Unknowns<'_>, ends: [ObjectId; 2], width: Term, other: ObjectId) -> Vec<Claim> {
    let [region] = facts.regions()[..] else { return Vec::new() };
    let doors: Vec<ObjectId> = facts.world.allow.doors.iter().map(|door| door.object).collect();
    if !facts.is_rectangle(region) || !facts.is_straight(region) || doors.contains(&other) || doors.len() > MOST_DOORS {
        return Vec::new();
    }
    let Some(openings) = doors.iter().map(|d| opening(facts, *d)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let (thing, room, height) = (facts.thing(other), floor(facts, region), facts.room(region).pos.0[1]);
    if thing.axes.0[1].0[1].known() != Some(1.0) {
        return Vec::new();
    }
    let (center, reach) = (thing.center(), thing.reach());
    // A line through its middle is at least so long on both sides within it, however it is turned.
    let is_along =
        thing.axes.0[0].0.iter().all(|c| c.known().is_some_and(|c| c.abs() < TURNED || c.abs() > 1.0 - TURNED));
    let least = thing.scale.0[0].min(thing.scale.0[2]).scale(0.5);
    let half = [0, 2].map(|i| if is_along { reach.0[i] } else { least });
    let at = [0, 2].map(|i| center.0[i]);
    let [bottom, top] = [center.0[1] - reach.0[1], center.0[1] + reach.0[1]];
    let mut stands = vec![
        (height + Term::constant(HEAD) - bottom).at_least(ROUNDING),
        (top - height - Term::constant(STEP)).at_least(ROUNDING),
    ];
    stands.extend([0, 1].map(|k| (room.half[k] - (at[k] - room.at[k]).abs()).at_least(ROUNDING)));
    let ends = ends.map(|end| {
        let thing = facts.thing(end);
        (thing.center(), thing.reach())
    });
    let off = width.scale(0.5) + Term::constant(NEAR);
    let follow = |axis: usize| {
        let (line, k, i) = (at[axis], 1 - axis, 2 * axis);
        let between = any(&[[0, 1], [1, 0]].map(|[p, q]| {
            let ((from, at_from), (to, at_to)) = (ends[p], ends[q]);
            all(&[
                (line - from.0[i] - at_from.0[i] - off).at_least(ROUNDING),
                (to.0[i] - at_to.0[i] - line - off).at_least(ROUNDING),
            ])
        }));
        let mut ways: Vec<Claim> = [1.0, -1.0]
            .map(|side| (room.half[k] - (at[k] - room.at[k]).scale(side) - half[k] - width).at_least(-SLACK))
            .to_vec();
        ways.extend(openings.iter().map(|o| (o.reach[axis] - (o.at[axis] - line).abs()).at_least(-ROUNDING)));
        let premises: Vec<Claim> = stands.iter().copied().chain([between]).collect();
        implies(all(&premises), any(&ways))
    };
    [0, 1].map(follow).into_iter().filter(|claim| *claim != Claim::TRUE).collect()
}

/// In the only room. If that is narrower than the disc, one end of the line across it is in an opening that reaches out of
/// the room on that side, and the disc is no farther towards the other walls than openings there reach out.
fn within(floor: &Floor, openings: &[Opening], width: Term) -> Vec<Claim> {
    let half = width.scale(0.5);
    let beyond = |i: usize| {
        let out = openings.iter().map(|o| (o.at[i] - floor.at[i]).abs() + o.reach[i] - floor.half[i]);
        out.fold(Term::constant(0.0), Term::max)
    };
    [0, 1]
        .map(|i| {
            let k = 1 - i;
            let inwards = floor.half[k] + beyond(k) - half;
            let mut ways = vec![(floor.half[i].scale(2.0) - width).at_least(-SLACK)];
            for o in openings {
                let sideways = (o.at[i] - floor.at[i]).abs() + o.reach[i] - half;
                let reaches = inwards - (o.at[k] - floor.at[k]).abs() + o.reach[k];
                ways.push(all(&[sideways.at_least(-SLACK), reaches.at_least(-SLACK)]));
            }
            any(&ways)
        })
        .to_vec()
}

/// Between rooms. Where a line along an axis meets no region and the path leads from one side of it to the other, the disc
/// is on it at some time: then the line across it is in one opening, unless two of them meet there.
fn across(
    facts: &Unknowns<'_>,
    ends: [ObjectId; 2],
    floors: &[Floor],
    openings: &[Opening],
    width: Term,
) -> Vec<Claim> {
    let ends = ends.map(|end| {
        let thing = facts.thing(end);
        (thing.center(), thing.reach())
    });
    let off = width.scale(0.5) + Term::constant(NEAR);
    let mut follow = Vec::new();
    for (n, a) in floors.iter().enumerate() {
        for (b, axis) in floors[n + 1..].iter().flat_map(|b| [(b, 0), (b, 1)]) {
            // Between the middles of the two, in the middle of what is between their walls.
            for (low, high) in [(a, b), (b, a)] {
                let line = (low.at[axis] + low.half[axis] + high.at[axis] - high.half[axis]).scale(0.5);
                let mut apart: Vec<Claim> =
                    floors.iter().map(|f| ((f.at[axis] - line).abs() - f.half[axis]).at_least(ROUNDING)).collect();
                if apart.contains(&Claim::FALSE) {
                    continue;
                }
                apart.push(any(&[[0, 1], [1, 0]].map(|[p, q]| {
                    let ((from, at_from), (to, at_to)) = (ends[p], ends[q]);
                    let i = 2 * axis;
                    all(&[
                        (line - from.0[i] - at_from.0[i] - off).at_least(ROUNDING),
                        (to.0[i] - at_to.0[i] - line - off).at_least(ROUNDING),
                    ])
                })));
                let meets: Vec<Claim> =
                    openings.iter().map(|o| (o.reach[axis] - (o.at[axis] - line).abs()).at_least(-ROUNDING)).collect();
                let mut ways: Vec<Claim> = std::iter::zip(openings, &meets)
                    .map(|(o, meets)| all(&[*meets, (o.longest - width).at_least(-SLACK)]))
                    .collect();
                for (k, one) in meets.iter().enumerate() {
                    ways.extend(meets[..k].iter().map(|other| all(&[*one, *other])));
                }
                follow.push(implies(all(&apart), any(&ways)));
            }
        }
    }
    follow.retain(|claim| *claim != Claim::TRUE);
    follow
}
