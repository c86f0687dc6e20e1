//! Rigid bodies in GLB files (`--gltf-physics`), held against what the draft extensions say of their members, and against the
//! layout.

use crate::checkers::{judge, oracle};
use crate::support::{example, faults, fits, has_node_package, read_json, scenelang, skip};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Command;

const BODIES: &str = "KHR_physics_rigid_bodies";
const SHAPES: &str = "KHR_implicit_shapes";

/// What the drafts say of the members that may be written, in one schema: `document`, and `node` for the extension of a node.
fn schema() -> Value {
    let number = |least: f64| json!({ "type": "number", "minimum": least });
    let above = json!({ "type": "number", "exclusiveMinimum": 0 });
    let id = json!({ "type": "integer", "minimum": 0 });
    let list = |items: &Value, n: usize| json!({ "type": "array", "items": items, "minItems": n, "maxItems": n });
    let object = |properties: Value, required: Value| json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false });
    let axes = json!({
        "type": "array", "items": { "type": "integer", "minimum": 0, "maximum": 2 },
        "minItems": 1, "maxItems": 3, "uniqueItems": true,
    });
    let any = json!({ "type": "number" });
    let limit = |key: &str| object(json!({ key: axes, "min": any, "max": any }), json!([key, "min", "max"]));
    let drive = object(
        json!({
            "type": { "enum": ["linear", "angular"] }, "mode": { "enum": ["force", "acceleration"] },
            "axis": { "type": "integer", "minimum": 0, "maximum": 2 }, "velocityTarget": any, "damping": number(0.0),
        }),
        json!(["type", "mode", "axis"]),
    );
    let many = |items: Value| json!({ "type": "array", "items": items, "minItems": 1 });
    let texts = json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
    let limits = json!({ "oneOf": [limit("linearAxes"), limit("angularAxes")] });
    let friction = object(
        json!({ "staticFriction": number(0.0), "dynamicFriction": number(0.0), "restitution": number(0.0) }),
        json!([]),
    );
    let bodies = object(
        json!({
            "physicsMaterials": many(friction),
            "physicsJoints": many(object(json!({ "limits": many(limits), "drives": many(drive) }), json!([]))),
            "collisionFilters": many(object(
                json!({ "collisionSystems": texts, "notCollideWithSystems": texts }), json!(["collisionSystems"]),
            )),
        }),
        json!([]),
    );
    let cylinder = object(json!({ "radiusBottom": above, "radiusTop": above, "height": above }), json!(["height"]));
    let shape = json!({ "oneOf": [
        object(json!({ "type": { "const": "box" }, "box": object(json!({ "size": list(&above, 3) }), json!(["size"])) }),
            json!(["type", "box"])),
        object(json!({ "type": { "const": "cylinder" }, "cylinder": cylinder }), json!(["type", "cylinder"])),
    ] });
    let geometry = json!({ "oneOf": [
        object(json!({ "shape": id }), json!(["shape"])),
        object(json!({ "node": id, "convexHull": { "type": "boolean" } }), json!(["node"])),
    ] });
    let motion = object(
        json!({
            "mass": above, "centerOfMass": list(&any, 3), "inertiaDiagonal": list(&above, 3),
            "inertiaOrientation": list(&any, 4),
        }),
        json!([]),
    );
    let node = object(
        json!({
            "motion": motion,
            "collider": object(
                json!({ "geometry": geometry, "physicsMaterial": id, "collisionFilter": id }), json!(["geometry"]),
            ),
            "joint": object(
                json!({ "connectedNode": id, "joint": id, "enableCollision": { "type": "boolean" } }),
                json!(["connectedNode", "joint"]),
            ),
        }),
        json!([]),
    );
    let shapes = object(json!({ "shapes": many(shape) }), json!(["shapes"]));
    object(
        json!({ "bodies": bodies, "shapes": shapes, "nodes": { "type": "array", "items": node } }),
        json!(["bodies", "nodes"]),
    )
}

