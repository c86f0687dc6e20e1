//! What of an object opens, and the floor that it sweeps on the way.

use super::{Object, ReportRow};
use nalgebra::{Rotation3, Unit};
use scenelang_lang::opening::{Opened, asserted};
use scenelang_lang::program::{Node, ObjectId, Program};
use scenelang_layout::planar::convex_hull;
use scenelang_layout::{Joint, Motion, Vec2, Vec3};

/// A movable part and how far it is opened where that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Which joint of the placement.
    pub joint: usize,
    /// As far as the program demands, else as far as is useful; where neither is known, as far as it goes (degrees or metres).
    pub amount: f64,
    /// Whether the program or the asset says how far.
    pub asked: bool,
    /// Whether P-OPEN, or the assertion that it opens so far, is violated for it.
    pub blocked: bool,
    /// Outline of what it sweeps from closed to open, in the frame of the object: x, z. A leaf on an upright axis has the axis
    /// first, and its open edge last. Empty where the object lies on its side.
    pub swept: Vec<Vec2>,
}

/// Degrees between two poses from which an outline is made.
const STEP: f64 = 5.0;
/// A direction is upright where its height is more than this share of it.
const UPRIGHT: f64 = 0.99;

/// How far an assertion demands that the parts of an object open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Demand {
    object: ObjectId,
    /// Of the parts that move this way; `None`: of all.
    motion: Option<Motion>,
    /// Degrees or metres; `None`: as far as is of use.
    amount: Option<f64>,
    /// Whether the assertion demands nothing else and is violated.
    fails: bool,
}

/// What the assertions of a program demand (`opens(wardrobe, 60deg)`, `sliding(desk) >= 0.3`); `fails` says
/// whether the one with an index is violated.
pub(super) fn demands(program: &Program, fails: impl Fn(usize) -> bool) -> Vec<Demand> {
    let demand = |(index, object, opened): (usize, ObjectId, Opened)| {
        let (motion, amount) = match opened {
            Opened::Useful => (None, None),
            Opened::Turned(amount) => (Some(Motion::Hinge), Some(amount)),
            Opened::Slid(amount) => (Some(Motion::Slide), Some(amount)),
        };
        // Which part of several fails is not known.
        let alone = motion.is_some() && !matches!(program.constraints[index].formula.root_node(), Node::And(_));
        amount.is_none_or(|amount| amount > 0.0).then(|| Demand {
            object,
            motion,
            amount,
            fails: alone && fails(index),
        })
    };
    asserted(program).into_iter().filter_map(demand).collect()
}

/// All openings of the object with a number, in the order of its joints.
pub(super) fn openings(id: usize, object: &Object, rows: &[ReportRow], demands: &[Demand]) -> Vec<Opening> {
    // Parts that do not fill the box are not those that were judged.
    if object.place.parts.len() != object.solid.len() {
        return Vec::new();
    }
    let opening = |(index, joint): (usize, &Joint)| {
        let rule = format!("P-OPEN:{}/{}", object.name, joint.name);
        let rule = rows.iter().find(|row| row.id == rule);
        let moves = |motion: &Option<Motion>| motion.is_none_or(|motion| motion == joint.motion);
        let own = || demands.iter().filter(|d| d.object.0 as usize == id && moves(&d.motion));
        let asked = own().filter_map(|d| d.amount.or(joint.useful)).reduce(f64::max);
        let most = joint.limits[1];
        let amount = asked.or(joint.useful).unwrap_or(most).min(most);
        let stands = object.axes[(1, 1)] > UPRIGHT;
        Opening {
            joint: index,
            amount,
            asked: joint.useful.is_some() || asked.is_some(),
            blocked: rule.is_some_and(ReportRow::violated) || own().any(|d| d.fails),
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
    use scenelang_lang::{Options, compile_text};
    use std::path::Path;

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
        assert!(!plan::svg(&scene).contains("data-swept"), "nobody says how far");
        scene.objects[0].place.joints[0].useful = Some(90.0);
        let row = |part: &str| ReportRow {
            id: format!("P-OPEN:cupboard/{part}"),
            kind: "opening".into(),
            satisfied: Some(false),
        };
        for (part, mark) in [("drawer", ""), ("door", r#" data-violated="true""#)] {
            scene.objects[0].openings = openings(0, &scene.objects[0], &[row(part)], &[]);
            let svg = plan::svg(&scene);
            assert_eq!(svg.matches("data-swept").count(), 1);
            assert!(svg.contains(&format!(r#"data-swept="cupboard/door"{mark} fill"#)), "{part}");
        }
    }

    #[test]
    fn what_an_assertion_demands_is_shown() {
        let demands_of = |assertion: &str| {
            let text = format!("object other; object cupboard; {assertion}");
            let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
            demands(&compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics)), |_| true)
        };
        let mut scene = cupboard();
        scene.objects[0].place.joints[0].useful = Some(90.0);
        let amounts = |demands: &[Demand], rows: &[ReportRow]| {
            let found = openings(1, &scene.objects[0], rows, demands);
            [&found[0], &found[1]].map(|opening| (opening.amount, opening.asked, opening.blocked))
        };
        let nothing = [(90.0, true, false), (0.3, false, false)];
        for (assertion, door, drawer) in [
            ("assert opens(cupboard, 60deg);", (60.0, true, true), nothing[1]),
            ("assert slides(cupboard, 0.2);", nothing[0], (0.2, true, true)),
            // Which of two is violated is not known.
            ("assert opens(cupboard, 60deg) and slides(cupboard, 0.2);", (60.0, true, false), (0.2, true, false)),
            ("assert opens(cupboard, 170deg);", (110.0, true, true), nothing[1]),
            ("assert opening(cupboard) >= 60deg;", (60.0, true, true), nothing[1]),
            ("assert 0.2 <= sliding(cupboard);", nothing[0], (0.2, true, true)),
            ("assert opening(cupboard) <= 60deg;", nothing[0], nothing[1]),
            ("assert not opens(cupboard, 60deg);", nothing[0], nothing[1]),
            ("prefer opens(cupboard, 60deg);", nothing[0], nothing[1]),
            ("assert opens(other, 60deg);", nothing[0], nothing[1]),
            ("assert opens(cupboard);", nothing[0], nothing[1]),
            ("assert opens(cupboard); assert opens(cupboard, 60deg);", (90.0, true, true), nothing[1]),
        ] {
            assert_eq!(amounts(&demands_of(assertion), &[]), [door, drawer], "{assertion}");
        }
        // The rule demands no more than the program does.
        let row = ReportRow { id: "P-OPEN:cupboard/door".into(), kind: "opening".into(), satisfied: Some(true) };
        let demands = demands_of("assert opens(cupboard, 60deg);");
        assert_eq!(amounts(&demands, &[row])[0].0, 60.0);
    }

    #[test]
    fn what_lies_on_its_side_sweeps_nothing_on_the_floor() {
        let mut scene = cupboard();
        scene.objects[0].axes = scenelang_layout::rotation::matrix(Vec3::new(90.0, 0.0, 0.0));
        assert!(openings(0, &scene.objects[0], &[], &[]).iter().all(|opening| opening.swept.is_empty()));
    }
}
