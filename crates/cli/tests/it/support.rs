//! What the tests share: where things are, how to run the binary and other tools, what to do when a tool is missing.

use serde_json::Value;
use std::ffi::OsStr;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The scenes of `examples/`, each a test of its own in several modules; a test holds the list against the folder.
macro_rules! for_each_example {
    ($test:path) => {
        #[test]
        fn meeting_room() {
            $test("meeting-room");
        }
        #[test]
        fn bedroom() {
            $test("bedroom");
        }
        #[test]
        fn apartment() {
            $test("apartment");
        }
        #[test]
        fn classroom() {
            $test("classroom");
        }
        #[test]
        fn restaurant() {
            $test("restaurant");
        }
        #[test]
        fn robot_lab() {
            $test("robot-lab");
        }
        #[test]
        fn workshop_safety() {
            $test("workshop-safety");
        }
    };
}
pub(crate) use for_each_example;

/// The same list as names.
pub const EXAMPLES: [&str; 7] =
    ["apartment", "bedroom", "classroom", "meeting-room", "restaurant", "robot-lab", "workshop-safety"];

/// A process that runs longer hangs. No test measures time; this only ends what would never end.
const HANGS: Duration = Duration::from_secs(300);

/// The repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// The program of an example.
pub fn example(name: &str) -> PathBuf {
    root().join("examples").join(format!("{name}.scene"))
}

/// How a process ended and what it said.
#[derive(Debug)]
pub struct Ended {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Ended {
    /// The JSON reports it printed, one per line, each as its schema says.
    pub fn reports(&self) -> Vec<Value> {
        self.stdout.lines().map(|line| fits("report", line)).collect()
    }
}

/// A document that is as a schema of ours says.
pub fn fits(schema: &str, text: &str) -> Value {
    let document: Value = serde_json::from_str(text).unwrap_or_else(|e| panic!("{e} in {text}"));
    let schema: Value = serde_json::from_str(scenelang_verify::schemas::find(schema).unwrap()).unwrap();
    let faults = faults(&jsonschema::draft202012::options().build(&schema).unwrap(), &document);
    assert!(faults.is_empty(), "{faults:#?} in {document:#}");
    document
}

/// What a schema has against a document.
pub fn faults(validator: &jsonschema::Validator, document: &Value) -> Vec<String> {
    validator.iter_errors(document).map(|e| format!("{}: {e}", e.instance_path())).collect()
}

/// Runs `scenelang` in `folder`.
pub fn scenelang<S: AsRef<OsStr>>(folder: &Path, args: impl IntoIterator<Item = S>) -> Ended {
    scenelang_with_input(folder, args, b"")
}

/// Runs `scenelang` in `folder` with something to read.
pub fn scenelang_with_input<S: AsRef<OsStr>>(folder: &Path, args: impl IntoIterator<Item = S>, input: &[u8]) -> Ended {
    run(binary().args(args).current_dir(folder), input)
}

/// `scenelang`, to be run as somebody who has set nothing: what whoever runs the tests has set changes none of them.
pub fn binary() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenelang"));
    at_home(&mut command);
    command
}

/// Gives a command a home in which there is nothing, unless it has one already.
fn at_home(command: &mut Command) {
    let home = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("home-{}", std::process::id()));
    let folders = ["HOME", "USERPROFILE", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "APPDATA", "LOCALAPPDATA"];
    let given = |name: &str| command.get_envs().any(|(known, value)| known == name && value.is_some());
    let missing: Vec<&str> = folders.into_iter().filter(|name| !given(name)).collect();
    for name in missing {
        match name {
            // Without them both are below the home.
            "XDG_CONFIG_HOME" | "XDG_CACHE_HOME" => command.env_remove(name),
            _ => command.env(name, &home),
        };
    }
}

/// Runs a command to its end.
///
/// # Panics
/// If it hangs, or ends by a signal (a crash, a stack overflow).
pub fn run(command: &mut Command, input: &[u8]) -> Ended {
    let name = format!("{command:?}");
    // A shell that limits what the binary may do.
    if command.get_program() == "sh" {
        at_home(command);
    }
    let mut child = command
        .env("NO_COLOR", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    // A process may end without reading all we have to say.
    let feeder = std::thread::spawn(move || stdin.write_all(&input).ok());
    let (out, err) = (collect(child.stdout.take().unwrap()), collect(child.stderr.take().unwrap()));
    let since = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if since.elapsed() > HANGS {
            child.kill().ok();
            panic!("{name} hangs");
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    feeder.join().unwrap();
    let (stdout, stderr) = (out.join().unwrap(), err.join().unwrap());
    let Some(code) = status.code() else { panic!("{name} crashed ({status}): {stderr}") };
    Ended { code, stdout, stderr }
}

fn collect(mut from: impl Read + Send + 'static) -> std::thread::JoinHandle<String> {
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        from.read_to_end(&mut bytes).unwrap();
        String::from_utf8(bytes).expect("what we print is UTF-8")
    })
}

/// A folder with these files, by name and text.
pub fn folder_of(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// A folder with a copy of an example's program in it, and the program's path.
pub fn folder_with(name: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join(format!("{name}.scene"));
    fs::copy(example(name), &scene).unwrap();
    (folder, scene)
}

/// Reads a JSON file.
pub fn read_json(path: &Path) -> Value {
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A tool is missing: a message, and a failure where nothing may be missing.
pub fn skip(what: &str) {
    assert!(std::env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: {what}");
    eprintln!("skipped: {what}");
}

/// The Python that `./x test` sets up for the checkers.
pub fn python() -> Option<PathBuf> {
    let path = root().join(".venv/bin/python");
    path.exists().then_some(path)
}

/// Whether `./x test` has installed a package for the checkers that run in Node.
pub fn has_node_package(name: &str) -> bool {
    root().join("tests/oracles/node_modules").join(name).exists()
        && Command::new("node").arg("--version").output().is_ok_and(|o| o.status.success())
}

/// A browser that can run without a screen.
pub fn browser() -> Option<PathBuf> {
    let named = std::env::var_os("CHROME_BIN").map(PathBuf::from);
    let found = ["chromium", "chromium-browser", "google-chrome"].iter().find_map(|name| {
        let folders = std::env::var_os("PATH")?;
        std::env::split_paths(&folders).map(|f| f.join(name)).find(|p| p.is_file())
    });
    named.or(found)
}

#[test]
fn the_list_of_examples_is_what_the_folder_holds() {
    let mut found: Vec<String> = fs::read_dir(root().join("examples"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "scene"))
        .map(|p| p.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    found.sort();
    assert_eq!(found, EXAMPLES);
}
