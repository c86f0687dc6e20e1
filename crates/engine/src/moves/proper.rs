//! Places where people put such a thing: before the middle of a desk, at the sides of a table, next to the end of a sofa with
//! the backs in line, a plant at a wall, a rug with the table on its middle.

use super::flaws::{CHAIR, stands_aside};
use super::search::{ASIDE, Move, MoveSearch};
use super::stands::LOW;
use super::walls;
use crate::Pose;
use crate::pose::{half_turn, yaw_towards};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Vec3, obb};
use scenelang_verify::explain::ObjectMove;

/// So many objects that the goals speak of are looked at.
const RELATED: usize = 6;
/// Tables so near to these are looked at, too, for seats (metres).
const TABLES: f64 = 2.0;
/// Spaces between a seat and its table (metres), of which the first that will do is taken: a chair is pushed up to it, an
/// armchair leaves room for the knees.
const BEFORE: [f64; 4] = [0.05, 0.2, 0.3, 0.4];
const KNEES: [f64; 4] = [0.3, 0.4, 0.2, 0.05];
/// Spaces between what stands side by side (metres).
pub(super) const BESIDE: [f64; 2] = [0.05, 0.2];
/// What it counts that the middles are in line and not the backs, or that a seat stands beside something instead of before a table (metres).
const SECOND: f64 = 0.5;
/// The same of fronts that are in line.
const THIRD: f64 = 0.8;
/// What a metre counts of a way to a wall: a plant is carried across a room before a bed is pushed aside.
const LIGHT: f64 = 0.01;
/// What it counts that a plant stands amid a wall and not in a corner (metres, of such a way).
const AMID: f64 = 0.1;
/// So many places at walls are looked for: in most rooms there are four corners.
const WALLS: usize = 5;
/// Places along a wall that are nearer to each other are one (metres).
const APART: f64 = 0.5;
/// What is deeper than this in something else is no place for it (metres).
const OVERLAP: f64 = 0.01;
/// What stands higher or lower than this stands on something else (metres).
const SAME_FLOOR: f64 = 0.3;

impl MoveSearch<'_, '_> {
    /// What was found in places where such things stand, the smallest move first.
    pub fn proper(mut self) -> Vec<(f64, ObjectMove)> {
        let Some(mut home) = self.stage.home(self.from.object).filter(|_| self.freedom.pos) else { return Vec::new() };
        // On the floor that it is to stand on.
        home.pos.y += self.from.by[1];
        let mut out: Vec<(f64, ObjectMove)> = Vec::new();
        let role = self.stage.role(self.from.object);
        // Each try may be dear, so what is most likely comes first.
        if walls::has_back(role, &home.scale) && walls::is_backed(&home, self.stage.world()) {
            out.extend(self.with_back_to_wall(&home));
        }
        for other in self.companions() {
            let Some(anchor) = self.stage.pose(other).filter(|a| (a.pos.y - home.pos.y).abs() < SAME_FLOOR) else {
                continue;
            };
            let spots = if self.stage.role(self.from.object) == "carpet" {
                vec![(0.0, vec![Pose { pos: level(anchor.pos, &home), ..home }])]
            } else if self.sits_at(other) {
                before(&home, &anchor, self.stage.role(other) == "desk")
            } else {
                beside(&home, &anchor, self.dear)
            };
            let aside = if !self.sits_at(other) && self.stage.role(self.from.object) == "seat" { SECOND } else { 0.0 };
            for (more, spots) in spots {
                // Of places that differ in their space only the first is enough.
                let found = spots.iter().find_map(|spot| self.reached(&home, spot));
                out.extend(found.map(|step| (self.cost(&step) + more + aside, step)));
            }
        }
        if self.from.by[1] < 0.0 {
            for spot in self.off_what_is_below(&home) {
                let found = self.reached(&home, &spot);
                out.extend(found.map(|step| (self.cost(&step), step)));
            }
        }
        if stands_aside(role, &home.scale) {
            let amid = if role == "plant" { AMID } else { 0.0 };
            let price =
                |(corner, spot): &(bool, Pose)| LIGHT * (spot.pos - home.pos).norm() + if *corner { 0.0 } else { amid };
            // To try a place may be dear: the best come first, and few of them are enough.
            let mut spots = walls::in_corners(&home, self.stage.world());
            spots.retain(|(_, spot)| self.is_free(spot));
            spots.sort_by(|a, b| price(a).total_cmp(&price(b)));
            let found = spots.iter().filter_map(|spot| Some((price(spot), self.reached(&home, &spot.1)?)));
            out.extend(found.take(WALLS).collect::<Vec<_>>());
        }
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        out
    }

