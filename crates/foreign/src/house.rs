//! What is known of a house, whoever wrote the file: in the frame of a layout (left-handed, y up, metres).

use crate::cursor::Rest;
use crate::names;
use nalgebra::Matrix3;
use scenelang_lang::library::usual_size;
use scenelang_lang::nouns::{Stands, ending};
use scenelang_layout::{Polygon, Vec2, Vec3};
use std::collections::BTreeMap;

/// The height of the rooms of a house of which nobody says any.
const HEIGHT: f64 = 2.6;

#[derive(Debug, Default)]
pub(crate) struct House {
    pub rooms: Vec<HouseRoom>,
    pub openings: Vec<Opening>,
    pub things: Vec<HouseObject>,
    /// What the file says besides.
    pub rest: Rest,
    /// What was filled in or left out: what, and of which things.
    pub open: BTreeMap<Open, Vec<String>>,
}

/// What a file leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Open {
    /// The size is the usual one.
    Usual,
    /// No size is known: left out.
    Sizeless,
    /// The place of an opening in its wall: left out.
    Nowhere,
}

impl House {
    /// The height of a room of which nobody says it: that of the highest of the others.
    pub fn usual_height(&self) -> f64 {
        self.rooms.iter().filter_map(|room| room.height).reduce(f64::max).unwrap_or(HEIGHT)
    }

    /// How often a corner of a room would be looked at.
    pub fn work(&self) -> usize {
        let corners: usize = self.rooms.iter().map(|room| room.corners.len()).sum();
        corners.saturating_mul(self.things.len() + self.openings.len())
    }

    pub fn note(&mut self, what: Open, whose: impl Into<String>) {
        self.open.entry(what).or_default().push(whose.into());
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct HouseRoom {
    /// What the file calls it.
    pub id: String,
    /// What it is: "living room".
    pub kind: String,
    /// Corners of the floor, x and z.
    pub corners: Vec<[f64; 2]>,
    /// Height of the floor.
    pub floor: f64,
    /// `None`: nobody says it.
    pub height: Option<f64>,
    /// The floor, when all is read.
    pub polygon: Option<Polygon>,
}

impl HouseRoom {
    /// What is there when all is read.
    pub fn finish(&mut self) {
        self.height = self.height.filter(|height| *height > 0.0);
        self.polygon = Polygon::new(&self.corners).ok();
    }

    /// Whether a segment lies on its outline: both ends and the middle.
    pub fn has_wall(&self, segment: &[Vec2; 2]) -> bool {
        const NEAR: f64 = 0.06;
        let corner = |i: usize| Vec2::from(self.corners[i % self.corners.len()]);
        let middle = (segment[0] + segment[1]) / 2.0;
        let on = |p: Vec2| (0..self.corners.len()).any(|i| from_edge(p, corner(i), corner(i + 1)) <= NEAR);
        [segment[0], middle, segment[1]].into_iter().all(on)
    }

    /// Whether a point is over its floor, or within some millimetres of it.
    pub fn holds(&self, p: Vec2) -> bool {
        self.polygon.as_ref().is_some_and(|polygon| polygon.clearance_of_point(p).value >= -0.005)
    }
}

fn from_edge(p: Vec2, a: Vec2, b: Vec2) -> f64 {
    let along = b - a;
    let t = if along.norm_squared() > 0.0 { ((p - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
    (p - a - along * t).norm()
}

/// A door or a window.
#[derive(Clone, Debug)]
pub(crate) struct Opening {
    pub id: String,
    pub is_window: bool,
    /// Its ends, seen from above.
    pub segment: [Vec2; 2],
    /// Height of its lower edge, and its own height.
    pub bottom: f64,
    pub height: f64,
    /// The rooms that the file names, by index.
    pub rooms: Vec<usize>,
}

/// How a thing is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    Stands,
    Wall,
    Ceiling,
}

/// A thing.
#[derive(Clone, Debug)]
pub(crate) struct HouseObject {
    pub id: String,
    pub category: String,
    /// The file or the model that it is.
    pub asset: String,
    /// The middle of its box.
    pub center: Vec3,
    /// Its right, up and front as columns.
    pub axes: Matrix3<f64>,
    /// Width, height, depth.
    pub size: Vec3,
    /// Whether that is only what is usual.
    pub is_usual: bool,
    /// The room that the file names.
    pub room: Option<usize>,
    /// The thing that the file says it is on or in.
    pub parent: Option<usize>,
    pub holds: Holds,
}

impl HouseObject {
    /// The middle of the lower face of its box.
    pub fn base(&self) -> Vec3 {
        self.center - self.axes.column(1) * (self.size.y / 2.0)
    }

    /// The height of its highest point.
    pub fn top(&self) -> f64 {
        self.center.y + self.half_height()
    }

    /// The height of its lowest point.
    pub fn bottom(&self) -> f64 {
        self.center.y - self.half_height()
    }

    fn half_height(&self) -> f64 {
        (0..3).map(|k| (self.axes[(1, k)] * self.size[k] / 2.0).abs()).sum()
    }
}

/// The size that things of a category usually have.
pub(crate) fn usual(category: &str) -> Option<Vec3> {
    usual_size(category).map(Vec3::from)
}

/// The size of a thing whose category usually has this one and whose middle is so high. One that could stand on the floor does:
/// it is as high as that makes it.
pub(crate) fn standing(usual: Vec3, middle: f64, floor: f64) -> Vec3 {
    let height = 2.0 * (middle - floor);
    // One that is lower than usual cannot be anywhere else.
    if (0.01..1.7 * usual.y).contains(&height) { Vec3::new(usual.x, height, usual.z) } else { usual }
}

/// What things of a category hang from, if they do; what a file says counts before this.
pub(crate) fn usually(category: &str, bottom: f64, floor: f64) -> Holds {
    // A thing that stands on the floor hangs from nothing.
    if bottom <= floor + 0.05 {
        return Holds::Stands;
    }
    match ending(&names::category(category)).map(|noun| noun.stands) {
        Some(Stands::Wall) => Holds::Wall,
        Some(Stands::Ceiling) => Holds::Ceiling,
        _ => Holds::Stands,
    }
}

/// Whether others stand on things of a category as if it were the floor.
pub(crate) fn is_flat(category: &str) -> bool {
    ending(&names::category(category)).is_some_and(|noun| noun.stands == Stands::Flat)
}
