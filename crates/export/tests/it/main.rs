//! What exporters write for one small scene, read back by hand.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod back;
mod edited;
mod fixture;
mod glb;
mod live;
mod pictures;
mod project;
mod report;
mod rewritten;
mod scene;
mod scripts;
mod simulators;
mod textured;
mod unity;
mod usd_back;
mod written;
