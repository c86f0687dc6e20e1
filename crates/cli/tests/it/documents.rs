//! What the documents claim: their scenes compile and solve, their links lead somewhere.

use crate::support::{root, scenelang};
use std::fs;

const DOCUMENTS: [&str; 7] = [
    "README.md",
    "CONTRIBUTING.md",
    "SECURITY.md",
    "docs/architecture.md",
    "docs/benchmarks.md",
    "docs/evaluation.md",
    "docs/simulators.md",
];

fn read(document: &str) -> String {
    fs::read_to_string(root().join(document)).unwrap()
}

#[test]
fn the_scenes_in_documents_solve() {
    let mut scenes = 0;
    for document in DOCUMENTS {
        for block in read(document).split("```scene\n").skip(1) {
            let folder = tempfile::tempdir().unwrap();
            let scene = folder.path().join("block.scene");
            fs::write(&scene, block.split("```").next().unwrap()).unwrap();
            let ended = scenelang(folder.path(), ["solve", "block.scene", "-o", "block.layout.json"]);
            assert_eq!(ended.code, 0, "{document}: {}{}", ended.stdout, ended.stderr);
            let ended = scenelang(folder.path(), ["check", "block.scene", "block.layout.json"]);
            assert_eq!(ended.code, 0, "{document}: {}{}", ended.stdout, ended.stderr);
            scenes += 1;
        }
    }
    assert!(scenes > 0);
}

/// The headings of a document, as links name them.
fn headings(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| line.starts_with('#'));
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, '-' | ' ');
    lines
        .map(|line| {
            line.trim_start_matches('#')
                .trim()
                .to_lowercase()
                .chars()
                .filter(kept)
                .collect::<String>()
                .replace(' ', "-")
        })
        .collect()
}

#[test]
fn the_links_in_documents_lead_somewhere() {
    let mut dead = Vec::new();
    for document in DOCUMENTS {
        let text = read(document);
        let folder = root().join(document).parent().unwrap().to_owned();
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let there = folder.join(file);
            let has_heading = || headings(&fs::read_to_string(&there).unwrap()).iter().any(|h| h == heading);
            if !link.contains("://") && !(there.exists() && (heading.is_empty() || has_heading())) {
                dead.push(format!("{document}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "{dead:#?}");
}
