//! What encloses a room: floor and ceiling slabs, walls of real thickness with holes for doors and windows, and skirting boards.

use super::wall::{Opener, Wall};
use crate::geometry::mesh::MeshGroup;
use crate::geometry::polygon::{offset, offset_each};
use scenelang_layout::planar::edges;
use scenelang_layout::{Prism, Vec2, Vec3};

/// Thickness of walls and slabs, metres, where the report does not say: the language's η. Walls stand outside the floor
/// polygon.
pub const USUAL_WALL: f64 = 0.03;
/// How far a zone's tint lies above the floor it colours, metres: enough to be seen, too little to stumble over.
const TINT: f64 = 0.002;
/// One piece of a room's shell, in world coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Shell {
    /// `office/floor`, `office/wall2`: unique in the scene.
    pub name: String,
    /// The region it belongs to; none for the ground.
    pub region: Option<String>,
    pub role: Role,
    /// How it looks.
    pub group: MeshGroup,
    /// The prisms it consists of.
    pub pieces: Vec<WallPrism>,
    /// Boxes that stop things (walls only; floors and ceilings stop things by their triangles, tints and skirting boards
    /// stop nothing). They are as thick as the verifier takes walls to be, whatever is drawn.
    pub boxes: Vec<Slab>,
}

/// The role of a piece of shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Role {
    /// Under the whole room, walls included.
    Floor,
    /// Over the whole room, walls included.
    Ceiling,
    /// Along one edge of the floor polygon.
    Wall {
        /// Start of the edge; the polygon runs counterclockwise (x right, z up).
        from: Vec2,
        /// End of the edge.
        to: Vec2,
    },
    /// A board along the foot of the wall over the same edge, inside the room.
    Skirting {
        /// Start of the edge.
        from: Vec2,
        /// End of the edge.
        to: Vec2,
    },
    /// The colour of a zone, on its room's floor.
    Tint,
}

impl Role {
    /// What it is in a word, in exported files.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Floor | Self::Tint => "floor",
            Self::Ceiling => "ceiling",
            Self::Wall { .. } => "wall",
            Self::Skirting { .. } => "skirting",
        }
    }
}

/// An upright prism over a convex quadrilateral.
#[derive(Clone, Debug, PartialEq)]
pub struct WallPrism {
    /// Counterclockwise: the inner edge's ends first, then the outer edge's, backwards.
    pub polygon: Vec<Vec2>,
    /// Height of its lower face.
    pub low: f64,
    /// Height of its upper face.
    pub high: f64,
}

/// A box turned about the vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab {
    pub center: Vec3,
    /// Full extents: along the wall, up, across.
    pub size: Vec3,
    /// Degrees about y that turn x to the wall's direction.
    pub yaw: f64,
}

/// Surfaces of a region's shell, as indices into the scene's table.
#[derive(Clone, Copy, Debug)]
pub struct Surfaces {
    pub floor: usize,
    pub wall: usize,
    pub ceiling: usize,
    /// None where there is no skirting board.
    pub skirting: Option<usize>,
}

/// How thick the walls of a room are, metres.
#[derive(Clone, Copy, Debug)]
pub struct Thickness<'a> {
    /// What the verifier takes them to be, which is what stops things.
    pub stops: f64,
    /// What is drawn for each edge of the floor.
    pub drawn: &'a [f64],
}

/// The shell of a room: floor, ceiling, and for each edge a wall and perhaps a skirting board.
pub fn room(name: &str, prism: &Prism, thick: Thickness<'_>, openers: &[Opener], surfaces: Surfaces) -> Vec<Shell> {
    let polygon = prism.polygon.corners();
    let (low, high) = (prism.floor, prism.ceiling);
    let stop = offset(polygon, thick.stops);
    let outer = offset_each(polygon, thick.drawn);
    let mut out = vec![
        slab(name, "floor", Role::Floor, &outer, (low - thick.stops, low), surfaces.floor),
        slab(name, "ceiling", Role::Ceiling, &outer, (high, high + thick.stops), surfaces.ceiling),
    ];
    let n = polygon.len();
    for (i, (from, to)) in edges(polygon).enumerate() {
        let holes: Vec<_> = openers.iter().filter_map(|o| o.hole(from, to)).collect();
        let ends = |corners: &[Vec2]| [corners[i], corners[(i + 1) % n]];
        let wall = Wall {
            from,
            to,
            outer: ends(&outer),
            stop: ends(&stop),
            low,
            high,
            drawn: thick.drawn[i],
            stops: thick.stops,
        };
        out.push(wall.shell(name, i, &holes, surfaces.wall));
        out.extend(surfaces.skirting.and_then(|surface| wall.skirting(name, i, &holes, surface)));
    }
    out
}

/// The floor of a region that has no walls: a slab outdoors, a thin tint for a zone.
pub fn open(name: &str, prism: &Prism, thickness: f64, zone: bool, surface: usize) -> Shell {
    let floor = prism.floor;
    let (role, range) =
        if zone { (Role::Tint, (floor, floor + TINT)) } else { (Role::Floor, (floor - thickness, floor)) };
    slab(name, "floor", role, prism.polygon.corners(), range, surface)
}

fn slab(region: &str, part: &str, role: Role, polygon: &[Vec2], (low, high): (f64, f64), surface: usize) -> Shell {
    let mut group = MeshGroup::new(surface);
    group.prism(polygon, low, high);
    let pieces = vec![WallPrism { polygon: polygon.to_vec(), low, high }];
    Shell { name: format!("{region}/{part}"), region: Some(region.to_owned()), role, group, pieces, boxes: Vec::new() }
}
