//! The last centimetres of a move: what is put down touches what it rests on, what is pushed to a wall stands flush with
//! it, and nothing is left at the very edge of what carries it. All of that only where the goals hold then.

use super::search::{Move, MoveSearch};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Prism, Vec2, Vec3};
use scenelang_verify::World;

/// What ends so near to a wall to which it was moved stands at it (metres).
const FLUSH: f64 = 0.06;
/// What is less than this is no distance (metres).
const TOUCHES: f64 = 1e-3;
/// So far from the edge of what carries it is something put down, if there is room (metres).
const INSIDE: [f64; 2] = [0.05, 0.02];
/// So far on is moved what would otherwise stick out over the edge (metres).
const MOST_INSIDE: f64 = 0.2;

impl MoveSearch<'_, '_> {
    /// A move at whose end the object touches what it rests on.
    pub(super) fn put_down(&mut self, m: Move) -> Move {
        if self.step(&m).by[1] == 0.0 {
            return m;
        }
        self.put(&m);
        let Some((off, _)) = self.stage.off_rest(self.from.object) else { return m };
        let exact = rounded(self.step(&m).by[1] + off) - self.from.by[1];
        let [x, _, z, turn] = m;
        let down = [x, exact, z, turn];
        if off.abs() > 1e-9 && self.holds(&down) { down } else { m }
    }

    /// A move that goes somewhat farther and ends better: flush with the wall that the object was moved to, or not at the
    /// edge of what carries it.
    pub(super) fn settled(&mut self, m: Move) -> Option<Move> {
        if self.dear || self.spent() {
            return None;
        }
        let [by_x, _, by_z] = self.step(&m).by;
        let way = Vec3::new(by_x, 0.0, by_z);
        if way.norm() < TOUCHES {
            return None;
        }
        self.put(&m);
        let carrier = self.stage.off_rest(self.from.object).and_then(|(_, carrier)| carrier);
        if let Some(carrier) = carrier.filter(|id| !self.stage.is_like_floor(*id)) {
            return self.inside_the_edge(m, carrier);
        }
        let mut at = m;
        for _ in 0..2 {
            self.put(&at);
            let Some(by) = self.to_the_wall(&way) else { break };
            let flush = [at[0] + by.x, at[1], at[2] + by.z, at[3]];
            if !self.holds(&flush) {
                break;
            }
            at = flush;
        }
        (at != m).then_some(at)
    }

    fn inside_the_edge(&mut self, m: Move, carrier: ObjectId) -> Option<Move> {
        let on = self.stage.pose(carrier)?.pos - self.stage.pose(self.from.object)?.pos;
        let [own, top] = [self.half(self.from.object)?, self.half(carrier)?];
        // As far as no part of it is over the edge, if that is not far; else a little.
        let whole = [(on.x, own.x, top.x), (on.z, own.z, top.z)].map(|(off, own, top)| {
            let over = off.abs() + own + INSIDE[1] - top;
            if over <= MOST_INSIDE { over.clamp(INSIDE[0], INSIDE[0].max(off.abs())) } else { INSIDE[0] }
        });
        [whole, [INSIDE[0]; 2], [INSIDE[1]; 2]].into_iter().find_map(|inside| {
            // Only on in the direction it came in, and not beyond the middle.
            let more = |by: f64, to: f64, inside: f64| {
                if by * to > 0.0 && to.abs() >= inside { inside.copysign(by) } else { 0.0 }
            };
            let by = [more(m[0], on.x, inside[0]), more(m[2], on.z, inside[1])];
            let inner = [m[0] + rounded(by[0]), m[1], m[2] + rounded(by[1]), m[3]];
            (inner != m && self.holds(&inner)).then_some(inner)
        })
    }

    /// Half of an object's extent along the axes of the world.
    fn half(&self, id: ObjectId) -> Option<Vec3> {
        let obb = &self.stage.world().object(id).ok()?.body.obb;
        Some(obb.axes.abs() * obb.half)
    }

    /// What is left to the wall in a direction in which the object was moved: behind it or at a side.
    fn to_the_wall(&self, way: &Vec3) -> Option<Vec3> {
        let body = &self.stage.world().object(self.from.object).ok()?.body;
        let (obb, room) = (&body.obb, room(self.stage.world(), &body.obb.center)?);
        let axis = |i: usize| -> Vec3 { obb.axes.column(i).into() };
        let sides = [(-axis(2), obb.half.z), (axis(0), obb.half.x), (-axis(0), obb.half.x), (axis(2), obb.half.z)];
        sides.into_iter().filter(|(side, _)| side.dot(way) > TOUCHES).find_map(|(side, half)| {
            let end = obb.center + side * half;
            let clearance = room.polygon.clearance_of_point(Vec2::new(end.x, end.z));
            let inward = Vec3::new(clearance.inward.x, 0.0, clearance.inward.y);
            let faces = inward.dot(&side) < -0.999 * inward.norm();
            let left = ((clearance.value * 1e4 + 1e-6).floor() / 1e4).max(0.0);
            (faces && left > TOUCHES && left <= FLUSH)
                .then(|| side.map(|c| if c.abs() < 1e-9 { 0.0 } else { c }) * left)
        })
    }
}

/// The room around a point: of the regions that hold it the largest.
fn room<'w>(world: &'w World<f64>, at: &Vec3) -> Option<&'w Prism> {
    let at = Vec2::new(at.x, at.z);
    let prisms = world.prisms().map(|(_, prism)| prism).filter(|prism| prism.polygon.contains(at));
    prisms.max_by(|a, b| a.area().total_cmp(&b.area()))
}

/// A length to the thousandth of a millimetre.
fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6 + 0.0
}
