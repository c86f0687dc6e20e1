//! Colours of names by what they stand for.

use crate::fixture::Fixture;
use scenelang_base::TextRange;
use scenelang_ide::tokens::{MODIFIERS, TYPES, tokens};

#[test]
fn names_by_what_they_stand_for() {
    let line = "assert forall s in stand: near(s, bed, space) and clear(s, front, 1);";
    let fixture = Fixture::with(line);
    let within = TextRange::new(fixture.text.len() - line.len(), fixture.text.len());
    let found = tokens(&fixture.snapshot, Some(within)).unwrap();
    let said = |t: &scenelang_ide::tokens::Token| {
        let modifiers = MODIFIERS
            .iter()
            .enumerate()
            .filter(|(i, _)| t.modifiers & (1 << i) != 0)
            .map(|(_, name)| format!(".{name}"));
        format!("{} {}{}", fixture.slice(t.range), TYPES[t.ty as usize], modifiers.collect::<String>())
    };
    let words: Vec<String> = found.iter().map(said).filter(|w| w.starts_with(char::is_alphabetic)).collect();
    assert_eq!(
        words,
        [
            "assert keyword",
            "forall keyword",
            "s variable.declaration.readonly",
            "in keyword",
            "stand class",
            "near function.defaultLibrary",
            "s variable.readonly",
            "bed class",
            "space variable",
            "and keyword",
            "clear function.defaultLibrary",
            "s variable.readonly",
            "front enumMember",
        ]
    );
}
