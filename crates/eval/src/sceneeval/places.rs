//! Relations of objects to rooms and to their walls, doors, windows and ceilings, by the published thresholds.

use super::relations::{Thresholds, across, near, next};
use super::scene::ScoredRoom;
use super::shape::{Shape, SideTest, ease};
use super::table::Table;
use scenelang_layout::{Placement, Vec2, Vec3};

/// How far above the floor is still on it (metres).
const SLACK: f64 = 0.02;
/// How thick walls are (metres): what is against a wall is before its face.
const THICK: f64 = 0.1;
/// Walls whose directions have a greater cosine make no corner.
const SQUARE: f64 = 0.15;

/// A relation to a room or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoomRelation {
    /// Within half a metre of a door or window.
    NextToOpening,
    /// Within one and a half.
    NearOpening,
    /// Between one and a half metres and four away.
    AcrossOpening,
    /// Four metres away or more.
    FarFromOpening,
    /// Lower than it, and within a metre.
    BelowOpening,
    /// Near two walls that meet.
    Corner,
    /// Around the middle of the room.
    Middle,
    OnWall,
    /// Within one and a half metres of one.
    NearWall,
    /// Within 30 centimetres of one.
    AgainstWall,
    /// Hanging from the ceiling.
    Ceiling,
    Floor,
    Inside,
}

impl RoomRelation {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::NextToOpening,
        Self::NearOpening,
        Self::AcrossOpening,
        Self::FarFromOpening,
        Self::BelowOpening,
        Self::Corner,
        Self::Middle,
        Self::OnWall,
        Self::NearWall,
        Self::AgainstWall,
        Self::Ceiling,
        Self::Floor,
        Self::Inside,
    ];

    /// As in the table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NextToOpening => "opening-next",
            Self::NearOpening => "opening-near",
            Self::AcrossOpening => "opening-across",
            Self::FarFromOpening => "opening-far",
            Self::BelowOpening => "opening-below",
            Self::Corner => "corner",
            Self::Middle => "in-middle",
            Self::OnWall => "on-wall",
            Self::NearWall => "near-wall",
            Self::AgainstWall => "against-wall",
            Self::Ceiling => "on-ceiling",
            Self::Floor => "on-floor",
            Self::Inside => "in-room",
        }
    }

    /// What a word and an element mean; every pair means something.
    pub fn of(relation: &str, element: &str, table: &Table) -> Self {
        let kind = kind(element);
        if is_opening(element) {
            return match table.find("opening", relation) {
                Some("next") => Self::NextToOpening,
                Some("across") => Self::AcrossOpening,
                Some("far") => Self::FarFromOpening,
                Some("below") => Self::BelowOpening,
                _ => Self::NearOpening,
            };
        }
        let room = table.find("room", relation);
        match (kind, room) {
            ("ceiling", _) => Self::Ceiling,
            ("corner", _) | (_, Some("corner")) => Self::Corner,
            (_, Some("middle")) => Self::Middle,
            ("middle" | "center", _) if relation == "in" => Self::Middle,
            ("wall" | "walls", _) => match table.find("wall", relation) {
                Some("on") => Self::OnWall,
                Some("near") => Self::NearWall,
                _ => Self::AgainstWall,
            },
            ("floor", _) => Self::Floor,
            _ => Self::Inside,
        }
    }

    /// How well a box stands in the relation, 0 to 1. `openings` are the doors, or the windows, that are meant.
    pub fn score(self, shape: &Shape, rooms: &[ScoredRoom], openings: &[&Shape], thresholds: &Thresholds) -> f64 {
        let opening = |of: &dyn Fn(&Shape) -> f64| best(openings.iter().map(|opening| of(opening)));
        let wall = |of: &dyn Fn(&Shape) -> f64| best(rooms.iter().flat_map(walls).map(|wall| of(&wall)));
        let before =
            |wall: &Shape| wall.share_at(shape, SideTest { axis: 2, positive: true, beyond: true, margin: 1e-9 });
        match self {
            Self::NextToOpening => opening(&|opening| next(shape, opening)),
            Self::NearOpening => opening(&|opening| near(shape, opening, thresholds)),
            Self::AcrossOpening => opening(&|opening| across(shape, opening)),
            Self::FarFromOpening => opening(&|opening| ease(shape.gap(opening), [4.0, f64::INFINITY], 0.25)),
            Self::BelowOpening => opening(&|opening| below(shape, opening)),
            Self::OnWall => wall(&|wall| before(wall) * ease(shape.gap(wall), [0.0, 0.01], 0.01)),
            Self::AgainstWall => wall(&|wall| before(wall) * ease(shape.gap(wall), [0.0, 0.3], 0.1)),
            Self::NearWall => wall(&|wall| near(shape, wall, thresholds)),
            Self::Corner => best(rooms.iter().map(|room| corner(shape, room))),
            Self::Middle => best(rooms.iter().map(|room| middle(shape, room))),
            Self::Ceiling => best(rooms.iter().map(|room| ceiling(shape, room))),
            Self::Floor => best(rooms.iter().map(|room| {
                let stands = shape.obb.aabb().min.y - room.floor < SLACK;
                if stands { room.share_of(shape) } else { 0.0 }
            })),
            Self::Inside => best(rooms.iter().map(|room| room.share_of(shape))),
        }
    }
}

