//! Tests of the whole: the binary from end to end, other people's checkers on what it writes, hostile input, the rules
//! of the house (layering, licences), and what the documents claim.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod agreement;
mod assets;
mod back;
mod bounded;
mod brief;
mod carriers;
mod checkers;
mod cli;
mod design;
mod diff;
mod documents;
mod editors;
mod evaluation;
mod everyday;
mod examples;
mod exporting;
mod faults;
mod fixing;
mod formats;
mod furniture;
mod groups;
mod hostile;
mod hostile_models;
#[cfg(unix)]
mod hostile_repositories;
mod inspect;
mod interrupts;
mod kills;
mod layering;
mod licences;
mod model;
mod permissions;
mod pipes;
mod problems;
mod query;
mod repair;
mod replacing;
mod rooms;
mod sceneeval;
mod signals;
mod solving;
mod speaking;
mod stability;
mod stage_one;
mod support;
mod trace;
mod view;
mod view_hostile;
mod view_users;
mod watch;
mod work;
mod workspace;
