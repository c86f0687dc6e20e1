//! What a layout file says, as values. Metres and degrees; left-handed frame, y up.

use nalgebra::Vector3;
use smol_str::SmolStr;
use std::collections::BTreeMap;

/// Three numbers: a point, extents, or an Euler triple in degrees (x, then z, then y, about the fixed world axes).
pub type Vec3 = Vector3<f64>;

/// A layout: where everything is. Order is that of the file, and is kept on writing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Path of the program, relative to the layout's file.
    pub scene: Option<String>,
    /// The seed it was made with.
    pub seed: Option<u64>,
    /// Whether the solver was ended before it was done with it.
    pub incomplete: bool,
    /// Placed objects by name (`lamp`, `chair[0]`).
    pub objects: Vec<(SmolStr, Placement)>,
    /// The category of an object by its name, for people who read the file. Nothing is judged by it: the program decides.
    pub categories: BTreeMap<SmolStr, SmolStr>,
    /// Placed regions by name.
    pub regions: Vec<(SmolStr, RegionPlacement)>,
    pub variables: Vec<(SmolStr, DecisionValue)>,
    /// Recorded draws by key.
    pub draws: Vec<(String, f64)>,
}

impl Layout {
    pub fn object(&self, name: &str) -> Option<&Placement> {
        self.objects.iter().find(|(n, _)| n == name).map(|(_, p)| p)
    }
    pub fn region(&self, name: &str) -> Option<&RegionPlacement> {
        self.regions.iter().find(|(n, _)| n == name).map(|(_, p)| p)
    }
}

/// Where an object is, how it is turned, how large it is, and what it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Centre of the bottom face of the box, and pivot of the rotation (metres).
    pub pos: Vec3,
    /// Euler triple (degrees).
    pub rot: Vec3,
    /// Full extents w, h, d (metres), each > 0.
    pub scale: Vec3,
    /// Convex parts in the object's own frame, already at scale; empty: the box.
    pub parts: Vec<Part>,
    /// Height of the support surface above the base, where the asset declares one (a mattress, a seat).
    pub surface: Option<f64>,
    /// What of it can be opened; all of it is closed here.
    pub joints: Vec<Joint>,
}

/// A door, a drawer or a lid: some parts of an object that turn or slide together. The layout has it closed, so that
/// its parts are parts like all others to whoever knows nothing of joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// What it is called; no two of an object have the same name.
    pub name: SmolStr,
    /// How it moves.
    pub motion: Motion,
    /// Direction of the axis in the frame of the object, not zero: it is slid along, or turned about. Positive angles
    /// are those of [`crate::rotation`].
    pub axis: Vec3,
    /// A point of the axis in the frame of the object (metres).
    pub anchor: Vec3,
    /// The least and the greatest that it can be opened (degrees or metres): at most 0, which is closed, and more than 0.
    pub limits: [f64; 2],
    /// How far it has to open to be of use (degrees or metres); `None`: nobody demands that it does.
    pub useful: Option<f64>,
    /// Where it is taken hold of, in the frame of the object (metres).
    pub handle: Option<Vec3>,
    /// What moves: indices into [`Placement::parts`]. No part moves with two joints.
    pub parts: Vec<usize>,
}

impl Joint {
    /// The same of an object that is larger by these factors along its width, height and depth. Angles stay; a drawer
    /// gets longer with what it is in.
    pub fn stretched(&self, by: &Vec3) -> Self {
        let axis = self.axis.component_mul(by);
        let factor = match self.motion {
            Motion::Hinge => 1.0,
            Motion::Slide => axis.norm() / self.axis.norm(),
        };
        Self {
            axis: axis.normalize(),
            anchor: self.anchor.component_mul(by),
            limits: self.limits.map(|limit| limit * factor),
            useful: self.useful.map(|useful| useful * factor),
            handle: self.handle.map(|handle| handle.component_mul(by)),
            ..self.clone()
        }
    }
}

/// How a movable part moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// It turns about the axis; amounts are degrees.
    Hinge,
    /// It slides along the axis; amounts are metres.
    Slide,
}

impl Motion {
    /// What it is called in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hinge => "hinge",
            Self::Slide => "slide",
        }
    }
}

/// A convex part, in the frame of its object (origin: centre of the bottom face).
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    Box {
        /// Its centre.
        pos: Vec3,
        /// Full extents.
        size: Vec3,
        /// Euler triple (degrees) about its centre.
        rot: Vec3,
    },
    /// An upright cylinder (axis y), as a solid a regular 24-gon prism inscribed, a vertex on +x.
    Cylinder {
        /// Its centre.
        pos: Vec3,
        radius: f64,
        /// Full height.
        height: f64,
        /// Euler triple (degrees) about its centre.
        rot: Vec3,
    },
    /// The convex hull of points.
    Hull {
        /// At least four, not in one plane.
        points: Vec<Vec3>,
    },
}

/// Where a region is.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionPlacement {
    /// Centre of the rectangle's floor; `pos.y` is the floor's height.
    pub pos: Vec3,
    /// Only `rot.y` turns it.
    pub rot: Vec3,
    /// Full extents; `scale.y` is the height.
    pub scale: Vec3,
    /// Floor polygon (world x, z), simple, either winding; then pos.x/z, scale.x/z and rot.y have no say.
    pub vertices: Option<Vec<[f64; 2]>>,
}

/// The value of a decision variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DecisionValue {
    /// Number or Degree.
    Number(f64),
    Bool(bool),
    /// Vector3, or Rotation as an Euler triple.
    Triple([f64; 3]),
}
