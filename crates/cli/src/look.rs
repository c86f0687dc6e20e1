//! Commands to look things up and to start: `explain`, `schema`, `new`.

use crate::args::{Explain, New, Schema};
use crate::{FAILED, GOOD, drawings, input, manual, out, plain, words};
use scenelang_base::door::Door;
use scenelang_base::fs::is_stream;
use scenelang_base::{Code, codes, suggest};
use scenelang_lang::library;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::schemas;

/// Shows the page of a code, or what a word of the language means; of several words, what they mean together or else each.
pub fn explain(args: &Explain) -> u8 {
    let whole = args.words.join(" ");
    let each = || args.words.iter().map(|word| explained(word)).collect::<Option<Vec<String>>>();
    if let Some(found) = explained(&whole).or_else(|| Some(each()?.join("\n"))) {
        out::show(&found);
        return draw(args);
    }
    let word = args.words.iter().find(|word| args.words.len() > 1 && explained(word).is_none()).unwrap_or(&whole);
    let is_category = |word: &str| library::is_category(&word.to_lowercase().replace(' ', "_"));
    if let Some(category) = [&whole, word].into_iter().find(|word| is_category(word)) {
        let quoted = input::quoted(category);
        eprintln!("error: `{category}` is a category: `scenelang categories {quoted}` shows its usual size");
        return FAILED;
    }
    let digits = word.strip_prefix(['E', 'W', 'V', 'e', 'w', 'v']).unwrap_or_default();
    if digits.len() == 4 && digits.chars().all(|c| c.is_ascii_digit()) {
        eprintln!("error: there is no code {}", word.to_uppercase());
        return FAILED;
    }
    eprintln!("error: `{word}` is not a code, rule, keyword, predicate, function, property, setting or command");
    let all = codes::ALL.iter().map(|(code, _)| code.as_str());
    let near = suggest::nearest(&word.to_uppercase(), all).map(str::to_owned);
    match near.or_else(|| words::nearest_of_all(word)) {
        Some(near) => eprintln!("  did you mean `{near}`?"),
        None => eprintln!("  codes look like E0201, W0302 or V0101"),
    }
    FAILED
}

/// Writes the drawings of words that have one.
fn draw(args: &Explain) -> u8 {
    let Some(folder) = &args.drawings else { return GOOD };
    let drawings: Vec<_> = args.words.iter().flat_map(|word| words::drawings_of(word)).collect();
    if drawings.is_empty() {
        eprintln!("error: there is no drawing of `{}`; predicates and some functions have one", args.words.join(" "));
        return FAILED;
    }
    match drawings::write(&drawings, folder, args.force) {
        Ok(()) => GOOD,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

/// What is known of a code or a word.
fn explained(word: &str) -> Option<String> {
    // A physical rule has the page of what tells that it is violated.
    let rule = RowKind::ALL.into_iter().find(|kind| kind.rule().is_some_and(|rule| rule.eq_ignore_ascii_case(word)));
    if let Some(code) = Code::find(word).or(rule.map(RowKind::code)) {
        return Some(plain::page(code.page()));
    }
    let found = [words::meaning(word).map(|text| plain::page(&text)), words::setting(word), manual::command(word)];
    let found: Vec<String> = found.into_iter().flatten().collect();
    (!found.is_empty()).then(|| found.join("\n"))
}

/// Prints a JSON Schema.
pub fn schema(args: &Schema) -> u8 {
    let Some(text) = schemas::find(&args.name) else { return FAILED };
    print!("{text}");
    GOOD
}

/// Writes a small program to start from; a file that is there already is left alone, unless `--force` is given.
pub fn new(args: &New) -> u8 {
    let shown = args.file.display();
    let is_file = !is_stream(&args.file);
    if is_file && args.file.extension().is_none_or(|end| end != "scene") {
        let named = input::quoted(&args.file.with_extension("scene").display().to_string());
        eprintln!("error: the name of a program ends in `.scene`, unlike {shown}; try `scenelang new {named}`");
        return FAILED;
    }
    if is_file && args.file.exists() && !args.force {
        eprintln!("error: {shown} exists already and is not overwritten; use --force, or name another file");
        return FAILED;
    }
    match Door::of(&args.file).write(&args.file, TEMPLATE.as_bytes()) {
        Ok(()) => {
            let named = input::quoted(&shown.to_string());
            println!("{shown} written; `scenelang synth {named}` furnishes it");
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
