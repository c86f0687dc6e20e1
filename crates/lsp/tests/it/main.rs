//! The server over its protocol, in this process: a client that looks at every message.

#![allow(clippy::unwrap_used, clippy::needless_pass_by_value, reason = "a test that cannot go on fails")]

mod across;
mod actions;
mod client;
mod commands;
mod features;
#[cfg(target_os = "linux")]
mod hanging;
mod hazards;
mod life;
mod model;
mod moving;
mod proofs;
mod sync;
mod watching;
