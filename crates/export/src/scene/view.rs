//! Where to look from: a raised corner, from which most of the furniture shows its front, and what hangs on walls is seen.

use super::{Body, Object, RegionKind, Role, Scene};
use crate::geometry::polygon::outward;
use nalgebra::Matrix3;
use scenelang_layout::planar::nearest_on_segment;
use scenelang_layout::{Obb, Vec2, Vec3};

/// A camera that looks at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where it stands.
    pub eye: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// Vertical angle of view, degrees.
    pub fov: f64,
}

/// The way sunlight goes, not of unit length.
pub const SUN: Vec3 = Vec3::new(-0.35, -0.85, 0.4);

/// Directions tried, degrees about y from +z; corners first, so that a bare room is seen from one.
const AZIMUTHS: [f64; 8] = [215.0, 145.0, 325.0, 35.0, 235.0, 125.0, 305.0, 55.0];
/// What is no farther than this from a wall is in it or hangs on it, metres.
const ON_WALL: f64 = 0.1;
/// What it is worth to see all fronts, and all that hangs on walls; a picture that is filled half is worth 1 less.
const FRONTS: f64 = 2.0;
const WALLS: f64 = 0.8;
/// What it is worth to see all that hangs on walls and is large, in square metres: what a cinema or a classroom looks at.
const LARGE: f64 = 1.5;
const LARGE_SEEN: f64 = 2.5;
/// A door or a window says less than a screen or a picture of the same size.
const OPENING: f64 = 0.3;
/// What is taller hides what stands behind it, metres.
const TALL: f64 = 1.2;
/// A face of less counts for nothing (square metres).
const SMALL: f64 = 0.1;
/// How steeply the camera looks down, degrees.
const ELEVATION: f64 = 42.0;
/// Angle of view from above, degrees: from so far away, what is tall does not lean over what stands beside it.
const STEEP: f64 = 6.0;

impl View {
    /// Its axes as columns: right, up, forward.
    pub fn axes(&self) -> Matrix3<f64> {
        let forward = (self.target - self.eye).normalize();
        // Straight down, x is to the right and z up, as in a plan.
        let right = Vec3::y().cross(&forward).try_normalize(1e-9).unwrap_or(Vec3::x());
        Matrix3::from_columns(&[right, forward.cross(&right), forward])
    }

    /// The best corner view of a scene in a picture of this width by height.
    pub fn of(scene: &Scene, aspect: f64) -> Self {
        let points = outline(scene);
        let views = AZIMUTHS.map(|azimuth| Self::towards(&points, direction(azimuth), aspect));
        let distance = |v: &Self| (v.eye - v.target).norm();
        let nearest = views.iter().map(distance).fold(f64::INFINITY, f64::min);
        let hung = hung(scene);
        let large: Vec<(f64, Vec2)> = hung.iter().copied().filter(|(area, _)| *area > LARGE).collect();
        // Fronts count, what hangs on walls that are cut away is lost, and the picture should be filled.
        let value = |v: &Self| {
            let way = (v.eye - v.target).normalize();
            let missed = WALLS * lost(&hung, way) + LARGE_SEEN * lost(&large, way);
            FRONTS * fronts_seen(scene, way) - missed - (distance(v) / nearest - 1.0)
        };
        views.into_iter().reduce(|best, v| if value(&v) > value(&best) + 1e-6 { v } else { best }).unwrap_or(views[0])
    }

    /// The view of some points from a direction, as near as they allow.
    fn towards(points: &[Vec3], way: Vec3, aspect: f64) -> Self {
        Self::framing(points, way, aspect, 28.0)
    }

    /// The same with an angle of view.
    fn framing(points: &[Vec3], way: Vec3, aspect: f64, fov: f64) -> Self {
        let middle = points.iter().sum::<Vec3>() / points.len().max(1) as f64;
        let mut view = Self { eye: middle + way, target: middle, fov };
        // The right distance moves what is in the middle, and that the right distance: a few rounds settle it.
        for _ in 0..8 {
            view.frame(points, way, aspect);
        }
        view
    }

    /// From above, straight down, in a picture of this width by height. From so far away that what is tall hides little.
    pub fn above(scene: &Scene, aspect: f64) -> Self {
        Self::framing(&outline(scene), Vec3::y(), aspect, STEEP)
    }

    /// A view from a corner of the first room, as someone who has just come in and looks across it. Without a room:
    /// the view from outside.
    pub fn within(scene: &Scene) -> Self {
        let Some(room) = scene.regions.iter().find(|r| r.kind == RegionKind::Room) else { return Self::of(scene, 1.6) };
        let prism = &room.prism;
        let middle = prism.center();
        let height = prism.ceiling - prism.floor;
        let seen = |corner: &Vec2| {
            let back = Vec3::new(corner.x - middle.x, 0.0, corner.y - middle.z);
            fronts_seen(scene, back.normalize())
        };
        let corners = prism.polygon.corners();
        let corner = corners.iter().copied().reduce(|best, c| if seen(&c) > seen(&best) + 1e-6 { c } else { best });
        let corner = corner.unwrap_or(middle.xz());
        let inwards = (middle.xz() - corner).try_normalize(1e-9).unwrap_or(Vec2::x()) * 0.35;
        Self {
            eye: Vec3::new(corner.x + inwards.x, prism.floor + 0.72 * height, corner.y + inwards.y),
            target: Vec3::new(middle.x, prism.floor + 0.25 * height, middle.z),
            fov: 70.0,
        }
    }

