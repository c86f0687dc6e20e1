//! The JSON Schemas: sound by themselves, true of what we read and write, and strict where a schema can be.

use crate::given::{judged, layout};
use jsonschema::Validator;
use scenelang_base::FileId;
use scenelang_verify::compare::compare;
use scenelang_verify::{Detail, Options, Tolerances, schemas, settings};
use serde_json::{Value, json};

/// The validator of a schema.
pub fn validator(name: &str) -> Validator {
    let schema: Value = serde_json::from_str(schemas::find(name).unwrap()).unwrap();
    jsonschema::draft202012::options().build(&schema).unwrap()
}

/// What a schema has against a document.
pub fn faults(validator: &Validator, document: &Value) -> Vec<String> {
    validator.iter_errors(document).map(|e| format!("{}: {e}", e.instance_path())).collect()
}

#[test]
fn every_schema_is_one() {
    for (name, text) in schemas::ALL {
        let schema: Value = serde_json::from_str(text).unwrap();
        assert!(jsonschema::draft202012::meta::is_valid(&schema), "{name}");
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        assert!(schema["$id"].as_str().unwrap().ends_with(&format!("/crates/verify/schemas/{name}.json")));
    }
}

/// Changes to a good layout: where, what (`null`: take it out), and whether a schema can see that it is wrong.
#[test]
fn broken_layouts_are_refused_where_a_schema_can() {
    let good = json!({
        "format": "scenelang.layout/1", "scene": "room.scene", "seed": 7, "incomplete": true, "note": "kept",
        "objects": { "lamp": {
            "pos": [0, 0, 0], "rot": [0, 90, 0], "scale": [1, 1, 1],
            "asset": { "surface": 0.5, "joints": [
                { "name": "lid", "motion": "hinge", "parts": [0], "axis": [0, 1, 0], "anchor": [0, 0, 0], "limits": [0, 90] }
            ], "parts": [
                { "shape": "box", "pos": [0, 0.5, 0], "size": [1, 1, 1] },
                { "shape": "cylinder", "pos": [0, 0.5, 0], "radius": 0.5, "height": 1, "rot": [0, 0, 0] },
                { "shape": "hull", "points": [[0, 0, 0], [0.5, 0, 0], [0, 0, 0.5], [0, 1, 0]] } ] } } },
        "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.5, 4], "vertices": [[0, 0], [4, 0], [0, 4]] } },
        "variables": { "gap": 0.5, "open": true, "at": [1, 2, 3] },
        "draws": { "gap/0": 0.4 }
    });
    let layouts = validator("layout");
    assert_eq!(faults(&layouts, &good), Vec::<String>::new());
    let reads = |document: &Value| {
        let read = scenelang_layout::file::read(&document.to_string(), FileId(0));
        !read.diagnostics.iter().any(|d| d.is_error())
    };
    assert!(reads(&good));
    for (at, what, seen) in [
        ("/format", Value::Null, true),
        ("/format", json!("scenelang.layout/2"), true),
        ("/format", json!(1), true),
        ("/scene", json!(3), true),
        ("/seed", json!(-1), true),
        ("/seed", json!(1.5), true),
        ("/seed", json!("7"), true),
        ("/incomplete", json!("no"), true),
        ("/objects", json!([]), true),
        ("/objects/lamp", json!([1, 2, 3]), true),
        ("/objects/lamp/pos", Value::Null, true),
        ("/objects/lamp/pos", json!([0, 0]), true),
        ("/objects/lamp/pos", json!([0, 0, 0, 0]), true),
        ("/objects/lamp/pos", json!([0, "0", 0]), true),
        ("/objects/lamp/pos", json!([0, 2e6, 0]), true),
        ("/objects/lamp/rot", json!("none"), true),
        ("/objects/lamp/scale", Value::Null, true),
        ("/objects/lamp/scale", json!([1, 0, 1]), true),
        ("/objects/lamp/scale", json!([1, -1, 1]), true),
        ("/objects/lamp/asset", json!("chair.glb"), true),
        ("/objects/lamp/asset/surface", json!(true), true),
        ("/objects/lamp/asset/parts", json!({}), true),
        ("/objects/lamp/asset/parts/0/shape", json!("sphere"), true),
        ("/objects/lamp/asset/parts/0/size", Value::Null, true),
        ("/objects/lamp/asset/parts/1/radius", json!(0), true),
        ("/objects/lamp/asset/parts/1/height", Value::Null, true),
        ("/objects/lamp/asset/parts/2/points", json!([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), true),
        // All in one plane: that takes arithmetic.
        ("/objects/lamp/asset/parts/2/points", json!([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), false),
        ("/regions", json!(null), true),
        ("/regions/room/scale", json!([4, 0, 4]), true),
        ("/regions/room/rot", json!([10, 0, 0]), false),
        ("/regions/room/vertices", json!([[0, 0], [1, 1]]), true),
        ("/regions/room/vertices", json!([[0, 0], [1, 1], [2]]), true),
        ("/regions/room/vertices", json!([[0, 0], [1, 1], [2, 2]]), false),
        ("/draws/gap~10", json!("0.4"), true),
    ] {
        let mut bad = good.clone();
        match (&what, at.rsplit_once('/').unwrap()) {
            (Value::Null, (parent, key)) if at != "/regions" => {
                bad.pointer_mut(parent).unwrap().as_object_mut().unwrap().remove(key);
            }
            (_, (parent, key)) => {
                let parent = bad.pointer_mut(parent).unwrap();
                match key.parse::<usize>() {
                    Ok(i) => parent[i] = what.clone(),
                    Err(_) => parent[key.replace("~1", "/")] = what.clone(),
                }
            }
        }
        assert!(!reads(&bad), "{at} = {what} is read");
        assert_eq!(!faults(&layouts, &bad).is_empty(), seen, "{at} = {what}");
    }
}

#[test]
fn reports_fit_and_what_is_no_report_does_not() {
    let reports = validator("report");
    let scene = "object a; object b;\nassert a.pos.x > 1;\nprefer a = b weight 2;\n@req(\"x\") assert b.pos.x / 0 > 1;\na.pos <- vec3(0, 0, 0)";
    for text in [layout("object a 0 0 0\nobject b 3 0 0"), layout("object a 0 0 0"), "{".to_owned()] {
        for all in [false, true] {
            let report =
                judged(scene, &text, &Options { detail: Detail { all, ..Detail::default() }, ..Options::default() })
                    .report;
            assert_eq!(faults(&reports, &serde_json::to_value(&report).unwrap()), Vec::<String>::new());
        }
    }
    let good = judged("object a;\nassert a.pos.x > 1;", &layout("object a 0 0 0"), &Options::default()).report;
    let good = serde_json::to_value(&good).unwrap();
    for (at, what) in [
        ("/format", json!("scenelang.report/2")),
        ("/ok", json!("yes")),
        ("/summary/pins", json!(3)),
        ("/constraints/0/kind", json!("wish")),
        ("/constraints/0/code", Value::Null),
        ("/constraints/0/code", json!("E0101")),
        ("/constraints/0/unit", Value::Null),
        ("/constraints/0/margin", json!("NaN")),
        ("/constraints/0/span/start", json!([0, 1])),
        ("/constraints/0/span/end", json!([1])),
        ("/diagnostics", json!({})),
        ("/eta", json!(-1)),
    ] {
        let mut bad = good.clone();
        *bad.pointer_mut(at).unwrap() = what.clone();
        assert!(!faults(&reports, &bad).is_empty(), "{at} = {what}");
    }
}

#[test]
fn comparisons_fit() {
    let scene =
        "region r;\nobject a; object b; Number gap;\nassert a.pos.x > gap;\nprefer a.rot.y = 0;\nassert b.pos.x < 2;";
    let judge = |text: &str| judged(scene, &layout(text), &Options::default());
    let before = judge("region r 0 0 0 | 4 3 4\nobject a 0 0 0\nobject b 3 0 0\nvalue gap 0.5");
    for after in [
        "region r 0 0 0 | 4 3 4\nobject a 1 0 0 0 30 0\nobject b 3 0 0\nvalue gap 0.5",
        "region r 0 0 1 | 4 3 4\nobject a 1 0 0 | 1 2 1\nvalue gap 0.25",
        "object c 1 0 0",
    ] {
        let comparison = compare(&before, &judge(after), 1e-3);
        assert!(!comparison.equal);
        let value = serde_json::to_value(&comparison).unwrap();
        assert_eq!(faults(&validator("diff"), &value), Vec::<String>::new(), "{value:#}");
    }
    let same = compare(&before, &before, 0.0);
    assert!(same.equal && same.constraints.is_empty());
}

/// TOML as the JSON that a schema judges.
fn as_json(text: &str) -> Value {
    fn item(item: &toml_edit::Item) -> Value {
        match item.as_table_like() {
            Some(table) => {
                table.iter().map(|(key, i)| (key.to_owned(), item_or(i))).collect::<serde_json::Map<_, _>>().into()
            }
            None => item_or(item),
        }
    }
    fn item_or(i: &toml_edit::Item) -> Value {
        match i {
            toml_edit::Item::Value(v) if !v.is_inline_table() => value(v),
            other => item(other),
        }
    }
    fn value(v: &toml_edit::Value) -> Value {
        let number = v.as_float().map(Value::from).or(v.as_integer().map(Value::from));
        let simple = number.or(v.as_bool().map(Value::from)).or(v.as_str().map(Value::from));
        simple.or(v.as_array().map(|a| a.iter().map(value).collect())).unwrap_or(Value::Null)
    }
    item(toml_edit::Document::parse(text).unwrap().as_item())
}

#[test]
fn settings_are_refused_by_their_schema_and_by_the_reader_alike() {
    let config = validator("config");
    for (text, good) in [
        ("", true),
        ("physics = false\ngeometry = \"box\"\neta = 0.1\n[tolerances]\nequal = 0\n[lints]\nallow = [\"W0203\"]", true),
        ("tolerances = { angle = 1, door = 0.5 }", true),
        ("phisics = true", false),
        ("physics = 1", false),
        ("geometry = \"mesh\"", false),
        ("eta = -0.1", false),
        ("eta = 1e7", false),
        ("tolerances = 3", false),
        ("[tolerances]\nequals = 1", false),
        ("[tolerances]\nlevel = \"1\"", false),
        ("[lints]\nallow = \"W0203\"", false),
        ("[lints]\nallow = [\"E0203\"]", false),
        ("[lints]\ndeny = []", false),
        ("[llm]\nmodel = \"openai:m\"\nbatch = 3\nrounds = 0\ntemperature = 0\nmax_calls = 0\ncache = false", true),
        ("[llm]\nmax_output = 1\ntimeout = 1\ntries = 1\nper_minute = 0.5\nmax_tokens = 9\nmax_money = 0.5", true),
        ("[llm.prices.\"openai:m\"]\ninput = 2.5\noutput = 10", true),
        ("[llm.prices.m]\ninput = 2.5", false),
        ("[llm.prices.m]\ninput = -1\noutput = 1", false),
        ("[llm]\nmodel = 3", false),
        ("[llm]\nbatch = 0", false),
        ("[llm]\nrounds = 1.5", false),
        ("[llm]\nmax_output = 0", false),
        ("[llm]\ntemperature = 3", false),
        ("[llm]\napi_key = \"x\"", false),
        ("[llm]\nbase_url = \"x\"", false),
        ("llm = 3", false),
    ] {
        assert_eq!(settings::read(text, FileId(0)).is_ok(), good, "{text}");
        assert_eq!(faults(&config, &as_json(text)).is_empty(), good, "{text}");
    }
}

#[test]
fn the_schema_of_settings_states_the_defaults() {
    let schema: Value = serde_json::from_str(schemas::find("config").unwrap()).unwrap();
    let stated = schema["properties"]["tolerances"]["properties"].as_object().unwrap();
    let defaults = serde_json::to_value(Tolerances::default()).unwrap();
    assert_eq!(stated.keys().collect::<Vec<_>>(), Tolerances::NAMES.iter().collect::<Vec<_>>());
    for (name, property) in stated {
        assert_eq!(property["default"].as_f64(), defaults[name].as_f64(), "{name}");
    }
    assert_eq!(schema["properties"]["eta"]["default"].as_f64(), Some(scenelang_verify::DEFAULT_ETA));
}
