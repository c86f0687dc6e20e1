//! What words of the language and settings mean (`explain near`), and which categories are known (`categories`).

use crate::args::{Categories, Plain};
use crate::drawings::{self, Drawing};
use crate::progress::Progress;
use crate::replace::{self, May};
use crate::{FAILED, GOOD, manual};
use scenelang_assets::family_of;
use scenelang_base::suggest;
use scenelang_export::{OutFile, thumbnail};
use scenelang_ide::{hover, keywords};
use scenelang_lang::library;
use scenelang_lang::natives;
use scenelang_lang::nouns;
use scenelang_lang::roles::role_of;
use scenelang_verify::schemas;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;

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

/// Terms and signs that are no words of the language, and are met wherever it is spoken of.
const TERMS: [(&str, &str); 6] = [
    (
        "margin",
        "The margin of a formula says, in metres or degrees, by how much it holds or, if it is negative, by how much it fails.\n\n\
         ```scene\nassert lamp.pos.y > 1;\n```\n\nThe margin is 0.5 m if `lamp.pos.y` is 1.5, and -0.2 m if it is 0.8.",
    ),
    (
        "<-",
        "`<-` assigns a value to a property or a variable. `=` compares two values.\n\n\
         ```scene\nlamp.color <- \"red\";\nassert lamp.pos.y = 0.75;\n```",
    ),
    (
        "=",
        "`=` compares two values; two lengths are equal if they differ by at most 1 mm. To assign a value, write `<-`.\n\n\
         ```scene\nassert lamp.pos.y = 0.75;\nlamp.color <- \"red\";\n```",
    ),
    (":=", "`:=` defines a predicate.\n\n```scene\npredicate low(Object a) := a.top < 0.5;\n```"),
    (
        "preference",
        "A preference is a `prefer` statement: its condition is desirable but not required.\n\n\
         ```scene\nprefer near(sofa, window, 2) weight 3;\n```",
    ),
    (
        "layout",
        "A layout gives the position, the rotation and the size of every object and region. It is a JSON file: `room.layout.json` \
         belongs to `room.scene`. `scenelang solve` writes it, and `scenelang check` checks it.",
    ),
];

/// What a keyword, predicate, function or property means, with examples where the book has them.
pub fn meaning(word: &str) -> Option<String> {
    let mut out = String::new();
    if let Some(section) = CHAPTERS.iter().find_map(|chapter| section(chapter, word)) {
        out.push_str(&section);
    } else if let Some(predicate) = hover::library_predicate(word) {
        let _ = writeln!(out, "{predicate}");
    } else if natives::is_built_in(word) {
        let _ = writeln!(out, "{}", hover::built_ins(word));
    } else if let Some(says) = keywords::says(word) {
        let _ = writeln!(out, "{says}");
    } else if let Some((_, says)) = TERMS.iter().find(|(term, _)| *term == word) {
        let _ = writeln!(out, "{says}");
    }
    for (owner, table) in [("object", natives::OBJECT_PROPERTIES), ("region", natives::REGION_PROPERTIES)] {
        if let Some(property) = table.iter().find(|p| p.name == word) {
            let _ = writeln!(out, "`{word}` of an {owner} : {}\n\n{}", property.ty.name(), property.doc);
        }
    }
    let out = out.replace("of an region", "of a region");
    (!out.is_empty()).then_some(out)
}

/// The word of the language that is most like one that is none.
pub fn nearest(word: &str) -> Option<&'static str> {
    let properties = [natives::OBJECT_PROPERTIES, natives::REGION_PROPERTIES].into_iter().flatten().map(|p| p.name);
    let built_in = natives::BUILT_INS.iter().map(|s| s.name);
    suggest::nearest(word, library::names().chain(built_in).chain(properties).chain(keywords::all()))
}

/// The same among words of the language, settings and commands together.
pub fn nearest_of_all(word: &str) -> Option<String> {
    let others: Vec<String> = settings().into_iter().map(|setting| setting.name).chain(manual::commands()).collect();
    let all = nearest(word).into_iter().chain(others.iter().map(String::as_str));
    suggest::nearest(word, all).map(str::to_owned)
}

/// A key of `scenelang.toml`.
struct Setting {
    table: Option<String>,
    name: String,
    schema: Value,
}

