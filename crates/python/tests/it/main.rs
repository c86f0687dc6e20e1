//! The module as Python sees it: put into an empty folder as a wheel would put it, and asked by scripts that need nothing but
//! Python. What they compare it with is the command line.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap().to_path_buf()
}

/// A tool is missing: a message, and a failure where nothing may be missing.
fn skip(what: &str) {
    assert!(std::env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: {what}");
    eprintln!("skipped: {what}");
}

/// Whether a Python runs a line without an error.
fn can(python: &Path, line: &str) -> bool {
    Command::new(python).args(["-I", "-c", line]).output().is_ok_and(|output| output.status.success())
}

/// A Python that the module is for.
fn plain() -> Option<PathBuf> {
    let names = ["python3", "python"].map(PathBuf::from);
    names.into_iter().chain([prepared()]).find(|python| can(python, "import sys; assert sys.version_info >= (3, 11)"))
}

/// The Python that `./x test` sets up, which has NumPy.
fn prepared() -> PathBuf {
    root().join(".venv/bin/python")
}

fn with_numpy() -> Option<PathBuf> {
    let line = "import sys, numpy; assert sys.version_info >= (3, 11)";
    Some(prepared()).filter(|python| can(python, line))
}

/// The folder of the test's own program: Cargo has put the library there.
fn built() -> PathBuf {
    std::env::current_exe().unwrap().parent().unwrap().to_path_buf()
}

/// A folder with the package in it, as a wheel has it.
fn installed() -> &'static Path {
    static FOLDER: OnceLock<tempfile::TempDir> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let package = folder.path().join("scenelang");
        fs::create_dir(&package).unwrap();
        for entry in fs::read_dir(root().join("crates/python/scenelang")).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                fs::copy(&path, package.join(path.file_name().unwrap())).unwrap();
            }
        }
        let library = built().join(format!("{DLL_PREFIX}scenelang_python{DLL_SUFFIX}"));
        let module = if cfg!(windows) { "_native.pyd" } else { "_native.abi3.so" };
        fs::copy(&library, package.join(module)).unwrap_or_else(|e| panic!("{}: {e}", library.display()));
        folder
    });
    folder.path()
}

/// The command line, which stands beside the folder of the tests once its own are built.
fn command_line() -> Option<PathBuf> {
    let path = built().parent().unwrap().join(format!("scenelang{EXE_SUFFIX}"));
    path.is_file().then_some(path)
}

/// Runs a script with the module in its path and nothing else, in a folder of its own; what it prints.
fn run(python: &Path, script: &Path, arguments: &[&Path]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(python)
        .args(["-B", "-W", "error"])
        .arg(script)
        .args(arguments)
        .env("PYTHONPATH", installed())
        .env("PYTHONIOENCODING", "utf-8")
        .current_dir(folder.path())
        .output()
        .unwrap();
    let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}:\n{}{}", script.display(), said(&output.stdout), said(&output.stderr));
    said(&output.stdout)
}

fn script(name: &str) -> PathBuf {
    root().join("crates/python/tests").join(name)
}

/// Once without NumPy where there is such a Python, once with it.
fn in_each(name: &str, arguments: &[&Path]) {
    let Some(python) = plain() else { return skip("the module is not tried: no Python 3.11") };
    run(&python, &script(name), arguments);
    match with_numpy() {
        Some(python) => drop(run(&python, &script(name), arguments)),
        None => skip("the module is not tried with NumPy: it is not in .venv"),
    }
}

#[test]
fn what_it_does() {
    in_each("api.py", &[]);
}

#[test]
fn stubs_are_complete() {
    match plain() {
        Some(python) => drop(run(&python, &script("stubs.py"), &[])),
        None => skip("the module is not tried: no Python 3.11"),
    }
}

#[test]
fn margins_are_those_of_the_command_line() {
    let Some(binary) = command_line() else { return skip("no command line beside the tests: build the workspace") };
    let (script, examples) = (script("agreement.py"), root().join("examples"));
    // Every example has to be solved first, so without NumPy, where only the arrays differ, one of them does.
    match plain() {
        Some(python) => drop(run(&python, &script, &[&binary, &examples, Path::new("bedroom")])),
        None => skip("the module is not tried: no Python 3.11"),
    }
    match with_numpy() {
        Some(python) => drop(run(&python, &script, &[&binary, &examples])),
        None => skip("the module is not tried with NumPy: it is not in .venv"),
    }
}

#[test]
fn many_environments() {
    in_each("many.py", &[]);
}

/// The examples of the page are its code blocks, each of them a program.
#[test]
fn the_examples_of_its_page() {
    let page = fs::read_to_string(root().join("docs/python.md")).unwrap();
    let blocks: Vec<&str> = page.split("```python\n").skip(1).map(|rest| rest.split("\n```").next().unwrap()).collect();
    assert!(blocks.len() >= 3, "{}", blocks.len());
    let Some(python) = with_numpy() else {
        return skip("the examples of docs/python.md are not run: no NumPy in .venv");
    };
    let folder = tempfile::tempdir().unwrap();
    for (index, block) in blocks.iter().enumerate() {
        let file = folder.path().join(format!("example{index}.py"));
        fs::write(&file, block).unwrap();
        run(&python, &file, &[]);
    }
}
