//! The little geometry that drawing needs: floor polygons, meshes of prisms and convex parts, frames.
//!
//! Everything is in the scene's own left-handed frame (y up, metres); exporters convert on the way out.

pub mod frame;
pub mod mesh;
pub mod polygon;
pub mod tangent;
