//! Files that are cut off, of the wrong types, too large: one diagnosis each, with its place, and no panic.

use crate::written::House;
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap};
use scenelang_foreign::{Beside, MAX_BYTES, Sizes, read, recognise};
use serde_json::{Value, json};
use std::path::Path;

fn refused(text: &str) -> Option<Diagnostic> {
    read("house.json", Path::new("house.json"), text, FileId(0), &Beside::default()).err().map(|e| *e)
}

fn kinds() -> Vec<Value> {
    let house = House::new(5, 2);
    let [task, poses] = house.layoutvlm();
    vec![house.procthor(false), house.procthor(true), house.holodeck(), task, poses, house.scene_state(true)]
}

#[test]
fn what_is_cut_off_is_refused_where_it_ends() {
    for value in kinds() {
        let text = serde_json::to_string_pretty(&value).unwrap();
        for k in 1..40 {
            let cut: String = text.chars().take(text.len() * k / 40).collect();
            let finding = refused(&cut).unwrap_or_else(|| panic!("cut at {k} of 40"));
            let place = finding.primary.as_ref().expect("a place").place;
            assert!(finding.code.as_str() == "E0501" && place.range.end as usize <= cut.len(), "{finding:?}");
        }
    }
}

/// Every value of a document that is a number, a string or a list, with how one gets there.
fn leaves(value: &Value, at: String, out: &mut Vec<String>) {
    match value {
        Value::Object(members) => members
            .iter()
            .for_each(|(key, v)| leaves(v, format!("{at}/{}", key.replace('~', "~0").replace('/', "~1")), out)),
        Value::Array(items) => {
            out.push(at.clone());
            items.iter().take(2).enumerate().for_each(|(i, v)| leaves(v, format!("{at}/{i}"), out));
        }
        _ => out.push(at),
    }
}

#[test]
fn whatever_stands_in_the_place_of_a_value_is_survived() {
    let others = [
        json!(null),
        json!("x"),
        json!(1e300),
        json!(-1e9),
        json!([]),
        json!({}),
        json!(true),
        json!([[[1]]]),
        json!(0),
    ];
    let mut refusals = 0;
    for value in kinds() {
        let mut places = Vec::new();
        leaves(&value, String::new(), &mut places);
        for (k, place) in places.iter().enumerate() {
            let mut spoilt = value.clone();
            *spoilt.pointer_mut(place).unwrap() = others[k % others.len()].clone();
            let text = spoilt.to_string();
            if recognise(&text).is_some()
                && let Some(finding) = refused(&text)
            {
                refusals += 1;
                assert!(finding.primary.is_some() && finding.message.len() < 300, "{place}: {finding:?}");
            }
        }
    }
    assert!(refusals > 100, "{refusals}");
}

#[test]
fn the_place_and_what_was_expected_are_said() {
    let mut sources = SourceMap::new();
    let mut said = |change: &dyn Fn(&mut Value)| {
        let mut value = House::new(5, 1).procthor(false);
        change(&mut value);
        let text = serde_json::to_string_pretty(&value).unwrap();
        let finding = refused(&text).unwrap();
        let id = sources.add(SourceFile::new("house.json", "house.json", text.clone()));
        let at = sources.get(id).position(finding.primary.unwrap().place.range.start);
        let line = text.lines().nth(at.line as usize - 1).unwrap().trim().to_owned();
        (finding.code.to_string(), finding.message, line)
    };
    let case = |code: &str, say: &str, line: &str| (code.to_owned(), say.to_owned(), line.to_owned());
    assert_eq!(
        said(&|v| v["rooms"][0]["floorPolygon"][1]["x"] = json!("wide")),
        case("E0504", "`rooms[0].floorPolygon[1].x` is a string, expected a number", "\"x\": \"wide\",")
    );
    assert_eq!(
        said(&|v| drop(v["objects"][0].as_object_mut().unwrap().remove("position"))),
        case("E0503", "the member `position` of `objects[0]` is missing", "{")
    );
    assert_eq!(
        said(&|v| v["objects"][0]["position"]["y"] = json!(1e9)),
        case(
            "E0505",
            "`objects[0].position.y` is 1000000000; the largest absolute value is 100000",
            "\"y\": 1000000000.0,"
        )
    );
    let (code, say, _) = said(&|v| v["rooms"][0]["floorPolygon"].as_array_mut().unwrap().truncate(2));
    assert_eq!((code.as_str(), say.as_str()), ("E0508", "a floor polygon needs at least 3 vertices, but there are 2"));
    let (code, say, _) = said(&|v| v["rooms"][0]["floorPolygon"].as_array_mut().unwrap().swap(1, 2));
    assert!(code == "E0508" && say.contains("crosses itself"), "{say}");
}

#[test]
fn numbers_that_are_none_are_refused() {
    let text = House::new(5, 1).procthor(false).to_string();
    for (bad, say) in [
        ("NaN", "JSON has no number `NaN`"),
        ("Infinity", "JSON has no number `Infinity`"),
        ("1e999", "the number 1e999 is too large"),
    ] {
        let finding = refused(&text.replacen("\"y\":0.0", &format!("\"y\":{bad}"), 1)).unwrap();
        assert_eq!(finding.message, say);
    }
}

#[test]
fn large_files_and_deep_ones_are_refused_at_once() {
    let large = format!("{{\"rooms\": [], \"walls\": [], \"floorPolygon\": \"{}\"}}", "x".repeat(MAX_BYTES));
    assert!(recognise(&large).is_some());
    assert_eq!(refused(&large).unwrap().code.to_string(), "E0006");
    let deep = format!("{{\"rooms\": [], \"walls\": {}", "[".repeat(100_000));
    assert_eq!(refused(&deep).unwrap().code.to_string(), "E0004");
    let many = json!({ "rooms": [], "walls": [], "objects": vec![json!({}); 20_001] }).to_string();
    assert_eq!(refused(&many).unwrap().code.to_string(), "E0005");
    assert!(Sizes::read("{}", FileId(0)).is_err() && Sizes::read("[1, {", FileId(0)).is_err());
}
