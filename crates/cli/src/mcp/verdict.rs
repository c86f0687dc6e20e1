//! A judgement in few words: what fails and why, by names and sentences.

use scenelang_base::plain;
use scenelang_verify::Checked;
use scenelang_verify::report::model::{Finding, Report, Row, Tally};
use serde_json::{Value, json};

/// So many entries of each list are told; how many there are is told as well.
const TOLD: usize = 20;

/// The whole of it.
pub fn of(checked: &Checked) -> Value {
    let report = &checked.report;
    let violated = report.constraints.iter().filter(|row| row.is_violation());
    let unmet = report.constraints.iter().filter(|row| row.satisfied == Some(false) && !row.is_violation());
    let is_error = |finding: &&Finding| finding.severity == "error";
    let errors = report.diagnostics.iter().filter(is_error);
    let warnings = report.diagnostics.iter().filter(|finding| !is_error(finding));
    let mut out = json!({
        "file": report.file,
        "ok": report.ok,
        "judged": if checked.layout.is_some() { "program and layout" } else { "program" },
        "summary": summary(report, checked.layout.is_some()),
    });
    let lists = [
        ("fails", list(violated, failing)),
        ("unmet", list(unmet, failing)),
        ("errors", list(errors, finding)),
        ("warnings", list(warnings, finding)),
    ];
    for (name, (entries, more)) in lists {
        if !entries.is_empty() {
            out[name] = entries.into();
        }
        if more > 0 {
            out[format!("more_{name}")] = more.into();
        }
    }
    if let Some(with) = &report.judged_with {
        out["judged_with"] = with.in_words().into();
    }
    out
}

/// How many of each kind hold, in a sentence.
pub fn summary(report: &Report, has_layout: bool) -> String {
    if !has_layout {
        let errors = report.diagnostics.iter().filter(|finding| finding.severity == "error").count();
        return match errors {
            0 => "no errors; there is no layout yet (`solve` makes one)".to_owned(),
            1 => "1 error".to_owned(),
            n => format!("{n} errors"),
        };
    }
    let s = &report.summary;
    let kinds = [
        ("assertions", s.assertions),
        ("preferences", s.preferences),
        ("assignments", s.pins),
        ("physical rules", s.physical),
    ];
    let said = kinds.iter().filter(|(_, tally)| tally.total > 0);
    let said: Vec<String> =
        said.map(|(kind, Tally { total, satisfied })| format!("{satisfied} of {total} {kind} hold")).collect();
    said.join(", ")
}

/// The first entries of a list, and how many more there are.
pub fn list<T>(items: impl Iterator<Item = T>, entry: impl Fn(T) -> Value) -> (Vec<Value>, usize) {
    let (mut out, mut more) = (Vec::new(), 0);
    for item in items {
        if out.len() < TOLD { out.push(entry(item)) } else { more += 1 }
    }
    (out, more)
}

/// A constraint that does not hold.
fn failing(row: &Row) -> Value {
    let mut out = json!({ "id": row.id, "text": folded(&row.text), "why": row.message });
    if !row.requirements.is_empty() {
        out["for"] = json!(row.requirements);
    }
    if let Some(explanation) = &row.explanation {
        if let Some(repair) = &explanation.repair {
            out["repair"] = repair.text.clone().into();
        }
        if !explanation.pinned.is_empty() {
            out["pinned_by"] = json!(explanation.pinned);
        }
    }
    out
}

/// A finding about a file.
pub fn finding(finding: &Finding) -> Value {
    let mut out = json!({ "code": finding.code, "message": finding.message });
    if let Some(span) = &finding.span {
        out["at"] = format!("{}:{}:{}", span.file, span.start[0], span.start[1]).into();
    }
    if !finding.notes.is_empty() {
        out["notes"] = json!(finding.notes);
    }
    let fixes: Vec<&str> = finding.fixes.iter().map(|fix| fix.title.as_str()).collect();
    if !fixes.is_empty() {
        out["fixes"] = json!(fixes);
    }
    out
}

/// A statement on one line.
pub fn folded(text: &str) -> String {
    plain::line(&text.split_whitespace().collect::<Vec<_>>().join(" ")).into_owned()
}
