//! `kill -9`, of the command line and of the language server: no file is half-written, and whoever comes next goes on as if
//! nothing had been.
#![cfg(unix)]

use crate::support::{binary, fits, folder_with, scenelang};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Nothing here takes so long.
const PATIENCE: Duration = Duration::from_secs(120);

/// All files below a folder with their bytes. A file that was being written under a name of its own is none of them: it is
/// hidden, and nobody reads it.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut out = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if !entry.file_name().to_string_lossy().starts_with(".scenelang-") {
                // It may be gone by now: it was given its own name.
                out.extend(fs::read(&path).ok().map(|bytes| (path, bytes)));
            }
        }
    }
    out
}

/// Small, and not the same from two seeds.
const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\nassert inside(bed, room);\n";

fn synth(folder: &Path, seed: &str) -> Child {
    let mut command = binary();
    command.args(["synth", "room.scene", "-o", "out", "--seed", seed]).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn kill(child: &mut Child) {
    child.kill().unwrap();
    child.wait().unwrap();
}

/// Killed before it writes, after its first file, and with more and more of them there; into an empty folder, and over what
/// another seed had made.
#[test]
fn synth_leaves_whole_files_and_a_folder_that_can_be_used() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), ROOM).unwrap();
    let out = folder.path().join("out");
    let made = |seed: &str| {
        assert!(synth(folder.path(), seed).wait().unwrap().success());
        files(&out)
    };
    let first = made("0");
    // By this list scenelang knows its files again.
    let list = out.join(".scenelang-files.sha256");
    let listed = fs::read(&list).unwrap();
    let second = made("1");
    assert!(first != second && first.len() > 10);
    for (before, wanted) in [(None, 0), (None, 1), (None, 20), (Some(&first), 1), (Some(&first), 4)] {
        fs::remove_dir_all(&out).unwrap();
        for (path, bytes) in before.into_iter().flatten() {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, bytes).unwrap();
        }
        if before.is_some() {
            fs::write(&list, &listed).unwrap();
        }
        let mut child = synth(folder.path(), "1");
        let since = Instant::now();
        if wanted == 0 {
            sleep(Duration::from_millis(100));
        }
        // Files that are there, or another than they were.
        let news = || match before {
            None => files(&out).len(),
            Some(old) => files(&out).iter().filter(|(path, bytes)| old.get(*path) != Some(bytes)).count(),
        };
        while wanted > 0 && news() < wanted && child.try_wait().unwrap().is_none() {
            assert!(since.elapsed() < PATIENCE);
        }
        kill(&mut child);
        for (path, bytes) in files(&out) {
            let whole = second.get(&path) == Some(&bytes) || before.and_then(|old| old.get(&path)) == Some(&bytes);
            assert!(whole, "{} is neither the old file nor the new one", path.display());
        }
        assert_eq!(made("1"), second, "after a kill at {wanted} files");
    }
}

/// A server of its own process.
struct Server {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
}

impl Server {
    /// A server for an editor that cannot make changes, so that the server writes layouts itself.
    fn start(folder: &Path, parent: &Value) -> Self {
        let mut command = binary();
        command.arg("lsp").current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = command.spawn().unwrap();
        let (to, from) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
        let mut server = Self { child, to, from };
        let can = json!({ "window": { "workDoneProgress": true } });
        server.ask(1, "initialize", &json!({ "processId": parent, "capabilities": can }));
        server.until(|m| m["id"] == 1);
        server.say(&json!({ "method": "initialized", "params": {} }));
        server
    }

