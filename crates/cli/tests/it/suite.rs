//! `scenelang eval dataset`, `run` and `report`: the same bytes each time, work that is taken up again, a model by a script.

use crate::support::{Ended, scenelang};
use scenelang_eval::correctness::{compiled, direct};
use scenelang_eval::dataset::scene;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Seeds of scenes that are laid out fast.
const SUITE: &str = r#"{ "format": "scenelang.suite/1", "name": "two", "scenes": 2, "seed": 7 }"#;

fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let read = |path: std::path::PathBuf| {
        (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap())
    };
    entries.filter(|path| path.is_file()).map(read).collect()
}

#[test]
fn a_dataset_is_the_same_for_any_number_of_jobs() {
    let folder = tempfile::tempdir().unwrap();
    let make = |output: &str, jobs: &str| {
        let fixed =
            ["eval", "dataset", "--scenes", "2", "--seed", "7", "--format", "json", "-o", output, "--jobs", jobs];
        scenelang(folder.path(), fixed)
    };
    let one = make("one", "1");
    assert_eq!((one.code, one.stderr.as_str()), (0, ""), "{}", one.stdout);
    let found: Value = serde_json::from_str(&one.stdout).unwrap();
    assert_eq!(found["scenes_in_which_all_holds"], json!([2, 2]));
    let two = make("two", "2");
    assert_eq!(two.stdout, one.stdout);
    let written = files(&folder.path().join("one"));
    assert_eq!(files(&folder.path().join("two")), written);
    assert_eq!(written["dataset.jsonl"].lines().count(), 2);
    // Request and ground truth are in the form that `eval requests` reads, program and layout in that of `check`.
    let read = scenelang(folder.path(), ["eval", "requests", "one", "--programs", "one", "--format", "json"]);
    assert_eq!((read.code, read.stderr.as_str()), (0, ""), "{}", read.stdout);
    let read: Value = serde_json::from_str(&read.stdout).unwrap();
    assert_eq!((&read["mean"]["recall"], &read["compiled"]), (&json!(1.0), &json!([2, 2])));
    let id = scene(7, 0).id;
    let checked = scenelang(folder.path(), ["check", &format!("one/{id}.layout.json")]);
    assert_eq!(checked.code, 0, "{}", checked.stdout);
    // What somebody has edited stays.
    fs::write(folder.path().join("one/dataset.jsonl"), "mine\n").unwrap();
    let again = make("one", "1");
    assert!(again.code == 2 && again.stderr.contains("dataset.jsonl"), "{}", again.stderr);
}

fn run(folder: &Path, more: &[&str]) -> Ended {
    scenelang(folder, ["eval", "run", "--suite", "suite.json", "-o", "results", "--format", "json"].iter().chain(more))
}

#[test]
fn a_run_is_taken_up_again_and_reported() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("suite.json"), SUITE).unwrap();
    let first = run(folder.path(), &["--jobs", "2"]);
    assert_eq!((first.code, first.stderr.as_str()), (0, ""), "{}", first.stdout);
    let figures: Value = serde_json::from_str(&first.stdout).unwrap();
    assert_eq!((figures["scenes"].clone(), figures["size"][0].clone()), (json!(2), json!(2)));
    assert_eq!(figures["search"].as_array().map(Vec::len), Some(7));
    // One that is missing is measured, the other is not: its times stay.
    let cases = folder.path().join("results/cases");
    let [one, other] = [0, 1].map(|number| cases.join(format!("{}.json", scene(7, number).id)));
    let kept = fs::read_to_string(&other).unwrap();
    fs::remove_file(&one).unwrap();
    assert_eq!(run(folder.path(), &["--jobs", "1"]).stdout, first.stdout);
    assert_eq!(fs::read_to_string(&other).unwrap(), kept);
    assert!(one.is_file());
    // A page, and another form of it.
    let report = |more: &[&str]| scenelang(folder.path(), ["eval", "report", "results"].iter().chain(more));
    let shown = report(&["-o", "docs/page.md", "--html", "page.html"]);
    assert_eq!((shown.code, shown.stderr.as_str()), (0, ""));
    let page = fs::read_to_string(folder.path().join("docs/page.md")).unwrap();
    for name in ["evaluation-iterations.svg", "evaluation-tau.svg", "evaluation-time.svg"] {
        assert!(page.contains(&format!("(images/{name})")), "{page}");
        let svg = fs::read_to_string(folder.path().join("docs/images").join(name)).unwrap();
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{svg}");
    }
    let html = fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(html.contains("<svg") && html.contains("<table>"));
    let again = report(&["-o", "docs/page.md"]);
    assert!(again.code == 2 && again.stderr.contains("page.md"), "{}", again.stderr);
    assert_eq!(report(&["-o", "docs/page.md", "--force"]).code, 0);
    fs::remove_file(&one).unwrap();
    let missing = report(&[]);
    assert!(missing.code == 2 && missing.stderr.contains("eval run"), "{}", missing.stderr);
}