/// The document of a GLB file.
fn document(path: &Path) -> Value {
    let bytes = fs::read(path).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

/// An example's GLB file with rigid bodies, and its layout.
fn made(name: &str) -> (tempfile::TempDir, Value, Value) {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(example(name), folder.path().join("room.scene")).unwrap();
    let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "out", "--only", "glb", "--gltf-physics"]);
    assert!(ended.code <= 1, "{ended:?}");
    let layout = read_json(&folder.path().join("out/room.layout.json"));
    let glb = document(&folder.path().join("out/room.glb"));
    (folder, glb, layout)
}

fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}

#[test]
fn they_are_as_the_drafts_say() {
    let schema = jsonschema::draft202012::options().build(&schema()).unwrap();
    for name in ["bedroom", "restaurant", "workshop-safety"] {
        let (folder, glb, layout) = made(name);
        let used = glb["extensionsUsed"].as_array().unwrap();
        assert!(used.contains(&json!(BODIES)) && used.contains(&json!(SHAPES)), "{used:?}");
        assert_eq!(glb["extensionsRequired"], Value::Null, "whoever does not know them still shows the room");
        let nodes = glb["nodes"].as_array().unwrap();
        let own: Vec<&Value> = nodes.iter().map(|n| &n["extensions"][BODIES]).filter(|own| !own.is_null()).collect();
        let all = json!({ "bodies": glb["extensions"][BODIES], "shapes": glb["extensions"][SHAPES], "nodes": own });
        assert_eq!(faults(&schema, &all), Vec::<String>::new());
        let count = |list: &Value| list.as_array().map_or(0, Vec::len);
        let (shapes, bodies) = (&glb["extensions"][SHAPES]["shapes"], &glb["extensions"][BODIES]);
        for node in own {
            let (collider, joint) = (&node["collider"], &node["joint"]);
            if let Some(shape) = collider["geometry"].get("shape") {
                assert!(index(shape) < count(shapes));
            }
            if let Some(hull) = collider["geometry"].get("node") {
                assert!(nodes[index(hull)]["mesh"].is_u64());
            }
            if let Some(filter) = collider.get("collisionFilter") {
                assert!(index(filter) < count(&bodies["collisionFilters"]));
            }
            if joint.is_object() {
                assert!(index(&joint["joint"]) < count(&bodies["physicsJoints"]));
                assert!(nodes[index(&joint["connectedNode"])].is_object());
            }
        }
        let told = layout["objects"].as_object().unwrap().values().map(|o| count(&o["asset"]["joints"])).sum::<usize>();
        let joints = nodes.iter().filter(|n| n["extensions"][BODIES]["joint"].is_object()).count();
        assert_eq!(joints, told, "{name}");
        // Nobody has edited it.
        let ended = scenelang(folder.path(), ["check", "out/room.glb", "--format", "json"]);
        let report = fits("report", ended.stdout.trim());
        assert_eq!(
            report["diagnostics"].as_array().map_or(0, |all| all.iter().filter(|d| d["code"] == "W0504").count()),
            0
        );
        if has_node_package("gltf-validator") {
            let found = judge(
                "glTF validator",
                Command::new("node").arg(oracle("gltf.mjs")).arg(folder.path().join("out/room.glb")),
            );
            assert!(found.is_none(), "{found:?}");
        } else {
            skip("GLB not validated: no gltf-validator (Node and tests/oracles/node_modules)");
        }
    }
}

#[test]
fn a_wrong_member_is_found() {
    let schema = jsonschema::draft202012::options().build(&schema()).unwrap();
    for node in [
        json!({ "motion": { "mass": 0 } }),
        json!({ "collider": { "shape": 0 } }),
        json!({ "collider": { "geometry": { "shape": 0, "node": 1 } } }),
        json!({ "joint": { "joint": 0 } }),
    ] {
        let all = json!({ "bodies": {}, "nodes": [node] });
        assert!(!faults(&schema, &all).is_empty(), "{all}");
    }
}

#[test]
fn without_the_option_there_are_none() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(example("bedroom"), folder.path().join("room.scene")).unwrap();
    let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "out", "--only", "glb"]);
    assert!(ended.code <= 1, "{ended:?}");
    let glb = document(&folder.path().join("out/room.glb"));
    assert_eq!((&glb["extensionsUsed"], &glb["extensions"][BODIES]), (&json!(["KHR_lights_punctual"]), &Value::Null));
}
