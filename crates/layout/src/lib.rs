//! Vectors and rotations, boxes, prisms and polygons; the layout file read, checked and written back.
//!
//! Absent here: programs, constraints, margins of formulas.

pub mod broad;
pub mod convex;
pub mod digits;
pub mod file;
pub mod model;
pub mod obb;
pub mod planar;
pub mod polygon;
pub mod region;
pub mod rotation;
pub mod separation;
pub mod sweep;

pub use convex::{Convex, Face, Geometry, Nearest};
pub use file::{Document, Places, ReadLayout};
pub use model::{DecisionValue, Joint, Layout, Motion, Part, Placement, RegionPlacement, Vec3};
pub use obb::Obb;
pub use planar::Vec2;
pub use polygon::{Clearance, NotSimple, Polygon};
pub use region::{Inside, Prism, inside_clearance};
pub use separation::{Aabb, Separation};
pub use sweep::{Moving, Swept};
