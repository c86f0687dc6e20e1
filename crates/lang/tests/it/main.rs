//! The front end as its users see it: programs in `cases/*.md` with the diagnostics they must have.
//!
//! A block fenced by ```` ```scene ```` is one program. A trailing comment `//~ CODE` says that a diagnostic of that
//! code starts on that line; `//~ CODE:COLUMN` fixes its column too; several are separated by blanks. Diagnostics and
//! comments must match exactly; warnings (W02 to W04) only where they are marked, and in the files `lint-*.md`, which
//! are about them. A block fenced by ```` ```scene core ```` is checked as core language. A block
//! ```` ```text ```` after a program gives what its constraints become, one a line.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod blocks;
mod fixes;
mod format;
mod incremental;
mod lints;
mod shape;
mod soup;
mod spec;
mod syntax;
mod tree;

use blocks::{Mark, agree, blocks, expected, relevant};
use scenelang_lang::print::Printed;
use scenelang_lang::{Compiled, Options, compile_text};
use std::path::Path;

/// The diagnostics of the main file, sorted.
pub fn found(compiled: &Compiled) -> Vec<Mark> {
    let file = compiled.sources.get(compiled.main);
    let places = compiled.diagnostics.iter().filter_map(|d| Some((d.code, d.primary.as_ref()?.place)));
    let mut out: Vec<Mark> = places
        .filter(|(_, place)| place.file == compiled.main)
        .map(|(code, place)| {
            let at = file.position(place.range.start);
            (at.line, code.to_string(), Some(at.column))
        })
        .collect();
    out.sort();
    out
}

#[test]
fn cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/cases");
    let mut files: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let mut wrong = String::new();
    let mut programs = 0;
    for file in files {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let blocks = blocks(&std::fs::read_to_string(&file).unwrap());
        for (i, block) in blocks.iter().enumerate() {
            if !block.is_scene() {
                continue;
            }
            programs += 1;
            let options = Options { core: block.words().contains(&"core") };
            let compiled = compile_text("case.scene", Path::new("case.scene"), &block.text, options);
            let wanted = expected(&block.text);
            let found = found(&compiled);
            let found = if name.starts_with("lint-") { found } else { relevant(found, &wanted) };
            if !agree(&found, &wanted) {
                let messages: Vec<_> = compiled.diagnostics.iter().map(|d| &d.message).collect();
                wrong +=
                    &format!("{name}:{}: expected {wanted:?}\n    found {found:?}\n    {messages:?}\n", block.line);
            }
            if let Some(text) = blocks.get(i + 1).filter(|b| b.info == "text") {
                let rows = compiled.program.as_ref().map_or(String::new(), |p| {
                    p.constraints.iter().map(|c| format!("{}\n", Printed(p, &c.formula))).collect()
                });
                if rows != text.text {
                    wrong += &format!("{name}:{}: expected\n{}found\n{rows}", text.line, text.text);
                }
            }
        }
    }
    assert!(programs > 20, "only {programs} programs found");
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// The scenes that a newcomer opens first, and the library, are as good as they can be.
#[test]
fn examples_and_library_raise_no_warning() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut programs: Vec<(String, String)> =
        scenelang_lang::library::FILES.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
    for entry in std::fs::read_dir(examples).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "scene") {
            programs.push((path.display().to_string(), std::fs::read_to_string(&path).unwrap()));
        }
    }
    assert!(programs.len() > 10);
    for (name, text) in programs {
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
        assert!(compiled.diagnostics.is_empty(), "{name}: {:#?}", compiled.diagnostics);
    }
}
