//! Whatever a page, or a link that it was given, says: an answer comes, and says what is wrong.

use crate::{ask, opened, raw};
use scenelang_playground::Session;
use serde_json::{Value, json};

#[test]
fn what_is_no_request_is_refused() {
    let mut session = Session::default();
    for request in [
        &b""[..],
        b"\xff\xfe",
        b"[]",
        b"null",
        b"{\"method\": \"nothing\"}",
        b"{\"method\": \"hover\"}",
        b"{\"method\": \"hover\", \"at\": -1}",
        b"{\"method\": \"hover\", \"at\": 1, \"more\": 2}",
        b"{\"method\": \"export\", \"format\": \"unity\"}",
    ] {
        let why = raw(&mut session, request).unwrap_err();
        assert!(why.starts_with("this is not a valid request"), "{why}");
    }
}

#[test]
fn without_a_program_there_is_nothing_to_ask_about() {
    let mut session = Session::default();
    for method in ["room", "format", "proofs"] {
        let why = ask(&mut session, &json!({ "method": method, "known": null, "plan": false }))
            .map_or_else(|why| why, |v| v.to_string());
        assert!(why.contains("no program is open") || why.contains("no request"), "{method}: {why}");
    }
}

#[test]
fn offsets_beyond_the_text_mean_its_end() {
    let (mut session, _) = opened("object a; // 🪑");
    for at in [0, 13, 14, 15, u32::MAX] {
        ask(&mut session, &json!({ "method": "hover", "at": at })).unwrap();
        ask(&mut session, &json!({ "method": "complete", "at": at, "asked": true })).unwrap();
    }
}

#[test]
fn files_beside_the_program_are_not_there() {
    for path in ["other.scene", "../other.scene", "/etc/passwd", "room.scene"] {
        let (_, marks) = opened(&format!("import \"{path}\";\nobject a;\n"));
        assert_eq!(marks["complete"], false, "{path}: {}", marks["marks"]);
        let said = marks["marks"].to_string();
        assert!(!said.contains("root:"), "{said}");
    }
    let (_, marks) = opened("import \"other.scene\";\n");
    assert!(marks["marks"][0]["message"].as_str().unwrap().contains("command line"), "{}", marks["marks"]);
}

#[test]
fn programs_that_are_none_are_marked() {
    let deep = format!("assert {}1{} > 0;", "(".repeat(5_000), ")".repeat(5_000));
    let long = format!("assert 0{} > 0;", " + 1".repeat(50_000));
    for text in ["", "\0\0\0", "<script>alert(1)</script>", "object 🪑;", &deep, &long] {
        let (mut session, marks) = opened(text);
        assert!(marks["marks"].is_array());
        assert_eq!(ask(&mut session, &json!({ "method": "room", "known": null, "plan": true })).unwrap(), Value::Null);
        let request = json!({ "method": "solve", "name": "room.scene", "text": text, "start": null, "seed": 0 });
        ask(&mut session, &request).unwrap();
    }
}

#[test]
fn layouts_that_are_none_are_said_so() {
    let (mut session, _) = opened("region room;\nobject desk;\n");
    for layout in ["", "{", "[]", "{\"objects\": {\"desk\": {\"pos\": [1e999, 0, 0]}}}", "{\"objects\": 3}"] {
        let marks = ask(&mut session, &json!({ "method": "layout", "text": layout })).unwrap();
        assert!(marks["marks"].as_array().is_some_and(|marks| !marks.is_empty()), "{layout}");
        assert_eq!(ask(&mut session, &json!({ "method": "room", "known": null, "plan": true })).unwrap(), Value::Null);
        let far = json!({ "method": "move", "object": "desk", "pos": [1e300, 0, 0], "rot": [0, 0, 0], "commit": true });
        assert!(ask(&mut session, &far).is_err());
        assert!(ask(&mut session, &json!({ "method": "export", "format": "glb" })).is_err());
        let start = json!({ "method": "solve", "name": "room.scene", "text": "object a;", "start": layout, "seed": 0 });
        assert_eq!(ask(&mut session, &start).unwrap()["end"], "errors", "{layout}");
    }
}
