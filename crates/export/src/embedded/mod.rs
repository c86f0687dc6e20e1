//! The program and the layout that a GLB file, a USD file or a Unity project carries, read back as the scene stands now.
//!
//! Somebody may have moved a desk in Blender or in Unity since. So the transforms of the objects are read, too ([`glb`],
//! [`usd`], [`unity`]) and held against the layout that was embedded ([`edits`]): what was moved is where it was moved to, and
//! each change is reported. A scene that nobody changed gives the embedded layout back, to the byte.

mod documents;
mod edits;
mod glb;
mod prefab;
mod stand;
mod unity;
mod usd;
mod usda;

pub use edits::differences;

use scenelang_base::{Diagnostic, codes};
use scenelang_lang::library::IMPORTED;
use scenelang_lang::sources::{Loader, normal};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// A kind of file that carries a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    Glb,
    /// A layer of USD as text, or a package with one.
    Usd,
    /// The folder of a Unity project.
    Unity,
}

/// An embedded scene. As a [`Loader`] it gives the files of the program, as if they stood beside the layout.
#[derive(Clone, Debug)]
pub struct Embedded {
    /// How to call the layout in messages: as a file below the carrier.
    pub layout_name: String,
    /// The path of the same.
    pub layout_path: PathBuf,
    /// The path of the program's main file.
    pub main: PathBuf,
    /// The layout's text: the embedded one, with what was changed in the scene since.
    pub layout: String,
    /// The layout's text as it was embedded.
    pub exported: String,
    /// What was changed, one warning for each thing.
    pub changes: Vec<Diagnostic>,
    /// Why it is not known how the scene stands now, where it is not: then the layout is the embedded one.
    pub unread: Option<String>,
    files: BTreeMap<PathBuf, String>,
}

impl Embedded {
    /// The files of the program, each with its path as if it stood beside the layout; the standard library is everywhere.
    pub fn files(&self) -> impl Iterator<Item = (&Path, &str)> {
        let is_ours = |path: &Path| path.components().rev().nth(1).is_some_and(|folder| folder.as_os_str() == "std");
        let in_library = move |path: &Path, text: &str| is_ours(path) && IMPORTED.iter().any(|(_, own)| *own == text);
        let all = self.files.iter().map(|(path, text)| (path.as_path(), text.as_str()));
        all.filter(move |(path, text)| !in_library(path, text))
    }

    /// Takes over how the things of the scene stand now.
    fn updated(mut self, standing: &[stand::Standing]) -> Self {
        let edited = edits::apply(&self.layout, standing);
        self.changes = edited.changes;
        if let Some(layout) = edited.layout {
            self.layout = layout;
        }
        self
    }

    /// Says that it is not known how the scene stands now.
    fn unread(mut self, why: String) -> Self {
        let message = format!("{why}, so the embedded layout is checked");
        self.changes.push(Diagnostic::without_place(codes::W0504, message));
        self.unread = Some(why);
        self
    }
}

impl Loader for Embedded {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.files
            .get(&normal(path))
            .map(|text| text.clone().into_bytes())
            .ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// What kind of carrier a path is, if it is one.
pub fn carrier(path: &Path) -> Option<Carrier> {
    if path.is_dir() {
        let unity = path.join("Assets").is_dir() && path.join("ProjectSettings").is_dir();
        return unity.then_some(Carrier::Unity);
    }
    let extension = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match extension.as_str() {
        "glb" => Some(Carrier::Glb),
        "usda" | "usdc" | "usdz" | "usd" => Some(Carrier::Usd),
        _ => None,
    }
}

/// Reads what a carrier, called `name`, holds; files come from `loader`.
///
/// # Errors
/// It cannot be read, is not what its name says, or holds no scene of ours.
pub fn read(name: &str, path: &Path, carrier: Carrier, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    match carrier {
        Carrier::Glb => glb::read(name, path, loader),
        Carrier::Usd => usd::read(name, path, loader),
        Carrier::Unity => unity::read(name, path, loader),
    }
}

fn nothing(message: String) -> Box<Diagnostic> {
    let note = "`scenelang synth` embeds the program and the layout in the files it writes; \
                other programs may remove them";
    Box::new(Diagnostic::without_place(codes::E0008, message).note(note))
}

/// What a carrier holds, before anybody looks at how the scene stands now.
fn embedded(layout_name: String, layout_path: PathBuf, layout: &str, spec: &str, imports: &Value) -> Embedded {
    let folder = layout_path.parent().unwrap_or(Path::new(""));
    let document: Value = serde_json::from_str(layout.trim_start_matches('\u{feff}')).unwrap_or_default();
    // Without `scene` the program is looked for beside the layout.
    let main = normal(&folder.join(document["scene"].as_str().unwrap_or("layout.scene")));
    let beside = main.parent().map(Path::to_path_buf).unwrap_or_default();
    let texts = imports.as_object().into_iter().flatten();
    let mut files: BTreeMap<PathBuf, String> =
        texts.filter_map(|(path, text)| Some((normal(&beside.join(path)), text.as_str()?.to_owned()))).collect();
    files.insert(main.clone(), spec.to_owned());
    let layout = layout.to_owned();
    Embedded {
        layout_name,
        layout_path,
        main,
        exported: layout.clone(),
        layout,
        changes: Vec::new(),
        unread: None,
        files,
    }
}
