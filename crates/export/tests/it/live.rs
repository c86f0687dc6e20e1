//! A room that is shown again after every edit: what is the same is not drawn again, and not sent again.

use scenelang_base::FileId;
use scenelang_export::scene::Memory;
use scenelang_export::{Scene, SceneInput, preview};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::file;
use serde_json::{Value, json};
use std::path::Path;

const PROGRAM: &str = "region room; object desk; desk.category <- \"desk\"; object lamp; lamp.category <- \"floor lamp\"; \
                       object cupboard; cupboard.category <- \"wardrobe\"; cupboard.color <- \"white\";";
const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "objects": {
    "desk": { "pos": [1, 0, -0.5], "rot": [0, 90, 0], "scale": [1.4, 0.74, 0.7] },
    "lamp": { "pos": [-1, 0, 1], "rot": [0, 0, 0], "scale": [0.4, 1.6, 0.4] },
    "cupboard": { "pos": [-1, 0, -1], "rot": [0, 0, 0], "scale": [1, 2, 0.6], "asset": { "parts": [
        { "shape": "box", "pos": [0, 1, -0.01], "size": [1, 2, 0.58] },
        { "shape": "box", "pos": [0, 1, 0.29], "size": [1, 2, 0.02] } ], "joints": [
        { "name": "door", "motion": "hinge", "axis": [0, -1, 0], "anchor": [-0.5, 1, 0.28], "limits": [0, 110], "parts": [1] } ] } } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.6, 4] } }, "variables": {}, "draws": {} }"#;

/// The scene of a program and a layout; `memory`: what was drawn before.
fn scene(program: &str, layout: &str, memory: Option<&Memory>) -> Scene {
    let compiled = compile_text("room.scene", Path::new("room.scene"), program, Options::default());
    let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let read = file::read(layout, FileId(0));
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    let input = SceneInput {
        name: "room",
        program: &program,
        sources: &compiled.sources,
        files: &[compiled.main],
        layout: &read.layout,
        layout_text: layout,
        report: &json!({ "eta": 0.03, "constraints": [] }),
    };
    memory.map_or_else(|| Scene::build(&input), |memory| Scene::remembered(&input, memory)).unwrap()
}

fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replace(from, to)
}

