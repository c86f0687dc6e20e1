//! Language models behind one trait: messages and a JSON Schema in, a typed value out.
//!
//! [`Session`] is what is asked in practice: a provider, with the cache before it, the budget that is kept, the retries and
//! waits that networks need, the record of what was said. [`Replay`] is a recorded conversation in its place.
//!
//! Absent here: scenes, and what they are asked about.

mod cache;
mod clock;
mod error;
mod ledger;
mod message;
mod model;
mod retry;
mod session;
mod tape;
mod whole;

#[cfg(feature = "providers")]
mod provider;

pub use clock::{Clock, SystemClock};
pub use error::{Error, plain};
pub use ledger::{Account, Budget, Price, Spent};
pub use message::{Image, Message, Reply, Request, Role, Schema, Usage};
pub use model::{Model, json_of, typed};
pub use retry::Retry;
pub use session::{Limits, Session};
pub use tape::Replay;

#[cfg(feature = "providers")]
pub use provider::{Key, ModelName, Reach, Remote, Web, connect, providers};
