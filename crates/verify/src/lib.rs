//! The verifier: the one margin evaluator, geometry queries, physical rules, navigation; verdicts and reports.
//!
//! A formula has one meaning, its signed margin; [`evaluate`] computes it with any [`Number`]. [`check`] judges a whole
//! layout.
//!
//! Absent here: reading of programs and of layout files (`lang`, `layout`), layouts that change (`engine`), and any search
//! for a better one.

mod builtins;
pub mod check;
pub mod coded;
pub mod compare;
pub mod eval;
pub mod explain;
mod navigation;
pub mod number;
pub mod opening;
pub mod prove;
pub mod query;
pub mod report;
pub mod rules;
pub mod schemas;
pub mod settings;
mod tolerances;
pub mod trace;
pub mod vector;
mod world;

pub use builtins::{Declared, Slack, Surroundings, declared, gap, in_region, in_the_way, surroundings};
pub use check::{CheckVerdict, Checked, check};
pub use eval::{Cause, EvalError, Lazy, Scratch, Truth, Value, cone, evaluate, judge, objects_of};
pub use explain::Explain;
pub use number::{Algebra, Dual, Logic, Number};
pub use report::{Report, exit_code};
pub use scenelang_layout::Geometry;
pub use settings::Settings;
pub use tolerances::{DEFAULT_ETA, Detail, Opens, Options, Tolerances};
pub use world::{Body, ObjectInstance, RegionInstance, World};
