//! Commands to look things up and to start: `explain`, `schema`, `new`.

use crate::args::{Explain, New, Schema};
use crate::{FAILED, GOOD, manual, out, words};
use scenelang_base::door::Door;
use scenelang_base::fs::is_stream;
use scenelang_base::{Code, codes, suggest};
use scenelang_lang::library;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::schemas;

/// Shows the page of a code, or what a word of the language means.
pub fn explain(args: &Explain) -> u8 {
    let word = args.words.join(" ");
    // A physical rule has the page of what tells that it is violated.
    let rule = RowKind::ALL.into_iter().find(|kind| kind.rule().is_some_and(|rule| rule.eq_ignore_ascii_case(&word)));
    if let Some(code) = Code::find(&word).or(rule.map(RowKind::code)) {
        out::show(code.page());
        return GOOD;
    }
    let found = [words::meaning(&word), words::setting(&word), manual::command(&word)];
    let found: Vec<String> = found.into_iter().flatten().collect();
    if !found.is_empty() {
        out::show(&found.join("\n"));
        return GOOD;
    }
    eprintln!("error: `{word}` is not a code, rule, keyword, predicate, function, property, setting or command");
    let all = codes::ALL.iter().map(|(code, _)| code.as_str());
    if library::is_known(&word) {
        eprintln!("  it is a category: `scenelang categories {word}` shows its usual size");
        return FAILED;
    }
    let near = suggest::nearest(&word.to_uppercase(), all).map(str::to_owned);
    match near.or_else(|| words::nearest_of_all(&word)) {
        Some(near) => eprintln!("  did you mean `{near}`?"),
        None => eprintln!("  codes look like E0201, W0302 or V0101"),
    }
    FAILED
}

/// Prints a JSON Schema.
pub fn schema(args: &Schema) -> u8 {
    let Some(text) = schemas::find(&args.name) else { return FAILED };
    print!("{text}");
    GOOD
}

/// Writes a small program to start from; a file that is there already is left alone.
pub fn new(args: &New) -> u8 {
    if args.file.exists() && !is_stream(&args.file) {
        eprintln!("error: {} exists already and is not overwritten; name another file", args.file.display());
        return FAILED;
    }
    match Door::of(&args.file).write(&args.file, TEMPLATE.as_bytes()) {
        Ok(()) => {
            println!("{} written; `scenelang synth {}` furnishes it", args.file.display(), args.file.display());
            GOOD
        }
        Err(e) => {
            eprintln!("error: {e}");
            FAILED
        }
    }
}

/// What `scenelang new` writes.
const TEMPLATE: &str = include_str!("new.scene");

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::Options;
    use std::path::Path;

    #[test]
    fn the_program_to_start_from_compiles_in_standard_form() {
        let compiled = scenelang_lang::compile_text("new.scene", Path::new("new.scene"), TEMPLATE, Options::default());
        assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
        assert_eq!(scenelang_lang::fmt::format(TEMPLATE, &Default::default()), TEMPLATE);
    }
}