fn best(scores: impl Iterator<Item = f64>) -> f64 {
    scores.fold(0.0, f64::max)
}

/// The walls of a room, the front of each towards the room.
fn walls(room: &ScoredRoom) -> impl Iterator<Item = Shape> + '_ {
    room.outline.edges().map(|(a, b)| {
        let along = b - a;
        // The inside is on the positive side of an edge: x towards z.
        let front = Vec2::new(-along.y, along.x).normalize();
        let foot = (a + b) / 2.0 - front * (THICK / 2.0);
        Shape::new(&Placement {
            pos: Vec3::new(foot.x, room.floor, foot.y),
            rot: Vec3::new(0.0, front.x.atan2(front.y).to_degrees(), 0.0),
            scale: Vec3::new(along.norm(), room.ceiling - room.floor, THICK),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        })
    })
}

/// Near two walls that it is before at a right angle.
fn corner(shape: &Shape, room: &ScoredRoom) -> f64 {
    if room.share_of(shape) < 0.5 {
        return 0.0;
    }
    let sides: Vec<(Vec3, f64)> =
        walls(room).map(|wall| (shape.way_to(&wall).normalize(), ease(shape.gap(&wall), [0.0, 0.8], 0.25))).collect();
    let pairs = sides.iter().enumerate().flat_map(|(i, a)| sides[i + 1..].iter().map(move |b| (a, b)));
    best(pairs.filter(|((a, _), (b, _))| a.dot(b).abs() < SQUARE).map(|((_, a), (_, b))| a * b))
}

fn middle(shape: &Shape, room: &ScoredRoom) -> f64 {
    let off = Vec2::new(shape.obb.center.x, shape.obb.center.z) - (room.low + room.high) / 2.0;
    let size = room.high - room.low;
    let (mean, wide) = ((size.x + size.y) / 2.0, 2.0 * shape.obb.half.x.max(shape.obb.half.z));
    let deviation = 0.5 * wide + (1.0 - wide / mean);
    (-off.norm_squared() / (2.0 * deviation * deviation)).exp()
}

fn ceiling(shape: &Shape, room: &ScoredRoom) -> f64 {
    if room.share_of(shape) <= 0.0 {
        return 0.0;
    }
    ease((room.ceiling - shape.obb.aabb().max.y).abs(), [0.0, 0.01], 0.03)
}

/// The last word of an element: `wall` of `north_wall`.
pub fn kind(element: &str) -> &str {
    element.rsplit('_').next().unwrap_or_default()
}

/// Whether an element is a door or a window.
pub fn is_opening(element: &str) -> bool {
    matches!(kind(element), "door" | "window")
}

