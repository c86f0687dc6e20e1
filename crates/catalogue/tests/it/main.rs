//! The catalogue against folders of models that the tests write themselves.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod checking;
mod hostile;
mod made;
mod reading;
mod searching;
