//! `scenelang sample` and `scenelang batch`: the same bytes however the work is split, what becomes of what is bad, and going
//! on after an end at any moment.

use crate::support::{Ended, binary, root, scenelang};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object box;\nbox.dimensions <- vec3(rand(0.5, 1), 0.5, 0.6);\nobject crate;\ncrate.dimensions <- vec3(0.5, 0.5, 0.5);\n\
    assert gap(box, crate) >= 0.5;\n";
/// The same without draws.
fn fixed() -> String {
    ROOM.replace("rand(0.5, 1)", "0.8")
}

/// All files of a folder with names that end so, in order, as one.
fn joined(folder: &Path, end: &str) -> String {
    let mut found: Vec<_> = vec![folder.to_path_buf()];
    let mut files = Vec::new();
    while let Some(folder) = found.pop() {
        for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                found.push(entry);
            } else if entry.to_string_lossy().ends_with(end) {
                files.push(entry);
            }
        }
    }
    files.sort();
    files.iter().map(|file| fs::read_to_string(file).unwrap()).collect()
}

fn sample(folder: &Path, args: &[&str]) -> Ended {
    let all = ["sample", "room.scene", "--seed", "7"];
    let ended = scenelang(folder, all.iter().chain(args));
    assert_eq!(ended.code, 0, "{ended:?}");
    ended
}

/// What one run writes, and that two threads and so many parts write the same.
fn same_bytes(text: &str, parts: &[usize]) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), text).unwrap();
    sample(folder.path(), &["-n", "20", "--jobs", "1", "-o", "one"]);
    let one = joined(&folder.path().join("one"), ".jsonl");
    assert_eq!(one.lines().count(), 20);
    sample(folder.path(), &["-n", "20", "--jobs", "2", "-o", "two"]);
    assert_eq!(joined(&folder.path().join("two"), ".jsonl"), one);
    for of in parts {
        let split = format!("split{of}");
        for index in 0..*of {
            sample(folder.path(), &["-n", "20", "--shard", &format!("{index}/{of}"), "-o", &split]);
        }
        assert_eq!(joined(&folder.path().join(&split), ".jsonl"), one, "{of}");
    }
}

#[test]
fn samples_are_the_same_however_they_are_split() {
    same_bytes(ROOM, &[3, 16]);
}

#[test]
fn so_are_samples_that_all_have_the_same_sizes() {
    same_bytes(&fixed(), &[3]);
}

#[test]
fn a_sample_is_a_layout_that_holds() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), ROOM).unwrap();
    let ended = sample(folder.path(), &["-n", "3", "-o", "out", "--export", "glb", "--format", "json"]);
    let report: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((&report["stored"], &report["asked"]), (&3.into(), &3.into()), "{report}");
    for (i, line) in joined(&folder.path().join("out"), ".jsonl").lines().enumerate() {
        let file = folder.path().join(format!("out/s{i}.layout.json"));
        fs::write(&file, line).unwrap();
        let ended = scenelang(folder.path(), ["check", file.to_str().unwrap(), "room.scene"]);
        assert_eq!(ended.code, 0, "{ended:?}");
        assert!(folder.path().join(format!("out/sample-{i:09}/sample-{i:09}.glb")).is_file());
    }
}

#[test]
fn more_samples_and_more_formats_of_a_run_are_added() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("room.scene"), ROOM).unwrap();
    sample(folder, &["-n", "12", "-o", "whole"]);
    sample(folder, &["-n", "5", "-o", "grown"]);
    let grown = sample(folder, &["-n", "12", "-o", "grown"]);
    assert!(grown.stdout.starts_with("5 samples were drawn before"), "{grown:?}");
    assert_eq!(results(&folder.join("grown")), results(&folder.join("whole")));
    let again = sample(folder, &["-n", "12", "-o", "grown", "--export", "glb"]);
    assert!(again.stdout.starts_with("12 samples were drawn before"), "{again:?}");
    sample(folder, &["-n", "12", "-o", "exported", "--export", "glb"]);
    assert_eq!(results(&folder.join("grown")), results(&folder.join("exported")));
    for i in 0..12 {
        let file = format!("sample-{i:09}/sample-{i:09}.glb");
        let [grown, exported] = ["grown", "exported"].map(|out| fs::read(folder.join(out).join(&file)).unwrap());
        assert!(grown == exported, "{file}");
    }
}

