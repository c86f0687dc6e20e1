//! The server over its protocol, in this process: a client that looks at every message.

mod actions;
mod client;
mod commands;
mod features;
mod hazards;
mod life;
mod sync;
mod watching;
