//! The program and the layout that a GLB file or a Unity project carries, read back.
//!
//! Absent here: what somebody has moved in such a file since. The layout is the one that was embedded.

use scenelang_base::{Diagnostic, codes};
use scenelang_lang::sources::{Loader, normal, unreadable};
use scenelang_layout::file::decode;
use serde_json::Value;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// A kind of file that carries a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// A GLB file.
    Glb,
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
    /// The layout's text.
    pub layout: String,
    files: BTreeMap<PathBuf, String>,
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
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("glb")).then_some(Carrier::Glb)
}

/// Reads what a carrier, called `name`, holds; files come from `loader`.
///
/// # Errors
/// It cannot be read, is not what its name says, or holds no scene of ours.
pub fn read(name: &str, path: &Path, carrier: Carrier, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    match carrier {
        Carrier::Glb => glb(name, path, loader),
        Carrier::Unity => unity(name, path, loader),
    }
}

fn glb(name: &str, path: &Path, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    let bytes = loader.load(path).map_err(|e| Box::new(unreadable(&format!("read {name}"), &e)))?;
    let Some(document) = json_chunk(&bytes) else { return Err(nothing(format!("{name} is not a GLB file"))) };
    let own = &document["scenes"][document["scene"].as_u64().unwrap_or(0) as usize]["extras"]["scenelang"];
    let (Some(spec), Some(layout)) = (own["spec"].as_str(), own["layout"].as_str()) else {
        return Err(nothing(format!("{name} is a GLB file without a program and a layout in it")));
    };
    Ok(embedded(format!("{name}/layout.json"), path.join("layout.json"), layout, spec, &own["imports"]))
}

/// The first chunk of a GLB file: a header of 12 bytes, then length, kind and data of each chunk.
fn json_chunk(bytes: &[u8]) -> Option<Value> {
    let number = |at: usize| bytes.get(at..at + 4)?.try_into().ok().map(u32::from_le_bytes);
    if !bytes.starts_with(b"glTF") || number(4)? != 2 || bytes.get(16..20)? != b"JSON" {
        return None;
    }
    let end = 20_usize.checked_add(number(12)? as usize)?;
    serde_json::from_slice(bytes.get(20..end)?).ok()
}

fn unity(name: &str, path: &Path, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    let text = |file: &str| loader.load(&path.join("Assets/Scenelang").join(file)).ok().map(decode).transpose();
    let (spec, layout) = (text("spec.scene.txt")?, text("layout.json")?);
    let (Some(spec), Some(layout)) = (spec, layout) else {
        return Err(nothing(format!("{name} is a Unity project without a program and a layout in it")));
    };
    let imports = text("imports.json")?.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    let file = "Assets/Scenelang/layout.json";
    Ok(embedded(format!("{name}/{file}"), path.join(file), &layout, &spec, &imports))
}

fn nothing(message: String) -> Box<Diagnostic> {
    let note = "scenelang synth embeds them in what it writes; other tools may drop them";
    Box::new(Diagnostic::without_place(codes::E0008, message).note(note))
}

fn embedded(layout_name: String, layout_path: PathBuf, layout: &str, spec: &str, imports: &Value) -> Embedded {
    let folder = layout_path.parent().unwrap_or(Path::new(""));
    let document: Value = serde_json::from_str(layout.trim_start_matches('\u{feff}')).unwrap_or_default();
    // Without `scene` the program is looked for beside the layout.
    let main = normal(&folder.join(document["scene"].as_str().unwrap_or("layout.scene")));
    let beside = main.parent().map(Path::to_path_buf).unwrap_or_default();
    let texts = imports.as_object().into_iter().flatten();
    let mut files: BTreeMap<PathBuf, String> =
        texts.filter_map(|(path, text)| Some((normal(&beside.join(path)), text.as_str()?.to_owned()))).collect();
    files.insert(main, spec.to_owned());
    Embedded { layout_name, layout_path, layout: layout.to_owned(), files }
}
