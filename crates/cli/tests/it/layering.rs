//! The table of `docs/architecture.md` as data: which crate may use which. An arrow that is not in it fails.

use crate::support;
use cargo_metadata::{DependencyKind, MetadataCommand};
use std::collections::{BTreeMap, BTreeSet};

/// Crate and what it may use, without our prefix; "may use" is transitive.
const TABLE: &[(&str, &[&str])] = &[
    ("base", &[]),
    ("lang", &["base"]),
    ("layout", &["base"]),
    ("verify", &["lang", "layout"]),
    ("assets", &["layout"]),
    ("llm", &["base"]),
    ("formalize", &["verify", "llm"]),
    ("engine", &["verify"]),
    ("solve", &["engine", "llm"]),
    ("export", &["lang", "layout", "assets", "verify"]),
    ("catalogue", &["assets", "llm"]),
    ("synth", &["export", "solve", "formalize", "catalogue"]),
    ("foreign", &["lang", "layout"]),
    ("eval", &["synth"]),
    ("sample", &["synth"]),
    ("analysis", &["engine"]),
    ("ide", &["analysis", "assets"]),
    ("lsp", &["ide", "synth"]),
    ("cli", &["lsp", "eval", "sample", "catalogue", "foreign"]),
    ("grammars", &["lang"]),
    ("python", &["analysis", "sample"]),
    ("playground", &["ide", "synth"]),
];

/// Whatever is reachable in the table.
fn allowed(from: &str) -> BTreeSet<&'static str> {
    let direct = TABLE.iter().find(|(name, _)| *name == from).map_or(&[][..], |(_, uses)| uses);
    direct.iter().flat_map(|to| allowed(to).into_iter().chain([*to])).collect()
}

/// Our crates with the ones of ours they depend on, tests and benchmarks apart.
fn arrows() -> BTreeMap<String, BTreeSet<String>> {
    let ours = |name: &str| name.strip_prefix("scenelang-").map(str::to_owned);
    let metadata = MetadataCommand::new()
        .manifest_path(support::root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo describes the workspace");
    metadata
        .packages
        .iter()
        .filter_map(|package| {
            let uses = package
                .dependencies
                .iter()
                .filter(|d| d.kind != DependencyKind::Development)
                .filter_map(|d| ours(&d.name))
                .collect();
            Some((ours(&package.name)?, uses))
        })
        .collect()
}

#[test]
fn no_arrow_against_the_table() {
    let mut wrong = Vec::new();
    for (from, uses) in arrows() {
        let allowed = allowed(&from);
        wrong.extend(uses.iter().filter(|to| !allowed.contains(to.as_str())).map(|to| format!("{from} → {to}")));
    }
    assert!(wrong.is_empty(), "arrows that docs/architecture.md does not have: {}", wrong.join(", "));
}

#[test]
fn the_table_and_the_workspace_name_the_same_crates() {
    let table: BTreeSet<_> = TABLE.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(table, arrows().into_keys().collect());
}

/// Who reads or writes files without the door of `base`, and why.
const AT_THE_DISK: &[(&str, &str)] = &[
    ("base/src/door", "it is the door"),
    ("base/src/fs", "what the door writes with"),
    ("base/src/owned", "which files are ours: of regular files that are about to be replaced"),
    ("cli/src/model.rs", "a recording is made where the option `--record` says"),
    ("cli/src/sample/", "samples are recorded one by one, in a folder that `-o` names and the door permits"),
    ("cli/src/view/peer.rs", "the system's list of connections"),
    ("grammars/src", "no part of the program: it writes files of this repository"),
    ("llm/src/cache.rs", "`llm` knows nothing of ours; the cache has a folder of its own"),
    ("llm/src/tape.rs", "`llm` knows nothing of ours; conversations are named by options"),
    ("lsp/src/record.rs", "a session is recorded where the option `--record` says, message by message"),
];

#[test]
fn only_the_door_touches_the_disk() {
    let calls = ["fs::read(", "fs::read_to_string(", "fs::write(", "fs::copy(", "fs::rename(", "fs::hard_link("];
    let more = ["fs::create_dir", "fs::remove_", "File::open(", "File::create(", "OpenOptions", "write_whole("];
    let crates = support::root().join("crates");
    let mut folders: Vec<_> = std::fs::read_dir(&crates).unwrap().map(|e| e.unwrap().path().join("src")).collect();
    let (mut wrong, mut needed) = (Vec::new(), BTreeSet::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            let name = entry.strip_prefix(&crates).unwrap().to_string_lossy().replace('\\', "/");
            if entry.is_dir() {
                folders.push(entry);
                continue;
            }
            // What stands behind `mod tests` is no part of the program.
            let text = std::fs::read_to_string(&entry).unwrap();
            let text = text.split("#[cfg(test)]\nmod ").next().unwrap();
            let found = calls.iter().chain(&more).find(|call| text.contains(**call));
            match (found, AT_THE_DISK.iter().find(|(path, _)| name.starts_with(path))) {
                _ if name.ends_with("/tests.rs") => {}
                (Some(call), None) => wrong.push(format!("{name}: {call}…)")),
                (Some(_), Some((path, _))) => drop(needed.insert(*path)),
                (None, _) => {}
            }
        }
    }
    assert!(wrong.is_empty(), "files are read and written through scenelang_base::door: {}", wrong.join(", "));
    let unused: Vec<_> = AT_THE_DISK.iter().filter(|(path, _)| !needed.contains(path)).collect();
    assert!(unused.is_empty(), "these need not be in the list any more: {unused:?}");
}

#[test]
fn the_document_has_the_same_table() {
    let text = std::fs::read_to_string(support::root().join("docs/architecture.md")).unwrap();
    for (name, uses) in TABLE {
        let row = format!("| `{name}` |");
        let line = text.lines().find(|l| l.starts_with(&row)).unwrap_or_else(|| panic!("no row for {name}"));
        let cell = line.split('|').nth(3).unwrap().trim();
        let said: BTreeSet<&str> = match cell {
            "–" => BTreeSet::new(),
            "all above" | "all" => TABLE.iter().map(|(n, _)| *n).take_while(|n| n != name).collect(),
            list => list.split(", ").collect(),
        };
        let reachable = |direct: &BTreeSet<&str>| -> BTreeSet<_> {
            direct.iter().flat_map(|d| allowed(d).into_iter().map(str::to_owned).chain([(*d).to_owned()])).collect()
        };
        assert_eq!(reachable(&said), reachable(&uses.iter().copied().collect()), "row of {name}");
    }
}
