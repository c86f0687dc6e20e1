//! The language book, judged: its layouts with the programs before them, row by row, and its drawings.
//!
//! A block `json layout` is a layout of the nearest program before it. Words behind it name the diagnostics that must be
//! found in the layout (`E0505`, `E0505:5`, `E0505:5:14`), ask for another judgement (`box`, `no-physics`, `opens-doors`, `core`, `all`), or
//! for a drawing, see `drawing`. In the program, a comment `//= …` at the end of a statement says what the layout must
//! make of it: `holds`, `fails`, `null`, `margin 0.25 m`, several separated by commas; unmarked statements must hold. A
//! code there is a diagnostic that only a layout brings up. `//= P-COLLIDE:a:b` is a physical rule that is violated
//! (`… null`: that cannot be judged, listed by `all`); there are no others. Where the layout has errors, only they are compared, unless
//! the word `judged` says that the rows are to be looked at all the same.
//!
//! `json report` gives some members of the report on the block before it; `text report` some lines, in order, of what a
//! person reads, `text compact report` and `text github report` of those formats. `json diff` gives some of what the two
//! layouts before it differ in; `toml settings` is a settings file, with the codes to be found in it.

#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "../../../lang/tests/it/blocks.rs"]
mod blocks;
mod drawing;

use crate::schemas::{faults, validator};
use blocks::{Block, Mark, agree, blocks, expected, relevant};
use scenelang_base::FileId;
use scenelang_engine::{check_file, check_layout_text};
use scenelang_lang::sources::Loader;
use scenelang_verify::compare::compare;
use scenelang_verify::report::model::{Finding, Row};
use scenelang_verify::report::{Human, compact, github, human};
use scenelang_verify::{Checked, Detail, Geometry, Opens, Options, settings};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::{fs, io};

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/src")
}

struct Page {
    name: String,
    blocks: Vec<Block>,
}

fn pages() -> Vec<Page> {
    let mut out = Vec::new();
    let mut folders = vec![book()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                let name = path.strip_prefix(book()).unwrap().to_string_lossy().replace('\\', "/");
                out.push(Page { name, blocks: blocks(&fs::read_to_string(&path).unwrap()) });
            }
        }
    }
    out.sort_by(|a, b| a.name.cmp(&b.name));
    out
}

/// The programs of a page by name; the one at hand is `room.scene`.
struct Files<'p> {
    page: &'p Page,
    main: &'p Block,
}

impl Loader for Files<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let name = path.to_string_lossy().replace('\\', "/");
        if name == name_of(self.main) {
            return Ok(self.main.text.clone().into_bytes());
        }
        let block = self.page.blocks.iter().find(|b| b.is_scene() && b.setting("name") == Some(name.as_str()));
        block.map(|b| b.text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

fn name_of(scene: &Block) -> &str {
    scene.setting("name").unwrap_or("room.scene")
}

fn options(block: &Block) -> (Options, scenelang_lang::Options) {
    let has = |word: &str| block.words().contains(&word);
    let mut options = Options {
        physics: !has("no-physics"),
        detail: Detail { all: has("all"), ..Detail::default() },
        ..Options::default()
    };
    if has("box") {
        options.geometry = Geometry::Box;
    }
    if has("opens-doors") {
        options.opens = Opens::Doors;
    }
    (options, scenelang_lang::Options { core: has("core") })
}

fn judged(page: &Page, scene: &Block, layout: &Block) -> Checked {
    let (name, loader) = ("room.layout.json", Files { page, main: scene });
    let (options, compile) = options(layout);
    check_layout_text(name, Path::new(name), layout.text.clone(), &options, compile, &loader)
}

/// A program by itself, from disk.
fn checked(page: &Page, scene: &Block) -> Checked {
    let folder = tempfile::tempdir().unwrap();
    for block in page.blocks.iter().filter(|b| b.is_scene()) {
        if let Some(name) = block.setting("name") {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, &block.text).unwrap();
        }
    }
    let path = folder.path().join(name_of(scene));
    fs::write(&path, &scene.text).unwrap();
    let compile = scenelang_lang::Options { core: scene.words().contains(&"core") };
    check_file(name_of(scene), &path, &Options::default(), compile)
}

