//! The verifier against a second one: random programs and layouts, judged by both.
//!
//! The second is written from the text of the language alone: matrices of three rows, all pairs, all axes, all edges. It
//! shares nothing with the verifier, not even the front end: the generator makes trees, which are judged as they are and
//! written out for the verifier to read. Where the text fixes no more than a sign (P-SUPPORT, `connects`, `visible`,
//! `clear`, a box outside a concave region), only verdicts are compared; where a margin is within rounding of its
//! threshold, nothing is. `reachable` and `walkDistance` have an oracle of their own, in `navigation.rs`.

mod eval;
mod flat;
mod hostile;
mod library;
mod make;
mod program;
mod rules;
mod say;
mod scaled;
mod scene;
mod solid;
mod space;
mod term;
mod value;

use crate::dice::Dice;
use crate::given::judged;
use eval::{Outcome, Trouble, World};
use program::{Expansion, Statement};
use scenelang_verify::report::model::Row;
use scenelang_verify::{Explain, Options};
use std::fmt::Write as _;
use term::Term;
use value::{Truth, Vector, same_rotations, same_vectors};

/// A program with its layout, and what must be said of them.
struct Case {
    text: String,
    layout: String,
    stated: Vec<Outcome<Truth>>,
    physical: Vec<rules::Ruling>,
}

fn case(seed: u64, scale: f64) -> Case {
    let mut dice = Dice(seed);
    let mut scene = make::scene(&mut dice);
    if scale != 1.0 {
        let [x, _, z] = scene.things[0].pos;
        scene.moved([-x, -z]);
        scene.scaled(scale);
    }
    let program = say::program(&mut dice, &scene);
    // Expanded, in source order, with what was drawn.
    let (mut asserts, mut prefers, mut expanded) = (0, 0, Vec::new());
    let mut drawn: Vec<(String, f64, f64)> = Vec::new();
    for statement in &program.statements {
        let (owner, term) = match statement {
            Statement::Assert(term) => {
                asserts += 1;
                (format!("assert[{}]", asserts - 1), term)
            }
            Statement::Prefer(term, _) => {
                prefers += 1;
                (format!("prefer[{}]", prefers - 1), term)
            }
            Statement::Pin(target, value) => (target.to_string(), value),
        };
        let mut expansion = Expansion::new(&program, &scene, &owner);
        expanded.push(expansion.expand(term, &[]));
        drawn.extend(expansion.draws);
    }
    for (key, lo, hi) in drawn {
        if !scene.draws.iter().any(|(k, _)| *k == key) {
            let x = dice.between(lo, hi);
            scene.draws.push((key, x));
        }
    }
    let text = program.text(&scene);
    let layout = scene.layout();
    let asserted = program.statements.iter().zip(&expanded).filter(|(s, _)| matches!(s, Statement::Assert(_)));
    let asserted: Vec<Term> = asserted.map(|(_, t)| t.clone()).collect();
    let lifted = rules::lifted(&asserted);
    let mut world = World::new(&scene);
    world.doors.clone_from(&lifted.doors);
    let mut stated: Vec<Outcome<Truth>> = Vec::new();
    for thing in &scene.things {
        // A size that is asked for is checked like an assigned one.
        let asked = thing.dimensions.map(|d| same_vectors(Vector::new(thing.scale), Vector::new(d)));
        stated.extend(asked.map(Ok));
    }
    for (statement, term) in program.statements.iter().zip(&expanded) {
        stated.push(match statement {
            Statement::Pin(target, _) => {
                let target = Expansion::new(&program, &scene, "").expand(target, &[]);
                match (world.value(&target), world.value(term)) {
                    (Ok(eval::Value::Vector(a)), Ok(eval::Value::Vector(b))) => Ok(same_vectors(a, b)),
                    (Ok(eval::Value::Rotation(a)), Ok(eval::Value::Rotation(b))) => Ok(same_rotations(a, b)),
                    other => panic!("a pin of {other:?}"),
                }
            }
            _ => world.truth(term),
        });
    }
    let physical = rules::rulings(&world, &program, &lifted);
    Case { text, layout, stated, physical }
}

/// What came of the comparisons.
#[derive(Default)]
struct Tally {
    rows: usize,
    /// Verdicts that the text does not fix: near a threshold, or a case that it is silent on.
    open: usize,
    margins: usize,
    holding: usize,
    errors: usize,
}

