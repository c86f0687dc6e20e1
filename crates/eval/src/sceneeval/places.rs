//! Relations of objects to rooms and to their walls, doors, windows and ceilings, by the published thresholds.

use super::relations::{across, near, next};
use super::scene::ScoredRoom;
use super::shape::{Shape, SideTest, ease};
use super::table::Table;
use scenelang_layout::Vec2;

/// How far from a wall still counts as on it (metres).
const TOUCHING: f64 = 0.05;
/// How far beyond the walls is still in the room, and above the floor still on it (metres).
const SLACK: [f64; 2] = [0.01, 0.02];

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
    pub fn score(self, shape: &Shape, rooms: &[ScoredRoom], openings: &[&Shape]) -> f64 {
        let best = |of: &dyn Fn(&Shape) -> f64| openings.iter().map(|opening| of(opening)).fold(0.0, f64::max);
        match self {
            Self::NextToOpening => return best(&|opening| next(shape, opening)),
            Self::NearOpening => return best(&|opening| near(shape, opening)),
            Self::AcrossOpening => return best(&|opening| across(shape, opening)),
            Self::FarFromOpening => return best(&|opening| ease(shape.gap(opening), [4.0, f64::INFINITY], 0.25)),
            Self::BelowOpening => return best(&|opening| below(shape, opening)),
            _ => {}
        }
        let Some(room) = own_room(shape, rooms) else { return 0.0 };
        let points = shape.coarse();
        let center = Vec2::new(shape.obb.center.x, shape.obb.center.z);
        let off = center - (room.low + room.high) / 2.0;
        let size = room.high - room.low;
        let walls = wall_gaps(&points, room);
        match self {
            Self::Ceiling => {
                let top = points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
                ease((room.ceiling - top).abs(), [0.0, 0.01], 0.03)
            }
            Self::Corner => {
                let [(first, axis), ..] = walls;
                let other = walls.iter().find(|(_, a)| *a != axis).map_or(f64::INFINITY, |(gap, _)| *gap);
                let at = |gap| ease(gap, [0.0, 0.8], 0.25);
                at(first).min(at(other))
            }
            Self::Middle => {
                let (mean, wide) = ((size.x + size.y) / 2.0, 2.0 * shape.obb.half.x.max(shape.obb.half.z));
                let deviation = (0.5 * wide + (1.0 - wide / mean)).max(0.05);
                (-off.norm_squared() / (2.0 * deviation * deviation)).exp()
            }
            Self::OnWall if walls[0].0 < TOUCHING => ease(walls[0].0, [0.0, 0.01], 0.01),
            Self::NearWall => ease(walls[0].0, [0.0, 1.5], 0.25),
            Self::AgainstWall => ease(walls[0].0, [0.0, 0.3], 0.1),
            Self::Floor => {
                let base = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
                if base - room.floor < SLACK[1] { 1.0 } else { 0.0 }
            }
            Self::Inside if off.x.abs() <= size.x / 2.0 + SLACK[0] && off.y.abs() <= size.y / 2.0 + SLACK[0] => 1.0,
            _ => 0.0,
        }
    }
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

/// The room in whose middle a box is most, by the shares of the way to its walls.
fn own_room<'a>(shape: &Shape, rooms: &'a [ScoredRoom]) -> Option<&'a ScoredRoom> {
    let center = Vec2::new(shape.obb.center.x, shape.obb.center.z);
    let off = |room: &ScoredRoom| {
        let size = (room.high - room.low).sup(&Vec2::repeat(1e-6));
        (center - (room.low + room.high) / 2.0).component_div(&size).amax()
    };
    rooms.iter().min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// How far a box is from each wall of the rectangle around a room, and the wall's axis (0: x, 1: z), the nearest first.
fn wall_gaps(points: &[scenelang_layout::Vec3], room: &ScoredRoom) -> [(f64, usize); 4] {
    let reach = |axis: usize, from: f64, pick: fn(f64, f64) -> f64| points.iter().map(|p| p[2 * axis]).fold(from, pick);
    let highest = |axis| (room.high[axis] - reach(axis, f64::NEG_INFINITY, f64::max)).abs();
    let lowest = |axis| (room.low[axis] - reach(axis, f64::INFINITY, f64::min)).abs();
    let mut gaps = [(highest(0), 0), (lowest(0), 0), (highest(1), 1), (lowest(1), 1)];
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0));
    gaps
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::{Placement, Vec3};

    fn shape(pos: [f64; 3], scale: [f64; 3]) -> Shape {
        let (pos, rot, scale) = (Vec3::from(pos), Vec3::zeros(), Vec3::from(scale));
        Shape::new(&Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() })
    }

    /// A room of 4 m by 3 m by 2.6 m around the origin.
    fn room() -> ScoredRoom {
        ScoredRoom::rectangle([-2.0, -1.5], [2.0, 1.5], 0.0, 2.6)
    }

    fn score(place: RoomRelation, pos: [f64; 3], scale: [f64; 3]) -> f64 {
        place.score(&shape(pos, scale), &[room()], &[])
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
        close(score(RoomRelation::OnWall, [1.7, 1.0, 0.0], cube), 0.0);
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
        close(score(RoomRelation::Inside, [1.9, 0.0, 0.0], cube), 1.0);
        close(score(RoomRelation::Inside, [2.1, 0.0, 0.0], cube), 0.0);
        close(RoomRelation::Inside.score(&shape([0.0; 3], cube), &[], &[]), 0.0);
    }

    #[test]
    fn openings() {
        let window = shape([0.0, 0.9, 1.55], [1.2, 1.2, 0.1]);
        let at = |place: RoomRelation, pos| place.score(&shape(pos, [0.4; 3]), &[room()], &[&window]);
        close(at(RoomRelation::BelowOpening, [0.0, 0.0, 1.2]), 1.0);
        close(at(RoomRelation::BelowOpening, [0.0, 2.0, 1.2]), 0.0);
        close(at(RoomRelation::NextToOpening, [0.0, 1.0, 1.0]), 1.0);
        close(at(RoomRelation::AcrossOpening, [0.0, 1.0, -1.0]), 1.0);
        close(at(RoomRelation::FarFromOpening, [0.0, 1.0, -3.0]), 1.0);
        close(RoomRelation::NearOpening.score(&shape([0.0; 3], [0.4; 3]), &[room()], &[]), 0.0);
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
