//! The front end as its users see it: programs in `cases/*.md` with the diagnostics they must have.
//!
//! A block fenced by ```` ```scene ```` is one program. A trailing comment `//~ CODE` says that a diagnostic of that
//! code starts on that line; `//~ CODE:COLUMN` fixes its column too; several are separated by blanks. Diagnostics and
//! comments must match exactly. A block fenced by ```` ```scene core ```` is checked as core language. A block
//! ```` ```text ```` after a program gives what its constraints become, one a line.

use scenelang_lang::print::Printed;
use scenelang_lang::{Options, compile_text};
use std::path::Path;

struct Block {
    line: usize,
    info: String,
    text: String,
}

fn blocks(markdown: &str) -> Vec<Block> {
    let mut out: Vec<Block> = Vec::new();
    let mut open = false;
    for (i, line) in markdown.lines().enumerate() {
        match (open, line.strip_prefix("```")) {
            (false, Some(info)) => {
                out.push(Block { line: i + 2, info: info.trim().into(), text: String::new() });
                open = true;
            }
            (true, Some(_)) => open = false,
            (true, None) => {
                let block = out.last_mut().unwrap();
                block.text.push_str(line);
                block.text.push('\n');
            }
            (false, None) => {}
        }
    }
    out
}

/// (line, code, column if given), sorted.
fn expected(text: &str) -> Vec<(u32, String, Option<u32>)> {
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let Some((_, marks)) = line.split_once("//~") else { continue };
        for mark in marks.split_whitespace() {
            let (code, column) = match mark.split_once(':') {
                Some((code, column)) => (code, Some(column.parse().unwrap())),
                None => (mark, None),
            };
            out.push((i as u32 + 1, code.to_owned(), column));
        }
    }
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
            if !block.info.starts_with("scene") {
                continue;
            }
            programs += 1;
            let options = Options { core: block.info.contains("core") };
            let compiled = compile_text("case.scene", Path::new("case.scene"), &block.text, options);
            let file = compiled.sources.get(compiled.main);
            let mut found: Vec<(u32, String, Option<u32>)> = compiled
                .diagnostics
                .iter()
                .map(|d| {
                    let at = file.position(d.primary.as_ref().unwrap().place.range.start);
                    (at.line, d.code.to_string(), Some(at.column))
                })
                .collect();
            found.sort();
            let wanted = expected(&block.text);
            let same = found.len() == wanted.len()
                && found.iter().zip(&wanted).all(|(f, w)| (f.0, &f.1) == (w.0, &w.1) && (w.2.is_none() || w.2 == f.2));
            if !same {
                let messages: Vec<_> = compiled.diagnostics.iter().map(|d| &d.message).collect();
                wrong += &format!("{name}:{}: expected {wanted:?}\n    found {found:?}\n    {messages:?}\n", block.line);
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