    /// Centres the points and backs off until they fit.
    fn frame(&mut self, points: &[Vec3], way: Vec3, aspect: f64) {
        self.eye = self.target + way;
        let axes = self.axes();
        let slope_y = (self.fov / 2.0).to_radians().tan() * 0.94;
        let slope_x = slope_y * aspect;
        let seen = |p: &Vec3| axes.tr_mul(&(p - self.target));
        let distance =
            points.iter().map(seen).map(|p| (p.x.abs() / slope_x).max(p.y.abs() / slope_y) - p.z).fold(1.0, f64::max);
        let spread = |axis: usize| {
            let slopes = points.iter().map(seen).map(|p| p[axis] / (p.z + distance));
            let (lo, hi) = slopes.fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
            (lo + hi) / 2.0 * distance
        };
        if !points.is_empty() {
            self.target += axes.column(0) * spread(0) + axes.column(1) * spread(1);
        }
        self.eye = self.target + way * distance;
    }
}

/// From the scene towards the eye.
fn direction(azimuth: f64) -> Vec3 {
    let (a, e) = (azimuth.to_radians(), ELEVATION.to_radians());
    Vec3::new(a.sin() * e.cos(), e.sin(), a.cos() * e.cos())
}

/// Families that look alike from all sides, or whose front says nothing.
const FRONTLESS: [&str; 10] =
    ["theatre_seat", "table", "desk", "door", "window", "plant", "lamp", "rug", "stool", "box"];

/// How well an eye in this direction sees the objects: their fronts, large ones counting more, and large things rather
/// behind small ones than before them. Between about −1 and 1.
pub(super) fn fronts_seen(scene: &Scene, way: Vec3) -> f64 {
    // What is tall and turns its back hides the most; of a bed the whole top is seen, or the headboard. By the root, or
    // one shelf would outweigh all that a bathroom is for; what is small says nothing about where to look from.
    let face = |o: &Object| {
        let area = match o.family.as_str() {
            "bed" | "crib" => 6.0 * o.place.scale.x * o.place.scale.z,
            "sofa" => 3.0 * o.place.scale.x * o.place.scale.z,
            // Seen if its wall is.
            "door" | "window" => 0.0,
            // Many, and turned all ways.
            "chair" | "stool" | "theatre_seat" => 0.1 * o.place.scale.x * o.place.scale.y,
            _ if o.place.scale.y > TALL => 1.4 * o.place.scale.x * o.place.scale.y,
            _ => o.place.scale.x * o.place.scale.y,
        };
        if area < SMALL { area } else { area.sqrt() }
    };
    let all: f64 = scene.objects.iter().map(face).sum::<f64>().max(1e-9);
    let middle = scene.objects.iter().map(|o| o.place.pos * face(o)).sum::<Vec3>() / all;
    let spread = scene.objects.iter().map(|o| (o.place.pos - middle).norm()).fold(1.0, f64::max);
    let value = |o: &Object| {
        let front = if FRONTLESS.contains(&o.family.as_str()) { 0.0 } else { o.axes.column(2).dot(&way) };
        let nearness = (o.place.pos - middle).dot(&way) / spread;
        face(o) * (front - 0.7 * nearness)
    };
    scene.objects.iter().map(value).sum::<f64>() / all
}

/// Whether an object is in a wall or hangs on it; the wall runs along an edge of a floor. What hangs in a corner of a room
/// also touches the wall beside it, which is not the one that it has at its back.
pub fn hangs_on(object: &Object, from: Vec2, to: Vec2) -> bool {
    let near = |p: Vec2| (nearest_on_segment(&p, &from, &to) - p).norm() <= ON_WALL;
    let place = Obb::from_placement(&object.place);
    let faces_away = || outward(from, to).dot(&object.axes.column(2).xz()).abs() > 0.7;
    object.body != Body::Free
        && (near(place.center.xz()) || (faces_away() && place.corners().iter().any(|c| near(c.xz()))))
}

/// What is in walls or hangs on them: the weight of each, which is its area, and the way out through its wall.
fn hung(scene: &Scene) -> Vec<(f64, Vec2)> {
    let walls = || {
        scene.shells.iter().filter_map(|s| match s.role {
            Role::Wall { from, to } => Some((from, to)),
            _ => None,
        })
    };
    let of = |o: &Object| {
        let (from, to) = walls().find(|(from, to)| hangs_on(o, *from, *to))?;
        let weight = if matches!(o.family.as_str(), "door" | "window") { OPENING } else { 1.0 };
        Some((weight * o.place.scale.x * o.place.scale.y, outward(from, to)))
    };
    scene.objects.iter().filter_map(of).collect()
}

/// How much of it is on walls between the room and an eye in this direction, which are cut away: 0 to 1.
fn lost(hung: &[(f64, Vec2)], way: Vec3) -> f64 {
    let all: f64 = hung.iter().map(|(area, _)| area).sum();
    hung.iter().filter(|(_, out)| out.dot(&way.xz()) > 0.0).map(|(area, _)| area).sum::<f64>() / all.max(1e-9)
}

/// Points that must be in the picture.
fn outline(scene: &Scene) -> Vec<Vec3> {
    let mut out = Vec::new();
    for region in &scene.regions {
        let walls = if region.kind == RegionKind::Room { region.prism.ceiling } else { region.prism.floor };
        for c in region.prism.polygon.corners() {
            out.extend([region.prism.floor, walls].map(|y| Vec3::new(c.x, y, c.y)));
        }
    }
    for object in &scene.objects {
        out.extend(Obb::from_placement(&object.place).corners());
    }
    out
}
