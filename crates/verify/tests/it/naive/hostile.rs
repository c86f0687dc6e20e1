//! Layouts with numbers that nobody means: whatever they are, a report comes of it that can be read, says nothing that is
//! no number, and has an exit code.

use super::make;
use super::{number, say};
use crate::dice::Dice;
use crate::given::judged;
use crate::schemas::{faults, validator};
use scenelang_verify::report::model::{Quantity, Report, Row};
use scenelang_verify::report::{Human, compact, github, human, junit, sarif};
use scenelang_verify::{Checked, Options, exit_code};
use serde_json::Value;
use std::fmt::Write as _;

const HOSTILE: [f64; 24] = [
    1e308,
    -1e308,
    f64::MAX,
    5e-324,
    -5e-324,
    2.3e-308,
    1e-300,
    1e-12,
    1e-4,
    0.0,
    -0.0,
    1e4,
    -1e4,
    1e6,
    -1e6,
    1_000_001.0,
    999_999.9,
    360.0,
    -360.0,
    89.999_999_999,
    1e5,
    -123_456.789,
    0.1,
    3.0,
];

/// Puts hostile numbers into some places of a document.
fn spoil(value: &mut Value, dice: &mut Dice, percent: usize) {
    match value {
        Value::Number(x) if dice.chance(percent) => {
            *x = serde_json::Number::from_f64(dice.one(&HOSTILE)).expect("a finite number");
        }
        Value::Array(list) => list.iter_mut().for_each(|v| spoil(v, dice, percent)),
        Value::Object(members) => members.iter_mut().for_each(|(_, v)| spoil(v, dice, percent)),
        _ => {}
    }
}

/// Every number that a row gives.
fn numbers(row: &Row) -> Vec<f64> {
    let mut out: Vec<f64> = row.margin.into_iter().chain(row.weight).collect();
    let Some(why) = &row.explanation else { return out };
    for side in why.measured.iter().flat_map(|m| [m.left, m.right]).flatten() {
        match side {
            Quantity::Number(x) => out.push(x),
            Quantity::Triple(v) => out.extend(v),
        }
    }
    why.objects.iter().for_each(|o| out.extend([o.pos, o.rot, o.size].concat()));
    if let Some(repair) = &why.repair {
        out.extend(repair.by);
        out.push(repair.turn);
        repair.also.iter().for_each(|step| out.extend(step.by.iter().chain([&step.turn])));
    }
    out
}

/// How a float that is no number is written.
fn is_no_number(word: &str) -> bool {
    ["NaN", "inf", "Infinity"].contains(&word.trim_matches(|c: char| !c.is_alphanumeric()))
}

fn blemishes(checked: &Checked, schema: &jsonschema::Validator) -> Vec<String> {
    let report: &Report = &checked.report;
    let mut out = Vec::new();
    for row in &report.constraints {
        if !numbers(row).iter().all(|x| x.is_finite()) {
            out.push(format!("{}: {:?}", row.text, numbers(row)));
        }
    }
    let json = serde_json::to_string(report).expect("a report can be written");
    let read: Value = serde_json::from_str(&json).expect("and read");
    out.extend(faults(schema, &read));
    let shown = human(checked, Human::default());
    let one = std::slice::from_ref(report);
    let short = [compact(report, Human::default()), github(one), junit(one), sarif(std::slice::from_ref(checked))];
    for text in short.iter().chain([&json, &shown]) {
        let odd = text.split_whitespace().find(|w| is_no_number(w));
        out.extend(odd.map(|w| format!("{w:?} is said in {text:.3000}")));
    }
    if !(0..=2).contains(&exit_code(report)) {
        out.push(format!("exit {}", exit_code(report)));
    }
    out
}

#[test]
fn hostile_numbers_give_a_report() {
    let (mut exits, mut wrong) = ([0; 3], String::new());
    let schema = validator("report");
    let cases = number("SCENELANG_CASES", 2_000) / 10;
    for seed in 0..cases {
        let mut dice = Dice(seed ^ 0xbad);
        let scene = make::scene(&mut dice);
        let program = say::program(&mut dice, &scene).text(&scene);
        let mut layout: Value = serde_json::from_str(&scene.layout()).expect("JSON");
        let percent = dice.one(&[1, 3, 10, 60]);
        spoil(&mut layout, &mut dice, percent);
        let checked = judged(&program, &layout.to_string(), &Options::default());
        exits[exit_code(&checked.report) as usize] += 1;
        let found = blemishes(&checked, &schema);
        if !found.is_empty() {
            writeln!(wrong, "seed {seed}: {found:#?}\n{program}\n{layout}").unwrap();
        }
    }
    println!("{cases} layouts; exit 0, 1, 2: {exits:?}");
    assert!(wrong.is_empty(), "{wrong:.20000}");
    assert!(exits[1] * 20 > cases && exits[2] * 4 > cases, "too one-sided: {exits:?}");
}