/// What a row says that is not what the second verifier says.
fn differs(row: &Row, expected: &Outcome<Truth>, tally: &mut Tally) -> Option<String> {
    tally.rows += 1;
    let truth = match expected {
        Err(Trouble::Unsure) => {
            tally.open += 1;
            return None;
        }
        Err(Trouble::Error) => {
            tally.errors += 1;
            return row.satisfied.map(|_| "an error".to_owned());
        }
        Ok(truth) => truth,
    };
    let Some(satisfied) = row.satisfied else { return Some(format!("{truth:?}")) };
    match truth.holds {
        None => tally.open += 1,
        Some(holds) if holds != satisfied => return Some(format!("{truth:?}")),
        Some(holds) => tally.holding += usize::from(holds),
    }
    if truth.noise.is_infinite() {
        return None;
    }
    tally.margins += 1;
    let agree = match row.margin {
        None => truth.margin.is_infinite(),
        Some(margin) => (margin - truth.margin).abs() <= truth.noise * 4.0 + 1e-9 * (1.0 + margin.abs()),
    };
    let unit = truth.degrees.map(|degrees| if degrees { "deg" } else { "m" });
    let same_unit = row.margin.is_none() || unit.is_none() || row.unit.as_deref() == unit;
    (!agree || !same_unit).then(|| format!("{truth:?}"))
}

fn disagreements(seed: u64, scale: f64, tally: &mut Tally) -> String {
    let mut options = Options::default();
    options.detail.all = true;
    options.detail.sentences = false;
    options.detail.explain = Explain::First(0);
    let case = case(seed, scale);
    let checked = judged(&case.text, &case.layout, &options);
    let (physical, stated): (Vec<&Row>, Vec<&Row>) = checked.report.constraints.iter().partition(|r| r.rule.is_some());
    let mut out = String::new();
    if stated.len() != case.stated.len() {
        writeln!(out, "{} rows, not {}: {:?}", stated.len(), case.stated.len(), checked.report.diagnostics).unwrap();
    }
    for (row, expected) in stated.iter().zip(&case.stated) {
        if let Some(expected) = differs(row, expected, tally) {
            writeln!(out, "`{}`: {:?} {:?} {:?}, expected {expected}", row.text, row.satisfied, row.margin, row.unit)
                .unwrap();
        }
    }
    for ruling in &case.physical {
        let Some(row) = physical.iter().find(|r| r.id == ruling.id) else {
            writeln!(out, "no row {}", ruling.id).unwrap();
            continue;
        };
        if let Some(expected) = differs(row, &Ok(ruling.truth), tally) {
            writeln!(out, "{}: {:?} {:?}, expected {expected}", row.id, row.satisfied, row.margin).unwrap();
        }
    }
    for row in physical {
        if !case.physical.iter().any(|r| r.id == row.id) {
            writeln!(out, "{}: {:?}, expected no row", row.id, row.satisfied).unwrap();
        }
    }
    if !out.is_empty() {
        out = format!("seed {seed}\n{out}{}\n{}\n", case.text, case.layout);
    }
    out
}

/// How many are judged; `SCENELANG_CASES=100000` judges more, `SCENELANG_SEED` others.
fn number(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(otherwise)
}

/// Both judge so many cases, all lengths multiplied.
fn hold(cases: u64, scale: f64) -> Tally {
    let first = number("SCENELANG_SEED", 0);
    let (mut tally, mut wrong) = (Tally::default(), Vec::new());
    for seed in first..first + cases {
        let found = disagreements(seed, scale, &mut tally);
        if !found.is_empty() {
            wrong.push(found);
        }
    }
    let Tally { rows, open, margins, holding, errors } = tally;
    println!(
        "{cases} cases times {scale}, {rows} verdicts ({holding} hold, {errors} errors, {open} open), {margins} margins"
    );
    let shown = wrong.iter().take(10).fold(String::new(), |all, w| all + w);
    assert!(wrong.is_empty(), "{} of {cases} cases:\n{shown}", wrong.len());
    tally
}

#[test]
fn two_verifiers_agree() {
    let Tally { rows, open, holding, .. } = hold(number("SCENELANG_CASES", 2_000), 1.0);
    assert!(open * 16 < rows, "{open} of {rows} verdicts were left open");
    assert!(holding * 4 > rows && holding * 4 < 3 * rows, "{holding} of {rows} hold: too one-sided");
}

#[test]
fn two_verifiers_agree_on_tenths_of_millimetres() {
    hold(number("SCENELANG_CASES", 2_000) / 10, 2e-4);
}

#[test]
fn two_verifiers_agree_on_kilometres() {
    hold(number("SCENELANG_CASES", 2_000) / 10, 2e3);
}