/// All settings, from the schema that they are checked with.
fn settings() -> Vec<Setting> {
    let schema: Value = schemas::find("config").and_then(|text| serde_json::from_str(text).ok()).unwrap_or_default();
    let properties = |schema: &Value| schema["properties"].as_object().cloned().unwrap_or_default();
    let mut found = Vec::new();
    for (name, value) in properties(&schema) {
        for (key, inner) in properties(&value) {
            found.push(Setting { table: Some(name.clone()), name: key, schema: inner });
        }
        found.push(Setting { table: None, name, schema: value });
    }
    found
}

/// What a setting means: by its key, with or without the table that it stands in.
pub fn setting(word: &str) -> Option<String> {
    let mut out = String::new();
    for Setting { table, name, schema } in settings() {
        let whole = table.as_ref().map_or_else(|| name.clone(), |table| format!("{table}.{name}"));
        let Some(description) = schema["description"].as_str().filter(|_| word == name || word == whole) else {
            continue;
        };
        let is_table = schema["properties"].is_object();
        let _ = writeln!(
            out,
            "`{whole}`, a {} of `scenelang.toml`\n\n{description}",
            if is_table { "table" } else { "setting" }
        );
        let names = |list: &Value| list.as_array().into_iter().flatten().map(Value::to_string).collect::<Vec<_>>();
        let one_of = names(&schema["enum"]);
        if !one_of.is_empty() {
            let _ = writeln!(out, "It is one of {}.", one_of.join(", "));
        }
        if let Some(keys) = schema["properties"].as_object() {
            let _ = writeln!(out, "Its settings are {}.", keys.keys().cloned().collect::<Vec<_>>().join(", "));
        }
        if let Some(default) = schema.get("default") {
            let table = table.map_or_else(String::new, |table| format!("[{table}]\n"));
            let _ = writeln!(out, "\nThe default:\n\n```toml\n{table}{name} = {default}\n```");
        }
        out.push('\n');
    }
    let out = out.trim_end();
    (!out.is_empty()).then(|| format!("{out}\n"))
}

/// The lines of the section of a chapter about a word.
fn lines_about<'a>(chapter: &'a str, word: &str) -> impl Iterator<Item = &'a str> {
    let is_own = move |line: &str| {
        let head = line.strip_prefix("## ").unwrap_or_default().trim_matches('`');
        head.split('(').next() == Some(word)
    };
    let mut lines = chapter.lines().skip_while(move |line| !is_own(line));
    let head = lines.next();
    head.into_iter().chain(lines.take_while(|line| !line.starts_with("## ")))
}

/// The section of a chapter about a word, with what its drawings show in place of them.
fn section(chapter: &str, word: &str) -> Option<String> {
    let mut out = String::new();
    for line in lines_about(chapter, word) {
        match drawings::of_line(line) {
            Some((shows, _)) => {
                let _ = writeln!(out, "Drawing: {shows}.");
            }
            None => out.extend([line, "\n"]),
        }
    }
    (!out.is_empty()).then(|| format!("{}\n", out.trim_end()))
}

/// The drawings in the section about a word.
pub fn drawings_of(word: &str) -> Vec<&'static Drawing> {
    let sections = CHAPTERS.iter().flat_map(|chapter| lines_about(chapter, word));
    sections.filter_map(drawings::of_line).map(|(_, drawing)| drawing).collect()
}

