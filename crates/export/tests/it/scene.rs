//! The scene itself: bodies, rows, walls, and what cannot be drawn.

use crate::fixture::{parts, scene};
use scenelang_base::FileId;
use scenelang_export::scene::{Body, RegionKind, Role};
use scenelang_export::{BuildError, Scene, SceneInput};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Vec2, file};
use serde_json::json;
use std::path::Path;

#[test]
fn bodies_follow_what_the_program_allows() {
    use Body::{Free, Held, Static};
    let found: Vec<(String, Body)> = scene().objects.into_iter().map(|o| (o.name, o.body)).collect();
    let want = [
        ("table", Free),
        ("chair[0]", Free),
        ("chair[1]", Free),
        ("balloon", Held),
        ("picture", Held),
        ("door", Static),
        ("window", Static),
        ("crate", Free),
    ];
    assert_eq!(found, want.map(|(n, b)| (n.to_owned(), b)));
}

#[test]
fn rows_reach_all_objects_a_statement_reads_not_only_the_deciding_ones() {
    let scene = scene();
    let rows = |name: &str| scene.objects.iter().find(|o| o.name == name).unwrap().rows.clone();
    assert_eq!(rows("chair[0]"), [0]);
    assert_eq!(rows("chair[1]"), [0]);
    assert_eq!(rows("table"), [0, 1]);
    let violated: Vec<&str> = scene.objects.iter().filter(|o| o.violated).map(|o| o.name.as_str()).collect();
    assert_eq!(violated, ["table"], "a preference that fails is no violation");
}

#[test]
fn declarations_are_quoted_from_the_program() {
    let found: Vec<String> = scene().objects.into_iter().map(|o| o.declaration).collect();
    assert_eq!(found[1], "object chair[2];");
    assert_eq!(found[2], "object chair[2];");
    assert_eq!(found[5], "object door;");
}

#[test]
fn rooms_have_walls_with_holes_and_zones_only_a_tint() {
    let scene = scene();
    let kinds: Vec<RegionKind> = scene.regions.iter().map(|r| r.kind).collect();
    assert_eq!(kinds, [RegionKind::Room, RegionKind::Room, RegionKind::Zone]);
    let walls: Vec<(&str, usize)> = scene
        .shells
        .iter()
        .filter(|s| matches!(s.role, Role::Wall { .. }))
        .map(|s| (s.name.as_str(), s.pieces.len()))
        .collect();
    // The window leaves four pieces (sides, sill, lintel), the door three in the walls of both rooms.
    assert_eq!(
        walls,
        [
            ("hall/wall0", 4),
            ("hall/wall1", 3),
            ("hall/wall2", 1),
            ("hall/wall3", 1),
            ("den/wall0", 1),
            ("den/wall1", 1),
            ("den/wall2", 1),
            ("den/wall3", 3),
        ]
    );
    let corner: Vec<&Role> = scene.shells.iter().filter(|s| s.name.starts_with("corner")).map(|s| &s.role).collect();
    assert_eq!(corner, [&Role::Tint]);
}

#[test]
fn walls_stand_outside_their_floor() {
    let scene = scene();
    for shell in scene.shells.iter().filter(|s| matches!(s.role, Role::Wall { .. })) {
        let region = scene.regions.iter().find(|r| shell.region.as_deref() == Some(&r.name)).unwrap();
        let inside = |at: Vec2| region.prism.polygon.clearance_of_point(at).value;
        for slab in &shell.boxes {
            let middle = inside(slab.center.xz());
            assert!((middle + 0.015).abs() < 1e-9, "{}: {middle}", shell.name);
        }
        for piece in &shell.pieces {
            let middle = inside(piece.polygon.iter().sum::<Vec2>() / piece.polygon.len() as f64);
            assert!((-0.06 - 1e-9..=-0.015 + 1e-9).contains(&middle), "{}: {middle}", shell.name);
        }
    }
}

#[test]
fn parts_of_the_layouts_own_are_what_is_drawn() {
    let scene = scene();
    let own = scene.objects.iter().find(|o| o.name == "crate").unwrap();
    assert_eq!(own.solid.len(), 3);
    assert_eq!(own.mesh.len(), 1);
    assert_eq!(own.mesh[0].indices.len() / 3, 12 + 12 + (24 * 2 + 22 * 2));
}

