//! What `check` says of permissions to collide: how deep things are inside each other that may be.

use crate::support::scenelang;
use std::fs;

const PROGRAM: &str = r#"region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(4, 2.6, 4);
object crate[2];
crate.dimensions <- vec3(1, 1, 1);
object box;
box.dimensions <- vec3(0.5, 0.5, 0.5);
assert forall c in crate: onFloor(c, room);
assert onFloor(box, room);
allowCollide(crate[0], crate[1]);
allowCollide(box, objects);
"#;

const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.6, 4] } },
  "objects": {
    "crate[0]": { "pos": [0, 0, 0], "rot": [0, 0, 0], "scale": [1, 1, 1] },
    "crate[1]": { "pos": [0.8, 0, 0], "rot": [0, 0, 0], "scale": [1, 1, 1] },
    "box": { "pos": [-1.5, 0, -1.5], "rot": [0, 0, 0], "scale": [0.5, 0.5, 0.5] } } }"#;

#[test]
fn each_permission_says_what_it_hides() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), PROGRAM).unwrap();
    fs::write(folder.path().join("room.layout.json"), LAYOUT).unwrap();
    let said = scenelang(folder.path(), ["check", "room.layout.json"]);
    assert_eq!(said.code, 0, "{}", said.stderr);
    for line in [
        "allowCollide(crate[0], crate[1]): allows crate[0] and crate[1] to overlap by 0.200 m\n",
        "allowCollide(box, objects): hides nothing\n",
    ] {
        assert!(said.stdout.contains(line), "{}", said.stdout);
    }
    let said = scenelang(folder.path(), ["check", "--format", "json", "room.layout.json"]);
    let report: serde_json::Value = serde_json::from_str(&said.stdout).unwrap();
    let [deep, nothing] = report["permissions"].as_array().unwrap().as_slice() else { panic!("{}", said.stdout) };
    assert_eq!(deep["hides"]["objects"], serde_json::json!(["crate[0]", "crate[1]"]));
    assert!((deep["hides"]["depth"].as_f64().unwrap() - 0.2).abs() < 1e-9, "{deep}");
    assert_eq!((&deep["hides"]["others"], &nothing["hides"]), (&serde_json::json!(0), &serde_json::Value::Null));
}
