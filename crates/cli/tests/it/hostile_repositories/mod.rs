//! Repositories of strangers: whatever a clone has in it, no command and no server reads or writes anything outside of it,
//! hangs, falls over, or writes what acts into a log.
//!
//! A row of the table in `rows.rs` makes a repository, in a folder that has secrets and victims beside it. Every command
//! that takes files is run in it, with little memory and little time, and a server is started on it.

mod rows;
mod server;

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// What is in every file outside, and in the environment.
pub const SECRET: &str = "hunter2";
/// A process that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(60);
/// More address space than this no command needs (KiB).
const MEMORY: u32 = 6 << 20;

/// A good program, and its layout.
pub const ROOM: &str = "object desk;\ndesk.scale <- vec3(1, 1, 1);\nassert desk.pos.x > 1;\n";
pub const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
    "objects": { "desk": { "pos": [0, 0.5, 0], "scale": [1, 1, 1] } } }"#;

/// What looks as if it could be repaired, and is no program.
const TOOL: &str = "object tool;;\nassert tool.pos.x > 1;\n";

/// A row of the table.
pub struct Row {
    /// What it is about.
    pub name: &'static str,
    /// Makes it; `room.scene` and `room.layout.json` are there already.
    pub make: fn(&Repository),
    /// What the editor's settings say of where layouts are: a workspace can bring settings with it.
    pub setting: Option<&'static str>,
}

/// A repository, with things beside it that are none of its business.
pub struct Repository {
    around: tempfile::TempDir,
}

impl Repository {
    fn new(row: &Row) -> Self {
        let made = Self { around: tempfile::tempdir().unwrap() };
        let fixable = format!("object {SECRET};;\nassert {SECRET}.pos.x > 1;\n");
        for (file, text) in [
            ("secret.scene", fixable.as_str()),
            ("secret.env", &format!("key = \"{SECRET}\"\n")),
            ("secret.json", &format!("{{ \"key\": \"{SECRET}\" }}")),
            ("victim.js", &fixable),
            ("victim.json", &LAYOUT.replace("desk", SECRET)),
            ("home/.ssh/key", SECRET),
            ("elsewhere/kept.txt", SECRET),
            ("repo/.git/HEAD", "ref: refs/heads/main\n"),
            ("repo/room.scene", ROOM),
            ("repo/room.layout.json", LAYOUT),
            // A file of the repository that is none of ours: whatever names it, it stays as it is.
            ("repo/tool.js", TOOL),
            (
                "repo/jobs.jsonl",
                "{\"name\": \"one\", \"program\": \"room.scene\"}\n{\"program\": \"../home/.ssh/key\"}\n",
            ),
            ("repo/good.scene", "object good;;\nassert good.pos.x > 1;\n"),
        ] {
            let path = made.around.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        (row.make)(&made);
        made
    }

    /// The repository itself.
    pub fn root(&self) -> PathBuf {
        self.around.path().join("repo")
    }

    /// A file in it, or beside it.
    pub fn at(&self, path: &str) -> PathBuf {
        self.root().join(path)
    }

    /// Writes a file in it, in place of what is there.
    pub fn write(&self, path: &str, text: impl AsRef<[u8]>) {
        let path = self.at(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let _ = fs::remove_file(&path);
        fs::write(path, text).unwrap();
    }

    /// Makes a link in it, in place of what is there.
    pub fn link(&self, path: &str, to: impl AsRef<Path>) {
        let _ = fs::remove_file(self.at(path));
        std::os::unix::fs::symlink(to, self.at(path)).unwrap();
    }

    /// Makes a pipe in it, in place of what is there.
    pub fn pipe(&self, path: &str) {
        let _ = fs::remove_file(self.at(path));
        assert!(Command::new("mkfifo").arg(self.at(path)).status().unwrap().success());
    }

    /// Makes a file of so many bytes, none of which takes room on the disk.
    pub fn sparse(&self, path: &str, size: u64) {
        self.write(path, "");
        fs::File::create(self.at(path)).unwrap().set_len(size).unwrap();
    }

    /// Everything outside of it: what is where, and what is in it. Pages of the book that the server puts into the user's
    /// cache are left out, if they are what the book says.
    fn outside(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let cache = self.around.path().join("home/.cache");
        let mut found = BTreeMap::new();
        let mut folders = vec![self.around.path().to_path_buf()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
                let (path, kind) = (entry.path(), entry.file_type().unwrap());
                let is_cached = path.starts_with(&cache);
                if kind.is_dir() && path != self.root() {
                    folders.push(path.clone());
                    found.extend((!is_cached).then_some((path, Vec::new())));
                } else if kind.is_file() {
                    let text = fs::read(&path).unwrap();
                    if !(is_cached && is_page(&text)) {
                        found.insert(path, text);
                    }
                }
            }
        }
        found
    }

    /// A secret that has come into a file of the repository.
    fn leaked(&self) -> Option<PathBuf> {
        let mut folders = vec![self.root()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
                let kind = entry.file_type().unwrap();
                if kind.is_dir() {
                    folders.push(entry.path());
                } else if kind.is_file() && entry.metadata().unwrap().len() < 1 << 20 {
                    let bytes = fs::read(entry.path()).unwrap();
                    if String::from_utf8_lossy(&bytes).contains(SECRET) {
                        return Some(entry.path());
                    }
                }
            }
        }
        None
    }