/// What the `//=` of a line say: the line and one of the things.
fn says(text: &str) -> Vec<(u32, &str)> {
    let marks = |(i, line)| {
        let (_, marks): (&str, &str) = str::split_once(line, "//=")?;
        let marks = marks.split("//").next().unwrap_or_default();
        Some(marks.split(',').map(move |m| (i as u32 + 1, m.trim())))
    };
    text.lines().enumerate().filter_map(marks).flatten().collect()
}

/// Codes of what is proved without a layout.
fn is_proof(code: &str) -> bool {
    code.starts_with("E04") || code.starts_with("W04")
}

fn is_code(word: &str) -> bool {
    let code = word.split(':').next().unwrap_or_default();
    code.len() == 5 && code.starts_with(['E', 'W']) && code[1..].bytes().all(|b| b.is_ascii_digit())
}

fn found(findings: &[Finding], fits: impl Fn(&str) -> bool) -> Vec<Mark> {
    let place = |f: &Finding| f.span.as_ref().map_or(("", [0, 0]), |s| (s.file.as_str(), s.start)).1;
    let fitting = findings.iter().filter(|f| fits(f.span.as_ref().map_or("", |s| s.file.as_str())));
    let mut out: Vec<Mark> = fitting.map(|f| (place(f)[0], f.code.clone(), Some(place(f)[1]))).collect();
    out.sort();
    out
}

/// Whether codes and places agree, where the place may be left open altogether.
fn layout_agrees(found: &[Mark], wanted: &[&str]) -> bool {
    let mut open: Vec<&Mark> = found.iter().collect();
    let all = wanted.iter().all(|word| {
        let mut parts = word.split(':');
        let code = parts.next().unwrap_or_default();
        let (line, column) = (parts.next(), parts.next());
        let fits = |m: &&Mark| {
            m.1 == code
                && line.is_none_or(|l| l == m.0.to_string())
                && column.is_none_or(|c| m.2.is_some_and(|n| c == n.to_string()))
        };
        let at = open.iter().position(fits);
        at.map(|at| open.remove(at)).is_some()
    });
    all && open.is_empty()
}

/// What a row says other than it should.
fn differs(row: &Row, say: &str) -> bool {
    let word = match row.satisfied {
        Some(true) => "holds",
        Some(false) => "fails",
        None => "null",
    };
    match say.strip_prefix("margin ") {
        Some("null") => row.margin.is_some(),
        Some(margin) => {
            let (value, unit) = margin.split_once(' ').unwrap_or((margin, ""));
            let digits = value.split_once('.').map_or(0, |(_, d)| d.len());
            let got = row.margin.map(|m| format!("{:.digits$}", m + 0.0));
            got.as_deref() != Some(value) || row.unit.as_deref() != Some(unit)
        }
        None => say != word,
    }
}

fn rows_differ(scene: &Block, checked: &Checked, wrong: &mut Vec<String>) {
    let says = says(&scene.text);
    let rows = &checked.report.constraints;
    let mut used = vec![false; says.len()];
    for row in rows {
        let shown =
            format!("{} is {:?}, margin {:?} {:?}: {}", row.id, row.satisfied, row.margin, row.unit, row.message);
        if row.rule.is_some() && row.satisfied == Some(true) {
            continue;
        }
        if row.rule.is_some() {
            let wanted = says.iter().position(|(_, say)| {
                let (id, null) = say.strip_suffix(" null").map_or((*say, false), |id| (id, true));
                id == row.id && null == row.satisfied.is_none()
            });
            match wanted {
                Some(i) => used[i] = true,
                None => wrong.push(format!("not marked: {shown}")),
            }
            continue;
        }
        let span = row.span.as_ref().expect("a statement has a place");
        if span.file != name_of(scene) {
            continue;
        }
        let mut marked = false;
        for (i, (line, say)) in says.iter().enumerate() {
            if !(span.start[0]..=span.end[0]).contains(line) || is_code(say) || say.starts_with("P-") {
                continue;
            }
            (marked, used[i]) = (true, true);
            if differs(row, say) {
                wrong.push(format!("`{say}` in line {line}, but {shown}"));
            }
        }
        if !marked && row.satisfied != Some(true) {
            wrong.push(format!("not marked: {shown}"));
        }
    }
    for ((line, say), used) in says.iter().zip(used) {
        if !used && !is_code(say) {
            wrong.push(format!("`{say}` in line {line} is about nothing"));
        }
    }
}

