//! The convex shapes that bodies consist of.

use crate::geometry::polygon::triangles;
use crate::scene::{Object, Role, Shell};
use nalgebra::Matrix3;
use scenelang_layout::convex::CYLINDER_SIDES;
use scenelang_layout::{Convex, Obb, Part, Vec2, Vec3, convex, rotation};

/// A convex shape in the frame of its body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Geom {
    /// Its form.
    pub shape: Shape,
    /// Its centre, where the form has one; else the origin.
    pub pos: Vec3,
    /// How it is turned about that.
    pub axes: Matrix3<f64>,
    /// Index of the surface that it looks like.
    pub surface: usize,
}

/// The form of a shape.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Full extents.
    Box(Vec3),
    /// About the y axis.
    Cylinder {
        /// Metres.
        radius: f64,
        /// Full height.
        height: f64,
    },
    /// Any convex body, in the frame of the body.
    Hull(Box<Convex>),
}

/// A cylinder part was verified as a prism of 24 sides within it. Where the two differ by more than this (metres), the prism
/// is written, so that what stands close to it does not begin inside of it.
const ROUND: f64 = 0.001;

impl Geom {
    fn hull(body: Convex, surface: usize) -> Self {
        Self { shape: Shape::Hull(Box::new(body)), pos: Vec3::zeros(), axes: Matrix3::identity(), surface }
    }

    fn block(obb: &Obb, surface: usize) -> Self {
        Self { shape: Shape::Box(obb.half * 2.0), pos: obb.center, axes: obb.axes, surface }
    }

    /// A body as a box where it is one.
    fn of(body: &Convex, surface: usize) -> Self {
        body.as_box().map_or_else(|| Self::hull(body.clone(), surface), |obb| Self::block(obb, surface))
    }
}

/// The parts of an object.
pub(super) fn of_object(object: &Object) -> Vec<Geom> {
    let parts = &object.place.parts;
    // Parts that do not fill the box have no say, so the solid may be another.
    let told = parts.len() == object.solid.len() && convex::parts_fill_box(&object.place);
    let geom = |(i, body): (usize, &Convex)| match parts.get(i) {
        Some(Part::Cylinder { pos, radius, height, rot }) if told && is_round(*radius) => Geom {
            shape: Shape::Cylinder { radius: *radius, height: *height },
            pos: *pos,
            axes: rotation::matrix(*rot),
            surface: object.looks[i],
        },
        _ => Geom::of(body, object.looks[i]),
    };
    object.solid.iter().enumerate().map(geom).collect()
}

/// Whether a cylinder may stand for its prism.
fn is_round(radius: f64) -> bool {
    radius * (1.0 - (std::f64::consts::PI / CYLINDER_SIDES as f64).cos()) <= ROUND
}

/// What a piece of the building stops things with.
pub(super) fn of_shell(shell: &Shell) -> Vec<Geom> {
    let surface = shell.group.surface;
    match shell.role {
        Role::Tint | Role::Skirting { .. } => Vec::new(),
        Role::Wall { .. } => {
            let slab = |s: &crate::scene::shell::Slab| Geom {
                shape: Shape::Box(s.size),
                pos: s.center,
                axes: rotation::matrix(Vec3::new(0.0, s.yaw, 0.0)),
                surface,
            };
            shell.boxes.iter().map(slab).collect()
        }
        Role::Floor | Role::Ceiling => {
            shell.pieces.iter().flat_map(|p| prisms(&p.polygon, p.low, p.high, surface)).collect()
        }
    }
}

/// Convex pieces of an upright prism: a box over a rectangle, else a prism over each triangle.
fn prisms(polygon: &[Vec2], low: f64, high: f64, surface: usize) -> Vec<Geom> {
    if let Some((center, along, size)) = rectangle(polygon) {
        let obb = Obb {
            center: Vec3::new(center.x, (low + high) / 2.0, center.y),
            axes: Matrix3::from_columns(&[
                Vec3::new(along.x, 0.0, along.y),
                Vec3::y(),
                Vec3::new(-along.y, 0.0, along.x),
            ]),
            half: Vec3::new(size.x, high - low, size.y) / 2.0,
        };
        return vec![Geom::block(&obb, surface)];
    }
    let prism = |t: [usize; 3]| {
        let points: Vec<Vec3> =
            [low, high].iter().flat_map(|&y| t.map(|i| Vec3::new(polygon[i].x, y, polygon[i].y))).collect();
        // A sliver that has no hull carries nothing either.
        Convex::from_hull(&points).map(|hull| Geom::hull(hull, surface))
    };
    triangles(polygon).into_iter().filter_map(prism).collect()
}

/// The middle, the direction of one side, and both lengths, if a polygon is a rectangle.
fn rectangle(polygon: &[Vec2]) -> Option<(Vec2, Vec2, Vec2)> {
    let [a, b, c, d] = *polygon else { return None };
    let (u, v) = (b - a, d - a);
    let along = u.try_normalize(1e-9)?;
    let square = along.dot(&v).abs() < 1e-9 && (a + c - b - d).norm() < 1e-9;
    square.then(|| ((a + c) / 2.0, along, Vec2::new(u.norm(), v.norm())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_is_one_box_or_as_many_prisms_as_triangles() {
        let turned = |p: [f64; 2]| {
            let (s, c) = 0.3_f64.sin_cos();
            Vec2::new(c * p[0] - s * p[1], s * p[0] + c * p[1])
        };
        let oblong = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]].map(turned);
        let [geom] = &prisms(&oblong, -0.03, 0.0, 7)[..] else { panic!("a rectangle is a box") };
        let Shape::Box(size) = geom.shape else { panic!("{geom:?}") };
        assert!((size - Vec3::new(4.0, 0.03, 3.0)).norm() < 1e-12);
        assert!((geom.axes.determinant() - 1.0).abs() < 1e-12);
        for corner in oblong {
            let local = geom.axes.transpose() * (Vec3::new(corner.x, 0.0, corner.y) - geom.pos);
            assert!((local.abs() - size / 2.0).norm() < 1e-12);
        }
        let l = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]].map(Vec2::from);
        assert_eq!(prisms(&l, 0.0, 1.0, 0).len(), 4);
    }

    #[test]
    fn thin_cylinders_are_round_and_thick_ones_are_what_was_verified() {
        assert!(is_round(0.1) && !is_round(0.15));
    }
}
