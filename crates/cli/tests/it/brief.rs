//! A request through its brief, and the account of its words: by the binary.

use crate::support::{Ended, fits, run};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

fn formalize(folder: &Path, args: &[&str]) -> Ended {
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenelang"));
    command.arg("formalize").args(args).current_dir(folder).env_clear();
    run(&mut command, b"")
}

const REQUEST: &str = "A study, 5 by 4 m, for three people, with two desks, a lamp on each desk, a white sofa against the \
                       north wall and no television. The first desk is at most 2 m from the sofa.";

#[test]
fn a_brief_is_printed_checked_and_gone_on_from() {
    let folder = tempfile::tempdir().unwrap();
    let printed = formalize(folder.path(), &["--brief", REQUEST]);
    assert_eq!(printed.code, 0, "{printed:?}");
    let brief = fits("brief", &printed.stdout);
    assert_eq!(brief["rooms"][0]["people"], 3);
    assert_eq!(brief["things"][1]["number"]["each"]["of"], "desk");
    fs::write(folder.path().join("brief.json"), &printed.stdout).unwrap();
    for literal in [&["--literal"][..], &[]] {
        let direct = formalize(folder.path(), &[&["--untried", REQUEST], literal].concat());
        let through = formalize(folder.path(), &[&["--untried", "--from-brief", "brief.json"], literal].concat());
        assert_eq!((through.code, &through.stdout), (0, &direct.stdout));
        assert_eq!(through.stderr, direct.stderr);
    }
    fs::write(folder.path().join("bad.json"), printed.stdout.replacen("\"kind\"", "\"sort\"", 1)).unwrap();
    let bad = formalize(folder.path(), &["--from-brief", "bad.json"]);
    assert_eq!(bad.code, 2, "{bad:?}");
    assert!(bad.stderr.contains("unknown field `sort`") && bad.stderr.contains("line 7"), "{bad:?}");
    let asked = formalize(folder.path(), &["--brief", REQUEST, "--model", "ollama/x"]);
    assert!(asked.code == 2 && asked.stderr.contains("--model"), "{asked:?}");
}

#[test]
fn the_summary_counts_words_and_strict_demands_all_of_them() {
    let folder = tempfile::tempdir().unwrap();
    let all = "A study with a desk and two lamps.";
    let some = "A study with a desk. It was built in 1987.";
    for (request, strict, plain) in [(all, 0, 0), (some, 1, 0), ("zzz qqq xxx", 1, 1)] {
        assert_eq!(formalize(folder.path(), &["--untried", request]).code, plain, "{request}");
        assert_eq!(formalize(folder.path(), &["--untried", "--strict", request]).code, strict, "{request}");
    }
    let ended = formalize(folder.path(), &["--untried", some]);
    let unused = ended.stderr.split("words became part of the program; not used: ").nth(1);
    assert!(unused.and_then(|words| words.lines().next()).is_some_and(|w| w.contains("\"1987\"")), "{}", ended.stderr);
    let ended = formalize(folder.path(), &["--untried", "--format", "json", some]);
    let said: Value = serde_json::from_str(&ended.stdout).unwrap();
    let unused = said["words"]["unused"].as_array().unwrap();
    assert!(unused.iter().any(|word| word["text"] == "1987"), "{said}");
    assert!(said["words"]["used"].as_u64() < said["words"]["all"].as_u64(), "{said}");
    assert_eq!(said["preferences"], 0);
}

#[test]
fn what_cannot_hold_is_counted_as_a_preference() {
    let folder = tempfile::tempdir().unwrap();
    let request = "A study with a desk and a sofa. The desk is at most 1 m from the sofa. The desk is at least 3 m from the sofa.";
    let ended = formalize(folder.path(), &["--untried", "--strict", request]);
    assert_eq!(ended.code, 1, "{ended:?}");
    assert!(ended.stderr.contains("1 statement from the request became a preference"), "{ended:?}");
}