#[test]
fn samples_of_different_runs_are_not_mixed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("room.scene"), ROOM).unwrap();
    sample(folder, &["-n", "4", "-o", "out", "--export", "glb"]);
    let run = |args: &[&str]| scenelang(folder, ["sample", "room.scene", "-o", "out"].iter().chain(args));
    let before = results(&folder.join("out"));
    for (args, why) in [
        (&["-n", "4", "--seed", "8"][..], "drawn with --seed 7 instead of 8"),
        (&["-n", "4", "--seed", "7", "--eta", "0.1"], "drawn with other options"),
        (&["-n", "3", "--seed", "7"], "with higher numbers"),
        (&["-n", "4", "--seed", "7", "--shard", "0/2"], "split in another way"),
    ] {
        let ended = run(args);
        assert!(
            ended.code == 2 && ended.stderr.contains(why) && ended.stderr.contains("--force"),
            "{args:?} {ended:?}"
        );
        assert_eq!(results(&folder.join("out")), before);
    }
    assert_eq!(run(&["-n", "2", "--seed", "8", "--force"]).code, 0);
    let fresh = scenelang(folder, ["sample", "room.scene", "-n", "2", "--seed", "8", "-o", "fresh"]);
    assert_eq!(fresh.code, 0, "{fresh:?}");
    assert_eq!(results(&folder.join("out")), results(&folder.join("fresh")));
    assert!(!folder.join("out/sample-000000003").exists(), "exports of the other run are gone");
    fs::write(folder.join("room.scene"), ROOM.replace("crate", "case")).unwrap();
    let ended = run(&["-n", "2", "--seed", "8"]);
    assert!(ended.code == 2 && ended.stderr.contains("of another version of the program"), "{ended:?}");
}

#[cfg(unix)]
#[test]
fn samples_continue_after_an_end_at_any_moment() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("room.scene"), ROOM).unwrap();
    sample(folder, &["-n", "60", "-o", "whole"]);
    let journal = folder.join("killed/.scenelang-samples-000000000.journal");
    let mut length = 0;
    for moment in [40, 70, 100] {
        let mut command = binary();
        command.args(["sample", "room.scene", "--seed", "7", "-n", "60", "-o", "killed"]).current_dir(folder);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        sleep(Duration::from_millis(moment));
        child.kill().unwrap();
        child.wait().unwrap();
        // As if the power had failed in the middle of an entry.
        if let Ok(text) = fs::read(&journal) {
            assert!(text.len() >= length, "nothing is drawn again");
            fs::write(&journal, &text[..text.len() - text.len().min(9)]).unwrap();
            length = text.len().saturating_sub(9);
        }
    }
    sample(folder, &["-n", "60", "-o", "killed"]);
    assert!(!journal.exists());
    assert_eq!(results(&folder.join("killed")), results(&folder.join("whole")));
}

/// A run may end after its record is written and before its journal is removed.
#[test]
fn a_journal_beside_its_record_is_removed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("room.scene"), ROOM).unwrap();
    sample(folder, &["-n", "4", "-o", "out"]);
    let before = results(&folder.join("out"));
    let journal = folder.join("out/.scenelang-samples-000000000.journal");
    fs::write(&journal, "{\"format\": \"cut off").unwrap();
    let again = sample(folder, &["-n", "4", "-o", "out"]);
    assert!(again.stdout.starts_with("4 samples were drawn before"), "{again:?}");
    assert!(!journal.exists());
    assert_eq!(results(&folder.join("out")), before);
}

#[test]
fn a_contradiction_has_no_sample() {
    let folder = tempfile::tempdir().unwrap();
    let text = fixed() + "assert box.pos.x >= 1;\nassert crate.pos.z <= 0.5;\nassert box.pos.x <= 0.5;\n";
    fs::write(folder.path().join("room.scene"), text).unwrap();
    let ended = scenelang(folder.path(), ["sample", "room.scene", "-n", "5", "-o", "out"]);
    assert_eq!(ended.code, 1, "{ended:?}");
    assert!(ended.stdout.contains("no sample was written") && ended.stdout.contains("box.pos.x <= 0.5"), "{ended:?}");
    assert!(!ended.stdout.contains("assert crate.pos.z"), "the set is the smallest: {ended:?}");
    assert!(!folder.path().join("out").exists());
}