fn below(shape: &Shape, opening: &Shape) -> f64 {
    let side = SideTest { axis: 1, positive: false, beyond: false, margin: 10.0 };
    if opening.obb.center.y > shape.obb.center.y && opening.share_at(shape, side) > 0.0 {
        ease(shape.gap(opening), [0.0, 1.0], 0.25)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(pos: [f64; 3], scale: [f64; 3]) -> Shape {
        let (pos, rot, scale) = (Vec3::from(pos), Vec3::zeros(), Vec3::from(scale));
        Shape::new(&Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() })
    }

    /// A room of 4 m by 3 m by 2.6 m around the origin.
    fn room() -> ScoredRoom {
        ScoredRoom::rectangle([-2.0, -1.5], [2.0, 1.5], 0.0, 2.6)
    }

    fn score(place: RoomRelation, pos: [f64; 3], scale: [f64; 3]) -> f64 {
        place.score(&shape(pos, scale), &[room()], &[], &Thresholds::WIDE)
    }

    fn close(found: f64, wanted: f64) {
        assert!((found - wanted).abs() < 1e-9, "{found} is not {wanted}");
    }

    #[test]
    fn walls_and_corners() {
        let cube = [0.4; 3];
        close(score(RoomRelation::AgainstWall, [1.5, 0.0, 0.0], cube), 1.0);
        close(score(RoomRelation::AgainstWall, [1.4, 0.0, 0.0], cube), (-0.5_f64).exp());
        close(score(RoomRelation::OnWall, [1.795, 1.0, 0.0], cube), 1.0);
        close(score(RoomRelation::OnWall, [1.78, 1.0, 0.0], cube), (-0.5_f64).exp());
        close(score(RoomRelation::OnWall, [1.7, 1.0, 0.0], cube), (-0.5_f64 * 81.0).exp());
        close(score(RoomRelation::NearWall, [0.5, 0.0, 0.0], cube), 1.0);
        close(score(RoomRelation::Corner, [1.1, 0.0, 0.6], cube), 1.0);
        close(score(RoomRelation::Corner, [1.1, 0.0, 0.25], cube), (-0.5_f64).exp());
    }

    #[test]
    fn middle_floor_ceiling_and_inside() {
        let cube = [0.4; 3];
        close(score(RoomRelation::Middle, [0.0, 0.0, 0.0], cube), 1.0);
        // The deviation is half of 0.4 and what 0.4 leaves of 3.5.
        let deviation: f64 = 0.2 + 1.0 - 0.4 / 3.5;
        close(score(RoomRelation::Middle, [1.0, 0.0, 0.0], cube), (-1.0 / (2.0 * deviation * deviation)).exp());
        close(score(RoomRelation::Ceiling, [0.0, 2.2, 0.0], cube), 1.0);
        close(score(RoomRelation::Ceiling, [0.0, 2.16, 0.0], cube), (-0.5_f64).exp());
        close(score(RoomRelation::Floor, [0.0, 0.01, 0.0], cube), 1.0);
        close(score(RoomRelation::Floor, [0.0, 0.1, 0.0], cube), 0.0);
        close(score(RoomRelation::Inside, [1.9, 0.0, 0.0], cube), 0.75);
        close(score(RoomRelation::Inside, [2.1, 0.0, 0.0], cube), 0.25);
        close(RoomRelation::Inside.score(&shape([0.0; 3], cube), &[], &[], &Thresholds::WIDE), 0.0);
    }

    #[test]
    fn openings() {
        let window = shape([0.0, 0.9, 1.55], [1.2, 1.2, 0.1]);
        let at =
            |place: RoomRelation, pos| place.score(&shape(pos, [0.4; 3]), &[room()], &[&window], &Thresholds::WIDE);
        close(at(RoomRelation::BelowOpening, [0.0, 0.0, 1.2]), 1.0);
        close(at(RoomRelation::BelowOpening, [0.0, 2.0, 1.2]), 0.0);
        close(at(RoomRelation::NextToOpening, [0.0, 1.0, 1.0]), 1.0);
        close(at(RoomRelation::AcrossOpening, [0.0, 1.0, -1.0]), 1.0);
        close(at(RoomRelation::FarFromOpening, [0.0, 1.0, -3.0]), 1.0);
        close(RoomRelation::NearOpening.score(&shape([0.0; 3], [0.4; 3]), &[room()], &[], &Thresholds::WIDE), 0.0);
    }

    #[test]
    fn words_mean_places() {
        let table = Table::new();
        let cases = [
            ("against", "wall", RoomRelation::AgainstWall),
            ("mount", "north_wall", RoomRelation::OnWall),
            ("hang", "ceiling", RoomRelation::Ceiling),
            ("corner", "bedroom", RoomRelation::Corner),
            ("in", "bedroom", RoomRelation::Inside),
            ("in", "room_center", RoomRelation::Middle),
            ("front", "window", RoomRelation::NearOpening),
            ("beneath", "bay_window", RoomRelation::BelowOpening),
            ("far", "door", RoomRelation::FarFromOpening),
        ];
        for (relation, element, place) in cases {
            assert_eq!(RoomRelation::of(relation, element, &table), place, "{relation} {element}");
        }
    }
}
