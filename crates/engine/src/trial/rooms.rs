//! Rooms as a trial sees them: an outline, walls with the way in, and where doors fit into walls.

use super::Span;
use crate::pose::round_turn;
use scenelang_lang::program::RegionId;
use scenelang_layout::{Polygon, Prism, Vec2};
use scenelang_verify::World;
use scenelang_verify::coded::Flat;
use std::sync::Arc;

/// Walls of two rooms no further apart than this share a door (metres).
const SHARED: f64 = 0.2;
/// A rectangle on the floor, by its least and greatest x and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The least x and z (metres).
    pub min: [f64; 2],
    /// The greatest.
    pub max: [f64; 2],
}

impl Field {
    fn of(polygon: &Polygon) -> Option<Self> {
        let low = polygon.corners().iter().copied().reduce(|a, b| a.inf(&b))?;
        let high = polygon.corners().iter().copied().reduce(|a, b| a.sup(&b))?;
        Some(Self { min: low.into(), max: high.into() })
    }
    /// What two share.
    pub fn meet(self, other: Self) -> Self {
        let least = |k: usize| self.min[k].max(other.min[k]);
        let most = |k: usize| self.max[k].min(other.max[k]);
        Self { min: [least(0), least(1)], max: [most(0), most(1)] }
    }
    /// The least one around two.
    pub fn join(self, other: Self) -> Self {
        let least = |k: usize| self.min[k].min(other.min[k]);
        let most = |k: usize| self.max[k].max(other.max[k]);
        Self { min: [least(0), least(1)], max: [most(0), most(1)] }
    }
    /// Whether another is within it.
    pub fn contains(&self, other: &Self) -> bool {
        (0..2).all(|k| self.min[k] <= other.min[k] && self.max[k] >= other.max[k])
    }
    /// Its four sides.
    pub fn walls(&self) -> Vec<Wall> {
        let ([a, b], [c, d]) = (self.min, self.max);
        let corners = [[a, b], [c, b], [c, d], [a, d]];
        (0..4).filter_map(|k| Wall::new(corners[k], corners[(k + 1) % 4])).collect()
    }
}

/// A side of a room.
#[derive(Clone, Copy, Debug)]
pub struct Wall {
    /// Where it begins (metres).
    pub from: [f64; 2],
    /// The unit vector along it.
    pub along: [f64; 2],
    /// The unit vector into the room.
    pub inward: [f64; 2],
    /// How long it is (metres).
    pub length: f64,
    /// The yaw of what has its back to it (degrees).
    pub yaw: f64,
}

impl Wall {
    fn new(a: [f64; 2], b: [f64; 2]) -> Option<Self> {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        // Outlines run from x towards z, the inside on the positive side.
        let inward = [-along[1], along[0]];
        let yaw = round_turn(inward[0].atan2(inward[1]).to_degrees());
        (length > 0.0).then_some(Self { from: a, along, inward, length, yaw })
    }
    /// A point so far along and so far inside.
    pub fn point(&self, along: f64, inside: f64) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + self.along[k] * along + self.inward[k] * inside)
    }
    /// How far it is from a point.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        let nearest = self.point(self.shadow(p).clamp(0.0, self.length), 0.0);
        (p[0] - nearest[0]).hypot(p[1] - nearest[1])
    }
    /// How far along a point is.
    pub fn shadow(&self, p: [f64; 2]) -> f64 {
        (p[0] - self.from[0]) * self.along[0] + (p[1] - self.from[1]) * self.along[1]
    }
}

/// A region.
#[derive(Clone, Debug)]
pub struct RoomBox {
    pub id: RegionId,
    /// The rectangle around it.
    pub field: Field,
    /// Height of the floor (metres).
    pub floor: f64,
    /// Height of the ceiling (metres).
    pub ceiling: f64,
    /// Its area (m²).
    pub area: f64,
    /// Its outline, unless that is the field.
    pub outline: Option<Arc<Polygon>>,
    /// Its sides.
    pub walls: Vec<Wall>,
}

impl RoomBox {
    /// That of a prism; `None`: it has no corners.
    pub fn new(id: RegionId, prism: &Prism) -> Option<Self> {
        let field = Field::of(&prism.polygon)?;
        let area = prism.area();
        let whole = (area - (field.max[0] - field.min[0]) * (field.max[1] - field.min[1])).abs() < 1e-9;
        let walls = prism.polygon.edges().filter_map(|(a, b)| Wall::new(a.into(), b.into())).collect();
        let outline = (!whole).then(|| Arc::new(prism.polygon.clone()));
        Some(Self { id, field, floor: prism.floor, ceiling: prism.ceiling, area, outline, walls })
    }

    /// The least of three clearances of an upright box: from the walls, above the floor, below the ceiling (metres).
    pub fn clearance(&self, span: &Span, flat: impl FnOnce() -> Flat) -> f64 {
        self.aside(span, flat).min(span.min[1] - self.floor).min(self.ceiling - span.max[1])
    }

    /// The clearance from the walls (metres).
    pub fn aside(&self, span: &Span, flat: impl FnOnce() -> Flat) -> f64 {
        let field = &self.field;
        let x = (span.min[0] - field.min[0]).min(field.max[0] - span.max[0]);
        let z = (span.min[2] - field.min[1]).min(field.max[1] - span.max[2]);
        match &self.outline {
            None => x.min(z),
            Some(outline) => flat().clearance(outline),
        }
    }

    /// How deep a point is in it, negative outside (metres; outside of a rectangle, along its axes).
    pub fn depth(&self, [x, z]: [f64; 2]) -> f64 {
        let field = &self.field;
        match &self.outline {
            None => (x - field.min[0]).min(field.max[0] - x).min(z - field.min[1]).min(field.max[1] - z),
            Some(outline) => outline.clearance_of_point(Vec2::new(x, z)).value,
        }
    }
}

/// A stretch of wall that a door fits into: where its middle can be, and the yaws that it may have.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Where.
    pub wall: Wall,
    /// How far behind the wall's face the middle of the door is (metres).
    pub behind: f64,
    /// Height of the floor.
    pub floor: f64,
}

/// The stretches of the walls of one room, or of those that two share.
pub fn stretches(world: &World<f64>, first: &RoomBox, second: Option<&RoomBox>) -> Vec<Stretch> {
    let Some(second) = second else {
        let behind = world.options.eta / 2.0;
        return first.walls.iter().map(|&wall| Stretch { wall, behind, floor: first.floor }).collect();
    };
    let mut found = Vec::new();
    for wall in &first.walls {
        for other in &second.walls {
            let opposite = wall.along[0] * other.along[0] + wall.along[1] * other.along[1] < -0.999;
            let way = [other.from[0] - wall.from[0], other.from[1] - wall.from[1]];
            let apart = -(way[0] * wall.inward[0] + way[1] * wall.inward[1]);
            if !opposite || !(-0.01..SHARED).contains(&apart) {
                continue;
            }
            let from = wall.shadow(other.point(other.length, 0.0)).max(0.0);
            let to = wall.shadow(other.from).min(wall.length);
            if to > from {
                let part = Wall { from: wall.point(from, 0.0), length: to - from, ..*wall };
                found.push(Stretch { wall: part, behind: apart / 2.0, floor: first.floor });
            }
        }
    }
    found
}
