//! Relations between objects, by the published geometry and thresholds, on oriented boxes.
//!
//! Left and right are those of someone who stands before the front of the reference and looks at it: the reference's own
//! right is on the left.

use super::shape::{Shape, SideTest, ease};
use scenelang_layout::{Vec2, Vec3};

/// How distances fall off outside of their ranges (metres).
const DEVIATION: f64 = 0.25;
/// How far a direction may be off before nothing of it is left (degrees).
const ASTRAY: f64 = 30.0;

/// Two thresholds that can be those of the benchmark or wider ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// How far from each other things near each other are (metres).
    pub near: [f64; 2],
    /// How much wider than the reference the space beside, before and behind it is, as a share.
    pub beside: f64,
}

impl Thresholds {
    /// Those of the benchmark.
    pub const PUBLISHED: Self = Self { near: [0.5, 1.5], beside: 0.25 };
    /// What is nearer than half a metre is near, too, and a thing before a sofa may be further to the side.
    pub const WIDE: Self = Self { near: [0.0, 1.5], beside: 10.0 };
}

/// A relation of a target to a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Over the reference's upper half, its middle higher.
    OnTop,
    /// Within half a metre.
    Next,
    /// Within one and a half.
    Near,
    /// Between one and a half metres and four away.
    Across,
    /// On its left, seen from in front.
    Left,
    /// On its right, seen from in front.
    Right,
    /// Before its front.
    Front,
    /// Behind its back.
    Behind,
    /// Higher than its top.
    Above,
    /// Lower than its base.
    Below,
    /// Turned to it.
    Facing,
    Inside,
    LongSide,
    ShortSide,
    /// At its middle, seen from above.
    Middle,
    /// Several targets all round it.
    Surround,
}

impl Relation {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::OnTop,
        Self::Next,
        Self::Near,
        Self::Across,
        Self::Left,
        Self::Right,
        Self::Front,
        Self::Behind,
        Self::Above,
        Self::Below,
        Self::Facing,
        Self::Inside,
        Self::LongSide,
        Self::ShortSide,
        Self::Middle,
        Self::Surround,
    ];

    /// As in the table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::OnTop => "on-top",
            Self::Next => "next",
            Self::Near => "near",
            Self::Across => "across",
            Self::Left => "left",
            Self::Right => "right",
            Self::Front => "front",
            Self::Behind => "behind",
            Self::Above => "above",
            Self::Below => "below",
            Self::Facing => "facing",
            Self::Inside => "inside",
            Self::LongSide => "long-side",
            Self::ShortSide => "short-side",
            Self::Middle => "middle",
            Self::Surround => "surround",
        }
    }

    /// The relation of a name in the table.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|relation| relation.name() == name)
    }

    /// How well one target stands in the relation, 0 to 1.
    pub fn score(self, target: &Shape, reference: &Shape, thresholds: &Thresholds) -> f64 {
        let beside = |axis, positive| {
            let margin = if axis == UP { ABOVE } else { thresholds.beside };
            reference.share_at(target, SideTest { axis, positive, beyond: true, margin })
        };
        match self {
            Self::OnTop if target.obb.center.y > reference.obb.center.y => {
                reference.share_at(target, SideTest { axis: UP, positive: true, beyond: false, margin: 1e-9 })
            }
            Self::OnTop => 0.0,
            Self::Next => next(target, reference),
            Self::Near => near(target, reference, thresholds),
            Self::Across => across(target, reference),
            Self::Left => beside(0, true),
            Self::Right => beside(0, false),
            Self::Front => beside(2, true),
            Self::Behind => beside(2, false),
            Self::Above => beside(UP, true),
            Self::Below => beside(UP, false),
            Self::Facing => facing(target, reference),
            Self::Inside => reference.share_inside(target),
            Self::LongSide => at_sides(target, reference, true),
            Self::ShortSide => at_sides(target, reference, false),
            Self::Middle => {
                let off = flat(target) - flat(reference);
                (-off.norm_squared() / (2.0 * DEVIATION * DEVIATION)).exp()
            }
            Self::Surround => surround(&[target], reference),
        }
    }
}

/// The axis of heights.
const UP: usize = 1;
/// How much wider than the reference the space above and below it is, as a share.
const ABOVE: f64 = 0.25;

/// Within half a metre.
pub fn next(a: &Shape, b: &Shape) -> f64 {
    ease(a.gap(b), [0.0, 0.5], DEVIATION)
}

/// Within one and a half metres.
pub fn near(a: &Shape, b: &Shape, thresholds: &Thresholds) -> f64 {
    ease(a.gap(b), thresholds.near, DEVIATION)
}

/// Between one and a half metres and four away.
pub fn across(a: &Shape, b: &Shape) -> f64 {
    ease(a.gap(b), [1.5, 4.0], DEVIATION)
}

