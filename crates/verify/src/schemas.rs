//! JSON Schemas (draft 2020-12) of the files that tools exchange: the layout, the report, the comparison, the settings.

/// The schemas by name: name and text.
pub const ALL: [(&str, &str); 4] = [
    ("config", include_str!("../schemas/config.json")),
    ("diff", include_str!("../schemas/diff.json")),
    ("layout", include_str!("../schemas/layout.json")),
    ("report", include_str!("../schemas/report.json")),
];

/// The schema of a name.
pub fn find(name: &str) -> Option<&'static str> {
    ALL.iter().find(|(n, _)| *n == name).map(|(_, text)| *text)
}
