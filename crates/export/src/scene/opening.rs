//! What of an object opens, and the floor that it sweeps on the way.

use super::{Object, Row};
use nalgebra::{Rotation3, Unit};
use scenelang_layout::planar::convex_hull;
use scenelang_layout::{Joint, Motion, Vec2, Vec3};

/// A movable part and how far it is opened where that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Which joint of the placement.
    pub joint: usize,
    /// As far as is useful; where that is not known, as far as it goes (degrees or metres).
    pub amount: f64,
    /// Whether the asset says how far is useful.
    pub useful: bool,
    /// Whether P-OPEN is violated for it.
    pub blocked: bool,
    /// Outline of what it sweeps from closed to open, in the frame of the object: x, z. A leaf on an upright axis has the axis
    /// first, and its open edge last. Empty where the object lies on its side.
    pub swept: Vec<Vec2>,
}

/// Degrees between two poses from which an outline is made.
const STEP: f64 = 5.0;
/// A direction is upright where its height is more than this share of it.
const UPRIGHT: f64 = 0.99;

/// All openings of an object, in the order of its joints.
pub(super) fn openings(object: &Object, rows: &[Row]) -> Vec<Opening> {
    // Parts that do not fill the box are not those that were judged.
    if object.place.parts.len() != object.solid.len() {
        return Vec::new();
    }
    let opening = |(index, joint): (usize, &Joint)| {
        let id = format!("P-OPEN:{}/{}", object.name, joint.name);
        let amount = joint.useful.unwrap_or(joint.limits[1]);
        let stands = object.axes[(1, 1)] > UPRIGHT;
        Opening {
            joint: index,
            amount,
            useful: joint.useful.is_some(),
            blocked: rows.iter().any(|row| row.id == id && row.violated()),
            swept: if stands { swept(object, joint, amount) } else { Vec::new() },
        }
    };
    object.place.joints.iter().enumerate().map(opening).collect()
}

fn swept(object: &Object, joint: &Joint, amount: f64) -> Vec<Vec2> {
    let Some(axis) = Unit::try_new(joint.axis, 1e-9) else { return Vec::new() };
    let points: Vec<Vec3> =
        joint.parts.iter().filter_map(|&p| object.solid.get(p)).flat_map(|c| c.vertices()).copied().collect();
    let poses = match joint.motion {
        Motion::Slide => 1,
        Motion::Hinge => (amount.abs() / STEP).ceil().clamp(1.0, 360.0) as usize,
    };
    let at = |p: &Vec3, pose: usize| {
        let by = amount * pose as f64 / poses as f64;
        match joint.motion {
            Motion::Slide => p + axis.scale(by),
            Motion::Hinge => joint.anchor + Rotation3::from_axis_angle(&axis, by.to_radians()) * (p - joint.anchor),
        }
    };
    if joint.motion == Motion::Hinge && axis.y.abs() > UPRIGHT {
        let radius = |p: &&Vec3| (*p - joint.anchor).xz().norm();
        let Some(edge) = points.iter().max_by(|a, b| radius(a).total_cmp(&radius(b))) else { return Vec::new() };
        return std::iter::once(joint.anchor.xz()).chain((0..=poses).map(|pose| at(edge, pose).xz())).collect();
    }
    convex_hull((0..=poses).flat_map(|pose| points.iter().map(move |p| at(p, pose).xz())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::fixture::cupboard;
    use crate::plan;

    #[test]
    fn a_leaf_sweeps_a_sector_and_a_drawer_a_rectangle() {
        let scene = cupboard();
        let [door, drawer] = &scene.objects[0].openings[..] else { panic!("a door and a drawer") };
        assert_eq!((door.amount, drawer.amount), (110.0, 0.3));
        let (hinge, arc) = door.swept.split_first().unwrap();
        assert_eq!(*hinge, Vec2::new(-0.39, 0.23));
        let radius = 0.78_f64.hypot(0.02);
        assert!(arc.iter().all(|p| ((p - hinge).norm() - radius).abs() < 1e-9));
        let opened = (arc[0] - hinge).angle(&(arc[arc.len() - 1] - hinge)).to_degrees();
        assert!((opened - 110.0).abs() < 1e-9 && arc[arc.len() - 1].y > 0.9, "towards the front");
        assert!(drawer.swept.len() == 4 && drawer.swept.iter().all(|p| (p.x.abs() - 0.39).abs() < 1e-9));
        let reach = drawer.swept.iter().map(|p| p.y).fold(0.0, f64::max);
        assert!((reach - 0.55).abs() < 1e-9);
    }

    #[test]
    fn the_plan_shows_what_is_useful_and_in_red_what_is_blocked() {
        let mut scene = cupboard();
        assert!(!plan::svg(&scene).contains("data-swept"), "no useful amount is known");
        scene.objects[0].place.joints[0].useful = Some(90.0);
        let row =
            |part: &str| Row { id: format!("P-OPEN:cupboard/{part}"), kind: "opening".into(), satisfied: Some(false) };
        for (part, mark) in [("drawer", ""), ("door", r#" data-violated="true""#)] {
            scene.objects[0].openings = openings(&scene.objects[0], &[row(part)]);
            let svg = plan::svg(&scene);
            assert_eq!(svg.matches("data-swept").count(), 1);
            assert!(svg.contains(&format!(r#"data-swept="cupboard/door"{mark} fill"#)), "{part}");
        }
    }

    #[test]
    fn what_lies_on_its_side_sweeps_nothing_on_the_floor() {
        let mut scene = cupboard();
        scene.objects[0].axes = scenelang_layout::rotation::matrix(Vec3::new(90.0, 0.0, 0.0));
        assert!(openings(&scene.objects[0], &[]).iter().all(|opening| opening.swept.is_empty()));
    }
}
