//! What a draft is as a program, and what a model makes of a request.

mod account;
mod arrange;
mod brief;
mod furnish;
mod homes;
mod meaning;
mod model;
mod read;
#[path = "../../../llm/tests/it/server.rs"]
#[allow(dead_code, clippy::unwrap_used, reason = "it is the server of another crate's tests")]
mod server;
mod support;
mod together;
mod write;
