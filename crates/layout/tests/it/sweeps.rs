//! Motions: what is said of all poses against many poses looked at one by one.

use nalgebra::Matrix3;
use proptest::prelude::*;
use scenelang_layout::convex::separation;
use scenelang_layout::sweep::RESOLUTION;
use scenelang_layout::{Convex, Joint, Motion, Moving, Obb, Vec3, rotation};

/// Where the verdict of a sweep and of samples may differ (metres).
const BAND: f64 = 2e-3;

fn solid(center: [f64; 3], size: [f64; 3], rot: [f64; 3]) -> Convex {
    let (center, half) = (Vec3::from(center), Vec3::from(size) / 2.0);
    Convex::from_box(&Obb { center, axes: rotation::matrix(Vec3::from(rot)), half })
}

fn joint(motion: Motion, axis: Vec3, anchor: Vec3, most: f64) -> Joint {
    let (name, limits) = ("leaf".into(), [0.0, most]);
    Joint { name, motion, axis, anchor, limits, useful: None, handle: None, parts: vec![0] }
}

fn moving(joint: &Joint, bodies: &[Convex]) -> Moving {
    Moving::new(joint, bodies.iter(), &Matrix3::identity(), &Vec3::zeros())
}

/// The least gap at poses a tenth of a degree or half a millimetre apart, each found by turning and sliding corners anew,
/// and the first of these poses at which the gap is less than `least`.
fn sampled(joint: &Joint, body: &Convex, obstacle: &Convex, amount: f64, least: f64) -> (f64, f64) {
    let step = if joint.motion == Motion::Hinge { 0.1 } else { 5e-4 };
    let count = (amount / step).ceil() as usize;
    let axis = joint.axis.normalize();
    let (mut lowest, mut first) = (f64::INFINITY, f64::INFINITY);
    for i in 0..=count {
        let at = amount * i as f64 / count as f64;
        let place = |v: &Vec3| match joint.motion {
            Motion::Slide => v + axis * at,
            Motion::Hinge => {
                // Rodrigues' formula, as in any textbook.
                let (arm, (sin, cos)) = (v - joint.anchor, at.to_radians().sin_cos());
                joint.anchor + arm * cos + axis.cross(&arm) * sin + axis * (axis.dot(&arm) * (1.0 - cos))
            }
        };
        let points: Vec<Vec3> = body.vertices().iter().map(place).collect();
        let gap = separation(&Convex::from_hull(&points).expect("a box"), obstacle).gap;
        lowest = lowest.min(gap);
        if gap < least && first.is_infinite() {
            first = at;
        }
    }
    (lowest, first)
}

fn sizes() -> impl Strategy<Value = [f64; 3]> {
    [0.02..0.9, 0.1..2.0, 0.02..0.5f64]
}

