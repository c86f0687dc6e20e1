//! What people write by mistake: contradictions that are proved where things are taken as usual, each with the smallest
//! set of statements, and beside each a program that differs by a hair and is not called contradictory.
//!
//! Cases whose name begins with `(missed)` are not proved yet, or with a larger set; one that is proved loses the mark. Those
//! with `(closely)` take more than the usual work.
//!
//! The cases of `always.txt` are assertions that always hold instead, each beside one that says something.
//!
//! The cases are in `tests/proofs/everyday`; the head of `packing.txt` says how they are written. That the other programs
//! have layouts is tested where they can be solved (`crates/cli`).

use crate::proofs::{compiled, lines};
use scenelang_verify::prove::{Findings, ProveOptions, WORK, prove, prove_closely};
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, time::Instant};

/// A case: its name, the contradictory program, the smallest set (lines), the other program.
struct Case {
    name: String,
    text: String,
    wanted: Vec<usize>,
    twin: String,
}

/// The file of assertions that always hold.
const ALWAYS: &str = "always";

/// The contradictions.
fn cases() -> Vec<Case> {
    all_cases().into_iter().filter(|c| !c.name.starts_with(ALWAYS)).collect()
}

fn all_cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proofs/everyday");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let mut out: Vec<Case> = Vec::new();
    for file in files {
        let stem = file.file_stem().unwrap().to_string_lossy().into_owned();
        let text = fs::read_to_string(&file).unwrap();
        for part in format!("\n{text}").split("\n== ").skip(1) {
            let (name, body) = part.split_once('\n').unwrap();
            let mut case =
                Case { name: format!("{stem}: {name}"), text: String::new(), wanted: Vec::new(), twin: String::new() };
            let mut last = 0;
            for line in body.lines() {
                if let Some(other) = line.strip_prefix("~ ") {
                    case.twin.truncate(last);
                    writeln!(case.twin, "{other}").unwrap();
                    continue;
                }
                last = case.twin.len();
                writeln!(case.text, "{line}").unwrap();
                writeln!(case.twin, "{}", line.trim_end_matches("//!")).unwrap();
                if line.ends_with("//!") {
                    case.wanted.push(case.text.lines().count());
                }
            }
            out.push(case);
        }
    }
    out
}

fn proved(text: &str, closely: bool) -> (Findings, Vec<Vec<usize>>) {
    let program = compiled(text);
    let options = ProveOptions { usual: true, redundant: false, ..ProveOptions::default() };
    let findings = if closely { prove_closely(&program, &options) } else { prove(&program, &options) };
    let mut found = lines(text, &program, &findings);
    found.iter_mut().for_each(Vec::dedup);
    (findings, found)
}

#[test]
fn everyday_contradictions_are_proved_with_the_smallest_set() {
    let (mut wrong, mut inexact, mut proofs, mut all) = (String::new(), 0, 0, 0);
    for case in cases() {
        all += 1;
        let begun = Instant::now();
        let closely = case.name.contains("(closely)");
        let (findings, found) = proved(&case.text, closely);
        assert!(!closely || proved(&case.text, false).1.is_empty(), "{}: proved with the usual work", case.name);
        let took = begun.elapsed();
        println!("{}: {found:?} in {took:.1?}, {} steps", case.name, findings.work_spent);
        // The last step may end a little beyond.
        if findings.work_spent > WORK + WORK / 100 {
            writeln!(wrong, "{}: {} steps, more than the {WORK} of `check`", case.name, findings.work_spent).unwrap();
        }
        proofs += usize::from(!found.is_empty());
        let exact = found.first() == Some(&case.wanted);
        inexact += usize::from(!found.is_empty() && !exact);
        if exact == case.name.contains("(missed)") {
            writeln!(wrong, "{}: expected {:?}, found {found:?}", case.name, case.wanted).unwrap();
        }
    }
    println!("{proofs} of {all} proved, {inexact} of them with another set");
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(proofs * 100 >= all * 90, "only {proofs} of {all} are proved");
    assert!((proofs - inexact) * 100 >= all * 85, "only {} of {all} have the smallest set", proofs - inexact);
}

/// The lines of assertions that always hold.
fn always(text: &str) -> Vec<usize> {
    let program = compiled(text);
    let findings = prove(&program, &ProveOptions { usual: true, ..ProveOptions::default() });
    assert!(findings.contradictions.is_empty() && findings.work_spent <= WORK + WORK / 100, "{text}");
    let line = |s: &usize| text[..program.constraints[*s].span.range.start as usize].matches('\n').count() + 1;
    findings.always.iter().map(line).collect()
}

#[test]
fn assertions_that_always_hold_are_told_from_others() {
    let cases: Vec<Case> = all_cases().into_iter().filter(|c| c.name.starts_with(ALWAYS)).collect();
    assert!(cases.len() >= 6, "only {} cases", cases.len());
    for case in cases {
        assert_eq!(always(&case.text), case.wanted, "{}", case.name);
        assert_eq!(always(&case.twin), [0; 0], "{}", case.name);
    }
}

#[test]
fn what_differs_by_a_hair_is_not_contradictory() {
    let mut wrong = String::new();
    for case in cases() {
        let (_, found) = proved(&case.twin, case.name.contains("(closely)"));
        if !found.is_empty() {
            writeln!(wrong, "{}: {found:?}\n{}", case.name, case.twin).unwrap();
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}
