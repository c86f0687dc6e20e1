//! What words of the language mean (`explain near`), and what kinds of things it knows (`categories`).

use crate::args::{Categories, Plain};
use crate::{FAILED, GOOD};
use scenelang_base::suggest;
use scenelang_ide::hover;
use scenelang_lang::library;
use scenelang_lang::natives;
use scenelang_lang::nouns;
use scenelang_lang::roles::role_of;
use serde_json::json;
use std::fmt::Write;

/// Chapters of the book with a section for each predicate and built-in.
const CHAPTERS: [&str; 7] = [
    include_str!("../../../spec/src/std/distance.md"),
    include_str!("../../../spec/src/std/contact.md"),
    include_str!("../../../spec/src/std/directions.md"),
    include_str!("../../../spec/src/std/orientation.md"),
    include_str!("../../../spec/src/std/walls.md"),
    include_str!("../../../spec/src/std/groups.md"),
    include_str!("../../../spec/src/reference/built-in.md"),
];

/// What a predicate, function or property means, with examples where the book has them.
pub fn meaning(word: &str) -> Option<String> {
    let mut out = String::new();
    if let Some(section) = CHAPTERS.iter().find_map(|chapter| section(chapter, word)) {
        out.push_str(&section);
    } else if let Some(predicate) = hover::library_predicate(word) {
        let _ = writeln!(out, "{predicate}");
    } else if natives::is_built_in(word) {
        let _ = writeln!(out, "{}", hover::built_ins(word));
    }
    for (owner, table) in [("object", natives::OBJECT_PROPERTIES), ("region", natives::REGION_PROPERTIES)] {
        if let Some(property) = table.iter().find(|p| p.name == word) {
            let _ = writeln!(out, "`{word}` of an {owner} : {}\n\n{}", property.ty.name(), property.doc);
        }
    }
    let out = out.replace("of an region", "of a region");
    (!out.is_empty()).then_some(out)
}

/// The word that can be explained and is most like one that cannot.
pub fn nearest(word: &str) -> Option<&'static str> {
    let properties = [natives::OBJECT_PROPERTIES, natives::REGION_PROPERTIES].into_iter().flatten().map(|p| p.name);
    let built_in = natives::BUILT_INS.iter().map(|s| s.name);
    suggest::nearest(word, library::names().chain(built_in).chain(properties))
}

/// The section of a chapter about a word, without layouts and drawings.
fn section(chapter: &str, word: &str) -> Option<String> {
    let own = |line: &str| {
        let head = line.strip_prefix("## ").unwrap_or_default().trim_matches('`');
        head.split('(').next() == Some(word)
    };
    let mut lines = chapter.lines().skip_while(|line| !own(line));
    let mut out = format!("{}\n", lines.next()?);
    let mut in_layout = false;
    for line in lines.take_while(|line| !line.starts_with("## ")) {
        let starts = line.starts_with("```json layout");
        in_layout |= starts;
        let shown = !in_layout && !line.starts_with("![");
        in_layout &= starts || line != "```";
        // What was left out leaves one empty line.
        if shown && !(line.is_empty() && out.ends_with("\n\n")) {
            out.push_str(line);
            out.push('\n');
        }
    }
    Some(format!("{}\n", out.trim_end()))
}

/// Lists the categories that are known, or those with a word in them.
pub fn categories(args: &Categories) -> u8 {
    let word = args.word.as_deref().unwrap_or_default().to_lowercase();
    let found: Vec<&(String, [f64; 3])> =
        library::categories().iter().filter(|(name, _)| name.contains(&word)).collect();
    if found.is_empty() {
        eprintln!("error: no category has `{word}` in its name");
        if let Some(near) = library::nearest_category(&word) {
            eprintln!("  did you mean `{near}`?");
        }
        return FAILED;
    }
    let mut out = String::new();
    if args.format == Plain::Json {
        let row = |(name, size): &&(String, [f64; 3])| json!({ "category": name, "size": size, "role": role_of(name), "stands": stands(name) });
        let list =
            json!({ "format": "scenelang.categories/1", "categories": found.iter().map(row).collect::<Vec<_>>() });
        let _ = writeln!(out, "{list}");
    } else {
        let width = found.iter().map(|(name, _)| name.chars().count()).max().unwrap_or_default();
        let _ = writeln!(out, "{:width$}   width height  depth   role", "category");
        for (name, [w, h, d]) in found {
            let _ = writeln!(out, "{name:width$}  {w:>6.2} {h:>6.2} {d:>6.2}   {}", role_of(name));
        }
    }
    crate::out::show(&out);
    GOOD
}

/// What things of a category stand on, in a word.
fn stands(name: &str) -> Option<String> {
    nouns::ending(name).map(|noun| format!("{:?}", noun.stands).to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_predicate_function_and_property_is_explained() {
        let built_in = natives::BUILT_INS.iter().map(|s| s.name);
        let properties = [natives::OBJECT_PROPERTIES, natives::REGION_PROPERTIES].into_iter().flatten().map(|p| p.name);
        for word in library::names().chain(built_in).chain(properties) {
            assert!(meaning(word).is_some_and(|text| text.lines().count() > 1), "{word}");
        }
        let near = meaning("near").unwrap_or_default();
        assert!(near.contains("gap(a, b) <= d") && near.contains("margin 0.15 m") && !near.contains("json"), "{near}");
        assert_eq!((meaning("nearr"), nearest("nearr")), (None, Some("near")));
    }
}
