//! The report for code scanning: SARIF 2.1.0, a result per violation and per diagnostic.

use super::build;
use super::model::{Finding, Related, Remedy, Report, Row, SourceSpan};
use crate::check::{Checked, Judged};
use scenelang_base::{Code, Severity, SourceMap, codes};
use serde_json::{Value, json};

/// A SARIF log with one run over all files.
pub fn sarif(checked: &[Checked]) -> String {
    let mut results: Vec<Value> = checked.iter().flat_map(of_one).collect();
    let mut used: Vec<String> = results.iter().filter_map(|r| r["ruleId"].as_str()).map(str::to_owned).collect();
    used.sort_unstable();
    used.dedup();
    for result in &mut results {
        let index = used.iter().position(|code| result["ruleId"] == *code);
        result["ruleIndex"] = json!(index);
    }
    let rules: Vec<Value> = used.iter().map(|code| rule(code)).collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "scenelang",
                "version": env!("CARGO_PKG_VERSION"),
                "informationUri": env!("CARGO_PKG_REPOSITORY"),
                "rules": rules,
            } },
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    });
    serde_json::to_string_pretty(&log).expect("a log is made of strings, numbers and lists") + "\n"
}

fn of_one(checked: &Checked) -> Vec<Value> {
    let Checked { report, verdict, sources, .. } = checked;
    let rows = report.constraints.iter().zip(&verdict.rows).filter(|(row, _)| row.satisfied == Some(false));
    let violations = rows.map(|(row, judged)| violation(row, judged, sources, report));
    // Of which rule they are a result must say; nearly all of so many are collisions.
    let more =
        report.unlisted.failing_in_words().map(|more| result(codes::V0102.as_str(), "error", &more, None, report));
    violations.chain(more).chain(report.diagnostics.iter().map(|d| finding(d, report))).collect()
}

/// What a code means, from its page in the book.
fn rule(code: &str) -> Value {
    let Some(code) = Code::find(code) else { return json!({ "id": code }) };
    let level = match code.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    json!({
        "id": code.as_str(),
        "shortDescription": { "text": code.title() },
        "fullDescription": { "text": code.summary() },
        "help": { "text": code.summary(), "markdown": code.page() },
        "helpUri": format!("{}/blob/main/spec/src/codes/{code}.md", env!("CARGO_PKG_REPOSITORY")),
        "defaultConfiguration": { "level": level },
    })
}

fn violation(row: &Row, judged: &Judged, sources: &SourceMap, report: &Report) -> Value {
    // A preference that is not met does not fail a build.
    let level = if row.is_violation() { "error" } else { "note" };
    let text = if row.message.is_empty() { row.text.clone() } else { format!("{}: {}", row.text, row.message) };
    let mut result = result(row.code.as_deref().unwrap_or_default(), level, &text, row.span.as_ref(), report);
    let related =
        judged.related.iter().map(|l| Related { message: l.message.clone(), span: build::place(sources, l.place) });
    relate(&mut result, &related.collect::<Vec<_>>());
    result["partialFingerprints"] = json!({ "constraint/v1": format!("{}#{}", report.file, row.id) });
    result["properties"] = json!({ "margin": row.margin, "unit": row.unit, "objects": row.objects });
    result
}

fn finding(found: &Finding, report: &Report) -> Value {
    let mut text = found.message.clone();
    for note in &found.notes {
        text.push_str("; ");
        text.push_str(note);
    }
    let mut result = result(&found.code, &found.severity, &text, found.span.as_ref(), report);
    relate(&mut result, &found.related);
    if !found.fixes.is_empty() {
        result["fixes"] = found.fixes.iter().map(fix).collect();
    }
    result
}

fn result(code: &str, level: &str, text: &str, place: Option<&SourceSpan>, report: &Report) -> Value {
    let location = place
        .map_or_else(|| json!({ "physicalLocation": { "artifactLocation": { "uri": uri(&report.file) } } }), location);
    json!({ "ruleId": code, "level": level, "message": { "text": text }, "locations": [location] })
}

fn relate(result: &mut Value, related: &[Related]) {
    let places = related.iter().enumerate().map(|(id, r)| {
        let mut place = location(&r.span);
        place["id"] = json!(id);
        place["message"] = json!({ "text": r.message });
        place
    });
    if !related.is_empty() {
        result["relatedLocations"] = places.collect();
    }
}

/// A fix: for each file, what is replaced by what.
fn fix(remedy: &Remedy) -> Value {
    let mut files: Vec<&str> = Vec::new();
    for edit in &remedy.edits {
        if !files.contains(&edit.span.file.as_str()) {
            files.push(&edit.span.file);
        }
    }
    let change = |file: &&str| {
        let edits = remedy.edits.iter().filter(|edit| edit.span.file == **file);
        let replacements: Vec<Value> =
            edits.map(|e| json!({ "deletedRegion": region(&e.span), "insertedContent": { "text": e.text } })).collect();
        json!({ "artifactLocation": { "uri": uri(file) }, "replacements": replacements })
    };
    json!({
        "description": { "text": remedy.title },
        "artifactChanges": files.iter().map(change).collect::<Vec<_>>(),
        "properties": { "applicability": remedy.applicability },
    })
}

fn location(place: &SourceSpan) -> Value {
    json!({
        "physicalLocation": { "artifactLocation": { "uri": uri(&place.file) }, "region": region(place) },
    })
}

fn region(place: &SourceSpan) -> Value {
    json!({
        "startLine": place.start[0],
        "startColumn": place.start[1],
        "endLine": place.end[0],
        "endColumn": place.end[1],
    })
}

/// A path as a URI reference: what may not stand in one is written in hexadecimal; an absolute path names its scheme.
fn uri(path: &str) -> String {
    let path = path.replace('\\', "/");
    let drive = path.as_bytes().get(1) == Some(&b':');
    let mut out = String::from(match (drive, path.starts_with('/')) {
        (true, _) => "file:///",
        (false, true) => "file://",
        (false, false) => "",
    });
    for byte in path.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'/' | b'-' | b'.' | b'_' | b'~' => out.push(char::from(byte)),
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}
