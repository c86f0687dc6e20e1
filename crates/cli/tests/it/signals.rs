//! Ctrl-C, SIGTERM and `kill -9` at pseudo-random points of every command that writes: each file is the old one or the new
//! one, after Ctrl-C no temporary file is left, and the command can be run again.
//!
//! `SCENELANG_KILLS=200 cargo test -p scenelang-cli signals` tries more points.
#![cfg(unix)]

use crate::support::binary;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// So many points of each command and signal.
const POINTS: u64 = 8;
/// What the shell sees of an end by Ctrl-C.
const INTERRUPTED: i32 = 130;
/// Nothing here takes so long.
const PATIENCE: Duration = Duration::from_secs(120);

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(6, 2.6, 6);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\nassert inside(bed, room);\n\
    object desk;\ndesk.category <- \"desk\";\nassert inside(desk, room);\nassert far(bed, desk, 1);\n";
const REQUEST: &str = "a bedroom with a bed and a desk by the window";
const TRUTH: &str = r#"{ "id": "one", "rooms": [], "objects": [], "relations": [], "numeric": [] }"#;
const BROKEN: &str = r#"{ "format": "scenelang.layout/1", "scene": "broken.scene",
    "objects": { "box": { "pos": [0, 0, 0], "scale": [1, 1, 1] } } }"#;

fn points() -> u64 {
    std::env::var("SCENELANG_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(POINTS)
}

/// A repeatable number (splitmix64).
fn dice(n: u64) -> u64 {
    let z = n.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

type Files = BTreeMap<PathBuf, Vec<u8>>;

/// All files below a folder, with their bytes.
fn files(folder: &Path) -> Files {
    let mut out = Files::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let bytes = fs::read(&path).unwrap();
                out.insert(path, bytes);
            }
        }
    }
    out
}

/// Files that nobody but scenelang reads.
fn is_hidden(path: &Path) -> bool {
    path.file_name().unwrap().to_string_lossy().starts_with(".scenelang-")
}

fn is_part(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "part")
}

fn restore(folder: &Path, wanted: &Files) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { fs::remove_dir_all(path).unwrap() } else { fs::remove_file(path).unwrap() }
    }
    for (path, bytes) in wanted {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
}

fn start(folder: &Path, args: &[&str]) -> Child {
    let mut command = binary();
    command.args(args).current_dir(folder).env("NO_COLOR", "1").stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn ended(child: &mut Child) -> Option<i32> {
    let since = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code();
        }
        if since.elapsed() > PATIENCE {
            child.kill().unwrap();
            panic!("it goes on");
        }
        sleep(Duration::from_millis(2));
    }
}

fn whole(folder: &Path, args: &[&str]) -> Files {
    let code = ended(&mut start(folder, args));
    assert!(matches!(code, Some(0 | 1)), "{args:?}: {code:?}");
    files(folder)
}

