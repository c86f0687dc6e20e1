//! `clear` on boxes: the space on a side of a thing, what reaches into it, and the room that it must stay in.

use super::rooms::RoomBox;
use super::{Span, Trial};
use scenelang_lang::program::{Formula, Node, ObjectSide};
use scenelang_verify::coded::{Block, Flat};
use scenelang_verify::{Surroundings, World, surroundings};

/// Lower than this above the base of a thing nothing is in its way (metres).
const SILL: f64 = 0.05;
/// What a `clear` says.
#[derive(Clone, Copy, Debug)]
pub struct Clear {
    /// Beside what.
    pub owner: usize,
    side: ObjectSide,
    depth: f64,
    /// A door's: how thick the wall before it may be (metres).
    wall: Option<f64>,
}

/// A space: its rectangle, and from where to where it reaches upwards.
struct Space {
    flat: Flat,
    low: f64,
    high: f64,
}

impl Space {
    pub fn span(&self) -> Span {
        let [sin, cos] = self.flat.turn.map(f64::abs);
        let ([w, d], [x, z]) = (self.flat.half, self.flat.at);
        let (rx, rz) = (cos * w + sin * d, sin * w + cos * d);
        Span { min: [x - rx, self.low, z - rz], max: [x + rx, self.high, z + rz] }
    }
}

impl Clear {
    /// What a node of a formula says, if it asks for free space of constant depth.
    pub fn of(node: &Node, formula: &Formula, doors: &[usize], world: &World<f64>) -> Option<Self> {
        let Surroundings::Space { owner, side, depth: Some(depth) } = surroundings(formula, node) else { return None };
        let door = matches!(side, ObjectSide::Front | ObjectSide::Behind) && doors.contains(&(owner.0 as usize));
        let wall = door.then_some(2.0 * world.options.eta + world.options.tolerances.door);
        Some(Self { owner: owner.0 as usize, side, depth, wall })
    }
}

impl Trial<'_> {
    /// The space; `None`: nothing is left of it.
    fn space(&self, clear: &Clear) -> Option<Space> {
        let ([w, h, d], [_, y, ..]) = (self.size[clear.owner], self.inputs(clear.owner));
        let (own, depth) = (self.flat(clear.owner), clear.depth);
        let low = y + SILL;
        let beside =
            |at: [f64; 2], half: [f64; 2]| Space { flat: Flat { at: own.point(at), half, ..own }, low, high: y + h };
        Some(match clear.side {
            ObjectSide::Front => beside([0.0, (d + depth) / 2.0], [w / 2.0, depth / 2.0]),
            ObjectSide::Behind => beside([0.0, -(d + depth) / 2.0], [w / 2.0, depth / 2.0]),
            ObjectSide::Left => beside([-(w + depth) / 2.0, 0.0], [depth / 2.0, d / 2.0]),
            ObjectSide::Right => beside([(w + depth) / 2.0, 0.0], [depth / 2.0, d / 2.0]),
            ObjectSide::Above => Space { flat: own, low: y + h, high: y + h + depth },
        })
        .filter(|space| depth > 0.0 && space.high > space.low)
    }

    /// The upright box around the space; `None`: there is none.
    pub(super) fn space_span(&self, clear: &Clear) -> Option<Span> {
        self.space(clear).map(|space| space.span())
    }

    /// What a `clear` costs, and whether it holds.
    pub(super) fn clear(&mut self, clear: &Clear) -> (f64, bool) {
        self.work += 4 + self.count() as u64 / 8;
        self.lack_of_space(clear)
    }

    /// The same, not counted as work.
    pub(super) fn lack_of_space(&self, clear: &Clear) -> (f64, bool) {
        let Some(space) = self.space(clear) else { return (0.0, true) };
        let contact = self.tolerances.contact;
        let (mut cost, mut holds) = (0.0, true);
        for (_, gap) in self.blockers(clear.owner, &space) {
            let found = self.physical(gap + contact, contact);
            (cost, holds) = (cost + found.0, holds && found.1);
        }
        if let Some(left) = self.room_left(clear, &space) {
            let found = self.physical(left + contact, contact);
            (cost, holds) = (cost + found.0, holds && found.1);
        }
        (cost, holds)
    }

    /// Other objects that reach into a space, and how far (negative, metres).
    fn blockers(&self, owner: usize, space: &Space) -> Vec<(usize, f64)> {
        let span = space.span();
        let [w, d] = space.flat.half;
        let block = [Block::new([0.0; 3], [w, (space.high - space.low) / 2.0, d])];
        let mut found = Vec::new();
        for j in (0..self.count()).filter(|&j| j != owner && self.span[j].meets(&span)) {
            let gap = self.gap_of_blocks((j, &self.flat(j)), (&block, &space.flat, (space.low + space.high) / 2.0));
            if gap < 0.0 {
                found.push((j, gap));
            }
        }
        found
    }

    /// An object that is in the way, if one is.
    pub fn in_the_way(&self, clear: &Clear) -> Vec<usize> {
        let space = self.space(clear);
        space.map_or(Vec::new(), |space| self.blockers(clear.owner, &space).into_iter().map(|(j, _)| j).collect())
    }

    /// How much is left between the space and the walls and the ceiling of its room; `None`: it is asked to stay in none.
    fn room_left(&self, clear: &Clear, space: &Space) -> Option<f64> {
        let own = self.flat(clear.owner);
        if let Some(wall) = clear.wall {
            let sign = if clear.side == ObjectSide::Front { 1.0 } else { -1.0 };
            let beyond = own.point([0.0, sign * (own.half[1] + wall)]);
            let rooms = self.rooms.iter().map(|room| (room.depth(beyond), room));
            let (_, room) = rooms.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(d, _)| *d >= -self.tolerances.contact)?;
            // The first step is still in the wall.
            let depth = clear.depth - wall;
            if depth <= 0.0 {
                return Some(room.ceiling - space.high);
            }
            let middle = own.point([0.0, sign * (own.half[1] + wall + depth / 2.0)]);
            let rest = Space { flat: Flat { at: middle, half: [own.half[0], depth / 2.0], ..own }, ..*space };
            return Some(room.aside(&rest.span(), || rest.flat).min(room.ceiling - space.high));
        }
        let span = &self.span[clear.owner];
        let key = |room: &RoomBox| {
            let aside = room.aside(span, || own);
            let least = aside.min(span.min[1] - room.floor).min(room.ceiling - span.max[1]);
            let [least, aside] = [(least + self.tolerances.contact).min(0.0), aside].map(|m| (m * 1e6).round());
            [least, aside, room.area]
        };
        let order = |a: &[f64; 3], b: &[f64; 3]| {
            a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
        };
        let room = match &self.rooms[..] {
            [room] => room,
            rooms => rooms.iter().map(|room| (key(room), room)).max_by(|a, b| order(&a.0, &b.0))?.1,
        };
        Some(room.aside(&space.span(), || space.flat).min(room.ceiling - space.high))
    }
}