/// Where the centre of a box is, seen from above.
fn flat(shape: &Shape) -> Vec2 {
    Vec2::new(shape.obb.center.x, shape.obb.center.z)
}

fn facing(target: &Shape, reference: &Shape) -> f64 {
    let Some(way) = target.sight(reference) else { return 0.0 };
    let front = Vec2::new(target.obb.axes[(0, 2)], target.obb.axes[(2, 2)]);
    if way.norm() < 1e-9 || front.norm() < 1e-9 {
        return 0.0;
    }
    // As published, so that the greatest score is 0.996.
    let length = |way: Vec2| way.norm() + 1e-6;
    let cosine = (way.dot(&front) / length(way) / length(front)).clamp(-1.0, 1.0);
    (1.0 - cosine.acos().to_degrees() / ASTRAY).max(0.0)
}

fn at_sides(target: &Shape, reference: &Shape, long: bool) -> f64 {
    let half = reference.obb.half;
    if (half.x - half.z).abs() < 1e-6 {
        return 0.0;
    }
    // The long sides are those that the short axis leads to.
    let axis = if (half.x < half.z) == long { 0 } else { 2 };
    let share = |positive| reference.share_at(target, SideTest { axis, positive, beyond: false, margin: 1e-9 });
    share(true).max(share(false))
}

