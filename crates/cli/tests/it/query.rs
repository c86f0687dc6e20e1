//! `scenelang query`: what is known of an object, in the scene as it stands.

use crate::support::{Ended, fits, folder_of, root, scenelang};
use serde_json::{Value, json};
use std::fs;

const SCENE: &str = "\
region study;
study.scale <- vec3(4, 2.5, 4);
/// Where one works.
@req(\"a desk\")
object desk;
desk.category <- \"desk\";
desk.dimensions <- vec3(1.4, 0.75, 0.7);
object chair[2];
object lamp;
lamp.dimensions <- vec3(0.2, 0.4, 0.2);
object picture;
@req(\"a picture on the wall\")
assert wallMounted(picture, study);
assert on(lamp, desk);
@req(\"the chairs are near the desk\")
assert forall c in chair: near(c, desk, 0.5);
prefer chair[0].pos.x > 1;
";

const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "objects": {
    "desk": { "pos": [0, 0, 0], "scale": [1.4, 0.75, 0.7], "asset": {
      "parts": [ { "shape": "box", "pos": [0, 0.375, 0.05], "size": [1.4, 0.75, 0.6] },
                 { "shape": "box", "pos": [0, 0.6, -0.3], "size": [0.4, 0.1, 0.1] } ],
      "joints": [ { "name": "drawer", "motion": "slide", "parts": [1], "axis": [0, 0, -1], "anchor": [0, 0, 0], "limits": [0, 0.25] } ] } },
    "lamp": { "pos": [0.3, 0.75, 0], "scale": [0.2, 0.4, 0.2] },
    "chair[0]": { "pos": [0, 0, 1.5], "scale": [0.5, 0.9, 0.5] },
    "chair[1]": { "pos": [0, 0.3, -0.8], "rot": [0, 90, 0], "scale": [0.5, 0.9, 0.5] },
    "picture": { "pos": [0, 1.4, 1.98], "rot": [0, 180, 0], "scale": [0.8, 0.6, 0.04] } },
  "regions": { "study": { "pos": [0, 0, 0], "scale": [4, 2.5, 4] } } }"#;

fn query(files: &[(&str, &str)], args: &[&str]) -> Ended {
    scenelang(folder_of(files).path(), ["query"].iter().chain(args))
}

/// The objects of an answer, and what is known of each beside its pose.
fn details(args: &[&str]) -> Vec<(String, Value)> {
    let files = [("room.scene", SCENE), ("room.layout.json", LAYOUT)];
    let ended = query(&files, &[args, &["--format", "json"]].concat());
    assert_eq!(ended.code, 0, "{ended:?}");
    let found = fits("query", &ended.stdout);
    let objects = found["objects"].as_array().unwrap().iter();
    objects.map(|object| (object["name"].as_str().unwrap().to_owned(), object.clone())).collect()
}

/// The verdict of the row that has this text, or this id.
fn verdict<'v>(object: &'v Value, row: &str) -> &'v Value {
    let rows = object["details"]["constraints"].as_array().unwrap();
    let found = rows.iter().find(|r| r["text"].as_str().unwrap().starts_with(row) || r["id"] == row);
    &found.unwrap_or_else(|| panic!("no {row} in {object:#}"))["satisfied"]
}

#[test]
fn an_object_is_known_with_all_that_speaks_of_it() {
    let desk = details(&["room.scene", "--object", "desk"]).remove(0).1;
    assert_eq!((&desk["category"], &desk["requirements"]), (&json!("desk"), &json!(["a desk"])));
    assert_eq!(desk["declared"]["text"], "object desk");
    assert_eq!(desk["declared"]["span"]["start"], json!([5, 1]));
    assert_eq!(desk["pose"]["size"], json!([1.4, 0.75, 0.7]));
    assert_eq!(desk["details"]["rests_on"], json!({ "on": "floor", "name": "study" }));
    let drawer = json!({ "name": "drawer", "motion": "slide", "limits": [0.0, 0.25], "useful": null });
    assert_eq!(desk["details"]["joints"], json!([drawer]));
    for (row, holds) in [
        ("on(lamp, desk)", true),
        ("forall c in chair: near(c, desk, 0.5)", false),
        ("P-BOUNDS:desk", true),
        ("P-SUPPORT:desk", true),
    ] {
        assert_eq!(*verdict(&desk, row), json!(holds), "{row}");
    }
    let rows = desk["details"]["constraints"].as_array().unwrap();
    let near = rows.iter().find(|row| row["text"].as_str().unwrap().contains("near(c, desk")).unwrap();
    assert_eq!(near["requirements"], json!(["the chairs are near the desk"]));
    assert!(near["margin"].as_f64().unwrap() < 0.0 && near["unit"] == "m", "{near:#}");
    assert!(rows.iter().all(|row| !row["text"].as_str().unwrap().contains("wallMounted")), "{rows:#?}");
}

