//! What an output folder was made from, stage by stage and object by object, so that the next run makes again only what an edit
//! touches.
//!
//! The manifest stands in the folder as [`NAME`]. It has the sum of what goes into each stage and of what comes out of it. A
//! stage is kept if both are as they were: what goes in, and what lies on the disk. While files are being replaced, the manifest
//! has the old and the new state, so that a run that was ended in between is gone on with.

mod inputs;
mod plan;
mod why;

pub use inputs::{AssetInput, Inputs, Looks};
pub(crate) use inputs::{How, layout_inputs, prefers_otherwise, shape};
pub use plan::{Format, Planned, own_names, planned};
pub use why::{of_layout, of_program};

use scenelang_base::FileId;
use scenelang_base::door::Door;
use scenelang_base::owned::{Record, full, sum_below};
use scenelang_layout::{Layout, file};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// The manifest's file.
pub const NAME: &str = ".scenelang-manifest.json";
/// What the manifest calls itself.
const FORMAT: &str = "scenelang.rebuild/1";
/// How many digits of a sum tell two states apart.
const DIGITS: usize = 16;

/// The manifest of a folder.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    format: String,
    /// By the stem of the program.
    scenes: BTreeMap<String, Known>,
}

/// What is known of a scene. A stage has two states as long as its files are being replaced.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// The program, and the request that it was written from.
    #[serde(default)]
    pub program: Vec<State>,
    /// What each object was given.
    #[serde(default)]
    pub assets: Looks,
    #[serde(default)]
    pub layout: Vec<State>,
    /// What is written besides the formats: program, imports, layout, report.
    #[serde(default)]
    pub own: Vec<String>,
    /// The exported formats, by name.
    #[serde(default)]
    pub formats: BTreeMap<String, Vec<State>>,
}

/// A stage as it was made once.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Sums of what went into it.
    pub inputs: Inputs,
    /// Files that came of it, below the folder, with `/` between the parts.
    pub files: Vec<String>,
    /// The sum of these files.
    pub sum: String,
    /// Of a layout: whether all that must hold does.
    #[serde(default)]
    pub converged: bool,
}

impl State {
    /// Whether its files lie in the folder as they were written.
    pub fn is_there(&self, folder: &Path) -> bool {
        sum_below(folder, self.files.iter().map(String::as_str)).is_some_and(|sum| sum == self.sum)
    }
}

impl Manifest {
    /// The manifest of a folder; an empty one where there is none, or none that can be read.
    pub fn of(folder: &Path) -> Self {
        let bytes = Door::within(folder).read(&folder.join(NAME)).unwrap_or_default();
        let read: Self = serde_json::from_slice(&bytes).unwrap_or_default();
        if read.format == FORMAT { read } else { Self::default() }
    }

    pub fn scene(&self, stem: &str) -> Known {
        self.scenes.get(stem).cloned().unwrap_or_default()
    }

    /// Files that other scenes of the folder have.
    fn others(&self, stem: &str) -> impl Iterator<Item = &str> {
        let scenes = self.scenes.iter().filter(move |(name, _)| *name != stem).map(|(_, known)| known);
        scenes.flat_map(Known::files)
    }

    /// The record of a change after which `new` is known of a scene, and until then also what was.
    pub fn record(&self, stem: &str, new: &Known) -> Record {
        let during = Known {
            program: both(&self.scene(stem).program, &new.program),
            layout: both(&self.scene(stem).layout, &new.layout),
            formats: {
                let mut all = self.scene(stem).formats;
                for (name, states) in &new.formats {
                    let old = all.remove(name).unwrap_or_default();
                    all.insert(name.clone(), both(&old, states));
                }
                all
            },
            own: self.scene(stem).own.iter().chain(&new.own).cloned().collect(),
            assets: new.assets.clone(),
        };
        Record { name: NAME.into(), during: self.with(stem, during), after: self.with(stem, new.clone()) }
    }

    fn with(&self, stem: &str, known: Known) -> Vec<u8> {
        let mut all = Self { format: FORMAT.to_owned(), scenes: self.scenes.clone() };
        all.scenes.insert(stem.to_owned(), known);
        let text = serde_json::to_string_pretty(&all).unwrap_or_default();
        (text + "\n").into_bytes()
    }
}

/// Old states and new ones, each once.
fn both(old: &[State], new: &[State]) -> Vec<State> {
    let fresh = new.iter().filter(|state| !old.contains(state));
    old.iter().chain(fresh).cloned().collect()
}

impl Known {
    /// All files, in no order.
    fn files(&self) -> impl Iterator<Item = &str> {
        let states = self.formats.values().flatten().flat_map(|state| &state.files);
        self.own.iter().chain(states).map(String::as_str)
    }

    /// The state of a stage that lies in the folder, if one does.
    pub fn state<'s>(states: &'s [State], folder: &Path) -> Option<&'s State> {
        states.iter().rev().find(|state| state.is_there(folder))
    }

    /// The layout that lies in the folder as it was made; `None`: there is none, or it was edited, or it is no place to go on
    /// from, because not all that must hold does.
    pub fn layout(&self, folder: &Path) -> Option<Before> {
        let state = Self::state(&self.layout, folder).filter(|state| state.converged)?;
        let path = folder.join(state.files.first()?);
        let text = String::from_utf8(Door::within(folder).read(&path).ok()?).ok()?;
        let read = file::read(&text, FileId(0));
        if !read.usable || read.diagnostics.iter().any(scenelang_base::Diagnostic::is_error) {
            return None;
        }
        Some(Before { text, layout: read.layout, inputs: state.inputs.clone(), looks: self.assets.clone() })
    }
}

/// The layout of an earlier run, in which all that must hold does.
#[derive(Clone, Debug)]
pub struct Before {
    /// The layout's text.
    pub text: String,
    /// The same, read.
    pub layout: Layout,
    /// What it was made from.
    pub inputs: Inputs,
    /// What each object was given.
    pub looks: Looks,
}

/// A sum that tells two states apart.
pub fn sum(bytes: &[u8]) -> String {
    let mut sum = full(bytes);
    sum.truncate(DIGITS);
    sum
}
