//! All examples: the page gets the bytes that the command line writes, which come from the same crates by another way.

use crate::ask;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scenelang_base::door::Door;
use scenelang_base::owned::sealed_json;
use scenelang_export::{Exporter, glb::Glb, preview};
use scenelang_playground::Session;
use scenelang_solve::Stop;
use scenelang_synth::{Hold, LayoutRequest, Observer, Solved, Stage};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

struct Quiet;

impl Observer for Quiet {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &scenelang_solve::Progress) {}
}

/// As `scenelang synth` asks: the file from disk, its whole path in messages, all cores.
fn by_command_line(path: &Path, stem: &str) -> Solved {
    let (name, layout_name, member) =
        (path.display().to_string(), format!("{stem}.layout.json"), format!("{stem}.scene"));
    let request = LayoutRequest {
        name: &name,
        path,
        files: &Door::of(path),
        start: None,
        before: None,
        share: 1,
        layout_name: &layout_name,
        scene_member: &member,
        hold: Hold::Nothing,
        time: None,
        alternatives: None,
        free: 0,
        threads: 0,
        effort: 1,
        quality: scenelang_solve::QUALITY,
        stop: &Stop::default(),
        seed: 0,
        judge: scenelang_verify::Options::default(),
        furniture: None,
    };
    scenelang_synth::solve(&request, &mut Quiet).expect("examples have layouts")
}

/// Solves an example both ways, and compares all that comes of it.
fn same(stem: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(format!("{stem}.scene"));
    let text = std::fs::read_to_string(&path).expect("it is there");
    let name = format!("{stem}.scene");
    let mut session = Session::default();
    let mut wanted = |request: Value| ask(&mut session, &request).expect("an example is no reason to refuse");

    let solved = wanted(json!({ "method": "solve", "name": name, "text": text, "start": null, "seed": 0 }));
    let expected = by_command_line(&path, stem);
    assert_eq!(solved["layout"], expected.first.text.as_str(), "layout of {stem}");
    assert_eq!((&solved["converged"], &solved["end"]), (&json!(true), &json!("solved")), "{stem}");

    let marks = wanted(json!({ "method": "open", "name": name, "text": text, "layout": solved["layout"] }));
    assert_eq!((&marks["complete"], &marks["placed"], &marks["count"][2]), (&json!(true), &json!(true), &json!(0)));
    let scene = scenelang_synth::scene(&expected, stem).expect("it can be exported");
    let file = wanted(json!({ "method": "export", "format": "glb" }));
    let bytes = STANDARD.decode(file["base64"].as_str().expect("a text")).expect("base64");
    let glb = Glb.files(&scene).expect("it can be written").remove(0);
    assert_eq!(Path::new(file["name"].as_str().expect("a name")), glb.path);
    assert!(bytes == glb.bytes, "the GLB of {stem} differs");
    let file = wanted(json!({ "method": "export", "format": "layout" }));
    assert_eq!(file["text"], sealed_json(&expected.first.text));

    let mut room = wanted(json!({ "method": "room", "known": null, "plan": true }));
    let mut live = preview::live(scene, None, true).expect("it can be shown");
    // The verdict that an editor shows while somebody types is not explained.
    for report in [&mut room["report"], &mut live["report"]] {
        *report = report["constraints"].as_array().expect("rows").iter().map(|row| row["margin"].clone()).collect();
    }
    assert!(room == live, "the room of {stem} differs");
    let again = wanted(json!({ "method": "room", "known": room["shape"], "plan": false }));
    assert_eq!(
        (&again["glb"], &again["plan"]),
        (&Value::Null, &json!("")),
        "what is known, or not wanted, is not sent"
    );
}

#[test]
fn apartment() {
    same("apartment");
}

#[test]
fn bedroom() {
    same("bedroom");
}

#[test]
fn classroom() {
    same("classroom");
}

#[test]
fn meeting_room() {
    same("meeting-room");
}

#[test]
fn restaurant() {
    same("restaurant");
}

#[test]
fn robot_lab() {
    same("robot-lab");
}

#[test]
fn workshop_safety() {
    same("workshop-safety");
}

#[test]
fn no_example_is_left_out() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let here = include_str!("examples.rs");
    for entry in std::fs::read_dir(folder).expect("it is there") {
        let name = entry.expect("it can be read").file_name().to_string_lossy().into_owned();
        let stem = name.strip_suffix(".scene").expect("examples are programs");
        assert!(here.contains(&format!("same(\"{stem}\")")), "{name} is not compared");
    }
}
