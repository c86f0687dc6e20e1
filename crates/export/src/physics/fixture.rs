//! For tests: a cupboard with a door on hinges and a drawer, on the floor.

use crate::{Scene, SceneInput};
use scenelang_base::FileId;
use scenelang_lang::{Options, compile_text};
use scenelang_layout::file;
use std::path::Path;

const PROGRAM: &str = "region room; object cupboard; cupboard.category <- \"cupboard\";";

/// Parts: the case, the door on its front, hung on the left and opening by 110°, and the drawer below the door, by 30 cm.
const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "objects": { "cupboard": {
    "pos": [1, 0, -0.5], "rot": [0, 90, 0], "scale": [0.8, 1, 0.5], "asset": { "parts": [
        { "shape": "box", "pos": [0, 0.5, -0.01], "size": [0.8, 1, 0.48] },
        { "shape": "box", "pos": [0, 0.65, 0.24], "size": [0.78, 0.68, 0.02] },
        { "shape": "box", "pos": [0, 0.15, 0.24], "size": [0.78, 0.28, 0.02] } ], "joints": [
        { "name": "door", "motion": "hinge", "axis": [0, -1, 0], "anchor": [-0.39, 0.65, 0.23], "limits": [0, 110], "parts": [1] },
        { "name": "drawer", "motion": "slide", "axis": [0, 0, 1], "anchor": [0, 0, 0], "limits": [0, 0.3], "parts": [2] } ] } } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.6, 4] } }, "variables": {}, "draws": {} }"#;

/// The cupboard in its room.
pub fn cupboard() -> Scene {
    let compiled = compile_text("room.scene", Path::new("room.scene"), PROGRAM, Options::default());
    let program = compiled.program.unwrap();
    let layout = file::read(LAYOUT, FileId(0)).layout;
    let report = serde_json::json!({ "eta": 0.03, "constraints": [] });
    let files = [compiled.main];
    let (sources, layout_text) = (&compiled.sources, LAYOUT);
    Scene::build(&SceneInput {
        name: "room",
        program: &program,
        sources,
        files: &files,
        layout: &layout,
        layout_text,
        report: &report,
    })
    .unwrap()
}
