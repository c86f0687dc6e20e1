//! Houses of other systems on the command line, the way back from USD, and one object as URDF.

use crate::support::{folder_of, python, read_json, scenelang, skip};
use std::fs;
use std::process::Command;

const HOUSE: &str = r#"{
  "rooms": [{ "id": "room|2", "roomType": "Bedroom", "floorMaterial": "Oak", "floorPolygon": [
    { "x": 0, "y": 0, "z": 0 }, { "x": 0, "y": 0, "z": 4 }, { "x": 5, "y": 0, "z": 4 }, { "x": 5, "y": 0, "z": 0 }] }],
  "walls": [], "doors": [], "windows": [],
  "objects": [
    { "id": "Bed|2|0", "assetId": "Bed_1", "position": { "x": 2, "y": 0.3, "z": 2 }, "rotation": { "x": 0, "y": 90, "z": 0 } },
    { "id": "Desk|2|1", "assetId": "Desk_1", "position": { "x": 2.4, "y": 0.37, "z": 2 }, "rotation": { "x": 0, "y": 0, "z": 0 } }]
}"#;
const SIZES: &str = r#"{ "Bed": [{ "assetId": "Bed_1", "boundingBox": { "x": 1.6, "y": 0.6, "z": 2 } }],
  "Desk": [{ "assetId": "Desk_1", "boundingBox": { "x": 1.2, "y": 0.74, "z": 0.6 } }] }"#;

#[test]
fn a_house_of_others_is_judged_and_imported() {
    let folder = folder_of(&[("house.json", HOUSE), ("sizes.json", SIZES)]);
    let ended = scenelang(folder.path(), ["check", "house.json", "--sizes", "sizes.json", "--format", "json"]);
    let report = ended.reports().remove(0);
    assert_eq!((ended.code, report["file"].as_str()), (1, Some("house.json")));
    let failing: Vec<&str> = report["constraints"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|row| row["satisfied"] == false)
        .filter_map(|row| row["code"].as_str())
        .collect();
    assert_eq!(failing, ["V0102"], "{report}");
    let said = report["diagnostics"].to_string();
    assert!(said.contains("W0505") && said.contains("rooms[].floorMaterial") && !said.contains("usual size"), "{said}");

    let ended = scenelang(folder.path(), ["import", "house.json", "-o", "mine", "--sizes", "sizes.json"]);
    assert_eq!((ended.code, ended.stdout.lines().count()), (0, 2), "{}", ended.stderr);
    assert!(ended.stderr.contains("the height of 1 room"), "{}", ended.stderr);
    let ended = scenelang(folder.path(), ["check", "mine/house.scene", "mine/house.layout.json"]);
    assert_eq!(ended.code, 1, "{}{}", ended.stdout, ended.stderr);
    // Two runs give the same files, and what somebody has edited is left alone.
    assert_eq!(scenelang(folder.path(), ["import", "house.json", "-o", "mine", "--sizes", "sizes.json"]).code, 0);
    fs::write(folder.path().join("mine/house.scene"), "object mine;\n").unwrap();
    assert_eq!(scenelang(folder.path(), ["import", "house.json", "-o", "mine"]).code, 2);
    assert_eq!(scenelang(folder.path(), ["query", "house.json", "--object", "bed"]).code, 0);
}

#[test]
fn a_broken_house_is_refused_where_it_is_broken() {
    let wrong = HOUSE.replace("\"x\": 2.4", "\"x\": \"far\"");
    let folder = folder_of(&[
        ("wrong.json", &wrong),
        ("cut.json", &HOUSE[..HOUSE.len() / 2]),
        ("other.json", "{ \"a\": 1 }"),
        ("sizes.json", "{}"),
    ]);
    let ended = scenelang(folder.path(), ["check", "wrong.json", "--format", "json"]);
    let found = ended.reports().remove(0)["diagnostics"].clone();
    assert_eq!(
        (ended.code, found.as_array().unwrap().len(), found[0]["code"].as_str()),
        (2, 1, Some("E0504")),
        "{found}"
    );
    assert_eq!(found[0]["span"]["start"][0], 7, "{found}");
    let ended = scenelang(folder.path(), ["import", "wrong.json", "-o", "mine"]);
    assert!(
        ended.code == 2
            && ended.stderr.contains("wrong.json:7:")
            && ended.stderr.contains("`objects[1].position.x` is a string"),
        "{}",
        ended.stderr
    );
    assert!(!folder.path().join("mine").exists());
    for (args, say) in [
        (vec!["import", "cut.json", "-o", "mine"], "E0501"),
        (vec!["import", "other.json", "-o", "mine"], "E0502"),
        (vec!["import", "none.json", "-o", "mine"], "E0001"),
        (vec!["import", "cut.json", "-o", "mine", "--sizes", "sizes.json"], "E0503"),
        (vec!["check", "cut.json"], "E0501"),
        (vec!["check", "other.json"], "E0502"),
    ] {
        let ended = scenelang(folder.path(), &args);
        assert!(
            ended.code == 2 && format!("{}{}", ended.stdout, ended.stderr).contains(say),
            "{args:?}: {}{}",
            ended.stdout,
            ended.stderr
        );
    }
}

