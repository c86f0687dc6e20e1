//! Editors of others, without a screen, set up as docs/editors.md says and with the binary as their server: what is marked,
//! what a hover says, what the light bulb offers, a repair, a new name. An editor that is not there is skipped.
#![cfg(unix)]

use crate::support::{read_json, root, run, skip};
use scenelang_export::preview::has_viewer;
use serde_json::Value;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// The first block of a language in a section of docs/editors.md.
fn block(section: &str, language: &str) -> String {
    let text = fs::read_to_string(root().join("docs/editors.md")).unwrap();
    let (_, rest) = text.split_once(&format!("\n## {section}\n")).unwrap_or_else(|| panic!("no section {section}"));
    let section = rest.split("\n## ").next().unwrap();
    let (_, rest) = section.split_once(&format!("\n```{language}\n")).unwrap_or_else(|| panic!("no {language}"));
    rest.split_once("```").unwrap().0.to_owned()
}

/// A home of its own, with a folder `ws` that has a room in it in which some things do not hold.
fn home() -> TempDir {
    let home = tempfile::tempdir().unwrap();
    let ws = home.path().join("ws");
    fs::create_dir(&ws).unwrap();
    for file in ["room.scene", "room.layout.json", "parts.scene"] {
        fs::copy(root().join("crates/lsp/tests/it/room").join(file), ws.join(file)).unwrap();
    }
    // No browser is opened.
    fs::create_dir(home.path().join("bin")).unwrap();
    for opener in ["xdg-open", "osascript"] {
        let file = home.path().join("bin").join(opener);
        fs::write(&file, "#!/bin/sh\n").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).unwrap();
    }
    home
}

/// An editor that finds our binary, and nothing of whoever runs the test.
fn editor(program: &str, home: &Path) -> Command {
    let ours = Path::new(env!("CARGO_BIN_EXE_scenelang")).parent().unwrap().to_path_buf();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let before = [home.join("bin"), ours];
    let path = std::env::join_paths(before.into_iter().chain(std::env::split_paths(&path))).unwrap();
    let mut command = Command::new(program);
    command.current_dir(home.join("ws")).env("PATH", path).env("HOME", home).env("SEEN", home.join("seen.json"));
    for (variable, folder) in [("CONFIG", "config"), ("DATA", "data"), ("STATE", "state"), ("CACHE", "cache")] {
        command.env(format!("XDG_{variable}_HOME"), home.join(folder));
    }
    command
}

/// Whether an editor is there; else the test is skipped.
fn is_there(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok_and(|o| o.status.success());
    if !there {
        skip(&format!("`{program}` is not installed"));
    }
    there
}

/// What was to be seen in an editor that did what a user does, and what became of the files.
fn is_as_it_should_be(home: &Path, told: &str) {
    assert!(home.join("seen.json").exists(), "{told}");
    let seen = read_json(&home.join("seen.json"));
    assert_eq!(seen["trouble"], Value::Null, "{seen:#}");
    let has = |list: &str, line: u32, text: &str, words: [&str; 2]| {
        let marks = seen[list].as_array().unwrap();
        let fits = |m: &&Value| {
            let told = format!("{} {}", m["code"], m["message"]);
            m["line"] == line && m["text"].as_str().unwrap().starts_with(text) && words.iter().all(|w| told.contains(w))
        };
        marks.iter().any(|m| fits(&m))
    };
    let gap = ("assert gap(stand[1], bed) >= space", ["V0101", "must be at least `space`"]);
    let bed = ("bed", ["V0102", "overlaps `stand[1]`"]);
    assert!(has("marked", 34, gap.0, gap.1) && has("marked", 12, bed.0, bed.1), "{seen:#}");
    assert!(!has("repaired", 34, gap.0, gap.1) && !has("repaired", 12, bed.0, bed.1), "{seen:#}");
    assert!(has("repaired", 35, "prefer bed.pos.x > 1", ["V0106", "must be more than 1"]), "{seen:#}");
    let hover = seen["hover"].as_str().unwrap();
    assert!(hover.contains("Where one sleeps") && hover.contains("1.60 × 0.55 × 2.00 m"), "{hover}");
    let menu: Vec<&str> = seen["menu"].as_array().unwrap().iter().map(|title| title.as_str().unwrap()).collect();
    assert!(
        menu.contains(&"Repair this constraint") && menu.iter().any(|t| t.starts_with("Move `stand[1]`")),
        "{menu:?}"
    );

    // It is repaired, and nobody calls the bed a bed any more.
    let layout = read_json(&home.join("ws/room.layout.json"));
    let objects = layout["objects"].as_object().unwrap();
    assert!(
        objects.contains_key("couch") && !objects.contains_key("bed") && layout["objects"]["lamp"]["note"] == "mine"
    );
    let scene = fs::read_to_string(home.join("ws/room.scene")).unwrap();
    assert!(scene.contains("object couch;") && scene.contains("assert low(couch, 1);"), "{scene}");
    let ended = crate::support::scenelang(&home.join("ws"), ["check", "room.layout.json"]);
    assert_eq!(ended.code, 0, "{}", ended.stdout);
}

