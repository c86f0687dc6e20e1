//! The report for code scanning: SARIF 2.1.0, a result per violation and per diagnostic.

use super::model::{Finding, Place, Report, Row};
use scenelang_base::codes;
use serde_json::{Value, json};

/// A SARIF log with one run over all reports.
pub fn sarif(reports: &[Report]) -> String {
    let results: Vec<Value> = reports
        .iter()
        .flat_map(|report| {
            let rows = report.constraints.iter().filter(|row| row.satisfied == Some(false));
            rows.map(|row| violation(row, report)).chain(report.diagnostics.iter().map(|d| finding(d, report)))
        })
        .collect();
    let mut used: Vec<&str> = results.iter().filter_map(|r| r["ruleId"].as_str()).collect();
    used.sort_unstable();
    used.dedup();
    let title = |code: &str| codes::ALL.iter().find(|(c, _)| c.as_str() == code).map_or("", |(_, title)| title);
    let rules: Vec<Value> =
        used.iter().map(|code| json!({ "id": code, "shortDescription": { "text": title(code) } })).collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": { "name": "scenelang", "version": env!("CARGO_PKG_VERSION"), "rules": rules } },
            // Columns count code points.
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    });
    serde_json::to_string_pretty(&log).expect("a log is made of strings, numbers and lists") + "\n"
}

fn violation(row: &Row, report: &Report) -> Value {
    // A wish that is not met does not fail a build.
    let level = if row.is_violation() { "error" } else { "note" };
    let text = if row.message.is_empty() { row.text.clone() } else { format!("{}: {}", row.text, row.message) };
    let mut result = result(row.code.as_deref().unwrap_or_default(), level, &text, row.span.as_ref(), report);
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
    if !found.related.is_empty() {
        let related: Vec<Value> = found
            .related
            .iter()
            .map(|r| {
                let mut place = location(&r.span);
                place["message"] = json!({ "text": r.message });
                place
            })
            .collect();
        result["relatedLocations"] = Value::from(related);
    }
    result
}

fn result(code: &str, level: &str, text: &str, place: Option<&Place>, report: &Report) -> Value {
    let location = place
        .map_or_else(|| json!({ "physicalLocation": { "artifactLocation": { "uri": uri(&report.file) } } }), location);
    json!({ "ruleId": code, "level": level, "message": { "text": text }, "locations": [location] })
}

fn location(place: &Place) -> Value {
    json!({
        "physicalLocation": {
            "artifactLocation": { "uri": uri(&place.file) },
            "region": {
                "startLine": place.start[0],
                "startColumn": place.start[1],
                "endLine": place.end[0],
                "endColumn": place.end[1],
            },
        },
    })
}

/// A path as a URI reference: what may not stand in one is written in hexadecimal.
fn uri(path: &str) -> String {
    let mut out = String::new();
    for byte in path.replace('\\', "/").bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'/' | b'-' | b'.' | b'_' | b'~' => out.push(char::from(byte)),
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}
