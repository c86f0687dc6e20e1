//! Where one thing is, how it is turned, how large it is; and moving several things as one.

use nalgebra::Vector3;
pub use scenelang_layout::digits::round_to;
use scenelang_layout::{Aabb, Obb, Vec3, rotation};
use scenelang_verify::{Number, ObjectInstance, vector::V3};

/// Position, Euler triple and extents of an object or a region (metres, degrees).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Centre of the bottom face; of a region, of its floor.
    pub pos: Vec3,
    /// Euler triple.
    pub rot: Vec3,
    /// Full extents.
    pub scale: Vec3,
}

impl Pose {
    pub fn of<N: Number>(thing: &ObjectInstance<N>) -> Self {
        Self { pos: thing.pos.value(), rot: thing.rot.value(), scale: thing.scale.value() }
    }
    /// As numbers that depend on nothing.
    pub fn constant<N: Number>(&self) -> [V3<N>; 3] {
        [V3::constant(&self.pos), V3::constant(&self.rot), V3::constant(&self.scale)]
    }
    /// Whether it stands upright.
    pub fn is_upright(&self) -> bool {
        self.rot.x == 0.0 && self.rot.z == 0.0
    }
    /// The same elsewhere.
    pub fn at(self, x: f64, y: f64, z: f64) -> Self {
        Self { pos: Vec3::new(x, y, z), ..self }
    }
    /// The same, turned about the vertical through its position.
    pub fn facing(self, yaw: f64) -> Self {
        Self { rot: Vec3::new(self.rot.x, round_turn(yaw), self.rot.z), ..self }
    }
    /// Its box.
    pub fn obb(&self) -> Obb {
        let axes = rotation::matrix(self.rot);
        let half = self.scale / 2.0;
        Obb { center: self.pos + axes.column(1) * half.y, axes, half }
    }
    /// The upright box around it.
    pub fn span(&self) -> Aabb {
        self.obb().aabb()
    }
    /// How far its lowest corner is below its position.
    pub fn depth_below(&self) -> f64 {
        if self.is_upright() { 0.0 } else { self.pos.y - self.span().min.y }
    }
    /// Half its extent along a horizontal unit direction.
    pub fn reach(&self, direction: &Vec3) -> f64 {
        let axes = rotation::matrix(self.rot);
        (self.scale / 2.0).dot(&axes.tr_mul(direction).abs())
    }
    /// Where it faces.
    pub fn front(&self) -> Vec3 {
        rotation::matrix(self.rot).column(2).into()
    }
    /// Its own right.
    pub fn right(&self) -> Vec3 {
        rotation::matrix(self.rot).column(0).into()
    }
    /// How hard it is to move: metres that a degree moves the farthest point of its footprint, and what the way counts:
    /// once for what is small, up to twice for what is large, since one would rather move the nightstand than the bed.
    pub fn heft(&self) -> (f64, f64) {
        let per_degree = (self.scale.x.hypot(self.scale.z) / 2.0).max(0.1).to_radians();
        let volume: f64 = self.scale.iter().product();
        (per_degree, 1.0 + volume / (1.0 + volume))
    }
    /// Centre of its box.
    pub fn center(&self) -> Vec3 {
        self.pos + rotation::matrix(self.rot).column(1) * (self.scale.y / 2.0)
    }
}

/// The rigid motion about the vertical that takes one pose to another.
#[derive(Clone, Copy, Debug)]
pub struct Ride {
    from: Vec3,
    to: Vec3,
    turn: f64,
}

impl Ride {
    /// From a pose to the next one of the same object.
    pub fn new(from: &Pose, to: &Pose) -> Self {
        Self { from: from.pos, to: to.pos, turn: round_turn(to.rot.y - from.rot.y) }
    }
    /// Takes something else along.
    pub fn apply(&self, pose: &Pose) -> Pose {
        let way = pose.pos - self.from;
        let pos = self.to + rotation::matrix(Vec3::new(0.0, self.turn, 0.0)) * way;
        // The turn about the vertical is the last of the three, so that it adds to what is there.
        Pose { pos, rot: Vec3::new(pose.rot.x, round_turn(pose.rot.y + self.turn), pose.rot.z), ..*pose }
    }
}

/// Degrees in [0, 360), whole quarter turns exact.
pub fn round_turn(degrees: f64) -> f64 {
    let quarter = (degrees / 90.0).round() * 90.0;
    let exact = if (degrees - quarter).abs() < 1e-9 { quarter } else { degrees };
    let turned = exact.rem_euclid(360.0);
    if turned >= 360.0 { 0.0 } else { turned + 0.0 }
}

/// An angle between −180 and 180.
pub fn half_turn(degrees: f64) -> f64 {
    let turn = degrees.rem_euclid(360.0);
    if turn > 180.0 { turn - 360.0 } else { turn }
}

/// The yaw at which an object faces along a horizontal direction.
pub fn yaw_towards(way: &Vec3) -> f64 {
    round_turn(way.x.atan2(way.z).to_degrees())
}

/// Where something faces that is turned by so many degrees.
pub fn direction(yaw: f64) -> Vec3 {
    let (s, c) = rotation::sin_cos(yaw);
    Vector3::new(s, 0.0, c)
}
