//! The placement problems of `tests/problems`: hidden layouts are solutions, the judge there and our verifier agree on
//! what holds in layouts that are not, and `bench solve` says what both of them say.

use crate::support::{Ended, python, read_json, root, run, scenelang, skip};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Margins nearer to zero than this may be judged either way (metres, degrees): tolerances differ.
const CLOSE: f64 = 0.3;
const CLOSE_METRES: f64 = 0.006;

fn problems() -> PathBuf {
    root().join("tests/problems")
}

/// Names of the sample's problems.
pub fn sample() -> Vec<String> {
    let files = fs::read_dir(problems().join("sample")).unwrap().map(|e| e.unwrap().path());
    let scenes = files.filter(|p| p.extension().is_some_and(|e| e == "scene"));
    let mut names: Vec<String> = scenes.map(|p| p.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    names.sort();
    assert!(names.len() >= 12, "{names:?}");
    names
}

pub fn file(name: &str, ending: &str) -> PathBuf {
    problems().join("sample").join(format!("{name}.{ending}"))
}

/// Any Python will do: the scripts use nothing beside it.
fn plain_python() -> Option<PathBuf> {
    let there = || Command::new("python3").arg("--version").output().is_ok_and(|o| o.status.success());
    let found = python().or_else(|| there().then(|| "python3".into()));
    if found.is_none() {
        skip("problems not judged: no python3");
    }
    found
}

fn script(python: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.arg("-B").arg(problems().join(name));
    command
}

/// The judge's verdicts on some layouts of a problem.
fn judged(python: &Path, name: &str, layouts: &[PathBuf]) -> Vec<Value> {
    let ended = run(script(python, "judge.py").arg(file(name, "json")).args(layouts), b"");
    assert!(ended.code < 2, "{name}: {}", ended.stderr);
    ended.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn check(folder: &Path, files: &[PathBuf]) -> Ended {
    let args = ["check", "--format", "json", "--explain", "none"].map(PathBuf::from);
    scenelang(folder, args.iter().chain(files))
}

#[test]
fn hidden_layouts_are_solutions_and_contradictions_are_found_whole() {
    for name in sample() {
        let facts = read_json(&file(&name, "json"));
        if facts["contradiction"].is_null() {
            let ended = check(&root(), &[file(&name, "witness.json")]);
            assert_eq!(ended.code, 0, "{name}: {}", ended.stdout);
            continue;
        }
        let ended = scenelang(&root(), ["bench", "solve", "--format", "json", file(&name, "scene").to_str().unwrap()]);
        assert_eq!(ended.code, 0, "{name}: {}", ended.stderr);
        let record: Value = serde_json::from_str(&ended.stdout).unwrap();
        let found: BTreeSet<&str> =
            record["runs"][0]["contradictions"][0].as_array().unwrap().iter().map(|c| c.as_str().unwrap()).collect();
        let planted: BTreeSet<&str> =
            facts["contradiction"].as_array().unwrap().iter().map(|c| c.as_str().unwrap()).collect();
        assert_eq!(found, planted, "{name}");
    }
}

/// Layouts with one object out of place each.
fn broken(layout: &Value) -> Vec<Value> {
    let names: Vec<&String> = layout["objects"].as_object().unwrap().keys().collect();
    let moves = [[0.3, 0.0, 0.0, 0.0], [0.0, 0.0, -0.35, 40.0], [-1.1, 0.0, 0.6, 100.0], [0.0, 0.4, 0.0, 0.0]];
    let mut out = Vec::new();
    for (i, name) in names.iter().enumerate() {
        for (k, by) in moves.iter().enumerate() {
            // Each in two ways; of many objects, in one.
            if (i + k) % (if names.len() > 12 { 4 } else { 2 }) != 0 {
                continue;
            }
            let mut moved = layout.clone();
            let object = &mut moved["objects"][name.as_str()];
            for axis in 0..3 {
                object["pos"][axis] = json!(object["pos"][axis].as_f64().unwrap() + by[axis]);
            }
            object["rot"][1] = json!(object["rot"][1].as_f64().unwrap() + by[3]);
            out.push(moved);
        }
    }
    out
}

/// Holds a report and a verdict against each other; the kinds of stated constraints that both saw fail.
fn agree(name: &str, facts: &Value, report: &Value, verdict: &Value) -> BTreeSet<String> {
    let mut failed = BTreeSet::new();
    let of = |id: &str| facts["constraints"].as_array().unwrap().iter().find(|c| c["id"] == id).unwrap();
    let near = |margin: &Value, unit: &Value| {
        margin.as_f64().is_some_and(|m| m.abs() < if unit == "deg" { CLOSE } else { CLOSE_METRES })
    };
    for row in report["constraints"].as_array().unwrap() {
        let Some(id) = row["requirements"][0].as_str() else { continue };
        let margin = &verdict["margins"][id];
        // A facing within 30 degrees is measured in metres here and there; either may be close.
        if near(&row["margin"], &row["unit"]) || near(margin, &row["unit"]) {
            continue;
        }
        let holds = if row["kind"] == "prefer" {
            margin.as_f64().is_none_or(|m| m >= 0.0)
        } else {
            !verdict["broken"].as_array().unwrap().iter().any(|b| b == id)
        };
        assert_eq!(row["satisfied"], holds, "{name}: {row:#} but {margin} in {}", verdict["layout"]);
        if !holds {
            failed.insert(of(id)["kind"].as_str().unwrap().to_owned());
        }
    }
    let physical = |row: &&Value| !row["rule"].is_null() && row["satisfied"] == false;
    let mut rows = report["constraints"].as_array().unwrap().iter().filter(physical);
    let wrong = verdict["wrong"].as_array().unwrap();
    if !wrong.is_empty() {
        assert!(rows.clone().next().is_some(), "{name}: {wrong:?}, and nothing in {}", verdict["layout"]);
    } else if let Some(row) = rows.find(|row| !near(&row["margin"], &row["unit"])) {
        panic!("{name}: {row:#}, and nothing found by the judge in {}", verdict["layout"]);
    }
    failed
}

#[test]
fn the_judge_and_the_verifier_agree_on_broken_layouts() {
    let Some(python) = plain_python() else { return };
    let (mut failed, mut stated) = (BTreeSet::new(), BTreeSet::new());
    for name in sample() {
        let facts = read_json(&file(&name, "json"));
        if !facts["contradiction"].is_null() {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        fs::copy(file(&name, "scene"), folder.path().join(format!("{name}.scene"))).unwrap();
        let witness = read_json(&file(&name, "witness.json"));
        let mut layouts = Vec::new();
        for (i, layout) in std::iter::once(witness.clone()).chain(broken(&witness)).enumerate() {
            let path = folder.path().join(format!("{i}.layout.json"));
            fs::write(&path, layout.to_string()).unwrap();
            layouts.push(path);
        }
        let verdicts = judged(&python, &name, &layouts);
        assert_eq!(verdicts[0]["valid"], true, "{name}: {}", verdicts[0]);
        let reports = check(folder.path(), &layouts).reports();
        assert_eq!((reports.len(), verdicts.len()), (layouts.len(), layouts.len()), "{name}");
        for (report, verdict) in reports.iter().zip(&verdicts) {
            failed.extend(agree(&name, &facts, report, verdict));
        }
        let counted = facts["constraints"].as_array().unwrap().iter().filter(|c| c["given"].is_null());
        stated.extend(counted.map(|c| c["kind"].as_str().unwrap().to_owned()));
    }
    assert_eq!(failed, stated, "each kind was seen to fail");
}

#[test]
fn the_sample_is_what_the_generator_makes() {
    let Some(python) = plain_python() else { return };
    let folder = tempfile::tempdir().unwrap();
    let ended = run(script(&python, "generate.py").arg("--sample").arg("-o").arg(folder.path()), b"");
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let read = |path: &Path| fs::read_to_string(path).unwrap();
    let mut files = 0;
    for entry in fs::read_dir(folder.path()).unwrap() {
        let made = entry.unwrap().path();
        let kept = problems().join("sample").join(made.file_name().unwrap());
        assert_eq!(read(&made), read(&kept), "{}", kept.display());
        files += 1;
    }
    assert_eq!(files, fs::read_dir(problems().join("sample")).unwrap().count());
}

#[test]
fn bench_solve_counts_what_the_judge_accepts() {
    let name = "tight-packing-n10-d85-s1";
    let folder = tempfile::tempdir().unwrap();
    let (scene, layouts, record) =
        (folder.path().join(format!("{name}.scene")), folder.path().join("layouts"), folder.path().join("bench.json"));
    // A layout may name a program beside its folder where one workspace holds both.
    fs::write(folder.path().join("scenelang.toml"), "").unwrap();
    fs::copy(file(name, "scene"), &scene).unwrap();
    let args = ["bench", "solve", "--seeds", "2", "--threads", "2", "--layouts"].map(PathBuf::from);
    let rest = [layouts.clone(), "-o".into(), record.clone(), scene];
    let ended = scenelang(folder.path(), args.iter().chain(&rest));
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    let row = ended.stdout.lines().find(|line| line.contains("tight-packing")).unwrap();
    assert!(row.contains("100.0 %"), "{row}");
    assert!(ended.stdout.contains("93.8 %"), "the published figure stands beside ours: {}", ended.stdout);

    let record = read_json(&record);
    assert_eq!(record["format"], "scenelang.bench/1");
    let family = &record["families"][0];
    assert_eq!((&family["problems"], &family["runs"], &family["solved"]), (&json!(1), &json!(2), &json!(2)));
    let files: Vec<PathBuf> = (0..2).map(|seed| layouts.join(format!("{name}.s{seed}.layout.json"))).collect();
    assert_eq!(check(folder.path(), &files).code, 0);
    if let Some(python) = plain_python() {
        for verdict in judged(&python, name, &files) {
            assert_eq!(verdict["valid"], true, "{verdict}");
        }
    }
}

#[test]
fn bench_solve_says_what_it_cannot_run() {
    let folder = tempfile::tempdir().unwrap();
    let bench = || scenelang(folder.path(), ["bench", "solve", "."]);
    let ended = bench();
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("there is no .scene file"), "{}", ended.stderr);
    fs::write(folder.path().join("a.scene"), "object a; assert a.pos.x >").unwrap();
    fs::write(folder.path().join("b.scene"), "object b; b.dimensions <- vec3(1, 1, 1);").unwrap();
    let ended = bench();
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("a.scene does not compile"), "{}", ended.stderr);
    assert!(ended.stdout.contains("100.0 %"), "the others are run: {}", ended.stdout);
}
