//! The standard library: predicates written in the language, shipped inside the binary, and the table of usual sizes.

use crate::ast::StmtKind;
use crate::items::{Located, Predicate, PredicateHead, head_of};
use crate::parse::{ParsedFile, parse_file};
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use std::sync::OnceLock;

/// The files of the library: name and text.
pub const FILES: &[(&str, &str)] = &[
    ("std/directions.scene", include_str!("../std/directions.scene")),
    ("std/contact.scene", include_str!("../std/contact.scene")),
    ("std/distance.scene", include_str!("../std/distance.scene")),
    ("std/orientation.scene", include_str!("../std/orientation.scene")),
    ("std/walls.scene", include_str!("../std/walls.scene")),
    ("std/groups.scene", include_str!("../std/groups.scene")),
];

/// Files of the library that count only where they are imported: what the import says, and the text.
pub const IMPORTED: &[(&str, &str)] = &[("std/guidelines.scene", include_str!("../std/guidelines.scene"))];

/// The text of a file of the library that a program imports.
pub fn imported(path: &str) -> Option<&'static str> {
    IMPORTED.iter().find(|(name, _)| *name == path).map(|(_, text)| *text)
}

/// The library, parsed once per process.
pub fn parsed() -> &'static [ParsedFile] {
    static PARSED: OnceLock<Vec<ParsedFile>> = OnceLock::new();
    PARSED.get_or_init(|| FILES.iter().map(|(_, text)| parse_file(text)).collect())
}

/// Its predicates by name.
pub fn predicates() -> &'static FxHashMap<SmolStr, Predicate<'static>> {
    static PREDICATES: OnceLock<FxHashMap<SmolStr, Predicate<'static>>> = OnceLock::new();
    PREDICATES.get_or_init(|| {
        let statements = parsed().iter().flat_map(|f| &f.statements);
        let places = statements.map(|(offset, stmt)| Located { file: None, offset: *offset, stmt });
        places.filter_map(Predicate::of).map(|p| (p.name.clone(), p)).collect()
    })
}

/// What a call needs to know of one of its predicates.
pub fn predicate_head(name: &str) -> Option<PredicateHead> {
    let p = predicates().get(name)?;
    Some(head_of(p.place.stmt, p.params, p.body, true))
}

/// Names of its predicates, in the order of the files.
pub fn names() -> impl Iterator<Item = &'static str> {
    parsed().iter().flat_map(|f| &f.statements).filter_map(|(_, s)| match &s.kind {
        StmtKind::Predicate { name, .. } => Some(name.text.as_str()),
        _ => None,
    })
}

/// The usual size (width, height, depth in metres) of a category: that of the furniture or else of the noun that has its
/// whole name, else that of the furniture that its last words name.
pub fn usual_size(category: &str) -> Option<[f64; 3]> {
    let words = words(category);
    let noun = |name: &str| crate::nouns::noun(name).map(|noun| noun.size);
    let whole = words.join("_");
    lookup(&whole).or_else(|| noun(&whole)).or_else(|| furniture_size(category))
}

/// The usual size of furniture: the whole text, else its last word that the table has ("oak dining table" is a dining
/// table, "blue chair" a chair).
pub fn furniture_size(category: &str) -> Option<[f64; 3]> {
    let words = words(category);
    (0..words.len())
        .find_map(|skip| lookup(&words[skip..].join("_")))
        .or_else(|| words.iter().rev().find_map(|w| lookup(w)))
}

/// The categories of which a usual size is known, with it (width, height, depth in metres), sorted, each once; words are
/// separated by blanks.
pub fn categories() -> &'static [(String, [f64; 3])] {
    static ALL: OnceLock<Vec<(String, [f64; 3])>> = OnceLock::new();
    ALL.get_or_init(|| {
        let furniture = sizes().iter().map(|(name, size)| (*name, *size));
        let nouns = crate::nouns::all().iter().map(|noun| (noun.name, noun.size));
        let all: std::collections::BTreeMap<String, [f64; 3]> =
            nouns.chain(furniture).map(|(name, size)| (name.replace('_', " "), size)).collect();
        all.into_iter().collect()
    })
}

/// Whether anything is known of a category, or of what its last words name ("wolf pelt" is a pelt): a usual size, or what
/// it is for.
pub fn is_known(category: &str) -> bool {
    let words = words(category);
    let named = || (1..words.len()).any(|skip| crate::nouns::noun(&words[skip..].join("_")).is_some());
    usual_size(category).is_some() || !crate::roles::role_of(category).is_empty() || named()
}

/// The known category whose name is most like one that is not known: as a whole, or by its last word.
pub fn nearest_category(category: &str) -> Option<String> {
    let words = words(category);
    let all = || categories().iter().map(|(name, _)| name.as_str());
    let whole = words.join(" ");
    if let Some(near) = scenelang_base::suggest::nearest(&whole, all()) {
        return Some(near.to_owned());
    }
    let (last, before) = words.split_last()?;
    let near = scenelang_base::suggest::nearest(last, all()).filter(|_| !before.is_empty())?;
    Some(format!("{} {near}", before.join(" ")))
}

