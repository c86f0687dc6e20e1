//! Where in a room a group has its best place: at a wall, in a corner, on the floor, on a wall. The first places by their cost
//! are tried in order until one leaves the ways free.

use super::floor::{Floor, Pose, Shape};
use std::cell::LazyCell;

/// Behind the back of what stands at a wall (metres).
pub const BEHIND: f64 = 0.003;
/// Beside what stands in a corner.
const BESIDE: f64 = 0.03;
/// From one place that is tried to the next.
const STEP: f64 = 0.1;
/// The most steps from the middle of the floor to a wall.
const MOST_STEPS: f64 = 30.0;
/// So many places are held against the ways.
const TRIED: usize = 21;
/// Places that are so near to one that bars a way are not tried (metres): after each so many tries, farther ones.
const NEAR: [f64; 3] = [0.25, 0.7, 1.4];
const EACH: usize = 7;
/// What stands free is this far from walls.
const FREE: f64 = 0.6;

/// A wall seen from the room: the turn of what has its back at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// At the greatest z.
    Back,
    /// At the least x.
    Left,
    /// At the greatest x.
    Right,
    /// At the least z.
    Front,
}

impl Wall {
    /// All, the one that is looked at first before the others.
    pub const ALL: [Self; 4] = [Self::Back, Self::Left, Self::Right, Self::Front];

    /// The turn of what has its back at it.
    pub fn yaw(self) -> f64 {
        match self {
            Self::Back => 180.0,
            Self::Left => 90.0,
            Self::Right => 270.0,
            Self::Front => 0.0,
        }
    }

    /// How long it is.
    pub fn length(self, size: [f64; 3]) -> f64 {
        if matches!(self, Self::Back | Self::Front) { size[0] } else { size[2] }
    }

    /// How far it is from the wall across the room.
    pub fn depth(self, size: [f64; 3]) -> f64 {
        if matches!(self, Self::Back | Self::Front) { size[2] } else { size[0] }
    }

    /// The place whose middle is so far from the wall and so far along it, to the right of who stands with the back at it.
    pub fn place(self, size: [f64; 3], along: f64, off: f64) -> Pose {
        let [w, _, d] = size;
        let (x, z) = match self {
            Self::Back => (-along, d / 2.0 - off),
            Self::Left => (-w / 2.0 + off, -along),
            Self::Right => (w / 2.0 - off, along),
            Self::Front => (along, off - d / 2.0),
        };
        Pose { x, y: 0.0, z, yaw: self.yaw() }
    }

    /// The wall that something has its back at.
    pub fn behind(pose: &Pose) -> Option<Self> {
        Self::ALL.into_iter().find(|wall| (wall.yaw() - pose.yaw).abs() < 1.0)
    }

    /// The wall across the room.
    pub fn across(self) -> Self {
        match self {
            Self::Back => Self::Front,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::Front => Self::Back,
        }
    }
}

/// How far a group reaches to the left, the right, the back and the front of its first thing.
pub fn reach(shape: &Shape) -> [f64; 4] {
    let mut out = [0.0_f64; 4];
    for piece in shape.pieces.iter().filter(|piece| !piece.flat) {
        let block = super::floor::Block::of(&piece.at, piece.size);
        out[0] = out[0].max(-block.low[0]);
        out[1] = out[1].max(block.high[0]);
        out[2] = out[2].max(-block.low[2]);
        out[3] = out[3].max(block.high[2]);
    }
    out
}

/// The best place by a cost; `None` costs: never there.
pub fn best(
    floor: &Floor,
    shape: &Shape,
    places: impl Iterator<Item = Pose>,
    cost: &dyn Fn(&Pose) -> Option<f64>,
) -> Option<Pose> {
    let mut found: Vec<(f64, Pose)> =
        places.filter(|at| floor.fits(shape, at)).filter_map(|at| Some((cost(&at)?, at))).collect();
    found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let unreached = LazyCell::new(|| floor.unreached());
    // Places beside each other bar the same ways: one of each neighbourhood is tried.
    let mut tried: Vec<Pose> = Vec::new();
    for (_, at) in &found {
        let near = NEAR[(tried.len() / EACH).min(NEAR.len() - 1)];
        if tried.iter().any(|other| (other.x - at.x).hypot(other.z - at.z) < near && other.yaw == at.yaw) {
            continue;
        }
        if floor.unreached_with(shape, at) <= *unreached {
            return Some(*at);
        }
        tried.push(*at);
        if tried.len() >= TRIED {
            break;
        }
    }
    None
}