fn motions() -> impl Strategy<Value = (Joint, f64)> {
    let upright = prop_oneof![Just(Vec3::y()), Just(-Vec3::y())];
    let tilted = [-1.0..1.0, -1.0..1.0, 0.3..1.0f64].prop_map(Vec3::from);
    let axis = prop_oneof![upright, tilted];
    (any::<bool>(), axis, [-0.5..0.5, -0.5..0.5, -0.3..0.3f64], 0.05..1.0f64).prop_map(
        |(hinge, axis, anchor, share)| {
            let (motion, most) = if hinge { (Motion::Hinge, 180.0) } else { (Motion::Slide, 0.8) };
            (joint(motion, axis, Vec3::from(anchor), most), share * most)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn a_sweep_is_what_dense_samples_see(
        (joint, amount) in motions(),
        size in sizes(), rot in [-20.0..20.0, 0.0..90.0, -20.0..20.0f64],
        other in sizes(), at in [-1.2..1.2, -1.0..1.0, -1.2..1.2f64], turned in [0.0..10.0, 0.0..90.0, 0.0..10.0f64],
    ) {
        let body = solid([0.3, 0.0, 0.0], size, rot);
        let obstacle = solid(at, other, turned);
        let (lowest, first) = sampled(&joint, &body, &obstacle, amount, -1e-3);
        let moving = moving(&joint, std::slice::from_ref(&body));
        let mut looks = usize::MAX;
        let swept = moving.least(std::slice::from_ref(&obstacle), amount, f64::INFINITY, &mut looks).unwrap();
        // Never wider, and narrower by no more than is promised and what lies between two samples.
        let step = 0.1f64.to_radians() * 1.2;
        prop_assert!(swept.gap <= lowest + 1e-6, "{} {lowest}", swept.gap);
        prop_assert!(swept.gap >= lowest - RESOLUTION.max((lowest.abs() + step) / 32.0) - step, "{} {lowest}", swept.gap);
        // Poses near the one that was found show the same gap.
        let there = separation(&moving.opened(swept.at)[0], &obstacle).gap;
        prop_assert!((there - swept.separation.gap).abs() < 1e-6);
        if lowest.abs() > BAND {
            prop_assert_eq!(swept.gap > 0.0, lowest > 0.0);
        }
        let (free, blocker) = moving.free(std::slice::from_ref(&obstacle), amount, -1e-3, &mut looks);
        prop_assert!(free <= first.min(amount) + 1e-9, "{free} {first}");
        prop_assert_eq!(blocker.is_some(), free < amount);
        // Less than it can be, if at all, only where the gap all but ends it.
        if free < amount {
            let nearly = sampled(&joint, &body, &obstacle, (free + 0.15).min(amount), -1e-3).0;
            prop_assert!(nearly < -1e-3 + BAND, "{free} {first} {nearly}");
        }
        let around = moving.around(amount);
        for share in [0.0, 0.3, 0.77, 1.0] {
            let there = *moving.opened(share * amount)[0].aabb();
            prop_assert!((around.min - there.min).max() < 1e-9 && (there.max - around.max).max() < 1e-9);
        }
    }
}

/// A leaf 0.8 m wide, hinged at the origin, closed along +x, that opens to +z.
fn leaf() -> (Joint, Convex) {
    (joint(Motion::Hinge, -Vec3::y(), Vec3::zeros(), 120.0), solid([0.4, 1.0, -0.02], [0.8, 2.0, 0.04], [0.0; 3]))
}

#[test]
fn sweeps_known_by_hand() {
    let (joint, body) = leaf();
    let moving = moving(&joint, &[body]);
    let least = |obstacle: &Convex, amount: f64| {
        moving.least(std::slice::from_ref(obstacle), amount, f64::INFINITY, &mut 10_000).unwrap()
    };
    // A wall across the way, 0.57 m off: the tip would be 0.8 m off.
    let wall = solid([0.0, 1.0, 0.67], [4.0, 2.0, 0.2], [0.0; 3]);
    let swept = least(&wall, 90.0);
    assert!((swept.gap + 0.23).abs() < 1e-3 && (swept.at - 90.0).abs() < 1.0, "{swept:?}");
    let (free, _) = moving.free(std::slice::from_ref(&wall), 90.0, 0.0, &mut 10_000);
    assert!((free - (0.57f64 / 0.8).asin().to_degrees()).abs() < 0.1, "{free}");
    // A wall along the hinge touches it all the way, and is no obstacle.
    let beside = solid([-0.5, 1.0, 0.0], [1.0, 2.0, 4.0], [0.0; 3]);
    assert_eq!(least(&beside, 90.0).gap, 0.0);
    assert_eq!(moving.free(std::slice::from_ref(&beside), 90.0, 0.0, &mut 10_000), (90.0, None));
    // A thin post that stands in the way between two closed and open poses is not stepped over.
    let post = solid([0.55, 1.0, 0.55], [0.001, 2.0, 0.001], [0.0; 3]);
    assert!(least(&post, 90.0).gap < -1e-3);
    // Drawers.
    let slide = self::joint(Motion::Slide, Vec3::z() * 3.0, Vec3::zeros(), 0.5);
    let drawer = self::moving(&slide, &[solid([0.0; 3], [0.4, 0.2, 0.4], [0.0; 3])]);
    let before = solid([0.0, 0.0, 0.7], [0.4, 0.2, 0.2], [0.0; 3]);
    let swept = drawer.least(std::slice::from_ref(&before), 0.5, f64::INFINITY, &mut 100).unwrap();
    assert!((swept.gap + 0.1).abs() < 1e-9 && swept.at == 0.5, "{swept:?}");
    let (free, blocker) = drawer.free(std::slice::from_ref(&before), 0.5, 0.0, &mut 100);
    assert!((free - 0.4).abs() < 1e-3 && blocker == Some(0), "{free}");
    assert_eq!(drawer.least(&[], 0.5, 1.0, &mut 100), None);
}

#[test]
fn few_looks_give_bounds_that_are_no_wider() {
    let (joint, body) = leaf();
    let moving = moving(&joint, &[body]);
    let near = solid([0.3, 1.0, 0.81], [0.4, 2.0, 0.01], [0.0, 30.0, 0.0]);
    let exact = moving.least(std::slice::from_ref(&near), 90.0, 9.0, &mut 100_000).unwrap().gap;
    for few in [0, 1, 3, 10, 40] {
        let gap = moving.least(std::slice::from_ref(&near), 90.0, 9.0, &mut { few }).unwrap().gap;
        assert!(gap <= exact + RESOLUTION, "{few} {gap} {exact}");
    }
}
