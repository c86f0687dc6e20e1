//! Polygons against exact arithmetic on whole numbers, and clearance against dense sampling.

use proptest::prelude::*;
use scenelang_layout::planar::{convex_hull, edges};
use scenelang_layout::{NotSimple, Obb, Polygon, Prism, RegionPlacement, Vec2, Vec3, inside_clearance, rotation};

/// Whether segments of whole numbers share a point, by exact orientation.
fn meet([a, b]: [(i64, i64); 2], [c, d]: [(i64, i64); 2]) -> bool {
    let turn =
        |p: (i64, i64), q: (i64, i64), r: (i64, i64)| ((q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0)).signum();
    let within = |p: (i64, i64), q: (i64, i64), r: (i64, i64)| {
        turn(p, q, r) == 0
            && (p.0.min(q.0)..=p.0.max(q.0)).contains(&r.0)
            && (p.1.min(q.1)..=p.1.max(q.1)).contains(&r.1)
    };
    turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
        || within(a, b, c)
        || within(a, b, d)
        || within(c, d, a)
        || within(c, d, b)
}

/// Simple by definition: only neighbouring edges meet, and only in their common corner.
fn simple(points: &[(i64, i64)]) -> bool {
    let n = points.len();
    let edge = |i: usize| [points[i % n], points[(i + 1) % n]];
    n >= 3
        && (0..n).all(|i| edge(i)[0] != edge(i)[1])
        && (0..n).all(|i| {
            (i + 1..n).all(|j| {
                if j == i + 1 || (j + 1) % n == i {
                    let (x, y) = if j == i + 1 { (edge(i), edge(j)) } else { (edge(j), edge(i)) };
                    // Neighbours may not fold back: the far end of neither lies on the other.
                    !meet(x, [y[1], y[1]]) && !meet([x[0], x[0]], y)
                } else {
                    !meet(edge(i), edge(j))
                }
            })
        })
}

/// A polygon about the origin, with inner corners.
fn star() -> impl Strategy<Value = Polygon> {
    let radius = prop_oneof![0.5..3.0, Just(1.0), Just(2.0)];
    prop::collection::vec(radius, 4..12).prop_map(|radii| {
        let step = std::f64::consts::TAU / radii.len() as f64;
        let at = |(i, r): (usize, &f64)| [r * (step * i as f64).cos(), r * (step * i as f64).sin()];
        Polygon::new(&radii.iter().enumerate().map(at).collect::<Vec<_>>()).unwrap()
    })
}

fn footprint() -> impl Strategy<Value = Vec<Vec2>> {
    (prop::array::uniform2(-2.0..2.0f64), prop::array::uniform2(0.05..3.0f64), prop_oneof![Just(0.0), 0.0..90.0f64])
        .prop_map(|([x, z], [w, d], turn)| {
            Polygon::rectangle(Vec2::new(x, z), Vec2::new(w, d), turn).corners().to_vec()
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn simple_is_what_exact_arithmetic_says(points in prop::collection::vec((-3i64..=3, -3i64..=3), 0..7)) {
        let given: Vec<[f64; 2]> = points.iter().map(|&(x, z)| [x as f64, z as f64]).collect();
        let mut open = points;
        if open.len() > 1 && open.first() == open.last() {
            open.pop();
        }
        prop_assert_eq!(Polygon::new(&given).is_ok(), simple(&open), "{:?}", Polygon::new(&given));
    }

    #[test]
    fn clearance_is_the_least_along_the_outline(polygon in star(), footprint in footprint()) {
        let c = polygon.clearance(&footprint);
        let steps = 400;
        let mut least = f64::INFINITY;
        let mut longest = 0.0f64;
        for (a, b) in edges(&footprint) {
            longest = longest.max((b - a).norm());
            for i in 0..steps {
                let p = a + (b - a) * (f64::from(i) / f64::from(steps));
                least = least.min(polygon.clearance_of_point(p).value);
            }
        }
        prop_assert!(c.value <= least + 1e-9, "{} but {least} was found", c.value);
        prop_assert!(c.value >= least - longest / f64::from(steps), "{} but only {least} was found", c.value);
        // The deciding point explains the value.
        prop_assert!(((c.at - c.wall).norm() - c.value.abs()).abs() < 1e-12);
        prop_assert!((c.inward.norm() - 1.0).abs() < 1e-12);
        prop_assert!((c.at - c.wall - c.inward * c.value).norm() < 1e-9);
    }

    #[test]
    fn overlaps_are_inside_both(polygon in star(), footprint in footprint()) {
        for p in polygon.overlap_points(&footprint) {
            prop_assert!(polygon.clearance_of_point(p).value > -1e-8);
        }
        // A dense sample of the overlap lies in the hull of the points.
        let hull = convex_hull(polygon.overlap_points(&footprint));
        for i in 0..400 {
            let p = Vec2::new(f64::from(i % 20) * 0.3 - 3.0, f64::from(i / 20) * 0.3 - 3.0);
            let within = |corners: &[Vec2]| scenelang_layout::planar::depth_in_convex(corners, p) > 1e-9;
            if polygon.contains(p) && within(&footprint) {
                prop_assert!(within(&hull) || scenelang_layout::planar::depth_in_convex(&hull, p) > -1e-9);
            }
        }
    }

    #[test]
    fn area_and_centroid_do_not_depend_on_place_or_winding(polygon in star(), x in -1e5..1e5f64, z in -1e5..1e5f64) {
        let by = Vec2::new(x, z);
        let mut moved: Vec<[f64; 2]> = polygon.corners().iter().map(|c| (c + by).into()).collect();
        moved.reverse();
        let moved = Polygon::new(&moved).unwrap();
        prop_assert!((moved.area() - polygon.area()).abs() < 1e-8);
        prop_assert!((moved.centroid() - by - polygon.centroid()).norm() < 1e-8);
    }
}

#[test]
fn why_a_polygon_is_not_simple() {
    let many: Vec<[f64; 2]> = (0..20_000).map(|i| [f64::from(i), f64::from(i * i % 7)]).collect();
    let cases: [(&[[f64; 2]], NotSimple); 8] = [
        (&[], NotSimple::TooFew(0)),
        (&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], NotSimple::TooFew(2)),
        (&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]], NotSimple::Flat),
        (&[[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [0.0, 2.0]], NotSimple::Repeated(2)),
        (&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [2.0, 1.0]], NotSimple::Spike(2)),
        (&[[-3.0, -3.0], [3.0, 3.0], [3.0, -3.0], [-3.0, 3.0]], NotSimple::Crossing(0, 2)),
        (&[[-3.0, -3.0], [0.0, 0.0], [3.0, -3.0], [3.0, 3.0], [0.0, 0.0], [-3.0, 3.0]], NotSimple::Crossing(0, 4)),
        (&many, NotSimple::TooMany(20_000)),
    ];
    for (vertices, why) in cases {
        assert_eq!(Polygon::new(vertices).unwrap_err(), why, "{why}");
    }
}

