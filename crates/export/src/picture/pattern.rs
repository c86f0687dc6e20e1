//! What is drawn on floors and walls: boards, tiles, a weave. All computed from the place, nothing stored.

use scenelang_assets::Surface;

/// A pattern in the world's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pattern {
    /// One colour.
    Plain,
    /// Floor boards along z.
    Boards,
    /// Square tiles with joints.
    Tiles,
    /// A soft grain.
    Grain,
}

impl Pattern {
    /// Of a floor, by the finish that a surface's name begins with.
    pub fn of_floor(surface: &Surface) -> Self {
        match surface.name.split('-').next() {
            Some("wood") => Self::Boards,
            Some("ceramic") => Self::Tiles,
            Some("carpet" | "fabric" | "leaf" | "soil" | "stone" | "wicker") => Self::Grain,
            _ => Self::Plain,
        }
    }

    /// Of a wall.
    pub fn of_wall(surface: &Surface) -> Self {
        if surface.name.starts_with("ceramic-") { Self::Tiles } else { Self::Plain }
    }

    /// How bright the surface is at a place, about 1; `normal` tells floor from wall.
    pub fn shade(self, [x, y, z]: [f32; 3], normal: [f32; 3]) -> f32 {
        match self {
            Self::Plain => 1.0,
            Self::Boards => boards(x, z),
            Self::Tiles => {
                // On a wall the tiles run up, along the axis that the wall is less turned from.
                let (u, v) = match normal {
                    [_, ny, _] if ny.abs() > 0.7 => (x, z),
                    [nx, _, nz] if nx.abs() > nz.abs() => (z, y),
                    _ => (x, y),
                };
                tiles(u, v)
            }
            Self::Grain => 0.96 + 0.08 * noise((x * 45.0).floor() as i32, (z * 45.0).floor() as i32),
        }
    }
}

fn boards(x: f32, z: f32) -> f32 {
    const WIDTH: f32 = 0.14;
    const LENGTH: f32 = 1.4;
    let row = (x / WIDTH).floor();
    // Neighbouring rows start elsewhere.
    let along = z / LENGTH + noise(row as i32, 7) * 3.0;
    let board = noise(row as i32, along.floor() as i32 + 1000);
    let joint = joint(x / WIDTH, 0.0035 / WIDTH).min(joint(along, 0.003 / LENGTH));
    let grain = noise((x * 260.0).floor() as i32, (z * 5.0).floor() as i32);
    (0.9 + 0.16 * board + 0.035 * (grain - 0.5)) * joint
}

fn tiles(u: f32, v: f32) -> f32 {
    const SIDE: f32 = 0.4;
    let shade = 0.97 + 0.05 * noise((u / SIDE).floor() as i32, (v / SIDE).floor() as i32);
    shade * joint(u / SIDE, 0.006 / SIDE).min(joint(v / SIDE, 0.006 / SIDE))
}

/// Darker near whole numbers, within `half` of them.
fn joint(t: f32, half: f32) -> f32 {
    if (t - t.round()).abs() < half { 0.72 } else { 1.0 }
}

/// A repeatable number in 0..1 for a cell.
fn noise(i: i32, j: i32) -> f32 {
    let mut h = (i as u32).wrapping_mul(0x9e37_79b9) ^ (j as u32).wrapping_mul(0x85eb_ca6b);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1 << 24) as f32
}