#[test]
fn what_is_not_placed_is_named() {
    let mut missing = parts();
    missing.layout.objects.retain(|(n, _)| n != "chair[1]");
    assert_eq!(missing.build().unwrap_err(), BuildError::MissingObject("chair[1]".into()));
    let mut missing = parts();
    missing.layout.regions.retain(|(n, _)| n != "den");
    assert_eq!(missing.build().unwrap_err(), BuildError::MissingRegion("den".into()));
    let mut flat = parts();
    flat.layout.regions[0].1.vertices = Some(vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    assert!(matches!(flat.build().unwrap_err(), BuildError::Floor(name, _) if name == "hall"));
}

#[test]
fn what_shares_space_with_its_carrier_is_held() {
    let text =
        "object cot; object blanket; object stool; object book; allowCollide(blanket, cot); allowCollide(stool, cot);";
    let compiled = compile_text("room.scene", Path::new("room.scene"), text, Options::default());
    let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let layout = r#"{ "format": "scenelang.layout/1", "regions": {}, "objects": {
        "cot": { "pos": [0, 0, 0], "scale": [0.7, 0.5, 1.4] },
        "blanket": { "pos": [0, 0.3, 0], "scale": [0.6, 0.3, 0.8] },
        "stool": { "pos": [0.5, 0, 0], "scale": [0.4, 0.4, 0.4] },
        "book": { "pos": [0, 0.5, 0.6], "scale": [0.1, 0.02, 0.1] } } }"#;
    let report = json!({ "format": "scenelang.report/1", "eta": 0.03, "constraints": [], "diagnostics": [] });
    let input = SceneInput {
        name: "room",
        program: &program,
        sources: &compiled.sources,
        files: &[compiled.main],
        layout: &file::read(layout, FileId(0)).layout,
        layout_text: layout,
        report: &report,
    };
    let bodies: Vec<Body> = Scene::build(&input).unwrap().objects.iter().map(|o| o.body).collect();
    // The stool stands beside the cot on the floor, the book rests on it.
    assert_eq!(bodies, [Body::Free, Body::Held, Body::Free, Body::Free]);
}

/// A scene shows the colours that the draws of its layout choose.
#[test]
fn what_is_chosen_is_shown() {
    let surfaces = |[wall, floor, box_color]: [&str; 3], draws: &str| {
        let text = format!(
            "region room; room.scale <- vec3(4, 2.6, 4); room.pos <- vec3(0, 0, 0); object box; box.category <- \"box\";\n\
             box.color <- {box_color}; room.wallColor <- {wall}; room.floorMaterial <- {floor};"
        );
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let layout = format!(
            r#"{{ "format": "scenelang.layout/1", "objects": {{ "box": {{ "pos": [0, 0, 0], "scale": [1, 1, 1] }} }},
                 "regions": {{ "room": {{ "pos": [0, 0, 0], "scale": [4, 2.6, 4] }} }}, "draws": {draws} }}"#
        );
        let read = file::read(&layout, FileId(0));
        let report = json!({ "format": "scenelang.report/1", "eta": 0.03, "constraints": [], "diagnostics": [] });
        let input = SceneInput {
            name: "room",
            program: &program,
            sources: &compiled.sources,
            files: &[compiled.main],
            layout: &read.layout,
            layout_text: &layout,
            report: &report,
        };
        format!("{:?}", Scene::build(&input).unwrap().surfaces)
    };
    let chosen = ["oneOf(\"red\", \"blue\")", "oneOf(\"oak\", \"tile\")", "oneOf(\"green\", \"white\", \"black\")"];
    let draws = |wall: u8, floor: u8, thing: u8| {
        format!(r#"{{ "room.wallColor/0": {wall}, "room.floorMaterial/0": {floor}, "box.color/0": {thing} }}"#)
    };
    let last = surfaces(["\"blue\"", "\"tile\"", "\"black\""], "{}");
    assert_eq!(surfaces(chosen, &draws(1, 1, 2)), last);
    assert_eq!(surfaces(chosen, &draws(0, 1, 1)), surfaces(["\"red\"", "\"tile\"", "\"white\""], "{}"));
    assert_ne!(surfaces(chosen, &draws(0, 1, 2)), last);
}