#[test]
fn neovim() {
    if !is_there("nvim") {
        return;
    }
    let home = home();
    // With the block that lets a browser follow the cursor.
    let follows = block("The room beside the text", "vim");
    fs::write(home.path().join("init.lua"), format!("{}vim.cmd([[{follows}]])\n", block("Neovim", "lua"))).unwrap();
    let driver = root().join("crates/cli/tests/it/editors/neovim.lua");
    let mut command = editor("nvim", home.path());
    if has_viewer() {
        command.env("VIEWER", "1");
    }
    command.args(["--headless", "-u", "../init.lua", "-i", "NONE", "-n", "room.scene", "-S"]).arg(driver);
    let ended = run(&mut command, b"");
    is_as_it_should_be(home.path(), &ended.stderr);
    let seen = read_json(&home.path().join("seen.json"));
    assert!(seen["followed"].as_u64().is_some_and(|places| places > 1), "{seen:#}");
    let shown = &seen["shown"];
    let is_shown = shown.as_str().is_some_and(|said| said.contains("the room is shown at http://127.0.0.1:"));
    assert_eq!(is_shown, has_viewer(), "{shown}");
}

#[test]
fn emacs() {
    if !is_there("emacs") {
        return;
    }
    let home = home();
    let driver = root().join("crates/cli/tests/it/editors/emacs.el");
    let has_eglot = "(progn (require 'package) (package-initialize) (kill-emacs (if (require 'eglot nil t) 0 1)))";
    if !editor("emacs", home.path()).args(["--batch", "-q", "--eval", has_eglot]).output().unwrap().status.success() {
        return skip("Emacs has no Eglot");
    }
    fs::write(home.path().join("block.el"), block("Emacs", "elisp")).unwrap();
    let mut command = editor("emacs", home.path());
    command.env("BLOCK", home.path().join("block.el")).args(["--batch", "-q", "-l"]).arg(driver);
    let ended = run(&mut command, b"");
    is_as_it_should_be(home.path(), &ended.stderr);
}

/// Helix has no scripts; but it says what it makes of its settings.
#[test]
fn helix() {
    if !Command::new("hx").arg("--version").output().is_ok_and(|o| o.status.success()) {
        // Not every distribution has it, so nothing insists on it.
        return eprintln!("skipped: `hx` is not installed");
    }
    let home = home();
    let folder = home.path().join("config/helix");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("languages.toml"), block("Helix", "toml")).unwrap();
    let ended = run(editor("hx", home.path()).args(["--health", "scene"]), b"");
    let binary = fs::canonicalize(env!("CARGO_BIN_EXE_scenelang")).unwrap();
    let found = ended.stdout.lines().find(|line| line.contains("scenelang")).unwrap_or_default();
    assert!(found.contains('✓') && found.contains(&binary.display().to_string()), "{}{}", ended.stdout, ended.stderr);
}
