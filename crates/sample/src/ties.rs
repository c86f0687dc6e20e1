//! Which things belong together: those that cannot stay behind when one of them goes elsewhere. A chain that moves them one
//! by one would need steps as small as the room that constraints leave between them; moved as one piece they keep what they
//! are to each other.

use crate::dice::Dice;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::{Frame, Hold};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;
use scenelang_verify::judge;

/// How far a thing is moved away to see whether another misses it (metres).
const AWAY: f64 = 1.5;
/// So many others are asked of each thing.
const ASKED: usize = 16;

/// By object, those that it belongs to.
pub struct Ties(Vec<Vec<ObjectId>>);

impl Ties {
    /// As they show in a layout in which all holds: two belong together if a statement about both fails whichever way one
    /// of them is moved.
    pub fn new(state: &Candidate<'_>) -> Self {
        let frame = state.frame;
        let mut ties = vec![Vec::new(); frame.program.objects.len()];
        for id in frame.objects() {
            let related = frame.related[id.0 as usize].iter().take(ASKED).map(|(other, _)| *other);
            let held = match frame.hold(id) {
                Hold::Container(container) => Some(container),
                _ => state.seats[id.0 as usize],
            };
            for other in related
                .filter(|other| frame.is_movable(*other))
                .filter(|other| held == Some(*other) || misses(state, id, *other))
            {
                for (a, b) in [(id, other), (other, id)] {
                    if !ties[a.0 as usize].contains(&b) {
                        ties[a.0 as usize].push(b);
                    }
                }
            }
        }
        ties.iter_mut().for_each(|of| of.sort_unstable());
        Self(ties)
    }

    /// None, where there is no layout yet to see them in.
    pub fn none(frame: &Frame<'_>) -> Self {
        Self(vec![Vec::new(); frame.program.objects.len()])
    }

    /// Some that move along with a thing: none, all, or some of its next ones; and what stands on them. The choice does not
    /// depend on where things are, but for what stands on what, which moving as one piece does not change.
    pub fn group(&self, state: &Candidate<'_>, id: ObjectId, dice: &mut Dice) -> Vec<ObjectId> {
        let mut group = vec![id];
        let way = dice.unit();
        if way >= 0.6 {
            let mut next = 0;
            while next < group.len() {
                for other in &self.0[group[next].0 as usize] {
                    if !group.contains(other) {
                        group.push(*other);
                    }
                }
                next += 1;
            }
        } else if way >= 0.4 {
            group.extend(self.0[id.0 as usize].iter().filter(|_| dice.below(2) == 0));
        }
        for at in 0..group.len() {
            for rider in state.riders(group[at]) {
                if !group.contains(&rider) {
                    group.push(rider);
                }
            }
        }
        group
    }
}

/// Whether a statement about two things fails whichever way the one is moved.
fn misses(state: &Candidate<'_>, id: ObjectId, other: ObjectId) -> bool {
    let frame = state.frame;
    let terms = frame.index.of_object(id).iter().map(|&t| &frame.terms[t]);
    let both: Vec<_> = terms.filter(|t| t.is_hard() && !t.walks && !t.sees_all && t.objects.contains(&other)).collect();
    if both.is_empty() {
        return false;
    }
    let mut world = state.world().clone();
    [Vec3::x(), -Vec3::x(), Vec3::z(), -Vec3::z()].iter().all(|way| {
        let mut pose = state.pose(id);
        pose.pos += way * AWAY;
        let [pos, rot, scale] = pose.constant();
        world.place(id, pos, rot, scale);
        both.iter().any(|term| !judge(&term.formula, &world).is_ok_and(|truth| truth.holds))
    })
}
