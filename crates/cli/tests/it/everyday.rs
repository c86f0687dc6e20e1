//! What people write by mistake: `check` says so before anything is solved; and the programs beside these, which differ
//! by a hair, have layouts. The cases are those of the prover's own tests.

use std::fs;
use std::path::Path;
use std::process::Command;

fn scenelang(args: &[&str], folder: &Path) -> (i32, String) {
    let out = Command::new(env!("CARGO_BIN_EXE_scenelang")).args(args).current_dir(folder).output().unwrap();
    let text = [out.stdout, out.stderr].map(|t| String::from_utf8_lossy(&t).into_owned()).concat();
    (out.status.code().unwrap_or(-1), text)
}

/// The programs that can be satisfied, by the names of their cases.
fn twins() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../verify/tests/proofs/everyday");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let texts = files.into_iter().map(|file| format!("\n{}", fs::read_to_string(file).unwrap()));
    let case = |part: &str| {
        let (name, body) = part.split_once('\n').unwrap();
        let mut lines: Vec<&str> = Vec::new();
        for line in body.lines() {
            match line.strip_prefix("~ ") {
                Some(other) => *lines.last_mut().unwrap() = other,
                None => lines.push(line.trim_end_matches("//!")),
            }
        }
        (name.to_owned(), lines.join("\n"))
    };
    texts.flat_map(|text| text.split("\n== ").skip(1).map(case).collect::<Vec<_>>()).collect()
}

#[test]
fn programs_that_differ_by_a_hair_are_solved() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in twins() {
        fs::write(folder.path().join("twin.scene"), &text).unwrap();
        // Whether furniture opens is not what these are about: wardrobes all along the walls of a small room would not.
        let (code, said) = scenelang(&["solve", "twin.scene", "--opens", "doors", "--force"], folder.path());
        assert_eq!(code, 0, "{name}\n{text}\n{said}");
    }
}

#[test]
fn a_contradiction_is_told_before_the_search() {
    let folder = tempfile::tempdir().unwrap();
    let text = "region room; object crate[5];\nroom.scale <- vec3(4, 2.5, 4);\ncrate.scale <- vec3(1.6, 1.5, 1.6);\n";
    fs::write(folder.path().join("room.scene"), text).unwrap();
    for command in ["check", "solve"] {
        let (code, said) = scenelang(&[command, "room.scene"], folder.path());
        assert!(code != 0 && said.contains("at most 4 fit") && said.contains("unless something is tilted"), "{said}");
    }
}

/// What is added to a furnished room by hand contradicts itself: the rest of the room does not hide it.
#[test]
fn a_contradiction_in_a_furnished_room_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let request = "A dining room with a long table for ten and a sideboard.";
    let (code, said) = scenelang(&["formalize", request, "-o", "room.scene"], folder.path());
    assert_eq!(code, 0, "{said}");
    let file = folder.path().join("room.scene");
    let text = fs::read_to_string(&file).unwrap();
    let more = "assert diningTable.rot.y = 0 and diningTable.pos.x > -100;\nassert diningTable.rot.y = 90 and diningTable.pos.x > -90;\n";
    fs::write(&file, text + more).unwrap();
    let (code, said) = scenelang(&["check", "room.scene"], folder.path());
    assert!(code != 0 && said.contains("these 2 statements contradict each other"), "{said}");
}
