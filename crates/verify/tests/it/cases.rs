//! Cases as data, in `cases/*.txt`: a scene, a layout, and what the judgement must say, line by line.

use crate::given::{cases, judged, layout};
use scenelang_verify::report::model::Row;
use scenelang_verify::{Checked, Options, exit_code};
use std::fs;
use std::path::Path;

/// What the judgement says, in the words of the cases.
fn said(checked: &Checked) -> String {
    let report = &checked.report;
    let mut out: Vec<String> = report.constraints.iter().map(row).collect();
    // What is suspicious about the program alone is the front end's business, and tested there.
    let of_program = |code: &str| code.starts_with("W02") || code.starts_with("W03");
    for finding in report.diagnostics.iter().filter(|d| !of_program(&d.code)) {
        let place = finding.span.as_ref().map_or("nowhere".to_owned(), |span| {
            let file = if span.file.ends_with(".scene") { "scene" } else { "layout" };
            format!("{file} {}:{}", span.start[0], span.start[1])
        });
        out.push(format!("{} {place}", finding.code));
    }
    out.push(format!("exit {}", exit_code(report)));
    assert_eq!(report.ok, exit_code(report) == 0);
    out.join("\n")
}

fn row(row: &Row) -> String {
    let place = match (&row.rule, &row.span) {
        (None, Some(span)) => span.start[0].to_string(),
        _ => row.id.clone(),
    };
    let verdict = match row.satisfied {
        Some(true) => "holds",
        Some(false) => "fails",
        None => "null",
    };
    let margin = match (row.margin, &row.unit) {
        // Margins of support are normative in their sign alone.
        (Some(_), _) if row.rule.as_deref() == Some("P-SUPPORT") => String::new(),
        (Some(margin), Some(unit)) => format!(" {} {unit}", (margin * 1e4).round() / 1e4 + 0.0),
        _ => String::new(),
    };
    format!("{place} {verdict}{margin}")
}

#[test]
fn all_cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/cases");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let (mut count, mut wrong) = (0, Vec::new());
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        for case in cases(&text) {
            count += 1;
            let mut options = Options::default();
            let expect = case.expect.trim();
            let expect = match expect.strip_prefix("with --geometry box\n") {
                Some(rest) => {
                    options.geometry = scenelang_verify::Geometry::Box;
                    rest
                }
                None => expect,
            };
            let got = said(&judged(&case.scene, &layout(&case.layout), &options));
            if got != expect {
                let name = file.file_name().unwrap().to_string_lossy();
                wrong.push(format!("{name}: {}\n-- expected\n{expect}\n-- got\n{got}\n", case.title));
            }
        }
    }
    assert!(count > 40, "only {count} cases");
    assert!(wrong.is_empty(), "{} of {count} cases:\n{}", wrong.len(), wrong.join("\n"));
}
