//! `scenelang diff`: what two layouts differ in.

use crate::FAILED;
use crate::args::{Beside, Diff, SummaryFormat};
use crate::check::judge;
use crate::solve::color_err;
use crate::table::Table;
use crate::targets::{JudgeTarget, find};
use scenelang_base::Diagnostic;
use scenelang_base::door::{Door, Named};
use scenelang_verify::compare::{Changed, ChangedThing, ComparedVerdict, Comparison, Difference, Turn, compare};
use scenelang_verify::{Checked, Detail, report};
use std::path::PathBuf;

/// Compares; 0 if geometry and verdicts are the same, 1 if not, 2 if one cannot be judged.
pub fn run(args: &Diff) -> u8 {
    let named = Named::new([args.before.as_path(), args.after.as_path()]);
    let [before, after] = match [&args.before, &args.after].map(target) {
        [Ok(before), Ok(after)] => [before, after].map(|target| {
            let door = Door::of(target.path()).named(&named);
            judge(&target, &args.judging, &Beside::default(), Detail::default(), false, &door, &door)
        }),
        [Err(message), _] | [_, Err(message)] => {
            eprintln!("error: {message}");
            return FAILED;
        }
    };
    let comparison = compare(&before, &after, args.threshold);
    match args.format {
        SummaryFormat::Human => {
            let errors = [&before, &after].map(errors);
            eprint!("{}", errors.concat());
            // Of what cannot be read nothing is known.
            if comparison.exit_code() != FAILED || errors.iter().all(String::is_empty) {
                crate::out::show(&human(&comparison));
            }
        }
        SummaryFormat::Json => match serde_json::to_string(&comparison) {
            Ok(text) => println!("{text}"),
            Err(e) => {
                eprintln!("error: {e}");
                return FAILED;
            }
        },
    }
    comparison.exit_code()
}

/// A layout, or what carries one.
fn target(path: &PathBuf) -> Result<JudgeTarget, String> {
    let layout = |t: &JudgeTarget| match t {
        JudgeTarget::File(path) => path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json")),
        JudgeTarget::Carrier(..) => true,
        JudgeTarget::Empty(_) => false,
    };
    match find(std::slice::from_ref(path)).as_slice() {
        [one] if one.path() == path && layout(one) => Ok(one.clone()),
        _ => Err(format!("{} is not a layout; diff compares layouts, GLB files and Unity projects", path.display())),
    }
}

/// Why something cannot be judged.
fn errors(checked: &Checked) -> String {
    let errors: Vec<Diagnostic> = checked.verdict.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
    report::diagnostics(&errors, &checked.sources, color_err())
}

fn human(c: &Comparison) -> String {
    let mut out = String::new();
    for (what, things) in [("object", &c.objects), ("region", &c.regions)] {
        let mut table = Table::new(&[what, "is", "how"]);
        for ChangedThing { name, changes } in things {
            for change in changes {
                table.row([name.clone(), change.what.as_str().to_owned(), change.words.clone()]);
            }
        }
        add(&mut out, &table, things.is_empty());
    }
    for (what, values) in [("variable", &c.variables), ("draw", &c.draws)] {
        let mut table = Table::new(&[what, "was", "is"]);
        for Changed { name, before, after } in values {
            table.row([name.clone(), before.to_string(), after.to_string()]);
        }
        add(&mut out, &table, values.is_empty());
    }
    let mut table = Table::new(&["constraint", "change", "margin before", "margin after"]);
    for row in &c.constraints {
        let Difference { id, text, what, before, after, .. } = row;
        let name = if row.kind.rule().is_some() { id.clone() } else { format!("{id} {}", short(text)) };
        let (before, after) = (margin(*before, row), margin(*after, row));
        let fails = row.after.is_some_and(|side| side.satisfied == Some(false));
        let change = match what {
            Turn::Shrinks if fails => "fails by more",
            Turn::Grows if fails => "fails by less",
            what => what.as_str(),
        };
        table.row([name, change.to_owned(), before, after]);
    }
    add(&mut out, &table, c.constraints.is_empty());
    let verdict = match (c.exit_code(), c.equal) {
        (FAILED, _) => "not fully compared, because one of them could not be checked",
        (_, true) => "equal in geometry and results",
        (_, false) => "they differ",
    };
    out += &format!("{} → {}: {verdict}\n", c.before.file, c.after.file);
    match (&c.before.judged_with, &c.after.judged_with) {
        (Some(with), other) if other.as_ref() == Some(with) => out += &format!("{}\n", with.in_words()),
        (before, after) => {
            for (file, with) in [(&c.before.file, before), (&c.after.file, after)] {
                if let Some(with) = with {
                    out += &format!("{file}: {}\n", with.in_words());
                }
            }
        }
    }
    out
}

fn add(out: &mut String, table: &Table, empty: bool) {
    if !empty {
        *out += &table.render();
        out.push('\n');
    }
}

fn margin(side: Option<ComparedVerdict>, row: &Difference) -> String {
    match (side.and_then(|s| s.margin), row.unit.as_deref()) {
        (Some(margin), Some("deg")) => format!("{margin:.1}°"),
        (Some(margin), Some(unit)) => format!("{margin:.3} {unit}"),
        _ => "–".to_owned(),
    }
}

/// A statement, cut where it would spoil the table.
fn short(text: &str) -> String {
    const MOST: usize = 60;
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() <= MOST { line } else { line.chars().take(MOST - 1).chain(['…']).collect() }
}
