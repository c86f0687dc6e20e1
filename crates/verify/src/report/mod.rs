//! Reports: a judgement as a value ([`Report`]), and that value for people, machines, code scanning, test runners and
//! pull requests.

mod build;
mod compact;
mod github;
mod human;
mod json;
mod junit;
pub mod model;
mod sarif;
mod words;

pub use build::{build, part_id, place, statement_id};
pub use compact::{compact, goes_with};
pub use github::github;
pub use human::{Human, diagnostics, human};
pub use json::json;
pub use junit::junit;
pub use model::Report;
pub use sarif::sarif;

/// Exit code of a report: 0 all holds; 1 something fails, or is proved impossible; 2 something could not be judged.
pub fn exit_code(report: &Report) -> u8 {
    let errors = || report.diagnostics.iter().filter(|d| d.severity == "error");
    // E04: statements that contradict each other. The program was judged, and cannot hold.
    let proof = |code: &str| code.starts_with("E04");
    if errors().any(|d| !proof(&d.code)) {
        2
    } else if errors().next().is_some() || report.constraints.iter().any(model::Row::is_violation) {
        1
    } else {
        0
    }
}
