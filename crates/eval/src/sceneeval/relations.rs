//! Relations between objects, by the published geometry and thresholds, on oriented boxes.
//!
//! Left and right are those of someone who stands before the front of the reference and looks at it: the reference's own
//! right is on the left.

use super::shape::{Shape, SideTest, ease};
use scenelang_layout::Vec2;

/// How distances fall off outside of their ranges (metres).
const DEVIATION: f64 = 0.25;
/// How far a direction may be off before nothing of it is left (degrees).
const ASTRAY: f64 = 30.0;

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
    pub fn score(self, target: &Shape, reference: &Shape) -> f64 {
        let beside =
            |axis, positive| reference.share_at(target, SideTest { axis, positive, beyond: true, margin: WIDE[axis] });
        match self {
            Self::OnTop if target.obb.center.y > reference.obb.center.y => {
                reference.share_at(target, SideTest { axis: 1, positive: true, beyond: false, margin: 1e-9 })
            }
            Self::OnTop => 0.0,
            Self::Next => next(target, reference),
            Self::Near => near(target, reference),
            Self::Across => across(target, reference),
            Self::Left => beside(0, true),
            Self::Right => beside(0, false),
            Self::Front => beside(2, true),
            Self::Behind => beside(2, false),
            Self::Above => beside(1, true),
            Self::Below => beside(1, false),
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

/// How much wider than the reference the space at a side of it is: above and below little, beside it much.
const WIDE: [f64; 3] = [10.0, 0.25, 10.0];

/// Within half a metre.
pub fn next(a: &Shape, b: &Shape) -> f64 {
    ease(a.gap(b), [0.0, 0.5], DEVIATION)
}

/// Within one and a half metres. As published it is at least half a metre; here, what is nearer is near, too.
pub fn near(a: &Shape, b: &Shape) -> f64 {
    ease(a.gap(b), [0.0, 1.5], DEVIATION)
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
    let Some(seen) = target.seen_of(reference) else { return 0.0 };
    let way = Vec2::new(seen.x, seen.z) - flat(target);
    let front = Vec2::new(target.obb.axes[(0, 2)], target.obb.axes[(2, 2)]);
    if way.norm() < 1e-9 || front.norm() < 1e-9 {
        return 0.0;
    }
    let cosine = (way.dot(&front) / way.norm() / front.norm()).clamp(-1.0, 1.0);
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

/// How evenly targets stand round a reference, in distance and direction, 0 to 1; fewer than three do not surround it.
pub fn surround(targets: &[&Shape], reference: &Shape) -> f64 {
    use std::f64::consts::TAU;
    if targets.len() < 3 {
        return 0.0;
    }
    let ways: Vec<Vec2> = targets.iter().map(|target| flat(target) - flat(reference)).collect();
    let distances: Vec<f64> = ways.iter().map(|way| way.norm()).collect();
    let mut sorted = distances.clone();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    let median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0;
    let mut angles: Vec<f64> = ways.iter().map(|way| way.y.atan2(way.x)).collect();
    angles.sort_by(f64::total_cmp);
    angles.push(angles[0] + TAU);
    let ideal = TAU / n as f64;
    let even = |value: f64, wanted: f64| (1.0 - ((value - wanted).abs() / wanted).clamp(0.0, 1.0)).powi(2);
    let near = distances.iter().map(|d| even(*d, median));
    let round = angles.windows(2).map(|pair| even(pair[1] - pair[0], ideal));
    near.zip(round).map(|(d, a)| 0.5 * d + 0.5 * a).sum::<f64>() / n as f64
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

    #[test]
    fn on_and_above_and_below() {
        let score = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0));
        close(score(Relation::OnTop, [0.0, 0.75, 0.0]), 1.0);
        // Two of the seven layers of points are beyond the edge at 0.8.
        close(score(Relation::OnTop, [0.7, 0.75, 0.0]), 5.0 / 7.0);
        close(score(Relation::OnTop, [0.0, -0.4, 0.0]), 0.0);
        close(score(Relation::Above, [0.0, 0.75, 0.0]), 1.0);
        close(score(Relation::Above, [0.0, 0.5, 0.0]), 3.0 / 7.0);
        close(score(Relation::Below, [0.0, -0.4, 0.0]), 1.0);
        close(score(Relation::Below, [0.0, 0.0, 0.0]), 1.0 / 7.0);
    }

    #[test]
    fn distances() {
        let score = |relation: Relation, x: f64| relation.score(&cube([x, 0.0, 0.0], 0.0), &table(0.0));
        // The gap is x - 1.
        close(score(Relation::Next, 1.4), 1.0);
        close(score(Relation::Next, 1.75), (-0.5_f64).exp());
        close(score(Relation::Near, 2.4), 1.0);
        close(score(Relation::Near, 2.75), (-0.5_f64).exp());
        close(score(Relation::Across, 2.25), (-0.5_f64).exp());
        close(score(Relation::Across, 3.0), 1.0);
        close(score(Relation::Across, 5.25), (-0.5_f64).exp());
    }

    #[test]
    fn left_and_right_are_of_who_looks_at_the_front() {
        let at = |relation: Relation, pos, yaw| relation.score(&cube(pos, 0.0), &table(yaw));
        close(at(Relation::Left, [1.2, 0.0, 0.0], 0.0), 1.0);
        close(at(Relation::Right, [1.2, 0.0, 0.0], 0.0), 0.0);
        close(at(Relation::Right, [1.2, 0.0, 0.0], 180.0), 1.0);
        close(at(Relation::Front, [0.0, 0.0, 0.9], 0.0), 1.0);
        close(at(Relation::Behind, [0.0, 0.0, 0.9], 180.0), 1.0);
        // It is no longer at that side eleven times as far out.
        close(at(Relation::Front, [10.0, 0.0, 0.9], 0.0), 0.0);
    }

    #[test]
    fn facing_needs_the_reference_ahead() {
        let at = |yaw| Relation::Facing.score(&cube([0.0, 0.0, 2.0], yaw), &table(0.0));
        // An arc cosine near 1 is good to half the digits.
        assert!((at(180.0) - 1.0).abs() < 1e-6, "{}", at(180.0));
        close(at(0.0), 0.0);
        close(at(120.0), 0.0);
        // Half of the rays pass the table by, so that what is met is to one side.
        let partly = at(150.0);
        assert!(0.0 < partly && partly < 1.0, "{partly}");
    }

    #[test]
    fn inside_and_middle() {
        let at = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0));
        close(at(Relation::Inside, [0.0, 0.1, 0.0]), 1.0);
        close(at(Relation::Inside, [0.8, 0.1, 0.0]), 4.0 / 7.0);
        close(at(Relation::Middle, [0.0, 2.0, 0.0]), 1.0);
        close(at(Relation::Middle, [0.25, 0.0, 0.0]), (-0.5_f64).exp());
    }

    #[test]
    fn long_and_short_sides() {
        // Half of the chair is under the table.
        let at = |relation: Relation, pos| relation.score(&cube(pos, 0.0), &table(0.0));
        close(at(Relation::LongSide, [0.3, 0.0, 0.5]), 1.0);
        close(at(Relation::ShortSide, [0.3, 0.0, 0.5]), 2.0 / 7.0);
        close(at(Relation::ShortSide, [1.2, 0.0, 0.0]), 1.0);
        let square = shape([0.0; 3], [1.0, 0.7, 1.0], 0.0);
        close(Relation::LongSide.score(&cube([0.0, 0.0, 0.7], 0.0), &square), 0.0);
    }

    #[test]
    fn surrounded() {
        let round: Vec<Shape> = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
            .map(|[x, z]| cube([x, 0.0, z], 0.0))
            .into_iter()
            .collect();
        let all: Vec<&Shape> = round.iter().collect();
        close(surround(&all, &table(0.0)), 1.0);
        close(surround(&all[..2], &table(0.0)), 0.0);
        // Gaps of a quarter, a quarter and a half turn instead of thirds: (0.75² + 0.75² + 0.5²) / 3.
        close(surround(&all[..3], &table(0.0)), 0.5 + 0.5 * (0.5625 + 0.5625 + 0.25) / 3.0);
        close(Relation::Surround.score(&round[0], &table(0.0)), 0.0);
    }
}
