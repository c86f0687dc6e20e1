//! The language server: the protocol around `crates/ide`.
//!
//! One thread owns all state and takes messages in the order in which they came ([`serve`], `state`); questions are answered
//! by a pool of threads from snapshots, and asked again when the text changes meanwhile; long work (solving, repairing) has
//! threads of its own, says how far it is, and can be cancelled.
//!
//! Absent here: what the answers are. No protocol type leaves this crate.

mod advised;
mod alternatives;
mod beside;
mod capabilities;
mod change;
mod client;
mod commands;
mod config;
mod convert;
mod disk;
mod dispatch;
mod documents;
mod drag;
mod features;
mod frames;
mod imports;
mod jobs;
mod model;
mod pages;
mod parent;
mod parked;
mod picture;
mod pool;
mod proved;
mod provisional;
mod publish;
mod reading;
mod record;
mod refuted;
mod repair;
mod shelf;
mod state;
mod text;
mod told;
mod trace;
mod wire;

pub use beside::{Beside, Show};
pub use client::Named;
pub use model::{Connect, ModelQuestion};
pub use record::{Recorder, replay};
pub use state::Setup;
pub use wire::serve;