/// Runs a command that makes the old files, then another that makes the new ones, which is ended at every point.
fn survives(old: &[&str], new: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("room.scene"), ROOM).unwrap();
    fs::write(at("broken.scene"), "object box; assert box.pos.x >= 1;").unwrap();
    fs::write(at("broken.layout.json"), BROKEN).unwrap();
    fs::write(at("fmt.scene"), "object   a;assert a.pos.x>1;").unwrap();
    fs::write(at("fix.scene"), "object a;;\nassert a.pos.x > 1;\n").unwrap();
    fs::create_dir(at("requests")).unwrap();
    fs::write(at("requests/one.txt"), "A room with a bed.").unwrap();
    fs::write(at("requests/one.expect.json"), TRUTH).unwrap();
    whole(folder.path(), &["solve", "room.scene"]);
    let before = if old.is_empty() { files(folder.path()) } else { whole(folder.path(), old) };
    let since = Instant::now();
    let after = whole(folder.path(), new);
    let took = u64::try_from(since.elapsed().as_micros()).unwrap();
    assert_ne!(before, after, "{new:?} writes something");
    for point in 0..points() {
        for signal in ["-INT", "-TERM", "-KILL"] {
            if signal == "-TERM" && point % 4 != 0 {
                continue;
            }
            restore(folder.path(), &before);
            let mut child = start(folder.path(), new);
            sleep(Duration::from_micros(dice(point) % (took * 5 / 4 + 1)));
            let pressed = Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
            pressed.unwrap();
            let code = ended(&mut child);
            let what = format!("{new:?} {signal} at point {point}, which ended with {code:?}");
            // Before it listens, the signal itself ends it; after its work, nobody hears it.
            assert!(matches!(code, Some(INTERRUPTED | 0 | 1) | None), "{what}");
            for (path, bytes) in files(folder.path()) {
                assert!(signal == "-KILL" || !is_part(&path), "{} is left: {what}", path.display());
                let is = |files: &Files| files.get(&path) == Some(&bytes);
                // A layout may be as far as it was found.
                let best = || String::from_utf8_lossy(&bytes).contains("\"incomplete\": true");
                let report = path.ends_with("report.json") && signal != "-KILL";
                assert!(
                    is_hidden(&path) || is(&before) || is(&after) || best() || report,
                    "{} is neither old nor new: {what}",
                    path.display()
                );
            }
            for path in before.keys().filter(|path| !is_hidden(path)) {
                assert!(path.exists(), "{} is gone: {what}", path.display());
            }
        }
    }
    // Whatever was left, the next run does its work; but `new` leaves alone what is there.
    if new[0] == "new" {
        restore(folder.path(), &before);
    }
    let visible = |files: Files| files.into_iter().filter(|(path, _)| !is_hidden(path)).collect::<Files>();
    assert_eq!(visible(whole(folder.path(), new)), visible(after));
}

#[test]
fn solve() {
    survives(&["solve", "room.scene", "--seed", "1"], &["solve", "room.scene", "--seed", "2"]);
}

#[test]
fn several_layouts() {
    let args = |seed| ["solve", "room.scene", "--alternatives", "2", "-o", "some.layout.json", "--seed", seed];
    survives(&args("1"), &args("2"));
}

#[test]
fn repair() {
    survives(&[], &["repair", "broken.layout.json"]);
}

#[test]
fn formalize() {
    survives(&["formalize", "a room with a bed", "-o", "asked.scene"], &["formalize", REQUEST, "-o", "asked.scene"]);
}

#[test]
fn synth() {
    survives(&["synth", "room.scene", "-o", "out"], &["synth", "room.scene", "-o", "out", "--seed", "2"]);
}

#[test]
fn synth_of_a_request() {
    // What it writes is the same without furniture that nobody asked for, and each of the many runs is shorter.
    survives(&[], &["synth", REQUEST, "--literal", "-o", "asked"]);
}

#[test]
fn export() {
    survives(&[], &["export", "room.layout.json", "-o", "out"]);
}

#[test]
fn import() {
    survives(
        &["export", "room.layout.json", "--only", "glb", "-o", "made"],
        &["import", "made/room.glb", "-o", "back"],
    );
}

#[test]
fn fmt() {
    survives(&[], &["fmt", "fmt.scene"]);
}

#[test]
fn fix() {
    survives(&[], &["check", "--fix", "fix.scene"]);
}

#[test]
fn new() {
    survives(&[], &["new", "new.scene"]);
}

/// What ends `batch` has processes of its own to end, which is tried in `many`.
#[test]
fn sample() {
    survives(&[], &["sample", "room.scene", "-n", "20", "-o", "samples"]);
}

#[test]
fn eval() {
    survives(&[], &["eval", "requests", "requests", "-o", "programs"]);
}

#[test]
fn bench() {
    survives(&[], &["bench", "solve", "room.scene", "--seeds", "3", "--layouts", "layouts"]);
}
