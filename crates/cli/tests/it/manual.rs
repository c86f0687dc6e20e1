//! Completions, manual pages, and the pages of the book on each command.

use crate::support::{root, run, scenelang, skip};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

fn names(folder: &Path) -> BTreeSet<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn the_pages_of_the_book_are_those_of_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let ended = scenelang(folder.path(), ["man", "--format", "markdown", "-o", "pages"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let (book, made) = (root().join("spec/src/commands"), folder.path().join("pages"));
    let hidden = |names: BTreeSet<String>| names.into_iter().filter(|n| !n.starts_with('.')).collect::<BTreeSet<_>>();
    assert_eq!(hidden(names(&book)), hidden(names(&made)), "./x pages writes them");
    let summary = fs::read_to_string(root().join("spec/src/SUMMARY.md")).unwrap();
    for name in hidden(names(&made)) {
        let [old, new] = [&book, &made].map(|folder| fs::read_to_string(folder.join(&name)).unwrap());
        assert_eq!(old, new, "{name} is stale; ./x pages writes it");
        assert!(summary.contains(&format!("(commands/{name})")), "SUMMARY.md does not list {name}");
    }
}

#[test]
fn pages_for_man_are_written_and_known_again() {
    let folder = tempfile::tempdir().unwrap();
    for _ in 0..2 {
        let ended = scenelang(folder.path(), ["man", "-o", "pages"]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
    }
    let check = folder.path().join("pages/scenelang-check.1");
    assert!(fs::read_to_string(&check).unwrap().contains(".TH"));
    assert!(folder.path().join("pages/scenelang-bench-solve.1").is_file());
    fs::write(&check, "mine").unwrap();
    assert_eq!(scenelang(folder.path(), ["man", "-o", "pages"]).code, 2);
    assert_eq!(scenelang(folder.path(), ["man", "bench", "solve"]).code, 0);
    let ended = scenelang(folder.path(), ["man", "chekc"]);
    assert!(ended.code == 2 && ended.stderr.contains("check"), "{}", ended.stderr);
}

#[test]
fn shells_are_told_of_every_command() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let ended = scenelang(folder.path(), ["completions", shell]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        for word in ["formalize", "explain-proof", "sceneeval"] {
            assert!(ended.stdout.contains(word), "{shell}: {word}");
        }
    }
    let script = scenelang(folder.path(), ["completions", "bash"]).stdout;
    fs::write(folder.path().join("bash"), script).unwrap();
    if Command::new("bash").arg("--version").output().is_err() {
        return skip("there is no bash");
    }
    let asked = "source ./bash; COMP_WORDS=(scenelang formal); COMP_CWORD=1; _scenelang scenelang formal scenelang; \
        echo \"${COMPREPLY[@]}\"";
    let ended = run(Command::new("bash").args(["-c", asked]).current_dir(folder.path()), b"");
    assert_eq!(ended.stdout.trim(), "formalize", "{}", ended.stderr);
}

/// The name of a rule, as reports give it, leads to the page of its code.
#[test]
fn physical_rules_are_explained() {
    let folder = tempfile::tempdir().unwrap();
    for (rule, code) in [("P-COLLIDE", "V0102"), ("P-BOUNDS", "V0103"), ("p-support", "V0104"), ("P-OPEN", "V0107")] {
        let [by_rule, by_code] = [rule, code].map(|word| scenelang(folder.path(), ["explain", word]));
        assert_eq!((by_rule.code, by_rule.stdout), (0, by_code.stdout), "{rule}");
    }
    assert_eq!(scenelang(folder.path(), ["explain", "P-FLY"]).code, 2);
}
