//! Readers that are gone, and standard outputs that are full: no command panics, what it was to write is written, and its
//! exit code says what happened.
#![cfg(unix)]

use crate::support::{binary, example, folder_with};
use std::fs::{File, OpenOptions};
use std::io::{PipeWriter, Read, pipe};
use std::path::Path;
use std::process::Stdio;

/// What the shell sees of a program whose reader is gone.
const CLOSED: i32 = 141;

/// Commands in a folder with `bedroom.scene` and a layout of it, each with more to print than nothing.
const COMMANDS: [&[&str]; 34] = [
    &["check", "bedroom.scene"],
    &["formalize", "a bedroom with a bed and two lamps"],
    &["formalize", "a bedroom with a bed and two lamps", "--format", "json"],
    &["trace", "bedroom.scene"],
    &["categories"],
    &["assets", "search", "chair"],
    &["query", "bedroom.layout.json"],
    &["query", "bedroom.scene", "--object", "bed", "--format", "json"],
    &["check", "bedroom.layout.json", "--all"],
    &["check", "bedroom.layout.json", "--format", "json"],
    &["check", "bedroom.layout.json", "--format", "sarif"],
    &["check", "bedroom.layout.json", "--format", "junit"],
    &["check", ".", "--jobs", "2", "--all"],
    &["check", "--fix", "bedroom.scene"],
    &["solve", "bedroom.scene", "-o", "other.layout.json"],
    &["solve", "bedroom.scene", "-o", "other.layout.json", "--format", "json"],
    &["repair", "bedroom.layout.json", "--dry-run"],
    &["repair", "bedroom.layout.json", "--dry-run", "--format", "json"],
    &["export", "bedroom.layout.json", "-o", "out"],
    &["import", "out/bedroom.glb", "-o", "back"],
    &["sample", "box.scene", "-n", "1", "-o", "samples"],
    &["batch", "jobs.jsonl", "-o", "many"],
    &["fmt", "-"],
    &["explain", "V0101"],
    &["schema", "report"],
    &["completions", "bash"],
    &["man", "check"],
    &["syntax", "bedroom.scene"],
    &["syntax", "bedroom.scene", "--format", "json"],
    &["hir", "bedroom.scene"],
    &["hir", "bedroom.scene", "--format", "json"],
    &["constraints", "bedroom.scene"],
    &["constraints", "bedroom.scene", "--format", "json"],
    &["diff", "bedroom.layout.json", "bedroom.layout.json", "--format", "json"],
];

/// Runs a command whose standard output goes to `out`; its exit code and what it told besides.
fn run(folder: &Path, args: &[&str], out: impl Into<Stdio>) -> (Option<i32>, String) {
    let mut command = binary();
    command.args(args).current_dir(folder).env("NO_COLOR", "1");
    command.stdin(File::open(folder.join("bedroom.scene")).unwrap()).stdout(out).stderr(Stdio::piped());
    let output = command.spawn().unwrap().wait_with_output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// A pipe that nobody reads.
fn unread() -> PipeWriter {
    pipe().unwrap().1
}

fn room() -> tempfile::TempDir {
    let (folder, scene) = folder_with("bedroom");
    let (code, said) = run(folder.path(), &["solve", "bedroom.scene"], Stdio::null());
    assert_eq!(code, Some(0), "{said} {}", scene.display());
    std::fs::write(folder.path().join("box.scene"), "object a;").unwrap();
    std::fs::write(folder.path().join("jobs.jsonl"), "{\"source\": \"object a;\"}").unwrap();
    folder
}

#[test]
fn every_command_survives_its_reader() {
    let folder = room();
    for args in COMMANDS {
        let (code, said) = run(folder.path(), args, unread());
        assert!(!said.contains("panicked"), "{args:?}: {said}");
        assert_eq!(code, Some(CLOSED), "{args:?}: {said}");
    }
    let made = run(folder.path(), &["new", "mine.scene"], unread());
    assert!(made.0 == Some(CLOSED) && folder.path().join("mine.scene").exists(), "{made:?}");
}

/// Every command that prints is in the list above.
#[test]
fn the_list_is_complete() {
    let help = binary().arg("--help").output().unwrap();
    let help = String::from_utf8(help.stdout).unwrap();
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    for command in listed.filter_map(|line| line.split_whitespace().next()) {
        // The page, the editor and the assistant have streams of their own; a benchmark takes as long as it takes.
        let elsewhere = ["help", "view", "lsp", "mcp", "bench", "eval", "new", "synth"].contains(&command);
        assert!(elsewhere || COMMANDS.iter().any(|args| args[0] == command), "{command} is not tried");
    }
}

/// `synth` has files to write when the first line of its summary is all that is wanted.
#[test]
fn work_is_done_to_its_end() {
    let (folder, _) = folder_with("bedroom");
    let (code, said) = run(folder.path(), &["synth", "bedroom.scene", "-o", "out"], unread());
    assert_eq!(code, Some(CLOSED), "{said}");
    assert!(!said.contains("panicked"), "{said}");
    for file in ["bedroom.layout.json", "report.json", "preview.html"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}: {said}");
    }
}

/// A reader that goes after the first line, as `head -1` does.
#[test]
fn a_reader_may_go_in_the_middle() {
    let folder = room();
    for i in 0..40 {
        std::fs::copy(example("bedroom"), folder.path().join(format!("copy{i}.scene"))).unwrap();
    }
    let (mut reads, writes) = pipe().unwrap();
    let reader = std::thread::spawn(move || reads.read_exact(&mut [0; 100]).unwrap());
    let (code, said) = run(folder.path(), &["check", ".", "--format", "json"], writes);
    reader.join().unwrap();
    assert_eq!(code, Some(CLOSED), "{said}");
    assert!(!said.contains("panicked"), "{said}");
}

/// Standard error may be gone, too: `2>&1 | head -1`.
#[test]
fn both_streams_may_be_gone() {
    let (folder, _) = folder_with("bedroom");
    std::fs::write(folder.path().join("broken.scene"), "object a").unwrap();
    for args in
        [&["check", "missing.scene"][..], &["hir", "broken.scene"], &["solve", "broken.scene"], &["fmt", "missing"]]
    {
        let mut command = binary();
        command.args(args).current_dir(folder.path()).stdin(Stdio::null()).stdout(unread()).stderr(unread());
        let code = command.status().unwrap().code();
        assert!(matches!(code, Some(1 | 2 | CLOSED)), "{args:?}: {code:?}");
    }
}

/// A disk that is full is a failure that is told.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = room();
    for args in COMMANDS {
        let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
        let (code, said) = run(folder.path(), args, full);
        assert!(said.contains("cannot write to standard output") && !said.contains("panicked"), "{args:?}: {said}");
        assert_eq!(code, Some(2), "{args:?}: {said}");
    }
}