/// A manifest with good lines and bad ones.
fn manifest(folder: &Path) -> usize {
    let program = |text: &str| serde_json::to_string(text).unwrap();
    let good = |i: usize| format!("{{\"name\": \"room-{i}\", \"seed\": {i}, \"source\": {}}}", program(ROOM));
    let contradiction = fixed() + "assert box.pos.x >= 1 and box.pos.x <= 0;";
    let lines = [
        good(0),
        "{\"name\": \"broken\", \"source\": \"object\"}".to_owned(),
        good(1),
        format!("{{\"name\": \"never\", \"source\": {}}}", program(&contradiction)),
        "{\"name\": \"../outside\", \"source\": \"object a;\"}".to_owned(),
        format!("{{\"source\": \"{}\"}}", "x".repeat(10 << 20)),
        good(2),
        "{\"program\": \"room.scene\", \"name\": \"file\"}".to_owned(),
        "not JSON".to_owned(),
        good(3),
    ];
    fs::write(folder.join("room.scene"), ROOM).unwrap();
    fs::write(folder.join("jobs.jsonl"), lines.join("\n")).unwrap();
    lines.len()
}

/// What a folder of results has, without what says how it was split.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let named = files.map(|file| (file.file_name().into_string().unwrap(), file.path()));
    let kept = named.filter(|(name, path)| !name.starts_with("summary-") && !name.starts_with('.') && path.is_file());
    kept.map(|(name, path)| (name, fs::read(path).unwrap())).collect()
}

fn batch(folder: &Path, args: &[&str]) -> Ended {
    scenelang(folder, ["batch", "jobs.jsonl", "--jobs", "2"].iter().chain(args))
}

#[test]
fn bad_lines_stop_nothing_and_shards_make_what_one_run_makes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let lines = manifest(folder);
    let ended = batch(folder, &["-o", "one", "--format", "json"]);
    assert_eq!(ended.code, 1, "{ended:?}");
    let summary: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((&summary["lines"], &summary["good"]), (&lines.into(), &5.into()), "{summary:#}");
    let kinds: Vec<&str> =
        summary["results"].as_array().unwrap().iter().map(|r| r["error"]["kind"].as_str().unwrap_or("")).collect();
    assert_eq!(kinds, ["", "input", "", "contradiction", "line", "line", "", "", "line", ""], "{summary:#}");
    assert!(summary["results"][5]["error"]["message"].as_str().unwrap().contains("10.0 MiB"), "{summary:#}");
    for name in ["room-0", "file"] {
        let checked = scenelang(folder, ["check", &format!("one/{name}.layout.json"), "room.scene"]);
        assert_eq!(checked.code, 0, "{checked:?}");
    }
    // The same command has nothing more to do, and says the same.
    let before = results(&folder.join("one"));
    let again = batch(folder, &["-o", "one"]);
    assert!(again.code == 1 && again.stdout.contains(&format!("{lines} lines were done before")), "{again:?}");
    for index in 0..3 {
        batch(folder, &["-o", "three", "--shard", &format!("{index}/3")]);
    }
    assert_eq!(results(&folder.join("three")), before);
    for out in ["one", "three"] {
        let ended = scenelang(folder, ["batch", "merge", out]);
        assert!(ended.code == 1 && ended.stdout.contains("5 of 10 lines have a scene"), "{ended:?}");
    }
    assert_eq!(results(&folder.join("three")), results(&folder.join("one")));
    let list = fs::read_to_string(folder.join("one/results.jsonl")).unwrap();
    assert_eq!(list.lines().count(), lines);
    fs::remove_file(folder.join("three/summary-00001-of-00003.json")).unwrap();
    let ended = scenelang(folder, ["batch", "merge", "three"]);
    assert!(ended.code == 2 && ended.stderr.contains("summary-00001-of-00003.json"), "{ended:?}");
}

#[test]
fn a_line_has_its_time_and_a_failed_one_is_tried_again_on_demand() {
    let folder = tempfile::tempdir().unwrap();
    let hopeless =
        fixed() + "object more[60]; more.dimensions <- vec3(0.5, 0.5, 0.5); assert forall m in more: onFloor(m, room);";
    let line =
        format!("{{\"name\": \"long\", \"effort\": 1000, \"source\": {}}}", serde_json::to_string(&hopeless).unwrap());
    fs::write(folder.path().join("jobs.jsonl"), line + "\n{\"name\": \"short\", \"source\": \"object a;\"}").unwrap();
    // The second line has all the time that it needs, however busy the machine is.
    assert_eq!(batch(folder.path(), &["-o", "out", "--shard", "1/2"]).code, 0);
    let ended = batch(folder.path(), &["-o", "out", "--time", "0.5"]);
    assert_eq!(ended.code, 1, "{ended:?}");
    assert!(ended.stdout.contains("line 1 (long)") && ended.stdout.contains("0.5 s"), "{ended:?}");
    assert!(ended.stdout.contains("1 of 2 lines have a scene"), "{ended:?}");
    let again = batch(folder.path(), &["-o", "out", "--time", "0.5", "--retry"]);
    assert!(again.stdout.contains("1 lines were done before"), "{again:?}");
}

