//! The grammars against the front end, which they must not contradict: what parses, where statements are, what class
//! each byte is of. And against the files that are committed.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod colours;
mod committed;
mod programs;
#[path = "../../../lang/tests/it/soup.rs"]
mod soup;
mod textmate;
mod tree;
