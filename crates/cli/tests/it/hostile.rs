//! Bad input: an error or a result, never a panic, a hang or an overflow.
//!
//! The thousands of variations go through the front end in this process; files that are bad as files go through the
//! binary. A panic or an overflow ends the test; a hang is ended by the test runner (and, for the binary, by `support`).

use crate::support::{EXAMPLES, example, for_each_example, root, scenelang, scenelang_with_input};
use scenelang_lang::{Options, compile_text};
use std::fs;
use std::path::Path;

/// Compiles a text, and formats it if it can be: whatever it is, there is a program or an error.
fn swallow(text: &str) {
    let compiled = compile_text("bad.scene", Path::new("bad.scene"), text, Options::default());
    assert!(compiled.program.is_some() != compiled.has_errors(), "neither a program nor an error, or both:\n{text}");
    for d in &compiled.diagnostics {
        let range = d.primary.as_ref().map(|l| l.place.range).unwrap_or_default();
        assert!(range.start <= range.end && range.end as usize <= text.len(), "{d:?} points outside:\n{text}");
    }
}

mod every_prefix {
    use super::*;

    fn is_swallowed(name: &str) {
        let text = fs::read_to_string(example(name)).unwrap();
        for (end, _) in text.char_indices() {
            swallow(&text[..end]);
        }
    }
    for_each_example!(is_swallowed);
}

/// A repeatable stream of numbers (splitmix64).
pub struct Dice(pub u64);

impl Dice {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }
}

/// What a slip of the hand, or malice, puts into a program.
const SPLINTERS: [&str; 28] = [
    ";",
    "(",
    ")",
    "[",
    "]",
    "{",
    "\"",
    "/*",
    "*/",
    "//",
    "<-",
    "<",
    "=",
    "-",
    "..",
    ".",
    ",",
    "forall x in objects: ",
    "not ",
    " where ",
    "1e999",
    "0/0",
    "\0",
    "\u{feff}",
    "é",
    "𝄞",
    "[99999999999]",
    "rand(1, 0)",
];

fn mutated(text: &str, dice: &mut Dice) -> String {
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..=dice.below(4) {
        let at = dice.below(chars.len());
        let end = (at + dice.below(40)).min(chars.len());
        match dice.below(5) {
            0 => drop(chars.drain(at..end)),
            1 => {
                let copy = chars[at..end].to_vec();
                let to = dice.below(chars.len());
                chars.splice(to..to, copy);
            }
            2 => chars[at..end].reverse(),
            3 => drop(chars.splice(at..at, SPLINTERS[dice.below(SPLINTERS.len())].chars())),
            _ => drop(chars.splice(at..end, SPLINTERS[dice.below(SPLINTERS.len())].chars())),
        }
        if chars.is_empty() {
            chars.push(';');
        }
    }
    chars.into_iter().collect()
}

#[test]
fn a_thousand_mutations() {
    let texts = EXAMPLES.map(|name| fs::read_to_string(example(name)).unwrap());
    let mut dice = Dice(2);
    for round in 0..1000 {
        swallow(&mutated(&texts[round % texts.len()], &mut dice));
    }
}

/// Files that are bad as files, or extreme.
fn bad_files() -> Vec<(&'static str, Vec<u8>)> {
    let scene = fs::read_to_string(example("bedroom")).unwrap();
    let deep = |n: usize| format!("object a; assert {}a.pos.x > 1{};", "(".repeat(n), ")".repeat(n));
    vec![
        ("empty", Vec::new()),
        ("blank", b" \n\t\r\n".to_vec()),
        ("byte-order-mark", [b"\xef\xbb\xbf", scene.as_bytes()].concat()),
        ("carriage-returns", scene.replace('\n', "\r\n").into_bytes()),
        ("nul", b"object a;\0assert a.pos.x > 1;\0".to_vec()),
        ("not-utf8", b"object a; // \xff\xfe\xc3(\nassert a.pos.x > 1;".to_vec()),
        ("half-a-character", [scene.as_bytes(), b"// \xe2\x82"].concat()),
        ("long-line", format!("object a; assert a.pos.x > {};", "1 + ".repeat(2_500_000) + "1").into_bytes()),
        ("long-comment", [b"// ", "x".repeat(10_000_000).as_bytes()].concat()),
        ("long-name", format!("object {};", "a".repeat(10_000_000)).into_bytes()),
        ("long-string", format!("object a; a.color <- \"{}\";", "a".repeat(10_000_000)).into_bytes()),
        ("deep", deep(10_000).into_bytes()),
        ("deep-unclosed", format!("object a; assert {}", "(".repeat(10_000)).into_bytes()),
        ("deep-not", format!("object a; assert {}a.pos.x > 1;", "not ".repeat(10_000)).into_bytes()),
        ("deep-minus", format!("object a; assert a.pos.x > {}1;", "-".repeat(10_000)).into_bytes()),
        ("deep-comment", "/*".repeat(10_000).into_bytes()),
        ("long-sum", format!("object a; assert a.pos.x > {}1;", "1 + ".repeat(50_000)).into_bytes()),
        ("many-errors", "assert ;\n".repeat(20_000).into_bytes()),
        ("wide", b"object a[100000]; assert forall x in a: forall y in a: x != y implies gap(x, y) > 0;".to_vec()),
        ("huge-array", b"object a[99999999999999999999];".to_vec()),
    ]
}

