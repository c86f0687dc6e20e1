//! Everything an exporter needs, worked out once: placed and furnished objects, rooms with their walls, and what the
//! report says about each. Exporters only write it down.
//!
//! Frame: the language's own (left-handed, y up, metres, degrees).

mod build;
mod dress;
mod eye;
mod memory;
mod opening;
pub mod shell;
mod thickness;
pub mod view;
mod wall;
mod weight;

pub use build::{BuildError, Looks, SceneInput};
pub use memory::Memory;
pub use opening::Opening;
pub use shell::{Role, Shell};
pub use view::View;

use crate::geometry::mesh::MeshGroup;
use memory::Tops;
use nalgebra::Matrix3;
use scenelang_assets::{Light, Surface};
use scenelang_base::door::{normal, relative};
use scenelang_layout::{Convex, Placement, Prism, Vec3, rotation};
use std::path::Path;
use std::sync::Arc;

/// A scene ready to be written in any format.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The stem of the program's file name: `meeting_room`.
    pub name: String,
    /// Name and text of the program's files, main first, then imports.
    pub program: Vec<(String, String)>,
    /// The layout file, whole.
    pub layout_text: String,
    /// The report on it (language book: JSON report), as it came.
    pub report: serde_json::Value,
    /// What exporters need of the report's rows, in its order.
    pub rows: Vec<ReportRow>,
    /// All surfaces, each once; groups refer to them by index.
    pub surfaces: Vec<Surface>,
    /// In order of declaration.
    pub objects: Vec<Object>,
    /// In order of declaration.
    pub regions: Vec<Region>,
    /// Floors, ceilings, walls, skirting boards and tints, region by region. Without any region: the ground.
    pub shells: Vec<Shell>,
    /// The lights of its lamps, and one for each room without any.
    pub lamps: Vec<Lamp>,
    /// Objects, by index, that may overlap and do; smaller index first.
    pub overlaps: Vec<[usize; 2]>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct ReportRow {
    /// `room.scene:12:1`, `P-COLLIDE:a:b`.
    pub id: String,
    /// `assert`, `prefer`, `pin`, `collision`, …
    pub kind: String,
    /// `None` where it could not be judged.
    pub satisfied: Option<bool>,
}

impl ReportRow {
    /// Whether something that must hold fails (a preference may).
    pub fn violated(&self) -> bool {
        self.satisfied == Some(false) && self.kind != "prefer"
    }
}

/// How an object takes part in physics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// Part of the building: doors, windows in walls.
    Static,
    /// Stays where it is put: on a wall, under a ceiling, floating, or where there is no floor.
    Held,
    /// Rests on what is below it.
    Free,
}

/// A placed and furnished object.
#[derive(Clone, Debug)]
pub struct Object {
    /// `lamp`, `chair[0]`.
    pub name: String,
    /// `name` as a file name: ASCII letters, digits, `_` and `-`, unlike that of any other object even where case does not count.
    pub stem: String,
    /// What to write on it: the category where there is one, else the name.
    pub label: String,
    /// Assigned text, or empty.
    pub category: String,
    /// The furniture family that draws it: `chair`.
    pub family: String,
    /// Where it is.
    pub place: Placement,
    /// Its orientation: columns are its right, up and front.
    pub axes: Matrix3<f64>,
    /// A number for all that its look is made from. Objects of the same number have the same mesh, lights, solid and weights.
    pub look: u64,
    /// Its triangles by surface, in its own frame.
    pub mesh: Vec<MeshGroup>,
    /// What light it gives, in its own frame.
    pub lights: Vec<Light>,
    /// Its convex parts, or its box, in its own frame: what the verifier judged.
    pub solid: Vec<Convex>,
    /// The surface of each of these parts: that of most of what is drawn within it.
    pub looks: Vec<usize>,
    /// Kilograms of each of these parts, an estimate from its material, surface and volume.
    pub weights: Vec<f64>,
    /// What of it opens, by joint.
    pub openings: Vec<Opening>,
    /// How it takes part in physics.
    pub body: Body,
    /// Kilograms, all parts together.
    pub mass: f64,
    /// The statement that declares it.
    pub declaration: String,
    /// The sentences that this statement stands for.
    pub requirements: Vec<String>,
    /// Rows of the report that speak of it.
    pub rows: Vec<usize>,
    /// Whether one of them is violated.
    pub violated: bool,
    /// The colours of its parts from above, as far as a plan was drawn.
    pub(crate) tops: Arc<Tops>,
}

impl Object {
    /// A point of its own frame in the world.
    pub fn at(&self, local: Vec3) -> Vec3 {
        self.place.pos + self.axes * local
    }
    /// Its orientation as a unit quaternion x, y, z, w.
    pub fn quaternion(&self) -> [f64; 4] {
        rotation::quaternion(&self.axes)
    }
    pub fn world_solid(&self) -> impl Iterator<Item = Convex> + '_ {
        self.solid.iter().map(|c| c.moved(&self.axes, &self.place.pos))
    }
}

#[derive(Clone, Debug)]
pub struct Region {
    /// As in the program.
    pub name: String,
    /// Room, zone or outdoors.
    pub kind: RegionKind,
    /// Its floor polygon and heights.
    pub prism: Prism,
}

/// What a region is to a builder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegionKind {
    /// Has floor, walls and ceiling.
    Room,
    /// Lies inside another region: no walls.
    Zone,
    /// "outdoor" is among its features: a floor only.
    Outdoor,
}

/// A light that shines in all directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// `office/lamp`, `desk_lamp/light`.
    pub name: String,
    /// The object that gives it, by index. `None`: it has no body, and hangs under the ceiling of a room without lamps.
    pub object: Option<usize>,
    /// Where it is.
    pub pos: Vec3,
    /// How far it shines, metres.
    pub range: f64,
    /// sRGB, each 0 to 1.
    pub color: [f32; 3],
    /// Luminous intensity.
    pub candela: f64,
}

impl Scene {
    /// Draws up a scene.
    ///
    /// # Errors
    /// Something is not placed, or a floor is no polygon.
    pub fn build(input: &SceneInput<'_>) -> Result<Self, BuildError> {
        build::build(input, &|_| None, &Memory::default())
    }

    /// The same, with what some objects look like that the furniture library does not draw.
    ///
    /// # Errors
    /// As for [`Self::build`].
    pub fn dressed(input: &SceneInput<'_>, own: Looks<'_>) -> Result<Self, BuildError> {
        build::build(input, own, &Memory::default())
    }

    /// The same scene as from [`Self::build`]. Objects that are remembered are not drawn again.
    ///
    /// # Errors
    /// As for [`Self::build`].
    pub fn remembered(input: &SceneInput<'_>, memory: &Memory) -> Result<Self, BuildError> {
        build::build(input, &|_| None, memory)
    }

    /// The program's main file.
    pub fn main_text(&self) -> &str {
        self.program.first().map_or("", |(_, text)| text)
    }

    /// What the program imports: text by path relative to the main file. `None` where it imports nothing.
    pub fn imports(&self) -> Option<serde_json::Value> {
        let ((main, _), imports) = self.program.split_first()?;
        let folder = normal(Path::new(main)).parent().map(Path::to_path_buf).unwrap_or_default();
        let seen = |name: &str| relative(&normal(Path::new(name)), &folder);
        let texts: serde_json::Map<String, serde_json::Value> =
            imports.iter().map(|(name, text)| (seen(name), text.as_str().into())).collect();
        (!texts.is_empty()).then(|| texts.into())
    }
}