#[test]
fn a_model_is_asked_and_vectors_are_used() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    put("suite.json", &SUITE.replace("\"scenes\": 2", "\"scenes\": 1"));
    let asked = scene(7, 0);
    let program = compiled(&asked.program).unwrap();
    let answer = json!({ "objects": [{ "name": program.objects[0].name.as_str(), "x": 0, "y": 0, "z": 0, "yaw": 0 }] });
    let turn = json!({
        "request": direct::question(&asked, &program, 7),
        "reply": { "text": answer.to_string(), "usage": { "input": 1, "output": 1 } },
    });
    put("talk.json", &json!({ "format": "scenelang.conversation/1", "model": "m", "turns": [turn] }).to_string());
    let ended = run(folder.path(), &["--model", "replay:talk.json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let figures: Value = serde_json::from_str(&ended.stdout).unwrap();
    let placed = figures["direct"][1].as_f64().unwrap();
    assert!(placed > 0.0 && placed < 10.0, "one object of many: {figures}");
    // The question about its picture has no answer in the conversation: only with --pictures is it asked.
    let ended = run(folder.path(), &["--model", "replay:talk.json", "--pictures"]);
    assert!(ended.code == 2 && ended.stderr.contains(&asked.id), "{}", ended.stderr);
    let ended = run(folder.path(), &["--pictures"]);
    assert!(ended.code == 2 && ended.stderr.contains("--model"), "{}", ended.stderr);
    // Without the model it is another measurement.
    let figures: Value = serde_json::from_str(&run(folder.path(), &[]).stdout).unwrap();
    assert_eq!((&figures["direct"], &figures["similarity"]), (&Value::Null, &json!("lexical")));

    // Vectors of all texts: each is alike to itself and to nothing else by more than a half.
    let ended = scenelang(folder.path(), ["eval", "run", "--suite", "suite.json", "--texts", "texts.jsonl"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let texts = fs::read_to_string(folder.path().join("texts.jsonl")).unwrap();
    let count = texts.lines().count();
    let vector = |(n, line): (usize, &str)| {
        let mut line: Value = serde_json::from_str(line).unwrap();
        line["vector"] = (0..count).map(|i| u8::from(i == n)).collect();
        line.to_string() + "\n"
    };
    put("m.jsonl", &texts.lines().enumerate().map(vector).collect::<String>());
    let figures: Value = serde_json::from_str(&run(folder.path(), &["--embeddings", "m.jsonl"]).stdout).unwrap();
    assert_eq!(figures["similarity"], "m");
    assert!(figures["resemblance"][0][2].as_f64() > Some(0.0), "things of the same name and look are found: {figures}");
    put("m.jsonl", "{\"text\": \"x\", \"vector\": [1]}\n");
    let ended = run(folder.path(), &["--embeddings", "m.jsonl"]);
    assert!(ended.code == 2 && ended.stderr.contains("--texts"), "{}", ended.stderr);
}

#[test]
fn a_suite_that_is_none_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (text, why) in [("{", "suite.json"), ("{}", "missing field")] {
        fs::write(folder.path().join("suite.json"), text).unwrap();
        let ended = run(folder.path(), &[]);
        assert!(ended.code == 2 && ended.stderr.contains(why), "{}", ended.stderr);
    }
    let ended = scenelang(folder.path(), ["eval", "report", "results"]);
    assert!(ended.code == 2 && ended.stderr.contains("suite.json"), "{}", ended.stderr);
}
