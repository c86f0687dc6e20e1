//! Things that do not stand upright: they lie, lean or are tipped, because the program or the layout says so.
//!
//! The yaw is the outermost of the three turns. So such a thing is here an upright one with another shape: each of its parts
//! is the box around it as it leans. Where that is more than the part, the physical rules are asked of the evaluator; so is
//! every formula that speaks of such a thing.
//!
//! How a thing leans is left as it is unless the program speaks of it; then it may change as the values of decision variables
//! do.

use super::{Inputs, TOUCHING, Trial, setup};
use crate::frame::Frame;
use crate::penalty;
use crate::pose::Pose;
use scenelang_lang::program::ObjectId;
use scenelang_verify::coded::{self, INPUTS};
use scenelang_verify::{Truth, World, rules};

/// What a physical rule takes that is asked of the evaluator.
const ASKED: u64 = 30;
/// How a thing that does not stand upright leans.
#[derive(Clone, Debug)]
pub(super) struct Lean {
    /// Its turns about x and about z (degrees).
    angles: [f64; 2],
    /// Whether these may change.
    is_free: bool,
    /// Whether boxes around its parts are more than these.
    is_oblique: bool,
    /// The box around it from the middle of its bottom face, in a frame that has its yaw only (metres).
    hull: [[f64; 3]; 2],
}

impl Lean {
    /// Its turns about x and about z (degrees).
    pub fn angles(&self) -> [f64; 2] {
        self.angles
    }
    /// The middle of the box on the floor.
    fn middle(&self) -> [f64; 2] {
        [0, 2].map(|k| (self.hull[0][k] + self.hull[1][k]) / 2.0)
    }
}

/// Things that lean: those that the layout has so, those that rules turn, and those of which the program says what no
/// upright thing does. With `all`, those of which it says anything.
pub(super) fn leaning(frame: &Frame<'_>, world: &World<f64>, all: bool) -> Vec<bool> {
    let leans = |id: ObjectId| {
        let upright = world.object(id).is_ok_and(|thing| Pose::of(thing).is_upright());
        let tilts = frame.tilts[id.0 as usize];
        !upright || tilts && (all || frame.fixed(id).rot || setup::upright_yaws(frame, world, id).is_empty())
    };
    frame.objects().map(leans).collect()
}

