//! `--only` and `--all-formats`: which formats are written, and what they leave out.

use crate::args::{Formats, UnityVersion, ViewName};
use scenelang_base::door::Door;
use scenelang_base::plain;
use scenelang_export::glb::{Glb, WithPhysics};
use scenelang_export::picture::{Picture, PictureView};
use scenelang_export::unity::{self, Editor, Pipeline, Unity};
use scenelang_export::urdf::Urdf;
use scenelang_export::{Exporter, Loss, all_exporters, exporters};
use serde_json::{Value, json};
use std::path::Path;

/// The exporters asked for, Unity's for a pipeline; the usual ones if none are. A project that is in the folder already stays
/// one for its version of Unity.
pub fn chosen(asked: &Formats, pipeline: Pipeline, folder: &Path) -> Vec<Box<dyn Exporter>> {
    let known = if asked.all_formats || !asked.only.is_empty() { all_exporters() } else { exporters() };
    let editor = match asked.unity {
        Some(UnityVersion::V2022) => Editor::V2022,
        Some(UnityVersion::V6000) => Editor::V6000,
        None => of_project(folder).unwrap_or_default(),
    };
    let unity = Unity { pipeline, editor };
    let view = match asked.view {
        ViewName::Eye => PictureView::Eye,
        ViewName::Top => PictureView::Top,
        ViewName::Iso => PictureView::Iso,
    };
    let picture = Picture { view, size: asked.size };
    let own = |e: Box<dyn Exporter>| -> Box<dyn Exporter> {
        match e.name() {
            name if name == unity.name() => Box::new(unity),
            name if name == picture.name() => Box::new(picture),
            name if name == Glb.name() && asked.gltf_physics => Box::new(WithPhysics),
            _ => e,
        }
    };
    let wanted = known.into_iter().filter(|e| asked.only.is_empty() || asked.only.iter().any(|o| o == e.name()));
    wanted.map(own).collect()
}

/// The editor that the project in a folder was written for.
fn of_project(folder: &Path) -> Option<Editor> {
    let project = folder.join(unity::ROOT);
    let text = Door::within(folder).read(&project.join(unity::VERSION)).ok()?;
    Editor::of_project(&String::from_utf8_lossy(&text))
}

/// `--only`: the name of an exporter.
pub fn name(text: &str) -> Result<String, String> {
    let all = all_exporters();
    let names: Vec<_> = all.iter().map(|e| e.name()).collect();
    if text == Urdf::NAME {
        return Err("urdf contains a single object; name it with --object, or leave urdf out of --only".to_owned());
    }
    if names.contains(&text) { Ok(text.to_owned()) } else { Err(format!("valid formats: {}", names.join(", "))) }
}

/// What is left out, for people.
pub fn notes(lost: &[Loss]) -> String {
    lost.iter().map(|loss| format!("note: {}: {}\n", loss.format, plain::line(&loss.what.to_string()))).collect()
}

/// The same for programs.
pub fn json(lost: &[Loss]) -> Value {
    let entry =
        |loss: &Loss| json!({ "format": loss.format, "what": loss.what.key(), "message": loss.what.to_string() });
    lost.iter().map(entry).collect()
}
