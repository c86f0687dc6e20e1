//! All exporters together: what is written, and that it is the same each time.

use crate::fixture::scene;
use scenelang_export::{ExportError, Exporter, OutFile, Scene, all_exporters, write_all};

/// They have tests of their own: a picture takes long without optimisation.
const DRAWN: [&str; 2] = ["picture", "report"];

#[test]
fn the_same_scene_gives_the_same_bytes() {
    for exporter in all_exporters().iter().filter(|e| !DRAWN.contains(&e.name())) {
        assert_eq!(exporter.files(&scene()).unwrap(), exporter.files(&scene()).unwrap(), "{}", exporter.name());
    }
}

#[test]
fn paths_are_relative_and_below_the_output_folder() {
    let dir = tempfile::tempdir().unwrap();
    let some: Vec<Box<dyn Exporter>> = all_exporters().into_iter().filter(|e| !DRAWN.contains(&e.name())).collect();
    let written = write_all(&scene(), dir.path(), &some).unwrap();
    assert!(written.iter().all(|p| p.starts_with(dir.path()) && p.is_file()));
    let usual = ["room.glb", "plan.svg", "plan.png", "preview.html", "unity/Assets/Scenes/room.unity"];
    let further = ["room.mjcf.xml", "room.mjcf.json", "room.usda", "room.usdz", "sdf/room.sdf", "obj/room.obj"];
    for name in usual.iter().chain(&further) {
        assert!(written.contains(&dir.path().join(name)), "{name}");
    }
}

#[derive(Debug)]
struct Refuses;

impl Exporter for Refuses {
    fn name(&self) -> &'static str {
        "refuses"
    }
    fn files(&self, _: &Scene) -> Result<Vec<OutFile>, ExportError> {
        Err(ExportError::Format("refuses", "no".into()))
    }
}

#[test]
fn nothing_is_written_unless_all_succeed() {
    let dir = tempfile::tempdir().unwrap();
    let both: Vec<Box<dyn Exporter>> = vec![Box::new(scenelang_export::glb::Glb), Box::new(Refuses)];
    assert_eq!(write_all(&scene(), dir.path(), &both).unwrap_err().to_string(), "refuses: no");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
    // No folder can be made below a file.
    std::fs::write(dir.path().join("file"), "").unwrap();
    let nowhere = dir.path().join("file/nowhere");
    let error = write_all(&scene(), &nowhere, &[Box::new(scenelang_export::glb::Glb) as Box<dyn Exporter>]);
    assert!(error.unwrap_err().to_string().contains("nowhere"));
}
