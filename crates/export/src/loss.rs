//! What a format cannot hold of a scene: told to whoever asks for the format, never left out in silence.

use crate::{Exporter, Scene};
use std::fmt;

/// Something of a scene that is not in the files of a format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loss {
    /// The format: `sdf`.
    pub format: &'static str,
    pub what: Lost,
}

/// What can be lost. `Display` says it in a sentence, and what comes of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lost {
    /// These objects may share space, and an engine will push them apart.
    Overlaps(Vec<[String; 2]>),
    /// Masses, what stands still and what is loose.
    Physics,
    /// So many lights.
    Lights(usize),
    /// What is drawn: the solids are shown in its place.
    Meshes,
    /// Textures: things have their mean colours.
    Textures,
    /// All other things, and the room.
    Others,
    /// Program, layout and report: no command can judge these files.
    Program,
}

impl Lost {
    /// Its name for programs.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Overlaps(_) => "overlaps",
            Self::Physics => "physics",
            Self::Lights(_) => "lights",
            Self::Meshes => "meshes",
            Self::Textures => "textures",
            Self::Others => "others",
            Self::Program => "program",
        }
    }
}

/// So many pairs are named.
const NAMED: usize = 3;

impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlaps(pairs) => {
                let named: Vec<String> = pairs.iter().take(NAMED).map(|[a, b]| format!("{a} and {b}")).collect();
                let more = pairs.len().saturating_sub(NAMED);
                let more = if more == 0 { String::new() } else { format!(", and {more} more pairs") };
                write!(f, "permissions to overlap are lost: {}{more} may be pushed apart", named.join(", "))
            }
            Self::Physics => f.write_str("masses are lost, and so is the distinction between fixed and loose objects"),
            Self::Lights(1) => f.write_str("the light is lost"),
            Self::Lights(n) => write!(f, "the {n} lights are lost"),
            Self::Meshes => f.write_str("objects are shown as their solids, without rounded edges and small details"),
            Self::Textures => f.write_str("textures are lost: wood, fabric and the like have plain colours"),
            Self::Others => f.write_str("the file contains one object and nothing of the room around it"),
            Self::Program => {
                f.write_str("program, layout and report are not embedded in the files, so `check` cannot check them")
            }
        }
    }
}

/// What some exporters leave out of a scene, exporter by exporter.
pub fn losses(scene: &Scene, exporters: &[Box<dyn Exporter>]) -> Vec<Loss> {
    let of =
        |e: &dyn Exporter| e.lost(scene).into_iter().map(|what| Loss { format: e.name(), what }).collect::<Vec<_>>();
    exporters.iter().flat_map(|e| of(e.as_ref())).collect()
}
