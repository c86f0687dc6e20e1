//! `scenelang eval sceneeval`: what it makes and writes, layouts of others, exit codes, files that are broken.

use crate::support::{Ended, scenelang};
use serde_json::Value;
use std::fs;
use std::path::Path;

const HEAD: &str = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty,SceneScope\n";
const ROWS: &str = "0,\"A study with a desk, and a lamp on the desk.\",\"eq,1,desk; eq,1,lamp\",,\"eq,1,on,0,desk,lamp\",,easy,single_room\n\
    1,\"A bedroom with a bed, and a wardrobe in the corner.\",\"eq,1,bed; eq,1,wardrobe\",,,\"eq,1,corner,wardrobe,room\",hard,single_room\n";
const LAYOUT: &str = r#"{ "format": "scenelang.layout/1",
  "objects": { "desk": { "pos": [0, 0, 0], "scale": [1.2, 0.7, 0.6] }, "lamp": { "pos": [1, 0, 0], "scale": [0.2, 0.4, 0.2] } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.6, 4] } } }"#;

fn folder(rows: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.csv"), format!("{HEAD}{rows}")).unwrap();
    folder
}

fn eval(folder: &Path, more: &[&str]) -> Ended {
    scenelang(folder, ["eval", "sceneeval", "--annotations", "a.csv", "-o", "out"].iter().chain(more))
}

fn json(ended: &Ended) -> Value {
    serde_json::from_str(&ended.stdout).unwrap_or_else(|e| panic!("{e}: {}{}", ended.stdout, ended.stderr))
}

