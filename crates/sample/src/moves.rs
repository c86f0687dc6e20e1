//! One move of the chain. Each is as likely as its way back, or is taken with the probability that makes up for it, so that
//! all layouts in which everything holds come to be equally likely.

use crate::dice::Dice;
use crate::places::Places;
use crate::tally::{KINDS, MoveKind, Tally};
use crate::ties::Ties;
use crate::walls::Walls;
use scenelang_engine::Pose;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::{Frame, Hold};
use scenelang_engine::pose::Ride;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;
use scenelang_layout::rotation;

/// The smallest step (metres) and the smallest turn (degrees).
const STEP: f64 = 1e-3;
const TURN: f64 = 0.01;

/// What does not change in a chain.
pub struct Mover {
    /// What the chain may move.
    pub movable: Vec<ObjectId>,
    /// Where things can be.
    pub places: Places,
    walls: Walls,
    ties: Ties,
}

impl Mover {
    /// Of a layout in which all holds; or of one in which nothing has a place yet, and nothing belongs together.
    pub fn new(state: &Candidate<'_>) -> Self {
        let frame = state.frame;
        let is_placed = frame.objects().all(|id| state.is_placed(id));
        Self {
            movable: frame.objects().filter(|id| frame.is_movable(*id)).collect(),
            places: Places::new(frame, state.world()),
            walls: Walls::new(state.world()),
            ties: if is_placed { Ties::new(state) } else { Ties::none(frame) },
        }
    }

    /// Tries a move, and takes it or not.
    pub fn step(&self, state: &mut Candidate<'_>, dice: &mut Dice, tally: &mut Tally) {
        if self.movable.is_empty() {
            return;
        }
        let (kind, ..) = KINDS[dice.pick(KINDS.iter().map(|(_, weight, _)| *weight))];
        let id = self.movable[dice.below(self.movable.len())];
        let changes = match kind {
            MoveKind::Swap => self.swap(state, id, dice),
            MoveKind::Pair => self.pair(state, id, dice),
            _ => self.ride(state, kind, id, dice),
        };
        let taken = changes.is_some_and(|changes| match state.attempt_holding(&changes) {
            Ok(()) => {
                state.keep();
                true
            }
            Err(check) => {
                tally.refused(state.frame, state.numbering, check);
                false
            }
        });
        tally.tried(kind, taken);
    }

    /// A thing goes elsewhere, and others with it as one piece.
    fn ride(&self, state: &Candidate<'_>, kind: MoveKind, id: ObjectId, dice: &mut Dice) -> Option<Vec<Change>> {
        let frame = state.frame;
        let group = self.ties.group(state, id, dice);
        let (old, fixed) = (state.pose(id), frame.fixed(id));
        let may_turn = !fixed.rot && group.iter().all(|member| turns(frame, *member));
        let mut odds = 1.0;
        let mut new = match kind {
            MoveKind::Step => self.aside(&old, dice),
            MoveKind::Turn if may_turn => old.facing(old.rot.y + dice.step(TURN, 180.0)),
            MoveKind::Quarter if may_turn => old.facing(old.rot.y + 90.0 * (1 + dice.below(3)) as f64),
            MoveKind::Place if is_free(frame, id) => {
                let turned = if may_turn { turned(old, dice) } else { old };
                let new = self.places.draw(state, id, &turned, &group, dice)?;
                let [back, there] = [&old, &new].map(|pose| self.places.density(state, id, pose, &group));
                odds = if there > 0.0 { back / there } else { 0.0 };
                new
            }
            MoveKind::Wall => self.walls.elsewhere(&old, may_turn, dice)?,
            MoveKind::Lift if floats(frame, id) => {
                let [low, high] = self.places.heights(&old)?;
                let y = if dice.below(2) == 0 { old.pos.y + dice.step(STEP, 1.0) } else { dice.between(low, high) };
                old.at(old.pos.x, y, old.pos.z)
            }
            _ => return None,
        };
        (0..3).filter(|&axis| fixed.pos[axis]).for_each(|axis| new.pos[axis] = old.pos[axis]);
        if odds < 1.0 && dice.unit() >= odds {
            return None;
        }
        let ride = Ride::new(&old, &new);
        let own = Change::Object(id, new);
        let others = group.iter().filter(|member| **member != id);
        Some(std::iter::once(own).chain(others.map(|m| Change::Object(*m, ride.apply(&state.pose(*m))))).collect())
    }

