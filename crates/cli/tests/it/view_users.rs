//! `scenelang view` and other users of the machine, who know the address and the secret in it. For an administrator only:
//! nobody else can be two users.
#![cfg(target_os = "linux")]

use crate::support::example;
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::{MetadataExt, chown};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};

/// Who shows a room, and who is curious; both are nobody in particular.
const OWN: u32 = 65534;
const OTHER: u32 = 65533;

fn as_user(user: u32, program: &Path, folder: &Path) -> Command {
    let mut command = Command::new(program);
    command.uid(user).gid(user).current_dir(folder).env_clear().env("PATH", "/usr/bin:/bin").env("HOME", folder);
    command
}

/// The status that a user gets; 0: the connection is closed without an answer. `None`: there is no curl.
fn status(user: u32, address: &str) -> Option<u16> {
    let mut command = as_user(user, Path::new("/usr/bin/curl"), Path::new("/"));
    let said = command.args(["-s", "-m", "60", "-o", "/dev/null", "-w", "%{http_code}", address]).output().ok()?;
    String::from_utf8(said.stdout).unwrap().trim().parse().ok()
}

#[test]
fn another_user_gets_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let administrator = fs::metadata("/proc/self").unwrap().uid() == 0;
    if !administrator || chown(folder.path(), Some(OWN), Some(OWN)).is_err() || !Path::new("/usr/bin/curl").exists() {
        eprintln!("skipped: only an administrator with curl can be two users");
        return;
    }
    // Where it was built others may not look.
    fs::copy(env!("CARGO_BIN_EXE_scenelang"), at("scenelang")).unwrap();
    fs::copy(example("bedroom"), at("room.scene")).unwrap();
    chown(at("room.scene"), Some(OWN), Some(OWN)).unwrap();
    let run = |args: &[&str]| {
        let mut command = as_user(OWN, &at("scenelang"), folder.path());
        command.args(args).stdin(Stdio::null()).stderr(Stdio::null());
        command
    };
    assert!(run(&["solve", "room.scene"]).stdout(Stdio::null()).status().unwrap().success());
    let mut view = run(&["view", "room.scene", "--no-open"]).stdout(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    BufReader::new(view.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let address = line.trim();
    let without = address.split_once("?key=").unwrap().0;
    let found = [(OWN, address), (OWN, without), (OTHER, address), (OTHER, without), (0, address)]
        .map(|(user, address)| status(user, address));
    view.kill().unwrap();
    view.wait().unwrap();
    assert_eq!(found, [Some(303), Some(403), Some(0), Some(0), Some(0)]);
}