#[test]
fn programs_and_layouts_are_made_and_scored() {
    let folder = folder(ROWS);
    let ended = eval(folder.path(), &["--format", "json", "--jobs", "1"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    let found = json(&ended);
    assert_eq!(found["summary"]["all"]["good"], serde_json::json!([2, 2]));
    assert_eq!(found["summary"]["all"]["scores"]["CNT"], serde_json::json!([4, 4]));
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    assert_eq!(serde_json::from_str::<Value>(&read("report.json")).unwrap(), found);
    let summary = read("summary.csv");
    for (line, start) in summary.lines().zip(["id,difficulty,layout,", "0,easy,holds,", "1,hard,holds,"]) {
        assert!(line.starts_with(start), "{line}");
    }
    // On two threads it is the same, byte for byte; and so it is where everything is there already.
    let files = ["0.scene", "0.layout.json", "1.scene", "1.layout.json", "report.json", "summary.csv"];
    let before = files.map(read);
    for more in [&["--jobs", "2", "--format", "json"][..], &["--resume", "--format", "json"]] {
        assert_eq!(eval(folder.path(), more).stdout, ended.stdout);
        assert_eq!(files.map(read), before);
    }
    // What somebody has edited is not replaced.
    fs::write(folder.path().join("out/1.scene"), before[2].clone() + "object plant;\n").unwrap();
    let ended = eval(folder.path(), &[]);
    assert!(ended.code == 2 && ended.stderr.contains("1.scene has been edited"), "{}", ended.stderr);
}

/// A model's answer counts instead of the table: here it takes a lamp for a desk.
#[test]
fn a_model_says_what_names_and_words_mean() {
    use scenelang_eval::sceneeval::{question, read};
    let row = ROWS.lines().next().unwrap();
    let folder = folder(row);
    fs::create_dir(folder.path().join("theirs")).unwrap();
    fs::write(folder.path().join("theirs/0.layout.json"), LAYOUT).unwrap();
    let benchmark = read(&format!("{HEAD}{row}")).unwrap();
    let categories = ["desk", "lamp"].map(str::to_owned).into();
    let answer = serde_json::json!({
        "names": [{ "name": "desk", "categories": ["lamp", "desk"] }],
        "words": [{ "word": "on", "relation": "none" }],
    });
    let turn = serde_json::json!({
        "request": question(&benchmark.requests[0], &categories),
        "reply": { "text": answer.to_string(), "usage": { "input": 1, "output": 1 } },
    });
    let talk = serde_json::json!({ "format": "scenelang.conversation/1", "model": "m", "turns": [turn] });
    fs::write(folder.path().join("talk.json"), talk.to_string()).unwrap();
    let given = ["--layouts", "theirs", "--format", "json"];
    let plain = json(&eval(folder.path(), &given));
    assert_eq!(plain["summary"]["all"]["scores"]["CNT"], serde_json::json!([2, 2]));
    let asked = json(&eval(folder.path(), &[&given[..], &["--model", "replay:talk.json"]].concat()));
    assert_eq!(asked["summary"]["all"]["scores"]["CNT"], serde_json::json!([0, 2]), "two desks and no lamp: {asked}");
    assert_eq!(asked["summary"]["all"]["scores"]["OOR"], serde_json::json!([0, 0]), "the word means nothing: {asked}");
    // A model that does not answer ends the command.
    fs::write(folder.path().join("talk.json"), talk.to_string().replace("\"turns\":[{", "\"turns\":[],\"x\":[{"))
        .unwrap();
    let ended = eval(folder.path(), &[&given[..], &["--model", "replay:talk.json"]].concat());
    assert_eq!(ended.code, 2, "{ended:?}");
}

#[test]
fn layouts_of_others_are_scored_by_their_names() {
    let folder = folder(ROWS);
    fs::create_dir(folder.path().join("theirs")).unwrap();
    fs::write(folder.path().join("theirs/0.layout.json"), LAYOUT).unwrap();
    let ended = eval(folder.path(), &["--layouts", "theirs", "--format", "json"]);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    let requests = &json(&ended)["requests"];
    assert_eq!((&requests[0]["layout"], &requests[1]["layout"]), (&Value::from("unjudged"), &Value::from("none")));
    assert_eq!(
        requests[0]["scores"],
        serde_json::json!({ "CNT": [2, 2], "ATR": [0, 0], "OOR": [0, 1], "OAR": [0, 0] })
    );
    assert!(requests[1]["trouble"].as_str().unwrap().contains("1.layout.json"), "{requests}");
    // One request, and for people.
    let ended = eval(folder.path(), &["--layouts", "theirs", "--ids", "even"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    let miss = "OOR eq,1,on,0,desk,lamp: 0 found; not satisfied: \"A study with a desk, and a lamp on the desk.\"";
    assert!(ended.stdout.contains(miss), "{}", ended.stdout);
    assert!(!folder.path().join("out/0.scene").exists());
    // A layout that cannot be read is none.
    fs::write(folder.path().join("theirs/0.layout.json"), "{ \"format\": 7 }").unwrap();
    let ended = eval(folder.path(), &["--layouts", "theirs", "--ids", "0", "--format", "json"]);
    assert_eq!((ended.code, &json(&ended)["requests"][0]["layout"]), (1, &Value::from("none")));
}

#[test]
fn layouts_are_looked_for_in_a_folder() {
    let folder = folder(ROWS);
    let ended = eval(folder.path(), &["--layouts", "nothing"]);
    assert!(ended.code == 2 && ended.stderr.contains("--layouts nothing: there is no such folder"), "{ended:?}");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn broken_files_have_one_message() {
    let cases = [
        ("0,x,,,,,easy\n", "a.csv: line 2: the row has 7 fields, but the header has 8"),
        ("0,\"x,,,,,,easy\n", "a.csv: line 2: a quotation mark is never closed"),
        ("../0,x,,,,,easy,\n", "a.csv: line 2, column ID: \"../0\" is not a valid ID"),
        ("", "a.csv has no such request"),
    ];
    for (rows, message) in cases {
        let ended = eval(folder(rows).path(), &[]);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{rows}");
        assert_eq!(ended.stderr.lines().count(), 1, "{}", ended.stderr);
        assert!(ended.stderr.starts_with("error: ") && ended.stderr.contains(message), "{}", ended.stderr);
    }
    let ended = eval(folder(ROWS).path(), &["--ids", "0,7"]);
    assert!(ended.code == 2 && ended.stderr.contains("a.csv has no request \"7\""), "{}", ended.stderr);
    // What is wrong with one annotation is told, and the others are judged.
    let folder = folder("0,A desk.,\"eq,1,desk; eq,99999999999999999999,lamp; some,1,lamp\",,,,easy,\n");
    fs::create_dir(folder.path().join("theirs")).unwrap();
    fs::write(folder.path().join("theirs/0.layout.json"), LAYOUT).unwrap();
    let ended = eval(folder.path(), &["--layouts", "theirs", "--format", "json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert_eq!(ended.stderr.lines().count(), 2, "{}", ended.stderr);
    assert!(ended.stderr.contains("line 2, column ObjCount, item 2"), "{}", ended.stderr);
    assert_eq!(json(&ended)["summary"]["all"]["scores"]["CNT"], serde_json::json!([1, 1]));
}
