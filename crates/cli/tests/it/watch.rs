//! `check --watch`: a new report for each change, by whatever way a file is saved; Ctrl-C ends it.
#![cfg(unix)]

use crate::support::binary;
use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// A report that does not come in this time does not come at all. Nothing here depends on how long it takes.
const NEVER: Duration = Duration::from_secs(60);

struct Watch {
    child: Child,
    lines: Receiver<String>,
}

impl Watch {
    fn start(folder: &Path, args: &[&str]) -> Self {
        let mut child = binary()
            .args(["check", "--watch", "--format", "json"])
            .args(args)
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let out = BufReader::new(child.stdout.take().unwrap());
        let (sender, lines) = channel();
        std::thread::spawn(move || out.lines().map_while(Result::ok).try_for_each(|line| sender.send(line)));
        Self { child, lines }
    }
    /// The next report: its file, whether it is good, and the codes of its diagnostics.
    fn next(&self) -> (String, bool, Vec<String>) {
        let line = self.lines.recv_timeout(NEVER).expect("a report comes");
        let report: Value = serde_json::from_str(&line).unwrap();
        let codes = report["diagnostics"].as_array().unwrap().iter().map(|d| d["code"].as_str().unwrap().to_owned());
        (report["file"].as_str().unwrap().to_owned(), report["ok"].as_bool().unwrap(), codes.collect())
    }
    /// Ctrl-C; the exit code.
    fn end(mut self) -> Option<i32> {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        self.child.wait().unwrap().code()
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        // A test that fails leaves nobody behind.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn good(file: &str) -> (String, bool, Vec<String>) {
    (file.to_owned(), true, Vec::new())
}

#[test]
fn every_way_to_save_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("near.scene"), "predicate closeBy(Object a, Object b) := distance(a, b) < 3;\n").unwrap();
    fs::write(at("room.scene"), "import \"near.scene\";\nobject a;\nobject b;\nassert closeBy(a, b);\n").unwrap();
    let layout = |x: f64| {
        format!(
            r#"{{ "format": "scenelang.layout/1", "objects": {{
                 "a": {{ "pos": [0, 0, 0], "scale": [1, 1, 1] }}, "b": {{ "pos": [{x}, 0, 0], "scale": [1, 1, 1] }} }} }}"#
        )
    };
    fs::write(at("room.layout.json"), layout(2.0)).unwrap();
    let watch = Watch::start(folder.path(), &["room.layout.json"]);
    assert_eq!(watch.next(), good("room.layout.json"));

    // Written in place.
    fs::write(at("room.layout.json"), layout(4.25)).unwrap();
    assert!(!watch.next().1);
    // Renamed into place, as editors do.
    fs::write(at("room.layout.json~"), layout(2.5)).unwrap();
    fs::rename(at("room.layout.json~"), at("room.layout.json")).unwrap();
    assert!(watch.next().1);
    // An import of its program.
    fs::write(at("near.scene"), "predicate closeBy(Object a, Object b) := distance(a, b) < 1.5;\n").unwrap();
    assert!(!watch.next().1);
    // Gone, and back.
    fs::remove_file(at("near.scene")).unwrap();
    assert!(watch.next().2.contains(&"E0206".to_owned()));
    fs::write(at("near.scene"), "predicate closeBy(Object a, Object b) := distance(a, b) < 30;\n").unwrap();
    assert_eq!(watch.next(), good("room.layout.json"));
    // Settings that were not there.
    fs::write(at("scenelang.toml"), "phisics = true\n").unwrap();
    assert_eq!(watch.next().2, ["E0007"]);
    assert_eq!(watch.end(), Some(2), "the code of the last report");
}

#[test]
fn a_folder_is_watched_for_new_files() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.scene"), "object a;\nassert a.pos.x > 0;\n").unwrap();
    let watch = Watch::start(folder.path(), &["."]);
    assert_eq!(watch.next(), good("a.scene"));
    fs::write(folder.path().join("b.scene"), "object b;\nassert b.pos.x > 0;\n").unwrap();
    assert_eq!((watch.next(), watch.next()), (good("a.scene"), good("b.scene")));
    assert_eq!(watch.end(), Some(0));
}
