//! JSON Schemas (draft 2020-12) of the files that tools exchange: the layout, the report, the comparison, the trace,
//! the brief of a request, what `query`, `repair` and `solve` print, the settings.

/// The schemas by name: name and text.
pub const ALL: [(&str, &str); 9] = [
    ("brief", include_str!("../schemas/brief.json")),
    ("config", include_str!("../schemas/config.json")),
    ("diff", include_str!("../schemas/diff.json")),
    ("layout", include_str!("../schemas/layout.json")),
    ("query", include_str!("../schemas/query.json")),
    ("repair", include_str!("../schemas/repair.json")),
    ("report", include_str!("../schemas/report.json")),
    ("solution", include_str!("../schemas/solution.json")),
    ("trace", include_str!("../schemas/trace.json")),
];

/// The schema of a name.
pub fn find(name: &str) -> Option<&'static str> {
    ALL.iter().find(|(n, _)| *n == name).map(|(_, text)| *text)
}
