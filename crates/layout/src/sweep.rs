//! Parts in motion: the least gap between what turns or slides and what stands around, over the whole motion.
//!
//! The gap of two bodies changes no faster than the points of the one that moves. So what was measured at one pose says
//! something of all poses near it, and a look at few poses bounds the gap over an interval of them: an interval that cannot
//! hold less than the least gap found is left alone, every other one is halved. A direction that separates the bodies in
//! the middle of an interval mostly separates them in all of it, and then bounds the gap exactly. Nothing is sampled and
//! hoped for: what is said of a motion holds at each of its poses.

use crate::convex::{Convex, separation};
use crate::separation::{Aabb, Separation};
use crate::{Joint, Motion, Obb, Vec3, obb};
use nalgebra::{Matrix3, Rotation3, Unit};
use std::f64::consts::{PI, TAU};

/// The least gap of a motion is known to this (metres) where it decides: what is said of it is less than it is by no more.
pub const RESOLUTION: f64 = 5e-4;
/// Where it decides nothing, since there is plenty of room or much too little, it is known to this share of itself.
pub const SHARE: f64 = 1.0 / 32.0;
/// The free range is known to this, in metres that the fastest point goes.
const STEP: f64 = 5e-4;

/// What turns or slides, in the world, at its closed pose.
#[derive(Clone, Debug)]
pub struct Moving {
    bodies: Vec<Convex>,
    motion: Motion,
    axis: Unit<Vec3>,
    anchor: Vec3,
    /// By body: how fast its fastest point is (metres per radian, or 1).
    speeds: Vec<f64>,
}

/// The least gap over a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swept {
    /// No more than the least gap, and less by at most [`RESOLUTION`] or a 32nd of it, whichever is more, unless the looks
    /// were not enough (metres).
    pub gap: f64,
    /// An amount at which the gap is nearly that (degrees or metres).
    pub at: f64,
    /// The separation there, from the part that moves to the other.
    pub separation: Separation,
    /// Which body of what moves, and which of the obstacles.
    pub parts: [usize; 2],
}

/// What is known of the gap in an interval of a motion.
struct Look {
    least: f64,
    separation: Separation,
}