#[test]
fn a_first_vertex_may_be_repeated_at_the_end() {
    let closed = Polygon::new(&[[-3.0, -3.0], [-3.0, 3.0], [3.0, 3.0], [3.0, -3.0], [-3.0, -3.0]]).unwrap();
    assert_eq!((closed.corners().len(), closed.area()), (4, 36.0));
}

fn region(vertices: Option<Vec<[f64; 2]>>, turn: f64) -> Prism {
    let placement = RegionPlacement {
        pos: Vec3::new(0.0, 1.0, 0.0),
        rot: Vec3::new(0.0, turn, 0.0),
        scale: Vec3::new(6.0, 3.0, 4.0),
        vertices,
    };
    Prism::from_placement(&placement).unwrap()
}

fn upright(x: f64, y: f64, z: f64, size: f64) -> Obb {
    let half = Vec3::repeat(size / 2.0);
    Obb { center: Vec3::new(x, y, z), axes: rotation::matrix(Vec3::zeros()), half }
}

#[test]
fn an_inner_corner_between_the_corners_of_a_box_is_seen() {
    // An L whose inner corner is at the origin; the box straddles it, its own corners inside or outside.
    let l = region(Some(vec![[-4.0, -4.0], [4.0, -4.0], [4.0, 0.0], [0.0, 0.0], [0.0, 4.0], [-4.0, 4.0]]), 0.0);
    let turned = |x: f64, z: f64| Obb { axes: rotation::matrix(Vec3::new(0.0, 45.0, 0.0)), ..upright(x, 2.5, z, 2.0) };
    // A face of the box leads past the inner corner: outside by the distance of its farthest point from both walls.
    let poked = inside_clearance(&turned(-0.6, -0.6), &l);
    let past = 1.0 - 0.6 * 2f64.sqrt();
    assert!((poked.horizontal.value + past / 2f64.sqrt()).abs() < 1e-9, "{poked:?}");
    let beside = inside_clearance(&turned(-0.8, -0.8), &l);
    assert!((beside.horizontal.value - (0.8 * 2f64.sqrt() - 1.0)).abs() < 1e-12, "{beside:?}");
    assert_eq!(beside.horizontal.wall, Vec2::zeros());
}

#[test]
fn a_slot_through_a_box_is_seen() {
    // A slot of 20 cm from above leads right through the box.
    let slotted =
        [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [0.1, 4.0], [0.1, -2.0], [-0.1, -2.0], [-0.1, 4.0], [-4.0, 4.0]];
    let prism = region(Some(slotted.to_vec()), 0.0);
    let c = inside_clearance(&upright(0.0, 2.5, 0.0, 2.0), &prism).horizontal;
    assert!((c.value + 0.1).abs() < 1e-9, "{c:?}");
}

#[test]
fn floor_and_ceiling_count() {
    let room = region(None, 0.0);
    assert_eq!((room.area(), room.center()), (24.0, Vec3::new(0.0, 2.5, 0.0)));
    for (y, least) in [(2.5, 1.0), (1.5, 0.0), (1.4, -0.1), (3.75, -0.25)] {
        let inside = inside_clearance(&upright(0.0, y, 0.5, 1.0), &room);
        assert!((inside.least() - least).abs() < 1e-12, "{y}: {inside:?}");
    }
    // Turned by 90 degrees the room is 4 wide and 6 deep.
    let turned = region(None, 90.0);
    let c = inside_clearance(&upright(0.0, 2.5, 0.5, 1.0), &turned).horizontal;
    assert!((c.value - 1.5).abs() < 1e-12, "{c:?}");
    assert!((inside_clearance(&upright(2.0, 2.5, 0.5, 1.0), &turned).horizontal.value + 0.5).abs() < 1e-12);
}
