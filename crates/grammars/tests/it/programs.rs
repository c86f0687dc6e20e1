//! The programs that everything here is tried on: the examples, the standard library, the language book, and what its
//! grammar makes.

#[path = "../../../lang/tests/it/blocks.rs"]
#[allow(dead_code, reason = "other tests use the rest")]
mod blocks;
#[path = "../../../lang/tests/it/spec/ebnf.rs"]
pub mod ebnf;
#[path = "../../../lang/tests/it/spec/make.rs"]
mod make;

use blocks::Block;
use make::Maker;
use scenelang_lang::library;
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::{Kind, lex};
use std::fs;
use std::path::{Path, PathBuf};

/// A program and what it is called in messages.
pub struct Program {
    pub name: String,
    pub text: String,
}

/// The repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A page of the language book.
pub struct Page {
    pub path: PathBuf,
    pub blocks: Vec<Block>,
}

/// All pages, sorted by path.
pub fn pages() -> Vec<Page> {
    let mut out = Vec::new();
    let mut folders = vec![root().join("spec/src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                out.push(Page { blocks: blocks::blocks(&fs::read_to_string(&path).unwrap()), path });
            }
        }
    }
    out.sort_by(|a, b| a.path.cmp(&b.path));
    out
}

/// The examples and the standard library.
pub fn written() -> Vec<Program> {
    let folder = fs::read_dir(root().join("examples")).unwrap().map(|e| e.unwrap().path());
    let mut paths: Vec<PathBuf> = folder.filter(|p| p.extension().is_some_and(|e| e == "scene")).collect();
    paths.sort();
    let examples = paths.iter().map(|path| Program {
        name: path.file_name().unwrap().to_string_lossy().into_owned(),
        text: fs::read_to_string(path).unwrap(),
    });
    let library = library::FILES.iter().map(|(name, text)| Program { name: (*name).into(), text: (*text).into() });
    examples.chain(library).collect()
}

/// Every program of the language book, the broken ones too.
pub fn book() -> Vec<Program> {
    let of_page = |page: Page| {
        let scenes = page.blocks.into_iter().filter(Block::is_scene);
        scenes.map(move |b| Program { name: format!("{}:{}", page.path.display(), b.line), text: b.text })
    };
    pages().into_iter().flat_map(of_page).collect()
}

/// Statements that the grammar of the book makes, the same every time.
pub fn made(count: usize) -> Vec<Program> {
    let (rules, words) = (ebnf::of_page("grammar.md"), ebnf::of_page("lexical.md"));
    let statement = rules.iter().find(|(n, _)| n == "statement").unwrap().1.clone();
    let mut maker = Maker::new(&rules, &words, 3);
    let mut out = Vec::new();
    while out.len() < count {
        let mut tokens = Vec::new();
        maker.make(&statement, 14, &mut tokens);
        let text = tokens.join(" ");
        if text.len() < 2000 {
            out.push(Program { name: format!("made {}", out.len()), text });
        }
    }
    out
}

/// Whether the front end takes the text as it is.
pub fn is_well_formed(text: &str) -> bool {
    !parse_file(text).diagnostics.iter().any(|d| d.is_error())
}

/// Whether a number is too large for a double, which is an error but no matter of a grammar.
pub fn has_huge_number(text: &str) -> bool {
    let numbers = lex(text).into_iter().filter(|t| t.kind == Kind::Number);
    numbers.map(|t| text[t.range.bytes()].trim_end_matches(char::is_alphabetic)).any(|n| n.parse() == Ok(f64::INFINITY))
}
