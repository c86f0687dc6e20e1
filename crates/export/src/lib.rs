//! Stage IV: a verified layout as things that others open — a Unity project, a GLB, a plan, a picture, a web page.
//!
//! [`Scene`] is worked out once from program, layout and report; each exporter is one file or folder that implements
//! [`Exporter`] and only writes down what the scene says.
//!
//! [`embedded`] is the way back: the program and the layout that such a file carries.
//!
//! Absent here: solving, judging, and how furniture is made (the `assets` room).

#[cfg(not(target_family = "wasm"))]
mod drawing;
pub mod embedded;
mod exporter;
mod geometry;
pub mod glb;
mod loss;
pub mod mjcf;
mod names;
mod numbers;
pub mod obj;
mod parts;
mod physics;
pub mod picture;
pub mod plan;
pub mod preview;
pub mod report;
pub mod scene;
pub mod sdf;
mod textures;
pub mod thumbnail;
pub mod unity;
pub mod urdf;
pub mod usd;
mod xml;

pub use embedded::Embedded;
pub use exporter::{ExportError, Exporter, OutFile, all_exporters, exporters, write_all};
pub use geometry::frame::Frame;
pub use geometry::mesh::MeshGroup;
pub use loss::{Loss, Lost, losses};
pub use parts::{Parts, Shows, parts};
pub use scene::{BuildError, Scene, SceneInput};
