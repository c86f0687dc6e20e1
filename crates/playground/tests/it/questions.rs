//! What an editor asks, in the places that a page has: units of UTF-16.

use crate::{ask, opened};
use scenelang_playground::Session;
use serde_json::{Value, json};

const DESK: &str = "// 🪑 naïve\nregion room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 3, 4);\nobject desk;\n\
                    desk.category <- \"desk\";\nassert inside(desk, room);\n";

/// Where something is in a text, in units of UTF-16.
fn units(text: &str, what: &str) -> u32 {
    text[..text.find(what).expect("it is there")].encode_utf16().count() as u32
}

fn solved(session: &mut Session, text: &str) -> Value {
    let request = json!({ "method": "solve", "name": "room.scene", "text": text, "start": null, "seed": 0 });
    ask(session, &request).expect("it can be solved")["layout"].clone()
}

#[test]
fn marks_are_where_javascript_has_them() {
    let text = format!("{DESK}assert inside(desk, rom);\n");
    let (_, marks) = opened(&text);
    let mark = &marks["marks"][0];
    let at = units(&text, "rom)");
    assert_eq!((&mark["severity"], &mark["range"]), (&json!("error"), &json!([at, at + 3])), "{mark}");
    assert_eq!(marks["complete"], false);
    let tokens: Vec<u64> = marks["tokens"].as_array().unwrap().iter().filter_map(Value::as_u64).collect();
    let class = marks["types"].as_array().unwrap().iter().position(|t| t == "class").unwrap() as u64;
    let declared = u64::from(units(&text, "desk;"));
    assert!(tokens.chunks(4).any(|t| t[..3] == [declared, declared + 4, class]), "the declaration is coloured");
}

#[test]
fn proposals_and_hovers_know_the_program() {
    let text = format!("{DESK}assert inside(de, room);\n");
    let (mut session, _) = opened(&text);
    let at = units(&text, "de, room") + 2;
    let found = ask(&mut session, &json!({ "method": "complete", "at": at, "asked": true })).unwrap();
    assert_eq!((&found["from"], &found["to"]), (&json!(at - 2), &json!(at)));
    let list = found["list"].as_array().unwrap();
    assert!(list.iter().any(|p| p["label"] == "desk" && p["sort"] == "class"), "{list:?}");
    let at = units(&text, "inside(desk") + 1;
    let hover = ask(&mut session, &json!({ "method": "hover", "at": at })).unwrap();
    assert!(hover["text"].as_str().unwrap().contains("inside"), "{hover}");
    let statement = units(&text, "assert inside(de,");
    let found = ask(&mut session, &json!({ "method": "complete", "at": statement, "asked": true })).unwrap();
    let about = found["list"].as_array().unwrap().iter().find_map(|p| p["about"].as_str());
    if let Some(about) = about {
        assert!(ask(&mut session, &json!({ "method": "describe", "about": about })).unwrap().is_string());
    }
}

#[test]
fn an_edit_is_judged_by_the_layout_that_is_there() {
    let (mut session, marks) = opened(DESK);
    assert_eq!((&marks["count"], &marks["placed"]), (&Value::Null, &json!(false)));
    assert_eq!(ask(&mut session, &json!({ "method": "room", "known": null, "plan": false })).unwrap(), Value::Null);
    let layout = solved(&mut session, DESK);
    let marks = ask(&mut session, &json!({ "method": "layout", "text": layout })).unwrap();
    assert_eq!((&marks["count"][2], &marks["placed"]), (&json!(0), &json!(true)));
    let text = format!("{DESK}assert desk.pos.x > 100;\n");
    let marks = ask(&mut session, &json!({ "method": "edit", "text": text })).unwrap();
    assert_eq!((&marks["count"][2], &marks["placed"]), (&json!(1), &json!(true)), "{}", marks["marks"]);
    let text = format!("{DESK}object chair;\nchair.category <- \"chair\";\n");
    let marks = ask(&mut session, &json!({ "method": "edit", "text": text })).unwrap();
    assert_eq!(marks["placed"], false, "the chair has no place yet");
}

#[test]
fn what_is_moved_is_judged_and_kept_only_if_that_is_wanted() {
    let (mut session, _) = opened(DESK);
    let layout = solved(&mut session, DESK);
    ask(&mut session, &json!({ "method": "layout", "text": layout })).unwrap();
    let mut moved = |commit: bool| {
        let request =
            json!({ "method": "move", "object": "desk", "pos": [50, 0, 0], "rot": [0, 0, 0], "commit": commit });
        ask(&mut session, &request).unwrap()
    };
    let judged = moved(false);
    assert!(judged["constraints"].as_array().unwrap().iter().any(|row| row["state"] == "fails"), "{judged}");
    assert_eq!(judged.get("layout"), None);
    let text = moved(true)["layout"].clone();
    assert!(text.as_str().unwrap().contains("[50, 0, 0]"), "{text}");
    let marks = ask(&mut session, &json!({ "method": "layout", "text": text })).unwrap();
    assert_ne!(marks["count"][2], 0);
}

#[test]
fn contradictions_are_told_and_proved() {
    let text = format!("{DESK}assert desk.pos.x > 3;\nassert desk.pos.x < 2;\n");
    let (mut session, _) = opened(&text);
    let proofs = ask(&mut session, &json!({ "method": "proofs" })).unwrap();
    assert!(proofs.as_array().unwrap().iter().any(|mark| mark["severity"] == "error"), "{proofs}");
    let request = json!({ "method": "solve", "name": "room.scene", "text": text, "start": null, "seed": 0 });
    let answer = ask(&mut session, &request).unwrap();
    assert_eq!((&answer["layout"], &answer["end"]), (&Value::Null, &json!("contradiction")));
    assert!(!answer["said"].as_array().unwrap().is_empty());
}

#[test]
fn a_sentence_becomes_a_program_and_a_room() {
    let mut session = Session::default();
    let request = json!({ "method": "write", "text": "a study with a desk and two bookshelves" });
    let written = ask(&mut session, &request).unwrap();
    assert!(written["program"].as_str().unwrap().contains("bookshelf"), "{written}");
    assert_eq!(written["solved"]["converged"], true);
    let open = json!({
        "method": "open", "name": written["name"], "text": written["program"], "layout": written["solved"]["layout"],
    });
    let marks = ask(&mut session, &open).unwrap();
    assert_eq!((&marks["complete"], &marks["count"][2]), (&json!(true), &json!(0)), "{}", marks["marks"]);
    let refused = ask(&mut session, &json!({ "method": "write", "text": "…" })).unwrap_err();
    assert!(refused.contains("understood"), "{refused}");
}

#[test]
fn a_program_is_formatted() {
    let (mut session, _) = opened("object   desk ;\n");
    let found = ask(&mut session, &json!({ "method": "format" })).unwrap();
    assert_eq!(found["text"].as_str().map(str::is_empty), Some(false), "{found}");
    let (mut session, _) = opened(DESK);
    assert_eq!(ask(&mut session, &json!({ "method": "format" })).unwrap(), Value::Null);
}
