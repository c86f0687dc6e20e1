//! What a violation of each predicate of the library says. The predicates and their parameters come from the library itself,
//! so that a new one is tested by being there.

use crate::dice::Dice;
use crate::given::layout;
use scenelang_base::FileId;
use scenelang_lang::ast::TypeWord;
use scenelang_lang::items::Predicate;
use scenelang_lang::{library, wording};
use scenelang_layout::file;
use scenelang_verify::{CheckVerdict, Options, check};
use std::collections::BTreeMap;
use std::fmt::Write;

/// How many elements each array has: a set is all of it, an object the second.
const COUNT: usize = 3;

/// A program with one assertion of the predicate, and the names that its message may use.
fn program(predicate: &Predicate<'_>) -> (String, Vec<String>) {
    let mut text = "region hall;\n".to_owned();
    let mut names = Vec::new();
    let mut limits = ["0.5", "0.8"].into_iter();
    let args = predicate.params.iter().map(|param| {
        let name = param.name.text.to_string();
        match param.ty {
            TypeWord::Object | TypeWord::Objects => {
                writeln!(text, "object {name}[{COUNT}];").unwrap();
                names.push(name.clone());
                if param.ty == TypeWord::Object { format!("{name}[1]") } else { name }
            }
            TypeWord::Region => "hall".to_owned(),
            TypeWord::Number => limits.next().expect("two numbers at most").to_owned(),
            other => panic!("no argument of type {other:?} can be made: teach this test"),
        }
    });
    let args = args.collect::<Vec<_>>().join(", ");
    writeln!(text, "assert {}({args});", predicate.name).unwrap();
    (text, names)
}

/// Boxes anywhere in a hall, half of them on its floor, most of them square to it.
fn boxes(names: &[String], dice: &mut Dice) -> String {
    let mut text = "region hall 0 0 0 | 8 3 6\n".to_owned();
    for name in names {
        for i in 0..COUNT {
            let y = if dice.chance(50) { 0.0 } else { dice.between(0.0, 2.0) };
            let [x, z] = [dice.between(-4.0, 4.0), dice.between(-3.0, 3.0)];
            let [w, h, d] = [dice.between(0.3, 1.5), dice.between(0.3, 1.0), dice.between(0.3, 1.5)];
            let turn = if dice.chance(75) { 90.0 * dice.below(4) as f64 } else { dice.between(0.0, 360.0) };
            writeln!(text, "object {name}[{i}] {x} {y} {z} | {w} {h} {d} | 0 {turn} 0").unwrap();
        }
    }
    text
}

/// What the only assertion says where it fails.
fn violation(verdict: &CheckVerdict) -> Option<&str> {
    let row = verdict.rows.iter().find(|row| row.code.to_string() == "V0101" || !row.text.starts_with("P-"))?;
    (row.satisfied == Some(false)).then_some(row.measured.as_str())
}

/// A sentence without its numbers, of which any may stand there.
fn form(said: &str) -> String {
    let digits: String = said.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
    let mut out = digits;
    for _ in 0..4 {
        out = out.replace("00", "0").replace("0.0", "0").replace("-0", "0");
    }
    out
}

/// One sentence of each form.
#[test]
fn a_violation_of_each_predicate_names_its_objects() {
    let mut lines = BTreeMap::new();
    for name in library::names() {
        let predicate = &library::predicates()[name];
        let (scene, names) = program(predicate);
        let compiled = crate::proofs::compiled(&scene);
        for seed in 0..20 {
            let placed = file::read(&layout(&boxes(&names, &mut Dice(seed))), FileId(0)).layout;
            let verdict = check(&compiled, &placed, &Options::default());
            let Some(said) = violation(&verdict) else { continue };
            let is_named = names.iter().any(|object| said.contains(&format!("`{object}[")));
            assert!(is_named, "{name}, seed {seed}: {said:?}");
            lines.entry(format!("{name}: {}", form(said))).or_insert_with(|| format!("{name}: {said}"));
        }
    }
    insta::assert_snapshot!(lines.into_values().collect::<Vec<_>>().join("\n"));
}

/// A template that stands for a comparison of two objects, which is decided when the program is expanded, is one line too
/// early or too late.
#[test]
fn each_template_is_for_a_comparison_of_numbers() {
    for name in library::names() {
        let predicate = &library::predicates()[name];
        let (scene, _) = program(predicate);
        let compiled = crate::proofs::compiled(&scene);
        let wordings = || compiled.constraints.iter().flat_map(|constraint| &constraint.wordings);
        for (_, template) in wording::templates(predicate.place.stmt) {
            assert!(wordings().any(|wording| wording.template == template), "{name}: {template:?}");
        }
    }
}