impl Moving {
    /// What a joint of an object moves: `bodies` are its parts in the object's frame, which stands at `pos`, turned by `axes`.
    pub fn new<'b>(joint: &Joint, bodies: impl Iterator<Item = &'b Convex>, axes: &Matrix3<f64>, pos: &Vec3) -> Self {
        let axis = Unit::new_normalize(axes * joint.axis);
        let anchor = axes * joint.anchor + pos;
        let bodies: Vec<Convex> = bodies.map(|body| body.moved(axes, pos)).collect();
        let radius = |v: &Vec3| (v - anchor).cross(&axis).norm();
        let speed = |body: &Convex| match joint.motion {
            Motion::Slide => 1.0,
            Motion::Hinge => body.vertices().iter().map(radius).fold(0.0, f64::max),
        };
        let speeds = bodies.iter().map(speed).collect();
        Self { bodies, motion: joint.motion, axis, anchor, speeds }
    }

    /// Its bodies, closed.
    pub fn bodies(&self) -> &[Convex] {
        &self.bodies
    }

    /// Its bodies, opened by so much (degrees or metres).
    pub fn opened(&self, amount: f64) -> Vec<Convex> {
        let (turn, by) = self.pose(self.inner(amount));
        self.bodies.iter().map(|body| body.moved(&turn, &by)).collect()
    }

    /// The upright box around all of the motion.
    pub fn around(&self, amount: f64) -> Aabb {
        let to = self.inner(amount);
        let reach = |axis: Vec3| {
            let highest =
                |way: Vec3| self.bodies.iter().map(|b| self.highest(b, &way, [0.0, to])).fold(-1e300, f64::max);
            [-highest(-axis), highest(axis)]
        };
        let ([x, x2], [y, y2], [z, z2]) = (reach(Vec3::x()), reach(Vec3::y()), reach(Vec3::z()));
        Aabb { min: Vec3::new(x, y, z), max: Vec3::new(x2, y2, z2) }
    }

    /// The least gap to obstacles while it is opened by so much (degrees or metres); `None` where that cannot be less than
    /// `below`, or there are no obstacles. Each look at a pose takes one of `looks`; without any left the bounds are as good
    /// as they are by then.
    pub fn least(&self, obstacles: &[Convex], amount: f64, below: f64, looks: &mut usize) -> Option<Swept> {
        self.least_about(obstacles, amount, below, SHARE, looks)
    }

    /// The same, known to another share of itself than [`SHARE`].
    pub fn least_about(
        &self,
        obstacles: &[Convex],
        amount: f64,
        below: f64,
        share: f64,
        looks: &mut usize,
    ) -> Option<Swept> {
        let to = self.inner(amount);
        let mut best: Option<Swept> = None;
        // No gap is less than this.
        let mut bound = f64::INFINITY;
        for (i, body) in self.bodies.iter().enumerate() {
            let around = self.around_of(body, to);
            for (j, obstacle) in obstacles.iter().enumerate() {
                let most = best.map_or(below, |swept| swept.separation.gap.min(below));
                if around.distance(obstacle.aabb()) > most.max(0.0) {
                    continue;
                }
                let mut open = vec![[0.0, 0.0], [to, to], [0.0, to]];
                open.swap(0, 2);
                while let Some([from, until]) = open.pop() {
                    let middle = (from + until) / 2.0;
                    let look = self.look(i, obstacle, [from, until], looks);
                    if best.is_none_or(|swept| look.separation.gap < swept.separation.gap) {
                        let at = self.outer(middle);
                        best = Some(Swept { gap: 0.0, at, separation: look.separation, parts: [i, j] });
                    }
                    let most = best.map_or(below, |swept| swept.separation.gap.min(below));
                    if look.least >= most - RESOLUTION.max(share * most.abs()) || *looks == 0 {
                        bound = bound.min(look.least);
                    } else {
                        open.extend([[middle, until], [from, middle]]);
                    }
                }
            }
        }
        let swept = best?;
        (swept.separation.gap.min(bound) < below).then_some(Swept { gap: swept.separation.gap.min(bound), ..swept })
    }

    /// How far it can be opened, `amount` at most, with no gap less than `least` on the way (degrees or metres); and the
    /// obstacle that ends it, if one does. Never more than it can, and less by at most half a millimetre at its fastest point.
    pub fn free(&self, obstacles: &[Convex], amount: f64, least: f64, looks: &mut usize) -> (f64, Option<usize>) {
        let mut to = self.inner(amount);
        let mut blocker = None;
        for (i, body) in self.bodies.iter().enumerate() {
            for (j, obstacle) in obstacles.iter().enumerate() {
                if self.around_of(body, to).distance(obstacle.aabb()) >= least.max(0.0) + RESOLUTION {
                    continue;
                }
                let reached = self.advance(i, obstacle, to, least, looks);
                if reached < to {
                    (to, blocker) = (reached, Some(j));
                }
            }
        }
        // What nothing ends is the amount itself: to radians and back would round it.
        (if blocker.is_some() { self.outer(to) } else { amount }, blocker)
    }

    /// How far one body comes past one obstacle.
    fn advance(&self, body: usize, obstacle: &Convex, to: f64, least: f64, looks: &mut usize) -> f64 {
        let smallest = STEP / self.speeds[body].max(1e-9);
        let (mut from, mut step) = (0.0, to);
        while from < to {
            let until = (from + step).min(to);
            if self.look(body, obstacle, [from, until], looks).least >= least {
                (from, step) = (until, 2.0 * step);
            } else if step <= smallest || *looks == 0 {
                return from;
            } else {
                step /= 2.0;
            }
        }
        to
    }

    /// What the pose in the middle of an interval says of the gap in all of it.
    fn look(&self, body: usize, obstacle: &Convex, interval: [f64; 2], looks: &mut usize) -> Look {
        *looks = looks.saturating_sub(1);
        let own = &self.bodies[body];
        let (turn, by) = self.pose((interval[0] + interval[1]) / 2.0);
        let found = match (own.as_box(), obstacle.as_box()) {
            (Some(a), Some(b)) => {
                let there = Obb { center: turn * a.center + by, axes: turn * a.axes, half: a.half };
                obb::separation(&there, b)
            }
            _ => separation(&own.moved(&turn, &by), obstacle),
        };
        let far = self.speeds[body] * (interval[1] - interval[0]) / 2.0;
        let along = -obstacle.support_height(&-found.normal) - self.highest(own, &found.normal, interval);
        Look { least: (found.gap - far).max(along).min(found.gap), separation: found }
    }

    /// The greatest height along a direction that a body has anywhere in an interval.
    fn highest(&self, body: &Convex, way: &Vec3, [from, until]: [f64; 2]) -> f64 {
        let heights = body.vertices().iter().map(|v| match self.motion {
            Motion::Slide => v.dot(way) + self.axis.dot(way) * if self.axis.dot(way) < 0.0 { from } else { until },
            Motion::Hinge => {
                let arm = v - self.anchor;
                let along = self.axis.scale(self.axis.dot(&arm));
                let level = (self.anchor + along).dot(way);
                let (cosine, sine) = ((arm - along).dot(way), self.axis.cross(&arm).dot(way));
                level + crest(cosine, sine, from, until)
            }
        });
        heights.fold(f64::NEG_INFINITY, f64::max)
    }

    fn around_of(&self, body: &Convex, to: f64) -> Aabb {
        let highest = |way: Vec3| self.highest(body, &way, [0.0, to]);
        let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
        Aabb { min: Vec3::from(axes.map(|axis| -highest(-axis))), max: Vec3::from(axes.map(highest)) }
    }

    /// The rotation about the origin and the translation after it that open it by so much (radians or metres).
    fn pose(&self, amount: f64) -> (Matrix3<f64>, Vec3) {
        match self.motion {
            Motion::Slide => (Matrix3::identity(), self.axis.scale(amount)),
            Motion::Hinge => {
                let turn = *Rotation3::from_axis_angle(&self.axis, amount).matrix();
                (turn, self.anchor - turn * self.anchor)
            }
        }
    }

    /// An amount in radians or metres.
    fn inner(&self, amount: f64) -> f64 {
        if self.motion == Motion::Hinge { amount.to_radians() } else { amount }
    }

    /// An amount in degrees or metres.
    fn outer(&self, amount: f64) -> f64 {
        if self.motion == Motion::Hinge { amount.to_degrees() } else { amount }
    }
}

/// The greatest value of a·cos t + b·sin t for t in an interval.
fn crest(a: f64, b: f64, from: f64, until: f64) -> f64 {
    let top = b.atan2(a);
    // The first top that is not before the interval.
    let turns = ((from - top) / TAU).ceil();
    if until - from >= TAU || top + turns * TAU <= until + 1e-12 * PI {
        return a.hypot(b);
    }
    let at = |t: f64| a * t.cos() + b * t.sin();
    at(from).max(at(until))
}
