//! The playground without its page: a program under edit, and what may be asked of it, as JSON. Nothing is read from a disk
//! or sent anywhere.
//!
//! - [`Session::call`]: one request, one answer; `request.rs` lists them.
//! - [`Offsets`]: places as a page counts them.
//!
//! Absent here: the page (`playground/`), and what the answers are (`ide`, `synth`, `export`).

#[cfg(target_family = "wasm")]
mod abi;
mod answers;
mod files;
mod make;
mod offsets;
mod request;
mod room;
mod session;

pub use offsets::Offsets;
pub use session::Session;