/// Lists the categories that are known, or those with a word in them.
pub fn categories(args: &Categories) -> u8 {
    let word = args.word.as_deref().unwrap_or_default().to_lowercase();
    let containing = |word: &str| -> Vec<&(String, [f64; 3])> {
        library::categories().iter().filter(|(name, _)| name.contains(word)).collect()
    };
    // Adjectives may stand before a category.
    let ends = std::iter::once(word.as_str()).chain(word.match_indices(' ').map(|(at, _)| &word[at + 1..]));
    let found = ends.map(containing).find(|found| !found.is_empty()).unwrap_or_default();
    if found.is_empty() {
        eprintln!("error: no category contains `{word}`");
        if let Some(near) = library::nearest_category(&word) {
            eprintln!("  did you mean `{near}`?");
        }
        return FAILED;
    }
    let mut out = String::new();
    if args.format == Plain::Json {
        let row = |(name, size): &&(String, [f64; 3])| {
            let (role, stands, furniture) = (role_of(name), stands(name), family_of(name, ""));
            json!({ "category": name, "size": size, "role": role, "stands": stands, "furniture": furniture })
        };
        let list =
            json!({ "format": "scenelang.categories/1", "categories": found.iter().map(row).collect::<Vec<_>>() });
        let _ = writeln!(out, "{list}");
    } else {
        let width = found.iter().map(|(name, _)| name.chars().count()).max().unwrap_or_default();
        let _ = writeln!(out, "{:width$}   width height  depth   {:14} furniture", "category", "role");
        for (name, [w, h, d]) in &found {
            let furniture = family_of(name, "").unwrap_or("a labelled box");
            let _ = writeln!(out, "{name:width$}  {w:>6.2} {h:>6.2} {d:>6.2}   {:14} {furniture}", role_of(name));
        }
    }
    crate::out::show(&out);
    let Some(folder) = &args.pictures else { return GOOD };
    match pictures(found.iter().map(|(name, _)| name.as_str()), folder, args.force) {
        Ok(()) => GOOD,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

/// Writes a picture of each category.
fn pictures<'a>(names: impl Iterator<Item = &'a str>, folder: &Path, force: bool) -> Result<(), String> {
    let progress = Progress::new("drawing");
    let draw = |name: &str| {
        progress.say(format!("drawing {name}"));
        thumbnail::of_category(name, PICTURE).map(|png| OutFile::new(format!("{name}.png"), png))
    };
    let files: Vec<OutFile> = names.filter_map(draw).collect();
    drop(progress);
    let written = replace::folder(folder, &files, &[], May { force, these: &[] })?;
    let plural = if written.len() == 1 { "" } else { "s" };
    eprintln!("{} picture{plural} written to {}", written.len(), folder.display());
    Ok(())
}

/// How large a picture is (pixels).
const PICTURE: [usize; 2] = [640, 480];

/// What things of a category stand on, in a word.
fn stands(name: &str) -> Option<String> {
    nouns::ending(name).map(|noun| format!("{:?}", noun.stands).to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_keyword_is_explained_and_suggested() {
        for word in keywords::all() {
            assert!(meaning(word).is_some_and(|says| says.contains(word)), "{word}");
        }
        assert_eq!(nearest("asert"), Some("assert"));
    }

    #[test]
    fn every_predicate_function_and_property_is_explained() {
        let built_in = natives::BUILT_INS.iter().map(|s| s.name);
        let properties = [natives::OBJECT_PROPERTIES, natives::REGION_PROPERTIES].into_iter().flatten().map(|p| p.name);
        for word in library::names().chain(built_in).chain(properties) {
            assert!(meaning(word).is_some_and(|text| text.lines().count() > 1), "{word}");
        }
        let near = meaning("near").unwrap_or_default();
        assert!(
            near.contains("gap(a, b) <= d") && near.contains("margin 0.15 m") && near.contains("```json"),
            "{near}"
        );
        assert!(near.contains("Drawing: lamp is 25 cm from sofa"), "{near}");
        assert!(meaning("margin").is_some() && meaning("<-").is_some());
        assert_eq!((meaning("nearr"), nearest("nearr")), (None, Some("near")));
    }

    #[test]
    fn every_drawing_of_the_chapters_is_embedded_and_no_other() {
        let lines = CHAPTERS.iter().flat_map(|chapter| chapter.lines()).filter(|line| line.starts_with("!["));
        let drawn: BTreeSet<&str> = lines.map(|line| drawings::of_line(line).expect(line).1.name).collect();
        let embedded: BTreeSet<&str> = drawings::all().collect();
        assert_eq!(drawn, embedded);
        for word in library::names() {
            assert!(!drawings_of(word).is_empty(), "{word}");
        }
    }

    #[test]
    fn every_setting_and_command_is_explained() {
        for Setting { table, name, .. } in settings().into_iter().filter(|s| s.schema["description"].is_string()) {
            let whole = table.map_or_else(|| name.clone(), |table| format!("{table}.{name}"));
            assert!(setting(&whole).is_some() && setting(&name).is_some(), "{whole}");
        }
        let eta = setting("eta").unwrap_or_default();
        assert!(eta.contains("metres") && eta.contains("eta = 0.03"), "{eta}");
        assert!(setting("tolerances.equal").is_some_and(|text| text.contains("[tolerances]\nequal = 0.001")));
        assert!(setting("tolerance").is_none());
        for command in manual::commands() {
            assert!(manual::command(&command).is_some_and(|text| text.contains("scenelang")), "{command}");
        }
        assert_eq!(nearest_of_all("sovle").as_deref(), Some("solve"));
    }
}