/// How evenly targets stand round a reference, in distance and in direction, 0 to 1; fewer than three do not surround it.
pub fn surround(targets: &[&Shape], reference: &Shape) -> f64 {
    use std::f64::consts::TAU;
    let n = targets.len();
    if n < 3 {
        return 0.0;
    }
    let ways: Vec<Vec3> = targets.iter().map(|target| target.obb.center - reference.obb.center).collect();
    let mut sorted: Vec<f64> = ways.iter().map(|way| way.norm()).collect();
    sorted.sort_by(f64::total_cmp);
    let median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0;
    if sorted[0] < 1e-9 {
        return 0.0;
    }
    let ideal = TAU / n as f64;
    let even = |value: f64, wanted: f64| (1.0 - ((value - wanted).abs() / wanted).clamp(0.0, 1.0)).powi(2);
    // To the next one on the same side. Where there is none within half a turn nothing is left, as published.
    let next = |from: &Vec3| {
        let angle = |to: &Vec3| (from.dot(to) / from.norm() / to.norm()).clamp(-1.0, 1.0).acos();
        let ahead = ways.iter().filter(|to| from.x * to.z - from.z * to.x > 0.0).map(angle);
        ahead.reduce(f64::min)
    };
    let of = |way: &Vec3| 0.5 * even(way.norm(), median) + 0.5 * next(way).map_or(0.0, |angle| even(angle, ideal));
    ways.iter().map(of).sum::<f64>() / n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::{Placement, Vec3};

    /// A box by the middle of its base, its extents, and how it is turned about y.
    fn shape(pos: [f64; 3], scale: [f64; 3], yaw: f64) -> Shape {
        let (pos, rot, scale) = (Vec3::from(pos), Vec3::new(0.0, yaw, 0.0), Vec3::from(scale));
        Shape::new(&Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() })
    }

    /// A table of 1.6 m by 0.75 m by 0.8 m whose front is +z.
    fn table(yaw: f64) -> Shape {
        shape([0.0; 3], [1.6, 0.75, 0.8], yaw)
    }

    /// A cube of 0.4 m.
    fn cube(pos: [f64; 3], yaw: f64) -> Shape {
        shape(pos, [0.4; 3], yaw)
    }

    fn close(found: f64, wanted: f64) {
        assert!((found - wanted).abs() < 1e-9, "{found} is not {wanted}");
    }

    /// To what counts as on a boundary.
    fn near_to(found: f64, wanted: f64) {
        assert!((found - wanted).abs() < 1e-5, "{found} is not {wanted}");
    }

    #[test]
    fn on_and_above_and_below() {
        let score = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0), &Thresholds::WIDE);
        close(score(Relation::OnTop, [0.0, 0.75, 0.0]), 1.0);
        // A quarter of it is beyond the edge at 0.8.
        near_to(score(Relation::OnTop, [0.7, 0.75, 0.0]), 0.75);
        close(score(Relation::OnTop, [0.0, -0.4, 0.0]), 0.0);
        close(score(Relation::Above, [0.0, 0.75, 0.0]), 1.0);
        near_to(score(Relation::Above, [0.0, 0.5, 0.0]), 0.375);
        close(score(Relation::Below, [0.0, -0.4, 0.0]), 1.0);
        near_to(score(Relation::Below, [0.0, -0.1, 0.0]), 0.25);
    }

    #[test]
    fn distances() {
        let score =
            |relation: Relation, x: f64| relation.score(&cube([x, 0.0, 0.0], 0.0), &table(0.0), &Thresholds::WIDE);
        // The gap is x - 1.
        close(score(Relation::Next, 1.4), 1.0);
        close(score(Relation::Next, 1.75), (-0.5_f64).exp());
        close(score(Relation::Near, 2.4), 1.0);
        close(score(Relation::Near, 2.75), (-0.5_f64).exp());
        close(score(Relation::Across, 2.25), (-0.5_f64).exp());
        close(score(Relation::Across, 3.0), 1.0);
        close(score(Relation::Across, 5.25), (-0.5_f64).exp());
        let published = |x| Relation::Near.score(&cube([x, 0.0, 0.0], 0.0), &table(0.0), &Thresholds::PUBLISHED);
        close(published(1.6), 1.0);
        close(published(1.25), (-0.5_f64).exp());
        // What is within is as far from it as its nearest side.
        close(table(0.0).gap(&cube([0.5, 0.1, 0.0], 0.0)), 0.1);
    }

    #[test]
    fn left_and_right_are_of_who_looks_at_the_front() {
        let at = |relation: Relation, pos, yaw| relation.score(&cube(pos, 0.0), &table(yaw), &Thresholds::WIDE);
        close(at(Relation::Left, [1.2, 0.0, 0.0], 0.0), 1.0);
        close(at(Relation::Right, [1.2, 0.0, 0.0], 0.0), 0.0);
        close(at(Relation::Right, [1.2, 0.0, 0.0], 180.0), 1.0);
        close(at(Relation::Front, [0.0, 0.0, 0.9], 0.0), 1.0);
        close(at(Relation::Behind, [0.0, 0.0, 0.9], 180.0), 1.0);
        // It is no longer at that side eleven times as far out; as published, a quarter further out than the table is wide.
        close(at(Relation::Front, [10.0, 0.0, 0.9], 0.0), 0.0);
        let published = |x| Relation::Front.score(&cube([x, 0.0, 0.9], 0.0), &table(0.0), &Thresholds::PUBLISHED);
        near_to(published(0.9), 0.75);
        close(published(1.3), 0.0);
        close(at(Relation::Front, [1.3, 0.0, 0.9], 0.0), 1.0);
    }

    #[test]
    fn facing_needs_the_reference_ahead() {
        let at = |yaw| Relation::Facing.score(&cube([0.0, 0.0, 2.0], yaw), &table(0.0), &Thresholds::WIDE);
        assert!((at(180.0) - 1.0).abs() < 5e-3, "{}", at(180.0));
        close(at(0.0), 0.0);
        close(at(120.0), 0.0);
        // Some of the rays pass the table by, so that what is met is to one side.
        let partly = at(150.0);
        assert!(0.0 < partly && partly < 1.0, "{partly}");
    }

    #[test]
    fn inside_and_middle() {
        let at = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0), &Thresholds::WIDE);
        close(at(Relation::Inside, [0.0, 0.1, 0.0]), 1.0);
        near_to(at(Relation::Inside, [0.8, 0.1, 0.0]), 0.5);
        close(at(Relation::Middle, [0.0, 2.0, 0.0]), 1.0);
        close(at(Relation::Middle, [0.25, 0.0, 0.0]), (-0.5_f64).exp());
    }

    #[test]
    fn long_and_short_sides() {
        // Half of the chair is under the table.
        let at = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0), &Thresholds::WIDE);
        close(at(Relation::LongSide, [0.3, 0.0, 0.5]), 1.0);
        near_to(at(Relation::ShortSide, [0.1, 0.0, 0.3]), 0.75 * 0.75);
        close(at(Relation::ShortSide, [1.2, 0.0, 0.0]), 1.0);
        let square = shape([0.0; 3], [1.0, 0.7, 1.0], 0.0);
        close(Relation::LongSide.score(&cube([0.0, 0.0, 0.7], 0.0), &square, &Thresholds::WIDE), 0.0);
    }

    #[test]
    fn surrounded() {
        let round: Vec<Shape> = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
            .map(|[x, z]| cube([x, 0.0, z], 0.0))
            .into_iter()
            .collect();
        let all: Vec<&Shape> = round.iter().collect();
        close(surround(&all, &shape([0.0; 3], [1.6, 0.4, 0.8], 0.0)), 1.0);
        close(surround(&all[..2], &table(0.0)), 0.0);
        // A quarter turn to the next one instead of a third, twice; before the last there is none.
        let lower: f64 = 0.2 - 0.375;
        let angle = (lower * lower / (1.0 + lower * lower)).acos();
        let even = 1.0 - (std::f64::consts::TAU / 3.0 - angle) / (std::f64::consts::TAU / 3.0);
        close(surround(&all[..3], &table(0.0)), 0.5 + 0.5 * 2.0 * even * even / 3.0);
        close(Relation::Surround.score(&round[0], &table(0.0), &Thresholds::WIDE), 0.0);
    }
}
