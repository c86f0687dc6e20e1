//! Two rooms, a zone, furniture of every kind of body, and a report with one violation.

use scenelang_assets::{AssetRequest, furnish};
use scenelang_base::{FileId, SourceMap};
use scenelang_export::{BuildError, Exporter, Scene, SceneInput};
use scenelang_lang::program::Program;
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Layout, file};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const PROGRAM: &str = r##"
region hall; hall.wallColor <- "white"; hall.floorMaterial <- "oak";
region den;
region corner;
object table; table.category <- "table";
/// Two of them.
object chair[2]; chair.category <- "chair"; chair.color <- "#000080";
object balloon;
object picture; picture.category <- "painting";
object door; door.category <- "door";
object window; window.category <- "window";
object NAME; NAME.category <- "crate";
allowFloat(balloon);
assert wallMounted(picture, hall);
assert connects(door, hall, den);
assert connects(window, hall);
assert forall c in chair: gap(c, table) >= 0;
assert table.pos.x = 1;
"##;

const LAYOUT: &str = r#"{
  "format": "scenelang.layout/1",
  "objects": {
    "table":    { "pos": [0, 0, 0], "rot": [0, 0, 0], "scale": [1.6, 0.75, 0.8] },
    "chair[0]": { "pos": [-0.4, 0, 1], "rot": [0, 180, 0], "scale": [0.5, 0.9, 0.5] },
    "chair[1]": { "pos": [0.4, 0, 1], "rot": [0, 165, 0], "scale": [0.5, 0.9, 0.5] },
    "balloon":  { "pos": [-1.2, 1.8, -1], "scale": [0.3, 0.4, 0.3] },
    "picture":  { "pos": [0, 1.4, 1.98], "rot": [0, 180, 0], "scale": [0.8, 0.6, 0.04] },
    "door":     { "pos": [2.03, 0, 0], "rot": [0, 90, 0], "scale": [0.9, 2, 0.08] },
    "window":   { "pos": [-0.5, 0.9, -2.015], "rot": [0, 0, 0], "scale": [1.2, 1.2, 0.06] },
    "NAME":     { "pos": [3, 0, 0], "rot": [0, 30, 0], "scale": [0.4, 0.4, 0.4],
                  "asset": { "parts": [
                    { "shape": "box", "pos": [0, 0.1, 0], "size": [0.4, 0.2, 0.4] },
                    { "shape": "box", "pos": [0, 0.3, 0], "size": [0.1, 0.1, 0.1], "rot": [0, 45, 0] },
                    { "shape": "cylinder", "pos": [0, 0.3, 0], "radius": 0.2, "height": 0.2 } ] } }
  },
  "regions": {
    "hall":   { "pos": [0, 0, 0], "scale": [4, 2.6, 4] },
    "den":    { "pos": [3.06, 0, 0], "scale": [2, 2.6, 4] },
    "corner": { "pos": [-1.2, 0, -1.2], "scale": [1, 2.6, 1] }
  },
  "variables": {}, "draws": {}
}
"#;

/// What a scene is built from, all of it owned.
pub struct Parts {
    pub program: Program,
    pub sources: SourceMap,
    pub main: FileId,
    pub layout: Layout,
    pub report: Value,
}

pub fn parts() -> Parts {
    named("crate")
}

/// With another name for the crate, to be written by exporters.
pub fn named(name: &str) -> Parts {
    let text = PROGRAM.replace("NAME", name);
    let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
    let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let mut read = file::read(&LAYOUT.replace("NAME", name), FileId(0));
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    for (object, (_, place)) in program.objects.iter().zip(&mut read.layout.objects) {
        if place.parts.is_empty() && object.name != "balloon" {
            let asset = furnish(&AssetRequest {
                name: &object.name,
                category: &object.category,
                size: Some(place.scale),
                ..AssetRequest::default()
            });
            place.parts = asset.parts;
        }
    }
    let row = |line: u32, kind: &str, satisfied: bool, margin: f64, objects: &[&str], text: &str| {
        json!({ "id": format!("out/room.scene:{line}:1"), "kind": kind, "rule": null, "code": null, "satisfied": satisfied,
                "margin": margin, "unit": "m", "objects": objects, "text": text, "message": "" })
    };
    let report = json!({
        "format": "scenelang.report/1", "file": "room.layout.json", "ok": false, "eta": 0.03,
        "summary": { "assertions": { "total": 5, "satisfied": 4 } },
        "constraints": [
            row(17, "assert", true, 0.1, &["chair[1]", "table"], "forall c in chair: gap(c, table) >= 0"),
            row(18, "assert", false, -0.999, &["table"], "table.pos.x = 1 </script><b>"),
            row(19, "prefer", false, -1.0, &["balloon"], "balloon.pos.y < 1"),
        ],
        "diagnostics": []
    });
    Parts { program, sources: compiled.sources, main: compiled.main, layout: read.layout, report }
}

impl Parts {
    pub fn build(&self) -> Result<Scene, BuildError> {
        Scene::build(&SceneInput {
            name: "room",
            program: &self.program,
            sources: &self.sources,
            files: &[self.main],
            layout: &self.layout,
            layout_text: LAYOUT,
            report: &self.report,
        })
    }
}

pub fn scene() -> Scene {
    parts().build().unwrap()
}

/// The scene of the fixture with another layout, as files in a folder of its own, and the text of the layout.
pub fn written(layout: &Layout, exporters: &[&dyn Exporter]) -> (tempfile::TempDir, String) {
    let (parts, text) = (parts(), file::to_json(layout, None));
    let scene = Scene::build(&SceneInput {
        name: "room",
        program: &parts.program,
        sources: &parts.sources,
        files: &[parts.main],
        layout,
        layout_text: &text,
        report: &parts.report,
    });
    let (scene, folder) = (scene.unwrap(), tempfile::tempdir().unwrap());
    for out in exporters.iter().flat_map(|exporter| exporter.files(&scene).unwrap()) {
        let path = folder.path().join(out.path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, out.bytes).unwrap();
    }
    (folder, text)
}

/// The Python that has a module; `None`, which is said: there is none, so a test is skipped. In CI there must be one.
pub fn python_with(module: &str) -> Option<PathBuf> {
    let own = [".venv/bin/python", "../../.venv/bin/python"].map(PathBuf::from).into_iter().find(|path| path.exists());
    let has = |python: &PathBuf| {
        let import = format!("import {module}");
        Command::new(python).args(["-c", &import]).output().is_ok_and(|output| output.status.success())
    };
    let found = own.filter(has);
    if found.is_none() {
        assert!(std::env::var_os("CI").is_none(), "CI has {module}");
        eprintln!("skipped: {module} is not installed");
    }
    found
}