    fn open(&mut self, scene: &Path) -> String {
        let (uri, text) = (format!("file://{}", scene.display()), fs::read_to_string(scene).unwrap());
        let document = json!({ "uri": uri, "languageId": "scene", "version": 1, "text": text });
        self.say(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } }));
        uri
    }

    fn solve(&mut self, uri: &str) {
        let solve = json!({ "command": "scenelang.solveAnew", "arguments": [{ "uri": uri }], "workDoneToken": "ours" });
        self.ask(2, "workspace/executeCommand", &solve);
    }

    fn ask(&mut self, id: i64, method: &str, params: &Value) {
        self.say(&json!({ "id": id, "method": method, "params": params }));
    }

    fn say(&mut self, message: &Value) {
        let mut message = message.clone();
        message["jsonrpc"] = "2.0".into();
        let body = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.to.flush().unwrap();
    }

    /// Reads until a message is the one.
    fn until(&mut self, mut is_it: impl FnMut(&Value) -> bool) -> Value {
        loop {
            let mut length = 0;
            loop {
                let mut line = String::new();
                assert_ne!(self.from.read_line(&mut line).unwrap(), 0, "the server is gone");
                match line.trim() {
                    "" => break,
                    line => length = line.strip_prefix("Content-Length: ").unwrap().parse().unwrap(),
                }
            }
            let mut body = vec![0; length];
            self.from.read_exact(&mut body).unwrap();
            let message: Value = serde_json::from_slice(&body).unwrap();
            if message["method"].is_string() && !message["id"].is_null() {
                self.say(&json!({ "id": message["id"], "result": null }));
            }
            if is_it(&message) {
                return message;
            }
        }
    }
}

/// Killed while it solves and at the moment at which the layout appears, over an old layout and without one.
#[test]
fn the_server_leaves_the_layout_whole() {
    let (folder, scene) = folder_with("bedroom");
    let layout = scene.with_extension("layout.json");
    let old = {
        assert_eq!(scenelang(folder.path(), ["solve", "bedroom.scene", "--seed", "7"]).code, 0);
        fs::read(&layout).unwrap()
    };
    for (there, late) in [(false, false), (true, false), (false, true), (true, true)] {
        if there {
            fs::write(&layout, &old).unwrap();
        } else {
            fs::remove_file(&layout).unwrap();
        }
        let mut server = Server::start(folder.path(), &Value::Null);
        let uri = server.open(&scene);
        server.solve(&uri);
        server.until(|m| m["method"] == "$/progress" && m["params"]["token"] == "ours");
        let since = Instant::now();
        while late && fs::read(&layout).map_or(true, |now| now == old) {
            assert!(since.elapsed() < PATIENCE);
        }
        kill(&mut server.child);
        match fs::read_to_string(&layout) {
            Ok(text) => {
                let whole = fits("layout", &text);
                assert!(late || text.as_bytes() == old, "{whole}");
            }
            Err(e) => assert!(!late && !there, "{e}"),
        }

        // Another server does the work.
        let mut server = Server::start(folder.path(), &Value::Null);
        let uri = server.open(&scene);
        server.solve(&uri);
        let answer = server.until(|m| m["id"] == 2 && m["method"].is_null());
        assert!(answer["result"]["message"].as_str().unwrap().starts_with("solved:"), "{answer}");
        fits("layout", &fs::read_to_string(&layout).unwrap());
        assert_eq!(scenelang(folder.path(), ["check", "bedroom.layout.json"]).code, 0);
        kill(&mut server.child);
    }
}

/// An editor that is killed cannot say goodbye, and may leave the server's input open.
#[test]
fn the_server_ends_with_its_editor() {
    let (folder, scene) = folder_with("bedroom");
    let mut editor = Command::new("sleep").arg("600").spawn().unwrap();
    let mut server = Server::start(folder.path(), &editor.id().into());
    server.open(&scene);
    assert!(server.child.try_wait().unwrap().is_none());
    kill(&mut editor);
    let since = Instant::now();
    let status = loop {
        if let Some(status) = server.child.try_wait().unwrap() {
            break status;
        }
        assert!(since.elapsed() < PATIENCE, "it goes on");
        sleep(Duration::from_millis(50));
    };
    assert_eq!(status.code(), Some(1));
}
