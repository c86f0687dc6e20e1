//! Vectors and rotations, boxes, prisms and polygons; the layout file read, checked and written back.
//!
//! Absent here: programs, constraints, margins of formulas.

pub mod model;

pub use model::{Layout, Part, Placement, RegionPlacement, Value, Vec3};
