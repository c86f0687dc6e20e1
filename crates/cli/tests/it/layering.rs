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
    ("solve", &["verify", "llm"]),
    ("export", &["lang", "layout", "assets", "verify"]),
    ("synth", &["export", "solve", "formalize"]),
    ("eval", &["synth"]),
    ("ide", &["verify"]),
    ("lsp", &["ide", "synth"]),
    ("cli", &["lsp", "eval"]),
    ("grammars", &["lang"]),
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