    /// Places with the back to a wall, for what stands so.
    fn with_back_to_wall(&mut self, home: &Pose) -> Vec<(f64, ObjectMove)> {
        let mut spots = walls::along(home, self.stage.world());
        spots.retain(|spot| self.is_free(spot));
        let far = |spot: &Pose| (spot.pos - home.pos).norm();
        spots.sort_by(|a, b| far(a).total_cmp(&far(b)));
        let mut out: Vec<(f64, ObjectMove)> = Vec::new();
        let barred = self.is_barred();
        let mut tried: Vec<Pose> = Vec::new();
        for spot in spots {
            if out.len() >= WALLS || self.spent() {
                break;
            }
            // Each try may be dear: then not those that are as good as tried.
            let again = |other: &Pose| other.rot == spot.rot && (other.pos - spot.pos).norm() < ASIDE;
            if self.dear && (barred && far(&spot) < ASIDE || tried.iter().any(again)) {
                continue;
            }
            tried.push(spot);
            if let Some(step) = self.reached(home, &spot) {
                // Of places side by side the first is enough.
                let near = |other: &ObjectMove| (0..3).all(|i| (other.by[i] - step.by[i]).abs() < APART);
                if !out.iter().any(|(_, other)| near(other)) {
                    out.push((self.cost(&step), step));
                }
            }
        }
        out
    }

    /// What it may stand beside: what the goals speak of and, for a seat, the tables there.
    fn companions(&self) -> Vec<ObjectId> {
        let mut found = self.stage.spoken_of(&self.goals, self.from.object);
        found.truncate(RELATED);
        if self.stage.role(self.from.object) == "seat" {
            let spoken: Vec<Pose> = found.iter().filter_map(|id| self.stage.pose(*id)).collect();
            let near = |pose: &Pose| spoken.iter().any(|s| (s.pos - pose.pos).norm() <= TABLES);
            let objects = self.stage.world().bodies().map(|(id, _)| id);
            let tables: Vec<ObjectId> = objects
                .filter(|id| *id != self.from.object && self.sits_at(*id) && !found.contains(id))
                .filter(|id| self.stage.pose(*id).is_some_and(|pose| near(&pose)))
                .take(RELATED)
                .collect();
            found.extend(tables);
        }
        found
    }

    /// Places on the floor at the sides of what it stood on or was above.
    fn off_what_is_below(&self, home: &Pose) -> Vec<Pose> {
        let below = |id: &ObjectId| {
            let Some(pose) = self.stage.pose(*id).filter(|_| *id != self.from.object) else { return false };
            let by = home.pos - pose.pos;
            let meets = |way: Vec3, half: f64| by.dot(&way).abs() < half + home.reach(&way);
            let high = pose.scale.y > LOW && pose.pos.y < home.pos.y + LOW;
            high && meets(pose.front(), pose.scale.z / 2.0) && meets(pose.right(), pose.scale.x / 2.0)
        };
        let bodies = self.stage.world().bodies().map(|(id, _)| id);
        let mut out = Vec::new();
        for pose in bodies.filter(below).filter_map(|id| self.stage.pose(id)).take(RELATED) {
            let by = home.pos - pose.pos;
            for (way, half) in [(pose.front(), pose.scale.z / 2.0), (pose.right(), pose.scale.x / 2.0)] {
                for side in [way, -way] {
                    let out_by = half + home.reach(&side) + BESIDE[0] - by.dot(&side);
                    out.push(Pose { pos: level(home.pos + side * out_by, home), ..*home });
                }
            }
        }
        out
    }

