//! What is kept of a line: one file, written last and as a whole. A line that has it is done.

use super::manifest::Line;
use crate::replace;
use scenelang_base::door::Door;
use scenelang_base::owned::{Standing, standing};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What the file calls itself.
const FORMAT: &str = "scenelang.batchResult/1";

/// Why a line has no scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum FailureKind {
    /// The line is no job.
    Line,
    /// The request or the program cannot be read.
    Input,
    /// It is proved that the program has no layout.
    Contradiction,
    /// No layout was found in which all holds that must.
    Unsatisfied,
    /// It took too long.
    Time,
    /// It took too much memory.
    Memory,
    /// The process ended otherwise.
    Crash,
    /// Its files could not be written.
    Files,
}

/// What went wrong, in a sentence or several.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Trouble {
    pub kind: FailureKind,
    /// What happened.
    pub message: String,
}

impl Trouble {
    pub fn new(kind: FailureKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into() }
    }
}

/// What came of a line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    format: String,
    /// What its files are called.
    pub name: String,
    /// The sum of what the line asked for.
    pub key: String,
    /// Whether there is a scene.
    pub ok: bool,
    /// The program's file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    /// The layout's file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<String>,
    /// How many objects it has.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objects: Option<usize>,
    /// Why there is no scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<Trouble>,
}

impl Record {
    /// Of a scene. A program in a file of its own stays there, and `scene` is none.
    pub fn good(name: &str, key: &str, scene: Option<String>, objects: usize) -> Self {
        let layout = Some(layout_of(name));
        Self { ok: true, scene, layout, objects: Some(objects), ..Self::bad(name, key, None) }
    }

    /// Of a line without one.
    pub fn bad(name: &str, key: &str, error: Option<Trouble>) -> Self {
        let (format, name, key) = (FORMAT.to_owned(), name.to_owned(), key.to_owned());
        Self { format, name, key, ok: false, scene: None, layout: None, objects: None, error }
    }

    /// Writes it.
    ///
    /// # Errors
    /// What the file system says.
    pub fn write(&self, folder: &Path) -> Result<(), String> {
        let text = serde_json::to_string_pretty(self).map_err(|e| e.to_string())? + "\n";
        replace::json(&path(folder, &self.name), &text)
    }

    /// The one of a line, if it is as we wrote it.
    pub fn read(folder: &Path, name: &str) -> Option<Self> {
        let path = path(folder, name);
        if standing(&path).ok()? != Standing::Ours {
            return None;
        }
        let record: Self = serde_json::from_slice(&Door::of(&path).read(&path).ok()?).ok()?;
        (record.format == FORMAT && record.name == name).then_some(record)
    }

    /// The one of this line and no older one.
    pub fn of(folder: &Path, line: &Line) -> Option<Self> {
        Self::read(folder, &line.name).filter(|record| record.key == line.key)
    }
}

pub fn path(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.result.json"))
}

/// The file of a program.
pub fn scene_of(name: &str) -> String {
    format!("{name}.scene")
}

pub fn layout_of(name: &str) -> String {
    format!("{name}.layout.json")
}
