//! What the user has set in the editor: the section `scenelang`.

use serde::Deserialize;
use serde_json::Value;

/// The section. What is missing, or of another type, is as usual.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Which inlay hints are shown.
    pub hints: Hints,
    /// Where the layout of a program is, relative to the program's folder; `{stem}` stands for the program's name.
    pub layout: Option<String>,
}

/// Kinds of inlay hints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hints {
    /// The margin behind each assertion.
    pub margins: bool,
    /// What variables are in the layout.
    pub values: bool,
    /// How large objects are.
    pub sizes: bool,
}

impl Default for Config {
    fn default() -> Self {
        Self { hints: Hints { margins: true, values: true, sizes: true }, layout: None }
    }
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Section {
    inlay_hints: Value,
    layout: Value,
}

impl Config {
    /// Reads the section.
    pub fn read(value: &Value) -> Self {
        let section = Section::deserialize(value).unwrap_or_default();
        let on = |key: &str| section.inlay_hints[key].as_bool().unwrap_or(true);
        let layout = section.layout.as_str().filter(|pattern| !pattern.trim().is_empty());
        Self {
            hints: Hints { margins: on("margins"), values: on("values"), sizes: on("sizes") },
            layout: layout.map(str::to_owned),
        }
    }
}
