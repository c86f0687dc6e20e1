//! The promise of `examples/`: each solves wholly from ten seeds, and a hand in the layout is noticed and named.

use crate::support::{EXAMPLES, fits, folder_with, for_each_example, read_json, scenelang};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The default seed and nine others.
const SEEDS: [Option<u64>; 10] =
    [None, Some(1), Some(2), Some(3), Some(5), Some(8), Some(13), Some(21), Some(1_000_003), Some(u32::MAX as u64)];

/// Solves a scene; the layout's path.
fn solve(folder: &Path, scene: &Path, seed: Option<u64>) -> PathBuf {
    let layout = scene.with_extension("layout.json");
    let mut args = vec!["solve".to_owned(), scene.display().to_string(), "-o".to_owned(), layout.display().to_string()];
    args.extend(seed.into_iter().flat_map(|s| ["--seed".to_owned(), s.to_string()]));
    let ended = scenelang(folder, args);
    assert_eq!(ended.code, 0, "seed {seed:?}:\n{}{}", ended.stdout, ended.stderr);
    fits("layout", &std::fs::read_to_string(&layout).unwrap());
    layout
}

/// The report of `check --format json`, with the exit code.
fn check(folder: &Path, file: &Path) -> (i32, Value) {
    let ended = scenelang(folder, ["check", &file.display().to_string(), "--format", "json"]);
    let mut reports = ended.reports();
    assert_eq!(reports.len(), 1, "{ended:?}");
    (ended.code, reports.remove(0))
}

/// Rows that fail.
fn failing(report: &Value) -> Vec<&Value> {
    report["constraints"].as_array().unwrap().iter().filter(|c| c["satisfied"] == false).collect()
}

mod solve_from_ten_seeds {
    use super::*;

    fn holds(name: &str) {
        let (folder, scene) = folder_with(name);
        for seed in SEEDS {
            let layout = solve(folder.path(), &scene, seed);
            let (code, report) = check(folder.path(), &layout);
            let hard: Vec<_> = failing(&report).into_iter().filter(|c| c["kind"] != "prefer").collect();
            assert!(hard.is_empty(), "seed {seed:?}: {hard:#?}");
            assert_eq!((code, &report["ok"]), (0, &Value::Bool(true)), "seed {seed:?}");
            for part in ["assertions", "physical", "pins"] {
                let summary = &report["summary"][part];
                assert_eq!(summary["total"], summary["satisfied"], "seed {seed:?}, {part}");
                assert!(summary["total"].as_u64() > Some(0), "{part} are judged");
            }
            assert_eq!(report["diagnostics"].as_array().map(Vec::len), Some(0), "{:#}", report["diagnostics"]);
        }
    }
    for_each_example!(holds);
}

mod compile_without_a_word {
    use super::*;

    fn holds(name: &str) {
        let (folder, scene) = folder_with(name);
        let (code, report) = check(folder.path(), &scene);
        assert_eq!(code, 0);
        assert_eq!(report["diagnostics"].as_array().map(Vec::len), Some(0), "{:#}", report["diagnostics"]);
        let ended = scenelang(folder.path(), ["fmt", "--check", &scene.display().to_string()]);
        assert_eq!(ended.code, 0, "not formatted: {}{}", ended.stdout, ended.stderr);
        let program = scenelang_lang::compile_file(name, &scene, scenelang_lang::Options::default()).program.unwrap();
        assert!((8..=40).contains(&program.objects.len()), "{} objects", program.objects.len());
    }
    for_each_example!(holds);
}

/// One object of each example, how far it is moved, and the text or the id of a row that must fail for it.
const MOVES: [(&str, &str, [f64; 3], &str); 7] = [
    ("meeting-room", "whiteboard", [0.0, 0.0, 0.4], "wallMounted(whiteboard, room)"),
    ("bedroom", "bedLamp[1]", [0.0, 0.2, 0.0], "P-SUPPORT:bedLamp[1]"),
    ("apartment", "sofa", [0.0, 0.0, 20.0], "P-BOUNDS:sofa"),
    ("classroom", "chair[5]", [0.0, 0.0, 1.6], "near(chair[i], desk[i], 0.3)"),
    ("restaurant", "stool[0]", [0.9, 0.0, 0.0], "P-COLLIDE:stool[0]:stool[1]"),
    ("robot-lab", "extinguisher[0]", [9.0, 0.0, 0.0], "walkDistance(w, e) <= 2"),
    ("workshop-safety", "extinguisher[1]", [0.0, 0.0, -1.0], "wallMounted(extinguisher[i], workshop)"),
];

mod notice_a_hand_in_the_layout {
    use super::*;

    fn holds(name: &str) {
        let (_, object, by, want) = MOVES.into_iter().find(|m| m.0 == name).expect("a move for each example");
        let (folder, scene) = folder_with(name);
        let path = solve(folder.path(), &scene, None);
        let mut layout = read_json(&path);
        for (i, d) in by.into_iter().enumerate() {
            let x = &mut layout["objects"][object]["pos"][i];
            *x = (x.as_f64().unwrap() + d).into();
        }
        std::fs::write(&path, layout.to_string()).unwrap();

        let (code, report) = check(folder.path(), &path);
        assert_eq!(code, 1);
        let rows = failing(&report);
        let row = rows.iter().find(|c| c["id"] == want || c["text"].as_str().is_some_and(|t| t.contains(want)));
        let row = row.unwrap_or_else(|| panic!("no failing row for {want}: {rows:#?}"));
        assert!(row["objects"].as_array().unwrap().iter().any(|o| o == object), "{row:#}");
        // A path that is not there has no length, hence no margin.
        assert!(row["margin"].as_f64().map_or(want.contains("walkDistance"), |m| m < 0.0), "{row:#}");
        assert!(row["code"].as_str().unwrap().starts_with('V'), "{row:#}");

        let human = scenelang(folder.path(), ["check", &path.display().to_string()]);
        assert_eq!(human.code, 1);
        let said = human.stdout + &human.stderr;
        assert!(said.contains(object), "the object is named:\n{said}");
    }
    for_each_example!(holds);
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let (folder, scene) = folder_with(EXAMPLES[1]);
    let read = |seed| std::fs::read(solve(folder.path(), &scene, seed)).unwrap();
    let first = read(Some(7));
    assert_eq!(first, read(Some(7)));
    assert_ne!(first, read(Some(8)));
}
