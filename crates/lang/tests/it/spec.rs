//! The language book, executed: every block of `spec/src` is compiled, every link leads somewhere, every name of the
//! language is in it.
//!
//! What a block is, its first word says: `scene` a program, compiled here with its marks (`scene core`: as core
//! language; `name=parts.scene`: a file that other blocks of the page import); `text constraints` what the program
//! before it becomes; `scene formatted` what the formatter makes of the program before it; `ebnf` a part of the grammar
//! (see `grammar`). Layouts and reports are judged by the verifier's tests, what commands print by those of the
//! command line. Any other block is an error.

#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

mod ebnf;
mod grammar;
mod make;
mod railroad;
mod recognise;

use crate::blocks::{Block, agree, blocks, expected, relevant};
use crate::found;
use scenelang_base::codes;
use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::compile::{Compiled, Options, compile_main};
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_lang::print::Printed;
use scenelang_lang::sources::Loader;
use scenelang_lang::{library, natives};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// First letters of codes that later stages report: static proofs, and what concerns layouts and models.
const LATER: [&str; 7] = ["E04", "E05", "E07", "W04", "W05", "W06", "W07"];

/// Where the book is.
pub fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/src")
}

/// A page: its path below `spec/src`, its text, its blocks.
pub struct Page {
    pub path: PathBuf,
    pub text: String,
    pub blocks: Vec<Block>,
}

impl Page {
    fn at(&self, line: usize) -> String {
        format!("{}:{line}", self.path.display())
    }
}

/// All pages, sorted by path.
pub fn pages() -> Vec<Page> {
    let mut out = Vec::new();
    let mut folders = vec![book()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                let text = fs::read_to_string(&path).unwrap();
                let path = path.strip_prefix(book()).unwrap().to_owned();
                out.push(Page { path, blocks: blocks(&text), text });
            }
        }
    }
    out.sort_by(|a, b| a.path.cmp(&b.path));
    out
}

/// The named programs of a page, for imports.
struct Files<'p>(&'p [Block]);

impl Loader for Files<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let name = path.to_string_lossy().replace('\\', "/");
        let block = self.0.iter().find(|b| b.is_scene() && b.setting("name") == Some(name.as_str()));
        block.map(|b| b.text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

fn compiled(block: &Block, page: &Page) -> Compiled {
    let name = block.setting("name").unwrap_or("room.scene");
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new(name, name, block.text.as_str()));
    compile_main(main, Options { core: block.words().contains(&"core") }, &Files(&page.blocks), sources)
}

