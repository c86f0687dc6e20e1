//! Which terms ask only whether something opens: nothing that stays away from what opens changes them.

use crate::frame::Frame;
use scenelang_lang::program::{Formula, ObjectId};
use scenelang_layout::{Aabb, Vec3};
use scenelang_verify::{Surroundings, World, surroundings};

/// What rests on a part goes along with it, and is no further from its object than this (metres): so is whatever decides
/// that it does.
const CARRIED: f64 = 0.5;
/// For rounding (metres).
const SPARE: f64 = 0.01;

/// An object that has to open, and how far from its position anything comes that has a say in whether it does.
struct Swing {
    owner: ObjectId,
    far: f64,
    scale: Vec3,
}

/// By term: what has to open; `None`: the term may depend on anything.
pub(super) struct Swings(Vec<Option<Vec<Swing>>>);

impl Swings {
    /// Of a program. Where it is asked how much room there is before what opens, things far away count.
    pub fn of(frame: &Frame<'_>, world: &World<f64>) -> Self {
        let clearance = world.options.detail.clearance;
        let of =
            |formula: &Formula| clearance.is_finite().then(|| swings(formula, world, clearance.max(0.0))).flatten();
        Self(frame.terms.iter().map(|term| of(&term.formula)).collect())
    }

    /// Whether moves of other objects than those that a term names, from and to these boxes, may change it.
    pub fn may_see(&self, term: usize, world: &World<f64>, swept: &[Aabb]) -> bool {
        let Some(swings) = &self.0[term] else { return true };
        swings.iter().any(|swing| {
            let Ok(thing) = world.object(swing.owner) else { return true };
            let (pos, scale) = (thing.pos.value(), thing.scale.value());
            let meets =
                |span: &Aabb| (0..3).all(|k| span.min[k] <= pos[k] + swing.far && pos[k] - swing.far <= span.max[k]);
            scale != swing.scale || swept.iter().any(meets)
        })
    }
}

fn swings(formula: &Formula, world: &World<f64>, clearance: f64) -> Option<Vec<Swing>> {
    let mut found = Vec::new();
    for node in &formula.nodes {
        match surroundings(formula, node) {
            Surroundings::Nothing => {}
            Surroundings::Swing { owner } => {
                let thing = world.object(owner).ok()?;
                let joints = std::iter::zip(thing.body.joints(), thing.body.moving_in_frame());
                let reach = joints.map(|(joint, moving)| {
                    let around = moving.around(joint.limits[1]);
                    around.min.abs().sup(&around.max.abs()).norm()
                });
                let far = reach.fold(0.0, f64::max) + clearance + CARRIED + SPARE;
                found.push(Swing { owner, far, scale: thing.scale.value() });
            }
            _ => return None,
        }
    }
    (!found.is_empty()).then_some(found)
}