#[test]
fn names_stand_for_objects_and_for_arrays() {
    let names = |args: &[&str]| details(args).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
    assert_eq!(names(&["room.layout.json", "--object", "chair"]), ["chair[0]", "chair[1]"]);
    assert_eq!(names(&["room.layout.json", "--object", "chair[1]"]), ["chair[1]"]);
    assert_eq!(names(&["room.scene"]), ["desk", "chair[0]", "chair[1]", "lamp", "picture"]);
    let files = [("room.scene", SCENE), ("room.layout.json", LAYOUT)];
    for (name, said) in [
        ("dask", "the program has no object `dask`; did you mean `desk`?"),
        ("chair[7]", "the program has no object `chair[7]`; did you mean `chair[0]`?"),
        ("study", "`study` is a region"),
    ] {
        let ended = query(&files, &["room.scene", "--object", name]);
        assert!(ended.code == 2 && ended.stderr.contains(said), "{said}: {ended:?}");
    }
}

#[test]
fn what_it_rests_on_is_what_it_rests_on_now() {
    for (name, on, what) in [
        ("lamp", "object", "desk"),
        ("desk", "floor", "study"),
        ("chair[0]", "floor", "study"),
        ("picture", "wall", "study"),
    ] {
        let found = details(&["room.scene", "--object", name]).remove(0).1;
        assert_eq!(found["details"]["rests_on"], json!({ "on": on, "name": what }), "{name}");
    }
    let chair = details(&["room.scene", "--object", "chair[1]"]).remove(0).1;
    let rests = &chair["details"]["rests_on"];
    assert_eq!((&rests["on"], &rests["name"]), (&json!("nothing"), &Value::Null));
    assert!((rests["gap"].as_f64().unwrap() - 0.3).abs() < 1e-9, "{rests}");
    assert_eq!(*verdict(&chair, "P-SUPPORT:chair[1]"), json!(false));
    let counts = &chair["constraints"];
    assert!(counts["fails"].as_u64() >= Some(1) && counts["unmet"] == 0, "{counts}");
    let first = details(&["room.scene", "--object", "chair[0]"]).remove(0).1;
    assert_eq!(first["constraints"]["unmet"], 1, "{first:#}");
}

#[test]
fn people_read_a_table_of_all_objects() {
    let files = [("room.scene", SCENE), ("room.layout.json", LAYOUT)];
    let ended = query(&files, &["room.scene"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    for part in ["object", "category", "chair[1]", "0.000, 0.300, -0.800", "90.0°"] {
        assert!(ended.stdout.contains(part), "{part}: {}", ended.stdout);
    }
    // Machines have the same, without what is known of one object only.
    assert!(details(&["room.scene"]).iter().all(|(_, object)| object.get("details").is_none()));
}

#[test]
fn what_cannot_be_judged_is_told_as_far_as_it_is_known() {
    let missing = LAYOUT.replace("\"lamp\"", "\"lamps\"");
    for (files, args, code, said) in [
        (
            vec![("room.scene", SCENE)],
            vec!["room.scene", "--object", "lamp"],
            0,
            "is stated  room.scene:14:1  on(lamp, desk)",
        ),
        (vec![("room.scene", SCENE)], vec!["room.scene"], 0, "nothing was checked"),
        (
            vec![("room.scene", SCENE), ("room.layout.json", missing.as_str())],
            vec!["room.scene", "--object", "lamp"],
            2,
            "is not in the layout",
        ),
        (vec![("room.scene", "object")], vec!["room.scene"], 2, ""),
        (vec![], vec!["room.scene"], 2, ""),
        (vec![], vec!["room.glb"], 2, ""),
        (vec![("room.layout.json", "{")], vec!["room.layout.json"], 2, ""),
        (vec![], vec!["."], 2, ""),
    ] {
        let ended = query(&files, &args);
        assert_eq!(ended.code, code, "{files:?} {args:?}\n{ended:?}");
        assert!(ended.stdout.contains(said) && (code < 2 || !ended.stderr.is_empty()), "{said}: {ended:?}");
    }
}

#[test]
fn the_book_shows_a_query_as_it_is() {
    let page = fs::read_to_string(root().join("spec/src/command-line.md")).unwrap();
    let section = page.split("\n## query\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let block = |tag: &str| section.split(&format!("```{tag}\n")).nth(1).unwrap().split("```").next().unwrap();
    let files = [("room.scene", block("scene")), ("room.layout.json", block("json layout"))];
    assert_eq!(query(&files, &["room.scene", "--object", "lamp"]).stdout, block("text query lamp"));
    assert_eq!(query(&files, &["room.scene"]).stdout, block("text query"));
}