const SCENE: &str = "region room;\nobject cabinet;\ncabinet.category <- \"cabinet\";\nobject stool;\nassert gap(cabinet, stool) >= 0.4;\n";
const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.5, 3] } },
  "objects": {
    "cabinet": { "pos": [0, 0, -1.2], "scale": [0.8, 1, 0.5], "asset": { "parts": [
      { "shape": "box", "pos": [0, 0.5, -0.01], "size": [0.8, 1, 0.48] },
      { "shape": "box", "pos": [0, 0.65, 0.24], "size": [0.78, 0.68, 0.02] } ], "joints": [
      { "name": "door", "motion": "hinge", "axis": [0, -1, 0], "anchor": [-0.39, 0.65, 0.23], "limits": [0, 110], "parts": [1] } ] } },
    "stool": { "pos": [1, 0, 0.5], "scale": [0.4, 0.5, 0.4] } } }
"#;

#[test]
fn what_was_moved_in_usd_is_judged_taken_and_not_written_over() {
    let folder = folder_of(&[("room.scene", SCENE), ("room.layout.json", LAYOUT)]);
    let run = |args: &[&str]| scenelang(folder.path(), args);
    let ended = run(&["export", "room.layout.json", "-o", "out", "--only", "usd,usdz"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    for file in ["out/room.usda", "out/room.usdz"] {
        assert_eq!(run(&["check", file]).code, 0);
        assert_eq!(run(&["import", file, "-o", "back"]).code, 0);
        assert_eq!(fs::read_to_string(folder.path().join("back/room.layout.json")).unwrap(), LAYOUT);
    }
    let path = folder.path().join("out/room.usda");
    let text = fs::read_to_string(&path).unwrap();
    let moved = text.replace("xformOp:translate = (-1, 0, 0.5)", "xformOp:translate = (0, 0, -0.5)");
    assert_ne!(moved, text);
    fs::write(&path, moved).unwrap();
    let ended = run(&["check", "out/room.usda"]);
    assert!(
        ended.code == 1 && ended.stdout.contains("`stool` was moved by -1.000 m along x, -1.000 m along z"),
        "{}",
        ended.stdout
    );
    let ended = run(&["export", "room.layout.json", "-o", "out", "--only", "usd,usdz"]);
    assert!(ended.code == 2 && ended.stderr.contains("`stool` was moved by"), "{}", ended.stderr);
    let ended = run(&["export", "room.layout.json", "-o", "out", "--only", "usd,usdz", "--take", "--force"]);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    let layout = read_json(&folder.path().join("room.layout.json"));
    assert_eq!(layout["objects"]["stool"]["pos"], serde_json::json!([0, 0, -0.5]));
    assert_eq!(run(&["import", "room.scene", "-o", "back"]).code, 2);
}

#[test]
fn one_object_is_written_as_a_robot_that_others_load() {
    let folder = folder_of(&[("room.scene", SCENE), ("room.layout.json", LAYOUT)]);
    let run = |args: &[&str]| scenelang(folder.path(), args);
    let ended = run(&["export", "room.layout.json", "-o", "out", "--object", "cabinet", "--format", "json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stdout.contains("out/urdf/cabinet.urdf")
            && ended.stdout.contains("\"others\"")
            && !ended.stdout.contains("unity"),
        "{}",
        ended.stdout
    );
    let ended = run(&["export", "room.layout.json", "-o", "out", "--object", "cabinett"]);
    assert!(ended.code == 2 && ended.stderr.contains("did you mean `cabinet`?"), "{}", ended.stderr);
    assert!(run(&["export", "room.layout.json", "--only", "urdf"]).stderr.contains("--object"));
    let robot = folder.path().join("out/urdf/cabinet.urdf");
    match Command::new("check_urdf").arg(&robot).output() {
        Ok(output) => assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout)),
        Err(_) => skip("URDF not read by check_urdf: it is not installed"),
    }
    let Some(python) = python() else { return skip("URDF not loaded by MuJoCo: no .venv") };
    // Joint, axis and limits as another program understands them, and how wide the whole is.
    let script = "import sys, mujoco, json\nm = mujoco.MjModel.from_xml_path(sys.argv[1])\nd = mujoco.MjData(m); mujoco.mj_forward(m, d)\n\
                  j = m.joint('door_joint')\nprint(json.dumps([m.njnt, list(j.range), list(j.axis), list(d.xanchor[0])]))\n";
    let output = Command::new(python)
        .args(["-c", script])
        .arg("cabinet.urdf")
        .current_dir(robot.parent().unwrap())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let [joints, range, axis, anchor]: [serde_json::Value; 4] = serde_json::from_slice(&output.stdout).unwrap();
    let near = |value: &serde_json::Value, wanted: &[f64]| {
        wanted.iter().enumerate().all(|(k, w)| (value[k].as_f64().unwrap() - w).abs() < 1e-4)
    };
    assert_eq!(joints, 1);
    assert!(
        near(&range, &[0.0, 110_f64.to_radians()])
            && near(&axis, &[0.0, 0.0, 1.0])
            && near(&anchor, &[-0.39, 0.23, 0.65]),
        "{range} {axis} {anchor}"
    );
}
