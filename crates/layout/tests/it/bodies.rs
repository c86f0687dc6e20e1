//! The signed gap of boxes and polyhedra against what proves it: a slab from below, points or all directions from above.

use nalgebra::Matrix3;
use proptest::prelude::*;
use scenelang_layout::{Convex, Geometry, Obb, Part, Placement, Separation, Vec3, convex, obb, rotation};

/// Coarse values make faces parallel, edges parallel and bodies flush; fine ones make none of that.
fn number(range: f64) -> impl Strategy<Value = f64> {
    prop_oneof![(-4i32..=4).prop_map(move |i| f64::from(i) * range / 4.0), -range..range]
}

fn vector(range: f64) -> impl Strategy<Value = Vec3> {
    (number(range), number(range), number(range)).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn turned() -> impl Strategy<Value = Vec3> {
    prop_oneof![vector(180.0), Just(Vec3::zeros()), number(180.0).prop_map(|y| Vec3::new(0.0, y, 0.0))]
}

fn sizes() -> impl Strategy<Value = Vec3> {
    vector(1.0).prop_map(|v| v.map(|x| x.abs().max(0.05)))
}

fn boxes() -> impl Strategy<Value = Obb> {
    (vector(1.0), turned(), sizes()).prop_map(|(center, rot, size)| Obb {
        center,
        axes: rotation::matrix(rot),
        half: size / 2.0,
    })
}

fn hulls() -> impl Strategy<Value = Convex> {
    prop::collection::vec(vector(0.5), 4..14).prop_filter_map("flat", |points| Convex::from_hull(&points))
}

fn bodies() -> impl Strategy<Value = Convex> {
    let cylinder = (sizes(), turned())
        .prop_map(|(s, rot)| Convex::from_cylinder(&Vec3::zeros(), &rotation::matrix(rot), s.x / 2.0, s.y));
    let body = prop_oneof![boxes().prop_map(|b| Convex::from_box(&b)), cylinder, hulls()];
    (body, turned(), vector(1.2)).prop_map(|(body, rot, by)| body.moved(&rotation::matrix(rot), &by))
}

/// Directions in all the sphere, evenly, and along the axes.
fn directions() -> impl Iterator<Item = Vec3> {
    let n = 1500;
    let spiral = (0..n).map(move |i| {
        let y = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(n);
        let (s, c) = (f64::from(i) * 2.399_963).sin_cos();
        Vec3::new(c * (1.0 - y * y).sqrt(), y, s * (1.0 - y * y).sqrt())
    });
    spiral.chain([Vec3::x(), -Vec3::x(), Vec3::y(), -Vec3::y(), Vec3::z(), -Vec3::z()])
}

/// How far `p` is outside of a body, by its faces.
fn outside(body: &Convex, p: &Vec3) -> f64 {
    let height = |f: &scenelang_layout::Face| f.normal.dot(&(p - body.face_corners(f).next().unwrap()));
    body.faces().iter().map(height).fold(f64::NEG_INFINITY, f64::max)
}

fn check(a: &Convex, b: &Convex, s: &Separation, precision: f64) -> Result<(), TestCaseError> {
    let slab = |n: &Vec3| -a.support_height(n) - b.support_height(&-n);
    prop_assert!((s.normal.norm() - 1.0).abs() < 1e-12);
    prop_assert!((slab(&s.normal) - s.gap).abs() < 1e-9, "attained: {} {}", slab(&s.normal), s.gap);
    for n in directions() {
        prop_assert!(slab(&n) <= s.gap + precision, "{n} gives {}, more than {}", slab(&n), s.gap);
    }
    // Points of both bodies that are the gap apart prove the rest.
    let (p, q) = a.contact(b, s);
    prop_assert!(outside(a, &p) < 1e-6 && outside(b, &q) < 1e-6, "{} {} {s:?}", outside(a, &p), outside(b, &q));
    prop_assert!((q - p - s.normal * s.gap).norm() < 1e-9);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn boxes_have_the_gap_that_their_faces_prove(a in boxes(), b in boxes()) {
        let s = obb::separation(&a, &b);
        check(&Convex::from_box(&a), &Convex::from_box(&b), &s, 1e-10)?;
        let back = obb::separation(&b, &a);
        prop_assert!((back.gap - s.gap).abs() < 1e-12);
    }

    #[test]
    fn upright_boxes_have_the_gap_that_their_faces_prove(
        [a, b] in [boxes(), boxes()],
        turns in prop::array::uniform2(prop_oneof![Just(0.0), Just(90.0), -180.0..180.0]),
    ) {
        let upright = |o: Obb, turn: f64| Obb { axes: rotation::matrix(Vec3::y() * turn), ..o };
        let (a, b) = (upright(a, turns[0]), upright(b, turns[1]));
        let s = obb::separation(&a, &b);
        check(&Convex::from_box(&a), &Convex::from_box(&b), &s, 1e-10)?;
        prop_assert!((obb::separation(&b, &a).gap - s.gap).abs() < 1e-12);
    }

    #[test]
    fn polyhedra_have_the_gap_that_their_faces_prove(a in bodies(), b in bodies()) {
        let s = convex::separation(&a, &b);
        check(&a, &b, &s, 1e-7)?;
        prop_assert!((convex::separation(&b, &a).gap - s.gap).abs() < 3e-7);
    }

    #[test]
    fn boxes_as_hulls_have_the_gap_of_boxes(a in boxes(), b in boxes()) {
        let hull = |o: &Obb| Convex::from_hull(&o.corners()).unwrap();
        let (x, y) = (obb::separation(&a, &b).gap, convex::separation(&hull(&a), &hull(&b)).gap);
        prop_assert!((x - y).abs() < 3e-7, "{x} {y}");
    }

    #[test]
    fn what_is_left_out_of_solids_changes_no_bit(
        a in prop::collection::vec(bodies(), 1..7),
        b in prop::collection::vec(bodies(), 1..7),
        far in 0.0..4.0,
    ) {
        let away: Vec<Convex> = b.iter().map(|body| body.moved(&Matrix3::identity(), &(Vec3::x() * far))).collect();
        let mut pairs: Vec<(f64, [usize; 2])> = Vec::new();
        for (i, x) in a.iter().enumerate() {
            pairs.extend(away.iter().enumerate().map(|(j, y)| (x.aabb().distance(y.aabb()), [i, j])));
        }
        pairs.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        let all = pairs.iter().map(|(_, [i, j])| (convex::separation(&a[*i], &away[*j]), [*i, *j]));
        let (separation, parts) = all.reduce(|best, next| if next.0.gap < best.0.gap { next } else { best }).unwrap();
        let found = convex::nearest(&a, &away).unwrap();
        // Bodies that overlap by as much are equal, whichever is told.
        if separation.gap > 0.0 {
            prop_assert_eq!((found.separation, found.parts), (separation, parts));
        }
        prop_assert_eq!(found.separation.gap, separation.gap);
    }

    #[test]
    fn hulls_hold_their_points_and_nothing_more(points in prop::collection::vec(vector(2.0), 4..60)) {
        let Some(hull) = Convex::from_hull(&points) else { return Ok(()) };
        for p in &points {
            prop_assert!(outside(&hull, p) < 1e-6);
        }
        for v in hull.vertices() {
            prop_assert!(points.iter().any(|p| (p - v).norm() < 1e-7));
        }
        for f in hull.faces() {
            let heights = hull.face_corners(f).map(|c| c.dot(&f.normal) - hull.support_height(&f.normal));
            prop_assert!(heights.into_iter().all(|h| h.abs() < 1e-6));
        }
    }

    #[test]
    fn contact_points_give_the_rate_of_change(
        a in bodies(), b in bodies(), spin in vector(1.0), way in vector(1.0),
    ) {
        // Move b a little: about the origin, and along.
        let motion = |t: f64| b.moved(&rotation::matrix(spin * t), &(way * t));
        let s = convex::separation(&a, &b);
        let (_, q) = a.contact(&b, &s);
        // Between the quotients on either side, which differ where another feature takes over; and where one does so
        // very near, with a smaller step. GJK's gaps are good to 1e-7, which the quotient magnifies.
        let fits = |h: f64| {
            let velocity = (rotation::matrix(spin * h) * q - rotation::matrix(spin * -h) * q) / (2.0 * h) + way;
            let rate = s.normal.dot(&velocity);
            let ahead = (convex::separation(&a, &motion(h)).gap - s.gap) / h;
            let behind = (s.gap - convex::separation(&a, &motion(-h)).gap) / h;
            let slack = 2e-3 + 2e-7 * s.gap.max(0.0) / h;
            rate > ahead.min(behind) - slack && rate < ahead.max(behind) + slack
        };
        prop_assert!([1e-5, 1e-6, 1e-4].into_iter().any(fits), "{s:?} at {q}");
    }
}

fn obb(center: [f64; 3], size: [f64; 3], rot: [f64; 3]) -> Obb {
    Obb { center: Vec3::from(center), axes: rotation::matrix(Vec3::from(rot)), half: Vec3::from(size) / 2.0 }
}

#[test]
fn gaps_known_by_hand() {
    let unit = obb([0.0; 3], [1.0; 3], [0.0; 3]);
    let diagonal = 2f64.sqrt() / 2.0;
    let cases = [
        (obb([1.0, 0.0, 0.0], [1.0; 3], [0.0; 3]), 0.0),
        (obb([1.25, 0.3, 0.0], [1.0; 3], [0.0; 3]), 0.25),
        (obb([0.9, 0.0, 0.0], [1.0; 3], [0.0; 3]), -0.1),
        (obb([0.0; 3], [0.2; 3], [0.0; 3]), -0.6),
        // Corner to corner, edge to edge, edge to face.
        (obb([2.0, 2.0, 2.0], [1.0; 3], [0.0; 3]), 3f64.sqrt()),
        (obb([2.0, 2.0, 0.0], [1.0; 3], [0.0; 3]), 2f64.sqrt()),
        (obb([2.0, 0.0, 0.0], [1.0; 3], [0.0, 45.0, 0.0]), 1.5 - diagonal),
        // Crossed edges: one box on its edge along z, the other on its edge along x.
        (obb([0.0, 0.5 + diagonal - 0.05, 0.0], [1.0; 3], [0.0, 0.0, 45.0]), -0.05),
        // Far away nothing is lost.
        (obb([1e6, 0.0, 0.0], [1.0; 3], [0.0; 3]), 999_999.0),
    ];
    for (b, gap) in cases {
        assert!((obb::separation(&unit, &b).gap - gap).abs() < 1e-12, "{b:?} {:?}", obb::separation(&unit, &b));
    }
}

#[test]
fn a_box_on_its_edge_over_another_crossed() {
    let a = obb([0.0; 3], [1.0; 3], [45.0, 0.0, 0.0]);
    for lift in [0.3, 0.0, -0.2] {
        let b = obb([0.0, 2f64.sqrt() + lift, 0.0], [1.0; 3], [0.0, 0.0, 45.0]);
        let s = obb::separation(&a, &b);
        assert!((s.gap - lift).abs() < 1e-12 && (s.normal - Vec3::y()).norm() < 1e-9, "{s:?}");
    }
}

fn placement(parts: Vec<Part>) -> Placement {
    Placement {
        pos: Vec3::new(1.0, 0.5, 2.0),
        rot: Vec3::new(0.0, 90.0, 0.0),
        scale: Vec3::new(1.0, 2.0, 0.5),
        parts,
        surface: None,
        joints: Vec::new(),
    }
}

#[test]
fn solids_are_parts_only_where_they_fill_the_box() {
    let rot = Vec3::zeros();
    let leg = |x: f64, height: f64| Part::Box {
        pos: Vec3::new(x, height / 2.0, 0.0),
        size: Vec3::new(0.2, height, 0.5),
        rot,
    };
    let good = placement(vec![leg(-0.4, 2.0), leg(0.4, 1.0)]);
    assert!(convex::parts_fill_box(&good));
    assert_eq!(convex::solid(&good, Geometry::Parts).len(), 2);
    assert_eq!(convex::solid(&good, Geometry::Box).len(), 1);
    let slightly = placement(vec![leg(-0.4, 2.001), leg(0.4, 1.0)]);
    assert!(convex::parts_fill_box(&slightly));
    let bad = placement(vec![leg(-0.4, 2.002), leg(0.4, 1.0)]);
    assert!(!convex::parts_fill_box(&bad));
    let body = &convex::solid(&bad, Geometry::Parts)[0];
    assert_eq!(body.as_box(), Some(&Obb::from_placement(&bad)));
    let flat = Part::Hull { points: vec![Vec3::zeros(); 5] };
    assert!(!convex::parts_fill_box(&placement(vec![leg(-0.4, 2.0), leg(0.4, 1.0), flat])));
    assert!(convex::parts_fill_box(&placement(Vec::new())));
}

#[test]
fn a_cylinder_is_a_24_gon_with_a_vertex_on_x() {
    let c = Convex::from_cylinder(&Vec3::zeros(), &Matrix3::identity(), 1.0, 2.0);
    assert_eq!((c.vertices().len(), c.faces().len()), (48, 26));
    assert_eq!(c.support_height(&Vec3::x()), 1.0);
    assert_eq!(c.support_height(&Vec3::z()), 1.0);
    // Flat sides: half way between two vertices it is thinner than the circle.
    let between = Vec3::new(7.5f64.to_radians().cos(), 0.0, 7.5f64.to_radians().sin());
    assert!((c.support_height(&between) - 7.5f64.to_radians().cos()).abs() < 1e-12);
    let standing = placement(vec![Part::Cylinder { pos: Vec3::y(), radius: 0.25, height: 2.0, rot: Vec3::zeros() }]);
    assert!(!convex::parts_fill_box(&standing), "it is narrower than the box");
}

#[test]
fn the_least_gap_of_solids_is_that_of_all_pairs() {
    let at = |x: f64, y: f64, r: f64| Convex::from_cylinder(&Vec3::new(x, y, 0.3), &Matrix3::identity(), r, 0.5);
    let a: Vec<Convex> = (0..4).map(|i| at(f64::from(i) * 0.7, 0.1 * f64::from(i), 0.2)).collect();
    for shift in [0.05, 0.3, 3.0] {
        let b: Vec<Convex> = (0..3).map(|i| at(shift + f64::from(i) * 1.1, 0.2, 0.3)).collect();
        let all = a.iter().flat_map(|x| b.iter().map(|y| convex::separation(x, y).gap)).fold(f64::INFINITY, f64::min);
        let nearest = convex::nearest(&a, &b).unwrap();
        assert_eq!(nearest.separation.gap, all);
        let [i, j] = nearest.parts;
        assert_eq!(convex::separation(&a[i], &b[j]), nearest.separation);
    }
    assert_eq!(convex::nearest(&a, &[]), None);
}

/// Many parts far from each other and through each other: most pairs are never looked at.
#[test]
fn the_least_gap_of_many_parts_is_that_of_all_pairs() {
    let mut state = 5_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut solid = |shift: f64| -> Vec<Convex> {
        (0..12)
            .map(|i| {
                let center = Vec3::new(shift + 2.0 * random(), random(), 2.0 * random());
                let axes = rotation::matrix(Vec3::new(0.0, 360.0 * random(), 0.0));
                let half = Vec3::new(0.02 + 0.3 * random(), 0.02 + 0.3 * random(), 0.02 + 0.3 * random());
                if i % 4 == 0 {
                    Convex::from_cylinder(&center, &axes, half.x, half.y)
                } else {
                    Convex::from_box(&Obb { center, axes, half })
                }
            })
            .collect()
    };
    for shift in [0.0, 1.0, 2.0, 2.5, 3.0, 8.0] {
        let (a, b) = (solid(0.0), solid(shift));
        let all = a.iter().flat_map(|x| b.iter().map(|y| convex::separation(x, y).gap)).fold(f64::INFINITY, f64::min);
        assert_eq!(convex::nearest(&a, &b).unwrap().separation.gap, all, "{shift}");
    }
}

#[test]
fn a_body_moved_over_another_is_as_if_it_were_new() {
    let axes = rotation::matrix(Vec3::new(10.0, 20.0, 30.0));
    let by = Vec3::new(1.0, 2.0, 3.0);
    let body = Convex::from_cylinder(&Vec3::y(), &Matrix3::identity(), 0.4, 1.0);
    let mut other = Convex::from_box(&Obb { center: Vec3::zeros(), axes, half: Vec3::repeat(1.0) });
    body.moved_over(&mut other, &axes, &by);
    assert_eq!(other, body.moved(&axes, &by));
    assert_eq!(other.aabb(), body.moved(&axes, &by).aabb());
}

#[test]
fn hulls_of_awkward_points() {
    let grid: Vec<Vec3> =
        (0..27).map(|i| Vec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)) * 0.1).collect();
    let hull = Convex::from_hull(&grid).unwrap();
    assert_eq!(hull.faces().len(), 6, "points within faces and edges do not count");
    assert!(hull.faces().iter().all(|f| f.corners.len() == 4));
    let far: Vec<Vec3> = grid.iter().map(|p| p + Vec3::repeat(1e5)).collect();
    assert!(Convex::from_hull(&far).is_some());
    assert!(Convex::from_hull(&grid[..3]).is_none());
    assert!(Convex::from_hull(&grid[..9]).is_none(), "one plane");
    assert!(Convex::from_hull(&[Vec3::zeros(), Vec3::x(), Vec3::x() * 2.0, Vec3::x() * 3.0]).is_none(), "one line");
    assert!(Convex::from_hull(&vec![Vec3::zeros(); convex::MAX_HULL_POINTS + 1]).is_none());
}
