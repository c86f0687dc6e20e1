//! The report as one line of JSON.

use super::model::Report;

/// One line of JSON, without the line feed.
pub fn json(report: &Report) -> String {
    serde_json::to_string(report).expect("a report is made of strings, numbers and lists")
}