/// Places at the walls; `depth` is that of the thing whose back touches the wall.
pub fn at_walls(size: [f64; 3], shape: &Shape, depth: f64) -> Vec<Pose> {
    let [left, right, back, _] = reach(shape);
    // Who sits behind a drum kit has a place there.
    let off = (depth / 2.0).max(back) + BEHIND;
    let mut out = Vec::new();
    for wall in Wall::ALL {
        let (low, high) = (left + 0.02 - wall.length(size) / 2.0, wall.length(size) / 2.0 - right - 0.02);
        if low > high {
            continue;
        }
        let steps = ((high - low) / STEP).floor() as usize;
        let along = (0..=steps).map(|i| low + STEP * i as f64).chain([high]);
        let along = along.chain((low < 0.0 && high > 0.0).then_some(0.0));
        out.extend(along.map(|along| wall.place(size, along, off)));
    }
    out
}

/// Places at the walls that touch what stands beside them there, each less than a step from a place of `places`.
pub fn beside_others(floor: &Floor, shape: &Shape, of: [f64; 3], places: &[Pose]) -> Vec<Pose> {
    let [left, right, ..] = reach(shape);
    let mut out = Vec::new();
    for at in places {
        let is_across = (at.yaw / 90.0).round() as i64 % 2 == 0;
        // How far the group reaches beyond the thing itself, first towards the lower coordinates of the room.
        let beyond = [left, right].map(|side| side - of[0] / 2.0);
        let beyond =
            if matches!(Wall::behind(at), Some(Wall::Left | Wall::Back)) { [beyond[1], beyond[0]] } else { beyond };
        for ((gap, beyond), sign) in floor.stretch(at, of).into_iter().zip(beyond).zip([-1.0, 1.0]) {
            let way = gap - beyond - BEHIND;
            if way > 0.0 && way < STEP {
                let [dx, dz] = if is_across { [sign * way, 0.0] } else { [0.0, sign * way] };
                out.push(Pose { x: at.x + dx, z: at.z + dz, ..*at });
            }
        }
    }
    out
}

/// Places on the walls at a height.
pub fn on_walls(size: [f64; 3], shape: &Shape, depth: f64, y: f64) -> Vec<Pose> {
    let mut out = at_walls(size, shape, depth);
    out.iter_mut().for_each(|pose| pose.y = y);
    out
}

/// Places in the corners, the back at either wall, or at what stands along the edges.
pub fn in_corners(size: [f64; 3], shape: &Shape, of: [f64; 3], edge: f64) -> Vec<Pose> {
    let mut out = Vec::new();
    let beside = BESIDE + edge;
    let back = reach(shape)[2].max(of[2] / 2.0);
    for wall in Wall::ALL {
        let end = wall.length(size) / 2.0 - of[0] / 2.0 - beside;
        out.extend([-end, end].map(|along| wall.place(size, along, back + beside)));
    }
    out
}

/// Places on the floor, not turned, away from the walls.
pub fn on_floor(size: [f64; 3], of: [f64; 3], yaws: &[f64]) -> Vec<Pose> {
    let mut out = Vec::new();
    for yaw in yaws {
        let (across, along) = if (yaw / 90.0).round() as i64 % 2 == 0 { (of[0], of[2]) } else { (of[2], of[0]) };
        let (x, z) = ((size[0] - across) / 2.0 - FREE - 0.01, (size[2] - along) / 2.0 - FREE - 0.01);
        if x < 0.0 || z < 0.0 {
            continue;
        }
        let steps = |most: f64| {
            // A hall is looked at more coarsely than a living room: the work is bounded.
            let step = (2.0 * STEP).max(most / MOST_STEPS);
            let n = (most / step).floor() as i64;
            (-n..=n).map(move |i| step * i as f64)
        };
        for at_x in steps(x) {
            out.extend(steps(z).map(|at_z| Pose { x: at_x, y: 0.0, z: at_z, yaw: *yaw }));
        }
    }
    out
}