#[test]
fn layouts_are_judged_as_they_say() {
    let (mut count, mut wrong) = (0, String::new());
    for page in &pages() {
        for (i, layout) in page.blocks.iter().enumerate().filter(|(_, b)| b.info.starts_with("json layout")) {
            let scene = page.blocks[..i].iter().rfind(|b| b.is_scene() && b.info != "scene formatted");
            let Some(scene) = scene else { panic!("{}:{}: no program", page.name, layout.line) };
            count += 1;
            let checked = judged(page, scene, layout);
            let mut here = Vec::new();
            let words = layout.words();
            let wanted: Vec<&str> = words.iter().copied().filter(|w| is_code(w)).collect();
            let in_layout = found(&checked.report.diagnostics, |file| !file.ends_with(".scene"));
            if !layout_agrees(&in_layout, &wanted) {
                here.push(format!("in the layout {in_layout:?}, not {wanted:?}"));
            }
            let broken = wanted.iter().any(|w| w.starts_with('E'));
            if !broken || words.contains(&"judged") {
                let mut marks = expected(&scene.text);
                let extra = says(&scene.text).into_iter().filter(|(_, say)| is_code(say));
                marks.extend(extra.map(|(line, say)| (line, say.to_owned(), None)));
                // What is proved of a program is said where it is checked alone.
                marks.retain(|(_, code, _)| !is_proof(code));
                marks.sort();
                let in_scene = found(&checked.report.diagnostics, |file| file == name_of(scene));
                let in_scene = relevant(in_scene, &marks);
                if !agree(&in_scene, &marks) {
                    here.push(format!("in the program {in_scene:?}, not {marks:?}"));
                }
                rows_differ(scene, &checked, &mut here);
            }
            if let Some(problem) = drawing::compare(&book().join("pictures"), layout, &checked) {
                here.push(problem);
            }
            if !here.is_empty() {
                wrong += &format!("{}:{}:\n    {}\n", page.name, layout.line, here.join("\n    "));
                for finding in &checked.report.diagnostics {
                    wrong += &format!("    ({}: {})\n", finding.code, finding.message);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(count > 60, "only {count} layouts");
}

#[test]
fn programs_are_checked_as_they_say() {
    let mut wrong = String::new();
    for page in &pages() {
        for scene in page.blocks.iter().filter(|b| b.is_scene() && b.info != "scene formatted") {
            let wanted = expected(&scene.text);
            let found = found(&checked(page, scene).report.diagnostics, |file| file == name_of(scene));
            let mut found = relevant(found, &wanted);
            // An example that shows what fails may do so by contradicting itself.
            if says(&scene.text).iter().any(|(_, say)| say.starts_with("fails") || say.starts_with("P-")) {
                found.retain(|(_, code, _)| !is_proof(code) || wanted.iter().any(|w| w.1 == *code));
            }
            if !agree(&found, &wanted) {
                wrong += &format!("{}:{}: expected {wanted:?}\n    found {found:?}\n", page.name, scene.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// A layout block with the program it belongs to, judged.
fn layout_at(page: &Page, i: usize) -> Checked {
    let scene = page.blocks[..i].iter().rfind(|b| b.is_scene()).expect("a program");
    judged(page, scene, &page.blocks[i])
}

#[test]
fn comparisons_are_as_shown() {
    let mut count = 0;
    for page in &pages() {
        for (i, block) in page.blocks.iter().enumerate().filter(|(_, b)| b.info == "json diff") {
            let layouts: Vec<usize> = (0..i).filter(|i| page.blocks[*i].info.starts_with("json layout")).collect();
            let [.., before, after] = layouts[..] else { panic!("{}:{}: two layouts", page.name, block.line) };
            let whole = compare(&layout_at(page, before), &layout_at(page, after), 1e-3);
            let whole = serde_json::to_value(whole).unwrap();
            assert!(contains(&whole, &serde_json::from_str(&block.text).unwrap()), "{}: {whole:#}", page.name);
            assert_eq!(faults(&validator("diff"), &whole), Vec::<String>::new());
            count += 1;
        }
    }
    assert!(count > 0);
}

#[test]
fn settings_are_read_as_they_say() {
    let mut count = 0;
    for page in &pages() {
        for block in page.blocks.iter().filter(|b| b.info.starts_with("toml")) {
            // The user's own file takes less than that of a workspace, and an address besides.
            let own = block.info.ends_with(" own");
            let read = |text| {
                if own {
                    settings::read_own(text, FileId(0)).map(drop)
                } else {
                    settings::read(text, FileId(0)).map(drop)
                }
            };
            let found = read(&block.text).err().unwrap_or_default();
            let found: Vec<&str> = found.iter().map(|d| d.code.as_str()).collect();
            let wanted = if own { Vec::new() } else { block.words()[2..].to_vec() };
            assert_eq!(found, wanted, "{}:{}", page.name, block.line);
            count += 1;
        }
    }
    assert!(count > 2);
}

#[test]
fn layouts_and_reports_of_the_book_fit_their_schemas() {
    let [layouts, reports] = ["layout", "report"].map(validator);
    let mut wrong = String::new();
    for page in &pages() {
        for (i, layout) in page.blocks.iter().enumerate().filter(|(_, b)| b.info.starts_with("json layout")) {
            let at = format!("{}:{}", page.name, layout.line);
            let Some(scene) = page.blocks[..i].iter().rfind(|b| b.is_scene()) else { panic!("{at}: no program") };
            let report = judged(page, scene, layout).report;
            let good = !report.diagnostics.iter().any(|d| d.severity == "error" && d.code.starts_with("E05"));
            for fault in faults(&reports, &serde_json::to_value(&report).unwrap()) {
                wrong += &format!("{at}: report {fault}\n");
            }
            match serde_json::from_str(&layout.text) {
                Ok(document) if good => {
                    faults(&layouts, &document).iter().for_each(|f| wrong += &format!("{at}: {f}\n"))
                }
                Ok(_) => {}
                Err(e) => assert!(!good, "{at}: {e}"),
            }
        }
        for scene in page.blocks.iter().filter(|b| b.is_scene() && b.info != "scene formatted") {
            for fault in faults(&reports, &serde_json::to_value(&checked(page, scene).report).unwrap()) {
                wrong += &format!("{}:{}: report {fault}\n", page.name, scene.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Whether all that `part` says is in `whole`; of an array, each item in some item.
fn contains(whole: &Value, part: &Value) -> bool {
    match (whole, part) {
        (Value::Object(whole), Value::Object(part)) => {
            part.iter().all(|(key, value)| whole.get(key).is_some_and(|w| contains(w, value)))
        }
        (Value::Array(whole), Value::Array(part)) if part.iter().any(Value::is_object) => {
            part.iter().all(|value| whole.iter().any(|w| contains(w, value)))
        }
        (Value::Number(a), Value::Number(b)) => (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-9,
        _ => whole == part,
    }
}

#[test]
fn reports_are_as_shown() {
    let mut wrong = String::new();
    for page in &pages() {
        for (i, block) in page.blocks.iter().enumerate().filter(|(_, b)| b.info.ends_with(" report")) {
            let subject =
                page.blocks[..i].iter().rposition(|b| !b.info.ends_with(" report")).expect("a block before it");
            let subject_block = &page.blocks[subject];
            let checked = if subject_block.is_scene() {
                checked(page, subject_block)
            } else {
                let scene = page.blocks[..subject].iter().rfind(|b| b.is_scene()).expect("a program");
                judged(page, scene, subject_block)
            };
            let at = format!("{}:{}", page.name, block.line);
            if block.info.starts_with("json") {
                let whole = serde_json::to_value(&checked.report).unwrap();
                let part: Value = serde_json::from_str(&block.text).unwrap_or_else(|e| panic!("{at}: {e}"));
                if !contains(&whole, &part) {
                    wrong += &format!("{at}: not in {whole:#}\n");
                }
            } else {
                let whole = match block.info.as_str() {
                    "text compact report" => compact(&checked.report, Human::default()),
                    "text github report" => github(&[checked.report]),
                    _ => human(&checked, Human::default()),
                };
                let mut rest = whole.lines();
                for line in block.text.lines().filter(|l| !l.trim().is_empty()) {
                    if !rest.any(|l| l.trim_end() == line.trim_end()) {
                        wrong += &format!("{at}: `{line}` is not, or not there, in\n{whole}\n");
                        break;
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}
