//! What is taken in a room that is being furnished: boxes of things, and the space before and beside them that is kept free.
//!
//! All is in the room's own frame: x to the right, z to the back, the middle of the floor at the origin. Turns are multiples
//! of 90 degrees. Nothing here is a statement: it says where a search may begin.

use super::flood::Cells;

/// Things may be this close without being in each other's way (metres).
const TOUCH: f64 = 0.004;
/// Edge of a cell in which ways are looked for (metres).
const CELL: f64 = 0.1;
/// The most cells along a wall.
const MOST_CELLS: f64 = 400.0;
/// Half the width of a way, a cell's rounding included (metres).
const HALF_WAY: f64 = 0.40;
/// Nobody bumps into what is higher (metres).
const HEAD: f64 = 1.9;
/// What lies flat and is longer is no doormat (metres).
const MAT: f64 = 1.0;
/// Half of what one needs to pass between things (metres).
const PASS: f64 = 0.45;
/// What is kept free higher up takes no floor (metres).
const LOW: f64 = 0.5;

/// A place and a turn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// To the right.
    pub x: f64,
    /// Height of the base.
    pub y: f64,
    /// To the back.
    pub z: f64,
    /// Turn in degrees.
    pub yaw: f64,
}

impl Pose {
    /// A place that is given in the frame of this one.
    pub fn then(&self, local: &Self) -> Self {
        let (sin, cos) = self.yaw.to_radians().sin_cos();
        Self {
            x: self.x + local.x * cos + local.z * sin,
            y: self.y + local.y,
            z: self.z - local.x * sin + local.z * cos,
            yaw: (self.yaw + local.yaw).rem_euclid(360.0),
        }
    }
}

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Least x, y, z.
    pub low: [f64; 3],
    /// Greatest x, y, z.
    pub high: [f64; 3],
}

impl Block {
    /// The box around a thing of a size that stands at a place.
    pub fn of(pose: &Pose, size: [f64; 3]) -> Self {
        let (sin, cos) = pose.yaw.to_radians().sin_cos();
        let half = [(size[0] * cos).abs() + (size[2] * sin).abs(), (size[0] * sin).abs() + (size[2] * cos).abs()];
        let [across, along] = half.map(|v| v / 2.0);
        Self {
            low: [pose.x - across, pose.y, pose.z - along],
            high: [pose.x + across, pose.y + size[1], pose.z + along],
        }
    }

    /// Whether they are in each other's way.
    pub fn meets(&self, other: &Self) -> bool {
        (0..3).all(|k| self.low[k] < other.high[k] - TOUCH && other.low[k] < self.high[k] - TOUCH)
    }

    /// How far they are apart, seen from above.
    pub fn gap(&self, other: &Self) -> f64 {
        self.gap_squared(other).sqrt()
    }

    fn gap_squared(&self, other: &Self) -> f64 {
        let along = |k: usize| (self.low[k] - other.high[k]).max(other.low[k] - self.high[k]).max(0.0);
        along(0) * along(0) + along(2) * along(2)
    }
}

/// What one piece of a group takes: where it stands, seen from the group's first thing.
#[derive(Clone, Copy, Debug)]
pub struct Footprint {
    /// Index of the thing in the draft, and which of its elements in this group.
    pub thing: usize,
    /// Its place in the group.
    pub at: Pose,
    pub size: [f64; 3],
    /// Whether objects may stand on it: rugs.
    pub flat: bool,
    /// Whether it hides a window and is hidden from the door.
    pub tall: bool,
}

/// A group that is to be placed as one piece.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    /// What it consists of.
    pub pieces: Vec<Footprint>,
    /// Boxes that are kept free, in the frame of the group, as place and size.
    pub free: Vec<(Pose, [f64; 3])>,
    /// Whether it is a sofa with what stands before it: one gets to the sofa between these.
    pub is_lounge: bool,
}

/// So many seats around a table hide it: one gets to them.
const RING: usize = 6;

impl Shape {
    /// The box around the seats that stand all around the first thing, or around a sofa and what stands before it.
    fn ring(&self, at: &Pose) -> Option<Block> {
        let first = self.pieces.first()?.thing;
        let around = |a: Block, b: Block| Block {
            low: [0, 1, 2].map(|k| a.low[k].min(b.low[k])),
            high: [0, 1, 2].map(|k| a.high[k].max(b.high[k])),
        };
        if self.is_lounge {
            let own = self.pieces.iter().filter(|piece| !piece.flat && piece.at.y < LOW);
            return own.map(|piece| Block::of(&at.then(&piece.at), piece.size)).reduce(around);
        }
        let seats = |piece: &&Footprint| piece.thing != first && !piece.flat && piece.at.y < LOW;
        let one = self.pieces.iter().find(seats)?.thing;
        let own = self.pieces.iter().filter(|piece| piece.thing == one && !piece.flat);
        let blocks: Vec<Block> = own.map(|piece| Block::of(&at.then(&piece.at), piece.size)).collect();
        (blocks.len() >= RING).then(|| blocks.into_iter().reduce(around)).flatten()
    }
}