    /// A step of any size: anywhere, or along the thing's own sides, as what is at a wall has to go.
    fn aside(&self, old: &Pose, dice: &mut Dice) -> Pose {
        let way = match dice.below(4) {
            0 => old.right(),
            1 => old.front(),
            _ => {
                let angle = dice.between(0.0, 360.0);
                let (sin, cos) = rotation::sin_cos(angle);
                Vec3::new(sin, 0.0, cos)
            }
        };
        let far = dice.step(STEP, self.places.diameter());
        let to = old.pos + way * far;
        old.at(to.x, old.pos.y, to.z)
    }

    /// Two things change places, each with what stands on it.
    fn swap(&self, state: &Candidate<'_>, id: ObjectId, dice: &mut Dice) -> Option<Vec<Change>> {
        let frame = state.frame;
        let other = self.movable[dice.below(self.movable.len())];
        let alike = other != id
            && frame.hold(id) == frame.hold(other)
            && [id, other].iter().all(|o| {
                let fixed = frame.fixed(*o);
                fixed.pos == [false; 3] && !fixed.rot
            });
        if !alike {
            return None;
        }
        let [a, b] = [id, other].map(|o| state.pose(o));
        let mut changes = Vec::new();
        for (own, (from, to)) in [(id, (a, b)), (other, (b, a))] {
            let riders = state.riders(own);
            if riders.contains(&id) || riders.contains(&other) {
                return None;
            }
            let new = Pose { scale: from.scale, ..to };
            if !riders.iter().all(|rider| turns(frame, *rider)) {
                return None;
            }
            let ride = Ride::new(&from, &new);
            changes.push(Change::Object(own, new));
            changes.extend(riders.into_iter().map(|r| Change::Object(r, ride.apply(&state.pose(r)))));
        }
        Some(changes)
    }

    /// Two things go anywhere at once.
    fn pair(&self, state: &Candidate<'_>, id: ObjectId, dice: &mut Dice) -> Option<Vec<Change>> {
        let frame = state.frame;
        let other = self.movable[dice.below(self.movable.len())];
        let both = [id, other];
        if id == other || !both.iter().all(|o| is_free(frame, *o)) {
            return None;
        }
        let (mut odds, mut changes) = (1.0, Vec::new());
        for own in both {
            let old = state.pose(own);
            let may_turn = !frame.fixed(own).rot;
            let new = self.places.draw(state, own, &if may_turn { turned(old, dice) } else { old }, &both, dice)?;
            let [back, there] = [&old, &new].map(|pose| self.places.density(state, own, pose, &both));
            odds *= if there > 0.0 { back / there } else { 0.0 };
            changes.push(Change::Object(own, new));
        }
        (odds >= 1.0 || dice.unit() < odds).then_some(changes)
    }
}

/// As it is, turned by quarters, or turned anyhow.
fn turned(pose: Pose, dice: &mut Dice) -> Pose {
    match dice.below(3) {
        0 => pose,
        1 => pose.facing(pose.rot.y + 90.0 * dice.below(4) as f64),
        _ => pose.facing(dice.between(0.0, 360.0)),
    }
}

/// Whether it can be put anywhere on a floor or on something else.
pub fn is_free(frame: &Frame<'_>, id: ObjectId) -> bool {
    let fixed = frame.fixed(id).pos;
    !fixed[0] && !fixed[2] && !matches!(frame.hold(id), Hold::Wall(_) | Hold::Door(..))
}

/// Whether its height is its own.
fn floats(frame: &Frame<'_>, id: ObjectId) -> bool {
    !frame.fixed(id).pos[1] && matches!(frame.hold(id), Hold::Floats | Hold::Wall(_) | Hold::Door(..))
}

/// Whether it can be turned with others. Where a rule sets one of its coordinates on the floor and not the other, a turn
/// would not be as likely as its way back.
fn turns(frame: &Frame<'_>, id: ObjectId) -> bool {
    let fixed = frame.fixed(id).pos;
    fixed[0] == fixed[2]
}
