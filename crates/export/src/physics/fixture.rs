//! For tests: a cupboard with a door on hinges and a drawer, on the floor.

use super::{Body, Motion, Movable, Physics};
use crate::{Scene, SceneInput};
use scenelang_base::FileId;
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Vec3, file};
use std::path::Path;

const PROGRAM: &str = "region room; object cupboard; cupboard.category <- \"cupboard\";";

/// Parts: the case, the door on its front, hung on the left, and the drawer below the door.
const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "objects": { "cupboard": {
    "pos": [1, 0, -0.5], "rot": [0, 90, 0], "scale": [0.8, 1, 0.5], "asset": { "parts": [
        { "shape": "box", "pos": [0, 0.5, -0.01], "size": [0.8, 1, 0.48] },
        { "shape": "box", "pos": [0, 0.65, 0.24], "size": [0.78, 0.68, 0.02] },
        { "shape": "box", "pos": [0, 0.15, 0.24], "size": [0.78, 0.28, 0.02] } ] } } },
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

/// What of it can be opened: the door by 110°, the drawer by 30 cm.
pub fn movable() -> [Movable<'static>; 2] {
    [
        Movable {
            name: "door",
            motion: Motion::Hinge,
            axis: -Vec3::y(),
            anchor: Vec3::new(-0.39, 0.65, 0.23),
            limits: [0.0, 110.0],
            parts: &[1],
        },
        Movable {
            name: "drawer",
            motion: Motion::Slide,
            axis: Vec3::z(),
            anchor: Vec3::zeros(),
            limits: [0.0, 0.3],
            parts: &[2],
        },
    ]
}

/// The scene, with what can be opened.
pub fn opened(scene: &Scene) -> Physics<'_> {
    let mut physics = Physics::of(scene);
    physics.bodies[0] = Body::object(&scene.objects[0], &movable());
    physics
}