impl Trial<'_> {
    pub(super) fn does_lean(&self, id: ObjectId) -> bool {
        self.leans[id.0 as usize].is_some()
    }

    /// How a thing leans: its turns about x and z (degrees).
    pub fn angles(&self, i: usize) -> [f64; 2] {
        self.leans[i].as_ref().map_or([0.0; 2], |lean| lean.angles)
    }

    /// How far it reaches below its position.
    pub fn depth_below(&self, i: usize) -> f64 {
        self.leans[i].as_ref().map_or(0.0, |lean| -lean.hull[0][1])
    }

    /// Whether boxes are more than what it is made of.
    pub(super) fn is_oblique(&self, i: usize) -> bool {
        self.leans[i].as_ref().is_some_and(|lean| lean.is_oblique)
    }

    /// The middle of the box around a leaning thing, and half its width and depth.
    pub(super) fn lying(&self, i: usize, inputs: &Inputs) -> Option<([f64; 2], [f64; 2])> {
        let lean = self.leans[i].as_ref()?;
        let ([u, v], [x, _, z, _, sin, cos]) = (lean.middle(), *inputs);
        let half = [0, 2].map(|k| (lean.hull[1][k] - lean.hull[0][k]) / 2.0);
        Some(([x + u * cos + v * sin, z - u * sin + v * cos], half))
    }

    /// From where to where a leaning thing reaches upwards.
    pub(super) fn upwards(&self, i: usize, y: f64) -> Option<[f64; 2]> {
        self.leans[i].as_ref().map(|lean| [y + lean.hull[0][1], y + lean.hull[1][1]])
    }

    /// Makes things lean as an instance has them.
    pub(super) fn begin_to_lean(&mut self, leans: &[bool], world: &World<f64>) {
        for i in (0..self.count()).filter(|&i| leans[i]) {
            let id = ObjectId(i as u32);
            let Ok(thing) = world.object(id) else { continue };
            let rot = thing.rot.value();
            let is_free = self.frame.tilts[i] && !self.frame.fixed(id).rot;
            self.leans[i] = Some(Lean { angles: [0.0; 2], is_free, is_oblique: false, hull: [[0.0; 3]; 2] });
            self.lean(i, [rot.x, rot.z]);
        }
        if leans.contains(&true) {
            self.begin_to_follow();
        }
    }

    /// A thing leans so from now on, without a look at anything.
    pub(super) fn lean(&mut self, i: usize, angles: [f64; 2]) {
        let Ok(thing) = self.instance.world().object(ObjectId(i as u32)) else { return };
        let (hull, blocks) = coded::leaning(&thing.body, angles);
        let Some(lean) = &mut self.leans[i] else { return };
        lean.angles = angles;
        lean.hull = hull;
        lean.is_oblique = angles.iter().any(|angle| angle % 90.0 != 0.0);
        // Seen from its position it is as wide as twice its longer side.
        let wide = |k: usize| 2.0 * hull[0][k].abs().max(hull[1][k].abs());
        self.size[i] = [wide(0), hull[1][1], wide(2)];
        self.surface[i] = hull[1][1] - hull[0][1];
        self.feet[i] = setup::feet(&blocks, self.tolerances.support);
        self.blocks[i] = blocks;
    }

    /// Whether the program leaves it open how a thing leans.
    pub fn may_lean(&self, i: usize) -> bool {
        self.leans[i].as_ref().is_some_and(|lean| lean.is_free)
    }

    /// Begins a trial, or goes on with one: a thing leans otherwise where it is.
    pub fn go_lean(&mut self, i: usize, angles: [f64; 2]) {
        let old = self.angles(i);
        if self.leans[i].is_none() || old == angles {
            return;
        }
        self.leaned.push((i, old));
        // Its lowest point stays at its height.
        let below = self.depth_below(i);
        self.lean(i, angles);
        let mut inputs = self.inputs(i);
        if !self.frame.fixed(ObjectId(i as u32)).pos[1] {
            inputs[1] += self.depth_below(i) - below;
        }
        self.shift(i, inputs);
        for at in 0..self.followers[i].len() {
            let rule = self.followers[i][at];
            self.obey(rule, 0);
        }
    }

    pub(super) fn undo_leans(&mut self) {
        while let Some((i, angles)) = self.leaned.pop() {
            self.lean(i, angles);
        }
    }

    /// How everything leans that does, as inputs of the code are written.
    pub(super) fn all_angles(&self) -> impl Iterator<Item = Inputs> + '_ {
        (0..self.count()).filter(|&i| self.leans[i].is_some()).map(|i| {
            let mut inputs = [0.0; INPUTS];
            inputs[..2].copy_from_slice(&self.angles(i));
            inputs
        })
    }

    pub(super) fn put_angles(&mut self, all: &[Inputs]) {
        let leaning: Vec<usize> = (0..self.count()).filter(|&i| self.leans[i].is_some()).collect();
        for (i, angles) in std::iter::zip(leaning, all) {
            self.lean(i, [angles[0], angles[1]]);
        }
    }

    /// P-BOUNDS of a thing that is more or less than its boxes.
    pub(super) fn bounds_asked(&mut self, i: usize) -> (f64, bool) {
        let contact = self.tolerances.contact;
        self.ask(|world| rules::bounds::object(world, ObjectId(i as u32)).ok(), |_| contact)
    }

    /// P-SUPPORT of such a thing.
    pub(super) fn support_asked(&mut self, i: usize) -> (f64, bool) {
        let own = self.span[i];
        let over = |j: &usize| {
            let other = &self.span[*j];
            *j != i && [0, 2].iter().all(|&k| own.min[k] < other.max[k] && other.min[k] < own.max[k])
        };
        let under: Vec<ObjectId> = (0..self.count()).filter(over).map(|j| ObjectId(j as u32)).collect();
        // Resting has a tolerance of height, but none of balance: only the former is asked to be unused.
        let tolerance = self.tolerances.support;
        let unused = tolerance.min(self.tolerances.contact);
        let target = |holds: bool| if holds { unused } else { tolerance };
        self.work += ASKED * under.len() as u64;
        self.ask(|world| rules::support::among(world, ObjectId(i as u32), &under).ok(), target)
    }

    /// P-COLLIDE where one of two such things is one.
    pub(super) fn collision_asked(&mut self, i: usize, j: usize) -> (f64, bool) {
        let pair = [i, j].map(|k| ObjectId(k as u32));
        let target = self.tolerances.contact - TOUCHING;
        self.ask(|world| rules::collide::pair(world, pair[0], pair[1]).ok(), |_| target)
    }

    fn ask(&mut self, truth: impl Fn(&World<f64>) -> Option<Truth<f64>>, target: impl Fn(bool) -> f64) -> (f64, bool) {
        // Where nothing can be measured it is far from holding (metres).
        const FAR_OFF: f64 = -10.0;
        self.follow();
        self.work += ASKED;
        let Some(truth) = truth(self.instance.world()) else { return (0.0, true) };
        let margin = if truth.margin.is_finite() { truth.margin } else { FAR_OFF };
        (penalty::cost(truth.holds, target(truth.holds) - margin), truth.holds)
    }
}