    /// A command in the repository: with secrets in its environment, and not much memory.
    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new("sh");
        command.args([
            "-c",
            &format!("ulimit -v {MEMORY} 2>/dev/null; exec \"$0\" \"$@\""),
            env!("CARGO_BIN_EXE_scenelang"),
        ]);
        command.args(args).current_dir(self.root()).env("HOME", self.around.path().join("home"));
        command.env("API_KEY", SECRET).env("NO_COLOR", "1").env_remove("XDG_CACHE_HOME");
        command
    }
}

/// The commands that take files.
const COMMANDS: &[&[&str]] = &[
    &["check", "."],
    &["check", "--verbosity", "compact", "room.scene", "room.layout.json"],
    &["check", "--format", "json", "."],
    &["check", "--format", "github", "."],
    &["check", "--format", "junit", "."],
    &["check", "--format", "sarif", "."],
    &["constraints", "room.scene"],
    &["hir", "room.scene"],
    &["syntax", "room.scene"],
    &["trace", "room.scene"],
    &["diff", "room.layout.json", "room.layout.json"],
    &["query", "room.scene"],
    &["query", "room.layout.json", "--object", "desk"],
    &["query", "room.glb"],
    &["import", "room.glb", "-o", "back"],
    &["export", "room.layout.json", "--only", "plan"],
    &["assets", "check", "."],
    &["assets", "check", "--format", "sarif", "."],
    &["assets", "list", "."],
    &["assets", "search", "desk", "--in", "."],
    &["repair", "room.layout.json"],
    &["repair", "room.layout.json", "--apply", "1"],
    &["eval", "requests", "."],
    &["formalize", "-f", "request.txt", "--untried", "-o", "formal.scene"],
    &["check", "--fix", "."],
    &["fmt", "room.scene"],
    &["solve", "room.scene"],
    &["synth", "room.scene"],
    &["sample", "room.scene", "-n", "1", "-o", "samples"],
    &["batch", "jobs.jsonl", "-o", "many"],
    &["solve", "room.scene", "-o", "out/room.layout.json"],
];

/// Whether a text is a page of the book about a code, or the beginning of one: a server may be killed while it writes.
fn is_page(text: &[u8]) -> bool {
    let pages = fs::read_dir(crate::support::root().join("spec/src/codes")).unwrap();
    pages.map(|page| fs::read(page.unwrap().path()).unwrap()).any(|page| page.starts_with(text))
}

/// Runs all commands and a server on the repository of a row.
fn hold(name: &str) {
    let row = rows::ROWS.iter().find(|row| row.name == name).expect("the row of its own name");
    let made = Repository::new(row);
    let before = made.outside();
    for args in COMMANDS {
        let said = format!("{name}: {args:?}");
        let (code, out) = run(made.command(args), &said);
        assert!((0..=2).contains(&code), "{said} ended with {code}: {out}");
        clean(&out, &said, args.contains(&"github"));
        assert!(made.outside() == before, "{said} wrote outside");
        assert_eq!(made.leaked(), None, "{said}");
        assert_eq!(fs::read_to_string(made.at("tool.js")).unwrap(), TOOL, "{said} changed a script");
    }
    // Commands have changed the repository: the server has its own.
    let made = Repository::new(row);
    let before = made.outside();
    let told = server::serve(&made, row);
    assert!(!told.contains(SECRET), "{name}: the server told a secret: {told}");
    assert!(made.outside() == before, "{name}: the server wrote outside");
    assert_eq!(made.leaked(), None, "{name}: the server");
    assert_eq!(fs::read_to_string(made.at("tool.js")).unwrap(), TOOL, "{name}: the server changed a script");
    let made = Repository::new(row);
    let before = made.outside();
    let told = server::assist(&made);
    assert!(!told.contains(SECRET), "{name}: an assistant was told a secret: {told}");
    assert!(made.outside() == before, "{name}: an assistant wrote outside");
    assert_eq!(made.leaked(), None, "{name}: an assistant");
    assert_eq!(fs::read_to_string(made.at("tool.js")).unwrap(), TOOL, "{name}: an assistant changed a script");
}

/// Nothing secret is said, and nothing that acts.
fn clean(out: &str, said: &str, annotates: bool) {
    assert!(!out.contains(SECRET), "{said} told a secret: {out}");
    let acts = |c: char| c.is_control() && !matches!(c, '\n' | '\t') || ('\u{202a}'..='\u{202e}').contains(&c);
    let machine = said.contains("json") || said.contains("sarif");
    assert!(machine || !out.contains(acts), "{said} printed what acts: {out:?}");
    for line in out.lines().filter(|line| line.trim_start().starts_with("::")) {
        let ours = ["::error file=", "::warning file=", "::notice file="];
        assert!(annotates && ours.iter().any(|start| line.starts_with(start)), "{said} wrote a command: {line}");
    }
}

/// Runs a command to its end: the exit code, and all it said.
fn run(mut command: Command, said: &str) -> (i32, String) {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let (out, err) = (collect(child.stdout.take().unwrap()), collect(child.stderr.take().unwrap()));
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if begun.elapsed() > PATIENCE {
            child.kill().ok();
            panic!("{said} hangs");
        }
        thread::sleep(Duration::from_millis(5));
    };
    let text = out.join().unwrap() + &err.join().unwrap();
    (status.code().unwrap_or_else(|| panic!("{said} crashed ({status}): {text}")), text)
}

fn collect(mut from: impl Read + Send + 'static) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        from.read_to_end(&mut bytes).unwrap();
        String::from_utf8(bytes).expect("what we print is UTF-8")
    })
}
