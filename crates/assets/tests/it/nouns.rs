//! Nouns: what they are taken for, and that each noun with a usual size has a family.

use scenelang_assets::{Request, family_of, furnish};
use scenelang_layout::Vec3;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// The names of all families, as phrases.
pub fn families() -> impl Iterator<Item = &'static str> {
    include_str!("../../src/lexicon.txt")
        .lines()
        .filter(|l| !l.starts_with('#'))
        .filter_map(|l| l.split_once(':'))
        .map(|(family, _)| family)
}

/// The language's table of usual sizes.
pub fn sizes() -> BTreeMap<String, Vec3> {
    let mut table = BTreeMap::new();
    for line in include_str!("../../../lang/std/sizes.txt").lines() {
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().collect();
        if words.is_empty() {
            continue;
        }
        assert_eq!(words.len(), 4, "{line}");
        let size = Vec3::from_iterator(words[1..].iter().map(|n| n.parse().expect("a number")));
        assert!(size.iter().all(|c: &f64| *c > 0.0 && *c < 12.0), "{line}");
        assert!(table.insert(words[0].replace('_', " "), size).is_none(), "twice: {line}");
    }
    table
}

#[test]
fn every_noun_with_a_usual_size_has_a_family() {
    let sizes = sizes();
    assert!(sizes.len() >= 200, "{}", sizes.len());
    let unknown: Vec<_> = sizes.keys().filter(|n| family_of(n, "").is_none()).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    for family in families() {
        let name = family.replace('_', " ");
        assert!(sizes.contains_key(&name), "no usual size for {name}");
    }
}

/// What the requests of the development set ask for, by the nouns of those who annotated them.
fn requested() -> BTreeSet<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/requests/development");
    let mut nouns = BTreeSet::new();
    for entry in fs::read_dir(folder).expect("the requests are there") {
        let path = entry.expect("a file").path();
        if !path.to_string_lossy().ends_with(".expect.json") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("it is text");
        let objects = text.split_once("\"objects\": [").expect("it lists objects").1;
        let names = objects.lines().take_while(|line| line.trim_end() != " ],");
        let names = names.filter_map(|line| line.trim().strip_prefix("\"name\": \"")?.split('"').next());
        nouns.extend(names.map(|name| name.replace('_', " ")));
    }
    nouns
}

#[test]
fn nouns_of_the_requests_have_a_family_and_the_rest_is_listed() {
    let nouns = requested();
    assert!(nouns.len() > 200, "{}", nouns.len());
    let boxes: Vec<&str> = nouns.iter().map(String::as_str).filter(|noun| family_of(noun, "").is_none()).collect();
    let known = [
        "architectural model",
        "basketball hoop",
        "bell",
        "cello stand",
        "cheese dome",
        "fountain",
        "material sample",
        "mobile",
        "paper roll",
        "pizza peel",
        "toy train",
    ];
    assert_eq!(boxes, known);
    assert!(boxes.len() * 20 <= nouns.len(), "{} of {}", boxes.len(), nouns.len());
}

#[test]
fn nouns_are_taken_for_what_they_are() {
    let nouns = include_str!("nouns.txt");
    let lines = nouns.lines().map(|n| format!("{n} -> {}", family_of(n, "").unwrap_or("?")));
    insta::assert_snapshot!(lines.collect::<Vec<_>>().join("\n"));
}

#[test]
fn categories_and_names_help_each_other() {
    for (category, name, want) in [
        ("", "readingChair", Some("armchair")),
        ("", "chair[3]", Some("chair")),
        ("", "deskLeft", Some("desk")),
        ("", "lamp_a", Some("lamp")),
        ("furniture", "desk2", Some("desk")),
        ("lamp", "ceilingLamp", Some("ceiling_light")),
        ("lamp", "desk", Some("lamp")),
        ("table", "lampTable", Some("table")),
        ("chair", "officeChair", Some("chair")),
        ("", "x", None),
        ("thing", "y", None),
    ] {
        assert_eq!(family_of(category, name), want, "{category:?} {name:?}");
    }
}

#[test]
fn lamps_are_told_apart_by_words_and_size() {
    let top = |category, features, size: [f64; 3]| {
        let r = Request { name: "lamp", category, features, size: Some(Vec3::from(size)), ..Request::default() };
        furnish(&r).mesh
    };
    let floor = top("floor lamp", "", [0.4, 1.6, 0.4]);
    assert_eq!(top("lamp", "", [0.4, 1.6, 0.4]), floor);
    assert_eq!(top("lamp", "", [0.3, 0.5, 0.3]), top("table lamp", "", [0.3, 0.5, 0.3]));
    assert_eq!(top("lamp", "hangs from the ceiling", [0.4, 0.2, 0.4]), top("ceiling light", "", [0.4, 0.2, 0.4]));
    assert_ne!(top("lamp", "pendant", [0.4, 1.6, 0.4]), floor);
}