/// What is taken in a room.
#[derive(Clone, Debug)]
pub struct Floor {
    /// Width, height, depth.
    pub size: [f64; 3],
    /// What is there.
    bodies: Vec<Block>,
    /// What is kept free.
    free: Vec<Block>,
    /// What is kept free of tall things only.
    lit: Vec<Block>,
    /// Where one comes in: just inside of doors.
    doors: Vec<[f64; 2]>,
    /// What one has to get to.
    goals: Vec<Block>,
    /// Mats and rugs that lie there.
    flats: Vec<Block>,
    /// Before doors: nothing lies there but a doormat.
    swing: Vec<Block>,
    /// Whether ways may be narrower: what is asked for in a small room stands there all the same.
    pub narrow: bool,
    /// What stands along the edges of the floor is so thick.
    pub edge: f64,
}

impl Floor {
    /// An empty room.
    pub fn new(size: [f64; 3]) -> Self {
        Self {
            size,
            bodies: Vec::new(),
            free: Vec::new(),
            lit: Vec::new(),
            doors: Vec::new(),
            goals: Vec::new(),
            flats: Vec::new(),
            swing: Vec::new(),
            narrow: false,
            edge: 0.0,
        }
    }

    /// The room itself, somewhat wider.
    fn inside(&self, block: &Block) -> bool {
        let [w, h, d] = self.size;
        let most = [w / 2.0, h, d / 2.0];
        let least = [-w / 2.0, 0.0, -d / 2.0];
        (0..3).all(|k| block.low[k] >= least[k] - TOUCH && block.high[k] <= most[k] + TOUCH)
    }

    /// A door in a wall of the room, and the floor before it.
    pub fn door(&mut self, pose: &Pose, size: [f64; 3], clear: f64) {
        self.bodies.push(Block::of(pose, size));
        let way = Block::of(pose, [size[0], size[1], 2.0 * clear + size[2]]);
        self.doors.push([0, 2].map(|k| {
            // A room that is narrower than a way has its middle.
            let edge = (self.size[k] / 2.0 - HALF_WAY - self.cell()).max(0.0);
            ((way.low[k] + way.high[k]) / 2.0).clamp(-edge, edge)
        }));
        self.free.push(way);
        self.swing.push(way);
    }

    /// A door that one does not come in by, and the floor before it.
    pub fn side_door(&mut self, pose: &Pose, size: [f64; 3], clear: f64) {
        self.bodies.push(Block::of(pose, size));
        self.free.push(Block::of(pose, [size[0], size[1], 2.0 * clear + size[2]]));
        self.swing.push(Block::of(pose, [size[0], size[1], 2.0 * clear + size[2]]));
        self.goals.push(Block::of(pose, size));
    }

    /// What is there from now on, and hides nothing.
    pub fn body(&mut self, pose: &Pose, size: [f64; 3]) {
        self.bodies.push(Block::of(pose, size));
    }

    /// How much of the wall behind a place is free to the left and to the right of it, at the height of a thing of a size.
    pub fn stretch(&self, pose: &Pose, size: [f64; 3]) -> [f64; 2] {
        let own = Block::of(pose, size);
        let along = if (pose.yaw / 90.0).round() as i64 % 2 == 0 { 0 } else { 2 };
        let across = 2 - along;
        let mut out = [self.size[along] / 2.0 + own.low[along], self.size[along] / 2.0 - own.high[along]];
        for body in &self.bodies {
            let near = body.low[across] < own.high[across] + 0.4 && own.low[across] - 0.4 < body.high[across];
            if !near || body.high[1] < own.low[1] - 0.05 || body.low[1] > own.high[1] {
                continue;
            }
            if body.high[along] <= own.low[along] + 0.01 {
                out[0] = out[0].min(own.low[along] - body.high[along]);
            } else if body.low[along] >= own.high[along] - 0.01 {
                out[1] = out[1].min(body.low[along] - own.high[along]);
            }
        }
        out
    }