#[cfg(unix)]
#[test]
fn an_end_at_any_moment_loses_and_repeats_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    manifest(folder);
    batch(folder, &["-o", "whole"]);
    // When each result was written: none is written again.
    let written = || -> BTreeMap<String, std::time::SystemTime> {
        let Ok(files) = fs::read_dir(folder.join("killed")) else { return BTreeMap::new() };
        let files =
            files.map(|file| file.unwrap()).filter(|f| f.file_name().to_string_lossy().ends_with(".result.json"));
        files.map(|f| (f.file_name().into_string().unwrap(), f.metadata().unwrap().modified().unwrap())).collect()
    };
    let mut before = BTreeMap::new();
    let unchanged =
        |before: &BTreeMap<_, _>, now: &BTreeMap<String, _>| before.iter().all(|(n, at)| now.get(n) == Some(at));
    for moment in [20, 90, 160, 60, 240] {
        let mut command = binary();
        command.args(["batch", "jobs.jsonl", "--jobs", "2", "-o", "killed"]).current_dir(folder);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        sleep(Duration::from_millis(moment));
        child.kill().unwrap();
        child.wait().unwrap();
        let now = written();
        assert!(unchanged(&before, &now), "{before:?} {now:?}");
        before = now;
    }
    // What was not finished when the command was killed, the next one does.
    let ended = batch(folder, &["-o", "killed"]);
    assert_eq!(ended.code, 1, "{ended:?}");
    let now = written();
    assert!(unchanged(&before, &now), "{before:?} {now:?}");
    let whole = results(&folder.join("whole"));
    let killed = results(&folder.join("killed"));
    assert_eq!(killed.keys().collect::<Vec<_>>(), whole.keys().collect::<Vec<_>>());
    assert!(killed == whole, "the bytes differ");
}

#[cfg(unix)]
#[test]
fn the_script_for_slurm_splits_the_work_by_the_variables_of_its_tasks() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    manifest(folder);
    for task in 10..14 {
        let ended = Command::new("bash")
            .arg(root().join("integrations/slurm/scenelang.sbatch"))
            .args(["jobs.jsonl", "out"])
            .current_dir(folder)
            .env("SCENELANG", env!("CARGO_BIN_EXE_scenelang"))
            .env("SLURM_ARRAY_TASK_ID", task.to_string())
            .env("SLURM_ARRAY_TASK_MIN", "10")
            .env("SLURM_ARRAY_TASK_COUNT", "4")
            .env("SLURM_CPUS_PER_TASK", "1")
            .output()
            .unwrap();
        assert!(ended.status.code().is_some_and(|code| code <= 1), "{ended:?}");
    }
    let merged = scenelang(folder, ["batch", "merge", "out"]);
    assert!(merged.code == 1 && merged.stdout.contains("5 of 10 lines have a scene"), "{merged:?}");
    batch(folder, &["-o", "one"]);
    scenelang(folder, ["batch", "merge", "one"]);
    assert_eq!(results(&folder.join("out")), results(&folder.join("one")));
}

#[test]
fn the_driver_for_ray_makes_what_one_run_makes() {
    let python = std::env::var("SCENELANG_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has = Command::new(&python).args(["-c", "import ray"]).output();
    if !has.is_ok_and(|ended| ended.status.success()) {
        // It is too large for a package that only this test needs, so it may lack in CI, too.
        println!("skipped: the package ray for Python is not there");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    manifest(folder);
    let ended = Command::new(&python)
        .arg(root().join("integrations/ray/scenelang_ray.py"))
        .args(["jobs.jsonl", "-o", "out", "--shards", "3", "--binary", env!("CARGO_BIN_EXE_scenelang")])
        .current_dir(folder)
        .output()
        .unwrap();
    assert_eq!(ended.status.code(), Some(1), "{ended:?}");
    batch(folder, &["-o", "one"]);
    scenelang(folder, ["batch", "merge", "one"]);
    assert_eq!(results(&folder.join("out")), results(&folder.join("one")));
}

/// The manifest in the book.
#[test]
fn the_lines_of_the_book_are_jobs() {
    let page = fs::read_to_string(root().join("spec/src/many-scenes.md")).unwrap();
    let block = page.split("```json jobs\n").nth(1).unwrap().split("```").next().unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("labs")).unwrap();
    fs::write(folder.path().join("labs/lab.scene"), ROOM).unwrap();
    fs::write(folder.path().join("jobs.jsonl"), block).unwrap();
    let ended = batch(folder.path(), &["-o", "out"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    for file in ["study-1.scene", "lab-1.layout.json", "line-000000003.result.json"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}");
    }
}
