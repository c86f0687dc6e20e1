//! The catalogue against folders of models that the tests write themselves.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod checking;
mod generating;
mod holodeck;
mod hostile;
mod importing;
mod made;
mod providing;
mod reading;
mod searching;
mod serving;
mod similar;
