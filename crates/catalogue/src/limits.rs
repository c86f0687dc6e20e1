//! How much of a folder and of a file is read. What is beyond is an error that says so.

/// A model file is at most so large (bytes).
pub const BYTES: usize = 64 << 20;
/// A packed file is at most so large once it is unpacked (bytes).
pub const UNPACKED: usize = 256 << 20;
/// A card is at most so large (bytes).
pub const CARD: usize = 1 << 20;
/// A model has at most so many triangles, all copies of a mesh counted.
pub const TRIANGLES: usize = 1_000_000;
/// A model has at most so many nodes, all copies counted.
pub const NODES: usize = 10_000;
/// Nodes are at most so deep in each other.
pub const DEPTH: usize = 64;
/// A model is at most so large, and no point of it is farther than this from the origin of its file (metres).
pub const EXTENT: f64 = 10_000.0;
/// A catalogue has at most so many models.
pub const MODELS: usize = 200_000;
/// Folders are at most so deep in each other.
pub const FOLDERS: usize = 16;
/// An array of features is at most so large (bytes).
pub const FEATURES: usize = 512 << 20;
/// A pickle has at most so many values, all copies of shared ones counted.
pub const VALUES: usize = 16 << 20;