/// Words for colors, and for materials, which stand for their usual color.
pub fn colors() -> impl Iterator<Item = &'static str> {
    let lines = include_str!("../std/colors.txt").lines().filter(|line| !line.starts_with('#'));
    lines.flat_map(str::split_whitespace)
}

/// The name of a color that a text probably means, if it names none: the one that is most like the whole text or a word of
/// it. `None`: it names one, or nothing like one.
pub fn meant_color(text: &str) -> Option<&'static str> {
    static KNOWN: OnceLock<FxHashSet<&str>> = OnceLock::new();
    /// Names of colors have at most so many words.
    const LONGEST: usize = 3;
    /// Shorter words are like too many others.
    const SHORTEST: usize = 3;
    let known = KNOWN.get_or_init(|| colors().collect());
    // The British spelling is as good, and so is a plural.
    let words: Vec<String> = words(text).into_iter().map(|word| word.replace("grey", "gray")).collect();
    let names = |run: &[String]| {
        let run = run.concat();
        known.contains(run.as_str()) || run.strip_suffix('s').is_some_and(|one| known.contains(one))
    };
    if text.contains('#') || (1..=LONGEST).flat_map(|n| words.windows(n)).any(names) {
        return None;
    }
    let all = std::iter::once(words.concat()).chain(words.iter().rev().cloned());
    all.filter(|word| word.len() >= SHORTEST).find_map(|word| scenelang_base::suggest::nearest(&word, colors()))
}

/// Whether the table of usual sizes has a word as it stands.
pub fn is_category(word: &str) -> bool {
    lookup(word).is_some()
}

/// Lower-case words of a category or a name: blanks, underscores, digits and humps separate.
pub fn words(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in text.chars() {
        let hump = c.is_uppercase() && before.is_lowercase();
        match out.last_mut() {
            _ if !c.is_alphabetic() => {}
            Some(word) if before.is_alphabetic() && !hump => word.extend(c.to_lowercase()),
            _ => out.push(c.to_lowercase().collect()),
        }
        before = c;
    }
    out
}

/// The table of usual sizes, by name.
fn sizes() -> &'static [(&'static str, [f64; 3])] {
    static TABLE: OnceLock<Vec<(&str, [f64; 3])>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let mut rows: Vec<_> = include_str!("../std/sizes.txt").lines().filter_map(size_row).collect();
        rows.sort_by_key(|(name, _)| *name);
        rows
    })
}

fn lookup(key: &str) -> Option<[f64; 3]> {
    let table = sizes();
    let find = |k: &str| table.binary_search_by_key(&k, |(name, _)| name).ok().map(|i| table[i].1);
    find(key).or_else(|| find(key.strip_suffix('s')?)).or_else(|| find(key.strip_suffix("es")?))
}

fn size_row(line: &str) -> Option<(&str, [f64; 3])> {
    let mut fields = line.split('#').next()?.split_whitespace();
    let name = fields.next()?;
    let mut number = || fields.next()?.parse().ok();
    Some((name, [number()?, number()?, number()?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_parses_and_documents_its_predicates() {
        for (file, (name, _)) in parsed().iter().zip(FILES) {
            assert!(file.diagnostics.is_empty(), "{name}: {:?}", file.diagnostics);
            for (_, stmt) in &file.statements {
                assert!(matches!(stmt.kind, StmtKind::Predicate { .. }), "{name}");
                assert!(!stmt.doc.is_empty(), "{name}: {:?}", stmt.kind);
            }
        }
        assert!(names().count() >= 24);
    }

    #[test]
    fn words_of_names() {
        assert_eq!(words("bookShelf2"), ["book", "shelf"]);
        assert_eq!(words("dining_table"), ["dining", "table"]);
        assert_eq!(words("TV"), ["tv"]);
    }

    #[test]
    fn sizes_are_found_by_head_noun() {
        let chair = usual_size("chair").unwrap();
        assert_eq!(usual_size("blue chair"), Some(chair));
        assert_eq!(usual_size("chairs"), Some(chair));
        assert_eq!(usual_size("paper shredder"), Some([0.35, 0.55, 0.25]), "and not the size of paper");
        assert_eq!(usual_size("quux"), None);
    }

    #[test]
    fn what_is_misspelt_has_a_known_neighbour() {
        for (slip, meant) in
            [("refridgerator", "refrigerator"), ("wardrob", "wardrobe"), ("red sofaa", "red sofa"), ("quuxly", "")]
        {
            assert!(!is_known(slip), "{slip}");
            assert_eq!(nearest_category(slip).unwrap_or_default(), meant, "{slip}");
        }
        assert!(categories().len() > 500 && categories().is_sorted_by(|a, b| a.0 < b.0));
    }

    #[test]
    fn every_row_of_the_size_table_is_read() {
        for line in include_str!("../std/sizes.txt").lines() {
            let content = line.split('#').next().unwrap().trim();
            if !content.is_empty() {
                let (_, size) = size_row(line).unwrap_or_else(|| panic!("{line}"));
                assert!(size.iter().all(|x| (0.001..=30.0).contains(x)), "{line}");
            }
        }
    }
}
