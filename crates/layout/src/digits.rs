//! How many digits a number gets in a layout file. A solver computes sixteen; nobody edits or compares those.

use crate::{Convex, Joint, Part, Placement, Vec3};

/// What is chosen freely is a multiple of this: a tenth of a millimetre, and as small a part of a degree.
pub const STEP: f64 = 1e-4;
/// The same for directions, which have no unit: the far end of a long axis must not wander.
const DIRECTION: f64 = 1e-6;

/// The nearest multiple of a grid, as the decimal number that is meant.
pub fn round_to(value: f64, grid: f64) -> f64 {
    let per = (1.0 / grid).round();
    (value * per).round() / per + 0.0
}

fn short(v: &Vec3) -> Vec3 {
    v.map(|x| round_to(x, STEP))
}

/// The same, but never so little that nothing is left.
fn extent(x: f64) -> f64 {
    let rounded = round_to(x, STEP);
    if rounded > 0.0 { rounded } else { x }
}

impl Placement {
    /// The same with what it is made of in numbers of few digits. Pose and size stay as they are.
    #[must_use]
    pub fn in_short(mut self) -> Self {
        self.parts = self.parts.iter().map(Part::in_short).collect();
        self.surface = self.surface.map(|height| round_to(height, STEP));
        self.joints = self.joints.iter().map(Joint::in_short).collect();
        self
    }
}

impl Part {
    /// The same in numbers of few digits.
    #[must_use]
    pub fn in_short(&self) -> Self {
        let rounded = match self {
            Self::Box { pos, size, rot } => Self::Box { pos: short(pos), size: size.map(extent), rot: short(rot) },
            Self::Cylinder { pos, radius, height, rot } => {
                Self::Cylinder { pos: short(pos), radius: extent(*radius), height: extent(*height), rot: short(rot) }
            }
            Self::Hull { points } => Self::Hull { points: points.iter().map(short).collect() },
        };
        // A very thin hull may be flat in round numbers.
        if Convex::from_part(&rounded).is_some() { rounded } else { self.clone() }
    }
}

impl Joint {
    fn in_short(&self) -> Self {
        let limits = [round_to(self.limits[0], STEP), extent(self.limits[1])];
        Self {
            axis: self.axis.map(|x| round_to(x, DIRECTION)),
            anchor: short(&self.anchor),
            limits,
            useful: self.useful.map(|useful| extent(useful).min(limits[1])),
            handle: self.handle.as_ref().map(short),
            ..self.clone()
        }
    }
}
