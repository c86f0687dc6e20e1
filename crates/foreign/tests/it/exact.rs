//! Single cases: how files turn and measure, worked out by hand.

use crate::houses::{judged, taken};
use scenelang_base::FileId;
use scenelang_foreign::{Beside, Sizes, recognise};
use scenelang_layout::{Vec3, file, rotation};
use serde_json::{Value, json};

fn room() -> Value {
    json!([{ "id": "room|2", "roomType": "Kitchen",
             "floorPolygon": [{ "x": 0, "y": 0, "z": 0 }, { "x": 0, "y": 0, "z": 4 }, { "x": 4, "y": 0, "z": 4 }, { "x": 4, "y": 0, "z": 0 }] }])
}

#[test]
fn unity_turns_about_z_then_x_then_y() {
    let object = |id: &str, rotation: Value| json!({ "id": id, "assetId": "a", "position": { "x": 2, "y": 1, "z": 2 }, "rotation": rotation });
    let value = json!({ "rooms": room(), "walls": [], "objects": [
        object("Chair|1", json!({ "x": 30, "y": 20, "z": 10 })),
        object("Chair|2", json!({ "axis": { "x": 0, "y": 1, "z": 0 }, "degrees": 90 })),
    ] });
    let list = json!({ "a": { "boundingBox": { "x": 0.4, "y": 0.8, "z": 0.6 } } });
    let beside = Beside { sizes: Sizes::read(&list.to_string(), FileId(0)).unwrap(), room: None };
    let layout = file::read(&taken(&value, &beside).layout, FileId(0)).layout;
    // Where Unity puts the corner (1, 2, 3) of a thing that is turned so: worked out by a rotation about each axis by hand.
    let turn = |v: Vec3, about: usize, degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        match about {
            0 => Vec3::new(v.x, v.y * cos - v.z * sin, v.y * sin + v.z * cos),
            1 => Vec3::new(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin),
            _ => Vec3::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos, v.z),
        }
    };
    let corner = Vec3::new(1.0, 2.0, 3.0);
    let there = turn(turn(turn(corner, 2, 10.0), 0, 30.0), 1, 20.0);
    let placed = &layout.objects[0].1;
    assert!((rotation::matrix(placed.rot) * corner - there).amax() < 1e-5);
    // The middle of its box is where the file says, so its base is not below it.
    let up = rotation::matrix(placed.rot).column(1) * 0.4;
    assert!((placed.pos + up - Vec3::new(2.0, 1.0, 2.0)).amax() < 1e-5);
    // +z towards +x.
    let front = rotation::matrix(layout.objects[1].1.rot).column(2).into_owned();
    assert!((front - Vec3::x()).amax() < 1e-6);
}

#[test]
fn what_hangs_is_asserted_to_and_what_is_in_a_shelf_may_be() {
    let at = |x: f64, y: f64, z: f64| json!({ "x": x, "y": y, "z": z });
    let object = |id: &str, asset: &str, position: Value| json!({ "id": id, "assetId": asset, "position": position, "rotation": at(0.0, 0.0, 0.0) });
    let mut shelf = object("ShelvingUnit|2|0", "shelf", at(2.0, 1.0, 1.0));
    shelf["children"] = json!([object("Bowl|2|1", "bowl", at(2.0, 1.0, 1.0))]);
    let value = json!({ "rooms": room(), "walls": [{ "id": "w", "roomId": "room|2", "polygon": [at(0.0, 0.0, 0.0), at(0.0, 0.0, 4.0), at(0.0, 2.5, 4.0), at(0.0, 2.5, 0.0)] }],
        "objects": [shelf, object("Painting|2|2", "picture", at(2.0, 1.5, 0.025)), object("Painting|2|3", "picture", at(3.0, 1.5, 0.3))] });
    let of = |x: f64, y: f64, z: f64| json!({ "boundingBox": { "x": x, "y": y, "z": z } });
    let list = json!({ "shelf": of(1.0, 2.0, 0.4), "bowl": of(0.2, 0.1, 0.2), "picture": of(0.6, 0.4, 0.05) });
    let scene = taken(&value, &Beside { sizes: Sizes::read(&list.to_string(), FileId(0)).unwrap(), room: None });
    for line in ["allowCollide(bowl, shelvingUnit);", "allowFloat(bowl);", "assert wallMounted(painting, kitchen);"] {
        assert!(scene.program.contains(line), "{line} is not in {}", scene.program);
    }
    // The second one is 27 cm before its wall.
    let failing: Vec<String> = judged(&scene)
        .report
        .constraints
        .iter()
        .filter(|row| row.satisfied == Some(false))
        .map(|row| row.text.clone())
        .collect();
    assert!(failing.iter().all(|text| text.contains("painting2")) && !failing.is_empty(), "{failing:?}");
}

#[test]
fn names_of_strangers_become_names_and_comments_that_can_be_read() {
    let object = |id: &str| json!({ "id": id, "assetId": "a", "position": { "x": 2, "y": 0.4, "z": 2 } });
    let value = json!({ "rooms": room(), "walls": [], "objects": [
        object("object\n*/ assert 1 = 2; // |\u{1b}[31m"), object("灯|2|0"), object("Chair|2|0"), object("Chair|2|1"), object("") ] });
    let list = json!({ "a": { "boundingBox": { "x": 0.4, "y": 0.8, "z": 0.4 } } });
    let scene = taken(&value, &Beside { sizes: Sizes::read(&list.to_string(), FileId(0)).unwrap(), room: None });
    let checked = judged(&scene);
    let program = checked.program.unwrap_or_else(|| panic!("{:?}\n{}", checked.verdict.diagnostics, scene.program));
    assert_eq!((program.objects.len(), scene.program.contains('\u{1b}')), (5, false));
}

#[test]
fn other_json_is_left_alone() {
    for text in [
        "{}",
        "[]",
        "1",
        r#"{ "format": "scenelang.layout/1", "objects": {} }"#,
        r#"{ "rooms": 3 }"#,
        r#"{ "a": { "position": [] } }"#,
        "",
        "nothing",
    ] {
        assert_eq!(recognise(text), None, "{text}");
    }
}
