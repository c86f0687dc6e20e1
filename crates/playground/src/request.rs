//! What may be asked. A request is a JSON object with a `method` and its parameters; offsets are units of UTF-16.

use serde::Deserialize;

/// A request. Those about the open program need one.
#[derive(Debug, Deserialize)]
#[serde(tag = "method", rename_all = "lowercase", deny_unknown_fields)]
pub enum PageRequest {
    /// Another program, without a layout, or with the text of one: what is wrong with it, and its colours.
    Open {
        name: String,
        text: String,
        layout: Option<String>,
    },
    /// Another text of the program; its layout stays.
    Edit {
        text: String,
    },
    /// Another layout.
    Layout {
        text: Option<String>,
    },
    /// What a viewer shows; the geometry is left out if it has the shape that is `known`, and the plan if it is not wanted.
    Room {
        known: Option<String>,
        plan: bool,
    },
    /// What could be written at an offset; `asked`: somebody wants to know, and did not just type.
    Complete {
        at: u32,
        asked: bool,
    },
    /// More about a proposal.
    Describe {
        about: String,
    },
    /// What is at an offset.
    Hover {
        at: u32,
    },
    /// The program, formatted.
    Format,
    /// An object elsewhere: what then holds. With `commit` the answer has the layout, too.
    Move {
        object: String,
        pos: [f64; 3],
        rot: [f64; 3],
        commit: bool,
    },
    /// What is proved of the open program.
    Proofs,
    /// A file of the room: `glb`, `layout` or `report`.
    Export {
        format: Format,
    },
    /// A layout of a program, from nothing or from another one.
    Solve {
        name: String,
        text: String,
        start: Option<String>,
        seed: u64,
    },
    /// A room from plain English: its program, and a layout.
    Write {
        text: String,
    },
    Version,
}

/// What a room can be written as.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// One file with its geometry, in base64.
    Glb,
    Layout,
    /// The report as JSON.
    Report,
}
