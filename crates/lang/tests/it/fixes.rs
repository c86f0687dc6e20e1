//! Fixes. `fixes/safe.md` holds pairs of programs: before, and after all safe fixes. `fixes/unsafe.md` holds programs with
//! one finding, followed by what each of its fixes makes of it.

use crate::blocks::blocks;
use crate::spec;
use scenelang_base::{Applicability, Diagnostic, Edit, TextRange, fix};
use scenelang_lang::fixes::fix_all;
use scenelang_lang::sources::Loader;
use scenelang_lang::{Options, compile_text};
use std::path::{Path, PathBuf};
use std::{fs, io};

const NAME: &str = "room.scene";

/// A program without any other file.
struct Alone<'t>(&'t str);

impl Loader for Alone<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let here = (path == Path::new(NAME)).then(|| self.0.as_bytes().to_vec());
        here.ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// The text after all safe fixes.
fn fixed(text: &str) -> String {
    let fixed = fix_all(NAME, Path::new(NAME), Options::default(), Applicability::Safe, &Alone(text));
    fixed.files.into_iter().next().map_or_else(|| text.to_owned(), |file| file.text)
}

fn found(text: &str) -> Vec<Diagnostic> {
    compile_text(NAME, Path::new(NAME), text, Options::default()).diagnostics
}

fn syntax_errors(text: &str) -> usize {
    found(text).iter().filter(|d| d.code.as_str().starts_with("E01")).count()
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/fixes").join(name);
    fs::read_to_string(path).unwrap()
}

#[test]
fn safe_fixes_make_what_they_say() {
    let blocks = blocks(&page("safe.md"));
    assert!(blocks.len() > 10 && blocks.len().is_multiple_of(2));
    for pair in blocks.chunks(2) {
        assert_eq!((pair[0].info.as_str(), pair[1].info.as_str()), ("scene", "scene after"));
        assert_eq!(fixed(&pair[0].text), pair[1].text, "safe.md:{}", pair[0].line);
    }
}

#[test]
fn every_unsafe_fix_makes_what_it_says() {
    let blocks = blocks(&page("unsafe.md"));
    let mut at = 0;
    while at < blocks.len() {
        let before = &blocks[at];
        let after = blocks[at + 1..].iter().take_while(|b| b.info == "scene after").count();
        let found = found(&before.text);
        let fixes: Vec<_> = found.iter().flat_map(|d| &d.fixes).collect();
        let line = before.line;
        assert_eq!(fixes.len(), after, "unsafe.md:{line}: {found:?}");
        for (fix_given, wanted) in fixes.iter().zip(&blocks[at + 1..]) {
            let edits: Vec<Edit<TextRange>> =
                fix_given.edits.iter().map(|e| Edit { place: e.place.range, text: e.text.clone() }).collect();
            let applied = fix::apply(&before.text, [&edits]);
            assert_eq!(applied.text, wanted.text, "unsafe.md:{}: {}", wanted.line, fix_given.title);
            assert!(!fix_given.title.is_empty());
        }
        at += after + 1;
    }
}

/// Programs of all kinds: the tests' own, good and bad, and the book's.
fn programs() -> Vec<(String, String)> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it");
    let mut out = Vec::new();
    let mut add = |path: &Path, text: &str| {
        let blocks = blocks(text).into_iter().filter(|b| b.is_scene());
        out.extend(blocks.map(|b| (format!("{}:{}", path.display(), b.line), b.text)));
    };
    for folder in ["cases", "fixes"] {
        let mut files: Vec<PathBuf> = fs::read_dir(tests.join(folder)).unwrap().map(|e| e.unwrap().path()).collect();
        files.sort();
        files.iter().for_each(|path| add(path, &fs::read_to_string(path).unwrap()));
    }
    spec::pages().iter().for_each(|page| add(&page.path, &page.text));
    for entry in fs::read_dir(tests.join("syntax")).unwrap() {
        let path = entry.unwrap().path();
        out.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
    }
    out
}

#[test]
fn fixing_makes_nothing_worse_and_once_is_enough() {
    let programs = programs();
    assert!(programs.len() > 300, "{}", programs.len());
    let mut changed = 0;
    for (at, text) in &programs {
        let after = fixed(text);
        changed += usize::from(after != *text);
        assert!(syntax_errors(&after) <= syntax_errors(text), "{at}:\n{after}");
        assert_eq!(fixed(&after), after, "{at}: fixing again changes it");
    }
    assert!(changed > 10, "only {changed} are changed");
}