    /// A window: nothing tall before it, and nothing taller than the sill within half a metre.
    pub fn window(&mut self, pose: &Pose, size: [f64; 3]) {
        self.bodies.push(Block::of(pose, [size[0], size[1], size[2] + 0.02]));
        let above = Pose { y: pose.y + 0.1, ..*pose };
        self.free.push(Block::of(&above, [size[0], size[1] - 0.1, 1.0]));
        let all = Pose { y: 0.0, ..*pose };
        self.lit.push(Block::of(&all, [size[0] + 0.24, self.size[1], size[2] + 0.24]));
    }

    /// Keeps a place free from now on.
    pub fn keep(&mut self, pose: &Pose, size: [f64; 3]) {
        self.free.push(Block::of(pose, size));
    }

    /// Whether some of a place is kept free.
    pub fn keeps_free(&self, block: &Block) -> bool {
        let raised = Block { high: [block.high[0], block.high[1].max(0.2), block.high[2]], ..*block };
        self.free.iter().any(|free| free.meets(&raised))
    }

    /// Whether a group has room at a place.
    pub fn fits(&self, shape: &Shape, at: &Pose) -> bool {
        let bodies = shape.pieces.iter().map(|piece| (piece, Block::of(&at.then(&piece.at), piece.size)));
        let stands = |(piece, block): (&Footprint, Block)| {
            let taken = self.bodies.iter().chain(&self.free).any(|other| other.meets(&block));
            let darkens = piece.tall && self.lit.iter().any(|other| other.meets(&block));
            let large = piece.size[0].max(piece.size[2]) > MAT;
            // A rug ends before what belongs to others.
            let barred = || self.flats.iter().chain(&self.swing).chain(&self.bodies);
            let lies = piece.flat && large && barred().any(|other| other.meets(&block));
            self.inside(&block) && if piece.flat { !lies } else { !(taken || darkens) }
        };
        bodies.into_iter().all(stands)
            && shape.free.iter().all(|(pose, size)| {
                let block = Block::of(&at.then(pose), *size);
                self.inside(&block) && !self.bodies.iter().any(|other| other.meets(&block))
            })
    }

    /// Whether nothing stands at a place or is used from there.
    pub fn has_room(&self, at: &Pose, size: [f64; 3]) -> bool {
        let block = Block::of(at, size);
        self.inside(&block) && !self.bodies.iter().chain(&self.free).any(|other| other.meets(&block))
    }

    pub fn take(&mut self, shape: &Shape, at: &Pose) {
        for piece in shape.pieces.iter().filter(|piece| !piece.flat) {
            self.bodies.push(Block::of(&at.then(&piece.at), piece.size));
        }
        for piece in shape.pieces.iter().filter(|piece| piece.flat) {
            self.flats.push(Block::of(&at.then(&piece.at), piece.size));
        }
        self.free.extend(shape.free.iter().map(|(pose, size)| Block::of(&at.then(pose), *size)));
        if let Some(first) =
            shape.pieces.first().filter(|first| !first.flat && first.at.y < HEAD && first.size[0] > 0.3)
        {
            let block = Block::of(&at.then(&first.at), first.size);
            if block.low[1] < 0.5 {
                self.goals.push(shape.ring(at).unwrap_or(block));
            }
        }
    }

    /// Where one comes in.
    pub fn first_door(&self) -> Option<[f64; 2]> {
        self.doors.first().copied()
    }

    /// How far a place is from the nearest door.
    pub fn away_from_door(&self, pose: &Pose) -> f64 {
        self.doors.iter().map(|[x, z]| (pose.x - x).hypot(pose.z - z)).fold(f64::INFINITY, f64::min)
    }

    /// How far something is from the nearest place where a door swings (metres); 0 in it.
    pub fn off_swing(&self, block: &Block) -> f64 {
        let apart = |swing: &Block| {
            let [dx, dz] = [0, 2].map(|k| (swing.low[k] - block.high[k]).max(block.low[k] - swing.high[k]).max(0.0));
            dx.hypot(dz)
        };
        self.swing.iter().map(apart).fold(f64::INFINITY, f64::min)
    }

    /// How far the wall is before a place, straight ahead.
    pub fn wall_ahead(&self, pose: &Pose) -> f64 {
        let [w, _, d] = self.size;
        match (pose.yaw / 90.0).round() as i64 % 4 {
            0 => d / 2.0 - pose.z,
            1 => w / 2.0 - pose.x,
            2 => d / 2.0 + pose.z,
            _ => w / 2.0 + pose.x,
        }
    }