#[test]
fn programs_compile_as_they_say() {
    let (mut programs, mut wrong) = (0, String::new());
    for page in &pages() {
        for block in page.blocks.iter().filter(|b| b.is_scene()) {
            programs += 1;
            let later = |code: &str| LATER.iter().any(|l| code.starts_with(l));
            let wanted: Vec<_> = expected(&block.text).into_iter().filter(|m| !later(&m.1)).collect();
            let compiled = compiled(block, page);
            let found = relevant(found(&compiled), &wanted);
            if !agree(&found, &wanted) {
                let messages: Vec<_> = compiled.diagnostics.iter().map(|d| &d.message).collect();
                let at = page.at(block.line);
                wrong += &format!("{at}: expected {wanted:?}\n    found {found:?}\n    {messages:?}\n");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(programs > 200, "only {programs} programs found");
}

#[test]
fn what_programs_become_is_as_they_say() {
    let mut wrong = String::new();
    for page in &pages() {
        for (i, block) in page.blocks.iter().enumerate() {
            let made = match block.info.as_str() {
                "text constraints" => {
                    let scene = page.blocks[..i].iter().rfind(|b| b.is_scene()).expect("a program before it");
                    let compiled = compiled(scene, page);
                    compiled.program.as_ref().map_or(String::new(), |p| {
                        p.constraints.iter().map(|c| format!("{}\n", Printed(p, &c.formula))).collect()
                    })
                }
                "scene formatted" => format(&page.blocks[i - 1].text, &FormatOptions::default()),
                _ => continue,
            };
            if made != block.text {
                wrong += &format!("{}: expected\n{}found\n{made}", page.at(block.line), block.text);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn every_block_is_executed() {
    let mut wrong = String::new();
    for page in &pages() {
        let mut before: Option<&Block> = None;
        for block in &page.blocks {
            let after = |wanted: fn(&Block) -> bool| before.is_some_and(wanted);
            let judged: fn(&Block) -> bool = |b| b.is_scene() || b.info.starts_with("json layout");
            let known = match block.words().as_slice() {
                ["scene", "formatted"] => after(Block::is_scene),
                ["scene", rest @ ..] => rest.iter().all(|w| *w == "core" || w.starts_with("name=")),
                // Layouts, reports and settings are for the verifier's tests.
                ["text", "constraints"] | ["json", "layout", ..] => {
                    page.blocks.iter().take_while(|b| b.line < block.line).any(Block::is_scene)
                }
                ["json", "diff"] => after(|b| b.info.starts_with("json layout")),
                ["toml", "settings", ..] => true,
                ["json", "report"] | ["text", "report"] | ["text", "compact" | "github", "report"] => {
                    after(judged) || after(|b| b.info.ends_with(" report"))
                }
                // What commands print is for the command line's tests.
                ["text", "syntax" | "hir"] | ["json", "syntax" | "hir" | "constraints"] => {
                    page.path.parent() == Some(Path::new("")) && before.is_some()
                }
                ["json", "repair"] => {
                    page.path == Path::new("command-line.md") && after(|b| b.info.starts_with("json layout"))
                }
                ["json", "solve"] => page.path == Path::new("command-line.md") && after(Block::is_scene),
                ["text", "trace"] => page.path == Path::new("command-line.md") && after(Block::is_scene),
                ["text", "query", ..] => {
                    page.path == Path::new("command-line.md")
                        && after(|b| b.info.starts_with("json layout") || b.info.starts_with("text query"))
                }
                ["json", "jobs"] => page.path == Path::new("many-scenes.md"),
                ["toml", "own"] => ["models.md", "furniture.md"].iter().any(|name| page.path == Path::new(name)),
                ["text", "asking"] => page.path == Path::new("models.md"),
                ["text", "model"] => page.path == Path::new("models.md") && before.is_some(),
                ["sh"] | ["json", "client"] | ["js", "three"] => page.path.starts_with("for"),
                // A test of the exporter compiles them.
                ["csharp"] | ["text", "editor"] => page.path == Path::new("for/unity.md"),
                ["ebnf"] => page.path.starts_with("reference"),
                _ => false,
            };
            if !known {
                wrong += &format!("{}: nothing executes a block `{}`\n", page.at(block.line), block.info);
            }
            before = Some(block);
        }
        let mut fenced = false;
        let mut gap = true;
        for (i, line) in page.text.lines().enumerate() {
            if line.starts_with("```") {
                fenced = !fenced;
            } else if !fenced && (line.trim_start().starts_with("```") || line.trim_start().starts_with("~~~")) {
                wrong += &format!("{}: a fence begins its line and is made of backquotes\n", page.at(i + 1));
            } else if !fenced && gap && line.starts_with("    ") && !line.trim().is_empty() {
                wrong += &format!("{}: an indented block is not executed\n", page.at(i + 1));
            }
            gap = line.trim().is_empty();
        }
        assert!(!fenced, "{}: a block does not close", page.path.display());
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Links of a page outside its blocks: the line and the target.
fn links(page: &Page) -> Vec<(usize, String)> {
    let mut out = Vec::new();
    let mut fenced = false;
    for (i, line) in page.text.lines().enumerate() {
        fenced ^= line.starts_with("```");
        if fenced {
            continue;
        }
        // Inline code holds no links.
        let prose: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
        for (at, _) in prose.match_indices("](") {
            let target = prose[at + 2..].split(')').next().unwrap_or_default();
            out.push((i + 1, target.to_owned()));
        }
    }
    out
}

/// The anchors that headings make, as GitHub and mdBook name them.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut fenced = false;
    let mut out = BTreeSet::new();
    for line in text.lines() {
        fenced ^= line.starts_with("```");
        if !fenced && line.starts_with('#') {
            let title = line.trim_start_matches('#').trim().to_lowercase();
            let kept = title.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
            out.insert(kept.map(|c| if c == ' ' { '-' } else { c }).collect());
        }
    }
    out
}

#[test]
fn links_lead_somewhere_and_the_summary_lists_every_page() {
    let (pages, mut wrong) = (pages(), String::new());
    for page in &pages {
        for (line, target) in links(page) {
            if target.starts_with("http://") || target.starts_with("https://") {
                continue;
            }
            let (file, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let path = if file.is_empty() {
                book().join(&page.path)
            } else {
                book().join(page.path.parent().unwrap()).join(file)
            };
            let text = fs::read_to_string(&path);
            let found = text.is_ok_and(|text| anchor.is_empty() || anchors(&text).contains(anchor));
            if !found {
                wrong += &format!("{}: `{target}` leads nowhere\n", page.at(line));
            }
        }
    }
    let summary = fs::read_to_string(book().join("SUMMARY.md")).unwrap();
    for page in pages.iter().filter(|p| p.path != Path::new("SUMMARY.md")) {
        let path = page.path.to_string_lossy().replace('\\', "/");
        if !summary.contains(&format!("({path})")) {
            wrong += &format!("SUMMARY.md does not list {path}\n");
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn every_picture_is_shown() {
    let text: String = pages().iter().map(|p| p.text.clone()).collect();
    let mut wrong = String::new();
    for folder in [book().join("pictures"), book().join("pictures/grammar")] {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_file() && !text.contains(&format!("/{name})")) {
                wrong += &format!("no page shows {name}\n");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn every_name_of_the_language_is_in_the_reference() {
    let reference: String =
        pages().iter().filter(|p| p.path.starts_with("reference")).map(|p| p.text.clone()).collect();
    let mut names: Vec<&str> = natives::BUILT_INS.iter().map(|s| s.name).collect();
    names.extend(natives::OBJECT_PROPERTIES.iter().chain(natives::REGION_PROPERTIES).map(|p| p.name));
    names.extend(natives::SIDES.iter().map(|(word, _)| *word));
    names.sort_unstable();
    names.dedup();
    let lacking: Vec<&str> = names
        .into_iter()
        .filter(|n| !reference.contains(&format!("`{n}`")) && !reference.contains(&format!("`{n}(")))
        .collect();
    assert!(lacking.is_empty(), "the reference does not name {lacking:?}");
}

#[test]
fn the_library_chapter_holds_every_predicate_as_it_is() {
    let chapter: Vec<Page> = pages().into_iter().filter(|p| p.path.starts_with("std")).collect();
    let programs: Vec<&Block> = chapter.iter().flat_map(|p| &p.blocks).filter(|b| b.is_scene()).collect();
    let mut wrong = String::new();
    let folded = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for (file, parsed) in library::FILES.iter().zip(library::parsed()) {
        for (offset, stmt) in &parsed.statements {
            let scenelang_lang::ast::StmtKind::Predicate { name, .. } = &stmt.kind else { continue };
            let source = folded(&file.1[stmt.range.shifted(*offset).bytes()]);
            if !programs.iter().any(|b| folded(&b.text).contains(&format!("{source};"))) {
                wrong += &format!("`{}`: its definition is not in the book, or another\n", name.text);
            }
            let heading = format!("\n## `{}(", name.text);
            let Some(page) = chapter.iter().find(|p| p.text.contains(&heading)) else {
                wrong += &format!("`{}` has no section\n", name.text);
                continue;
            };
            let section = page.text.split(&heading).nth(1).unwrap().split("\n## ").next().unwrap();
            for needed in ["//= holds", "//= fails", ".svg)", stmt.doc.lines().next().unwrap_or_default()] {
                if !section.contains(needed) {
                    wrong += &format!("the section on `{}` lacks `{needed}`\n", name.text);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn decisions_are_numbered_and_listed() {
    let pages = pages();
    let list = &pages.iter().find(|p| p.path == Path::new("decisions.md")).expect("decisions.md").text;
    let mut wrong = String::new();
    for number in 1.. {
        let mark = format!("(**D{number}**)");
        let holders: Vec<&Page> = pages.iter().filter(|p| p.text.contains(&mark)).collect();
        let row = list.lines().find(|l| l.starts_with(&format!("| D{number} |")));
        match (holders.as_slice(), row) {
            ([], None) => break,
            ([page], Some(row)) if page.text.matches(&mark).count() == 1 => {
                if !row.contains(&format!("({}#", page.path.to_string_lossy().replace('\\', "/"))) {
                    wrong += &format!("D{number} is in {}, not where decisions.md says\n", page.path.display());
                }
            }
            (holders, row) => {
                let places: Vec<_> = holders.iter().map(|p| &p.path).collect();
                wrong += &format!("D{number} is in {places:?}; in decisions.md: {}\n", row.is_some());
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn usual_sizes_are_as_listed() {
    let page = fs::read_to_string(book().join("std/sizes.md")).unwrap();
    let mut count = 0;
    for line in page.lines() {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [category, rest @ ..] = cells.as_slice() else { continue };
        let size: Vec<f64> = rest.iter().filter_map(|c| c.parse().ok()).collect();
        let Ok(size) = <[f64; 3]>::try_from(size) else { continue };
        count += 1;
        assert_eq!(library::usual_size(category), Some(size), "{category}");
    }
    assert!(count >= 10, "only {count} sizes");
    for (text, head) in [("blue armchair", "armchair"), ("oak dining table", "dining table"), ("Chairs", "chair")] {
        assert_eq!(library::usual_size(text), library::usual_size(head), "{text}");
    }
}

#[test]
fn every_code_has_its_page() {
    let pages = pages();
    let mut wrong = String::new();
    let index = pages.iter().find(|p| p.path == Path::new("codes/README.md")).expect("codes/README.md");
    for (code, title) in codes::ALL {
        let path = format!("codes/{code}.md");
        let Some(page) = pages.iter().find(|p| p.path == Path::new(&path)) else {
            wrong += &format!("{path} is missing\n");
            continue;
        };
        if !page.text.starts_with(&format!("# {code}: {title}\n")) {
            wrong += &format!("{path} does not start with `# {code}: {title}`\n");
        }
        if !index.text.contains(&format!("[{code}]({code}.md)")) || !index.text.contains(title) {
            wrong += &format!("codes/README.md does not list {code} as it is called\n");
        }
        for part in ["## Why", "## Example", "## What to do"] {
            if !page.text.contains(&format!("\n{part}\n")) {
                wrong += &format!("{path} has no `{part}`\n");
            }
        }
        let in_prose = PROSE.iter().any(|start| code.as_str().starts_with(start));
        if page.blocks.is_empty() && !in_prose {
            wrong += &format!("{path} has no example\n");
        }
        let shown = page.blocks.iter().any(|b| b.info.contains(code.as_str()) || b.text.contains(code.as_str()));
        if !shown && !code.as_str().starts_with('V') && !in_prose {
            wrong += &format!("no block of {path} is marked with {code}\n");
        }
    }
    let known = codes::ALL.len() + 1;
    let written = pages.iter().filter(|p| p.path.starts_with("codes")).count();
    assert!(wrong.is_empty(), "\n{wrong}");
    assert_eq!(written, known, "pages of codes that do not exist");
}

/// Codes, or their first letters, that no text in a book can trigger: files that are not there or not text, scenes that
/// were edited, those of furnishing, and those of models.
const PROSE: [&str; 14] = [
    "E0001", "E0003", "E0004", "E0006", "E0008", "E0009", "E07", "W0504", "W0505", "W0601", "W0602", "W0603", "W0604",
    "W07",
];