    /// Whether it is a seat, and another object is what one sits at.
    fn sits_at(&self, other: ObjectId) -> bool {
        self.stage.role(self.from.object) == "seat" && matches!(self.stage.role(other), "desk" | "table" | "counter")
    }

    /// Whether nothing else stands in a place.
    fn is_free(&self, spot: &Pose) -> bool {
        let (own, world) = (self.from.object, self.stage.world());
        let there = spot.obb();
        world.bodies().all(|(id, _)| {
            let other = world.object(id).map(|thing| &thing.body.obb);
            id == own || other.is_ok_and(|other| obb::apart(other, &there, -OVERLAP))
        })
    }

    /// The move that brings it to a place, in whole centimetres if that will do, if the goals hold there.
    fn reached(&mut self, home: &Pose, spot: &Pose) -> Option<ObjectMove> {
        let turn = half_turn(spot.rot.y - home.rot.y - self.from.turn);
        if self.spent() || turn != 0.0 && !self.freedom.turn {
            return None;
        }
        let by: [f64; 3] = std::array::from_fn(|i| spot.pos[i] - home.pos[i] - self.from.by[i]);
        for grid in [100.0, 1000.0, 10_000.0] {
            let round = |x: f64| (x * grid).round() / grid + 0.0;
            let m: Move = [round(by[0]), 0.0, round(by[2]), round(turn)];
            if self.holds(&m) {
                return Some(self.step(&m));
            }
            // A way that is barred is so to the millimetre as well.
            if self.dear && self.holds_cheaply(&m) {
                return None;
            }
        }
        None
    }
}

/// Before the sides of a table, or before the front of a desk, looking at it.
fn before(seat: &Pose, table: &Pose, desk: bool) -> Vec<(f64, Vec<Pose>)> {
    let [front, right] = [table.front(), table.right()];
    let half = table.scale / 2.0;
    let sides = [(front, half.z), (-front, half.z), (right, half.x), (-right, half.x)];
    let spaces = if seat.scale.x < CHAIR { BEFORE } else { KNEES };
    let count = if desk { 1 } else { sides.len() };
    let spot = |(way, half): (Vec3, f64), space: f64| {
        let turned = seat.facing(yaw_towards(&-way));
        Pose { pos: level(table.pos + way * (half + seat.scale.z / 2.0 + space), seat), ..turned }
    };
    sides.into_iter().take(count).map(|side| (0.0, spaces.map(|space| spot(side, space)).into())).collect()
}

/// At either side of another object, the backs in line, the middles or the fronts; turned as it is, or as that is; `few`: not the
/// fronts. With each, what it counts.
fn beside(own: &Pose, other: &Pose, few: bool) -> Vec<(f64, Vec<Pose>)> {
    let [front, right] = [other.front(), other.right()];
    let mut out = Vec::new();
    for turned in [*own, own.facing(other.rot.y)] {
        let [deep, wide] = [front, right].map(|way| turned.reach(&way));
        let back = deep - other.scale.z / 2.0;
        let lines = [(back, 0.0), (0.0, SECOND), (-back, THIRD)];
        for (along, more) in lines.into_iter().take(if few { 2 } else { 3 }) {
            for side in [right, -right] {
                let spot = |space: f64| {
                    let pos = other.pos + side * (other.scale.x / 2.0 + wide + space) + front * along;
                    Pose { pos: level(pos, own), ..turned }
                };
                out.push((more, BESIDE.map(spot).into()));
            }
        }
    }
    out
}

/// A place at the height of an object.
fn level(pos: Vec3, own: &Pose) -> Vec3 {
    Vec3::new(pos.x, own.pos.y, pos.z)
}