#[test]
fn bad_files_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in bad_files() {
        let file = format!("{name}.scene");
        fs::write(folder.path().join(&file), &bytes).unwrap();
        let ended = scenelang(folder.path(), ["check", "--format", "json", &file]);
        assert!((0..=2).contains(&ended.code), "{name}: {}", ended.code);
        assert_eq!(ended.reports().len(), 1, "{name}: {}", ended.stderr);
        let shown = scenelang(folder.path(), ["check", &file]);
        assert_eq!(shown.code, ended.code, "{name}: {}", shown.stderr);
        assert!(shown.stdout.len() + shown.stderr.len() < 1_000_000, "{name}: nobody reads so much");
        let formatted = scenelang_with_input(folder.path(), ["fmt", "-"], &bytes);
        assert!((0..=2).contains(&formatted.code), "{name}: {}", formatted.code);
        for command in ["syntax", "hir", "constraints"] {
            if bytes.len() > 1_000_000 && command == "syntax" {
                continue; // the tree of millions of tokens takes as long to print as all else here
            }
            let shown = scenelang(folder.path(), [command, "--format", "json", &file]);
            assert!((0..=2).contains(&shown.code), "{command} {name}: {}", shown.stderr);
        }
    }
}

#[test]
fn bad_layouts_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.scene"), "object a; assert a.pos.x > 1;").unwrap();
    let good = r#"{"format":"scenelang.layout/1","scene":"a.scene","objects":{"a":{"pos":[2,0,0],"scale":[1,1,1]}}}"#;
    let mut files: Vec<Vec<u8>> = (0..good.len()).map(|end| good.as_bytes()[..end].to_vec()).collect();
    files.push("[".repeat(10_000).into_bytes());
    files.push("{\"objects\":".repeat(10_000).into_bytes());
    files.push(good.replace("2,", "1e999,").into_bytes());
    files.push(good.replace("2,", "1e400000,").into_bytes());
    files.push(good.replace("2,", "null,").into_bytes());
    files.push([good.as_bytes(), b"\0"].concat());
    files.push([good.as_bytes(), b"\xff"].concat());
    let names: Vec<String> = (0..files.len()).map(|i| format!("{i}.layout.json")).collect();
    for (name, bytes) in names.iter().zip(&files) {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    let ended = scenelang(folder.path(), ["check", "--format", "json"].map(str::to_owned).iter().chain(&names));
    assert_eq!(ended.code, 2);
    let reports = ended.reports();
    assert_eq!(reports.len(), files.len());
    for (report, bytes) in reports.iter().zip(&files) {
        assert_eq!(report["ok"], false, "{}: {report:#}", String::from_utf8_lossy(bytes));
    }
}

/// Whatever a fuzz target has found once is read by all that reads what strangers wrote.
#[test]
fn what_fuzzing_has_found() {
    let targets = fs::read_dir(root().join("fuzz/findings")).unwrap().map(|entry| entry.unwrap().path());
    for target in targets.filter(|path| path.is_dir()) {
        for file in fs::read_dir(target).unwrap() {
            let bytes = fs::read(file.unwrap().path()).unwrap();
            if let Ok(text) = scenelang_layout::file::decode(bytes) {
                swallow(&text);
                scenelang_layout::file::read(&text, scenelang_base::FileId(0));
                let _ = scenelang_verify::settings::read(&text, scenelang_base::FileId(0));
            }
        }
    }
}