/// Edits of the program or the layout by which nothing looks otherwise: from, to.
const MOVES: [[&str; 2]; 6] = [
    [r#""pos": [1, 0, -0.5]"#, r#""pos": [1.2, 0, 0.5]"#],
    [r#""rot": [0, 90, 0]"#, r#""rot": [0, 45, 0]"#],
    [r#""rot": [0, 90, 0]"#, r#""rot": [10, 45, 5]"#],
    [r#""pos": [-1, 0, 1]"#, r#""pos": [0.5, 0, 0.5]"#],
    [r#""pos": [-1, 0, -1]"#, r#""pos": [1, 0, 1.2]"#],
    ["desk.category <- \"desk\";", "desk.category <- \"desk\"; assert desk.pos.x > 0;"],
];

#[test]
fn what_is_only_moved_is_not_drawn_again() {
    let memory = Memory::default();
    let first = preview::live(scene(PROGRAM, LAYOUT, Some(&memory)), None, true).unwrap();
    assert!(first["glb"].is_string());
    assert_eq!(memory.drawn(), 3);
    let shape = first["shape"].as_str().unwrap();
    for [from, to] in MOVES {
        let edited = [PROGRAM, LAYOUT].map(|text| text.replace(from, to));
        assert_ne!(edited, [PROGRAM, LAYOUT], "{from}");
        let [program, layout] = edited;
        let again = preview::live(scene(&program, &layout, Some(&memory)), Some(shape), true).unwrap();
        assert_eq!((&again["shape"], &again["glb"]), (&first["shape"], &Value::Null), "{to}");
        assert_eq!(memory.drawn(), 3, "{to}");
        // All of it is as if nothing were known of earlier scenes, and the geometry really is the same.
        let anew = preview::live(scene(&program, &layout, None), None, true).unwrap();
        for member in ["plan", "objects", "regions", "shape"] {
            assert_eq!(anew[member], again[member], "{member}: {to}");
        }
        assert_eq!(anew["glb"], first["glb"], "{to}");
    }
}

#[test]
fn whoever_shows_geometry_gets_no_plan() {
    let told = preview::live(scene(PROGRAM, LAYOUT, None), None, false).unwrap();
    assert_eq!(told["plan"], "");
}

/// Edits by which something looks otherwise: from, to, and how many objects are drawn for it.
const CHANGES: [(&str, &str, usize); 12] = [
    ("desk.category <- \"desk\";", "desk.category <- \"table\";", 1),
    ("desk.category <- \"desk\";", "desk.category <- \"desk\"; desk.color <- \"red\";", 1),
    ("desk.category <- \"desk\";", "desk.category <- \"desk\"; desk.material <- \"steel\";", 1),
    ("desk.category <- \"desk\";", "desk.category <- \"desk\"; desk.features <- \"standing\";", 1),
    ("[1.4, 0.74, 0.7]", "[1.5, 0.74, 0.7]", 1),
    // What stands on the floor without a colour of its own has one that differs from it.
    ("region room;", "region room; room.floorColor <- \"black\";", 2),
    ("region room;", "region room; room.wallColor <- \"red\";", 0),
    ("[4, 2.6, 4]", "[4, 2.7, 4]", 0),
    (r#""size": [1, 2, 0.02]"#, r#""size": [1, 1.9, 0.02]"#, 1),
    (r#""name": "door""#, r#""name": "leaf""#, 0),
    (r#""parts": [1]"#, r#""parts": [0]"#, 0),
    ("region room;", "region room; object stool; stool.category <- \"stool\";", 1),
];

#[test]
fn what_looks_otherwise_has_another_shape() {
    let shown = |told: &Value| (told["shape"].clone(), told["glb"].clone());
    let first = shown(&preview::live(scene(PROGRAM, LAYOUT, None), None, false).unwrap());
    for (from, to, drawn) in CHANGES {
        let memory = Memory::default();
        scene(PROGRAM, LAYOUT, Some(&memory));
        let program = PROGRAM.replace(from, to);
        let mut layout = LAYOUT.replace(from, to);
        assert!(program != PROGRAM || layout != LAYOUT, "{from}");
        if to.contains("stool") {
            let stool = r#""stool": { "pos": [0, 0, 0], "rot": [0, 0, 0], "scale": [0.4, 0.5, 0.4] }, "desk""#;
            layout = replaced(&layout, "\"desk\"", stool);
        }
        let again = preview::live(scene(&program, &layout, Some(&memory)), first.0.as_str(), false).unwrap();
        assert_ne!(again["shape"], first.0, "{to}");
        assert!(again["glb"].is_string() && again["glb"] != first.1, "{to}");
        assert_eq!(memory.drawn(), 3 + drawn, "{to}");
        let anew = preview::live(scene(&program, &layout, None), None, false).unwrap();
        assert_eq!(shown(&anew), shown(&again), "{to}");
    }
}

#[test]
fn what_comes_back_is_remembered_and_the_rest_is_forgotten() {
    let memory = Memory::default();
    let coloured = |color: usize| {
        let own = format!("desk.category <- \"desk\"; desk.color <- \"#{color:06x}\";");
        scene(&replaced(PROGRAM, "desk.category <- \"desk\";", &own), LAYOUT, Some(&memory));
        memory.drawn()
    };
    assert_eq!((coloured(1), coloured(2), coloured(1)), (3, 4, 4));
    let after = (1..=300).map(coloured).last().unwrap();
    assert_eq!(after, 3 + 299, "each colour once, and the others not again");
    assert_eq!(coloured(1), after + 1, "it was too long ago");
}

#[test]
fn the_light_of_a_lamp_goes_with_it() {
    use base64::Engine;
    let told = preview::live(scene(PROGRAM, LAYOUT, None), None, false).unwrap();
    let glb = base64::engine::general_purpose::STANDARD.decode(told["glb"].as_str().unwrap()).unwrap();
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let document: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let light = document["nodes"].as_array().unwrap().iter().find(|node| node["name"] == "lamp/light").unwrap();
    let at: Vec<f64> = light["translation"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert!(
        at[0].abs() < 0.01 && at[2].abs() < 0.01 && (0.5..1.6).contains(&at[1]),
        "above the lamp's own foot: {at:?}"
    );
}