    /// How far the nearest door is before a place, straight ahead.
    pub fn door_ahead(&self, pose: &Pose) -> f64 {
        let (sin, cos) = pose.yaw.to_radians().sin_cos();
        let near = self.doors.iter().map(|[x, z]| [x - pose.x, z - pose.z]);
        let near = near.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
        near.map_or(f64::INFINITY, |[dx, dz]| dx * sin + dz * cos)
    }

    /// How far beyond a line across the floor the first door is; negative: on the other side.
    pub fn door_beyond(&self, axis: usize, line: f64) -> f64 {
        self.doors.first().map_or(0.0, |door| door[axis / 2] - line)
    }

    /// How far a group at a place is from the nearest thing on the floor.
    pub fn room_around(&self, shape: &Shape, at: &Pose) -> f64 {
        let own: Vec<Block> = shape.pieces.iter().map(|piece| Block::of(&at.then(&piece.at), piece.size)).collect();
        let low = self.bodies.iter().filter(|body| body.low[1] < HEAD);
        low.flat_map(|body| own.iter().map(|block| block.gap_squared(body))).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Whether one still gets from the doors to everything when a group stands at a place.
    pub fn leaves_ways(&self, shape: &Shape, at: &Pose) -> bool {
        self.unreached_with(shape, at) <= self.unreached()
    }

    /// How many things there is no way to when a group stands at a place.
    pub fn unreached_with(&self, shape: &Shape, at: &Pose) -> usize {
        let mut other = self.clone();
        other.take(shape, at);
        other.unreached()
    }

    /// Whether one still gets from the doors to everything when such a group stands at each of these places.
    pub fn leaves_ways_to_all(&self, shape: &Shape, places: &[Pose]) -> bool {
        let mut other = self.clone();
        places.iter().for_each(|at| other.take(shape, at));
        other.unreached() <= self.unreached()
    }

    /// The part of the floor that nothing is near and nobody needs: farther than a passage from all that stands there, and
    /// not kept free for its use.
    pub fn idle(&self) -> f64 {
        let (columns, rows) = self.cells();
        let standing = |body: &&Block| body.low[1] < LOW && body.high[1] > 0.08;
        let wider = |body: &Block| Block {
            low: [body.low[0] - PASS, 0.0, body.low[2] - PASS],
            high: [body.high[0] + PASS, 0.0, body.high[2] + PASS],
        };
        let near: Vec<Block> = self.bodies.iter().filter(standing).map(wider).collect();
        let needed: Vec<&Block> = near.iter().chain(self.free.iter().filter(|block| block.low[1] < LOW)).collect();
        let idle = (0..columns * rows).filter(|cell| {
            let [x, z] = self.middle(cell % columns, cell / columns);
            !needed
                .iter()
                .any(|block| (block.low[0]..block.high[0]).contains(&x) && (block.low[2]..block.high[2]).contains(&z))
        });
        idle.count() as f64 / ((columns * rows) as f64).max(1.0)
    }

    /// How many things there is no way to.
    pub fn unreached(&self) -> usize {
        if self.doors.is_empty() {
            return 0;
        }
        let (columns, rows) = self.cells();
        let reached = self.reached();
        let far = HALF_WAY + if self.narrow { 0.2 } else { 0.12 };
        // Only the cells around a thing are near it: a hall has very many others.
        let near = |goal: &Block| {
            let [i, j] = [0, 2].map(|k| {
                let cell = |v: f64| (((v + self.size[k] / 2.0) / self.cell()).floor().max(0.0)) as usize;
                (cell(goal.low[k] - far), cell(goal.high[k] + far))
            });
            (j.0..(j.1 + 1).min(rows)).any(|row| {
                (i.0..(i.1 + 1).min(columns)).any(|column| {
                    let [x, z] = self.middle(column, row);
                    let point = Block { low: [x, 0.0, z], high: [x, 0.0, z] };
                    reached.has(column, row) && goal.gap(&point) <= far
                })
            })
        };
        self.goals.iter().filter(|goal| !near(goal)).count()
    }

    /// The side of a cell; halls have coarser ones, so that their number is bounded.
    fn cell(&self) -> f64 {
        CELL.max(self.size[0].max(self.size[2]) / MOST_CELLS)
    }

    /// How many cells the floor has in each direction.
    fn cells(&self) -> (usize, usize) {
        ((self.size[0] / self.cell()) as usize, (self.size[2] / self.cell()) as usize)
    }

    fn middle(&self, i: usize, j: usize) -> [f64; 2] {
        let cell = self.cell();
        [(i as f64 + 0.5) * cell - self.size[0] / 2.0, (j as f64 + 0.5) * cell - self.size[2] / 2.0]
    }

    /// The cells that one can stand in, coming from a door.
    fn reached(&self) -> Cells {
        let [w, _, d] = self.size;
        let (columns, rows) = self.cells();
        let cell = self.cell();
        let mut open = Cells::all(columns, rows);
        let mut close = |low: [f64; 2], high: [f64; 2]| {
            let cells = |v: f64, half: f64, n: usize| (((v + half) / cell - 0.5).ceil().max(0.0) as usize).min(n);
            for j in cells(low[1], d / 2.0, rows)..cells(high[1], d / 2.0, rows) {
                let (from, to) = (cells(low[0], w / 2.0, columns), cells(high[0], w / 2.0, columns));
                open.take(j, from, to);
            }
        };
        let margin = HALF_WAY - if self.narrow { 0.05 } else { 0.02 };
        for body in self.bodies.iter().filter(|body| body.low[1] < HEAD && body.high[1] > 0.08) {
            // What is in the wall leaves the way free; curtains and pictures before it do not.
            let within =
                |k: usize| body.low[k] > -self.size[k] / 2.0 - 0.02 && body.high[k] < self.size[k] / 2.0 + 0.02;
            let thin = [0, 2].iter().any(|k| body.high[*k] - body.low[*k] < 0.15);
            if !within(0) || !within(2) || self.narrow && thin {
                continue;
            }
            close([body.low[0] - margin, body.low[2] - margin], [body.high[0] + margin, body.high[2] + margin]);
        }
        close([-w, -d], [-w / 2.0 + margin, d]);
        close([w / 2.0 - margin, -d], [w, d]);
        close([-w, -d], [w, -d / 2.0 + margin]);
        close([-w, d / 2.0 - margin], [w, d]);
        let at = |v: f64, half: f64, n: usize| (((v + half) / cell) as usize).min(n.saturating_sub(1));
        open.reached(self.doors.iter().flat_map(|[x, z]| {
            let (i, j) = (at(*x, w / 2.0, columns), at(*z, d / 2.0, rows));
            (i.saturating_sub(2)..i + 3).flat_map(move |i| (j.saturating_sub(2)..j + 3).map(move |j| (i, j)))
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cupboard() -> Shape {
        let piece = Footprint { thing: 0, at: Pose::default(), size: [1.0, 2.0, 0.6], flat: false, tall: true };
        let before = Pose { z: 0.6, ..Pose::default() };
        Shape { pieces: vec![piece], free: vec![(before, [1.0, 1.8, 0.6])], ..Shape::default() }
    }

    #[test]
    fn a_turned_place_carries_what_is_before_it_along() {
        let wall = Pose { x: -2.0, z: 0.5, yaw: 90.0, ..Pose::default() };
        let before = wall.then(&Pose { z: 1.0, ..Pose::default() });
        assert!((before.x + 1.0).abs() < 1e-9 && (before.z - 0.5).abs() < 1e-9, "{before:?}");
    }

    #[test]
    fn nothing_stands_before_a_cupboard_or_a_door() {
        let mut floor = Floor::new([4.0, 2.6, 4.0]);
        let at = Pose { z: 1.69, yaw: 180.0, ..Pose::default() };
        assert!(floor.fits(&cupboard(), &at));
        floor.take(&cupboard(), &at);
        assert!(!floor.fits(&cupboard(), &Pose { z: 0.8, ..at }));
        floor.door(&Pose { x: 1.0, z: -2.0, ..Pose::default() }, [0.95, 2.08, 0.12], 0.95);
        assert!(!floor.fits(&cupboard(), &Pose { x: 1.0, z: -1.69, ..Pose::default() }));
        assert!(floor.fits(&cupboard(), &Pose { x: -1.4, z: -1.69, ..Pose::default() }));
    }

    #[test]
    fn what_bars_the_way_to_something_is_seen() {
        let mut floor = Floor::new([2.2, 2.6, 5.0]);
        floor.door(&Pose { z: -2.5, ..Pose::default() }, [0.95, 2.08, 0.12], 0.95);
        floor.take(&cupboard(), &Pose { z: 2.19, yaw: 180.0, ..Pose::default() });
        let bar = Shape { free: Vec::new(), ..cupboard() };
        assert!(!floor.leaves_ways(&bar, &Pose { yaw: 0.0, ..Pose::default() }));
        let wide = Floor { size: [5.0, 2.6, 5.0], ..floor };
        assert!(wide.leaves_ways(&bar, &Pose { yaw: 0.0, ..Pose::default() }));
    }
}
